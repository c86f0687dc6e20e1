//! Where doors and windows of a room may be: in walls that lead where they shall, doors near a corner, windows in one wall.

use super::floor::{Floor, Pose};
use super::gates::GATE;
use super::seek::Wall;
use super::{kinds, place};
use crate::draft::{Draft, Opening, OpeningKind, Statement, ThingOrigin};

/// So much wall remains beside an opening (metres).
const JAMB: f64 = 0.12;
/// Beside a door there is room for a light switch, or for what stands in the corner.
const CORNER: f64 = 0.3;
/// In a wall that is shorter a window is at one end, so far from the corner: something tall finds room beside it.
const NARROW: f64 = 2.4;
const MARGIN: f64 = 0.25;
/// Two doors in walls that meet are so far apart at least, middle to middle (metres).
const AT_CORNER: f64 = 0.85;
/// What each metre from the bathroom to the door of a hotel room costs.
const PASSED: f64 = 1.0;
/// Half the distance of two rooms, in which a door between them is.
const BETWEEN: f64 = 0.03;
/// How far two rooms are apart at most that share a wall.
const NEXT: f64 = 0.2;

/// The pieces of a wall of a room behind which is another room, or none: from and to, along the wall.
pub fn spans(draft: &Draft, room: usize, wall: Wall, beyond: Option<usize>) -> Vec<(f64, f64)> {
    let own = &draft.rooms[room];
    let half = wall.length(own.size) / 2.0;
    // The axis along the wall, the one across it, and where the wall is on that.
    let (along, across, side) = match wall {
        Wall::Back => (0, 1, 1.0),
        Wall::Front => (0, 1, -1.0),
        Wall::Left => (1, 0, -1.0),
        Wall::Right => (1, 0, 1.0),
    };
    let flat = |size: [f64; 3]| [size[0] / 2.0, size[2] / 2.0];
    let edge = own.at[across] + side * flat(own.size)[across];
    // Seen by who stands with the back at the wall.
    let sign = if matches!(wall, Wall::Back | Wall::Left) { -1.0 } else { 1.0 };
    let mut taken: Vec<(f64, f64)> = Vec::new();
    for (index, other) in draft.rooms.iter().enumerate() {
        let near = (other.at[across] - side * flat(other.size)[across] - edge) * side;
        if index == room || near.abs() > NEXT || beyond.is_some_and(|beyond| beyond != index) {
            continue;
        }
        let ends = [-1.0, 1.0].map(|end| sign * (other.at[along] + end * flat(other.size)[along] - own.at[along]));
        let (low, high) = (ends[0].min(ends[1]).max(-half), ends[0].max(ends[1]).min(half));
        if high > low {
            taken.push((low, high));
        }
    }
    if beyond.is_some() {
        return taken;
    }
    taken.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut out, mut from) = (Vec::new(), -half);
    for (low, high) in taken.into_iter().chain([(half, half)]) {
        if low > from {
            out.push((from, low));
        }
        from = from.max(high);
    }
    out
}

/// A place in the scene of something that stands in the frame of a room.
pub fn in_scene(draft: &Draft, room: usize, pose: &Pose) -> Pose {
    let [x, z] = draft.rooms[room].at;
    Pose { x: pose.x + x, z: pose.z + z, ..*pose }
}

/// Finds places for the doors of a room that have none yet.
pub fn doors(draft: &mut Draft, room: usize) {
    for at in 0..draft.openings.len() {
        let door = draft.openings[at].clone();
        let own = door.rooms.first() == Some(&room) || door.rooms.len() == 2 && door.rooms.contains(&room);
        if door.kind != OpeningKind::Door || !own || draft.place_of(&door.name).is_some() {
            continue;
        }
        let beyond = door.rooms.iter().copied().find(|other| *other != room);
        // One comes in at the end of the aisle between pews.
        let pews = |kind: &kinds::FurnishingKind| kind.lines.iter().any(|line| line.noun.ends_with("pew"));
        let to_aisle = beyond.is_none() && kinds::of(&draft.rooms[room].kind).is_some_and(pews);
        let bathroom = beyond.is_none().then(|| bathroom(draft, room)).flatten();
        let mut best: Option<(f64, Pose)> = None;
        for wall in [Wall::Front, Wall::Right, Wall::Left, Wall::Back] {
            let gate = door.category.as_deref() == Some(GATE);
            let inner = door.category.is_some() && !gate;
            let dear = match (beyond, wall) {
                // To the next room, not to the street.
                (None, Wall::Front) if inner => 0.6,
                (None, Wall::Back) if inner => 0.5,
                (None, Wall::Right) => 1.0,
                (None, Wall::Left) => 1.5,
                (None, Wall::Back) => 2.0,
                _ => 0.0,
            };
            // A car that comes in by it has room before it.
            let [across, _, deep] = draft.rooms[room].size;
            let before = if matches!(wall, Wall::Front | Wall::Back) { deep } else { across };
            let dear = if gate && before < CAR { dear + 3.0 } else { dear };
            for (low, high) in spans(draft, room, wall, beyond) {
                let half = door.size[0] / 2.0;
                let margin = if high - low > door.size[0] + 2.0 * CORNER { CORNER } else { JAMB };
                let (first, last) = (low + margin + half, high - margin - half);
                if first > last + 1e-9 {
                    continue;
                }
                let steps = ((last - first) / 0.2).floor() as usize;
                for along in (0..=steps).map(|i| last - 0.2 * i as f64).chain([first]) {
                    let off = if beyond.is_some() { -BETWEEN } else { 0.0 };
                    let pose = wall.place(draft.rooms[room].size, along, off);
                    let off_best = match (gate, to_aisle) {
                        (true, _) => (along + 0.6).abs(),
                        (_, true) => along.abs(),
                        _ => (last - along).min(along - first),
                    };
                    let passed = bathroom.map_or(0.0, |[x, z]| (pose.x - x).hypot(pose.z - z) * PASSED);
                    let cost = dear + off_best * 0.2 + passed;
                    let free = !at_odds(draft, room, &pose, &door);
                    if free && best.as_ref().is_none_or(|(least, _)| cost < *least - 1e-9) {
                        best = Some((cost, pose));
                    }
                }
            }
        }
        if let Some((_, pose)) = best {
            if door.category.is_some() && beyond.is_none() && matches!(door.source, ThingOrigin::Inferred(_)) {
                let there = place::absolute(&door.name, &draft.rooms[room].name, [pose.x, pose.y, pose.z], pose.yaw);
                let text = format!("prefer {there};");
                let why = ThingOrigin::Inferred("the place it leads to is on this side".into());
                draft.statements.push(Statement::new(&text, why));
            }
            let pose = in_scene(draft, room, &pose);
            draft.places.push((door.name.clone(), [pose.x, pose.y, pose.z, pose.yaw]));
        }
    }
}

/// Where the bathroom of a hotel room is, seen from its middle: one comes in beside it.
fn bathroom(draft: &Draft, room: usize) -> Option<[f64; 2]> {
    let own = &draft.rooms[room];
    kinds::of(&own.kind).filter(|kind| draft.rooms.len() == 2 && kind.has_hung_screen())?;
    let other = &draft.rooms[1 - room];
    Some([other.at[0] - own.at[0], other.at[1] - own.at[1]])
}

/// Whether a door would be in the way of another opening, or that of it.
fn at_odds(draft: &Draft, room: usize, pose: &Pose, door: &Opening) -> bool {
    let own = in_scene(draft, room, pose);
    draft.openings.iter().any(|other| {
        draft.place_of(&other.name).is_some_and(|[x, _, z, yaw]| {
            let apart = (x - own.x).hypot(z - own.z);
            // Around a corner, at the end of a hall, two doors may be nearer.
            let round_corner = (yaw - own.yaw).rem_euclid(180.0) == 90.0;
            apart < if round_corner { AT_CORNER } else { (other.size[0] + door.size[0]) / 2.0 + 0.25 }
        })
    })
}

/// How many windows a wall of a room has room for, side by side at a distance from middle to middle, and the middle of the
/// first.
pub fn windows_in(draft: &Draft, room: usize, wall: Wall, n: usize, size: [f64; 3], step: f64) -> (usize, f64) {
    let longest = spans(draft, room, wall, None).into_iter().max_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)));
    let Some((low, high)) = longest else { return (0, 0.0) };
    let most = ((high - low - size[0] - 0.5) / step + 1.0).floor().max(0.0) as usize;
    let n = n.min(most);
    if n == 0 {
        return (0, 0.0);
    }
    if n == 1 && high - low < NARROW {
        return (n, low + MARGIN + size[0] / 2.0);
    }
    (n, (low + high) / 2.0 - step * (n as f64 - 1.0) / 2.0)
}

/// What a car and the ways round it need before a gate (metres).
const CAR: f64 = 5.9;

/// The floor of a room with the doors and windows that have a place.
pub fn floor(draft: &Draft, room: usize) -> Floor {
    let own = &draft.rooms[room];
    let mut floor = Floor::new(own.size);
    for opening in draft.openings.iter().filter(|o| o.rooms.contains(&room)) {
        let Some([x, y, z, yaw]) = draft.place_of(&opening.name) else { continue };
        let pose = Pose { x: x - own.at[0], y, z: z - own.at[1], yaw };
        match opening.kind {
            OpeningKind::Door if opening.category.is_some() => {
                floor.side_door(&pose, opening.size, crate::write::clear_space(opening));
            }
            OpeningKind::Door => floor.door(&pose, opening.size, crate::write::clear_space(opening)),
            OpeningKind::Window => floor.window(&pose, opening.size),
        }
    }
    floor
}
