//! What the names in a statement refer to: something that it binds itself (a quantifier's variable, a parameter), or
//! something of the program.

use crate::ast::{ExprId, ExprKind, Name, Stmt, StmtKind};
use rustc_hash::FxHashMap;

/// What binds a name within a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Binder {
    /// A parameter of the predicate, by its number.
    Parameter(usize),
    Quantifier(ExprId),
}

/// The expressions of a statement with what their names refer to.
#[derive(Debug, Default)]
pub struct Scopes<'s> {
    /// The expressions in the order of the text, each before its parts.
    pub order: Vec<ExprId>,
    /// All names that the statement binds.
    pub bound: Vec<&'s Name>,
    /// Bound names that hide one bound further out: the inner and the outer one.
    pub hiding: Vec<(&'s Name, &'s Name)>,
    binders: FxHashMap<u32, Binder>,
}

/// Work that is left to do. A list instead of recursion: trees may be high.
enum Step<'s> {
    Visit(ExprId),
    Bind(&'s Name, Binder),
    Unbind,
}

impl<'s> Scopes<'s> {
    /// Walks through a statement.
    pub fn of(stmt: &'s Stmt) -> Self {
        let mut out = Self { order: Vec::with_capacity(stmt.exprs.len()), ..Self::default() };
        let mut scope: Vec<(&Name, Binder)> = Vec::new();
        if let StmtKind::Predicate { params, .. } = &stmt.kind {
            // Two parameters of one name are an error.
            scope.extend(params.iter().enumerate().map(|(i, p)| (&p.name, Binder::Parameter(i))));
            out.bound.extend(params.iter().map(|p| &p.name));
        }
        let mut steps: Vec<Step<'_>> = Vec::with_capacity(stmt.exprs.len().min(32));
        steps.extend(roots(stmt).into_iter().rev().map(Step::Visit));
        while let Some(step) = steps.pop() {
            match step {
                Step::Visit(id) => {
                    out.order.push(id);
                    match &stmt.expr(id).kind {
                        ExprKind::Name(name) => {
                            if let Some((_, binder)) = scope.iter().rev().find(|(n, _)| n.text == *name) {
                                out.binders.insert(id.0, *binder);
                            }
                        }
                        ExprKind::Quantified(_, name, domain, body) => {
                            let bind = Step::Bind(name, Binder::Quantifier(id));
                            steps.extend([Step::Unbind, Step::Visit(*body), bind, Step::Visit(*domain)]);
                        }
                        kind => {
                            let at = steps.len();
                            kind.for_each_child(|child| steps.push(Step::Visit(child)));
                            steps[at..].reverse();
                        }
                    }
                }
                Step::Bind(name, binder) => {
                    if let Some((outer, _)) = scope.iter().rev().find(|(n, _)| n.text == name.text) {
                        out.hiding.push((name, outer));
                    }
                    out.bound.push(name);
                    scope.push((name, binder));
                }
                Step::Unbind => {
                    scope.pop();
                }
            }
        }
        out
    }

    /// What binds the name that an expression is; `None`: the program, or it is no name.
    pub fn binder(&self, id: ExprId) -> Option<Binder> {
        self.binders.get(&id.0).copied()
    }
}

/// The expressions of a statement that are no part of another, in the order of the text.
pub fn roots(stmt: &Stmt) -> Vec<ExprId> {
    match &stmt.kind {
        StmtKind::Declare { size, .. } => size.iter().copied().collect(),
        StmtKind::Assign { index, value, .. } => index.iter().chain([value]).copied().collect(),
        StmtKind::Assert { formula } => vec![*formula],
        StmtKind::Prefer { formula, weight } => std::iter::once(*formula).chain(*weight).collect(),
        StmtKind::Allow { args, .. } => args.clone(),
        StmtKind::Predicate { body, .. } => vec![*body],
        StmtKind::Import { .. } | StmtKind::Empty | StmtKind::Error => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::parse_statement;

    #[test]
    fn names_are_bound_by_the_nearest() {
        let (stmts, _) = parse_statement(
            "predicate p(Object a, Objects s) := (forall x in s: x = a) and forall a in x: exists x in a: x = y;",
        );
        let scopes = Scopes::of(&stmts[0]);
        let named: Vec<String> = scopes
            .order
            .iter()
            .filter_map(|id| match &stmts[0].expr(*id).kind {
                ExprKind::Name(n) => Some((n, scopes.binder(*id))),
                _ => None,
            })
            .map(|(name, binder)| match binder {
                None => format!("{name}"),
                Some(Binder::Parameter(i)) => format!("{name}:{i}"),
                Some(Binder::Quantifier(_)) => format!("{name}:q"),
            })
            .collect();
        assert_eq!(named.join(" "), "s:1 x:q a:0 x a:q x:q y");
        let hiding: Vec<&str> = scopes.hiding.iter().map(|(inner, _)| inner.text.as_str()).collect();
        assert_eq!(hiding, ["a"]);
        assert_eq!(scopes.bound.len(), 5);
    }
}
