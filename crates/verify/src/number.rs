//! What the evaluator computes with: plain floats, or floats with their derivatives; a third kind, unknowns of which
//! only bounds are known, is in `prove`.
//!
//! Where a function has no derivative (`sqrt` at 0, `abs` at 0, an angle between vectors of which one is zero) the
//! derivative is 0: a margin sits in such points exactly when it is satisfied, and a NaN there would end a search.

use scenelang_layout::rotation::sin_cos;
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A verdict, or something that behaves like one.
pub trait Logic: Copy + Debug + PartialEq + 'static {
    /// A verdict that depends on nothing.
    fn constant(holds: bool) -> Self;
    /// The verdict, where it is settled.
    fn known(self) -> Option<bool>;
    /// Both.
    fn and(self, other: Self) -> Self;
    /// Either.
    fn or(self, other: Self) -> Self;
    /// The contrary.
    fn negated(self) -> Self;
    /// Both or neither.
    fn iff(self, other: Self) -> Self;
    /// At least `n` of them.
    fn at_least(n: usize, of: impl Iterator<Item = Self>) -> Self;
}

impl Logic for bool {
    fn constant(holds: bool) -> Self {
        holds
    }
    fn known(self) -> Option<bool> {
        Some(self)
    }
    fn and(self, other: Self) -> Self {
        self && other
    }
    fn or(self, other: Self) -> Self {
        self || other
    }
    fn negated(self) -> Self {
        !self
    }
    fn iff(self, other: Self) -> Self {
        self == other
    }
    fn at_least(n: usize, of: impl Iterator<Item = Self>) -> Self {
        of.filter(|holds| *holds).count() >= n
    }
}

/// What formulas are evaluated in. Angles are degrees.
///
/// It need not have a value: of what is unknown (see `prove`) the evaluator may ask only what is [known](Self::known),
/// and decides by `min`, `max`, `abs` and verdicts.
pub trait Algebra:
    Copy
    + Debug
    + PartialEq
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// What comparisons of it yield.
    type Verdict: Logic;
    /// A number that depends on nothing.
    fn constant(value: f64) -> Self;
    /// Its plain value, if it has one.
    fn known(self) -> Option<f64>;
    /// 1 where the verdict is yes, else 0.
    fn indicator(verdict: Self::Verdict) -> Self;
    /// Whether it is `bound` or more.
    fn at_least(self, bound: f64) -> Self::Verdict;
    /// Whether it is more than `bound`.
    fn above(self, bound: f64) -> Self::Verdict;
    /// Without its sign.
    fn abs(self) -> Self;
    /// The smaller; of equals, `self`.
    fn min(self, other: Self) -> Self;
    /// The greater; of equals, `self`.
    fn max(self, other: Self) -> Self;
    /// The square root; the caller rules out negative values.
    fn sqrt(self) -> Self;
    /// The sine of degrees, exact at quarter turns.
    fn sin(self) -> Self;
    /// The cosine of degrees, exact at quarter turns.
    fn cos(self) -> Self;
    /// The angle of the point (`x`, `self`) in degrees, in (−180, 180].
    fn atan2(self, x: Self) -> Self;
    /// Degrees modulo 360, in [0, 360).
    fn wrap(self) -> Self;
    /// Times a plain factor.
    fn scale(self, factor: f64) -> Self;
}

/// A number with a plain value, which geometry can measure: a float, alone or with derivatives.
pub trait Number: Algebra<Verdict = bool> {
    /// Its plain value.
    fn value(self) -> f64;
    /// A number whose value was measured by geometry on plain floats. `slope` moves as it does, to first order; only
    /// its derivatives are used, and it is not asked for where there are none to find.
    fn measured(value: f64, slope: impl FnOnce() -> Self) -> Self;
}

/// Degrees modulo 360; a tiny negative angle is 0, not 360.
fn wrap(degrees: f64) -> f64 {
    let turned = degrees.rem_euclid(360.0);
    if turned >= 360.0 { 0.0 } else { turned }
}

impl Number for f64 {
    fn value(self) -> f64 {
        self
    }
    fn measured(value: f64, _: impl FnOnce() -> Self) -> Self {
        value
    }
}

impl Algebra for f64 {
    type Verdict = bool;
    fn constant(value: f64) -> Self {
        value
    }
    fn known(self) -> Option<f64> {
        Some(self)
    }
    fn indicator(verdict: bool) -> Self {
        f64::from(u8::from(verdict))
    }
    fn at_least(self, bound: f64) -> bool {
        self >= bound
    }
    fn above(self, bound: f64) -> bool {
        self > bound
    }
    fn abs(self) -> Self {
        self.abs()
    }
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
    fn sqrt(self) -> Self {
        self.sqrt()
    }
    fn sin(self) -> Self {
        sin_cos(self).0
    }
    fn cos(self) -> Self {
        sin_cos(self).1
    }
    fn atan2(self, x: Self) -> Self {
        self.atan2(x).to_degrees()
    }
    fn wrap(self) -> Self {
        wrap(self)
    }
    fn scale(self, factor: f64) -> Self {
        self * factor
    }
}

/// A value with its derivatives by K unknowns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<const K: usize> {
    pub value: f64,
    /// Its partial derivatives.
    pub slope: [f64; K],
}

impl<const K: usize> Dual<K> {
    /// The unknown number `index`, at `value`.
    pub fn unknown(value: f64, index: usize) -> Self {
        let mut slope = [0.0; K];
        slope[index] = 1.0;
        Self { value, slope }
    }
    /// `value`, moving `by` times as fast as `self`; where that is not finite (at a corner) it does not move.
    fn chain(self, value: f64, by: f64) -> Self {
        let by = if by.is_finite() && value.is_finite() { by } else { 0.0 };
        Self { value, slope: self.slope.map(|s| s * by) }
    }
    /// `value`, moving as `p` times `self` and `q` times `other`.
    fn join(self, other: Self, value: f64, p: f64, q: f64) -> Self {
        if !(value.is_finite() && p.is_finite() && q.is_finite()) {
            return Self::constant(value);
        }
        Self { value, slope: std::array::from_fn(|i| p * self.slope[i] + q * other.slope[i]) }
    }
}

impl<const K: usize> Number for Dual<K> {
    fn value(self) -> f64 {
        self.value
    }
    fn measured(value: f64, slope: impl FnOnce() -> Self) -> Self {
        Self { value, ..slope() }
    }
}

impl<const K: usize> Algebra for Dual<K> {
    type Verdict = bool;
    fn constant(value: f64) -> Self {
        Self { value, slope: [0.0; K] }
    }
    fn known(self) -> Option<f64> {
        Some(self.value)
    }
    fn indicator(verdict: bool) -> Self {
        Self::constant(f64::from(u8::from(verdict)))
    }
    fn at_least(self, bound: f64) -> bool {
        self.value >= bound
    }
    fn above(self, bound: f64) -> bool {
        self.value > bound
    }
    fn abs(self) -> Self {
        let sign = if self.value == 0.0 { 0.0 } else { self.value.signum() };
        self.chain(self.value.abs(), sign)
    }
    fn min(self, other: Self) -> Self {
        if other.value < self.value { other } else { self }
    }
    fn max(self, other: Self) -> Self {
        if other.value > self.value { other } else { self }
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }
    fn sin(self) -> Self {
        let (sin, cos) = sin_cos(self.value);
        self.chain(sin, cos.to_radians())
    }
    fn cos(self) -> Self {
        let (sin, cos) = sin_cos(self.value);
        self.chain(cos, -sin.to_radians())
    }
    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        let per = 1f64.to_degrees() / square;
        self.join(x, Algebra::atan2(self.value, x.value), x.value * per, -self.value * per)
    }
    fn wrap(self) -> Self {
        self.chain(wrap(self.value), 1.0)
    }
    fn scale(self, factor: f64) -> Self {
        self.chain(self.value * factor, factor)
    }
}

impl<const K: usize> Add for Dual<K> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.join(other, self.value + other.value, 1.0, 1.0)
    }
}

impl<const K: usize> Sub for Dual<K> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.join(other, self.value - other.value, 1.0, -1.0)
    }
}

impl<const K: usize> Mul for Dual<K> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.join(other, self.value * other.value, other.value, self.value)
    }
}

impl<const K: usize> Div for Dual<K> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        self.join(other, value, 1.0 / other.value, -value / other.value)
    }
}

impl<const K: usize> Neg for Dual<K> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, slope: self.slope.map(|s| -s) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    type D = Dual<2>;

    fn numeric(f: impl Fn(f64, f64) -> f64, x: f64, y: f64) -> [f64; 2] {
        let h = 1e-6;
        [(f(x + h, y) - f(x - h, y)) / (2.0 * h), (f(x, y + h) - f(x, y - h)) / (2.0 * h)]
    }

    fn formulas<N: Number>(x: N, y: N) -> Vec<N> {
        vec![
            x * y - x / (y * y + N::constant(1.0)),
            (x * x + y * y).sqrt(),
            x.sin() * y.cos(),
            (x * y).scale(2.0).abs(),
            x.min(y).max(-x),
            y.atan2(x),
            x.wrap() + y,
        ]
    }

    proptest! {
        #[test]
        fn derivatives_agree_with_differences(x in 0.1..170f64, y in 0.1..170f64) {
            prop_assume!((x - y).abs() > 1e-3);
            let exact = formulas(D::unknown(x, 0), D::unknown(y, 1));
            let plain = formulas(x, y);
            for (i, d) in exact.iter().enumerate() {
                prop_assert_eq!(d.value, plain[i]);
                let expect = numeric(|x, y| formulas(x, y)[i], x, y);
                for k in 0..2 {
                    prop_assert!((d.slope[k] - expect[k]).abs() <= 1e-5 * (1.0 + expect[k].abs()), "{} {:?} {:?}", i, d, expect);
                }
            }
        }
    }

    #[test]
    fn corners_have_no_slope_rather_than_none() {
        let (x, zero) = (D::unknown(0.0, 0), D::constant(0.0));
        for d in [(x * x).sqrt(), x.abs(), x.atan2(zero), x / zero, D::constant(f64::INFINITY) * x] {
            assert_eq!(d.slope, [0.0; 2], "{d:?}");
        }
    }

    #[test]
    fn quarter_turns_are_exact() {
        for (angle, sin, cos) in [(90.0, 1.0, 0.0), (-90.0, -1.0, 0.0), (450.0, 1.0, 0.0), (-180.0, 0.0, -1.0)] {
            assert_eq!((Algebra::sin(angle), Algebra::cos(angle)), (sin, cos));
        }
        assert_eq!(Algebra::wrap(-1e-20), 0.0);
        assert_eq!(Algebra::wrap(-5.0), 355.0);
    }
}
