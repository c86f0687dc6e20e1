//! Curious things: an hourglass, a hookah, a safe, swords and shields, a skull, binoculars, a model of houses.

use super::strokes::{at, blade, cone, headed, long, of, small};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::BuiltModel;
use std::f64::consts::TAU;

/// Two bulbs of glass with sand, between plates on posts.
pub(super) fn hourglass(a: &Ask) -> BuiltModel {
    let wood = a.main(stuff::WALNUT);
    let sand = of(Finish::Soil, 0xd9b36a);
    small(a, |mesh| {
        for y in [0.0..0.12, 2.08..2.2] {
            mesh.drum(block(-0.7..0.7, y, -0.7..0.7), &wood);
        }
        let glass = [(0.9, 0.0), (1.0, 0.14), (0.8, 0.34), (0.12, 0.5), (0.8, 0.66), (1.0, 0.86), (0.9, 1.0)];
        mesh.lathe(block(-0.52..0.52, 0.12..2.08, -0.52..0.52), &glass, 24, &stuff::GLASS.surface());
        mesh.lathe(block(-0.46..0.46, 0.13..0.6, -0.46..0.46), &[(0.95, 0.0), (1.0, 0.2), (0.0, 1.0)], 20, &sand);
        mesh.lathe(block(-0.36..0.36, 1.14..1.5, -0.36..0.36), &[(0.1, 0.0), (0.9, 0.9), (1.0, 1.0)], 20, &sand);
        for k in 0..4 {
            let (sin, cos) = (TAU * (f64::from(k) + 0.5) / 4.0).sin_cos();
            mesh.rod(at(0.6 * cos, 0.1, 0.6 * sin), at(0.6 * cos, 2.1, 0.6 * sin), 0.05, &wood);
        }
    })
}

/// A vase of glass, a stem, a bowl, and the hose.
pub(super) fn hookah(a: &Ask) -> BuiltModel {
    let glass = a.main(Stuff(Finish::Glass, 0x3f5fa0));
    let brass = stuff::BRASS.surface();
    small(a, |mesh| {
        mesh.lathe(
            block(-0.4..0.4, 0.0..0.9, -0.4..0.4),
            &[(0.9, 0.0), (1.0, 0.1), (0.9, 0.4), (0.4, 0.75), (0.36, 1.0)],
            24,
            &glass,
        );
        mesh.lathe(
            block(-0.12..0.12, 0.86..2.0, -0.12..0.12),
            &[(1.0, 0.0), (0.5, 0.1), (0.9, 0.3), (0.4, 0.5), (0.8, 0.7), (0.4, 0.9), (0.6, 1.0)],
            16,
            &brass,
        );
        mesh.lathe(block(-0.3..0.3, 1.96..2.04, -0.3..0.3), &[(0.4, 0.0), (1.0, 1.0)], 24, &brass);
        mesh.lathe(
            block(-0.16..0.16, 2.02..2.34, -0.16..0.16),
            &[(0.5, 0.0), (1.0, 0.7), (0.9, 1.0)],
            16,
            &of(Finish::Ceramic, 0xa5523a),
        );
        let hose = [
            at(0.08, 1.0, 0.0),
            at(0.36, 1.1, 0.0),
            at(0.46, 0.7, 0.2),
            at(0.42, 0.3, 0.4),
            at(0.2, 0.7, 0.5),
            at(0.0, 1.2, 0.46),
        ];
        mesh.tube(&hose, 0.04, &of(Finish::Fabric, 0x8a2432));
        cone(mesh, at(0.0, 1.2, 0.46), at(-0.12, 1.56, 0.4), [0.05, 0.03], &brass);
    })
}

/// A box of steel with a door, a dial and a wheel to open it.
pub(super) fn safe(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let steel = a.main(Stuff(Finish::Paint, 0x4a5257));
    let (chrome, dark) = (stuff::CHROME.surface(), stuff::DARK_PLASTIC.surface());
    for foot in b.share(0.04..0.16, 0.0..0.05, 0.06..0.18).four_corners() {
        m.board(foot, &dark);
    }
    m.rounded(b.share(0.0..1.0, 0.05..1.0, 0.0..0.86), 0.015, &steel);
    let door = b.share(0.08..0.92, 0.12..0.93, 0.86..0.91);
    m.board(door, &shade(&steel, 1.25));
    for hinge in [0.2..0.3, 0.75..0.85] {
        m.board(b.share(0.02..0.08, hinge, 0.86..0.92), &chrome);
    }
    let s = door.size();
    let r = (0.11 * s.x).min(0.11 * s.y);
    let front = b.max.z;
    let wheel = |x: f64, y: f64, r: f64| {
        let c = at(door.min.x + x * s.x, door.min.y + y * s.y, 0.0);
        block(c.x - r..c.x + r, c.y - r..c.y + r, door.max.z..front)
    };
    let dial = wheel(0.5, 0.7, r);
    m.disc(2, dial, &dark);
    m.mesh.disc(2, dial.share(0.2..0.8, 0.2..0.8, 0.9..1.0).z(front - 0.1 * dial.size().z..front), &chrome);
    let hub = wheel(0.5, 0.34, 1.5 * r);
    m.solid(hub);
    m.mesh.stretch(hub, |mesh| {
        mesh.place(at(0.0, 0.0, 0.0), [90.0, 0.0, 0.0], |mesh| {
            mesh.torus(block(-1.0..1.0, 0.6..1.0, -1.0..1.0), 0.2, &chrome);
            mesh.drum(block(-0.24..0.24, 0.0..1.0, -0.24..0.24), &chrome);
            for turn in [0.0, 60.0, 120.0] {
                mesh.place(at(0.0, 0.8, 0.0), [0.0, turn, 0.0], |mesh| {
                    mesh.rod(at(-0.9, 0.0, 0.0), at(0.9, 0.0, 0.0), 0.09, &chrome)
                });
            }
        });
    });
    m
}

/// A blade, a guard, a grip and a pommel; its point is down where it hangs.
pub(super) fn sword(a: &Ask) -> BuiltModel {
    let steel = a.main(Stuff(Finish::Metal, 0xb4bac0));
    let brass = stuff::BRASS.surface();
    long(a, |mesh| {
        mesh.extrude(
            1,
            &[(-1.0, 0.0), (-0.86, 0.065), (0.48, 0.075), (0.48, -0.075), (-0.86, -0.065)],
            -0.014..0.014,
            &steel,
        );
        mesh.extrude(
            1,
            &[(-0.8, 0.012), (0.48, 0.016), (0.48, -0.016), (-0.8, -0.012)],
            -0.02..0.02,
            &shade(&steel, 0.7),
        );
        mesh.rounded(block(-0.26..0.26, -0.035..0.035, 0.46..0.54), 0.03, 2, &brass);
        cone(mesh, at(0.0, 0.0, 0.53), at(0.0, 0.0, 0.86), [0.034, 0.04], &of(Finish::Leather, 0x4a2e1e));
        mesh.ball(block(-0.07..0.07, -0.06..0.06, 0.84..1.0), &brass);
    })
}

/// A shield with a point below, a cross and a boss.
pub(super) fn shield(a: &Ask) -> BuiltModel {
    let paint = a.main(Stuff(Finish::Paint, 0x9c2b2e));
    let steel = stuff::STEEL.surface();
    small(a, |mesh| {
        let outline = |by: f64| -> Vec<(f64, f64)> {
            [
                (-0.76, 1.0),
                (0.76, 1.0),
                (0.76, 0.2),
                (0.62, -0.3),
                (0.34, -0.72),
                (0.0, -1.0),
                (-0.34, -0.72),
                (-0.62, -0.3),
                (-0.76, 0.2),
            ]
            .map(|(x, y)| (by * x, by * y + 0.06 * (1.0 - by)))
            .to_vec()
        };
        mesh.extrude(2, &outline(1.0), 0.0..0.08, &steel);
        mesh.extrude(2, &outline(0.9), 0.04..0.11, &paint);
        mesh.crisp(block(-0.1..0.1, -0.78..0.9, 0.08..0.13), &of(Finish::Paint, 0xe3c25a));
        mesh.crisp(block(-0.66..0.66, 0.3..0.5, 0.08..0.132), &of(Finish::Paint, 0xe3c25a));
        mesh.ball(block(-0.2..0.2, 0.2..0.6, -0.02..0.24), &steel);
    })
}

/// A skull that looks to +z.
pub(super) fn skull(a: &Ask) -> BuiltModel {
    let bone = a.main(Stuff(Finish::Ceramic, 0xdccfae));
    let dark = of(Finish::Paint, 0x2b2420);
    small(a, |mesh| {
        mesh.ball(block(-0.7..0.7, 0.5..2.0, -1.0..0.7), &bone);
        mesh.rounded(block(-0.44..0.44, 0.24..0.9, -0.1..0.76), 0.16, 2, &bone);
        mesh.rounded(block(-0.4..0.4, 0.0..0.24, -0.1..0.74), 0.1, 2, &shade(&bone, 0.9));
        for side in [-1.0, 1.0] {
            mesh.ball(block(-0.19..0.19, 0.82..1.2, 0.4..0.78).moved(side * 0.28, 0.0, 0.0), &dark);
            mesh.ball(block(-0.14..0.14, 0.56..0.86, 0.1..0.6).moved(side * 0.52, 0.0, 0.0), &bone);
        }
        mesh.extrude(2, &[(-0.1, 0.58), (0.1, 0.58), (0.0, 0.82)], 0.6..0.79, &dark);
        for tooth in block(-0.3..0.3, 0.2..0.36, 0.7..0.8).split(0, 7, 0.02) {
            mesh.crisp(tooth, &stuff::SHEET.surface());
        }
    })
}

/// Two tubes with a bridge.
pub(super) fn binoculars(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::DARK_PLASTIC);
    headed(a, |mesh| {
        for x in [-0.36, 0.36] {
            cone(mesh, at(x, 0.3, -0.8), at(x, 0.3, -0.5), [0.19, 0.16], &shade(&case, 1.4));
            cone(mesh, at(x, 0.3, -0.55), at(x, 0.3, 0.1), [0.22, 0.24], &case);
            cone(mesh, at(x, 0.3, 0.08), at(x, 0.3, 0.8), [0.24, 0.3], &case);
            cone(mesh, at(x, 0.3, 0.72), at(x, 0.3, 0.84), [0.31, 0.31], &shade(&case, 1.4));
            cone(mesh, at(x, 0.3, 0.8), at(x, 0.3, 0.855), [0.26, 0.26], &of(Finish::Glass, 0x6f8fc0));
        }
        mesh.rounded(block(-0.3..0.3, 0.24..0.4, -0.36..-0.2), 0.03, 1, &case);
        mesh.rounded(block(-0.3..0.3, 0.24..0.4, 0.04..0.2), 0.03, 1, &case);
        cone(mesh, at(0.0, 0.34, -0.46), at(0.0, 0.34, 0.1), [0.09, 0.09], &stuff::STEEL.surface());
    })
}

/// A barrel with marks, a plunger and a needle; a pipette has a bulb and a long point.
pub(super) fn syringe(a: &Ask) -> BuiltModel {
    let pipette = a.says(&["pipette", "dropper"]);
    let glass = a.main(stuff::GLASS);
    let steel = stuff::STEEL.surface();
    long(a, |mesh| {
        if pipette {
            mesh.sweep(
                &[
                    (at(0.0, 0.0, -1.0), 0.05, 0.05),
                    (at(0.0, 0.0, -0.9), 0.16, 0.16),
                    (at(0.0, 0.0, -0.6), 0.17, 0.17),
                    (at(0.0, 0.0, -0.5), 0.09, 0.09),
                ],
                at(0.0, 1.0, 0.0),
                12,
                &stuff::RED.surface(),
            );
            cone(mesh, at(0.0, 0.0, -0.52), at(0.0, 0.0, 0.5), [0.08, 0.08], &glass);
            cone(mesh, at(0.0, 0.0, 0.5), at(0.0, 0.0, 1.0), [0.08, 0.02], &glass);
            cone(mesh, at(0.0, 0.0, 0.0), at(0.0, 0.0, 0.48), [0.06, 0.06], &of(Finish::Water, 0x4f8fc0));
            return;
        }
        cone(mesh, at(0.0, 0.0, -0.3), at(0.0, 0.0, 0.5), [0.15, 0.15], &glass);
        cone(mesh, at(0.0, 0.0, 0.0), at(0.0, 0.0, 0.48), [0.125, 0.125], &of(Finish::Water, 0x4f8fc0));
        cone(mesh, at(0.0, 0.0, -0.1), at(0.0, 0.0, 0.0), [0.13, 0.13], &stuff::DARK_PLASTIC.surface());
        cone(mesh, at(0.0, 0.0, -0.95), at(0.0, 0.0, -0.05), [0.04, 0.04], &stuff::PLASTIC.surface());
        cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, -0.94), [0.15, 0.15], &stuff::GRAY_PLASTIC.surface());
        mesh.rounded(block(-0.28..0.28, -0.06..0.06, -0.33..-0.27), 0.02, 1, &stuff::GRAY_PLASTIC.surface());
        cone(mesh, at(0.0, 0.0, 0.5), at(0.0, 0.0, 0.64), [0.06, 0.04], &of(Finish::Plastic, 0xe08a3a));
        cone(mesh, at(0.0, 0.0, 0.62), at(0.0, 0.0, 1.0), [0.014, 0.008], &steel);
        for k in 0..5 {
            let z = -0.18 + 0.14 * f64::from(k);
            mesh.crisp(block(-0.06..0.06, 0.14..0.156, z..z + 0.02), &stuff::DARK_PLASTIC.surface());
        }
    })
}

/// Houses and trees of card on a board.
pub(super) fn architectural_model(a: &Ask) -> BuiltModel {
    let card = a.main(Stuff(Finish::Paper, 0xded8cb));
    let leaf = stuff::LEAF.surface();
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.0..0.07, -0.75..0.75), 0.01, 1, &stuff::OAK.surface());
        mesh.crisp(block(-0.94..0.94, 0.06..0.08, -0.7..0.7), &of(Finish::Paper, 0x9fae86));
        mesh.crisp(block(-0.94..0.94, 0.06..0.085, -0.06..0.08), &of(Finish::Paper, 0x9a9a98));
        mesh.crisp(block(-0.1..0.06, 0.06..0.084, -0.7..0.7), &of(Finish::Paper, 0x9a9a98));
        for (x, z, w, d, h) in [
            (-0.8, -0.6, 0.3, 0.4, 0.9),
            (-0.42, -0.55, 0.24, 0.3, 0.42),
            (0.2, -0.6, 0.5, 0.3, 0.55),
            (0.66, 0.2, 0.24, 0.4, 0.74),
        ] {
            let house = block(x..x + w, 0.08..h, z..z + d);
            mesh.crisp(house, &card);
            let floors = ((h - 0.08) / 0.13) as usize;
            for floor in house.z(house.max.z..house.max.z + 0.008).split(1, floors.max(1), 0.05) {
                for window in floor.split(0, 3, 0.04) {
                    mesh.crisp(window.inset(0.01, 0.01, 0.0), &of(Finish::Screen, 0x5f7f97));
                }
            }
        }
        for x in [-0.8, -0.42, 0.18] {
            let house = block(x..x + 0.26, 0.08..0.28, 0.24..0.5);
            mesh.crisp(house, &card);
            mesh.extrude(
                2,
                &[(x - 0.03, 0.28), (x + 0.29, 0.28), (x + 0.13, 0.46)],
                0.22..0.52,
                &of(Finish::Paper, 0xb5553f),
            );
        }
        for (x, z) in [(-0.2, -0.3), (-0.2, 0.3), (0.12, 0.6), (0.5, 0.3), (0.84, -0.3), (-0.6, 0.62), (0.84, -0.6)] {
            mesh.rod(at(x, 0.07, z), at(x, 0.16, z), 0.012, &stuff::WALNUT.surface());
            mesh.bead(block(-0.06..0.06, 0.14..0.28, -0.06..0.06).moved(x, 0.0, z), &leaf);
        }
    })
}

/// A shackle and a body with a keyhole.
pub(super) fn padlock(a: &Ask) -> BuiltModel {
    let brass = a.main(Stuff(Finish::Brass, 0xc9a040));
    small(a, |mesh| {
        mesh.rounded(block(-0.5..0.5, 0.0..0.9, -0.2..0.2), 0.08, 2, &brass);
        let bow = [
            at(-0.32, 0.8, 0.0),
            at(-0.32, 1.2, 0.0),
            at(-0.22, 1.46, 0.0),
            at(0.0, 1.54, 0.0),
            at(0.22, 1.46, 0.0),
            at(0.32, 1.2, 0.0),
            at(0.32, 0.8, 0.0),
        ];
        mesh.tube(&bow, 0.09, &stuff::CHROME.surface());
        mesh.disc(2, block(-0.1..0.1, 0.4..0.6, 0.18..0.22), &stuff::DARK_PLASTIC.surface());
        mesh.crisp(block(-0.04..0.04, 0.2..0.46, 0.18..0.205), &stuff::DARK_PLASTIC.surface());
    })
}

/// Four triangles that meet in a point, with the courses of its stones.
pub(super) fn pyramid(a: &Ask) -> BuiltModel {
    let stone = a.main(Stuff(Finish::Stone, 0xcfa860));
    small(a, |mesh| {
        mesh.taper(block(-1.0..1.0, 0.0..0.01, -1.0..1.0), block(-0.004..0.004, 1.49..1.5, -0.004..0.004), &stone);
    })
}

/// A balloon on its string.
pub(super) fn balloon(a: &Ask) -> BuiltModel {
    let skin = a.main(Stuff(Finish::Rubber, 0xd8403f));
    small(a, |mesh| {
        mesh.lathe(
            block(-1.0..1.0, 1.0..3.4, -1.0..1.0),
            &[(0.03, 0.0), (0.3, 0.06), (0.75, 0.26), (1.0, 0.6), (0.86, 0.84), (0.5, 0.97), (0.0, 1.0)],
            24,
            &skin,
        );
        mesh.lathe(block(-0.14..0.14, 0.86..1.02, -0.14..0.14), &[(1.0, 0.0), (0.3, 1.0)], 12, &skin);
        mesh.tube(
            &[at(0.0, 0.9, 0.0), at(0.1, 0.6, 0.0), at(-0.08, 0.3, 0.03), at(0.0, 0.0, 0.0)],
            0.02,
            &stuff::SHEET.surface(),
        );
    })
}

/// A sack with a tied neck, full.
pub(super) fn sack(a: &Ask) -> BuiltModel {
    let cloth = a.main(Stuff(Finish::Fabric, 0xb99a6b));
    small(a, |mesh| {
        let body = [
            (0.8, 0.0),
            (0.95, 0.06),
            (1.0, 0.3),
            (0.9, 0.6),
            (0.6, 0.76),
            (0.26, 0.84),
            (0.3, 0.9),
            (0.5, 1.0),
            (0.3, 0.97),
        ];
        mesh.lathe(block(-1.0..1.0, 0.0..2.6, -0.8..0.8), &body, 24, &cloth);
        mesh.torus(block(-0.32..0.32, 2.12..2.26, -0.26..0.26), 0.4, &of(Finish::Fabric, 0x6b4a2a));
        mesh.rod(at(0.2, 2.18, 0.2), at(0.4, 1.9, 0.42), 0.04, &of(Finish::Fabric, 0x6b4a2a));
        blade(mesh, at(0.0, 0.01, 0.0), [1.5, 1.2], 0.02, &cloth);
    })
}
