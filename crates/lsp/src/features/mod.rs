//! Handlers: from parameters to what `ide` is asked, and from its answers to results. One file for what belongs together.

pub mod across;
pub mod actions;
pub mod diagnostic;
pub mod looks;
pub mod moving;
pub mod navigation;
pub mod scene;
pub mod writing;

use serde::Deserialize;
use tower_lsp::ls_types::{Position, Range, TextDocumentIdentifier};

/// A question about a document.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Whole {
    #[allow(dead_code, reason = "that it is there, and an address, is what matters")]
    text_document: TextDocumentIdentifier,
}

/// A question about a place in a document.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct At {
    #[allow(dead_code, reason = "that it is there, and an address, is what matters")]
    text_document: TextDocumentIdentifier,
    /// Where.
    pub position: Position,
}

/// A question about a part of a document.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Within {
    #[allow(dead_code, reason = "that it is there, and an address, is what matters")]
    text_document: TextDocumentIdentifier,
    /// From where to where.
    pub range: Range,
}
