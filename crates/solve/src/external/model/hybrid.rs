//! The model proposes, the numeric search finishes; and what the numeric search finds by itself is never thrown away.

use super::{Asking, ModelProposer, Tally};
use crate::external::steps::Steps;
use crate::pipeline::{solve, solve_with};
use crate::problem::{Options, Outcome, Problem, Progress, TermSubject};
use scenelang_lang::Program;
use scenelang_lang::program::ConstraintKind;
use scenelang_llm::Model;
use std::cmp::Ordering;
use std::ops::ControlFlow;

/// Who finishes what the model leaves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Finisher {
    /// The numeric search.
    #[default]
    Numeric,
    /// Nobody: the algorithm exactly as published, to compare with.
    None,
}

/// What came of a solve with a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Hybrid {
    /// The better of both ways.
    pub outcome: Outcome,
    /// What came of asking the model.
    pub tally: Tally,
    /// Whether the numeric search did better without the model, and the outcome is its.
    pub without: bool,
}

/// Solves with a model. With [`Finisher::Numeric`], the numeric search also runs without the model unless all holds already,
/// and the better outcome is kept: so asking never does harm.
pub fn hybrid(
    problem: &Problem<'_>,
    options: &Options,
    model: &mut dyn Model,
    asking: Asking,
    finisher: Finisher,
    progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Hybrid {
    let mut proposer = ModelProposer::new(model, asking);
    let mut ended = false;
    let mut watched = |p: Progress| {
        let flow = progress(p);
        ended |= flow.is_break();
        flow
    };
    let proposers_only = finisher == Finisher::None;
    // No rounds at all is nobody asked.
    let mut steps = Steps { rounds: asking.rounds, proposers_only, ..Steps::default() };
    if asking.rounds > 0 {
        steps.proposers.push(&mut proposer);
    }
    let batched = Options { batch: asking.batch, ..options.clone() };
    let outcome = solve_with(problem, &batched, &mut steps, &mut watched);
    drop(steps);
    let tally = proposer.tally().clone();
    if ended || finisher == Finisher::None || outcome.unsatisfied.is_empty() {
        return Hybrid { outcome, tally, without: false };
    }
    let alone = solve(problem, options, progress);
    let without = compare(problem.program, &alone, &outcome) == Ordering::Less;
    Hybrid { outcome: if without { alone } else { outcome }, tally, without }
}

/// `Less`: `a` is better. First by how much that must hold is violated, then by the preferences that are not met.
fn compare(program: &Program, a: &Outcome, b: &Outcome) -> Ordering {
    let (a, b) = (badness(program, a), badness(program, b));
    a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.total_cmp(&b.2))
}

/// How many hard constraints and rules are violated, by how much in all, the weight of the preferences that are not met.
pub(super) fn badness(program: &Program, outcome: &Outcome) -> (usize, f64, f64) {
    let (mut count, mut amount, mut weight) = (0, 0.0, 0.0);
    for failing in &outcome.unsatisfied {
        match &failing.what {
            TermSubject::Stated(index)
                if let ConstraintKind::Prefer { weight: w } = program.constraints[*index].kind =>
            {
                weight += w;
            }
            _ => {
                count += 1;
                amount += failing.margin.map_or(1.0, |m| -m);
            }
        }
    }
    (count, amount, weight)
}
