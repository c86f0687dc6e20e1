//! What the checker says of each run.

#![allow(missing_docs, reason = "the macros of salsa make items that take no documentation")]

use super::names::KnownNames;
use super::runs::{Run, parsed};
use crate::check::{self, Where};
use crate::hir::{self, Hir};
use crate::parse::core::check_core;
use scenelang_base::Diagnostic;

/// Findings of the checker, each with the number of its statement in the run.
#[salsa::tracked]
pub(crate) fn checked<'db>(db: &'db dyn salsa::Database, run: Run<'db>) -> Vec<(u32, Diagnostic<Where>)> {
    let names = KnownNames(db);
    let statements = &parsed(db, run).statements;
    let found = statements.iter().zip(0..).flat_map(|((_, stmt), i)| {
        let found = check::statement(&names, stmt);
        found.into_iter().map(move |d| (i, d))
    });
    found.collect()
}

/// What the statements of a run mean.
#[salsa::tracked]
pub(crate) fn meanings<'db>(db: &'db dyn salsa::Database, run: Run<'db>) -> Vec<Hir> {
    let names = KnownNames(db);
    parsed(db, run).statements.iter().map(|(_, stmt)| hir::statement(&names, stmt)).collect()
}

/// What of a run is outside the core language.
#[salsa::tracked]
pub(crate) fn core_checked<'db>(db: &'db dyn salsa::Database, run: Run<'db>) -> Vec<(u32, Diagnostic<Where>)> {
    let statements = &parsed(db, run).statements;
    let found = statements
        .iter()
        .zip(0..)
        .flat_map(|((_, stmt), i)| check_core(stmt).into_iter().map(move |d| (i, d.map_places(Where::Here))));
    found.collect()
}
