//! The first layout of a local search: one object after the other at the best of some poses.

use super::LocalSearch;
use crate::search::chance::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::trial::Inputs;

/// How many poses are tried for each object of a first layout.
const FIRST: usize = 24;
/// How many more with room for a path beside it, where that is wanted.
const AIRY: usize = 6;
/// What it costs that a thing touches another that it has nothing to do with, where room is left for paths.
const CROWD: f64 = 0.3;
/// What is so near to a wall is beside it (metres).
const BESIDE: f64 = 0.1;
/// Where so much of the floor is covered, paths that come last find no room: one of the searches plans them at once.
const CROWDED: f64 = 0.3;
/// How much sooner than others the rest of a cluster comes of which something is there (square metres).
const BEGUN: f64 = 50.0;
/// How many things are looked at for a unit of work.
const LOOKS: u64 = 8;

impl LocalSearch<'_> {
    /// A first layout: one object after the other at the best of some poses. Large ones come first, and what has to do
    /// with those that are there already.
    pub(super) fn begin(&mut self, chance: &mut ChaCha8Rng, given: &[bool], late: &dyn Fn() -> bool) {
        self.trial.weight.fill(1.0);
        self.trial.reluctance.fill(0.0);
        self.trial.work += self.trial.count() as u64;
        let is_new = |i: &usize| !given.get(*i).copied().unwrap_or(false);
        let mut waiting: Vec<usize> = self.trial.movable.iter().copied().filter(is_new).collect();
        self.trial.away.fill(false);
        let is_warm = waiting.is_empty();
        // What is built anew in a part of a layout keeps out of the corridors that there are.
        let is_rebuilt = self.course.is_rebuilt;
        if !(is_warm || is_rebuilt && self.walking) {
            self.trial.forget_paths();
        }
        self.trial.trust_paths();
        for &i in &waiting {
            self.trial.away[i] = true;
            for k in self.dependants(i) {
                self.trial.away[k] = true;
            }
        }
        for i in 0..self.trial.count() {
            self.trial.put(i, self.trial.inputs(i));
        }
        self.trial.away_count = self.trial.away.iter().filter(|a| **a).count();
        self.trial.judge_all();
        if is_rebuilt && self.walking {
            self.trial.judge_paths();
            if chance.below(2) == 0 {
                self.trial.plan_barred();
            }
        }
        self.settle_variables(chance);
        let factor: Vec<f64> = (0..self.trial.count()).map(|_| chance.between(0.7, 1.3)).collect();
        let company = chance.between(0.0, 1.0);
        let mut links = vec![0.0; self.trial.count()];
        for i in (0..self.trial.count()).filter(|i| !self.trial.away[*i]) {
            self.link(i, &mut links);
        }
        let mut poses = Vec::new();
        // What stands together is built as one piece where paths are to lead past it, and it proved hard without.
        let proved_hard = self.course.turn > 0 || self.is_other;
        let as_one = !is_warm && !is_rebuilt && proved_hard && self.air > 0.0 && self.is_clustered;
        let mut begun = None;
        while !waiting.is_empty() {
            let rank = |i: usize| {
                let door = if self.trial.doors.contains(&i) { 100.0 } else { 0.0 };
                let begun = if begun.is_some() && self.clusters.of[i] == begun { BEGUN } else { 0.0 };
                door + begun + self.trial.size[i][0] * self.trial.size[i][2] * factor[i] + company * links[i]
            };
            let based =
                |i: &usize| self.bases[*i].iter().chain(&self.trial.container[*i]).all(|base| !self.trial.away[*base]);
            let ready = (0..waiting.len()).filter(|&k| based(&waiting[k]));
            let next = ready.max_by(|&a, &b| rank(waiting[a]).total_cmp(&rank(waiting[b]))).unwrap_or(0);
            let i = waiting.swap_remove(next);
            self.bring_in(i, chance, &mut poses, late);
            self.link(i, &mut links);
            if as_one && let Some(cluster) = self.clusters.of[i] {
                begun = Some(cluster);
                if !waiting.iter().any(|&k| self.clusters.of[k] == begun) {
                    self.mend_cluster(cluster, chance, &mut poses, late);
                    self.settle_cluster(cluster, chance, late);
                }
            }
        }
        self.trial.judge_all();
        if as_one {
            self.arrange_clusters(chance, late);
        }
        let early = self.is_other && !is_rebuilt && self.course.turn % 4 < 2 && !is_warm && self.covered() >= CROWDED;
        self.walking = is_rebuilt && self.walking
            || early
            || (is_warm || as_one) && self.trial.bad.is_empty()
            || self.trial.path_count() == 0;
        if self.walking {
            self.trial.judge_paths();
            self.trial.plan_missing(late);
            if (is_warm || as_one) && !self.trial.bad.is_empty() && !late() {
                // What has its place already is not moved for a plan, which is coarser than the evaluator.
                self.trial.confirm_paths();
            }
        }
    }

    /// Objects that go wherever rules put them when this one moves.
    fn dependants(&self, i: usize) -> Vec<usize> {
        let rules = self.trial.frame.followers[i].iter().map(|&rule| self.trial.rules[rule].owner);
        rules.filter(|&k| k != i && !self.trial.is_movable(k)).collect()
    }

    /// Gives an object its first place.
    fn bring_in(&mut self, i: usize, chance: &mut ChaCha8Rng, poses: &mut Vec<Inputs>, late: &dyn Fn() -> bool) {
        self.trial.away[i] = false;
        let mut movers = Vec::new();
        for k in self.dependants(i) {
            movers.clear();
            self.movers(k, 0, &mut movers);
            self.trial.away[k] = movers.iter().any(|mover| self.trial.away[*mover]);
        }
        for k in std::iter::once(i).chain(self.dependants(i)) {
            self.trial.put(k, self.trial.inputs(k));
            self.trial.near.set(k, &self.trial.span[k]);
        }
        self.trial.away_count = self.trial.away.iter().filter(|a| **a).count();
        let pose = self.anywhere(i, chance);
        self.trial.settle(i, pose);
        let mut around = Vec::new();
        let mut best = (self.crowd(i, &mut around) - 1e-9, None);
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
                if self.air > 0.0 {
                    for _ in 0..AIRY {
                        self.a_path_apart(i, self.air, chance, poses);
                    }
                }
            } else {
                self.poses(i, chance, poses);
                self.by_analogy(i, poses);
                self.in_line(i, poses);
            }
            for &pose in poses.iter() {
                self.trial.go(i, pose);
                let crowd = self.crowd(i, &mut around);
                if let Some(delta) = self.trial.judge(best.0 - crowd) {
                    best = (delta + crowd - 1e-9, Some(pose));
                }
                self.trial.undo();
            }
            if let Some(pose) = best.1.take() {
                self.trial.settle(i, pose);
            }
            best.0 = self.crowd(i, &mut around) - 1e-9;
            if self.trial.terms_of[i].iter().all(|&t| !self.trial.is_bad(t)) && self.trial.hits[i].is_empty() {
                break;
            }
        }
    }

    /// How much an object narrows the paths between things, if this turn begins with room for these: what stands nearer to
    /// another than a path is wide costs more, unless the two have to do with each other.
    pub(super) fn crowd(&mut self, i: usize, around: &mut Vec<usize>) -> f64 {
        if self.air == 0.0 || self.trial.doors.contains(&i) {
            return 0.0;
        }
        let own = self.trial.span[i];
        let mut wide = own;
        for k in [0, 2] {
            wide.min[k] -= self.air;
            wide.max[k] += self.air;
        }
        self.trial.work += self.trial.near.around(&wide, &self.trial.span, around) as u64 / LOOKS;
        let together = |j: usize| {
            j == i
                || self.course.turn > 0 && self.clusters.share(i, j)
                || self.related[i].contains(&j)
                || self.trial.frame.siblings[i].iter().any(|s| s.0 as usize == j)
        };
        let gap = |j: usize| {
            let apart = |k: usize| {
                (self.trial.span[j].min[k] - own.max[k]).max(own.min[k] - self.trial.span[j].max[k]).max(0.0)
            };
            apart(0).hypot(apart(2))
        };
        let near = around.iter().filter(|&&j| !self.trial.away[j] && !together(j));
        let things: f64 = near.map(|&j| CROWD * (1.0 - gap(j) / self.air).max(0.0)).sum();
        // Between it and a wall there is a path or nothing.
        let field = &self.field[i];
        let walls = [(0, 0), (1, 2)].map(|(k, axis)| [own.min[axis] - field.min[k], field.max[k] - own.max[axis]]);
        let narrow = walls.as_flattened().iter().filter(|gap| **gap > BESIDE && **gap < self.air);
        things + narrow.map(|gap| CROWD * (1.0 - gap / self.air)).sum::<f64>()
    }

    /// Others have so much more to do with what is there.
    fn link(&self, i: usize, links: &mut [f64]) {
        for (other, weight) in &self.trial.frame.related[i] {
            links[other.0 as usize] += weight;
        }
    }
}
