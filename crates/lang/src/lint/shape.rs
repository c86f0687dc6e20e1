//! Whether two expressions say the same: the same names, numbers and operators, however they are spelt and spaced.

use super::scope::roots;
use crate::ast::{Expr, ExprId, ExprKind, Stmt, StmtKind};
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};
use std::mem::discriminant;

/// A number for each expression of a statement; expressions that say the same have the same one.
pub fn hashes(stmt: &Stmt) -> Vec<u64> {
    let mut out: Vec<u64> = Vec::with_capacity(stmt.exprs.len());
    for expr in &stmt.exprs {
        let mut h = FxHasher::default();
        own(&expr.kind, &mut h);
        expr.kind.for_each_child(|child| out[child.0 as usize].hash(&mut h));
        out.push(h.finish());
    }
    out
}

/// What an expression is, its parts left out.
fn own(kind: &ExprKind, h: &mut FxHasher) {
    discriminant(kind).hash(h);
    match kind {
        ExprKind::Number(x, unit) => (x.to_bits(), unit).hash(h),
        ExprKind::Text(text) => text.hash(h),
        ExprKind::Bool(value) => value.hash(h),
        ExprKind::Name(name) => name.hash(h),
        ExprKind::Member(_, name) | ExprKind::Own(name) => name.text.hash(h),
        ExprKind::Binary(op, ..) => op.hash(h),
        ExprKind::Compare(_, steps) => steps.iter().for_each(|(op, ..)| op.hash(h)),
        ExprKind::Call(name, args) => (&name.text, args.len()).hash(h),
        ExprKind::Quantified(quantifier, name, ..) => (quantifier, &name.text).hash(h),
        ExprKind::Objects | ExprKind::Index(..) | ExprKind::Neg(_) | ExprKind::Not(_) => {}
        ExprKind::Where(..) | ExprKind::Range(..) | ExprKind::Error => {}
    }
}

/// Whether two expressions say the same. What did not parse is like nothing else.
pub fn same(a: (&Stmt, ExprId), b: (&Stmt, ExprId)) -> bool {
    let mut pairs = vec![(a.1, b.1)];
    while let Some((x, y)) = pairs.pop() {
        let (x, y) = (a.0.expr(x), b.0.expr(y));
        if !alike(x, y) {
            return false;
        }
        let mut parts = Vec::new();
        x.kind.for_each_child(|child| parts.push(child));
        let mut parts = parts.into_iter();
        y.kind.for_each_child(|child| pairs.extend(parts.next().map(|part| (part, child))));
    }
    true
}

/// Whether two expressions are alike but for their parts, of which they have the same number.
fn alike(x: &Expr, y: &Expr) -> bool {
    use ExprKind::*;
    match (&x.kind, &y.kind) {
        (Number(a, u), Number(b, v)) => a.to_bits() == b.to_bits() && u == v,
        (Text(a), Text(b)) => a == b,
        (Bool(a), Bool(b)) => a == b,
        (Name(a), Name(b)) => a == b,
        (Member(_, a), Member(_, b)) | (Own(a), Own(b)) => a.text == b.text,
        (Binary(a, ..), Binary(b, ..)) => a == b,
        (Compare(_, a), Compare(_, b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.0 == b.0),
        (Call(a, p), Call(b, q)) => a.text == b.text && p.len() == q.len(),
        (Quantified(a, n, ..), Quantified(b, m, ..)) => a == b && n.text == m.text,
        (Error, Error) => false,
        (a, b) => discriminant(a) == discriminant(b),
    }
}

/// A number for a whole statement, for those that may be repeated: assertions and allowances. Attributes and comments do
/// not count; nor does the order of the two objects that may collide.
pub fn statement(stmt: &Stmt, hashes: &[u64]) -> Option<u64> {
    let mut parts: Vec<u64> = roots(stmt).into_iter().map(|root| hashes[root.0 as usize]).collect();
    let mut h = FxHasher::default();
    match &stmt.kind {
        StmtKind::Assert { .. } => {}
        StmtKind::Allow { rule, .. } => {
            rule.hash(&mut h);
            parts.sort_unstable();
        }
        _ => return None,
    }
    parts.hash(&mut h);
    Some(h.finish())
}

/// Whether two statements with the same number say the same.
pub fn same_statement(a: &Stmt, b: &Stmt) -> bool {
    match (&a.kind, &b.kind) {
        (StmtKind::Assert { formula: x }, StmtKind::Assert { formula: y }) => same((a, *x), (b, *y)),
        (StmtKind::Allow { rule: r, args: x, .. }, StmtKind::Allow { rule: s, args: y, .. }) => {
            let fits =
                |order: &[ExprId]| x.len() == order.len() && x.iter().zip(order).all(|(x, y)| same((a, *x), (b, *y)));
            let turned: Vec<ExprId> = y.iter().rev().copied().collect();
            r == s && (fits(y) || fits(&turned))
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::parse_statement;

    #[test]
    fn spelling_and_blanks_are_of_no_account() {
        let cases = [
            ("assert a && not b;", "@req(\"x\") assert a  and ! b;", true),
            ("assert (a.pos.x) = 1;", "assert a.pos.x == 1;", true),
            ("assert a = 30cm;", "assert a = 30;", false),
            ("assert near(a, b, 1);", "assert near(b, a, 1);", false),
            ("assert forall x in s: p(x);", "assert forall y in s: p(y);", false),
            ("assert a - b = c;", "assert a + b = c;", false),
            ("assert a < b;", "assert a <= b;", false),
            ("allowCollide(a, b);", "allowCollide(b, a);", true),
            ("allowCollide(a, a);", "allowCollide(b, a);", false),
            ("allowOutside(a);", "allowFloat(a);", false),
            ("assert a = ;", "assert a = ;", false),
        ];
        for (a, b, expected) in cases {
            let (a, b) = (parse_statement(a).0, parse_statement(b).0);
            let number = |s: &Stmt| statement(s, &hashes(s));
            assert_eq!(same_statement(&a[0], &b[0]), expected, "{a:?} {b:?}");
            assert!(!expected || number(&a[0]) == number(&b[0]), "{a:?} {b:?}");
        }
    }
}
