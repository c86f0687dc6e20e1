//! Which handler answers which question.

use crate::client::Client;
use crate::config::Config;
use crate::convert::Places;
use crate::disk::Files;
use crate::features;
use crate::state::State;
use crate::text::Text;
use scenelang_analysis::FileSettings;
use scenelang_base::{FileId, TextRange};
use scenelang_export::scene::Memory;
use scenelang_ide::{Cancelled, Snapshot};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Arc, Mutex};
use tower_lsp::jsonrpc::{Error, ErrorCode, Id};
use tower_lsp::ls_types::{CompletionItem, InlayHint, Position, Range, SemanticToken, Uri};

/// The numbers of semantic tokens, by the number of the answer that they were in.
pub type Tokens = Arc<Mutex<Option<(String, Vec<SemanticToken>)>>>;

/// What a handler sees of the program that it is asked about.
pub struct Context {
    /// The document.
    pub uri: Uri,
    /// Where it is.
    pub path: PathBuf,
    pub text: Arc<Text>,
    /// What is known of it.
    pub snapshot: Snapshot,
    /// Where its layout is, or would be.
    pub layout: Option<PathBuf>,
    /// The settings of its workspace.
    pub settings: Arc<FileSettings>,
    /// Which of its verdicts is asked for.
    pub generation: u64,
    /// What the client can.
    pub client: Arc<Client>,
    /// What the user has set.
    pub config: Arc<Config>,
    /// The semantic tokens that were sent last, with the number of that answer.
    pub tokens: Tokens,
    /// What the objects of its room look like.
    pub looks: Arc<Memory>,
    /// Addresses of open documents.
    pub open: BTreeMap<PathBuf, Uri>,
    /// Versions of open documents.
    pub versions: BTreeMap<String, i32>,
    /// Open texts, then the disk.
    pub files: Files,
    /// The folders of the workspace.
    pub roots: Arc<[PathBuf]>,
}

impl Context {
    /// Places in its files.
    pub fn places(&self) -> Places<'_> {
        let main = (self.snapshot.main(), Arc::clone(&self.text));
        Places::new(self.snapshot.sources(), self.client.encoding, &self.open, main)
    }
    /// Its own file.
    pub fn file(&self) -> FileId {
        self.snapshot.main()
    }
    /// The byte offset of a position.
    pub fn offset(&self, at: Position) -> u32 {
        self.text.offset(at, self.client.encoding)
    }
    /// A range of positions as bytes.
    pub fn bytes(&self, range: Range) -> TextRange {
        self.text.bytes(range, self.client.encoding)
    }
    /// A range of bytes as positions.
    pub fn range(&self, range: TextRange) -> Range {
        self.text.range(range, self.client.encoding)
    }
    /// Versions, if the client has edits with these.
    pub fn edit_versions(&self) -> Option<&BTreeMap<String, i32>> {
        self.client.document_changes.then_some(&self.versions)
    }
}

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// The text has changed: ask again.
    Outdated,
    /// There is no such question.
    Unknown(String),
    /// It does not ask about anything.
    Invalid(String),
    /// It cannot be done, and why.
    Failed(String),
    /// Somebody does not want it any more.
    Cancelled,
    /// A mistake of ours.
    Internal,
}

impl Fault {
    /// As the protocol has it.
    pub fn into_error(self) -> Error {
        let with = |code, message: String| Error { code, message: message.into(), data: None };
        match self {
            Self::Outdated => Error::content_modified(),
            Self::Unknown(method) => with(ErrorCode::MethodNotFound, format!("there is no request `{method}`")),
            Self::Invalid(why) => with(ErrorCode::InvalidParams, why),
            Self::Failed(why) => with(ErrorCode::ServerError(-32803), why),
            Self::Cancelled => Error::request_cancelled(),
            Self::Internal => Error::internal_error(),
        }
    }
}

impl From<Cancelled> for Fault {
    fn from(_: Cancelled) -> Self {
        Self::Outdated
    }
}

/// An answer as it is sent.
///
/// # Errors
/// A mistake of ours.
pub fn sent(answer: impl Serialize) -> Result<Value, Fault> {
    serde_json::to_value(answer).map_err(|_| Fault::Internal)
}

/// Reads parameters.
///
/// # Errors
/// They are not what the question takes.
pub fn params<P: DeserializeOwned>(params: Value) -> Result<P, Fault> {
    P::deserialize(params).map_err(|e| Fault::Invalid(e.to_string()))
}

impl State {
    /// Has a question answered.
    ///
    /// # Errors
    /// Why nobody can.
    pub fn dispatch(&mut self, id: &Id, method: &str, given: Value) -> Result<(), Fault> {
        use features::*;
        match method {
            "textDocument/diagnostic" => self.document(id, given, diagnostic::document),
            "textDocument/hover" => self.document(id, given, navigation::hover),
            "textDocument/definition" => self.document(id, given, navigation::definition),
            "textDocument/declaration" => self.document(id, given, navigation::declaration),
            "textDocument/typeDefinition" => self.document(id, given, navigation::type_definition),
            "textDocument/references" => self.document(id, given, navigation::references),
            "textDocument/documentHighlight" => self.document(id, given, navigation::highlight),
            "textDocument/prepareRename" => self.document(id, given, navigation::prepare_rename),
            "textDocument/rename" => self.document(id, given, navigation::rename),
            "textDocument/documentSymbol" => self.document(id, given, navigation::document_symbols),
            "textDocument/prepareCallHierarchy" => self.document(id, given, navigation::prepare_calls),
            "callHierarchy/incomingCalls" => self.item(id, given, navigation::incoming),
            "callHierarchy/outgoingCalls" => self.item(id, given, navigation::outgoing),
            "textDocument/completion" => self.document(id, given, writing::completion),
            "textDocument/signatureHelp" => self.document(id, given, writing::signature_help),
            "textDocument/formatting" => self.document(id, given, writing::formatting),
            "textDocument/rangeFormatting" => self.document(id, given, writing::range_formatting),
            "textDocument/onTypeFormatting" => self.document(id, given, writing::on_type_formatting),
            "textDocument/linkedEditingRange" => self.document(id, given, writing::linked_editing),
            "textDocument/semanticTokens/full" => self.document(id, given, looks::tokens_full),
            "textDocument/semanticTokens/full/delta" => self.document(id, given, looks::tokens_delta),
            "textDocument/semanticTokens/range" => self.document(id, given, looks::tokens_range),
            "textDocument/foldingRange" => self.document(id, given, looks::folding),
            "textDocument/selectionRange" => self.document(id, given, looks::selection),
            "textDocument/documentLink" => self.links(id, given),
            "textDocument/documentColor" => self.document(id, given, looks::colours),
            "textDocument/colorPresentation" => self.document(id, given, looks::presentations),
            "textDocument/inlayHint" => self.document(id, given, looks::inlay_hints),
            "inlayHint/resolve" => self.resolve_hint(id, given),
            "textDocument/codeLens" => self.document(id, given, looks::lenses),
            "textDocument/codeAction" => self.document(id, given, actions::actions),
            "codeAction/resolve" => self.resolve_action(id, given),
            "workspace/executeCommand" => self.execute(id, given),
            "scenelang/scene" => self.custom(id, given, scene::scene),
            "scenelang/forms" => self.custom(id, given, scene::forms),
            "scenelang/move" => self.move_object(id, given),
            "scenelang/provisional" => self.provisional(id, given),
            "completionItem/resolve" => {
                let item: CompletionItem = params(given)?;
                self.ask_pool(id, move || sent(writing::resolve_completion(item)));
                Ok(())
            }
            "workspace/diagnostic" => {
                self.workspace_diagnostic(id, given);
                Ok(())
            }
            "workspace/willRenameFiles" => {
                let asked: moving::Renames = params(given)?;
                let workspace = moving::Workspace {
                    roots: Arc::clone(&self.roots),
                    files: self.documents.files(),
                    client: Arc::clone(&self.client),
                    config: Arc::clone(&self.config),
                    open: self.documents.iter().map(|d| (d.path.clone(), d.uri.clone())).collect(),
                    versions: self.documents.iter().map(|d| (d.uri.as_str().to_owned(), d.version)).collect(),
                };
                self.ask_pool(id, move || sent(workspace.edits(&asked)));
                Ok(())
            }
            "workspace/symbol" => {
                let query = given["query"].as_str().unwrap_or_default().to_owned();
                let (roots, files, encoding) = (Arc::clone(&self.roots), self.documents.files(), self.client.encoding);
                self.ask_pool(id, move || sent(navigation::workspace_symbols(&roots, &files, encoding, &query)));
                Ok(())
            }
            _ => Err(Fault::Unknown(method.to_owned())),
        }
    }

    /// `textDocument/documentLink`, which is asked of layouts, too.
    fn links(&mut self, id: &Id, given: Value) -> Result<(), Fault> {
        let uri = given["textDocument"]["uri"].as_str().unwrap_or_default();
        let data = self.documents.get(uri).filter(|document| document.scene.is_none());
        let Some((path, text)) = data.map(|d| (d.path.clone(), Arc::clone(&d.text))) else {
            return self.document(id, given, features::looks::links);
        };
        let (encoding, files) = (self.client.encoding, self.documents.files());
        self.ask_pool(id, move || sent(features::looks::layout_links(&path, &text, encoding, &files)));
        Ok(())
    }

    /// `inlayHint/resolve`: what there is to say of it, for who points at it.
    fn resolve_hint(&mut self, id: &Id, hint: Value) -> Result<(), Fault> {
        // Of a value or a size there is nothing more to say.
        if hint["data"].is_null() {
            let hint: InlayHint = params(hint)?;
            self.ask_pool(id, move || sent(hint));
            return Ok(());
        }
        let about: features::looks::About = params(hint["data"].clone())?;
        let hint: InlayHint = params(hint)?;
        let uri = about.uri.as_str().to_owned();
        self.ask_reader(
            id,
            &uri,
            Arc::new(move |context| sent(features::looks::resolved_hint(context, hint.clone(), &about)?)),
        );
        Ok(())
    }

    /// A question that is none of the protocol.
    fn custom<P: DeserializeOwned + Send + Sync + 'static, R: Serialize + 'static>(
        &mut self,
        id: &Id,
        given: Value,
        handler: fn(&Context, &P) -> Result<R, Fault>,
    ) -> Result<(), Fault> {
        let uri = given["uri"].as_str().unwrap_or_default().to_owned();
        let given: P = params(given)?;
        self.ask_reader(id, &uri, Arc::new(move |context| sent(handler(context, &given)?)));
        Ok(())
    }

    /// A question about an item that the client was given before.
    fn item<P: DeserializeOwned + Send + Sync + 'static, R: Serialize + 'static>(
        &mut self,
        id: &Id,
        given: Value,
        handler: fn(&Context, &P) -> Result<R, Fault>,
    ) -> Result<(), Fault> {
        let uri = given["item"]["uri"].as_str().unwrap_or_default().to_owned();
        let given: P = params(given)?;
        self.ask_reader(id, &uri, Arc::new(move |context| sent(handler(context, &given)?)));
        Ok(())
    }

    /// A question about a document.
    fn document<P: DeserializeOwned + Send + Sync + 'static, R: Serialize + 'static>(
        &mut self,
        id: &Id,
        given: Value,
        handler: fn(&Context, &P) -> Result<R, Fault>,
    ) -> Result<(), Fault> {
        let uri = given["textDocument"]["uri"].as_str().unwrap_or_default().to_owned();
        let given: P = params(given)?;
        self.ask_reader(id, &uri, Arc::new(move |context| sent(handler(context, &given)?)));
        Ok(())
    }
}
