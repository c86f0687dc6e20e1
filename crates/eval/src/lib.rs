//! Requests with ground truth, and how much of it a program says.
//!
//! ```text
//! NAME.txt ──reader──▶ program ──told──▶ what it says ─┐
//! NAME.expect.json ───expect──▶ what it should say ────┴─score──▶ shares ──requests──▶ table, JSON
//! ```
//!
//! Beside that: a [`dataset`] of such requests, made by a grammar; the published [`resemblance`] and solution [`correctness`]
//! with two baselines, and the [`coherence`] of pictures; layouts scored by the annotations of SceneEval ([`sceneeval`]); all of it for a suite ([`suite`]).
//!
//! Absent here: readers of requests (they are handed in), and files.

pub mod coherence;
pub mod correctness;
pub mod dataset;
mod expect;
mod pairing;
pub mod requests;
pub mod resemblance;
pub mod sceneeval;
mod score;
pub mod suite;
mod told;
mod words;
mod wrong;

pub use expect::{Connection, Expectation, ExpectedRoom, ExpectedThing, Number, OneOrSeveral, Relation};
pub use requests::{Case, EvalRequest, Reader, Reading, Requests, read_folder};
pub use score::{Score, Share, score};
