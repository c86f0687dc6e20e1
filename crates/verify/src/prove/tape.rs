//! The third kind of number: an unknown of which only bounds are known, and which remembers how it came about.
//!
//! The evaluator runs over [`Term`]s and [`Claim`]s as it runs over floats and booleans. Each operation is noted once on
//! a tape (equal ones are shared), with an interval that its result is in whatever the unknowns are. So the formulas of
//! a program become equations between unknowns without a second evaluator, and what is known about a result can be
//! carried back to what it was made of.

use super::interval::Interval;
use crate::number::{Algebra, Logic};
use rustc_hash::{FxHashMap, FxHashSet};
use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number: the index of its node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Term(pub u32);

/// A verdict: twice the index of its node, plus 1 where it is the contrary of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Claim(pub u32);

impl Claim {
    pub const TRUE: Self = Self(0);
    pub const FALSE: Self = Self(1);

    pub fn index(self) -> usize {
        (self.0 / 2) as usize
    }
    pub fn is_contrary(self) -> bool {
        self.0 & 1 == 1
    }
}

/// How a number came about. Floats are held by their bits, so that equal nodes can be found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Op {
    Constant(u64),
    /// An unknown; its number makes it one of its own.
    Unknown(u32),
    Add(Term, Term),
    Sub(Term, Term),
    Scale(Term, u64),
    Mul(Term, Term),
    Div(Term, Term),
    Square(Term),
    Sqrt(Term),
    Abs(Term),
    Min(Term, Term),
    Max(Term, Term),
    Sin(Term),
    Cos(Term),
    Atan(Term, Term),
    Wrap(Term),
    Indicator(Claim),
}

/// How a verdict came about.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Fact {
    True,
    /// The number is at least (strict: more than) the bound.
    Atom {
        term: Term,
        bound: u64,
        strict: bool,
    },
    /// A Bool variable, or a predicate of which only consequences are known.
    Open(u32),
    All(Box<[Claim]>),
    AtLeast(u32, Box<[Claim]>),
    Iff(Claim, Claim),
}

/// Everything that was noted.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tape {
    pub ops: Vec<Op>,
    /// What each number is in whatever the unknowns are.
    pub ranges: Vec<Interval>,
    pub facts: Vec<Fact>,
    known_ops: FxHashMap<Op, Term>,
    known_facts: FxHashMap<Fact, Claim>,
    unknowns: u32,
    /// Constants that were computed, and rounded.
    rounded: FxHashSet<Term>,
}

/// So near to a bound (relative) the way in which a number was computed decides on which side of it it is.
const ROUNDED: f64 = 1e-9;

thread_local! {
    /// The tape that is being written, while [`Tape::record`] runs: numbers are `Copy`, and constants come from nowhere, so
    /// they cannot carry it.
    static TAPE: RefCell<Tape> = RefCell::new(Tape::default());
}

impl Tape {
    /// An empty tape.
    pub fn new() -> Self {
        let mut tape = Self::default();
        tape.fact(Fact::True);
        tape
    }
    /// Notes what is computed meanwhile, behind what is on the tape already. Another tape that was being written waits.
    pub fn record<R>(&mut self, compute: impl FnOnce() -> R) -> R {
        let waiting = TAPE.replace(std::mem::take(self));
        let result = compute();
        *self = TAPE.replace(waiting);
        result
    }
    fn op(&mut self, op: Op, range: Interval) -> Term {
        if let Some(&known) = self.known_ops.get(&op) {
            return known;
        }
        let term = Term(self.ops.len() as u32);
        self.ops.push(op);
        self.ranges.push(range);
        self.known_ops.insert(op, term);
        term
    }
    fn fact(&mut self, fact: Fact) -> Claim {
        if let Some(&known) = self.known_facts.get(&fact) {
            return known;
        }
        let claim = Claim(2 * self.facts.len() as u32);
        self.facts.push(fact.clone());
        self.known_facts.insert(fact, claim);
        claim
    }
    fn range(&self, term: Term) -> Interval {
        self.ranges[term.0 as usize]
    }
    fn value(&self, term: Term) -> Option<f64> {
        match self.ops[term.0 as usize] {
            Op::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }
    /// A constant computed from others, and whether it is just what floats make of it.
    fn computed(&mut self, value: f64, exact: bool, from: &[Term]) -> Term {
        let is_rounded = !exact || from.iter().any(|term| self.rounded.contains(term));
        let term = constant(self, value);
        if is_rounded {
            self.rounded.insert(term);
        }
        term
    }
}

fn tape<R>(f: impl FnOnce(&mut Tape) -> R) -> R {
    TAPE.with_borrow_mut(f)
}

/// Looks at what is written so far.
pub(crate) fn look<R>(f: impl FnOnce(&Tape) -> R) -> R {
    TAPE.with_borrow(f)
}

/// An unknown number in an interval.
pub(crate) fn unknown(range: Interval) -> Term {
    tape(|t| {
        t.unknowns += 1;
        let op = Op::Unknown(t.unknowns);
        t.op(op, range)
    })
}

/// An unknown verdict.
pub(crate) fn open() -> Claim {
    tape(|t| {
        t.unknowns += 1;
        let fact = Fact::Open(t.unknowns);
        t.fact(fact)
    })
}

/// What a term is in, whatever the unknowns are.
pub(crate) fn range(term: Term) -> Interval {
    tape(|t| t.range(term))
}

pub(crate) fn all(claims: &[Claim]) -> Claim {
    let mut parts: Vec<Claim> = claims.iter().copied().filter(|c| *c != Claim::TRUE).collect();
    parts.sort_unstable();
    parts.dedup();
    if parts.contains(&Claim::FALSE) || parts.windows(2).any(|w| w[0].0 ^ 1 == w[1].0) {
        return Claim::FALSE;
    }
    match parts.as_slice() {
        [] => Claim::TRUE,
        [one] => *one,
        _ => tape(|t| t.fact(Fact::All(parts.into()))),
    }
}

pub(crate) fn any(claims: &[Claim]) -> Claim {
    let contrary: Vec<Claim> = claims.iter().map(|c| c.negated()).collect();
    all(&contrary).negated()
}

/// If the one, then the other.
pub(crate) fn implies(a: Claim, b: Claim) -> Claim {
    any(&[a.negated(), b])
}

fn compare(term: Term, bound: f64, strict: bool) -> Claim {
    tape(|t| {
        let range = t.range(term);
        // A layout is judged by other steps, whose last bits are others.
        if t.rounded.contains(&term) && (range.lo - bound).abs() <= ROUNDED * (1.0 + bound.abs()) {
            t.unknowns += 1;
            let fact = Fact::Open(t.unknowns);
            return t.fact(fact);
        }
        let holds = |x: f64| if strict { x > bound } else { x >= bound };
        if holds(range.lo) {
            return Claim::TRUE;
        }
        if !holds(range.hi) {
            return Claim::FALSE;
        }
        t.fact(Fact::Atom { term, bound: bound.to_bits(), strict })
    })
}

impl Logic for Claim {
    fn constant(holds: bool) -> Self {
        if holds { Self::TRUE } else { Self::FALSE }
    }
    fn known(self) -> Option<bool> {
        (self.index() == 0).then_some(self == Self::TRUE)
    }
    fn and(self, other: Self) -> Self {
        all(&[self, other])
    }
    fn or(self, other: Self) -> Self {
        any(&[self, other])
    }
    fn negated(self) -> Self {
        Self(self.0 ^ 1)
    }
    fn iff(self, other: Self) -> Self {
        match (self.known(), other.known()) {
            (Some(true), _) => other,
            (Some(false), _) => other.negated(),
            (_, Some(true)) => self,
            (_, Some(false)) => self.negated(),
            _ if self.index() == other.index() => Self::constant(self == other),
            _ => {
                // Signs are taken out, so that p = q and q = p, and their contraries, are one node.
                let flip = (self.0 ^ other.0) & 1;
                let (a, b) = (Self(self.0 & !1).min(Self(other.0 & !1)), Self(self.0 & !1).max(Self(other.0 & !1)));
                Self(tape(|t| t.fact(Fact::Iff(a, b))).0 ^ flip)
            }
        }
    }
    fn at_least(n: usize, of: impl Iterator<Item = Self>) -> Self {
        let mut open: Vec<Self> = Vec::new();
        let mut holding = 0;
        for claim in of {
            match claim.known() {
                Some(holds) => holding += usize::from(holds),
                None => open.push(claim),
            }
        }
        let n = n.saturating_sub(holding);
        match n {
            0 => Self::TRUE,
            1 => any(&open),
            _ if n > open.len() => Self::FALSE,
            _ if n == open.len() => all(&open),
            _ => {
                open.sort_unstable();
                tape(|t| t.fact(Fact::AtLeast(n as u32, open.into())))
            }
        }
    }
}

impl Term {
    /// A node of one argument; constants are computed as floats are.
    fn unary(self, op: Op, plain: impl Fn(f64) -> f64, bound: impl Fn(Interval) -> Interval) -> Self {
        tape(|t| match t.value(self) {
            Some(value) => {
                let result = plain(value);
                let exact = match op {
                    Op::Abs(_) => true,
                    Op::Square(_) => value.mul_add(value, -result) == 0.0,
                    Op::Scale(_, factor) => value.mul_add(f64::from_bits(factor), -result) == 0.0,
                    _ => false,
                };
                t.computed(result, exact, &[self])
            }
            None => {
                let range = bound(t.range(self));
                t.op(op, range)
            }
        })
    }
    fn binary(
        self,
        other: Self,
        op: Op,
        plain: impl Fn(f64, f64) -> f64,
        bound: impl Fn(Interval, Interval) -> Interval,
    ) -> Self {
        tape(|t| match (t.value(self), t.value(other)) {
            (Some(a), Some(b)) => {
                let result = plain(a, b);
                let exact = match op {
                    Op::Min(..) | Op::Max(..) => true,
                    Op::Add(..) => sum_is_exact(a, b),
                    Op::Sub(..) => sum_is_exact(a, -b),
                    Op::Mul(..) => a.mul_add(b, -result) == 0.0,
                    _ => false,
                };
                t.computed(result, exact, &[self, other])
            }
            _ => {
                let range = bound(t.range(self), t.range(other));
                t.op(op, range)
            }
        })
    }
    fn value(self) -> Option<f64> {
        tape(|t| t.value(self))
    }
    /// Whether it is minus something else, or a constant below 0.
    pub fn is_contrary(self) -> bool {
        let minus = (-1f64).to_bits();
        tape(|t| match t.ops[self.0 as usize] {
            Op::Scale(_, factor) => factor == minus,
            Op::Constant(value) => f64::from_bits(value) < 0.0,
            _ => false,
        })
    }
}

fn constant(tape: &mut Tape, value: f64) -> Term {
    // −0 is 0.
    let value = value + 0.0;
    tape.op(Op::Constant(value.to_bits()), if value.is_nan() { Interval::ALL } else { Interval::point(value) })
}

/// Whether a sum is not rounded (Knuth, The Art of Computer Programming, volume 2, 4.2.2, theorem B).
fn sum_is_exact(a: f64, b: f64) -> bool {
    let sum = a + b;
    let of_b = sum - a;
    (a - (sum - of_b)) + (b - of_b) == 0.0
}

fn ordered(a: Term, b: Term) -> (Term, Term) {
    if a.0 <= b.0 { (a, b) } else { (b, a) }
}

impl Algebra for Term {
    type Verdict = Claim;

    fn constant(value: f64) -> Self {
        tape(|t| constant(t, value))
    }
    fn known(self) -> Option<f64> {
        self.value()
    }
    fn indicator(verdict: Claim) -> Self {
        match verdict.known() {
            Some(holds) => <Self as Algebra>::constant(f64::from(u8::from(holds))),
            None => tape(|t| t.op(Op::Indicator(verdict), Interval::new(0.0, 1.0))),
        }
    }
    fn at_least(self, bound: f64) -> Claim {
        compare(self, bound, false)
    }
    fn above(self, bound: f64) -> Claim {
        compare(self, bound, true)
    }
    fn abs(self) -> Self {
        if range(self).lo >= 0.0 {
            return self;
        }
        self.unary(Op::Abs(self), f64::abs, Interval::abs)
    }
    fn min(self, other: Self) -> Self {
        let (x, y) = (range(self), range(other));
        if x.hi <= y.lo {
            return self;
        }
        if y.hi <= x.lo {
            return other;
        }
        let (a, b) = ordered(self, other);
        self.binary(other, Op::Min(a, b), Algebra::min, Interval::min)
    }
    fn max(self, other: Self) -> Self {
        let (x, y) = (range(self), range(other));
        if x.lo >= y.hi {
            return self;
        }
        if y.lo >= x.hi {
            return other;
        }
        let (a, b) = ordered(self, other);
        self.binary(other, Op::Max(a, b), Algebra::max, Interval::max)
    }
    fn sqrt(self) -> Self {
        self.unary(Op::Sqrt(self), f64::sqrt, Interval::sqrt)
    }
    fn sin(self) -> Self {
        self.unary(Op::Sin(self), Algebra::sin, Interval::sin)
    }
    fn cos(self) -> Self {
        self.unary(Op::Cos(self), Algebra::cos, Interval::cos)
    }
    fn atan2(self, x: Self) -> Self {
        self.binary(x, Op::Atan(self, x), Algebra::atan2, Interval::atan2)
    }
    fn wrap(self) -> Self {
        let own = range(self);
        if own.lo >= 0.0 && own.hi < 360.0 {
            return self;
        }
        self.unary(Op::Wrap(self), Algebra::wrap, Interval::wrap)
    }
    fn scale(self, factor: f64) -> Self {
        if factor == 1.0 {
            return self;
        }
        let contrary = |t: &Tape| match t.ops[self.0 as usize] {
            Op::Scale(inner, by) if factor == -1.0 && by == factor.to_bits() => Some(inner),
            _ => None,
        };
        if let Some(inner) = look(contrary) {
            return inner;
        }
        self.unary(Op::Scale(self, factor.to_bits()), |x| x * factor, |x| x.scale(factor))
    }
}

impl Add for Term {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        match (self.value(), other.value()) {
            (Some(0.0), _) => other,
            (_, Some(0.0)) => self,
            _ => {
                let (a, b) = ordered(self, other);
                self.binary(other, Op::Add(a, b), |a, b| a + b, |a, b| a + b)
            }
        }
    }
}

impl Sub for Term {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        match other.value() {
            Some(0.0) => self,
            _ => self.binary(other, Op::Sub(self, other), |a, b| a - b, |a, b| a - b),
        }
    }
}

impl Mul for Term {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        match (self.value(), other.value()) {
            (Some(0.0), None) | (None, Some(0.0)) => <Self as Algebra>::constant(0.0),
            (Some(factor), None) => other.scale(factor),
            (None, Some(factor)) => self.scale(factor),
            _ if self == other => self.unary(Op::Square(self), |x| x * x, Interval::square),
            _ => {
                let (a, b) = ordered(self, other);
                self.binary(other, Op::Mul(a, b), |a, b| a * b, |a, b| a * b)
            }
        }
    }
}

impl Div for Term {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        // By a constant it is linear. The reciprocal may be rounded, as the quotient is when a layout is judged.
        if let (None, Some(divisor)) = (self.value(), other.value())
            && divisor != 0.0
            && (1.0 / divisor).is_finite()
        {
            return self.scale(1.0 / divisor);
        }
        self.binary(other, Op::Div(self, other), |a, b| a / b, Interval::over)
    }
}

impl Neg for Term {
    type Output = Self;
    fn neg(self) -> Self {
        self.scale(-1.0)
    }
}
