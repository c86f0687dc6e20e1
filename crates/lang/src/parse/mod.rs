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
use crate::chunk::{self, Chunks, has_line_break};
use crate::token::{Class, Kind, Token, lex};
use builder::Builder;
use diagnose::{After, Site};
use lexical::Damage;
use scenelang_base::codes::{E0101, E0111, W0101};
use scenelang_base::{Applicability, Diagnostic, TextRange};
use std::ops::Range;
use wanted::Failure;
use words::Words;

#[derive(Clone, Debug, Default, PartialEq)]
pub struct ParsedFile {
    /// The statements in order, each with the byte offset in the file that its places are relative to.
    pub statements: Vec<(u32, Stmt)>,
    /// Errors and warnings, in order of the statements; places are bytes of the file.
    pub diagnostics: Vec<Diagnostic<TextRange>>,
}

/// Parses a file. Files of 4 GB and more are refused by the caller.
pub fn parse_file(text: &str) -> ParsedFile {
    parse_chunks(text, chunk::cut(text))
}

/// Parses a run of statements cut out of a file; it begins with the first of them. What is said of them is what
/// [`parse_file`] says, places apart.
pub(crate) fn parse_run(text: &str) -> ParsedFile {
    parse_chunks(text, chunk::cut_part(text, false))
}

fn parse_chunks(text: &str, chunks: Chunks) -> ParsedFile {
    let mut file = ParsedFile::default();
    for chunk in chunks.chunks {
        let offset = chunk.range.start;
        let (statements, diagnostics) = parse_statement(&text[chunk.range.bytes()]);
        file.statements.extend(statements.into_iter().map(|s| (offset, s)));
        file.diagnostics.extend(diagnostics.into_iter().map(|d| d.map_places(|p| p.shifted(offset))));
    }
    file
}

/// The tokens of a file as its parser reads them: contextual words are told from names, `<-` inside an expression is `<`
/// and `-`. Like those of [`lex`] they cover the file. A chunk that lacks a `;` is read as one statement.
pub fn read_tokens(text: &str) -> Vec<Token> {
    let Chunks { tokens, chunks } = chunk::cut(text);
    let mut read = Vec::with_capacity(tokens.len());
    let mut done = 0;
    for chunk in chunks {
        read.extend_from_slice(&tokens[done..chunk.tokens.start]);
        done = chunk.tokens.end;
        let chunk = &tokens[chunk.tokens];
        let (trivia, mut words): (Vec<Token>, Vec<Token>) = chunk.iter().partition(|t| t.kind.is_trivia());
        let semicolon = words.pop_if(|last| last.kind == Kind::Semi);
        let from = read.len();
        read.extend(trivia.into_iter().chain(semicolon));
        let Words { kinds, ranges, .. } = words::read(text, &words, None);
        // The parser goes on with what a wrong token means; here it stays wrong.
        let lexed = |start: u32| words.binary_search_by_key(&start, |t| t.range.start).map(|at| words[at].kind);
        read.extend(kinds.into_iter().zip(ranges).map(|(kind, range)| match lexed(range.start) {
            Ok(wrong) if wrong.class() == Class::Error => Token { kind: wrong, range },
            _ => Token { kind, range },
        }));
        read[from..].sort_unstable_by_key(|t| t.range.start);
    }
    read.extend_from_slice(&tokens[done..]);
    read
}

/// Parses the text of one chunk. Usually one statement; several where a `;` is missing between them, none where there
/// is nothing but a comment. Places are relative to the start of the text.
pub fn parse_statement(text: &str) -> (Vec<Stmt>, Vec<Diagnostic<TextRange>>) {
    let parsed = parse_chunk(text);
    (parsed.statements, parsed.diagnostics)
}

/// A chunk, parsed, and how its tokens were taken: for who makes a tree of them.
pub(crate) struct ParsedChunk {
    /// All tokens, trivia too.
    pub tokens: Vec<Token>,
    pub statements: Vec<Stmt>,
    /// Errors and warnings.
    pub diagnostics: Vec<Diagnostic<TextRange>>,
    /// The runs of tokens that were taken as one statement each, in order.
    pub segments: Vec<Segment>,
}

/// Tokens that were taken as one statement.
pub(crate) struct Segment {
    /// The tokens as the grammar read them, without trivia and without the `;`.
    pub words: Words,
    /// What they amount to; several statements if names of a broken one were kept.
    pub statements: Range<usize>,
    /// Whether they did not parse.
    pub broken: bool,
}

pub(crate) fn parse_chunk(text: &str) -> ParsedChunk {
    let all = lex(text);
    let mut tokens: Vec<Token> = all.iter().copied().filter(|t| !t.kind.is_trivia()).collect();
    let mut parser =
        ChunkParser { text, all: &all, statements: Vec::new(), diagnostics: Vec::new(), segments: Vec::new() };
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
    let ChunkParser { statements, mut diagnostics, segments, .. } = parser;
    diagnostics.sort_by_key(|d| d.primary.as_ref().map(|p| p.place.start));
    ParsedChunk { tokens: all, statements, diagnostics, segments }
}

/// What became of tokens that follow the grammar.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ParseOutcome {
    /// They are a statement.
    Taken,
    /// They nest too deeply to be one.
    Refused,
}

struct ChunkParser<'t> {
    text: &'t str,
    /// All tokens of the chunk, trivia too.
    all: &'t [Token],
    statements: Vec<Stmt>,
    diagnostics: Vec<Diagnostic<TextRange>>,
    segments: Vec<Segment>,
}

impl ChunkParser<'_> {
    fn chunk(&mut self, tokens: &[Token], end: After) {
        if tokens.is_empty() {
            if let After::Semicolon(range) = end {
                self.stray_semicolon(range);
            }
            return;
        }
        let (tokens, before) = self.hash_comments(tokens);
        if tokens.is_empty() && before > 0 {
            return;
        }
        let first = self.statements.len();
        let words = words::read(self.text, tokens, None);
        if let Some(refusal) = depth::check_tokens(words.kinds.iter().copied().zip(words.ranges.iter().copied())) {
            self.diagnostics.push(refusal);
            self.salvage(tokens, &words, before);
            self.segment(words, first, true);
            return;
        }
        let failure = match self.attempt(tokens, &words, before, end) {
            Ok(verdict) => {
                self.segment(words, first, verdict == ParseOutcome::Refused);
                return;
            }
            Err(failure) => failure,
        };
        let segments = split::split(self.text, tokens);
        if let [_] = segments.as_slice() {
            self.fail(tokens, &words, failure, before, end);
            self.segment(words, first, true);
            return;
        }
        let mut from = before;
        for (i, segment) in segments.iter().enumerate() {
            let end = segments.get(i + 1).map_or(end, |next| After::Statement(tokens[next.start].range));
            let tokens = &tokens[segment.clone()];
            let words = words::read(self.text, tokens, None);
            let first = self.statements.len();
            let attempt = self.attempt(tokens, &words, from, end);
            let broken = attempt != Ok(ParseOutcome::Taken);
            if let Err(failure) = attempt {
                self.fail(tokens, &words, failure, from, end);
            }
            self.segment(words, first, broken);
            from = tokens.last().map_or(from, |t| t.range.end);
        }
    }

    /// Reports lines before a statement that begin with `#`, as comments of other languages do, and passes over them.
    /// Returns the rest of the tokens, and where the last such line ends.
    fn hash_comments<'a>(&mut self, mut tokens: &'a [Token]) -> (&'a [Token], u32) {
        let mut from = 0;
        while let Some(hash) =
            tokens.first().filter(|t| t.kind == Kind::Unknown && self.text[t.range.bytes()].starts_with('#'))
        {
            let new_line =
                |pair: &[Token]| has_line_break(&self.text[pair[0].range.end as usize..pair[1].range.start as usize]);
            let end = tokens.windows(2).position(new_line).map_or(tokens.len(), |last| last + 1);
            let sign = TextRange { start: hash.range.start, end: hash.range.start + 1 };
            let diagnostic =
                Diagnostic::new(E0101, sign, "unexpected character `#`").note("a comment begins with `//`");
            self.diagnostics.push(diagnostic.fix(Applicability::Safe, "write `//`", sign, "//"));
            let line = hash.range.cover(tokens[end - 1].range);
            let first = self.statements.len();
            self.nothing(line);
            self.segment(words::read(self.text, &tokens[..end], None), first, true);
            from = line.end;
            tokens = &tokens[end..];
        }
        (tokens, from)
    }

    /// Remembers how some tokens were taken; `first` is the first of their statements.
    fn segment(&mut self, words: Words, first: usize, broken: bool) {
        self.segments.push(Segment { words, statements: first..self.statements.len(), broken });
    }

    /// Takes the tokens as one statement. What it cannot take is left alone, unreported. `from`: where the statement
    /// before it ends.
    fn attempt(
        &mut self,
        tokens: &[Token],
        words: &Words,
        from: u32,
        end: After,
    ) -> Result<ParseOutcome, Option<Failure>> {
        let (errors, damage) = lexical::check(self.text, tokens);
        if damage == Damage::Lost {
            return Err(None);
        }
        let (parsed, builder) = grammar::parse(&words.kinds, Builder::new(self.text, &words.ranges));
        let parsed = parsed.map_err(Some)?;
        if let Some(refusal) = depth::check_exprs(&builder.exprs) {
            self.diagnostics.push(refusal);
            self.salvage(tokens, words, from);
            return Ok(ParseOutcome::Refused);
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
            exprs: builder.exprs.into(),
        });
        Ok(ParseOutcome::Taken)
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
            exprs: exprs.into(),
        }));
    }

    fn require_semicolon(&mut self, tokens: &[Token], end: After) {
        let (Some(last), true) = (tokens.last(), matches!(end, After::Statement(_) | After::Nothing)) else { return };
        let place = TextRange::empty(last.range.end);
        let missing = Diagnostic::new(E0111, place, "missing `;` at the end of this statement");
        let missing = match end {
            After::Statement(next) => missing.related(next, "the next statement begins here"),
            _ => missing.note("every statement ends with `;`, including the last one"),
        };
        self.diagnostics.push(missing.fix(Applicability::Safe, "insert `;`", place, ";"));
    }

    fn stray_semicolon(&mut self, range: TextRange) {
        let warning = Diagnostic::new(W0101, range, "there is no statement before this `;`");
        self.diagnostics.push(warning.fix(Applicability::Safe, "remove it", range, ""));
        self.nothing(range);
    }

    /// A statement that says nothing.
    fn nothing(&mut self, range: TextRange) {
        self.statements.push(Stmt {
            kind: StmtKind::Empty,
            range,
            requirements: Vec::new(),
            doc: String::new(),
            attributes: None,
            exprs: Box::default(),
        });
    }

    /// The text of the `///` lines between two places, and the range of the first.
    fn documentation(&self, from: u32, to: u32) -> (String, Option<TextRange>) {
        let mut lines: Vec<&str> = Vec::new();
        let mut place = None;
        for range in doc_comments(self.text, self.all, from, to) {
            let line = self.text[range.bytes()].trim_start_matches('/');
            lines.push(line.strip_prefix(' ').unwrap_or(line).trim_end());
            place = place.or(Some(range));
        }
        (lines.join("\n"), place)
    }
}

/// The `///` lines between the end of a statement (or the start of the text) and the next. One that stands behind the
/// previous statement, on its line, documents nothing.
pub(crate) fn doc_comments(text: &str, tokens: &[Token], from: u32, to: u32) -> impl Iterator<Item = TextRange> {
    let first = tokens.partition_point(|t| t.range.start < from);
    let mut new_line = from == 0;
    tokens[first..].iter().take_while(move |t| t.range.start < to).filter_map(move |token| match token.kind {
        Kind::DocComment if new_line => Some(token.range),
        _ => {
            new_line |= has_line_break(&text[token.range.bytes()]);
            None
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::token::TABLE;
    use std::collections::BTreeSet;

    #[test]
    fn every_contextual_word_of_the_table_is_read() {
        let text = "import \"a\"; predicate p(Object a, Region r, Objects o, String s) := a.x <-1;\n\
            prefer forall x in objects where .a = 1: (count(y in x: y) = 1 implies exists z in x: z) weight 2; allowFloat(a);";
        let read: BTreeSet<(usize, &str)> =
            read_tokens(text).iter().map(|t| (t.kind as usize, &text[t.range.bytes()])).collect();
        for row in TABLE {
            for word in row.words {
                assert!(read.contains(&(row.kind as usize, word)), "{word}");
            }
        }
        assert!(read.contains(&(Kind::Lt as usize, "<")) && read.contains(&(Kind::Minus as usize, "-")));
    }

    #[test]
    fn what_is_read_covers_the_text() {
        for text in ["", ";;", "// a\nobject a; /// b", "prefer a <-1 /* c */ ; \"open", "a <- 'x' + 3kg /* open"] {
            let mut at = 0;
            for token in read_tokens(text) {
                assert_eq!(token.range.start, at, "{text}");
                at = token.range.end;
            }
            assert_eq!(at as usize, text.len(), "{text}");
        }
        let classes: Vec<Class> = read_tokens("a <- 'x' + 3kg;").iter().map(|t| t.kind.class()).collect();
        assert_eq!(classes.iter().filter(|c| **c == Class::Error).count(), 2, "repaired tokens stay errors");
    }
}
