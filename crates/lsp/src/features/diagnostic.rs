//! Diagnostics for clients that ask for them: of a document, and of all programs of the workspace.

use crate::client::Client;
use crate::config::Config;
use crate::disk::{self, Files, Reach};
use crate::dispatch::{Context, Fault, Tokens, sent};
use crate::documents::{judge_by, layout_of, name_of};
use crate::publish::verdict;
use crate::reading::copied;
use crate::state::{Event, State, guarded};
use crate::text::Text;
use rustc_hash::{FxHashMap, FxHasher};
use scenelang_ide::Host;
use scenelang_lang::sources::Loader;
use serde::Deserialize;
use serde_json::Value;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::hash::{Hash, Hasher};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tower_lsp::jsonrpc::Id;
use tower_lsp::ls_types::{
    Diagnostic, DocumentDiagnosticReport, FullDocumentDiagnosticReport, RelatedFullDocumentDiagnosticReport,
    RelatedUnchangedDocumentDiagnosticReport, TextDocumentIdentifier, UnchangedDocumentDiagnosticReport, Uri,
    WorkspaceDiagnosticReport, WorkspaceDocumentDiagnosticReport, WorkspaceFullDocumentDiagnosticReport,
    WorkspaceUnchangedDocumentDiagnosticReport,
};

/// Parameters of `textDocument/diagnostic`.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct DiagnosticRequest {
    #[allow(dead_code, reason = "that it is there, and an address, is what matters")]
    text_document: TextDocumentIdentifier,
    previous_result_id: Option<String>,
}

/// `textDocument/diagnostic`
pub fn document(context: &Context, params: &DiagnosticRequest) -> Result<DocumentDiagnosticReport, Fault> {
    let id = context.generation.to_string();
    if params.previous_result_id.as_deref() == Some(&id) {
        let known = UnchangedDocumentDiagnosticReport { result_id: id };
        let report = RelatedUnchangedDocumentDiagnosticReport {
            related_documents: None,
            unchanged_document_diagnostic_report: known,
        };
        return Ok(report.into());
    }
    let mut marks = verdict(context)?.marks;
    let own = marks.remove(context.uri.as_str()).unwrap_or_default();
    let all = FullDocumentDiagnosticReport { result_id: Some(id), items: own };
    Ok(RelatedFullDocumentDiagnosticReport { related_documents: None, full_document_diagnostic_report: all }.into())
}

/// What a question about the workspace needs.
struct Workspace {
    roots: Arc<[PathBuf]>,
    files: Files,
    client: Arc<Client>,
    config: Arc<Config>,
    open: BTreeMap<PathBuf, Uri>,
    /// What the client was told before, by address.
    before: BTreeMap<String, String>,
}

impl State {
    /// `workspace/diagnostic`: about the programs that are not open. A client that knows all of it already waits until
    /// something changes.
    pub fn workspace_diagnostic(&mut self, id: &Id, given: Value) {
        let before = given["previousResultIds"].as_array().into_iter().flatten();
        let before = before.filter_map(|p| Some((p["uri"].as_str()?.to_owned(), p["value"].as_str()?.to_owned())));
        let workspace = Workspace {
            roots: Arc::clone(&self.roots),
            files: self.documents.files(),
            client: Arc::clone(&self.client),
            config: Arc::clone(&self.config),
            open: self.documents.iter().map(|d| (d.path.clone(), d.uri.clone())).collect(),
            before: before.collect(),
        };
        let (id, events, wakes) = (id.clone(), self.events(), self.wakes);
        self.in_background(move || {
            let found = guarded(|| Ok(workspace.reports()));
            let _ = events.send(Event::Done(Box::new(move |state: &mut State| match found {
                // What changed while it was looked at may have been looked at before.
                Ok((_, false)) if state.wakes != wakes => state.workspace_diagnostic(&id, given),
                Ok((_, false)) => state.waiting.push((id, given)),
                Ok((items, true)) => state.reply(&id, sent(WorkspaceDiagnosticReport { items })),
                Err(fault) => state.reply(&id, Err(fault)),
            })));
        });
    }
}

/// What was read of files, by the root of who read them: programs of a workspace import the same files.
type Read = RefCell<FxHashMap<(PathBuf, PathBuf), io::Result<Vec<u8>>>>;

/// Files that are read once.
struct Once<'a> {
    reach: &'a Reach,
    read: &'a Read,
}

impl Loader for Once<'_> {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        let key = (self.reach.door().root().to_path_buf(), path.to_owned());
        let mut all = self.read.borrow_mut();
        let read = all.entry(key).or_insert_with(|| self.reach.load(path));
        read.as_ref().map(Vec::clone).map_err(copied)
    }
}

impl Workspace {
    /// A report for each program, and whether any says something new.
    fn reports(&self) -> (Vec<WorkspaceDocumentDiagnosticReport>, bool) {
        let mut items = Vec::new();
        let mut news = self.before.is_empty();
        let mut known = self.before.clone();
        let read = Read::default();
        for path in self.roots.iter().flat_map(|root| disk::programs(root)) {
            let Some(uri) = disk::uri_of(&path).filter(|_| !self.open.contains_key(&path)) else { continue };
            let before = known.remove(uri.as_str());
            if let Some((item, new)) = self.report(&path, &uri, before.as_deref(), &read) {
                items.push(item);
                news |= new;
            }
        }
        // Nothing is said any more of files that are gone, once; open ones are asked about one by one.
        let gone = known.into_keys().filter(|uri| self.open.values().all(|open| open.as_str() != uri));
        for uri in gone.filter_map(|uri| uri.parse().ok()) {
            items.push(full(uri, None, Vec::new()));
            news = true;
        }
        (items, news)
    }

    fn report(
        &self,
        path: &Path,
        uri: &Uri,
        before: Option<&str>,
        read: &Read,
    ) -> Option<(WorkspaceDocumentDiagnosticReport, bool)> {
        let reach = self.files.of(path);
        let files = Once { reach: &reach, read };
        let text = String::from_utf8_lossy(&files.load(path).ok()?).into_owned();
        let mut host = Host::new(&name_of(path), path, &text, &files);
        let layout = layout_of(path, &self.config);
        let settings = judge_by(&mut host, layout.as_deref(), reach.door(), &files);
        let snapshot = host.snapshot();
        let mut hasher = FxHasher::default();
        snapshot.sources().iter().for_each(|(_, file)| file.text().hash(&mut hasher));
        settings.sources.iter().for_each(|(_, file)| file.text().hash(&mut hasher));
        let id = format!("{:016x}", hasher.finish());
        if before == Some(&id) {
            let unchanged_document_diagnostic_report = UnchangedDocumentDiagnosticReport { result_id: id };
            let (uri, version) = (uri.clone(), None);
            let report =
                WorkspaceUnchangedDocumentDiagnosticReport { uri, version, unchanged_document_diagnostic_report };
            return Some((report.into(), false));
        }
        let context = Context {
            uri: uri.clone(),
            path: path.to_owned(),
            text: Arc::new(Text::new(text)),
            snapshot,
            layout,
            settings,
            generation: 0,
            client: Arc::clone(&self.client),
            config: Arc::clone(&self.config),
            tokens: Tokens::default(),
            looks: Arc::default(),
            open: self.open.clone(),
            versions: BTreeMap::new(),
            files: self.files.clone(),
            roots: Arc::clone(&self.roots),
        };
        let own = verdict(&context).ok()?.marks.remove(uri.as_str()).unwrap_or_default();
        Some((full(uri.clone(), Some(id), own), true))
    }
}

/// All that is marked in a file that is not open.
fn full(uri: Uri, result_id: Option<String>, items: Vec<Diagnostic>) -> WorkspaceDocumentDiagnosticReport {
    let full_document_diagnostic_report = FullDocumentDiagnosticReport { result_id, items };
    WorkspaceFullDocumentDiagnosticReport { uri, version: None, full_document_diagnostic_report }.into()
}
