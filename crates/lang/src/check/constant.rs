//! Arithmetic of literals: what can be computed without a layout is checked without one.
//!
//! Only literals, operators and functions of such; names are not followed.

use crate::ast::{BinaryOp, ExprId, ExprKind, Stmt, UnitSuffix};
use scenelang_base::{Code, codes};

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Constant {
    /// A number, in metres or degrees where it has a unit.
    Number(f64),
    Vector([f64; 3]),
}

/// Why an expression of constants has no value.
#[derive(Clone, Debug, PartialEq)]
pub struct NoValue {
    pub code: Code,
    /// The sentence.
    pub message: String,
}

fn no(code: Code, message: impl Into<String>) -> NoValue {
    NoValue { code, message: message.into() }
}

/// The value of a literal with its unit: metres or degrees.
pub fn with_unit(value: f64, unit: Option<UnitSuffix>) -> f64 {
    match unit {
        None | Some(UnitSuffix::M | UnitSuffix::Deg) => value,
        Some(UnitSuffix::Cm) => value / 100.0,
        Some(UnitSuffix::Mm) => value / 1000.0,
        Some(UnitSuffix::Ft) => value * 0.3048,
        Some(UnitSuffix::In) => value * 0.0254,
        Some(UnitSuffix::Rad) => value.to_degrees(),
    }
}

/// The number an expression of literals stands for; `None` if it is not constant, no number, or has no value.
pub fn number(stmt: &Stmt, id: ExprId) -> Option<f64> {
    match evaluate(stmt, id, &|_| None) {
        Ok(Some(Constant::Number(x))) => Some(x),
        _ => None,
    }
}

/// Evaluates an expression whose operands are known (`known` is asked first, so that a caller that walks bottom up
/// need not recompute). `Ok(None)`: not constant.
///
/// # Errors
/// The operation at the top has no value although its operands have.
pub fn evaluate(
    stmt: &Stmt,
    id: ExprId,
    known: &dyn Fn(ExprId) -> Option<Constant>,
) -> Result<Option<Constant>, NoValue> {
    let value = |e: ExprId| match known(e) {
        Some(c) => Ok(Some(c)),
        None => stacker::maybe_grow(64 << 10, 1 << 20, || evaluate(stmt, e, known)),
    };
    let result = match &stmt.expr(id).kind {
        ExprKind::Number(x, unit) => Constant::Number(with_unit(*x, *unit)),
        ExprKind::Neg(e) => match value(*e)? {
            Some(Constant::Number(x)) => Constant::Number(-x),
            Some(Constant::Vector(v)) => Constant::Vector(v.map(|x| -x)),
            None => return Ok(None),
        },
        ExprKind::Binary(op, _, l, r) => match (value(*l)?, value(*r)?) {
            (Some(l), Some(r)) => match arith(*op, l, r)? {
                Some(c) => c,
                None => return Ok(None),
            },
            _ => return Ok(None),
        },
        ExprKind::Call(name, args) => {
            let mut values = Vec::with_capacity(args.len());
            for a in args {
                match value(*a)? {
                    Some(v) => values.push(v),
                    None => return Ok(None),
                }
            }
            match call(&name.text, &values)? {
                Some(c) => c,
                None => return Ok(None),
            }
        }
        _ => return Ok(None),
    };
    let finite = match result {
        Constant::Number(x) => x.is_finite(),
        Constant::Vector(v) => v.iter().all(|x| x.is_finite()),
    };
    if finite { Ok(Some(result)) } else { Err(no(codes::E0607, "the result is too large for a number")) }
}

fn arith(op: BinaryOp, l: Constant, r: Constant) -> Result<Option<Constant>, NoValue> {
    use Constant::{Number as N, Vector as V};
    let zip = |a: [f64; 3], b: [f64; 3], f: fn(f64, f64) -> f64| V([f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])]);
    if op == BinaryOp::Div && r == N(0.0) {
        return Err(no(codes::E0601, "division by zero"));
    }
    Ok(Some(match (op, l, r) {
        (BinaryOp::Add, N(a), N(b)) => N(a + b),
        (BinaryOp::Sub, N(a), N(b)) => N(a - b),
        (BinaryOp::Mul, N(a), N(b)) => N(a * b),
        (BinaryOp::Div, N(a), N(b)) => N(a / b),
        (BinaryOp::Add, V(a), V(b)) => zip(a, b, |x, y| x + y),
        (BinaryOp::Sub, V(a), V(b)) => zip(a, b, |x, y| x - y),
        (BinaryOp::Mul, V(a), N(b)) | (BinaryOp::Mul, N(b), V(a)) => V(a.map(|x| x * b)),
        (BinaryOp::Div, V(a), N(b)) => V(a.map(|x| x / b)),
        _ => return Ok(None),
    }))
}

fn call(name: &str, args: &[Constant]) -> Result<Option<Constant>, NoValue> {
    use Constant::{Number as N, Vector as V};
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let numbers = || args.iter().map(|a| if let N(x) = a { Some(*x) } else { None }).collect::<Option<Vec<f64>>>();
    Ok(Some(match (name, args) {
        ("vec3", [N(x), N(y), N(z)]) => V([*x, *y, *z]),
        ("abs", [N(x)]) => N(x.abs()),
        ("min" | "max", [N(_), N(_), ..]) => match numbers() {
            Some(xs) if name == "min" => N(xs.into_iter().fold(f64::INFINITY, f64::min)),
            Some(xs) => N(xs.into_iter().fold(f64::NEG_INFINITY, f64::max)),
            None => return Ok(None),
        },
        ("sqrt", [N(x)]) if *x < 0.0 => return Err(no(codes::E0602, format!("{x} has no real square root"))),
        ("sqrt", [N(x)]) => N(x.sqrt()),
        ("sin", [N(x)]) => N(x.to_radians().sin()),
        ("cos", [N(x)]) => N(x.to_radians().cos()),
        ("length", [V(v)]) => N(dot(*v, *v).sqrt()),
        ("dot", [V(a), V(b)]) => N(dot(*a, *b)),
        ("normalize", [V(v)]) => {
            let length = dot(*v, *v).sqrt();
            if length == 0.0 {
                return Err(no(codes::E0606, "the zero vector has no direction"));
            }
            V(v.map(|x| x / length))
        }
        ("angle", [V(a), V(b)]) if dot(*a, *a) == 0.0 || dot(*b, *b) == 0.0 => {
            return Err(no(codes::E0606, "the zero vector has no direction, so it forms no angle"));
        }
        ("rand", [N(lo), N(hi)]) if lo > hi => {
            return Err(no(codes::E0603, format!("`rand` draws from lo to hi, but {lo} is greater than {hi}")));
        }
        _ => return Ok(None),
    }))
}
