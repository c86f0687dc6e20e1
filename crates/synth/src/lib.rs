//! The corridor: program → sizes and parts → layout → report → files, each stage a value that can be looked at.
//!
//! Absent here: what the stages do. They live in the rooms below; this one joins them.

mod again;
mod corridor;
mod doubt;
mod furnish;
mod hold;
mod manifest;
mod narrow;
mod output;
pub mod rebuild;
mod refute;
mod rehearse;

pub use corridor::{
    Advice, Adviser, Arranged, Arranging, Failure, Furnishings, JudgedLayout, LayoutRequest, Made, Observer, PLANNED,
    Solved, Stage, arrange, compiled, furnished, numbered, solve, solve_with, too_large,
};
pub use doubt::{Ended, doubted};
pub use furnish::{Chosen, Earlier, Furnished, asset_of, furnish, furnish_from, queries};
pub use hold::Hold;
pub use manifest::{manifest, told};
pub use output::{furniture_file, own_files, program_files, scene};
pub use rehearse::{Tried, rehearse, rehearse_reading};
