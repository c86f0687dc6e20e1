//! `inside(Object, Region)`: the least of three clearances of the box: from the walls, above the floor, below the
//! ceiling. `inside(Object, Object)`: the least clearance of the box's corners from the faces of the other box.

use super::declared::Given;
use super::{Call, Declared, Semantics, Surroundings, metres};
use crate::coded::Boxes;
use crate::eval::{EvalError, Truth};
use crate::number::{Algebra, Number};
use crate::prove::tape::{Claim, Term, all, implies};
use crate::prove::unknowns::{EXACT, Unknowns, claimed};
use crate::tolerances::Tolerances;
use crate::vector::V3;
use crate::world::{ObjectInstance, RegionInstance, World};
use scenelang_lang::program::{Arg, ObjectId, Program, RegionId, Unit};
use scenelang_layout::planar::nearest_on_segment;
use scenelang_layout::polygon::Clearance;
use scenelang_layout::{Obb, Prism, Vec2, Vec3, inside_clearance};

/// A zone may reach into the walls of its room by so much (metres).
const ZONE: f64 = 0.05;

pub(super) struct Inside;

impl Semantics for Inside {
    type Yields<N: Algebra> = Truth<N>;
    const DECLARED: Declared = Declared {
        unit: Unit::Metre,
        wanted: Some(|t| t.contact),
        unwanted: None,
        may_be_infinite: false,
        violation: None,
    };

    fn surroundings(_given: &Given<'_>) -> Surroundings {
        Surroundings::Nothing
    }

    fn exact<N: Number>(call: &Call<'_, N>) -> Result<Truth<N>, EvalError> {
        let tolerances = &call.world.options.tolerances;
        let (_, thing) = call.object(0)?;
        Ok(match call.args.get(1) {
            Some(Arg::Object(_)) => in_box(thing, call.object(1)?.1, tolerances),
            _ => in_region(thing, call.region(1)?.1, tolerances),
        })
    }

    fn bounds(call: &Call<'_, Term>, facts: &mut Unknowns<'_>) -> Result<Option<Truth<Term>>, EvalError> {
        let (object, thing) = call.object(0)?;
        Ok(Some(match call.args.get(1) {
            Some(Arg::Object(_)) => in_box(thing, call.object(1)?.1, &call.world.options.tolerances),
            _ => claimed(in_proofs(facts, object, call.region(1)?.0)),
        }))
    }

    fn fast(call: &Call<'_, Term>, boxes: &mut Boxes<'_, '_>) -> Result<Option<Truth<Term>>, EvalError> {
        let (_, thing) = call.object(0)?;
        let tolerances = &call.world.options.tolerances;
        Ok(match call.args.get(1) {
            Some(Arg::Object(_)) => Some(in_box(thing, call.object(1)?.1, tolerances)),
            _ => {
                let (_, room) = call.region(1)?;
                let aside = clearance_in_convex(thing, room).or_else(|| boxes.clearance(thing, room));
                aside.map(|aside| with_heights(aside, thing, room, tolerances))
            }
        })
    }

    fn words(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        let (_, thing) = call.object(0).ok()?;
        let name = call.name(0, names);
        if let Some(Arg::Object(outer)) = call.args.get(1) {
            let least = thing.body.obb.clearance_in(&call.world.object(*outer).ok()?.body.obb);
            let outer = call.name(1, names);
            return Some(if least < 0.0 {
                format!("`{name}` sticks out of `{outer}` by {}", metres(-least))
            } else {
                format!("`{name}` is {} from the nearest face of `{outer}`", metres(least))
            });
        }
        let (_, room) = call.region(1).ok()?;
        let region = call.name(1, names);
        let inside = inside_clearance(&thing.body.obb, &room.prism);
        let least = inside.least();
        // Who is told so does not want it there, and has no use for how near it is to the floor.
        if least >= 0.0 {
            return Some(format!("`{name}` is inside `{region}`"));
        }
        let place = if least == inside.horizontal.value {
            edge_of(call.world, &room.prism)
        } else if least == inside.floor {
            "the floor"
        } else {
            "the ceiling"
        };
        Some(format!("`{name}` extends {} beyond {place} of `{region}`", metres(-least)))
    }
}

/// What a region ends with at its sides: a zone of a room has no walls.
fn edge_of(world: &World<f64>, region: &Prism) -> &'static str {
    let around = |other: &Prism| {
        other.polygon.area() > region.polygon.area()
            && region.polygon.edges().all(|(corner, _)| other.polygon.clearance_of_point(corner).value >= -ZONE)
    };
    if world.prisms().any(|(_, other)| around(other)) { "the edge" } else { "a wall" }
}

/// Whether the box of an object is in a region.
pub fn in_region<N: Number>(thing: &ObjectInstance<N>, room: &RegionInstance<N>, tolerances: &Tolerances) -> Truth<N> {
    let [floor, ceiling] = heights(thing, room);
    let least = clearance_in_region(thing, room).min(floor).min(ceiling);
    Truth::metres(least + N::constant(tolerances.contact), tolerances.order)
}

/// How far the box of an object is above the floor of a region, and below its ceiling.
pub(super) fn heights<N: Algebra>(thing: &ObjectInstance<N>, room: &RegionInstance<N>) -> [N; 2] {
    let (center, reach) = (thing.center(), thing.reach());
    [(center - reach).0[1] - room.pos.0[1], room.pos.0[1] + room.scale.0[1] - (center + reach).0[1]]
}

/// The same of a box whose clearance from the walls is known, as code takes it.
fn with_heights(
    aside: Term,
    thing: &ObjectInstance<Term>,
    room: &RegionInstance<Term>,
    tolerances: &Tolerances,
) -> Truth<Term> {
    let [floor, ceiling] = heights(thing, room);
    let least = floor.min(ceiling).min(aside);
    Truth::metres(least + Term::constant(tolerances.contact), tolerances.order)
}

/// The horizontal clearance of an object's box from the walls of a region, negative outside, without tolerance.
pub(super) fn clearance_in_region<N: Number>(thing: &ObjectInstance<N>, room: &RegionInstance<N>) -> N {
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

/// How a point of the footprint of a box moves along a direction in the plane, with the box.
pub(super) fn moving<N: Number>(thing: &ObjectInstance<N>, at: Vec2, way: Vec2) -> N {
    thing.attached_to_box(&over(&thing.body.obb, at)).along(&Vec3::new(way.x, 0.0, way.y))
}

/// The nearest point of the wall, along the way in.
pub(super) fn wall_along<N: Number>(room: &RegionInstance<N>, clearance: &Clearance) -> N {
    let [x, z] = room.attached(clearance.wall.x, clearance.wall.y);
    x.scale(clearance.inward.x) + z.scale(clearance.inward.y)
}

/// Whether the box of an object is in the box of another.
pub(crate) fn in_box<N: Algebra>(
    thing: &ObjectInstance<N>,
    outer: &ObjectInstance<N>,
    tolerances: &Tolerances,
) -> Truth<N> {
    let between = thing.center() - outer.center();
    let clearance = |axis: usize| {
        let way = outer.axes.0[axis];
        let reach = |own: usize| way.dot(thing.axes.0[own]).abs() * thing.scale.0[own].scale(0.5);
        outer.scale.0[axis].scale(0.5) - way.dot(between).abs() - (reach(0) + reach(1) + reach(2))
    };
    let least = clearance(0).min(clearance(1)).min(clearance(2));
    Truth::metres(least + N::constant(tolerances.contact), tolerances.order)
}

/// Whether an object is in a region, in proofs: exact for a rectangle; of another outline only floor and ceiling are
/// known.
pub(crate) fn in_proofs(facts: &mut Unknowns<'_>, object: ObjectId, region: RegionId) -> Claim {
    let (thing, room) = (facts.thing(object), facts.room(region));
    let tolerances = facts.options.tolerances;
    let contact = Term::constant(tolerances.contact);
    let mut parts = heights(&thing, &room).to_vec();
    let rectangle = facts.is_rectangle(region);
    if rectangle {
        parts.extend(facts.wall_distances(object, region));
    }
    let parts: Vec<Claim> = parts.iter().map(|p| (*p + contact).at_least(-tolerances.order)).collect();
    if rectangle { all(&parts) } else { facts.open(format!("inside {object:?} {region:?}"), &parts) }
}

/// However an upright box is turned inside a rectangle, its middle is as far from the walls as half of its shorter side. That
/// follows from its turn, but not without looking at each.
pub(super) fn middle_in_proofs(facts: &mut Unknowns<'_>, object: ObjectId, region: RegionId) -> Claim {
    let (thing, room) = (facts.thing(object), facts.room(region));
    let is_turned = thing.axes.0[0].0.iter().any(|c| c.known().is_none());
    if thing.axes.0[1].0[1].known() != Some(1.0) || !is_turned || !facts.is_rectangle(region) {
        return Claim::TRUE;
    }
    let slack = facts.options.tolerances.contact + facts.options.tolerances.order;
    let between = thing.center() - room.pos;
    let at = facts.framed(region, between.0[0], between.0[2]);
    let least = thing.scale.0[0].min(thing.scale.0[2]).scale(0.5);
    let from = [0, 1].map(|i| (room.scale.0[2 * i].scale(0.5) - at[i].abs() - least).at_least(-slack - EXACT));
    implies(in_proofs(facts, object, region), all(&from))
}

/// The least clearance of a box from the planes of the walls of a convex region. That is what
/// [`in_region`] measures of what is inside; of what is outside both say so.
fn clearance_in_convex(thing: &ObjectInstance<Term>, room: &RegionInstance<Term>) -> Option<Term> {
    let polygon = &room.prism.polygon;
    if !polygon.is_convex() {
        return None;
    }
    let center = thing.center();
    let mut least = Term::constant(f64::INFINITY);
    for (a, b) in polygon.edges() {
        let along = (b - a).normalize();
        // The inside is on the left of the way from x towards z.
        let inward = Vec3::new(-along.y, 0.0, along.x);
        let own = |axis: usize| thing.axes.0[axis].along(&inward).abs() * thing.scale.0[axis].scale(0.5);
        let level = Term::constant(inward.x * a.x + inward.z * a.y);
        // A wall along an axis of the world is shown as far as the box reaches along it.
        let reach = own(0) + own(1) + own(2);
        least = least.min(center.along(&inward) - reach - level);
    }
    Some(least)
}
