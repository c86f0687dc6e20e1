//! The loop of the quick search: take something violated and an object that it speaks of, try many poses, take the best
//! if it is better; where none is, let what is violated weigh more.

use super::Quick;
use crate::checks::Check;
use crate::pool::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_lang::program::ObjectId;
use scenelang_verify::coded::INPUTS;
use std::time::Instant;

/// What a violated check gains in weight when no move helps.
const STUBBORN: f64 = 0.5;
/// How many poses are tried for each object of a first layout.
const FIRST: usize = 24;
/// So many steps without a new best, and all begins anew: per object, and per root of the number of objects, whichever
/// is less. Large scenes are better begun anew than waited for.
const PATIENCE: [f64; 2] = [400.0, 2500.0];
/// How many exchanges of two objects are tried in a step.
const EXCHANGES: usize = 2;

impl Quick<'_> {
    /// Searches until all holds that is judged here, or so much work is done. Whether it does.
    /// Objects that are `given` a place start from there at first.
    pub fn search(&mut self, chance: &mut ChaCha8Rng, budget: u64, deadline: Option<Instant>, given: &[bool]) -> bool {
        let late = || deadline.is_some_and(|end| Instant::now() >= end);
        let mut kept_in_place = given;
        let end = self.work + budget;
        let n = self.movable.len().max(5) as f64;
        let patience = (PATIENCE[0] * n).min(PATIENCE[1] * n.sqrt()) as usize;
        let mut best = usize::MAX;
        let mut kept: Vec<[f64; INPUTS]> = Vec::new();
        let mut poses = Vec::new();
        while self.work < end && !late() {
            self.begin(chance, kept_in_place);
            kept_in_place = &[];
            let (mut idle, mut least) = (0, usize::MAX);
            while !self.bad.is_empty() && self.work < end && !late() && idle < patience {
                self.step(chance, &mut poses);
                idle = if self.bad.len() < least { 0 } else { idle + 1 };
                least = least.min(self.bad.len());
                if self.bad.len() < best {
                    best = self.bad.len();
                    kept = (0..self.count()).map(|i| self.inputs(i)).collect();
                }
            }
            if self.bad.is_empty() || self.movable.is_empty() {
                return self.bad.is_empty();
            }
        }
        for (i, inputs) in kept.into_iter().enumerate() {
            self.put(i, inputs);
        }
        false
    }

    /// A first layout: one object after the other at the best of some random poses, large ones first.
    fn begin(&mut self, chance: &mut ChaCha8Rng, given: &[bool]) {
        self.weight.fill(1.0);
        self.work += self.count() as u64;
        let new: Vec<usize> =
            self.movable.iter().copied().filter(|i| !given.get(*i).copied().unwrap_or(false)).collect();
        for &i in &new {
            let pose = self.anywhere(i, chance);
            self.go(i, pose);
            self.moved.clear();
        }
        self.judge_all();
        let mut order: Vec<(f64, usize)> =
            new.iter().map(|&i| (self.size[i][0] * self.size[i][2] * chance.between(0.7, 1.3), i)).collect();
        order.sort_by(|a, b| b.0.total_cmp(&a.0));
        for (_, i) in order {
            let mut best = (-1e-9, None);
            for _ in 0..FIRST {
                let pose = self.anywhere(i, chance);
                self.go(i, pose);
                if let Some(delta) = self.judge(best.0) {
                    best = (delta - 1e-9, Some(pose));
                }
                self.undo();
            }
            if let Some(pose) = best.1 {
                self.settle(i, pose);
            }
        }
    }

    /// Judges everything anew.
    fn judge_all(&mut self) {
        self.cost.fill(0.0);
        self.bad.clear();
        self.bad_at.fill(u32::MAX);
        self.hits.iter_mut().for_each(Vec::clear);
        self.moved = (0..self.count()).map(|i| (i, self.inputs(i), self.span[i])).collect();
        for i in 0..self.count() {
            self.put(i, self.inputs(i));
        }
        let _ = self.judge(f64::INFINITY);
        self.keep();
    }

    pub(super) fn settle(&mut self, i: usize, pose: [f64; INPUTS]) {
        self.go(i, pose);
        if self.judge(f64::INFINITY).is_some() {
            self.keep();
        } else {
            self.undo();
        }
    }

    /// One object of something violated goes to the best of many poses, or changes places with another.
    fn step(&mut self, chance: &mut ChaCha8Rng, poses: &mut Vec<[f64; INPUTS]>) {
        self.work += 1;
        let check = self.bad[chance.below(self.bad.len())];
        let Some(i) = self.culprit(check, chance) else {
            self.weight[check] += STUBBORN;
            return;
        };
        self.poses(i, chance, poses);
        let mut best = (1e-9, None);
        let now = self.inputs(i);
        for &pose in poses.iter() {
            if pose == now {
                continue;
            }
            self.go(i, pose);
            if let Some(delta) = self.judge(best.0) {
                best = (delta, Some(pose));
            }
            self.undo();
        }
        let mut swap = None;
        for _ in 0..EXCHANGES {
            let j = self.movable[chance.below(self.movable.len())];
            if i == j {
                continue;
            }
            let turn = chance.below(2) == 0;
            self.exchange(i, j, turn);
            if let Some(delta) = self.judge(best.0) {
                best = (delta, Some(now));
                swap = Some((j, turn));
            }
            self.undo();
        }
        match (best.1, swap) {
            (Some(_), Some((j, turn))) => {
                self.exchange(i, j, turn);
                if self.judge(f64::INFINITY).is_some() {
                    self.keep();
                }
            }
            (Some(pose), None) => self.settle(i, pose),
            (None, _) => {}
        }
        if best.0 > -1e-9 {
            for at in 0..self.bad.len() {
                self.weight[self.bad[at]] += STUBBORN * chance.unit();
            }
        }
    }

    fn exchange(&mut self, i: usize, j: usize, turn: bool) {
        let (a, b) = (self.inputs(i), self.inputs(j));
        let at = |own: [f64; INPUTS], theirs: [f64; INPUTS]| {
            let mut next = if turn { theirs } else { own };
            (next[0], next[2]) = (theirs[0], theirs[2]);
            next[1] = own[1];
            next
        };
        self.go(i, at(a, b));
        self.go(j, at(b, a));
    }

    /// A movable object that a check speaks of.
    fn culprit(&self, check: usize, chance: &mut ChaCha8Rng) -> Option<usize> {
        let movable = |o: &ObjectId| self.frame.is_movable(*o);
        match self.numbering.check(check) {
            Check::Term(t) => {
                let objects = &self.frame.terms[t].objects;
                let count = objects.iter().filter(|o| movable(o)).count();
                objects.iter().filter(|o| movable(o)).nth(chance.below(count)).map(|o| o.0 as usize)
            }
            Check::Collide(a, b) => {
                let (first, second) = if chance.below(2) == 0 { (a, b) } else { (b, a) };
                [first, second].iter().find(|o| movable(o)).map(|o| o.0 as usize)
            }
            Check::Bounds(a) | Check::Support(a) => Some(a).filter(movable).map(|o| o.0 as usize),
        }
    }
}
