//! The steps of the published algorithm as traits, each with a default: what is left out of [`Steps`] is done by the
//! solver's own means.
//!
//! A step sees the layout as a [`View`] and answers with values; the frame judges every answer by the one evaluator
//! before it takes it. So no step can make a layout worse, and none has to know how a search is run.

use crate::external::view::{Concern, Proposal, View};
use crate::problem::pose::Pose;
use scenelang_lang::program::ObjectId;

/// InitialPlacement: where an object that has no place yet could go.
pub trait Placer {
    /// Poses to choose from, in any order; the one with which least is violated is taken. None: the solver's own.
    fn place(&mut self, view: &View<'_>, object: ObjectId) -> Vec<Pose>;
}

/// PhysicsRelaxation: moves after which less overlaps and less hangs in the air.
pub trait Relaxer {
    /// Proposals, tried in order; each is taken if less is violated with it.
    fn relax(&mut self, view: &View<'_>) -> Vec<Proposal>;
}

/// SelectBatch: which of the violated constraints are taken up next.
pub trait Selector {
    /// At most `k` indices into `unsatisfied`.
    fn select(&mut self, view: &View<'_>, unsatisfied: &[Concern], k: usize) -> Vec<usize>;
}

/// Proposes moves for a batch of violated constraints.
pub trait Proposer {
    /// Proposals for a batch, best first; `round` counts from 1. Each is judged by itself: it is taken if less is
    /// violated with it and nothing is broken that held before.
    fn propose(&mut self, view: &View<'_>, batch: &[Concern], round: usize) -> Vec<Proposal>;
    /// What became of the last answer: for each proposal whether it was taken.
    fn judged(&mut self, _taken: &[bool]) {}
}

/// EnforceBounds: where to an object that is outside every region is brought back.
pub trait Bounds {
    /// A pose; taken if less is violated with it.
    fn enforce(&mut self, view: &View<'_>, object: ObjectId) -> Option<Pose>;
}

/// Steps that take the place of the solver's own, or come before them.
#[derive(Default)]
pub struct Steps<'s> {
    /// InitialPlacement.
    pub placer: Option<&'s mut dyn Placer>,
    /// PhysicsRelaxation.
    pub relaxer: Option<&'s mut dyn Relaxer>,
    pub selector: Option<&'s mut dyn Selector>,
    /// Asked in this order, in [`Steps::rounds`] rounds before the numeric proposer.
    pub proposers: Vec<&'s mut dyn Proposer>,
    /// EnforceBounds.
    pub bounds: Option<&'s mut dyn Bounds>,
    /// T: how many rounds the proposers have; 0 means 5.
    pub rounds: usize,
    /// Only the proposers propose: what they leave violated stays so.
    pub proposers_only: bool,
}

impl Steps<'_> {
    pub(crate) fn is_default(&self) -> bool {
        self.placer.is_none() && self.proposers.is_empty()
    }
    pub(crate) fn rounds(&self) -> usize {
        if self.rounds == 0 { 5 } else { self.rounds }
    }
}
