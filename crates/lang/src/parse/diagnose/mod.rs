//! Why a statement does not parse, in the user's words.
//!
//! The grammar tells where it could not go on and what it wanted there. Rules look at what stands at that place, the
//! most telling first; what no rule knows is said plainly: found this, expected that.

mod brackets;
mod habits;
mod heads;
mod operands;
mod operators;

use super::wanted::{Failure, Wanted};
use super::wording::{describe, quote};
use super::words::Words;
use crate::token::Kind;
use scenelang_base::codes::E0110;
use scenelang_base::{Diagnostic, TextRange};

pub use heads::{meant_statement, nearest_statement};

/// What follows the tokens of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum After {
    /// Its `;`.
    Semicolon(TextRange),
    /// Another statement, without a `;` between them.
    Statement(TextRange),
    /// The end of the file.
    Nothing,
    /// An open string or comment, which is reported already.
    Cut,
}

/// Where the grammar stopped.
pub struct Site<'t> {
    text: &'t str,
    kinds: &'t [Kind],
    ranges: &'t [TextRange],
    /// The first token of the statement proper.
    head: usize,
    /// The token that does not fit; their number if they end too early.
    at: usize,
    wanted: Wanted,
    after: After,
}

type Finding = Diagnostic<TextRange>;

/// The rules, the most telling first.
const RULES: &[fn(&Site<'_>) -> Option<Finding>] = &[
    brackets::mixed,
    heads::attribute,
    heads::reserved_name,
    heads::declaration,
    heads::assignment,
    heads::misspelt,
    heads::no_arrow,
    heads::predicate,
    heads::allowance,
    heads::import,
    heads::first_word,
    operands::property,
    operands::number_like,
    operands::needs_parentheses,
    operands::split_operator,
    operands::list,
    habits::shared_side,
    operands::missing,
    habits::prefix,
    habits::called_quantifier,
    habits::sentence,
    habits::weight,
    habits::vector,
    habits::no_colon,
    operators::pairs,
    operators::comma,
    operators::unit,
    operators::misspelt,
    operators::foreign_use,
    operators::quantifier,
    operators::argument,
    brackets::open,
    operators::juxtaposed,
];

/// Says what is wrong.
pub fn diagnose(site: &Site<'_>) -> Finding {
    RULES.iter().find_map(|rule| rule(site)).unwrap_or_else(|| site.plain())
}

impl<'t> Site<'t> {
    /// The place where the grammar stopped in some words.
    pub fn new(text: &'t str, words: &'t Words, failure: Failure, after: After) -> Self {
        let Words { kinds, ranges, head, .. } = words;
        Self { text, kinds, ranges, head: *head, at: failure.at.min(kinds.len()), wanted: failure.wanted, after }
    }

    /// The kind of a token, if there is one.
    fn kind(&self, at: usize) -> Option<Kind> {
        self.kinds.get(at).copied()
    }
    /// What stands where the grammar stopped.
    fn found(&self) -> Option<Kind> {
        self.kind(self.at)
    }
    /// The token before it.
    fn before(&self) -> Option<Kind> {
        self.at.checked_sub(1).and_then(|at| self.kind(at))
    }
    fn slice(&self, at: usize) -> &'t str {
        self.ranges.get(at).map_or("", |r| &self.text[r.bytes()])
    }
    /// The place of a token; past the last one, of what follows: the `;`, or else the point where it should be.
    fn range(&self, at: usize) -> TextRange {
        match (self.ranges.get(at), self.after) {
            (Some(range), _) => *range,
            (None, After::Semicolon(range)) => range,
            (None, _) => TextRange::empty(self.ranges.last().map_or(0, |r| r.end)),
        }
    }
    /// The point directly behind a token.
    fn behind(&self, at: usize) -> TextRange {
        TextRange::empty(self.ranges.get(at).map_or(0, |r| r.end))
    }
    /// What stands at a place, as a sentence names it.
    fn name_of(&self, at: usize) -> String {
        match (self.kind(at), self.after) {
            (Some(kind), _) => describe(kind, self.slice(at)),
            (None, After::Semicolon(_)) => "`;`".to_owned(),
            (None, After::Statement(_)) => "the next statement".to_owned(),
            (None, _) => "the end of the file".to_owned(),
        }
    }
    /// A token's text in backquotes.
    fn quoted(&self, at: usize) -> String {
        quote(self.slice(at))
    }

    /// What is expected, without what is possible nearly everywhere.
    fn expectation(&self) -> String {
        let mut wanted = self.wanted;
        if wanted.has(Wanted::OPERATOR) || wanted.has(Wanted::CONNECTIVE) {
            wanted = wanted.without(Wanted::DOT.and(Wanted::OPEN_BRACKET).and(Wanted::OPEN_PAREN));
        }
        if wanted.has(Wanted::OPERATOR) {
            wanted = wanted.without(Wanted::CONNECTIVE);
        }
        if wanted.has(Wanted::ARROW) {
            wanted = wanted.without(Wanted::DOT.and(Wanted::OPEN_BRACKET));
        }
        if wanted.has(Wanted::VALUE) {
            wanted = wanted.without(Wanted::CONDITION);
        }
        // A `;` that stands there already is not what is missing.
        if matches!(self.after, After::Semicolon(_)) && self.at == self.kinds.len() {
            wanted = wanted.without(Wanted::END);
        }
        wanted.words()
    }

    /// Found this, expected that.
    fn plain(&self) -> Finding {
        let found = self.name_of(self.at);
        let diagnostic = match self.expectation() {
            expected if expected.is_empty() => {
                Diagnostic::new(E0110, self.range(self.at), format!("{found} is not allowed here"))
            }
            expected => Diagnostic::new(E0110, self.range(self.at), format!("expected {expected}, found {found}")),
        };
        match self.innermost_open() {
            Some(open) if self.wanted.has(Wanted::CLOSE_PAREN) || self.wanted.has(Wanted::CLOSE_BRACKET) => {
                diagnostic.related(self.range(open), "inside the brackets that open here")
            }
            _ => diagnostic,
        }
    }

    /// The innermost bracket that is open where the grammar stopped.
    fn innermost_open(&self) -> Option<usize> {
        let mut closed = 0;
        (0..self.at).rev().find(|&at| match self.kinds[at] {
            Kind::RParen | Kind::RBracket => {
                closed += 1;
                false
            }
            Kind::LParen | Kind::LBracket if closed > 0 => {
                closed -= 1;
                false
            }
            kind => matches!(kind, Kind::LParen | Kind::LBracket),
        })
    }
}
