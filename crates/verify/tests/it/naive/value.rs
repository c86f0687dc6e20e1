//! Values and truths, each with how far rounding may have taken it: the text fixes verdicts except where a margin is
//! within that of its threshold.

use super::space::{V, length};
use super::term::Order;

/// What a literal is depends on its surroundings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Literal,
    Plain,
    Degree,
}

#[derive(Clone, Copy, Debug)]
pub struct Num {
    pub x: f64,
    pub kind: Kind,
    /// How far another way of computing may be from this. Infinite: a jump is near.
    pub noise: f64,
}

/// What rounding does to a length that geometry gives.
pub const NOISE: f64 = 1e-10;

impl Num {
    pub fn plain(x: f64) -> Self {
        Self { x, kind: Kind::Plain, noise: NOISE * (1.0 + x.abs()) }
    }
    pub fn degree(x: f64) -> Self {
        Self { kind: Kind::Degree, ..Self::plain(x) }
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Vector {
    pub v: V,
    pub noise: f64,
}

impl Vector {
    pub fn new(v: V) -> Self {
        Self { v, noise: NOISE * (1.0 + length(v)) }
    }
}

/// A signed margin with its verdict.
#[derive(Clone, Copy, Debug)]
pub struct Truth {
    pub margin: f64,
    /// `None`: too near to the threshold to say.
    pub holds: Option<bool>,
    /// Of the margin. Infinite where the text fixes no more than the sign.
    pub noise: f64,
    /// `None`: of two parts that decide alike, one is in degrees.
    pub degrees: Option<bool>,
}

/// `<=` and `>=`, and the physical rules, hold down to minus this.
pub const ORDER: f64 = 1e-6;
/// `=` of lengths.
pub const EQUAL: f64 = 1e-3;
/// `=` of degrees.
pub const EQUAL_DEGREES: f64 = 0.1;
/// How deep solids may touch, boxes leave.
pub const CONTACT: f64 = 1e-3;

impl Truth {
    pub fn discrete(holds: bool) -> Self {
        let margin = if holds { f64::INFINITY } else { f64::NEG_INFINITY };
        Self { margin, holds: Some(holds), noise: 0.0, degrees: Some(false) }
    }
    /// Holds above a threshold.
    fn above(margin: f64, threshold: f64, noise: f64, degrees: bool) -> Self {
        let noise = noise.max(1e-14 * (1.0 + margin.abs()));
        let holds = ((margin - threshold).abs() > noise).then_some(margin > threshold);
        Self { margin, holds, noise, degrees: Some(degrees) }
    }
    /// Built-in predicates and physical rules, of which the text does not say what happens within 1e-6 of 0.
    pub fn geometric(margin: f64) -> Self {
        Self { noise: 1e-8, ..Self::above(margin, 0.0, 2e-6, false) }
    }
    /// The same where only the sign is given by the text.
    pub fn sign(margin: f64) -> Self {
        Self { noise: f64::INFINITY, ..Self::geometric(margin) }
    }
    pub fn rough(self) -> Self {
        Self { noise: f64::INFINITY, ..self }
    }
    /// At least zero, in metres.
    pub fn at_least_zero(margin: f64) -> Self {
        Self::above(margin, -ORDER, NOISE * (1.0 + margin.abs()), false)
    }
    pub fn is_discrete(&self) -> bool {
        self.margin.is_infinite()
    }
    pub fn not(self) -> Self {
        Self { margin: -self.margin, holds: self.holds.map(|h| !h), ..self }
    }
    fn with(self, other: Self, holds: Option<bool>, first: bool) -> Self {
        let (taken, left) = if first { (self, other) } else { (other, self) };
        let close = (taken.margin - left.margin).abs() <= taken.noise + left.noise;
        let noise = if close || left.noise.is_infinite() { taken.noise.max(left.noise) } else { taken.noise };
        let degrees = taken.degrees.filter(|d| !close || left.degrees == Some(*d));
        Self { holds, noise, degrees, ..taken }
    }
    pub fn and(self, other: Self) -> Self {
        let holds = match (self.holds, other.holds) {
            (Some(false), _) | (_, Some(false)) => Some(false),
            (Some(true), Some(true)) => Some(true),
            _ => None,
        };
        self.with(other, holds, self.margin <= other.margin)
    }
    pub fn or(self, other: Self) -> Self {
        self.not().and(other.not()).not()
    }
    /// Both or neither.
    pub fn iff(self, other: Self) -> Self {
        let both = self.and(other).or(self.not().and(other.not()));
        let holds = self.holds.zip(other.holds).map(|(p, q)| p == q);
        Self { holds, ..both }
    }
}

/// Two numbers compared; equality of degrees goes around.
pub fn compare(order: Order, a: Num, b: Num) -> Truth {
    let degrees = a.kind == Kind::Degree || b.kind == Kind::Degree;
    let noise = a.noise + b.noise;
    match order {
        Order::Lt => Truth::above(b.x - a.x, 0.0, noise, degrees),
        Order::Gt => Truth::above(a.x - b.x, 0.0, noise, degrees),
        Order::Le => Truth::above(b.x - a.x, -ORDER, noise, degrees),
        Order::Ge => Truth::above(a.x - b.x, -ORDER, noise, degrees),
        Order::Ne => compare(Order::Eq, a, b).not(),
        Order::Eq => {
            let off = (a.x - b.x).abs();
            let off = if degrees { (off % 360.0).min(360.0 - off % 360.0) } else { off };
            Truth::above((if degrees { EQUAL_DEGREES } else { EQUAL }) - off, 0.0, noise, degrees)
        }
    }
}

/// Two vectors, by their distance.
pub fn same_vectors(a: Vector, b: Vector) -> Truth {
    let noise = a.noise + b.noise;
    Truth::above(EQUAL - super::space::distance(a.v, b.v), 0.0, noise, false)
}

/// Two orientations, by the angle between them.
pub fn same_rotations(a: V, b: V) -> Truth {
    let between = super::space::turn_between(&super::space::euler(a), &super::space::euler(b));
    Truth::above(EQUAL_DEGREES - between, 0.0, 1e-5, true)
}

/// The n-th greatest of the margins; truth by counting.
pub fn at_least(n: usize, truths: &[Truth]) -> Truth {
    if n == 0 || n > truths.len() {
        return Truth::discrete(n == 0);
    }
    let mut sorted = truths.to_vec();
    sorted.sort_by(|a, b| b.margin.total_cmp(&a.margin));
    let sure = truths.iter().filter(|t| t.holds == Some(true)).count();
    let perhaps = truths.iter().filter(|t| t.holds.is_none()).count();
    let holds = if sure >= n { Some(true) } else { (sure + perhaps < n).then_some(false) };
    let noise = truths.iter().map(|t| t.noise).fold(0.0, f64::max);
    Truth { holds, noise, ..sorted[n - 1] }
}
