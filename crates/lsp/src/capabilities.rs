//! What the server says that it can. Nothing stands here that does nothing.

use crate::client::Client;
use crate::commands;
use scenelang_ide::tokens;
use serde_json::{Value, json};

/// The answer to `initialize`.
pub fn of(client: &Client) -> Value {
    let mut capabilities = json!({
        "positionEncoding": client.encoding.name(),
        "textDocumentSync": { "openClose": true, "change": 2, "save": { "includeText": false } },
        "hoverProvider": true,
        "definitionProvider": true,
        "declarationProvider": true,
        "typeDefinitionProvider": true,
        "referencesProvider": true,
        "documentHighlightProvider": true,
        "renameProvider": { "prepareProvider": true },
        "documentSymbolProvider": true,
        "workspaceSymbolProvider": true,
        "callHierarchyProvider": true,
        "completionProvider": { "triggerCharacters": [".", "\"", "(", ",", "@"], "resolveProvider": true },
        "signatureHelpProvider": { "triggerCharacters": ["(", ","], "retriggerCharacters": [")"] },
        "documentFormattingProvider": true,
        "documentRangeFormattingProvider": true,
        "documentOnTypeFormattingProvider": { "firstTriggerCharacter": ";" },
        "linkedEditingRangeProvider": true,
        "semanticTokensProvider": {
            "legend": { "tokenTypes": tokens::TYPES, "tokenModifiers": tokens::MODIFIERS },
            "full": { "delta": true },
            "range": true,
        },
        "foldingRangeProvider": true,
        "selectionRangeProvider": true,
        "documentLinkProvider": { "resolveProvider": false },
        "colorProvider": true,
        "inlayHintProvider": { "resolveProvider": true },
        "codeLensProvider": { "resolveProvider": false },
        "codeActionProvider": {
            "codeActionKinds": [
                "quickfix", "refactor.extract", "refactor.inline", "refactor.rewrite", "source.fixAll.scenelang",
            ],
            "resolveProvider": true,
        },
        "executeCommandProvider": { "commands": commands::ALL, "workDoneProgress": true },
        "workspace": { "workspaceFolders": { "supported": true, "changeNotifications": true } },
    });
    if client.asks_of_renames {
        let file = |glob: &str| json!({ "scheme": "file", "pattern": { "glob": glob, "matches": "file" } });
        let folders = json!({ "scheme": "file", "pattern": { "glob": "**", "matches": "folder" } });
        let filters = json!([file("**/*.scene"), file("**/*.layout.json"), folders]);
        capabilities["workspace"]["fileOperations"] = json!({ "willRename": { "filters": filters } });
    }
    if client.pulls {
        capabilities["diagnosticProvider"] =
            json!({ "identifier": "scenelang", "interFileDependencies": true, "workspaceDiagnostics": true });
    }
    json!({
        "capabilities": capabilities,
        "serverInfo": { "name": "scenelang", "version": env!("CARGO_PKG_VERSION") },
    })
}
