//! `inside(Object, Region)`: the least of three clearances of the box: from the walls, above the floor, below the
//! ceiling. `inside(Object, Object)`: the least clearance of the box's corners from the faces of the other box.

use super::{Call, Predicate, metres};
use crate::eval::{EvalError, Truth};
use crate::number::Number;
use crate::tolerances::Tolerances;
use crate::vector::V3;
use crate::world::{Room, Thing};
use scenelang_lang::program::{Arg, Program};
use scenelang_layout::inside_clearance;
use scenelang_layout::polygon::Clearance;
use nalgebra::Vector3;

/// See the file.
pub(super) struct Inside;

impl Predicate for Inside {
    fn truth<N: Number>(call: &Call<'_, N>) -> Result<Truth<N>, EvalError> {
        let tolerances = &call.world.options.tolerances;
        let (_, thing) = call.object(0)?;
        Ok(match call.args.get(1) {
            Some(Arg::Object(_)) => in_box(thing, call.object(1)?.1, tolerances),
            _ => in_region(thing, call.region(1)?.1, tolerances),
        })
    }

    fn explain(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        let (object, thing) = call.object(0).ok()?;
        let name = &names.objects[object.0 as usize].name;
        if let Some(Arg::Object(outer)) = call.args.get(1) {
            let least = thing.body.obb.clearance_in(&call.world.object(*outer).ok()?.body.obb);
            let outer = &names.objects[outer.0 as usize].name;
            return Some(if least < 0.0 {
                format!("`{name}` sticks out of `{outer}` by {}", metres(-least))
            } else {
                format!("`{name}` is {} from the nearest face of `{outer}`", metres(least))
            });
        }
        let (region, room) = call.region(1).ok()?;
        let region = &names.regions[region.0 as usize].name;
        let inside = inside_clearance(&thing.body.obb, &room.prism);
        let least = inside.least();
        let place = if least == inside.horizontal.value {
            "a wall"
        } else if least == inside.floor {
            "the floor"
        } else {
            "the ceiling"
        };
        Some(if least < 0.0 {
            format!("`{name}` is beyond {place} of `{region}` by {}", metres(-least))
        } else {
            format!("`{name}` is {} from {place} of `{region}`", metres(least))
        })
    }
}

/// Whether the box of an object is in a region.
pub fn in_region<N: Number>(thing: &Thing<N>, room: &Room<N>, tolerances: &Tolerances) -> Truth<N> {
    let (center, reach) = (thing.center(), thing.reach());
    let floor = (center - reach).0[1] - room.pos.0[1];
    let ceiling = room.pos.0[1] + room.scale.0[1] - (center + reach).0[1];
    let least = clearance_in_region(thing, room).min(floor).min(ceiling);
    Truth::metres(least + N::constant(tolerances.contact), tolerances.order)
}

/// The horizontal clearance of an object's box from the walls of a region, negative outside, without tolerance.
pub(super) fn clearance_in_region<N: Number>(thing: &Thing<N>, room: &Room<N>) -> N {
    let clearance = room.prism.polygon.clearance(&thing.body.obb.footprint());
    N::measured(clearance.value, || {
        // The wall's nearest point stays, the box turns on the corner it shows to the wall: its reach that way.
        let way = V3::constant(&Vector3::new(clearance.inward.x, 0.0, clearance.inward.y));
        let reach = |axis: usize| way.dot(thing.axes.0[axis]).abs() * thing.scale.0[axis].scale(0.5);
        way.dot(thing.center()) - reach(0) - reach(1) - reach(2) - wall_along(room, &clearance)
    })
}

/// The nearest point of the wall, along the way in.
pub(super) fn wall_along<N: Number>(room: &Room<N>, clearance: &Clearance) -> N {
    let [x, z] = room.attached(clearance.wall.x, clearance.wall.y);
    x.scale(clearance.inward.x) + z.scale(clearance.inward.y)
}

/// Whether the box of an object is in the box of another.
fn in_box<N: Number>(thing: &Thing<N>, outer: &Thing<N>, tolerances: &Tolerances) -> Truth<N> {
    let between = thing.center() - outer.center();
    let clearance = |axis: usize| {
        let way = outer.axes.0[axis];
        let reach = |own: usize| way.dot(thing.axes.0[own]).abs() * thing.scale.0[own].scale(0.5);
        outer.scale.0[axis].scale(0.5) - way.dot(between).abs() - (reach(0) + reach(1) + reach(2))
    };
    let least = clearance(0).min(clearance(1)).min(clearance(2));
    Truth::metres(least + N::constant(tolerances.contact), tolerances.order)
}
