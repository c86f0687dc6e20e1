//! Machines to train with, and tables to play at: weights on cables, presses, steppers, table football, air hockey,
//! roulette, pinball.

use super::strokes::{at, cone, headed, of, small};
use crate::ask::Ask;
use crate::block::{Block, block};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use std::f64::consts::TAU;

const VINYL: Stuff = Stuff(Finish::Leather, 0x26282b);

/// A stack of plates in a frame, cables over wheels to a bar, and a seat below it.
pub(super) fn cable_machine(a: &Ask) -> BuiltModel {
    let frame = a.main(Stuff(Finish::Paint, 0xc9ccd0));
    let (dark, vinyl, steel) = (stuff::BLACK_STEEL.surface(), VINYL.surface(), stuff::CHROME.surface());
    headed(a, |mesh| {
        for x in [-0.4, 0.4] {
            mesh.rounded(block(x - 0.06..x + 0.06, 0.0..2.3, -1.0..-0.88), 0.02, 1, &frame);
            mesh.rounded(block(x - 0.06..x + 0.06, 0.0..0.1, -1.0..0.9), 0.02, 1, &frame);
        }
        mesh.rounded(block(-0.45..0.45, 2.2..2.34, -0.99..-0.87), 0.02, 1, &frame);
        mesh.rounded(block(-0.06..0.06, 2.22..2.34, -0.9..0.3), 0.02, 1, &frame);
        mesh.rounded(block(-0.44..0.44, 0.005..0.095, 0.8..0.92), 0.02, 1, &frame);
        for plate in block(-0.26..0.26, 0.14..1.2, -0.98..-0.8).split(1, 11, 0.015) {
            mesh.crisp(plate, &dark);
        }
        for x in [-0.18, 0.18] {
            mesh.rod(at(x, 0.1, -0.89), at(x, 2.2, -0.89), 0.02, &steel);
        }
        for z in [-0.7, 0.25] {
            mesh.disc(0, block(-0.03..0.03, 2.05..2.25, z - 0.1..z + 0.1), &dark);
        }
        mesh.rod(at(0.0, 1.2, -0.78), at(0.0, 2.15, -0.78), 0.012, &dark);
        mesh.rod(at(0.0, 2.1, 0.34), at(0.0, 1.8, 0.36), 0.012, &dark);
        mesh.tube(&[at(-0.6, 1.66, 0.36), at(-0.4, 1.8, 0.36), at(0.4, 1.8, 0.36), at(0.6, 1.66, 0.36)], 0.025, &steel);
        mesh.rounded(block(-0.24..0.24, 0.5..0.62, 0.1..0.62), 0.05, 2, &vinyl);
        mesh.rounded(block(-0.05..0.05, 0.05..0.52, 0.3..0.42), 0.02, 1, &frame);
        mesh.rounded(block(-0.05..0.05, 0.02..0.1, -0.9..0.9), 0.02, 1, &frame);
        for side in [-1.0, 1.0] {
            cone(mesh, at(side * 0.04, 0.78, 0.16), at(side * 0.26, 0.78, 0.16), [0.08, 0.08], &vinyl);
        }
        mesh.rod(at(0.0, 0.3, 0.25), at(0.0, 0.78, 0.16), 0.03, &frame);
    })
}

/// A seat that leans back, and a plate for the feet on a sledge with weights.
pub(super) fn leg_press(a: &Ask) -> BuiltModel {
    let frame = a.main(Stuff(Finish::Paint, 0xc9ccd0));
    let (dark, vinyl) = (stuff::BLACK_STEEL.surface(), VINYL.surface());
    headed(a, |mesh| {
        for x in [-0.45, 0.45] {
            mesh.rounded(block(x - 0.05..x + 0.05, 0.0..0.1, -1.0..1.0), 0.02, 1, &frame);
            mesh.rod(at(x, 0.08, -0.5), at(x, 1.3, 0.95), 0.045, &frame);
            mesh.rod(at(x, 0.05, 0.95), at(x, 1.3, 0.95), 0.045, &frame);
            mesh.rod(at(0.9 * x, 0.5, -0.35), at(1.2 * x, 0.5, -0.35), 0.025, &dark);
        }
        for z in [-0.98, 0.95] {
            mesh.rod(at(-0.45, 0.05, z), at(0.45, 0.05, z), 0.05, &frame);
        }
        mesh.place(at(0.0, 0.32, -0.45), [10.0, 0.0, 0.0], |mesh| {
            mesh.rounded(block(-0.28..0.28, 0.0..0.12, -0.1..0.4), 0.05, 2, &vinyl)
        });
        mesh.place(at(0.0, 0.36, -0.5), [-48.0, 0.0, 0.0], |mesh| {
            mesh.rounded(block(-0.28..0.28, 0.0..0.85, -0.12..0.0), 0.05, 2, &vinyl);
            mesh.rounded(block(-0.15..0.15, 0.86..1.05, -0.1..0.02), 0.05, 2, &vinyl);
        });
        mesh.place(at(0.0, 0.95, 0.55), [-40.0, 0.0, 0.0], |mesh| {
            mesh.rounded(block(-0.36..0.36, -0.3..0.3, -0.05..0.0), 0.02, 1, &stuff::STEEL.surface());
            for x in [-0.6, 0.6] {
                mesh.disc(0, block(x - 0.1..x + 0.1, -0.24..0.24, 0.02..0.5), &dark);
            }
            mesh.rod(at(-0.75, 0.0, 0.26), at(0.75, 0.0, 0.26), 0.03, &stuff::CHROME.surface());
        });
        mesh.rod(at(0.0, 0.1, -0.8), at(0.0, 0.6, -0.75), 0.05, &frame);
    })
}

/// Two pedals on arms before a console on a mast, with rails to hold.
pub(super) fn stepper(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::DARK_PLASTIC);
    let steel = stuff::STEEL.surface();
    headed(a, |mesh| {
        mesh.rounded(block(-0.4..0.4, 0.0..0.12, -0.9..0.9), 0.03, 1, &steel);
        mesh.rounded(block(-0.26..0.26, 0.1..0.9, 0.3..0.9), 0.12, 2, &case);
        mesh.rod(at(0.0, 0.8, 0.6), at(0.0, 1.9, 0.75), 0.06, &steel);
        mesh.place(at(0.0, 1.85, 0.72), [-20.0, 0.0, 0.0], |mesh| {
            mesh.rounded(block(-0.3..0.3, 0.0..0.4, -0.06..0.06), 0.03, 1, &case);
            mesh.crisp(block(-0.22..0.22, 0.08..0.32, -0.07..-0.05), &stuff::SCREEN.surface());
        });
        for (side, high) in [(-1.0, 0.45), (1.0, 0.75)] {
            let x = side * 0.2;
            mesh.rod(at(x, 0.5, 0.35), at(x, high - 0.04, -0.55), 0.04, &steel);
            mesh.rounded(block(x - 0.14..x + 0.14, high - 0.05..high + 0.03, -0.75..-0.25), 0.03, 1, &case);
            mesh.tube(
                &[at(x, 1.6, 0.68), at(side * 0.42, 1.5, 0.3), at(side * 0.42, 1.45, -0.4), at(side * 0.42, 1.2, -0.5)],
                0.03,
                &of(Finish::Rubber, 0x2a2b2d),
            );
        }
    })
}

/// A table whose long side is along x in a wide box, along z in a deep one; drawn along z.
fn long_table(a: &Ask, draw: impl FnOnce(&mut Mesh)) -> BuiltModel {
    headed(a, draw)
}

/// The body of a table to play at: a case on four legs, its field sunk.
fn case(mesh: &mut Mesh, wood: &Surface, field: &Surface) {
    for leg in block(-0.58..-0.44, 0.0..0.72, 0.8..0.98).four_corners() {
        mesh.taper(leg, leg.inset(0.0, 0.0, 0.0), wood);
    }
    mesh.crisp(block(-0.6..0.6, 0.6..0.82, -1.1..1.1), wood);
    mesh.crisp(block(-0.52..0.52, 0.8..0.83, -1.0..1.0), field);
    for side in block(-0.62..-0.52, 0.58..0.98, -1.12..1.12).both_sides() {
        mesh.crisp(side, wood);
    }
    for z in [-1.11..-1.0, 1.0..1.11] {
        mesh.crisp(block(-0.53..0.53, 0.585..0.975, z), wood);
    }
}

/// Rods with figures over a green field.
pub(super) fn foosball(a: &Ask) -> BuiltModel {
    let wood = a.main(stuff::WALNUT);
    let steel = stuff::CHROME.surface();
    long_table(a, |mesh| {
        case(mesh, &wood, &of(Finish::Carpet, 0x3f8a4c));
        mesh.crisp(block(-0.5..0.5, 0.825..0.834, -0.01..0.01), &stuff::WHITE.surface());
        for (k, count) in [1, 2, 3, 5, 5, 3, 2, 1].into_iter().enumerate() {
            let z = -0.84 + 0.24 * k as f64;
            let red = matches!(k, 0 | 1 | 3 | 5);
            let s = of(Finish::Plastic, if red { 0xc8392f } else { 0x2f5fa8 });
            mesh.sweep(
                &[(at(-0.78, 1.0, z), 0.014, 0.014), (at(0.78, 1.0, z), 0.014, 0.014)],
                at(0.0, 1.0, 0.0),
                6,
                &steel,
            );
            let end = if red { 0.78 } else { -0.78 };
            mesh.sweep(
                &[(at(end, 1.0, z), 0.03, 0.03), (at(1.16 * end, 1.0, z), 0.03, 0.03)],
                at(0.0, 1.0, 0.0),
                8,
                &stuff::DARK_PLASTIC.surface(),
            );
            for i in 0..count {
                let x = 0.9 * ((f64::from(i) + 0.5) / f64::from(count) - 0.5);
                mesh.taper(
                    block(x - 0.025..x + 0.025, 0.85..1.06, z - 0.03..z + 0.03),
                    block(x - 0.04..x + 0.04, 1.05..1.06, z - 0.025..z + 0.025),
                    &s,
                );
                mesh.crisp(block(x - 0.02..x + 0.02, 1.06..1.12, z - 0.02..z + 0.02), &s);
            }
        }
        mesh.bead(block(0.1..0.15, 0.83..0.88, 0.0..0.05), &stuff::WHITE.surface());
    })
}

/// A white field with holes and lines, two mallets and a puck.
pub(super) fn air_hockey(a: &Ask) -> BuiltModel {
    let wood = a.main(Stuff(Finish::Plastic, 0x2f5fa8));
    let red = stuff::RED.surface();
    long_table(a, |mesh| {
        case(mesh, &wood, &stuff::WHITE.surface());
        mesh.crisp(block(-0.52..0.52, 0.826..0.834, -0.015..0.015), &red);
        mesh.torus(block(-0.2..0.2, 0.82..0.84, -0.2..0.2), 0.1, &red);
        for z in [-1.0, 1.0] {
            mesh.crisp(block(-0.18..0.18, 0.83..0.93, z - 0.02..z + 0.02), &stuff::DARK_PLASTIC.surface());
            let c = 0.6 * z;
            mesh.drum(block(-0.09..0.09, 0.83..0.87, c - 0.09..c + 0.09), &red);
            mesh.drum(block(-0.04..0.04, 0.86..0.96, c - 0.04..c + 0.04), &red);
        }
        mesh.drum(block(0.1..0.22, 0.83..0.85, 0.2..0.32), &of(Finish::Plastic, 0x1d1d20));
        for k in 0..60 {
            let (x, z) = (-0.42 + 0.21 * f64::from(k % 5), -0.9 + 0.16 * f64::from(k / 5));
            mesh.crisp(block(x - 0.008..x + 0.008, 0.826..0.833, z - 0.008..z + 0.008), &stuff::GRAY_PLASTIC.surface());
        }
    })
}

/// A wheel in one end of a table of green cloth with fields; dice and chips where it is for craps.
pub(super) fn roulette_table(a: &Ask) -> BuiltModel {
    let wood = a.main(stuff::WALNUT);
    let craps = a.says(&["crap"]);
    let white = stuff::WHITE.surface();
    long_table(a, |mesh| {
        case(mesh, &wood, &of(Finish::Carpet, 0x1f6f4a));
        let (first, last) = if craps { (-0.9, 0.9) } else { (-0.3, 0.9) };
        for k in 0..=8 {
            let z = first + (last - first) * f64::from(k) / 8.0;
            mesh.crisp(block(-0.36..0.36, 0.826..0.834, z - 0.008..z + 0.008), &white);
            for j in 0..3 {
                let x = -0.24 + 0.24 * f64::from(j);
                let color = if (k + j) % 2 == 0 { 0xb8322c } else { 0x1d1d20 };
                if k < 8 && !craps {
                    disc(
                        mesh,
                        block(x - 0.05..x + 0.05, 0.825..0.836, z + 0.03..z + 0.12),
                        8,
                        &of(Finish::Paint, color),
                    );
                }
            }
        }
        for x in [-0.36, -0.12, 0.12, 0.36] {
            mesh.crisp(block(x - 0.008..x + 0.008, 0.826..0.8335, first..last), &white);
        }
        for (k, color) in [0xc8392f, 0x2f6fa8, 0xe3bd3a, 0x3f8a4c].into_iter().enumerate() {
            let x = -0.44 + 0.03 * k as f64;
            disc(
                mesh,
                block(x..x + 0.08, 0.83..0.86 + 0.03 * k as f64, 0.5 - 0.12 * k as f64..0.58 - 0.12 * k as f64),
                12,
                &of(Finish::Plastic, color),
            );
        }
        if craps {
            for (x, z) in [(0.1, -0.4), (0.26, -0.3)] {
                mesh.rounded(block(x..x + 0.1, 0.83..0.93, z..z + 0.1), 0.02, 1, &stuff::RED.surface());
                mesh.crisp(block(x + 0.035..x + 0.065, 0.925..0.934, z + 0.035..z + 0.065), &white);
            }
        } else {
            wheel(mesh, &wood);
        }
    })
}

/// A flat disc of few sides, for many of them.
fn disc(mesh: &mut Mesh, b: Block, sides: usize, s: &Surface) {
    mesh.lathe(b, &[(1.0, 0.0), (1.0, 1.0)], sides, s);
}

/// The bowl of a roulette with pockets and a spindle.
fn wheel(mesh: &mut Mesh, wood: &Surface) {
    let z = -0.66;
    mesh.lathe(
        block(-0.34..0.34, 0.82..1.0, z - 0.34..z + 0.34),
        &[(0.9, 0.0), (1.0, 0.8), (0.94, 1.0), (0.8, 0.5), (0.4, 0.4)],
        24,
        wood,
    );
    for k in 0..14 {
        let (sin, cos) = (TAU * f64::from(k) / 14.0).sin_cos();
        let color = if k == 0 {
            0x1f8f4a
        } else if k % 2 == 0 {
            0xb8322c
        } else {
            0x1d1d20
        };
        mesh.rod(
            at(0.16 * cos, 0.91, z + 0.16 * sin),
            at(0.24 * cos, 0.93, z + 0.24 * sin),
            0.03,
            &of(Finish::Paint, color),
        );
    }
    cone(mesh, at(0.0, 0.88, z), at(0.0, 1.06, z), [0.08, 0.02], &stuff::BRASS.surface());
}

/// A sloping field under glass on legs, and a head that shines behind it.
pub(super) fn pinball(a: &Ask) -> BuiltModel {
    let case = a.main(Stuff(Finish::Paint, 0x6f2f8f));
    let steel = stuff::CHROME.surface();
    small(a, |mesh| {
        for (x, z, top) in [(-0.5, 0.9, 0.7), (0.5, 0.9, 0.7), (-0.5, -0.8, 0.85), (0.5, -0.8, 0.85)] {
            mesh.crisp(block(x - 0.05..x + 0.05, 0.0..top, z - 0.05..z + 0.05), &steel);
        }
        let side = [(0.62, 1.0), (0.92, 1.0), (1.12, -0.9), (0.72, -0.9)];
        mesh.extrude(0, &side, -0.55..0.55, &case);
        mesh.place(at(0.0, 0.925, 1.0), [6.0, 0.0, 0.0], |mesh| {
            mesh.crisp(block(-0.48..0.48, 0.0..0.02, -1.7..-0.06), &of(Finish::Paint, 0x1f3f6f));
            for (x, z, color) in [(-0.2, -1.2, 0xc8392f), (0.2, -1.2, 0xe3bd3a), (0.0, -0.9, 0x3f8a4c)] {
                mesh.drum(block(x - 0.1..x + 0.1, 0.02..0.12, z - 0.1..z + 0.1), &of(Finish::Glow, color));
            }
            for x in [-0.15, 0.15] {
                mesh.place(at(x, 0.05, -0.25), [0.0, x.signum() * 25.0, 0.0], |mesh| {
                    mesh.rounded(block(-0.13..0.13, -0.03..0.03, -0.03..0.03), 0.02, 1, &stuff::WHITE.surface())
                });
            }
            mesh.bead(block(0.3..0.38, 0.02..0.1, -0.6..-0.52), &steel);
        });
        mesh.rounded(block(-0.6..0.6, 1.05..2.0, -1.15..-0.8), 0.04, 1, &case);
        mesh.crisp(block(-0.52..0.52, 1.25..1.94, -0.81..-0.78), &of(Finish::Glow, 0xf0a030));
        for (x, y, r, color) in [(-0.2, 1.6, 0.2, 0xc8392f), (0.22, 1.66, 0.15, 0x2f6fa8)] {
            mesh.disc(2, block(x - r..x + r, y - r..y + r, -0.79..-0.76), &of(Finish::Glow, color));
        }
        mesh.crisp(block(-0.3..0.3, 1.1..1.2, -0.81..-0.77), &stuff::SCREEN.surface());
        mesh.rod(at(0.4, 0.78, 1.0), at(0.4, 0.78, 1.12), 0.04, &steel);
        mesh.rounded(block(-0.3..0.1, 0.68..0.84, 0.99..1.02), 0.01, 1, &shade(&case, 0.6));
    })
}
