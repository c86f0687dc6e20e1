//! Clean numbers: quarter turns, whole degrees, centimetres, millimetres, wherever that does no harm.

use crate::problem::frame::Hold;
use crate::problem::pose::{Pose, round_turn};
use crate::search::state::State;
use scenelang_lang::program::ObjectId;

/// Grids for angles (degrees).
const TURNS: [f64; 4] = [90.0, 45.0, 5.0, 1.0];
/// Grids for lengths (metres).
const LENGTHS: [f64; 4] = [0.05, 0.01, 0.001, 0.0001];
/// What a clean number may cost.
const HARM: f64 = 1e-6;

/// Rounds the pose of an object as far as nothing gets worse.
pub(crate) fn object(state: &mut State<'_>, id: ObjectId) {
    let fixed = state.frame.fixed(id);
    if !fixed.rot {
        let yaw = state.pose(id).rot.y;
        let turned = TURNS.iter().map(|grid| (yaw / grid).round() * grid);
        let near = turned.filter(|t| (t - yaw).abs() < 3.0).map(round_turn);
        first(state, id, |pose, yaw| pose.facing(yaw), near.collect());
    }
    let rests = state.frame.scope.is_some() && state.frame.hold(id) == Hold::Rests;
    for axis in (0..3).filter(|&a| !fixed.pos[a] && (a != 1 || !rests)) {
        let value = state.pose(id).pos[axis];
        let rounded = LENGTHS.iter().map(|grid| round_to(value, *grid));
        first(state, id, |pose, v| with_axis(pose, axis, v), rounded.collect());
    }
}

/// To the nearest multiple of a grid, as the decimal number that is meant.
pub(crate) fn round_to(value: f64, grid: f64) -> f64 {
    let per = (1.0 / grid).round();
    (value * per).round() / per + 0.0
}

fn with_axis(pose: Pose, axis: usize, value: f64) -> Pose {
    let mut pose = pose;
    pose.pos[axis] = value;
    pose
}

/// Takes the first of some values that does no harm.
fn first(state: &mut State<'_>, id: ObjectId, set: impl Fn(Pose, f64) -> Pose, values: Vec<f64>) {
    let pose = state.pose(id);
    for value in values {
        let next = set(pose, value);
        if next == pose {
            return;
        }
        let changes = state.with_riders(id, next);
        if state.attempt(&changes, HARM).is_some() {
            state.keep();
            return;
        }
    }
}
