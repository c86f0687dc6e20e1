//! InitialPlacement: one object after the other, each at the best of many candidates given what is there already.
//!
//! First what the program fixes, then what is in walls, then by how determined and how large an object is: a table
//! before its chairs, a shelf before what stands on it.

use crate::external::steps::Steps;
use crate::problem::frame::Hold;
use crate::problem::terms::Term;
use crate::search::Search;
use crate::search::state::Change;
use scenelang_lang::program::ObjectId;
use scenelang_layout::Vec3;

/// Comes before everything that stands in a room.
const IN_WALLS: f64 = 10.0;
/// How early an object comes, by its terms, what holds it, and its size.
pub(crate) fn priority<'t>(terms: impl Iterator<Item = &'t Term>, hold: Hold, size: Vec3) -> f64 {
    let volume: f64 = size.iter().product();
    let large = ((volume.max(1e-9).log10() + 3.0) / 3.5).clamp(0.0, 1.2);
    let (mut alone, mut all) = (0.0, 0.5);
    for term in terms.filter(|t| t.is_hard()) {
        let others = term.objects.len() - 1;
        let weight = 1.0 / others.max(1) as f64;
        all += weight;
        if others == 0 {
            alone += weight;
        }
    }
    let wall = if matches!(hold, Hold::Door(..)) { IN_WALLS } else { 0.0 };
    wall + 1.5 * alone / all + 1.3 * large
}

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
