//! Our solver at its iterations. The published one repairs a batch of violated constraints in each; ours moves one thing at a
//! time, so an iteration is so much work for each thing: about as much as a look at each of them takes.

use super::{Satisfied, problem, satisfied};
use scenelang_lang::Program;
use scenelang_solve::{Options, Stop, solve};
use std::ops::ControlFlow;

/// As published: the first layout, and five iterations.
pub const ITERATIONS: u64 = 5;
/// Units of work of an iteration, for each thing.
pub const WORK: u64 = 2_000;

/// How much holds after 0, 1, … iterations.
pub fn iterations(program: &Program, seed: u64, stop: &Stop) -> Vec<Satisfied> {
    let problem = problem(program, seed);
    let things = program.objects.len().max(1) as u64;
    let after = |iteration: u64| {
        let options = Options {
            seed,
            // The first layout needs no work beyond itself; a budget of nothing would be the usual one.
            budget: (iteration * WORK * things).max(1),
            threads: 1,
            polish: 0.0,
            diagnose: false,
            stop: stop.clone(),
            ..Options::default()
        };
        let outcome = solve(&problem, &options, &mut |_| ControlFlow::Continue(()));
        satisfied(program, &outcome.layout)
    };
    (0..=ITERATIONS).map(after).collect()
}
