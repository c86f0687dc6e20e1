//! Candidates from other objects: at their sides near and far, in line and flush, turned to them, away, across; between
//! two of them; and flush with whatever stands around.

use super::{Chance, Pool};
use crate::problem::pose::{direction, yaw_towards};
use scenelang_lang::program::ObjectId;
use scenelang_layout::Vec3;

/// Distances that are tried beside another object (metres).
const GAPS: [f64; 6] = [0.02, 0.1, 0.3, 0.6, 1.0, 1.6];
/// How many related objects are considered.
const PARTNERS: usize = 4;
/// How many others that it has nothing to do with.
const NEIGHBOURS: usize = 4;

impl Pool<'_, '_> {
    /// Beside and facing what it has to do with; in the middle between two of these; right where one is.
    pub(super) fn by_the_others(&mut self) {
        let related = self.related();
        for &other in related.iter().take(PARTNERS) {
            self.at_sides(other, &GAPS);
            self.at_same_place(other);
        }
        for pair in related.windows(2).take(PARTNERS) {
            let (a, b) = (self.state.pose(pair[0]), self.state.pose(pair[1]));
            let middle = (a.pos + b.pos) / 2.0;
            for yaw in self.yaws(a.rot.y) {
                self.push_standing(self.now.facing(yaw).at(middle.x, 0.0, middle.z));
                self.push_standing(self.now.facing(yaw).at(a.pos.x, 0.0, b.pos.z));
                self.push_standing(self.now.facing(yaw).at(b.pos.x, 0.0, a.pos.z));
            }
        }
    }

    /// Along the four sides of another object.
    fn at_sides(&mut self, other: ObjectId, gaps: &[f64]) {
        let base = self.state.pose(other);
        for quarter in 0..4 {
            let way = direction(base.rot.y + 90.0 * f64::from(quarter));
            let across = direction(base.rot.y + 90.0 * f64::from(quarter) + 90.0);
            let (far, wide) = (base.reach(&way), base.reach(&across));
            for yaw in self.yaws(base.rot.y) {
                let pose = self.now.facing(yaw);
                let (own, half) = (pose.reach(&way), pose.reach(&across));
                // Drawn up to it: a third of its depth under it, which only parts allow.
                let tucked = [-0.6 * own];
                for gap in tucked.iter().chain(gaps) {
                    let out = far + own + gap;
                    let mut offsets = vec![0.0, wide - half, half - wide];
                    if wide > 1.5 * half {
                        offsets.extend([0.5 * wide, -0.5 * wide, self.chance.between(-wide, wide)]);
                    }
                    for offset in offsets {
                        let p = base.pos + way * out + across * offset;
                        self.push_standing(pose.at(p.x, 0.0, p.z));
                    }
                }
            }
        }
        if self.turns {
            // Askew, but turned to it.
            for _ in 0..8 {
                let way = direction(self.chance.between(0.0, 360.0));
                let out = base.reach(&way) + self.now.scale.z / 2.0 + self.chance.between(0.05, 1.5);
                let p = base.pos + way * out;
                let pose = self.now.facing(yaw_towards(&-way));
                self.push_standing(pose.at(p.x, 0.0, p.z));
            }
        }
    }

    /// Under or around another object: rugs, and chairs pushed all the way in.
    fn at_same_place(&mut self, other: ObjectId) {
        let base = self.state.pose(other);
        for yaw in self.yaws(base.rot.y) {
            let pose = self.now.facing(yaw);
            for (along, aside) in [(0.0, 0.0), (0.3, 0.0), (-0.3, 0.0), (0.0, 0.3), (0.0, -0.3)] {
                let p: Vec3 = base.pos + base.front() * (along * base.scale.z) + base.right() * (aside * base.scale.x);
                self.push_standing(pose.at(p.x, 0.0, p.z));
            }
        }
    }

    /// Flush with things that it has nothing to do with: how full rooms are packed.
    pub(super) fn among_neighbours(&mut self) {
        let related = self.related();
        let mut others: Vec<ObjectId> = self.state.placed().filter(|o| *o != self.id && !related.contains(o)).collect();
        self.chance.shuffle(&mut others);
        for other in others.into_iter().take(NEIGHBOURS) {
            let base = self.state.pose(other);
            for quarter in 0..4 {
                let way = direction(base.rot.y + 90.0 * f64::from(quarter));
                let across = direction(base.rot.y + 90.0 * f64::from(quarter) + 90.0);
                for yaw in self.yaws(base.rot.y) {
                    let pose = self.now.facing(yaw);
                    let flush = base.reach(&across) - pose.reach(&across);
                    for offset in [flush, -flush] {
                        let p = base.pos + way * (base.reach(&way) + pose.reach(&way)) + across * offset;
                        self.push_standing(pose.at(p.x, 0.0, p.z));
                    }
                }
            }
        }
    }
}
