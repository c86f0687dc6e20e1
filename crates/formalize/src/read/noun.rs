//! Noun phrases: "two low oak side tables", "each of the desks", "the back wall", "the meeting room", "it".

use super::chunk::Dims;
use super::token::Token;
use crate::brief::{Group, Op, Pattern, Place};
use crate::draft;
pub(super) use ahead::room_here;
pub use amount::{add_dims, bounded};
use scan::Scan;

mod ahead;
mod amount;
mod begin;
mod count;
mod end;
mod scan;
mod words;

/// How a noun phrase begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Det {
    /// By nothing: "chairs".
    None,
    /// "a", "some".
    Indefinite,
    /// "the", "these".
    Definite,
    /// "my", "its", "the teacher's".
    Own,
    /// "each", "all", "both".
    Each,
    /// "no".
    No,
    Number,
}

/// What a noun phrase speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NounKind {
    Thing,
    /// A room: an index into the kinds.
    Room,
    /// A place in a room or on a thing.
    Place(Place),
    /// Something that is no thing: "the atmosphere".
    Abstract,
    /// "it", "they", "both".
    Pronoun,
}

/// A noun phrase.
#[derive(Clone, Debug, PartialEq)]
pub struct Np {
    /// How it begins.
    pub det: Det,
    /// How many.
    pub count: Option<usize>,
    /// The number as it is written, where that is no count of things.
    pub number: Option<f64>,
    /// A plural with no number.
    pub many: bool,
    /// "several", "a few": at least three.
    pub several: bool,
    /// What it speaks of.
    pub kind: NounKind,
    /// Words of the name in the singular, looks left out: "coffee", "table".
    pub words: Vec<String>,
    /// How many of the last words the tables know as one noun.
    pub last: usize,
    /// The group of the noun, if the tables know it.
    pub group: Option<Group>,
    /// Whether the tables know the noun.
    pub known: bool,
    /// Looks before the noun.
    pub look: draft::Look,
    /// Sizes before the noun.
    pub dims: Dims,
    /// Words before a place or a room: "left", "front", "north", "long".
    pub which: Vec<String>,
    /// "another", "other".
    pub other: bool,
    /// Which of several: "the first exit", "half of the desks".
    pub nth: Option<Nth>,
    /// "a row of chairs".
    pub row: bool,
    /// "three rows of four chairs", "two groups of four desks".
    pub pattern: Option<Pattern>,
    /// Whether the number is said to bind from one side, or exactly: "at least two chairs".
    pub bound: Option<Op>,
}

/// Which of several a noun phrase speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Nth {
    /// This one, from 0: "the first exit".
    At(usize),
    /// "the last exit".
    Last,
    /// "the middle exit".
    Middle,
    /// As many as are counted: "two of the desks".
    Some,
    /// "half of the desks".
    Half,
    /// "every second desk".
    Every(usize),
    /// "each desk except the first".
    ButFirst,
    /// "all desks but the last".
    ButLast,
}

impl Np {
    fn new(kind: NounKind) -> Self {
        Self {
            det: Det::None,
            count: None,
            number: None,
            many: false,
            several: false,
            kind,
            words: Vec::new(),
            last: 1,
            group: None,
            known: false,
            look: draft::Look::default(),
            dims: Vec::new(),
            which: Vec::new(),
            other: false,
            nth: None,
            row: false,
            pattern: None,
            bound: None,
        }
    }

    /// The noun itself: the words that the tables know as one.
    pub fn head(&self) -> String {
        self.words[self.words.len().saturating_sub(self.last)..].join(" ")
    }

    /// The whole name.
    pub fn name(&self) -> String {
        self.words.join(" ")
    }
}

/// The noun phrase that begins here and how many tokens it takes. `listed`: where a thing is expected, so that a word
/// nobody knows may be one.
pub fn noun_phrase(rest: &[Token], listed: bool) -> Option<(Np, usize)> {
    let mut scan = Scan::new(rest, listed);
    scan.determiners();
    scan.gathered();
    if let Some(used) = scan.pronoun().or_else(|| scan.count()) {
        return Some((scan.np, used));
    }
    scan.words()
}
