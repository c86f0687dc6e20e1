//! For how many people a room is in which seats are asked for: "a meeting room with ten chairs".

use super::claim::{line, sit_at};
use super::groups;
use super::kinds::{self, Count, seats_all};
use super::stand::counts_as;
use crate::brief::{Brief, Group, Thing};

/// A room in which all seats belong to its tables is for as many people as there are seats, if nothing else is said.
pub fn people(brief: &mut Brief) {
    let mut gone = Vec::new();
    for at in 0..brief.rooms.len() {
        if brief.rooms[at].people.is_some() || brief.rooms[at].only {
            continue;
        }
        let Some(kind) = kinds::of(&brief.rooms[at].name) else { continue };
        let here: Vec<usize> = (0..brief.things.len()).filter(|i| brief.things[*i].room == at).collect();
        // "A boardroom with a table for sixteen".
        let is_one = |thing: &&Thing| thing.group == Group::Table && thing.number.said().is_none_or(|n| n == 1);
        let tables = here.iter().map(|i| &brief.things[*i]).filter(is_one);
        let places = tables.filter(|table| seats_all(kind, &table.name())).find_map(|table| table.places);
        if let Some(n) = places.filter(|n| *n as f64 > kind.people) {
            brief.rooms[at].people = Some(n);
            continue;
        }
        let mut seats = here.iter().filter(|i| brief.things[**i].group == Group::Seat);
        let (Some(&seat), None) = (seats.next(), seats.next()) else { continue };
        let thing = &brief.things[seat];
        let related = brief.facts.iter().any(|fact| {
            let objects = fact.what.objects().unwrap_or_default();
            fact.of.contains(&seat) || objects.contains(&seat)
        });
        let said = |noun: &str| {
            let absent = brief.absent.iter().any(|(name, _)| counts_as(noun, name));
            absent || here.iter().any(|i| counts_as(noun, &brief.things[*i].name()))
        };
        let Some(n) = thing.number.said() else { continue };
        let of_its_own = !related && thing.part.is_none();
        let at_line = line(kind, &thing.name(), n, &said).is_some_and(|line| sit_at(line, kind.dress));
        let more = n as f64 > kind.people && here.iter().any(|i| sits_around(&brief.things[*i].name(), kind.dress));
        // "A classroom with 24 seats": its desks have them.
        let by_people = kind.lines.iter().any(|line| matches!(line.count, Count::People(_)));
        if of_its_own && !at_line && by_people && thing.words == ["seat"] {
            brief.rooms[at].people = Some(n);
            gone.push(seat);
        } else if of_its_own && at_line || more {
            brief.rooms[at].people = Some(n);
        }
    }
    if !gone.is_empty() {
        brief.remove(&gone);
    }
}

/// Whether people sit around a thing of this name.
fn sits_around(noun: &str, dress: &str) -> bool {
    let parts = groups::of(noun, dress);
    parts.iter().any(|part| part.at.is_around())
}
