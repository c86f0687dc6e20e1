//! A program that asks for a little less: to find how much of what a statement asks for is possible.

use super::tape::{Claim, Term};
use crate::eval::{Scratch, Value};
use crate::number::Algebra;
use scenelang_lang::program::{Comparison, Formula, Node, NodeId, Owner, Pinned, Program, RegionId};

/// What is asked for less strictly than the program does.
#[derive(Clone, Copy, Debug)]
pub(super) enum Loosened {
    /// A comparison in the conjunctions of a statement may be missed by so much.
    Missed { statement: usize, node: NodeId, by: f64 },
    /// The left side of a comparison is at least so much (`upper`: at most), whatever it is compared with.
    Left { statement: usize, node: NodeId, bound: f64, upper: bool },
    /// Another number stands in a statement.
    Number { statement: usize, node: NodeId, to: f64 },
    /// A region has another extent.
    Size { region: RegionId, axis: usize, to: f64 },
}

/// That a node holds.
pub(super) fn truth(scratch: &Scratch<Term>, id: NodeId) -> Option<Claim> {
    match scratch.value(id) {
        Ok(Value::Truth(truth)) => Some(truth.holds),
        _ => None,
    }
}

impl Loosened {
    pub fn statement(&self) -> Option<usize> {
        match self {
            Self::Missed { statement, .. } | Self::Left { statement, .. } | Self::Number { statement, .. } => {
                Some(*statement)
            }
            Self::Size { .. } => None,
        }
    }

    /// Whether it stands in place of a whole statement.
    pub fn replaces(&self, program: &Program, statement: usize) -> bool {
        let Self::Size { region, .. } = self else { return false };
        let sizes = |pin: &scenelang_lang::program::Pin| {
            pin.owner == Owner::Region(*region) && pin.property == Pinned::Scale && pin.constraint == statement
        };
        program.pins.iter().any(sizes)
    }

    /// The formula of a statement with another number in it.
    pub fn altered(&self, formula: &Formula, of: usize) -> Option<Formula> {
        let Self::Number { statement, node, to } = *self else { return None };
        if statement != of {
            return None;
        }
        let mut altered = formula.clone();
        altered.nodes[node.0 as usize] = Node::Number(to);
        Some(altered)
    }

    /// What a part of the statement says then.
    pub fn claim(&self, formula: &Formula, scratch: &Scratch<Term>, id: NodeId) -> Option<Claim> {
        match (*self, formula.node(id)) {
            (Self::Missed { node, .. } | Self::Left { node, .. }, Node::Compare(op, _, a, b)) if node == id => {
                let side = |id: &NodeId| match scratch.value(*id) {
                    Ok(Value::Number(n)) => Some(n),
                    _ => None,
                };
                match *self {
                    Self::Left { bound, upper: true, .. } => Some((-side(a)?).at_least(-bound)),
                    Self::Left { bound, .. } => Some(side(a)?.at_least(bound)),
                    Self::Missed { by, .. } => {
                        let (a, b) = (side(a)?, side(b)?);
                        let upper = matches!(op, Comparison::Le | Comparison::Lt);
                        Some(if upper { b - a } else { a - b }.at_least(-by))
                    }
                    _ => None,
                }
            }
            (Self::Missed { .. } | Self::Left { .. }, Node::And(parts)) => {
                let own = parts.iter().map(|part| self.claim(formula, scratch, *part)).collect::<Option<Vec<Claim>>>();
                own.map(|own| super::tape::all(&own))
            }
            _ => truth(scratch, id),
        }
    }
}
