//! SceneEval-500: other people's requests and annotations, and how well layouts do by the measures published with them.
//!
//! ```text
//! FILE.csv ──annotations──▶ what is asked for ─────────────┐
//! layout, program ──scene──▶ objects and rooms ──┬─score───┴──▶ CNT, ATR, OOR, OAR ──fate──▶ misses ─┐
//!                                                └─plausible, floor──▶ held, apart, free to walk ────┴─report
//! ```
//!
//! All geometry is on oriented boxes or on the parts of objects, where the original has meshes; what it asks models for is
//! in `table.txt`, or in the answers of a model (`lookups`). Absent here: how programs and layouts are made.

#[cfg(test)]
mod agreement;
pub mod annotations;
mod csv;
mod fate;
mod floor;
mod lookups;
mod names;
mod places;
pub mod plausible;
mod relations;
pub mod report;
mod scene;
mod score;
mod shape;
mod table;

pub use annotations::{AnnotatedRequest, Benchmark, Measure, read};
pub use lookups::{by_model, question};
pub use plausible::Plausible;
pub use report::{Case, Made, Scores};
pub use scene::categories;
pub use table::Table;
