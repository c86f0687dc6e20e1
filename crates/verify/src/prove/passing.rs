//! What claims say of how two solids are off each other: whether they exclude it in a range, and what is left of it for
//! solids that pass each other on either side.

use super::beside::Extent;
use super::interval::Interval;
use super::narrow::narrow;
use super::packing::{Packing, PackingRegion, of};
use super::placing::{MadeOf, verdict};
use super::problem::{Affine, Problem, UnknownKind, Var};
use super::state::{Conflict, EventId, State};
use std::rc::Rc;

/// A claim made of more than this says too much to be looked at for a pair alone.
const MOST_TOLD: usize = 60;
/// Farther off each other than this no two things are (metres).
const FARTHEST: f64 = 1e4;
/// So many steps to a bound; one that gains less than this (metres) is not worth an event.
const STEPS: usize = 14;
const WORTH: f64 = 1e-3;

/// Values of the variables that claims are made of.
pub(super) struct Looks<'p> {
    problem: &'p Problem,
    values: Vec<Interval>,
    pub work: u64,
}

/// The two variables of which a variable is the difference.
fn difference(problem: &Problem, var: Var) -> Option<[Var; 2]> {
    match &problem.kinds[var as usize] {
        UnknownKind::Row(parts) => match **parts {
            [(p, 1.0), (q, -1.0)] => Some([p, q]),
            _ => None,
        },
        _ => None,
    }
}

/// How often a difference is in a sum of variables.
fn times(parts: &[(Var, f64)], [p, q]: [Var; 2]) -> Option<f64> {
    let factor = |var: Var| parts.iter().find(|(v, _)| *v == var).map(|(_, c)| *c);
    factor(p).filter(|c| factor(q) == Some(-c))
}

impl<'p> Looks<'p> {
    pub fn new(problem: &'p Problem) -> Self {
        Self { problem, values: vec![Interval::ALL; problem.kinds.len()], work: 0 }
    }

    /// A sum in which there is one of the differences that are in ranges.
    fn sum(&self, parts: &[(Var, f64)], ranges: &[(Var, Interval)]) -> Option<Interval> {
        let (ends, factor, range) = ranges.iter().find_map(|(var, range)| {
            let ends = difference(self.problem, *var)?;
            Some((ends, times(parts, ends)?, *range))
        })?;
        let rest = parts.iter().filter(|(v, _)| !ends.contains(v));
        Some(rest.fold(range.scale(factor), |sum, (v, c)| sum + self.values[*v as usize].scale(*c)))
    }

    /// Whether one of the claims excludes that these terms are in these ranges.
    pub fn exclude(&mut self, state: &State, told: &[&MadeOf], ranges: &[(Affine, Interval)]) -> bool {
        let own = |(term, range): &(Affine, Interval)| term.solve(*range).meet(state.domain[term.var as usize]);
        let own: Vec<(Var, Interval)> = ranges.iter().map(|r| (r.0.var, own(r))).collect();
        if own.iter().any(|(_, range)| range.is_empty()) {
            return true;
        }
        told.iter().any(|made| {
            self.values[0] = Interval::point(0.0);
            self.work += 1 + made.vars.len() as u64 / 8;
            for &var in &made.vars {
                let value = |t: &Affine| t.of(self.values[t.var as usize]);
                let domain = state.domain[var as usize];
                self.values[var as usize] =
                    match (own.iter().find(|(v, _)| *v == var), &self.problem.kinds[var as usize]) {
                        (Some((_, range)), _) => *range,
                        (None, UnknownKind::Apply(function, a, b)) => narrow(*function, domain, value(a), value(b))[0],
                        (None, UnknownKind::Row(parts)) => self.sum(parts, &own).map_or(domain, |sum| domain.meet(sum)),
                        _ => domain,
                    };
            }
            verdict(self.problem, made.claim, &self.values) == Some(false)
        })
    }
}

/// The events that claims, and what is known of what they are made of, rest on.
pub(super) fn reasons_of(told: &[&MadeOf], state: &State) -> Vec<EventId> {
    let mut vars: Vec<Var> = told.iter().flat_map(|m| m.vars.iter().copied()).collect();
    vars.sort_unstable();
    vars.dedup();
    let claims = told.iter().map(|m| state.verdict_why[m.claim.index()]);
    claims.chain(vars.into_iter().flat_map(|v| state.why[v as usize])).collect()
}

impl Packing<'_> {
    /// The claims that hold of any of these terms.
    pub(super) fn told_of<'s>(&'s self, problem: &Problem, terms: &[Affine], state: &State) -> Vec<&'s MadeOf> {
        let made_of = self.made_of(problem);
        let key = [0, terms.len() - 1].map(|i| terms[i].var);
        let known = self.told.borrow().get(&key).map(Rc::clone);
        let told = known.unwrap_or_else(|| {
            let has = |m: &MadeOf, var: Var| m.vars.binary_search(&var).is_ok();
            let names = |m: &MadeOf, t: &Affine| {
                let ends = || difference(problem, t.var).is_some_and(|ends| ends.iter().all(|end| has(m, *end)));
                t.var != 0 && (has(m, t.var) || ends())
            };
            let speaks = |m: &MadeOf| m.vars.len() <= MOST_TOLD && terms.iter().any(|t| names(m, t));
            let told: Rc<[usize]> = (0..made_of.len()).filter(|i| speaks(&made_of[*i])).collect();
            self.told.borrow_mut().insert(key, Rc::clone(&told));
            told
        });
        told.iter().map(|i| &made_of[*i]).filter(|m| state.is_true(m.claim)).collect()
    }

    /// Two solids that claims keep in order along an axis, one behind the other: either they are apart along it, or they pass
    /// each other, and then claims about both axes say how far on they are at least.
    pub(super) fn passing(
        &self,
        problem: &Problem,
        group: &PackingRegion<Affine>,
        extents: &[Extent],
        reasons: &[EventId],
        state: &mut State,
    ) -> Result<(), Conflict> {
        let margin = 2.0 * self.contact;
        for (n, a) in extents.iter().enumerate() {
            for b in &extents[..n] {
                let pair = (b.member.min(a.member), b.member.max(a.member));
                let in_height = a.bottom < b.top - margin && b.bottom < a.top - margin;
                if !in_height || group.excepted.binary_search(&pair).is_ok() {
                    continue;
                }
                let Some(off) = group.off(pair) else { continue };
                let least = [0, 1].map(|axis| (a.size[axis] + b.size[axis]) / 2.0);
                let told = self.told_of(problem, &off, state);
                if told.is_empty() {
                    continue;
                }
                for (axis, sign) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)] {
                    let between = of(state, off[axis]);
                    let known = if sign > 0.0 { between.lo } else { -between.hi };
                    if known >= least[axis] {
                        continue;
                    }
                    let Some(to) = passed(problem, state, &told, off, axis, (sign, known), least) else { continue };
                    let mut why = [reasons, &a.why[..], &b.why].concat();
                    why.extend(reasons_of(&told, state));
                    why.extend(off.iter().flat_map(|t| state.why[t.var as usize]));
                    let whole = if sign > 0.0 { Interval::from(to) } else { Interval::to(-to) };
                    state.bound(off[axis].var, off[axis].solve(whole), &why)?;
                }
            }
        }
        Ok(())
    }
}

/// How far on, at least, two solids are along an axis where they are at least so far on, or where claims say that they are on,
/// and do not overlap.
fn passed(
    problem: &Problem,
    state: &mut State,
    told: &[&MadeOf],
    off: [Affine; 2],
    axis: usize,
    (sign, known): (f64, f64),
    least: [f64; 2],
) -> Option<f64> {
    let mut looks = Looks::new(problem);
    let range = |from: f64, to: f64| if sign > 0.0 { Interval::new(from, to) } else { Interval::new(-to, -from) };
    if known <= 0.0 && !looks.exclude(state, told, &[(off[axis], range(-FARTHEST, 0.0))]) {
        state.work += looks.work;
        return None;
    }
    let from = known.max(0.0);
    let mut excludes = |to: f64| {
        let on = range(from, to);
        let sides = [Interval::new(least[1 - axis], FARTHEST), Interval::new(-FARTHEST, -least[1 - axis])];
        sides.iter().all(|side| looks.exclude(state, told, &[(off[axis], on), (off[1 - axis], *side)]))
    };
    let (mut lo, mut hi) = (from, least[axis]);
    if excludes(hi) {
        lo = hi;
    } else {
        for _ in 0..STEPS {
            let mid = (lo + hi) / 2.0;
            if excludes(mid) { lo = mid } else { hi = mid }
        }
    }
    state.work += looks.work;
    (lo > from + WORTH).then_some(lo)
}
