//! Solving again: what the search has moved goes back to where it was, as far as nothing is the worse for it.

use crate::problem::pose::Pose;
use crate::search::Search;
use crate::search::state::Change;
use scenelang_lang::program::ObjectId;

/// How often all objects are gone through: one that goes back may make room for another.
const PASSES: usize = 3;
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
                changed |= go(search, id, pose);
            }
        }
        if !changed {
            break;
        }
    }
}

fn go(search: &mut Search<'_>, id: ObjectId, pose: Pose) -> bool {
    let dear = !search.state.frame.walks.is_empty();
    let before = dear.then(|| search.snapshot());
    if search.state.attempt(&[Change::Object(id, pose)], HARM).is_none() {
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
