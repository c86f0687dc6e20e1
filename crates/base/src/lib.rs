//! The ground floor: places in source text, the one diagnostic type with its table of codes, the one door to the disk,
//! and file writes that happen whole or not at all.
//!
//! Absent here: anything about scenes, and any rendering of diagnostics.

pub mod codes;
pub mod diagnostic;
pub mod door;
pub mod fix;
pub mod fs;
pub mod owned;
mod pages;
pub mod plain;
pub mod source;
pub mod suggest;

pub use codes::Code;
pub use diagnostic::{Applicability, Diagnostic, Edit, Fix, Label, Severity};
pub use source::{FileId, LineColumn, SourceFile, SourceMap, Span, TextRange};
