//! Hovering, and going from names to where they come from and where they are used.

use super::{At, Whole, across};
use crate::disk;
use crate::dispatch::{Context, Fault};
use crate::pages;
use scenelang_base::TextRange;
use scenelang_ide::calls::{self, CallNode, Item};
use scenelang_ide::names::{Role, name_at};
use scenelang_ide::navigate::{self, NavigationTarget};
use scenelang_ide::{Cancelled, Snapshot, hover as hovering, rename as renaming, symbols};
use serde::Deserialize;
use serde_json::{Value, json};
use std::path::PathBuf;
use tower_lsp::ls_types::{Location, Position, Range, TextDocumentIdentifier};

/// `textDocument/hover`
pub fn hover(context: &Context, at: &At) -> Result<Value, Fault> {
    let found = hovering::hover(&context.snapshot, context.offset(at.position))?;
    Ok(found.map_or(
        Value::Null,
        |(range, text)| json!({ "contents": { "kind": "markdown", "value": text }, "range": context.range(range) }),
    ))
}

type Find = fn(&Snapshot, u32) -> Result<Option<(TextRange, NavigationTarget)>, Cancelled>;

/// `textDocument/definition`
pub fn definition(context: &Context, at: &At) -> Result<Value, Fault> {
    go(context, at, navigate::definition)
}

/// `textDocument/declaration`
pub fn declaration(context: &Context, at: &At) -> Result<Value, Fault> {
    go(context, at, navigate::declaration)
}

/// `textDocument/typeDefinition`
pub fn type_definition(context: &Context, at: &At) -> Result<Value, Fault> {
    go(context, at, navigate::type_definition)
}

fn go(context: &Context, at: &At, find: Find) -> Result<Value, Fault> {
    let Some((origin, target)) = find(&context.snapshot, context.offset(at.position))? else { return Ok(Value::Null) };
    let places = context.places();
    let (uri, whole, name) = match target {
        NavigationTarget::File(span, whole) => {
            let Some(uri) = places.uri(span.file) else { return Ok(Value::Null) };
            (uri, places.range(whole.in_file(span.file)), places.range(span))
        }
        NavigationTarget::Library(file, name, whole) => {
            let (path, text) = pages::library_file(file)?;
            let Some(uri) = disk::uri_of(&path) else { return Ok(Value::Null) };
            let text = crate::text::Text::new(text.to_owned());
            let encoding = context.client.encoding;
            (uri, text.range(whole, encoding), text.range(name, encoding))
        }
    };
    Ok(if context.client.links {
        json!([{
            "originSelectionRange": context.range(origin),
            "targetUri": uri, "targetRange": cover(whole, name), "targetSelectionRange": name,
        }])
    } else {
        json!({ "uri": uri, "range": name })
    })
}

/// The smallest range that holds both.
fn cover(a: Range, b: Range) -> Range {
    Range { start: a.start.min(b.start), end: a.end.max(b.end) }
}

/// Parameters of `textDocument/references`.
#[derive(Deserialize)]
pub struct References {
    #[serde(flatten)]
    at: At,
    context: ReferenceContext,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct ReferenceContext {
    include_declaration: bool,
}

/// `textDocument/references`
pub fn references(context: &Context, params: &References) -> Result<Value, Fault> {
    let snapshot = &context.snapshot;
    let Some(name) = name_at(snapshot, context.file(), context.offset(params.at.position))? else {
        return Ok(Value::Null);
    };
    let places = context.places();
    let declaration = params.context.include_declaration;
    let found = navigate::references(snapshot, context.file(), &name.symbol, declaration)?;
    let mut found: Vec<Location> = found.into_iter().filter_map(|(span, _)| places.location(span)).collect();
    across::references(context, params.at.position, declaration, &mut found)?;
    Ok(json!(found))
}

/// `textDocument/documentHighlight`
pub fn highlight(context: &Context, at: &At) -> Result<Value, Fault> {
    let found = navigate::highlights(&context.snapshot, context.offset(at.position))?;
    let kind = |role: Role| if role == Role::Reads { 2 } else { 3 };
    Ok(found.into_iter().map(|(range, role)| json!({ "range": context.range(range), "kind": kind(role) })).collect())
}

/// `textDocument/prepareRename`
pub fn prepare_rename(context: &Context, at: &At) -> Result<Value, Fault> {
    let Some(range) = renaming::renamable(&context.snapshot, context.offset(at.position))? else {
        return Ok(Value::Null);
    };
    let name = context.snapshot.slice(range.in_file(context.file()));
    Ok(json!({ "range": context.range(range), "placeholder": name }))
}

/// Parameters of `textDocument/rename`.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Rename {
    #[serde(flatten)]
    at: At,
    new_name: String,
}

/// `textDocument/rename`
pub fn rename(context: &Context, params: &Rename) -> Result<Value, Fault> {
    let edits = renaming::rename(&context.snapshot, context.offset(params.at.position), &params.new_name)?;
    across::rename(context, params.at.position, &params.new_name, &edits.map_err(Fault::Failed)?)
}

// ── Symbols ──

/// The number of the protocol for what a symbol is.
pub fn symbol_kind(sort: symbols::Sort) -> u32 {
    match sort {
        symbols::Sort::Object => 19,
        symbols::Sort::Array => 18,
        symbols::Sort::Region => 3,
        symbols::Sort::Variable => 13,
        symbols::Sort::Predicate => 12,
        symbols::Sort::Constraint => 24,
    }
}

/// `textDocument/documentSymbol`
pub fn document_symbols(context: &Context, _: &Whole) -> Result<Value, Fault> {
    let entries = symbols::outline(&context.snapshot, context.file())?;
    let shown = |e: symbols::Entry| {
        let (range, own) = (context.range(e.range), context.range(e.name_range));
        if context.client.nested_symbols {
            json!({
                "name": e.name, "detail": e.detail, "kind": symbol_kind(e.sort),
                "range": range, "selectionRange": own,
            })
        } else {
            json!({ "name": e.name, "kind": symbol_kind(e.sort), "location": { "uri": context.uri, "range": own } })
        }
    };
    Ok(entries.into_iter().map(shown).collect())
}

// ── Who speaks of whom ──

/// `textDocument/prepareCallHierarchy`
pub fn prepare_calls(context: &Context, at: &At) -> Result<Value, Fault> {
    let item = calls::item_at(&context.snapshot, context.offset(at.position))?;
    Ok(item.map_or(Value::Null, |item| json!([shown(context, &item)])))
}

/// Parameters of the two questions about an item: what they were given before.
#[derive(Deserialize)]
pub struct HierarchyRequest {
    item: AskedItem,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct AskedItem {
    selection_range: Range,
}

/// `callHierarchy/incomingCalls`
pub fn incoming(context: &Context, params: &HierarchyRequest) -> Result<Value, Fault> {
    let Some(node) = node(context, params)? else { return Ok(Value::Null) };
    let found = calls::incoming(&context.snapshot, &node)?;
    Ok(found.iter().map(|(item, places)| relation(context, "from", item, places)).collect())
}

/// `callHierarchy/outgoingCalls`
pub fn outgoing(context: &Context, params: &HierarchyRequest) -> Result<Value, Fault> {
    let Some(node) = node(context, params)? else { return Ok(Value::Null) };
    let found = calls::outgoing(&context.snapshot, &node)?;
    Ok(found.iter().map(|(item, places)| relation(context, "to", item, places)).collect())
}

fn relation(context: &Context, key: &str, item: &Item, places: &[TextRange]) -> Value {
    let places: Vec<Range> = places.iter().map(|r| context.range(*r)).collect();
    json!({ key: shown(context, item), "fromRanges": places })
}

/// The item of a question: what stands where it was shown.
fn node(context: &Context, params: &HierarchyRequest) -> Result<Option<CallNode>, Fault> {
    let range = context.bytes(params.item.selection_range);
    let item = calls::item_at(&context.snapshot, range.start)?;
    Ok(item.filter(|item| item.name_range == range).map(|item| item.node))
}

fn shown(context: &Context, item: &Item) -> Value {
    let (kind, detail) = match &item.node {
        CallNode::Name(_) => (19, ""),
        CallNode::Constraint(_) => (24, "constraint"),
        CallNode::Requirement(_) => (15, "requirement"),
    };
    json!({
        "name": item.name, "kind": kind, "detail": detail, "uri": context.uri,
        "range": context.range(item.range), "selectionRange": context.range(item.name_range),
    })
}

// ── The workspace ──

/// Programs of the workspace with names that match a query, the first so many.
pub fn workspace_symbols(
    roots: &[PathBuf],
    files: &disk::Files,
    encoding: crate::text::Encoding,
    query: &str,
) -> Value {
    use scenelang_lang::sources::Loader;
    const MOST: usize = 500;
    let mut out: Vec<Value> = Vec::new();
    let mut paths: Vec<PathBuf> = roots.iter().flat_map(|root| disk::programs(root)).collect();
    paths.extend(files.texts.keys().filter(|path| path.extension().is_some_and(|e| e == "scene")).cloned());
    paths.sort_unstable();
    paths.dedup();
    for path in paths {
        let (Ok(bytes), Some(uri)) = (files.of(&path).load(&path), disk::uri_of(&path)) else { continue };
        let text = crate::text::Text::new(String::from_utf8_lossy(&bytes).into_owned());
        let file = crate::documents::name_of(&path);
        for entry in symbols::declarations(text.as_str()).into_iter().filter(|e| symbols::matches(query, &e.name)) {
            if out.len() == MOST {
                return out.into();
            }
            out.push(json!({
                "name": entry.name, "kind": symbol_kind(entry.sort), "containerName": file,
                "location": { "uri": uri, "range": text.range(entry.name_range, encoding) },
            }));
        }
    }
    out.into()
}

/// A document by its identifier, where the question has one elsewhere than usual.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Positions {
    #[allow(dead_code, reason = "that it is there, and an address, is what matters")]
    text_document: TextDocumentIdentifier,
    /// Where.
    pub positions: Vec<Position>,
}
