//! A second opinion on parts: corners, bounds, centre of mass, what touches the floor. Shares no code with the library.

use scenelang_assets::Mesh;
use scenelang_layout::{Part, Vec3};

/// The corners of a part; parts of this library are not turned.
pub fn corners(part: &Part) -> Vec<Vec3> {
    match part {
        Part::Box { pos, size, rot } => {
            assert_eq!(*rot, Vec3::zeros());
            (0..8).map(|k| pos + Vec3::from_fn(|i, _| if k >> i & 1 == 1 { size[i] } else { -size[i] } / 2.0)).collect()
        }
        Part::Cylinder { pos, radius, height, rot } => {
            assert_eq!(*rot, Vec3::zeros());
            (0..48)
                .map(|k| {
                    let (sin, cos) = (f64::from(k / 2) * 15.0).to_radians().sin_cos();
                    pos + Vec3::new(radius * cos, height * (f64::from(k % 2) - 0.5), radius * sin)
                })
                .collect()
        }
        Part::Hull { points } => points.clone(),
    }
}

pub fn bounds(points: impl IntoIterator<Item = Vec3>) -> (Vec3, Vec3) {
    points.into_iter().fold((Vec3::repeat(f64::MAX), Vec3::repeat(f64::MIN)), |(lo, hi), p| (lo.inf(&p), hi.sup(&p)))
}

/// The planes of a hull, as (outward normal, offset), by trying every triple of points.
pub fn planes(points: &[Vec3]) -> Vec<(Vec3, f64)> {
    let (lo, hi) = bounds(points.iter().copied());
    let eps = 1e-9 * (hi - lo).norm();
    let mut out: Vec<(Vec3, f64)> = Vec::new();
    for (i, a) in points.iter().enumerate() {
        for (j, b) in points.iter().enumerate().skip(i + 1) {
            for c in &points[j + 1..] {
                let n = (b - a).cross(&(c - a));
                if n.norm() < 1e-9 * (b - a).norm() * (c - a).norm() {
                    continue;
                }
                for n in [n.normalize(), -n.normalize()] {
                    let d = n.dot(a);
                    if points.iter().all(|p| n.dot(p) <= d + eps)
                        && !out.iter().any(|(m, e)| (m - n).norm() < 1e-7 && (e - d).abs() < eps)
                    {
                        out.push((n, d));
                    }
                }
            }
        }
    }
    out
}

/// Volume and centre of mass; hulls by sampling a grid.
pub fn mass(part: &Part) -> (f64, Vec3) {
    match part {
        Part::Box { pos, size, .. } => (size.product(), *pos),
        Part::Cylinder { pos, radius, height, .. } => {
            (12.0 * radius * radius * 15_f64.to_radians().sin() * height, *pos)
        }
        Part::Hull { points } => {
            let planes = planes(points);
            let (lo, hi) = bounds(points.iter().copied());
            const N: usize = 14;
            let mut sum = Vec3::zeros();
            let mut hits = 0;
            for k in 0..N * N * N {
                let at = [k % N, k / N % N, k / N / N].map(|i| (i as f64 + 0.5) / N as f64);
                let p = lo + (hi - lo).component_mul(&Vec3::from(at));
                if planes.iter().all(|(n, d)| n.dot(&p) <= *d) {
                    sum += p;
                    hits += 1;
                }
            }
            assert!(hits > 0, "a flat hull: {points:?}");
            ((hi - lo).product() * f64::from(hits) / (N * N * N) as f64, sum / f64::from(hits))
        }
    }
}

/// How far (x, z) is inside the convex hull of points of the plane; negative outside.
pub fn inside_hull(points: &[(f64, f64)], at: (f64, f64)) -> f64 {
    let mut worst = f64::MAX;
    for p in points {
        for q in points {
            let (dx, dz) = (q.0 - p.0, q.1 - p.1);
            let length = dx.hypot(dz);
            if length < 1e-12 {
                continue;
            }
            let side = |r: &(f64, f64)| (dx * (r.1 - p.1) - dz * (r.0 - p.0)) / length;
            if points.iter().all(|r| side(r) >= -1e-12) {
                worst = worst.min(side(&at));
            }
        }
    }
    worst
}

/// Signed volume by the divergence theorem; positive if the triangles wind outward.
pub fn volume(mesh: &Mesh) -> f64 {
    triangles(mesh).map(|[a, b, c]| a.dot(&b.cross(&c)) / 6.0).sum()
}

pub fn triangles(mesh: &Mesh) -> impl Iterator<Item = [Vec3; 3]> + '_ {
    mesh.groups.iter().flat_map(|g| {
        g.indices.chunks(3).map(|t| [t[0], t[1], t[2]].map(|i| Vec3::from(g.positions[i as usize].map(f64::from))))
    })
}
