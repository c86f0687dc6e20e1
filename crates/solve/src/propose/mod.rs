//! Proposers: given a batch of violated constraints, they change the layout so that less is violated.

mod numeric;

use crate::search::Search;
pub(crate) use numeric::Numeric;

/// Proposes moves for a batch of violated checks and keeps those that help.
pub(crate) trait Proposer {
    /// Whether anything was improved, by the weights in force.
    fn propose(&mut self, search: &mut Search<'_>, batch: &[usize]) -> bool;
}
