//! A trial: something goes elsewhere with what is tied to it and what stands on it, and what that changes is judged.

use super::variables::MovedVariable;
use super::{CodedRule, Judge, LocalSearch, Ran, Span, TOUCHING};
use scenelang_engine::frame::checks::Check;
use scenelang_engine::frame::rules::Sets;
use scenelang_engine::penalty::Penalty;
use scenelang_lang::program::ObjectId;
use scenelang_verify::coded::{self, Block, Flat, INPUTS};
use std::marker::PhantomData;

/// What a rule without code takes.
const WITHOUT_CODE: u64 = 30;
/// So many pairs of blocks are held against each other in a unit of work.
const BLOCKS: u64 = 8;

/// What moved in a trial: an object, where it was.
pub(super) type Moved = (usize, [f64; INPUTS], Span);

impl LocalSearch<'_> {
    pub(super) fn is_movable(&self, i: usize) -> bool {
        self.frame.is_movable(ObjectId(i as u32))
    }

    pub(super) fn count(&self) -> usize {
        self.size.len()
    }

    pub(super) fn inputs(&self, i: usize) -> [f64; INPUTS] {
        self.slots.get(ObjectId(i as u32))
    }

    /// Puts an object somewhere, without a look at anything.
    pub(super) fn put(&mut self, i: usize, inputs: [f64; INPUTS]) {
        self.slots.put(ObjectId(i as u32), inputs);
        let ([mut w, h, mut d], [mut x, y, mut z, _, sin, cos]) = (self.size[i], inputs);
        if let Some((middle, half)) = self.lying(i, &inputs) {
            ([x, z], [w, d]) = (middle, half.map(|half| 2.0 * half));
        }
        let [low, high] = self.upwards(i, y).unwrap_or([y, y + h]);
        let (rx, rz) = ((cos.abs() * w + sin.abs() * d) / 2.0, (sin.abs() * w + cos.abs() * d) / 2.0);
        let span = Span { min: [x - rx, low, z - rz], max: [x + rx, high, z + rz] };
        self.span[i] = if self.away[i] { Span::NONE } else { span };
        self.has_moved(i);
    }

    fn has_moved(&mut self, i: usize) {
        if self.follows {
            self.instance.moved(i);
        }
    }

    /// Begins a trial: an object goes somewhere; what its rules tie to it and what stands on it goes along.
    pub(super) fn go(&mut self, i: usize, inputs: [f64; INPUTS]) {
        self.take(i, inputs, 0);
    }

    fn take(&mut self, i: usize, mut inputs: [f64; INPUTS], depth: usize) {
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
    fn carry(&mut self, i: usize, inputs: [f64; INPUTS], depth: usize) {
        // Things stand on each other no higher than this.
        const HIGH: usize = 8;
        let old = self.inputs(i);
        self.shift(i, inputs);
        if self.raised_count > 0 && depth < HIGH {
            for k in (0..self.count()).filter(|&k| self.seat[k] == Some(i)).collect::<Vec<_>>() {
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
            let yaw = crate::problem::pose::round_turn(rot.y);
            let (sin, cos) = scenelang_layout::rotation::sin_cos(yaw);
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
                let (sin, cos) = scenelang_layout::rotation::sin_cos(yaw);
                next[3..].copy_from_slice(&[crate::problem::pose::round_turn(yaw), sin, cos]);
            }
            Sets::Scale => return,
        }
        if next != self.inputs(owner) {
            self.carry(owner, next, depth);
        }
    }

    pub(super) fn shift(&mut self, i: usize, inputs: [f64; INPUTS]) {
        if !self.moved.iter().any(|(o, ..)| *o == i) {
            self.moved.push((i, self.inputs(i), self.span[i]));
        }
        self.put(i, inputs);
    }

    /// Takes a trial back.
    pub(super) fn undo(&mut self) {
        self.undo_variables();
        self.undo_leans();
        while let Some((i, inputs, span)) = self.moved.pop() {
            self.slots.put(ObjectId(i as u32), inputs);
            self.span[i] = span;
            self.has_moved(i);
        }
    }

    /// By how much a trial costs more than what was before; `None`: more than `limit`.
    pub(super) fn judge(&mut self, limit: f64) -> Option<f64> {
        self.fresh.clear();
        self.now = self.now.wrapping_add(1);
        let moved = std::mem::take(&mut self.moved);
        let variables = std::mem::take(&mut self.variables.moved);
        let delta = self.judge_moved(&moved, &variables, limit);
        (self.moved, self.variables.moved) = (moved, variables);
        delta
    }

    fn judge_moved(&mut self, moved: &[Moved], variables: &[MovedVariable], limit: f64) -> Option<f64> {
        let mut delta = 0.0;
        // What these cost before.
        for &(i, ..) in moved {
            let id = ObjectId(i as u32);
            for check in [self.numbering.bounds(id), self.numbering.support(id)] {
                delta -= self.weight[check] * self.cost[check];
            }
            for at in 0..self.terms_of[i].len() {
                let t = self.terms_of[i][at];
                if self.stamp[t] != self.now {
                    self.stamp[t] = self.now;
                    delta -= self.weight[t] * self.cost[t];
                }
            }
            for at in 0..if self.preferring { self.preferences_of[i].len() } else { 0 } {
                let t = self.preferences_of[i][at];
                if self.stamp[t] != self.now {
                    self.stamp[t] = self.now;
                    delta -= self.weight[t] * self.cost[t];
                }
            }
            for &j in &self.hits[i] {
                let check = self.numbering.collide(id, ObjectId(j as u32));
                if self.stamp[check] != self.now {
                    self.stamp[check] = self.now;
                    delta -= self.weight[check] * self.cost[check];
                }
            }
        }
        delta -= self.cost_of_variables(variables);
        self.now = self.now.wrapping_add(1);
        for &(i, ..) in moved {
            let check = self.numbering.bounds(ObjectId(i as u32));
            if self.bounded[i] && !self.away[i] {
                let found = self.bounds(i);
                delta += self.note(check, found);
            }
            let check = self.numbering.support(ObjectId(i as u32));
            if self.rests[i] && !self.away[i] {
                let found = self.support(i);
                delta += self.note(check, found);
            }
            if delta > limit {
                return None;
            }
        }
        for &(i, ..) in moved {
            delta += self.collisions(i, moved);
            if delta > limit {
                return None;
            }
        }
        let alone = moved.len() == 1 && variables.is_empty();
        for &(i, ..) in moved {
            for at in 0..self.terms_of[i].len() {
                let t = self.terms_of[i][at];
                if !alone && std::mem::replace(&mut self.stamp[t], self.now) == self.now {
                    continue;
                }
                let found = self.term(t);
                delta += self.note(t, found);
                if delta > limit {
                    // What often decides is asked earlier the next time.
                    self.terms_of[i].swap(at, at.saturating_sub(1));
                    return None;
                }
            }
        }
        for &(i, ..) in moved {
            for at in 0..if self.preferring { self.preferences_of[i].len() } else { 0 } {
                let t = self.preferences_of[i][at];
                if !alone && std::mem::replace(&mut self.stamp[t], self.now) == self.now {
                    continue;
                }
                let found = self.term(t);
                delta += self.note(t, found);
            }
        }
        delta += self.judge_variables(variables);
        delta += self.others_above(moved) + self.onlookers(moved) + self.paths_change(moved);
        (delta <= limit).then_some(delta)
    }

    pub(super) fn note(&mut self, check: usize, (cost, holds): (f64, bool)) -> f64 {
        self.fresh.push((check, cost, holds));
        self.weight[check] * cost
    }

    pub(super) fn term(&mut self, t: usize) -> (f64, bool) {
        if self.away_count > 0 && self.frame.terms[t].objects.iter().any(|o| self.away[o.0 as usize]) {
            return (0.0, true);
        }
        let code = match &self.judges[t] {
            Judge::Code(code) => code,
            Judge::Inside(i, room) => {
                let (i, contact) = (*i, self.tolerances.contact);
                let clearance = self.rooms[*room].clearance(&self.span[i], || self.flat(i));
                return self.physical(clearance + contact, contact);
            }
            Judge::Clear(clear) => {
                let clear = *clear;
                return self.clear(&clear);
            }
            Judge::Mixed(_) => return self.mixed(t),
            Judge::PathGroup(_) | Judge::Shared(_) | Judge::Turn | Judge::Absent => return (0.0, true),
        };
        self.work += 3 + code.steps() as u64 / 8;
        code.run(&mut self.slots);
        let ran = Ran { code, slots: &self.slots };
        let penalty = Penalty {
            formula: &self.frame.terms[t].formula,
            values: &ran,
            tolerances: &self.tolerances,
            numbers: PhantomData,
        };
        penalty.both()
    }

    fn bounds(&mut self, i: usize) -> (f64, bool) {
        if self.is_asked(i) {
            return self.bounds_asked(i);
        }
        let span = &self.span[i];
        let clearances = self.rooms.iter().map(|room| room.clearance(span, || self.flat(i)));
        let best = clearances.fold(f64::NEG_INFINITY, f64::max);
        let contact = self.tolerances.contact;
        self.physical(best + contact, contact)
    }

    /// On a floor, or with its feet on tops of one thing. Standing on the edges of several things is left to the search
    /// proper.
    fn support(&mut self, i: usize) -> (f64, bool) {
        if self.is_asked(i) {
            return self.support_asked(i);
        }
        let tolerance = self.tolerances.support;
        let target = tolerance.min(self.tolerances.contact);
        let mut off = self.above_floor(i).abs();
        if off > target {
            off = self.nearest_top(i).map_or(off, |(_, top)| off.min(top));
        }
        self.physical(tolerance - off, target)
    }

    /// How far its base is above the nearest floor of where it is.
    fn above_floor(&self, i: usize) -> f64 {
        let base = self.span[i].min[1];
        if let Some(floor) = self.floor {
            return base - floor;
        }
        let [x, z] = self.flat(i).at;
        let under = self.rooms.iter().filter(|room| room.depth([x, z]) >= -self.tolerances.contact);
        let nearest = under.map(|room| base - room.floor).min_by(|a, b| a.abs().total_cmp(&b.abs()));
        nearest.unwrap_or(base)
    }

    /// Of the things with tops below (or above) its feet the one with those nearest to its base, and how far they are.
    fn nearest_top(&self, i: usize) -> Option<(usize, f64)> {
        let own = self.flat(i);
        let [x, z] = own.at;
        let mut best: Option<(usize, f64)> = None;
        for j in 0..self.count() {
            let other = &self.span[j];
            if j == i
                || !(other.min[0]..=other.max[0]).contains(&x)
                || !(other.min[2]..=other.max[2]).contains(&z)
                || !self.is_over(j, x, z)
                || self.is_oblique(j)
            {
                continue;
            }
            let theirs = self.flat(j);
            let off = |foot: &[f64; 2]| self.height_over(i, j, theirs.local(own.point(*foot)));
            let Some(off) = self.feet[i].iter().map(off).try_fold(0.0, |most: f64, off| Some(most.max(off?))) else {
                continue;
            };
            if best.is_none_or(|(_, least)| off < least) {
                best = Some((j, off));
            }
        }
        best
    }

    /// How far the base of one is from the nearest top of another at a point of that one's frame.
    fn height_over(&self, i: usize, j: usize, [u, v]: [f64; 2]) -> Option<f64> {
        let base = self.span[i].min[1] - self.middle(j);
        let covers =
            |block: &&Block| (u - block.at[0]).abs() <= block.half[0] && (v - block.at[2]).abs() <= block.half[2];
        let offs = self.blocks[j].iter().filter(covers).map(|block| (base - block.at[1] - block.half[1]).abs());
        offs.reduce(f64::min)
    }

    /// What it stands on, if that is not a floor.
    fn find_seat(&self, i: usize) -> Option<usize> {
        let (support, target) = (self.tolerances.support, self.tolerances.contact);
        let raised = self.rests[i] && self.above_floor(i) > support;
        self.nearest_top(i).filter(|(_, off)| raised && *off <= support.max(target)).map(|(j, _)| j)
    }

    /// Whether the evaluator is asked for the physical rules of an object.
    fn is_asked(&self, i: usize) -> bool {
        self.asked[i] || self.is_oblique(i)
    }

    fn is_over(&self, j: usize, x: f64, z: f64) -> bool {
        let flat = self.flat(j);
        let [u, v] = flat.local([x, z]);
        u.abs() <= flat.half[0] && v.abs() <= flat.half[1]
    }

    /// What overlaps of one of the moved objects cost now.
    fn collisions(&mut self, i: usize, moved: &[Moved]) -> f64 {
        let own = self.span[i];
        let mut around = std::mem::take(&mut self.around);
        self.work += 2 + self.near.around(&own, &self.span, &mut around) as u64 / 8;
        let moves = |j: usize| moved.iter().any(|(m, ..)| *m == j);
        // Of two that move together the first is asked for both.
        let others = moved.iter().map(|(m, ..)| *m).filter(|&m| m > i);
        let sum = around.iter().copied().filter(|&j| !moves(j)).chain(others).map(|j| self.collision(i, j, &own)).sum();
        self.around = around;
        sum
    }

    /// What it costs that two overlap.
    fn collision(&mut self, i: usize, j: usize, own: &Span) -> f64 {
        if !own.meets(&self.span[j]) || !self.collide[i * self.count() + j] {
            return 0.0;
        }
        // Spans of carved things meet often, and each block is then held against each: a hall of racks is dear.
        self.work += (self.blocks[i].len() * self.blocks[j].len()) as u64 / BLOCKS;
        let gap = self.gap(i, j);
        if gap >= -TOUCHING {
            return 0.0;
        }
        let contact = self.tolerances.contact;
        let found = if self.is_asked(i) || self.is_asked(j) {
            self.collision_asked(i, j)
        } else {
            self.physical(gap + contact, contact - TOUCHING)
        };
        if found == (0.0, true) {
            return 0.0;
        }
        let check = self.numbering.collide(ObjectId(i as u32), ObjectId(j as u32));
        self.note(check, found)
    }

    /// The signed gap of two upright things that may overlap.
    fn gap(&self, i: usize, j: usize) -> f64 {
        let (a, b) = (&self.span[i], &self.span[j]);
        if self.blocks[i].len() > 1 || self.blocks[j].len() > 1 {
            return self.gap_of_blocks((i, &self.flat(i)), (&self.blocks[j], &self.flat(j), self.middle(j)));
        }
        let along = |k: usize| (a.min[k] - b.max[k]).max(b.min[k] - a.max[k]);
        let square = |k: usize| {
            let [.., sin, cos] = self.inputs(k);
            sin == 0.0 || cos == 0.0
        };
        let aside = if square(i) && square(j) { along(0).max(along(2)) } else { self.flat(i).gap(&self.flat(j)) };
        aside.max(along(1))
    }

    /// The signed gap between a thing and blocks that stand somewhere.
    pub(super) fn gap_of_blocks(&self, (i, flat): (usize, &Flat), other: (&[Block], &Flat, f64)) -> f64 {
        coded::gap([(&self.blocks[i], flat, self.middle(i)), other], f64::max)
    }

    /// How high its middle is.
    pub(super) fn middle(&self, i: usize) -> f64 {
        (self.span[i].min[1] + self.span[i].max[1]) / 2.0
    }

    /// What stands on something: its carrier may have come or gone.
    fn others_above(&mut self, moved: &[Moved]) -> f64 {
        let mut sum = 0.0;
        if self.raised_count == 0 {
            return sum;
        }
        for k in 0..self.count() {
            if !self.raised[k] || !self.rests[k] || moved.iter().any(|(m, ..)| *m == k) {
                continue;
            }
            let span = self.span[k];
            let over = |s: &Span| {
                s.min[0] < span.max[0] && span.min[0] < s.max[0] && s.min[2] < span.max[2] && span.min[2] < s.max[2]
            };
            if moved.iter().any(|(m, _, old)| over(old) || over(&self.span[*m])) {
                let check = self.numbering.support(ObjectId(k as u32));
                let found = self.support(k);
                sum += self.note(check, found) - self.weight[check] * self.cost[check];
            }
        }
        sum
    }

    /// Spaces that something moved into, or out of.
    fn onlookers(&mut self, moved: &[Moved]) -> f64 {
        let mut sum = 0.0;
        for at in 0..self.onlookers.len() {
            let t = self.onlookers[at];
            let own = |o: &ObjectId| moved.iter().any(|(m, ..)| *m == o.0 as usize);
            let judged = self.stamp[t] == self.now && self.variables.are_moving;
            if judged || !self.counts(t) || self.frame.terms[t].objects.iter().any(own) {
                continue;
            }
            if self.is_seen(t, moved) {
                let found = self.term(t);
                sum += self.note(t, found) - self.weight[t] * self.cost[t];
            }
        }
        sum
    }

    /// Keeps a trial that was judged to its end.
    pub(super) fn keep(&mut self) {
        let moved = std::mem::take(&mut self.moved);
        for &(i, ..) in &moved {
            self.near.set(i, &self.span[i]);
            for j in std::mem::take(&mut self.hits[i]) {
                self.hits[j].retain(|k| *k != i);
                self.set(self.numbering.collide(ObjectId(i as u32), ObjectId(j as u32)), 0.0, true);
            }
            let on_something = self.rests[i] && !self.away[i] && self.above_floor(i) > self.tolerances.support;
            let raised = on_something || self.container[i].is_some();
            self.raised_count = self.raised_count + usize::from(raised) - usize::from(self.raised[i]);
            self.raised[i] = raised;
            self.seat[i] = self.container[i].or_else(|| if raised { self.find_seat(i) } else { None });
        }
        self.paths_keep(&moved);
        let fresh = std::mem::take(&mut self.fresh);
        for &(check, cost, holds) in &fresh {
            self.set(check, cost, holds);
            if let Check::Collide(a, b) = self.numbering.check(check) {
                self.hits[a.0 as usize].push(b.0 as usize);
                self.hits[b.0 as usize].push(a.0 as usize);
            }
        }
        self.fresh = fresh;
        self.moved = moved;
        self.moved.clear();
        self.leaned.clear();
        self.variables.moved.clear();
    }

    /// Whether a check holds, as last judged.
    pub(super) fn does_hold(&self, check: usize) -> bool {
        self.holds[check]
    }

    pub(super) fn set(&mut self, check: usize, cost: f64, holds: bool) {
        self.cost[check] = cost;
        self.holds[check] = holds;
        // A preference that fails is no violation, unless it is demanded.
        let fine = holds || !self.is_demanded(check) && self.frame.terms.get(check).is_some_and(|t| !t.is_hard());
        let at = self.bad_at[check];
        if fine && at != u32::MAX {
            self.bad.swap_remove(at as usize);
            self.bad_at[check] = u32::MAX;
            if let Some(&last) = self.bad.get(at as usize) {
                self.bad_at[last] = at;
            }
        } else if !fine && at == u32::MAX {
            self.bad_at[check] = self.bad.len() as u32;
            self.bad.push(check);
        }
    }
}

/// Where something comes to be that stands on a thing which goes from one pose to another.
pub(super) fn carried(from: &[f64; INPUTS], to: &[f64; INPUTS], pose: &[f64; INPUTS]) -> [f64; INPUTS] {
    let (x, z) = (pose[0] - from[0], pose[2] - from[2]);
    let (sin, cos) = (to[4] * from[5] - to[5] * from[4], to[5] * from[5] + to[4] * from[4]);
    let mut next = *pose;
    next[0] = to[0] + x * cos + z * sin;
    next[1] = pose[1] + to[1] - from[1];
    next[2] = to[2] - x * sin + z * cos;
    if to[3] != from[3] {
        let yaw = crate::problem::pose::round_turn(pose[3] + to[3] - from[3]);
        let (sin, cos) = scenelang_layout::rotation::sin_cos(yaw);
        next[3..].copy_from_slice(&[yaw, sin, cos]);
    }
    next
}
