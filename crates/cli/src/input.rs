//! Programs from files or from standard input.

use scenelang_base::door::{Door, MOST};
use scenelang_base::{FileId, SourceMap};
use scenelang_lang::sources::{decode, plain};
use std::io::Read;
use std::path::Path;

/// Whether a path stands for standard input.
pub fn is_stdin(path: &Path) -> bool {
    path == Path::new("-")
}

/// How a file is called in messages.
pub fn name_of(path: &Path) -> String {
    if is_stdin(path) { "<stdin>".to_owned() } else { path.display().to_string() }
}

/// Reads a program; `-` is standard input.
///
/// # Errors
/// A sentence: there is no such file, or it is no text.
pub fn read(path: &Path) -> Result<(SourceMap, FileId), String> {
    let name = name_of(path);
    let bytes = if is_stdin(path) {
        let mut bytes = Vec::new();
        // One byte more than is taken, so that it is refused as too large and not cut.
        std::io::stdin().take(MOST + 1).read_to_end(&mut bytes).map(|_| bytes)
    } else {
        Door::of(path).read(path)
    };
    let bytes = bytes.map_err(|e| format!("cannot read {name}: {}", plain(&e)))?;
    let mut sources = SourceMap::new();
    let id = decode(&name, path, bytes, &mut sources).map_err(|refused| refused.1.message)?;
    Ok((sources, id))
}
