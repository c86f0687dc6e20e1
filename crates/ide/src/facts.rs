//! What is known of a thing in the current layout, in words.

use crate::Snapshot;
use scenelang_base::TextRange;
use scenelang_lang::program::{Formula, Node, NodeId, ObjectId, ObjectProperty, Program, RegionId, RegionProperty};
use scenelang_layout::{DecisionValue, Layout, Vec3};
use scenelang_verify::{Value, World, evaluate};

/// The value of a property of an object in the layout, as it could be written.
pub(crate) fn of_object(
    snapshot: &Snapshot,
    program: &Program,
    layout: &Layout,
    id: ObjectId,
    property: &str,
) -> Option<String> {
    use ObjectProperty::*;
    let property = match property {
        "pos" => Pos,
        "rot" => Rot,
        "scale" | "size" | "dimensions" => Scale,
        "center" => Center,
        "top" => Top,
        "bottom" => Bottom,
        "surface" => Surface,
        "front" => Front,
        "right" => Right,
        "up" => Up,
        "min" => Min,
        "max" => Max,
        _ => return None,
    };
    value(snapshot, program, layout, Node::Object(property, id))
}

/// The same of a region.
pub(crate) fn of_region(
    snapshot: &Snapshot,
    program: &Program,
    layout: &Layout,
    id: RegionId,
    property: &str,
) -> Option<String> {
    use RegionProperty::*;
    let property = match property {
        "pos" => Pos,
        "rot" => Rot,
        "scale" => Scale,
        "floor" => Floor,
        "ceiling" => Ceiling,
        "area" => Area,
        "center" => Center,
        _ => return None,
    };
    value(snapshot, program, layout, Node::Region(property, id))
}

fn value(snapshot: &Snapshot, program: &Program, layout: &Layout, node: Node) -> Option<String> {
    let world = World::new(program, layout, &snapshot.judging().options);
    let formula = Formula { nodes: vec![node], ranges: vec![TextRange::empty(0)], root: NodeId(0) };
    match evaluate(&formula, &world).ok()? {
        Value::Number(n) => Some(short(n)),
        Value::Vector(v) => Some(format!("vec3({})", triple(v.value()))),
        Value::Rotation(v) => Some(format!("rot({})", triple(v.value()))),
        Value::Truth(_) => None,
    }
}

/// The value of a decision variable.
pub(crate) fn of_variable(layout: &Layout, name: &str) -> Option<String> {
    let (_, value) = layout.variables.iter().find(|(n, _)| n == name)?;
    Some(match value {
        DecisionValue::Number(n) => short(*n),
        DecisionValue::Bool(b) => b.to_string(),
        DecisionValue::Triple(t) => format!("({})", triple(Vec3::from(*t))),
    })
}

/// Extents: `1.60 × 1.00 × 2.10 m`.
pub(crate) fn size(scale: &Vec3) -> String {
    format!("{:.2} × {:.2} × {:.2} m", scale.x, scale.y, scale.z)
}

pub(crate) fn triple(v: Vec3) -> String {
    format!("{}, {}, {}", short(v.x), short(v.y), short(v.z))
}

/// To three digits after the point.
pub(crate) fn short(x: f64) -> String {
    let rounded = (x * 1000.0).round() / 1000.0 + 0.0;
    rounded.to_string()
}
