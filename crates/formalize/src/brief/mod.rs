//! What a request asks for, as one value: rooms, things and what is said of them. It stands between the reader, which
//! knows words, and the composer, which knows statements; neither knows the other's.
//!
//! ```text
//! request ──read──▶ Brief ──complete──▶ Brief ──compose──▶ Draft ──write──▶ program
//! ```
//!
//! Things and rooms are named by their index. Each of them, and each fact, has the bytes of the request that it comes
//! from, or the reason why it was added. Lengths are in metres.

mod fact;
pub mod json;
mod room;
mod thing;

pub use fact::{Dim, Fact, FactKind, Op, Pattern, Place, Quantifier, Rel, Side};
pub use room::Room;
pub use thing::{Group, Look, Number, Pick, Subset, Thing, ThingOrigin, opens};

use std::ops::Range;

/// A request as a value.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Brief {
    /// The request itself; all ranges are bytes of it.
    pub request: String,
    /// The rooms; there is at least one.
    pub rooms: Vec<Room>,
    /// The things, doors and windows included.
    pub things: Vec<Thing>,
    /// What is said of them.
    pub facts: Vec<Fact>,
    /// What must not be there, and where that is said.
    pub absent: Vec<(String, Range<usize>)>,
    /// Words that became nothing, or something else than they say, and why.
    pub notes: Vec<Note>,
    /// The clauses of the request in their order.
    pub clauses: Vec<Clause>,
    /// The words of the request that say something, in their order.
    pub words: Vec<Word>,
}

/// A clause of the request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Clause {
    /// Bytes of the request.
    pub at: Range<usize>,
    /// Whether all its words that say something became part of the brief.
    pub understood: bool,
}

/// A word of the request that says something: a noun, a look, a relation, a number, a negation, a comparison.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// Bytes of the request.
    pub at: Range<usize>,
    /// Whether it became part of the brief.
    pub used: bool,
}

/// Words of the request that became no statement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// Bytes of the request.
    pub at: Range<usize>,
    /// Why: "no thing of the request is called this".
    pub reason: String,
}

/// A request has at most so many things; the others are left out.
pub const MOST_THINGS: usize = 300;
/// At most so many of one kind are placed.
pub const MOST_COUNT: usize = 400;

/// At most so many things are placed in all.
pub const MOST_IN_ALL: usize = 800;
/// The guidelines of the library weigh pairs of things: with more than so many a program would be too large to judge.
pub(crate) const MOST_GUIDED: usize = 250;

/// What is said of a number of like things that is not taken as it is.
pub fn too_many(n: usize) -> Option<String> {
    (n > MOST_COUNT).then(|| format!("{n} is too many: at most {MOST_COUNT} of one kind are placed"))
}

impl Brief {
    /// Adds a fact, unless it is known already, or nothing is said of anything.
    pub fn say(&mut self, fact: Fact) {
        let known = self.facts.iter().any(|f| f.of == fact.of && f.what == fact.what && f.not == fact.not);
        if !fact.of.is_empty() && !known && self.facts.len() < 4 * MOST_THINGS {
            self.facts.push(fact);
        }
    }

    /// Removes things, their parts, and all that is said of them or with them.
    pub fn remove(&mut self, gone: &[usize]) {
        let lost = |i: usize| gone.contains(&i) || self.things[i].part.as_ref().is_some_and(|p| gone.contains(&p.of));
        let mut next = 0;
        let new: Vec<Option<usize>> = (0..self.things.len())
            .map(|i| {
                let kept = !lost(i);
                next += usize::from(kept);
                kept.then(|| next - 1)
            })
            .collect();
        let moved = |list: &[usize]| -> Vec<usize> { list.iter().filter_map(|i| new[*i]).collect() };
        for fact in &mut self.facts {
            fact.of = moved(&fact.of);
            if let Some(to) = fact.what.objects_mut() {
                let all = to.len();
                *to = moved(to);
                if to.len() < all {
                    fact.of.clear();
                }
            }
        }
        self.facts.retain(|f| !f.of.is_empty());
        let things = std::mem::take(&mut self.things);
        for (mut thing, _) in things.into_iter().zip(&new).filter(|(_, new)| new.is_some()) {
            if let Number::Each { of, number } = thing.number {
                thing.number = new[of].map_or(Number::Exactly(number), |of| Number::Each { of, number });
            }
            if let Some(part) = &mut thing.part {
                part.of = new[part.of].unwrap_or(part.of);
            }
            self.things.push(thing);
        }
    }

    /// The thing on whose number that of another depends.
    pub(crate) fn depends(&self, thing: usize) -> Option<usize> {
        match (&self.things[thing].part, self.things[thing].number) {
            (Some(part), _) => Some(part.of),
            (None, Number::Each { of, .. }) if of < thing || !self.things[of].number.follows() => Some(of),
            _ => None,
        }
    }

    /// Lowers the numbers of things with which there would be more than [`MOST_IN_ALL`], and says so.
    pub fn bound(&mut self) {
        let mut left = MOST_IN_ALL;
        for thing in (0..self.things.len()).filter(|thing| self.things[*thing].part.is_none()).collect::<Vec<_>>() {
            let n = self.count(thing);
            if n > left.max(1) {
                let kept = left.max(1);
                let reason = format!(
                    "{n} of these would exceed the limit of {MOST_IN_ALL} objects in all; the number is reduced to {kept}"
                );
                self.notes.push(Note { at: self.things[thing].source.at(), reason });
                self.things[thing].number = Number::Exactly(kept);
            }
            left = left.saturating_sub(n);
        }
    }

    /// How many there are of a thing, at most [`MOST_COUNT`].
    pub fn count(&self, thing: usize) -> usize {
        match &self.things[thing].part {
            Some(part) => self.elements(part).len(),
            None => self.stated(thing).clamp(1, MOST_COUNT),
        }
    }

    /// How many there are of a thing by what is said, however many that are.
    pub fn stated(&self, thing: usize) -> usize {
        let own = &self.things[thing];
        match own.number {
            Number::Each { number, .. } => {
                self.depends(thing).map_or(number, |of| self.count(of).saturating_mul(number))
            }
            Number::Exactly(n) | Number::AtLeast(n) => n,
            Number::Several => 3,
            Number::Plural if matches!(own.group, Group::Ceiling | Group::Seat) => 3,
            Number::Plural => 2,
            Number::Unsaid => 1,
        }
    }

    /// The indices of some of a thing.
    pub fn elements(&self, part: &Subset) -> Vec<usize> {
        let rows = self.facts.iter().find_map(|f| match f.what {
            FactKind::Pattern(Pattern::Rows(n)) if f.of.contains(&part.of) => n,
            _ => None,
        });
        part.pick.indices(self.count(part.of), rows.unwrap_or(1))
    }

    /// Some of a thing, as a thing of its own; the same each time.
    pub fn part(&mut self, of: usize, pick: Pick, at: Range<usize>) -> usize {
        let part = Subset { of, pick };
        if let Some(known) = self.things.iter().position(|i| i.part.as_ref() == Some(&part)) {
            return known;
        }
        let number = if self.elements(&part).len() > 1 { Number::Plural } else { Number::Unsaid };
        let thing = Thing { number, part: Some(part), source: ThingOrigin::Stated(at), ..self.things[of].clone() };
        self.things.push(thing);
        self.things.len() - 1
    }

    /// The thing that a thing is some of, or itself.
    pub fn whole(&self, thing: usize) -> usize {
        self.things[thing].part.as_ref().map_or(thing, |p| p.of)
    }
}
