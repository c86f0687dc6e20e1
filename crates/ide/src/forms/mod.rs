//! What becomes of a program, to look at: its tree (`syntax`), what its names and expressions mean (`hir`), what its
//! statements become (`constraints`). Each as text for people, and as JSON.
//!
//! The JSON of each is described in the language book, `spec/src/reports.md`.

pub mod constraints;
mod formula;
pub mod hir;
pub mod syntax;
mod write;
