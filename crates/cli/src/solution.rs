//! What `scenelang solve` says of what it found: for people, and as JSON.

use crate::check::color;
use scenelang_base::plain;
use scenelang_lang::program::{Constraint, ConstraintKind};
use scenelang_solve::{End, Freedom};
use scenelang_synth::{Hold, JudgedLayout, Solved};
use scenelang_verify::Checked;
use scenelang_verify::prove::{ProveOptions, WORK, prove};
use scenelang_verify::report::{self, Human};
use serde_json::{Value, json};
use std::path::PathBuf;

/// What it calls itself.
const FORMAT: &str = "scenelang.solution/1";
/// So many objects that are still free are named to people.
const NAMED: usize = 5;

/// For people: what fails in each layout, where it is, what is in the way, what is still free if that was looked for.
/// `hold`: what had to stay where it was.
pub fn text(solved: &Solved, files: &[PathBuf], wanted: Option<usize>, hold: Hold<'_>) -> String {
    let mut out = String::new();
    for (found, file) in solved.all().zip(files) {
        out += &report::human(&found.checked, Human { color: color(), all: false });
        let end = match found.outcome.end {
            _ if found.layout().incomplete => ", incomplete because of the interruption",
            End::Time => " after the time limit was reached",
            End::Budget => " after the search budget was used up (increase it with --effort)",
            _ => "",
        };
        out += &preferred(found);
        let file = file.display().to_string();
        // Of proposers from outside; without a model there are none.
        let rounds = match found.outcome.iterations {
            0 => String::new(),
            1 => " after 1 round".to_owned(),
            n => format!(" after {n} rounds"),
        };
        out += &format!("{} written{rounds}{end}\n", plain::line(&file));
        let blamed = in_the_way(found);
        if !matches!(hold, Hold::Nothing) && !blamed.is_empty() {
            out += "locked objects were not moved; unlocking some of them may be enough\n";
        }
        out += &blamed;
    }
    out += &still_free(&solved.first);
    if let Some(wanted) = wanted.filter(|wanted| *wanted > files.len()) {
        let found = if solved.first.outcome.converged { files.len() } else { 0 };
        out += &format!("{found} of {wanted} substantially different layouts were found\n");
    }
    out
}

/// How much the preferences weigh that hold, and all of them.
fn weights(found: &JudgedLayout) -> (f64, f64) {
    let rows = found.checked.report.constraints.iter();
    let preferences = rows.filter_map(|row| Some((row.weight?, row.satisfied == Some(true))));
    preferences.fold((0.0, 0.0), |(met, all), (weight, holds)| (if holds { met + weight } else { met }, all + weight))
}

/// The same in words, where not all of them hold.
fn preferred(found: &JudgedLayout) -> String {
    let (met, all) = weights(found);
    if met >= all {
        return String::new();
    }
    let advice = match excluded(found) {
        Some(texts) => format!("these cannot hold together: {}", texts.join(", ")),
        None => "use a higher --quality to optimise for longer".to_owned(),
    };
    format!("preferences met: {met} of a total weight of {all}; {advice}\n")
}

/// The statements of a contradiction between preferences, or between one and what is required: no search can meet them all.
fn excluded(found: &JudgedLayout) -> Option<Vec<String>> {
    let mut program = found.checked.program.clone()?;
    let is_preference = |c: &Constraint| matches!(c.kind, ConstraintKind::Prefer { .. }) && c.guideline.is_none();
    let preferred: Vec<bool> = program.constraints.iter().map(is_preference).collect();
    for (constraint, is_preference) in program.constraints.iter_mut().zip(&preferred) {
        if *is_preference {
            constraint.kind = ConstraintKind::Assert;
        }
    }
    let options = ProveOptions { work: WORK / 3, redundant: false, usual: true, ..ProveOptions::default() };
    let all = prove(&program, &options).contradictions;
    let found = all.into_iter().find(|found| found.statements.iter().any(|s| preferred[*s]))?;
    Some(found.statements.iter().map(|s| format!("`{}`", program.constraints[*s].text)).collect())
}

/// What is free, in words.
fn still_free(found: &JudgedLayout) -> String {
    let free = &found.free;
    let named: Vec<String> = free.objects.iter().take(NAMED).map(ToString::to_string).collect();
    let more = match free.objects.len().saturating_sub(NAMED) {
        _ if named.is_empty() => return String::new(),
        _ if !free.complete => "; and perhaps others".to_owned(),
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    format!("objects that can still move: {}{more}\n", named.join("; "))
}

/// The statements in the way, in words.
fn in_the_way(found: &JudgedLayout) -> String {
    let list: Vec<(String, &str)> = named(found).collect();
    let mut out = match list.len() {
        0 => return String::new(),
        1 => "the layout satisfies all statements except this one, although removing it may not be necessary:\n"
            .to_owned(),
        n => format!("the layout satisfies all statements except these {n}; removing fewer of them may be enough:\n"),
    };
    for (id, text) in list {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        out += &format!("  {}: {}\n", plain::line(&id), plain::line(&text));
    }
    out
}

/// The statements in the way: how reports call them, and what they say.
pub fn named(found: &JudgedLayout) -> impl Iterator<Item = (String, &str)> {
    let Checked { sources, program, report, .. } = &found.checked;
    let constraints = program.iter().flat_map(|program| &program.constraints);
    let list = constraints.enumerate().filter(|(index, _)| found.outcome.in_the_way.contains(index));
    list.map(|(_, c)| (report::statement_id(&report.file, sources, c.span), c.text.as_str()))
}

pub fn json(file: &str, solved: &Solved, files: &[PathBuf]) -> Value {
    let end = match solved.first.outcome.end {
        _ if solved.first.layout().incomplete => "interrupted",
        End::Solved => "solved",
        End::Budget => "budget",
        End::Time => "time",
        End::Exhausted => "exhausted",
        End::Asked => "interrupted",
    };
    let said = solved.warnings.iter().map(|d| d.message.clone());
    json!({
        "format": FORMAT,
        "file": file,
        "ok": solved.first.checked.report.ok,
        "end": end,
        "layouts": solved.all().zip(files).map(|(found, file)| json!({
            "file": file.display().to_string(),
            "rounds": found.outcome.iterations,
            "preferences": { "met": weights(found).0, "all": weights(found).1 },
            "in_the_way": named(found).map(|(id, text)| json!({ "id": id, "text": text })).collect::<Vec<_>>(),
            "free": { "objects": found.free.objects.iter().map(freedom).collect::<Vec<_>>(), "complete": found.free.complete },
            "report": found.checked.report,
        })).collect::<Vec<_>>(),
        "report": null,
        "warnings": said.chain(solved.first.outcome.warnings.iter().cloned()).collect::<Vec<_>>(),
    })
}

fn freedom(free: &Freedom) -> Value {
    let [x, y, z] = free.moves;
    json!({ "object": free.name, "text": free.to_string(), "x": x, "y": y, "z": z, "turn": free.turns })
}

/// As JSON, where it is proved that there is no layout.
pub fn refuted(file: &str, checked: &Checked) -> Value {
    json!({
        "format": FORMAT,
        "file": file,
        "ok": false,
        "end": "contradiction",
        "layouts": [],
        "report": checked.report,
        "warnings": [],
    })
}
