//! What rooms of a kind have, for a request that says little: "a bedroom" is not an empty box.

use super::lexicon::{Group, Rel, get, plural, singular};
use super::noun::Place;
use super::number;
use super::scene::{Fact, Item, Scene, What};
use super::token::Token;
use crate::draft::Look;

/// A request that names fewer things says little.
const LITTLE: usize = 3;

/// Adds to each room with few things what such rooms have, as far as nothing of the kind is there or ruled out.
pub fn add(scene: &mut Scene) {
    let named = scene.items.iter().filter(|i| !i.opening() && i.part.is_none()).count();
    for room in 0..scene.rooms.len() {
        let own = scene.items.iter().filter(|i| i.room == room && !i.opening()).count();
        if own >= LITTLE || named >= LITTLE {
            continue;
        }
        let words: Vec<String> = scene.rooms[room].name.split(' ').map(str::to_owned).collect();
        let Some((_, kind)) = get().room_ending(&words) else { continue };
        for line in &kind.content {
            add_one(scene, room, kind.name, line);
        }
    }
    if named < LITTLE {
        for room in 0..scene.rooms.len() {
            if !scene.items.iter().any(|i| i.group == Group::Door && (i.room == room || i.beyond == Some(room))) {
                push(scene, room, "door", 1, "one has to get in");
            }
        }
    } else {
        joined(scene);
    }
}

/// For how many people: "for eight people", "seating ten guests".
fn persons(tokens: &[Token]) -> Option<usize> {
    const WHO: [&str; 10] = [
        "people",
        "persons",
        "guests",
        "participants",
        "attendees",
        "colleagues",
        "members",
        "employees",
        "visitors",
        "diners",
    ];
    const MOST: f64 = 40.0;
    (0..tokens.len()).filter(|&i| tokens[i].is("for") || tokens[i].is("seating")).find_map(|i| {
        let (n, words) = number::count(&tokens[i + 1..])?;
        let who = tokens.get(i + 1 + words)?;
        (n > 1.0 && n <= MOST && WHO.iter().any(|w| who.is(w))).then_some(n as usize)
    })
}

/// "A table for twelve people; the chairs …": so many chairs.
pub fn counted(scene: &mut Scene, tokens: &[Token]) {
    let Some(persons) = persons(tokens) else { return };
    let mut seats = scene.items.iter_mut().filter(|i| i.group == Group::Seat && i.part.is_none());
    if let (Some(seat), None) = (seats.next(), seats.next())
        && seat.many
        && seat.count.is_none()
        && seat.per.is_none()
    {
        seat.count = Some(persons);
    }
}

/// "For eight people": where there is a table and nothing is said of seats, so many chairs stand around it.
pub fn seats(scene: &mut Scene, tokens: &[Token]) {
    let persons = persons(tokens);
    let is_seat = |i: &Item| i.group == Group::Seat || i.words.last().is_some_and(|w| w == "bench");
    let ruled_out = scene.absent.iter().any(|(a, _)| ["chair", "seat"].iter().any(|seat| a.contains(seat)));
    let (Some(persons), false) = (persons, ruled_out || scene.items.iter().any(is_seat)) else { return };
    let Some(table) = scene.items.iter().position(|i| i.group == Group::Table && i.count.is_none_or(|n| n == 1)) else {
        return;
    };
    let id = push(scene, scene.items[table].room, "chair", persons, &format!("{persons} people sit there"));
    let what = What::Rel(Rel::Around, vec![table]);
    scene.facts.push(Fact { of: vec![id], what, soft: false, not: false, at: 0..0 });
}

/// Rooms that no door joins to the others get one.
pub fn joined(scene: &mut Scene) {
    for room in 1..scene.rooms.len() {
        let linked = scene
            .items
            .iter()
            .any(|i| i.group == Group::Door && i.beyond.is_some() && (i.room == room || i.beyond == Some(room)));
        if !linked {
            let id = push(scene, room - 1, "door", 1, "one has to get from room to room");
            scene.items[id].beyond = Some(room);
        }
    }
}

/// `2 nightstand beside bed`, `1 sofa against wall`, `1 table middle`.
fn add_one(scene: &mut Scene, room: usize, kind: &str, line: &str) {
    const RELATIONS: [(&str, Rel); 9] = [
        ("against", Rel::Against),
        ("in", Rel::In),
        ("beside", Rel::Beside),
        ("under", Rel::Under),
        ("around", Rel::Around),
        ("inFrontOf", Rel::InFrontOf),
        ("facing", Rel::Facing),
        ("near", Rel::Near),
        ("mounted", Rel::Mounted),
    ];
    let words: Vec<&str> = line.split(' ').collect();
    let count = words.first().and_then(|n| n.parse().ok()).unwrap_or(1);
    let at = words.iter().position(|w| RELATIONS.iter().any(|(k, _)| k == w) || *w == "middle");
    let name = words[1..at.unwrap_or(words.len())].join(" ");
    let lexicon = get();
    let find = |scene: &Scene, name: &str| {
        let head = name.split(' ').next_back().unwrap_or(name).to_owned();
        scene.items.iter().rposition(|i| {
            i.room == room && (i.name() == name || i.words.last() == Some(&head) || lexicon.alike(&i.head(), name))
        })
    };
    let ruled_out = scene.absent.iter().any(|(a, _)| name.contains(a.as_str()) || a.contains(&name));
    if find(scene, &name).is_some() || ruled_out {
        return;
    }
    let id = push(scene, room, &name, count, &format!("a {kind} has one"));
    let Some(at) = at else { return };
    let what = match (words[at], words.get(at + 1..).unwrap_or(&[]).join(" ")) {
        ("middle", _) => What::Place(Rel::In, Place::Middle, vec![]),
        (_, object) if object == "wall" => {
            What::Place(if words[at] == "mounted" { Rel::Mounted } else { Rel::Against }, Place::Wall, vec![])
        }
        (_, object) if object == "corner" => What::Place(Rel::In, Place::Corner, vec![]),
        (relation, object) => {
            let rel = RELATIONS.iter().find(|(k, _)| *k == relation).map(|r| r.1);
            match (rel, find(scene, &object)) {
                (Some(rel), Some(to)) if to != id => What::Rel(rel, vec![to]),
                _ => return,
            }
        }
    };
    scene.facts.push(Fact { of: vec![id], what, soft: false, not: false, at: 0..0 });
}

fn push(scene: &mut Scene, room: usize, name: &str, count: usize, why: &str) -> usize {
    let words: Vec<String> = name.split(' ').map(|w| if plural(w) { singular(w) } else { w.to_owned() }).collect();
    let (last, group) = get().noun_ending(&words).unwrap_or((1, Group::Floor));
    scene.items.push(Item {
        words,
        last,
        group,
        count: Some(count),
        per: None,
        many: count > 1,
        room,
        beyond: None,
        look: Look::default(),
        size: [None; 3],
        at: 0..0,
        inferred: Some(why.to_owned()),
        part: None,
        several: false,
        of: None,
    });
    scene.items.len() - 1
}
