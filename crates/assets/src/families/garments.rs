//! Clothes on a hanger, bags, dolls, dress forms, punching bags, flags, hooks, flip charts.

use super::strokes::{at, of, small};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use scenelang_layout::Vec3;

/// A coat or a jacket on a hanger.
pub(super) fn garment(a: &Ask) -> BuiltModel {
    let white = a.says(&["lab"]);
    let cloth = a.main(if white {
        stuff::SHEET
    } else {
        Stuff(Finish::Fabric, if a.says(&["jacket"]) { 0x3f5f7f } else { 0x7a4f35 })
    });
    let dark = shade(&cloth, 0.7);
    let low = if a.says(&["jacket"]) { 0.55 } else { 0.0 };
    small(a, |mesh| {
        let hook = [at(0.0, 2.05, 0.0), at(0.0, 2.2, 0.0), at(0.08, 2.28, 0.0), at(0.12, 2.2, 0.0)];
        mesh.tube(&hook, 0.016, &stuff::STEEL.surface());
        let up = at(0.0, 0.0, 1.0);
        for side in [-1.0, 1.0] {
            // Half of the front and the back, then a sleeve.
            let half = [
                (side * 0.015, 2.0),
                (side * 0.18, 2.02),
                (side * 0.42, 1.86),
                (side * 0.34, 1.3),
                (side * 0.42, low),
                (side * 0.015, low),
            ];
            mesh.extrude(2, &half, -0.11..0.1, &cloth);
            let sleeve = [
                (at(side * 0.4, 1.84, 0.0), 0.1, 0.11),
                (at(side * 0.52, 1.4, 0.02), 0.1, 0.1),
                (at(side * 0.54, 0.85, 0.05), 0.08, 0.09),
            ];
            mesh.sweep(&sleeve, up, 12, &cloth);
            mesh.sweep(
                &[(at(side * 0.54, 0.93, 0.045), 0.088, 0.098), (at(side * 0.54, 0.85, 0.05), 0.09, 0.1)],
                up,
                12,
                &dark,
            );
            mesh.extrude(
                2,
                &[(side * 0.02, 1.45), (side * 0.03, 2.0), (side * 0.19, 2.06), (side * 0.2, 1.8)],
                0.1..0.13,
                &shade(&cloth, 0.88),
            );
            mesh.crisp(block(side * 0.24 - 0.1..side * 0.24 + 0.1, low + 0.36..low + 0.42, 0.1..0.12), &dark);
        }
        for k in 0..4 {
            let y = low + 0.2 + 0.3 * f64::from(k);
            if y < 1.45 {
                mesh.bead(block(0.03..0.08, y..y + 0.05, 0.09..0.13), &stuff::DARK_PLASTIC.surface());
            }
        }
    })
}

/// Bags: with handles and a zip, of clubs, of laundry with a cord, small ones for make-up.
pub(super) fn bag(a: &Ask) -> BuiltModel {
    if a.says(&["golf"]) {
        return golf_bag(a);
    }
    if a.says(&["laundry"]) {
        let cloth = a.main(stuff::LINEN);
        return small(a, |mesh| {
            let sack =
                [(0.7, 0.0), (0.95, 0.1), (1.0, 0.45), (0.8, 0.75), (0.4, 0.86), (0.7, 1.0), (0.6, 1.0), (0.3, 0.88)];
            mesh.lathe(block(-1.0..1.0, 0.0..2.6, -1.0..1.0), &sack, 24, &cloth);
            mesh.torus(block(-0.44..0.44, 2.18..2.28, -0.44..0.44), 0.25, &of(Finish::Fabric, 0x8a5a34));
            for side in [-1.0, 1.0] {
                mesh.tube(
                    &[at(side * 0.1, 2.22, 0.4), at(side * 0.2, 1.9, 0.75), at(side * 0.3, 1.5, 0.98)],
                    0.03,
                    &of(Finish::Fabric, 0x8a5a34),
                );
            }
        });
    }
    let little = a.says(&["makeup", "make", "cosmetic"]);
    let cloth = a.main(Stuff(Finish::Fabric, if little { 0xc2708f } else { 0x2f4f6f }));
    let trim = shade(&cloth, 0.6);
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.0..0.95, -0.5..0.5), 0.3, 4, &cloth);
        mesh.crisp(block(-0.9..0.9, 0.93..0.97, -0.04..0.04), &stuff::BRASS.surface());
        mesh.rounded(block(0.8..0.92, 0.95..1.0, -0.08..0.08), 0.02, 1, &stuff::BRASS.surface());
        if little {
            return;
        }
        for side in block(-0.66..-0.5, -0.002..0.9, -0.515..0.515).both_sides() {
            mesh.rounded(side, 0.06, 2, &trim);
        }
        for z in [-0.4, 0.4] {
            mesh.tube(
                &[at(-0.58, 0.8, z * 1.2), at(-0.4, 1.25, z * 0.8), at(0.4, 1.25, z * 0.8), at(0.58, 0.8, z * 1.2)],
                0.05,
                &trim,
            );
        }
        mesh.rounded(block(-0.4..0.4, 0.15..0.6, 0.44..0.56), 0.04, 1, &trim);
    })
}

/// A tube with a pocket and a strap; clubs look out of it.
fn golf_bag(a: &Ask) -> BuiltModel {
    let cloth = a.main(Stuff(Finish::Fabric, 0x2f5f4a));
    let (trim, steel) = (shade(&cloth, 0.6), stuff::CHROME.surface());
    small(a, |mesh| {
        mesh.drum(block(-0.5..0.5, 0.0..2.5, -0.5..0.5), &cloth);
        for y in [0.0, 1.2, 2.42] {
            mesh.drum(block(-0.53..0.53, y..y + 0.14, -0.53..0.53), &trim);
        }
        mesh.rounded(block(-0.36..0.36, 0.25..1.1, 0.3..0.72), 0.1, 2, &trim);
        mesh.tube(&[at(0.45, 2.2, 0.1), at(0.8, 1.8, 0.2), at(0.75, 1.0, 0.2), at(0.48, 0.6, 0.1)], 0.06, &trim);
        for (k, (x, z)) in
            [(-0.25, -0.2), (0.2, -0.25), (0.0, 0.1), (-0.25, 0.25), (0.28, 0.15)].into_iter().enumerate()
        {
            let top = 3.0 + 0.16 * (k as f64);
            mesh.rod(at(x, 2.3, z), at(1.2 * x, top, 1.2 * z), 0.03, &steel);
            if k % 2 == 0 {
                mesh.ball(
                    block(1.2 * x - 0.1..1.2 * x + 0.3, top - 0.08..top + 0.16, 1.2 * z - 0.14..1.2 * z + 0.14),
                    &stuff::DARK_PLASTIC.surface(),
                );
            } else {
                mesh.rounded(
                    block(1.2 * x - 0.04..1.2 * x + 0.3, top - 0.05..top + 0.16, 1.2 * z - 0.04..1.2 * z + 0.06),
                    0.03,
                    1,
                    &steel,
                );
            }
        }
    })
}

/// A doll in a dress, with hair and a face.
pub(super) fn doll(a: &Ask) -> BuiltModel {
    let dress = a.main(Stuff(Finish::Fabric, 0xd0567f));
    let (skin, hair) = (of(Finish::Plastic, 0xe8b898), of(Finish::Fabric, 0x8a5a2a));
    small(a, |mesh| {
        for side in [-1.0, 1.0] {
            mesh.rod(at(side * 0.16, 0.1, 0.0), at(side * 0.14, 0.8, 0.0), 0.1, &skin);
            mesh.rounded(
                block(side * 0.16 - 0.12..side * 0.16 + 0.12, 0.0..0.16, -0.14..0.24),
                0.06,
                2,
                &stuff::DARK_PLASTIC.surface(),
            );
            mesh.rod(at(side * 0.22, 1.6, 0.0), at(side * 0.58, 1.15, 0.06), 0.08, &skin);
            mesh.bead(block(side * 0.6 - 0.1..side * 0.6 + 0.1, 1.03..1.2, -0.03..0.15), &skin);
            mesh.bead(block(side * 0.3 - 0.16..side * 0.3 + 0.16, 1.42..1.72, -0.15..0.15), &dress);
            mesh.bead(
                block(side * 0.14 - 0.045..side * 0.14 + 0.045, 2.05..2.15, 0.36..0.44),
                &stuff::DARK_PLASTIC.surface(),
            );
            mesh.bead(block(side * 0.44 - 0.14..side * 0.44 + 0.14, 1.75..2.2, -0.2..0.08), &hair);
        }
        mesh.lathe(
            block(-0.56..0.56, 0.5..1.74, -0.5..0.5),
            &[(1.0, 0.0), (0.75, 0.35), (0.42, 0.6), (0.48, 0.85), (0.2, 1.0)],
            24,
            &dress,
        );
        mesh.ball(block(-0.42..0.42, 1.66..2.46, -0.4..0.42), &skin);
        mesh.lathe(
            block(-0.46..0.46, 2.02..2.52, -0.46..0.36),
            &[(0.9, 0.0), (1.0, 0.2), (0.8, 0.7), (0.0, 1.0)],
            20,
            &hair,
        );
        mesh.tube(&[at(-0.09, 1.9, 0.39), at(0.0, 1.87, 0.41), at(0.09, 1.9, 0.39)], 0.02, &stuff::RED.surface());
    })
}

/// A torso of linen on a turned stand.
pub(super) fn dress_form(a: &Ask) -> BuiltModel {
    let linen = a.main(stuff::LINEN);
    let wood = a.second(stuff::WALNUT);
    small(a, |mesh| {
        let torso = [
            (0.62, 0.0),
            (0.86, 0.08),
            (0.92, 0.2),
            (0.62, 0.46),
            (0.9, 0.72),
            (1.0, 0.84),
            (0.55, 0.95),
            (0.26, 0.97),
            (0.24, 1.0),
        ];
        mesh.lathe(block(-0.42..0.42, 1.6..3.1, -0.28..0.28), &torso, 24, &linen);
        mesh.lathe(
            block(-0.1..0.1, 3.08..3.26, -0.1..0.1),
            &[(1.0, 0.0), (0.9, 0.3), (0.4, 0.6), (0.5, 0.8), (0.0, 1.0)],
            16,
            &wood,
        );
        for side in [-1.0, 1.0] {
            mesh.place(at(side * 0.36, 2.86, 0.0), [0.0, 0.0, side * 60.0], |mesh| {
                mesh.drum(block(-0.13..0.13, -0.03..0.03, -0.13..0.13), &wood)
            });
        }
        mesh.crisp(block(-0.012..0.012, 1.7..3.0, 0.2..0.285), &shade(&linen, 0.7));
        mesh.lathe(
            block(-0.07..0.07, 0.5..1.62, -0.07..0.07),
            &[(1.0, 0.0), (0.6, 0.2), (1.0, 0.4), (0.6, 0.7), (1.0, 1.0)],
            16,
            &wood,
        );
        for k in 0..3 {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / 3.0).sin_cos();
            mesh.tube(
                &[at(0.0, 0.6, 0.0), at(0.24 * sin, 0.4, 0.24 * cos), at(0.42 * sin, 0.05, 0.42 * cos)],
                0.05,
                &wood,
            );
        }
    })
}

/// A heavy roll of leather on chains.
pub(super) fn punching_bag(a: &Ask) -> BuiltModel {
    let leather = a.main(Stuff(Finish::Leather, 0x8a2a24));
    let steel = stuff::STEEL.surface();
    small(a, |mesh| {
        mesh.lathe(
            block(-0.5..0.5, 0.0..2.6, -0.5..0.5),
            &[(0.8, 0.0), (1.0, 0.05), (1.0, 0.95), (0.85, 1.0)],
            24,
            &leather,
        );
        for y in [0.5, 1.9] {
            mesh.drum(block(-0.515..0.515, y..y + 0.22, -0.515..0.515), &stuff::DARK_PLASTIC.surface());
        }
        for k in 0..4 {
            let (sin, cos) = (std::f64::consts::TAU * (f64::from(k) + 0.5) / 4.0).sin_cos();
            chain(mesh, at(0.4 * cos, 2.58, 0.4 * sin), at(0.0, 3.3, 0.0), &steel);
        }
        chain(mesh, at(0.0, 3.25, 0.0), at(0.0, 3.6, 0.0), &steel);
        mesh.drum(block(-0.18..0.18, 3.58..3.66, -0.18..0.18), &steel);
    })
}

/// Links from one point to another, as beads on a rod.
fn chain(mesh: &mut Mesh, from: Vec3, to: Vec3, s: &Surface) {
    mesh.rod(from, to, 0.016, s);
    for k in 1..5 {
        let p = from + (to - from) * (f64::from(k) / 5.0);
        super::strokes::pearl(mesh, block(p.x - 0.04..p.x + 0.04, p.y - 0.05..p.y + 0.05, p.z - 0.04..p.z + 0.04), s);
    }
}

/// A pole on a foot, with a ball on top and a cloth that falls in folds.
pub(super) fn flag(a: &Ask) -> BuiltModel {
    let cloth = a.main(Stuff(Finish::Fabric, 0x2f4f9f));
    let brass = stuff::BRASS.surface();
    small(a, |mesh| {
        mesh.lathe(block(-0.34..0.34, 0.0..0.16, -0.34..0.34), &[(1.0, 0.0), (0.9, 0.4), (0.3, 1.0)], 24, &brass);
        mesh.rod(at(0.0, 0.1, 0.0), at(0.0, 3.3, 0.0), 0.035, &of(Finish::Wood, 0x8a5a34));
        mesh.bead(block(-0.09..0.09, 3.26..3.44, -0.09..0.09), &brass);
        let bands = [(3.2, 2.8), (2.8, 2.4), (2.4, 2.0)];
        for (k, (top, low)) in bands.into_iter().enumerate() {
            let s = if k == 1 {
                of(Finish::Fabric, 0xf1f0ec)
            } else if k == 0 {
                cloth.clone()
            } else {
                of(Finish::Fabric, 0xb8322c)
            };
            for fold in 0..6 {
                let (x, next) = (0.03 + 0.2 * f64::from(fold), 0.03 + 0.2 * f64::from(fold + 1));
                let (z, far) = if fold % 2 == 0 { (0.0, 0.1) } else { (0.1, 0.0) };
                let sag = 0.03 * f64::from(fold);
                mesh.place(at(0.0, -sag, 0.0), [0.0; 3], |mesh| {
                    mesh.extrude(
                        1,
                        &[(z - 0.012, x), (z + 0.012, x), (far + 0.012, next), (far - 0.012, next)],
                        low..top,
                        &s,
                    )
                });
            }
        }
    })
}

/// A plate with hooks; keys hang on those of a holder.
pub(super) fn hook(a: &Ask) -> BuiltModel {
    let holder = a.says(&["key", "holder"]);
    let plate = a.main(if holder { stuff::OAK } else { stuff::BRASS });
    let brass = stuff::BRASS.surface();
    small(a, |mesh| {
        let xs: &[f64] = if holder { &[-0.7, -0.25, 0.2, 0.65] } else { &[0.0] };
        if holder {
            mesh.rounded(block(-1.0..1.0, 0.4..1.0, 0.0..0.12), 0.04, 1, &plate);
        } else {
            mesh.rounded(block(-0.3..0.3, -0.4..0.9, 0.0..0.12), 0.05, 2, &plate);
        }
        for (k, &x) in xs.iter().enumerate() {
            let r = if holder { 0.04 } else { 0.09 };
            mesh.tube(&[at(x, 0.6, 0.1), at(x, 0.5, 0.3), at(x, 0.56, 0.5), at(x, 0.74, 0.56)], r, &brass);
            mesh.bead(block(x - 1.6 * r..x + 1.6 * r, 0.7..0.7 + 3.2 * r, 0.56 - 1.6 * r..0.56 + 1.6 * r), &brass);
            if holder && k % 2 == 0 {
                mesh.place(at(x, 0.34, 0.4), [90.0, 0.0, 0.0], |mesh| {
                    mesh.torus(block(-0.13..0.13, -0.02..0.02, -0.2..0.14), 0.2, &stuff::STEEL.surface())
                });
                mesh.crisp(block(x - 0.05..x + 0.05, -0.2..0.24, 0.38..0.42), &stuff::STEEL.surface());
                mesh.crisp(block(x + 0.04..x + 0.11, -0.16..-0.08, 0.38..0.419), &stuff::STEEL.surface());
            } else if !holder {
                mesh.tube(&[at(x, 0.0, 0.1), at(x, -0.2, 0.3), at(x, -0.2, 0.45), at(x, -0.05, 0.52)], r, &brass);
            }
        }
    })
}

/// A board on three legs with a pad of paper that is written on.
pub(super) fn flip_chart(a: &Ask) -> BuiltModel {
    let steel = a.main(stuff::GRAY);
    small(a, |mesh| {
        mesh.rod(at(0.0, 2.7, -0.1), at(0.0, 0.0, -0.75), 0.03, &steel);
        for side in [-1.0, 1.0] {
            mesh.rod(at(side * 0.25, 2.7, 0.0), at(side * 0.5, 0.0, 0.35), 0.03, &steel);
        }
        mesh.place(at(0.0, 1.2, 0.22), [-7.0, 0.0, 0.0], |mesh| {
            mesh.rounded(block(-0.52..0.52, 0.0..1.56, -0.04..0.0), 0.01, 1, &stuff::WHITE.surface());
            mesh.crisp(block(-0.48..0.48, 0.08..1.5, 0.0..0.03), &stuff::PAPER.surface());
            mesh.rounded(block(-0.52..0.52, 1.5..1.6, -0.05..0.06), 0.02, 1, &steel);
            mesh.rounded(block(-0.5..0.5, -0.04..0.02, -0.02..0.12), 0.02, 1, &steel);
            for (k, color) in [0x2f6fa8, 0xc8392f, 0x3f8a4c, 0x26282b].into_iter().enumerate() {
                let y = 1.25 - 0.28 * k as f64;
                mesh.crisp(
                    block(-0.38..0.32 - 0.12 * (k % 2) as f64, y..y + 0.04, 0.03..0.036),
                    &of(Finish::Paint, color),
                );
                let x = -0.4 + 0.2 * k as f64;
                mesh.rod(at(x, 0.05, 0.08), at(x + 0.14, 0.05, 0.08), 0.025, &of(Finish::Plastic, color));
            }
        });
    })
}
