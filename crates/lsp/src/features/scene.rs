//! The scene as a picture shows it, with what holds in it; and what the program becomes, to look at.

use crate::commands::count;
use crate::disk;
use crate::dispatch::{Context, Fault};
use scenelang_base::FileId;
use scenelang_export::{Scene, SceneInput, preview};
use scenelang_ide::{forms, symbols};
use scenelang_verify::report;
use serde::Deserialize;
use serde_json::{Value, json};
use tower_lsp::ls_types::Uri;

/// Parameters of `scenelang/scene`.
#[derive(Deserialize)]
pub struct Seen {
    #[allow(dead_code, reason = "that it is there, and an address, is what matters")]
    uri: Uri,
    /// The shape that the client has; it needs the geometry of another one only.
    known: Option<String>,
}

/// `scenelang/scene`
pub fn scene(context: &Context, seen: &Seen) -> Result<Value, Fault> {
    let snapshot = &context.snapshot;
    let places = context.places();
    let objects: Vec<Value> = symbols::outline(snapshot, context.file())?
        .into_iter()
        .filter(|e| matches!(e.sort, symbols::Sort::Object | symbols::Sort::Array))
        .map(|e| json!({ "name": e.name, "range": context.range(e.name_range) }))
        .collect();
    let layout = context.layout.as_deref().and_then(disk::uri_of);
    let (Some(judged), Some(file)) = (snapshot.judged()?, snapshot.layout()) else {
        return Ok(json!({
            "layout": null, "data": null, "holds": 0, "total": 0, "constraints": [], "objects": objects,
        }));
    };
    let program = &judged.compiled.program;
    let name = snapshot.sources().get(file.file).name();
    let report = report::build(name, &judged.verdict, Some(program), snapshot.sources(), &snapshot.judging().options);
    let rows = judged.verdict.rows.iter().zip(&report.constraints).map(|(row, listed)| {
        let state = match row.satisfied {
            Some(true) => "holds",
            Some(false) => "fails",
            None => "unknown",
        };
        let range = places.range(row.place);
        json!({
            "id": listed.id, "text": listed.text, "line": range.start.line, "uri": places.uri(row.place.file),
            "range": range, "state": state, "margin": listed.margin, "unit": listed.unit, "objects": listed.objects,
        })
    });
    let rows: Vec<Value> = rows.collect();
    let [holds, total] = count(&judged.verdict);
    let report = serde_json::to_value(&report).map_err(|_| Fault::Internal)?;
    let stem = context.path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let files: Vec<FileId> = snapshot.sources().iter().map(|(id, _)| id).filter(|id| *id != file.file).collect();
    let input = SceneInput {
        name: &stem,
        program,
        sources: snapshot.sources(),
        files: &files,
        layout: &file.read.layout,
        layout_text: snapshot.sources().get(file.file).text(),
        report: &report,
    };
    // A layout that lacks something cannot be drawn; its rows can be listed.
    let scene = Scene::build(&input).ok();
    drop(report);
    let data = scene.and_then(|scene| preview::live(scene, seen.known.as_deref()).ok());
    let mut out = json!({ "layout": layout, "holds": holds, "total": total });
    // The macro would copy these, and they are large.
    out["data"] = data.unwrap_or_default();
    out["constraints"] = rows.into();
    out["objects"] = objects.into();
    Ok(out)
}

/// Parameters of `scenelang/forms`.
#[derive(Deserialize)]
pub struct Form {
    #[allow(dead_code, reason = "that it is there, and an address, is what matters")]
    uri: Uri,
    form: Kind,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Kind {
    Syntax,
    Hir,
    Constraints,
}

/// `scenelang/forms`
pub fn forms(context: &Context, params: &Form) -> Result<Value, Fault> {
    let snapshot = &context.snapshot;
    let sources = snapshot.sources();
    let text = match params.form {
        Kind::Syntax => forms::syntax::text(snapshot.text()),
        Kind::Hir => forms::hir::text(sources.get(context.file()), sources, &snapshot.meanings()?),
        Kind::Constraints => forms::constraints::text(&snapshot.compiled()?.program, sources, context.file()),
    };
    Ok(json!({ "text": text }))
}
