//! Instruments to blow: straight ones of wood or silver, brass with its bell, the saxophone, and the horn of a gramophone.

use super::strokes::{at, cone, flare, long, of, small};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use scenelang_layout::Vec3;
use std::f64::consts::TAU;

/// A flute, a clarinet, an oboe, a bassoon.
pub(super) fn flute(a: &Ask) -> BuiltModel {
    let silver = stuff::CHROME.surface();
    let across = a.says(&["flute", "piccolo"]);
    let usual = if across {
        Stuff(Finish::Chrome, 0xc3c9ce)
    } else if a.says(&["bassoon"]) {
        Stuff(Finish::Wood, 0x6b2f22)
    } else {
        Stuff(Finish::Wood, 0x2a2422)
    };
    let tube = a.main(usual);
    long(a, |mesh| {
        if across {
            cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, 1.0), [0.028, 0.028], &tube);
            mesh.rounded(block(-0.03..0.03, 0.015..0.04, 0.66..0.76), 0.01, 2, &silver);
            for z in [-0.5, 0.5] {
                cone(mesh, at(0.0, 0.0, z), at(0.0, 0.0, z + 0.06), [0.032, 0.032], &shade(&tube, 0.7));
            }
            keys(mesh, -0.9, 0.4, 0.028, &shade(&tube, 0.8));
        } else if a.says(&["bassoon"]) {
            for (x, top) in [(-0.05, 0.6), (0.05, 1.0)] {
                cone(mesh, at(x, 0.0, -1.0), at(x, 0.0, top), [0.05, 0.035], &tube);
            }
            keys(mesh, -0.8, 0.5, 0.05, &silver);
            cone(mesh, at(0.05, 0.0, 0.9), at(0.05, 0.0, 0.94), [0.05, 0.05], &stuff::CERAMIC.surface());
            mesh.tube(
                &[at(-0.05, 0.0, 0.58), at(-0.08, 0.0, 0.72), at(-0.2, 0.0, 0.7), at(-0.26, 0.0, 0.6)],
                0.012,
                &silver,
            );
        } else {
            cone(mesh, at(0.0, 0.0, -0.7), at(0.0, 0.0, 0.72), [0.042, 0.034], &tube);
            flare(mesh, &[(at(0.0, 0.0, -0.7), 0.043), (at(0.0, 0.0, -0.86), 0.055), (at(0.0, 0.0, -1.0), 0.1)], &tube);
            let mouth = [
                (at(0.0, 0.0, 0.72), 0.036, 0.036),
                (at(0.0, 0.0, 0.85), 0.036, 0.034),
                (at(0.0, 0.0, 1.0), 0.028, 0.008),
            ];
            mesh.sweep(&mouth, at(0.0, 1.0, 0.0), 10, &shade(&tube, 0.8));
            for z in [-0.68, 0.0, 0.7] {
                cone(mesh, at(0.0, 0.0, z), at(0.0, 0.0, z + 0.03), [0.05, 0.05], &silver);
            }
            keys(mesh, -0.6, 0.6, 0.04, &silver);
        }
    })
}

/// Keys in a row along a tube, and the rod that they turn on.
fn keys(mesh: &mut Mesh, from: f64, to: f64, r: f64, s: &Surface) {
    const N: u32 = 9;
    mesh.rod(at(0.7 * r, 0.9 * r, from), at(0.7 * r, 0.9 * r, to), 0.2 * r, s);
    for k in 0..N {
        let z = from + (to - from) * (f64::from(k) + 0.5) / f64::from(N);
        mesh.drum(block(-0.6 * r..0.6 * r, 0.85 * r..1.25 * r, z - 0.6 * r..z + 0.6 * r), s);
    }
}

/// Brass: a trumpet, a trombone, a tuba, a French horn, an alpine horn of wood, a megaphone.
pub(super) fn trumpet(a: &Ask) -> BuiltModel {
    let says = |word: &str| a.says(&[word]);
    let usual = if says("alpine") || says("alphorn") {
        Stuff(Finish::Wood, 0xb98a55)
    } else if says("megaphone") {
        Stuff(Finish::Plastic, 0xd2402f)
    } else {
        Stuff(Finish::Brass, 0xd0a640)
    };
    let brass = a.main(usual);
    let silver = stuff::CHROME.surface();
    long(a, |mesh| {
        if says("trombone") {
            flare(
                mesh,
                &[
                    (at(0.1, 0.0, -0.75), 0.012),
                    (at(0.1, 0.0, 0.0), 0.014),
                    (at(0.1, 0.0, 0.35), 0.03),
                    (at(0.1, 0.0, 0.5), 0.1),
                ],
                &brass,
            );
            mesh.tube(&arc([0.03, -0.75], 0.07, 0.0, -0.5), 0.012, &brass);
            for x in [-0.04, -0.12] {
                mesh.rod(at(x, 0.0, -0.75), at(x, 0.0, 1.0), 0.011, &brass);
            }
            mesh.tube(&arc([-0.08, 1.0], 0.04, 0.0, 0.5), 0.011, &brass);
            for z in [-0.55, 0.0] {
                mesh.rod(at(-0.12, 0.0, z), at(0.1, 0.0, z), 0.008, &silver);
            }
            mesh.rod(at(-0.04, 0.0, -0.75), at(-0.04, 0.0, -0.9), 0.02, &silver);
        } else if says("tuba") || says("sousaphone") || says("euphonium") {
            tuba(mesh, &brass, &silver);
        } else if says("french") {
            french(mesh, &brass, &silver);
        } else if says("alpine") || says("alphorn") {
            flare(
                mesh,
                &[
                    (at(0.0, 0.0, -1.0), 0.012),
                    (at(0.0, 0.0, 0.5), 0.03),
                    (at(0.02, 0.0, 0.8), 0.045),
                    (at(0.12, 0.0, 0.97), 0.07),
                    (at(0.24, 0.0, 1.02), 0.1),
                ],
                &brass,
            );
        } else if says("megaphone") {
            flare(
                mesh,
                &[
                    (at(0.0, 0.0, -1.0), 0.22),
                    (at(0.0, 0.0, -0.6), 0.2),
                    (at(0.0, 0.0, 0.8), 0.55),
                    (at(0.0, 0.0, 1.0), 0.62),
                ],
                &brass,
            );
            mesh.sweep(
                &[(at(-0.15, 0.0, -0.5), 0.07, 0.1), (at(-0.62, 0.0, -0.6), 0.07, 0.1)],
                at(0.0, 0.0, 1.0),
                10,
                &stuff::DARK_PLASTIC.surface(),
            );
            cone(mesh, at(0.0, 0.0, -1.1), at(0.0, 0.0, -0.98), [0.24, 0.24], &stuff::DARK_PLASTIC.surface());
        } else {
            flare(
                mesh,
                &[
                    (at(0.12, 0.0, -0.55), 0.03),
                    (at(0.12, 0.0, 0.35), 0.035),
                    (at(0.12, 0.0, 0.75), 0.07),
                    (at(0.12, 0.0, 0.93), 0.13),
                    (at(0.12, 0.0, 1.0), 0.24),
                ],
                &brass,
            );
            mesh.tube(&arc([0.0, -0.55], 0.12, 0.0, -0.5), 0.03, &brass);
            mesh.rod(at(-0.12, 0.0, -0.55), at(-0.12, 0.0, 0.5), 0.028, &brass);
            mesh.tube(&arc([0.0, 0.5], 0.12, 0.5, -0.5), 0.028, &brass);
            mesh.rod(at(0.12, 0.06, -0.9), at(0.12, 0.06, 0.5), 0.022, &brass);
            cone(mesh, at(0.12, 0.06, -0.88), at(0.12, 0.06, -1.0), [0.025, 0.06], &silver);
            for z in [-0.18, -0.04, 0.1] {
                mesh.rod(at(-0.2, 0.02, z), at(0.22, 0.02, z), 0.055, &brass);
                mesh.rod(at(0.2, 0.02, z), at(0.32, 0.02, z), 0.03, &silver);
            }
        }
    })
}

/// Part of a circle in the plane of z and x, about a middle (x, z), from one part of a turn to another; it begins at +x.
fn arc([x, z]: [f64; 2], r: f64, from: f64, by: f64) -> Vec<Vec3> {
    let point = |k: u32| {
        let (sin, cos) = (TAU * (from + by * f64::from(k) / 8.0)).sin_cos();
        at(x + r * cos, 0.0, z + r * sin)
    };
    (0..=8).map(point).collect()
}

/// Its bell is up; loops of tube below it, valves before them.
fn tuba(mesh: &mut Mesh, brass: &Surface, silver: &Surface) {
    flare(
        mesh,
        &[
            (at(0.2, 0.0, -0.6), 0.13),
            (at(0.2, 0.0, 0.2), 0.16),
            (at(0.2, 0.0, 0.7), 0.24),
            (at(0.2, 0.0, 0.92), 0.36),
            (at(0.2, 0.0, 1.0), 0.46),
        ],
        brass,
    );
    mesh.tube(&arc([-0.05, -0.6], 0.25, 0.0, -0.5), 0.13, brass);
    mesh.tube(&[at(-0.3, 0.0, -0.6), at(-0.3, 0.0, 0.35), at(-0.26, 0.03, 0.48)], 0.1, brass);
    mesh.tube(&arc([-0.12, 0.4], 0.16, 0.45, -0.45), 0.07, brass);
    mesh.tube(&[at(0.02, 0.0, 0.4), at(0.0, 0.1, 0.0), at(-0.04, 0.14, -0.5)], 0.05, brass);
    for k in 0..3 {
        let x = -0.18 + 0.11 * f64::from(k);
        mesh.rod(at(x, 0.2, -0.35), at(x, 0.2, 0.1), 0.05, silver);
        mesh.rod(at(x, 0.2, 0.1), at(x, 0.2, 0.18), 0.025, brass);
    }
    mesh.tube(&[at(-0.12, 0.05, 0.5), at(-0.15, 0.2, 0.56), at(-0.2, 0.3, 0.52)], 0.025, silver);
}

/// A wide coil with its bell to one side and down.
fn french(mesh: &mut Mesh, brass: &Surface, silver: &Surface) {
    for (r, y) in [(0.5, -0.06), (0.42, 0.06)] {
        mesh.tube(&arc([0.0, 0.2], r, 0.0, 0.5), 0.05, brass);
        mesh.tube(&arc([0.0, 0.2], r, 0.5, 0.5), 0.05, brass);
        mesh.rod(at(-0.1, y, 0.2 + r), at(0.1, y, 0.2 + r), 0.05, brass);
    }
    flare(
        mesh,
        &[
            (at(-0.5, 0.0, 0.2), 0.06),
            (at(-0.42, 0.0, -0.1), 0.09),
            (at(-0.2, 0.05, -0.36), 0.15),
            (at(0.1, 0.12, -0.52), 0.25),
            (at(0.26, 0.16, -0.6), 0.42),
        ],
        brass,
    );
    for k in 0..3 {
        let x = -0.2 + 0.16 * f64::from(k);
        mesh.rod(at(x, -0.1, 0.25), at(x, 0.2, 0.25), 0.07, silver);
    }
    mesh.tube(&[at(0.2, 0.0, 0.65), at(0.4, 0.0, 0.8), at(0.62, 0.0, 0.82)], 0.028, silver);
}

/// A tube that bends below to a bell that looks up, and above to the mouth.
pub(super) fn saxophone(a: &Ask) -> BuiltModel {
    let brass = a.main(Stuff(Finish::Brass, 0xd0a640));
    let dark = stuff::DARK_PLASTIC.surface();
    long(a, |mesh| {
        let bow = [
            (at(-0.16, 0.0, 0.82), 0.035),
            (at(-0.12, 0.0, 0.0), 0.07),
            (at(-0.08, 0.0, -0.65), 0.1),
            (at(0.0, 0.0, -0.86), 0.12),
            (at(0.14, 0.0, -0.9), 0.13),
            (at(0.28, 0.0, -0.76), 0.14),
            (at(0.34, 0.0, -0.4), 0.17),
            (at(0.4, 0.0, -0.05), 0.24),
            (at(0.42, 0.0, 0.04), 0.3),
        ];
        flare(mesh, &bow, &brass);
        mesh.tube(
            &[at(-0.16, 0.0, 0.82), at(-0.18, 0.0, 0.96), at(-0.3, 0.0, 1.02), at(-0.42, 0.0, 0.98)],
            0.032,
            &brass,
        );
        cone(mesh, at(-0.4, 0.0, 0.99), at(-0.58, 0.0, 0.9), [0.045, 0.02], &dark);
        mesh.rod(at(-0.05, 0.1, -0.6), at(-0.1, 0.08, 0.7), 0.014, &brass);
        for k in 0..9 {
            let z = -0.55 + 0.14 * f64::from(k);
            let x = -0.11 - 0.03 * f64::from(k) / 9.0;
            mesh.rod(at(x, 0.05, z), at(x, 0.13, z), 0.055, &stuff::CERAMIC.surface());
        }
        for (x, z) in [(0.3, -0.55), (0.33, -0.3)] {
            mesh.rod(at(x, 0.1, z), at(x, 0.2, z), 0.08, &brass);
        }
    })
}

/// A box with a turntable, and the horn over it.
pub(super) fn gramophone(a: &Ask) -> BuiltModel {
    let wood = a.main(stuff::WALNUT);
    let brass = a.second(Stuff(Finish::Brass, 0xc79b45));
    let dark = stuff::DARK_PLASTIC.surface();
    small(a, |mesh| {
        mesh.rounded(block(-0.5..0.5, 0.0..0.06, -0.5..0.5), 0.02, 1, &wood);
        mesh.rounded(block(-0.46..0.46, 0.05..0.36, -0.46..0.46), 0.02, 1, &wood);
        mesh.drum(block(-0.38..0.38, 0.36..0.4, -0.36..0.4), &dark);
        mesh.drum(block(-0.13..0.13, 0.4..0.405, -0.11..0.15), &of(Finish::Paper, 0xb5432e));
        mesh.rod(at(0.44, 0.22, 0.1), at(0.54, 0.22, 0.1), 0.02, &brass);
        let horn = [
            (at(0.0, 0.4, -0.42), 0.04),
            (at(0.0, 0.72, -0.44), 0.05),
            (at(0.0, 0.95, -0.3), 0.09),
            (at(0.0, 1.03, -0.02), 0.18),
            (at(0.0, 1.05, 0.26), 0.32),
            (at(0.0, 1.06, 0.4), 0.5),
        ];
        flare(mesh, &horn, &brass);
        mesh.tube(&[at(0.0, 0.6, -0.42), at(0.0, 0.52, -0.2), at(0.05, 0.42, 0.1)], 0.025, &stuff::STEEL.surface());
    })
}
