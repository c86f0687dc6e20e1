//! What the client can, as it said in `initialize`.

use crate::text::Encoding;
use serde_json::Value;

/// The command of an editor that shows the room beside the program.
pub const SHOW: &str = "scenelang.show";

/// Which language model may be asked. No file of a workspace says so.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Models {
    #[default]
    None,
    /// The editor's own.
    Client,
    /// The one that the settings name.
    Configured,
}

/// The model that `configured` means, as the user of the editor has set it: what `--model` and `--base-url` say on the
/// command line. Empty: what the settings of the workspace name.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Named {
    /// `PROVIDER:NAME`.
    pub name: Option<String>,
    /// Where it is.
    pub base_url: Option<String>,
}

impl Named {
    fn read(value: &Value) -> Self {
        let text = |key: &str| value[key].as_str().map(str::trim).filter(|text| !text.is_empty()).map(str::to_owned);
        Self { name: text("name"), base_url: text("baseUrl") }
    }
}

/// Capabilities that we ask about.
#[derive(Clone, Debug)]
pub struct Client {
    /// How positions count.
    pub encoding: Encoding,
    /// Asks for diagnostics itself, and asks again when told to.
    pub pulls: bool,
    /// Diagnostics may speak of further places.
    pub related: bool,
    /// Versions of documents stand in edits.
    pub document_changes: bool,
    /// Files can be renamed by an edit.
    pub renames: bool,
    /// Asks before files are renamed.
    pub asks_of_renames: bool,
    /// Hints may be completed when somebody points at them.
    pub resolves_hints: bool,
    /// Edits may be applied at our request.
    pub applies: bool,
    /// Shows how far long work is.
    pub progress: bool,
    /// Has settings for us.
    pub configuration: bool,
    /// Says when settings change, if asked to.
    pub watches_configuration: bool,
    /// Says when files change, if asked to.
    pub watches_files: bool,
    /// Code actions may be completed when they are chosen.
    pub resolves_edits: bool,
    /// Completions may be snippets.
    pub snippets: bool,
    /// Symbols may contain each other.
    pub nested_symbols: bool,
    /// Definitions may say where they were asked from.
    pub links: bool,
    /// Hints, lenses, tokens and diagnostics can be asked for again: the requests that say so.
    pub refreshes: Vec<&'static str>,
    /// Which language model the user of the editor wants asked.
    pub model: Models,
    /// Which one is configured, where the editor says so.
    pub named: Named,
    /// Edits may come with words about them.
    pub annotates: bool,
    /// Has a command of its own that shows the room: it names it in `initializationOptions.commands`.
    pub shows: bool,
    /// Draws pictures that are data in a text; others would show the data.
    pub pictures: bool,
}

impl Client {
    /// Reads the parameters of `initialize`.
    pub fn new(params: &Value) -> Self {
        let at = |path: &str| params["capabilities"].pointer(path).cloned().unwrap_or_default();
        let on = |path: &str| at(path).as_bool() == Some(true);
        let offered = at("/general/positionEncodings");
        let offers = |encoding: Encoding| {
            offered.as_array().is_some_and(|list| list.iter().any(|name| name.as_str() == Some(encoding.name())))
        };
        let encoding = [Encoding::Utf8, Encoding::Utf16, Encoding::Utf32].into_iter().find(|e| offers(*e));
        let refresh = [
            ("/workspace/diagnostics/refreshSupport", "workspace/diagnostic/refresh"),
            ("/workspace/inlayHint/refreshSupport", "workspace/inlayHint/refresh"),
            ("/workspace/codeLens/refreshSupport", "workspace/codeLens/refresh"),
        ];
        let refreshes: Vec<&'static str> = refresh.iter().filter(|(path, _)| on(path)).map(|(_, name)| *name).collect();
        let operations = at("/workspace/workspaceEdit/resourceOperations");
        let tips = at("/textDocument/inlayHint/resolveSupport/properties");
        let resolves = at("/textDocument/codeAction/resolveSupport/properties");
        let has =
            |list: &Value, word: &str| list.as_array().is_some_and(|l| l.iter().any(|w| w.as_str() == Some(word)));
        Self {
            encoding: encoding.unwrap_or(Encoding::Utf16),
            pulls: at("/textDocument/diagnostic").is_object() && refreshes.contains(&"workspace/diagnostic/refresh"),
            related: on("/textDocument/publishDiagnostics/relatedInformation"),
            document_changes: on("/workspace/workspaceEdit/documentChanges"),
            renames: has(&operations, "rename"),
            asks_of_renames: on("/workspace/fileOperations/willRename"),
            resolves_hints: has(&tips, "tooltip"),
            applies: on("/workspace/applyEdit"),
            progress: on("/window/workDoneProgress"),
            configuration: on("/workspace/configuration"),
            watches_configuration: on("/workspace/didChangeConfiguration/dynamicRegistration"),
            watches_files: on("/workspace/didChangeWatchedFiles/dynamicRegistration"),
            resolves_edits: has(&resolves, "edit"),
            snippets: on("/textDocument/completion/completionItem/snippetSupport"),
            nested_symbols: on("/textDocument/documentSymbol/hierarchicalDocumentSymbolSupport"),
            links: on("/textDocument/definition/linkSupport"),
            refreshes,
            model: match params["initializationOptions"]["languageModel"].as_str() {
                Some("client") => Models::Client,
                Some("configured") => Models::Configured,
                // Nobody is asked whom the user did not want asked, in so many words.
                _ => Models::None,
            },
            named: Named::read(&params["initializationOptions"]["model"]),
            annotates: at("/workspace/workspaceEdit/changeAnnotationSupport").is_object(),
            pictures: params["initializationOptions"]["pictures"] == true,
            shows: has(&params["initializationOptions"]["commands"], SHOW),
        }
    }
}
