//! Preferences against each other, once all that must hold does: a search for the layout in which the most weight of them
//! holds.
//!
//! It is the search for what must hold, with preferences among what may be violated. A preference that fails is worth its
//! weight, and more the longer it fails, up to a bound; what must hold comes to weigh more without one, so that the search
//! goes back and forth over its edge. Each layout in which all that must hold does is compared with the best so far
//! (Lei, Cai: Solving (weighted) partial MaxSAT by dynamic local search for SAT, 2018). While something that must hold does
//! not, unmet preferences lose weight again where no move helps: otherwise a search in a crowded room stays beyond the edge
//! for most of its steps (Gendreau, Hertz, Laporte: A tabu search heuristic for the vehicle routing problem, 1994).

use super::LocalSearch;
use super::preferences::Preference;
use crate::search::chance::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::frame::checks::Check;
use scenelang_engine::limit::Limit;

/// What the heaviest preference costs: at first, by how much more each time that no move helps, and at most.
const AT_FIRST: f64 = 0.1;
const MORE: f64 = 0.3;
const AT_MOST: f64 = 20.0;
/// What is left of that, each time that no move helps, while something that must hold does not.
const YIELDS: f64 = 0.85;
/// What a violated check gains in weight when no move helps.
const STUBBORN: f64 = 0.5;
/// Steps without a better layout, for each object and in all, after which all weighs what it did at first, and so many such
/// rounds in a row are the end, at the usual quality.
const PATIENCE: [usize; 2] = [20, 100];
const ROUNDS: f64 = 5.0;
/// A round begins from the best layout once in so many times, else from where the search is, if all that must hold does there.
const FROM_BEST: usize = 2;
/// How many times more rounds there are for what is unmet, if that is all of the weight: the more there is to gain, the longer
/// it is tried.
const UNMET: f64 = 8.0;
/// The work that it may take for each object, at the usual quality.
const WORK: f64 = 300_000.0;
/// How often another check is drawn where the first was a preference and something that must hold does not.
const DRAWS: usize = 3;
impl LocalSearch<'_> {
    /// Looks for a layout in which preferences of more weight hold than in this one, in which all holds that must. It goes
    /// on holding.
    pub(super) fn optimise(
        &mut self,
        preferences: &[Preference],
        chance: &mut ChaCha8Rng,
        (end, quality): (u64, f64),
        limit: &Limit,
    ) {
        let weights = self.trial.weight.clone();
        self.stake = self.stakes(preferences);
        self.trial.demand((0..self.stake.len()).filter(|&t| self.stake[t] > 0.0));
        self.weigh_anew();
        let (mut best, mut found) = (self.standing(preferences), self.found());
        let mut real = self.standing_with_paths(preferences);
        let patience = PATIENCE[0] * self.trial.count() + PATIENCE[1];
        let all = preferences.iter().map(|p| p.weight).sum::<f64>().max(1e-12);
        let most = |met: f64| (ROUNDS * quality * (1.0 + UNMET * (1.0 - met / all))).ceil() as usize;
        let end = end.min(self.trial.work + (WORK * quality * self.trial.count() as f64) as u64);
        let (mut idle, mut rounds) = (0, 0);
        let mut poses = Vec::new();
        while self.trial.work < end && !limit.is_over() && rounds < most(best.met) && !self.trial.bad.is_empty() {
            self.step(chance, &mut poses);
            idle += 1;
            if self.is_allowed() {
                let now = self.standing(preferences);
                if now.is_better(&best) && self.is_allowed_paths(limit) {
                    let with_paths = self.standing_with_paths(preferences);
                    if with_paths.is_better(&real) {
                        if now.met > best.met {
                            (idle, rounds) = (0, 0);
                        }
                        (best, real, found) = (now, with_paths, self.found());
                    }
                }
            }
            if idle > patience {
                (idle, rounds) = (0, rounds + 1);
                if chance.below(FROM_BEST) == 0 || !self.is_allowed() {
                    self.show(&found);
                }
                self.weigh_anew();
            }
        }
        self.stake.clear();
        self.trial.demand([]);
        self.trial.weight = weights;
        self.show(&found);
    }

    /// Whether all holds that must, as far as a search looks at it.
    fn is_allowed(&self) -> bool {
        !self.trial.bad.iter().any(|&check| self.trial.is_hard(check))
    }

    /// The same for paths that terms ask for beside other things.
    fn is_allowed_paths(&mut self, limit: &Limit) -> bool {
        self.trial.path_terms.is_empty() || self.trial.find_paths(&|| limit.is_over())
    }

    /// By term: what it is worth, the heaviest preference 1; 0: nothing can be done for it, or it must hold.
    fn stakes(&self, preferences: &[Preference]) -> Vec<f64> {
        let most = preferences.iter().map(|p| p.weight).fold(1e-12, f64::max);
        let mut stakes = vec![0.0; self.trial.frame.terms.len()];
        let mut movers = Vec::new();
        for preference in preferences {
            for &part in &preference.parts {
                movers.clear();
                self.movers_of(part, &mut movers);
                if !movers.is_empty() {
                    stakes[part] = preference.weight / most / (preference.parts.len() as f64).sqrt();
                }
            }
        }
        stakes
    }

    /// All weighs what it weighs at first.
    fn weigh_anew(&mut self) {
        self.trial.weight.fill(1.0);
        for t in 0..self.stake.len() {
            if !self.trial.is_hard(t) {
                self.trial.weight[t] = AT_FIRST * self.stake[t];
                let (cost, holds) = (self.trial.cost[t], self.trial.holds[t]);
                self.trial.set(t, cost, holds);
            }
        }
    }

    /// Something violated to take up: rather what must hold than a preference, and of those rather one that weighs more.
    pub(super) fn pick(&self, chance: &mut ChaCha8Rng) -> usize {
        let mut draw = || self.trial.bad[chance.below(self.trial.bad.len())];
        let mut check = draw();
        if self.stake.is_empty() {
            return check;
        }
        for _ in 0..DRAWS {
            if self.trial.is_hard(check) {
                break;
            }
            let other = draw();
            if self.trial.is_hard(other) || self.trial.weight[other] > self.trial.weight[check] {
                check = other;
            }
        }
        check
    }

    /// No move helps: what is violated comes to weigh more, preferences only where all holds that must; else they lose weight.
    pub(super) fn insist(&mut self, chance: &mut ChaCha8Rng) {
        let optimising = !self.stake.is_empty();
        let broken = !optimising || self.trial.bad.iter().any(|&check| self.trial.is_hard(check));
        for at in 0..self.trial.bad.len() {
            let check = self.trial.bad[at];
            if !optimising || self.trial.is_hard(check) {
                self.trial.weight[check] += STUBBORN * chance.unit();
            } else if broken {
                self.trial.weight[check] = (YIELDS * self.trial.weight[check]).max(AT_FIRST * self.stake[check]);
            } else {
                let stake = self.stake[check];
                self.trial.weight[check] =
                    (self.trial.weight[check] + MORE * stake * chance.unit()).min(AT_MOST * stake);
            }
        }
    }

    /// Everything movable that a check speaks of.
    pub(super) fn movers_of(&self, check: usize, out: &mut Vec<usize>) {
        let mut moves = |i: usize| self.movers(i, 0, out);
        match self.trial.numbering.check(check) {
            Check::Term(t) => self.trial.frame.terms[t].objects.iter().for_each(|o| moves(o.0 as usize)),
            Check::Collide(a, b) => [a, b].iter().for_each(|o| moves(o.0 as usize)),
            Check::Bounds(a) | Check::Support(a) => moves(a.0 as usize),
        }
    }
}
