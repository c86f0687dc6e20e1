//! Work on many things at once, with results in order.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;

/// As much as a main thread usually has, in bytes: what is nested deeply is no different there.
const STACK: usize = 8 << 20;

/// Does `work` on each item, on as many threads as `jobs` says, and gives the results to `each` in the order of the items:
/// the outcome does not depend on how many threads there are.
pub fn in_order<T: Sync, R: Send>(items: &[T], jobs: usize, work: impl Fn(&T) -> R + Sync, mut each: impl FnMut(R)) {
    let jobs = jobs.min(items.len());
    if jobs <= 1 {
        return items.iter().for_each(|item| each(work(item)));
    }
    let next = AtomicUsize::new(0);
    let (sender, receiver) = mpsc::channel();
    let mut started = 0;
    std::thread::scope(|scope| {
        for _ in 0..jobs {
            let (sender, next, work) = (sender.clone(), &next, &work);
            let labour = move || {
                loop {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    let Some(item) = items.get(i) else { return };
                    // Nobody listens any more only where the receiving side has panicked.
                    if sender.send((i, work(item))).is_err() {
                        return;
                    }
                }
            };
            let thread = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, labour);
            started += usize::from(thread.is_ok());
        }
        drop(sender);
        if started == 0 {
            // The system gives us no thread at all.
            return items.iter().for_each(|item| each(work(item)));
        }
        let mut early: BTreeMap<usize, R> = BTreeMap::new();
        let mut wanted = 0;
        for (i, result) in receiver {
            early.insert(i, result);
            while let Some(result) = early.remove(&wanted) {
                each(result);
                wanted += 1;
            }
        }
    });
}

/// How many threads to use if nothing is said.
pub fn usual() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_order_from_any_number_of_threads() {
        let items: Vec<u64> = (0..200).collect();
        // Work of very different length, so that later items are done first.
        let work = |n: &u64| (0..(200 - n) * 50).fold(*n, |a, b| a ^ b.wrapping_mul(n + 1));
        let mut alone = Vec::new();
        in_order(&items, 1, work, |r| alone.push(r));
        for jobs in [2, 3, 64] {
            let mut together = Vec::new();
            in_order(&items, jobs, work, |r| together.push(r));
            assert_eq!(together, alone);
        }
        in_order(&[], 4, work, |_| panic!("there is nothing"));
    }
}
