//! A layout for those who change it otherwise than a search does: what the program demands, worked out once, the candidate
//! to change, and the way back to a layout.

use crate::pipeline::finish::compose;
use crate::problem::pose::round_to;
use crate::problem::setup::{Setup, setup};
use crate::problem::{Options, Problem};
use scenelang_engine::candidate::{Candidate, Change};
use scenelang_engine::frame::Frame;
use scenelang_layout::Layout;

/// Whoever only asks whether everything holds need not know how much more room than this there is before what opens (metres).
const CLEARANCE: f64 = 0.01;

pub struct Ground<'a> {
    setup: Setup<'a>,
}

impl<'a> Ground<'a> {
    /// Of a problem: its draws are those of the seed, what has a place already has it.
    pub fn new(problem: &Problem<'a>, options: &Options) -> Self {
        Self { setup: setup(problem, options) }
    }

    /// What the program demands.
    pub fn frame(&self) -> &Frame<'a> {
        &self.setup.frame
    }

    /// Everything that has a place in it, and nothing else.
    pub fn candidate(&self) -> Candidate<'_> {
        let mut world = self.setup.world.clone();
        world.options.detail.clearance = CLEARANCE;
        let mut state = Candidate::new(&self.setup.frame, world);
        let placed = self.setup.given.iter().filter_map(|(id, pose)| Some(Change::Object(*id, (*pose)?)));
        let placed: Vec<Change> = placed.collect();
        if state.attempt(&placed, f64::INFINITY).is_some() {
            state.keep();
        }
        state.measure_all();
        state
    }

    /// The layout of a candidate. With a step, numbers that the program does not assign are cut to multiples of it.
    pub fn layout(&self, state: &Candidate<'_>, step: Option<f64>) -> Layout {
        match step {
            Some(step) => compose(&self.setup, state, |_, x| round_to(x, step)),
            None => compose(&self.setup, state, |_, x| x),
        }
    }
}
