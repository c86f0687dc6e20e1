//! `walkDistance(Object, Object)`: how far a person walks; infinite where there is no way.
//!
//! What moves is known: the ends and the bends of the way.

use super::declared::Given;
use super::inside::moving;
use super::{Call, Declared, Semantics, Surroundings};
use crate::eval::EvalError;
use crate::navigation::{self, Path};
use crate::number::{Algebra, Number};
use crate::prove::interval::Interval;
use crate::prove::tape::Term;
use crate::prove::unknowns::Unknowns;
use crate::world::{ObjectInstance, World};
use scenelang_lang::program::{Program, Unit};

/// Longer than any way that could be compared with anything (metres).
const NO_WAY: f64 = 1e12;

pub(super) struct WalkDistance;

impl Semantics for WalkDistance {
    type Yields<N: Algebra> = N;
    const DECLARED: Declared =
        Declared { unit: Unit::Metre, wanted: None, unwanted: None, may_be_infinite: true, violation: None };

    fn surroundings(given: &Given<'_>) -> Surroundings {
        Surroundings::Path { from: given.object(0), to: given.object(1), width: Some(navigation::PERSON) }
    }

    fn exact<N: Number>(call: &Call<'_, N>) -> Result<N, EvalError> {
        let ((_, a), (_, b)) = (call.object(0)?, call.object(1)?);
        if let Some(cause) = call.world.missing_object().or(call.world.missing_region()) {
            return Err(call.fail(cause));
        }
        let path = navigation::walk(call.world, &a.body.obb, &b.body.obb);
        let length = path.as_ref().map_or(f64::INFINITY, |path| path.length);
        Ok(N::measured(length, || path.map_or(N::constant(0.0), |path| lengthening(call.world, [a, b], &path))))
    }

    fn bounds(call: &Call<'_, Term>, facts: &mut Unknowns<'_>) -> Result<Option<Term>, EvalError> {
        let ((a, x), (b, y)) = (call.object(0)?, call.object(1)?);
        let (walk, new) = facts.term(format!("walk {a:?} {b:?}"), Interval::new(0.0, NO_WAY));
        if new {
            // From near the one to near the other: no shorter than the boxes are apart, less a disc at each end.
            let flat = x.center() - y.center();
            let distance = (flat.0[0] * flat.0[0] + flat.0[2] * flat.0[2]).sqrt();
            let span = (x.scale.length() + y.scale.length()).scale(0.5);
            facts.always.push((walk + span - distance).at_least(-1.0));
        }
        Ok(Some(walk))
    }

    fn words(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        Some(format!("the shortest path from `{}` to `{}`", call.name(0, names), call.name(1, names)))
    }
}

/// How the length of a way grows as its ends move, and the objects round which it bends.
fn lengthening<N: Number>(world: &World<N>, [a, b]: [&ObjectInstance<N>; 2], path: &Path) -> N {
    let step = |i: usize| (path.points[i + 1] - path.points[i]).try_normalize(1e-12).unwrap_or_default();
    let Some(last) = path.points.len().checked_sub(2) else { return N::constant(0.0) };
    let mut sum = moving(b, path.points[last + 1], step(last)) - moving(a, path.points[0], step(0));
    for bend in 1..=last {
        if let Some((object, at)) = navigation::touched(world, path.points[bend])
            && let Ok(thing) = world.object(object)
        {
            sum = sum + moving(thing, at, step(bend - 1) - step(bend));
        }
    }
    sum
}
