//! Many bookshelves stand as in libraries: in double rows, back to back, with aisles between them. Shelves and racks of which
//! the request gives the number of rows stand in these as one block, and so do tables of which it gives the groups.

use super::build::Root;
use super::floor::{Floor, Footprint, Pose, Shape};
use super::plan::{AtWall, Plan};
use super::{place, seek, stand};
use crate::brief::Group;

/// So many shelves stand at the walls.
const AT_WALLS: usize = 12;
/// Between double rows, and around all of them, where people walk and choose (metres).
const AISLE: f64 = 1.1;
const AROUND: f64 = 0.9;
/// Between shelves beside each other, and between their backs.
const JOINT: f64 = 0.01;
/// A row has so many shelves.
const ROW: std::ops::RangeInclusive<usize> = 3..=8;
const WHY: &str = "shelves stand back to back in rows";

/// Whether a thing is many shelves of a library, and nothing is said of where they are.
pub fn are_many(plan: &Plan, thing: usize) -> bool {
    let it = &plan.draft.things[thing];
    it.count > AT_WALLS
        && plan.kind.dress == "library"
        && stand::group(&it.category) == Group::Storage
        && stand::has_back(&it.category)
        && plan.draft.rooms[plan.room].outline.is_none()
        && !stand::placed(plan.draft, &it.name)
}

/// Gives them their places. Whether there is room for all.
pub fn stand_up(plan: &mut Plan, thing: usize) -> bool {
    let it = plan.draft.things[thing].clone();
    let Some(size) = it.size else { return false };
    let Some(places) = places(plan, thing, arrangements(it.count, size), &[0.0, 90.0]) else { return false };
    let room = plan.room_name();
    let at = |(i, at): (usize, &Pose)| place::absolute(&format!("{}[{i}]", it.name), &room, [at.x, at.y, at.z], at.yaw);
    let each: Vec<String> = places.iter().enumerate().map(at).collect();
    plan.say(format!("assert {};", each.join(" and ")), WHY);
    put(plan, thing, &places)
}

/// Puts shelves where the request gives their rows, and tables where it gives their groups. Whether it does, and there is
/// room for all.
pub fn in_formation(plan: &mut Plan, thing: usize) -> bool {
    let it = plan.draft.things[thing].clone();
    let group = stand::group(&it.category);
    let is_turned = it.formation.iter().any(|[.., yaw]| *yaw != 0.0);
    let in_groups = group == Group::Table && is_turned;
    // Machines in two rows face each other.
    let faces = group == Group::Floor && is_turned;
    let has_corners = plan.draft.rooms[plan.room].outline.is_some();
    let (Some(size), false, true) = (
        it.size,
        it.formation.is_empty() || has_corners,
        matches!(group, Group::Storage | Group::Seat) || in_groups || faces,
    ) else {
        return false;
    };
    // With what stands at each.
    let [_, _, back, front] = if in_groups {
        plan.reach(&it.category.replace('_', " "), size)
    } else {
        [size[0] / 2.0, size[0] / 2.0, size[2] / 2.0, size[2] / 2.0]
    };
    let (mut least, mut most) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for [x, z, yaw] in &it.formation {
        let [behind, before] = if *yaw == 0.0 { [back, front] } else { [front, back] };
        least = [least[0].min(x - size[0] / 2.0), least[1].min(z - behind)];
        most = [most[0].max(x + size[0] / 2.0), most[1].max(z + before)];
    }
    let middle = [0, 1].map(|k| (least[k] + most[k]) / 2.0);
    let place = |[x, z, yaw]: &[f64; 3]| Pose { x: x - middle[0], z: z - middle[1], yaw: *yaw, ..Pose::default() };
    let block = [most[0] - least[0], size[1], most[1] - least[1]];
    let all = vec![(block, it.formation.iter().map(place).collect())];
    let Some(places) = places(plan, thing, all, &[0.0]) else {
        // They want a larger room.
        plan.lacking += it.count;
        return false;
    };
    put(plan, thing, &places)
}

/// Places on the floor for the first of some arrangements that has one, with room around it.
fn places(plan: &Plan, thing: usize, arrangements: Vec<([f64; 3], Vec<Pose>)>, yaws: &[f64]) -> Option<Vec<Pose>> {
    let floor = plan.ground.as_ref()?;
    arrangements.into_iter().find_map(|(block, local)| {
        let piece = Footprint { thing, at: Pose::default(), size: block, flat: false, tall: true };
        let around = [block[0] + 2.0 * AROUND, block[1], block[2] + 2.0 * AROUND];
        let shape = Shape { pieces: vec![piece], free: vec![(Pose::default(), around)], ..Shape::default() };
        let places = seek::on_floor(floor.size, around, yaws).into_iter();
        let at = seek::best(floor, &shape, places, &|at| Some(-floor.away_from_door(at)))?;
        Some(local.iter().map(|shelf| at.then(shelf)).collect())
    })
}

fn put(plan: &mut Plan, thing: usize, places: &[Pose]) -> bool {
    let it = &plan.draft.things[thing];
    let (Some(size), n) = (it.size, it.count) else { return false };
    plan.take([size[0], size[1], size[2] + AISLE / 2.0], n, false);
    let seek = |_: &Floor, _: &Shape, before: &[Pose]| places.get(before.len()).copied();
    let root = Root { n, frames: vec![Pose::default()], wall: AtWall::No, free: Vec::new(), whole: false, seek: &seek };
    plan.place_asked(thing, &root)
}

/// Ways to stand in double rows: the size of the whole, and the places seen from its middle; full rows and those that are as
/// deep as wide come first.
fn arrangements(n: usize, [w, h, d]: [f64; 3]) -> Vec<([f64; 3], Vec<Pose>)> {
    let mut all: Vec<(bool, f64, [f64; 3], Vec<Pose>)> = ROW
        .map(|row| {
            let pairs = n.div_ceil(2 * row);
            let (wide, step) = (row as f64 * (w + JOINT) - JOINT, 2.0 * d + JOINT + AISLE);
            let deep = (pairs - 1) as f64 * step + 2.0 * d + JOINT;
            let place = |i: usize| {
                let (line, column) = (i / row, i % row);
                let front = line % 2 == 0;
                let middle = ((line / 2) as f64 - (pairs as f64 - 1.0) / 2.0) * step;
                Pose {
                    x: (column as f64 - (row as f64 - 1.0) / 2.0) * (w + JOINT),
                    y: 0.0,
                    z: middle + if front { 0.5 } else { -0.5 } * (d + JOINT),
                    yaw: if front { 0.0 } else { 180.0 },
                }
            };
            (!n.is_multiple_of(2 * row), (wide - deep).abs(), [wide, h, deep], (0..n).map(place).collect())
        })
        .collect();
    all.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    all.into_iter().map(|(_, _, block, places)| (block, places)).collect()
}
