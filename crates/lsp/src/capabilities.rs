//! What the server says that it can. Nothing stands here that does nothing.

use crate::client::Client;
use serde_json::{Value, json};

/// The answer to `initialize`.
pub fn of(client: &Client) -> Value {
    let mut capabilities = json!({
        "positionEncoding": client.encoding.name(),
        "textDocumentSync": { "openClose": true, "change": 2, "save": { "includeText": false } },
        "workspace": { "workspaceFolders": { "supported": true, "changeNotifications": true } },
    });
    if client.pulls {
        capabilities["diagnosticProvider"] =
            json!({ "identifier": "scenelang", "interFileDependencies": true, "workspaceDiagnostics": false });
    }
    json!({
        "capabilities": capabilities,
        "serverInfo": { "name": "scenelang", "version": env!("CARGO_PKG_VERSION") },
    })
}
