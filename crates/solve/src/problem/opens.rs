//! P-OPEN for the search: a term for each object of which something has to open. It is judged by the built-in that says the
//! same, so that the search treats it like any other term.

use scenelang_engine::Reads;
use scenelang_engine::frame::terms::{Force, Term};
use scenelang_lang::program::{Arg, BuiltIn, Formula, Node, NodeId, ObjectId};
use scenelang_verify::World;
use scenelang_verify::rules::open;

/// The terms of an instance, in the order of the objects.
pub(crate) fn terms(world: &World<f64>) -> Vec<Term> {
    let asked = world.bodies().map(|(id, _)| id).filter(|id| !open::demands(world, *id).is_empty());
    asked.map(term).collect()
}

fn term(id: ObjectId) -> Term {
    let call = Node::BuiltIn(BuiltIn::Opens, Box::new([Arg::Object(id)]));
    let formula = Formula { nodes: vec![call], ranges: Vec::new(), root: NodeId(0) };
    Term { constraint: usize::MAX, opens: Some(id), force: Force::Hard, reads: Reads::of(&formula), formula }
}
