//! Numbers that look random and are the same everywhere: what the generators of tests throw.

/// A small generator of numbers (SplitMix64): the same seed gives the same program everywhere.
pub struct Dice(pub u64);

impl Dice {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }
    pub fn one<T: Clone>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())].clone()
    }
    /// With three digits.
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        let part = self.below(100_001) as f64 / 1e5;
        ((lo + part * (hi - lo)) * 1000.0).round() / 1000.0
    }
    pub fn chance(&mut self, percent: usize) -> bool {
        self.below(100) < percent
    }
}
