//! What is hard: metal, stone, tiles, plaster.

use super::noise::{Clouds, Noise, cell, from_whole};
use super::{Places, Texel};

/// Brushed along v.
pub(super) fn metal() -> Places {
    let (fine, hair) = (Noise::new(64, 3, 5), Noise::new(128, 6, 6));
    Box::new(move |u, v| {
        let brush = 0.5 * fine.at(u, v) + 0.5 * hair.at(u, v);
        Texel { light: 0.92 + 0.07 * (brush - 0.5), height: 0.00004 * brush, rough: 0.75 + 0.3 * (brush - 0.5) }
    })
}

/// Clouds, grains and a few veins.
pub(super) fn stone() -> Places {
    let (clouds, bent) = (Clouds::new(3, 3, 5, 15), Clouds::new(2, 2, 4, 33));
    let (strong, specks) = (Noise::new(3, 3, 44), Noise::new(64, 64, 55));
    Box::new(move |u, v| {
        let cloud = clouds.at(u, v);
        // A vein is where slow noise passes through its middle.
        let vein = (1.0 - (bent.at(u, v) - 0.5).abs() * 28.0).max(0.0) * strong.at(u, v);
        let speck = (specks.at(u, v) - 0.7).max(0.0);
        Texel {
            light: 0.88 + 0.26 * (cloud - 0.5) - 0.12 * vein - 0.16 * speck,
            height: 0.0002 * cloud,
            rough: 0.82 + 0.3 * (cloud - 0.5),
        }
    })
}

/// Side of a tile and width of a joint, metres; tiles to the side of the picture.
const SIDE: f32 = 0.4;
const JOINT: f32 = 0.005;
const TILES: f32 = 2.0;

/// Tiles with joints, each a little different.
pub(super) fn tiles() -> Places {
    let glaze = Noise::new(4, 4, 65);
    Box::new(move |u, v| {
        let (x, y) = (u * TILES, v * TILES);
        let edge = |t: f32| from_whole(t) * SIDE;
        let within = edge(x).min(edge(y));
        let pixel = SIDE * TILES / 256.0;
        let joint = ((JOINT / 2.0 + pixel / 2.0 - within) / pixel).clamp(0.0, 1.0);
        let bevel = (1.0 - (within - JOINT / 2.0) / 0.004).clamp(0.0, 1.0);
        let fired = cell(x as u32, y as u32, 25);
        let light = 0.94 + 0.03 * (fired - 0.5) + 0.03 * (glaze.at(u, v) - 0.5);
        Texel { light: light * (1.0 - 0.4 * joint), height: -0.0012 * bevel * bevel, rough: 0.45 + 0.5 * joint }
    })
}

/// Trowelled smooth, and painted.
pub(super) fn plaster() -> Places {
    let (trowel, grain) = (Clouds::new(3, 3, 4, 75), Noise::new(64, 64, 85));
    Box::new(move |u, v| {
        let (trowel, grain) = (trowel.at(u, v), grain.at(u, v));
        Texel {
            light: 0.955 + 0.035 * (trowel - 0.5) + 0.012 * (grain - 0.5),
            height: 0.00015 * trowel + 0.0001 * grain,
            rough: 0.93,
        }
    })
}
