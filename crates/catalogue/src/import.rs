//! A folder of models as a catalogue of its own: each model a GLB file in metres, on its base, with its front to +z, and with
//! a card that says all of that. What is read from it needs no guess any more.

use crate::folder::{Catalogue, Entry};
use crate::model::CatalogueModel;
use crate::provide::sum;
use scenelang_assets::{MeshGroup, Surface};
use scenelang_base::Diagnostic;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::Path;

/// What became of a file.
#[derive(Clone, Debug)]
pub struct Imported {
    /// The file, below the folder that was read.
    pub file: String,
    /// The model in the catalogue, and what was found of it; or why there is none.
    pub outcome: Result<Kept, Box<Diagnostic>>,
}

/// A model of the catalogue.
#[derive(Clone, Debug)]
pub struct Kept {
    /// Its file, below that of the catalogue; the card is beside it.
    pub name: String,
    pub glb: Vec<u8>,
    pub card: Value,
    /// How many convex parts it has.
    pub parts: usize,
}

/// Reads a folder, in the order of its names.
///
/// # Errors
/// There is no such folder, or nothing to read in it.
pub fn import(folder: &Path) -> Result<Vec<Imported>, Box<Diagnostic>> {
    let catalogue = Catalogue::list(folder)?;
    let mut taken = BTreeSet::new();
    let refused =
        catalogue.refused.iter().map(|r| Imported { file: r.file.clone(), outcome: Err(Box::new(r.finding.clone())) });
    let mut out: Vec<Imported> = refused.collect();
    for entry in &catalogue.entries {
        let outcome = kept(&catalogue, entry, &mut taken);
        out.push(Imported { file: entry.file.clone(), outcome });
    }
    out.sort_by(|a, b| a.file.cmp(&b.file));
    Ok(out)
}

fn kept(catalogue: &Catalogue, entry: &Entry, taken: &mut BTreeSet<String>) -> Result<Kept, Box<Diagnostic>> {
    let bytes = catalogue.bytes(entry)?;
    let content = sum(&[&bytes]);
    let model = catalogue.model_of(entry, bytes)?;
    Ok(Kept {
        name: name(&entry.file, taken),
        glb: glb(&model),
        card: card(&model, &content),
        parts: model.parts.len(),
    })
}

/// A name of its own, also where case does not count: `a/chair.obj` is `a/chair.glb`, or `a/chair-2.glb`.
fn name(file: &str, taken: &mut BTreeSet<String>) -> String {
    // Objects of objathor are in folders of their own.
    let file = file.strip_prefix("assets/").and_then(|rest| rest.rsplit('/').next()).unwrap_or(file);
    let stem = [".json.gz", ".json", ".glb", ".obj"].iter().find_map(|end| {
        let cut = file.len().checked_sub(end.len())?;
        file.get(cut..).filter(|rest| rest.eq_ignore_ascii_case(end)).map(|_| &file[..cut])
    });
    let stem = stem.unwrap_or(file);
    let numbered = |n: usize| if n == 1 { format!("{stem}.glb") } else { format!("{stem}-{n}.glb") };
    let free = (1..).map(numbered).find(|name| taken.insert(name.to_lowercase()));
    free.unwrap_or_else(|| format!("{stem}.glb"))
}

fn card(model: &CatalogueModel, content: &str) -> Value {
    let card = &model.card;
    let mut out = json!({
        "category": card.category,
        "size": [model.size.x, model.size.y, model.size.z],
        "up": "y",
    });
    let text = |text: &str| (!text.is_empty()).then(|| json!(text));
    let more = [
        ("description", text(&card.description)),
        ("synset", text(&card.synset)),
        ("materials", (!card.materials.is_empty()).then(|| json!(card.materials))),
        // Where nobody has said it, that stays so: `check` asks for it.
        ("front", card.front.map(|_| json!("+z"))),
        ("licence", card.licence.as_deref().and_then(text)),
        ("mass", card.mass.map(|mass| json!(mass))),
        ("source", text(&model.file)),
        ("source_sha256", text(content)),
    ];
    for (key, value) in more {
        if let Some(value) = value {
            out[key] = value;
        }
    }
    out
}

/// A model as a GLB file: right-handed, so mirrored along x.
fn glb(model: &CatalogueModel) -> Vec<u8> {
    let groups: Vec<&MeshGroup> = model.mesh.groups.iter().filter(|g| !g.indices.is_empty()).collect();
    let mut binary: Vec<u8> = Vec::new();
    let (mut views, mut accessors) = (Vec::new(), Vec::new());
    let mut add = |bytes: Vec<u8>, target: u32, accessor: Value| {
        views.push(json!({ "buffer": 0, "byteOffset": binary.len(), "byteLength": bytes.len(), "target": target }));
        binary.extend(bytes);
        let mut accessor = accessor;
        accessor["bufferView"] = json!(views.len() - 1);
        accessors.push(accessor);
        accessors.len() - 1
    };
    let mut primitives = Vec::new();
    for (material, group) in groups.iter().enumerate() {
        let points: Vec<[f32; 3]> = group.positions.iter().map(|[x, y, z]| [0.0 - x, *y, *z]).collect();
        let normals: Vec<[f32; 3]> = group.normals.iter().map(|[x, y, z]| [0.0 - x, *y, *z]).collect();
        let flipped: Vec<u32> = group.indices.as_chunks::<3>().0.iter().flat_map(|[a, b, c]| [*a, *c, *b]).collect();
        let bound = |pick: fn(f32, f32) -> f32| {
            let first = points.first().copied().unwrap_or_default();
            points.iter().fold(first, |lo, p| [0, 1, 2].map(|axis| pick(lo[axis], p[axis])))
        };
        let bytes = |list: &[[f32; 3]]| list.iter().flatten().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
        let vectors = |count: usize| json!({ "componentType": 5126, "count": count, "type": "VEC3" });
        let mut position = vectors(points.len());
        position["min"] = json!(bound(f32::min));
        position["max"] = json!(bound(f32::max));
        let position = add(bytes(&points), 34962, position);
        let normal = add(bytes(&normals), 34962, vectors(normals.len()));
        let indices = flipped.iter().flat_map(|i| i.to_le_bytes()).collect();
        let count = json!({ "componentType": 5125, "count": flipped.len(), "type": "SCALAR" });
        let indices = add(indices, 34963, count);
        primitives.push(json!({
            "attributes": { "POSITION": position, "NORMAL": normal }, "indices": indices, "material": material,
        }));
    }
    let document = json!({
        "asset": { "version": "2.0", "generator": concat!("scenelang ", env!("CARGO_PKG_VERSION")) },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "name": model.card.category, "mesh": 0 }],
        "meshes": [{ "primitives": primitives }],
        "materials": groups.iter().map(|g| material(&g.surface)).collect::<Vec<_>>(),
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{ "byteLength": binary.len() }],
    });
    packed(&document, binary)
}

/// Colours of glTF are linear.
fn material(surface: &Surface) -> Value {
    let linear = |x: f32| {
        let x = f64::from(x);
        if x <= 0.040_45 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
    };
    let [r, g, b] = surface.color.map(linear);
    let mut out = json!({
        "name": surface.name,
        "pbrMetallicRoughness": {
            "baseColorFactor": [r, g, b, surface.opacity],
            "metallicFactor": surface.metallic,
            "roughnessFactor": surface.roughness,
        },
    });
    if let Some(glow) = surface.emissive {
        out["emissiveFactor"] = json!(glow.map(linear));
    }
    if surface.opacity < 1.0 {
        out["alphaMode"] = json!("BLEND");
    }
    out
}

fn packed(document: &Value, mut binary: Vec<u8>) -> Vec<u8> {
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    binary.resize(binary.len().next_multiple_of(4), 0);
    let mut out = Vec::with_capacity(28 + text.len() + binary.len());
    let length = |n: usize| (n as u32).to_le_bytes();
    out.extend(b"glTF");
    out.extend(2_u32.to_le_bytes());
    out.extend(length(28 + text.len() + binary.len()));
    for (kind, data) in [(b"JSON", &text), (b"BIN\0", &binary)] {
        out.extend(length(data.len()));
        out.extend(kind);
        out.extend(data);
    }
    out
}
