//! Rolls, reels, records, wheels, coils of rope, sticks and pipes.

use super::strokes::{at, cone, headed, long, of, round, small};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use std::f64::consts::TAU;

/// Something rolled up, with a hole; its end shows the turns. A rolling pin has handles.
pub(super) fn roll(a: &Ask) -> BuiltModel {
    if a.says(&["rolling", "pin"]) {
        let wood = a.main(Stuff(Finish::Wood, 0xcfa56e));
        return long(a, |mesh| {
            cone(mesh, at(0.0, 0.0, -0.6), at(0.0, 0.0, 0.6), [0.16, 0.16], &wood);
            for side in [-1.0, 1.0] {
                let grip = [
                    (at(0.0, 0.0, side * 0.6), 0.05, 0.05),
                    (at(0.0, 0.0, side * 0.8), 0.08, 0.08),
                    (at(0.0, 0.0, side), 0.04, 0.04),
                ];
                mesh.sweep(&grip, at(0.0, 1.0, 0.0), 12, &shade(&wood, 0.8));
            }
        });
    }
    let usual = if a.says(&["carpet"]) {
        Stuff(Finish::Carpet, 0x9a4a3c)
    } else if a.says(&["fabric", "cloth"]) {
        Stuff(Finish::Fabric, 0x4f7f9c)
    } else if a.says(&["gift", "wrap", "wallpaper"]) {
        Stuff(Finish::Paper, 0xc8465a)
    } else if a.says(&["foam", "roller"]) {
        Stuff(Finish::Rubber, 0x3f6f8c)
    } else if a.says(&["tape"]) {
        Stuff(Finish::Plastic, 0xb99a5f)
    } else {
        Stuff(Finish::Paper, 0xe2dccf)
    };
    let main = a.main(usual);
    let hole = if a.says(&["tape"]) { 0.72 } else { 0.3 };
    round(a, |mesh| {
        // The wall of the tube, and its bottom far within.
        let wall = [(1.0, 0.0), (1.0, 1.0), (hole, 1.0), (hole, 0.04)];
        mesh.lathe(block(-1.0..1.0, 0.0..1.0, -1.0..1.0), &wall, 24, &main);
        let mut r = hole + 0.12;
        while r < 0.95 {
            mesh.torus(block(-r..r, 0.985..1.004, -r..r), 0.03, &shade(&main, 0.6));
            r += 0.17;
        }
        let flap = block(0.8..1.03, 0.0..1.0, -0.45..0.1);
        mesh.crisp(flap, &shade(&main, 0.85));
    })
}

/// Two flanges and what is wound between them; yarn in a ball; a yo-yo.
pub(super) fn spool(a: &Ask) -> BuiltModel {
    if a.says(&["yarn", "wool"]) {
        let wool = a.main(Stuff(Finish::Fabric, 0xc45a6a));
        return small(a, |mesh| {
            mesh.ball(block(-0.94..0.94, -0.94..0.94, -0.94..0.94), &wool);
            for k in 0..6 {
                let turn = f64::from(k) * 60.0;
                mesh.place(at(0.0, 0.0, 0.0), [30.0 + turn, turn * 1.7, turn * 0.6], |mesh| {
                    mesh.torus(
                        block(-0.99..0.99, -0.05..0.05, -0.99..0.99),
                        0.1,
                        &shade(&wool, if k % 2 == 0 { 0.8 } else { 1.2 }),
                    );
                });
            }
        });
    }
    let film = a.says(&["film"]);
    let hose = a.says(&["hose"]);
    let wound = if film {
        Stuff(Finish::Plastic, 0x2c2420)
    } else if hose {
        Stuff(Finish::Rubber, 0x3f8a4c)
    } else if a.says(&["cable"]) {
        Stuff(Finish::Rubber, 0xd8602a)
    } else {
        Stuff(Finish::Fabric, 0xc8392f)
    };
    let (wound, flange) = (a.main(wound), a.second(if film || hose { stuff::STEEL } else { stuff::OAK }));
    round(a, |mesh| {
        if a.says(&["yo", "yoyo"]) {
            for half in
                [[(0.5, 0.0), (0.92, 0.1), (1.0, 0.5), (0.92, 1.0)], [(0.92, 0.0), (1.0, 0.5), (0.92, 0.9), (0.5, 1.0)]]
                    .into_iter()
                    .enumerate()
            {
                let low = if half.0 == 0 { -0.6 } else { 0.1 };
                mesh.lathe(block(-1.0..1.0, low..low + 0.5, -1.0..1.0), &half.1, 24, &wound);
            }
            mesh.drum(block(-0.4..0.4, -0.11..0.11, -0.4..0.4), &stuff::SHEET.surface());
            return;
        }
        for y in [-1.0..-0.86, 0.86..1.0] {
            mesh.drum(block(-1.0..1.0, y, -1.0..1.0), &flange);
        }
        let r = if film { 0.8 } else { 0.78 };
        if hose || a.says(&["cable"]) {
            for k in 0..5 {
                let y = -0.7 + 0.35 * f64::from(k);
                mesh.torus(block(-0.86..0.86, y - 0.18..y + 0.18, -0.86..0.86), 0.3, &wound);
            }
            mesh.drum(block(-0.5..0.5, -0.86..0.86, -0.5..0.5), &flange);
        } else {
            mesh.drum(block(-r..r, -0.86..0.86, -r..r), &wound);
        }
        mesh.drum(block(-0.22..0.22, 0.99..1.02, -0.22..0.22), &stuff::DARK_PLASTIC.surface());
        if film {
            for k in 0..5 {
                let (sin, cos) = (TAU * f64::from(k) / 5.0).sin_cos();
                mesh.drum(block(-0.2..0.2, 0.99..1.02, -0.2..0.2).moved(0.58 * cos, 0.0, 0.58 * sin), &wound);
            }
        }
    })
}

/// A flat disc: a record with its label and hole, a silver disc, a coin.
pub(super) fn record(a: &Ask) -> BuiltModel {
    let coin = a.says(&["coin", "token"]);
    let bright = a.says(&["game", "cd", "dvd", "disc"]);
    let usual = match (coin, bright) {
        (true, _) => Stuff(Finish::Brass, 0xcfa23a),
        (_, true) => Stuff(Finish::Chrome, 0xb9c4d4),
        _ => Stuff(Finish::Plastic, 0x1c1d1f),
    };
    let main = a.main(usual);
    round(a, |mesh| {
        mesh.drum(block(-1.0..1.0, -0.02..0.02, -1.0..1.0), &main);
        if coin {
            mesh.torus(block(-0.99..0.99, -0.03..0.03, -0.99..0.99), 0.12, &main);
            mesh.drum(block(-0.4..0.4, -0.03..0.03, -0.4..0.4), &shade(&main, 0.8));
            return;
        }
        for k in 0..4 {
            let r = 0.5 + 0.13 * f64::from(k);
            mesh.torus(block(-r..r, -0.026..0.026, -r..r), 0.02, &shade(&main, 1.3));
        }
        let label = if bright { stuff::GLASS.surface() } else { of(Finish::Paper, 0xc8392f) };
        mesh.drum(block(-0.34..0.34, -0.03..0.03, -0.34..0.34), &label);
        mesh.drum(block(-0.05..0.05, -0.034..0.034, -0.05..0.05), &stuff::PAPER.surface());
    })
}

/// A wheel with its tyre, rim and spokes; a tyre alone.
pub(super) fn wheel(a: &Ask) -> BuiltModel {
    let rubber = a.main(stuff::RUBBER);
    let alone = a.says(&["tire", "tyre"]);
    round(a, |mesh| {
        mesh.torus(block(-1.0..1.0, -0.3..0.3, -1.0..1.0), if alone { 0.42 } else { 0.34 }, &rubber);
        for k in 0..24 {
            let turn = 15.0 * f64::from(k);
            mesh.place(at(0.0, 0.0, 0.0), [0.0, turn, 0.0], |mesh| {
                mesh.crisp(block(0.96..1.015, -0.14..0.14, -0.04..0.04), &shade(&rubber, 0.8));
            });
        }
        if !alone {
            let steel = stuff::STEEL.surface();
            mesh.torus(block(-0.72..0.72, -0.26..0.26, -0.72..0.72), 0.14, &steel);
            mesh.drum(block(-0.18..0.18, -0.22..0.22, -0.18..0.18), &steel);
            for k in 0..5 {
                mesh.place(at(0.0, 0.0, 0.0), [0.0, 72.0 * f64::from(k), 0.0], |mesh| {
                    mesh.rounded(block(0.1..0.66, 0.0..0.16, -0.09..0.09), 0.03, 1, &steel);
                });
            }
        }
    })
}

/// A coil of rope, its end beside it; a skipping rope has handles.
pub(super) fn rope(a: &Ask) -> BuiltModel {
    let hemp = a.main(Stuff(Finish::Fabric, 0xb8955a));
    small(a, |mesh| {
        for (k, r) in [0.92, 0.86, 0.9].into_iter().enumerate() {
            let y = 0.12 + 0.2 * k as f64;
            mesh.torus(block(-r..r, y - 0.12..y + 0.12, -r..r), 0.24, &hemp);
            let r = r - 0.2;
            mesh.torus(block(-r..r, y - 0.12..y + 0.12, -r..r), 0.3, &shade(&hemp, 0.85));
        }
        mesh.tube(&[at(0.75, 0.55, 0.3), at(0.9, 0.4, 0.62), at(0.8, 0.12, 0.98), at(0.5, 0.11, 1.1)], 0.11, &hemp);
        if a.says(&["skipping", "jump"]) {
            for x in [-0.35, 0.3] {
                mesh.tube(&[at(x, 0.7, -0.7), at(x, 0.7, 0.1)], 0.14, &stuff::RED.surface());
            }
        }
    })
}

/// A chain that hangs from its wall: links, every second one turned, and a ring for a wrist at the end.
pub(super) fn chain(a: &Ask) -> BuiltModel {
    const LINKS: usize = 7;
    let iron = a.main(Stuff(Finish::Metal, 0x55585c));
    small(a, |mesh| {
        let step = 1.4 / LINKS as f64;
        for k in 0..LINKS {
            let top = 1.0 - step * k as f64;
            let wide = if k % 2 == 0 { 0.45 } else { 0.14 };
            let ring = [at(-wide, top - 0.05, 0.0), at(-wide, top - step * 1.1, 0.0)];
            mesh.tube(&ring, 0.1, &iron);
            mesh.tube(&ring.map(|p| at(-p.x, p.y, 0.0)), 0.1, &iron);
            mesh.tube(&[at(-wide, top - 0.05, 0.0), at(wide, top - 0.05, 0.0)], 0.1, &iron);
        }
        let ring = |angle: f64| at(0.9 * angle.cos(), -0.7 + 0.28 * angle.sin(), 0.0);
        let round: Vec<_> = (0..=12).map(|k| ring(TAU * f64::from(k) / 12.0)).collect();
        mesh.tube(&round, 0.1, &shade(&iron, 0.9));
    })
}

/// Long thin things: sticks, poles, pipes, planks, nails, crayons.
pub(super) fn pipe(a: &Ask) -> BuiltModel {
    let says = |words: &[&str]| a.says(words);
    let (steel, wood) = (of(Finish::Metal, 0x9aa0a5), Stuff(Finish::Wood, 0xb98a55));
    let shaft = |mesh: &mut Mesh, r: [f64; 2], s: &Surface| cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, 1.0), r, s);
    if says(&["crayon", "pencil"]) {
        let wax = a.main(Stuff(Finish::Paper, 0xc8392f));
        return long(a, |mesh| {
            cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, 0.7), [0.2, 0.2], &shade(&wax, 0.8));
            cone(mesh, at(0.0, 0.0, -0.8), at(0.0, 0.0, 0.6), [0.207, 0.207], &wax);
            cone(mesh, at(0.0, 0.0, 0.69), at(0.0, 0.0, 1.0), [0.16, 0.05], &shade(&wax, 0.8));
        });
    }
    if says(&["nail"]) {
        let iron = a.main(Stuff(Finish::Metal, 0x8f969c));
        return long(a, |mesh| {
            cone(mesh, at(0.0, 0.0, -0.96), at(0.0, 0.0, 0.8), [0.03, 0.03], &iron);
            cone(mesh, at(0.0, 0.0, 0.8), at(0.0, 0.0, 1.0), [0.03, 0.002], &iron);
            cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, -0.95), [0.07, 0.07], &iron);
        });
    }
    if says(&["plank", "board"]) {
        let plank = a.main(Stuff(Finish::Wood, 0xc9a06c));
        let mut m = BuiltModel::default();
        m.board(a.whole(), &plank);
        return m;
    }
    if says(&["chopstick"]) {
        let stick = a.main(Stuff(Finish::Wood, 0x7a2f24));
        return long(a, |mesh| {
            for (low, top) in [(-0.25, -0.06), (0.25, 0.06)] {
                mesh.sweep(
                    &[(at(low, 0.0, -1.0), 0.06, 0.06), (at(top, 0.0, 1.0), 0.03, 0.03)],
                    at(0.0, 1.0, 0.0),
                    8,
                    &stick,
                );
            }
        });
    }
    if says(&["cue"]) {
        let ash = a.main(Stuff(Finish::Wood, 0xd2a869));
        return long(a, |mesh| {
            cone(mesh, at(0.0, 0.0, -0.3), at(0.0, 0.0, 0.98), [0.8, 0.4], &ash);
            cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, -0.3), [1.0, 0.82], &stuff::DARK_PLASTIC.surface());
            cone(mesh, at(0.0, 0.0, -0.32), at(0.0, 0.0, -0.28), [0.9, 0.9], &stuff::SHEET.surface());
            cone(mesh, at(0.0, 0.0, 0.98), at(0.0, 0.0, 1.0), [0.4, 0.4], &of(Finish::Fabric, 0x3f78b0));
        });
    }
    if says(&["fishing", "rod"]) {
        let rod = a.main(Stuff(Finish::Plastic, 0x2f3a34));
        return long(a, |mesh| {
            shaft(mesh, [0.5, 0.12], &rod);
            cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, -0.72), [0.8, 0.8], &of(Finish::Wood, 0xc79a63));
            mesh.disc(0, block(-0.9..0.9, -2.4..-0.6, -0.68..-0.6), &stuff::STEEL.surface());
            for z in [-0.3, 0.1, 0.45, 0.75, 0.97] {
                mesh.torus(block(-0.5..0.5, -1.1..-0.2, z - 0.004..z + 0.004), 0.2, &stuff::STEEL.surface());
            }
        });
    }
    let usual = if says(&["straw"]) {
        Stuff(Finish::Plastic, 0xd8483c)
    } else if says(&["dance", "pole"]) {
        stuff::CHROME
    } else if says(&["stylus"]) {
        stuff::DARK_PLASTIC
    } else if says(&["stick"]) {
        wood
    } else {
        Stuff(Finish::Metal, 0x9aa0a5)
    };
    let main = a.main(usual);
    if says(&["stylus", "stick"]) {
        return long(a, |mesh| {
            shaft(mesh, [1.0, 0.9], &main);
            cone(mesh, at(0.0, 0.0, 0.98), at(0.0, 0.0, 1.08), [0.8, 0.15], &steel);
        });
    }
    if says(&["dance", "pole"]) {
        return long(a, |mesh| {
            shaft(mesh, [0.6, 0.6], &main);
            for z in [-1.0..-0.985, 0.985..1.0] {
                cone(mesh, at(0.0, 0.0, z.start), at(0.0, 0.0, z.end), [1.0, 1.0], &main);
            }
        });
    }
    round(a, |mesh| {
        mesh.lathe(
            block(-1.0..1.0, 0.0..1.0, -1.0..1.0),
            &[(1.0, 0.0), (1.0, 1.0), (0.78, 1.0), (0.78, 0.03)],
            24,
            &main,
        );
    })
}

/// A locomotive; a lorry to push; a small train on a ring of rails.
pub(super) fn train(a: &Ask) -> BuiltModel {
    let truck = a.says(&["truck", "lorry"]);
    let body = a.main(if truck { Stuff(Finish::Paint, 0xe0a52f) } else { Stuff(Finish::Paint, 0xb5332c) });
    let dark = stuff::DARK_PLASTIC.surface();
    let glass = of(Finish::Screen, 0x2b3844);
    if a.says(&["set"]) {
        return train_set(a, &body, &dark);
    }
    headed(a, |mesh| {
        let wheels = |mesh: &mut Mesh, r: f64, places: &[f64]| {
            for z in places {
                for x in [-0.32..-0.22, 0.22..0.32] {
                    mesh.disc(0, block(x.clone(), 0.0..2.0 * r, z - r..z + r), &dark);
                    let out = if x.start < 0.0 { x.start - 0.015..x.start + 0.02 } else { x.end - 0.02..x.end + 0.015 };
                    mesh.disc(0, block(out, 0.5 * r..1.5 * r, z - 0.5 * r..z + 0.5 * r), &of(Finish::Paint, 0xe3bd3a));
                }
            }
        };
        mesh.rounded(block(-0.26..0.26, 0.14..0.26, -0.95..0.95), 0.03, 1, &dark);
        if truck {
            wheels(mesh, 0.15, &[-0.62, -0.28, 0.6]);
            mesh.rounded(block(-0.3..0.3, 0.24..0.72, 0.32..0.92), 0.06, 2, &body);
            mesh.crisp(block(-0.26..0.26, 0.46..0.66, 0.88..0.935), &glass);
            for x in [-0.31..-0.27, 0.27..0.31] {
                mesh.crisp(block(x, 0.46..0.64, 0.5..0.8), &glass);
            }
            let bed = of(Finish::Paint, 0x3f6f8c);
            mesh.crisp(block(-0.3..0.3, 0.26..0.32, -0.95..0.28), &bed);
            for side in block(-0.3..-0.26, 0.3..0.58, -0.95..0.28).both_sides() {
                mesh.crisp(side, &bed);
            }
            for end in [-0.94..-0.9, 0.23..0.27] {
                mesh.crisp(block(-0.27..0.27, 0.31..0.57, end), &bed);
            }
            return;
        }
        wheels(mesh, 0.14, &[-0.7, -0.36, 0.05, 0.38, 0.7]);
        mesh.disc(2, block(-0.2..0.2, 0.26..0.66, -0.3..0.86), &body);
        mesh.disc(2, block(-0.21..0.21, 0.25..0.67, 0.8..0.92), &dark);
        mesh.rounded(block(-0.28..0.28, 0.24..0.82, -0.95..-0.3), 0.03, 1, &body);
        mesh.rounded(block(-0.32..0.32, 0.8..0.88, -1.0..-0.25), 0.03, 1, &dark);
        for x in [-0.29..-0.25, 0.25..0.29] {
            mesh.crisp(block(x, 0.5..0.74, -0.8..-0.45), &glass);
        }
        mesh.lathe(
            block(-0.08..0.08, 0.6..0.98, 0.58..0.74),
            &[(0.7, 0.0), (0.7, 0.7), (1.0, 0.75), (1.0, 1.0)],
            16,
            &dark,
        );
        mesh.ball(block(-0.09..0.09, 0.58..0.76, 0.2..0.38), &stuff::BRASS.surface());
        mesh.disc(2, block(-0.06..0.06, 0.6..0.72, 0.9..0.96), &of(Finish::Glow, 0xfff4d6));
        mesh.extrude(0, &[(0.06, 0.94), (0.24, 0.9), (0.06, 1.08)], -0.24..0.24, &dark);
    })
}

/// Rails on sleepers, an engine and two wagons.
fn train_set(a: &Ask, body: &Surface, dark: &Surface) -> BuiltModel {
    let wood = stuff::OAK.surface();
    small(a, |mesh| {
        for k in 0..20 {
            mesh.place(at(0.0, 0.0, 0.0), [0.0, 18.0 * f64::from(k), 0.0], |mesh| {
                mesh.crisp(block(0.7..1.0, 0.0..0.04, -0.05..0.05), &wood);
            });
        }
        for r in [0.78, 0.94] {
            mesh.torus(block(-r..r, 0.03..0.07, -r..r), 0.03, &stuff::STEEL.surface());
        }
        for (turn, high) in [(0.0, 0.3), (30.0, 0.2), (60.0, 0.2)] {
            mesh.place(at(0.0, 0.0, 0.0), [0.0, turn, 0.0], |mesh| {
                mesh.rounded(block(0.77..0.95, 0.1..0.08 + high, -0.18..0.18), 0.03, 1, body);
                for x in [0.76..0.79, 0.93..0.96] {
                    for z in [-0.1, 0.1] {
                        mesh.disc(0, block(x.clone(), 0.06..0.16, z - 0.05..z + 0.05), dark);
                    }
                }
            });
        }
        mesh.rod(at(0.86, 0.36, -0.1), at(0.86, 0.46, -0.1), 0.03, dark);
    })
}
