//! The primitives of the part grammar as meshes: rounded boxes, turned profiles, swept sections, extruded polygons and
//! tapered boxes. All closed, all wound outward (see [`crate::mesh`]).

use crate::block::Block;
use crate::mesh::{Mesh, Surface};
use scenelang_layout::Vec3;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::ops::Range;

/// Sides of anything round and upright: a cylinder part is a 24-gon, and what is seen should be what is touched.
pub(crate) const SIDES: usize = 24;
/// Thinner than this (metres) is not drawn.
const THIN: f64 = 2e-6;

/// A point of a swept path: where, and the half width and half height of the section there.
pub(crate) type Station = (Vec3, f64, f64);

impl Mesh {
    /// A box with a small bevel, for boards and casings.
    pub(crate) fn board(&mut self, b: Block, s: &Surface) {
        self.rounded(b, 0.004, 1, s);
    }
    /// A box with soft edges, for upholstery.
    pub(crate) fn cushion(&mut self, b: Block, s: &Surface) {
        self.rounded(b, 0.4 * b.size().min().min(0.12), 3, s);
    }
    /// A box with edges rounded by `radius` (at most 45 % of the least extent) in `steps` per quarter. With one step the
    /// bevel is flat but shaded round.
    pub(crate) fn rounded(&mut self, b: Block, radius: f64, steps: usize, s: &Surface) {
        let size = b.size();
        if size.min() < THIN {
            return;
        }
        let r = radius.min(if steps == 1 { 0.2 } else { 0.45 } * size.min());
        let inner = size / 2.0 - Vec3::repeat(r);
        let group = self.group(s);
        // Rings of constant latitude from the bottom to the top; the two poles are the corners of the flat faces.
        let mut rings: Vec<Vec<u32>> = Vec::new();
        for half in [-1.0, 1.0] {
            for i in 0..=steps {
                let step = if half < 0.0 { i as f64 - steps as f64 } else { i as f64 } / steps as f64;
                let pole = step.abs() == 1.0;
                let (sin, cos) = if pole { (step, 0.0) } else { (step * FRAC_PI_2).sin_cos() };
                let mut ring = Vec::new();
                for (quarter, (sx, sz)) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].into_iter().enumerate()
                {
                    let mut last = None;
                    for j in 0..=steps {
                        let id = last.filter(|_| pole).unwrap_or_else(|| {
                            let (z, x) = turn(quarter * steps + j, 4 * steps);
                            let n = Vec3::new(cos * x, sin, cos * z);
                            let corner = Vec3::new(sx * inner.x, half * inner.y, sz * inner.z);
                            group.vertex(b.center() + corner + n * r, n)
                        });
                        last = Some(id);
                        ring.push(id);
                    }
                }
                rings.push(ring);
            }
        }
        for pair in rings.windows(2) {
            for j in 0..pair[0].len() {
                let k = (j + 1) % pair[0].len();
                group.quad(pair[0][j], pair[1][j], pair[1][k], pair[0][k]);
            }
        }
        let step = steps + 1;
        let [bottom, top] = [&rings[0], &rings[rings.len() - 1]].map(|r| [r[0], r[step], r[2 * step], r[3 * step]]);
        group.quad(bottom[0], bottom[1], bottom[2], bottom[3]);
        group.quad(top[0], top[3], top[2], top[1]);
    }
    /// A box with sharp edges, for small things in numbers.
    pub(crate) fn crisp(&mut self, b: Block, s: &Surface) {
        self.taper(b, b, s);
    }
    /// The hull of `foot`'s bottom face and `head`'s top face.
    pub(crate) fn taper(&mut self, foot: Block, head: Block, s: &Surface) {
        if foot.size().xz().max().max(head.size().xz().max()) < THIN || head.max.y - foot.min.y < THIN {
            return;
        }
        let ring = |b: Block, y: f64| {
            [(b.max.x, b.max.z), (b.min.x, b.max.z), (b.min.x, b.min.z), (b.max.x, b.min.z)]
                .map(|(x, z)| Vec3::new(x, y, z))
        };
        let (low, up) = (ring(foot, foot.min.y), ring(head, head.max.y));
        let group = self.group(s);
        group.facet(&low);
        group.facet(&[up[0], up[3], up[2], up[1]]);
        for i in 0..4 {
            let j = (i + 1) % 4;
            group.facet(&[low[i], up[i], up[j], low[j]]);
        }
    }
    /// An upright cylinder (elliptic if the box is not square) that fills the box, with a small bevel.
    pub(crate) fn drum(&mut self, b: Block, s: &Surface) {
        let size = b.size();
        if size.min() < THIN {
            return;
        }
        let bevel = 0.004_f64.min(0.1 * size.min());
        let (r, y) = (1.0 - 2.0 * bevel / size.x.min(size.z), bevel / size.y);
        self.lathe(b, &[(r, 0.0), (1.0, y), (1.0, 1.0 - y), (r, 1.0)], SIDES, s);
    }
    /// A ball (ellipsoid) that fills the box.
    pub(crate) fn ball(&mut self, b: Block, s: &Surface) {
        self.lathe(b, &sphere(8), 16, s);
    }
    /// A ball of fewer faces, for small ones in numbers.
    pub(crate) fn bead(&mut self, b: Block, s: &Surface) {
        self.lathe(b, &sphere(6), 12, s);
    }
    /// The same of flowers, of which a bunch has many.
    pub(crate) fn bud(&mut self, b: Block, s: &Surface) {
        self.lathe(b, &sphere(4), 8, s);
    }
    /// A profile turned about the upright axis of the box. Points are (radius, height), both as fractions of the box, from
    /// the bottom outside up (and, for a vessel, down again inside); open ends are closed by a disc, and a profile that ends at
    /// the height at which it begins is a ring. `sides` is a multiple of four, so that the extents are exact.
    pub(crate) fn lathe(&mut self, b: Block, profile: &[(f64, f64)], sides: usize, s: &Surface) {
        let size = b.size();
        let (Some(first), Some(last)) = (profile.first(), profile.last()) else { return };
        if size.min() < THIN {
            return;
        }
        let is_ring = first.1 == last.1 && first.0 > 0.0 && last.0 > 0.0;
        let mut points = profile.to_vec();
        if is_ring {
            points.push(*first);
        } else {
            points.insert(0, (0.0, first.1));
            points.push((0.0, last.1));
        }
        points.dedup();
        // Tangents in metres decide what is smooth: bends below 40 degrees.
        let mean = (size.x + size.z) / 4.0;
        let tangents: Vec<(f64, f64)> = points
            .windows(2)
            .map(|p| {
                let (r, y) = ((p[1].0 - p[0].0) * mean, (p[1].1 - p[0].1) * size.y);
                let length = r.hypot(y).max(1e-12);
                (r / length, y / length)
            })
            .collect();
        let joined = |i: usize, j: Option<usize>| {
            let (t, o) = (tangents[i], j.and_then(|j| tangents.get(j)).copied().unwrap_or(tangents[i]));
            if t.0 * o.0 + t.1 * o.1 > 0.76 { (t.0 + o.0, t.1 + o.1) } else { t }
        };
        let (rx, rz, center) = (size.x / 2.0, size.z / 2.0, b.center());
        let group = self.group(s);
        for i in 0..tangents.len() {
            let mut ring = |(r, y): (f64, f64), (tr, ty): (f64, f64)| -> Vec<u32> {
                (0..sides)
                    .map(|k| {
                        let (sin, cos) = turn(k, sides);
                        let n = Vec3::new(ty * rz * cos, -tr * rx * rz / mean, ty * rx * sin);
                        let p = Vec3::new(center.x + r * rx * cos, b.min.y + y * size.y, center.z + r * rz * sin);
                        group.vertex(p, n.try_normalize(1e-18).unwrap_or_else(Vec3::y))
                    })
                    .collect()
            };
            let low = ring(points[i], joined(i, i.checked_sub(1)));
            let up = ring(points[i + 1], joined(i, Some(i + 1)));
            for j in 0..sides {
                let k = (j + 1) % sides;
                group.triangle(low[j], up[j], low[k]);
                group.triangle(up[j], up[k], low[k]);
            }
        }
    }
    /// An elliptic section of `sides` carried along a path; `up` is roughly the direction of the half height.
    pub(crate) fn sweep(&mut self, path: &[Station], up: Vec3, sides: usize, s: &Surface) {
        if path.len() < 2 {
            return;
        }
        let group = self.group(s);
        let mut rings = Vec::new();
        let mut ends = Vec::new();
        for (i, &(at, a, b)) in path.iter().enumerate() {
            let before = path[i.saturating_sub(1)].0;
            let after = path[(i + 1).min(path.len() - 1)].0;
            let Some(t) = (after - before).try_normalize(1e-12) else { return };
            let e1 = up.cross(&t).try_normalize(1e-9).unwrap_or_else(|| t.cross(&Vec3::new(t.y, t.z, t.x)).normalize());
            let e2 = t.cross(&e1);
            let ring: Vec<u32> = (0..sides)
                .map(|k| {
                    let (sin, cos) = turn(k, sides);
                    let n = e1 * (cos * b.max(1e-6)) + e2 * (sin * a.max(1e-6));
                    group.vertex(at + e1 * (cos * a) + e2 * (sin * b), n.normalize())
                })
                .collect();
            if i == 0 || i + 1 == path.len() {
                ends.push(
                    (0..sides).map(|k| turn(k, sides)).map(|(sin, cos)| at + e1 * (cos * a) + e2 * (sin * b)).collect(),
                );
            }
            rings.push(ring);
        }
        for pair in rings.windows(2) {
            for j in 0..sides {
                let k = (j + 1) % sides;
                group.triangle(pair[0][j], pair[0][k], pair[1][j]);
                group.triangle(pair[1][j], pair[0][k], pair[1][k]);
            }
        }
        let ends: [Vec<Vec3>; 2] = ends.try_into().unwrap_or_default();
        let [mut start, end] = ends;
        start.reverse();
        group.facet(&start);
        group.facet(&end);
        if let [(from, ..), (to, ..)] = path {
            self.lies_along(to - from);
        }
    }
    /// A round bar from one point to another.
    pub(crate) fn rod(&mut self, from: Vec3, to: Vec3, radius: f64, s: &Surface) {
        self.tube(&[from, to], radius, s);
    }
    /// A round bar along points.
    pub(crate) fn tube(&mut self, points: &[Vec3], radius: f64, s: &Surface) {
        let path: Vec<Station> = points.iter().map(|p| (*p, radius, radius)).collect();
        self.sweep(&path, Vec3::new(0.3, 0.9, 0.2), 10, s);
    }
    /// A disc that fills a box, with its axis along x (0) or z (2).
    pub(crate) fn disc(&mut self, axis: usize, b: Block, s: &Surface) {
        const SIDES: usize = 20;
        let (c, half) = (b.center(), b.size() / 2.0);
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let at = |k: usize| {
            // Exact at the quarters, so that the disc fills the box.
            let (sin, cos) = match 4 * k / SIDES {
                quarter if (4 * k).is_multiple_of(SIDES) => {
                    [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][quarter % 4]
                }
                _ => (TAU * k as f64 / SIDES as f64).sin_cos(),
            };
            (c[u] + half[u] * cos, c[v] + half[v] * sin)
        };
        let round: Vec<(f64, f64)> = (0..SIDES).map(at).collect();
        self.extrude(axis, &round, b.min[axis]..b.max[axis], s);
    }
    /// A convex polygon carried straight along an axis (0 x, 1 y, 2 z). Its points are in the two axes that follow:
    /// (y, z), (z, x) or (x, y).
    pub(crate) fn extrude(&mut self, axis: usize, polygon: &[(f64, f64)], range: Range<f64>, s: &Surface) {
        if range.end - range.start < THIN || polygon.len() < 3 {
            return;
        }
        let area: f64 = (0..polygon.len())
            .map(|i| {
                let (p, q) = (polygon[i], polygon[(i + 1) % polygon.len()]);
                p.0 * q.1 - p.1 * q.0
            })
            .sum();
        let mut outline = polygon.to_vec();
        if area < 0.0 {
            outline.reverse();
        }
        let at = |along: f64| -> Vec<Vec3> {
            let point = |&(u, v): &(f64, f64)| {
                let mut p = Vec3::zeros();
                (p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]) = (along, u, v);
                p
            };
            outline.iter().map(point).collect()
        };
        let (low, up) = (at(range.start), at(range.end));
        let group = self.group(s);
        for i in 0..low.len() {
            let j = (i + 1) % low.len();
            group.facet(&[low[i], low[j], up[j], up[i]]);
        }
        group.facet(&up);
        group.facet(&low.into_iter().rev().collect::<Vec<_>>());
    }
}

/// The profile of a ball in `bands`.
pub(crate) fn sphere(bands: usize) -> Vec<(f64, f64)> {
    (0..=bands).map(|i| turn(i, 2 * bands)).map(|(r, y)| (r, 0.5 - 0.5 * y)).collect()
}

/// Sine and cosine of `k` of `n` equal turns, exact at the quarters so that extents are exact.
pub(crate) fn turn(k: usize, n: usize) -> (f64, f64) {
    match (4 * k) % (4 * n) {
        0 => (0.0, 1.0),
        q if q == n => (1.0, 0.0),
        q if q == 2 * n => (0.0, -1.0),
        q if q == 3 * n => (-1.0, 0.0),
        _ => (k as f64 / n as f64 * TAU).sin_cos(),
    }
}
