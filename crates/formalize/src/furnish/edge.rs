//! A railing along the open edges of a balcony, where nobody must fall, and the wall of the house behind it.

use super::floor::Pose;
use super::kinds::Line;
use super::place;
use super::plan::Plan;
use crate::draft::DraftRoom;

/// How thick a railing is, and how high (metres).
pub const THICK: f64 = 0.06;
const HIGH: f64 = 1.05;
/// How thick the wall of the house is; how wide its panes are, and are where it is wider than this (metres).
const WALL: f64 = 0.12;
const GLASS: [f64; 2] = [1.4, 2.4];
const WIDE: f64 = 4.5;

/// Adds the railing along the edges beyond which there is nothing: no room of the home, and no wall of the house, which is
/// at the front.
pub fn railing(plan: &mut Plan, line: &Line, why: &str) {
    if plan.draft.rooms[plan.room].outline.is_some() {
        return;
    }
    let [w, _, d] = plan.draft.rooms[plan.room].size;
    let [near, far, left, right] = open(plan);
    let ends = [(far, 1.0, 180.0), (near, -1.0, 0.0)];
    let ends: Vec<Pose> = ends
        .into_iter()
        .filter(|(is_open, ..)| *is_open)
        .map(|(_, sign, yaw)| Pose { z: sign * (d - THICK) / 2.0, yaw, ..Pose::default() })
        .collect();
    along(plan, line.noun, [w, HIGH, THICK], &ends, why);
    // The sides lie between the two ends, or begin at the wall of the house.
    let house = if plan.draft.outdoor { WALL } else { 0.0 };
    let [low, high] = [if near { THICK } else { house }, if far { THICK } else { 0.0 }];
    let sides = [(left, -1.0, 90.0), (right, 1.0, 270.0)];
    let sides: Vec<Pose> = sides
        .into_iter()
        .filter(|(is_open, ..)| *is_open)
        .map(|(_, sign, yaw)| Pose { x: sign * (w - THICK) / 2.0, z: (low - high) / 2.0, yaw, ..Pose::default() })
        .collect();
    along(plan, line.noun, [d - low - high, HIGH, THICK], &sides, why);
    if let Some(ground) = &mut plan.ground {
        ground.edge = THICK;
    }
}

/// Whether nothing is beyond the edges at low and high z, and at low and high x.
fn open(plan: &Plan) -> [bool; 4] {
    const NEAR: f64 = 0.3;
    if plan.draft.outdoor {
        return [false, true, true, true];
    }
    let own = &plan.draft.rooms[plan.room];
    let beyond = |axis: usize, sign: f64| {
        let half = |room: &DraftRoom, axis: usize| room.size[2 * axis] / 2.0;
        plan.draft.rooms.iter().enumerate().any(|(other, room)| {
            let gap = sign * (room.at[axis] - own.at[axis]) - half(room, axis) - half(own, axis);
            let along = 1 - axis;
            let beside = (room.at[along] - own.at[along]).abs() < half(room, along) + half(own, along) - NEAR;
            other != plan.room && gap.abs() < NEAR && beside
        })
    };
    [(1, -1.0), (1, 1.0), (0, -1.0), (0, 1.0)].map(|(axis, sign)| !beyond(axis, sign))
}

/// Adds the wall of the house at the front, with panes through which one goes out.
pub fn house(plan: &mut Plan, line: &Line, why: &str) {
    let [w, height, d] = plan.draft.rooms[plan.room].size;
    if !plan.draft.outdoor || plan.draft.rooms[plan.room].outline.is_some() || w < 2.0 * GLASS[0] {
        return;
    }
    let glass = if w > WIDE { GLASS[1] } else { GLASS[0] };
    let part = (w - glass) / 2.0;
    let at = |x: f64, thick: f64| Pose { x, z: (thick - d) / 2.0, ..Pose::default() };
    let sides = [-1.0, 1.0].map(|sign| at(sign * (w - part) / 2.0, WALL));
    along(plan, line.noun, [part, height, WALL], &sides, why);
    along(plan, "glass wall", [glass, height, THICK], &[at(0.0, THICK)], why);
}

/// What stands along an edge.
fn along(plan: &mut Plan, noun: &str, size: [f64; 3], places: &[Pose], why: &str) {
    if places.is_empty() {
        return;
    }
    let thing = plan.add(noun, places.len(), size, why);
    let (name, room) = (plan.draft.things[thing].name.clone(), plan.room_name());
    let mut fixed = Vec::new();
    for (i, at) in places.iter().enumerate() {
        let element = if places.len() > 1 { format!("{name}[{i}]") } else { name.clone() };
        fixed.push(place::absolute(&element, &room, [at.x, at.y, at.z], at.yaw));
        plan.note_place(&element, at);
        if let Some(ground) = &mut plan.ground {
            ground.body(at, size);
        }
    }
    plan.say(format!("assert {};", fixed.join(" and ")), why);
}
