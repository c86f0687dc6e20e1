//! From a file of a workspace to what is said of it: its settings, how it is judged by them, what is silenced, and the
//! verdict. The command line and the language server ask here, so that they cannot differ.
//!
//! Absent here: how a verdict is shown, and when it is asked for.

mod judge;
pub mod permissions;
mod settings;

pub use judge::{Question, judge, proofs, silence};
pub use settings::{FileSettings, Judging};
