//! Tests of layouts that change: the verdict that follows a move, and the moves that are offered.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

mod explanations;
#[path = "../../../verify/tests/it/given.rs"]
mod given;
mod live;
mod opening;
mod state;
