//! A group in its mirror: a thing and what it has most to do with, each on the other side of the middle of the group, so
//! that a row runs the other way and a desk has its chair at its other side. Tried while preferences are raised.

use super::LocalSearch;
use super::moves::turned;
use scenelang_engine::trial::Inputs;

/// How many things that one has to do with are mirrored with it, at most.
const COMPANY: usize = 11;

impl LocalSearch<'_> {
    /// Mirrors a thing and its company across the middle of them, along x (0) or z (2). Whether there is a company.
    pub(super) fn go_mirrored(&mut self, i: usize, axis: usize) -> bool {
        let mut group = vec![i];
        group.extend(self.related[i].iter().copied().filter(|&k| self.trial.is_movable(k) && k != i).take(COMPANY));
        if group.len() == 1 {
            return false;
        }
        let least = group.iter().map(|&k| self.trial.span[k].min[axis]).fold(f64::INFINITY, f64::min);
        let most = group.iter().map(|&k| self.trial.span[k].max[axis]).fold(f64::NEG_INFINITY, f64::max);
        let middle = (least + most) / 2.0;
        for k in group {
            let mut pose: Inputs = self.trial.inputs(k);
            pose[axis] = 2.0 * middle - pose[axis];
            let yaw = if axis == 0 { -pose[3] } else { 180.0 - pose[3] };
            let allowed = self.trial.turns[k] || self.trial.yaws[k].contains(&crate::problem::pose::round_turn(yaw));
            self.trial.go(k, if allowed { turned(pose, yaw) } else { pose });
        }
        true
    }
}
