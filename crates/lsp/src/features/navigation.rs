//! Hovering, and going from names to where they come from and where they are used.

use super::{At, Whole, across};
use crate::change::WorkspaceChange;
use crate::disk;
use crate::dispatch::{Context, Fault};
use crate::pages;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use scenelang_base::TextRange;
use scenelang_export::thumbnail;
use scenelang_ide::calls::{self, CallNode, Item};
use scenelang_ide::names::{Role, name_at};
use scenelang_ide::navigate::{self, NavigationTarget};
use scenelang_ide::{Cancelled, Snapshot, hover as hovering, rename as renaming, symbols};
use serde::Deserialize;
use std::fmt::Write;
use std::path::PathBuf;
use tower_lsp::ls_types::{
    CallHierarchyIncomingCall, CallHierarchyItem, CallHierarchyOutgoingCall, DocumentHighlight, DocumentHighlightKind,
    DocumentSymbol, DocumentSymbolResponse, GotoDefinitionResponse, Hover, HoverContents, Location, LocationLink,
    MarkupContent, MarkupKind, OneOf, Position, PrepareRenameResponse, Range, SymbolInformation, SymbolKind,
    TextDocumentIdentifier, WorkspaceSymbol,
};

/// `textDocument/hover`
pub fn hover(context: &Context, at: &At) -> Result<Option<Hover>, Fault> {
    let offset = context.offset(at.position);
    let Some((range, mut value)) = hovering::hover(&context.snapshot, offset)? else { return Ok(None) };
    if context.client.pictures
        && let Some(category) = hovering::category_at(&context.snapshot, offset)
        && let Some(png) = thumbnail::of_category(&category, PICTURE)
    {
        let _ = write!(value, "\n\n![{category}](data:image/png;base64,{})", STANDARD.encode(png));
    }
    let contents = HoverContents::Markup(MarkupContent { kind: MarkupKind::Markdown, value });
    Ok(Some(Hover { contents, range: Some(context.range(range)) }))
}

/// How large the picture of a category is (pixels).
const PICTURE: [usize; 2] = [176, 132];

type Find = fn(&Snapshot, u32) -> Result<Option<(TextRange, NavigationTarget)>, Cancelled>;

/// `textDocument/definition`
pub fn definition(context: &Context, at: &At) -> Result<Option<GotoDefinitionResponse>, Fault> {
    go(context, at, navigate::definition)
}

/// `textDocument/declaration`
pub fn declaration(context: &Context, at: &At) -> Result<Option<GotoDefinitionResponse>, Fault> {
    go(context, at, navigate::declaration)
}

/// `textDocument/typeDefinition`
pub fn type_definition(context: &Context, at: &At) -> Result<Option<GotoDefinitionResponse>, Fault> {
    go(context, at, navigate::type_definition)
}

fn go(context: &Context, at: &At, find: Find) -> Result<Option<GotoDefinitionResponse>, Fault> {
    let Some((origin, target)) = find(&context.snapshot, context.offset(at.position))? else { return Ok(None) };
    let places = context.places();
    let (uri, whole, name) = match target {
        NavigationTarget::File(span, whole) => {
            let Some(uri) = places.uri(span.file) else { return Ok(None) };
            (uri, places.range(whole.in_file(span.file)), places.range(span))
        }
        NavigationTarget::Library(file, name, whole) => {
            let (path, text) = pages::library_file(file)?;
            let Some(uri) = disk::uri_of(&path) else { return Ok(None) };
            let text = crate::text::Text::new(text.to_owned());
            let encoding = context.client.encoding;
            (uri, text.range(whole, encoding), text.range(name, encoding))
        }
    };
    Ok(Some(if context.client.links {
        GotoDefinitionResponse::Link(vec![LocationLink {
            origin_selection_range: Some(context.range(origin)),
            target_uri: uri,
            target_range: cover(whole, name),
            target_selection_range: name,
        }])
    } else {
        GotoDefinitionResponse::Scalar(Location { uri, range: name })
    }))
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
pub fn references(context: &Context, params: &References) -> Result<Option<Vec<Location>>, Fault> {
    let snapshot = &context.snapshot;
    let Some(name) = name_at(snapshot, context.file(), context.offset(params.at.position))? else {
        return Ok(None);
    };
    let places = context.places();
    let declaration = params.context.include_declaration;
    let found = navigate::references(snapshot, context.file(), &name.symbol, declaration)?;
    let mut found: Vec<Location> = found.into_iter().filter_map(|(span, _)| places.location(span)).collect();
    across::references(context, params.at.position, declaration, &mut found)?;
    Ok(Some(found))
}

/// `textDocument/documentHighlight`
pub fn highlight(context: &Context, at: &At) -> Result<Vec<DocumentHighlight>, Fault> {
    let found = navigate::highlights(&context.snapshot, context.offset(at.position))?;
    let kind = |role: Role| match role {
        Role::Reads => DocumentHighlightKind::READ,
        Role::Declares | Role::Writes => DocumentHighlightKind::WRITE,
    };
    let shown = |(range, role)| DocumentHighlight { range: context.range(range), kind: Some(kind(role)) };
    Ok(found.into_iter().map(shown).collect())
}

/// `textDocument/prepareRename`
pub fn prepare_rename(context: &Context, at: &At) -> Result<Option<PrepareRenameResponse>, Fault> {
    let Some(range) = renaming::renamable(&context.snapshot, context.offset(at.position))? else {
        return Ok(None);
    };
    let name = context.snapshot.slice(range.in_file(context.file()));
    Ok(Some(PrepareRenameResponse::RangeWithPlaceholder { range: context.range(range), placeholder: name.to_owned() }))
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
pub fn rename(context: &Context, params: &Rename) -> Result<WorkspaceChange, Fault> {
    let edits = renaming::rename(&context.snapshot, context.offset(params.at.position), &params.new_name)?;
    across::rename(context, params.at.position, &params.new_name, &edits.map_err(Fault::Failed)?)
}

// ── Symbols ──

/// What the protocol has for what a symbol is.
fn symbol_kind(sort: symbols::Sort) -> SymbolKind {
    match sort {
        symbols::Sort::Object => SymbolKind::OBJECT,
        symbols::Sort::Array => SymbolKind::ARRAY,
        symbols::Sort::Region => SymbolKind::NAMESPACE,
        symbols::Sort::Variable => SymbolKind::VARIABLE,
        symbols::Sort::Predicate => SymbolKind::FUNCTION,
        symbols::Sort::Constraint => SymbolKind::EVENT,
    }
}

/// `textDocument/documentSymbol`
#[expect(deprecated, reason = "a field that is not set has to be named all the same")]
pub fn document_symbols(context: &Context, _: &Whole) -> Result<DocumentSymbolResponse, Fault> {
    let entries = symbols::outline(&context.snapshot, context.file())?.into_iter();
    let nested = |e: symbols::Entry| DocumentSymbol {
        name: e.name,
        detail: Some(e.detail),
        kind: symbol_kind(e.sort),
        tags: None,
        deprecated: None,
        range: context.range(e.range),
        selection_range: context.range(e.name_range),
        children: None,
    };
    let flat = |e: symbols::Entry| SymbolInformation {
        name: e.name,
        kind: symbol_kind(e.sort),
        tags: None,
        deprecated: None,
        location: Location { uri: context.uri.clone(), range: context.range(e.name_range) },
        container_name: None,
    };
    Ok(if context.client.nested_symbols {
        DocumentSymbolResponse::Nested(entries.map(nested).collect())
    } else {
        DocumentSymbolResponse::Flat(entries.map(flat).collect())
    })
}

// ── Who speaks of whom ──

/// `textDocument/prepareCallHierarchy`
pub fn prepare_calls(context: &Context, at: &At) -> Result<Option<Vec<CallHierarchyItem>>, Fault> {
    let item = calls::item_at(&context.snapshot, context.offset(at.position))?;
    Ok(item.map(|item| vec![shown(context, &item)]))
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
pub fn incoming(context: &Context, params: &HierarchyRequest) -> Result<Option<Vec<CallHierarchyIncomingCall>>, Fault> {
    let Some(node) = node(context, params)? else { return Ok(None) };
    let found = calls::incoming(&context.snapshot, &node)?;
    let call = |(item, places): &(Item, Vec<TextRange>)| CallHierarchyIncomingCall {
        from: shown(context, item),
        from_ranges: ranges(context, places),
    };
    Ok(Some(found.iter().map(call).collect()))
}

/// `callHierarchy/outgoingCalls`
pub fn outgoing(context: &Context, params: &HierarchyRequest) -> Result<Option<Vec<CallHierarchyOutgoingCall>>, Fault> {
    let Some(node) = node(context, params)? else { return Ok(None) };
    let found = calls::outgoing(&context.snapshot, &node)?;
    let call = |(item, places): &(Item, Vec<TextRange>)| CallHierarchyOutgoingCall {
        to: shown(context, item),
        from_ranges: ranges(context, places),
    };
    Ok(Some(found.iter().map(call).collect()))
}

fn ranges(context: &Context, places: &[TextRange]) -> Vec<Range> {
    places.iter().map(|place| context.range(*place)).collect()
}

/// The item of a question: what stands where it was shown.
fn node(context: &Context, params: &HierarchyRequest) -> Result<Option<CallNode>, Fault> {
    let range = context.bytes(params.item.selection_range);
    let item = calls::item_at(&context.snapshot, range.start)?;
    Ok(item.filter(|item| item.name_range == range).map(|item| item.node))
}

fn shown(context: &Context, item: &Item) -> CallHierarchyItem {
    let (kind, detail) = match &item.node {
        CallNode::Name(_) => (SymbolKind::OBJECT, ""),
        CallNode::Constraint(_) => (SymbolKind::EVENT, "constraint"),
        CallNode::Requirement(_) => (SymbolKind::STRING, "requirement"),
    };
    CallHierarchyItem {
        name: item.name.to_string(),
        kind,
        tags: None,
        detail: Some(detail.to_owned()),
        uri: context.uri.clone(),
        range: context.range(item.range),
        selection_range: context.range(item.name_range),
        data: None,
    }
}

// ── The workspace ──

/// Programs of the workspace with names that match a query, the first so many.
pub fn workspace_symbols(
    roots: &[PathBuf],
    files: &disk::Files,
    encoding: crate::text::Encoding,
    query: &str,
) -> Vec<WorkspaceSymbol> {
    use scenelang_lang::sources::Loader;
    const MOST: usize = 500;
    let mut out = Vec::new();
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
                return out;
            }
            let location = Location { uri: uri.clone(), range: text.range(entry.name_range, encoding) };
            out.push(WorkspaceSymbol {
                name: entry.name,
                kind: symbol_kind(entry.sort),
                tags: None,
                container_name: Some(file.clone()),
                location: OneOf::Left(location),
                data: None,
            });
        }
    }
    out
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
