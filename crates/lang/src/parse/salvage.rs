//! What can be kept of a statement that does not parse: names it declares, variables and properties it assigns,
//! predicates it defines. So an error poisons its statement and nothing else.
//!
//! The kept part is cut to a form that the grammar takes, with `true` of no width in the place of what is lost; those
//! become [`ExprKind::Error`].

use super::builder::Builder;
use super::depth;
use super::diagnose::meant_statement;
use super::grammar;
use super::words::{self, Words, declares, is_constructor, is_type_word};
use crate::ast::{Expr, ExprId, ExprKind, Name, StmtKind};
use crate::token::{Kind, Token};
use scenelang_base::TextRange;

/// The most names that are kept of one broken declaration: a list that long is no slip.
const MOST_NAMES: usize = 1000;

type Kept = (StmtKind, Vec<Expr>);

/// The statements that broken tokens still amount to; none if nothing can be kept.
pub fn salvage(text: &str, tokens: &[Token], words: &Words) -> Vec<Kept> {
    let head = words.head;
    match words.kinds.get(head) {
        Some(kind) if declares(*kind) => declarations(text, words),
        Some(Kind::Predicate) => predicate(text, words).into_iter().collect(),
        Some(Kind::Import) => import(text, words).into_iter().collect(),
        Some(Kind::Ident) => {
            let assignment = assignment(text, words);
            if assignment.is_some() {
                return assignment.into_iter().collect();
            }
            let slice = |at: usize| words.ranges.get(at).map_or("", |range| &text[range.bytes()]);
            let Some((_, meant)) = meant_statement(slice(head), slice(head + 1)) else { return Vec::new() };
            let repaired = words::read(text, tokens, Some(meant));
            match whole(text, &repaired) {
                Some(kept) => vec![kept],
                None => salvage(text, tokens, &repaired),
            }
        }
        _ => without_last(text, words).into_iter().collect(),
    }
}

/// A statement that parses but for the keyword that was put right.
fn whole(text: &str, words: &Words) -> Option<Kept> {
    Draft { kinds: words.kinds.clone(), ranges: words.ranges.clone() }.parse(text)
}

/// `assert a > 1,` and `assert a > 1)`: all but the last token.
fn without_last(text: &str, words: &Words) -> Option<Kept> {
    let Some((Kind::Comma | Kind::RParen | Kind::RBracket | Kind::Colon, kinds)) = words.kinds.split_last() else {
        return None;
    };
    Draft { kinds: kinds.to_vec(), ranges: words.ranges[..kinds.len()].to_vec() }.parse(text)
}

/// Every name that a declaration lists, rightly or not: `object a, b`, `object a b`.
fn declarations(text: &str, words: &Words) -> Vec<Kept> {
    let head = words.head;
    let ty = words.kinds[head];
    let mut kept = Vec::new();
    let mut at = head + 1;
    while words.kinds.get(at) == Some(&Kind::Ident) && kept.len() < MOST_NAMES {
        let mut draft = Draft::default();
        draft.copy(words, head);
        draft.copy(words, at);
        at = draft.brackets(words, at + 1);
        kept.extend(draft.parse(text));
        let given = matches!(words.kinds.get(at), Some(Kind::Arrow | Kind::ArrowSign | Kind::Eq | Kind::Define));
        if given && is_type_word(ty) {
            let mut draft = Draft::default();
            draft.copy(words, at - 1);
            draft.add(Kind::Arrow, words.ranges[at]);
            draft.lost(words.ranges[at].end);
            kept.extend(draft.parse(text));
        }
        if words.kinds.get(at) == Some(&Kind::Comma) {
            at += 1;
        }
    }
    kept
}

/// `target <- …`
fn assignment(text: &str, words: &Words) -> Option<Kept> {
    let mut draft = Draft::default();
    draft.copy(words, words.head);
    let mut at = draft.brackets(words, words.head + 1);
    while let [Kind::Dot, Kind::Ident, ..] = words.kinds.get(at..)? {
        draft.copy(words, at);
        draft.copy(words, at + 1);
        at += 2;
    }
    match words.kinds.get(at)? {
        Kind::Arrow | Kind::ArrowSign | Kind::Define | Kind::Implies => {}
        // `gap = 1` assigns; `lamp.pos.y = 1` may as well be an assertion without its `assert`.
        Kind::Eq if draft.kinds == [Kind::Ident] => {}
        _ => return None,
    }
    draft.add(Kind::Arrow, words.ranges[at]);
    draft.lost(words.ranges[at].end);
    draft.parse(text)
}

/// `predicate name(parameters) …`; without parameters if they do not parse.
fn predicate(text: &str, words: &Words) -> Option<Kept> {
    let rest = words.kinds.get(words.head..)?;
    let close = words.head + rest.iter().position(|k| *k == Kind::RParen).unwrap_or(0);
    let mut draft = Draft::default();
    (words.head..=close).for_each(|at| draft.copy(words, at));
    let end = words.ranges[close].end;
    draft.add(Kind::Define, TextRange::empty(end));
    draft.lost(end);
    if let Some(kept) = draft.parse(text) {
        return Some(kept);
    }
    words.kinds.get(words.head + 1).filter(|k| **k == Kind::Ident || is_constructor(**k))?;
    let name = words.ranges.get(words.head + 1)?;
    let name = Name { text: text[name.bytes()].into(), range: *name };
    let body = ExprId(0);
    let lost = Expr { kind: ExprKind::Error, range: TextRange::empty(end) };
    Some((StmtKind::Predicate { name, params: Vec::new(), body }, vec![lost]))
}

/// `import parts.scene`: the quotes are missing.
fn import(text: &str, words: &Words) -> Option<Kept> {
    let first = words.ranges.get(words.head + 1)?;
    let range = first.cover(*words.ranges.last()?);
    let path = text[range.bytes()].to_owned();
    let plain = !path.is_empty() && path.chars().all(|c| c.is_alphanumeric() || "./_-".contains(c));
    plain.then_some((StmtKind::Import { path, range }, Vec::new()))
}

/// Tokens put together for the grammar.
#[derive(Default)]
struct Draft {
    kinds: Vec<Kind>,
    ranges: Vec<TextRange>,
}

impl Draft {
    fn add(&mut self, kind: Kind, range: TextRange) {
        self.kinds.push(kind);
        self.ranges.push(range);
    }
    fn copy(&mut self, words: &Words, at: usize) {
        self.add(words.kinds[at], words.ranges[at]);
    }
    /// An operand that is lost.
    fn lost(&mut self, at: u32) {
        self.add(Kind::True, TextRange::empty(at));
    }
    /// Copies `[…]` if it begins at `at`, its content only if that is one token. Returns what follows it.
    fn brackets(&mut self, words: &Words, at: usize) -> usize {
        if words.kinds.get(at) != Some(&Kind::LBracket) {
            return at;
        }
        let close = words.kinds[at..].iter().position(|k| *k == Kind::RBracket).map(|n| at + n);
        self.copy(words, at);
        let end = words.ranges[at].end;
        match words.kinds.get(at + 1) {
            Some(Kind::Number | Kind::Ident) if close.is_none_or(|close| close == at + 2) => self.copy(words, at + 1),
            _ => self.lost(end),
        }
        self.add(Kind::RBracket, TextRange::empty(end));
        close.map_or(words.kinds.len(), |close| close + 1)
    }
    fn parse(&self, text: &str) -> Option<Kept> {
        // What was refused for its depth must not be descended into here.
        if depth::check_tokens(self.kinds.iter().copied().zip(self.ranges.iter().copied())).is_some() {
            return None;
        }
        let (parsed, mut builder) = grammar::parse(&self.kinds, Builder::new(text, &self.ranges));
        let parsed = parsed.ok().filter(|_| depth::check_exprs(&builder.exprs).is_none())?;
        for expr in builder.exprs.iter_mut().filter(|e| e.kind == ExprKind::Bool(true) && e.range.is_empty()) {
            expr.kind = ExprKind::Error;
        }
        Some((parsed.kind, builder.exprs))
    }
}
