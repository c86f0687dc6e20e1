//! The first layout of a local search: one object after the other at the best of some poses.

use super::LocalSearch;
use super::moves::Inputs;
use crate::search::pool::Chance;
use rand_chacha::ChaCha8Rng;

/// How many poses are tried for each object of a first layout.
const FIRST: usize = 24;

impl LocalSearch<'_> {
    /// A first layout: one object after the other at the best of some poses. Large ones come first, and what has to do
    /// with those that are there already.
    pub(super) fn begin(&mut self, chance: &mut ChaCha8Rng, given: &[bool], late: &dyn Fn() -> bool) {
        self.weight.fill(1.0);
        self.reluctance.fill(0.0);
        self.work += self.count() as u64;
        let is_new = |i: &usize| !given.get(*i).copied().unwrap_or(false);
        let mut waiting: Vec<usize> = self.movable.iter().copied().filter(is_new).collect();
        self.away.fill(false);
        let is_warm = waiting.is_empty();
        if !is_warm {
            self.forget_paths();
        }
        self.trust_paths();
        for &i in &waiting {
            self.away[i] = true;
            for k in self.dependants(i) {
                self.away[k] = true;
            }
        }
        for i in 0..self.count() {
            self.put(i, self.inputs(i));
        }
        self.away_count = self.away.iter().filter(|a| **a).count();
        self.judge_all();
        let factor: Vec<f64> = (0..self.count()).map(|_| chance.between(0.7, 1.3)).collect();
        let company = chance.between(0.0, 1.0);
        let mut links = vec![0.0; self.count()];
        for i in (0..self.count()).filter(|i| !self.away[*i]) {
            self.link(i, &mut links);
        }
        let mut poses = Vec::new();
        while !waiting.is_empty() {
            let rank = |i: usize| {
                let door = if self.doors.contains(&i) { 100.0 } else { 0.0 };
                door + self.size[i][0] * self.size[i][2] * factor[i] + company * links[i]
            };
            let based = |i: &usize| self.bases[*i].iter().chain(&self.container[*i]).all(|base| !self.away[*base]);
            let ready = (0..waiting.len()).filter(|&k| based(&waiting[k]));
            let next = ready.max_by(|&a, &b| rank(waiting[a]).total_cmp(&rank(waiting[b]))).unwrap_or(0);
            let i = waiting.swap_remove(next);
            self.bring_in(i, chance, &mut poses, late);
            self.link(i, &mut links);
        }
        self.judge_all();
        self.walking = is_warm && self.bad.is_empty() || self.path_count() == 0;
        if self.walking {
            self.judge_paths();
            self.plan_missing(late);
            if is_warm && !self.bad.is_empty() && !late() {
                // What has its place already is not moved for a plan.
                self.confirm_paths();
            }
        }
    }

    /// Objects that go wherever rules put them when this one moves.
    fn dependants(&self, i: usize) -> Vec<usize> {
        let rules = self.frame.followers[i].iter().map(|&rule| self.rules[rule].owner);
        rules.filter(|&k| k != i && !self.is_movable(k)).collect()
    }

    /// Gives an object its first place.
    fn bring_in(&mut self, i: usize, chance: &mut ChaCha8Rng, poses: &mut Vec<Inputs>, late: &dyn Fn() -> bool) {
        self.away[i] = false;
        let mut movers = Vec::new();
        for k in self.dependants(i) {
            movers.clear();
            self.movers(k, 0, &mut movers);
            self.away[k] = movers.iter().any(|mover| self.away[*mover]);
        }
        for k in std::iter::once(i).chain(self.dependants(i)) {
            self.put(k, self.inputs(k));
            self.near.set(k, &self.span[k]);
        }
        self.away_count = self.away.iter().filter(|a| **a).count();
        let pose = self.anywhere(i, chance);
        self.settle(i, pose);
        let mut best = (-1e-9, None);
        for round in 0..2 {
            if late() {
                return;
            }
            poses.clear();
            if round == 0 {
                for _ in 0..FIRST {
                    let pose = self.anywhere(i, chance);
                    poses.push(pose);
                }
            } else {
                self.poses(i, chance, poses);
                self.by_analogy(i, poses);
            }
            for &pose in poses.iter() {
                self.go(i, pose);
                if let Some(delta) = self.judge(best.0) {
                    best = (delta - 1e-9, Some(pose));
                }
                self.undo();
            }
            if let Some(pose) = best.1.take() {
                self.settle(i, pose);
            }
            best.0 = -1e-9;
            if self.terms_of[i].iter().all(|&t| self.bad_at[t] == u32::MAX) && self.hits[i].is_empty() {
                break;
            }
        }
    }

    /// Others have so much more to do with what is there.
    fn link(&self, i: usize, links: &mut [f64]) {
        for (other, weight) in &self.frame.related[i] {
            links[other.0 as usize] += weight;
        }
    }

    /// Judges everything anew.
    pub(super) fn judge_all(&mut self) {
        self.cost.fill(0.0);
        self.holds.fill(true);
        self.bad.clear();
        self.bad_at.fill(u32::MAX);
        self.hits.iter_mut().for_each(Vec::clear);
        self.near.clear();
        self.moved = (0..self.count()).map(|i| (i, self.inputs(i), self.span[i])).collect();
        for i in 0..self.count() {
            self.put(i, self.inputs(i));
        }
        let _ = self.judge(f64::INFINITY);
        self.keep();
    }

    pub(super) fn settle(&mut self, i: usize, pose: Inputs) {
        self.go(i, pose);
        if self.judge(f64::INFINITY).is_some() {
            self.keep();
        } else {
            self.undo();
        }
    }
}
