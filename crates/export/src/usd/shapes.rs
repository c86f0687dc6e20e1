//! What bodies look like and what they stop others with: meshes of one material each, and colliders. What several bodies
//! have is written once.

use super::text::{Usda, schemas, scalar, triple, triples};
use super::{FRAME, Looks, leaf, place};
use crate::geometry::mesh::Group;
use crate::names::Identifiers;
use crate::physics::{Geom, Physics, Shape};
use scenelang_layout::Vec3;

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
    drawn: &'a [Group],
    geoms: &'a [Geom],
    /// Where it is, if several bodies have it.
    shared: Option<String>,
}

/// How a body gets its shape.
pub(super) enum Use<'a> {
    /// From the prim at this path.
    Shared(&'a str),
    /// It is written in the body's own prim.
    Own(Own<'a>),
}

/// A shape to be written.
pub(super) struct Own<'a> {
    looks: &'a Looks,
    body: &'a Body<'a>,
}

impl<'a> Shapes<'a> {
    pub fn of(physics: &'a Physics<'a>, looks: &'a Looks) -> Self {
        let mut all: Vec<Body<'a>> = Vec::new();
        let mut names = Identifiers::default();
        let mut of = Vec::with_capacity(physics.bodies.len());
        for body in &physics.bodies {
            let (drawn, geoms) = (body.drawn, &body.geoms[..]);
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

    /// The shape of a body.
    pub fn of_body(&self, index: usize) -> Use<'_> {
        let body = &self.all[self.of[index]];
        match &body.shared {
            Some(path) => Use::Shared(path),
            None => Use::Own(Own { looks: self.looks, body }),
        }
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
                Own { looks: self.looks, body }.write(out);
                out.end();
            }
        }
        out.end();
    }
}

impl Own<'_> {
    pub fn write(&self, out: &mut Usda) {
        for (i, group) in self.body.drawn.iter().filter(|g| !g.indices.is_empty()).enumerate() {
            out.begin("def Mesh", &format!("look_{i}"), &[schemas(&["MaterialBindingAPI"])]);
            mesh(out, group);
            out.line(&format!("rel material:binding = <{}>", self.looks.paths[group.surface]));
            out.end();
        }
        for (i, geom) in self.body.geoms.iter().enumerate() {
            collider(out, &format!("solid_{i}"), geom);
        }
    }
}

/// Points, normals and triangles.
fn mesh(out: &mut Usda, group: &Group) {
    let points = || group.positions.iter().map(|p| FRAME.corner(*p));
    let ends = points().fold([[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]], |[lo, hi], p| {
        [std::array::from_fn(|i| lo[i].min(p[i])), std::array::from_fn(|i| hi[i].max(p[i]))]
    });
    out.line(&format!("float3[] extent = {}", triples(ends.into_iter())));
    out.line(&format!("int[] faceVertexCounts = [{}]", vec!["3"; group.indices.len() / 3].join(", ")));
    let turned = group.indices.chunks_exact(3).flat_map(|t| [t[0], t[2], t[1]]);
    let indices: Vec<String> = turned.map(|i| i.to_string()).collect();
    out.line(&format!("int[] faceVertexIndices = [{}]", indices.join(", ")));
    let normals = triples(group.normals.iter().map(|n| FRAME.corner(*n)));
    out.line(&format!("normal3f[] normals = {normals} ("));
    out.line("    interpolation = \"vertex\"");
    out.line(")");
    out.line(&format!("point3f[] points = {}", triples(points())));
    out.line("uniform token subdivisionScheme = \"none\"");
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
            let mut group = Group::new(geom.surface);
            group.solid(hull);
            mesh(out, &group);
            out.line("uniform token physics:approximation = \"convexHull\"");
        }
    }
    out.line("uniform token purpose = \"guide\"");
    out.end();
}
