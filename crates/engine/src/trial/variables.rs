//! Decision variables: numbers that are changed, judged and taken back as poses are. They stand behind the objects in the
//! inputs of the code.

use super::{Inputs, Trial};
use crate::frame::{Frame, variables, variables_of_sizes};
use scenelang_lang::program::{ObjectId, VariableId, VariableKind};
use scenelang_verify::vector::V3;
use scenelang_verify::{Truth, Value, World};

/// A variable that was changed in a trial, and what it was.
pub(super) type MovedVariable = (usize, Inputs);

/// What is known of the decision variables.
pub struct Variables {
    kinds: Vec<VariableKind>,
    /// Whether a region or a size is made of it: such a one keeps its value.
    is_fixed: Vec<bool>,
    terms_of: Vec<Vec<usize>>,
    preferences_of: Vec<Vec<usize>>,
    pub(super) moved: Vec<MovedVariable>,
    /// Whether the trial that is being judged changes some.
    pub(super) are_moving: bool,
}

impl Variables {
    /// Those that have a value.
    pub fn new(frame: &Frame<'_>, world: &World<f64>) -> Self {
        let has_value = |id| world.variable(id).is_ok();
        debug_assert!(variables(frame.program).all(has_value));
        Self {
            is_fixed: {
                let of_sizes = variables_of_sizes(frame.program);
                variables(frame.program).map(|id| of_sizes.contains(&id)).collect()
            },
            kinds: frame.program.variables.iter().map(|variable| variable.kind).collect(),
            terms_of: Vec::new(),
            preferences_of: Vec::new(),
            moved: Vec::new(),
            are_moving: false,
        }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.kinds.len()
    }

    pub fn kind(&self, v: usize) -> VariableKind {
        self.kinds[v]
    }
}

impl Trial<'_> {
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
    pub fn is_settled(&self) -> bool {
        let Variables { terms_of, is_fixed, .. } = &self.variables;
        self.movable.is_empty() && std::iter::zip(terms_of, is_fixed).all(|(terms, fixed)| *fixed || terms.is_empty())
    }

    /// Where everything is, and behind that what the variables are and how things lean.
    pub fn everything(&self) -> Vec<Inputs> {
        let plain = (0..self.count() + self.variables.kinds.len()).map(|i| self.inputs(i));
        plain.chain(self.all_angles()).collect()
    }

    /// Puts everything where it was, without a look at anything.
    pub fn put_everything(&mut self, all: &[Inputs]) {
        let (poses, others) = all.split_at(self.count());
        let (values, angles) = others.split_at(self.variables.kinds.len());
        self.put_angles(angles);
        poses.iter().enumerate().for_each(|(i, pose)| self.put(i, *pose));
        values.iter().enumerate().for_each(|(v, value)| self.put_variable(v, *value));
    }

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
    pub fn go_variable(&mut self, v: usize, inputs: Inputs) {
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
    pub fn terms_of_variable(&self, v: usize) -> impl Iterator<Item = usize> + use<> {
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

    /// Variables that a check reads and that may change.
    pub fn open_variables(&self, check: usize) -> Vec<usize> {
        let read = self.frame.terms.get(check).map_or(&[][..], |term| &term.variables);
        read.iter().map(|v| v.0 as usize).filter(|v| !self.variables.is_fixed[*v]).collect()
    }
}
