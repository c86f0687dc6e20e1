//! Animals on four legs, as toys, as figures and (a horse) as they are; a duck for the bath and a pig for coins.

use super::strokes::{at, headed, of, pearl, small};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;

/// How an animal is built: its colour, how high and thick its body is, its neck (length, how much it leans forward), its head
/// and its snout.
struct Build {
    color: u32,
    legs: f64,
    body: [f64; 2],
    neck: [f64; 2],
    head: [f64; 2],
}

/// An animal that looks to the end of its box.
pub(super) fn animal(a: &Ask) -> BuiltModel {
    if a.says(&["duck"]) {
        return duck(a);
    }
    let says = |words: &[&str]| a.says(words);
    let build = if says(&["elephant"]) {
        Build { color: 0x8b9096, legs: 0.5, body: [0.42, 0.78], neck: [0.1, 0.2], head: [0.3, 0.1] }
    } else if says(&["giraffe"]) {
        Build { color: 0xd9a545, legs: 0.9, body: [0.24, 0.5], neck: [1.3, 0.45], head: [0.13, 0.22] }
    } else if says(&["dinosaur", "dino"]) {
        Build { color: 0x5f9a52, legs: 0.42, body: [0.34, 0.72], neck: [0.8, 0.6], head: [0.14, 0.2] }
    } else if says(&["lion"]) {
        Build { color: 0xcf9a48, legs: 0.5, body: [0.26, 0.66], neck: [0.16, 0.2], head: [0.24, 0.14] }
    } else if says(&["fox"]) {
        Build { color: 0xd0662b, legs: 0.42, body: [0.22, 0.6], neck: [0.2, 0.2], head: [0.2, 0.26] }
    } else if says(&["pig", "piggy"]) {
        Build { color: 0xe79aa8, legs: 0.26, body: [0.46, 0.72], neck: [0.02, 0.1], head: [0.3, 0.14] }
    } else if says(&["unicorn"]) {
        Build { color: 0xd9cfe6, legs: 0.7, body: [0.26, 0.6], neck: [0.5, 0.34], head: [0.16, 0.26] }
    } else {
        Build { color: 0x8a5a34, legs: 0.8, body: [0.26, 0.64], neck: [0.5, 0.36], head: [0.15, 0.3] }
    };
    let hide = a.main(Stuff(Finish::Fabric, build.color));
    headed(a, |mesh| draw(mesh, &build, &hide, &says))
}

fn draw(mesh: &mut Mesh, build: &Build, hide: &Surface, says: &dyn Fn(&[&str]) -> bool) {
    let dark = stuff::DARK_PLASTIC.surface();
    let Build { legs, body: [thick, long], neck: [neck, lean], head: [head, snout], .. } = *build;
    let back = legs + 2.0 * thick;
    mesh.ball(block(-0.8 * thick..0.8 * thick, legs..back, -long..long), hide);
    let leg = 0.3 * thick + 0.02;
    for z in [-0.62 * long, 0.62 * long] {
        for x in [-0.42 * thick, 0.42 * thick] {
            mesh.sweep(
                &[(at(x, 0.0, z), 0.8 * leg, 0.8 * leg), (at(x, legs + 0.6 * thick, z), leg, leg)],
                at(1.0, 0.0, 0.0),
                10,
                hide,
            );
            mesh.sweep(
                &[(at(x, 0.0, z), 0.84 * leg, 0.84 * leg), (at(x, 0.07, z), 0.84 * leg, 0.84 * leg)],
                at(1.0, 0.0, 0.0),
                10,
                &shade(hide, 0.5),
            );
        }
    }
    let root = at(0.0, back - 0.7 * thick, 0.74 * long);
    let top = at(0.0, back - 0.3 * thick + neck, 0.86 * long + lean * neck + 0.1);
    mesh.sweep(&[(root, 0.5 * thick, 0.6 * thick), (top, 0.7 * head, 0.8 * head)], at(1.0, 0.0, 0.0), 12, hide);
    mesh.ball(block(-head..head, -head..head, -1.05 * head..1.05 * head).moved(0.0, top.y, top.z), hide);
    let front = top.z + head;
    // What one knows it by.
    if says(&["elephant"]) {
        let trunk = [
            (at(0.0, top.y - 0.02, front - 0.1), 0.13, 0.13),
            (at(0.0, top.y - 0.2, front + 0.16), 0.1, 0.1),
            (at(0.0, 0.4, front + 0.2), 0.08, 0.08),
            (at(0.0, 0.26, front + 0.34), 0.06, 0.06),
        ];
        mesh.sweep(&trunk, at(1.0, 0.0, 0.0), 12, hide);
        for side in [-1.0, 1.0] {
            mesh.ball(
                block(-0.07..0.07, -0.34..0.3, -0.26..0.24).moved(side * (head + 0.02), top.y, top.z - 0.12),
                &shade(hide, 0.85),
            );
            mesh.sweep(
                &[
                    (at(side * 0.14, top.y - 0.16, front - 0.08), 0.035, 0.035),
                    (at(side * 0.17, top.y - 0.3, front + 0.24), 0.01, 0.01),
                ],
                at(1.0, 0.0, 0.0),
                8,
                &of(Finish::Ceramic, 0xf2ead8),
            );
        }
    } else {
        mesh.sweep(
            &[
                (at(0.0, top.y - 0.1 * head, top.z), 0.62 * head, 0.6 * head),
                (at(0.0, top.y - 0.35 * head, front + snout), 0.42 * head, 0.4 * head),
            ],
            at(0.0, 1.0, 0.0),
            12,
            hide,
        );
        if says(&["pig", "piggy"]) {
            mesh.disc(
                2,
                block(-0.16..0.16, top.y - 0.26..top.y + 0.04, front + 0.06..front + snout + 0.03),
                &shade(hide, 0.85),
            );
            mesh.crisp(block(-0.14..0.14, back - 0.012..back + 0.012, -0.05..0.05), &dark);
        } else {
            mesh.bead(
                block(-0.24 * head..0.24 * head, -0.16 * head..0.2 * head, -0.2 * head..0.2 * head).moved(
                    0.0,
                    top.y - 0.24 * head,
                    front + snout,
                ),
                &dark,
            );
        }
        ears(mesh, at(0.0, top.y, top.z), head, says(&["fox", "pig", "piggy"]), hide);
    }
    for side in [-1.0, 1.0] {
        let r = 0.14 * head;
        mesh.bead(block(-r..r, -r..r, -r..r).moved(side * 0.66 * head, top.y + 0.3 * head, top.z + 0.66 * head), &dark);
    }
    marks(mesh, build, (root, top), hide, says);
}

fn ears(mesh: &mut Mesh, at_head: scenelang_layout::Vec3, head: f64, pointed: bool, hide: &Surface) {
    for side in [-1.0, 1.0] {
        let foot = at_head + at(side * 0.55 * head, 0.7 * head, -0.1 * head);
        let tip = foot + at(side * 0.2 * head, if pointed { 0.9 } else { 0.6 } * head, 0.0);
        let wide = if pointed { 0.4 } else { 0.26 } * head;
        mesh.sweep(&[(foot, wide, 0.16 * head), (tip, 0.05 * head, 0.04 * head)], at(0.0, 0.0, 1.0), 8, hide);
    }
}

/// Mane, tail, spots, horn.
fn marks(
    mesh: &mut Mesh,
    build: &Build,
    (root, top): (scenelang_layout::Vec3, scenelang_layout::Vec3),
    hide: &Surface,
    says: &dyn Fn(&[&str]) -> bool,
) {
    let Build { legs, body: [thick, long], head: [head, _], .. } = *build;
    let rear = at(0.0, legs + 1.3 * thick, -0.94 * long);
    let side_on = at(1.0, 0.0, 0.0);
    let tail = |mesh: &mut Mesh, path: &[(f64, f64, f64)], s: &Surface| {
        let path: Vec<_> = path.iter().map(|(y, z, r)| (rear + at(0.0, *y, *z), *r, *r)).collect();
        mesh.sweep(&path, side_on, 10, s);
    };
    if says(&["dinosaur", "dino"]) {
        tail(mesh, &[(-0.1, 0.2, 0.26), (-0.2, -0.3, 0.16), (-0.3, -0.7, 0.07), (-0.2, -1.1, 0.02)], hide);
        for k in 0..7 {
            let z = -0.8 * long + 1.5 * long * f64::from(k) / 6.0;
            let y = legs + 2.0 * thick - 0.25 * thick * (z / long).powi(2);
            mesh.extrude(
                0,
                &[(y - 0.08, z - 0.09), (y - 0.08, z + 0.09), (y + 0.16, z)],
                -0.03..0.03,
                &of(Finish::Fabric, 0xd9823f),
            );
        }
    } else if says(&["lion"]) {
        let mane = of(Finish::Fabric, 0x7d4a20);
        for k in 0..12 {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / 12.0).sin_cos();
            let r = 0.15;
            mesh.bead(block(-r..r, -r..r, -0.12..0.12).moved(0.3 * cos, top.y + 0.3 * sin, top.z - 0.06), &mane);
        }
        tail(mesh, &[(0.0, 0.1, 0.04), (0.1, -0.3, 0.035), (0.3, -0.5, 0.03)], hide);
        mesh.bead(block(-0.08..0.08, 0.24..0.42, -0.6..-0.44).moved(0.0, rear.y, rear.z), &mane);
    } else if says(&["fox"]) {
        tail(mesh, &[(0.0, 0.1, 0.05), (0.04, -0.3, 0.16), (0.1, -0.6, 0.15)], hide);
        tail(mesh, &[(0.1, -0.58, 0.15), (0.14, -0.82, 0.02)], &stuff::SHEET.surface());
    } else if says(&["giraffe"]) {
        let spot = of(Finish::Fabric, 0x8a5226);
        for k in 0..14 {
            let (t, side) = (f64::from(k / 2) / 6.0, if k % 2 == 0 { 1.0 } else { -1.0 });
            let (z, up) = (-0.7 * long + 1.4 * long * t, [-0.4, 0.5, 0.05][k as usize / 2 % 3]);
            let x = 0.8 * thick * (1.0 - (z / long).powi(2) - up * up).max(0.0).sqrt();
            pearl(
                mesh,
                block(-0.05..0.05, -0.08..0.08, -0.07..0.07).moved(side * x, legs + thick * (1.0 + up), z),
                &spot,
            );
            let on = root + (top - root) * (0.15 + 0.7 * t);
            let x = 0.5 * thick * (1.0 - t) + 0.7 * head * t;
            pearl(mesh, block(-0.04..0.04, -0.06..0.06, -0.05..0.05).moved(side * x, on.y, on.z), &spot);
        }
        for side in [-1.0, 1.0] {
            mesh.rod(at(side * 0.06, top.y + 0.1, top.z), at(side * 0.08, top.y + 0.3, top.z - 0.02), 0.025, &spot);
        }
        tail(mesh, &[(0.0, 0.1, 0.03), (-0.4, -0.1, 0.03)], &spot);
    } else if says(&["elephant", "pig", "piggy"]) {
        tail(mesh, &[(0.0, 0.1, 0.03), (0.0, -0.08, 0.03), (-0.2, -0.12, 0.02)], hide);
    } else {
        let unicorn = says(&["unicorn"]);
        let mane = of(Finish::Fabric, if unicorn { 0xe07fae } else { 0x2e2018 });
        for k in 0..6 {
            let p = root + (top - root) * (0.25 + 0.17 * f64::from(k)) + at(0.0, 0.0, -0.14);
            mesh.ball(block(-0.05..0.05, -0.12..0.12, -0.1..0.1).moved(p.x, p.y, p.z), &mane);
        }
        tail(mesh, &[(0.08, 0.08, 0.05), (0.06, -0.14, 0.09), (-0.5, -0.22, 0.05)], &mane);
        if unicorn {
            mesh.sweep(
                &[
                    (at(0.0, top.y + 0.6 * head, top.z + 0.3 * head), 0.05, 0.05),
                    (at(0.0, top.y + 3.2 * head, top.z + 1.6 * head), 0.004, 0.004),
                ],
                side_on,
                10,
                &stuff::BRASS.surface(),
            );
        }
    }
}

/// A body, a head and a beak.
fn duck(a: &Ask) -> BuiltModel {
    let yellow = a.main(Stuff(Finish::Rubber, 0xf0c02c));
    small(a, |mesh| {
        let body = [(0.6, 0.0), (0.92, 0.2), (1.0, 0.5), (0.8, 0.85), (0.4, 1.0)];
        mesh.lathe(block(-0.62..0.62, 0.0..0.9, -0.9..0.8), &body, 24, &yellow);
        mesh.ball(block(-0.44..0.44, 0.78..1.66, -0.06..0.82), &yellow);
        mesh.sweep(
            &[(at(0.0, 0.6, -0.6), 0.3, 0.2), (at(0.0, 0.86, -0.92), 0.16, 0.08), (at(0.0, 1.02, -1.02), 0.04, 0.03)],
            at(0.0, 1.0, 0.0),
            10,
            &yellow,
        );
        let beak = of(Finish::Rubber, 0xe8752a);
        for (y, tip) in [(1.2, 1.22), (1.12, 1.04)] {
            mesh.sweep(&[(at(0.0, y, 0.7), 0.2, 0.06), (at(0.0, tip, 1.06), 0.14, 0.03)], at(0.0, 1.0, 0.0), 10, &beak);
        }
        for side in [-1.0, 1.0] {
            mesh.bead(
                block(-0.07..0.07, -0.09..0.09, -0.07..0.07).moved(side * 0.24, 1.36, 0.7),
                &stuff::DARK_PLASTIC.surface(),
            );
            mesh.ball(block(-0.1..0.1, -0.2..0.24, -0.42..0.3).moved(side * 0.56, 0.54, -0.1), &shade(&yellow, 0.88));
        }
    })
}
