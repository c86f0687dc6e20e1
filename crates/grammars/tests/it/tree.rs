//! The tree-sitter grammar accepts what the front end accepts, and finds the same statements.

use crate::programs::{Program, book, ebnf, has_huge_number, is_well_formed, made, root, written};
use crate::soup;
use proptest::prelude::*;
use scenelang_base::TextRange;
use scenelang_lang::ast::{Stmt, StmtKind};
use scenelang_lang::chunk::has_line_break;
use scenelang_lang::parse::parse_file;
use scenelang_lang::token::{Kind, lex};
use serde_json::Value;
use std::collections::BTreeSet;
use std::ops::Range;
use tree_sitter::{InputEdit, Node, Parser, Point, Tree};

pub fn parse(text: &str) -> Tree {
    parser().parse(text, None).unwrap()
}

fn parser() -> Parser {
    let mut parser = Parser::new();
    parser.set_language(&scenelang_grammars::language()).unwrap();
    parser
}

/// Row and column of a byte, as tree-sitter counts them.
fn point(text: &str, at: usize) -> Point {
    let line = text[..at].rfind('\n').map_or(0, |end| end + 1);
    Point { row: text[..at].matches('\n').count(), column: at - line }
}

/// The name that a statement's node has.
fn kind(stmt: &Stmt) -> &'static str {
    match stmt.kind {
        StmtKind::Declare { .. } => "declaration",
        StmtKind::Assign { .. } => "assignment",
        StmtKind::Assert { .. } => "assertion",
        StmtKind::Prefer { .. } => "preference",
        StmtKind::Allow { .. } => "allowance",
        StmtKind::Predicate { .. } => "predicate",
        StmtKind::Import { .. } => "import",
        StmtKind::Empty | StmtKind::Error => "",
    }
}

type Place = (String, Range<usize>);

/// Kinds and bytes of the front end's statements, strays apart.
fn ours(text: &str) -> Vec<Place> {
    let parsed = parse_file(text);
    let places = parsed.statements.iter().map(|(offset, s)| (kind(s).to_owned(), s.range.shifted(*offset).bytes()));
    places.filter(|(kind, _)| !kind.is_empty()).collect()
}

/// Kinds and bytes of the tree's statements, without requirements and `;`.
fn theirs(tree: &Tree) -> Vec<Place> {
    let mut cursor = tree.walk();
    let statements = tree.root_node().children(&mut cursor).filter(|n| n.kind() == "statement");
    statements.filter_map(body).map(|body| (body.kind().to_owned(), body.byte_range())).collect()
}

fn body(statement: Node<'_>) -> Option<Node<'_>> {
    let parts = (0..statement.named_child_count() as u32).filter_map(|i| statement.named_child(i));
    parts.into_iter().find(|n| !n.is_extra() && n.kind() != "requirement")
}

/// Whether a reserved word stands on the line after a `.`. The front end takes it for the next statement, as one has it
/// while typing; tree-sitter, which does not look at line ends, for a property.
fn has_late_property(text: &str) -> bool {
    let tokens: Vec<_> = lex(text).into_iter().filter(|t| !t.kind.is_trivia()).collect();
    tokens.windows(2).any(|pair| {
        let gap = &text[pair[0].range.end as usize..pair[1].range.start as usize];
        pair[0].kind == Kind::Dot
            && has_line_break(gap)
            && pair[1].kind.row().spellings.iter().any(|s| s.starts_with(char::is_alphabetic))
    })
}

/// What is wrong with the tree of a text, if something is.
fn difference(text: &str) -> Option<String> {
    if has_huge_number(text) || has_late_property(text) {
        return None;
    }
    let tree = parse(text);
    if tree.root_node().has_error() == is_well_formed(text) {
        return Some(format!("{text}\n{}", tree.root_node().to_sexp()));
    }
    let (ours, theirs) = (ours(text), theirs(&tree));
    (!tree.root_node().has_error() && ours != theirs).then(|| format!("{text}\n{ours:?}\n{theirs:?}"))
}

fn agree(programs: &[Program]) {
    let wrong: Vec<String> =
        programs.iter().filter_map(|p| difference(&p.text).map(|found| format!("{}: {found}", p.name))).collect();
    assert!(wrong.is_empty(), "{} of {}:\n{}", wrong.len(), programs.len(), wrong.join("\n"));
}

#[test]
fn written_programs_parse_alike() {
    agree(&written());
}

#[test]
fn programs_of_the_book_parse_alike() {
    let book = book();
    assert!(book.len() > 200 && book.iter().filter(|p| !is_well_formed(&p.text)).count() > 20);
    agree(&book);
}

#[test]
fn sentences_of_the_grammar_parse_alike() {
    agree(&made(2000));
}

/// An error costs its own statement and no other. (A string that does not close is the exception: where it should have
/// ended, tree-sitter guesses.)
#[test]
fn statements_beside_an_error_are_found() {
    let mut kept = 0;
    for Program { name, text } in book() {
        let parsed = parse_file(&text);
        let errors: Vec<TextRange> =
            parsed.diagnostics.iter().filter(|d| d.is_error()).map(|d| d.primary.as_ref().unwrap().place).collect();
        if errors.is_empty() || lex(&text).iter().any(|t| t.kind == Kind::OpenStr) {
            continue;
        }
        let theirs = theirs(&parse(&text));
        for (offset, stmt) in &parsed.statements {
            let place = stmt.range.shifted(*offset);
            // A `;` that is missing is reported behind the statement.
            let is_bad = errors.iter().any(|e| e.start <= place.end + 1 && e.end >= place.start);
            if is_bad || kind(stmt).is_empty() {
                continue;
            }
            let found = theirs.contains(&(kind(stmt).to_owned(), place.bytes()));
            assert!(found, "{name}: `{}` is not found in\n{text}", &text[place.bytes()]);
            kept += 1;
        }
    }
    assert!(kept > 30, "only {kept}");
}

/// Nodes are named as the rules of the book's grammar, as far as those make nodes.
#[test]
fn nodes_are_rules_of_the_book() {
    const OWN: [&str; 18] = [
        "block_comment",
        "documentation",
        "element",
        "escape",
        "filter",
        "identifier",
        "line_comment",
        "number",
        "objects",
        "own",
        "parameters",
        "parenthesized",
        "string",
        "truth",
        "unit",
        "value",
        "formula",
        "call",
    ];
    let path = root().join("editors/tree-sitter-scenelang/src/node-types.json");
    let types: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let rules: BTreeSet<String> =
        ["grammar.md", "lexical.md"].iter().flat_map(|p| ebnf::of_page(p)).map(|(n, _)| n).collect();
    let named = types.as_array().unwrap().iter().filter(|t| t["named"] == true).map(|t| t["type"].as_str().unwrap());
    let nodes: BTreeSet<&str> = named.collect();
    let unknown: Vec<_> = nodes.iter().filter(|n| !rules.contains(**n) && !OWN.contains(n)).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
}

/// Every node lies in its parent, behind the one before it, and the whole covers the text.
fn check_places(node: Node<'_>) {
    let mut at = node.start_byte();
    for i in 0..node.child_count() {
        let child = node.child(i).unwrap();
        assert!(child.start_byte() >= at && child.end_byte() <= node.end_byte());
        at = child.end_byte();
        check_places(child);
    }
}

proptest! {
    #[test]
    fn programs_with_comments_anywhere_parse_alike(text in soup::program()) {
        prop_assert_eq!(difference(&text), None);
    }
    /// A token is lost, or another one stands in its place.
    #[test]
    fn nearly_right_programs_parse_alike(text in soup::program(), at: prop::sample::Index, by: Option<prop::sample::Index>) {
        let tokens: Vec<_> = lex(&text).into_iter().filter(|t| !t.kind.is_trivia()).collect();
        if tokens.is_empty() {
            return Ok(());
        }
        let place = tokens[at.index(tokens.len())].range.bytes();
        let other = by.map_or("", |by| &text[tokens[by.index(tokens.len())].range.bytes()]);
        let text = format!("{} {other} {}", &text[..place.start], &text[place.end..]);
        prop_assert_eq!(difference(&text), None);
    }
    /// What is parsed again after an edit is what is parsed from the start.
    #[test]
    fn edits_lead_to_the_same_tree(before in soup::program(), at: prop::sample::Index, new in soup::soup()) {
        let boundaries: Vec<usize> = before.char_indices().map(|(i, _)| i).chain([before.len()]).collect();
        let (start, end) = (boundaries[at.index(boundaries.len())], before.len());
        let end = end.min(start + lex(&before[start..]).first().map_or(0, |t| t.range.end as usize));
        let after = format!("{}{new}{}", &before[..start], &before[end..]);
        let mut tree = parse(&before);
        tree.edit(&InputEdit {
            start_byte: start,
            old_end_byte: end,
            new_end_byte: start + new.len(),
            start_position: point(&before, start),
            old_end_position: point(&before, end),
            new_end_position: point(&after, start + new.len()),
        });
        let again = parser().parse(&after, Some(&tree)).unwrap();
        prop_assert_eq!(again.root_node().to_sexp(), parse(&after).root_node().to_sexp());
    }
    #[test]
    fn soup_parses_alike(text in soup::soup()) {
        let tree = parse(&text);
        prop_assert_eq!(tree.root_node().end_byte(), text.len());
        check_places(tree.root_node());
        prop_assert_eq!(difference(&text), None);
    }
}
