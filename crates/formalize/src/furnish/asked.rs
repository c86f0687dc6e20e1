//! What is asked for: where it stands if the request does not say it, and how large its tables are.

use super::build::Root;
use super::choose::{self, Choice, PULL};
use super::daylight::window_walls;
use super::floor::{Floor, Pose, Shape};
use super::inventory::{TEAM, as_seen, counter_length, has_seats, opposite_of};
use super::kinds::{self, Line, PlanPlace, seats_all};
use super::plan::{AtWall, Plan, metres};
use super::rows::{is_desk, rows};
use super::spots::{free, gate, in_row, is_driven_in, keep_exit, kept, lanes, near, near_to, nominal, watched_from};
use super::{facing, groups, order, place, seek, slots, stacks, stand, twin};
use crate::brief::{Brief, Group};
use crate::draft::{Demand, DraftThing, OpeningKind, Statement, ThingOrigin};
use crate::names::mentions;
use std::cell::{Cell, RefCell};

/// So many counters stand near the door.
const SERVED: usize = 4;
/// Several things with a place of their own are so far apart (metres).
const APART: f64 = 0.8;
/// Seats that stand at a wall if nothing is said of them and such rooms have none.
const ASIDE: [&str; 3] = ["bench", "chair", "visitor chair"];
/// Booths stand side by side.
pub(super) const BOOTH: &str = "booth";
/// What is said to be so stands away from the walls.
const FREE: [&str; 2] = ["freestanding", "free-standing"];
/// What is asked for and finds no place counts like so many that stand badly.
const UNPLACED: usize = 2;
/// Before this an island stands.
const COUNTER: &str = "kitchen counter";
/// The width of a desk for two (metres).
const FOR_TWO: f64 = 1.9;
/// What stands free with its seats is at least so far from others, if the room may be larger (metres).
const CLOSE: f64 = 0.45;
/// What is wheeled stands at a wall, and so does what all look at.
const AT_WALL: [&str; 5] = ["bar cart", "serving cart", "tea trolley", "drinks trolley", "stage"];
/// What stands or leads along a wall.
const PARKED: [&str; 10] = [
    "staircase",
    "stairs",
    "stairway",
    "ladder",
    "bicycle",
    "mountain bike",
    "motorcycle",
    "motorbike",
    "moped",
    "kayak",
];
/// What stands in a corner and is higher is in the way everywhere else (metres).
const TALL: f64 = 1.8;
/// So many of what stands free stand in a row.
const SEVERAL: usize = 3;
/// So many of what nobody uses stand in corners.
const CORNERS: usize = 4;

/// Round tables that are asked for are circles, as large as those need who sit at them.
pub fn rounded(plan: &mut Plan, brief: &Brief) {
    for at in 0..plan.draft.things.len() {
        let thing = &plan.draft.things[at];
        let oval = thing.category.contains("oval") || thing.look.features.iter().any(|f| f == "oval");
        let sized = brief.things.iter().any(|t| t.source == thing.source && t.size.iter().any(Option::is_some));
        if thing.room != Some(plan.room) || oval || sized || !stand::round(&thing.category, &thing.look.features) {
            continue;
        }
        let seats = plan.draft.things.iter().filter(|t| t.room == Some(plan.room));
        let seats = seats.filter(|t| stand::group(&t.category) == Group::Seat);
        let people = plan.people.filter(|_| seats_all(plan.kind, &thing.category.replace('_', " ")));
        let n = seats.map(|t| t.count).max().or(people).unwrap_or(0).div_ceil(thing.count.max(1));
        let usual = Plan::size(&thing.category.replace('_', " "));
        let fits = plan.draft.rooms[plan.room].size;
        let most = fits[0].min(fits[2]) - 1.6;
        let across = slots::diameter(n.min(12), Plan::size("chair")[0]).max(usual[0].min(usual[2])).min(most.max(0.6));
        if let Some(size) = plan.draft.things[at].size.as_mut().filter(|s| s[1] > 0.55) {
            (size[0], size[2]) = (across, across);
        }
    }
}

/// Whether two people work at a desk.
pub(super) fn is_shared(thing: &DraftThing) -> bool {
    let features = &thing.look.features;
    is_desk(&thing.category.replace('_', " "))
        && thing.count == 1
        && features.iter().any(|f| f == "shared" || f == "double")
}

/// Tables that are asked for are as long as the seats need that are asked for and go with them.
pub fn lengthened(plan: &mut Plan, brief: &Brief) {
    for at in 0..plan.draft.things.len() {
        let thing = &plan.draft.things[at];
        let lines = plan.kind.lines.iter();
        let like = lines.filter(|line| stand::counts_as(line.noun, &thing.category.replace('_', " ")));
        let counter = like.map(|line| counter_length(plan, line)).fold(0.0, f64::max);
        let sized = brief.things.iter().any(|t| t.source == thing.source && t.size.iter().any(Option::is_some));
        if !sized
            && thing.room == Some(plan.room)
            && thing.count == 1
            && let Some(size) = plan.draft.things[at].size.as_mut()
        {
            size[0] = size[0].max(counter);
        }
        if !sized
            && is_shared(&plan.draft.things[at])
            && let Some(size) = plan.draft.things[at].size.as_mut()
        {
            size[0] = size[0].max(FOR_TWO);
        }
        if !sized {
            fit_horseshoe(plan, at);
            fit_screen(plan, at);
            fit_stage(plan, at);
            fit_dance_floor(plan, at);
        }
        let thing = &plan.draft.things[at];
        let is_table = stand::group(&thing.category) == Group::Table;
        let is_round = stand::round(&thing.category, &thing.look.features);
        let is_oval = is_round && thing.size.is_some_and(|[w, _, d]| w > d);
        let fits = is_table && (!is_round || is_oval) && !sized && thing.count == 1;
        let (Some(size), true) = (thing.size, fits) else { continue };
        let seats = plan.companions(at).into_iter().map(|seat| plan.draft.things[seat].clone());
        let seats = seats.filter(|seat| stand::group(&seat.category) == Group::Seat);
        let Some((own, n)) = seats.filter_map(|seat| Some((seat.size?, seat.count))).max_by_key(|(_, n)| *n) else {
            continue;
        };
        let [w, _, d] = plan.draft.rooms[plan.room].size;
        // At a bar all sit on one side.
        let parts = groups::of(&thing.category, plan.kind.dress);
        let in_row = parts.iter().any(|part| matches!(part.at, groups::Where::Row(..)));
        // Stools that stand at tables are not those of the bar.
        let noun_of = |t: &DraftThing| t.category.replace('_', " ");
        let sits = |t: &DraftThing| t.room == Some(plan.room) && t.count > 1 && has_seats(plan, &noun_of(t));
        let told = plan.companions(at).into_iter().any(|seat| {
            let named = |text: &str| mentions(text, &plan.draft.things[seat].name) && mentions(text, &thing.name);
            plan.draft.statements.iter().any(|s| matches!(s.source, ThingOrigin::Stated(_)) && named(&s.text))
        });
        if in_row && !told && plan.draft.things.iter().any(sits) {
            continue;
        }
        let (room_for, needed) = match in_row {
            true => (slots::in_row(size[0], own[0]), slots::row(n, own[0])),
            false if is_oval => (slots::capacity(size, own, true), slots::oval(n, own[0], size[2])),
            false => {
                let at_ends =
                    if parts.iter().any(|part| matches!(part.at, groups::Where::LongSides(..))) { 0 } else { 2 };
                let along = n.saturating_sub(at_ends).div_ceil(2) as f64 * (own[0] + 0.12) + 0.1;
                (slots::capacity(size, own, false).saturating_sub(2 - at_ends), along)
            }
        };
        let needed = needed.min(w.max(d) - 2.0);
        if room_for < n
            && needed > size[0]
            && let Some(size) = plan.draft.things[at].size.as_mut()
        {
            size[0] = (needed * 100.0).ceil() / 100.0;
        }
    }
}

/// A screen that many look at is as large as the length of their room asks.
fn fit_screen(plan: &mut Plan, at: usize) {
    const MANY: usize = 8;
    const SHARE: f64 = 0.22;
    const LARGEST: f64 = 2.2;
    const SHAPE: f64 = 0.58;
    const IN_ROWS: f64 = 0.4;
    const LARGEST_IN_ROWS: f64 = 4.0;
    let thing = &plan.draft.things[at];
    let noun = thing.category.replace('_', " ");
    let is_named = ["screen", "tv", "television", "display"].iter().any(|end| noun.ends_with(end));
    let is_screen = is_named && (stand::group(&noun) == Group::Screen || noun == "projection screen");
    let is_usual = thing.size == Some(Plan::size(&noun));
    let [w, _, d] = plan.draft.rooms[plan.room].size;
    let mut wide = (SHARE * w.max(d)).min(LARGEST);
    // Rows of seats look at nothing else.
    let seats = |line: &Line| line.place == PlanPlace::Rows(true) && stand::group(line.noun) == Group::Seat;
    if noun == "projection screen" && plan.kind.lines.iter().any(seats) {
        wide = (IN_ROWS * w).min(LARGEST_IN_ROWS);
    }
    let is_here = thing.room == Some(plan.room) && thing.count == 1;
    let is_watched = plan.people.is_some_and(|people| people >= MANY);
    if let Some(size) = plan.draft.things[at].size.as_mut()
        && (is_screen && is_usual && is_here && is_watched)
        && size[0] < wide
    {
        (size[0], size[1]) = ((wide * 100.0).round() / 100.0, (SHAPE * wide * 100.0).round() / 100.0);
    }
}

/// A stage is as wide as a hall with rows of seats asks.
fn fit_stage(plan: &mut Plan, at: usize) {
    let thing = &plan.draft.things[at];
    let line = plan.kind.lines.iter().find(|line| line.noun == "stage" && thing.category == line.noun);
    let is_here = thing.room == Some(plan.room) && thing.count == 1;
    if let (Some(line), Some(size), true) = (line, thing.size, is_here) {
        plan.draft.things[at].size = Some(as_seen(plan, line, size));
    }
}

/// A dance floor is large enough for a third of the guests, where nobody says how large it is.
fn fit_dance_floor(plan: &mut Plan, at: usize) {
    /// Square metres for each of those who dance, and the shortest and longest side (metres).
    const EACH: f64 = 0.65;
    const SIDES: [f64; 2] = [3.2, 8.0];
    let thing = &plan.draft.things[at];
    let usual = Plan::size(order::DANCE_FLOOR);
    let is_usual = thing.category.replace('_', " ") == order::DANCE_FLOOR && thing.size == Some(usual);
    if let Some(people) = plan.people.filter(|_| is_usual && thing.count == 1) {
        let side = (people as f64 / 3.0 * EACH).sqrt().clamp(SIDES[0], SIDES[1]);
        let side = (side * 10.0).round() / 10.0;
        plan.draft.things[at].size = Some([side, usual[1], side]);
    }
}

/// A table like a U is as large as the seats need at its outer sides that are asked for, or the people in the room.
fn fit_horseshoe(plan: &mut Plan, at: usize) {
    let parts = groups::of(&plan.draft.things[at].category.replace('_', " "), plan.kind.dress);
    let Some(part) = parts.iter().find(|part| matches!(part.at, groups::Where::Outside(..))) else { return };
    let asked = plan.companions(at).into_iter().map(|seat| plan.draft.things[seat].count).max();
    let Some(n) = asked.or(plan.people) else { return };
    if let Some(size) = plan.draft.things[at].size.as_mut() {
        [size[0], size[2]] = slots::horseshoe(n, Plan::size(part.noun)[0]).map(|v| (v * 100.0).ceil() / 100.0);
    }
}

/// What is asked for stands at a wall if such things do and nothing else is said, and gets what goes with it.
pub fn stand_up(plan: &mut Plan, thing: usize) {
    if plan.claimed.contains(&thing) {
        return;
    }
    let it = plan.draft.things[thing].clone();
    let noun = it.category.replace('_', " ");
    // Where such rooms have their own of it, it stands as those do.
    let line = line_of(plan, &noun);
    let own = line.map(|line| &line.place);
    let is_table = stand::group(&it.category) == Group::Table && !stand::is_treated_on(&noun);
    let in_rows = match own {
        Some(PlanPlace::Rows(toward)) => Some(*toward),
        // The desks of a team stand in groups.
        Some(PlanPlace::Floor) if it.count >= TEAM && is_desk(&noun) => Some(false),
        // So does what one works at from all sides, beside each other.
        Some(PlanPlace::Middle) if !is_table => Some(false),
        Some(PlanPlace::Floor) if it.count >= SEVERAL && stand::group(&noun) == Group::Floor => Some(false),
        // So do mats, with nothing on them.
        _ if stand::group(&noun) == Group::Flat => Some(true),
        _ => None,
    };
    let fewest = if is_table || own == Some(&PlanPlace::Middle) { 2 } else { 3 };
    if let (Some(toward), true) = (in_rows, it.count >= fewest && !is_told(plan, &it.name)) {
        let clear = format!("againstWall(a, {})", plan.room_name());
        let is_mat = stand::group(&noun) == Group::Flat;
        if (is_mat || stand::on_floor(plan.draft, &it))
            && rows(plan, &noun, it.count, toward, ("this kind of object stands in rows", Some(thing)))
        {
            plan.draft
                .statements
                .retain(|s| s.demand != Demand::Prefer || !s.text.contains(&clear) || !s.text.contains(&it.name));
            return;
        }
    }
    if stacks::are_many(plan, thing) && stacks::stand_up(plan, thing) || stacks::in_formation(plan, thing) {
        return;
    }
    // Where such rooms have it in the middle, it is not at a wall; where they have it at a place of its own, it is there.
    let by_area = line.is_some_and(|line| matches!(line.count, kinds::Count::Area(_)));
    let apart = (it.count == 1 || by_area || groups::is_visited(&noun, plan.kind.dress))
        && matches!(own, Some(PlanPlace::Floor | PlanPlace::Middle))
        || it.count == 1 && it.look.features.iter().any(|feature| FREE.contains(&feature.as_str()));
    let special = |place: &PlanPlace| {
        matches!(place, PlanPlace::Before(..) | PlanPlace::Service(_) | PlanPlace::Back(_) | PlanPlace::Front(_))
    };
    // A car stands in line with the gate, and so does what lifts it.
    let gated = is_driven_in(&it.category) && gate(plan).is_some();
    let has_place = |line: &&Line| special(&line.place) || gated;
    // Several robots stand at the conveyor, as one does.
    let several =
        |line: &&Line| matches!(line.place, PlanPlace::Service(_) | PlanPlace::Before(_, 0.0)) && it.count <= SERVED;
    let own_place =
        line.filter(|line| (it.count == 1 || several(line)) && has_place(line) && !is_elsewhere(plan, thing));
    let at_wall_like = matches!(own, Some(PlanPlace::Wall | PlanPlace::Run)) && !apart;
    // Who serves stands behind a counter.
    let is_served =
        own_place.is_some_and(|line| matches!(line.place, PlanPlace::Before(_, 180.0) | PlanPlace::Service(_)));
    let has_back = stand::has_back(&it.category) && !apart && !is_served;
    let is_on_floor = stand::on_floor(plan.draft, &it);
    let pair = plan.ground.is_some()
        && (facing::is_pair(plan, thing) || facing::is_pair_of_desks(plan, thing) || facing::is_set(plan, thing, 3));
    let is_at_wall = is_on_floor && it.count <= 4 && has_back && !pair && !is_backed(plan, &it.name);
    let wall = if is_at_wall { at_a_wall(plan, thing) } else { AtWall::No };
    // One reads in a corner where nobody else sits on soft seats.
    let is_soft = |line: &Line| line.noun.ends_with("sofa");
    let reads = stand::is_easy(&noun) && it.count == 1 && !plan.kind.lines.iter().any(is_soft);
    let aside = own.map_or_else(|| reads || stand::is_aside(&it.category), |place| *place == PlanPlace::Corner);
    let aside =
        (aside && !plan.is_placed(thing) || plan.is_in_corners(thing) || plan.is_cornered(thing) && it.count == 1)
            && it.count <= CORNERS;
    let is_parked = is_parked(&noun);
    if !at_wall_like && !aside && !is_parked && (own_place.is_none() || gated) {
        straighten(plan, thing);
    }
    // Who waits on a bench or a chair is in nobody's way.
    let is_seat_aside = (ASIDE.contains(&noun.as_str()) || AT_WALL.iter().any(|end| noun.ends_with(end)))
        && own.is_none()
        && it.count <= 2
        && !plan.draft.outdoor
        && !plan.is_placed(thing);
    let waits = is_for_waiting(plan, thing);
    let is_unit = waits || noun == BOOTH || stand::is_unit(&noun, it.count);
    let in_run = own == Some(&PlanPlace::Run) || is_unit && !plan.is_placed(thing);
    // What is watched stands across from where one sits.
    let watched = line.filter(|line| matches!(line.place, PlanPlace::Opposite(_)));
    let looks_at = watched.and_then(|line| opposite_of(plan, line)).and_then(|name| plan.place_in_room(&name));
    let like = Like {
        line: own_place,
        at_wall: has_back || at_wall_like || is_seat_aside || waits,
        in_run,
        central: own == Some(&PlanPlace::Middle) && it.count == 1 && is_table && !plan.is_placed(thing),
        aside,
        looks_at,
        by: line.map_or("", |line| line.by),
    };
    if !(plan.ground.is_some() && (is_on_floor || is_mat(plan, thing, &noun)) && give_place(plan, thing, wall, &like)) {
        plan.building = None;
        plan.surround(thing, wall, 0);
    }
}

/// Whether it is a mat, which has a place of its own on which nothing stands.
fn is_mat(plan: &Plan, thing: usize, noun: &str) -> bool {
    stand::group(noun) == Group::Flat && (noun.ends_with("mat") || noun == order::DANCE_FLOOR) && !plan.is_placed(thing)
}

/// Whether the request says where or how a thing stands, other than that it looks at a board of which nothing is said.
fn is_told(plan: &Plan, name: &str) -> bool {
    let at_board = format!("forall a in {name}: sameWay(a, ");
    let here = || plan.draft.things.iter().enumerate().filter(|(_, it)| it.room == Some(plan.room));
    let is_free = |board: &str| here().any(|(at, it)| it.name == board && !plan.is_placed(at));
    let counts = |s: &Statement| {
        let board = s.text.split_once(&at_board).and_then(|(_, rest)| rest.split_once(')'));
        !board.is_some_and(|(board, _)| is_free(board))
    };
    stand::placed_where(plan.draft, name, None, &counts)
}

/// Whether the request says where a thing stands, other than in the half of the room where it stands anyway: "a teacher's desk
/// at the front".
fn is_elsewhere(plan: &Plan, thing: usize) -> bool {
    let it = &plan.draft.things[thing];
    let half = format!("{0}.center.z >= {1}.center.z", it.name, plan.room_name());
    let usual = format!("inside({}, {})", it.name, plan.room_name());
    let stated = plan.draft.statements.iter().filter(|s| matches!(s.source, ThingOrigin::Stated(_)));
    let mut about = stated.filter(|s| mentions(&s.text, &it.name));
    let is_before = |line: &Line| matches!(line.place, PlanPlace::Before(_, 0.0));
    let is_taught = plan.kind.is_taught() && line_of(plan, &it.category.replace('_', " ")).is_some_and(is_before);
    // Seats look at the stage wherever it is, and at a wall it is anyway.
    let is_back = line_of(plan, &it.category.replace('_', " ")).is_some_and(|l| matches!(l.place, PlanPlace::Back(_)));
    let at_wall = format!("againstWall({}, {})", it.name, plan.room_name());
    let looked_at = [format!("facing(a, {})", it.name), format!("dot({}.center - a.center, a.front) >= 0", it.name)];
    let is_free =
        |s: &Statement| s.text.contains(&at_wall) || looked_at.iter().any(|looks| s.text.contains(looks.as_str()));
    if is_back && about.clone().all(is_free) {
        return false;
    }
    plan.is_placed(thing) && !(is_taught && about.all(|s| s.text == half || s.text.contains(&usual)))
}

/// Whether something is said to stand behind a thing.
fn is_backed(plan: &Plan, name: &str) -> bool {
    let of = format!(", {name})");
    let mut stated = plan.draft.statements.iter().filter(|s| matches!(s.source, ThingOrigin::Stated(_)));
    stated.any(|s| s.text.contains("behind(") && s.text.contains(&of))
}

/// The line of the inventory that a thing of this name stands for.
fn line_of(plan: &Plan, noun: &str) -> Option<&'static Line> {
    // A kitchen is no counter at which guests are served.
    let is_kitchen = |line: &&Line| noun.ends_with("kitchen counter") && !line.noun.ends_with("kitchen counter");
    // Nor is a desk to work at one at which visitors are received.
    let is_other = |line: &&Line| is_reception(noun) && line.noun != noun && !stand::are_kin(line.noun, noun);
    let mut lines = plan.kind.lines.iter().filter(|line| !is_kitchen(line) && !is_other(line));
    let named = lines.clone().find(|line| line.noun == noun);
    named.or_else(|| lines.find(|line| stand::counts_as(line.noun, noun))).or_else(|| received(plan, noun))
}

/// Whether many chairs are asked for in a room in which visitors are received and nobody sits at tables: they wait there.
pub(super) fn is_for_waiting(plan: &Plan, thing: usize) -> bool {
    let it = &plan.draft.things[thing];
    let receives = |line: &Line| matches!(line.place, PlanPlace::Before(_, 180.0) | PlanPlace::Service(_));
    let here = plan.draft.things.iter().filter(|other| other.room == Some(plan.room));
    let asked = here.filter(|other| matches!(other.source, ThingOrigin::Stated(_)));
    let names = asked.map(|other| other.category.replace('_', " "));
    // Magazines lie on a table of a waiting room, and nobody sits at it.
    let waits = plan.kind.name.contains("waiting");
    let names = names.filter(|noun| !(waits && noun == "table"));
    let mut nouns = names.chain(plan.kind.lines.iter().map(|line| line.noun.to_owned()));
    it.count >= SEVERAL
        && it.room == Some(plan.room)
        && matches!(it.source, ThingOrigin::Stated(_))
        && ASIDE.contains(&it.category.replace('_', " ").as_str())
        && plan.kind.home.is_none()
        && plan.kind.lines.iter().any(receives)
        && !nouns.any(|noun| has_seats(plan, &noun))
}

/// Whether a thing is parked along a wall. An exercise bike is not.
fn is_parked(noun: &str) -> bool {
    noun == "bike" || PARKED.iter().any(|end| noun.ends_with(end))
}

fn is_reception(noun: &str) -> bool {
    noun.ends_with("reception desk") || noun.ends_with("front desk")
}

/// A desk or a counter at which visitors are received stands as in a reception, and a bar as in a pub, in rooms that usually
/// have none.
fn received(plan: &Plan, noun: &str) -> Option<&'static Line> {
    const COUNTERS: [&str; 4] = ["counter", "service counter", "shop counter", "customer counter"];
    const BARS: [&str; 2] = ["bar counter", "bar"];
    let desk = is_reception(noun);
    let public = plan.kind.home.is_none();
    let (kind, own) = match () {
        () if desk || public && COUNTERS.contains(&noun) => ("reception", "reception desk"),
        () if public && BARS.contains(&noun) => ("bar room", BARS[0]),
        () => return None,
    };
    kinds::of(kind)?.lines.iter().find(|line| line.noun == own)
}

/// How things of a kind stand in a room.
struct Like {
    /// The line of the inventory that has a place of its own.
    line: Option<&'static Line>,
    /// With their backs at a wall.
    at_wall: bool,
    in_run: bool,
    /// In the middle of the room.
    central: bool,
    /// In a corner, or at least at a wall.
    aside: bool,
    /// Across from what stands here.
    looks_at: Option<Pose>,
    /// Near this.
    by: &'static str,
}

/// Says that a thing stands at a wall, which is only preferred where the request places it.
fn at_a_wall(plan: &mut Plan, thing: usize) -> AtWall {
    let it = plan.draft.things[thing].clone();
    let (noun, room) = (it.category.replace('_', " "), plan.room_name());
    let verb = if plan.is_placed(thing) { "prefer" } else { "assert" };
    let one = if it.count > 1 { "a" } else { it.name.as_str() };
    // At a railing, as far from the edge as that is thick.
    let edge = plan.ground.as_ref().map_or(0.0, |ground| ground.edge);
    let at_wall = match edge {
        0.0 => format!("againstWall({one}, {room})"),
        _ => format!("backToWall({one}, {room}, {})", metres(edge + 0.01)),
    };
    let all = |formula: &str| match it.count {
        1 => format!("{verb} {formula};"),
        _ => format!("{verb} forall a in {}: {formula};", it.name),
    };
    let said = plan.draft.statements.iter().any(|s| s.demand == Demand::Must && s.text.contains(&at_wall));
    plan.draft.statements.retain(|s| s.demand != Demand::Prefer || s.text != at_wall);
    if !said {
        plan.say(all(&at_wall), "this kind of object stands against a wall");
    }
    if let Some(depth) = stand::access(&it.category).filter(|_| !choose::front_taken(&noun)) {
        let text = all(&format!("clear({one}, front, {})", metres(depth))).replacen("assert", "prefer", 1);
        plan.say(text, "it is used from the front");
    }
    if verb == "assert" || said { AtWall::Yes } else { AtWall::No }
}

/// Gives a thing a place. Whether there is one.
fn give_place(plan: &mut Plan, thing: usize, wall: AtWall, like: &Like) -> bool {
    let it = plan.draft.things[thing].clone();
    let Some(size) = it.size else { return false };
    let (noun, windows) = (it.category.replace('_', " "), window_walls(plan));
    // One sits before a fire, or around it.
    let fire = noun.ends_with("fireplace");
    // Between two sofas that face each other one looks to the side.
    let between = || near_to(plan, "sofa").map(|at| Pose { yaw: (at.yaw + 90.0) % 360.0, ..at });
    let choice = Choice {
        looks_at: like.looks_at.or_else(|| watched_from(plan).or_else(between).filter(|_| fire)),
        strictly: like.looks_at.is_some(),
        near: stands_near(plan, &it, like),
        pull: PULL[usize::from(at_window(plan, &it.name).is_some())],
        side: plan.side(thing),
        ..Choice::of(plan, &noun, size, &windows)
    };
    let says = |text: &str| plan.draft.statements.iter().any(|s| s.text.contains(text));
    let turn = [island_turn(plan)];
    let central = like.central || says(&format!("centeredIn({},", it.name));
    let is_across = says(&format!("{}.rot.y = 90", it.name)) || says(&format!("forall a in {}: a.rot.y = 90", it.name));
    let yaws: &[f64] = match is_across {
        true => &[90.0],
        false if is_island(&it.category) => &turn,
        false if groups::is_visited(&noun, plan.kind.dress) => &[0.0, 90.0, 180.0, 270.0],
        false => &[0.0],
    };
    let received = it.count == 1 && groups::is_visited(&noun, plan.kind.dress);
    let own = like.line.map(|line| (line, nominal(plan, line, size, 0.0)));
    let is_parked = is_parked(&noun);
    // In another place nothing could hold.
    let cornered = plan.is_cornered(thing);
    let around = like.line.map_or_else(Vec::new, |line| kept(line, size, false, 0.0));
    let row = RefCell::new(Vec::new());
    let (is_close, is_behind) = (Cell::new(false), Cell::new(false));
    let seek = |floor: &Floor, shape: &Shape, before: &[Pose]| {
        if cornered {
            // It is at the walls itself, and nobody stands behind it.
            choice.corner(floor, shape, before).filter(|_| seek::reach(shape)[2] < size[2] / 2.0 + 0.05)
        } else if let Some(pose) = in_row(&choice, floor, shape, before, (it.count, like.in_run), &row) {
            Some(pose)
        } else if let Some(pose) = central.then(|| choice.middle(floor, shape, yaws)).flatten() {
            Some(pose)
        } else if let Some(pose) = received.then(|| choice.received_at(floor, shape)).flatten() {
            Some(pose)
        } else if let Some((line, nominal)) = own {
            match line.place {
                PlanPlace::Service(gap) => lanes(&choice, floor, shape, before, (it.count, gap), &row),
                _ => {
                    // Several stand side by side, with room to walk between them.
                    let step = size[0] + APART;
                    let along = (before.len() as f64 - (it.count - 1) as f64 / 2.0) * step;
                    near(line, floor, shape, Pose { x: nominal.x + along, ..nominal })
                }
            }
        } else {
            let there = |choice: &Choice| match like {
                Like { aside: true, .. } => {
                    choice.corner(floor, shape, before).or_else(|| choice.wall(floor, shape, before))
                }
                _ if is_parked => choice.along_wall(floor, shape, before),
                Like { at_wall: true, .. } if it.count <= 8 => {
                    let aside = Choice { strictly: false, ..*choice };
                    choice.wall(floor, shape, before).or_else(|| aside.wall(floor, shape, before))
                }
                _ => {
                    let pose = free(choice, floor, shape, before, (it.count, yaws), &row)?;
                    is_close.set(shape.pieces.len() > 1 && floor.room_around(shape, &pose) < CLOSE);
                    Some(pose)
                }
            };
            // What is asked for stands behind the counter rather than nowhere.
            there(&choice).or_else(|| {
                let behind = there(&Choice { staffed: None, ..choice });
                is_behind.set(is_behind.get() || behind.is_some());
                behind
            })
        }
    };
    if stand_as_pair(plan, thing, &choice) {
        return true;
    }
    let root = Root { n: it.count, frames: vec![Pose::default()], wall, free: around, whole: false, seek: &seek };
    let placed = plan.place_asked(thing, &root);
    if placed && it.count > 1 && noun.starts_with("checkout") {
        let tills: Vec<Pose> = (0..it.count).filter_map(|i| plan.place_in_room(&format!("{}[{i}]", it.name))).collect();
        keep_exit(plan, &tills, size);
    }
    if placed {
        keep_there(plan, thing, like, received);
        keep_gaps(plan, thing, size);
    }
    let is_scattered = is_scattered(plan, thing, like, row.borrow().is_empty());
    // So does a table whose chairs meet those of a desk, or a sofa that finds a place only behind the counter.
    plan.lacking += if placed { usize::from(is_scattered || is_close.get() || is_behind.get()) } else { UNPLACED };
    placed
}

/// Several tables that stand where there is a gap want a larger room, and so do counters that are not side by side.
fn is_scattered(plan: &Plan, thing: usize, like: &Like, is_gap: bool) -> bool {
    let it = &plan.draft.things[thing];
    let is_served = like.line.is_some_and(|line| matches!(line.place, PlanPlace::Service(_)));
    let has_seats = || {
        let parts = groups::of(&it.category.replace('_', " "), plan.kind.dress);
        parts.iter().any(|part| stand::group(part.noun) == Group::Seat)
    };
    let is_row = stand::group(&it.category) == Group::Table && (is_served || has_seats()) || it.category == BOOTH;
    it.count > 1 && is_gap && is_row
}

/// Two seats, sofas, desks or beds that belong together get their places as one. Whether it is such a pair that has a place.
fn stand_as_pair(plan: &mut Plan, thing: usize, choice: &Choice) -> bool {
    let lengthwise: &[f64] = &[0.0, 90.0];
    let wall = |floor: &Floor, shape: &Shape, before: &[Pose]| choice.wall(floor, shape, before);
    let corner = |floor: &Floor, shape: &Shape, before: &[Pose]| choice.in_corner(floor, shape, before);
    let across = |floor: &Floor, shape: &Shape, before: &[Pose]| choice.floor(floor, shape, before, lengthwise);
    let beds = |floor: &Floor, shape: &Shape, _: &[Pose]| twin::at_wall(floor, shape, choice.size[2], choice.windows);
    facing::is_pair(plan, thing) && facing::stand_up(plan, thing, &wall)
        || facing::is_set(plan, thing, 2) && facing::in_corner(plan, thing, &corner)
        || facing::is_set(plan, thing, 3) && facing::on_three_sides(plan, thing, &wall)
        || facing::is_pair_of_desks(plan, thing) && facing::desks(plan, thing, &across)
        || twin::is_pair(plan, thing) && twin::stand_up(plan, thing, &beds)
}

/// Says that a thing stays at its place, should the search move it: in its corner, at the place of its own that such rooms have
/// for it, or with the visitors before it.
fn keep_there(plan: &mut Plan, thing: usize, like: &Like, received: bool) {
    const USUAL: &str = "it usually stands there in such a room";
    let it = plan.draft.things[thing].clone();
    let room = plan.room_name();
    if like.aside && it.count == 1 && it.size.is_some_and(|s| s[1] > TALL) {
        plan.say(format!("prefer inCorner({}, {room});", it.name), USUAL);
    }
    // In a corner, where it was asked for, there is less room behind it.
    let cornered = format!("inCorner({}, {room})", it.name);
    let in_corner = plan.draft.statements.iter().any(|s| s.demand == Demand::Must && s.text.contains(&cornered));
    if !in_corner && it.size.is_some_and(|size| stand::moving(&it.category.replace('_', " "), size) != size) {
        let one = if it.count > 1 { "a" } else { it.name.as_str() };
        let clear = format!("clear({one}, behind, {})", metres(stand::BEHIND_ROCKING));
        let all = if it.count > 1 { format!("forall a in {}: {clear}", it.name) } else { clear };
        plan.say(format!("assert {all};"), "it rocks");
    }
    // Tills and booths stand side by side as they were planned, as those of the inventory do.
    let is_served = like.line.is_some_and(|line| matches!(line.place, PlanPlace::Service(_)));
    if it.count > 1 && (is_served || it.category == BOOTH && like.in_run) {
        let element = |i: usize| format!("{}[{i}]", it.name);
        let fixed = |i: usize| {
            let at = plan.place_in_room(&element(i))?;
            Some(place::absolute(&element(i), &room, [at.x, at.y, at.z], at.yaw))
        };
        if let Some(all) = (0..it.count).map(fixed).collect::<Option<Vec<_>>>() {
            plan.say(format!("assert {};", all.join(" and ")), USUAL);
        }
        return;
    }
    let Some(at) = plan.place_in_room(&it.name).filter(|_| it.count == 1) else { return };
    let there = place::absolute(&it.name, &room, [at.x, at.y, at.z], at.yaw);
    let special = |line: &Line| matches!(line.place, PlanPlace::Before(..) | PlanPlace::Back(_) | PlanPlace::Front(_));
    if (like.central || like.line.is_some_and(special)) && !received && at.y == 0.0 {
        plan.say(format!("prefer {there};"), USUAL);
    }
    if received && !plan.is_placed(thing) {
        plan.say(format!("assert {there};"), "the person who works there faces the visitors");
    }
}

/// Nothing else stands between machines or shelves that stand side by side, where a gap is hardly wider than one of them.
fn keep_gaps(plan: &mut Plan, thing: usize, [width, height, depth]: [f64; 3]) {
    let it = &plan.draft.things[thing];
    if it.count < SEVERAL || !matches!(stand::group(&it.category), Group::Floor | Group::Storage) {
        return;
    }
    let places: Vec<Pose> = (0..it.count).filter_map(|i| plan.place_in_room(&format!("{}[{i}]", it.name))).collect();
    let Some(ground) = &mut plan.ground else { return };
    for pair in places.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        let (dx, dz) = (b.x - a.x, b.z - a.z);
        let gap = dx.hypot(dz) - width;
        let turn = a.yaw.to_radians();
        let ahead = (dx * turn.sin() + dz * turn.cos()).abs();
        if a.yaw == b.yaw && ahead < 0.01 && (0.1..1.5 * width).contains(&gap) {
            let middle = Pose { x: (a.x + b.x) / 2.0, y: 0.05, z: (a.z + b.z) / 2.0, yaw: a.yaw };
            ground.keep(&middle, [gap - 0.02, height, depth]);
        }
    }
}

/// The place of what a thing stands near.
fn stands_near(plan: &Plan, it: &DraftThing, like: &Like) -> Option<Pose> {
    at_window(plan, &it.name).or_else(|| match it.category.as_str() {
        order::PLAY_MAT => near_to(plan, "toy box").or_else(|| near_to(plan, "toy shelf")),
        category if is_island(category) => near_to(plan, COUNTER),
        category if category.replace('_', " ").starts_with(stand::AT_WINDOW) => {
            let mut windows = plan.draft.openings.iter().filter(|o| o.kind == OpeningKind::Window);
            windows.find(|o| o.rooms.contains(&plan.room)).and_then(|o| plan.place_in_room(&o.name))
        }
        _ => near_to(plan, like.by),
    })
}

/// The window that a thing is said to stand at.
fn at_window(plan: &Plan, name: &str) -> Option<Pose> {
    let windows = plan.draft.openings.iter().filter(|o| o.kind == OpeningKind::Window && o.rooms.contains(&plan.room));
    let is_near = |window: &str| {
        let said = format!("near({name}, {window}");
        plan.draft.statements.iter().any(|s| s.text.starts_with(&said))
    };
    windows.filter(|o| is_near(&o.name)).find_map(|o| plan.place_in_room(&o.name))
}

/// Whether people sit at it and look at the worktops of a kitchen.
pub(super) fn is_island(category: &str) -> bool {
    category.ends_with("island") || category.ends_with("breakfast_bar") || category.ends_with("breakfast bar")
}

/// How an island is turned: who sits there has the kitchen before the eyes.
fn island_turn(plan: &Plan) -> f64 {
    near_to(plan, COUNTER).map_or(180.0, |at| at.yaw)
}

/// What is asked for and stands free is parallel to the walls, where nothing says how it is turned.
fn straighten(plan: &mut Plan, thing: usize) {
    const TURNING: [&str; 12] = [
        "againstWall(",
        "inCorner(",
        "facing(",
        "looksAt(",
        "beside(",
        "inFrontOf(",
        "behind(",
        "Mounted(",
        ".front",
        ".rot",
        "parallel(",
        ".right",
    ];
    let it = plan.draft.things[thing].clone();
    let free = matches!(stand::group(&it.category), Group::Table | Group::Floor);
    let name = &it.name;
    let subject = [format!("({name},"), format!("({name}["), format!("forall a in {name}:"), format!("{name}.")];
    let turned = plan
        .draft
        .statements
        .iter()
        .any(|s| TURNING.iter().any(|t| s.text.contains(t)) && subject.iter().any(|n| s.text.contains(n)));
    // Who receives visitors turns to the door.
    let received = it.count == 1 && groups::is_visited(&it.category.replace('_', " "), plan.kind.dress);
    if !free || turned || received || !stand::on_floor(plan.draft, &it) || stand::has_back(&it.category) {
        return;
    }
    let [w, _, d] = plan.draft.rooms[plan.room].size;
    let along = it.size.is_none_or(|s| s[0] >= s[2]);
    let yaw = match (w >= d) == along {
        _ if is_driven_in(&it.category) && gate(plan).is_some() => "0",
        // Its open side is towards the screen.
        _ if groups::is_open_to_front(&it.category.replace('_', " "), plan.kind.dress) => "0",
        // Who sits at an island has the kitchen before the eyes.
        _ if is_island(&it.category) => match island_turn(plan) {
            0.0 => "0",
            90.0 => "90",
            270.0 => "270",
            _ => "180",
        },
        true => "0",
        false => "90",
    };
    let [own_w, _, own_d] = it.size.unwrap_or_default();
    let (across, deep) = if matches!(yaw, "0" | "180") { (own_w, own_d) } else { (own_d, own_w) };
    // What cannot stand so is left to turn.
    if across > w || deep > d {
        return;
    }
    let island = stand::group(&it.category) == Group::Table && !stand::placed(plan.draft, name);
    let text = match it.count {
        1 if island && own_w.max(own_d) < w.min(d) - 2.0 => {
            format!("assert {name}.rot.y = {yaw} and gap({name}, {}) >= 0.7;", plan.room_name())
        }
        1 => format!("assert {name}.rot.y = {yaw};"),
        _ => format!("assert forall a in {name}: a.rot.y = {yaw};"),
    };
    plan.say(text, "objects stand parallel to the walls");
}
