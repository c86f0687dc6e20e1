//! Solution correctness: how much of what a program states holds in a layout, as published, and three ways to a layout: our
//! search at its iterations, Holodeck's floor solver rebuilt ([`grid`]), a language model that is asked directly ([`direct`]).

pub mod direct;
pub mod grid;
mod iterations;

pub use iterations::{ITERATIONS, WORK, iterations};

use crate::score::Share;
use scenelang_lang::{Options, Program, compile_text};
use scenelang_layout::Layout;
use scenelang_solve::{Placed, Problem, Stop, draws, solve};
use scenelang_synth::furnish;
use scenelang_verify::check::{Subject, check};
use scenelang_verify::prove::{ProveOptions, prove};
use std::ops::ControlFlow;
use std::path::Path;

/// How much holds in a layout.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Satisfied {
    /// Of the assertions that a request states (those with `@req`): what is published as solution correctness. What cannot
    /// be judged, since a thing is missing in the layout, does not hold.
    pub stated: Share,
    /// Of all assertions, assignments and physical rules.
    pub all: Share,
}

/// Judges a layout.
pub fn satisfied(program: &Program, layout: &Layout) -> Satisfied {
    let verdict = check(program, layout, &plain());
    let is_stated = |subject: Subject| match subject {
        Subject::Statement(index) => {
            let told = &program.constraints[index].requirements;
            !told.is_empty() && !told.iter().any(|why| why.starts_with("inferred"))
        }
        _ => false,
    };
    let asked = verdict
        .rows
        .iter()
        .filter(|row| row.kind == scenelang_verify::report::model::RowKind::Assert && is_stated(row.subject));
    let stated = Share::of(asked, |row| row.satisfied == Some(true));
    let summary = verdict.summary;
    let counts = [summary.assertions, summary.pins, summary.physical];
    // Rules that speak of what is missing have no row: the things that are missing count as outside.
    let missing = program.objects.iter().filter(|o| layout.object(&o.name).is_none()).count();
    let all = Share {
        part: counts.iter().map(|count| count.satisfied).sum(),
        whole: counts.iter().map(|count| count.total).sum::<usize>() + missing,
    };
    Satisfied { stated, all }
}

/// Only verdicts: no sentences, no look for what bars a way.
fn plain() -> scenelang_verify::Options {
    let mut options = scenelang_verify::Options::default();
    options.detail.sentences = false;
    options.detail.bars = false;
    options
}

/// A program with its layout.
#[derive(Debug)]
pub struct Laid {
    pub program: Program,
    /// The best layout that the solver found.
    pub layout: Layout,
    /// Whether a layout is not ruled out by proof; asked only where none was found.
    pub satisfiable: Option<bool>,
}

/// The program of a text, or the first error in it.
pub fn compiled(text: &str) -> Result<Program, String> {
    let compiled = compile_text("room.scene", Path::new("room.scene"), text, Options::default());
    match compiled.diagnostics.iter().find(|d| d.is_error()) {
        Some(error) => Err(error.message.clone()),
        None => compiled.program.ok_or_else(|| "it has no statements".to_owned()),
    }
}

/// What the solver is given for a program: sizes and parts from the library.
pub fn problem(program: &Program, seed: u64) -> Problem<'_> {
    let judge = scenelang_verify::Options::default();
    let start = furnish(program, draws(program, seed), None, &judge).layout;
    Problem { program, start, placed: Placed::None }
}

/// Lays out a program by itself.
///
/// # Errors
/// It does not compile.
pub fn laid_out(text: &str, seed: u64, stop: &Stop) -> Result<Laid, String> {
    let program = compiled(text)?;
    let options = scenelang_solve::Options {
        seed,
        threads: 1,
        polish: 0.0,
        diagnose: false,
        stop: stop.clone(),
        ..scenelang_solve::Options::default()
    };
    let outcome = solve(&problem(&program, seed), &options, &mut |_| ControlFlow::Continue(()));
    let mut layout = outcome.layout;
    layout.seed = Some(seed);
    let satisfiable = if outcome.converged {
        Some(true)
    } else {
        let found = prove(&program, &ProveOptions { redundant: false, ..ProveOptions::default() });
        Some(found.contradictions.is_empty())
    };
    Ok(Laid { program, layout, satisfiable })
}
