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
use tower_lsp::ls_types::{
    CompletionItem, CompletionItemKind, CompletionList, CompletionTextEdit, Documentation, InsertTextFormat,
    LinkedEditingRanges, MarkupContent, MarkupKind, ParameterInformation, ParameterLabel, SignatureHelp,
    SignatureInformation, TextEdit,
};

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
pub fn completion(context: &Context, params: &Completion) -> Result<CompletionList, Fault> {
    const INVOKED: u32 = 1;
    let offset = context.offset(params.at.position);
    // An editor also says so for what a letter brought up; then there are letters.
    let asked = params.context.as_ref().is_none_or(|c| c.trigger_kind.is_none_or(|kind| kind == INVOKED));
    let found = complete(&context.snapshot, &|| imports(&context.path), offset, asked)?;
    let replaces = found.replaces;
    let line = context.text.line(context.text.line_of(offset));
    let rest = context.text.as_str().get(replaces.end.min(line.end) as usize..line.end as usize).unwrap_or_default();
    let items = found.list.into_iter().map(|p| item(context, p, replaces, rest)).collect();
    Ok(CompletionList { is_incomplete: false, items })
}

fn item(context: &Context, proposal: Proposal, replaces: TextRange, rest: &str) -> CompletionItem {
    let Proposal { label, sort, detail, snippet, rank, about } = proposal;
    // Where the rest is there already, only the word is missing.
    let there = match sort {
        Sort::Function | Sort::Predicate => rest.trim_start().starts_with('('),
        Sort::File => false,
        _ => !rest.trim().is_empty(),
    };
    let snippet = snippet.filter(|s| !there && (context.client.snippets || !s.contains('$')));
    let is_snippet = snippet.as_ref().is_some_and(|s| s.contains('$'));
    let edit = TextEdit { range: context.range(replaces), new_text: snippet.unwrap_or_else(|| label.clone()) };
    // Editors show a swatch for this.
    let color = (sort == Sort::Color).then(|| color_of(&label)).flatten();
    CompletionItem {
        kind: Some(kind(sort)),
        detail: (!detail.is_empty()).then_some(detail),
        documentation: color.map(|[r, g, b]| Documentation::String(format!("#{r:02x}{g:02x}{b:02x}"))),
        sort_text: Some(format!("{rank}{label}")),
        insert_text_format: Some(if is_snippet { InsertTextFormat::SNIPPET } else { InsertTextFormat::PLAIN_TEXT }),
        text_edit: Some(CompletionTextEdit::Edit(edit)),
        data: about.map(Into::into),
        label,
        ..CompletionItem::default()
    }
}

fn kind(sort: Sort) -> CompletionItemKind {
    match sort {
        Sort::Keyword => CompletionItemKind::KEYWORD,
        Sort::Object => CompletionItemKind::CLASS,
        Sort::Region => CompletionItemKind::MODULE,
        Sort::Variable => CompletionItemKind::VARIABLE,
        Sort::Property => CompletionItemKind::PROPERTY,
        Sort::Function | Sort::Predicate => CompletionItemKind::FUNCTION,
        Sort::Type => CompletionItemKind::TYPE_PARAMETER,
        Sort::Constant => CompletionItemKind::CONSTANT,
        Sort::Unit => CompletionItemKind::UNIT,
        Sort::Color => CompletionItemKind::COLOR,
        Sort::Text => CompletionItemKind::VALUE,
        Sort::File => CompletionItemKind::FILE,
    }
}

fn markdown(value: String) -> Documentation {
    Documentation::MarkupContent(MarkupContent { kind: MarkupKind::Markdown, value })
}

/// `completionItem/resolve`
pub fn resolve_completion(mut item: CompletionItem) -> CompletionItem {
    if let Some(text) = item.data.as_ref().and_then(|data| data.as_str()).and_then(describe) {
        item.documentation = Some(markdown(text));
    }
    item
}

/// `textDocument/signatureHelp`
pub fn signature_help(context: &Context, at: &At) -> Result<Option<SignatureHelp>, Fault> {
    let Some(help) = signature::help(&context.snapshot, context.offset(at.position))? else { return Ok(None) };
    let parameter = |p: &String| ParameterInformation { label: ParameterLabel::Simple(p.clone()), documentation: None };
    let signatures = help.signatures.into_iter().map(|s| SignatureInformation {
        parameters: Some(s.params.iter().map(parameter).collect()),
        label: s.label,
        documentation: Some(markdown(s.doc)),
        active_parameter: None,
    });
    Ok(Some(SignatureHelp {
        signatures: signatures.collect(),
        active_signature: Some(help.active as u32),
        active_parameter: Some(help.argument as u32),
    }))
}

fn edits(context: &Context, replacement: Option<Replacement>) -> Vec<TextEdit> {
    replacement.into_iter().map(|(range, new_text)| TextEdit { range: context.range(range), new_text }).collect()
}

/// `textDocument/formatting`
pub fn formatting(context: &Context, _: &Whole) -> Result<Vec<TextEdit>, Fault> {
    Ok(edits(context, format::file(context.text.as_str())))
}

/// `textDocument/rangeFormatting`
pub fn range_formatting(context: &Context, within: &Within) -> Result<Vec<TextEdit>, Fault> {
    Ok(edits(context, format::range(context.text.as_str(), context.bytes(within.range))))
}

/// `textDocument/onTypeFormatting`
pub fn on_type_formatting(context: &Context, at: &At) -> Result<Vec<TextEdit>, Fault> {
    Ok(edits(context, format::ended(context.text.as_str(), context.offset(at.position))))
}

/// `textDocument/linkedEditingRange`
pub fn linked_editing(context: &Context, at: &At) -> Result<Option<LinkedEditingRanges>, Fault> {
    let found = shape::linked(&context.snapshot, context.offset(at.position))?;
    let ranges: Vec<_> = found.into_iter().map(|range| context.range(range)).collect();
    Ok((ranges.len() >= 2).then_some(LinkedEditingRanges { ranges, word_pattern: None }))
}
