//! How large a room is whose size nobody gave: as its kind usually is, larger where something that matters finds no room,
//! smaller where much of the floor would be empty.

use super::number::{Scale, scale};
use super::room::furnish_once;
use super::stand;
use crate::brief::Brief;
use crate::draft::{Draft, Thing};

/// How often a room grows in which something that matters finds no room, and by how much.
const GROWN: usize = 5;
const GROWTH: f64 = 1.07;
/// How often each side of a room becomes shorter that has more floor than its furniture needs, and by how much.
const SHRUNK: usize = 5;
const SHRINKING: f64 = 0.95;
/// The part of the floor that furniture covers in a room that is as full as such rooms are.
const COVERED: f64 = 0.3;
/// A room keeps this part of the floor that such rooms usually have.
const LEAST: f64 = 0.66;
/// Where more than this is said of how things stand, floor is left for it.
const FACTS: usize = 2;
/// What is lower than this covers no floor (metres).
const FLAT: f64 = 0.05;
/// What is left of the longer wall beside the longest thing (metres).
const BESIDE: f64 = 0.1;
/// A room is no longer than so many times its width.
const LONG: f64 = 1.7;

/// Furnishes a room of a draft.
pub fn furnish(draft: &mut Draft, brief: &Brief, at: usize, closed: &[String]) {
    let room = &draft.rooms[at];
    let is_free = draft.rooms.len() == 1 && !room.sized && room.outline.is_none();
    // In a larger or smaller room as much is counted by area as in one of the usual size.
    let counted = room.size[0] * room.size[2];
    let once = |draft: &mut Draft| furnish_once(draft, brief, at, closed, counted);
    let empty = draft.clone();
    let mut lacking = once(draft);
    if is_free && lacking > 0 {
        lacking = grow(draft, empty.clone(), at, lacking, &once);
    }
    let told = brief.facts.len() > FACTS;
    if is_free && lacking == 0 && !told && scale(brief, at) == Scale::Usual && !draft.outdoor {
        shrink(draft, empty, at, LEAST * counted, &once);
    }
}

/// Furnishes a room in which so much is lacking anew, larger and larger, and takes the smallest that lacks the least.
fn grow(
    draft: &mut Draft,
    mut empty: Draft,
    at: usize,
    mut least: usize,
    furnish: &impl Fn(&mut Draft) -> usize,
) -> usize {
    for _ in 0..GROWN {
        for k in [0, 2] {
            empty.rooms[at].size[k] = (empty.rooms[at].size[k] * GROWTH * 10.0).ceil() / 10.0;
        }
        let mut larger = empty.clone();
        let lacking = furnish(&mut larger);
        if lacking < least {
            (least, *draft) = (lacking, larger);
        }
        if least == 0 {
            break;
        }
    }
    least
}

/// Furnishes a room with much empty floor anew, with one side and then the other shorter, as long as there is room for all
/// that it had.
fn shrink(draft: &mut Draft, mut empty: Draft, at: usize, least: f64, furnish: &impl Fn(&mut Draft) -> usize) {
    let mut size = draft.rooms[at].size;
    let mut done = [false; 2];
    let own = draft.things.iter().filter(|thing| thing.room == Some(at));
    let longest = own.filter_map(|thing| thing.size).fold(0.0, |most: f64, [w, _, d]| most.max(w).max(d)) + BESIDE;
    for step in 0..2 * SHRUNK {
        let k = 2 * (step % 2);
        let side = (size[k] * SHRINKING * 10.0).floor() / 10.0;
        let odd = size[2 - k] > LONG * side || size[2 - k] * side < least || side.max(size[2 - k]) < longest;
        if covered(draft, at) >= COVERED || done[k / 2] || odd {
            continue;
        }
        empty.rooms[at].size = size;
        empty.rooms[at].size[k] = side;
        let mut smaller = empty.clone();
        let has_all = furnish(&mut smaller) == 0
            && draft.things.iter().all(|thing| count(&smaller, &thing.category) >= count(draft, &thing.category));
        if has_all {
            (size[k], *draft) = (side, smaller);
        } else {
            done[k / 2] = true;
        }
    }
}

/// How many things of a category there are.
fn count(draft: &Draft, category: &str) -> usize {
    draft.things.iter().filter(|thing| thing.category == category).map(|thing| thing.count).sum()
}

/// The part of the floor of a room that things stand on.
fn covered(draft: &Draft, at: usize) -> f64 {
    let stand = draft.things.iter().filter(|thing| thing.room == Some(at) && stand::on_floor(draft, thing));
    let area = |thing: &Thing| thing.size.map_or(0.0, |[w, h, d]| if h < FLAT { 0.0 } else { w * d });
    let [w, _, d] = draft.rooms[at].size;
    stand.map(|thing| thing.count as f64 * area(thing)).sum::<f64>() / (w * d)
}
