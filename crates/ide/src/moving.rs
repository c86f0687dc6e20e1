//! What has to be written anew where files get other names: paths of imports, and what a layout says its program is.

use crate::shape::program_of;
use scenelang_base::door::{normal, relative};
use scenelang_base::{Edit, TextRange};
use scenelang_lang::ast::StmtKind;
use scenelang_lang::parse::parse_file;
use std::path::{Path, PathBuf};

/// Files and folders with the paths that they get.
pub struct Moves(pub Vec<(PathBuf, PathBuf)>);

impl Moves {
    /// Where a file is afterwards.
    pub fn of(&self, path: &Path) -> PathBuf {
        let moved = |(from, to): &(PathBuf, PathBuf)| {
            let rest = path.strip_prefix(from).ok()?;
            // Joined to nothing a path would end in a separator.
            Some(if rest.as_os_str().is_empty() { to.clone() } else { to.join(rest) })
        };
        self.0.iter().find_map(moved).unwrap_or_else(|| path.to_owned())
    }

    /// Whether it is elsewhere afterwards.
    pub fn has(&self, path: &Path) -> bool {
        self.of(path) != path
    }

    /// The path of a file as seen from another, after the moves; `None`: what is written there still leads to it.
    fn seen(&self, file: &Path, written: &str, is_there: &dyn Fn(&Path) -> bool) -> Option<String> {
        let target = normal(&file.parent()?.join(written));
        let (after, there) = (self.of(file), self.of(&target));
        if after == file && there == target || !is_there(&target) {
            return None;
        }
        let seen = relative(&there, after.parent()?);
        (normal(&after.parent()?.join(written)) != there).then_some(seen)
    }
}

/// Edits of the imports of a program; `is_there`: whether a file is there before the moves.
pub fn imports(file: &Path, text: &str, moves: &Moves, is_there: &dyn Fn(&Path) -> bool) -> Vec<Edit<TextRange>> {
    let parsed = parse_file(text);
    let imports = parsed.statements.iter().filter_map(|(offset, stmt)| {
        let StmtKind::Import { path, range } = &stmt.kind else { return None };
        let range = range.shifted(*offset);
        let seen = moves.seen(file, path, is_there)?;
        // The quotation marks stay; a path without them has none to leave out.
        let quoted = text.get(range.bytes()).is_some_and(|t| t.len() > 1 && t.starts_with('"') && t.ends_with('"'));
        let place = if quoted { TextRange { start: range.start + 1, end: range.end - 1 } } else { range };
        Some(Edit { place, text: seen })
    });
    imports.collect()
}

/// The edit of what a layout says its program is.
pub fn program(file: &Path, text: &str, moves: &Moves, is_there: &dyn Fn(&Path) -> bool) -> Option<Edit<TextRange>> {
    let (place, written) = program_of(text)?;
    let seen = moves.seen(file, &written, is_there)?;
    let quoted = serde_json::Value::from(seen).to_string();
    Some(Edit { place, text: quoted.trim_matches('"').to_owned() })
}
