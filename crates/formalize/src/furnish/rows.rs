//! Things in rows: desks of a classroom, tables of a restaurant, racks, lights under a ceiling.

use super::build::Root;
use super::floor::{Floor, Footprint, Pose, Shape};
use super::inventory::TEAM;
use super::kinds::{Line, PlanPlace};
use super::plan::{AtWall, Plan, metres};
use super::spots::{for_counters, for_tills, gate};
use super::{groups, place, stand};
use crate::brief::{Brief, Fact, FactKind, Pattern};

/// A dining room of more has lights beside those over its table (square metres).
const WIDE: f64 = 30.0;
/// So many lights at most.
const MOST: usize = 16;

/// Lights spread evenly under the ceiling, or, if they hang low, one over each table whose place is known.
pub fn ceiling(plan: &mut Plan, noun: &str, n: usize, why: &str) {
    if plan.draft.outdoor {
        return;
    }
    let [w, h, d] = plan.draft.rooms[plan.room].size;
    let size = Plan::size(noun);
    let outline = plan.draft.rooms[plan.room].outline.is_some();
    let n = if outline { 1 } else { n.min(MOST) };
    // Rows across the shorter side.
    let pendant = plan.draft.things.iter().any(|t| t.room == Some(plan.room) && t.category.contains("pendant"));
    // What hangs over the one table of a dining room is light enough.
    let one_table = plan.kind.lines.first().is_some_and(|line| line.place == PlanPlace::Middle);
    if pendant && one_table && noun == "ceiling light" && w * d < WIDE {
        return;
    }
    let n = if pendant { n.max(2) } else { n };
    let rows = ((n as f64 * d / w).sqrt().round() as usize).clamp(1, n);
    let columns = n.div_ceil(rows);
    // What hangs over a table in the middle has its place there.
    let columns = if pendant && rows % 2 == 1 && columns % 2 == 1 { columns + 1 } else { columns };
    let y = h - size[1];
    let mut places: Vec<[f64; 2]> = (0..rows * columns)
        .map(|i| {
            let x = ((i % columns) as f64 + 0.5) / columns as f64 - 0.5;
            let z = ((i / columns) as f64 + 0.5) / rows as f64 - 0.5;
            [x * w, z * d]
        })
        .collect();
    let over = tables(plan);
    // So does the one light of a room whose table has its place in the middle, or nearly there.
    let one_over_one = one_table && places.len() == 1 && over.len() == 1;
    if (noun.starts_with("pendant") || one_over_one) && !over.is_empty() && !outline {
        places = over;
    }
    let n = places.len();
    let thing = plan.add(noun, n, size, why);
    let room = plan.room_name();
    let name = plan.draft.things[thing].name.clone();
    let text = if outline {
        format!("assert {name}.pos = vec3({room}.center.x, {room}.floor + {}, {room}.center.z);", metres(y))
    } else {
        let element = |i: usize| if n == 1 { name.clone() } else { format!("{name}[{i}]") };
        let at = |(i, [x, z]): (usize, &[f64; 2])| place::absolute(&element(i), &room, [*x, y, *z], 0.0);
        let each: Vec<String> = places.iter().enumerate().map(at).collect();
        format!("assert {};", each.join(" and "))
    };
    plan.say(text, why);
    let mounted = match n {
        1 => format!("assert ceilingMounted({name}, {room});"),
        _ => format!("assert forall a in {name}: ceilingMounted(a, {room});"),
    };
    plan.say(mounted, why);
}

/// Where tables and counters of the room stand, as far as that is known: what hangs low hangs over them.
fn tables(plan: &Plan) -> Vec<[f64; 2]> {
    const LIT: [&str; 3] = ["table", "counter", "bar"];
    const LOW: [&str; 4] = ["coffee table", "low table", "side table", "changing table"];
    let here = plan.draft.things.iter().filter(|thing| thing.room == Some(plan.room));
    let lit = here.filter(|thing| {
        let noun = thing.category.replace('_', " ");
        LIT.iter().any(|end| noun.ends_with(end)) && !LOW.iter().any(|low| noun.ends_with(low))
    });
    let mut found: Vec<[f64; 2]> = Vec::new();
    for thing in lit {
        for i in 0..thing.count {
            let name = if thing.count > 1 { format!("{}[{i}]", thing.name) } else { thing.name.clone() };
            found.extend(plan.place_in_room(&name).map(|at| [at.x, at.z]));
        }
    }
    found.truncate(MOST);
    found
}

/// Things with their groups in rows, as many as there is room for.
/// Of things that are asked for, all or none. Whether they stand there.
pub fn rows(plan: &mut Plan, noun: &str, n: usize, toward: bool, (why, asked): (&str, Option<usize>)) -> bool {
    let [w, _, d] = plan.draft.rooms[plan.room].size;
    if plan.draft.rooms[plan.room].outline.is_some() || n == 0 {
        return false;
    }
    let wanted = n;
    let size = asked.and_then(|thing| plan.draft.things[thing].size).unwrap_or_else(|| Plan::size(noun));
    let reach = plan.reach(noun, size);
    let [left, right, back, front] = reach;
    let (cell_w, cell_d) = (left + right, back + front);
    let flat = size[1] < 0.05;
    let facing = !toward && n >= TEAM && is_desk(noun);
    // Tables at which a team meets have a side of the room for themselves.
    let meets =
        |t: &crate::draft::DraftThing| t.room == Some(plan.room) && plan.is_parted(&t.category.replace('_', " "));
    let aside = plan.draft.things.iter().any(meets);
    let places = if facing { pairs([w, d], size, front, (n, aside)) } else { None };
    let matters = plan.matters || asked.is_some();
    // A team that finds no room for its groups of desks wants a larger one.
    plan.lacking += usize::from(matters && facing && places.is_none() && asked.is_none());
    let is_table = stand::group(noun) == crate::brief::Group::Table;
    let more = if asked.is_some() && is_table { &FARTHER[..] } else { &FARTHER[..2] };
    // Nearer to each other, too, where something is in the way of tables that are spread.
    let spreads = if is_table { &[SPREAD, 0.95, 0.6, 0.0][..] } else { &[SPREAD][..] };
    let tries = more.iter().flat_map(|more| spreads.iter().map(move |spread| (toward, *more, *spread)));
    let tries = tries.filter_map(|how| {
        let upright = || grid(plan, [w, d], noun, size, reach, n, how);
        let mut places = turned(plan, noun, size, reach, n, how).or_else(|| places.clone()).or_else(upright)?;
        if let Some(ground) = &plan.ground {
            // What stands there already, and doors, leave less.
            let around = Pose { x: (right - left) / 2.0, z: (front - back) / 2.0, ..Pose::default() };
            let cell = [cell_w, size[1].max(0.9), cell_d];
            let piece = Footprint { thing: 0, at: around, size: cell, flat, tall: false };
            let shape = Shape { pieces: vec![piece], ..Shape::default() };
            let is_free = |at: &Pose| ground.fits(&shape, at);
            let piece = Footprint { size: [cell_w + 2.0 * ROUND, cell[1], cell_d + 2.0 * ROUND], ..piece };
            let wider = Shape { pieces: vec![piece], ..Shape::default() };
            // Tables with seats at both sides, and groups of desks, move aside together for what stands there already.
            if facing || is_table && back > size[2] / 2.0 + SEATED {
                places = shifted(&places, &|at| ground.fits(&wider, at));
            }
            places.retain(is_free);
        }
        Some((how.1, places))
    });
    // The first with the most places.
    let most = tries.reduce(|best, next| if next.1.len() > best.1.len() { next } else { best });
    let Some((farther, places)) = most else {
        plan.lacking += usize::from(matters);
        return false;
    };
    let n = places.len();
    let is_crowded = is_table && back > size[2] / 2.0 + SEATED && crowded(&places, [cell_w, cell_d]);
    // So do rows that are too close to the teacher's desk.
    let teaches = |line: &Line| matches!(line.place, PlanPlace::Before(_, 0.0)) && is_desk(line.noun);
    let is_near = farther < 0.0 && plan.kind.lines.iter().any(teaches);
    plan.lacking += usize::from(matters && (n < wanted || is_crowded || is_near));
    if n == 0 || asked.is_some() && n < wanted {
        return false;
    }
    let thing = asked.unwrap_or_else(|| plan.add(noun, n, size, why));
    let room = plan.room_name();
    let name = plan.draft.things[thing].name.clone();
    let each: Vec<String> = places
        .iter()
        .enumerate()
        .map(|(i, at)| {
            let element = if n > 1 { format!("{name}[{i}]") } else { name.clone() };
            place::absolute(&element, &room, [at.x, at.y, at.z], at.yaw)
        })
        .collect();
    plan.say(format!("assert {};", each.join(" and ")), why);
    plan.take([cell_w, size[1], cell_d], n, false);
    let seek = |_: &Floor, _: &Shape, before: &[Pose]| places.get(before.len()).copied();
    let root = Root { n, frames: vec![Pose::default()], wall: AtWall::No, free: Vec::new(), whole: false, seek: &seek };
    if plan.ground.is_none() || !plan.place_asked(thing, &root) {
        plan.building = None;
        plan.surround(thing, AtWall::No, 0);
    }
    true
}

/// "Five bookshelves in five rows": each is as long as a row of a few.
pub fn long_shelves(brief: &mut Brief) {
    const IN_ROW: f64 = 4.0;
    for at in 0..brief.things.len() {
        let n = brief.count(at);
        let is_row = |fact: &Fact| fact.of == [at] && fact.what == FactKind::Pattern(Pattern::Rows(Some(n)));
        let in_rows = n > 2 && brief.facts.iter().any(is_row);
        let thing = &brief.things[at];
        let named = thing.words.last().is_some_and(|word| matches!(word.as_str(), "bookshelf" | "bookcase" | "shelf"));
        let Some(kind) = brief.rooms.get(thing.room).and_then(|room| super::kinds::of(&room.name)) else { continue };
        let is_public = matches!(kind.dress, "library" | "shop") || kind.dress == "books";
        if in_rows && named && is_public && thing.size[0].is_none() {
            let wide = Plan::size(&thing.name())[0];
            // Half of the room at most: there are other things in it.
            let most = (kind.size[0] / 2.0 / wide).floor().clamp(1.0, IN_ROW);
            brief.things[at].size[0] = Some((wide * most * 100.0).round() / 100.0);
        }
    }
}

/// Whether someone works at it, who has others of a team around.
pub fn is_desk(noun: &str) -> bool {
    noun.ends_with("desk") || noun.ends_with("workstation")
}

/// The same places, all moved so that as many as possible are free, and no farther than needed.
fn shifted(places: &[Pose], is_free: &dyn Fn(&Pose) -> bool) -> Vec<Pose> {
    const STEP: f64 = 0.25;
    const FAR: i32 = 5;
    let moved = |(x, z): (i32, i32)| -> Vec<Pose> {
        let by = |at: &Pose| Pose { x: at.x + STEP * f64::from(x), z: at.z + STEP * f64::from(z), ..*at };
        places.iter().map(by).collect()
    };
    let mut shifts: Vec<(i32, i32)> = (-FAR..=FAR).flat_map(|x| (-FAR..=FAR).map(move |z| (x, z))).collect();
    shifts.sort_by_key(|(x, z)| (x.abs() + z.abs(), *x, *z));
    let free = |places: &[Pose]| places.iter().filter(|at| is_free(at)).count();
    let mut best = (free(places), places.to_vec());
    for shift in shifts {
        if best.0 == places.len() {
            break;
        }
        let next = moved(shift);
        let n = free(&next);
        if n > best.0 {
            best = (n, next);
        }
    }
    best.1
}

/// Whether lines of tables are so near that chairs of two of them meet back to back.
fn crowded(places: &[Pose], cell: [f64; 2]) -> bool {
    let gap = |a: &Pose, b: &Pose| {
        let cell = if (a.yaw / 90.0).round() as i64 % 2 == 0 { cell } else { [cell[1], cell[0]] };
        ((a.x - b.x).abs() - cell[0]).max((a.z - b.z).abs() - cell[1])
    };
    places.iter().enumerate().any(|(i, a)| places[..i].iter().any(|b| gap(a, b) < BACKS))
}

/// Places that are a quarter turned: of tables with chairs at two of their sides that would otherwise stand in a single line,
/// and of racks in a room with a gate.
fn turned(
    plan: &Plan,
    noun: &str,
    size: [f64; 3],
    reach: [f64; 4],
    n: usize,
    toward: (bool, f64, f64),
) -> Option<Vec<Pose>> {
    let [left, right, back, front] = reach;
    let [w, _, d] = plan.draft.rooms[plan.room].size;
    // Aisles lead to the gate, before which is room to turn, or to where one pays.
    let tills = for_tills(plan).filter(|_| noun.ends_with("gondola"));
    let before = match () {
        () if toward.0 => None,
        () if noun.ends_with("rack") => gate(plan).map(|_| BEFORE_GATE),
        () => tills,
    };
    if let Some(before) = before {
        let beside = if tills.is_some() { BESIDE_WALLS } else { 0.0 };
        // Before tills and counters the aisle is counted already that is before a wall.
        let counters = for_counters(plan);
        let front = before - if tills.is_some() { BEFORE_RACKS } else { 0.0 };
        let behind = if tills.is_some() && counters > 0.0 { counters - BEFORE_RACKS } else { 0.0 };
        let places = grid(plan, [d - front - behind, w - beside], noun, size, reach, n, toward);
        // Rows of shelves before tills do not stand across.
        let places = if tills.is_some() { places.unwrap_or_default() } else { places? };
        let turned = Pose { yaw: 90.0, z: (front - behind) / 2.0, ..Pose::default() };
        return Some(places.iter().map(|at| turned.then(at)).collect());
    }
    let even = (left - right).abs() < 0.02 && (back - front).abs() < 0.02 && front > left + 0.1;
    if !even || n < SINGLE || stand::group(noun) != crate::brief::Group::Table {
        return None;
    }
    let lines = |places: &[Pose]| {
        let mut z: Vec<i64> = places.iter().map(|at| (at.z * 1000.0) as i64).collect();
        z.sort_unstable();
        z.dedup();
        z.len()
    };
    let upright = grid(plan, [w, d], noun, size, reach, n, toward).unwrap_or_default();
    let mut places = grid(plan, [w, d], noun, [size[2], size[1], size[0]], [back, front, left, right], n, toward)?;
    places.iter_mut().for_each(|at| at.yaw = (at.yaw + 90.0) % 360.0);
    (places.len() >= upright.len() && places.len() == n && lines(&upright) <= 1 && lines(&places) > 1).then_some(places)
}

/// So many tables in a single line look like a classroom.
const SINGLE: usize = 5;
/// Between racks and before the first of them (metres): where a lift truck passes, and where people walk.
const AISLES: [f64; 4] = [3.0, 2.7, 1.85, 1.2];
const WIDEST: f64 = 3.2;
/// Between the ends of racks and the walls (metres).
const BEFORE_RACKS: f64 = 1.0;
/// So many pallet racks stand back to back, with so much between the two (metres).
const BACK_TO_BACK: usize = 4;
const BEHIND_RACKS: f64 = 0.1;
/// Behind a gate so much is free of racks (metres).
const BEFORE_GATE: f64 = 2.2;
/// Shelves of a shop leave so much of its width to what stands along the walls (metres).
const BESIDE_WALLS: f64 = 1.2;
/// Between the backs of chairs of one table and those of the next.
const TABLES: f64 = 0.9;
/// What reaches farther from a table than this is a chair at it; chairs have this much between their backs (metres).
const SEATED: f64 = 0.3;
/// Around what is moved aside there is so much free.
const ROUND: f64 = 0.3;
const BACKS: f64 = 0.7;
/// Between the backs of chairs and the walls.
const BESIDE_TABLES: f64 = 0.7;
/// Between groups of desks.
const DESKS: f64 = 1.25;
/// More desks of a class than so many stand in pairs, with so much between the two; between pairs and between lines of them
/// are ways, one gets out to the side.
const PAIRED: usize = 8;
const BETWEEN: f64 = 0.02;
const PAIRS: [(f64, f64); 2] = [(0.9, 0.6), (0.8, 0.45)];
/// Between seats beside each other, where they stand in rows, and the least between one row's backs and the next row.
const SEATS: (f64, f64) = (0.06, 0.5);
/// The aisle in the middle of rows of so many seats or more.
const AISLE: (f64, usize) = (1.1, 6);
/// Tables are so far from each other at most (metres).
const SPREAD: f64 = 1.3;
/// How much farther from what is before them (metres) rows are tried that are asked for, where something is in their way.
const FARTHER: [f64; 5] = [0.0, NEARER, 0.5, 1.0, 1.5];
/// Between the desk of a teacher and the first row (metres).
const BEFORE_TEACHER: f64 = 0.9;
/// Rows begin so much nearer to what is before them where there is no room for all.
const NEARER: f64 = -0.7;
/// The aisle between pews, and what is between one and the back of the next.
const PEWS: (f64, f64) = (1.1, 0.36);
/// Where the floor is so many times what racks and their aisles take, they stand in rows of so many.
const ROOMY: f64 = 2.5;
const IN_SHORT_ROW: usize = 3;
/// What is looked at from all sides, and how much room is around it.
const EXHIBITED: [&str; 6] = ["sculpture", "statue", "pedestal", "plinth", "display case", "showcase"];
const EXHIBITS: f64 = 2.2;
/// At least so much: one gets past, and a case can be opened.
const BETWEEN_EXHIBITS: (f64, f64) = (0.9, 1.1);

/// Between two that one works at from all sides (metres).
const AROUND_CENTRAL: f64 = 1.4;
/// So many of them stand beside each other, with this much between what belongs to them and the walls (metres).
const BESIDE: usize = 2;
const BESIDE_CENTRAL: f64 = 0.5;
/// Between the wall that people on mats look at and the first row of mats (metres).
const BEFORE_MATS: f64 = 1.3;
/// Between a stage and the first row (metres).
const BEFORE_STAGE: f64 = 1.5;

/// Whether such rooms have it in their middle.
pub fn is_central(plan: &Plan, noun: &str) -> bool {
    let like = |line: &&Line| stand::counts_as(line.noun, noun);
    plan.kind.lines.iter().find(like).is_some_and(|line| line.place == PlanPlace::Middle)
}

/// The distance from one to the next of so many, if they are spread over what is free.
fn step(free: f64, cell: f64, count: usize, least: f64, spread: f64) -> f64 {
    let most = if count > 1 { (free - cell) / (count - 1) as f64 } else { 0.0 };
    most.min(cell + least.max(0.35 * cell).max(spread)).max(most.min(cell + least))
}

/// Places in columns and lines that look to the back of the room or away from it, so much farther from there than usual, and
/// so far from each other at most if they are tables.
fn grid(
    plan: &Plan,
    room: [f64; 2],
    noun: &str,
    size: [f64; 3],
    reach: [f64; 4],
    n: usize,
    how: (bool, f64, f64),
) -> Option<Vec<Pose>> {
    // Desks of a class stand in pairs, unless more have room one by one.
    let pairs = || cells(plan, room, noun, size, reach, (n, 2), how);
    let paired = if how.0 && n > PAIRED && is_desk(noun) { pairs() } else { None };
    let single = || cells(plan, room, noun, size, reach, (n, 1), how);
    if paired.as_ref().is_some_and(|places| places.len() >= n) {
        // An odd number has full lines only where each stands alone.
        let full = |places: &Vec<Pose>| places.len() >= n && lines_are_full(places);
        return single().filter(|places| n % 2 == 1 && full(places)).or(paired);
    }
    let single = single();
    [paired, single].into_iter().flatten().reduce(|best, next| if next.len() > best.len() { next } else { best })
}

/// Whether as many stand in each line.
fn lines_are_full(places: &[Pose]) -> bool {
    let mut lines: std::collections::BTreeMap<i64, usize> = std::collections::BTreeMap::new();
    places.iter().for_each(|at| *lines.entry((at.z * 1000.0).round() as i64).or_default() += 1);
    lines.values().all(|n| Some(n) == lines.values().next())
}

/// How much of the depth of a room is free before rows that look to the back; behind what is kept free before a counter there
/// is room for a line of tables at least, which leaves `most`.
fn before_rows(plan: &Plan, (flat, table): (bool, bool), depth: f64, most: f64) -> f64 {
    if flat {
        return BEFORE_MATS;
    }
    let counter = plan.kind.lines.iter().find_map(|line| match line.place {
        PlanPlace::Before(gap, yaw) if yaw == 180.0 && table => Some(gap + Plan::size(line.noun)[2] + 1.2),
        _ => None,
    });
    let has_stage = plan.draft.things.iter().any(|thing| thing.room == Some(plan.room) && thing.category == "stage");
    let at_back = |line: &&Line| line.noun == "stage" && matches!(line.place, PlanPlace::Back(_));
    let stage = plan.kind.lines.iter().find(at_back).filter(|_| has_stage);
    let ahead = stage.map_or(2.6_f64.min(0.33 * depth), |line| Plan::size(line.noun)[2] + BEFORE_STAGE);
    // One gets past between the teacher's desk and those who look at it.
    let taught = plan.kind.lines.iter().find_map(|line| match line.place {
        PlanPlace::Before(gap, 0.0) if is_desk(line.noun) => Some(gap + Plan::size(line.noun)[2] + BEFORE_TEACHER),
        _ => None,
    });
    counter.map_or(ahead.max(taught.unwrap_or(0.0)), |gap| gap.min(most.max(0.42 * depth)))
}

/// Between rows and the side walls (metres): one gets past, at tables behind pulled chairs.
fn beside((racks, central, tables): (bool, bool, bool)) -> f64 {
    match () {
        () if racks => BEFORE_RACKS,
        () if central => BESIDE_CENTRAL,
        () if tables => BESIDE_TABLES,
        () => 0.9,
    }
}

/// How much room is around what is looked at or worked at from all sides (metres).
fn around(plan: &Plan, noun: &str) -> f64 {
    match () {
        () if is_exhibited(noun) => EXHIBITS,
        () if is_central(plan, noun) => AROUND_CENTRAL,
        () => 0.0,
    }
}

fn is_exhibited(noun: &str) -> bool {
    EXHIBITED.iter().any(|end| noun.ends_with(end))
}

/// The ways between racks with such an aisle, and the narrower ones; a lift truck needs its width.
fn racks(aisle: f64) -> Vec<(f64, f64)> {
    let [wide, narrow, ..] = AISLES;
    let least = if aisle >= wide { narrow } else { 0.0 };
    AISLES.iter().filter(|narrower| (least..=aisle).contains(*narrower)).map(|aisle| (0.02, *aisle)).collect()
}

/// The aisle before racks of a width.
fn aisle(noun: &str, width: f64) -> f64 {
    let [wide, _, usual, narrowest] = AISLES;
    match width {
        _ if noun.ends_with("pallet rack") => wide,
        _ if width < 2.0 => narrowest,
        _ => usual,
    }
}

/// The same in cells of `each`.
fn cells(
    plan: &Plan,
    [w, d]: [f64; 2],
    noun: &str,
    size: [f64; 3],
    reach: [f64; 4],
    (n, each): (usize, usize),
    (toward, farther, widest): (bool, f64, f64),
) -> Option<Vec<Pose>> {
    let [left, right, back, front] = reach;
    let (one, own_d) = (left + right, back + front);
    let cell_w = if each == 2 { 2.0 * one + BETWEEN } else { one };
    // Pallet racks stand back to back, with an aisle for a lift truck before each.
    let roomy = w * d > ROOMY * n as f64 * size[0] * (size[2] + AISLES[0]);
    let deep = 1 + usize::from(noun.ends_with("pallet rack") && n >= BACK_TO_BACK && !roomy);
    let cell_d = deep as f64 * own_d + (deep - 1) as f64 * BEHIND_RACKS;
    let (each, n, asked) = (each * deep, n.div_ceil(each * deep), n);
    let flat = size[1] < 0.05;
    let rack = !toward && stand::group(noun) == crate::brief::Group::Storage || noun.ends_with("rack");
    let aisle_of_racks = aisle(noun, size[0]);
    let table = stand::group(noun) == crate::brief::Group::Table;
    let in_one_line = !table && n <= BESIDE && is_central(plan, noun);
    let side = beside((rack, in_one_line, table && (back - front).abs() < 0.1));
    let ahead = match toward {
        true => before_rows(plan, (flat, table), d, d - side - cell_d),
        false if rack => aisle_of_racks,
        false => side,
    } + farther;
    let (free_w, free_d) = (w - 2.0 * side, d - ahead - side);
    if cell_w > free_w || cell_d > free_d {
        return None;
    }
    // Ways of this width between the columns and the lines; narrower ones where there is no room for all.
    let narrow = (if cell_w > 1.9 { 0.75 } else { 0.45 }, if flat { 0.35 } else { 0.6 });
    let seat = stand::group(noun) == crate::brief::Group::Seat;
    let alone = seat && cell_w < 1.0 && (cell_d - size[2]).abs() < 0.02;
    let ways = match () {
        () if rack => racks(aisle_of_racks),
        () if each == 2 && deep == 1 => PAIRS.to_vec(),
        () if is_exhibited(noun) => vec![BETWEEN_EXHIBITS],
        () if table => vec![(TABLES, TABLES), narrow],
        () if alone => vec![SEATS],
        () if seat && (cell_d - size[2]).abs() < 0.02 => vec![PEWS, narrow],
        () => vec![narrow],
    };
    // Long rows of seats have an aisle in the middle.
    let aisle_of_seats =
        if alone && n >= 3 * AISLE.1 && free_w > AISLE.1 as f64 * cell_w + AISLE.0 { AISLE.0 } else { 0.0 };
    let free_w = free_w - aisle_of_seats;
    let counts = |(aisle, between): (f64, f64)| {
        let columns = (((free_w + aisle) / (cell_w + aisle)) as usize).max(1);
        // As many seats on one side of the aisle as on the other.
        let columns = if aisle_of_seats > 0.0 { columns & !1 } else { columns };
        let lines = (((free_d + between) / (cell_d + between)) as usize).max(1);
        (columns, if in_one_line { 1 } else { lines })
    };
    let enough = ways.iter().find(|way| counts(**way).0 * counts(**way).1 >= n).or(ways.last());
    let (aisle, between) = *enough?;
    let (columns, lines) = counts((aisle, between));
    let n = n.min(columns * lines);
    // As square as the room; racks stand in long rows.
    let square = if rack { 1 } else { ((n as f64 * free_d / free_w).sqrt().round() as usize).clamp(1, lines) };
    let halves = 1 + usize::from(aisle_of_seats > 0.0);
    let lines_used = match n.div_ceil(columns).max(square) {
        // A few racks in a large hall stand in several rows, not in one line.
        used if rack && roomy => used.max(n.div_ceil(IN_SHORT_ROW)).min(lines),
        used if rack => used,
        used => full_lines(n, [columns, lines], used, (halves, if alone { 2 } else { 1 })),
    };
    let columns_used = n.div_ceil(lines_used).next_multiple_of(halves);
    let spread = match () {
        () if each == 2 && deep == 1 => widest.min(PAIRS[0].0),
        () if table => widest,
        () => around(plan, noun),
    };
    let step_x = if rack || alone { cell_w + aisle } else { step(free_w, cell_w, columns_used, aisle, spread) };
    let step_z = step(free_d, cell_d, lines_used, between, if rack { WIDEST } else { spread });
    // The middle of the rows, the group's own middle apart.
    let mid_z = (side - ahead) / 2.0 - if toward { 0.0 } else { (front - back) / 2.0 };
    // Who sits at a desk looks over its back; who sits on a seat, the way that faces.
    let yaw = if toward && !seat { 180.0 } else { 0.0 };
    // Servers draw cold air from one aisle and blow it out into the next.
    let alternate = noun.ends_with("server rack");
    let off = if toward { (front - back) / 2.0 } else { 0.0 };
    // A short last line keeps to the columns.
    let place = |i: usize| {
        let unit = i / each;
        let (in_pair, behind) = if deep == 2 { (0, i % each) } else { (i % each, 0) };
        let (column, line) = (unit % columns_used, unit / columns_used);
        let x = (column as f64 - (columns_used as f64 - 1.0) / 2.0) * step_x;
        let x = x + if 2 * column < columns_used { -0.5 } else { 0.5 } * aisle_of_seats;
        let x = x + (in_pair as f64 - ((each / deep) as f64 - 1.0) / 2.0) * (one + BETWEEN);
        let z = mid_z + off - (line as f64 - (lines_used as f64 - 1.0) / 2.0) * step_z;
        let z = z + (behind as f64 - (deep as f64 - 1.0) / 2.0) * (own_d + BEHIND_RACKS);
        let yaw = if alternate && line % 2 == 0 || deep == 2 && behind == 0 { 180.0 } else { yaw };
        Pose { x, y: 0.0, z, yaw }
    };
    Some((0..asked.min(each * n)).map(place).collect())
}

/// Full lines rather than a short last one, where that takes up to `wider` more or less lines than wanted.
fn full_lines(n: usize, [columns, lines]: [usize; 2], wanted: usize, (halves, wider): (usize, usize)) -> usize {
    let full = |used: &usize| (1..=lines).contains(used) && n.is_multiple_of(halves * *used) && n / used <= columns;
    let mut near = (0..=wider).flat_map(|by| [wanted + by, wanted.saturating_sub(by)]);
    near.find(full).unwrap_or(wanted)
}

/// Desks that face each other in groups, spread over the floor; `front` is how far one reaches with its chair.
/// `aside`: on the left, and no wider apart than needed.
fn pairs([w, d]: [f64; 2], size: [f64; 3], front: f64, (n, aside): (usize, bool)) -> Option<Vec<Pose>> {
    const WIDEST: [f64; 2] = [2.2, DESKS];
    const BESIDE: f64 = 0.9;
    const BEHIND_CHAIRS: f64 = 0.7;
    // In groups of four, or of six where those have no seat left over.
    let each = if n % 4 == 2 && n.is_multiple_of(6) { 3 } else { 2 };
    let groups = n.div_ceil(2 * each);
    let (wide, deep) = (each as f64 * size[0] + 0.02, 2.0 * front + size[2] + 0.02);
    let (free_w, free_d) = (w - 2.0 * BESIDE, d - 2.0 * BEHIND_CHAIRS);
    if wide > free_w || deep > free_d {
        return None;
    }
    let columns = (((free_w + DESKS) / (wide + DESKS)) as usize).min(groups);
    let lines = groups.div_ceil(columns);
    if lines as f64 * (deep + 0.6) - 0.6 > free_d {
        return None;
    }
    let step = |free: f64, cell: f64, count: usize| {
        if count > 1 { ((free - cell) / (count - 1) as f64).min(cell + WIDEST[usize::from(aside)]) } else { 0.0 }
    };
    let (step_x, step_z) = (step(free_w, wide, columns), step(free_d, deep, lines));
    let off = if aside { (free_w - wide - (columns - 1) as f64 * step_x) / 2.0 } else { 0.0 };
    let place = |i: usize| {
        let (group, seat) = (i / (2 * each), i % (2 * each));
        let x = ((group % columns) as f64 - (columns as f64 - 1.0) / 2.0) * step_x - off;
        let z = ((lines as f64 - 1.0) / 2.0 - (group / columns) as f64) * step_z;
        let across = ((seat / 2) as f64 - (each as f64 - 1.0) / 2.0) * (size[0] + 0.02);
        let back = if seat % 2 == 0 { 1.0 } else { -1.0 };
        let yaw = if seat % 2 == 0 { 0.0 } else { 180.0 };
        Pose { x: x + across, y: 0.0, z: z + back * (size[2] / 2.0 + 0.01), yaw }
    };
    Some((0..n).map(place).collect())
}

impl Plan<'_> {
    /// How far a thing and what stands around it reach to the left, the right, the back and the front of its middle. Not each
    /// of several has a bin.
    pub(super) fn reach(&self, noun: &str, of: [f64; 3]) -> [f64; 4] {
        let mut out = [of[0] / 2.0, of[0] / 2.0, of[2] / 2.0, of[2] / 2.0];
        // Seats that are asked for stand there, too.
        let here = || self.draft.things.iter().filter(|t| t.room == Some(self.room) && t.count > 1);
        let asked = |noun: &str| here().any(|t| stand::counts_as(noun, &t.category.replace('_', " ")));
        for part in groups::of(noun, self.kind.dress)
            .iter()
            .filter(|p| (!self.is_closed(p.noun) || asked(p.noun)) && p.noun != "bin" && self.counted >= p.least)
        {
            let own = part.size.unwrap_or_else(|| Plan::size(part.noun));
            let sizes = super::slots::Sizes { of, own, round: stand::round(noun, &[]) };
            for slot in super::slots::slots(&part.at, &sizes, &[]) {
                if slot.level != super::slots::Level::Floor || own[1] < 0.05 {
                    continue;
                }
                let turned = (slot.yaw / 90.0).round() as i64 % 2 != 0;
                let (half_w, half_d) = if turned { (own[2] / 2.0, own[0] / 2.0) } else { (own[0] / 2.0, own[2] / 2.0) };
                out[0] = out[0].max(half_w - slot.x);
                out[1] = out[1].max(half_w + slot.x);
                out[2] = out[2].max(half_d - slot.z);
                out[3] = out[3].max(half_d + slot.z);
            }
        }
        out
    }
}
