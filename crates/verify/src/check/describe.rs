//! Formulas and measurements in words: what was compared, and what was found.

use super::wording::Compared;
use crate::builtins::{Call, declared};
use crate::eval::{Scratch, Value};
use crate::explain;
use crate::world::World;
use scenelang_base::Label;
use scenelang_lang::program::{
    Arg, Arith, Axis, Comparison, Constraint, Formula, Function, Node, NodeId, ObjectId, ObjectProperty, Program,
    RegionProperty, Unit,
};
use scenelang_layout::Vec3;

/// Longer than this a formula says less than its value.
const LONGEST: usize = 60;

/// What decided a formula, in a sentence; `holds` is the verdict of the whole.
pub(super) fn measured(
    program: &Program,
    world: &World<f64>,
    constraint: &Constraint,
    scratch: &Scratch<f64>,
    deciding: NodeId,
    holds: bool,
) -> String {
    let formula = &constraint.formula;
    let get = |id: NodeId| scratch.get(id).ok();
    match formula.node(deciding) {
        Node::Compare(op, unit, a, b) => {
            let truth = get(deciding).is_some_and(|v| matches!(v, Value::Truth(t) if t.holds));
            // Under a `not` the comparison decides by its contrary.
            let op = if truth == holds { *op } else { contrary(*op) };
            if let (Some(Value::Number(left)), Some(Value::Number(right))) = (get(*a), get(*b))
                && let Ok(at) = constraint.wordings.binary_search_by_key(&deciding.0, |w| w.node.0)
            {
                let compared = Compared { op, unit: *unit, left, right, holds };
                return compared.by(&constraint.wordings[at], program, scratch);
            }
            if let Some(said) = measure(program, world, formula, scratch, op, [*a, *b], holds) {
                return said;
            }
            let side = |id: NodeId| match get(id) {
                Some(Value::Number(n)) => number(n, *unit),
                _ => "unknown".to_owned(),
            };
            let left = match text(program, formula, *a) {
                Some(text) => format!("`{text}` is {}", side(*a)),
                None => format!("the left side is {}", side(*a)),
            };
            let right = match (formula.node(*b), text(program, formula, *b)) {
                (Node::Number(_), _) => side(*b),
                (_, Some(text)) => format!("`{text}`, which is {}", side(*b)),
                _ => format!("the right side, which is {}", side(*b)),
            };
            let must = if holds { "" } else { "but must be " };
            format!("{left}, {must}{} {right}", relation(op))
        }
        Node::Same(a, b) => {
            let side = |id: NodeId| match get(id) {
                Some(Value::Vector(v) | Value::Rotation(v)) => triple(&v.value()),
                _ => "unknown".to_owned(),
            };
            let what = text(program, formula, *a).map_or("the left side".to_owned(), |t| format!("`{t}`"));
            let truth = get(deciding).is_some_and(|v| matches!(v, Value::Truth(t) if t.holds));
            // Under a `not` the two must differ.
            let must = match (holds, truth == holds) {
                (true, true) => "equal to",
                (true, false) => "different from",
                (false, true) => "but must be",
                (false, false) => "but must be different from",
            };
            format!("{what} is {}, {must} {}", side(*a), side(*b))
        }
        Node::BuiltIn(built_in, args) => {
            let values = scratch.values();
            let call = Call { built_in: *built_in, args, values, world, node: deciding };
            call.words(program).unwrap_or_default()
        }
        Node::SamePolygon(region, _) => {
            format!("the outline of `{}` is a different polygon", program.regions[region.0 as usize].name)
        }
        _ => String::new(),
    }
}

/// The comparison of a measure with a number that is written in the formula.
fn measure(
    program: &Program,
    world: &World<f64>,
    formula: &Formula,
    scratch: &Scratch<f64>,
    op: Comparison,
    [left, right]: [NodeId; 2],
    holds: bool,
) -> Option<String> {
    let (Node::BuiltIn(built_in, args), Node::Number(limit)) = (formula.node(left), formula.node(right)) else {
        return None;
    };
    let Ok(Value::Number(value)) = scratch.get(left) else { return None };
    let call = Call { built_in: *built_in, args, values: scratch.values(), world, node: left };
    let (noun, unit) = (call.words(program)?, declared(*built_in).unit);
    // What has no length is not there.
    if value.is_infinite()
        && !holds
        && matches!(op, Comparison::Lt | Comparison::Le)
        && let Some(path) = noun.strip_prefix("the shortest ")
    {
        let limit = with_unit(*limit, unit);
        return Some(format!("there is no {path}, but there must be one of {} {limit}", relation(op)));
    }
    let must = if holds { "" } else { "but must be " };
    let (value, limit) = (with_unit(value, unit), with_unit(*limit, unit));
    Some(format!("{noun} is {value}, {must}{} {limit}", relation(op)))
}

/// Declarations of objects, with where these are.
pub(super) fn declarations(program: &Program, world: &World<f64>, objects: &[ObjectId]) -> Vec<Label> {
    const MOST: usize = 4;
    let label = |&id: &ObjectId| {
        let object = &program.objects[id.0 as usize];
        Some(Label { place: object.span, message: explain::ObjectPlace::of(program, world, id)?.text })
    };
    objects.iter().take(MOST).filter_map(label).collect()
}

/// A number as people read it, with its unit.
pub(crate) fn number(n: f64, unit: Unit) -> String {
    let digits = rounded(n);
    match unit {
        // Plain numbers count as metres, and have no unit to show.
        Unit::Metre => digits,
        Unit::Degree => format!("{digits}°"),
    }
}

/// A number with its unit, where it is known to be a length or an angle.
pub(super) fn with_unit(n: f64, unit: Unit) -> String {
    match unit {
        Unit::Metre if n.is_finite() => format!("{} m", rounded(n)),
        _ => number(n, unit),
    }
}

/// Four digits after the point at most.
pub(super) fn rounded(n: f64) -> String {
    if n.is_infinite() {
        return if n > 0.0 { "infinite" } else { "minus infinite" }.to_owned();
    }
    // Cut first and written in full then, which is much faster than writing four digits exactly.
    let cut = if n.abs() < 1e11 { (n * 1e4).round() / 1e4 } else { n };
    if cut == 0.0 { "0".to_owned() } else { cut.to_string() }
}

fn triple(v: &Vec3) -> String {
    format!("({}, {}, {})", rounded(v.x), rounded(v.y), rounded(v.z))
}

pub(super) fn relation(op: Comparison) -> &'static str {
    match op {
        Comparison::Eq => "equal to",
        Comparison::Ne => "different from",
        Comparison::Lt => "less than",
        Comparison::Le => "at most",
        Comparison::Gt => "more than",
        Comparison::Ge => "at least",
    }
}

fn contrary(op: Comparison) -> Comparison {
    match op {
        Comparison::Eq => Comparison::Ne,
        Comparison::Ne => Comparison::Eq,
        Comparison::Lt => Comparison::Ge,
        Comparison::Le => Comparison::Gt,
        Comparison::Gt => Comparison::Le,
        Comparison::Ge => Comparison::Lt,
    }
}

/// A value of a formula as it could be written, if that is short.
fn text(program: &Program, formula: &Formula, id: NodeId) -> Option<String> {
    let mut out = String::new();
    write(program, formula, id, &mut out)?;
    Some(out)
}

/// Writes a node; `None`: too long, or not to be written.
fn write(program: &Program, formula: &Formula, id: NodeId, out: &mut String) -> Option<()> {
    let object = |id: &ObjectId| program.objects[id.0 as usize].name.as_str();
    let list = |ids: &[NodeId], out: &mut String| -> Option<()> {
        for (i, id) in ids.iter().enumerate() {
            out.push_str(if i > 0 { ", " } else { "" });
            write(program, formula, *id, out)?;
        }
        Some(())
    };
    match formula.node(id) {
        Node::Number(n) => out.push_str(&rounded(*n)),
        Node::Object(property, id) => {
            out.push_str(&format!("{}.{}", object(id), of_object(*property)));
        }
        Node::Region(property, id) => {
            out.push_str(&format!("{}.{}", program.regions[id.0 as usize].name, of_region(*property)));
        }
        Node::Variable(id) => out.push_str(&program.variables[id.0 as usize].name),
        Node::Vector(parts) | Node::Rotation(parts) => {
            let vector = matches!(formula.node(id), Node::Vector(_));
            out.push_str(if vector { "vec3(" } else { "rot(" });
            list(parts, out)?;
            out.push(')');
        }
        Node::Neg(a) => {
            out.push('-');
            operand(program, formula, *a, out)?;
        }
        Node::Arith(op, a, b) => {
            operand(program, formula, *a, out)?;
            out.push_str(match op {
                Arith::Add => " + ",
                Arith::Sub => " - ",
                Arith::Mul => " * ",
                Arith::Div => " / ",
            });
            operand(program, formula, *b, out)?;
        }
        Node::Component(axis, a) => {
            operand(program, formula, *a, out)?;
            out.push_str(match axis {
                Axis::X => ".x",
                Axis::Y => ".y",
                Axis::Z => ".z",
            });
        }
        Node::Call(function, args) => {
            out.push_str(called(*function));
            out.push('(');
            list(args, out)?;
            out.push(')');
        }
        Node::BuiltIn(built_in, args) => {
            out.push_str(built_in.name());
            out.push('(');
            for (i, arg) in args.iter().enumerate() {
                out.push_str(if i > 0 { ", " } else { "" });
                match arg {
                    Arg::Object(id) => out.push_str(object(id)),
                    Arg::Region(id) => out.push_str(&program.regions[id.0 as usize].name),
                    Arg::Value(node) => write(program, formula, *node, out)?,
                    Arg::Side(_) => return None,
                }
            }
            out.push(')');
        }
        _ => return None,
    }
    (out.len() <= LONGEST).then_some(())
}

/// A property of an object as it is written.
fn of_object(property: ObjectProperty) -> &'static str {
    match property {
        ObjectProperty::Pos => "pos",
        ObjectProperty::Rot => "rot",
        ObjectProperty::Scale => "scale",
        ObjectProperty::Center => "center",
        ObjectProperty::Top => "top",
        ObjectProperty::Bottom => "bottom",
        ObjectProperty::Surface => "surface",
        ObjectProperty::Front => "front",
        ObjectProperty::Right => "right",
        ObjectProperty::Up => "up",
        ObjectProperty::Min => "min",
        ObjectProperty::Max => "max",
    }
}

/// A property of a region as it is written.
fn of_region(property: RegionProperty) -> &'static str {
    match property {
        RegionProperty::Pos => "pos",
        RegionProperty::Rot => "rot",
        RegionProperty::Scale => "scale",
        RegionProperty::Floor => "floor",
        RegionProperty::Ceiling => "ceiling",
        RegionProperty::Area => "area",
        RegionProperty::Center => "center",
    }
}

/// A function as it is written.
fn called(function: Function) -> &'static str {
    match function {
        Function::Abs => "abs",
        Function::Min => "min",
        Function::Max => "max",
        Function::Sqrt => "sqrt",
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Length => "length",
        Function::Normalize => "normalize",
        Function::Cross => "cross",
        Function::Dot => "dot",
        Function::Angle => "angle",
        Function::Distance => "distance",
    }
}

/// A node as an operand: in brackets where it has operators of its own.
fn operand(program: &Program, formula: &Formula, id: NodeId, out: &mut String) -> Option<()> {
    let bare = !matches!(formula.node(id), Node::Arith(..) | Node::Neg(_));
    out.push_str(if bare { "" } else { "(" });
    write(program, formula, id, out)?;
    out.push_str(if bare { "" } else { ")" });
    Some(())
}
