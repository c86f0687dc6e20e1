//! One GLB file: a node for each object and each piece of the building, found again by `extras.scenelang`.
//!
//! glTF is right-handed: x is negated and triangles run the other way round; the front stays +z. Colours are linear.

mod physics;

use crate::geometry::frame::{mirrored, mirrored_quaternion};
use crate::geometry::mesh::MeshGroup;
use crate::geometry::tangent::tangents;
use crate::physics::{Apart, Physics, drawn_apart};
use crate::scene::{Shell, view};
use crate::{ExportError, Exporter, OutFile, Scene, textures};
use nalgebra::UnitQuaternion;
use scenelang_assets::Surface;
use scenelang_assets::textures::Texture;
use scenelang_layout::Vec3;
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, BTreeSet};

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

/// The same file with rigid bodies: colliders, mass, and joints for what opens.
#[derive(Clone, Copy, Debug)]
pub struct WithPhysics;

impl Exporter for WithPhysics {
    fn name(&self) -> &'static str {
        Glb.name()
    }
    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError> {
        let apart: Vec<_> = scene.objects.iter().map(drawn_apart).collect();
        let bytes = write(scene, &apart, Some(&Physics::of(scene)))?;
        Ok(vec![OutFile::new(format!("{}.glb", scene.name), bytes)])
    }
}

const FLOAT: u32 = 5126;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// Of the sun, lux: modest, for viewers that take it literally.
const SUN: f64 = 1.5;

/// The whole file.
///
/// # Errors
/// More than 4 GB of geometry.
pub fn bytes(scene: &Scene) -> Result<Vec<u8>, ExportError> {
    write(scene, &[], None)
}

/// The same with a node of its own for each movable part, below that of its object: `extras.scenelang` has the names of both.
/// Its frame is that of the object.
///
/// # Errors
/// More than 4 GB of geometry.
pub(crate) fn in_pieces(scene: &Scene) -> Result<Vec<u8>, ExportError> {
    write(scene, &scene.objects.iter().map(drawn_apart).collect::<Vec<_>>(), None)
}

fn write(scene: &Scene, apart: &[Option<Apart>], physics: Option<&Physics<'_>>) -> Result<Vec<u8>, ExportError> {
    let mut writer = Writer { has_physics: physics.is_some(), ..Writer::default() };
    writer.textures(scene)?;
    writer.scene(scene, apart, physics);
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
    written: Vec<&'a [MeshGroup]>,
    /// Positions, normals, places on materials, tangents, short indices, long indices.
    views: [Vec<u8>; KINDS.len()],
    /// The kinds of textures of the document.
    textures: Vec<Texture>,
    /// Their pictures, as many for each as [`PICTURES`] has names.
    images: Vec<Vec<u8>>,
    root: Map<String, Value>,
    /// Whether there are rigid bodies.
    has_physics: bool,
    /// What they share.
    physics: physics::Resources,
    /// Nodes with the meshes of hulls, which come after those that are seen.
    hulls: Vec<(usize, Value)>,
}

/// What the buffer views of geometry hold: the target, and the bytes of a vertex.
const KINDS: [(u32, Option<usize>); 6] = [
    (VERTICES, Some(12)),
    (VERTICES, Some(12)),
    (VERTICES, Some(8)),
    (VERTICES, Some(16)),
    (INDICES, None),
    (INDICES, None),
];
/// The pictures of a texture.
const PICTURES: [&str; 3] = ["color", "normal", "roughness"];

impl<'a> Writer<'a> {
    /// A set of pictures for each kind of texture.
    fn textures(&mut self, scene: &Scene) -> Result<(), ExportError> {
        self.textures = textures::used(scene);
        for &texture in &self.textures {
            self.images.extend([textures::color(texture)?, textures::normal(texture)?, textures::roughness(texture)?]);
        }
        Ok(())
    }

    fn scene(&mut self, scene: &'a Scene, apart: &'a [Option<Apart>], physics: Option<&Physics<'_>>) {
        let apart = |index: usize| apart.get(index).and_then(Option::as_ref);
        for (index, object) in scene.objects.iter().enumerate() {
            let extras = json!({ "id": object.name, "category": object.category, "label": object.label });
            let mut node = node(&object.name, &extras);
            node["translation"] = triple(mirrored(object.place.pos));
            node["rotation"] = json!(mirrored_quaternion(object.quaternion()));
            let body = apart(index).map_or(&object.mesh, |(body, _)| body);
            self.mesh(&mut node, &object.name, body, scene);
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
        let mut hanging = BTreeSet::new();
        // By the names that bodies and their pieces have.
        let objects = scene.objects.iter().map(|object| object.name.clone());
        let names = objects.chain(scene.shells.iter().map(|shell| shell.name.clone()));
        let mut nodes: BTreeMap<String, usize> = names.zip(0..).collect();
        for (owner, object) in scene.objects.iter().enumerate() {
            let moving = apart(owner).into_iter().flat_map(|(_, moving)| moving);
            for (joint, groups) in object.place.joints.iter().zip(moving) {
                let name = format!("{}/{}", object.name, joint.name);
                let mut node = node(&name, &json!({ "of": object.name, "joint": joint.name.as_str() }));
                self.mesh(&mut node, &name, groups, scene);
                self.nodes.push(node);
                hanging.insert(self.hang(owner));
                nodes.insert(name, self.nodes.len() - 1);
            }
        }
        for lamp in &scene.lamps {
            let light = json!({
                "type": "point", "intensity": rounded(lamp.candela), "range": rounded(lamp.range),
                "color": lamp.color.map(|c| rounded(linear(c))),
            });
            // What belongs to a thing is moved with it.
            let object = lamp.object.and_then(|index| scene.objects.get(index).zip(Some(index)));
            let pos = object.map_or(lamp.pos, |(o, _)| o.axes.transpose() * (lamp.pos - o.place.pos));
            self.light(&lamp.name, light, |node| node["translation"] = triple(mirrored(pos)));
            if let Some((_, index)) = object {
                hanging.insert(self.hang(index));
            }
        }
        if let Some(physics) = physics {
            let first = self.nodes.len();
            self.bodies(physics, &nodes);
            // All of them hang on others, or are in no scene.
            hanging.extend(first..self.nodes.len());
        }
        let mut own = json!({
            "version": env!("CARGO_PKG_VERSION"), "spec": scene.main_text(), "layout": scene.layout_text,
        });
        if let Some(imports) = scene.imports() {
            own["imports"] = imports;
        }
        let extras = json!({ "scenelang": own });
        let all: Vec<usize> = (0..self.nodes.len()).filter(|n| !hanging.contains(n)).collect();
        self.root.insert("scenes".into(), json!([{ "name": scene.name, "nodes": all, "extras": extras }]));
    }

    /// Hangs the last node below another one; returns its number.
    fn hang(&mut self, owner: usize) -> usize {
        let number = self.nodes.len() - 1;
        match self.nodes[owner]["children"].as_array_mut() {
            Some(children) => children.push(json!(number)),
            None => self.nodes[owner]["children"] = json!([number]),
        }
        number
    }

    fn light(&mut self, name: &str, mut light: Value, place: impl FnOnce(&mut Value)) {
        light["name"] = json!(name);
        let mut node = json!({ "name": name, "extensions": { "KHR_lights_punctual": { "light": self.lights.len() } } });
        place(&mut node);
        self.lights.push(light);
        self.nodes.push(node);
    }

    /// Gives a node its mesh; nothing where there are no triangles (a wall that is all door).
    fn mesh(&mut self, node: &mut Value, name: &str, groups: &'a [MeshGroup], scene: &Scene) {
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

    fn primitive(&mut self, group: &MeshGroup, scene: &Scene) -> Value {
        let position = self.positions(group);
        let normal = self.accessor(1, FLOAT, "VEC3", group.normals.len());
        floats(&mut self.views[1], group.normals.iter().copied().map(mirror));
        let surface = &scene.surfaces[group.surface];
        let texture = Texture::of(surface);
        let place = texture.map(|texture| self.places(group, texture));
        let indices = self.indices(group);
        let mut attributes = json!({ "POSITION": position, "NORMAL": normal });
        if let Some([place, tangent]) = place {
            attributes["TEXCOORD_0"] = json!(place);
            attributes["TANGENT"] = json!(tangent);
        }
        json!({ "attributes": attributes, "indices": indices, "material": self.material(group.surface, surface) })
    }

    /// The accessor of the corners of a group.
    fn positions(&mut self, group: &MeshGroup) -> usize {
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
        floats(&mut self.views[0], group.positions.iter().copied().map(mirror));
        position
    }

    /// The accessor of the triangles of a group.
    fn indices(&mut self, group: &MeshGroup) -> usize {
        // 65535 restarts a strip, so that many vertices already need long indices.
        let short = group.positions.len() < 0xffff;
        let (view, component) = if short { (4, UNSIGNED_SHORT) } else { (5, UNSIGNED_INT) };
        let indices = self.accessor(view, component, "SCALAR", group.indices.len());
        let width = if short { 2 } else { 4 };
        let out = &mut self.views[view];
        out.reserve(width * group.indices.len());
        for t in group.indices.chunks_exact(3) {
            for i in [t[0], t[2], t[1]] {
                out.extend_from_slice(&i.to_le_bytes()[..width]);
            }
        }
        indices
    }

    /// Where on its texture each vertex is, and which way the texture runs there: the numbers of two accessors.
    fn places(&mut self, group: &MeshGroup, texture: Texture) -> [usize; 2] {
        let place = self.accessor(2, FLOAT, "VEC2", group.uvs.len());
        // In tiles, and downwards.
        let [width, height] = texture.pixels().tile.map(|metres| metres as f32);
        floats(&mut self.views[2], group.uvs.iter().map(|[u, v]| [u / width, 0.0 - v / height]));
        let tangent = self.accessor(3, FLOAT, "VEC4", group.uvs.len());
        // In a mirror the other side is the right one.
        let mirror = |([x, y, z], side): ([f32; 3], f32)| [0.0 - x, y, z, -side];
        floats(&mut self.views[3], tangents(group).into_iter().map(mirror));
        [place, tangent]
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
            let texture = Texture::of(surface);
            let number = texture.and_then(|texture| self.textures.iter().position(|t| *t == texture));
            self.used.push(index);
            self.materials.push(material(surface, texture.zip(number)));
            self.used.len() - 1
        })
    }

    fn finish(mut self) -> Result<Vec<u8>, ExportError> {
        let of = |all: &[Vec<u8>]| all.iter().map(|bytes| bytes.len() + 4).sum::<usize>();
        let mut binary = Vec::with_capacity(of(&self.views) + of(&self.images));
        let mut buffer_views = Vec::new();
        let mut number = [0; KINDS.len()];
        let mut add = |bytes: &[u8]| {
            let entry = json!({ "buffer": 0, "byteOffset": binary.len(), "byteLength": bytes.len() });
            binary.extend_from_slice(bytes);
            binary.resize(binary.len().next_multiple_of(4), 0);
            entry
        };
        for (kind, view) in self.views.iter().enumerate().filter(|(_, v)| !v.is_empty()) {
            number[kind] = buffer_views.len();
            let mut entry = add(view);
            let (target, stride) = KINDS[kind];
            entry["target"] = json!(target);
            if let Some(stride) = stride {
                entry["byteStride"] = json!(stride);
            }
            buffer_views.push(entry);
        }
        let mut images = Vec::new();
        for (i, image) in self.images.iter().enumerate() {
            let name = format!("{}_{}", self.textures[i / PICTURES.len()].name(), PICTURES[i % PICTURES.len()]);
            images.push(json!({ "name": name, "mimeType": "image/png", "bufferView": buffer_views.len() }));
            buffer_views.push(add(image));
        }
        let all: Vec<Value> = (0..images.len()).map(|source| json!({ "sampler": 0, "source": source })).collect();
        let samplers = if images.is_empty() { Vec::new() } else { vec![sampler()] };
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
        let mut extensions = Map::new();
        extensions.insert("KHR_lights_punctual".into(), json!({ "lights": self.lights }));
        if self.has_physics {
            self.physics.extensions(&mut extensions);
        }
        root.insert("extensionsUsed".into(), extensions.keys().map(String::as_str).collect::<Value>());
        root.insert("extensions".into(), Value::Object(extensions));
        for (node, hull) in self.hulls {
            self.nodes[node]["mesh"] = json!(self.meshes.len());
            self.meshes.push(hull);
        }
        for (key, values) in [
            ("nodes", self.nodes),
            ("meshes", self.meshes),
            ("materials", self.materials),
            ("accessors", self.accessors),
            ("bufferViews", buffer_views),
            ("images", images),
            ("samplers", samplers),
            ("textures", all),
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

/// Adds numbers to a buffer view.
fn floats<const N: usize>(view: &mut Vec<u8>, vectors: impl ExactSizeIterator<Item = [f32; N]>) {
    view.reserve(4 * N * vectors.len());
    for vector in vectors {
        for number in vector {
            view.extend_from_slice(&number.to_le_bytes());
        }
    }
}

/// A corner or a normal in the frame of glTF.
fn mirror([x, y, z]: [f32; 3]) -> [f32; 3] {
    [0.0 - x, y, z]
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
    let part = shell.role.word();
    match &shell.region {
        Some(region) => json!({ "region": region, "part": part }),
        None => json!({ "part": part }),
    }
}

/// Smooth near and far, and without an end.
fn sampler() -> Value {
    const LINEAR: u32 = 9729;
    const LINEAR_MIPMAP_LINEAR: u32 = 9987;
    json!({ "magFilter": LINEAR, "minFilter": LINEAR_MIPMAP_LINEAR })
}

/// A material; `texture` is a kind, and its number in the document.
fn material(surface: &Surface, texture: Option<(Texture, usize)>) -> Value {
    let color = surface.color.map(|c| linear(c) as f32);
    let pixels = texture.map(|(texture, _)| texture.pixels());
    let factor = pixels.map_or(color, |p| p.factor(color));
    let roughness = pixels.map_or(surface.roughness, |p| textures::rough_factor(p, surface.roughness));
    let [r, g, b] = factor.map(|c| rounded(c.into()));
    let mut out = json!({
        "name": surface.name,
        "pbrMetallicRoughness": {
            "baseColorFactor": [r, g, b, rounded(surface.opacity.into())],
            "metallicFactor": rounded(surface.metallic.into()),
            "roughnessFactor": rounded(roughness.into()),
        },
    });
    if let Some((_, number)) = texture {
        let of = |picture: usize| json!({ "index": number * PICTURES.len() + picture });
        out["pbrMetallicRoughness"]["baseColorTexture"] = of(0);
        out["normalTexture"] = of(1);
        out["pbrMetallicRoughness"]["metallicRoughnessTexture"] = of(2);
    }
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
