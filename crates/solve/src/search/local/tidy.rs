//! Once all holds: better looks where they cost nothing, free turns along the walls, and clean numbers.
//!
//! What nobody asks for and everybody expects: tall things have a wall behind them, fronts are not barred by one, and what
//! has nothing to do with each other keeps apart. These costs only decide between layouts that are equally good otherwise.

use super::moves::turned;
use super::{Home, LocalSearch, Wall};
use crate::problem::pose::round_to;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::limit::Limit;
use scenelang_lang::program::ObjectId;
use scenelang_verify::coded::INPUTS;

/// Cost of a tall thing whose back is a metre from the wall.
const ADRIFT: f64 = 0.01;
/// Cost of a front that a wall bars.
const BARRED: f64 = 0.01;
/// Cost of touching something it has nothing to do with.
const CROWDED: f64 = 0.004;
/// Space that one likes to keep around things (metres).
const AROUND: f64 = 0.3;
/// From this height on a thing looks better with its back to a wall (metres).
const TALL: f64 = 1.1;
/// Grids for positions (metres), the coarsest first.
const GRIDS: [f64; 3] = [0.05, 0.01, 0.001];
/// What a clean number may cost.
const HARM: f64 = 1e-6;
/// What is turned out of the directions of a wall by less is not (degrees).
const ASKEW: f64 = 1e-6;
/// How often all objects are gone through for better looks.
const PASSES: usize = 2;
/// How many places along walls are tried in each pass.
const WALLS: usize = 12;

impl LocalSearch<'_> {
    /// Improves a layout in which everything holds; it keeps holding.
    pub fn tidy(&mut self, chance: &mut ChaCha8Rng, limit: &Limit) {
        let mut poses = Vec::new();
        let count = self.trial.movable.len();
        for at in 0..count {
            if limit.is_over() {
                return;
            }
            self.square(self.trial.movable[at]);
        }
        for at in (0..PASSES).flat_map(|_| 0..count) {
            if limit.is_over() {
                return;
            }
            self.straighten(self.trial.movable[at], chance, &mut poses);
        }
        for at in 0..count {
            if limit.is_over() {
                return;
            }
            self.round(self.trial.movable[at]);
        }
    }

    /// Turns what stands askew parallel or square to the nearest wall, the shortest way that does no harm.
    fn square(&mut self, i: usize) {
        let Home::Stands(walls) = &self.homes[i] else { return };
        let now = self.trial.inputs(i);
        let apart = |wall: &&Wall| wall.distance([now[0], now[2]]);
        let Some(wall) = walls.iter().min_by(|a, b| apart(a).total_cmp(&apart(b))) else { return };
        let off = (now[3] - wall.yaw).rem_euclid(90.0);
        if !self.trial.turns[i] || off.min(90.0 - off) < ASKEW {
            return;
        }
        let mut turns = [-off, 90.0 - off, -off - 90.0, 180.0 - off];
        turns.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        for turn in turns {
            self.trial.go(i, turned(now, now[3] + turn));
            if self.trial.judge(HARM).is_some()
                && self.trial.fresh.iter().all(|(check, _, holds)| *holds || !self.trial.holds[*check])
            {
                self.trial.keep();
                return;
            }
            self.trial.undo();
        }
    }

    fn straighten(&mut self, i: usize, chance: &mut ChaCha8Rng, poses: &mut Vec<[f64; INPUTS]>) {
        let now = self.oddity(i);
        if now < 1e-3 {
            return;
        }
        poses.clear();
        for _ in 0..WALLS {
            self.at_a_wall(i, chance, poses);
            let pose = self.anywhere(i, chance);
            poses.push(pose);
        }
        let mut best = (now - 1e-4, None);
        for &pose in poses.iter() {
            self.trial.go(i, pose);
            let odd = self.oddity(i);
            if odd < best.0 && self.trial.judge(HARM).is_some() {
                best = (odd, Some(pose));
            }
            self.trial.undo();
        }
        if let Some(pose) = best.1 {
            self.trial.settle(i, pose);
        }
    }

    /// How odd an object looks where it is.
    fn oddity(&self, i: usize) -> f64 {
        let ([x, _, z, _, sin, cos], span, [_, height, depth]) =
            (self.trial.inputs(i), self.trial.span[i], self.trial.size[i]);
        let mut cost = 0.0;
        if let Some(room) = self.trial.rooms.iter().find(|room| room.depth([x, z]) >= 0.0) {
            let clearance = |ahead: f64| room.depth([x + sin * ahead, z + cos * ahead]);
            if height >= TALL && self.related[i].is_empty() {
                cost += ADRIFT * clearance(-depth / 2.0).clamp(0.0, 1.0);
            }
            if height > 0.3 && clearance(depth / 2.0 + 0.4) < 0.0 {
                cost += BARRED;
            }
        }
        for j in (0..self.trial.count()).filter(|j| *j != i && !self.related[i].contains(j)) {
            let other = &self.trial.span[j];
            let apart = |k: usize| (span.min[k] - other.max[k]).max(other.min[k] - span.max[k]).max(0.0);
            let apart = apart(0).max(apart(1)).max(apart(2));
            if apart < AROUND {
                cost += CROWDED * (1.0 - apart / AROUND);
            }
        }
        cost
    }

    /// Rounds its position as far as nothing gets worse.
    fn round(&mut self, i: usize) {
        let fixed = self.trial.frame.fixed(ObjectId(i as u32));
        for axis in [0, 2].into_iter().filter(|&axis| !fixed.pos[axis]) {
            for grid in GRIDS {
                let mut pose = self.trial.inputs(i);
                pose[axis] = round_to(pose[axis], grid);
                self.trial.go(i, pose);
                if self.trial.judge(HARM).is_some() {
                    self.trial.keep();
                    break;
                }
                self.trial.undo();
            }
        }
    }
}
