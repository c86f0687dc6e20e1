//! The formatter: one statement a line, comments where they were, one way to write each operator.
//!
//! It keeps every comment and the meaning: a formatted statement has the same tokens as before, up to the spelling of
//! operators, and this is checked; what does not parse, or would not pass that check, is left byte for byte as it is.
//! Formatting twice is formatting once.

mod doc;
mod spelling;
mod statement;

use crate::ast::StmtKind;
use crate::chunk::{self, Chunk, has_line_break};
use crate::parse::parse_statement;
use crate::token::{Kind, Token, lex};
use scenelang_base::{Diagnostic, TextRange};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FormatOptions {
    /// The longest line, in characters, where a statement can be broken so. Comments and strings never are.
    pub width: usize,
}

impl Default for FormatOptions {
    fn default() -> Self {
        Self { width: 100 }
    }
}

/// Formats a file. Line ends become LF; a byte order mark stays.
pub fn format(text: &str, options: &FormatOptions) -> String {
    let cut = chunk::cut(text);
    let mut out = Output::default();
    let mut at = 0;
    if let Some(Token { kind: Kind::Bom, .. }) = cut.tokens.first() {
        out.text.push('\u{feff}');
        at = 1;
    }
    for chunk in &cut.chunks {
        out.gap(text, &cut.tokens[at..chunk.tokens.start]);
        out.item(&statement(text, chunk, &cut.tokens, options));
        at = chunk.tokens.end;
    }
    out.gap(text, &cut.tokens[at..]);
    let open = cut.tokens.last().is_some_and(|t| t.kind == Kind::OpenComment);
    if out.written && !open {
        out.text.push('\n');
    }
    out.text
}

/// A statement, formatted if it parses.
fn statement(text: &str, chunk: &Chunk, tokens: &[Token], options: &FormatOptions) -> String {
    let own = &text[chunk.range.bytes()];
    let (statements, diagnostics) = parse_statement(own);
    let stated = matches!(statements.as_slice(), [stmt] if stmt.kind != StmtKind::Empty);
    let whole = stated && !diagnostics.iter().any(Diagnostic::is_error);
    let shifted: Vec<Token> = tokens[chunk.tokens.clone()]
        .iter()
        .map(|t| Token {
            kind: t.kind,
            range: TextRange { start: t.range.start - chunk.range.start, end: t.range.end - chunk.range.start },
        })
        .collect();
    let layout = if whole { statement::layout(own, &shifted) } else { None };
    let formatted = layout.map(|docs| doc::print(&docs, options.width));
    match formatted {
        Some(formatted) if essence(&formatted) == essence(own) => formatted,
        _ => own.to_owned(),
    }
}

/// What formatting must keep: the tokens in one spelling, and the comments.
fn essence(text: &str) -> Vec<(Kind, String)> {
    let mut kept = Vec::new();
    for token in lex(text).into_iter().filter(|t| t.kind != Kind::Blank) {
        let slice = &text[token.range.bytes()];
        match token.kind {
            // Inside an expression an arrow is two tokens, and is written so.
            Kind::Arrow | Kind::ArrowSign => {
                kept.extend([(Kind::Lt, "<".to_owned()), (Kind::Minus, "-".to_owned())]);
            }
            kind if kind.is_comment() => kept.push((kind, comment_text(slice))),
            kind => kept.push((kind, spelling::spelling(kind, slice).to_owned())),
        }
    }
    kept
}

/// A comment without blanks at its end, its lines ended by LF.
fn comment_text(text: &str) -> String {
    text.trim_end().replace("\r\n", "\n").replace('\r', "\n")
}

/// How many lines end in a text.
fn line_breaks(text: &str) -> usize {
    text.matches(['\n', '\r']).count() - text.matches("\r\n").count()
}

/// The formatted file so far.
#[derive(Default)]
struct Output {
    text: String,
    /// Something stands in it already.
    written: bool,
    /// Line ends in the source since the last item.
    breaks: usize,
    /// The next item stays on the line of the last.
    joined: bool,
}

impl Output {
    /// The comments between two statements.
    fn gap(&mut self, text: &str, trivia: &[Token]) {
        // What stands on the line of the statement before stays there.
        self.joined = self.written;
        // Whether the line holds comments only, so far: then a statement may follow them on it.
        let mut comments_only = false;
        let mut statement_before = self.written;
        self.breaks = 0;
        for token in trivia {
            let slice = &text[token.range.bytes()];
            if token.kind == Kind::Blank {
                self.breaks += line_breaks(slice);
                if has_line_break(slice) {
                    (self.joined, comments_only, statement_before) = (false, false, false);
                }
            } else {
                self.item(&comment_text(slice));
                self.joined = token.kind == Kind::BlockComment;
                comments_only = self.joined && !statement_before;
            }
        }
        self.joined &= comments_only;
    }

    fn item(&mut self, item: &str) {
        if self.joined {
            self.text.push(' ');
        } else if self.written {
            self.text.push_str(if self.breaks > 1 { "\n\n" } else { "\n" });
        } else if self.text.is_empty() && item.starts_with('\u{feff}') {
            // A stray byte order mark must not become the file's.
            self.text.push('\n');
        }
        self.text.push_str(item);
        self.written = true;
        self.joined = false;
        self.breaks = 0;
    }
}
