//! Tools: for the hand, with long handles, brushes, a vise, an anvil.

use super::strokes::{at, blade, cone, headed, long, of, small};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;

/// A tool for the hand, told by its name; a spanner if it says nothing more.
pub(super) fn tool(a: &Ask) -> BuiltModel {
    let grip = a.main(Stuff(Finish::Plastic, 0xc63b2c));
    let wood = a.main(Stuff(Finish::Wood, 0xa8703c));
    let steel = of(Finish::Metal, 0x8f969c);
    if a.says(&["soldering"]) {
        return soldering_iron(a, &grip, &steel);
    }
    long(a, |mesh| {
        if a.says(&["hammer", "mallet"]) {
            hammer(mesh, &wood, &steel);
        } else if a.says(&["axe", "hatchet"]) {
            mesh.sweep(
                &[(at(0.0, 0.0, -1.0), 0.09, 0.06), (at(0.0, 0.0, 1.0), 0.06, 0.05)],
                at(0.0, 1.0, 0.0),
                12,
                &wood,
            );
            mesh.extrude(1, &[(0.6, -0.1), (0.95, -0.1), (1.1, 0.5), (0.45, 0.5)], -0.07..0.07, &steel);
        } else if a.says(&["screwdriver", "chisel"]) {
            let flat = if a.says(&["chisel"]) { 0.17 } else { 0.05 };
            let handle =
                [(at(0.0, 0.0, -1.0), 0.13, 0.13), (at(0.0, 0.0, -0.9), 0.2, 0.2), (at(0.0, 0.0, -0.3), 0.2, 0.2)];
            mesh.sweep(&handle, at(0.0, 1.0, 0.0), 8, &grip);
            cone(mesh, at(0.0, 0.0, -0.3), at(0.0, 0.0, -0.1), [0.2, 0.1], &shade(&grip, 0.6));
            mesh.sweep(
                &[
                    (at(0.0, 0.0, -0.1), flat, 0.05),
                    (at(0.0, 0.0, 0.85), flat, 0.05),
                    (at(0.0, 0.0, 1.0), 1.4 * flat, 0.015),
                ],
                at(0.0, 1.0, 0.0),
                8,
                &steel,
            );
        } else if a.says(&["saw", "handsaw", "hacksaw"]) {
            saw(mesh, a.says(&["hacksaw"]), &wood, &steel);
        } else if a.says(&["drill"]) {
            drill(mesh, &grip, &steel);
        } else if a.says(&["chainsaw", "chain"]) {
            chainsaw(mesh, &grip, &steel);
        } else if a.says(&["plier", "pincer"]) {
            for side in [-1.0, 1.0] {
                let arm = [at(side * 0.35, 0.0, -1.0), at(side * 0.3, 0.0, -0.4), at(0.0, 0.0, 0.3)];
                mesh.tube(&arm, 0.09, &grip);
                mesh.extrude(
                    1,
                    &[(0.2, 0.0), (0.2, -side * 0.2), (1.0, -side * 0.08), (1.0, -side * 0.01)],
                    -0.09..0.09,
                    &steel,
                );
            }
        } else {
            spanner(mesh, &a.main(Stuff(Finish::Metal, 0x8f969c)));
        }
    })
}

/// In its stand, the tip in a coil.
fn soldering_iron(a: &Ask, grip: &Surface, steel: &Surface) -> BuiltModel {
    headed(a, |mesh| {
        mesh.rounded(block(-0.5..0.5, 0.0..0.14, -0.7..0.9), 0.04, 1, &stuff::DARK_PLASTIC.surface());
        mesh.rounded(block(-0.3..0.3, 0.14..0.24, 0.4..0.8), 0.04, 1, &of(Finish::Rubber, 0xd9b33a));
        let way = at(0.0, 0.55, -0.84);
        let tip = at(0.0, 0.35, 0.2);
        for k in 0..5 {
            let near = tip + way * (0.14 * f64::from(k));
            let r = 0.13 + 0.025 * f64::from(k);
            mesh.place(near, [-57.0, 0.0, 0.0], |mesh| mesh.torus(block(-r..r, -0.03..0.03, -r..r), 0.2, steel));
        }
        mesh.rod(at(0.0, 0.1, -0.3), tip + way * 0.5, 0.04, steel);
        cone(mesh, tip, tip + way * 0.7, [0.03, 0.07], steel);
        cone(mesh, tip + way * 0.7, tip + way * 0.8, [0.17, 0.17], &stuff::DARK_PLASTIC.surface());
        cone(mesh, tip + way * 0.78, tip + way * 1.7, [0.1, 0.14], grip);
    })
}

fn hammer(mesh: &mut Mesh, wood: &Surface, steel: &Surface) {
    let handle = [(at(0.0, 0.0, -1.0), 0.1, 0.08), (at(0.0, 0.0, -0.5), 0.11, 0.09), (at(0.0, 0.0, 1.0), 0.06, 0.06)];
    mesh.sweep(&handle, at(0.0, 1.0, 0.0), 12, wood);
    mesh.rounded(block(-0.16..0.16, -0.13..0.13, 0.66..0.96), 0.03, 1, steel);
    cone(mesh, at(0.1, 0.0, 0.81), at(0.42, 0.0, 0.81), [0.11, 0.11], steel);
    cone(mesh, at(0.38, 0.0, 0.81), at(0.52, 0.0, 0.81), [0.17, 0.17], steel);
    for side in [-1.0, 1.0] {
        let claw = [
            (at(-0.1, side * 0.04, 0.81), 0.04, 0.1),
            (at(-0.35, side * 0.06, 0.78), 0.04, 0.07),
            (at(-0.55, side * 0.09, 0.6), 0.03, 0.02),
        ];
        mesh.sweep(&claw, at(0.0, 0.0, 1.0), 8, steel);
    }
}

/// Open jaws at one end, a ring at the other.
fn spanner(mesh: &mut Mesh, steel: &Surface) {
    mesh.rounded(block(-0.09..0.09, -0.05..0.05, -0.75..0.7), 0.03, 1, steel);
    mesh.torus(block(-0.2..0.2, -0.08..0.08, -1.1..-0.7), 0.45, steel);
    mesh.extrude(
        1,
        &[(0.6, -0.12), (0.76, -0.26), (0.84, -0.26), (0.84, 0.26), (0.76, 0.26), (0.6, 0.12)],
        -0.08..0.08,
        steel,
    );
    for side in [-1.0, 1.0] {
        let jaw =
            [(0.82, side * 0.12), (0.82, side * 0.26), (1.0, side * 0.26), (1.12, side * 0.2), (1.12, side * 0.12)];
        mesh.extrude(1, &jaw, -0.08..0.08, steel);
    }
}

fn saw(mesh: &mut Mesh, framed: bool, wood: &Surface, steel: &Surface) {
    if framed {
        for (from, to) in [((-0.6, 0.1), (-0.6, 0.5)), ((-0.6, 0.5), (1.0, 0.5)), ((1.0, 0.5), (1.0, -0.1))] {
            mesh.rod(at(from.1, 0.0, from.0), at(to.1, 0.0, to.0), 0.04, steel);
        }
        mesh.crisp(block(-0.1..-0.02, -0.015..0.015, -0.7..1.0), steel);
        mesh.rounded(block(-0.3..0.14, -0.08..0.08, -0.9..-0.66), 0.06, 2, wood);
        return;
    }
    mesh.extrude(1, &[(-0.45, -0.22), (1.0, -0.22), (1.0, -0.08), (-0.45, 0.26)], -0.012..0.012, steel);
    for k in 0..22 {
        let z = -0.42 + 1.4 * f64::from(k) / 22.0;
        mesh.extrude(1, &[(z, -0.21), (z + 0.06, -0.21), (z + 0.06, -0.27)], -0.01..0.01, steel);
    }
    // The grip is an open ring.
    for (x, z) in
        [(-0.28..-0.16, -0.95..-0.4), (0.2..0.32, -0.95..-0.4), (-0.2..0.24, -1.0..-0.86), (-0.2..0.24, -0.56..-0.4)]
    {
        mesh.rounded(block(x, -0.07..0.07, z), 0.05, 2, wood);
    }
}

/// Held upright: +x is up.
fn drill(mesh: &mut Mesh, case: &Surface, steel: &Surface) {
    let dark = stuff::DARK_PLASTIC.surface();
    mesh.rounded(block(0.2..0.7, -0.2..0.2, -0.8..0.3), 0.12, 3, case);
    cone(mesh, at(0.45, 0.0, 0.25), at(0.45, 0.0, 0.6), [0.18, 0.12], &dark);
    cone(mesh, at(0.45, 0.0, 0.58), at(0.45, 0.0, 1.1), [0.03, 0.025], steel);
    mesh.sweep(&[(at(0.3, 0.0, -0.4), 0.14, 0.2), (at(-0.6, 0.0, -0.5), 0.13, 0.19)], at(0.0, 0.0, 1.0), 12, &dark);
    mesh.rounded(block(-0.95..-0.58, -0.22..0.22, -0.85..-0.15), 0.06, 2, case);
    mesh.rounded(block(0.02..0.2, -0.06..0.06, -0.26..-0.14), 0.03, 1, &of(Finish::Plastic, 0xe0b23a));
}

/// Held upright: +x is up.
fn chainsaw(mesh: &mut Mesh, case: &Surface, steel: &Surface) {
    let dark = stuff::DARK_PLASTIC.surface();
    mesh.rounded(block(-0.3..0.2, -0.22..0.22, -0.7..0.05), 0.08, 2, case);
    blade(mesh, at(-0.08, 0.0, 0.45), [0.26, 1.3], 0.04, steel);
    blade(mesh, at(-0.08, 0.0, 0.45), [0.32, 1.38], 0.02, &dark);
    let bow = [at(0.1, -0.2, -0.05), at(0.42, -0.15, -0.1), at(0.42, 0.15, -0.1), at(0.1, 0.2, -0.05)];
    mesh.tube(&bow, 0.035, &dark);
    mesh.tube(&[at(0.1, 0.0, -0.65), at(0.12, 0.0, -1.0), at(-0.2, 0.0, -1.0), at(-0.25, 0.0, -0.65)], 0.05, &dark);
}

/// What has a long handle, standing with its lower end down: brooms, mops, rakes, shovels, oars, sticks.
pub(super) fn broom(a: &Ask) -> BuiltModel {
    let wood = a.main(Stuff(Finish::Wood, 0xb98a55));
    let steel = of(Finish::Metal, 0x7f878d);
    let up = at(0.0, 1.0, 0.0);
    long(a, |mesh| {
        let handle =
            |mesh: &mut Mesh, low: f64, r: f64| cone(mesh, at(0.0, 0.0, low), at(0.0, 0.0, 1.0), [r, r], &wood);
        if a.says(&["mop"]) {
            handle(mesh, -0.7, 0.025);
            mesh.rounded(block(-0.12..0.12, -0.05..0.05, -0.74..-0.68), 0.03, 1, &of(Finish::Plastic, 0x2f6fa8));
            for k in 0..11 {
                let x = (f64::from(k) - 5.0) / 5.0;
                let y = 0.07 * (f64::from(k) * 2.4).sin();
                mesh.tube(
                    &[at(0.1 * x, 0.3 * y, -0.71), at(0.2 * x, y, -0.84), at(0.27 * x, y, -1.0)],
                    0.024,
                    &stuff::LINEN.surface(),
                );
            }
        } else if a.says(&["rake", "pitchfork", "fork"]) {
            handle(mesh, -0.86, 0.02);
            mesh.rounded(block(-0.26..0.26, -0.02..0.02, -0.88..-0.84), 0.01, 1, &steel);
            for k in 0..9 {
                let x = (f64::from(k) - 4.0) * 0.062;
                mesh.tube(&[at(x, 0.0, -0.86), at(x, 0.01, -0.95), at(x, 0.06, -1.0)], 0.009, &steel);
            }
        } else if a.says(&["shovel", "spade"]) {
            handle(mesh, -0.6, 0.025);
            let point = if a.says(&["spade"]) { 0.0 } else { 0.12 };
            mesh.extrude(
                1,
                &[(-0.56, -0.17), (-0.56, 0.17), (-0.9, 0.17), (-0.9 - point, 0.0), (-0.9, -0.17)],
                -0.012..0.012,
                &steel,
            );
            cone(mesh, at(0.0, 0.0, -0.7), at(0.0, 0.0, -0.45), [0.02, 0.035], &steel);
            mesh.rod(at(-0.1, 0.0, 0.98), at(0.1, 0.0, 0.98), 0.028, &wood);
        } else if a.says(&["oar", "paddle"]) {
            handle(mesh, -0.6, 0.022);
            blade(mesh, at(0.0, 0.0, -0.72), [0.2, 0.56], 0.02, &shade(&wood, 0.8));
            mesh.rod(at(-0.05, 0.0, 0.99), at(0.05, 0.0, 0.99), 0.025, &wood);
        } else if a.says(&["hockey"]) {
            mesh.rounded(block(-0.03..0.03, -0.02..0.02, -0.95..1.0), 0.01, 1, &wood);
            mesh.extrude(
                1,
                &[(-0.9, -0.03), (-1.0, -0.01), (-1.0, 0.3), (-0.9, 0.3), (-0.88, 0.03)],
                -0.02..0.02,
                &stuff::DARK_PLASTIC.surface(),
            );
            mesh.rounded(block(-0.034..0.034, -0.024..0.024, 0.75..0.99), 0.01, 1, &stuff::DARK_PLASTIC.surface());
        } else if a.says(&["peel"]) {
            cone(mesh, at(0.0, 0.0, 0.0), at(0.0, 0.0, 1.0), [0.04, 0.045], &wood);
            blade(mesh, at(0.0, 0.0, -0.5), [0.8, 1.05], 0.05, &wood);
        } else {
            handle(mesh, -0.7, 0.025);
            mesh.rounded(block(-0.24..0.24, -0.06..0.06, -0.76..-0.68), 0.03, 2, &shade(&wood, 0.7));
            let straw = of(Finish::Wicker, 0xd8b45f);
            for k in 0..7 {
                let x = (f64::from(k) - 3.0) / 3.0;
                mesh.sweep(
                    &[(at(0.27 * x, 0.0, -1.0), 0.045, 0.08), (at(0.2 * x, 0.0, -0.74), 0.035, 0.05)],
                    up,
                    8,
                    &straw,
                );
            }
        }
    })
}

/// Brushes: for paint, for hair, for hands and floors, for dust.
pub(super) fn brush(a: &Ask) -> BuiltModel {
    let wood = a.main(Stuff(Finish::Wood, 0xb5763a));
    let (hair, steel) = (of(Finish::Fabric, 0x54402f), stuff::STEEL.surface());
    let up = at(0.0, 1.0, 0.0);
    long(a, |mesh| {
        if a.says(&["duster", "feather"]) {
            cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, 0.0), [0.05, 0.07], &wood);
            let plume = of(Finish::Fabric, 0x8a5f7c);
            for k in 0..14 {
                let (sin, cos) = (f64::from(k) * 2.4).sin_cos();
                let z = 0.05 * f64::from(k);
                let path = [
                    (at(0.0, 0.0, z - 0.1), 0.03, 0.03),
                    (at(0.2 * cos, 0.2 * sin, z + 0.2), 0.13, 0.06),
                    (at(0.34 * cos, 0.34 * sin, z + 0.36), 0.02, 0.02),
                ];
                mesh.sweep(&path, up, 8, &plume);
            }
        } else if a.says(&["roller"]) {
            cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, -0.3), [0.1, 0.08], &a.main(Stuff(Finish::Plastic, 0x2f6fa8)));
            mesh.tube(
                &[at(0.0, 0.0, -0.3), at(0.0, 0.0, 0.2), at(0.8, 0.0, 0.4), at(0.8, 0.0, 0.8), at(0.6, 0.0, 0.8)],
                0.03,
                &steel,
            );
            cone(mesh, at(-0.7, 0.0, 0.8), at(0.66, 0.0, 0.8), [0.22, 0.22], &of(Finish::Carpet, 0xe3c25a));
        } else if a.says(&["paintbrush", "paint"]) {
            let handle =
                [(at(0.0, 0.0, -1.0), 0.05, 0.05), (at(0.0, 0.0, -0.2), 0.13, 0.1), (at(0.0, 0.0, 0.2), 0.1, 0.1)];
            mesh.sweep(&handle, up, 12, &wood);
            cone(mesh, at(0.0, 0.0, 0.18), at(0.0, 0.0, 0.5), [0.13, 0.15], &steel);
            let tip =
                [(at(0.0, 0.0, 0.48), 0.14, 0.14), (at(0.0, 0.0, 0.7), 0.17, 0.16), (at(0.0, 0.0, 1.0), 0.02, 0.02)];
            mesh.sweep(&tip, up, 12, &hair);
        } else if a.says(&["toothbrush", "tooth"]) {
            mesh.rounded(block(-0.1..0.1, -0.05..0.05, -1.0..1.0), 0.05, 2, &a.main(Stuff(Finish::Plastic, 0x2f8fb5)));
            for tuft in block(-0.09..0.09, 0.04..0.3, 0.55..0.98).split(2, 5, 0.02) {
                mesh.crisp(tuft, &stuff::SHEET.surface());
            }
        } else {
            mesh.sweep(&[(at(0.0, 0.0, -1.0), 0.08, 0.06), (at(0.0, 0.0, -0.1), 0.07, 0.06)], up, 10, &wood);
            blade(mesh, at(0.0, 0.0, 0.4), [0.5, 1.2], 0.14, &wood);
            for row in block(-0.19..0.19, 0.06..0.36, -0.1..0.9).split(2, 8, 0.08) {
                // Fewer where the back of the brush is narrower.
                let n = if row.center().z < 0.0 || row.center().z > 0.8 { 3 } else { 5 };
                let half = 0.04 * n as f64;
                for tuft in row.x(-half..half).split(0, n, 0.04) {
                    mesh.crisp(tuft, &hair);
                }
            }
        }
    })
}

/// Two jaws, a screw with a bar to turn it, a foot.
pub(super) fn vise(a: &Ask) -> BuiltModel {
    let iron = a.main(Stuff(Finish::Paint, 0x2f5f8e));
    let steel = stuff::STEEL.surface();
    small(a, |mesh| {
        mesh.rounded(block(-0.5..0.5, 0.0..0.12, -0.8..0.2), 0.04, 1, &iron);
        mesh.rounded(block(-0.3..0.3, 0.1..0.6, -0.6..0.0), 0.08, 2, &iron);
        mesh.rounded(block(-0.2..0.2, 0.2..0.55, -0.1..0.7), 0.04, 1, &shade(&iron, 0.85));
        for z in [-0.16..0.0, 0.3..0.46] {
            mesh.rounded(block(-0.42..0.42, 0.5..0.9, z), 0.04, 1, &iron);
        }
        for z in [-0.01..0.06, 0.24..0.31] {
            mesh.crisp(block(-0.44..0.44, 0.74..0.92, z), &steel);
        }
        mesh.rod(at(0.0, 0.38, 0.6), at(0.0, 0.38, 0.95), 0.08, &steel);
        mesh.rod(at(-0.45, 0.38, 0.9), at(0.45, 0.38, 0.9), 0.035, &steel);
        for side in [-0.45, 0.45] {
            mesh.bead(block(-0.06..0.06, 0.32..0.44, 0.84..0.96).moved(side, 0.0, 0.0), &steel);
        }
    })
}

/// A face with a horn on a waist; where it is high it stands on a block of wood.
pub(super) fn anvil(a: &Ask) -> BuiltModel {
    let iron = a.main(Stuff(Finish::Iron, 0x3a3e43));
    let low = if a.h > a.w { 0.55 * a.h } else { 0.0 };
    let mut m = BuiltModel::default();
    let b = a.whole();
    if low > 0.0 {
        m.drum(b.share(0.12..0.88, 0.0..1.0, 0.0..1.0).y(0.0..low), &stuff::OAK.surface());
    }
    m.solid(b.y(low..a.h));
    m.mesh.stretch(b.y(low..a.h), |mesh| {
        mesh.taper(block(-0.7..0.7, 0.0..0.1, -0.5..0.5), block(-0.6..0.6, 0.1..0.25, -0.42..0.42), &iron);
        mesh.taper(block(-0.45..0.45, 0.2..0.3, -0.3..0.3), block(-0.3..0.3, 0.4..0.6, -0.24..0.24), &iron);
        mesh.taper(block(-0.3..0.3, 0.55..0.6, -0.24..0.24), block(-0.55..0.55, 0.7..0.75, -0.34..0.34), &iron);
        mesh.rounded(block(-1.0..0.55, 0.72..1.0, -0.36..0.36), 0.03, 1, &iron);
        let horn =
            [(at(0.5, 0.84, 0.0), 0.12, 0.3), (at(0.85, 0.88, 0.0), 0.1, 0.2), (at(1.25, 0.94, 0.0), 0.03, 0.04)];
        mesh.sweep(&horn, at(0.0, 0.0, 1.0), 12, &iron);
    });
    m
}
