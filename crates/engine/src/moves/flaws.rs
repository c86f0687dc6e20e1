//! What is awkward about where an object stands, though no statement forbids it: a lamp before a sofa, a chair at the end of
//! its desk, a wardrobe away from its wall. Of two moves that repair the same, people make the one without such flaws.
//!
//! Objects are told apart by their roles, and most of what is asked here is asked by `std/guidelines.scene`, too. A program
//! need not import that for a repair to be sensible. What was awkward before a move is not held against it.

use scenelang_lang::program::{ObjectId, Program};
use scenelang_layout::{Obb, Prism, Vec2, Vec3, obb};
use scenelang_verify::World;

/// What is deeper than this in the space before something is in the way (metres).
const INTO: f64 = 0.02;
/// What stands lower than this above the floor stands on it (metres).
const ON_FLOOR: f64 = 0.3;
/// A back that is so near to a wall is at it (metres).
const AT_WALL: f64 = 0.1;
/// A lamp or a plant that is farther from walls, and from furniture that it may stand beside, stands alone (metres).
const ALONE: f64 = 0.2;
/// A chair that is so near to a desk belongs to it (metres).
const BELONGS: f64 = 0.45;
/// What is narrower is a chair, what is wider a sofa or an armchair (metres).
pub(super) const CHAIR: f64 = 0.75;
/// A lower seat has no back: one may sit or put one's feet on it from any side (metres).
const STOOL: f64 = 0.6;
/// What is wider seats several people, who have a wall behind them (metres).
const SOFA: f64 = 1.3;
/// So far away is the table that an armchair looks at (metres).
const TABLE: f64 = 1.2;
/// A chair that is farther from walls and from all furniture belongs to nothing (metres).
const STRAY: f64 = 0.5;
/// What holds things and is no wider than this, and twice as high, is a coat stand or the like (metres).
const SLIM: f64 = 0.5;
/// What is turned by less than this from the walls of its room is square to them (degrees).
const SQUARE: f64 = 0.5;

/// The middle of a carpet is so much of it.
const MIDDLE: f64 = 0.3;

/// Roles of what may be under other things.
const UNDER: [&str; 6] = ["carpet", "item", "device", "decor", "curtain", "heating"];

/// Roles of what stands at a wall, in a corner or beside furniture, but never in the middle of a room.
const STANDS_ASIDE: [&str; 3] = ["light", "plant", "decor"];

/// Whether a thing of a role and a size stands there: coat stands do, too.
pub(super) fn stands_aside(role: &str, size: &Vec3) -> bool {
    let wide = size.x.max(size.z);
    STANDS_ASIDE.contains(&role) || role == "storage" && wide <= SLIM && size.y >= 2.0 * wide
}

/// A flaw of where an object stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Flaw {
    /// The first stands in the space before the second that people need.
    InTheWay(ObjectId, ObjectId),
    /// A wall is where people need space.
    FacesWall(ObjectId),
    /// A chair is not before the middle of the desk or the table it belongs to.
    AtEnd(ObjectId),
    /// A seat looks away from its desk or table.
    LooksAway(ObjectId),
    /// What has its back at a wall in most rooms has not.
    OffWall(ObjectId),
    /// A lamp or a plant stands alone in the room.
    Alone(ObjectId),
    /// A chair stands in the room and belongs to nothing.
    Stray(ObjectId),
    /// It is not square to the walls.
    Askew(ObjectId),
    /// The first stands under the second, where a foot or a bag may be, but no furniture.
    Beneath(ObjectId, ObjectId),
    /// Of the tables that stand on a carpet none stands on its middle.
    OffCentre(ObjectId),
}

/// An object as it is seen here.
struct Thing<'a> {
    id: ObjectId,
    role: &'a str,
    obb: &'a Obb,
}

impl Thing<'_> {
    fn axis(&self, i: usize) -> Vec3 {
        self.obb.axes.column(i).into()
    }

    fn bottom(&self) -> f64 {
        self.obb.center.y - self.obb.half.y
    }

    fn top(&self) -> f64 {
        self.obb.center.y + self.obb.half.y
    }

    fn width(&self) -> f64 {
        2.0 * self.obb.half.x
    }

    fn is_chair(&self) -> bool {
        self.role == "seat" && self.width() < CHAIR
    }

    fn stands_aside(&self) -> bool {
        stands_aside(self.role, &(2.0 * self.obb.half))
    }

    /// Whether it is a seat without a back, which has no front.
    fn is_stool(&self) -> bool {
        self.role == "seat" && self.top() - self.bottom() < STOOL
    }

    /// Whether a chair can belong to it, or stand in a row with it.
    fn is_furniture(&self) -> bool {
        let others = ["carpet", "curtain", "wallDecor", "door", "window", "item", "divider", "heating"];
        !self.stands_aside() && !others.contains(&self.role)
    }

    /// Whether a point is over it, seen from above, as if it were larger or smaller by a factor.
    fn is_around(&self, at: &Vec3, factor: f64) -> bool {
        let by = at - self.obb.center;
        [0, 2].into_iter().all(|i| by.dot(&self.axis(i)).abs() < factor * self.obb.half[i])
    }

    /// Whether people sit at it.
    fn is_table(&self) -> bool {
        matches!(self.role, "desk" | "table" | "counter")
    }

    /// The spaces around it that people need, at its height.
    fn spaces(&self) -> Vec<Obb> {
        let (half, deep) = (self.obb.half.x, self.obb.half.z);
        // Along its front, to its right, and half of what it takes of either.
        let space = |front: f64, right: f64, along: f64, across: f64| {
            let center = self.obb.center + self.axis(2) * front + self.axis(0) * right;
            Obb { center, axes: self.obb.axes, half: Vec3::new(across, self.obb.half.y, along) }
        };
        let before = |depth: f64, part: f64| space(deep + depth / 2.0, 0.0, depth / 2.0, part * half);
        match self.role {
            "seat" if self.is_stool() => Vec::new(),
            "seat" => vec![before(0.5, 0.8)],
            "storage" | "appliance" | "sanitary" | "desk" => vec![before(0.6, 1.0)],
            "door" => vec![space(0.0, 0.0, deep + 0.8, half)],
            "window" => vec![space(0.0, 0.0, deep + 0.5, half)],
            // At the head a nightstand may stand.
            "bed" => [1.0, -1.0].map(|side| space(deep / 3.0, side * (half + 0.2), deep * 2.0 / 3.0, 0.2)).into(),
            _ => Vec::new(),
        }
    }

    /// Whether it may not stand in the space that another one needs.
    fn bars(&self, owner: &Thing<'_>) -> bool {
        let stands = self.bottom() - owner.bottom() < ON_FLOOR;
        let low = self.top() - owner.bottom() < 0.05;
        match (owner.role, self.role) {
            (_, "carpet" | "door" | "window" | "curtain") => false,
            ("window", role) => self.top() - owner.bottom() > 0.1 && self.bottom() < owner.top() && role != "light",
            ("seat", _) => stands && !(low || self.is_stool() || self.is_table()),
            ("desk" | "bed" | "storage", "seat") => false,
            _ => stands && !low,
        }
    }
}

/// Looks for flaws in an instance.
pub(super) struct Sense<'a> {
    program: &'a Program,
    world: &'a World<f64>,
}

impl<'a> Sense<'a> {
    pub fn new(program: &'a Program, world: &'a World<f64>) -> Self {
        Self { program, world }
    }

    /// The flaws that objects have or cause, sorted.
    pub fn flaws(&self, moved: &[ObjectId]) -> Vec<Flaw> {
        let mut found = Vec::new();
        for thing in moved.iter().filter_map(|id| self.thing(*id)) {
            self.in_the_way(&thing, &mut found);
            self.own(&thing, &mut found);
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    fn thing(&self, id: ObjectId) -> Option<Thing<'a>> {
        let role = self.program.objects[id.0 as usize].role.as_str();
        let instance = self.world.object(id).ok()?;
        Some(Thing { id, role, obb: &instance.body.obb })
    }

    fn others(&self, id: ObjectId) -> impl Iterator<Item = Thing<'a>> + '_ {
        self.world.bodies().filter(move |(other, _)| *other != id).filter_map(|(other, _)| self.thing(other))
    }

    /// The room of an object: of the regions that hold its centre the largest, since zones have no walls.
    fn room(&self, thing: &Thing<'_>) -> Option<&'a Prism> {
        let at = Vec2::new(thing.obb.center.x, thing.obb.center.z);
        let prisms = self.world.prisms().map(|(_, prism)| prism);
        prisms.filter(|p| p.polygon.contains(at)).max_by(|a, b| a.area().total_cmp(&b.area()))
    }

    /// What is in whose way: the object in that of others, and others in its own.
    fn in_the_way(&self, thing: &Thing<'_>, found: &mut Vec<Flaw>) {
        let meets = |bar: &Thing<'_>, owner: &Thing<'_>| {
            bar.bars(owner) && owner.spaces().iter().any(|space| !obb::apart(space, bar.obb, -INTO))
        };
        for other in self.others(thing.id) {
            if meets(thing, &other) {
                found.push(Flaw::InTheWay(thing.id, other.id));
            }
            if meets(&other, thing) {
                found.push(Flaw::InTheWay(other.id, thing.id));
            }
        }
    }

    /// What is awkward about the object alone, or with what it belongs to.
    fn own(&self, thing: &Thing<'_>, found: &mut Vec<Flaw>) {
        if let Some(room) = self.room(thing) {
            let wall = |p: Vec3| room.polygon.clearance_of_point(Vec2::new(p.x, p.z)).value;
            self.walls(thing, room, &wall, found);
        }
        if thing.role == "seat" && !thing.is_stool() {
            self.seat(thing, found);
        }
        if thing.role == "carpet" {
            self.carpet(thing, found);
        } else if !UNDER.contains(&thing.role) {
            let covers = |other: &Thing<'_>| {
                other.is_furniture() && other.top() >= thing.top() && other.bottom() <= thing.bottom() + ON_FLOOR
            };
            let over = |other: &Thing<'_>| covers(other) && other.is_around(&thing.obb.center, 1.0);
            found.extend(self.others(thing.id).filter(over).map(|other| Flaw::Beneath(thing.id, other.id)));
        }
    }

    fn carpet(&self, carpet: &Thing<'_>, found: &mut Vec<Flaw>) {
        let on = |other: &Thing<'_>| {
            let higher = other.bottom() - carpet.bottom() < ON_FLOOR && other.top() > carpet.top();
            other.role == "table" && higher && carpet.is_around(&other.obb.center, 1.0 + MIDDLE)
        };
        let mut tables = self.others(carpet.id).filter(on).peekable();
        if tables.peek().is_some() && !tables.any(|table| carpet.is_around(&table.obb.center, MIDDLE)) {
            found.push(Flaw::OffCentre(carpet.id));
        }
    }

    fn walls(&self, thing: &Thing<'_>, room: &Prism, wall: &dyn Fn(Vec3) -> f64, found: &mut Vec<Flaw>) {
        let (center, half) = (thing.obb.center, thing.obb.half);
        let [right, front] = [0, 2].map(|i| thing.axis(i));
        let beyond = |way: Vec3, half: f64, by: f64| wall(center + way * (half + by)) <= 0.0;
        let (stands, aside) = (thing.bottom() - room.floor < ON_FLOOR, thing.stands_aside());
        let fronted = matches!(thing.role, "seat" | "storage" | "appliance" | "desk") && !aside && !thing.is_stool();
        if fronted && stands && beyond(front, half.z, 0.4) {
            found.push(Flaw::FacesWall(thing.id));
        }
        let backed = match thing.role {
            "bed" | "storage" | "appliance" | "sanitary" | "desk" | "screen" => stands && !aside,
            "seat" => thing.width() >= SOFA,
            _ => false,
        };
        let beside = || [right, -right].into_iter().any(|way| beyond(way, half.x, AT_WALL));
        if backed && !beyond(-front, half.z, AT_WALL) && !beside() {
            found.push(Flaw::OffWall(thing.id));
        }
        let from_walls = wall(center) - half.x.max(half.z);
        if stands && aside {
            let near_wall = from_walls <= ALONE;
            let near = |other: &Thing<'_>| {
                let furniture = matches!(other.role, "storage" | "appliance" | "bed" | "screen" | "sanitary")
                    || other.role == "seat" && !other.is_chair();
                furniture && !obb::apart(other.obb, thing.obb, ALONE)
            };
            if !near_wall && !self.others(thing.id).any(|other| near(&other)) {
                found.push(Flaw::Alone(thing.id));
            }
        }
        let belongs = |other: &Thing<'_>| other.is_furniture() && !obb::apart(other.obb, thing.obb, STRAY);
        if stands && thing.is_chair() && from_walls > STRAY && !self.others(thing.id).any(|other| belongs(&other)) {
            found.push(Flaw::Stray(thing.id));
        }
        let along = room.polygon.clearance_of_point(Vec2::new(center.x, center.z)).inward;
        let angle = (front.x.atan2(front.z) - along.x.atan2(along.y)).to_degrees();
        let step = if thing.role == "seat" { 45.0 } else { 90.0 };
        if (angle - step * (angle / step).round()).abs() > SQUARE {
            found.push(Flaw::Askew(thing.id));
        }
    }

    fn seat(&self, seat: &Thing<'_>, found: &mut Vec<Flaw>) {
        let reach = if seat.is_chair() { BELONGS } else { TABLE };
        let gap = |table: &Thing<'_>| obb::separation(seat.obb, table.obb).gap;
        let tables = self.others(seat.id).filter(|o| o.is_table() && !obb::apart(seat.obb, o.obb, reach));
        let tables = tables.map(|table| (gap(&table), table)).filter(|(gap, _)| *gap <= reach);
        let Some((_, table)) = tables.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.id.cmp(&b.1.id))) else { return };
        let way = table.obb.center - seat.obb.center;
        // Where the seat is, seen from the table: along its width and its depth.
        let at = [0, 2].map(|i| -way.dot(&table.axis(i)));
        let half = [table.obb.half.x, table.obb.half.z];
        let outside = at.iter().zip(half).map(|(at, half)| at.abs() - half).collect::<Vec<_>>();
        let side = usize::from(outside[1] >= outside[0]);
        let inward = -table.axis(2 * side) * at[side].signum();
        let towards = seat.axis(2).dot(&inward);
        if !seat.is_chair() {
            // A side table may stand beside an armchair.
            if seat.axis(2).dot(&way) < 0.0 && towards < -0.1 {
                found.push(Flaw::LooksAway(seat.id));
            }
            return;
        }
        if towards < 0.5 {
            found.push(Flaw::LooksAway(seat.id));
        }
        let across = 1 - side;
        let own = seat.obb.half.x;
        let ends = if self.is_alone_at(seat, &table) && table.role == "desk" {
            0.5 * (half[across] - own).max(0.1)
        } else {
            (half[across] - own + 0.05).max(0.1)
        };
        let behind = table.role == "desk" && (side == 0 || at[1] < 0.0);
        if behind || at[across].abs() > ends {
            found.push(Flaw::AtEnd(seat.id));
        }
    }

    /// The chairs that are drawn up to a table: so near to it and to no other one, and looking at it if they have a front.
    pub fn drawn_up(&self, table: ObjectId) -> Vec<ObjectId> {
        let Some(table) = self.thing(table).filter(Thing::is_table) else { return Vec::new() };
        let near = |seat: &Thing<'_>, table: &Thing<'_>| {
            let near = !obb::apart(seat.obb, table.obb, BELONGS);
            near.then(|| obb::separation(seat.obb, table.obb).gap)
        };
        let looks = |seat: &Thing<'_>| seat.is_stool() || seat.axis(2).dot(&(table.obb.center - seat.obb.center)) > 0.0;
        let belongs = |seat: &Thing<'_>| {
            let Some(gap) = near(seat, &table) else { return false };
            let tables = self.others(table.id).filter(|other| other.is_table() && other.id != seat.id);
            seat.is_chair() && looks(seat) && !tables.filter_map(|other| near(seat, &other)).any(|other| other < gap)
        };
        self.others(table.id).filter(belongs).map(|seat| seat.id).collect()
    }

    /// Whether no other seat is at a table.
    fn is_alone_at(&self, seat: &Thing<'_>, table: &Thing<'_>) -> bool {
        !self.others(seat.id).any(|other| other.is_chair() && !obb::apart(other.obb, table.obb, BELONGS))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_lang::compile_text;
    use scenelang_layout::file;
    use scenelang_verify::Options;
    use std::fmt::Write;

    /// The flaws of the first of some objects: `NAME CATEGORY x z yaw width height depth`, in a room of 6 m by 6 m.
    fn flaws(objects: &[&str]) -> Vec<String> {
        let mut text = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(6, 2.7, 6);\n".to_owned();
        let mut placed = Vec::new();
        for object in objects {
            let words: Vec<&str> = object.split(' ').collect();
            let [name, category, x, z, yaw, w, h, d] = words[..] else { panic!("{object}") };
            let category = category.replace('-', " ");
            write!(text, "object {name};\n{name}.category <- \"{category}\";\n").unwrap();
            placed.push(format!(
                "\"{name}\": {{ \"pos\": [{x}, 0, {z}], \"rot\": [0, {yaw}, 0], \"scale\": [{w}, {h}, {d}] }}"
            ));
        }
        let layout = format!(
            r#"{{ "format": "scenelang.layout/1", "objects": {{ {} }},
                 "regions": {{ "room": {{ "pos": [0, 0, 0], "scale": [6, 2.7, 6] }} }} }}"#,
            placed.join(", ")
        );
        let compiled = compile_text("room.scene", "room.scene".as_ref(), &text, scenelang_lang::Options::default());
        let program = compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
        let read = file::read(&layout, scenelang_base::FileId(0));
        let world = World::new(&program, &read.layout, &Options::default());
        let name = |id: &ObjectId| program.objects[id.0 as usize].name.clone();
        let said = |flaw: &Flaw| match flaw {
            Flaw::InTheWay(a, b) => format!("{} bars {}", name(a), name(b)),
            Flaw::FacesWall(_) => "faces a wall".to_owned(),
            Flaw::AtEnd(_) => "at an end".to_owned(),
            Flaw::LooksAway(_) => "looks away".to_owned(),
            Flaw::OffWall(_) => "off its wall".to_owned(),
            Flaw::Alone(_) => "alone".to_owned(),
            Flaw::Stray(_) => "stray".to_owned(),
            Flaw::Askew(_) => "askew".to_owned(),
            Flaw::Beneath(a, b) => format!("{} under {}", name(a), name(b)),
            Flaw::OffCentre(_) => "off the middle".to_owned(),
        };
        Sense::new(&program, &world).flaws(&[ObjectId(0)]).iter().map(said).collect()
    }

    #[test]
    fn what_people_mind() {
        const SOFA: &str = "sofa sofa 0 -2.5 0 1.9 0.8 0.9";
        const DESK: &str = "desk desk 0 2.6 180 1.4 0.74 0.7";
        const TABLE: &str = "table dining-table 0 0 0 1.6 0.74 0.8";
        let mut wrong = Vec::new();
        for (objects, wanted) in [
            (&["lamp floor-lamp 0.3 -1.7 0 0.3 1.6 0.3", SOFA][..], &["lamp bars sofa", "alone"][..]),
            (&["lamp floor-lamp 1.2 -2.6 0 0.3 1.6 0.3", SOFA], &[]),
            (&["lamp floor-lamp 0 0 0 0.3 1.6 0.3", SOFA], &["alone"]),
            (&["plant plant 2.5 0 0 0.4 1 0.4", SOFA], &["alone"]),
            (&["plant plant 2.7 0 0 0.4 1 0.4", SOFA], &[]),
            (&["stand coat-stand 0 0 0 0.4 1.7 0.4"], &["alone"]),
            (&["stand coat-stand 2.7 0 90 0.4 1.7 0.4"], &[]),
            (&["stand nightstand 0 0 0 0.4 0.5 0.4"], &["off its wall"]),
            // What belongs before a sofa.
            (&["table coffee-table 0 -1.6 0 1 0.42 0.6", SOFA], &[]),
            (&["rug rug 0 -1.6 0 2 0.02 1.4", SOFA], &[]),
            (&["pouf pouf 0 -1.7 0 0.5 0.4 0.5", SOFA], &[]),
            (&["pouf pouf 0 0.1 0 0.5 0.4 0.5", TABLE], &["pouf under table"]),
            (&["bag bag 0 0.1 0 0.5 0.4 0.3", TABLE], &[]),
            (&["rug rug 0 0.2 0 2 0.02 1.4", TABLE], &[]),
            (&["rug rug 0.9 0.4 0 2 0.02 1.4", TABLE], &["off the middle"]),
            (&["sofa sofa 0 -1 0 1.9 0.8 0.9"], &["off its wall"]),
            (&["sofa sofa 0 -2.5 20 1.9 0.8 0.9"], &["askew"]),
            (&["sofa sofa 0 2.3 0 1.9 0.8 0.9"], &["faces a wall", "off its wall"]),
            // A chair and its desk.
            (&["chair chair 0 1.9 0 0.5 0.9 0.5", DESK], &[]),
            (&["chair chair 0.55 1.9 0 0.5 0.9 0.5", DESK], &["at an end"]),
            (&["chair chair 1 2.5 270 0.5 0.9 0.5", DESK], &["at an end"]),
            (&["chair chair 0 1.9 180 0.5 0.9 0.5", DESK], &["looks away"]),
            // A chair that belongs to nothing; in a row, at a wall, beside a couch.
            (&["chair chair 0 0 0 0.5 0.9 0.5", "lamp floor-lamp 0.5 0 0 0.3 1.6 0.3", DESK], &["stray"]),
            (&["chair chair 0 0 0 0.5 0.9 0.5", "other chair 0.7 0 0 0.5 0.9 0.5"], &[]),
            (&["chair chair 0 -2.5 0 0.5 0.9 0.5"], &[]),
            (&["chair chair 0 0 0 0.5 0.9 0.5", "couch examination-couch 0.7 0 0 0.7 0.7 1.9"], &[]),
            // Two people share a desk; a table has four sides.
            (&["chair chair 0.4 1.9 0 0.5 0.9 0.5", DESK, "other chair -0.4 1.9 0 0.5 0.9 0.5"], &[]),
            (&["chair chair 1.1 0 270 0.5 0.9 0.5", TABLE], &[]),
            (&["chair chair 0.8 0.7 180 0.5 0.9 0.5", TABLE], &["at an end"]),
            (&["armchair armchair 0 -1 180 0.8 0.85 0.8", TABLE], &["looks away"]),
            (&["plant plant 0 -2 0 0.4 1 0.4", "door door 0 -2.97 0 0.9 2 0.06"], &["plant bars door", "alone"]),
            (&["plant plant 1 -2.7 0 0.4 1 0.4", "door door 0 -2.97 0 0.9 2 0.06"], &[]),
            (&["wardrobe wardrobe 0 -2.7 0 1.2 2 0.6", "bed bed 0 -1 0 1.6 0.5 2"], &["bed bars wardrobe"]),
        ] {
            let found = flaws(objects);
            if found != wanted {
                wrong.push(format!("{objects:?}: {found:?}"));
            }
        }
        assert!(wrong.is_empty(), "{wrong:#?}");
    }
}
