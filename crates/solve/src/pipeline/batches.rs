//! The loop of the published algorithm: as long as something is violated, take a batch of it, propose, enforce bounds,
//! and remember the best.
//!
//! What stays violated comes to weigh more, so that the search leaves its dead ends (breakout); where that does not help
//! the troubled objects are taken out and placed anew with what depends on them.

use crate::external::steps::Steps;
use crate::pipeline::bounds;
use crate::pipeline::propose;
use crate::pipeline::select;
use crate::problem::{Phase, Progress};
use crate::search::pool::Chance;
use crate::search::{STEPS, Search};
use scenelang_lang::program::ObjectId;
use std::ops::ControlFlow;

/// What a violated check gains in weight for each round that leaves it so.
const STUBBORN: f64 = 0.4;
/// Rounds without a new best layout before objects are placed anew.
const PATIENCE: usize = 6;
/// How many objects are placed anew together, at first and at most.
const TOGETHER: [usize; 2] = [4, 16];

impl<'a> Search<'a> {
    /// Runs the loop for at most so many rounds. Whether everything holds now; `Break`: the caller wants no more.
    pub fn repair(
        &mut self,
        rounds: usize,
        steps: &mut Steps<'_>,
        iterations: &mut usize,
        progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> ControlFlow<(), bool> {
        let mut idle = 0;
        let mut kicks = 0;
        for _ in 0..rounds {
            let violated = self.state.failing();
            if violated.is_empty() {
                self.note();
                return ControlFlow::Continue(true);
            }
            if self.is_spent(1.0) {
                break;
            }
            *iterations += 1;
            progress(self.progress(Phase::Repair, *iterations))?;
            if idle >= PATIENCE {
                idle = 0;
                kicks += 1;
                self.kick(&violated, kicks);
            } else {
                self.round(&violated);
                self.enforce_bounds(steps);
            }
            idle = if self.note() { 0 } else { idle + 1 };
            if idle == PATIENCE / 2 {
                self.polish_all();
                self.note();
            }
        }
        ControlFlow::Continue(self.state.failing().is_empty())
    }

    /// Moves everything at once a little.
    fn polish_all(&mut self) {
        let all = self.state.placed().filter(|o| self.state.frame.is_movable(*o)).collect();
        self.polish(all, STEPS[0]);
    }

    /// A few rounds, only to repair what a larger change has left behind.
    pub fn fix(&mut self, rounds: usize) {
        let weights = self.state.weight.clone();
        for _ in 0..rounds {
            let violated = self.state.failing();
            if violated.is_empty() || self.is_spent(1.0) {
                break;
            }
            self.round(&violated);
            bounds::enforce(&mut self.state);
        }
        self.state.weight = weights;
    }

    /// One round on a batch.
    fn round(&mut self, violated: &[usize]) {
        let batch = select::batch(&self.state, violated, self.options.batch, &mut self.chance);
        propose::numeric(self, &batch);
        for check in batch {
            if self.state.is_violated(check) {
                self.state.weight[check] += STUBBORN;
            }
        }
    }

    /// Goes back to the best layout, takes troubled objects out with what depends on them, and places them anew.
    fn kick(&mut self, violated: &[usize], kicks: usize) {
        if let Some(best) = self.best.as_ref().map(|b| b.snapshot.clone())
            && !kicks.is_multiple_of(3)
        {
            self.restore(&best);
        }
        let violated = if self.state.failing().is_empty() { violated.to_vec() } else { self.state.failing() };
        let check = violated[self.chance.below(violated.len())];
        let mut seeds = self.blamed(check);
        self.chance.shuffle(&mut seeds);
        seeds.truncate(1 + self.chance.below(3));
        let most = (TOGETHER[0] + 2 * kicks).min(TOGETHER[1]);
        let mut group: Vec<ObjectId> = self.dependents(&seeds, most);
        // Some of what is around, too: it may be what leaves no room.
        let around: Vec<ObjectId> = self
            .state
            .placed()
            .filter(|o| !group.contains(o) && self.state.frame.is_movable(*o))
            .filter(|o| seeds.iter().any(|s| self.state.span(*s).distance(self.state.span(*o)) < 0.5))
            .collect();
        for id in around {
            if group.len() < most && self.chance.below(2) == 0 {
                group.push(id);
            }
        }
        self.recreate(&group);
        self.state.weight.iter_mut().enumerate().for_each(|(c, w)| {
            if self.state.frame.terms.get(c).is_none_or(|t| t.is_hard()) {
                *w = 1.0 + 0.5 * (*w - 1.0);
            }
        });
    }

    /// How far the search is.
    pub fn progress(&self, phase: Phase, iteration: usize) -> Progress {
        let frame = self.state.frame;
        let n = frame.program.objects.len();
        let physical = frame.scope.as_ref().map_or(0, |s| s.pairs(n, |_| true) + 2 * n);
        let total = frame.terms.iter().filter(|t| t.is_hard()).count() + physical;
        Progress { phase, iteration, held: total.saturating_sub(self.state.violated().len()), total }
    }
}
