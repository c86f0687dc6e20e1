//! The scene file: a root that carries program, layout and report; below it the building and the objects; sun, lamps
//! and a camera beside it. What an object becomes is in [`super::object`], and which are instances of prefabs in [`super::prefab`].

use super::component::{self, Shine, class};
use super::editor::Editor;
use super::project::{Project, mesh_of};
use super::tree::{Child, GameObject, Layer, scene_file};
use super::yaml::{Yaml, asset, map};
use super::{Material, mesh_obj};
use crate::Scene;
use crate::geometry::mesh::MeshGroup;
use crate::names::Stems;
use crate::scene::{Lamp, ReportRow, Role, Shell, View, view};
use nalgebra::{Matrix3, UnitQuaternion};
use scenelang_layout::{Vec3, rotation};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

/// GUIDs of the text assets.
pub(super) struct Texts {
    pub spec: String,
    pub layout: String,
    pub report: String,
    pub rows: String,
}

/// GUIDs of the scripts.
pub(super) struct Scripts {
    pub scene: String,
    pub object: String,
    pub joint: String,
    pub nav_mesh: String,
}

/// Writes the scene, and the meshes it needs into the project.
pub(super) struct Writer<'a> {
    pub scene: &'a Scene,
    pub project: &'a mut Project,
    pub materials: &'a [Material],
    pub scripts: &'a Scripts,
    pub editor: Editor,
    /// Stems of mesh files of the building; those of objects have their own folder.
    pub stems: Stems,
}

impl Writer<'_> {
    /// The `.unity` file.
    pub fn write(&mut self, texts: &Texts) -> Vec<u8> {
        let mut root = GameObject::new("scene", self.scene.name.clone());
        root.add(
            class::MONO_BEHAVIOUR,
            "MonoBehaviour",
            component::script(
                &self.scripts.scene,
                map! {
                    "spec" => asset(4_900_000, &texts.spec, 3),
                    "layout" => asset(4_900_000, &texts.layout, 3),
                    "report" => asset(4_900_000, &texts.report, 3),
                    "layoutSha256" => Yaml::Word(sha256(&self.scene.layout_text)),
                    "version" => Yaml::Word(env!("CARGO_PKG_VERSION").into()),
                    "rows" => asset(4_900_000, &texts.rows, 3),
                },
            ),
        );
        // The corridor that the navigation mesh is baked for is that of the settings below.
        let walker = map! { "radius" => component::RADIUS, "height" => component::HEIGHT, "step" => component::STEP };
        root.add(class::MONO_BEHAVIOUR, "MonoBehaviour", component::script(&self.scripts.nav_mesh, walker));
        let mut building = GameObject::new("building", "Building");
        building.fixed = true;
        building.children = self.scene.shells.iter().filter_map(|s| self.shell(s)).map(Child::Node).collect();
        let mut furniture = GameObject::new("objects", "Objects");
        furniture.children = self.objects();
        root.children = vec![building.into(), furniture.into()];
        let mut roots = vec![root, sun(self.editor), camera(self.scene)];
        let hung = self.scene.lamps.iter().filter(|lamp| lamp.object.is_none());
        roots.extend(hung.map(|light| lamp(light, format!("light:{}", light.name), &light.name, self.editor)));
        scene_file(|stream| component::settings(stream, self.editor), &roots)
    }

    fn shell(&mut self, shell: &Shell) -> Option<GameObject> {
        if shell.group.indices.is_empty() {
            return None;
        }
        let stem = self.stems.take(&shell.name);
        let mesh = self.mesh(&format!("Building/{stem}"), std::slice::from_ref(&shell.group));
        let mut node = GameObject::new(format!("shell:{}", shell.name), shell.name.replace('/', " "));
        node.fixed = true;
        match shell.role {
            Role::Floor => node.place_on(Layer::Floor),
            Role::Ceiling => node.place_on(Layer::Ceiling),
            Role::Wall { .. } => node.place_on(Layer::Wall),
            Role::Tint | Role::Skirting { .. } => {}
        }
        self.show(&mut node, &mesh, std::slice::from_ref(&shell.group));
        match shell.role {
            // What stands on a floor that is a triangle mesh stands on it exactly, whatever the floor's shape.
            Role::Floor | Role::Ceiling => {
                node.add(class::MESH_COLLIDER, "MeshCollider", component::mesh_collider(mesh_of(&mesh), false));
            }
            Role::Wall { .. } => {
                for (i, slab) in shell.boxes.iter().enumerate() {
                    let mut child = GameObject::new(format!("shell:{}/{i}", shell.name), format!("piece{i}"));
                    child.fixed = true;
                    child.pos = slab.center;
                    child.axes = rotation::matrix(Vec3::new(0.0, slab.yaw, 0.0));
                    child.add(class::BOX_COLLIDER, "BoxCollider", component::box_collider(Vec3::zeros(), slab.size));
                    node.children.push(child.into());
                }
            }
            Role::Tint | Role::Skirting { .. } => {}
        }
        Some(node)
    }

    /// Adds an OBJ file; returns its GUID.
    pub fn mesh(&mut self, path: &str, groups: &[MeshGroup]) -> String {
        let text = mesh_obj::obj(groups, |surface| self.materials[surface].name.clone());
        self.project.asset(&format!("Assets/Scenelang/Meshes/{path}.obj"), text)
    }

    /// Makes a mesh visible, a material for each of its groups.
    pub fn show(&self, node: &mut GameObject, mesh: &str, groups: &[MeshGroup]) {
        let materials = groups.iter().map(|g| asset(2_100_000, &self.materials[g.surface].guid, 2)).collect();
        node.add(class::MESH_FILTER, "MeshFilter", component::mesh_filter(mesh_of(mesh)));
        node.add(class::MESH_RENDERER, "MeshRenderer", component::mesh_renderer(materials));
    }
}

fn sun(editor: Editor) -> GameObject {
    let mut node = GameObject::new("light:sun", "Sun");
    // Lights in Unity shine along +z.
    node.axes = UnitQuaternion::rotation_between(&Vec3::z(), &view::SUN)
        .map_or_else(Matrix3::identity, |q| *q.to_rotation_matrix().matrix());
    node.pos = Vec3::new(0.0, 5.0, 0.0);
    node.add(class::LIGHT, "Light", component::light(&Shine::Sun, editor));
    node
}

pub(super) fn lamp(lamp: &Lamp, key: String, name: &str, editor: Editor) -> GameObject {
    let mut node = GameObject::new(key, name);
    node.pos = lamp.pos;
    node.add(class::LIGHT, "Light", component::light(&Shine::Lamp(lamp), editor));
    node
}

fn camera(scene: &Scene) -> GameObject {
    let view = View::within(scene);
    let mut node = GameObject::new("camera", "Main Camera");
    node.pos = view.eye;
    node.axes = view.axes();
    node.tag = "MainCamera";
    node.add(class::CAMERA, "Camera", component::camera(view.fov));
    node.add(class::AUDIO_LISTENER, "AudioListener", map! { "m_Enabled" => 1 });
    node
}

fn sha256(text: &str) -> String {
    use std::fmt::Write;
    Sha256::digest(text).iter().fold(String::with_capacity(64), |mut out, byte| {
        let _ = write!(out, "{byte:02x}");
        out
    })
}

/// The rows of the report, and which objects may overlap, as the scripts read them: Unity's reader of JSON fills in classes, and knows no null.
pub(super) fn rows(scene: &Scene) -> String {
    let told = scene.report["constraints"].as_array().map(Vec::as_slice).unwrap_or_default();
    let row = |(row, told): (&ReportRow, &Value)| {
        let text = |key: &str| told[key].as_str().unwrap_or_default();
        let texts =
            |key: &str| -> Vec<&str> { told[key].as_array().into_iter().flatten().filter_map(Value::as_str).collect() };
        json!({
            "id": row.id,
            "kind": row.kind,
            "text": text("text"),
            "message": text("message"),
            "verdict": row.satisfied.map_or(0, |holds| if holds { 1 } else { 2 }),
            "margin": told["margin"].as_f64().unwrap_or_default(),
            "unit": text("unit"),
            "requirements": texts("requirements"),
            "objects": texts("objects"),
        })
    };
    let rows: Vec<Value> = scene.rows.iter().zip(told).map(row).collect();
    // Bodies that may share space must not push each other apart.
    let name = |index: usize| scene.objects[index].name.as_str();
    let pairs: Vec<Value> = scene.overlaps.iter().map(|&[a, b]| json!({ "a": name(a), "b": name(b) })).collect();
    format!("{:#}\n", json!({ "constraints": rows, "overlaps": pairs }))
}
