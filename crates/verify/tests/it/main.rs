//! Tests of the verifier through its public face: cases as data, gradients against differences, reports.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

mod builtins;
mod cases;
mod dice;
mod everyday;
mod given;
mod gradients;
mod naive;
mod navigation;
mod proofs;
mod reports;
mod schemas;
mod sentences;
mod spec;
