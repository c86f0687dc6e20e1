//! Commands that show what becomes of a program: its tree (`syntax`), what its names and expressions mean (`hir`), what
//! its statements become (`constraints`).
//!
//! The JSON of each is described in the language book, `spec/src/reports.md`.

mod constraints;
mod formula;
mod hir;
mod syntax;
mod write;

pub use constraints::run as constraints;
pub use hir::run as hir;
pub use syntax::run as syntax;

use crate::input;
use crate::solve::color_err;
use scenelang_base::{Diagnostic, FileId, SourceMap};
use scenelang_verify::report;
use std::fmt::Display;
use std::io::{BufWriter, Write};
use std::path::Path;

/// Reads the program, or says why not.
fn read(path: &Path) -> Option<(SourceMap, FileId)> {
    let read = input::read(path);
    read.map_err(|message| eprintln!("error: {message}")).ok()
}

/// Prints to standard output.
fn print(what: impl Display) {
    let mut out = BufWriter::new(std::io::stdout().lock());
    // A closed pipe is no reason to fail: whoever reads has seen enough.
    let _ = write!(out, "{what}").and_then(|()| out.flush());
}

/// Shows diagnostics on standard error; whether there is an error among them.
fn show(diagnostics: &[Diagnostic], sources: &SourceMap) -> bool {
    eprint!("{}", report::diagnostics(diagnostics, sources, color_err()));
    diagnostics.iter().any(Diagnostic::is_error)
}
