//! Ruin and recreate: where a search is stuck close to its aim, a part of the best layout is taken away, around something that
//! is violated, and built anew; the rest stays where it is (Schrimpf and others: Record breaking optimization results using
//! the ruin and recreate principle, 2000). That costs a fraction of a new beginning, and loses little.

use super::LocalSearch;
use crate::search::chance::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::trial::{Inputs, Judge};

/// How many such turns without a better layout are tried before all begins anew, at most.
const TRIES: u32 = 6;
/// With fewer movable things than this a new layout is found as fast.
const MANY: usize = 30;
/// A layout is worth it in which no more is violated than this part of the number of movable things, or so much.
const NEARLY: f64 = 0.1;
const FEW: usize = 3;
/// The part of the things that is taken away, at least and at most, and how many things that is at least.
const SHARE: [f64; 2] = [0.03, 0.15];
const LEAST: usize = 3;
/// What costs no more than this part of what it did is a success.
const LESS: f64 = 0.9;

/// The best layout since all began anew.
#[derive(Clone, Debug, Default)]
pub(super) struct Lineage {
    /// How much is violated, what that costs, where everything is, and whether paths were looked at.
    best: Option<(usize, f64, Vec<Inputs>, bool)>,
    /// How many turns began from it without success.
    tries: u32,
    /// The work when all began anew, and when that turn was over.
    begun: u64,
    over: Option<u64>,
}

impl Lineage {
    /// All begins anew, when so much work is done.
    pub fn begun_at(work: u64) -> Self {
        Self { begun: work, ..Self::default() }
    }
}

impl LocalSearch<'_> {
    /// Whether the next turn is to begin from a part of a layout.
    pub(super) fn may_ruin(&self) -> bool {
        let Lineage { best, tries, begun, over } = &self.course.lineage;
        // All of these turns together take no longer than the one before them: so they cannot cost much where they are no use.
        let spent = over.is_some_and(|over| self.trial.work - over > over - begun);
        let many = self.trial.movable.len() >= MANY;
        // Clusters that bar paths stand in the wrong places as a whole: to build parts of them anew is of no use.
        let bars = |walking: bool| walking && self.is_clustered && self.trial.path_count() > 0;
        let is_of_use = best.as_ref().is_some_and(|(.., walking)| !bars(*walking));
        many && !self.is_warm() && *tries < TRIES && !spent && is_of_use
    }

    /// Remembers the best layout since all began anew, of which so much is violated.
    pub(super) fn note_lineage(&mut self, bad: usize) {
        // Those in which nothing is wrong but that paths are barred come first.
        let bad = if self.walking || self.trial.path_count() == 0 { bad } else { bad + 1 };
        let most = ((NEARLY * self.trial.movable.len() as f64) as usize).max(FEW);
        let Lineage { best, tries, .. } = &mut self.course.lineage;
        let (least, least_cost) = best.as_ref().map_or((most, f64::INFINITY), |(bad, cost, ..)| (*bad, *cost));
        if bad > least {
            return;
        }
        let cost = self.trial.bad.iter().map(|&check| self.trial.cost[check]).sum::<f64>();
        if bad < least || cost < least_cost {
            if bad < least || cost < LESS * least_cost {
                *tries = 0;
            }
            *best = Some((bad, cost, self.trial.everything(), self.walking));
        }
    }

    /// How much is violated in the best layout, and where everything is.
    #[cfg(test)]
    pub(super) fn best_of_lineage(&self) -> Option<(usize, Vec<Inputs>)> {
        self.course.lineage.best.as_ref().map(|(bad, _, poses, _)| (*bad, poses.clone()))
    }

    /// Begins a turn from the best layout, a part of which is built anew.
    pub(super) fn ruin(&mut self, chance: &mut ChaCha8Rng, late: &dyn Fn() -> bool) {
        let lineage = &mut self.course.lineage;
        lineage.tries += 1;
        lineage.over.get_or_insert(self.trial.work);
        if let Some((.., poses, walking)) = lineage.best.clone() {
            self.walking = walking;
            self.trial.put_everything(&poses);
        }
        self.trial.judge_all();
        if self.walking {
            self.trial.judge_paths();
            self.trial.plan_missing(late);
        }
        let taken = self.to_rebuild(chance);
        let kept: Vec<bool> = taken.iter().map(|taken| !taken).collect();
        self.course.is_rebuilt = true;
        self.begin(chance, &kept, late);
        self.open_turn();
    }

    /// What is taken away: something that is violated, its cluster, and what stands nearest to it.
    fn to_rebuild(&self, chance: &mut ChaCha8Rng) -> Vec<bool> {
        let mut taken = vec![false; self.trial.count()];
        let mut at_fault = Vec::new();
        if let Some(&check) = self.trial.bad.get(chance.below(self.trial.bad.len())) {
            match self.trial.judges.get(check) {
                Some(Judge::PathGroup(group)) => at_fault = self.trial.hindrances(*group),
                _ => self.movers_of(check, &mut at_fault),
            }
        }
        let movable = &self.trial.movable;
        let Some(&core) =
            at_fault.get(chance.below(at_fault.len())).or_else(|| movable.get(chance.below(movable.len())))
        else {
            return taken;
        };
        taken[core] = true;
        let share = chance.between(SHARE[0], SHARE[1]);
        let count = ((share * movable.len() as f64) as usize).max(LEAST);
        let [x, _, z, ..] = self.trial.inputs(core);
        let far = |i: usize| {
            let there = self.trial.inputs(i);
            (there[0] - x).hypot(there[2] - z)
        };
        let mut nearest = movable.clone();
        nearest.sort_by(|&a, &b| far(a).total_cmp(&far(b)).then(a.cmp(&b)));
        nearest.into_iter().take(count).for_each(|i| taken[i] = true);
        if let Some(cluster) = self.clusters.of[core].filter(|_| chance.below(2) == 0) {
            self.clusters.members[cluster].iter().for_each(|&i| taken[i] = true);
        }
        taken
    }
}
