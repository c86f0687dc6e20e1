//! The scene file: a root that carries program, layout and report; below it the building and the objects; sun, lamps
//! and a camera beside it.

use super::component::{self, Shine, class};
use super::ids::anchor;
use super::project::{Project, mesh_of};
use super::tree::{Node, narrow, scene_file};
use super::yaml::{Yaml, asset, map, vector};
use super::{Material, joint, mesh_obj};
use crate::Scene;
use crate::geometry::mesh::Group;
use crate::names::Stems;
use crate::physics::{Body as Jointed, Moving};
use crate::scene::{Body, Lamp, Object, Role, Shell, View, view};
use nalgebra::{Matrix3, UnitQuaternion};
use scenelang_layout::{Aabb, Convex, Joint as Told, Motion, Obb, Vec3, rotation};
use sha2::{Digest, Sha256};

/// GUIDs of the text assets.
pub(super) struct Texts {
    pub spec: String,
    pub layout: String,
    pub report: String,
}

/// GUIDs of the scripts.
pub(super) struct Scripts {
    pub scene: String,
    pub object: String,
}

/// Writes the scene, and the meshes it needs into the project.
pub(super) struct Writer<'a> {
    pub scene: &'a Scene,
    pub project: &'a mut Project,
    pub materials: &'a [Material],
    /// Stems of mesh files of the building; those of objects have their own folder.
    pub stems: Stems,
}

impl Writer<'_> {
    /// The `.unity` file.
    pub fn write(&mut self, texts: &Texts, scripts: &Scripts) -> Vec<u8> {
        let mut root = Node::new("scene", self.scene.name.clone());
        root.add(
            class::MONO_BEHAVIOUR,
            "MonoBehaviour",
            component::script(
                &scripts.scene,
                map! {
                    "spec" => asset(4_900_000, &texts.spec, 3),
                    "layout" => asset(4_900_000, &texts.layout, 3),
                    "report" => asset(4_900_000, &texts.report, 3),
                    "layoutSha256" => Yaml::Word(sha256(&self.scene.layout_text)),
                    "version" => Yaml::Word(env!("CARGO_PKG_VERSION").into()),
                },
            ),
        );
        let mut building = Node::new("building", "Building");
        building.fixed = true;
        building.children = self.scene.shells.iter().filter_map(|s| self.shell(s)).collect();
        let mut furniture = Node::new("objects", "Objects");
        furniture.children = self.scene.objects.iter().map(|o| self.object(o, &scripts.object)).collect();
        root.children = vec![building, furniture];
        let mut roots = vec![root, sun(), camera(self.scene)];
        roots.extend(self.scene.lamps.iter().filter(|lamp| lamp.object.is_none()).map(lamp));
        scene_file(component::settings, &roots)
    }

    fn shell(&mut self, shell: &Shell) -> Option<Node> {
        if shell.group.indices.is_empty() {
            return None;
        }
        let stem = self.stems.take(&shell.name);
        let mesh = self.mesh(&format!("Building/{stem}"), std::slice::from_ref(&shell.group));
        let mut node = Node::new(format!("shell:{}", shell.name), shell.name.replace('/', " "));
        node.fixed = true;
        self.show(&mut node, &mesh, std::slice::from_ref(&shell.group));
        match shell.role {
            // What stands on a floor that is a triangle mesh stands on it exactly, whatever the floor's shape.
            Role::Floor | Role::Ceiling => {
                node.add(class::MESH_COLLIDER, "MeshCollider", component::mesh_collider(mesh_of(&mesh), false));
            }
            Role::Wall { .. } => {
                for (i, slab) in shell.boxes.iter().enumerate() {
                    let mut child = Node::new(format!("shell:{}/{i}", shell.name), format!("piece{i}"));
                    child.fixed = true;
                    child.pos = slab.center;
                    child.axes = rotation::matrix(Vec3::new(0.0, slab.yaw, 0.0));
                    child.add(class::BOX_COLLIDER, "BoxCollider", component::box_collider(Vec3::zeros(), slab.size));
                    node.children.push(child);
                }
            }
            Role::Tint => {}
        }
        Some(node)
    }

    fn object(&mut self, object: &Object, script: &str) -> Node {
        let mut node = Node::new(format!("object:{}", object.name), object.name.clone());
        node.pos = object.place.pos;
        node.axes = object.axes;
        node.fixed = object.body == Body::Static;
        let whole = Jointed::object(object);
        let mesh = self.mesh(&format!("Objects/{}", object.stem), &whole.drawn);
        self.show(&mut node, &mesh, &whole.drawn);
        let joints: &[Told] = if whole.moving.is_empty() { &[] } else { &object.place.joints };
        let owner = |part: usize| joints.iter().position(|joint| joint.parts.contains(&part));
        for (i, body) in object.solid.iter().enumerate().filter(|(i, _)| owner(*i).is_none()) {
            self.collider(&mut node, object, i, body);
        }
        for (index, (piece, told)) in whole.moving.iter().zip(joints).enumerate() {
            let mut child = self.piece(object, index, piece, told);
            for (i, body) in object.solid.iter().enumerate().filter(|(i, _)| owner(*i) == Some(index)) {
                self.collider(&mut child, object, i, body);
            }
            node.children.push(child);
        }
        // What belongs to a thing is moved with it.
        let own = |l: &&Lamp| l.object.is_some_and(|index| std::ptr::eq(&raw const self.scene.objects[index], object));
        for light in self.scene.lamps.iter().filter(own) {
            let mut child = lamp(light);
            child.pos = object.axes.transpose() * (light.pos - object.place.pos);
            node.children.push(child);
        }
        // A joint needs a body to hang on, also where that stands still.
        if object.body != Body::Static || !whole.moving.is_empty() {
            let held = object.body != Body::Free;
            let mass = whole.inertia.filter(|_| !whole.moving.is_empty()).map_or(object.mass, |inertia| inertia.mass);
            node.add(class::RIGIDBODY, "Rigidbody", component::rigidbody(mass, held));
        }
        let ids = object.rows.iter().map(|&r| Yaml::from(self.scene.rows[r].id.as_str())).collect::<Vec<_>>();
        let bounds = world_bounds(object);
        node.add(
            class::MONO_BEHAVIOUR,
            "MonoBehaviour",
            component::script(
                script,
                map! {
                    "id" => object.name.as_str(),
                    "category" => object.category.as_str(),
                    "declaration" => object.declaration.as_str(),
                    "constraints" => ids,
                    "boundsMin" => vector(narrow(bounds.min)),
                    "boundsMax" => vector(narrow(bounds.max)),
                },
            ),
        );
        node
    }

    /// What moves against an object, closed, in the frame of the object; without its colliders.
    fn piece(&mut self, object: &Object, index: usize, piece: &Moving, told: &Told) -> Node {
        let mut node = Node::new(format!("object:{}/joint{index}", object.name), told.name.clone());
        let mesh = self.mesh(&format!("Objects/{}.joint{index}", object.stem), &piece.drawn);
        self.show(&mut node, &mesh, &piece.drawn);
        node.add(class::RIGIDBODY, "Rigidbody", component::rigidbody(piece.inertia.mass, false));
        let to = anchor(&format!("object:{}", object.name), "Rigidbody");
        match piece.joint.motion {
            Motion::Hinge => node.add(class::HINGE_JOINT, "HingeJoint", joint::hinge(&piece.joint, to)),
            Motion::Slide => node.add(class::CONFIGURABLE_JOINT, "ConfigurableJoint", joint::slide(&piece.joint, to)),
        }
        if let Some(handle) = told.handle {
            let mut grip = Node::new(format!("object:{}/joint{index}/handle", object.name), "handle");
            grip.pos = handle;
            grip.add(class::BOX_COLLIDER, "BoxCollider", component::box_trigger(Vec3::zeros(), Vec3::repeat(GRIP)));
            node.children.push(grip);
        }
        node
    }

    /// A box that stands straight sits on the object itself, a turned one on a child, any other body is a convex mesh.
    fn collider(&mut self, node: &mut Node, object: &Object, i: usize, body: &Convex) {
        let Some(Obb { center, axes, half }) = body.as_box() else {
            let mut group = Group::new(0);
            group.solid(body);
            let mesh = self.mesh(&format!("Objects/{}.hull{i}", object.stem), &[group]);
            node.add(class::MESH_COLLIDER, "MeshCollider", component::mesh_collider(mesh_of(&mesh), true));
            return;
        };
        if (axes - Matrix3::identity()).amax() < 1e-9 {
            node.add(class::BOX_COLLIDER, "BoxCollider", component::box_collider(*center, half * 2.0));
            return;
        }
        let mut child = Node::new(format!("object:{}/{i}", object.name), format!("part{i}"));
        child.pos = *center;
        child.axes = *axes;
        child.add(class::BOX_COLLIDER, "BoxCollider", component::box_collider(Vec3::zeros(), half * 2.0));
        node.children.push(child);
    }

    /// Adds an OBJ file; returns its GUID.
    fn mesh(&mut self, path: &str, groups: &[Group]) -> String {
        let text = mesh_obj::obj(groups, |surface| self.materials[surface].name.clone());
        self.project.asset(&format!("Assets/Scenelang/Meshes/{path}.obj"), text)
    }

    /// Makes a mesh visible, a material for each of its groups.
    fn show(&self, node: &mut Node, mesh: &str, groups: &[Group]) {
        let materials = groups.iter().map(|g| asset(2_100_000, &self.materials[g.surface].guid, 2)).collect();
        node.add(class::MESH_FILTER, "MeshFilter", component::mesh_filter(mesh_of(mesh)));
        node.add(class::MESH_RENDERER, "MeshRenderer", component::mesh_renderer(materials));
    }
}

/// A hand finds a handle within a cube of this size, metres.
const GRIP: f64 = 0.06;

fn sun() -> Node {
    let mut node = Node::new("light:sun", "Sun");
    // Lights in Unity shine along +z.
    node.axes = UnitQuaternion::rotation_between(&Vec3::z(), &view::SUN)
        .map_or_else(Matrix3::identity, |q| *q.to_rotation_matrix().matrix());
    node.pos = Vec3::new(0.0, 5.0, 0.0);
    node.add(class::LIGHT, "Light", component::light(&Shine::Sun));
    node
}

fn lamp(lamp: &Lamp) -> Node {
    let mut node = Node::new(format!("light:{}", lamp.name), lamp.name.clone());
    node.pos = lamp.pos;
    node.add(class::LIGHT, "Light", component::light(&Shine::Lamp(lamp)));
    node
}

fn camera(scene: &Scene) -> Node {
    let view = View::within(scene);
    let mut node = Node::new("camera", "Main Camera");
    node.pos = view.eye;
    node.axes = view.axes();
    node.tag = "MainCamera";
    node.add(class::CAMERA, "Camera", component::camera(view.fov));
    node.add(class::AUDIO_LISTENER, "AudioListener", map! { "m_Enabled" => 1 });
    node
}

/// The world-axis box of what is seen of an object, for the self test.
fn world_bounds(object: &Object) -> Aabb {
    let points = object.mesh.iter().flat_map(|g| &g.positions);
    Aabb::of(points.map(|p| object.at(Vec3::from(p.map(f64::from)))))
}

fn sha256(text: &str) -> String {
    use std::fmt::Write;
    Sha256::digest(text).iter().fold(String::with_capacity(64), |mut out, byte| {
        let _ = write!(out, "{byte:02x}");
        out
    })
}
