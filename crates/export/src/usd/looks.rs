//! Materials: `UsdPreviewSurface`, with the textures of the furniture library where a surface has one. Pictures are files
//! beside the layer.

use super::text::{Usda, quoted, scalar, schemas};
use super::{SURFACE, leaf, linear};
use crate::names::Identifiers;
use crate::numbers::{coarse, numbers};
use crate::physics::FRICTION;
use crate::textures::{self, Picture};
use crate::{ExportError, Scene};
use scenelang_assets::Surface;
use scenelang_assets::textures::Texture;

/// Where on their textures points are.
pub(super) const PLACES: &str = "st";
/// The pictures of a material, and what its shaders are called.
const PICTURES: [(&str, Picture); 3] =
    [("Color", Picture::Color), ("Normal", Picture::Normal), ("Roughness", Picture::Roughness)];

/// Materials, by surface.
pub(super) struct Looks {
    paths: Vec<String>,
    textures: Vec<Option<Texture>>,
}

/// The pictures that the materials of a scene refer to, by their paths beside the layer.
///
/// # Errors
/// A picture cannot be encoded.
pub(super) fn pictures(scene: &Scene) -> Result<Vec<(String, Vec<u8>)>, ExportError> {
    let all = textures::used(scene).into_iter().flat_map(|t| PICTURES.map(|(_, picture)| (t, picture)));
    all.map(|(texture, picture)| Ok((picture.path(texture), picture.bytes(texture)?))).collect()
}

impl Looks {
    pub fn of(scene: &Scene) -> Self {
        let mut names = Identifiers::default();
        names.take(leaf(SURFACE));
        Self {
            paths: scene.surfaces.iter().map(|s| format!("/World/Looks/{}", names.take(&s.name))).collect(),
            textures: scene.surfaces.iter().map(Texture::of).collect(),
        }
    }

    /// The path of a surface's material.
    pub fn path(&self, surface: usize) -> &str {
        &self.paths[surface]
    }

    /// What one repeat of a surface's texture measures, metres.
    pub fn tile(&self, surface: usize) -> Option<[f32; 2]> {
        Some(self.textures[surface]?.pixels().tile.map(|metres| metres as f32))
    }

    pub fn write(&self, out: &mut Usda, scene: &Scene) {
        out.begin("def Scope", "Looks", &[]);
        out.begin("def Material", leaf(SURFACE), &[schemas(&["PhysicsMaterialAPI"])]);
        out.line(&scalar("float physics:dynamicFriction", FRICTION));
        out.line("float physics:restitution = 0");
        out.line(&scalar("float physics:staticFriction", FRICTION));
        out.end();
        for ((path, surface), texture) in self.paths.iter().zip(&scene.surfaces).zip(&self.textures) {
            material(out, path, surface, *texture);
        }
        out.end();
    }
}

fn material(out: &mut Usda, path: &str, surface: &Surface, texture: Option<Texture>) {
    out.begin("def Material", leaf(path), &[format!("displayName = {}", quoted(&surface.name))]);
    out.line(&format!("token outputs:surface.connect = <{path}/Surface.outputs:surface>"));
    out.begin("def Shader", "Surface", &[]);
    out.line("uniform token info:id = \"UsdPreviewSurface\"");
    let from = |name: &str, output: &str| format!("<{path}/{name}.outputs:{output}>");
    if texture.is_some() {
        out.line(&format!("color3f inputs:diffuseColor.connect = {}", from("Color", "rgb")));
    } else {
        out.line(&format!("color3f inputs:diffuseColor = {}", linear(surface.color)));
    }
    if let Some(emissive) = surface.emissive {
        out.line(&format!("color3f inputs:emissiveColor = {}", linear(emissive)));
    }
    out.line(&scalar("float inputs:metallic", coarse(surface.metallic)));
    if texture.is_some() {
        out.line(&format!("normal3f inputs:normal.connect = {}", from("Normal", "rgb")));
    }
    out.line(&scalar("float inputs:opacity", coarse(surface.opacity)));
    if texture.is_some() {
        out.line(&format!("float inputs:roughness.connect = {}", from("Roughness", "r")));
    } else {
        out.line(&scalar("float inputs:roughness", coarse(surface.roughness)));
    }
    out.line("token outputs:surface");
    out.end();
    if let Some(texture) = texture {
        reader(out);
        for (name, picture) in PICTURES {
            sampler(out, &from("Places", "result"), (name, picture), surface, texture);
        }
    }
    out.end();
}

/// Hands the places of a mesh to the pictures.
fn reader(out: &mut Usda) {
    out.begin("def Shader", "Places", &[]);
    out.line("uniform token info:id = \"UsdPrimvarReader_float2\"");
    out.line(&format!("string inputs:varname = \"{PLACES}\""));
    out.line("float2 outputs:result");
    out.end();
}

/// A picture: its values times a scale, plus a bias.
fn sampler(out: &mut Usda, places: &str, (name, picture): (&str, Picture), surface: &Surface, texture: Texture) {
    let pixels = texture.pixels();
    let (space, scale, bias, output) = match picture {
        Picture::Color => {
            let factor = pixels.factor(surface.color.map(|c| crate::glb::linear(c) as f32));
            ("sRGB", factor.map(coarse), None, "float3 outputs:rgb")
        }
        Picture::Normal => ("raw", [2.0; 3], Some("(-1, -1, -1, 0)"), "float3 outputs:rgb"),
        Picture::Roughness => {
            let factor = coarse(textures::rough_factor(pixels, surface.roughness));
            ("raw", [factor; 3], None, "float outputs:r")
        }
    };
    out.begin("def Shader", name, &[]);
    out.line("uniform token info:id = \"UsdUVTexture\"");
    if let Some(bias) = bias {
        out.line(&format!("float4 inputs:bias = {bias}"));
    }
    out.line(&format!("asset inputs:file = @./{}@", picture.path(texture)));
    out.line(&format!("float4 inputs:scale = ({}, 1)", numbers(scale, ", ")));
    out.line(&format!("token inputs:sourceColorSpace = \"{space}\""));
    out.line(&format!("float2 inputs:st.connect = {places}"));
    out.line("token inputs:wrapS = \"repeat\"");
    out.line("token inputs:wrapT = \"repeat\"");
    out.line(output);
    out.end();
}
