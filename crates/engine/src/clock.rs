//! The clock that time limits are measured with.
//!
//! In a browser the standard library has none, and asking for it panics. There it stands still: budgets count work, and
//! whoever wants an end by the clock ends the worker.

#[cfg(not(target_family = "wasm"))]
pub use std::time::Instant;

#[cfg(target_family = "wasm")]
pub use still::Instant;

#[cfg(target_family = "wasm")]
mod still {
    use std::time::Duration;

    /// A moment: so long after the only one that is ever now.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub struct Instant(Duration);

    impl Instant {
        /// The only moment that is ever now.
        pub fn now() -> Self {
            Self(Duration::ZERO)
        }
        /// The time since this moment: none.
        pub fn elapsed(&self) -> Duration {
            Duration::ZERO
        }
        /// A later moment.
        pub fn checked_add(&self, by: Duration) -> Option<Self> {
            self.0.checked_add(by).map(Self)
        }
        /// An earlier moment.
        pub fn checked_sub(&self, by: Duration) -> Option<Self> {
            self.0.checked_sub(by).map(Self)
        }
        /// The time from an earlier moment to this one.
        pub fn saturating_duration_since(&self, earlier: Self) -> Duration {
            self.0.saturating_sub(earlier.0)
        }
    }
}
