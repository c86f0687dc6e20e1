//! Decision variables under local search: numbers that are tried, judged and taken back as poses are.
//!
//! They stand behind the objects in the inputs of the code. What must hold of them alone is seen to before anything gets a
//! place; after that a term that fails asks now for another pose of one of its objects, now for another value of one of its
//! variables.

use super::LocalSearch;
use crate::search::chance::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::trial::Inputs;
use scenelang_lang::program::VariableKind;
use scenelang_verify::{Truth, Value, coded};

/// How far a value is changed to see what that does (metres, degrees).
const PROBE: f64 = 1e-3;
/// How much further than needed one goes, against rounding.
const EASE: f64 = 1e-9;
/// How often the slope is followed: a product of variables is no straight line.
const FOLLOWED: usize = 4;
/// How many violated terms of a variable say where it should be.
const TERMS: usize = 6;
/// Changes at random are as large as this.
const FAR: [f64; 4] = [0.03, 0.3, 3.0, 60.0];
/// No value is greater.
const MOST: f64 = 1e6;
/// How many steps each variable is worth before anything has a place.
const STEPS: usize = 60;

impl LocalSearch<'_> {
    /// Sees to what must hold of variables alone, before anything has a place.
    pub(super) fn settle_variables(&mut self, chance: &mut ChaCha8Rng) {
        for _ in 0..STEPS * self.trial.variables.count() {
            let open: Vec<usize> = self.trial.bad.iter().flat_map(|check| self.trial.open_variables(*check)).collect();
            if open.is_empty() {
                break;
            }
            self.step_variable(open[chance.below(open.len())], chance);
        }
        self.trial.weight.fill(1.0);
    }

    /// Where a violated term reads variables, one of these may change in place of an object. Whether that was tried.
    pub(super) fn takes_variable(&mut self, check: usize, chance: &mut ChaCha8Rng) -> bool {
        let open = self.trial.open_variables(check);
        let Some(term) = self.trial.frame.terms.get(check).filter(|_| !open.is_empty()) else { return false };
        let objects = term.objects.iter().filter(|o| self.trial.is_movable(o.0 as usize)).count();
        let drawn = chance.below(open.len() + objects.min(2));
        if let Some(v) = open.get(drawn) {
            self.step_variable(*v, chance);
        }
        drawn < open.len()
    }

    /// A variable takes the best of many values, if that is better than the one it has.
    fn step_variable(&mut self, v: usize, chance: &mut ChaCha8Rng) {
        let candidates = self.candidates(v, chance);
        self.step_among(&candidates, chance, |local, value| local.trial.go_variable(v, value));
    }

    /// The best of some changes is made, if it is better than none; where none is, what is violated comes to weigh more.
    pub(super) fn step_among<T: Copy>(&mut self, all: &[T], chance: &mut ChaCha8Rng, go: impl Fn(&mut Self, T)) {
        let mut best = (1e-9, None);
        for &each in all {
            go(self, each);
            if let Some(delta) = self.trial.judge(best.0) {
                best = (delta, Some(each));
            }
            self.trial.undo();
        }
        if let Some(each) = best.1 {
            go(self, each);
            if self.trial.judge(f64::INFINITY).is_some() {
                self.trial.keep();
            } else {
                self.trial.undo();
            }
        }
        if best.0 > -1e-9 {
            self.insist(chance);
        }
    }

    /// Values to try: where its violated terms would hold, changes at random, and rounder numbers.
    fn candidates(&mut self, v: usize, chance: &mut ChaCha8Rng) -> Vec<Inputs> {
        let now = self.trial.inputs(self.trial.count() + v);
        let parts = match self.trial.variables.kind(v) {
            VariableKind::Bool => return vec![coded::variable(&Value::Truth(Truth::discrete(now[0] < 0.5)))],
            VariableKind::Number | VariableKind::Degree => 1,
            VariableKind::Vector | VariableKind::Rotation => 3,
        };
        let mut out = Vec::new();
        let mut terms: Vec<usize> = self.trial.terms_of_variable(v).filter(|&t| self.trial.cost[t] > 0.0).collect();
        while terms.len() > TERMS {
            terms.swap_remove(chance.below(terms.len()));
        }
        for part in 0..parts {
            for &t in &terms {
                self.where_it_holds(v, part, t, &mut out);
            }
            for far in FAR {
                let mut next = now;
                next[part] += chance.between(-far, far);
                out.push(next);
                next[part] = next[part].round();
                out.push(next);
            }
            let mut next = now;
            next[part] = 0.0;
            out.push(next);
        }
        let degrees = self.trial.variables.kind(v) == VariableKind::Degree;
        out.iter_mut().for_each(|value| {
            value[0] = if degrees { value[0].rem_euclid(360.0) } else { value[0].clamp(-MOST, MOST) };
        });
        out.retain(|value| *value != now && value.iter().all(|x| x.is_finite()));
        out
    }

    /// Along the slope to where a term would hold, and a little beyond.
    fn where_it_holds(&mut self, v: usize, part: usize, t: usize, out: &mut Vec<Inputs>) {
        let mut next = self.trial.inputs(self.trial.count() + v);
        for _ in 0..FOLLOWED {
            let missing = self.lacks_with(t, v, next);
            if missing == 0.0 {
                break;
            }
            let mut probe = next;
            probe[part] += PROBE;
            let slope = (self.lacks_with(t, v, probe) - missing) / PROBE;
            let step = -(missing + EASE) / slope;
            if !step.is_finite() || step.abs() > MOST {
                break;
            }
            next[part] += step;
            out.push(next);
        }
    }

    fn lacks_with(&mut self, t: usize, v: usize, value: Inputs) -> f64 {
        self.trial.go_variable(v, value);
        let lacks = self.trial.lacks(t);
        self.trial.work += 4;
        self.trial.undo();
        lacks
    }
}
