//! Small devices: cameras, consoles, routers, scales, batteries, microscopes, switches on walls, vents, watches.

use super::strokes::{at, blade, cone, headed, of, round, small};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use std::f64::consts::TAU;

/// A lens that looks to the front, from its edge in.
fn lens(mesh: &mut Mesh, [x, y, z]: [f64; 3], r: f64, s: &Surface) {
    cone(mesh, at(x, y, z), at(x, y, z + 0.5 * r), [r, 0.95 * r], s);
    cone(mesh, at(x, y, z + 0.48 * r), at(x, y, z + 0.53 * r), [0.8 * r, 0.78 * r], &of(Finish::Glass, 0x2a3f6f));
    cone(mesh, at(x, y, z + 0.52 * r), at(x, y, z + 0.56 * r), [0.3 * r, 0.3 * r], &of(Finish::Glass, 0x8fa8d0));
}

/// A camera on a wall bracket; on a foot where it films who sits before it; to take pictures with, where it is just a camera.
pub(super) fn camera(a: &Ask) -> BuiltModel {
    let watches = a.says(&["security", "cctv", "surveillance"]);
    let case = a.main(if watches { stuff::WHITE } else { stuff::DARK_PLASTIC });
    let dark = stuff::DARK_PLASTIC.surface();
    small(a, |mesh| {
        if watches {
            mesh.disc(2, block(-0.36..0.36, 0.64..1.36, -1.4..-1.25), &case);
            mesh.tube(&[at(0.0, 1.0, -1.3), at(0.0, 1.0, -0.8), at(0.0, 0.5, -0.5)], 0.12, &case);
            mesh.place(at(0.0, 0.3, 0.0), [12.0, 0.0, 0.0], |mesh| {
                mesh.rounded(block(-0.36..0.36, -0.34..0.3, -0.9..0.9), 0.12, 2, &case);
                mesh.rounded(block(-0.44..0.44, 0.26..0.36, -0.9..1.15), 0.04, 1, &shade(&case, 0.9));
                mesh.disc(2, block(-0.3..0.3, -0.32..0.26, 0.88..0.94), &dark);
                lens(mesh, [0.0, -0.03, 0.9], 0.2, &dark);
            });
        } else if a.says(&["webcam"]) {
            mesh.rounded(block(-0.8..0.8, 0.5..1.1, -0.2..0.3), 0.24, 3, &case);
            lens(mesh, [0.0, 0.8, 0.28], 0.26, &dark);
            mesh.disc(2, block(0.5..0.6, 0.75..0.85, 0.3..0.33), &stuff::GREEN_LIGHT.surface());
            mesh.rounded(block(-0.3..0.3, 0.36..0.54, -0.2..0.3), 0.05, 1, &dark);
            mesh.place(at(0.0, 0.4, -0.2), [14.0, 0.0, 0.0], |mesh| {
                mesh.rounded(block(-0.3..0.3, -0.44..0.0, -0.1..0.0), 0.03, 1, &dark)
            });
        } else {
            mesh.rounded(block(-1.0..1.0, 0.0..1.1, -0.3..0.3), 0.1, 2, &case);
            mesh.taper(block(-0.4..0.4, 1.05..1.4, -0.3..0.3), block(-0.25..0.25, 1.3..1.4, -0.25..0.2), &case);
            mesh.rounded(block(-1.02..-0.62, 0.0..1.1, -0.28..0.44), 0.1, 2, &shade(&case, 1.4));
            lens(mesh, [0.1, 0.55, 0.28], 0.46, &shade(&case, 0.8));
            lens(mesh, [0.1, 0.55, 0.48], 0.38, &case);
            mesh.drum(block(-0.9..-0.7, 1.08..1.2, 0.0..0.2), &stuff::CHROME.surface());
            mesh.drum(block(0.55..0.85, 1.08..1.22, -0.15..0.15), &stuff::CHROME.surface());
        }
    })
}

/// Two grips with sticks, a cross and four buttons.
pub(super) fn game_controller(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::DARK_PLASTIC);
    small(a, |mesh| {
        mesh.rounded(block(-0.8..0.8, 0.3..0.62, -0.5..0.3), 0.14, 3, &case);
        for side in [-1.0, 1.0] {
            let grip = [
                (at(side * 0.62, 0.44, -0.35), 0.36, 0.2),
                (at(side * 0.78, 0.4, 0.2), 0.3, 0.2),
                (at(side * 0.86, 0.2, 0.8), 0.16, 0.14),
            ];
            mesh.sweep(&grip, at(0.0, 1.0, 0.0), 14, &case);
            mesh.rounded(
                block(side * 0.6 - 0.2..side * 0.6 + 0.2, 0.36..0.56, -0.64..-0.5),
                0.05,
                1,
                &shade(&case, 1.5),
            );
            mesh.drum(block(side * 0.3 - 0.14..side * 0.3 + 0.14, 0.6..0.74, 0.0..0.28), &shade(&case, 1.6));
        }
        for (x, z, color) in
            [(0.62, -0.38, 0xe3bd3a), (0.62, -0.06, 0x3f8a4c), (0.46, -0.22, 0x2f6fa8), (0.78, -0.22, 0xc8392f)]
        {
            mesh.drum(block(x - 0.07..x + 0.07, 0.6..0.7, z - 0.07..z + 0.07), &of(Finish::Plastic, color));
        }
        mesh.crisp(block(-0.8..-0.44, 0.6..0.68, -0.28..-0.16), &shade(&case, 1.8));
        mesh.crisp(block(-0.68..-0.56, 0.6..0.681, -0.4..-0.04), &shade(&case, 1.8));
    })
}

/// A flat box with a slot for discs, and lights.
pub(super) fn game_console(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::DARK_PLASTIC);
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.06..0.3, -0.8..0.8), 0.05, 1, &case);
        mesh.rounded(block(-1.0..1.0, 0.34..0.58, -0.8..0.76), 0.05, 1, &shade(&case, 1.4));
        mesh.crisp(block(-0.96..0.96, 0.28..0.36, -0.76..0.74), &of(Finish::Glow, 0x4f9fe0));
        mesh.crisp(block(-0.8..0.1, 0.44..0.48, 0.74..0.77), &stuff::RUBBER.surface());
        mesh.disc(2, block(0.6..0.76, 0.38..0.54, 0.75..0.79), &of(Finish::Glow, 0x4f9fe0));
        for x in [0.3, 0.55] {
            mesh.crisp(block(x..x + 0.16, 0.14..0.2, 0.79..0.81), &stuff::RUBBER.surface());
        }
    })
}

/// A flat case with antennas and a row of lights; for a ceiling a disc with a ring of light.
pub(super) fn router(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::DARK_PLASTIC);
    if a.says(&["access", "point"]) {
        return small(a, |mesh| {
            mesh.lathe(
                block(-1.0..1.0, 0.0..0.4, -1.0..1.0),
                &[(0.7, 0.0), (1.0, 0.5), (0.94, 1.0)],
                24,
                &stuff::WHITE.surface(),
            );
            mesh.torus(block(-0.5..0.5, -0.03..0.03, -0.5..0.5), 0.12, &of(Finish::Glow, 0x4f9fe0));
        });
    }
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.0..0.3, -0.6..0.6), 0.1, 2, &case);
        for x in [-0.8, 0.0, 0.8] {
            cone(mesh, at(x, 0.15, -0.62), at(x, 0.4, -0.66), [0.07, 0.07], &shade(&case, 1.4));
            cone(mesh, at(x, 0.36, -0.66), at(x * 1.1, 1.5, -0.7), [0.06, 0.05], &case);
        }
        for k in 0..6 {
            let x = -0.6 + 0.22 * f64::from(k);
            mesh.crisp(block(x..x + 0.1, 0.12..0.18, 0.59..0.62), &stuff::GREEN_LIGHT.surface());
        }
        for k in 0..8 {
            let x = -0.7 + 0.18 * f64::from(k);
            mesh.crisp(block(x..x + 0.09, 0.29..0.31, -0.4..0.2), &shade(&case, 1.8));
        }
    })
}

/// A plate to stand on with a dial; for a kitchen with a bowl over a display; a balance has a beam with two pans.
pub(super) fn scale(a: &Ask) -> BuiltModel {
    let steel = a.main(stuff::STEEL);
    let dark = stuff::DARK_PLASTIC.surface();
    if a.says(&["balance"]) {
        let brass = a.main(stuff::BRASS);
        return small(a, |mesh| {
            mesh.rounded(block(-1.0..1.0, 0.0..0.16, -0.5..0.5), 0.04, 1, &stuff::WALNUT.surface());
            cone(mesh, at(0.0, 0.1, 0.0), at(0.0, 1.7, 0.0), [0.09, 0.05], &brass);
            cone(mesh, at(-1.0, 1.6, 0.0), at(1.0, 1.6, 0.0), [0.05, 0.05], &brass);
            mesh.bead(block(-0.1..0.1, 1.66..1.86, -0.1..0.1), &brass);
            for x in [-0.95, 0.95] {
                for k in 0..3 {
                    let (sin, cos) = (TAU * f64::from(k) / 3.0).sin_cos();
                    mesh.rod(at(x, 1.58, 0.0), at(x + 0.36 * cos, 0.6, 0.36 * sin), 0.012, &brass);
                }
                let pan = [(0.3, 0.0), (0.8, 0.4), (1.0, 1.0), (0.92, 1.0), (0.6, 0.5)];
                mesh.lathe(block(x - 0.42..x + 0.42, 0.46..0.62, -0.42..0.42), &pan, 24, &brass);
            }
        });
    }
    let kitchen = a.says(&["kitchen", "digital"]);
    small(a, |mesh| {
        mesh.rounded(
            block(-1.0..1.0, 0.0..0.26, -1.0..1.0),
            0.1,
            2,
            &if kitchen { stuff::WHITE.surface() } else { steel.clone() },
        );
        if kitchen {
            mesh.drum(block(-0.8..0.8, 0.24..0.4, -0.95..0.6), &steel);
            mesh.crisp(block(-0.4..0.4, 0.25..0.28, 0.66..0.92), &stuff::SCREEN.surface());
            for x in [-0.7, 0.7] {
                mesh.drum(block(x - 0.12..x + 0.12, 0.24..0.3, 0.68..0.92), &dark);
            }
        } else {
            for side in block(-0.88..-0.2, 0.25..0.29, -0.4..0.9).both_sides() {
                mesh.rounded(side, 0.01, 1, &of(Finish::Rubber, 0x4a4f55));
            }
            mesh.drum(block(-0.4..0.4, 0.24..0.3, -0.92..-0.44), &stuff::WHITE.surface());
            mesh.crisp(block(-0.02..0.02, 0.3..0.31, -0.86..-0.66), &stuff::RED.surface());
            for k in -2..=2 {
                let (sin, cos) = (0.5 * f64::from(k)).sin_cos();
                mesh.bead(block(-0.03..0.03, 0.28..0.32, -0.03..0.03).moved(0.3 * sin, 0.0, -0.68 - 0.18 * cos), &dark);
            }
        }
    })
}

/// A case with two poles, plus and minus.
pub(super) fn battery(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::DARK_PLASTIC);
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.0..1.1, -0.6..0.6), 0.05, 1, &case);
        mesh.rounded(block(-1.02..1.02, 0.9..1.2, -0.62..0.62), 0.05, 1, &shade(&case, 1.6));
        for (x, color) in [(-0.66, 0x3a3a3e), (0.66, 0xc8392f)] {
            mesh.drum(block(x - 0.16..x + 0.16, 1.18..1.28, -0.16..0.16), &of(Finish::Plastic, color));
            mesh.drum(block(x - 0.1..x + 0.1, 1.26..1.5, -0.1..0.1), &of(Finish::Metal, 0x9a9ea2));
        }
        mesh.crisp(block(-0.85..0.85, 0.25..0.8, 0.6..0.62), &of(Finish::Paper, 0xe3bd3a));
        for x in [-0.5, 0.5] {
            mesh.crisp(block(x - 0.18..x + 0.18, 0.49..0.56, 0.61..0.635), &case);
        }
        mesh.crisp(block(0.465..0.535, 0.34..0.71, 0.61..0.634), &case);
    })
}

/// A case with an antenna, a grille and a display.
pub(super) fn walkie_talkie(a: &Ask) -> BuiltModel {
    let case = a.main(Stuff(Finish::Plastic, 0xd9a33a));
    let dark = stuff::DARK_PLASTIC.surface();
    small(a, |mesh| {
        mesh.rounded(block(-0.5..0.5, 0.0..1.6, -0.3..0.3), 0.1, 2, &case);
        cone(mesh, at(-0.3, 1.55, 0.0), at(-0.3, 2.7, 0.0), [0.11, 0.07], &dark);
        mesh.drum(block(0.1..0.4, 1.58..1.76, -0.15..0.15), &dark);
        mesh.crisp(block(-0.34..0.34, 1.1..1.42, 0.29..0.32), &stuff::SCREEN.surface());
        for k in 0..5 {
            let y = 0.2 + 0.1 * f64::from(k);
            mesh.crisp(block(-0.32..0.32, y..y + 0.05, 0.29..0.315), &dark);
        }
        for x in [-0.25, 0.0, 0.25] {
            mesh.rounded(block(x - 0.08..x + 0.08, 0.84..0.98, 0.28..0.34), 0.02, 1, &dark);
        }
        mesh.rounded(block(-0.58..-0.46, 0.8..1.3, -0.14..0.14), 0.04, 1, &dark);
    })
}

/// A tube that leans over a stage, on a curved arm and a heavy foot.
pub(super) fn microscope(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::WHITE);
    let dark = stuff::DARK_PLASTIC.surface();
    let steel = stuff::CHROME.surface();
    headed(a, |mesh| {
        mesh.rounded(block(-0.5..0.5, 0.0..0.2, -0.7..0.7), 0.08, 2, &case);
        let arm = [
            (at(0.0, 0.15, -0.55), 0.2, 0.16),
            (at(0.0, 0.9, -0.6), 0.18, 0.14),
            (at(0.0, 1.5, -0.4), 0.18, 0.14),
            (at(0.0, 1.62, 0.0), 0.2, 0.14),
        ];
        mesh.sweep(&arm, at(0.0, 0.0, 1.0), 12, &case);
        mesh.rounded(block(-0.42..0.42, 0.72..0.82, -0.4..0.55), 0.02, 1, &dark);
        mesh.crisp(block(-0.3..0.3, 0.81..0.84, 0.02..0.2), &stuff::GLASS.surface());
        cone(mesh, at(0.0, 1.2, 0.1), at(0.0, 1.75, 0.1), [0.17, 0.2], &case);
        cone(mesh, at(0.0, 0.9, 0.12), at(0.0, 1.22, 0.1), [0.06, 0.1], &steel);
        cone(mesh, at(0.16, 0.98, 0.02), at(0.06, 1.22, 0.08), [0.05, 0.09], &steel);
        cone(mesh, at(0.0, 1.7, 0.08), at(0.0, 2.2, -0.35), [0.15, 0.13], &dark);
        cone(mesh, at(0.0, 2.18, -0.33), at(0.0, 2.3, -0.44), [0.16, 0.16], &dark);
        for side in [-1.0, 1.0] {
            cone(mesh, at(side * 0.1, 0.55, -0.58), at(side * 0.36, 0.55, -0.58), [0.16, 0.16], &dark);
        }
        mesh.drum(block(-0.16..0.16, 0.2..0.4, -0.05..0.27), &of(Finish::Glow, 0xfff2cf));
    })
}

/// Plates on a wall with what is worked there: a rocker, holes, a dial, a button, a speaker or a reader.
pub(super) fn wall_switch(a: &Ask) -> BuiltModel {
    let plate = a.main(stuff::WHITE);
    let dark = stuff::DARK_PLASTIC.surface();
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, -1.0..1.0, 0.0..0.2), 0.06, 1, &plate);
        if a.says(&["socket", "outlet"]) {
            mesh.disc(2, block(-0.7..0.7, -0.7..0.7, 0.18..0.26), &shade(&plate, 0.85));
            for x in [-0.3, 0.3] {
                mesh.disc(2, block(x - 0.11..x + 0.11, -0.11..0.11, 0.25..0.28), &dark);
            }
            for y in [-0.64, 0.52] {
                mesh.crisp(block(-0.1..0.1, y..y + 0.12, 0.25..0.3), &stuff::BRASS.surface());
            }
        } else if a.says(&["thermostat"]) {
            mesh.disc(2, block(-0.8..0.8, -0.8..0.8, 0.18..0.6), &stuff::CHROME.surface());
            mesh.disc(2, block(-0.66..0.66, -0.66..0.66, 0.55..0.64), &stuff::SCREEN.surface());
            for k in -4..=4 {
                let (sin, cos) = (0.5 * f64::from(k)).sin_cos();
                mesh.bead(
                    block(-0.05..0.05, -0.05..0.05, 0.6..0.68).moved(0.54 * sin, 0.54 * cos, 0.0),
                    &of(Finish::Glow, 0xe98a3a),
                );
            }
        } else if a.says(&["doorbell"]) {
            mesh.disc(2, block(-0.55..0.55, -0.55..0.55, 0.18..0.3), &stuff::BRASS.surface());
            mesh.disc(2, block(-0.3..0.3, -0.3..0.3, 0.28..0.46), &of(Finish::Glow, 0xfff2cf));
            bell(mesh, &dark);
        } else if a.says(&["intercom"]) {
            for k in 0..5 {
                let y = 0.2 + 0.13 * f64::from(k);
                mesh.crisp(block(-0.6..0.6, y..y + 0.06, 0.19..0.22), &dark);
            }
            for (k, x) in [-0.5, 0.0, 0.5].into_iter().enumerate() {
                let s = if k == 1 { stuff::GREEN_LIGHT.surface() } else { shade(&plate, 0.7) };
                mesh.rounded(block(x - 0.18..x + 0.18, -0.7..-0.34, 0.18..0.3), 0.04, 1, &s);
            }
            mesh.disc(2, block(-0.12..0.12, -0.16..0.08, 0.19..0.24), &dark);
        } else if a.says(&["card", "reader"]) {
            mesh.rounded(block(-0.8..0.8, -0.9..0.9, 0.16..0.4), 0.08, 1, &dark);
            mesh.crisp(block(-0.5..0.5, 0.5..0.6, 0.39..0.42), &stuff::GREEN_LIGHT.surface());
            for r in [0.2, 0.36, 0.52] {
                let arc = (-3..=3)
                    .map(|k| at(-0.3 + r * (0.25 * f64::from(k)).cos(), -0.2 + r * (0.25 * f64::from(k)).sin(), 0.41));
                mesh.tube(&arc.collect::<Vec<_>>(), 0.04, &plate);
            }
        } else {
            mesh.rounded(block(-0.45..0.45, -0.7..0.7, 0.14..0.26), 0.03, 1, &shade(&plate, 0.9));
            mesh.place(at(0.0, 0.0, 0.24), [-8.0, 0.0, 0.0], |mesh| {
                mesh.rounded(block(-0.36..0.36, -0.6..0.6, -0.04..0.1), 0.03, 1, &plate)
            });
        }
    })
}

/// The sign of a bell below a button.
fn bell(mesh: &mut Mesh, s: &Surface) {
    mesh.extrude(2, &[(-0.16, -0.82), (0.16, -0.82), (0.09, -0.64), (-0.09, -0.64)], 0.19..0.23, s);
    mesh.bead(block(-0.05..0.05, -0.9..-0.8, 0.18..0.24), s);
}

/// A frame with slats.
pub(super) fn vent(a: &Ask) -> BuiltModel {
    let metal = a.main(stuff::WHITE);
    small(a, |mesh| {
        mesh.crisp(block(-0.88..0.88, -0.88..0.88, 0.03..0.1), &stuff::DARK_PLASTIC.surface());
        for side in block(-1.0..-0.86, -1.0..1.0, 0.0..0.4).both_sides() {
            mesh.crisp(side, &metal);
        }
        for y in [-1.0..-0.86, 0.86..1.0] {
            mesh.crisp(block(-0.86..0.86, y, 0.0..0.39), &metal);
        }
        for k in 0..8 {
            mesh.place(at(0.0, -0.74 + 0.21 * f64::from(k), 0.22), [50.0, 0.0, 0.0], |mesh| {
                mesh.crisp(block(-0.88..0.88, -0.03..0.03, -0.16..0.16), &metal)
            });
        }
        for (x, y) in [(-0.93, -0.93), (0.93, -0.93), (-0.93, 0.93), (0.93, 0.93)] {
            mesh.bead(block(x - 0.04..x + 0.04, y - 0.04..y + 0.04, 0.36..0.44), &stuff::STEEL.surface());
        }
    })
}

/// A pipe from the ceiling, a frame with a red bulb, and the plate that spreads the water.
pub(super) fn sprinkler(a: &Ask) -> BuiltModel {
    let brass = a.main(stuff::BRASS);
    small(a, |mesh| {
        mesh.drum(block(-1.0..1.0, 0.9..1.0, -1.0..1.0), &stuff::WHITE.surface());
        cone(mesh, at(0.0, 0.62, 0.0), at(0.0, 0.95, 0.0), [0.3, 0.3], &brass);
        for side in [-1.0, 1.0] {
            mesh.tube(&[at(side * 0.26, 0.64, 0.0), at(side * 0.4, 0.4, 0.0), at(side * 0.1, 0.14, 0.0)], 0.07, &brass);
        }
        cone(mesh, at(0.0, 0.16, 0.0), at(0.0, 0.64, 0.0), [0.1, 0.1], &of(Finish::Glass, 0xd02f2a));
        mesh.drum(block(-0.55..0.55, 0.04..0.1, -0.55..0.55), &brass);
        for k in 0..12 {
            let (sin, cos) = (TAU * f64::from(k) / 12.0).sin_cos();
            mesh.bead(block(-0.08..0.08, 0.03..0.11, -0.08..0.08).moved(0.6 * cos, 0.0, 0.6 * sin), &brass);
        }
        mesh.drum(block(-0.14..0.14, 0.0..0.2, -0.14..0.14), &brass);
    })
}

/// A round dial with hands: on a band, or with a crown to stop it.
pub(super) fn watch(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::CHROME);
    let dark = stuff::DARK_PLASTIC.surface();
    if a.says(&["sundial"]) {
        let stone = a.main(stuff::STONE);
        return round(a, |mesh| {
            mesh.drum(block(-1.0..1.0, 0.0..0.16, -1.0..1.0), &stone);
            mesh.drum(block(-0.86..0.86, 0.14..0.2, -0.86..0.86), &stuff::BRASS.surface());
            for k in 0..12 {
                let (sin, cos) = (TAU * f64::from(k) / 12.0).sin_cos();
                mesh.rod(at(0.6 * cos, 0.21, 0.6 * sin), at(0.8 * cos, 0.21, 0.8 * sin), 0.025, &dark);
            }
            mesh.extrude(0, &[(0.2, -0.7), (0.2, 0.1), (0.9, -0.7)], -0.04..0.04, &stuff::BRASS.surface());
        });
    }
    let face = |mesh: &mut Mesh| {
        mesh.drum(block(-0.7..0.7, 0.0..0.24, -0.7..0.7), &case);
        mesh.drum(block(-0.6..0.6, 0.22..0.27, -0.6..0.6), &stuff::WHITE.surface());
        for k in 0..12 {
            let (sin, cos) = (TAU * f64::from(k) / 12.0).sin_cos();
            mesh.rod(at(0.44 * cos, 0.275, 0.44 * sin), at(0.54 * cos, 0.275, 0.54 * sin), 0.02, &dark);
        }
        mesh.rod(at(0.0, 0.29, 0.0), at(0.0, 0.29, -0.44), 0.025, &dark);
        mesh.rod(at(0.0, 0.29, 0.0), at(0.26, 0.29, -0.16), 0.03, &stuff::RED.surface());
    };
    if a.says(&["stopwatch", "timer"]) {
        return round(a, |mesh| {
            face(mesh);
            cone(mesh, at(0.0, 0.12, -0.68), at(0.0, 0.12, -0.86), [0.1, 0.1], &case);
            cone(mesh, at(0.0, 0.12, -0.85), at(0.0, 0.12, -1.0), [0.17, 0.17], &case);
            cone(mesh, at(0.48, 0.12, -0.52), at(0.6, 0.12, -0.66), [0.08, 0.08], &case);
            mesh.place(at(0.0, 0.12, -1.0), [0.0, 0.0, 0.0], |mesh| {
                mesh.torus(block(-0.24..0.24, -0.05..0.05, -0.2..0.2), 0.25, &case)
            });
        });
    }
    let strap = a.second(Stuff(Finish::Leather, 0x5a3a24));
    small(a, |mesh| {
        // The band stands as a ring, the dial on its front.
        mesh.place(at(0.0, 0.9, 0.0), [0.0, 0.0, 90.0], |mesh| {
            mesh.torus(block(-0.9..0.9, -0.3..0.3, -0.9..0.9), 0.14, &strap)
        });
        mesh.place(at(0.0, 0.9, 0.84), [90.0, 0.0, 0.0], face);
        cone(mesh, at(0.66, 0.9, 0.96), at(0.8, 0.9, 0.96), [0.08, 0.08], &case);
    })
}

/// A gate of two posts and a head that one walks through.
pub(super) fn metal_detector(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let case = a.main(stuff::GRAY);
    for side in b.share(0.0..0.14, 0.0..1.0, 0.0..1.0).both_sides() {
        m.board(side, &case);
        for k in 0..6 {
            let low = 0.1 + 0.12 * f64::from(k);
            m.mesh.crisp(side.share(0.3..0.7, low..low + 0.08, 0.99..1.0), &stuff::GREEN_LIGHT.surface());
        }
    }
    m.board(b.share(0.14..0.86, 0.88..1.0, 0.0..1.0), &case);
    m.mesh.crisp(b.share(0.36..0.64, 0.91..0.97, 0.985..1.0), &stuff::SCREEN.surface());
    m.mesh.crisp(b.share(0.14..0.86, 0.0..0.01, 0.1..0.9), &stuff::RUBBER.surface());
    m
}

/// A ball of small mirrors on a chain.
pub(super) fn disco_ball(a: &Ask) -> BuiltModel {
    let silver = a.main(stuff::MIRROR);
    small(a, |mesh| {
        mesh.lathe(block(-0.97..0.97, -0.97..0.97, -0.97..0.97), &crate::shapes::sphere(8), 16, &shade(&silver, 0.5));
        for row in 1..12 {
            let lat = std::f64::consts::PI * (f64::from(row) / 12.0 - 0.5);
            let count = (18.0 * lat.cos()).round().max(4.0) as u32;
            for k in 0..count {
                let turn = 360.0 * f64::from(k) / f64::from(count);
                mesh.place(at(0.0, 0.0, 0.0), [0.0, turn, 0.0], |mesh| {
                    mesh.place(at(0.0, lat.sin(), lat.cos()), [-lat.to_degrees(), 0.0, 0.0], |mesh| {
                        mesh.extrude(2, &[(-0.12, -0.1), (0.12, -0.1), (0.12, 0.1), (-0.12, 0.1)], -0.05..0.0, &silver);
                    });
                });
            }
        }
        mesh.drum(block(-0.16..0.16, 0.96..1.16, -0.16..0.16), &stuff::CHROME.surface());
        mesh.rod(at(0.0, 1.1, 0.0), at(0.0, 1.4, 0.0), 0.03, &stuff::CHROME.surface());
    })
}

/// A ribbon with a disc.
pub(super) fn medal(a: &Ask) -> BuiltModel {
    let gold = a.main(stuff::BRASS);
    small(a, |mesh| {
        for (side, color) in [(-1.0, 0x2f4f9f), (1.0, 0xb8322c)] {
            let band = [(side * 0.02, 0.9), (side * 0.24, 0.9), (side * 0.66, 3.4), (side * 0.34, 3.4)];
            mesh.extrude(2, &band, 0.02 * side..0.02 * side + 0.05, &of(Finish::Fabric, color));
        }
        mesh.place(at(0.0, 0.0, 0.0), [90.0, 0.0, 0.0], |mesh| {
            mesh.drum(block(-0.7..0.7, -0.06..0.12, -0.7..0.7), &gold);
            mesh.torus(block(-0.72..0.72, 0.06..0.18, -0.72..0.72), 0.16, &shade(&gold, 0.8));
            blade(mesh, at(0.0, 0.14, 0.0), [0.5, 0.8], 0.04, &shade(&gold, 1.2));
        });
        mesh.rounded(block(-0.2..0.2, 0.66..0.96, -0.06..0.1), 0.03, 1, &gold);
    })
}
