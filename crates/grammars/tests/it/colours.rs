//! The colours that `highlights.scm` gives are those of the table of tokens, byte by byte.

use crate::programs::{Program, book, is_well_formed, made, root, written};
use crate::soup;
use crate::tree::parse;
use proptest::prelude::*;
use scenelang_grammars::style::style;
use scenelang_lang::parse::read_tokens;
use scenelang_lang::token::{Class, Token, UNITS};
use std::fs;
use std::sync::LazyLock;
use tree_sitter::{Query, QueryCursor, StreamingIterator};

/// A query of the grammar.
fn query(name: &str) -> Query {
    let path = root().join("editors/tree-sitter-scenelang/queries").join(name);
    Query::new(&scenelang_grammars::language(), &fs::read_to_string(path).unwrap()).unwrap()
}

/// What the query says of each byte. Of several patterns for a node the last one counts, and of several nodes the
/// innermost.
fn colours(text: &str) -> Vec<&'static str> {
    static HIGHLIGHTS: LazyLock<Query> = LazyLock::new(|| query("highlights.scm"));
    let tree = parse(text);
    let mut cursor = QueryCursor::new();
    let mut captures = Vec::new();
    let mut matches = cursor.matches(&HIGHLIGHTS, tree.root_node(), text.as_bytes());
    while let Some(found) = matches.next() {
        let own = found.captures().iter();
        captures.extend(
            own.map(|c| (c.node.byte_range(), found.pattern_index, HIGHLIGHTS.capture_names()[c.index as usize])),
        );
    }
    captures.sort_by_key(|(bytes, pattern, _)| (bytes.start, usize::MAX - bytes.end, *pattern));
    let mut out = vec![""; text.len()];
    for (bytes, _, name) in captures {
        out[bytes].fill(name);
    }
    out
}

/// Whether a token of this class may have this colour.
fn fits(class: Class, token: &str, colour: &str) -> bool {
    const NAMES: [&str; 7] = [
        "variable",
        "variable.member",
        "variable.parameter",
        "property",
        "function",
        "function.call",
        "function.builtin",
    ];
    match class {
        Class::Name => NAMES.contains(&colour),
        Class::Text => colour == "string" || colour == "string.escape" || colour == "string.special.path",
        Class::Logic if !token.starts_with(char::is_alphabetic) => colour == "operator",
        _ => colour == style(class).capture,
    }
}

/// The first token whose colour is not that of its class.
fn miscoloured(text: &str) -> Option<String> {
    let colours = colours(text);
    for Token { kind, range } in read_tokens(text) {
        let token = &text[range.bytes()];
        let mut bytes = range.bytes();
        if kind.class() == Class::Number {
            // A unit is a token of its own there.
            let unit = UNITS.iter().filter(|u| token.ends_with(*u)).map(|u| u.len()).max().unwrap_or(0);
            let unit = bytes.end - unit..bytes.end;
            bytes.end = unit.start;
            if colours[unit].iter().any(|c| *c != "type") {
                return Some(format!("the unit of `{token}`"));
            }
        }
        if let Some(wrong) = colours[bytes].iter().find(|c| !fits(kind.class(), token, c)) {
            return Some(format!("`{token}` ({kind:?}) is `{wrong}`"));
        }
    }
    None
}

#[test]
fn every_byte_has_the_colour_of_its_class() {
    for Program { name, text } in written().into_iter().chain(book()).chain(made(500)) {
        if is_well_formed(&text) {
            assert_eq!(miscoloured(&text), None, "{name}\n{text}");
        }
    }
}

#[test]
fn the_languages_own_names_are_known() {
    let text = "assert near(a.pos, inside(b, c)) and mine(lamp.mine, rot(1, 2, 3)) and forall x in objects: x;";
    let colours = colours(text);
    let of = |word: &str| colours[text.find(word).unwrap()];
    let expected = [
        ("near", "function.builtin"),
        ("pos", "property"),
        ("inside", "function.builtin"),
        ("mine(", "function.call"),
        ("mine,", "variable.member"),
        ("lamp", "variable"),
        ("rot", "function.builtin"),
        ("forall", "keyword"),
        ("x in", "variable.parameter"),
        ("objects", "constant.builtin"),
    ];
    for (word, colour) in expected {
        assert_eq!(of(word), colour, "{word}");
    }
}

#[test]
fn the_other_queries_fit_the_grammar() {
    assert_eq!(query("folds.scm").capture_names(), ["fold"]);
    assert_eq!(query("locals.scm").capture_names(), ["local.scope", "local.definition", "local.reference"]);
}

proptest! {
    #[test]
    fn words_have_the_colour_of_what_they_are_there(text in soup::program()) {
        prop_assert_eq!(miscoloured(&text), None);
    }
}
