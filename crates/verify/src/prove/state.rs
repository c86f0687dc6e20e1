//! What is known at a point of a proof: an interval per variable, a verdict where there is one, and for each of these
//! the event that brought it, with the events that it follows from. All of it can be taken back.
//!
//! The rules of deduction here: a verdict decides its parts and its parts decide it; a comparison bounds its variable
//! and a bound decides comparisons; rows and operations narrow their variables (see `narrow`).

use super::interval::{Interval, down, up};
use super::narrow::narrow;
use super::problem::{Affine, Function, Problem, UnknownKind, Var, VariableFormula};
use super::tape::Claim;
use std::collections::VecDeque;

/// Index of an event; 0 is what holds from the start.
pub(super) type EventId = u32;

/// What happened, for explanations and for finding what a conflict rests on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum EventKind {
    /// A statement or a rule was taken as given: an index into the caller's list.
    Given(u32),
    /// Supposed, to see whether it can be.
    Supposed,
    /// A verdict was decided.
    Decided(Claim),
    /// A bound of a variable.
    Bound { var: Var, upper: bool, value: f64 },
    /// Impossible.
    Conflict(Rule),
    /// All but one of several suppositions have failed.
    Excluded,
}

/// What made a conflict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rule {
    /// An empty interval.
    Empty(Var),
    /// A verdict and its contrary.
    Verdict(Claim),
    /// A sum of inequalities, each times a factor, that says 0 > 0.
    Sum,
    /// Boxes that are too large together.
    Packing,
    /// Boxes that do not fit beside each other; at most so many do.
    Beside { fit: u32 },
}

/// An event with the events that it follows from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Event {
    pub what: EventKind,
    start: u32,
    end: u32,
}

/// Why something cannot be: the last event of the chain.
#[derive(Clone, Copy, Debug)]
pub(super) struct Conflict(pub EventId);

#[derive(Clone, Copy, Debug)]
enum Undo {
    Domain { var: Var, domain: Interval, why: [EventId; 2] },
    Verdict(u32),
}

#[derive(Clone, Debug)]
pub(super) struct State {
    pub domain: Vec<Interval>,
    pub why: Vec<[EventId; 2]>,
    pub verdict: Vec<Option<bool>>,
    pub verdict_why: Vec<EventId>,
    events: Vec<Event>,
    reasons: Vec<EventId>,
    trail: Vec<Undo>,
    vars: VecDeque<Var>,
    facts: VecDeque<u32>,
    in_vars: Vec<bool>,
    /// Room for the sums of a row, kept from one row to the next.
    sums: Vec<[Interval; 2]>,
    /// Steps taken.
    pub work: u64,
}

/// A point to go back to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark {
    trail: usize,
    pub event: EventId,
    reasons: usize,
}

/// A bound must move by this part of the interval to be worth telling; linear reasoning takes what is smaller.
const PROGRESS: f64 = 0.005;

impl State {
    /// Nothing is known but what is always so.
    pub fn new(problem: &Problem) -> Self {
        let facts = problem.verdicts.len();
        let mut verdict = vec![None; facts];
        if facts > 0 {
            verdict[0] = Some(true);
        }
        Self {
            domain: problem.initial.clone(),
            why: vec![[0; 2]; problem.initial.len()],
            verdict,
            verdict_why: vec![0; facts],
            events: vec![Event { what: EventKind::Excluded, start: 0, end: 0 }],
            reasons: Vec::new(),
            trail: Vec::new(),
            vars: VecDeque::new(),
            facts: VecDeque::new(),
            in_vars: vec![false; problem.initial.len()],
            sums: Vec::new(),
            work: 0,
        }
    }

    /// Makes room for a variable that was added to the problem.
    pub fn grow(&mut self, problem: &Problem) {
        for var in self.domain.len()..problem.initial.len() {
            self.domain.push(problem.initial[var]);
            self.why.push([0; 2]);
            self.in_vars.push(false);
        }
    }

    pub fn mark(&self) -> Mark {
        Mark { trail: self.trail.len(), event: self.events.len() as EventId, reasons: self.reasons.len() }
    }

    /// Back to a point; events since then are gone.
    pub fn back(&mut self, mark: Mark) {
        while self.trail.len() > mark.trail {
            match self.trail.pop() {
                Some(Undo::Domain { var, domain, why }) => {
                    self.domain[var as usize] = domain;
                    self.why[var as usize] = why;
                }
                Some(Undo::Verdict(fact)) => self.verdict[fact as usize] = None,
                None => break,
            }
        }
        self.events.truncate(mark.event as usize);
        self.reasons.truncate(mark.reasons);
        for var in self.vars.drain(..) {
            self.in_vars[var as usize] = false;
        }
        self.facts.clear();
    }

    pub fn event(&mut self, what: EventKind, reasons: &[EventId]) -> EventId {
        let start = self.reasons.len() as u32;
        self.reasons.extend(reasons.iter().filter(|r| **r != 0));
        self.events.push(Event { what, start, end: self.reasons.len() as u32 });
        self.events.len() as EventId - 1
    }
    pub fn what(&self, event: EventId) -> EventKind {
        self.events[event as usize].what
    }
    pub fn reasons(&self, event: EventId) -> &[EventId] {
        let event = &self.events[event as usize];
        &self.reasons[event.start as usize..event.end as usize]
    }

    pub fn is_true(&self, claim: Claim) -> bool {
        self.verdict[claim.index()] == Some(!claim.is_contrary())
    }
    pub fn is_false(&self, claim: Claim) -> bool {
        self.verdict[claim.index()] == Some(claim.is_contrary())
    }

    pub fn decide(&mut self, claim: Claim, reasons: &[EventId]) -> Result<(), Conflict> {
        if self.is_true(claim) {
            return Ok(());
        }
        if self.is_false(claim) {
            let mut all = reasons.to_vec();
            all.push(self.verdict_why[claim.index()]);
            return Err(Conflict(self.event(EventKind::Conflict(Rule::Verdict(claim)), &all)));
        }
        let event = self.event(EventKind::Decided(claim), reasons);
        self.decide_by(claim, event);
        Ok(())
    }

    /// Decides an undecided claim, by an event that is there already.
    pub fn decide_by(&mut self, claim: Claim, event: EventId) {
        self.verdict[claim.index()] = Some(!claim.is_contrary());
        self.verdict_why[claim.index()] = event;
        self.trail.push(Undo::Verdict(claim.index() as u32));
        self.facts.push_back(claim.index() as u32);
    }

    /// Meets a variable with an interval.
    pub fn bound(&mut self, var: Var, with: Interval, reasons: &[EventId]) -> Result<(), Conflict> {
        self.meet(var, with, reasons, 0.0)
    }

    fn meet(&mut self, var: Var, with: Interval, reasons: &[EventId], progress: f64) -> Result<(), Conflict> {
        self.side(var, false, with.lo, reasons, progress)?;
        self.side(var, true, with.hi, reasons, progress)
    }

    fn side(&mut self, var: Var, upper: bool, value: f64, reasons: &[EventId], progress: f64) -> Result<(), Conflict> {
        let old = self.domain[var as usize];
        let better = if upper { value < old.hi } else { value > old.lo };
        if !better {
            return Ok(());
        }
        let new = if upper { Interval::new(old.lo, value) } else { Interval::new(value, old.hi) };
        let moved = if upper { old.hi - value } else { value - old.lo };
        if !new.is_empty() && moved <= progress * old.width() && old.width().is_finite() {
            return Ok(());
        }
        let event = self.event(EventKind::Bound { var, upper, value }, reasons);
        if new.is_empty() {
            let other = self.why[var as usize][usize::from(!upper)];
            return Err(Conflict(self.event(EventKind::Conflict(Rule::Empty(var)), &[event, other])));
        }
        self.trail.push(Undo::Domain { var, domain: old, why: self.why[var as usize] });
        self.domain[var as usize] = new;
        self.why[var as usize][usize::from(upper)] = event;
        if !std::mem::replace(&mut self.in_vars[var as usize], true) {
            self.vars.push_back(var);
        }
        Ok(())
    }

    /// Draws all consequences, as long as the work does not pass `most`.
    pub fn propagate(&mut self, problem: &Problem, most: u64) -> Result<(), Conflict> {
        loop {
            if self.work > most {
                return Ok(());
            }
            if let Some(fact) = self.facts.pop_front() {
                self.down(problem, fact)?;
                for &parent in &problem.above[fact as usize] {
                    // A conjunction that holds has told its parts already.
                    let told = self.verdict[parent as usize] == Some(true);
                    if !(told && matches!(problem.verdicts[parent as usize], VariableFormula::All(_))) {
                        self.fact(problem, parent)?;
                    }
                }
            } else if let Some(var) = self.vars.pop_front() {
                self.in_vars[var as usize] = false;
                self.revise(problem, var)?;
                for &parent in &problem.parents[var as usize] {
                    self.revise(problem, parent)?;
                }
                for &atom in &problem.atoms[var as usize] {
                    self.atom(problem, atom)?;
                }
            } else {
                return Ok(());
            }
        }
    }

    /// Wakes everything once: what follows from the start.
    pub fn wake(&mut self, problem: &Problem) {
        for (var, kind) in problem.kinds.iter().enumerate() {
            if !matches!(kind, UnknownKind::Free) && !self.in_vars[var] {
                self.in_vars[var] = true;
                self.vars.push_back(var as Var);
            }
        }
    }

    /// From a decided fact to what it is made of.
    fn down(&mut self, problem: &Problem, fact: u32) -> Result<(), Conflict> {
        self.work += 1;
        if let VariableFormula::Atom { term, bound, strict } = problem.verdicts[fact as usize] {
            let Some(holds) = self.verdict[fact as usize] else { return Ok(()) };
            let whole = match (holds, strict) {
                (true, false) => Interval::from(bound),
                (true, true) => Interval::from(up(bound)),
                (false, false) => Interval::to(down(bound)),
                (false, true) => Interval::to(bound),
            };
            return self.bound(term.var, term.solve(whole), &[self.verdict_why[fact as usize]]);
        }
        self.fact(problem, fact)
    }

    /// A comparison that its variable decides.
    fn atom(&mut self, problem: &Problem, fact: u32) -> Result<(), Conflict> {
        self.work += 1;
        let VariableFormula::Atom { term, bound, strict } = problem.verdicts[fact as usize] else { return Ok(()) };
        if self.verdict[fact as usize].is_some() {
            return Ok(());
        }
        let whole = term.of(self.domain[term.var as usize]);
        let [lower, upper] = self.why[term.var as usize];
        let (low, high) = if term.minus { (upper, lower) } else { (lower, upper) };
        let claim = Claim(2 * fact);
        if if strict { whole.lo > bound } else { whole.lo >= bound } {
            self.decide(claim, &[low])
        } else if if strict { whole.hi <= bound } else { whole.hi < bound } {
            self.decide(Claim(claim.0 | 1), &[high])
        } else {
            Ok(())
        }
    }

    /// A fact made of others: what its parts say of it, and it of its parts.
    fn fact(&mut self, problem: &Problem, fact: u32) -> Result<(), Conflict> {
        let claim = Claim(2 * fact);
        match &problem.verdicts[fact as usize] {
            VariableFormula::Open | VariableFormula::Atom { .. } => Ok(()),
            VariableFormula::All(parts) => self.at_least(claim, parts.len(), parts),
            VariableFormula::AtLeast(n, parts) => self.at_least(claim, *n as usize, parts),
            VariableFormula::Iff(a, b) => {
                self.work += 1;
                let sides = [*a, *b, claim];
                let known = sides.map(|s| self.verdict[s.index()].map(|v| v != s.is_contrary()));
                let open: Vec<usize> = (0..3).filter(|&i| known[i].is_none()).collect();
                let [i] = open.as_slice() else {
                    if open.is_empty() && (known[0] == known[1]) != (known[2] == Some(true)) {
                        let why = sides.map(|s| self.verdict_why[s.index()]);
                        return Err(Conflict(self.event(EventKind::Conflict(Rule::Verdict(claim)), &why)));
                    }
                    return Ok(());
                };
                // One is open: it is what makes an even number of them false.
                let holds = (0..3).filter(|k| k != i && known[*k] == Some(false)).count() % 2 == 0;
                let why: Vec<EventId> = (0..3).filter(|k| k != i).map(|k| self.verdict_why[sides[k].index()]).collect();
                let side = sides[*i];
                self.decide(if holds { side } else { Claim(side.0 ^ 1) }, &why)
            }
        }
    }

    /// At least n of the parts, all of them where there are n.
    fn at_least(&mut self, claim: Claim, n: usize, parts: &[Claim]) -> Result<(), Conflict> {
        self.work += parts.len() as u64 / 4 + 1;
        let (mut held, mut failed) = (0, 0);
        for part in parts {
            held += usize::from(self.is_true(*part));
            failed += usize::from(self.is_false(*part));
        }
        let open = parts.len() - held - failed;
        let spare = parts.len() - n;
        let why = |s: &Self, holding: bool| -> Vec<EventId> {
            let of = |p: &&Claim| if holding { s.is_true(**p) } else { s.is_false(**p) };
            parts.iter().filter(of).map(|p| s.verdict_why[p.index()]).collect()
        };
        match self.verdict[claim.index()] {
            None if held >= n => {
                let why = why(self, true);
                self.decide(claim, &why)
            }
            None if failed > spare => {
                // One reason is enough where all are needed.
                let mut why = why(self, false);
                why.truncate(spare + 1);
                self.decide(Claim(claim.0 | 1), &why)
            }
            Some(true) if failed > spare || failed == spare && open > 0 => {
                let mut why = why(self, false);
                why.push(self.verdict_why[claim.index()]);
                self.rest(parts, true, &why, failed > spare, claim)
            }
            Some(false) if held >= n || held + 1 == n && open > 0 => {
                let mut why = why(self, true);
                why.push(self.verdict_why[claim.index()]);
                self.rest(parts, false, &why, held >= n, claim)
            }
            _ => Ok(()),
        }
    }

    /// Decides what is open of the parts; if there is one decision too many already, that is a conflict.
    fn rest(
        &mut self,
        parts: &[Claim],
        holds: bool,
        why: &[EventId],
        over: bool,
        claim: Claim,
    ) -> Result<(), Conflict> {
        if over {
            return Err(Conflict(self.event(EventKind::Conflict(Rule::Verdict(claim)), why)));
        }
        for part in parts {
            if self.verdict[part.index()].is_none() {
                self.decide(if holds { *part } else { Claim(part.0 ^ 1) }, why)?;
            }
        }
        Ok(())
    }

    /// What a variable is made of narrows it, and it what it is made of.
    fn revise(&mut self, problem: &Problem, var: Var) -> Result<(), Conflict> {
        match &problem.kinds[var as usize] {
            UnknownKind::Free => Ok(()),
            UnknownKind::Row(parts) => self.revise_row(var, parts),
            UnknownKind::Apply(function, a, b) => self.revise_operation(*function, var, *a, *b),
            UnknownKind::Indicator(claim) => {
                let domain = self.domain[var as usize];
                let why = self.why[var as usize];
                if self.is_true(*claim) {
                    self.bound(var, Interval::point(1.0), &[self.verdict_why[claim.index()]])
                } else if self.is_false(*claim) {
                    self.bound(var, Interval::point(0.0), &[self.verdict_why[claim.index()]])
                } else if domain.lo > 0.0 {
                    self.decide(*claim, &[why[0]])
                } else if domain.hi < 1.0 {
                    self.decide(Claim(claim.0 ^ 1), &[why[1]])
                } else {
                    Ok(())
                }
            }
        }
    }

    fn revise_operation(&mut self, function: Function, var: Var, a: Affine, b: Affine) -> Result<(), Conflict> {
        self.work += 2;
        let (x, y) = (a.of(self.domain[a.var as usize]), b.of(self.domain[b.var as usize]));
        let [z, p, q] = narrow(function, self.domain[var as usize], x, y);
        let why = [var, a.var, b.var].map(|v| self.why[v as usize]);
        let all = [why[0][0], why[0][1], why[1][0], why[1][1], why[2][0], why[2][1]];
        self.meet(var, z, &all, PROGRESS)?;
        if a.var != 0 {
            self.meet(a.var, a.solve(p), &all, PROGRESS)?;
        }
        if b.var != 0 && b.var != a.var {
            self.meet(b.var, b.solve(q), &all, PROGRESS)?;
        }
        Ok(())
    }

    /// A row is the sum of its parts; each part is the row less the others.
    fn revise_row(&mut self, var: Var, parts: &[(Var, f64)]) -> Result<(), Conflict> {
        self.work += parts.len() as u64;
        // Sums of all to the left and all to the right of each part, so that leaving one out costs nothing.
        let zero = Interval::point(0.0);
        let mut sums = std::mem::take(&mut self.sums);
        sums.clear();
        sums.resize(parts.len() + 1, [zero; 2]);
        for (i, (v, c)) in parts.iter().enumerate().rev() {
            let value = self.domain[*v as usize].scale(*c);
            sums[i] = [sums[i + 1][0] + value, value];
        }
        let outcome = self.revise_parts(var, parts, &sums);
        self.sums = sums;
        outcome
    }

    /// By the sums of the parts from each on, and what each contributes.
    fn revise_parts(&mut self, var: Var, parts: &[(Var, f64)], sums: &[[Interval; 2]]) -> Result<(), Conflict> {
        // The event behind the lower (upper) bound of what a part contributes.
        let reason =
            |s: &Self, i: usize, upper: bool| s.why[parts[i].0 as usize][usize::from(upper != (parts[i].1 < 0.0))];
        for upper in [false, true] {
            let value = if upper { sums[0][0].hi } else { sums[0][0].lo };
            if value.is_finite() && self.gains(var, upper, value) {
                let why: Vec<EventId> = (0..parts.len()).map(|i| reason(self, i, upper)).collect();
                self.side(var, upper, value, &why, PROGRESS)?;
            }
        }
        let whole = self.domain[var as usize];
        let mut left = Interval::point(0.0);
        for (i, (v, c)) in parts.iter().enumerate() {
            let rest = left + sums[i + 1][0];
            let own = match *c {
                1.0 => whole - rest,
                -1.0 => rest - whole,
                c => (whole - rest) * reciprocal(c),
            };
            left = left + sums[i][1];
            for upper in [false, true] {
                let value = if upper { own.hi } else { own.lo };
                if value.is_finite() && self.gains(*v, upper, value) {
                    // The upper bound of c·v comes from the upper bound of the row and the lower bounds of the others.
                    let top = upper != (*c < 0.0);
                    let mut why: Vec<EventId> =
                        (0..parts.len()).filter(|k| *k != i).map(|k| reason(self, k, !top)).collect();
                    why.push(self.why[var as usize][usize::from(top)]);
                    self.side(*v, upper, value, &why, PROGRESS)?;
                }
            }
        }
        Ok(())
    }

    fn gains(&self, var: Var, upper: bool, value: f64) -> bool {
        let old = self.domain[var as usize];
        if upper { value < old.hi } else { value > old.lo }
    }
}

fn reciprocal(c: f64) -> Interval {
    Interval::point(1.0).over(Interval::point(c))
}
