//! How large a room is whose size nobody gave: as its kind usually is, larger where something that matters finds no room,
//! smaller where more of the floor is idle than in such rooms.

use super::inventory::listed;
use super::kinds;
use super::number::{Scale, scale};
use super::room::{First, Furnished, furnish_once};
use super::stand;
use crate::brief::{Brief, Group};
use crate::draft::{Draft, DraftThing, ThingOrigin};
use scenelang_lang::nouns::with_article;

/// How often a room grows in which something that matters finds no room, and by how much.
const GROWN: usize = 5;
/// The same of one that is said to be small.
const GROWN_SMALL: usize = 4;
const GROWTH: f64 = 1.07;
/// How often a room becomes smaller that has more floor than its furniture needs: as a whole, and then each side by so
/// much.
const HALVED: usize = 4;
const SHRUNK: usize = 3;
const SHRINKING: f64 = 0.94;
/// So many of a kind stand in rows.
const IN_ROWS: usize = 6;
/// Other proportions of the room that are tried, as parts of its width and depth.
const TURNED: [[f64; 2]; 4] = [[0.72, 1.22], [1.22, 0.72], [0.82, 1.1], [1.1, 0.82]];
/// A room keeps this part of the floor that such rooms usually have.
const LEAST: f64 = 0.6;
/// A room of which so much more than the usual part is idle may lose so many pieces of its inventory.
const IDLE_BY_FAR: f64 = 0.26;
const SPARED: usize = 2;
/// Where more than this is said of how things stand, floor is left for it, and the room keeps this part of its size.
const FACTS: usize = 2;
const TOLD: f64 = 0.8;
/// What is left of the longer wall beside the longest thing (metres).
const BESIDE: f64 = 0.1;
/// Beside the rows that are asked for, and before and behind them (metres).
const BESIDE_ROWS: f64 = 1.2;
/// A room is no longer than so many times its width.
const LONG: f64 = 1.7;

/// Furnishes a room of a draft.
pub fn furnish(draft: &mut Draft, brief: &Brief, at: usize, closed: &[String]) {
    let room = &draft.rooms[at];
    let is_free = draft.rooms.len() == 1 && !room.sized && room.outline.is_none();
    // In a larger or smaller room as much is counted by area as in one of the usual size.
    let area = room.size[0] * room.size[2];
    let usual = brief.rooms.get(at).and_then(|room| room.usual).map_or(area, |[w, _, d]| w * d);
    let counted = if is_free { usual.min(area) } else { area };
    let is_small = scale(brief, at) == Scale::Small;
    // A side whose length the request gives keeps it.
    let said = brief.rooms.get(at).map_or([None; 2], |room| [room.size[0], room.size[2]]);
    let once = |draft: &mut Draft| {
        let furnished = furnish_once(draft, brief, at, closed, (counted, First::Asked));
        // Nobody expects much room behind the chairs of a small room.
        Furnished { tight: if is_small { 0 } else { furnished.tight }, ..furnished }
    };
    let empty = draft.clone();
    let mut furnished = once(draft);
    if !is_free {
        // A room that cannot grow has its bed before the desk that is asked for, or its wardrobe before the bed, if only so both
        // have a place.
        for first in [First::Kind, First::Next] {
            if furnished.lacking == 0 {
                break;
            }
            let mut other = empty.clone();
            let next = furnish_once(&mut other, brief, at, closed, (counted, first));
            let has_first =
                kind_line(&draft.rooms[at].kind).is_none_or(|noun| count(&other, &noun) >= count(draft, &noun));
            if next.wants() < furnished.wants() && has_first {
                (furnished, *draft) = (next, other);
            }
        }
        return;
    }
    if furnished.wants() != [0; 3] {
        let most = if is_small { GROWN_SMALL } else { GROWN };
        furnished = grow(draft, empty.clone(), (at, most, said), furnished, &once);
    }
    let kind = kinds::of(&draft.rooms[at].kind).or_else(|| kinds::of("room"));
    // A ward is as large as its beds need.
    let is_ward = kind.is_some_and(|kind| kind.bay.is_some());
    if scale(brief, at) != Scale::Large && !is_ward && draft.roomier == 0 {
        let most = kind.map_or(1.0, |kind| kind.idle);
        let least = if brief.facts.len() > FACTS { TOLD } else { LEAST } * counted;
        shrink(draft, empty, (at, said), (most, least), furnished, &once);
    }
}

/// Furnishes a room in which something is lacking or cannot be reached anew, larger and larger, and takes the smallest that lacks
/// the least.
fn grow(
    draft: &mut Draft,
    mut empty: Draft,
    (at, most, said): (usize, usize, [Option<f64>; 2]),
    mut best: Furnished,
    furnish: &impl Fn(&mut Draft) -> Furnished,
) -> Furnished {
    for _ in 0..most {
        for k in [0, 2].into_iter().filter(|k| said[k / 2].is_none()) {
            empty.rooms[at].size[k] = (empty.rooms[at].size[k] * GROWTH * 10.0).ceil() / 10.0;
        }
        let mut larger = empty.clone();
        let furnished = furnish(&mut larger);
        if furnished.wants() < best.wants() {
            (best, *draft) = (furnished, larger);
        }
        if best.wants() == [0; 3] {
            break;
        }
    }
    best
}

/// Furnishes a room of which more than `most` is idle anew and smaller, as long as there is room for all that stands in it, plants
/// apart: first as a whole, then one side and the other.
fn shrink(
    draft: &mut Draft,
    mut empty: Draft,
    (at, said): (usize, [Option<f64>; 2]),
    (most, least): (f64, f64),
    mut now: Furnished,
    furnish: &impl Fn(&mut Draft) -> Furnished,
) {
    let kind = kinds::of(&draft.rooms[at].kind);
    let is_home = kind.is_some_and(|kind| kind.home.is_some());
    let listed = kind.map(listed);
    // Whether a thing is there because such rooms have some, and not because it goes with another thing.
    let is_inventory = |thing: &DraftThing| match (&thing.source, &listed) {
        (ThingOrigin::Inferred(why), Some(listed)) => why.starts_with(listed.as_str()),
        _ => false,
    };
    let own = draft.things.iter().filter(|thing| thing.room == Some(at));
    let longest = own.filter_map(|thing| thing.size).fold(0.0, |most: f64, [w, _, d]| most.max(w).max(d)) + BESIDE;
    let sizes = footprints(draft, at);
    let rows = draft.rooms[at].rows;
    let mut try_sides = |draft: &mut Draft, now: &mut Furnished, [w, d]: [f64; 2]| {
        let round = |v: f64| (v * 10.0).round() / 10.0;
        let [w, d] = [said[0].unwrap_or_else(|| round(w)), said[1].unwrap_or_else(|| round(d))];
        let size = draft.rooms[at].size;
        let is_long = w.max(d) > LONG * w.min(d) && said == [None; 2];
        let is_narrow = rows[0] > 0.0 && (w < rows[0] + BESIDE_ROWS || d < rows[1] + BESIDE_ROWS);
        let is_short = w.max(d) < longest || !hold(&sizes, [w, d]);
        if w * d < least - 1e-9 || is_short || is_long || is_narrow || [w, d] == [size[0], size[2]] {
            return false;
        }
        empty.rooms[at].size = [w, size[1], d];
        let mut smaller = empty.clone();
        let furnished = furnish(&mut smaller);
        let is_mat = |thing: &DraftThing| thing.count > 1 && stand::group(&thing.category) == Group::Flat;
        let standing = draft
            .things
            .iter()
            .filter(|thing| (is_mat(thing) || stand::on_floor(draft, thing)) && thing.category != "plant");
        let missing = standing.filter(|thing| count(&smaller, &thing.category) < count(draft, &thing.category));
        // Where people work, a coat rack or a second cabinet may go if a room would be idle by far for the sake of it.
        let may_go = if now.idle > most + IDLE_BY_FAR && !is_home { SPARED } else { 0 };
        let (minor, mut other): (Vec<_>, Vec<_>) = missing.partition(|thing| is_inventory(thing));
        // What is on it goes with it.
        other.retain(|thing| !minor.iter().any(|carrier| is_because_of(thing, carrier)));
        let has_all = furnished.lacking <= now.lacking
            && furnished.unreached <= now.unreached
            && furnished.tight <= now.tight
            && other.is_empty()
            && minor.len() <= may_go;
        if has_all {
            (*now, *draft) = (furnished, smaller);
        }
        has_all
    };
    // The part of its sides that the room keeps, and what was too small already.
    let (mut kept, mut low) = (1.0, 0.0);
    let [w, _, d] = draft.rooms[at].size;
    for _ in 0..HALVED {
        if now.idle <= most {
            break;
        }
        // What is left if all idle floor went, or half-way to it.
        let aim = (kept * (1.0 - (now.idle - most)).sqrt()).max((least / (w * d)).sqrt());
        let next = if low > 0.0 { (kept + low) / 2.0 } else { aim };
        if next > 0.98 * kept {
            break;
        }
        if try_sides(&mut *draft, &mut now, [w * next, d * next]) {
            kept = next;
        } else {
            low = next;
        }
    }
    // Rows of which the last is nearly empty fit better into a room that is narrower and deeper, or the other way round.
    let has_rows = draft.things.iter().any(|thing| thing.room == Some(at) && thing.count >= IN_ROWS);
    for [across, deep] in TURNED {
        if now.idle <= most || !has_rows {
            break;
        }
        let [w, _, d] = draft.rooms[at].size;
        try_sides(&mut *draft, &mut now, [w * across, d * deep]);
    }
    let mut done = [false; 2];
    for step in 0..2 * SHRUNK {
        let k = step % 2;
        if done[k] || now.idle <= most {
            continue;
        }
        let [w, _, d] = draft.rooms[at].size;
        let sides = if k == 0 { [w * SHRINKING, d] } else { [w, d * SHRINKING] };
        done[k] = !try_sides(&mut *draft, &mut now, sides);
    }
}

/// Width and depth of what is in a room, and whether it lies on the floor.
fn footprints(draft: &Draft, at: usize) -> Vec<([f64; 2], bool)> {
    let own = draft.things.iter().filter(|thing| thing.room == Some(at));
    let lies = |thing: &DraftThing| stand::group(&thing.category) == Group::Flat;
    own.filter_map(|thing| thing.size.map(|[x, _, z]| ([x, z], lies(thing)))).collect()
}

/// Whether a room so wide and so deep has room for each of them. What lies on the floor lies along the walls; all else may be turned.
fn hold(sizes: &[([f64; 2], bool)], [w, d]: [f64; 2]) -> bool {
    sizes.iter().all(|([x, z], lies)| w.min(d) >= x.min(*z) && (!lies || w >= *x && d >= *z))
}

/// Whether a thing is there because of another one: a box that is on a pallet.
fn is_because_of(thing: &DraftThing, other: &DraftThing) -> bool {
    let needs = format!("{} needs ", with_article(&other.category.replace('_', " ")));
    matches!(&thing.source, ThingOrigin::Inferred(why) if why.starts_with(&needs))
}

/// The category of what matters most in a kind of room.
fn kind_line(room: &str) -> Option<String> {
    kinds::of(room)?.lines.first().map(|line| line.noun.replace(' ', "_"))
}

/// How many things of a category there are.
fn count(draft: &Draft, category: &str) -> usize {
    let like = |thing: &&DraftThing| thing.category == category;
    draft.things.iter().filter(like).map(|thing| thing.count).sum()
}
