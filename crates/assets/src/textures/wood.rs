//! Wood, as it is sawn and as it lies on a floor.

use super::Texel;
use super::noise::{cell, clouds, fraction, from_whole, noise};

/// How dark the grain is at a place, 0 to 1: late wood in lines that waver, broad bands, fine fibres.
fn grain(u: f32, v: f32, rings: u32, fibres: u32, seed: u32) -> f32 {
    let waver = clouds(u, v, 3, 2, 2, seed) * 2.4;
    let at = fraction(u * rings as f32 + waver);
    // Light early in the year, darker slowly, and then at once light again.
    let ring = at * at * (1.0 - ((at - 0.86) / 0.14).clamp(0.0, 1.0));
    let band = noise(u, v, 5, 2, seed + 7);
    let fibre = noise(u, v, fibres, 12, seed + 9);
    0.42 * ring + 0.33 * band + 0.25 * fibre
}

/// Grain along v.
pub(super) fn wood(u: f32, v: f32) -> Texel {
    let dark = grain(u, v, 22, 128, 11);
    let pore = (noise(u, v, 128, 24, 31) - 0.72).max(0.0);
    Texel { light: 0.97 - 0.24 * dark - 0.25 * pore, height: -0.0004 * pore, rough: 0.82 + 0.18 * dark }
}

/// Boards next to each other and rows of them in the tile.
const ACROSS: u32 = 12;
const ALONG: u32 = 3;

/// Boards 14 cm wide and 1.4 m long, each from another tree, with fine joints.
pub(super) fn boards(u: f32, v: f32) -> Texel {
    let x = u * ACROSS as f32;
    let row = x as u32 % ACROSS;
    // Neighbouring rows start elsewhere.
    let y = v * ALONG as f32 + cell(row, 7, 3) * ALONG as f32;
    let board = y as u32 % ALONG;
    let tone = cell(row, board, 5);
    let dark = grain(u + tone, v + cell(row, board, 9), 60, 256, 17);
    let edge = |t: f32, metres: f32| from_whole(t) * metres;
    // A joint is 3 mm wide; a pixel covers a part of it.
    let covered = |from_edge: f32, pixel: f32| ((0.0017 + pixel / 2.0 - from_edge) / pixel).clamp(0.0, 1.0);
    let joint = covered(edge(x, 0.14), 0.0033).max(covered(edge(y, 1.4), 0.0164));
    let light = (0.98 - 0.16 * tone - 0.15 * dark) * (1.0 - 0.36 * joint);
    Texel { light, height: -0.001 * joint, rough: (0.8 + 0.15 * dark).max(joint) }
}
