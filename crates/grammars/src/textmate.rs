//! The TextMate grammar, and what VS Code wants to know of a language beside its colours.
//!
//! Such a grammar is a list of regular expressions that are tried at every place of a line; it knows no statements. So
//! it tells a contextual word from a name by what stands behind it on the line, which an object called `where` can fool,
//! and `<-` is an arrow to it everywhere. What people write it gets right, see the tests.

use crate::style::{known_functions, known_properties, style};
use crate::syntax::{ESCAPE, is_word};
use scenelang_lang::token::{Class, Kind, TABLE, UNITS};
use serde_json::{Value, json};

/// The language, at the end of every scope.
const LANGUAGE: &str = "scenelang";

/// The end of a word.
const END: &str = r"(?!\p{XID_Continue})";

/// What stands behind a word that a value must follow: its beginning, or the end of the line. Infix words begin none.
/// `minus` is how a sign before the value looks.
fn before_value(minus: &str) -> String {
    let start = r#"$|//|/\*|["(0-9!¬\p{XID_Start}_]|\.[0-9]"#;
    let infix = [Kind::And, Kind::Or, Kind::Implies, Kind::Where, Kind::Weight, Kind::In].map(|kind| kind.row());
    let infix: Vec<&str> =
        infix.iter().flat_map(|r| r.spellings.iter().chain(r.words).copied()).filter(|s| is_word(s)).collect();
    format!(r"(?=[ \t]*(?:{start})|[ \t]+(?:{minus}|\.\S))(?![ \t]*{}{END})", any(&infix))
}

fn scope(name: &str) -> String {
    format!("{name}.{LANGUAGE}")
}

fn class_scope(class: Class) -> String {
    scope(style(class).scope)
}

fn pattern_of(kind: Kind) -> &'static str {
    kind.row().patterns[0]
}

/// A regular expression for one of several texts.
fn any(texts: &[&str]) -> String {
    let escaped: Vec<String> = texts.iter().map(|t| escaped(t)).collect();
    format!("(?:{})", escaped.join("|"))
}

fn escaped(text: &str) -> String {
    text.chars().fold(String::new(), |mut out, c| {
        if r".*+?()[]{}^$|\".contains(c) {
            out.push('\\');
        }
        out.push(c);
        out
    })
}

fn found(pattern: impl Into<String>, scope: impl Into<String>) -> Value {
    json!({ "match": pattern.into(), "name": scope.into() })
}

fn include(name: &str) -> Value {
    json!({ "include": format!("#{name}") })
}

/// `scenelang.tmLanguage.json`
pub fn grammar() -> Value {
    let parts =
        ["comments", "strings", "attributes", "numbers", "properties", "declarations", "words", "names", "signs"];
    json!({
        "information_for_contributors": ["Made by `./x grammars` from the table of tokens."],
        "name": "ScenethesisLang",
        "scopeName": scope("source"),
        "fileTypes": ["scene"],
        "patterns": parts.map(include),
        "repository": {
            "comments": { "patterns": comments() },
            "block-comment": block_comment(),
            "strings": { "patterns": strings() },
            "attributes": { "patterns": attributes() },
            "numbers": { "patterns": numbers() },
            "properties": { "patterns": properties() },
            "declarations": { "patterns": declarations() },
            "words": { "patterns": words() },
            "names": { "patterns": names() },
            "signs": { "patterns": signs() },
        },
    })
}

fn comments() -> Vec<Value> {
    let mark = |sign: &str| json!({ "1": { "name": scope(sign) } });
    vec![
        json!({
            "match": "(///)(?!/).*",
            "name": class_scope(Class::Documentation),
            "captures": mark("punctuation.definition.comment"),
        }),
        json!({
            "match": "(//).*",
            "name": scope("comment.line.double-slash"),
            "captures": mark("punctuation.definition.comment"),
        }),
        include("block-comment"),
    ]
}

/// Comments nest, so they include themselves.
fn block_comment() -> Value {
    json!({
        "begin": r"/\*",
        "end": r"\*/",
        "name": scope("comment.block"),
        "captures": { "0": { "name": scope("punctuation.definition.comment") } },
        "patterns": [include("block-comment")],
    })
}

fn strings() -> Vec<Value> {
    let mut all = vec![json!({
        "begin": "\"",
        "end": "(\")|$",
        "name": class_scope(Class::Text),
        "beginCaptures": { "0": { "name": scope("punctuation.definition.string.begin") } },
        "endCaptures": { "1": { "name": scope("punctuation.definition.string.end") } },
        "patterns": [
            found(ESCAPE, scope("constant.character.escape")),
            found(r"\\.?", scope("invalid.illegal.escape")),
        ],
    })];
    let odd = Kind::OddQuotes.row().patterns.iter();
    all.extend(odd.map(|quotes| found(*quotes, scope("invalid.illegal.quotes"))));
    all
}

fn attributes() -> Vec<Value> {
    let rows = TABLE.iter().filter(|r| r.class == Class::Attribute);
    let known = rows.flat_map(|r| r.spellings).map(|s| found(escaped(s) + END, class_scope(Class::Attribute)));
    known.chain([found(pattern_of(Kind::BadAttribute), scope("invalid.illegal.attribute"))]).collect()
}

fn numbers() -> Vec<Value> {
    let units = any(&UNITS);
    let good = format!(
        r"((?:[0-9]+(?:\.(?!\.)[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)({units})?(?!\p{{XID_Continue}}|\.[0-9])"
    );
    vec![
        json!({
            "match": good,
            "captures": { "1": { "name": class_scope(Class::Number) }, "2": { "name": scope("keyword.other.unit") } },
        }),
        found(r"\.?[0-9](?:[eE][+-]|\.(?!\.)|\p{XID_Continue})*", scope("invalid.illegal.number")),
    ]
}

/// `.name`; after `..` no property stands.
fn properties() -> Vec<Value> {
    let range = Kind::DotDot.row().spellings;
    let after = |name: String, kind: &str| {
        json!({
            "match": format!(r"(\.)[ \t]*({name})"),
            "captures": { "1": { "name": class_scope(Class::Accessor) }, "2": { "name": scope(kind) } },
        })
    };
    vec![
        found(any(range), class_scope(Class::Range)),
        after(any(&known_properties()) + END, "support.variable.property"),
        after(pattern_of(Kind::Ident).to_owned(), "variable.other.property"),
    ]
}

/// `object lamp`, `Number gap`, `predicate near`: what is named there is a name, whatever the word is elsewhere.
fn declarations() -> Vec<Value> {
    let named = |words: &[&str], class: Class, name: &str| {
        json!({
            "match": format!(r"({})[ \t]+({})", any(words), pattern_of(Kind::Ident)),
            "captures": { "1": { "name": class_scope(class) }, "2": { "name": scope(name) } },
        })
    };
    let reserved = |class: Class| -> Vec<&str> {
        TABLE.iter().filter(|r| r.class == class).flat_map(|r| r.spellings).copied().collect()
    };
    vec![
        named(&reserved(Class::Declaration), Class::Declaration, "variable.other.declaration"),
        named(&reserved(Class::Type), Class::Type, "variable.other.declaration"),
        named(Kind::Predicate.row().words, Class::Declaration, "entity.name.function"),
    ]
}

/// What must follow a contextual word that is none of the program's names.
fn behind(kind: Kind) -> String {
    let name = pattern_of(Kind::Ident);
    match kind {
        Kind::Prefer => r"(?!\()".to_owned() + &before_value("-"),
        // What is most likely to be a name as well: `weight - 1`.
        Kind::Weight => before_value(r"-\S"),
        Kind::Import => r#"(?=[ \t]*(?:"|$))"#.to_owned(),
        Kind::AllowFloat => r"(?=[ \t]*\()".to_owned(),
        Kind::Predicate => r"(?=[ \t]*$)".to_owned(),
        Kind::ParamType => format!(r"(?=[ \t]+{name})"),
        Kind::Forall | Kind::Exists => format!(r"(?=[ \t]+{name}[ \t]+in{END}|[ \t]+{name}[ \t]*$|[ \t]*$)"),
        Kind::Count => format!(r"(?=[ \t]*\([ \t]*(?:{name}[ \t]+in{END}|$))"),
        Kind::Objects => r"(?![ \t]*\()".to_owned(),
        _ => before_value("-"),
    }
}

fn words() -> Vec<Value> {
    let mut all = Vec::new();
    for row in TABLE {
        let reserved: Vec<&str> = row.spellings.iter().copied().filter(|s| is_word(s)).collect();
        if !reserved.is_empty() {
            all.push(found(any(&reserved) + END, class_scope(row.class)));
        }
        if !row.words.is_empty() {
            all.push(found(any(row.words) + END + &behind(row.kind), class_scope(row.class)));
        }
    }
    all
}

fn names() -> Vec<Value> {
    let call = r"(?=[ \t]*\()";
    vec![
        found(any(&known_functions()) + END + call, class_scope(Class::Function)),
        found(format!("{}{END}{call}", pattern_of(Kind::Ident)), scope("entity.name.function")),
        found(pattern_of(Kind::Ident), class_scope(Class::Name)),
    ]
}

/// Signs, the longest first; what is left then belongs to no token.
fn signs() -> Vec<Value> {
    let mut signs: Vec<(usize, Class, &str)> = Vec::new();
    for row in TABLE.iter().filter(|r| r.class != Class::Blank && r.class != Class::Attribute) {
        let own = row.spellings.iter().filter(|s| !is_word(s));
        signs.extend(own.map(|s| (usize::MAX - s.chars().count(), row.class, *s)));
    }
    signs.sort_by_key(|(shortness, class, _)| (*shortness, *class));
    let groups = signs.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1));
    let mut all: Vec<Value> = groups
        .map(|group| {
            let texts: Vec<&str> = group.iter().map(|(_, _, s)| *s).collect();
            found(any(&texts), class_scope(group[0].1))
        })
        .collect();
    all.push(found(r"[^ \t\r\n\f\x{FEFF}]", scope("invalid.illegal.character")));
    all
}

/// `language-configuration.json`
pub fn configuration() -> Value {
    let rows = TABLE.iter().filter(|r| r.class == Class::Bracket);
    let brackets: Vec<&str> = rows.flat_map(|r| r.spellings).copied().collect();
    let pairs: Vec<[&str; 2]> = brackets.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect();
    let quotes = ["\"", "\""];
    let closing = pairs.iter().map(|[open, close]| json!({ "open": open, "close": close }));
    let closing: Vec<Value> = closing
        .chain([
            json!({ "open": "\"", "close": "\"", "notIn": ["string", "comment"] }),
            json!({ "open": "/*", "close": " */", "notIn": ["string", "comment"] }),
        ])
        .collect();
    json!({
        "comments": { "lineComment": "//", "blockComment": ["/*", "*/"] },
        "brackets": pairs,
        "autoClosingPairs": closing,
        "surroundingPairs": pairs.iter().copied().chain([quotes]).collect::<Vec<_>>(),
        "wordPattern": { "pattern": pattern_of(Kind::Ident), "flags": "u" },
        "onEnterRules": [{
            "beforeText": r"^\s*///(?!/)",
            "action": { "indent": "none", "appendText": "/// " },
        }],
    })
}
