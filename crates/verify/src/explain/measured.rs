//! The values on both sides of what decided a row.

use crate::builtins::{Call, declared};
use crate::eval::{Scratch, Value};
use crate::report::model::RowKind;
use crate::rules::support::Rest;
use crate::world::World;
use scenelang_lang::program::{Formula, Node, NodeId, Unit};

/// Both sides of a comparison. Of a rule or a built-in predicate the left side is what was measured, the right one what
/// it may be at worst.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// What was found.
    pub left: Quantity,
    /// What it was compared with.
    pub right: Quantity,
    /// Metres (and plain numbers) or degrees.
    pub unit: Unit,
}

/// A number, or the three of a vector or a rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    /// One number; infinite where there is no way to walk.
    Number(f64),
    /// Three.
    Triple([f64; 3]),
}

/// What decided a formula, as last evaluated.
pub(crate) fn of_statement(
    world: &World<f64>,
    formula: &Formula,
    scratch: &Scratch<f64>,
    deciding: NodeId,
) -> Option<Measured> {
    let quantity = |id: NodeId| match scratch.get(id).ok()? {
        Value::Number(n) => Some(Quantity::Number(n + 0.0)),
        Value::Vector(v) | Value::Rotation(v) => Some(Quantity::Triple(v.0.map(|c| c + 0.0))),
        Value::Truth(_) => None,
    };
    match formula.node(deciding) {
        Node::Compare(_, unit, a, b) => Some(Measured { left: quantity(*a)?, right: quantity(*b)?, unit: *unit }),
        Node::Same(a, b) => {
            let unit = if matches!(scratch.get(*a), Ok(Value::Rotation(_))) { Unit::Degree } else { Unit::Metre };
            Some(Measured { left: quantity(*a)?, right: quantity(*b)?, unit })
        }
        Node::BuiltIn(built_in, args) => {
            let call = Call { built_in: *built_in, args, values: scratch.values(), world, node: deciding };
            let (left, right) = call.measured()?;
            Some(Measured { unit: declared(*built_in).unit, ..metres(left, right) })
        }
        _ => None,
    }
}

/// What decided a physical rule; `rest`: how the object of P-SUPPORT rests.
pub(crate) fn of_rule(world: &World<f64>, kind: RowKind, margin: f64, rest: Option<&Rest>) -> Option<Measured> {
    let tolerances = &world.options.tolerances;
    match (kind, rest) {
        (RowKind::Support, rest) => rest.map(|rest| match rest.off {
            // It touches, and does not balance: how far its centre is beyond what carries it.
            Some(off) => metres(off, tolerances.contact),
            None => metres(rest.lowest, rest.nearest),
        }),
        _ if margin.is_finite() => Some(metres(margin - tolerances.contact, -tolerances.contact)),
        _ => None,
    }
}

fn metres(left: f64, right: f64) -> Measured {
    Measured { left: Quantity::Number(left + 0.0), right: Quantity::Number(right + 0.0), unit: Unit::Metre }
}
