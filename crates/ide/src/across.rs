//! A name beyond the program that it is asked about in: other programs that read the file of its declaration name it too.

use crate::Snapshot;
use crate::names::{Role, Symbol, name_at};
use crate::{navigate, rename};
use scenelang_base::{Edit, FileId, Span, TextRange};
use scenelang_lang::db::Cancelled;
use scenelang_lang::hir::Meanings;
use scenelang_lang::sources::normal;
use std::path::{Path, PathBuf};

/// What other programs may name: what it is, and where it is declared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shared {
    symbol: Symbol,
    name: String,
    /// The file of its declaration.
    pub path: PathBuf,
    place: TextRange,
}

/// What is named at an offset of the main file, if it is declared in the program and not in one statement only.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn shared(snapshot: &Snapshot, offset: u32) -> Result<Option<Shared>, Cancelled> {
    let Some(found) = name_at(snapshot, snapshot.main(), offset)? else { return Ok(None) };
    let place = declaration(&snapshot.meanings()?, &found.symbol);
    Ok(place.map(|span| Shared {
        symbol: found.symbol,
        name: snapshot.slice(span).to_owned(),
        path: normal(snapshot.sources().get(span.file).path()),
        place: span.range,
    }))
}

impl Shared {
    /// Whether a program reads the file of the declaration.
    pub fn is_read_by<'a>(&self, mut files: impl Iterator<Item = &'a Path>) -> bool {
        files.any(|file| normal(file) == self.path)
    }

    /// Where another program names it.
    ///
    /// # Errors
    /// [`Cancelled`]: the text has changed.
    pub fn references(&self, other: &Snapshot, declaration: bool) -> Result<Vec<(Span, Role)>, Cancelled> {
        match self.file_in(other)? {
            Some(file) => navigate::references(other, file, &self.symbol, declaration),
            None => Ok(Vec::new()),
        }
    }

    /// Edits that give it another name in another program and its layout; or why not, in a sentence.
    ///
    /// # Errors
    /// [`Cancelled`]: the text has changed.
    pub fn rename(&self, other: &Snapshot, new: &str) -> Result<Result<Vec<Edit>, String>, Cancelled> {
        match self.file_in(other)? {
            Some(file) => rename::edits(other, file, &self.symbol, &self.name, new),
            None => Ok(Ok(Vec::new())),
        }
    }

    /// The file of the declaration among those of a program, if the name means the same there.
    fn file_in(&self, other: &Snapshot) -> Result<Option<FileId>, Cancelled> {
        let found = declaration(&other.meanings()?, &self.symbol);
        let same = |span: &Span| span.range == self.place && normal(other.sources().get(span.file).path()) == self.path;
        Ok(found.filter(same).map(|span| span.file))
    }
}

/// Where a program declares something that all of its files know.
fn declaration(meanings: &Meanings<'_>, symbol: &Symbol) -> Option<Span> {
    match symbol {
        Symbol::Item(name, _) => meanings.declared.get(name).copied(),
        Symbol::Predicate(name) => meanings.defined.get(name).copied(),
        _ => None,
    }
}
