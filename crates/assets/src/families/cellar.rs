//! What stands in cellars and over hearths: racks of bottles, cauldrons.

use crate::ask::Ask;
use crate::block::{Block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::BuiltModel;
use std::f64::consts::TAU;

/// The bottom of a bottle that lies in a rack, seen from +z, as an octagon in (x, y).
fn octagon(b: Block) -> Vec<(f64, f64)> {
    let (c, r) = (b.center(), 0.42 * b.size().x.min(b.size().y));
    (0..8)
        .map(|k| (TAU * (f64::from(k) + 0.5) / 8.0).sin_cos())
        .map(|(sin, cos)| (c.x + r * cos, c.y + r * sin))
        .collect()
}

/// A frame of pigeonholes with a bottle lying in most of them.
pub(super) fn wine_rack(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let mut dice = a.dice();
    let b = a.whole();
    let main = a.main(stuff::OAK);
    let t = 0.025_f64.min(0.06 * a.w).min(0.06 * a.h);
    let inner = b.inset(t, t, 0.0);
    m.solid(b);
    for side in b.x(b.min.x..inner.min.x).both_sides() {
        m.mesh.board(side, &main);
    }
    for board in [b.y(0.0..t), b.y(a.h - t..a.h)] {
        m.mesh.board(board.x(inner.min.x..inner.max.x), &main);
    }
    m.mesh.crisp(inner.share(0.0..1.0, 0.0..1.0, 0.0..0.06), &shade(&main, 0.55));
    let (columns, rows) = (pieces(a.w, 0.14, 2, 7), pieces(a.h, 0.15, 2, 11));
    let glass = [0x22352a, 0x2f3b22, 0x3a1d22].map(|color| Stuff(Finish::Ceramic, color).surface());
    for (i, row) in inner.split(1, rows, 0.0).enumerate() {
        if i > 0 {
            m.mesh.crisp(row.share(0.0..1.0, 0.0..0.08, 0.06..0.92), &main);
        }
        for cell in row.split(0, columns, 0.0) {
            let bottle = cell.share(0.0..1.0, 0.08..1.0, 0.12..0.86);
            if dice.unit() < 0.85 {
                m.mesh.extrude(2, &octagon(bottle), bottle.min.z..bottle.max.z, dice.pick(&glass));
            }
        }
    }
    for upright in inner.split(0, columns, 0.0).skip(1) {
        m.mesh.crisp(upright.share(0.0..0.06, 0.0..1.0, 0.06..0.92), &main);
    }
    m
}

/// A round iron pot with a rim on three feet, and what boils in it.
pub(super) fn cauldron(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let iron = a.main(stuff::BLACK_STEEL);
    let belly = b.share(0.0..1.0, 0.12..1.0, 0.0..1.0);
    m.solid_drum(belly);
    let wall = [(0.3, 0.0), (0.72, 0.08), (0.95, 0.28), (1.0, 0.45), (0.95, 0.66), (0.8, 0.84), (0.78, 0.9)];
    let rim = [(0.88, 0.95), (0.88, 1.0), (0.72, 1.0), (0.7, 0.86)];
    m.mesh.lathe(belly, &[&wall[..], &rim[..]].concat(), 24, &iron);
    m.mesh.drum(belly.share(0.16..0.84, 0.84..0.9, 0.16..0.84), &Stuff(Finish::Water, 0x5c8f3a).surface());
    for (x, z) in [(0.5, 0.82), (0.2, 0.32), (0.8, 0.32)] {
        let foot = b.share(x - 0.04..x + 0.04, 0.0..0.2, z - 0.04..z + 0.04);
        m.taper(foot, b.share(x - 0.07..x + 0.07, 0.0..0.2, z - 0.07..z + 0.07), &iron);
    }
    for ear in b.share(0.0..0.09, 0.74..0.84, 0.42..0.58).both_sides() {
        m.mesh.crisp(ear, &shade(&iron, 1.3));
    }
    m
}
