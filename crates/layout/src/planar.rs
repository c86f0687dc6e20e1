//! Small things in the plane (world x, z) and in space: segments, convex hulls, overlaps of convex polygons.
//!
//! A convex polygon here is the slice of its corners in order of positive winding (x towards z); one or two corners
//! are allowed and mean a point and a segment.

use nalgebra::{SVector, Vector2};

/// A point in the floor plane: world x and z, in metres.
pub type Vec2 = Vector2<f64>;

/// Twice the signed area of a triangle: positive where `c` is on the positive side of the line from `a` to `b`.
pub fn turn(a: Vec2, b: Vec2, c: Vec2) -> f64 {
    (b - a).perp(&(c - a))
}

/// The point of segment `a b` nearest to `p`.
pub fn nearest_on_segment<const D: usize>(
    p: &SVector<f64, D>,
    a: &SVector<f64, D>,
    b: &SVector<f64, D>,
) -> SVector<f64, D> {
    let along = b - a;
    let length = along.norm_squared();
    if length == 0.0 {
        return *a;
    }
    let t = (p - a).dot(&along) / length;
    if t <= 0.0 {
        *a
    } else if t >= 1.0 {
        *b
    } else {
        a + along * t
    }
}

/// The nearest points of segments `a b` and `c d`.
pub fn nearest_of_segments<const D: usize>(
    [a, b]: [&SVector<f64, D>; 2],
    [c, d]: [&SVector<f64, D>; 2],
) -> (SVector<f64, D>, SVector<f64, D>) {
    // Either an end is nearest, or the nearest points of the two lines lie within both segments.
    let mut best = [
        (*a, nearest_on_segment(a, c, d)),
        (*b, nearest_on_segment(b, c, d)),
        (nearest_on_segment(c, a, b), *c),
        (nearest_on_segment(d, a, b), *d),
    ]
    .into_iter()
    .min_by(|x, y| (x.1 - x.0).norm_squared().total_cmp(&(y.1 - y.0).norm_squared()))
    .unwrap_or((*a, *c));
    let (u, v, w) = (b - a, d - c, a - c);
    let (uu, uv, vv) = (u.norm_squared(), u.dot(&v), v.norm_squared());
    let denominator = uu * vv - uv * uv;
    if denominator > 1e-14 * uu * vv {
        let (uw, vw) = (u.dot(&w), v.dot(&w));
        let (s, t) = ((uv * vw - vv * uw) / denominator, (uu * vw - uv * uw) / denominator);
        if (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
            let (p, q) = (a + u * s, c + v * t);
            if (q - p).norm_squared() < (best.1 - best.0).norm_squared() {
                best = (p, q);
            }
        }
    }
    best
}

/// The edges of a closed polygon.
pub fn edges(polygon: &[Vec2]) -> impl Iterator<Item = (Vec2, Vec2)> + '_ {
    polygon.iter().enumerate().map(|(i, &a)| (a, polygon[(i + 1) % polygon.len()]))
}

/// Points nearer to each other than this are one (metres).
const SAME: f64 = 1e-9;

/// The convex hull of points, without corners of 180° and without repeats.
pub fn convex_hull(points: impl IntoIterator<Item = Vec2>) -> Vec<Vec2> {
    let mut points: Vec<Vec2> = points.into_iter().collect();
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let chain = |points: &mut dyn Iterator<Item = Vec2>| {
        let mut out: Vec<Vec2> = Vec::new();
        for p in points {
            while out.len() >= 2 && turn(out[out.len() - 2], out[out.len() - 1], p) <= 0.0 {
                out.pop();
            }
            out.push(p);
        }
        out.pop();
        out
    };
    let mut hull = chain(&mut points.iter().copied());
    hull.extend(chain(&mut points.iter().rev().copied()));
    // An edge as short as rounding has any direction: the whole hull might lie on its wrong side.
    hull.dedup_by(|b, a| (*b - *a).norm() < SAME);
    while hull.len() > 1 && (hull[hull.len() - 1] - hull[0]).norm() < SAME {
        hull.pop();
    }
    hull
}

/// How deep `p` is in a convex polygon: distance to its boundary within, minus the distance outside.
/// A point or a segment has no inside; of no corners at all it is -∞.
pub fn depth_in_convex(polygon: &[Vec2], p: Vec2) -> f64 {
    let mut distance = f64::INFINITY;
    let mut inside = polygon.len() > 2;
    for (a, b) in edges(polygon) {
        distance = distance.min((nearest_on_segment(&p, &a, &b) - p).norm());
        inside &= turn(a, b, p) >= 0.0;
    }
    if inside { distance } else { -distance }
}

/// The overlap of two convex polygons, again convex; touching ones give a point or a segment (within 1e-9 m).
pub fn convex_overlap(a: &[Vec2], b: &[Vec2]) -> Vec<Vec2> {
    if are_apart(a, b) {
        return Vec::new();
    }
    let mut points: Vec<Vec2> = a.iter().copied().filter(|&p| depth_in_convex(b, p) >= -SAME).collect();
    points.extend(b.iter().copied().filter(|&p| depth_in_convex(a, p) >= -SAME));
    for (p, q) in edges(a) {
        points.extend(edges(b).filter_map(|(r, s)| crossing([p, q], [r, s])));
    }
    convex_hull(points)
}

/// Whether the upright rectangles around two sets of points do not touch.
fn are_apart(a: &[Vec2], b: &[Vec2]) -> bool {
    let around = |points: &[Vec2]| {
        let none = (Vec2::repeat(f64::INFINITY), Vec2::repeat(f64::NEG_INFINITY));
        points.iter().fold(none, |(lo, hi), p| (lo.inf(p), hi.sup(p)))
    };
    let ((a_lo, a_hi), (b_lo, b_hi)) = (around(a), around(b));
    (a_lo - b_hi).sup(&(b_lo - a_hi)).max() > 2.0 * SAME
}

/// Where two segments cross, if they are not parallel.
pub fn crossing([a, b]: [Vec2; 2], [c, d]: [Vec2; 2]) -> Option<Vec2> {
    let (u, v) = (b - a, d - c);
    let denominator = u.perp(&v);
    if denominator.abs() <= 1e-12 * u.norm() * v.norm() {
        return None;
    }
    let (s, t) = ((c - a).perp(&v) / denominator, (c - a).perp(&u) / denominator);
    ((0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t)).then(|| a + u * s)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;
    use proptest::prelude::*;

    #[test]
    fn corners_that_rounding_has_split_are_one() {
        let corners = [[0.217, 0.0], [0.0, 0.217], [-0.217, 0.0], [0.0, -0.217]].map(Vec2::from);
        for turned in 0..360 {
            let (sin, cos) = f64::from(turned).to_radians().sin_cos();
            let turn = |p: Vec2| Vec2::new(1.3 + cos * p.x + sin * p.y, 0.4 - sin * p.x + cos * p.y);
            let mut points = Vec::new();
            for corner in corners.map(turn) {
                let ulp = 2.3e-16;
                points.extend([[0.0, 0.0], [ulp, 0.0], [-ulp, ulp], [0.0, -ulp]].map(|d| corner + Vec2::from(d)));
            }
            let hull = convex_hull(points);
            assert_eq!(hull.len(), 4, "{turned}");
            assert!((depth_in_convex(&hull, Vec2::new(1.3, 0.4)) - 0.217 / 2f64.sqrt()).abs() < 1e-9, "{turned}");
        }
    }

    fn square(x: f64, z: f64, half: f64) -> Vec<Vec2> {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(i, j)| Vec2::new(x + i * half, z + j * half))
            .to_vec()
    }

    #[test]
    fn overlaps_of_every_dimension() {
        let area = |p: &[Vec2]| edges(p).map(|(a, b)| a.perp(&b)).sum::<f64>() / 2.0;
        let a = square(0.0, 0.0, 1.0);
        assert_eq!(area(&convex_overlap(&a, &square(1.0, 1.0, 1.0))), 1.0);
        assert_eq!(area(&convex_overlap(&a, &square(0.0, 0.0, 0.5))), 1.0);
        assert_eq!(convex_overlap(&a, &square(2.0, 0.0, 1.0)).len(), 2);
        assert_eq!(convex_overlap(&a, &square(2.0, 2.0, 1.0)), [Vec2::new(1.0, 1.0)]);
        assert!(convex_overlap(&a, &square(2.1, 0.0, 1.0)).is_empty());
        assert_eq!(convex_overlap(&a, &[Vec2::new(-3.0, 0.0), Vec2::new(0.5, 0.0)]).len(), 2);
        assert!(convex_overlap(&a, &[]).is_empty());
    }

    #[test]
    fn depth_in_degenerate_hulls() {
        let p = Vec2::new(3.0, 4.0);
        assert_eq!(depth_in_convex(&[], p), f64::NEG_INFINITY);
        assert_eq!(depth_in_convex(&[Vec2::zeros()], p), -5.0);
        assert_eq!(depth_in_convex(&[Vec2::zeros(), Vec2::new(3.0, 0.0)], p), -4.0);
        assert_eq!(depth_in_convex(&square(3.0, 4.0, 2.0), p), 2.0);
    }

    proptest! {
        #[test]
        fn nearest_points_of_segments_are_nearest(v in prop::array::uniform12(-2i32..=2)) {
            // Small whole numbers make parallel, touching and zero-length segments common.
            let p = |i: usize| Vector3::new(f64::from(v[i]), f64::from(v[i + 1]), f64::from(v[i + 2]));
            let (a, b, c, d) = (p(0), p(3), p(6), p(9));
            let (x, y) = nearest_of_segments([&a, &b], [&c, &d]);
            let on = |q: &Vector3<f64>, a: &Vector3<f64>, b: &Vector3<f64>| (nearest_on_segment(q, a, b) - q).norm() < 1e-12;
            prop_assert!(on(&x, &a, &b) && on(&y, &c, &d));
            for i in 0..=20 {
                let q = a + (b - a) * (f64::from(i) / 20.0);
                prop_assert!((nearest_on_segment(&q, &c, &d) - q).norm() >= (y - x).norm() - 1e-12);
            }
        }

        #[test]
        fn hulls_hold_their_points(v in prop::collection::vec((-3i32..=3, -3i32..=3), 1..20)) {
            let points: Vec<Vec2> = v.iter().map(|&(x, z)| Vec2::new(f64::from(x), f64::from(z))).collect();
            let hull = convex_hull(points.iter().copied());
            for &p in &points {
                prop_assert!(depth_in_convex(&hull, p) >= 0.0 || hull.len() < 3 && depth_in_convex(&hull, p) > -1e-12);
            }
            if hull.len() > 2 {
                for i in 0..hull.len() {
                    prop_assert!(turn(hull[i], hull[(i + 1) % hull.len()], hull[(i + 2) % hull.len()]) > 0.0);
                }
            }
        }
    }
}
