//! `connects(Object, Region)`, `connects(Object, Region, Region)`: a door sits in the wall. Its centre and both ends of
//! its width are near the edges of the regions, and it is between the higher floor and the lower ceiling.

use super::declared::Given;
use super::inside::heights;
use super::{Call, Declared, Semantics, Surroundings, metres};
use crate::coded::Boxes;
use crate::eval::{EvalError, Truth};
use crate::number::{Algebra, Number};
use crate::prove::tape::{Term, any};
use crate::prove::unknowns::{Unknowns, claimed};
use crate::vector::V3;
use crate::world::{ObjectInstance, RegionInstance};
use scenelang_lang::program::{Program, Unit};
use scenelang_layout::{Vec2, Vec3};

pub(super) struct Connects;

/// What rounding of a place may cost in a proof (metres).
const ROUNDING: f64 = 1e-6;

impl Semantics for Connects {
    type Yields<N: Algebra> = Truth<N>;
    const DECLARED: Declared = Declared {
        unit: Unit::Metre,
        wanted: Some(|t| t.door),
        unwanted: None,
        may_be_infinite: false,
        violation: None,
    };

    fn surroundings(_given: &Given<'_>) -> Surroundings {
        Surroundings::Nothing
    }

    fn exact<N: Number>(call: &Call<'_, N>) -> Result<Truth<N>, EvalError> {
        let (_, door) = call.object(0)?;
        let options = &call.world.options;
        let slack = N::constant(options.tolerances.door);
        let mut margin = N::constant(f64::INFINITY);
        for index in 1..call.args.len() {
            let (_, room) = call.region(index)?;
            let [above, below] = heights(door, room);
            let off = N::constant(2.0 * options.eta) - off_wall(door, room);
            margin = margin.min((above.min(below)).min(off) + slack);
        }
        Ok(Truth::metres(margin, options.tolerances.order))
    }

    fn bounds(call: &Call<'_, Term>, facts: &mut Unknowns<'_>) -> Result<Option<Truth<Term>>, EvalError> {
        let (_, door) = call.object(0)?;
        let slack = facts.options.tolerances.door + facts.options.tolerances.order;
        let off = 2.0 * facts.options.eta + slack + ROUNDING;
        let half = door.axes.0[0].times(door.scale.0[0].scale(0.5));
        let mut follow = Vec::new();
        for index in 1..call.args.len() {
            let (region, room) = call.region(index)?;
            follow.extend(heights(door, room).map(|height| height.at_least(-slack)));
            if !facts.is_rectangle(region) {
                continue;
            }
            // Of a rectangle, what is near an edge is not far outside, and not far from both pairs of walls.
            for point in [door.center(), door.center() - half, door.center() + half] {
                let at = facts.framed(region, point.0[0] - room.pos.0[0], point.0[2] - room.pos.0[2]);
                let from = [0, 1].map(|i| room.scale.0[2 * i].scale(0.5) - at[i].abs());
                follow.extend(from.map(|from| from.at_least(-off)));
                follow.push(any(&from.map(|from| (-from).at_least(-off))));
            }
        }
        Ok(Some(claimed(facts.open(call.question()?, &follow))))
    }

    fn fast(call: &Call<'_, Term>, boxes: &mut Boxes<'_, '_>) -> Result<Option<Truth<Term>>, EvalError> {
        let (_, door) = call.object(0)?;
        let options = &call.world.options;
        let half = door.axes.0[0].times(door.scale.0[0].scale(0.5));
        let center = door.center();
        let mut margin = Term::constant(f64::INFINITY);
        for index in 1..call.args.len() {
            let (_, room) = call.region(index)?;
            let [above, below] = heights(door, room);
            margin = margin.min(above).min(below);
            for point in [center, center - half, center + half] {
                let off = boxes.depth(&point, room).abs();
                margin = margin.min(Term::constant(2.0 * options.eta) - off);
            }
        }
        Ok(Some(Truth::metres(margin + Term::constant(options.tolerances.door), options.tolerances.order)))
    }

    fn words(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        let (_, door) = call.object(0).ok()?;
        let name = call.name(0, names);
        let far = (1..call.args.len())
            .filter_map(|i| call.region(i).ok())
            .map(|(id, room)| (off_wall(door, room), id))
            .max_by(|a, b| a.0.total_cmp(&b.0))?;
        let options = &call.world.options;
        let limit = 2.0 * options.eta + options.tolerances.door;
        let room = &names.regions[far.1.0 as usize].name;
        let said = format!("the farthest point of `{name}` is {} from the wall of `{room}`", metres(far.0));
        // A door at the wall is too low or too high.
        let is_far = far.0 > limit;
        Some(if is_far { format!("{said}, but must be at most {} from it", metres(limit)) } else { said })
    }
}

/// How far the centre and the ends of a door's width are from the edges of a region, at most.
fn off_wall<N: Number>(door: &ObjectInstance<N>, room: &RegionInstance<N>) -> N {
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
