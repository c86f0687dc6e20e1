//! `visible(Object, Object)`: no other box stands across the segment between the centres.

use super::declared::Given;
use super::{Call, Declared, Semantics, Surroundings};
use crate::eval::{EvalError, Truth};
use crate::number::{Algebra, Number};
use crate::world::{Body, World};
use nalgebra::Matrix3;
use scenelang_lang::program::{ObjectId, Program, Unit};
use scenelang_layout::{Obb, Separation, Vec3, obb};

pub(super) struct Visible;

impl Semantics for Visible {
    type Yields<N: Algebra> = Truth<N>;
    const DECLARED: Declared = Declared {
        unit: Unit::Metre,
        wanted: Some(|t| t.contact),
        unwanted: None,
        may_be_infinite: false,
        violation: None,
    };

    fn surroundings(given: &Given<'_>) -> Surroundings {
        Surroundings::Sight { from: given.object(0), to: given.object(1) }
    }

    fn exact<N: Number>(call: &Call<'_, N>) -> Result<Truth<N>, EvalError> {
        let ((a, from), (b, to)) = (call.object(0)?, call.object(1)?);
        let sight = segment(&from.body.obb.center, &to.body.obb.center);
        let Some((blocker, separation)) = nearest_blocker(call.world, &sight, [a, b]) else {
            return settled(call, Truth::discrete(true));
        };
        let tolerances = &call.world.options.tolerances;
        let gap = N::measured(separation.gap, || {
            let Ok(box_) = call.world.object(blocker) else { return N::constant(0.0) };
            let (p, q) = sight.contact(&box_.body.obb, &separation);
            // Where on the way between the centres the point of the segment is.
            let t = (p - from.body.obb.center).dot(&sight.axes.column(2)) / (2.0 * sight.half.z).max(1e-12);
            let p = from.center().map(|c| c.scale(1.0 - t)) + to.center().map(|c| c.scale(t));
            box_.attached_to_box(&q).along(&separation.normal) - p.along(&separation.normal)
        });
        settled(call, Truth::metres(gap + N::constant(tolerances.contact), tolerances.order))
    }

    fn words(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        let ((a, from), (b, to)) = (call.object(0).ok()?, call.object(1).ok()?);
        let sight = segment(&from.body.obb.center, &to.body.obb.center);
        let (blocker, separation) = nearest_blocker(call.world, &sight, [a, b])?;
        let [a, b, blocker] = [a, b, blocker].map(|id| &names.objects[id.0 as usize].name);
        let hidden = separation.gap + call.world.options.tolerances.contact < 0.0;
        hidden.then(|| format!("`{blocker}` stands between `{a}` and `{b}`"))
    }

    fn in_the_way(call: &Call<'_, f64>) -> Vec<ObjectId> {
        let (Ok((a, from)), Ok((b, to))) = (call.object(0), call.object(1)) else { return Vec::new() };
        let sight = segment(&from.body.obb.center, &to.body.obb.center);
        nearest_blocker(call.world, &sight, [a, b]).map(|(id, _)| id).into_iter().collect()
    }
}

/// What seems free cannot be judged while the layout lacks an object: it could stand in the way.
pub(super) fn settled<N: Number>(call: &Call<'_, N>, truth: Truth<N>) -> Result<Truth<N>, EvalError> {
    let missing = call.world.missing_object().filter(|_| truth.holds);
    missing.map_or(Ok(truth), |cause| Err(call.fail(cause)))
}

/// A segment as a box without width.
fn segment(from: &Vec3, to: &Vec3) -> Obb {
    let way = to - from;
    let front = way.try_normalize(1e-12).unwrap_or(Vec3::z());
    let other = if front.x.abs() < 0.6 { Vec3::x() } else { Vec3::y() };
    let right = front.cross(&other).normalize();
    let axes = Matrix3::from_columns(&[right, front.cross(&right), front]);
    Obb { center: (from + to) / 2.0, axes, half: Vec3::new(0.0, 0.0, way.norm() / 2.0) }
}

/// The object, other than the two, whose box is nearest to the segment.
fn nearest_blocker<N: Number>(world: &World<N>, sight: &Obb, ends: [ObjectId; 2]) -> Option<(ObjectId, Separation)> {
    let around = sight.aabb();
    let mut best: Option<(ObjectId, Separation)> = None;
    let others = world.bodies().filter(|(id, _)| !ends.contains(id));
    for (id, Body { obb: other, .. }) in others {
        let far = |s: &Separation| around.distance(&other.aabb()) > s.gap.max(0.0);
        // An axis that shows as much shows that it is no nearer.
        if best.as_ref().is_some_and(|(_, s)| far(s) || obb::apart(sight, other, s.gap)) {
            continue;
        }
        let separation = obb::separation(sight, other);
        if best.as_ref().is_none_or(|(_, s)| separation.gap < s.gap) {
            best = Some((id, separation));
        }
    }
    best
}
