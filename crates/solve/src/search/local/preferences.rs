//! Once all that must hold does: preferences, the weightiest first. One that fails is demanded for a while; what comes of
//! that is kept where everything else still holds and the preferences together cost less.

use super::LocalSearch;
use super::moves::Inputs;
use super::paths::PathGroup;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::frame::terms::Force;
use scenelang_engine::limit::Limit;

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

/// How preferences stand.
#[derive(Clone, Copy)]
pub(super) struct Standing {
    /// How much those weigh that hold.
    pub met: f64,
    /// What all of them cost.
    pub cost: f64,
}

impl Standing {
    /// Whether more weight holds, or all comes closer to holding.
    pub fn is_better(&self, other: &Self) -> bool {
        self.met > other.met + SAME || self.met > other.met - SAME && self.cost < other.cost - SAME
    }
}

/// A layout: where everything is, and the corridors that are planned.
pub(super) struct Found {
    poses: Vec<Inputs>,
    groups: Vec<PathGroup>,
}

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

    /// Improves a layout in which all holds that must, up to so much work. It keeps holding. What is `settled` is moved only
    /// for a preference that holds then. The higher the quality (usually 1), the longer it is tried without success.
    pub fn improve_preferences(
        &mut self,
        chance: &mut ChaCha8Rng,
        (budget, quality): (u64, f64),
        limit: &Limit,
        settled: bool,
    ) {
        let end = self.work + budget;
        let mut preferences = self.preferences();
        if preferences.is_empty() || budget == 0 {
            return;
        }
        preferences.sort_by(|a, b| b.weight.total_cmp(&a.weight).then(a.parts.cmp(&b.parts)));
        self.preferring = true;
        self.weight.fill(1.0);
        for t in preferences.iter().flat_map(|p| &p.parts) {
            self.weight[*t] = self.weight_of_preference(*t);
        }
        self.judge_all();
        self.judge_paths();
        self.plan_missing(&|| limit.is_over());
        for _ in 0..PASSES {
            let before = self.standing(&preferences);
            for preference in &preferences {
                if self.work >= end || limit.is_over() {
                    break;
                }
                if !self.is_met(preference) {
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
        let (reluctance, weights) = (self.reluctance.clone(), self.weight.clone());
        self.demanded.clone_from(&preference.parts);
        preference.parts.iter().for_each(|&t| self.weight[t] = DEMANDED);
        self.note_demand(preference);
        let mut poses = Vec::new();
        let mut steps = (STEPS[0] * self.count()).max(STEPS[1]);
        while steps > 0 && !self.bad.is_empty() && self.work < end && !late() {
            self.step(chance, &mut poses);
            steps -= 1;
        }
        let done = self.is_done(&late);
        self.demanded.clear();
        self.weight = weights;
        self.reluctance = reluctance;
        self.note_demand(preference);
        let better = done && self.standing(all).is_better(&before) && (!settled || self.is_met(preference));
        if !better || !self.standing_with_paths(all).is_better(&real) {
            self.show(&found);
        }
    }

    /// Counts a preference as violated where it fails, or no longer.
    fn note_demand(&mut self, preference: &Preference) {
        for &t in &preference.parts {
            let (cost, holds) = (self.cost[t], self.does_hold(t));
            self.set(t, cost, holds);
        }
    }

    /// The preferences, each with the terms that it is made of.
    fn preferences(&self) -> Vec<Preference> {
        let mut found: Vec<(usize, Preference)> = Vec::new();
        for (t, term) in self.frame.terms.iter().enumerate() {
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

    fn is_met(&self, preference: &Preference) -> bool {
        preference.parts.iter().all(|&t| self.does_hold(t))
    }

    /// How the preferences stand.
    pub(super) fn standing(&self, preferences: &[Preference]) -> Standing {
        let met = preferences.iter().filter(|p| self.is_met(p)).map(|p| p.weight).sum();
        Standing { met, cost: self.preferences_cost() }
    }

    /// The same with the paths that there are, where preferences ask for some.
    pub(super) fn standing_with_paths(&mut self, preferences: &[Preference]) -> Standing {
        self.with_paths(|local| local.standing(preferences))
    }

    /// Where everything is.
    pub(super) fn found(&self) -> Found {
        Found { poses: self.everything(), groups: self.groups.clone() }
    }

    /// Puts everything where it was.
    pub(super) fn show(&mut self, found: &Found) {
        self.put_everything(&found.poses);
        self.groups.clone_from(&found.groups);
        self.judge_all();
        self.judge_paths();
    }
}
