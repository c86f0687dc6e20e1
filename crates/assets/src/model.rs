//! A model under construction: what is touched (convex parts) and what is seen (the mesh), drawn together.

use crate::block::Block;
use crate::mesh::{Mesh, Surface};
use scenelang_layout::{Joint, Part, Vec3};

/// Parts and mesh of one object, in its own frame.
#[derive(Debug, Default)]
pub(crate) struct BuiltModel {
    /// Convex parts.
    pub parts: Vec<Part>,
    /// Triangles.
    pub mesh: Mesh,
    /// Height of the support surface, where it is not the top.
    pub surface: Option<f64>,
    /// What opens, see `families::moving`.
    pub joints: Vec<Joint>,
}

impl BuiltModel {
    /// A box that is touched and drawn by hand.
    pub fn solid(&mut self, b: Block) {
        if b.size().min() > 0.0 {
            self.parts.push(Part::Box { pos: b.center(), size: b.size(), rot: Vec3::zeros() });
        }
    }
    /// A round solid that fills a box, drawn by hand: a cylinder, or a hull where the box is not square.
    pub fn solid_drum(&mut self, b: Block) {
        let (size, c) = (b.size(), b.center());
        if size.min() <= 0.0 {
            return;
        }
        if (size.x - size.z).abs() < 1e-9 {
            self.parts.push(Part::Cylinder { pos: c, radius: size.x / 2.0, height: size.y, rot: Vec3::zeros() });
            return;
        }
        let quarter = |k: usize| (k as f64 * std::f64::consts::PI / 8.0).sin_cos();
        let mut points = Vec::new();
        for k in 0..16 {
            // Exact at the quarters, so that the hull fills the box.
            let (sin, cos) = match k {
                0 => (0.0, 1.0),
                4 => (1.0, 0.0),
                8 => (0.0, -1.0),
                12 => (-1.0, 0.0),
                _ => quarter(k),
            };
            for y in [b.min.y, b.max.y] {
                points.push(Vec3::new(c.x + cos * size.x / 2.0, y, c.z + sin * size.z / 2.0));
            }
        }
        self.parts.push(Part::Hull { points });
    }
    /// The hull of points, drawn by hand.
    pub fn solid_hull(&mut self, points: Vec<Vec3>) {
        self.parts.push(Part::Hull { points });
    }
    /// A bevelled box.
    pub fn board(&mut self, b: Block, s: &Surface) {
        self.solid(b);
        self.mesh.board(b, s);
    }
    /// A soft box.
    pub fn cushion(&mut self, b: Block, s: &Surface) {
        self.solid(b);
        self.mesh.cushion(b, s);
    }
    /// A box with rounded edges.
    pub fn rounded(&mut self, b: Block, radius: f64, s: &Surface) {
        self.solid(b);
        self.mesh.rounded(b, radius, 3, s);
    }
    /// A bevelled upright cylinder.
    pub fn drum(&mut self, b: Block, s: &Surface) {
        self.solid_drum(b);
        self.mesh.drum(b, s);
    }
    /// A disc that fills a box, with its axis along x (0) or z (2): the solid is the box.
    pub fn disc(&mut self, axis: usize, b: Block, s: &Surface) {
        self.solid(b);
        self.mesh.disc(axis, b, s);
    }
    /// A turned profile; the solid is its cylinder.
    pub fn lathe(&mut self, b: Block, profile: &[(f64, f64)], s: &Surface) {
        self.solid_drum(b);
        self.mesh.lathe(b, profile, crate::shapes::SIDES, s);
    }
    /// The hull of `foot`'s bottom face and `head`'s top face.
    pub fn taper(&mut self, foot: Block, head: Block, s: &Surface) {
        if (head.max.y - foot.min.y).min(foot.size().xz().min()).min(head.size().xz().min()) > 0.0 {
            let face = |b: Block, y: f64| {
                [(b.min.x, b.min.z), (b.min.x, b.max.z), (b.max.x, b.min.z), (b.max.x, b.max.z)]
                    .map(|(x, z)| Vec3::new(x, y, z))
            };
            let points = [face(foot, foot.min.y), face(head, head.max.y)].concat();
            self.solid_hull(points);
        }
        self.mesh.taper(foot, head, s);
    }
    /// A convex polygon carried along an axis, see [`Mesh::extrude`].
    pub fn extrude(&mut self, axis: usize, polygon: &[(f64, f64)], range: std::ops::Range<f64>, s: &Surface) {
        let mut points = Vec::new();
        for along in [range.start, range.end] {
            for &(u, v) in polygon {
                let mut p = Vec3::zeros();
                (p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]) = (along, u, v);
                points.push(p);
            }
        }
        self.solid_hull(points);
        self.mesh.extrude(axis, polygon, range, s);
    }
    /// Four square legs, thinner at the foot, at the corners of a box they stand in.
    pub fn legs(&mut self, stand: Block, thick: f64, s: &Surface) {
        let t = thick.min(0.3 * stand.size().x).min(0.3 * stand.size().z);
        let head = stand.x(stand.min.x..stand.min.x + t).z(stand.min.z..stand.min.z + t);
        let foot = head.x(head.min.x..head.min.x + 0.7 * t).z(head.min.z..head.min.z + 0.7 * t);
        let about = stand.center();
        let put = |b: Block| b.moved(-about.x, 0.0, -about.z).four_corners().map(|c| c.moved(about.x, 0.0, about.z));
        for (f, h) in put(foot).into_iter().zip(put(head)) {
            self.taper(f, h, s);
        }
    }
}
