//! What the checker says of each run.

#![allow(missing_docs, reason = "the macros of salsa make items that take no documentation")]

use super::names::KnownNames;
use super::runs::{Run, Sources, parsed};
use crate::check::{self, Where};
use crate::hir::{self, Hir};
use crate::lint;
use crate::parse::core;
use scenelang_base::Diagnostic;

/// Findings of the checker and warnings about single statements, each with the number of its statement in the run.
#[salsa::tracked]
pub(crate) fn checked<'db>(db: &'db dyn salsa::Database, run: Run<'db>) -> Vec<(u32, Diagnostic<Where>)> {
    let names = KnownNames(db);
    let core_only = Sources::get(db).core(db);
    let mut out = Vec::new();
    for ((_, stmt), i) in parsed(db, run).statements.iter().zip(0..) {
        let mut found = check::statement(&names, stmt);
        if core_only {
            found = core::check(stmt, found);
        }
        if !found.iter().any(Diagnostic::is_error) {
            found.extend(lint::statement(&names, stmt));
        }
        out.extend(found.into_iter().map(|d| (i, d)));
    }
    out
}

/// What each statement of a run says of names and texts. It depends on the run alone, so there is nothing to compare.
#[salsa::tracked(no_eq)]
pub(crate) fn summaries<'db>(db: &'db dyn salsa::Database, run: Run<'db>) -> Vec<lint::Uses> {
    parsed(db, run).statements.iter().map(|(_, stmt)| lint::uses(stmt)).collect()
}

/// What the statements of a run mean.
#[salsa::tracked]
pub(crate) fn meanings<'db>(db: &'db dyn salsa::Database, run: Run<'db>) -> Vec<Hir> {
    let names = KnownNames(db);
    parsed(db, run).statements.iter().map(|(_, stmt)| hir::statement(&names, stmt)).collect()
}
