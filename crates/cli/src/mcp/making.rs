//! Tools that make something: `formalize`, `solve`, `repair`. What they make is written where the server may write, else
//! kept in memory.

use super::tools::{Answered, Call, ToolAnswer};
use super::verdict::{self, folded};
use super::workspace::{Made, called, is_program};
use crate::repair::{changes_layout, no_repair, programs};
use crate::room::layout_of;
use crate::solve::relative;
use crate::{formalize as reader, replace, solution};
use scenelang_base::Diagnostic;
use scenelang_base::FileId;
use scenelang_layout::file as layout_file;
use scenelang_solve::repair::told::{AlternativesReport, how, rounded, rows};
use scenelang_solve::repair::{Damaged, RepairOptions, Text, Unjudged, Which, repair as look};
use scenelang_synth::{Failure, Hold, LayoutRequest, Observer, Stage};
use scenelang_verify::Checked;
use serde::Deserialize;
use serde_json::{Value, json};

/// A longer request is none (bytes).
const REQUEST: usize = 64 << 10;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Formalize {
    request: String,
    file: Option<String>,
    #[serde(default)]
    literal: bool,
}

/// The program of a request in plain words.
pub fn formalize(call: &Call<'_>, Formalize { request, file, literal }: Formalize) -> Answered {
    if request.len() > REQUEST {
        return Err(format!(
            "a request of {} kB is too long: at most {} kB are read",
            request.len() >> 10,
            REQUEST >> 10
        ));
    }
    let path = file.map(|file| call.workspace.scene_file(&file)).transpose()?;
    if let Some(path) = &path {
        if !is_program(path) {
            return Err(format!("{} is not a name for a program; use NAME.scene", called(path)));
        }
        call.workspace.permit(path, &[])?;
    }
    let understood = reader::understand(reader::RequestSource::Words(request), literal, true, None, call.stop, None)?;
    if call.stop.is_set() {
        return Err(call.late());
    }
    if understood.reading.nothing {
        return Err("nothing in the request was understood; say which objects are in which room".to_owned());
    }
    let said = reader::summary(&understood.reading);
    let mut out = json!({ "understood": format!("{} of {} clauses", said["understood"], said["clauses"]) });
    let texts = |list: &Value| -> Vec<Value> {
        list.as_array().into_iter().flatten().map(|entry| entry["text"].clone()).collect()
    };
    let notes = said["notes"].as_array().into_iter().flatten();
    let notes: Vec<String> = notes
        .map(|n| {
            format!("\"{}\": {}", n["text"].as_str().unwrap_or_default(), n["reason"].as_str().unwrap_or_default())
        })
        .collect();
    for (name, list) in [
        ("not_used", json!(texts(&said["words"]["unused"]))),
        ("notes", json!(notes)),
        ("problems", json!(understood.diagnostics)),
    ] {
        if list.as_array().is_some_and(|list| !list.is_empty()) {
            out[name] = list;
        }
    }
    match path {
        // Whoever names a file can read it.
        Some(path) => kept(call, &mut out, vec![Made { path, text: understood.program, edited: false }])?,
        None => out["program"] = understood.program.into(),
    }
    Ok(ToolAnswer::of(out))
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Solve {
    file: String,
    #[serde(default)]
    seed: u64,
    #[serde(default)]
    lock: Vec<String>,
}

/// A layout of a program.
pub fn solve(call: &Call<'_>, Solve { file, seed, lock }: Solve) -> Answered {
    let path = call.workspace.scene_file(&file)?;
    if !is_program(&path) {
        return Err(format!(
            "{} is not a program; `solve` takes NAME.scene, and `repair` takes a layout",
            called(&path)
        ));
    }
    let layout = layout_of(&path);
    let files = call.workspace.files(&path);
    files.text(&path)?;
    let start = if lock.is_empty() { None } else { Some(files.text(&layout)?) };
    if start.is_none() {
        call.workspace.permit(&layout, &[&path])?;
    }
    let judging = call.workspace.judging(&files)?;
    let (name, layout_name) = (called(&path), called(&layout));
    let request = LayoutRequest {
        name: &name,
        path: &path,
        files: &files,
        start: start.as_ref().map(|text| (layout_name.as_str(), text.as_str())),
        before: None,
        share: 1,
        layout_name: &layout_name,
        scene_member: &relative(&path, &layout),
        hold: if lock.is_empty() { Hold::Nothing } else { Hold::These(&lock) },
        time: None,
        alternatives: None,
        free: 0,
        threads: 0,
        effort: 1,
        quality: scenelang_solve::QUALITY,
        stop: call.stop,
        seed,
        furniture: None,
        judge: judging.options,
    };
    let solved = match scenelang_synth::solve(&request, &mut Quiet) {
        Ok(solved) => solved,
        Err(Failure::Interrupted) => return Err(call.late()),
        Err(Failure::Contradiction(checked)) => {
            let mut out = verdict::of(&checked);
            out["text"] = "no layout satisfies all statements; `why_not` shows the smallest contradictory set".into();
            return Ok(ToolAnswer::of(out));
        }
        Err(Failure::Input(_, findings)) => return Err(input(&name, &findings)),
    };
    if solved.first.layout().incomplete {
        return Err(call.late());
    }
    let found = &solved.first;
    let mut out = verdict::of(&found.checked);
    let (in_the_way, more) =
        verdict::list(solution::named(found), |(id, text)| json!({ "id": id, "text": folded(text) }));
    if !in_the_way.is_empty() {
        out["in_the_way"] = in_the_way.into();
        out["text"] = "without the statements in `in_the_way`, the rest holds (found by search, not proved)".into();
    }
    if more > 0 {
        out["more_in_the_way"] = more.into();
    }
    let edited = start.as_ref().is_some_and(|text| !replace::is_ours(&layout, text));
    let text = found.text.clone();
    kept(call, &mut out, vec![Made { path: layout, text, edited }])?;
    Ok(ToolAnswer::of(out))
}

/// Why a program cannot be laid out.
fn input(name: &str, findings: &[Diagnostic]) -> String {
    let first = findings.iter().find(|d| d.is_error()).or(findings.first());
    format!("{name} cannot be solved: {}; use `check` for details", first.map_or("it has errors", |d| &d.message))
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Repair {
    file: String,
    constraint: Option<String>,
    apply: Option<u16>,
    #[serde(default)]
    lock: Vec<String>,
}

/// The smallest changes that repair a layout, and one of them made.
pub fn repair(call: &Call<'_>, Repair { file, constraint, apply, lock }: Repair) -> Answered {
    let path = layout_of(&call.workspace.scene_file(&file)?);
    let files = call.workspace.files(&path);
    let old = files.text(&path).map_err(|e| format!("{e}; `solve` makes a layout"))?;
    let name = called(&path);
    let judging = call.workspace.judging(&files)?;
    let checked = call.workspace.judge(&path, &files);
    let is_whole = !checked.verdict.diagnostics.iter().any(Diagnostic::is_error);
    let (Some(program), Some(layout), true) = (&checked.program, &checked.layout, is_whole) else {
        return Err(format!("{name} cannot be checked completely; `scenelang check` says why"));
    };
    if let Some(finding) = scenelang_synth::too_large(program) {
        return Err(finding.message);
    }
    let scene = call.workspace.program(&path)?;
    let main = called(&scene);
    let which = match &constraint {
        None => Which::All,
        Some(asked) => Which::Rows(rows(&checked, &main, asked)?),
    };
    let locked = Hold::These(&lock).objects(program, Some(layout)).map_err(|finding| finding.message)?;
    let compile = scenelang_lang::Options::default();
    let text = Text { name: &main, path: &scene, compile, loader: &files, sources: &checked.sources };
    let damaged = Damaged { program, layout, text: Some(text) };
    let options = RepairOptions { judge: judging.options, stop: call.stop.clone(), locked, ..RepairOptions::default() };
    let found = look(&damaged, &which, &options)
        .map_err(|Unjudged| format!("{name} cannot be checked completely; `scenelang check` says why"))?;
    if call.stop.is_set() {
        return Err(call.late());
    }
    let told = AlternativesReport { checked: &checked, program, name: &name };
    let (failing, more) = verdict::list(
        told.failing(&found.failing).into_iter(),
        |(id, _, text)| json!({ "id": id, "text": folded(&text) }),
    );
    let ways = found.alternatives.iter().enumerate();
    let ways =
        ways.map(|(i, way)| json!({ "n": i + 1, "how": how(way), "text": told.words(way), "cost": rounded(way.cost) }));
    let mut out = json!({ "file": name, "fails": failing, "ways": ways.collect::<Vec<_>>() });
    if more > 0 {
        out["more_fails"] = more.into();
    }
    if let Some(contradiction) = &found.contradiction {
        let member = |(id, text)| json!({ "id": id, "text": text });
        out["contradiction"] = told.members(contradiction).into_iter().map(member).collect();
    }
    let Some(n) = apply else {
        out["text"] = match (found.failing.is_empty(), found.alternatives.is_empty()) {
            (false, true) if found.contradiction.is_some() => "no layout satisfies all statements of the contradiction",
            (true, _) => "nothing to repair",
            (false, true) => "no repair was found, which is not a proof that none exists",
            (false, false) => "nothing has been changed yet; to apply a repair, call again with its number as `apply`",
        }
        .into();
        return Ok(ToolAnswer::of(out));
    };
    let chosen = usize::from(n).checked_sub(1).and_then(|i| found.alternatives.get(i));
    let chosen = chosen.ok_or_else(|| no_repair(usize::from(n), &found))?;
    let mut made: Vec<Made> = programs(&files.door, &checked, chosen)?
        .into_iter()
        .map(|(_, path, text)| Made { path, text, edited: true })
        .collect();
    if changes_layout(chosen) {
        let read = layout_file::read(&old, FileId(0));
        let mut layout = chosen.layout.clone();
        // What a search has left undone is done, if all of it holds now.
        layout.incomplete &= constraint.is_some();
        let text = layout_file::checked(&path, &layout, read.usable.then_some(&read.document));
        let edited = !replace::is_ours(&path, &old);
        made.push(Made { path: path.clone(), text: text.map_err(|e| e.to_string())?, edited });
    }
    out["applied"] = n.into();
    kept(call, &mut out, made)?;
    let after: Checked = call.workspace.judge(&path, &call.workspace.files(&path));
    out["after"] = verdict::of(&after);
    Ok(ToolAnswer::of(out))
}

/// Keeps or writes what was made, and says so.
fn kept(call: &Call<'_>, out: &mut Value, made: Vec<Made>) -> Result<(), String> {
    let names: Vec<String> = made.iter().map(|made| called(&made.path)).collect();
    call.workspace.keep(made)?;
    if call.workspace.writes() {
        out["written"] = json!(names);
    } else {
        out["in_memory"] = json!(names);
        out["note"] =
            "this server is not allowed to write files. The files listed in `in_memory` exist only until it stops, and only its tools can see them. Start it with `scenelang mcp --write` to write them to disk."
                .into();
    }
    Ok(())
}

/// Nobody looks on.
struct Quiet;

impl Observer for Quiet {
    fn enter(&mut self, _: Stage) {}
    fn leave(&mut self, _: Stage) {}
    fn solving(&mut self, _: &scenelang_solve::Progress) {}
}
