//! The scene as a picture shows it, with what holds in it; and what the program becomes, to look at.

use crate::disk;
use crate::dispatch::{Context, Fault};
use crate::picture::Picture;
use scenelang_ide::{forms, symbols};
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
    let picture = Picture {
        path: &context.path,
        program: &judged.compiled.program,
        sources: snapshot.sources(),
        about: file.file,
        layout_file: Some(file.file),
        layout: &file.read.layout,
        text: snapshot.sources().get(file.file).text(),
        verdict: &judged.verdict,
        options: &snapshot.judging().options,
        looks: &context.looks,
    };
    let mut out = picture.value(&places, seen.known.as_deref())?;
    out["layout"] = json!(layout);
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
