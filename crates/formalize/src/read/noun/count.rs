//! How many a noun phrase speaks of: "a dozen", "2 x", "two of the".

use super::super::lexicon::Class;
use super::super::measure::measure;
use super::super::token::Token;
use super::super::{counts, number};
use super::scan::Scan;
use super::{Det, Nth};
use crate::brief::Pattern;

/// What things stand in that are counted by it.
const GATHERED: [&str; 10] =
    ["rows", "lines", "columns", "groups", "clusters", "sets", "stacks", "banks", "islands", "pods"];
const LINES: [&str; 4] = ["rows", "lines", "columns", "aisles"];
const GROUPS: [&str; 4] = ["groups", "clusters", "islands", "pods"];

impl Scan<'_> {
    /// Reads the number. The tokens of the phrase where it ends here: "two of them".
    pub fn count(&mut self) -> Option<usize> {
        let found = self.number();
        self.counted = self.np.count.is_some();
        (self.start, self.looks_end) = (self.used, self.used);
        found
    }

    fn number(&mut self) -> Option<usize> {
        // "a dozen", "a pair of" begin with their article.
        let pair = |i: usize| matches!(self.text(i), "dozen" | "hundred" | "pair" | "couple" | "trio");
        let with_article =
            self.article && number::count(self.from(self.used - 1)).is_some_and(|(_, n)| n > 1 && pair(self.used));
        let from = if with_article { self.used - 1 } else { self.used };
        if measure(self.from(self.used)).is_some() {
            return None;
        }
        let (n, k) = number::count(self.from(from))?;
        let whole = n.fract() == 0.0 || self.rest.get(from + k).is_some_and(Token::word);
        if !whole || !(0.0..=1e9).contains(&n) {
            return None;
        }
        // "three rows of four desks", "two groups of six chairs"
        let gathered = GATHERED.contains(&self.text(from + k)) && self.text(from + k + 1) == "of";
        // "In two islands of three" says nothing of what.
        let goes_on = |t: &Token| {
            t.word() && !t.is("with") && !t.is("and") && self.lexicon.relation(std::slice::from_ref(t)).is_none()
        };
        if let (true, Some((each, more))) = (gathered, number::count(self.from(from + k + 2)))
            && n.fract() == 0.0
            && each.fract() == 0.0
            && self.rest.get(from + k + 2 + more).is_some_and(goes_on)
        {
            self.np.pattern = match self.text(from + k) {
                lines if LINES.contains(&lines) => Some(Pattern::Rows(Some(n as usize))),
                groups if GROUPS.contains(&groups) && each > 1.0 => Some(Pattern::Groups(n as usize)),
                _ => None,
            };
            return self.take_number(n * each, from + k + 2 + more);
        }
        // "six rows of racks": how many there are in each is not said.
        let lines = LINES.contains(&self.text(from + k)) && self.text(from + k + 1) == "of";
        if lines
            && n.fract() == 0.0
            && (2.0..=50.0).contains(&n)
            && self.rest.get(from + k + 2).is_some_and(Token::word)
        {
            self.np.pattern = Some(Pattern::Rows(Some(n as usize)));
            self.np.many = true;
            self.used = from + k + 2;
            return None;
        }
        self.take_number(n, from + k)
    }

    /// What follows a number that ends before a token.
    fn take_number(&mut self, n: f64, end: usize) -> Option<usize> {
        self.np.number = counts::said(n).map(|_| n);
        self.np.count = Some(if n.fract() == 0.0 { n as usize } else { counts::whole(n) });
        self.used = end;
        if matches!(self.last_det, Det::None | Det::Indefinite) {
            self.np.det = Det::Number;
        }
        // "2 x bookcase", "2 no. bookcases"
        while matches!(self.text(self.used), "x" | "×" | "nos" | "pcs")
            && self.rest.get(self.used + 1).is_some_and(Token::word)
        {
            self.used += 1;
        }
        let of = self.text(self.used) == "of";
        if of && matches!(self.text(self.used + 1), "them" | "these" | "those") {
            self.stands_for("them");
            return Some(self.used + 2);
        }
        if of && self.is_determiner(self.text(self.used + 1)) {
            self.used += 2;
            self.np.det = Det::Definite;
            self.np.nth = Some(Nth::Some);
        }
        while self.lexicon.is(self.text(self.used), Class::Def) {
            self.used += 1;
        }
        None
    }
}
