//! A noun phrase that is being read: where the reading is, and what was found so far.

use super::super::lexicon::{Class, Lexicon, get};
use super::super::token::Token;
use super::{Det, NounKind, Np};

pub(super) struct Scan<'t> {
    pub rest: &'t [Token],
    pub lexicon: &'static Lexicon,
    /// Where a thing is expected.
    pub listed: bool,
    /// Tokens read.
    pub used: usize,
    /// What was read.
    pub np: Np,
    /// The determiner that came last, and whether that is "a".
    pub last_det: Det,
    pub article: bool,
    /// Whether a determiner or a number came.
    pub begun: bool,
    pub counted: bool,
    /// Where the determiners end, and where what stands before the noun begins.
    pub owner_end: usize,
    pub start: usize,
    /// In the singular, and whether as written it is a plural.
    pub nouns: Vec<(String, bool)>,
    /// Tokens up to the last noun, and up to the last look.
    pub noun_end: usize,
    pub looks_end: usize,
    /// A screen's diagonal.
    pub inches: Option<(f64, String)>,
}

/// What comes of a word.
pub(super) enum ScanStep {
    /// The next one is read.
    Go,
    /// The name ends before it.
    Stop,
    /// That is the phrase, with so many tokens.
    Found(usize),
    /// There is no phrase.
    Nothing,
}

impl<'t> Scan<'t> {
    pub fn new(rest: &'t [Token], listed: bool) -> Self {
        Self {
            rest,
            lexicon: get(),
            listed,
            used: 0,
            np: Np::new(NounKind::Thing),
            last_det: Det::None,
            article: false,
            begun: false,
            counted: false,
            owner_end: 0,
            start: 0,
            nouns: Vec::new(),
            noun_end: 0,
            looks_end: 0,
            inches: None,
        }
    }

    /// A token's text; none beyond the end.
    pub fn text(&self, i: usize) -> &'t str {
        self.rest.get(i).map_or("", |t| t.text.as_str())
    }

    /// What follows, from a token.
    pub fn from(&self, i: usize) -> &'t [Token] {
        &self.rest[i.min(self.rest.len())..]
    }

    pub fn is_determiner(&self, w: &str) -> bool {
        [Class::Def, Class::Det, Class::Each, Class::No].iter().any(|class| self.lexicon.is(w, *class))
    }

    /// Whether something says that this is a noun phrase: its beginning, or a word before the noun.
    pub fn expects_noun(&self) -> bool {
        self.begun || self.counted || self.used > self.start
    }

    /// Whether the last noun is one that the tables know.
    pub fn is_known(&self) -> bool {
        self.lexicon.noun(self.nouns.last().map_or("", |n| n.0.as_str())).is_some()
    }

    /// Takes so many tokens as part of the name.
    pub fn name(&mut self, n: usize, many: bool) {
        let words = &self.rest[self.used..self.used + n];
        self.nouns.extend(words.iter().map(|t| (super::super::lexicon::singular(&t.text), many)));
        self.used += n;
        self.noun_end = self.used;
    }
}
