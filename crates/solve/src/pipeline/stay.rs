//! Solving again: what the search has moved goes back to where it was, as far as nothing is the worse for it.

use crate::problem::pose::Pose;
use crate::search::Search;
use crate::search::state::Change;
use scenelang_lang::program::ObjectId;

/// How often all objects are gone through: one that goes back may make room for another.
const PASSES: usize = 3;
/// So many that moved are looked at together.
const MOST: usize = 24;
/// What going back may cost.
const HARM: f64 = 1e-9;

/// Puts objects back to the places that were given, one after the other, while all that must hold does.
pub(crate) fn put_back(search: &mut Search<'_>, given: &[(ObjectId, Option<Pose>)]) {
    for _ in 0..PASSES {
        let mut changed = false;
        for (id, pose) in given.iter().filter_map(|(id, pose)| Some((*id, (*pose)?))) {
            if search.is_late() {
                return;
            }
            if search.state.frame.is_movable(id) && search.state.pose(id) != pose {
                changed |= go(search, &[Change::Object(id, pose)]);
            }
        }
        if !changed {
            break;
        }
    }
    all_but_one(search, given);
}

/// A row that moved as one piece goes back as one piece, but for the one that had to move.
fn all_but_one(search: &mut Search<'_>, given: &[(ObjectId, Option<Pose>)]) {
    let moved: Vec<(ObjectId, Pose)> = given
        .iter()
        .filter_map(|(id, pose)| Some((*id, (*pose)?)))
        .filter(|(id, pose)| search.state.frame.is_movable(*id) && search.state.pose(*id) != *pose)
        .collect();
    if !(3..=MOST).contains(&moved.len()) {
        return;
    }
    for (stays, _) in &moved {
        let back: Vec<Change> =
            moved.iter().filter(|(id, _)| id != stays).map(|(id, pose)| Change::Object(*id, *pose)).collect();
        if search.is_late() || go(search, &back) {
            return;
        }
    }
}

fn go(search: &mut Search<'_>, changes: &[Change]) -> bool {
    let dear = !search.state.frame.walks.is_empty();
    let before = dear.then(|| search.snapshot());
    if search.state.attempt(changes, HARM).is_none() {
        return false;
    }
    if !search.state.violated().is_empty() {
        search.state.undo();
        return false;
    }
    search.state.keep();
    // Ways over the floor are not looked at in a trial.
    if let Some(before) = before.filter(|_| search.state.hard().0 > 0) {
        search.restore(&before);
        return false;
    }
    true
}
