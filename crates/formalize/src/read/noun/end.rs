//! What a noun phrase speaks of, once all its words are read.

use super::super::chunk::looks;
use super::super::lexicon::{Class, plural, singular};
use super::super::senses::{Sense, sense};
use super::ahead::but_one;
use super::begin::is_pronoun;
use super::scan::Scan;
use super::{Det, NounKind, Np};
use crate::brief::Dim;
use crate::draft;

/// Colours that are things where no noun follows.
const FRUIT: [&str; 7] = ["apple", "cherry", "plum", "peach", "lemon", "lime", "rose"];

impl Scan<'_> {
    /// The phrase, and how many tokens it takes.
    pub fn end(mut self) -> Option<(Np, usize)> {
        self.fruit();
        if self.noun_end == 0 {
            let used = self.without_noun()?;
            return Some((self.np, used));
        }
        self.np.words = self.nouns.iter().map(|n| n.0.clone()).collect();
        self.np.many |= self.nouns.last().is_some_and(|n| n.1) && self.np.count.is_none();
        self.kind();
        self.diagonal();
        let np = &mut self.np;
        let exception = matches!(np.det, Det::Each | Det::Definite) && np.kind == NounKind::Thing && np.nth.is_none();
        if let Some((nth, n)) = but_one(&self.rest[self.noun_end..]).filter(|_| exception) {
            np.nth = Some(nth);
            return Some((self.np, self.noun_end + n));
        }
        Some((self.np, self.noun_end))
    }

    /// "a single apple"
    fn fruit(&mut self) {
        let none = self.noun_end == 0 && self.begun && self.used > self.owner_end;
        if !none || !FRUIT.contains(&singular(self.text(self.used - 1)).as_str()) {
            return;
        }
        let last = self.used - 1;
        let before = looks(&self.rest[self.start..last]).filter(|(_, n)| self.start + n == last);
        self.np.look = before.map_or_else(draft::Look::default, |(look, _)| look);
        self.nouns.push((singular(self.text(last)), plural(self.text(last))));
        self.noun_end = self.used;
    }

    /// "these", "the other", "the two": pronouns, if anything.
    fn without_noun(&mut self) -> Option<usize> {
        let (end, first) = (self.owner_end, self.text(0));
        let points = is_pronoun(first) && !self.begun && matches!(first, "these" | "those" | "each" | "all");
        if points || self.begun && self.np.det == Det::Each && self.used == end {
            self.stands_for(first);
            return Some(end.max(1));
        }
        let other = matches!(self.text(end), "one" | "ones" | "other" | "others");
        if self.begun && other || self.np.other && self.used == end && end > 0 {
            self.stands_for("other");
            return Some(end + usize::from(other));
        }
        let these = matches!(self.last_det, Det::Definite | Det::Each) || self.np.count == Some(1);
        if self.counted && self.used == self.start && these {
            self.stands_for("ones");
            return Some(self.used);
        }
        None
    }

    /// A room, a thing of the tables, or something else.
    fn kind(&mut self) {
        let np = &mut self.np;
        let thing = self.lexicon.noun_ending(&np.words);
        match (self.lexicon.room_ending(&np.words), thing) {
            (Some((n, _)), t) if t.is_none_or(|(m, _)| n >= m) => {
                np.kind = NounKind::Room;
                np.last = n;
                np.known = true;
                // What may be either is a thing where it is not said like a room.
                np.group = t.filter(|(m, _)| *m == n).map(|t| t.1);
            }
            (_, Some((m, group))) => {
                np.last = m;
                np.group = Some(group);
                np.known = true;
            }
            _ => {
                let head = np.words.last().cloned().unwrap_or_default();
                let named = np.words.len() > 1 && self.lexicon.is(&head, Class::Tail);
                let is_no_thing = || {
                    let known = scenelang_lang::library::is_known(&np.words.join(" "));
                    !known && matches!(sense(&head), Some(Sense::Person | Sense::Abstract))
                };
                if !named && (self.lexicon.is(&head, Class::Abstract) || is_no_thing()) {
                    np.kind = NounKind::Abstract;
                }
            }
        }
    }

    /// "a 55 inch television": the diagonal of a picture of 16 to 9.
    fn diagonal(&mut self) {
        let np = &mut self.np;
        let screen = np.words.last().is_some_and(|w| matches!(w.as_str(), "tv" | "television" | "monitor" | "screen"));
        if let Some((across, said)) = self.inches.take().filter(|_| screen) {
            np.dims.retain(|(dim, _)| *dim != Dim::Length);
            np.dims.extend([(Dim::Width, across * 0.872), (Dim::Height, across * 0.49)]);
            np.look.features.push(said);
        }
    }
}
