//! GLB files: the triangles of the scene, in its right-handed frame (y up, front to +z).
//!
//! This is no general reader. The well-known ones assert where a file of a stranger has to be refused, so this one reads
//! the little that is needed, and nothing before it is known to be there: positions, normals and plain colours, where the
//! nodes of the scene put them.

mod data;
mod document;

use crate::faults::{Fault, beyond, broken, fault};
use crate::limits;
use crate::raw::{Patch, Raw, plain_surface, surface};
use data::Data;
use document::{GlbDocument, GlbNode, Material, Primitive};
use nalgebra::{Matrix4, Quaternion, Translation3, UnitQuaternion, Vector3};
use scenelang_assets::Surface;
use scenelang_base::codes;

const JSON: u32 = 0x4e4f_534a;
const BINARY: u32 = 0x004e_4942;
const POINTS_AND_LINES: std::ops::Range<u32> = 0..4;
const TRIANGLES: u32 = 4;
const STRIP: u32 = 5;
const FAN: u32 = 6;

/// Extensions that change nothing of what is read here, so that a file may demand them.
const HARMLESS: [&str; 8] = [
    "KHR_lights_punctual",
    "KHR_materials_clearcoat",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_texture_transform",
];

/// The triangles of a GLB file.
pub(crate) fn read(bytes: &[u8]) -> Result<Raw, Fault> {
    let (json, binary) = chunks(bytes)?;
    let document: GlbDocument =
        serde_json::from_slice(json).map_err(|e| broken(format!("its JSON is not valid glTF: {e}")))?;
    refuse_references(&document, binary.len())?;
    if let Some(unknown) = document.extensions_required.iter().find(|e| !HARMLESS.contains(&e.as_str())) {
        return Err(broken(format!("it requires the extension {unknown}, which is not supported")));
    }
    let mut walk = Walk { data: Data { document: &document, binary }, raw: Raw::default(), left: limits::NODES };
    let scene = document.scenes.get(document.scene.unwrap_or(0)).ok_or_else(|| broken("it has no scene"))?;
    for &node in &scene.nodes {
        walk.node(node, &Matrix4::identity(), 0)?;
    }
    Ok(walk.raw)
}

/// The JSON and the binary chunk: a header of 12 bytes, then length, kind and data of each chunk.
fn chunks(bytes: &[u8]) -> Result<(&[u8], &[u8]), Fault> {
    let number = |at: usize| bytes.get(at..at + 4)?.try_into().ok().map(u32::from_le_bytes);
    if !bytes.starts_with(b"glTF") {
        return Err(broken("it is not a GLB file"));
    }
    match number(4) {
        Some(2) => {}
        Some(version) => return Err(broken(format!("it is GLB version {version}, not version 2"))),
        None => return Err(broken("it ends within its header")),
    }
    let said = number(8).ok_or_else(|| broken("it ends within its header"))? as usize;
    if said > bytes.len() {
        return Err(broken(format!("it is truncated: it declares {said} bytes, but has {}", bytes.len())));
    }
    let (mut json, mut binary) = (None, None);
    let mut at = 12;
    while let (Some(length), Some(kind)) = (number(at), number(at + 4)) {
        let start = at + 8;
        let end = start.checked_add(length as usize).filter(|end| *end <= bytes.len());
        let Some(end) = end else { return Err(broken("it ends within a chunk")) };
        match kind {
            JSON if json.is_none() => json = Some(&bytes[start..end]),
            BINARY if binary.is_none() => binary = Some(&bytes[start..end]),
            _ => {}
        }
        at = end;
    }
    Ok((json.ok_or_else(|| broken("it has no JSON chunk"))?, binary.unwrap_or_default()))
}

/// Buffers must be in the file; pictures, which are not looked at, must not lead out of its folder.
fn refuse_references(document: &GlbDocument, binary: usize) -> Result<(), Fault> {
    for (i, buffer) in document.buffers.iter().enumerate() {
        if buffer.uri.is_some() || i > 0 {
            return Err(fault(codes::E0703, "it has a buffer that is not in the file"));
        }
        if buffer.byte_length > limits::BYTES as u64 {
            let claim = buffer.byte_length >> 20;
            return Err(beyond(format!(
                "it declares a buffer of {claim} MB; the maximum is {} MB",
                limits::BYTES >> 20
            )));
        }
        if buffer.byte_length > binary as u64 {
            let claim = buffer.byte_length;
            return Err(broken(format!("it declares a buffer of {claim} bytes, but has {binary}")));
        }
    }
    let leads_out = |uri: &str| {
        let uri =
            uri.replace('\\', "/").replace("%2e", ".").replace("%2E", ".").replace("%2f", "/").replace("%2F", "/");
        uri.starts_with('/') || uri.contains(':') || uri.split('/').any(|part| part == "..")
    };
    match document.images.iter().filter_map(|i| i.uri.as_deref()).find(|u| !u.starts_with("data:") && leads_out(u)) {
        Some(uri) => Err(fault(codes::E0703, format!("it refers to an image outside its folder: {}", excerpt(uri)))),
        None => Ok(()),
    }
}

/// So much of a text as fits into a message.
fn excerpt(text: &str) -> String {
    let start: String = text.chars().take(60).collect();
    if start.len() < text.len() { format!("{start}…") } else { start }
}

/// The nodes of a scene, one after the other.
struct Walk<'d> {
    data: Data<'d>,
    raw: Raw,
    /// How many nodes may still be looked at: they may refer to each other in circles.
    left: usize,
}

impl Walk<'_> {
    fn node(&mut self, index: usize, above: &Matrix4<f64>, depth: usize) -> Result<(), Fault> {
        let document = self.data.document;
        let node = document.nodes.get(index).ok_or_else(|| broken(format!("there is no node {index}")))?;
        if depth > limits::DEPTH {
            return Err(beyond(format!("its nodes are nested more than {} levels deep", limits::DEPTH)));
        }
        self.left =
            self.left.checked_sub(1).ok_or_else(|| beyond(format!("it has more than {} nodes", limits::NODES)))?;
        let here = above * local(node)?;
        if let Some(mesh) = node.mesh {
            let mesh = document.meshes.get(mesh).ok_or_else(|| broken(format!("there is no mesh {mesh}")))?;
            for primitive in &mesh.primitives {
                if let Some(patch) = self.patch(primitive)? {
                    self.raw.add(patch.placed(&here))?;
                }
            }
        }
        node.children.iter().try_for_each(|&child| self.node(child, &here, depth + 1))
    }

    /// The triangles of a primitive; `None` for points and lines.
    fn patch(&self, primitive: &Primitive) -> Result<Option<Patch>, Fault> {
        if POINTS_AND_LINES.contains(&primitive.mode) {
            return Ok(None);
        }
        let Some(&positions) = primitive.attributes.get("POSITION") else { return Ok(None) };
        let positions = self.data.vectors(positions)?;
        let normals = primitive.attributes.get("NORMAL").map(|&n| self.data.vectors(n)).transpose()?;
        let corners = match primitive.indices {
            Some(indices) => self.data.indices(indices)?,
            None => (0..positions.len() as u32).collect(),
        };
        let indices = match primitive.mode {
            TRIANGLES => corners[..corners.len() / 3 * 3].to_vec(),
            STRIP => strip(&corners),
            FAN => corners.windows(2).skip(1).flat_map(|w| [corners[0], w[0], w[1]]).collect(),
            other => return Err(broken(format!("there is no primitive mode {other}"))),
        };
        let surface = primitive.material.and_then(|m| self.data.document.materials.get(m)).map(look);
        let normals = normals.filter(|n| n.len() == positions.len()).unwrap_or_default();
        Ok(Some(Patch { surface: surface.unwrap_or_else(plain_surface), positions, normals, indices }))
    }
}

/// Triangles of a strip: every other one runs the other way round.
fn strip(corners: &[u32]) -> Vec<u32> {
    let turned = |(i, t): (usize, &[u32])| if i % 2 == 0 { [t[0], t[1], t[2]] } else { [t[1], t[0], t[2]] };
    corners.windows(3).enumerate().flat_map(turned).collect()
}

/// The transform of a node: a matrix, column by column, or translation, rotation and scale.
fn local(node: &GlbNode) -> Result<Matrix4<f64>, Fault> {
    let matrix = match &node.matrix {
        Some(matrix) => Matrix4::from_column_slice(matrix),
        None => {
            let [x, y, z, w] = node.rotation;
            let turn = UnitQuaternion::try_new(Quaternion::new(w, x, y, z), 1e-9);
            let turn = turn.ok_or_else(|| broken("a node has an invalid rotation"))?;
            Translation3::from(Vector3::from(node.translation)).to_homogeneous()
                * turn.to_homogeneous()
                * Matrix4::new_nonuniform_scaling(&Vector3::from(node.scale))
        }
    };
    if matrix.iter().all(|x| x.is_finite()) {
        Ok(matrix)
    } else {
        Err(broken("a node has a transform that is not finite"))
    }
}

/// What a material looks like. Colours of glTF are linear.
fn look(material: &Material) -> Surface {
    let pbr = &material.pbr;
    let srgb = |x: f64| {
        let x = x.clamp(0.0, 1.0);
        (if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 }) as f32
    };
    let [r, g, b, a] = pbr.base_color_factor;
    let opacity = if material.alpha_mode.as_deref() == Some("BLEND") { a as f32 } else { 1.0 };
    surface(
        [r, g, b].map(srgb),
        opacity,
        pbr.roughness_factor as f32,
        pbr.metallic_factor as f32,
        material.emissive_factor.map(srgb),
    )
}
