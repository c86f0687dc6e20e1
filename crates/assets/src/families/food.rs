//! Food and what holds it: fruit, sandwiches and cakes, jars, shakers, a mortar, a dome of glass.

use super::strokes::{at, of, pearl, small};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use std::f64::consts::TAU;
use std::ops::Range;

/// Fruit with a stalk, each in its own shape and colour.
pub(super) fn apple(a: &Ask) -> BuiltModel {
    let skin = |color: u32| a.main(Stuff(Finish::Ceramic, color));
    small(a, |mesh| {
        if a.says(&["pear"]) {
            pear(mesh, &skin(0xb9b23c));
        } else if a.says(&["pineapple"]) {
            pineapple(mesh, &skin(0xc9912e));
        } else if a.says(&["watermelon", "melon"]) {
            melon(mesh, &skin(0x2f6a35));
        } else if a.says(&["pumpkin", "squash"]) {
            pumpkin(mesh, &skin(if a.says(&["squash"]) { 0xd9a441 } else { 0xd9762b }));
        } else if a.says(&["tomato"]) {
            tomato(mesh, &skin(0xcf3526));
        } else if a.says(&["peach", "apricot"]) {
            round_fruit(mesh, &skin(0xe59a5f));
        } else {
            round_fruit(mesh, &skin(if a.says(&["lemon"]) { 0xe8cf3f } else { 0xb92f2a }));
        }
    })
}

/// A round body of radius 1.
fn body(mesh: &mut Mesh, y: Range<f64>, profile: &[(f64, f64)], s: &Surface) {
    mesh.lathe(block(-1.0..1.0, y, -1.0..1.0), profile, 24, s);
}

fn stalk() -> Surface {
    of(Finish::Wood, 0x5f4426)
}

fn pear(mesh: &mut Mesh, skin: &Surface) {
    let profile =
        [(0.3, 0.0), (0.8, 0.06), (1.0, 0.25), (0.92, 0.42), (0.62, 0.6), (0.46, 0.78), (0.38, 0.92), (0.12, 1.0)];
    body(mesh, 0.0..2.4, &profile, skin);
    mesh.tube(&[at(0.0, 2.35, 0.0), at(0.05, 2.6, 0.0), at(0.12, 2.75, 0.0)], 0.06, &stalk());
}

fn pineapple(mesh: &mut Mesh, skin: &Surface) {
    let profile = [(0.6, 0.0), (0.9, 0.1), (1.0, 0.4), (0.95, 0.7), (0.7, 0.93), (0.3, 1.0)];
    body(mesh, 0.0..2.4, &profile, skin);
    for k in 0..30 {
        let (y, turn) = (0.3 + 0.42 * f64::from(k / 6), TAU * (f64::from(k % 6) + 0.5 * f64::from(k / 6 % 2)) / 6.0);
        let (sin, cos) = turn.sin_cos();
        let eye = block(-0.16..0.16, -0.16..0.16, -0.16..0.16).moved(0.88 * cos, y, 0.88 * sin);
        pearl(mesh, eye, &of(Finish::Ceramic, 0x9a6a22));
    }
    for k in 0..14 {
        let (sin, cos) = (f64::from(k) * 2.4).sin_cos();
        let out = 0.2 + 0.05 * f64::from(k);
        let leaf = [
            (at(0.1 * cos, 2.3, 0.1 * sin), 0.16, 0.04),
            (at(0.6 * out * cos, 3.0, 0.6 * out * sin), 0.14, 0.04),
            (at(out * cos, 4.3 - 1.2 * out, out * sin), 0.02, 0.01),
        ];
        mesh.sweep(&leaf, at(cos, 0.2, sin), 6, &stuff::LEAF.surface());
    }
}

/// A ball with stripes from pole to pole.
fn melon(mesh: &mut Mesh, skin: &Surface) {
    body(mesh, 0.0..2.0, &crate::shapes::sphere(14), skin);
    for k in 0..5 {
        mesh.place(at(0.0, 1.0, 0.0), [90.0, 36.0 * f64::from(k) + 11.0, 0.0], |mesh| {
            mesh.torus(block(-1.005..1.005, -0.09..0.09, -1.005..1.005), 0.06, &shade(skin, 1.6));
        });
    }
}

/// Ribs round the middle, and a stalk.
fn pumpkin(mesh: &mut Mesh, skin: &Surface) {
    for k in 0..10 {
        let (sin, cos) = (TAU * f64::from(k) / 10.0).sin_cos();
        mesh.ball(block(-0.42..0.42, 0.0..1.6, -0.42..0.42).moved(0.58 * cos, 0.0, 0.58 * sin), skin);
    }
    let stalk = [at(0.0, 1.2, 0.0), at(0.0, 1.65, 0.0), at(0.14, 1.86, 0.05)];
    mesh.tube(&stalk, 0.13, &of(Finish::Leaf, 0x6d7a34));
}

fn tomato(mesh: &mut Mesh, skin: &Surface) {
    let leaf = stuff::LEAF.surface();
    let profile = [(0.4, 0.0), (0.85, 0.1), (1.0, 0.42), (0.9, 0.75), (0.5, 0.97), (0.14, 0.92)];
    body(mesh, 0.0..1.6, &profile, skin);
    for k in 0..5 {
        let (sin, cos) = (TAU * f64::from(k) / 5.0).sin_cos();
        let path = [
            (at(0.0, 1.56, 0.0), 0.1, 0.03),
            (at(0.35 * cos, 1.62, 0.35 * sin), 0.1, 0.03),
            (at(0.62 * cos, 1.5, 0.62 * sin), 0.01, 0.01),
        ];
        mesh.sweep(&path, at(0.0, 1.0, 0.0), 6, &leaf);
    }
    mesh.rod(at(0.0, 1.5, 0.0), at(0.0, 1.75, 0.0), 0.06, &leaf);
}

/// An apple, a peach or a lemon: with a hollow for the stalk, and one leaf.
fn round_fruit(mesh: &mut Mesh, skin: &Surface) {
    let profile =
        [(0.3, 0.03), (0.62, 0.0), (0.9, 0.22), (1.0, 0.55), (0.93, 0.82), (0.62, 0.98), (0.3, 0.97), (0.08, 0.84)];
    body(mesh, 0.0..1.75, &profile, skin);
    mesh.tube(&[at(0.0, 1.45, 0.0), at(0.03, 1.8, 0.0), at(0.12, 2.05, 0.0)], 0.05, &stalk());
    let leaf =
        [(at(0.02, 1.78, 0.0), 0.03, 0.02), (at(0.32, 1.98, 0.08), 0.17, 0.03), (at(0.66, 2.0, 0.14), 0.01, 0.01)];
    mesh.sweep(&leaf, at(0.0, 1.0, 0.0), 8, &stuff::LEAF.surface());
}

/// What is eaten from the hand or a plate: a sandwich, a hamburger, a pie, pancakes, a cookie, a wheel of cheese.
pub(super) fn sandwich(a: &Ask) -> BuiltModel {
    let crust = a.main(Stuff(Finish::Ceramic, 0xc98f4a));
    small(a, |mesh| {
        if a.says(&["hamburger", "burger"]) {
            hamburger(mesh, &crust);
        } else if a.says(&["pancake"]) {
            for k in 0..3 {
                let y = 0.2 * f64::from(k);
                disc(mesh, 1.0 - 0.03 * f64::from(k), y..y + 0.2, &shade(&crust, if k == 2 { 0.9 } else { 1.1 }));
            }
            mesh.rounded(block(-0.18..0.18, 0.6..0.72, -0.16..0.16), 0.04, 1, &of(Finish::Ceramic, 0xf2d96b));
        } else if a.says(&["cookie", "biscuit"]) {
            disc(mesh, 1.0, 0.0..0.3, &crust);
            for k in 0..11 {
                let r = 0.26 * f64::from(k).sqrt();
                let (sin, cos) = (f64::from(k) * 2.4).sin_cos();
                let chip = block(-0.11..0.11, 0.24..0.38, -0.11..0.11).moved(r * cos, 0.0, r * sin);
                mesh.bead(chip, &of(Finish::Ceramic, CHOCOLATE));
            }
        } else if a.says(&["cheese"]) {
            cheese(mesh, &a.main(Stuff(Finish::Ceramic, 0xd9a132)));
        } else if a.says(&["pie", "cake", "tart", "quiche"]) {
            pie(mesh, &crust);
        } else {
            slices(mesh, &crust);
        }
    })
}

const CHOCOLATE: u32 = 0x5a3520;
const TOMATO: u32 = 0xcf3526;

/// A flat round thing whose edge is broken.
fn disc(mesh: &mut Mesh, r: f64, y: Range<f64>, s: &Surface) {
    mesh.lathe(block(-r..r, y, -r..r), &[(0.9, 0.0), (1.0, 0.3), (1.0, 0.7), (0.9, 1.0)], 24, s);
}

/// The two halves of a bun with what is between them, and sesame on top.
fn hamburger(mesh: &mut Mesh, crust: &Surface) {
    disc(mesh, 0.94, 0.0..0.24, crust);
    disc(mesh, 1.0, 0.24..0.44, &of(Finish::Ceramic, CHOCOLATE));
    mesh.crisp(block(-0.78..0.78, 0.44..0.48, -0.78..0.78), &of(Finish::Ceramic, 0xeab93c));
    disc(mesh, 0.98, 0.48..0.56, &of(Finish::Ceramic, TOMATO));
    disc(mesh, 1.05, 0.55..0.62, &stuff::LEAF.surface());
    let dome = [(0.97, 0.0), (1.0, 0.15), (0.92, 0.5), (0.6, 0.86), (0.0, 1.0)];
    mesh.lathe(block(-0.96..0.96, 0.61..1.2, -0.96..0.96), &dome, 24, crust);
    for k in 0..14 {
        let r = 0.2 + 0.04 * f64::from(k);
        let (sin, cos) = (f64::from(k) * 2.4).sin_cos();
        let y = 0.6 + 0.6 * (1.0 - (r / 1.0).powi(2)).sqrt();
        let seed = block(-0.05..0.05, -0.03..0.05, -0.05..0.05).moved(r * cos, y, r * sin);
        mesh.bead(seed, &stuff::SHEET.surface());
    }
}

/// A wheel with a slice taken out.
fn cheese(mesh: &mut Mesh, rind: &Surface) {
    const N: i32 = 20;
    for k in 0..N - 3 {
        let point = |k: i32| {
            let (sin, cos) = (TAU * f64::from(k) / f64::from(N)).sin_cos();
            (cos, sin)
        };
        mesh.extrude(1, &[(0.0, 0.0), point(k), point(k + 1)], 0.0..0.8, rind);
    }
    for turn in [0, N - 3] {
        let degrees = 360.0 * f64::from(turn) / f64::from(N);
        let side = if turn == 0 { 0.0..0.015 } else { -0.015..0.0 };
        // At no turn the edge of the slice lies along z.
        mesh.place(at(0.0, 0.0, 0.0), [0.0, degrees, 0.0], |mesh| {
            mesh.crisp(block(-side.end..-side.start, 0.03..0.77, 0.03..0.97), &shade(rind, 1.9));
        });
    }
}

/// A tin with a filling under a lattice of dough.
fn pie(mesh: &mut Mesh, crust: &Surface) {
    let tin = [(0.78, 0.0), (1.0, 1.0), (0.9, 1.0), (0.86, 0.8)];
    mesh.lathe(block(-1.0..1.0, 0.0..0.42, -1.0..1.0), &tin, 24, &stuff::STEEL.surface());
    mesh.torus(block(-1.0..1.0, 0.36..0.56, -1.0..1.0), 0.16, crust);
    mesh.drum(block(-0.88..0.88, 0.3..0.43, -0.88..0.88), &of(Finish::Ceramic, 0xa8352c));
    for k in -2..=2 {
        let t = 0.32 * f64::from(k);
        let half = (0.84_f64.powi(2) - t * t).sqrt();
        mesh.rounded(block(t - 0.08..t + 0.08, 0.4..0.5, -half..half), 0.02, 1, crust);
        mesh.rounded(block(-half..half, 0.42..0.53, t - 0.08..t + 0.08), 0.02, 1, crust);
    }
}

/// Two slices of bread with salad, cheese and ham.
fn slices(mesh: &mut Mesh, crust: &Surface) {
    let (bread, green) = (of(Finish::Ceramic, 0xe6c88f), stuff::LEAF.surface());
    let mut slice = |low: f64, half: f64, high: f64, s: &Surface| {
        mesh.extrude(1, &[(-half, -half), (-half, half), (half, half), (half, -half)], low..low + high, s);
    };
    for low in [0.0, 0.7] {
        slice(low, 1.0, 0.34, crust);
        slice(low - 0.01, 0.93, 0.36, &bread);
    }
    slice(0.34, 0.96, 0.1, &green);
    slice(0.44, 0.9, 0.1, &of(Finish::Ceramic, 0xeab93c));
    slice(0.54, 0.98, 0.09, &of(Finish::Ceramic, 0xe0908a));
    slice(0.62, 0.94, 0.09, &green);
}

/// Jars, tins and cans with a lid; glass shows what is in it.
pub(super) fn jar(a: &Ask) -> BuiltModel {
    let lid = a.second(Stuff(Finish::Metal, 0xb5a06a));
    let inside = if a.says(&["honey"]) {
        Some(0xd08a1f)
    } else if a.says(&["jam", "marmalade"]) {
        Some(0xa02436)
    } else if a.says(&["pickle"]) {
        Some(0x6f8a3a)
    } else if a.says(&["ink", "inkwell"]) {
        Some(0x1b2440)
    } else if a.says(&["sugar", "salt", "flour"]) {
        Some(0xe6ded0)
    } else {
        None
    };
    let tin = a.says(&["tin", "can", "canister", "biscuit", "paint", "soda"]);
    small(a, |mesh| {
        if a.says(&["medicine", "pill", "vitamin"]) {
            mesh.lathe(
                block(-0.9..0.9, 0.0..1.5, -0.9..0.9),
                &[(0.95, 0.0), (1.0, 0.03), (1.0, 0.88), (0.75, 1.0)],
                24,
                &a.main(Stuff(Finish::Plastic, 0xd0752a)),
            );
            mesh.lathe(
                block(-0.92..0.92, 0.3..1.1, -0.92..0.92),
                &[(1.0, 0.0), (1.0, 1.0)],
                24,
                &stuff::PAPER.surface(),
            );
            mesh.drum(block(-1.0..1.0, 1.48..2.0, -1.0..1.0), &stuff::PLASTIC.surface());
        } else if tin {
            let tin = a.main(Stuff(Finish::Metal, 0x9c3d38));
            mesh.lathe(block(-0.97..0.97, 0.0..1.7, -0.97..0.97), &[(1.0, 0.0), (1.0, 1.0)], 24, &tin);
            for y in [0.0..0.06, 1.66..1.74] {
                mesh.torus(block(-1.0..1.0, y, -1.0..1.0), 0.06, &stuff::STEEL.surface());
            }
            mesh.lathe(
                block(-0.98..0.98, 0.5..1.2, -0.98..0.98),
                &[(1.0, 0.0), (1.0, 1.0)],
                24,
                &stuff::PAPER.surface(),
            );
            if a.says(&["soda", "can"]) {
                mesh.lathe(
                    block(-0.9..0.9, 1.7..1.8, -0.9..0.9),
                    &[(1.0, 0.0), (0.9, 1.0), (0.85, 0.4)],
                    24,
                    &stuff::STEEL.surface(),
                );
            } else {
                mesh.lathe(block(-1.0..1.0, 1.72..1.98, -1.0..1.0), &[(1.0, 0.0), (1.0, 0.8), (0.96, 1.0)], 24, &tin);
                mesh.drum(block(-0.2..0.2, 1.97..2.1, -0.2..0.2), &stuff::BRASS.surface());
            }
        } else {
            let glass = a.main(stuff::GLASS);
            let body = [(0.86, 0.0), (0.98, 0.05), (1.0, 0.12), (1.0, 0.8), (0.92, 0.9), (0.78, 0.95), (0.78, 1.0)];
            mesh.lathe(block(-1.0..1.0, 0.0..1.7, -1.0..1.0), &body, 24, &glass);
            if let Some(color) = inside {
                mesh.lathe(
                    block(-0.95..0.95, 0.04..1.25, -0.95..0.95),
                    &[(0.9, 0.0), (1.0, 0.06), (1.0, 1.0)],
                    24,
                    &of(Finish::Ceramic, color),
                );
            }
            mesh.lathe(block(-0.9..0.9, 1.66..2.0, -0.9..0.9), &[(1.0, 0.0), (1.0, 0.85), (0.94, 1.0)], 24, &lid);
            mesh.lathe(
                block(-1.01..1.01, 0.45..1.05, -1.01..1.01),
                &[(1.0, 0.0), (1.0, 1.0)],
                24,
                &stuff::PAPER.surface(),
            );
        }
    })
}

/// Shakers with holes, mills with a knob, and the one for drinks.
pub(super) fn shaker(a: &Ask) -> BuiltModel {
    let steel = stuff::CHROME.surface();
    small(a, |mesh| {
        if a.says(&["mill", "grinder"]) {
            let wood = a.main(Stuff(Finish::Wood, 0x7a4a2a));
            mesh.lathe(
                block(-1.0..1.0, 0.0..4.3, -1.0..1.0),
                &[(0.95, 0.0), (1.0, 0.05), (0.9, 0.2), (0.62, 0.42), (0.72, 0.7), (0.9, 0.9), (0.85, 1.0)],
                24,
                &wood,
            );
            mesh.lathe(
                block(-0.86..0.86, 4.35..5.6, -0.86..0.86),
                &[(0.9, 0.0), (1.0, 0.2), (0.9, 0.6), (0.4, 1.0)],
                24,
                &wood,
            );
            mesh.drum(block(-0.7..0.7, 4.25..4.4, -0.7..0.7), &steel);
            mesh.ball(block(-0.26..0.26, 5.5..6.0, -0.26..0.26), &steel);
        } else if a.says(&["cocktail"]) {
            let metal = a.main(Stuff(Finish::Chrome, 0xb4bbc0));
            mesh.lathe(block(-1.0..1.0, 0.0..3.0, -1.0..1.0), &[(0.74, 0.0), (0.78, 0.02), (1.0, 1.0)], 24, &metal);
            mesh.lathe(
                block(-1.0..1.0, 2.98..4.1, -1.0..1.0),
                &[(1.0, 0.0), (1.0, 0.1), (0.85, 0.5), (0.5, 0.85), (0.46, 1.0)],
                24,
                &shade(&metal, 0.9),
            );
            mesh.lathe(block(-0.52..0.52, 4.08..4.9, -0.52..0.52), &[(1.0, 0.0), (1.0, 0.7), (0.6, 1.0)], 24, &metal);
        } else {
            let pepper = a.says(&["pepper"]);
            let glass = a.main(stuff::GLASS);
            mesh.lathe(
                block(-1.0..1.0, 0.0..2.6, -1.0..1.0),
                &[(0.94, 0.0), (1.0, 0.04), (0.92, 0.5), (0.76, 1.0)],
                12,
                &glass,
            );
            let filled = of(Finish::Ceramic, if pepper { 0x3a3230 } else { 0xe9e4da });
            mesh.lathe(block(-0.92..0.92, 0.1..1.7, -0.92..0.92), &[(0.94, 0.0), (0.98, 0.1), (0.9, 1.0)], 12, &filled);
            mesh.lathe(
                block(-0.82..0.82, 2.55..3.6, -0.82..0.82),
                &[(1.0, 0.0), (1.0, 0.4), (0.85, 0.75), (0.5, 0.97), (0.0, 1.0)],
                24,
                &steel,
            );
            // The hole in the middle is highest.
            mesh.bead(block(-0.08..0.08, 3.5..3.66, -0.08..0.08), &stuff::DARK_PLASTIC.surface());
            for k in 0..6 {
                let (sin, cos) = (TAU * f64::from(k) / 6.0).sin_cos();
                mesh.bead(
                    block(-0.08..0.08, 3.44..3.58, -0.08..0.08).moved(0.4 * cos, 0.0, 0.4 * sin),
                    &stuff::DARK_PLASTIC.surface(),
                );
            }
        }
    })
}

/// A bowl of stone and what grinds in it.
pub(super) fn mortar(a: &Ask) -> BuiltModel {
    let stone = a.main(Stuff(Finish::Stone, 0x8d8a84));
    small(a, |mesh| {
        let bowl =
            [(0.6, 0.0), (0.62, 0.08), (0.5, 0.18), (0.85, 0.45), (1.0, 1.0), (0.85, 1.0), (0.7, 0.55), (0.3, 0.4)];
        mesh.lathe(block(-1.0..1.0, 0.0..1.3, -1.0..1.0), &bowl, 24, &stone);
        mesh.sweep(
            &[
                (at(-0.1, 0.6, 0.0), 0.24, 0.24),
                (at(0.05, 0.8, 0.0), 0.2, 0.2),
                (at(0.55, 1.5, 0.0), 0.12, 0.12),
                (at(0.8, 1.85, 0.0), 0.16, 0.16),
            ],
            at(0.0, 0.0, 1.0),
            12,
            &shade(&stone, 0.8),
        );
    })
}

/// A dome of glass with a knob over a plate.
pub(super) fn cheese_dome(a: &Ask) -> BuiltModel {
    let wood = a.main(stuff::OAK);
    small(a, |mesh| {
        mesh.drum(block(-1.0..1.0, 0.0..0.14, -1.0..1.0), &wood);
        mesh.lathe(
            block(-0.86..0.86, 0.14..1.25, -0.86..0.86),
            &[(1.0, 0.0), (1.0, 0.4), (0.9, 0.7), (0.6, 0.93), (0.1, 1.0)],
            24,
            &stuff::GLASS.surface(),
        );
        mesh.ball(block(-0.12..0.12, 1.22..1.46, -0.12..0.12), &stuff::GLASS.surface());
        mesh.extrude(1, &[(-0.5, -0.3), (0.5, 0.0), (-0.5, 0.4)], 0.14..0.6, &of(Finish::Ceramic, 0xe8b93c));
        mesh.torus(block(-0.88..0.88, 0.13..0.18, -0.88..0.88), 0.06, &stuff::GLASS.surface());
    })
}
