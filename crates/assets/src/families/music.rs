//! What people play on: a drum kit, strings on a stand, an organ.

use crate::ask::Ask;
use crate::block::{Block, block};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;
use scenelang_layout::Vec3;

/// A shell with two skins and bright hoops, upright.
fn drum(m: &mut BuiltModel, b: Block, shell: &Surface) {
    let (skin, hoop) = (stuff::SHEET.surface(), stuff::CHROME.surface());
    m.solid_drum(b);
    let mut ring = |b: Block, s: &Surface| m.mesh.lathe(b, &[(1.0, 0.0), (1.0, 1.0)], 24, s);
    ring(b.share(0.02..0.98, 0.1..0.9, 0.02..0.98), shell);
    for rim in [b.share(0.0..1.0, 0.0..0.12, 0.0..1.0), b.share(0.0..1.0, 0.86..0.98, 0.0..1.0)] {
        ring(rim, &hoop);
    }
    ring(b.share(0.04..0.96, 0.96..1.0, 0.04..0.96), &skin);
}

/// A bass drum on its side, two toms over it, a floor tom, a snare, and three cymbals. The drummer sits at -z.
pub(super) fn drum_kit(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let shell = a.main(Stuff(Finish::Paint, 0x9c2b2e));
    let (chrome, bronze) = (stuff::CHROME.surface(), stuff::BRASS.surface());
    let bass = b.share(0.33..0.67, 0.0..0.5, 0.45..0.95);
    m.disc(2, bass, &shell);
    for hoop in [bass.share(0.0..1.0, 0.0..1.0, 0.0..0.08), bass.share(0.0..1.0, 0.0..1.0, 0.92..1.0)] {
        m.mesh.disc(2, hoop.inset(-0.004 * a.w, 0.0, 0.0), &shade(&shell, 0.6));
    }
    m.mesh.disc(2, bass.share(0.06..0.94, 0.06..0.94, 0.99..1.02), &stuff::SHEET.surface());
    for tom in b.share(0.3..0.49, 0.54..0.7, 0.42..0.66).both_sides() {
        drum(&mut m, tom, &shell);
        m.mesh.crisp(tom.share(0.46..0.54, -0.3..0.05, 0.46..0.54), &chrome);
    }
    for low in [b.share(0.7..0.94, 0.2..0.5, 0.22..0.52), b.share(0.12..0.34, 0.34..0.5, 0.2..0.48)] {
        drum(&mut m, low, &shell);
        let foot = low.share(0.3..0.7, 0.0..1.0, 0.3..0.7).y(0.0..low.min.y);
        m.solid(foot);
        for (x, z) in [(0.0, 0.0), (0.88, 0.0), (0.0, 0.88), (0.88, 0.88)] {
            m.mesh.crisp(foot.share(x..x + 0.12, 0.0..1.0, z..z + 0.12), &chrome);
        }
    }
    let cymbals = [
        (b.share(0.0..0.26, 0.96..1.0, 0.5..0.8), 0.05),
        (b.share(0.72..1.0, 0.93..0.97, 0.62..1.0), 0.05),
        (b.share(0.02..0.22, 0.68..0.72, 0.0..0.24), 0.06),
    ];
    for (plate, thin) in cymbals {
        m.solid_drum(plate);
        m.mesh.lathe(plate, &[(1.0, 0.0), (1.0, 0.2), (0.3, 0.5), (0.2, 1.0)], 24, &bronze);
        let stand = plate.share(0.5 - thin..0.5 + thin, 0.0..1.0, 0.5 - thin..0.5 + thin).y(0.0..plate.min.y);
        m.board(stand, &chrome);
        let foot = plate.share(0.2..0.8, 0.0..1.0, 0.2..0.8).y(0.0..0.02 * a.h);
        m.solid(foot);
        m.mesh.crisp(foot.share(0.0..1.0, 0.0..1.0, 0.44..0.56), &chrome);
        m.mesh.crisp(foot.share(0.44..0.56, 0.0..1.0, 0.0..1.0), &chrome);
    }
    m
}

/// A guitar, a violin, a cello or a double bass on its stand: body with a waist, neck, head, strings.
pub(super) fn strings(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let bowed = a.says(&["cello", "violin", "viola", "fiddle", "double", "contrabass"]);
    let banjo = a.says(&["banjo"]);
    let body = a.main(if bowed { Stuff(Finish::Wood, 0x8a4b22) } else { Stuff(Finish::Wood, 0xc98d46) });
    let dark = stuff::DARK_PLASTIC.surface();
    // The body leans on a stand whose feet fill the floor of the box.
    let foot = b.share(0.0..1.0, 0.0..0.05, 0.0..1.0);
    m.solid(foot);
    for bar in [foot.share(0.0..1.0, 0.0..1.0, 0.84..1.0), foot.share(0.42..0.58, 0.0..1.0, 0.0..0.9)] {
        m.mesh.crisp(bar, &dark);
    }
    m.board(b.share(0.44..0.56, 0.05..0.5, 0.0..0.16), &dark);
    let lower = b.share(0.06..0.94, 0.05..0.36, 0.2..0.8);
    let upper = b.share(0.16..0.84, 0.33..0.56, 0.2..0.8);
    if banjo {
        // Its body is a drum.
        let round = b.share(0.0..1.0, 0.05..0.44, 0.2..0.8);
        m.disc(2, round, &body);
        m.mesh.disc(2, round.share(0.08..0.92, 0.08..0.92, 0.9..1.04), &stuff::SHEET.surface());
        m.board(b.share(0.44..0.56, 0.44..0.5, 0.6..0.84), &shade(&body, 0.6));
    } else {
        for part in [lower, upper] {
            m.disc(2, part, &body);
        }
        m.mesh.disc(2, b.share(0.36..0.64, 0.34..0.44, 0.79..0.83), &dark);
    }
    let face = shade(&body, 1.15);
    m.mesh.crisp(b.share(0.34..0.66, 0.16..0.19, 0.8..0.88), &dark);
    m.board(b.share(0.44..0.56, 0.5..0.92, 0.6..0.84), &shade(&body, 0.6));
    m.board(b.share(0.4..0.6, 0.91..1.0, 0.52..0.8), &face);
    for string in b.share(0.46..0.475, 0.18..0.93, 0.86..0.87).both_sides() {
        m.mesh.crisp(string, &stuff::STEEL.surface());
    }
    m
}

/// A case with pipes in towers and fields, and the console with two keyboards before it. Who plays sits at +z.
pub(super) fn organ(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wood = a.main(stuff::OAK);
    let (dark, tin) = (shade(&wood, 0.6), Stuff(Finish::Metal, 0xced0d2).surface());
    m.board(b.share(0.0..1.0, 0.0..0.36, 0.0..0.64), &wood);
    for panel in b.share(0.03..0.97, 0.06..0.31, 0.64..0.65).split(0, 5, 0.06) {
        m.mesh.crisp(panel, &shade(&wood, 1.15));
    }
    for (from, to, top) in
        [(0.0, 0.22, 1.0), (0.22, 0.39, 0.84), (0.39, 0.61, 0.95), (0.61, 0.78, 0.84), (0.78, 1.0, 1.0)]
    {
        let field = b.share(from..to, 0.36..top, 0.02..0.62);
        m.solid(field);
        m.mesh.crisp(field.share(0.02..0.98, 0.0..1.0, 0.0..0.3), &dark);
        for ledge in [field.share(0.0..1.0, 0.0..0.05, 0.0..1.0), field.share(0.0..1.0, 0.93..1.0, 0.0..1.0)] {
            m.mesh.board(ledge, &wood);
        }
        for (i, pipe) in field.share(0.04..0.96, 0.05..0.93, 0.4..0.85).split(0, 5, 0.0).enumerate() {
            // The longest is in the middle of its tower.
            let shorter = 0.1 * (i as f64 - 2.0).abs() * pipe.size().y;
            m.mesh.lathe(pipe.y(pipe.min.y..pipe.max.y - shorter), &[(0.25, 0.0), (0.95, 0.16), (0.95, 1.0)], 8, &tin);
        }
    }
    let key = 0.76_f64.min(0.34 * a.h);
    m.board(b.share(0.3..0.7, 0.0..1.0, 0.64..0.86).y(0.0..key), &wood);
    m.board(b.share(0.3..0.7, 0.0..1.0, 0.86..1.0).y(0.86 * key..key), &wood);
    let white = Stuff(Finish::Plastic, 0xf7f5ee).surface();
    m.mesh.crisp(b.share(0.33..0.67, 0.0..1.0, 0.88..0.99).y(key..1.02 * key), &white);
    m.board(b.share(0.3..0.7, 0.0..1.0, 0.64..0.78).y(key..1.3 * key), &wood);
    m.board(b.share(0.3..0.7, 0.0..1.0, 0.78..0.86).y(key..1.06 * key), &wood);
    m.mesh.crisp(b.share(0.33..0.67, 0.0..1.0, 0.78..0.86).y(1.06 * key..1.08 * key), &white);
    m.solid(b.share(0.35..0.65, 0.0..0.03, 0.86..0.99));
    for pedal in b.share(0.35..0.65, 0.01..0.03, 0.86..0.99).split(0, 7, 0.03) {
        m.mesh.crisp(pedal, &dark);
    }
    m
}

/// A round foot, a stand and a head behind a grille; one for a table is as high as it is made, and a high one has an arm.
pub(super) fn microphone(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let (dark, steel) = (a.main(stuff::DARK_PLASTIC), stuff::STEEL.surface());
    let foot = 0.03_f64.min(0.12 * a.h);
    m.drum(b.y(0.0..foot), &dark);
    let (r, thick) = (0.06_f64.min(0.2 * a.w.min(a.d)), 0.012_f64.min(0.06 * a.w.min(a.d)));
    if a.h > 1.0 && a.h > 2.0 * a.d {
        boom(&mut m, a, [foot, r, thick], [&dark, &steel]);
        return m;
    }
    let head = a.h - (3.2 * r).min(0.45 * a.h);
    m.drum(block(-thick..thick, foot..head, -thick..thick), &dark);
    let body = head + 0.45 * (a.h - head);
    m.drum(block(-0.5 * r..0.5 * r, head..body, -0.5 * r..0.5 * r), &dark);
    let grille = block(-r..r, body..a.h, -r..r);
    m.solid(grille);
    m.mesh.ball(grille, &steel);
    m
}

/// A slanted arm on a pole, with a microphone at its upper end and a weight at the lower one.
fn boom(m: &mut BuiltModel, a: &Ask, [foot, r, thick]: [f64; 3], [dark, steel]: [&Surface; 2]) {
    let (joint, x) = (0.74 * a.h, a.w / 2.0);
    m.drum(block(-1.2 * thick..1.2 * thick, foot..joint, -1.2 * thick..1.2 * thick), steel);
    m.rounded(
        block(-2.4 * thick..2.4 * thick, joint - 2.0 * thick..joint + 2.0 * thick, -2.0 * thick..2.0 * thick),
        0.01,
        dark,
    );
    // Along x, so that it is seen from the front.
    let (low, high) =
        (Vec3::new(-(0.8 * x).min(x - 2.4 * thick), 0.64 * a.h, 0.0), Vec3::new(x - 1.7 * r, a.h - 1.6 * r, 0.0));
    m.mesh.rod(low, high, thick, steel);
    let end = |p: Vec3, h: f64| block(p.x - h..p.x + h, p.y - h..p.y + h, p.z - h..p.z + h);
    let (from, to) = (end(low, thick), end(high, thick));
    let corners =
        |c: Block| (0..8).map(move |k| Vec3::from_fn(|i, _| if k >> i & 1 == 0 { c.min[i] } else { c.max[i] }));
    m.solid_hull(corners(from).chain(corners(to)).collect());
    let weight = end(low, 2.2 * thick);
    m.rounded(weight, 0.01, dark);
    // The microphone points on along the arm.
    let grille = block(x - 2.2 * r..x - 0.2 * r, a.h - 2.0 * r..a.h, -r..r);
    m.solid(grille);
    m.mesh.ball(grille, steel);
    let band = grille.share(0.02..0.98, 0.42..0.56, 0.02..0.98);
    m.mesh.drum(band, dark);
    let way = (high - low).normalize();
    let (back, front) = (high - way * 2.6 * r, high);
    m.mesh.rod(back, front, 0.62 * r, dark);
    m.solid(block(back.x - 0.6 * r..front.x, back.y - 0.6 * r..front.y + 0.6 * r, -0.6 * r..0.6 * r));
}

/// Two cups, lying, and the band between them.
pub(super) fn headphones(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::DARK_PLASTIC);
    for cup in b.share(0.0..0.24, 0.0..1.0, 0.5..1.0).both_sides() {
        m.solid(cup);
        m.mesh.cushion(cup, &main);
    }
    m.board(b.share(0.1..0.9, 0.0..0.8, 0.0..0.1), &main);
    for arm in b.share(0.1..0.18, 0.1..0.7, 0.1..0.5).both_sides() {
        m.board(arm, &main);
    }
    m
}
