//! The outlines of the regions, given what they are connected by; their walls 2η apart.
//!
//! The model gives vertices and, as published, by how much to shift each region so that neighbours stand 2η apart.
//! Whether they do is measured; where they do not, the rooms are arranged by their doors.

use super::ask::{Asker, PLACE, Trouble, length, list, object};
use super::sentences::Sentences;
use crate::arrange::{WALL, arrange_rooms, is_arranged};
use crate::draft::Draft;
use serde::Deserialize;
use serde_json::json;

/// How long and how high a region can be (metres).
const LENGTHS: [f64; 2] = [0.8, 200.0];
const HEIGHTS: [f64; 2] = [2.0, 30.0];
/// More vertices than these are no outline of a room.
const MOST: usize = 32;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PlaceAnswer {
    regions: Vec<Region>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Region {
    name: String,
    height: f64,
    vertices: Vec<Point>,
    shift: Point,
    /// Whether the request gives the size.
    stated: bool,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Point {
    x: f64,
    z: f64,
}

/// Sets sizes, places and outlines.
pub(super) fn place(asker: &mut Asker<'_>, sentences: &Sentences, draft: &mut Draft) -> Result<(), Trouble> {
    let number = || json!({ "type": "number" });
    let point = object(&json!({ "x": number(), "z": number() }));
    let region = object(&json!({
        "name": { "type": "string" },
        "height": number(),
        "vertices": list(&point),
        "shift": point,
        "stated": { "type": "boolean" },
    }));
    let regions: Vec<_> = draft.rooms.iter().map(|room| json!({ "name": room.name, "kind": room.kind })).collect();
    let connections: Vec<_> = draft
        .openings
        .iter()
        .map(|opening| {
            let between: Vec<&str> = opening.rooms.iter().map(|room| draft.rooms[*room].name.as_str()).collect();
            json!({ "name": opening.name, "between": between, "width": opening.size[0] })
        })
        .collect();
    let known = json!({
        "regions": regions,
        "connections": connections,
        "distance_of_neighbours": WALL,
        "outdoor": draft.outdoor,
        "sentences": sentences.told(None),
    });
    let answer: PlaceAnswer = asker.ask(PLACE, object(&json!({ "regions": list(&region) })), &known)?;
    for room in &mut draft.rooms {
        let Some(region) = answer.regions.iter().find(|region| region.name == room.name) else { continue };
        let usual = room.size[1];
        room.size[1] = length(region.height, HEIGHTS, usual);
        let points = region.vertices.iter().map(|p| [p.x + region.shift.x, p.z + region.shift.z]);
        let points: Vec<[f64; 2]> = points.map(|p| p.map(|v| (v * 1e4).round() / 1e4)).collect();
        let far = |v: f64| !(v.is_finite() && v.abs() <= 10.0 * LENGTHS[1]);
        if points.len() < 3 || points.len() > MOST || points.iter().flatten().any(|v| far(*v)) {
            asker.diagnostics.push(format!("the outline of {} cannot be used, so the usual size is taken", room.name));
            continue;
        }
        let bound = |axis: usize| {
            let along = points.iter().map(|point| point[axis]);
            along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
        };
        let [x, z] = [bound(0), bound(1)];
        room.at = [(x.0 + x.1) / 2.0, (z.0 + z.1) / 2.0];
        (room.size[0], room.size[2]) = (length(x.1 - x.0, LENGTHS, usual), length(z.1 - z.0, LENGTHS, usual));
        room.sized = region.stated;
        let kept = room.size[0] == length(x.1 - x.0, [0.0, f64::MAX], 0.0)
            && room.size[2] == length(z.1 - z.0, [0.0, f64::MAX], 0.0);
        let corner = |p: &[f64; 2]| (p[0] == x.0 || p[0] == x.1) && (p[1] == z.0 || p[1] == z.1);
        let rectangle = points.len() == 4 && points.iter().all(corner);
        room.outline = (kept && !rectangle && is_simple(&points)).then_some(points);
    }
    Ok(())
}

/// Puts neighbours 2η apart where they are not.
pub(super) fn separate(draft: &mut Draft) {
    if !is_arranged(draft) {
        arrange_rooms(draft);
    }
}

/// Whether an outline does not cross or touch itself, and has an area.
fn is_simple(points: &[[f64; 2]]) -> bool {
    let count = points.len();
    let turn = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let edge = |i: usize| (points[i], points[(i + 1) % count]);
    let crosses = |i: usize, j: usize| {
        let ((a, b), (c, d)) = (edge(i), edge(j));
        let apart = (0..2).any(|k| a[k].max(b[k]) < c[k].min(d[k]) || c[k].max(d[k]) < a[k].min(b[k]));
        !apart && turn(a, b, c) * turn(a, b, d) <= 0.0 && turn(c, d, a) * turn(c, d, b) <= 0.0
    };
    let neighbours = |i: usize, j: usize| (i + 1) % count == j || (j + 1) % count == i;
    let flat = |i: usize| turn(points[i], points[(i + 1) % count], points[(i + 2) % count]).abs() < 1e-6;
    !(0..count).any(|i| flat(i) || (i + 1..count).any(|j| !neighbours(i, j) && crosses(i, j)))
}

#[cfg(test)]
mod tests {
    use super::is_simple;

    #[test]
    fn outlines_that_cross_themselves_are_none() {
        assert!(is_simple(&[[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 2.0], [2.0, 4.0], [0.0, 4.0]]));
        assert!(!is_simple(&[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]]));
        assert!(!is_simple(&[[0.0, 0.0], [4.0, 0.0], [2.0, 0.0]]));
    }
}
