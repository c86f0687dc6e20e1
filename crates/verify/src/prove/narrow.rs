//! How one operation narrows what it is made of: forward from arguments to result, and back from result to arguments.
//!
//! Each rule keeps every combination of members that satisfies the operation. An operation that is undefined somewhere
//! (a quotient by 0, the root of a negative number) may there have any result, since formulas may skip it.

use super::interval::{Interval, down, up};
use super::problem::Function;

/// What is left of result and arguments (of one argument: both alike).
pub(super) fn narrow(function: Function, z: Interval, x: Interval, y: Interval) -> [Interval; 3] {
    match function {
        Function::Mul => {
            let back = |z: Interval, x: Interval, y: Interval| {
                // Where y can be 0 the quotient is unbounded, unless z is away from 0: then |x| is at least |z| / |y|.
                if !y.has(0.0) {
                    return x.meet(inflate(z).over(y));
                }
                if z.has(0.0) {
                    return x;
                }
                away(x, z.abs().lo, y.magnitude(), z, y)
            };
            let z = z.meet(x * y);
            [z, back(z, x, y), back(z, y, x)]
        }
        Function::Div => {
            if y.has(0.0) {
                return [z, x, y];
            }
            let z = z.meet(x.over(y));
            let y_back = if z.has(0.0) || x.has(0.0) { y } else { y.meet(x.over(inflate(z))) };
            [z, x.meet(inflate(z) * y), y_back]
        }
        Function::Square => {
            let z = z.meet(x.square());
            let x = x.meet(both(Interval::new(0.0, up(up(z.hi).max(0.0).sqrt()))));
            let x = outside(x, down(down(z.lo).max(0.0).sqrt()));
            [z, x, x]
        }
        Function::Sqrt => {
            let z = z.meet(x.sqrt());
            let x = if z.lo > 0.0 { x.meet(Interval::from(down(down(z.lo) * down(z.lo)))) } else { x };
            let x = x.meet(Interval::to(up(up(z.hi) * up(z.hi))));
            [z, x, x]
        }
        Function::Abs => {
            let z = z.meet(x.abs());
            let x = outside(x.meet(both(z)), z.lo);
            [z, x, x]
        }
        Function::Min => {
            let z = z.meet(x.min(y));
            let floor = Interval::from(z.lo);
            let (x, y) = (x.meet(floor), y.meet(floor));
            // If the one is never the least, the other is it.
            let (a, b) = (if y.lo > z.hi { x.meet(z) } else { x }, if x.lo > z.hi { y.meet(z) } else { y });
            [z, a, b]
        }
        Function::Max => {
            let z = z.meet(x.max(y));
            let roof = Interval::to(z.hi);
            let (x, y) = (x.meet(roof), y.meet(roof));
            let (a, b) = (if y.hi < z.lo { x.meet(z) } else { x }, if x.hi < z.lo { y.meet(z) } else { y });
            [z, a, b]
        }
        Function::Sin => [z.meet(x.sin()), x, x],
        Function::Cos => [z.meet(x.cos()), x, x],
        Function::Atan => [z.meet(x.atan2(y)), x, y],
        Function::Wrap => {
            let turns = (x.lo / 360.0).floor();
            let one = turns == (x.hi / 360.0).floor() && turns.abs() < 1e9;
            let back = if one { x.meet(inflate(z) + Interval::point(360.0 * turns)) } else { x };
            [z.meet(x.wrap()), back, back]
        }
    }
}

/// One step wider: a result that was rounded came from something that near.
fn inflate(z: Interval) -> Interval {
    Interval::new(down(z.lo), up(z.hi))
}

/// z and −z, and what is between them.
fn both(z: Interval) -> Interval {
    Interval::new(-z.hi, z.hi)
}

/// What of an interval is at least `least` away from 0.
fn outside(x: Interval, least: f64) -> Interval {
    if least <= 0.0 {
        return x;
    }
    let lo = if x.lo > -least { x.lo.max(least) } else { x.lo };
    let hi = if x.hi < least { x.hi.min(-least) } else { x.hi };
    Interval::new(lo, hi)
}

/// x of x·y = z where z is away from 0 and y may be 0: |x| is at least |z| / |y|; and of one sign, if y is.
fn away(x: Interval, z_least: f64, y_most: f64, z: Interval, y: Interval) -> Interval {
    if y_most == 0.0 {
        return Interval::new(1.0, 0.0);
    }
    let least = down(down(z_least) / y_most);
    let x = outside(x, least);
    let positive = z.lo > 0.0;
    if y.lo >= 0.0 {
        return x.meet(if positive { Interval::from(least) } else { Interval::to(-least) });
    }
    if y.hi <= 0.0 {
        return x.meet(if positive { Interval::to(-least) } else { Interval::from(least) });
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Algebra;
    use proptest::prelude::*;

    const FUNCTIONS: [Function; 11] = [
        Function::Mul,
        Function::Div,
        Function::Square,
        Function::Sqrt,
        Function::Abs,
        Function::Min,
        Function::Max,
        Function::Sin,
        Function::Cos,
        Function::Atan,
        Function::Wrap,
    ];

    fn plain(function: Function, x: f64, y: f64) -> f64 {
        match function {
            Function::Mul => x * y,
            Function::Div => x / y,
            Function::Square => x * x,
            Function::Sqrt => x.sqrt(),
            Function::Abs => x.abs(),
            Function::Min => x.min(y),
            Function::Max => x.max(y),
            Function::Sin => Algebra::sin(x),
            Function::Cos => Algebra::cos(x),
            Function::Atan => Algebra::atan2(x, y),
            Function::Wrap => Algebra::wrap(x),
        }
    }

    proptest! {
        /// A combination that satisfies the operation is never narrowed away.
        #[test]
        fn solutions_stay(x in -800.0..800.0f64, y in -9.0..9.0f64, wide in prop::array::uniform6(0.0..30.0f64), exact in 0u8..8) {
            for function in FUNCTIONS {
                let two = matches!(function, Function::Mul | Function::Div | Function::Min | Function::Max | Function::Atan);
                let y = if two { y } else { x };
                let z = plain(function, x, y);
                if z.is_nan() || z.is_infinite() {
                    continue;
                }
                let around = |v: f64, k: usize| {
                    let point = exact >> (k / 2) & 1 == 1;
                    if point { Interval::point(v) } else { Interval::new(v - wide[k], v + wide[k + 1]) }
                };
                let (a, b) = (around(x, 0), around(y, 2));
                let b = if two { b } else { a };
                let [r, p, q] = narrow(function, around(z, 4), a, b);
                prop_assert!(r.has(z) && p.has(x) && q.has(y), "{:?} {} {} {}: {:?} {:?} {:?}", function, x, y, z, r, p, q);
            }
        }
    }
}
