//! Different ways to satisfy a goal: of a disjunction one part is enough, and of what is counted one more. The slope of
//! such a goal speaks for the part that is nearest to holding, whichever side or object that is; so the others are tried
//! as goals of their own.

use super::DEAR;
use super::stage::Stage;
use crate::rows::Goal;
use scenelang_lang::program::{Formula, Node, NodeId, ObjectId};
use scenelang_verify::{Value, objects_of};

/// So many ways of a goal are tried.
const MOST: usize = 4;
/// So many parts of one way are goals.
const PARTS: usize = 16;

impl Stage<'_> {
    /// Whether there may be several ways to satisfy a goal. What is dear is not tried more often than it must.
    pub fn has_ways(&self, goal: Goal) -> bool {
        let choice = |node: &Node| matches!(node, Node::Or(_) | Node::AtLeast(..));
        self.cost(goal) <= DEAR && self.formula(goal).is_some_and(|(_, formula, _)| formula.nodes.iter().any(choice))
    }

    /// Ways to satisfy a goal by moving an object, the nearest first, each as parts that are to hold together. None: there
    /// is nothing to choose.
    pub fn ways(&mut self, goal: Goal, object: ObjectId) -> Vec<Vec<Goal>> {
        let Some((index, formula, from)) = self.formula(goal) else { return Vec::new() };
        self.pay(self.costs[index]);
        if self.scratch.evaluate(formula, self.state.world()).is_err() {
            return Vec::new();
        }
        let ways = self.expanded(formula, from, object);
        if ways.len() == 1 && ways[0] == [from] {
            return Vec::new();
        }
        let fits = |way: &Vec<NodeId>| way.len() <= PARTS;
        let goals = |way: Vec<NodeId>| way.into_iter().map(|part| Goal::Part(index, part)).collect();
        ways.into_iter().filter(fits).map(goals).collect()
    }

    /// The verdict and the margin of a part, as last evaluated.
    fn part(&self, part: NodeId) -> Option<(bool, f64)> {
        match self.scratch.get(part) {
            Ok(Value::Truth(t)) => Some((t.holds, t.margin)),
            _ => None,
        }
    }

    /// Parts, those that are nearest to holding first. What no move changes is not among them.
    fn by_margin(&self, parts: &[NodeId]) -> Vec<NodeId> {
        let mut known: Vec<(f64, NodeId)> =
            parts.iter().filter_map(|&part| Some((self.part(part)?.1, part))).filter(|(m, _)| m.is_finite()).collect();
        known.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        known.into_iter().map(|(_, part)| part).collect()
    }

    fn expanded(&self, formula: &Formula, node: NodeId, object: ObjectId) -> Vec<Vec<NodeId>> {
        let each = |parts: Vec<NodeId>| {
            let ways = parts.into_iter().flat_map(|part| self.expanded(formula, part, object));
            ways.take(MOST).collect::<Vec<_>>()
        };
        match formula.node(node) {
            Node::And(parts) => {
                let mut ways: Vec<Vec<NodeId>> = vec![Vec::new()];
                for &part in parts {
                    let own = self.expanded(formula, part, object);
                    let joined = ways.iter().flat_map(|way| {
                        own.iter().map(move |more| way.iter().chain(more).copied().collect::<Vec<NodeId>>())
                    });
                    ways = joined.take(MOST).collect();
                }
                if ways.len() == 1 { vec![vec![node]] } else { ways }
            }
            Node::Or(parts) => {
                let about = |part: &NodeId| objects_of(formula, *part).contains(&object);
                let own: Vec<NodeId> = self.by_margin(parts).into_iter().filter(about).collect();
                if own.len() < 2 { vec![vec![node]] } else { each(own) }
            }
            Node::AtLeast(n, parts) => {
                let (holding, failing): (Vec<NodeId>, Vec<NodeId>) =
                    parts.iter().partition(|part| self.part(**part).is_some_and(|(holds, _)| holds));
                if holding.len() + 1 != *n as usize {
                    return vec![vec![node]];
                }
                let about = |part: &NodeId| objects_of(formula, *part).contains(&object);
                let mut ways = each(self.by_margin(&failing).into_iter().filter(about).collect());
                if ways.is_empty() {
                    return vec![vec![node]];
                }
                ways.iter_mut().for_each(|way| way.extend(&holding));
                ways
            }
            _ => vec![vec![node]],
        }
    }

    /// The objects that have a say in a goal that fails because too few of some parts hold: those of each part that could
    /// be the next one. What few other statements speak of comes first, since that is what most likely has strayed.
    pub(super) fn candidates(&self, formula: &Formula, from: NodeId) -> Vec<ObjectId> {
        let mut at = from;
        loop {
            match formula.node(at) {
                Node::AtLeast(_, parts) | Node::Or(parts) => {
                    let failing =
                        parts.iter().copied().filter(|part| self.part(*part).is_some_and(|(holds, _)| !holds));
                    let parts = self.by_margin(&failing.collect::<Vec<_>>());
                    let mut found: Vec<(usize, Vec<ObjectId>)> = Vec::new();
                    for part in parts {
                        let objects = objects_of(formula, self.scratch.deciding_from(formula, part));
                        let spoken = objects.iter().map(|id| self.index.of_object(*id).len()).sum();
                        found.push((spoken, objects));
                    }
                    found.sort_by_key(|(spoken, _)| *spoken);
                    return found.into_iter().flat_map(|(_, objects)| objects).collect();
                }
                Node::And(parts) => {
                    let failing =
                        parts.iter().copied().filter(|part| self.part(*part).is_some_and(|(holds, _)| !holds));
                    match self.by_margin(&failing.collect::<Vec<_>>()).pop() {
                        Some(worst) => at = worst,
                        None => return Vec::new(),
                    }
                }
                _ => return Vec::new(),
            }
        }
    }
}
