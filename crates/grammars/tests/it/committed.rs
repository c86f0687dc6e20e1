//! What is committed under `editors/` is what is made.

use crate::programs::root;
use serde_json::Value;
use std::process::Command;
use std::{env, fs};

#[test]
fn the_committed_grammars_are_those_that_are_made() {
    let mut stale = Vec::new();
    for (path, text) in scenelang_grammars::files().unwrap() {
        if fs::read_to_string(root().join(&path)).unwrap_or_default() != text {
            stale.push(path);
        }
    }
    assert!(stale.is_empty(), "run ./x grammars: {} would change", stale.join(", "));
}

/// People read and may run `grammar.js`; the parser is made from `grammar.json`.
#[test]
fn both_forms_of_the_grammar_say_the_same() {
    let folder = root().join("editors/tree-sitter-scenelang");
    if !Command::new("node").arg("--version").output().is_ok_and(|o| o.status.success()) {
        assert!(env::var("CI").as_deref() != Ok("true"), "in CI nothing may be skipped: no Node");
        eprintln!("skipped: grammar.js not run, no Node");
        return;
    }
    let run = tree_sitter_generate::load_grammar_file(&folder.join("grammar.js"), Some("node")).unwrap();
    let made: Value = serde_json::from_str(&run).unwrap();
    let committed: Value = serde_json::from_str(&fs::read_to_string(folder.join("src/grammar.json")).unwrap()).unwrap();
    assert_eq!(made, committed);
}
