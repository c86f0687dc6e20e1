//! Scores worked out by hand, of small programs for one request; the form of the requests of `tests/requests`; SceneEval's
//! scores of hand-made layouts; the dataset, the published metrics and the baselines.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

mod alike;
mod coherence;
mod correctness;
mod dataset;
mod requests;
mod resemblance;
mod sceneeval;
mod scores;
mod suite;
