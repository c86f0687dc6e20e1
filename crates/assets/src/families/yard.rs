//! What stands in gardens and playgrounds: tents, fountains, swings, little houses, figures of snow and straw, wood and stone.

use super::strokes::{at, cone, headed, of, round, small};
use crate::ask::Ask;
use crate::block::{block, pieces};
use crate::loft::oval;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use std::f64::consts::TAU;

/// A tent with a ridge, a teepee of poles, an igloo.
pub(super) fn tent(a: &Ask) -> BuiltModel {
    if a.says(&["igloo"]) {
        let snow = a.main(Stuff(Finish::Plaster, 0xdbe6ec));
        return small(a, |mesh| {
            let joint = shade(&snow, 0.8);
            mesh.lathe(
                block(-1.0..1.0, 0.0..0.96, -1.0..1.0),
                &[(1.0, 0.0), (0.98, 0.25), (0.87, 0.55), (0.64, 0.82), (0.35, 0.96), (0.0, 1.0)],
                24,
                &snow,
            );
            for (y, r) in [(0.2, 0.995), (0.42, 0.93), (0.64, 0.82), (0.82, 0.6)] {
                mesh.torus(block(-r..r, y - 0.012..y + 0.012, -r..r), 0.03, &joint);
            }
            for (half, top, z, s) in
                [(0.42, 0.5, 0.7..1.3, &snow), (0.28, 0.36, 1.2..1.32, &of(Finish::Paint, 0x2e3a44))]
            {
                let arch = |k: u32| (TAU * f64::from(k) / 20.0).sin_cos();
                let arch: Vec<(f64, f64)> =
                    (0..=10).map(arch).map(|(sin, cos)| (half * cos, top * sin.max(0.0))).collect();
                mesh.extrude(2, &arch, z, s);
            }
        });
    }
    if a.says(&["teepee", "tipi", "wigwam"]) {
        let cloth = a.main(Stuff(Finish::Fabric, 0xd9c39a));
        return small(a, |mesh| {
            mesh.lathe(block(-0.9..0.9, 0.0..1.6, -0.9..0.9), &[(1.0, 0.0), (0.08, 1.0)], 8, &cloth);
            for k in 0..6 {
                let (sin, cos) = (TAU * (f64::from(k) + 0.25) / 6.0).sin_cos();
                mesh.rod(
                    at(0.94 * cos, 0.02, 0.94 * sin),
                    at(-0.22 * cos, 2.0, -0.22 * sin),
                    0.03,
                    &stuff::OAK.surface(),
                );
            }
            let flap = [at(-0.26, 0.0, 0.9), at(0.26, 0.0, 0.9), at(0.0, 0.95, 0.42)];
            opening(mesh, flap, &of(Finish::Fabric, 0x4a3a2c));
        });
    }
    let cloth = a.main(Stuff(Finish::Fabric, 0xc96a3a));
    headed(a, |mesh| {
        mesh.extrude(2, &[(-1.0, 0.0), (1.0, 0.0), (0.0, 1.4)], -1.0..1.0, &cloth);
        opening(mesh, [at(-0.42, 0.0, 1.0), at(0.42, 0.0, 1.0), at(0.0, 1.15, 1.0)], &of(Finish::Fabric, 0x3a2c24));
        mesh.rod(at(0.0, 1.38, -1.04), at(0.0, 1.38, 1.06), 0.03, &stuff::OAK.surface());
        for side in [-1.0, 1.0] {
            mesh.extrude(
                1,
                &[(1.0, side * 0.4), (1.06, side * 0.4), (1.05, side * 0.95), (1.0, side * 0.95)],
                0.0..0.08,
                &shade(&cloth, 0.8),
            );
        }
    })
}

/// A dark triangle before a wall of cloth, a little out of it towards +z.
fn opening(mesh: &mut Mesh, corners: [scenelang_layout::Vec3; 3], s: &Surface) {
    let [p, q, r] = corners;
    let out = |v: scenelang_layout::Vec3, by: f64| at(v.x, v.y, v.z + by);
    let ring = |by: f64| vec![out(p, by), out(q, by), out(r, by)];
    mesh.loft(&[ring(0.03), ring(-0.05)], s);
}

/// A basin, a column and a smaller bowl, with water in both.
pub(super) fn fountain(a: &Ask) -> BuiltModel {
    let stone = a.main(Stuff(Finish::Stone, 0xb9b2a4));
    let water = of(Finish::Water, 0x6fb7cf);
    small(a, |mesh| {
        mesh.lathe(
            block(-1.0..1.0, 0.0..0.42, -1.0..1.0),
            &[(0.96, 0.0), (1.0, 0.1), (0.95, 0.2), (0.97, 0.8), (1.0, 1.0), (0.86, 1.0), (0.84, 0.4)],
            24,
            &stone,
        );
        mesh.drum(block(-0.85..0.85, 0.2..0.34, -0.85..0.85), &water);
        mesh.lathe(
            block(-0.2..0.2, 0.15..0.85, -0.2..0.2),
            &[(1.0, 0.0), (0.8, 0.2), (0.6, 0.5), (0.7, 0.9), (1.0, 1.0)],
            16,
            &stone,
        );
        mesh.lathe(
            block(-0.5..0.5, 0.82..1.06, -0.5..0.5),
            &[(0.3, 0.0), (0.7, 0.3), (1.0, 0.9), (1.0, 1.0), (0.9, 1.0), (0.6, 0.5)],
            24,
            &stone,
        );
        mesh.drum(block(-0.44..0.44, 0.96..1.03, -0.44..0.44), &water);
        mesh.lathe(
            block(-0.1..0.1, 1.0..1.3, -0.1..0.1),
            &[(1.0, 0.0), (0.6, 0.3), (0.9, 0.6), (0.0, 1.0)],
            12,
            &stone,
        );
        for k in 0..8 {
            let (sin, cos) = (TAU * f64::from(k) / 8.0).sin_cos();
            let jet =
                [at(0.05 * cos, 1.24, 0.05 * sin), at(0.2 * cos, 1.38, 0.2 * sin), at(0.38 * cos, 1.02, 0.38 * sin)];
            mesh.tube(&jet, 0.02, &water);
            let fall =
                [at(0.48 * cos, 1.04, 0.48 * sin), at(0.58 * cos, 0.9, 0.58 * sin), at(0.64 * cos, 0.3, 0.64 * sin)];
            mesh.tube(&fall, 0.02, &water);
        }
    })
}

/// A ring of stones with logs and a flame.
pub(super) fn fire_pit(a: &Ask) -> BuiltModel {
    let stone = a.main(Stuff(Finish::Stone, 0x7f7a72));
    let bark = of(Finish::Wood, 0x5a3d28);
    small(a, |mesh| {
        for k in 0..12 {
            let tint = shade(&stone, [1.0, 0.85, 1.2][k % 3]);
            mesh.place(at(0.0, 0.0, 0.0), [0.0, 30.0 * k as f64, 0.0], |mesh| {
                mesh.rounded(block(0.68..1.0, 0.0..0.34, -0.21..0.21), 0.09, 2, &tint);
            });
        }
        mesh.drum(block(-0.72..0.72, 0.0..0.08, -0.72..0.72), &stuff::SOIL.surface());
        for k in 0..5 {
            let (sin, cos) = (TAU * f64::from(k) / 5.0).sin_cos();
            mesh.rod(at(0.5 * cos, 0.1, 0.5 * sin), at(-0.06 * cos, 0.52, -0.06 * sin), 0.07, &bark);
        }
        for k in 0..6 {
            let (sin, cos) = (f64::from(k) * 2.4).sin_cos();
            let r = if k == 0 { 0.0 } else { 0.16 };
            let tip = if k == 0 { 0.98 } else { 0.66 + 0.04 * f64::from(k) };
            let flame = [
                (at(r * cos, 0.2, r * sin), 0.06, 0.06),
                (at(r * cos, 0.42, r * sin), 0.13, 0.13),
                (at(0.6 * r * cos, tip, 0.6 * r * sin), 0.01, 0.01),
            ];
            mesh.sweep(&flame, at(1.0, 0.0, 0.0), 8, &of(Finish::Glow, if k % 2 == 0 { 0xf2a33a } else { 0xe8622a }));
        }
    })
}

/// Two frames like an A, a beam, and seats on ropes.
pub(super) fn swing(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wood = a.main(stuff::OAK);
    let seat = a.second(Stuff(Finish::Plastic, 0xc8392f));
    let rope = of(Finish::Fabric, 0x6b6458);
    for end in b.share(0.0..0.1, 0.0..1.0, 0.0..1.0).both_sides() {
        m.solid(end);
    }
    m.solid(b.share(0.1..0.9, 0.94..1.0, 0.44..0.56));
    let n = pieces(a.w, 0.9, 1, 3);
    m.solid(b.share(0.16..0.84, 0.22..0.94, 0.4..0.6));
    m.mesh.stretch(b, |mesh| {
        for x in [-0.93, 0.93] {
            for z in [-1.0, 1.0] {
                mesh.sweep(
                    &[(at(x, 0.0, 0.9 * z), 0.05, 0.1), (at(x, 1.96, 0.08 * z), 0.05, 0.1)],
                    at(1.0, 0.0, 0.0),
                    8,
                    &wood,
                );
            }
            mesh.rounded(block(x - 0.04..x + 0.04, 0.7..0.8, -0.62..0.62), 0.02, 1, &wood);
        }
        mesh.rod(at(-1.0, 1.94, 0.0), at(1.0, 1.94, 0.0), 0.06, &wood);
        for place in block(-0.66..0.66, 0.5..0.56, -0.16..0.16).split(0, n, 0.3) {
            mesh.rounded(place, 0.02, 1, &seat);
            if a.says(&["baby", "toddler"]) {
                mesh.rounded(place.y(0.56..0.92).z(-0.18..-0.13), 0.02, 1, &seat);
                mesh.rounded(place.y(0.74..0.8).z(0.12..0.17), 0.02, 1, &seat);
            }
            for x in [place.min.x + 0.03, place.max.x - 0.03] {
                mesh.rod(at(x, 0.53, 0.0), at(x, 1.94, 0.0), 0.012, &rope);
            }
        }
    });
    m
}

/// A trunk with its rings, sawn at both ends; a pile of logs; a piece of driftwood.
pub(super) fn log(a: &Ask) -> BuiltModel {
    let bark = a.main(Stuff(Finish::Wood, 0x6b4a30));
    let cut = of(Finish::Wood, 0xd8b27a);
    let single = !a.says(&["pile", "stack", "firewood"]);
    let one = |mesh: &mut Mesh, x: f64, y: f64, r: f64, tint: f32| {
        let z = 1.0 - 0.06 * (x * 7.0 + y * 5.0).sin().abs();
        cone(mesh, at(x, y, -z), at(x, y, z), [r, r], &shade(&bark, tint));
        for side in [-1.0, 1.0] {
            cone(mesh, at(x, y, side * (z - 0.02)), at(x, y, side * (z + 0.012)), [0.86 * r, 0.86 * r], &cut);
            if single {
                let (from, to) = (at(x, y, side * z), at(x, y, side * (z + 0.018)));
                cone(mesh, from, to, [0.4 * r, 0.4 * r], &shade(&cut, 0.8));
            }
        }
    };
    if !single {
        return small(a, |mesh| {
            for row in 0..4 {
                let n = if row % 2 == 0 { 5 } else { 4 };
                for k in 0..n {
                    let x = 0.34 * (f64::from(k) - f64::from(n - 1) / 2.0);
                    one(mesh, x, 0.17 + 0.29 * f64::from(row), 0.17, [1.0, 0.85, 1.2][(k + row) as usize % 3]);
                }
            }
        });
    }
    round(a, |mesh| {
        mesh.place(at(0.0, 0.0, 0.0), [-90.0, 0.0, 0.0], |mesh| {
            one(mesh, 0.0, 0.0, 0.3, 1.0);
            mesh.tube(&[at(0.24, 0.1, 0.3), at(0.36, 0.18, 0.42)], 0.08, &bark);
        });
    })
}

/// A rounded stone, or a few of them.
pub(super) fn stone(a: &Ask) -> BuiltModel {
    let gray = a.main(Stuff(Finish::Stone, 0x8a867e));
    let mut dice = a.dice();
    small(a, |mesh| {
        let around = |y: f64, r: f64, dice: &mut crate::words::Dice| {
            let mut ring = oval(y, [0.0; 2], [r, r], 1.0);
            for p in ring.chunks_mut(3) {
                let by = dice.between(0.86, 1.08);
                p.iter_mut().for_each(|p| (p.x, p.z) = (p.x * by, p.z * by));
            }
            ring
        };
        let rings: Vec<_> = [(0.0, 0.62), (0.16, 0.92), (0.5, 1.0), (0.8, 0.8), (0.96, 0.5), (1.02, 0.2)]
            .into_iter()
            .map(|(y, r)| around(y, r, &mut dice))
            .collect();
        mesh.loft(&rings, &gray);
    })
}

/// Three balls of snow with a hat, a carrot and arms.
pub(super) fn snowman(a: &Ask) -> BuiltModel {
    let snow = a.main(Stuff(Finish::Plaster, 0xe3ecf0));
    let coal = stuff::DARK_PLASTIC.surface();
    small(a, |mesh| {
        for (low, r) in [(0.0, 0.4), (0.64, 0.29), (1.1, 0.2)] {
            mesh.ball(block(-r..r, low..low + 2.0 * r, -r..r), &snow);
        }
        mesh.drum(block(-0.24..0.24, 1.42..1.45, -0.24..0.24), &coal);
        mesh.drum(block(-0.15..0.15, 1.44..1.68, -0.15..0.15), &coal);
        cone(mesh, at(0.0, 1.28, 0.18), at(0.0, 1.27, 0.38), [0.035, 0.004], &of(Finish::Paint, 0xe8822a));
        for x in [-0.075, 0.075] {
            mesh.bead(block(-0.025..0.025, -0.025..0.025, -0.02..0.02).moved(x, 1.36, 0.175), &coal);
        }
        for y in [0.82, 0.94, 1.06] {
            mesh.bead(block(-0.028..0.028, -0.028..0.028, -0.02..0.02).moved(0.0, y, 0.28), &coal);
        }
        mesh.torus(block(-0.2..0.2, 1.08..1.18, -0.2..0.2), 0.3, &stuff::RED.surface());
        for side in [-1.0, 1.0] {
            mesh.tube(
                &[at(side * 0.24, 1.0, 0.0), at(side * 0.48, 1.14, 0.03), at(side * 0.62, 1.3, 0.0)],
                0.018,
                &of(Finish::Wood, 0x5a3d28),
            );
        }
    })
}

/// A small man with a beard and a pointed hat.
pub(super) fn garden_gnome(a: &Ask) -> BuiltModel {
    let coat = a.main(Stuff(Finish::Paint, 0x2f5fa0));
    let (red, skin) = (stuff::RED.surface(), of(Finish::Ceramic, 0xe0a988));
    small(a, |mesh| {
        for boot in block(-0.34..-0.04, 0.0..0.16, -0.16..0.3).both_sides() {
            mesh.rounded(boot, 0.07, 2, &of(Finish::Leather, 0x4a3020));
        }
        mesh.lathe(
            block(-0.42..0.42, 0.12..0.84, -0.36..0.36),
            &[(0.8, 0.0), (1.0, 0.2), (0.92, 0.6), (0.6, 1.0)],
            20,
            &coat,
        );
        mesh.torus(block(-0.42..0.42, 0.34..0.42, -0.36..0.36), 0.14, &of(Finish::Leather, 0x3a2a1c));
        mesh.ball(block(-0.26..0.26, 0.74..1.2, -0.24..0.26), &skin);
        mesh.sweep(
            &[(at(0.0, 0.96, 0.22), 0.2, 0.08), (at(0.0, 0.7, 0.34), 0.2, 0.09), (at(0.0, 0.42, 0.36), 0.03, 0.03)],
            at(0.0, 0.0, 1.0),
            10,
            &stuff::SHEET.surface(),
        );
        mesh.lathe(
            block(-0.31..0.31, 1.1..1.9, -0.3..0.3),
            &[(1.0, 0.0), (0.92, 0.1), (0.5, 0.5), (0.0, 1.0)],
            20,
            &red,
        );
        mesh.bead(block(-0.06..0.06, 0.98..1.1, 0.22..0.36), &skin);
        for x in [-0.1, 0.1] {
            mesh.bead(block(-0.03..0.03, 1.06..1.12, 0.2..0.27).moved(x, 0.0, 0.0), &stuff::DARK_PLASTIC.surface());
        }
        for side in [-1.0, 1.0] {
            mesh.tube(&[at(side * 0.3, 0.74, 0.0), at(side * 0.48, 0.5, 0.1), at(side * 0.36, 0.38, 0.3)], 0.09, &coat);
        }
    })
}

/// A shirt and a hat on a cross of wood.
pub(super) fn scarecrow(a: &Ask) -> BuiltModel {
    let shirt = a.main(Stuff(Finish::Fabric, 0xa8473a));
    let (wood, straw) = (stuff::OAK.surface(), of(Finish::Wicker, 0xd8b45f));
    small(a, |mesh| {
        mesh.rod(at(0.0, 0.0, 0.0), at(0.0, 1.5, 0.0), 0.035, &wood);
        mesh.lathe(
            block(-0.24..0.24, 0.62..1.34, -0.13..0.13),
            &[(0.9, 0.0), (0.8, 0.4), (1.0, 0.9), (0.5, 1.0)],
            16,
            &shirt,
        );
        mesh.lathe(
            block(-0.22..0.22, 0.3..0.66, -0.12..0.12),
            &[(0.9, 0.0), (1.0, 1.0)],
            16,
            &of(Finish::Fabric, 0x3f557a),
        );
        for side in [-1.0, 1.0] {
            cone(mesh, at(side * 0.16, 1.26, 0.0), at(side * 0.66, 1.22, 0.0), [0.09, 0.08], &shirt);
            for (dy, dz) in [(-0.06, 0.04), (0.05, 0.0), (0.0, -0.05), (-0.02, 0.07)] {
                mesh.rod(at(side * 0.64, 1.22, 0.0), at(side * 0.8, 1.22 + dy, dz), 0.012, &straw);
            }
        }
        mesh.ball(block(-0.15..0.15, 1.34..1.66, -0.14..0.14), &of(Finish::Fabric, 0xcfae7a));
        mesh.drum(block(-0.3..0.3, 1.6..1.63, -0.26..0.26), &straw);
        mesh.lathe(block(-0.15..0.15, 1.62..1.84, -0.14..0.14), &[(1.0, 0.0), (0.8, 0.8), (0.4, 1.0)], 16, &straw);
        for x in [-0.06, 0.06] {
            mesh.bead(block(-0.022..0.022, 1.5..1.55, 0.11..0.15).moved(x, 0.0, 0.0), &stuff::DARK_PLASTIC.surface());
        }
        mesh.tube(
            &[at(-0.07, 1.43, 0.12), at(0.0, 1.41, 0.14), at(0.07, 1.43, 0.12)],
            0.012,
            &stuff::DARK_PLASTIC.surface(),
        );
    })
}

/// A house under a gable, with a round hole and a perch for birds, an arch for dogs, a door and a window for children.
pub(super) fn birdhouse(a: &Ask) -> BuiltModel {
    let children = a.says(&["playhouse", "play"]);
    let dog = a.says(&["kennel", "dog", "doghouse"]);
    let wall = a.main(Stuff(Finish::Wood, 0xc08a4f));
    let roof = a.second(Stuff(Finish::Paint, 0xa5402f));
    let dark = of(Finish::Paint, 0x2b221c);
    small(a, |mesh| {
        mesh.extrude(2, &[(-0.8, 0.04), (0.8, 0.04), (0.8, 1.0), (0.0, 1.62), (-0.8, 1.0)], -0.8..0.8, &wall);
        for side in [-1.0, 1.0] {
            mesh.extrude(2, &[(0.0, 1.6), (side * 1.0, 0.83), (side * 1.0, 0.95), (0.0, 1.74)], -0.95..0.95, &roof);
        }
        mesh.crisp(block(-0.84..0.84, 0.0..0.06, -0.84..0.84), &shade(&wall, 0.7));
        if children {
            mesh.crisp(block(-0.55..-0.05, 0.06..0.95, 0.78..0.83), &of(Finish::Paint, 0x3f7fa0));
            mesh.bead(block(-0.18..-0.1, 0.46..0.54, 0.82..0.88), &stuff::BRASS.surface());
            mesh.crisp(block(0.16..0.62, 0.46..0.9, 0.78..0.82), &stuff::WHITE.surface());
            for pane in block(0.2..0.58, 0.5..0.86, 0.8..0.84).split(0, 2, 0.04) {
                mesh.crisp(pane, &of(Finish::Screen, 0x7fa8bf));
            }
        } else if dog {
            mesh.crisp(block(-0.4..0.4, 0.06..0.6, 0.78..0.82), &dark);
            mesh.disc(2, block(-0.4..0.4, 0.25..0.95, 0.78..0.815), &dark);
        } else {
            mesh.disc(2, block(-0.26..0.26, 0.64..1.16, 0.78..0.82), &dark);
            mesh.rod(at(0.0, 0.44, 0.78), at(0.0, 0.44, 1.15), 0.05, &shade(&wall, 0.7));
        }
    })
}

/// Boxes on each other under a flat roof, with a slot for bees.
pub(super) fn beehive(a: &Ask) -> BuiltModel {
    let wood = a.main(Stuff(Finish::Wood, 0xd9b46a));
    small(a, |mesh| {
        for x in [-0.4..-0.3, 0.3..0.4] {
            for z in [-0.4..-0.3, 0.3..0.4] {
                mesh.crisp(block(x.clone(), 0.0..0.16, z), &shade(&wood, 0.7));
            }
        }
        mesh.rounded(block(-0.46..0.46, 0.15..0.2, -0.46..0.56), 0.01, 1, &shade(&wood, 0.7));
        for y in [0.2..0.56, 0.58..0.84, 0.86..1.12] {
            mesh.rounded(block(-0.42..0.42, y.clone(), -0.42..0.42), 0.02, 1, &wood);
            let c = f64::midpoint(y.start, y.end);
            mesh.crisp(block(-0.12..0.12, c + 0.03..c + 0.07, 0.41..0.44), &shade(&wood, 0.55));
        }
        mesh.crisp(block(-0.26..0.26, 0.2..0.25, 0.4..0.43), &stuff::DARK_PLASTIC.surface());
        mesh.rounded(block(-0.47..0.47, 1.12..1.24, -0.47..0.47), 0.02, 1, &stuff::STEEL.surface());
        for k in 0..5 {
            let (sin, cos) = (f64::from(k) * 2.4).sin_cos();
            let bee = block(-0.025..0.025, -0.018..0.018, -0.018..0.018).moved(
                0.2 * cos,
                0.3 + 0.06 * f64::from(k),
                0.48 + 0.04 * sin,
            );
            mesh.bead(bee, &of(Finish::Paint, 0xe0a82f));
        }
    })
}

/// A house of glass in a frame.
pub(super) fn greenhouse(a: &Ask) -> BuiltModel {
    let frame = a.main(Stuff(Finish::Metal, 0x7d8a80));
    let glass = stuff::GLASS.surface();
    headed(a, |mesh| {
        mesh.extrude(2, &[(-0.97, 0.02), (0.97, 0.02), (0.97, 1.1), (0.0, 1.68), (-0.97, 1.1)], -0.98..0.98, &glass);
        mesh.crisp(block(-1.0..1.0, 0.0..0.14, -1.0..1.0), &of(Finish::Stone, 0xa39a8c));
        for k in 0..6 {
            let z = -0.98 + 0.392 * f64::from(k);
            for side in [-1.0, 1.0] {
                mesh.rod(at(side * 0.98, 0.0, z), at(side * 0.98, 1.12, z), 0.02, &frame);
                mesh.rod(at(side * 0.98, 1.1, z), at(0.0, 1.7, z), 0.02, &frame);
            }
        }
        for (x, y) in [(-0.98, 1.1), (0.98, 1.1), (0.0, 1.7), (-0.5, 1.4), (0.5, 1.4), (-0.98, 0.6), (0.98, 0.6)] {
            mesh.rod(at(x, y, -1.0), at(x, y, 1.0), 0.02, &frame);
        }
        for x in [-0.34, 0.34] {
            mesh.rod(at(x, 0.0, 1.0), at(x, 1.2, 1.0), 0.02, &frame);
        }
        mesh.rod(at(-0.34, 1.2, 1.0), at(0.34, 1.2, 1.0), 0.02, &frame);
        for bed in block(-0.9..-0.35, 0.14..0.4, -0.9..0.8).both_sides() {
            mesh.rounded(bed, 0.1, 2, &stuff::LEAF.surface());
        }
    })
}

/// A round basin of cloth or air: water in one, balls in the other.
pub(super) fn ball_pit(a: &Ask) -> BuiltModel {
    let balls = a.says(&["ball"]);
    let wall = a.main(if balls { Stuff(Finish::Fabric, 0x7f93a8) } else { Stuff(Finish::Plastic, 0x3f8fc0) });
    small(a, |mesh| {
        if !balls {
            for (k, y) in [0.0, 0.28, 0.56].into_iter().enumerate() {
                mesh.torus(
                    block(-1.0..1.0, y..y + 0.32, -1.0..1.0),
                    0.28,
                    &shade(&wall, if k == 1 { 1.6 } else { 1.0 }),
                );
            }
            mesh.drum(block(-0.86..0.86, 0.0..0.6, -0.86..0.86), &of(Finish::Water, 0x6fb7cf));
            return;
        }
        mesh.lathe(
            block(-1.0..1.0, 0.0..0.8, -1.0..1.0),
            &[(0.98, 0.0), (1.0, 0.1), (1.0, 0.95), (0.96, 1.0), (0.86, 1.0), (0.84, 0.5)],
            24,
            &wall,
        );
        let colors = [0xc8392f, 0x3f7fb5, 0xe3bd3a, 0x6da544, 0xe07b9a];
        for k in 0..44_u32 {
            let r = 0.118 * f64::from(k).sqrt();
            let (sin, cos) = (f64::from(k) * 2.4).sin_cos();
            let ball = block(-0.12..0.12, 0.54..0.76, -0.12..0.12).moved(r * cos, 0.03 * f64::from(k % 4), r * sin);
            mesh.lathe(ball, &crate::shapes::sphere(4), 8, &of(Finish::Plastic, colors[k as usize % 5]));
        }
    })
}

/// A platform and a roof about a pillar, and horses on poles.
pub(super) fn carousel(a: &Ask) -> BuiltModel {
    let red = a.main(Stuff(Finish::Paint, 0xb5332c));
    let (gold, cream) = (stuff::BRASS.surface(), of(Finish::Paint, 0xe6d9b8));
    small(a, |mesh| {
        mesh.drum(block(-1.0..1.0, 0.0..0.12, -1.0..1.0), &stuff::OAK.surface());
        mesh.drum(block(-0.24..0.24, 0.1..1.4, -0.24..0.24), &cream);
        for k in 0..12 {
            let turn = |k: f64| (TAU * k / 12.0).sin_cos();
            let ((s0, c0), (s1, c1)) = (turn(f64::from(k)), turn(f64::from(k) + 1.0));
            let s = if k % 2 == 0 { &red } else { &cream };
            // A sector of the roof: flat below, rising to the tip.
            mesh.loft(
                &[
                    vec![at(0.0, 1.4, 0.0), at(c0, 1.4, s0), at(c1, 1.4, s1)],
                    vec![at(0.0, 1.8, 0.0), at(c0, 1.46, s0), at(c1, 1.46, s1)],
                ],
                s,
            );
        }
        mesh.ball(block(-0.07..0.07, 1.76..1.92, -0.07..0.07), &gold);
        for k in 0..5 {
            mesh.place(at(0.0, 0.0, 0.0), [0.0, 72.0 * f64::from(k), 0.0], |mesh| {
                let y = if k % 2 == 0 { 0.44 } else { 0.58 };
                mesh.rod(at(0.7, 0.1, 0.0), at(0.7, 1.42, 0.0), 0.02, &gold);
                mesh.rounded(block(0.64..0.76, y..y + 0.16, -0.2..0.18), 0.06, 2, &cream);
                mesh.sweep(
                    &[(at(0.7, y + 0.1, 0.14), 0.05, 0.07), (at(0.7, y + 0.34, 0.24), 0.035, 0.05)],
                    at(1.0, 0.0, 0.0),
                    8,
                    &cream,
                );
                mesh.sweep(
                    &[(at(0.7, y + 0.34, 0.2), 0.035, 0.05), (at(0.7, y + 0.26, 0.38), 0.025, 0.03)],
                    at(1.0, 0.0, 0.0),
                    8,
                    &cream,
                );
                for z in [-0.16, 0.13] {
                    mesh.rod(at(0.67, y + 0.05, z), at(0.67, y - 0.18, z + 0.06), 0.02, &cream);
                    mesh.rod(at(0.73, y + 0.05, z), at(0.73, y - 0.18, z - 0.06), 0.02, &cream);
                }
                mesh.rounded(block(0.63..0.77, y + 0.13..y + 0.18, -0.1..0.06), 0.02, 1, &red);
            });
        }
    })
}

/// A mast on legs with an arm and a hook.
pub(super) fn crane(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let paint = a.main(Stuff(Finish::Paint, 0xe0a020));
    let steel = stuff::BLACK_STEEL.surface();
    for leg in b.share(0.0..0.12, 0.02..0.08, 0.0..1.0).both_sides() {
        m.board(leg, &paint);
    }
    m.board(b.share(0.12..0.88, 0.02..0.08, 0.0..0.1), &paint);
    for wheel in b.share(0.01..0.11, 0.0..0.02, 0.01..0.07).four_corners() {
        m.board(wheel, &steel);
    }
    m.board(b.share(0.42..0.58, 0.08..0.9, 0.0..0.1), &paint);
    m.board(b.share(0.44..0.56, 0.9..1.0, 0.0..0.92), &paint);
    m.solid(b.share(0.46..0.54, 0.5..0.9, 0.1..0.5));
    let point = |y: f64, z: f64| at(0.0, y * a.h, b.min.z + z * a.d);
    let r = (0.035 * a.w).min(0.02 * a.h).min(0.04 * a.d);
    m.mesh.rod(point(0.52, 0.06), point(0.92, 0.46), r, &steel);
    let thin = 0.3 * r;
    m.solid(b.share(0.46..0.54, 0.52..0.9, 0.82..0.92));
    m.mesh.rod(point(0.64, 0.87), point(0.92, 0.87), thin, &steel);
    let (c, hook) = (0.87, (0.04 * a.d).min(0.04 * a.h));
    let z = b.min.z + c * a.d;
    let curve: Vec<_> = [(0.0, 2.0), (0.0, 1.0), (0.9, 0.2), (0.6, -0.8), (-0.5, -0.8), (-0.9, 0.0)]
        .into_iter()
        .map(|(x, y)| at(0.0, 0.58 * a.h + y * hook, z + x * hook))
        .collect();
    m.mesh.tube(&curve, 0.3 * hook.min(0.1 * a.w), &stuff::STEEL.surface());
    m
}

/// A tray over one wheel, with two handles and two legs; the wheel is in front.
pub(super) fn wheelbarrow(a: &Ask) -> BuiltModel {
    let paint = a.main(Stuff(Finish::Paint, 0x3f7a4c));
    let wood = stuff::OAK.surface();
    headed(a, |mesh| {
        let tray = |y: f64, half: [f64; 2], z: f64| oval(y, [0.0, z], half, 0.45);
        mesh.loft(
            &[
                tray(0.42, [0.3, 0.36], 0.1),
                tray(0.98, [0.5, 0.62], 0.08),
                tray(0.98, [0.46, 0.57], 0.08),
                tray(0.5, [0.27, 0.32], 0.1),
            ],
            &paint,
        );
        mesh.disc(0, block(-0.08..0.08, 0.0..0.56, 0.68..1.2), &stuff::RUBBER.surface());
        mesh.disc(0, block(-0.1..0.1, 0.14..0.42, 0.81..1.07), &stuff::STEEL.surface());
        for side in [-1.0, 1.0] {
            mesh.tube(
                &[
                    at(side * 0.1, 0.28, 0.94),
                    at(side * 0.3, 0.4, 0.3),
                    at(side * 0.42, 0.62, -0.6),
                    at(side * 0.42, 0.66, -1.0),
                ],
                0.04,
                &wood,
            );
            mesh.tube(
                &[
                    at(side * 0.34, 0.46, -0.1),
                    at(side * 0.34, 0.02, -0.3),
                    at(side * 0.34, 0.02, -0.5),
                    at(side * 0.4, 0.58, -0.5),
                ],
                0.03,
                &stuff::BLACK_STEEL.surface(),
            );
            let grip = block(-0.055..0.055, 0.6..0.71, -1.06..-0.76).moved(side * 0.42, 0.0, 0.0);
            mesh.ball(grip, &stuff::DARK_PLASTIC.surface());
        }
    })
}
