//! The library as its users see it: shapes that fill their boxes, meshes that are sound, nouns that are understood.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

mod geometry;
mod looks;
mod nouns;
mod opened;
mod shapes;
