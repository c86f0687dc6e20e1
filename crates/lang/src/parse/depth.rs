//! Refuses what nests too deeply, so that nobody after the lexer has to fear for the stack.
//!
//! Two measures: brackets and prefixes are counted on the tokens, before the parser descends; the height of the tree
//! is measured on the finished expressions, for `1 + 1 + …` nests without any bracket.

use crate::ast::{Expr, ExprKind};
use crate::token::Kind;

use super::words::ends_value;
use scenelang_base::codes::E0004;
use scenelang_base::{Diagnostic, TextRange};

/// The greatest nesting of brackets, prefixes and operators that is read.
const LIMIT: u32 = 1000;

/// What one pair of brackets holds open.
#[derive(Clone, Copy, Default)]
struct Frame {
    /// Quantifiers and `implies`: open up to the end of the brackets.
    lasting: u32,
    /// `not`: open up to the next connective or comma.
    nots: u32,
    /// Signs in a row.
    signs: u32,
}

impl Frame {
    fn open(self) -> u32 {
        self.lasting + self.nots + self.signs
    }
}

/// Counts what the parser would descend into; reports the token that is too deep.
pub fn check_tokens(tokens: impl Iterator<Item = (Kind, TextRange)>) -> Option<Diagnostic<TextRange>> {
    let mut outer: Vec<Frame> = Vec::new();
    let mut here = Frame::default();
    // What the frames in `outer` hold open, each with its bracket.
    let mut below = 0;
    let mut after_value = false;
    for (kind, range) in tokens {
        match kind {
            Kind::LParen | Kind::LBracket => {
                below += here.open() + 1;
                outer.push(here);
                here = Frame::default();
            }
            Kind::RParen | Kind::RBracket => {
                if let Some(frame) = outer.pop() {
                    here = frame;
                    below -= here.open() + 1;
                }
            }
            Kind::Minus if !after_value => here.signs += 1,
            Kind::Not => here.nots += 1,
            Kind::Forall | Kind::Exists => here.lasting += 1,
            Kind::Implies => here = Frame { lasting: here.lasting + 1, ..Frame::default() },
            Kind::And | Kind::Or | Kind::Comma => here = Frame { lasting: here.lasting, ..Frame::default() },
            _ => here.signs = 0,
        }
        after_value = ends_value(kind);
        if below + here.open() > LIMIT {
            return Some(refusal(range));
        }
    }
    None
}

/// Measures the tree; reports the first operator that is too high.
pub fn check_exprs(exprs: &[Expr]) -> Option<Diagnostic<TextRange>> {
    let mut heights: Vec<u32> = Vec::with_capacity(exprs.len());
    for expr in exprs {
        let mut height = 0;
        expr.kind.for_each_child(|child| height = height.max(heights[child.0 as usize] + 1));
        if height > LIMIT {
            let place = match &expr.kind {
                ExprKind::Binary(_, operator, ..) => *operator,
                ExprKind::Member(_, name) => name.range,
                _ => expr.range,
            };
            return Some(refusal(place));
        }
        heights.push(height);
    }
    None
}

fn refusal(range: TextRange) -> Diagnostic<TextRange> {
    Diagnostic::new(E0004, range, format!("this is nested more than {LIMIT} levels deep"))
        .note("split it into several statements, or name its parts with variables or predicates")
}
