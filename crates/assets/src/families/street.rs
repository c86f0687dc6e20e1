//! What stands outside: street lamps, hydrants, bollards, signs for wet floors, mailboxes, goals, turnstiles, scaffolds,
//! racks for bicycles, sandboxes, gazebos; and what carries people.

use super::strokes::{at, cone, of, small};
use crate::ask::Ask;
use crate::block::{block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use std::f64::consts::TAU;

/// A post with a lamp on an arm or, lower, under a hat.
pub(super) fn street_lamp(a: &Ask) -> BuiltModel {
    let iron = a.main(stuff::BLACK_STEEL);
    let glow = of(Finish::Glow, 0xfff0c8);
    small(a, |mesh| {
        mesh.lathe(block(-0.3..0.3, 0.0..0.5, -0.3..0.3), &[(1.0, 0.0), (1.0, 0.2), (0.6, 0.5), (0.4, 1.0)], 16, &iron);
        cone(mesh, at(0.0, 0.3, 0.0), at(0.0, 3.3, 0.0), [0.1, 0.07], &iron);
        for y in [0.9, 2.9] {
            mesh.torus(block(-0.14..0.14, y..y + 0.12, -0.14..0.14), 0.6, &iron);
        }
        mesh.lathe(block(-0.2..0.2, 3.3..3.4, -0.2..0.2), &[(0.5, 0.0), (1.0, 1.0)], 16, &iron);
        mesh.lathe(block(-0.28..0.28, 3.4..3.9, -0.28..0.28), &[(0.6, 0.0), (1.0, 1.0)], 8, &glow);
        mesh.lathe(block(-0.36..0.36, 3.9..4.15, -0.36..0.36), &[(1.0, 0.0), (0.4, 0.6), (0.0, 1.0)], 8, &iron);
        for k in 0..4 {
            let (sin, cos) = (TAU * (f64::from(k) + 0.5) / 4.0).sin_cos();
            mesh.rod(at(0.16 * cos, 3.38, 0.16 * sin), at(0.28 * cos, 3.92, 0.28 * sin), 0.02, &iron);
        }
        mesh.bead(block(-0.06..0.06, 4.12..4.26, -0.06..0.06), &iron);
    })
}

/// A frame with glass, a flame in it, and a ring to carry it by.
pub(super) fn lantern(a: &Ask) -> BuiltModel {
    let iron = a.main(stuff::BLACK_STEEL);
    small(a, |mesh| {
        mesh.crisp(block(-0.6..0.6, 0.0..0.12, -0.6..0.6), &iron);
        mesh.crisp(block(-0.6..0.6, 1.4..1.5, -0.6..0.6), &iron);
        for post in block(-0.56..-0.46, 0.1..1.42, 0.46..0.56).four_corners() {
            mesh.crisp(post, &iron);
        }
        for side in block(-0.53..-0.5, 0.12..1.4, -0.46..0.46).both_sides() {
            mesh.crisp(side, &stuff::GLASS.surface());
        }
        for z in [-0.53..-0.5, 0.5..0.53] {
            mesh.crisp(block(-0.46..0.46, 0.12..1.4, z), &stuff::GLASS.surface());
        }
        mesh.drum(block(-0.2..0.2, 0.12..0.7, -0.2..0.2), &of(Finish::Plastic, 0xf4ecd8));
        mesh.lathe(
            block(-0.1..0.1, 0.7..1.1, -0.1..0.1),
            &[(0.3, 0.0), (1.0, 0.3), (0.5, 0.7), (0.0, 1.0)],
            12,
            &of(Finish::Glow, 0xffb347),
        );
        mesh.taper(block(-0.6..0.6, 1.5..1.9, -0.6..0.6), block(-0.15..0.15, 1.85..1.9, -0.15..0.15), &iron);
        mesh.place(at(0.0, 2.1, 0.0), [90.0, 0.0, 0.0], |mesh| {
            mesh.torus(block(-0.28..0.28, -0.05..0.05, -0.28..0.28), 0.2, &iron)
        });
    })
}

/// A barrel with caps and a dome.
pub(super) fn hydrant(a: &Ask) -> BuiltModel {
    let red = a.main(stuff::RED);
    let steel = stuff::STEEL.surface();
    small(a, |mesh| {
        mesh.drum(block(-0.5..0.5, 0.0..0.14, -0.5..0.5), &red);
        mesh.drum(block(-0.34..0.34, 0.1..1.3, -0.34..0.34), &red);
        mesh.drum(block(-0.44..0.44, 1.26..1.4, -0.44..0.44), &red);
        mesh.lathe(
            block(-0.38..0.38, 1.4..1.75, -0.38..0.38),
            &[(1.0, 0.0), (0.85, 0.5), (0.5, 0.85), (0.0, 1.0)],
            20,
            &red,
        );
        mesh.drum(block(-0.1..0.1, 1.72..1.92, -0.1..0.1), &steel);
        for side in [-1.0, 1.0] {
            cone(mesh, at(side * 0.3, 0.9, 0.0), at(side * 0.56, 0.9, 0.0), [0.18, 0.18], &red);
            cone(mesh, at(side * 0.54, 0.9, 0.0), at(side * 0.68, 0.9, 0.0), [0.2, 0.2], &steel);
        }
        cone(mesh, at(0.0, 0.85, 0.3), at(0.0, 0.85, 0.54), [0.24, 0.24], &red);
        cone(mesh, at(0.0, 0.85, 0.52), at(0.0, 0.85, 0.64), [0.26, 0.26], &steel);
        mesh.rounded(block(-0.08..0.08, 0.77..0.93, 0.62..0.74), 0.03, 1, &steel);
    })
}

/// A post with bands.
pub(super) fn bollard(a: &Ask) -> BuiltModel {
    let iron = a.main(stuff::BLACK_STEEL);
    small(a, |mesh| {
        mesh.drum(block(-0.45..0.45, 0.0..0.1, -0.45..0.45), &iron);
        mesh.lathe(
            block(-0.3..0.3, 0.1..2.2, -0.3..0.3),
            &[(1.0, 0.0), (0.9, 0.86), (0.7, 0.96), (0.0, 1.0)],
            24,
            &iron,
        );
        for y in [1.35, 1.7] {
            mesh.drum(block(-0.31..0.31, y..y + 0.16, -0.31..0.31), &of(Finish::Paint, 0xf1f0ec));
        }
    })
}

/// Two boards that lean together, yellow, with a sign of danger.
pub(super) fn floor_sign(a: &Ask) -> BuiltModel {
    let yellow = a.main(Stuff(Finish::Plastic, 0xf0c020));
    let dark = stuff::DARK_PLASTIC.surface();
    small(a, |mesh| {
        for (turn, z) in [(-14.0, 0.5), (14.0, -0.5)] {
            mesh.place(at(0.0, 0.0, z), [turn, 0.0, 0.0], |mesh| {
                mesh.extrude(2, &[(-0.55, 0.0), (0.55, 0.0), (0.4, 1.9), (-0.4, 1.9)], -0.04..0.04, &yellow);
                let front = if z > 0.0 { 0.04..0.06 } else { -0.06..-0.04 };
                mesh.extrude(2, &[(-0.34, 0.9), (0.34, 0.9), (0.0, 1.5)], front.clone(), &dark);
                let over = if z > 0.0 { 0.06..0.075 } else { -0.075..-0.06 };
                mesh.extrude(2, &[(-0.04, 1.08), (0.04, 1.08), (0.05, 1.32), (-0.05, 1.32)], over.clone(), &yellow);
                mesh.extrude(2, &[(-0.04, 0.96), (0.04, 0.96), (0.04, 1.03), (-0.04, 1.03)], over, &yellow);
                for y in [0.35, 0.55, 0.72] {
                    mesh.crisp(block(-0.36..0.36, y..y + 0.09, front.clone()), &dark);
                }
            });
        }
        mesh.rounded(block(-0.25..0.25, 1.8..2.0, -0.1..0.1), 0.05, 1, &yellow);
    })
}

/// A head with a window and a slot for coins on a pole.
pub(super) fn parking_meter(a: &Ask) -> BuiltModel {
    let case = a.main(Stuff(Finish::Metal, 0x6f7a80));
    small(a, |mesh| {
        mesh.drum(block(-0.35..0.35, 0.0..0.08, -0.35..0.35), &case);
        mesh.rod(at(0.0, 0.0, 0.0), at(0.0, 2.2, 0.0), 0.09, &case);
        mesh.rounded(block(-0.32..0.32, 2.1..2.8, -0.22..0.22), 0.08, 2, &case);
        mesh.place(at(0.0, 2.8, 0.0), [90.0, 0.0, 0.0], |mesh| {
            mesh.drum(block(-0.32..0.32, -0.21..0.21, -0.32..0.32), &case)
        });
        mesh.place(at(0.0, 2.82, 0.2), [90.0, 0.0, 0.0], |mesh| {
            mesh.drum(block(-0.24..0.24, 0.0..0.04, -0.24..0.24), &stuff::SCREEN.surface())
        });
        mesh.rounded(block(-0.2..0.2, 2.2..2.45, 0.2..0.27), 0.03, 1, &stuff::CHROME.surface());
        mesh.crisp(block(-0.02..0.02, 2.24..2.4, 0.26..0.28), &stuff::RUBBER.surface());
    })
}

/// A box with a round back, a flap with a slot, and a flag.
pub(super) fn mailbox(a: &Ask) -> BuiltModel {
    let case = a.main(stuff::RED);
    small(a, |mesh| {
        let arch: Vec<(f64, f64)> = (0..=10)
            .map(|k| (std::f64::consts::PI * f64::from(k) / 10.0).sin_cos())
            .map(|(sin, cos)| (0.6 * cos, 1.0 + 0.4 * sin))
            .collect();
        let mut outline = vec![(-0.6, 0.0), (0.6, 0.0)];
        outline.extend(arch);
        mesh.extrude(2, &outline, -0.5..0.44, &case);
        let door: Vec<(f64, f64)> = outline.iter().map(|(x, y)| (0.92 * x, 0.05 + 0.92 * y)).collect();
        mesh.extrude(2, &door, 0.4..0.5, &shade(&case, 0.85));
        mesh.rounded(block(-0.36..0.36, 0.92..1.02, 0.48..0.54), 0.02, 1, &stuff::RUBBER.surface());
        mesh.crisp(block(-0.3..0.3, 0.4..0.75, 0.49..0.52), &stuff::PAPER.surface());
        for (x, side) in [(-0.3, 1.0), (0.3, -1.0)] {
            mesh.rod(at(x, 0.74, 0.53), at(x + 0.3 * side, 0.56, 0.53), 0.015, &stuff::DARK_PLASTIC.surface());
        }
        mesh.crisp(block(0.6..0.64, 0.5..1.2, 0.0..0.08), &stuff::BRASS.surface());
        mesh.crisp(block(0.6..0.65, 1.0..1.25, -0.05..0.3), &of(Finish::Paint, 0xe3bd3a));
    })
}

/// Two posts and a bar, and a net behind.
pub(super) fn goal(a: &Ask) -> BuiltModel {
    let paint = a.main(stuff::WHITE);
    let rope = of(Finish::Fabric, 0xc9ccd0);
    small(a, |mesh| {
        for x in [-1.5, 1.5] {
            mesh.rod(at(x, 0.0, 0.5), at(x, 2.0, 0.5), 0.06, &paint);
            mesh.tube(&[at(x, 2.0, 0.5), at(x, 1.9, 0.0), at(x, 0.0, -0.5)], 0.03, &paint);
            mesh.rod(at(x, 0.03, 0.5), at(x, 0.03, -0.5), 0.03, &paint);
        }
        mesh.rod(at(-1.56, 2.0, 0.5), at(1.56, 2.0, 0.5), 0.06, &paint);
        mesh.rod(at(-1.5, 0.03, -0.5), at(1.5, 0.03, -0.5), 0.03, &paint);
        let thin = |mesh: &mut Mesh, from, to| {
            mesh.sweep(&[(from, 0.012, 0.012), (to, 0.012, 0.012)], at(0.3, 0.9, 0.2), 4, &rope)
        };
        for k in 0..=16 {
            let x = -1.5 + 3.0 * f64::from(k) / 16.0;
            thin(mesh, at(x, 1.96, 0.46), at(x, 1.9, 0.0));
            thin(mesh, at(x, 1.9, 0.0), at(x, 0.03, -0.5));
        }
        for k in 0..=10 {
            let t = f64::from(k) / 10.0;
            thin(mesh, at(-1.5, 1.9 - 1.87 * t, -0.5 * t), at(1.5, 1.9 - 1.87 * t, -0.5 * t));
            for x in [-1.5, 1.5] {
                thin(mesh, at(x, 1.9 - 1.87 * t, -0.5 * t), at(x, 2.0 - 1.97 * t, 0.46));
            }
        }
    })
}

/// A post with three arms that turn, between two housings.
pub(super) fn turnstile(a: &Ask) -> BuiltModel {
    let steel = a.main(stuff::STEEL);
    let dark = stuff::DARK_PLASTIC.surface();
    small(a, |mesh| {
        for x in [-1.0, 0.7] {
            mesh.rounded(block(x..x + 0.3, 0.0..1.5, -0.6..0.6), 0.06, 2, &steel);
            mesh.rounded(block(x + 0.02..x + 0.28, 1.48..1.56, -0.58..0.58), 0.03, 1, &dark);
            mesh.crisp(block(x + 0.08..x + 0.22, 1.1..1.3, 0.59..0.62), &stuff::GREEN_LIGHT.surface());
        }
        let hub = at(-0.62, 1.15, 0.0);
        cone(mesh, at(-0.72, 1.15, 0.0), at(-0.56, 1.2, 0.0), [0.18, 0.14], &dark);
        for k in 0..3 {
            let (sin, cos) = (TAU * f64::from(k) / 3.0).sin_cos();
            let tip = if k == 0 { at(0.6, 1.15, 0.0) } else { hub + at(0.25, 0.7 * cos, 0.7 * sin) };
            cone(mesh, hub, tip, [0.045, 0.045], &stuff::CHROME.surface());
        }
    })
}

/// Frames of tubes with a deck of boards and braces.
pub(super) fn scaffold(a: &Ask) -> BuiltModel {
    let steel = a.main(stuff::STEEL);
    let wood = of(Finish::Wood, 0xb98a55);
    small(a, |mesh| {
        for x in [-1.0, 1.0] {
            for z in [-0.4, 0.4] {
                mesh.rod(at(x, 0.0, z), at(x, 2.6, z), 0.035, &steel);
                mesh.crisp(block(x - 0.08..x + 0.08, 0.0..0.02, z - 0.08..z + 0.08), &steel);
            }
            for y in [0.4, 0.8, 1.2, 1.6, 2.1, 2.55] {
                mesh.rod(at(x, y, -0.4), at(x, y, 0.4), 0.028, &steel);
            }
        }
        for z in [-0.4, 0.4] {
            for y in [2.1, 2.55] {
                mesh.rod(at(-1.0, y, z), at(1.0, y, z), 0.028, &steel);
            }
            mesh.rod(at(-1.0, 0.2, z), at(1.0, 1.5, z), 0.024, &steel);
            mesh.rod(at(-1.0, 1.5, z), at(1.0, 0.2, z), 0.024, &steel);
        }
        for deck in block(-1.0..1.0, 1.62..1.68, -0.38..0.38).split(2, 3, 0.02) {
            mesh.crisp(deck, &wood);
        }
        mesh.crisp(block(-1.0..1.0, 1.66..1.82, 0.38..0.41), &wood);
    })
}

/// Hoops on two rails.
pub(super) fn bike_rack(a: &Ask) -> BuiltModel {
    let steel = a.main(stuff::STEEL);
    small(a, |mesh| {
        for z in [-0.5, 0.5] {
            mesh.rod(at(-1.0, 0.05, z), at(1.0, 0.05, z), 0.05, &steel);
        }
        for k in 0..5 {
            let x = -0.9 + 0.45 * f64::from(k);
            let hoop = [
                at(x, 0.05, -0.5),
                at(x, 0.8, -0.5),
                at(x, 1.0, -0.3),
                at(x, 1.0, 0.3),
                at(x, 0.8, 0.5),
                at(x, 0.05, 0.5),
            ];
            mesh.tube(&hoop, 0.045, &steel);
        }
    })
}

/// A frame of planks with sand in it, a bucket and a shovel.
pub(super) fn sandbox(a: &Ask) -> BuiltModel {
    let wood = a.main(Stuff(Finish::Wood, 0xb98a55));
    small(a, |mesh| {
        for side in block(-1.0..-0.88, 0.0..0.3, -1.0..1.0).both_sides() {
            mesh.crisp(side, &wood);
        }
        for z in [-1.0..-0.88, 0.88..1.0] {
            mesh.crisp(block(-0.9..0.9, 0.0..0.29, z), &wood);
        }
        for corner in block(-1.0..-0.7, 0.29..0.33, 0.7..1.0).four_corners() {
            mesh.crisp(corner, &shade(&wood, 1.15));
        }
        mesh.crisp(block(-0.9..0.9, 0.0..0.16, -0.9..0.9), &of(Finish::Soil, 0xe3c88f));
        mesh.lathe(
            block(-0.6..0.2, 0.1..0.34, -0.5..0.2),
            &[(1.0, 0.0), (0.7, 0.5), (0.0, 1.0)],
            20,
            &of(Finish::Soil, 0xd9bc80),
        );
        mesh.lathe(
            block(0.3..0.6, 0.14..0.44, 0.2..0.5),
            &[(0.75, 0.0), (1.0, 1.0), (0.9, 1.0), (0.7, 0.1)],
            16,
            &stuff::RED.surface(),
        );
        mesh.rod(at(-0.1, 0.18, 0.6), at(0.3, 0.2, 0.72), 0.03, &of(Finish::Plastic, 0xe3bd3a));
        mesh.crisp(block(-0.3..-0.08, 0.16..0.19, 0.5..0.66), &of(Finish::Plastic, 0x2f6fa8));
    })
}

/// A roof on posts; of cloth where it is a canopy.
pub(super) fn gazebo(a: &Ask) -> BuiltModel {
    let cloth = a.says(&["canopy"]);
    let wood = a.main(if cloth { stuff::WHITE } else { Stuff(Finish::Wood, 0x9c6a3c) });
    let roof = a.second(if cloth { Stuff(Finish::Fabric, 0xe9e4da) } else { Stuff(Finish::Wood, 0x6b4a34) });
    let mut m = BuiltModel::default();
    let b = a.whole();
    for post in b.share(0.0..0.05, 0.0..0.74, 0.0..0.05).four_corners() {
        m.board(post, &wood);
    }
    let eaves = b.share(0.0..1.0, 0.7..0.76, 0.0..1.0);
    m.board(eaves, &roof);
    m.taper(b.share(0.02..0.98, 0.76..0.78, 0.02..0.98), b.share(0.4..0.6, 0.9..1.0, 0.4..0.6), &shade(&roof, 0.9));
    if !cloth {
        for side in b.share(0.0..0.03, 0.12..0.34, 0.05..0.95).both_sides() {
            m.solid(side);
            m.mesh.board(side.share(0.0..1.0, 0.9..1.0, 0.0..1.0), &wood);
            for bar in side.share(0.2..0.8, 0.0..0.9, 0.0..1.0).split(2, 9, 0.2) {
                m.mesh.crisp(bar.share(0.0..1.0, 0.0..1.0, 0.3..0.7), &wood);
            }
        }
        m.board(b.share(0.05..0.95, 0.31..0.34, 0.0..0.03), &wood);
    }
    m
}

/// A stair of steel, or a belt, between glass sides with rubber rails.
pub(super) fn walkway(a: &Ask) -> BuiltModel {
    let steel = a.main(stuff::STEEL);
    let (glass, rubber) = (stuff::GLASS.surface(), stuff::RUBBER.surface());
    let rises = a.says(&["escalator"]);
    let mut m = BuiltModel::default();
    let b = a.whole();
    let n = pieces(b.size().z, 0.35, 4, 20);
    let top = if rises { 0.66 } else { 0.12 };
    let height = |t: f64| if rises { 0.04 + (top - 0.04) * ((t - 0.12) / 0.76).clamp(0.0, 1.0) } else { top };
    m.solid(b);
    for k in 0..n {
        let (from, to) = (k as f64 / n as f64, (k + 1) as f64 / n as f64);
        let high = height(1.0 - (from + to) / 2.0);
        let step = b.share(0.12..0.88, 0.0..high, from..to);
        m.mesh.crisp(step, &steel);
        m.mesh.crisp(step.share(0.0..1.0, 0.99..1.004, 0.86..1.0), &of(Finish::Paint, 0xe3bd3a));
    }
    for side in [-1.0, 1.0] {
        let (size, floor) = (b.size(), b.min.y);
        let x = side * 0.45 * size.x;
        let points: Vec<(f64, f64)> =
            [0.0, 0.12, 0.88, 1.0].iter().map(|t| (b.max.z - t * size.z, floor + height(*t) * size.y)).collect();
        let rail = if rises { 0.32 } else { 0.84 } * size.y;
        for pair in points.windows(2) {
            let [(z, y), (far, high)] = [pair[0], pair[1]];
            m.mesh.extrude(
                0,
                &[(floor, z), (floor, far), (high, far), (y, z)],
                x - 0.05 * size.x..x + 0.05 * size.x,
                &shade(&steel, 0.8),
            );
            m.mesh.extrude(
                0,
                &[(y, z), (high, far), (high + rail, far), (y + rail, z)],
                x - 0.015 * size.x..x + 0.015 * size.x,
                &glass,
            );
        }
        let path: Vec<_> = points.iter().map(|(z, y)| (at(x, y + rail, *z), 0.05 * size.x, 0.04 * size.y)).collect();
        m.mesh.sweep(&path, at(0.0, 1.0, 0.0), 8, &rubber);
    }
    let drawn = std::mem::take(&mut m.mesh);
    m.mesh.stretch(b, |mesh| *mesh = drawn);
    m
}

/// Four leaves of glass on an axle, in a round case.
pub(super) fn revolving_door(a: &Ask) -> BuiltModel {
    let frame = a.main(stuff::BLACK_STEEL);
    let glass = stuff::GLASS.surface();
    small(a, |mesh| {
        for y in [0.0..0.06, 2.15..2.4] {
            mesh.drum(block(-1.1..1.1, y, -1.1..1.1), &frame);
        }
        mesh.rod(at(0.0, 0.05, 0.0), at(0.0, 2.2, 0.0), 0.05, &frame);
        for k in 0..4 {
            mesh.place(at(0.0, 0.0, 0.0), [0.0, 90.0 * f64::from(k) + 25.0, 0.0], |mesh| {
                mesh.crisp(block(0.1..0.94, 0.16..2.1, -0.012..0.012), &glass);
                for x in [0.06..0.1, 0.94..1.0] {
                    mesh.crisp(block(x, 0.08..2.15, -0.03..0.03), &frame);
                }
                for y in [0.08..0.16, 2.08..2.15] {
                    mesh.crisp(block(0.08..0.96, y, -0.029..0.029), &frame);
                }
                mesh.rod(at(0.2, 1.05, 0.06), at(0.85, 1.05, 0.06), 0.025, &stuff::CHROME.surface());
            });
        }
        // The case is open in front and behind.
        for side in [0.0, 180.0] {
            for k in -3..=3 {
                mesh.place(at(0.0, 0.0, 0.0), [0.0, side + 15.0 * f64::from(k), 0.0], |mesh| {
                    mesh.crisp(block(1.04..1.06, 0.06..2.15, -0.14..0.14), &glass)
                });
            }
            for end in [-52.5, 52.5] {
                mesh.place(at(0.0, 0.0, 0.0), [0.0, side + end, 0.0], |mesh| {
                    mesh.crisp(block(1.02..1.08, 0.06..2.15, -0.04..0.04), &frame)
                });
            }
        }
    })
}

/// Lines on the floor: the bay of a car, the fields of hopscotch, the corners of an area that stays free, a strip of stripes.
pub(super) fn floor_marking(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    m.solid(b);
    let paint = a.main(Stuff(Finish::Paint, if a.says(&["parking", "free"]) { 0xf1f0ec } else { 0xf0c020 }));
    let line = |m: &mut BuiltModel, x: [f64; 2], z: [f64; 2]| {
        m.mesh.crisp(b.share(1.0 - x[1]..1.0 - x[0], 0.0..1.0, z[0]..z[1]), &paint)
    };
    if a.says(&["parking"]) {
        line(&mut m, [0.0, 0.05], [0.0, 1.0]);
        line(&mut m, [0.95, 1.0], [0.0, 1.0]);
        line(&mut m, [0.05, 0.95], [0.0, 0.025]);
        for (x, z) in [
            ([0.4, 0.46], [0.42, 0.66]),
            ([0.46, 0.58], [0.42, 0.445]),
            ([0.46, 0.58], [0.52, 0.545]),
            ([0.54, 0.6], [0.445, 0.52]),
        ] {
            line(&mut m, x, z);
        }
    } else if a.says(&["free"]) {
        // An angle at each corner, as long on all sides and as wide as tape.
        let (w, d) = (b.size().x, b.size().z);
        let (long, tape) = (0.18 * w.min(d), 0.05_f64.min(0.1 * w.min(d)));
        for left in [true, false] {
            let share = |from: f64, to: f64| if left { [from / w, to / w] } else { [1.0 - to / w, 1.0 - from / w] };
            for (near, far) in [([0.0, tape], [tape, long]), ([d - tape, d], [d - long, d - tape])] {
                line(&mut m, share(0.0, long), near.map(|z| z / d));
                line(&mut m, share(0.0, tape), far.map(|z| z / d));
            }
        }
    } else if a.says(&["hopscotch"]) {
        let mut at = 0.0;
        for fields in [1, 2, 1, 2, 1] {
            let z = [at, at + 0.2];
            let (from, to) = if fields == 2 { (0.0, 1.0) } else { (0.25, 0.75) };
            line(&mut m, [from, from + 0.03], z);
            line(&mut m, [to - 0.03, to], z);
            line(&mut m, [from + 0.03, to - 0.03], [at, at + 0.016]);
            if fields == 2 {
                line(&mut m, [0.485, 0.515], [at + 0.016, at + 0.2]);
            }
            at += 0.2;
        }
        line(&mut m, [0.28, 0.72], [0.984, 1.0]);
    } else {
        stripes(&mut m, b, &paint);
    }
    m
}

/// A frame with slanted bars in it.
fn stripes(m: &mut BuiltModel, b: crate::block::Block, paint: &Surface) {
    for x in [0.0..0.06, 0.94..1.0] {
        m.mesh.crisp(b.share(x, 0.0..1.0, 0.0..1.0), paint);
    }
    for z in [0.0..0.06, 0.94..1.0] {
        m.mesh.crisp(b.share(0.06..0.94, 0.0..1.0, z), paint);
    }
    let at = |u: f64, v: f64| (b.min.z + v * b.size().z, b.min.x + u * b.size().x);
    for k in 0..5 {
        let u = 0.1 + 0.14 * f64::from(k);
        m.mesh.extrude(
            1,
            &[at(u, 0.94), at(u + 0.06, 0.94), at(u + 0.2, 0.06), at(u + 0.14, 0.06)],
            b.min.y..b.max.y,
            paint,
        );
    }
}
