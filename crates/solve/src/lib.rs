//! Stage III, the Rubik solver: a program and the sizes of its objects in, a layout in which everything holds out.
//!
//! A local search ([`local`]) finds most layouts. Where it does not, and for proposers from outside, there is the published
//! algorithm: InitialPlacement ([`place`]), PhysicsRelaxation ([`relax`]), then rounds of SelectBatch ([`select`]),
//! proposals ([`propose`]) and EnforceBounds ([`bounds`]); the best layout is kept. What holds, and by how much, is asked
//! of the one evaluator (`verify`); no predicate is known here by name.
//!
//! A language model may be one of the proposers ([`model`]).
//!
//! Absent here: reading of files, assets, how a model is reached.

mod alternatives;
mod bounds;
mod checks;
mod diagnose;
mod draws;
mod equations;
mod finish;
mod frame;
mod freedom;
mod limit;
mod local;
mod looks;
pub mod mend;
mod model;
mod penalty;
mod place;
mod polish;
mod pool;
mod portfolio;
mod pose;
mod problem;
mod propose;
mod regions;
mod relax;
mod repair;
mod rounds;
mod rules;
mod search;
mod select;
mod setup;
mod solve;
mod sound;
mod state;
mod stay;
mod steps;
mod terms;
mod tidy;
mod view;
mod wishes;

pub use alternatives::alternatives;
pub use draws::draws;
pub use freedom::{FAR, Free, Freedom, freedom};
pub use limit::Stop;
pub use model::{Asking, Finisher, Hybrid, ModelProposer, Tally, hybrid};
pub use pose::Pose;
pub use problem::{End, MOST_OBJECTS, Options, Outcome, Phase, Placed, Problem, Progress, Standing, Unsatisfied, What};
pub use solve::{solve, solve_with};
pub use steps::{Bounds, Placer, Proposer, Relaxer, Selector, Steps};
pub use view::{Concern, Move, Proposal, View};
