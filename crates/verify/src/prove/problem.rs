//! A tape as equations between variables: sums become rows of coefficients, everything else an operation on variables
//! up to sign and offset. So `a.pos.x + 1 <= b.pos.x` and `b.pos.x - a.pos.x > 3` bound one and the same row.

use super::interval::Interval;
use super::tape::{Claim, Fact, Op, Tape, Term};
use rustc_hash::{FxHashMap, FxHashSet};

/// A variable: index into [`Problem::kinds`]. Variable 0 is the number 0.
pub(super) type Var = u32;

/// A variable up to sign and offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Affine {
    pub var: Var,
    pub minus: bool,
    pub add: Interval,
}

impl Affine {
    /// What it is, where the variable is in an interval.
    pub fn of(self, domain: Interval) -> Interval {
        if self.minus { self.add - domain } else { self.add + domain }
    }
    /// What the variable is, where it is in an interval.
    pub fn solve(self, whole: Interval) -> Interval {
        if self.minus { self.add - whole } else { whole - self.add }
    }
}

/// What a variable is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum UnknownKind {
    Free,
    /// The sum of variables times coefficients, sorted by variable.
    Row(Box<[(Var, f64)]>),
    Apply(Function, Affine, Affine),
    Indicator(Claim),
}

/// An operation of one or two arguments (of one: both are the same).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Function {
    Mul,
    Div,
    Square,
    Sqrt,
    Abs,
    Min,
    Max,
    Sin,
    Cos,
    Atan,
    Wrap,
}

/// A verdict in terms of variables.
#[derive(Clone, Debug)]
pub(super) enum VariableFormula {
    Open,
    /// The term is at least the bound; strict: more.
    Atom {
        term: Affine,
        bound: f64,
        strict: bool,
    },
    All(Box<[Claim]>),
    AtLeast(u32, Box<[Claim]>),
    Iff(Claim, Claim),
}

/// Variables and verdicts; those of the tape that no claim asked for are left out.
#[derive(Clone, Debug, Default)]
pub(super) struct Problem {
    pub kinds: Vec<UnknownKind>,
    /// What each is in whatever happens.
    pub initial: Vec<Interval>,
    /// By variable: the variables that are made of it.
    pub parents: Vec<Vec<Var>>,
    /// By variable: the verdicts about it.
    pub atoms: Vec<Vec<u32>>,
    /// By index of a fact of the tape.
    pub verdicts: Vec<VariableFormula>,
    /// By index of a fact: the facts that are made of it.
    pub above: Vec<Vec<u32>>,
    /// Lengths: the variable, and the differences it is the length of.
    pub lengths: Vec<(Var, Vec<Affine>)>,
    /// By variable: whether linear reasoning leaves it out.
    pub curved: Vec<bool>,
    /// By term, for words.
    pub terms: Vec<Option<Affine>>,
    rows: FxHashMap<Vec<(Var, u64)>, Var>,
    applied: FxHashMap<(Function, [Key; 2]), Var>,
}

/// An argument by its bits.
type Key = (Var, bool, [u64; 2]);

/// A sum of variables with coefficients, and a constant.
#[derive(Clone, Debug, Default)]
struct Sum {
    parts: Vec<(Var, f64)>,
    add: Option<Interval>,
}

impl Problem {
    /// What of a tape these claims and terms need.
    pub fn new(tape: &Tape, roots: &[Claim], wanted: &[Term], curved: &[Claim]) -> Self {
        let (facts, terms) = reached(tape, roots, wanted);
        let mut own = Self {
            kinds: Vec::new(),
            initial: Vec::new(),
            parents: Vec::new(),
            atoms: Vec::new(),
            verdicts: vec![VariableFormula::Open; tape.facts.len()],
            above: vec![Vec::new(); tape.facts.len()],
            lengths: Vec::new(),
            curved: Vec::new(),
            terms: vec![None; tape.ops.len()],
            rows: FxHashMap::default(),
            applied: FxHashMap::default(),
        };
        own.variable(UnknownKind::Free, Interval::point(0.0));
        let mut sums: Vec<Sum> = vec![Sum::default(); tape.ops.len()];
        for index in (0..tape.ops.len()).filter(|&i| terms[i]) {
            sums[index] = own.sum(tape, &sums, index);
        }
        for index in (0..tape.facts.len()).filter(|&i| facts[i]) {
            let verdict = match &tape.facts[index] {
                Fact::True | Fact::Open(_) => VariableFormula::Open,
                Fact::Atom { term, bound, strict } => {
                    let term = own.affine(&sums[term.0 as usize]);
                    own.atoms[term.var as usize].push(index as u32);
                    VariableFormula::Atom { term, bound: f64::from_bits(*bound), strict: *strict }
                }
                Fact::All(parts) => VariableFormula::All(parts.clone()),
                Fact::AtLeast(n, parts) => VariableFormula::AtLeast(*n, parts.clone()),
                Fact::Iff(a, b) => VariableFormula::Iff(*a, *b),
            };
            let children: Vec<Claim> = match &verdict {
                VariableFormula::All(parts) | VariableFormula::AtLeast(_, parts) => parts.to_vec(),
                VariableFormula::Iff(a, b) => vec![*a, *b],
                VariableFormula::Open | VariableFormula::Atom { .. } => Vec::new(),
            };
            for child in children {
                own.above[child.index()].push(index as u32);
            }
            own.verdicts[index] = verdict;
        }
        own.leave_out(curved);
        own
    }

    /// Marks the rows that these claims are about, and operations that stand in such rows only.
    fn leave_out(&mut self, curved: &[Claim]) {
        let only: FxHashSet<u32> = curved.iter().map(|c| c.index() as u32).collect();
        self.curved = vec![false; self.kinds.len()];
        for var in (1..self.kinds.len()).rev() {
            let atoms = self.atoms[var].iter().all(|a| only.contains(a));
            let parents = self.parents[var].iter().all(|p| self.curved[*p as usize]);
            let used = !(self.atoms[var].is_empty() && self.parents[var].is_empty());
            self.curved[var] = used && atoms && parents && !matches!(self.kinds[var], UnknownKind::Free);
        }
    }

    fn variable(&mut self, kind: UnknownKind, domain: Interval) -> Var {
        let var = self.kinds.len() as Var;
        let mut of = |v: Var| {
            if v != 0 && self.parents[v as usize].last() != Some(&var) {
                self.parents[v as usize].push(var);
            }
        };
        match &kind {
            UnknownKind::Row(parts) => parts.iter().for_each(|(v, _)| of(*v)),
            UnknownKind::Apply(_, a, b) => [a.var, b.var].into_iter().for_each(&mut of),
            UnknownKind::Free | UnknownKind::Indicator(_) => {}
        }
        self.kinds.push(kind);
        self.initial.push(domain);
        self.parents.push(Vec::new());
        self.atoms.push(Vec::new());
        self.curved.push(false);
        var
    }

    /// The row of these coefficients (sorted, none 0, the first positive), made where it is new.
    pub fn row(&mut self, parts: &[(Var, f64)]) -> Var {
        let key: Vec<(Var, u64)> = parts.iter().map(|(v, c)| (*v, c.to_bits())).collect();
        if let Some(known) = self.rows.get(&key) {
            return *known;
        }
        let domain = parts.iter().fold(Interval::point(0.0), |sum, (v, c)| sum + self.initial[*v as usize].scale(*c));
        let var = self.variable(UnknownKind::Row(parts.into()), domain);
        self.rows.insert(key, var);
        var
    }

    /// A sum as a variable up to sign and offset.
    fn affine(&mut self, sum: &Sum) -> Affine {
        let add = sum.add.unwrap_or(Interval::point(0.0));
        match sum.parts.as_slice() {
            [] => Affine { var: 0, minus: false, add },
            [(var, c)] if c.abs() == 1.0 => Affine { var: *var, minus: *c < 0.0, add },
            parts => {
                let minus = parts[0].1 < 0.0;
                let sign = if minus { -1.0 } else { 1.0 };
                let parts: Vec<(Var, f64)> = parts.iter().map(|(v, c)| (*v, c * sign)).collect();
                Affine { var: self.row(&parts), minus, add }
            }
        }
    }

    /// One combination of two sums. A coefficient that had to be rounded is made good in the constant; where that
    /// cannot be (the variable has no bounds), there is no sum.
    fn combine(&self, a: &Sum, p: f64, b: &Sum, q: f64) -> Option<Sum> {
        let zero = Interval::point(0.0);
        let mut add = a.add.unwrap_or(zero).scale(p) + b.add.unwrap_or(zero).scale(q);
        let mut parts = Vec::with_capacity(a.parts.len() + b.parts.len());
        let (mut i, mut k) = (0, 0);
        loop {
            let (x, y) = (a.parts.get(i), b.parts.get(k));
            let Some(var) = x.map(|x| x.0).into_iter().chain(y.map(|y| y.0)).min() else { break };
            let mut exact = zero;
            let mut plain = 0.0;
            if let Some((v, c)) = x.filter(|x| x.0 == var) {
                debug_assert_eq!(*v, var);
                exact = exact + Interval::point(*c) * Interval::point(p);
                plain += c * p;
                i += 1;
            }
            if let Some((_, c)) = y.filter(|y| y.0 == var) {
                exact = exact + Interval::point(*c) * Interval::point(q);
                plain += c * q;
                k += 1;
            }
            let rest = exact - Interval::point(plain);
            if rest != zero {
                let domain = self.initial[var as usize];
                if !domain.magnitude().is_finite() {
                    return None;
                }
                add = add + rest * domain;
            }
            if plain != 0.0 {
                parts.push((var, plain));
            }
        }
        Some(Sum { parts, add: Some(add) })
    }

    fn sum(&mut self, tape: &Tape, sums: &[Sum], index: usize) -> Sum {
        let of = |t: Term| &sums[t.0 as usize];
        let range = tape.ranges[index];
        let none = Sum::default();
        let linear = match tape.ops[index] {
            Op::Constant(bits) if f64::from_bits(bits).is_finite() => {
                Some(Sum { parts: Vec::new(), add: Some(Interval::point(f64::from_bits(bits))) })
            }
            Op::Add(a, b) => self.combine(of(a), 1.0, of(b), 1.0),
            Op::Sub(a, b) => self.combine(of(a), 1.0, of(b), -1.0),
            Op::Scale(a, factor) if f64::from_bits(factor).is_finite() => {
                self.combine(of(a), f64::from_bits(factor), &none, 1.0)
            }
            _ => None,
        };
        if let Some(sum) = linear {
            self.terms[index] = Some(self.affine(&sum));
            return sum;
        }
        let (function, a, b) = match tape.ops[index] {
            Op::Mul(a, b) => (Function::Mul, a, b),
            Op::Div(a, b) => (Function::Div, a, b),
            Op::Min(a, b) => (Function::Min, a, b),
            Op::Max(a, b) => (Function::Max, a, b),
            Op::Atan(a, b) => (Function::Atan, a, b),
            Op::Square(a) => (Function::Square, a, a),
            Op::Sqrt(a) => (Function::Sqrt, a, a),
            Op::Abs(a) => (Function::Abs, a, a),
            Op::Sin(a) => (Function::Sin, a, a),
            Op::Cos(a) => (Function::Cos, a, a),
            Op::Wrap(a) => (Function::Wrap, a, a),
            // An unknown; or a sum that could not be joined, of which only the range is known.
            op => {
                let kind =
                    if let Op::Indicator(claim) = op { UnknownKind::Indicator(claim) } else { UnknownKind::Free };
                return self.named(index, self.kinds.len() as Var, 1.0, Some((kind, range)));
            }
        };
        let (a, b) = (self.affine(of(a)), self.affine(of(b)));
        let (sign, a, b) = plain(function, a, b);
        let range = if sign < 0.0 { -range } else { range };
        let key = (function, [a, b].map(|t| (t.var, t.minus, [t.add.lo, t.add.hi].map(f64::to_bits))));
        if let Some(&var) = self.applied.get(&key) {
            let known = &mut self.initial[var as usize];
            *known = known.meet(range);
            return self.named(index, var, sign, None);
        }
        let var = self.kinds.len() as Var;
        self.applied.insert(key, var);
        let sum = self.named(index, var, sign, Some((UnknownKind::Apply(function, a, b), range)));
        if let Op::Sqrt(a) = tape.ops[index] {
            self.length(sums, var, a);
        }
        sum
    }

    /// A variable up to sign as the sum of a term, made where there is a kind for it.
    fn named(&mut self, index: usize, var: Var, sign: f64, new: Option<(UnknownKind, Interval)>) -> Sum {
        if let Some((kind, range)) = new {
            self.variable(kind, range);
        }
        self.terms[index] = Some(Affine { var, minus: sign < 0.0, add: Interval::point(0.0) });
        Sum { parts: vec![(var, sign)], add: None }
    }

    /// Notes the root of a sum of squares as a length.
    fn length(&mut self, sums: &[Sum], var: Var, of: Term) {
        let sum = &sums[of.0 as usize];
        let zero = |add: Option<Interval>| add.is_none_or(|a| a == Interval::point(0.0));
        let squares: Option<Vec<Affine>> = sum
            .parts
            .iter()
            .map(|(v, c)| match &self.kinds[*v as usize] {
                UnknownKind::Apply(Function::Square, a, _) if *c == 1.0 => Some(*a),
                _ => None,
            })
            .collect();
        let squares = squares.filter(|s| !s.is_empty() && zero(sum.add));
        if let Some(parts) = squares {
            self.lengths.push((var, parts));
        }
    }
}

/// Arguments without the signs that make no difference to an operation but its own: so (a − b)·c and (b − a)·c, and the
/// squares of a − b and of b − a, are one variable.
fn plain(function: Function, a: Affine, b: Affine) -> (f64, Affine, Affine) {
    // −0 is 0, so that equal arguments have equal bits.
    let flipped = |t: Affine| Affine { minus: false, add: Interval::point(0.0) - t.add, ..t };
    let bare = |t: Affine| if t.minus { (-1.0, flipped(t)) } else { (1.0, t) };
    match function {
        Function::Square | Function::Abs => {
            let (_, a) = bare(a);
            (1.0, a, a)
        }
        Function::Mul => {
            let ((s, a), (t, b)) = (bare(a), bare(b));
            let (a, b) = if (a.var, a.add.lo) <= (b.var, b.add.lo) { (a, b) } else { (b, a) };
            (s * t, a, b)
        }
        _ => (1.0, a, b),
    }
}

/// Facts and terms that claims need.
pub(super) fn reached(tape: &Tape, roots: &[Claim], wanted: &[Term]) -> (Vec<bool>, Vec<bool>) {
    let mut facts = vec![false; tape.facts.len()];
    let mut terms = vec![false; tape.ops.len()];
    let mut open: Vec<usize> = roots.iter().map(|c| c.index()).collect();
    let mut wanted: Vec<Term> = wanted.to_vec();
    loop {
        while let Some(index) = open.pop() {
            if std::mem::replace(&mut facts[index], true) {
                continue;
            }
            match &tape.facts[index] {
                Fact::True | Fact::Open(_) => {}
                Fact::Atom { term, .. } => wanted.push(*term),
                Fact::All(parts) | Fact::AtLeast(_, parts) => open.extend(parts.iter().map(|c| c.index())),
                Fact::Iff(a, b) => open.extend([a.index(), b.index()]),
            }
        }
        let Some(term) = wanted.pop() else { break };
        if std::mem::replace(&mut terms[term.0 as usize], true) {
            continue;
        }
        match tape.ops[term.0 as usize] {
            Op::Constant(_) | Op::Unknown(_) => {}
            Op::Indicator(claim) => open.push(claim.index()),
            Op::Add(a, b)
            | Op::Sub(a, b)
            | Op::Mul(a, b)
            | Op::Div(a, b)
            | Op::Min(a, b)
            | Op::Max(a, b)
            | Op::Atan(a, b) => wanted.extend([a, b]),
            Op::Scale(a, _) | Op::Square(a) | Op::Sqrt(a) | Op::Abs(a) | Op::Sin(a) | Op::Cos(a) | Op::Wrap(a) => {
                wanted.push(a)
            }
        }
    }
    (facts, terms)
}
