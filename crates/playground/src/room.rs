//! The room as a viewer shows it, what becomes of it when something is moved, and its files.

use crate::files::stem;
use crate::request::Format;
use crate::session::{Open, Refused, cancelled};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use scenelang_base::owned::sealed_json;
use scenelang_base::{Edit, FileId, TextRange, fix};
use scenelang_engine::{Live, moved as verdicts};
use scenelang_export::{Scene, SceneInput, glb, preview};
use scenelang_ide::actions::placing;
use scenelang_ide::{Judged, LayoutFile, Snapshot};
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Vec3, file as layout_file};
use scenelang_verify::report;
use serde_json::{Value, json};
use std::sync::Arc;

const NO_LAYOUT: &str = "there is no layout yet";

/// The room, `scenelang.preview/1`; `null`: there is no layout that can be shown.
pub fn shown(open: &Open, known: Option<&str>, plan: bool) -> Result<Value, Refused> {
    let snapshot = open.host.snapshot();
    let Some((judged, layout)) = judged(&snapshot)? else { return Ok(Value::Null) };
    // A layout that lacks something cannot be drawn; that is marked in the program.
    let Ok(scene) = scene(open, &snapshot, &judged, layout) else { return Ok(Value::Null) };
    preview::live(scene, known, plan).map_err(|e| e.to_string())
}

fn judged(snapshot: &Snapshot) -> Result<Option<(Arc<Judged>, &LayoutFile)>, Refused> {
    Ok(snapshot.judged().map_err(cancelled)?.zip(snapshot.layout()))
}

fn scene(open: &Open, snapshot: &Snapshot, judged: &Judged, layout: &LayoutFile) -> Result<Scene, Refused> {
    let program = &judged.compiled.program;
    let sources = snapshot.sources();
    let name = sources.get(layout.file).name();
    let options = &snapshot.judging().options;
    let report = report::build(name, &judged.verdict, Some(program), sources, options);
    let report = serde_json::to_value(&report).map_err(|e| e.to_string())?;
    let files: Vec<FileId> = sources.iter().map(|(id, _)| id).filter(|id| *id != layout.file).collect();
    let input = SceneInput {
        name: stem(&open.name),
        program,
        sources,
        files: &files,
        layout: &layout.read.layout,
        layout_text: sources.get(layout.file).text(),
        report: &report,
    };
    Scene::remembered(&input, &open.looks).map_err(|e| e.to_string())
}

/// What holds if an object is put elsewhere, and the text of that layout.
pub fn moved(snapshot: &Snapshot, object: &str, pos: [f64; 3], rot: [f64; 3]) -> Result<(Value, String), Refused> {
    if pos.iter().chain(&rot).any(|x| !x.is_finite() || x.abs() > layout_file::LARGEST) {
        return Err("a position is three numbers within a million".to_owned());
    }
    let (judged, layout) = judged(snapshot)?.ok_or(NO_LAYOUT)?;
    let program = &judged.compiled.program;
    let index = program.objects.iter().position(|o| o.name == object);
    let index = index.ok_or_else(|| format!("the program has no `{object}`"))?;
    let (pos, rot) = (Vec3::from(pos), Vec3::from(rot));
    let edits = placing(layout, object, pos, rot).ok_or_else(|| format!("the layout has no `{object}`"))?;
    let mut options = snapshot.judging().options;
    options.physics &= judged.compiled.complete;
    let mut live = Live::new(program, &layout.read.layout, &options);
    live.drag(ObjectId(index as u32), pos, rot);
    let file = snapshot.sources().get(layout.file);
    let answer = verdicts(&live, program, snapshot.sources(), file.name());
    let local: Vec<Edit<TextRange>> = edits.into_iter().map(|e| Edit { place: e.place.range, text: e.text }).collect();
    Ok((answer, fix::apply(file.text(), [local.as_slice()]).text))
}

/// A file of the room: its name, and its text or its bytes in base64.
pub fn exported(open: &Open, format: Format) -> Result<Value, Refused> {
    let snapshot = open.host.snapshot();
    let (judged, layout) = judged(&snapshot)?.ok_or(NO_LAYOUT)?;
    let stem = stem(&open.name);
    let text = snapshot.sources().get(layout.file).text();
    Ok(match format {
        Format::Layout => json!({ "name": format!("{stem}.layout.json"), "text": sealed_json(text) }),
        Format::Report => {
            let verdict = snapshot.explained().map_err(cancelled)?.ok_or(NO_LAYOUT)?;
            let name = snapshot.sources().get(layout.file).name();
            let options = &snapshot.judging().options;
            let report = report::build(name, &verdict, Some(&judged.compiled.program), snapshot.sources(), options);
            let mut text = serde_json::to_string_pretty(&report).map_err(|e| e.to_string())?;
            text.push('\n');
            json!({ "name": "report.json", "text": text })
        }
        Format::Glb => {
            let scene = scene(open, &snapshot, &judged, layout)?;
            let bytes = glb::bytes(&scene).map_err(|e| e.to_string())?;
            json!({ "name": format!("{stem}.glb"), "base64": STANDARD.encode(bytes) })
        }
    })
}
