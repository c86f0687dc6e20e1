//! The Python module `scenelang`, as far as it is compiled: `scenelang._native`. What users see of it is
//! `crates/python/scenelang`, which gives results their types and arrays their shape.
//!
//! Between the two go texts (programs, layouts, reports as the command line writes them) and buffers of floats, so that what
//! Python says of a scene is what the command line says. Whatever takes long leaves the interpreter to other threads.
//!
//! Absent here: anything that decides something about scenes.

#![allow(clippy::needless_pass_by_value, reason = "what Python hands over is read from it, and ours")]

mod errors;
mod evaluator;
mod make;
mod poses;
mod program;
mod work;

use pyo3::prelude::*;

/// What is imported as `scenelang._native`.
#[pymodule]
mod _native {
    #[pymodule_export]
    use super::evaluator::Evaluator;
    #[pymodule_export]
    use super::make::{formalize, repair, sample, solve};
    #[pymodule_export]
    use super::program::Program;
}
