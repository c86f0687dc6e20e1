//! Scores worked out by hand, of small programs for one request; the form of the requests of `tests/requests`; SceneEval's
//! scores of hand-made layouts.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

mod requests;
mod sceneeval;
mod scores;
