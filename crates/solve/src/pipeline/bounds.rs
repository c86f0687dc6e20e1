//! EnforceBounds: what a proposal has left outside every region is brought back in, the shortest way.

use scenelang_engine::candidate::Candidate;
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Vec3, inside_clearance};
use scenelang_verify::rules;

/// How often the shortest way may lead to another wall.
const WALLS: usize = 8;
/// Ease to a wall (metres).
const EASE: f64 = 1e-4;

/// Brings movable objects back into their regions.
pub(crate) fn enforce(state: &mut Candidate<'_>) {
    for id in outside(state) {
        let Ok((Some(region), _)) = rules::bounds::best(state.world(), id) else { continue };
        let mut pose = state.pose(id);
        for _ in 0..WALLS {
            let Ok(room) = state.world().region(region) else { break };
            let inside = inside_clearance(&pose.obb(), &room.prism);
            let mut step = Vec3::zeros();
            if inside.horizontal.value < 0.0 {
                let way = inside.horizontal.inward * (EASE - inside.horizontal.value);
                step += Vec3::new(way.x, 0.0, way.y);
            }
            step.y += (-inside.floor).max(0.0) - (-inside.ceiling).max(0.0);
            if step == Vec3::zeros() {
                break;
            }
            pose.pos += step;
        }
        let changes = state.with_riders(id, pose);
        if state.attempt(&changes, 0.0).is_some() {
            state.keep();
        }
    }
}

/// Movable objects that no region holds.
pub(crate) fn outside(state: &Candidate<'_>) -> Vec<ObjectId> {
    state.placed().filter(|&id| state.frame.is_movable(id) && state.is_violated(state.numbering.bounds(id))).collect()
}
