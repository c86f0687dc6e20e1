//! Formatting: of a file, of the statements in a range, of the one that was just ended.

use scenelang_base::TextRange;
use scenelang_lang::chunk::{Chunk, cut};
use scenelang_lang::fmt::{FormatOptions, format};
use scenelang_lang::parse::parse_file;

/// One replacement: a place of the text, and what stands there afterwards.
pub type Replacement = (TextRange, String);

/// What formatting a file changes: the lines between the first and the last that differ.
pub fn file(text: &str) -> Option<Replacement> {
    difference(text, &format(text, &FormatOptions::default()))
}

/// What formatting the statements that a range touches changes.
pub fn range(text: &str, range: TextRange) -> Option<Replacement> {
    let touched = |chunk: &Chunk| chunk.range.start <= range.end && range.start <= chunk.range.end;
    statements(text, touched)
}

/// What formatting the statement that ends with the `;` before an offset changes. One that is not right yet stays as it is.
pub fn ended(text: &str, offset: u32) -> Option<Replacement> {
    let own = |chunk: &Chunk| chunk.range.end == offset;
    let chunk = cut(text).chunks.into_iter().find(own)?;
    let good = parse_file(&text[chunk.range.bytes()]).diagnostics.iter().all(|d| !d.is_error());
    if good { statements(text, own) } else { None }
}

/// Formats the statements that are meant, from the first to the last.
fn statements(text: &str, meant: impl Fn(&Chunk) -> bool) -> Option<Replacement> {
    let chunks = cut(text).chunks;
    let first = chunks.iter().position(&meant)?;
    let last = chunks.iter().rposition(&meant)?;
    let place = chunks[first].range.cover(chunks[last].range);
    let old = text.get(place.bytes())?;
    let new = format(old, &FormatOptions::default());
    differing(old, new.trim_end_matches('\n'), place.start)
}

/// What makes one text another: the lines between the first and the last that differ.
pub fn difference(old: &str, new: &str) -> Option<Replacement> {
    differing(old, new, 0)
}

/// What makes one text another: the lines that differ, run by run, where both have as many; else as [`difference`].
pub fn differences(old: &str, new: &str) -> Vec<Replacement> {
    if old.matches('\n').count() != new.matches('\n').count() {
        return difference(old, new).into_iter().collect();
    }
    let mut out: Vec<Replacement> = Vec::new();
    let mut at = 0;
    for (a, b) in old.split_inclusive('\n').zip(new.split_inclusive('\n')) {
        let range = TextRange::new(at, at + a.len());
        at += a.len();
        if a == b {
            continue;
        }
        match out.last_mut() {
            Some((last, text)) if last.end == range.start => {
                last.end = range.end;
                text.push_str(b);
            }
            _ => out.push((range, b.to_owned())),
        }
    }
    out
}

/// The part of a text that differs from another, whole lines as far as these are alike.
fn differing(old: &str, new: &str, at: u32) -> Option<Replacement> {
    if old == new {
        return None;
    }
    let same = |a: &mut dyn Iterator<Item = &str>, b: &mut dyn Iterator<Item = &str>| -> usize {
        a.zip(b).take_while(|(x, y)| x == y).map(|(x, _)| x.len()).sum()
    };
    let head = same(&mut old.split_inclusive('\n'), &mut new.split_inclusive('\n'));
    let (a, b) = (&old[head..], &new[head..]);
    // Lines from the end, each with the break before it.
    let tail = same(&mut from_end(a).into_iter(), &mut from_end(b).into_iter());
    let range = TextRange::new(head, old.len() - tail).shifted(at);
    Some((range, b[..b.len() - tail].to_owned()))
}

/// Pieces of a text from its end, each beginning with a line break.
fn from_end(text: &str) -> Vec<&str> {
    let mut rest = text;
    let mut out = Vec::new();
    while let Some(at) = rest.rfind('\n') {
        out.push(&rest[at..]);
        rest = &rest[..at];
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn apply(text: &str, edit: Option<Replacement>) -> String {
        let mut out = text.to_owned();
        if let Some((range, new)) = edit {
            out.replace_range(range.bytes(), &new);
        }
        out
    }

    #[test]
    fn only_what_differs_is_replaced() {
        let text = "object a;\nobject   b;\nobject c;\n";
        assert_eq!(file(text), Some((TextRange { start: 10, end: 21 }, "object b;".to_owned())));
        assert_eq!(file("object a;\n"), None);
        for text in ["", "object a", "object  a;object b;", "a<-1;\r\n\r\n\r\nobject a;", "object a;\n\n\n\n// x\n"] {
            assert_eq!(apply(text, file(text)), format(text, &FormatOptions::default()), "{text:?}");
        }
    }

    #[test]
    fn lines_that_are_alike_stay_between_others() {
        let old = "a\nb\nc\nd\ne\n";
        for (new, count) in [
            (old, 0),
            ("A\nb\nc\nd\nE\n", 2),
            ("a\nB\nC\nd\ne\n", 1),
            ("A\nb\nc\nd\n", 1),
            ("a\nb\nx\nc\nd\nE\n", 1),
            ("a\nb\nc\nD\nE", 1),
        ] {
            let found = differences(old, new);
            let mut text = old.to_owned();
            found.iter().rev().for_each(|(range, with)| text.replace_range(range.bytes(), with));
            assert_eq!((text.as_str(), found.len()), (new, count), "{found:?}");
        }
    }

    #[test]
    fn ranges_and_endings_touch_their_statements_only() {
        let text = "object   a;\nobject   b;\nobject   c;\n";
        assert_eq!(apply(text, range(text, TextRange { start: 14, end: 15 })), "object   a;\nobject b;\nobject   c;\n");
        assert_eq!(apply(text, ended(text, 11)), "object a;\nobject   b;\nobject   c;\n");
        assert_eq!(ended(text, 10), None);
        assert_eq!(ended("assert  a  <;", 13), None);
    }
}
