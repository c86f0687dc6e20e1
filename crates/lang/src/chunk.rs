//! Cuts a file into statements at `;`, before anything is parsed.
//!
//! A chunk is the unit of incrementality: what the parser says of it depends on its text alone. Plain comments and
//! blanks before a statement belong to the gap between chunks; `///` lines, `@req(…)` and everything from the first
//! token to the `;` belong to the chunk. An open string ends its statement with its line.

use crate::token::{Kind, Token, lex};
use scenelang_base::TextRange;
use std::ops::Range;

/// One statement's text, not yet parsed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chunk {
    /// Its bytes in the file.
    pub range: TextRange,
    /// Its tokens, in [`Chunks::tokens`].
    pub tokens: Range<usize>,
}

/// A file cut into statements.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chunks {
    /// All tokens of the file, with places in the file.
    pub tokens: Vec<Token>,
    /// The statements, in order.
    pub chunks: Vec<Chunk>,
}

/// Cuts a file; offsets are `u32`, so the caller refuses files of 4 GB and more.
pub fn cut(text: &str) -> Chunks {
    cut_part(text, true)
}

/// Cuts a part of a file that begins with a statement, or a whole one: only there a byte order mark may stand.
pub(crate) fn cut_part(text: &str, whole: bool) -> Chunks {
    let tokens = lex(text);
    let mut chunks = Vec::new();
    let mut at = 0;
    while let Some(start) = next_start(text, &tokens, at, whole) {
        let end = end_of_statement(&tokens, start);
        let range = TextRange { start: tokens[start].range.start, end: tokens[end - 1].range.end };
        chunks.push(Chunk { range, tokens: start..end });
        at = end;
    }
    Chunks { tokens, chunks }
}

/// The first token of the next statement: a `///` that begins its line, or the first that is no trivia.
fn next_start(text: &str, tokens: &[Token], from: usize, whole: bool) -> Option<usize> {
    let mut doc = None;
    let mut new_line = from == 0;
    for (i, token) in tokens.iter().enumerate().skip(from) {
        match token.kind {
            Kind::Bom if whole && i == 0 => {}
            Kind::DocComment if new_line => doc = doc.or(Some(i)),
            kind if kind.is_trivia() => new_line |= has_line_break(&text[token.range.bytes()]),
            Kind::OpenComment => return Some(i),
            _ => return doc.or(Some(i)),
        }
    }
    None
}

/// One past the last token of the statement that begins at `start`.
fn end_of_statement(tokens: &[Token], start: usize) -> usize {
    let mut end = start;
    if tokens[start].kind == Kind::Semi {
        // A run of stray ones is one piece of news.
        return start + tokens[start..].iter().take_while(|t| t.kind == Kind::Semi).count();
    }
    for (i, token) in tokens.iter().enumerate().skip(start) {
        match token.kind {
            Kind::Semi | Kind::OpenComment => return i + 1,
            Kind::OpenStr => {
                // The `;` that the string would have swallowed may stand on the next line.
                let next = (i + 1..tokens.len()).find(|&j| !tokens[j].kind.is_trivia());
                return next.filter(|&j| tokens[j].kind == Kind::Semi).map_or(i + 1, |j| j + 1);
            }
            kind if kind.is_trivia() => {}
            _ => end = i + 1,
        }
    }
    end
}

/// Whether a line ends in the text: LF, CRLF or CR.
pub fn has_line_break(text: &str) -> bool {
    text.contains(['\n', '\r'])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn texts(text: &str) -> Vec<&str> {
        cut(text).chunks.iter().map(|c| &text[c.range.bytes()]).collect()
    }

    #[test]
    fn cuts_at_semicolons() {
        assert_eq!(texts("object a; object b;\n"), ["object a;", "object b;"]);
        assert_eq!(texts("\u{feff}// plain\nobject a;"), ["object a;"]);
        assert_eq!(texts(" ;; ;"), [";;", ";"]);
        assert_eq!(texts("object a // last\n"), ["object a"]);
        assert_eq!(texts(""), [""; 0]);
    }

    #[test]
    fn documentation_and_requirements_go_with_their_statement() {
        assert_eq!(
            texts("object a; /// trailing\n/// doc\n// plain\nobject b;"),
            ["object a;", "/// doc\n// plain\nobject b;"]
        );
        assert_eq!(texts("@req(\"one; two\")\nobject a;"), ["@req(\"one; two\")\nobject a;"]);
        assert_eq!(texts("object a;\n/// dangling\n"), ["object a;"]);
    }

    #[test]
    fn an_open_string_ends_with_its_line_and_an_open_comment_with_the_file() {
        assert_eq!(texts("a <- \"red;\nb <- 1;"), ["a <- \"red;", "b <- 1;"]);
        assert_eq!(texts("a <- \"red\\\n  ;\nb <- 1;"), ["a <- \"red\\\n  ;", "b <- 1;"]);
        assert_eq!(texts("a <- 1; /* x\nb <- 1;"), ["a <- 1;", "/* x\nb <- 1;"]);
        assert_eq!(texts("a <- 1 /* x\nb <- 1;"), ["a <- 1 /* x\nb <- 1;"]);
    }

    proptest! {
        /// What the parser sees of a chunk is what it would see if the chunk were the whole file.
        #[test]
        fn chunks_lex_alone_as_they_do_in_the_file(text in r#"(object a|[;"'/*.\n ]|///|/\*|\*/|x <- |"red"|@req\("a"\)|\x{feff}|5){0,24}"#) {
            let cut = cut(&text);
            for chunk in &cut.chunks {
                let alone = lex(&text[chunk.range.bytes()]);
                let there: Vec<_> = cut.tokens[chunk.tokens.clone()].to_vec();
                let moved: Vec<_> =
                    alone.iter().map(|t| Token { kind: t.kind, range: t.range.shifted(chunk.range.start) }).collect();
                prop_assert_eq!(moved, there);
            }
        }
    }
}
