//! Tests of the layout crate through its public face.

#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

mod bodies;
mod files;
mod polygons;
mod rewriting;
mod sweeps;
