//! Linear reasoning: whether the rows can all be within their bounds at once. The method is the simplex of Dutertre and
//! de Moura (bounds on rows, no objective), because it can be stopped and resumed as bounds come and go, and because a
//! row that cannot be repaired names the inequalities that contradict each other.
//!
//! It computes in floats and is believed in nothing: the factors that it finds are tried on the original rows, in
//! intervals ([`Simplex::certificate`]), and only what passes there is a proof.

use super::interval::Interval;
use super::problem::{Problem, UnknownKind, Var};
use super::state::{EventId, State};
use std::collections::BTreeMap;

/// How far a value may be off its bound before it has to move.
const SLACK: f64 = 1e-9;
/// By how much intervals are narrowed to find what holds strictly only.
const INSIDE: f64 = 1e-7;
/// Smaller factors are rounding.
const TINY: f64 = 1e-11;

/// A side of a variable's interval with its factor in a contradiction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Share {
    pub var: Var,
    pub upper: bool,
    pub factor: f64,
}

/// What came of a check.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum SimplexOutcome {
    /// The values are within all bounds.
    Fits,
    /// These bounds contradict each other.
    Contradiction(Vec<Share>),
    /// The work did not suffice, or rounding got in the way.
    Unknown,
}

/// A sum of variables times factors, sorted by variable.
type Row = Vec<(Var, f64)>;

/// The tableau: dependent variables as sums of independent ones.
#[derive(Clone, Debug, Default)]
pub(super) struct Simplex {
    /// By variable: its row, if it depends on others.
    rows: Vec<Option<Row>>,
    /// The variables that have a row, sorted.
    dependent: Vec<Var>,
    /// By independent variable: the rows it stands in.
    columns: Vec<Vec<Var>>,
    values: Vec<f64>,
    /// By variable: whether its row was taken in (it may be independent since).
    is_in: Vec<bool>,
}

impl Simplex {
    /// The value of a variable when the last check ended.
    pub fn value(&self, var: Var) -> f64 {
        self.values.get(var as usize).copied().unwrap_or(0.0)
    }

    /// Takes in the rows that have a bound by now which their variables do not give them.
    fn grow(&mut self, problem: &Problem, why: &[[EventId; 2]]) {
        self.values.resize(problem.kinds.len(), 0.0);
        self.is_in.resize(problem.kinds.len(), false);
        self.rows.resize(problem.kinds.len(), None);
        self.columns.resize(problem.kinds.len(), Vec::new());
        for (var, why) in why.iter().enumerate() {
            let UnknownKind::Row(parts) = &problem.kinds[var] else { continue };
            if *why == [0, 0] || problem.curved[var] || self.rows[var].is_some() || self.is_in[var] {
                continue;
            }
            self.is_in[var] = true;
            let mut row = Vec::new();
            self.flatten(problem, parts, 1.0, &mut row);
            let mut row = gathered(row);
            row.retain(|(_, c)| c.abs() > TINY);
            row.iter().for_each(|(v, _)| self.columns[*v as usize].push(var as Var));
            self.depend(var as Var, row);
        }
    }

    /// Gives a variable its row.
    fn depend(&mut self, var: Var, row: Row) {
        self.rows[var as usize] = Some(row);
        if let Err(at) = self.dependent.binary_search(&var) {
            self.dependent.insert(at, var);
        }
    }

    /// A sum by what is independent now, its parts as they come.
    fn flatten(&self, problem: &Problem, parts: &[(Var, f64)], factor: f64, out: &mut Row) {
        for (part, c) in parts {
            let factor = factor * c;
            match (&self.rows[*part as usize], &problem.kinds[*part as usize]) {
                (Some(inner), _) => out.extend(inner.iter().map(|(v, c)| (*v, factor * c))),
                (None, UnknownKind::Row(inner)) if !self.is_in[*part as usize] => {
                    self.flatten(problem, inner, factor, out)
                }
                _ => out.push((*part, factor)),
            }
        }
    }

    /// Looks for values within the bounds; `work` counts what it costs, up to `most`.
    ///
    /// `strictly`: every interval is taken a little narrower, so that a circle of `<` shows; the contradiction must then
    /// be tried on the true ones, as ever.
    pub fn check(
        &mut self,
        problem: &Problem,
        state: &State,
        strictly: bool,
        work: &mut u64,
        most: u64,
    ) -> SimplexOutcome {
        self.grow(problem, &state.why);
        let narrower = |d: &Interval| {
            if d.width() > 4.0 * INSIDE { Interval::new(d.lo + INSIDE, d.hi - INSIDE) } else { *d }
        };
        let domain: Vec<Interval> =
            if strictly { state.domain.iter().map(narrower).collect() } else { state.domain.clone() };
        let outcome = self.repair(&domain, work, most);
        // Rows that stayed out are what their variables make them.
        for (var, kind) in problem.kinds.iter().enumerate() {
            if let UnknownKind::Row(parts) = kind
                && !self.is_in[var]
            {
                self.values[var] = parts.iter().map(|(v, c)| c * self.values[*v as usize]).sum();
            }
        }
        *work += problem.kinds.len() as u64 / 4;
        outcome
    }

    fn repair(&mut self, domain: &[Interval], work: &mut u64, most: u64) -> SimplexOutcome {
        // Independent ones to within their bounds, dependent ones by their rows.
        for (var, bounds) in domain.iter().enumerate() {
            if self.rows[var].is_none() {
                let near = self.values[var].max(bounds.lo).min(bounds.hi);
                self.values[var] = if near.is_finite() { near } else { 0.0 };
            }
        }
        for var in &self.dependent {
            let Some(row) = &self.rows[*var as usize] else { continue };
            self.values[*var as usize] = row.iter().map(|(v, c)| c * self.values[*v as usize]).sum();
            *work += row.len() as u64 / 2 + 1;
        }
        for round in 0..2000 {
            if *work > most {
                return SimplexOutcome::Unknown;
            }
            // The worst first, until that might run in circles; then the first (Bland's rule ends).
            let mut worst: Option<(Var, bool, f64)> = None;
            for &var in &self.dependent {
                let (value, bounds) = (self.values[var as usize], domain[var as usize]);
                let off = (bounds.lo - value).max(value - bounds.hi);
                if off > SLACK * (1.0 + value.abs().min(1e3)) && worst.is_none_or(|(_, _, w)| round < 200 && off > w) {
                    worst = Some((var, value > bounds.hi, off));
                }
            }
            *work += self.dependent.len() as u64 / 8 + 1;
            let Some((var, over, _)) = worst else { return SimplexOutcome::Fits };
            let Some(row) = &self.rows[var as usize] else { return SimplexOutcome::Unknown };
            // A variable that can move the right way, of large factor in preference.
            let mut best: Option<(Var, f64)> = None;
            for &(other, c) in row {
                let up = (c > 0.0) != over;
                let (value, bounds) = (self.values[other as usize], domain[other as usize]);
                let free = if up { value < bounds.hi } else { value > bounds.lo };
                if free && (best.is_none_or(|(_, b)| round < 200 && c.abs() > b)) {
                    best = Some((other, c.abs()));
                }
            }
            match best {
                Some((other, c)) if c > 1e-7 => self.exchange(
                    var,
                    other,
                    if over { domain[var as usize].hi } else { domain[var as usize].lo },
                    work,
                ),
                Some(_) => return SimplexOutcome::Unknown,
                None => {
                    let mut shares = vec![Share { var, upper: over, factor: 1.0 }];
                    shares.extend(row.iter().map(|&(other, c)| Share {
                        var: other,
                        upper: (c > 0.0) != over,
                        factor: c.abs(),
                    }));
                    return SimplexOutcome::Contradiction(shares);
                }
            }
        }
        SimplexOutcome::Unknown
    }

    /// The dependent `var` becomes independent, at `value`, in the place of `other`.
    fn exchange(&mut self, var: Var, other: Var, value: f64, work: &mut u64) {
        let Some(mut row) = self.rows[var as usize].take() else { return };
        self.dependent.retain(|v| *v != var);
        let Ok(at) = row.binary_search_by_key(&other, |(v, _)| *v) else { return };
        let (_, pivot) = row.remove(at);
        let step = (value - self.values[var as usize]) / pivot;
        self.values[var as usize] = value;
        self.values[other as usize] += step;
        for (v, _) in &row {
            let column = &mut self.columns[*v as usize];
            column.retain(|r| *r != var);
            column.push(other);
        }
        // other = (var − rest) / pivot
        let mut solved: Row = row.iter().map(|(v, c)| (*v, -c / pivot)).collect();
        let at = solved.partition_point(|(v, _)| *v < var);
        solved.insert(at, (var, 1.0 / pivot));
        let mut users = std::mem::take(&mut self.columns[other as usize]);
        users.retain(|r| *r != var);
        self.columns[var as usize] = vec![other];
        for user in users {
            let Some(target) = self.rows[user as usize].take() else { continue };
            let Ok(at) = target.binary_search_by_key(&other, |(v, _)| *v) else {
                self.rows[user as usize] = Some(target);
                continue;
            };
            let factor = target[at].1;
            self.values[user as usize] += factor * step;
            *work += solved.len() as u64;
            self.rows[user as usize] = Some(self.replaced(user, &target, other, factor, &solved));
        }
        self.depend(other, solved);
    }

    /// The row `target` of `user`, in which factor·`solved` stands in the place of factor·`other`; columns follow.
    fn replaced(&mut self, user: Var, target: &Row, other: Var, factor: f64, solved: &Row) -> Row {
        let mut out = Vec::with_capacity(target.len() + solved.len());
        let mut old = target.iter().filter(|(v, _)| *v != other).peekable();
        for (v, c) in solved {
            while let Some(part) = old.next_if(|(o, _)| o < v) {
                out.push(*part);
            }
            let known = old.next_if(|(o, _)| o == v).map(|(_, c)| *c);
            let new = known.unwrap_or(0.0) + factor * c;
            let column = &mut self.columns[*v as usize];
            if new.abs() > TINY {
                out.push((*v, new));
                if known.is_none() {
                    column.push(user);
                }
            } else if known.is_some() {
                column.retain(|r| *r != user);
            }
        }
        out.extend(old);
        out
    }

    /// Tries a contradiction on the rows as they were stated. Each bound, times its factor, is an inequality that holds;
    /// their sum has, up to rounding, no variable left on the one side, and on the other a number that is more than 0.
    /// What rounding leaves of a variable is bounded by the interval that the variable has from the start.
    ///
    /// Returns the shares that count, or nothing if the sum does not prove it.
    pub fn certificate(problem: &Problem, domain: &[Interval], shares: &[Share]) -> Option<Vec<Share>> {
        let mut left: BTreeMap<Var, Interval> = BTreeMap::new();
        let zero = Interval::point(0.0);
        let mut right = zero;
        let counted: Vec<Share> = shares.iter().copied().filter(|s| s.factor > TINY).collect();
        for share in &counted {
            let bounds = domain[share.var as usize];
            // var − lo ≥ 0, or hi − var ≥ 0; times the factor.
            let (bound, sign) = if share.upper { (bounds.hi, -1.0) } else { (bounds.lo, 1.0) };
            if !bound.is_finite() {
                return None;
            }
            let factor = Interval::point(share.factor * sign);
            right = right + factor * Interval::point(bound);
            let mut add = |var: Var, c: Interval| {
                let entry = left.entry(var).or_insert(zero);
                *entry = *entry + c;
            };
            match &problem.kinds[share.var as usize] {
                UnknownKind::Row(parts) => expand(problem, parts, factor, &mut add),
                _ => add(share.var, factor),
            }
        }
        // Σ left ≥ right, for every combination of values; but Σ left is at most:
        let mut most = zero;
        for (var, factor) in left {
            if factor != zero {
                most = most + factor * problem.initial[var as usize];
            }
        }
        (most.hi < right.lo).then_some(counted)
    }
}

/// Parts as a row: sorted, those of one variable added up in their order.
fn gathered(mut parts: Row) -> Row {
    parts.sort_by_key(|(v, _)| *v);
    parts.dedup_by(|next, first| {
        let same = next.0 == first.0;
        if same {
            first.1 += next.1;
        }
        same
    });
    parts
}

/// A row by variables that are no rows.
fn expand(problem: &Problem, parts: &[(Var, f64)], factor: Interval, add: &mut impl FnMut(Var, Interval)) {
    for (var, c) in parts {
        let factor = factor * Interval::point(*c);
        match &problem.kinds[*var as usize] {
            // A cut is a row of rows; those are of plain variables.
            UnknownKind::Row(inner) => expand(problem, inner, factor, add),
            _ => add(*var, factor),
        }
    }
}
