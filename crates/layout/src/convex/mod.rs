//! Convex polyhedra: the parts that solids are made of, and the signed gap of two.
//!
//! A box stays a box (its gap to another box has a formula of its own); a cylinder is the regular 24-gon prism inscribed
//! in it, with a vertex on +x; a hull is computed once, then only moved.

mod cut;
mod gap;
mod hull;
mod solid;

pub use gap::separation;
pub use hull::MAX_HULL_POINTS;
pub use solid::{Geometry, Nearest, aabb, local_solid, nearest, nearest_of, parts_fill_box, solid};

use crate::separation::{Aabb, Separation, contact, highest};
use crate::{Obb, Part, Vec3, obb, rotation};
use nalgebra::Matrix3;
use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

/// How many sides a cylinder has as a solid.
pub const CYLINDER_SIDES: usize = 24;

/// By how much the gap of two bodies that are no boxes may be off (metres, and for each metre).
const ROUNDED: f64 = 1e-6;

/// A face of a convex polyhedron.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Unit, outward.
    pub normal: Vec3,
    /// Indices of its corners, in order round the face.
    pub corners: Cow<'static, [u32]>,
}

/// An edge of a convex polyhedron.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Edge {
    /// Indices of its ends.
    pub ends: [u32; 2],
    /// Normals of the faces on either side.
    pub normals: [Vec3; 2],
}

/// A convex polyhedron.
#[derive(Clone, Debug)]
pub struct Convex {
    /// Its corners.
    vertices: Vec<Vec3>,
    surface: Surface,
    aabb: Aabb,
    /// A box around it, and whether it is that.
    around: Obb,
    is_box: bool,
}

/// The faces and edges of a body. Of most bodies nobody asks for them, so they are worked out when somebody does.
#[derive(Clone, Debug)]
struct Surface {
    from: Origin,
    sides: OnceLock<Arc<Sides>>,
}

/// What faces and edges are worked out from.
#[derive(Clone, Debug)]
enum Origin {
    /// They are there.
    Given,
    /// The axes of a box.
    Box(Matrix3<f64>),
    /// Those of the same body before it was turned, and how it was.
    Turned(Arc<Sides>, Matrix3<f64>),
}

/// Faces and edges.
#[derive(Clone, Debug, Default, PartialEq)]
struct Sides {
    faces: Vec<Face>,
    edges: Vec<Edge>,
}

impl Surface {
    fn new(faces: Vec<Face>, edges: Vec<Edge>) -> Self {
        Self { from: Origin::Given, sides: OnceLock::from(Arc::new(Sides { faces, edges })) }
    }

    fn of_box(axes: Matrix3<f64>) -> Self {
        Self { from: Origin::Box(axes), sides: OnceLock::new() }
    }

    fn sides(&self) -> &Arc<Sides> {
        self.sides.get_or_init(|| {
            Arc::new(match &self.from {
                Origin::Given => Sides::default(),
                Origin::Box(axes) => Sides::of_box(axes),
                Origin::Turned(sides, axes) => sides.turned(axes),
            })
        })
    }

    fn turned(&self, axes: &Matrix3<f64>) -> Self {
        Self { from: Origin::Turned(Arc::clone(self.sides()), *axes), sides: OnceLock::new() }
    }
}

impl Sides {
    fn of_box(axes: &Matrix3<f64>) -> Self {
        const FACES: [[u32; 4]; 6] =
            [[1, 3, 7, 5], [0, 4, 6, 2], [2, 6, 7, 3], [0, 1, 5, 4], [4, 5, 7, 6], [0, 2, 3, 1]];
        /// Ends, and the faces on either side: what [`Self::from_faces`] would find.
        const EDGES: [([u32; 2], [usize; 2]); 12] = [
            ([0, 1], [3, 5]),
            ([0, 2], [1, 5]),
            ([0, 4], [1, 3]),
            ([1, 3], [0, 5]),
            ([1, 5], [0, 3]),
            ([2, 3], [2, 5]),
            ([2, 6], [1, 2]),
            ([3, 7], [0, 2]),
            ([4, 5], [3, 4]),
            ([4, 6], [1, 4]),
            ([5, 7], [0, 4]),
            ([6, 7], [2, 4]),
        ];
        let normal = |i: usize| if i.is_multiple_of(2) { axes.column(i / 2).into() } else { -axes.column(i / 2) };
        let face = |(i, corners): (usize, &'static [u32; 4])| Face { normal: normal(i), corners: corners.into() };
        Self {
            faces: FACES.iter().enumerate().map(face).collect(),
            edges: EDGES.iter().map(|&(ends, sides)| Edge { ends, normals: sides.map(normal) }).collect(),
        }
    }

    fn turned(&self, axes: &Matrix3<f64>) -> Self {
        let turned = |f: &Face| Face { normal: axes * f.normal, corners: f.corners.clone() };
        Self {
            faces: self.faces.iter().map(turned).collect(),
            edges: self.edges.iter().map(|e| Edge { normals: e.normals.map(|n| axes * n), ..*e }).collect(),
        }
    }
}

impl PartialEq for Convex {
    fn eq(&self, other: &Self) -> bool {
        self.vertices == other.vertices
            && self.surface.sides() == other.surface.sides()
            && self.as_box() == other.as_box()
    }
}

impl Convex {
    pub fn from_box(obb: &Obb) -> Self {
        let vertices = obb.corners().to_vec();
        let aabb = Aabb::of(vertices.iter().copied());
        Self { aabb, vertices, surface: Surface::of_box(obb.axes), around: *obb, is_box: true }
    }

    /// An upright cylinder about `center`, turned by `axes`.
    pub fn from_cylinder(center: &Vec3, axes: &Matrix3<f64>, radius: f64, height: f64) -> Self {
        let n = CYLINDER_SIDES as u32;
        let step = 360.0 / f64::from(n);
        let at = |degrees: f64, y: f64, r: f64| {
            let (s, c) = rotation::sin_cos(degrees);
            Vec3::new(r * c, y, r * s)
        };
        let ring = |y: f64| (0..n).map(move |i| center + axes * at(step * f64::from(i), y, radius));
        let vertices = ring(-height / 2.0).chain(ring(height / 2.0)).collect();
        let mut faces: Vec<Face> = (0..n)
            .map(|i| Face {
                normal: axes * at(step * (f64::from(i) + 0.5), 0.0, 1.0),
                corners: vec![i, (i + 1) % n, n + (i + 1) % n, n + i].into(),
            })
            .collect();
        faces.push(Face { normal: -axes.column(1), corners: (0..n).collect() });
        faces.push(Face { normal: axes.column(1).into(), corners: (n..2 * n).collect() });
        let around = Obb { center: *center, axes: *axes, half: Vec3::new(radius, height / 2.0, radius) };
        Self { around, ..Self::from_faces(vertices, faces) }
    }

    /// The convex hull of points; `None` where they are fewer than four, nearly in one plane, or more than
    /// [`MAX_HULL_POINTS`].
    pub fn from_hull(points: &[Vec3]) -> Option<Self> {
        hull::hull(points)
    }

    /// A part, in the frame of its object; `None` where its numbers describe no body.
    pub fn from_part(part: &Part) -> Option<Self> {
        match part {
            Part::Box { pos, size, rot } => (size.min() > 0.0)
                .then(|| Self::from_box(&Obb { center: *pos, axes: rotation::matrix(*rot), half: size / 2.0 })),
            Part::Cylinder { pos, radius, height, rot } => (*radius > 0.0 && *height > 0.0)
                .then(|| Self::from_cylinder(pos, &rotation::matrix(*rot), *radius, *height)),
            Part::Hull { points } => Self::from_hull(points),
        }
    }

    /// From corners and faces in order round each; every edge must have two faces.
    fn from_faces(vertices: Vec<Vec3>, faces: Vec<Face>) -> Self {
        let mut sides: Vec<([u32; 2], Vec3)> = Vec::new();
        for face in &faces {
            for (i, &a) in face.corners.iter().enumerate() {
                let b = face.corners[(i + 1) % face.corners.len()];
                sides.push(([a.min(b), a.max(b)], face.normal));
            }
        }
        sides.sort_by_key(|(ends, _)| *ends);
        let edges = sides
            .chunk_by(|x, y| x.0 == y.0)
            .filter_map(|pair| Some(Edge { ends: pair[0].0, normals: [pair[0].1, pair.get(1)?.1] }))
            .collect();
        Self::new(vertices, Surface::new(faces, edges))
    }

    fn new(vertices: Vec<Vec3>, surface: Surface) -> Self {
        let aabb = Aabb::of(vertices.iter().copied());
        Self { aabb, vertices, surface, around: Obb::upright(&aabb), is_box: false }
    }

    /// The same body turned by `axes` (about the origin), then moved by `by`.
    pub fn moved(&self, axes: &Matrix3<f64>, by: &Vec3) -> Self {
        self.moved_in(Vec::new(), axes, by)
    }
    /// The same, written over a body that is not needed any more: who moves one often spares its memory.
    pub fn moved_over(&self, old: &mut Self, axes: &Matrix3<f64>, by: &Vec3) {
        *old = self.moved_in(std::mem::take(&mut old.vertices), axes, by);
    }
    fn moved_in(&self, mut vertices: Vec<Vec3>, axes: &Matrix3<f64>, by: &Vec3) -> Self {
        vertices.clear();
        vertices.extend(self.vertices.iter().map(|v| axes * v + by));
        Self {
            aabb: Aabb::of(vertices.iter().copied()),
            vertices,
            surface: self.surface.turned(axes),
            around: Obb {
                center: axes * self.around.center + by,
                axes: axes * self.around.axes,
                half: self.around.half,
            },
            is_box: self.is_box,
        }
    }

    /// What of it is not lower than a height; `None`: it does not reach above it.
    pub fn above(&self, height: f64) -> Option<Self> {
        cut::above(self, height)
    }

    /// Its corners.
    pub fn vertices(&self) -> &[Vec3] {
        &self.vertices
    }
    /// The ends of its edges.
    pub fn edges(&self) -> impl Iterator<Item = [Vec3; 2]> {
        self.sides().edges.iter().map(|edge| self.ends(edge))
    }
    pub fn faces(&self) -> &[Face] {
        &self.sides().faces
    }
    fn sides(&self) -> &Sides {
        self.surface.sides()
    }
    /// The corners of a face, in order round it.
    pub fn face_corners<'a>(&'a self, face: &'a Face) -> impl Iterator<Item = Vec3> + 'a {
        face.corners.iter().map(|&i| self.vertices[i as usize])
    }
    /// The smallest upright box that holds it.
    pub fn aabb(&self) -> &Aabb {
        &self.aabb
    }
    /// Which box it is, if it is one.
    pub fn as_box(&self) -> Option<&Obb> {
        self.is_box.then_some(&self.around)
    }
    /// Whether it is certain that another body is at least so far away (metres): an axis of the boxes around them shows it.
    fn is_apart(&self, other: &Self, distance: f64) -> bool {
        // The gap of two boxes is no less than what an axis shows; that of others is less by what is rounded.
        let certain = if self.is_box && other.is_box { distance } else { distance + ROUNDED * (1.0 + distance.abs()) };
        obb::apart(&self.around, &other.around, certain)
    }
    /// The greatest height along `n`.
    pub fn support_height(&self, n: &Vec3) -> f64 {
        self.vertices.iter().map(|v| v.dot(n)).fold(f64::NEG_INFINITY, f64::max)
    }
    /// Points of both that witness a separation, see [`contact`].
    pub fn contact(&self, other: &Self, separation: &Separation) -> (Vec3, Vec3) {
        let n = separation.normal;
        contact(&highest(&self.vertices, &n), &highest(&other.vertices, &-n), separation)
    }
    fn ends(&self, edge: &Edge) -> [Vec3; 2] {
        edge.ends.map(|i| self.vertices[i as usize])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_edges_of_a_box_are_those_of_its_faces() {
        let obb = Obb {
            center: Vec3::new(1.0, 2.0, 3.0),
            axes: rotation::matrix(Vec3::new(10.0, 20.0, 30.0)),
            half: Vec3::new(0.5, 1.0, 1.5),
        };
        let body = Convex::from_box(&obb);
        let found = Convex::from_faces(body.vertices.clone(), body.faces().to_vec());
        assert_eq!(body, Convex { around: obb, is_box: true, ..found });
    }
}
