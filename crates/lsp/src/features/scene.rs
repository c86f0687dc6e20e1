//! The scene as a picture shows it, with what holds in it; and what the program becomes, to look at.

use crate::disk;
use crate::dispatch::{Context, Fault};
use crate::picture::{Picture, Shown};
use scenelang_ide::{forms, symbols};
use serde::{Deserialize, Serialize};
use tower_lsp::ls_types::{Range, Uri};

/// Parameters of `scenelang/scene`.
#[derive(Deserialize)]
pub struct Seen {
    #[allow(dead_code, reason = "that it is there, and an address, is what matters")]
    uri: Uri,
    /// The shape that the client has; it needs the geometry of another one only.
    known: Option<String>,
}

/// What `scenelang/scene` answers.
#[derive(Serialize)]
pub struct SceneAnswer {
    #[serde(flatten)]
    shown: Shown,
    /// The address of the layout; null: the program has none.
    layout: Option<Uri>,
    objects: Vec<Declared>,
}

/// An object, or an array of them, and where its name is declared.
#[derive(Serialize)]
struct Declared {
    name: String,
    range: Range,
}

/// `scenelang/scene`
pub fn scene(context: &Context, seen: &Seen) -> Result<SceneAnswer, Fault> {
    let snapshot = &context.snapshot;
    let places = context.places();
    let objects: Vec<Declared> = symbols::outline(snapshot, context.file())?
        .into_iter()
        .filter(|e| matches!(e.sort, symbols::Sort::Object | symbols::Sort::Array))
        .map(|e| Declared { name: e.name, range: context.range(e.name_range) })
        .collect();
    let layout = context.layout.as_deref().and_then(disk::uri_of);
    let (Some(judged), Some(file)) = (snapshot.judged()?, snapshot.layout()) else {
        return Ok(SceneAnswer { shown: Shown::default(), layout: None, objects });
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
    Ok(SceneAnswer { shown: picture.shown(&places, seen.known.as_deref())?, layout, objects })
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

/// What `scenelang/forms` answers.
#[derive(Serialize)]
pub struct FormText {
    text: String,
}

/// `scenelang/forms`
pub fn forms(context: &Context, params: &Form) -> Result<FormText, Fault> {
    let snapshot = &context.snapshot;
    let sources = snapshot.sources();
    let text = match params.form {
        Kind::Syntax => forms::syntax::text(snapshot.text()),
        Kind::Hir => forms::hir::text(sources.get(context.file()), sources, &snapshot.meanings()?),
        Kind::Constraints => forms::constraints::text(&snapshot.compiled()?.program, sources, context.file()),
    };
    Ok(FormText { text })
}
