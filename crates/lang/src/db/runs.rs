//! From a file's text to runs of statements, and what each run says, places relative to the run.

use crate::chunk::{Chunks, cut};
use crate::lint::allow::Allowances;
use crate::parse::{ParsedFile, parse_run};
use rustc_hash::FxBuildHasher;
use std::hash::BuildHasher;

/// A file of the program.
#[salsa::input]
pub(crate) struct File {
    #[returns(deref)]
    pub text: String,
    /// Whether it is a file of the library that was imported: what the program defines itself counts instead of it.
    #[returns(copy)]
    pub bundled: bool,
}

/// The files of the program: the main one, then the imported ones in the order met.
#[salsa::input(singleton)]
pub(crate) struct Sources {
    #[returns(deref)]
    pub files: Vec<File>,
    /// Whether only the core language is accepted.
    #[returns(copy)]
    pub core: bool,
}

/// Some statements that follow each other, and the blanks and comments between them.
#[salsa::interned]
pub(crate) struct Run<'db> {
    #[returns(deref)]
    pub text: String,
}

/// A statement ends its run if a hash of it falls into one of so many classes: a run has as many statements on average.
/// Fewer cost more bookkeeping in large files, more cost more checking after an edit.
const CLASSES: u64 = 8;
/// No run has more statements.
const LONGEST: usize = 32;

/// The runs of a file and where they begin (bytes).
#[salsa::tracked]
pub(crate) fn placed_runs<'db>(db: &'db dyn salsa::Database, file: File) -> Vec<(u32, Run<'db>)> {
    let text = file.text(db);
    let Chunks { chunks, .. } = cut(text);
    let mut out = Vec::with_capacity(chunks.len() / CLASSES as usize + 1);
    let mut first = 0;
    for (i, chunk) in chunks.iter().enumerate() {
        let ends = FxBuildHasher.hash_one(&text[chunk.range.bytes()]).is_multiple_of(CLASSES);
        if ends || i + 1 - first == LONGEST || i + 1 == chunks.len() {
            let start = chunks[first].range.start;
            let run = &text[start as usize..chunk.range.end as usize];
            out.push((start, Run::new(db, run)));
            first = i + 1;
        }
    }
    out
}

/// The comments of a file that silence something.
#[salsa::tracked]
pub(crate) fn allowances(db: &dyn salsa::Database, file: File) -> Allowances {
    Allowances::of(file.text(db))
}

/// The statements of a run. Its text never changes, so there is nothing to compare.
#[salsa::tracked(no_eq)]
pub(crate) fn parsed<'db>(db: &'db dyn salsa::Database, run: Run<'db>) -> ParsedFile {
    let mut parsed = parse_run(run.text(db));
    // It is kept: a tree of a large file would take a third more.
    parsed.statements.shrink_to_fit();
    parsed
}
