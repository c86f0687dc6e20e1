//! Wavefront OBJ with its materials: what nearly every program reads, and no more than can be seen.
//!
//! Right-handed with y up: x of the scene is negated. Metres. One `o` for each object and each piece of the building, by its
//! name; positions are in the world.

use crate::geometry::frame::Frame;
use crate::geometry::mesh::MeshGroup;
use crate::glb::linear;
use crate::loss::Lost;
use crate::names::Stems;
use crate::numbers::{coarse, spaced};
use crate::textures::{self, Picture};
use crate::{ExportError, Exporter, OutFile, Scene};
use nalgebra::Matrix3;
use scenelang_assets::Surface;
use scenelang_assets::textures::{Pixels, Texture, encoded};
use scenelang_layout::Vec3;
use std::fmt::Write;

/// `obj/NAME.obj`, `obj/NAME.mtl` and `obj/textures/`.
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
        let mut files = vec![OutFile::new(format!("obj/{stem}.obj"), mesh.finish())];
        files.extend(materials.files(scene, "obj", &format!("{stem}.mtl"))?);
        Ok(files)
    }

    fn lost(&self, scene: &Scene) -> Vec<Lost> {
        // The sun, too.
        vec![Lost::Physics, Lost::Lights(scene.lamps.len() + 1), Lost::Program]
    }
}

/// Materials, by surface.
pub(crate) struct Materials {
    names: Vec<String>,
    /// What one repeat of the texture measures, metres; 1 where there is none.
    tiles: Vec<[f32; 2]>,
    /// Those that the meshes have.
    used: Vec<bool>,
}

/// The pictures of a texture that a material refers to, by the keyword.
const MAPS: [(&str, Picture); 3] =
    [("map_Kd", Picture::Color), ("norm", Picture::Normal), ("map_Pr", Picture::Roughness)];

impl Materials {
    pub fn of(scene: &Scene) -> Self {
        Self::used(scene, |_| true)
    }

    /// Of some surfaces, by index; meshes of others have names of materials that are nowhere.
    pub fn used(scene: &Scene, used: impl Fn(usize) -> bool) -> Self {
        let mut stems = Stems::default();
        let tile = |surface: &Surface| {
            Texture::of(surface).map_or([1.0; 2], |texture| texture.pixels().tile.map(|metres| metres as f32))
        };
        Self {
            names: scene.surfaces.iter().map(|surface| stems.take(&surface.name)).collect(),
            tiles: scene.surfaces.iter().map(tile).collect(),
            used: (0..scene.surfaces.len()).map(used).collect(),
        }
    }

    /// The file that describes them, and their textures, in a folder.
    ///
    /// # Errors
    /// A texture cannot be encoded.
    pub fn files(&self, scene: &Scene, folder: &str, library: &str) -> Result<Vec<OutFile>, ExportError> {
        let used = || scene.surfaces.iter().enumerate().filter(|(i, _)| self.used[*i]);
        let mut out = String::from("# Colours are sRGB. Pr and Pm are roughness and metalness of the PBR extension.\n");
        for (i, surface) in used() {
            material(&mut out, &self.names[i], surface);
        }
        let mut files = vec![OutFile::new(format!("{folder}/{library}"), out)];
        for texture in textures::kinds(used().map(|(_, surface)| surface)) {
            for (_, picture) in MAPS {
                let path = format!("{folder}/{}", picture.path(texture));
                files.push(OutFile::new(path, picture.bytes(texture)?));
            }
        }
        Ok(files)
    }
}

fn material(out: &mut String, name: &str, surface: &Surface) {
    let triple = |color: [f32; 3]| spaced(color.map(coarse));
    let texture = Texture::of(surface);
    let pixels = texture.map(Texture::pixels);
    // As colours are multiplied in linear light, and said in sRGB.
    let factor = |p: &Pixels| p.factor(surface.color.map(|c| linear(c) as f32)).map(encoded);
    let color = pixels.map_or(surface.color, factor);
    let roughness = pixels.map_or(surface.roughness, |p| textures::rough_factor(p, surface.roughness));
    let _ = writeln!(out, "newmtl {name}");
    let _ = writeln!(out, "Kd {}", triple(color));
    if let Some(emissive) = surface.emissive {
        let _ = writeln!(out, "Ke {}", triple(emissive));
    }
    let [opacity, roughness, metallic] = [surface.opacity, roughness, surface.metallic].map(coarse);
    let _ = writeln!(out, "d {opacity}\nPr {roughness}\nPm {metallic}\nillum 2");
    if let Some(texture) = texture {
        for (keyword, picture) in MAPS {
            let _ = writeln!(out, "{keyword} {}", picture.path(texture));
        }
    }
}

/// Metres, or repeats of a texture, to a tenth of a thousandth: what is finer is not seen on a material.
pub(crate) fn to_tenths(place: f32) -> f32 {
    (place * 1e4).round() / 1e4 + 0.0
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
    pub fn groups(&mut self, groups: &[MeshGroup], axes: &Matrix3<f64>, pos: &Vec3) {
        let turned = |v: &[f32; 3]| axes * Vec3::from(v.map(f64::from));
        for group in groups.iter().filter(|g| !g.indices.is_empty()) {
            self.vectors("v", group.positions.iter().map(|p| turned(p) + pos));
            self.vectors("vn", group.normals.iter().map(turned));
            // In repeats of the texture.
            let [width, height] = self.materials.tiles[group.surface];
            for [u, v] in &group.uvs {
                let _ = writeln!(self.out, "vt {} {}", to_tenths(u / width), to_tenths(v / height));
            }
            let _ = writeln!(self.out, "usemtl {}", self.materials.names[group.surface]);
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
