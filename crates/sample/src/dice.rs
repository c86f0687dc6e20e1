//! Random numbers of one sample: a stream of its own, fixed by the seed of the run and the sample's number, so that it does
//! not matter which process draws it, or after which others.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};

/// The seed of one sample. Below 2^53, since readers of JSON keep no more digits.
pub fn seed_of(seed: u64, index: u64) -> u64 {
    let mut generator = ChaCha8Rng::seed_from_u64(seed);
    generator.set_stream(index);
    generator.next_u64() >> 11
}

pub struct Dice(ChaCha8Rng);

impl Dice {
    /// The stream of a sample.
    pub fn new(seed: u64) -> Self {
        let mut generator = ChaCha8Rng::seed_from_u64(seed);
        // Draws of `rand` and the solver have streams of the same seed: this one is none of theirs.
        generator.set_stream(u64::MAX);
        Self(generator)
    }
    /// Uniform on [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }
    /// Uniform between two numbers.
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }
    /// Uniform on 0..n; 0 for n = 0.
    pub fn below(&mut self, n: usize) -> usize {
        ((self.unit() * n as f64) as usize).min(n.saturating_sub(1))
    }
    /// Of either sign, its size as likely to be in one decade between the two as in the next: steps of all sizes.
    pub fn step(&mut self, least: f64, most: f64) -> f64 {
        let size = least * (most / least).max(1.0).powf(self.unit());
        if self.below(2) == 0 { size } else { -size }
    }
    /// An index, by weights.
    pub fn pick(&mut self, weights: impl Iterator<Item = f64> + Clone) -> usize {
        let mut left = self.unit() * weights.clone().sum::<f64>();
        let mut last = 0;
        for (i, weight) in weights.enumerate().filter(|(_, weight)| *weight > 0.0) {
            last = i;
            left -= weight;
            if left < 0.0 {
                break;
            }
        }
        last
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seeds_differ_and_what_weighs_nothing_is_never_picked() {
        let seeds: std::collections::BTreeSet<u64> = (0..1000).map(|i| seed_of(7, i)).collect();
        assert_eq!(seeds.len(), 1000);
        assert!(seeds.iter().all(|seed| *seed < 1 << 53));
        let mut dice = Dice::new(1);
        let mut counts = [0; 4];
        for _ in 0..4000 {
            counts[dice.pick([1.0, 0.0, 2.0, 0.0].into_iter())] += 1;
        }
        assert_eq!((counts[1], counts[3]), (0, 0));
        assert!((counts[0] as f64 - 1333.0).abs() < 150.0);
        assert!((0..1000).all(|_| (0.001..=5.0).contains(&dice.step(0.001, 5.0).abs())));
    }
}
