//! Small things of a household: taps, tubes, torches, bulbs, irons, caddies, knives in their block, strips of sockets.

use super::strokes::{at, blade, cone, headed, long, of, small};
use crate::ask::Ask;
use crate::block::block;
use crate::loft::oval;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::BuiltModel;
use std::f64::consts::TAU;

/// A tap with its spout to the front; a column with handles for beer; the head of a shower.
pub(super) fn tap(a: &Ask) -> BuiltModel {
    let chrome = a.main(stuff::CHROME);
    let dark = stuff::DARK_PLASTIC.surface();
    small(a, |mesh| {
        if a.says(&["head"]) {
            mesh.lathe(
                block(-1.0..1.0, 0.0..0.5, -1.0..1.0),
                &[(1.0, 0.0), (1.0, 0.24), (0.5, 0.7), (0.2, 1.0)],
                24,
                &chrome,
            );
            mesh.tube(&[at(0.0, 0.45, 0.0), at(0.0, 0.8, 0.0), at(0.0, 0.9, -0.3), at(0.0, 0.9, -1.0)], 0.12, &chrome);
            for k in 0..16 {
                let (sin, cos) = (f64::from(k) * 2.4).sin_cos();
                let r = 0.2 * f64::from(k + 1).sqrt();
                mesh.bead(block(-0.04..0.04, -0.03..0.03, -0.04..0.04).moved(r * cos, 0.0, r * sin), &dark);
            }
            return;
        }
        if a.says(&["beer"]) {
            mesh.drum(block(-0.3..0.3, 0.0..0.08, -0.3..0.3), &chrome);
            mesh.drum(block(-0.16..0.16, 0.05..1.0, -0.16..0.16), &chrome);
            cone(mesh, at(-1.0, 1.1, 0.0), at(1.0, 1.1, 0.0), [0.2, 0.2], &chrome);
            for x in [-0.7, 0.0, 0.7] {
                mesh.tube(&[at(x, 1.1, 0.1), at(x, 1.1, 0.42), at(x, 0.84, 0.5)], 0.06, &chrome);
                mesh.sweep(
                    &[
                        (at(x, 1.12, 0.3), 0.04, 0.04),
                        (at(x, 1.4, 0.34), 0.1, 0.06),
                        (at(x, 1.9, 0.36), 0.12, 0.08),
                        (at(x, 1.98, 0.36), 0.04, 0.04),
                    ],
                    at(0.0, 0.0, 1.0),
                    10,
                    &of(Finish::Wood, 0x2f2420),
                );
            }
            return;
        }
        mesh.drum(block(-0.28..0.28, 0.0..0.08, -0.28..0.28), &chrome);
        let spout = [
            at(0.0, 0.04, 0.0),
            at(0.0, 1.2, 0.0),
            at(0.0, 1.55, 0.12),
            at(0.0, 1.66, 0.4),
            at(0.0, 1.55, 0.7),
            at(0.0, 1.2, 0.8),
        ];
        mesh.tube(&spout, 0.12, &chrome);
        cone(mesh, at(0.0, 1.16, 0.8), at(0.0, 1.24, 0.8), [0.15, 0.15], &shade(&chrome, 0.7));
        for (side, color) in [(-1.0, 0xc8392f), (1.0, 0x3f7fb5)] {
            mesh.rod(at(0.0, 0.4, 0.0), at(side * 0.34, 0.4, 0.0), 0.07, &chrome);
            cone(mesh, at(side * 0.3, 0.4, 0.0), at(side * 0.44, 0.4, 0.0), [0.14, 0.14], &chrome);
            mesh.bead(
                block(-0.05..0.05, -0.05..0.05, -0.05..0.05).moved(side * 0.45, 0.4, 0.0),
                &of(Finish::Paint, color),
            );
        }
    })
}

/// A tube that is flat at its end, with a cap.
pub(super) fn tube(a: &Ask) -> BuiltModel {
    let paint = a.says(&["paint"]);
    let foil = a.main(if paint { Stuff(Finish::Metal, 0xc9ccd0) } else { Stuff(Finish::Plastic, 0x3f93b5) });
    long(a, |mesh| {
        let up = at(0.0, 1.0, 0.0);
        mesh.sweep(
            &[
                (at(0.0, 0.0, -1.0), 0.36, 0.02),
                (at(0.0, 0.0, -0.86), 0.35, 0.04),
                (at(0.0, 0.0, 0.4), 0.28, 0.26),
                (at(0.0, 0.0, 0.6), 0.26, 0.26),
                (at(0.0, 0.0, 0.7), 0.12, 0.12),
            ],
            up,
            16,
            &foil,
        );
        mesh.rounded(block(-0.38..0.38, -0.035..0.035, -1.04..-0.9), 0.01, 1, &shade(&foil, 0.7));
        mesh.sweep(
            &[(at(0.0, 0.0, -0.4), 0.335, 0.15), (at(0.0, 0.0, 0.1), 0.31, 0.225)],
            up,
            16,
            &of(Finish::Paint, if paint { 0xc8392f } else { 0xe9e4da }),
        );
        cone(mesh, at(0.0, 0.0, 0.68), at(0.0, 0.0, 1.0), [0.17, 0.15], &stuff::DARK_PLASTIC.surface());
    })
}

/// A barrel with a head that shines.
pub(super) fn flashlight(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::DARK_PLASTIC);
    long(a, |mesh| {
        cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, 0.4), [0.17, 0.17], &case);
        cone(mesh, at(0.0, 0.0, 0.34), at(0.0, 0.0, 0.66), [0.18, 0.31], &case);
        cone(mesh, at(0.0, 0.0, 0.64), at(0.0, 0.0, 1.0), [0.32, 0.32], &case);
        cone(mesh, at(0.0, 0.0, 0.96), at(0.0, 0.0, 1.02), [0.27, 0.27], &of(Finish::Glow, 0xfff2cf));
        for z in [-0.8, -0.6, -0.4, -0.2] {
            cone(mesh, at(0.0, 0.0, z), at(0.0, 0.0, z + 0.08), [0.185, 0.185], &shade(&case, 1.3));
        }
        mesh.rounded(block(-0.07..0.07, 0.14..0.24, 0.06..0.26), 0.03, 1, &stuff::RED.surface());
    })
}

/// A bulb of glass on its screw.
pub(super) fn lightbulb(a: &Ask) -> BuiltModel {
    let glass = a.main(Stuff(Finish::Glow, 0xffe9b8));
    small(a, |mesh| {
        let bulb =
            [(0.4, 0.0), (0.42, 0.06), (0.7, 0.32), (0.95, 0.5), (1.0, 0.66), (0.9, 0.84), (0.55, 0.97), (0.0, 1.0)];
        mesh.lathe(block(-1.0..1.0, 0.9..3.2, -1.0..1.0), &bulb, 24, &glass);
        mesh.drum(block(-0.42..0.42, 0.2..0.95, -0.42..0.42), &stuff::STEEL.surface());
        for y in [0.3, 0.5, 0.7] {
            mesh.torus(block(-0.48..0.48, y - 0.06..y + 0.06, -0.48..0.48), 0.3, &stuff::CHROME.surface());
        }
        mesh.lathe(
            block(-0.3..0.3, 0.0..0.22, -0.3..0.3),
            &[(0.4, 0.0), (1.0, 1.0)],
            16,
            &stuff::DARK_PLASTIC.surface(),
        );
    })
}

/// A pointed sole under a case with a handle.
pub(super) fn iron(a: &Ask) -> BuiltModel {
    let case = a.main(Stuff(Finish::Plastic, 0x3f7fb5));
    headed(a, |mesh| {
        // The middle of the point is in front: half of an oval, square behind.
        let ring = |y: f64, wide: f64, tip: f64, back: f64| {
            let mut ring = oval(y, [0.0; 2], [wide, tip], 1.25);
            ring.iter_mut().filter(|p| p.z < 0.0).for_each(|p| {
                p.x = p.x.signum() * wide * (p.x.abs() / wide).powf(0.3);
                p.z *= back / tip;
            });
            ring
        };
        mesh.loft(&[ring(0.0, 0.46, 1.0, 0.9), ring(0.1, 0.47, 1.02, 0.9)], &stuff::STEEL.surface());
        mesh.loft(&[ring(0.1, 0.45, 0.98, 0.88), ring(0.34, 0.4, 0.84, 0.84), ring(0.46, 0.26, 0.5, 0.76)], &case);
        let grip =
            [at(0.0, 0.4, 0.4), at(0.0, 0.78, 0.34), at(0.0, 0.92, 0.0), at(0.0, 0.9, -0.5), at(0.0, 0.4, -0.72)];
        mesh.tube(&grip, 0.13, &shade(&case, 0.6));
        mesh.drum(block(-0.12..0.12, 0.44..0.54, 0.0..0.24), &stuff::DARK_PLASTIC.surface());
        mesh.tube(&[at(0.0, 0.8, -0.6), at(0.0, 0.9, -0.86), at(0.1, 0.6, -1.0)], 0.04, &stuff::DARK_PLASTIC.surface());
    })
}

/// An open box with compartments, a handle over it, and what is kept in it.
pub(super) fn caddy(a: &Ask) -> BuiltModel {
    let hung = a.says(&["shower"]);
    let main = a.main(if hung { stuff::CHROME } else { stuff::OAK });
    small(a, |mesh| {
        if hung {
            mesh.tube(
                &[at(-0.3, 0.3, -0.9), at(-0.3, 1.9, -0.9), at(0.0, 2.1, -0.9), at(0.3, 1.9, -0.9), at(0.3, 0.3, -0.9)],
                0.05,
                &main,
            );
        }
        let tiers: &[f64] = if hung { &[0.0, 0.95] } else { &[0.0] };
        for low in tiers {
            let high = if hung { 0.34 } else { 0.7 };
            mesh.crisp(block(-0.96..0.96, *low..low + 0.06, -0.96..0.96), &main);
            for side in block(-1.0..-0.94, *low..low + high, -0.99..0.99).both_sides() {
                mesh.crisp(side, &main);
            }
            for z in [-1.0..-0.92, 0.92..1.0] {
                mesh.crisp(block(-0.95..0.95, *low..low + high, z), &main);
            }
            for (k, x) in [-0.66, -0.2, 0.3, 0.7].into_iter().enumerate() {
                let color = [0x3f93b5, 0xe3bd3a, 0x7fa860, 0xc85f7a][k];
                let top = low + high + [0.5, 0.3, 0.42, 0.24][k] * if hung { 0.9 } else { 1.0 };
                mesh.lathe(
                    block(x - 0.16..x + 0.16, low + 0.06..top, -0.6..0.6),
                    &[(0.9, 0.0), (1.0, 0.1), (1.0, 0.7), (0.4, 0.85), (0.4, 1.0)],
                    12,
                    &of(Finish::Plastic, color),
                );
            }
        }
        if !hung {
            mesh.crisp(block(-0.96..0.96, 0.03..0.66, -0.03..0.03), &main);
            for side in block(-1.0..-0.92, 0.6..1.3, -0.2..0.2).both_sides() {
                mesh.crisp(side, &main);
            }
            mesh.rod(at(-0.98, 1.25, 0.0), at(0.98, 1.25, 0.0), 0.07, &main);
        }
    })
}

/// A block that leans back, with handles of knives; a pot with spoons and turners.
pub(super) fn knife_block(a: &Ask) -> BuiltModel {
    let wood = a.main(Stuff(Finish::Wood, 0x9c6a3c));
    let (dark, steel) = (stuff::DARK_PLASTIC.surface(), stuff::STEEL.surface());
    small(a, |mesh| {
        if a.says(&["spatula", "utensil", "cutlery"]) {
            let pot = a.main(Stuff(Finish::Ceramic, 0x6f8fa0));
            mesh.lathe(
                block(-1.0..1.0, 0.0..2.0, -1.0..1.0),
                &[(0.86, 0.0), (0.96, 0.04), (1.0, 1.0), (0.9, 1.0), (0.86, 0.3)],
                24,
                &pot,
            );
            for k in 0..5 {
                let (sin, cos) = (TAU * f64::from(k) / 5.0).sin_cos();
                let (foot, top) = (at(-0.3 * cos, 0.7, -0.3 * sin), at(0.8 * cos, 3.4, 0.8 * sin));
                mesh.rod(foot, top, 0.09, &stuff::OAK.surface());
                let way = (top - foot).normalize();
                let head = [(top, 0.1, 0.06), (top + way * 0.3, 0.34, 0.06), (top + way * 0.9, 0.3, 0.06)];
                mesh.sweep(&head, at(sin, 0.0, -cos), 10, if k % 2 == 0 { &steel } else { &wood });
            }
            return;
        }
        mesh.extrude(0, &[(0.0, -0.8), (0.0, 0.7), (0.6, 0.9), (1.6, -0.1), (1.0, -0.9)], -0.6..0.6, &wood);
        for (row, t) in [(0, 0.2), (1, 0.6)] {
            for x in [-0.36, 0.0, 0.36] {
                let from = at(x, 0.6 + t, 0.9 - t);
                let way = at(0.0, 0.7, 0.7);
                mesh.sweep(
                    &[(from - way * 0.2, 0.08, 0.14), (from + way * (0.62 + 0.1 * f64::from(row)), 0.09, 0.15)],
                    at(1.0, 0.0, 0.0).cross(&way),
                    10,
                    &dark,
                );
                mesh.sweep(
                    &[(from, 0.11, 0.17), (from + way * 0.06, 0.11, 0.17)],
                    at(1.0, 0.0, 0.0).cross(&way),
                    10,
                    &steel,
                );
            }
        }
    })
}

/// A strip with sockets and a switch.
pub(super) fn power_strip(a: &Ask) -> BuiltModel {
    let white = a.main(Stuff(Finish::Plastic, 0xc9ccce));
    let dark = stuff::DARK_PLASTIC.surface();
    long(a, |mesh| {
        mesh.rounded(block(-0.16..0.16, 0.0..0.22, -0.9..0.85), 0.05, 2, &white);
        for place in block(-0.12..0.12, 0.21..0.235, -0.82..0.42).split(2, 5, 0.03) {
            mesh.drum(place, &shade(&white, 0.6));
            for x in [-0.05, 0.05] {
                mesh.bead(block(-0.02..0.02, 0.22..0.25, -0.02..0.02).moved(x, 0.0, place.center().z), &dark);
            }
        }
        mesh.rounded(block(-0.06..0.06, 0.2..0.27, 0.54..0.72), 0.02, 1, &stuff::RED.surface());
        mesh.tube(&[at(0.0, 0.1, 0.84), at(0.0, 0.06, 0.94), at(0.0, 0.05, 1.1)], 0.05, &dark);
    })
}

/// The shade of a lamp, open above and below.
pub(super) fn lampshade(a: &Ask) -> BuiltModel {
    let cloth = a.main(Stuff(Finish::Fabric, 0xd9c39a));
    small(a, |mesh| {
        mesh.lathe(
            block(-1.0..1.0, 0.0..1.4, -1.0..1.0),
            &[(0.93, 0.12), (0.96, 0.0), (1.0, 0.0), (0.62, 1.0), (0.58, 1.0), (0.6, 0.88)],
            24,
            &cloth,
        );
        for (y, r) in [(0.03, 1.0), (1.36, 0.63)] {
            mesh.torus(block(-r..r, y - 0.03..y + 0.03, -r..r), 0.06, &shade(&cloth, 0.7));
        }
        mesh.rod(at(-0.58, 1.3, 0.0), at(0.58, 1.3, 0.0), 0.02, &stuff::BRASS.surface());
        mesh.drum(block(-0.1..0.1, 1.2..1.44, -0.1..0.1), &stuff::BRASS.surface());
    })
}

/// A palette with a hole for the thumb and dabs of paint.
pub(super) fn palette(a: &Ask) -> BuiltModel {
    let wood = a.main(Stuff(Finish::Wood, 0xb9803f));
    let colors = [0xc8392f, 0xe8822a, 0xe3bd3a, 0x6da544, 0x3f7fb5, 0x7a5aa0];
    long(a, |mesh| {
        blade(mesh, at(0.0, 0.0, 0.0), [1.3, 2.0], 0.06, &wood);
        blade(mesh, at(0.3, 0.0, -0.62), [0.26, 0.36], 0.064, &stuff::DARK_PLASTIC.surface());
        for (k, color) in colors.into_iter().enumerate() {
            let (sin, cos) = (-0.9 + 0.55 * k as f64).sin_cos();
            mesh.bead(
                block(-0.13..0.13, 0.01..0.1, -0.14..0.14).moved(-0.42 * cos, 0.0, 0.72 * sin),
                &of(Finish::Paint, color),
            );
        }
        mesh.sweep(
            &[(at(0.1, 0.08, -0.5), 0.03, 0.03), (at(-0.05, 0.08, 0.8), 0.04, 0.03)],
            at(0.0, 1.0, 0.0),
            8,
            &of(Finish::Wood, 0x5a3a24),
        );
    })
}
