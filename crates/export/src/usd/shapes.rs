//! What bodies look like and what they stop others with: meshes of one material each, and colliders. What several bodies
//! have is written once.

use super::looks::{Looks, PLACES};
use super::text::{Usda, scalar, schemas, triple, triples};
use super::{FRAME, leaf, place};
use crate::geometry::mesh::MeshGroup;
use crate::names::Identifiers;
use crate::obj::to_tenths;
use crate::physics::{Geom, Physics, Shape};
use scenelang_layout::Vec3;
use std::collections::BTreeMap;

/// The shapes of all bodies.
pub(super) struct Shapes<'a> {
    looks: &'a Looks,
    /// Each once.
    all: Vec<Body<'a>>,
    /// For each body the index of its shape.
    of: Vec<usize>,
}

/// What is drawn, and the solid.
struct Body<'a> {
    drawn: &'a [MeshGroup],
    geoms: &'a [Geom],
    /// Where it is, if several bodies have it.
    shared: Option<String>,
}

/// How a body gets its shape.
pub(super) enum Use<'a> {
    /// From the prim at a path.
    Shared(&'a str, &'a Looks),
    /// It is written in the body's own prim.
    Own(Own<'a>),
}

impl<'a> Use<'a> {
    /// The materials.
    pub fn looks(&self) -> &'a Looks {
        match self {
            Self::Shared(_, looks) => looks,
            Self::Own(own) => own.looks,
        }
    }
}

/// A shape to be written.
pub(super) struct Own<'a> {
    pub looks: &'a Looks,
    pub drawn: &'a [MeshGroup],
    pub geoms: &'a [Geom],
}

impl<'a> Shapes<'a> {
    pub fn of(physics: &'a Physics<'a>, looks: &'a Looks) -> Self {
        let mut all: Vec<Body<'a>> = Vec::new();
        let mut names = Identifiers::default();
        let mut of = Vec::with_capacity(physics.bodies.len());
        for body in &physics.bodies {
            let (drawn, geoms) = (&body.drawn[..], &body.geoms[..]);
            let known = all.iter().position(|b| b.drawn == drawn && b.geoms == geoms);
            match known {
                Some(index) if all[index].shared.is_none() => {
                    all[index].shared = Some(format!("/Shapes/{}", names.take(body.category())));
                }
                Some(_) => {}
                None => all.push(Body { drawn, geoms, shared: None }),
            }
            of.push(known.unwrap_or(all.len() - 1));
        }
        Self { looks, all, of }
    }

    /// The shape of a body, but for what of it moves.
    pub fn of_body(&self, index: usize) -> Use<'_> {
        let body = &self.all[self.of[index]];
        match &body.shared {
            Some(path) => Use::Shared(path, self.looks),
            None => Use::Own(self.own(body)),
        }
    }

    fn own(&self, body: &Body<'a>) -> Own<'a> {
        Own { looks: self.looks, drawn: body.drawn, geoms: body.geoms }
    }

    /// Writes what several bodies have.
    pub fn write(&self, out: &mut Usda) {
        if self.all.iter().all(|b| b.shared.is_none()) {
            return;
        }
        out.begin("class Scope", "Shapes", &[]);
        for body in &self.all {
            if let Some(path) = &body.shared {
                out.begin("def Xform", leaf(path), &[]);
                self.own(body).write(out);
                out.end();
            }
        }
        out.end();
    }
}

impl Own<'_> {
    pub fn write(&self, out: &mut Usda) {
        let meshes =
            self.drawn.iter().flat_map(|group| Welded::of(group).into_iter().map(|mesh| (group.surface, mesh)));
        for (i, (surface, mesh)) in meshes.enumerate() {
            out.begin("def Mesh", &format!("look_{i}"), &[schemas(&["MaterialBindingAPI"])]);
            mesh.write(out, self.looks.tile(surface));
            out.line(&format!("rel material:binding = <{}>", self.looks.path(surface)));
            out.end();
        }
        for (i, geom) in self.geoms.iter().enumerate() {
            collider(out, &format!("solid_{i}"), geom);
        }
    }
}

/// A corner of a triangle.
struct Corner {
    point: u32,
    normal: [f32; 3],
    /// Where it is on its material, metres.
    uv: [f32; 2],
}

/// A mesh as USD wants it: no two points are in the same place, and no edge has more than two faces.
#[derive(Default)]
struct Welded {
    points: Vec<[f32; 3]>,
    corners: Vec<Corner>,
    /// Points by where they are.
    known: BTreeMap<[u32; 3], u32>,
}

impl Welded {
    /// The meshes of a group: as few as there can be where pieces that touch are in different ones.
    fn of(group: &MeshGroup) -> Vec<Self> {
        let mut all = Self::default();
        let mut faces = Vec::new();
        for t in group.indices.chunks_exact(3) {
            let corners = [t[0], t[2], t[1]].map(|i| i as usize);
            let points = corners.map(|i| all.point(FRAME.corner(group.positions[i])));
            let [a, b, c] = points;
            if a != b && b != c && c != a {
                faces.push((points, corners));
            }
        }
        let mut out: Vec<Self> = Vec::new();
        for piece in pieces(&faces.iter().map(|(points, _)| *points).collect::<Vec<_>>()) {
            let mut mesh = Self::default();
            for i in piece.into_iter().flat_map(|face| faces[face].1) {
                let point = mesh.point(FRAME.corner(group.positions[i]));
                mesh.corners.push(Corner { point, normal: FRAME.corner(group.normals[i]), uv: group.uvs[i] });
            }
            mesh.join(&mut out);
        }
        out
    }

    fn point(&mut self, place: [f32; 3]) -> u32 {
        let place = place.map(|c| c + 0.0);
        *self.known.entry(place.map(f32::to_bits)).or_insert_with(|| {
            self.points.push(place);
            self.points.len() as u32 - 1
        })
    }

    /// Adds a piece to the first mesh that it does not touch.
    fn join(self, meshes: &mut Vec<Self>) {
        let Some(mesh) = meshes.iter_mut().find(|m| self.known.keys().all(|place| !m.known.contains_key(place))) else {
            return meshes.push(self);
        };
        let first = mesh.points.len() as u32;
        mesh.points.extend(self.points);
        mesh.corners.extend(self.corners.into_iter().map(|c| Corner { point: first + c.point, ..c }));
        mesh.known.extend(self.known.into_iter().map(|(place, point)| (place, first + point)));
    }

    /// Writes it, with the places of its corners on a texture whose repeats are so large.
    fn write(&self, out: &mut Usda, tile: Option<[f32; 2]>) {
        let points = || self.points.iter().copied();
        let ends = points().fold([[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]], |[lo, hi], p| {
            [std::array::from_fn(|i| lo[i].min(p[i])), std::array::from_fn(|i| hi[i].max(p[i]))]
        });
        out.line(&format!("float3[] extent = {}", triples(ends.into_iter())));
        out.line(&format!("int[] faceVertexCounts = [{}]", vec!["3"; self.corners.len() / 3].join(", ")));
        let indices: Vec<String> = self.corners.iter().map(|c| c.point.to_string()).collect();
        out.line(&format!("int[] faceVertexIndices = [{}]", indices.join(", ")));
        let normals = triples(self.corners.iter().map(|c| c.normal));
        out.line(&format!("normal3f[] normals = {normals} ("));
        out.line("    interpolation = \"faceVarying\"");
        out.line(")");
        out.line(&format!("point3f[] points = {}", triples(points())));
        if let Some([width, height]) = tile {
            // Each place once: validators object to values that are repeated without indices.
            let mut places: Vec<String> = Vec::new();
            let mut known = BTreeMap::new();
            let mut index = |corner: &Corner| {
                let [u, v] = [corner.uv[0] / width, corner.uv[1] / height].map(to_tenths);
                let place = format!("({u}, {v})");
                *known.entry(place).or_insert_with_key(|place| {
                    places.push(place.clone());
                    places.len() - 1
                })
            };
            let indices: Vec<String> = self.corners.iter().map(|c| index(c).to_string()).collect();
            out.line(&format!("texCoord2f[] primvars:{PLACES} = [{}] (", places.join(", ")));
            out.line("    interpolation = \"faceVarying\"");
            out.line(")");
            out.line(&format!("int[] primvars:{PLACES}:indices = [{}]", indices.join(", ")));
        }
        out.line("uniform token subdivisionScheme = \"none\"");
    }
}

/// The faces, sorted into pieces: faces that run along an edge in opposite directions belong together. Where solids touch along
/// an edge there are four; the faces of a solid come one after the other, so each meets one of its own first.
fn pieces(faces: &[[u32; 3]]) -> Vec<Vec<usize>> {
    let mut single: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
    let mut next: Vec<Vec<usize>> = vec![Vec::new(); faces.len()];
    for (face, &[a, b, c]) in faces.iter().enumerate() {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            match single.get_mut(&[to, from]).and_then(Vec::pop) {
                Some(other) => {
                    next[face].push(other);
                    next[other].push(face);
                }
                None => single.entry([from, to]).or_default().push(face),
            }
        }
    }
    let (mut found, mut seen) = (Vec::new(), vec![false; faces.len()]);
    for face in 0..faces.len() {
        let (mut piece, mut open) = (Vec::new(), vec![face]);
        while let Some(face) = open.pop() {
            if !std::mem::replace(&mut seen[face], true) {
                piece.push(face);
                open.extend(&next[face]);
            }
        }
        if !piece.is_empty() {
            piece.sort_unstable();
            found.push(piece);
        }
    }
    found
}

fn collider(out: &mut Usda, name: &str, geom: &Geom) {
    let solid = "PhysicsCollisionAPI";
    match &geom.shape {
        Shape::Box(size) => {
            out.begin("def Cube", name, &[schemas(&[solid])]);
            out.line("float3[] extent = [(-0.5, -0.5, -0.5), (0.5, 0.5, 0.5)]");
            out.line("double size = 1");
            place(out, &geom.pos, &geom.axes, Some(size));
        }
        Shape::Cylinder { radius, height } => {
            out.begin("def Cylinder", name, &[schemas(&[solid])]);
            out.line("uniform token axis = \"Y\"");
            let half = Vec3::new(*radius, height / 2.0, *radius);
            out.line(&format!("float3[] extent = [{}, {}]", triple(&-half), triple(&half)));
            out.line(&scalar("double height", *height));
            out.line(&scalar("double radius", *radius));
            place(out, &geom.pos, &geom.axes, None);
        }
        Shape::Hull(hull) => {
            out.begin("def Mesh", name, &[schemas(&[solid, "PhysicsMeshCollisionAPI"])]);
            let mut group = MeshGroup::new(geom.surface);
            group.solid(hull);
            // A convex body is one piece.
            if let Some(mesh) = Welded::of(&group).first() {
                mesh.write(out, None);
            }
            out.line("uniform token physics:approximation = \"convexHull\"");
        }
    }
    out.line("uniform token purpose = \"guide\"");
    out.end();
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Matrix3;
    use scenelang_layout::{Convex, Obb};

    #[test]
    fn solids_that_touch_are_in_different_meshes() {
        let block = |x| {
            let half = Vec3::repeat(0.5);
            Convex::from_box(&Obb { center: Vec3::new(x, 0.0, 0.0), axes: Matrix3::identity(), half })
        };
        let mut group = MeshGroup::new(0);
        [0.0, 1.0, 5.0].iter().for_each(|&x| group.solid(&block(x)));
        let counts: Vec<_> = Welded::of(&group).iter().map(|m| (m.points.len(), m.corners.len())).collect();
        assert_eq!(counts, [(16, 72), (8, 36)]);
    }
}
