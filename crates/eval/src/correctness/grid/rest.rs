//! What is not on the floor: on the tops of other things in rows, along the walls, under the ceiling. Doors and windows in the
//! middle of their walls.

use super::words::instance;
use crate::dataset::{DatasetScene, Object};
use scenelang_layout::{Layout, Placement};
use std::collections::BTreeMap;

/// Where things are, by name: the middle of the base, quarter turns.
type Spots = BTreeMap<String, ([f64; 3], usize)>;
/// How high the middle of what hangs on a wall is (metres).
const EYES: f64 = 1.5;
/// From what hangs to wall and ceiling (metres).
const TOUCH: f64 = 0.005;

/// Adds what is not there yet. What would be on something that was left out is left out.
pub(super) fn place(scene: &DatasetScene, start: &Layout, spots: &mut Spots) {
    links(scene, start, spots);
    let relation = |object: &Object| scene.relations.iter().find(|r| r.subject == object.name);
    let mut on: BTreeMap<String, f64> = BTreeMap::new();
    for (r, room) in scene.rooms.iter().enumerate() {
        let hung = scene.objects.iter().filter(|o| o.room == room.name);
        let hung: Vec<(&Object, &str, &str)> =
            hung.filter_map(|o| relation(o).map(|r| (o, r.relation.as_str(), r.object.as_str()))).collect();
        let of = |word: &str| hung.iter().filter(|h| h.1 == word).map(|h| h.0.count as usize).sum::<usize>();
        let (on_walls, on_ceiling) = (of("hung"), of("ceiling"));
        let (mut wall, mut ceiling) = (0, 0);
        for (object, word, target) in hung {
            for nth in 0..object.count {
                let name = instance(object, nth);
                let Some(own) = start.object(&name) else { continue };
                let spot = match word {
                    "hung" => {
                        wall += 1;
                        Some(along_walls(scene, r, own, (wall as f64 - 0.5) / on_walls as f64))
                    }
                    "ceiling" => {
                        ceiling += 1;
                        let x = room.x + room.size[0] * ((ceiling as f64 - 0.5) / on_ceiling as f64 - 0.5);
                        Some(([x, room.size[1] - own.scale.y, 0.0], 0))
                    }
                    "on" | "over" => beside(scene, start, spots, &mut on, (target, nth, word), own),
                    _ => None,
                };
                if let Some(spot) = spot {
                    spots.entry(name).or_insert(spot);
                }
            }
        }
    }
}

/// On a thing, beside what is on it already, or above it.
fn beside(
    scene: &DatasetScene,
    start: &Layout,
    spots: &Spots,
    on: &mut BTreeMap<String, f64>,
    (target, nth, word): (&str, u32, &str),
    own: &Placement,
) -> Option<([f64; 3], usize)> {
    let below = scene.objects.iter().find(|object| object.name == target)?;
    let carrier = instance(below, nth % below.count);
    let (at, turns) = *spots.get(&carrier)?;
    let body = start.object(&carrier)?;
    if word == "over" {
        let room = scene.rooms.iter().find(|room| room.name == below.room)?;
        return Some(([at[0], room.size[1] - own.scale.y, at[2]], turns));
    }
    // From the left to the right.
    let used = on.entry(carrier).or_insert(0.0);
    let along = (*used + own.scale.x / 2.0).min(body.scale.x - own.scale.x / 2.0) - body.scale.x / 2.0;
    *used += own.scale.x + 0.02;
    let right = [[1.0, 0.0], [0.0, -1.0], [-1.0, 0.0], [0.0, 1.0]][turns % 4];
    let top = body.surface.unwrap_or(body.scale.y);
    Some(([at[0] + right[0] * along, at[1] + top, at[2] + right[1] * along], turns))
}

/// At a share of the way along all four walls.
fn along_walls(scene: &DatasetScene, room: usize, own: &Placement, share: f64) -> ([f64; 3], usize) {
    let [w, h, d] = scene.rooms[room].size;
    let x0 = scene.rooms[room].x;
    let (deep, high) = (own.scale.z / 2.0 + TOUCH, (EYES - own.scale.y / 2.0).min(h - own.scale.y).max(0.0));
    let fit = |along: f64, length: f64| {
        let most = (length - own.scale.x).max(0.0) / 2.0;
        (along - length / 2.0).clamp(-most, most)
    };
    let way = share * 2.0 * (w + d);
    let ([x, z], turns) = if way < w {
        ([fit(way, w), deep - d / 2.0], 0)
    } else if way < w + d {
        ([w / 2.0 - deep, fit(way - w, d)], 3)
    } else if way < 2.0 * w + d {
        ([-fit(way - w - d, w), d / 2.0 - deep], 2)
    } else {
        ([deep - w / 2.0, -fit(way - 2.0 * w - d, d)], 1)
    };
    ([x0 + x, high, z], turns)
}

/// Doors and windows.
fn links(scene: &DatasetScene, start: &Layout, spots: &mut Spots) {
    let thickness = 0.015;
    for link in &scene.connections {
        let Some(room) = scene.rooms.iter().find(|room| room.name == link.between[0]) else { continue };
        if start.object(&link.name).is_none() {
            continue;
        }
        let [w, _, d] = room.size;
        let spot = match (link.kind.as_str(), link.between[1].as_str()) {
            ("window", _) => ([room.x, 0.9, d / 2.0 + thickness], 2),
            (_, "outside") => ([room.x, 0.0, -d / 2.0 - thickness], 0),
            _ => ([room.x + w / 2.0 + 2.0 * thickness, 0.0, 0.0], 1),
        };
        spots.insert(link.name.clone(), spot);
    }
}
