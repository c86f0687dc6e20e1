//! What is pushed or drives itself: strollers, wagons, scooters to sit on, vacuum cleaners, mowers, walkers; humanoids, robot
//! dogs, rovers.

use super::strokes::{at, cone, headed, of, small};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;

/// A wheel with its axle along x.
fn wheel(mesh: &mut Mesh, [x, y, z]: [f64; 3], r: f64, half: f64) {
    mesh.disc(0, block(x - half..x + half, y - r..y + r, z - r..z + r), &stuff::RUBBER.surface());
    mesh.disc(
        0,
        block(x - 1.15 * half..x + 1.15 * half, y - 0.6 * r..y + 0.6 * r, z - 0.6 * r..z + 0.6 * r),
        &stuff::STEEL.surface(),
    );
}

/// A seat, or a tub for a baby, under a hood on four wheels, with a bar to push.
pub(super) fn stroller(a: &Ask) -> BuiltModel {
    let cloth = a.main(Stuff(Finish::Fabric, 0x3f5f7f));
    let (steel, dark) = (stuff::STEEL.surface(), stuff::DARK_PLASTIC.surface());
    let tub = a.says(&["pram", "carriage"]);
    headed(a, |mesh| {
        for x in [-0.4, 0.4] {
            for z in [-0.55, 0.6] {
                wheel(mesh, [x, 0.2, z], 0.2, 0.05);
            }
            mesh.tube(&[at(0.9 * x, 0.22, 0.6), at(0.9 * x, 0.7, 0.1), at(0.9 * x, 1.45, -0.75)], 0.03, &steel);
            mesh.rod(at(0.9 * x, 0.22, -0.55), at(0.9 * x, 0.85, 0.0), 0.03, &steel);
        }
        mesh.rod(at(-0.36, 1.45, -0.75), at(0.36, 1.45, -0.75), 0.045, &dark);
        if tub {
            mesh.taper(block(-0.24..0.24, 0.5..0.95, -0.4..0.5), block(-0.32..0.32, 0.9..0.95, -0.55..0.65), &cloth);
            mesh.rounded(block(-0.33..0.33, 0.92..1.0, 0.0..0.66), 0.04, 2, &shade(&cloth, 1.25));
        } else {
            mesh.place(at(0.0, 0.55, -0.1), [-24.0, 0.0, 0.0], |mesh| {
                mesh.rounded(block(-0.3..0.3, 0.0..0.8, -0.08..0.0), 0.04, 2, &cloth)
            });
            mesh.rounded(block(-0.3..0.3, 0.5..0.58, -0.12..0.4), 0.04, 2, &cloth);
            mesh.place(at(0.0, 0.54, 0.4), [60.0, 0.0, 0.0], |mesh| {
                mesh.rounded(block(-0.26..0.26, -0.05..0.0, 0.0..0.36), 0.02, 1, &shade(&cloth, 0.7))
            });
            mesh.tube(
                &[at(-0.32, 0.8, -0.1), at(-0.32, 0.86, 0.36), at(0.32, 0.86, 0.36), at(0.32, 0.8, -0.1)],
                0.035,
                &dark,
            );
        }
        // A hood of ribs that open from the back.
        let (y, z) = if tub { (0.96, -0.1) } else { (1.0, -0.3) };
        for k in 0..5 {
            mesh.place(at(0.0, y, z), [-80.0 + 26.0 * f64::from(k), 0.0, 0.0], |mesh| {
                mesh.extrude(
                    0,
                    &[(0.0, -0.02), (0.46, -0.14), (0.48, 0.14), (0.0, 0.02)],
                    -0.34..0.34,
                    &shade(&cloth, if k % 2 == 0 { 0.8 } else { 0.95 }),
                );
            });
        }
    })
}

/// A tub on four wheels with a bar to pull.
pub(super) fn wagon(a: &Ask) -> BuiltModel {
    let red = a.main(stuff::RED);
    small(a, |mesh| {
        for z in [-0.4, 0.4] {
            for x in [-0.6, 0.6] {
                mesh.disc(2, block(x - 0.2..x + 0.2, 0.0..0.4, z - 0.05..z + 0.05), &stuff::RUBBER.surface());
                mesh.disc(2, block(x - 0.12..x + 0.12, 0.08..0.32, z - 0.06..z + 0.06), &stuff::WHITE.surface());
            }
            mesh.crisp(block(-0.9..0.9, 0.4..0.75, z - 0.03..z + 0.03), &red);
        }
        mesh.crisp(block(-0.9..0.9, 0.36..0.44, -0.42..0.42), &red);
        for x in [-0.9, 0.86] {
            mesh.crisp(block(x..x + 0.04, 0.4..0.75, -0.42..0.42), &red);
        }
        for x in [-0.6, 0.6] {
            mesh.rod(at(x, 0.2, -0.4), at(x, 0.2, 0.4), 0.04, &stuff::BLACK_STEEL.surface());
        }
        mesh.rod(at(0.85, 0.3, 0.0), at(1.4, 1.15, 0.0), 0.035, &stuff::BLACK_STEEL.surface());
        mesh.rod(at(1.4, 1.15, -0.18), at(1.4, 1.15, 0.18), 0.045, &stuff::RUBBER.surface());
    })
}

/// A seat over a platform with a tiller and a basket before it.
pub(super) fn mobility_scooter(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::RED);
    let dark = stuff::DARK_PLASTIC.surface();
    headed(a, |mesh| {
        for x in [-0.3, 0.3] {
            wheel(mesh, [x, 0.16, -0.5], 0.16, 0.07);
            wheel(mesh, [x, 0.16, 0.62], 0.16, 0.07);
        }
        mesh.rounded(block(-0.3..0.3, 0.14..0.26, -0.6..0.7), 0.05, 2, &case);
        mesh.rounded(block(-0.28..0.28, 0.2..0.48, -0.7..-0.1), 0.12, 3, &case);
        mesh.rod(at(0.0, 0.4, -0.35), at(0.0, 0.62, -0.35), 0.07, &dark);
        mesh.rounded(block(-0.28..0.28, 0.6..0.72, -0.62..-0.08), 0.05, 2, &dark);
        mesh.place(at(0.0, 0.68, -0.58), [-8.0, 0.0, 0.0], |mesh| {
            mesh.rounded(block(-0.26..0.26, 0.0..0.56, -0.06..0.06), 0.05, 2, &dark)
        });
        for side in [-1.0, 1.0] {
            mesh.tube(
                &[at(side * 0.32, 0.62, -0.5), at(side * 0.34, 0.92, -0.5), at(side * 0.34, 0.92, -0.14)],
                0.035,
                &dark,
            );
            mesh.tube(&[at(0.0, 1.08, 0.44), at(side * 0.2, 1.1, 0.42), at(side * 0.32, 1.06, 0.32)], 0.03, &dark);
        }
        mesh.rounded(block(-0.14..0.14, 0.22..0.6, 0.52..0.7), 0.06, 2, &case);
        mesh.rod(at(0.0, 0.5, 0.62), at(0.0, 1.1, 0.44), 0.05, &dark);
        mesh.disc(2, block(-0.06..0.06, 0.84..0.96, 0.54..0.62), &of(Finish::Glow, 0xfff2cf));
        for side in block(-0.18..-0.16, 0.64..0.84, 0.62..0.86).both_sides() {
            mesh.crisp(side, &dark);
        }
        mesh.crisp(block(-0.18..0.18, 0.62..0.65, 0.62..0.86), &dark);
        mesh.crisp(block(-0.18..0.18, 0.64..0.84, 0.84..0.86), &dark);
    })
}

/// A body on wheels with a hose, a pipe and a wide nozzle.
pub(super) fn vacuum_cleaner(a: &Ask) -> BuiltModel {
    let case = a.main(Stuff(Finish::Plastic, 0xb8322c));
    let (dark, steel) = (stuff::DARK_PLASTIC.surface(), stuff::CHROME.surface());
    headed(a, |mesh| {
        mesh.rounded(block(-0.4..0.4, 0.08..0.62, -0.9..0.1), 0.24, 4, &case);
        mesh.rounded(block(-0.3..0.3, 0.5..0.7, -0.75..-0.2), 0.08, 2, &dark);
        for side in [-1.0, 1.0] {
            mesh.disc(0, block(side * 0.42 - 0.05..side * 0.42 + 0.05, 0.0..0.46, -0.86..-0.4), &dark);
        }
        let hose = [at(0.0, 0.42, 0.08), at(0.0, 0.6, 0.4), at(0.15, 1.0, 0.5), at(0.3, 1.5, 0.3), at(0.3, 1.7, 0.1)];
        mesh.tube(&hose, 0.07, &dark);
        cone(mesh, at(0.3, 1.72, 0.08), at(0.3, 1.35, 0.4), [0.07, 0.06], &case);
        cone(mesh, at(0.3, 1.36, 0.39), at(0.3, 0.12, 0.9), [0.045, 0.045], &steel);
        mesh.rounded(block(0.0..0.6, 0.0..0.14, 0.82..1.05), 0.05, 2, &dark);
    })
}

/// A deck with a motor on four wheels, a bag behind, a bar to push.
pub(super) fn lawn_mower(a: &Ask) -> BuiltModel {
    let case = a.main(Stuff(Finish::Paint, 0x3f8a4c));
    let dark = stuff::DARK_PLASTIC.surface();
    headed(a, |mesh| {
        for x in [-0.46, 0.46] {
            wheel(mesh, [x, 0.16, 0.6], 0.16, 0.06);
            wheel(mesh, [x, 0.2, -0.2], 0.2, 0.06);
            mesh.tube(&[at(0.8 * x, 0.3, -0.2), at(0.8 * x, 0.6, -0.6), at(0.8 * x, 1.3, -1.2)], 0.03, &dark);
        }
        mesh.taper(block(-0.42..0.42, 0.1..0.42, -0.3..0.7), block(-0.34..0.34, 0.36..0.42, -0.2..0.58), &case);
        mesh.drum(block(-0.24..0.24, 0.4..0.62, -0.04..0.44), &dark);
        mesh.rounded(block(-0.18..0.18, 0.6..0.7, 0.02..0.38), 0.05, 2, &case);
        mesh.rounded(block(0.2..0.34, 0.42..0.54, 0.1..0.3), 0.03, 1, &stuff::STEEL.surface());
        mesh.rod(at(-0.37, 1.3, -1.2), at(0.37, 1.3, -1.2), 0.045, &stuff::RUBBER.surface());
        mesh.rod(at(-0.33, 0.95, -0.9), at(0.33, 0.95, -0.9), 0.025, &dark);
        mesh.rounded(block(-0.3..0.3, 0.2..0.66, -0.9..-0.3), 0.12, 2, &of(Finish::Fabric, 0x3c434b));
    })
}

/// A frame with grips to walk with, two wheels in front.
pub(super) fn walker(a: &Ask) -> BuiltModel {
    let steel = a.main(stuff::STEEL);
    small(a, |mesh| {
        for side in [-1.0, 1.0] {
            let x = side * 0.4;
            mesh.tube(
                &[
                    at(x, 0.0, -0.3),
                    at(0.92 * x, 1.3, -0.14),
                    at(0.92 * x, 1.42, -0.05),
                    at(0.92 * x, 1.36, 0.1),
                    at(x, 0.12, 0.35),
                ],
                0.035,
                &steel,
            );
            mesh.rod(at(0.92 * x, 1.4, -0.16), at(0.92 * x, 1.4, 0.06), 0.06, &stuff::RUBBER.surface());
            mesh.rod(at(x, 0.5, -0.24), at(x, 0.5, 0.26), 0.026, &steel);
            wheel(mesh, [x + side * 0.06, 0.12, 0.35], 0.12, 0.04);
            mesh.drum(block(x - 0.05..x + 0.05, 0.0..0.08, -0.36..-0.26), &stuff::RUBBER.surface());
        }
        for y in [0.62, 1.08] {
            mesh.rod(at(-0.38, y, 0.24 - 0.1 * y), at(0.38, y, 0.24 - 0.1 * y), 0.03, &steel);
        }
    })
}

/// Head with a visor, trunk, arms and legs with joints.
pub(super) fn humanoid(a: &Ask) -> BuiltModel {
    let shell = a.main(stuff::WHITE);
    let (dark, glow) = (stuff::DARK_PLASTIC.surface(), of(Finish::Glow, 0x4f9fe0));
    small(a, |mesh| {
        mesh.rounded(block(-0.22..0.22, 2.7..3.2, -0.2..0.2), 0.16, 3, &shell);
        mesh.rounded(block(-0.18..0.18, 2.84..3.08, 0.1..0.22), 0.08, 2, &dark);
        for x in [-0.08, 0.08] {
            mesh.disc(2, block(x - 0.04..x + 0.04, 2.93..3.01, 0.2..0.24), &glow);
        }
        mesh.rod(at(0.0, 2.5, 0.0), at(0.0, 2.75, 0.0), 0.09, &dark);
        mesh.taper(block(-0.26..0.26, 1.9..2.6, -0.18..0.18), block(-0.42..0.42, 2.5..2.6, -0.22..0.22), &shell);
        mesh.disc(2, block(-0.09..0.09, 2.26..2.44, 0.18..0.25), &glow);
        mesh.rounded(block(-0.2..0.2, 1.6..1.95, -0.14..0.14), 0.06, 2, &dark);
        mesh.rounded(block(-0.3..0.3, 1.4..1.7, -0.18..0.18), 0.1, 2, &shell);
        for side in [-1.0, 1.0] {
            let ball = |mesh: &mut Mesh, x: f64, y: f64, z: f64, r: f64| {
                mesh.bead(block(x - r..x + r, y - r..y + r, z - r..z + r), &dark)
            };
            let x = side * 0.54;
            ball(mesh, side * 0.5, 2.48, 0.0, 0.14);
            cone(mesh, at(x, 2.42, 0.0), at(x, 1.98, 0.0), [0.11, 0.09], &shell);
            ball(mesh, x, 1.92, 0.0, 0.1);
            cone(mesh, at(x, 1.88, 0.0), at(x, 1.46, 0.12), [0.1, 0.07], &shell);
            mesh.rounded(block(x - 0.07..x + 0.07, 1.26..1.48, 0.04..0.2), 0.04, 1, &dark);
            let x = side * 0.18;
            cone(mesh, at(x, 1.45, 0.0), at(x, 0.86, 0.02), [0.15, 0.11], &shell);
            ball(mesh, x, 0.8, 0.02, 0.12);
            cone(mesh, at(x, 0.76, 0.0), at(x, 0.16, -0.02), [0.12, 0.08], &shell);
            mesh.rounded(block(x - 0.11..x + 0.11, 0.0..0.16, -0.14..0.26), 0.05, 2, &dark);
        }
    })
}

/// A trunk on four bent legs, a head with sensors.
pub(super) fn robot_dog(a: &Ask) -> BuiltModel {
    let shell = a.main(Stuff(Finish::Plastic, 0xe0b23a));
    let dark = stuff::DARK_PLASTIC.surface();
    headed(a, |mesh| {
        mesh.rounded(block(-0.24..0.24, 0.85..1.2, -0.8..0.8), 0.1, 2, &shell);
        mesh.rounded(block(-0.18..0.18, 0.9..1.24, 0.76..1.06), 0.08, 2, &dark);
        for x in [-0.09, 0.09] {
            mesh.disc(2, block(x - 0.05..x + 0.05, 1.02..1.12, 1.05..1.08), &of(Finish::Glow, 0x4f9fe0));
        }
        mesh.rounded(block(-0.16..0.16, 1.18..1.26, -0.5..0.4), 0.03, 1, &dark);
        for x in [-0.34, 0.34] {
            for z in [-0.62, 0.62] {
                mesh.disc(0, block(x - 0.1..x + 0.1, 0.86..1.14, z - 0.14..z + 0.14), &dark);
                cone(mesh, at(x, 0.98, z), at(x, 0.5, z - 0.34), [0.1, 0.08], &shell);
                mesh.bead(block(x - 0.09..x + 0.09, 0.41..0.59, z - 0.43..z - 0.25), &dark);
                cone(mesh, at(x, 0.5, z - 0.34), at(x, 0.06, z), [0.06, 0.045], &dark);
                mesh.bead(block(x - 0.07..x + 0.07, 0.0..0.14, z - 0.07..z + 0.07), &stuff::RUBBER.surface());
            }
        }
    })
}

/// Six wheels, a deck with a solar panel, a mast with cameras and an arm.
pub(super) fn rover(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::WHITE);
    let steel = stuff::STEEL.surface();
    headed(a, |mesh| {
        for x in [-0.62, 0.62] {
            for z in [-0.75, 0.0, 0.75] {
                wheel(mesh, [x, 0.2, z], 0.2, 0.1);
                mesh.rod(at(0.85 * x, 0.2, z), at(0.7 * x, 0.62, 0.4 * z), 0.035, &steel);
            }
        }
        mesh.rounded(block(-0.42..0.42, 0.5..0.78, -0.7..0.7), 0.05, 1, &case);
        for panel in block(-0.6..0.6, 0.78..0.83, -0.85..0.35).split(0, 4, 0.02) {
            mesh.crisp(panel, &of(Finish::Glass, 0x1f2f5f));
        }
        mesh.rod(at(0.2, 0.75, 0.55), at(0.2, 1.5, 0.55), 0.04, &steel);
        mesh.rounded(block(-0.02..0.42, 1.46..1.66, 0.45..0.68), 0.04, 1, &case);
        for x in [0.1, 0.3] {
            mesh.disc(2, block(x - 0.06..x + 0.06, 1.5..1.62, 0.67..0.74), &stuff::DARK_PLASTIC.surface());
        }
        mesh.tube(&[at(-0.25, 0.7, 0.7), at(-0.25, 0.9, 0.95), at(-0.25, 0.4, 1.15)], 0.04, &steel);
        mesh.drum(block(-0.33..-0.17, 0.28..0.42, 1.07..1.23), &stuff::BRASS.surface());
        mesh.place(at(-0.3, 1.0, -0.55), [-30.0, 0.0, 0.0], |mesh| {
            mesh.lathe(
                block(-0.22..0.22, 0.0..0.12, -0.22..0.22),
                &[(0.2, 0.0), (1.0, 1.0), (0.9, 1.0), (0.1, 0.2)],
                20,
                &case,
            )
        });
        mesh.rod(at(-0.3, 0.8, -0.55), at(-0.3, 1.02, -0.55), 0.03, &steel);
    })
}

/// A ring as high as the box that one is pushed into, lying on a table; narrower for computed tomography.
pub(super) fn scanner(a: &Ask) -> BuiltModel {
    let shell = a.main(stuff::WHITE);
    let ct = a.says(&["ct"]);
    let glow: Surface = of(Finish::Glow, 0x4f9fe0);
    small(a, |mesh| {
        // The ring is made of blocks around a hole.
        let (deep, far) = if ct { (0.35, -0.75) } else { (0.7, -1.1) };
        let n = 20;
        let point = |k: usize, r: f64| {
            let (sin, cos) = (std::f64::consts::TAU * k as f64 / f64::from(n)).sin_cos();
            (r * cos, 1.0 + r * sin)
        };
        for k in 0..n as usize {
            let outer = |k: usize| {
                let (x, y) = point(k, 1.0);
                let s = 1.0 / (x.abs().max((y - 1.0).abs())).max(0.8);
                (x * s, 1.0 + (y - 1.0) * s)
            };
            let quad = [point(k, 0.42), outer(k), outer(k + 1), point(k + 1, 0.42)];
            mesh.extrude(2, &quad, far..far + 2.0 * deep, &shell);
            let rim = [point(k, 0.42), point(k, 0.47), point(k + 1, 0.47), point(k + 1, 0.42)];
            mesh.extrude(2, &rim, far + 2.0 * deep..far + 2.0 * deep + 0.02, &glow);
        }
        mesh.rounded(block(-0.26..0.26, 0.72..0.8, far + 0.2..1.1), 0.03, 2, &of(Finish::Leather, 0x3f5f7f));
        mesh.rounded(block(-0.3..0.3, 0.64..0.73, far + 0.15..1.12), 0.03, 1, &shell);
        mesh.rounded(block(-0.22..0.22, 0.0..0.66, far + 2.0 * deep + 0.15..0.9), 0.06, 2, &shade(&shell, 0.85));
        mesh.rounded(block(-0.16..0.16, 0.79..0.87, -0.1..0.14), 0.04, 2, &shell);
        mesh.crisp(block(0.56..0.8, 1.2..1.5, far + 2.0 * deep..far + 2.0 * deep + 0.03), &stuff::SCREEN.surface());
    })
}

/// A cart with a screen on an arm, a desk of keys and probes in their holders.
pub(super) fn ultrasound(a: &Ask) -> BuiltModel {
    let shell = a.main(stuff::WHITE);
    let dark = stuff::DARK_PLASTIC.surface();
    small(a, |mesh| {
        for caster in block(-0.5..-0.36, 0.0..0.14, 0.36..0.5).four_corners() {
            mesh.drum(caster, &stuff::RUBBER.surface());
        }
        mesh.rounded(block(-0.45..0.45, 0.12..0.3, -0.5..0.5), 0.06, 2, &shell);
        mesh.rounded(block(-0.3..0.3, 0.28..1.2, -0.45..0.1), 0.08, 2, &shell);
        mesh.place(at(0.0, 1.15, 0.1), [10.0, 0.0, 0.0], |mesh| {
            mesh.rounded(block(-0.5..0.5, 0.0..0.14, -0.4..0.5), 0.05, 2, &shell);
            for k in 0..18 {
                let (x, z) = (-0.36 + 0.13 * f64::from(k % 6), -0.1 + 0.14 * f64::from(k / 6));
                mesh.crisp(block(x..x + 0.08, 0.14..0.165, z..z + 0.08), &dark);
            }
            mesh.bead(block(-0.06..0.06, 0.1..0.2, 0.34..0.46), &dark);
        });
        mesh.rod(at(0.0, 1.2, -0.25), at(0.0, 1.7, -0.25), 0.06, &dark);
        mesh.rounded(block(-0.5..0.5, 1.55..2.3, -0.24..-0.14), 0.03, 1, &dark);
        mesh.crisp(block(-0.45..0.45, 1.62..2.24, -0.15..-0.13), &stuff::SCREEN.surface());
        mesh.extrude(
            2,
            &[(-0.08, 2.16), (0.08, 2.16), (0.32, 1.76), (-0.32, 1.76)],
            -0.13..-0.12,
            &of(Finish::Glow, 0x8f9aa8),
        );
        for (k, z) in [0.0, 0.25].into_iter().enumerate() {
            mesh.rod(at(0.56, 0.98, z), at(0.56, 1.26, z), 0.06, &shade(&shell, 0.85));
            mesh.tube(
                &[at(0.56, 0.98, z), at(0.6, 0.5, z + 0.1), at(0.5, 0.3 + 0.1 * k as f64, 0.1), at(0.3, 0.6, 0.0)],
                0.02,
                &dark,
            );
        }
    })
}

/// A stand with an arm: the tube above, the plate below.
pub(super) fn x_ray(a: &Ask) -> BuiltModel {
    let shell = a.main(stuff::WHITE);
    let steel = stuff::STEEL.surface();
    headed(a, |mesh| {
        mesh.rounded(block(-0.45..0.45, 0.0..0.14, -1.0..0.8), 0.04, 1, &steel);
        mesh.rounded(block(-0.18..0.18, 0.1..2.4, -0.95..-0.65), 0.05, 2, &shell);
        mesh.rounded(block(-0.13..0.13, 1.9..2.1, -0.7..0.3), 0.05, 2, &shell);
        mesh.rounded(block(-0.3..0.3, 1.75..2.25, 0.1..0.6), 0.1, 2, &shell);
        mesh.taper(
            block(-0.2..0.2, 1.5..1.8, 0.18..0.52),
            block(-0.13..0.13, 1.7..1.8, 0.24..0.46),
            &stuff::DARK_PLASTIC.surface(),
        );
        mesh.crisp(block(-0.1..0.1, 1.47..1.51, 0.26..0.44), &of(Finish::Glow, 0xfff2cf));
        mesh.rounded(block(-0.45..0.45, 0.75..0.83, -0.3..0.95), 0.03, 1, &stuff::DARK_PLASTIC.surface());
        mesh.rounded(block(-0.4..0.4, 0.66..0.76, -0.2..0.85), 0.02, 1, &shell);
        mesh.rounded(block(-0.1..0.1, 0.6..0.74, -0.7..0.0), 0.03, 1, &steel);
        for side in [-1.0, 1.0] {
            mesh.tube(
                &[at(side * 0.28, 2.0, 0.35), at(side * 0.48, 2.0, 0.35), at(side * 0.48, 2.0, 0.62)],
                0.03,
                &steel,
            );
        }
        mesh.crisp(block(-0.14..0.14, 2.0..2.15, 0.6..0.62), &stuff::SCREEN.surface());
    })
}
