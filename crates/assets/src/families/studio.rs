//! What stands in studios: a camera on its tripod, a telescope, a soft light, a backdrop, a mixing desk.

use crate::ask::Ask;
use crate::block::block;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::BuiltModel;

/// Three legs that meet at a share of the height, their feet at the sides of the box.
fn tripod(m: &mut BuiltModel, a: &Ask, up: f64, metal: &crate::mesh::Surface) {
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let t = 0.03_f64.min(0.08 * a.w).min(0.1 * a.d);
    let head = block(-t / 2.0..t / 2.0, up - t.min(0.1 * up)..up, -t / 2.0..t / 2.0);
    for (px, pz) in [(-x, -z), (x - t, -z), (-t / 2.0, z - t)] {
        m.taper(block(px..px + t, 0.0..0.01 * a.h, pz..pz + t), head, metal);
    }
}

/// A camera on three legs; it looks to the front.
pub(super) fn camera_tripod(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let body = a.main(stuff::DARK_PLASTIC);
    let metal = stuff::BLACK_STEEL.surface();
    let neck = 0.86 * a.h;
    tripod(&mut m, a, neck, &metal);
    let camera = block(-0.16 * a.w..0.16 * a.w, 0.9 * a.h..a.h, -0.14 * a.d..0.06 * a.d);
    m.board(camera.inset(0.1 * a.w, 0.0, 0.04 * a.d).y(neck..0.9 * a.h), &metal);
    m.board(camera, &body);
    let r = (0.4 * camera.size().y).min(0.4 * camera.size().x);
    let c = camera.center();
    let lens = block(c.x - r..c.x + r, c.y - r..c.y + r, camera.max.z..camera.max.z + 0.16 * a.d);
    m.disc(2, lens, &metal);
    m.mesh.disc(2, lens.inset(0.25 * r, 0.25 * r, 0.0).z(lens.max.z..lens.max.z + 0.01 * a.d), &stuff::GLASS.surface());
    m
}

/// A telescope on three legs: a long tube that rises to the front, with its eyepiece low at the back.
pub(super) fn telescope(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let tube = a.main(stuff::WHITE);
    let metal = stuff::BLACK_STEEL.surface();
    let neck = 0.66 * a.h;
    tripod(&mut m, a, neck, &metal);
    let r = (0.09 * a.h).min(0.2 * a.w).min(0.2 * a.d);
    let fork = block(-0.5 * r..0.5 * r, neck..0.76 * a.h, -0.5 * r..0.5 * r);
    m.board(fork, &metal);
    // Seen from the side: the upper end is at the top and the front of the box, the eyepiece at its back.
    let (back, front) = (-a.d / 2.0, a.d / 2.0);
    let low = 0.72 * a.h;
    let tail = back + 0.12 * a.d;
    let rise = (a.h - 2.0 * r - low) / (front - tail);
    let at = |z: f64| low + rise * (z - tail);
    let hood = front - 0.16 * a.d;
    let body = [
        (at(tail) + 0.2 * r, tail),
        (at(hood) + 0.2 * r, hood),
        (at(hood) + 1.8 * r, hood),
        (at(tail) + 1.8 * r, tail),
    ];
    m.extrude(0, &body, -0.8 * r..0.8 * r, &tube);
    let end = [(at(hood), hood), (at(front), front), (a.h, front), (at(hood) + 2.0 * r, hood)];
    m.extrude(0, &end, -r..r, &metal);
    let lens = block(-0.7 * r..0.7 * r, at(front) + 0.3 * r..a.h - 0.3 * r, front - 0.002 * a.d..front);
    m.mesh.disc(2, lens, &stuff::GLASS.surface());
    let eye = block(-0.35 * r..0.35 * r, at(tail) + 0.5 * r..at(tail) + 1.2 * r, back..tail);
    m.board(eye, &metal);
    m
}

/// A light in a box of cloth, which shines to the front.
pub(super) fn softbox(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let metal = stuff::BLACK_STEEL.surface();
    let cloth = a.main(Stuff(Finish::Fabric, 0x22252a));
    let low = 0.62 * a.h;
    tripod(&mut m, a, 0.3 * a.h, &metal);
    let r = 0.015_f64.min(0.05 * a.w).min(0.05 * a.d);
    m.board(block(-r..r, 0.3 * a.h..low, -r..r), &metal);
    // Seen from the side: narrow at the back, as tall as it is in front.
    let (back, front) = (-0.3 * a.d, 0.3 * a.d);
    let c = (low + a.h) / 2.0;
    let small = 0.25 * (a.h - low);
    let outline = [(c - small, back), (low, front), (a.h, front), (c + small, back)];
    m.extrude(0, &outline, -a.w / 2.0..a.w / 2.0, &cloth);
    let screen = block(-0.46 * a.w..0.46 * a.w, low + 0.03 * a.h..a.h - 0.03 * a.h, front..front + 0.02 * a.d);
    m.mesh.crisp(screen, &stuff::WHITE.surface());
    m
}

/// A sheet that hangs from a bar between two stands and runs out over the floor.
pub(super) fn backdrop(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let sheet = a.main(Stuff(Finish::Paper, 0xd9dbd6));
    let metal = stuff::BLACK_STEEL.surface();
    let thick = (0.1 * a.d).min(0.02);
    let post = 0.03_f64.min(0.05 * a.w);
    let bar = 0.03_f64.min(0.05 * a.h);
    for side in [b.x(b.min.x..b.min.x + post), b.x(b.max.x - post..b.max.x)] {
        m.board(side.y(0.0..a.h).z(b.min.z..b.min.z + 2.0 * thick), &metal);
        m.board(side.y(0.0..bar).z(b.min.z + 2.0 * thick..b.max.z), &metal);
    }
    let inner = b.x(b.min.x + post..b.max.x - post);
    m.board(inner.y(a.h - bar..a.h).z(b.min.z..b.min.z + 2.0 * thick), &metal);
    let hangs = inner.inset(0.01 * a.w, 0.0, 0.0);
    m.board(hangs.y(0.0..a.h - bar).z(b.min.z + thick..b.min.z + 2.0 * thick), &sheet);
    m.board(hangs.y(0.0..0.2 * bar).z(b.min.z + 2.0 * thick..b.max.z), &sheet);
    m
}

/// A desk of faders and knobs that rises to the back; a tall one on legs.
pub(super) fn mixing_desk(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(Stuff(Finish::Plastic, 0x3a3f47));
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    // What is as tall as a table stands on legs of its own.
    let under = if a.h > 0.4 { 0.72 * a.h } else { 0.0 };
    if under > 0.0 {
        m.legs(a.whole().y(0.0..under), 0.06, &stuff::BLACK_STEEL.surface());
    }
    let (low, rise) = (under + 0.35 * (a.h - under), 0.65 * (a.h - under));
    // Seen from the side, in (y, z): low in front, as high as the box at the back.
    let outline = [(under, -z), (under, z), (low, z), (a.h, -z)];
    m.extrude(0, &outline, -x..x, &main);
    let lanes = ((a.w / 0.07) as usize).clamp(4, 16);
    let wide = 0.92 * a.w / lanes as f64;
    // A row of points up the slope, each a little above it.
    let up = |share: f64| (low + share * rise, z - share * a.d);
    for lane in 0..lanes {
        let at = -0.46 * a.w + (lane as f64 + 0.5) * wide;
        for (row, share) in [0.16, 0.5, 0.64, 0.78, 0.9].into_iter().enumerate() {
            let (y, back) = up(share);
            let (half, long) = if row == 0 { (0.3 * wide, 0.05 * a.d) } else { (0.18 * wide, 0.02 * a.d) };
            let color = match (row, (lane + row) % 3) {
                (0, _) => stuff::WHITE.surface(),
                (_, 0) => stuff::RED.surface(),
                _ => shade(&main, 1.8),
            };
            m.mesh
                .crisp(block(at - half..at + half, y - 0.08 * rise..y + 0.03 * rise, back - long..back + long), &color);
        }
    }
    m
}
