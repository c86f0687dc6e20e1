//! Definitions that go in a circle: variables or properties defined by each other, predicates that call themselves.
//! Each circle is reported once, with its path.

use rustc_hash::FxHashMap;
use scenelang_base::{Code, Diagnostic, Span};
use smol_str::SmolStr;

/// The circles among `nodes` that are defined somewhere, each with where its members are defined, from the member that
/// is defined first. `onward` gives the names that a definition refers to.
///
/// A depth-first search without recursion; a back edge closes a circle.
pub(crate) fn circles<'n, P: Copy + Ord>(
    nodes: &[SmolStr],
    defined: impl Fn(&SmolStr) -> Option<P>,
    onward: impl Fn(P) -> &'n [SmolStr],
) -> Vec<Vec<(SmolStr, P)>> {
    let edges = |at: P| onward(at).iter().filter_map(|n| Some((n.clone(), defined(n)?))).collect::<Vec<_>>();
    let mut out = Vec::new();
    // 1: on the current path, 2: done.
    let mut state: FxHashMap<SmolStr, u8> = FxHashMap::default();
    for root in nodes {
        let Some(at) = defined(root) else { continue };
        if state.contains_key(root) {
            continue;
        }
        let mut path = vec![(root.clone(), at, edges(at))];
        state.insert(root.clone(), 1);
        while let Some((_, _, next)) = path.last_mut() {
            let Some((to, at)) = next.pop() else {
                if let Some((done, ..)) = path.pop() {
                    state.insert(done, 2);
                }
                continue;
            };
            match state.get(&to) {
                None => {
                    state.insert(to.clone(), 1);
                    path.push((to, at, edges(at)));
                }
                Some(1) => {
                    let from = path.iter().position(|(n, ..)| *n == to).unwrap_or(0);
                    let mut circle: Vec<_> = path[from..].iter().map(|(n, at, _)| (n.clone(), *at)).collect();
                    // So that the report does not depend on the search.
                    let first = (0..circle.len()).min_by_key(|i| circle[*i].1).unwrap_or(0);
                    circle.rotate_left(first);
                    out.push(circle);
                }
                Some(_) => {}
            }
        }
    }
    out
}

/// The report of a circle of `what`.
pub(crate) fn report<P: Copy>(
    circle: &[(SmolStr, P)],
    place: impl Fn(P) -> Option<Span>,
    code: Code,
    what: &str,
) -> Option<Diagnostic> {
    let path: Vec<String> = circle.iter().chain(circle.first()).map(|(n, _)| format!("`{n}`")).collect();
    let message = match circle.len() {
        1 => format!("{} refers to itself", path[0]),
        _ => format!("{what} refer to each other in a cycle: {}", path.join(" → ")),
    };
    let (first, others) = circle.split_first()?;
    let mut d = Diagnostic::new(code, place(first.1)?, message);
    for (name, at) in others {
        if let Some(span) = place(*at) {
            d = d.related(span, format!("`{name}`"));
        }
    }
    Some(d)
}
