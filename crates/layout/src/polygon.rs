//! Simple polygons in the floor plane: are they simple, what do they hold, and with how much clearance.

use crate::planar::{Vec2, crossing, depth_in_convex, edges, nearest_of_segments, nearest_on_segment, turn};
use std::fmt;

/// Points nearer than this (metres) count as the same, edges nearer than this as touching.
const TOUCHING: f64 = 1e-9;

/// How many corners a polygon may have: far more than any floor plan, few enough to test every pair of edges.
pub const MAX_CORNERS: usize = 10_000;

/// Why a list of vertices is no simple polygon. Indices count from 0, as given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotSimple {
    /// Fewer than three vertices (the first repeated at the end does not count).
    TooFew(usize),
    /// More than [`MAX_CORNERS`].
    TooMany(usize),
    /// A vertex repeats the one before.
    Repeated(usize),
    /// All vertices lie on one line.
    Flat,
    /// At this vertex the outline turns back on itself.
    Spike(usize),
    /// The edges that start at these vertices cross or touch.
    Crossing(usize, usize),
}

impl fmt::Display for NotSimple {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew(n) => write!(f, "a floor polygon needs at least 3 vertices, but there are {n}"),
            Self::TooMany(n) => {
                write!(f, "a floor polygon of {n} vertices is too large; at most {MAX_CORNERS} are allowed")
            }
            Self::Repeated(i) => write!(f, "vertex {i} of the floor polygon repeats the one before"),
            Self::Flat => write!(f, "all vertices of the floor polygon lie on one line"),
            Self::Spike(i) => write!(f, "the floor polygon turns back on itself at vertex {i}"),
            Self::Crossing(i, j) => {
                write!(
                    f,
                    "the floor polygon touches or crosses itself: the edges that start at vertices {i} and {j} meet"
                )
            }
        }
    }
}

/// A simple polygon of positive winding (x towards z), possibly concave.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    corners: Vec<Vec2>,
    convex: bool,
}

/// How a point or a footprint lies in a polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearance {
    /// Metres: distance to the boundary, or minus how far outside.
    pub value: f64,
    /// The point (of the footprint) that decides.
    pub at: Vec2,
    /// The point of the boundary nearest to it.
    pub wall: Vec2,
    /// Unit direction in which `at` gains clearance.
    pub inward: Vec2,
}

impl Polygon {
    /// The polygon of some vertices (world x, z), in either winding, the first one perhaps repeated at the end.
    ///
    /// # Errors
    /// Why it is not simple.
    pub fn new(vertices: &[[f64; 2]]) -> Result<Self, NotSimple> {
        let mut corners: Vec<Vec2> = vertices.iter().map(|&[x, z]| Vec2::new(x, z)).collect();
        if corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        check_simple(&corners)?;
        Ok(Self::wound(corners))
    }

    /// A rectangle around `center`, of full extents `size`, turned by `degrees` about y.
    pub fn rectangle(center: Vec2, size: Vec2, degrees: f64) -> Self {
        let (s, c) = crate::rotation::sin_cos(degrees);
        let at = |i: f64, j: f64| {
            let (x, z) = (i * size.x / 2.0, j * size.y / 2.0);
            center + Vec2::new(c * x + s * z, c * z - s * x)
        };
        Self::wound(vec![at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)])
    }

    fn wound(mut corners: Vec<Vec2>) -> Self {
        if doubled_area(&corners) < 0.0 {
            corners.reverse();
        }
        let n = corners.len();
        let convex = (0..n).all(|i| turn(corners[i], corners[(i + 1) % n], corners[(i + 2) % n]) >= 0.0);
        Self { corners, convex }
    }

    /// Its corners, in positive winding.
    pub fn corners(&self) -> &[Vec2] {
        &self.corners
    }
    /// Its edges, the inside on the positive side.
    pub fn edges(&self) -> impl Iterator<Item = (Vec2, Vec2)> + '_ {
        edges(&self.corners)
    }
    /// Whether no corner points inwards.
    pub fn is_convex(&self) -> bool {
        self.convex
    }
    /// Square metres.
    pub fn area(&self) -> f64 {
        doubled_area(&self.corners) / 2.0
    }
    /// Centre of area.
    pub fn centroid(&self) -> Vec2 {
        // Relative to a corner, so that a small polygon far away keeps its digits.
        let origin = self.corners[0];
        let (mut sum, mut weight) = (Vec2::zeros(), 0.0);
        for (a, b) in self.edges() {
            let (a, b) = (a - origin, b - origin);
            let w = a.perp(&b);
            sum += (a + b) * w;
            weight += w;
        }
        origin + sum / (3.0 * weight)
    }
    /// Whether `p` is inside; on the boundary either answer is possible.
    pub fn contains(&self, p: Vec2) -> bool {
        let mut inside = false;
        for (a, b) in self.edges() {
            if (a.y > p.y) != (b.y > p.y) && (turn(a, b, p) > 0.0) == (b.y > a.y) {
                inside = !inside;
            }
        }
        inside
    }
    pub fn clearance_of_point(&self, p: Vec2) -> Clearance {
        let (edge, wall) = self.nearest_edge(p);
        let distance = (p - wall).norm();
        let inside = self.contains(p);
        Clearance {
            value: if inside { distance } else { -distance },
            at: p,
            wall,
            inward: self.inward(edge, if inside { p - wall } else { wall - p }),
        }
    }

    /// The clearance of a convex footprint (positive winding): how far it stays from the boundary within, or minus how
    /// far its outline leads outside at most. Where the outline is inside so is all of it, a simple polygon having no holes.
    pub fn clearance(&self, footprint: &[Vec2]) -> Clearance {
        if let Some(clearance) = self.convex.then(|| self.clearance_in_convex(footprint)).filter(|c| c.value > 0.0) {
            return clearance;
        }
        let mut outside: Option<Clearance> = None;
        let mut worst = |c: Clearance| {
            if outside.is_none_or(|o| c.value < o.value) {
                outside = Some(c);
            }
        };
        for &p in footprint {
            let c = self.clearance_of_point(p);
            if c.value < 0.0 {
                worst(c);
            }
        }
        if !self.convex {
            for (a, b) in edges(footprint) {
                self.outside_along(a, b, &mut worst);
            }
        }
        outside.unwrap_or_else(|| self.clearance_within(footprint))
    }

    /// The least distance from the line of an edge: the clearance, if all of the footprint is inside. Not so outside,
    /// where what is nearest may be a corner.
    fn clearance_in_convex(&self, footprint: &[Vec2]) -> Clearance {
        let mut best = Clearance { value: f64::INFINITY, at: Vec2::zeros(), wall: Vec2::zeros(), inward: Vec2::x() };
        for (a, b) in self.edges() {
            let inward = Vec2::new(a.y - b.y, b.x - a.x).normalize();
            for &at in footprint {
                let value = inward.dot(&(at - a));
                if value < best.value {
                    best = Clearance { value, at, wall: at - inward * value, inward };
                }
            }
        }
        best
    }

    /// Clearance of a footprint known to be inside.
    fn clearance_within(&self, footprint: &[Vec2]) -> Clearance {
        let mut best = Clearance { value: f64::INFINITY, at: Vec2::zeros(), wall: Vec2::zeros(), inward: Vec2::x() };
        for (edge, (a, b)) in self.edges().enumerate() {
            for (c, d) in edges(footprint) {
                let (wall, at) = nearest_of_segments([&a, &b], [&c, &d]);
                let value = (at - wall).norm();
                if value < best.value {
                    best = Clearance { value, at, wall, inward: self.inward(edge, at - wall) };
                }
            }
        }
        best
    }

    /// Tells `worst` of the points of segment `a b` farthest outside.
    fn outside_along(&self, a: Vec2, b: Vec2, worst: &mut impl FnMut(Clearance)) {
        // Cut wherever the line of an edge crosses: one cut too many costs little, a missing one would mix in and out.
        let along = b - a;
        let mut cuts = vec![0.0, 1.0];
        for (c, d) in self.edges() {
            let t = (c - a).perp(&(d - c)) / along.perp(&(d - c));
            if t > 0.0 && t < 1.0 {
                cuts.push(t);
            }
        }
        cuts.sort_by(f64::total_cmp);
        for pair in cuts.windows(2) {
            let (p, q) = (a + along * pair[0], a + along * pair[1]);
            if pair[1] > pair[0] && !self.contains((p + q) / 2.0) {
                worst(self.farthest_outside(p, q));
            }
        }
    }

    /// The point of a segment wholly outside that is farthest from the polygon, to 1e-10 m (or what doubles give).
    fn farthest_outside(&self, p: Vec2, q: Vec2) -> Clearance {
        let sample = |at: Vec2| {
            let (edge, wall) = self.nearest_edge(at);
            let value = -(at - wall).norm();
            (edge, Clearance { value, at, wall, inward: self.inward(edge, wall - at) })
        };
        let to_edge = |edge: usize, at: Vec2| {
            let (a, b) = self.edge(edge);
            (at - nearest_on_segment(&at, &a, &b)).norm()
        };
        let (first, last) = (sample(p), sample(q));
        let mut best = if last.1.value < first.1.value { last.1 } else { first.1 };
        let mut open = vec![(first, last)];
        let precision = 1e-10 + 8.0 * f64::EPSILON * p.amax().max(q.amax());
        while let Some((x, y)) = open.pop() {
            // The distance to one edge is convex along the segment, so that between two points it is at most the
            // greater one; the distance to the polygon is at most that to either of two edges.
            let bound = |e: usize| to_edge(e, x.1.at).max(to_edge(e, y.1.at));
            // Where numbers have overflowed nothing compares, and there is nothing more to find.
            let farther = bound(x.0).min(bound(y.0)) > -best.value + precision;
            if !farther {
                continue;
            }
            let middle = sample((x.1.at + y.1.at) / 2.0);
            if middle.1.value < best.value {
                best = middle.1;
            }
            open.push((x, middle));
            open.push((middle, y));
        }
        best
    }

    /// Corners of the convex hull of what it shares with a convex polygon lie among these points.
    pub fn overlap_points(&self, convex: &[Vec2]) -> Vec<Vec2> {
        let mut points: Vec<Vec2> =
            convex.iter().copied().filter(|&p| self.clearance_of_point(p).value >= -TOUCHING).collect();
        points.extend(self.corners.iter().copied().filter(|&p| depth_in_convex(convex, p) >= -TOUCHING));
        for (a, b) in self.edges() {
            points.extend(edges(convex).filter_map(|(c, d)| crossing([a, b], [c, d])));
        }
        points
    }

    fn edge(&self, index: usize) -> (Vec2, Vec2) {
        (self.corners[index], self.corners[(index + 1) % self.corners.len()])
    }

    /// The edge nearest to `p`, and its nearest point.
    fn nearest_edge(&self, p: Vec2) -> (usize, Vec2) {
        let mut best = (f64::INFINITY, 0, self.corners[0]);
        for (i, (a, b)) in self.edges().enumerate() {
            let wall = nearest_on_segment(&p, &a, &b);
            let distance = (p - wall).norm_squared();
            if distance < best.0 {
                best = (distance, i, wall);
            }
        }
        (best.1, best.2)
    }

    /// `way` as a unit vector; where it has no length the direction into the polygon from the edge.
    fn inward(&self, edge: usize, way: Vec2) -> Vec2 {
        let (a, b) = self.edge(edge);
        let normal = Vec2::new(a.y - b.y, b.x - a.x);
        way.try_normalize(TOUCHING).or_else(|| normal.try_normalize(0.0)).unwrap_or(Vec2::x())
    }
}

fn doubled_area(corners: &[Vec2]) -> f64 {
    let origin = corners.first().copied().unwrap_or_default();
    edges(corners).map(|(a, b)| (a - origin).perp(&(b - origin))).sum()
}

fn check_simple(corners: &[Vec2]) -> Result<(), NotSimple> {
    let n = corners.len();
    if n < 3 {
        return Err(NotSimple::TooFew(n));
    }
    if n > MAX_CORNERS {
        return Err(NotSimple::TooMany(n));
    }
    let at = |i: usize| corners[i % n];
    if let Some(i) = (0..n).find(|&i| (at(i + 1) - at(i)).norm() <= TOUCHING) {
        return Err(NotSimple::Repeated((i + 1) % n));
    }
    let farthest = corners.iter().copied().max_by(|a, b| (a - at(0)).norm().total_cmp(&(b - at(0)).norm()));
    let along = farthest.and_then(|f| (f - at(0)).try_normalize(0.0)).unwrap_or(Vec2::x());
    if corners.iter().all(|c| along.perp(&(c - at(0))).abs() <= TOUCHING) {
        return Err(NotSimple::Flat);
    }
    let near = |p: Vec2, a: Vec2, b: Vec2| (nearest_on_segment(&p, &a, &b) - p).norm() <= TOUCHING;
    for i in 0..n {
        let (a, b, c) = (at(i), at(i + 1), at(i + 2));
        if near(c, a, b) || near(a, b, c) {
            return Err(NotSimple::Spike((i + 1) % n));
        }
    }
    // Edges in order of their least x: only those whose spans in both directions meet can meet.
    let span = |i: usize| (at(i).inf(&at(i + 1)), at(i).sup(&at(i + 1)).add_scalar(TOUCHING));
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&i, &j| span(i).0.x.total_cmp(&span(j).0.x).then(i.cmp(&j)));
    for (k, &i) in order.iter().enumerate() {
        let (low, high) = span(i);
        for &j in order[k + 1..].iter().take_while(|&&j| span(j).0.x <= high.x) {
            let neighbours = (i + 1) % n == j || (j + 1) % n == i;
            if neighbours || span(j).0.y > high.y || span(j).1.y < low.y {
                continue;
            }
            let (p, q) = nearest_of_segments([&at(i), &at(i + 1)], [&at(j), &at(j + 1)]);
            if (p - q).norm() <= TOUCHING {
                return Err(NotSimple::Crossing(i.min(j), i.max(j)));
            }
        }
    }
    Ok(())
}
