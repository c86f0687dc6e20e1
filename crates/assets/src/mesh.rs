//! Triangle meshes grouped by surface.
//!
//! The frame is left-handed (x right, y up, z to the front). A triangle (a, b, c) is wound so that (b − a) × (c − a),
//! by the usual formula, points out of the solid: seen from outside it runs clockwise, as Unity wants it. To write a
//! right-handed file, mirror x (positions and normals) and swap two indices of each triangle. Each primitive is closed.

use crate::apart::{MeshPrimitive, apart};
use crate::block::Block;
use crate::unwrap::unwrap;
use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use scenelang_layout::Vec3;

/// What a surface looks like. Equal names mean equal surfaces, over all assets.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Finish and colour: `wood-c8a272`.
    pub name: String,
    /// sRGB, each 0 to 1.
    pub color: [f32; 3],
    /// 0 a mirror, 1 chalk.
    pub roughness: f32,
    /// 0 to 1.
    pub metallic: f32,
    /// Light given off (sRGB, each 0 to 1), for lamps and screens.
    pub emissive: Option<[f32; 3]>,
    /// 1 opaque; glass is less.
    pub opacity: f32,
}

/// The triangles of one surface.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshGroup {
    /// Its look.
    pub surface: Surface,
    /// Vertices, in the frame of the object (metres).
    pub positions: Vec<[f32; 3]>,
    /// Unit normals, one per vertex, outward.
    pub normals: Vec<[f32; 3]>,
    /// Where on its material each vertex is, metres; the grain runs along the second axis. Empty where nobody said.
    pub uvs: Vec<[f32; 2]>,
    /// Three per triangle.
    pub indices: Vec<u32>,
}

/// A mesh: one group per surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// In order of first use.
    pub groups: Vec<MeshGroup>,
    /// The primitives that are still to be unwrapped, in the order in which they were drawn.
    solids: Vec<Solid>,
}

/// A primitive within a group: from its first index to that of the next of the same group.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Solid {
    group: usize,
    first: usize,
    /// From the axes that it was drawn along to those of the mesh.
    turn: UnitQuaternion<f64>,
}

impl From<Vec<MeshGroup>> for Mesh {
    fn from(groups: Vec<MeshGroup>) -> Self {
        Self { groups, solids: Vec::new() }
    }
}

impl Mesh {
    /// Least and greatest corner; `None` if there is no vertex.
    pub fn bounds(&self) -> Option<(Vec3, Vec3)> {
        let mut points = self.groups.iter().flat_map(|g| &g.positions).map(|p| wide(*p));
        let first = points.next()?;
        Some(points.fold((first, first), |(lo, hi), p| (lo.inf(&p), hi.sup(&p))))
    }
    /// Number of triangles.
    pub fn triangles(&self) -> usize {
        self.groups.iter().map(|g| g.indices.len() / 3).sum()
    }
    /// The group of a surface, made on first use; a new primitive begins in it.
    pub(crate) fn group(&mut self, surface: &Surface) -> &mut MeshGroup {
        let at = self.find(surface);
        let first = self.groups[at].indices.len();
        self.solids.push(Solid { group: at, first, turn: UnitQuaternion::identity() });
        &mut self.groups[at]
    }
    /// The primitive drawn last lies along a direction.
    pub(crate) fn lies_along(&mut self, way: Vec3) {
        if let Some(solid) = self.solids.last_mut()
            && let Some(turn) = UnitQuaternion::rotation_between(&Vec3::y(), &way)
        {
            solid.turn = turn;
        }
    }
    fn find(&mut self, surface: &Surface) -> usize {
        self.groups.iter().position(|g| g.surface.name == surface.name).unwrap_or_else(|| {
            self.groups.push(MeshGroup {
                surface: surface.clone(),
                positions: Vec::new(),
                normals: Vec::new(),
                uvs: Vec::new(),
                indices: Vec::new(),
            });
            self.groups.len() - 1
        })
    }
    /// Moves faces of different primitives that lie in one plane apart.
    pub(crate) fn apart(mut self) -> Self {
        let end = |at: usize| {
            let Solid { group, .. } = self.solids[at];
            let next = self.solids[at + 1..].iter().find(|s| s.group == group);
            next.map_or(self.groups[group].indices.len(), |s| s.first)
        };
        let piece = |(at, s): (usize, &Solid)| MeshPrimitive { group: s.group, indices: s.first..end(at) };
        let pieces: Vec<MeshPrimitive> = self.solids.iter().enumerate().map(piece).collect();
        apart(&mut self.groups, &pieces);
        self
    }
    /// Gives every vertex of the groups that have none its place on the material.
    pub fn unwrapped(mut self) -> Self {
        let solids = std::mem::take(&mut self.solids);
        for (at, group) in self.groups.iter_mut().enumerate().filter(|(_, g)| g.uvs.len() != g.positions.len()) {
            let mut own: Vec<_> = solids.iter().filter(|s| s.group == at).map(|s| (s.first, s.turn)).collect();
            if own.first().is_none_or(|(first, _)| *first > 0) {
                own.insert(0, (0, UnitQuaternion::identity()));
            }
            unwrap(group, &own);
        }
        self
    }
    /// Draws something about the origin, then turns it (degrees about x, z, y in this order, as in the language) and
    /// moves the origin to `at`.
    pub(crate) fn place(&mut self, at: Vec3, rot: [f64; 3], draw: impl FnOnce(&mut Self)) {
        let [rx, ry, rz] = rot.map(f64::to_radians);
        let axis = |v: Vector3<f64>, angle| UnitQuaternion::from_scaled_axis(v * angle);
        let turn = axis(Vector3::y(), ry) * axis(Vector3::z(), rz) * axis(Vector3::x(), rx);
        let frame = Isometry3::from_parts(Translation3::from(at), turn);
        let mut sub = Self::default();
        draw(&mut sub);
        sub.map(|p| frame.transform_point(&p.into()).coords, |n| frame.transform_vector(&n));
        sub.solids.iter_mut().for_each(|s| s.turn = turn * s.turn);
        self.append(sub);
    }
    /// Draws something of any size, then stretches it to fill a box.
    pub(crate) fn stretch(&mut self, into: Block, draw: impl FnOnce(&mut Self)) {
        let mut sub = Self::default();
        draw(&mut sub);
        let Some((lo, hi)) = sub.bounds() else { return };
        let scale = into.size().zip_map(&(hi - lo), |a, b| if b > 1e-9 { a / b } else { 1.0 });
        let from = (lo + hi) / 2.0;
        let to = into.center();
        sub.map(|p| (p - from).component_mul(&scale) + to, |n| n.component_div(&scale).try_normalize(0.0).unwrap_or(n));
        self.append(sub);
    }
    fn map(&mut self, point: impl Fn(Vec3) -> Vec3, normal: impl Fn(Vec3) -> Vec3) {
        for g in &mut self.groups {
            g.positions.iter_mut().for_each(|p| *p = narrow(point(wide(*p))));
            g.normals.iter_mut().for_each(|n| *n = narrow(normal(wide(*n))));
        }
    }
    fn append(&mut self, other: Self) {
        let mut to = Vec::with_capacity(other.groups.len());
        for from in &other.groups {
            let at = self.find(&from.surface);
            to.push((at, self.groups[at].indices.len()));
        }
        self.solids.extend(other.solids.iter().map(|s| {
            let (group, first) = to[s.group];
            Solid { group, first: first + s.first, turn: s.turn }
        }));
        for (from, (at, _)) in other.groups.into_iter().zip(to) {
            let to = &mut self.groups[at];
            let base = to.positions.len() as u32;
            to.positions.extend(from.positions);
            to.normals.extend(from.normals);
            to.indices.extend(from.indices.iter().map(|i| i + base));
        }
    }
}

impl MeshGroup {
    /// Adds a vertex.
    pub(crate) fn vertex(&mut self, p: Vec3, n: Vec3) -> u32 {
        self.positions.push(narrow(p));
        self.normals.push(narrow(n));
        self.positions.len() as u32 - 1
    }
    /// Adds a triangle, unless two corners are the same vertex or it has no area.
    pub(crate) fn triangle(&mut self, a: u32, b: u32, c: u32) {
        let [p, q, r] = [a, b, c].map(|i| wide(self.positions[i as usize]));
        let longest = (q - p).norm_squared().max((r - p).norm_squared()).max((r - q).norm_squared());
        if (q - p).cross(&(r - p)).norm() > 1e-7 * longest {
            self.indices.extend([a, b, c]);
        }
    }
    /// Adds a flat four-cornered face.
    pub(crate) fn quad(&mut self, a: u32, b: u32, c: u32, d: u32) {
        self.triangle(a, b, c);
        self.triangle(a, c, d);
    }
    /// Adds a flat convex polygon with its own vertices; corners in winding order.
    pub(crate) fn facet(&mut self, corners: &[Vec3]) {
        let mut normal = Vec3::zeros();
        for (i, p) in corners.iter().enumerate() {
            normal += (p - corners[0]).cross(&(corners[(i + 1) % corners.len()] - corners[0]));
        }
        let Some(normal) = normal.try_normalize(1e-18) else { return };
        let ids: Vec<u32> = corners.iter().map(|p| self.vertex(*p, normal)).collect();
        for i in 1..ids.len() - 1 {
            self.triangle(ids[0], ids[i], ids[i + 1]);
        }
    }
}

pub(crate) fn wide(p: [f32; 3]) -> Vec3 {
    Vec3::new(p[0].into(), p[1].into(), p[2].into())
}

fn narrow(p: Vec3) -> [f32; 3] {
    [p.x as f32, p.y as f32, p.z as f32]
}
