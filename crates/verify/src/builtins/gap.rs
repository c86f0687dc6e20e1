//! `gap`: the distance between solids, negative where they overlap; of an object or a point in a region, the horizontal
//! distance to the nearest wall.

use super::declared::Given;
use super::inside::{clearance_in_region, middle_in_proofs, wall_along};
use super::{Call, Declared, Semantics, Surroundings, metres};
use crate::coded::Boxes;
use crate::eval::EvalError;
use crate::number::{Algebra, Number};
use crate::prove::tape::{Term, any};
use crate::prove::unknowns::{ANY, EXACT, OUT_OF_BOX, Unknowns};
use crate::vector::V3;
use crate::world::{Body, ObjectInstance};
use scenelang_lang::program::{Arg, ObjectId, Program, RegionId, Unit};
use scenelang_layout::convex::nearest_of;
use scenelang_layout::{Separation, Vec2, Vec3, obb};

pub(super) struct Gap;

impl Semantics for Gap {
    type Yields<N: Algebra> = N;
    const DECLARED: Declared =
        Declared { unit: Unit::Metre, wanted: None, unwanted: None, may_be_infinite: false, violation: None };

    fn surroundings(_given: &Given<'_>) -> Surroundings {
        Surroundings::Nothing
    }

    fn exact<N: Number>(call: &Call<'_, N>) -> Result<N, EvalError> {
        match call.args {
            [Arg::Object(_), Arg::Object(_)] => Ok(between(call.object(0)?.1, call.object(1)?.1)),
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

    fn bounds(call: &Call<'_, Term>, facts: &mut Unknowns<'_>) -> Result<Option<Term>, EvalError> {
        Ok(match call.args {
            [Arg::Object(a), Arg::Object(b)] => (a != b).then(|| in_proofs(facts, *a, *b)),
            [Arg::Object(a), _] => Some(from_walls_in_proofs(facts, *a, call.region(1)?.0)),
            _ => {
                let (point, (region, _)) = (call.vector(0)?, call.region(1)?);
                Some(if facts.is_rectangle(region) {
                    point_in_proofs(facts, point, region)
                } else {
                    facts.term(format!("gap {point:?} {region:?}"), ANY).0
                })
            }
        })
    }

    fn fast(call: &Call<'_, Term>, boxes: &mut Boxes<'_, '_>) -> Result<Option<Term>, EvalError> {
        Ok(match call.args {
            [Arg::Object(_), Arg::Object(_)] => boxes.gap(call.object(0)?.1, call.object(1)?.1),
            [Arg::Object(_), _] => boxes.clearance(call.object(0)?.1, call.region(1)?.1),
            _ => Some(boxes.depth(&call.vector(0)?, call.region(1)?.1)),
        })
    }

    fn words(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        match call.args {
            [Arg::Object(_), Arg::Object(_)] => {
                Some(format!("the gap between `{}` and `{}`", call.name(0, names), call.name(1, names)))
            }
            [Arg::Object(_), _] => {
                let (thing, room) = (call.name(0, names), call.name(1, names));
                Some(format!("the distance from `{thing}` to the nearest wall of `{room}`"))
            }
            _ => None,
        }
    }
}

pub(crate) fn in_words(a: &str, b: &str, gap: f64) -> String {
    if gap < 0.0 {
        format!("`{a}` overlaps `{b}` by {}", metres(-gap))
    } else {
        format!("`{a}` is {} from `{b}`", metres(gap))
    }
}

/// The gap between the solids of two objects: 0 when they touch, negative when they overlap (metres).
pub fn between<N: Number>(a: &ObjectInstance<N>, b: &ObjectInstance<N>) -> N {
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
    let ((a, over), (b, around)) = (a.bounded(), b.bounded());
    let found = nearest_of([(a, &over), (b, &around)]).expect("a solid has at least one part");
    (found.separation, Some(found.parts))
}

/// The gap between the solids of two objects, in proofs.
pub(crate) fn in_proofs(facts: &mut Unknowns<'_>, a: ObjectId, b: ObjectId) -> Term {
    let (gap, new) = facts.term(name(a, b), ANY);
    if new {
        let (x, y) = (facts.thing(a), facts.thing(b));
        let between = (x.center() - y.center()).map(Term::abs);
        let reach = x.reach() + y.reach();
        // Convex parts lie in the boxes, or out of them by little. Along any direction two convex bodies are apart by
        // no more than their gap (nor overlap less than their depth), and bodies in boxes are apart by at least as
        // much as the boxes.
        for i in 0..3 {
            let apart = between.0[i] - reach.0[i];
            facts.always.push((gap - apart).at_least(-OUT_OF_BOX));
        }
        // Somewhere points of the two are as far apart as the gap; each is in its box, so no farther from its centre
        // than half a diagonal.
        let span = (x.scale.length() + y.scale.length()).scale(0.5);
        let distance = (x.center() - y.center()).length();
        let far = Term::constant(0.0).max(gap);
        facts.always.push((far + span - distance).at_least(-OUT_OF_BOX));
        facts.always.push((distance + span - gap).at_least(-OUT_OF_BOX));
        if facts.usual.is_some() {
            // No two points of them are nearer.
            let (p, q) = (facts.point_of(a), facts.point_of(b));
            facts.always.push(((p - q).length() - gap).at_least(-OUT_OF_BOX));
            facts.spans.push(([a, b], far + span));
            // In a house it would be said of every room.
            if let [region] = facts.regions()[..] {
                let middles = [a, b].map(|object| middle_in_proofs(facts, object, region));
                facts.always.extend(middles);
            }
            between_solids(facts, gap, a, b);
        }
    }
    gap
}

/// What is solid of two upright objects bounds their gap: no two points of them are nearer.
fn between_solids(facts: &mut Unknowns<'_>, gap: Term, a: ObjectId, b: ObjectId) {
    let (thing, other) = (facts.thing(a), facts.thing(b));
    let between = thing.center() - other.center();
    let (length, zero) = (between.length(), Term::constant(0.0));
    let flat = V3([between.0[0], zero, between.0[2]]).length();
    facts.always.push((length - flat).at_least(-OUT_OF_BOX));
    facts.always.push((flat + between.0[1].abs() - length).at_least(-OUT_OF_BOX));
    let (Some(x), Some(y)) = (facts.solid_of(a), facts.solid_of(b)) else { return };
    let is_upright = |t: &ObjectInstance<Term>| t.axes.0[1].0[1].known() == Some(1.0);
    if !is_upright(&x) || !is_upright(&y) {
        return;
    }
    // Each holds a disc about its middle axis, at each of its heights.
    let top = |t: &ObjectInstance<Term>| t.pos.0[1] + t.scale.0[1];
    let over = zero.max(x.pos.0[1] - top(&y)).max(y.pos.0[1] - top(&x));
    let round = |t: &ObjectInstance<Term>| t.scale.0[0].min(t.scale.0[2]).scale(0.5);
    let aside = zero.max(flat - round(&x) - round(&y));
    facts.always.push((aside + over - gap).at_least(-OUT_OF_BOX));
    // Along the axes of the world, each is a box.
    let along = |t: &ObjectInstance<Term>| {
        t.axes.0[0].0.iter().all(|c| c.known().is_some_and(|c| c.abs() < EXACT || c.abs() > 1.0 - EXACT))
    };
    if along(&x) && along(&y) {
        let reach = x.reach() + y.reach();
        let aside = [0, 2].map(|i| zero.max(between.0[i].abs() - reach.0[i]));
        let direct = V3([aside[0], over, aside[1]]).length();
        facts.always.push((direct - gap).at_least(-OUT_OF_BOX));
        facts.always.push((aside[0] + aside[1] + over - gap).at_least(-OUT_OF_BOX));
    }
}

/// Whether the gap between two objects is spoken of in proofs.
pub(crate) fn is_in_proofs(facts: &Unknowns<'_>, a: ObjectId, b: ObjectId) -> bool {
    facts.knows(&name(a, b))
}

fn name(a: ObjectId, b: ObjectId) -> String {
    format!("gap {:?} {:?}", a.min(b), a.max(b))
}

/// The horizontal distance of an object from the walls of a region, in proofs.
fn from_walls_in_proofs(facts: &mut Unknowns<'_>, object: ObjectId, region: RegionId) -> Term {
    let (gap, new) = facts.term(format!("gap {object:?} {region:?}"), ANY);
    if new && facts.is_rectangle(region) {
        // Inside it is the least of the two; outside a corner may be farther off than either, at most √2 times.
        let [x, z] = facts.wall_distances(object, region);
        let least = x.min(z);
        let zero = Term::constant(0.0);
        facts.always.push((least - gap).at_least(-EXACT));
        facts.always.push((gap - zero.max(least) - zero.min(least).scale(1.4143)).at_least(-EXACT));
    }
    gap
}

/// The horizontal distance of a point from the walls of a rectangle, negative outside, in proofs.
fn point_in_proofs(facts: &mut Unknowns<'_>, point: V3<Term>, region: RegionId) -> Term {
    let room = facts.room(region);
    let at = facts.framed(region, point.0[0] - room.pos.0[0], point.0[2] - room.pos.0[2]);
    let from = [0, 1].map(|i| room.scale.0[2 * i].scale(0.5) - at[i].abs());
    let zero = Term::constant(0.0);
    let out = from.map(|f| zero.max(-f));
    let gap = zero.max(from[0].min(from[1])) - (out[0] * out[0] + out[1] * out[1]).sqrt();
    // Where it is not inside, it is beyond one of the walls.
    let beyond = from.map(|f| (-f).at_least(-1e-5));
    facts.always.push(any(&[gap.above(1e-5), beyond[0], beyond[1]]));
    gap
}
