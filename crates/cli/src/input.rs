//! Programs from files or from standard input.

use scenelang_base::door::{Door, MOST};
use scenelang_base::{FileId, SourceMap};
use scenelang_lang::ast::StmtKind;
use scenelang_lang::parse::parse_file;
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

/// A path or an argument as it is written in a shell: quoted, if it has blanks or signs in it.
pub fn quoted(argument: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "._-/\\:+,@%=".contains(c);
    match argument.chars().all(is_plain) && !argument.is_empty() {
        true => argument.to_owned(),
        false if argument.contains('"') => format!("'{argument}'"),
        false => format!("\"{argument}\""),
    }
}

/// Whether a text is a program, or a broken one, rather than a request in words.
pub fn is_program(text: &str) -> bool {
    let parsed = parse_file(text);
    let (mut sound, mut broken) = (0, 0);
    for (_, statement) in &parsed.statements {
        match statement.kind {
            StmtKind::Error => broken += 1,
            StmtKind::Empty => {}
            _ => sound += 1,
        }
    }
    // Sentences with a semicolon may parse, too: no request assigns, declares or asserts.
    let states = |line: &str| {
        let line = line.trim();
        line.ends_with(';') && ["object ", "region ", "assert "].iter().any(|word| line.starts_with(word))
    };
    text.contains(';') && sound > broken && (text.contains("<-") || text.lines().any(states))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arguments_with_blanks_are_quoted() {
        for (argument, written) in [("a/b.scene", "a/b.scene"), ("my room.scene", "\"my room.scene\""), ("", "\"\"")] {
            assert_eq!(quoted(argument), written);
        }
    }

    #[test]
    fn a_program_is_no_request() {
        for program in ["region room;", "object a; assert near(a, b, 1);", "object a; object b; assert near(a b, 1);"] {
            assert!(is_program(program), "{program}");
        }
        for request in
            ["a bedroom with a bed", "A bedroom; a bed, and a lamp.", "", "Put two chairs; they face a table;"]
        {
            assert!(!is_program(request), "{request}");
        }
    }
}
