//! Candidates on top of other objects, and inside containers.

use super::{Chance, Pool};
use crate::problem::pose::Pose;
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Vec2, Vec3};
use scenelang_verify::Body;

/// How many related objects are considered as carriers.
const PARTNERS: usize = 4;
/// How many others: things have to stand somewhere.
const OTHERS: usize = 2;
/// Offsets from the middle of a top, in parts of the room there is.
const SPREAD: [f64; 5] = [0.0, 0.5, -0.5, 1.0, -1.0];

/// A level surface that can carry things.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Top {
    /// Its height.
    pub height: f64,
    /// Least corner of the box around it, in the horizontal frame of the object that has it (right, front).
    pub low: Vec2,
    /// Greatest corner.
    pub high: Vec2,
}

/// The level tops of an object, those of one height joined; the one it declares as its surface, or the highest, first.
pub(crate) fn tops(body: &Body, pose: &Pose) -> Vec<Top> {
    let (right, front) = (pose.right(), pose.front());
    let mut list: Vec<Top> = Vec::new();
    for part in body.solid() {
        for face in part.faces().iter().filter(|f| f.normal.y > 0.9998) {
            for corner in part.face_corners(face) {
                let way: Vec3 = corner - pose.pos;
                let p = Vec2::new(way.dot(&right), way.dot(&front));
                match list.iter_mut().find(|t| (t.height - corner.y).abs() < 1e-6) {
                    Some(top) => (top.low, top.high) = (top.low.inf(&p), top.high.sup(&p)),
                    None => list.push(Top { height: corner.y, low: p, high: p }),
                }
            }
        }
    }
    let surface = body.surface.map(|s| pose.pos.y + s);
    let rank = |t: &Top| surface.map_or(-t.height, |s| (t.height - s).abs());
    list.sort_by(|a, b| rank(a).total_cmp(&rank(b)));
    list
}

impl Pool<'_, '_> {
    /// On what it has to do with, and on some others.
    pub(super) fn on_the_others(&mut self) {
        let related = self.related();
        for &other in related.iter().take(PARTNERS) {
            self.on_top_of(other, 4);
        }
        let mut others: Vec<ObjectId> =
            self.state.placed().filter(|o| *o != self.id && !related.contains(o) && self.fits_on(*o)).collect();
        self.chance.shuffle(&mut others);
        for other in others.into_iter().take(OTHERS) {
            self.on_top_of(other, 1);
        }
    }

    fn fits_on(&self, other: ObjectId) -> bool {
        let scale = self.state.pose(other).scale;
        self.now.scale.x.min(self.now.scale.z) <= scale.x.max(scale.z)
    }

    fn on_top_of(&mut self, other: ObjectId, levels: usize) {
        let base = self.state.pose(other);
        let Ok(thing) = self.state.world().object(other) else { return };
        let list = tops(&thing.body, &base);
        for top in list.into_iter().take(levels) {
            let size = top.high - top.low;
            let middle = (top.low + top.high) / 2.0;
            for yaw in self.yaws(base.rot.y) {
                let pose = self.now.facing(yaw);
                let own = Vec2::new(pose.reach(&base.right()), pose.reach(&base.front()));
                let room = (size / 2.0 - own).sup(&Vec2::zeros());
                let mut offsets: Vec<Vec2> = Vec::new();
                for i in SPREAD {
                    offsets.extend(SPREAD.map(|j| Vec2::new(i, j)));
                }
                offsets.push(Vec2::new(self.chance.between(-1.0, 1.0), self.chance.between(-1.0, 1.0)));
                for offset in offsets {
                    let at = middle + room.component_mul(&offset);
                    let p = base.pos + base.right() * at.x + base.front() * at.y;
                    self.out.push(pose.at(p.x, top.height + pose.depth_below(), p.z));
                }
            }
        }
    }

    /// Inside a container: on its bottom, on a grid.
    pub(super) fn within(&mut self, container: ObjectId) {
        if !self.state.is_placed(container) {
            self.out.push(self.now);
            return;
        }
        let base = self.state.pose(container);
        for yaw in self.yaws(base.rot.y) {
            let pose = self.now.facing(yaw);
            let own = Vec2::new(pose.reach(&base.right()), pose.reach(&base.front()));
            let room = (Vec2::new(base.scale.x, base.scale.z) / 2.0 - own).sup(&Vec2::zeros());
            for i in SPREAD {
                for j in SPREAD {
                    let p = base.pos + base.right() * (room.x * i) + base.front() * (room.y * j);
                    self.out.push(pose.at(p.x, base.pos.y + pose.depth_below(), p.z));
                }
            }
        }
        // On what is in there already.
        let inside: Vec<ObjectId> = self.related().into_iter().filter(|o| *o != container).collect();
        for other in inside.into_iter().take(OTHERS) {
            self.on_top_of(other, 1);
        }
    }
}
