//! Convex hulls: parry's triangles, joined into flat faces and checked.

use super::{Convex, Edge, Face, Surface};
use crate::Vec3;
use crate::planar::{Vec2, convex_hull};
use crate::separation::Aabb;
use parry3d_f64::math::Vector;
use parry3d_f64::transformation::try_convex_hull;

/// How many points a hull may have: what physics engines take, and enough for furniture.
pub const MAX_HULL_POINTS: usize = 255;

/// The hull of points, or `None`: too few, too many, or nearly in one plane.
pub(super) fn hull(points: &[Vec3]) -> Option<Convex> {
    if points.len() < 4 || points.len() > MAX_HULL_POINTS {
        return None;
    }
    let aabb = Aabb::of(points.iter().copied());
    let size = (aabb.max - aabb.min).norm();
    let middle = (aabb.min + aabb.max) / 2.0;
    // Scaled to unit size about the middle, so that parry's absolute tolerances mean the same for all.
    let mut unit: Vec<Vec3> = Vec::with_capacity(points.len());
    for p in points {
        let p = (p - middle) / size;
        if unit.iter().all(|q| (p - q).norm() > 1e-9) {
            unit.push(p);
        }
    }
    if is_flat(&unit) {
        return None;
    }
    let cloud: Vec<Vector> = unit.iter().map(|p| (*p).into()).collect();
    let (corners, triangles) = try_convex_hull(&cloud).ok()?;
    let corners: Vec<Vec3> = corners.into_iter().map(Into::into).collect();
    let body = join(&corners, &triangles)?;
    // Not taken on trust: every point must be behind every face.
    let holds = |f: &Face| {
        let height = body.vertices[f.corners[0] as usize].dot(&f.normal);
        unit.iter().all(|p| p.dot(&f.normal) <= height + 1e-7)
    };
    if !body.faces().iter().all(holds) {
        return None;
    }
    let vertices: Vec<Vec3> = body.vertices.iter().map(|v| v * size + middle).collect();
    Some(Convex::new(vertices, body.surface))
}

/// Whether points of unit size lie in one plane, or nearly.
fn is_flat(points: &[Vec3]) -> bool {
    let farthest = |height: &dyn Fn(&Vec3) -> f64| {
        points.iter().copied().max_by(|a, b| height(a).total_cmp(&height(b))).unwrap_or_default()
    };
    let a = points.first().copied().unwrap_or_default();
    let b = farthest(&|p| (p - a).norm());
    let along = (b - a).try_normalize(1e-6).unwrap_or_default();
    let c = farthest(&|p| (p - a).cross(&along).norm());
    let Some(normal) = along.cross(&(c - a)).try_normalize(1e-6) else { return true };
    let d = farthest(&|p| (p - a).dot(&normal).abs());
    (d - a).dot(&normal).abs() < 1e-6
}

/// Triangles in one plane become one face; edges within a face go.
fn join(corners: &[Vec3], triangles: &[[u32; 3]]) -> Option<Convex> {
    let normal = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| corners[i as usize]);
        (b - a).cross(&(c - a)).try_normalize(1e-14)
    };
    // Slivers have no direction of their own and add no face.
    let triangles: Vec<(&[u32; 3], Vec3)> = triangles.iter().filter_map(|t| Some((t, normal(t)?))).collect();
    let mut faces: Vec<(Vec3, Vec<u32>)> = Vec::new();
    let mut face_of = Vec::with_capacity(triangles.len());
    for (t, n) in &triangles {
        let same = faces.iter().position(|(m, _)| (m - n).norm() < 1e-6);
        let index = same.unwrap_or_else(|| {
            faces.push((*n, Vec::new()));
            faces.len() - 1
        });
        faces[index].1.extend_from_slice(*t);
        face_of.push(index);
    }
    let mut sides: Vec<([u32; 2], usize)> = Vec::new();
    for ((t, _), face) in triangles.iter().zip(&face_of) {
        for i in 0..3 {
            let (a, b) = (t[i], t[(i + 1) % 3]);
            sides.push(([a.min(b), a.max(b)], *face));
        }
    }
    sides.sort_unstable();
    let edges = sides
        .chunk_by(|x, y| x.0 == y.0)
        .filter(|pair| pair.len() == 2 && pair[0].1 != pair[1].1)
        .map(|pair| Edge { ends: pair[0].0, normals: [faces[pair[0].1].0, faces[pair[1].1].0] })
        .collect();
    let faces: Vec<Face> = faces.into_iter().map(|(normal, at)| outline(corners, normal, at)).collect();
    let flat = faces.len() < 4 || faces.iter().any(|f| f.corners.len() < 3);
    (!flat).then(|| Convex::new(corners.to_vec(), Surface::new(faces, edges)))
}

/// The corners of a face in order, without those within.
fn outline(corners: &[Vec3], normal: Vec3, mut indices: Vec<u32>) -> Face {
    indices.sort_unstable();
    indices.dedup();
    let u = if normal.x.abs() < 0.6 { normal.cross(&Vec3::x()) } else { normal.cross(&Vec3::y()) }.normalize();
    let v = normal.cross(&u);
    let flat = |i: u32| Vec2::new(corners[i as usize].dot(&u), corners[i as usize].dot(&v));
    let order = convex_hull(indices.iter().map(|&i| flat(i)));
    let corners: Vec<u32> = order.iter().filter_map(|p| indices.iter().copied().find(|&i| flat(i) == *p)).collect();
    Face { normal, corners: corners.into() }
}
