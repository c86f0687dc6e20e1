//! Statements that say something else than the request: worse than what is missing, since they look as if they were asked
//! for.
//!
//! A statement that says to come from the request is wrong if it
//! - says a relation of the ground truth the other way round (`on(table, lamp)` for a lamp on a table),
//! - claims what the ground truth denies, or denies what it claims,
//! - says the opposite (`leftOf` for `rightOf`),
//! - speaks of a thing that is in no way asked for,
//! - says of a thing that it is in another room than its own,
//! - connects two rooms between which the ground truth has no way.
//!
//! What the ground truth does not speak of is not known to be wrong.

use crate::expect::Expectation;
use crate::score::Share;
use crate::told::{Argument, ProgramOutline, Said, Statement};

/// The ground truth beside a program, with what is what.
pub struct Truth<'a> {
    pub expect: &'a Expectation,
    pub told: &'a ProgramOutline,
    /// Of each room of the ground truth, the region.
    pub rooms: &'a [Option<usize>],
    /// Of each object of the ground truth, the thing of the program.
    pub things: &'a [Option<usize>],
}

/// Relations that mean the same here, each with its opposite.
const FAMILIES: [(&[&str], &[&str]); 6] = [
    (&["on", "restsOn"], &["under", "below"]),
    (&["above", "over"], &["under", "below"]),
    (&["leftOf", "seenLeftOf"], &["rightOf", "seenRightOf"]),
    (&["inFrontOf"], &["behind"]),
    (&["inside"], &[]),
    (&["facing", "looksAt"], &[]),
];

/// The names that say the same as a predicate, and those that say the opposite; `None`: it has no direction.
fn family(name: &str) -> Option<(&'static [&'static str], &'static [&'static str])> {
    FAMILIES.iter().find_map(|(same, opposite)| match name {
        name if same.contains(&name) => Some((*same, *opposite)),
        name if opposite.contains(&name) => Some((*opposite, *same)),
        _ => None,
    })
}

impl Truth<'_> {
    /// The ways between two rooms that the program has.
    pub fn connections(&self, misses: &mut Vec<String>) -> Share {
        let two = self.expect.connections.iter().filter(|c| self.ends(&c.between).is_some());
        Share::of(two, |connection| {
            let ends = self.ends(&connection.between);
            let is = self.told.statements.iter().flat_map(|s| &s.said).any(|said| connects(said) == ends);
            if !is {
                misses.push(format!("no way: {}", connection.between.join(" to ")));
            }
            is
        })
    }

    /// The statements that contradict the ground truth.
    pub fn wrong(&self, misses: &mut Vec<String>) -> Share {
        let stated = self.told.statements.iter().filter(|s| s.asks && s.stated);
        Share::of(stated, |statement| {
            let why = self.why(statement);
            if let Some(why) = &why {
                misses.push(format!("wrong: {why}"));
            }
            why.is_some()
        })
    }

    fn why(&self, statement: &Statement) -> Option<String> {
        let unasked = statement.things.iter().find(|t| !self.things.contains(&Some(**t)) && !self.opening(**t));
        if let Some(thing) = unasked {
            return Some(format!("of {}, which was not requested", self.told.things[*thing].name));
        }
        statement
            .said
            .iter()
            .find_map(|said| self.way(said).or_else(|| self.room(said)).or_else(|| self.relation(said)))
    }

    /// Whether a thing of the program is a door or a window: the ground truth names those that connect rooms elsewhere.
    fn opening(&self, thing: usize) -> bool {
        let name = self.told.things[thing].name.to_lowercase();
        name.contains("door") || name.contains("window")
    }

    fn way(&self, said: &Said) -> Option<String> {
        let (a, b) = connects(said)?;
        let known = |region| self.rooms.contains(&Some(region));
        let asked = self.expect.connections.iter().any(|c| self.ends(&c.between) == Some((a, b)));
        let judged = known(a) && known(b) && !said.denied;
        (judged && !asked).then(|| "a connection between rooms that should have none".to_owned())
    }

    fn room(&self, said: &Said) -> Option<String> {
        let places = ["inside", "onFloor", "againstWall", "inCorner", "wallMounted", "ceilingMounted", "centeredIn"];
        let [Argument::Thing(thing), Argument::Region(region)] = said.of[..] else { return None };
        let object = &self.expect.objects[self.things.iter().position(|t| *t == Some(thing))?];
        let own = self.rooms[self.expect.rooms.iter().position(|r| r.name == object.room)?]?;
        let other = places.contains(&said.name.as_str()) && !said.denied && own != region;
        (other && self.rooms.contains(&Some(region))).then(|| format!("{} in another room", object.name))
    }

    fn relation(&self, said: &Said) -> Option<String> {
        let [Argument::Thing(a), Argument::Thing(b)] = said.of[..2] else { return None };
        let name = |thing| Some(self.expect.objects[self.things.iter().position(|t| *t == Some(thing))?].name.as_str());
        let (a, b) = (name(a)?, name(b)?);
        let own = [said.name.as_str()];
        let (same, opposite) = family(&said.name).unwrap_or((&[], &[]));
        let same = if same.is_empty() { &own[..] } else { same };
        let holds = |subject: &str, object: &str, names: &[&str], denied: bool| {
            self.expect.relations.iter().any(|r| {
                let (not, relation) =
                    r.relation.strip_prefix("not_").map_or((false, &*r.relation), |name| (true, name));
                not == denied
                    && names.contains(&relation)
                    && r.subject.all().iter().any(|n| n == subject)
                    && r.object.all().iter().any(|n| n == object)
            })
        };
        let told = || format!("{a} {} {b}", said.name);
        if holds(a, b, same, said.denied) {
            return None;
        }
        if holds(a, b, same, !said.denied) {
            return Some(format!("{}, but the contrary was requested", told()));
        }
        if said.denied || family(&said.name).is_none() {
            return None;
        }
        if holds(a, b, opposite, false) {
            return Some(format!("{}, but the opposite was requested", told()));
        }
        let turned = a != b && holds(b, a, same, false) && !holds(b, a, opposite, false);
        // Two things may well face each other.
        let turned = turned && !["facing", "looksAt"].contains(&said.name.as_str());
        turned.then(|| format!("{}, but the reverse was requested", told()))
    }

    /// The regions of two rooms of the ground truth, in order.
    fn ends(&self, between: &[String]) -> Option<(usize, usize)> {
        let region = |name: &String| self.rooms[self.expect.rooms.iter().position(|r| r.name == *name)?];
        let [a, b] = between else { return None };
        let (a, b) = (region(a)?, region(b)?);
        Some((a.min(b), a.max(b)))
    }
}

/// The two regions that a call of `connects` names, in order.
fn connects(said: &Said) -> Option<(usize, usize)> {
    let regions: Vec<usize> =
        said.of.iter().filter_map(|of| if let Argument::Region(r) = of { Some(*r) } else { None }).collect();
    match (said.name.as_str(), regions.as_slice()) {
        ("connects", [a, b]) => Some((*a.min(b), *a.max(b))),
        _ => None,
    }
}
