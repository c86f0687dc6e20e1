//! A scene as a physics engine sees it: bodies that stand still or are loose, made of convex shapes, with mass and inertia.
//! MJCF, USD and SDF are written from it.
//!
//! Frame: the scene's own (left-handed, y up, metres); who writes converts with a [`Frame`](crate::geometry::frame::Frame).
//!
//! A body is rigid but for the pieces of it that move: see [`Moving`].

#[cfg(test)]
pub(crate) mod fixture;
mod inertia;
mod joint;
mod shape;

pub(crate) use inertia::Inertia;
pub(crate) use joint::{Joint, Moving, piece_name};
pub(crate) use shape::{Geom, Shape};

use crate::Scene;
use crate::geometry::mesh::MeshGroup;
use crate::scene::{Body as Holding, Object, Role, Shell};
use nalgebra::Matrix3;
use scenelang_lang::roles::role_of;
use scenelang_layout::Vec3;
use std::borrow::Cow;

/// How well things grip, by the law of Coulomb; one for all.
pub(crate) const FRICTION: f64 = 0.8;
/// Metres per second squared.
pub(crate) const GRAVITY: f64 = 9.81;

/// All bodies of a scene.
pub(crate) struct Physics<'a> {
    /// The objects in order of declaration, then the shells that stop something.
    pub bodies: Vec<Body<'a>>,
    /// Bodies, by index, that do not push each other: at least one of them loose where they share space by permission of the
    /// program; and curtains, or a rug below a door, which give way to what opens.
    pub through: Vec<[usize; 2]>,
}

/// A rigid body, and what moves against it.
pub(crate) struct Body<'a> {
    /// As in the program: `chair[0]`; of the building `office/wall2`.
    pub name: &'a str,
    pub what: BodyKind<'a>,
    /// Where its frame is.
    pub pos: Vec3,
    /// How its frame is turned.
    pub axes: Matrix3<f64>,
    /// Whether it falls if nothing carries it; else it stands still whatever happens.
    pub loose: bool,
    /// Its solid; empty where it stops nothing.
    pub geoms: Vec<Geom>,
    /// What is seen of it, in its frame.
    pub drawn: Cow<'a, [MeshGroup]>,
    /// Mass and how it is distributed; nobody needs to know what the building weighs.
    pub inertia: Option<Inertia>,
    /// What is no part of it and hangs on it.
    pub moving: Vec<Moving>,
}

/// What a body is in the scene.
#[derive(Clone, Copy)]
pub(crate) enum BodyKind<'a> {
    /// An object of the program.
    Object(&'a Object),
    /// A piece of the building.
    Shell(&'a Shell),
}

/// What is seen of an object's body, and of what each of its joints moves; `None` where it is in one piece.
pub(crate) fn drawn_apart(object: &Object) -> Option<Apart> {
    let pieces = joint::take_apart(object, &shape::of_object(object))?;
    Some((pieces.drawn, pieces.moving.into_iter().map(|moving| moving.drawn).collect()))
}

/// Triangles of a body, and of what each joint moves, in the object's frame.
pub(crate) type Apart = (Vec<MeshGroup>, Vec<Vec<MeshGroup>>);

impl<'a> Body<'a> {
    /// An object, and what of it opens.
    pub fn object(object: &'a Object) -> Self {
        let loose = object.body == Holding::Free;
        let geoms = shape::of_object(object);
        let mut body = Self {
            name: &object.name,
            what: BodyKind::Object(object),
            pos: object.place.pos,
            axes: object.axes,
            loose,
            geoms: Vec::new(),
            drawn: Cow::Borrowed(&object.mesh),
            inertia: None,
            moving: Vec::new(),
        };
        let mut fixed: Vec<usize> = (0..geoms.len()).collect();
        if let Some(pieces) = joint::take_apart(object, &geoms) {
            (fixed, body.moving, body.drawn) = (pieces.fixed, pieces.moving, Cow::Owned(pieces.drawn));
        }
        body.inertia = Some(joint::inertia(object, &fixed));
        body.geoms = fixed.into_iter().map(|part| geoms[part].clone()).collect();
        body
    }

    fn shell(shell: &'a Shell) -> Self {
        Self {
            name: &shell.name,
            what: BodyKind::Shell(shell),
            pos: Vec3::zeros(),
            axes: Matrix3::identity(),
            loose: false,
            geoms: shape::of_shell(shell),
            drawn: Cow::Borrowed(std::slice::from_ref(&shell.group)),
            inertia: None,
            moving: Vec::new(),
        }
    }

    /// The object, if it is one.
    pub fn as_object(&self) -> Option<&'a Object> {
        match self.what {
            BodyKind::Object(object) => Some(object),
            BodyKind::Shell(_) => None,
        }
    }

    /// What kind of thing it is, in a word: the category, the family of furniture where the program says none, `wall`.
    pub fn category(&self) -> &'a str {
        match self.what {
            BodyKind::Object(object) if object.category.is_empty() => &object.family,
            BodyKind::Object(object) => &object.category,
            BodyKind::Shell(shell) => shell.role.word(),
        }
    }

    /// Whether it hides the room from an eye above.
    pub fn is_ceiling(&self) -> bool {
        matches!(self.what, BodyKind::Shell(Shell { role: Role::Ceiling, .. }))
    }
}

impl<'a> Physics<'a> {
    /// The bodies of a scene.
    pub fn of(scene: &'a Scene) -> Self {
        let objects = scene.objects.iter().map(Body::object);
        // A wall that is all door has nothing to show.
        let shells = scene.shells.iter().filter(|s| !s.group.indices.is_empty()).map(Body::shell);
        let bodies: Vec<Body<'a>> = objects.chain(shells).collect();
        let mut through: Vec<[usize; 2]> =
            scene.overlaps.iter().copied().filter(|pair| pair.iter().any(|&i| bodies[i].loose)).collect();
        let roles: Vec<&str> = scene.objects.iter().map(|object| role_of(&object.category)).collect();
        for (a, opens) in bodies.iter().enumerate().filter(|(_, body)| !body.moving.is_empty()) {
            // Furniture stands on a rug.
            let gives_way = |role: &str| role == "curtain" || role == "carpet" && !opens.loose;
            let soft = (0..roles.len()).filter(|b| *b != a && gives_way(roles[*b])).map(|b| [a, b]);
            through.extend(
                soft.filter(|[a, b]| !scene.overlaps.contains(&[*a, *b]) && !scene.overlaps.contains(&[*b, *a])),
            );
        }
        Self { bodies, through }
    }

    /// The names of such a pair.
    pub fn names(&self, [a, b]: [usize; 2]) -> [&'a str; 2] {
        [self.bodies[a].name, self.bodies[b].name]
    }
}
