//! Which ranges of a statement are nodes, from its typed tree; and the pairs of brackets, which that does not hold.

use super::build::NodeRange;
use super::kind::NodeKind;
use crate::ast::{Expr, ExprKind, Name, Stmt, StmtKind};
use crate::parse::words::{Words, is_constructor};
use crate::token::Kind;
use scenelang_base::TextRange;

/// The nodes of a statement that parses.
pub(super) fn statement(stmt: &Stmt, words: &Words, out: &mut Vec<NodeRange>) {
    out.push(NodeRange { range: stmt.range, kind: NodeKind::from(&stmt.kind) });
    parts(stmt, out);
    out.extend(groups(words, usize::MAX).into_iter().map(|group| group.piece(words)));
}

/// Names, parameters, paths and expressions of a statement, outer ones before inner ones where both have one range.
pub(super) fn parts(stmt: &Stmt, out: &mut Vec<NodeRange>) {
    let mut push = |range, kind| out.push(NodeRange { range, kind });
    match &stmt.kind {
        StmtKind::Declare { name, .. } => push(name.range, NodeKind::Name),
        StmtKind::Assign { name, path, target, .. } => {
            push(*target, NodeKind::Path);
            push(name.range, NodeKind::NameRef);
            path.iter().for_each(|p| push(p.range, NodeKind::Property));
        }
        StmtKind::Predicate { name, params, .. } => {
            push(name.range, NodeKind::Name);
            for param in params {
                push(param.ty_range.cover(param.name.range), NodeKind::Parameter);
                push(param.name.range, NodeKind::Name);
            }
        }
        _ => {}
    }
    stmt.exprs.iter().for_each(|expr| expression(expr, &mut push));
}

fn expression(expr: &Expr, push: &mut impl FnMut(TextRange, NodeKind)) {
    push(expr.range, NodeKind::from(&expr.kind));
    match &expr.kind {
        ExprKind::Member(_, Name { range, .. }) | ExprKind::Own(Name { range, .. }) => push(*range, NodeKind::Property),
        ExprKind::Quantified(_, Name { range, .. }, ..) => push(*range, NodeKind::Name),
        _ => {}
    }
}

/// A pair of brackets, or one that does not close.
#[derive(Clone, Copy)]
pub(super) struct BracketPair {
    /// The opening bracket, counted in words.
    pub open: usize,
    /// The last word: the closing bracket, or what stands before the place where it is missed.
    pub last: usize,
}

impl BracketPair {
    /// The brackets as a node; what kind depends on the word before them.
    pub fn piece(self, words: &Words) -> NodeRange {
        let before = |n: usize| self.open.checked_sub(n).and_then(|at| words.kinds.get(at)).copied();
        let kind = match (words.kinds[self.open], before(1)) {
            (Kind::LBracket, _) => NodeKind::Brackets,
            (_, Some(Kind::Ident)) if before(2) == Some(Kind::Predicate) => NodeKind::Parameters,
            (_, Some(kind)) if is_constructor(kind) && before(2) == Some(Kind::Predicate) => NodeKind::Parameters,
            (_, Some(Kind::Ident)) if before(2) != Some(Kind::Dot) => NodeKind::Arguments,
            (_, Some(Kind::AllowCollide | Kind::AllowOutside | Kind::AllowFloat)) => NodeKind::Arguments,
            (_, Some(kind)) if is_constructor(kind) => NodeKind::Arguments,
            _ => NodeKind::Parentheses,
        };
        NodeRange { range: words.ranges[self.open].cover(words.ranges[self.last]), kind }
    }
}

/// The pairs of brackets after the attributes, not nested deeper than `deepest`. One that does not close ends where one
/// around it does, or with the words.
pub(super) fn groups(words: &Words, deepest: usize) -> Vec<BracketPair> {
    let mut out = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    for at in words.head..words.kinds.len() {
        let opening = match words.kinds[at] {
            Kind::LParen | Kind::LBracket => {
                if open.len() < deepest {
                    open.push(at);
                }
                continue;
            }
            Kind::RParen => Kind::LParen,
            Kind::RBracket => Kind::LBracket,
            _ => continue,
        };
        let Some(partner) = open.iter().rposition(|o| words.kinds[*o] == opening) else { continue };
        out.extend(open.drain(partner + 1..).map(|open| BracketPair { open, last: at - 1 }));
        out.extend(open.pop().map(|open| BracketPair { open, last: at }));
    }
    let last = words.kinds.len().saturating_sub(1);
    out.extend(open.into_iter().map(|open| BracketPair { open, last }));
    out
}
