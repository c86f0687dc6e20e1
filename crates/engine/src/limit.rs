//! When a search has to end, however much work it still may do: at a time, or as soon as somebody says so.

use crate::clock::Instant;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// A request to stop. Clones are the same request: set one, and all who hold another see it.
#[derive(Clone, Debug, Default)]
pub struct Stop {
    asked: Arc<AtomicBool>,
    above: Option<Arc<AtomicBool>>,
}

impl Stop {
    /// Asks for an end. Whether that was asked here before.
    pub fn set(&self) -> bool {
        self.asked.swap(true, Ordering::SeqCst)
    }
    /// Whether an end was asked for.
    pub fn is_set(&self) -> bool {
        let above = self.above.as_ref().is_some_and(|above| above.load(Ordering::Relaxed));
        above || self.asked.load(Ordering::Relaxed)
    }
    /// The request for those who know nothing of what is above it.
    pub fn flag(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.asked)
    }
    /// Another request, which this one sets too, but which does not set this one.
    pub fn below(&self) -> Self {
        Self { asked: Arc::default(), above: Some(Arc::clone(&self.asked)) }
    }
}

/// Who may say so is no part of what is asked for.
impl PartialEq for Stop {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// The end of a search by the clock or by request.
#[derive(Clone, Debug, Default)]
pub struct Limit {
    end: Option<Instant>,
    stop: Stop,
}

impl Limit {
    /// So long from now, or until asked.
    pub fn new(time: Option<Duration>, stop: &Stop) -> Self {
        // A time that no clock can show is none.
        Self { end: time.and_then(|time| Instant::now().checked_add(time)), stop: stop.clone() }
    }
    /// The same, but so much earlier.
    pub fn earlier(&self, by: Duration) -> Self {
        let end = self.end.map(|end| end.checked_sub(by).unwrap_or(end));
        Self { end, stop: self.stop.clone() }
    }
    /// The time that is left, if that is counted.
    pub fn left(&self) -> Option<Duration> {
        self.end.map(|end| end.saturating_duration_since(Instant::now()))
    }
    /// Whether the search has to end.
    pub fn is_over(&self) -> bool {
        self.is_asked() || self.is_late()
    }
    /// Whether somebody asked for the end.
    pub fn is_asked(&self) -> bool {
        self.stop.is_set()
    }
    /// Whether the time is over.
    pub fn is_late(&self) -> bool {
        self.end.is_some_and(|end| Instant::now() >= end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_request_reaches_those_below_and_not_above() {
        let above = Stop::default();
        let below = above.below();
        assert!(!below.set());
        assert!(below.set() && below.is_set() && !above.is_set());
        let other = above.below();
        let same = above.clone();
        same.set();
        assert!(other.is_set() && above.is_set() && same.is_set());
    }

    #[test]
    fn a_limit_is_over_by_time_or_by_request() {
        let stop = Stop::default();
        let long = Limit::new(Some(Duration::MAX), &stop);
        assert!(!long.is_over() && Limit::new(Some(Duration::ZERO), &stop).is_late());
        stop.set();
        assert!(long.is_asked() && long.is_over() && !long.is_late());
    }
}
