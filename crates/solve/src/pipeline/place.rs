//! InitialPlacement: one object after the other, each at the best of many candidates given what is there already.
//!
//! First what the program fixes, then what is in walls, then by how determined and how large an object is: a table
//! before its chairs, a shelf before what stands on it.

use crate::external::steps::Steps;
use crate::search::Search;
use scenelang_engine::candidate::Change;
use scenelang_lang::program::ObjectId;

/// Puts objects where they are given a place.
fn as_given(search: &mut Search<'_>, given: &[(ObjectId, Option<crate::problem::pose::Pose>)]) {
    for &(id, pose) in given {
        let pose = pose.unwrap_or_else(|| search.state.pose(id));
        if search.state.attempt(&[Change::Object(id, pose)], f64::INFINITY).is_some() {
            search.state.keep();
        }
    }
}

/// Puts everything that has no place yet somewhere, without a look at anything.
pub(crate) fn anywhere(search: &mut Search<'_>, given: &[(ObjectId, Option<crate::problem::pose::Pose>)]) {
    let waits = |search: &Search<'_>, id: ObjectId| !search.state.is_placed(id);
    let own: Vec<_> = given.iter().copied().filter(|(id, _)| waits(search, *id)).collect();
    as_given(search, &own);
    for id in search.state.frame.objects() {
        if waits(search, id) {
            search.put_anywhere(id);
        }
    }
}

/// Places everything that has no place yet: by a step from outside, or wherever rules put it.
pub(crate) fn initial(
    search: &mut Search<'_>,
    steps: &mut Steps<'_>,
    given: &[(ObjectId, Option<crate::problem::pose::Pose>)],
) {
    let own: Vec<_> = given.iter().copied().filter(|(id, _)| !search.state.is_placed(*id)).collect();
    as_given(search, &own);
    let mut waiting: Vec<ObjectId> = search.state.frame.objects().filter(|o| !search.state.is_placed(*o)).collect();
    let rank = |o: &ObjectId| search.state.frame.priority[o.0 as usize];
    waiting.sort_by(|a, b| rank(b).total_cmp(&rank(a)).then(a.cmp(b)));
    while !waiting.is_empty() {
        let ready = waiting.iter().position(|&o| search.is_ready(o, &waiting)).unwrap_or(0);
        let id = waiting.remove(ready);
        if !search.state.is_placed(id) && !search.outside_place(steps, id) {
            search.put_anywhere(id);
        }
    }
}
