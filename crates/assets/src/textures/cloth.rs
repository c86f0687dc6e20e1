//! What is soft or thin: fabric, leather, carpet, paper, leaves.

use super::noise::{Clouds, Noise, Scattered, cell, fraction};
use super::{Places, Texel};
use std::f32::consts::TAU;

/// A plain weave of threads 4 mm wide, none like the other.
pub(super) fn weave() -> Places {
    const THREADS: f32 = 24.0;
    let (spun, worn) = (Noise::new(48, 48, 5), Clouds::new(3, 3, 3, 21));
    Box::new(move |u, v| {
        let (x, y) = (u * THREADS, v * THREADS);
        let (i, j) = (x as u32, y as u32);
        let over = (i + j).is_multiple_of(2);
        // A thread is round across, and highest where it crosses over.
        let (across, along, thread) = if over { (x, y, cell(i, 1, 3)) } else { (y, x, cell(j, 2, 3)) };
        let bow = |t: f32| {
            let t = fraction(t);
            4.0 * t * (1.0 - t)
        };
        let height = bow(across).sqrt() * (0.55 + 0.45 * bow(along));
        let (spun, worn) = (spun.at(u, v), worn.at(u, v));
        let light = 0.8 + 0.14 * height + 0.05 * (thread - 0.5) + 0.05 * (spun - 0.5) + 0.02 * (worn - 0.5);
        Texel { light: light.min(1.0), height: 0.0009 * height, rough: 0.94 }
    })
}

/// Small cushions between creases.
pub(super) fn leather() -> Places {
    let (cushions, worn) = (Scattered::new(30, 41), Clouds::new(3, 3, 3, 51));
    Box::new(move |u, v| {
        let [near, next] = cushions.at(u, v);
        let crease = 1.0 - ((next - near) / 0.28).clamp(0.0, 1.0);
        let worn = worn.at(u, v);
        Texel {
            light: 0.97 - 0.1 * crease - 0.16 * (1.0 - worn),
            height: -0.00035 * crease * crease,
            rough: 0.72 + 0.16 * crease + 0.1 * worn,
        }
    })
}

/// Tufts of a short pile.
pub(super) fn carpet() -> Places {
    let (tufts, walked) = (Scattered::new(40, 61), Clouds::new(3, 3, 3, 71));
    Box::new(move |u, v| {
        let [near, _] = tufts.at(u, v);
        let tuft = 1.0 - near.min(1.0);
        let walked = walked.at(u, v);
        Texel { light: 0.76 + 0.16 * tuft + 0.05 * (walked - 0.5), height: 0.002 * tuft, rough: 1.0 }
    })
}

/// Fibres in all directions.
pub(super) fn paper() -> Places {
    let fibres = Clouds::new(16, 16, 3, 81);
    Box::new(move |u, v| {
        let fibre = fibres.at(u, v);
        Texel { light: 0.94 + 0.1 * (fibre - 0.5), height: 0.0002 * fibre, rough: 0.95 }
    })
}

/// Veins to both sides of a rib that runs along v.
pub(super) fn leaf() -> Places {
    const VEINS: f32 = 6.0;
    let mottled = Clouds::new(4, 4, 4, 91);
    Box::new(move |u, v| {
        let side = (u - 0.5).abs() * 2.0;
        let vein = ((v * VEINS - side * 2.0) * TAU).cos() * 0.5 + 0.5;
        let thin = (vein - 0.9).max(0.0) * 10.0 * (1.0 - side);
        let rib = (1.0 - side * 14.0).max(0.0);
        let mottled = mottled.at(u, v);
        let light = 0.74 + 0.3 * (mottled - 0.5) + 0.12 * thin.max(rib);
        Texel { light: light.clamp(0.0, 1.0), height: -0.0004 * thin.max(rib), rough: 0.78 + 0.2 * mottled }
    })
}
