//! A railing along the open edges of a balcony: nobody falls.

use super::floor::Pose;
use super::kinds::Line;
use super::place;
use super::plan::Plan;

/// How thick a railing is, and how high (metres).
pub const THICK: f64 = 0.06;
const HIGH: f64 = 1.05;

/// Adds the railing: along the far edge and both sides. The house is at the front.
pub fn railing(plan: &mut Plan, line: &Line, why: &str) {
    if plan.draft.rooms[plan.room].outline.is_some() {
        return;
    }
    let [w, _, d] = plan.draft.rooms[plan.room].size;
    let far = Pose { z: (d - THICK) / 2.0, yaw: 180.0, ..Pose::default() };
    let side = |sign: f64| Pose {
        x: sign * (w - THICK) / 2.0,
        z: -THICK / 2.0,
        yaw: if sign > 0.0 { 270.0 } else { 90.0 },
        ..Pose::default()
    };
    along(plan, line.noun, w, &[far], why);
    along(plan, line.noun, d - THICK, &[side(-1.0), side(1.0)], why);
    if let Some(ground) = &mut plan.ground {
        ground.edge = THICK;
    }
}

/// Railings of a length.
fn along(plan: &mut Plan, noun: &str, length: f64, places: &[Pose], why: &str) {
    let size = [length, HIGH, THICK];
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
