//! Where an object could go: anywhere, a little aside, turned, up against another thing or a wall, and to where a
//! violated constraint would hold.

use super::{Judge, Quick};
use crate::pool::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_verify::coded::INPUTS;

/// A step to see how a margin changes (metres).
const PROBE: f64 = 1e-3;
/// A little more than what is missing, so that rounding does not take it away (metres).
const EASE: f64 = 1e-4;

impl Quick<'_> {
    /// Poses for an object, into `out`.
    pub(super) fn poses(&mut self, i: usize, chance: &mut ChaCha8Rng, out: &mut Vec<[f64; INPUTS]>) {
        out.clear();
        let now = self.inputs(i);
        for _ in 0..6 {
            let pose = self.anywhere(i, chance);
            out.push(pose);
        }
        self.satisfying(i, chance, out);
        for at in 0..self.yaws[i].len() {
            let yaw = self.yaws[i][at];
            if yaw != now[3] {
                out.push(turned(now, yaw));
            }
        }
        for far in [0.02, 0.1, 0.4, 1.0] {
            let mut pose = now;
            pose[0] += chance.between(-far, far);
            pose[2] += chance.between(-far, far);
            out.push(pose);
        }
        self.beside_others(i, chance, out);
        self.at_walls(i, chance, out);
    }

    /// Anywhere that it may be.
    pub(super) fn anywhere(&self, i: usize, chance: &mut ChaCha8Rng) -> [f64; INPUTS] {
        let mut pose = self.some_turn(i, chance);
        let (rx, rz) = self.reach(i, &pose);
        let field = &self.field[i];
        pose[0] = within(chance, field.min[0] + rx, field.max[0] - rx);
        pose[2] = within(chance, field.min[1] + rz, field.max[1] - rz);
        pose
    }

    fn some_turn(&self, i: usize, chance: &mut ChaCha8Rng) -> [f64; INPUTS] {
        let yaws = &self.yaws[i];
        turned(self.inputs(i), yaws[chance.below(yaws.len())])
    }

    pub(super) fn reach(&self, i: usize, pose: &[f64; INPUTS]) -> (f64, f64) {
        let ([w, _, d], [.., sin, cos]) = (self.size[i], *pose);
        ((cos.abs() * w + sin.abs() * d) / 2.0, (sin.abs() * w + cos.abs() * d) / 2.0)
    }

    /// Along x, z or y to where a violated term of it would hold, and some way beyond.
    fn satisfying(&mut self, i: usize, chance: &mut ChaCha8Rng, out: &mut Vec<[f64; INPUTS]>) {
        let now = self.inputs(i);
        let fixed = self.frame.fixed(scenelang_lang::program::ObjectId(i as u32));
        let terms = self.terms_of[i].iter().copied().filter(|&t| self.bad_at[t] != u32::MAX);
        let terms: Vec<usize> = terms.take(6).collect();
        for t in terms {
            let missing = self.missing(t, i, now);
            for axis in [0, 2, 1] {
                if fixed.pos[axis] {
                    continue;
                }
                let mut probe = now;
                probe[axis] += PROBE;
                let slope = (self.missing(t, i, probe) - missing) / PROBE;
                if slope.abs() < 1e-3 {
                    continue;
                }
                let step = -(missing + EASE) / slope;
                if !step.is_finite() || step.abs() > 100.0 {
                    continue;
                }
                let mut pose = now;
                pose[axis] += step;
                out.push(pose);
                let beyond = chance.unit();
                pose[axis] += step.signum() * beyond * beyond;
                let other = 2 - axis;
                if axis != 1 && !fixed.pos[other] {
                    out.push(pose);
                    let field = &self.field[i];
                    pose[other] = chance.between(field.min[other / 2], field.max[other / 2]);
                }
                out.push(pose);
            }
        }
    }

    /// What a term lacks with an object somewhere (metres).
    fn missing(&mut self, t: usize, i: usize, pose: [f64; INPUTS]) -> f64 {
        let id = scenelang_lang::program::ObjectId(i as u32);
        let old = self.slots.get(id);
        self.slots.put(id, pose);
        let Judge::Code(code) = &self.judges[t] else { return 0.0 };
        code.run(&mut self.slots);
        let ran = super::Ran { code, slots: &self.slots };
        let merit = super::Merit {
            formula: &self.frame.terms[t].formula,
            values: &ran,
            tolerances: &self.tolerances,
            numbers: super::PhantomData,
        };
        let mut missing: Vec<f64> = Vec::new();
        merit.residuals(&mut missing);
        self.slots.put(id, old);
        missing.into_iter().sum()
    }

    /// Up against what it overlaps, has to do with, or meets by chance.
    fn beside_others(&self, i: usize, chance: &mut ChaCha8Rng, out: &mut Vec<[f64; INPUTS]>) {
        let now = self.inputs(i);
        for round in 0..6 {
            let pool = match round {
                0 | 1 if !self.hits[i].is_empty() => &self.hits[i],
                2 | 3 if !self.related[i].is_empty() => &self.related[i],
                _ => &self.movable,
            };
            let Some(&j) = pool.get(chance.below(pool.len())) else { continue };
            if i == j {
                continue;
            }
            let mut pose = if chance.below(2) == 0 { now } else { self.some_turn(i, chance) };
            let reach = self.reach(i, &pose);
            let (own, span) = ([reach.0, 0.0, reach.1], self.span[j]);
            let axis = 2 * chance.below(2);
            let across = 2 - axis;
            pose[axis] = if chance.below(2) == 0 { span.min[axis] - own[axis] } else { span.max[axis] + own[axis] };
            match chance.below(4) {
                0 => pose[across] = span.min[across] + own[across],
                1 => pose[across] = span.max[across] - own[across],
                2 => pose[across] = chance.between(span.min[across] - own[across], span.max[across] + own[across]),
                _ => {}
            }
            out.push(pose);
        }
        if !self.frame.fixed(scenelang_lang::program::ObjectId(i as u32)).pos[1] {
            self.on_others(i, chance, out);
        }
    }

    /// On what it has to do with, or on the floor.
    fn on_others(&self, i: usize, chance: &mut ChaCha8Rng, out: &mut Vec<[f64; INPUTS]>) {
        let mut low = self.anywhere(i, chance);
        low[1] = self.floor;
        out.push(low);
        for at in 0..self.related[i].len().min(3) {
            let span = self.span[self.related[i][at]];
            let mut pose = self.some_turn(i, chance);
            pose[1] = span.max[1];
            pose[0] = chance.between(span.min[0], span.max[0]);
            pose[2] = chance.between(span.min[2], span.max[2]);
            out.push(pose);
        }
    }

    /// Along the walls and in the corners.
    fn at_walls(&self, i: usize, chance: &mut ChaCha8Rng, out: &mut Vec<[f64; INPUTS]>) {
        let field = &self.field[i];
        for _ in 0..3 {
            let mut pose = if chance.below(2) == 0 { self.inputs(i) } else { self.some_turn(i, chance) };
            let (rx, rz) = self.reach(i, &pose);
            let which = chance.below(8);
            let x = if which & 1 == 0 { field.min[0] + rx } else { field.max[0] - rx };
            let z = if which & 2 == 0 { field.min[1] + rz } else { field.max[1] - rz };
            match which / 4 * 2 + chance.below(2) {
                0 => pose[0] = x,
                1 => pose[2] = z,
                _ => (pose[0], pose[2]) = (x, z),
            }
            out.push(pose);
        }
    }
}

/// The same, turned.
fn turned(pose: [f64; INPUTS], yaw: f64) -> [f64; INPUTS] {
    let (sin, cos) = scenelang_layout::rotation::sin_cos(yaw);
    [pose[0], pose[1], pose[2], yaw, sin, cos]
}

fn within(chance: &mut ChaCha8Rng, lo: f64, hi: f64) -> f64 {
    if lo < hi { chance.between(lo, hi) } else { (lo + hi) / 2.0 }
}
