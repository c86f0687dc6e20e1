//! Solids of placed objects: the union of their parts, or their box.

use super::{Convex, separation};
use crate::separation::{Aabb, Separation};
use crate::{Obb, Placement, Vec3, rotation};
use nalgebra::Matrix3;

/// How far the common box of the parts may differ from the object's box at any face, in metres.
const PARTS_TOLERANCE: f64 = 1e-3;

/// A little more than one: what is greater than another by this factor is so whatever is rounded.
const ROUNDED: f64 = 1.0 + 1e-12;

/// What stands for an object where solids meet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Geometry {
    /// Its parts where it has them and they fill its box, else its box.
    #[default]
    Parts,
    Box,
}

/// Whether the parts describe bodies whose common box is that of the object, within 1 mm at every face.
/// True without parts.
pub fn parts_fill_box(placement: &Placement) -> bool {
    placement.parts.is_empty() || local_parts(placement).is_some()
}

/// The bodies of the parts, where there are some and they fill the box.
fn local_parts(placement: &Placement) -> Option<Vec<Convex>> {
    let bodies: Vec<Convex> = placement.parts.iter().map(Convex::from_part).collect::<Option<_>>()?;
    let common = bodies.iter().map(|b| *b.aabb()).reduce(|a, b| a.cover(&b))?;
    let own = local_box(placement).aabb();
    // A hair more than a millimetre, so that exactly one passes whatever the rounding.
    let near = |a: Vec3, b: Vec3| (a - b).amax() <= PARTS_TOLERANCE + 1e-9;
    (near(common.min, own.min) && near(common.max, own.max)).then_some(bodies)
}

fn local_box(placement: &Placement) -> Obb {
    let half = placement.scale / 2.0;
    Obb { center: Vec3::new(0.0, half.y, 0.0), axes: Matrix3::identity(), half }
}

/// The solid of an object in its own frame (origin: its `pos`). Parts that do not fill the box have no say.
pub fn local_solid(placement: &Placement, geometry: Geometry) -> Vec<Convex> {
    let parts = match geometry {
        Geometry::Parts => local_parts(placement),
        Geometry::Box => None,
    };
    parts.unwrap_or_else(|| vec![Convex::from_box(&local_box(placement))])
}

/// The solid of an object in the world. Parts that do not fill the box have no say.
pub fn solid(placement: &Placement, geometry: Geometry) -> Vec<Convex> {
    let axes = rotation::matrix(placement.rot);
    local_solid(placement, geometry).iter().map(|c| c.moved(&axes, &placement.pos)).collect()
}

/// The least gap of two solids, and the parts that have it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// The gap, from the part of the first solid to that of the second.
    pub separation: Separation,
    /// Index of a part of either solid.
    pub parts: [usize; 2],
}

/// The least signed gap over pairs of parts; `None` only where a solid has no part.
pub fn nearest(a: &[Convex], b: &[Convex]) -> Option<Nearest> {
    nearest_of([(a, &aabb(a)), (b, &aabb(b))])
}

/// The same of solids that are given with the upright boxes around them, as [`aabb`] finds them.
pub fn nearest_of(solids: [(&[Convex], &Aabb); 2]) -> Option<Nearest> {
    let [(a, _), (b, _)] = solids;
    // The pair whose boxes are nearest tells which others need a look; these are few, and only they are sorted.
    let mut facing = Vec::new();
    let first = nearest_boxes(solids, &mut facing)?;
    let of = |[i, j]: [usize; 2]| (&a[i], &b[j]);
    let look = |parts: [usize; 2]| {
        let (x, y) = of(parts);
        Nearest { separation: separation(x, y), parts }
    };
    let mut best = look(first);
    let mut pairs = pairs_within(solids, best.separation.gap.max(0.0), &mut facing);
    pairs.sort_by(|x, y| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1)));
    for (bound, parts) in pairs {
        if bound > best.separation.gap.max(0.0) {
            break;
        }
        let (x, y) = of(parts);
        if parts == first || x.is_apart(y, best.separation.gap) {
            continue;
        }
        let next = look(parts);
        if next.separation.gap < best.separation.gap {
            best = next;
        }
    }
    Some(best)
}

/// Those parts, by their index, whose upright boxes are no farther from another box than the root of `most`.
fn within(parts: &[Convex], to: &Aabb, most: f64, found: &mut Vec<usize>) {
    found.clear();
    found.extend((0..parts.len()).filter(|&i| parts[i].aabb().distance_squared(to) <= most));
}

/// The parts whose upright boxes are nearest to each other; the first of equals.
fn nearest_boxes([(a, over), (b, around)]: [(&[Convex], &Aabb); 2], facing: &mut Vec<usize>) -> Option<[usize; 2]> {
    let mut best: Option<(f64, [usize; 2])> = None;
    // The part of `a` that is nearest to all of `b` is near one of its parts: no farther is the nearest pair, which spares
    // most others a look. What is farther by more than rounding is told from the squares.
    let near = least(a, around)?;
    let mut most = b.iter().map(|y| near.aabb().distance_squared(y.aabb())).fold(f64::INFINITY, f64::min) * ROUNDED;
    within(b, over, most, facing);
    for (i, x) in a.iter().enumerate() {
        if x.aabb().distance_squared(around) > most {
            continue;
        }
        for &j in facing.iter() {
            let squared = x.aabb().distance_squared(b[j].aabb());
            if squared <= most && best.is_none_or(|(least, _)| squared.sqrt() < least) {
                best = Some((squared.sqrt(), [i, j]));
                most = squared * ROUNDED;
            }
        }
    }
    best.map(|(_, parts)| parts)
}

/// The part whose upright box is nearest to another box.
fn least<'a>(parts: &'a [Convex], to: &Aabb) -> Option<&'a Convex> {
    let mut best: Option<(f64, &Convex)> = None;
    for part in parts {
        let squared = part.aabb().distance_squared(to);
        if best.is_none_or(|(least, _)| squared < least) {
            best = Some((squared, part));
        }
    }
    best.map(|(_, part)| part)
}

/// The pairs of parts whose upright boxes are no farther apart than `most` (metres), with how far they are.
fn pairs_within(
    [(a, over), (b, around)]: [(&[Convex], &Aabb); 2],
    most: f64,
    facing: &mut Vec<usize>,
) -> Vec<(f64, [usize; 2])> {
    let mut pairs = Vec::new();
    let squared = most * most * ROUNDED;
    within(b, over, squared, facing);
    for (i, x) in a.iter().enumerate().filter(|(_, x)| x.aabb().distance_squared(around) <= squared) {
        for &j in facing.iter() {
            let apart = x.aabb().distance_squared(b[j].aabb());
            if apart <= squared && apart.sqrt() <= most {
                pairs.push((apart.sqrt(), [i, j]));
            }
        }
    }
    pairs
}

/// The smallest upright box that holds a solid.
pub fn aabb(solid: &[Convex]) -> Aabb {
    solid.iter().map(|c| *c.aabb()).fold(Aabb::of([]), |a, b| a.cover(&b))
}
