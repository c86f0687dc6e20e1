//! P-OPEN for the search: a term for each object of which something has to open. It is judged by the built-ins that say the
//! same, so that the search treats it like any other term.

use scenelang_engine::Reads;
use scenelang_engine::frame::terms::{Force, Term};
use scenelang_lang::program::{Arg, BuiltIn, Formula, Node, NodeId, ObjectId};
use scenelang_layout::{Joint, Motion};
use scenelang_verify::World;
use scenelang_verify::opening;
use scenelang_verify::rules::open;

/// The terms of an instance, in the order of the objects.
pub(crate) fn terms(world: &World<f64>) -> Vec<Term> {
    let asked = world.bodies().map(|(id, _)| id).filter_map(|id| Some(term(id, formula(world, id)?)));
    asked.collect()
}

/// That an object opens as far as the rule demands; `None`: it demands nothing of it.
fn formula(world: &World<f64>, id: ObjectId) -> Option<Formula> {
    let demands = open::demands(world, id);
    if demands.is_empty() {
        return None;
    }
    let all = opening::joints(world, id);
    let demand = |part: usize| demands.iter().find(|(own, _)| usize::from(*own) == part).map(|(_, amount)| *amount);
    let useful = |(part, joint): (usize, &Joint)| joint.useful.is_none_or(|useful| demand(part) == Some(useful));
    if all.iter().enumerate().all(useful) {
        return Some(call(BuiltIn::Opens, id, None));
    }
    // The program asks for less than is useful: of what turns, of what slides or of both. The same amount is asked of all
    // that moves in the same way, so it is no more than any of it can do.
    let each = |motion: Motion| {
        let own = || all.iter().enumerate().filter(|(_, joint)| joint.motion == motion);
        let most = own().filter_map(|(part, _)| demand(part)).reduce(f64::max)?;
        Some(own().map(|(_, joint)| joint.limits[1]).fold(most, f64::min))
    };
    match [each(Motion::Hinge), each(Motion::Slide)] {
        [Some(turns), Some(slides)] => {
            let mut nodes = call(BuiltIn::Opens, id, Some(turns)).nodes;
            let first = NodeId(nodes.len() as u32 - 1);
            let amount = NodeId(nodes.len() as u32);
            nodes.push(Node::Number(slides));
            nodes.push(Node::BuiltIn(BuiltIn::Slides, Box::new([Arg::Object(id), Arg::Value(amount)])));
            let root = NodeId(nodes.len() as u32);
            nodes.push(Node::And(Box::new([first, NodeId(amount.0 + 1)])));
            Some(Formula { nodes, ranges: Vec::new(), root })
        }
        [Some(turns), None] => Some(call(BuiltIn::Opens, id, Some(turns))),
        [None, Some(slides)] => Some(call(BuiltIn::Slides, id, Some(slides))),
        [None, None] => None,
    }
}

/// A built-in of an object, with an amount if there is one.
fn call(built_in: BuiltIn, id: ObjectId, amount: Option<f64>) -> Formula {
    let mut nodes: Vec<Node> = amount.map(Node::Number).into_iter().collect();
    let mut args = vec![Arg::Object(id)];
    args.extend(amount.map(|_| Arg::Value(NodeId(0))));
    let root = NodeId(nodes.len() as u32);
    nodes.push(Node::BuiltIn(built_in, args.into()));
    Formula { nodes, ranges: Vec::new(), root }
}

fn term(id: ObjectId, formula: Formula) -> Term {
    Term { constraint: usize::MAX, opens: Some(id), force: Force::Hard, reads: Reads::of(&formula), formula }
}
