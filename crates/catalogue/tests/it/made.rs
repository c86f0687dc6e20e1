//! GLB files made on the spot: a small writer, and meshes to write with it.

use scenelang_assets::{Asset, AssetRequest, furnish};
use scenelang_layout::Vec3;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// Triangles in the frame of glTF: right-handed, y up.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    pub positions: Vec<[f32; 3]>,
    pub indices: Vec<u32>,
}

impl Mesh {
    /// Adds a box between two corners.
    pub fn cuboid(mut self, lo: [f32; 3], hi: [f32; 3]) -> Self {
        let first = self.positions.len() as u32;
        self.positions.extend((0..8).map(|i: usize| {
            let pick = |axis: usize| if i >> axis & 1 == 1 { hi[axis] } else { lo[axis] };
            [pick(0), pick(1), pick(2)]
        }));
        for [a, b, c, d] in [[1, 3, 7, 5], [0, 4, 6, 2], [2, 6, 7, 3], [0, 1, 5, 4], [4, 5, 7, 6], [0, 2, 3, 1]] {
            self.indices.extend([a, b, c, a, c, d].map(|i| first + i));
        }
        self
    }

    /// A profile (x, y) carried along z: one piece, closed, not convex; `caps` are the triangles of the profile.
    pub fn extruded(profile: &[[f32; 2]], caps: &[[u32; 3]], depth: f32) -> Self {
        let n = profile.len() as u32;
        let ring = |z: f32| profile.iter().map(move |[x, y]| [*x, *y, z]);
        let mut mesh = Self { positions: ring(0.0).chain(ring(depth)).collect(), indices: Vec::new() };
        for &[a, b, c] in caps {
            mesh.indices.extend([c, b, a, n + a, n + b, n + c]);
        }
        for i in 0..n {
            let j = (i + 1) % n;
            mesh.indices.extend([i, j, n + j, i, n + j, n + i]);
        }
        mesh
    }

    /// What the furniture library draws.
    pub fn of(asset: &Asset) -> Self {
        let mut mesh = Self::default();
        for group in &asset.mesh.groups {
            let first = mesh.positions.len() as u32;
            mesh.positions.extend(group.positions.iter().map(|[x, y, z]| [-x, *y, *z]));
            mesh.indices.extend(group.indices.chunks_exact(3).flat_map(|t| [t[0], t[2], t[1]].map(|i| first + i)));
        }
        mesh
    }

    /// Every vertex changed.
    pub fn map(mut self, by: impl Fn([f32; 3]) -> [f32; 3]) -> Self {
        self.positions.iter_mut().for_each(|p| *p = by(*p));
        self
    }

    /// A document that shows it, and the numbers of it.
    pub fn document(&self) -> (Value, Vec<u8>) {
        let mut binary: Vec<u8> = self.positions.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
        let start = binary.len();
        binary.extend(self.indices.iter().flat_map(|i| i.to_le_bytes()));
        let document = json!({
            "asset": { "version": "2.0" },
            "scene": 0,
            "scenes": [{ "nodes": [0] }],
            "nodes": [{ "mesh": 0 }],
            "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }],
            "accessors": [
                { "bufferView": 0, "componentType": 5126, "count": self.positions.len(), "type": "VEC3" },
                { "bufferView": 1, "componentType": 5125, "count": self.indices.len(), "type": "SCALAR" },
            ],
            "bufferViews": [
                { "buffer": 0, "byteOffset": 0, "byteLength": start },
                { "buffer": 0, "byteOffset": start, "byteLength": binary.len() - start },
            ],
            "buffers": [{ "byteLength": binary.len() }],
        });
        (document, binary)
    }

    /// The file.
    pub fn glb(&self) -> Vec<u8> {
        let (document, binary) = self.document();
        glb(&document, &binary)
    }
}

/// A GLB file of a document and its numbers.
pub fn glb(document: &Value, binary: &[u8]) -> Vec<u8> {
    let chunk = |kind: &[u8; 4], data: &[u8], fill: u8| {
        let mut data = data.to_vec();
        data.resize(data.len().next_multiple_of(4), fill);
        [&(data.len() as u32).to_le_bytes(), kind.as_slice(), &data].concat()
    };
    let chunks = [chunk(b"JSON", document.to_string().as_bytes(), b' '), chunk(b"BIN\0", binary, 0)].concat();
    [b"glTF".as_slice(), &2_u32.to_le_bytes(), &(chunks.len() as u32 + 12).to_le_bytes(), &chunks].concat()
}

/// A box of these extents on the floor.
pub fn block(w: f32, h: f32, d: f32) -> Mesh {
    Mesh::default().cuboid([-w / 2.0, 0.0, -d / 2.0], [w / 2.0, h, d / 2.0])
}

/// Writes a model and, unless it is null, its card.
pub fn write(folder: &Path, name: &str, bytes: &[u8], card: &Value) {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(&path, bytes).unwrap();
    if !card.is_null() {
        fs::write(path.with_extension("json"), card.to_string()).unwrap();
    }
}

/// A thing as the furniture library makes it.
pub fn furniture(category: &str) -> Asset {
    furnish(&AssetRequest { category, size: usual(category), ..AssetRequest::default() })
}

/// The usual size of a category.
pub fn usual(category: &str) -> Option<Vec3> {
    scenelang_lang::library::usual_size(category).map(Vec3::from)
}

/// A card with nothing to find fault with.
pub fn card(category: &str, size: &Vec3) -> Value {
    json!({ "category": category, "front": "+z", "licence": "CC0-1.0", "mass": 100.0 * size.product() })
}
