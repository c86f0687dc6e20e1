//! What children ride, and machines that are ridden: sleds, tricycles, a tractor, an aeroplane.

use super::strokes::{at, blade, cone, headed, of};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;

/// Two runners that turn up, and slats; a sleigh has a seat between high sides.
pub(super) fn sled(a: &Ask) -> BuiltModel {
    let sleigh = a.says(&["sleigh", "sledge"]) && a.h > 0.5;
    let wood = a.main(if sleigh { Stuff(Finish::Paint, 0xa8282c) } else { Stuff(Finish::Wood, 0xb9803f) });
    let runner = if sleigh { stuff::BRASS.surface() } else { shade(&wood, 0.8) };
    headed(a, |mesh| {
        for side in [-1.0, 1.0] {
            let x = 0.36 * side;
            let curve = [at(x, 0.04, -1.0), at(x, 0.04, 0.7), at(x, 0.12, 0.9), at(x, 0.34, 1.02), at(x, 0.46, 0.9)];
            mesh.tube(&curve, 0.04, &runner);
            for z in [-0.7, 0.5] {
                mesh.rod(at(x, 0.04, z), at(0.9 * x, 0.4, z), 0.03, &runner);
            }
        }
        if sleigh {
            mesh.rounded(block(-0.4..0.4, 0.36..0.46, -0.9..0.8), 0.03, 1, &wood);
            for side in block(-0.46..-0.38, 0.38..0.9, -0.9..0.2).both_sides() {
                mesh.rounded(side, 0.03, 1, &wood);
            }
            mesh.rounded(block(-0.46..0.46, 0.4..1.2, -1.0..-0.86), 0.05, 2, &wood);
            mesh.sweep(
                &[(at(0.0, 0.4, 0.72), 0.42, 0.06), (at(0.0, 0.7, 0.86), 0.42, 0.05), (at(0.0, 0.92, 0.7), 0.42, 0.03)],
                at(1.0, 0.0, 0.0).cross(&at(0.0, 0.0, 1.0)),
                8,
                &wood,
            );
            mesh.rounded(block(-0.38..0.38, 0.46..0.66, -0.86..-0.3), 0.08, 2, &of(Finish::Velvet, 0x5a1f24));
            return;
        }
        for x in block(-0.42..0.42, 0.4..0.46, -1.0..0.7).split(0, 5, 0.04) {
            mesh.rounded(x, 0.015, 1, &wood);
        }
        for z in [-0.7, 0.5] {
            mesh.crisp(block(-0.44..0.44, 0.34..0.41, z - 0.05..z + 0.05), &runner);
        }
        mesh.tube(
            &[at(-0.34, 0.42, 0.88), at(0.0, 0.5, 1.1), at(0.34, 0.42, 0.88)],
            0.015,
            &of(Finish::Fabric, 0xc8392f),
        );
    })
}

/// A tyre with spokes, its axle along x.
fn tyre(mesh: &mut Mesh, x: f64, z: f64, r: f64, rim: &Surface) {
    let half = 0.14 * r;
    mesh.place(at(x, r, z), [0.0, 0.0, 90.0], |mesh| {
        mesh.torus(block(-r..r, -half..half, -r..r), 0.24, &stuff::RUBBER.surface());
        mesh.drum(block(-0.16 * r..0.16 * r, -1.6 * half..1.6 * half, -0.16 * r..0.16 * r), rim);
        for k in 0..4 {
            mesh.place(at(0.0, 0.0, 0.0), [0.0, 45.0 * f64::from(k), 0.0], |mesh| {
                mesh.rod(at(-0.84 * r, 0.0, 0.0), at(0.84 * r, 0.0, 0.0), 0.025 * r, rim);
            });
        }
    });
}

/// A big wheel in front, two behind, a saddle and a handlebar; a unicycle has one wheel.
pub(super) fn tricycle(a: &Ask) -> BuiltModel {
    let one = a.says(&["unicycle"]);
    let paint = a.main(Stuff(Finish::Paint, 0xc8392f));
    let (dark, chrome) = (stuff::DARK_PLASTIC.surface(), stuff::CHROME.surface());
    headed(a, |mesh| {
        if one {
            tyre(mesh, 0.0, 0.0, 0.5, &chrome);
            for side in [-1.0, 1.0] {
                mesh.tube(&[at(side * 0.12, 0.5, 0.0), at(side * 0.12, 1.06, 0.0), at(0.0, 1.14, 0.0)], 0.03, &paint);
                mesh.rod(at(side * 0.14, 0.5, 0.0), at(side * 0.16, 0.5 - 0.22 * side, 0.0), 0.02, &chrome);
                mesh.crisp(
                    block(-0.1..0.1, -0.02..0.02, -0.08..0.08).moved(side * 0.24, 0.5 - 0.22 * side, 0.0),
                    &dark,
                );
            }
            mesh.rod(at(0.0, 1.1, 0.0), at(0.0, 1.36, 0.0), 0.035, &chrome);
            mesh.sweep(
                &[(at(0.0, 1.44, -0.3), 0.14, 0.06), (at(0.0, 1.38, 0.0), 0.08, 0.05), (at(0.0, 1.44, 0.3), 0.1, 0.06)],
                at(0.0, 1.0, 0.0),
                12,
                &dark,
            );
            return;
        }
        tyre(mesh, 0.0, 0.6, 0.42, &chrome);
        for side in [-0.4, 0.4] {
            tyre(mesh, side, -0.62, 0.26, &chrome);
        }
        mesh.rod(at(-0.42, 0.26, -0.62), at(0.42, 0.26, -0.62), 0.03, &chrome);
        for side in [-1.0, 1.0] {
            mesh.tube(&[at(side * 0.12, 0.42, 0.6), at(side * 0.12, 0.88, 0.5), at(0.0, 0.94, 0.46)], 0.03, &paint);
            mesh.rod(at(side * 0.1, 0.42, 0.6), at(side * 0.3, 0.42 + 0.14 * side, 0.6), 0.02, &chrome);
            mesh.crisp(block(-0.08..0.08, -0.03..0.03, -0.07..0.07).moved(side * 0.3, 0.42 + 0.14 * side, 0.6), &dark);
        }
        mesh.rod(at(0.0, 0.9, 0.48), at(0.0, 1.2, 0.38), 0.035, &paint);
        mesh.tube(
            &[at(-0.4, 1.18, 0.24), at(-0.2, 1.22, 0.36), at(0.2, 1.22, 0.36), at(0.4, 1.18, 0.24)],
            0.03,
            &chrome,
        );
        for side in [-1.0, 1.0] {
            mesh.rod(at(side * 0.36, 1.185, 0.26), at(side * 0.5, 1.16, 0.16), 0.045, &dark);
        }
        mesh.tube(&[at(0.0, 0.9, 0.48), at(0.0, 0.6, 0.1), at(0.0, 0.5, -0.3), at(0.0, 0.3, -0.6)], 0.045, &paint);
        mesh.rod(at(0.0, 0.5, -0.26), at(0.0, 0.74, -0.3), 0.03, &chrome);
        mesh.sweep(
            &[(at(0.0, 0.76, -0.5), 0.2, 0.05), (at(0.0, 0.74, -0.2), 0.14, 0.05), (at(0.0, 0.74, 0.02), 0.06, 0.04)],
            at(0.0, 1.0, 0.0),
            12,
            &dark,
        );
    })
}

/// Two high wheels behind a bonnet with two low ones, a cabin of glass.
pub(super) fn tractor(a: &Ask) -> BuiltModel {
    let paint = a.main(Stuff(Finish::Paint, 0x3a7a3a));
    let (glass, dark) = (of(Finish::Screen, 0x2b3844), stuff::DARK_PLASTIC.surface());
    let yellow = of(Finish::Paint, 0xe3bd3a);
    headed(a, |mesh| {
        let wheel = |mesh: &mut Mesh, x: [f64; 2], z: f64, r: f64| {
            mesh.disc(0, block(x[0]..x[1], 0.0..2.0 * r, z - r..z + r), &stuff::RUBBER.surface());
            let (y, rim) = (r, 0.58 * r);
            mesh.disc(0, block(x[0] - 0.02..x[1] + 0.02, y - rim..y + rim, z - rim..z + rim), &yellow);
            for k in 0..16 {
                let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / 16.0).sin_cos();
                // Lugs stay above the ground.
                let (cy, cz) = (y + 0.97 * r * sin, z + 0.97 * r * cos);
                mesh.crisp(block(x[0]..x[1], (cy - 0.03).max(0.0)..cy + 0.03, cz - 0.03..cz + 0.03), &dark);
            }
        };
        for side in [-1.0, 1.0_f64] {
            let span = |near: f64, far: f64| if side < 0.0 { [-far, -near] } else { [near, far] };
            wheel(mesh, span(0.3, 0.52), -0.5, 0.44);
            wheel(mesh, span(0.26, 0.42), 0.66, 0.26);
            mesh.rounded(block(span(0.28, 0.54)[0]..span(0.28, 0.54)[1], 0.86..0.92, -0.9..-0.1), 0.02, 1, &paint);
        }
        mesh.rounded(block(-0.22..0.22, 0.3..0.5, -0.8..0.9), 0.03, 1, &dark);
        mesh.rounded(block(-0.24..0.24, 0.46..0.86, 0.0..1.0), 0.08, 2, &paint);
        for x in block(-0.2..0.2, 0.5..0.8, 0.98..1.02).split(1, 4, 0.03) {
            mesh.crisp(x, &dark);
        }
        mesh.rounded(block(-0.28..0.28, 0.5..0.8, -0.84..0.02), 0.03, 1, &paint);
        mesh.taper(block(-0.3..0.3, 0.8..0.81, -0.84..0.04), block(-0.26..0.26, 1.34..1.36, -0.78..-0.06), &glass);
        mesh.rounded(block(-0.32..0.32, 1.36..1.44, -0.86..0.02), 0.03, 1, &paint);
        mesh.rod(at(0.12, 0.8, 0.6), at(0.12, 1.24, 0.6), 0.03, &dark);
        for x in [-0.18, 0.18] {
            mesh.disc(2, block(-0.05..0.05, 0.68..0.78, 0.98..1.03).moved(x, 0.0, 0.0), &of(Finish::Glow, 0xfff4d6));
        }
    })
}

/// A fuselage, two wings, a tail and a propeller.
pub(super) fn plane(a: &Ask) -> BuiltModel {
    let paint = a.main(Stuff(Finish::Paint, 0xc8443a));
    let (white, dark) = (of(Finish::Paint, 0xdfe3e4), stuff::DARK_PLASTIC.surface());
    headed(a, |mesh| {
        let body = [
            (at(0.0, 0.36, -1.0), 0.04, 0.05),
            (at(0.0, 0.34, -0.4), 0.11, 0.13),
            (at(0.0, 0.32, 0.3), 0.16, 0.18),
            (at(0.0, 0.3, 0.8), 0.15, 0.16),
            (at(0.0, 0.3, 0.92), 0.09, 0.1),
        ];
        mesh.sweep(&body, at(0.0, 1.0, 0.0), 16, &paint);
        blade(mesh, at(0.0, 0.26, 0.36), [2.0, 0.44], 0.05, &white);
        blade(mesh, at(0.0, 0.4, -0.86), [0.72, 0.26], 0.04, &white);
        mesh.extrude(0, &[(0.38, -0.66), (0.38, -0.98), (0.72, -1.04), (0.72, -0.9)], -0.025..0.025, &paint);
        mesh.ball(block(-0.11..0.11, 0.4..0.58, -0.02..0.4), &of(Finish::Screen, 0x37506a));
        cone(mesh, at(0.0, 0.3, 0.9), at(0.0, 0.3, 1.04), [0.06, 0.01], &dark);
        mesh.rounded(block(-0.03..0.03, 0.02..0.58, 0.95..0.98), 0.01, 1, &dark);
        for side in [-1.0, 1.0] {
            mesh.rod(at(side * 0.1, 0.22, 0.4), at(side * 0.26, 0.08, 0.44), 0.02, &dark);
            mesh.disc(
                0,
                block(-0.04..0.04, 0.0..0.16, 0.36..0.52).moved(side * 0.28, 0.0, 0.0),
                &stuff::RUBBER.surface(),
            );
        }
        mesh.rod(at(0.0, 0.34, -0.9), at(0.0, 0.1, -0.94), 0.02, &dark);
    })
}
