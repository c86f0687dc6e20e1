//! Where things are drawn, cut and made: racks of timber, tables for draughtsmen and dressmakers.

use crate::ask::Ask;
use crate::block::{Block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;

/// Kinds of wood, by their colours.
const TIMBER: &[u32] = &[0xd9b27c, 0xc99a5e, 0xe6c998, 0xb5824a, 0xa06a3c, 0xdcbd8c];

/// Uprights with arms to the front, and boards and beams that lie on them.
pub(super) fn timber_rack(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let steel = a.main(Stuff(Finish::Paint, 0x3a5f7d));
    let mut dice = a.dice();
    let posts = pieces(a.w, 1.2, 2, 3);
    let levels = pieces(a.h, 0.5, 2, 4);
    let t = 0.08_f64.min(0.1 * a.w).min(0.16 * a.d);
    let arm = 0.07_f64.min(0.05 * a.h);
    let foot = 0.1_f64.min(0.07 * a.h);
    let step = (a.h - foot) / levels as f64;
    for k in 0..posts {
        let x = (-0.36 + 0.72 * k as f64 / (posts - 1) as f64) * a.w;
        let post = b.x(x - t / 2.0..x + t / 2.0);
        m.board(post.y(0.0..foot), &steel);
        m.board(post.y(foot..a.h).z(b.min.z..b.min.z + t), &steel);
        for level in 1..levels {
            let y = foot + step * level as f64 - 0.35 * step;
            let z = b.min.z + t..b.max.z - 0.03 * a.d;
            m.extrude(
                0,
                &[(y, z.start), (y, z.end), (y - 0.4 * arm, z.end), (y - arm, z.start)],
                x - t / 2.0..x + t / 2.0,
                &steel,
            );
            // A peg keeps the timber from rolling off.
            m.mesh.crisp(post.y(y..y + 0.3 * arm).z(z.end - 0.3 * t..z.end), &steel);
        }
    }
    for level in 0..levels {
        let y = if level == 0 { foot } else { foot + step * level as f64 - 0.35 * step };
        let room = if level + 1 == levels { a.h - y } else { (0.62 * step).min(a.h - y) };
        let full = if level == 0 { (0.0, 1.0) } else { *dice.pick(&[(0.03, 0.97), (0.0, 0.94), (0.06, 1.0)]) };
        let bed = b.share(full.0..full.1, 0.0..1.0, 0.0..0.95).z(b.min.z + 1.15 * t..b.max.z - 0.08 * a.d);
        stack(&mut m, bed.y(y..y + 0.56 * room), level, &mut dice);
    }
    m
}

/// Boards and beams in layers; the ends of some stick out.
fn stack(m: &mut BuiltModel, bed: Block, level: usize, dice: &mut crate::words::Dice) {
    m.solid(bed);
    let beams = level.is_multiple_of(2);
    let each = if beams { 0.1 } else { 0.045 };
    let rows = pieces(bed.size().y, each, 1, if beams { 3 } else { 5 });
    let across = pieces(bed.size().z, if beams { 0.11 } else { 0.2 }, 2, if beams { 6 } else { 3 });
    for (row, layer) in bed.split(1, rows, 0.008).enumerate() {
        let wood = *dice.pick(TIMBER);
        for (k, place) in layer.split(2, across, 0.012).enumerate() {
            let short = |dice: &mut crate::words::Dice| 0.07 * dice.unit() * bed.size().x;
            // The first of each stack is as long as its bed.
            let (left, right) = if row + k == 0 { (0.0, 0.0) } else { (short(dice), short(dice)) };
            let tint = if (row + k) % 3 == 1 { *dice.pick(TIMBER) } else { wood };
            let one = place.x(place.min.x + left..place.max.x - right);
            m.mesh.crisp(one, &Stuff(Finish::Wood, tint).surface());
        }
    }
}

/// A board with a sheet and a ruler across it, on a frame; who draws sits at +z. The board is level: things lie on it.
pub(super) fn drafting_table(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let top = a.main(Stuff(Finish::Wood, 0xd9bd92));
    let steel = a.second(stuff::BLACK_STEEL);
    // The upper face of the board, from the edge at +z to the one at -z, as (height, depth) shares.
    let (low, high) = ((0.978, 1.0), (0.978, 0.0));
    m.surface = Some(0.978 * a.h);
    let at = |along: f64, up: f64| {
        let y = (low.0 + (high.0 - low.0) * along + up) * a.h;
        (y, b.min.z + (low.1 + (high.1 - low.1) * along) * a.d)
    };
    let slab = |m: &mut BuiltModel, along: [f64; 2], up: [f64; 2], x: [f64; 2], s: &Surface| {
        let outline = [at(along[0], up[0]), at(along[1], up[0]), at(along[1], up[1]), at(along[0], up[1])];
        m.mesh.extrude(0, &outline, x[0] * a.w..x[1] * a.w, s);
    };
    let outline = [at(0.0, -0.04), at(1.0, -0.04), at(1.0, 0.0), at(0.0, 0.0)];
    m.extrude(0, &outline, -0.5 * a.w..0.5 * a.w, &top);
    // A sheet with a plan on it.
    let (paper, ink) = (stuff::PAPER.surface(), Stuff(Finish::Paper, 0x3d5f8f).surface());
    // Lines that cross lie one above the other.
    let (lift, across) = (0.007, 0.005);
    slab(&mut m, [0.12, 0.86], [-0.01, 0.5 * lift], [-0.34, 0.34], &paper);
    for (along, x) in [([0.24, 0.255], [-0.26, 0.22]), ([0.74, 0.755], [-0.26, 0.22])] {
        slab(&mut m, along, [0.0, lift], x, &ink);
    }
    for (along, x) in [
        ([0.24, 0.755], [-0.265, -0.255]),
        ([0.24, 0.755], [0.215, 0.225]),
        ([0.46, 0.755], [-0.05, -0.04]),
        ([0.24, 0.36], [0.06, 0.07]),
    ] {
        slab(&mut m, along, [0.0, across], x, &ink);
    }
    slab(&mut m, [0.46, 0.47], [0.0, lift], [-0.26, -0.04], &ink);
    // The ruler and its runners.
    let (rule, dark) = (Stuff(Finish::Plastic, 0xf2f2ee).surface(), stuff::DARK_PLASTIC.surface());
    slab(&mut m, [0.36, 0.43], [0.0, 0.016], [-0.47, 0.47], &rule);
    for side in [[-0.49, -0.45], [0.45, 0.49]] {
        let carriage = [at(0.34, 0.0), at(0.45, 0.0), at(0.45, 0.022), at(0.34, 0.022)];
        m.extrude(0, &carriage, side[0] * a.w..side[1] * a.w, &dark);
        slab(&mut m, [0.02, 0.98], [0.0, 0.006], [side[0] + 0.015, side[1] - 0.015], &stuff::STEEL.surface());
    }
    frame(&mut m, b, &steel);
    m
}

/// Two feet, posts that carry the board, and a bar between them.
fn frame(m: &mut BuiltModel, b: Block, steel: &Surface) {
    for foot in b.share(0.1..0.15, 0.0..0.05, 0.0..0.96).both_sides() {
        m.board(foot, steel);
        let post = foot.share(0.1..0.9, 0.0..1.0, 0.42..0.54);
        m.board(post.y(foot.max.y..0.938 * b.max.y), steel);
    }
    m.board(b.share(0.15..0.85, 0.18..0.22, 0.46..0.5), steel);
    m.board(b.share(0.2..0.8, 0.0..1.0, 0.44..0.5).y(0.86 * b.max.y..0.93 * b.max.y), steel);
}

/// A table to cut cloth on: a green mat with a grid, bolts of cloth on a shelf below.
pub(super) fn cutting_table(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wood = a.main(stuff::BIRCH);
    let thick = 0.05_f64.min(0.1 * a.h);
    let under = a.h - thick;
    m.solid(b.y(under..a.h));
    m.mesh.board(b.y(under..a.h - 0.1 * thick), &wood);
    let mat = b.inset(0.06 * a.w, 0.0, 0.06 * a.d).y(a.h - 0.2 * thick..a.h - 0.05 * thick);
    m.mesh.crisp(mat, &Stuff(Finish::Rubber, 0x2f7d5b).surface());
    let line = Stuff(Finish::Paint, 0xe9f2d8).surface();
    let (cols, rows) = (pieces(mat.size().x, 0.1, 2, 24), pieces(mat.size().z, 0.1, 2, 16));
    let t = 0.003_f64.min(0.02 * mat.size().x).min(0.02 * mat.size().z);
    let ink = mat.y(mat.max.y - 0.05 * thick..a.h);
    for k in 1..cols {
        let x = mat.min.x + mat.size().x * k as f64 / cols as f64;
        m.mesh.crisp(ink.x(x - t..x + t), &line);
    }
    for k in 1..rows {
        let z = mat.min.z + mat.size().z * k as f64 / rows as f64;
        m.mesh.crisp(ink.y(ink.min.y..a.h - 0.02 * thick).z(z - t..z + t), &line);
    }
    let leg = 0.06_f64;
    m.legs(b.inset(0.02 * a.w, 0.0, 0.02 * a.d).y(0.0..under), leg, &wood);
    let shelf = b.share(0.04..0.96, 0.2..0.24, 0.06..0.94);
    m.board(shelf, &shade(&wood, 0.9));
    let mut dice = a.dice();
    let bolts = b.share(0.08..0.92, 0.24..0.42, 0.16..0.84);
    m.solid(bolts);
    for bolt in bolts.split(2, pieces(bolts.size().z, 0.14, 2, 6), 0.01) {
        let cloth = Stuff(Finish::Fabric, *dice.pick(&[0xb5493f, 0x3f6f8f, 0xd9b24a, 0x6f8f5a, 0x8a5f86, 0xe4ded2]));
        m.mesh.disc(0, bolt, &cloth.surface());
    }
    m
}
