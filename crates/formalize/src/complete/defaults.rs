//! What follows from what is said: seats for people, a fence around a robot.

use crate::brief::{Brief, Fact, FactKind, Group, Look, Number, Rel, Thing, ThingOrigin};
use crate::furnish::{FENCED, kinds, seats_at, stand};
use crate::read::lexicon::{get, plural, singular};

/// So many sit in a booth.
pub const AT_BOOTH: usize = 4;

/// How many sit on a seat, and at the table that goes with it.
fn sit_on(seat: &Thing) -> usize {
    match seat.words.last().map_or("", String::as_str) {
        "booth" => AT_BOOTH,
        "sofa" | "couch" | "bench" => 3,
        _ => 1,
    }
}

/// "A table for twelve people; the chairs …": so many chairs. "Booths for twelve" are three.
pub fn counted(brief: &mut Brief) {
    let Some(people) = brief.rooms.iter().find_map(|room| room.people) else { return };
    // In a restaurant with booths half of the guests sit at tables.
    let rooms: Vec<bool> =
        brief.rooms.iter().map(|room| kinds::of(&room.name).is_some_and(kinds::has_tables)).collect();
    let mut seats = brief.things.iter_mut().filter(|i| i.group == Group::Seat && i.part.is_none() && !is_lain_on(i));
    if let (Some(seat), None) = (seats.next(), seats.next())
        && seat.number == Number::Plural
    {
        let shares = sit_on(seat) == AT_BOOTH && seat.places.is_none() && rooms.get(seat.room) == Some(&true);
        let people = if shares { people.div_ceil(2) } else { people };
        seat.number = Number::Exactly(people.div_ceil(sit_on(seat)));
    }
}

/// Whether one lies on it: nobody sits at a table there.
fn is_lain_on(seat: &Thing) -> bool {
    const LAIN_ON: [&str; 12] = [
        "lounger", "daybed", "hammock", "chaise", "recliner", "futon", "beanbag", "beanbags", "bean", "armchair",
        "pouf", "ottoman",
    ];
    seat.words.iter().any(|word| LAIN_ON.contains(&word.as_str()))
}

/// Whether people eat at it.
fn is_dined_at(table: &Thing) -> bool {
    matches!(table.name().as_str(), "dining table" | "kitchen table")
        || table.places.is_some() && table.head().ends_with("table")
}

/// Whether a seat is no chair at a table.
fn is_soft(seat: &Thing) -> bool {
    const SOFT: [&str; 9] =
        ["sofa", "couch", "settee", "armchair", "loveseat", "recliner", "beanbag", "pouf", "ottoman"];
    seat.words.last().is_some_and(|last| SOFT.contains(&last.as_str())) || stand::is_easy(&seat.name())
}

/// Tables at which nobody sits with others.
const FOR_ONE: [&str; 9] =
    ["dressing", "vanity", "makeup", "changing", "coffee", "side", "console", "bedside", "ironing"];
/// At a sideboard or a dresser nobody sits at all.
const SAT_AT: [&str; 5] = ["table", "desk", "island", "counter", "bar"];
/// So many sit at an island.
const AT_ISLAND: usize = 3;
/// So many sit at each of several tables.
const AT_TABLE: usize = 4;
/// So many sit at a bar; a larger party sits at tables.
const AT_BAR: usize = 10;

/// "For eight people": where there is a table and nothing is said of seats, so many chairs stand around it.
pub fn seats(brief: &mut Brief) {
    share_places(brief);
    seats_at_each(brief);
    gather_on_floor(brief);
    let people = brief.rooms.iter().find_map(|room| room.people);
    let is = |i: &Thing, noun: &str| i.words.last().is_some_and(|w| w == noun);
    // A baby sits in a chair of its own.
    let is_seat = |i: &Thing| i.group == Group::Seat && !is(i, "highchair") && !is_lain_on(i) || is(i, "bench");
    let ruled_out = brief.absent.iter().any(|(a, _)| ["chair", "seat"].iter().any(|seat| a.contains(seat)));
    // Nobody eats on a sofa where there is a table for it.
    let dines = brief.things.iter().any(|i| i.number.said().is_none_or(|n| n == 1) && is_dined_at(i));
    let is_seat = |i: &Thing| is_seat(i) && !(dines && is_soft(i));
    let (Some(people), false) = (people, ruled_out || brief.things.iter().any(is_seat)) else { return };
    let open = |i: &Thing| brief.rooms.get(i.room).is_none_or(|room| !room.only);
    let one = |i: &Thing| i.number.said().is_none_or(|n| n == 1);
    // Who works or eats elsewhere in such rooms does not sit at every table.
    let seats_all = |i: &Thing| {
        let kind = brief.rooms.get(i.room).and_then(|room| kinds::of(&room.name));
        kind.is_none_or(|kind| kinds::seats_all(kind, &i.name()))
    };
    // A couple does not sit at the desk of its bedroom, nor at its dressing table.
    let for_one = |i: &Thing| i.words.iter().any(|word| FOR_ONE.contains(&word.as_str()));
    let seats_all = |i: &Thing| seats_all(i) || i.places.is_some() && i.head().ends_with("table");
    let works = |i: &Thing| i.places.is_none() && (i.words.last().is_some_and(|word| word == "desk") || for_one(i));
    let sat_at = |i: &Thing| i.words.last().is_some_and(|word| SAT_AT.iter().any(|end| word.ends_with(end)));
    let is_bar = |i: &Thing| people > AT_BAR && i.words.last().is_some_and(|word| word == "bar" || word == "counter");
    let sits = |i: &Thing| {
        i.group == Group::Table && sat_at(i) && one(i) && open(i) && seats_all(i) && !works(i) && !is_bar(i)
    };
    let why = format!("{people} people sit there");
    let is_island = |i: &Thing| i.words.last().is_some_and(|word| word == "island");
    // A table rather than a counter.
    let is_table = |i: &Thing| i.words.last().is_some_and(|word| word.ends_with("table"));
    let first = |is: &dyn Fn(&Thing) -> bool| brief.things.iter().position(|i| sits(i) && !is_island(i) && is(i));
    let table = match first(&is_table).or_else(|| first(&|_| true)) {
        Some(table) => table,
        // An island has stools for a few; a family also has a table.
        None => {
            let Some(island) = brief.things.iter().find(|i| sits(i) && people > AT_ISLAND) else { return };
            push(brief, island.room, "kitchen table", 1, &why)
        }
    };
    // "A desk for two": side by side.
    if people == 2 && is(&brief.things[table], "desk") {
        brief.things[table].look.features.push("shared".into());
        return;
    }
    // "Tables for sixty people": as many as they need.
    if brief.things[table].number == Number::Plural && people > 2 * AT_TABLE {
        brief.things[table].number = Number::Exactly(people.div_ceil(AT_TABLE));
        brief.things[table].places = Some(AT_TABLE);
        seats_at_each(brief);
        return;
    }
    let id = push(brief, brief.things[table].room, "chair", people, &why);
    brief.facts.push(Fact::new(vec![id], FactKind::Rel(Rel::Around, vec![table]), ThingOrigin::Inferred(why)));
}

/// "For 80 guests with ten round tables": eight sit at each.
fn share_places(brief: &mut Brief) {
    const AT_EACH: std::ops::RangeInclusive<usize> = 3..=12;
    let Some((room, people)) = brief.rooms.iter().enumerate().find_map(|(at, room)| Some((at, room.people?))) else {
        return;
    };
    let is_table =
        |i: &Thing| i.room == room && i.group == Group::Table && i.head().ends_with("table") && i.part.is_none();
    let tables: Vec<usize> = (0..brief.things.len()).filter(|at| is_table(&brief.things[*at])).collect();
    let [table] = tables[..] else { return };
    let thing = &mut brief.things[table];
    let each = thing.number.said().filter(|n| *n > 1 && people.is_multiple_of(*n)).map(|n| people / n);
    if let Some(each) = each.filter(|each| AT_EACH.contains(each) && thing.places.is_none()) {
        thing.places = Some(each);
    }
}

/// Several bean bags of which nothing else is said stand around a low table.
fn gather_on_floor(brief: &mut Brief) {
    const SEVERAL: std::ops::RangeInclusive<usize> = 2..=4;
    let is_bag = |thing: &Thing| matches!(thing.name().as_str(), "bean bag" | "beanbag");
    let Some(bags) = brief.things.iter().position(is_bag) else { return };
    let room = brief.things[bags].room;
    let is_said = brief.facts.iter().any(|fact| fact.of.contains(&bags) && fact.what.objects().is_some());
    let is_open = brief
        .rooms
        .get(room)
        .is_some_and(|room| !room.only && kinds::of(&room.name).is_some_and(|kind| kind.dress != "kids"));
    let n = brief.count(bags);
    if is_said || !is_open || !SEVERAL.contains(&n) {
        return;
    }
    push(brief, room, "round lounge table", 1, &format!("{n} people sit there"));
}

/// "Six tables for eight": so many chairs at each, where nothing is said of seats.
fn seats_at_each(brief: &mut Brief) {
    let here = |room: usize, i: &Thing| i.room == room && i.group == Group::Seat && !is_soft(i);
    let table =
        brief.things.iter().position(|i| i.seats_each() && !brief.things.iter().any(|other| here(i.room, other)));
    let Some(table) = table.filter(|table| !brief.rooms[brief.things[*table].room].only) else { return };
    let (n, each, room) = (brief.count(table), brief.things[table].places.unwrap_or(1), brief.things[table].room);
    let (usual, seat) = seats_at(&brief.rooms[room].name, &brief.things[table].name()).unwrap_or((0, "chair"));
    if usual < each {
        push(brief, room, seat, n * each, &format!("{each} people sit there"));
    }
}

/// The robot of a cell works behind a fence. Several share one only where the request says how.
pub fn fence(brief: &mut Brief) {
    for room in 0..brief.rooms.len() {
        let is_cell = kinds::of(&brief.rooms[room].name).is_some_and(|kind| kind.name == "robot cell");
        let here = |thing: &&Thing| thing.room == room;
        let is_robot =
            |thing: &&Thing| thing.words.iter().any(|w| w.starts_with("robot") || w == "cobot" || w == "arm");
        let robots: usize =
            brief.things.iter().filter(here).filter(is_robot).map(|t| t.number.said().unwrap_or(2)).sum();
        let is_fence = |name: &str| ["fence", "cage", "barrier"].iter().any(|fence| name.contains(fence));
        let said = brief.things.iter().filter(here).any(|thing| is_fence(&thing.name()))
            || brief.absent.iter().any(|(name, _)| is_fence(name));
        if is_cell && robots == 1 && !said && !brief.rooms[room].only {
            push(brief, room, "safety fence", 1, FENCED);
        }
    }
}

/// Adds things that nobody asked for; the index of them.
pub(crate) fn push(brief: &mut Brief, room: usize, name: &str, count: usize, why: &str) -> usize {
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
        places: None,
        look: Look::default(),
        size: [None; 3],
        source: ThingOrigin::Inferred(why.to_owned()),
        part: None,
    });
    brief.things.len() - 1
}
