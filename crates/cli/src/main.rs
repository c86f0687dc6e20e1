//! The `scenelang` binary.
fn main() {}
