//! An object in the scene: its own game object, and one below it for each part that moves.

use super::component::{self, class};
use super::joint;
use super::project::mesh_of;
use super::scene::{Writer, lamp};
use super::tree::{Child, GameObject, Layer, narrow};
use super::yaml::{Map, Yaml, local, map, none, vector};
use crate::Scene;
use crate::geometry::mesh::MeshGroup;
use crate::physics::{Body as Jointed, Moving, piece_name};
use crate::scene::{Body, Lamp, Object};
use nalgebra::Matrix3;
use scenelang_layout::{Aabb, Convex, Joint as Told, Motion, Obb, Vec3};

/// A hand finds a handle within a cube of this size, metres.
const GRIP: f64 = 0.06;

impl Writer<'_> {
    /// An object where it stands; files of its meshes have the name of the asset.
    pub fn object(&mut self, object: &Object, asset: &str) -> GameObject {
        let mut node = self.made(object, &key(object), asset, Some(object));
        object.name.clone_into(&mut node.name);
        node.pos = object.place.pos;
        node.axes = object.axes;
        node
    }

    /// What all objects of an asset have in common, at the origin, made from one of them.
    pub fn bare(&mut self, object: &Object, key: &str, asset: &str) -> GameObject {
        self.made(object, key, asset, None)
    }

    /// An object at the origin. Scripts speak of the named one, or of none.
    fn made(&mut self, object: &Object, key: &str, asset: &str, named: Option<&Object>) -> GameObject {
        let mut node = GameObject::new(key, "");
        node.fixed = object.body == Body::Static;
        node.place_on(if node.fixed { Layer::Opening } else { Layer::Furniture });
        let whole = Jointed::object(object);
        self.drawn(&mut node, asset, &whole.drawn);
        let joints: &[Told] = if whole.moving.is_empty() { &[] } else { &object.place.joints };
        let owner = |part: usize| joints.iter().position(|joint| joint.parts.contains(&part));
        for (i, body) in object.solid.iter().enumerate().filter(|(i, _)| owner(*i).is_none()) {
            self.collider(&mut node, (&format!("{key}/{i}"), asset, i), body);
        }
        for (index, (piece, told)) in whole.moving.iter().zip(joints).enumerate() {
            let mut child = self.piece(&node, asset, index, (piece, told, named));
            for (i, body) in object.solid.iter().enumerate().filter(|(i, _)| owner(*i) == Some(index)) {
                self.collider(&mut child, (&format!("{key}/{i}"), asset, i), body);
            }
            node.children.push(child.into());
        }
        // What belongs to a thing is moved with it.
        let own = |l: &&Lamp| l.object.is_some_and(|index| std::ptr::eq(&raw const self.scene.objects[index], object));
        for (i, (light, bulb)) in self.scene.lamps.iter().filter(own).zip(&object.lights).enumerate() {
            let mut child = lamp(light, format!("{key}/light{i}"), "light", self.editor);
            child.pos = bulb.pos;
            node.children.push(child.into());
        }
        // A joint needs a body to hang on, also where that stands still.
        if object.body != Body::Static || !whole.moving.is_empty() {
            let held = object.body != Body::Free;
            let mass = whole.inertia.filter(|_| !whole.moving.is_empty()).map_or(object.mass, |inertia| inertia.mass);
            node.add(class::RIGIDBODY, "Rigidbody", component::rigidbody(mass, held, self.editor));
        }
        let fields = told(named.map(|object| (self.scene, object)));
        node.add(class::MONO_BEHAVIOUR, "MonoBehaviour", component::script(&self.scripts.object, fields));
        node
    }

    /// What moves against an object, closed, in the frame of the object; without its colliders.
    fn piece(
        &mut self,
        owner: &GameObject,
        asset: &str,
        index: usize,
        (piece, told, named): (&Moving, &Told, Option<&Object>),
    ) -> GameObject {
        let mut node = GameObject::new(format!("{}/joint{index}", owner.key), told.name.clone());
        node.tag = "Part";
        self.drawn(&mut node, &format!("{asset}.joint{index}"), &piece.drawn);
        node.add(class::RIGIDBODY, "Rigidbody", component::rigidbody(piece.inertia.mass, false, self.editor));
        let to = owner.anchor("Rigidbody");
        match piece.joint.motion {
            Motion::Hinge => node.add(class::HINGE_JOINT, "HingeJoint", joint::hinge(&piece.joint, to)),
            Motion::Slide => node.add(class::CONFIGURABLE_JOINT, "ConfigurableJoint", joint::slide(&piece.joint, to)),
        }
        let grip = told.handle.map(|handle| {
            let mut grip = GameObject::new(format!("{}/handle", node.key), "handle");
            grip.pos = handle;
            grip.place_on(Layer::Handle);
            grip.add(class::BOX_COLLIDER, "BoxCollider", component::box_trigger(Vec3::zeros(), Vec3::repeat(GRIP)));
            grip
        });
        let motion = match told.motion {
            Motion::Hinge => 0,
            Motion::Slide => 1,
        };
        let fields = map! {
            // In a prefab it is a part of an object without a name.
            "id" => piece_name(named.map_or("", |object| &object.name), told).as_str(),
            "motion" => motion,
            "axis" => vector(narrow(piece.joint.axis)),
            "pivot" => vector(narrow(piece.joint.anchor)),
            "min" => told.limits[0] as f32,
            "max" => told.limits[1] as f32,
            "handle" => grip.as_ref().map_or_else(none, |grip| local(grip.transform())),
        };
        node.add(class::MONO_BEHAVIOUR, "MonoBehaviour", component::script(&self.scripts.joint, fields));
        node.children.extend(grip.map(Child::Node));
        node
    }

    /// Makes visible what there is to see.
    fn drawn(&mut self, node: &mut GameObject, stem: &str, groups: &[MeshGroup]) {
        if !groups.is_empty() {
            let mesh = self.mesh(&format!("Objects/{stem}"), groups);
            self.show(node, &mesh, groups);
        }
    }

    /// A box that stands straight sits on the object itself, a turned one on a child, any other body is a convex mesh.
    fn collider(&mut self, node: &mut GameObject, (key, asset, i): (&str, &str, usize), body: &Convex) {
        let Some(Obb { center, axes, half }) = body.as_box() else {
            let mut group = MeshGroup::new(0);
            group.solid(body);
            let mesh = self.mesh(&format!("Objects/{asset}.hull{i}"), &[group]);
            node.add(class::MESH_COLLIDER, "MeshCollider", component::mesh_collider(mesh_of(&mesh), true));
            return;
        };
        if (axes - Matrix3::identity()).amax() < 1e-9 {
            node.add(class::BOX_COLLIDER, "BoxCollider", component::box_collider(*center, half * 2.0));
            return;
        }
        let mut child = GameObject::new(key, format!("part{i}"));
        child.pos = *center;
        child.axes = *axes;
        child.add(class::BOX_COLLIDER, "BoxCollider", component::box_collider(Vec3::zeros(), half * 2.0));
        node.children.push(child.into());
    }
}

/// What the identities of an object are made from.
pub(super) fn key(object: &Object) -> String {
    format!("object:{}", object.name)
}

/// What the script of an object carries: what the program says of it. In a prefab: nothing.
pub(super) fn told(of: Option<(&Scene, &Object)>) -> Map {
    let text = |part: fn(&Object) -> &str| of.map_or("", |(_, object)| part(object));
    let list =
        |texts: fn(&Scene, &Object) -> Vec<Yaml>| of.map_or_else(Vec::new, |(scene, object)| texts(scene, object));
    let bounds = of.map_or(Aabb { min: Vec3::zeros(), max: Vec3::zeros() }, |(_, object)| world_bounds(object));
    map! {
        "id" => text(|object| &object.name),
        "category" => text(|object| &object.category),
        "declaration" => text(|object| &object.declaration),
        "requirements" => list(|_, object| object.requirements.iter().map(|said| Yaml::from(said.as_str())).collect()),
        "constraints" => list(|scene, object| object.rows.iter().map(|&r| Yaml::from(scene.rows[r].id.as_str())).collect()),
        "boundsMin" => vector(narrow(bounds.min)),
        "boundsMax" => vector(narrow(bounds.max)),
    }
}

/// The world-axis box of what is seen of an object, for the self test.
fn world_bounds(object: &Object) -> Aabb {
    let points = object.mesh.iter().flat_map(|g| &g.positions);
    Aabb::of(points.map(|p| object.at(Vec3::from(p.map(f64::from)))))
}
