//! A convex body cut at a height: what is left above keeps its faces, cut, and gets a level one below.

use super::{Convex, Face};
use crate::Vec3;
use std::collections::BTreeMap;

/// What is not lower than a height; `None`: nothing reaches above it.
pub(super) fn above(body: &Convex, height: f64) -> Option<Convex> {
    let is_kept = |v: &Vec3| v.y >= height;
    if body.vertices.iter().all(is_kept) {
        return Some(body.clone());
    }
    if !body.vertices.iter().any(|v| v.y > height) {
        return None;
    }
    let mut vertices: Vec<Vec3> = Vec::new();
    let kept: Vec<Option<u32>> = body
        .vertices
        .iter()
        .map(|v| {
            is_kept(v).then(|| {
                vertices.push(*v);
                vertices.len() as u32 - 1
            })
        })
        .collect();
    // Where an edge comes through the cut: once, for the two faces that share it.
    let mut through: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    let mut faces: Vec<Face> = Vec::new();
    for face in body.faces() {
        let mut corners: Vec<u32> = Vec::new();
        for (i, &a) in face.corners.iter().enumerate() {
            let b = face.corners[(i + 1) % face.corners.len()];
            corners.extend(kept[a as usize]);
            let (from, to) = (body.vertices[a as usize], body.vertices[b as usize]);
            if (from.y > height && to.y < height) || (from.y < height && to.y > height) {
                corners.push(*through.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                    let at = from + (to - from) * ((height - from.y) / (to.y - from.y));
                    vertices.push(Vec3::new(at.x, height, at.z));
                    vertices.len() as u32 - 1
                }));
            }
        }
        if corners.len() > 2 {
            faces.push(Face { normal: face.normal, corners: corners.into() });
        }
    }
    let mut floor: Vec<u32> = (0..vertices.len() as u32).filter(|&i| vertices[i as usize].y <= height).collect();
    let middle = floor.iter().fold(Vec3::zeros(), |sum, &i| sum + vertices[i as usize]) / floor.len().max(1) as f64;
    let around = |i: u32| (vertices[i as usize].z - middle.z).atan2(vertices[i as usize].x - middle.x);
    floor.sort_by(|a, b| around(*a).total_cmp(&around(*b)));
    if floor.len() > 2 {
        faces.push(Face { normal: -Vec3::y(), corners: floor.into() });
    }
    Some(Convex::from_faces(vertices, faces))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Obb, convex::separation, rotation};

    fn cuboid(center: [f64; 3], degrees: [f64; 3], size: [f64; 3]) -> Convex {
        let axes = rotation::matrix(Vec3::from(degrees));
        Convex::from_box(&Obb { center: Vec3::from(center), axes, half: Vec3::from(size) / 2.0 })
    }

    #[test]
    fn an_upright_box_becomes_a_lower_one() {
        let cut = above(&cuboid([0.0, 1.0, 0.0], [0.0; 3], [1.0, 2.0, 1.0]), 0.5).unwrap();
        assert_eq!((cut.vertices().len(), cut.faces().len()), (8, 6));
        assert_eq!((cut.aabb().min.y, cut.aabb().max.y), (0.5, 2.0));
        assert!(above(&cut, 2.0).is_none());
        assert_eq!(above(&cut, 0.5).unwrap(), cut);
    }

    #[test]
    fn a_sliver_that_leans_keeps_what_is_above() {
        // A millimetre thick and two metres long: too thin for a hull of points.
        let cut = above(&cuboid([0.0, 0.05, 0.0], [1.5, 344.367, 5.0], [1.779, 0.001, 0.897]), 0.06).unwrap();
        assert!(cut.aabb().min.y >= 0.06 && cut.aabb().max.y > 0.1);
        assert!(cut.faces().iter().all(|f| f.corners.len() > 2));
        let over = cuboid([0.0, 1.0, 0.0], [0.0; 3], [9.0, 0.2, 9.0]);
        let gap = separation(&cut, &over).gap;
        assert!((gap - (0.9 - cut.aabb().max.y)).abs() < 1e-9, "{gap}");
    }
}
