//! Appliances that stand on a worktop or a floor: blenders, mixers, cookers, fryers, dryers, a sewing machine, a record
//! player, a typewriter, a shredder.

use super::strokes::{at, cone, of, small};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;

const RED: Stuff = Stuff(Finish::Plastic, 0xb8322c);
const CREAM: Stuff = Stuff(Finish::Plastic, 0xe8e0cf);

/// A jug with a lid and blades over a base with a dial; one for juice has a chute in its lid.
pub(super) fn blender(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::DARK_PLASTIC);
    let steel = stuff::CHROME.surface();
    small(a, |mesh| {
        mesh.lathe(block(-0.5..0.5, 0.0..0.6, -0.5..0.5), &[(1.0, 0.0), (0.95, 0.5), (0.7, 1.0)], 24, &case);
        dial(mesh, 0.28, 0.46, 0.12, &steel);
        mesh.drum(block(-0.34..0.34, 0.6..0.7, -0.34..0.34), &steel);
        let jug = [(0.66, 0.0), (1.0, 1.0), (0.94, 1.0), (0.6, 0.06)];
        mesh.lathe(block(-0.48..0.48, 0.7..1.9, -0.48..0.48), &jug, 24, &stuff::GLASS.surface());
        mesh.lathe(
            block(-0.38..0.38, 0.76..1.3, -0.38..0.38),
            &[(0.8, 0.0), (1.0, 1.0)],
            20,
            &of(Finish::Water, 0xd98a3c),
        );
        mesh.tube(&[at(0.44, 1.75, 0.0), at(0.72, 1.7, 0.0), at(0.68, 1.1, 0.0), at(0.36, 0.95, 0.0)], 0.06, &case);
        mesh.lathe(block(-0.5..0.5, 1.88..2.02, -0.5..0.5), &[(1.0, 0.0), (0.96, 1.0)], 24, &case);
        let high = if a.says(&["juicer", "processor"]) { 2.4 } else { 2.12 };
        mesh.drum(block(-0.2..0.2, 2.0..high, -0.2..0.2), &shade(&case, 1.4));
    })
}

/// A round knob on the front, with a mark.
fn dial(mesh: &mut Mesh, y: f64, z: f64, r: f64, s: &Surface) {
    mesh.disc(2, block(-r..r, y - r..y + r, z - 0.02..z + 0.06), s);
    mesh.crisp(block(-0.1 * r..0.1 * r, y..y + 0.9 * r, z + 0.06..z + 0.07), &stuff::RED.surface());
}

/// A head on an arm over a bowl.
pub(super) fn stand_mixer(a: &Ask) -> BuiltModel {
    let case = a.main(RED);
    let steel = stuff::CHROME.surface();
    small(a, |mesh| {
        mesh.rounded(block(-1.2..0.9, 0.0..0.22, -0.5..0.5), 0.2, 3, &case);
        mesh.taper(block(-1.2..-0.6, 0.2..1.4, -0.36..0.36), block(-1.1..-0.6, 1.3..1.4, -0.3..0.3), &case);
        mesh.rounded(block(-1.25..0.8, 1.3..1.95, -0.38..0.38), 0.26, 4, &case);
        mesh.disc(0, block(0.76..0.86, 1.48..1.78, -0.15..0.15), &steel);
        cone(mesh, at(0.3, 1.36, 0.0), at(0.3, 1.1, 0.0), [0.16, 0.12], &steel);
        let bowl = [(0.5, 0.0), (0.56, 0.06), (0.9, 0.5), (1.0, 1.0), (0.94, 1.0), (0.84, 0.5), (0.4, 0.12)];
        mesh.lathe(block(-0.3..0.9, 0.22..1.05, -0.6..0.6), &bowl, 24, &steel);
        for side in [-1.0, 1.0] {
            let wire = [at(0.3, 1.15, 0.0), at(0.3 + 0.26 * side, 0.8, 0.0), at(0.3, 0.4, 0.0)];
            mesh.tube(&wire, 0.03, &steel);
        }
        mesh.rod(at(-0.7, 1.66, 0.36), at(-0.7, 1.66, 0.46), 0.09, &stuff::DARK_PLASTIC.surface());
    })
}

/// A round pot with a lid, handles and a panel: rice cookers, slow cookers, pressure cookers.
pub(super) fn rice_cooker(a: &Ask) -> BuiltModel {
    let case = a.main(if a.says(&["pressure"]) { stuff::STEEL } else { CREAM });
    let dark = stuff::DARK_PLASTIC.surface();
    small(a, |mesh| {
        let pot = [(0.86, 0.0), (0.98, 0.1), (1.0, 0.8), (0.97, 1.0)];
        mesh.lathe(block(-1.0..1.0, 0.06..1.2, -1.0..1.0), &pot, 24, &case);
        mesh.drum(block(-0.8..0.8, 0.0..0.08, -0.8..0.8), &dark);
        mesh.torus(block(-1.01..1.01, 1.16..1.26, -1.01..1.01), 0.1, &stuff::CHROME.surface());
        let lid = [(1.0, 0.0), (0.8, 0.6), (0.4, 0.94), (0.0, 1.0)];
        let glass = a.says(&["slow"]);
        let top = if glass { stuff::GLASS.surface() } else { shade(&case, 0.9) };
        mesh.lathe(block(-0.97..0.97, 1.24..1.55, -0.97..0.97), &lid, 24, &top);
        mesh.lathe(block(-0.18..0.18, 1.52..1.74, -0.18..0.18), &[(0.6, 0.0), (1.0, 0.6), (0.8, 1.0)], 16, &dark);
        for side in [-1.0, 1.0] {
            mesh.rounded(block(side * 1.1 - 0.15..side * 1.1 + 0.15, 0.8..0.95, -0.3..0.3), 0.05, 1, &dark);
        }
        mesh.rounded(block(-0.36..0.36, 0.25..0.75, 0.8..1.04), 0.04, 1, &dark);
        dial(mesh, 0.5, 1.02, 0.14, &stuff::CHROME.surface());
    })
}

/// An egg of a case with a drawer that has a handle, and a display over it.
pub(super) fn air_fryer(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::DARK_PLASTIC);
    small(a, |mesh| {
        let egg = [(0.84, 0.0), (0.98, 0.15), (1.0, 0.5), (0.9, 0.85), (0.6, 1.0)];
        mesh.lathe(block(-1.0..1.0, 0.0..2.1, -1.0..1.0), &egg, 24, &case);
        mesh.rounded(block(-0.66..0.66, 0.2..1.0, 0.5..1.08), 0.12, 2, &shade(&case, 1.5));
        mesh.rounded(block(-0.14..0.14, 0.5..0.8, 1.0..1.5), 0.08, 2, &shade(&case, 0.8));
        mesh.rounded(block(-0.4..0.4, 1.25..1.7, 0.6..0.97), 0.04, 1, &stuff::CHROME.surface());
        mesh.crisp(block(-0.32..0.32, 1.34..1.6, 0.96..0.98), &stuff::SCREEN.surface());
    })
}

/// A case with a lid that has a window with a loaf below it.
pub(super) fn bread_maker(a: &Ask) -> BuiltModel {
    let case = a.main(CREAM);
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.0..1.5, -0.7..0.7), 0.14, 2, &case);
        mesh.rounded(block(-0.98..0.4, 1.46..1.68, -0.68..0.68), 0.12, 2, &shade(&case, 0.86));
        mesh.rounded(block(-0.75..0.15, 1.62..1.7, -0.42..0.42), 0.04, 1, &stuff::DARK_PLASTIC.surface());
        mesh.ball(block(-0.6..0.0, 1.6..1.74, -0.3..0.3), &of(Finish::Soil, 0xb9783a));
        mesh.crisp(block(0.5..0.9, 1.48..1.53, -0.5..0.5), &stuff::DARK_PLASTIC.surface());
        mesh.crisp(block(0.58..0.82, 1.5..1.55, -0.44..-0.1), &stuff::SCREEN.surface());
        for z in [0.05, 0.25] {
            mesh.drum(block(0.6..0.8, 1.5..1.56, z..z + 0.16), &stuff::CHROME.surface());
        }
    })
}

/// A hopper with beans over a case with a spout and a drawer.
pub(super) fn coffee_grinder(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::BLACK_STEEL);
    small(a, |mesh| {
        mesh.rounded(block(-0.5..0.5, 0.0..0.16, -0.6..0.7), 0.06, 2, &case);
        mesh.rounded(block(-0.45..0.45, 0.1..1.5, -0.6..0.1), 0.12, 2, &case);
        mesh.rounded(block(-0.42..0.42, 1.1..1.6, -0.5..0.5), 0.12, 2, &case);
        cone(mesh, at(0.0, 1.15, 0.3), at(0.0, 0.86, 0.4), [0.14, 0.1], &stuff::CHROME.surface());
        mesh.lathe(
            block(-0.28..0.28, 0.16..0.6, 0.12..0.68),
            &[(0.9, 0.0), (1.0, 1.0), (0.9, 1.0), (0.8, 0.1)],
            20,
            &stuff::STEEL.surface(),
        );
        let hopper = [(0.5, 0.0), (1.0, 0.7), (1.0, 1.0)];
        mesh.lathe(block(-0.5..0.5, 1.6..2.3, -0.5..0.5), &hopper, 24, &stuff::GLASS.surface());
        mesh.lathe(
            block(-0.42..0.42, 1.62..2.1, -0.42..0.42),
            &[(0.5, 0.0), (1.0, 1.0)],
            20,
            &of(Finish::Soil, 0x4a2c1a),
        );
        mesh.drum(block(-0.52..0.52, 2.28..2.36, -0.52..0.52), &stuff::DARK_PLASTIC.surface());
    })
}

/// A vat of oil with baskets that hang in it, their handles to the front.
pub(super) fn deep_fryer(a: &Ask) -> BuiltModel {
    let steel = a.main(stuff::STEEL);
    let dark = stuff::DARK_PLASTIC.surface();
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.0..1.2, -0.8..0.8), 0.04, 1, &steel);
        mesh.crisp(block(-1.0..1.0, 1.15..1.75, -0.8..-0.7), &steel);
        for x in [-0.5, 0.5] {
            mesh.crisp(block(x - 0.4..x + 0.4, 1.18..1.22, -0.6..0.6), &of(Finish::Water, 0xb8862c));
            for side in [-0.34, 0.3] {
                mesh.crisp(block(x + side..x + side + 0.04, 1.1..1.42, -0.5..0.45), &shade(&steel, 0.7));
            }
            for z in [-0.5, 0.41] {
                mesh.crisp(block(x - 0.34..x + 0.34, 1.1..1.42, z..z + 0.04), &shade(&steel, 0.7));
            }
            for k in 0..7 {
                let u = x - 0.26 + 0.08 * f64::from(k);
                let z = 0.3 * (f64::from(k) * 2.4).sin();
                mesh.crisp(block(u..u + 0.05, 1.3..1.36, z - 0.18..z + 0.1), &of(Finish::Soil, 0xe0b04a));
            }
            mesh.tube(&[at(x, 1.38, 0.44), at(x, 1.6, 0.7), at(x, 1.6, 1.1)], 0.04, &dark);
            mesh.disc(2, block(x - 0.12..x + 0.12, 0.85..1.09, 0.8..0.88), &dark);
            mesh.crisp(block(x - 0.36..x + 0.36, 0.12..0.7, 0.8..0.83), &shade(&steel, 0.9));
        }
    })
}

/// A flat plate to fry on, or round plates to heat on, over a case with knobs.
pub(super) fn hot_plate(a: &Ask) -> BuiltModel {
    let steel = a.main(stuff::STEEL);
    let dark = stuff::BLACK_STEEL.surface();
    let flat = a.says(&["griddle"]);
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.08..0.6, -0.8..0.8), 0.06, 2, &steel);
        for foot in block(-0.9..-0.7, 0.0..0.1, 0.5..0.7).four_corners() {
            mesh.drum(foot, &dark);
        }
        if flat {
            mesh.crisp(block(-0.94..0.94, 0.58..0.66, -0.74..0.6), &dark);
            for side in block(-1.0..-0.94, 0.5..0.85, -0.8..0.6).both_sides() {
                mesh.crisp(side, &steel);
            }
            mesh.crisp(block(-1.0..1.0, 0.5..0.9, -0.8..-0.74), &steel);
        } else {
            mesh.drum(block(-0.64..0.64, 0.58..0.68, -0.7..0.58), &dark);
            for r in [0.5, 0.34, 0.18] {
                mesh.torus(block(-r..r, 0.66..0.7, -0.06 - r..-0.06 + r), 0.1, &shade(&dark, 1.8));
            }
        }
        for x in [-0.5, 0.0, 0.5] {
            mesh.disc(2, block(x - 0.12..x + 0.12, 0.2..0.44, 0.78..0.9), &stuff::DARK_PLASTIC.surface());
        }
    })
}

/// A case with two levers over a tray, and a cone of ice cream below.
pub(super) fn ice_cream_machine(a: &Ask) -> BuiltModel {
    let steel = a.main(stuff::STEEL);
    small(a, |mesh| {
        mesh.rounded(block(-0.6..0.6, 0.0..2.0, -0.8..0.4), 0.06, 1, &steel);
        mesh.rounded(block(-0.56..0.56, 1.4..1.95, 0.3..0.55), 0.06, 1, &of(Finish::Plastic, 0xe98aa8));
        for x in [-0.3, 0.0, 0.3] {
            cone(mesh, at(x, 1.42, 0.48), at(x, 1.2, 0.48), [0.1, 0.05], &stuff::CHROME.surface());
            mesh.tube(&[at(x, 1.6, 0.54), at(x, 1.62, 0.72), at(x, 1.45, 0.78)], 0.04, &stuff::DARK_PLASTIC.surface());
        }
        mesh.rounded(block(-0.5..0.5, 0.1..0.2, 0.36..0.8), 0.03, 1, &shade(&steel, 0.7));
        mesh.lathe(
            block(-0.14..0.14, 0.2..0.66, 0.36..0.64),
            &[(0.3, 0.0), (1.0, 1.0)],
            16,
            &of(Finish::Soil, 0xc98f4c),
        );
        let cream = [(0.9, 0.0), (1.0, 0.2), (0.7, 0.34), (0.8, 0.5), (0.45, 0.64), (0.5, 0.76), (0.0, 1.0)];
        mesh.lathe(block(-0.17..0.17, 0.64..1.16, 0.33..0.67), &cream, 16, &of(Finish::Plastic, 0xfff4e0));
    })
}

/// A barrel that blows, over a grip.
pub(super) fn hair_dryer(a: &Ask) -> BuiltModel {
    let case = a.main(Stuff(Finish::Plastic, 0xc2476f));
    let dark = stuff::DARK_PLASTIC.surface();
    small(a, |mesh| {
        cone(mesh, at(-0.7, 1.6, 0.0), at(0.2, 1.6, 0.0), [0.5, 0.46], &case);
        cone(mesh, at(0.18, 1.6, 0.0), at(0.7, 1.6, 0.0), [0.4, 0.3], &case);
        cone(mesh, at(0.66, 1.6, 0.0), at(1.05, 1.6, 0.0), [0.3, 0.34], &dark);
        cone(mesh, at(-0.78, 1.6, 0.0), at(-0.68, 1.6, 0.0), [0.4, 0.44], &dark);
        mesh.sweep(&[(at(-0.3, 1.3, 0.0), 0.2, 0.26), (at(-0.14, 0.1, 0.0), 0.17, 0.2)], at(1.0, 0.0, 0.0), 14, &case);
        mesh.rounded(block(-0.06..0.1, 0.8..1.1, -0.08..0.08), 0.03, 1, &dark);
        mesh.tube(&[at(-0.14, 0.15, 0.0), at(-0.16, -0.1, 0.0), at(-0.4, -0.2, 0.0)], 0.05, &dark);
    })
}

/// A case for the wall that blows from below.
pub(super) fn hand_dryer(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::WHITE);
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.2..2.0, -0.8..0.5), 0.35, 4, &case);
        cone(mesh, at(0.0, 0.6, 0.4), at(0.0, 0.0, 0.75), [0.34, 0.28], &stuff::CHROME.surface());
        cone(mesh, at(0.0, 0.01, 0.745), at(0.0, -0.03, 0.765), [0.22, 0.22], &stuff::DARK_PLASTIC.surface());
        mesh.disc(2, block(-0.3..0.3, 1.2..1.8, 0.48..0.56), &stuff::CHROME.surface());
        for k in 0..4 {
            let y = 0.6 + 0.12 * f64::from(k);
            mesh.crisp(block(-0.8..-0.4, y..y + 0.05, 0.48..0.52), &stuff::GRAY_PLASTIC.surface());
        }
    })
}

/// An arm with a needle over a bed, a wheel at its end and a reel of thread on top.
pub(super) fn sewing_machine(a: &Ask) -> BuiltModel {
    let case = a.main(CREAM);
    let steel = stuff::CHROME.surface();
    small(a, |mesh| {
        mesh.rounded(block(-1.1..1.1, 0.0..0.3, -0.45..0.45), 0.06, 2, &case);
        mesh.rounded(block(0.45..1.0, 0.28..1.6, -0.35..0.35), 0.12, 2, &case);
        mesh.rounded(block(-1.0..1.0, 1.05..1.62, -0.32..0.32), 0.14, 3, &case);
        mesh.rounded(block(-1.05..-0.65, 0.8..1.6, -0.3..0.3), 0.1, 2, &case);
        mesh.rod(at(-0.85, 0.85, 0.0), at(-0.85, 0.34, 0.0), 0.03, &steel);
        mesh.crisp(block(-0.98..-0.72, 0.32..0.37, -0.12..0.16), &steel);
        mesh.disc(0, block(1.0..1.16, 0.95..1.55, -0.3..0.3), &stuff::DARK_PLASTIC.surface());
        dial(mesh, 1.33, 0.33, 0.16, &steel);
        mesh.rod(at(0.3, 1.6, 0.0), at(0.3, 2.05, 0.0), 0.03, &steel);
        mesh.drum(block(0.16..0.44, 1.66..1.98, -0.14..0.14), &of(Finish::Fabric, 0x3f6fb0));
        mesh.tube(
            &[at(0.2, 1.9, 0.1), at(-0.4, 1.75, 0.2), at(-0.85, 1.66, 0.28), at(-0.85, 0.5, 0.06)],
            0.012,
            &of(Finish::Fabric, 0x3f6fb0),
        );
    })
}

/// A record on a platter, with an arm.
pub(super) fn record_player(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::WALNUT);
    let steel = stuff::CHROME.surface();
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.1..0.42, -0.8..0.8), 0.04, 1, &case);
        for foot in block(-0.9..-0.66, 0.0..0.12, 0.48..0.72).four_corners() {
            mesh.drum(foot, &stuff::RUBBER.surface());
        }
        mesh.drum(block(-0.92..0.52, 0.42..0.5, -0.72..0.72), &steel);
        mesh.drum(block(-0.88..0.48, 0.49..0.53, -0.68..0.68), &of(Finish::Plastic, 0x141416));
        for r in [0.58, 0.42] {
            mesh.torus(block(-0.2 - r..-0.2 + r, 0.52..0.54, -r..r), 0.03, &of(Finish::Plastic, 0x3a3a3e));
        }
        mesh.drum(block(-0.42..0.02, 0.52..0.55, -0.22..0.22), &stuff::RED.surface());
        mesh.rod(at(-0.2, 0.5, 0.0), at(-0.2, 0.62, 0.0), 0.03, &steel);
        mesh.drum(block(0.62..0.9, 0.42..0.62, -0.64..-0.36), &stuff::DARK_PLASTIC.surface());
        mesh.tube(&[at(0.76, 0.7, -0.7), at(0.76, 0.7, 0.1), at(0.3, 0.66, 0.42)], 0.03, &steel);
        mesh.rounded(block(0.2..0.38, 0.54..0.66, 0.38..0.5), 0.02, 1, &stuff::DARK_PLASTIC.surface());
        mesh.drum(block(0.7..0.82, 0.42..0.48, 0.5..0.62), &steel);
    })
}

/// Rows of round keys, the carriage with its roller, and a sheet.
pub(super) fn typewriter(a: &Ask) -> BuiltModel {
    let case = a.main(Stuff(Finish::Paint, 0x2f4f4a));
    small(a, |mesh| {
        mesh.taper(block(-0.9..0.9, 0.0..0.3, -0.8..0.9), block(-0.85..0.85, 0.2..0.3, -0.8..0.85), &case);
        mesh.taper(block(-0.85..0.85, 0.3..0.8, -0.8..0.2), block(-0.7..0.7, 0.7..0.8, -0.8..-0.2), &case);
        for row in 0..4 {
            let (y, z) = (0.54 - 0.08 * f64::from(row), 0.2 + 0.17 * f64::from(row));
            for k in 0..9 {
                let x = -0.64 + 0.15 * f64::from(k) + 0.04 * f64::from(row % 2);
                mesh.lathe(
                    block(x..x + 0.11, y - 0.24..y, z..z + 0.11),
                    &[(1.0, 0.0), (1.0, 1.0)],
                    8,
                    &stuff::CERAMIC.surface(),
                );
            }
        }
        mesh.rounded(block(-0.5..0.5, 0.3..0.36, 0.86..0.96), 0.02, 1, &stuff::CERAMIC.surface());
        cone(mesh, at(-1.0, 0.95, -0.5), at(1.0, 0.95, -0.5), [0.14, 0.14], &stuff::RUBBER.surface());
        for side in [-1.0, 1.0] {
            cone(mesh, at(side, 0.95, -0.5), at(side * 1.12, 0.95, -0.5), [0.1, 0.1], &stuff::CHROME.surface());
        }
        mesh.crisp(block(-0.6..0.6, 0.9..1.6, -0.66..-0.64), &stuff::PAPER.surface());
        for k in 0..4 {
            let y = 1.16 + 0.1 * f64::from(k);
            mesh.crisp(
                block(-0.48..0.44 - 0.1 * f64::from(k), y..y + 0.025, -0.64..-0.635),
                &stuff::DARK_PLASTIC.surface(),
            );
        }
    })
}

/// A bin with a head that has a slot; strips hang below a sheet.
pub(super) fn paper_shredder(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::DARK_PLASTIC);
    small(a, |mesh| {
        mesh.taper(block(-0.8..0.8, 0.0..1.4, -0.55..0.55), block(-0.9..0.9, 1.3..1.4, -0.6..0.6), &shade(&case, 1.6));
        mesh.crisp(block(-0.5..0.5, 0.3..1.1, 0.5..0.63), &stuff::GLASS.surface());
        for k in 0..9 {
            let x = -0.44 + 0.1 * f64::from(k);
            mesh.crisp(block(x..x + 0.06, 0.36..0.9 - 0.06 * f64::from(k % 3), 0.6..0.635), &stuff::PAPER.surface());
        }
        mesh.rounded(block(-0.95..0.95, 1.38..1.8, -0.65..0.65), 0.12, 2, &case);
        mesh.crisp(block(-0.7..0.7, 1.78..1.82, -0.1..0.1), &stuff::RUBBER.surface());
        mesh.crisp(block(-0.55..0.55, 1.7..2.3, -0.015..0.015), &stuff::PAPER.surface());
        mesh.disc(2, block(0.6..0.76, 1.5..1.66, 0.64..0.68), &stuff::GREEN_LIGHT.surface());
    })
}

/// A tower with slots all around its foot and a panel on top.
pub(super) fn air_purifier(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::WHITE);
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.0..2.0, -1.0..1.0), 0.3, 3, &case);
        for k in 0..9 {
            let y = 0.25 + 0.1 * f64::from(k);
            mesh.crisp(block(-0.66..0.66, y..y + 0.05, 0.98..1.02), &stuff::GRAY_PLASTIC.surface());
        }
        mesh.disc(2, block(-0.22..0.22, 1.4..1.84, 0.98..1.03), &stuff::SCREEN.surface());
        for k in 0..5 {
            let x = -0.6 + 0.26 * f64::from(k);
            mesh.crisp(block(x..x + 0.14, 1.98..2.02, -0.6..0.6), &stuff::DARK_PLASTIC.surface());
        }
    })
}
