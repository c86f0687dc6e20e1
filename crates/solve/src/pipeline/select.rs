//! SelectBatch: which violated constraints are taken up next.

use crate::search::chance::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::candidate::Candidate;

/// Chooses at most `k` of the unsatisfied checks: the first by weight, cost and noise; the others likewise, but those
/// that share objects with it first, so that what hangs together is repaired together.
pub(crate) fn batch(state: &Candidate<'_>, unsatisfied: &[usize], k: usize, chance: &mut ChaCha8Rng) -> Vec<usize> {
    let mut scored: Vec<(f64, usize)> =
        unsatisfied.iter().map(|&c| (state.weight[c] * (0.1 + state.cost(c)) * chance.unit(), c)).collect();
    scored.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let Some(&(_, first)) = scored.first() else { return Vec::new() };
    let own = state.objects_of(first);
    let shares = |c: usize| state.objects_of(c).iter().any(|o| own.contains(o));
    let mut rest: Vec<usize> = scored[1..].iter().map(|(_, c)| *c).collect();
    rest.sort_by_key(|&c| !shares(c));
    std::iter::once(first).chain(rest).take(k).collect()
}
