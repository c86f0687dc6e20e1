//! The layout of one statement: its tokens, with the places where its line may end.
//!
//! Long formulas break before `and`, `or`, `implies`, then before comparisons, then before `+ - * /`; lists break at
//! their commas; all by two columns. The looser an operator binds, the sooner it breaks.

use super::doc::Doc;
use super::spelling::{blank_between, spelling};
use crate::chunk::has_line_break;
use crate::parse::words::{self, Words, ends_value};
use crate::token::{Kind, Token};
use scenelang_base::TextRange;
use std::ops::Range;

/// Deeper than this a statement is left as it is: nobody reads it, and the layout descends by recursion.
const DEEPEST: usize = 200;

/// Operators by how loosely they bind.
const LEVELS: [&[Kind]; 7] = [
    &[Kind::Where],
    &[Kind::Implies],
    &[Kind::Or],
    &[Kind::And],
    &[Kind::Eq, Kind::Ne, Kind::Lt, Kind::Le, Kind::Gt, Kind::Ge],
    &[Kind::Plus, Kind::Minus],
    &[Kind::Star, Kind::Slash],
];

/// The first level of [`LEVELS`] that is not one of connectives.
const COMPARISON: usize = 4;

/// The layout of a statement that parses; `None` if it is too deep. `tokens`: all of its text, trivia too.
pub fn layout(text: &str, tokens: &[Token]) -> Option<Vec<Doc>> {
    let plain: Vec<Token> = tokens.iter().copied().filter(|t| !t.kind.is_trivia()).collect();
    let (semicolon, plain) = plain.split_last()?;
    let words = words::read(text, plain, None);
    let pairs = pairs(&words.kinds)?;
    let mut builder = Builder { text, words: &words, pairs, comments: Vec::new(), before: Vec::new(), depth: 0 };
    builder.collect_comments(tokens, semicolon.range);
    builder.statement()
}

/// For each opening bracket and quantifier the closing bracket or `:` that belongs to it.
fn pairs(kinds: &[Kind]) -> Option<Vec<usize>> {
    let mut pairs = vec![usize::MAX; kinds.len()];
    let mut open = Vec::new();
    for (at, kind) in kinds.iter().enumerate() {
        match kind {
            Kind::LParen | Kind::LBracket | Kind::Forall | Kind::Exists | Kind::Count => open.push(at),
            Kind::RParen | Kind::RBracket | Kind::Colon => {
                // The `(` after `count` is closed by its `)`, and `count` by its `:`; they are swapped on the stack.
                let last = open.pop()?;
                let other = open.last().copied();
                match (kind, other) {
                    (Kind::Colon, Some(count)) if kinds[last] == Kind::LParen && kinds[count] == Kind::Count => {
                        pairs[count] = at;
                        open.pop();
                        open.push(last);
                    }
                    _ => pairs[last] = at,
                }
            }
            _ => {}
        }
    }
    open.is_empty().then_some(pairs)
}

struct Builder<'t> {
    text: &'t str,
    words: &'t Words,
    pairs: Vec<usize>,
    /// The comments behind each token.
    comments: Vec<Vec<Doc>>,
    /// The comments before the first.
    before: Vec<Doc>,
    depth: usize,
}

impl Builder<'_> {
    fn collect_comments(&mut self, tokens: &[Token], semicolon: TextRange) {
        let ranges = &self.words.ranges;
        self.comments = vec![Vec::new(); ranges.len()];
        let mut next = 0;
        for (i, token) in tokens.iter().enumerate() {
            while next < ranges.len() && ranges[next].start < token.range.start {
                next += 1;
            }
            if !token.kind.is_comment() || token.range.start > semicolon.start {
                continue;
            }
            let blank = |at: Option<usize>| {
                let token = at.and_then(|at| tokens.get(at)).filter(|t| t.kind == Kind::Blank);
                token.map_or("", |t| &self.text[t.range.bytes()])
            };
            let (above, below) = (blank(i.checked_sub(1)), blank(Some(i + 1)));
            let head = next <= self.words.head;
            let list = match next.checked_sub(1) {
                Some(before) => &mut self.comments[before],
                None => &mut self.before,
            };
            if head && super::line_breaks(above) > 1 {
                list.push(Doc::Empty);
            }
            list.push(Doc::Comment {
                text: super::comment_text(&self.text[token.range.bytes()]),
                own_line: has_line_break(above),
                // Inside a statement the layout decides what follows a block comment, lest it decide anew the next time.
                ends_line: token.kind != Kind::BlockComment || head && has_line_break(below),
            });
            if head && super::line_breaks(below) > 1 {
                list.push(Doc::Empty);
            }
        }
    }

    fn statement(mut self) -> Option<Vec<Doc>> {
        let Words { kinds, head, .. } = self.words;
        let (head, end) = (*head, kinds.len());
        let mut out = std::mem::take(&mut self.before);
        for attribute in (0..head).step_by(4) {
            self.flat(attribute..attribute + 4, &mut out);
            out.push(Doc::Hard);
        }
        let body = head + 1..end;
        match kinds.get(head)? {
            Kind::Assert => {
                self.token(head, &mut out);
                out.push(Doc::text(" "));
                self.formula(body, 0, true, &mut out)?;
            }
            Kind::Prefer => {
                self.token(head, &mut out);
                out.push(Doc::text(" "));
                let weight = self.top(body.clone()).filter(|at| kinds[*at] == Kind::Weight).last();
                let formula = body.start..weight.unwrap_or(end);
                let mut inner = Vec::new();
                self.formula(formula, 0, false, &mut inner)?;
                if let Some(weight) = weight {
                    inner.push(Doc::Line);
                    self.token(weight, &mut inner);
                    inner.push(Doc::text(" "));
                    self.formula(weight + 1..end, 0, true, &mut inner)?;
                }
                out.push(Doc::group(vec![Doc::Indent(inner)]));
            }
            Kind::Predicate => {
                let define = self.top(body).find(|at| kinds[*at] == Kind::Define)?;
                self.sequence(head..define, &mut out)?;
                out.push(Doc::text(" "));
                self.token(define, &mut out);
                let mut inner = vec![Doc::Line];
                self.formula(define + 1..end, 0, false, &mut inner)?;
                out.push(Doc::group(vec![Doc::Indent(inner)]));
            }
            Kind::Ident => {
                let arrow = self.top(body).find(|at| matches!(kinds[*at], Kind::Arrow | Kind::ArrowSign))?;
                self.sequence(head..arrow, &mut out)?;
                out.push(Doc::text(" "));
                self.token(arrow, &mut out);
                out.push(Doc::text(" "));
                self.formula(arrow + 1..end, 0, true, &mut out)?;
            }
            _ => self.sequence(head..end, &mut out)?,
        }
        out.push(Doc::text(";"));
        Some(out)
    }

    /// The tokens of a range that stand in no brackets of it.
    fn top(&self, range: Range<usize>) -> impl Iterator<Item = usize> {
        let bracket = |at: &usize| matches!(self.words.kinds[*at], Kind::LParen | Kind::LBracket);
        let first = Some(range.start).filter(|at| *at < range.end);
        let next = move |at: &usize| {
            let step = if bracket(at) { self.pairs[*at] } else { *at } + 1;
            (step < range.end).then_some(step)
        };
        std::iter::successors(first, next)
    }

    /// A token with the comments behind it.
    fn token(&self, at: usize, out: &mut Vec<Doc>) {
        let text = &self.text[self.words.ranges[at].bytes()];
        out.push(Doc::text(spelling(self.words.kinds[at], text)));
        out.extend(self.comments[at].iter().cloned());
    }

    /// Whether the minus at `at` is a sign.
    fn is_sign(&self, at: usize) -> bool {
        self.words.kinds[at] == Kind::Minus && !at.checked_sub(1).is_some_and(|b| ends_value(self.words.kinds[b]))
    }

    fn blank(&self, at: usize) -> bool {
        let kinds = &self.words.kinds;
        blank_between(kinds[at - 1], self.is_sign(at - 1), kinds[at])
    }

    /// Tokens on one line.
    fn flat(&self, range: Range<usize>, out: &mut Vec<Doc>) {
        for at in range.clone() {
            if at > range.start && self.blank(at) {
                out.push(Doc::text(" "));
            }
            self.token(at, out);
        }
    }

    /// Tokens on one line, but that brackets may break.
    fn sequence(&mut self, range: Range<usize>, out: &mut Vec<Doc>) -> Option<()> {
        let mut at = range.start;
        while at < range.end {
            if at > range.start && self.blank(at) {
                out.push(Doc::text(" "));
            }
            at = match self.words.kinds[at] {
                Kind::LParen | Kind::LBracket => {
                    self.brackets(at, out)?;
                    self.pairs[at] + 1
                }
                _ => {
                    self.token(at, out);
                    at + 1
                }
            };
        }
        Some(())
    }

    /// An expression, split at its loosest operators. `indent`: whether lines after the first stand further right.
    fn formula(&mut self, range: Range<usize>, level: usize, indent: bool, out: &mut Vec<Doc>) -> Option<()> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return None;
        }
        let kinds = &self.words.kinds;
        let mut splits = Vec::new();
        let mut found = level;
        for (n, operators) in LEVELS.iter().enumerate().skip(level) {
            // The body of a quantifier extends to the end: what is in there is not ours.
            let ours = self.top(range.clone()).take_while(|at| !matches!(kinds[*at], Kind::Forall | Kind::Exists));
            splits =
                ours.filter(|at| operators.contains(&kinds[*at]) && *at > range.start && !self.is_sign(*at)).collect();
            found = n;
            if !splits.is_empty() {
                break;
            }
        }
        if splits.is_empty() {
            self.operand(range, out)?;
        } else {
            let mut inner = Vec::new();
            self.formula(range.start..splits[0], found + 1, true, &mut inner)?;
            for (n, &split) in splits.iter().enumerate() {
                let mut step = vec![Doc::Line];
                self.token(split, &mut step);
                step.push(Doc::text(" "));
                let end = splits.get(n + 1).copied().unwrap_or(range.end);
                self.formula(split + 1..end, found + 1, true, &mut step)?;
                // Connectives break all or none; comparisons and arithmetic only where the line is full.
                if found < COMPARISON { inner.extend(step) } else { inner.push(Doc::group(step)) }
            }
            let inner = if indent || found >= COMPARISON { vec![Doc::Indent(inner)] } else { inner };
            out.push(Doc::group(inner));
        }
        self.depth -= 1;
        Some(())
    }

    /// Prefixes, a quantifier, or a value with what hangs on it.
    fn operand(&mut self, range: Range<usize>, out: &mut Vec<Doc>) -> Option<()> {
        let kinds = &self.words.kinds;
        let mut first = range.start;
        while first < range.end && matches!(kinds[first], Kind::Not | Kind::Minus) {
            self.token(first, out);
            if kinds[first] == Kind::Not {
                out.push(Doc::text(" "));
            }
            first += 1;
        }
        if first < range.end && matches!(kinds[first], Kind::Forall | Kind::Exists) {
            self.token(first, out);
            out.push(Doc::text(" "));
            return self.binding(first + 1..range.end, self.pairs[first], out);
        }
        self.sequence(first..range.end, out)
    }

    /// `x in S: φ`, with the `:` at `colon`.
    fn binding(&mut self, range: Range<usize>, colon: usize, out: &mut Vec<Doc>) -> Option<()> {
        self.flat(range.start..range.start + 2, out);
        out.push(Doc::text(" "));
        self.formula(range.start + 2..colon, 0, true, out)?;
        self.token(colon, out);
        let mut inner = vec![Doc::Line];
        self.formula(colon + 1..range.end, 0, false, &mut inner)?;
        out.push(Doc::group(vec![Doc::Indent(inner)]));
        Some(())
    }

    /// Brackets and the list in them.
    fn brackets(&mut self, open: usize, out: &mut Vec<Doc>) -> Option<()> {
        let close = self.pairs[open];
        let kinds = &self.words.kinds;
        let mut group = Vec::new();
        self.token(open, &mut group);
        let mut inner = vec![Doc::Soft];
        let colon = open.checked_sub(1).filter(|at| kinds[*at] == Kind::Count).map(|at| self.pairs[at]);
        let parameters = kinds[self.words.head] == Kind::Predicate && open == self.words.head + 2;
        if let Some(colon) = colon {
            self.binding(open + 1..close, colon, &mut inner)?;
        } else if open + 1 < close {
            let commas: Vec<usize> = self.top(open + 1..close).filter(|at| kinds[*at] == Kind::Comma).collect();
            let mut start = open + 1;
            for end in commas.into_iter().chain([close]) {
                if parameters {
                    self.flat(start..end, &mut inner);
                } else {
                    self.formula(start..end, 0, start != open + 1 || end != close, &mut inner)?;
                }
                if end < close {
                    self.token(end, &mut inner);
                    inner.push(Doc::Line);
                }
                start = end + 1;
            }
        }
        if open + 1 < close {
            group.extend([Doc::Indent(inner), Doc::Soft]);
        }
        self.token(close, &mut group);
        out.push(Doc::group(group));
        Some(())
    }
}
