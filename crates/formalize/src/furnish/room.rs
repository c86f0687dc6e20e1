//! One room, from the way in to the light: openings, floor and walls, what is asked for with what goes with it, then the
//! inventory of its kind as far as there is room.

use super::build::Root;
use super::choose::{self, Choice, Staff};
use super::daylight::{add_windows, keep_windows_free, way_in, window_walls};
use super::floor::{Block, Floor, Pose, Shape};
use super::kinds::{self, Count, Line, Place};
use super::openings;
use super::plan::{AtWall, Plan, for_people, metres};
use super::rows::{ceiling, rows};
use super::seek::Wall;
use super::{asked, edge, even, gates, groups, place, slots, stand, taste, tops};
use crate::brief::{Brief, Group, MOST_GUIDED};
use crate::draft::{Draft, Source, Thing};
use std::cell::RefCell;

/// So many desks are those of a team.
pub(super) const TEAM: usize = 3;
/// How high things on walls are looked at.
const EYES: f64 = 1.5;

/// Before a counter so much is free (metres).
const SERVED: f64 = 1.15;
/// A counter before the wall at the back takes this part of the room's width, in rooms that are wider than usual.
const COUNTER: f64 = 0.26;
/// What is narrower is a stand, and no counter.
const STAND: f64 = 1.0;
/// Things on walls are so far from each other and from what is tall beside them, if there is room, else so far.
const APART: [f64; 2] = [0.3, 0.12];

/// In a run things are so far apart at least, where there is a choice.
const TIGHT: f64 = 0.15;

/// Lengths of what may be shorter than usual rather than lack its sink, its stove or its seats (metres).
const SHORTER: [(&str, &[f64]); 4] = [
    ("kitchen counter", &[1.8, 1.2, 0.8]),
    ("kitchenette", &[1.4, 1.2]),
    ("dining table", &[1.2, 0.9]),
    ("kitchen table", &[0.9]),
];
/// So much of the floor a place to eat takes (square metres).
const EATING: f64 = 8.0;
/// Where many books are asked for there are so many bookcases.
const BOOKCASES: usize = 3;
/// So many lines of an inventory matter: a room without them is not what it is called.
const MATTER: usize = 4;
/// What came of furnishing a room.
#[derive(Clone, Copy, Debug, Default)]
pub struct Furnished {
    /// How much that matters found no room.
    pub lacking: usize,
    /// The part of the floor that nothing is near and nobody needs.
    pub idle: f64,
    /// How many things there is no way to.
    pub unreached: usize,
}

impl Furnished {
    /// What a larger room may mend.
    pub fn wants(&self) -> (usize, usize) {
        (self.lacking, self.unreached)
    }
}

/// Furnishes a room of its size with as much as one of `counted` square metres has.
pub fn furnish_once(draft: &mut Draft, brief: &Brief, at: usize, closed: &[String], counted: f64) -> Furnished {
    let kind = kinds::of(&draft.rooms[at].kind).or_else(|| kinds::of("room"));
    let Some(kind) = kind else { return Furnished::default() };
    let doors_ruled_out = brief.absent.iter().any(|(name, _)| name.contains("door"));
    if !draft.outdoor && !doors_ruled_out {
        way_in(draft, at);
        gates::doors(draft, at, kind);
    }
    let rectangular = draft.rooms[at].outline.is_none();
    if rectangular && !draft.outdoor {
        openings::doors(draft, at);
    }
    let is_asked = |t: &Thing| matches!(t.source, Source::Stated(_)) || for_people(&t.source) && tables(&t.category);
    let own = |t: &Thing| t.room == Some(at) && is_asked(t);
    let mut asked: Vec<usize> = (0..draft.things.len()).filter(|i| own(&draft.things[*i])).collect();
    // What seats go with comes before them.
    asked.sort_by_key(|i| {
        let category = &draft.things[*i].category;
        stand::group(category) == Group::Seat && !stand::has_back(category)
    });
    let windows = brief.things.iter().any(|t| t.room == at && t.group == Group::Window)
        || closed.iter().any(|name| name.contains("window"))
        || draft.outdoor;
    let room = &mut draft.rooms[at];
    taste::surfaces(kind, &mut room.floor, &mut room.walls);
    for thing in &asked {
        let it = &mut draft.things[*thing];
        taste::dressed(kind, &it.category, &mut it.look);
    }
    let mut plan = Plan::new(draft, at, kind, closed.to_vec(), brief.rooms[at].people);
    (plan.only, plan.counted) = (brief.rooms[at].only, counted);
    if !windows {
        add_windows(&mut plan);
    }
    if rectangular {
        plan.ground = Some(openings::floor(plan.draft, at));
        if !windows {
            gates::curtains(&mut plan);
        }
    }
    asked::rounded(&mut plan, brief);
    asked::lengthened(&mut plan, brief);
    // A plan tries many places for each thing and looks for the ways that are left: a crowd is for the search alone.
    let crowd = plan.draft.things.iter().map(|thing| thing.count).sum::<usize>() > MOST_GUIDED;
    // What goes with something else waits for that, and what stands on things for all of them.
    let (small, asked): (Vec<usize>, Vec<usize>) = asked.into_iter().partition(|at| tops::waits(&plan, *at));
    plan.small = small.clone();
    let (with_asked, asked): (Vec<usize>, Vec<usize>) = asked.into_iter().partition(|at| plan.waits_for_asked(*at));
    let (waiting, asked): (Vec<usize>, Vec<usize>) = asked.into_iter().partition(|at| plan.waits_for_inventory(*at));
    // Many tables leave the place where such rooms have their counter.
    let many = |at: &usize| plan.draft.things[*at].count > 2 && tables(&plan.draft.things[*at].category);
    // What stands at the walls of a kitchen leaves the middle for a table.
    let at_walls = kind.lines.first().is_some_and(|line| matches!(line.place, Place::Wall | Place::Run));
    // The same of the desks of an office, which has one for each.
    let at_desks = kind.lines.first().is_some_and(|line| {
        matches!(line.count, Count::People(_)) && line.noun.ends_with("desk") && plan.people.is_some_and(|n| n >= TEAM)
    });
    let later =
        |at: &usize| (at_walls || at_desks) && has_seats(&plan, &plan.draft.things[*at].category.replace('_', " "));
    let (tables_later, asked): (Vec<usize>, Vec<usize>) = asked.into_iter().partition(later);
    let is_early = |line: &Line| matches!(line.place, Place::Before(_, 180.0) | Place::Service(_));
    let early: Vec<&Line> = kind.lines.iter().take(MATTER).filter(|line| is_early(line)).collect();
    let early = if asked.iter().any(many) { early } else { Vec::new() };
    for line in &early {
        matter(&mut plan, line, true);
    }
    let (with_first, with_later) =
        if tables_later.is_empty() { (with_asked, Vec::new()) } else { (Vec::new(), with_asked) };
    for thing in asked.iter().chain(&with_first).filter(|_| !crowd) {
        asked::stand_up(&mut plan, *thing);
    }
    let eats = |room: &crate::draft::Room| kinds::of(&room.kind).is_some_and(|kind| kind.name == "dining room");
    let home = plan.draft.rooms.len() > 1 && !plan.draft.rooms.iter().any(eats);
    let (first, rest) = kind.lines.split_at(kind.lines.len().min(2));
    let eat = kind.eat.iter().filter(|_| home);
    // Where one eats in the room, too, its armchairs do not come first.
    let all = plan.counted;
    if eat.clone().next().is_some() {
        plan.counted -= EATING;
    }
    for (i, line) in first.iter().chain(rest).enumerate() {
        if i == first.len() {
            plan.counted = all;
            for thing in tables_later.iter().chain(&with_later).filter(|_| !crowd) {
                asked::stand_up(&mut plan, *thing);
            }
            eat.clone().for_each(|line| eat_at(&mut plan, line));
        }
        let matters = i < MATTER && is_essential(&plan, line);
        if !early.contains(&line) {
            matter(&mut plan, line, matters);
        }
    }
    for thing in waiting.iter().filter(|_| !crowd) {
        asked::stand_up(&mut plan, *thing);
    }
    for thing in small {
        if !tops::carry(&mut plan, thing) && !crowd {
            asked::stand_up(&mut plan, thing);
        }
    }
    tops::settle(&mut plan);
    plan.lacking += seats_apart(&plan, &waiting);
    let idle = plan.ground.as_ref().map_or(0.0, Floor::idle);
    let unreached = plan.ground.as_ref().map_or(0, Floor::unreached);
    let furnished = Furnished { lacking: plan.lacking, idle, unreached };
    keep_windows_free(plan.draft, at);
    furnished
}

/// Whether such a room is not complete without a line of its inventory.
fn is_essential(plan: &Plan, line: &Line) -> bool {
    let stands = !matches!(line.place, Place::Hung | Place::Ceiling | Place::Corner);
    let few = match line.count {
        Count::Fixed(n) => n <= 3,
        // A bed and a desk for each of two or three.
        Count::People(each) => {
            plan.people.map_or(plan.kind.people, |n| n as f64) / each <= 3.0 || plan.tables(line).is_some()
        }
        Count::Area(_) => false,
    };
    // A shop with a shelf less is a shop; who has no seat is missing.
    let seats = matches!(line.place, Place::Floor) && matches!(line.count, Count::People(_));
    let few = few || seats || matches!(line.place, Place::Rows(_)) && !matches!(line.count, Count::Area(_));
    stands && few && line.least == 0.0 && !plan.is_furnished()
}

/// How many kinds of seats have no place at the table that they belong to: they want a larger room.
fn seats_apart(plan: &Plan, waiting: &[usize]) -> usize {
    let apart = |at: &usize| {
        let thing = &plan.draft.things[*at];
        let belongs = for_people(&thing.source) || waiting.contains(at);
        let is_seat = stand::group(&thing.category) == Group::Seat;
        thing.room == Some(plan.room) && is_seat && belongs && !plan.claimed.contains(at)
    };
    (0..plan.draft.things.len()).filter(apart).count()
}

/// Whether things of a category are tables.
fn tables(category: &str) -> bool {
    stand::group(category) == Group::Table
}

/// Adds a line of the inventory, and notes where it matters and finds no room.
fn matter(plan: &mut Plan, line: &Line, matters: bool) {
    plan.matters = matters;
    let (things, closed) = (plan.draft.things.len(), plan.is_closed(line.noun));
    inventory(plan, line);
    let is_there = closed || came_along(plan, line);
    plan.lacking += usize::from(matters && !is_there && plan.draft.things.len() == things);
}

/// Adds what one eats at, if there is room for its seats, too.
fn eat_at(plan: &mut Plan, line: &Line) {
    let draft = plan.draft.clone();
    let before = (plan.ground.clone(), plan.floor, plan.walls, plan.turn);
    inventory(plan, line);
    let new = &plan.draft.things[draft.things.len()..];
    if !new.iter().any(|thing| stand::group(&thing.category) == Group::Seat) {
        *plan.draft = draft;
        (plan.ground, plan.floor, plan.walls, plan.turn) = before;
    }
}

/// The part of a room in which someone works behind a counter; `None`: nobody does.
pub(super) fn staffed(plan: &Plan) -> Option<Staff> {
    /// Beside a desk that visitors come to so much is for who works there, and as much more behind the chair (metres).
    const BESIDE: f64 = 0.9;
    const BEHIND: f64 = 0.3;
    let [_, height, depth] = plan.draft.rooms[plan.room].size;
    plan.kind.lines.iter().find_map(|line| match line.place {
        Place::Before(gap, 180.0) => {
            let usual = depth / 2.0 - gap - Plan::size(line.noun)[2];
            let at = near_to(plan, line.noun);
            Some(Staff::Beyond(at.map_or(usual, |at| at.z - Plan::size(line.noun)[2] / 2.0)))
        }
        Place::Service(gap) if Plan::size(line.noun)[0] >= STAND => {
            let at = near_to(plan, line.noun)?;
            let [wide, _, deep] = Plan::size(line.noun);
            let behind = Pose { z: -(gap + BEHIND) / 2.0, ..Pose::default() };
            let size = [wide + 2.0 * BESIDE, height, deep + gap + BEHIND];
            Some(Staff::Around(Block::of(&at.then(&behind), size)))
        }
        _ => None,
    })
}

/// The place of what someone sits or lies on who looks at something.
fn watched_from(plan: &Plan) -> Option<Pose> {
    let seat = plan.draft.things.iter().filter(|t| t.room == Some(plan.room));
    let mut seat = seat.filter(|t| choose::seats(&t.category.replace('_', " ")));
    let seat = seat.next()?;
    if seat.count == 1 {
        return plan.place_in_room(&seat.name);
    }
    // From the middle of several that look the same way.
    let places: Vec<Pose> =
        (0..seat.count).filter_map(|i| plan.place_in_room(&format!("{}[{i}]", seat.name))).collect();
    let first = *places.first().filter(|first| places.iter().all(|p| p.yaw == first.yaw))?;
    let mean = |of: fn(&Pose) -> f64| places.iter().map(of).sum::<f64>() / places.len() as f64;
    Some(Pose { x: mean(|p| p.x), z: mean(|p| p.z), ..first })
}

/// Where the beds of the room are.
fn beds(plan: &Plan) -> Vec<Pose> {
    let beds =
        plan.draft.things.iter().filter(|t| t.room == Some(plan.room) && stand::group(&t.category) == Group::Bed);
    let names =
        beds.flat_map(|t| (0..t.count).map(|i| if t.count > 1 { format!("{}[{i}]", t.name) } else { t.name.clone() }));
    names.filter_map(|name| plan.place_in_room(&name)).collect()
}

/// The next place of several beds, or of what stands in a run, side by side; `row` keeps all of them.
pub(super) fn in_row(
    choice: &Choice,
    floor: &Floor,
    shape: &Shape,
    before: &[Pose],
    (n, in_run): (usize, bool),
    row: &RefCell<Vec<Pose>>,
) -> Option<Pose> {
    if n < 2 || !(in_run || choice.noun.ends_with("bed")) {
        return None;
    }
    if before.is_empty() {
        row.replace(
            even::places(floor, shape, n, (choice.size[2], stand::is_unit(choice.noun)), choice.windows)
                .unwrap_or_default(),
        );
    }
    row.borrow().get(before.len()).copied()
}

/// The next place of several that stand free, spread over the floor if there is room for all; `row` keeps all of them.
pub(super) fn free(
    choice: &Choice,
    floor: &Floor,
    shape: &Shape,
    before: &[Pose],
    (n, yaws): (usize, &[f64]),
    row: &RefCell<Vec<Pose>>,
) -> Option<Pose> {
    if before.is_empty() {
        row.replace(choice.spread(floor, shape, n, yaws).unwrap_or_default());
    }
    // Several are parallel to each other.
    let first = before.first().map(|first| [first.yaw]);
    let next = row.borrow().get(before.len()).copied();
    next.or_else(|| choice.floor(floor, shape, before, first.as_ref().map_or(yaws, |yaw| &yaw[..])))
}

/// Where the wide door of the room is, if it has one.
pub(super) fn gate(plan: &Plan) -> Option<Pose> {
    let door = plan.draft.openings.iter().find(|o| o.category.as_deref() == Some(gates::GATE))?;
    plan.place_in_room(&door.name)
}

/// What is kept free around a thing of the inventory, in its frame: behind a counter for who works there, before it for who
/// is served, beside it for the way there; beside what hangs.
pub(super) fn kept(line: &Line, size: [f64; 3], hung: bool, beside: f64) -> Vec<(Pose, [f64; 3])> {
    let [w, h, d] = size;
    let at = |x: f64, y: f64, z: f64| Pose { x, y, z, yaw: 0.0 };
    if hung {
        return vec![(at(0.0, -1.4 * beside, 0.0), [w + 2.0 * beside, h + 1.4 * beside, d])];
    }
    if line.noun.ends_with("car") {
        // Its doors open, and one walks round it.
        let (side, end) = (0.6, 0.45);
        let beside = |x: f64| (at(x * (w + side) / 2.0, 0.05, 0.0), [side, 1.0, 0.8 * d]);
        let ends = |z: f64| (at(0.0, 0.05, z * (d + end) / 2.0), [w, 1.0, end]);
        return vec![beside(-1.0), beside(1.0), ends(-1.0), ends(1.0)];
    }
    let behind = match line.place {
        Place::Service(gap) => gap - 0.02,
        Place::Before(gap, 180.0) => gap - 0.5,
        _ => return Vec::new(),
    };
    let pass = 0.7;
    if w < STAND {
        // One person stands behind it, and the others before it.
        return vec![
            (at(0.0, 0.05, (d + pass) / 2.0), [w + pass, 1.7, pass]),
            (at(0.0, 0.05, -(d + pass) / 2.0), [w + pass, 1.7, pass]),
        ];
    }
    vec![
        (at(0.0, 0.05, (d + SERVED) / 2.0), [w, 1.7, SERVED]),
        (at(pass / 2.0, 0.05, -(d + behind) / 2.0), [w + pass, 1.7, behind]),
        (at((w + pass) / 2.0, 0.05, 0.0), [pass, 1.7, d]),
    ]
}

/// At both ends of a run whose elements stand apart as much is kept free as between them.
fn ends([w, h, d]: [f64; 3], gap: f64, n: usize) -> Vec<(Pose, [f64; 3])> {
    let beside = |x: f64| (Pose { x, y: 0.05, ..Pose::default() }, [gap, h, d]);
    let last = (n - 1) as f64 * (w + gap);
    if gap > 0.1 { vec![beside(-(w + gap) / 2.0), beside(last + (w + gap) / 2.0)] } else { Vec::new() }
}

/// Whether the one thing of a line, which stands on the floor, is there already with another: a bin beside the desk.
fn came_along(plan: &Plan, line: &Line) -> bool {
    let listed = format!("a {} has ", plan.kind.name);
    let with_another = |t: &Thing| match &t.source {
        Source::Inferred(why) => !why.starts_with(&listed),
        _ => false,
    };
    let hung = line.place == Place::Hung || line.place == Place::Ceiling;
    let mut here = plan.draft.things.iter().filter(|t| t.room == Some(plan.room));
    line.count == Count::Fixed(1) && !hung && here.any(|t| t.category.replace('_', " ") == line.noun && with_another(t))
}

/// Whether people sit around such a thing.
fn has_seats(plan: &Plan, noun: &str) -> bool {
    let around = |part: &groups::Part| matches!(part.at, groups::Where::Around(..) | groups::Where::LongSides(..));
    stand::group(noun) == Group::Table && groups::of(noun, plan.kind.dress).iter().any(around)
}

/// Whether several tables for people are asked for: their number is what the request says, whatever they are called.
fn several_tables(plan: &Plan) -> bool {
    let mut asked = plan.draft.things.iter().filter(|t| t.room == Some(plan.room) && t.count > 1);
    asked.any(|t| matches!(t.source, Source::Stated(_)) && has_seats(plan, &t.category.replace('_', " ")))
}

/// Adds a line of the inventory.
fn inventory(plan: &mut Plan, line: &Line) {
    // A room with only what is asked for has light all the same.
    let closed = if line.place == Place::Ceiling { plan.is_said(line.noun) } else { plan.is_closed(line.noun) };
    let seated = has_seats(plan, line.noun) && several_tables(plan);
    if plan.counted < line.least || closed || seated || plan.is_furnished() || came_along(plan, line) {
        return;
    }
    // No one screen is seen from beds at opposite walls.
    let several_ways = |beds: &[Pose]| beds.iter().any(|bed| bed.yaw != beds[0].yaw);
    if line.noun == "tv" && several_ways(&beds(plan)) {
        return;
    }
    let people = plan.people.map_or(usual_people(plan), |n| n as f64);
    let n = match line.count {
        Count::Fixed(n) if line.noun == "bookshelf" && has_books(plan) => n.max(BOOKCASES),
        Count::Fixed(n) => n,
        Count::Area(each) => (plan.counted / each).round() as usize,
        Count::People(each) => plan.tables(line).unwrap_or((people / each).ceil() as usize),
    };
    let why = format!("a {} has {}", plan.kind.name, if n == 1 { "one" } else { "some" });
    match &line.place {
        Place::Ceiling => ceiling(plan, line.noun, n.max(1), &why),
        Place::Edge => edge::railing(plan, line, &why),
        Place::Rows(toward) => {
            rows(plan, line.noun, n, *toward, (&why, None));
        }
        // The desks of a team stand in groups, not one by one.
        Place::Floor if n >= TEAM && line.noun.ends_with("desk") => {
            rows(plan, line.noun, n, false, (&why, None));
        }
        _ => single(plan, line, n, &why),
    }
}

/// Whether books are asked for, of which nobody says how many: "lots of books".
fn has_books(plan: &Plan) -> bool {
    let mut here = plan.draft.things.iter().filter(|t| t.room == Some(plan.room));
    here.any(|t| t.count > 1 && t.category == "book" && matches!(t.source, Source::Stated(_)))
}

/// For how many people a room is of which nobody says it: fewer in a small one, more in a large one.
fn usual_people(plan: &Plan) -> f64 {
    let [w, _, d] = plan.kind.size;
    let is_free = plan.draft.rooms.len() == 1 && !plan.draft.rooms[plan.room].sized;
    let share = if is_free { (plan.counted / (w * d)).clamp(0.5, 1.5) } else { 1.0 };
    (plan.kind.people * share).round().max(1.0)
}

/// How long a counter before the wall at the back is at least, in metres; 0 for anything else.
pub(super) fn counter_length(plan: &Plan, line: &Line) -> f64 {
    let is_counter = matches!(line.place, Place::Before(_, 180.0)) && line.noun.ends_with("counter");
    let length = COUNTER * plan.draft.rooms[plan.room].size[0];
    if is_counter { (length * 10.0).round() / 10.0 } else { 0.0 }
}

/// The size of a thing; a table is as long as the people need who sit at it.
fn size_for_people(plan: &Plan, noun: &str, n: usize) -> [f64; 3] {
    let mut size = Plan::size(noun);
    let seats = groups::of(noun, plan.kind.dress).iter().find(|part| matches!(part.at, groups::Where::Around(..)));
    if let (Some(people), Some(part), 1) = (plan.people, seats, n) {
        let [w, _, d] = plan.draft.rooms[plan.room].size;
        let each_side = people.saturating_sub(2).div_ceil(2) as f64;
        let needed = each_side * (Plan::size(part.noun)[0] + 0.12) + 0.1;
        size[0] = size[0].max(needed.min(w.max(d) - 2.0));
    }
    // A bar is as long as the stools need that are asked for and stand at it.
    let row = groups::of(noun, plan.kind.dress).iter().find(|part| matches!(part.at, groups::Where::Row(..)));
    if let (Some(part), 1) = (row, n) {
        let stools = plan.draft.things.iter().filter(|t| t.room == Some(plan.room));
        let stools = stools.filter(|t| matches!(t.source, Source::Stated(_)) && !stand::placed(plan.draft, &t.name));
        let stools = stools.filter(|t| stand::counts_as(part.noun, &t.category.replace('_', " ")));
        let needed = stools.map(|t| slots::row(t.count, t.size.map_or(0.4, |own| own[0]))).fold(0.0, f64::max);
        let [w, _, d] = plan.draft.rooms[plan.room].size;
        size[0] = size[0].max((needed.min(w.max(d) - 2.0) * 100.0).ceil() / 100.0);
    }
    size
}

/// Things at walls, in corners, in the middle.
fn single(plan: &mut Plan, line: &Line, n: usize, why: &str) {
    let mut size = size_for_people(plan, line.noun, n);
    size[0] = size[0].max(counter_length(plan, line));
    // A worktop is as long as what stands beside it leaves room for, a table as its chairs do.
    let shorter = SHORTER.iter().filter(|(noun, _)| *noun == line.noun).flat_map(|(_, widths)| *widths);
    let known = plan.ground.is_some();
    for width in shorter.filter(|_| known) {
        if single_of(plan, line, n, why, size, true) {
            return;
        }
        size[0] = *width;
    }
    // A table that nobody can sit at is left out, unless the room is nothing without it.
    let whole = known && !plan.matters && has_seats(plan, line.noun);
    single_of(plan, line, n, why, size, whole);
}

/// The name of the thing that a line's thing looks at from across the room.
fn opposite_of(plan: &Plan, line: &Line) -> Option<String> {
    let Place::Opposite(other) = &line.place else { return None };
    let mut here = plan.draft.things.iter().filter(|t| t.room == Some(plan.room) && t.count == 1);
    here.find(|t| t.category.replace('_', " ").ends_with(other.as_str())).map(|t| t.name.clone())
}

/// The same of a size. Whether it has a place, with `whole` together with all that it is not complete without.
fn single_of(plan: &mut Plan, line: &Line, n: usize, why: &str, size: [f64; 3], whole: bool) -> bool {
    let hung = line.place == Place::Hung || matches!(stand::group(line.noun), Group::Wall | Group::Screen);
    let at_wall = !matches!(line.place, Place::Middle | Place::Floor | Place::Before(..) | Place::Service(_));
    // Where places are known, they say better what there is room for.
    let room_for = |n: &usize| hung || plan.matters && plan.ground.is_some() || plan.has_room(size, *n, at_wall);
    let n = (0..=n).rev().find(room_for).unwrap_or(0);
    if n == 0 {
        return false;
    }
    let height = plan.draft.rooms[plan.room].size[1];
    let under_ceiling = (height - size[1] - 0.1).max(0.3);
    let y = if hung { (EYES - size[1] / 2.0).max(above_low(plan, line)).clamp(0.3, under_ceiling) } else { 0.0 };
    let opposite = opposite_of(plan, line);
    let opposite_pose = opposite.as_ref().and_then(|name| plan.place_in_room(name));
    let watched = if line.noun.ends_with("tv") { watched_from(plan) } else { opposite_pose };
    let windows = window_walls(plan);
    let beds = if line.noun.ends_with("tv") { beds(plan) } else { Vec::new() };
    let choice = Choice {
        noun: line.noun,
        size,
        windows: &windows,
        looks_at: watched,
        strictly: opposite_pose.is_some(),
        staffed: staffed(plan),
        near: near_to(plan, line.by),
        beds: &beds,
    };
    let nominal = nominal(plan, line, size, y);
    let row = RefCell::new(Vec::new());
    let seek = |floor: &Floor, shape: &Shape, before: &[Pose]| match &line.place {
        _ if hung && matches!(line.place, Place::Hung | Place::Wall) => choice.hung(floor, shape, before, y),
        Place::Wall | Place::Run | Place::Hung => in_row(&choice, floor, shape, before, (n, false), &row)
            .filter(|_| line.place == Place::Wall)
            .or_else(|| choice.wall(floor, shape, before)),
        Place::Service(gap) => choice.service(floor, shape, *gap).or_else(|| choice.service(floor, shape, 0.9)),
        Place::Opposite(_) => choice.wall(floor, shape, before).or_else(|| {
            let anywhere = Choice { strictly: false, ..choice };
            anywhere.wall(floor, shape, before)
        }),
        Place::Corner => choice.corner(floor, shape, before),
        Place::Floor => free(&choice, floor, shape, before, (n, &[0.0, 90.0]), &row),
        Place::Middle if n > 1 => free(&choice, floor, shape, before, (n, &[0.0]), &row),
        _ => near(line, floor, shape, nominal),
    };
    let run = line.place == Place::Run && n > 1;
    let together = |n: usize, gap: f64| -> Vec<Pose> {
        let n = if run { n } else { 1 };
        (0..n).map(|i| Pose { x: i as f64 * (size[0] + gap), ..Pose::default() }).collect()
    };
    let wall = if at_wall && !hung && line.place != Place::Corner { AtWall::Yes } else { AtWall::No };
    let mut add = |plan: &mut Plan, n: usize| {
        if !hung {
            plan.take(size, n, at_wall);
        }
        plan.add(line.noun, n, size, why)
    };
    // A run that is too long is made tighter, and then shorter if nobody asked for the seats at it; what hangs comes nearer
    // to others.
    let mut found = None;
    let asked = plan.ground.is_some() && plan.tables(line).is_some();
    let shortest = if run && !asked { 1 } else { n };
    let tighter = if run && line.gap > TIGHT { vec![line.gap, TIGHT.max(0.4 * line.gap)] } else { vec![line.gap] };
    let tries = (shortest..=n).rev().flat_map(|n| match hung {
        true => APART.map(|apart| (n, line.gap, apart)).to_vec(),
        false => tighter.iter().map(|gap| (n, *gap, 0.0)).collect(),
    });
    let mut gap = line.gap;
    for (less, between, beside) in tries {
        gap = between;
        let frames = together(less, gap);
        let mut free = kept(line, size, hung, beside);
        if run {
            free.extend(ends(size, gap, less));
        }
        let root = Root { n: if run { 1 } else { n }, frames, wall, free, whole, seek: &seek };
        found = plan.place_group(&root, &mut add);
        if found.is_some() {
            break;
        }
    }
    let Some((thing, poses)) = found else { return false };
    // Several tables that stand where there is a gap want a larger room.
    let is_scattered = line.place == Place::Floor && poses.len() > 1 && row.borrow().is_empty();
    plan.lacking += usize::from(plan.matters && is_scattered && has_seats(plan, line.noun));
    if let (Place::Opposite(_), Some(seen), Some(at)) = (&line.place, opposite_pose, poses.first()) {
        // What is not straight across from it wants a room of another size.
        let straight = (seen.yaw - at.yaw).rem_euclid(360.0) == 180.0;
        plan.lacking += usize::from(plan.matters && !straight);
    }
    if let (Some(at), Some(seen)) = (poses.first(), opposite_pose) {
        keep_view(plan, at, &seen);
    }
    let at = Stood { line, thing, poses: &poses, nominal, gap, hung, y, opposite: opposite.zip(opposite_pose) };
    tell(plan, &at, why);
    true
}

/// How high something hangs at least that hangs near something low: both are seen, as a board over the counter.
fn above_low(plan: &Plan, line: &Line) -> f64 {
    const LOW: f64 = 1.3;
    const OVER: f64 = 0.55;
    let mut things = plan.draft.things.iter().filter(|t| t.room == Some(plan.room) && !line.by.is_empty());
    let thing = things.find(|t| t.category.replace('_', " ").ends_with(line.by));
    thing
        .and_then(|t| t.size)
        .map_or(0.0, |[_, h, _]| if h < LOW && !stand::has_back(line.by) { h + OVER } else { 0.0 })
}

/// Nothing more stands between a thing and what it is opposite of.
fn keep_view(plan: &mut Plan, at: &Pose, seen: &Pose) {
    const WIDE: f64 = 0.8;
    let [dx, dz] = [(at.x - seen.x).abs(), (at.z - seen.z).abs()];
    let middle = Pose { x: (at.x + seen.x) / 2.0, y: 0.05, z: (at.z + seen.z) / 2.0, yaw: 0.0 };
    if let Some(ground) = &mut plan.ground {
        ground.keep(&middle, [dx.max(WIDE), 1.2, dz.max(WIDE)]);
    }
}

/// Of places along a line, the nearest to the one that is meant.
pub(super) fn near(line: &Line, floor: &Floor, shape: &Shape, nominal: Pose) -> Option<Pose> {
    let car = line.noun.ends_with("car");
    let far = if car { 0.5 } else { 2.0 };
    // At a wall at the side "along" is to the back and to the front.
    let sideways = nominal.yaw == 90.0 || nominal.yaw == 270.0;
    let sideways = sideways && matches!(line.place, Place::Back(_) | Place::Front(_));
    let off = |i: i32, k: i32| match (0.15 * f64::from(i), 0.15 * f64::from(k)) {
        (along, off) if sideways => Pose { x: nominal.x + off, z: nominal.z + along, ..nominal },
        (along, off) => Pose { x: nominal.x + along, z: nominal.z - off, ..nominal },
    };
    let further = match line.place {
        Place::Before(..) => 0..=6,
        // What came in by a wide door stands in line with it, as deep in the room as it must.
        _ if car => -8..=8,
        _ => 0..=0,
    };
    let steps = further.flat_map(|k| (-30..=30).map(move |i| off(i, k)));
    let [fx, fz] = if sideways { [far, 1.0] } else { [1.0, far] };
    super::seek::best(floor, shape, steps, &|pose| {
        Some(fx * (pose.x - nominal.x).abs() + fz * (pose.z - nominal.z).abs())
    })
}

/// Where a thing of an inventory should stand that has its place in the room.
pub(super) fn nominal(plan: &Plan, line: &Line, size: [f64; 3], y: f64) -> Pose {
    let [width, _, depth] = plan.draft.rooms[plan.room].size;
    let middle_yaw = if (width >= depth) == (size[0] >= size[2]) { 0.0 } else { 90.0 };
    match &line.place {
        // Who sits at the long sides of a table looks at one of its ends.
        Place::Back(0.0) if width > depth && has_table(plan) && stand::group(line.noun) == Group::Screen => {
            let windows = window_walls(plan);
            let wall = if windows.contains(&Wall::Right) { Wall::Left } else { Wall::Right };
            Pose { y, ..wall.place([width, 0.0, depth], 0.0, size[2] / 2.0) }
        }
        Place::Back(share) => Pose { x: share * (width - size[0]) / 2.0, y, z: (depth - size[2]) / 2.0, yaw: 180.0 },
        Place::Front(share) => Pose { x: share * (width - size[0]) / 2.0, y, z: (size[2] - depth) / 2.0, yaw: 0.0 },
        Place::Before(gap, yaw) => Pose { x: 0.0, y: 0.0, z: (depth - size[2]) / 2.0 - gap, yaw: *yaw },
        _ => match gate(plan).filter(|_| line.noun.ends_with("car")) {
            Some(gate) => Pose { x: gate.x, ..Pose::default() },
            None => Pose { yaw: middle_yaw, ..Pose::default() },
        },
    }
}

/// Whether such a room has a table in its middle.
fn has_table(plan: &Plan) -> bool {
    plan.kind.lines.iter().any(|line| line.place == Place::Middle && stand::group(line.noun) == Group::Table)
}

/// The place of the first thing of this name in the room; of several, their middle.
fn near_to(plan: &Plan, noun: &str) -> Option<Pose> {
    let mut things = plan.draft.things.iter().filter(|t| t.room == Some(plan.room) && !noun.is_empty());
    let thing = things.find(|t| t.category.replace('_', " ").ends_with(noun))?;
    let names = (0..thing.count).map(|i| format!("{}[{i}]", thing.name));
    let all: Vec<Pose> = match thing.count {
        1 => plan.place_in_room(&thing.name).into_iter().collect(),
        _ => names.filter_map(|name| plan.place_in_room(&name)).collect(),
    };
    let n = all.len() as f64;
    let middle = |of: fn(&Pose) -> f64| all.iter().map(of).sum::<f64>() / n;
    Some(Pose { x: middle(|p| p.x), z: middle(|p| p.z), ..*all.first()? })
}

/// A line of an inventory that has found its place.
struct Stood<'a> {
    line: &'a Line,
    thing: usize,
    poses: &'a [Pose],
    /// Where it should be.
    nominal: Pose,
    /// Of several in a run: so far apart.
    gap: f64,
    /// Whether it is on a wall, and how high.
    hung: bool,
    y: f64,
    /// What it is opposite of, and where that is.
    opposite: Option<(String, Pose)>,
}

/// Says in the program where things of a line stand.
fn tell(plan: &mut Plan, at: &Stood, why: &str) {
    let Stood { line, thing, poses, nominal, gap, hung, y, opposite } = at;
    let (hung, y) = (*hung, *y);
    let size = plan.draft.things[*thing].size.unwrap_or_default();
    let rectangular = plan.draft.rooms[plan.room].outline.is_none();
    let (name, n) = (plan.draft.things[*thing].name.clone(), plan.draft.things[*thing].count);
    let room = plan.room_name();
    let every = |f: &dyn Fn(&str) -> String| match n {
        1 => format!("assert {};", f(&name)),
        _ => format!("assert forall a in {name}: {};", f("a")),
    };
    let access = stand::access(line.noun).filter(|_| !choose::front_taken(line.noun)).map(metres);
    let used = |x: &str| access.as_ref().map_or(String::new(), |a| format!(" and clear({x}, front, {a})"));
    let at = poses.first().copied().unwrap_or(*nominal);
    let fixed = |at: &Pose| place::absolute(&name, &room, [at.x, at.y, at.z], at.yaw);
    // Against the wall to a millimetre, so that what is on the wall above it touches the wall, too.
    let back = |x: &str| format!("onFloor({x}, {room}) and backToWall({x}, {room}, 0.01)");
    let text = match &line.place {
        _ if hung && matches!(line.place, Place::Hung | Place::Wall) => {
            every(&|x| format!("wallMounted({x}, {room}) and {x}.bottom = {}", metres(y)))
        }
        Place::Wall | Place::Hung => every(&|x| format!("{}{}", back(x), used(x))),
        Place::Run if n == 1 => every(&|x| format!("{}{}", back(x), used(x))),
        Place::Run => {
            let step = metres(size[0] + gap);
            let first = format!("{name}[0]");
            plan.say(format!("assert {}{};", back(&first), used(&first)), why);
            format!(
                "assert forall i in 1..{n}: {name}[i].pos = {name}[0].pos + {name}[0].right * (i * {step}) and {name}[i].rot.y = {name}[0].rot.y;"
            )
        }
        Place::Corner if line.noun == "plant" => every(&|x| format!("onFloor({x}, {room})")),
        Place::Corner => every(&|x| format!("onFloor({x}, {room}) and inCorner({x}, {room})")),
        Place::Middle if n == 1 && rectangular => format!("assert {};", fixed(&at)),
        Place::Middle | Place::Floor => {
            let yaw = metres(at.yaw);
            every(&|x| format!("onFloor({x}, {room}) and gap({x}, {room}) >= 0.6 and {x}.rot.y = {yaw}"))
        }
        Place::Back(_) | Place::Front(_) | Place::Before(..) | Place::Service(_) if n == 1 => {
            format!("assert {};", fixed(&at))
        }
        Place::Before(..) | Place::Service(_) if poses.len() == n => {
            let each = poses
                .iter()
                .enumerate()
                .map(|(i, at)| place::absolute(&format!("{name}[{i}]"), &room, [at.x, at.y, at.z], at.yaw));
            format!("assert {};", each.collect::<Vec<_>>().join(" and "))
        }
        Place::Back(_) | Place::Front(_) | Place::Before(..) | Place::Service(_) => every(&|x| back(x)),
        Place::Opposite(_) => {
            let straight = |seen: &Pose| poses.first().is_none_or(|at| (seen.yaw - at.yaw).rem_euclid(360.0) == 180.0);
            if let Some((to, _)) = opposite.as_ref().filter(|(_, seen)| straight(seen)) {
                plan.say(
                    format!(
                        "prefer angle({name}.front, {to}.front) >= 175 and abs(dot({name}.center - {to}.center, {to}.right)) <= 0.3;"
                    ),
                    why,
                );
            }
            every(&|x| back(x))
        }
        Place::Ceiling | Place::Edge | Place::Rows(_) => return,
    };
    plan.say(text, why);
    if matches!(line.place, Place::Back(_) | Place::Front(_)) && hung {
        plan.say(every(&|x| format!("wallMounted({x}, {room})")), why);
    }
}
