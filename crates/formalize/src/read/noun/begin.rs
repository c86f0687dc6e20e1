//! How a noun phrase begins: "each of the", "all but the last", "a row of"; and those that are no more than that.

use super::super::lexicon::Class;
use super::super::number;
use super::super::token::Token;
use super::ahead::{before_noun, but_one, half, names_something, ordinal};
use super::scan::Scan;
use super::{Det, NounKind, Nth};

impl Scan<'_> {
    /// Reads the determiners.
    pub fn determiners(&mut self) {
        while self.rest.get(self.used).is_some_and(Token::word) && self.determiner() {
            self.used += 1;
        }
        self.owner_end = self.used;
    }

    /// Whether a word is one of them.
    fn determiner(&mut self) -> bool {
        let (used, w) = (self.used, self.text(self.used));
        if is_each(w) && (w != "adjacent" || self.text(used + 1) != "to") {
            self.last_det = Det::Each;
        } else if self.lexicon.is(w, Class::No) && used == 0 && w != "without" {
            self.last_det = Det::No;
        } else if self.lexicon.is(w, Class::Def) {
            self.definite(w);
        } else if self.lexicon.is(w, Class::Det) && w != "one" {
            self.indefinite(w);
        } else if w == "other" && used > 0 {
            self.np.other = true;
        } else if w == "half" && used == 0 && half(self.from(1)) > 0 {
            self.used += half(self.from(1));
            self.np.nth = Some(Nth::Half);
            self.last_det = Det::Definite;
        } else {
            return self.which_of_several(w) || self.links(w);
        }
        true
    }

    fn definite(&mut self, w: &str) {
        if !matches!(self.last_det, Det::Each | Det::No) {
            let own = matches!(w, "my" | "your" | "our" | "its" | "their" | "his" | "her");
            self.last_det = if own { Det::Own } else { Det::Definite };
        }
    }

    fn indefinite(&mut self, w: &str) {
        let np = &mut self.np;
        np.other |= w == "another";
        np.several |= matches!(w, "several" | "few" | "many" | "various" | "multiple" | "numerous");
        np.many |= np.several || w == "some";
        if self.last_det == Det::None {
            self.last_det = Det::Indefinite;
        }
        self.article = matches!(w, "a" | "an" | "another");
    }

    /// "the second desk", "every third", "all but the last desk"
    fn which_of_several(&mut self, w: &str) -> bool {
        if self.np.nth.is_some() {
            return false;
        }
        if let (true, Some(nth)) = (self.used > 0, ordinal(w))
            && self.last_det != Det::Indefinite
            && names_something(self.from(self.used + 1))
        {
            self.np.nth = match (self.last_det, nth) {
                (Det::Each, Nth::At(n)) => Some(Nth::Every(n + 1)),
                _ => Some(nth),
            };
            if self.last_det == Det::Each {
                self.last_det = Det::Definite;
            }
            return true;
        }
        let but = || but_one(self.from(self.used)).filter(|_| self.last_det == Det::Each && w == "but");
        if let Some((nth, n)) = but()
            && before_noun(self.from(self.used + n))
        {
            self.np.nth = Some(nth);
            self.used += n - 1;
            return true;
        }
        false
    }

    /// "each of the desks", "every one of them"
    fn links(&self, w: &str) -> bool {
        let used = self.used;
        let of = w == "of"
            && used > 0
            && matches!(self.text(used - 1), "each" | "both" | "all" | "any" | "one" | "either" | "some" | "none")
            && (self.is_determiner(self.text(used + 1)) || number::count(self.from(used + 1)).is_some());
        of || w == "one" && used > 0 && self.text(used + 1) == "of"
    }

    /// "a row of four hooks", "a set of knives", "a group of armchairs"; "a stack of two books": two books.
    pub fn gathered(&mut self) {
        let (used, w) = (self.used, self.text(self.used));
        let of = self.text(used + 1) == "of";
        let heap = matches!(w, "stack" | "pile") && self.rest.get(used + 2..).and_then(number::count).is_some();
        if heap && of {
            self.np.look.features.push("stacked".to_owned());
        }
        if self.article && (heap || is_many_of(w)) && of && self.rest.get(used + 2).is_some_and(Token::word) {
            self.np.row = matches!(w, "row" | "line" | "series" | "bank");
            self.used += 2;
            self.last_det = Det::None;
            self.article = false;
        }
        self.np.det = self.last_det;
        self.begun = self.used > 0;
        self.owner_end = self.used;
    }

    /// "it", "each of them", "on its surface": what stands for a noun, and the tokens that it takes.
    pub fn pronoun(&mut self) -> Option<usize> {
        let end = self.owner_end;
        if self.np.det == Det::Own
            && matches!(self.text(end - 1), "its" | "their")
            && self.lexicon.is(self.text(end), Class::Surface)
            && !before_noun(self.from(end + 1))
        {
            self.stands_for(if self.text(end - 1) == "its" { "it" } else { "them" });
            return Some(end + 1);
        }
        if self.begun && matches!(self.text(self.used), "it" | "them") {
            self.stands_for(self.text(self.used));
            return Some(self.used + 1);
        }
        let first = self.text(0);
        if !self.begun && is_pronoun(first) && !matches!(first, "all" | "these" | "those" | "each" | "one") {
            self.stands_for(first);
            return Some(1);
        }
        None
    }

    /// The phrase is a pronoun.
    pub fn stands_for(&mut self, word: &str) {
        self.np.kind = NounKind::Pronoun;
        self.np.words = vec![word.to_owned()];
    }
}

/// Whether a word stands for a noun.
pub(super) fn is_pronoun(w: &str) -> bool {
    matches!(w, "it" | "they" | "them" | "both" | "each" | "these" | "those" | "itself" | "either" | "all" | "one")
}

fn is_each(w: &str) -> bool {
    matches!(
        w,
        "each" | "every" | "all" | "both" | "any" | "either" | "neighbouring" | "neighboring" | "adjacent" | "per"
    )
}

fn is_many_of(w: &str) -> bool {
    matches!(w, "row" | "line" | "series" | "set" | "group" | "cluster" | "collection" | "number" | "bunch" | "bank")
}
