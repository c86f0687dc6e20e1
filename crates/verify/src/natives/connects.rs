//! `connects(Object, Region)`, `connects(Object, Region, Region)`: a door sits in the wall. Its centre and both ends of
//! its width are near the edges of the regions, and it is between the higher floor and the lower ceiling.

use super::{Call, Predicate, metres};
use crate::eval::{EvalError, Truth};
use crate::number::Number;
use crate::vector::V3;
use crate::world::{Room, Thing};
use scenelang_lang::program::Program;
use scenelang_layout::{Vec2, Vec3};

/// See the file.
pub(super) struct Connects;

impl Predicate for Connects {
    fn truth<N: Number>(call: &Call<'_, N>) -> Result<Truth<N>, EvalError> {
        let (_, door) = call.object(0)?;
        let options = &call.world.options;
        let slack = N::constant(options.tolerances.door);
        let (center, reach) = (door.center(), door.reach());
        let mut margin = N::constant(f64::INFINITY);
        for index in 1..call.args.len() {
            let (_, room) = call.region(index)?;
            let above = (center - reach).0[1] - room.pos.0[1];
            let below = room.pos.0[1] + room.scale.0[1] - (center + reach).0[1];
            let off = N::constant(2.0 * options.eta) - off_wall(door, room);
            margin = margin.min((above.min(below)).min(off) + slack);
        }
        Ok(Truth::metres(margin, options.tolerances.order))
    }

    fn explain(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        let (object, door) = call.object(0).ok()?;
        let name = &names.objects[object.0 as usize].name;
        let far = (1..call.args.len())
            .filter_map(|i| call.region(i).ok())
            .map(|(id, room)| (off_wall(door, room), id))
            .max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(format!("`{name}` is up to {} off the wall of `{}`", metres(far.0), names.regions[far.1.0 as usize].name))
    }

    fn measured(call: &Call<'_, f64>) -> Option<(f64, f64)> {
        let slack = call.world.options.tolerances.door;
        Some((Self::truth(call).ok()?.margin - slack, -slack))
    }
}

/// How far the centre and the ends of a door's width are from the edges of a region, at most.
fn off_wall<N: Number>(door: &Thing<N>, room: &Room<N>) -> N {
    let half = door.axes.0[0].times(door.scale.0[0].scale(0.5));
    let center = door.center();
    let off = |point: V3<N>| {
        let plain = point.value();
        let near = room.prism.polygon.clearance_of_point(Vec2::new(plain.x, plain.z));
        let away = if near.value < 0.0 { -near.inward } else { near.inward };
        N::measured(near.value.abs(), || {
            let [x, z] = room.attached(near.wall.x, near.wall.y);
            point.along(&Vec3::new(away.x, 0.0, away.y)) - x.scale(away.x) - z.scale(away.y)
        })
    };
    off(center).max(off(center - half)).max(off(center + half))
}
