//! Diagnostics for clients that ask for them.

use crate::dispatch::{Context, Fault};
use crate::publish::verdict;
use serde_json::{Value, json};
use tower_lsp::ls_types::DocumentDiagnosticParams;

/// `textDocument/diagnostic`
pub fn document(context: &Context, params: &DocumentDiagnosticParams) -> Result<Value, Fault> {
    let id = context.generation.to_string();
    if params.previous_result_id.as_deref() == Some(&id) {
        return Ok(json!({ "kind": "unchanged", "resultId": id }));
    }
    let mut marks = verdict(context)?.marks;
    let own = marks.remove(context.uri.as_str()).unwrap_or_default();
    Ok(json!({ "kind": "full", "resultId": id, "items": own }))
}
