//! Things of bathrooms, tables and gardens: paper on its roll, brushes in their holders, bidets, potties, cakes and pizzas,
//! stoves for wood, chaises, stands for umbrellas and plants, mixers for concrete.

use super::strokes::{at, blade, cone, headed, of, small};
use crate::ask::Ask;
use crate::block::block;
use crate::loft::oval;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::Mesh;
use crate::model::BuiltModel;
use std::f64::consts::TAU;

/// A roll of paper with its hole; on a bracket for a wall where it is a holder.
pub(super) fn toilet_paper(a: &Ask) -> BuiltModel {
    let paper = a.main(stuff::SHEET);
    let tube = of(Finish::Paper, 0xa8845c);
    if a.says(&["holder"]) {
        let steel = a.main(stuff::CHROME);
        return small(a, |mesh| {
            mesh.rounded(block(-0.9..-0.5, 0.5..0.9, -0.7..-0.6), 0.04, 1, &steel);
            mesh.tube(&[at(-0.7, 0.7, -0.65), at(-0.7, 0.7, 0.0), at(0.75, 0.7, 0.0)], 0.06, &steel);
            mesh.disc(0, block(-0.5..0.6, 0.1..1.2, -0.55..0.55), &stuff::SHEET.surface());
            mesh.disc(0, block(-0.51..0.61, 0.48..0.84, -0.18..0.18), &tube);
            mesh.crisp(block(-0.48..0.58, -0.4..0.65, 0.52..0.55), &stuff::SHEET.surface());
        });
    }
    small(a, |mesh| {
        let roll =
            [(0.4, 0.0), (0.98, 0.0), (1.0, 0.03), (1.0, 0.97), (0.98, 1.0), (0.4, 1.0), (0.36, 0.96), (0.36, 0.1)];
        mesh.lathe(block(-1.0..1.0, 0.0..2.0, -1.0..1.0), &roll, 24, &paper);
        mesh.lathe(
            block(-0.38..0.38, 0.3..2.02, -0.38..0.38),
            &[(1.0, 0.0), (1.0, 1.0), (0.9, 1.0), (0.88, 0.1)],
            20,
            &tube,
        );
        mesh.crisp(block(0.97..1.0, 0.0..2.0, 0.0..1.05), &paper);
    })
}

/// A handle in a pot, the bristles just seen.
pub(super) fn toilet_brush(a: &Ask) -> BuiltModel {
    let pot = a.main(stuff::CERAMIC);
    let steel = stuff::CHROME.surface();
    small(a, |mesh| {
        mesh.lathe(
            block(-0.5..0.5, 0.0..1.5, -0.5..0.5),
            &[(0.9, 0.0), (1.0, 0.1), (0.9, 1.0), (0.8, 1.0), (0.8, 0.7)],
            24,
            &pot,
        );
        mesh.lathe(
            block(-0.36..0.36, 1.0..1.66, -0.36..0.36),
            &[(0.8, 0.0), (1.0, 0.4), (0.7, 1.0)],
            12,
            &of(Finish::Carpet, 0xf1f0ec),
        );
        mesh.rod(at(0.0, 1.5, 0.0), at(0.0, 3.6, 0.0), 0.07, &steel);
        mesh.lathe(
            block(-0.13..0.13, 3.3..4.2, -0.13..0.13),
            &[(0.6, 0.0), (1.0, 0.3), (1.0, 0.85), (0.0, 1.0)],
            16,
            &steel,
        );
        mesh.drum(block(-0.3..0.3, 1.62..1.7, -0.3..0.3), &steel);
    })
}

/// A low bowl with a tap; one in the floor with places for the feet; a small pot with a back for children.
pub(super) fn bidet(a: &Ask) -> BuiltModel {
    let white = a.main(if a.says(&["potty"]) { Stuff(Finish::Plastic, 0x6fa8d0) } else { stuff::CERAMIC });
    let inside = shade(&white, 0.8);
    let steel = stuff::CHROME.surface();
    headed(a, |mesh| {
        if a.says(&["squat"]) {
            mesh.rounded(block(-0.7..0.7, 0.0..0.16, -1.0..1.0), 0.06, 2, &white);
            blade(mesh, at(0.0, 0.16, 0.0), [0.56, 1.6], 0.02, &inside);
            blade(mesh, at(0.0, 0.165, -0.4), [0.24, 0.3], 0.03, &stuff::DARK_PLASTIC.surface());
            mesh.lathe(block(-0.3..0.3, 0.12..0.46, 0.5..0.95), &[(1.0, 0.0), (0.9, 0.6), (0.0, 1.0)], 20, &white);
            for side in block(-0.62..-0.34, 0.15..0.2, -0.4..0.3).both_sides() {
                mesh.rounded(side, 0.02, 1, &white);
                for ridge in side.share(0.1..0.9, 1.0..1.4, 0.05..0.95).split(2, 6, 0.05) {
                    mesh.crisp(ridge, &inside);
                }
            }
            mesh.rounded(block(-0.25..0.25, 0.1..0.9, -1.0..-0.9), 0.03, 1, &white);
            mesh.tube(&[at(0.0, 0.7, -0.92), at(0.0, 0.7, -0.84), at(0.0, 0.2, -0.8)], 0.04, &steel);
            return;
        }
        let potty = a.says(&["potty"]);
        let bowl = [
            oval(0.0, [0.0, -0.1], [0.36, 0.5], 1.0),
            oval(0.4, [0.0, -0.04], [0.34, 0.56], 1.0),
            oval(1.0, [0.0, 0.0], [0.52, 0.86], 1.0),
            oval(1.08, [0.0, 0.0], [0.5, 0.84], 1.0),
        ];
        mesh.loft(&bowl, &white);
        mesh.loft(&[oval(1.06, [0.0, 0.06], [0.36, 0.62], 1.0), oval(1.1, [0.0, 0.06], [0.37, 0.63], 1.0)], &inside);
        blade(mesh, at(0.0, 1.1, 0.0), [0.16, 0.16], 0.03, &steel);
        if potty {
            mesh.loft(
                &[
                    oval(1.0, [0.0, -0.72], [0.44, 0.14], 1.0),
                    oval(1.7, [0.0, -0.86], [0.36, 0.1], 1.0),
                    oval(1.85, [0.0, -0.9], [0.2, 0.06], 1.0),
                ],
                &white,
            );
            mesh.rounded(block(-0.1..0.1, 1.0..1.4, 0.6..0.78), 0.06, 2, &white);
        } else {
            mesh.tube(
                &[at(0.0, 1.05, -0.68), at(0.0, 1.4, -0.66), at(0.0, 1.4, -0.4), at(0.0, 1.3, -0.34)],
                0.05,
                &steel,
            );
            for x in [-0.2, 0.2] {
                mesh.drum(block(x - 0.06..x + 0.06, 1.05..1.25, -0.74..-0.62), &steel);
            }
        }
    })
}

/// A layered cake with cream and cherries; on a foot with a rim; a pizza; a plate of food.
pub(super) fn cake(a: &Ask) -> BuiltModel {
    if a.says(&["pizza"]) {
        let crust = a.main(Stuff(Finish::Soil, 0xc98f4c));
        return small(a, |mesh| {
            mesh.drum(block(-1.0..1.0, 0.0..0.1, -1.0..1.0), &crust);
            mesh.torus(block(-1.0..1.0, 0.02..0.22, -1.0..1.0), 0.16, &crust);
            mesh.drum(block(-0.88..0.88, 0.08..0.14, -0.88..0.88), &of(Finish::Soil, 0xe8b84a));
            spread(mesh, 9, 0.7, 0.14, 0.13, &of(Finish::Leather, 0xa8302a));
            spread(mesh, 5, 0.45, 0.15, 0.06, &of(Finish::Leaf, 0x3f7a3a));
            for k in 0..4 {
                mesh.place(at(0.0, 0.145, 0.0), [0.0, 45.0 * f64::from(k), 0.0], |mesh| {
                    mesh.crisp(block(-0.9..0.9, -0.01..0.012, -0.012..0.012), &shade(&crust, 0.6))
                });
            }
        });
    }
    if a.says(&["food"]) {
        let plate = a.main(stuff::CERAMIC);
        return small(a, |mesh| {
            mesh.lathe(
                block(-1.0..1.0, 0.0..0.14, -1.0..1.0),
                &[(0.6, 0.0), (0.7, 0.3), (1.0, 1.0), (0.95, 1.0), (0.66, 0.4)],
                24,
                &plate,
            );
            mesh.ball(block(-0.6..0.05, 0.04..0.36, -0.5..0.1), &of(Finish::Soil, 0x8a4a24));
            mesh.ball(block(0.0..0.6, 0.04..0.34, -0.5..0.05), &of(Finish::Soil, 0xf0e0b0));
            for k in 0..7 {
                let x = -0.4 + 0.12 * f64::from(k);
                super::strokes::pearl(
                    mesh,
                    block(x..x + 0.13, 0.06..0.2, 0.2 + 0.05 * f64::from(k % 3)..0.33 + 0.05 * f64::from(k % 3)),
                    &of(Finish::Leaf, 0x5f9a3a),
                );
            }
        });
    }
    let on_foot = a.says(&["stand"]);
    let cream = a.main(if on_foot { stuff::CERAMIC } else { Stuff(Finish::Ceramic, 0xf6e4d8) });
    small(a, |mesh| {
        let low = if on_foot { 0.8 } else { 0.06 };
        if on_foot {
            mesh.lathe(
                block(-0.5..0.5, 0.0..0.72, -0.5..0.5),
                &[(1.0, 0.0), (0.9, 0.1), (0.24, 0.3), (0.24, 0.8), (0.5, 1.0)],
                24,
                &cream,
            );
            mesh.lathe(
                block(-1.2..1.2, 0.7..0.82, -1.2..1.2),
                &[(0.9, 0.0), (1.0, 0.4), (1.0, 1.0), (0.94, 0.8)],
                24,
                &cream,
            );
        } else {
            mesh.drum(block(-1.0..1.0, 0.0..0.06, -1.0..1.0), &stuff::CERAMIC.surface());
        }
        let sponge = of(Finish::Soil, 0xc98f5a);
        for k in 0..3 {
            let y = low + 0.3 * f64::from(k);
            mesh.drum(block(-0.8..0.8, y..y + 0.24, -0.8..0.8), &sponge);
            mesh.drum(block(-0.82..0.82, y + 0.23..y + 0.31, -0.82..0.82), &of(Finish::Ceramic, 0xf6e4d8));
        }
        let top = low + 0.9;
        for k in 0..8 {
            let (sin, cos) = (TAU * f64::from(k) / 8.0).sin_cos();
            let (x, z) = (0.62 * cos, 0.62 * sin);
            mesh.lathe(
                block(x - 0.14..x + 0.14, top..top + 0.16, z - 0.14..z + 0.14),
                &[(1.0, 0.0), (0.7, 0.6), (0.0, 1.0)],
                8,
                &of(Finish::Ceramic, 0xfff6ee),
            );
            super::strokes::pearl(
                mesh,
                block(x - 0.08..x + 0.08, top + 0.12..top + 0.28, z - 0.08..z + 0.08),
                &of(Finish::Ceramic, 0xc2262e),
            );
        }
    })
}

/// Round pieces on a disc.
fn spread(mesh: &mut Mesh, count: u32, out: f64, y: f64, r: f64, s: &crate::mesh::Surface) {
    for k in 0..count {
        let (sin, cos) = (2.4 * f64::from(k)).sin_cos();
        let far = out * ((f64::from(k) + 0.5) / f64::from(count)).sqrt();
        mesh.lathe(
            block(far * cos - r..far * cos + r, y..y + 0.04, far * sin - r..far * sin + r),
            &[(1.0, 0.0), (1.0, 1.0)],
            12,
            s,
        );
    }
}

/// An iron box on legs with a fire behind glass, and its pipe.
pub(super) fn wood_stove(a: &Ask) -> BuiltModel {
    let iron = a.main(stuff::BLACK_STEEL);
    small(a, |mesh| {
        for leg in block(-0.7..-0.56, 0.0..0.32, 0.36..0.5).four_corners() {
            mesh.taper(leg, leg.inset(0.02, 0.0, 0.02), &iron);
        }
        mesh.rounded(block(-0.75..0.75, 0.3..1.5, -0.55..0.55), 0.05, 1, &iron);
        mesh.rounded(block(-0.82..0.82, 1.48..1.58, -0.6..0.6), 0.03, 1, &shade(&iron, 1.3));
        mesh.rounded(block(-0.58..0.58, 0.5..1.34, 0.53..0.6), 0.04, 1, &shade(&iron, 1.5));
        mesh.crisp(block(-0.46..0.46, 0.62..1.22, 0.59..0.62), &of(Finish::Glow, 0x5a2410));
        for (x, high, color) in [(-0.24, 0.3, 0xf08a2a), (0.0, 0.5, 0xffb83a), (0.24, 0.36, 0xf08a2a)] {
            mesh.extrude(
                2,
                &[(x - 0.15, 0.68), (x + 0.15, 0.68), (x + 0.04, 0.68 + high), (x - 0.05, 0.68 + 0.9 * high)],
                0.61..0.64,
                &of(Finish::Glow, color),
            );
        }
        for y in [0.66, 0.72] {
            cone(mesh, at(-0.4, y, 0.62), at(0.4, 1.38 - y, 0.62), [0.035, 0.035], &of(Finish::Wood, 0x5a3a24));
        }
        mesh.rod(at(0.5, 0.8, 0.64), at(0.5, 1.05, 0.64), 0.03, &stuff::BRASS.surface());
        mesh.drum(block(-0.2..0.2, 1.56..2.7, -0.36..0.04), &iron);
        mesh.drum(block(-0.23..0.23, 1.56..1.66, -0.39..0.07), &shade(&iron, 1.3));
    })
}

/// A long seat whose back rises at one end.
pub(super) fn chaise(a: &Ask) -> BuiltModel {
    let cloth = a.main(Stuff(Finish::Velvet, 0x5f7a6f));
    let wood = a.legs(&cloth);
    let mut m = BuiltModel::default();
    let b = a.whole();
    m.legs(b.share(0.06..0.94, 0.0..0.2, 0.04..0.96), 0.05, &wood);
    m.cushion(b.share(0.0..1.0, 0.18..0.36, 0.0..1.0), &shade(&cloth, 0.85));
    m.cushion(b.share(0.04..0.96, 0.35..0.52, 0.2..0.99), &cloth);
    m.cushion(b.share(0.0..1.0, 0.34..1.0, 0.0..0.2), &cloth);
    m.cushion(b.share(0.0..0.14, 0.34..0.74, 0.18..0.56), &shade(&cloth, 0.92));
    m.cushion(b.share(0.2..0.8, 0.54..0.82, 0.19..0.28), &a.second(stuff::LINEN));
    m
}

/// A pot with umbrellas.
pub(super) fn umbrella_stand(a: &Ask) -> BuiltModel {
    let pot = a.main(stuff::BLACK_STEEL);
    small(a, |mesh| {
        mesh.lathe(
            block(-0.5..0.5, 0.0..1.3, -0.5..0.5),
            &[(0.9, 0.0), (0.86, 0.5), (1.0, 1.0), (0.92, 1.0), (0.78, 0.4)],
            24,
            &pot,
        );
        for y in [0.2, 1.05] {
            mesh.torus(block(-0.5..0.5, y..y + 0.08, -0.5..0.5), 0.12, &stuff::BRASS.surface());
        }
        for (k, color) in [0x2f4f8f, 0xb8322c, 0x3a3a3e].into_iter().enumerate() {
            let (sin, cos) = (TAU * k as f64 / 3.0 + 0.4).sin_cos();
            let (foot, top) = (at(-0.15 * cos, 0.3, -0.15 * sin), at(0.26 * cos, 1.9, 0.26 * sin));
            cone(mesh, foot, top, [0.05, 0.13], &of(Finish::Fabric, color));
            let way = (top - foot).normalize();
            let side = at(cos, 0.0, sin);
            mesh.tube(
                &[
                    top,
                    top + way * 0.42,
                    top + way * 0.55 + side * 0.08,
                    top + way * 0.5 + side * 0.2,
                    top + way * 0.4 + side * 0.22,
                ],
                0.035,
                &of(Finish::Wood, 0x6b4227),
            );
        }
    })
}

/// Three legs and a ring that hold a pot with a plant.
pub(super) fn plant_stand(a: &Ask) -> BuiltModel {
    let iron = a.main(stuff::BLACK_STEEL);
    let leaf = stuff::LEAF.surface();
    small(a, |mesh| {
        for k in 0..4 {
            let (sin, cos) = (TAU * (f64::from(k) + 0.5) / 4.0).sin_cos();
            mesh.rod(at(0.52 * cos, 0.0, 0.52 * sin), at(0.46 * cos, 1.35, 0.46 * sin), 0.03, &iron);
        }
        for y in [0.4, 1.0] {
            mesh.torus(block(-0.5..0.5, y..y + 0.05, -0.5..0.5), 0.1, &iron);
        }
        mesh.drum(block(-0.46..0.46, 0.98..1.02, -0.46..0.46), &iron);
        mesh.lathe(
            block(-0.4..0.4, 1.02..1.6, -0.4..0.4),
            &[(0.7, 0.0), (1.0, 0.9), (1.0, 1.0), (0.9, 1.0), (0.85, 0.85)],
            24,
            &of(Finish::Ceramic, 0xe9e4da),
        );
        for k in 0..9 {
            let (sin, cos) = (2.4 * f64::from(k)).sin_cos();
            let far = 0.25 + 0.06 * f64::from(k % 4);
            let path = [
                (at(0.0, 1.5, 0.0), 0.03, 0.02),
                (at(0.5 * far * cos, 2.0, 0.5 * far * sin), 0.1, 0.02),
                (at(1.6 * far * cos, 2.25 - 0.04 * f64::from(k), 1.6 * far * sin), 0.01, 0.01),
            ];
            mesh.sweep(&path, at(0.0, 1.0, 0.0), 8, &leaf);
        }
    })
}

/// A can with a long spout and a rose, and a handle.
pub(super) fn watering_can(a: &Ask) -> BuiltModel {
    let zinc = a.main(Stuff(Finish::Metal, 0x5f8a6a));
    small(a, |mesh| {
        mesh.lathe(
            block(-0.5..0.5, 0.0..1.0, -0.4..0.4),
            &[(1.0, 0.0), (0.9, 1.0), (0.8, 1.0), (0.78, 0.9)],
            24,
            &zinc,
        );
        cone(mesh, at(0.4, 0.2, 0.0), at(1.1, 1.1, 0.0), [0.12, 0.06], &zinc);
        cone(mesh, at(1.06, 1.04, 0.0), at(1.24, 1.24, 0.0), [0.06, 0.2], &zinc);
        cone(mesh, at(1.235, 1.235, 0.0), at(1.26, 1.26, 0.0), [0.19, 0.19], &shade(&zinc, 0.5));
        mesh.tube(
            &[
                at(0.3, 1.0, 0.0),
                at(0.1, 1.4, 0.0),
                at(-0.4, 1.35, 0.0),
                at(-0.75, 0.9, 0.0),
                at(-0.6, 0.5, 0.0),
                at(-0.45, 0.4, 0.0),
            ],
            0.05,
            &zinc,
        );
        mesh.rod(at(0.45, 0.8, 0.0), at(0.8, 0.75, 0.0), 0.03, &zinc);
    })
}

/// A drum that leans in a frame on two wheels, its mouth to the front.
pub(super) fn concrete_mixer(a: &Ask) -> BuiltModel {
    let paint = a.main(Stuff(Finish::Paint, 0xe07a24));
    let steel = stuff::BLACK_STEEL.surface();
    headed(a, |mesh| {
        for x in [-0.5, 0.5] {
            mesh.disc(0, block(x - 0.06..x + 0.06, 0.0..0.5, -0.75..-0.25), &stuff::RUBBER.surface());
            mesh.tube(&[at(0.8 * x, 0.25, -0.5), at(0.8 * x, 1.0, -0.1), at(0.8 * x, 0.0, 0.7)], 0.045, &steel);
        }
        mesh.rod(at(-0.5, 0.25, -0.5), at(0.5, 0.25, -0.5), 0.04, &steel);
        mesh.rod(at(-0.4, 0.05, 0.68), at(0.4, 0.05, 0.68), 0.04, &steel);
        mesh.place(at(0.0, 1.1, 0.0), [40.0, 0.0, 0.0], |mesh| {
            let drum = [(0.5, 0.0), (0.9, 0.12), (1.0, 0.42), (0.96, 0.52), (0.56, 1.0), (0.5, 1.0), (0.8, 0.5)];
            mesh.lathe(block(-0.55..0.55, -0.55..0.75, -0.55..0.55), &drum, 24, &paint);
            mesh.torus(block(-0.58..0.58, -0.08..0.06, -0.58..0.58), 0.1, &steel);
        });
        mesh.rounded(block(0.42..0.62, 0.7..1.1, -0.3..0.15), 0.04, 1, &paint);
        mesh.place(at(-0.58, 1.1, 0.0), [0.0, 0.0, 90.0], |mesh| {
            mesh.torus(block(-0.3..0.3, -0.03..0.03, -0.3..0.3), 0.14, &steel)
        });
    })
}

/// A box of hedge: leaves over leaves, in a long pot.
pub(super) fn hedge(a: &Ask) -> BuiltModel {
    let leaf = a.main(stuff::LEAF);
    let mut dice = a.dice();
    let mut m = BuiltModel::default();
    let b = a.whole();
    m.solid(b);
    m.mesh.board(b.share(0.0..1.0, 0.0..0.16, 0.0..1.0), &stuff::BLACK_STEEL.surface());
    m.mesh.crisp(b.share(0.03..0.97, 0.14..0.95, 0.1..0.9), &shade(&leaf, 0.7));
    m.mesh.stretch(b.share(0.0..1.0, 0.16..1.0, 0.0..1.0), |mesh| {
        for k in 0..40 {
            let (x, y) = (0.2 * f64::from(k % 8) + dice.between(-0.04, 0.04), 0.2 * f64::from(k / 8));
            let r = dice.between(0.12, 0.17);
            super::strokes::pearl(
                mesh,
                block(x - r..x + r, y - r..y + r, -0.3..0.3),
                &shade(&leaf, dice.between(0.8, 1.2) as f32),
            );
        }
    });
    m
}

/// A box with a rounded lid and twin lamps, for when the power fails; letters of light on a dark plate.
pub(super) fn lit_letters(a: &Ask) -> BuiltModel {
    if a.says(&["emergency"]) {
        let case = a.main(stuff::WHITE);
        return small(a, |mesh| {
            mesh.rounded(block(-1.0..1.0, 0.0..0.9, 0.0..0.5), 0.12, 2, &case);
            for x in [-0.6, 0.6] {
                cone(mesh, at(x, 0.95, 0.25), at(x, 1.1, 0.25), [0.1, 0.1], &stuff::DARK_PLASTIC.surface());
                cone(mesh, at(x, 1.3, 0.05), at(x, 1.3, 0.55), [0.2, 0.34], &case);
                cone(mesh, at(x, 1.3, 0.54), at(x, 1.3, 0.58), [0.29, 0.28], &of(Finish::Glow, 0xfff2cf));
            }
            mesh.disc(2, block(-0.06..0.06, 0.2..0.32, 0.48..0.53), &stuff::GREEN_LIGHT.surface());
            mesh.rounded(block(0.2..0.5, 0.2..0.34, 0.48..0.53), 0.02, 1, &stuff::RED.surface());
        });
    }
    let plate = a.main(stuff::DARK_PLASTIC);
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.0..1.0, 0.0..0.05), 0.02, 1, &plate);
        let pink = of(Finish::Glow, 0xff4f9a);
        let blue = of(Finish::Glow, 0x4fd0ff);
        let glow = |mesh: &mut Mesh, points: &[(f64, f64)], s| {
            mesh.tube(&points.iter().map(|(x, y)| at(-x, *y, 0.1)).collect::<Vec<_>>(), 0.03, s)
        };
        glow(mesh, &[(-0.94, 0.08), (-0.94, 0.92), (0.94, 0.92), (0.94, 0.08), (-0.94, 0.07)], &blue);
        // "OPEN"
        glow(
            mesh,
            &[(-0.5, 0.3), (-0.68, 0.3), (-0.76, 0.5), (-0.68, 0.7), (-0.54, 0.7), (-0.46, 0.5), (-0.5, 0.32)],
            &pink,
        );
        glow(mesh, &[(-0.32, 0.28), (-0.32, 0.7), (-0.12, 0.68), (-0.1, 0.52), (-0.3, 0.48)], &pink);
        for y in [0.3, 0.5, 0.7] {
            glow(mesh, &[(0.08, y), (0.3, y)], &pink);
        }
        glow(mesh, &[(0.08, 0.3), (0.08, 0.7)], &pink);
        glow(mesh, &[(0.46, 0.28), (0.46, 0.7), (0.72, 0.3), (0.72, 0.72)], &pink);
    })
}
