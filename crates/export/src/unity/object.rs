//! An object in the scene: its own game object, and one below it for each part that moves.

use super::component::{self, class};
use super::ids::anchor;
use super::joint;
use super::project::mesh_of;
use super::scene::{Writer, lamp};
use super::tree::{Layer, Node, narrow};
use super::yaml::{Yaml, local, map, none, vector};
use crate::geometry::mesh::Group;
use crate::physics::{Body as Jointed, Moving};
use crate::scene::{Body, Lamp, Object};
use nalgebra::Matrix3;
use scenelang_layout::{Aabb, Convex, Joint as Told, Motion, Obb, Vec3};

/// A hand finds a handle within a cube of this size, metres.
const GRIP: f64 = 0.06;

impl Writer<'_> {
    pub fn object(&mut self, object: &Object) -> Node {
        let mut node = Node::new(key(object), object.name.clone());
        node.pos = object.place.pos;
        node.axes = object.axes;
        node.fixed = object.body == Body::Static;
        node.place_on(if node.fixed { Layer::Opening } else { Layer::Furniture });
        let whole = Jointed::object(object);
        self.drawn(&mut node, &object.stem, &whole.drawn);
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
            let mut child = lamp(light, self.editor);
            child.pos = object.axes.transpose() * (light.pos - object.place.pos);
            node.children.push(child);
        }
        // A joint needs a body to hang on, also where that stands still.
        if object.body != Body::Static || !whole.moving.is_empty() {
            let held = object.body != Body::Free;
            let mass = whole.inertia.filter(|_| !whole.moving.is_empty()).map_or(object.mass, |inertia| inertia.mass);
            node.add(class::RIGIDBODY, "Rigidbody", component::rigidbody(mass, held, self.editor));
        }
        self.told(&mut node, object);
        node
    }

    /// The script that carries what the program says of it.
    fn told(&self, node: &mut Node, object: &Object) {
        let ids = object.rows.iter().map(|&r| Yaml::from(self.scene.rows[r].id.as_str())).collect::<Vec<_>>();
        let bounds = world_bounds(object);
        let fields = map! {
            "id" => object.name.as_str(),
            "category" => object.category.as_str(),
            "declaration" => object.declaration.as_str(),
            "requirements" => object.requirements.iter().map(|said| Yaml::from(said.as_str())).collect::<Vec<_>>(),
            "constraints" => ids,
            "boundsMin" => vector(narrow(bounds.min)),
            "boundsMax" => vector(narrow(bounds.max)),
        };
        node.add(class::MONO_BEHAVIOUR, "MonoBehaviour", component::script(&self.scripts.object, fields));
    }

    /// What moves against an object, closed, in the frame of the object; without its colliders.
    fn piece(&mut self, object: &Object, index: usize, piece: &Moving, told: &Told) -> Node {
        let mut node = Node::new(format!("{}/joint{index}", key(object)), told.name.clone());
        node.tag = "Part";
        self.drawn(&mut node, &format!("{}.joint{index}", object.stem), &piece.drawn);
        node.add(class::RIGIDBODY, "Rigidbody", component::rigidbody(piece.inertia.mass, false, self.editor));
        let to = anchor(&key(object), "Rigidbody");
        match piece.joint.motion {
            Motion::Hinge => node.add(class::HINGE_JOINT, "HingeJoint", joint::hinge(&piece.joint, to)),
            Motion::Slide => node.add(class::CONFIGURABLE_JOINT, "ConfigurableJoint", joint::slide(&piece.joint, to)),
        }
        let grip = told.handle.map(|handle| {
            let mut grip = Node::new(format!("{}/joint{index}/handle", key(object)), "handle");
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
            "id" => piece.name.as_str(),
            "motion" => motion,
            "axis" => vector(narrow(piece.joint.axis)),
            "pivot" => vector(narrow(piece.joint.anchor)),
            "min" => told.limits[0] as f32,
            "max" => told.limits[1] as f32,
            "handle" => grip.as_ref().map_or_else(none, |grip| local(grip.transform())),
        };
        node.add(class::MONO_BEHAVIOUR, "MonoBehaviour", component::script(&self.scripts.joint, fields));
        node.children.extend(grip);
        node
    }

    /// Makes visible what there is to see.
    fn drawn(&mut self, node: &mut Node, stem: &str, groups: &[Group]) {
        if !groups.is_empty() {
            let mesh = self.mesh(&format!("Objects/{stem}"), groups);
            self.show(node, &mesh, groups);
        }
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
        let mut child = Node::new(format!("{}/{i}", key(object)), format!("part{i}"));
        child.pos = *center;
        child.axes = *axes;
        child.add(class::BOX_COLLIDER, "BoxCollider", component::box_collider(Vec3::zeros(), half * 2.0));
        node.children.push(child);
    }
}

/// What the identities of an object are made from.
fn key(object: &Object) -> String {
    format!("object:{}", object.name)
}

/// The world-axis box of what is seen of an object, for the self test.
fn world_bounds(object: &Object) -> Aabb {
    let points = object.mesh.iter().flat_map(|g| &g.positions);
    Aabb::of(points.map(|p| object.at(Vec3::from(p.map(f64::from)))))
}
