//! Where a second statement begins in a chunk that does not parse as one: the `;` before it is missing.
//!
//! Reserved words begin statements wherever they stand, inside open brackets too. Contextual words, assignments and
//! misspelt keywords do where the text before them is complete, or where they begin a line.

use super::diagnose::nearest_statement;
use super::words::{attributes_end, declares, ends_value, is_assigned, is_type_word, is_word, starts_statement};
use crate::chunk::has_line_break;
use crate::token::{Kind, Token};
use scenelang_base::suggest::nearest;
use std::cell::Cell;
use std::ops::Range;

/// How far an assignment's target is looked through for its arrow, in tokens.
const TARGET: usize = 64;

/// The most statements that are looked for in one chunk: nobody forgets a thousand semicolons in a row.
const MOST: usize = 1000;

/// The most words that are looked at for misspellings.
const GUESSES: u32 = 1000;

/// Cuts the tokens (not empty, without trivia and `;`) into statements; usually one.
pub fn split(text: &str, tokens: &[Token]) -> Vec<Range<usize>> {
    let scan = Scan { text, tokens, guesses: Cell::new(GUESSES) };
    let mut segments = Vec::new();
    let mut start = 0;
    let mut attributes = attributes_end(tokens);
    let mut depth = 0usize;
    // Between `predicate` and `:=` words stand side by side.
    let mut heading = scan.slice(attributes) == "predicate";
    for at in 1..tokens.len() {
        match tokens[at - 1].kind {
            Kind::LParen | Kind::LBracket => depth += 1,
            Kind::RParen | Kind::RBracket => depth = depth.saturating_sub(1),
            Kind::Define => heading = false,
            _ => {}
        }
        if segments.len() + 1 == MOST {
            break;
        }
        if at > start + attributes && (!heading || scan.new_line(at)) && scan.starts(at, depth) {
            segments.push(start..at);
            start = at;
            attributes = attributes_end(&tokens[at..]);
            depth = 0;
            heading = scan.slice(at + attributes) == "predicate";
        }
    }
    segments.push(start..tokens.len());
    segments
}

struct Scan<'t> {
    text: &'t str,
    tokens: &'t [Token],
    /// How many more words may be compared with those that they may be slips of: that costs time.
    guesses: Cell<u32>,
}

impl Scan<'_> {
    fn kind(&self, at: usize) -> Option<Kind> {
        self.tokens.get(at).map(|t| t.kind)
    }

    fn slice(&self, at: usize) -> &str {
        self.tokens.get(at).map_or("", |t| &self.text[t.range.bytes()])
    }

    /// Whether a line ends between a token and the one before it.
    fn new_line(&self, at: usize) -> bool {
        has_line_break(&self.text[self.tokens[at - 1].range.end as usize..self.tokens[at].range.start as usize])
    }

    fn starts(&self, at: usize, depth: usize) -> bool {
        let before = self.tokens[at - 1].kind;
        let after = self.kind(at + 1);
        let named = after == Some(Kind::Ident) || after == Some(Kind::BadNumber);
        match self.tokens[at].kind {
            // After a dot a word is a property, unless that has not been written yet and a line begins here.
            kind if before == Kind::Dot && is_word(self.slice(at)) => {
                self.new_line(at) && starts_statement(kind) && (named || after == Some(Kind::LParen))
            }
            // `forall object in …`: a bad name for a variable.
            kind if declares(kind) && before == Kind::Ident && matches!(self.slice(at - 1), "forall" | "exists") => {
                false
            }
            Kind::Object | Kind::Entity | Kind::Region => named,
            kind if is_type_word(kind) => {
                let declared = matches!(self.kind(at + 2), None | Some(Kind::Arrow | Kind::ArrowSign | Kind::Eq));
                let listed = matches!(before, Kind::Comma | Kind::LParen);
                named && (depth == 0 || declared || !listed && self.new_line(at))
            }
            Kind::Assert => after != Some(Kind::Dot) && !(declares(before) && after.is_none()),
            Kind::AllowCollide | Kind::AllowOutside => after == Some(Kind::LParen),
            Kind::Req => true,
            Kind::BadAttribute => ends_value(before) || self.new_line(at),
            Kind::Ident => self.word_starts(at, before, depth),
            _ => false,
        }
    }

    /// Whether a word that is not reserved begins a statement.
    fn word_starts(&self, at: usize, before: Kind, depth: usize) -> bool {
        let complete = ends_value(before);
        let new_line = self.new_line(at);
        // The set of a quantifier.
        if at >= 3 && self.slice(at - 1) == "in" && matches!(self.slice(at - 3), "forall" | "exists") {
            return false;
        }
        if !new_line && (!complete || depth > 0) {
            return false;
        }
        let after = self.kind(at + 1);
        let word = self.slice(at);
        if self.assigns(at, complete && depth == 0) {
            return true;
        }
        match word {
            "prefer" if after.is_some() && !is_assigned(after) && after != Some(Kind::Comma) => return true,
            "predicate" if after == Some(Kind::Ident) => return true,
            "import" if matches!(after, Some(Kind::Str | Kind::OddQuotes | Kind::OpenStr)) => return true,
            "allowFloat" if after == Some(Kind::LParen) && (complete || new_line) => return true,
            "where" | "implies" | "weight" | "in" => return false,
            _ => {}
        }
        let another_word = self.tokens.get(at + 1).is_some() && is_word(self.slice(at + 1));
        if another_word && self.may_guess() && nearest_statement(word).is_some() {
            return true;
        }
        complete && new_line && depth == 0 && !self.is_slip_of_operator(at)
    }

    fn may_guess(&self) -> bool {
        let left = self.guesses.get();
        self.guesses.set(left.saturating_sub(1));
        left > 0
    }

    /// `target <- …`. Where it is not certain that the statement before is complete, the arrow must be one by its looks:
    /// a blank follows.
    fn assigns(&self, at: usize, certain: bool) -> bool {
        let mut end = at + 1;
        if self.kind(end) == Some(Kind::LBracket) {
            let close = (end..(end + TARGET).min(self.tokens.len())).find(|&i| self.kind(i) == Some(Kind::RBracket));
            let Some(close) = close else { return false };
            end = close + 1;
        }
        while end < at + TARGET && self.kind(end) == Some(Kind::Dot) && is_word(self.slice(end + 1)) {
            end += 2;
        }
        match self.kind(end) {
            Some(Kind::ArrowSign | Kind::Define) => true,
            Some(Kind::Arrow) => {
                let after = self.tokens[end].range.end as usize;
                certain || self.text[after..].starts_with([' ', '\t', '\r', '\n'])
            }
            _ => false,
        }
    }

    /// Whether the word looks like a misspelt `and`, `or`, … between two operands.
    fn is_slip_of_operator(&self, at: usize) -> bool {
        let operand = match self.kind(at + 1) {
            Some(Kind::Ident | Kind::Number | Kind::Str | Kind::True | Kind::False | Kind::Not | Kind::Inside) => true,
            Some(kind) => matches!(kind, Kind::Rand | Kind::Vec3 | Kind::Rot | Kind::DotWord),
            None => false,
        };
        operand && self.may_guess() && nearest(self.slice(at), ["and", "or", "implies", "weight", "where"]).is_some()
    }
}
