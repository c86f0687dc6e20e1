//! What can be read of objects and regions.

use super::Values;
use super::arithmetic::triple;
use super::value::{Cause, EvalError, Truth, Value};
use crate::number::{Algebra, Number};
use crate::vector::V3;
use crate::world::World;
use scenelang_lang::program::{NodeId, ObjectId, ObjectProperty, RegionId, RegionProperty};
use scenelang_layout::Vec3;

/// A property of an object that needs no geometry; the surface is in [`surface`].
pub(super) fn of_object<N: Algebra>(
    world: &World<N>,
    property: ObjectProperty,
    object: ObjectId,
) -> Result<Value<N>, Cause> {
    let thing = world.object(object)?;
    Ok(match property {
        ObjectProperty::Pos => Value::Vector(thing.pos),
        ObjectProperty::Rot => Value::Rotation(thing.rot),
        ObjectProperty::Scale => Value::Vector(thing.scale),
        ObjectProperty::Center => Value::Vector(thing.center()),
        ObjectProperty::Top | ObjectProperty::Surface => Value::Number((thing.center() + thing.reach()).0[1]),
        ObjectProperty::Bottom => Value::Number((thing.center() - thing.reach()).0[1]),
        ObjectProperty::Right => Value::Vector(thing.axes.0[0]),
        ObjectProperty::Up => Value::Vector(thing.axes.0[1]),
        ObjectProperty::Front => Value::Vector(thing.axes.0[2]),
        ObjectProperty::Min => Value::Vector(thing.center() - thing.reach()),
        ObjectProperty::Max => Value::Vector(thing.center() + thing.reach()),
    })
}

/// The height of the support surface of an object: the declared one, else the top.
pub(super) fn surface<N: Number>(world: &World<N>, object: ObjectId) -> Result<Value<N>, Cause> {
    let thing = world.object(object)?;
    match thing.body.surface {
        Some(height) => Ok(Value::Number((thing.pos + thing.axes.turn_constant(&Vec3::new(0.0, height, 0.0))).0[1])),
        None => of_object(world, ObjectProperty::Top, object),
    }
}

/// A property of a region, taken as a rectangle.
pub(crate) fn of_region<N: Algebra>(
    world: &World<N>,
    property: RegionProperty,
    region: RegionId,
) -> Result<Value<N>, Cause> {
    let room = world.region(region)?;
    let ceiling = room.pos.0[1] + room.scale.0[1];
    Ok(match property {
        RegionProperty::Pos => Value::Vector(room.pos),
        RegionProperty::Rot => Value::Rotation(room.rot),
        RegionProperty::Scale => Value::Vector(room.scale),
        RegionProperty::Floor => Value::Number(room.pos.0[1]),
        RegionProperty::Ceiling => Value::Number(ceiling),
        RegionProperty::Area => Value::Number(room.scale.0[0] * room.scale.0[2]),
        RegionProperty::Center => {
            Value::Vector(V3([room.pos.0[0], (room.pos.0[1] + ceiling).scale(0.5), room.pos.0[2]]))
        }
    })
}

/// The same, of the outline that it has.
pub(crate) fn of_outline<N: Number>(
    world: &World<N>,
    property: RegionProperty,
    region: RegionId,
) -> Result<Value<N>, Cause> {
    let room = world.region(region)?;
    let rectangle = of_region(world, property, region)?;
    Ok(match (property, rectangle) {
        (RegionProperty::Area, _) if room.outlined => Value::Number(N::constant(room.prism.area())),
        (RegionProperty::Center, Value::Vector(center)) if room.outlined => {
            let c = room.prism.center();
            Value::Vector(V3([N::constant(c.x), center.0[1], N::constant(c.z)]))
        }
        _ => rectangle,
    })
}

/// Whether a region's outline is the polygon given, up to start vertex and winding.
pub(super) fn same_polygon<N: Number>(
    world: &World<N>,
    region: RegionId,
    values: &Values<N>,
    vertices: &[NodeId],
    node: NodeId,
) -> Result<Truth<N>, EvalError> {
    let room = world.region(region).map_err(|cause| EvalError { cause, node })?;
    let zero = N::constant(0.0);
    let flat = |id: &NodeId| values[id.0 as usize].map(|v| V3([triple(v).0[0], zero, triple(v).0[2]]));
    let mut given = vertices.iter().map(flat).collect::<Result<Vec<V3<N>>, EvalError>>()?;
    if given.len() > 1 && given.first().map(V3::value) == given.last().map(V3::value) {
        given.pop();
    }
    let corners = room.prism.polygon.corners();
    let n = corners.len();
    if given.len() != n {
        return Ok(Truth::discrete(false));
    }
    let there: Vec<V3<N>> = corners
        .iter()
        .map(|c| {
            let [x, z] = room.attached(c.x, c.y);
            V3([x, zero, z])
        })
        .collect();
    let apart = |start: usize, step: usize| {
        let distance = |i: usize| (there[i] - given[(start + step * i) % n]).length();
        (1..n).fold(distance(0), |worst, i| worst.max(distance(i)))
    };
    // Every start, in either winding.
    let least =
        (0..n).flat_map(|start| [apart(start, 1), apart(start, n - 1)]).fold(N::constant(f64::INFINITY), N::min);
    let tolerance = world.options.tolerances.equal;
    Ok(Truth::metres(N::constant(tolerance) - least, 1e-12))
}
