//! Two local searches with different random numbers, side by side. What is easy is found by the first one alone; for the rest the one
//! that needs less work wins. So a search that came to a bad end costs half of the time and not all of it, and the result
//! does not depend on how many threads there are.

use crate::search::local::LocalSearch;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::limit::Limit;
use std::sync::atomic::{AtomicU64, Ordering};

/// The work that the first one has for itself, and so the first round of both; each round is twice the one before.
const ALONE: u64 = 3_000_000;
/// In how many parts a round is done: between them one that has lost finds out.
const PARTS: u64 = 8;

/// A local search and its random numbers.
pub(crate) struct Member<'a> {
    pub local: LocalSearch<'a>,
    pub chance: ChaCha8Rng,
}

impl Member<'_> {
    /// Does a round. The work that it took, if all holds then; it ends early where another needed less.
    fn round(&mut self, slice: u64, limit: &Limit, given: &[bool], least: &AtomicU64) -> Option<u64> {
        let begun = self.local.trial.work;
        for part in 1..=PARTS {
            let budget = (begun + slice * part / PARTS).saturating_sub(self.local.trial.work);
            if self.local.search(&mut self.chance, budget, limit, given) {
                let took = self.local.trial.work - begun;
                least.fetch_min(took, Ordering::Relaxed);
                return Some(took);
            }
            if limit.is_over() || self.local.trial.work - begun > least.load(Ordering::Relaxed) {
                break;
            }
        }
        None
    }
}

/// Searches until all holds in one of them, or all of them together have done so much work. The winner, whose work is that
/// of all, and whether all holds; where it does not, the one in which the least is violated.
pub(crate) fn search<'a>(
    mut first: Member<'a>,
    another: impl FnOnce() -> Member<'a>,
    budget: u64,
    limit: &Limit,
    given: &[bool],
    threads: usize,
) -> (Member<'a>, bool) {
    let mut slice = ALONE.min(budget);
    if first.local.search(&mut first.chance, slice, limit, given) {
        return (first, true);
    }
    let mut work = first.local.trial.work;
    if work >= budget || limit.is_over() {
        first.local.restore_best();
        return (first, false);
    }
    let mut second = another();
    while work < budget && !limit.is_over() {
        slice = slice.min((budget - work).div_ceil(2));
        let begun = [first.local.trial.work, second.local.trial.work];
        let least = AtomicU64::new(u64::MAX);
        let (one, other) = if threads > 1 {
            std::thread::scope(|scope| {
                let other = scope.spawn(|| second.round(slice, limit, given, &least));
                let one = first.round(slice, limit, given, &least);
                (one, other.join().ok().flatten())
            })
        } else {
            (first.round(slice, limit, given, &least), second.round(slice, limit, given, &least))
        };
        if let Some(took) = one.into_iter().chain(other).min() {
            let mut winner = if one == Some(took) { first } else { second };
            winner.local.trial.work = work + 2 * took;
            return (winner, true);
        }
        work += first.local.trial.work - begun[0] + second.local.trial.work - begun[1];
        slice *= 2;
    }
    let mut closest = if second.local.least_violated() < first.local.least_violated() { second } else { first };
    closest.local.restore_best();
    closest.local.trial.work = work;
    (closest, false)
}
