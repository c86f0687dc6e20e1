//! What one cooks and eats with: forks, knives and spoons, ladles, spatulas, whisks, tongs, corkscrews.

use super::strokes::{at, blade, cone, long, of};
use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use scenelang_layout::Vec3;

/// A utensil by its name; a spoon if it says nothing more.
pub(super) fn utensil(a: &Ask) -> BuiltModel {
    let wooden = a.says(&["wooden", "utensil"]);
    let usual = if wooden { Stuff(Finish::Wood, 0xb98a55) } else { Stuff(Finish::Metal, 0xaab0b5) };
    let steel = a.main(usual);
    let dark = stuff::DARK_PLASTIC.surface();
    long(a, |mesh| {
        if a.says(&["fork"]) {
            fork(mesh, 0.0, &steel);
        } else if a.says(&["knife"]) {
            knife(mesh, 0.0, &dark, &steel);
        } else if a.says(&["cutlery", "silverware"]) {
            fork(mesh, -0.3, &steel);
            knife(mesh, 0.3, &steel, &steel);
        } else if a.says(&["ladle"]) {
            ladle(mesh, &steel);
        } else if a.says(&["spatula", "turner"]) {
            spatula(mesh, &dark, &steel);
        } else if a.says(&["whisk"]) {
            whisk(mesh, &steel);
        } else if a.says(&["tong"]) {
            tongs(mesh, &dark, &steel);
        } else if a.says(&["corkscrew"]) {
            corkscrew(mesh, &steel);
        } else {
            stem(mesh, 0.0, &steel);
            mesh.ball(block(-0.22..0.22, -0.05..0.03, 0.4..1.0), &steel);
            blade(mesh, at(0.0, 0.012, 0.7), [0.34, 0.5], 0.05, &shade(&steel, 0.7));
        }
    })
}

/// Up, where a utensil lies flat.
fn up() -> Vec3 {
    at(0.0, 1.0, 0.0)
}

/// The handle of a fork or a spoon.
fn stem(mesh: &mut Mesh, x: f64, s: &Surface) {
    let path = [(at(x, 0.0, -1.0), 0.09, 0.03), (at(x, 0.0, -0.4), 0.05, 0.03), (at(x, 0.0, 0.5), 0.035, 0.03)];
    mesh.sweep(&path, up(), 8, s);
}

fn fork(mesh: &mut Mesh, x: f64, steel: &Surface) {
    stem(mesh, x, steel);
    let head = [(at(x, 0.0, 0.44), 0.04, 0.03), (at(x, 0.0, 0.58), 0.15, 0.03), (at(x, 0.0, 0.68), 0.15, 0.03)];
    mesh.sweep(&head, up(), 8, steel);
    for k in -1..=2 {
        let tine = x + 0.09 * (f64::from(k) - 0.5);
        mesh.sweep(&[(at(tine, 0.0, 0.64), 0.022, 0.022), (at(tine, 0.02, 1.0), 0.01, 0.01)], up(), 6, steel);
    }
}

fn knife(mesh: &mut Mesh, x: f64, handle: &Surface, steel: &Surface) {
    mesh.sweep(&[(at(x, 0.0, -1.0), 0.1, 0.05), (at(x, 0.0, -0.2), 0.08, 0.05)], up(), 8, handle);
    let outline = [(-0.22, x - 0.07), (0.85, x - 0.07), (1.0, x + 0.01), (0.9, x + 0.09), (-0.22, x + 0.09)];
    mesh.extrude(1, &outline, -0.015..0.015, steel);
}

fn ladle(mesh: &mut Mesh, steel: &Surface) {
    mesh.tube(&[at(0.0, 1.0, -1.0), at(0.0, 1.12, -0.92), at(0.0, 1.0, -0.8), at(0.0, 0.6, 0.5)], 0.05, steel);
    let bowl = [(0.3, 0.0), (0.75, 0.2), (0.95, 0.6), (1.0, 1.0), (0.93, 1.0), (0.86, 0.6), (0.5, 0.2)];
    mesh.lathe(block(-0.42..0.42, 0.0..0.7, 0.3..1.1), &bowl, 24, steel);
}

/// With slots.
fn spatula(mesh: &mut Mesh, handle: &Surface, steel: &Surface) {
    mesh.sweep(&[(at(0.0, 0.02, -1.0), 0.09, 0.05), (at(0.0, 0.02, -0.1), 0.06, 0.04)], up(), 10, handle);
    cone(mesh, at(0.0, 0.02, -0.12), at(0.0, 0.0, 0.34), [0.03, 0.03], steel);
    for x in block(-0.28..0.28, -0.02..0.02, 0.42..0.9).split(0, 4, 0.05) {
        mesh.crisp(x, steel);
    }
    for z in [0.3..0.43, 0.89..1.0] {
        mesh.crisp(block(-0.28..0.28, -0.021..0.021, z), steel);
    }
}

/// Loops of wire.
fn whisk(mesh: &mut Mesh, steel: &Surface) {
    cone(mesh, at(0.0, 0.0, -1.0), at(0.0, 0.0, -0.25), [0.08, 0.07], steel);
    let point = |t: f64| at(0.3 * (std::f64::consts::PI * t).sin(), 0.0, -0.28 + 1.28 * t);
    for k in 0..4 {
        mesh.place(at(0.0, 0.0, 0.0), [0.0, 0.0, 45.0 * f64::from(k)], |mesh| {
            for side in [-1.0, 1.0] {
                let points = (0..=8).map(|i| point(f64::from(i) / 8.0));
                let wire: Vec<_> = points.map(|p| at(side * p.x.powf(0.8), 0.0, p.z)).collect();
                mesh.tube(&wire, 0.012, steel);
            }
        });
    }
}

fn tongs(mesh: &mut Mesh, hinge: &Surface, steel: &Surface) {
    for side in [-1.0, 1.0] {
        let arm = [
            (at(0.0, 0.0, -1.0), 0.03, 0.08),
            (at(side * 0.16, 0.0, -0.2), 0.03, 0.1),
            (at(side * 0.3, 0.0, 0.7), 0.03, 0.08),
            (at(side * 0.26, 0.0, 1.0), 0.04, 0.16),
        ];
        mesh.sweep(&arm, up(), 8, steel);
    }
    mesh.rounded(block(-0.06..0.06, -0.1..0.1, -1.04..-0.9), 0.03, 1, hinge);
}

fn corkscrew(mesh: &mut Mesh, steel: &Surface) {
    mesh.rounded(block(-0.6..0.6, -0.12..0.12, -1.0..-0.74), 0.1, 2, &of(Finish::Wood, 0x8a5a34));
    cone(mesh, at(0.0, 0.0, -0.76), at(0.0, 0.0, -0.2), [0.05, 0.05], steel);
    let turn = |k: u32| {
        let (sin, cos) = (f64::from(k) * 0.8).sin_cos();
        at(0.1 * cos, 0.1 * sin, -0.24 + 1.24 * f64::from(k) / 40.0)
    };
    let helix: Vec<_> = (0..=40).map(turn).collect();
    mesh.tube(&helix, 0.035, steel);
}
