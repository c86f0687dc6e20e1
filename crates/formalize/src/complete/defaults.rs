//! What rooms of a kind have, for a request that says little: "a bedroom" is not an empty box.

use crate::brief::{Brief, Fact, Group, Look, Number, Place, Rel, Source, Thing, What};
use crate::read::lexicon::{get, plural, singular};

/// A request that names fewer things says little.
const LITTLE: usize = 3;

/// Adds to each room with few things what such rooms have, as far as nothing of the kind is there or ruled out.
pub fn add(brief: &mut Brief) {
    let named = brief.things.iter().filter(|i| !i.opening() && i.part.is_none()).count();
    for room in 0..brief.rooms.len() {
        let own = brief.things.iter().filter(|i| i.room == room && !i.opening()).count();
        if own >= LITTLE || named >= LITTLE {
            continue;
        }
        let words: Vec<String> = brief.rooms[room].name.split(' ').map(str::to_owned).collect();
        let Some((_, kind)) = get().room_ending(&words) else { continue };
        for line in &kind.content {
            add_one(brief, room, kind.name, line);
        }
    }
    if named < LITTLE {
        for room in 0..brief.rooms.len() {
            if !brief.things.iter().any(|i| i.group == Group::Door && (i.room == room || i.beyond == Some(room))) {
                push(brief, room, "door", 1, "one has to get in");
            }
        }
    } else {
        joined(brief);
    }
}

/// "A table for twelve people; the chairs …": so many chairs.
pub fn counted(brief: &mut Brief) {
    let Some(people) = brief.rooms.iter().find_map(|room| room.people) else { return };
    let mut seats = brief.things.iter_mut().filter(|i| i.group == Group::Seat && i.part.is_none());
    if let (Some(seat), None) = (seats.next(), seats.next())
        && seat.number == Number::Plural
    {
        seat.number = Number::Exactly(people);
    }
}

/// "For eight people": where there is a table and nothing is said of seats, so many chairs stand around it.
pub fn seats(brief: &mut Brief) {
    let people = brief.rooms.iter().find_map(|room| room.people);
    let is_seat = |i: &Thing| i.group == Group::Seat || i.words.last().is_some_and(|w| w == "bench");
    let ruled_out = brief.absent.iter().any(|(a, _)| ["chair", "seat"].iter().any(|seat| a.contains(seat)));
    let (Some(people), false) = (people, ruled_out || brief.things.iter().any(is_seat)) else { return };
    let one = |i: &Thing| i.number.said().is_none_or(|n| n == 1);
    let Some(table) = brief.things.iter().position(|i| i.group == Group::Table && one(i)) else { return };
    let why = format!("{people} people sit there");
    let id = push(brief, brief.things[table].room, "chair", people, &why);
    brief.facts.push(Fact::new(vec![id], What::Rel(Rel::Around, vec![table]), Source::Inferred(why)));
}

/// Rooms that no door joins to the others get one.
pub fn joined(brief: &mut Brief) {
    for room in 1..brief.rooms.len() {
        let linked = brief
            .things
            .iter()
            .any(|i| i.group == Group::Door && i.beyond.is_some() && (i.room == room || i.beyond == Some(room)));
        if !linked {
            let id = push(brief, room - 1, "door", 1, "one has to get from room to room");
            brief.things[id].beyond = Some(room);
        }
    }
}

/// `2 nightstand beside bed`, `1 sofa against wall`, `1 table middle`.
fn add_one(brief: &mut Brief, room: usize, kind: &str, line: &str) {
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
    let find = |brief: &Brief, name: &str| {
        let head = name.split(' ').next_back().unwrap_or(name).to_owned();
        brief.things.iter().rposition(|i| {
            i.room == room && (i.name() == name || i.words.last() == Some(&head) || lexicon.alike(&i.head(), name))
        })
    };
    let ruled_out = brief.absent.iter().any(|(a, _)| name.contains(a.as_str()) || a.contains(&name));
    if find(brief, &name).is_some() || ruled_out {
        return;
    }
    let id = push(brief, room, &name, count, &format!("a {kind} has one"));
    let Some(at) = at else { return };
    let what = match (words[at], words.get(at + 1..).unwrap_or(&[]).join(" ")) {
        ("middle", _) => What::Place(Rel::In, Place::Middle, vec![]),
        (_, object) if object == "wall" => {
            What::Place(if words[at] == "mounted" { Rel::Mounted } else { Rel::Against }, Place::Wall, vec![])
        }
        (_, object) if object == "corner" => What::Place(Rel::In, Place::Corner, vec![]),
        (relation, object) => {
            let rel = RELATIONS.iter().find(|(k, _)| *k == relation).map(|r| r.1);
            match (rel, find(brief, &object)) {
                (Some(rel), Some(to)) if to != id => What::Rel(rel, vec![to]),
                _ => return,
            }
        }
    };
    let why = brief.things[id].source.clone();
    brief.facts.push(Fact::new(vec![id], what, why));
}

fn push(brief: &mut Brief, room: usize, name: &str, count: usize, why: &str) -> usize {
    let words: Vec<String> = name.split(' ').map(|w| if plural(w) { singular(w) } else { w.to_owned() }).collect();
    let (last, group) = get().noun_ending(&words).unwrap_or((1, Group::Floor));
    brief.things.push(Thing {
        words,
        last,
        group,
        number: Number::Exactly(count),
        of: None,
        room,
        beyond: None,
        look: Look::default(),
        size: [None; 3],
        source: Source::Inferred(why.to_owned()),
        part: None,
    });
    brief.things.len() - 1
}
