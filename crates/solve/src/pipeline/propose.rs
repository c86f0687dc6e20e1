//! The numeric proposer: a joint polish of what the batch speaks of, then other places for each of its objects, then
//! exchanges of places.

use crate::problem::pose::Pose;
use crate::search::pool::{Breadth, Chance};
use crate::search::state::Change;
use crate::search::{STEPS, Search};
use scenelang_lang::program::{ObjectId, VariableId, VariableKind};
use scenelang_verify::{Truth, Value};

/// How many objects of a batch are moved.
const OBJECTS: usize = 6;
/// How many other places are tried for each.
const PLACES: usize = 60;
/// How many objects go with one.
const GROUP: usize = 40;
/// How many exchanges of places are tried for each.
const EXCHANGES: usize = 4;

/// Moves what a batch of violated checks speaks of, so that less is violated. Whether anything was improved, by the
/// weights in force.
pub(crate) fn numeric(search: &mut Search<'_>, batch: &[usize]) -> bool {
    let mut objects: Vec<ObjectId> = Vec::new();
    let mut walks = false;
    for &check in batch {
        walks |= search.state.frame.terms.get(check).is_some_and(|t| t.walks);
        for id in search.blamed(check) {
            if !objects.contains(&id) {
                objects.push(id);
            }
        }
    }
    let mut improved = flip(search, batch);
    search.chance.shuffle(&mut objects);
    objects.truncate(OBJECTS);
    improved |= search.polish(objects.clone(), STEPS[1]);
    if walks {
        return clear_ways(search, &objects) || improved;
    }
    for &id in &objects {
        if search.is_spent(1.0) {
            break;
        }
        improved |= search.place(id, Breadth::Some(PLACES), &[], true);
        let group = search.dependents(&[id], GROUP);
        if group.len() > 1 {
            improved |= search.place(id, Breadth::Some(PLACES), &group, true);
        }
        improved |= exchange(search, id);
        improved |= search.reconcile(id);
    }
    improved
}

/// Tries the other value of the truths that a batch reads.
fn flip(search: &mut Search<'_>, batch: &[usize]) -> bool {
    let frame = search.state.frame;
    let terms = batch.iter().filter_map(|&c| frame.terms.get(c));
    let mut variables: Vec<VariableId> = terms.flat_map(|t| t.variables.iter().copied()).collect();
    variables.sort_unstable();
    variables.dedup();
    variables.retain(|v| frame.program.variables[v.0 as usize].kind == VariableKind::Bool);
    let mut improved = false;
    for id in variables {
        let Ok(Value::Truth(now)) = search.state.world().variable(id) else { continue };
        let other = Change::Variable(id, Value::Truth(Truth::discrete(!now.holds)));
        if search.state.attempt(&[other], -1e-9).is_some() {
            search.state.keep();
            improved = true;
        }
    }
    improved
}

/// Lets an object change places with others.
fn exchange(search: &mut Search<'_>, id: ObjectId) -> bool {
    let frame = search.state.frame;
    let hold = std::mem::discriminant(&frame.hold(id));
    let mut others: Vec<ObjectId> = search
        .state
        .placed()
        .filter(|o| *o != id && frame.is_movable(*o) && std::mem::discriminant(&frame.hold(*o)) == hold)
        .collect();
    search.chance.shuffle(&mut others);
    for other in others.into_iter().take(EXCHANGES) {
        let (a, b) = (search.state.pose(id), search.state.pose(other));
        for turned in [false, true] {
            let take = |own: &Pose, theirs: &Pose| {
                let pose = own.at(theirs.pos.x, theirs.pos.y, theirs.pos.z);
                if turned { pose.facing(theirs.rot.y) } else { pose }
            };
            let mut changes = search.state.with_riders(id, take(&a, &b));
            let more = search.state.with_riders(other, take(&b, &a));
            let moved = |c: &Change| matches!(c, Change::Object(o, _) if more.iter().any(|m| matches!(m, Change::Object(p, _) if p == o)));
            // What stands on one of them may be the other.
            if changes.iter().any(moved) {
                continue;
            }
            changes.extend(more);
            if search.state.attempt(&changes, -1e-9).is_some() {
                search.state.keep();
                return true;
            }
        }
    }
    false
}

/// Moves what bars ways over the floor to places where everything else holds, until the ways are free.
fn clear_ways(search: &mut Search<'_>, objects: &[ObjectId]) -> bool {
    let (start, violated) = (search.snapshot(), search.state.hard());
    for &id in objects {
        for _ in 0..3 {
            // Any place that is as good otherwise may free the way.
            let candidates =
                crate::search::pool::candidates(&mut search.state, id, Breadth::Some(2 * PLACES), &mut search.chance);
            let mut tried = 0;
            for pose in candidates {
                // A look at the ways is dear; a round of them may be dearer than all that is left.
                if search.is_spent(1.0) {
                    search.restore(&start);
                    return false;
                }
                let changes = search.state.with_riders(id, pose);
                if search.state.attempt(&changes, 0.05).is_none() {
                    continue;
                }
                search.state.keep();
                if search.is_troubled(id) {
                    search.polish(vec![id], STEPS[0]);
                }
                let now = search.state.hard();
                if now.0 < violated.0 || now.0 == violated.0 && now.1 < violated.1 - 1e-9 {
                    return true;
                }
                search.restore(&start);
                tried += 1;
                if tried > 6 {
                    break;
                }
            }
        }
    }
    false
}
