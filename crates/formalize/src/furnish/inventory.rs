//! The lines of the inventory of a kind of room: how many of each, how large, and the best place that is left.

use super::asked::{BOOTH, is_for_waiting};
use super::build::Root;
use super::choose::{self, Choice};
use super::daylight::window_walls;
use super::floor::{Floor, Pose, Shape};
use super::kinds::{self, Count, FurnishingKind, Line, PlanPlace};
use super::plan::{AtWall, Plan};
use super::rows::{ceiling, is_desk, rows};
use super::spots::{
    beds, beside_pair, ends, free, in_row, keep_exit, kept, lanes, near, near_to, nominal, watched_from,
};
use super::tell::{Stood, tell};
use super::{edge, groups, slots, stand};
use crate::brief::Group;
use crate::complete::defaults::AT_BOOTH;
use crate::draft::{DraftThing, OpeningKind, ThingOrigin};
use scenelang_lang::nouns::with_article;
use std::cell::RefCell;

/// How high things on walls are looked at.
pub(super) const EYES: f64 = 1.5;

/// A counter before the wall at the back takes this part of the room's width, in rooms that are wider than usual.
pub(super) const COUNTER: f64 = 0.26;

/// Things on walls are so far from each other and from what is tall beside them, if there is room, else so far.
pub(super) const APART: [f64; 2] = [0.3, 0.12];

/// In a run things are so far apart at least, where there is a choice.
pub(super) const TIGHT: f64 = 0.15;

/// Lengths of what may be shorter than usual rather than lack its sink, its stove or its seats (metres).
pub(super) const SHORTER: [(&str, &[f64]); 4] = [
    ("kitchen counter", &[1.8, 1.2, 0.8]),
    ("kitchenette", &[1.4, 1.2]),
    ("dining table", &[1.2, 0.9]),
    ("kitchen table", &[0.9]),
];

/// What takes less than this of the floor (square metres) has room where it has a place.
const SMALL: f64 = 0.15;
/// A worktop that is shorter than this part of the usual length is too short, if there may be more room.
const STUNTED: f64 = 0.7;
/// Where many books are asked for there are so many bookcases.
pub(super) const BOOKCASES: usize = 3;

/// How deep a television is that hangs on a wall (metres).
pub(super) const HUNG_SCREEN: f64 = 0.08;

/// So many desks are those of a team.
pub(super) const TEAM: usize = 2;

/// How the reason begins why something of the inventory of a kind of room is there.
pub(super) fn listed(kind: &FurnishingKind) -> String {
    format!("{} usually has ", with_article(kind.name))
}

/// Whether the one thing of a line, which stands on the floor, is there already with another: a bin beside the desk.
pub(super) fn came_along(plan: &Plan, line: &Line) -> bool {
    let listed = listed(plan.kind);
    let with_another = |t: &DraftThing| match &t.source {
        ThingOrigin::Inferred(why) => !why.starts_with(&listed),
        _ => false,
    };
    let hung = line.place == PlanPlace::Hung || line.place == PlanPlace::Ceiling;
    let mut here = plan.draft.things.iter().filter(|t| t.room == Some(plan.room));
    // One mirror is enough.
    let hung = hung && line.noun != "mirror";
    line.count == Count::Fixed(1) && !hung && here.any(|t| t.category.replace('_', " ") == line.noun && with_another(t))
}

/// Whether people sit around such a thing.
pub(super) fn has_seats(plan: &Plan, noun: &str) -> bool {
    let around = |part: &groups::GroupPart| part.at.is_around();
    stand::group(noun) == Group::Table && groups::of(noun, plan.kind.dress).iter().any(around)
}

/// Whether several tables for people are asked for: their number is what the request says, whatever they are called.
pub(super) fn several_tables(plan: &Plan) -> bool {
    let mut asked = plan.draft.things.iter().filter(|t| t.room == Some(plan.room) && t.count > 1);
    asked.any(|t| matches!(t.source, ThingOrigin::Stated(_)) && has_seats(plan, &t.category.replace('_', " ")))
}

/// Whether a bar is asked for with so many stools: its guests sit there. "A ramen bar with eight stools" has no tables.
fn sits_at_bar(plan: &Plan) -> bool {
    const SEVERAL: usize = 4;
    let mut here = plan.draft.things.iter().filter(|t| t.room == Some(plan.room));
    let is_stool = |t: &DraftThing| t.category.ends_with("stool") && matches!(t.source, ThingOrigin::Stated(_));
    plan.draft.rooms[plan.room].kind.ends_with(" bar") && here.any(|t| t.count >= SEVERAL && is_stool(t))
}

/// Adds a line of the inventory.
pub(super) fn inventory(plan: &mut Plan, line: &Line) {
    // A room with only what is asked for has light all the same.
    let closed = if line.place == PlanPlace::Ceiling { plan.is_said(line.noun) } else { plan.is_closed(line.noun) };
    let seats = has_seats(plan, line.noun) || matches!(line.place, PlanPlace::Rows(_)) && is_desk(line.noun);
    let seated = seats && (several_tables(plan) || sits_at_bar(plan));
    let is_small = plan.counted < line.least && !shows_on(plan, line);
    // Who waits on chairs that are asked for needs no sofa.
    let waits = line.noun.ends_with("sofa") && (0..plan.draft.things.len()).any(|at| is_for_waiting(plan, at));
    if is_small || closed || seated || waits || plan.is_furnished() || came_along(plan, line) {
        return;
    }
    // No one screen is seen from beds at opposite walls.
    let several_ways = |beds: &[Pose]| beds.iter().any(|bed| bed.yaw != beds[0].yaw);
    if line.noun == "tv" && several_ways(&beds(plan)) {
        return;
    }
    let people = plan.people.map_or(usual_people(plan), |n| n as f64);
    // Those who sit in booths do not sit at tables.
    let people = if has_seats(plan, line.noun) { (people - in_booths(plan) as f64).max(0.0) } else { people };
    let n = match line.count {
        Count::Fixed(n) if line.noun == "bookshelf" && has_books(plan) => n.max(BOOKCASES),
        Count::Fixed(n) => n,
        Count::Area(each) => (plan.counted / each).round() as usize,
        // Where it is said for how many people, no places are to spare.
        Count::People(each) if each > 1.0 && seats && plan.people.is_some() => {
            plan.tables(line).unwrap_or((people / each.max(2.0)).ceil() as usize)
        }
        Count::People(each) => plan.tables(line).unwrap_or((people / each).ceil() as usize),
    };
    let why = listed(plan.kind) + if n == 1 { "one" } else { "some" };
    match &line.place {
        PlanPlace::Ceiling => ceiling(plan, line.noun, n.max(1), &why),
        PlanPlace::Edge if line.noun.ends_with("wall") => edge::house(plan, line, &why),
        PlanPlace::Edge => edge::railing(plan, line, &why),
        PlanPlace::Rows(toward) => {
            rows(plan, line.noun, n, *toward, (&why, None));
        }
        // The desks of a team stand in groups, not one by one.
        PlanPlace::Floor if n >= TEAM && is_desk(line.noun) => {
            rows(plan, line.noun, n, false, (&why, None));
        }
        _ => single(plan, line, n, &why),
    }
}

/// How many people sit in the booths that are asked for.
fn in_booths(plan: &Plan) -> usize {
    let booths = plan.draft.things.iter().filter(|t| t.room == Some(plan.room) && t.category == BOOTH);
    booths.map(|t| t.count * AT_BOOTH).sum()
}

/// Whether a projector that is asked for needs this screen.
fn shows_on(plan: &Plan, line: &Line) -> bool {
    let mut here = plan.draft.things.iter().filter(|t| t.room == Some(plan.room));
    line.noun == "projection screen" && here.any(|t| t.category.ends_with("projector"))
}

/// Whether books are asked for, of which nobody says how many: "lots of books".
pub(super) fn has_books(plan: &Plan) -> bool {
    let mut here = plan.draft.things.iter().filter(|t| t.room == Some(plan.room));
    here.any(|t| t.count > 1 && t.category == "book" && matches!(t.source, ThingOrigin::Stated(_)))
}

/// For how many people a room is of which nobody says it: fewer in a small one, more in a large one.
pub(super) fn usual_people(plan: &Plan) -> f64 {
    let [w, _, d] = plan.kind.size;
    let is_free = plan.draft.rooms.len() == 1 && !plan.draft.rooms[plan.room].sized;
    let share = if is_free { (plan.counted / (w * d)).clamp(0.5, 1.5) } else { 1.0 };
    (plan.kind.people * share).round().max(1.0)
}

/// How long a counter before the wall at the back is at least, in metres; 0 for anything else.
pub(super) fn counter_length(plan: &Plan, line: &Line) -> f64 {
    let is_counter = matches!(line.place, PlanPlace::Before(_, 180.0)) && line.noun.ends_with("counter");
    let length = COUNTER * plan.draft.rooms[plan.room].size[0];
    if is_counter { (length * 10.0).round() / 10.0 } else { 0.0 }
}

/// How wide the stand of a television is that is asked for and large.
fn under_screen(plan: &Plan, line: &Line) -> f64 {
    const BESIDE: f64 = 0.1;
    let asked =
        plan.draft.things.iter().filter(|t| t.room == Some(plan.room) && t.count == 1 && line.noun == "tv stand");
    let screens = asked.filter(|t| stand::counts_as("tv", &t.category.replace('_', " ")));
    screens.filter_map(|t| t.size).map(|size| size[0] + BESIDE).fold(0.0, f64::max)
}

/// The size of a thing; a table is as long as the people need who sit at it.
pub(super) fn size_for_people(plan: &Plan, noun: &str, n: usize) -> [f64; 3] {
    let mut size = Plan::size(noun);
    let all = kinds::seats_all(plan.kind, noun);
    let sits = |part: &&groups::GroupPart| part.at.is_around() && (all || matches!(part.at, groups::Where::Around(..)));
    let seats = groups::of(noun, plan.kind.dress).iter().find(sits);
    if let (Some(people), Some(part), 1) = (plan.people, seats, n) {
        let [w, _, d] = plan.draft.rooms[plan.room].size;
        let at_ends = if matches!(part.at, groups::Where::Around(..)) { 2 } else { 0 };
        let each_side = people.saturating_sub(at_ends).div_ceil(2) as f64;
        let needed = each_side * (Plan::size(part.noun)[0] + 0.12) + 0.1;
        size[0] = size[0].max(needed.min(w.max(d) - 2.0));
    }
    // A bar is as long as the stools need that are asked for and stand at it, and a table as its chairs do.
    let at_length =
        |part: &&groups::GroupPart| matches!(part.at, groups::Where::Row(..) | groups::Where::LongSides(..));
    let row = groups::of(noun, plan.kind.dress).iter().find(at_length);
    if let (Some(part), 1) = (row, n) {
        let stools = plan.draft.things.iter().filter(|t| t.room == Some(plan.room));
        let stools =
            stools.filter(|t| matches!(t.source, ThingOrigin::Stated(_)) && !stand::placed(plan.draft, &t.name));
        let stools = stools.filter(|t| stand::counts_as(part.noun, &t.category.replace('_', " ")));
        let sides = if matches!(part.at, groups::Where::Row(..)) { 1 } else { 2 };
        let own = |t: &DraftThing| t.size.map_or(0.4, |own| own[0]);
        let needed = stools.map(|t| slots::row(t.count.div_ceil(sides), own(t))).fold(0.0, f64::max);
        let [w, _, d] = plan.draft.rooms[plan.room].size;
        size[0] = size[0].max((needed.min(w.max(d) - 2.0) * 100.0).ceil() / 100.0);
    }
    size
}

/// A screen or a board that is seen from the back of a hall is as large as that needs, a stage as wide as the hall asks; a television that hangs has no foot.
pub(super) fn as_seen(plan: &Plan, line: &Line, [w, h, d]: [f64; 3]) -> [f64; 3] {
    const SHARE: f64 = 0.3;
    const LARGEST: f64 = 4.4;
    const WATCHED: [f64; 2] = [0.6, 8.0];
    const BELOW: f64 = 1.6;
    const LARGEST_BOARD: f64 = 3.6;
    const STAGE: f64 = 0.66;
    const LARGEST_STAGE: f64 = 12.0;
    let [width, height, _] = plan.draft.rooms[plan.room].size;
    if line.noun == "tv" && line.place == PlanPlace::Hung {
        return [w, h, HUNG_SCREEN];
    }
    if !matches!(line.place, PlanPlace::Back(_)) {
        return [w, h, d];
    }
    if line.noun.ends_with("board") {
        return [(SHARE * width).min(LARGEST_BOARD).max(w), h, d];
    }
    if line.noun == "stage" {
        return [((STAGE * width).min(LARGEST_STAGE).max(w) * 10.0).floor() / 10.0, h, d];
    }
    if line.noun != "projection screen" {
        return [w, h, d];
    }
    // Rows of seats look at nothing else.
    let watched = |line: &Line| line.place == PlanPlace::Rows(true) && stand::group(line.noun) == Group::Seat;
    let [share, largest] = if plan.kind.lines.iter().any(watched) { WATCHED } else { [SHARE, LARGEST] };
    let wide = (share * width).min(largest).min(1.7 * (height - BELOW)).max(w);
    [wide, h.max(0.56 * wide), d]
}

/// Things at walls, in corners, in the middle.
pub(super) fn single(plan: &mut Plan, line: &Line, n: usize, why: &str) {
    let mut size = size_for_people(plan, line.noun, n);
    size[0] = size[0].max(counter_length(plan, line)).max(under_screen(plan, line));
    size = as_seen(plan, line, size);
    // A worktop is as long as what stands beside it leaves room for, a table as its chairs do.
    let shorter = SHORTER.iter().filter(|(noun, _)| *noun == line.noun).flat_map(|(_, widths)| *widths);
    let known = plan.ground.is_some();
    let usual = size[0];
    for width in shorter.filter(|_| known) {
        if single_of(plan, line, n, why, size, true) {
            // A kitchen with hardly a worktop wants a larger room.
            let [w, _, d] = plan.draft.rooms[plan.room].size;
            let small = w * d < 0.9 * plan.kind.size[0] * plan.kind.size[2];
            let stunted = plan.matters && !small && size[0] < STUNTED * usual;
            plan.lacking += usize::from(stunted && line.noun.ends_with("counter"));
            return;
        }
        size[0] = *width;
    }
    // A desk that nobody can sit at is left out: rather one with a chair than two without.
    let is_sat_at = |part: &groups::GroupPart| stand::group(part.noun) == Group::Seat;
    if known && is_desk(line.noun) && groups::of(line.noun, plan.kind.dress).iter().any(is_sat_at) {
        let is_first = plan.kind.lines.first().is_some_and(|first| first.noun == line.noun);
        let placed = (1..=n).rev().find(|n| single_of(plan, line, *n, why, size, true));
        // In a larger room there is a desk for everyone.
        plan.lacking += usize::from(plan.matters && placed != Some(n));
        if placed.is_some() || !is_first {
            return;
        }
    }
    // A table that nobody can sit at is left out, unless the room is nothing without it.
    let whole = known && !plan.matters && has_seats(plan, line.noun);
    single_of(plan, line, n, why, size, whole);
}

/// Whether such rooms have a screen across from the sofa.
pub(super) fn is_watched_room(plan: &Plan) -> bool {
    plan.kind.lines.iter().any(|line| matches!(&line.place, PlanPlace::Opposite(other) if other.ends_with("sofa")))
}

/// The name of the thing that a line's thing looks at from across the room.
pub(super) fn opposite_of(plan: &Plan, line: &Line) -> Option<String> {
    let PlanPlace::Opposite(other) = &line.place else { return None };
    let is_it = |t: &&DraftThing| {
        let noun = t.category.replace('_', " ");
        t.room == Some(plan.room) && (noun.ends_with(other.as_str()) || stand::are_kin(other, &noun))
    };
    let one = plan.draft.things.iter().find(|t| t.count == 1 && is_it(t)).map(|t| t.name.clone());
    // Of two in a corner, the first.
    let turn = |name: String| plan.place_in_room(&name).map(|at| at.yaw);
    let is_bent = |t: &&DraftThing| match [0, 1].map(|i| turn(format!("{}[{i}]", t.name))) {
        [Some(first), Some(second)] => (first - second).rem_euclid(180.0) == 90.0,
        _ => false,
    };
    let two = || plan.draft.things.iter().filter(|t| t.count == 2 && is_it(t)).find(is_bent);
    one.or_else(|| two().map(|t| format!("{}[0]", t.name)))
}

/// Whether what has such a place stands or hangs at a wall.
fn is_at_wall(place: &PlanPlace) -> bool {
    !matches!(place, PlanPlace::Middle | PlanPlace::Floor | PlanPlace::Before(..) | PlanPlace::Service(_))
}

/// The same of a size. Whether it has a place, with `whole` together with all that it is not complete without.
pub(super) fn single_of(plan: &mut Plan, line: &Line, n: usize, why: &str, size: [f64; 3], whole: bool) -> bool {
    let hung = line.place == PlanPlace::Hung || matches!(stand::group(line.noun), Group::Wall | Group::Screen);
    let at_wall = is_at_wall(&line.place);
    // Where places are known, they say better what there is room for.
    let small = size[0] * size[2] < SMALL;
    let room_for =
        |n: &usize| hung || small || plan.matters && plan.ground.is_some() || plan.has_room(size, *n, at_wall);
    let n = (0..=n).rev().find(room_for).unwrap_or(0);
    if n == 0 {
        return false;
    }
    let y = if hung { hung_at(plan, line, size[1]) } else { 0.0 };
    let opposite = opposite_of(plan, line);
    let opposite_pose = opposite.as_ref().and_then(|name| plan.place_in_room(name));
    let aside = matches!(line.place, PlanPlace::Opposite(_)).then(|| beside_pair(plan)).flatten();
    let watched = if line.noun.ends_with("tv") { watched_from(plan) } else { opposite_pose };
    let windows = window_walls(plan);
    let beds = if line.noun.ends_with("tv") { beds(plan) } else { Vec::new() };
    let choice = Choice {
        looks_at: watched.or(aside),
        strictly: opposite_pose.is_some() || aside.is_some(),
        near: near_to(plan, line.by),
        beds: &beds,
        ..Choice::of(plan, line.noun, size, &windows)
    };
    // Either side of a pair that faces each other will do.
    let behind = Choice { looks_at: aside.map(|at| Pose { yaw: (at.yaw + 180.0) % 360.0, ..at }), ..choice };
    let anywhere = Choice { strictly: false, ..choice };
    let nominal = nominal(plan, line, size, y);
    let (dress, bent) = (plan.kind.dress, groups::turns_corner(line.noun, plan.kind.dress));
    let row = RefCell::new(Vec::new());
    let seek = |floor: &Floor, shape: &Shape, before: &[Pose]| match &line.place {
        _ if hung && matches!(line.place, PlanPlace::Hung | PlanPlace::Wall) => choice.hung(floor, shape, before, y),
        PlanPlace::Wall | PlanPlace::Run | PlanPlace::Hung => in_row(&choice, floor, shape, before, (n, false), &row)
            .filter(|_| line.place == PlanPlace::Wall)
            .or_else(|| choice.in_corner(floor, shape, before).filter(|_| bent))
            .or_else(|| choice.wall(floor, shape, before)),
        PlanPlace::Service(gap) => lanes(&choice, floor, shape, before, (n, *gap), &row),
        PlanPlace::Opposite(_) => choice
            .wall(floor, shape, before)
            .or_else(|| aside.and_then(|_| behind.wall(floor, shape, before)))
            .or_else(|| anywhere.wall(floor, shape, before)),
        PlanPlace::Corner => choice.corner(floor, shape, before),
        PlanPlace::Floor if n == 1 && groups::is_visited(line.noun, dress) => {
            choice.received_at(floor, shape).or_else(|| choice.floor(floor, shape, before, &[0.0, 90.0]))
        }
        PlanPlace::Floor => free(&choice, floor, shape, before, (n, &[0.0, 90.0]), &row),
        PlanPlace::Middle if n > 1 => free(&choice, floor, shape, before, (n, &[0.0]), &row),
        _ => near(line, floor, shape, nominal),
    };
    let run = line.place == PlanPlace::Run && n > 1;
    let together = |n: usize, gap: f64| -> Vec<Pose> {
        let n = if run { n } else { 1 };
        (0..n).map(|i| Pose { x: i as f64 * (size[0] + gap), ..Pose::default() }).collect()
    };
    let wall = if at_wall && !hung && line.place != PlanPlace::Corner { AtWall::Yes } else { AtWall::No };
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
    let is_scattered = row.borrow().is_empty();
    plan.lacking += amiss(plan, line, &poses, is_scattered, opposite_pose);
    keep_free(plan, line, (&poses, size), opposite_pose);
    let at = Stood { line, thing, poses: &poses, nominal, gap, hung, y, opposite: opposite.zip(opposite_pose) };
    tell(plan, &at, why);
    true
}

/// Keeps free what is seen across the room, and the way out behind tills.
fn keep_free(plan: &mut Plan, line: &Line, (poses, size): (&[Pose], [f64; 3]), opposite: Option<Pose>) {
    if let (Some(at), Some(seen)) = (poses.first(), opposite) {
        keep_view(plan, at, &seen);
    }
    if poses.len() > 1 && line.noun.starts_with("checkout") {
        keep_exit(plan, poses, size);
    }
}

/// How many places of things that matter are not as they should be; a larger room, or one with other sides, may mend them.
fn amiss(plan: &Plan, line: &Line, poses: &[Pose], is_scattered: bool, opposite: Option<Pose>) -> usize {
    if !plan.matters {
        return 0;
    }
    // Several tables that stand where there is a gap.
    let scattered = line.place == PlanPlace::Floor && poses.len() > 1 && is_scattered && has_seats(plan, line.noun);
    // People who share a workroom sit side by side.
    let apart = is_desk(line.noun) && matches!(poses, [first, second] if first.yaw != second.yaw);
    let askew = match (&line.place, opposite, poses.first()) {
        (PlanPlace::Opposite(_), Some(seen), Some(at)) => (seen.yaw - at.yaw).rem_euclid(360.0) != 180.0,
        _ => false,
    };
    usize::from(scattered) + usize::from(apart) + usize::from(askew)
}

/// How far an exit sign hangs above its door (metres).
const OVER_DOOR: f64 = 0.14;

/// How high something of a height hangs.
fn hung_at(plan: &Plan, line: &Line, height: f64) -> f64 {
    let under_ceiling = (plan.draft.rooms[plan.room].size[1] - height - 0.1).max(0.3);
    if line.noun.ends_with(choose::OVER_DOOR) {
        let doors = plan.draft.openings.iter().filter(|o| o.kind == OpeningKind::Door);
        let high = doors.map(|door| door.size[1]).fold(Plan::size("door")[1], f64::max);
        return (high + OVER_DOOR).clamp(0.3, under_ceiling);
    }
    (EYES - height / 2.0).max(above_low(plan, line)).clamp(0.3, under_ceiling)
}

/// How high something hangs at least that hangs near something low: both are seen, as a board over the counter.
pub(super) fn above_low(plan: &Plan, line: &Line) -> f64 {
    const LOW: f64 = 1.3;
    const OVER: f64 = 0.55;
    // What is at the back of a hall is seen over the stage.
    let by = if matches!(line.place, PlanPlace::Back(_)) { "stage" } else { line.by };
    let mut things = plan.draft.things.iter().filter(|t| t.room == Some(plan.room) && !by.is_empty());
    let thing = things.find(|t| t.category.replace('_', " ").ends_with(by));
    thing.and_then(|t| t.size).map_or(0.0, |[_, h, _]| if h < LOW && !stand::has_back(by) { h + OVER } else { 0.0 })
}

/// Nothing more stands between a thing and what it is opposite of.
pub(super) fn keep_view(plan: &mut Plan, at: &Pose, seen: &Pose) {
    const WIDE: f64 = 0.8;
    let [dx, dz] = [(at.x - seen.x).abs(), (at.z - seen.z).abs()];
    let middle = Pose { x: (at.x + seen.x) / 2.0, y: 0.05, z: (at.z + seen.z) / 2.0, yaw: 0.0 };
    if let Some(ground) = &mut plan.ground {
        ground.keep(&middle, [dx.max(WIDE), 1.2, dz.max(WIDE)]);
    }
}
