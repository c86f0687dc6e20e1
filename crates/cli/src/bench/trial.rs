//! One problem, from some seeds: solved, timed, judged.

use super::problems::Case;
use crate::solve::relative;
use crate::{interrupt, replace};
use scenelang_base::Diagnostic;
use scenelang_base::door::Door;
use scenelang_engine::check_layout_of;
use scenelang_lang::{Compiled, Program, compile_file};
use scenelang_solve::{End, Outcome, Phase, Placed, Problem, Progress};
use scenelang_synth::furnish;
use scenelang_verify::exit_code;
use scenelang_verify::prove::{Findings, ProveOptions, prove};
use scenelang_verify::report::model::{Summary, Tally};
use std::ops::ControlFlow;
use std::path::Path;
use std::time::{Duration, Instant};

/// What all runs share.
pub struct Limits<'a> {
    /// Seeds 0, 1, …: so many.
    pub seeds: u64,
    /// A run is ended after so long.
    pub time: Option<Duration>,
    /// Where layouts go.
    pub layouts: Option<&'a Path>,
    /// Whether they replace whatever is there.
    pub force: bool,
    /// How layouts are judged.
    pub judge: scenelang_verify::Options,
}

/// What a run came to.
#[derive(Clone, Debug, PartialEq)]
pub enum TrialEnd {
    /// The verifier accepts the layout.
    Solved,
    /// The verifier does not.
    Unsolved,
    /// There is no layout: a proof, with the `@req` texts of each minimal set of statements.
    Refuted(Vec<Vec<String>>),
}

#[derive(Clone, Debug)]
pub struct BenchRun {
    /// The problem's name.
    pub problem: String,
    pub family: String,
    pub seed: u64,
    /// How many objects it has.
    pub objects: usize,
    /// What came of it.
    pub answer: TrialEnd,
    /// How many constraints of each kind hold, as the verifier counts.
    pub held: Summary,
    /// Until the solver first had everything that must hold, or until the proof; `None` without an answer.
    pub first: Option<Duration>,
    /// Until the solver returned, or until the proof.
    pub total: Duration,
    /// How long the search for a contradiction took, which comes before solving and is not in the other times.
    pub proving: Duration,
    /// Work that the solver counted.
    pub work: u64,
    /// Rounds of its loop.
    pub rounds: usize,
    /// Whether the time ended it.
    pub cut: bool,
}

impl BenchRun {
    /// Whether this is the answer: a layout, or the proof that there is none.
    pub fn answered(&self) -> bool {
        self.answer != TrialEnd::Unsolved
    }
    /// Statements that must hold, assignments included.
    pub fn stated(&self) -> Tally {
        let (a, b) = (self.held.assertions, self.held.pins);
        Tally { total: a.total + b.total, satisfied: a.satisfied + b.satisfied }
    }
}

/// Runs a problem from each seed.
///
/// # Errors
/// A sentence: the program does not compile, or a layout cannot be written.
pub fn run(case: &Case, limits: &Limits<'_>) -> Result<Vec<BenchRun>, String> {
    if interrupt::asked() {
        return Ok(Vec::new());
    }
    let name = case.path.display().to_string();
    let compiled = compile_file(&name, &case.path, scenelang_lang::Options::default());
    let Some(program) = &compiled.program else {
        let why = compiled.diagnostics.iter().find(|d| d.is_error()).map_or("", |d: &Diagnostic| &d.message);
        return Err(format!("{name} does not compile: {why}"));
    };
    let begun = Instant::now();
    let findings = prove(
        program,
        &ProveOptions { judging: limits.judge, cancel: Some(interrupt::stop().flag()), ..ProveOptions::default() },
    );
    let proving = begun.elapsed();
    let mut trials = Vec::new();
    for seed in 0..limits.seeds {
        let mut trial = BenchRun {
            problem: case.name.clone(),
            family: case.family.clone(),
            seed,
            objects: program.objects.len(),
            answer: TrialEnd::Unsolved,
            held: Summary::default(),
            first: None,
            total: proving,
            proving,
            work: 0,
            rounds: 0,
            cut: false,
        };
        if interrupt::asked() {
            break;
        }
        if findings.contradictions.is_empty() {
            solve(case, &compiled, program, limits, &mut trial)?;
        } else {
            trial.first = Some(proving);
            trial.answer = TrialEnd::Refuted(requirements(program, &findings));
        }
        if interrupt::asked() {
            break;
        }
        trials.push(trial);
    }
    Ok(trials)
}

/// The `@req` texts of the members of each contradiction, in their order.
fn requirements(program: &Program, findings: &Findings) -> Vec<Vec<String>> {
    let of = |statement: &usize| program.constraints[*statement].requirements.clone();
    findings.contradictions.iter().map(|c| c.statements.iter().flat_map(of).collect()).collect()
}

/// Solves, judges and writes the layout.
fn solve(
    case: &Case,
    compiled: &Compiled,
    program: &Program,
    limits: &Limits<'_>,
    trial: &mut BenchRun,
) -> Result<(), String> {
    let draws = scenelang_solve::draws(program, trial.seed);
    let start = furnish(program, draws, None, &limits.judge).layout;
    let problem = Problem { program, placed: Placed::None, start };
    let options =
        scenelang_solve::Options { seed: trial.seed, judge: limits.judge, time: limits.time, ..Default::default() };
    let mut first = None;
    let begun = Instant::now();
    let mut outcome: Outcome = scenelang_solve::solve(&problem, &options, &mut |step: Progress| {
        let elapsed = begun.elapsed();
        // Before anything is placed there is nothing that could fail.
        if first.is_none() && step.phase != Phase::InitialPlacement && step.held == step.total {
            first = Some(elapsed);
        }
        if interrupt::asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    trial.total = begun.elapsed();
    trial.cut = outcome.end == End::Time;
    (trial.work, trial.rounds) = (outcome.work, outcome.iterations);

    if interrupt::asked() {
        // A search that was broken off is no trial.
        return Ok(());
    }
    let file = limits.layouts.map(|folder| folder.join(format!("{}.s{}.layout.json", case.name, trial.seed)));
    outcome.layout.scene = file.as_ref().map(|file| relative(&case.path, file));
    outcome.layout.seed = Some(trial.seed);
    let text = scenelang_layout::file::to_json(&outcome.layout, None);
    if let Some(file) = &file {
        replace::permit(file, &[&case.path], limits.force)?;
        replace::json(file, &text)?;
    }
    let name = compiled.sources.get(compiled.main).name();
    let options = scenelang_lang::Options::default();
    let checked =
        check_layout_of("layout.json", text, (name, &case.path), &limits.judge, options, &Door::of(&case.path));
    trial.held = checked.report.summary;
    if exit_code(&checked.report) == 0 {
        trial.answer = TrialEnd::Solved;
        trial.first = Some(first.unwrap_or(trial.total).min(trial.total));
    }
    Ok(())
}
