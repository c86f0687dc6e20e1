//! The parts of a conjunction, each judged by itself: which of them decides, and how far the others are from failing.

use crate::Snapshot;
use crate::diagnostics::in_words;
use scenelang_base::TextRange;
use scenelang_lang::ast::{BinaryOp, ExprId, ExprKind, Quantifier, Stmt, StmtKind};
use scenelang_lang::db::Cancelled;
use scenelang_lang::program::{Constraint, Formula, Node, NodeId, Unit};
use scenelang_verify::{World, judge};

/// A part of a conjunction, as written, and what came of it.
pub(crate) struct Conjunct {
    /// Its text, blanks folded.
    pub text: String,
    /// Whether it holds.
    pub holds: bool,
    /// By how much, in words; `None`: it has no measure.
    pub margin: Option<String>,
}

/// The parts of a constraint of the main file that is `A and B and …`; nothing where it is none, or a part cannot be judged.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub(crate) fn parts(snapshot: &Snapshot, constraint: &Constraint) -> Result<Vec<Conjunct>, Cancelled> {
    let written = |stmt: &Stmt, formula: ExprId| {
        let mut written = Vec::new();
        conjuncts(stmt, formula, &mut written);
        if written.len() < 2 { Vec::new() } else { written }
    };
    Ok(judged(snapshot, constraint, &written)?.unwrap_or_default())
}

/// The innermost part of a conjunction that holds an offset, also of one behind `forall`: of several instances the one that
/// decides. `None`: the constraint is no conjunction there.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub(crate) fn part_at(
    snapshot: &Snapshot,
    constraint: &Constraint,
    offset: u32,
) -> Result<Option<Conjunct>, Cancelled> {
    let Some(at) = offset.checked_sub(constraint.span.range.start) else { return Ok(None) };
    let written = |stmt: &Stmt, formula: ExprId| innermost(stmt, formula, at).into_iter().collect();
    Ok(judged(snapshot, constraint, &written)?.and_then(|parts| parts.into_iter().next()))
}

/// Parts of a constraint, judged; `None`: one of them cannot be. `written` says which they are.
fn judged(
    snapshot: &Snapshot,
    constraint: &Constraint,
    written: &dyn Fn(&Stmt, ExprId) -> Vec<TextRange>,
) -> Result<Option<Vec<Conjunct>>, Cancelled> {
    let Some(layout) = snapshot.layout().filter(|l| l.read.usable).map(|l| &l.read.layout) else { return Ok(None) };
    let meanings = snapshot.meanings()?;
    let own = |stmt: &Stmt, offset: u32| stmt.range.shifted(offset).end == constraint.span.range.end;
    let found = meanings.statements.iter().find(|(place, _)| own(place.stmt, place.offset));
    let Some((place, _)) = found.filter(|_| constraint.span.file == snapshot.main()) else { return Ok(None) };
    let (StmtKind::Assert { formula } | StmtKind::Prefer { formula, .. }) = &place.stmt.kind else { return Ok(None) };
    let written = written(place.stmt, *formula);
    if written.is_empty() {
        return Ok(None);
    }
    let compiled = snapshot.compiled()?;
    let world = World::new(&compiled.program, layout, &snapshot.judging().options);
    let mut leaves = Vec::new();
    conditions(&constraint.formula, constraint.formula.root, &mut leaves);
    let start = constraint.span.range.start;
    let judged = written.into_iter().map(|range| {
        let range = range.shifted(place.offset);
        let inside = |leaf: &&NodeId| {
            let own = constraint.formula.ranges.get(leaf.0 as usize).map(|own| own.shifted(start));
            own.is_some_and(|own| range.start <= own.start && own.end <= range.end)
        };
        let mut worst: Option<(bool, f64, Unit)> = None;
        for leaf in leaves.iter().filter(inside) {
            let truth = judge(&Formula { root: *leaf, ..constraint.formula.clone() }, &world).ok()?;
            if worst.is_none_or(|(holds, margin, _)| (truth.holds, truth.margin) < (holds, margin)) {
                worst = Some((truth.holds, truth.margin, truth.unit));
            }
        }
        let (holds, margin, unit) = worst?;
        let text = snapshot.text().get(range.bytes())?.split_whitespace().collect::<Vec<_>>().join(" ");
        Some(Conjunct { text, holds, margin: margin.is_finite().then(|| in_words(margin, unit)) })
    });
    Ok(judged.collect())
}

/// The part of a conjunction around an offset from the beginning of the statement.
fn innermost(stmt: &Stmt, formula: ExprId, at: u32) -> Option<TextRange> {
    let around = |id: ExprId| {
        let range = stmt.expr(id).range;
        range.start <= at && at <= range.end
    };
    let (mut id, mut found) = (formula, None);
    loop {
        id = match &stmt.expr(id).kind {
            ExprKind::Binary(BinaryOp::And, _, left, right) => {
                let side = [*left, *right].into_iter().find(|side| around(*side))?;
                found = Some(side);
                side
            }
            ExprKind::Quantified(Quantifier::Forall, _, _, body) if around(*body) => *body,
            _ => break,
        };
    }
    found.map(|id| stmt.expr(id).range)
}

/// The operands of a chain of `and`, from the left.
fn conjuncts(stmt: &Stmt, id: ExprId, out: &mut Vec<TextRange>) {
    // A chain leans to the left, so the right operands are found first.
    let (mut id, mut found) = (id, Vec::new());
    while let ExprKind::Binary(BinaryOp::And, _, left, right) = &stmt.expr(id).kind {
        found.push(stmt.expr(*right).range);
        id = *left;
    }
    found.push(stmt.expr(id).range);
    out.extend(found.into_iter().rev());
}

fn conditions(formula: &Formula, id: NodeId, out: &mut Vec<NodeId>) {
    let mut left = vec![id];
    while let Some(id) = left.pop() {
        match formula.node(id) {
            Node::And(list) => left.extend(list.iter().rev()),
            _ => out.push(id),
        }
    }
}
