//! Statements that say where something that was added stands.

use super::slots::{Level, Slot};
use crate::write::number;

/// The position and the turn of an element, given those of another: equations, so that both are moved as one.
pub fn fixed(part: &str, of: &str, slot: &Slot, height: f64, ceiling: f64) -> String {
    let mut pos = format!("{part}.pos = {of}.pos");
    let mut shift = |direction: &str, by: f64| {
        let by = rounded(by);
        if by != 0.0 {
            let (sign, by) = if by < 0.0 { ('-', -by) } else { ('+', by) };
            pos.push_str(&format!(" {sign} {of}.{direction} * {}", number(by)));
        }
    };
    shift("right", slot.x);
    shift("front", slot.z);
    let up = match slot.level {
        Level::Floor => None,
        Level::Top => Some(format!("{of}.surface - {of}.bottom")),
        Level::At(y) | Level::Above(y) => Some(number(rounded_up(y))),
        Level::Ceiling => Some(number(rounded(ceiling - height))),
    };
    if let Some(up) = up {
        pos.push_str(&format!(" + vec3(0, {up}, 0)"));
    }
    let yaw = if slot.yaw == 0.0 { String::new() } else { format!(" + {}", number(slot.yaw)) };
    format!("{pos} and {part}.rot.y = {of}.rot.y{yaw}")
}

/// The place of an element in its room: metres from the middle, and a turn.
pub fn absolute(part: &str, room: &str, [x, y, z]: [f64; 3], yaw: f64) -> String {
    let place: Vec<String> = [x, y, z].iter().map(|v| number(rounded(*v))).collect();
    format!("{part}.pos = {room}.pos + vec3({}) and {part}.rot.y = {}", place.join(", "), number(yaw))
}

/// To millimetres.
fn rounded(v: f64) -> f64 {
    let v = (v * 1000.0).round() / 1000.0;
    if v == 0.0 { 0.0 } else { v }
}

/// A height above a board, never below it by rounding.
fn rounded_up(v: f64) -> f64 {
    (v * 10_000.0).ceil() / 10_000.0
}
