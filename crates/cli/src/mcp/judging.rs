//! Tools that judge and change nothing: `check`, `why_not`, `speculate`, `render`.

use super::tools::{Answered, Call, ToolAnswer};
use super::verdict::{self, folded};
use super::workspace::called;
use crate::room::{CheckedLayout, layout_of};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use scenelang_base::{SourceMap, codes};
use scenelang_export::{Exporter, picture, plan};
use scenelang_lang::compile_with;
use scenelang_verify::compare::{Difference, compare};
use scenelang_verify::prove::{ProveOptions, prove};
use scenelang_verify::report;
use serde::Deserialize;
use serde_json::{Value, json};

/// Margins that differ by no more are the same (metres or degrees).
const SEEN: f64 = 0.001;
/// So many steps of a proof are told.
const STEPS: usize = 60;
/// So many things of a picture are named.
const NAMED: usize = 200;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Check {
    file: String,
}

/// The verdict of a program and its layout.
pub fn check(call: &Call<'_>, Check { file }: Check) -> Answered {
    let path = call.workspace.scene_file(&file)?;
    let files = call.workspace.files(&path);
    files.text(&path)?;
    Ok(ToolAnswer::of(verdict::of(&call.workspace.judge(&path, &files))))
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WhyNot {
    file: String,
    statement: Option<String>,
    #[serde(default)]
    proof: bool,
}

/// What is proved impossible in a program, with the smallest set of statements that are to blame.
pub fn why_not(call: &Call<'_>, WhyNot { file, statement, proof }: WhyNot) -> Answered {
    let path = call.workspace.program(&call.workspace.scene_file(&file)?)?;
    let mut files = call.workspace.files(&path);
    let text = files.text(&path)?;
    if let Some(statement) = &statement {
        files = files.with(&path, format!("{}\n{statement}\n", text.trim_end()));
    }
    let judging = call.workspace.judging(&files)?;
    let compiled = compile_with(&called(&path), &path, scenelang_lang::Options::default(), &files, SourceMap::new());
    let Some(program) = &compiled.program else {
        let first = compiled.diagnostics.iter().find(|d| d.is_error());
        let why = first.map_or_else(String::new, |d| {
            let at = d.primary.as_ref().map(|label| place(&compiled.sources, label.place));
            format!(": {}{}", d.message, at.map_or_else(String::new, |at| format!(" ({at})")))
        });
        return Err(format!("{} does not compile{why}; use `check` for details", called(&path)));
    };
    let how = ProveOptions {
        judging: judging.options,
        explain: proof,
        redundant: false,
        usual: true,
        cancel: Some(call.stop.flag()),
        ..ProveOptions::default()
    };
    let findings = prove(program, &how);
    let found = findings.diagnostics(program);
    let found = found.iter().filter(|d| d.code == codes::E0401 || d.code == codes::E0402);
    let (contradictions, more) = verdict::list(found, |d| {
        let mut places = Vec::new();
        for label in d.primary.iter().chain(&d.related) {
            if !places.contains(&label.place) {
                places.push(label.place);
            }
        }
        let why: Vec<&str> = d.notes.iter().flat_map(|note| note.lines()).map(str::trim).take(STEPS).collect();
        let statements = places
            .iter()
            .map(|at| json!({ "at": place(&compiled.sources, *at), "text": folded(compiled.sources.text(*at)) }));
        json!({ "message": d.message, "statements": statements.collect::<Vec<_>>(), "why": why })
    });
    let mut out = json!({ "file": called(&path), "contradiction": !contradictions.is_empty() });
    out["text"] = match (contradictions.is_empty(), findings.complete && !findings.too_large) {
        (false, _) => {
            "in each of these sets, the statements contradict each other; remove or change one statement in each set"
        }
        (true, true) => {
            "nothing is proved impossible, which does not mean that there is a layout; `solve` looks for one"
        }
        (true, false) => "nothing is proved impossible, but not everything was examined; `solve` looks for a layout",
    }
    .into();
    if !contradictions.is_empty() {
        out["sets"] = contradictions.into();
    }
    if more > 0 {
        out["more_sets"] = more.into();
    }
    Ok(ToolAnswer::of(out))
}

/// `room.scene:3:1`
fn place(sources: &SourceMap, at: scenelang_base::Span) -> String {
    let place = report::place(sources, at);
    format!("{}:{}:{}", place.file, place.start[0], place.start[1])
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Speculate {
    file: String,
    text: Option<String>,
    #[serde(default)]
    edits: Vec<Edit>,
}

/// A piece of text in place of another.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Edit {
    old: String,
    new: String,
}

/// What an edit would do to the verdict, without making it.
pub fn speculate(call: &Call<'_>, Speculate { file, text, edits }: Speculate) -> Answered {
    let path = call.workspace.scene_file(&file)?;
    let files = call.workspace.files(&path);
    let was = files.text(&path)?;
    let now = match (text, edits.is_empty()) {
        (Some(text), true) => text,
        (None, false) => edited(was, &edits)?,
        _ => return Err("give either `text`, the whole new text of the file, or `edits`".to_owned()),
    };
    let before = call.workspace.judge(&path, &files);
    let after = call.workspace.judge(&path, &files.with(&path, now));
    let mut out = json!({
        "before": { "ok": before.report.ok, "summary": verdict::summary(&before.report, before.layout.is_some()) },
        "after": verdict::of(&after),
    });
    if before.layout.is_some() && after.layout.is_some() {
        let differences = compare(&before, &after, SEEN).constraints;
        let turns = differences.iter().filter(|row| !row.what.is_margin_only());
        let (turns, more) = verdict::list(turns, turn);
        out["changes"] = turns.into();
        if more > 0 {
            out["more_changes"] = more.into();
        }
    }
    Ok(ToolAnswer::of(out))
}

fn turn(row: &Difference) -> Value {
    let text = if row.kind.rule().is_some() { row.id.clone() } else { folded(&row.text) };
    json!({ "constraint": text, "what": row.what.as_str() })
}

/// A text with some pieces replaced, each of which is in it once.
fn edited(mut text: String, edits: &[Edit]) -> Result<String, String> {
    for Edit { old, new } in edits {
        match text.matches(old.as_str()).count() {
            _ if old.is_empty() => {
                return Err("`old` of an edit is empty, so it is not clear where the edit goes".to_owned());
            }
            0 => return Err(format!("`{old}` is not in the file")),
            1 => text = text.replacen(old.as_str(), new, 1),
            n => return Err(format!("`{old}` occurs {n} times in the file; give more of the text around it")),
        }
    }
    Ok(text)
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Render {
    file: String,
    #[serde(default)]
    view: View,
}

#[derive(Deserialize, Default, Clone, Copy)]
#[serde(rename_all = "lowercase")]
enum View {
    #[default]
    Plan,
    Picture,
}

/// A layout from above, or in perspective.
pub fn render(call: &Call<'_>, Render { file, view }: Render) -> Answered {
    let path = layout_of(&call.workspace.scene_file(&file)?);
    let files = call.workspace.files(&path);
    if !files.has(&path) {
        return Err(format!("there is no layout {}; `solve` makes one", called(&path)));
    }
    let room = CheckedLayout::judge(path.clone(), &files.door, &files)?;
    let scene = room.scene()?;
    let exporter: Box<dyn Exporter> = match view {
        View::Plan => Box::new(plan::Plan),
        View::Picture => Box::new(picture::Picture::default()),
    };
    let drawn = exporter.files(&scene).map_err(|e| e.to_string())?;
    let png = drawn.iter().find(|file| file.path.extension().is_some_and(|e| e == "png"));
    let png = png.ok_or("nothing was drawn")?;
    let said = json!({
        "file": called(&path),
        "ok": room.checked.report.ok,
        "objects": room.program.objects.iter().take(NAMED).map(|object| object.name.to_string()).collect::<Vec<_>>(),
    });
    Ok(ToolAnswer { said, picture: Some(BASE64_STANDARD.encode(&png.bytes)) })
}
