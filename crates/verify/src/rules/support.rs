//! P-SUPPORT: the lowest points of a solid rest on a floor or on level tops of other solids, and the centre of the box,
//! projected down, lies in the convex hull of these contacts.

use crate::eval::{Cause, Truth};
use crate::number::Number;
use crate::tolerances::Tolerances;
use crate::world::{Body, World};
use scenelang_lang::program::ObjectId;
use scenelang_layout::planar::{convex_hull, convex_overlap, depth_in_convex};
use scenelang_layout::{Convex, Face, Vec2, Vec3};
use std::cell::OnceCell;

/// How an object rests, measured on plain floats.
#[derive(Clone, Debug, PartialEq)]
pub struct Rest {
    /// Height of the lowest point of the solid.
    pub lowest: f64,
    /// Of what could carry it, the height nearest to that.
    pub nearest: f64,
    /// What that belongs to; `None`: a floor.
    pub carrier: Option<ObjectId>,
    /// Distance of the centre, projected down, to the hull of the contacts; `None`: there is no contact.
    pub off: Option<f64>,
}

impl Rest {
    /// Whether it is supported, and by how much.
    pub fn truth(&self, tolerances: &Tolerances) -> Truth<f64> {
        let height = tolerances.support - (self.lowest - self.nearest).abs();
        let balance = self.off.map_or(height, |off| tolerances.contact - off);
        Truth::metres(height.min(balance), tolerances.order)
    }
}

/// Whether an object rests on something. Others that may carry it are those near it.
///
/// # Errors
/// The layout lacks the object.
pub fn object<N: Number>(world: &World<N>, id: ObjectId) -> Result<Truth<N>, Cause> {
    among(world, id, &others(world, id))
}

/// All other objects that are there.
pub fn others<N: Number>(world: &World<N>, id: ObjectId) -> Vec<ObjectId> {
    world.bodies().map(|(other, _)| other).filter(|other| *other != id).collect()
}

/// Whether an object rests on a floor or on some of `others`.
///
/// # Errors
/// The layout lacks the object.
pub fn among<N: Number>(world: &World<N>, id: ObjectId, others: &[ObjectId]) -> Result<Truth<N>, Cause> {
    let thing = world.object(id)?;
    let rest = rest(world, id, others)?;
    let truth = rest.truth(&world.options.tolerances);
    let margin = N::measured(truth.margin, || {
        // Up or down to what is nearest; how it balances is known only as a value.
        let carrier = rest.carrier.and_then(|c| world.object(c).ok());
        let below = carrier.map_or(N::constant(rest.nearest), |c| {
            let at = Vec3::new(thing.body.obb.center.x, rest.nearest, thing.body.obb.center.z);
            c.attached(&at).0[1]
        });
        let error = (thing.center() - thing.reach()).0[1] - below;
        if rest.lowest < rest.nearest { error } else { -error }
    });
    Ok(Truth { margin, holds: truth.holds, unit: truth.unit })
}

/// How an object rests on a floor or on some of `others`.
///
/// # Errors
/// The layout lacks the object.
pub fn rest<N: Number>(world: &World<N>, id: ObjectId, others: &[ObjectId]) -> Result<Rest, Cause> {
    let tolerances = &world.options.tolerances;
    let body = &world.object(id)?.body;
    let lowest = body.lowest();
    let center = Vec2::new(body.obb.center.x, body.obb.center.z);
    let slices = || body.solid().iter().filter_map(|part| slice(part, lowest + tolerances.support));
    let base: OnceCell<Vec<Vec<Vec2>>> = OnceCell::new();
    let mut found = Rest { lowest, nearest: f64::NAN, carrier: None, off: None };
    let mut contacts: Vec<Vec2> = Vec::new();
    let mut nearest = f64::NAN;
    let mut consider = |height: f64, carrier: Option<ObjectId>, nearest: &mut f64| {
        if nearest.is_nan() || (lowest - height).abs() < (lowest - *nearest).abs() {
            *nearest = height;
            (found.nearest, found.carrier) = (height, carrier);
        }
    };
    for height in floors(world, center) {
        consider(height, None, &mut nearest);
        if (lowest - height).abs() <= tolerances.support + tolerances.order {
            contacts.extend(slices().flatten());
        }
    }
    let tops = others.iter().filter_map(|&other| Some((other, &world.object(other).ok()?.body)));
    for (other, carrier) in tops.filter(|(other, carrier)| *other != id && below(body, carrier)) {
        for (part, face) in level_tops(carrier, tolerances.level) {
            // No nearer than what is known, and too far to touch: nothing of it counts. Most of what is in one place is.
            let far = from_face(lowest, part, face);
            if far > tolerances.support + tolerances.order + 1e-9 && far >= (lowest - nearest).abs() {
                continue;
            }
            let top = outline(part, face);
            for own in base.get_or_init(|| slices().map(convex_hull).collect()) {
                for point in convex_overlap(own, &top) {
                    let height = height_at(part, face, point);
                    consider(height, Some(other), &mut nearest);
                    if (lowest - height).abs() <= tolerances.support + tolerances.order {
                        contacts.push(point);
                    }
                }
            }
        }
    }
    let hull = convex_hull(contacts);
    found.off = (!hull.is_empty()).then(|| (-depth_in_convex(&hull, center)).max(0.0));
    Ok(found)
}

/// Heights of the floors under a point: those of the regions that hold it, else 0.
fn floors<N: Number>(world: &World<N>, center: Vec2) -> Vec<f64> {
    let holds = |prism: &scenelang_layout::Prism| {
        prism.polygon.clearance_of_point(center).value >= -world.options.tolerances.contact
    };
    let floors: Vec<f64> = world.prisms().filter(|(_, prism)| holds(prism)).map(|(_, prism)| prism.floor).collect();
    if floors.is_empty() { vec![0.0] } else { floors }
}

/// Whether the one is over the other, seen from above.
fn below(body: &Body, carrier: &Body) -> bool {
    let (a, b) = (body.aabb(), carrier.aabb());
    a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.z <= b.max.z && b.min.z <= a.max.z
}

/// What of a convex part is no higher than `height`, seen from above: points whose hull it is.
fn slice(part: &Convex, height: f64) -> Option<Vec<Vec2>> {
    if part.aabb().min.y > height {
        return None;
    }
    let corners = part.vertices().iter().copied().filter(|corner| corner.y <= height);
    let cut = part.edges().filter_map(|[a, b]| {
        let t = (height - a.y) / (b.y - a.y);
        (t > 0.0 && t < 1.0).then(|| a + (b - a) * t)
    });
    Some(corners.chain(cut).map(|p| Vec2::new(p.x, p.z)).collect())
}

/// Faces of a solid that point up, to within some degrees.
fn level_tops(body: &Body, degrees: f64) -> impl Iterator<Item = (&Convex, &Face)> {
    let up = degrees.to_radians().cos() - 1e-12;
    body.solid()
        .iter()
        .flat_map(move |part| part.faces().iter().filter(move |face| face.normal.y >= up).map(move |face| (part, face)))
}

/// How far a height is from those of a face.
fn from_face(height: f64, part: &Convex, face: &Face) -> f64 {
    let (low, high) = part
        .face_corners(face)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), c| (c.y.min(low), c.y.max(high)));
    (low - height).max(height - high).max(0.0)
}

fn outline(part: &Convex, face: &Face) -> Vec<Vec2> {
    convex_hull(part.face_corners(face).map(|c| Vec2::new(c.x, c.z)))
}

/// The height of a level face at a point.
fn height_at(part: &Convex, face: &Face, point: Vec2) -> f64 {
    let Some(corner) = part.face_corners(face).next() else { return f64::NAN };
    let n = face.normal;
    corner.y - (n.x * (point.x - corner.x) + n.z * (point.y - corner.z)) / n.y
}
