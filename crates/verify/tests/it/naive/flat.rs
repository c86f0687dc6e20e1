//! Polygons in the plane of the floor (world x, z), by looking at every point and every edge.

pub type P = [f64; 2];

fn sub(a: P, b: P) -> P {
    [a[0] - b[0], a[1] - b[1]]
}
fn cross(a: P, b: P) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}
fn dot(a: P, b: P) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}
fn length(a: P) -> f64 {
    dot(a, a).sqrt()
}
/// Twice the area of the triangle a, b, c: positive where they turn to the left.
fn turn(a: P, b: P, c: P) -> f64 {
    cross(sub(b, a), sub(c, a))
}

pub fn edges(polygon: &[P]) -> impl Iterator<Item = (P, P)> + '_ {
    (0..polygon.len()).map(|i| (polygon[i], polygon[(i + 1) % polygon.len()]))
}

/// Signed: positive where the corners run to the left.
fn signed_area(polygon: &[P]) -> f64 {
    edges(polygon).map(|(a, b)| cross(a, b)).sum::<f64>() / 2.0
}
pub fn area(polygon: &[P]) -> f64 {
    signed_area(polygon).abs()
}

/// Of the area, not of the corners.
pub fn centroid(polygon: &[P]) -> P {
    let from = polygon[0];
    let (mut sum, mut all) = ([0.0; 2], 0.0);
    for (a, b) in edges(polygon) {
        let (a, b) = (sub(a, from), sub(b, from));
        let weight = cross(a, b);
        all += weight;
        sum = [sum[0] + (a[0] + b[0]) * weight, sum[1] + (a[1] + b[1]) * weight];
    }
    [from[0] + sum[0] / all / 3.0, from[1] + sum[1] / all / 3.0]
}

pub fn is_convex(polygon: &[P]) -> bool {
    let n = polygon.len();
    let winding = signed_area(polygon).signum();
    (0..n).all(|i| turn(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) * winding >= -1e-12)
}

pub fn to_segment(p: P, a: P, b: P) -> f64 {
    let along = sub(b, a);
    let square = dot(along, along);
    let t = if square > 0.0 { (dot(sub(p, a), along) / square).clamp(0.0, 1.0) } else { 0.0 };
    length(sub(p, [a[0] + t * along[0], a[1] + t * along[1]]))
}

/// Proper crossings only: touching is no crossing.
fn cross_each_other(a: P, b: P, c: P, d: P) -> bool {
    turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0
}

fn between_segments(a: P, b: P, c: P, d: P) -> f64 {
    if cross_each_other(a, b, c, d) {
        return 0.0;
    }
    [to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)]
        .into_iter()
        .fold(f64::MAX, f64::min)
}

/// By counting the edges to the right of the point.
pub fn holds(polygon: &[P], p: P) -> bool {
    edges(polygon)
        .filter(|(a, b)| {
            let between = (a[1] > p[1]) != (b[1] > p[1]);
            between && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
        })
        .count()
        % 2
        == 1
}

pub fn to_edges(polygon: &[P], p: P) -> f64 {
    edges(polygon).map(|(a, b)| to_segment(p, a, b)).fold(f64::MAX, f64::min)
}

/// Distance from the nearest edge: positive inside, negative outside.
pub fn depth(polygon: &[P], p: P) -> f64 {
    if holds(polygon, p) { to_edges(polygon, p) } else { -to_edges(polygon, p) }
}

/// How a footprint lies in a polygon.
#[derive(Clone, Copy, Debug)]
pub struct Clearance {
    /// From the edges; negative: how far its farthest point is outside, or a bound of that.
    pub value: f64,
    /// Whether the value is only a lower bound of how far it is outside.
    pub bound: bool,
}

/// Of a convex footprint in any simple polygon.
pub fn clearance(polygon: &[P], footprint: &[P]) -> Clearance {
    let outside = |p: P| (-depth(polygon, p)).max(0.0);
    let far = footprint.iter().map(|p| outside(*p)).fold(0.0, f64::max);
    if is_convex(polygon) && far > 0.0 {
        // The distance to a convex set is greatest at a corner.
        return Clearance { value: -far, bound: false };
    }
    let crosses = edges(footprint).any(|(a, b)| edges(polygon).any(|(c, d)| cross_each_other(a, b, c, d)));
    let swallows = polygon.iter().any(|p| depth(footprint, *p) > 0.0);
    if far == 0.0 && !crosses && !swallows {
        let nearest = |(a, b)| edges(polygon).map(|(c, d)| between_segments(a, b, c, d)).fold(f64::MAX, f64::min);
        return Clearance { value: edges(footprint).map(nearest).fold(f64::MAX, f64::min), bound: false };
    }
    // The farthest point may be anywhere in a notch: many points are looked at, which gives a bound.
    let n = 40;
    let far = samples(footprint, n).into_iter().map(outside).fold(far, f64::max);
    Clearance { value: -far, bound: true }
}

/// Points all over a convex polygon, its edges among them.
fn samples(footprint: &[P], n: usize) -> Vec<P> {
    let mut out = Vec::new();
    for i in 1..footprint.len().saturating_sub(1) {
        let (a, b, c) = (footprint[0], footprint[i], footprint[i + 1]);
        for s in 0..=n {
            for t in 0..=n - s {
                let (s, t) = (s as f64 / n as f64, t as f64 / n as f64);
                out.push([0, 1].map(|k| a[k] + s * (b[k] - a[k]) + t * (c[k] - a[k])));
            }
        }
    }
    out
}

/// Convex hull, running to the left (gift wrapping by the angle of every other point); of one or two points: these.
pub fn hull(points: &[P]) -> Vec<P> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted;
    }
    let half = |points: &mut dyn Iterator<Item = P>| {
        let mut out: Vec<P> = Vec::new();
        for p in points {
            while out.len() > 1 && turn(out[out.len() - 2], out[out.len() - 1], p) <= 0.0 {
                out.pop();
            }
            out.push(p);
        }
        out.pop();
        out
    };
    let mut out = half(&mut sorted.iter().copied());
    out.extend(half(&mut sorted.iter().rev().copied()));
    // What rounding has split is one.
    out.dedup_by(|b, a| length(sub(*b, *a)) < 1e-9);
    if out.len() > 1 && length(sub(out[0], out[out.len() - 1])) < 1e-9 {
        out.pop();
    }
    out
}

/// Distance of a point to a convex hull of any dimension; 0 inside.
pub fn to_hull(hull: &[P], p: P) -> f64 {
    match hull {
        [] => f64::INFINITY,
        [a] => length(sub(p, *a)),
        [a, b] => to_segment(p, *a, *b),
        _ if edges(hull).all(|(a, b)| turn(a, b, p) >= 0.0) => 0.0,
        _ => to_edges(hull, p),
    }
}

/// What two convex polygons share; the second runs to the left.
pub fn clip(subject: &[P], by: &[P]) -> Vec<P> {
    let mut out = subject.to_vec();
    for (a, b) in edges(by) {
        let before = std::mem::take(&mut out);
        for (p, q) in edges(&before) {
            let (in_p, in_q) = (turn(a, b, p), turn(a, b, q));
            if in_p >= 0.0 {
                out.push(p);
            }
            if (in_p > 0.0 && in_q < 0.0) || (in_p < 0.0 && in_q > 0.0) {
                let t = in_p / (in_p - in_q);
                out.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
            }
        }
    }
    out
}

#[test]
fn clearances_of_a_square_in_an_ell() {
    let ell = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 2.0], [2.0, 4.0], [0.0, 4.0]];
    let square = |x: f64, z: f64| [[x, z], [x + 1.0, z], [x + 1.0, z + 1.0], [x, z + 1.0]];
    assert_eq!(clearance(&ell, &square(0.25, 0.5)).value, 0.25);
    assert_eq!(clearance(&ell, &square(-1.0, 0.5)).value, -1.0);
    let over_the_corner = clearance(&ell, &square(1.5, 1.5));
    assert!(over_the_corner.bound && over_the_corner.value < -0.4);
    assert_eq!(area(&ell), 12.0);
    assert!(!is_convex(&ell));
    assert_eq!(area(&hull(&clip(&square(0.0, 0.0), &square(0.5, 0.5)))), 0.25);
}
