//! Once all that must hold does: preferences, and looks.
//!
//! Each preference that fails gets its objects moved, alone, with what goes with them, or all anew; only layouts in
//! which everything still holds are kept, and only better ones.

use crate::search::pool::{Breadth, Chance};
use crate::search::{Best, Search};
use scenelang_lang::program::ObjectId;

/// How often all preferences are gone through.
const PASSES: usize = 3;
/// How often objects are taken out and placed anew for one preference.
const RECREATIONS: usize = 4;
/// How many objects may be placed anew together.
const TOGETHER: usize = 14;
/// What looks odder than this is looked at (see `looks`).
const ODD: f64 = 0.004;

/// Improves a layout in which everything holds, up to a part of the budget. What is `settled` is moved only for a
/// preference that holds then: not to come closer to one, nor for its looks.
pub(crate) fn improve(search: &mut Search<'_>, until: f64, settled: bool) {
    for _ in 0..PASSES {
        let mut better = false;
        let failing: Vec<usize> = (0..search.state.frame.terms.len())
            .filter(|&t| !search.state.is_hard(t) && !search.state.does_hold(t))
            .collect();
        for preference in failing {
            for attempt in 0..=RECREATIONS {
                if search.is_spent(until) {
                    return;
                }
                if search.state.does_hold(preference) {
                    break;
                }
                let before = settled.then(|| search.snapshot());
                let granted = grant(search, preference, attempt);
                match before.filter(|_| granted && !search.state.does_hold(preference)) {
                    Some(before) => search.restore(&before),
                    None => better |= granted,
                }
            }
        }
        if !settled {
            better |= straighten(search, until);
        }
        if !better {
            break;
        }
    }
}

/// One attempt to make a preference hold.
fn grant(search: &mut Search<'_>, preference: usize, attempt: usize) -> bool {
    let mut objects = search.blamed(preference);
    search.chance.shuffle(&mut objects);
    if attempt == 0 {
        return objects.iter().take(8).any(|&id| {
            keep_if_better(search, |search| {
                search.place(id, Breadth::Some(120), &[], true);
            })
        });
    }
    let Some(&seed) = objects.first() else { return false };
    keep_if_better(search, |search| {
        let group = search.dependents(&[seed], TOGETHER);
        search.recreate(&group);
        search.fix(20);
    })
}

/// Gives what looks odd another place.
fn straighten(search: &mut Search<'_>, until: f64) -> bool {
    let movable: Vec<ObjectId> = search.state.frame.objects().filter(|o| search.state.frame.is_movable(*o)).collect();
    let mut better = false;
    for id in movable {
        if search.is_spent(until) {
            break;
        }
        if search.state.oddity(id) > ODD {
            better |= keep_if_better(search, |search| {
                search.place(id, Breadth::Some(120), &[], true);
            });
        }
    }
    better
}

/// Does something; takes it back unless everything still holds and the rest is better.
fn keep_if_better(search: &mut Search<'_>, act: impl FnOnce(&mut Search<'_>)) -> bool {
    let (snapshot, before) = (search.snapshot(), (search.state.hard(), search.state.soft()));
    act(search);
    if search.snapshot() != snapshot && Best::is_better((search.state.hard(), search.state.soft()), before) {
        return true;
    }
    search.restore(&snapshot);
    false
}
