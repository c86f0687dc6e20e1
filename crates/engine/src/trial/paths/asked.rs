//! What a term asks for that speaks of paths of a constant width.

use super::PathGroup;
use scenelang_lang::program::{Comparison, Formula, Node, NodeId};
use scenelang_verify::{Surroundings, World, surroundings};

/// What a term asks for: a way of a width between two things, or from one of them to any of several.
#[derive(Clone, Debug)]
pub(in crate::trial) struct PathRequest {
    pub term: usize,
    ends: [usize; 2],
    goals: Vec<usize>,
    width: f64,
    /// The preference that it is a part of; `None`: it must be there.
    preference: Option<usize>,
}

impl PathRequest {
    /// What a formula says, if it asks for a path of constant width, or for one of several that share an end.
    pub fn of(term: usize, formula: &Formula, preference: Option<usize>) -> Option<Self> {
        let one = |node: NodeId| {
            let node = match formula.node(node) {
                // How far one walks is asked of the evaluator in the end; there has to be a path at all.
                Node::Compare(Comparison::Le | Comparison::Lt, _, distance, most)
                    if matches!(formula.node(*most), Node::Number(_)) =>
                {
                    formula.node(*distance)
                }
                node => node,
            };
            let Surroundings::Path { from, to, width: Some(width) } = surroundings(formula, node) else { return None };
            Some(([from.0 as usize, to.0 as usize], width))
        };
        let all: Vec<([usize; 2], f64)> = match formula.root_node() {
            Node::Or(parts) => parts.iter().map(|&part| one(part)).collect::<Option<_>>()?,
            _ => vec![one(formula.root)?],
        };
        let &(ends, width) = all.first()?;
        let shared = |end: &usize| all.iter().all(|(ends, w)| ends.contains(end) && *w == width);
        let from = ends.into_iter().find(shared)?;
        let goals: Vec<usize> = all.iter().map(|(ends, _)| if ends[0] == from { ends[1] } else { ends[0] }).collect();
        Some(Self { term, ends: [from, goals[0]], goals, width, preference })
    }

    /// Paths by where they begin: things at which many do come first.
    pub fn together(all: &[Self], world: &World<f64>) -> Vec<(PathGroup, Vec<usize>)> {
        let mut found: Vec<(PathGroup, Vec<usize>)> = Vec::new();
        let asks = |end: usize, width: f64, preference: Option<usize>| {
            all.iter()
                .filter(|a| {
                    a.width == width
                        && a.preference == preference
                        && (a.ends[0] == end || a.goals == [a.ends[1]] && a.ends[1] == end)
                })
                .count()
        };
        for asked in all {
            let [a, b] = asked.ends;
            let turned = asked.goals.len() == 1
                && asks(b, asked.width, asked.preference) > asks(a, asked.width, asked.preference);
            let (from, goals) = if turned { (b, vec![a]) } else { (a, asked.goals.clone()) };
            let radius = ((asked.width - world.options.tolerances.contact) / 2.0).max(0.0);
            let alike = |group: &PathGroup| {
                group.from == from && group.radius == radius && group.preference == asked.preference
            };
            match found.iter_mut().find(|(group, _)| alike(group)) {
                Some((group, terms)) => {
                    group.targets.push(goals);
                    terms.push(asked.term);
                }
                None => found.push((PathGroup::new(from, goals, radius, asked.preference), vec![asked.term])),
            }
        }
        found
    }
}
