//! Triangles in groups of one surface each, and the solids that become triangles.
//!
//! A triangle's corners stand so that `(b − a) × (c − a)` (the usual formula) points out of the solid; in this
//! left-handed frame that is clockwise seen from outside, as Unity wants it.

use super::polygon::triangles;
use scenelang_layout::Vec3;
use scenelang_layout::convex::Convex;
use scenelang_layout::planar::{Vec2, edges};

/// Triangles of one surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshGroup {
    /// Index into [`crate::Scene::surfaces`].
    pub surface: usize,
    /// Corners, metres, in the frame of whatever owns the mesh.
    pub positions: Vec<[f32; 3]>,
    /// Unit normals, one for each corner.
    pub normals: Vec<[f32; 3]>,
    /// Where on its material each corner is, metres; grain runs along the second axis.
    pub uvs: Vec<[f32; 2]>,
    /// Three for each triangle.
    pub indices: Vec<u32>,
}

impl MeshGroup {
    /// No triangles yet.
    pub fn new(surface: usize) -> Self {
        Self { surface, ..Self::default() }
    }

    /// A flat convex face; its corners in order round it, either way, at least three.
    pub fn face(&mut self, corners: &[Vec3], normal: &Vec3) {
        let first = self.positions.len() as u32;
        self.positions.extend(corners.iter().map(narrow));
        self.normals.extend(std::iter::repeat_n(narrow(normal), corners.len()));
        // Faces in one plane have one origin, so that nothing breaks where they meet; the second axis runs up.
        let across = normal.cross(&Vec3::y()).try_normalize(1e-6).unwrap_or_else(Vec3::x);
        let up = if normal.y.abs() > 1.0 - 1e-9 { Vec3::z() } else { across.cross(normal) };
        self.uvs.extend(corners.iter().map(|p| [p.dot(&across) as f32, p.dot(&up) as f32]));
        let forward = (corners[1] - corners[0]).cross(&(corners[2] - corners[0])).dot(normal) > 0.0;
        for i in 2..corners.len() as u32 {
            let (b, c) = if forward { (i - 1, i) } else { (i, i - 1) };
            self.indices.extend([first, first + b, first + c]);
        }
    }

    /// An upright prism over a polygon of positive winding, between two heights.
    pub fn prism(&mut self, polygon: &[Vec2], low: f64, high: f64) {
        let at = |p: Vec2, y| Vec3::new(p.x, y, p.y);
        for (a, b) in edges(polygon) {
            let normal = super::polygon::outward(a, b);
            self.face(&[at(a, low), at(a, high), at(b, high), at(b, low)], &Vec3::new(normal.x, 0.0, normal.y));
        }
        for t in triangles(polygon) {
            self.face(&t.map(|i| at(polygon[i], high)), &Vec3::y());
            self.face(&t.map(|i| at(polygon[i], low)), &-Vec3::y());
        }
    }

    pub fn solid(&mut self, body: &Convex) {
        for face in body.faces() {
            self.face(&body.face_corners(face).collect::<Vec<_>>(), &face.normal);
        }
    }

    /// The corners of each triangle.
    pub fn triangles(&self) -> impl Iterator<Item = [[f32; 3]; 3]> + '_ {
        self.indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]].map(|i| self.positions[i as usize]))
    }
}

/// The volume that outward triangles enclose, cubic metres.
pub fn enclosed(group: &MeshGroup) -> f64 {
    let wide = |p: [f32; 3]| Vec3::from(p.map(f64::from));
    group.triangles().map(|t| t.map(wide)).map(|[a, b, c]| a.dot(&b.cross(&c))).sum::<f64>() / 6.0
}

fn narrow(v: &Vec3) -> [f32; 3] {
    [v.x as f32, v.y as f32, v.z as f32]
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_layout::Part;

    #[test]
    fn solids_are_closed_and_face_outwards() {
        let rot = Vec3::new(20.0, 40.0, 60.0);
        let pos = Vec3::new(1.0, 2.0, 3.0);
        let l = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 2.0], [2.0, 5.0], [0.0, 5.0]].map(Vec2::from);
        let gon = 12.0 * (std::f64::consts::TAU / 24.0).sin();
        let tetrahedron = vec![Vec3::zeros(), Vec3::x(), Vec3::y(), Vec3::z()];
        let mut prism = MeshGroup::new(0);
        prism.prism(&l, 1.0, 3.0);
        let part = |p: Part| {
            let mut g = MeshGroup::new(0);
            g.solid(&Convex::from_part(&p).unwrap());
            g
        };
        for (group, volume) in [
            (prism, 28.0),
            (part(Part::Box { pos, size: Vec3::new(1.0, 2.0, 3.0), rot }), 6.0),
            (part(Part::Cylinder { pos, radius: 2.0, height: 0.5, rot }), gon * 4.0 * 0.5),
            (part(Part::Hull { points: tetrahedron }), 1.0 / 6.0),
        ] {
            assert!((enclosed(&group) - volume).abs() < 1e-4, "{} is not {volume}", enclosed(&group));
            assert_eq!(group.positions.len(), group.normals.len());
            for (t, corners) in group.indices.chunks(3).zip(group.triangles()) {
                let [a, b, c] = corners.map(|p| Vec3::from(p.map(f64::from)));
                let n = Vec3::from(group.normals[t[0] as usize].map(f64::from));
                assert!((b - a).cross(&(c - a)).dot(&n) > 0.0);
            }
        }
    }
}
