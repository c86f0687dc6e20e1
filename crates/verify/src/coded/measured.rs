//! What code cannot say in sums and products, measured on boxes: gaps, and clearances in rooms of any outline.
//!
//! Signs are those of the evaluator. Of what overlaps, or leaves a room, the size is that of the nearest way out, which
//! is what a search asks for.

use crate::world::Body;
use scenelang_layout::convex::Convex;
use scenelang_layout::planar::nearest_on_segment;
use scenelang_layout::rotation::matrix;
use scenelang_layout::{Polygon, Vec2, Vec3};
use std::sync::Arc;

/// Something measured on numbers.
#[derive(Clone, Debug)]
pub(super) enum Measured {
    /// The gap of two upright things made of these blocks, from x, y, z of the centre, sine and cosine of each.
    Gap([Arc<[Block]>; 2]),
    /// The clearance of an upright box with half this width and depth from the walls of a room, from x, z of its
    /// centre, sine and cosine.
    Clearance(Arc<Polygon>, [f64; 2]),
    /// How deep a point is within an outline, from its x and z.
    Depth(Arc<Polygon>),
}

/// So many pairs of parts are looked at in the time of a step: most are too far apart to matter.
const PAIRS: usize = 4;

impl Measured {
    /// How many steps it takes beside its own.
    pub(super) fn steps(&self) -> usize {
        match self {
            Self::Gap([a, b]) => a.len() * b.len() / PAIRS,
            Self::Clearance(..) | Self::Depth(_) => 0,
        }
    }

    /// Its value, from the numbers it asks for.
    pub fn of(&self, input: impl Fn(usize) -> f64) -> f64 {
        match self {
            Self::Gap(things) => {
                let at = |k: usize| Flat {
                    at: [input(5 * k), input(5 * k + 2)],
                    turn: [input(5 * k + 3), input(5 * k + 4)],
                    half: [0.0; 2],
                };
                let frames = [at(0), at(1)];
                gap([(&things[0], &frames[0], input(1)), (&things[1], &frames[1], input(6))], |upright, aside| {
                    if upright > 0.0 && aside > 0.0 { length(upright, aside) } else { upright.max(aside) }
                })
            }
            Self::Clearance(polygon, half) => {
                Flat { at: [input(0), input(1)], turn: [input(2), input(3)], half: *half }.clearance(polygon)
            }
            Self::Depth(polygon) => depth(polygon, Vec2::new(input(0), input(1))),
        }
    }
}

/// A part of a thing as an upright box or cylinder in the thing's frame, the middle of its box the origin (metres).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Its middle.
    pub at: [f64; 3],
    /// Half its extents.
    pub half: [f64; 3],
    /// Of the circle around it, seen from above.
    radius: f64,
    /// Whether it is that circle.
    is_round: bool,
}

impl Block {
    /// One with this middle and half these extents.
    pub fn new(at: [f64; 3], half: [f64; 3]) -> Self {
        Self { at, half, radius: half[0].hypot(half[2]), is_round: false }
    }

    /// The box or, if it is round, the cylinder around a part: it is never less than the part.
    fn around(part: &Convex, middle: Vec3) -> Self {
        let (min, max) = (part.aabb().min, part.aabb().max);
        let (at, half) = ((min + max) / 2.0, (max - min) / 2.0);
        let block = Self::new((at - middle).into(), half.into());
        let from_axis = |v: &Vec3| (v.x - at.x).hypot(v.z - at.z);
        let radii = part.vertices().iter().map(from_axis);
        let (least, most) = radii.fold((f64::INFINITY, 0.0_f64), |(low, high), r| (low.min(r), high.max(r)));
        let is_round = part.vertices().len() >= 2 * ROUND && most > THICK && most - least < 1e-6;
        if is_round { Self { radius: most, is_round, ..block } } else { block }
    }

    /// How far it is from another one on the floor, each given with what it covers there: their distance or, negative, a shift
    /// that would part them. If that is no less than `most`, anything from there on.
    fn aside(&self, here: &Flat, other: &Self, there: &Flat, most: f64) -> f64 {
        match (self.is_round, other.is_round) {
            (false, false) => here.gap_below(there, most),
            (true, true) => length(here.at[0] - there.at[0], here.at[1] - there.at[1]) - self.radius - other.radius,
            (true, false) => there.signed_distance(here.at) - self.radius,
            (false, true) => here.signed_distance(there.at) - other.radius,
        }
    }

    /// What it covers of the floor where the thing stands, whose rectangle is given.
    pub fn flat(&self, thing: &Flat) -> Flat {
        let [x, _, z] = self.at;
        Flat { at: thing.point([x, z]), turn: thing.turn, half: [self.half[0], self.half[2]] }
    }
}

/// What is round has at least so many corners, at its bottom and at its top.
const ROUND: usize = 12;
/// Around what is thinner a box is good enough (metres from its axis).
const THICK: f64 = 0.15;

/// What a body is made of, each part as what is around it. A body without parts is one block.
pub fn blocks(body: &Body) -> Arc<[Block]> {
    let half = body.obb.half;
    let Some(parts) = body.parts() else { return [Block::new([0.0; 3], half.into())].into() };
    let middle = Vec3::new(0.0, half.y, 0.0);
    parts.iter().map(|part| Block::around(part, middle)).collect()
}

/// A body that leans by these turns about x and z (degrees): the box around it from the middle of its bottom face, least and
/// greatest, in a frame that has its yaw only; and its parts, each as the box around it, the middle of that box the origin.
pub fn leaning(body: &Body, [x, z]: [f64; 2]) -> ([[f64; 3]; 2], Arc<[Block]>) {
    let axes = matrix(Vec3::new(x, 0.0, z));
    let around = |points: &mut dyn Iterator<Item = Vec3>| {
        let none = (Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY));
        points.fold(none, |(min, max), point| {
            let there = axes * point;
            (min.inf(&there), max.sup(&there))
        })
    };
    let half = body.obb.half;
    let signs = [-1.0, 1.0];
    let mut corners = signs
        .iter()
        .flat_map(|a| signs.map(|b| [*a, b]))
        .flat_map(|[a, b]| [0.0, 2.0].map(|up| Vec3::new(a * half.x, up * half.y, b * half.z)));
    let (min, max) = around(&mut corners);
    let middle = (min + max) / 2.0;
    let block = |(min, max): (Vec3, Vec3)| Block::new(((min + max) / 2.0 - middle).into(), ((max - min) / 2.0).into());
    let blocks = match body.parts() {
        Some(parts) => parts.iter().map(|part| block(around(&mut part.vertices().iter().copied()))).collect(),
        None => [block((min, max))].into(),
    };
    ([min.into(), max.into()], blocks)
}

/// The least gap between blocks of two things, each given with where it stands and the height of its middle; what is
/// between two blocks is made of how far they are apart upright and aside.
pub fn gap(things: [(&[Block], &Flat, f64); 2], between: impl Fn(f64, f64) -> f64) -> f64 {
    let [(one, here, low), (other, there, high)] = things;
    let others: Vec<Flat> = other.iter().map(|b| b.flat(there)).collect();
    let mut least = f64::INFINITY;
    for a in one {
        let flat = a.flat(here);
        for (b, other) in other.iter().zip(&others) {
            let upright = (low + a.at[1] - high - b.at[1]).abs() - a.half[1] - b.half[1];
            // Between the circles around them there is no more than between them.
            let (dx, dz, reach) = (flat.at[0] - other.at[0], flat.at[1] - other.at[1], least + a.radius + b.radius);
            if upright < least && (dx * dx + dz * dz < reach * reach || least <= 0.0) {
                least = least.min(between(upright, a.aside(&flat, b, other, least)));
            }
        }
    }
    least
}

/// The length of a vector of metres. `hypot` takes longer, because it guards against numbers that no room has.
fn length(a: f64, b: f64) -> f64 {
    (a * a + b * b).sqrt()
}

/// A rectangle on the floor.
#[derive(Clone, Copy, Debug)]
pub struct Flat {
    /// Its middle: x and z (metres).
    pub at: [f64; 2],
    /// Sine and cosine of its yaw.
    pub turn: [f64; 2],
    /// Half its width and its depth (metres).
    pub half: [f64; 2],
}

impl Flat {
    /// A point as the rectangle sees it.
    pub fn local(&self, [x, z]: [f64; 2]) -> [f64; 2] {
        let ([dx, dz], [sin, cos]) = ([x - self.at[0], z - self.at[1]], self.turn);
        [dx * cos - dz * sin, dx * sin + dz * cos]
    }
    /// A point of its own as all see it.
    pub fn point(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        let [sin, cos] = self.turn;
        [self.at[0] + u * cos + v * sin, self.at[1] - u * sin + v * cos]
    }
    pub fn corners(&self) -> [[f64; 2]; 4] {
        let [w, d] = self.half;
        [[-w, -d], [w, -d], [w, d], [-w, d]].map(|p| self.point(p))
    }
    /// How far a point is from it, 0 within (metres).
    pub fn distance(&self, p: [f64; 2]) -> f64 {
        let [u, v] = self.local(p);
        let (u, v) = ((u.abs() - self.half[0]).max(0.0), (v.abs() - self.half[1]).max(0.0));
        (u * u + v * v).sqrt()
    }

    /// The same of a point within it as well: then it is negative, how far the nearest side is.
    fn signed_distance(&self, p: [f64; 2]) -> f64 {
        let [u, v] = self.local(p);
        let (u, v) = (u.abs() - self.half[0], v.abs() - self.half[1]);
        if u > 0.0 && v > 0.0 { length(u, v) } else { u.max(v) }
    }

    /// The point so far from it that is nearest to one outside.
    pub fn away(&self, p: [f64; 2], far: f64) -> [f64; 2] {
        let [u, v] = self.local(p);
        let near = [u.clamp(-self.half[0], self.half[0]), v.clamp(-self.half[1], self.half[1])];
        let off = [u - near[0], v - near[1]];
        let length = off[0].hypot(off[1]);
        if length < 1e-9 { p } else { self.point([0, 1].map(|k| near[k] + off[k] / length * far)) }
    }

    /// Between two: their distance or, negative, the least shift that would part them (metres).
    pub fn gap(&self, other: &Self) -> f64 {
        self.gap_below(other, f64::INFINITY)
    }

    /// The same if it is less than `most`, otherwise anything from `most` to the gap.
    fn gap_below(&self, other: &Self, most: f64) -> f64 {
        let [sin, cos] = [self.turn[0] * other.turn[1] - self.turn[1] * other.turn[0], self.dot(other)].map(f64::abs);
        let seen = |from: &Self, to: &Self| {
            let [u, v] = from.local(to.at);
            let reach = [cos * to.half[0] + sin * to.half[1], sin * to.half[0] + cos * to.half[1]];
            [u.abs() - from.half[0] - reach[0], v.abs() - from.half[1] - reach[1]]
        };
        let ([a, b], [c, d]) = (seen(self, other), seen(other, self));
        let apart = a.max(b).max(c).max(d);
        if apart <= 0.0 || apart >= most {
            return apart;
        }
        if sin == 0.0 || cos == 0.0 {
            // They share their axes.
            return if a > 0.0 && b > 0.0 { length(a, b) } else { apart };
        }
        // Of two convex things apart one shows a corner to the other.
        let from = |a: &Self, b: &Self| b.corners().into_iter().map(|p| a.distance(p)).fold(f64::INFINITY, f64::min);
        from(self, other).min(from(other, self))
    }

    /// How far it is from a segment, which does not touch it.
    fn distance_of_segment(&self, from: Vec2, to: Vec2) -> f64 {
        let ends = self.distance([from.x, from.y]).min(self.distance([to.x, to.y]));
        let corners = self.corners().map(|[x, z]| Vec2::new(x, z));
        corners.into_iter().map(|p| (p - nearest_on_segment(&p, &from, &to)).norm()).fold(ends, f64::min)
    }

    fn dot(&self, other: &Self) -> f64 {
        self.turn[0] * other.turn[0] + self.turn[1] * other.turn[1]
    }

    /// How far it stays from the walls within a room or, negative, how far it reaches beyond them (metres).
    pub fn clearance(&self, room: &Polygon) -> f64 {
        let [w, d] = self.half;
        let mut least = f64::INFINITY;
        for (from, to) in room.edges() {
            let (a, b) = (self.local([from.x, from.y]), self.local([to.x, to.y]));
            let beyond = |k: usize, half: f64| (a[k].min(b[k]) - half).max(-a[k].max(b[k]) - half);
            let way = [b[0] - a[0], b[1] - a[1]];
            let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
            let off = (a[0] * way[1] - a[1] * way[0]).abs() - w * way[1].abs() - d * way[0].abs();
            let apart = beyond(0, w).max(beyond(1, d)).max(off / length);
            if apart >= least {
                continue;
            }
            least = if apart > 0.0 { least.min(self.distance_of_segment(from, to)) } else { apart };
        }
        if least >= 0.0 && room.contains(Vec2::new(self.at[0], self.at[1])) {
            return least;
        }
        // Corners of it beyond the walls, and corners of the walls within it.
        let corners = self.corners().map(|[x, z]| Vec2::new(x, z));
        let outside = corners.into_iter().map(|p| depth(room, p)).fold(0.0, f64::min);
        let within = room.corners().iter().map(|p| self.local([p.x, p.y])).map(|[u, v]| (u.abs() - w).max(v.abs() - d));
        let worst = within.fold(outside, f64::min);
        if worst < 0.0 { worst } else { least.min(0.0) }
    }
}

/// How far a point is from the outline, negative outside.
fn depth(room: &Polygon, p: Vec2) -> f64 {
    let off = room.edges().map(|(a, b)| (p - nearest_on_segment(&p, &a, &b)).norm_squared());
    let off = off.fold(f64::INFINITY, f64::min).sqrt();
    if room.contains(p) { off } else { -off }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use scenelang_layout::rotation::sin_cos;

    fn flat() -> impl Strategy<Value = Flat> {
        let yaw = prop_oneof![0.0..360.0, (0..4).prop_map(|k| 90.0 * f64::from(k))];
        ((-4.0..4.0, -4.0..4.0), yaw, (0.05..1.5, 0.05..1.5)).prop_map(|((x, z), yaw, (w, d))| Flat {
            at: [x, z],
            turn: sin_cos(yaw).into(),
            half: [w, d],
        })
    }

    fn ell() -> Polygon {
        Polygon::new(&[[-3.0, -3.0], [3.0, -3.0], [3.0, 0.5], [0.5, 0.5], [0.5, 3.0], [-3.0, 3.0]]).unwrap()
    }

    fn as_box(flat: &Flat) -> scenelang_layout::Obb {
        let [sin, cos] = flat.turn;
        let axes = nalgebra::Matrix3::new(cos, 0.0, sin, 0.0, 1.0, 0.0, -sin, 0.0, cos);
        let vec = |x, y, z| Vec3::new(x, y, z);
        scenelang_layout::Obb {
            center: vec(flat.at[0], 0.5, flat.at[1]),
            axes,
            half: vec(flat.half[0], 0.5, flat.half[1]),
        }
    }

    proptest! {
        #[test]
        fn gaps_are_those_of_boxes(a in flat(), b in flat()) {
            let exact = scenelang_layout::obb::separation(&as_box(&a), &as_box(&b)).gap;
            let gap = a.gap(&b).max(-1.0);
            prop_assert!((gap - exact).abs() < 1e-9, "{gap} {exact}");
        }

        /// The rim of a round thing at many points, against what is said of it.
        #[test]
        fn round_things_are_as_far_as_their_rims(a in flat(), b in flat(), r in 0.05..1.5) {
            let round = Block { radius: r, is_round: true, ..Block::new([0.0; 3], [r, 1.0, r]) };
            let boxed = Block::new([0.0; 3], [b.half[0], 1.0, b.half[1]]);
            let rim = (0..720).map(|k| (f64::from(k) / 2.0).to_radians());
            let nearest = rim.map(|k| b.distance([a.at[0] + r * k.sin(), a.at[1] + r * k.cos()])).fold(f64::INFINITY, f64::min);
            let gap = round.aside(&a, &boxed, &b, f64::INFINITY);
            prop_assert_eq!(gap, boxed.aside(&b, &round, &a, f64::INFINITY));
            let overlap = b.distance(a.at) < r;
            prop_assert!(if overlap { gap < 0.0 } else { (gap - nearest).abs() < 0.01 }, "{} {}", gap, nearest);
        }

        #[test]
        fn clearances_have_the_signs_of_the_verifier(a in flat()) {
            let exact = ell().clearance(&a.corners().map(|[x, z]| Vec2::new(x, z))).value;
            let found = a.clearance(&ell());
            prop_assert_eq!(found >= 0.0, exact >= 0.0, "{} {}", found, exact);
            prop_assert!(exact < 0.0 || found <= exact + 1e-9);
            prop_assert!(exact > -0.01 || found < -0.002, "{} {}", found, exact);
        }
    }
}
