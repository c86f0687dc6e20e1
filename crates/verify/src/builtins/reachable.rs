//! `reachable(Object, Object, width)`: a disc of that diameter can move on the floor from one to the other.
//!
//! Where there is no way it has no margin of its own. What moves is known all the same: the gap at the bottleneck.

use super::declared::Given;
use super::inside::moving;
use super::passages;
use super::{Call, Declared, Semantics, Surroundings, metres};
use crate::eval::{EvalError, Truth};
use crate::navigation::{self, Blocker, Bottleneck};
use crate::number::{Algebra, Number};
use crate::prove::tape::Term;
use crate::prove::unknowns::{Unknowns, claimed};
use crate::world::World;
use scenelang_lang::program::{ObjectId, Program, Unit};

pub(super) struct Reachable;

impl Semantics for Reachable {
    type Yields<N: Algebra> = Truth<N>;
    const DECLARED: Declared =
        Declared { unit: Unit::Metre, wanted: None, unwanted: None, may_be_infinite: false, violation: None };

    fn surroundings(given: &Given<'_>) -> Surroundings {
        Surroundings::Path { from: given.object(0), to: given.object(1), width: given.constant(2) }
    }

    fn exact<N: Number>(call: &Call<'_, N>) -> Result<Truth<N>, EvalError> {
        let ((from, a), (to, b)) = (call.object(0)?, call.object(1)?);
        let width = call.number(2)?;
        let holds = navigation::reachable(call.world, &a.body.obb, &b.body.obb, width.value());
        // What is missing could stand in the way, or be the way.
        let missing = if holds { call.world.missing_object() } else { call.world.missing_region() };
        if let Some(cause) = missing {
            return Err(call.fail(cause));
        }
        let truth = Truth::discrete(holds);
        if holds {
            return Ok(truth);
        }
        let margin = N::measured(f64::NEG_INFINITY, || {
            let bottleneck = navigation::bottleneck(call.world, from, to, width.value());
            bottleneck.map_or(N::constant(0.0), |found| widening(call.world, &found) - width)
        });
        Ok(Truth { margin, ..truth })
    }

    fn bounds(call: &Call<'_, Term>, facts: &mut Unknowns<'_>) -> Result<Option<Truth<Term>>, EvalError> {
        let (from, to, width) = (call.object(0)?.0, call.object(1)?.0, call.number(2)?);
        let follow = passages::needed(facts, [from, to], width);
        let claim = facts.open(call.question()?, &follow);
        facts.paths.push((claim, [from, to], width));
        Ok(Some(claimed(claim)))
    }

    fn words(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        let ((from, a), (to, b)) = (call.object(0).ok()?, call.object(1).ok()?);
        let width = call.number(2).ok()?;
        if navigation::reachable(call.world, &a.body.obb, &b.body.obb, width) {
            return None;
        }
        let [a, b] = [call.name(0, names), call.name(1, names)];
        if !call.world.options.detail.bars {
            return Some(format!("there is no path {} wide from `{a}` to `{b}`", metres(width)));
        }
        Some(match navigation::bottleneck(call.world, from, to, width) {
            Some(bottleneck) => in_words(&bottleneck, [a, b], width, names),
            None => closed_in_words([a, b], &navigation::closing(call.world, from, to, width), names),
        })
    }

    fn measured(call: &Call<'_, f64>) -> Option<(f64, f64)> {
        let (from, to, width) = (call.object(0).ok()?.0, call.object(1).ok()?.0, call.number(2).ok()?);
        if !call.world.options.detail.bars || Self::exact(call).ok()?.holds {
            return None;
        }
        Some((navigation::bottleneck(call.world, from, to, width).map_or(0.0, |found| found.width), width))
    }

    fn in_the_way(call: &Call<'_, f64>) -> Vec<ObjectId> {
        let (Ok((from, _)), Ok((to, _)), Ok(width)) = (call.object(0), call.object(1), call.number(2)) else {
            return Vec::new();
        };
        let found = navigation::bottleneck(call.world, from, to, width);
        let object = |blocker: Blocker| match blocker {
            Blocker::Object(id) => Some(id),
            Blocker::Wall(_) | Blocker::Door(_) | Blocker::Edge => None,
        };
        match found {
            Some(found) => found.between.into_iter().filter_map(object).collect(),
            None if Self::exact(call).is_ok_and(|truth| !truth.holds) => {
                navigation::closing(call.world, from, to, width)
            }
            None => Vec::new(),
        }
    }
}

/// What closes the way between two objects, in words.
fn closed_in_words([a, b]: [&str; 2], closing: &[ObjectId], names: &Program) -> String {
    let closed = format!("there is no path of any width from `{a}` to `{b}`");
    let quoted: Vec<String> = closing.iter().map(|id| format!("`{}`", names.objects[id.0 as usize].name)).collect();
    match quoted.split_last() {
        None => closed,
        Some((one, [])) => format!("{closed}, because {one} is in the way"),
        Some((last, rest)) => format!("{closed}, because {} and {last} are in the way", rest.join(", ")),
    }
}

/// What keeps a disc of some width from getting from one object to the other, in words.
pub(crate) fn in_words(found: &Bottleneck, ends: [&str; 2], width: f64, names: &Program) -> String {
    let (wide, short) = (metres(found.width), metres(width - found.width));
    let name = |blocker: &Blocker| match blocker {
        Blocker::Object(id) => format!("`{}`", names.objects[id.0 as usize].name),
        Blocker::Wall(id) => format!("the wall of `{}`", names.regions[id.0 as usize].name),
        Blocker::Door(id) => format!("the frame of `{}`", names.objects[id.0 as usize].name),
        Blocker::Edge => "the edge of the floor".to_owned(),
    };
    match (found.between, found.end) {
        ([a, b], Some(end)) => {
            let between = if a == b { name(&a) } else { format!("{} and {}", name(&a), name(&b)) };
            format!("the space beside `{}` is at most {wide} wide, {short} too narrow, because of {between}", ends[end])
        }
        ([Blocker::Door(door), Blocker::Door(_)], _) => {
            format!("the doorway `{}` is {wide} wide, {short} too narrow", names.objects[door.0 as usize].name)
        }
        ([Blocker::Wall(a), Blocker::Wall(b)], _) if a == b => {
            format!(
                "the passage between the walls of `{}` is {wide} wide, {short} too narrow",
                names.regions[a.0 as usize].name
            )
        }
        ([a, b], _) => format!("the passage between {} and {} is {wide} wide, {short} too narrow", name(&a), name(&b)),
    }
}

/// How the gap at a bottleneck grows as its objects move; walls stay where they are.
fn widening<N: Number>(world: &World<N>, found: &Bottleneck) -> N {
    let [p, q] = found.at;
    let Some(way) = (q - p).try_normalize(1e-12) else { return N::constant(0.0) };
    let along = |i: usize| match found.between[i] {
        Blocker::Object(id) => world.object(id).map_or(N::constant(0.0), |thing| moving(thing, found.at[i], way)),
        Blocker::Wall(_) | Blocker::Door(_) | Blocker::Edge => N::constant(0.0),
    };
    along(1) - along(0)
}
