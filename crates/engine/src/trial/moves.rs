//! A trial: something goes elsewhere, what its rules tie to it and what stands on it goes along, and all of it may go back.

use super::{CodedRule, Inputs, Span, Trial};
use crate::frame::rules::Sets;
use crate::pose::round_turn;
use scenelang_lang::program::ObjectId;
use scenelang_layout::rotation::sin_cos;

/// What a rule without code takes.
const WITHOUT_CODE: u64 = 30;
/// What moved in a trial: an object, where it was.
pub type Moved = (usize, Inputs, Span);

impl Trial<'_> {
    /// Whether its pose is not fixed.
    pub fn is_movable(&self, i: usize) -> bool {
        self.frame.is_movable(ObjectId(i as u32))
    }

    /// How many objects there are.
    pub fn count(&self) -> usize {
        self.size.len()
    }

    /// The pose of an object.
    pub fn inputs(&self, i: usize) -> Inputs {
        self.slots.get(ObjectId(i as u32))
    }

    /// Puts an object somewhere, without a look at anything.
    pub fn put(&mut self, i: usize, inputs: Inputs) {
        self.slots.put(ObjectId(i as u32), inputs);
        let ([mut w, h, mut d], [mut x, y, mut z, _, sin, cos]) = (self.size[i], inputs);
        if let Some((middle, half)) = self.lying(i, &inputs) {
            ([x, z], [w, d]) = (middle, half.map(|half| 2.0 * half));
        }
        let [low, high] = self.upwards(i, y).unwrap_or([y, y + h]);
        let (rx, rz) = ((cos.abs() * w + sin.abs() * d) / 2.0, (sin.abs() * w + cos.abs() * d) / 2.0);
        let span = Span { min: [x - rx, low, z - rz], max: [x + rx, high, z + rz] };
        self.span[i] = if self.away[i] { Span::NONE } else { span };
        self.near.follow(i, &self.span[i]);
        self.has_moved(i);
    }

    fn has_moved(&mut self, i: usize) {
        if self.follows {
            self.instance.moved(i);
        }
    }

    /// Begins a trial: an object goes somewhere; what its rules tie to it and what stands on it goes along.
    pub fn go(&mut self, i: usize, inputs: Inputs) {
        self.take(i, inputs, 0);
    }

    fn take(&mut self, i: usize, mut inputs: Inputs, depth: usize) {
        let id = ObjectId(i as u32);
        let (fixed, old) = (self.frame.fixed(id), self.inputs(i));
        (0..3).filter(|&k| fixed.pos[k]).for_each(|k| inputs[k] = old[k]);
        // Nor is it turned as the program forbids, by what it goes along with.
        let is_told = !self.turns[i] && !self.yaws[i].contains(&inputs[3]);
        if fixed.rot || is_told {
            inputs[3..].copy_from_slice(&old[3..]);
        }
        self.carry(i, inputs, depth);
        for at in 0..self.followers[i].len() {
            let rule = self.followers[i][at];
            self.obey(rule, depth);
        }
    }

    /// Puts an object somewhere with what stands on it.
    fn carry(&mut self, i: usize, inputs: Inputs, depth: usize) {
        // Things stand on each other no higher than this.
        const HIGH: usize = 8;
        let old = self.inputs(i);
        self.shift(i, inputs);
        if self.raised_count > 0 && depth < HIGH {
            // What stands on what changes only when a trial is kept.
            for at in 0..self.seats.riders(i).len() {
                let k = self.seats.riders(i)[at];
                if self.is_movable(k) {
                    self.take(k, carried(&old, &inputs, &self.inputs(k)), depth + 1);
                }
            }
        }
    }

    pub(super) fn obey(&mut self, rule: usize, depth: usize) {
        let CodedRule { owner, sets, value } = &self.rules[rule];
        let (owner, sets) = (*owner, *sets);
        let mut next = self.slots.get(ObjectId(owner as u32));
        let Some(value) = value else {
            self.follow();
            self.work += WITHOUT_CODE;
            let Some([pos, rot, _]) = self.frame.rules.list[rule].apply(self.instance.world()) else { return };
            let rot = rot.value();
            if sets == Sets::Rot {
                self.go_lean(owner, [rot.x, rot.z]);
            }
            let yaw = round_turn(rot.y);
            let (sin, cos) = sin_cos(yaw);
            next = [pos.0[0], pos.0[1], pos.0[2], yaw, sin, cos];
            if next != self.inputs(owner) {
                self.carry(owner, next, depth);
            }
            return;
        };
        let found = value.run(&mut self.slots);
        match sets {
            Sets::Pos => next[..3].copy_from_slice(&found),
            Sets::Axis(axis, per) => next[axis] -= found[0] / per,
            Sets::Shift(per) => (0..3).for_each(|k| next[k] -= found[k] / per),
            Sets::Rot | Sets::Yaw => {
                let yaw = if sets == Sets::Rot { found[1] } else { found[0] };
                let (sin, cos) = sin_cos(yaw);
                next[3..].copy_from_slice(&[round_turn(yaw), sin, cos]);
            }
            Sets::Scale => return,
        }
        if next != self.inputs(owner) {
            self.carry(owner, next, depth);
        }
    }

    pub(super) fn shift(&mut self, i: usize, inputs: Inputs) {
        if !std::mem::replace(&mut self.is_moved[i], true) {
            self.moved.push((i, self.inputs(i), self.span[i]));
        }
        self.put(i, inputs);
    }

    /// Takes a trial back.
    pub fn undo(&mut self) {
        self.undo_variables();
        self.undo_leans();
        while let Some((i, inputs, span)) = self.moved.pop() {
            self.is_moved[i] = false;
            self.slots.put(ObjectId(i as u32), inputs);
            self.span[i] = span;
            self.near.follow(i, &span);
            self.has_moved(i);
        }
    }

    /// An object goes somewhere for good.
    pub fn settle(&mut self, i: usize, pose: Inputs) {
        self.go(i, pose);
        if self.judge(f64::INFINITY).is_some() {
            self.keep();
        } else {
            self.undo();
        }
    }
}

/// Where something comes to be that stands on a thing which goes from one pose to another.
pub fn carried(from: &Inputs, to: &Inputs, pose: &Inputs) -> Inputs {
    let (x, z) = (pose[0] - from[0], pose[2] - from[2]);
    let (sin, cos) = (to[4] * from[5] - to[5] * from[4], to[5] * from[5] + to[4] * from[4]);
    let mut next = *pose;
    next[0] = to[0] + x * cos + z * sin;
    next[1] = pose[1] + to[1] - from[1];
    next[2] = to[2] - x * sin + z * cos;
    if to[3] != from[3] {
        let yaw = round_turn(pose[3] + to[3] - from[3]);
        let (sin, cos) = sin_cos(yaw);
        next[3..].copy_from_slice(&[yaw, sin, cos]);
    }
    next
}
