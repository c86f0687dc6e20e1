//! Pieces of a body that turn or slide against the rest of it: doors, drawers, lids.

use super::{GRAVITY, Geom, Inertia};
use crate::geometry::frame::Frame;
use crate::geometry::mesh::MeshGroup;
use crate::scene::Object;
use scenelang_layout::{Convex, Joint as Told, Motion, Vec3};

/// How a piece hangs on its body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Joint {
    /// How it moves.
    pub motion: Motion,
    /// Direction of the axis in the frame of the body, of unit length.
    pub axis: Vec3,
    /// A point of the axis in the frame of the body.
    pub anchor: Vec3,
    /// The least and the greatest that it can be opened, radians or metres.
    pub range: [f64; 2],
    /// Of its speed, N·m·s per radian or N·s per metre.
    pub damping: f64,
    /// The torque (N·m) or force (N) that it takes to move at all.
    pub friction: f64,
}

/// What is let go comes to rest in about so many seconds.
const REST: f64 = 0.5;
/// Friction of a joint for the weight that hangs on it. Furniture settles by a tenth of a degree in a simulator; without
/// friction its drawers would slide out. This much holds on a slope of 3°.
const GRIP: f64 = 0.05;

impl Joint {
    /// Its axis in a frame of others. A reflection turns the sense of turning round, so the axis of a hinge points the other
    /// way, and the same range is the same opening.
    pub fn axis_in(&self, frame: Frame) -> Vec3 {
        match self.motion {
            Motion::Hinge => -frame.point(self.axis),
            Motion::Slide => frame.point(self.axis),
        }
    }
}

/// A piece that moves. All of it is in the frame of the body, closed.
pub(crate) struct Moving {
    /// As [`piece_name`] says.
    pub name: String,
    /// How it hangs on the body.
    pub joint: Joint,
    /// Its solid.
    pub geoms: Vec<Geom>,
    /// What is seen of it.
    pub drawn: Vec<MeshGroup>,
    /// Its mass.
    pub inertia: Inertia,
}

/// What a piece of an object is called: `cabinet/door`.
pub(crate) fn piece_name(object: &str, joint: &Told) -> String {
    format!("{object}/{}", joint.name)
}

/// An object in pieces.
pub(super) struct Pieces {
    /// The parts that do not move, by index.
    pub fixed: Vec<usize>,
    /// What is seen of them.
    pub drawn: Vec<MeshGroup>,
    /// What moves.
    pub moving: Vec<Moving>,
}

/// Takes an object apart by the joints of its layout; `geoms` are those of its parts. `None` where nothing moves, or nothing stays that it could hang on.
pub(super) fn take_apart(object: &Object, geoms: &[Geom]) -> Option<Pieces> {
    // Parts that do not fill the box have no say.
    let told: &[Told] = if object.place.parts.len() == geoms.len() { &object.place.joints } else { &[] };
    let owner = |part: usize| told.iter().position(|m| m.parts.contains(&part));
    let of = |index: Option<usize>| (0..geoms.len()).filter(|&p| owner(p) == index).collect::<Vec<usize>>();
    let piece = |(index, told): (usize, &Told)| {
        let parts = of(Some(index));
        if parts.is_empty() || told.axis.norm() < 1e-9 {
            return None;
        }
        let inertia = inertia(object, &parts);
        Some(Moving {
            name: piece_name(&object.name, told),
            joint: joint(told, &inertia),
            geoms: parts.iter().map(|&p| geoms[p].clone()).collect(),
            drawn: seen(object, |part| part.and_then(owner) == Some(index)),
            inertia,
        })
    };
    let moving: Vec<Moving> = told.iter().enumerate().filter_map(piece).collect();
    let fixed = of(None);
    let apart = moving.len() == told.len() && !moving.is_empty() && !fixed.is_empty();
    apart.then(|| Pieces { fixed, drawn: seen(object, |part| part.and_then(owner).is_none()), moving })
}

/// Mass of some parts of an object.
pub(super) fn inertia(object: &Object, parts: &[usize]) -> Inertia {
    Inertia::of(parts.iter().map(|&p| (&object.solid[p], object.weights[p])))
}

fn joint(told: &Told, inertia: &Inertia) -> Joint {
    let axis = told.axis.normalize();
    let (range, load, arm) = match told.motion {
        Motion::Slide => (told.limits, inertia.mass, 1.0),
        Motion::Hinge => {
            let arm = axis.cross(&(inertia.center - told.anchor)).norm();
            let about = axis.dot(&(inertia.tensor * axis)) + inertia.mass * arm * arm;
            (told.limits.map(f64::to_radians), about, arm)
        }
    };
    let friction = GRIP * GRAVITY * inertia.mass * arm;
    Joint { motion: told.motion, axis, anchor: told.anchor, range, damping: load / REST, friction }
}

/// A triangle belongs to a part whose box it is no farther out of than this, metres.
const NEAR: f64 = 0.002;

/// The triangles that belong to certain parts; those of no part are asked for as `None`. Where several parts are about a
/// triangle it belongs to the smallest: a door lies within the box of its cupboard.
fn seen(object: &Object, wanted: impl Fn(Option<usize>) -> bool) -> Vec<MeshGroup> {
    let volume = |c: &Convex| (c.aabb().max - c.aabb().min).product();
    let part_of = |t: [[f32; 3]; 3]| {
        let corners = t.map(|p| Vec3::from(p.map(f64::from)));
        let about = |c: &Convex| {
            let (min, max) = (c.aabb().min, c.aabb().max);
            corners.iter().all(|p| (0..3).all(|i| (min[i] - NEAR..=max[i] + NEAR).contains(&p[i])))
        };
        let near = object.solid.iter().enumerate().filter(|(_, c)| about(c));
        near.min_by(|a, b| f64::total_cmp(&volume(a.1), &volume(b.1))).map(|(index, _)| index)
    };
    let of = |group: &MeshGroup| {
        let mut out = MeshGroup::new(group.surface);
        for (indices, corners) in group.indices.chunks_exact(3).zip(group.triangles()) {
            if wanted(part_of(corners)) {
                let first = out.positions.len() as u32;
                out.positions.extend(corners);
                out.normals.extend(indices.iter().map(|&i| group.normals[i as usize]));
                out.uvs.extend(indices.iter().map(|&i| group.uvs[i as usize]));
                out.indices.extend([first, first + 1, first + 2]);
            }
        }
        out
    };
    object.mesh.iter().map(of).filter(|group| !group.indices.is_empty()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::fixture::cupboard;
    use crate::physics::{Body, Physics};

    #[test]
    fn what_moves_is_taken_out_of_the_body_and_nothing_is_lost() {
        let scene = cupboard();
        let mut closed = cupboard();
        closed.objects[0].place.joints.clear();
        let whole = Body::object(&closed.objects[0]);
        let physics = Physics::of(&scene);
        let body = &physics.bodies[0];
        assert_eq!((whole.geoms.len(), body.geoms.len(), body.moving.len()), (3, 1, 2));
        let door = &body.moving[0];
        assert_eq!((door.name.as_str(), &door.geoms[..]), ("cupboard/door", &whole.geoms[1..2]));
        let mass = |b: &Body<'_>| b.inertia.unwrap().mass;
        let sum = mass(body) + body.moving.iter().map(|m| m.inertia.mass).sum::<f64>();
        assert!((mass(&whole) - sum).abs() < 1e-9);
        let triangles = |groups: &[MeshGroup]| groups.iter().map(|g| g.indices.len() / 3).sum::<usize>();
        let seen = body.moving.iter().map(|m| triangles(&m.drawn)).collect::<Vec<_>>();
        assert_eq!(seen, [12, 12]);
        assert_eq!(triangles(&body.drawn), triangles(&whole.drawn) - 24);
    }

    #[test]
    fn limits_are_in_radians_and_metres_and_resistance_fits_what_moves() {
        let scene = cupboard();
        let physics = Physics::of(&scene);
        let [door, drawer] = &physics.bodies[0].moving[..] else { panic!("a door and a drawer") };
        assert_eq!(door.joint.range, [0.0, 110_f64.to_radians()]);
        assert_eq!(drawer.joint.range, [0.0, 0.3]);
        assert_eq!(drawer.joint.damping, drawer.inertia.mass / REST);
        // A board of width w about its edge has m·w²/3, and here the edge is 1 cm behind its middle.
        let about = door.inertia.mass * (0.78_f64.powi(2) / 3.0 + 0.02_f64.powi(2) / 12.0 + 0.01_f64.powi(2));
        assert!((door.joint.damping - about / REST).abs() < 1e-6);
        // 3° of slope do not move either of them: the weight of the door acts at its middle, half a width from the edge.
        let slope = GRAVITY * 2.8_f64.to_radians().sin();
        assert!(drawer.joint.friction > slope * drawer.inertia.mass);
        assert!(door.joint.friction > slope * door.inertia.mass * 0.39);
        assert!(door.joint.friction < 0.1 * GRAVITY * door.inertia.mass * 0.4, "a robot can open it");
    }

    #[test]
    fn an_opening_is_the_same_in_every_frame() {
        use nalgebra::{Rotation3, Unit};
        let joint = Joint {
            motion: Motion::Hinge,
            axis: Vec3::new(0.0, 0.8, 0.6),
            anchor: Vec3::zeros(),
            range: [0.0, 1.0],
            damping: 0.0,
            friction: 0.0,
        };
        let point = Vec3::new(0.3, 0.2, -0.5);
        let turned = |axis: Vec3, p: Vec3| Rotation3::from_axis_angle(&Unit::new_normalize(axis), 0.7) * p;
        for frame in [Frame::YUp, Frame::ZUp] {
            let there = frame.point(turned(joint.axis, point));
            assert!((turned(joint.axis_in(frame), frame.point(point)) - there).norm() < 1e-12);
        }
    }

    #[test]
    fn what_cannot_be_taken_apart_stays_whole() {
        let mut scene = cupboard();
        let [door, drawer] = <[Told; 2]>::try_from(std::mem::take(&mut scene.objects[0].place.joints)).unwrap();
        let all = Told { parts: vec![0, 1, 2], ..door.clone() };
        let none = Told { parts: Vec::new(), ..door.clone() };
        let beyond = Told { parts: vec![7], ..door };
        let nowhere = Told { axis: Vec3::zeros(), ..drawer };
        for told in [all, none, beyond, nowhere] {
            scene.objects[0].place.joints = vec![told];
            let body = Body::object(&scene.objects[0]);
            assert_eq!((body.geoms.len(), body.moving.len()), (3, 0));
        }
    }
}
