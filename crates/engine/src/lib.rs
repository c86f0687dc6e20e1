//! Layouts that change: one state with a journal, what a move alters, what it costs to judge that, and which move repairs
//! what fails.
//!
//! - [`State`]: poses, one way to write them, and back again.
//! - [`Mirror`]: the same layout in other numbers, brought up to date where it is needed.
//! - [`Index`]: from objects, regions and variables to the formulas that a change of them can alter.
//! - [`frame`]: what a program demands, worked out once: terms, rules, what each object is held by.
//! - [`candidate`]: a whole layout with what each demand costs in it, and trials that are judged by what they touch;
//!   [`penalty`] says what a formula costs.
//! - [`trial`]: the same with code in place of the evaluator, for those who make very many trials.
//! - [`Live`]: the verdict of a layout whose objects are moved by hand.
//! - [`Batch`]: margins in many layouts that differ in where their objects are.
//! - [`check`], [`moves_for`]: the verdict with the moves that repair what fails.
//! - [`check_file`] and its like: the same of files.
//!
//! Absent here: what holds in one layout (`verify`), and any search for a whole layout (`solve`).

mod batch;
pub mod candidate;
mod clock;
mod explain;
mod file;
pub mod frame;
mod index;
pub mod limit;
mod live;
mod mirror;
mod moved;
mod moves;
pub mod penalty;
pub mod pose;
mod rows;
mod state;
pub mod trial;

pub use batch::Batch;
pub use clock::Instant;
pub use explain::{check, moves_for};
pub use file::{
    check_file, check_file_with, check_layout_of, check_layout_text, check_program, check_read, check_read_locked,
    program_of,
};
pub use index::{Index, Reads};
pub use live::Live;
pub use mirror::Mirror;
pub use moved::moved;
pub use pose::Pose;
pub use rows::row_of;
pub use state::State;
