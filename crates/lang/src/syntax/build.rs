//! Tokens and ranges → tree.

use super::kind::{NodeKind, SyntaxKind};
use super::{fragments, outline};
use crate::chunk::{self, Chunks};
use crate::parse::{ParsedChunk, Segment, doc_comments, parse_chunk};
use crate::token::{Kind, Token};
use rowan::{GreenNode, GreenNodeBuilder, GreenToken, NodeOrToken};
use scenelang_base::TextRange;

/// A range of the text that is to be a node.
#[derive(Clone, Copy, Debug)]
pub(super) struct NodeRange {
    pub range: TextRange,
    pub kind: NodeKind,
}

/// The tree of a file. Files of 4 GB and more are refused by the caller.
pub fn file(text: &str) -> GreenNode {
    file_of(text, &chunk::cut(text), statement_tree)
}

/// The tree of a file, cut into chunks, from the trees of its statements.
pub fn file_of(text: &str, chunks: &Chunks, mut statement: impl FnMut(&str) -> GreenNode) -> GreenNode {
    let leaf = |token: &Token| {
        let kind = SyntaxKind::Token(token.kind);
        NodeOrToken::Token(GreenToken::new(kind.into(), &text[token.range.bytes()]))
    };
    let mut children = Vec::with_capacity(2 * chunks.chunks.len() + 1);
    let mut at = 0;
    for chunk in &chunks.chunks {
        children.extend(chunks.tokens[at..chunk.tokens.start].iter().map(leaf));
        children.push(NodeOrToken::Node(statement(&text[chunk.range.bytes()])));
        at = chunk.tokens.end;
    }
    children.extend(chunks.tokens[at..].iter().map(leaf));
    GreenNode::new(SyntaxKind::Node(NodeKind::File).into(), children)
}

/// The tree of one chunk: a [`NodeKind::Statement`]. It depends on the text alone.
pub fn statement_tree(text: &str) -> GreenNode {
    let parsed = parse_chunk(text);
    let mut pieces = pieces(text, &parsed);
    // Stable: of two with one range, the first is outside.
    pieces.sort_by_key(|p| (p.range.start, std::cmp::Reverse(p.range.end)));
    let mut builder = GreenNodeBuilder::new();
    builder.start_node(SyntaxKind::Node(NodeKind::Statement).into());
    let mut pieces = pieces.into_iter().peekable();
    let mut open: Vec<u32> = Vec::new();
    for (kind, range) in leaves(&parsed) {
        while open.last().is_some_and(|end| *end <= range.start) {
            open.pop();
            builder.finish_node();
        }
        while let Some(piece) = pieces.next_if(|p| p.range.start <= range.start) {
            // What would cross another node, or starts within a token, is no node: the leaves are there all the same.
            if piece.range.start == range.start && open.last().is_none_or(|end| piece.range.end <= *end) {
                builder.start_node(SyntaxKind::Node(piece.kind).into());
                open.push(piece.range.end);
            }
        }
        builder.token(SyntaxKind::Token(kind).into(), &text[range.bytes()]);
    }
    open.iter().for_each(|_| builder.finish_node());
    builder.finish_node();
    builder.finish()
}

/// All nodes below the statement.
fn pieces(text: &str, parsed: &ParsedChunk) -> Vec<NodeRange> {
    let mut out = Vec::new();
    let mut from = 0;
    for segment in &parsed.segments {
        let words = &segment.words;
        let Some((first, last)) = words.ranges.first().zip(words.ranges.last()) else { continue };
        // Attributes without a statement are broken themselves.
        let body = words.ranges.get(words.head).map_or(*first, |head| *head).cover(*last);
        documentation(text, &parsed.tokens, from, body.start, &mut out);
        let statements = &parsed.statements[segment.statements.clone()];
        match (segment.broken, statements) {
            (false, [stmt]) => outline::statement(stmt, words, &mut out),
            _ => fragments::pieces(body, statements, words, &mut out),
        }
        let attributes = words.ranges[..words.head].chunks(4).filter_map(|r| Some(r.first()?.cover(*r.last()?)));
        out.extend(attributes.map(|range| NodeRange { range, kind: NodeKind::Requirement }));
        from = last.end;
    }
    if parsed.segments.is_empty() {
        // Stray semicolons; or nothing but a comment that does not close.
        out.extend(parsed.statements.iter().map(|s| NodeRange { range: s.range, kind: NodeKind::Empty }));
    }
    out
}

/// Runs of `///` lines with nothing but blanks between them.
fn documentation(text: &str, tokens: &[Token], from: u32, to: u32, out: &mut Vec<NodeRange>) {
    let blank = |range: TextRange| text[range.bytes()].trim().is_empty();
    let mut run: Option<TextRange> = None;
    for line in doc_comments(text, tokens, from, to) {
        run = match run {
            Some(run) if blank(TextRange { start: run.end, end: line.start }) => Some(run.cover(line)),
            before => {
                out.extend(before.map(|range| NodeRange { range, kind: NodeKind::Documentation }));
                Some(line)
            }
        };
    }
    out.extend(run.map(|range| NodeRange { range, kind: NodeKind::Documentation }));
}

/// The tokens as the grammar read them, with what it did not read: contextual words are told apart, and `<-` that meant
/// `<` and `-` is two.
fn leaves(parsed: &ParsedChunk) -> impl Iterator<Item = (Kind, TextRange)> {
    let words = |s: &Segment| s.words.kinds.iter().copied().zip(s.words.ranges.iter().copied()).collect::<Vec<_>>();
    let mut read = parsed.segments.iter().flat_map(words).peekable();
    parsed.tokens.iter().flat_map(move |token| {
        let here = read.next_if(|(_, range)| range.start == token.range.start);
        match here {
            Some((kind, range)) if range.end < token.range.end => {
                [Some((kind, range)), read.next().filter(|(_, rest)| rest.end == token.range.end)]
            }
            // A slip that the grammar read as what was meant stays a slip.
            Some((kind, range)) if kind == Kind::Ident || token.kind == Kind::Ident => [Some((kind, range)), None],
            _ => [Some((token.kind, token.range)), None],
        }
        .into_iter()
        .flatten()
    })
}
