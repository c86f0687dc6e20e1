//! Stage III, the Rubik solver: a program and the sizes of its objects in, a layout in which everything holds out.
//!
//! - [`problem`]: what is given, and what of it stays the same during a search.
//! - [`search`]: layouts that change, by weighted min-conflicts ([`search::local`]). Sizes and open regions that constraints
//!   speak of are found before it, by least squares ([`search::least_squares`]).
//! - [`pipeline`]: the whole procedure. For proposers from outside it is the published algorithm: InitialPlacement
//!   ([`pipeline::place`]), then rounds of SelectBatch ([`pipeline::select`]), proposals ([`pipeline::rounds`]) and
//!   EnforceBounds ([`pipeline::bounds`]), before the local search goes on from there.
//! - [`repair`]: the fewest and shortest moves after which what failed holds.
//! - [`diagnose`], [`freedom`]: what is in the way, and how far things may move.
//! - [`Ground`]: a layout for those who change it otherwise than a search does.
//! - [`external`]: steps in place of the solver's own; a language model may be one of the proposers.
//!
//! What holds, and by how much, is asked of the one evaluator (`verify`); no predicate is known here by name.
//!
//! Absent here: reading of files, assets, how a model is reached.

mod alternatives;
mod diagnose;
mod external;
mod freedom;
mod ground;
mod pipeline;
mod problem;
pub mod repair;
mod search;

pub use alternatives::alternatives;
pub use external::model::{Asking, Finisher, Hybrid, ModelProposer, Tally, hybrid};
pub use external::steps::{Bounds, Placer, Proposer, Relaxer, Selector, Steps};
pub use external::view::{Concern, Move, Proposal, View};
pub use freedom::{FAR, Free, Freedom, freedom};
pub use ground::Ground;
pub use pipeline::{solve, solve_with};
pub use problem::draws::draws;
pub use problem::pose::Pose;
pub use problem::{
    End, MOST_OBJECTS, Options, Outcome, Phase, Placed, Problem, Progress, QUALITY, Standing, TermSubject, Unsatisfied,
};
pub use scenelang_engine::limit::Stop;
