//! Numbers, vectors and rotations: arithmetic, components, functions.
//!
//! Nothing infinite or undefined comes out of finite numbers: that is an error. The one infinity that may come in is a
//! walk for which there is no way.

use super::Values;
use super::value::{Cause, EvalError, Value};
use crate::number::Algebra;
use crate::vector::{M3, V3};
use scenelang_lang::program::{Arith, Axis, Function, NodeId};

/// Formulas are typed by the front end; a value of another kind is a mistake there.
#[track_caller]
fn ill_typed<N: Algebra>(value: Value<N>) -> ! {
    unreachable!("a formula of the wrong types: {value:?}")
}

pub(super) fn number<N: Algebra>(value: Value<N>) -> N {
    match value {
        Value::Number(n) => n,
        other => ill_typed(other),
    }
}

/// Three numbers, as they are.
pub(super) fn triple<N: Algebra>(value: Value<N>) -> V3<N> {
    match value {
        Value::Vector(v) | Value::Rotation(v) => v,
        other => ill_typed(other),
    }
}

/// A vector from the nodes of its components.
pub(super) fn vector<N: Algebra>(values: &Values<N>, parts: &[NodeId; 3]) -> Result<V3<N>, EvalError> {
    let get = |i: usize| values[parts[i].0 as usize].map(number);
    Ok(V3([get(0)?, get(1)?, get(2)?]))
}

/// Minus a number or a vector.
pub(super) fn negate<N: Algebra>(value: Value<N>) -> Value<N> {
    match value {
        Value::Number(n) => Value::Number(-n),
        other => Value::Vector(-triple(other)),
    }
}

/// `+ - * /`.
pub(super) fn combine<N: Algebra>(op: Arith, a: Value<N>, b: Value<N>) -> Result<Value<N>, Cause> {
    match (op, a, b) {
        (Arith::Div, _, Value::Number(d)) if d.known() == Some(0.0) => Err(Cause::DivisionByZero),
        (_, Value::Number(x), Value::Number(y)) => {
            let result = match op {
                Arith::Add => x + y,
                Arith::Sub => x - y,
                Arith::Mul => x * y,
                Arith::Div => x / y,
            };
            checked(result, [x, y].into_iter().filter_map(N::known).any(f64::is_infinite)).map(Value::Number)
        }
        (Arith::Add, Value::Vector(x), Value::Vector(y)) => finite(x + y),
        (Arith::Sub, Value::Vector(x), Value::Vector(y)) => finite(x - y),
        (Arith::Mul, Value::Vector(v), Value::Number(f)) | (Arith::Mul, Value::Number(f), Value::Vector(v)) => {
            finite(v.times(f))
        }
        (Arith::Div, Value::Vector(v), Value::Number(d)) => finite(v.map(|c| c / d)),
        (_, other, _) => ill_typed(other),
    }
}

fn checked<N: Algebra>(result: N, may_be_infinite: bool) -> Result<N, Cause> {
    let fine = result.known().is_none_or(|value| value.is_finite() || may_be_infinite && !value.is_nan());
    if fine { Ok(result) } else { Err(Cause::NotFinite) }
}

fn finite<N: Algebra>(v: V3<N>) -> Result<Value<N>, Cause> {
    for c in v.0 {
        checked(c, false)?;
    }
    Ok(Value::Vector(v))
}

/// x, y or z; of a rotation in [0, 360).
pub(super) fn component<N: Algebra>(axis: Axis, value: Value<N>) -> Value<N> {
    let c = triple(value).0[axis as usize];
    Value::Number(if matches!(value, Value::Rotation(_)) { c.wrap() } else { c })
}

/// A function of numbers, vectors or rotations.
pub(super) fn call<N: Algebra>(
    function: Function,
    values: &Values<N>,
    args: &[NodeId],
    fail: impl Fn(Cause) -> EvalError,
) -> Result<Value<N>, EvalError> {
    let get = |i: usize| values[args[i].0 as usize];
    let fold = |f: fn(N, N) -> N| {
        let first = get(0).map(number)?;
        (1..args.len()).try_fold(first, |best, i| Ok(f(best, get(i).map(number)?)))
    };
    let check = |n: N| checked(n, false).map(Value::Number).map_err(&fail);
    match function {
        Function::Abs => Ok(Value::Number(number(get(0)?).abs())),
        Function::Min => fold(N::min).map(Value::Number),
        Function::Max => fold(N::max).map(Value::Number),
        Function::Sqrt => {
            let x = number(get(0)?);
            if x.known().is_some_and(|value| value < 0.0) {
                Err(fail(Cause::NegativeRoot))
            } else {
                Ok(Value::Number(x.sqrt()))
            }
        }
        Function::Sin => check(number(get(0)?).sin()),
        Function::Cos => check(number(get(0)?).cos()),
        Function::Length => check(triple(get(0)?).length()),
        Function::Normalize => {
            let v = triple(get(0)?);
            let length = v.length();
            if length.known() == Some(0.0) {
                return Err(fail(Cause::ZeroVector));
            }
            finite(v.map(|c| c / length)).map_err(fail)
        }
        Function::Cross => finite(triple(get(0)?).cross(triple(get(1)?))).map_err(fail),
        Function::Dot => check(triple(get(0)?).dot(triple(get(1)?))),
        Function::Distance => check((triple(get(0)?) - triple(get(1)?)).length()),
        Function::Angle => match (get(0)?, get(1)?) {
            (Value::Rotation(a), Value::Rotation(b)) => Ok(Value::Number(M3::rotation(a).angle(&M3::rotation(b)))),
            (a, b) => {
                let (a, b) = (triple(a), triple(b));
                if a.length().known() == Some(0.0) || b.length().known() == Some(0.0) {
                    return Err(fail(Cause::ZeroVector));
                }
                check(a.angle(b))
            }
        },
    }
}
