//! The rows of an image, divided among threads. Which of them does a row has no influence on what is in it.

use std::ops::Range;
use std::panic::resume_unwind;
use std::thread;

/// How many threads draw: as many as there are cores.
pub(super) fn cores() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// Calls `band` with as many bands of rows as threads are wanted, each on a thread of its own, and gives the results from
/// top to bottom.
pub(super) fn bands<R: Send>(height: usize, threads: usize, band: impl Fn(Range<usize>) -> R + Sync) -> Vec<R> {
    let count = threads.clamp(1, height.max(1));
    let rows = |k: usize| k * height / count..(k + 1) * height / count;
    let band = &band;
    thread::scope(|scope| {
        let spawn = |k: usize| thread::Builder::new().spawn_scoped(scope, move || band(rows(k)));
        let others: Vec<_> = (1..count).map(spawn).collect();
        let mut out = vec![band(rows(0))];
        for (k, other) in (1..).zip(others) {
            out.push(match other {
                Ok(thread) => thread.join().unwrap_or_else(|panic| resume_unwind(panic)),
                // The system has no more threads.
                Err(_) => band(rows(k)),
            });
        }
        out
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_is_in_one_band() {
        for (height, threads) in [(0, 4), (1, 4), (7, 3), (800, 64), (5, 0)] {
            let rows: Vec<usize> = bands(height, threads, |rows| rows).into_iter().flatten().collect();
            assert_eq!(rows, (0..height).collect::<Vec<_>>(), "{height} rows, {threads} threads");
        }
    }
}
