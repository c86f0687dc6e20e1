//! What the grammar builds with: the tokens' places and text, and the expressions of the statement so far.

use super::literals;
use crate::ast::{Expr, ExprId, ExprKind, Name};
use chumsky::span::SimpleSpan;
use scenelang_base::TextRange;

/// The state of one parse.
pub struct Builder<'t> {
    text: &'t str,
    ranges: &'t [TextRange],
    /// The expressions, children before parents.
    pub exprs: Vec<Expr>,
}

impl<'t> Builder<'t> {
    /// Nothing built yet; `ranges` are the places of the parser's tokens in `text`.
    pub fn new(text: &'t str, ranges: &'t [TextRange]) -> Self {
        Self { text, ranges, exprs: Vec::new() }
    }
    /// The place of some tokens in the text; `tokens` counts tokens and is not empty.
    pub fn range(&self, tokens: SimpleSpan) -> TextRange {
        match self.ranges.get(tokens.start..tokens.end) {
            Some([first, .., last]) => first.cover(*last),
            Some([only]) => *only,
            _ => TextRange::empty(self.ranges.last().map_or(0, |r| r.end)),
        }
    }
    /// The text of some tokens.
    pub fn slice(&self, tokens: SimpleSpan) -> &'t str {
        &self.text[self.range(tokens).bytes()]
    }
    pub fn name(&self, token: SimpleSpan) -> Name {
        Name { text: self.slice(token).into(), range: self.range(token) }
    }
    /// A string token with its escapes resolved.
    pub fn string(&self, token: SimpleSpan) -> String {
        literals::string_value(self.slice(token))
    }
    /// Adds an expression made of `tokens`.
    pub fn push(&mut self, tokens: SimpleSpan, kind: ExprKind) -> ExprId {
        let range = self.range(tokens);
        self.exprs.push(Expr { kind, range });
        ExprId(self.exprs.len() as u32 - 1)
    }
    /// Adds a string; one that does not close has no value, for who knows where it should have ended.
    pub fn push_string(&mut self, token: SimpleSpan) -> ExprId {
        let kind = match literals::is_closed(self.slice(token)) {
            true => ExprKind::Text(self.string(token)),
            false => ExprKind::Error,
        };
        self.push(token, kind)
    }
    /// Adds a number.
    pub fn push_number(&mut self, token: SimpleSpan) -> ExprId {
        let kind = match literals::number_value(self.slice(token)) {
            Some((value, unit)) => ExprKind::Number(value, unit),
            None => ExprKind::Error,
        };
        self.push(token, kind)
    }
}
