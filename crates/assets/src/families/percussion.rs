//! Instruments to strike, to shake and to pluck: kettledrums, gongs, bars in rows, bells, maracas, a zither, an accordion.

use super::strokes::{at, cone, long, of, small};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::Mesh;
use crate::model::BuiltModel;
use std::f64::consts::TAU;

/// A copper bowl under a skin, on legs.
pub(super) fn timpani(a: &Ask) -> BuiltModel {
    let copper = a.main(Stuff(Finish::Metal, 0xb8693a));
    let chrome = stuff::CHROME.surface();
    small(a, |mesh| {
        let bowl = [(0.15, 0.0), (0.5, 0.06), (0.78, 0.25), (0.93, 0.55), (0.97, 1.0)];
        mesh.lathe(block(-0.5..0.5, 0.28..0.93, -0.5..0.5), &bowl, 24, &copper);
        mesh.torus(block(-0.52..0.52, 0.9..0.97, -0.52..0.52), 0.1, &chrome);
        mesh.drum(block(-0.49..0.49, 0.92..0.975, -0.49..0.49), &stuff::SHEET.surface());
        for k in 0..8 {
            let (sin, cos) = (TAU * f64::from(k) / 8.0).sin_cos();
            mesh.rod(at(0.53 * cos, 0.62, 0.53 * sin), at(0.53 * cos, 0.99, 0.53 * sin), 0.012, &chrome);
        }
        for k in 0..4 {
            let (sin, cos) = (TAU * (f64::from(k) + 0.5) / 4.0).sin_cos();
            mesh.tube(
                &[at(0.5 * cos, 0.6, 0.5 * sin), at(0.42 * cos, 0.2, 0.42 * sin), at(0.5 * cos, 0.02, 0.5 * sin)],
                0.02,
                &chrome,
            );
        }
    })
}

/// A shallow ring with a skin and pairs of jingles in its wall.
pub(super) fn tambourine(a: &Ask) -> BuiltModel {
    let wood = a.main(Stuff(Finish::Wood, 0xb9803f));
    let steel = stuff::CHROME.surface();
    small(a, |mesh| {
        for y in [0.0..0.07, 0.15..0.23] {
            mesh.lathe(block(-0.5..0.5, y, -0.5..0.5), &[(1.0, 0.0), (1.0, 1.0)], 24, &wood);
        }
        mesh.drum(block(-0.46..0.46, 0.2..0.24, -0.46..0.46), &stuff::LINEN.surface());
        mesh.drum(block(-0.4..0.4, 0.05..0.2, -0.4..0.4), &shade(&wood, 0.5));
        for k in 0..10 {
            let turn = 36.0 * f64::from(k);
            mesh.place(at(0.0, 0.0, 0.0), [0.0, turn, 0.0], |mesh| {
                for y in [0.08..0.105, 0.118..0.143] {
                    mesh.lathe(block(0.42..0.54, y, -0.07..0.07), &[(0.6, 0.0), (1.0, 0.5), (0.6, 1.0)], 12, &steel);
                }
            });
            let rest = turn + 18.0;
            mesh.place(at(0.0, 0.0, 0.0), [0.0, rest, 0.0], |mesh| {
                mesh.crisp(block(0.44..0.49, 0.06..0.16, -0.07..0.07), &wood);
            });
        }
    })
}

/// A disc of bronze that hangs in a frame.
pub(super) fn gong(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wood = a.second(Stuff(Finish::Wood, 0x5a2e20));
    let bronze = a.main(Stuff(Finish::Brass, 0xb5862f));
    for foot in b.share(0.0..0.1, 0.0..0.05, 0.0..1.0).both_sides() {
        m.board(foot, &wood);
    }
    for post in b.share(0.02..0.08, 0.05..0.94, 0.42..0.58).both_sides() {
        m.board(post, &wood);
    }
    m.board(b.share(0.0..1.0, 0.94..1.0, 0.4..0.6), &wood);
    m.board(b.share(0.08..0.92, 0.08..0.12, 0.45..0.55), &wood);
    let plate = b.share(0.14..0.86, 0.18..0.84, 0.46..0.54);
    m.disc(2, plate, &bronze);
    m.mesh.disc(2, plate.share(0.08..0.92, 0.08..0.92, 0.8..1.3), &shade(&bronze, 1.2));
    m.disc(2, plate.share(0.36..0.64, 0.36..0.64, 1.0..2.0), &bronze);
    for x in [0.32..0.34, 0.66..0.68] {
        m.mesh.crisp(b.share(x, 0.74..0.95, 0.49..0.51), &stuff::LINEN.surface());
    }
    m
}

const BARS: [u32; 8] = [0xc8392f, 0xe07b2f, 0xe3bd3a, 0x6da544, 0x3f8f7a, 0x3f78b0, 0x5a55a0, 0xa04f8c];

/// Bars that get shorter on two rails: of colours where it is small, of metal or wood on a stand with tubes where it is high.
pub(super) fn xylophone(a: &Ask) -> BuiltModel {
    let metal = a.says(&["glockenspiel", "vibraphone"]);
    let wood = a.second(stuff::WALNUT);
    let stands = a.h > 0.4;
    let usual = if metal { Stuff(Finish::Metal, 0xc3c8cc) } else { Stuff(Finish::Wood, 0x9c4a2a) };
    let plain = a.main(usual);
    let n = if stands { 18 } else { 8 };
    small(a, |mesh| {
        let (low, top) = if stands { (0.86, 1.0) } else { (0.0, 1.0) };
        let y = |t: f64| low + (top - low) * t;
        for side in [-1.0, 1.0] {
            let rail = [(-1.0, side * 0.72), (-1.0, side * 0.6), (1.0, side * 0.3), (1.0, side * 0.42)];
            // The points of an upright piece are (z, x).
            let rail = rail.map(|(x, z)| (z, x));
            mesh.extrude(1, &rail, y(0.0)..y(0.7), &wood);
        }
        for end in [-1.0..-0.92, 0.92..1.0] {
            let half = if end.start < 0.0 { 0.72 } else { 0.42 };
            mesh.crisp(block(end, y(0.0)..y(0.62), -half..half), &wood);
        }
        for (k, place) in block(-0.9..0.9, y(0.7)..y(1.0), -1.0..1.0).split(0, n, 0.03).enumerate() {
            let t = k as f64 / (n - 1) as f64;
            let half = 1.0 - 0.5 * t;
            let bar = place.z(-half..half);
            let colored = !stands && !metal && !a.has_color();
            let s = if colored { of(Finish::Paint, BARS[k % BARS.len()]) } else { plain.clone() };
            mesh.rounded(bar, 0.2 * bar.size().min(), 1, &s);
            if stands {
                let c = bar.center();
                let r = 0.4 * bar.size().x;
                mesh.lathe(
                    block(c.x - r..c.x + r, 0.78 - 0.5 * (1.0 - t)..0.86, -0.3 - 0.12..-0.3 + 0.12),
                    &[(1.0, 0.0), (1.0, 1.0)],
                    8,
                    &stuff::CHROME.surface(),
                );
            }
        }
        if stands {
            for x in [-0.96..-0.88, 0.88..0.96] {
                let half = if x.start < 0.0 { 0.7 } else { 0.4 };
                for z in [-half..-half + 0.1, half - 0.1..half] {
                    mesh.crisp(block(x.clone(), 0.0..0.86, z), &wood);
                }
            }
            mesh.crisp(block(-0.9..0.9, 0.12..0.17, -0.06..0.06), &wood);
        }
    })
}

/// A cymbal on a stand with three feet.
pub(super) fn cymbal(a: &Ask) -> BuiltModel {
    let bronze = a.main(Stuff(Finish::Brass, 0xd0a640));
    let chrome = stuff::CHROME.surface();
    small(a, |mesh| {
        mesh.lathe(
            block(-0.5..0.5, 0.93..0.985, -0.5..0.5),
            &[(1.0, 0.0), (1.0, 0.1), (0.26, 0.55), (0.2, 0.9), (0.0, 1.0)],
            24,
            &bronze,
        );
        mesh.rod(at(0.0, 0.1, 0.0), at(0.0, 1.0, 0.0), 0.02, &chrome);
        mesh.rod(at(0.0, 0.1, 0.0), at(0.0, 0.5, 0.0), 0.03, &chrome);
        for k in 0..4 {
            let (sin, cos) = (TAU * (f64::from(k) + 0.5) / 4.0).sin_cos();
            mesh.rod(at(0.0, 0.28, 0.0), at(0.4 * cos, 0.012, 0.4 * sin), 0.014, &chrome);
        }
    })
}

/// A bell with a handle.
pub(super) fn bell(a: &Ask) -> BuiltModel {
    let brass = a.main(Stuff(Finish::Brass, 0xcfa23a));
    let wood = a.second(stuff::WALNUT);
    small(a, |mesh| {
        let shape = [(1.0, 0.0), (1.0, 0.06), (0.8, 0.2), (0.66, 0.5), (0.58, 0.78), (0.36, 0.94), (0.12, 1.0)];
        mesh.lathe(block(-0.5..0.5, 0.04..0.66, -0.5..0.5), &shape, 24, &brass);
        mesh.ball(block(-0.1..0.1, 0.0..0.16, -0.1..0.1), &stuff::BLACK_STEEL.surface());
        let grip = [(0.5, 0.0), (0.6, 0.1), (0.9, 0.5), (1.0, 0.8), (0.7, 1.0)];
        mesh.lathe(block(-0.11..0.11, 0.64..1.0, -0.11..0.11), &grip, 16, &wood);
    })
}

/// Tubes of several lengths that hang in a ring about a clapper; or, over a bed, shapes on crossed rods.
pub(super) fn mobile(a: &Ask) -> BuiltModel {
    let chimes = a.says(&["chime", "wind"]);
    let wood = a.second(stuff::OAK);
    let tube = a.main(Stuff(Finish::Metal, 0x9ba1a6));
    let cord = of(Finish::Fabric, 0x8d8677);
    small(a, |mesh| {
        if chimes {
            mesh.drum(block(-0.3..0.3, 0.8..0.84, -0.3..0.3), &wood);
            for k in 0..3 {
                let (sin, cos) = (TAU * f64::from(k) / 3.0).sin_cos();
                mesh.rod(at(0.22 * cos, 0.83, 0.22 * sin), at(0.0, 1.0, 0.0), 0.008, &cord);
            }
            for k in 0..6 {
                let (sin, cos) = (TAU * f64::from(k) / 6.0).sin_cos();
                let low = 0.2 + 0.07 * f64::from(k);
                mesh.rod(at(0.23 * cos, 0.72, 0.23 * sin), at(0.23 * cos, 0.82, 0.23 * sin), 0.008, &cord);
                mesh.rod(at(0.23 * cos, low, 0.23 * sin), at(0.23 * cos, 0.74, 0.23 * sin), 0.055, &tube);
            }
            mesh.rod(at(0.0, 0.05, 0.0), at(0.0, 0.82, 0.0), 0.008, &cord);
            mesh.drum(block(-0.13..0.13, 0.44..0.48, -0.13..0.13), &wood);
            mesh.rounded(block(-0.09..0.09, 0.0..0.14, -0.015..0.015), 0.01, 1, &wood);
            return;
        }
        mesh.rod(at(0.0, 0.75, 0.0), at(0.0, 1.0, 0.0), 0.008, &cord);
        mesh.rod(at(-0.48, 0.75, 0.0), at(0.48, 0.75, 0.0), 0.014, &wood);
        mesh.rod(at(0.0, 0.75, -0.48), at(0.0, 0.75, 0.48), 0.014, &wood);
        let hung = [(0.44, 0.0, 0.3), (-0.44, 0.0, 0.2), (0.0, 0.44, 0.1), (0.0, -0.44, 0.26), (0.0, 0.0, 0.02)];
        for (k, (x, z, low)) in hung.into_iter().enumerate() {
            let s = of(Finish::Paint, [0xe3a33a, 0x5f93b5, 0xd1685a, 0x7fa860, 0xe6cf63][k]);
            mesh.rod(at(x, low + 0.1, z), at(x, 0.75, z), 0.006, &cord);
            toy(mesh, k, at(x, low + 0.09, z), &s);
        }
    })
}

/// A star, a ball or a cloud.
fn toy(mesh: &mut Mesh, kind: usize, c: scenelang_layout::Vec3, s: &crate::mesh::Surface) {
    match kind % 3 {
        0 => {
            for turn in [0.0, 90.0, 45.0, 135.0] {
                mesh.place(c, [0.0, 0.0, turn], |mesh| {
                    mesh.extrude(2, &[(-0.11, 0.0), (0.0, -0.035), (0.11, 0.0), (0.0, 0.035)], -0.02..0.02, s)
                });
            }
        }
        1 => mesh.ball(block(-0.09..0.09, -0.09..0.09, -0.09..0.09).moved(c.x, c.y, c.z), s),
        _ => {
            for (x, y) in [(-0.07, -0.02), (0.07, -0.02), (0.0, 0.03)] {
                mesh.ball(block(-0.07..0.07, -0.06..0.06, -0.05..0.05).moved(c.x + x, c.y + y, c.z), s);
            }
        }
    }
}

/// A ball on a handle.
pub(super) fn maraca(a: &Ask) -> BuiltModel {
    let red = a.main(Stuff(Finish::Paint, 0xc8392f));
    long(a, |mesh| {
        mesh.ball(block(-0.4..0.4, -0.4..0.4, 0.0..1.0), &red);
        cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, 0.1), [0.1, 0.14], &of(Finish::Wood, 0xb98a55));
        for (z, r) in [(0.3, 0.375), (0.7, 0.375)] {
            cone(mesh, at(0.0, 0.0, z - 0.04), at(0.0, 0.0, z + 0.04), [r, r], &of(Finish::Paint, 0xe8c445));
        }
    })
}

/// A flat box with a slanting side, and strings over a hole.
pub(super) fn zither(a: &Ask) -> BuiltModel {
    let wood = a.main(Stuff(Finish::Wood, 0xa8632f));
    long(a, |mesh| {
        mesh.extrude(1, &[(-1.0, -0.6), (1.0, -0.6), (1.0, -0.1), (-0.6, 0.6), (-1.0, 0.6)], 0.0..0.14, &wood);
        mesh.drum(block(-0.28..0.08, 0.13..0.145, -0.2..0.2), &stuff::DARK_PLASTIC.surface());
        for (z, x) in [(-0.86..-0.8, -0.55..0.55), (0.8..0.86, -0.55..-0.08)] {
            mesh.crisp(block(x, 0.13..0.19, z), &shade(&wood, 0.5));
        }
        for k in 0..9 {
            let t = f64::from(k) / 8.0;
            mesh.rod(at(-0.5 + t, 0.19, -0.84), at(-0.5 + 0.4 * t, 0.19, 0.84), 0.006, &stuff::STEEL.surface());
        }
    })
}

/// Folds between two ends, one with keys, the other with buttons.
pub(super) fn accordion(a: &Ask) -> BuiltModel {
    let red = a.main(Stuff(Finish::Paint, 0xa3262c));
    let (white, dark) = (of(Finish::Plastic, 0xf2efe6), stuff::DARK_PLASTIC.surface());
    small(a, |mesh| {
        for end in block(-0.5..-0.26, 0.0..1.0, -0.4..0.4).both_sides() {
            mesh.rounded(end, 0.05, 2, &red);
        }
        for (k, fold) in block(-0.28..0.28, 0.04..0.96, -0.36..0.36).split(0, 11, 0.0).enumerate() {
            let by = if k % 2 == 0 { 0.0 } else { 0.05 };
            mesh.crisp(fold.inset(0.0, by, by), if k % 2 == 0 { &dark } else { &white });
        }
        for (k, key) in block(0.3..0.5, 0.06..0.94, 0.38..0.46).split(1, 12, 0.012).enumerate() {
            mesh.crisp(key, &white);
            if ![2, 6, 9].contains(&(k % 12)) {
                let c = key.max.y;
                mesh.crisp(block(0.29..0.4, c - 0.02..c + 0.02, 0.44..0.5), &dark);
            }
        }
        for row in block(-0.46..-0.3, 0.1..0.9, 0.38..0.43).split(0, 3, 0.01) {
            for button in row.split(1, 8, 0.04) {
                mesh.crisp(button, &white);
            }
        }
    })
}
