//! Contradictions between assertions that need no numbers: things that are beyond each other all the way round, and a few
//! predicates of the library about the same things.

use super::Contradiction;
use super::conjuncts::located;
use scenelang_lang::program::{Constraint, ConstraintKind, Node, Program};

/// The axis along which one thing is beyond another, and whether it is the second that is.
type Order = (char, bool);

/// A predicate of the library in words, and the axis along which it is an order, if it is.
const RELATIONS: [(&str, &str, Option<Order>); 17] = [
    ("leftOf", "is on the left of", Some(('x', false))),
    ("rightOf", "is on the right of", Some(('x', true))),
    ("inFrontOf", "is in front of", Some(('z', false))),
    ("behind", "is behind", Some(('z', true))),
    ("above", "is above", Some(('y', false))),
    ("below", "is below", Some(('y', true))),
    ("on", "stands on", Some(('y', false))),
    ("restsOn", "stands on", Some(('y', false))),
    ("facing", "faces", None),
    ("parallel", "is parallel to", None),
    ("sameWay", "looks the same way as", None),
    ("oppositeWays", "looks the opposite way to", None),
    ("inside", "is inside", None),
    ("onFloor", "stands on the floor of", None),
    ("againstWall", "has its back against a wall of", None),
    ("seenLeftOf", "is, seen from the front, on the left of", None),
    ("seenRightOf", "is, seen from the front, on the right of", None),
];

/// A statement, or a part of one, that is a predicate of the library about two things.
struct Said<'p> {
    phrase: String,
    ends: [&'p str; 2],
    order: Option<Order>,
}

/// What the assertions of a contradiction say; nothing, where one of them says something else (or, if wanted, something about
/// how things are turned).
fn said<'p>(program: &'p Program, found: &Contradiction, whatever_turns: bool) -> Option<Vec<Said<'p>>> {
    let mut texts: Vec<&str> = Vec::new();
    for &statement in &found.statements {
        let constraint: &Constraint = &program.constraints[statement];
        match (constraint.kind, found.parts.iter().find(|(s, _)| *s == statement)) {
            (ConstraintKind::Pin, _) => {}
            _ if whatever_turns && constraint.formula.nodes.iter().any(|n| matches!(n, Node::Same(..))) => {}
            (_, Some((_, parts))) => {
                for part in parts {
                    texts.push(located(constraint, *part).1?);
                }
            }
            (_, None) => texts.push(&constraint.text),
        }
    }
    let parsed = |text: &&'p str| {
        let (predicate, rest) = text.split_once('(')?;
        let (_, words, order) = RELATIONS.iter().find(|(name, ..)| *name == predicate.trim())?;
        let (a, b) = rest.strip_suffix(')')?.split_once(',')?;
        let ends = [a.trim(), b.trim()];
        let is_name = |end: &str| !end.is_empty() && !end.contains(['(', ')', ',', ' ', '+', '-']);
        ends.iter().all(|e| is_name(e)).then(|| Said {
            phrase: format!("`{}` {words} `{}`", ends[0], ends[1]),
            ends,
            order: *order,
        })
    };
    texts.iter().map(parsed).collect()
}

/// That things are said to be beyond each other all the way round.
pub(super) fn circle(program: &Program, found: &Contradiction) -> Option<String> {
    let said = said(program, found, true)?;
    let axis = said.first()?.order?.0;
    let edge = |s: &Said<'_>| {
        s.order
            .filter(|(own, _)| *own == axis)
            .map(|(_, back)| (s.ends[usize::from(back)].to_owned(), s.ends[usize::from(!back)].to_owned()))
    };
    let edges: Vec<(String, String)> = said.iter().map(edge).collect::<Option<_>>()?;
    let mut order = vec![0];
    while order.len() < edges.len() {
        let end = &edges[*order.last()?].1;
        let next = (0..edges.len()).find(|i| !order.contains(i) && edges[*i].0 == *end)?;
        order.push(next);
    }
    if said.len() < 2 || edges[*order.last()?].1 != edges[0].0 {
        return None;
    }
    let phrases: Vec<&str> = order.iter().map(|i| said[*i].phrase.as_str()).collect();
    let (last, rest) = phrases.split_last()?;
    Some(format!("{} and {last}, which is circular", rest.join(", ")))
}

/// What a few assertions say of the same things, where no number tells why.
pub(super) fn exclusive(program: &Program, found: &Contradiction) -> Option<String> {
    let said = said(program, found, false).filter(|said| (2..=4).contains(&said.len()))?;
    let phrases: Vec<&str> = said.iter().map(|s| s.phrase.as_str()).collect();
    let (last, rest) = phrases.split_last()?;
    Some(format!("{}, so it cannot be that {last}", rest.join(" and ")))
}
