//! What a node of a formula yields: a number, a vector, a rotation, or a truth; or the reason why it yields nothing.

use crate::number::{Algebra, Logic, Number};
use crate::vector::V3;
use scenelang_base::{Code, codes};
use scenelang_lang::program::{DrawId, NodeId, ObjectId, RegionId, Unit, VariableId};

/// A verdict with its signed margin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Truth<N: Algebra> {
    /// By how much it holds (> 0) or fails (< 0), tolerances included; ±∞ for a discrete fact.
    pub margin: N,
    /// Whether it holds.
    pub holds: N::Verdict,
    /// Unit of the margin.
    pub unit: Unit,
}

impl<N: Algebra> Truth<N> {
    /// A fact that has no metres.
    pub fn discrete(holds: bool) -> Self {
        let margin = if holds { f64::INFINITY } else { f64::NEG_INFINITY };
        Self { margin: N::constant(margin), holds: N::Verdict::constant(holds), unit: Unit::Metre }
    }
    /// A margin in metres that holds down to minus `slack`.
    pub fn metres(margin: N, slack: f64) -> Self {
        Self { margin, holds: margin.at_least(-slack), unit: Unit::Metre }
    }
    /// A margin in degrees that holds down to minus `slack`.
    pub fn degrees(margin: N, slack: f64) -> Self {
        Self { unit: Unit::Degree, ..Self::metres(margin, slack) }
    }
    /// Whether it is a discrete fact: nothing that is measured can change it.
    pub fn is_discrete(&self) -> bool {
        self.margin.known().is_some_and(f64::is_infinite)
    }
    /// Both: the least margin.
    pub fn and(self, other: Self) -> Self {
        let unit = if other.margin.known() < self.margin.known() { other.unit } else { self.unit };
        Self { margin: self.margin.min(other.margin), holds: self.holds.and(other.holds), unit }
    }
    /// Either: the greatest margin.
    pub fn or(self, other: Self) -> Self {
        let unit = if other.margin.known() > self.margin.known() { other.unit } else { self.unit };
        Self { margin: self.margin.max(other.margin), holds: self.holds.or(other.holds), unit }
    }
    /// The contrary of it.
    pub fn negated(self) -> Self {
        Self { margin: -self.margin, holds: self.holds.negated(), unit: self.unit }
    }
    /// Both or neither.
    pub fn iff(self, other: Self) -> Self {
        let same = self.and(other).or(self.negated().and(other.negated()));
        Self { holds: self.holds.iff(other.holds), ..same }
    }
}

impl<N: Number> Truth<N> {
    /// On plain floats.
    pub fn plain(self) -> Truth<f64> {
        Truth { margin: self.margin.value(), holds: self.holds, unit: self.unit }
    }
}

/// What a node yields.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value<N: Algebra> {
    /// A number: metres, degrees or plain.
    Number(N),
    /// A point, a direction, extents.
    Vector(V3<N>),
    /// A rotation as an Euler triple in degrees.
    Rotation(V3<N>),
    Truth(Truth<N>),
}

impl<N: Algebra> From<Truth<N>> for Value<N> {
    fn from(truth: Truth<N>) -> Self {
        Self::Truth(truth)
    }
}

impl<N: Algebra> From<N> for Value<N> {
    fn from(number: N) -> Self {
        Self::Number(number)
    }
}

impl<N: Number> Value<N> {
    /// The same in other numbers, which depend on nothing.
    pub fn constant<M: Number>(self) -> Value<M> {
        let convert = |v: V3<N>| V3::<M>::constant(&v.value());
        match self {
            Self::Number(n) => Value::Number(M::constant(n.value())),
            Self::Vector(v) => Value::Vector(convert(v)),
            Self::Rotation(v) => Value::Rotation(convert(v)),
            Self::Truth(t) => Value::Truth(Truth::discrete(t.holds)),
        }
    }
}

/// Why a node yields nothing, and which.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EvalError {
    /// The reason.
    pub cause: Cause,
    /// The node where it arose.
    pub node: NodeId,
}

/// Why something cannot be judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Cause {
    /// The layout lacks the object.
    MissingObject(ObjectId),
    /// The layout lacks the region.
    MissingRegion(RegionId),
    /// The layout has no value for the variable.
    MissingVariable(VariableId),
    /// The layout records no such draw.
    MissingDraw(DrawId),
    /// What the layout gives for the variable or the draw is refused, and said so at its own place.
    Refused,
    DivisionByZero,
    /// The square root of a negative number.
    NegativeRoot,
    /// The direction of a zero vector.
    ZeroVector,
    /// The result is too large, or none.
    NotFinite,
}

impl Cause {
    /// The code of its diagnostic; `None` where the layout file's own diagnostics say it already.
    pub fn code(self) -> Option<Code> {
        match self {
            Self::MissingObject(_) | Self::MissingRegion(_) | Self::Refused => None,
            Self::MissingVariable(_) => Some(codes::E0605),
            Self::MissingDraw(_) => Some(codes::E0604),
            Self::DivisionByZero => Some(codes::E0601),
            Self::NegativeRoot => Some(codes::E0602),
            Self::ZeroVector => Some(codes::E0606),
            Self::NotFinite => Some(codes::E0607),
        }
    }
}
