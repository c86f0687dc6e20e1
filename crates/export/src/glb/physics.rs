//! Rigid bodies in a GLB file, by the drafts of `KHR_physics_rigid_bodies` and `KHR_implicit_shapes`: motion with mass and inertia
//! for what is loose, colliders of convex shapes, joints with limits and damping for what opens.
//!
//! A collider is a node of its own below its body. A joint holds two frames together, one below the body and one below the piece
//! that moves; their x axes lie on the axis of the joint.

use super::{Writer, triple};
use crate::geometry::frame::Frame;
use crate::geometry::mesh::MeshGroup;
use crate::physics::{Body, FRICTION, Geom, Inertia, Joint, Physics, Shape};
use nalgebra::{Matrix3, Rotation3, SymmetricEigen, UnitQuaternion, Vector3};
use scenelang_layout::{Motion, Vec3};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;

pub(super) const BODIES: &str = "KHR_physics_rigid_bodies";
pub(super) const SHAPES: &str = "KHR_implicit_shapes";

/// The resources that nodes share.
#[derive(Default)]
pub(super) struct Resources {
    shapes: Vec<Value>,
    joints: Vec<Value>,
    filters: Vec<Value>,
}

impl Resources {
    /// The extensions of the document.
    pub fn extensions(self, all: &mut Map<String, Value>) {
        let material = json!({ "staticFriction": FRICTION, "dynamicFriction": FRICTION, "restitution": 0.0 });
        let mut bodies = json!({ "physicsMaterials": [material] });
        for (key, list) in [("physicsJoints", self.joints), ("collisionFilters", self.filters)] {
            if !list.is_empty() {
                bodies[key] = Value::Array(list);
            }
        }
        all.insert(BODIES.to_owned(), bodies);
        if !self.shapes.is_empty() {
            all.insert(SHAPES.to_owned(), json!({ "shapes": self.shapes }));
        }
    }
}

/// The index of a value in a list, where it is once.
fn index_of(list: &mut Vec<Value>, value: Value) -> usize {
    list.iter().position(|known| *known == value).unwrap_or_else(|| {
        list.push(value);
        list.len() - 1
    })
}

impl Writer<'_> {
    /// Makes bodies of the nodes of a scene, by their names.
    pub(super) fn bodies(&mut self, physics: &Physics<'_>, nodes: &BTreeMap<String, usize>) {
        for (index, body) in physics.bodies.iter().enumerate() {
            let Some(&node) = nodes.get(body.name) else { continue };
            let filter = self.filter(physics, index);
            if let Some(inertia) = body.inertia.as_ref().filter(|_| body.loose) {
                self.nodes[node]["extensions"][BODIES]["motion"] = motion(inertia);
            }
            self.colliders(node, &body.geoms, filter);
            for piece in &body.moving {
                let Some(&moving) = nodes.get(&piece.name) else { continue };
                self.nodes[moving]["extensions"][BODIES]["motion"] = motion(&piece.inertia);
                self.colliders(moving, &piece.geoms, filter);
                self.joint(node, moving, &piece.name, &piece.joint);
            }
        }
    }

    /// What must not push a body away: what may share space with it, and its own pieces among each other.
    fn filter(&mut self, physics: &Physics<'_>, index: usize) -> Option<usize> {
        let through = physics.through.iter().filter(|pair| pair.contains(&index));
        let others = through.map(|&[a, b]| physics.bodies[if a == index { b } else { a }].name);
        let body: &Body<'_> = &physics.bodies[index];
        let own = (!body.moving.is_empty()).then_some(body.name);
        let mut passed: Vec<&str> = others.chain(own).collect();
        passed.sort_unstable();
        let filter = json!({ "collisionSystems": [body.name], "notCollideWithSystems": passed });
        (!passed.is_empty()).then(|| index_of(&mut self.physics.filters, filter))
    }

    /// A collider below a node for each of its shapes.
    fn colliders(&mut self, node: usize, geoms: &[Geom], filter: Option<usize>) {
        for (number, geom) in geoms.iter().enumerate() {
            let geometry = match &geom.shape {
                Shape::Box(size) => {
                    json!({ "shape": self.shape(json!({ "type": "box", "box": { "size": triple(*size) } })) })
                }
                Shape::Cylinder { radius, height } => {
                    let sizes = json!({ "radiusBottom": radius, "radiusTop": radius, "height": height });
                    json!({ "shape": self.shape(json!({ "type": "cylinder", "cylinder": sizes })) })
                }
                Shape::Hull(hull) => {
                    let mut group = MeshGroup::new(geom.surface);
                    group.solid(hull);
                    json!({ "node": self.hull(&group), "convexHull": true })
                }
            };
            let mut collider = json!({ "geometry": geometry, "physicsMaterial": 0 });
            if let Some(filter) = filter {
                collider["collisionFilter"] = json!(filter);
            }
            let name = format!("{}/collider{number}", self.nodes[node]["name"].as_str().unwrap_or_default());
            let mut child = json!({ "name": name, "extensions": { BODIES: { "collider": collider } } });
            place(&mut child, geom.pos, &geom.axes);
            self.nodes.push(child);
            self.hang(node);
        }
    }

    fn shape(&mut self, shape: Value) -> usize {
        index_of(&mut self.physics.shapes, shape)
    }

    /// A node with the mesh of a hull, which is in no scene: nobody is to see it.
    fn hull(&mut self, group: &MeshGroup) -> usize {
        let position = self.positions(group);
        let indices = self.indices(group);
        let mesh = json!({ "primitives": [{ "attributes": { "POSITION": position }, "indices": indices }] });
        self.nodes.push(json!({ "name": format!("hull{}", self.hulls.len()) }));
        // Equal meshes are looked for among those that are seen, which are not all there yet.
        self.hulls.push((self.nodes.len() - 1, mesh));
        self.nodes.len() - 1
    }

    /// Joins two nodes. How far a joint is open is how the frame of the piece stands in that of the body.
    fn joint(&mut self, body: usize, piece: usize, name: &str, joint: &Joint) {
        let axis = joint.axis_in(Frame::YUp);
        let frame = UnitQuaternion::rotation_between(&Vec3::x(), &axis)
            .unwrap_or_else(|| UnitQuaternion::from_axis_angle(&Vector3::y_axis(), std::f64::consts::PI));
        let at = |name: String| {
            json!({
                "name": name, "translation": triple(Frame::YUp.point(joint.anchor)),
                "rotation": [frame.i, frame.j, frame.k, frame.w],
            })
        };
        self.nodes.push(at(format!("{name}/moves")));
        let connected = self.hang(piece);
        let description = index_of(&mut self.physics.joints, description(joint));
        let mut fixed = at(format!("{name}/joint"));
        let says = json!({ "connectedNode": connected, "joint": description, "enableCollision": false });
        fixed["extensions"] = json!({ BODIES: { "joint": says } });
        self.nodes.push(fixed);
        self.hang(body);
    }
}

/// One free axis, with its range, and what brakes the motion along it.
fn description(joint: &Joint) -> Value {
    let none = |key: &str, axes: &[usize]| json!({ key: axes, "min": 0.0, "max": 0.0 });
    let [min, max] = joint.range;
    let (kind, limits) = match joint.motion {
        Motion::Hinge => {
            let free = json!({ "angularAxes": [0], "min": min, "max": max });
            ("angular", [none("linearAxes", &[0, 1, 2]), none("angularAxes", &[1, 2]), free])
        }
        Motion::Slide => {
            let free = json!({ "linearAxes": [0], "min": min, "max": max });
            ("linear", [none("angularAxes", &[0, 1, 2]), none("linearAxes", &[1, 2]), free])
        }
    };
    let drive = json!({ "type": kind, "mode": "force", "axis": 0, "velocityTarget": 0.0, "damping": joint.damping });
    json!({ "limits": limits, "drives": [drive] })
}

/// How a body moves: its mass, and how that is distributed.
fn motion(inertia: &Inertia) -> Value {
    let SymmetricEigen { eigenvalues, mut eigenvectors } = SymmetricEigen::new(Frame::YUp.tensor(&inertia.tensor));
    if eigenvectors.determinant() < 0.0 {
        eigenvectors.column_mut(0).neg_mut();
    }
    let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(eigenvectors));
    json!({
        "mass": inertia.mass,
        "centerOfMass": triple(Frame::YUp.point(inertia.center)),
        "inertiaDiagonal": triple(eigenvalues),
        "inertiaOrientation": [turn.i, turn.j, turn.k, turn.w],
    })
}

/// Puts a node below its body, unless it is where that is.
fn place(node: &mut Value, pos: Vec3, axes: &Matrix3<f64>) {
    if pos != Vec3::zeros() {
        node["translation"] = triple(Frame::YUp.point(pos));
    }
    if *axes != Matrix3::identity() {
        node["rotation"] = json!(Frame::YUp.quaternion(axes));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::glb::WithPhysics;
    use crate::physics::fixture::cupboard;
    use crate::{Exporter, Scene};
    use scenelang_layout::rotation::from_quaternion;

    /// The document of the cupboard's file.
    fn document(scene: &Scene) -> Value {
        let bytes = WithPhysics.files(scene).unwrap().remove(0).bytes;
        let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
        serde_json::from_slice(&bytes[20..20 + length]).unwrap()
    }

    fn numbers<const N: usize>(value: &Value) -> [f64; N] {
        std::array::from_fn(|i| value[i].as_f64().unwrap())
    }

    /// Where a node is in relation to its body, and how it is turned.
    fn frame(node: &Value) -> (Vec3, Matrix3<f64>) {
        (Vec3::from(numbers::<3>(&node["translation"])), from_quaternion(numbers(&node["rotation"])))
    }

    fn node<'d>(document: &'d Value, name: &str) -> &'d Value {
        document["nodes"].as_array().unwrap().iter().find(|node| node["name"] == name).unwrap()
    }

    #[test]
    fn a_joint_opens_its_piece_as_the_layout_says() {
        let scene = cupboard();
        let document = document(&scene);
        let place = &scene.objects[0].place;
        for told in &place.joints {
            let name = format!("cupboard/{}", told.name);
            let fixed = node(&document, &format!("{name}/joint"));
            let own = &fixed["extensions"][BODIES]["joint"];
            let moves = &document["nodes"][own["connectedNode"].as_u64().unwrap() as usize];
            assert_eq!(moves["name"], json!(format!("{name}/moves")));
            let ((at, axes), (also, same)) = (frame(fixed), frame(moves));
            assert!((at - also).norm() < 1e-12 && (axes - same).amax() < 1e-12, "closed, both frames are one");
            let joint = &document["extensions"][BODIES]["physicsJoints"][own["joint"].as_u64().unwrap() as usize];
            let free = joint["limits"].as_array().unwrap().iter().find(|l| l["max"] != json!(0.0)).unwrap();
            let max = free["max"].as_f64().unwrap();
            // A point of the piece, opened in either frame.
            let point = Vec3::new(0.2, 0.5, 0.26);
            let axis = told.axis.normalize();
            let (opened, there) = match told.motion {
                Motion::Hinge => {
                    let turn = |axis: Vec3, angle: f64| Rotation3::from_scaled_axis(axis * angle);
                    let opened = told.anchor + turn(axis, told.limits[1].to_radians()) * (point - told.anchor);
                    (opened, at + turn(axes.column(0).into(), max) * (Frame::YUp.point(point) - at))
                }
                Motion::Slide => (point + axis * told.limits[1], Frame::YUp.point(point) + axes.column(0) * max),
            };
            assert!((Frame::YUp.point(opened) - there).norm() < 1e-9, "{name}");
        }
    }

    #[test]
    fn what_is_loose_has_mass_and_what_stands_still_has_none() {
        let scene = cupboard();
        let document = document(&scene);
        let motion = |name: &str| &node(&document, name)["extensions"][BODIES]["motion"];
        let whole: f64 = ["cupboard", "cupboard/door", "cupboard/drawer"]
            .map(|name| motion(name)["mass"].as_f64().unwrap())
            .iter()
            .sum();
        assert!((whole - scene.objects[0].mass).abs() < 1e-9, "{whole} of {}", scene.objects[0].mass);
        assert!(motion("room/floor").is_null());
        for name in ["cupboard", "cupboard/door"] {
            let Value::Object(_) = motion(name) else { panic!("{name}") };
            let [a, b, c] = numbers(&motion(name)["inertiaDiagonal"]);
            assert!(a > 0.0 && a + b >= c && b + c >= a && c + a >= b, "moments of a body");
            let q = numbers::<4>(&motion(name)["inertiaOrientation"]);
            assert!((q.iter().map(|v| v * v).sum::<f64>() - 1.0).abs() < 1e-9);
        }
        let colliders = document["nodes"].as_array().unwrap().iter();
        let colliders = colliders.filter(|node| node["extensions"][BODIES]["collider"].is_object()).count();
        assert!(colliders > 3 + 4, "three parts, and the room: {colliders}");
    }
}
