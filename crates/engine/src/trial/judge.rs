//! What a trial costs more than what was before: only what the moved objects touch is looked at.

use super::variables::MovedVariable;
use super::{Inputs, Judge, Moved, Span, Trial};
use crate::frame::checks::Check;
use crate::penalty::{Penalty, Truths};
use scenelang_lang::program::{NodeId, ObjectId};
use scenelang_verify::Truth;
use scenelang_verify::coded::{Coded, Slots};
use std::marker::PhantomData;

/// Truths of code that has run.
struct Ran<'r> {
    code: &'r Coded,
    slots: &'r Slots,
}

impl Truths<f64> for Ran<'_> {
    fn truth(&self, node: NodeId) -> Option<Truth<f64>> {
        self.code.truth(node, self.slots)
    }
}

impl Trial<'_> {
    /// By how much a trial costs more than what was before; `None`: more than `limit`.
    pub fn judge(&mut self, limit: f64) -> Option<f64> {
        self.fresh.clear();
        self.now = self.now.wrapping_add(1);
        let moved = std::mem::take(&mut self.moved);
        let variables = std::mem::take(&mut self.variables.moved);
        let delta = self.judge_moved(&moved, &variables, limit);
        (self.moved, self.variables.moved) = (moved, variables);
        delta
    }

    fn judge_moved(&mut self, moved: &[Moved], variables: &[MovedVariable], limit: f64) -> Option<f64> {
        let mut delta = 0.0;
        for &(i, ..) in moved {
            let id = ObjectId(i as u32);
            delta -= self.before(self.numbering.bounds(id));
            delta -= self.before(self.numbering.support(id));
            for at in 0..self.terms_of[i].len() {
                delta -= self.before(self.terms_of[i][at]);
            }
            for at in 0..if self.preferring { self.preferences_of[i].len() } else { 0 } {
                delta -= self.before(self.preferences_of[i][at]);
            }
            for at in 0..self.hits[i].len() {
                delta -= self.before(self.numbering.collide(id, ObjectId(self.hits[i][at] as u32)));
            }
        }
        delta -= self.cost_of_variables(variables);
        self.now = self.now.wrapping_add(1);
        for &(i, ..) in moved {
            let check = self.numbering.bounds(ObjectId(i as u32));
            if self.bounded[i] && !self.away[i] {
                let found = self.bounds(i);
                delta += self.note(check, found);
            }
            let check = self.numbering.support(ObjectId(i as u32));
            if self.rests[i] && !self.away[i] {
                let found = self.support(i);
                delta += self.note(check, found);
            }
            if delta > limit {
                return None;
            }
        }
        for &(i, ..) in moved {
            delta += self.collisions(i, moved);
            if delta > limit {
                return None;
            }
        }
        let alone = moved.len() == 1 && variables.is_empty();
        for &(i, ..) in moved {
            for at in 0..self.terms_of[i].len() {
                let t = self.terms_of[i][at];
                if !alone && std::mem::replace(&mut self.stamp[t], self.now) == self.now {
                    continue;
                }
                let found = self.term(t);
                delta += self.note(t, found);
                if delta > limit {
                    // What often decides is asked earlier the next time.
                    self.terms_of[i].swap(at, at.saturating_sub(1));
                    return None;
                }
            }
        }
        for &(i, ..) in moved {
            for at in 0..if self.preferring { self.preferences_of[i].len() } else { 0 } {
                let t = self.preferences_of[i][at];
                if !alone && std::mem::replace(&mut self.stamp[t], self.now) == self.now {
                    continue;
                }
                let found = self.term(t);
                delta += self.note(t, found);
            }
        }
        delta += self.judge_variables(variables);
        delta += self.others_above(moved) + self.onlookers(moved) + self.paths_change(moved);
        (delta <= limit).then_some(delta)
    }

    /// What a check cost before the trial, if that was not yet asked of it.
    fn before(&mut self, check: usize) -> f64 {
        if std::mem::replace(&mut self.stamp[check], self.now) == self.now {
            return 0.0;
        }
        self.weight[check] * self.cost[check]
    }

    pub(super) fn note(&mut self, check: usize, (cost, holds): (f64, bool)) -> f64 {
        self.fresh.push((check, cost, holds));
        self.weight[check] * cost
    }

    /// What a term costs, and whether it holds.
    pub fn term(&mut self, t: usize) -> (f64, bool) {
        if self.away_count > 0 && self.frame.terms[t].objects.iter().any(|o| self.away[o.0 as usize]) {
            return (0.0, true);
        }
        let code = match &self.judges[t] {
            Judge::Code(code) => code,
            Judge::Inside(i, room) => {
                let (i, contact) = (*i, self.tolerances.contact);
                let clearance = self.rooms[*room].clearance(&self.span[i], || self.flat(i));
                return self.physical(clearance + contact, contact);
            }
            Judge::Clear(clear) => {
                let clear = *clear;
                return self.clear(&clear);
            }
            Judge::Mixed(_) => return self.mixed(t),
            Judge::PathGroup(_) | Judge::Shared(_) | Judge::Turn | Judge::Absent => return (0.0, true),
        };
        self.work += 3 + code.steps() as u64 / 8;
        code.run(&mut self.slots);
        let ran = Ran { code, slots: &self.slots };
        let penalty = Penalty {
            formula: &self.frame.terms[t].formula,
            values: &ran,
            tolerances: &self.tolerances,
            numbers: PhantomData,
        };
        penalty.both()
    }

    /// What a term lacks (metres).
    pub fn lacks(&mut self, t: usize) -> f64 {
        let mut missing: Vec<f64> = Vec::new();
        if let Judge::Code(code) = &self.judges[t] {
            code.run(&mut self.slots);
            let values = Ran { code, slots: &self.slots };
            let formula = &self.frame.terms[t].formula;
            let penalty = Penalty { formula, values: &values, tolerances: &self.tolerances, numbers: PhantomData };
            penalty.residuals(&mut missing);
        } else {
            self.mixed_with(t, |penalty| penalty.residuals(&mut missing));
        }
        missing.into_iter().sum()
    }

    /// What stands on something: its carrier may have come or gone.
    fn others_above(&mut self, moved: &[Moved]) -> f64 {
        let mut sum = 0.0;
        if self.raised_count == 0 {
            return sum;
        }
        for k in 0..self.count() {
            if !self.raised[k] || !self.rests[k] || self.is_moved[k] {
                continue;
            }
            let span = self.span[k];
            let over = |s: &Span| {
                s.min[0] < span.max[0] && span.min[0] < s.max[0] && s.min[2] < span.max[2] && span.min[2] < s.max[2]
            };
            if moved.iter().any(|(m, _, old)| over(old) || over(&self.span[*m])) {
                let check = self.numbering.support(ObjectId(k as u32));
                let found = self.support(k);
                sum += self.note(check, found) - self.weight[check] * self.cost[check];
            }
        }
        sum
    }

    /// Spaces that something moved into, or out of.
    fn onlookers(&mut self, moved: &[Moved]) -> f64 {
        let mut sum = 0.0;
        for at in 0..self.onlookers.len() {
            let t = self.onlookers[at];
            let own = |o: &ObjectId| self.is_moved[o.0 as usize];
            let judged = self.stamp[t] == self.now && self.variables.are_moving;
            if judged || !self.counts(t) || self.frame.terms[t].objects.iter().any(own) {
                continue;
            }
            if self.is_seen(t, moved) {
                let found = self.term(t);
                sum += self.note(t, found) - self.weight[t] * self.cost[t];
            }
        }
        sum
    }

    /// Keeps a trial that was judged to its end.
    pub fn keep(&mut self) {
        let moved = std::mem::take(&mut self.moved);
        for &(i, ..) in &moved {
            self.near.set(i, &self.span[i]);
        }
        for &(i, ..) in &moved {
            for j in std::mem::take(&mut self.hits[i]) {
                self.hits[j].retain(|k| *k != i);
                self.set(self.numbering.collide(ObjectId(i as u32), ObjectId(j as u32)), 0.0, true);
            }
            let on_something = self.rests[i] && !self.away[i] && self.above_floor(i) > self.tolerances.support;
            let raised = on_something || self.container[i].is_some();
            self.raised_count = self.raised_count + usize::from(raised) - usize::from(self.raised[i]);
            self.raised[i] = raised;
            let seat = self.container[i].or_else(|| if raised { self.find_seat(i) } else { None });
            self.seats.sit(i, seat);
        }
        self.paths_keep(&moved);
        let fresh = std::mem::take(&mut self.fresh);
        for &(check, cost, holds) in &fresh {
            self.set(check, cost, holds);
            if let Check::Collide(a, b) = self.numbering.check(check) {
                self.hits[a.0 as usize].push(b.0 as usize);
                self.hits[b.0 as usize].push(a.0 as usize);
            }
        }
        self.fresh = fresh;
        moved.iter().for_each(|&(i, ..)| self.is_moved[i] = false);
        self.moved = moved;
        self.moved.clear();
        self.leaned.clear();
        self.variables.moved.clear();
    }

    /// Whether a check holds, as last judged.
    pub fn does_hold(&self, check: usize) -> bool {
        self.holds[check]
    }

    /// Whether a check counts as violated.
    pub fn is_bad(&self, check: usize) -> bool {
        self.bad_at[check] != u32::MAX
    }

    /// What a check costs from now on, and whether it holds.
    pub fn set(&mut self, check: usize, cost: f64, holds: bool) {
        self.cost[check] = cost;
        self.holds[check] = holds;
        // A preference that fails is no violation, unless it is demanded.
        let fine = holds || !self.is_demanded(check) && self.frame.terms.get(check).is_some_and(|t| !t.is_hard());
        let at = self.bad_at[check];
        if fine && at != u32::MAX {
            self.bad.swap_remove(at as usize);
            self.bad_at[check] = u32::MAX;
            if let Some(&last) = self.bad.get(at as usize) {
                self.bad_at[last] = at;
            }
        } else if !fine && at == u32::MAX {
            self.bad_at[check] = self.bad.len() as u32;
            self.bad.push(check);
        }
    }

    /// Judges everything anew.
    pub fn judge_all(&mut self) {
        self.cost.fill(0.0);
        self.holds.fill(true);
        self.bad.clear();
        self.bad_at.fill(u32::MAX);
        self.hits.iter_mut().for_each(Vec::clear);
        self.near.clear();
        self.moved = (0..self.count()).map(|i| (i, self.inputs(i), self.span[i])).collect();
        self.is_moved.fill(true);
        self.all_variables_move();
        for i in 0..self.count() {
            self.put(i, self.inputs(i));
        }
        let _ = self.judge(f64::INFINITY);
        self.keep();
    }

    /// Whether a check must hold.
    pub fn is_hard(&self, check: usize) -> bool {
        self.frame.terms.get(check).is_none_or(|term| term.is_hard())
    }

    /// Whether a term counts at present: it must hold, or preferences are looked at.
    pub fn counts(&self, t: usize) -> bool {
        self.preferring || self.frame.terms[t].is_hard()
    }

    /// Whether a check counts as violated where it fails, though it is a preference.
    pub fn is_demanded(&self, check: usize) -> bool {
        self.demanded.get(check) == Some(&true)
    }

    /// From now on these preferences count as violated where they fail, and no others.
    pub fn demand(&mut self, terms: impl IntoIterator<Item = usize>) {
        self.demanded.fill(false);
        terms.into_iter().for_each(|t| self.demanded[t] = true);
    }

    /// What a term lacks with an object somewhere, whatever goes along with it (metres).
    pub fn lacks_at(&mut self, t: usize, i: usize, inputs: Inputs) -> f64 {
        let id = ObjectId(i as u32);
        let before = self.slots.get(id);
        self.slots.put(id, inputs);
        let lacks = self.lacks(t);
        self.slots.put(id, before);
        lacks
    }
}
