//! ScenethesisLang: text → tokens → statements → names → types → a [`program::Program`] of constraints.
//!
//! Absent here: layouts, geometry, evaluation, rendering of diagnostics.

pub mod ast;
pub mod check;
pub mod chunk;
pub mod compile;
pub mod db;
pub mod fixes;
pub mod fmt;
pub mod hir;
pub mod items;
pub mod library;
pub mod lint;
pub mod lower;
pub mod natives;
pub mod nouns;
pub mod opening;
pub mod overlaps;
pub mod parse;
pub mod print;
pub mod program;
pub mod roles;
pub mod solids;
pub mod sources;
pub mod syntax;
pub mod token;
pub mod types;
pub mod wording;

pub use compile::{Compiled, Options, compile_file, compile_main, compile_text, compile_with};
pub use program::Program;
