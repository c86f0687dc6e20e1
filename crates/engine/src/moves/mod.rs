//! The smallest move that repairs what fails: who looks for it ([`finder`]), where moves are tried ([`stage`]), what goes along
//! ([`company`]), how the moves of one object are found ([`search`], [`proper`], [`ways`]), what is awkward about where they lead ([`flaws`]), and which of
//! them are offered ([`choice`]).

mod choice;
mod company;
mod finder;
mod flaws;
mod proper;
mod search;
mod settle;
mod stage;
mod stands;
mod walls;
mod ways;
mod zones;

pub(crate) use finder::MoveFinder;

/// A row that costs more than this to judge is dear: it is tried less often.
const DEAR: usize = 100;
