//! Equipment for emergencies, in the colours that the signs of most countries use.

use super::kitchen::dial;
use crate::ask::Ask;
use crate::block::{Block, block};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;
use scenelang_layout::Vec3;

/// A cross on the front of `b`, using its depth.
fn cross(m: &mut BuiltModel, b: Block, s: &Surface) {
    let (size, c) = (b.size(), b.center());
    let arm = 0.5 * size.x.min(size.y);
    let half = 0.32 * arm;
    m.mesh.crisp(block(c.x - arm..c.x + arm, c.y - half..c.y + half, b.min.z..b.max.z), s);
    m.mesh.crisp(block(c.x - half..c.x + half, c.y + half..c.y + arm, b.min.z..b.max.z), s);
    m.mesh.crisp(block(c.x - half..c.x + half, c.y - arm..c.y - half, b.min.z..b.max.z), s);
}

/// A red bottle with a valve, a hose and a label.
pub(super) fn extinguisher(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.tinted(Stuff(Finish::Paint, 0xc4201d));
    let dark = stuff::RUBBER.surface();
    let neck = 0.78 * a.h;
    let body = b.y(0.0..neck);
    m.solid_drum(body);
    // Set in where the label goes round it.
    let (low, high) = (0.4, 0.66);
    let foot = [(0.94, 0.0), (1.0, 0.02), (1.0, low), (0.97, low)];
    let top = [(0.97, high), (1.0, high), (1.0, 0.84), (0.93, 0.9), (0.7, 0.965), (0.36, 1.0)];
    m.mesh.lathe(body, &[&foot[..], &top[..]].concat(), 24, &main);
    let label = body.inset(0.005 * a.w, 0.0, 0.005 * a.d).y(low * neck..high * neck);
    m.mesh.lathe(label, &[(1.0, 0.0), (1.0, 1.0)], 24, &stuff::PAPER.surface());
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let head = block(-0.62 * x..0.78 * x, neck..a.h, -0.4 * z..0.4 * z);
    m.solid(head);
    m.mesh.drum(
        block(-0.22 * x..0.22 * x, neck..neck + 0.5 * (a.h - neck), -0.22 * z..0.22 * z),
        &stuff::BRASS.surface(),
    );
    m.mesh.board(
        block(-0.3 * x..0.78 * x, neck + 0.45 * (a.h - neck)..neck + 0.62 * (a.h - neck), -0.14 * z..0.14 * z),
        &stuff::STEEL.surface(),
    );
    m.mesh.board(block(-0.2 * x..0.7 * x, neck + 0.84 * (a.h - neck)..a.h, -0.12 * z..0.12 * z), &main);
    m.mesh.board(
        block(-0.62 * x..-0.1 * x, neck + 0.35 * (a.h - neck)..neck + 0.55 * (a.h - neck), -0.1 * z..0.1 * z),
        &dark,
    );
    // The hose hugs the bottle, inside its cylinder.
    let slim = (0.07 * x.min(z)).min(0.05 * a.h);
    let at = |x_: f64, y: f64| Vec3::new(x_ * x, y * a.h, 0.0);
    m.mesh.tube(&[at(-0.5, 0.84), at(-0.86, 0.74), at(-0.92, 0.5), at(-0.9, 0.3)], slim, &dark);
    m
}

/// A flat case with a cross: green for first aid, red for fire, with a heart for a defibrillator.
pub(super) fn first_aid(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.tinted(Stuff(Finish::Paint, 0x1f8f54));
    case(&mut m, a, &main, cross);
    m
}

/// A defibrillator in its box.
pub(super) fn aed(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.tinted(Stuff(Finish::Paint, 0xf1f2ef));
    let green = Stuff(Finish::Paint, 0x1f8f54).surface();
    case(&mut m, a, &main, |m, face, _| {
        let (size, c) = (face.size(), face.center());
        let r = 0.4 * size.x.min(size.y);
        let heart = |x: f64, y: f64| (c.x + x * r, c.y + y * r);
        let half = |side: f64| {
            [
                heart(0.0, -0.9),
                heart(side * 0.95, 0.2),
                heart(side * 0.8, 0.7),
                heart(side * 0.45, 0.85),
                heart(0.0, 0.5),
            ]
        };
        for side in [-1.0, 1.0] {
            m.mesh.extrude(2, &half(side), face.min.z..face.max.z - 0.3 * size.z, &green);
        }
        let bolt = [heart(0.12, 0.55), heart(-0.3, -0.1), heart(0.02, -0.05)];
        let back = [heart(-0.08, -0.6), heart(0.3, 0.1), heart(-0.02, 0.05)];
        for side in [bolt, back] {
            m.mesh.extrude(2, &side, face.max.z - 0.3 * size.z..face.max.z, &stuff::WHITE.surface());
        }
    });
    m
}

/// A red case: fire blankets, hydrants, hoses.
pub(super) fn fire_box(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.tinted(Stuff(Finish::Paint, 0xc4201d));
    case(&mut m, a, &main, |m, face, s| {
        let (size, c) = (face.size(), face.center());
        let r = 0.3 * size.x.min(size.y);
        let flame = [(-0.6, -0.8), (0.6, -0.8), (0.85, -0.1), (0.35, 0.5), (0.1, 1.0), (-0.5, 0.4), (-0.85, -0.1)];
        let outline: Vec<_> = flame.iter().map(|(x, y)| (c.x + x * r, c.y + y * r)).collect();
        m.mesh.extrude(2, &outline, face.min.z..face.max.z, s);
    });
    m
}

/// A case with a door; `mark` draws on it in white.
fn case(m: &mut BuiltModel, a: &Ask, main: &Surface, mark: impl FnOnce(&mut BuiltModel, Block, &Surface)) {
    let b = a.whole();
    m.solid(b);
    let deep = 0.1 * a.d;
    m.mesh.rounded(b.z(b.min.z..b.max.z - 2.0 * deep), 0.012, 2, main);
    let face = b.inset(0.05 * a.w, 0.05 * a.h, 0.0).z(b.max.z - 2.0 * deep..b.max.z);
    m.mesh.board(face.z(face.min.z..face.min.z + deep), &shade(main, 1.06));
    mark(m, face.inset(0.16 * a.w, 0.16 * a.h, 0.0).z(face.min.z + deep..face.max.z), &stuff::WHITE.surface());
}

/// A lit green sign: someone running through a door, and an arrow.
pub(super) fn exit_sign(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    m.solid(b);
    let main = a.tinted(stuff::GREEN_LIGHT);
    let white = Stuff(Finish::Glow, 0xf6fff8).surface();
    let deep = 0.2 * a.d;
    m.mesh.board(b.z(b.min.z..b.max.z - deep), &main);
    let (w, h) = (a.w, a.h);
    let face = b.z(b.max.z - deep..b.max.z);
    let at = |x0: f64, x1: f64, y0: f64, y1: f64| face.x(x0 * w..x1 * w).y(y0 * h..y1 * h);
    m.mesh.crisp(at(0.12, 0.16, 0.12, 0.88), &white);
    m.mesh.crisp(at(0.36, 0.4, 0.12, 0.88), &white);
    m.mesh.crisp(at(0.16, 0.36, 0.82, 0.88), &white);
    let limb = |points: [(f64, f64); 4]| points.map(|(x, y)| (x * w, y * h));
    let z = face.min.z..face.max.z;
    for part in [
        [(0.2, 0.4), (0.27, 0.42), (0.24, 0.66), (0.18, 0.62)],
        [(0.2, 0.44), (0.25, 0.4), (0.31, 0.28), (0.29, 0.25)],
        [(0.2, 0.42), (0.24, 0.38), (0.17, 0.15), (0.14, 0.17)],
        [(0.24, 0.62), (0.25, 0.57), (0.33, 0.5), (0.33, 0.54)],
    ] {
        m.mesh.extrude(2, &limb(part), z.clone(), &white);
    }
    m.mesh.crisp(at(0.2, 0.25, 0.68, 0.78), &white);
    m.mesh.crisp(at(-0.3, 0.04, 0.42, 0.58), &white);
    m.mesh.extrude(2, &[(-0.28 * w, 0.2 * h), (-0.28 * w, 0.8 * h), (-0.42 * w, 0.5 * h)], z, &white);
    m
}

/// Call points and alarm buttons on walls.
pub(super) fn alarm(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    m.solid(b);
    let main = a.tinted(Stuff(Finish::Paint, 0xc4201d));
    m.mesh.rounded(b.z(b.min.z..b.max.z - 0.3 * a.d), 0.01, 2, &main);
    let face = b.inset(0.2 * a.w, 0.2 * a.h, 0.0).z(b.max.z - 0.3 * a.d..b.max.z - 0.15 * a.d);
    m.mesh.board(face, &stuff::WHITE.surface());
    let (c, r) = (face.center(), 0.2 * a.w.min(a.h));
    dial(
        &mut m.mesh,
        block(c.x - r..c.x + r, c.y - r..c.y + r, face.max.z..b.max.z),
        &[(1.0, 0.0), (0.9, 1.0)],
        &stuff::DARK_PLASTIC.surface(),
    );
    m
}

/// Smoke detectors, sprinklers, cameras on the ceiling: a small turned body, wide side up.
pub(super) fn detector(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(stuff::WHITE);
    m.lathe(a.whole(), &[(0.45, 0.0), (0.6, 0.1), (0.62, 0.4), (0.95, 0.6), (1.0, 0.7), (1.0, 1.0)], &main);
    let r = 0.06 * a.w.min(a.d);
    m.mesh.crisp(block(-r..r, 0.0..0.05 * a.h, -r..r), &Stuff(Finish::Glow, 0xe0362f).surface());
    m
}

/// Cones for traffic and wet floors.
pub(super) fn cone(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Plastic, 0xe8682a));
    let foot = 0.05 * a.h;
    m.board(b.y(0.0..foot), &main);
    let body = b.inset(0.12 * a.w, 0.0, 0.12 * a.d).y(foot..a.h);
    m.solid_drum(body);
    let ring = |lo: f64, hi: f64| [lo, hi].map(|y| (1.0 - 0.86 * y, y));
    m.mesh.lathe(body, &ring(0.0, 0.36), 24, &main);
    let band = |b: Block, lo: f64, hi: f64| {
        let s = b.size();
        let r = 0.86 * lo;
        b.inset(0.5 * r * s.x, 0.0, 0.5 * r * s.z).y(b.min.y + lo * s.y..b.min.y + hi * s.y)
    };
    for (lo, hi, s) in [(0.36, 0.62, &stuff::WHITE.surface()), (0.62, 1.0, &main)] {
        m.mesh.lathe(band(body, lo, hi), &[(1.0, 0.0), ((1.0 - 0.86 * hi) / (1.0 - 0.86 * lo), 1.0)], 24, s);
    }
    m
}
