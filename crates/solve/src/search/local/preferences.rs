//! Once all that must hold does: preferences, the weightiest first. One that fails is demanded for a while; what comes of
//! that is kept where everything else still holds and the preferences together cost less.

use super::LocalSearch;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::frame::terms::Force;
use scenelang_engine::limit::Limit;
use scenelang_engine::trial::{Inputs, PathGroup, Trial};

/// How often all preferences are gone through.
const PASSES: usize = 2;
/// All preferences together cost about this, so that none is worth a violation.
const ALL: f64 = 0.05;
/// What a preference costs while it is demanded: as much as what must hold.
const DEMANDED: f64 = 1.0;
/// How many steps a demand is worth, for each object and in all.
const STEPS: [usize; 2] = [6, 60];
/// Weights and costs that differ by less are the same.
const SAME: f64 = 1e-6;
/// A preference: what it weighs, and the terms that it is made of.
pub(super) struct Preference {
    pub weight: f64,
    pub parts: Vec<usize>,
}

impl Preference {
    fn is_met(&self, trial: &Trial<'_>) -> bool {
        self.parts.iter().all(|&t| trial.does_hold(t))
    }
}

#[derive(Clone, Copy)]
pub(super) struct Standing {
    /// How much those weigh that hold.
    pub met: f64,
    /// What all of them cost.
    pub cost: f64,
}

impl Standing {
    /// How preferences stand in a layout.
    fn of(trial: &Trial<'_>, preferences: &[Preference]) -> Self {
        let met = preferences.iter().filter(|p| p.is_met(trial)).map(|p| p.weight).sum();
        let cost = weights(trial).map(|(t, weight)| weight * trial.cost[t]).sum();
        Self { met, cost }
    }

    /// Whether more weight holds, or all comes closer to holding.
    pub fn is_better(&self, other: &Self) -> bool {
        self.met > other.met + SAME || self.met > other.met - SAME && self.cost < other.cost - SAME
    }
}

/// A layout: where everything is, and the corridors that are planned.
pub(super) struct FoundLayout {
    poses: Vec<Inputs>,
    groups: Vec<PathGroup>,
}

impl LocalSearch<'_> {
    /// Improves a layout in which all holds that must, up to so much work. It keeps holding. What is `settled` is moved only
    /// for a preference that holds then. The higher the quality (usually 1), the longer it is tried without success.
    pub fn improve_preferences(
        &mut self,
        chance: &mut ChaCha8Rng,
        (budget, quality): (u64, f64),
        limit: &Limit,
        settled: bool,
    ) {
        let end = self.trial.work + budget;
        let mut preferences = self.preferences();
        if preferences.is_empty() || budget == 0 {
            return;
        }
        preferences.sort_by(|a, b| b.weight.total_cmp(&a.weight).then(a.parts.cmp(&b.parts)));
        self.trial.preferring = true;
        self.keeps_openings = settled;
        self.trial.weight.fill(1.0);
        let weights: Vec<(usize, f64)> = weights(&self.trial).collect();
        weights.into_iter().for_each(|(t, weight)| self.trial.weight[t] = weight);
        self.trial.judge_all();
        self.trial.judge_paths();
        self.trial.plan_missing(&|| limit.is_over());
        for _ in 0..PASSES {
            let before = self.standing(&preferences);
            for preference in &preferences {
                if self.trial.work >= end || limit.is_over() {
                    break;
                }
                if !preference.is_met(&self.trial) {
                    self.demand(preference, &preferences, chance, end, limit, settled);
                }
            }
            if !self.standing(&preferences).is_better(&before) {
                break;
            }
        }
        if !settled {
            self.optimise(&preferences, chance, (end, quality), limit);
        }
        self.keeps_openings = false;
    }

    /// Demands a preference for a while.
    fn demand(
        &mut self,
        preference: &Preference,
        all: &[Preference],
        chance: &mut ChaCha8Rng,
        end: u64,
        limit: &Limit,
        settled: bool,
    ) {
        let late = || limit.is_over();
        let (found, before, real) = (self.found(), self.standing(all), self.standing_with_paths(all));
        let (reluctance, weights) = (self.trial.reluctance.clone(), self.trial.weight.clone());
        self.trial.demand(preference.parts.iter().copied());
        preference.parts.iter().for_each(|&t| self.trial.weight[t] = DEMANDED);
        self.note_demand(preference);
        let mut poses = Vec::new();
        let mut steps = (STEPS[0] * self.trial.count()).max(STEPS[1]);
        while steps > 0 && !self.trial.bad.is_empty() && self.trial.work < end && !late() {
            self.step(chance, &mut poses);
            steps -= 1;
        }
        let done = self.is_done(&late);
        self.trial.demand([]);
        self.trial.weight = weights;
        self.trial.reluctance = reluctance;
        self.note_demand(preference);
        let better = done && self.standing(all).is_better(&before) && (!settled || preference.is_met(&self.trial));
        if !better || !self.standing_with_paths(all).is_better(&real) {
            self.show(&found);
        }
    }

    /// Counts a preference as violated where it fails, or no longer.
    fn note_demand(&mut self, preference: &Preference) {
        for &t in &preference.parts {
            let (cost, holds) = (self.trial.cost[t], self.trial.does_hold(t));
            self.trial.set(t, cost, holds);
        }
    }

    /// The preferences, each with the terms that it is made of.
    fn preferences(&self) -> Vec<Preference> {
        let mut found: Vec<(usize, Preference)> = Vec::new();
        for (t, term) in self.trial.frame.terms.iter().enumerate() {
            let Force::Soft(weight) = term.force else { continue };
            match found.last_mut().filter(|(constraint, _)| *constraint == term.constraint) {
                Some((_, preference)) => {
                    preference.weight += weight;
                    preference.parts.push(t);
                }
                None => found.push((term.constraint, Preference { weight, parts: vec![t] })),
            }
        }
        found.into_iter().map(|(_, preference)| preference).collect()
    }

    pub(super) fn standing(&self, preferences: &[Preference]) -> Standing {
        Standing::of(&self.trial, preferences)
    }

    /// The same with the paths that there are, where preferences ask for some.
    pub(super) fn standing_with_paths(&mut self, preferences: &[Preference]) -> Standing {
        self.trial.with_paths(|trial| Standing::of(trial, preferences))
    }

    /// Where everything is.
    pub(super) fn found(&self) -> FoundLayout {
        FoundLayout { poses: self.trial.everything(), groups: self.trial.groups.clone() }
    }

    /// Puts everything where it was.
    pub(super) fn show(&mut self, found: &FoundLayout) {
        self.trial.put_everything(&found.poses);
        self.trial.groups.clone_from(&found.groups);
        self.trial.judge_all();
        self.trial.judge_paths();
    }
}

/// Terms of preferences, each with its part of what all of them cost together.
fn weights(trial: &Trial<'_>) -> impl Iterator<Item = (usize, f64)> {
    let terms = &trial.frame.terms;
    let weight = |t: usize| if let Force::Soft(weight) = terms[t].force { weight } else { 0.0 };
    let all: f64 = (0..terms.len()).map(weight).sum();
    (0..terms.len()).filter(|&t| !terms[t].is_hard()).map(move |t| (t, ALL * weight(t) / all.max(1e-12)))
}
