//! One GLB file: a node for each object and each piece of the building, found again by `extras.scenelang`.
//!
//! glTF is right-handed: x is negated and triangles run the other way round; the front stays +z. Colours are linear.

use crate::geometry::frame::{mirrored, mirrored_quaternion};
use crate::geometry::mesh::Group;
use crate::scene::{Role, Shell, view};
use crate::{ExportError, Exporter, OutFile, Scene};
use nalgebra::UnitQuaternion;
use scenelang_assets::Surface;
use scenelang_layout::Vec3;
use serde_json::{Map, Value, json};

/// `NAME.glb`: the one file that travels alone, so it carries the name of the scene.
#[derive(Clone, Copy, Debug)]
pub struct Glb;

impl Exporter for Glb {
    fn name(&self) -> &'static str {
        "glb"
    }
    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError> {
        Ok(vec![OutFile::new(format!("{}.glb", scene.name), bytes(scene)?)])
    }
}

const FLOAT: u32 = 5126;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// Luminous intensity of a room's lamp, candela; of the sun, lux. Modest, for viewers that take them literally.
const LAMP: f64 = 30.0;
const SUN: f64 = 1.5;

/// The whole file.
///
/// # Errors
/// More than 4 GB of geometry.
pub fn bytes(scene: &Scene) -> Result<Vec<u8>, ExportError> {
    let mut writer = Writer::default();
    writer.scene(scene);
    writer.finish()
}

/// The document as it grows; vertices and indices in a buffer view for each kind.
#[derive(Default)]
struct Writer<'a> {
    nodes: Vec<Value>,
    meshes: Vec<Value>,
    accessors: Vec<Value>,
    materials: Vec<Value>,
    lights: Vec<Value>,
    /// For each material of the document the scene's surface.
    used: Vec<usize>,
    /// Meshes written so far: equal ones are written once.
    written: Vec<&'a [Group]>,
    /// Positions, normals, short indices, long indices.
    views: [Vec<u8>; 4],
    root: Map<String, Value>,
}

impl<'a> Writer<'a> {
    fn scene(&mut self, scene: &'a Scene) {
        for object in &scene.objects {
            let extras = json!({ "id": object.name, "category": object.category, "label": object.label });
            let mut node = node(&object.name, &extras);
            node["translation"] = triple(mirrored(object.place.pos));
            node["rotation"] = json!(mirrored_quaternion(object.quaternion()));
            self.mesh(&mut node, &object.name, &object.mesh, scene);
            self.nodes.push(node);
        }
        for shell in &scene.shells {
            let mut node = node(&shell.name, &shell_extras(shell));
            self.mesh(&mut node, &shell.name, std::slice::from_ref(&shell.group), scene);
            self.nodes.push(node);
        }
        self.light("sun", json!({ "type": "directional", "intensity": SUN }), |node| {
            // Lights of a glTF shine along −z.
            let turn = UnitQuaternion::rotation_between(&-Vec3::z(), &mirrored(view::SUN));
            node["rotation"] = json!(turn.map_or([0.0, 0.0, 0.0, 1.0], |q| [q.i, q.j, q.k, q.w]));
        });
        for lamp in &scene.lamps {
            let light =
                json!({ "type": "point", "intensity": LAMP, "range": rounded(lamp.range), "color": [1.0, 0.96, 0.9] });
            self.light(&lamp.name, light, |node| node["translation"] = triple(mirrored(lamp.pos)));
        }
        let mut own = json!({
            "version": env!("CARGO_PKG_VERSION"), "spec": scene.main_text(), "layout": scene.layout_text,
        });
        if let Some(imports) = scene.imports() {
            own["imports"] = imports;
        }
        let extras = json!({ "scenelang": own });
        let all: Vec<usize> = (0..self.nodes.len()).collect();
        self.root.insert("scenes".into(), json!([{ "name": scene.name, "nodes": all, "extras": extras }]));
    }

    fn light(&mut self, name: &str, mut light: Value, place: impl FnOnce(&mut Value)) {
        light["name"] = json!(name);
        let mut node = json!({ "name": name, "extensions": { "KHR_lights_punctual": { "light": self.lights.len() } } });
        place(&mut node);
        self.lights.push(light);
        self.nodes.push(node);
    }

    /// Gives a node its mesh; nothing where there are no triangles (a wall that is all door).
    fn mesh(&mut self, node: &mut Value, name: &str, groups: &'a [Group], scene: &Scene) {
        if groups.iter().all(|g| g.indices.is_empty()) {
            return;
        }
        let known = self.written.iter().position(|w| *w == groups);
        let index = known.unwrap_or_else(|| {
            let primitives: Vec<Value> =
                groups.iter().filter(|g| !g.indices.is_empty()).map(|g| self.primitive(g, scene)).collect();
            self.meshes.push(json!({ "name": name, "primitives": primitives }));
            self.written.push(groups);
            self.written.len() - 1
        });
        node["mesh"] = json!(index);
    }

    fn primitive(&mut self, group: &Group, scene: &Scene) -> Value {
        let mirror = |[x, y, z]: [f32; 3]| [0.0 - x, y, z];
        let bounds = group
            .positions
            .iter()
            .copied()
            .map(mirror)
            .fold(([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]), |(lo, hi), p| {
                (std::array::from_fn(|i| p[i].min(lo[i])), std::array::from_fn(|i| p[i].max(hi[i])))
            });
        let position = self.accessor(0, FLOAT, "VEC3", group.positions.len());
        self.accessors[position]["min"] = json!(bounds.0.map(f64::from));
        self.accessors[position]["max"] = json!(bounds.1.map(f64::from));
        let normal = self.accessor(1, FLOAT, "VEC3", group.normals.len());
        for (view, vectors) in [(0, &group.positions), (1, &group.normals)] {
            self.views[view].extend(vectors.iter().copied().flat_map(mirror).flat_map(f32::to_le_bytes));
        }
        // 65535 restarts a strip, so that many vertices already need long indices.
        let short = group.positions.len() < 0xffff;
        let (view, component) = if short { (2, UNSIGNED_SHORT) } else { (3, UNSIGNED_INT) };
        let indices = self.accessor(view, component, "SCALAR", group.indices.len());
        for t in group.indices.chunks_exact(3) {
            for i in [t[0], t[2], t[1]] {
                let bytes = i.to_le_bytes();
                self.views[view].extend_from_slice(if short { &bytes[..2] } else { &bytes });
            }
        }
        json!({
            "attributes": { "POSITION": position, "NORMAL": normal },
            "indices": indices,
            "material": self.material(group.surface, &scene.surfaces[group.surface]),
        })
    }

    /// An accessor at the end of a view; the view's number is that of its kind until [`Self::finish`].
    fn accessor(&mut self, view: usize, component: u32, kind: &str, count: usize) -> usize {
        self.accessors.push(json!({
            "bufferView": view, "byteOffset": self.views[view].len(), "componentType": component, "type": kind, "count": count,
        }));
        self.accessors.len() - 1
    }

    fn material(&mut self, index: usize, surface: &Surface) -> usize {
        self.used.iter().position(|&u| u == index).unwrap_or_else(|| {
            self.used.push(index);
            self.materials.push(material(surface));
            self.used.len() - 1
        })
    }

    fn finish(mut self) -> Result<Vec<u8>, ExportError> {
        let mut binary = Vec::new();
        let mut buffer_views = Vec::new();
        let mut number = [0; 4];
        for (kind, view) in self.views.iter().enumerate().filter(|(_, v)| !v.is_empty()) {
            number[kind] = buffer_views.len();
            let mut entry = json!({ "buffer": 0, "byteOffset": binary.len(), "byteLength": view.len() });
            entry["target"] = json!(if kind < 2 { VERTICES } else { INDICES });
            if kind < 2 {
                entry["byteStride"] = json!(12);
            }
            buffer_views.push(entry);
            binary.extend_from_slice(view);
            binary.resize(binary.len().next_multiple_of(4), 0);
        }
        for accessor in &mut self.accessors {
            let kind = accessor["bufferView"].as_u64().unwrap_or_default() as usize;
            accessor["bufferView"] = json!(number[kind]);
        }
        let mut root = self.root;
        root.insert(
            "asset".into(),
            json!({ "version": "2.0", "generator": concat!("scenelang ", env!("CARGO_PKG_VERSION")) }),
        );
        root.insert("scene".into(), json!(0));
        root.insert("extensionsUsed".into(), json!(["KHR_lights_punctual"]));
        root.insert("extensions".into(), json!({ "KHR_lights_punctual": { "lights": self.lights } }));
        for (key, values) in [
            ("nodes", self.nodes),
            ("meshes", self.meshes),
            ("materials", self.materials),
            ("accessors", self.accessors),
            ("bufferViews", buffer_views),
        ] {
            if !values.is_empty() {
                root.insert(key.into(), Value::Array(values));
            }
        }
        if !binary.is_empty() {
            root.insert("buffers".into(), json!([{ "byteLength": binary.len() }]));
        }
        container(Value::Object(root).to_string().into_bytes(), &binary)
    }
}

/// The two chunks with their headers.
fn container(mut document: Vec<u8>, binary: &[u8]) -> Result<Vec<u8>, ExportError> {
    document.resize(document.len().next_multiple_of(4), b' ');
    let chunks: &[(&[u8], &[u8; 4])] =
        if binary.is_empty() { &[(&document, b"JSON")] } else { &[(&document, b"JSON"), (binary, b"BIN\0")] };
    let total = 12 + chunks.iter().map(|(data, _)| 8 + data.len()).sum::<usize>();
    let length = |n: usize| {
        u32::try_from(n).map_err(|_| ExportError::Format("glb", "the scene has more than 4 GB of geometry".into()))
    };
    let mut out = Vec::with_capacity(total);
    out.extend_from_slice(b"glTF");
    out.extend(2_u32.to_le_bytes());
    out.extend(length(total)?.to_le_bytes());
    for (data, kind) in chunks {
        out.extend(length(data.len())?.to_le_bytes());
        out.extend_from_slice(*kind);
        out.extend_from_slice(data);
    }
    Ok(out)
}

fn node(name: &str, extras: &Value) -> Value {
    json!({ "name": name, "extras": { "scenelang": extras } })
}

fn shell_extras(shell: &Shell) -> Value {
    let part = match shell.role {
        Role::Floor | Role::Tint => "floor",
        Role::Ceiling => "ceiling",
        Role::Wall { .. } => "wall",
    };
    match &shell.region {
        Some(region) => json!({ "region": region, "part": part }),
        None => json!({ "part": part }),
    }
}

fn material(surface: &Surface) -> Value {
    let [r, g, b] = surface.color.map(|c| rounded(linear(c)));
    let mut out = json!({
        "name": surface.name,
        "pbrMetallicRoughness": {
            "baseColorFactor": [r, g, b, rounded(surface.opacity.into())],
            "metallicFactor": rounded(surface.metallic.into()),
            "roughnessFactor": rounded(surface.roughness.into()),
        },
    });
    if surface.opacity < 1.0 {
        out["alphaMode"] = json!("BLEND");
    }
    if let Some(emissive) = surface.emissive {
        out["emissiveFactor"] = json!(emissive.map(|c| rounded(linear(c))));
    }
    out
}

/// Linear light from an sRGB component.
pub(crate) fn linear(c: f32) -> f64 {
    let c = f64::from(c);
    if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
}

fn triple(v: Vec3) -> Value {
    json!([v.x, v.y, v.z])
}

/// Six decimals: enough for colours and ranges, and easy on the eye.
fn rounded(v: f64) -> f64 {
    (v * 1e6).round() / 1e6
}
