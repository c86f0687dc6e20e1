//! Plants, vessels, books, clocks and other things that make a room lived in.

use super::panels::disc;
use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use crate::words::Dice;
use scenelang_layout::Vec3;
use std::f64::consts::TAU;

/// A leaf: which way it points from above (radians), how far its tip would rise and how far it droops, and its size.
struct Leaf {
    yaw: f64,
    rise: f64,
    droop: f64,
    long: f64,
    wide: f64,
}

impl Leaf {
    fn draw(&self, mesh: &mut Mesh, from: Vec3, s: &Surface) {
        let (sin, cos) = self.yaw.sin_cos();
        let path: Vec<_> = [0.0, 0.18, 0.42, 0.68, 0.88, 1.0]
            .into_iter()
            .zip([0.12, 0.5, 1.0, 0.8, 0.38, 0.02])
            .map(|(t, width)| {
                let out = self.long * t * (1.0 - 0.15 * t);
                let up = self.rise * t - self.droop * t * t;
                let at = from + Vec3::new(cos * out, up, sin * out);
                (at, 0.5 * self.wide * width, 0.05 * self.wide * (0.3 + width))
            })
            .collect();
        mesh.sweep(&path, Vec3::y(), 6, s);
    }
}

/// The pot of a plant: filled box, soil set in; returns the height of the soil.
fn pot(m: &mut BuiltModel, b: Block, s: &Surface) -> f64 {
    m.solid_drum(b);
    let size = b.size();
    m.mesh.lathe(
        b,
        &[(0.7, 0.0), (0.74, 0.04), (0.97, 0.86), (1.0, 0.88), (1.0, 1.0), (0.9, 1.0), (0.88, 0.86)],
        24,
        s,
    );
    let soil = b.min.y + 0.9 * size.y;
    m.mesh.drum(b.inset(0.06 * size.x, 0.0, 0.06 * size.z).y(soil - 0.06 * size.y..soil), &stuff::SOIL.surface());
    soil
}

/// Potted plants and trees: broad leaves, palms, blades, cactuses, clouds of foliage, by words and size.
pub(super) fn plant(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let mut dice = a.dice();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Ceramic, 0xe9e6df));
    // A green plant is not a green pot.
    let [r, g, bl] = main.color;
    let leafy = a.has_color() && g > r && g > bl;
    let clay = if leafy { stuff::CERAMIC.surface() } else { main.clone() };
    let green = if leafy { crate::looks::surface(Finish::Leaf, main.color) } else { stuff::LEAF.surface() };
    let tree = a.says(&["tree", "olive", "ficus"]) && a.h > 0.8;
    let high = if tree {
        0.24
    } else if a.h > 1.0 {
        0.26
    } else {
        0.4
    } * a.h;
    let share = if a.h > 0.6 { 0.27 } else { 0.36 };
    let (pw, pd) = ((share * a.w).min(0.9 * high.max(0.3 * a.w)), (share * a.d).min(0.9 * high.max(0.3 * a.d)));
    let soil = pot(&mut m, block(-pw..pw, 0.0..high, -pd..pd), &clay);
    let crown = b.y(high..a.h);
    if a.says(&["cactus"]) {
        m.solid_drum(crown);
        m.mesh.stretch(crown, |mesh| cactus(mesh, &green));
    } else if tree {
        let low = high + 0.38 * (a.h - high);
        let r = (0.05 * a.w).min(0.05 * a.d).min(0.3 * pw);
        m.solid_drum(block(-r..r, high..low, -r..r));
        let bark = Stuff(Finish::Wood, 0x6b5139).surface();
        let at = |x: f64, y: f64, thick: f64| (Vec3::new(x * r, y, 0.0), thick * r, thick * r);
        let fork = low + 0.5 * (a.h - low);
        let path = [at(0.0, soil, 1.0), at(0.25, 0.5 * (soil + low), 0.85), at(-0.1, low, 0.75), at(0.0, fork, 0.4)];
        m.mesh.sweep(&path, Vec3::z(), 10, &bark);
        let top = b.y(low..a.h);
        m.solid_drum(top);
        m.mesh.stretch(top, |mesh| foliage(mesh, &mut dice, &green));
    } else {
        m.solid_drum(crown);
        let palm = a.says(&["palm", "fern", "yucca", "dracaena", "areca"]);
        let blades = a.says(&["snake", "aloe", "agave", "grass", "sansevieria", "succulent", "bamboo"]);
        let bush = a.says(&["bush", "boxwood", "topiary", "hedge", "shrub", "flower", "bonsai"]);
        let from = soil.min(high);
        if bush {
            m.mesh.stretch(crown, |mesh| foliage(mesh, &mut dice, &green));
        } else {
            m.mesh.stretch(b.y(from..a.h), |mesh| {
                if blades {
                    upright(mesh, &mut dice, &green);
                } else if palm || (a.h > 1.3 && !a.says(&["rubber", "monstera"])) {
                    fronds(mesh, &mut dice, &green);
                } else {
                    broad(mesh, &mut dice, &green);
                }
            });
        }
    }
    if a.says(&["flower", "rose", "tulip", "orchid"]) {
        blossoms(&mut m.mesh, crown, &mut dice);
    }
    m
}

/// Broad leaves on stalks in a spiral, in a cylinder of radius 1 and height 2 or so.
fn broad(mesh: &mut Mesh, dice: &mut Dice, green: &Surface) {
    let dark = shade(green, 0.82);
    for k in 0..16 {
        let t = f64::from(k) / 15.0;
        let yaw = f64::from(k) * 2.4 + dice.between(-0.2, 0.2);
        let y = 0.25 + 1.25 * t;
        let (sin, cos) = yaw.sin_cos();
        let reach = 0.14 + 0.2 * (1.0 - t);
        let tip = Vec3::new(cos * reach, y, sin * reach);
        mesh.tube(
            &[Vec3::new(0.05 * cos, 0.0, 0.05 * sin), Vec3::new(0.5 * cos * reach, 0.55 * y, 0.5 * sin * reach), tip],
            0.012,
            &dark,
        );
        let long = dice.between(0.6, 0.75) * (1.0 - 0.3 * t);
        let blade = Leaf { yaw, rise: 0.35 + 0.3 * t, droop: 0.45, long, wide: 0.42 * (1.0 - 0.25 * t) };
        blade.draw(mesh, tip, if k % 2 == 0 { green } else { &dark });
    }
}

/// Long arching fronds.
fn fronds(mesh: &mut Mesh, dice: &mut Dice, green: &Surface) {
    let dark = shade(green, 0.8);
    for k in 0..22 {
        let yaw = f64::from(k) * 2.4 + dice.between(-0.2, 0.2);
        let t = f64::from(k) / 21.0;
        let (sin, cos) = yaw.sin_cos();
        let high = 0.45 + 1.0 * t;
        let base = Vec3::new(0.07 * cos, high, 0.07 * sin);
        mesh.tube(&[Vec3::new(0.03 * cos, 0.0, 0.03 * sin), base], 0.014, &dark);
        let long = dice.between(0.8, 1.0) * (1.0 - 0.25 * t);
        let blade = Leaf { yaw, rise: dice.between(0.75, 1.0), droop: dice.between(0.6, 0.95), long, wide: 0.17 };
        blade.draw(mesh, base, if k % 2 == 0 { green } else { &dark });
    }
}

/// Stiff blades that stand upright.
fn upright(mesh: &mut Mesh, dice: &mut Dice, green: &Surface) {
    let dark = shade(green, 0.78);
    for k in 0..13 {
        let yaw = f64::from(k) * 2.4;
        let (sin, cos) = yaw.sin_cos();
        let r = 0.1 + 0.25 * f64::from(k % 4) / 3.0;
        let base = Vec3::new(r * cos, 0.0, r * sin);
        let (rise, long) = (dice.between(1.2, 2.0), dice.between(0.1, 0.4));
        let blade = Leaf { yaw, rise, droop: 0.0, long, wide: 0.26 };
        blade.draw(mesh, base, if k % 3 == 0 { &dark } else { green });
    }
}

/// Overlapping balls of leaves.
fn foliage(mesh: &mut Mesh, dice: &mut Dice, green: &Surface) {
    let shades = [green.clone(), shade(green, 0.85), shade(green, 1.15)];
    for k in 0..14 {
        let t = (f64::from(k) + 0.5) / 14.0;
        let yaw = f64::from(k) * 2.4;
        let y = 1.0 - 2.0 * t;
        let out = (1.0 - y * y).sqrt() * 0.55;
        let c = Vec3::new(out * yaw.cos(), 0.5 * y, out * yaw.sin());
        let r = dice.between(0.36, 0.5);
        let ball = block(-r..r, -0.85 * r..0.85 * r, -r..r).moved(c.x, c.y, c.z);
        mesh.lathe(
            ball,
            &[(0.0, 0.0), (0.5, 0.07), (0.87, 0.25), (1.0, 0.5), (0.87, 0.75), (0.5, 0.93), (0.0, 1.0)],
            12,
            &shades[k as usize % 3],
        );
    }
}

fn cactus(mesh: &mut Mesh, green: &Surface) {
    let round = [(0.7, 0.0), (1.0, 0.15), (1.0, 0.8), (0.8, 0.93), (0.4, 0.99), (0.0, 1.0)];
    mesh.lathe(block(-0.4..0.4, 0.0..2.0, -0.4..0.4), &round, 16, green);
    for (side, y) in [(1.0, 0.7), (-1.0, 1.0)] {
        let at = |x: f64, up: f64| Vec3::new(side * x, y + up, 0.0);
        mesh.tube(&[at(0.3, 0.0), at(0.7, 0.05), at(0.8, 0.2), at(0.8, 0.6)], 0.2, green);
    }
    mesh.ball(block(-0.2..0.2, -0.2..0.2, -0.4..0.4).moved(0.0, 1.0, 0.0), green);
}

fn blossoms(mesh: &mut Mesh, crown: Block, dice: &mut Dice) {
    let size = crown.size();
    for k in 0..9 {
        let yaw = f64::from(k) * 2.4;
        let out = dice.between(0.1, 0.38);
        let c = crown.center() + Vec3::new(out * size.x * yaw.cos(), 0.32 * size.y, out * size.z * yaw.sin());
        let r = 0.07 * size.x.min(size.z);
        let s = Stuff(Finish::Leaf, *dice.pick(&[0xe0607e, 0xf2c14e, 0xf4f1ea, 0xc45ab3])).surface();
        mesh.bud(block(-r..r, -0.6 * r..0.6 * r, -r..r).moved(c.x, c.y, c.z), &s);
    }
}

/// Vases, and the flowers in them where the word asks.
pub(super) fn vase(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Ceramic, 0x8fb0ad));
    let flowers = a.says(&["flower", "bouquet", "rose", "tulip", "peony", "floral"]);
    let high = if flowers { 0.5 * a.h } else { a.h };
    let share = if flowers { 0.55 } else { 1.0 };
    let jar = b.y(0.0..high).inset(0.5 * (1.0 - share) * a.w, 0.0, 0.5 * (1.0 - share) * a.d);
    let turned = [
        (0.5, 0.0),
        (0.56, 0.03),
        (0.86, 0.25),
        (1.0, 0.48),
        (0.88, 0.7),
        (0.5, 0.88),
        (0.48, 0.93),
        (0.62, 1.0),
        (0.54, 1.0),
        (0.4, 0.9),
        (0.4, 0.6),
    ];
    m.lathe(jar, &turned, &main);
    if flowers {
        let mut dice = a.dice();
        let bunch = b.y(high..a.h);
        m.solid_drum(bunch);
        let c = Stuff(Finish::Leaf, 0x557f4a).surface();
        m.mesh.stretch(b.y(0.9 * high..a.h), |mesh| {
            for k in 0..14 {
                let yaw = f64::from(k) * 2.4;
                let out = 0.2 + 0.75 * f64::from(k) / 13.0;
                let (sin, cos) = yaw.sin_cos();
                let top = Vec3::new(out * cos, 1.6 - 0.6 * out * out, out * sin);
                mesh.tube(&[Vec3::new(0.1 * cos, 0.0, 0.1 * sin), top], 0.018, &c);
                Leaf { yaw: yaw + 0.8, rise: 0.3, droop: 0.2, long: 0.35, wide: 0.16 }.draw(mesh, top * 0.6, &c);
                let s = Stuff(Finish::Leaf, *dice.pick(&[0xe0607e, 0xf2c14e, 0xf4f1ea, 0xb45ab3, 0xe8842c])).surface();
                mesh.bud(block(-0.16..0.16, -0.12..0.14, -0.16..0.16).moved(top.x, top.y, top.z), &s);
            }
        });
    }
    m
}

const BOTTLES: &[Stuff] = &[
    Stuff(Finish::Glass, 0x4f8a63),
    Stuff(Finish::Glass, 0x7a4526),
    Stuff(Finish::Glass, 0xb9822f),
    Stuff(Finish::Glass, 0x8fb7bd),
    Stuff(Finish::Glass, 0x7d2f3b),
];

/// Bottles: a body, a neck, a cap.
pub(super) fn bottle(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    // Bottles on a shelf are not all alike.
    let usual = match () {
        () if a.says(&["ketchup"]) => Stuff(Finish::Plastic, 0xb8281f),
        () if a.says(&["mustard"]) => Stuff(Finish::Plastic, 0xdfb12c),
        () if a.says(&["detergent"]) => Stuff(Finish::Plastic, 0x3f78b5),
        () if a.says(&["lotion", "glue"]) => Stuff(Finish::Plastic, 0xd9cdbf),
        () if a.says(&["olive"]) => Stuff(Finish::Glass, 0x8a8a2f),
        () => *a.dice().pick(BOTTLES),
    };
    let main = a.main(usual);
    let b = a.whole();
    m.solid_drum(b);
    m.mesh.lathe(
        b.y(0.0..0.93 * a.h),
        &[(0.9, 0.0), (0.98, 0.03), (0.98, 0.58), (0.88, 0.68), (0.42, 0.82), (0.36, 0.88), (0.36, 1.0)],
        24,
        &main,
    );
    m.mesh.drum(b.inset(0.29 * a.w, 0.0, 0.29 * a.d).y(0.92 * a.h..a.h), &a.second(stuff::DARK_PLASTIC));
    // The label is outermost.
    m.mesh.lathe(b.y(0.2 * a.h..0.5 * a.h), &[(1.0, 0.0), (1.0, 1.0)], 24, &stuff::PAPER.surface());
    m
}

/// Cups and drinking glasses; wide ones have a handle on the right.
pub(super) fn cup(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let glass = a.says(&["glass", "wineglass", "tumbler"]);
    let main = a.main(if glass { stuff::GLASS } else { stuff::CERAMIC });
    let b = a.whole();
    let handled = a.w > 1.12 * a.d;
    let body = if handled { b.x(b.min.x..b.min.x + a.d) } else { b };
    if a.says(&["wine", "wineglass", "champagne"]) {
        let stem = [
            (0.8, 0.0),
            (0.82, 0.02),
            (0.1, 0.05),
            (0.08, 0.45),
            (0.6, 0.55),
            (1.0, 0.75),
            (0.9, 1.0),
            (0.84, 1.0),
            (0.92, 0.76),
            (0.55, 0.6),
        ];
        m.lathe(body, &stem, &main);
    } else {
        m.lathe(body, &[(0.74, 0.0), (0.8, 0.04), (0.98, 0.6), (1.0, 1.0), (0.9, 1.0), (0.88, 0.6), (0.7, 0.1)], &main);
    }
    if handled {
        let c = body.center();
        let r = (b.max.x - body.max.x).min(0.3 * a.h);
        let t = (0.22 * r).min(0.3 * a.d);
        m.solid(block(c.x..b.max.x, 0.25 * a.h..0.8 * a.h, -t..t));
        let at = |x: f64, y: f64| Vec3::new(body.max.x - 0.1 * a.d + x, y * a.h, 0.0);
        let out = b.max.x - body.max.x + 0.1 * a.d - t;
        let path =
            [at(0.0, 0.74), at(0.75 * out, 0.74), at(out, 0.6), at(out, 0.45), at(0.7 * out, 0.3), at(0.0, 0.27)];
        m.mesh
            .stretch(block(c.x + 0.4 * a.d..b.max.x, 0.25 * a.h..0.8 * a.h, -t..t), |mesh| mesh.tube(&path, t, &main));
    }
    m
}

/// Plates and bowls.
pub(super) fn dish(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(stuff::CERAMIC);
    let flat = a.h < 0.25 * a.w.min(a.d);
    let turned: &[(f64, f64)] = if flat {
        &[(0.55, 0.0), (0.62, 0.1), (0.97, 0.85), (1.0, 1.0), (0.93, 1.0), (0.66, 0.4), (0.6, 0.3)]
    } else {
        &[(0.42, 0.0), (0.46, 0.05), (0.8, 0.4), (1.0, 1.0), (0.94, 1.0), (0.74, 0.42), (0.4, 0.12)]
    };
    m.lathe(a.whole(), turned, &main);
    if a.says(&["fruit"]) {
        let mut dice = a.dice();
        let r = 0.17 * a.w.min(a.d);
        for k in 0..5 {
            let (sin, cos) = (TAU * f64::from(k) / 5.0).sin_cos();
            let s = Stuff(Finish::Plastic, *dice.pick(&[0xc8392f, 0xe6a532, 0x8fb03e])).surface();
            let (x, z) = (0.22 * a.w * cos, 0.22 * a.d * sin);
            let up = (0.3 * a.h).min(a.h - 2.0 * r).max(0.0);
            m.mesh.ball(block(-r..r, up..(up + 2.0 * r).min(a.h), -r..r).moved(x, 0.0, z), &s);
        }
    }
    m
}

/// Pots and pans: a steel body, handles left and right, a lid.
pub(super) fn pan(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(stuff::STEEL);
    let b = a.whole();
    let body = b.inset(0.1 * a.w, 0.0, 0.0).y(0.0..0.84 * a.h);
    m.solid_drum(body);
    m.mesh.lathe(body, &[(0.94, 0.0), (1.0, 0.08), (1.0, 0.9), (0.9, 0.97), (0.4, 1.0)], 24, &main);
    let knob = b.inset(0.42 * a.w, 0.0, 0.42 * a.d).y(0.84 * a.h..a.h);
    m.drum(knob, &stuff::DARK_PLASTIC.surface());
    let t = 0.04 * a.h;
    m.board(b.y(0.62 * a.h..0.62 * a.h + 2.0 * t).inset(0.0, 0.0, 0.42 * a.d), &stuff::DARK_PLASTIC.surface());
    m
}

/// One book lying flat, or a small pile of them.
pub(super) fn book(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let mut dice = a.dice();
    let b = a.whole();
    m.solid(b);
    if a.h > 1.3 * a.w && a.d > 1.3 * a.w {
        return standing(m, a);
    }
    let n = if a.h > 0.05 { pieces(a.h, 0.035, 2, 8) } else { 1 };
    let colors = [0x2f4b66, 0x8c3b33, 0x4f6b52, 0xc79a4a, 0x7a5470];
    for (i, book) in b.split(1, n, 0.0).enumerate() {
        let cover = if i + 1 == n && a.has_color() {
            a.main(stuff::PAPER)
        } else {
            Stuff(Finish::Paper, *dice.pick(&colors)).surface()
        };
        let off = if i == 0 || i + 1 == n { 0.0 } else { dice.between(0.0, 0.06) };
        let book = book.inset(off * a.w, 0.0, off * a.d);
        let s = book.size();
        let t = 0.12 * s.y;
        m.mesh.crisp(book.y(book.min.y..book.min.y + t), &cover);
        m.mesh.crisp(book.y(book.max.y - t..book.max.y), &cover);
        m.mesh.crisp(book.x(book.min.x..book.min.x + 0.04 * s.x).y(book.min.y + t..book.max.y - t), &cover);
        m.mesh.crisp(
            book.x(book.min.x + 0.04 * s.x..book.max.x - 0.02 * s.x).y(book.min.y + t..book.max.y - t).inset(
                0.0,
                0.0,
                0.02 * s.z,
            ),
            &stuff::PAPER.surface(),
        );
    }
    m
}

/// A book or a binder that stands with its spine to +z.
fn standing(mut m: BuiltModel, a: &Ask) -> BuiltModel {
    const COLORS: [u32; 7] = [0x2f4b66, 0x8c3b33, 0x4f6b52, 0xc79a4a, 0x7a5470, 0xd9d2c0, 0x37393d];
    let (b, mut dice) = (a.whole(), a.dice());
    let picked = Stuff(Finish::Paper, *dice.pick(&COLORS)).surface();
    let cover = if a.has_color() { a.main(stuff::PAPER) } else { picked };
    for side in b.share(0.0..0.12, 0.0..1.0, 0.0..0.97).both_sides() {
        m.mesh.crisp(side, &cover);
    }
    m.mesh.crisp(b.share(0.0..1.0, 0.0..1.0, 0.97..1.0), &cover);
    m.mesh.crisp(b.share(0.12..0.88, 0.02..0.97, 0.03..0.97), &stuff::PAPER.surface());
    m
}

/// Sheets of paper, a little askew on top.
pub(super) fn paper(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    m.solid(b);
    let main = a.main(if a.says(&["blueprint"]) { Stuff(Finish::Paper, 0x3f6fa8) } else { stuff::PAPER });
    for (i, sheet) in b.split(1, pieces(a.h, 0.01, 1, 6), 0.0).enumerate() {
        let off = if i % 2 == 1 { 0.015 } else { 0.0 };
        m.mesh.crisp(sheet.inset(off * a.w, 0.0, off * a.d), &main);
    }
    m
}

/// A round clock for the wall; tall ones stand on the floor in a case.
pub(super) fn clock(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::WALNUT);
    let face = Stuff(Finish::Paper, 0xfaf8f2).surface();
    let dark = stuff::DARK_PLASTIC.surface();
    let dial = if a.h > 1.6 * a.w && a.h > 0.5 {
        m.solid(b);
        m.mesh.board(b.y(0.0..0.1 * a.h), &main);
        m.mesh.board(b.inset(0.08 * a.w, 0.0, 0.0).y(0.1 * a.h..0.74 * a.h).z(b.min.z..b.max.z - 0.1 * a.d), &main);
        m.mesh.board(b.y(0.74 * a.h..a.h).z(b.min.z..b.max.z - 0.06 * a.d), &main);
        let glass = b.inset(0.25 * a.w, 0.0, 0.0).y(0.2 * a.h..0.68 * a.h);
        m.mesh.board(glass.z(b.max.z - 0.1 * a.d..b.max.z - 0.08 * a.d), &shade(&main, 0.5));
        m.mesh.ball(
            block(
                -0.1 * a.w..0.1 * a.w,
                0.28 * a.h..0.28 * a.h + 0.2 * a.w,
                b.max.z - 0.09 * a.d..b.max.z - 0.03 * a.d,
            ),
            &stuff::BRASS.surface(),
        );
        let r = 0.38 * a.w;
        let c = 0.87 * a.h;
        let r_y = r.min(0.11 * a.h);
        let dial = block(-r..r, c - r_y..c + r_y, b.max.z - 0.08 * a.d..b.max.z);
        let mut sub = BuiltModel::default();
        disc(&mut sub, dial, &stuff::BRASS.surface(), &face);
        m.mesh.stretch(dial, |mesh| *mesh = sub.mesh);
        dial
    } else {
        disc(&mut m, b, &main, &face);
        b
    };
    let (s, c) = (dial.size(), dial.center());
    let front = dial.min.z + 0.62 * s.z;
    for k in 0..12 {
        let (sin, cos) = (TAU * f64::from(k) / 12.0).sin_cos();
        let (x, y) = (c.x + 0.36 * s.x * sin, c.y + 0.36 * s.y * cos);
        let r = if k % 3 == 0 { 0.022 } else { 0.012 };
        m.mesh.crisp(block(x - r * s.x..x + r * s.x, y - r * s.y..y + r * s.y, dial.min.z + 0.58 * s.z..front), &dark);
    }
    for (angle, long, wide) in [(305.0_f64, 0.2, 0.016), (60.0, 0.31, 0.011)] {
        let (sin, cos) = angle.to_radians().sin_cos();
        let tip = (c.x + long * s.x * sin, c.y + long * s.y * cos);
        let (ox, oy) = (wide * s.x * cos, -wide * s.y * sin);
        let hand = [
            (c.x - ox, c.y - oy),
            (c.x + ox, c.y + oy),
            (tip.0 + 0.5 * ox, tip.1 + 0.5 * oy),
            (tip.0 - 0.5 * ox, tip.1 - 0.5 * oy),
        ];
        m.mesh.extrude(2, &hand, front..front + 0.08 * s.z, &dark);
    }
    m
}

/// A figure on a plinth.
pub(super) fn statue(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Stone, 0xe3dfd6));
    let foot = 0.3 * a.h;
    m.board(b.y(0.0..0.05 * a.h), &main);
    m.board(b.inset(0.1 * a.w, 0.0, 0.1 * a.d).y(0.05 * a.h..foot), &main);
    let figure = b.inset(0.16 * a.w, 0.0, 0.16 * a.d).y(foot..a.h);
    let turned = [
        (0.7, 0.0),
        (0.62, 0.1),
        (0.5, 0.28),
        (0.75, 0.42),
        (1.0, 0.58),
        (0.8, 0.68),
        (0.28, 0.73),
        (0.26, 0.77),
        (0.46, 0.84),
        (0.48, 0.91),
        (0.34, 0.97),
        (0.0, 1.0),
    ];
    m.lathe(figure, &turned, &main);
    m
}

/// A person in plain shapes, standing: mannequins, and stand-ins for people.
pub(super) fn person(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Plastic, 0xd9d5cd));
    // A mannequin shows what it wears.
    let mut dice = a.dice();
    let dressed = a.says(&["mannequin", "manikin"]);
    let cloth = |color: u32| if dressed { Stuff(Finish::Fabric, color).surface() } else { main.clone() };
    let top = cloth(*dice.pick(&[0xa8483f, 0x3f6f8c, 0xd2a94a, 0x5f7f63, 0x8a5f7c]));
    let trousers = cloth(0x2f3a4a);
    m.solid(b.y(0.0..0.44 * a.h).inset(0.15 * a.w, 0.0, 0.0));
    m.solid_drum(b.y(0.44 * a.h..0.84 * a.h));
    m.solid_drum(b.inset(0.3 * a.w, 0.0, 0.05 * a.d).y(0.84 * a.h..a.h));
    m.mesh.stretch(b, |mesh| {
        for side in [-1.0, 1.0] {
            let leg = [(0.55, 0.0), (0.5, 0.06), (0.62, 0.45), (0.95, 0.9), (1.0, 1.0)];
            mesh.lathe(block(-0.09..0.09, 0.0..0.9, -0.1..0.1).moved(0.11 * side, 0.0, 0.0), &leg, 12, &trousers);
            mesh.rounded(block(-0.06..0.06, 0.0..0.07, -0.08..0.19).moved(0.11 * side, 0.0, 0.0), 0.03, 2, &main);
            mesh.tube(
                &[
                    Vec3::new(0.2 * side, 1.42, 0.0),
                    Vec3::new(0.27 * side, 1.1, 0.0),
                    Vec3::new(0.26 * side, 0.82, 0.06),
                ],
                0.045,
                &top,
            );
        }
        let torso = [(0.75, 0.0), (0.9, 0.1), (0.72, 0.38), (1.0, 0.8), (0.85, 0.95), (0.3, 1.0), (0.27, 1.06)];
        mesh.lathe(block(-0.22..0.22, 0.84..1.48, -0.13..0.13), &torso, 20, &top);
        mesh.ball(block(-0.09..0.09, 1.5..1.76, -0.11..0.11), &main);
    });
    m
}

/// A globe on a stand, or any ball, flat where it rests.
pub(super) fn ball(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let globe = a.says(&["globe", "world"]);
    let main = a.main(if globe { Stuff(Finish::Plastic, 0x3f7fb0) } else { Stuff(Finish::Rubber, 0xd96a3a) });
    // A globe on a stand is as round as its width allows.
    let foot = if globe { (0.16 * a.h).max(a.h - a.w.min(a.d)) } else { 0.0 };
    if globe {
        m.lathe(
            b.inset(0.2 * a.w, 0.0, 0.2 * a.d).y(0.0..foot),
            &[(1.0, 0.0), (1.0, 0.08), (0.24, 0.2), (0.16, 1.0)],
            &stuff::WALNUT.surface(),
        );
    }
    let sphere = b.y(foot..a.h);
    m.solid_drum(sphere);
    m.mesh.lathe(sphere, &crate::shapes::sphere(14), 24, &main);
    m
}

/// Water, gravel and weed behind glass, on a stand where it is high.
pub(super) fn aquarium(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    m.solid(b);
    let low = if a.h > 0.9 { 0.5 * a.h } else { 0.06 * a.h };
    m.mesh.board(b.y(0.0..low), &a.main(stuff::BLACK_STEEL));
    m.mesh.board(b.y(0.94 * a.h..a.h), &stuff::BLACK_STEEL.surface());
    let tank = b.inset(0.004, 0.0, 0.004).y(low..0.94 * a.h);
    let size = tank.size();
    m.mesh.crisp(
        tank.y(low..low + 0.1 * size.y).inset(0.01 * a.w, 0.0, 0.02 * a.d),
        &Stuff(Finish::Soil, 0xc9b48a).surface(),
    );
    m.mesh.crisp(tank.y(low..low + 0.88 * size.y), &Stuff(Finish::Water, 0x5fb3cf).surface());
    let weed = stuff::LEAF.surface();
    for (k, x) in [-0.32, -0.1, 0.2, 0.36].into_iter().enumerate() {
        let high = size.y * (0.35 + 0.1 * (k % 3) as f64);
        let at = Vec3::new(x * size.x, low + 0.1 * size.y, 0.0);
        let path = [
            (at, 0.012 * size.x, 0.02 * size.z),
            (at + Vec3::y() * (0.6 * high), 0.02 * size.x, 0.05 * size.z),
            (at + Vec3::y() * high, 0.0, 0.0),
        ];
        m.mesh.sweep(&path, Vec3::z(), 6, &weed);
    }
    m
}

/// A parasol: a foot, a pole, a canopy.
pub(super) fn parasol(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::LINEN);
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let foot = 0.06 * a.h;
    m.drum(block(-0.19 * x..0.19 * x, 0.0..foot, -0.19 * z..0.19 * z), &stuff::STONE.surface());
    let r = 0.025_f64.min(0.05 * x).min(0.05 * z);
    m.drum(block(-r..r, foot..0.95 * a.h, -r..r), &a.second(stuff::OAK));
    let canopy = b.y(0.78 * a.h..a.h);
    m.solid_drum(canopy);
    m.mesh.lathe(canopy, &[(1.0, 0.0), (1.0, 0.12), (0.5, 0.66), (0.04, 1.0)], 8, &main);
    m
}

/// A loaf with cuts across its crust.
pub(super) fn bread(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let crust = a.main(Stuff(Finish::Ceramic, 0xb9783a));
    let round = 0.45 * a.h.min(a.w).min(a.d);
    m.rounded(b, round, &crust);
    let cuts = if a.w > a.d { b.split(0, 4, 0.0) } else { b.split(2, 4, 0.0) };
    for cut in cuts {
        let size = cut.size();
        let line = cut.inset(0.38 * size.x, 0.0, 0.38 * size.z).y(0.97 * a.h..a.h);
        m.mesh.crisp(line, &shade(&crust, 1.5));
    }
    m
}
