//! The signed gap of two convex bodies, and where it is attained.
//!
//! For a unit direction n let g(n) be the least height of b over the greatest height of a, heights taken along n. The
//! signed gap is the greatest g(n): the distance where the bodies are apart, minus the least way out where they overlap.

use crate::Vec3;
use crate::planar::{Vec2, convex_hull, convex_overlap, nearest_of_segments};

/// The signed gap of two convex bodies a and b.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Separation {
    /// Metres: distance (≥ 0), or minus the penetration depth.
    pub gap: f64,
    /// Unit direction from a to b that attains it: moving b along it widens the gap one for one.
    pub normal: Vec3,
}

impl Separation {
    /// The same gap seen from b.
    pub fn flipped(self) -> Self {
        Self { normal: -self.normal, ..self }
    }
}

/// Points p of a and q of b with q - p = gap · normal, in the middle of where the bodies would touch if b were moved by
/// -gap · normal. The gap's rate of change under any motion of the bodies is normal · (velocity of q - velocity of p).
///
/// `a` and `b` are the corners of the bodies' features: those highest along the normal, and those lowest.
pub fn contact(a: &[Vec3], b: &[Vec3], separation: &Separation) -> (Vec3, Vec3) {
    let n = separation.normal;
    let u = if n.x.abs() < 0.6 { n.cross(&Vec3::x()) } else { n.cross(&Vec3::y()) }.normalize();
    let v = n.cross(&u);
    let flat = |points: &[Vec3]| convex_hull(points.iter().map(|p| Vec2::new(p.dot(&u), p.dot(&v))));
    let (flat_a, flat_b) = (flat(a), flat(b));
    let overlap = convex_overlap(&flat_a, &flat_b);
    let middle = if overlap.is_empty() {
        nearest_corners(&flat_a, &flat_b)
    } else {
        overlap.iter().sum::<Vec2>() / overlap.len() as f64
    };
    let height = a.iter().map(|p| p.dot(&n)).fold(f64::NEG_INFINITY, f64::max);
    let p = u * middle.x + v * middle.y + n * height;
    (p, p + n * separation.gap)
}

/// Between the outlines where they come nearest: rounding can part features that touch in exact arithmetic.
fn nearest_corners(a: &[Vec2], b: &[Vec2]) -> Vec2 {
    let mut best = (f64::INFINITY, Vec2::zeros());
    for (i, p) in a.iter().enumerate() {
        for (j, q) in b.iter().enumerate() {
            let (x, y) = nearest_of_segments([p, &a[(i + 1) % a.len()]], [q, &b[(j + 1) % b.len()]]);
            if (x - y).norm() < best.0 {
                best = ((x - y).norm(), (x + y) / 2.0);
            }
        }
    }
    best.1
}

/// The points highest along `n`, within a hair.
pub(crate) fn highest(points: &[Vec3], n: &Vec3) -> Vec<Vec3> {
    let top = points.iter().map(|p| p.dot(n)).fold(f64::NEG_INFINITY, f64::max);
    points.iter().copied().filter(|p| p.dot(n) >= top - 1e-7).collect()
}

/// An upright box in world axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Least corner.
    pub min: Vec3,
    /// Greatest corner.
    pub max: Vec3,
}

impl Aabb {
    /// The smallest that holds the points; of no points inside out.
    pub fn of(points: impl IntoIterator<Item = Vec3>) -> Self {
        let empty = Self { min: Vec3::repeat(f64::INFINITY), max: Vec3::repeat(f64::NEG_INFINITY) };
        points.into_iter().fold(empty, |b, p| Self { min: b.min.inf(&p), max: b.max.sup(&p) })
    }
    /// The smallest that holds both.
    pub fn cover(&self, other: &Self) -> Self {
        Self { min: self.min.inf(&other.min), max: self.max.sup(&other.max) }
    }
    /// The distance between two, 0 where they overlap: never more than the gap of what they hold.
    pub fn distance(&self, other: &Self) -> f64 {
        self.distance_squared(other).sqrt()
    }
    pub fn distance_squared(&self, other: &Self) -> f64 {
        (self.min - other.max).sup(&(other.min - self.max)).sup(&Vec3::zeros()).norm_squared()
    }
}
