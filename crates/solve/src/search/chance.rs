//! Random numbers from a stream that is the same everywhere.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::RngCore;

/// Random numbers from a stream that is the same everywhere.
pub(crate) trait Chance {
    /// Uniform on [0, 1).
    fn unit(&mut self) -> f64;
    /// Uniform between two numbers.
    fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }
    /// Uniform on 0..n; 0 for n = 0.
    fn below(&mut self, n: usize) -> usize {
        ((self.unit() * n as f64) as usize).min(n.saturating_sub(1))
    }
}

impl Chance for ChaCha8Rng {
    fn unit(&mut self) -> f64 {
        (self.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }
}
