//! What cares for people and their clothes: chairs of dentists, tattooists and beauticians, loungers in the sun,
//! monitors of patients, racks for washing.

use crate::ask::Ask;
use crate::block::{Block, block};
use crate::looks::{Finish, Stuff, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;

/// A padded seat on a column, with a rest for the legs, a back and a head rest. The feet are at +z.
pub(super) fn treatment_chair(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let pad = a.tinted(Stuff(Finish::Leather, 0x3f6f78));
    let (steel, dark) = (stuff::STEEL.surface(), stuff::DARK_PLASTIC.surface());
    m.board(b.share(0.2..0.8, 0.0..0.06, 0.22..0.78), &dark);
    m.board(b.share(0.38..0.62, 0.06..0.38, 0.4..0.6), &steel);
    m.cushion(b.share(0.12..0.88, 0.38..0.5, 0.26..0.7), &pad);
    m.cushion(b.share(0.16..0.84, 0.32..0.44, 0.68..1.0), &pad);
    // The back rises from the seat towards the head.
    for (i, (from, to)) in [(0.2, 0.34), (0.12, 0.26), (0.05, 0.19)].into_iter().enumerate() {
        let low = 0.46 + 0.14 * i as f64;
        m.cushion(b.share(0.14..0.86, low..low + 0.17, from..to), &pad);
    }
    m.cushion(b.share(0.3..0.7, 0.86..1.0, 0.0..0.13), &pad);
    for arm in b.share(0.0..0.14, 0.58..0.63, 0.3..0.62).both_sides() {
        m.board(arm, &dark);
        m.board(arm.share(0.0..1.0, 0.0..1.0, 0.1..0.25).y(0.42 * a.h..arm.min.y), &steel);
    }
    m.surface = Some(0.5 * a.h);
    m
}

/// A low frame with slats and a raised back at -z.
pub(super) fn lounger(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wood = a.main(stuff::OAK);
    let cloth = a.second(stuff::LINEN);
    let flat = 0.42;
    for side in b.share(0.0..0.1, flat - 0.1..flat, 0.0..1.0).both_sides() {
        m.board(side, &wood);
    }
    for (x, z) in [(0.0, 0.06), (0.9, 0.06), (0.0, 0.86), (0.9, 0.86)] {
        m.board(b.share(x..x + 0.1, 0.0..flat - 0.1, z..z + 0.06), &wood);
    }
    m.cushion(b.share(0.1..0.9, flat - 0.04..flat + 0.12, 0.34..1.0), &cloth);
    for i in 0..4 {
        let (low, far) = (flat + 0.11 * f64::from(i), 0.36 - 0.1 * f64::from(i));
        m.cushion(b.share(0.1..0.9, low..low + 0.25, far - 0.06..far), &cloth);
    }
    m.surface = Some((flat + 0.12) * a.h);
    m
}

/// A screen on a pole that stands beside a bed.
pub(super) fn patient_monitor(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let body = a.main(stuff::PLASTIC);
    let foot = 0.06_f64.min(0.1 * a.h);
    let lower = if a.h > 0.6 { 0.74 * a.h } else { foot };
    m.rounded(b.y(0.0..foot), 0.02, &stuff::GRAY_PLASTIC.surface());
    if lower > foot {
        let r = 0.018_f64.min(0.1 * a.w).min(0.1 * a.d);
        m.drum(block(-r..r, foot..lower, -r..r), &stuff::STEEL.surface());
        // What is plugged in is kept in a basket.
        m.board(b.share(0.2..0.8, 0.3..0.4, 0.2..0.7), &stuff::STEEL.surface());
    }
    let skin = 0.02 * a.d;
    let head = b.y(lower..a.h).z(-0.2 * a.d..0.3 * a.d);
    m.board(head.z(head.min.z..head.max.z - skin), &body);
    let face = head.share(0.06..0.94, 0.1..0.94, 0.0..1.0).z(head.max.z - skin..head.max.z);
    m.mesh.board(face, &stuff::SCREEN.surface());
    for (row, color) in [(0.7, stuff::GREEN_LIGHT), (0.42, stuff::RED), (0.14, stuff::WARM)] {
        wave(&mut m, face.share(0.06..0.68, row..row + 0.2, 0.0..1.0), 0.3 * skin, &color.surface());
        let number = face.share(0.76..0.94, row + 0.02..row + 0.16, 1.0..1.0);
        m.mesh.crisp(number.z(face.max.z..face.max.z + 0.3 * skin), &color.surface());
    }
    m
}

/// A pulse that runs over a screen: level, with beats.
fn wave(m: &mut BuiltModel, b: Block, thick: f64, s: &Surface) {
    const BEAT: [[f64; 2]; 7] = [[0.2, 0.3], [0.2, 0.3], [0.2, 0.45], [0.3, 1.0], [0.0, 0.9], [0.0, 0.3], [0.2, 0.3]];
    for (k, piece) in b.split(0, 2 * BEAT.len(), 0.0).enumerate() {
        let [from, to] = BEAT[k % BEAT.len()];
        m.mesh.crisp(piece.share(0.0..1.0, from..to, 1.0..1.0).z(b.max.z..b.max.z + thick), s);
    }
}

/// Two frames with bars between them, cloths over some of the bars.
pub(super) fn drying_rack(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::STEEL);
    let cloths = [stuff::LINEN.surface(), stuff::CLOTH.surface(), a.second(stuff::SHEET)];
    let t = 0.02_f64.min(0.05 * a.w).min(0.05 * a.d);
    for side in b.x(b.min.x..b.min.x + t).both_sides() {
        m.board(side.z(b.min.z..b.min.z + t).y(0.0..a.h - t), &main);
        m.board(side.z(b.max.z - t..b.max.z).y(0.0..a.h - t), &main);
        m.board(side.y(a.h - t..a.h), &main);
    }
    let bars = 7;
    for i in 0..bars {
        let z = b.min.z + t / 2.0 + (a.d - t) * f64::from(i) / f64::from(bars - 1);
        let bar = b.inset(t, 0.0, 0.0).y(a.h - 0.85 * t..a.h - 0.15 * t).z(z - 0.35 * t..z + 0.35 * t);
        m.board(bar, &main);
        if i % 2 == 1 {
            let wide = 0.3 + 0.06 * f64::from(i % 3);
            let from = if i % 4 == 1 { 0.06 } else { 0.9 - wide };
            let cloth = b.share(from..from + wide, 0.0..1.0, 0.0..1.0).y(0.45 * a.h..a.h - t);
            m.board(cloth.z(z - 0.3 * t..z + 0.3 * t), &cloths[(i / 2) as usize % cloths.len()]);
        }
    }
    m
}
