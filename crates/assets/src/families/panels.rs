//! Flat things: on walls (facing +z, back flush at −z), and on the floor.

use super::openings::frame;
use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;
use crate::words::Dice;
use std::ops::Range;

/// A framed face; on feet where it is too deep to hang. Returns the space in front of the face, inside the frame.
fn panel(m: &mut BuiltModel, a: &Ask, face: &Surface, edge: &Surface, rim: f64) -> Block {
    let b = a.whole();
    let stands = a.d > 0.25 && a.h > 0.9;
    let rim = rim.min(0.1 * a.w).min(0.1 * a.h);
    let board = if stands {
        let t = 0.05_f64.min(0.1 * a.w);
        let foot = 0.05_f64.min(0.05 * a.h);
        for side in b.x(b.min.x..b.min.x + t).both_sides() {
            m.board(side.y(0.0..foot), edge);
            m.board(side.y(foot..a.h).z(-0.5 * t..0.5 * t), edge);
        }
        b.x(b.min.x + t..b.max.x - t).y(0.42 * a.h..a.h).z(-0.5 * t..0.5 * t)
    } else {
        b
    };
    m.solid(board);
    let deep = board.size().z;
    if rim > 0.0 {
        frame(m, board, rim, rim, rim, edge);
    }
    m.mesh.crisp(board.inset(rim, rim, 0.0).z(board.min.z..board.max.z - 0.4 * deep), face);
    board.inset(rim, rim, 0.0).z(board.max.z - 0.4 * deep..board.max.z)
}

/// Boards to write on or pin to, with a tray.
pub(super) fn board(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let dark = a.says(&["blackboard", "chalkboard", "chalk"]);
    let cork = a.says(&["cork", "corkboard", "notice", "bulletin", "pinboard", "noticeboard"]);
    let (usual, rim) = match (dark, cork) {
        (true, _) => (Stuff(Finish::Paint, 0x2f4a3e), stuff::OAK),
        (_, true) => (Stuff(Finish::Fabric, 0xc69c6d), stuff::OAK),
        _ => (Stuff(Finish::Plastic, 0xfbfbfa), stuff::STEEL),
    };
    let rim = a.second(rim);
    let face = panel(&mut m, a, &a.tinted(usual), &rim, 0.03);
    let size = face.size();
    let tray = face.inset(0.25 * size.x, 0.0, 0.0).y(face.min.y..face.min.y + 0.02 * size.y);
    if cork {
        let mut dice = a.dice();
        for cell in face.split(0, pieces(size.x, 0.35, 2, 8), 0.1) {
            let high = dice.between(0.25, 0.4) * size.y;
            let low = face.min.y + dice.between(0.15, 0.55) * size.y;
            let s = Stuff(Finish::Paper, *dice.pick(&[0xf8f4e8, 0xf6e58d, 0xbfe3d0, 0xf4c2c2])).surface();
            m.mesh.crisp(cell.y(low..low + high).z(face.min.z..face.min.z + 0.3 * size.z), &s);
        }
    } else {
        m.mesh.board(tray, &rim);
        for (k, color) in [0x2f62b0, 0xc23b33, 0x2a2b2d].into_iter().enumerate() {
            let x = -0.1 * size.x + 0.07 * size.x * k as f64;
            let t = 0.012 * size.y;
            let pen = block(x..x + 0.05 * size.x, tray.max.y..tray.max.y + t, face.min.z..face.max.z);
            m.mesh.crisp(pen, &Stuff(Finish::Plastic, if dark { 0xf4f0e6 } else { color }).surface());
        }
    }
    m
}

/// Pictures: a few fields of colour from the object's own dice; posters have no frame, maps blue and green.
pub(super) fn picture(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let mut dice = a.dice();
    let poster = a.says(&["poster", "map", "banner", "menu", "sign", "canvas"]);
    let paper = a.tinted(Stuff(Finish::Paper, 0xf3eee3));
    let edge = if poster { shade(&paper, 0.9) } else { a.second(stuff::BLACK_STEEL) };
    let face = panel(&mut m, a, &paper, &edge, if poster { 0.004 } else { 0.025 });
    let size = face.size();
    let art = face.inset(0.09 * size.x.min(size.y), 0.09 * size.x.min(size.y), 0.0);
    let layer = |k: u32| face.min.z + size.z * 0.2 * f64::from(k)..face.min.z + size.z * 0.2 * f64::from(k + 1);
    if a.says(&["map"]) {
        m.mesh.crisp(art.z(layer(0)), &Stuff(Finish::Paper, 0x9cc3d9).surface());
        let s = art.size();
        for (x, y, r, color) in [
            (-0.28, 0.62, 0.17, 0x7fa65a),
            (-0.2, 0.3, 0.11, 0xa8b56b),
            (0.02, 0.66, 0.1, 0xc9b27c),
            (0.06, 0.38, 0.13, 0xd2b068),
            (0.26, 0.66, 0.18, 0x8fae63),
            (0.36, 0.28, 0.09, 0xcf9f5f),
        ] {
            // Seen from the front, +x is on the left.
            let corner = |k: u32| {
                let (sin, cos) = (f64::from(k) / 8.0 * std::f64::consts::TAU).sin_cos();
                let r = r * dice.between(0.85, 1.0);
                (-x * s.x + r * s.x * cos, art.min.y + (y + 1.1 * r * sin) * s.y)
            };
            let land: Vec<_> = (0..8).map(corner).collect();
            m.mesh.extrude(2, &land, layer(1), &Stuff(Finish::Paper, color).surface());
        }
        return m;
    }
    if a.says(&["menu", "sign"]) {
        for (k, line) in art.split(1, 7, 0.0).enumerate() {
            let s = line.size();
            let short = if k == 6 { 0.35 * s.x } else { dice.between(0.02, 0.3) * s.x };
            let text = line.x(line.min.x + short..line.max.x).inset(0.0, 0.32 * s.y, 0.0);
            m.mesh.crisp(text.z(layer(0)), &shade(&paper, if paper.color[0] > 0.5 { 0.3 } else { 3.0 }));
        }
        return m;
    }
    const STYLES: [&str; 5] = ["landscape", "seascape", "abstract", "geometric", "botanical"];
    let style = STYLES.into_iter().find(|style| a.says(&[style]));
    if style.is_some() {
        dice = a.varied();
    }
    const SETS: [[u32; 4]; 8] = [
        [0x7a8b6f, 0xd9c9a3, 0xf2eee4, 0xb07d56],
        [0x53707f, 0xe6c9b3, 0xeef0ee, 0x9b5d4a],
        [0x2b2d34, 0xd6b26a, 0xf3f0ea, 0x8c8f94],
        [0x24415f, 0xe0a458, 0xd8e2dc, 0xb5523b],
        [0x2f5d50, 0xe9d8a6, 0xca6702, 0x94a89a],
        [0x3d405b, 0xf2cc8f, 0x81b29a, 0xe07a5f],
        [0x6d597a, 0xeaac8b, 0x355070, 0xe56b6f],
        [0x1d3557, 0xa8dadc, 0xe63946, 0xf1faee],
    ];
    let colors = *dice.pick(&SETS);
    let field = |hex: u32| Stuff(Finish::Paper, hex).surface();
    m.mesh.crisp(art.z(layer(0)), &field(colors[2]));
    let layers = [layer(1), layer(2)];
    let colors = colors.map(field);
    match style.unwrap_or_else(|| *dice.pick::<&str>(&["landscape", "landscape", "abstract", "geometric"])) {
        "landscape" | "seascape" => landscape(&mut m, art, layers, &mut dice, &colors),
        "abstract" => fields(&mut m, art, layers, &mut dice, &colors),
        "botanical" => leaves(&mut m, art, layers, &mut dice, &colors),
        _ => discs(&mut m, art, layer(1), &mut dice, &colors),
    }
    m
}

/// A stem with leaves at both sides.
fn leaves(m: &mut BuiltModel, art: Block, [near, nearer]: [Range<f64>; 2], dice: &mut Dice, colors: &[Surface; 4]) {
    let s = art.size();
    let stem = 0.012 * s.x.min(s.y);
    m.mesh.crisp(art.x(-stem..stem).y(art.min.y + 0.12 * s.y..art.min.y + 0.86 * s.y).z(near), &colors[3]);
    let pairs = 4;
    for k in 0..pairs {
        let y = art.min.y + (0.22 + 0.16 * f64::from(k)) * s.y;
        let long = (0.34 - 0.05 * f64::from(k)) * s.x.min(s.y) * dice.between(0.9, 1.1);
        for side in [-1.0, 1.0] {
            let tip = (side * long, y + 0.45 * long);
            let middle = (side * 0.55 * long, y + 0.05 * long);
            let upper = (side * 0.4 * long, y + 0.42 * long);
            let mut leaf = vec![(side * 2.0 * stem, y), middle, tip, upper];
            // Corners run counter-clockwise.
            if side < 0.0 {
                leaf.reverse();
            }
            m.mesh.extrude(2, &leaf, nearer.clone(), &colors[0]);
        }
    }
}

/// Twenty corners of a circle.
fn circle([x, y]: [f64; 2], r: f64) -> Vec<(f64, f64)> {
    let angles = (0..20).map(|k| (f64::from(k) / 20.0 * std::f64::consts::TAU).sin_cos());
    angles.map(|(v, u)| (x + r * u, y + r * v)).collect()
}

/// Land, a sun and a hill.
fn landscape(m: &mut BuiltModel, art: Block, [near, nearer]: [Range<f64>; 2], dice: &mut Dice, colors: &[Surface; 4]) {
    let s = art.size();
    let horizon = dice.between(0.3, 0.5);
    m.mesh.crisp(art.y(art.min.y..art.min.y + horizon * s.y).z(near.clone()), &colors[0]);
    let (r, x) = (dice.between(0.12, 0.2) * s.x.min(s.y), dice.between(-0.25, 0.25) * s.x);
    let y = art.min.y + dice.between(0.6, 0.78) * s.y;
    m.mesh.extrude(2, &circle([x, y], r), near, &colors[1]);
    let (peak, foot) = (dice.between(-0.2, 0.3) * s.x, dice.between(0.2, 0.35) * s.x);
    let base = art.min.y + 0.6 * horizon * s.y;
    let hill = [
        ((peak - foot).max(art.min.x), base),
        ((peak + foot).min(art.max.x), base),
        (peak.clamp(art.min.x, art.max.x), base + 0.33 * s.y),
    ];
    m.mesh.extrude(2, &hill, nearer, &colors[3]);
}

/// Three fields of colour with a narrow one across them.
fn fields(m: &mut BuiltModel, art: Block, [near, nearer]: [Range<f64>; 2], dice: &mut Dice, colors: &[Surface; 4]) {
    let s = art.size();
    let x = art.min.x + dice.between(0.3, 0.6) * s.x;
    let y = art.min.y + dice.between(0.35, 0.65) * s.y;
    m.mesh.crisp(art.x(art.min.x..x).y(y..art.max.y).z(near.clone()), &colors[0]);
    m.mesh.crisp(art.x(x..art.max.x).y(art.min.y..y).z(near.clone()), &colors[1]);
    m.mesh.crisp(art.x(art.min.x..art.min.x + 0.4 * (x - art.min.x)).y(art.min.y..y).z(near), &colors[3]);
    let band = art.min.y + dice.between(0.15, 0.8) * s.y;
    m.mesh.crisp(art.y(band..band + 0.06 * s.y).z(nearer), &colors[3]);
}

/// Three discs beside each other.
fn discs(m: &mut BuiltModel, art: Block, near: Range<f64>, dice: &mut Dice, colors: &[Surface; 4]) {
    let s = art.size();
    for (k, color) in [0, 3, 1].into_iter().enumerate() {
        let r = dice.between(0.1, 0.155) * s.x.min(s.y * 1.6);
        let x = (k as f64 - 1.0) * 0.32 * s.x;
        let free = (s.y / 2.0 - r).max(0.0);
        let y = art.min.y + s.y / 2.0 + dice.between(-0.7, 0.7) * free;
        m.mesh.extrude(2, &circle([x, y], r), near.clone(), &colors[color]);
    }
}

/// Silvered glass in a slim frame.
pub(super) fn mirror(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let edge = a.main(stuff::BRASS);
    if a.says(&["round", "oval", "circular"]) {
        disc(&mut m, a.whole(), &edge, &stuff::MIRROR.surface());
    } else {
        panel(&mut m, a, &stuff::MIRROR.surface(), &edge, 0.02);
    }
    m
}

/// A disc that looks to +z: a rim and a face set back in it.
pub(super) fn disc(m: &mut BuiltModel, b: Block, edge: &Surface, face: &Surface) {
    m.solid(b);
    m.mesh.stretch(b, |mesh| {
        mesh.place(scenelang_layout::Vec3::zeros(), [90.0, 0.0, 0.0], |mesh| {
            mesh.lathe(
                block(-1.0..1.0, 0.0..1.0, -1.0..1.0),
                &[(1.0, 0.0), (1.0, 0.9), (0.95, 1.0), (0.9, 1.0), (0.9, 0.5)],
                32,
                edge,
            );
            mesh.lathe(block(-0.9..0.9, 0.5..0.6, -0.9..0.9), &[(1.0, 0.0), (1.0, 1.0)], 32, face);
        });
    });
}

/// A screen to project on, or a sign that shines.
pub(super) fn screen(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    if a.d > 0.25 && a.h > 0.9 {
        panel(&mut m, a, &stuff::SHEET.surface(), &a.second(stuff::BLACK_STEEL), 0.03);
        return m;
    }
    m.solid(b);
    let case = a.second(stuff::WHITE);
    let head = 0.08_f64.min(0.1 * a.h);
    m.mesh.rounded(b.y(a.h - head..a.h), 0.02, 2, &case);
    let sheet = b.inset(0.03 * a.w, 0.0, 0.35 * a.d).y(0.02 * a.h..a.h - head);
    m.mesh.crisp(sheet, &stuff::BLACK_STEEL.surface());
    let picture = sheet.inset(0.03 * a.w, 0.03 * a.h, 0.0).z(sheet.max.z..sheet.max.z + 0.05 * a.d);
    m.mesh.crisp(picture, &a.tinted(Stuff(Finish::Paper, 0xf6f6f4)));
    m.mesh.rounded(b.y(0.0..0.025 * a.h).inset(0.02 * a.w, 0.0, 0.3 * a.d), 0.01, 2, &case);
    m
}

/// Rugs and mats: a border and a field, the top level; round ones by their word.
pub(super) fn rug(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Carpet, 0xa9a296));
    let main = if crate::looks::is(&main, Finish::Fabric) { a.tinted(Stuff(Finish::Carpet, 0xa9a296)) } else { main };
    let edge = a.second(Stuff(Finish::Carpet, 0));
    let edge = if edge.color == [0.0; 3] { shade(&main, 0.78) } else { edge };
    let rim = 0.08 * a.w.min(a.d);
    if a.says(&["round", "circular", "oval"]) {
        m.solid_drum(b);
        m.mesh.drum(b.y(0.0..0.9 * a.h), &edge);
        m.mesh.drum(b.inset(rim, 0.0, rim).y(0.0..a.h), &main);
    } else {
        m.solid(b);
        m.mesh.board(b.y(0.0..0.88 * a.h), &edge);
        m.mesh.board(b.inset(rim, 0.0, rim).y(0.0..0.94 * a.h), &main);
        let line = b.inset(1.6 * rim, 0.0, 1.6 * rim);
        m.mesh.board(line.y(0.0..0.97 * a.h), &shade(&main, 1.25));
        m.mesh.board(line.inset(0.18 * rim, 0.0, 0.18 * rim).y(0.0..a.h), &main);
    }
    m
}

/// A column on three feet with a desk for sheets, which leans back.
fn music_stand(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let dark = a.main(stuff::BLACK_STEEL);
    let t = 0.03_f64.min(0.08 * a.w).min(0.08 * a.d);
    for foot in [b.share(0.0..1.0, 0.0..0.03, 0.0..0.14), b.share(0.44..0.56, 0.0..0.03, 0.14..1.0)] {
        m.board(foot, &dark);
    }
    m.board(b.y(0.03 * a.h..0.74 * a.h).x(-t / 2.0..t / 2.0).z(-t / 2.0..t / 2.0), &dark);
    let (low, front, back) = (0.72 * a.h, 0.3 * a.d, -0.2 * a.d);
    let thin = 0.06 * a.d;
    let lean = [(low, front), (low, front + thin), (a.h, back + thin), (a.h, back)];
    m.extrude(0, &lean, b.min.x..b.max.x, &dark);
    m.board(b.y(low - 0.02 * a.h..low).z(front..front + 3.0 * thin), &dark);
    for sheet in b.x(b.min.x + 0.06 * a.w..-0.01 * a.w).both_sides() {
        let at = |share: f64| (low + share * (a.h - low), front + share * (back - front) + thin);
        let ((y, z), (up, away)) = (at(0.05), at(0.9));
        let page = [(y, z), (y, z + 0.2 * thin), (up, away + 0.2 * thin), (up, away)];
        m.mesh.extrude(0, &page, sheet.min.x..sheet.max.x, &stuff::PAPER.surface());
    }
    m
}

/// A stand with three legs and a picture on it: easels, tripods, flip charts; those for music have a column and a desk.
pub(super) fn easel(a: &Ask) -> BuiltModel {
    if a.says(&["music"]) {
        return music_stand(a);
    }
    let mut m = BuiltModel::default();
    let mut dice = a.dice();
    let main = a.main(stuff::OAK);
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let t = 0.04_f64.min(0.08 * a.w).min(0.1 * a.d);
    let top = block(-t / 2.0..t / 2.0, a.h - t.min(0.1 * a.h)..a.h, -t / 2.0..t / 2.0);
    for (px, pz) in [(-x, z - t), (x - t, z - t), (-t / 2.0, -z)] {
        let foot = block(px..px + t, 0.0..0.01 * a.h, pz..pz + t);
        m.taper(foot, top, &main);
    }
    let board = block(-0.9 * x..0.9 * x, 0.42 * a.h..0.94 * a.h, 0.5 * z..0.5 * z + 0.03_f64.min(0.1 * a.d));
    m.solid(board);
    m.mesh.board(board, &stuff::PAPER.surface());
    let ledge = block(-0.9 * x..0.9 * x, 0.4 * a.h..0.42 * a.h, 0.4 * z..0.75 * z);
    m.board(ledge, &main);
    let s = board.size();
    let mark = Stuff(Finish::Paper, *dice.pick(&[0xe07a5f, 0x3d405b, 0x81b29a])).surface();
    let front = board.inset(0.2 * s.x, 0.2 * s.y, 0.0).z(board.max.z..board.max.z + 0.1 * s.z);
    m.mesh.crisp(front, &mark);
    m
}
