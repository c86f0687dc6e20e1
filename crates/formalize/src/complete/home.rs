//! Homes and other buildings of several rooms: what a flat has that nobody names, a hall where there are many rooms, and
//! where things are that are said to be "in the flat".

use super::defaults::push;
use crate::brief::{Brief, FactKind, Group, Room, ThingOrigin};
use crate::furnish::kinds;
use crate::furnish::number::{Scale, scale as said_scale};
use crate::read::lexicon::get;
use crate::read::several::is_home;
use crate::storey;

/// From so many rooms on a home has a hall.
const HALL: usize = 4;
/// A home that is smaller is one room (square metres).
const STUDIO: f64 = 34.0;
/// A home with so many bedrooms has a second bathroom.
const MANY_BEDROOMS: usize = 4;
/// More bedrooms are not added.
const BEDROOMS: usize = 4;

/// Adds the rooms that a home has, and a hall where it is needed. How large the home is, compared with others.
pub fn complete(brief: &mut Brief) -> f64 {
    let mut scale = 1.0;
    let whole = brief.rooms.iter().position(|room| is_home(&room.name));
    if let Some(at) = whole.filter(|at| brief.rooms.len() > 1 || plain(brief, *at)) {
        let home = brief.rooms[at].clone();
        let people = home.people.unwrap_or(2);
        scale = match said_scale(brief, at) {
            Scale::Small => 0.85,
            Scale::Usual => 1.0,
            Scale::Large => 1.2,
        };
        usual(brief, people);
        divide(brief, at);
        fold(brief);
        hall(brief, HALL);
        scale *= share(brief, &home);
    } else {
        fold(brief);
        beside_annex(brief);
        let sized = brief.rooms.iter().any(|room| room.size.iter().any(Option::is_some) || room.corners.is_some());
        let joined = brief.things.iter().any(|thing| thing.beyond.is_some());
        if !sized && !joined {
            hall(brief, 2);
        }
    }
    baby(brief);
    scale
}

/// "For a couple with a baby": the second bedroom, if nothing is said of it, is for the baby, else a crib stands in the
/// parents' room.
fn baby(brief: &mut Brief) {
    const BABY: [&str; 3] = ["baby", "newborn", "infant"];
    const BEFORE: [&str; 4] = ["a", "their", "her", "his"];
    const CRIBS: [&str; 3] = ["crib", "cot", "cradle"];
    let request = brief.request.to_lowercase();
    // "A baby's bed" and "a baby monitor" are things; the baby ends its phrase.
    let mut phrases =
        request.split([',', '.', ';', ':']).flat_map(|phrase| phrase.split(" and ")).filter_map(|phrase| {
            let mut end = phrase.split_whitespace().rev();
            Some((end.next()?, end.next()?))
        });
    let said = |(last, before): (&str, &str)| BABY.contains(&last) && BEFORE.contains(&before);
    let has_crib = brief.things.iter().any(|thing| thing.words.last().is_some_and(|w| CRIBS.contains(&w.as_str())));
    if !phrases.any(said) || has_crib {
        return;
    }
    let is_bedroom = |at: &usize| kinds::of(&brief.rooms[*at].name).is_some_and(|kind| kind.name == "bedroom");
    let bedrooms: Vec<usize> = (0..brief.rooms.len()).filter(is_bedroom).collect();
    let (Some(first), false) = (bedrooms.first(), has(brief, &["nursery"])) else { return };
    let is_used = |at: &usize| brief.things.iter().any(|thing| thing.room == *at && thing.group == Group::Bed);
    match bedrooms[1..].iter().find(|at| !is_used(at) && brief.rooms[**at].name == "bedroom") {
        Some(at) => brief.rooms[*at].name = "nursery".into(),
        None => {
            push(brief, *first, "crib", 1, "a baby sleeps in a crib");
        }
    }
}

/// Makes rooms as much larger or smaller as their home is.
pub fn scale(brief: &mut Brief, scale: f64) {
    for room in brief.rooms.iter_mut().filter(|_| (scale - 1.0).abs() > 1e-9) {
        if let Some([w, _, d]) = &mut room.usual {
            (*w, *d) = (*w * scale.sqrt(), *d * scale.sqrt());
        }
    }
}

/// Whether a home of which no room is named becomes several: not if its sides or its shape are given.
fn plain(brief: &Brief, at: usize) -> bool {
    let room = &brief.rooms[at];
    let given = room.size[0].is_some() || room.size[2].is_some() || room.corners.is_some();
    !given && room.area.is_none_or(|area| area >= STUDIO)
}

fn has(brief: &Brief, kinds: &[&str]) -> bool {
    brief.rooms.iter().any(|room| kinds::of(&room.name).is_some_and(|kind| kinds.contains(&kind.name)))
}

fn add(brief: &mut Brief, name: &str, why: &str) {
    let ruled_out = brief.absent.iter().any(|(absent, _)| absent == name);
    if !ruled_out {
        brief.rooms.push(Room { name: name.into(), source: ThingOrigin::Inferred(why.into()), ..Room::default() });
    }
}

/// What a home has that nobody names.
fn usual(brief: &mut Brief, people: usize) {
    const SLEEP: [&str; 5] = ["bedroom", "kids room", "nursery", "dorm room", "studio apartment"];
    if !has(brief, &["living room", "studio apartment"]) {
        add(brief, "living room", "a home has a living room");
    }
    let cooks = brief.things.iter().any(|thing| thing.name() == "kitchen counter");
    if !cooks && !has(brief, &storey::KITCHENS) {
        add(brief, "kitchen", "a home has a kitchen");
    }
    if !has(brief, &SLEEP) {
        let bedrooms = 1 + people.saturating_sub(2).min(BEDROOMS - 1);
        for n in 0..bedrooms {
            let name = if n == 0 { "bedroom" } else { "kids room" };
            add(brief, name, "a home has a place to sleep");
        }
    }
    if !has(brief, &["bathroom"]) {
        let sleep = |room: &&Room| kinds::of(&room.name).is_some_and(|kind| SLEEP.contains(&kind.name));
        let bedrooms = brief.rooms.iter().filter(sleep).count();
        for _ in 0..1 + usize::from(bedrooms >= MANY_BEDROOMS) {
            add(brief, "bathroom", "a home has a bathroom");
        }
    }
    children(brief, people);
}

/// Of several bedrooms of which nothing more is said, all but the first are for the children of a family.
fn children(brief: &mut Brief, people: usize) {
    const PARENTS: usize = 2;
    let is_plain =
        |room: &Room| room.name == "bedroom" && room.people.is_none() && room.size.iter().all(Option::is_none);
    let used: Vec<usize> = brief.things.iter().map(|thing| thing.room).collect();
    let plain: Vec<usize> =
        (0..brief.rooms.len()).filter(|at| is_plain(&brief.rooms[*at]) && !used.contains(at)).collect();
    let Some((_, others)) = plain.split_first().filter(|(_, others)| !others.is_empty() && people > PARENTS) else {
        return;
    };
    if has(brief, &["kids room", "nursery"]) {
        return;
    }
    let mut left = people - PARENTS;
    for (i, at) in others.iter().enumerate() {
        let own = left.div_ceil(others.len() - i);
        if own > 0 {
            brief.rooms[*at].name = "kids bedroom".into();
            brief.rooms[*at].people = Some(own);
        }
        left -= own;
    }
}

/// What is in the home goes to the rooms where such things are; what is said of several things together keeps them together.
fn divide(brief: &mut Brief, at: usize) {
    for i in 0..brief.things.len() {
        if is_listed_beside(brief, at, i) {
            brief.things[i].room = at;
        }
    }
    let own: Vec<usize> = (0..brief.things.len()).filter(|i| brief.things[*i].room == at).collect();
    // What belongs together, by the smallest index.
    let mut group: Vec<usize> = (0..brief.things.len()).collect();
    let mut join = |a: usize, b: usize| {
        let (low, high) = (group[a].min(group[b]), group[a].max(group[b]));
        group.iter_mut().filter(|g| **g == high).for_each(|g| *g = low);
    };
    for (i, thing) in brief.things.iter().enumerate() {
        thing.part.iter().for_each(|part| join(i, part.of));
        if let Some(of) = brief.depends(i) {
            join(i, of);
        }
    }
    for fact in &brief.facts {
        let of: Vec<usize> = fact.of.iter().chain(fact.what.objects().unwrap_or(&[])).copied().collect();
        if !matches!(fact.what, FactKind::Gap(..)) || of.len() == 2 {
            of.windows(2).for_each(|pair| join(pair[0], pair[1]));
        }
    }
    let rooms: Vec<usize> = (0..brief.rooms.len()).filter(|room| *room != at).collect();
    let names: Vec<&str> = rooms.iter().map(|room| brief.rooms[*room].name.as_str()).collect();
    let hub = rooms[storey::hub(&names)];
    for i in own {
        let together: Vec<usize> = (0..group.len()).filter(|k| group[*k] == group[i]).collect();
        // Where something of it is in a room already, it is there, too.
        let there = together.iter().map(|k| brief.things[*k].room).find(|room| *room != at);
        let usual = || together.iter().find_map(|k| where_such_are(brief, &rooms, *k));
        let opening = brief.things[i].group == Group::Door;
        let room = if opening { hub } else { there.or_else(usual).unwrap_or(hub) };
        for k in together.into_iter().chain([i]) {
            if brief.things[k].room == at {
                brief.things[k].room = room;
            }
        }
    }
}

/// "A hotel room with a balcony, a bed and a sofa": what is listed with a second room, and what such a room never has, is in the
/// first one if such rooms have it.
fn beside_annex(brief: &mut Brief) {
    for i in 0..brief.things.len() {
        let room = brief.things[i].room;
        let usual = room > 0 && room < brief.rooms.len() && where_such_are(brief, &[0], i).is_some();
        if usual && is_in_list_with(brief, i) && where_such_are(brief, &[room], i).is_none() {
            brief.things[i].room = 0;
        }
    }
}

/// "A house with a kitchen, a sofa and a bed": what is listed with a room, and what such a room never has, is in the house.
fn is_listed_beside(brief: &Brief, home: usize, thing: usize) -> bool {
    if brief.things[thing].room == home || !is_in_list_with(brief, thing) {
        return false;
    }
    let room = brief.things[thing].room;
    let others: Vec<usize> = (0..brief.rooms.len()).filter(|other| *other != home && *other != room).collect();
    where_such_are(brief, &[room], thing).is_none() && where_such_are(brief, &others, thing).is_some()
}

/// Whether a thing is named after its room in the same list, and nothing says that it is in that room.
fn is_in_list_with(brief: &Brief, thing: usize) -> bool {
    const OF_ITS_OWN: [&str; 8] = [" with ", " has ", " having ", " in ", " containing ", " including ", " its ", "."];
    let it = &brief.things[thing];
    if it.part.is_some() || it.opening() {
        return false;
    }
    let between = brief.rooms[it.room].source.at().end..it.source.at().start;
    let said = brief.request.get(between).map(str::to_lowercase);
    said.is_some_and(|said| said.starts_with([',', ' ']) && !OF_ITS_OWN.iter().any(|word| said.contains(word)))
}

/// The room whose kind has such a thing.
fn where_such_are(brief: &Brief, rooms: &[usize], thing: usize) -> Option<usize> {
    let head = brief.things[thing].head();
    let name = brief.things[thing].name();
    let has = |room: &&usize| {
        let kind = kinds::of(&brief.rooms[**room].name);
        kind.is_some_and(|kind| {
            let mut nouns = kind.lines.iter().map(|line| line.noun);
            nouns.any(|noun| noun == name || noun == head || noun.ends_with(&format!(" {head}")))
        })
    };
    rooms.iter().find(has).copied()
}

/// A building is no room beside its rooms: what is in it goes to the one that leads to the others.
pub fn fold(brief: &mut Brief) {
    let is_building = |room: &Room| get().room(&room.name).is_some_and(|kind| kind.name == "apartment");
    let Some(at) = brief.rooms.iter().position(is_building).filter(|_| brief.rooms.len() > 1) else { return };
    let names: Vec<&str> = brief.rooms.iter().map(|room| room.name.as_str()).collect();
    let others: Vec<usize> = (0..names.len()).filter(|room| *room != at).collect();
    let other_names: Vec<&str> = others.iter().map(|room| names[*room]).collect();
    let hub = others[storey::hub(&other_names)];
    let moved = |room: usize| {
        let room = if room == at { hub } else { room };
        room - usize::from(room > at)
    };
    for thing in &mut brief.things {
        thing.room = moved(thing.room);
        thing.beyond = thing.beyond.map(moved);
    }
    brief.rooms.remove(at);
}

/// Adds a hall where there are so many rooms and none that leads to the others; where people pass through one already, from
/// four on.
fn hall(brief: &mut Brief, least: usize) {
    let owned = |room: usize| {
        let mut with = brief.things.iter().filter(|t| t.beyond.is_some() && (t.beyond == Some(room) || t.room == room));
        let from = with.next().filter(|door| door.beyond == Some(room)).map(|door| door.room);
        from.is_some_and(|from| !storey::is_passage(&brief.rooms[from].name)) && with.next().is_none()
    };
    let own =
        (0..brief.rooms.len()).filter(|room| owned(*room) && !storey::is_passage(&brief.rooms[*room].name)).count();
    let count = brief.rooms.len() - own;
    let leads = brief.rooms.iter().any(|room| storey::is_passage(&room.name));
    let home = brief.rooms.iter().all(|room| kinds::of(&room.name).is_some_and(|kind| kind.home.is_some()));
    if count < if leads { HALL } else { least } || leads && !home || has(brief, &["hallway", "reception"]) {
        return;
    }
    let name = if home { "hall" } else { "corridor" };
    add(brief, name, "it connects the rooms");
}

/// How much of what such rooms have together a home has.
fn share(brief: &Brief, home: &Room) -> f64 {
    let area = home.area.or_else(|| Some(home.size[0]? * home.size[2]?));
    let Some(area) = area else { return 1.0 };
    let usual = |room: &Room| kinds::of(&room.name).and_then(|kind| kind.home).map_or(0.0, |[area, ..]| area);
    let together: f64 = brief.rooms.iter().map(usual).sum();
    if together > 0.0 { (area / together).clamp(0.6, 2.0) } else { 1.0 }
}
