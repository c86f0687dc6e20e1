//! What can be read of objects and regions.

use super::Values;
use super::arithmetic::triple;
use super::value::{Cause, EvalError, Truth, Value};
use crate::number::Number;
use crate::vector::V3;
use crate::world::World;
use scenelang_lang::program::{NodeId, ObjectId, ObjectProperty, RegionId, RegionProperty};
use scenelang_layout::Vec3;

/// A property of an object.
pub(super) fn of_object<N: Number>(
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
        ObjectProperty::Top => Value::Number(top(thing.center(), thing.reach())),
        ObjectProperty::Bottom => Value::Number((thing.center() - thing.reach()).0[1]),
        ObjectProperty::Surface => Value::Number(match thing.body.surface {
            Some(height) => (thing.pos + thing.axes.turn_constant(&Vec3::new(0.0, height, 0.0))).0[1],
            None => top(thing.center(), thing.reach()),
        }),
        ObjectProperty::Right => Value::Vector(thing.axes.0[0]),
        ObjectProperty::Up => Value::Vector(thing.axes.0[1]),
        ObjectProperty::Front => Value::Vector(thing.axes.0[2]),
        ObjectProperty::Min => Value::Vector(thing.center() - thing.reach()),
        ObjectProperty::Max => Value::Vector(thing.center() + thing.reach()),
    })
}

fn top<N: Number>(center: V3<N>, reach: V3<N>) -> N {
    center.0[1] + reach.0[1]
}

/// A property of a region.
pub(super) fn of_region<N: Number>(
    world: &World<N>,
    property: RegionProperty,
    region: RegionId,
) -> Result<Value<N>, Cause> {
    let room = world.region(region)?;
    let height = room.pos.0[1] + room.scale.0[1];
    Ok(match property {
        RegionProperty::Pos => Value::Vector(room.pos),
        RegionProperty::Rot => Value::Rotation(room.rot),
        RegionProperty::Scale => Value::Vector(room.scale),
        RegionProperty::Floor => Value::Number(room.pos.0[1]),
        RegionProperty::Ceiling => Value::Number(height),
        RegionProperty::Area => Value::Number(if room.outlined {
            N::constant(room.prism.area())
        } else {
            room.scale.0[0] * room.scale.0[2]
        }),
        RegionProperty::Center => {
            let middle = (room.pos.0[1] + height).scale(0.5);
            Value::Vector(if room.outlined {
                let c = room.prism.center();
                V3([N::constant(c.x), middle, N::constant(c.z)])
            } else {
                V3([room.pos.0[0], middle, room.pos.0[2]])
            })
        }
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
