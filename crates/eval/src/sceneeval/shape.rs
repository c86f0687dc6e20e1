//! Oriented boxes as the benchmark measures them: by points on a grid within them.

use scenelang_layout::{Obb, Placement, Vec3};

/// So many points along each axis stand for a box where shares and distances are measured.
const FINE: usize = 7;
/// So many where only its corners and middles count.
const COARSE: usize = 3;
/// What counts as on a boundary (metres).
const EPSILON: f64 = 1e-6;

/// A box and its points.
#[derive(Clone, Debug)]
pub struct Shape {
    /// The box; its axes are its right, up and front.
    pub obb: Obb,
    points: Vec<Vec3>,
}

/// What is asked of points that are to be on one side of a box.
#[derive(Clone, Copy, Debug)]
pub struct SideTest {
    /// 0: right, 1: up, 2: front.
    pub axis: usize,
    /// Whether it is that side, or the opposite one.
    pub positive: bool,
    /// Whether points have to be beyond its face, or only beyond its middle.
    pub beyond: bool,
    /// How much wider than the box the space at that side is, as a share.
    pub margin: f64,
}

impl Shape {
    /// The box of a placed object.
    pub fn new(placement: &Placement) -> Self {
        let obb = Obb::from_placement(placement);
        let points = grid(&obb, FINE);
        Self { obb, points }
    }

    /// Points on a coarse grid: corners, middles of edges and faces, the centre.
    pub fn coarse(&self) -> Vec<Vec3> {
        grid(&self.obb, COARSE)
    }

    /// A point in the frame of the box.
    fn local(&self, point: &Vec3) -> Vec3 {
        self.obb.axes.tr_mul(&(point - self.obb.center))
    }

    /// How far a point is from the box (metres).
    fn distance(&self, point: &Vec3) -> f64 {
        (self.local(point).abs() - self.obb.half).sup(&Vec3::zeros()).norm()
    }

    /// The least distance of two boxes, by their points (metres).
    pub fn gap(&self, other: &Self) -> f64 {
        let least = |of: &Self, to: &Self| of.points.iter().map(|p| to.distance(p)).fold(f64::INFINITY, f64::min);
        least(self, other).min(least(other, self))
    }

    /// The share of another box's points that are at a side of this one.
    pub fn share_at(&self, other: &Self, side: SideTest) -> f64 {
        let sign = if side.positive { 1.0 } else { -1.0 };
        let from = if side.beyond { self.obb.half[side.axis] } else { 0.0 };
        let at = |point: &&Vec3| {
            let local = self.local(point);
            let wide = |o: usize| local[o].abs() <= self.obb.half[o] * (1.0 + side.margin) + 1e-9;
            sign * local[side.axis] >= from - EPSILON && (0..3).all(|o| o == side.axis || wide(o))
        };
        other.points.iter().filter(at).count() as f64 / other.points.len() as f64
    }

    /// The share of another box's points that are in this one.
    pub fn share_inside(&self, other: &Self) -> f64 {
        let inside = other.points.iter().filter(|point| self.distance(point) < EPSILON).count();
        inside as f64 / other.points.len() as f64
    }

    /// Where rays from this box along its front enter another, on average; `None`: no ray meets it.
    pub fn seen_of(&self, other: &Self) -> Option<Vec3> {
        const RAYS: usize = 5;
        let front: Vec3 = self.obb.axes.column(2).into();
        let along = other.obb.axes.tr_mul(&front);
        let (mut sum, mut hits) = (Vec3::zeros(), 0_usize);
        for origin in grid(&self.obb, RAYS) {
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
                sum += origin + front * enters.max(0.0);
                hits += 1;
            }
        }
        (hits > 0).then(|| sum / hits as f64)
    }
}

/// Points on an even grid in a box, its corners among them.
fn grid(obb: &Obb, n: usize) -> Vec<Vec3> {
    let step = |i: usize| 2.0 * i as f64 / (n - 1) as f64 - 1.0;
    let cells = (0..n * n * n).map(|i| Vec3::new(step(i / (n * n)), step(i / n % n), step(i % n)));
    cells.map(|cell| obb.center + obb.axes * cell.component_mul(&obb.half)).collect()
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
