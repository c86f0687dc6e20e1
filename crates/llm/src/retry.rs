//! When to try again: waits that double, with chance in them so that many clients do not come back together.

use std::time::Duration;

/// How patient to be with what may pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Retry {
    /// How often a request is made, at most.
    pub tries: u32,
    /// The wait after the first failure; it doubles with each.
    pub first: Duration,
    /// The longest wait. A provider that asks for more is not asked again.
    pub longest: Duration,
    /// Fixes the part that chance has in the waits.
    pub seed: u64,
}

impl Default for Retry {
    fn default() -> Self {
        Self { tries: 4, first: Duration::from_secs(1), longest: Duration::from_secs(60), seed: 0 }
    }
}

impl Retry {
    /// How long to wait after so many failures, if the provider `told` how long it wants to be left alone. `None`: longer
    /// than we want to.
    pub(crate) fn wait(&self, failures: u32, told: Option<Duration>) -> Option<Duration> {
        let chance = chance(self.seed, failures);
        match told {
            // Never earlier than told, and a little later, each client at another time.
            Some(told) => (told <= self.longest).then(|| told + self.first.mul_f64(0.5 * chance)),
            None => {
                let doubled = self.first.saturating_mul(1 << failures.saturating_sub(1).min(16)).min(self.longest);
                Some(doubled.mul_f64(0.5 + 0.5 * chance))
            }
        }
    }
}

/// A number from 0 to 1 that looks like chance (the finaliser of splitmix64).
fn chance(seed: u64, n: u32) -> f64 {
    let mut z = seed.wrapping_add(u64::from(n).wrapping_mul(0x9e37_79b9_7f4a_7c15));
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waits_double_within_bounds() {
        let retry = Retry { seed: 7, ..Retry::default() };
        for n in 1..40 {
            let whole = 2_f64.powi(n as i32 - 1).min(60.0);
            let wait = retry.wait(n, None).unwrap().as_secs_f64();
            assert!((0.5 * whole..=whole).contains(&wait), "{n}: {wait}");
        }
        assert_eq!(retry.wait(3, None), retry.wait(3, None));
        assert_ne!(retry.wait(3, None), Retry { seed: 8, ..retry }.wait(3, None));
    }

    #[test]
    fn what_a_provider_asks_for_is_kept() {
        let retry = Retry::default();
        let wait = retry.wait(1, Some(Duration::from_secs(5))).unwrap().as_secs_f64();
        assert!((5.0..=5.5).contains(&wait), "{wait}");
        assert_eq!(retry.wait(1, Some(Duration::from_secs(3600))), None);
    }
}
