//! Nodes in tokens that are no statement: brackets, open ones too, names, calls, and what is read of things.
//!
//! Only what the tokens' order alone makes certain is recognised (`a.b[1]`, `near(`); operators join nothing here. What
//! the parser kept of the statement (names that it declares, its target) is taken as the parser has it.

use super::build::NodeRange;
use super::kind::NodeKind;
use super::outline::{BracketPair, groups, parts};
use crate::ast::Stmt;
use crate::parse::words::{Words, ends_value, is_constructor};
use crate::token::Kind;
use rustc_hash::FxHashSet;
use scenelang_base::TextRange;

/// Brackets and dots that nest deeper than this are leaves only. What does not parse may nest as it likes, and whoever
/// walks a tree should not have to fear for the stack.
const DEEPEST: usize = 200;

/// The nodes of the broken statement at `body`; `kept` is what the parser could keep of it.
pub(super) fn pieces(body: TextRange, kept: &[Stmt], words: &Words, out: &mut Vec<NodeRange>) {
    out.push(NodeRange { range: body, kind: NodeKind::Error });
    let first = out.len();
    kept.iter().for_each(|stmt| parts(stmt, out));
    // Several statements may have been kept of the same words.
    let mut known = FxHashSet::default();
    let mut at = 0;
    out.retain(|piece| {
        at += 1;
        at <= first || !piece.range.is_empty() && known.insert((piece.range, piece.kind))
    });
    let known: FxHashSet<TextRange> = known.into_iter().map(|(range, _)| range).collect();
    let groups = groups(words, DEEPEST);
    let mut chains = Chains { words, ends: vec![None; words.kinds.len()], out: Vec::new() };
    for group in &groups {
        chains.ends[group.open] = Some(group.last);
    }
    (words.head..words.kinds.len()).for_each(|at| chains.at(at));
    let brackets = groups.iter().map(|group: &BracketPair| group.piece(words));
    out.extend(chains.out.into_iter().chain(brackets).filter(|piece| !known.contains(&piece.range)));
}

struct Chains<'w> {
    words: &'w Words,
    /// Of each opening bracket, the last word of its pair.
    ends: Vec<Option<usize>>,
    out: Vec<NodeRange>,
}

impl Chains<'_> {
    fn kind(&self, at: usize) -> Option<Kind> {
        self.words.kinds.get(at).copied()
    }

    fn push(&mut self, from: usize, to: usize, kind: NodeKind) {
        let range = self.words.ranges[from].cover(self.words.ranges[to]);
        self.out.push(NodeRange { range, kind });
    }

    /// What begins at a word: a name or a literal, a call; then `.property` and `[index]` as long as they follow.
    fn at(&mut self, start: usize) {
        let before = start.checked_sub(1).and_then(|at| self.kind(at));
        let opens = |chains: &Self, at: usize| chains.kind(at) == Some(Kind::LParen) && chains.ends[at].is_some();
        let mut end = start;
        match self.words.kinds[start] {
            Kind::Dot if !before.is_some_and(ends_value) => {
                let named = self.kind(start + 1) == Some(Kind::Ident);
                if named {
                    self.push(start + 1, start + 1, NodeKind::Property);
                }
                self.push(start, start + usize::from(named), NodeKind::Own);
                return;
            }
            Kind::Ident if before == Some(Kind::Dot) => return,
            Kind::Ident if matches!(before, Some(Kind::Forall | Kind::Exists)) => {
                self.push(start, start, NodeKind::Name);
                return;
            }
            kind if (kind == Kind::Ident || is_constructor(kind)) && opens(self, start + 1) => {
                if before == Some(Kind::Predicate) {
                    self.push(start, start, NodeKind::Name);
                    return;
                }
                end = self.ends[start + 1].unwrap_or(start + 1);
                self.push(start, end, NodeKind::Call);
            }
            Kind::Ident => self.push(start, start, NodeKind::NameRef),
            Kind::Objects => self.push(start, start, NodeKind::Objects),
            Kind::Number => self.push(start, start, NodeKind::Number),
            Kind::Str => self.push(start, start, NodeKind::Text),
            Kind::True | Kind::False => self.push(start, start, NodeKind::Bool),
            Kind::LParen if !before.is_some_and(|b| ends_value(b) || is_constructor(b)) && opens(self, start) => {
                end = self.ends[start].unwrap_or(start);
            }
            _ => return,
        }
        for _ in 0..DEEPEST {
            match self.kind(end + 1) {
                Some(Kind::Dot) if self.kind(end + 2) == Some(Kind::Ident) => {
                    self.push(end + 2, end + 2, NodeKind::Property);
                    end += 2;
                    self.push(start, end, NodeKind::Member);
                }
                Some(Kind::Dot) => {
                    end += 1;
                    self.push(start, end, NodeKind::Member);
                    return;
                }
                Some(Kind::LBracket) => {
                    let Some(last) = self.ends[end + 1] else { return };
                    end = last;
                    self.push(start, end, NodeKind::Index);
                }
                _ => return,
            }
        }
    }
}
