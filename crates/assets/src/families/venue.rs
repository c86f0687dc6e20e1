//! What gives a place its name: altars and crosses, chairs of barbers, jukeboxes, dartboards, racks of cues and of
//! magazines, shelves of medicine, ovens of bakers, booths and panels of sound studios.

use crate::ask::Ask;
use crate::block::{Block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;
use std::f64::consts::{PI, TAU};

/// A block of stone with a slab on it and a cloth over both, which hangs down in front and behind.
pub(super) fn altar(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::STONE);
    let linen = stuff::SHEET.surface();
    m.board(b.share(0.04..0.96, 0.0..0.08, 0.06..0.94), &shade(&main, 0.9));
    m.board(b.share(0.1..0.9, 0.08..0.88, 0.12..0.88), &main);
    m.board(b.share(0.0..1.0, 0.88..0.985, 0.025..0.975), &main);
    m.board(b.share(0.0..1.0, 0.985..1.0, 0.0..0.99), &linen);
    for fall in [b.share(0.28..0.72, 0.5..0.985, 0.0..0.025), b.share(0.28..0.72, 0.5..0.985, 0.975..0.99)] {
        m.board(fall, &linen);
    }
    let gold = stuff::BRASS.surface();
    let front = b.share(0.28..0.72, 0.5..0.985, 0.99..1.0);
    m.solid(front);
    m.mesh.crisp(front.share(0.0..1.0, 0.0..0.06, 0.0..1.0), &gold);
    m.mesh.crisp(front.share(0.46..0.54, 0.2..0.85, 0.0..1.0), &gold);
    for arm in front.share(0.34..0.46, 0.56..0.66, 0.0..1.0).both_sides() {
        m.mesh.crisp(arm, &gold);
    }
    m
}

/// A cross of wood, on a wall; one that is deep stands on a foot.
pub(super) fn cross(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wood = a.main(stuff::WALNUT);
    let stands = a.d > 0.15 * a.h;
    let (low, z) = if stands { (0.06, 0.3..0.7) } else { (0.0, 0.0..1.0) };
    if stands {
        m.board(b.share(0.1..0.9, 0.0..low, 0.0..1.0), &wood);
    }
    m.board(b.share(0.41..0.59, low..1.0, z.clone()), &wood);
    for arm in b.share(0.0..0.41, 0.64..0.76, z).both_sides() {
        m.board(arm, &wood);
    }
    m
}

/// A padded seat on a column and a round foot, arms, a back that leans to a head rest, and a rest for the feet at +z.
pub(super) fn barber_chair(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let pad = a.main(Stuff(Finish::Leather, 0x7a2f2b));
    let chrome = stuff::CHROME.surface();
    m.drum(b.share(0.12..0.88, 0.0..0.05, 0.1..0.78), &chrome);
    m.drum(b.share(0.36..0.64, 0.05..0.36, 0.34..0.56), &chrome);
    m.cushion(b.share(0.1..0.9, 0.36..0.48, 0.2..0.74), &pad);
    for (low, from) in [(0.46, 0.15), (0.62, 0.08)] {
        m.cushion(b.share(0.12..0.88, low..low + 0.2, from..from + 0.14), &pad);
    }
    m.cushion(b.share(0.3..0.7, 0.8..1.0, 0.0..0.14), &pad);
    for arm in b.share(0.0..0.13, 0.6..0.66, 0.18..0.66).both_sides() {
        m.rounded(arm, 0.02, &pad);
        m.board(arm.share(0.2..0.8, 0.0..1.0, 0.5..0.66).y(0.4 * a.h..arm.min.y), &chrome);
    }
    m.board(b.share(0.42..0.58, 0.1..0.38, 0.72..0.8), &chrome);
    m.board(b.share(0.2..0.8, 0.1..0.14, 0.8..1.0), &chrome);
    m.surface = Some(0.48 * a.h);
    m
}

/// Walls around a hollow and its floor; the solid is whole.
fn trough(m: &mut BuiltModel, b: Block, s: &Surface) {
    m.solid(b);
    for wall in b.share(0.0..0.12, 0.0..1.0, 0.0..1.0).both_sides() {
        m.mesh.crisp(wall, s);
    }
    for wall in [b.share(0.12..0.88, 0.0..1.0, 0.0..0.14), b.share(0.12..0.88, 0.0..1.0, 0.86..1.0)] {
        m.mesh.crisp(wall, s);
    }
    m.mesh.crisp(b.share(0.12..0.88, 0.0..0.25, 0.14..0.86), &shade(s, 0.85));
}

/// A basin on a column at -z and before it the seat of who lies back to have the hair washed.
pub(super) fn shampoo_station(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let pad = a.main(Stuff(Finish::Leather, 0x2b2d31));
    let (dark, chrome) = (stuff::DARK_PLASTIC.surface(), stuff::CHROME.surface());
    m.board(b.share(0.25..0.75, 0.0..0.7, 0.0..0.2), &dark);
    trough(&mut m, b.share(0.12..0.88, 0.7..0.86, 0.0..0.36), &stuff::CERAMIC.surface());
    m.board(b.share(0.46..0.54, 0.86..1.0, 0.01..0.05), &chrome);
    m.board(b.share(0.46..0.54, 0.96..1.0, 0.05..0.16), &chrome);
    m.board(b.share(0.28..0.72, 0.0..0.34, 0.5..0.8), &dark);
    m.cushion(b.share(0.08..0.92, 0.34..0.46, 0.46..0.86), &pad);
    for (low, from) in [(0.42, 0.42), (0.56, 0.36)] {
        m.cushion(b.share(0.1..0.9, low..low + 0.18, from..from + 0.12), &pad);
    }
    m.cushion(b.share(0.1..0.9, 0.26..0.4, 0.82..1.0), &pad);
    for arm in b.share(0.0..0.1, 0.56..0.61, 0.46..0.78).both_sides() {
        m.rounded(arm, 0.02, &pad);
        m.board(arm.share(0.2..0.8, 0.0..1.0, 0.4..0.6).y(0.38 * a.h..arm.min.y), &dark);
    }
    m.surface = Some(0.46 * a.h);
    m
}

/// The outline of a box with a round top that begins at a share of its height, in (x, y).
fn arch(b: Block, from: f64) -> Vec<(f64, f64)> {
    let (c, half) = (b.center().x, b.size().x / 2.0);
    let spring = b.min.y + from * b.size().y;
    let top = (0..=12).map(|k| (PI * f64::from(k) / 12.0).sin_cos());
    let top = top.enumerate().map(|(k, (sin, cos))| match k {
        0 => (b.max.x, spring),
        6 => (c, b.max.y),
        12 => (b.min.x, spring),
        _ => (c + half * cos, spring + (b.max.y - spring) * sin),
    });
    let mut out = vec![(b.min.x, b.min.y), (b.max.x, b.min.y)];
    out.extend(top);
    out
}

/// A case with a round top, tubes of coloured light along its edge, records behind glass and a grille below.
pub(super) fn jukebox(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wood = a.main(stuff::WALNUT);
    let (warm, pink) = (Stuff(Finish::Glow, 0xf2a33c).surface(), Stuff(Finish::Glow, 0xd8457a).surface());
    let chrome = stuff::CHROME.surface();
    // The solid is the case with all that is on its face.
    let outline = arch(b, 0.6);
    let corner = |(x, y): &(f64, f64), z: f64| scenelang_layout::Vec3::new(*x, *y, z);
    let hull = outline.iter().flat_map(|p| [corner(p, b.min.z), corner(p, b.max.z)]);
    m.solid_hull(hull.collect());
    let depth = |from: f64, to: f64| b.share(0.0..1.0, 0.0..1.0, from..to);
    let layer = |m: &mut BuiltModel, inset: f64, low: f64, (from, to): (f64, f64), s: &Surface| {
        let at = b.share(inset..1.0 - inset, low..1.0 - 0.6 * inset, from..to);
        m.mesh.extrude(2, &arch(at, 0.6), at.min.z..at.max.z, s);
    };
    layer(&mut m, 0.0, 0.0, (0.0, 0.9), &wood);
    layer(&mut m, 0.03, 0.06, (0.9, 0.94), &warm);
    layer(&mut m, 0.1, 0.06, (0.94, 0.96), &pink);
    layer(&mut m, 0.15, 0.06, (0.96, 0.98), &shade(&wood, 0.7));
    let lit = b.share(0.2..0.8, 0.56..0.84, 0.98..0.99);
    m.mesh.extrude(2, &arch(lit, 0.5), lit.min.z..lit.max.z, &Stuff(Finish::Screen, 0xf5e3b0).surface());
    for disc in lit.share(0.04..0.96, 0.1..0.5, 0.0..1.0).split(0, 5, 0.01) {
        m.mesh.crisp(disc.z(lit.max.z..b.max.z), &stuff::DARK_PLASTIC.surface());
    }
    m.mesh.board(depth(0.96, 1.0).share(0.2..0.8, 0.46..0.53, 0.0..1.0), &chrome);
    for bar in depth(0.98, 1.0).share(0.24..0.76, 0.1..0.42, 0.0..1.0).split(0, 7, 0.03) {
        m.mesh.crisp(bar, &chrome);
    }
    m
}

/// Twenty sectors in two colours on a dark ground, and a red middle.
pub(super) fn dartboard(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let dark = a.main(stuff::DARK_PLASTIC);
    m.solid(b);
    let c = b.center();
    m.mesh.disc(2, b.share(0.0..1.0, 0.0..1.0, 0.0..0.6), &dark);
    let (cream, black) = (Stuff(Finish::Paper, 0xe9dcb8).surface(), stuff::RUBBER.surface());
    let (red, green) = (stuff::RED.surface(), Stuff(Finish::Paint, 0x2f7d4a).surface());
    let depth = |from: f64, to: f64| b.min.z + from * a.d..b.min.z + to * a.d;
    let at = |share: f64, k: i32| {
        let (sin, cos) = (TAU * (f64::from(k) - 0.5) / 20.0).sin_cos();
        (c.x + share * a.w * sin, c.y + share * a.h * cos)
    };
    for k in 0..20 {
        let even = k % 2 == 0;
        let sector = |share: f64| [(c.x, c.y), at(share, k), at(share, k + 1)];
        m.mesh.extrude(2, &sector(0.39), depth(0.6, 0.7), if even { &red } else { &green });
        m.mesh.extrude(2, &sector(0.37), depth(0.7, 0.8), if even { &black } else { &cream });
    }
    let middle = |half: f64, from: f64, to: f64| {
        b.share(0.5 - half..0.5 + half, 0.5 - half..0.5 + half, from..1.0).z(depth(from, to))
    };
    m.mesh.disc(2, middle(0.05, 0.8, 0.9), &green);
    m.mesh.disc(2, middle(0.025, 0.9, 1.0).z(depth(0.9, 1.0).start..b.max.z), &red);
    m
}

/// A back with a base and a bar for a row of cues.
pub(super) fn cue_rack(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wood = a.main(stuff::WALNUT);
    let (tip, butt) = (stuff::BIRCH.surface(), shade(&stuff::WALNUT.surface(), 0.5));
    m.board(b.share(0.0..1.0, 0.0..0.1, 0.0..1.0), &wood);
    m.board(b.share(0.0..1.0, 0.1..1.0, 0.0..0.2), &wood);
    m.board(b.share(0.0..1.0, 0.7..0.74, 0.2..0.85), &wood);
    let row = b.share(0.06..0.94, 0.1..0.98, 0.45..0.7);
    m.solid(row);
    for cue in row.split(0, pieces(a.w, 0.11, 2, 8), 0.0) {
        let slim = |half: f64| cue.share(0.5 - half..0.5 + half, 0.0..1.0, 0.5 - half..0.5 + half);
        m.mesh.taper(slim(0.2).y(cue.min.y..cue.min.y), slim(0.15).y(cue.min.y..cue.min.y + 0.4 * a.h), &butt);
        let upper = cue.y(cue.min.y + 0.4 * a.h..cue.max.y);
        let thin = |half: f64| upper.share(0.5 - half..0.5 + half, 0.0..1.0, 0.5 - half..0.5 + half);
        m.mesh.taper(thin(0.15), thin(0.08), &tip);
    }
    m
}

/// Steps between two sides, and magazines that lean on each of them with their covers to the front.
pub(super) fn magazine_rack(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let mut dice = a.dice();
    let b = a.whole();
    let main = a.main(stuff::OAK);
    let t = (0.05 * a.w).min(0.03);
    let side = [(0.0, -0.5), (0.0, 0.5), (0.2, 0.5), (1.0, -0.1), (1.0, -0.5)].map(|(y, z)| (y * a.h, z * a.d));
    for at in b.x(b.min.x..b.min.x + t).both_sides() {
        m.extrude(0, &side, at.min.x..at.max.x, &main);
    }
    let inner = b.x(b.min.x + t..b.max.x - t);
    m.board(inner.share(0.0..1.0, 0.0..1.0, 0.0..0.08), &main);
    let rows = pieces(a.h, 0.3, 2, 5);
    for row in 0..rows {
        let (low, step) = (0.06 + 0.9 * row as f64 / rows as f64, 0.9 / rows as f64);
        // The front of a step is where the sides are at its height.
        let front = if low < 0.2 { 0.97 } else { 0.97 - 0.6 * (low - 0.2) / 0.8 };
        m.board(inner.share(0.0..1.0, low - 0.02..low, 0.08..front), &main);
        m.board(inner.share(0.0..1.0, low..low + 0.05, front - 0.04..front), &main);
        let held = inner.share(0.02..0.98, low..low + 0.92 * step, front - 0.16..front - 0.06);
        m.solid(held);
        for cover in held.split(0, pieces(a.w, 0.24, 2, 8), 0.02) {
            let color = *dice.pick(&[0xc2483f, 0x3f6f9c, 0xe3c56a, 0x5f8f6a, 0xd9d4c8, 0x7a5a86]);
            m.mesh.crisp(cover, &Stuff(Finish::Paper, color).surface());
            let title = cover.share(0.1..0.9, 0.78..0.9, 0.9..1.0);
            m.mesh.crisp(title.moved(0.0, 0.0, 0.02 * cover.size().z), &stuff::PAPER.surface());
        }
    }
    m
}

/// Sides, a back and boards, with boxes and bottles on each of them, the fronts in line.
pub(super) fn medicine_shelf(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let mut dice = a.dice();
    let b = a.whole();
    let main = a.main(stuff::WHITE);
    let t = 0.025_f64.min(0.08 * a.w).min(0.08 * a.d);
    for side in b.x(b.min.x..b.min.x + t).both_sides() {
        m.board(side, &main);
    }
    let inner = b.x(b.min.x + t..b.max.x - t);
    m.board(inner.z(b.min.z..b.min.z + t), &main);
    m.board(inner.y(a.h - 0.08 * a.h..a.h).z(b.min.z + t..b.max.z), &Stuff(Finish::Paint, 0x2f8f5b).surface());
    m.board(inner.y(0.0..0.06 * a.h).z(b.min.z + t..b.max.z), &main);
    let rows = pieces(a.h, 0.34, 1, 6);
    for (row, space) in inner.y(0.06 * a.h..0.92 * a.h).split(1, rows, 0.0).enumerate() {
        let size = space.size();
        let board = 0.025_f64.min(0.1 * size.y);
        if row > 0 {
            m.board(space.y(space.min.y..space.min.y + board).z(b.min.z + t..b.max.z), &main);
        }
        let low = space.min.y + if row > 0 { board } else { 0.0 };
        let goods = space.share(0.01..0.99, 0.0..1.0, 0.25..0.92).y(low..space.min.y + 0.72 * size.y);
        m.solid(goods);
        let colors = [0xf3f4f2, 0xf3f4f2, 0x9fcdb4, 0x8fb8d8, 0xf0d9a0, 0xe2a49a];
        for item in goods.split(0, pieces(size.x, 0.085, 1, 30), 0.012) {
            let item = item.y(item.min.y..item.min.y + dice.between(0.55, 1.0) * goods.size().y);
            let s = Stuff(Finish::Paper, *dice.pick(&colors)).surface();
            m.mesh.crisp(item, &s);
        }
    }
    m
}

/// Decks over each other, each with a lit window and a handle.
pub(super) fn deck_oven(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let steel = a.main(stuff::STEEL);
    let dark = stuff::DARK_PLASTIC.surface();
    m.solid(b);
    let deep = 0.08 * a.d;
    m.mesh.board(b.y(0.12 * a.h..a.h).z(b.min.z..b.max.z - deep), &steel);
    m.mesh.crisp(b.inset(0.03 * a.w, 0.0, 0.0).y(0.0..0.12 * a.h).z(b.min.z..b.max.z - 2.0 * deep), &dark);
    let face = b.z(b.max.z - deep..b.max.z);
    for deck in face.y(0.16 * a.h..0.98 * a.h).split(1, pieces(a.h, 0.45, 1, 4), 0.03) {
        let door = deck.share(0.03..0.78, 0.0..1.0, 0.0..0.5);
        m.mesh.board(door, &shade(&steel, 0.85));
        m.mesh.crisp(
            door.share(0.12..0.88, 0.25..0.7, 0.98..1.0).z(door.max.z..door.max.z + 0.1 * deep),
            &stuff::WARM.surface(),
        );
        m.mesh.board(deck.share(0.12..0.69, 0.82..0.9, 0.5..1.0), &stuff::CHROME.surface());
        m.mesh.board(deck.share(0.82..0.97, 0.1..0.9, 0.0..0.4), &dark);
        for knob in [0.25, 0.6] {
            m.mesh.disc(2, deck.share(0.86..0.93, knob..knob + 0.16, 0.4..0.7), &stuff::CHROME.surface());
        }
    }
    m
}

/// A panel of foam that takes sound: squares of two depths in a frame of cloth.
pub(super) fn acoustic_panel(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Fabric, 0x4a5560));
    m.solid(b);
    m.mesh.board(b.share(0.0..1.0, 0.0..1.0, 0.0..0.5), &main);
    let inner = b.share(0.02..0.98, 0.02..0.98, 0.5..1.0);
    for (i, column) in inner.split(0, pieces(a.w, 0.16, 2, 10), 0.012).enumerate() {
        for (k, tile) in column.split(1, pieces(a.h, 0.16, 2, 10), 0.012).enumerate() {
            let high = (i + k) % 2 == 0;
            let s = if high { shade(&main, 1.25) } else { shade(&main, 0.75) };
            m.mesh.crisp(tile.share(0.0..1.0, 0.0..1.0, 0.0..if high { 1.0 } else { 0.4 }), &s);
        }
    }
    m
}

/// A cabin with thick walls and a door with a window, behind which foam and a microphone are seen.
pub(super) fn vocal_booth(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Fabric, 0x50565d));
    let dark = stuff::BLACK_STEEL.surface();
    m.solid(b);
    let deep = 0.06 * a.d;
    m.mesh.board(b.z(b.min.z..b.max.z - deep), &main);
    let face = b.z(b.max.z - deep..b.max.z);
    for post in face.share(0.0..0.08, 0.0..1.0, 0.0..1.0).both_sides() {
        m.mesh.board(post, &dark);
    }
    for beam in [face.share(0.08..0.92, 0.0..0.06, 0.0..1.0), face.share(0.08..0.92, 0.92..1.0, 0.0..1.0)] {
        m.mesh.board(beam, &dark);
    }
    let room = face.share(0.1..0.9, 0.08..0.9, 0.0..0.2);
    m.mesh.crisp(room, &Stuff(Finish::Screen, 0x6b6257).surface());
    for foam in room.share(0.0..1.0, 0.0..1.0, 1.0..1.0).z(room.max.z..room.max.z + 0.1 * deep).split(0, 7, 0.02) {
        m.mesh.crisp(foam, &Stuff(Finish::Fabric, 0x3a3f45).surface());
    }
    let before = room.z(room.max.z + 0.1 * deep..room.max.z + 0.4 * deep);
    m.mesh.crisp(before.share(0.49..0.51, 0.0..0.62, 0.3..0.7), &stuff::CHROME.surface());
    m.mesh.disc(2, before.share(0.45..0.55, 0.62..0.72, 0.0..1.0), &stuff::STEEL.surface());
    m.mesh.crisp(face.share(0.1..0.9, 0.08..0.9, 0.8..0.86), &stuff::GLASS.surface());
    m.mesh.board(face.share(0.8..0.84, 0.42..0.52, 0.86..1.0), &stuff::CHROME.surface());
    m
}

/// An electronic piano: a slab of keys on two legs with a bar between them, or the slab alone where it is low.
pub(super) fn electronic_keyboard(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::DARK_PLASTIC);
    let steel = stuff::BLACK_STEEL.surface();
    let stands = a.h > 0.35;
    let slab = if stands { b.share(0.0..1.0, 0.78..0.9, 0.0..1.0) } else { b };
    if stands {
        for leg in b.share(0.06..0.1, 0.04..0.78, 0.35..0.65).both_sides() {
            m.board(leg, &steel);
        }
        for foot in b.share(0.05..0.11, 0.0..0.04, 0.0..1.0).both_sides() {
            m.board(foot, &steel);
        }
        m.board(b.share(0.1..0.9, 0.3..0.34, 0.42..0.58), &steel);
        m.board(b.share(0.3..0.7, 0.9..1.0, 0.02..0.1), &main);
        m.surface = Some(slab.max.y);
    }
    m.solid(slab);
    m.mesh.board(slab.share(0.0..1.0, 0.0..0.8, 0.0..1.0), &main);
    let top = slab.share(0.0..1.0, 0.8..1.0, 0.0..1.0);
    m.mesh.crisp(top.share(0.0..1.0, 0.0..0.8, 0.0..0.5), &main);
    m.mesh.crisp(top.share(0.42..0.58, 0.8..1.0, 0.15..0.4), &stuff::SCREEN.surface());
    for cheek in top.share(0.0..0.03, 0.0..1.0, 0.5..1.0).both_sides() {
        m.mesh.crisp(cheek, &main);
    }
    let keys = top.share(0.03..0.97, 0.0..0.6, 0.5..0.99);
    m.mesh.crisp(keys, &Stuff(Finish::Plastic, 0xf7f5ee).surface());
    for (i, key) in keys.split(0, pieces(a.w, 0.025, 14, 52), 0.0).enumerate() {
        if !matches!(i % 7, 2 | 6) {
            let black = key.share(0.72..1.0, 0.0..1.0, 0.0..0.6).y(keys.max.y..top.max.y);
            m.mesh.crisp(black, &stuff::RUBBER.surface());
        }
    }
    m
}
