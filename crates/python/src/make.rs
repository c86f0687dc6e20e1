//! What makes programs and layouts: `solve`, `repair`, `formalize`, `sample`. Results are JSON, layouts in them texts.

use crate::errors::{contradiction, refused, sentence};
use crate::program::{Held, Program};
use crate::work::away;
use pyo3::exceptions::{PyKeyboardInterrupt, PyValueError};
use pyo3::prelude::*;
use scenelang_formalize::{Options as Reading, read, write::write};
use scenelang_layout::file as layout_file;
use scenelang_sample::{Sampler, Settings};
use scenelang_solve::repair::told::{AlternativesReport, rows};
use scenelang_solve::repair::{Alternative, Damaged, RepairOptions, Text, Unjudged, Which, edited, repair as look};
use scenelang_solve::{End, MOST_OBJECTS};
use scenelang_synth::{
    Failure, Hold, JudgedLayout, LayoutRequest, Observer, Stage, Tried, rehearse_reading, too_large,
};
use scenelang_verify::Checked;
use scenelang_verify::prove::{ProveOptions, WORK, prove};
use scenelang_verify::report::statement_id;
use serde_json::{Value, json};
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Duration;

/// The part of the usual work that goes into proofs before anything is drawn, as `scenelang sample` has it.
const CHEAP: u64 = 6;

/// Nobody looks on.
struct Quiet;

impl Observer for Quiet {
    fn enter(&mut self, _: Stage) {}
    fn leave(&mut self, _: Stage) {}
    fn solving(&mut self, _: &scenelang_solve::Progress) {}
}

fn unsolved(held: &Held, failure: Failure) -> PyErr {
    match failure {
        Failure::Input(sources, diagnostics) => refused(&held.name, sources, diagnostics),
        Failure::Contradiction(checked) => contradiction(&checked),
        Failure::Interrupted => PyKeyboardInterrupt::new_err(()),
    }
}

/// What a layout of a program is called, seen from the program's folder.
fn layout_name(held: &Held) -> String {
    Path::new(&held.name).with_extension("layout.json").display().to_string()
}

/// How the layout names its program.
fn member(held: &Held) -> String {
    held.path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// Looks for a layout.
#[pyfunction]
#[pyo3(signature = (program, *, seed, start, lock, only, time, effort, quality, threads))]
#[expect(clippy::too_many_arguments, reason = "they are the options of the command")]
pub fn solve(
    py: Python<'_>,
    program: &Program,
    seed: u64,
    start: Option<(String, String)>,
    lock: Vec<String>,
    only: Vec<String>,
    time: Option<f64>,
    effort: u64,
    quality: Option<u8>,
    threads: usize,
) -> PyResult<String> {
    let held = &*program.held;
    let judging = held.judging()?;
    let time = time.map(Duration::try_from_secs_f64).transpose();
    let time = time.map_err(|_| PyValueError::new_err("time is a number of seconds, at least 0"))?;
    let solved = away(py, |stop| {
        let (layout_name, member) = (layout_name(held), member(held));
        let request = LayoutRequest {
            name: &held.name,
            path: &held.path,
            files: &held.files(),
            start: start.as_ref().map(|(name, text)| (name.as_str(), text.as_str())),
            before: None,
            share: 1,
            layout_name: &layout_name,
            scene_member: &member,
            hold: match (lock.as_slice(), only.as_slice()) {
                ([], []) => Hold::Nothing,
                (names, []) => Hold::These(names),
                (_, names) => Hold::AllBut(names),
            },
            time,
            alternatives: None,
            free: 0,
            threads,
            effort,
            quality: quality.unwrap_or(scenelang_solve::QUALITY),
            stop,
            seed,
            furniture: None,
            judge: judging.options,
        };
        scenelang_synth::solve(&request, &mut Quiet)
    })?;
    let mut solved = solved.map_err(|failure| unsolved(held, failure))?;
    solved.first.checked.report.judged_with = judging.with;
    let found = &solved.first;
    let end = match found.outcome.end {
        End::Solved => "solved",
        End::Budget => "budget",
        End::Time => "time",
        End::Exhausted => "exhausted",
        End::Asked => "interrupted",
    };
    let warnings = solved.warnings.iter().map(|d| d.message.clone());
    let out = json!({
        "layout": found.text,
        "end": end,
        "in_the_way": in_the_way(found),
        "report": found.checked.report,
        "warnings": warnings.chain(found.outcome.warnings.iter().cloned()).collect::<Vec<_>>(),
    });
    Ok(out.to_string())
}

/// Statements without which the rest can hold.
fn in_the_way(found: &JudgedLayout) -> Vec<Value> {
    let Checked { sources, program, report, .. } = &found.checked;
    let constraints = program.iter().flat_map(|program| &program.constraints).enumerate();
    let blamed = constraints.filter(|(index, _)| found.outcome.in_the_way.contains(index));
    blamed.map(|(_, c)| json!({ "id": statement_id(&report.file, sources, c.span), "text": c.text })).collect()
}

/// Ways to repair a layout.
#[pyfunction]
#[pyo3(signature = (program, layout, *, constraint, lock, time))]
pub fn repair(
    py: Python<'_>,
    program: &Program,
    layout: (String, String),
    constraint: Option<String>,
    lock: Vec<String>,
    time: Option<f64>,
) -> PyResult<String> {
    let held = &*program.held;
    let judge = held.judging()?.options;
    let time = time.map(Duration::try_from_secs_f64).transpose();
    let time = time.map_err(|_| PyValueError::new_err("time is a number of seconds, at least 0"))?;
    away(py, |stop| {
        let (name, text) = &layout;
        let checked = held.judged((name.as_str(), text.as_str()))?;
        let (Some(program), Some(placed)) = (&checked.program, &checked.layout) else {
            return Err(sentence(format!("{name} cannot be checked")));
        };
        if let Some(finding) = too_large(program) {
            return Err(refused(&held.name, checked.sources.clone(), vec![finding]));
        }
        let which = match &constraint {
            None => Which::All,
            Some(id) => Which::Rows(rows(&checked, &held.name, id).map_err(sentence)?),
        };
        let locked = match Hold::These(&lock).objects(program, Some(placed)) {
            Ok(locked) => locked,
            Err(finding) => return Err(sentence(finding.message)),
        };
        let files = held.files();
        let source = Text {
            name: &held.name,
            path: &held.path,
            compile: scenelang_lang::Options::default(),
            loader: &files,
            sources: &checked.sources,
        };
        let damaged = Damaged { program, layout: placed, text: Some(source) };
        let options = RepairOptions { judge, time, locked, stop: stop.clone(), ..RepairOptions::default() };
        let found = look(&damaged, &which, &options)
            .map_err(|Unjudged| sentence(format!("{name} cannot be checked completely; `check` says why")))?;
        let told = AlternativesReport { checked: &checked, program, name };
        let old = layout_file::read(text, scenelang_base::FileId(0));
        let way = |way: &Alternative| -> PyResult<Value> {
            let mut after = way.layout.clone();
            // What a search has left undone is done, if all of it holds now.
            after.incomplete &= constraint.is_some();
            let text = layout_file::checked(Path::new(name), &after, old.usable.then_some(&old.document));
            let mut out = told.alternative(way);
            out["layout"] = text.map_err(|e| sentence(e.to_string()))?.into();
            out["program"] = changed(held, &checked, way)?.into();
            Ok(out)
        };
        let ways = found.alternatives.iter().map(way).collect::<PyResult<Vec<_>>>()?;
        Ok(json!(ways).to_string())
    })?
}

/// The text of the program after a repair, where it changes no other file.
fn changed(held: &Held, checked: &Checked, way: &Alternative) -> PyResult<Option<String>> {
    let overlap = || sentence("the edits of a repair overlap");
    let texts = edited(&checked.sources, &way.edits).ok_or_else(overlap)?;
    let own = texts.iter().find(|(id, _)| checked.sources.get(**id).path() == held.path);
    Ok(own.filter(|_| texts.len() == 1).map(|(_, text)| text.clone()))
}

/// A program for a request in plain words.
#[pyfunction]
#[pyo3(signature = (request, *, literal, tried))]
pub fn formalize(py: Python<'_>, request: &str, literal: bool, tried: bool) -> PyResult<String> {
    away(py, |stop| {
        let mut reading = read(request, &Reading { literal });
        let objects: usize = reading.draft.things.iter().map(|thing| thing.count).sum();
        let mut end = None;
        if tried && !reading.nothing && objects <= MOST_OBJECTS {
            end = Some(rehearse_reading(&mut reading, stop, &mut |_| {}).0);
            reading.draft.notes.sort_by_key(|note| (note.at.start, note.at.end));
        }
        let of = |at: &std::ops::Range<usize>| request.get(at.clone()).unwrap_or_default();
        let clauses = reading.read.iter().map(|(at, understood)| json!({ "text": of(at), "understood": understood }));
        let unused = reading.words.iter().filter(|word| !word.used).map(|word| of(&word.at));
        let notes = reading.draft.notes.iter().map(|note| json!({ "text": of(&note.at), "reason": note.reason }));
        let out = json!({
            "program": write(&reading.draft),
            "understood": !reading.nothing,
            "clauses": clauses.collect::<Vec<_>>(),
            "unused": unused.collect::<Vec<_>>(),
            "notes": notes.collect::<Vec<_>>(),
            "layout": match end {
                None => "untried",
                Some(Tried::Holds) => "found",
                Some(Tried::Overfull) => "overfull",
                Some(_) => "not found",
            },
        });
        out.to_string()
    })
}

/// Layouts drawn uniformly: those of the numbers from `first` for which there is one, each with its number, as a line of JSON.
#[pyfunction]
#[pyo3(signature = (program, number, *, seed, first, effort, threads))]
pub fn sample(
    py: Python<'_>,
    program: &Program,
    number: u64,
    seed: u64,
    first: u64,
    effort: u64,
    threads: usize,
) -> PyResult<Vec<(u64, String)>> {
    let held = &*program.held;
    let judge = held.judging()?.options;
    if let Some(finding) = too_large(held.program()) {
        return Err(refused(&held.name, held.compiled.sources.clone(), vec![finding]));
    }
    let Some(end) = first.checked_add(number).filter(|end| *end <= u64::MAX / 2) else {
        return Err(PyValueError::new_err("the number is too large"));
    };
    let threads = if threads == 0 { thread::available_parallelism().map_or(1, usize::from) } else { threads };
    away(py, |stop| {
        let options = ProveOptions {
            judging: judge,
            redundant: false,
            usual: true,
            work: WORK / CHEAP,
            ..ProveOptions::default()
        };
        if !prove(held.program(), &options).contradictions.is_empty() {
            return Err(contradiction(&held.check(None)));
        }
        let settings =
            Settings { seed, judge, effort, budget: 0, scene: member(held), whole: true, stop: stop.clone() };
        let none =
            || sentence("no sample was drawn: no layout was found in which all that must hold does; `solve` says more");
        let sampler = Sampler::new(held.program(), settings).ok_or_else(none)?;
        let (next, lines) = (AtomicU64::new(first), Mutex::new(Vec::new()));
        thread::scope(|scope| {
            for _ in 0..threads.min(usize::try_from(number).unwrap_or(usize::MAX)).min(256) {
                scope.spawn(|| {
                    while !stop.is_set() {
                        let index = next.fetch_add(1, Ordering::Relaxed);
                        if index >= end {
                            break;
                        }
                        if let Ok(sample) = sampler.sample(index).result {
                            lines.lock().unwrap_or_else(PoisonError::into_inner).push((index, sample.line));
                        }
                    }
                });
            }
        });
        let mut lines = lines.into_inner().unwrap_or_else(PoisonError::into_inner);
        lines.sort_unstable();
        if lines.is_empty() && number > 0 { Err(none()) } else { Ok(lines) }
    })?
}
