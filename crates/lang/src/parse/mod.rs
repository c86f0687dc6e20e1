//! Tokens → statements, with errors that poison only the statement they stand in.
//!
//! A file is cut at `;` ([`crate::chunk`]); what is said of a chunk depends on its text alone, and places are relative
//! to its start. A chunk that does not parse is searched for the start of a second statement, so that a missing `;`
//! is one error and both statements are kept. What a broken statement declares or assigns is kept as well, so that
//! later stages do not complain about its name.
//!
//! | file | what it does |
//! |---|---|
//! | `lexical` | reports tokens that the lexer could not read |
//! | `words` | tells contextual keywords from names, arrows from `<` `-` |
//! | `depth` | refuses what nests too deeply |
//! | `grammar`, `builder`, `literals`, `wanted` | the grammar and what it makes |
//! | `lint` | chained comparisons, arrows inside expressions |
//! | `split` | finds the statements in a chunk that lacks a `;` |
//! | `diagnose`, `wording` | says why a statement does not parse |
//! | `salvage` | keeps what can be kept of one that does not |
//! | `core` | what is outside the core language, for `--core` |

mod builder;
pub mod core;
pub(crate) mod depth;
mod diagnose;
mod grammar;
mod lexical;
mod lint;
mod literals;
mod salvage;
mod split;
mod wanted;
mod wording;
pub(crate) mod words;

use crate::ast::{Stmt, StmtKind};
use crate::chunk::{self, has_line_break};
use crate::token::{Kind, Token, lex};
use builder::Builder;
use diagnose::{After, Site};
use lexical::Damage;
use scenelang_base::codes::{E0111, W0101};
use scenelang_base::{Applicability, Diagnostic, TextRange};
use wanted::Failure;
use words::Words;

/// A parsed file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ParsedFile {
    /// The statements in order, each with the byte offset in the file that its places are relative to.
    pub statements: Vec<(u32, Stmt)>,
    /// Errors and warnings, in order of the statements; places are bytes of the file.
    pub diagnostics: Vec<Diagnostic<TextRange>>,
}

/// Parses a file. Files of 4 GB and more are refused by the caller.
pub fn parse_file(text: &str) -> ParsedFile {
    let mut file = ParsedFile::default();
    for chunk in chunk::cut(text).chunks {
        let offset = chunk.range.start;
        let (statements, diagnostics) = parse_statement(&text[chunk.range.bytes()]);
        file.statements.extend(statements.into_iter().map(|s| (offset, s)));
        file.diagnostics.extend(diagnostics.into_iter().map(|d| d.map_places(|p| p.shifted(offset))));
    }
    file
}

/// Parses the text of one chunk. Usually one statement; several where a `;` is missing between them, none where there
/// is nothing but a comment. Places are relative to the start of the text.
pub fn parse_statement(text: &str) -> (Vec<Stmt>, Vec<Diagnostic<TextRange>>) {
    let all = lex(text);
    let mut tokens: Vec<Token> = all.iter().copied().filter(|t| !t.kind.is_trivia()).collect();
    let mut parser = ChunkParser { text, all: &all, statements: Vec::new(), diagnostics: Vec::new() };
    let end = match tokens.last().copied() {
        Some(last @ Token { kind: Kind::Semi, .. }) => {
            tokens.pop();
            match tokens.first().copied() {
                // A run of stray ones, see `chunk`.
                Some(first) if first.kind == Kind::Semi => {
                    tokens.clear();
                    After::Semicolon(first.range.cover(last.range))
                }
                _ => After::Semicolon(last.range),
            }
        }
        Some(open @ Token { kind: Kind::OpenComment, .. }) => {
            tokens.pop();
            parser.diagnostics.extend(lexical::check(text, &[open]).0);
            After::Cut
        }
        Some(Token { kind: Kind::OpenStr, .. }) => After::Cut,
        _ => After::Nothing,
    };
    parser.chunk(&tokens, end);
    parser.diagnostics.sort_by_key(|d| d.primary.as_ref().map(|p| p.place.start));
    (parser.statements, parser.diagnostics)
}

struct ChunkParser<'t> {
    text: &'t str,
    /// All tokens of the chunk, trivia too.
    all: &'t [Token],
    statements: Vec<Stmt>,
    diagnostics: Vec<Diagnostic<TextRange>>,
}

impl ChunkParser<'_> {
    fn chunk(&mut self, tokens: &[Token], end: After) {
        if tokens.is_empty() {
            if let After::Semicolon(range) = end {
                self.stray_semicolon(range);
            }
            return;
        }
        let words = words::read(self.text, tokens, None);
        if let Some(refusal) = depth::check_tokens(words.kinds.iter().copied().zip(words.ranges.iter().copied())) {
            self.diagnostics.push(refusal);
            self.salvage(tokens, &words, 0);
            return;
        }
        let failure = match self.attempt(tokens, &words, 0, end) {
            Ok(()) => return,
            Err(failure) => failure,
        };
        let segments = split::split(self.text, tokens);
        if let [_] = segments.as_slice() {
            self.fail(tokens, &words, failure, 0, end);
            return;
        }
        let mut from = 0;
        for (i, segment) in segments.iter().enumerate() {
            let end = segments.get(i + 1).map_or(end, |next| After::Statement(tokens[next.start].range));
            let tokens = &tokens[segment.clone()];
            let words = words::read(self.text, tokens, None);
            if let Err(failure) = self.attempt(tokens, &words, from, end) {
                self.fail(tokens, &words, failure, from, end);
            }
            from = tokens.last().map_or(from, |t| t.range.end);
        }
    }

    /// Takes the tokens as one statement. What it cannot take is left alone, unreported. `from`: where the statement
    /// before it ends.
    fn attempt(&mut self, tokens: &[Token], words: &Words, from: u32, end: After) -> Result<(), Option<Failure>> {
        let (errors, damage) = lexical::check(self.text, tokens);
        if damage == Damage::Lost {
            return Err(None);
        }
        let (parsed, builder) = grammar::parse(&words.kinds, Builder::new(self.text, &words.ranges));
        let parsed = parsed.map_err(Some)?;
        if let Some(refusal) = depth::check_exprs(&builder.exprs) {
            self.diagnostics.push(refusal);
            self.salvage(tokens, words, from);
            return Ok(());
        }
        let findings = lint::check(self.text, &builder.exprs, &words.split_arrows);
        let chained = findings.iter().any(Diagnostic::is_error);
        if chained && !words.split_arrows.is_empty() && split::split(self.text, tokens).len() > 1 {
            // `assert a >` before a line `b <- 1;`: the arrow is one after all.
            return Err(None);
        }
        self.diagnostics.extend(errors);
        self.diagnostics.extend(findings);
        self.require_semicolon(tokens, end);
        let (doc, doc_range) = self.documentation(from, parsed.range.start);
        self.statements.push(Stmt {
            kind: parsed.kind,
            range: parsed.range,
            requirements: parsed.requirements,
            doc,
            attributes: parsed.attribute.or(doc_range),
            exprs: builder.exprs,
        });
        Ok(())
    }

    /// Reports why the tokens are no statement, and keeps what can be kept of them.
    fn fail(&mut self, tokens: &[Token], words: &Words, failure: Option<Failure>, from: u32, end: After) {
        let (errors, _) = lexical::check(self.text, tokens);
        let lexical = !errors.is_empty();
        self.diagnostics.extend(errors);
        if let Some(failure) = failure
            && !lexical
            && end != After::Cut
        {
            self.diagnostics.push(diagnose::diagnose(&Site::new(self.text, words, failure, end)));
        }
        self.salvage(tokens, words, from);
    }

    fn salvage(&mut self, tokens: &[Token], words: &Words, from: u32) {
        let head = tokens.get(words.head).or(tokens.last());
        let place = head.zip(tokens.last()).map_or(TextRange::empty(from), |(head, last)| head.range.cover(last.range));
        let (doc, attributes) = self.documentation(from, place.start);
        let mut kept = salvage::salvage(self.text, tokens, words);
        if kept.is_empty() {
            kept.push((StmtKind::Error, Vec::new()));
        }
        self.statements.extend(kept.into_iter().map(|(kind, exprs)| Stmt {
            kind,
            range: place,
            requirements: Vec::new(),
            doc: doc.clone(),
            attributes,
            exprs,
        }));
    }

    fn require_semicolon(&mut self, tokens: &[Token], end: After) {
        let (Some(last), true) = (tokens.last(), matches!(end, After::Statement(_) | After::Nothing)) else { return };
        let place = TextRange::empty(last.range.end);
        let missing = Diagnostic::new(E0111, place, "a `;` is missing at the end of this statement");
        let missing = match end {
            After::Statement(next) => missing.related(next, "the next statement begins here"),
            _ => missing.note("every statement ends with `;`, the last one too"),
        };
        self.diagnostics.push(missing.fix(Applicability::Safe, "insert `;`", place, ";"));
    }

    fn stray_semicolon(&mut self, range: TextRange) {
        let warning = Diagnostic::new(W0101, range, "there is no statement before this `;`");
        self.diagnostics.push(warning.fix(Applicability::Safe, "remove it", range, ""));
        self.statements.push(Stmt {
            kind: StmtKind::Empty,
            range,
            requirements: Vec::new(),
            doc: String::new(),
            attributes: None,
            exprs: Vec::new(),
        });
    }

    /// The text of the `///` lines between two places, and the range of the first. One that stands behind the previous
    /// statement, on its line, documents nothing.
    fn documentation(&self, from: u32, to: u32) -> (String, Option<TextRange>) {
        let first = self.all.partition_point(|t| t.range.start < from);
        let mut new_line = from == 0;
        let mut lines: Vec<&str> = Vec::new();
        let mut place = None;
        for token in self.all[first..].iter().take_while(|t| t.range.start < to) {
            let slice = &self.text[token.range.bytes()];
            match token.kind {
                Kind::DocComment if new_line => {
                    let line = slice.trim_start_matches('/');
                    lines.push(line.strip_prefix(' ').unwrap_or(line).trim_end());
                    place = place.or(Some(token.range));
                }
                _ => new_line |= has_line_break(slice),
            }
        }
        (lines.join("\n"), place)
    }
}
