//! Layouts drawn as a whole, each thing by itself, until one is found in which everything holds: what that finds is uniform
//! without any burn-in. It serves small programs; of large ones nearly every draw is in vain.

use crate::dice::Dice;
use crate::moves::{Mover, is_free};
use crate::places::On;
use crate::tally::Tally;
use scenelang_engine::Pose;
use scenelang_engine::candidate::{Candidate, Change};
use scenelang_engine::frame::{Frame, Hold};
use scenelang_lang::program::ObjectId;

/// Whether layouts of a program can be drawn as a whole: its rooms and variables are given, and everything that moves is put
/// somewhere or is set by rules.
pub fn is_possible(state: &Candidate<'_>) -> bool {
    let frame = state.frame;
    let is_put = |id: &ObjectId| match frame.hold(*id) {
        Hold::Rests | Hold::Floats | Hold::Ceiling(_) => is_free(frame, *id) || frame.fixed(*id).pos == [true; 3],
        _ => false,
    };
    let mut movable = frame.objects().filter(|id| frame.is_movable(*id));
    !frame.has_open_regions() && frame.program.variables.is_empty() && movable.all(|id| is_put(&id))
}

/// Draws a layout; `true`: everything holds in it, and it is the one of `state`.
pub fn draw(mover: &Mover, state: &mut Candidate<'_>, dice: &mut Dice, tally: &mut Tally) -> bool {
    tally.whole[0] += 1;
    let found = tried(mover, state, dice, tally);
    tally.whole[1] += u64::from(found);
    found
}

fn tried(mover: &Mover, state: &mut Candidate<'_>, dice: &mut Dice, tally: &mut Tally) -> bool {
    let frame = state.frame;
    let is_new = frame.objects().any(|id| !state.is_placed(id));
    let mut poses: Vec<Pose> =
        frame.objects().map(|id| if state.is_placed(id) { state.pose(id) } else { state.home(id) }).collect();
    // What stands on something else is placed after it.
    let mut open: Vec<(ObjectId, On)> = Vec::new();
    for id in frame.objects().filter(|id| is_drawn(frame, *id)) {
        let at = |other: ObjectId| poses[other.0 as usize];
        let Some(on) = mover.places.uniform(&at, frame.hold(id), id, &poses[id.0 as usize], dice) else {
            return false;
        };
        open.push((id, on));
    }
    while !open.is_empty() {
        let waits = |on: On| matches!(on, On::Top(other) if open.iter().any(|(id, _)| *id == other));
        // Of two things, each on the other, neither can be put anywhere.
        let Some(next) = open.iter().position(|(_, on)| !waits(*on)) else { return false };
        let (id, on) = open.swap_remove(next);
        let old = poses[id.0 as usize];
        let old = if frame.fixed(id).rot { old } else { old.facing(dice.between(0.0, 360.0)) };
        let put = mover.places.put(&|other| poses[other.0 as usize], frame.hold(id), &old, on, dice);
        let Some(pose) = put else { return false };
        poses[id.0 as usize] = pose;
    }
    let changes: Vec<Change> = frame.objects().map(|id| Change::Object(id, poses[id.0 as usize])).collect();
    if let Err(check) = state.attempt_holding(&changes) {
        tally.refused(frame, state.numbering, check);
        return false;
    }
    // What stands where two tops meet could have come there in two ways.
    let drawn = frame.objects().filter(|id| is_drawn(frame, *id));
    let ways: f64 = drawn.map(|id| mover.places.ways_to(state, id).max(1) as f64).product();
    let taken = (ways <= 1.0 || dice.unit() < 1.0 / ways)
        && state.has_ways(|t| frame.terms[t].is_hard())
        && (!is_new || state.violated().is_empty());
    if taken {
        state.keep();
    } else {
        state.undo();
    }
    taken
}

fn is_drawn(frame: &Frame<'_>, id: ObjectId) -> bool {
    frame.is_movable(id) && is_free(frame, id)
}
