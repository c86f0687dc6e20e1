//! Statements as text without places, for comparing trees.

use scenelang_lang::ast::{Expr, ExprId, ExprKind, Stmt, StmtKind};

/// A statement without places: `assert (and (lt a 1) b)`.
pub fn stmt(stmt: &Stmt) -> String {
    let e = |id: &ExprId| expr(&stmt.exprs, *id);
    let list = |ids: &[ExprId]| ids.iter().map(e).collect::<Vec<_>>().join(" ");
    let index = |id: &Option<ExprId>| id.as_ref().map_or(String::new(), |id| format!("[{}]", e(id)));
    let body = match &stmt.kind {
        StmtKind::Declare { ty, name, size, .. } => format!("{ty:?} {}{}", name.text, index(size)),
        StmtKind::Assign { name, index: at, path, value, .. } => {
            let path: String = path.iter().map(|p| format!(".{}", p.text)).collect();
            format!("{}{}{path} <- {}", name.text, index(at), e(value))
        }
        StmtKind::Assert { formula } => format!("assert {}", e(formula)),
        StmtKind::Prefer { formula, weight } => {
            format!("prefer {} weight {}", e(formula), weight.as_ref().map_or("-".into(), e))
        }
        StmtKind::Allow { rule, args, .. } => format!("allow {rule:?} {}", list(args)),
        StmtKind::Predicate { name, params, body } => {
            let params: Vec<String> = params.iter().map(|p| format!("{:?} {}", p.ty, p.name.text)).collect();
            format!("predicate {}({}) := {}", name.text, params.join(", "), e(body))
        }
        StmtKind::Import { path, .. } => format!("import {path:?}"),
        StmtKind::Empty => ";".into(),
        StmtKind::Error => "error".into(),
    };
    let reqs: String = stmt.requirements.iter().map(|(r, _)| format!("@{r:?} ")).collect();
    let doc = if stmt.doc.is_empty() { String::new() } else { format!("{:?} ", stmt.doc) };
    format!("{doc}{reqs}{body}")
}

fn expr(exprs: &[Expr], id: ExprId) -> String {
    let e = |id: &ExprId| expr(exprs, *id);
    match &exprs[id.0 as usize].kind {
        ExprKind::Number(value, unit) => format!("{value}{}", unit.map_or(String::new(), |u| format!("{u:?}"))),
        ExprKind::Text(text) => format!("{text:?}"),
        ExprKind::Bool(value) => value.to_string(),
        ExprKind::Name(name) => name.to_string(),
        ExprKind::Objects => "OBJECTS".into(),
        ExprKind::Member(base, name) => format!("{}.{}", e(base), name.text),
        ExprKind::Own(name) => format!(".{}", name.text),
        ExprKind::Index(base, at) => format!("{}[{}]", e(base), e(at)),
        ExprKind::Neg(a) => format!("(neg {})", e(a)),
        ExprKind::Not(a) => format!("(not {})", e(a)),
        ExprKind::Binary(op, _, a, b) => format!("({op:?} {} {})", e(a), e(b)),
        ExprKind::Compare(first, steps) => {
            let steps: Vec<String> = steps.iter().map(|(op, _, right)| format!("{op:?} {}", e(right))).collect();
            format!("({} {})", e(first), steps.join(" "))
        }
        ExprKind::Call(name, args) => format!("{}({})", name.text, args.iter().map(e).collect::<Vec<_>>().join(", ")),
        ExprKind::Quantified(q, name, domain, body) => format!("({q:?} {} {}: {})", name.text, e(domain), e(body)),
        ExprKind::Where(set, filter) => format!("(where {} {})", e(set), e(filter)),
        ExprKind::Range(a, b) => format!("({} .. {})", e(a), e(b)),
        ExprKind::Error => "ERROR".into(),
    }
}
