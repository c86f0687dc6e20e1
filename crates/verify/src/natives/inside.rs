//! `inside(Object, Region)`: the least of three clearances of the box: from the walls, above the floor, below the
//! ceiling. `inside(Object, Object)`: the least clearance of the box's corners from the faces of the other box.

use super::{Call, Predicate, metres};
use crate::eval::{EvalError, Truth};
use crate::number::{Algebra, Number};
use crate::tolerances::Tolerances;
use crate::vector::V3;
use crate::world::{Room, Thing};
use scenelang_lang::program::{Arg, Program};
use scenelang_layout::planar::nearest_on_segment;
use scenelang_layout::polygon::Clearance;
use scenelang_layout::{Obb, Vec2, Vec3, inside_clearance};

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
    let footprint = thing.body.obb.footprint();
    let clearance = room.prism.polygon.clearance(&footprint);
    N::measured(clearance.value, || {
        let way = Vec3::new(clearance.inward.x, 0.0, clearance.inward.y);
        let own = if footprint.iter().any(|corner| (corner - clearance.at).norm() < 1e-9) {
            // A corner of the box that it shows to the wall, or a side that lies along it: how far it reaches that way.
            let way = V3::constant(&way);
            let reach = |axis: usize| way.dot(thing.axes.0[axis]).abs() * thing.scale.0[axis].scale(0.5);
            way.dot(thing.center()) - reach(0) - reach(1) - reach(2)
        } else {
            // A point of a side, which a corner of the wall is nearest to.
            thing.attached_to_box(&over(&thing.body.obb, clearance.at)).along(&way)
        };
        own - wall_along(room, &clearance)
    })
}

/// The point of the edges of a box that is over (or under) a point of the outline of its footprint.
pub(super) fn over(obb: &Obb, at: Vec2) -> Vec3 {
    let flat = |p: Vec3| Vec2::new(p.x, p.z);
    let on = |[p, q]: [Vec3; 2]| {
        let (a, b) = (flat(p), flat(q));
        let nearest = nearest_on_segment(&at, &a, &b);
        let length = (b - a).norm();
        let t = if length > 0.0 { (nearest - a).norm() / length } else { 0.0 };
        ((nearest - at).norm(), p + (q - p) * t)
    };
    obb.edges().map(on).into_iter().min_by(|x, y| x.0.total_cmp(&y.0)).map_or(obb.center, |(_, point)| point)
}

/// The nearest point of the wall, along the way in.
pub(super) fn wall_along<N: Number>(room: &Room<N>, clearance: &Clearance) -> N {
    let [x, z] = room.attached(clearance.wall.x, clearance.wall.y);
    x.scale(clearance.inward.x) + z.scale(clearance.inward.y)
}

/// Whether the box of an object is in the box of another.
pub(crate) fn in_box<N: Algebra>(thing: &Thing<N>, outer: &Thing<N>, tolerances: &Tolerances) -> Truth<N> {
    let between = thing.center() - outer.center();
    let clearance = |axis: usize| {
        let way = outer.axes.0[axis];
        let reach = |own: usize| way.dot(thing.axes.0[own]).abs() * thing.scale.0[own].scale(0.5);
        outer.scale.0[axis].scale(0.5) - way.dot(between).abs() - (reach(0) + reach(1) + reach(2))
    };
    let least = clearance(0).min(clearance(1)).min(clearance(2));
    Truth::metres(least + N::constant(tolerances.contact), tolerances.order)
}
