//! Handlers: from parameters to what `ide` is asked, and from its answers to results. One file for what belongs together.

pub mod diagnostic;
