//! The search for a refutation: draw all consequences; where none contradicts, suppose one side of something open and
//! look whether it can be; what cannot be is excluded, with what that rests on, and the search goes on.
//!
//! It ends at the first point at which nothing is left to suppose: then nothing is proved. So programs that can be
//! satisfied cost little, and what is refuted is refuted in every case.

use super::cuts::{self, Points};
use super::interval::Interval;
use super::model::ClaimModel;
use super::packing::Packing;
use super::problem::{Affine, Function, Problem, UnknownKind, Var, VariableFormula};
use super::simplex::{Simplex, SimplexOutcome};
use super::state::{Conflict, EventId, EventKind, Rule, State};
use super::tape::Claim;
use std::sync::atomic::{AtomicBool, Ordering};

/// So many suppositions on top of each other.
const DEEPEST: usize = 60;
/// So often a variable is halved on one path.
const HALVINGS: usize = 10;
/// Rounds of inequalities for operations, at the start and below a supposition.
const ROUNDS: [usize; 2] = [12, 3];
/// Signs are tried where they are no more, in this part of the work; each of something that may be so far from 0.
const MOST_SIGNS: usize = 60;
const SIGNS_WORK: u64 = 20;
const WIDE: f64 = 0.01;
/// So many rows may be added.
const MOST_ROWS: usize = 4000;

/// What may be supposed: a claim, or a variable up to (`upper`) or from a value.
#[derive(Clone, Copy, Debug)]
enum Supposition {
    Claim(Claim),
    Half { var: Var, value: f64 },
}

/// How a step of a proof is told: its depth, and what happened.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ProofEvent {
    pub depth: usize,
    pub what: EventKind,
    /// The steps before it that it follows from.
    pub reasons: Vec<usize>,
}

/// A search over one problem.
pub(super) struct Refutation<'a> {
    pub problem: Problem,
    pub state: State,
    simplex: Simplex,
    points: Points,
    packing: &'a Packing<'a>,
    /// Rows from here on were added by the search.
    first_row: usize,
    most: u64,
    cancel: Option<&'a AtomicBool>,
    /// How often a fact took part in a conflict lately.
    activity: Vec<f64>,
    weight: f64,
    /// Whether it ended, without supposing anything, because boxes do not fit.
    pub is_full: bool,
    /// Whether anything was supposed on the way.
    has_supposed: bool,
    /// The proof, if it is to be told.
    pub told: Option<Vec<ProofEvent>>,
    told_as: Vec<Option<usize>>,
}

/// How a part of the search ended.
enum End {
    /// It cannot be; these events from before it are why.
    Refuted { rests: Vec<EventId>, by_supposition: bool },
    /// Not refuted.
    Open,
}

impl<'a> Refutation<'a> {
    /// A search that may do `most` work.
    pub fn new(
        problem: Problem,
        model: &ClaimModel,
        packing: &'a Packing<'a>,
        most: u64,
        cancel: Option<&'a AtomicBool>,
    ) -> Self {
        let state = State::new(&problem);
        let points = Points::new(&problem, &model.angles, &model.spans);
        let activity = vec![0.0; problem.verdicts.len()];
        let first_row = problem.kinds.len();
        Self {
            problem,
            state,
            simplex: Simplex::default(),
            points,
            packing,
            first_row,
            most,
            cancel,
            activity,
            weight: 1.0,
            is_full: false,
            has_supposed: false,
            told: None,
            told_as: Vec::new(),
        }
    }

    /// Whether the claims cannot all hold; if so, the indices of those that the refutation used. Those of `always` need
    /// no reason.
    pub fn refute(&mut self, always: &[Claim], given: &[Claim]) -> Option<Vec<usize>> {
        match self.start(always, given) {
            Ok(()) => {}
            Err(conflict) => return Some(self.used(conflict.0)),
        }
        let mut end = self.search(0, 0, None);
        if matches!(end, End::Open) && !self.stopped() {
            end = match self.signs() {
                Ok(false) => End::Open,
                Ok(true) => self.search(0, 0, None),
                Err(conflict) => self.refuted(conflict.0, 0, 0),
            };
        }
        match end {
            End::Refuted { rests, .. } => {
                let event = self.state.event(EventKind::Excluded, &rests);
                Some(self.used(event))
            }
            End::Open => None,
        }
    }

    fn start(&mut self, always: &[Claim], given: &[Claim]) -> Result<(), Conflict> {
        self.state.wake(&self.problem);
        let mut failed = Ok(());
        for claim in always {
            failed = failed.and(self.state.decide(*claim, &[]));
        }
        for (index, claim) in given.iter().enumerate() {
            let event = self.state.event(EventKind::Given(index as u32), &[]);
            failed = failed.and_then(|()| self.state.decide(*claim, &[event]));
        }
        if let Err(conflict) = failed {
            self.tell(conflict.0, 0);
        }
        failed
    }

    /// The given claims that an event rests on.
    fn used(&self, event: EventId) -> Vec<usize> {
        let mut seen = vec![false; event as usize + 1];
        let mut open = vec![event];
        let mut out = Vec::new();
        while let Some(at) = open.pop() {
            if std::mem::replace(&mut seen[at as usize], true) {
                continue;
            }
            if let EventKind::Given(index) = self.state.what(at) {
                out.push(index as usize);
            }
            open.extend(self.state.reasons(at));
        }
        out.sort_unstable();
        out
    }

    fn stopped(&self) -> bool {
        self.state.work > self.most || self.cancel.is_some_and(|c| c.load(Ordering::Relaxed))
    }

    /// Draws consequences by all rules, with inequalities for operations in so many rounds.
    fn consequences(&mut self, rounds: usize) -> Result<(), Conflict> {
        for _ in 0..rounds {
            self.state.propagate(&self.problem, self.most)?;
            self.packing.check(&self.problem, &mut self.state)?;
            if self.stopped() {
                return Ok(());
            }
            if !self.linear(false)? || self.problem.kinds.len() > self.first_row + MOST_ROWS {
                return Ok(());
            }
            let mut work = 0;
            let cuts = cuts::broken(&self.problem, &self.state, &self.simplex, &self.points, &mut work);
            self.state.work += work;
            if cuts.is_empty() {
                return self.linear(true).map(|_| ());
            }
            for cut in cuts {
                self.cut(&cut)?;
            }
        }
        self.state.propagate(&self.problem, self.most)
    }

    /// Linear reasoning; whether it came to its end.
    fn linear(&mut self, strictly: bool) -> Result<bool, Conflict> {
        let mut work = self.state.work;
        let outcome = self.simplex.check(&self.problem, &self.state, strictly, &mut work, self.most);
        self.state.work = work;
        let SimplexOutcome::Contradiction(shares) = outcome else { return Ok(outcome == SimplexOutcome::Fits) };
        let Some(shares) = Simplex::certificate(&self.problem, &self.state.domain, &shares) else { return Ok(false) };
        let reasons: Vec<EventId> =
            shares.iter().map(|s| self.state.why[s.var as usize][usize::from(s.upper)]).collect();
        Err(Conflict(self.state.event(EventKind::Conflict(Rule::Sum), &reasons)))
    }

    fn cut(&mut self, cut: &cuts::Cut) -> Result<(), Conflict> {
        let sign = if cut.parts[0].1 < 0.0 { -1.0 } else { 1.0 };
        let (var, factor) = match cut.parts.as_slice() {
            [(var, c)] => (*var, c.abs()),
            parts => {
                let parts: Vec<(Var, f64)> = parts.iter().map(|(v, c)| (*v, c * sign)).collect();
                let var = self.problem.row(&parts);
                self.state.grow(&self.problem);
                (var, 1.0)
            }
        };
        let least = Interval::point(cut.least).over(Interval::point(factor)).lo;
        let whole = if sign < 0.0 { Interval::to(-least) } else { Interval::from(least) };
        self.state.bound(var, whole, &cut.reasons)
    }

    fn search(&mut self, depth: usize, halvings: usize, supposed: Option<EventId>) -> End {
        let start = supposed.unwrap_or(0);
        let mut rounds = ROUNDS[usize::from(depth > 0)];
        loop {
            if let Err(conflict) = self.consequences(rounds) {
                return self.refuted(conflict.0, start, depth);
            }
            if self.stopped() || depth >= DEEPEST {
                return End::Open;
            }
            let Some((supposition, halving)) = self.choose(halvings) else {
                // Before it gives up here it looks as closely as it can.
                if rounds == ROUNDS[0] {
                    return End::Open;
                }
                rounds = ROUNDS[0];
                continue;
            };
            let mark = self.state.mark();
            self.has_supposed = true;
            let event = self.state.event(EventKind::Supposed, &[]);
            let tried = match supposition {
                Supposition::Claim(claim) => self.state.decide(claim, &[event]),
                Supposition::Half { var, value } => self.state.bound(var, Interval::to(value), &[event]),
            };
            let end = match tried {
                Ok(()) => self.search(depth + 1, halvings + usize::from(halving), Some(event)),
                Err(conflict) => self.refuted(conflict.0, event, depth + 1),
            };
            self.state.back(mark);
            let End::Refuted { rests, by_supposition } = end else { return End::Open };
            self.forget(mark.event);
            if !by_supposition {
                // It failed without what was supposed: so it fails here.
                let conflict = self.state.event(EventKind::Excluded, &rests);
                return self.refuted(conflict, start, depth);
            }
            let excluded = match supposition {
                Supposition::Claim(claim) => self.state.decide(Claim(claim.0 ^ 1), &rests),
                Supposition::Half { var, value } => self.state.bound(var, Interval::from(value), &rests),
            };
            if let Err(conflict) = excluded {
                return self.refuted(conflict.0, start, depth);
            }
        }
    }

    /// Tries each sign that is open and matters by itself, and excludes what cannot be; whether anything was. So many signs
    /// cost as much as they are, and not as many as their combinations.
    fn signs(&mut self) -> Result<bool, Conflict> {
        let most = self.state.work + self.most / SIGNS_WORK;
        let mut open: Vec<(Var, f64)> = Vec::new();
        for kind in &self.problem.kinds[..self.first_row] {
            let UnknownKind::Apply(Function::Abs, a, _) = kind else { continue };
            let domain = self.state.domain[a.var as usize];
            let zero = a.solve(Interval::point(0.0)).lo;
            let wide = zero > domain.lo + WIDE && zero < domain.hi - WIDE && domain.magnitude().is_finite();
            if a.var != 0 && wide && !open.contains(&(a.var, zero)) {
                open.push((a.var, zero));
            }
        }
        if open.len() > MOST_SIGNS {
            return Ok(false);
        }
        let mut any = false;
        for (var, zero) in open {
            for upper in [false, true] {
                if self.state.work > most || self.stopped() {
                    return Ok(any);
                }
                let [half, rest] = match upper {
                    true => [Interval::to(zero), Interval::from(zero)],
                    false => [Interval::from(zero), Interval::to(zero)],
                };
                let mark = self.state.mark();
                let event = self.state.event(EventKind::Supposed, &[]);
                let tried = self.state.bound(var, half, &[event]).and_then(|()| self.consequences(1));
                let end = tried.err().map(|conflict| {
                    self.has_supposed = true;
                    self.refuted(conflict.0, event, 1)
                });
                self.state.back(mark);
                let Some(End::Refuted { rests, by_supposition }) = end else { continue };
                self.forget(mark.event);
                any = true;
                if !by_supposition {
                    return Err(Conflict(self.state.event(EventKind::Excluded, &rests)));
                }
                self.state.bound(var, rest, &rests)?;
            }
        }
        Ok(any)
    }

    /// What of a conflict lies before the supposition `start`, and whether it needs that.
    fn refuted(&mut self, conflict: EventId, start: EventId, depth: usize) -> End {
        self.tell(conflict, depth);
        self.is_full = depth == 0
            && !self.has_supposed
            && matches!(self.state.what(conflict), EventKind::Conflict(Rule::Packing | Rule::Beside { .. }));
        self.weight *= 1.05;
        let mut seen = vec![false; (conflict - start) as usize + 1];
        let mut open = vec![conflict];
        let mut rests = Vec::new();
        let mut by_supposition = false;
        while let Some(at) = open.pop() {
            if at < start {
                rests.push(at);
                continue;
            }
            if std::mem::replace(&mut seen[(at - start) as usize], true) {
                continue;
            }
            match self.state.what(at) {
                EventKind::Supposed if at == start => by_supposition = true,
                EventKind::Given(_) if start == 0 => rests.push(at),
                EventKind::Decided(claim) => {
                    self.activity[claim.index()] += self.weight;
                    open.extend(self.state.reasons(at));
                }
                _ => open.extend(self.state.reasons(at)),
            }
        }
        rests.sort_unstable();
        rests.dedup();
        End::Refuted { rests, by_supposition }
    }

    /// What to suppose next, and whether that halves an interval: a part of a disjunction, the most contested first,
    /// then the sign of something whose sign matters, then a half of an unknown that stands in an operation.
    fn choose(&mut self, halvings: usize) -> Option<(Supposition, bool)> {
        let mut best: Option<(f64, Claim)> = None;
        self.state.work += self.problem.verdicts.len() as u64 / 4;
        for (fact, verdict) in self.problem.verdicts.iter().enumerate() {
            let (parts, wanted): (&[Claim], bool) = match (verdict, self.state.verdict[fact]) {
                (VariableFormula::All(parts), Some(false)) => (parts, false),
                (VariableFormula::AtLeast(_, parts), Some(holds)) => (parts, holds),
                (VariableFormula::Iff(a, _), Some(_)) if self.state.verdict[a.index()].is_none() => {
                    (std::slice::from_ref(a), true)
                }
                _ => continue,
            };
            let settled = match verdict {
                VariableFormula::All(parts) => parts.iter().any(|p| self.state.is_false(*p)),
                VariableFormula::AtLeast(n, parts) if wanted => {
                    parts.iter().filter(|p| self.state.is_true(**p)).count() >= *n as usize
                }
                VariableFormula::AtLeast(n, parts) => {
                    parts.iter().filter(|p| self.state.is_false(**p)).count() + *n as usize > parts.len()
                }
                _ => false,
            };
            if settled {
                continue;
            }
            let open = parts.iter().filter(|p| self.state.verdict[p.index()].is_none());
            let (count, first) = open.fold((0, None), |(n, first), p| (n + 1, first.or(Some(*p))));
            let Some(part) = first else { continue };
            let contested: f64 = self.activity[fact] + parts.iter().map(|p| self.activity[p.index()]).sum::<f64>();
            let score = (contested + 1e-3) / f64::from(count);
            if best.is_none_or(|(s, _)| score > s) {
                best = Some((score, if wanted { part } else { Claim(part.0 ^ 1) }));
            }
        }
        if let Some((_, claim)) = best {
            return Some((Supposition::Claim(claim), false));
        }
        if halvings >= HALVINGS {
            return None;
        }
        self.halve().map(|s| (s, true))
    }

    /// An argument of an operation to halve: one whose sign is open at 0; else the widest for its size.
    fn halve(&self) -> Option<Supposition> {
        let mut best: Option<(f64, Supposition)> = None;
        for (index, kind) in self.problem.kinds.iter().enumerate() {
            let UnknownKind::Apply(function, a, b) = kind else { continue };
            // Where linear reasoning has it right there is nothing to gain.
            if self.is_right(*function, index as Var, *a, *b) {
                continue;
            }
            for term in [a, b] {
                let domain = self.state.domain[term.var as usize];
                if term.var == 0 || !domain.magnitude().is_finite() || domain.width() < 1e-3 {
                    continue;
                }
                let whole = term.of(domain);
                let (score, value) = match function {
                    Function::Abs | Function::Square | Function::Mul if whole.lo < 0.0 && whole.hi > 0.0 => {
                        let zero = term.solve(Interval::point(0.0));
                        (1.0 + 1.0 / (1.0 + domain.width()), zero.lo.max(domain.lo).min(domain.hi))
                    }
                    // Of the smaller of an angle and its supplement it is open which one that is.
                    Function::Min | Function::Max if a.var == b.var && a.minus != b.minus => {
                        let (plus, minus) = if a.minus { (b, a) } else { (a, b) };
                        (3.0, (minus.add.lo - plus.add.lo) / 2.0)
                    }
                    _ => (domain.width().min(1e3) / 1e4, domain.lo + domain.width() / 2.0),
                };
                let inside = value > domain.lo && value < domain.hi;
                if inside && best.is_none_or(|(s, _)| score > s) {
                    best = Some((score, Supposition::Half { var: term.var, value }));
                }
            }
        }
        best.map(|(_, supposition)| supposition)
    }

    /// Whether the values of linear reasoning satisfy an operation.
    fn is_right(&self, function: Function, var: Var, a: Affine, b: Affine) -> bool {
        let value = |t: Affine| t.of(Interval::point(self.simplex.value(t.var)));
        let [r, ..] = super::narrow::narrow(function, Interval::ALL, value(a), value(b));
        let z = self.simplex.value(var);
        r.lo - 1e-6 <= z && z <= r.hi + 1e-6
    }

    /// Notes the chain of a conflict in the proof, each event once and after its reasons.
    fn tell(&mut self, conflict: EventId, depth: usize) {
        if self.told.is_none() {
            return;
        }
        let mut chain = Vec::new();
        let mut open = vec![conflict];
        let mut seen = std::collections::BTreeSet::new();
        while let Some(at) = open.pop() {
            let known = self.told_as.get(at as usize).copied().flatten().is_some();
            if at != 0 && !known && seen.insert(at) {
                chain.push(at);
                open.extend(self.state.reasons(at));
            }
        }
        chain.sort_unstable();
        for event in chain {
            let reasons: Vec<usize> = self
                .state
                .reasons(event)
                .iter()
                .filter_map(|r| self.told_as.get(*r as usize).copied().flatten())
                .collect();
            let told = ProofEvent { depth, what: self.state.what(event), reasons };
            if let Some(list) = &mut self.told {
                if self.told_as.len() <= event as usize {
                    self.told_as.resize(event as usize + 1, None);
                }
                self.told_as[event as usize] = Some(list.len());
                list.push(told);
            }
        }
    }

    /// Events from here on will be others.
    fn forget(&mut self, from: EventId) {
        self.told_as.truncate(from as usize);
    }
}
