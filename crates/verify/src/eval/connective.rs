//! Truths: comparisons, and what `and`, `or`, `not`, counting make of them.
//!
//! A comparison decides its verdict by its own rule; connectives join verdicts by logic and margins by min and max.

use super::Values;
use super::value::{EvalError, Truth, Value};
use crate::number::{Algebra, Logic, Number};
use crate::tolerances::Tolerances;
use crate::vector::{M3, V3};
use scenelang_lang::program::{Comparison, Node, NodeId, Unit};

/// Equality holds exactly up to its tolerance; this is for the rounding of 1 − 0.999.
const ROUNDING: f64 = 1e-12;

/// A truth. Formulas are typed by the front end; another kind of value is a mistake there.
#[track_caller]
pub(super) fn truth<N: Algebra>(value: Value<N>) -> Truth<N> {
    match value {
        Value::Truth(t) => t,
        other => unreachable!("a formula of the wrong types: {other:?}"),
    }
}

/// A comparison of numbers.
pub(super) fn compare<N: Algebra>(op: Comparison, unit: Unit, a: N, b: N, tolerances: &Tolerances) -> Truth<N> {
    let over = |more: N, less: N, strict: bool| {
        // Two walks without a way are equally long; their difference is no number.
        if more.known().is_some_and(f64::is_infinite) && more.known() == less.known() {
            return Truth::discrete(!strict);
        }
        let margin = more - less;
        let holds = if strict { margin.above(0.0) } else { margin.at_least(-tolerances.order) };
        Truth { margin, holds, unit }
    };
    match op {
        Comparison::Lt => over(b, a, true),
        Comparison::Le => over(b, a, false),
        Comparison::Gt => over(a, b, true),
        Comparison::Ge => over(a, b, false),
        Comparison::Eq => equal(unit, a, b, tolerances),
        Comparison::Ne => equal(unit, a, b, tolerances).negated(),
    }
}

fn equal<N: Algebra>(unit: Unit, a: N, b: N, tolerances: &Tolerances) -> Truth<N> {
    if a.known().is_some_and(f64::is_infinite) && a.known() == b.known() {
        return Truth::discrete(true);
    }
    match unit {
        Unit::Metre => within(tolerances.equal, (a - b).abs(), unit),
        Unit::Degree => {
            let turned = (a - b).wrap();
            within(tolerances.angle, turned.min(N::constant(360.0) - turned), unit)
        }
    }
}

fn within<N: Algebra>(tolerance: f64, difference: N, unit: Unit) -> Truth<N> {
    let margin = N::constant(tolerance) - difference;
    Truth { margin, holds: margin.at_least(-ROUNDING), unit }
}

/// Two vectors at the same point.
pub(super) fn same_point<N: Algebra>(a: V3<N>, b: V3<N>, tolerances: &Tolerances) -> Truth<N> {
    within(tolerances.equal, (a - b).length(), Unit::Metre)
}

/// Two rotations of the same orientation.
pub(super) fn same_turn<N: Number>(a: Value<N>, b: Value<N>, tolerances: &Tolerances) -> Truth<N> {
    match (a, b) {
        (Value::Rotation(a), Value::Rotation(b)) => {
            within(tolerances.angle, M3::rotation(a).angle(&M3::rotation(b)), Unit::Degree)
        }
        other => unreachable!("a formula of the wrong types: {other:?}"),
    }
}

pub(super) fn all<N: Algebra>(values: &Values<N>, parts: &[NodeId]) -> Result<Truth<N>, EvalError> {
    join(values, parts, true, Truth::and)
}

pub(super) fn any<N: Algebra>(values: &Values<N>, parts: &[NodeId]) -> Result<Truth<N>, EvalError> {
    join(values, parts, false, Truth::or)
}

fn join<N: Algebra>(
    values: &Values<N>,
    parts: &[NodeId],
    empty: bool,
    with: fn(Truth<N>, Truth<N>) -> Truth<N>,
) -> Result<Truth<N>, EvalError> {
    let mut joined = Truth::discrete(empty);
    for part in parts {
        joined = with(joined, truth(values[part.0 as usize]?));
        // A discrete fact that decides: what stands to its right has no say, errors included.
        if joined.holds.known() == Some(!empty) && joined.is_discrete() {
            break;
        }
    }
    Ok(joined)
}

/// How many hold.
pub(super) fn count<N: Algebra>(values: &Values<N>, parts: &[NodeId]) -> Result<N, EvalError> {
    let mut sum = N::constant(0.0);
    for part in parts {
        sum = sum + N::indicator(truth(values[part.0 as usize]?).holds);
    }
    Ok(sum)
}

/// At least n hold: the n-th greatest margin, kept by min and max alone.
pub(super) fn at_least<N: Algebra>(
    n: usize,
    values: &Values<N>,
    parts: &[NodeId],
    greatest: &mut Vec<Truth<N>>,
) -> Result<Truth<N>, EvalError> {
    greatest.clear();
    for part in parts {
        let mut next = truth(values[part.0 as usize]?);
        for kept in greatest.iter_mut() {
            (*kept, next) = (kept.or(next), kept.and(next));
        }
        if greatest.len() < n {
            greatest.push(next);
        }
    }
    let verdicts = parts.iter().filter_map(|part| values[part.0 as usize].ok()).map(|value| truth(value).holds);
    let holds = N::Verdict::at_least(n, verdicts);
    let nth = if n == 0 { Some(Truth::discrete(true)) } else { greatest.get(n - 1).copied() };
    Ok(nth.map_or(Truth::discrete(false), |t| Truth { holds, ..t }))
}

/// Of a connective the part that its margin comes from; `None` for what decides by itself.
pub(super) fn deciding_child<N: Number>(node: &Node, id: NodeId, values: &Values<N>) -> Option<NodeId> {
    let of = |n: NodeId| match values[n.0 as usize] {
        Ok(Value::Truth(t)) => Some(t.plain()),
        _ => None,
    };
    let extreme = |parts: &[NodeId], sign: f64| {
        let whole = of(id)?;
        // Among the parts of the same verdict, so that a failure is explained by what fails.
        parts
            .iter()
            .filter_map(|&p| of(p).filter(|t| t.holds == whole.holds).map(|t| (p, sign * t.margin)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .map(|(p, _)| p)
    };
    match node {
        Node::And(parts) => extreme(parts, 1.0),
        Node::Or(parts) => extreme(parts, -1.0),
        Node::Not(part) => Some(*part),
        Node::AtLeast(_, parts) => {
            let margin = of(id)?.margin;
            parts.iter().copied().find(|&p| of(p).is_some_and(|t| t.margin == margin))
        }
        _ => None,
    }
}
