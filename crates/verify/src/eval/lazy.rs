//! Conjunctions whose parts are looked at only where they have a say, for who judges the same formula in many instances.
//!
//! `forall i, j: i < j implies gap(a[i], a[j]) >= 1` has as many parts again that hold whatever the gap is. Such a part has at
//! least the margin of the fact that decides it; where the parts before it have no more, its gap is not measured. The result
//! is that of the evaluator, to the last bit.

use super::connective::truth;
use super::value::{EvalError, Truth, Value};
use super::{Scratch, cone};
use crate::world::World;
use scenelang_lang::program::{Arg, BuiltIn, Formula, Node, NodeId};

/// A conjunction in parts.
#[derive(Clone, Debug)]
pub struct Lazy {
    parts: Vec<Part>,
}

#[derive(Clone, Debug)]
struct Part {
    /// It holds with at least this margin, and nothing in it can fail.
    least: Option<f64>,
    /// What it depends on, itself last; without what an earlier part needs in any case.
    nodes: Vec<NodeId>,
}

impl Lazy {
    /// A formula in an instance, of which only poses change from now on; `None`: there is nothing to gain.
    pub fn of(formula: &Formula, world: &World<f64>) -> Option<Self> {
        let Node::And(parts) = formula.root_node() else { return None };
        let mut known = vec![false; formula.nodes.len()];
        let mut scratch = Scratch::new();
        let part = |&node: &NodeId| {
            let least = least(formula, node, world, &mut scratch);
            let nodes: Vec<NodeId> = cone(formula, node).into_iter().filter(|n| !known[n.0 as usize]).collect();
            if least.is_none() {
                nodes.iter().for_each(|n| known[n.0 as usize] = true);
            }
            Part { least, nodes }
        };
        let parts: Vec<Part> = parts.iter().map(part).collect();
        parts.iter().any(|part| part.least.is_some()).then_some(Self { parts })
    }
}

impl Scratch<f64> {
    /// As [`Self::evaluate`].
    ///
    /// # Errors
    /// The first reason, in the order of the nodes, why it cannot be judged.
    pub fn evaluate_lazily(
        &mut self,
        formula: &Formula,
        lazy: &Lazy,
        world: &World<f64>,
    ) -> Result<Value<f64>, EvalError> {
        let mut joined = Truth::discrete(true);
        for part in &lazy.parts {
            if part.least.is_some_and(|least| least >= joined.margin) {
                continue;
            }
            joined = joined.and(truth(self.evaluate_cone(formula, &part.nodes, world)?));
            if !joined.holds && joined.is_discrete() {
                break;
            }
        }
        Ok(Value::Truth(joined))
    }
}

/// The margin with which a disjunction holds whatever the poses are, if it does, and nothing in it can fail.
fn least(formula: &Formula, node: NodeId, world: &World<f64>, scratch: &mut Scratch<f64>) -> Option<f64> {
    let Node::Or(parts) = formula.node(node) else { return None };
    let mut most: Option<f64> = None;
    for &part in parts {
        if !cannot_fail(formula, part, world) {
            return None;
        }
        let nodes = cone(formula, part);
        if nodes.iter().any(|n| matches!(formula.node(*n), Node::BuiltIn(..))) {
            continue;
        }
        let Ok(Value::Truth(fact)) = scratch.evaluate_cone(formula, &nodes, world) else { return None };
        if fact.holds && most.is_none_or(|most| fact.margin > most) {
            most = Some(fact.margin);
        }
    }
    most
}

/// Whether a node has a value in every instance with the same objects: comparisons of numbers and of gaps, joined by logic.
fn cannot_fail(formula: &Formula, node: NodeId, world: &World<f64>) -> bool {
    let all = |nodes: &[NodeId]| nodes.iter().all(|n| cannot_fail(formula, *n, world));
    match formula.node(node) {
        Node::Number(_) | Node::Truth(_) => true,
        Node::Compare(_, _, a, b) | Node::Iff(a, b) => all(&[*a, *b]),
        Node::Not(a) => all(&[*a]),
        Node::And(parts) | Node::Or(parts) => all(parts),
        Node::BuiltIn(BuiltIn::Gap | BuiltIn::Collides, args) => {
            args.iter().all(|arg| matches!(arg, Arg::Object(id) if world.object(*id).is_ok()))
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Options;
    use scenelang_lang::compile_text;
    use scenelang_layout::{Layout, Placement, Vec3};
    use std::path::Path;

    /// The assertion of a program with five boxes, and the boxes so far apart.
    fn judged(assertion: &str, step: f64) -> (Option<usize>, usize) {
        let text = format!("object a[5];\nassert {assertion};");
        let compiled = compile_text("t.scene", Path::new("t.scene"), &text, scenelang_lang::Options::default());
        let program = compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
        let place = |i: usize| Placement {
            pos: Vec3::new(step * i as f64, 0.0, 0.0),
            rot: Vec3::new(0.0, 10.0 * i as f64, 0.0),
            scale: Vec3::repeat(0.5),
            parts: Vec::new(),
            surface: None,
            joints: Vec::new(),
        };
        let objects = (0..5).map(|i| (format!("a[{i}]").into(), place(i))).collect();
        let world = World::<f64>::new(&program, &Layout { objects, ..Layout::default() }, &Options::default());
        let formula = &program.constraints[0].formula;
        let measures = |node: &&NodeId| matches!(formula.node(**node), Node::BuiltIn(..));
        let all = (0..=formula.root.0).map(NodeId).collect::<Vec<_>>();
        let of = |scratch: &Scratch<f64>| {
            all.iter().filter(measures).filter(|n| scratch.values.get(n.0 as usize).is_some_and(Result::is_ok)).count()
        };
        let (mut scratch, mut fresh) = (Scratch::new(), Scratch::new());
        let whole = scratch.evaluate(formula, &world);
        let lazy = Lazy::of(formula, &world);
        let looked = lazy.map(|lazy| {
            assert_eq!(fresh.evaluate_lazily(formula, &lazy, &world), whole, "{assertion} {step}");
            of(&fresh)
        });
        (looked, of(&scratch))
    }

    #[test]
    fn pairs_that_have_no_say_are_not_measured() {
        let pairs = "forall i in 0..5: forall j in 0..5: i < j implies gap(a[i], a[j]) >= 0.3";
        for step in [0.1, 0.6, 0.8, 3.0] {
            assert_eq!(judged(pairs, step), (Some(11), 25), "{step}");
        }
    }

    #[test]
    fn what_may_fail_or_depends_on_poses_is_looked_at() {
        for assertion in [
            "forall i in 0..5: forall j in 0..5: i < j implies distance(a[i], a[j]) >= 1 / a[i].pos.x",
            "forall x in a: forall y in a: x.pos.x < y.pos.x implies gap(x, y) > 0.1",
            "gap(a[0], a[1]) > 0",
        ] {
            assert_eq!(judged(assertion, 0.6).0, None, "{assertion}");
        }
    }
}
