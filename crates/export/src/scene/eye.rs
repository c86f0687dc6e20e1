//! What someone sees who has just come in: from the door of the largest room, at the height of the eyes, towards its middle.

use super::view::{View, fronts_seen};
use super::{Object, Region, RegionKind, Scene};
use scenelang_layout::planar::{edges, nearest_on_segment};
use scenelang_layout::{Obb, Vec2, Vec3};

/// Height of the eyes above the floor, metres.
const EYES: f64 = 1.6;
/// Of a lower room they are this far under the ceiling at least, metres.
const UNDER: f64 = 0.2;
/// How far in from the door or the corner the eyes are, metres.
const STEP: f64 = 0.3;
/// How far from the edge of a floor the middle of its door may be, metres.
const AT_WALL: f64 = 0.3;
/// How high above the floor is what they look at, metres.
const LOOK: f64 = 0.8;
/// What stands no farther before the eyes than this hides all the rest, metres.
const CLOSE: f64 = 0.9;
/// Vertical angle of view, degrees.
const WIDE: f64 = 66.0;

impl View {
    /// From the door of the largest room, or from a corner of it, at the height of the eyes, towards the middle of the room.
    /// `None`: there is no room.
    pub fn entering(scene: &Scene) -> Option<Self> {
        let room = largest(scene)?;
        let prism = &room.prism;
        let middle = prism.center();
        let height = (prism.floor + EYES).min(prism.ceiling - UNDER).max(prism.floor);
        let target = Vec3::new(middle.x, prism.floor + LOOK.min((height - prism.floor) / 2.0), middle.z);
        let stands: Vec<Vec3> = doors(scene, room)
            .chain(corners(scene, room))
            .filter(|p| prism.polygon.contains(*p))
            .map(|p| Vec3::new(p.x, height, p.y))
            .filter(|eye| (eye - target).xz().norm() > STEP)
            .collect();
        let eye = stands.iter().find(|eye| is_open(scene, **eye, target)).or_else(|| stands.first())?;
        Some(Self { eye: *eye, target, fov: WIDE })
    }
}

/// The first of the rooms with the largest floor.
fn largest(scene: &Scene) -> Option<&Region> {
    let rooms = scene.regions.iter().filter(|region| region.kind == RegionKind::Room);
    rooms.reduce(|best, room| if area(room) > area(best) + 1e-6 { room } else { best })
}

fn area(room: &Region) -> f64 {
    let twice: f64 = edges(room.prism.polygon.corners()).map(|(a, b)| a.x * b.y - b.x * a.y).sum();
    twice.abs() / 2.0
}

/// Inside the doors of a room, in the order in which they are declared.
fn doors<'a>(scene: &'a Scene, room: &'a Region) -> impl Iterator<Item = Vec2> + 'a {
    let is_door = |object: &&Object| object.family == "door";
    scene.objects.iter().filter(is_door).filter_map(|door| {
        let at = Obb::from_placement(&door.place).center;
        let is_here = room.prism.floor - AT_WALL < at.y && at.y < room.prism.ceiling;
        let near = |(from, to): (Vec2, Vec2)| {
            let nearest = nearest_on_segment(&at.xz(), &from, &to);
            let inwards = Vec2::new(from.y - to.y, to.x - from.x).try_normalize(1e-9)?;
            ((nearest - at.xz()).norm() < AT_WALL).then_some(nearest + inwards * STEP)
        };
        if is_here { edges(room.prism.polygon.corners()).find_map(near) } else { None }
    })
}

/// In the corners of a room, those first from which most of the furniture shows its front.
fn corners(scene: &Scene, room: &Region) -> impl Iterator<Item = Vec2> {
    let middle = room.prism.center().xz();
    let mut out: Vec<(f64, Vec2)> = Vec::new();
    for corner in room.prism.polygon.corners() {
        let Some(back) = (corner - middle).try_normalize(1e-9) else { continue };
        out.push((fronts_seen(scene, Vec3::new(back.x, 0.0, back.y)), corner - back * STEP));
    }
    out.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    out.into_iter().map(|(_, at)| at)
}

/// Whether nothing stands where the eyes are, or close before them.
fn is_open(scene: &Scene, eye: Vec3, target: Vec3) -> bool {
    let ahead = (target - eye).try_normalize(1e-9).unwrap_or(Vec3::z());
    let steps: Vec<Vec3> = (0..10).map(|k| eye + ahead * (CLOSE * f64::from(k) / 9.0)).collect();
    let hides = |object: &Object| {
        let half = object.place.scale / 2.0;
        steps.iter().any(|p| {
            let local = object.axes.transpose() * (p - object.place.pos);
            local.x.abs() < half.x + 0.05
                && local.z.abs() < half.z + 0.05
                && (0.0..object.place.scale.y).contains(&local.y)
        })
    };
    let is_door = |object: &Object| matches!(object.family.as_str(), "door" | "window");
    !scene.objects.iter().any(|object| !is_door(object) && hides(object))
}
