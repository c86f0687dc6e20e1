//! The rounds of proposers from outside, and whatever else is taken from them: every answer is judged before it counts.

use super::bounds;
use crate::external::steps::Steps;
use crate::external::view::{Concern, Proposal, View};
use crate::pipeline::select;
use crate::problem;
use crate::problem::Phase;
use crate::problem::pose::Pose;
use crate::search::Search;
use scenelang_engine::candidate::Change;
use scenelang_lang::program::ObjectId;
use std::ops::ControlFlow;

impl Search<'_> {
    /// Runs the loop with the proposers from outside. `Break`: the caller wants no more.
    pub fn outside_rounds(
        &mut self,
        steps: &mut Steps<'_>,
        iterations: &mut usize,
        progress: &mut dyn FnMut(problem::Progress) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        if steps.proposers.is_empty() {
            return ControlFlow::Continue(());
        }
        for round in 1..=steps.rounds() {
            let violated = self.state.failing();
            if violated.is_empty() || self.is_spent(1.0) {
                break;
            }
            *iterations += 1;
            progress(self.progress(Phase::Repair, *iterations))?;
            let batch = self.outside_batch(steps, &violated);
            for proposer in &mut steps.proposers {
                let proposals = proposer.propose(&View::new(&self.state), &batch, round);
                let taken: Vec<bool> = proposals.iter().map(|p| self.take(p, true)).collect();
                proposer.judged(&taken);
            }
            self.enforce_bounds(steps);
            self.note();
        }
        ControlFlow::Continue(())
    }

    fn outside_batch(&mut self, steps: &mut Steps<'_>, violated: &[usize]) -> Vec<Concern> {
        let k = self.options.batch;
        let Some(selector) = &mut steps.selector else {
            let batch = select::batch(&self.state, violated, k, &mut self.chance);
            let view = View::new(&self.state);
            return batch.into_iter().map(|check| view.concern(check)).collect();
        };
        let view = View::new(&self.state);
        let all: Vec<Concern> = violated.iter().map(|&check| view.concern(check)).collect();
        let mut chosen = selector.select(&view, &all, k);
        chosen.truncate(k);
        chosen.into_iter().filter_map(|i| all.get(i).cloned()).collect()
    }

    /// PhysicsRelaxation by a step from outside.
    pub fn outside_relax(&mut self, steps: &mut Steps<'_>) -> bool {
        let Some(relaxer) = &mut steps.relaxer else { return false };
        for proposal in relaxer.relax(&View::new(&self.state)) {
            self.take(&proposal, false);
        }
        true
    }

    /// EnforceBounds, by a step from outside or by the solver's own.
    pub fn enforce_bounds(&mut self, steps: &mut Steps<'_>) {
        let Some(step) = &mut steps.bounds else { return bounds::enforce(&mut self.state) };
        for id in bounds::outside(&self.state) {
            if let Some(pose) = step.enforce(&View::new(&self.state), id) {
                self.go(id, pose);
            }
        }
    }

    /// InitialPlacement of one object by a step from outside. Whether it has a place now.
    pub fn outside_place(&mut self, steps: &mut Steps<'_>, id: ObjectId) -> bool {
        let Some(placer) = &mut steps.placer else { return false };
        let mut best: Option<(f64, Pose)> = None;
        for pose in placer.place(&View::new(&self.state), id).into_iter().filter(is_finite) {
            let pose = Pose { scale: self.state.pose(id).scale, ..pose };
            let limit = best.map_or(f64::INFINITY, |(least, _)| least - 1e-9);
            if let Some(cost) = self.state.attempt(&[Change::Object(id, pose)], limit) {
                self.state.undo();
                best = Some((cost, pose));
            }
        }
        best.is_some_and(|(_, pose)| {
            let done = self.state.attempt(&[Change::Object(id, pose)], f64::INFINITY).is_some();
            if done {
                self.state.keep();
            }
            done
        })
    }

    fn go(&mut self, id: ObjectId, pose: Pose) -> bool {
        self.take(
            &Proposal { moves: vec![crate::external::view::Move { object: id, pos: pose.pos, rot: pose.rot }] },
            false,
        )
    }

    /// Makes the moves of a proposal if less is violated with them; `strict`: and nothing is broken that held before.
    fn take(&mut self, proposal: &Proposal, strict: bool) -> bool {
        let mut changes: Vec<Change> = Vec::new();
        for step in &proposal.moves {
            if step.object.0 as usize >= self.state.frame.program.objects.len() {
                return false;
            }
            let old = self.state.pose(step.object);
            let tilts = self.state.frame.tilts[step.object.0 as usize];
            let upright = Pose { rot: old.rot, ..old }.facing(step.rot.y);
            let next = Pose { pos: step.pos, rot: if tilts { step.rot } else { upright.rot }, scale: old.scale };
            if !is_finite(&next) || !self.state.is_placed(step.object) {
                return false;
            }
            for change in self.state.with_riders(step.object, next) {
                let Change::Object(moved, _) = change else { continue };
                let own = moved == step.object;
                if own {
                    changes.retain(|c| !matches!(c, Change::Object(o, _) if *o == moved));
                }
                if own || !changes.iter().any(|c| matches!(c, Change::Object(o, _) if *o == moved)) {
                    changes.push(change);
                }
            }
        }
        if changes.is_empty() {
            return false;
        }
        let before = if strict { self.state.violated() } else { Vec::new() };
        if self.state.attempt(&changes, -1e-9).is_none() {
            return false;
        }
        if strict && self.state.violated().iter().any(|c| before.binary_search(c).is_err()) {
            self.state.undo();
            return false;
        }
        self.state.keep();
        true
    }
}

fn is_finite(pose: &Pose) -> bool {
    const FAR: f64 = 1e6;
    pose.pos.iter().chain(&pose.rot).all(|x| x.abs() < FAR)
}
