//! Sets of numbers between two bounds, with operations that lose nothing: whatever the operation yields on members of
//! the arguments is a member of the result. Bounds are rounded outward, one step of the float beyond the nearest.
//!
//! No bound is ever a NaN: where an operation has no bound, the bound is infinite.

use scenelang_layout::rotation::sin_cos;
use std::ops::{Add, Mul, Neg, Sub};

/// All numbers from `lo` to `hi`; empty where `lo > hi`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Interval {
    pub lo: f64,
    pub hi: f64,
}

impl Interval {
    /// Every number.
    pub const ALL: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// Between two bounds.
    pub fn new(lo: f64, hi: f64) -> Self {
        Self { lo, hi }
    }
    /// One number.
    pub fn point(value: f64) -> Self {
        Self { lo: value, hi: value }
    }
    /// From `bound` up.
    pub fn from(bound: f64) -> Self {
        Self { lo: bound, hi: f64::INFINITY }
    }
    /// Up to `bound`.
    pub fn to(bound: f64) -> Self {
        Self { lo: f64::NEG_INFINITY, hi: bound }
    }
    pub fn is_empty(self) -> bool {
        self.lo > self.hi
    }
    pub fn is_point(self) -> bool {
        self.lo == self.hi
    }
    pub fn has(self, value: f64) -> bool {
        self.lo <= value && value <= self.hi
    }
    pub fn width(self) -> f64 {
        self.hi - self.lo
    }
    /// The greatest distance from 0.
    pub fn magnitude(self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }
    pub fn meet(self, other: Self) -> Self {
        Self { lo: self.lo.max(other.lo), hi: self.hi.min(other.hi) }
    }
    pub fn abs(self) -> Self {
        if self.lo >= 0.0 {
            self
        } else if self.hi <= 0.0 {
            -self
        } else {
            Self { lo: 0.0, hi: self.magnitude() }
        }
    }
    pub fn min(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.min(other.hi) }
    }
    pub fn max(self, other: Self) -> Self {
        Self { lo: self.lo.max(other.lo), hi: self.hi.max(other.hi) }
    }
    pub fn square(self) -> Self {
        let a = self.abs();
        Self { lo: down(a.lo * a.lo).max(0.0), hi: up(a.hi * a.hi) }
    }
    /// Of what is not negative in it.
    pub fn sqrt(self) -> Self {
        Self { lo: down(self.lo.max(0.0).sqrt()).max(0.0), hi: up(self.hi.max(0.0).sqrt()) }
    }
    pub fn scale(self, factor: f64) -> Self {
        match factor {
            1.0 => self,
            -1.0 => -self,
            _ => self * Self::point(factor),
        }
    }
    /// Quotients by what is not 0 in `divisor`; everything, where that comes arbitrarily close to 0.
    pub fn over(self, divisor: Self) -> Self {
        if divisor.lo <= 0.0 && divisor.hi >= 0.0 {
            return Self::ALL;
        }
        corners(self, divisor, |a, b| if a.is_infinite() && b.is_infinite() { f64::NAN } else { a / b })
    }
    /// Of degrees.
    pub fn sin(self) -> Self {
        (self + Self::point(-90.0)).cos()
    }
    /// Of degrees.
    pub fn cos(self) -> Self {
        // Beyond this size a float does not know its turn well enough.
        if self.width() >= 360.0 || self.magnitude() > 1e9 || self.is_empty() {
            return Self::new(-1.0, 1.0);
        }
        let (a, b) = (sin_cos(self.lo).1, sin_cos(self.hi).1);
        let slack = 1e-12;
        let turns = |offset: f64| ((self.lo - offset) / 360.0).floor() != ((self.hi - offset) / 360.0).floor();
        let near = |offset: f64| turns(offset) || turns(offset + 1e-6) || turns(offset - 1e-6);
        Self {
            lo: if near(180.0) { -1.0 } else { (a.min(b) - slack).max(-1.0) },
            hi: if near(0.0) { 1.0 } else { (a.max(b) + slack).min(1.0) },
        }
    }
    /// The angle of (`x`, `self`) in degrees.
    pub fn atan2(self, x: Self) -> Self {
        if self.is_point() && x.is_point() {
            let angle = self.lo.atan2(x.lo).to_degrees();
            return Self::new(angle - 1e-12, angle + 1e-12);
        }
        // Around the origin, and across the half-axis where the angle jumps, it may be any; elsewhere it is greatest and
        // least at corners, since along each side it only grows or only falls.
        let around = self.lo <= 0.0 && self.hi >= 0.0 && x.lo <= 0.0;
        let jumps = around && (self.lo < 0.0 || x.hi >= 0.0);
        if jumps || !self.magnitude().is_finite() || !x.magnitude().is_finite() {
            return if self.lo >= 0.0 { Self::new(0.0, 180.0) } else { Self::new(-180.0, 180.0) };
        }
        let angles = [self.lo, self.hi].into_iter().flat_map(|y| [x.lo, x.hi].map(|x| (y + 0.0).atan2(x).to_degrees()));
        let (lo, hi) = angles.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), a| (lo.min(a), hi.max(a)));
        Self::new(lo - 1e-9, hi + 1e-9)
    }
    /// Modulo 360.
    pub fn wrap(self) -> Self {
        let turns = (self.lo / 360.0).floor();
        if !turns.is_finite() || turns != (self.hi / 360.0).floor() || turns.abs() > 1e9 {
            return Self::new(0.0, 360.0);
        }
        (self + Self::point(-360.0 * turns)).meet(Self::new(0.0, 360.0))
    }
}

/// The next float below, and of what is not a number the least.
pub(super) fn down(x: f64) -> f64 {
    if x.is_nan() { f64::NEG_INFINITY } else { x.next_down() }
}

/// The next float above, and of what is not a number the greatest.
pub(super) fn up(x: f64) -> f64 {
    if x.is_nan() { f64::INFINITY } else { x.next_up() }
}

/// Sums, exact where the float sum is (so that constants stay points).
fn add_down(a: f64, b: f64) -> f64 {
    let sum = a + b;
    if exact(a, b, sum) { sum } else { down(sum) }
}

fn add_up(a: f64, b: f64) -> f64 {
    let sum = a + b;
    if exact(a, b, sum) { sum } else { up(sum) }
}

/// Whether a sum was not rounded (Knuth's error term is 0); infinities are themselves.
fn exact(a: f64, b: f64, sum: f64) -> bool {
    if sum.is_infinite() {
        return a.is_infinite() || b.is_infinite();
    }
    let part = sum - a;
    (a - (sum - part)) + (b - part) == 0.0
}

/// From the values at the corners. Where one is no number (0·∞) it is 0: the infinity is a bound that no member reaches.
fn corners(a: Interval, b: Interval, f: impl Fn(f64, f64) -> f64) -> Interval {
    let unit = |x: Interval| x.is_point() && (x.lo == 0.0 || x.lo.abs() == 1.0 || x.lo.abs() == 0.5);
    let all = [f(a.lo, b.lo), f(a.lo, b.hi), f(a.hi, b.lo), f(a.hi, b.hi)].map(|x| if x.is_nan() { 0.0 } else { x });
    let (lo, hi) =
        (all.iter().copied().fold(f64::INFINITY, f64::min), all.iter().copied().fold(f64::NEG_INFINITY, f64::max));
    if unit(a) || unit(b) { Interval { lo, hi } } else { Interval { lo: down(lo), hi: up(hi) } }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { lo: add_down(self.lo, other.lo), hi: add_up(self.hi, other.hi) }
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        corners(self, other, |a, b| a * b)
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Algebra;
    use proptest::prelude::*;

    fn within(bounds: (f64, f64), part: f64) -> (Interval, f64) {
        let (a, b) = bounds;
        let set = Interval::new(a.min(b), a.max(b));
        (set, (set.lo + part * (set.hi - set.lo)).clamp(set.lo, set.hi))
    }

    proptest! {
        #[test]
        fn results_hold_the_results_of_members(
            a in (-500.0..500.0f64, -500.0..500.0f64), b in (-9.0..9.0f64, -9.0..9.0f64), s in 0.0..1.0f64, t in 0.0..1.0f64,
        ) {
            let ((x, p), (y, q)) = (within(a, s), within(b, t));
            let pairs = [
                (x + y, p + q), (x - y, p - q), (x * y, p * q), (x.square(), p * p), (x.abs(), p.abs()),
                (x.min(y), p.min(q)), (x.max(y), p.max(q)), (x.abs().sqrt(), p.abs().sqrt()), (x.scale(0.3), p * 0.3),
                (x.sin(), Algebra::sin(p)), (x.cos(), Algebra::cos(p)), (x.wrap(), Algebra::wrap(p)),
                (x.atan2(y), Algebra::atan2(p, q)), (x.over(y), if q == 0.0 { 0.0 } else { p / q }),
            ];
            for (i, (set, member)) in pairs.into_iter().enumerate() {
                prop_assert!(set.has(member), "operation {} on {:?} {:?}: {:?} lacks {}", i, x, y, set, member);
            }
        }
    }

    #[test]
    fn infinite_bounds_make_no_nan() {
        let zero = Interval::point(0.0);
        for set in [
            Interval::ALL * zero,
            Interval::ALL - Interval::ALL,
            Interval::ALL.over(Interval::ALL),
            Interval::ALL.cos(),
        ] {
            assert!(!set.lo.is_nan() && !set.hi.is_nan(), "{set:?}");
        }
        assert_eq!(Interval::point(0.5) + Interval::point(0.25), Interval::point(0.75), "exact sums stay points");
    }
}
