//! References and new names in all programs of the workspace that read the file of a declaration, open or not.

use crate::change::{TextChange, WorkspaceChange};
use crate::convert::Places;
use crate::disk;
use crate::dispatch::{Context, Fault};
use crate::documents::{judge_by, layout_of, name_of};
use crate::text::Text;
use scenelang_base::Edit;
use scenelang_ide::across::{Shared, shared};
use scenelang_ide::{Host, Snapshot};
use scenelang_lang::sources::Loader;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;
use tower_lsp::ls_types::{Location, Position, Range};

/// A program that names something, too.
struct Other {
    path: PathBuf,
    snapshot: Snapshot,
}

impl Other {
    fn places<'a>(&'a self, context: &'a Context) -> Places<'a> {
        let main = (self.snapshot.main(), Arc::new(Text::new(self.snapshot.text().to_owned())));
        Places::new(self.snapshot.sources(), context.client.encoding, &context.open, main)
    }
}

/// The other programs that read the file in which something is declared: open ones, and those in the folders of the
/// workspace, as many as are looked at there.
fn others(context: &Context, shared: &Shared) -> Vec<Other> {
    let is_program = |path: &&PathBuf| path.extension().is_some_and(|e| e == "scene");
    let mut paths: Vec<PathBuf> = context.roots.iter().flat_map(|root| disk::programs(root)).collect();
    paths.extend(context.files.texts.keys().filter(is_program).cloned());
    paths.sort_unstable();
    paths.dedup();
    paths.retain(|path| *path != context.path);
    paths.into_iter().filter_map(|path| other(context, shared, path)).collect()
}

fn other(context: &Context, shared: &Shared, path: PathBuf) -> Option<Other> {
    let files = context.files.of(&path);
    let text = String::from_utf8(files.load(&path).ok()?).ok()?;
    // Most programs read no other, and are not looked into.
    if path != shared.path && !text.contains("import") {
        return None;
    }
    let mut host = Host::new(&name_of(&path), &path, &text, &files);
    if !shared.is_read_by(host.files()) {
        return None;
    }
    judge_by(&mut host, layout_of(&path, &context.config).as_deref(), files.door(), &files);
    Some(Other { snapshot: host.snapshot(), path })
}

/// Where else something is named than in the program that was asked about: places that are not known yet.
pub fn references(context: &Context, at: Position, declaration: bool, known: &mut Vec<Location>) -> Result<(), Fault> {
    let Some(shared) = shared(&context.snapshot, context.offset(at))? else { return Ok(()) };
    let key = |place: &Location| (place.uri.as_str().to_owned(), place.range.start);
    let mut seen: BTreeSet<(String, Position)> = known.iter().map(key).collect();
    for other in others(context, &shared) {
        let places = other.places(context);
        let spans = shared.references(&other.snapshot, declaration)?;
        let found = spans.into_iter().filter_map(|(span, _)| places.location(span));
        known.extend(found.filter(|place| seen.insert(key(place))));
    }
    Ok(())
}

/// Edits of one program, and of all others that name the same, as a change of the workspace.
///
/// # Errors
/// One of the others has another meaning for the new name.
pub fn rename(context: &Context, at: Position, new: &str, own: &[Edit]) -> Result<WorkspaceChange, Fault> {
    let mut made = Made::default();
    made.add(&context.places(), own);
    if let Some(shared) = shared(&context.snapshot, context.offset(at))? {
        for other in others(context, &shared) {
            let why = |why| Fault::Failed(format!("in {}: {why}", name_of(&other.path)));
            let edits = shared.rename(&other.snapshot, new)?.map_err(why)?;
            made.add(&other.places(context), &edits);
        }
    }
    Ok(WorkspaceChange::new(made.listed(), context.edit_versions()))
}

/// Edits by address and place: a file that several programs read is changed once.
#[derive(Default)]
struct Made(BTreeMap<String, BTreeMap<(Position, Position), String>>);

impl Made {
    fn add(&mut self, places: &Places<'_>, edits: &[Edit]) {
        for edit in edits {
            let Some(uri) = places.uri(edit.place.file) else { continue };
            let range = places.range(edit.place);
            self.0.entry(uri.as_str().to_owned()).or_default().insert((range.start, range.end), edit.text.clone());
        }
    }

    fn listed(self) -> BTreeMap<String, Vec<TextChange>> {
        let listed = |((start, end), text)| TextChange::new(Range { start, end }, text);
        self.0.into_iter().map(|(uri, edits)| (uri, edits.into_iter().map(listed).collect())).collect()
    }
}
