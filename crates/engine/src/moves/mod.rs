//! The smallest move that mends what fails: who looks for it ([`mender`]), where moves are tried ([`stage`]), and how the
//! moves of one object are found ([`search`]).

mod mender;
mod search;
mod stage;

pub(crate) use mender::Mender;

/// A row that costs more than this to judge is dear: it is tried less often.
const DEAR: usize = 100;
