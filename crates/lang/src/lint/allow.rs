//! Comments that silence warnings: `// allow(W0203)`, perhaps with words behind it.
//!
//! Behind code, such a comment speaks of its line and of the statement that ends there; on a line of its own, of the
//! statement that it stands in or above; above the first statement, of the whole file. Errors and violations cannot be
//! silenced. A comment that names no warning, or one that is not there, is one itself: W0103.

use crate::chunk::{Chunks, cut, has_line_break};
use crate::token::Kind;
use rustc_hash::FxHashMap;
use scenelang_base::{Applicability, Code, Diagnostic, FileId, Severity, SourceMap, TextRange, codes};

/// The comments of a file that silence something.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Allowances {
    list: Vec<Allowance>,
}

/// One such comment.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Allowance {
    comment: TextRange,
    /// What it names, as written, with its place.
    named: Vec<(String, TextRange)>,
    /// The warnings among these.
    codes: Vec<Code>,
    /// What it speaks of: bytes of the file.
    covers: TextRange,
}

impl Allowances {
    /// Reads the comments of a file.
    pub fn of(text: &str) -> Self {
        // Most files have none, and need not be read again.
        if !text.contains("allow(") && !text.contains("allow (") {
            return Self::default();
        }
        let chunks = cut(text);
        let comments = chunks.tokens.iter().enumerate().filter(|(_, t)| t.kind == Kind::LineComment);
        let list = comments.filter_map(|(at, token)| {
            let named = names(text, token.range)?;
            let known = named.iter().filter_map(|(name, _)| warning(name));
            Some(Allowance { comment: token.range, codes: known.collect(), covers: covers(text, &chunks, at), named })
        });
        Self { list: list.collect() }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The comments, by number, that silence a warning which begins at an offset of the file.
    fn silencing(&self, code: Code, at: u32) -> impl Iterator<Item = usize> {
        let speaks = move |a: &Allowance| a.codes.contains(&code) && a.covers.start <= at && at < a.covers.end;
        self.list.iter().enumerate().filter(move |(_, a)| speaks(a)).map(|(i, _)| i)
    }

    /// Whether a warning that begins at an offset of the file is silenced.
    pub fn silences(&self, code: Code, at: u32) -> bool {
        self.silencing(code, at).next().is_some()
    }

    /// What is wrong with the comments themselves. `found`: warnings of this file before any was silenced, with where
    /// they begin, if all of the front end's are among them; places are those of the file.
    pub fn check(&self, found: Option<&[(Code, u32)]>) -> Vec<Diagnostic<TextRange>> {
        let mut out = Vec::new();
        for allowance in &self.list {
            if allowance.named.is_empty() {
                let d = Diagnostic::new(codes::W0103, allowance.comment, "this `allow` comment names no code");
                out.push(d.note("as in `// allow(W0203)`"));
            }
            for (name, place) in &allowance.named {
                let d = |message: String| Diagnostic::new(codes::W0103, *place, message);
                match (Code::find(name), warning(name)) {
                    (None, _) => out.push(
                        d(format!("there is no code `{name}`"))
                            .note("a code is a letter and four digits, such as W0201"),
                    ),
                    (Some(code), None) => {
                        let what = if code.as_str().starts_with('V') { "a violation" } else { "an error" };
                        out.push(
                            d(format!("{code} is {what} and cannot be silenced"))
                                .note("only warnings can be silenced; their codes start with W"),
                        );
                    }
                    (Some(_), Some(code)) => {
                        let there = |(c, at): &(Code, u32)| {
                            *c == code && allowance.covers.start <= *at && *at < allowance.covers.end
                        };
                        let missing = found.is_some_and(|found| !found.iter().any(there));
                        if missing && is_early(code) {
                            let mut d = d(format!("{code} is not reported here, so there is nothing to silence"));
                            if allowance.named.len() == 1 {
                                d = d.fix(Applicability::Unsafe, "remove the comment", allowance.comment, "");
                            }
                            out.push(d);
                        }
                    }
                }
            }
        }
        out
    }
}

fn warning(name: &str) -> Option<Code> {
    Code::find(name).filter(|code| code.severity() == Severity::Warning)
}

/// Whether the front end itself reports a warning, so that it knows where there is none. That of this comment itself
/// is reported last.
fn is_early(code: Code) -> bool {
    code != codes::W0103 && ["W01", "W02", "W03"].iter().any(|family| code.as_str().starts_with(family))
}

/// What a comment names, if it is `// allow(…)`.
fn names(text: &str, comment: TextRange) -> Option<Vec<(String, TextRange)>> {
    let written = &text[comment.bytes()];
    let inner = written.trim_start_matches('/').trim_start().strip_prefix("allow")?.trim_start().strip_prefix('(')?;
    let start = comment.start + (written.len() - inner.len()) as u32;
    let list = inner.split(')').next().filter(|list| list.len() < inner.len())?;
    let mut at = start;
    let mut out = Vec::new();
    for part in list.split(',') {
        let name = part.trim();
        if !name.is_empty() {
            let from = at + (part.len() - part.trim_start().len()) as u32;
            out.push((name.to_owned(), TextRange { start: from, end: from + name.len() as u32 }));
        }
        at += part.len() as u32 + 1;
    }
    Some(out)
}

/// What the comment that is token `at` speaks of.
fn covers(text: &str, Chunks { tokens, chunks }: &Chunks, at: usize) -> TextRange {
    let comment = tokens[at].range;
    // Back to the start of the line: is there code?
    let line = tokens[..at].iter().rev().take_while(|t| !has_line_break(&text[t.range.bytes()])).collect::<Vec<_>>();
    let next = chunks.partition_point(|c| c.range.end <= comment.start);
    if let Some(last) = line.iter().find(|t| !t.kind.is_trivia()) {
        let mut start = line.last().map_or(comment.start, |t| t.range.start);
        // The statement that ends here may have begun on an earlier line.
        if let Some(ended) = next.checked_sub(1).map(|i| chunks[i].range).filter(|c| c.end == last.range.end) {
            start = start.min(ended.start);
        }
        return TextRange { start, end: comment.end };
    }
    match chunks.get(next) {
        Some(_) if next == 0 && comment.start < chunks[0].range.start => TextRange::new(0, text.len() + 1),
        Some(statement) => statement.range,
        // Behind the last statement there is nothing.
        None => comment,
    }
}

/// Takes out the warnings that comments in their files silence. For later stages, whose findings have places in
/// programs too; files that are no programs (`.json`) have no such comments.
pub fn silence(sources: &SourceMap, diagnostics: &mut Vec<Diagnostic>) {
    let mut read: FxHashMap<FileId, Allowances> = FxHashMap::default();
    diagnostics.retain(|d| {
        let Some(file) = d.primary.as_ref().map(|l| l.place.file) else { return true };
        let allowances = read.entry(file).or_insert_with(|| {
            let file = sources.get(file);
            let layout = file.path().extension().is_some_and(|e| e.eq_ignore_ascii_case("json"));
            if layout { Allowances::default() } else { Allowances::of(file.text()) }
        });
        !silenced(d, allowances)
    });
}

/// Whether the comments of its file silence a finding.
pub(crate) fn silenced(d: &Diagnostic, allowances: &Allowances) -> bool {
    let start = d.primary.as_ref().map(|l| l.place.range.start);
    !d.is_error() && start.is_some_and(|at| allowances.silences(d.code, at))
}

/// What is wrong with the comments of the main file, whose findings are all in `diagnostics`, silenced or not.
pub(crate) fn idle(allowances: &Allowances, main: FileId, diagnostics: &[Diagnostic]) -> Vec<Diagnostic> {
    // With an error, some warnings were not looked for.
    let complete = !diagnostics.iter().any(Diagnostic::is_error);
    let places = diagnostics.iter().filter_map(|d| Some((d.code, d.primary.as_ref()?.place)));
    let found: Vec<(Code, u32)> =
        places.filter(|(_, place)| place.file == main).map(|(code, place)| (code, place.range.start)).collect();
    let wrong = allowances.check(complete.then_some(found.as_slice()));
    wrong.into_iter().map(|d| d.map_places(|range| range.in_file(main))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The text that each comment covers, and the codes it silences.
    fn read(text: &str) -> Vec<(String, String)> {
        let covered = |range: TextRange| text.get(range.bytes()).unwrap_or("everything").trim().to_owned();
        let codes = |a: &Allowance| a.codes.iter().map(|c| c.as_str()).collect::<Vec<_>>().join(" ");
        Allowances::of(text).list.iter().map(|a| (covered(a.covers), codes(a))).collect()
    }

    #[test]
    fn what_a_comment_speaks_of() {
        let cases = [
            // Above the first statement: everything.
            ("// allow(W0201)\n\n/// doc\nobject a;\nobject b;", "everything"),
            // Behind a statement: its line, and all of the statement that ends there.
            ("object a;\nobject b; // allow(W0201)\nobject c;", "object b; // allow(W0201)"),
            ("object a; // allow(W0201)", "object a; // allow(W0201)"),
            ("object a;\nassert b\n  and c; // allow(W0201)", "assert b\n  and c; // allow(W0201)"),
            // Behind a part of one: its line.
            ("object a;\nassert b // allow(W0201)\n  and c;", "assert b // allow(W0201)"),
            // On a line of its own: the statement it stands above, or in.
            ("object a;\n// allow(W0201)\n\n/// doc\nobject b;\nobject c;", "/// doc\nobject b;"),
            ("object a;\nassert b\n  // allow(W0201)\n  and c;\nobject d;", "assert b\n  // allow(W0201)\n  and c;"),
            ("object a;\n// allow(W0201)", "// allow(W0201)"),
        ];
        for (text, covered) in cases {
            assert_eq!(read(text), [(covered.to_owned(), "W0201".to_owned())], "{text}");
        }
    }

    #[test]
    fn what_a_comment_names() {
        let cases = [
            ("// allow(W0201, W0203): both are meant", vec!["W0201 W0203"]),
            ("//allow( w0201 )", vec!["W0201"]),
            ("// allow(E0201, W9999, W0301)", vec!["W0301"]),
            ("// allow()", vec![""]),
            ("// allow W0201", vec![]),
            ("// allow(W0201", vec![]),
            ("// allowCollide(a, b);", vec![]),
            ("/// allow(W0201)", vec![]),
            ("/* allow(W0201) */", vec![]),
            ("assert a = \"// allow(W0201)\";", vec![]),
        ];
        for (text, expected) in cases {
            let found: Vec<String> = read(text).into_iter().map(|(_, codes)| codes).collect();
            assert_eq!(found, expected, "{text}");
        }
    }

    #[test]
    fn places_of_names_are_exact() {
        let text = "object a; // allow(W0201,  E0201)";
        let found = Allowances::of(text).check(None);
        let places: Vec<&str> = found.iter().map(|d| &text[d.primary.as_ref().unwrap().place.bytes()]).collect();
        assert_eq!(places, ["E0201"]);
    }
}
