//! `scenelang bench solve`: runs problem files through the solver and says how many it solved, and how fast.
//!
//! A problem is solved when our verifier accepts the layout as a file; `--layouts` writes the files, so that a judge that
//! is not ours can look at them, too. Time is the solver's alone, in this process: reading, compiling, furnishing and
//! judging are not in it.

mod families;
mod others;
mod problems;
mod record;
mod trial;

use crate::args::{BenchSolve, Plain};
use crate::progress::Progress;
use crate::{FAILED, FINDINGS, GOOD, INTERRUPTED, interrupt, parallel, replace};
use problems::Case;
use std::time::Duration;
use trial::{BenchRun, Limits};

/// Runs the problems; 0 if each run gave the answer, be it a layout or the proof that there is none.
pub fn solve(args: &BenchSolve) -> u8 {
    let cases = match problems::below(&args.paths) {
        Ok(cases) if cases.is_empty() => return fail("there is no .scene file"),
        Ok(cases) => cases,
        Err(message) => return fail(&message),
    };
    let inputs: Vec<_> = cases.iter().map(|case| case.path.as_path()).collect();
    if let Some(path) = &args.output
        && let Err(message) = replace::permit(path, &inputs, args.force)
    {
        return fail(&message);
    }
    let limits = Limits {
        seeds: args.seeds,
        time: args.time.map(Duration::from_secs_f64),
        layouts: args.layouts.as_deref(),
        force: args.force,
        judge: scenelang_verify::Options::default(),
    };
    interrupt::gently();
    let (trials, failures) = run(&cases, &limits, usize::from(args.threads));
    for failure in &failures {
        eprintln!("error: {failure}");
    }
    let record = record::json(args, &trials);
    if let Some(path) = &args.output
        && let Err(message) = replace::json(path, &format!("{record:#}\n"))
    {
        return fail(&message);
    }
    match args.format {
        Plain::Json => println!("{record}"),
        Plain::Text => print!("{}\n{}", families::text(&trials), others::text()),
    }
    if interrupt::asked() {
        eprintln!("interrupted after {} runs", trials.len());
        INTERRUPTED
    } else if !failures.is_empty() {
        FAILED
    } else if trials.iter().all(|t| t.answered()) {
        GOOD
    } else {
        FINDINGS
    }
}

/// All runs in order, and what could not be run.
fn run(cases: &[Case], limits: &Limits<'_>, threads: usize) -> (Vec<BenchRun>, Vec<String>) {
    let progress = Progress::new("starting");
    let (mut trials, mut failures): (Vec<BenchRun>, Vec<String>) = (Vec::new(), Vec::new());
    let mut done = 0;
    parallel::in_order(
        cases,
        threads,
        |case| trial::run(case, limits),
        |result| {
            done += 1;
            match result {
                Ok(found) => trials.extend(found),
                Err(message) => failures.push(message),
            }
            let answered = trials.iter().filter(|t| t.answered()).count();
            progress.say(format!("{done} of {} problems, {answered} of {} runs solved", cases.len(), trials.len()));
        },
    );
    (trials, failures)
}

fn fail(message: &str) -> u8 {
    eprintln!("error: {message}");
    FAILED
}
