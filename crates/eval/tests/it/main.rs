//! Scores worked out by hand, of small programs for one request; and the form of the requests of `tests/requests`.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

mod requests;
mod scores;
