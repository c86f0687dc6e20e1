//! Stage I: from a request in plain words to a program.
//!
//! ```text
//! request ──read──▶ Brief ──complete──▶ Brief ──compose──┐    the English reader: no model, no network
//!                                                        ├──▶ Draft ──write──▶ room.scene
//! request ──model────────────────────────────────────────┘    a language model asked step by step, as published
//! ```
//!
//! A [`Brief`] says what is asked for: rooms, things and facts, each with the words it came from. `read` knows words
//! and no statements, `compose` statements and no words. A [`Draft`] has the names and statements of the program, and
//! what was not understood. [`write`](write::write) turns it into the text of a program.

pub mod arrange;
pub mod brief;
pub mod colors;
mod complete;
mod compose;
pub mod draft;
pub mod formalize;
mod furnish;
pub mod model;
pub mod names;
pub mod prefer;
pub mod read;
mod reconcile;
mod sizes;
mod storey;
pub mod text;
pub mod write;

pub use arrange::arrange_rooms;
pub use brief::Brief;
pub use draft::Draft;
pub use formalize::{Formalized, formalize, of_draft, with_model};
pub use furnish::overfull;
pub use read::{Options, Reading, as_said, brief as read_brief, of_brief, read};
