//! Tests of the layout crate through its public face.

mod bodies;
mod files;
mod polygons;
mod rewriting;
