//! What the client is told and asked for that the types of the protocol's library do not have, or only with copies.

use crate::dispatch::sent;
use serde::Serialize;
use tower_lsp::ls_types::{ConfigurationItem, Diagnostic, Registration, Uri};

/// Parameters of `scenelang/changed`: what is open was judged again.
#[derive(Serialize)]
pub struct Changed {
    pub uri: Uri,
    /// How many constraints hold, of how many; both are 0 where there is no layout.
    pub holds: usize,
    pub total: usize,
    /// The address of the layout that was judged; null: there is none.
    pub layout: Option<Uri>,
}

/// Parameters of `textDocument/publishDiagnostics`.
#[derive(Serialize)]
pub struct Published<'a> {
    pub uri: &'a str,
    pub diagnostics: Vec<Diagnostic>,
    /// `None`: the document is not open.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub version: Option<i32>,
}

/// The settings that are the server's.
pub fn section() -> ConfigurationItem {
    ConfigurationItem { scope_uri: None, section: Some("scenelang".to_owned()) }
}

pub fn registration(id: &str, method: &str, options: impl Serialize) -> Registration {
    Registration { id: id.to_owned(), method: method.to_owned(), register_options: sent(options).ok() }
}
