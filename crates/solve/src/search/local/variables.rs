//! Decision variables under local search: numbers that are tried, judged and taken back as poses are.
//!
//! They stand behind the objects in the inputs of the code. What must hold of them alone is seen to before anything gets a
//! place; after that a term that fails asks now for another pose of one of its objects, now for another value of one of its
//! variables.

use super::LocalSearch;
use super::moves::Inputs;
use crate::problem::values;
use crate::search::chance::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::frame::Frame;
use scenelang_lang::program::{ObjectId, VariableId, VariableKind};
use scenelang_verify::coded;
use scenelang_verify::vector::V3;
use scenelang_verify::{Truth, Value, World};

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

/// A variable that was changed in a trial, and what it was.
pub(super) type MovedVariable = (usize, Inputs);

/// What is known of the decision variables.
pub(super) struct Variables {
    kinds: Vec<VariableKind>,
    /// Whether a region or a size is made of it: such a one keeps its value.
    is_fixed: Vec<bool>,
    terms_of: Vec<Vec<usize>>,
    preferences_of: Vec<Vec<usize>>,
    pub moved: Vec<MovedVariable>,
    /// Whether the trial that is being judged changes some.
    pub are_moving: bool,
}

impl Variables {
    /// Those that have a value.
    pub fn new(frame: &Frame<'_>, world: &World<f64>) -> Self {
        let has_value = |id| world.variable(id).is_ok();
        debug_assert!(scenelang_engine::frame::variables(frame.program).all(has_value));
        Self {
            is_fixed: {
                let of_sizes = values::of_sizes(frame.program);
                scenelang_engine::frame::variables(frame.program).map(|id| of_sizes.contains(&id)).collect()
            },
            kinds: frame.program.variables.iter().map(|variable| variable.kind).collect(),
            terms_of: Vec::new(),
            preferences_of: Vec::new(),
            moved: Vec::new(),
            are_moving: false,
        }
    }
}

impl LocalSearch<'_> {
    /// Which terms read which variables.
    pub(super) fn know_variables(&mut self) {
        for hard in [true, false] {
            let of = |v: usize| {
                let terms = self.frame.index.of_variable(VariableId(v as u32)).iter().copied();
                terms.filter(|&t| self.frame.terms[t].is_hard() == hard && self.is_judged_alone(t)).collect()
            };
            let lists = (0..self.variables.kinds.len()).map(of).collect();
            *if hard { &mut self.variables.terms_of } else { &mut self.variables.preferences_of } = lists;
        }
    }

    /// Whether there is nothing to try: all poses and all values are fixed.
    pub(super) fn is_settled(&self) -> bool {
        let Variables { terms_of, is_fixed, .. } = &self.variables;
        self.movable.is_empty() && std::iter::zip(terms_of, is_fixed).all(|(terms, fixed)| *fixed || terms.is_empty())
    }

    /// Where everything is, and behind that what the variables are and how things lean.
    pub(super) fn everything(&self) -> Vec<Inputs> {
        let plain = (0..self.count() + self.variables.kinds.len()).map(|i| self.inputs(i));
        plain.chain(self.all_angles()).collect()
    }

    /// Puts everything where it was, without a look at anything.
    pub(super) fn put_everything(&mut self, all: &[Inputs]) {
        let (poses, others) = all.split_at(self.count());
        let (values, angles) = others.split_at(self.variables.kinds.len());
        self.put_angles(angles);
        poses.iter().enumerate().for_each(|(i, pose)| self.put(i, *pose));
        values.iter().enumerate().for_each(|(v, value)| self.put_variable(v, *value));
    }

    /// The variables and their values.
    pub fn values(&self) -> impl Iterator<Item = (VariableId, Value<f64>)> + '_ {
        (0..self.variables.kinds.len()).map(|v| (VariableId(v as u32), self.value(v)))
    }

    fn value(&self, v: usize) -> Value<f64> {
        let [a, b, c, ..] = self.inputs(self.count() + v);
        match self.variables.kinds[v] {
            VariableKind::Number | VariableKind::Degree => Value::Number(a),
            VariableKind::Vector => Value::Vector(V3([a, b, c])),
            VariableKind::Rotation => Value::Rotation(V3([a, b, c])),
            VariableKind::Bool => Value::Truth(Truth::discrete(a > 0.5)),
        }
    }

    fn put_variable(&mut self, v: usize, inputs: Inputs) {
        self.slots.put(ObjectId((self.count() + v) as u32), inputs);
        let value = self.value(v);
        self.instance.set_variable(VariableId(v as u32), value);
    }

    /// Begins a trial: a variable takes a value, and what is fixed by it goes along.
    fn go_variable(&mut self, v: usize, inputs: Inputs) {
        let old = self.inputs(self.count() + v);
        self.variables.moved.push((v, old));
        self.put_variable(v, inputs);
        for at in 0..self.frame.variable_followers[v].len() {
            let rule = self.frame.variable_followers[v][at];
            self.obey(rule, 0);
        }
    }

    pub(super) fn undo_variables(&mut self) {
        while let Some((v, old)) = self.variables.moved.pop() {
            self.put_variable(v, old);
        }
    }

    /// All variables count as changed.
    pub(super) fn all_variables_move(&mut self) {
        let all = 0..self.variables.kinds.len();
        self.variables.moved = all.map(|v| (v, self.inputs(self.count() + v))).collect();
    }

    /// The terms of a variable that count at present.
    fn terms_of_variable(&self, v: usize) -> impl Iterator<Item = usize> + use<> {
        let preferences = if self.preferring { &self.variables.preferences_of[v][..] } else { &[] };
        let all: Vec<usize> = self.variables.terms_of[v].iter().chain(preferences).copied().collect();
        all.into_iter()
    }

    /// What the terms of changed variables cost before, those not counted that objects in the trial have, too.
    pub(super) fn cost_of_variables(&mut self, variables: &[MovedVariable]) -> f64 {
        let mut sum = 0.0;
        for t in variables.iter().flat_map(|(v, _)| self.terms_of_variable(*v)).collect::<Vec<_>>() {
            if std::mem::replace(&mut self.stamp[t], self.now) != self.now {
                sum += self.weight[t] * self.cost[t];
            }
        }
        sum
    }

    /// What they cost now.
    pub(super) fn judge_variables(&mut self, variables: &[MovedVariable]) -> f64 {
        self.variables.are_moving = !variables.is_empty();
        let mut sum = 0.0;
        for t in variables.iter().flat_map(|(v, _)| self.terms_of_variable(*v)).collect::<Vec<_>>() {
            if std::mem::replace(&mut self.stamp[t], self.now) != self.now {
                let found = self.term(t);
                sum += self.note(t, found);
            }
        }
        sum
    }

    /// Sees to what must hold of variables alone, before anything has a place.
    pub(super) fn settle_variables(&mut self, chance: &mut ChaCha8Rng) {
        for _ in 0..STEPS * self.variables.kinds.len() {
            let open: Vec<usize> = self.bad.iter().flat_map(|check| self.open_variables(*check)).collect();
            if open.is_empty() {
                break;
            }
            self.step_variable(open[chance.below(open.len())], chance);
        }
        self.weight.fill(1.0);
    }

    /// Where a violated term reads variables, one of these may change in place of an object. Whether that was tried.
    pub(super) fn takes_variable(&mut self, check: usize, chance: &mut ChaCha8Rng) -> bool {
        let open = self.open_variables(check);
        let Some(term) = self.frame.terms.get(check).filter(|_| !open.is_empty()) else { return false };
        let objects = term.objects.iter().filter(|o| self.is_movable(o.0 as usize)).count();
        let drawn = chance.below(open.len() + objects.min(2));
        if let Some(v) = open.get(drawn) {
            self.step_variable(*v, chance);
        }
        drawn < open.len()
    }

    /// Variables that a check reads and that may change.
    fn open_variables(&self, check: usize) -> Vec<usize> {
        let read = self.frame.terms.get(check).map_or(&[][..], |term| &term.variables);
        read.iter().map(|v| v.0 as usize).filter(|v| !self.variables.is_fixed[*v]).collect()
    }

    /// A variable takes the best of many values, if that is better than the one it has.
    fn step_variable(&mut self, v: usize, chance: &mut ChaCha8Rng) {
        let candidates = self.candidates(v, chance);
        self.step_among(&candidates, chance, |local, value| local.go_variable(v, value));
    }

    /// The best of some changes is made, if it is better than none; where none is, what is violated comes to weigh more.
    pub(super) fn step_among<T: Copy>(&mut self, all: &[T], chance: &mut ChaCha8Rng, go: impl Fn(&mut Self, T)) {
        let mut best = (1e-9, None);
        for &each in all {
            go(self, each);
            if let Some(delta) = self.judge(best.0) {
                best = (delta, Some(each));
            }
            self.undo();
        }
        if let Some(each) = best.1 {
            go(self, each);
            if self.judge(f64::INFINITY).is_some() {
                self.keep();
            } else {
                self.undo();
            }
        }
        if best.0 > -1e-9 {
            self.insist(chance);
        }
    }

    /// Values to try: where its violated terms would hold, changes at random, and rounder numbers.
    fn candidates(&mut self, v: usize, chance: &mut ChaCha8Rng) -> Vec<Inputs> {
        let now = self.inputs(self.count() + v);
        let parts = match self.variables.kinds[v] {
            VariableKind::Bool => return vec![coded::variable(&Value::Truth(Truth::discrete(now[0] < 0.5)))],
            VariableKind::Number | VariableKind::Degree => 1,
            VariableKind::Vector | VariableKind::Rotation => 3,
        };
        let mut out = Vec::new();
        let mut terms: Vec<usize> = self.terms_of_variable(v).filter(|&t| self.cost[t] > 0.0).collect();
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
        let degrees = self.variables.kinds[v] == VariableKind::Degree;
        out.iter_mut().for_each(|value| {
            value[0] = if degrees { value[0].rem_euclid(360.0) } else { value[0].clamp(-MOST, MOST) };
        });
        out.retain(|value| *value != now && value.iter().all(|x| x.is_finite()));
        out
    }

    /// Along the slope to where a term would hold, and a little beyond.
    fn where_it_holds(&mut self, v: usize, part: usize, t: usize, out: &mut Vec<Inputs>) {
        let mut next = self.inputs(self.count() + v);
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
        self.go_variable(v, value);
        let lacks = self.lacks(t);
        self.work += 4;
        self.undo();
        lacks
    }
}
