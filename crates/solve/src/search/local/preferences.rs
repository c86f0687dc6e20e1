//! Once all that must hold does: preferences, the weightiest first. One that fails is demanded for a while; what comes of
//! that is kept where everything else still holds and the preferences together cost less.

use super::LocalSearch;
use super::moves::Inputs;
use crate::problem::limit::Limit;
use crate::problem::terms::Force;
use rand_chacha::ChaCha8Rng;

/// How often all preferences are gone through.
const PASSES: usize = 2;
/// All preferences together cost about this, so that none is worth a violation.
const ALL: f64 = 0.05;
/// What a preference costs while it is demanded: as much as what must hold.
const DEMANDED: f64 = 1.0;
/// How many steps a demand is worth, for each object and in all.
const STEPS: [usize; 2] = [6, 60];

impl LocalSearch<'_> {
    /// Whether a term counts at present: it must hold, or preferences are looked at.
    pub(super) fn counts(&self, t: usize) -> bool {
        self.preferring || self.frame.terms[t].is_hard()
    }

    /// What preferences cost together.
    pub fn preferences_cost(&self) -> f64 {
        let soft = (0..self.frame.terms.len()).filter(|&t| !self.frame.terms[t].is_hard());
        soft.map(|t| self.weight_of_preference(t) * self.cost[t]).sum()
    }

    fn weight_of_preference(&self, t: usize) -> f64 {
        let weight = |t: usize| if let Force::Soft(weight) = self.frame.terms[t].force { weight } else { 0.0 };
        let all: f64 = (0..self.frame.terms.len()).map(weight).sum();
        ALL * weight(t) / all.max(1e-12)
    }

    /// Improves a layout in which all holds that must, up to so much work. It keeps holding.
    pub fn improve_preferences(&mut self, chance: &mut ChaCha8Rng, budget: u64, limit: &Limit, settled: bool) {
        let late = || limit.is_over();
        let end = self.work + budget;
        let mut preferences: Vec<usize> =
            (0..self.frame.terms.len()).filter(|&t| !self.frame.terms[t].is_hard()).collect();
        if preferences.is_empty() {
            return;
        }
        preferences
            .sort_by(|&a, &b| self.weight_of_preference(b).total_cmp(&self.weight_of_preference(a)).then(a.cmp(&b)));
        self.preferring = true;
        self.weight.fill(1.0);
        for &t in &preferences {
            self.weight[t] = self.weight_of_preference(t);
        }
        self.judge_all();
        self.judge_paths();
        for _ in 0..PASSES {
            let before = self.preferences_cost();
            for &t in &preferences {
                if self.work >= end || late() {
                    break;
                }
                if !self.does_hold(t) {
                    self.demand(t, chance, end, limit, settled);
                }
            }
            if self.preferences_cost() >= before - 1e-9 {
                break;
            }
        }
    }

    /// Demands a preference for a while.
    fn demand(&mut self, t: usize, chance: &mut ChaCha8Rng, end: u64, limit: &Limit, settled: bool) {
        let late = || limit.is_over();
        let before: Vec<Inputs> = (0..self.count()).map(|i| self.inputs(i)).collect();
        let (cost, reluctance) = (self.preferences_cost(), self.reluctance.clone());
        let (weights, groups) = (self.weight.clone(), self.groups.clone());
        self.weight[t] = DEMANDED;
        self.demanded = Some(t);
        let (now, holds) = (self.cost[t], self.does_hold(t));
        self.set(t, now, holds);
        let mut poses = Vec::new();
        let mut steps = (STEPS[0] * self.count()).max(STEPS[1]);
        while steps > 0 && !self.bad.is_empty() && self.work < end && !late() {
            self.step(chance, &mut poses);
            steps -= 1;
        }
        let done = self.is_done(&late);
        self.demanded = None;
        self.weight = weights;
        self.reluctance = reluctance;
        let (now, holds) = (self.cost[t], self.does_hold(t));
        self.set(t, now, holds);
        let better = self.preferences_cost() < cost - 1e-9;
        if !done || !better || settled && !holds {
            for (i, inputs) in before.into_iter().enumerate() {
                self.put(i, inputs);
            }
            self.groups = groups;
            self.judge_all();
            self.judge_paths();
        }
    }
}
