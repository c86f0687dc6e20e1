//! Places at the walls of a room: in its corners, and with the back to a wall.

use super::proper::BESIDE;
use crate::Pose;
use crate::pose::yaw_towards;
use scenelang_layout::{Polygon, Vec2, Vec3};
use scenelang_verify::World;

/// Places along a wall are so far from each other (metres).
const STEP: f64 = 0.1;
/// A back that is so near to a wall is at it (metres).
const AT_WALL: f64 = 0.1;
/// What is wider seats several people, who have a wall behind them (metres).
const SOFA: f64 = 1.3;

/// Whether things of a role and a size stand with the back to a wall, in most rooms.
pub(super) fn has_back(role: &str, size: &Vec3) -> bool {
    matches!(role, "storage" | "appliance" | "desk" | "bed" | "screen") || role == "seat" && size.x >= SOFA
}

/// Whether a thing has its back at a wall.
pub(super) fn is_backed(own: &Pose, world: &World<f64>) -> bool {
    let back = own.pos - own.front() * (own.scale.z / 2.0);
    let back = Vec2::new(back.x, back.z);
    let here = Vec2::new(own.pos.x, own.pos.z);
    room(here, world).is_some_and(|outline| outline.clearance_of_point(back).value.abs() <= AT_WALL)
}

/// The outline of the room around a point: of the regions that hold it the largest.
fn room(at: Vec2, world: &World<f64>) -> Option<&Polygon> {
    let outlines = world.prisms().map(|(_, prism)| &prism.polygon).filter(|outline| outline.contains(at));
    outlines.max_by(|a, b| a.area().total_cmp(&b.area()))
}

/// Places along all walls of the room that a thing is in, with its back to them.
pub(super) fn along(own: &Pose, world: &World<f64>) -> Vec<Pose> {
    let here = Vec2::new(own.pos.x, own.pos.z);
    let Some(outline) = room(here, world) else { return Vec::new() };
    let [wide, deep] = [own.scale.x / 2.0, own.scale.z / 2.0];
    let mut out = Vec::new();
    for (a, b) in outline.edges() {
        let long = (b - a).norm();
        if long < 2.0 * wide {
            continue;
        }
        let along = (b - a) / long;
        let ways = [Vec2::new(-along.y, along.x), Vec2::new(along.y, -along.x)];
        let Some(inward) = ways.into_iter().find(|way| outline.contains((a + b) / 2.0 + way * deep)) else { continue };
        let turned = own.facing(yaw_towards(&Vec3::new(inward.x, 0.0, inward.y)));
        let nearest = (here - a).dot(&along).clamp(wide, long - wide);
        let count = ((long - 2.0 * wide) / STEP).floor() as usize;
        let steps = (0..=count).map(|i| wide + STEP * i as f64);
        for at in [nearest, long - wide].into_iter().chain(steps) {
            let spot = a + along * at + inward * deep;
            out.push(Pose { pos: Vec3::new(spot.x, own.pos.y, spot.y), ..turned });
        }
    }
    out
}

/// At the walls of the room it is in: as near as can be, and in the corners. With each, whether it is in one.
pub(super) fn in_corners(own: &Pose, world: &World<f64>) -> Vec<(bool, Pose)> {
    let here = Vec2::new(own.pos.x, own.pos.z);
    let Some(outline) = room(here, world) else { return Vec::new() };
    let off = own.scale.x.max(own.scale.z) / 2.0 + BESIDE[0];
    let mut out = Vec::new();
    for (a, b) in outline.edges() {
        let long = (b - a).norm();
        if long < 2.0 * off {
            continue;
        }
        let along = (b - a) / long;
        let inward = [Vec2::new(-along.y, along.x), Vec2::new(along.y, -along.x)];
        let nearest = (here - a).dot(&along).clamp(off, long - off);
        for at in [nearest, off, long - off] {
            let spots = inward.map(|way| a + along * at + way * off);
            for spot in spots.into_iter().filter(|spot| outline.contains(*spot)) {
                let walls = outline.edges().filter(|(a, b)| distance(spot, *a, *b) < off + BESIDE[0]);
                let pose = Pose { pos: Vec3::new(spot.x, own.pos.y, spot.y), ..*own };
                // Two walls have the same corner.
                if out.iter().all(|(_, known): &(bool, Pose)| (known.pos - pose.pos).norm() > BESIDE[0]) {
                    out.push((walls.count() > 1, pose));
                }
            }
        }
    }
    out
}

/// How far a place is from a wall.
fn distance(at: Vec2, a: Vec2, b: Vec2) -> f64 {
    let along = b - a;
    let part = ((at - a).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
    (at - a - along * part).norm()
}
