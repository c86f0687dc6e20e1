//! What an editor asks about a program: every answer is a pure function of a [`Snapshot`], that is of the program's text,
//! its layout, and how that is judged. Places are bytes of files.
//!
//! Absent here: the protocol, threads, files, and any search for a better layout.

pub mod diagnostics;
mod host;
pub mod names;

pub use host::{Compiled, Host, Judged, Judging, LayoutFile, Snapshot};
pub use scenelang_lang::db::Cancelled;
