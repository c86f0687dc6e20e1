//! Wavefront OBJ with its materials: what nearly every program reads, and no more than can be seen.
//!
//! Right-handed with y up: x of the scene is negated. Metres. One `o` for each object and each piece of the building, by its
//! name; positions are in the world.

use crate::geometry::frame::Frame;
use crate::geometry::mesh::Group;
use crate::loss::Lost;
use crate::names::Stems;
use crate::{ExportError, Exporter, OutFile, Scene};
use nalgebra::Matrix3;
use scenelang_assets::Surface;
use scenelang_layout::Vec3;
use std::fmt::Write;

/// `obj/NAME.obj` and `obj/NAME.mtl`.
#[derive(Clone, Copy, Debug)]
pub struct Obj;

impl Exporter for Obj {
    fn name(&self) -> &'static str {
        "obj"
    }

    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError> {
        let stem = Stems::default().take(&scene.name);
        let materials = Materials::of(scene);
        let mut mesh = Mesh::new(Frame::YUp, &materials, &format!("{stem}.mtl"));
        for object in &scene.objects {
            mesh.name(&object.name);
            mesh.groups(&object.mesh, &object.axes, &object.place.pos);
        }
        for shell in scene.shells.iter().filter(|s| !s.group.indices.is_empty()) {
            mesh.name(&shell.name);
            mesh.groups(std::slice::from_ref(&shell.group), &Matrix3::identity(), &Vec3::zeros());
        }
        Ok(vec![
            OutFile::new(format!("obj/{stem}.obj"), mesh.finish()),
            OutFile::new(format!("obj/{stem}.mtl"), materials.library(scene)),
        ])
    }

    fn lost(&self, scene: &Scene) -> Vec<Lost> {
        // The sun, too.
        vec![Lost::Physics, Lost::Lights(scene.lamps.len() + 1), Lost::Program]
    }
}

/// Names of materials, by surface.
pub(crate) struct Materials(Vec<String>);

impl Materials {
    pub fn of(scene: &Scene) -> Self {
        let mut stems = Stems::default();
        Self(scene.surfaces.iter().map(|surface| stems.take(&surface.name)).collect())
    }

    /// The file that describes them.
    pub fn library(&self, scene: &Scene) -> String {
        let mut out = String::from("# Colours are sRGB. Pr and Pm are roughness and metalness of the PBR extension.\n");
        for (name, surface) in self.0.iter().zip(&scene.surfaces) {
            material(&mut out, name, surface);
        }
        out
    }
}

fn material(out: &mut String, name: &str, surface: &Surface) {
    let triple = |[r, g, b]: [f32; 3]| format!("{r} {g} {b}");
    let _ = writeln!(out, "newmtl {name}");
    let _ = writeln!(out, "Kd {}", triple(surface.color));
    if let Some(emissive) = surface.emissive {
        let _ = writeln!(out, "Ke {}", triple(emissive));
    }
    let _ = writeln!(out, "d {}", surface.opacity);
    let _ = writeln!(out, "Pr {}\nPm {}\nillum 2", surface.roughness, surface.metallic);
}

/// Metres to a tenth of a millimetre: what is finer is not seen on a material.
pub(crate) fn to_tenths(metres: f32) -> f32 {
    (metres * 1e4).round() / 1e4
}

/// The text of a mesh as it grows.
pub(crate) struct Mesh<'a> {
    out: String,
    frame: Frame,
    materials: &'a Materials,
    /// Vertices so far.
    count: usize,
}

impl<'a> Mesh<'a> {
    /// A mesh whose materials are in a file beside it.
    pub fn new(frame: Frame, materials: &'a Materials, library: &str) -> Self {
        Self { out: format!("mtllib {library}\n"), frame, materials, count: 0 }
    }

    /// What comes now is called so.
    pub fn name(&mut self, name: &str) {
        // A name ends with its line.
        let _ = writeln!(self.out, "o {}", name.replace(char::is_control, " "));
    }

    /// Triangles in a frame that is turned and moved.
    pub fn groups(&mut self, groups: &[Group], axes: &Matrix3<f64>, pos: &Vec3) {
        let turned = |v: &[f32; 3]| axes * Vec3::from(v.map(f64::from));
        for group in groups.iter().filter(|g| !g.indices.is_empty()) {
            self.vectors("v", group.positions.iter().map(|p| turned(p) + pos));
            self.vectors("vn", group.normals.iter().map(turned));
            for uv in &group.uvs {
                let [u, v] = uv.map(to_tenths);
                let _ = writeln!(self.out, "vt {u} {v}");
            }
            let _ = writeln!(self.out, "usemtl {}", self.materials.0[group.surface]);
            for t in group.indices.chunks_exact(3) {
                let [a, b, c] = [t[0], t[2], t[1]].map(|i| i as usize + self.count + 1);
                let _ = writeln!(self.out, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}");
            }
            self.count += group.positions.len();
        }
    }

    /// The text.
    pub fn finish(self) -> String {
        self.out
    }

    fn vectors(&mut self, word: &str, vectors: impl Iterator<Item = Vec3>) {
        for v in vectors {
            let v = self.frame.point(v).map(|c| if c.abs() < 1e-9 { 0.0 } else { c as f32 });
            let _ = writeln!(self.out, "{word} {} {} {}", v.x, v.y, v.z);
        }
    }
}
