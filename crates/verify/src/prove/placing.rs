//! Where statements about a thing alone let it stand: claims about it, tried on cells of its places and turns.

use super::interval::Interval;
use super::narrow::narrow;
use super::probes::{Cell, sine_and_cosine};
use super::problem::{Problem, UnknownKind, Var, VariableFormula};
use super::state::State;
use super::tape::Claim;
use rustc_hash::FxHashSet;

/// A thing with more said of it alone is looked at without that.
const MOST: usize = 400;

/// The claims about one thing alone.
#[derive(Clone, Debug, Default)]
pub(super) struct Placing {
    /// Its x, z, cosine and sine, as far as they are unknown, and x and z of its region.
    own: [Option<Var>; 4],
    region: [Option<Var>; 2],
    /// What the claims are made of, parts first.
    parts: Vec<Var>,
    pub claims: Vec<Claim>,
}

impl Placing {
    /// Of claims that hold those that are about a thing alone, by its own unknowns and those of its region.
    pub fn new(problem: &Problem, holding: &[MadeOf], own: [Option<Var>; 4], region: [Option<Var>; 2]) -> Self {
        let mut placing = Self { own, region, parts: Vec::new(), claims: Vec::new() };
        let mut all: FxHashSet<Var> = FxHashSet::default();
        for MadeOf { claim, vars, compared } in holding {
            // A region of which the place is not known is taken to be at 0: so only places relative to it count.
            let absolute = |v: &Var| (0..2).any(|i| region[i].is_some() && [own[i], region[i]].contains(&Some(*v)));
            if own.iter().flatten().any(|v| vars.binary_search(v).is_ok())
                && !compared.iter().any(absolute)
                && vars.iter().all(|v| placing.is_plain(problem, *v))
                && all.len() + vars.len() <= MOST
            {
                placing.claims.push(*claim);
                all.extend(vars);
            }
        }
        placing.parts = all.into_iter().collect();
        placing.parts.sort_unstable();
        placing
    }

    /// Whether a part has a value in a cell: it is made of what the cell says, and of places relative to the region.
    fn is_plain(&self, problem: &Problem, var: Var) -> bool {
        let axis = |v: Var, of: &[Option<Var>]| of.iter().position(|o| *o == Some(v));
        match &problem.kinds[var as usize] {
            UnknownKind::Free => {
                axis(var, &self.own).is_some()
                    || axis(var, &self.region).is_some()
                    || problem.initial[var as usize].is_point()
            }
            UnknownKind::Row(parts) => (0..2).all(|i| {
                let sum = |v: Option<Var>| parts.iter().filter(|(p, _)| Some(*p) == v).map(|(_, c)| c).sum::<f64>();
                self.region[i].is_none() || sum(self.own[i]) + sum(self.region[i]) == 0.0
            }),
            UnknownKind::Apply(_, a, b) => [a, b].iter().all(|t| {
                let placed =
                    |i: usize| self.region[i].is_some() && [self.own[i], self.region[i]].contains(&Some(t.var));
                t.var == 0 || !(placed(0) || placed(1))
            }),
            UnknownKind::Indicator(_) => false,
        }
    }

    /// Whether the claims let the thing be in a cell; the middle of the floor is at (0, 0) there, and at `at` in the world.
    pub fn may_be(&self, problem: &Problem, at: [f64; 2], cell: &Cell, values: &mut Vec<Interval>) -> bool {
        values.resize(problem.kinds.len(), Interval::ALL);
        values[0] = Interval::point(0.0);
        let [sin, cos] = sine_and_cosine(cell.lo[2], cell.hi[2]);
        let place = |i: usize| Interval::new(cell.lo[i], cell.hi[i]) + Interval::point(at[i]);
        let of_own = [place(0), place(1), cos, sin];
        for &var in &self.parts {
            let value = |t: &super::problem::Affine| t.of(values[t.var as usize]);
            let new = match &problem.kinds[var as usize] {
                UnknownKind::Free => match self.own.iter().position(|o| *o == Some(var)) {
                    Some(i) => of_own[i],
                    None if self.region.contains(&Some(var)) => Interval::point(0.0),
                    None => problem.initial[var as usize],
                },
                UnknownKind::Row(parts) => {
                    parts.iter().fold(Interval::point(0.0), |sum, (v, c)| sum + values[*v as usize].scale(*c))
                }
                UnknownKind::Apply(function, a, b) => narrow(*function, Interval::ALL, value(a), value(b))[0],
                UnknownKind::Indicator(_) => Interval::ALL,
            };
            values[var as usize] = new;
        }
        self.claims.iter().all(|claim| verdict(problem, *claim, values) != Some(false))
    }

    /// The events that the claims rest on.
    pub fn reasons(&self, state: &State) -> impl Iterator<Item = u32> {
        self.claims.iter().map(|c| state.verdict_why[c.index()])
    }
}

/// The parts of what always holds: members of conjunctions.
pub(super) fn conjuncts(problem: &Problem, claims: &[Claim]) -> Vec<Claim> {
    let mut open = claims.to_vec();
    let mut out = Vec::new();
    while let Some(claim) = open.pop() {
        match &problem.verdicts[claim.index()] {
            VariableFormula::All(parts) if !claim.is_contrary() => open.extend(parts.iter()),
            _ => out.push(claim),
        }
    }
    out
}

/// These claims, and what follows from them by those that always hold.
pub(super) fn follow(problem: &Problem, always: &[Claim], mut holding: Vec<Claim>) -> Vec<Claim> {
    let given: FxHashSet<Claim> = holding.iter().copied().collect();
    let contrary = |claim: Claim| Claim(claim.0 ^ 1);
    for claim in always {
        // One of these holds.
        let ways: Vec<Claim> = match &problem.verdicts[claim.index()] {
            VariableFormula::All(parts) if claim.is_contrary() => parts.iter().map(|p| contrary(*p)).collect(),
            VariableFormula::AtLeast(1, parts) if !claim.is_contrary() => parts.to_vec(),
            _ => continue,
        };
        let open: Vec<Claim> = ways.iter().copied().filter(|way| !given.contains(&contrary(*way))).collect();
        if let ([one], true) = (open.as_slice(), ways.len() > 1) {
            holding.extend(conjuncts(problem, &[*one]));
        }
    }
    holding
}

/// A claim with what it is made of.
#[derive(Clone, Debug)]
pub(super) struct MadeOf {
    pub claim: Claim,
    /// All variables, sorted.
    pub vars: Vec<Var>,
    /// Those that it compares.
    compared: Vec<Var>,
}

impl MadeOf {
    /// Nothing, where a part of the claim is no comparison, or where there are too many.
    pub fn new(problem: &Problem, claim: Claim) -> Option<Self> {
        let (mut facts, mut compared) = (vec![claim], Vec::new());
        while let Some(claim) = facts.pop() {
            match &problem.verdicts[claim.index()] {
                VariableFormula::Open => return None,
                VariableFormula::Atom { term, .. } => compared.push(term.var),
                VariableFormula::All(parts) | VariableFormula::AtLeast(_, parts) => facts.extend(parts.iter()),
                VariableFormula::Iff(a, b) => facts.extend([*a, *b]),
            }
            if facts.len() + compared.len() > MOST {
                return None;
            }
        }
        let (mut open, mut vars) = (compared.clone(), FxHashSet::default());
        while let Some(var) = open.pop() {
            if var == 0 || !vars.insert(var) {
                continue;
            }
            if vars.len() > MOST {
                return None;
            }
            match &problem.kinds[var as usize] {
                UnknownKind::Free => {}
                UnknownKind::Row(parts) => open.extend(parts.iter().map(|(v, _)| *v)),
                UnknownKind::Apply(_, a, b) => open.extend([a.var, b.var]),
                UnknownKind::Indicator(_) => return None,
            }
        }
        let mut vars: Vec<Var> = vars.into_iter().collect();
        vars.sort_unstable();
        Some(Self { claim, vars, compared })
    }
}

/// A claim where variables are in intervals.
pub(super) fn verdict(problem: &Problem, claim: Claim, values: &[Interval]) -> Option<bool> {
    let holds = match &problem.verdicts[claim.index()] {
        VariableFormula::Open => None,
        VariableFormula::Atom { term, bound, strict } => {
            let value = term.of(values[term.var as usize]);
            let above = |x: f64| if *strict { x > *bound } else { x >= *bound };
            match (above(value.lo), above(value.hi)) {
                (true, _) => Some(true),
                (_, false) => Some(false),
                _ => None,
            }
        }
        VariableFormula::All(parts) => at_least(problem, parts.len(), parts, values),
        VariableFormula::AtLeast(n, parts) => at_least(problem, *n as usize, parts, values),
        VariableFormula::Iff(a, b) => {
            verdict(problem, *a, values).zip(verdict(problem, *b, values)).map(|(a, b)| a == b)
        }
    };
    holds.map(|holds| holds != claim.is_contrary())
}

fn at_least(problem: &Problem, n: usize, parts: &[Claim], values: &[Interval]) -> Option<bool> {
    let (mut held, mut failed) = (0, 0);
    for part in parts {
        match verdict(problem, *part, values) {
            Some(true) => held += 1,
            Some(false) => failed += 1,
            None => {}
        }
    }
    if held >= n {
        Some(true)
    } else if failed > parts.len() - n {
        Some(false)
    } else {
        None
    }
}
