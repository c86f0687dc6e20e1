//! Of a layout that repairs, the part that is needed: objects go back to where they were, wholly if all that is wanted
//! still holds, else as far as it does; then to round numbers.

use super::moves::changes;
use super::room::RepairSearch;
use crate::problem::pose::round_to;
use crate::problem::pose::{Pose, half_turn, round_turn};
use scenelang_engine::candidate::Change;
use scenelang_lang::program::ObjectId;

/// So often a way is halved; where a look is dear, so often.
const HALVINGS: [usize; 2] = [12, 5];
/// Work for all of it, where each look is dear.
const WORK: u64 = 30_000_000;
/// Passes over all objects that have moved.
const PASSES: usize = 3;
/// Grids for lengths (metres), and for angles (degrees).
const GRIDS: [(f64, f64); 3] = [(0.01, 1.0), (0.001, 0.1), (0.0001, 0.01)];

/// Takes back what is not needed of the layout under search, in which all that is wanted holds; as far as the work goes,
/// where each look is dear.
pub(super) fn shrink(room: &mut RepairSearch<'_, '_>) {
    room.allow(WORK);
    for _ in 0..PASSES {
        let before = room.moved().len();
        // The farthest first: it is the most likely to have been moved for no reason.
        let mut moved = room.moved();
        let way = |room: &RepairSearch<'_, '_>, id: ObjectId| room.travel(id, &room.search.state.pose(id));
        moved.sort_by(|a, b| way(room, *b).total_cmp(&way(room, *a)).then(a.cmp(b)));
        for id in moved {
            home(room, id);
        }
        if room.moved().len() == before {
            break;
        }
    }
    let moved = room.moved();
    towards(room, &moved);
    // What another one carries goes where that goes.
    let carried = room.carried(&moved);
    let leaders: Vec<ObjectId> = moved.iter().copied().filter(|id| !carried.contains(id)).collect();
    for &id in leaders.iter().filter(|_| leaders.len() > 1) {
        let mut group = vec![id];
        group.extend(room.search.state.riders(id).into_iter().filter(|o| carried.contains(o)));
        towards(room, &group);
    }
    for id in leaders {
        round(room, id);
    }
}

/// Puts an object back, alone or with what stands on it.
fn home(room: &mut RepairSearch<'_, '_>, id: ObjectId) -> bool {
    let pose = room.poses[id.0 as usize];
    if room.hold(&[Change::Object(id, pose)]) {
        return true;
    }
    let riders = room.search.state.riders(id);
    let all: Vec<(ObjectId, Pose)> = std::iter::once(id).chain(riders).map(|o| (o, room.poses[o.0 as usize])).collect();
    all.len() > 1 && room.hold(&changes(&all))
}

/// Moves objects back together, each by the same part of its way.
fn towards(room: &mut RepairSearch<'_, '_>, objects: &[ObjectId]) {
    let ways: Vec<(ObjectId, Pose, Pose)> =
        objects.iter().map(|&id| (id, room.poses[id.0 as usize], room.search.state.pose(id))).collect();
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS[usize::from(room.dear)] {
        let middle = (low + high) / 2.0;
        let at: Vec<(ObjectId, Pose)> = ways.iter().map(|(id, a, b)| (*id, between(a, b, middle))).collect();
        if room.hold(&changes(&at)) {
            high = middle;
        } else {
            low = middle;
        }
    }
}

/// A pose on the way from one to another.
fn between(a: &Pose, b: &Pose, part: f64) -> Pose {
    let mut pose = *b;
    pose.pos = a.pos + (b.pos - a.pos) * part;
    for i in 0..3 {
        let turn = half_turn(b.rot[i] - a.rot[i]);
        if turn != 0.0 {
            pose.rot[i] = if part == 1.0 { b.rot[i] } else { round_turn(a.rot[i] + turn * part) };
        }
    }
    pose
}

/// Gives the move of an object fewer and rounder numbers.
fn round(room: &mut RepairSearch<'_, '_>, id: ObjectId) {
    let old = room.poses[id.0 as usize];
    let now = room.search.state.pose(id);
    for axis in 0..3 {
        let mut pose = room.search.state.pose(id);
        if pose.pos[axis] != old.pos[axis] {
            pose.pos[axis] = old.pos[axis];
            put(room, id, pose);
        }
    }
    let mut pose = room.search.state.pose(id);
    if pose.rot != old.rot {
        pose.rot = old.rot;
        put(room, id, pose);
    }
    if room.dear {
        return;
    }
    for axis in 0..3 {
        for (grid, _) in GRIDS {
            let mut pose = room.search.state.pose(id);
            let by = pose.pos[axis] - old.pos[axis];
            // The move in whole centimetres first, to the nearer and then to the farther side.
            let sides = [round_to(by, grid), round_to(by + grid.copysign(by) / 2.0, grid)];
            let done = by.abs() < 1e-9
                || sides.into_iter().any(|by| {
                    pose.pos[axis] = round_to(old.pos[axis] + by, 1e-6);
                    put(room, id, pose)
                });
            if done {
                break;
            }
        }
    }
    for (_, grid) in GRIDS {
        let mut pose = room.search.state.pose(id);
        if half_turn(pose.rot.y - now.rot.y).abs() > 1.0 || half_turn(pose.rot.y - old.rot.y).abs() < 1e-9 {
            break;
        }
        pose.rot.y = round_turn(round_to(pose.rot.y, grid));
        if put(room, id, pose) {
            break;
        }
    }
}

/// Puts an object somewhere, with what stands on it, if all that is wanted holds then.
fn put(room: &mut RepairSearch<'_, '_>, id: ObjectId, pose: Pose) -> bool {
    let with = room.search.state.with_riders(id, pose);
    room.hold(&with)
}
