//! What lies on a desk or in a pocket: pens, scissors, staplers, rulers, keys, combs, sunglasses, wallets, soap.

use super::strokes::{at, blade, cone, long, of, small};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;

/// A pen, a pencil, a marker or a lipstick; some of them in a cup.
pub(super) fn pen(a: &Ask) -> BuiltModel {
    if a.says(&["set"]) {
        let cup = a.main(stuff::DARK_PLASTIC);
        return small(a, |mesh| {
            let pot = [(1.0, 0.0), (1.0, 1.0), (0.9, 1.0), (0.86, 0.1)];
            mesh.lathe(block(-0.5..0.5, 0.0..0.9, -0.5..0.5), &pot, 24, &cup);
            for (k, color) in [0xc8392f, 0x2f6fa8, 0xe3bd3a, 0x3f8a4c, 0x26282b].into_iter().enumerate() {
                let (sin, cos) = (1.3 * k as f64).sin_cos();
                let (foot, top) = (at(-0.2 * cos, 0.1, -0.2 * sin), at(0.36 * cos, 1.5 + 0.1 * sin, 0.36 * sin));
                cone(mesh, foot, top, [0.09, 0.09], &of(Finish::Paint, color));
                cone(mesh, top, top + (top - foot) * 0.14, [0.09, 0.02], &stuff::BIRCH.surface());
            }
        });
    }
    let (pencil, lipstick) = (a.says(&["pencil"]), a.says(&["lipstick"]));
    let usual = match (pencil, lipstick) {
        (true, _) => Stuff(Finish::Paint, 0xe3b23a),
        (_, true) => Stuff(Finish::Plastic, 0x1d1d20),
        _ if a.says(&["marker"]) => Stuff(Finish::Plastic, 0x2f7a4c),
        _ => Stuff(Finish::Plastic, 0x2a4f8f),
    };
    let body = a.main(usual);
    let thick = if a.says(&["marker"]) { 0.13 } else { 0.075 };
    long(a, |mesh| {
        if pencil {
            mesh.sweep(
                &[(at(0.0, 0.0, -0.8), 0.07, 0.07), (at(0.0, 0.0, 0.7), 0.07, 0.07)],
                at(0.0, 1.0, 0.0),
                6,
                &body,
            );
            cone(mesh, at(0.0, 0.0, 0.7), at(0.0, 0.0, 0.93), [0.07, 0.02], &stuff::BIRCH.surface());
            cone(mesh, at(0.0, 0.0, 0.92), at(0.0, 0.0, 1.0), [0.022, 0.005], &stuff::BLACK_STEEL.surface());
            cone(mesh, at(0.0, 0.0, -0.9), at(0.0, 0.0, -0.78), [0.075, 0.075], &stuff::BRASS.surface());
            cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, -0.88), [0.065, 0.07], &of(Finish::Rubber, 0xe08a90));
        } else if lipstick {
            cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, -0.1), [0.26, 0.26], &body);
            cone(mesh, at(0.0, 0.0, -0.12), at(0.0, 0.0, 0.3), [0.22, 0.22], &stuff::BRASS.surface());
            cone(mesh, at(0.0, 0.0, 0.28), at(0.0, 0.0, 0.75), [0.18, 0.17], &stuff::RED.surface());
            cone(mesh, at(0.0, 0.0, 0.74), at(0.06, 0.0, 1.0), [0.17, 0.05], &stuff::RED.surface());
        } else {
            cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, 0.1), [thick, thick], &body);
            cone(
                mesh,
                at(0.0, 0.0, 0.08),
                at(0.0, 0.0, 0.8),
                [0.9 * thick, 0.8 * thick],
                &of(Finish::Plastic, 0xe9e4da),
            );
            cone(mesh, at(0.0, 0.0, 0.78), at(0.0, 0.0, 0.92), [0.7 * thick, 0.3 * thick], &body);
            cone(
                mesh,
                at(0.0, 0.0, 0.9),
                at(0.0, 0.0, 1.0),
                [0.25 * thick, 0.12 * thick],
                &stuff::DARK_PLASTIC.surface(),
            );
            let clip = block(-0.02..0.02, thick + 0.01..thick + 0.04, -0.95..-0.3);
            mesh.rounded(clip, 0.01, 1, &stuff::CHROME.surface());
            mesh.crisp(block(-0.02..0.02, 0.0..thick + 0.02, -0.95..-0.88), &stuff::CHROME.surface());
        }
    })
}

/// Two blades that cross, with rings for the fingers.
pub(super) fn scissors(a: &Ask) -> BuiltModel {
    let grip = a.main(Stuff(Finish::Plastic, 0xc8392f));
    let steel = stuff::STEEL.surface();
    long(a, |mesh| {
        for side in [-1.0, 1.0] {
            let y = 0.03 * side;
            let edge =
                [(-0.2, side * 0.1), (0.0, side * 0.07), (1.0, -side * 0.16), (0.9, -side * 0.06), (0.1, side * 0.02)];
            let outline = [(-0.25, side * 0.18), (-0.2, side * 0.04), (1.0, -side * 0.2), (0.1, side * 0.08)];
            mesh.extrude(1, &outline, y - 0.02..y + 0.02, &steel);
            mesh.extrude(1, &edge[..3], y - 0.015..y + 0.015, &steel);
            mesh.place(at(side * 0.28, y, -0.66), [0.0, side * 16.0, 0.0], |mesh| {
                mesh.torus(block(-0.2..0.2, -0.06..0.06, -0.34..0.34), 0.3, &grip);
            });
            mesh.rod(at(side * 0.18, y, -0.36), at(side * 0.1, y, -0.16), 0.06, &grip);
        }
        mesh.drum(block(-0.05..0.05, -0.07..0.07, -0.05..0.05), &stuff::DARK_PLASTIC.surface());
    })
}

/// An arm over a foot; a punch has two pins, a dispenser a reel of tape.
pub(super) fn stapler(a: &Ask) -> BuiltModel {
    let case = a.main(Stuff(Finish::Plastic, 0xb8322c));
    let steel = stuff::STEEL.surface();
    let dark = stuff::DARK_PLASTIC.surface();
    if a.says(&["punch"]) {
        return small(a, |mesh| {
            mesh.rounded(block(-1.0..1.0, 0.0..0.2, -0.6..0.7), 0.06, 2, &dark);
            mesh.rounded(block(-0.75..0.75, 0.18..0.6, -0.55..-0.1), 0.06, 1, &steel);
            mesh.place(at(0.0, 0.7, 0.0), [-14.0, 0.0, 0.0], |mesh| {
                mesh.rounded(block(-0.8..0.8, 0.0..0.2, -0.6..0.8), 0.08, 2, &case);
            });
            for x in [-0.45, 0.45] {
                mesh.rod(at(x, 0.2, 0.0), at(x, 0.8, 0.0), 0.1, &steel);
            }
        });
    }
    if a.says(&["tape"]) {
        return small(a, |mesh| {
            mesh.rounded(block(-0.5..0.5, 0.0..0.3, -1.0..1.2), 0.1, 2, &dark);
            for side in block(-0.5..-0.36, 0.1..0.8, -0.9..0.1).both_sides() {
                mesh.rounded(side, 0.06, 2, &dark);
            }
            mesh.disc(0, block(-0.3..0.3, 0.25..1.3, -0.95..0.1), &of(Finish::Plastic, 0xd9c48a));
            mesh.disc(0, block(-0.32..0.32, 0.5..1.05, -0.7..-0.15), &stuff::WHITE.surface());
            mesh.taper(block(-0.4..0.4, 0.2..0.8, 0.7..1.2), block(-0.4..0.4, 0.7..0.8, 0.95..1.2), &dark);
            mesh.crisp(block(-0.36..0.36, 0.76..0.86, 1.14..1.2), &steel);
            mesh.place(at(0.0, 1.25, -0.4), [16.0, 0.0, 0.0], |mesh| {
                mesh.crisp(block(-0.28..0.28, -0.01..0.01, 0.0..1.6), &of(Finish::Plastic, 0xd9c48a));
            });
        });
    }
    small(a, |mesh| {
        mesh.rounded(block(-0.35..0.35, 0.0..0.14, -1.0..1.0), 0.05, 1, &dark);
        mesh.crisp(block(-0.2..0.2, 0.14..0.18, 0.5..0.9), &steel);
        mesh.rounded(block(-0.3..0.3, 0.1..0.7, -0.98..-0.6), 0.08, 2, &dark);
        mesh.place(at(0.0, 0.5, -0.8), [-7.0, 0.0, 0.0], |mesh| {
            mesh.crisp(block(-0.24..0.24, -0.12..0.02, 0.0..1.7), &steel);
            mesh.rounded(block(-0.34..0.34, 0.0..0.34, -0.1..1.8), 0.14, 3, &case);
        });
    })
}

/// A strip with marks along its edge.
pub(super) fn ruler(a: &Ask) -> BuiltModel {
    let wood = a.main(Stuff(Finish::Wood, 0xd9b878));
    let dark = stuff::DARK_PLASTIC.surface();
    long(a, |mesh| {
        mesh.crisp(block(-0.13..0.13, -0.012..0.012, -1.0..1.0), &wood);
        for k in 0..31 {
            let z = -0.96 + 0.064 * f64::from(k);
            let deep = if k % 5 == 0 { 0.1 } else { 0.05 };
            mesh.crisp(block(0.13 - deep..0.13, 0.01..0.016, z - 0.006..z + 0.006), &dark);
        }
    })
}

/// A bow, a shank and a bit.
pub(super) fn key(a: &Ask) -> BuiltModel {
    let brass = a.main(stuff::BRASS);
    long(a, |mesh| {
        mesh.torus(block(-0.36..0.36, -0.07..0.07, -1.0..-0.3), 0.4, &brass);
        cone(mesh, at(0.0, 0.0, -0.34), at(0.0, 0.0, 1.0), [0.07, 0.07], &brass);
        mesh.torus(block(-0.12..0.12, -0.1..0.1, -0.34..-0.1), 0.6, &brass);
        for z in [0.56..0.66, 0.7..0.8, 0.86..0.96] {
            mesh.crisp(block(0.04..0.32, -0.04..0.04, z), &brass);
        }
        mesh.crisp(block(0.04..0.16, -0.04..0.04, 0.5..1.0), &brass);
    })
}

/// A back with teeth.
pub(super) fn comb(a: &Ask) -> BuiltModel {
    let horn = a.main(Stuff(Finish::Plastic, 0x3a2a20));
    long(a, |mesh| {
        mesh.rounded(block(0.02..0.2, -0.04..0.04, -1.0..1.0), 0.03, 1, &horn);
        for k in 0..30 {
            let z = -0.94 + 0.0635 * f64::from(k);
            mesh.crisp(block(-0.22..0.04, -0.025..0.025, z..z + 0.03), &horn);
        }
        for z in [-1.0..-0.95, 0.95..1.0] {
            mesh.crisp(block(-0.22..0.04, -0.03..0.03, z), &horn);
        }
    })
}

/// Two dark glasses on a bridge, the temples to the back.
pub(super) fn sunglasses(a: &Ask) -> BuiltModel {
    let frame = a.main(stuff::DARK_PLASTIC);
    let glass = of(Finish::Glass, 0x2a2622);
    small(a, |mesh| {
        for side in [-1.0, 1.0] {
            mesh.place(at(side * 0.5, 0.36, 0.9), [90.0, 0.0, 0.0], |mesh| {
                mesh.torus(block(-0.44..0.44, -0.06..0.06, -0.36..0.36), 0.2, &frame);
                blade(mesh, at(0.0, 0.0, 0.0), [0.78, 0.64], 0.04, &glass);
            });
            mesh.tube(
                &[
                    at(side * 0.92, 0.46, 0.9),
                    at(side * 0.98, 0.46, 0.8),
                    at(side * 0.98, 0.46, -0.6),
                    at(side * 0.96, 0.2, -0.95),
                ],
                0.05,
                &frame,
            );
        }
        mesh.tube(&[at(-0.12, 0.44, 0.92), at(0.0, 0.5, 0.94), at(0.12, 0.44, 0.92)], 0.05, &frame);
    })
}

/// Two tubes from the ears to one, and the disc at its end, laid in a bow.
pub(super) fn stethoscope(a: &Ask) -> BuiltModel {
    let rubber = a.main(Stuff(Finish::Rubber, 0x2f4f8f));
    let steel = stuff::CHROME.surface();
    small(a, |mesh| {
        for side in [-1.0, 1.0] {
            mesh.tube(&[at(0.0, 0.06, 0.1), at(side * 0.3, 0.06, -0.25), at(side * 0.42, 0.06, -0.55)], 0.06, &rubber);
            mesh.tube(
                &[at(side * 0.42, 0.06, -0.55), at(side * 0.4, 0.06, -0.8), at(side * 0.18, 0.06, -1.0)],
                0.035,
                &steel,
            );
            mesh.ball(
                block(side * 0.16 - 0.08..side * 0.16 + 0.08, -0.02..0.14, -1.08..-0.92),
                &stuff::DARK_PLASTIC.surface(),
            );
        }
        let tube =
            [at(0.0, 0.06, 0.08), at(0.05, 0.06, 0.5), at(0.4, 0.06, 0.8), at(0.75, 0.06, 0.6), at(0.8, 0.06, 0.2)];
        mesh.tube(&tube, 0.06, &rubber);
        mesh.drum(block(0.6..1.0, 0.0..0.12, -0.14..0.26), &steel);
        mesh.drum(block(0.66..0.94, 0.1..0.15, -0.08..0.2), &stuff::CERAMIC.surface());
    })
}

/// Folded leather with a strap and a button.
pub(super) fn wallet(a: &Ask) -> BuiltModel {
    let leather = a.main(Stuff(Finish::Leather, 0x6b4227));
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.0..0.12, -0.8..0.8), 0.05, 2, &leather);
        mesh.rounded(block(-1.0..1.0, 0.14..0.28, -0.8..0.78), 0.05, 2, &leather);
        mesh.crisp(block(-0.9..0.86, 0.1..0.16, -0.7..0.82), &of(Finish::Paper, 0x7fa878));
        mesh.crisp(block(-0.6..0.8, 0.12..0.15, -0.6..0.9), &of(Finish::Plastic, 0x2f6fa8));
        mesh.rounded(block(-0.2..0.2, 0.02..0.32, 0.4..0.86), 0.04, 1, &shade(&leather, 0.7));
        mesh.drum(block(-0.08..0.08, 0.3..0.36, 0.56..0.72), &stuff::BRASS.surface());
    })
}

/// A case with the plug at its end.
pub(super) fn usb_stick(a: &Ask) -> BuiltModel {
    let case = a.main(Stuff(Finish::Plastic, 0x2f6fa8));
    long(a, |mesh| {
        mesh.rounded(block(-0.34..0.34, -0.14..0.14, -1.0..0.4), 0.1, 2, &case);
        mesh.crisp(block(-0.24..0.24, -0.1..0.1, 0.4..1.0), &stuff::CHROME.surface());
        for x in [-0.12, 0.12] {
            mesh.crisp(block(x - 0.05..x + 0.05, 0.09..0.11, 0.65..0.78), &stuff::DARK_PLASTIC.surface());
        }
        mesh.torus(block(-0.1..0.1, 0.13..0.17, -0.9..-0.7), 0.5, &stuff::CHROME.surface());
    })
}

/// A bar with rounded edges and a name in it; a rubber is half blue.
pub(super) fn soap(a: &Ask) -> BuiltModel {
    if a.says(&["eraser", "rubber"]) {
        let rubber = a.main(Stuff(Finish::Rubber, 0xe08a90));
        return long(a, |mesh| {
            mesh.rounded(block(-0.4..0.4, -0.22..0.22, -0.1..1.0), 0.1, 2, &rubber);
            mesh.crisp(block(-0.42..0.42, -0.24..0.24, -1.0..0.3), &of(Finish::Paper, 0x2f6fa8));
            mesh.crisp(block(-0.43..0.43, -0.25..0.25, -0.5..-0.2), &stuff::WHITE.surface());
        });
    }
    let bar = a.main(Stuff(Finish::Ceramic, 0xe9c9d2));
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.0..0.6, -0.65..0.65), 0.25, 4, &bar);
        blade(mesh, at(0.0, 0.6, 0.0), [1.2, 0.7], 0.02, &shade(&bar, 0.9));
        for (x, y, z, r) in
            [(-0.7, 0.55, 0.4, 0.16), (-0.5, 0.6, 0.52, 0.1), (0.75, 0.5, 0.45, 0.12), (0.6, 0.6, -0.45, 0.14)]
        {
            mesh.bead(block(x - r..x + r, y..y + 2.0 * r, z - r..z + r), &stuff::GLASS.surface());
        }
    })
}

/// A glass tube with a bulb of red.
pub(super) fn thermometer(a: &Ask) -> BuiltModel {
    let glass = a.main(stuff::GLASS);
    long(a, |mesh| {
        cone(mesh, at(0.0, 0.0, -0.86), at(0.0, 0.0, 1.0), [0.09, 0.08], &glass);
        cone(mesh, at(0.0, 0.0, -0.95), at(0.0, 0.0, 0.3), [0.1, 0.1], &stuff::RED.surface());
        mesh.ball(block(-0.13..0.13, -0.13..0.13, -1.0..-0.74), &stuff::RED.surface());
        marks(mesh, &stuff::DARK_PLASTIC.surface());
    })
}

/// Marks of a scale around a tube.
fn marks(mesh: &mut Mesh, s: &Surface) {
    for k in 0..9 {
        let z = -0.6 + 0.17 * f64::from(k);
        cone(mesh, at(0.0, 0.0, z), at(0.0, 0.0, z + 0.02), [0.104, 0.104], s);
    }
}

/// Flat things to put something on: a mat for a mouse, a mat for a cup.
pub(super) fn mat(a: &Ask) -> BuiltModel {
    let round = a.says(&["coaster"]);
    let main = a.main(if round { Stuff(Finish::Wood, 0xb98a55) } else { Stuff(Finish::Rubber, 0x2f3f5f) });
    small(a, |mesh| {
        if round {
            mesh.drum(block(-1.0..1.0, 0.0..0.2, -1.0..1.0), &main);
            mesh.torus(block(-0.98..0.98, 0.14..0.28, -0.98..0.98), 0.16, &shade(&main, 0.7));
            for r in [0.6, 0.3] {
                mesh.torus(block(-r..r, 0.18..0.22, -r..r), 0.06, &shade(&main, 0.6));
            }
        } else {
            mesh.rounded(block(-1.0..1.0, 0.0..0.1, -0.8..0.8), 0.03, 1, &main);
            for z in [-0.76..-0.72, 0.72..0.76] {
                mesh.crisp(block(-0.96..0.96, 0.09..0.104, z), &shade(&main, 1.8));
            }
            for x in block(-0.96..-0.92, 0.09..0.104, -0.715..0.715).both_sides() {
                mesh.crisp(x, &shade(&main, 1.8));
            }
        }
    })
}
