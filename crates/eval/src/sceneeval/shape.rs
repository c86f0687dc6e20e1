//! Oriented boxes as the benchmark measures them: the share of a box that is somewhere, distances, and what a box faces.
//!
//! The original draws points in a box at random. Of upright boxes the shares are exact here, which is what it comes to with
//! ever more points; of leaning ones they are counted on a grid.

use scenelang_layout::planar::edges;
use scenelang_layout::{Obb, Placement, Polygon, Vec2, Vec3, obb};

/// So many points along each axis stand for a leaning box.
const FINE: usize = 16;
/// Sight lines across an upright box.
const LINES: usize = 64;
/// What counts as on a boundary (metres).
const EPSILON: f64 = 1e-6;

/// A box.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// The box; its axes are its right, up and front.
    pub obb: Obb,
}

/// What is asked of the part of a box that is to be on one side of another.
#[derive(Clone, Copy, Debug)]
pub struct SideTest {
    /// 0: right, 1: up, 2: front.
    pub axis: usize,
    /// Whether it is that side, or the opposite one.
    pub positive: bool,
    /// Whether it has to be beyond its face, or only beyond its middle.
    pub beyond: bool,
    /// How much wider than the box the space at that side is, as a share.
    pub margin: f64,
}

impl Shape {
    /// The box of a placed object.
    pub fn new(placement: &Placement) -> Self {
        Self { obb: Obb::from_placement(placement) }
    }

    /// Whether it is turned about the vertical only.
    fn is_upright(&self) -> bool {
        let up = self.obb.axes.column(1);
        up.y >= 1.0 - 1e-12 && up.x.abs() < 1e-9 && up.z.abs() < 1e-9
    }

    /// A point in the frame of the box.
    fn local(&self, point: &Vec3) -> Vec3 {
        self.obb.axes.tr_mul(&(point - self.obb.center))
    }

    /// The distance of two boxes (metres); of a box within another, how far it is from its surface.
    pub fn gap(&self, other: &Self) -> f64 {
        let gap = obb::separation(&self.obb, &other.obb).gap;
        if gap > 0.0 {
            return gap;
        }
        let volume = |shape: &Self| shape.obb.half.product();
        let (small, large) = if volume(self) < volume(other) { (self, other) } else { (other, self) };
        small.obb.clearance_in(&large.obb).max(0.0)
    }

    /// The share of another box that is at a side of this one.
    pub fn share_at(&self, other: &Self, side: SideTest) -> f64 {
        let mut high = self.obb.half * (1.0 + side.margin) + Vec3::repeat(1e-9);
        let mut low = -high;
        let from = if side.beyond { self.obb.half[side.axis] } else { 0.0 } - EPSILON;
        (low[side.axis], high[side.axis]) =
            if side.positive { (from, f64::INFINITY) } else { (f64::NEG_INFINITY, -from) };
        self.share_between(other, &low, &high)
    }

    /// The share of another box that is in this one.
    pub fn share_inside(&self, other: &Self) -> f64 {
        let half = self.obb.half + Vec3::repeat(EPSILON);
        self.share_between(other, &-half, &half)
    }

    /// The share of another box that is between two corners in the frame of this one.
    fn share_between(&self, other: &Self, low: &Vec3, high: &Vec3) -> f64 {
        if !(self.is_upright() && other.is_upright()) {
            let within = |point: &Vec3| {
                let local = self.local(point);
                (0..3).all(|axis| low[axis] <= local[axis] && local[axis] <= high[axis])
            };
            let points = grid(&other.obb, FINE);
            return points.iter().filter(|point| within(point)).count() as f64 / points.len() as f64;
        }
        let plan = self.plan_of(other);
        let mut part = plan.clone();
        for (axis, side) in [Vec2::x(), Vec2::y()].into_iter().zip([[low.x, high.x], [low.z, high.z]]) {
            for (bound, way) in side.into_iter().zip([axis, -axis]) {
                if bound.is_finite() {
                    part = clipped(&part, axis * bound, way);
                }
            }
        }
        let middle = self.local(&other.obb.center);
        share(&part, &plan) * overlap([middle.y - other.obb.half.y, middle.y + other.obb.half.y], [low.y, high.y])
    }

    /// The plan of another upright box in the frame of this one: right and front.
    fn plan_of(&self, other: &Self) -> Vec<Vec2> {
        let corner = |[x, z]: [f64; 2]| {
            let off = other.obb.axes * other.obb.half.component_mul(&Vec3::new(x, 0.0, z));
            let local = self.local(&(other.obb.center + off));
            Vec2::new(local.x, local.z)
        };
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(corner).to_vec()
    }

    /// The share of the box that is above an outline of a floor.
    pub fn share_over(&self, outline: &Polygon, floor: f64) -> f64 {
        if !self.is_upright() {
            let over = |p: &&Vec3| p.y >= floor - EPSILON && outline.contains(Vec2::new(p.x, p.z));
            let points = grid(&self.obb, FINE);
            return points.iter().filter(over).count() as f64 / points.len() as f64;
        }
        let plan = self.obb.footprint();
        let part = edges(&plan)
            .fold(outline.corners().to_vec(), |part, (a, b)| clipped(&part, a, Vec2::new(a.y - b.y, b.x - a.x)));
        let (middle, half) = (self.obb.center.y, self.obb.half.y);
        share(&part, &plan) * overlap([middle - half, middle + half], [floor - EPSILON, f64::INFINITY])
    }

    /// From the middle of the box to where rays from all of it along its front meet another, on average and seen from above;
    /// `None`: no ray meets it.
    pub fn sight(&self, other: &Self) -> Option<Vec2> {
        if self.is_upright() && other.is_upright() { self.sight_upright(other) } else { self.sight_leaning(other) }
    }

    fn sight_upright(&self, other: &Self) -> Option<Vec2> {
        let [own, its] = [self, other].map(|shape| (shape.obb.center.y, shape.obb.half.y));
        if (own.0 - its.0).abs() >= own.1 + its.1 {
            return None;
        }
        let plan = self.plan_of(other);
        let half = self.obb.half;
        let ends = |pick: fn(f64, f64) -> f64, from: f64| plan.iter().map(|p| p.x).fold(from, pick);
        let [low, high] = [ends(f64::min, f64::INFINITY).max(-half.x), ends(f64::max, f64::NEG_INFINITY).min(half.x)];
        let (mut sum, mut weight) = (Vec2::zeros(), 0.0);
        for line in 0..LINES {
            let x = low + (high - low) * (line as f64 + 0.5) / LINES as f64;
            let at = edges(&plan)
                .filter(|(a, b)| (a.x > x) != (b.x > x))
                .map(|(a, b)| a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
            let [near, far] = at.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], y| [low.min(y), high.max(y)]);
            // What begins before the other box enters it there; what begins within leaves it at the far side.
            let before = near.min(half.z) + half.z;
            let within = far.min(half.z) - near.max(-half.z);
            for (y, share) in [(near, before), (far, within)] {
                if share > 0.0 && y.is_finite() && low < high {
                    sum += Vec2::new(x, y) * share;
                    weight += share;
                }
            }
        }
        let mean = (weight > 0.0).then(|| sum / weight)?;
        let off = self.obb.axes * Vec3::new(mean.x, 0.0, mean.y);
        Some(Vec2::new(off.x, off.z))
    }

    fn sight_leaning(&self, other: &Self) -> Option<Vec2> {
        let front: Vec3 = self.obb.axes.column(2).into();
        let along = other.obb.axes.tr_mul(&front);
        let (mut sum, mut hits) = (Vec3::zeros(), 0_usize);
        for origin in grid(&self.obb, FINE) {
            let local = other.local(&origin);
            let (mut enters, mut leaves) = (f64::NEG_INFINITY, f64::INFINITY);
            for axis in 0..3 {
                let at = |face: f64| (face - local[axis]) / along[axis];
                let (a, b) = (at(-other.obb.half[axis]), at(other.obb.half[axis]));
                // A ray in the plane of a face says nothing about that axis.
                if !a.is_nan() && !b.is_nan() {
                    (enters, leaves) = (enters.max(a.min(b)), leaves.min(a.max(b)));
                }
            }
            if leaves >= enters.max(0.0) {
                sum += origin + front * if enters >= 0.0 { enters } else { leaves };
                hits += 1;
            }
        }
        let mean = (hits > 0).then(|| sum / hits as f64 - self.obb.center)?;
        Some(Vec2::new(mean.x, mean.z))
    }

    /// On average, the way from the box to the nearest points of another.
    pub fn way_to(&self, other: &Self) -> Vec3 {
        const FEW: usize = 4;
        grid(&self.obb, FEW).iter().map(|point| other.obb.nearest(point) - point).sum::<Vec3>() / FEW.pow(3) as f64
    }
}

/// The middles of the cells of an even grid in a box.
fn grid(obb: &Obb, n: usize) -> Vec<Vec3> {
    let step = |i: usize| (2 * i + 1) as f64 / n as f64 - 1.0;
    let cells = (0..n * n * n).map(|i| Vec3::new(step(i / (n * n)), step(i / n % n), step(i % n)));
    cells.map(|cell| obb.center + obb.axes * cell.component_mul(&obb.half)).collect()
}

/// The part of a polygon on one side of a line.
fn clipped(polygon: &[Vec2], on: Vec2, way: Vec2) -> Vec<Vec2> {
    let depth = |p: Vec2| (p - on).dot(&way);
    let mut out = Vec::new();
    for (a, b) in edges(polygon) {
        let (da, db) = (depth(a), depth(b));
        if da >= 0.0 {
            out.push(a);
        }
        if (da >= 0.0) != (db >= 0.0) {
            out.push(a + (b - a) * (da / (da - db)));
        }
    }
    out
}

/// Square metres, whichever way round.
fn area(polygon: &[Vec2]) -> f64 {
    edges(polygon).map(|(a, b)| a.perp(&b)).sum::<f64>().abs() / 2.0
}

fn share(part: &[Vec2], whole: &[Vec2]) -> f64 {
    let whole = area(whole);
    // Of a line or a point it is all or nothing.
    if whole > 1e-12 { (area(part) / whole).min(1.0) } else { f64::from(u8::from(!part.is_empty())) }
}

/// The share of a span that is within another.
fn overlap([low, high]: [f64; 2], within: [f64; 2]) -> f64 {
    let common = high.min(within[1]) - low.max(within[0]);
    let long = high - low;
    if long > 1e-9 { (common / long).clamp(0.0, 1.0) } else { f64::from(u8::from(common >= 0.0)) }
}

/// 1 within a range of distances, falling off like a bell outside.
pub fn ease(distance: f64, range: [f64; 2], deviation: f64) -> f64 {
    let [low, high] = range;
    if low <= distance && distance < high {
        return 1.0;
    }
    let off = (distance - low).abs().min((distance - high).abs());
    (-off * off / (2.0 * deviation * deviation)).exp()
}
