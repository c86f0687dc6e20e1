//! Definitions that go in a circle: variables defined by each other, predicates that call themselves. Each circle is
//! reported once, with its path.

use crate::ast::{ExprKind, Stmt};
use crate::items::{AssignKey, Items, Place};
use rustc_hash::FxHashMap;
use scenelang_base::{Diagnostic, Span, codes};
use smol_str::SmolStr;

/// Circles among variables that are assigned.
pub fn variable_cycles(items: &Items<'_>) -> Vec<Diagnostic> {
    let definition = |name: &SmolStr| {
        let key = AssignKey { name: name.clone(), element: None, property: SmolStr::default() };
        items.assignments.get(&key).filter(|_| items.names.contains_key(name))
    };
    let nodes: Vec<SmolStr> = items.order.iter().filter(|n| definition(n).is_some()).cloned().collect();
    let edges = |name: &SmolStr| {
        definition(name).map_or(Vec::new(), |a| {
            let named = names_in(a.place.stmt);
            named.into_iter().filter(|n| definition(n).is_some()).collect()
        })
    };
    let place = |name: &SmolStr| definition(name).and_then(|a| a.place.span(a.target));
    report(&nodes, edges, place, codes::E0204, "variables")
}

/// Predicates that call themselves, directly or through others.
pub fn predicate_cycles(items: &Items<'_>, order: &[Place<'_>]) -> Vec<Diagnostic> {
    let mut nodes = Vec::new();
    for place in order {
        if let crate::ast::StmtKind::Predicate { name, .. } = &place.stmt.kind {
            nodes.push(name.text.clone());
        }
    }
    let edges = |name: &SmolStr| {
        items.predicates.get(name).map_or(Vec::new(), |p| {
            let calls = p.place.stmt.exprs.iter().filter_map(|e| match &e.kind {
                ExprKind::Call(name, _) => Some(name.text.clone()),
                _ => None,
            });
            calls.filter(|n| items.predicates.contains_key(n)).collect()
        })
    };
    let place = |name: &SmolStr| {
        items.predicates.get(name).and_then(|p| match &p.place.stmt.kind {
            crate::ast::StmtKind::Predicate { name, .. } => p.place.span(name.range),
            _ => None,
        })
    };
    report(&nodes, edges, place, codes::E0210, "predicates")
}

fn names_in(stmt: &Stmt) -> Vec<SmolStr> {
    let mut out = Vec::new();
    for e in &stmt.exprs {
        if let ExprKind::Name(n) = &e.kind
            && !out.contains(n)
        {
            out.push(n.clone());
        }
    }
    out
}

/// Depth-first search without recursion; a back edge closes a circle, reported if none of its members was before.
pub(crate) fn report(
    nodes: &[SmolStr],
    edges: impl Fn(&SmolStr) -> Vec<SmolStr>,
    place: impl Fn(&SmolStr) -> Option<Span>,
    code: scenelang_base::Code,
    what: &str,
) -> Vec<Diagnostic> {
    let mut out = Vec::new();
    // 1: on the current path, 2: done.
    let mut state: FxHashMap<SmolStr, u8> = FxHashMap::default();
    for root in nodes {
        if state.contains_key(root) {
            continue;
        }
        let mut path: Vec<(SmolStr, Vec<SmolStr>)> = vec![(root.clone(), edges(root))];
        state.insert(root.clone(), 1);
        while let Some((_, next)) = path.last_mut() {
            let Some(to) = next.pop() else {
                if let Some((done, _)) = path.pop() {
                    state.insert(done, 2);
                }
                continue;
            };
            match state.get(&to) {
                None => {
                    state.insert(to.clone(), 1);
                    let onward = edges(&to);
                    path.push((to, onward));
                }
                Some(1) => {
                    let at = path.iter().position(|(n, _)| *n == to).unwrap_or(0);
                    let circle: Vec<&SmolStr> = path[at..].iter().map(|(n, _)| n).collect();
                    if let Some(d) = describe(&circle, &place, code, what) {
                        out.push(d);
                    }
                }
                Some(_) => {}
            }
        }
    }
    out
}

fn describe(
    circle: &[&SmolStr],
    place: &impl Fn(&SmolStr) -> Option<Span>,
    code: scenelang_base::Code,
    what: &str,
) -> Option<Diagnostic> {
    // Started at the member that stands first in the text, so that the report does not depend on the search.
    let start = (0..circle.len()).min_by_key(|i| place(circle[*i]))?;
    let turned: Vec<&SmolStr> = circle.iter().cycle().skip(start).take(circle.len()).copied().collect();
    let path: Vec<String> = turned.iter().chain(turned.first()).map(|n| format!("`{n}`")).collect();
    let message = match turned.len() {
        1 => format!("{} refers to itself", path[0]),
        _ => format!("{what} refer to each other in a circle: {}", path.join(" → ")),
    };
    let mut d = Diagnostic::new(code, place(turned[0])?, message);
    for name in &turned[1..] {
        if let Some(span) = place(name) {
            d = d.related(span, format!("`{name}`"));
        }
    }
    Some(d)
}
