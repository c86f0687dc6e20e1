//! What has to be written anew where files get other names.

use scenelang_base::{Edit, TextRange};
use scenelang_ide::moving::{Moves, imports, program};
use std::path::{Path, PathBuf};

fn after(text: &str, edits: &[Edit<TextRange>]) -> String {
    let mut out = text.to_owned();
    for edit in edits.iter().rev() {
        out.replace_range(edit.place.bytes(), &edit.text);
    }
    out
}

/// `from → to`, the file with the import, what it says, and what it says afterwards.
#[test]
fn imports_lead_where_they_led() {
    for (from, to, file, before, wanted) in [
        ("/w/parts.scene", "/w/pieces.scene", "/w/a.scene", "parts.scene", "pieces.scene"),
        ("/w/parts.scene", "/w/b/parts.scene", "/w/a.scene", "parts.scene", "b/parts.scene"),
        ("/w/parts.scene", "/w/b/parts.scene", "/w/b/a.scene", "../parts.scene", "parts.scene"),
        ("/w/a.scene", "/w/b/a.scene", "/w/a.scene", "parts.scene", "../parts.scene"),
        // Both go, and are to each other what they were.
        ("/w", "/v", "/w/a.scene", "parts.scene", "parts.scene"),
        ("/w/b", "/w/c", "/w/a.scene", "b/parts.scene", "c/parts.scene"),
        ("/w/b", "/w/c/d", "/w/b/a.scene", "../parts.scene", "../../parts.scene"),
        // Neither goes; nor does a part of a name count as a folder.
        ("/w/x.scene", "/w/y.scene", "/w/a.scene", "parts.scene", "parts.scene"),
        ("/w/part", "/w/y", "/w/a.scene", "parts.scene", "parts.scene"),
        // What is in the library, or nowhere, is not a file that could go.
        ("/w/a.scene", "/w/b/a.scene", "/w/a.scene", "std/guidelines.scene", "std/guidelines.scene"),
    ] {
        let moves = Moves(vec![(PathBuf::from(from), PathBuf::from(to))]);
        let there = |path: &Path| path.ends_with("parts.scene");
        let text = format!("// first\nimport \"{before}\";\nobject a;\n");
        let found = after(&text, &imports(Path::new(file), &text, &moves, &there));
        assert_eq!(found, text.replace(before, wanted), "{from} → {to} in {file}");
    }
}

#[test]
fn a_layout_says_where_its_program_is() {
    let moves = Moves(vec![("/w/a.scene".into(), "/w/b \"x\".scene".into())]);
    let text = "{\"format\": \"scenelang.layout/1\", \"scene\": \"a.scene\"}";
    let edit = program(Path::new("/w/a.layout.json"), text, &moves, &|_| true).unwrap();
    assert_eq!(after(text, &[edit]), text.replace("a.scene", "b \\\"x\\\".scene"));
    assert_eq!(program(Path::new("/v/a.layout.json"), text, &moves, &|_| true), None);
    assert_eq!(program(Path::new("/w/a.layout.json"), "{", &moves, &|_| true), None);
}
