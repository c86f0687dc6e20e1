//! Solving again: what the search has moved goes back to where it was, as far as nothing is the worse for it.

use crate::problem::pose::Pose;
use crate::search::Search;
use scenelang_engine::candidate::Change;
use scenelang_lang::program::ObjectId;

/// How often all objects are gone through: one that goes back may make room for another.
const PASSES: usize = 3;
/// So many that moved are looked at together.
const MOST: usize = 24;
/// What going back may cost.
const HARM: f64 = 1e-9;

/// Puts objects back to the places that were given, one after the other, while all that must hold does.
pub(crate) fn put_back(search: &mut Search<'_>, given: &[(ObjectId, Option<Pose>)]) {
    one_by_one(search, given);
    if all_but_one(search, given) {
        one_by_one(search, given);
    }
}

fn one_by_one(search: &mut Search<'_>, given: &[(ObjectId, Option<Pose>)]) {
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
}

/// What moved as one piece goes back as one piece, but for the one that had to move. Whether it did.
fn all_but_one(search: &mut Search<'_>, given: &[(ObjectId, Option<Pose>)]) -> bool {
    let moved: Vec<(ObjectId, Pose)> = given
        .iter()
        .filter_map(|(id, pose)| Some((*id, (*pose)?)))
        .filter(|(id, pose)| search.state.frame.is_movable(*id) && search.state.pose(*id) != *pose)
        .collect();
    if !(3..=MOST).contains(&moved.len()) {
        return false;
    }
    moved.iter().any(|(stays, _)| {
        let others = moved.iter().filter(|(id, _)| id != stays);
        let back: Vec<Change> = others.map(|(id, pose)| Change::Object(*id, *pose)).collect();
        let (met, before) = (met(search), search.snapshot());
        if search.is_late() || !go(search, &back) {
            return false;
        }
        // Preferences that are nearly met are no reason to leave others unmet.
        let kept = self::met(search) >= met;
        if !kept {
            search.restore(&before);
        }
        kept
    })
}

/// How much the preferences weigh that are met.
fn met(search: &Search<'_>) -> f64 {
    let terms = &search.state.frame.terms;
    let soft = (0..terms.len()).filter(|&t| !search.state.is_hard(t) && search.state.does_hold(t));
    soft.map(|t| search.state.weight[t]).sum()
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
