//! Whether a grammar of the book takes a text, read as tokens or as characters.

use super::ebnf::{Piece, Rules};
use rustc_hash::FxHashMap;
use scenelang_lang::token::{Kind, lex};
use std::collections::BTreeSet;

/// What a grammar reads: tokens or characters.
pub trait Input {
    /// How long it is.
    fn length(&self) -> usize;
    /// Ends of a literal that starts at `at`.
    fn literal(&self, at: usize, text: &str) -> Option<usize>;
    /// End of a character of a class.
    fn class(&self, at: usize, class: &[(char, char)]) -> Option<usize>;
    /// End of a rule that is built in.
    fn built_in(&self, at: usize, name: &str) -> Option<usize>;
}

/// Where a rule can end: everything that matches, so that the order of alternatives has no say.
pub struct Recogniser<'r, I> {
    rules: FxHashMap<&'r str, &'r Piece>,
    input: I,
    known: FxHashMap<(&'r str, usize), BTreeSet<usize>>,
}

impl<'r, I: Input> Recogniser<'r, I> {
    /// A grammar and what it is to read.
    pub fn new(rules: &'r Rules, input: I) -> Self {
        let rules = rules.iter().map(|(name, piece)| (name.as_str(), piece)).collect();
        Self { rules, input, known: FxHashMap::default() }
    }

    /// Whether a rule takes all of the input.
    pub fn accepts(&mut self, start: &'r str) -> bool {
        let length = self.input.length();
        self.rule(start, 0).contains(&length)
    }

    fn rule(&mut self, name: &'r str, at: usize) -> BTreeSet<usize> {
        if let Some(known) = self.known.get(&(name, at)) {
            return known.clone();
        }
        let ends = match self.rules.get(name).copied() {
            Some(piece) => self.ends(piece, at),
            None => self.input.built_in(at, name).into_iter().collect(),
        };
        self.known.insert((name, at), ends.clone());
        ends
    }

    fn ends(&mut self, piece: &'r Piece, at: usize) -> BTreeSet<usize> {
        match piece {
            Piece::Literal(text) => self.input.literal(at, text).into_iter().collect(),
            Piece::Class(class) => self.input.class(at, class).into_iter().collect(),
            Piece::Rule(name) => self.rule(name, at),
            Piece::Sequence(all) => {
                let mut ends = BTreeSet::from([at]);
                for piece in all {
                    ends = ends.into_iter().flat_map(|at| self.ends(piece, at)).collect();
                }
                ends
            }
            Piece::Choice(all) => all.iter().flat_map(|piece| self.ends(piece, at)).collect(),
            Piece::Optional(piece) => {
                let mut ends = self.ends(piece, at);
                ends.insert(at);
                ends
            }
            Piece::Any(piece) => {
                let mut ends = self.more(piece, BTreeSet::from([at]));
                ends.insert(at);
                ends
            }
            Piece::Some(piece) => {
                let first = self.ends(piece, at);
                self.more(piece, first)
            }
        }
    }

    fn more(&mut self, piece: &'r Piece, from: BTreeSet<usize>) -> BTreeSet<usize> {
        let (mut all, mut new) = (from.clone(), from);
        while !new.is_empty() {
            let next: BTreeSet<usize> = new.iter().flat_map(|at| self.ends(piece, *at)).collect();
            new = next.difference(&all).copied().collect();
            all.extend(&new);
        }
        all
    }
}

/// Tokens of a program, without blanks and comments.
pub struct Tokens<'t>(Vec<(Kind, &'t str)>);

impl<'t> Tokens<'t> {
    /// Those of a text.
    pub fn of(text: &'t str) -> Self {
        let tokens = lex(text).into_iter().filter(|t| !t.kind.is_trivia());
        Self(tokens.map(|t| (t.kind, &text[t.range.bytes()])).collect())
    }
}

impl Input for Tokens<'_> {
    fn length(&self) -> usize {
        self.0.len()
    }
    fn literal(&self, at: usize, text: &str) -> Option<usize> {
        self.0.get(at).filter(|(_, t)| *t == text).map(|_| at + 1)
    }
    fn class(&self, _: usize, _: &[(char, char)]) -> Option<usize> {
        None
    }
    fn built_in(&self, at: usize, name: &str) -> Option<usize> {
        let kind = match name {
            "NAME" => Kind::Ident,
            "NUMBER" => Kind::Number,
            "STRING" => Kind::Str,
            other => panic!("the grammar has no rule {other}"),
        };
        self.0.get(at).filter(|(k, _)| *k == kind).map(|_| at + 1)
    }
}

/// The characters of one token.
pub struct Characters(pub Vec<char>);

impl Input for Characters {
    fn length(&self) -> usize {
        self.0.len()
    }
    fn literal(&self, at: usize, text: &str) -> Option<usize> {
        let end = at + text.chars().count();
        (end <= self.0.len() && self.0[at..end].iter().copied().eq(text.chars())).then_some(end)
    }
    fn class(&self, at: usize, class: &[(char, char)]) -> Option<usize> {
        let c = self.0.get(at)?;
        class.iter().any(|(a, b)| a <= c && c <= b).then_some(at + 1)
    }
    fn built_in(&self, at: usize, name: &str) -> Option<usize> {
        let c = *self.0.get(at)?;
        let fits = match name {
            "XID_Start" => unicode_ident::is_xid_start(c),
            "XID_Continue" => unicode_ident::is_xid_continue(c),
            "CHARACTER" => !matches!(c, '"' | '\\' | '\r' | '\n'),
            other => panic!("the grammar has no rule {other}"),
        };
        fits.then_some(at + 1)
    }
}
