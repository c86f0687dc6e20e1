//! Oriented boxes: corners, support, and the signed gap of two.
//!
//! The gap is exact: fifteen axes decide overlap and its depth, and vertices and edges give the distance of boxes apart.

use crate::planar::{Vec2, convex_hull, nearest_of_segments};
use crate::separation::{Aabb, Separation, contact, highest};
use crate::{Placement, Vec3, rotation};
use nalgebra::Matrix3;

/// A box anywhere in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Obb {
    /// Centre of the box (not of its bottom).
    pub center: Vec3,
    /// Columns: unit vectors along its width, height and depth (right, up, front).
    pub axes: Matrix3<f64>,
    /// Half its extents along these.
    pub half: Vec3,
}

impl Obb {
    /// The box of a placed object.
    pub fn from_placement(placement: &Placement) -> Self {
        let axes = rotation::matrix(placement.rot);
        let half = placement.scale / 2.0;
        Self { center: placement.pos + axes.column(1) * half.y, axes, half }
    }
    /// An upright box.
    pub(crate) fn upright(aabb: &Aabb) -> Self {
        let half = (aabb.max - aabb.min) / 2.0;
        Self { center: aabb.min + half, axes: Matrix3::identity(), half }
    }
    /// The eight corners; bit 0 of the index says +x, bit 1 +y, bit 2 +z.
    pub fn corners(&self) -> [Vec3; 8] {
        std::array::from_fn(|i| {
            let sign = |bit: usize| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
            self.center + self.axes * self.half.component_mul(&Vec3::new(sign(0), sign(1), sign(2)))
        })
    }
    /// The twelve edges.
    pub fn edges(&self) -> [[Vec3; 2]; 12] {
        const STARTS: [[usize; 4]; 3] = [[0, 2, 4, 6], [0, 1, 4, 5], [0, 1, 2, 3]];
        let corners = self.corners();
        std::array::from_fn(|i| {
            let start = STARTS[i / 4][i % 4];
            [corners[start], corners[start | 1 << (i / 4)]]
        })
    }
    /// The greatest height along `n`.
    pub fn support_height(&self, n: &Vec3) -> f64 {
        self.center.dot(n) + self.reach(n)
    }
    /// How far it reaches from its centre along `n`.
    fn reach(&self, n: &Vec3) -> f64 {
        self.half.dot(&self.axes.tr_mul(n).abs())
    }
    /// A corner that is highest along `n`.
    pub fn support(&self, n: &Vec3) -> Vec3 {
        let local = self.axes.tr_mul(n).zip_map(&self.half, |d, h| if d < 0.0 { -h } else { h });
        self.center + self.axes * local
    }
    /// Whether it stands upright, turned about the vertical only.
    fn is_upright(&self) -> bool {
        let up = self.axes.column(1);
        up.y == 1.0 && up.x == 0.0 && up.z == 0.0 && self.axes[(1, 0)] == 0.0 && self.axes[(1, 2)] == 0.0
    }
    /// The corners of its plan, at the height of its centre.
    fn plan(&self) -> [Vec3; 4] {
        let (right, front) = (self.axes.column(0) * self.half.x, self.axes.column(2) * self.half.z);
        [right + front, right - front, front - right, -right - front].map(|off| self.center + off)
    }
    /// The smallest upright box that holds it.
    pub fn aabb(&self) -> Aabb {
        let reach = self.axes.abs() * self.half;
        Aabb { min: self.center - reach, max: self.center + reach }
    }
    /// Its outline seen from above, in world x, z.
    pub fn footprint(&self) -> Vec<Vec2> {
        convex_hull(self.corners().map(|c| Vec2::new(c.x, c.z)))
    }
    /// The point of the box nearest to `p` (`p` itself within).
    pub fn nearest(&self, p: &Vec3) -> Vec3 {
        let local = self.axes.tr_mul(&(p - self.center));
        self.center + self.axes * local.sup(&-self.half).inf(&self.half)
    }
    /// The least clearance of this box's corners from the faces of `outer`, negative where one is outside.
    pub fn clearance_in(&self, outer: &Self) -> f64 {
        self.corners()
            .iter()
            .map(|c| (outer.half - outer.axes.tr_mul(&(c - outer.center)).abs()).min())
            .fold(f64::INFINITY, f64::min)
    }
    /// Points of both that witness a separation, see [`contact`].
    pub fn contact(&self, other: &Self, separation: &Separation) -> (Vec3, Vec3) {
        let n = separation.normal;
        contact(&highest(&self.corners(), &n), &highest(&other.corners(), &-n), separation)
    }
}

/// The signed gap of two boxes.
pub fn separation(a: &Obb, b: &Obb) -> Separation {
    let upright = a.is_upright() && b.is_upright();
    let axis = separating_axis(a, b, upright);
    if axis.gap <= 0.0 {
        return axis;
    }
    let way = if upright { between_upright(a, b) } else { way_between(a, b) };
    let distance = way.norm();
    // Where the axis already attains the distance its direction is the better one: the points may all but touch.
    if distance <= axis.gap + 1e-12 * (1.0 + axis.gap) {
        return axis;
    }
    Separation { gap: distance, normal: way / distance }
}

/// Whether one of the fifteen axes shows a gap of at least `distance` (metres; negative: an overlap of that depth at
/// most). The first that does is enough, which makes this much faster than the gap itself.
pub fn apart(a: &Obb, b: &Obb, distance: f64) -> bool {
    let between = b.center - a.center;
    let shows = |axis: &Vec3| between.dot(axis).abs() - a.reach(axis) - b.reach(axis) >= distance;
    let faces = (0..3).any(|i| shows(&a.axes.column(i).into()) || shows(&b.axes.column(i).into()));
    faces
        || !(a.is_upright() && b.is_upright())
            && (0..3).any(|i| {
                (0..3).any(|j| {
                    let cross = a.axes.column(i).cross(&b.axes.column(j));
                    let length = cross.norm();
                    length > 1e-9 && shows(&(cross / length))
                })
            })
}

/// The best of the fifteen axes: exact where the boxes overlap, of the right sign and at most the distance where not. Edges
/// of upright boxes span no faces but those that the boxes have.
fn separating_axis(a: &Obb, b: &Obb, upright: bool) -> Separation {
    let between = b.center - a.center;
    let mut best = Separation { gap: f64::NEG_INFINITY, normal: Vec3::y() };
    let mut consider = |axis: Vec3| {
        let along = between.dot(&axis);
        let gap = along.abs() - a.reach(&axis) - b.reach(&axis);
        if gap > best.gap {
            best = Separation { gap, normal: if along < 0.0 { -axis } else { axis } };
        }
    };
    for i in 0..3 {
        consider(a.axes.column(i).into());
        consider(b.axes.column(i).into());
    }
    if upright {
        return best;
    }
    for i in 0..3 {
        for j in 0..3 {
            let cross = a.axes.column(i).cross(&b.axes.column(j));
            let length = cross.norm();
            // Parallel edges span no face of the difference; those of the faces are considered already.
            if length > 1e-9 {
                consider(cross / length);
            }
        }
    }
    best
}

/// The way from one upright box to another that it does not overlap. Seen from above it begins or ends at a corner.
fn between_upright(a: &Obb, b: &Obb) -> Vec3 {
    let rise = b.center.y - a.center.y;
    let height = (rise.abs() - a.half.y - b.half.y).max(0.0).copysign(rise);
    let between = b.center - a.center;
    let beside = |axis: &Vec3| between.dot(axis).abs() - a.reach(axis) > b.reach(axis);
    if ![a, b].iter().any(|o| [0, 2].iter().any(|&k| beside(&o.axes.column(k).into()))) {
        return Vec3::new(0.0, height, 0.0);
    }
    let to = |from: &Obb, corner: Vec3| {
        let local = from.axes.tr_mul(&(corner - from.center));
        let off = local - local.sup(&-from.half).inf(&from.half);
        let off = from.axes.column(0) * off.x + from.axes.column(2) * off.z;
        Vec3::new(off.x, height, off.z)
    };
    let ways = b.plan().into_iter().map(|q| to(a, q));
    let ways = ways.chain(a.plan().into_iter().map(|p| to(b, p)).map(|way| Vec3::new(-way.x, height, -way.z)));
    ways.reduce(|best, next| if next.norm_squared() < best.norm_squared() { next } else { best }).unwrap_or(between)
}

/// The way from a point of one box to the nearest one of another that it does not overlap.
fn way_between(a: &Obb, b: &Obb) -> Vec3 {
    let (p, q) = nearest_points(a, b);
    q - p
}

/// The nearest points of two boxes that do not overlap.
fn nearest_points(a: &Obb, b: &Obb) -> (Vec3, Vec3) {
    let of_corners = a.corners().into_iter().map(|p| (p, b.nearest(&p)));
    let of_corners = of_corners.chain(b.corners().into_iter().map(|q| (a.nearest(&q), q)));
    let (p, q) = of_corners.fold((a.center, b.center), nearer);
    // If the slab between two points keeps the boxes apart, none are nearer. Else it takes two edges.
    let distance = (q - p).norm();
    let n = (q - p) / distance;
    let slab = -a.support_height(&n) - b.support_height(&-n);
    if slab >= distance * (1.0 - 1e-12) {
        return (p, q);
    }
    let edges: Vec<Edge> = edges_of(b);
    let mut best = (p, q);
    let mut least = distance;
    for e in edges_of(a) {
        for f in &edges {
            if e.apart_squared(f) > (least + CERTAIN).powi(2) {
                continue;
            }
            let next = nearer(best, nearest_of_segments([&e.ends[0], &e.ends[1]], [&f.ends[0], &f.ends[1]]));
            if next != best {
                (best, least) = (next, (next.1 - next.0).norm());
            }
        }
    }
    best
}

/// The edges of a box. One without width has fewer: the others are corners, or the same again.
fn edges_of(obb: &Obb) -> Vec<Edge> {
    let mut edges: Vec<[Vec3; 2]> = obb.edges().into_iter().filter(|[p, q]| p != q).collect();
    edges.dedup();
    edges.into_iter().map(Edge::of).collect()
}

/// What is farther by so much (metres) is farther, whatever is rounded.
const CERTAIN: f64 = 1e-9;

/// An edge, and the upright box around it.
struct Edge {
    ends: [Vec3; 2],
    around: Aabb,
}

impl Edge {
    fn of(ends: [Vec3; 2]) -> Self {
        let [p, q] = &ends;
        let around = Aabb { min: p.inf(q), max: p.sup(q) };
        Self { ends, around }
    }

    /// Two are at least as far apart as the root of this.
    fn apart_squared(&self, other: &Self) -> f64 {
        self.around.distance_squared(&other.around)
    }
}

/// The nearer pair of points, the first of equals.
fn nearer(best: (Vec3, Vec3), next: (Vec3, Vec3)) -> (Vec3, Vec3) {
    if (next.1 - next.0).norm_squared() < (best.1 - best.0).norm_squared() { next } else { best }
}
