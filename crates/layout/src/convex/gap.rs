//! The signed gap of two convex polyhedra.
//!
//! Apart: parry's GJK proposes nearest points, and they are believed only where the slab between them proves the
//! distance. Else the faces of the Minkowski difference decide: those of either body, and those spanned by two edges
//! whose arcs cross on the Gauss map.

use super::Convex;
use crate::Vec3;
use crate::obb;
use crate::planar::nearest_of_segments;
use crate::separation::Separation;
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query::gjk::{CsoPoint, GJKResult, VoronoiSimplex, closest_points};
use parry3d_f64::shape::SupportMap;

/// Below this many metres nearest points are too close to give a direction: the axes do it better.
const TOUCHING: f64 = 1e-7;

/// The signed gap of two convex bodies; error at most 1e-7 of it.
pub fn separation(a: &Convex, b: &Convex) -> Separation {
    if let (Some(x), Some(y)) = (a.as_box(), b.as_box()) {
        return obb::separation(x, y);
    }
    if let Some(apart) = certified(a, b, proposed(a, b)) {
        return apart;
    }
    let axis = best_axis(a, b);
    if axis.gap <= TOUCHING { axis } else { certified(a, b, of_features(a, b)).unwrap_or(axis) }
}

/// The slab across two points, if it lies between the bodies and is as thick as the points are apart.
fn certified(a: &Convex, b: &Convex, points: Option<(Vec3, Vec3)>) -> Option<Separation> {
    let (p, q) = points?;
    let distance = (q - p).norm();
    if distance <= TOUCHING {
        return None;
    }
    let normal = (q - p) / distance;
    let gap = -a.support_height(&normal) - b.support_height(&-normal);
    (distance - gap <= 1e-7 * distance + 1e-12).then_some(Separation { gap, normal })
}

/// A body as parry sees it, relative to a point near both so that no digits are lost.
struct Cloud<'a> {
    vertices: &'a [Vec3],
    origin: Vec3,
}

impl SupportMap for Cloud<'_> {
    fn local_support_point(&self, dir: Vector) -> Vector {
        let dir: Vec3 = dir.into();
        let mut best = (f64::NEG_INFINITY, &self.origin);
        for v in self.vertices {
            let height = v.dot(&dir);
            if height > best.0 {
                best = (height, v);
            }
        }
        (best.1 - self.origin).into()
    }
}

/// Nearest points as GJK finds them; `None` where it sees an overlap or gives up.
fn proposed(a: &Convex, b: &Convex) -> Option<(Vec3, Vec3)> {
    let origin = (a.aabb.min + a.aabb.max) / 2.0;
    let (first, second) = (Cloud { vertices: &a.vertices, origin }, Cloud { vertices: &b.vertices, origin });
    let towards: Vec3 = origin - (b.aabb.min + b.aabb.max) / 2.0;
    let towards = towards.try_normalize(1e-12).unwrap_or(Vec3::x());
    let mut simplex = VoronoiSimplex::new();
    simplex.reset(CsoPoint::from_shapes(&Pose::IDENTITY, &first, &second, towards.into()));
    match closest_points(&Pose::IDENTITY, &first, &second, f64::MAX, true, &mut simplex) {
        GJKResult::ClosestPoints(p, q, _) => {
            let (p, q): (Vec3, Vec3) = (p.into(), q.into());
            Some((p + origin, q + origin))
        }
        _ => None,
    }
}

/// The greatest slab over the faces of the Minkowski difference: exact for bodies that overlap or touch.
fn best_axis(a: &Convex, b: &Convex) -> Separation {
    let mut best = Separation { gap: f64::NEG_INFINITY, normal: Vec3::y() };
    let mut consider = |normal: Vec3| {
        let gap = -a.support_height(&normal) - b.support_height(&-normal);
        if gap > best.gap {
            best = Separation { gap, normal };
        }
        best.gap
    };
    let mut gap = f64::NEG_INFINITY;
    for normal in a.faces().iter().map(|f| f.normal).chain(b.faces().iter().map(|f| -f.normal)) {
        gap = consider(normal);
    }
    for x in &a.sides().edges {
        let [p, p2] = a.ends(x);
        for y in &b.sides().edges {
            let [q, q2] = b.ends(y);
            let cross = (p2 - p).cross(&(q2 - q));
            let length = cross.norm();
            if length <= 1e-9 * (p2 - p).norm() * (q2 - q).norm() || !spans_face(x.normals, y.normals) {
                continue;
            }
            let normal = cross / length;
            // Of the two directions the one that leaves a: towards the normals beside its edge.
            let normal = if normal.dot(&(x.normals[0] + x.normals[1])) < 0.0 { -normal } else { normal };
            if normal.dot(&(q - p)) > gap {
                gap = consider(normal);
            }
        }
    }
    best
}

/// Whether the arcs of two edges, the second mirrored, cross on the sphere of directions.
fn spans_face([a, b]: [Vec3; 2], [c, d]: [Vec3; 2]) -> bool {
    let (c, d) = (-c, -d);
    let (ab, cd) = (a.cross(&b), c.cross(&d));
    let (ca, da, ac, bc) = (c.dot(&ab), d.dot(&ab), a.dot(&cd), b.dot(&cd));
    // Each arc's ends on either side of the other's plane, and both arcs on the same half of the sphere.
    ca * da < 0.0 && ac * bc < 0.0 && ca * bc > 0.0
}

/// Nearest points by trying all pairs of edges, and all corners against all faces.
fn of_features(a: &Convex, b: &Convex) -> Option<(Vec3, Vec3)> {
    let mut best: Option<(f64, (Vec3, Vec3))> = None;
    let mut consider = |pair: (Vec3, Vec3)| {
        let distance = (pair.1 - pair.0).norm();
        if best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, pair));
        }
    };
    for x in &a.sides().edges {
        let [p, p2] = a.ends(x);
        for y in &b.sides().edges {
            let [q, q2] = b.ends(y);
            consider(nearest_of_segments([&p, &p2], [&q, &q2]));
        }
    }
    for q in &b.vertices {
        above_faces(a, q).for_each(|p| consider((p, *q)));
    }
    for p in &a.vertices {
        above_faces(b, p).for_each(|q| consider((*p, q)));
    }
    best.map(|(_, pair)| pair)
}

/// The feet of the perpendiculars from `p` to those faces of a body that it is in front of.
fn above_faces<'a>(body: &'a Convex, p: &'a Vec3) -> impl Iterator<Item = Vec3> + 'a {
    body.faces().iter().filter_map(move |face| {
        let corners: Vec<Vec3> = body.face_corners(face).collect();
        let height = face.normal.dot(&(p - corners[0]));
        let foot = p - face.normal * height;
        // Faces are not wound alike, so all turns must agree, whichever way.
        let turns = (0..corners.len()).map(|i| {
            let (c, d) = (corners[i], corners[(i + 1) % corners.len()]);
            face.normal.dot(&(d - c).cross(&(foot - c)))
        });
        let (low, high) = turns.fold((0.0f64, 0.0f64), |(l, h), t| (l.min(t), h.max(t)));
        (height > 0.0 && (low >= 0.0 || high <= 0.0)).then_some(foot)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotation;

    /// GJK is hardly ever at a loss, so what stands in for it is tried alone.
    #[test]
    fn features_find_the_distance_too() {
        let tetrahedron = [Vec3::zeros(), Vec3::x(), Vec3::y() * 0.7, Vec3::z() * 1.3];
        let shapes = [
            Convex::from_cylinder(&Vec3::zeros(), &rotation::matrix(Vec3::zeros()), 0.4, 1.0),
            Convex::from_hull(&tetrahedron).expect("four points not in one plane"),
        ];
        let mut apart = 0;
        for i in 0..200 {
            let t = f64::from(i);
            let (axes, by) =
                (rotation::matrix(Vec3::new(t * 37.0, t * 15.0, t * 90.0)), Vec3::new(1.3, t % 7.0 * 0.2, -0.4));
            let (a, b) = (&shapes[i as usize % 2], shapes[i as usize / 2 % 2].moved(&axes, &by));
            let gap = separation(a, &b).gap;
            if gap > TOUCHING {
                apart += 1;
                let found = certified(a, &b, of_features(a, &b)).map(|s| s.gap);
                assert!(found.is_some_and(|f| (f - gap).abs() < 1e-6), "{found:?} {gap}");
            }
        }
        assert!(apart > 100, "{apart}");
    }
}
