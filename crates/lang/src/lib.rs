//! ScenethesisLang: text → tokens → statements → names → types → a [`program::Program`] of constraints.
//!
//! Absent here: layouts, geometry, evaluation, rendering of diagnostics.

pub mod ast;
pub mod program;
