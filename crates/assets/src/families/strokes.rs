//! How small things are drawn: in proportions of their own, one solid around them, stretched to fill their box; and which
//! way they lie in it.

use crate::ask::Ask;
use crate::block::Block;
use crate::looks::{Finish, Stuff, shade};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use scenelang_layout::Vec3;

/// A point.
pub(super) fn at(x: f64, y: f64, z: f64) -> Vec3 {
    Vec3::new(x, y, z)
}

/// A thing in one solid; its mesh is drawn in any unit and stretched to fill the box.
pub(super) fn small(a: &Ask, draw: impl FnOnce(&mut Mesh)) -> BuiltModel {
    let mut m = BuiltModel::default();
    m.solid(a.whole());
    m.mesh.stretch(a.whole(), draw);
    m
}

/// Something long, drawn with its length along z, less wide along x and thin along y. It lies as its box does; in a box that
/// is high it stands on its −z end, and in one that is higher than deep its +x side is up.
pub(super) fn long(a: &Ask, draw: impl FnOnce(&mut Mesh)) -> BuiltModel {
    let rot = if a.h >= a.w && a.h >= a.d {
        [-90.0, if a.w >= a.d { 0.0 } else { 90.0 }, 0.0]
    } else if a.d >= a.w {
        [0.0, 0.0, if a.h >= a.w { 90.0 } else { 0.0 }]
    } else {
        [0.0, 90.0, if a.h >= a.d { 90.0 } else { 0.0 }]
    };
    small(a, |mesh| mesh.place(Vec3::zeros(), rot, draw))
}

/// Something upright that looks to +z, and to +x if its box is wider than deep.
pub(super) fn headed(a: &Ask, draw: impl FnOnce(&mut Mesh)) -> BuiltModel {
    let rot = [0.0, if a.w > a.d { 90.0 } else { 0.0 }, 0.0];
    small(a, |mesh| mesh.place(Vec3::zeros(), rot, draw))
}

/// Something round, drawn about the upright axis; it is turned to the axis about which its box is most nearly square.
pub(super) fn round(a: &Ask, draw: impl FnOnce(&mut Mesh)) -> BuiltModel {
    let off = |one: f64, other: f64| (one / other).ln().abs();
    let (upright, ahead, aside) = (off(a.w, a.d), off(a.w, a.h), off(a.h, a.d));
    let rot = if upright <= ahead && upright <= aside {
        [0.0; 3]
    } else if ahead <= aside {
        [90.0, 0.0, 0.0]
    } else {
        [0.0, 0.0, -90.0]
    };
    small(a, |mesh| mesh.place(Vec3::zeros(), rot, draw))
}

/// A round bar from one point to another whose radius changes from the first number to the second.
pub(super) fn cone(mesh: &mut Mesh, from: Vec3, to: Vec3, [first, last]: [f64; 2], s: &Surface) {
    mesh.sweep(&[(from, first, first), (to, last, last)], at(0.3, 0.9, 0.2), 12, s);
}

/// A tube that widens along points, as the bell of a horn does; its end is dark within.
pub(super) fn flare(mesh: &mut Mesh, path: &[(Vec3, f64)], s: &Surface) {
    let stations: Vec<_> = path.iter().map(|(p, r)| (*p, *r, *r)).collect();
    mesh.sweep(&stations, at(0.3, 0.9, 0.2), 16, s);
    if let [.., (before, _), (end, r)] = path {
        let out = (end - before).normalize() * (0.04 * r);
        cone(mesh, *end, end + out, [0.88 * r, 0.86 * r], &shade(s, 0.35));
    }
}

/// A ball of few faces, for many of them.
pub(super) fn pearl(mesh: &mut Mesh, b: Block, s: &Surface) {
    mesh.lathe(b, &crate::shapes::sphere(4), 8, s);
}

/// A flat oval with its length along z: where, how wide and how long it is, and its thickness.
pub(super) fn blade(mesh: &mut Mesh, middle: Vec3, [wide, long]: [f64; 2], thick: f64, s: &Surface) {
    let n = 20;
    let point = |k: usize| {
        let (sin, cos) = (std::f64::consts::TAU * k as f64 / f64::from(n)).sin_cos();
        (middle.z + long / 2.0 * sin, middle.x + wide / 2.0 * cos)
    };
    let outline: Vec<(f64, f64)> = (0..n as usize).map(point).collect();
    mesh.extrude(1, &outline, middle.y - thick / 2.0..middle.y + thick / 2.0, s);
}

pub(super) fn of(finish: Finish, color: u32) -> Surface {
    Stuff(finish, color).surface()
}
