//! Places, moves and rows in words.

use super::{ObjectMove, RowRef, SmallestMove, name};
use crate::check::Subject;
use crate::report::model::RowKind;
use crate::world::World;
use scenelang_lang::program::{ObjectId, Program};

/// Where an object is.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjectPlace {
    pub object: ObjectId,
    /// Centre of its bottom face (metres).
    pub pos: [f64; 3],
    /// Its Euler triple (degrees).
    pub rot: [f64; 3],
    /// Its extents (metres).
    pub size: [f64; 3],
    /// All of this in words.
    pub text: String,
}

impl ObjectPlace {
    /// Of an object, unless the layout lacks it.
    pub fn of(program: &Program, world: &World<f64>, object: ObjectId) -> Option<Self> {
        let thing = world.object(object).ok()?;
        let [pos, rot, size] = [&thing.pos, &thing.rot, &thing.scale].map(|v| v.0);
        let place = in_words(pos, rot, size);
        Some(Self { object, pos, rot, size, text: format!("`{}` is {place}", name(program, object)) })
    }
}

/// Place, direction and size.
fn in_words(pos: [f64; 3], rot: [f64; 3], size: [f64; 3]) -> String {
    let [x, y, z] = pos.map(plain);
    let [w, h, d] = size;
    format!("at ({x}, {y}, {z}), {}, {w:.2} × {h:.2} × {d:.2} m", facing_in_words(rot))
}

/// Two digits, without a minus before zero.
fn plain(x: f64) -> String {
    let text = format!("{x:.2}");
    if text.trim_start_matches('-').bytes().all(|b| b == b'0' || b == b'.') {
        text.trim_start_matches('-').to_owned()
    } else {
        text
    }
}

/// Which way an object faces: north is +z, east is +x. One that is tilted has no such direction, and its turns are named.
pub fn facing_in_words(rot: [f64; 3]) -> String {
    const WINDS: [&str; 8] =
        ["north (+z)", "north-east", "east (+x)", "south-east", "south (-z)", "south-west", "west (-x)", "north-west"];
    let [x, y, z] = rot.map(|r| r.rem_euclid(360.0));
    let near = |angle: f64, to: f64| (angle - to).abs() < 0.05 || (angle - to).abs() > 359.95;
    if !(near(x, 0.0) && near(z, 0.0)) {
        let [x, y, z] = rot.map(degrees);
        return format!("rotated ({x}, {y}, {z})°");
    }
    let wind = (y / 45.0).round();
    let exact = near(y, wind * 45.0);
    let wind = WINDS[wind as usize % 8];
    if exact {
        return format!("faces {wind}");
    }
    format!("faces {} (turned {}°)", wind.split(' ').next().unwrap_or(wind), degrees(y))
}

fn degrees(x: f64) -> String {
    let text = format!("{x:.1}");
    text.strip_suffix(".0").map_or(text.clone(), |whole| if whole == "-0" { "0".into() } else { whole.to_owned() })
}

/// A length without its sign, as short as it can be to the tenth of a millimetre, two digits at least.
fn length(x: f64) -> String {
    let mut text = format!("{:.4}", x.abs());
    while text.ends_with('0') && text.split('.').nth(1).is_some_and(|digits| digits.len() > 2) {
        text.pop();
    }
    text
}

/// A move in the imperative: "move `nightstand` 0.07 m east". North is +z, and east is +x.
pub fn move_in_words(program: &Program, repair: &SmallestMove) -> String {
    let mut parts: Vec<(String, Vec<&str>, &ObjectMove)> = Vec::new();
    for step in &repair.steps {
        let text = step_in_words(step);
        // What goes along with another needs no sentence of its own.
        match parts.iter_mut().find(|(_, _, first)| step.with == Some(first.object)) {
            Some((_, names, _)) => names.push(name(program, step.object)),
            None => parts.push((text, Vec::new(), step)),
        }
    }
    let sentence = |(text, along, step): &(String, Vec<&str>, &ObjectMove)| {
        let moved = text.replacen("{}", &format!("`{}`", name(program, step.object)), 1);
        if along.is_empty() { moved } else { format!("{moved}, together with `{}`", along.join("`, `")) }
    };
    parts.iter().map(sentence).collect::<Vec<_>>().join("; ")
}

/// One step, with `{}` where the name goes.
fn step_in_words(step: &ObjectMove) -> String {
    let [x, y, z] = step.by;
    let along = |by: f64, [less, more]: [&str; 2]| {
        (by != 0.0).then(|| format!("{} m {}", length(by), if by < 0.0 { less } else { more }))
    };
    let ways = [along(x, ["west", "east"]), along(z, ["south", "north"]), along(y, ["down", "up"])];
    let ways: Vec<String> = ways.into_iter().flatten().collect();
    let moved = match ways.split_last() {
        None => return format!("turn {{}} by {}", turn_in_words(step.turn)),
        Some(_) if x == 0.0 && z == 0.0 => {
            format!("{} {{}} by {} m", if y < 0.0 { "lower" } else { "raise" }, length(y))
        }
        Some((last, [])) => format!("move {{}} {last}"),
        Some((last, rest)) => format!("move {{}} {} and {last}", rest.join(", ")),
    };
    if step.turn == 0.0 { moved } else { format!("{moved}, and turn it by {}", turn_in_words(step.turn)) }
}

/// A turn about the vertical, as it is seen from above.
fn turn_in_words(turn: f64) -> String {
    let size = degrees(turn.abs());
    // A half turn is the same either way.
    let sense = match turn {
        _ if size == "180" => "",
        _ if turn < 0.0 => " anticlockwise",
        _ => " clockwise",
    };
    format!("{size}°{sense}")
}

/// A row as a note names it; `place` says where a statement stands.
pub(crate) fn row_in_words(program: &Program, row: RowRef, place: impl Fn(usize) -> String) -> String {
    match (row.kind, row.subject) {
        (_, Subject::Statement(index)) => {
            let text = &program.constraints[index].text;
            const LONGEST: usize = 70;
            let short = text.char_indices().nth(LONGEST).map_or(text.clone(), |(at, _)| format!("{}…", &text[..at]));
            format!("`{short}` ({})", place(index))
        }
        (kind, Subject::Pair(a, b)) => {
            format!("{} for `{}` and `{}`", rule(kind), name(program, a), name(program, b))
        }
        (kind, Subject::Object(a) | Subject::Part(a, _)) => format!("{} for `{}`", rule(kind), name(program, a)),
    }
}

fn rule(kind: RowKind) -> &'static str {
    kind.rule().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_have_names() {
        for (rot, want) in [
            ([0.0, 0.0, 0.0], "faces north (+z)"),
            ([0.0, 90.0, 0.0], "faces east (+x)"),
            ([0.0, -180.0, 0.0], "faces south (-z)"),
            ([360.0, -90.0, 0.0], "faces west (-x)"),
            ([0.0, 45.0, 0.0], "faces north-east"),
            ([0.0, 359.99, 0.0], "faces north (+z)"),
            ([0.0, 338.0, 0.0], "faces north (turned 338°)"),
            ([0.0, 100.5, 0.0], "faces east (turned 100.5°)"),
            ([10.0, 0.0, 0.0], "rotated (10, 0, 0)°"),
        ] {
            assert_eq!(facing_in_words(rot), want, "{rot:?}");
        }
    }

    #[test]
    fn steps_have_words() {
        let step = |by: [f64; 3], turn: f64| step_in_words(&ObjectMove { object: ObjectId(0), by, turn, with: None });
        for (by, turn, want) in [
            ([0.07, 0.0, 0.0], 0.0, "move {} 0.07 m east"),
            ([0.0, 0.0, -1.5], 0.0, "move {} 1.50 m south"),
            ([0.0, 0.2, 0.0], 0.0, "raise {} by 0.20 m"),
            ([0.0, -0.2005, 0.0], 0.0, "lower {} by 0.2005 m"),
            ([0.1, 0.0, -0.2], 90.0, "move {} 0.10 m east and 0.20 m south, and turn it by 90° clockwise"),
            ([-1.0, 0.5, 0.3], 0.0, "move {} 1.00 m west, 0.30 m north and 0.50 m up"),
            ([0.0; 3], -14.5, "turn {} by 14.5° anticlockwise"),
            ([0.0; 3], -180.0, "turn {} by 180°"),
        ] {
            assert_eq!(step(by, turn), want);
        }
    }
}
