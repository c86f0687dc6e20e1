//! Two sofas that are asked for and face each other stand across a low table, as one piece; two desks stand edge to edge.

use super::build::Root;
use super::floor::{Floor, Piece, Pose, Shape};
use super::plan::{AtWall, Plan};
use super::slots::{Level, Slot};
use super::{place, stand};
use crate::brief::Group;
use crate::draft::{Demand, Source};
use crate::names::words;

/// Between the fronts of two seats that face each other, with a low table between them (metres).
const ACROSS: f64 = 1.5;
/// Between the edges of two desks (metres).
const EDGE: f64 = 0.01;
/// What is lower can stand there.
const LOW: f64 = 0.6;
/// The group of what stands around that table, and what is added where none is asked for.
const BETWEEN: &str = "facing table";
const TABLE: &str = "coffee table";
const WHY: &str = "who sits face to face has a low table between";

/// Finds a place for a group, given those of the groups before it.
type Seek<'s> = dyn Fn(&Floor, &Shape, &[Pose]) -> Option<Pose> + 's;

/// Whether a thing is such a pair.
pub fn is_pair(plan: &Plan, thing: usize) -> bool {
    let it = &plan.draft.things[thing];
    let facing = format!("facing({}[2 * i], {}[", it.name, it.name);
    is_two(plan, thing, &facing, "") && stand::group(&it.category) == Group::Seat && stand::has_back(&it.category)
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
    let mut said = plan.draft.statements.iter().filter(|s| words(&s.text).contains(&it.name.as_str()));
    let only = said.all(|s| {
        !matches!(s.source, Source::Stated(_))
            || s.text.contains(relation)
            || s.text.contains("inside(")
            || s.text.contains("onFloor(")
    });
    let related = plan.draft.statements.iter().any(|s| s.text.contains(relation) && s.text.contains(more));
    it.count == 2 && related && only
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
    plan.draft
        .statements
        .retain(|s| s.demand != Demand::Prefer || !s.text.contains(&wall) || !words(&s.text).contains(&name));
}

/// Gives the pair a place, its first one where `seek` finds one. Whether there is one.
pub fn stand_up(plan: &mut Plan, thing: usize, seek: &Seek<'_>) -> bool {
    let it = plan.draft.things[thing].clone();
    let Some([w, _, d]) = it.size else { return false };
    let frames = vec![Pose::default(), Pose { z: d + ACROSS, yaw: 180.0, ..Pose::default() }];
    let middle = (d + ACROSS) / 2.0;
    let free = vec![(Pose { z: middle, y: 0.05, ..Pose::default() }, [w, 1.0, ACROSS])];
    // One gets everywhere with the table there.
    let stands = Piece {
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
            && !stand::placed(plan.draft, name)
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
        let piece = Piece { thing: at, at: Pose::default(), size, flat: false, tall: false };
        let shape = Shape { pieces: vec![piece], free: Vec::new() };
        plan.ground.iter_mut().for_each(|ground| ground.take(&shape, &pose));
    }
    plan.surround_as(BETWEEN, at, AtWall::No, 2);
}
