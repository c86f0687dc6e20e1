//! Requests with ground truth, and how much of it a program says.
//!
//! ```text
//! NAME.txt ──reader──▶ program ──told──▶ what it says ─┐
//! NAME.expect.json ───expect──▶ what it should say ────┴─score──▶ shares ──requests──▶ table, JSON
//! ```
//!
//! Absent here: readers of requests (they are handed in), and whether a program can be solved.

mod expect;
mod pairing;
pub mod requests;
pub mod sceneeval;
mod score;
mod told;
mod words;
mod wrong;

pub use expect::{Connection, Expectation, Names, Number, Relation, Room, Thing};
pub use requests::{Case, Reader, Reading, Request, Requests, read_folder};
pub use score::{Score, Share, score};
