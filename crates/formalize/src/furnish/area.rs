//! Whether what is asked for fits beside each other on the floor, by area alone: what does not is said before any layout is
//! looked for.

use super::stand;
use crate::brief::Group;
use crate::draft::{Draft, DraftRoom, DraftThing, ThingOrigin};

/// A room whose size nobody gave becomes so many times as large while it is tried.
const GROWTH: f64 = 2.4;
/// What is lower than this lies under other things (metres).
const FLAT: f64 = 0.05;
/// So many kinds of things are named.
const NAMED: usize = 3;

/// A sentence about the first room whose floor is smaller than what is asked for and is to stand on it.
pub fn overfull(draft: &Draft) -> Option<String> {
    (0..draft.rooms.len()).find_map(|at| room_is_overfull(draft, at))
}

fn room_is_overfull(draft: &Draft, at: usize) -> Option<String> {
    let room = &draft.rooms[at];
    let most = floor(room) * if room.sized { 1.0 } else { GROWTH };
    let stands: Vec<&DraftThing> = draft
        .things
        .iter()
        .filter(|thing| thing.room == Some(at) && matches!(thing.source, ThingOrigin::Stated(_)))
        .filter(|thing| thing.size.is_some_and(|[_, h, _]| h > FLAT) && stand::on_floor(draft, thing))
        .collect();
    // Seats may stand under tables.
    let table = stands.iter().any(|thing| stand::group(&thing.category) == Group::Table);
    let counts = |thing: &&DraftThing| !table || stand::group(&thing.category) != Group::Seat;
    let area = |thing: &DraftThing| thing.size.map_or(0.0, |[w, _, d]| w * d) * thing.count as f64;
    let mut counted: Vec<(f64, &DraftThing)> =
        stands.into_iter().filter(counts).map(|thing| (area(thing), thing)).collect();
    let needed: f64 = counted.iter().map(|(area, _)| area).sum();
    if needed <= most {
        return None;
    }
    counted.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let said = counted.iter().take(NAMED).map(|(area, thing)| {
        let name = thing.category.replace('_', " ");
        if thing.count > 1 {
            format!("{} × {name} {area:.1} m²", thing.count)
        } else {
            format!("{name} {area:.1} m²")
        }
    });
    let said: Vec<String> = said.chain((counted.len() > NAMED).then(|| "…".to_owned())).collect();
    let has = if room.sized { "has" } else { "can have at most" };
    Some(format!(
        "the floor of `{}` {has} {most:.1} m², but the objects that stand on it need {needed:.1} m² ({})",
        room.name,
        said.join(", ")
    ))
}

/// Square metres: of an outline by Gauss's formula.
fn floor(room: &DraftRoom) -> f64 {
    let Some(corners) = &room.outline else { return room.size[0] * room.size[2] };
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|([x, z], [u, v])| x * v - u * z).sum::<f64>().abs() / 2.0
}
