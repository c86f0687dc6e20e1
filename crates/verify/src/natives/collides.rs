//! `collides(Object, Object)`: the solids overlap by more than the tolerance. `gap`: the distance between solids,
//! negative where they overlap; of an object or a point in a region, the horizontal distance to the nearest wall.

use super::inside::{clearance_in_region, wall_along};
use super::{Call, Measuring, Predicate, metres};
use crate::eval::{EvalError, Truth};
use crate::number::Number;
use crate::world::{Body, Thing};
use scenelang_lang::program::{Arg, Program};
use scenelang_layout::convex::nearest;
use scenelang_layout::{Separation, Vec2, Vec3, obb};

/// See the file.
pub(super) struct Collides;

impl Predicate for Collides {
    fn truth<N: Number>(call: &Call<'_, N>) -> Result<Truth<N>, EvalError> {
        let margin = -(gap(call.object(0)?.1, call.object(1)?.1) + N::constant(call.world.options.tolerances.contact));
        // A strict one: boxes that touch, or overlap by no more than the tolerance, do not collide.
        Ok(Truth { holds: margin.value() > 0.0, ..Truth::metres(margin, 0.0) })
    }

    fn explain(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        let ((a, x), (b, y)) = (call.object(0).ok()?, call.object(1).ok()?);
        let [a, b] = [a, b].map(|id| &names.objects[id.0 as usize].name);
        Some(in_words(a, b, gap(x, y)))
    }

    fn measured(call: &Call<'_, f64>) -> Option<(f64, f64)> {
        let gap = gap(call.object(0).ok()?.1, call.object(1).ok()?.1);
        Some((gap, -call.world.options.tolerances.contact))
    }
}

/// A gap in words.
pub(crate) fn in_words(a: &str, b: &str, gap: f64) -> String {
    if gap < 0.0 {
        format!("`{a}` overlaps `{b}` by {}", metres(-gap))
    } else {
        format!("`{a}` is {} from `{b}`", metres(gap))
    }
}

/// See the file.
pub(super) struct Gap;

impl Measuring for Gap {
    fn measure<N: Number>(call: &Call<'_, N>) -> Result<N, EvalError> {
        match call.args {
            [Arg::Object(_), Arg::Object(_)] => Ok(gap(call.object(0)?.1, call.object(1)?.1)),
            [Arg::Object(_), _] => Ok(clearance_in_region(call.object(0)?.1, call.region(1)?.1)),
            _ => {
                let (point, (_, room)) = (call.vector(0)?, call.region(1)?);
                let plain = point.value();
                let clearance = room.prism.polygon.clearance_of_point(Vec2::new(plain.x, plain.z));
                Ok(N::measured(clearance.value, || {
                    let way = Vec3::new(clearance.inward.x, 0.0, clearance.inward.y);
                    point.along(&way) - wall_along(room, &clearance)
                }))
            }
        }
    }
}

/// The gap between the solids of two objects: 0 when they touch, negative when they overlap (metres).
pub fn gap<N: Number>(a: &Thing<N>, b: &Thing<N>) -> N {
    let (separation, parts) = separation(&a.body, &b.body);
    N::measured(separation.gap, || {
        // The direction is the best one, so that turning it changes nothing to first order: only the points move.
        let (p, q) = match parts {
            None => a.body.obb.contact(&b.body.obb, &separation),
            Some([i, j]) => a.body.solid()[i].contact(&b.body.solid()[j], &separation),
        };
        b.attached(&q).along(&separation.normal) - a.attached(&p).along(&separation.normal)
    })
}

/// The separation of two bodies, and the parts that have it, unless both are boxes.
fn separation(a: &Body, b: &Body) -> (Separation, Option<[usize; 2]>) {
    if !a.has_parts() && !b.has_parts() {
        return (obb::separation(&a.obb, &b.obb), None);
    }
    let found = nearest(a.solid(), b.solid()).expect("a solid has at least one part");
    (found.separation, Some(found.parts))
}
