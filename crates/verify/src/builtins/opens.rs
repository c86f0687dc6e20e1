//! `opens` and `opening`, `slides` and `sliding`: how far the movable parts of an object come before they meet something.
//!
//! What turns is measured in degrees, what slides in metres. The verdict is that of P-OPEN: the least gap over the motion, in
//! metres, with the tolerance of contact. An object that has nothing of the kind does not open.

use super::declared::Given;
use super::{Call, Declared, Semantics, Surroundings};
use crate::eval::{EvalError, Truth};
use crate::number::{Algebra, Number};
use crate::opening::{self, LOOKS, Met};
use scenelang_lang::program::{ObjectId, Program, Unit};
use scenelang_layout::{Joint, Motion};

/// What a predicate about opening declares.
const PREDICATE: Declared = Declared {
    unit: Unit::Metre,
    wanted: Some(|t| t.contact),
    unwanted: None,
    may_be_infinite: false,
    violation: None,
};

/// `opens(a)`, `opens(a, angle)`.
pub(super) struct Opens;
/// `opening(a)`.
pub(super) struct Opening;
/// `slides(a, distance)`.
pub(super) struct Slides;
/// `sliding(a)`.
pub(super) struct Sliding;

/// The parts of the object that a use speaks of, each with how far it is asked to open (degrees or metres): without an amount
/// as far as is of use.
fn asked<N: Number>(call: &Call<'_, N>, motion: Motion) -> Result<Vec<(usize, f64)>, EvalError> {
    let (id, _) = call.object(0)?;
    let amount = if call.args.len() > 1 { Some(call.number(1)?.value()) } else { None };
    let joints = opening::joints(call.world, id).iter().enumerate();
    Ok(match amount {
        Some(amount) => joints.filter(|(_, joint)| joint.motion == motion).map(|(part, _)| (part, amount)).collect(),
        None => joints.filter_map(|(part, joint)| Some((part, joint.useful?))).collect(),
    })
}

/// Whether all of them open so far.
fn all<N: Number>(call: &Call<'_, N>, motion: Motion) -> Result<Truth<N>, EvalError> {
    let (id, _) = call.object(0)?;
    let parts = asked(call, motion)?;
    let joints = opening::joints(call.world, id);
    if parts.is_empty() || parts.iter().any(|(part, amount)| *amount > joints[*part].limits[1]) {
        return Ok(Truth::discrete(false));
    }
    parts.into_iter().filter(|(_, amount)| *amount > 0.0).try_fold(Truth::discrete(true), |all, (part, amount)| {
        let truth = opening::opens(call.world, id, part, amount, &mut { LOOKS }).map_err(|cause| call.fail(cause))?;
        Ok(all.and(truth))
    })
}

/// How far the parts that move this way open at the least, and what the one of them that opens least meets.
fn least<N: Number>(call: &Call<'_, N>, motion: Motion) -> Result<(f64, Option<Met>), EvalError> {
    let (id, _) = call.object(0)?;
    let joints = opening::joints(call.world, id).iter().enumerate().filter(|(_, joint)| joint.motion == motion);
    let mut least: Option<(f64, Option<Met>)> = None;
    for (part, joint) in joints {
        let found = opening::free(call.world, id, part, joint.limits[1], &mut { LOOKS }).map_err(|c| call.fail(c))?;
        if least.is_none_or(|(free, _)| found.0 < free) {
            least = Some(found);
        }
    }
    Ok(least.unwrap_or((0.0, None)))
}

/// Which part of an object does not open as it should, how far it does, and what it meets.
fn in_words(call: &Call<'_, f64>, names: &Program, motion: Motion) -> Option<String> {
    let (id, _) = call.object(0).ok()?;
    let name = call.name(0, names);
    let parts = asked(call, motion).ok()?;
    if parts.is_empty() {
        let what = match (call.args.len(), motion) {
            (1, _) => "opens",
            (_, Motion::Hinge) => "turns",
            (_, Motion::Slide) => "slides",
        };
        return Some(format!("no part of `{name}` {what}"));
    }
    let joints = opening::joints(call.world, id);
    let free = |part: usize, amount: f64| opening::free(call.world, id, part, amount, &mut { LOOKS }).ok();
    for (part, amount) in parts {
        let Joint { name: part_name, motion, limits, .. } = &joints[part];
        let wanted = opening::amount(amount, *motion);
        if amount > limits[1] {
            let most = opening::amount(limits[1], *motion);
            return Some(format!("`{part_name}` of `{name}` opens at most {most}, not {wanted}"));
        }
        if let Some((far, Some(met))) = free(part, amount) {
            let [far, wanted] = opening::amounts(far, amount, *motion);
            let met = opening::met_in_words(names, met);
            return Some(format!("`{part_name}` of `{name}` opens {far} of {wanted}, then hits {met}"));
        }
    }
    None
}

/// What ends the motion of the parts that are asked for.
fn met(call: &Call<'_, f64>, motion: Motion) -> Vec<ObjectId> {
    let (Ok((id, _)), Ok(parts)) = (call.object(0), asked(call, motion)) else { return Vec::new() };
    let nearest = parts.into_iter().filter_map(|(part, amount)| {
        let nearest = opening::nearest(call.world, id, part, amount, &mut { LOOKS }).ok()??;
        Some((nearest.swept.gap, nearest.met))
    });
    let least = nearest.min_by(|a, b| a.0.total_cmp(&b.0));
    least.and_then(|(_, met)| if let Met::Object(id) = met { Some(id) } else { None }).into_iter().collect()
}

impl Semantics for Opens {
    type Yields<N: Algebra> = Truth<N>;
    const DECLARED: Declared = PREDICATE;

    fn surroundings(given: &Given<'_>) -> Surroundings {
        Surroundings::Swing { owner: given.object(0) }
    }
    fn exact<N: Number>(call: &Call<'_, N>) -> Result<Truth<N>, EvalError> {
        all(call, Motion::Hinge)
    }
    fn words(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        in_words(call, names, Motion::Hinge)
    }
    fn in_the_way(call: &Call<'_, f64>) -> Vec<ObjectId> {
        met(call, Motion::Hinge)
    }
}

impl Semantics for Slides {
    type Yields<N: Algebra> = Truth<N>;
    const DECLARED: Declared = PREDICATE;

    fn surroundings(given: &Given<'_>) -> Surroundings {
        Surroundings::Swing { owner: given.object(0) }
    }
    fn exact<N: Number>(call: &Call<'_, N>) -> Result<Truth<N>, EvalError> {
        all(call, Motion::Slide)
    }
    fn words(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        in_words(call, names, Motion::Slide)
    }
    fn in_the_way(call: &Call<'_, f64>) -> Vec<ObjectId> {
        met(call, Motion::Slide)
    }
}

impl Semantics for Opening {
    type Yields<N: Algebra> = N;
    const DECLARED: Declared =
        Declared { unit: Unit::Degree, wanted: None, unwanted: None, may_be_infinite: false, violation: None };

    fn surroundings(given: &Given<'_>) -> Surroundings {
        Surroundings::Swing { owner: given.object(0) }
    }
    fn exact<N: Number>(call: &Call<'_, N>) -> Result<N, EvalError> {
        Ok(N::constant(least(call, Motion::Hinge)?.0))
    }
    fn words(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        Some(format!("the angle by which `{}` can open", call.name(0, names)))
    }
    fn in_the_way(call: &Call<'_, f64>) -> Vec<ObjectId> {
        ends(call, Motion::Hinge)
    }
}

impl Semantics for Sliding {
    type Yields<N: Algebra> = N;
    const DECLARED: Declared =
        Declared { unit: Unit::Metre, wanted: None, unwanted: None, may_be_infinite: false, violation: None };

    fn surroundings(given: &Given<'_>) -> Surroundings {
        Surroundings::Swing { owner: given.object(0) }
    }
    fn exact<N: Number>(call: &Call<'_, N>) -> Result<N, EvalError> {
        Ok(N::constant(least(call, Motion::Slide)?.0))
    }
    fn words(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        Some(format!("the distance by which `{}` can slide out", call.name(0, names)))
    }
    fn in_the_way(call: &Call<'_, f64>) -> Vec<ObjectId> {
        ends(call, Motion::Slide)
    }
}

/// The object that ends the free range.
fn ends(call: &Call<'_, f64>, motion: Motion) -> Vec<ObjectId> {
    match least(call, motion) {
        Ok((_, Some(Met::Object(id)))) => vec![id],
        _ => Vec::new(),
    }
}
