//! The parser in C, made by tree-sitter's own generator from `grammar.json`.

use crate::syntax::grammar;
use std::path::Path;
use std::{fs, io};
use tree_sitter_generate::{ABI_VERSION_MAX, OptLevel, generate_parser_in_directory};

/// The files of `editors/tree-sitter-scenelang` that make the parser, by their path there.
///
/// # Errors
/// If the grammar is none that tree-sitter takes, or the folder for temporary files cannot be written.
pub fn files(configuration: &str) -> io::Result<Vec<(&'static str, String)>> {
    const MADE: [&str; 5] = [
        "src/parser.c",
        "src/node-types.json",
        "src/tree_sitter/parser.h",
        "src/tree_sitter/alloc.h",
        "src/tree_sitter/array.h",
    ];
    let folder = tempfile::tempdir()?;
    let json = serde_json::to_string_pretty(&grammar().json()).map_err(io::Error::other)? + "\n";
    let source = folder.path().join("src/grammar.json");
    fs::create_dir(folder.path().join("src"))?;
    fs::write(&source, &json)?;
    // The generator takes the version of the grammar from here.
    fs::write(folder.path().join("tree-sitter.json"), configuration)?;
    generate(folder.path(), &source)?;
    let mut files = vec![("src/grammar.json", json)];
    for path in MADE {
        let text = fs::read_to_string(folder.path().join(path))?;
        files.push((path, if text.ends_with('\n') { text } else { text + "\n" }));
    }
    Ok(files)
}

fn generate(folder: &Path, source: &Path) -> io::Result<()> {
    let mut remarks = Vec::new();
    let made = generate_parser_in_directory(
        folder,
        None::<&Path>,
        Some(source),
        ABI_VERSION_MAX,
        None,
        None,
        true,
        OptLevel::default(),
        &mut remarks,
    );
    made.map_err(|e| io::Error::other(e.to_string()))?;
    match remarks.first() {
        None => Ok(()),
        Some(remark) => Err(io::Error::other(remark.to_string())),
    }
}
