//! What an editor asks about a program: every answer is a pure function of a [`Snapshot`], that is of the program's text,
//! its layout, and how that is judged. Places are bytes of files.
//!
//! Absent here: the protocol, threads, files, and any search for a better layout.

pub mod across;
pub mod actions;
pub mod calls;
pub mod colors;
pub mod completion;
mod conjuncts;
pub mod diagnostics;
mod facts;
pub mod format;
pub mod forms;
pub mod hints;
mod host;
pub mod hover;
pub mod keywords;
pub mod moving;
pub mod names;
pub mod navigate;
pub mod rename;
pub mod shape;
pub mod signature;
pub mod spoken;
pub mod symbols;
pub mod tokens;

pub use host::{Compiled, Host, Judged, LayoutFile, Snapshot};
pub use scenelang_lang::db::Cancelled;
