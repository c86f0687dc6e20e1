//! The grammars that editors colour programs by, made of the table of tokens (`scenelang_lang::token::TABLE`) and
//! committed under `editors/`: a TextMate grammar and a tree-sitter grammar with its queries. `./x grammars` makes them
//! anew; a test fails where one is not what would be made.
//!
//! | file | what it makes |
//! |---|---|
//! | `style` | what each class of tokens is called in themes of either kind |
//! | `textmate` | `scenelang.tmLanguage.json` and `language-configuration.json` |
//! | `syntax`, `rule` | the grammar for tree-sitter, and its two spellings `grammar.json` and `grammar.js` |
//! | `parser` | the parser in C, by tree-sitter's own generator |
//! | `queries` | `highlights.scm`, `locals.scm`, `folds.scm` |
//!
//! No part of the program; nothing but tests and benchmarks uses it.

mod parser;
mod queries;
mod rule;
pub mod style;
mod syntax;
mod textmate;

use serde_json::{Value, json};
use std::io;
use tree_sitter::Language;
use tree_sitter_language::LanguageFn;

/// The committed parser for tree-sitter.
pub fn language() -> Language {
    Language::new(LANGUAGE)
}

#[allow(unsafe_code, reason = "a function of the generated parser, and of the type that every such parser has")]
const LANGUAGE: LanguageFn = {
    unsafe extern "C" {
        fn tree_sitter_scenelang() -> *const ();
    }
    unsafe { LanguageFn::from_raw(tree_sitter_scenelang) }
};

const VS_CODE: &str = "editors/vscode";
const TREE_SITTER: &str = "editors/tree-sitter-scenelang";

/// Every file that is made: its path in the repository, and its text.
///
/// # Errors
/// If tree-sitter refuses the grammar, or the folder for temporary files cannot be written.
pub fn files() -> io::Result<Vec<(String, String)>> {
    let configuration = pretty(&tree_sitter_json())?;
    let head = "/// <reference types=\"tree-sitter-cli/dsl\" />\n\
        // Made by `./x grammars` from the table of tokens.\n\
        // The rules are those of the reference, spec/src/reference/grammar.md.\n";
    let mut tree_sitter = parser::files(&configuration)?;
    tree_sitter.extend([
        ("grammar.js", syntax::grammar().js(head)),
        ("tree-sitter.json", configuration),
        ("package.json", pretty(&package_json())?),
        ("queries/highlights.scm", queries::highlights()),
        ("queries/locals.scm", queries::locals()),
        ("queries/folds.scm", queries::folds()),
    ]);
    let vs_code = [
        ("syntaxes/scenelang.tmLanguage.json", pretty(&textmate::grammar())?),
        ("language-configuration.json", pretty(&textmate::configuration())?),
    ];
    let below = |folder: &str, (path, text): (&str, String)| (format!("{folder}/{path}"), text);
    let vs_code = vs_code.into_iter().map(|file| below(VS_CODE, file));
    Ok(vs_code.chain(tree_sitter.into_iter().map(|file| below(TREE_SITTER, file))).collect())
}

fn pretty(value: &Value) -> io::Result<String> {
    Ok(serde_json::to_string_pretty(value).map_err(io::Error::other)? + "\n")
}

const DESCRIPTION: &str = "ScenethesisLang for tree-sitter";

/// What the tree-sitter CLI wants to know of the grammar.
fn tree_sitter_json() -> Value {
    json!({
        "$schema": "https://tree-sitter.github.io/tree-sitter/assets/schemas/config.schema.json",
        "grammars": [{
            "name": "scenelang",
            "camelcase": "Scenelang",
            "title": "ScenethesisLang",
            "scope": "source.scenelang",
            "path": ".",
            "file-types": ["scene"],
            "highlights": "queries/highlights.scm",
            "locals": "queries/locals.scm",
            "injection-regex": "^scene(lang)?$",
        }],
        "metadata": {
            "version": env!("CARGO_PKG_VERSION"),
            "license": env!("CARGO_PKG_LICENSE"),
            "description": DESCRIPTION,
            "links": { "repository": env!("CARGO_PKG_REPOSITORY") },
        },
        "bindings": { "c": false, "go": false, "node": false, "python": false, "rust": false, "swift": false },
    })
}

/// What npm wants to know: `grammar.js` is a module.
fn package_json() -> Value {
    json!({
        "name": "tree-sitter-scenelang",
        "version": env!("CARGO_PKG_VERSION"),
        "description": DESCRIPTION,
        "license": env!("CARGO_PKG_LICENSE"),
        "repository": env!("CARGO_PKG_REPOSITORY"),
        "type": "module",
        "main": "grammar.js",
        "files": ["grammar.js", "tree-sitter.json", "queries/*", "src/**"],
    })
}
