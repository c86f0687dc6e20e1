//! Two sofas that are asked for stand around a low table as one piece: across it where they are said to face each other, else
//! in a corner; two desks stand edge to edge.

use super::build::Root;
use super::floor::{Floor, Footprint, Pose, Shape};
use super::plan::{AtWall, Plan};
use super::slots::{Level, Slot};
use super::{place, stand};
use crate::brief::Group;
use crate::draft::{Demand, DraftThing, ThingOrigin};
use crate::names::mentions;

/// Between the fronts of two seats that face each other, with a low table between them (metres).
const ACROSS: f64 = 1.5;
/// The back of a sofa is so near to its wall (metres).
const NEAR: f64 = 0.06;
/// Between the edges of two desks (metres).
const EDGE: f64 = 0.01;
/// What is lower can stand there.
const LOW: f64 = 0.6;
/// The group of what stands around that table, and what is added where none is asked for.
const BETWEEN: &str = "facing table";
const TABLE: &str = "coffee table";
const WHY: &str = "seats that face each other share a low table";

/// Between two sofas in a corner, and from the wall behind the first to the side of the second (metres).
const CORNER: f64 = 0.12;
const ASIDE: f64 = 0.6;
/// Between a sofa and the low table before it (metres).
const REACH: f64 = 0.42;

/// Finds a place for a group, given those of the groups before it.
type Seek<'s> = dyn Fn(&Floor, &Shape, &[Pose]) -> Option<Pose> + 's;

/// Whether a thing is such a pair: two that are said to face each other, or two sofas before a fire.
pub fn is_pair(plan: &Plan, thing: usize) -> bool {
    let it = &plan.draft.things[thing];
    let has_fire = plan.draft.things.iter().any(|t| t.room == Some(plan.room) && is_fire(t));
    if has_fire && is_set(plan, thing, 2) {
        return true;
    }
    let facing = format!("facing({}[2 * i], {}[", it.name, it.name);
    is_two(plan, thing, &facing, "") && stand::group(&it.category) == Group::Seat && stand::has_back(&it.category)
}

/// Whether a thing is exactly so many sofas whose position is not stated, except that they are at a fireplace.
pub fn is_set(plan: &Plan, thing: usize, count: usize) -> bool {
    let it = &plan.draft.things[thing];
    let is_sofa = ["sofa", "couch", "loveseat", "settee"].iter().any(|sofa| it.category.ends_with(sofa));
    let of_it = |s: &&crate::draft::Statement| mentions(&s.text, &it.name);
    let fires: Vec<&str> = plan.draft.things.iter().filter(|t| is_fire(t)).map(|t| t.name.as_str()).collect();
    // Who sits around a fire sits around the table before it.
    let at_fire = |text: &str| fires.iter().any(|fire| mentions(text, fire));
    let is_about = |text: &str| !text.contains("inside(") && !text.contains("onFloor(") && !at_fire(text);
    let said = plan.draft.statements.iter().filter(of_it);
    let mut said = said.filter(|s| matches!(s.source, ThingOrigin::Stated(_)) && is_about(&s.text));
    // Each has a table of its own if there are several.
    let is_low = |t: &DraftThing| {
        t.room == it.room && t.count > 1 && matches!(t.category.as_str(), "coffee_table" | "low_table")
    };
    let apart = plan.draft.things.iter().any(is_low);
    let l_shaped = it.look.features.iter().any(|feature| feature.contains("shaped"));
    it.count == count && is_sofa && !apart && !l_shaped && !it.category.contains("corner") && said.next().is_none()
}

fn is_fire(thing: &DraftThing) -> bool {
    thing.category.ends_with("fireplace")
}

/// Places three sofas around a low table, the first one where `seek` finds a place. Whether there is one.
pub fn on_three_sides(plan: &mut Plan, thing: usize, seek: &Seek<'_>) -> bool {
    let it = plan.draft.things[thing].clone();
    let Some([w, _, d]) = it.size else { return false };
    let low = Plan::size(TABLE);
    let middle = d / 2.0 + REACH + low[2] / 2.0;
    let beside = w / 2.0 + CORNER + d / 2.0;
    let at_side = |side: f64| Pose { x: side * beside, z: d / 2.0 + CORNER + w / 2.0, yaw: -side * 90.0, y: 0.0 };
    let frames = vec![Pose::default(), at_side(-1.0), at_side(1.0)];
    let before = Pose { z: middle, yaw: 180.0, y: 0.05, ..Pose::default() };
    let free = vec![(before, [w, 1.0, low[2]])];
    let root = Root { n: 1, frames: frames.clone(), wall: AtWall::No, free, whole: false, seek };
    if !plan.place_asked(thing, &root) {
        return false;
    }
    off_walls(plan, &it.name);
    let first = format!("{}[0]", it.name);
    for (i, at) in frames.iter().enumerate().skip(1) {
        let slot = Slot { x: at.x, z: at.z, level: Level::Floor, yaw: at.yaw.rem_euclid(360.0) };
        let other = format!("{}[{i}]", it.name);
        plan.say(
            format!("assert {};", place::fixed(&other, &first, &slot, 0.0, 0.0)),
            "three sofas stand around a table",
        );
    }
    table(plan, &first, middle);
    true
}

/// Gives two sofas a place in a corner, at right angles, the first one where `seek` finds one. Whether there is one.
pub fn in_corner(plan: &mut Plan, thing: usize, seek: &Seek<'_>) -> bool {
    let it = plan.draft.things[thing].clone();
    let Some([w, _, d]) = it.size else { return false };
    let low = Plan::size(TABLE);
    let middle = d / 2.0 + REACH + low[2] / 2.0;
    [-1.0, 1.0].into_iter().any(|side| {
        let beside = side * (w / 2.0 + CORNER + d / 2.0);
        let second = Pose { x: beside, z: ASIDE - d / 2.0 + w / 2.0, yaw: -side * 90.0, y: 0.0 };
        let frames = vec![Pose::default(), second];
        let before = Pose { z: middle, yaw: 180.0, ..Pose::default() };
        let free = vec![(Pose { y: 0.05, ..before }, [w.min(low[0] + 0.9), 1.0, low[2]])];
        // The back of the second is at a wall, too.
        let at_both = |floor: &Floor, shape: &Shape, before: &[Pose]| {
            let pose = seek(floor, shape, before)?;
            let other = pose.then(&second);
            let wall = super::seek::Wall::behind(&other)?;
            let off = match wall {
                super::seek::Wall::Back => floor.size[2] / 2.0 - other.z,
                super::seek::Wall::Front => floor.size[2] / 2.0 + other.z,
                super::seek::Wall::Left => floor.size[0] / 2.0 + other.x,
                super::seek::Wall::Right => floor.size[0] / 2.0 - other.x,
            };
            (off - d / 2.0 < NEAR).then_some(pose)
        };
        let root = Root { n: 1, frames, wall: AtWall::No, free, whole: false, seek: &at_both };
        if !plan.place_asked(thing, &root) {
            return false;
        }
        let [first, other] = [0, 1].map(|i| format!("{}[{i}]", it.name));
        let slot = Slot { x: second.x, z: second.z, level: Level::Floor, yaw: second.yaw.rem_euclid(360.0) };
        plan.say(format!("assert {};", place::fixed(&other, &first, &slot, 0.0, 0.0)), "two sofas form a corner");
        table(plan, &first, middle);
        true
    })
}

/// Whether a thing is a pair of desks at which people sit face to face.
pub fn is_pair_of_desks(plan: &Plan, thing: usize) -> bool {
    let it = &plan.draft.things[thing];
    let behind = format!("behind({}[2 * i], {}[", it.name, it.name);
    is_two(plan, thing, &behind, ">= 175") && stand::group(&it.category) == Group::Table
}

/// Whether a thing is two of which a statement with these words speaks, and nothing else is said of where they are.
fn is_two(plan: &Plan, thing: usize, relation: &str, more: &str) -> bool {
    let it = &plan.draft.things[thing];
    if it.count != 2 {
        return false;
    }
    let mut said = plan.draft.statements.iter().filter(|s| mentions(&s.text, &it.name));
    let only = said.all(|s| {
        !matches!(s.source, ThingOrigin::Stated(_))
            || s.text.contains(relation)
            || is_table_between(plan, &s.text)
            || s.text.contains("inside(")
            || s.text.contains("onFloor(")
    });
    let related = plan.draft.statements.iter().any(|s| s.text.contains(relation) && s.text.contains(more));
    related && only
}

/// Whether a statement puts a low table between the two, where it stands anyway.
fn is_table_between(plan: &Plan, text: &str) -> bool {
    let low = |t: &&DraftThing| t.count == 1 && t.size.is_some_and(|[_, h, _]| h < LOW);
    plan.draft.things.iter().filter(low).any(|table| text.contains(&format!("between({}, ", table.name)))
}

/// Gives the two desks a place. Whether there is one.
pub fn desks(plan: &mut Plan, thing: usize, seek: &Seek<'_>) -> bool {
    let it = plan.draft.things[thing].clone();
    let Some([_, _, d]) = it.size else { return false };
    let edge = d + EDGE;
    let frames = vec![Pose::default(), Pose { z: -edge, yaw: 180.0, ..Pose::default() }];
    let root = Root { n: 1, frames, wall: AtWall::No, free: Vec::new(), whole: false, seek };
    if !plan.place_asked(thing, &root) {
        return false;
    }
    off_walls(plan, &it.name);
    let [first, second] = [0, 1].map(|i| format!("{}[{i}]", it.name));
    let across = Slot { x: 0.0, z: -edge, level: Level::Floor, yaw: 180.0 };
    plan.say(format!("assert {};", place::fixed(&second, &first, &across, 0.0, 0.0)), "they face each other");
    true
}

/// What stands in mid-room is not wanted at a wall.
fn off_walls(plan: &mut Plan, name: &str) {
    let wall = format!("againstWall(a, {})", plan.room_name());
    plan.draft.statements.retain(|s| s.demand != Demand::Prefer || !s.text.contains(&wall) || !mentions(&s.text, name));
}

/// Gives the pair a place, its first one where `seek` finds one. Whether there is one.
pub fn stand_up(plan: &mut Plan, thing: usize, seek: &Seek<'_>) -> bool {
    let it = plan.draft.things[thing].clone();
    let Some([w, _, d]) = it.size else { return false };
    let frames = vec![Pose::default(), Pose { z: d + ACROSS, yaw: 180.0, ..Pose::default() }];
    let middle = (d + ACROSS) / 2.0;
    let free = vec![(Pose { z: middle, y: 0.05, ..Pose::default() }, [w, 1.0, ACROSS])];
    // One gets everywhere with the table there.
    let stands = Footprint {
        thing: usize::MAX,
        at: Pose { z: middle, yaw: 180.0, ..Pose::default() },
        size: Plan::size(TABLE),
        flat: false,
        tall: false,
    };
    let with_table = |floor: &Floor, shape: &Shape, before: &[Pose]| {
        let mut whole = shape.clone();
        whole.pieces.push(stands);
        seek(floor, &whole, before)
    };
    let root = Root { n: 1, frames, wall: AtWall::No, free, whole: false, seek: &with_table };
    if !plan.place_asked(thing, &root) {
        return false;
    }
    off_walls(plan, &it.name);
    let [first, second] = [0, 1].map(|i| format!("{}[{i}]", it.name));
    let across = Slot { x: 0.0, z: d + ACROSS, level: Level::Floor, yaw: 180.0 };
    plan.say(format!("assert {};", place::fixed(&second, &first, &across, 0.0, 0.0)), "they face each other");
    table(plan, &first, middle);
    true
}

/// The table between the two: one that is asked for and has no place, or another.
fn table(plan: &mut Plan, first: &str, middle: f64) {
    let is_low = |at: &usize| {
        let thing = &plan.draft.things[*at];
        let low = thing.size.is_some_and(|[_, h, d]| h < LOW && d < ACROSS - 0.5);
        let name = &thing.name;
        thing.room == Some(plan.room)
            && thing.count == 1
            && low
            && stand::group(&thing.category) == Group::Table
            && !plan.claimed.contains(at)
            && !stand::placed_where(plan.draft, name, None, &|s| !s.text.contains(&format!("between({name}, ")))
            && plan.draft.place_of(name).is_none()
    };
    let asked = (0..plan.draft.things.len()).find(is_low);
    let at = match asked {
        Some(at) => at,
        None if plan.is_closed(TABLE) => return,
        None => plan.add(TABLE, 1, Plan::size(TABLE), WHY),
    };
    let name = plan.draft.things[at].name.clone();
    let slot = Slot { x: 0.0, z: middle, level: Level::Floor, yaw: 180.0 };
    plan.say(format!("assert {};", place::fixed(&name, first, &slot, 0.0, 0.0)), WHY);
    plan.claimed.push(at);
    if let Some(from) = plan.place_in_room(first) {
        let pose = from.then(&Pose { z: middle, yaw: 180.0, ..Pose::default() });
        plan.note_place(&name, &pose);
        let size = plan.draft.things[at].size.unwrap_or_default();
        let piece = Footprint { thing: at, at: Pose::default(), size, flat: false, tall: false };
        let shape = Shape { pieces: vec![piece], ..Shape::default() };
        plan.ground.iter_mut().for_each(|ground| ground.take(&shape, &pose));
    }
    plan.surround_as(BETWEEN, at, AtWall::No, 2);
}
