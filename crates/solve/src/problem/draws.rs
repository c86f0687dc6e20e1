//! Draws of `rand` and `oneOf`: each uniform between its bounds, or among the arguments, fixed by the seed and its own key.
//!
//! So a draw keeps its value when statements elsewhere come and go.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use scenelang_lang::Program;
use scenelang_lang::program::DrawId;
use scenelang_layout::Layout;
use scenelang_verify::{Options, Value, World, evaluate};

/// Draws everything, in the order of the program: bounds depend on earlier draws at most.
/// Keys whose bounds have no value, or the wrong order, come back as the second part.
pub(crate) fn draw(program: &Program, seed: u64) -> (Vec<(String, f64)>, Vec<String>) {
    let mut world = World::<f64>::new(program, &Layout::default(), &Options::default());
    let mut drawn = Vec::new();
    let mut refused = Vec::new();
    for (index, draw) in program.draws.iter().enumerate() {
        let number = |formula| match evaluate(formula, &world) {
            Ok(Value::Number(n)) => Some(n),
            _ => None,
        };
        match (number(&draw.lo), number(&draw.hi)) {
            (Some(lo), Some(hi)) if lo <= hi => {
                let part = unit(seed, &draw.key);
                let value = if draw.is_choice { (part * (hi + 1.0)).floor() } else { lo + (hi - lo) * part };
                // Rounding must not lead out of the bounds.
                let value = value.clamp(lo, hi);
                world.set_draw(DrawId(index as u32), Ok(value));
                drawn.push((draw.key.clone(), value));
            }
            _ => refused.push(draw.key.clone()),
        }
    }
    (drawn, refused)
}

/// Uniform on [0, 1), by seed and key.
fn unit(seed: u64, key: &str) -> f64 {
    // FNV-1a: a stable hash, so that a key means the same draw in every version.
    let hash = key.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3));
    let mut generator = ChaCha8Rng::seed_from_u64(seed);
    generator.set_stream(hash);
    (generator.next_u64() >> 11) as f64 / (1u64 << 53) as f64
}

/// What `rand` yields, and which argument (from 0) `oneOf` chooses, for a seed, by key, in the order of the program. A draw
/// whose bounds have no value is left out.
pub fn draws(program: &Program, seed: u64) -> Vec<(String, f64)> {
    draw(program, seed).0
}
