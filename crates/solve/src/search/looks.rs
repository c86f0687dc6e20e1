//! What nobody asked for and everybody expects: things stand square to the room, tall ones with their backs to a wall,
//! nothing crowds what it has nothing to do with, doors and windows stay free.
//!
//! These costs are so small that they decide only between layouts that are equally good otherwise.

use crate::problem::frame::Hold;
use crate::problem::pose::Pose;
use crate::search::state::{State, overlap_in_plan};
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Aabb, Vec2, Vec3};

/// Cost of standing at 45° to the room.
const ASKEW: f64 = 0.01;
/// Cost of a tall thing whose back is a metre from the wall.
pub(crate) const ADRIFT: f64 = 0.01;
/// Cost of a front that a wall bars.
pub(crate) const BARRED: f64 = 0.01;
/// Cost of touching something it has nothing to do with.
pub(crate) const CROWDED: f64 = 0.004;
/// Cost of standing before a door or a window.
const IN_THE_WAY: f64 = 0.02;
/// Cost of sticking out a metre over what carries it.
const OVERHANG: f64 = 0.05;
/// Cost of being a metre out of line with what it has most to do with.
const OUT_OF_LINE: f64 = 0.003;
/// Cost of hanging a metre off the usual height.
const OFF_HEIGHT: f64 = 0.005;

/// Cost of standing half a metre off where its siblings would stand in its place.
const UNLIKE: f64 = 0.004;

/// Space that one likes to keep around things (metres).
pub(crate) const AROUND: f64 = 0.3;
/// Space that one likes to keep before doors and windows (metres).
const BEFORE_DOOR: f64 = 0.8;
/// From this height on a thing looks better with its back to a wall (metres).
pub(crate) const TALL: f64 = 1.1;
/// Where the middle of what hangs on a wall usually is (metres above the floor).
const EYE_LEVEL: f64 = 1.5;
/// Where the upper edge of doors and windows usually is (metres above the floor).
pub(crate) const LINTEL: f64 = 2.1;

/// How odd an object looks where it is.
pub(crate) fn cost(state: &State<'_>, id: ObjectId) -> f64 {
    let pose = state.pose(id);
    let hold = state.frame.hold(id);
    let span = state.span(id);
    let mut cost = askew(state, id, &pose);
    match hold {
        Hold::Rests => {
            cost += by_the_wall(state, id, &pose) + crowded(state, id, span) + overhang(state, id, span);
            cost += in_line(state, id, &pose) + unlike_siblings(state, id, &pose);
        }
        Hold::Wall(_) => {
            cost += OFF_HEIGHT * (pose.center().y - EYE_LEVEL).abs().min(2.0)
                + crowded(state, id, span)
                + in_line(state, id, &pose);
        }
        Hold::Door(..) => cost += OFF_HEIGHT * (span.max.y - LINTEL).abs().min(2.0) + kept_free(state, &pose, id),
        Hold::Ceiling(_) | Hold::Container(_) | Hold::Floats => cost += in_line(state, id, &pose),
    }
    cost
}

/// Turned out of the directions of its room.
fn askew(state: &State<'_>, id: ObjectId, pose: &Pose) -> f64 {
    if state.frame.fixed(id).rot {
        return 0.0;
    }
    let room = room_of(state, pose).map_or(0.0, |(_, yaw)| yaw);
    let off = (pose.rot.y - room).rem_euclid(90.0);
    ASKEW * off.min(90.0 - off) / 45.0
}

/// The region that holds a position, and its turn.
fn room_of<'s>(state: &'s State<'_>, pose: &Pose) -> Option<(&'s scenelang_layout::Prism, f64)> {
    let here = Vec2::new(pose.pos.x, pose.pos.z);
    let (id, prism) = state.world().prisms().find(|(_, prism)| prism.polygon.contains(here))?;
    let room = state.world().region(id).ok()?;
    Some((prism, if room.outlined { 0.0 } else { room.rot.0[1] }))
}

/// Tall things like a wall behind them; nothing likes one in its face.
fn by_the_wall(state: &State<'_>, id: ObjectId, pose: &Pose) -> f64 {
    let Some((prism, _)) = room_of(state, pose) else { return 0.0 };
    let (center, front) = (pose.center(), pose.front());
    let clearance = |p: Vec3| prism.polygon.clearance_of_point(Vec2::new(p.x, p.z)).value;
    let mut cost = 0.0;
    if state.frame.related[id.0 as usize].is_empty() && pose.scale.y >= TALL {
        cost += ADRIFT * clearance(center - front * (pose.scale.z / 2.0)).clamp(0.0, 1.0);
    }
    if pose.scale.y > 0.3 && clearance(center + front * (pose.scale.z / 2.0 + 0.4)) < 0.0 {
        cost += BARRED;
    }
    cost
}

/// Too close to what it has nothing to do with, or before a door.
fn crowded(state: &State<'_>, id: ObjectId, span: &Aabb) -> f64 {
    if span.max.y - span.min.y < 0.05 {
        return 0.0;
    }
    let related = &state.frame.related[id.0 as usize];
    let mut cost = 0.0;
    for other in state.placed().filter(|other| *other != id) {
        let near = state.span(other);
        let apart = near.distance(span);
        let is_door = matches!(state.frame.hold(other), Hold::Door(..));
        let flat = near.max.y - near.min.y < 0.05;
        if is_door {
            if apart < BEFORE_DOOR && overlap_in_plan(&before(&state.pose(other)), span) && in_height(near, span) {
                cost += IN_THE_WAY;
            }
        } else if apart < AROUND && !flat && !related.iter().any(|(r, _)| *r == other) {
            cost += CROWDED * (1.0 - apart / AROUND);
        }
    }
    cost
}

/// The same, seen from the door.
fn kept_free(state: &State<'_>, pose: &Pose, id: ObjectId) -> f64 {
    let (space, own) = (before(pose), state.span(id));
    let others = state.placed().filter(|other| *other != id && !matches!(state.frame.hold(*other), Hold::Door(..)));
    let blocking = others.filter(|other| {
        let span = state.span(*other);
        span.max.y - span.min.y >= 0.05 && overlap_in_plan(&space, span) && in_height(own, span)
    });
    IN_THE_WAY * blocking.count() as f64
}

/// The space before and behind a door, seen from above.
fn before(door: &Pose) -> Aabb {
    let scale = Vec3::new(door.scale.x, door.scale.y, door.scale.z + 2.0 * BEFORE_DOOR);
    Pose { scale, ..*door }.span()
}

fn in_height(a: &Aabb, b: &Aabb) -> bool {
    a.min.y < b.max.y - 0.01 && b.min.y < a.max.y - 0.01
}

/// Sticking out over what carries it.
fn overhang(state: &State<'_>, id: ObjectId, span: &Aabb) -> f64 {
    let base = state.placed().find(|other| {
        let top = state.span(*other);
        *other != id && top.min.y < span.min.y && (top.max.y - span.min.y).abs() < 0.01 && overlap_in_plan(top, span)
    });
    let Some(base) = base.map(|b| state.span(b)) else { return 0.0 };
    let out = (base.min - span.min).sup(&(span.max - base.max)).sup(&Vec3::zeros());
    OVERHANG * (out.x + out.z).min(1.0)
}

/// Out of line with what it has most to do with.
fn in_line(state: &State<'_>, id: ObjectId, pose: &Pose) -> f64 {
    let related = &state.frame.related[id.0 as usize];
    let Some((other, _)) = related.iter().find(|(other, _)| state.is_placed(*other)) else { return 0.0 };
    let anchor = state.pose(*other);
    let way = pose.center() - anchor.center();
    let off = way.dot(&anchor.right()).abs().min(way.dot(&anchor.front()).abs());
    OUT_OF_LINE * off.min(1.0)
}

/// Otherwise than its siblings stand to what they belong to.
fn unlike_siblings(state: &State<'_>, id: ObjectId, pose: &Pose) -> f64 {
    let away = state.as_siblings(id).into_iter().map(|p| (p.pos - pose.pos).norm()).fold(f64::INFINITY, f64::min);
    if away.is_finite() { UNLIKE * (2.0 * away).min(1.0) } else { 0.0 }
}
