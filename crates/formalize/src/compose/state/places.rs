//! Where in its room a thing stands: at which wall, in which corner, on which side.

use super::{Named, Side};
use crate::brief::{FactKind, Group, Place, Rel};
use crate::write::number;
use scenelang_lang::nouns::{self, Stands};
use scenelang_lang::roles;

/// Beside what stands between something and a wall so much is free (metres).
const PASS: f64 = 0.6;
/// Around a table so much is free for those who sit at it (metres): a chair that is pulled out, and somebody who passes.
const SEATED: f64 = 1.2;
/// At two sides of a table in a corner so many sit.
const AT_TWO_SIDES: usize = 3;
/// What is so many times deeper than wide has its long sides at its left and right.
const LONGER: f64 = 1.2;

impl Named<'_> {
    #[allow(clippy::too_many_arguments)]
    pub(super) fn place(
        &self,
        k: usize,
        a: usize,
        rel: Rel,
        place: Place,
        which: &[String],
        verb: &str,
        out: &mut Vec<String>,
    ) {
        let room = self.room(a);
        let group = self.group(a);
        let opening = self.brief.things[a].opening();
        // What things stand behind cannot have its back right at a wall; what hangs there leaves it free.
        let hangs = |of: &usize| matches!(self.group(*of), Group::Wall | Group::Screen | Group::Drape | Group::Window);
        let behind = self.brief.facts.iter().filter(|f| {
            let is = matches!(&f.what, FactKind::Rel(Rel::Behind, to) if to.contains(&a));
            is && !f.not && !f.soft
        });
        let behind = behind.flat_map(|f| f.of.iter().filter(|of| !hangs(of)));
        let deep = behind.map(|of| self.sizes[*of][0].max(self.sizes[*of][2])).reduce(f64::max);
        let up = self.is_hung(a, rel);
        // Nothing that hangs on a wall leaves room for what is behind it.
        let verb = if up && deep.is_some() && place == Place::Wall && !opening { "prefer" } else { verb };
        let turned = self.turned_walls(a, place, which);
        let which = &turned[..];
        let mut say = |text: String| out.push(format!("{verb} {text};"));
        // What is no contact with the wall.
        if place == Place::Wall && !opening {
            if let Some(text) = self.off_wall(a, rel, which) {
                say(text);
            }
            if matches!(rel, Rel::Facing | Rel::Parallel | Rel::Perpendicular | Rel::Near | Rel::Beside | Rel::Far) {
                return;
            }
        }
        match place {
            Place::Wall if opening => {
                self.side(a, which).into_iter().chain(self.middle_of_wall(a, which)).for_each(&mut say);
            }
            Place::Wall => {
                say(self.all(a, |x| match deep {
                    _ if up => format!("wallMounted({x}, {room})"),
                    None => format!("againstWall({x}, {room})"),
                    // As near the wall as what stands behind it, and who gets there, let it be.
                    Some(deep) => {
                        let off = number(((deep + PASS) * 10.0).ceil() / 10.0);
                        format!("inside({x}, {room}) and backToWall({x}, {room}, {off})")
                    }
                }));
                if let Some(text) = self.wall(k, a, which) {
                    say(text);
                }
                if let Some(text) = self.part_of_walls(a, which) {
                    say(text);
                }
            }
            Place::Corner if group != Group::Ceiling && (group != Group::Top || !self.carried_at_all(a)) => {
                self.corner(k, a, which, verb, out);
            }
            Place::Corner => say(self.all(a, |x| format!("gap({x}, {room}) <= 0.5"))),
            Place::Ceiling => say(self.all(a, |x| format!("ceilingMounted({x}, {room})"))),
            Place::Floor => say(self.all(a, |x| format!("onFloor({x}, {room})"))),
            Place::Middle if opening => {}
            Place::Middle if self.counts[a] == 1 && !self.shares_middle(a) => {
                say(format!("centeredIn({}, {room})", self.name(a)));
            }
            Place::Middle => {
                let size = self.room_sizes.get(self.brief.things[a].room).copied().unwrap_or([6.0; 3]);
                let half = self.grid(a).map_or(0.0, |g| {
                    (g.steps[0] * (g.columns - 1) as f64).hypot(g.steps[1] * (g.rows - 1) as f64) / 2.0 + 0.6
                });
                let reach = number(((size[0].min(size[2]) / 3.0).max(half) * 10.0).ceil() / 10.0);
                say(self.all(a, |x| {
                    format!(
                        "length(vec3({x}.center.x - {room}.center.x, 0, {x}.center.z - {room}.center.z)) <= {reach}"
                    )
                }));
                // One row is on the middle line.
                if self.grid(a).is_some_and(|grid| grid.rows == 1 && grid.columns > 1) {
                    let across = if self.is_lengthwise(a) { "x" } else { "z" };
                    say(format!("abs({}[0].center.{across} - {room}.center.{across}) <= 0.5", self.name(a)));
                }
            }
            Place::Side | Place::End | Place::Back | Place::Front | Place::Head | Place::Foot => {
                let mut which = which.to_vec();
                match place {
                    Place::Back => which.push("back".into()),
                    Place::Front => which.push("front".into()),
                    _ => {}
                }
                if self.is_turned_round(a, place) {
                    which.iter_mut().for_each(|word| *word = opposite(word));
                }
                if let Some(text) = self.side(a, &which) {
                    say(text);
                }
            }
            Place::Row | Place::Circle => {}
        }
    }

    /// Whether a thing that has this relation to a wall hangs there.
    fn is_hung(&self, a: usize, rel: Rel) -> bool {
        let group = self.group(a);
        let stands = matches!(group, Group::Table | Group::Seat | Group::Bed) || self.tall(a) || self.is_heavy(a);
        matches!(group, Group::Wall | Group::Screen | Group::Drape | Group::Ceiling)
            || matches!(rel, Rel::Mounted | Rel::Hang)
            || rel == Rel::On && !stands
    }

    /// What nobody hangs up: "dryers on the opposite wall" stand there, and so does a fireplace.
    fn is_heavy(&self, a: usize) -> bool {
        const HEAVY: f64 = 0.25;
        let name = self.brief.things[a].name();
        let stands = nouns::noun(&name).is_some_and(|noun| noun.stands == Stands::Back);
        let [w, _, d] = self.sizes[a];
        (stands || roles::role_of(&name) == "appliance") && w * d >= HEAVY && self.group(a) == Group::Floor
    }

    /// In the middle of its wall, or at two walls that face each other.
    fn part_of_walls(&self, a: usize, which: &[String]) -> Option<String> {
        const OFF: &str = "0.2";
        let (room, name) = (self.room(a), self.name(a));
        let is = |part: &str| which.iter().any(|word| word == part);
        if is("middle") && self.counts[a] == 1 {
            return Some(format!("abs(dot({name}.center - {room}.center, {name}.right)) <= {OFF}"));
        }
        (is("opposite") && self.counts[a] == 2).then(|| format!("dot({name}[0].front, {name}[1].front) <= -0.9"))
    }

    /// In the middle of the wall that an opening is in.
    fn middle_of_wall(&self, a: usize, which: &[String]) -> Option<String> {
        const OFF: &str = "0.2";
        let (room, name) = (self.room(a), self.name(a));
        let is_middle = which.iter().any(|word| matches!(word.as_str(), "middle" | "center" | "centre"));
        let (axis, _) = which.iter().find_map(|word| direction(word)).filter(|_| is_middle && self.counts[a] == 1)?;
        let along = if axis == 'x' { 'z' } else { 'x' };
        Some(format!("abs({name}.center.{along} - {room}.center.{along}) <= {OFF}"))
    }

    /// Where a thing must not stand; `None`: no statement denies this place.
    pub(super) fn not_at(&self, a: usize, rel: Rel, place: Place) -> Option<String> {
        let room = self.room(a);
        let up = matches!(self.group(a), Group::Wall | Group::Screen | Group::Drape) || rel == Rel::Mounted;
        let predicate = match place {
            Place::Wall if up => "wallMounted",
            Place::Wall => "againstWall",
            Place::Corner => "inCorner",
            Place::Middle => "centeredIn",
            _ => return None,
        };
        Some(self.all(a, |x| format!("not {predicate}({x}, {room})")))
    }

    /// What a relation to a wall says that is no contact with it.
    fn off_wall(&self, a: usize, rel: Rel, which: &[String]) -> Option<String> {
        let room = self.room(a);
        let direction = which.iter().find_map(|w| direction(w));
        match rel {
            Rel::Facing => direction.map(|(axis, sign)| {
                let test = if sign > 0.0 { ">= 0.9" } else { "<= -0.9" };
                self.all(a, |x| format!("{x}.front.{axis} {test}"))
            }),
            Rel::Parallel | Rel::Perpendicular => {
                let along = direction.map(|d| d.0).or_else(|| self.axis(a, which));
                // Of a bed the long side is the one at which its front is not.
                let [w, _, d] = self.sizes[a];
                let is_across = (rel == Rel::Parallel) != (d > LONGER * w);
                let axis = along.map(|axis| if (axis == 'x') == is_across { 'x' } else { 'z' });
                Some(match axis {
                    Some(axis) => self.all(a, |x| format!("abs({x}.front.{axis}) >= 0.9")),
                    None => self.all(a, |x| format!("max(abs({x}.front.x), abs({x}.front.z)) >= 0.99")),
                })
            }
            Rel::Near | Rel::Beside => Some(self.all(a, |x| format!("gap({x}, {room}) <= 0.6"))),
            Rel::Far => Some(self.all(a, |x| format!("gap({x}, {room}) >= 0.5"))),
            _ => None,
        }
    }

    /// In a corner, or several in their corners.
    fn corner(&self, k: usize, a: usize, which: &[String], verb: &str, out: &mut Vec<String>) {
        let room = self.room(a);
        let mut say = |text: String| out.push(format!("{verb} {text};"));
        // A corner is for one: what comes when all are taken is near one at best.
        let free = 4_usize.saturating_sub(self.corners_before(k, a));
        let taken = self.elements(a);
        let aside = self.brief.facts.iter().find_map(|f| match f.what {
            FactKind::Clear(Side::Around | Side::Sides | Side::Left | Side::Right, v) if f.of.contains(&a) => Some(v),
            _ => None,
        });
        if let Some(v) = aside {
            // Free at its sides: as near the corner as that lets it be.
            say(self.all(a, |x| format!("againstWall({x}, {room})")));
            out.push(format!("prefer {};", self.all(a, |x| {
                format!("min(gap({x}.center - {x}.right * ({x}.size.x / 2 + {v}), {room}), gap({x}.center + {x}.right * ({x}.size.x / 2 + {v}), {room})) <= 0.3")
            })));
            if let Some(text) = self.side(a, which) {
                out.push(format!("{verb} {text};"));
            }
            return;
        }
        let (of, n) = (self.name(a), self.counts[a]);
        if n == 1 && self.has_places_around(a) {
            // People sit at all its sides: as near the corner as their chairs let it be.
            let reach = number(((self.sizes[a][0].max(self.sizes[a][2]) / 2.0 + SEATED) * 10.0).ceil() / 10.0);
            say(format!(
                "{room}.size.x / 2 - abs({of}.center.x - {room}.center.x) <= {reach} and {room}.size.z / 2 - abs({of}.center.z - {room}.center.z) <= {reach}"
            ));
            if let Some(text) = self.side(a, which) {
                say(text);
            }
            return;
        }
        if self.array(a) && !which.iter().any(|w| w == "each") {
            // Several in one corner: the others by the first.
            say(format!("inCorner({of}[0], {room})"));
            if let Some(text) = self.side(a, which) {
                say(text);
            }
            let [w, _, d] = self.sizes[a];
            let reach = ((n as f64).sqrt() * (w.max(d) + 0.2) * 10.0).ceil() / 10.0;
            say(format!("forall i in 1..{n}: near({of}[i], {of}[0], {})", number(reach)));
        } else if self.counts[a] <= free {
            say(self.all(a, |x| format!("inCorner({x}, {room})")));
            if let Some(text) = self.side(a, which) {
                say(text);
            }
        } else {
            if free > 0 {
                let each: Vec<String> = taken.iter().take(free).map(|x| format!("inCorner({x}, {room})")).collect();
                say(each.join(" and "));
            }
            out.push(format!("prefer {};", self.all(a, |x| format!("gap({x}, {room}) <= 0.5"))));
        }
    }

    /// Whether more people sit at a table than find a place at two of its sides: "a meeting table for six".
    fn has_places_around(&self, a: usize) -> bool {
        let thing = &self.brief.things[a];
        thing.group == Group::Table
            && thing.head().ends_with("table")
            && thing.places.is_some_and(|places| places > AT_TWO_SIDES)
    }

    /// Whether it is said to be on or in something.
    fn carried_at_all(&self, a: usize) -> bool {
        self.said(a, |w| matches!(w, FactKind::Rel(Rel::On | Rel::In, _)))
    }

    /// Whether something else that stands on the floor is said to be in the middle of the same room.
    fn shares_middle(&self, a: usize) -> bool {
        let stands = |o: usize| {
            let item = &self.brief.things[o];
            item.room == self.brief.things[a].room && !matches!(item.group, Group::Flat | Group::Ceiling)
        };
        let other = |o: &usize| *o != a && stands(*o);
        let middle = |w: &FactKind| matches!(w, FactKind::Place(rel, Place::Middle, _) if *rel != Rel::Near);
        stands(a) && self.brief.facts.iter().any(|f| !f.not && middle(&f.what) && f.of.iter().any(other))
    }

    /// How many things are said to be in corners of the same room before.
    fn corners_before(&self, k: usize, a: usize) -> usize {
        let same = |o: &usize| self.brief.things[*o].room == self.brief.things[a].room && *o != a;
        let before = self.brief.facts[..k]
            .iter()
            .filter(|f| !f.not && !f.soft && matches!(f.what, FactKind::Place(_, Place::Corner, _)));
        before.flat_map(|f| f.of.iter().filter(|o| same(o))).map(|o| self.counts[*o]).sum()
    }

    /// Along which axis a "long" or "short" wall looks.
    fn axis(&self, a: usize, which: &[String]) -> Option<char> {
        let size = self.room_sizes.get(self.brief.things[a].room).copied().unwrap_or([6.0, 2.7, 5.0]);
        which.iter().find_map(|w| {
            let along_x = size[0] >= size[2];
            match w.as_str() {
                "side" => Some('x'),
                "long" | "longer" | "longest" => Some(if along_x { 'z' } else { 'x' }),
                "short" | "shorter" | "end" => Some(if along_x { 'x' } else { 'z' }),
                _ => None,
            }
        })
    }

    /// Half of several at one of two walls, and half at the other.
    fn at_both(&self, a: usize, axis: char) -> String {
        let half = self.counts[a].div_ceil(2);
        let looks = self.elements(a).into_iter().enumerate().map(|(i, x)| {
            let test = if i < half { ">= 0.9" } else { "<= -0.9" };
            format!("{x}.front.{axis} {test}")
        });
        looks.collect::<Vec<_>>().join(" and ")
    }

    /// At which wall: its back is to it.
    fn wall(&self, k: usize, a: usize, which: &[String]) -> Option<String> {
        for w in which {
            match (direction(w), w.as_str()) {
                (Some((axis, sign)), _) => {
                    let test = if sign > 0.0 { "<= -0.9" } else { ">= 0.9" };
                    return Some(self.all(a, |x| format!("{x}.front.{axis} {test}")));
                }
                (_, "long" | "longer" | "longest" | "short" | "shorter" | "side" | "end") => {
                    let axis = self.axis(a, which)?;
                    if which.iter().any(|w| w == "each") && self.counts[a] > 1 {
                        return Some(self.at_both(a, axis));
                    }
                    return Some(self.all(a, |x| format!("abs({x}.front.{axis}) >= 0.9")));
                }
                (_, "opposite" | "other" | "same" | "opposing") => {
                    let here = |b: usize| b != a && self.brief.things[b].room == self.brief.things[a].room;
                    let other = self.brief.facts[..k].iter().rev().find_map(|f| {
                        let at_wall =
                            !f.not && matches!(f.what, FactKind::Place(_, Place::Wall, _)) && !f.of.contains(&a);
                        f.of.first().copied().filter(|b| at_wall && here(*b))
                    });
                    let several = self.counts[a] > 1 || self.brief.facts[k].of.len() > 1;
                    if w == "same" && other.is_none() && several {
                        return self.at_one_wall(k, a);
                    }
                    // Opposite to what was spoken of before, if nothing was said of a wall.
                    let stands = |b: &usize| {
                        here(*b) && matches!(self.group(*b), Group::Bed | Group::Seat | Group::Table | Group::Storage)
                    };
                    let b = self.elements(other.or_else(|| (0..a).find(stands))?).first()?.clone();
                    let test = if w == "same" { ">= 0.9" } else { "<= -0.9" };
                    return Some(self.all(a, |x| format!("dot({x}.front, {b}.front) {test}")));
                }
                (_, "one") => return self.at_one_wall(k, a),
                _ => {}
            }
        }
        None
    }

    /// "Mirrors on one wall": their backs are at the wall that the first of them has at its back.
    fn at_one_wall(&self, k: usize, a: usize) -> Option<String> {
        let first = *self.brief.facts[k].of.first()?;
        let lead = self.elements(first).first()?.clone();
        if a != first {
            return Some(self.all(a, |x| format!("dot({x}.front, {lead}.front) >= 0.9")));
        }
        let n = self.counts[a];
        let name = self.name(a);
        (n > 1).then(|| format!("forall i in 1..{n}: dot({name}[i].front, {lead}.front) >= 0.9"))
    }

    /// Whether the front of a room is where people in it look, and not where they come in: in a classroom the board is at the
    /// front, wherever the door is.
    fn is_turned_round(&self, a: usize, place: Place) -> bool {
        use crate::furnish::kinds::{self, PlanPlace};
        let thing = &self.brief.things[a];
        let kind = self.brief.rooms.get(thing.room).and_then(|room| kinds::of(&room.name));
        let Some(kind) = kind.filter(|kind| kind.is_taught() && !thing.opening()) else { return false };
        // What such rooms have there is there by either word.
        let noun = thing.name();
        let is_before = |line: &kinds::Line| matches!(line.place, PlanPlace::Back(_) | PlanPlace::Before(..));
        let has_there = kind.lines.iter().any(|line| is_before(line) && line.noun == noun);
        place == Place::Front || place == Place::Back && !has_there
    }

    /// The back wall of a classroom is behind those who sit in it.
    fn turned_walls(&self, a: usize, place: Place, which: &[String]) -> Vec<String> {
        let side = |word: &str| match word {
            "front" => Some(Place::Front),
            "back" | "rear" => Some(Place::Back),
            _ => None,
        };
        let walls = matches!(place, Place::Wall | Place::Corner);
        let turned = |word: &String| walls && side(word).is_some_and(|side| self.is_turned_round(a, side));
        which.iter().map(|word| if turned(word) { opposite(word) } else { word.clone() }).collect()
    }

    /// Whether the request says where in its room a thing is.
    pub fn is_somewhere(&self, a: usize) -> bool {
        let is_place = |f: &crate::brief::Fact| matches!(f.what, FactKind::Place(..)) && f.of.contains(&a) && !f.not;
        self.brief.facts.iter().any(is_place)
    }

    /// In which part of the room.
    fn side(&self, a: usize, which: &[String]) -> Option<String> {
        let room = self.room(a);
        let size = self.room_sizes.get(self.brief.things[a].room).copied().unwrap_or([6.0, 2.7, 5.0]);
        let tests: Vec<(char, f64)> = which.iter().filter_map(|w| direction(w)).collect();
        if tests.is_empty() {
            return None;
        }
        Some(self.all(a, |x| {
            let each: Vec<String> = tests
                .iter()
                .map(|(axis, sign)| {
                    let reach = if self.brief.things[a].opening() {
                        if *axis == 'x' { size[0] / 2.0 - 0.3 } else { size[2] / 2.0 - 0.3 }
                    } else {
                        0.0
                    };
                    if *sign > 0.0 {
                        format!("{x}.center.{axis} >= {room}.center.{axis}{}", shift(" + ", reach))
                    } else {
                        format!("{x}.center.{axis} <= {room}.center.{axis}{}", shift(" - ", reach))
                    }
                })
                .collect();
            each.join(" and ")
        }))
    }
}

/// Front for back, and back for front.
fn opposite(word: &str) -> String {
    match word {
        "front" => "back".into(),
        "back" | "rear" => "front".into(),
        other => other.into(),
    }
}

/// What is added, if it is anything.
fn shift(sign: &str, by: f64) -> String {
    if by == 0.0 { String::new() } else { format!("{sign}{}", number(by)) }
}

/// Compass and plan: north and back are +z, east and right +x.
pub(super) fn direction(word: &str) -> Option<(char, f64)> {
    let word = word.strip_suffix("ern").unwrap_or(word);
    Some(match word {
        "north" | "back" | "rear" | "far" | "upper" | "top" | "farthest" | "furthest" => ('z', 1.0),
        "south" | "front" | "near" | "lower" | "bottom" | "entrance" => ('z', -1.0),
        "east" | "right" | "right-hand" => ('x', 1.0),
        "west" | "left" | "left-hand" => ('x', -1.0),
        _ => return None,
    })
}
