//! What sport is done with: boards to stand on, hoops, nets, rackets, weights, targets, things to jump over.

use super::strokes::{at, blade, cone, headed, long, of, pearl, round, small};
use crate::ask::Ask;
use crate::block::{block, pieces};
use crate::loft::oval;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use std::f64::consts::TAU;

/// Boards to stand on, along their box: surfboard, snowboard, skateboard, and a pair of skis.
pub(super) fn surfboard(a: &Ask) -> BuiltModel {
    let dark = stuff::DARK_PLASTIC.surface();
    if a.says(&["ski"]) {
        let paint = a.main(Stuff(Finish::Paint, 0xc63b2c));
        return long(a, |mesh| {
            for x in [-0.5, 0.5] {
                let tip = [
                    (at(x, 0.0, -1.0), 0.3, 0.04),
                    (at(x, 0.0, 0.7), 0.28, 0.04),
                    (at(x, 0.06, 0.88), 0.3, 0.03),
                    (at(x, 0.3, 1.0), 0.06, 0.02),
                ];
                mesh.sweep(&tip, at(0.0, 1.0, 0.0), 8, &paint);
                mesh.rounded(block(x - 0.2..x + 0.2, 0.03..0.2, -0.2..-0.06), 0.03, 1, &dark);
                mesh.rounded(block(x - 0.2..x + 0.2, 0.03..0.16, 0.06..0.16), 0.03, 1, &dark);
            }
        });
    }
    if a.says(&["skateboard", "longboard"]) {
        let wood = a.main(Stuff(Finish::Wood, 0xc07d3e));
        return headed(a, |mesh| {
            let deck = [
                (at(0.0, 0.98, -1.0), 0.2, 0.02),
                (at(0.0, 0.78, -0.78), 0.3, 0.05),
                (at(0.0, 0.72, -0.6), 0.33, 0.06),
                (at(0.0, 0.72, 0.6), 0.33, 0.06),
                (at(0.0, 0.78, 0.78), 0.3, 0.05),
                (at(0.0, 0.98, 1.0), 0.2, 0.02),
            ];
            mesh.sweep(&deck, at(0.0, 1.0, 0.0), 8, &wood);
            for z in [-0.52, 0.52] {
                mesh.rounded(block(-0.08..0.08, 0.3..0.7, z - 0.06..z + 0.06), 0.02, 1, &stuff::STEEL.surface());
                mesh.rod(at(-0.3, 0.25, z), at(0.3, 0.25, z), 0.03, &stuff::STEEL.surface());
                for x in [-0.32..-0.16, 0.16..0.32] {
                    mesh.disc(0, block(x, 0.0..0.5, z - 0.09..z + 0.09), &of(Finish::Plastic, 0xe8e2d4));
                }
            }
        });
    }
    let surf = a.says(&["surfboard", "surf", "paddleboard"]);
    let main = a.main(if surf { Stuff(Finish::Plastic, 0x4aa3c0) } else { Stuff(Finish::Plastic, 0x7a4fa0) });
    long(a, |mesh| {
        let stripe = shade(&main, 1.9);
        if surf {
            blade(mesh, at(0.0, 0.0, 0.0), [0.52, 2.0], 0.06, &main);
            mesh.crisp(block(-0.012..0.012, -0.034..0.034, -0.94..0.94), &stripe);
            mesh.crisp(block(-0.22..0.22, -0.033..0.033, 0.14..0.24), &stripe);
            for x in [-0.12, 0.0, 0.12] {
                mesh.extrude(0, &[(-0.02, -0.86), (-0.02, -0.7), (-0.14, -0.88)], x - 0.008..x + 0.008, &stripe);
            }
        } else {
            let deck = [
                (at(0.0, 0.1, -1.0), 0.08, 0.015),
                (at(0.0, 0.02, -0.88), 0.16, 0.02),
                (at(0.0, 0.0, -0.7), 0.19, 0.02),
                (at(0.0, 0.0, 0.0), 0.16, 0.02),
                (at(0.0, 0.0, 0.7), 0.19, 0.02),
                (at(0.0, 0.02, 0.88), 0.16, 0.02),
                (at(0.0, 0.1, 1.0), 0.08, 0.015),
            ];
            mesh.sweep(&deck, at(0.0, 1.0, 0.0), 8, &main);
            for z in [-0.3, 0.3] {
                mesh.rounded(block(-0.13..0.13, 0.01..0.06, z - 0.06..z + 0.06), 0.02, 1, &shade(&main, 0.4));
                mesh.rounded(block(-0.1..0.1, 0.05..0.12, z - 0.05..z + 0.03), 0.02, 1, &shade(&main, 0.4));
            }
        }
    })
}

/// A ring: to turn about the hips, to hang from, and, of leaves, for a door.
pub(super) fn hoop(a: &Ask) -> BuiltModel {
    if a.says(&["wreath"]) {
        let leaf = stuff::LEAF.surface();
        return round(a, |mesh| {
            mesh.torus(block(-0.9..0.9, -0.14..0.14, -0.9..0.9), 0.3, &shade(&leaf, 0.7));
            for k in 0..30 {
                let (sin, cos) = (TAU * f64::from(k) / 30.0).sin_cos();
                let r = if k % 2 == 0 { 0.86 } else { 0.66 };
                let tint = if k % 3 == 0 { shade(&leaf, 1.25) } else { leaf.clone() };
                pearl(mesh, block(-0.14..0.14, -0.16..0.16, -0.14..0.14).moved(r * cos, 0.0, r * sin), &tint);
            }
            for k in 0..6 {
                let (sin, cos) = (TAU * (f64::from(k) + 0.4) / 6.0).sin_cos();
                pearl(
                    mesh,
                    block(-0.06..0.06, 0.08..0.2, -0.06..0.06).moved(0.76 * cos, 0.0, 0.76 * sin),
                    &stuff::RED.surface(),
                );
            }
        });
    }
    let usual = if a.says(&["gym"]) { Stuff(Finish::Wood, 0xc99a5f) } else { Stuff(Finish::Plastic, 0xd64f7c) };
    let main = a.main(usual);
    let thick = if a.says(&["gym"]) { 0.26 } else { 0.07 };
    round(a, |mesh| mesh.torus(block(-1.0..1.0, -0.05..0.05, -1.0..1.0), thick, &main))
}

/// A board with a ring and a net; on a pole with a heavy foot where it is high.
pub(super) fn basketball_hoop(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let stands = a.h > 1.6;
    let orange = of(Finish::Paint, 0xd8602a);
    let face = a.main(Stuff(Finish::Plastic, 0xdfe6ea));
    let dark = a.second(stuff::BLACK_STEEL);
    let low = if stands { 0.66 } else { 0.0 };
    let (front, back) = if stands { (0.5, 0.44) } else { (0.1, 0.0) };
    if stands {
        m.rounded(b.share(0.1..0.9, 0.0..0.07, 0.0..1.0), 0.05, &dark);
        m.board(b.share(0.44..0.56, 0.07..0.9, 0.16..0.26), &dark);
        m.board(b.share(0.46..0.54, 0.8..0.84, 0.26..0.44), &dark);
    }
    let panel = b.share(0.0..1.0, low..1.0, back..front);
    m.board(panel, &face);
    let mark = panel.share(0.34..0.66, 0.28..0.66, 1.0..1.06);
    for edge in [
        mark.share(0.0..1.0, 0.0..0.1, 0.0..1.0),
        mark.share(0.0..1.0, 0.9..1.0, 0.0..1.0),
        mark.share(0.0..0.08, 0.1..0.9, 0.0..1.0),
        mark.share(0.92..1.0, 0.1..0.9, 0.0..1.0),
    ] {
        m.mesh.crisp(edge, &orange);
    }
    let z = if stands { 0.54..0.96 } else { 0.2..1.0 };
    let rim = panel.share(0.31..0.69, 0.2..0.25, 0.0..1.0);
    let rim = rim.z(b.min.z + z.start * a.d..b.min.z + z.end * a.d);
    m.solid(rim.y(rim.min.y - 0.18 * panel.size().y..rim.max.y));
    m.mesh.torus(rim, 0.1, &orange);
    m.board(b.share(0.45..0.55, 0.0..1.0, front..z.start + 0.03).y(rim.min.y..rim.max.y), &orange);
    let net = rim.y(rim.min.y - 0.18 * panel.size().y..rim.min.y);
    let (c, cord) = (net.center(), stuff::SHEET.surface());
    let r = (0.02 * rim.size().x.min(rim.size().z)).min(0.01);
    for k in 0..12 {
        let point = |turn: f64, y: f64, share: f64| {
            let (sin, cos) = (TAU * turn / 12.0).sin_cos();
            at(c.x + 0.48 * share * rim.size().x * cos, y, c.z + 0.48 * share * rim.size().z * sin)
        };
        let k = f64::from(k);
        m.mesh.rod(point(k, net.max.y, 0.95), point(k + 1.0, net.min.y + r, 0.62), r, &cord);
        m.mesh.rod(point(k, net.max.y, 0.95), point(k - 1.0, net.min.y + r, 0.62), r, &cord);
    }
    m
}

/// Two posts with a net between them; it runs along the longer side.
pub(super) fn net(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let post = a.main(stuff::BLACK_STEEL);
    let cord = of(Finish::Fabric, 0x4a4f52);
    let along = a.w >= a.d;
    let share = |long: std::ops::Range<f64>, y: std::ops::Range<f64>, deep: std::ops::Range<f64>| {
        if along { b.share(long, y, deep) } else { b.share(deep, y, long) }
    };
    for end in [0.0..0.02, 0.98..1.0] {
        m.board(share(end, 0.0..1.0, 0.0..1.0), &post);
    }
    m.solid(share(0.02..0.98, 0.1..0.95, 0.4..0.6));
    m.mesh.crisp(share(0.02..0.98, 0.9..0.96, 0.36..0.64), &stuff::SHEET.surface());
    let (length, columns) = (a.w.max(a.d), pieces(a.w.max(a.d), 0.12, 10, 34));
    let thin = (0.008 / length).min(0.004);
    for k in 1..columns {
        let x = 0.02 + 0.96 * k as f64 / columns as f64;
        m.mesh.crisp(share(x - thin..x + thin, 0.1..0.9, 0.46..0.54), &cord);
    }
    for k in 0..7 {
        let y = 0.1 + 0.8 * f64::from(k) / 7.0;
        m.mesh.crisp(share(0.02..0.98, y..y + 0.012, 0.45..0.55), &cord);
    }
    m
}

/// A frame with strings on a handle; a glass for a magnifier.
pub(super) fn racket(a: &Ask) -> BuiltModel {
    let glass = a.says(&["magnifier", "magnifying"]);
    let usual = if glass { Stuff(Finish::Brass, 0xb9964f) } else { Stuff(Finish::Plastic, 0x2f5fa0) };
    let frame = a.main(usual);
    let dark = stuff::DARK_PLASTIC.surface();
    long(a, |mesh| {
        mesh.torus(block(-0.42..0.42, -0.05..0.05, -0.1..1.0), 0.14, &frame);
        if glass {
            mesh.ball(block(-0.38..0.38, -0.04..0.04, -0.06..0.96), &stuff::GLASS.surface());
            cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, -0.08), [0.08, 0.06], &dark);
            return;
        }
        for k in -4..=4 {
            let t = f64::from(k) * 0.085;
            let half = (1.0 - (t / 0.42).powi(2)).sqrt();
            mesh.crisp(
                block(t - 0.006..t + 0.006, -0.006..0.006, 0.45 - 0.52 * half..0.45 + 0.52 * half),
                &stuff::SHEET.surface(),
            );
        }
        for k in -5..=5 {
            let t = f64::from(k) * 0.09;
            let half = 0.4 * (1.0 - (t / 0.55).powi(2)).sqrt();
            mesh.crisp(block(-half..half, -0.009..0.009, 0.444 + t..0.456 + t), &stuff::SHEET.surface());
        }
        for side in [-1.0, 1.0] {
            cone(mesh, at(side * 0.2, 0.0, -0.02), at(0.0, 0.0, -0.38), [0.03, 0.03], &frame);
        }
        mesh.rounded(block(-0.05..0.05, -0.045..0.045, -1.0..-0.36), 0.03, 2, &dark);
    })
}

/// A bar with plates at its ends.
pub(super) fn barbell(a: &Ask) -> BuiltModel {
    let plate = a.main(Stuff(Finish::Rubber, 0x2a2b2d));
    let steel = stuff::CHROME.surface();
    long(a, |mesh| {
        cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, 1.0), [0.03, 0.03], &steel);
        for side in [-1.0, 1.0] {
            for (z, r, s) in
                [(0.66, 0.24, &plate), (0.725, 0.24, &stuff::RED.surface()), (0.79, 0.17, &plate), (0.85, 0.06, &steel)]
            {
                cone(mesh, at(0.0, 0.0, side * (z - 0.028)), at(0.0, 0.0, side * (z + 0.028)), [r, r], s);
            }
            cone(mesh, at(0.0, 0.0, side * 0.62), at(0.0, 0.0, side), [0.045, 0.045], &steel);
        }
    })
}

const RINGS: [u32; 5] = [0xf2f0ea, 0x2a2b2d, 0x3f7fb5, 0xc8392f, 0xe8c445];

/// A round target of coloured rings on three legs.
pub(super) fn archery_target(a: &Ask) -> BuiltModel {
    let wood = a.main(stuff::OAK);
    small(a, |mesh| {
        for side in [-1.0, 1.0] {
            mesh.rod(at(side * 0.5, 0.03, 0.15), at(side * 0.15, 1.28, -0.1), 0.03, &wood);
        }
        mesh.rod(at(0.0, 0.03, -0.5), at(0.0, 1.2, -0.12), 0.03, &wood);
        mesh.rod(at(-0.45, 0.24, 0.12), at(0.45, 0.24, 0.12), 0.025, &wood);
        mesh.place(at(0.0, 0.8, 0.12), [-10.0, 0.0, 0.0], |mesh| {
            mesh.disc(2, block(-0.6..0.6, -0.6..0.6, -0.08..0.06), &of(Finish::Wicker, 0xd2ae6a));
            for (k, color) in RINGS.iter().enumerate() {
                let (r, z) = (0.56 - 0.108 * k as f64, 0.05 + 0.012 * k as f64);
                mesh.disc(2, block(-r..r, -r..r, z..z + 0.02), &of(Finish::Paper, *color));
            }
        });
    })
}

/// A point, a grip, a shaft with four vanes.
pub(super) fn dart(a: &Ask) -> BuiltModel {
    let vane = a.main(Stuff(Finish::Plastic, 0xc8392f));
    long(a, |mesh| {
        cone(mesh, at(0.0, 0.0, 0.6), at(0.0, 0.0, 1.0), [0.02, 0.004], &stuff::STEEL.surface());
        cone(mesh, at(0.0, 0.0, 0.0), at(0.0, 0.0, 0.62), [0.055, 0.06], &stuff::BRASS.surface());
        cone(mesh, at(0.0, 0.0, -0.9), at(0.0, 0.0, 0.0), [0.02, 0.03], &stuff::DARK_PLASTIC.surface());
        for turn in [0.0, 90.0] {
            mesh.place(at(0.0, 0.0, 0.0), [0.0, 0.0, turn], |mesh| {
                mesh.extrude(
                    1,
                    &[(-0.45, 0.0), (-0.6, -0.16), (-1.0, -0.16), (-1.0, 0.16), (-0.6, 0.16)],
                    -0.008..0.008,
                    &vane,
                );
            });
        }
    })
}

/// A beam on spread legs, to balance on or to lay boards on; a bar between two posts to jump over.
pub(super) fn trestle(a: &Ask) -> BuiltModel {
    if a.says(&["hurdle"]) {
        return hurdle(a);
    }
    let mut m = BuiltModel::default();
    let b = a.whole();
    let balance = a.says(&["balance"]);
    let wood = a.main(Stuff(Finish::Wood, 0xc29a66));
    let along = a.w >= a.d;
    let legs = if balance { stuff::BLACK_STEEL.surface() } else { shade(&wood, 0.85) };
    // The beam runs along z in a frame of its own.
    let rot = [0.0, if along { 90.0 } else { 0.0 }, 0.0];
    let top = if balance { 0.74 } else { 0.86 };
    let share = |long: std::ops::Range<f64>, y: std::ops::Range<f64>| {
        if along { b.share(long, y, 0.0..1.0) } else { b.share(0.0..1.0, y, long) }
    };
    m.solid(share(0.0..1.0, top..1.0));
    for end in [0.06..0.2, 0.8..0.94] {
        m.solid(share(end, 0.0..top));
    }
    let pale = if balance { stuff::LINEN.surface() } else { wood };
    m.mesh.stretch(b, |mesh| {
        mesh.place(at(0.0, 0.0, 0.0), rot, |mesh| {
            let half = if balance { 1.0 } else { 0.4 };
            mesh.rounded(block(-half..half, top..1.0, -1.0..1.0), 0.02, 1, &pale);
            for z in [-0.72, 0.72] {
                for side in [-1.0, 1.0] {
                    let leg = [(at(side * 0.2, top + 0.05, z), 0.16, 0.05), (at(side * 0.84, 0.0, z), 0.16, 0.05)];
                    mesh.sweep(&leg, at(0.0, 0.0, 1.0), 4, &legs);
                }
                mesh.crisp(block(-0.56..0.56, 0.3..0.38, z - 0.02..z + 0.02), &legs);
            }
        });
    });
    m
}

fn hurdle(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let steel = stuff::STEEL.surface();
    for foot in b.share(0.02..0.07, 0.0..0.04, 0.0..1.0).both_sides() {
        m.board(foot, &steel);
    }
    for post in b.share(0.025..0.065, 0.04..0.9, 0.42..0.5).both_sides() {
        m.board(post, &steel);
    }
    let bar = b.share(0.0..1.0, 0.84..1.0, 0.4..0.44);
    m.solid(bar);
    for (k, piece) in bar.split(0, 5, 0.0).enumerate() {
        let s = if k % 2 == 0 { a.main(Stuff(Finish::Paint, 0xc8392f)) } else { stuff::WHITE.surface() };
        m.mesh.crisp(piece, &s);
    }
    m
}

/// A rhombus of cloth with a tail of ribbons.
pub(super) fn kite(a: &Ask) -> BuiltModel {
    let cloth = a.main(Stuff(Finish::Fabric, 0xd64f3c));
    let other = shade(&cloth, 1.7);
    long(a, |mesh| {
        mesh.extrude(1, &[(1.0, 0.0), (0.4, 0.6), (0.4, 0.0)], -0.012..0.012, &cloth);
        mesh.extrude(1, &[(1.0, 0.0), (0.4, -0.6), (0.4, 0.0)], -0.012..0.012, &other);
        mesh.extrude(1, &[(-0.5, 0.0), (0.4, 0.6), (0.4, 0.0)], -0.012..0.012, &other);
        mesh.extrude(1, &[(-0.5, 0.0), (0.4, -0.6), (0.4, 0.0)], -0.012..0.012, &cloth);
        mesh.rod(at(0.0, -0.01, -0.5), at(0.0, -0.01, 0.99), 0.015, &stuff::OAK.surface());
        mesh.rod(at(-0.59, -0.01, 0.4), at(0.59, -0.01, 0.4), 0.015, &stuff::OAK.surface());
        mesh.tube(
            &[at(0.0, 0.0, -0.5), at(0.06, 0.0, -0.66), at(-0.06, 0.0, -0.82), at(0.02, 0.0, -1.0)],
            0.01,
            &stuff::LINEN.surface(),
        );
        for (x, z) in [(0.05, -0.64), (-0.04, -0.8), (0.02, -0.95)] {
            for side in [-1.0, 1.0] {
                mesh.extrude(1, &[(z, x), (z + 0.05, x + side * 0.1), (z - 0.05, x + side * 0.1)], -0.01..0.01, &cloth);
            }
        }
    })
}

/// Boats along their box: open to row, with a mast and sails where it is a model, long and pointed to paddle.
pub(super) fn boat(a: &Ask) -> BuiltModel {
    let paddled = a.says(&["canoe", "kayak"]);
    let sails = a.says(&["toy", "model", "sail", "sailing", "ship", "sailboat"]);
    let usual = if paddled { Stuff(Finish::Plastic, 0xd0682c) } else { Stuff(Finish::Wood, 0x8f5a33) };
    let hull = a.main(if sails { Stuff(Finish::Paint, 0x2f6fa8) } else { usual });
    headed(a, |mesh| {
        let deck = if a.says(&["kayak"]) { 1.0 } else { 0.0 };
        let taper = if paddled { 1.5 } else { 1.1 };
        let wide = if sails { 0.34 } else { 0.4 };
        let top = if sails { 0.4 } else { 1.0 };
        skin(mesh, [wide, top], taper, deck, &hull);
        if sails {
            mesh.rod(at(0.0, 0.1, 0.1), at(0.0, 1.6, 0.1), 0.02, &stuff::OAK.surface());
            mesh.extrude(0, &[(0.5, 0.02), (1.55, 0.06), (0.5, -0.85)], -0.012..0.012, &stuff::SHEET.surface());
            mesh.extrude(0, &[(0.48, 0.9), (1.4, 0.16), (0.48, 0.18)], -0.012..0.012, &stuff::SHEET.surface());
        } else if deck == 0.0 {
            for z in [-0.45, 0.0, 0.45] {
                mesh.crisp(block(-0.33..0.33, 0.7..0.76, z - 0.08..z + 0.08), &stuff::OAK.surface());
            }
        }
    })
}

/// The skin of a hull: how wide and high it is, how pointed, and whether a deck closes it (1) or it is open (0).
fn skin(mesh: &mut Mesh, [wide, top]: [f64; 2], taper: f64, deck: f64, s: &Surface) {
    // Bow and stern rise.
    let rise = |mut ring: Vec<scenelang_layout::Vec3>| {
        ring.iter_mut().for_each(|p| p.y += 0.28 * top * p.z.abs().powi(3));
        ring
    };
    let ring = |y: f64, x: f64, z: f64| rise(oval(top * y, [0.0; 2], [wide * x, z], taper));
    let outer = [ring(0.0, 0.5, 0.72), ring(0.2, 0.8, 0.86), ring(0.6, 0.96, 0.95), ring(0.9, 1.0, 1.0)];
    if deck > 0.0 {
        let lid = [ring(0.95, 0.98, 0.98), ring(1.2, 0.5, 0.7)];
        mesh.loft(&[&outer[..], &lid[..]].concat(), s);
        mesh.drum(block(-0.2..0.2, 1.1 * top..1.3 * top, -0.3..0.16), &stuff::DARK_PLASTIC.surface());
        return;
    }
    let inner = [ring(0.9, 0.9, 0.95), ring(0.3, 0.72, 0.82)];
    mesh.loft(&[&outer[..], &inner[..]].concat(), s);
}
