//! Recorded draws: in their bounds, and the bounds the right way round. One that is not is refused, once.

use crate::eval::{Cause, EvalError, Value, evaluate};
use crate::world::World;
use scenelang_base::{Diagnostic, codes};
use scenelang_lang::program::{Draw, DrawId, Formula, Program};
use scenelang_layout::Places;

/// How far outside its bounds a draw may be, for the rounding of a file.
const ROUNDING: f64 = 1e-9;

/// Refuses the draws that are wrong, and says why.
pub fn check(program: &Program, world: &mut World<f64>, places: Option<&Places>, out: &mut Vec<Diagnostic>) {
    for (index, draw) in program.draws.iter().enumerate() {
        let id = DrawId(index as u32);
        let bound = |formula: &Formula, world: &World<f64>| match evaluate(formula, world) {
            Ok(Value::Number(n)) => Ok(n),
            Ok(_) => Err(Cause::Refused),
            Err(EvalError { cause, .. }) => Err(cause),
        };
        let bounds = bound(&draw.lo, world).and_then(|lo| Ok((lo, bound(&draw.hi, world)?)));
        let finding = match (bounds, world.draw(id)) {
            (Err(cause), _) => cause.code().map(|code| {
                Diagnostic::new(code, draw.span, format!("the bounds of this `rand` have no value: {}", code.title()))
            }),
            (Ok((lo, hi)), _) if lo > hi => {
                let say = format!("the lower bound of this `rand`, {lo}, is greater than the upper bound, {hi}");
                Some(Diagnostic::new(codes::E0603, draw.span, say))
            }
            (Ok((lo, hi)), Ok(value))
                if value < lo - ROUNDING || value > hi + ROUNDING || draw.is_choice && value.fract() != 0.0 =>
            {
                Some(outside(draw, value, lo, hi, places))
            }
            _ => continue,
        };
        world.set_draw(id, Err(Cause::Refused));
        out.extend(finding);
    }
}

fn outside(draw: &Draw, value: f64, lo: f64, hi: f64, places: Option<&Places>) -> Diagnostic {
    let message = match draw.is_choice {
        true => format!("the draw `{}` is {value}, but `oneOf` needs a whole number from {lo} to {hi}", draw.key),
        false => format!("the draw `{}` is {value}, outside its bounds {lo} to {hi}", draw.key),
    };
    match places.and_then(|places| places.draws.get(&draw.key)) {
        Some(entry) => Diagnostic::new(codes::E0505, entry.place.value, message).related(draw.span, "drawn here"),
        None => Diagnostic::new(codes::E0505, draw.span, message),
    }
}
