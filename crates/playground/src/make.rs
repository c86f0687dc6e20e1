//! What takes long: a layout of a program, and a program from plain English. Neither knows of the open program, so that a
//! page can ask an instance of its own for it, and end that.

use crate::files::{Alone, layout_name, stem};
use crate::session::Refused;
use scenelang_base::{Diagnostic, Severity};
use scenelang_formalize::{Options as Reading, overfull, read, write::write};
use scenelang_layout::file as layout_file;
use scenelang_solve::{End, MOST_OBJECTS, Stop};
use scenelang_synth::{
    Failure, Hold, JudgedLayout, LayoutRequest, Observer, PLANNED, Solved, Stage, Tried, rehearse_reading,
};
use scenelang_verify::report::statement_id;
use scenelang_verify::{Checked, Options};
use serde_json::{Value, json};
use std::path::Path;

/// What the program of a request is called, as by the command line.
const ROOM: &str = "room.scene";

/// Nobody looks on: the page shows that it waits.
struct Quiet;

impl Observer for Quiet {
    fn enter(&mut self, _: Stage) {}
    fn leave(&mut self, _: Stage) {}
    fn solving(&mut self, _: &scenelang_solve::Progress) {}
}

/// A layout of a program; `start`: the text of one to start from.
pub fn solve(name: &str, text: &str, start: Option<&str>, seed: u64) -> Result<Value, Refused> {
    solved(name, text, start, 1, seed)
}

/// The same; `share`: one part in so many of the work for preferences is enough.
fn solved(name: &str, text: &str, start: Option<&str>, share: u8, seed: u64) -> Result<Value, Refused> {
    let layout_name = layout_name(name);
    let member = format!("{}.scene", stem(name));
    let request = LayoutRequest {
        name,
        path: Path::new(name),
        files: &Alone { name, text },
        start: start.map(|text| (layout_name.as_str(), text)),
        before: None,
        layout_name: &layout_name,
        scene_member: &member,
        hold: Hold::Nothing,
        time: None,
        alternatives: None,
        free: 0,
        threads: 1,
        effort: 1,
        quality: scenelang_solve::QUALITY,
        share,
        stop: &Stop::default(),
        seed,
        judge: Options::default(),
        furniture: None,
    };
    match scenelang_synth::solve(&request, &mut Quiet) {
        Ok(solved) => Ok(told(&solved)),
        Err(Failure::Contradiction(checked)) => {
            let why = checked.verdict.diagnostics.iter().filter(|d| d.is_error());
            Ok(json!({ "layout": null, "end": "contradiction", "said": why.map(sentence).collect::<Vec<_>>() }))
        }
        Err(Failure::Input(_, diagnostics)) => {
            let errors = diagnostics.iter().filter(|d| d.severity == Severity::Error);
            Ok(json!({ "layout": null, "end": "errors", "said": errors.map(sentence).collect::<Vec<_>>() }))
        }
        Err(Failure::Interrupted) => Err("it was interrupted".to_owned()),
    }
}

fn sentence(diagnostic: &Diagnostic) -> String {
    diagnostic.message.clone()
}

fn told(solved: &Solved) -> Value {
    let found = &solved.first;
    let end = match found.outcome.end {
        End::Solved => "solved",
        End::Budget => "budget",
        End::Time => "time",
        End::Exhausted => "exhausted",
        End::Asked => "interrupted",
    };
    let said = solved.warnings.iter().map(sentence).chain(found.outcome.warnings.iter().cloned());
    json!({
        "layout": found.text, "end": end, "converged": found.outcome.converged, "in_the_way": in_the_way(found),
        "said": said.collect::<Vec<_>>(),
    })
}

/// Statements without which the rest can hold.
fn in_the_way(found: &JudgedLayout) -> Vec<Value> {
    let Checked { sources, program, report, .. } = &found.checked;
    let constraints = program.iter().flat_map(|program| &program.constraints).enumerate();
    let blamed = constraints.filter(|(index, _)| found.outcome.in_the_way.contains(index));
    blamed.map(|(_, c)| json!({ "id": statement_id(&report.file, sources, c.span), "text": c.text })).collect()
}

/// A room from a request in plain English: as `scenelang synth "…"` makes it.
pub fn write_room(request: &str) -> Result<Value, Refused> {
    let mut reading = read(request, &Reading { literal: false });
    if reading.nothing {
        return Err("nothing in the request was understood; say which objects are in which room".to_owned());
    }
    let objects: usize = reading.draft.things.iter().map(|thing| thing.count).sum();
    let (mut end, mut planned) = (Tried::Holds, None);
    if objects <= MOST_OBJECTS {
        (end, planned) = rehearse_reading(&mut reading, &Stop::default(), &mut |_| {});
        reading.draft.notes.sort_by_key(|note| (note.at.start, note.at.end));
    }
    let program = write(&reading.draft);
    let of = |at: &std::ops::Range<usize>| request.get(at.clone()).unwrap_or_default();
    let notes = reading.draft.notes.iter().map(|note| json!({ "text": of(&note.at), "reason": note.reason }));
    let unused = reading.words.iter().filter(|word| !word.used).map(|word| of(&word.at));
    let mut out = json!({
        "name": ROOM, "program": program, "clauses": reading.clauses, "understood": reading.understood,
        "notes": notes.collect::<Vec<_>>(), "unused": unused.collect::<Vec<_>>(), "solved": null, "overfull": null,
    });
    if end == Tried::Overfull {
        out["overfull"] = overfull(&reading.draft).into();
        return Ok(out);
    }
    let start = planned.map(|layout| layout_file::to_json(&layout, None));
    let share = if start.is_some() { PLANNED } else { 1 };
    out["solved"] = solved(ROOM, &program, start.as_deref(), share, 0)?;
    Ok(out)
}
