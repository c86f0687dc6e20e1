//! Help while writing: completion, signatures, formatting, names that change together.

use super::{At, Whole, Within};
use crate::dispatch::{Context, Fault};
use crate::imports::imports;
use scenelang_assets::color_of;
use scenelang_base::TextRange;
use scenelang_ide::completion::{Proposal, Sort, complete, describe};
use scenelang_ide::format::{self, Replacement};
use scenelang_ide::{shape, signature};
use serde::Deserialize;
use serde_json::{Value, json};

/// Parameters of `textDocument/completion`.
#[derive(Deserialize)]
pub struct Completion {
    #[serde(flatten)]
    at: At,
    context: Option<Trigger>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Trigger {
    trigger_kind: Option<u32>,
}

/// `textDocument/completion`
pub fn completion(context: &Context, params: &Completion) -> Result<Value, Fault> {
    const INVOKED: u32 = 1;
    let offset = context.offset(params.at.position);
    // An editor also says so for what a letter brought up; then there are letters.
    let asked = params.context.as_ref().is_none_or(|c| c.trigger_kind.is_none_or(|kind| kind == INVOKED));
    let found = complete(&context.snapshot, &|| imports(&context.path), offset, asked)?;
    let replaces = found.replaces;
    let line = context.text.line(context.text.line_of(offset));
    let rest = context.text.as_str().get(replaces.end.min(line.end) as usize..line.end as usize).unwrap_or_default();
    let items = found.list.into_iter().map(|p| item(context, p, replaces, rest));
    Ok(json!({ "isIncomplete": false, "items": items.collect::<Vec<_>>() }))
}

fn item(context: &Context, proposal: Proposal, replaces: TextRange, rest: &str) -> Value {
    let Proposal { label, sort, detail, snippet, rank, about } = proposal;
    // Where the rest is there already, only the word is missing.
    let there = match sort {
        Sort::Function | Sort::Predicate => rest.trim_start().starts_with('('),
        Sort::File => false,
        _ => !rest.trim().is_empty(),
    };
    let snippet = snippet.filter(|s| !there && (context.client.snippets || !s.contains('$')));
    let format = if snippet.as_ref().is_some_and(|s| s.contains('$')) { 2 } else { 1 };
    let mut out = json!({
        "label": label,
        "kind": match sort {
            Sort::Keyword => 14,
            Sort::Object => 7,
            Sort::Region => 9,
            Sort::Variable => 6,
            Sort::Property => 10,
            Sort::Function | Sort::Predicate => 3,
            Sort::Type => 25,
            Sort::Constant => 21,
            Sort::Unit => 11,
            Sort::Color => 16,
            Sort::Text => 12,
            Sort::File => 17,
        },
        "sortText": format!("{rank}{label}"),
        "insertTextFormat": format,
        "textEdit": { "range": context.range(replaces), "newText": snippet.unwrap_or_else(|| label.clone()) },
    });
    if !detail.is_empty() {
        out["detail"] = detail.into();
    }
    if sort == Sort::Color
        && let Some([r, g, b]) = color_of(&label)
    {
        // Editors show a swatch for this.
        out["documentation"] = format!("#{r:02x}{g:02x}{b:02x}").into();
    }
    if let Some(about) = about {
        out["data"] = about.into();
    }
    out
}

/// `completionItem/resolve`
pub fn resolve_completion(mut item: Value) -> Value {
    if let Some(text) = item["data"].as_str().and_then(describe) {
        item["documentation"] = json!({ "kind": "markdown", "value": text });
    }
    item
}

/// `textDocument/signatureHelp`
pub fn signature_help(context: &Context, at: &At) -> Result<Value, Fault> {
    let Some(help) = signature::help(&context.snapshot, context.offset(at.position))? else { return Ok(Value::Null) };
    let signatures = help.signatures.into_iter().map(|s| {
        let params: Vec<Value> = s.params.iter().map(|p| json!({ "label": p })).collect();
        json!({
            "label": s.label, "parameters": params,
            "documentation": { "kind": "markdown", "value": s.doc },
        })
    });
    Ok(json!({
        "signatures": signatures.collect::<Vec<_>>(),
        "activeSignature": help.active, "activeParameter": help.argument,
    }))
}

fn edits(context: &Context, replacement: Option<Replacement>) -> Value {
    replacement.into_iter().map(|(range, text)| json!({ "range": context.range(range), "newText": text })).collect()
}

/// `textDocument/formatting`
pub fn formatting(context: &Context, _: &Whole) -> Result<Value, Fault> {
    Ok(edits(context, format::file(context.text.as_str())))
}

/// `textDocument/rangeFormatting`
pub fn range_formatting(context: &Context, within: &Within) -> Result<Value, Fault> {
    Ok(edits(context, format::range(context.text.as_str(), context.bytes(within.range))))
}

/// `textDocument/onTypeFormatting`
pub fn on_type_formatting(context: &Context, at: &At) -> Result<Value, Fault> {
    Ok(edits(context, format::ended(context.text.as_str(), context.offset(at.position))))
}

/// `textDocument/linkedEditingRange`
pub fn linked_editing(context: &Context, at: &At) -> Result<Value, Fault> {
    let found = shape::linked(&context.snapshot, context.offset(at.position))?;
    if found.len() < 2 {
        return Ok(Value::Null);
    }
    let ranges: Vec<_> = found.into_iter().map(|range| context.range(range)).collect();
    Ok(json!({ "ranges": ranges }))
}
