//! Wood, as it is sawn and as it lies on a floor.

use super::noise::{Clouds, Noise, cell, fraction, from_whole};
use super::{Places, Texel};

/// How dark the grain is: late wood in lines that waver, broad bands, fine fibres.
struct Grain {
    rings: f32,
    waver: Clouds,
    band: Noise,
    fibre: Noise,
}

impl Grain {
    fn new(rings: u32, fibres: u32, seed: u32) -> Self {
        Self {
            rings: rings as f32,
            waver: Clouds::new(3, 2, 2, seed),
            band: Noise::new(5, 2, seed + 7),
            fibre: Noise::new(fibres, 12, seed + 9),
        }
    }

    /// At a place, 0 to 1.
    fn at(&self, u: f32, v: f32) -> f32 {
        let at = fraction(u * self.rings + self.waver.at(u, v) * 2.4);
        // Light early in the year, darker slowly, and then at once light again.
        let ring = at * at * (1.0 - ((at - 0.86) / 0.14).clamp(0.0, 1.0));
        0.42 * ring + 0.33 * self.band.at(u, v) + 0.25 * self.fibre.at(u, v)
    }
}

/// Grain along v.
pub(super) fn wood() -> Places {
    let (grain, pores) = (Grain::new(22, 128, 11), Noise::new(128, 24, 31));
    Box::new(move |u, v| {
        let dark = grain.at(u, v);
        let pore = (pores.at(u, v) - 0.72).max(0.0);
        Texel { light: 0.97 - 0.24 * dark - 0.25 * pore, height: -0.0004 * pore, rough: 0.82 + 0.18 * dark }
    })
}

/// Boards next to each other and rows of them in the tile.
const ACROSS: u32 = 12;
const ALONG: u32 = 3;

/// Boards 14 cm wide and 1.4 m long, each from another tree, with fine joints.
pub(super) fn boards() -> Places {
    let grain = Grain::new(60, 256, 17);
    Box::new(move |u, v| {
        let x = u * ACROSS as f32;
        let row = x as u32 % ACROSS;
        // Neighbouring rows start elsewhere.
        let y = v * ALONG as f32 + cell(row, 7, 3) * ALONG as f32;
        let board = y as u32 % ALONG;
        let tone = cell(row, board, 5);
        let dark = grain.at(u + tone, v + cell(row, board, 9));
        let edge = |t: f32, metres: f32| from_whole(t) * metres;
        // A joint is 3 mm wide; a pixel covers a part of it.
        let covered = |from_edge: f32, pixel: f32| ((0.0017 + pixel / 2.0 - from_edge) / pixel).clamp(0.0, 1.0);
        let joint = covered(edge(x, 0.14), 0.0033).max(covered(edge(y, 1.4), 0.0164));
        let light = (0.98 - 0.16 * tone - 0.15 * dark) * (1.0 - 0.36 * joint);
        Texel { light, height: -0.001 * joint, rough: (0.8 + 0.15 * dark).max(joint) }
    })
}
