//! Noise that repeats: values at the points of a grid, smooth between them.

/// A repeatable number in 0..1 for a cell.
pub(super) fn cell(i: u32, j: u32, seed: u32) -> f32 {
    let mut h = i.wrapping_mul(0x9e37_79b9) ^ j.wrapping_mul(0x85eb_ca6b) ^ seed.wrapping_mul(0xc2b2_ae35);
    h = (h ^ (h >> 15)).wrapping_mul(0x2c1b_3c6d);
    h = (h ^ (h >> 12)).wrapping_mul(0x297a_2d39);
    ((h ^ (h >> 15)) >> 8) as f32 / (1 << 24) as f32
}

/// What is behind the point of a number that is not negative; much faster than `fract`.
pub(super) fn fraction(t: f32) -> f32 {
    t - t as u32 as f32
}

/// How far a number that is not negative is from the nearest whole one.
pub(super) fn from_whole(t: f32) -> f32 {
    (fraction(t + 0.5) - 0.5).abs()
}

/// Smooth noise of 0 to 1 with `across` by `along` cells in the tile; `u` and `v` in tiles, not negative.
pub(super) fn noise(u: f32, v: f32, across: u32, along: u32, seed: u32) -> f32 {
    let (x, y) = (fraction(u) * across as f32, fraction(v) * along as f32);
    let (i, j) = (x as u32, y as u32);
    let smooth = |t: f32| t * t * (3.0 - 2.0 * t);
    let (s, t) = (smooth(x - i as f32), smooth(y - j as f32));
    let at =
        |i: u32, j: u32| cell(if i < across { i } else { i - across }, if j < along { j } else { j - along }, seed);
    let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
    mix(mix(at(i, j), at(i + 1, j), s), mix(at(i, j + 1), at(i + 1, j + 1), s), t)
}

/// Noise of several sizes, each half the one before and half as strong: 0 to 1, about 0.5.
pub(super) fn clouds(u: f32, v: f32, across: u32, along: u32, octaves: u32, seed: u32) -> f32 {
    let (mut sum, mut all, mut weight) = (0.0, 0.0, 1.0);
    for k in 0..octaves {
        sum += weight * noise(u, v, across << k, along << k, seed + k);
        all += weight;
        weight *= 0.5;
    }
    sum / all
}

/// How far a place is from the nearest two of points scattered one to a cell, in cells.
pub(super) fn scattered(u: f32, v: f32, cells: u32, seed: u32) -> [f32; 2] {
    let (x, y) = (fraction(u) * cells as f32, fraction(v) * cells as f32);
    let (i, j) = (x as u32, y as u32);
    let mut near = [f32::MAX; 2];
    for dj in 0..3 {
        for di in 0..3 {
            let (a, b) = ((i + di + cells - 1) % cells, (j + dj + cells - 1) % cells);
            let px = (i + di) as f32 - 1.0 + cell(a, b, seed);
            let py = (j + dj) as f32 - 1.0 + cell(a, b, seed + 1);
            let d = (px - x).hypot(py - y);
            if d < near[0] {
                near = [d, near[0]];
            } else if d < near[1] {
                near[1] = d;
            }
        }
    }
    near
}
