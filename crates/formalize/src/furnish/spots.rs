//! Where things of a room stand that have a place of their own: the part for those who work behind a counter, what is kept
//! free, the place that is meant and the nearest one to it.

use super::choose::{self, Choice, Staff};
use super::daylight::window_walls;
use super::floor::{Block, Floor, Footprint, Pose, Shape};
use super::kinds::{Line, PlanPlace};
use super::plan::Plan;
use super::rows::is_desk;
use super::seek::Wall;
use super::{even, gates, stand};
use crate::brief::Group;
use std::cell::RefCell;

/// Before a counter so much is free (metres).
pub(super) const SERVED: f64 = 1.15;

/// From a dartboard to the line from which one throws (metres; World Darts Federation: 2.37).
const THROW: f64 = 2.4;
/// Behind a counter so much is for who works there, where there is no room for more (metres).
const BEHIND: f64 = 0.9;
/// What is narrower is a stand, and no counter.
pub(super) const STAND: f64 = 1.0;

/// The part of a room in which someone works behind a counter; `None`: nobody does.
pub(super) fn staffed(plan: &Plan) -> Option<Staff> {
    /// Beside a desk that visitors come to so much is for who works there, and as much more behind the chair (metres).
    const BESIDE: f64 = 1.8;
    const BEYOND: f64 = 0.3;
    let [_, height, depth] = plan.draft.rooms[plan.room].size;
    plan.kind.lines.iter().find_map(|line| match line.place {
        // Not at a counter that is there only if it is asked for.
        PlanPlace::Before(..) if line.least > plan.counted && near_to(plan, line.noun).is_none() => None,
        PlanPlace::Before(gap, 180.0) => {
            let usual = depth / 2.0 - gap - Plan::size(line.noun)[2];
            let at = near_to(plan, line.noun);
            Some(Staff::Beyond(at.map_or(usual, |at| at.z - Plan::size(line.noun)[2] / 2.0)))
        }
        PlanPlace::Service(gap) if Plan::size(line.noun)[0] >= STAND => {
            let at = near_to(plan, line.noun)?;
            let [wide, _, deep] = Plan::size(line.noun);
            let behind = Pose { z: -(gap + BEYOND) / 2.0, ..Pose::default() };
            let size = [wide + 2.0 * BESIDE, height, deep + gap + BEYOND];
            Some(Staff::Around(Block::of(&at.then(&behind), size)))
        }
        _ => None,
    })
}

/// The place of what someone sits or lies on who looks at something.
pub(super) fn watched_from(plan: &Plan) -> Option<Pose> {
    let seat = plan.draft.things.iter().filter(|t| t.room == Some(plan.room));
    let mut seat = seat.filter(|t| choose::seats(&t.category.replace('_', " ")));
    let seat = seat.next()?;
    if seat.count == 1 {
        return plan.place_in_room(&seat.name);
    }
    // From the middle of several that look the same way.
    let places: Vec<Pose> =
        (0..seat.count).filter_map(|i| plan.place_in_room(&format!("{}[{i}]", seat.name))).collect();
    let first = *places.first()?;
    match places[..] {
        // Of two in a corner, and of three around a table, from the first.
        [one, ref others @ ..]
            if !others.is_empty() && others.iter().all(|other| (one.yaw - other.yaw).rem_euclid(180.0) == 90.0) =>
        {
            return Some(one);
        }
        _ if places.iter().any(|p| p.yaw != first.yaw) => return None,
        _ => {}
    }
    let mean = |of: fn(&Pose) -> f64| places.iter().map(of).sum::<f64>() / places.len() as f64;
    Some(Pose { x: mean(|p| p.x), z: mean(|p| p.z), ..first })
}

/// From the middle between two seats that face each other, to one of the sides.
pub(super) fn beside_pair(plan: &Plan) -> Option<Pose> {
    let here = plan.draft.things.iter().filter(|t| t.room == Some(plan.room) && t.count == 2);
    let seats = here.filter(|t| choose::seats(&t.category.replace('_', " ")));
    seats.into_iter().find_map(|t| {
        let [first, second] = [0, 1].map(|i| plan.place_in_room(&format!("{}[{i}]", t.name)));
        let (first, second) = (first?, second?);
        let faces = (first.yaw - second.yaw).rem_euclid(360.0) == 180.0;
        let middle = |of: fn(&Pose) -> f64| (of(&first) + of(&second)) / 2.0;
        faces.then(|| Pose { x: middle(|p| p.x), z: middle(|p| p.z), yaw: (first.yaw + 90.0) % 360.0, ..first })
    })
}

/// Where the beds of the room are.
pub(super) fn beds(plan: &Plan) -> Vec<Pose> {
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
    // Two people who share a workroom sit side by side.
    let desks = n == 2 && is_desk(choice.noun);
    let lies = ["bed", "lounger"].iter().any(|end| choice.noun.ends_with(end));
    if n < 2 || !(in_run || desks || lies) {
        return None;
    }
    let is_close = desks || stand::is_unit(choice.noun, n);
    if before.is_empty() {
        row.replace(
            even::places(floor, shape, n, (choice.size[2], is_close), choice.windows, &|at| !choice.is_misplaced(at))
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

/// The next place of several counters at which guests are served: side by side, with a lane between two; `row` keeps all of
/// them.
pub(super) fn lanes(
    choice: &Choice,
    floor: &Floor,
    shape: &Shape,
    before: &[Pose],
    (n, behind): (usize, f64),
    row: &RefCell<Vec<Pose>>,
) -> Option<Pose> {
    const LANE: f64 = 0.9;
    const NO_LANE: f64 = 0.02;
    let single = || choice.service(floor, shape, behind).or_else(|| choice.service(floor, shape, BEHIND));
    if n < 2 {
        return single();
    }
    if before.is_empty()
        && let Some(places) = belts(choice, floor, shape, n)
    {
        row.replace(places);
    } else if before.is_empty() {
        let side_by_side = |lane: f64| {
            let frame = |i: usize| Pose { x: i as f64 * (choice.size[0] + lane), ..Pose::default() };
            let mut whole = Shape::default();
            for at in (0..n).map(frame) {
                whole.pieces.extend(shape.pieces.iter().map(|piece| Footprint { at: at.then(&piece.at), ..*piece }));
                whole.free.extend(shape.free.iter().map(|(pose, size)| (at.then(pose), *size)));
            }
            let first = choice.service(floor, &whole, behind)?;
            Some((0..n).map(|i| first.then(&frame(i))).collect::<Vec<_>>())
        };
        row.replace([LANE, NO_LANE].into_iter().find_map(side_by_side).unwrap_or_default());
    }
    row.borrow().get(before.len()).copied().or_else(single)
}

/// So far from the wall with the door the belts of tills end, and so wide is the lane between two of them (metres).
const BEFORE_DOOR: [f64; 3] = [1.9, 1.6, 2.4];
const TILL_LANE: f64 = 0.95;
/// Between the tills and the wall at the side of the door (metres): the way in, beside carts.
const WAY_IN: f64 = 2.2;

/// Places of several tills side by side, whose belts lead from the shelves towards the door at the front of the room.
fn belts(choice: &Choice, floor: &Floor, shape: &Shape, n: usize) -> Option<Vec<Pose>> {
    let [w, _, d] = floor.size;
    if !choice.noun.ends_with("checkout lane") || floor.door_beyond(2, -d / 2.0) > BEFORE_DOOR[0] {
        return None;
    }
    let [.., back, front] = super::seek::reach(shape);
    let pitch = back + front + TILL_LANE;
    let frame = |i: usize| Pose { z: i as f64 * pitch, ..Pose::default() };
    let mut whole = Shape::default();
    for at in (0..n).map(frame) {
        whole.pieces.extend(shape.pieces.iter().map(|piece| Footprint { at: at.then(&piece.at), ..*piece }));
    }
    let along = (n - 1) as f64 * pitch / 2.0;
    let steps = (-(w * 5.0) as i32..=(w * 5.0) as i32).map(|i| f64::from(i) * 0.1);
    // Goods are laid on the belt at the end that is to the right of the front.
    let places = steps.flat_map(|middle| {
        BEFORE_DOOR.into_iter().map(move |off| {
            let z = off + choice.size[0] / 2.0 - d / 2.0;
            Pose { x: middle + along, y: 0.0, z, yaw: 270.0 }
        })
    });
    let cost = |pose: &Pose| {
        let middle = pose.then(&Pose { z: along, ..Pose::default() });
        // One comes in beside them.
        let to_door = floor.first_door().map_or(0.0, |[x, _]| x.signum());
        let beside = WAY_IN - (w / 2.0 - to_door * middle.x - along - back.max(front));
        Some(2.0 * beside.max(0.0) + middle.x.abs() + (pose.z - choice.size[0] / 2.0 + d / 2.0 - BEFORE_DOOR[0]).abs())
    };
    let first = super::seek::best(floor, &whole, places, &cost)?;
    Some((0..n).map(|i| first.then(&frame(i))).collect())
}

/// How much of the depth of a shop is for its tills, before its shelves begin; `None`: it has none.
pub(super) fn for_tills(plan: &Plan) -> Option<f64> {
    const AISLE: f64 = 1.5;
    const USUAL: f64 = 3.2;
    let line = plan.kind.lines.iter().find(|line| matches!(line.place, PlanPlace::Service(_)))?;
    let [w, h, d] = Plan::size(line.noun);
    let Some(at) = near_to(plan, line.noun) else {
        let is_lane = line.noun.ends_with("checkout lane") && !plan.is_closed(line.noun);
        return Some(if is_lane { BEFORE_DOOR[0] + w + AISLE } else { USUAL });
    };
    let is_along = (at.yaw / 90.0).round() as i64 % 2 != 0;
    let depth = plan.draft.rooms[plan.room].size[2];
    Some(if is_along { Block::of(&at, [w, h, d]).high[2] + AISLE + depth / 2.0 } else { USUAL })
}

/// How much of the depth of a shop is for the counters before its back wall and those who are served there.
pub(super) fn for_counters(plan: &Plan) -> f64 {
    let depth = plan.draft.rooms[plan.room].size[2];
    let lines = plan.kind.lines.iter().filter(|line| matches!(line.place, PlanPlace::Before(_, 180.0)));
    let fronts = lines.filter_map(|line| Some((near_to(plan, line.noun)?, Plan::size(line.noun)[2])));
    let depths = fronts.map(|(at, deep)| depth / 2.0 - at.z + deep / 2.0 + SERVED);
    depths.fold(0.0, f64::max)
}

/// Where the wide door of the room is, if it has one.
pub(super) fn gate(plan: &Plan) -> Option<Pose> {
    let door = plan.draft.openings.iter().find(|o| o.category.as_deref() == Some(gates::GATE))?;
    plan.place_in_room(&door.name)
}

/// Behind several tills, where one has paid, nothing is for sale.
pub(super) fn keep_exit(plan: &mut Plan, tills: &[Pose], size: [f64; 3]) {
    let Some(ground) = &mut plan.ground else { return };
    let Some(till) = tills.first() else { return };
    let [w, _, d] = ground.size;
    let way = Block::of(till, size);
    // Guests come to the front of a till, or pass between two, and leave toward the door.
    // Between belts one passes along them.
    let is_turned = (till.yaw / 90.0).round() as i64 % 2 != 0;
    let are_belts = tills.get(1).is_some_and(|next| ((next.x - till.x).abs() > (next.z - till.z).abs()) == is_turned);
    let across = if is_turned == are_belts { 2 } else { 0 };
    let half = [w, 0.0, d][across] / 2.0;
    let toward_door = ground.door_beyond(across, (way.low[across] + way.high[across]) / 2.0);
    let (low, high) = if toward_door > 0.0 { (way.high[across], half) } else { (-half, way.low[across]) };
    let (middle, deep) = ((low + high) / 2.0, (high - low).max(0.1));
    // In the corners there is room for carts and baskets.
    const CORNERS: f64 = 1.0;
    let (at, size) = match across {
        2 => (Pose { z: middle, y: 0.05, ..Pose::default() }, [(w - 2.0 * CORNERS).max(0.1), 1.8, deep]),
        _ => (Pose { x: middle, y: 0.05, ..Pose::default() }, [deep, 1.8, (d - 2.0 * CORNERS).max(0.1)]),
    };
    ground.keep(&at, size);
    let whole = match across {
        2 => [w, size[1], deep],
        _ => [deep, size[1], d],
    };
    plan.exit = Some(Block::of(&at, whole));
}

/// Where the door to a room of a kind is.
fn door_to(plan: &Plan, kind: &str) -> Option<Pose> {
    let is = |room: &usize| *room != plan.room && plan.draft.rooms[*room].kind.ends_with(kind);
    let door = plan.draft.openings.iter().find(|o| o.rooms.contains(&plan.room) && o.rooms.iter().any(is))?;
    plan.place_in_room(&door.name)
}

/// What is kept free around a thing of the inventory, in its frame: behind a counter for who works there, before it for who
/// is served, beside it for the way there; beside what hangs.
pub(super) fn kept(line: &Line, size: [f64; 3], hung: bool, beside: f64) -> Vec<(Pose, [f64; 3])> {
    let [w, _, d] = size;
    let at = |x: f64, y: f64, z: f64| Pose { x, y, z, yaw: 0.0 };
    if hung {
        return around_hung(line.noun, size, beside);
    }
    if line.noun.ends_with("car") {
        // Its doors open, and one walks round it.
        let (side, end) = (0.6, 0.3);
        let beside = |x: f64| (at(x * (w + side) / 2.0, 0.05, 0.0), [side, 1.0, 0.8 * d]);
        let ends = |z: f64| (at(0.0, 0.05, z * (d + end) / 2.0), [w, 1.0, end]);
        return vec![beside(-1.0), beside(1.0), ends(-1.0), ends(1.0)];
    }
    let behind = match line.place {
        PlanPlace::Service(gap) => gap - 0.02,
        PlanPlace::Before(gap, 180.0) => gap - 0.5,
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

/// What is kept free around something on a wall: so much beside it, and where one throws at it.
pub(super) fn around_hung(noun: &str, [w, h, d]: [f64; 3], beside: f64) -> Vec<(Pose, [f64; 3])> {
    // Mirrors of a studio make one wall.
    let beside = if noun.ends_with("gym mirror") { 0.0 } else { beside };
    let around = (Pose { y: -1.4 * beside, ..Pose::default() }, [w + 2.0 * beside, h + 1.4 * beside, d]);
    let throw = Pose { y: -1.0, z: (d + THROW) / 2.0, ..Pose::default() };
    let thrown_at = noun.ends_with("dartboard").then_some((throw, [0.9, 1.5, THROW]));
    [around].into_iter().chain(thrown_at).collect()
}

/// At both ends of a run whose elements stand apart as much is kept free as between them.
pub(super) fn ends([w, h, d]: [f64; 3], gap: f64, n: usize) -> Vec<(Pose, [f64; 3])> {
    let beside = |x: f64| (Pose { x, y: 0.05, ..Pose::default() }, [gap, h, d]);
    let last = (n - 1) as f64 * (w + gap);
    if gap > 0.1 { vec![beside(-(w + gap) / 2.0), beside(last + (w + gap) / 2.0)] } else { Vec::new() }
}

/// Of places along a line, the nearest to the one that is meant.
pub(super) fn near(line: &Line, floor: &Floor, shape: &Shape, nominal: Pose) -> Option<Pose> {
    let car = line.noun.ends_with("car");
    let far = if car { 0.5 } else { 2.0 };
    // At a wall at the side "along" is to the back and to the front.
    let sideways = nominal.yaw == 90.0 || nominal.yaw == 270.0;
    let sideways = sideways && (car || matches!(line.place, PlanPlace::Back(_) | PlanPlace::Front(_)));
    let off = |i: i32, k: i32| match (0.15 * f64::from(i), 0.15 * f64::from(k)) {
        (along, off) if sideways => Pose { x: nominal.x + off, z: nominal.z + along, ..nominal },
        (along, off) => Pose { x: nominal.x + along, z: nominal.z - off, ..nominal },
    };
    let further = match line.place {
        PlanPlace::Before(..) => 0..=6,
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

/// Whether it comes in through the gate, or what does drives onto it.
pub(super) fn is_driven_in(noun: &str) -> bool {
    noun.ends_with("car") || noun.ends_with("car lift") || noun.ends_with("car_lift") || noun == "lift"
}

/// Whether something is in a wall at the left or the right.
fn is_sideways(at: &Pose) -> bool {
    matches!(Wall::behind(at), Some(Wall::Left | Wall::Right))
}

/// Where a thing of an inventory should stand that has its place in the room.
pub(super) fn nominal(plan: &Plan, line: &Line, size: [f64; 3], y: f64) -> Pose {
    let [width, _, depth] = plan.draft.rooms[plan.room].size;
    let middle_yaw = if (width >= depth) == (size[0] >= size[2]) { 0.0 } else { 90.0 };
    match &line.place {
        // Who sits at the long sides of a table looks at one of its ends.
        PlanPlace::Back(0.0) if width > depth && has_table(plan) && stand::group(line.noun) == Group::Screen => {
            let windows = window_walls(plan);
            let wall = if windows.contains(&Wall::Right) { Wall::Left } else { Wall::Right };
            Pose { y, ..wall.place([width, 0.0, depth], 0.0, size[2] / 2.0) }
        }
        PlanPlace::Back(share) => {
            Pose { x: share * (width - size[0]) / 2.0, y, z: (depth - size[2]) / 2.0, yaw: 180.0 }
        }
        PlanPlace::Front(share) => Pose { x: share * (width - size[0]) / 2.0, y, z: (size[2] - depth) / 2.0, yaw: 0.0 },
        PlanPlace::Before(gap, yaw) => {
            let x = line.gap * (width - size[0]) / 2.0;
            Pose { x, y: 0.0, z: (depth - size[2]) / 2.0 - gap, yaw: *yaw }
        }
        _ => match gate(plan).filter(|_| is_driven_in(line.noun)) {
            Some(gate) if is_sideways(&gate) => Pose { z: gate.z, yaw: 90.0, ..Pose::default() },
            Some(gate) => Pose { x: gate.x, ..Pose::default() },
            None => Pose { yaw: middle_yaw, ..Pose::default() },
        },
    }
}

/// Whether such a room has a table in its middle.
pub(super) fn has_table(plan: &Plan) -> bool {
    plan.kind.lines.iter().any(|line| line.place == PlanPlace::Middle && stand::group(line.noun) == Group::Table)
}

/// The place of the first thing of this name in the room; of several, their middle.
pub(super) fn near_to(plan: &Plan, noun: &str) -> Option<Pose> {
    match noun {
        "gate" => return gate(plan),
        "kitchen" => return door_to(plan, noun),
        _ => {}
    }
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
