//! PhysicsRelaxation: what overlaps is pushed apart, what hangs in the air comes down on what is beneath it.

use crate::problem::checks::Check;
use crate::search::pool::tops;
use crate::search::{STEPS, Search};
use scenelang_lang::program::ObjectId;
use scenelang_layout::Vec3;

/// How often all is gone through.
const PASSES: usize = 4;

/// Relaxes the layout; nothing gets worse by it.
pub(crate) fn relax(search: &mut Search<'_>) {
    for _ in 0..PASSES {
        let mut changed = false;
        for check in search.state.violated() {
            if search.is_spent(1.0) {
                return;
            }
            changed |= match search.state.numbering.check(check) {
                Check::Collide(a, b) => {
                    let movable = [a, b].into_iter().filter(|o| search.state.frame.is_movable(*o)).collect();
                    search.polish(movable, STEPS[0])
                }
                Check::Support(id) if search.state.frame.is_movable(id) => settle(search, id),
                _ => false,
            };
        }
        if !changed {
            break;
        }
    }
}

/// Lowers or lifts an object to the best of the levels under its centre.
fn settle(search: &mut Search<'_>, id: ObjectId) -> bool {
    let state = &mut search.state;
    let pose = state.pose(id);
    let center = pose.center();
    let floors =
        state.world().prisms().filter(|(_, p)| p.polygon.contains(scenelang_layout::Vec2::new(center.x, center.z)));
    let mut levels: Vec<f64> = floors.map(|(_, p)| p.floor).collect();
    if levels.is_empty() {
        levels.push(0.0);
    }
    for other in state.placed().filter(|o| *o != id) {
        let span = state.span(other);
        if (span.min.x..=span.max.x).contains(&center.x) && (span.min.z..=span.max.z).contains(&center.z) {
            let Ok(thing) = state.world().object(other) else { continue };
            levels.extend(tops(&thing.body, &state.pose(other)).iter().map(|t| t.height));
        }
    }
    let mut best: Option<(f64, Vec3)> = None;
    for level in levels {
        let next = Vec3::new(pose.pos.x, level + pose.depth_below(), pose.pos.z);
        let changes = state.with_riders(id, crate::problem::pose::Pose { pos: next, ..pose });
        let limit = best.map_or(-1e-9, |(least, _)| least);
        if let Some(cost) = state.attempt(&changes, limit) {
            state.undo();
            best = Some((cost, next));
        }
    }
    let Some((_, pos)) = best else { return false };
    let changes = state.with_riders(id, crate::problem::pose::Pose { pos, ..pose });
    let done = state.attempt(&changes, f64::INFINITY).is_some();
    if done {
        state.keep();
    }
    done
}
