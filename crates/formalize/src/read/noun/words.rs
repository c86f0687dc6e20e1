//! The words of a noun phrase after its beginning: looks, sizes and parts of the name, one after the other. Each rule says
//! what one of them is, or passes it on; the order of the rules matters.

use super::super::chunk::{add_look, fixed, look_at};
use super::super::lexicon::{Class, LookWord, get, plural, singular};
use super::super::measure::measure;
use super::super::number;
use super::super::senses::{Sense, sense};
use super::super::token::{Token, WordKind};
use super::ahead::{
    adjective, before_noun, leads_to_noun, leads_to_place, longest_noun, place, room_here, stands_somewhere,
    stops_here, tail_here, takes_object, tells_which, worded_look,
};
use super::amount::{add_dims, in_inches};
use super::scan::{Scan, ScanStep};
use super::{Det, NounKind, Np};
use crate::brief::Place;

impl Scan<'_> {
    /// Reads them to the end of the phrase.
    pub fn words(mut self) -> Option<(Np, usize)> {
        while let Some(token) = self.rest.get(self.used) {
            match if token.word() { self.word(token) } else { self.mark(token) } {
                ScanStep::Go => {}
                ScanStep::Stop => break,
                ScanStep::Found(used) => return Some((self.np, used)),
                ScanStep::Nothing => return None,
            }
        }
        self.end()
    }

    fn word(&mut self, token: &Token) -> ScanStep {
        let rules: [fn(&mut Self, &str) -> Option<ScanStep>; 14] = [
            Self::before_look,
            Self::look_of_several_words,
            Self::size,
            Self::owner,
            Self::surface,
            Self::after_singular,
            Self::noun_of_the_tables,
            Self::look,
            Self::place,
            Self::room,
            Self::wall,
            Self::clause_of_its_own,
            Self::of_no_thing,
            Self::grammar,
        ];
        let w = token.text.as_str();
        rules.iter().find_map(|rule| rule(self, w)).unwrap_or_else(|| self.unknown(w))
    }

    /// "a large, round table", as long as a noun comes; "a 2 m table".
    fn mark(&mut self, token: &Token) -> ScanStep {
        let used = self.used;
        let adjectives = self.nouns.is_empty()
            && used > self.start
            && look_at(self.from(used + 1)).is_some()
            && self.looks_end == used;
        if token.is(",") && adjectives && leads_to_noun(self.from(used + 1)) {
            self.used += 1;
            return ScanStep::Go;
        }
        if matches!(token.kind, WordKind::Number(_)) && self.nouns.is_empty() && self.measured() {
            return ScanStep::Go;
        }
        ScanStep::Stop
    }

    /// Whether a size is read.
    fn measured(&mut self) -> bool {
        let Some((m, n)) = measure(self.from(self.used)).filter(|(m, _)| m.plain() && !m.area) else { return false };
        let tokens = &self.rest[self.used..self.used + n];
        self.inches = self.inches.take().or_else(|| in_inches(&m, tokens));
        add_dims(&mut self.np.dims, &m.values, &m.dims);
        self.used += n;
        self.looks_end = self.used;
        true
    }

    /// "large and round", "very large"
    fn before_look(&mut self, w: &str) -> Option<ScanStep> {
        let used = self.used;
        let joins = w == "and"
            && used > self.start
            && self.looks_end == used
            && look_at(self.from(used + 1)).is_some()
            && leads_to_noun(self.from(used + 1))
            && self.lexicon.noun(self.text(used - 1)).is_none();
        let degree = matches!(w, "very" | "really" | "quite" | "slightly" | "rather" | "fairly" | "super" | "extra");
        (self.nouns.is_empty() && (joins || degree)).then(|| {
            self.used += 1;
            ScanStep::Go
        })
    }

    /// "a neatly rolled towel", "a glass top table"
    fn look_of_several_words(&mut self, _: &str) -> Option<ScanStep> {
        let expected = self.nouns.is_empty() && (self.expects_noun() || self.listed);
        let n = worded_look(self.from(self.used)).filter(|_| expected)?;
        self.add_look(LookWord::Feature, n);
        Some(ScanStep::Go)
    }

    fn add_look(&mut self, look: LookWord, n: usize) {
        add_look(&mut self.np.look, look, &self.rest[self.used..self.used + n]);
        self.used += n;
        self.looks_end = self.used;
    }

    fn size(&mut self, _: &str) -> Option<ScanStep> {
        // "a two metre long table": after its article, too.
        let begun = self.begun || self.used > self.owner_end.min(self.start);
        let here = self.nouns.is_empty() && begun;
        (here && self.measured()).then_some(ScanStep::Go)
    }

    /// "a teacher's desk": part of the name; "the desk's left side": of a thing.
    fn owner(&mut self, w: &str) -> Option<ScanStep> {
        self.rest[self.used].owner.then(|| {
            self.nouns.push((singular(w), false));
            self.used += 1;
            ScanStep::Go
        })
    }

    /// "the island surface", "the table's top": that thing.
    fn surface(&mut self, w: &str) -> Option<ScanStep> {
        let is = matches!(self.last_det, Det::Definite | Det::Own)
            && !self.nouns.is_empty()
            && self.is_known()
            && self.lexicon.is(w, Class::Surface)
            && !before_noun(self.from(self.used + 1));
        is.then(|| {
            self.used += 1;
            self.noun_end = self.used;
            ScanStep::Stop
        })
    }

    /// After a noun in the singular: more of the name, or a verb.
    fn after_singular(&mut self, w: &str) -> Option<ScanStep> {
        if self.nouns.last().is_none_or(|n| n.1) {
            return None;
        }
        let here = self.from(self.used);
        let is_verb = self.lexicon.verb(here).is_some();
        let (count, bare) = (self.np.count, self.last_det == Det::None);
        let several = count.map_or(bare || !self.article, |n| n > 1) && (count.is_some() || bare || !is_verb);
        if tail_here(here, several) {
            self.name(1, plural(w));
            return Some(ScanStep::Go);
        }
        // "a lamp casts light", "a vanity spans the wall": after "a", what ends so is a verb, known or not.
        let one = self.article && !(self.counted && count != Some(1));
        let goes_on = || {
            takes_object(self.from(self.used + 1))
                || matches!(self.text(self.used + 1), "through" | "into" | "onto" | "across" | "over")
        };
        let noun = longest_noun(here);
        let acts = plural(w) && (one || (noun.is_none() || is_verb) && goes_on());
        (acts && self.noun_end > 0 && !(one && noun.is_some_and(|(_, n)| n > 1))).then_some(ScanStep::Stop)
    }

    /// The longest noun of the tables that begins here.
    fn noun_of_the_tables(&mut self, _: &str) -> Option<ScanStep> {
        let (used, here) = (self.used, self.from(self.used));
        if self.text(used) == "side" && self.text(used + 1) == "by" && self.text(used + 2) == "side" {
            return Some(ScanStep::Stop);
        }
        let mut table = longest_noun(here);
        // "a fern plant stands near the window": not two plant stands. "The TV stands on the table", but "the TV stands are".
        if let Some((_, n)) = &table
            && *n > 1
            && (self.article || self.np.count == Some(1) || self.last_det == Det::Definite)
            && plural(self.text(used + n - 1))
            && self.lexicon.verb(self.from(used + n - 1)).is_some()
            && (self.last_det != Det::Definite || stands_somewhere(self.from(used + n)))
            // "An umbrella stands." is a stand.
            && self.rest.get(used + n).is_some_and(Token::word)
        {
            table = longest_noun(&here[..n - 1]);
        }
        let look = look_at(here);
        let before = |n: usize| before_noun(self.from(used + n));
        let (phrase, n) = table.filter(|(_, n)| look.is_none_or(|(_, m)| *n > m || *n == m && !before(*n)))?;
        // "a chest of drawers" is one.
        let many = plural(self.text(if phrase.contains(" of ") { used } else { used + n - 1 }));
        if n == 1 && self.nouns.is_empty() && stops_here(here, self.expects_noun() || self.listed) {
            return Some(ScanStep::Stop);
        }
        // "the window side": by the window.
        let side = phrase == "window" && matches!(self.text(used + n), "side" | "front" | "wall");
        self.nouns.extend(phrase.split(' ').map(|p| (p.to_owned(), false)));
        if let Some(last) = self.nouns.last_mut() {
            last.1 = many;
        }
        self.used += n + usize::from(side);
        self.noun_end = self.used;
        Some(if many && longest_noun(self.from(self.used)).is_none() { ScanStep::Stop } else { ScanStep::Go })
    }

    fn look(&mut self, _: &str) -> Option<ScanStep> {
        let used = self.used;
        // "A wine cellar" is no red one.
        let (kind, n) = look_at(self.from(used)).filter(|(_, n)| room_here(self.from(used)).is_none_or(|m| m <= *n))?;
        let after = self.from(used + n);
        if self.nouns.is_empty() || before_noun(after) {
            // "standing there", "double": only before something
            self.add_look(kind, n);
            return Some(ScanStep::Go);
        }
        // "a massage stone lies near the soap"
        let named = self.article
            && self.noun_end > 0
            && kind == LookWord::Material
            && longest_noun(&self.rest[used - 1..used]).is_none()
            && (self.lexicon.verb(after).is_some() || self.lexicon.relation(after).is_some());
        if !named {
            return Some(ScanStep::Stop);
        }
        self.name(n, false);
        Some(ScanStep::Go)
    }

    /// "on your left", "the back wall", "the room center"
    fn place(&mut self, w: &str) -> Option<ScanStep> {
        let used = self.used;
        let next = self.text(used + 1);
        if matches!(w, "left" | "right")
            && used > 0
            && self.text(used - 1) == "your"
            && !matches!(next, "side" | "hand" | "wall")
        {
            self.np.which = vec![w.to_owned()];
            return Some(self.is_place(Place::Side, "side", 1));
        }
        if tells_which(w) && leads_to_place(self.from(used)) {
            self.np.which.push(w.to_owned());
            self.used += 1;
            return Some(ScanStep::Go);
        }
        if let Some(found) = place(w).filter(|_| self.may_be_place(w))
            && (!before_noun(self.from(used + 1)) || matches!(found, Place::Middle | Place::Row))
        {
            self.np.many = w.ends_with('s');
            return Some(self.is_place(found, w, 1));
        }
        if let Some(n) = room_here(self.from(used))
            && let Some(found @ (Place::Middle | Place::Corner)) = place(self.text(used + n))
            && self.nouns.is_empty()
            && !before_noun(self.from(used + n + 1))
        {
            return Some(self.is_place(found, self.text(used + n), n + 1));
        }
        None
    }

    fn may_be_place(&self, w: &str) -> bool {
        self.nouns.iter().all(|(n, _)| tells_which(n))
            // "six wall panels": no place.
            && (self.np.count.is_none_or(|n| n <= 1) || w.ends_with('s'))
            && (self.expects_noun()
                || !self.np.which.is_empty()
                // "hangs from ceiling"
                || self.listed && matches!(w, "ceiling" | "wall" | "floor" | "corner" | "center" | "centre")
                || matches!(w, "walls" | "corners" | "rows"))
    }

    fn is_place(&mut self, found: Place, word: &str, n: usize) -> ScanStep {
        self.np.kind = NounKind::Place(found);
        self.np.words = vec![singular(word)];
        ScanStep::Found(self.used + n)
    }

    /// Room names of several words: "living room".
    fn room(&mut self, _: &str) -> Option<ScanStep> {
        let n = room_here(self.from(self.used))?;
        let after = longest_noun(self.from(self.used + n));
        // "a laundry hamper" is no room.
        let more = self.article
            && self.rest.get(self.used + n).is_some_and(|t| {
                let ends = ["s", "ed", "ing", "ly"].iter().any(|e| t.text.ends_with(e));
                t.word() && !self.lexicon.known(&t.text) && !ends
            });
        let first = self.used;
        self.name(n, false);
        // "Crew quarters" is one room.
        let plain: Vec<&str> = (first..first + n).map(|k| self.text(k)).collect();
        let last = plain.last().copied().unwrap_or_default();
        if let Some(noun) = self.nouns.last_mut().filter(|noun| noun.0 != last)
            && self.lexicon.room(&plain.join(" ")).is_some_and(|kind| kind.name != plain.join(" "))
            && last == "quarters"
        {
            last.clone_into(&mut noun.0);
        }
        if self.is_in_another(first) {
            return Some(ScanStep::Go);
        }
        let ends = after.is_none() && !more && !before_noun(self.from(self.used));
        Some(if ends { ScanStep::Stop } else { ScanStep::Go })
    }

    /// "an attic bedroom", "a hotel gym": the second name of a room says what it is. A kitchen dining room is both.
    fn is_in_another(&self, first: usize) -> bool {
        const BOTH: [&str; 2] = ["kitchen", "living"];
        let rest = self.from(self.used);
        let second = room_here(rest).map(|n| rest[..n].iter().map(|t| t.text.as_str()).collect::<Vec<_>>().join(" "));
        !BOTH.contains(&self.text(first)) && second.and_then(|name| self.lexicon.room(&name)).is_some_and(|k| !k.loose)
    }

    /// "a tool wall", "six wall panels": things.
    fn wall(&mut self, w: &str) -> Option<ScanStep> {
        let of_wall = self.np.det == Det::Indefinite && !self.nouns.is_empty() && self.is_known()
            || self.np.count.is_some_and(|n| n > 1) && self.rest.get(self.used + 1).is_some_and(|t| plural(&t.text));
        (w == "wall" && of_wall).then(|| {
            self.name(1, false);
            ScanStep::Go
        })
    }

    /// After the noun a clause of its own begins: "a lamp shaped like …", "the bookshelf lines the wall".
    fn clause_of_its_own(&mut self, w: &str) -> Option<ScanStep> {
        let lexicon = self.lexicon;
        let after = self.from(self.used + 1);
        let adverb = matches!(w, "anywhere" | "everywhere" | "somewhere" | "elsewhere");
        let stops = (lexicon.is(w, Class::Stop) && lexicon.is(w, Class::Abstract) || adverb) && !self.nouns.is_empty();
        let participle = || {
            self.noun_end > 0
                && (w.ends_with("ed") || w.ends_with("ing"))
                && !before_noun(after)
                && (self.nouns.iter().any(|n| lexicon.noun(&n.0).is_some())
                    || self.article && w.ends_with("ing") && lexicon.verb(after).is_none())
        };
        let verbal = || self.is_verbal() && self.noun_end > 0 && self.is_known();
        (stops || participle() || verbal()).then_some(ScanStep::Stop)
    }

    /// Whether a relation or a verb begins here.
    fn is_verbal(&self) -> bool {
        let here = self.from(self.used);
        self.lexicon.relation(here).is_some() || self.lexicon.verb(here).is_some()
    }

    /// "the atmosphere", "the conversation area"
    fn of_no_thing(&mut self, w: &str) -> Option<ScanStep> {
        let begun = self.begun || self.counted;
        let modifies = begun
            && self.rest.get(self.used + 1).is_some_and(|n| {
                n.word() && !self.lexicon.known(&n.text) && !n.text.ends_with("ed") && !n.text.ends_with("ing")
            });
        if !self.lexicon.is(w, Class::Abstract) || before_noun(self.from(self.used + 1)) || modifies {
            return None;
        }
        if !begun {
            return Some(if self.nouns.is_empty() { ScanStep::Nothing } else { ScanStep::Stop });
        }
        if self.noun_end > 0 && self.nouns.len() > 1 {
            return Some(ScanStep::Stop);
        }
        // "a glass top"
        let material = |n: &&(String, bool)| self.lexicon.look(&n.0) == Some(LookWord::Material);
        let found = self.nouns.iter().find(material).map(|n| n.0.clone());
        self.np.look.material = self.np.look.material.take().or(found);
        self.np.kind = NounKind::Abstract;
        self.np.words = vec![singular(w)];
        Some(ScanStep::Found(self.used + 1))
    }

    /// Words that hold sentences together end the name, and so do adverbs after it.
    fn grammar(&mut self, w: &str) -> Option<ScanStep> {
        let (lexicon, here, after) = (self.lexicon, self.from(self.used), self.from(self.used + 1));
        let space = lexicon.is(w, Class::Space);
        let grammar = self.is_verbal()
            || [Class::Stop, Class::Pronoun, Class::Not].iter().any(|class| lexicon.is(w, *class))
            || self.is_determiner(w)
            || number::small(w).is_some()
            || number::unit(w).is_some()
            || matches!(w, "with" | "and" | "or")
            || space && w != "floor" && !before_noun(after);
        // "a round play rug"
        let modifier = self.article
            && self.noun_end == 0
            && lexicon.relation(here).is_none()
            && !["s", "ed"].iter().any(|e| w.ends_with(e))
            && lexicon.verb(here).is_some_and(|(_, n)| n == 1)
            && longest_noun(after).is_some();
        let grammar = grammar && !modifier || !self.nouns.is_empty() && fixed(here).is_some();
        if grammar && !(space && before_noun(after)) {
            return Some(ScanStep::Stop);
        }
        if !w.ends_with("ly") || w.len() <= 4 {
            return None;
        }
        if !self.nouns.is_empty() || !self.expects_noun() {
            return Some(ScanStep::Stop);
        }
        self.used += 1;
        Some(ScanStep::Go)
    }

    /// A word that no table has: part of a name where a noun phrase has begun or is expected.
    fn unknown(&mut self, w: &str) -> ScanStep {
        let (lexicon, after) = (self.lexicon, self.from(self.used + 1));
        let room = lexicon.room(w).is_some() || lexicon.room(&singular(w)).is_some();
        let begun = self.begun || self.counted;
        let context = self.expects_noun() || self.listed || room || before_noun(after);
        // "With drafting tables": what they are for.
        let two = after.first().filter(|t| t.word()).map(|t| format!("{w} {}", singular(&t.text)));
        let is_noun = two.is_some_and(|two| scenelang_lang::nouns::noun(&two).is_some());
        let purpose = w.ends_with("ing") && is_noun;
        let verbal = self.nouns.is_empty() && !begun && !purpose && (w.ends_with("ing") || w.ends_with("ed"));
        if !context || verbal || w.chars().count() < 2 || self.nouns.len() > 5 || self.nouns.last().is_some_and(|n| n.1)
        {
            return ScanStep::Stop;
        }
        // "A play table": a name of the library that no table of the reader has.
        let is_look = adjective(w) && lexicon.verb(self.from(self.used)).is_none();
        if self.nouns.is_empty() && context && !is_look && is_noun {
            self.name(2, plural(self.text(self.used + 1)));
            return ScanStep::Go;
        }
        let unknown_follows = || after.first().is_some_and(|t| t.word() && !lexicon.known(&t.text));
        if self.nouns.is_empty() && adjective(w) && (before_noun(after) || leads_to_noun(after) || unknown_follows()) {
            self.add_look(LookWord::Feature, 1);
            return ScanStep::Go;
        }
        // "Two pushed together", "dead bouquets nobody has thrown away": no noun at all.
        let may_be_noun = !w.ends_with("ed") && !matches!(sense(w), Some(Sense::Verb | Sense::Quality));
        if !may_be_noun && !room && !before_noun(after) && !unknown_follows() && !goes_on_to_noun(after) {
            return ScanStep::Stop;
        }
        // After a known noun in the singular an unknown word may go on only if more of the name follows.
        if self.noun_end > 0 && !(begun || plural(w) || before_noun(after)) {
            return ScanStep::Stop;
        }
        self.name(1, plural(w));
        ScanStep::Go
    }
}

/// Whether a noun or a room comes right here or after one more word of a name: "lacquered storage credenza".
fn goes_on_to_noun(after: &[Token]) -> bool {
    let named = |n: usize| {
        let rest = after.get(n..).unwrap_or_default();
        !rest.is_empty() && (longest_noun(rest).is_some() || room_here(rest).is_some())
    };
    let joins = |t: &Token| {
        let one = std::slice::from_ref(t);
        t.word() && !get().is(&t.text, Class::Stop) && get().relation(one).is_none() && get().verb(one).is_none()
    };
    named(0) && joins(&after[0]) || after.first().is_some_and(joins) && named(1)
}
