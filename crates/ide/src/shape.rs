//! The shape of a file: what can be folded, what a selection grows to, names that are edited together, links.

use crate::Snapshot;
use crate::names::{self, Symbol};
use crate::navigate::imports;
use scenelang_base::{FileId, TextRange};
use scenelang_lang::ast::StmtKind;
use scenelang_lang::chunk::{cut, has_line_break};
use scenelang_lang::db::Cancelled;
use scenelang_lang::syntax;
use scenelang_lang::token::Kind;
use scenelang_layout::file as layout_file;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fold {
    Statement,
    Comment,
    Imports,
    /// From a heading to the next: a comment such as `// ---- Doors ----`.
    Section,
}

/// What can be folded: ranges over several lines, in the order of the text.
pub fn folds(text: &str) -> Vec<(TextRange, Fold)> {
    let cut = cut(text);
    let mut out: Vec<(TextRange, Fold)> = cut.chunks.iter().map(|c| (c.range, Fold::Statement)).collect();
    let mut comment: Option<TextRange> = None;
    let mut headings: Vec<u32> = Vec::new();
    for token in &cut.tokens {
        let slice = &text[token.range.bytes()];
        match token.kind {
            Kind::LineComment if is_heading(slice) => {
                out.extend(comment.take().map(|c| (c, Fold::Comment)));
                headings.push(token.range.start);
            }
            Kind::LineComment => comment = Some(comment.map_or(token.range, |c| c.cover(token.range))),
            Kind::BlockComment => out.push((token.range, Fold::Comment)),
            Kind::Blank if slice.matches('\n').count() < 2 => {}
            _ => out.extend(comment.take().map(|c| (c, Fold::Comment))),
        }
    }
    out.extend(comment.map(|c| (c, Fold::Comment)));
    for (i, start) in headings.iter().enumerate() {
        let end = headings.get(i + 1).map_or(text.len(), |next| *next as usize);
        let section = text[*start as usize..end].trim_end();
        out.push((TextRange { start: *start, end: *start + section.len() as u32 }, Fold::Section));
    }
    let imports = cut.chunks.iter().filter(|c| text[c.range.bytes()].trim_start().starts_with("import"));
    out.extend(imports.map(|c| c.range).reduce(TextRange::cover).map(|range| (range, Fold::Imports)));
    out.retain(|(range, _)| has_line_break(&text[range.bytes()]));
    out.sort_by_key(|(range, _)| (range.start, std::cmp::Reverse(range.end)));
    out
}

/// Whether a comment is a heading: words between rules.
fn is_heading(comment: &str) -> bool {
    let words = comment.trim_start_matches('/').trim();
    let rule = |c: char| matches!(c, '-' | '=' | '─' | '═' | '#' | '*');
    words.starts_with(rule) && words.trim_matches(rule).chars().any(char::is_alphanumeric)
}

/// What a selection at an offset grows to: innermost first, each larger than the one before.
pub fn selections(text: &str, offset: u32) -> Vec<TextRange> {
    let root = syntax::parse(text);
    let end = u32::from(root.text_range().end());
    let mut out: Vec<TextRange> = Vec::new();
    let mut push = |element: syntax::SyntaxElement| {
        let range = syntax::range_of(&element);
        if out.last().is_none_or(|last| *last != range) {
            out.push(range);
        }
    };
    let found = root.token_at_offset(offset.min(end).into());
    let token =
        found.clone().find(|t| t.kind().token().is_some_and(|k| !k.is_trivia())).or_else(|| found.right_biased());
    let Some(token) = token else { return vec![TextRange { start: 0, end }] };
    let ancestors: Vec<_> = token.parent_ancestors().collect();
    push(token.into());
    ancestors.into_iter().for_each(|node| push(node.into()));
    out
}

/// Names that are edited together with the one at an offset: a parameter or the variable of a quantifier, wherever it
/// stands. What the layout knows by its name is renamed instead.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn linked(snapshot: &Snapshot, offset: u32) -> Result<Vec<TextRange>, Cancelled> {
    let all = names::occurrences(snapshot, snapshot.main())?;
    let Some(name) = names::at(&all, offset).filter(|o| matches!(o.symbol, Symbol::Local { .. })) else {
        return Ok(Vec::new());
    };
    Ok(all.iter().filter(|o| o.symbol.is(&name.symbol)).map(|o| o.range).collect())
}

/// Where a link leads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Link {
    Import(FileId),
    Layout,
}

/// Links: the paths of imports, and the layout's name wherever a comment has it.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn links(snapshot: &Snapshot) -> Result<Vec<(TextRange, Link)>, Cancelled> {
    let mut out: Vec<(TextRange, Link)> =
        imports(snapshot)?.into_iter().map(|(range, file)| (inner(range), Link::Import(file))).collect();
    let name = snapshot.layout().and_then(|l| l.path.file_name()).map(|n| n.to_string_lossy().into_owned());
    if let Some(name) = name {
        let text = snapshot.text();
        for token in cut(text).tokens.iter().filter(|t| t.kind.is_comment()) {
            let found = text[token.range.bytes()].match_indices(&name);
            out.extend(
                found.map(|(at, _)| (TextRange::new(at, at + name.len()).shifted(token.range.start), Link::Layout)),
            );
        }
    }
    out.sort_by_key(|(range, _)| range.start);
    Ok(out)
}

/// The path of its program in the text of a layout, and where that stands, without quotation marks.
pub fn program_of(layout: &str) -> Option<(TextRange, String)> {
    let read = layout_file::read(layout, FileId(0));
    let place = read.places.top.get("scene")?.place.value.range;
    Some((inner(place), read.layout.scene.filter(|path| !path.is_empty())?))
}

/// A range without the quotation marks at its ends.
fn inner(range: TextRange) -> TextRange {
    TextRange { start: range.start + 1, end: (range.end - 1).max(range.start + 1) }
}

/// Whether a statement is a constraint.
pub(crate) fn is_constraint(kind: &StmtKind) -> bool {
    matches!(kind, StmtKind::Assert { .. } | StmtKind::Prefer { .. })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folds_of_a_file() {
        let text = "// one\n// two\nimport \"a\";\nimport \"b\";\n// ---- Doors ----\nobject a;\nassert a.top >\n  1;\n\n// ---- Beds ----\nobject b;\n";
        let found: Vec<(&str, Fold)> = folds(text).into_iter().map(|(r, f)| (&text[r.bytes()], f)).collect();
        assert_eq!(
            found,
            [
                ("// one\n// two", Fold::Comment),
                ("import \"a\";\nimport \"b\";", Fold::Imports),
                ("// ---- Doors ----\nobject a;\nassert a.top >\n  1;", Fold::Section),
                ("assert a.top >\n  1;", Fold::Statement),
                ("// ---- Beds ----\nobject b;", Fold::Section),
            ]
        );
    }

    #[test]
    fn a_layout_names_its_program() {
        for (text, wanted) in [
            (
                "{\"format\": \"scenelang.layout/1\", \"scene\": \"../a b.scene\"}",
                Some(("../a b.scene", "../a b.scene")),
            ),
            ("{\"format\": \"scenelang.layout/1\", \"scene\": \"\\u0061.scene\"}", Some(("\\u0061.scene", "a.scene"))),
            ("{\"format\": \"scenelang.layout/1\", \"scene\": \"\"}", None),
            ("{\"format\": \"scenelang.layout/1\", \"scene\": 5}", None),
            ("{\"scene\": ", None),
            ("", None),
        ] {
            let found = program_of(text);
            let found = found.as_ref().map(|(range, path)| (&text[range.bytes()], path.as_str()));
            assert_eq!(found, wanted, "{text}");
        }
    }

    #[test]
    fn a_selection_grows() {
        let text = "assert near(a, b + 1);";
        let found: Vec<&str> = selections(text, 15).into_iter().map(|r| &text[r.bytes()]).collect();
        assert_eq!(
            found,
            ["b", "b + 1", "(a, b + 1)", "near(a, b + 1)", "assert near(a, b + 1)", "assert near(a, b + 1);"]
        );
        assert_eq!(selections("", 9), [TextRange { start: 0, end: 0 }]);
    }
}
