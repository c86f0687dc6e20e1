//! Seats that are asked for without what they belong to: "a meeting room with ten chairs". They stand at the tables and
//! desks of such a room, and the room is for as many people.

use super::groups::{self, Where};
use super::kinds::{self, Count, Kind, Line};
use super::plan::Plan;
use super::stand::{self, counts_as};
use crate::brief::{Brief, Group};
use crate::draft::Source;

/// A room in which all seats belong to a table is for as many people as there are seats, if nothing else is said.
pub fn people(brief: &mut Brief) {
    for at in 0..brief.rooms.len() {
        if brief.rooms[at].people.is_some() || brief.rooms[at].only {
            continue;
        }
        let Some(kind) = kinds::of(&brief.rooms[at].name) else { continue };
        let here: Vec<usize> = (0..brief.things.len()).filter(|i| brief.things[*i].room == at).collect();
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
        if let (Some(line), false) = (line(kind, &thing.name(), &said), related || thing.part.is_some())
            && let Some(n) = thing.number.said()
            && fits(line, n)
        {
            brief.rooms[at].people = Some(n);
        }
    }
}

/// Whether a thing that is asked for is a seat that gets its place with something of the inventory.
pub fn wait(plan: &Plan, thing: usize) -> bool {
    line_of(plan, thing).is_some()
}

/// How many of a line's things there are for seats that are asked for and stand at them.
pub fn tables(plan: &Plan, line: &Line) -> Option<usize> {
    let seats = (0..plan.draft.things.len())
        .filter(|thing| plan.draft.things[*thing].room == Some(plan.room) && !plan.claimed.contains(thing))
        .find(|thing| line_of(plan, *thing) == Some(line))?;
    spread(line, plan.draft.things[seats].count)
}

/// The line of the inventory at which a seat that is asked for stands.
fn line_of(plan: &Plan, thing: usize) -> Option<&'static Line> {
    let it = &plan.draft.things[thing];
    let is_seat = matches!(it.source, Source::Stated(_)) && stand::group(&it.category) == Group::Seat;
    if plan.ground.is_none() || !is_seat || stand::placed(plan.draft, &it.name) {
        return None;
    }
    let said = |noun: &str| plan.is_closed(noun);
    line(plan.kind, &it.category.replace('_', " "), &said).filter(|line| fits(line, it.count))
}

/// Over how many of a line's things so many seats can be spread, as many at each as usual or fewer, but not one alone;
/// `None` where the line does not count people.
fn spread(line: &Line, seats: usize) -> Option<usize> {
    let Count::People(each) = line.count else { return None };
    let each = each as usize;
    (1..=each).rev().find(|k| seats.is_multiple_of(*k) && (*k > 1 || each == 1 || seats == 1)).map(|k| seats / k)
}

/// Whether so many seats can be spread evenly over what a line stands for.
fn fits(line: &Line, seats: usize) -> bool {
    match line.count {
        Count::Fixed(n) => n == 1,
        Count::People(_) => spread(line, seats).is_some(),
        Count::Area(_) => false,
    }
}

/// The line of an inventory at which seats of a name stand; none where such seats have a line of their own.
fn line(kind: &'static Kind, seat: &str, said: &dyn Fn(&str) -> bool) -> Option<&'static Line> {
    if kind.lines.iter().any(|line| counts_as(line.noun, seat)) {
        return None;
    }
    let seats = |at: &Where| matches!(at, Where::Row(..) | Where::Around(..) | Where::LongSides(..) | Where::Front(..));
    let usual = kind.size[0] * kind.size[2];
    kind.lines.iter().find(|line| {
        let parts = groups::of(line.noun, kind.dress);
        let mut parts = parts.iter().filter(|part| seats(&part.at) && stand::group(part.noun) == Group::Seat);
        line.least <= usual && !said(line.noun) && parts.any(|part| counts_as(part.noun, seat))
    })
}
