//! The chain: from a layout in which everything holds, by many moves, to one that no longer depends on where it began.
//!
//! Ways over the floor cost thousands of times more to judge than anything else. So moves are made in runs that do not look
//! for ways, and a run after which one is barred is taken back as a whole: since each run is as likely as its way back, what
//! comes of it is uniform all the same.

use crate::dice::Dice;
use crate::moves::Mover;
use crate::tally::Tally;
use scenelang_engine::candidate::{Candidate, Change};
use scenelang_solve::Stop;

/// Burn-in: so many moves for each thing that can move, within bounds.
pub const PER_OBJECT: usize = 400;
/// The least burn-in.
pub const LEAST: usize = 2_000;
/// The longest burn-in.
pub const MOST: usize = 40_000;
/// How many runs it is made in.
pub const RUNS: usize = 12;

/// How many moves the burn-in of so many movable things has.
pub fn burn_in(movable: usize) -> usize {
    (PER_OBJECT * movable).clamp(LEAST, MOST)
}

/// Moves everything about; `None`: it was asked to end.
pub fn run(mover: &Mover, state: &mut Candidate<'_>, dice: &mut Dice, tally: &mut Tally, stop: &Stop) -> Option<()> {
    let frame = state.frame;
    let looks = frame.walks.iter().any(|&t| frame.terms[t].is_hard());
    for _ in 0..RUNS {
        if stop.is_set() {
            return None;
        }
        let before: Vec<Change> = frame.objects().map(|id| Change::Object(id, state.pose(id))).collect();
        for _ in 0..burn_in(mover.movable.len()) / RUNS {
            mover.step(state, dice, tally);
        }
        if !looks {
            continue;
        }
        let free = state.has_ways(|t| frame.terms[t].is_hard());
        tally.ways[0] += 1;
        tally.ways[1] += u64::from(free);
        if !free && state.attempt(&before, f64::INFINITY).is_some() {
            state.keep();
        }
    }
    Some(())
}
