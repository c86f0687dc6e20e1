//! The plan of a storey: several rooms in a compact outline, each reached from the one that leads to the others, pipes
//! beside pipes, every room but a hall at an outer wall. Doors that nobody asked for are added where they are needed.
//!
//! A size that the request gives is never changed; the other rooms get sizes that such rooms have in a home, from
//! `data/kinds.txt`.

mod annex;
mod cost;
mod rows;
mod search;

use crate::arrange::arrange_rooms;
use crate::brief::{Brief, Group, Look, Room};
use crate::draft::{Draft, DraftRoom, Opening, OpeningKind, ThingOrigin};
use crate::furnish::kinds::{self, FurnishingKind};
use crate::furnish::stand::{counts_as, group};
use crate::names::GivenNames;
pub use annex::is_outside;
use cost::{bounds, ways};
use rows::{Cell, Rect};

/// More rooms than these are placed one by one.
const MOST: usize = 14;
/// A living room in which one eats, too, is so much larger (square metres).
const EATING: f64 = 4.0;
/// A kitchen of a home has a wall so long (metres): a stove, a sink, a counter and a fridge stand at it.
const RUN: f64 = 4.0;
/// Beyond the foot of a bed for two, and beside it with its nightstands, so much is free or a wall of cupboards (metres).
const FOOT: f64 = 1.5;
/// Before a desk, and beside it, for who works there (metres).
const USE: f64 = 1.0;
const BESIDE: f64 = 2.2;
/// How large toilets are next to another room (square metres, and at most).
const TOILETS: [f64; 2] = [6.0, 9.0];
/// A bed for two is at least so wide (metres).
const FOR_TWO: f64 = 1.35;
/// The doors that are added (metres), and why.
const DOOR: [f64; 3] = [0.95, 2.08, 0.12];
const WHY: &str = "the rooms must be connected";

/// Places the rooms of a draft, and adds the doors between them that are missing.
pub fn lay_out(draft: &mut Draft, brief: &Brief, names: &mut GivenNames) {
    if !planned(draft, brief, names) {
        chain(draft, names);
        arrange_rooms(draft);
    }
}

/// The room that leads to the others: of the rooms that people pass through, a hall before a living room before others.
pub fn hub(rooms: &[&str]) -> usize {
    let rank = |name: &str| passage(kinds::of(name).map_or("", |kind| kind.name));
    (0..rooms.len()).min_by_key(|room| (rank(rooms[*room]), *room)).unwrap_or(0)
}

/// How well a kind of room leads to others; more: worse.
fn passage(kind: &str) -> usize {
    const BEST: [&[&str]; 6] = [
        &["hallway"],
        &["reception", "shopping mall", "waiting room"],
        &["living room", "apartment"],
        &[
            "open-plan office",
            "office",
            "shop",
            "restaurant",
            "cafe",
            "library",
            "warehouse",
            "factory hall",
            "gallery",
        ],
        &["dining room"],
        &["kitchen", "kitchen diner", "corner kitchen", "bay kitchen", "galley kitchen", "break room", "conservatory"],
    ];
    BEST.iter().position(|kinds| kinds.contains(&kind)).unwrap_or(BEST.len())
}

/// Rooms of a home that have a kitchen run.
pub const KITCHENS: [&str; 5] = ["kitchen", "kitchen diner", "corner kitchen", "bay kitchen", "galley kitchen"];

/// Whether people pass through such rooms.
pub fn is_passage(room: &str) -> bool {
    kinds::of(room).is_some_and(|kind| passage(kind.name) < 6)
}

/// The doors between two rooms.
fn links(draft: &Draft) -> Vec<(usize, usize)> {
    let inner = draft.openings.iter().filter(|o| o.kind == OpeningKind::Door);
    inner
        .filter_map(|o| match o.rooms[..] {
            [a, b] if a != b => Some((a, b)),
            _ => None,
        })
        .collect()
}

/// Whether doors join all rooms already.
fn joined(count: usize, links: &[(usize, usize)]) -> bool {
    let mut with = vec![false; count];
    with[0] = true;
    for _ in 0..count {
        for (a, b) in links {
            let any = with[*a] || with[*b];
            (with[*a], with[*b]) = (any, any);
        }
    }
    with.iter().all(|with| *with)
}

fn planned(draft: &mut Draft, brief: &Brief, names: &mut GivenNames) -> bool {
    let count = draft.rooms.len();
    if !(2..=MOST).contains(&count) || draft.rooms.iter().any(|room| room.outline.is_some()) {
        return false;
    }
    let links = links(draft);
    let said = |room: &Room| room.size[0].is_some() || room.size[2].is_some() || room.area.is_some();
    if links.iter().any(|(a, b)| *a >= count || *b >= count) || joined(count, &links) && brief.rooms.iter().any(said) {
        return false;
    }
    let rooms: Vec<&str> = brief.rooms.iter().map(|room| room.name.as_str()).collect();
    let hub = hub(&rooms);
    let Some((rects, doors)) = plan(draft, brief, hub, &links) else { return false };
    let [low, size] = bounds(&rects);
    let height = draft.rooms.iter().map(|room| room.size[1]).fold(0.0, f64::max);
    for (at, rect) in rects.iter().enumerate() {
        let room = &mut draft.rooms[at];
        room.at = [0, 1].map(|k| rounded(rect.low[k] + rect.size[k] / 2.0 - low[k] - size[k] / 2.0));
        (room.size[0], room.size[2]) = (rect.size[0], rect.size[1]);
        if brief.rooms[at].size[1].is_none() {
            room.size[1] = height;
        }
    }
    for (from, to) in doors {
        add_door(draft, names, from, to);
    }
    true
}

/// Where rooms are, and the doors that are added between two of them.
type Plan = (Vec<Rect>, Vec<(usize, usize)>);

/// Where the rooms are, and the doors that are added: those under the roof first, then balconies outside.
fn plan(draft: &Draft, brief: &Brief, hub: usize, links: &[(usize, usize)]) -> Option<Plan> {
    let outside = |room: usize| room != hub && is_outside(&brief.rooms[room].name);
    let inner: Vec<usize> = (0..draft.rooms.len()).filter(|room| !outside(*room)).collect();
    let at = |room: usize| inner.iter().position(|other| *other == room);
    let within: Vec<(usize, usize)> = links.iter().filter_map(|(a, b)| Some((at(*a)?, at(*b)?))).collect();
    let of_all = cells(draft, brief, hub, links);
    let cells: Vec<Cell> =
        inner.iter().map(|room| Cell { own: of_all[*room].own.and_then(at), ..of_all[*room].clone() }).collect();
    let middle = at(hub)?;
    let (found, mut doors) = match &inner[..] {
        [only] => {
            (vec![Rect { low: [0.0; 2], size: [draft.rooms[*only].size[0], draft.rooms[*only].size[2]] }], Vec::new())
        }
        _ => {
            let found = search::search(&cells, middle, &within)?.rects;
            let ways = ways(&cells, &found, middle, &within);
            if ways.unmet + ways.unreached > 0 {
                return None;
            }
            (found, ways.doors.iter().map(|(from, to)| (inner[*from], inner[*to])).collect())
        }
    };
    let mut rects = vec![Rect::default(); draft.rooms.len()];
    inner.iter().zip(&found).for_each(|(room, rect)| rects[*room] = *rect);
    let mut placed = inner.clone();
    for room in (0..draft.rooms.len()).filter(|room| outside(*room)) {
        let said = links.iter().find_map(|(a, b)| match room {
            _ if *a == room => Some(*b),
            _ if *b == room => Some(*a),
            _ => None,
        });
        let [w, _, d] = draft.rooms[room].size;
        let known: Vec<Rect> = placed.iter().map(|other| rects[*other]).collect();
        let from =
            |of: usize| annex::beside(&known, placed.iter().position(|other| *other == of)?, [w.max(d), w.min(d)]);
        let (of, rect) = leading(brief, &inner, said).into_iter().find_map(|of| Some((of, from(of)?)))?;
        if said.is_none() {
            doors.push((of, room));
        }
        rects[room] = rect;
        placed.push(room);
    }
    Some((rects, doors))
}

/// The rooms that may lead to a balcony, the best first: the one that is said to, or else where people sit, eat and sleep.
fn leading(brief: &Brief, inner: &[usize], said: Option<usize>) -> Vec<usize> {
    const SITS: [&str; 8] = [
        "living room",
        "studio apartment",
        "dining room",
        "bedroom",
        "kitchen diner",
        "kitchen",
        "corner kitchen",
        "bay kitchen",
    ];
    if let Some(said) = said {
        return vec![said];
    }
    let rank = |room: &usize| {
        let kind = kinds::of(&brief.rooms[*room].name).map_or("", |kind| kind.name);
        SITS.iter().position(|name| *name == kind).unwrap_or(SITS.len())
    };
    let mut rooms = inner.to_vec();
    rooms.sort_by_key(|room| (rank(room), *room));
    rooms
}

fn rounded(metres: f64) -> f64 {
    (metres * 1e4).round() / 1e4
}

fn add_door(draft: &mut Draft, names: &mut GivenNames, from: usize, to: usize) {
    let ceiling = draft.rooms[from].size[1].min(draft.rooms[to].size[1]);
    draft.openings.push(Opening {
        name: names.take("door"),
        kind: OpeningKind::Door,
        category: None,
        rooms: vec![from, to],
        size: [DOOR[0], DOOR[1].min(ceiling - 0.1), DOOR[2]],
        look: Look::default(),
        source: ThingOrigin::Inferred(WHY.into()),
    });
}

/// Rooms that no door joins to another get one to the room before them.
fn chain(draft: &mut Draft, names: &mut GivenNames) {
    for room in 1..draft.rooms.len() {
        if !links(draft).iter().any(|(a, b)| *a == room || *b == room) {
            add_door(draft, names, room - 1, room);
        }
    }
}

/// What the plan has to know of the rooms.
fn cells(draft: &Draft, brief: &Brief, hub: usize, links: &[(usize, usize)]) -> Vec<Cell> {
    let kind = |room: usize| kinds::of(&brief.rooms[room].name);
    let home = (0..brief.rooms.len()).all(|room| kind(room).is_some_and(|kind| kind.home.is_some()));
    let is = |room: usize, names: &[&str]| kind(room).is_some_and(|kind| names.contains(&kind.name));
    let mut out = Vec::new();
    for room in 0..draft.rooms.len() {
        let [w, _, d] = draft.rooms[room].size;
        let asked = &brief.rooms[room];
        let given = asked.size[0].is_some() || asked.size[2].is_some() || asked.area.is_some();
        let (area, side) = match kind(room).and_then(|kind| Some((kind, kind.home?))) {
            Some((kind, usual)) if home => at_home(draft, asked, room, (kind, usual)),
            // Next to a café the toilets are small.
            _ if is(room, &["public toilets"]) && room != hub => (TOILETS, 2.0),
            // Beds of a ward stand side by side along its width.
            _ if kind(room).is_some_and(|kind| kind.bay.is_some()) => ([w * d, 1.1 * w * d], w),
            _ => ([w * d, 1.25 * w * d], 0.75 * w.min(d)),
        };
        let beds = draft.things.iter().filter(|thing| thing.room == Some(room) && group(&thing.category) == Group::Bed);
        let mut wide: Vec<[f64; 3]> = beds.filter_map(|bed| bed.size).filter(|size| size[0] >= FOR_TWO).collect();
        // A bedroom from which other rooms are reached needs a wall for its bed beside their doors.
        let doors = links.iter().filter(|(a, b)| *a == room || *b == room).count();
        let sleeps = kind(room).and_then(|kind| kind.lines.first()).filter(|line| line.noun == "bed");
        if let Some(bed) = sleeps.filter(|_| wide.is_empty() && doors + usize::from(room == hub) > 1) {
            wide.extend(scenelang_lang::nouns::noun(bed.noun).map(|noun| noun.size));
        }
        let (area, side) = wide.into_iter().fold((area, side), |([area, most], side), [w, _, d]| {
            let side = side.max(d + FOOT);
            let area = area.max(side * (w + BESIDE));
            ([area, most.max(1.15 * area)], side)
        });
        let wet = is(room, &KITCHENS) || is(room, &["bathroom", "public toilets", "laundry room"]);
        let widest = draft.things.iter().filter(|thing| thing.room == Some(room));
        let widest = widest.filter_map(|thing| thing.size).map(|size| size[0].max(size[2])).fold(0.0, f64::max);
        let kitchen = is(room, &KITCHENS);
        let long = if kitchen && home { RUN } else { side };
        let mut with = links.iter().filter(|(a, b)| *a == room || *b == room);
        let own = match (with.next(), with.next()) {
            (Some((a, b)), None) if wet || is(room, &["walk-in closet"]) => Some(if *a == room { *b } else { *a }),
            _ => None,
        };
        out.push(Cell {
            area,
            sides: [side, long.max(widest + 0.3)],
            fixed: given.then_some([w, d]),
            private: !is_passage(&asked.name) && room != hub,
            wet,
            hall: is(room, &["hallway"]),
            kitchen,
            shared: is(room, &["living room", "dining room"]),
            garage: is(room, &["garage"]),
            own: own.filter(|own| *own != hub && !is_passage(&brief.rooms[*own].name)),
        });
    }
    out
}

/// How large a room is in a home (square metres, and at most), and its shorter side: as its kind says, more where more is
/// asked for.
fn at_home(
    draft: &Draft,
    asked: &Room,
    room: usize,
    (kind, [area, most, side]): (&FurnishingKind, [f64; 3]),
) -> ([f64; 2], f64) {
    let floor = |[w, _, d]: [f64; 3]| w * d;
    let usual = asked.usual.map_or(floor(kind.size), floor);
    let said = usual / floor(kind.size);
    let is = floor(draft.rooms[room].size);
    // What stands in it by request needs more than such rooms have.
    let needed = if is > 1.1 * usual { 0.75 * is } else { 0.0 };
    // A desk that such a room does not have needs its floor, and that of who uses it.
    let own = |noun: &str| kind.lines.iter().chain(&kind.eat).any(|line| counts_as(line.noun, noun));
    let more = draft.things.iter().filter(|thing| thing.room == Some(room) && thing.count == 1);
    let more = more.filter(|thing| matches!(group(&thing.category), Group::Table | Group::Storage));
    let more =
        more.filter(|thing| matches!(thing.source, ThingOrigin::Stated(_)) && !own(&thing.category.replace('_', " ")));
    let more: f64 = more.filter_map(|thing| thing.size).map(|[w, _, d]| w * (d + USE)).sum();
    let dines = |room: &DraftRoom| kinds::of(&room.kind).is_some_and(FurnishingKind::is_eaten_in);
    let eats = !kind.eat.is_empty() && !draft.rooms.iter().any(dines);
    let more = more + if eats { EATING } else { 0.0 };
    let area = (area * said).max(needed) + more;
    ([area, (most * said).max(area * 1.15)], side * said.clamp(0.85, 1.3).sqrt())
}
