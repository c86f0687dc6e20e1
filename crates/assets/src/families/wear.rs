//! What is worn: hats, helmets, shoes, gloves, ties, stockings, masks, and the hanger of clothes.

use super::strokes::{at, headed, long, of, small};
use crate::ask::Ask;
use crate::block::block;
use crate::loft::oval;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::BuiltModel;

/// A crown and a brim; a helmet has a shell with a visor.
pub(super) fn hat(a: &Ask) -> BuiltModel {
    if a.says(&["helmet"]) {
        let shell = a.main(Stuff(Finish::Plastic, 0xd0452f));
        return headed(a, |mesh| {
            let dome = [
                oval(0.0, [0.0, -0.02], [0.82, 0.9], 1.0),
                oval(0.3, [0.0, -0.02], [0.9, 1.0], 1.0),
                oval(0.8, [0.0, -0.02], [0.84, 0.92], 1.0),
                oval(1.2, [0.0, -0.04], [0.6, 0.68], 1.0),
                oval(1.38, [0.0, -0.06], [0.24, 0.28], 1.0),
            ];
            mesh.loft(&dome, &shell);
            // Ridges over the crown.
            for x in [-0.45, 0.0, 0.45] {
                let across = f64::sqrt(1.0 - f64::powi(x / 0.95, 2));
                let point = |k: i32| {
                    let (sin, cos) = (0.24 * f64::from(k)).sin_cos();
                    at(x, 0.12 + 1.26 * cos * across, -0.04 + 0.94 * sin * across)
                };
                mesh.tube(&(-5..=5).map(point).collect::<Vec<_>>(), 0.07, &shade(&shell, 0.55));
            }
            mesh.loft(
                &[oval(0.22, [0.0, 0.66], [0.6, 0.5], 1.0), oval(0.32, [0.0, 0.6], [0.62, 0.5], 1.0)],
                &stuff::DARK_PLASTIC.surface(),
            );
            for side in [-1.0, 1.0] {
                mesh.tube(
                    &[at(side * 0.86, 0.2, 0.1), at(side * 0.7, -0.1, 0.2), at(side * 0.2, -0.3, 0.3)],
                    0.04,
                    &stuff::DARK_PLASTIC.surface(),
                );
            }
        });
    }
    let sun = a.says(&["sun", "straw"]);
    let felt = a.main(if sun { Stuff(Finish::Wicker, 0xd9b878) } else { Stuff(Finish::Fabric, 0x5a4634) });
    small(a, |mesh| {
        let brim = [(0.9, 0.0), (1.0, 0.25), (1.0, 0.4), (0.6, 0.7), (0.5, 1.0)];
        mesh.lathe(block(-1.0..1.0, 0.0..0.16, -1.0..1.0), &brim, 24, &felt);
        let crown: &[(f64, f64)] = if sun {
            &[(1.0, 0.0), (0.96, 0.5), (0.7, 0.9), (0.0, 1.0)]
        } else {
            &[(1.0, 0.0), (0.92, 0.85), (0.8, 1.0), (0.5, 0.9)]
        };
        mesh.lathe(block(-0.56..0.56, 0.08..0.8, -0.58..0.58), crown, 24, &felt);
        mesh.lathe(
            block(-0.575..0.575, 0.1..0.26, -0.595..0.595),
            &[(1.0, 0.0), (0.98, 1.0)],
            24,
            &of(Finish::Fabric, 0x8a2432),
        );
    })
}

/// A shoe along its box, its toe to the front; boots have a shaft, slippers no heel, skates wheels.
pub(super) fn shoe(a: &Ask) -> BuiltModel {
    let (boot, slipper) = (a.says(&["boot"]), a.says(&["slipper", "sandal"]));
    let skate = a.says(&["skate", "roller"]);
    let usual = if boot || skate {
        Stuff(Finish::Leather, 0x6b4227)
    } else if slipper {
        Stuff(Finish::Fabric, 0x8a5f7c)
    } else {
        Stuff(Finish::Leather, 0x3f4f66)
    };
    let upper = a.main(usual);
    let sole = if slipper || boot { shade(&upper, 0.4) } else { of(Finish::Rubber, 0xd9d4c8) };
    headed(a, |mesh| {
        if skate {
            for z in [-0.7, 0.6] {
                for x in [-0.3..-0.1, 0.1..0.3] {
                    mesh.disc(0, block(x, -0.75..-0.25, z - 0.25..z + 0.25), &of(Finish::Plastic, 0xd8483c));
                }
                mesh.crisp(block(-0.12..0.12, -0.5..-0.05, z - 0.1..z + 0.1), &stuff::STEEL.surface());
            }
            mesh.crisp(block(-0.26..0.26, -0.1..0.0, -0.9..0.9), &stuff::STEEL.surface());
        }
        mesh.loft(&[oval(0.0, [0.0, 0.0], [0.36, 1.0], 0.8), oval(0.12, [0.0, 0.0], [0.37, 1.02], 0.8)], &sole);
        if slipper {
            mesh.loft(
                &[oval(0.12, [0.0, 0.0], [0.33, 0.94], 0.8), oval(0.16, [0.0, 0.0], [0.3, 0.9], 0.8)],
                &shade(&upper, 1.5),
            );
            mesh.loft(
                &[
                    oval(0.12, [0.0, 0.42], [0.37, 0.6], 0.8),
                    oval(0.4, [0.0, 0.36], [0.34, 0.5], 0.9),
                    oval(0.56, [0.0, 0.22], [0.24, 0.3], 1.0),
                ],
                &upper,
            );
            mesh.torus(block(-0.36..0.36, 0.16..0.3, -0.96..-0.1), 0.2, &upper);
            return;
        }
        let low = [
            oval(0.1, [0.0, 0.0], [0.35, 0.98], 0.8),
            oval(0.3, [0.0, -0.02], [0.35, 0.95], 0.85),
            oval(0.48, [0.0, -0.16], [0.32, 0.78], 0.9),
            oval(0.66, [0.0, -0.36], [0.28, 0.52], 1.0),
        ];
        if boot || skate {
            let shaft = [
                oval(0.9, [0.0, -0.48], [0.28, 0.42], 1.0),
                oval(1.5, [0.0, -0.5], [0.3, 0.42], 1.0),
                oval(2.0, [0.0, -0.5], [0.33, 0.45], 1.0),
                oval(2.0, [0.0, -0.5], [0.27, 0.38], 1.0),
                oval(1.6, [0.0, -0.5], [0.25, 0.36], 1.0),
            ];
            mesh.loft(&[&low[..], &shaft[..]].concat(), &upper);
        } else {
            let collar = [
                oval(0.84, [0.0, -0.48], [0.26, 0.42], 1.0),
                oval(0.84, [0.0, -0.48], [0.2, 0.36], 1.0),
                oval(0.55, [0.0, -0.48], [0.2, 0.36], 1.0),
            ];
            mesh.loft(&[&low[..], &collar[..]].concat(), &upper);
        }
        for k in 0..4 {
            let t = f64::from(k) / 3.0;
            let (y, z) = (0.46 + 0.24 * t, 0.42 - 0.36 * t);
            mesh.rod(at(-0.2, y, z), at(0.2, y, z), 0.035, &stuff::SHEET.surface());
        }
    })
}

/// A palm, four fingers and a thumb, flat.
pub(super) fn glove(a: &Ask) -> BuiltModel {
    let wool = a.main(Stuff(Finish::Fabric, 0x3f5f7f));
    long(a, |mesh| {
        mesh.rounded(block(-0.42..0.42, -0.14..0.14, -0.5..0.32), 0.13, 2, &wool);
        mesh.rounded(block(-0.38..0.38, -0.16..0.16, -1.0..-0.44), 0.06, 1, &shade(&wool, 0.7));
        for (x, tip) in [(-0.31, 0.78), (-0.1, 0.97), (0.11, 1.0), (0.32, 0.86)] {
            mesh.rounded(block(x - 0.1..x + 0.1, -0.1..0.1, 0.1..tip), 0.09, 2, &wool);
        }
        mesh.sweep(
            &[(at(-0.3, 0.0, -0.2), 0.12, 0.1), (at(-0.56, 0.0, 0.05), 0.1, 0.1), (at(-0.66, 0.0, 0.34), 0.08, 0.08)],
            at(0.0, 1.0, 0.0),
            10,
            &wool,
        );
    })
}

/// A stocking to hang, a sock: the leg, the heel and the foot, flat.
pub(super) fn sock(a: &Ask) -> BuiltModel {
    let hung = a.h > a.d;
    let wool = a.main(if hung { Stuff(Finish::Fabric, 0xb9322c) } else { Stuff(Finish::Fabric, 0x5f7f8c) });
    let trim = if hung { stuff::SHEET.surface() } else { shade(&wool, 0.6) };
    long(a, |mesh| {
        let t = 0.1;
        mesh.rounded(block(-0.32..0.12, -t..t, -0.5..0.9), 0.09, 2, &wool);
        mesh.rounded(block(-0.36..0.16, -1.15 * t..1.15 * t, 0.68..1.0), 0.06, 1, &trim);
        let foot = [
            (at(-0.12, 0.0, -0.42), 0.22, t),
            (at(0.05, 0.0, -0.6), 0.26, t),
            (at(0.34, 0.0, -0.76), 0.22, t),
            (at(0.56, 0.0, -0.84), 0.12, t),
        ];
        mesh.sweep(&foot, at(0.0, 1.0, 0.0), 12, &wool);
        mesh.ball(block(-0.36..0.02, -1.1 * t..1.1 * t, -0.66..-0.3), &trim);
        mesh.ball(block(0.36..0.7, -1.1 * t..1.1 * t, -1.0..-0.68), &trim);
    })
}

/// A knot and two blades of cloth that widen to points.
pub(super) fn tie(a: &Ask) -> BuiltModel {
    let silk = a.main(Stuff(Finish::Fabric, 0x2f4b7c));
    long(a, |mesh| {
        mesh.extrude(1, &[(0.7, -0.1), (0.7, 0.1), (-0.75, 0.3), (-1.0, 0.0), (-0.75, -0.3)], -0.02..0.03, &silk);
        mesh.extrude(1, &[(0.66, -0.14), (0.66, 0.14), (0.96, 0.24), (0.96, -0.24)], -0.04..0.09, &shade(&silk, 1.15));
        for k in 0..5 {
            let z = -0.6 + 0.26 * f64::from(k);
            let half = 0.27 - 0.036 * f64::from(k);
            mesh.extrude(
                1,
                &[(z, -half), (z + 0.06, -half), (z + 0.16, half), (z + 0.1, half)],
                0.0..0.036,
                &of(Finish::Fabric, 0xc9b06a),
            );
        }
    })
}

/// A face: it looks to +z, with eyes that are open.
pub(super) fn mask(a: &Ask) -> BuiltModel {
    let paint = a.main(Stuff(Finish::Wood, 0xa8632f));
    small(a, |mesh| {
        mesh.ball(block(-0.7..0.7, -1.0..1.0, -0.3..0.3), &paint);
        for side in [-1.0, 1.0] {
            mesh.ball(
                block(-0.17..0.17, 0.18..0.38, 0.14..0.32).moved(side * 0.28, 0.0, 0.0),
                &stuff::DARK_PLASTIC.surface(),
            );
            mesh.tube(
                &[at(side * 0.1, 0.48, 0.28), at(side * 0.3, 0.55, 0.26), at(side * 0.5, 0.44, 0.18)],
                0.05,
                &shade(&paint, 0.5),
            );
        }
        mesh.sweep(
            &[(at(0.0, 0.4, 0.26), 0.06, 0.06), (at(0.0, -0.1, 0.36), 0.13, 0.12)],
            at(0.0, 0.0, 1.0),
            8,
            &paint,
        );
        mesh.ball(block(-0.3..0.3, -0.56..-0.36, 0.1..0.34), &of(Finish::Paint, 0x9a2b2b));
    })
}

/// Shoulders, a bar and a hook.
pub(super) fn hanger(a: &Ask) -> BuiltModel {
    let wood = a.main(Stuff(Finish::Wood, 0xb98a55));
    small(a, |mesh| {
        for side in [-1.0, 1.0] {
            let arm = [
                (at(0.0, 0.56, 0.0), 0.05, 0.07),
                (at(side * 0.5, 0.36, 0.0), 0.05, 0.06),
                (at(side, 0.06, 0.0), 0.05, 0.05),
            ];
            mesh.sweep(&arm, at(0.0, 1.0, 0.0), 10, &wood);
        }
        mesh.rod(at(-0.92, 0.1, 0.0), at(0.92, 0.1, 0.0), 0.025, &wood);
        let hook = [
            at(0.0, 0.56, 0.0),
            at(0.0, 0.76, 0.0),
            at(0.1, 0.84, 0.0),
            at(0.12, 0.96, 0.0),
            at(0.02, 1.05, 0.0),
            at(-0.1, 1.0, 0.0),
            at(-0.12, 0.92, 0.0),
        ];
        mesh.tube(&hook, 0.02, &stuff::STEEL.surface());
    })
}
