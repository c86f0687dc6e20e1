//! What is asked for becomes a draft of the program: names, sizes, places of rooms, and the statements of each fact.
//! It knows the language and its library, and no words.

mod clusters;
mod grid;
mod sizes;
mod state;
mod usual;

use crate::brief::{Brief, FactKind, Group, Look, Rel, too_many};
use crate::draft::{Draft, DraftRoom, DraftThing, ElementLook, Note, Opening, OpeningKind, Surface, ThingOrigin};
use crate::furnish::{GATE, kinds};
use crate::names::{GivenNames, identifier};
use crate::read::lexicon::MATERIALS_AND_SHADES;
use crate::sizes::SILL;

/// Kinds of rooms that have no ceiling.
const OPEN_AIR: [&str; 3] = ["balcony", "terrace", "garden"];

pub fn compose(brief: &Brief) -> Draft {
    let mut names = GivenNames::default();
    let sizes = sizes::things(brief);
    let mut room_sizes = sizes::rooms(brief, &sizes);
    let mut draft = Draft { request: brief.request.clone(), ..Draft::default() };
    let room_names = room_names(brief, &mut names);
    let mut sizes = sizes;
    sizes::fit_walls(brief, &mut sizes, &room_sizes);
    for (i, item) in brief.things.iter().enumerate().filter(|(_, item)| !item.opening() && item.part.is_none()) {
        let Some([w, h, d]) = room_sizes.get(item.room).copied() else { continue };
        // Its longer side lies along the longer side of the room.
        let (long, short) = (w.max(d) - 0.1, w.min(d) - 0.1);
        let (across, deep) = if sizes[i][0] < sizes[i][2] { (short, long) } else { (long, short) };
        let most = [across, h - 0.02, deep];
        if (0..3).any(|k| sizes[i][k] > most[k]) {
            (0..3).for_each(|k| sizes[i][k] = sizes[i][k].min(most[k].max(0.05)));
            if item.size.iter().any(Option::is_some) {
                draft.notes.push(Note {
                    at: item.source.at(),
                    reason: "it is larger than its room, so it is reduced to the largest size that fits".into(),
                });
            }
        }
    }
    draft.outdoor = brief.rooms.len() == 1
        && ["terrace", "balcony", "patio", "garden", "courtyard", "playground", "yard", "beer garden", "roof terrace"]
            .iter()
            .any(|o| brief.rooms[0].name.ends_with(o))
        || brief.rooms.len() == 1
            && (crate::storey::is_outside(&brief.rooms[0].name)
                || kinds::of(&brief.rooms[0].name).is_some_and(|kind| OPEN_AIR.contains(&kind.name)));
    let mut counts: Vec<usize> = (0..brief.things.len())
        .map(|i| if brief.things[i].opening() { brief.count(i).min(8) } else { brief.count(i) })
        .collect();
    let given = called(brief, &mut names, &counts, &mut sizes);
    for (count, given) in counts.iter_mut().zip(&given) {
        // At most as many openings as are made.
        if given.len() > 1 {
            *count = given.len();
        }
    }
    declare(brief, &given, &counts, &sizes, &room_sizes, &mut draft);
    draft.rooms = made_rooms(brief, &room_names, &room_sizes, &sizes);
    crate::storey::lay_out(&mut draft, brief, &mut names);
    for (size, room) in room_sizes.iter_mut().zip(&draft.rooms) {
        *size = room.size;
    }
    let named = state::Named { brief, names: given, counts, rooms: room_names, sizes, room_sizes };
    for (i, names) in named.names.iter().enumerate().filter(|(_, names)| names.len() == 1) {
        if let Some(thing) = draft.things.iter_mut().find(|thing| thing.name == names[0] && thing.count > 1) {
            thing.formation = named.formation(i);
        }
    }
    let mut stated = state::state(&named);
    windows(&named, &mut draft, &mut stated);
    draft.statements = stated.statements;
    draft.notes.extend(stated.notes);
    draft.notes.extend(limited(brief, &draft));
    for (name, at) in &brief.absent {
        if brief.things.iter().any(|i| i.name() == *name) {
            draft.notes.push(Note { at: at.clone(), reason: format!("\"{name}\" is requested elsewhere") });
        }
    }
    draft
}

/// What the rooms are called in the program; several of a name are told apart by numbers.
fn room_names(brief: &Brief, names: &mut GivenNames) -> Vec<String> {
    let wanted: Vec<String> = brief.rooms.iter().map(|room| identifier(&room.name, "room")).collect();
    let numbered = |at: usize| {
        let nth = wanted[..=at].iter().filter(|name| **name == wanted[at]).count();
        let several = wanted.iter().filter(|name| **name == wanted[at]).count() > 1;
        if several { format!("{}{nth}", wanted[at]) } else { wanted[at].clone() }
    };
    (0..wanted.len()).map(|at| names.take(&numbered(at))).collect()
}

/// What each thing is called in the program: an array by one name, of several doors each by its own.
fn called(brief: &Brief, names: &mut GivenNames, counts: &[usize], sizes: &mut [[f64; 3]]) -> Vec<Vec<String>> {
    let mut given: Vec<Vec<String>> = Vec::new();
    for (i, item) in brief.things.iter().enumerate() {
        let name = identifier(&item.name(), "thing");
        given.push(match &item.part {
            Some(part) => {
                sizes[i] = sizes[part.of];
                let of = |n: usize| match given[part.of].as_slice() {
                    _ if item.opening() => given[part.of].get(n).cloned(),
                    [one] if counts[part.of] == 1 => Some(one.clone()),
                    [set] => Some(format!("{set}[{n}]")),
                    _ => None,
                };
                brief.elements(part).into_iter().filter_map(of).collect()
            }
            // Several doors are told apart by numbers.
            None if item.opening() && counts[i] > 1 => {
                (1..=counts[i]).map(|n| names.take(&format!("{name}{n}"))).collect()
            }
            None => vec![names.take(&name)],
        });
    }
    given
}

/// Things, doors and windows.
fn declare(
    brief: &Brief,
    given: &[Vec<String>],
    counts: &[usize],
    sizes: &[[f64; 3]],
    room_sizes: &[[f64; 3]],
    draft: &mut Draft,
) {
    for (i, item) in brief.things.iter().enumerate().filter(|(_, item)| item.part.is_none()) {
        let source = item.source.clone();
        if item.opening() {
            let mut rooms = vec![item.room];
            rooms.extend(item.beyond);
            // The gate of a garden is no door for cars.
            let has_gate = brief
                .rooms
                .get(item.room)
                .and_then(|room| kinds::of(&room.name))
                .is_some_and(|kind| kind.gate.is_some());
            let kind = if item.group == Group::Door { OpeningKind::Door } else { OpeningKind::Window };
            for name in &given[i] {
                let mut size = sizes[i];
                let ceiling =
                    rooms.iter().filter_map(|r| room_sizes.get(*r)).map(|r| r[1]).fold(f64::INFINITY, f64::min);
                size[1] = size[1].min(ceiling - 0.1).max(0.3);
                size[2] = size[2].min(0.12);
                draft.openings.push(Opening {
                    name: name.clone(),
                    kind,
                    category: inner_or_goods(&item.name(), has_gate),
                    rooms: rooms.clone(),
                    size,
                    look: item.look.clone(),
                    source: source.clone(),
                });
            }
        } else {
            draft.things.push(DraftThing {
                name: given[i][0].clone(),
                category: item.of.iter().fold(item.words.join("_"), |name, of| format!("{name} {of}")),
                count: counts[i],
                room: Some(item.room),
                size: Some(sizes[i]),
                look: item.look.clone(),
                formation: Vec::new(),
                source,
            });
        }
    }
    told_apart(brief, given, draft);
}

/// The looks of things that are some of several: "the first chair is red".
fn told_apart(brief: &Brief, given: &[Vec<String>], draft: &mut Draft) {
    for (i, item) in brief.things.iter().enumerate().filter(|(_, item)| item.look != Look::default()) {
        let Some(part) = &item.part else { continue };
        let all = &brief.things[part.of].look;
        let look = Look {
            color: item.look.color.clone().filter(|color| all.color.as_ref() != Some(color)),
            material: item.look.material.clone().filter(|material| all.material.as_ref() != Some(material)),
            features: item.look.features.iter().filter(|feature| !all.features.contains(feature)).cloned().collect(),
        };
        if look == Look::default() {
            continue;
        }
        for (name, element) in given[i].iter().zip(brief.elements(part)) {
            match draft.openings.iter_mut().find(|opening| opening.name == *name) {
                Some(opening) => opening.look = look.clone(),
                None if name.ends_with(']') => {
                    draft.looks.push(ElementLook { of: given[part.of][0].clone(), element, look: look.clone() })
                }
                None => {}
            }
        }
    }
}

/// The rooms, not yet beside each other.
fn made_rooms(brief: &Brief, names: &[String], sizes: &[[f64; 3]], things: &[[f64; 3]]) -> Vec<DraftRoom> {
    let mut out = Vec::new();
    for (i, room) in brief.rooms.iter().enumerate() {
        let source = match &room.source {
            ThingOrigin::Stated(at) if at.is_empty() => ThingOrigin::Inferred("objects need a room to stand in".into()),
            source => source.clone(),
        };
        let sized = room.area.is_some() || room.size[0].is_some() && room.size[2].is_some();
        let [w, _, d] = sizes[i];
        let outline = room.corners.map(|n| polygon(n, w, d));
        out.push(DraftRoom {
            name: names[i].clone(),
            kind: room.name.clone(),
            at: [0.0; 2],
            size: sizes[i],
            sized,
            rows: sizes::rows(brief, things, i),
            outline,
            floor: floor(&room.floor),
            walls: surface(&room.walls),
            source,
        });
    }
    out
}

/// Numbers of things that follow from others, and sizes of rooms, that are not taken as they are.
fn limited(brief: &Brief, draft: &Draft) -> Vec<Note> {
    let mut out = Vec::new();
    for (i, item) in brief.things.iter().enumerate().filter(|(_, item)| item.number.follows() && item.part.is_none()) {
        let reason = too_many(brief.stated(i));
        out.extend(reason.map(|reason| Note { at: item.source.at(), reason }));
    }
    for (room, made) in brief.rooms.iter().zip(&draft.rooms) {
        for (said, is) in room.size.iter().zip(made.size) {
            let said = said.filter(|said| (said - is).abs() > 0.001);
            let reason = said.map(|said| format!("a room cannot have this size: {said} m is read as {is} m"));
            out.extend(reason.map(|reason| Note { at: room.source.at(), reason }));
        }
    }
    out
}

/// A window that something stands under begins above it.
fn windows(named: &state::Named, draft: &mut Draft, out: &mut state::Stated) {
    for fact in named.brief.facts.iter().filter(|f| !f.not) {
        let FactKind::Rel(Rel::Under, to) = &fact.what else { continue };
        for w in to.iter().filter(|w| named.brief.things[**w].group == Group::Window) {
            // It need not stand quite at the wall.
            let top = fact.of.iter().map(|a| named.sizes[*a][1]).fold(0.0, f64::max);
            let sill = ((top + 0.1) * 20.0).ceil() / 20.0;
            let ceiling = named.room_sizes.get(named.brief.things[*w].room).map_or(2.7, |s| s[1]);
            // Where the window begins if nothing is said.
            if sill <= ((ceiling - named.sizes[*w][1]) / 2.0).min(SILL) {
                continue;
            }
            for name in &named.names[*w] {
                if let Some(o) = draft.openings.iter_mut().find(|o| o.name == *name) {
                    o.size[1] = o.size[1].min(ceiling - sill - 0.1).max(0.3);
                }
                out.infer(
                    format!("assert {name}.bottom = {};", crate::write::number(sill)),
                    "the window sill is above the objects under the window",
                );
            }
        }
    }
}

/// A finish. "Brick" alone is a material, and a shade before a colour.
fn surface(look: &Look) -> Surface {
    let is_material = |word: &&String| MATERIALS_AND_SHADES.contains(&word.as_str());
    let material = look.material.clone().or_else(|| look.features.iter().find(is_material).cloned());
    Surface { color: look.color.clone(), material }
}

/// The finish of a floor: one of which it is said only that it is dark or light is of such wood.
fn floor(look: &Look) -> Surface {
    let Surface { color, material: None } = surface(look) else { return surface(look) };
    let shade = color.iter().chain(&look.features).find_map(|word| match word.as_str() {
        "dark" => Some("dark wood"),
        "light" | "pale" => Some("light wood"),
        _ => None,
    });
    match shade {
        Some(wood) => Surface { color: None, material: Some(wood.to_owned()) },
        None => Surface { color, material: None },
    }
}

/// An even polygon with a side at the front, within a width and a depth.
fn polygon(corners: usize, w: f64, d: f64) -> Vec<[f64; 2]> {
    let step = std::f64::consts::TAU / corners as f64;
    let reach = (step / 2.0).cos();
    (0..corners)
        .map(|i| {
            let angle = step * (i as f64 + 0.5);
            [angle.sin() * w / 2.0 / reach, angle.cos() * d / 2.0 / reach].map(|v| (v * 1e4).round() / 1e4)
        })
        .collect()
}

/// What a door that is asked for is, if it is no ordinary one: for cars and goods, or to the bathroom of a studio.
fn inner_or_goods(name: &str, has_gate: bool) -> Option<String> {
    const INNER: &str = "bathroom door";
    const GOODS: [&str; 6] =
        ["garage door", "roller door", "roller shutter", "loading door", "dock door", "loading gate"];
    let goods = GOODS.iter().any(|end| name.ends_with(end)) || has_gate && name == "gate";
    match name {
        _ if goods => Some(GATE.to_owned()),
        INNER => Some(INNER.to_owned()),
        _ => None,
    }
}
