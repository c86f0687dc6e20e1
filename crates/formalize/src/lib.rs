//! Stage I: from a request in plain words to a program.
//!
//! ```text
//! request ──read────┐                         the English reader: no model, no network
//!                   ├──▶ Draft ──write──▶ room.scene
//! request ──model───┘                         a language model asked step by step, as published
//! ```
//!
//! Both ways end in a [`Draft`]: rooms, openings, things and statements, each with the words it came from. What was not
//! understood is in it too. [`write`](write::write) turns a draft into the text of a program.

pub mod arrange;
pub mod colors;
pub mod draft;
pub mod formalize;
pub mod model;
pub mod names;
pub mod read;
pub mod text;
pub mod wish;
pub mod write;

pub use arrange::arrange_rooms;
pub use draft::Draft;
pub use formalize::{Formalized, formalize, of_draft, with_model};
pub use read::{Options, Reading, read};
