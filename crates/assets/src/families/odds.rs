//! Odds and ends: cages, boards to cut on, chess pieces, graters, cards, bars on a wall, frames to climb, boards of scores,
//! panels for the sun.

use super::strokes::{at, blade, cone, headed, of, round, small};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use std::f64::consts::TAU;

/// Bars under a dome with a perch; a low box of bars with a wheel for a hamster.
pub(super) fn cage(a: &Ask) -> BuiltModel {
    let brass = a.main(stuff::BRASS);
    let bar = |mesh: &mut Mesh, from, to| {
        mesh.sweep(&[(from, 0.014, 0.014), (to, 0.014, 0.014)], at(0.3, 0.9, 0.2), 6, &brass)
    };
    small(a, |mesh| {
        if a.says(&["hamster", "rabbit", "pet"]) {
            mesh.rounded(block(-1.0..1.0, 0.0..0.3, -0.6..0.6), 0.06, 2, &of(Finish::Plastic, 0x2f6fa8));
            mesh.crisp(block(-0.94..0.94, 0.28..0.32, -0.54..0.54), &of(Finish::Soil, 0xd9b878));
            for k in 0..=16 {
                let x = -0.96 + 0.12 * f64::from(k);
                for z in [-0.56, 0.56] {
                    bar(mesh, at(x, 0.28, z), at(x, 1.2, z));
                }
                bar(mesh, at(x, 1.2, -0.56), at(x, 1.2, 0.56));
            }
            for x in [-0.96, 0.96] {
                for k in 0..=9 {
                    let z = -0.54 + 0.12 * f64::from(k);
                    bar(mesh, at(x, 0.28, z), at(x, 1.2, z));
                }
            }
            mesh.place(at(0.4, 0.7, -0.2), [90.0, 0.0, 0.0], |mesh| {
                mesh.torus(block(-0.34..0.34, -0.1..0.1, -0.34..0.34), 0.12, &stuff::RED.surface())
            });
            return;
        }
        mesh.drum(block(-0.9..0.9, 0.0..0.14, -0.9..0.9), &brass);
        for k in 0..20 {
            let (sin, cos) = (TAU * f64::from(k) / 20.0).sin_cos();
            bar(mesh, at(0.86 * cos, 0.1, 0.86 * sin), at(0.86 * cos, 1.7, 0.86 * sin));
            bar(mesh, at(0.86 * cos, 1.7, 0.86 * sin), at(0.55 * cos, 2.2, 0.55 * sin));
            bar(mesh, at(0.55 * cos, 2.2, 0.55 * sin), at(0.0, 2.45, 0.0));
        }
        for y in [0.9, 1.66] {
            mesh.torus(block(-0.89..0.89, y..y + 0.05, -0.89..0.89), 0.05, &brass);
        }
        cone(mesh, at(-0.84, 0.8, 0.0), at(0.84, 0.8, 0.0), [0.05, 0.05], &stuff::OAK.surface());
        mesh.ball(block(-0.16..0.16, 0.84..1.2, -0.24..0.2), &of(Finish::Fabric, 0xe3bd3a));
        mesh.bead(block(-0.12..0.12, 1.12..1.38, 0.02..0.26), &of(Finish::Fabric, 0xe3bd3a));
        cone(mesh, at(0.0, 1.24, 0.24), at(0.0, 1.22, 0.36), [0.05, 0.01], &of(Finish::Plastic, 0xe08a2a));
        mesh.place(at(0.0, 2.58, 0.0), [90.0, 0.0, 0.0], |mesh| {
            mesh.torus(block(-0.14..0.14, -0.03..0.03, -0.14..0.14), 0.2, &brass)
        });
    })
}

/// A slab of wood with a groove and a grip; with a loaf and a knife where bread is cut.
pub(super) fn cutting_board(a: &Ask) -> BuiltModel {
    let wood = a.main(Stuff(Finish::Wood, 0xb98a55));
    super::strokes::long(a, |mesh| {
        mesh.rounded(block(-0.6..0.6, -0.06..0.06, -0.7..1.0), 0.04, 2, &wood);
        mesh.rounded(block(-0.16..0.16, -0.058..0.058, -1.1..-0.66), 0.05, 2, &wood);
        mesh.torus(block(-0.09..0.09, -0.07..0.07, -1.04..-0.86), 0.4, &shade(&wood, 0.6));
        let dark = shade(&wood, 0.7);
        for x in block(-0.54..-0.5, 0.055..0.064, -0.575..0.875).both_sides() {
            mesh.crisp(x, &dark);
        }
        for z in [-0.62..-0.58, 0.88..0.92] {
            mesh.crisp(block(-0.54..0.54, 0.054..0.063, z), &dark);
        }
    })
}

/// A turned foot and body; a king with his cross.
pub(super) fn chess_piece(a: &Ask) -> BuiltModel {
    let wood = a.main(stuff::BIRCH);
    small(a, |mesh| {
        let king = [
            (1.0, 0.0),
            (1.0, 0.08),
            (0.8, 0.14),
            (0.5, 0.2),
            (0.36, 0.34),
            (0.3, 0.62),
            (0.62, 0.66),
            (0.62, 0.7),
            (0.36, 0.74),
            (0.56, 0.92),
            (0.4, 0.98),
            (0.0, 1.0),
        ];
        mesh.lathe(block(-0.5..0.5, 0.0..2.2, -0.5..0.5), &king, 24, &wood);
        mesh.crisp(block(-0.05..0.05, 2.18..2.5, -0.04..0.04), &wood);
        mesh.crisp(block(-0.14..0.14, 2.3..2.4, -0.039..0.039), &wood);
    })
}

/// Four sides with holes that have an edge, under a handle; a bowl with holes for a colander.
pub(super) fn grater(a: &Ask) -> BuiltModel {
    let steel = a.main(stuff::CHROME);
    let dark = stuff::DARK_PLASTIC.surface();
    if a.says(&["colander", "sieve", "strainer"]) {
        return small(a, |mesh| {
            mesh.drum(block(-0.4..0.4, 0.0..0.1, -0.4..0.4), &steel);
            let bowl = [(0.4, 0.0), (0.8, 0.35), (0.98, 1.0), (0.9, 1.0), (0.72, 0.4), (0.3, 0.1)];
            mesh.lathe(block(-1.0..1.0, 0.06..0.9, -1.0..1.0), &bowl, 24, &steel);
            mesh.torus(block(-1.02..1.02, 0.86..0.94, -1.02..1.02), 0.06, &steel);
            for row in 0..3 {
                for k in 0..20 {
                    let (sin, cos) = (TAU * (f64::from(k) + 0.5 * f64::from(row % 2)) / 20.0).sin_cos();
                    let (r, y) = [(0.76, 0.32), (0.85, 0.5), (0.91, 0.68)][row as usize];
                    mesh.crisp(block(-0.035..0.035, -0.035..0.035, -0.035..0.035).moved(r * cos, y, r * sin), &dark);
                }
            }
            for x in [-1.0, 1.0] {
                mesh.tube(
                    &[at(x, 0.88, -0.25), at(1.2 * x, 0.88, -0.15), at(1.2 * x, 0.88, 0.15), at(x, 0.88, 0.25)],
                    0.05,
                    &steel,
                );
            }
        });
    }
    small(a, |mesh| {
        mesh.taper(block(-0.6..0.6, 0.0..2.0, -0.45..0.45), block(-0.4..0.4, 1.9..2.0, -0.28..0.28), &steel);
        for row in 0..7 {
            for k in 0..5 {
                let (x, y) = (-0.36 + 0.18 * f64::from(k) + 0.06 * f64::from(row % 2), 0.25 + 0.22 * f64::from(row));
                let z = 0.45 - 0.085 * y;
                mesh.extrude(
                    2,
                    &[(0.9 * x - 0.05, y), (0.9 * x + 0.05, y), (0.9 * x, y + 0.1)],
                    z - 0.02..z + 0.03,
                    &dark,
                );
            }
        }
        mesh.tube(&[at(-0.36, 1.98, 0.0), at(-0.3, 2.4, 0.0), at(0.3, 2.4, 0.0), at(0.36, 1.98, 0.0)], 0.06, &dark);
    })
}

/// A card on a pack of cards.
pub(super) fn playing_card(a: &Ask) -> BuiltModel {
    let white = a.main(stuff::PAPER);
    let red = stuff::RED.surface();
    super::strokes::long(a, |mesh| {
        mesh.rounded(block(-0.66..0.66, -0.3..0.1, -0.95..0.95), 0.03, 1, &shade(&white, 0.9));
        mesh.crisp(block(-0.64..0.64, 0.11..0.14, -0.93..0.93), &white);
        let heart = |mesh: &mut Mesh, x: f64, z: f64, r: f64| {
            for side in [-1.0, 1.0] {
                blade(mesh, at(x + 0.5 * r * side, 0.145, z + 0.3 * r), [1.2 * r, 1.2 * r], 0.03, &red);
            }
            mesh.extrude(
                1,
                &[(z + 0.2 * r, x - 1.05 * r), (z + 0.2 * r, x + 1.05 * r), (z - 1.2 * r, x)],
                0.13..0.158,
                &red,
            );
        };
        heart(mesh, 0.0, 0.05, 0.26);
        heart(mesh, -0.46, 0.72, 0.1);
        heart(mesh, 0.46, -0.66, 0.1);
    })
}

/// Bars between posts along a wall; two high rails where they are parallel; a frame of bars to climb on.
pub(super) fn wall_bars(a: &Ask) -> BuiltModel {
    let wood = a.main(Stuff(Finish::Wood, 0xc49b6b));
    let steel = stuff::STEEL.surface();
    if a.says(&["parallel"]) {
        return headed(a, |mesh| {
            for x in [-0.3, 0.3] {
                cone(mesh, at(x, 1.2, -1.0), at(x, 1.2, 1.0), [0.045, 0.045], &wood);
                mesh.rounded(block(x - 0.08..x + 0.08, 0.0..0.08, -0.95..0.95), 0.03, 1, &steel);
                for z in [-0.6, 0.6] {
                    cone(mesh, at(x, 0.05, z), at(x, 1.2, z), [0.05, 0.035], &steel);
                }
            }
            for z in [-0.9, 0.9] {
                mesh.rounded(block(-0.3..0.3, 0.0..0.07, z - 0.06..z + 0.06), 0.03, 1, &steel);
            }
        });
    }
    if a.says(&["frame"]) {
        let paint = |color: u32| of(Finish::Paint, color);
        return small(a, |mesh| {
            for i in 0..3 {
                for k in 0..3 {
                    let (x, z) = (f64::from(i) - 1.0, f64::from(k) - 1.0);
                    let high = if i == 1 && k == 1 { 2.0 } else { 1.4 };
                    mesh.sweep(
                        &[(at(x, 0.0, z), 0.045, 0.045), (at(x, high, z), 0.045, 0.045)],
                        at(0.0, 0.0, 1.0),
                        8,
                        &paint(0xc8392f),
                    );
                    for level in 1..=2 {
                        let y = 0.7 * f64::from(level);
                        let bar = |mesh: &mut Mesh, to, s: &Surface| {
                            mesh.sweep(&[(at(x, y, z), 0.035, 0.035), (to, 0.035, 0.035)], at(0.3, 0.9, 0.2), 8, s)
                        };
                        if i < 2 {
                            bar(mesh, at(x + 1.0, y, z), &paint(0x2f6fa8));
                        }
                        if k < 2 {
                            bar(mesh, at(x, y, z + 1.0), &paint(0xe3bd3a));
                        }
                    }
                    if high < 2.0 && (i == 1 || k == 1) {
                        mesh.sweep(
                            &[(at(x, 1.4, z), 0.035, 0.035), (at(0.0, 2.0, 0.0), 0.035, 0.035)],
                            at(0.3, 0.9, 0.2),
                            8,
                            &paint(0x3f8a4c),
                        );
                    }
                }
            }
        });
    }
    small(a, |mesh| {
        for side in block(-1.0..-0.88, 0.0..3.0, -0.1..0.2).both_sides() {
            mesh.crisp(side, &wood);
        }
        for k in 0..14 {
            let y = 0.2 + 0.2 * f64::from(k);
            cone(mesh, at(-0.9, y, 0.12), at(0.9, y, 0.12), [0.045, 0.045], &shade(&wood, 0.9));
        }
    })
}

/// Two numbers of light under two names.
pub(super) fn scoreboard(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::DARK_PLASTIC);
    let glow = of(Finish::Glow, 0xff5a2a);
    small(a, |mesh| {
        mesh.rounded(block(-1.5..1.5, 0.0..1.9, -0.1..0.0), 0.04, 1, &case);
        mesh.crisp(block(-1.4..1.4, 1.5..1.78, 0.0..0.02), &of(Finish::Paint, 0xf1f0ec));
        for x in [-0.9, 0.5] {
            mesh.crisp(block(x..x + 0.4, 1.58..1.7, 0.02..0.03), &case);
        }
        // Strokes of digits, each as of a display of seven.
        let strokes = |mesh: &mut Mesh, x: f64, which: &[usize]| {
            let at = [
                (0.0..0.4, 1.1..1.18),
                (0.0..0.4, 0.7..0.78),
                (0.0..0.4, 0.3..0.38),
                (-0.02..0.06, 0.74..1.14),
                (0.34..0.42, 0.74..1.14),
                (-0.02..0.06, 0.34..0.74),
                (0.34..0.42, 0.34..0.74),
            ];
            for &k in which {
                let (u, v) = at[k].clone();
                mesh.crisp(block(-x - u.end..-x - u.start, v, 0.0..0.03 + 0.004 * k as f64), &glow);
            }
        };
        strokes(mesh, -1.2, &[0, 1, 2, 4, 5]);
        strokes(mesh, -0.62, &[3, 1, 4, 6]);
        strokes(mesh, 0.2, &[4, 6]);
        strokes(mesh, 0.78, &[0, 1, 2, 4, 6]);
        for y in [0.55, 0.95] {
            mesh.crisp(block(-0.06..0.06, y - 0.06..y + 0.06, 0.0..0.03), &glow);
        }
    })
}

/// Cells of dark glass in a frame that leans on a stay.
pub(super) fn solar_panel(a: &Ask) -> BuiltModel {
    let frame = a.main(stuff::STEEL);
    small(a, |mesh| {
        mesh.place(at(0.0, 0.0, 0.4), [-30.0, 0.0, 0.0], |mesh| {
            mesh.crisp(block(-1.0..1.0, 0.0..1.4, -0.05..0.0), &frame);
            for row in block(-0.96..0.96, 0.04..1.36, 0.0..0.02).split(1, 4, 0.02) {
                for cell in row.split(0, 6, 0.02) {
                    mesh.crisp(cell, &of(Finish::Glass, 0x1f2f5f));
                }
            }
        });
        for x in [-0.8, 0.8] {
            mesh.rod(at(x, 1.0, -0.25), at(x, 0.0, -0.6), 0.03, &frame);
            mesh.rod(at(x, 0.03, -0.6), at(x, 0.03, 0.4), 0.03, &frame);
        }
    })
}

/// A disc of iron with a hole and a rim.
pub(super) fn weight_plate(a: &Ask) -> BuiltModel {
    let iron = a.main(stuff::BLACK_STEEL);
    round(a, |mesh| {
        mesh.drum(block(-0.96..0.96, -0.1..0.1, -0.96..0.96), &iron);
        mesh.torus(block(-1.0..1.0, -0.16..0.16, -1.0..1.0), 0.14, &iron);
        mesh.torus(block(-0.34..0.34, -0.17..0.17, -0.34..0.34), 0.4, &iron);
        mesh.drum(block(-0.14..0.14, -0.115..0.115, -0.14..0.14), &stuff::CHROME.surface());
        for k in 0..3 {
            let (sin, cos) = (TAU * f64::from(k) / 3.0).sin_cos();
            mesh.rounded(
                block(-0.18..0.18, -0.115..0.115, -0.09..0.09).moved(0.6 * cos, 0.0, 0.6 * sin),
                0.03,
                1,
                &of(Finish::Paint, 0xf1f0ec),
            );
        }
    })
}

/// Glass on all sides with earth, stones and plants in it, without water.
pub(super) fn terrarium(a: &Ask) -> BuiltModel {
    let frame = a.main(stuff::BLACK_STEEL);
    let leaf = stuff::LEAF.surface();
    let mut dice = a.dice();
    small(a, |mesh| {
        mesh.crisp(block(-1.0..1.0, 0.0..0.1, -0.5..0.5), &frame);
        mesh.crisp(block(-1.0..1.0, 1.3..1.4, -0.5..0.5), &frame);
        for post in block(-1.0..-0.95, 0.08..1.32, 0.45..0.5).four_corners() {
            mesh.crisp(post, &frame);
        }
        for z in [-0.49..-0.47, 0.47..0.49] {
            mesh.crisp(block(-0.96..0.96, 0.1..1.3, z), &stuff::GLASS.surface());
        }
        mesh.crisp(block(-0.95..0.95, 0.1..0.3, -0.46..0.46), &stuff::SOIL.surface());
        for _ in 0..6 {
            let (x, z, r) = (dice.between(-0.8, 0.8), dice.between(-0.3, 0.3), dice.between(0.06, 0.14));
            mesh.bead(block(x - r..x + r, 0.24..0.26 + 1.2 * r, z - r..z + r), &stuff::STONE.surface());
        }
        for k in 0..14 {
            let (x, z) = (dice.between(-0.8, 0.8), dice.between(-0.3, 0.3));
            let high = dice.between(0.5, 1.15);
            let path = [
                (at(x, 0.28, z), 0.02, 0.01),
                (at(x + 0.03, 0.6 * high, z), 0.06, 0.015),
                (at(x + dice.between(-0.15, 0.15), high, z), 0.01, 0.01),
            ];
            mesh.sweep(&path, at(0.0, 0.0, 1.0), 6, &shade(&leaf, if k % 2 == 0 { 0.8 } else { 1.2 }));
        }
    })
}

/// A shade of metal with a glowing bulb on a cord.
pub(super) fn heat_lamp(a: &Ask) -> BuiltModel {
    let steel = a.main(Stuff(Finish::Metal, 0xb87333));
    small(a, |mesh| {
        mesh.lathe(
            block(-0.6..0.6, 0.2..1.0, -0.6..0.6),
            &[(1.0, 0.0), (0.9, 0.3), (0.4, 0.8), (0.2, 1.0)],
            24,
            &steel,
        );
        mesh.ball(block(-0.26..0.26, 0.0..0.56, -0.26..0.26), &of(Finish::Glow, 0xff6a2a));
        mesh.drum(block(-0.14..0.14, 0.95..1.15, -0.14..0.14), &stuff::DARK_PLASTIC.surface());
        mesh.rod(at(0.0, 1.1, 0.0), at(0.0, 1.7, 0.0), 0.03, &stuff::DARK_PLASTIC.surface());
    })
}

/// Two sides on a foot, and napkins between them.
pub(super) fn napkin_holder(a: &Ask) -> BuiltModel {
    let steel = a.main(stuff::CHROME);
    small(a, |mesh| {
        mesh.rounded(block(-0.7..0.7, 0.0..0.08, -0.45..0.45), 0.03, 1, &steel);
        for z in [-0.34, 0.34] {
            mesh.place(at(0.0, 0.5, z), [90.0, 0.0, 0.0], |mesh| {
                mesh.torus(block(-0.62..0.62, -0.04..0.04, -0.5..0.5), 0.12, &steel);
                mesh.torus(block(-0.3..0.3, -0.03..0.03, -0.26..0.26), 0.2, &steel);
            });
        }
        for k in 0..5 {
            let z = -0.24 + 0.1 * f64::from(k);
            mesh.extrude(
                2,
                &[(-0.6, 0.08), (0.6, 0.08), (0.6, 1.15), (-0.6, 1.15)],
                z..z + 0.07,
                &shade(&stuff::SHEET.surface(), if k % 2 == 0 { 1.0 } else { 0.94 }),
            );
        }
    })
}
