//! The stated constraints as terms: top-level conjunctions taken apart, each with what it touches.
//!
//! A term is small, so that moving one object needs only the terms that read it. The parts of a preference over
//! many objects share its weight: what comes closer to holding is better, though only what holds as a whole counts in the end.

use crate::Reads;
use scenelang_lang::Program;
use scenelang_lang::program::{ConstraintKind, Formula, Node, NodeId, ObjectId};

/// A preference that speaks of no more objects than so is one term: each of them concerns most of it.
const FEW: usize = 4;

/// How a term counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Force {
    /// It must hold.
    Hard,
    /// It counts by this weight.
    Soft(f64),
}

/// A part of a constraint that is judged by itself.
#[derive(Clone, Debug)]
pub struct Term {
    /// The constraint that it is a part of: an index into `Program::constraints`; none of P-OPEN.
    pub constraint: usize,
    /// The object of P-OPEN, which stands in no program.
    pub opens: Option<ObjectId>,
    /// Hard or soft.
    pub force: Force,
    /// What must hold.
    pub formula: Formula,
    /// What it depends on.
    pub reads: Reads,
}

impl Term {
    /// Whether it must hold.
    pub fn is_hard(&self) -> bool {
        self.force == Force::Hard
    }

    fn new(constraint: usize, force: Force, formula: Formula) -> Self {
        Self { constraint, opens: None, force, reads: Reads::of(&formula), formula }
    }
}

impl std::ops::Deref for Term {
    type Target = Reads;

    fn deref(&self) -> &Reads {
        &self.reads
    }
}

/// All terms of a program; pins are none: they are obeyed, not searched for.
pub fn split(program: &Program) -> Vec<Term> {
    let mut terms = Vec::new();
    for (index, constraint) in program.constraints.iter().enumerate() {
        match constraint.kind {
            ConstraintKind::Assert => {
                let parts = conjuncts(&constraint.formula);
                let part = |root| Term::new(index, Force::Hard, extract(&constraint.formula, root));
                terms.extend(parts.into_iter().map(part));
            }
            ConstraintKind::Prefer { weight } => {
                let mut parts = conjuncts(&constraint.formula);
                if parts.is_empty() || constraint.formula.objects().len() <= FEW {
                    parts = vec![constraint.formula.root];
                }
                let weight = weight / parts.len() as f64;
                let part = |root| Term::new(index, Force::Soft(weight), extract(&constraint.formula, root));
                terms.extend(parts.into_iter().map(part));
            }
            ConstraintKind::Pin => {}
        }
    }
    terms
}

/// The members of the top-level conjunctions of a formula; facts that hold anyway are left out.
fn conjuncts(formula: &Formula) -> Vec<NodeId> {
    let mut open = vec![formula.root];
    let mut found = Vec::new();
    while let Some(id) = open.pop() {
        match formula.node(id) {
            Node::And(parts) => open.extend(parts.iter().rev()),
            Node::Truth(true) => {}
            _ => found.push(id),
        }
    }
    found
}

/// The part of a formula that `root` needs, as a formula of its own (without places in the source).
fn extract(formula: &Formula, root: NodeId) -> Formula {
    let needed = scenelang_verify::cone(formula, root);
    let at = |id: NodeId| NodeId(needed.partition_point(|n| *n < id) as u32);
    let nodes = needed.iter().map(|id| formula.node(*id).map_children(at)).collect();
    Formula { nodes, ranges: Vec::new(), root: at(root) }
}
