//! The incremental front end: what is known of a program, kept up to date while its text is edited.
//!
//! Statements are identified by their content. A file is cut into statements and these into *runs* of a few
//! statements each, the borders chosen by content too, so that an edit changes one run and leaves all others what they
//! were. What is said of a run speaks of places relative to it; nothing is said again because text above it moved.
//!
//! ```text
//! text ──► runs ──► parsed ──► heads ──► outline ──► names ──► facts of a name
//!            │         │                                              │
//!            │         └──────────────────► checked ◄─────────────────┘
//!            └──► where the runs stand: only the list of diagnostics asks
//! ```
//!
//! `facts` is the fire wall: a declaration that is added changes `names`, but only who uses that name is checked again.
//! [`Analysis`] is the way in; [`crate::compile`] uses it once, an editor after each keystroke.

mod analysis;
mod checked;
mod names;
mod reader;
mod runs;

pub use analysis::Analysis;
pub(crate) use analysis::Unit;
pub(crate) use names::{At, NameTable};

use std::panic::UnwindSafe;

/// Is told the name of every query that runs.
type Observer = Box<dyn Fn(&str) + Send + Sync>;

/// The storage of all queries. A clone is a second handle for another thread; a change waits until the readers have
/// noticed it, which takes well under a millisecond: they leave with [`Cancelled`].
#[salsa::db]
#[derive(Clone)]
pub(crate) struct Database {
    storage: salsa::Storage<Self>,
}

#[salsa::db]
impl salsa::Database for Database {}

impl Database {
    /// A database without anything in it.
    fn new(observer: Option<Observer>) -> Self {
        let callback = observer.map(|observer| -> Box<dyn Fn(salsa::Event) + Send + Sync> {
            Box::new(move |event| {
                if let salsa::EventKind::WillExecute { database_key } = event.kind {
                    observer(&format!("{database_key:?}"));
                }
            })
        });
        Self { storage: salsa::Storage::new(callback) }
    }
}

/// The text changed while it was being read: ask again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cancelled;

/// Runs a reader, which a change of the text stops.
///
/// # Errors
/// [`Cancelled`], if that happened.
pub(crate) fn cancellable<T>(reader: impl FnOnce() -> T + UnwindSafe) -> Result<T, Cancelled> {
    salsa::Cancelled::catch(reader).map_err(|_| Cancelled)
}
