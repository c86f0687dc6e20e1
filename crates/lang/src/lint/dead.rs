//! W0304: what makes no difference, as far as one look at it tells. What takes a proof is for the static checker.

use super::Linted;
use super::scope::Scopes;
use super::shape;
use crate::ast::{Allow, BinaryOp, ExprId, ExprKind, Quantifier, Stmt, StmtKind};
use crate::check::Where;
use crate::items::{ItemKind, Names};
use crate::natives;
use rustc_hash::{FxHashMap, FxHashSet};
use scenelang_base::{Diagnostic, FileId, TextRange, codes};
use std::cell::LazyCell;
use std::mem::discriminant;

type Out<'o> = &'o mut Vec<Diagnostic<Where>>;

/// Looks at one statement.
pub fn check(names: &dyn Names, stmt: &Stmt, scopes: &Scopes<'_>, out: Out<'_>) {
    if scopes.order.is_empty() {
        return;
    }
    let look = Look { names, stmt, hashes: LazyCell::new(|| shape::hashes(stmt)) };
    match &stmt.kind {
        StmtKind::Assert { formula } | StmtKind::Prefer { formula, .. }
            if stmt.expr(*formula).kind == ExprKind::Bool(true) =>
        {
            finding(out, stmt.expr(*formula).range, "`true` always holds, so this statement has no effect");
        }
        StmtKind::Allow { rule: Allow::Collide, args, .. } => look.collides_with_itself(args, out),
        _ => {}
    }
    let mut chained: FxHashSet<u32> = FxHashSet::default();
    for id in &scopes.order {
        match &stmt.expr(*id).kind {
            ExprKind::Compare(left, steps) => {
                if let [(_, operator, right)] = steps.as_slice()
                    && look.same(*left, *right)
                {
                    // Constants are another matter: W0303.
                    if !look.constant(*left) {
                        finding(out, stmt.expr(*id).range, "this compares something with itself")
                            .related
                            .push(here(*operator, "both sides are the same"));
                    }
                }
            }
            ExprKind::Binary(op @ (BinaryOp::And | BinaryOp::Or), ..) if !chained.contains(&id.0) => {
                let operands = look.operands(*op, *id, &mut chained);
                look.chain(*op, &operands, out);
            }
            ExprKind::Call(name, args) => look.relates_to_itself(&name.text, args, out),
            ExprKind::Binary(BinaryOp::Implies, _, left, right) => look.implication(*left, *right, out),
            ExprKind::Quantified(Quantifier::Forall, _, _, body) if stmt.expr(*body).kind == ExprKind::Bool(true) => {
                finding(out, stmt.expr(*body).range, "`true` does not depend on the variable of the quantifier");
            }
            _ => {}
        }
    }
}

fn finding<'o>(out: Out<'o>, range: TextRange, message: impl Into<String>) -> &'o mut Diagnostic<Where> {
    out.push(Diagnostic::new(codes::W0304, Where::Here(range), message));
    out.last_mut().expect("it was pushed just now")
}

fn here(range: TextRange, message: &str) -> scenelang_base::Label<Where> {
    scenelang_base::Label { place: Where::Here(range), message: message.to_owned() }
}

struct Look<'a, F: FnOnce() -> Vec<u64>> {
    names: &'a dyn Names,
    stmt: &'a Stmt,
    /// Of all expressions; most statements have nothing to compare.
    hashes: LazyCell<Vec<u64>, F>,
}

impl<F: FnOnce() -> Vec<u64>> Look<'_, F> {
    /// Whether two expressions have the same value wherever they stand. Each `rand` or `oneOf` is a draw of its own.
    fn same(&self, a: ExprId, b: ExprId) -> bool {
        let (x, y) = (&self.stmt.expr(a).kind, &self.stmt.expr(b).kind);
        let alike = || self.hashes[a.0 as usize] == self.hashes[b.0 as usize];
        discriminant(x) == discriminant(y)
            && alike()
            && shape::same((self.stmt, a), (self.stmt, b))
            && !self.any(a, |kind| self.may_draw(kind))
    }

    /// Whether a part of an expression, or itself, is such.
    fn any(&self, id: ExprId, such: impl Fn(&ExprKind) -> bool) -> bool {
        let mut open = vec![id];
        while let Some(id) = open.pop() {
            let kind = &self.stmt.expr(id).kind;
            if such(kind) {
                return true;
            }
            kind.for_each_child(|child| open.push(child));
        }
        false
    }

    fn may_draw(&self, kind: &ExprKind) -> bool {
        let ExprKind::Call(name, _) = kind else { return false };
        let library = || self.names.predicate(&name.text).is_some_and(|p| p.library);
        natives::is_draw(&name.text) || !(natives::is_built_in(&name.text) || library())
    }

    fn constant(&self, id: ExprId) -> bool {
        !self.any(id, |kind| matches!(kind, ExprKind::Name(_) | ExprKind::Objects | ExprKind::Own(_)))
    }

    /// What a chain of `and` or of `or` joins, in the order of the text; its operators are marked as seen.
    fn operands(&self, op: BinaryOp, root: ExprId, chained: &mut FxHashSet<u32>) -> Vec<ExprId> {
        let mut operands = Vec::new();
        let mut open = vec![root];
        while let Some(id) = open.pop() {
            match &self.stmt.expr(id).kind {
                ExprKind::Binary(o, _, left, right) if *o == op => {
                    chained.insert(id.0);
                    open.extend([*right, *left]);
                }
                _ => operands.push(id),
            }
        }
        operands
    }

    fn chain(&self, op: BinaryOp, operands: &[ExprId], out: Out<'_>) {
        let word = if op == BinaryOp::And { "and" } else { "or" };
        let mut seen: FxHashMap<u64, ExprId> = FxHashMap::default();
        for id in operands {
            let expr = self.stmt.expr(*id);
            if let ExprKind::Bool(value) = expr.kind {
                let message = match (op, value) {
                    (BinaryOp::And, true) | (BinaryOp::Or, false) => format!("`{word} {value}` has no effect"),
                    _ => format!("with `{word} {value}` the other conditions have no effect"),
                };
                finding(out, expr.range, message);
                continue;
            }
            match seen.get(&self.hashes[id.0 as usize]) {
                Some(first) if self.same(*first, *id) => {
                    finding(out, expr.range, "this condition occurs twice")
                        .related
                        .push(here(self.stmt.expr(*first).range, "it first occurs here"));
                }
                Some(_) => {}
                None => {
                    seen.insert(self.hashes[id.0 as usize], *id);
                }
            }
        }
    }

    fn implication(&self, left: ExprId, right: ExprId, out: Out<'_>) {
        let (condition, conclusion) = (self.stmt.expr(left), self.stmt.expr(right));
        match (&condition.kind, &conclusion.kind) {
            (ExprKind::Bool(true), _) => {
                finding(out, condition.range, "`true implies` has no effect");
            }
            (ExprKind::Bool(false), _) => {
                finding(out, condition.range, "with `false implies` the rest has no effect");
            }
            (_, ExprKind::Bool(true)) => {
                finding(out, conclusion.range, "with `implies true` the rest has no effect");
            }
            _ if self.same(left, right) => {
                finding(out, conclusion.range, "this follows from itself")
                    .related
                    .push(here(condition.range, "the condition is the same"));
            }
            _ => {}
        }
    }

    /// `near(desk, desk, 1)`: a relation of the library between an object and itself.
    fn relates_to_itself(&self, relation: &str, args: &[ExprId], out: Out<'_>) {
        let is_known = natives::is_built_in(relation) || self.names.predicate(relation).is_some_and(|p| p.library);
        let [a, b, ..] = args else { return };
        if is_known && self.is_object(*a) && self.same(*a, *b) {
            let message = format!("`{relation}` relates an object to itself");
            finding(out, self.stmt.expr(*b).range, message)
                .related
                .push(here(self.stmt.expr(*a).range, "the same object"));
        }
    }

    /// Whether an expression is an object by its form: the name of one, or an element of an array.
    fn is_object(&self, id: ExprId) -> bool {
        match &self.stmt.expr(id).kind {
            ExprKind::Name(name) => self.names.item(name) == Some(ItemKind::Object),
            kind => matches!(kind, ExprKind::Index(..)),
        }
    }

    fn collides_with_itself(&self, args: &[ExprId], out: Out<'_>) {
        let [a, b] = args else { return };
        if self.is_object(*a) && self.same(*a, *b) {
            finding(out, self.stmt.expr(*b).range, "an object never collides with itself")
                .notes
                .push("name the two objects that may overlap".to_owned());
        }
    }
}

/// Statements of a file that repeat an earlier one of it. `drawing`: user predicates that draw random numbers.
pub fn repeated(statements: &[Linted<'_>], drawing: impl Fn(&str) -> bool, out: &mut Vec<Diagnostic>) {
    let mut seen: FxHashMap<(Option<FileId>, u64), usize> = FxHashMap::default();
    seen.reserve(statements.len());
    for (i, Linted { place, uses, sound, .. }) in statements.iter().enumerate() {
        let Some(shape) = uses.shape.filter(|_| *sound && !uses.draws && !uses.calls.iter().any(|c| drawing(c))) else {
            continue;
        };
        let first = *seen.entry((place.file, shape)).or_insert(i);
        if first == i {
            continue;
        }
        let first = &statements[first].place;
        let (Some(at), Some(before)) = (place.span(place.stmt.range), first.span(first.stmt.range)) else { continue };
        if at != before && shape::same_statement(first.stmt, place.stmt) {
            let d = Diagnostic::new(codes::W0304, at, "this statement is repeated");
            out.push(
                d.related(before, "first stated here")
                    .note("a program is a set of statements, so repeating one has no effect"),
            );
        }
    }
}
