//! What a document looks like: colours of tokens and of colours, folds, selections, links, hints, lenses.

use super::navigation::Positions;
use super::{Whole, Within};
use crate::client::SHOW;
use crate::commands::{Target, command};
use crate::disk::{self, Files};
use crate::dispatch::{Context, Fault, sent};
use crate::text::{Encoding, Text};
use scenelang_base::TextRange;
use scenelang_ide::hints::{self, HintKind, Lens};
use scenelang_ide::shape::{self, Fold, Link};
use scenelang_ide::{colors, tokens};
use scenelang_lang::sources::normal;
use serde::{Deserialize, Serialize};
use std::path::Path;
use std::sync::PoisonError;
use tower_lsp::ls_types::{
    CodeLens, ColorPresentation, DocumentLink, FoldingRange, FoldingRangeKind, InlayHint, InlayHintLabel,
    InlayHintTooltip, MarkupContent, MarkupKind, Position, Range, SelectionRange, SemanticToken, SemanticTokens,
    SemanticTokensDelta, SemanticTokensEdit, SemanticTokensFullDeltaResult, TextDocumentIdentifier, TextEdit, Uri,
};

// ── Semantic tokens ──

/// Tokens as the protocol has them, each relative to the one before; one that goes over several lines is cut.
fn encoded(context: &Context, within: Option<TextRange>) -> Result<Vec<SemanticToken>, Fault> {
    let text = &context.text;
    let encoding = context.client.encoding;
    let mut out = Vec::new();
    let (mut line, mut column) = (0, 0);
    for token in tokens::tokens(&context.snapshot, within)? {
        let TextRange { start, end } = token.range;
        for number in text.line_of(start)..=text.line_of(end.saturating_sub(1).max(start)) {
            let own = text.line(number);
            let (from, to) = (start.max(own.start), end.min(own.end));
            if from >= to {
                continue;
            }
            let at = encoding.len(&text.as_str()[own.start as usize..from as usize]);
            let length = encoding.len(&text.as_str()[from as usize..to as usize]);
            out.push(SemanticToken {
                delta_line: number - line,
                delta_start: if number == line { at - column } else { at },
                length,
                token_type: token.ty as u32,
                token_modifiers_bitset: token.modifiers,
            });
            (line, column) = (number, at);
        }
    }
    Ok(out)
}

/// `textDocument/semanticTokens/full`
pub fn tokens_full(context: &Context, _: &Whole) -> Result<SemanticTokens, Fault> {
    let data = encoded(context, None)?;
    let id = context.generation.to_string();
    *context.tokens.lock().unwrap_or_else(PoisonError::into_inner) = Some((id.clone(), data.clone()));
    Ok(SemanticTokens { result_id: Some(id), data })
}

/// `textDocument/semanticTokens/range`
pub fn tokens_range(context: &Context, within: &Within) -> Result<SemanticTokens, Fault> {
    Ok(SemanticTokens { result_id: None, data: encoded(context, Some(context.bytes(within.range)))? })
}

/// Parameters of `textDocument/semanticTokens/full/delta`.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Delta {
    #[allow(dead_code, reason = "that it is there, and an address, is what matters")]
    text_document: TextDocumentIdentifier,
    previous_result_id: String,
}

/// `textDocument/semanticTokens/full/delta`
pub fn tokens_delta(context: &Context, params: &Delta) -> Result<SemanticTokensFullDeltaResult, Fault> {
    let data = encoded(context, None)?;
    let id = context.generation.to_string();
    let mut known = context.tokens.lock().unwrap_or_else(PoisonError::into_inner);
    let before = known.replace((id.clone(), data.clone())).filter(|(id, _)| *id == params.previous_result_id);
    let Some((_, before)) = before else { return Ok(SemanticTokens { result_id: Some(id), data }.into()) };
    let head = before.iter().zip(&data).take_while(|(a, b)| a == b).count();
    let (a, b) = (&before[head..], &data[head..]);
    let tail = a.iter().rev().zip(b.iter().rev()).take_while(|(a, b)| a == b).count();
    let (removed, added) = (a.len() - tail, &b[..b.len() - tail]);
    let edits = if removed == 0 && added.is_empty() {
        Vec::new()
    } else {
        // The client counts numbers, and has five for each token.
        let [start, delete_count] = [head, removed].map(|tokens| 5 * tokens as u32);
        vec![SemanticTokensEdit { start, delete_count, data: Some(added.to_vec()) }]
    };
    Ok(SemanticTokensDelta { result_id: Some(id), edits }.into())
}

// ── Shape ──

/// `textDocument/foldingRange`
pub fn folding(context: &Context, _: &Whole) -> Result<Vec<FoldingRange>, Fault> {
    let folds = shape::folds(context.text.as_str()).into_iter().map(|(range, fold)| {
        let Range { start, end } = context.range(range);
        let kind = match fold {
            Fold::Statement => None,
            Fold::Comment => Some(FoldingRangeKind::Comment),
            Fold::Imports => Some(FoldingRangeKind::Imports),
            Fold::Section => Some(FoldingRangeKind::Region),
        };
        FoldingRange { start_line: start.line, end_line: end.line, kind, ..FoldingRange::default() }
    });
    Ok(folds.collect())
}

/// `textDocument/selectionRange`
pub fn selection(context: &Context, params: &Positions) -> Result<Vec<Option<SelectionRange>>, Fault> {
    let grown = params.positions.iter().map(|at| {
        let ranges = shape::selections(context.text.as_str(), context.offset(*at)).into_iter().rev();
        ranges.fold(None, |parent: Option<SelectionRange>, range| {
            Some(SelectionRange { range: context.range(range), parent: parent.map(Box::new) })
        })
    });
    Ok(grown.collect())
}

/// `textDocument/documentLink`
pub fn links(context: &Context, _: &Whole) -> Result<Vec<DocumentLink>, Fault> {
    let places = context.places();
    let found = shape::links(&context.snapshot)?.into_iter().filter_map(|(range, link)| {
        let target = match link {
            Link::Import(file) => places.uri(file)?,
            Link::Layout => disk::uri_of(context.layout.as_deref()?)?,
        };
        Some(link_to(context.range(range), target))
    });
    Ok(found.collect())
}

/// The link from a layout to its program, if that is there.
pub fn layout_links(layout: &Path, text: &Text, encoding: Encoding, files: &Files) -> Vec<DocumentLink> {
    let reach = files.of(layout);
    let target = |path: String| {
        let path = normal(&layout.parent()?.join(path));
        disk::uri_of(&path).filter(|_| reach.has(&path))
    };
    let found = shape::program_of(text.as_str()).and_then(|(range, path)| Some((range, target(path)?)));
    found.map(|(range, target)| link_to(text.range(range, encoding), target)).into_iter().collect()
}

fn link_to(range: Range, target: Uri) -> DocumentLink {
    DocumentLink { range, target: Some(target), tooltip: None, data: None }
}

// ── Colours ──

/// `ColorInformation`; the type of the protocol's library has shares of single precision, which are written as other numbers.
#[derive(Serialize)]
pub struct Coloured {
    range: Range,
    color: Shares,
}

#[derive(Serialize)]
struct Shares {
    red: f64,
    green: f64,
    blue: f64,
    alpha: f64,
}

/// `textDocument/documentColor`
pub fn colours(context: &Context, _: &Whole) -> Result<Vec<Coloured>, Fault> {
    let share = |x: u8| f64::from(x) / 255.0;
    let found = colors::colors(&context.snapshot)?;
    let shown = found.into_iter().map(|(range, [r, g, b])| Coloured {
        range: context.range(range),
        color: Shares { red: share(r), green: share(g), blue: share(b), alpha: 1.0 },
    });
    Ok(shown.collect())
}

/// Parameters of `textDocument/colorPresentation`.
#[derive(Deserialize)]
pub struct Presentation {
    #[serde(flatten)]
    within: Within,
    color: Picked,
}

#[derive(Deserialize)]
struct Picked {
    red: f64,
    green: f64,
    blue: f64,
}

/// `textDocument/colorPresentation`
pub fn presentations(_: &Context, params: &Presentation) -> Result<Vec<ColorPresentation>, Fault> {
    let Picked { red, green, blue } = params.color;
    let rgb = [red, green, blue].map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
    let spelled = colors::spellings(rgb).into_iter().map(|text| ColorPresentation {
        text_edit: Some(TextEdit { range: params.within.range, new_text: text.clone() }),
        label: text,
        additional_text_edits: None,
    });
    Ok(spelled.collect())
}

// ── Between the lines ──

/// `textDocument/inlayHint`
pub fn inlay_hints(context: &Context, within: &Within) -> Result<Vec<InlayHint>, Fault> {
    let on = context.config.hints;
    let shown = |kind: HintKind| match kind {
        HintKind::Margin => on.margins,
        HintKind::Value => on.values,
        HintKind::Size => on.sizes,
    };
    let found = hints::hints(&context.snapshot, context.bytes(within.range))?;
    let found = found.into_iter().filter(|hint| shown(hint.kind)).map(|hint| -> Result<InlayHint, Fault> {
        let position = context.text.position(hint.at, context.client.encoding);
        let resolved = hint.kind == HintKind::Margin && context.client.resolves_hints;
        let data = resolved.then(|| sent(About { uri: context.uri.clone(), position })).transpose()?;
        Ok(InlayHint {
            position,
            label: InlayHintLabel::String(hint.label),
            kind: None,
            text_edits: None,
            tooltip: Some(InlayHintTooltip::String(hint.tooltip)),
            padding_left: Some(true),
            padding_right: None,
            data,
        })
    });
    found.collect()
}

/// What a hint is about.
#[derive(Deserialize, Serialize)]
pub struct About {
    /// The document.
    pub uri: Uri,
    position: Position,
}

/// `inlayHint/resolve`
pub fn resolved_hint(context: &Context, mut hint: InlayHint, about: &About) -> Result<InlayHint, Fault> {
    if let Some(value) = hints::tooltip(&context.snapshot, context.offset(about.position))? {
        let text = MarkupContent { kind: MarkupKind::Markdown, value };
        hint.tooltip = Some(InlayHintTooltip::MarkupContent(text));
    }
    Ok(hint)
}

/// `textDocument/codeLens`
pub fn lenses(context: &Context, _: &Whole) -> Result<Vec<CodeLens>, Fault> {
    let uri = &context.uri;
    let mut out = Vec::new();
    for (range, lens) in hints::lenses(&context.snapshot)? {
        let range = context.range(range);
        let mut push = |title: &str, name: &str, target: Target<'_>| -> Result<(), Fault> {
            let command = Some(command(title.to_owned(), name, target)?);
            out.push(CodeLens { range, command, data: None });
            Ok(())
        };
        match lens {
            Lens::Program => {
                push("Check", "scenelang.check", Target::of(uri))?;
                push("Solve", "scenelang.solve", Target::of(uri))?;
                push("Repair", "scenelang.repairAll", Target::of(uri))?;
                // Elsewhere the room is shown in a browser.
                push("Show", if context.client.shows { SHOW } else { "scenelang.view" }, Target::of(uri))?;
            }
            Lens::Failing => {
                push("Repair", "scenelang.repair", Target { line: Some(range.start.line), ..Target::of(uri) })?;
            }
            Lens::Unplaced(name) => {
                let target = Target { object: Some(name.as_str()), ..Target::of(uri) };
                push(&format!("Place `{name}`"), "scenelang.place", target)?;
            }
        }
    }
    Ok(out)
}
