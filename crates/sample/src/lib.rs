//! Many layouts of one program, drawn uniformly from all in which everything that must hold does.
//!
//! - [`Sampler`]: from a number to a verified layout; the same number gives the same one on any machine, so that a run can be
//!   split among many.
//! - [`whole`], [`chain`]: the two ways to draw. Small programs are drawn as a whole until all holds; others by a Markov
//!   chain of moves ([`moves`]), judged by the candidate of `engine`.
//! - [`Coverage`]: how far the samples are spread, and what refused most moves.
//!
//! What uniform means: over the plan (x and z, in square metres), over the turn about the vertical, over the heights of the
//! floors and tops that things can rest on (each counts alike), over the height of what hangs or floats. What rules of the
//! program set follows from the rest. Sizes, rooms that are left open, decision variables and the tilt of what leans are
//! those of the solved layout that a chain begins at.
//!
//! Absent here: files, and how a program is read.

pub mod chain;
mod coverage;
mod dice;
mod moves;
mod places;
mod sampler;
mod tally;
mod ties;
mod values;
mod walls;
pub mod whole;

pub use coverage::Coverage;
pub use dice::seed_of;
pub use moves::Mover;
pub use sampler::{Drawn, ENOUGH, Missing, PILOT, STARTS, Sample, Sampler, Settings, TRIES, holds};
pub use tally::{KINDS, MoveKind, RULES, Tally};
