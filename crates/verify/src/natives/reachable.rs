//! `reachable(Object, Object, width)`: a disc of that diameter can move on the floor from one to the other.
//! `walkDistance(Object, Object)`: how far a person walks; infinite where there is no way.

use super::{Call, Measuring, Predicate};
use crate::eval::{EvalError, Truth};
use crate::navigation;
use crate::number::Number;

/// See the file.
pub(super) struct Reachable;

impl Predicate for Reachable {
    fn truth<N: Number>(call: &Call<'_, N>) -> Result<Truth<N>, EvalError> {
        let ((_, a), (_, b)) = (call.object(0)?, call.object(1)?);
        let width = call.number(2)?.value();
        let holds = navigation::reachable(call.world, &a.body.obb, &b.body.obb, width);
        // What is missing could stand in the way, or be the way.
        let missing = if holds { call.world.missing_object() } else { call.world.missing_region() };
        missing.map_or(Ok(Truth::discrete(holds)), |cause| Err(call.fail(cause)))
    }
}

/// See the file.
pub(super) struct WalkDistance;

impl Measuring for WalkDistance {
    fn measure<N: Number>(call: &Call<'_, N>) -> Result<N, EvalError> {
        let ((_, a), (_, b)) = (call.object(0)?, call.object(1)?);
        if let Some(cause) = call.world.missing_object().or(call.world.missing_region()) {
            return Err(call.fail(cause));
        }
        let length = navigation::walk(call.world, &a.body.obb, &b.body.obb);
        Ok(N::measured(length, || N::constant(0.0)))
    }
}
