//! From places in files to what the protocol has: addresses, lines, units.

use crate::change::{TextChange, WorkspaceChange};
use crate::disk::uri_of;
use crate::text::{Encoding, Text};
use scenelang_base::{FileId, SourceMap, Span};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
use tower_lsp::ls_types::{Location, Range, Uri};

/// Where the files of a program are, and their lines; lines of imported files are counted when somebody asks.
pub struct Places<'a> {
    sources: &'a SourceMap,
    encoding: Encoding,
    /// Addresses of open documents, which must be given back as they came.
    open: &'a BTreeMap<PathBuf, Uri>,
    main: (FileId, Arc<Text>),
    others: Mutex<BTreeMap<FileId, Arc<Text>>>,
}

impl<'a> Places<'a> {
    /// Places in these files; `main` is the document that was asked about.
    pub fn new(
        sources: &'a SourceMap,
        encoding: Encoding,
        open: &'a BTreeMap<PathBuf, Uri>,
        main: (FileId, Arc<Text>),
    ) -> Self {
        Self { sources, encoding, open, main, others: Mutex::default() }
    }

    /// The text of a file with its lines.
    pub fn text(&self, file: FileId) -> Arc<Text> {
        if file == self.main.0 {
            return Arc::clone(&self.main.1);
        }
        let mut others = self.others.lock().unwrap_or_else(PoisonError::into_inner);
        let make = || Arc::new(Text::new(self.sources.get(file).text().to_owned()));
        Arc::clone(others.entry(file).or_insert_with(make))
    }

    /// The address of a file; `None`: it has none (a buffer that was never saved imports nothing).
    pub fn uri(&self, file: FileId) -> Option<Uri> {
        let path = self.sources.get(file).path();
        self.open.get(path).cloned().or_else(|| uri_of(path))
    }

    /// A place as lines and units.
    pub fn range(&self, span: Span) -> Range {
        self.text(span.file).range(span.range, self.encoding)
    }

    /// A place with its address.
    pub fn location(&self, span: Span) -> Option<Location> {
        Some(Location { uri: self.uri(span.file)?, range: self.range(span) })
    }

    /// Edits of files as a change of the workspace. `versions`: those of open documents.
    pub fn workspace_edit(
        &self,
        edits: &[scenelang_base::Edit],
        versions: Option<&BTreeMap<String, i32>>,
    ) -> WorkspaceChange {
        WorkspaceChange::new(self.by_file(edits), versions)
    }

    /// Edits by the address of the file.
    pub fn by_file(&self, edits: &[scenelang_base::Edit]) -> BTreeMap<String, Vec<TextChange>> {
        let mut by_file: BTreeMap<String, Vec<TextChange>> = BTreeMap::new();
        for edit in edits {
            let Some(uri) = self.uri(edit.place.file) else { continue };
            let change = TextChange::new(self.range(edit.place), edit.text.clone());
            by_file.entry(uri.as_str().to_owned()).or_default().push(change);
        }
        by_file
    }
}
