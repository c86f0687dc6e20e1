//! The parts of a statement that its author joined by `and`, so that a contradiction can name the one that matters.

use super::model::{Given, GivenSource};
use super::{Contradiction, minimal::Prover};
use scenelang_base::{Span, TextRange};
use scenelang_lang::program::{Constraint, ConstraintKind, Formula, Node, NodeId};

/// A statement of more parts than this is looked at as a whole.
const MOST_PARTS: usize = 16;

/// A part of a statement: where it is written (relative to the statement), and the nodes that it became. A part of the body
/// of a `forall` became one for each object.
pub(super) struct Part {
    pub range: TextRange,
    pub nodes: Vec<NodeId>,
}

/// The parts of a formula; the whole of it where it has one, or too many. The body of a predicate has the location of the
/// call, and is one part.
pub(super) fn parts(formula: &Formula) -> Vec<Part> {
    let range = |id: NodeId| formula.ranges[id.0 as usize];
    let mut found: Vec<Part> = Vec::new();
    let mut open = vec![formula.root];
    while let Some(id) = open.pop() {
        match formula.node(id) {
            Node::And(members) if members.iter().any(|m| range(*m) != range(id)) => {
                open.extend(members.iter().rev());
            }
            _ => match found.iter_mut().find(|part| part.range == range(id)) {
                Some(part) => part.nodes.push(id),
                None => found.push(Part { range: range(id), nodes: vec![id] }),
            },
        }
    }
    let nested = |a: &Part| {
        found.iter().any(|b| a.range != b.range && a.range.start <= b.range.start && b.range.end <= a.range.end)
    };
    if found.len() > MOST_PARTS || found.iter().any(nested) {
        return vec![Part { range: range(formula.root), nodes: vec![formula.root] }];
    }
    found
}

/// Where a part of a statement is, and its text if that was not folded.
pub(super) fn located(constraint: &Constraint, range: TextRange) -> (Span, Option<&str>) {
    let start = constraint.span.range.start;
    let span =
        Span { file: constraint.span.file, range: TextRange { start: start + range.start, end: start + range.end } };
    let whole = (constraint.span.range.end - start) as usize;
    let before = whole.checked_sub(constraint.text.len());
    let text = before.filter(|before| [7, 0].contains(before)).and_then(|before| {
        let from = (range.start as usize).checked_sub(before)?;
        constraint.text.get(from..(range.end as usize).checked_sub(before)?)
    });
    (span, text)
}

impl Prover<'_> {
    /// Notes which parts of the statements of a contradiction do without the others.
    pub(super) fn narrow_to_parts(&mut self, found: &mut Contradiction) {
        let split = |s: &usize| {
            let Constraint { formula, kind, .. } = &self.program.constraints[*s];
            // What is said of orientations is known of things, whichever part says it.
            let turns = formula.nodes.iter().any(|n| matches!(n, Node::Same(..)));
            let parts = if turns || *kind == ConstraintKind::Pin { Vec::new() } else { parts(formula) };
            (parts.len() > 1).then(|| (*s, parts.into_iter().map(|p| p.range).collect::<Vec<TextRange>>()))
        };
        let split: Vec<(usize, Vec<TextRange>)> = found.statements.iter().filter_map(split).collect();
        if split.is_empty() {
            return;
        }
        let (statements, as_usual) = (found.statements.clone(), found.as_usual);
        let usual = if as_usual { None } else { self.usual.take() };
        let model = self.model(self.whole(&statements), false);
        let mut problem = model.problem();
        let most = self.share();
        let mut without: Vec<(usize, usize)> = Vec::new();
        for (s, ranges) in &split {
            for part in (0..ranges.len()).rev() {
                without.push((*s, part));
                let drops = |g: &Given| matches!(g.what, GivenSource::Statement(s) if without.contains(&(s, g.part)));
                if self.search(&model, &mut problem, &drops, most, false).is_none() {
                    without.pop();
                }
            }
        }
        self.usual = self.usual.or(usual);
        for (s, ranges) in split {
            let kept: Vec<TextRange> =
                (0..ranges.len()).filter(|part| !without.contains(&(s, *part))).map(|part| ranges[part]).collect();
            if !kept.is_empty() && kept.len() < ranges.len() {
                found.parts.push((s, kept));
            }
        }
    }
}
