//! Tests of the verifier through its public face: cases as data, gradients against differences, reports.

mod cases;
mod gradients;
mod reports;
mod spec;
