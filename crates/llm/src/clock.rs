//! Time, as far as waiting needs it; tests have a clock of their own.

use std::time::{Duration, Instant};

/// How often a sleeper looks whether somebody wants to end it.
const LOOK: Duration = Duration::from_millis(50);

/// Tells the time and lets it pass.
pub trait Clock {
    /// Since some moment in the past.
    fn now(&self) -> Duration;
    /// Waits. `false`: somebody ended it.
    fn sleep(&mut self, time: Duration) -> bool;
}

/// The clock of the machine.
pub struct SystemClock {
    begun: Instant,
    stop: fn() -> bool,
}

impl SystemClock {
    /// A clock that stops waiting when `stop` says so.
    pub fn new(stop: fn() -> bool) -> Self {
        Self { begun: Instant::now(), stop }
    }
}

impl Clock for SystemClock {
    fn now(&self) -> Duration {
        self.begun.elapsed()
    }
    fn sleep(&mut self, time: Duration) -> bool {
        let end = self.now().saturating_add(time);
        while !(self.stop)() {
            let left = end.saturating_sub(self.now());
            if left.is_zero() {
                return true;
            }
            std::thread::sleep(left.min(LOOK));
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waiting_can_be_ended() {
        assert!(SystemClock::new(|| false).sleep(Duration::ZERO));
        assert!(!SystemClock::new(|| true).sleep(Duration::from_secs(1_000_000)));
    }
}
