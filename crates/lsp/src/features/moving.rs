//! `workspace/willRenameFiles`: what has to be written anew when files and folders get other names, and layouts that go with
//! their programs.

use crate::change::{TextChange, WorkspaceChange};
use crate::client::Client;
use crate::config::Config;
use crate::disk::{self, Files};
use crate::documents::layout_of;
use crate::text::Text;
use scenelang_base::{Edit, TextRange};
use scenelang_ide::moving::{self, Moves};
use scenelang_lang::sources::Loader;
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tower_lsp::ls_types::Uri;

/// Parameters of `workspace/willRenameFiles`.
#[derive(Deserialize)]
pub struct Renames {
    files: Vec<Renamed>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Renamed {
    old_uri: Uri,
    new_uri: Uri,
}

/// What is known of the workspace whose files are renamed.
pub struct Workspace {
    /// Its folders.
    pub roots: Arc<[PathBuf]>,
    /// Open texts, then the disk.
    pub files: Files,
    /// What the client can.
    pub client: Arc<Client>,
    /// Where layouts are.
    pub config: Arc<Config>,
    /// Addresses of open documents.
    pub open: BTreeMap<PathBuf, Uri>,
    pub versions: BTreeMap<String, i32>,
}

impl Workspace {
    /// The edits that keep imports and layouts, to be made before the files are moved; `None`: nothing has to be.
    pub fn edits(&self, asked: &Renames) -> Option<WorkspaceChange> {
        let pairs = asked.files.iter().map(|file| (disk::path_of(&file.old_uri), disk::path_of(&file.new_uri)));
        let mut moves = Moves(pairs.collect());
        let programs = self.programs(&moves);
        let layouts: BTreeSet<PathBuf> = programs.iter().filter_map(|path| layout_of(path, &self.config)).collect();
        let follow: Vec<(PathBuf, PathBuf)> = programs.iter().filter_map(|path| self.follows(path, &moves)).collect();
        moves.0.extend(follow.iter().cloned());
        let moved = moves.0.iter().map(|(from, _)| from.clone()).filter(|path| is_layout(path));
        let layouts = layouts.into_iter().chain(moved).collect::<BTreeSet<PathBuf>>();

        let mut changes: BTreeMap<String, Vec<TextChange>> = BTreeMap::new();
        for path in &programs {
            let there = |file: &Path| self.files.of(path).has(file);
            self.change(path, &mut changes, |text| moving::imports(path, text, &moves, &there));
        }
        for path in &layouts {
            let there = |file: &Path| self.files.of(path).has(file);
            self.change(path, &mut changes, |text| moving::program(path, text, &moves, &there).into_iter().collect());
        }
        if changes.is_empty() && follow.is_empty() {
            return None;
        }
        let mut out = WorkspaceChange::new(changes, self.client.document_changes.then_some(&self.versions));
        for (from, to) in &follow {
            if let (Some(old), Some(new)) = (self.uri(from), disk::uri_of(to)) {
                out.rename(old, new);
            }
        }
        Some(out)
    }

    /// Programs that may have to be changed: those of the workspace, open ones, and those that are moved.
    fn programs(&self, moves: &Moves) -> Vec<PathBuf> {
        let mut paths: Vec<PathBuf> = self.roots.iter().flat_map(|root| disk::programs(root)).collect();
        let moved = moves.0.iter().map(|(from, _)| from.clone());
        let further = self.files.texts.keys().cloned().chain(moved);
        paths.extend(further.filter(|path| path.extension().is_some_and(|e| e == "scene")));
        paths.sort_unstable();
        paths.dedup();
        paths
    }

    /// The layout that has to go with a program, and where to.
    fn follows(&self, program: &Path, moves: &Moves) -> Option<(PathBuf, PathBuf)> {
        let (from, to) = (layout_of(program, &self.config)?, layout_of(&moves.of(program), &self.config)?);
        let can = self.client.renames && self.client.document_changes;
        let reach = self.files.of(program);
        // What the user moves besides, or what is there already, is left alone.
        let own = moves.has(program) && !moves.has(&from) && from != to && reach.has(&from) && !reach.has(&to);
        (can && own).then_some((from, to))
    }

    fn uri(&self, path: &Path) -> Option<Uri> {
        self.open.get(path).cloned().or_else(|| disk::uri_of(path))
    }

    fn change(
        &self,
        path: &Path,
        changes: &mut BTreeMap<String, Vec<TextChange>>,
        edits: impl FnOnce(&str) -> Vec<Edit<TextRange>>,
    ) {
        let Some(bytes) = self.files.of(path).load(path).ok() else { return };
        let (Ok(text), Some(uri)) = (String::from_utf8(bytes), self.uri(path)) else { return };
        let edits = edits(&text);
        if edits.is_empty() {
            return;
        }
        let text = Text::new(text);
        let shown =
            |edit: &Edit<TextRange>| TextChange::new(text.range(edit.place, self.client.encoding), edit.text.clone());
        changes.insert(uri.as_str().to_owned(), edits.iter().map(shown).collect());
    }
}

fn is_layout(path: &Path) -> bool {
    path.to_string_lossy().ends_with(".layout.json")
}
