//! `clear(Object, side, depth)`: the space on that side of the box is free to that depth: no other solid reaches into
//! it, and it leaves the object's region neither sideways nor through the ceiling. Lower than 5 cm above the object's
//! base nothing counts (a rug, a sill), except above the object, where all of the space does.

use super::declared::Given;
use super::inside::wall_along;
use super::visible::settled;
use super::{Call, Declared, Semantics, Surroundings, metres};
use crate::eval::{EvalError, Truth};
use crate::number::{Algebra, Number};
use crate::prove::tape::{Claim, Term, all, any};
use crate::prove::unknowns::{Unknowns, claimed};
use crate::world::{Body, ObjectInstance, World};
use scenelang_lang::program::{ObjectId, ObjectSide, Program, RegionId, Unit};
use scenelang_layout::planar::convex_hull;
use scenelang_layout::polygon::Clearance;
use scenelang_layout::{Convex, Nearest, Obb, Prism, Vec2, Vec3, convex, inside_clearance};

/// Below this height above the base nothing stands in the way (metres).
const SILL: f64 = 0.05;

pub(super) struct Clear;

impl Semantics for Clear {
    type Yields<N: Algebra> = Truth<N>;
    const DECLARED: Declared = Declared {
        unit: Unit::Metre,
        wanted: Some(|t| t.contact),
        unwanted: None,
        may_be_infinite: false,
        violation: None,
    };

    fn surroundings(given: &Given<'_>) -> Surroundings {
        Surroundings::Space { owner: given.object(0), side: given.side(1), depth: given.constant(2) }
    }

    fn exact<N: Number>(call: &Call<'_, N>) -> Result<Truth<N>, EvalError> {
        let (id, thing) = call.object(0)?;
        let tolerances = &call.world.options.tolerances;
        let (side, depth) = (call.side(1), call.number(2)?);
        let Some(space) = space(&thing.body, side, depth.value()) else {
            return Ok(Truth::discrete(true));
        };
        let contact = N::constant(tolerances.contact);
        let mut truth = Truth::discrete(true);
        if let Some((blocker, found)) = nearest_body(call.world, &space, id) {
            let gap = N::measured(found.separation.gap, || {
                let Ok(other) = call.world.object(blocker) else { return N::constant(0.0) };
                let normal = found.separation.normal;
                let (p, q) = space.contact(&other.body.solid()[found.parts[1]], &found.separation);
                other.attached(&q).along(&normal) - thing.attached_to_box(&p).along(&normal)
            });
            truth = truth.and(Truth::metres(gap + contact, tolerances.order));
        }
        if let Some((region, prism)) = region_of(call.world, id, side) {
            let (left, wall) = room_left(call.world, id, side, &space, prism);
            let left = N::measured(left, || match (wall, call.world.region(region)) {
                (Some(wall), Ok(room)) => {
                    let at = Vec3::new(wall.at.x, thing.body.obb.center.y, wall.at.y);
                    let way = Vec3::new(wall.inward.x, 0.0, wall.inward.y);
                    thing.attached_to_box(&at).along(&way) - wall_along(room, &wall)
                }
                (_, Ok(room)) => room.pos.0[1] + room.scale.0[1] - (thing.center() + thing.reach()).0[1],
                _ => N::constant(0.0),
            });
            truth = truth.and(Truth::metres(left + contact, tolerances.order));
        }
        settled(call, truth)
    }

    fn bounds(call: &Call<'_, Term>, facts: &mut Unknowns<'_>) -> Result<Option<Truth<Term>>, EvalError> {
        let (id, thing) = call.object(0)?;
        let depth = call.number(2)?;
        let of_door = facts.world.allow.doors.iter().any(|door| door.object == id);
        let mut follow = Vec::new();
        let space = upright_space(thing, call.side(1), depth);
        // Before and behind a door the space is in another region, and begins in a wall.
        if let (Some(space), false) = (&space, of_door) {
            let regions = facts.regions();
            let leaves_none = |r: &RegionId| facts.is_rectangle(*r);
            if !regions.is_empty() && regions.iter().all(leaves_none) {
                let slack = facts.options.tolerances.contact + facts.options.tolerances.order;
                let stays = |r: RegionId| {
                    let distances = facts.wall_distances_of(space, id, r).map(|d| d.at_least(-slack));
                    all(&distances)
                };
                let inside: Vec<Claim> = regions.into_iter().map(stays).collect();
                follow.push(any(&inside));
            }
        }
        let is_upright = thing.axes.0[1].0[1].known() == Some(1.0);
        if call.side(1) == ObjectSide::Above && is_upright && depth.known().is_some_and(|depth| depth > 0.0) {
            // It does not reach through the ceiling of the region, whichever that is.
            let regions = facts.regions();
            let slack = facts.options.tolerances.contact + facts.options.tolerances.order;
            let top = thing.pos.0[1] + thing.scale.0[1] + depth;
            let below = |r: &RegionId| {
                let room = facts.room(*r);
                (room.pos.0[1] + room.scale.0[1] - top).at_least(-slack)
            };
            if !regions.is_empty() {
                follow.push(any(&regions.iter().map(below).collect::<Vec<Claim>>()));
            }
        }
        let claim = facts.open(call.question()?, &follow);
        if let Some(space) = space {
            facts.spaces.push((claim, id, space));
        }
        Ok(Some(claimed(claim)))
    }

    fn words(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        let (id, thing) = call.object(0).ok()?;
        let name = call.name(0, names);
        let side = call.side(1);
        let depth = call.number(2).ok()?;
        let space = space(&thing.body, side, depth)?;
        let beside = match side {
            ObjectSide::Front => "in front of",
            ObjectSide::Behind => "behind",
            ObjectSide::Left => "to the left of",
            ObjectSide::Right => "to the right of",
            ObjectSide::Above => "above",
        };
        let cleared = format!("the {} of space {beside} `{name}`", metres(depth));
        let contact = call.world.options.tolerances.contact;
        if let Some((blocker, found)) = nearest_body(call.world, &space, id)
            && found.separation.gap < -contact
        {
            let blocker = &names.objects[blocker.0 as usize].name;
            return Some(format!("`{blocker}` extends {} into {cleared}", metres(-found.separation.gap)));
        }
        let (region, prism) = region_of(call.world, id, side)?;
        let (left, _) = room_left(call.world, id, side, &space, prism);
        let region = &names.regions[region.0 as usize].name;
        (left < -contact).then(|| format!("{cleared} extends beyond `{region}` by {}", metres(-left)))
    }

    fn in_the_way(call: &Call<'_, f64>) -> Vec<ObjectId> {
        let (Ok((id, thing)), Ok(depth)) = (call.object(0), call.number(2)) else { return Vec::new() };
        let space = space(&thing.body, call.side(1), depth);
        space.and_then(|space| nearest_body(call.world, &space, id)).map(|(id, _)| id).into_iter().collect()
    }
}

/// The axis that a side lies along, and which way.
fn axis_of(side: ObjectSide) -> (usize, f64) {
    match side {
        ObjectSide::Front => (2, 1.0),
        ObjectSide::Behind => (2, -1.0),
        ObjectSide::Left => (0, -1.0),
        ObjectSide::Right => (0, 1.0),
        ObjectSide::Above => (1, 1.0),
    }
}

/// The space beside something that stands upright, in proofs, as a thing of its own, without what is below the sill.
fn upright_space(thing: &ObjectInstance<Term>, side: ObjectSide, depth: Term) -> Option<ObjectInstance<Term>> {
    let (axis, sign) = axis_of(side);
    let upright = thing.axes.0[1].0[1].known() == Some(1.0);
    let (height, depth) = (thing.scale.0[1].known()?, depth.known()?);
    if !upright || side == ObjectSide::Above || depth <= 0.0 || height <= SILL {
        return None;
    }
    let out = (thing.scale.0[axis] + Term::constant(depth)).scale(0.5 * sign);
    let pos = thing.pos + thing.axes.0[axis].times(out) + thing.axes.0[1].times(Term::constant(SILL));
    let mut scale = thing.scale;
    scale.0[axis] = Term::constant(depth);
    scale.0[1] = Term::constant(height - SILL);
    Some(ObjectInstance { pos, scale, ..thing.clone() })
}

/// The space on a side, as a convex body; `None`: nothing is left of it.
fn space(body: &Body, side: ObjectSide, depth: f64) -> Option<Convex> {
    let half = body.obb.half;
    let (axis, sign) = axis_of(side);
    if depth <= 0.0 {
        return None;
    }
    let (mut center, mut extent) = (Vec3::zeros(), half);
    center[axis] = sign * (half[axis] + depth / 2.0);
    extent[axis] = depth / 2.0;
    let whole = Obb { center: body.obb.center + body.obb.axes * center, axes: body.obb.axes, half: extent };
    let sill = body.obb.aabb().min.y + SILL;
    if side == ObjectSide::Above || whole.aabb().min.y >= sill {
        return Some(Convex::from_box(&whole));
    }
    let up = body.obb.axes.column(1);
    if up.y < 1.0 - 1e-12 {
        return Convex::from_box(&whole).above(sill);
    }
    // Upright, as nearly everything is: a lower box.
    let height = 2.0 * half.y - SILL;
    (height > 0.0).then(|| {
        let raised = Obb {
            center: whole.center + up * (SILL / 2.0),
            half: Vec3::new(extent.x, height / 2.0, extent.z),
            ..whole
        };
        Convex::from_box(&raised)
    })
}

/// The other object nearest to the space; the first of equals.
fn nearest_body<N: Number>(world: &World<N>, space: &Convex, own: ObjectId) -> Option<(ObjectId, Nearest)> {
    let others = || world.bodies().filter(|(id, _)| *id != own);
    let bound = |body: &Body| space.aabb().distance_squared(&body.aabb());
    let look = |body: &Body| {
        let (solid, around) = body.bounded();
        convex::nearest_of([(std::slice::from_ref(space), space.aabb()), (solid, &around)])
    };
    // The one whose box is nearest tells which others need a look: few.
    let (first, body) = others().min_by(|(_, a), (_, b)| bound(a).total_cmp(&bound(b)))?;
    let mut best = (first, look(body)?);
    for (id, body) in others().filter(|(id, _)| *id != first) {
        let least = best.1.separation.gap;
        if bound(body).sqrt() > least.max(0.0) {
            continue;
        }
        if let Some(found) = look(body)
            && (found.separation.gap < least || found.separation.gap == least && id < best.0)
        {
            best = (id, found);
        }
    }
    Some(best)
}

/// The region that the space must stay in: the one that best contains the object; before and behind a door the one on
/// that side, if there is one.
pub(crate) fn region_of<N: Number>(world: &World<N>, id: ObjectId, side: ObjectSide) -> Option<(RegionId, &Prism)> {
    let body = &world.object(id).ok()?.body;
    let contact = world.options.tolerances.contact;
    let Some(way) = leaves_door(world, id, side) else {
        // Of several that hold it (a room and its zones) the one that leaves it most room.
        return best_of(world, |prism| {
            let inside = inside_clearance(&body.obb, prism);
            [(inside.least() + contact).min(0.0), inside.horizontal.value]
        });
    };
    let beyond = body.obb.center + way * (body.obb.half.z + 2.0 * world.options.eta + world.options.tolerances.door);
    let fit = |prism: &Prism| prism.polygon.clearance_of_point(Vec2::new(beyond.x, beyond.z)).value;
    best_of(world, |prism| [fit(prism), 0.0]).filter(|(_, prism)| fit(prism) >= -contact)
}

/// The region that fits best and, of those that fit equally well, the largest: a zone has no walls of its own.
fn best_of<N: Number>(world: &World<N>, fit: impl Fn(&Prism) -> [f64; 2]) -> Option<(RegionId, &Prism)> {
    // Lengths are compared as whole micrometres, so that rounding does not decide.
    let key = |prism: &Prism| {
        let [first, then] = fit(prism).map(|metres| (metres * 1e6).round());
        [first, then, prism.area()]
    };
    let best = world.prisms().map(|(region, prism)| (key(prism), region, prism)).max_by(|(a, ..), (b, ..)| {
        let orders = a.iter().zip(b).map(|(x, y)| x.total_cmp(y));
        orders.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
    });
    best.map(|(_, region, prism)| (region, prism))
}

/// For the front and the back of an asserted door: the direction that leads out of it.
fn leaves_door<N: Number>(world: &World<N>, id: ObjectId, side: ObjectSide) -> Option<Vec3> {
    let sign = match side {
        ObjectSide::Front => 1.0,
        ObjectSide::Behind => -1.0,
        _ => return None,
    };
    let front = world.object(id).ok()?.body.obb.axes.column(2) * sign;
    world.allow.doors.iter().any(|door| door.object == id).then_some(front)
}

/// How much is left to the ceiling or, if less, to the wall given; negative where the space leaves the region.
fn room_left<N: Number>(
    world: &World<N>,
    id: ObjectId,
    side: ObjectSide,
    space: &Convex,
    prism: &Prism,
) -> (f64, Option<Clearance>) {
    let ceiling = prism.ceiling - space.aabb().max.y;
    // Before a door the first step is still in the wall: it is no room, and not asked to be.
    let start = leaves_door(world, id, side).and_then(|way| {
        let door = &world.object(id).ok()?.body.obb;
        let wall = 2.0 * world.options.eta + world.options.tolerances.door;
        Some((way, door.center.dot(&way) + door.half.z + wall))
    });
    let outline = space.vertices().iter().map(|v| {
        let step = start.map_or(Vec3::zeros(), |(way, start)| way * (start - v.dot(&way)).max(0.0));
        Vec2::new(v.x + step.x, v.z + step.z)
    });
    let footprint = convex_hull(outline);
    let wall = (footprint.len() > 2).then(|| prism.polygon.clearance(&footprint)).filter(|wall| wall.value < ceiling);
    (wall.map_or(ceiling, |wall| wall.value), wall)
}
