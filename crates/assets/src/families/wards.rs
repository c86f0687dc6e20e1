//! What stands beside patients: a dentist's unit, a pole for drips.

use crate::ask::Ask;
use crate::block::{Block, block};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;
use scenelang_layout::Vec3;

/// A padded slab with its outline in shares of height and depth, from one share of the width to another.
fn slab(m: &mut BuiltModel, b: Block, x: [f64; 2], outline: &[(f64, f64)], s: &Surface) {
    let size = b.size();
    let outline: Vec<(f64, f64)> = outline.iter().map(|(y, z)| (y * size.y, b.min.z + z * size.z)).collect();
    m.extrude(0, &outline, b.min.x + x[0] * size.x..b.min.x + x[1] * size.x, s);
}

/// A chair in which one lies back, with a column at its side that carries a lamp, a tray of instruments and a bowl. The
/// feet are at +z.
pub(super) fn dental_unit(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    // What it is upholstered with is not for the material of a room's furniture to say.
    let pad = a.tinted(Stuff(Finish::Leather, 0x3f8fa3));
    let (white, steel) = (stuff::WHITE.surface(), stuff::STEEL.surface());
    let body = b.x(b.min.x + 0.3 * a.w..b.max.x - 0.16 * a.w);
    m.rounded(body.share(0.12..0.88, 0.0..0.05, 0.3..0.72), 0.02, &white);
    m.board(body.share(0.3..0.7, 0.05..0.24, 0.42..0.62), &white);
    m.board(body.share(0.14..0.86, 0.24..0.28, 0.34..0.72), &white);
    // Seat, legs, back and head, from the feet to the head.
    m.cushion(body.share(0.04..0.96, 0.28..0.34, 0.38..0.66), &pad);
    slab(&mut m, body, [0.06, 0.94], &[(0.33, 0.65), (0.29, 0.64), (0.2, 0.96), (0.23, 1.0), (0.26, 0.99)], &pad);
    slab(&mut m, body, [0.04, 0.96], &[(0.34, 0.4), (0.28, 0.38), (0.47, 0.13), (0.53, 0.13), (0.54, 0.16)], &pad);
    slab(
        &mut m,
        body,
        [0.26, 0.74],
        &[(0.5, 0.12), (0.55, 0.0), (0.6, 0.0), (0.6, 0.03), (0.55, 0.14)],
        &shade(&pad, 0.85),
    );
    for arm in [body.share(-0.06..0.04, 0.4..0.43, 0.36..0.58), body.share(0.96..1.06, 0.4..0.43, 0.36..0.58)] {
        m.rounded(arm, 0.02, &stuff::DARK_PLASTIC.surface());
    }
    m.surface = Some(0.34 * a.h);
    unit_column(&mut m, b, [&white, &steel]);
    m
}

/// The column at the right of who lies there: the bowl, a pole with two arms, the lamp over the head, the tray before it.
fn unit_column(m: &mut BuiltModel, b: Block, [white, steel]: [&Surface; 2]) {
    m.rounded(b.share(0.0..0.26, 0.0..0.42, 0.3..0.52), 0.03, white);
    let bowl = b.share(0.02..0.24, 0.42..0.5, 0.36..0.5);
    m.lathe(bowl, &[(0.4, 0.0), (0.85, 0.4), (1.0, 1.0), (0.86, 1.0), (0.5, 0.4)], &stuff::CERAMIC.surface());
    m.board(b.share(0.11..0.15, 0.5..0.56, 0.33..0.36), steel);
    // The pole, and the arm that reaches over the chair.
    m.board(b.share(0.1..0.16, 0.42..0.97, 0.24..0.3), white);
    m.board(b.share(0.1..0.62, 0.97..1.0, 0.24..0.3), white);
    m.board(b.share(0.56..0.62, 0.88..0.97, 0.24..0.3), white);
    let lamp = b.share(0.42..0.76, 0.8..0.88, 0.16..0.4);
    m.lathe(lamp, &[(0.8, 0.0), (1.0, 0.4), (0.9, 0.8), (0.4, 1.0)], white);
    let lit = lamp.share(0.14..0.86, 0.0..0.1, 0.14..0.86);
    m.mesh.lathe(
        lit.y(lamp.min.y - 0.004 * b.max.y..lamp.min.y + 0.1 * lamp.size().y),
        &[(1.0, 0.0), (1.0, 1.0)],
        16,
        &stuff::WARM.surface(),
    );
    // The tray on the other side.
    m.board(b.share(0.94..1.0, 0.4..0.56, 0.46..0.52), white);
    m.board(b.share(0.7..1.0, 0.56..0.58, 0.44..0.7), steel);
    m.board(b.share(0.94..1.0, 0.0..0.4, 0.47..0.51), white);
    for k in 0..5 {
        let x = 0.74 + 0.045 * f64::from(k);
        m.mesh.crisp(b.share(x..x + 0.012, 0.58..0.59, 0.5..0.66), &stuff::DARK_PLASTIC.surface());
    }
    m.board(b.share(0.86..1.0, 0.0..0.02, 0.38..0.6), white);
}

/// A pole on five legs with castors, a hook to each side and bags of fluid on them, a tube and a pump.
pub(super) fn iv_stand(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let steel = a.main(stuff::CHROME);
    let (dark, plastic) = (stuff::DARK_PLASTIC.surface(), stuff::PLASTIC.surface());
    let foot = 0.09_f64.min(0.12 * a.h);
    m.solid_drum(b.y(0.0..foot));
    let r = 0.014_f64.min(0.1 * a.w).min(0.1 * a.d);
    let bar = 0.02_f64.min(0.1 * a.w).min(0.1 * a.d);
    // Two of the legs cross the box, so that the box is filled.
    let wheel = 0.05_f64.min(0.16 * a.w).min(0.16 * a.d).min(0.7 * foot);
    m.mesh.crisp(b.z(-bar..bar).y(0.6 * foot..foot), &steel);
    m.mesh.crisp(b.x(-bar..bar).y(0.55 * foot..0.95 * foot), &steel);
    for at in [(-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0)] {
        let (x, z) = (at.0 * (a.w / 2.0 - wheel / 2.0), at.1 * (a.d / 2.0 - wheel / 2.0));
        m.mesh.drum(block(x - wheel / 2.0..x + wheel / 2.0, 0.0..0.7 * foot, z - wheel / 2.0..z + wheel / 2.0), &dark);
    }
    m.drum(block(-r..r, foot..a.h - r, -r..r), &steel);
    m.board(b.share(0.08..0.92, 0.0..1.0, 0.45..0.55).y(a.h - r..a.h).z(-r..r), &steel);
    let deep = 0.05_f64.min(0.2 * a.d);
    for (side, color) in [(-1.0, 0xd9ecf2), (1.0, 0xf2d9a0)] {
        let (near, far) = (0.08 * a.w * side, 0.4 * a.w * side);
        let bag = b.x(near.min(far)..near.max(far)).z(-deep..deep);
        let body = bag.y(0.78 * a.h..0.96 * a.h);
        m.cushion(body, &Stuff(Finish::Plastic, color).surface());
        m.mesh.crisp(bag.share(0.42..0.58, 0.0..1.0, 0.46..0.54).y(0.96 * a.h..a.h - 0.5 * r), &steel);
        // The drip below it.
        m.board(bag.share(0.42..0.58, 0.0..1.0, 0.4..0.6).y(0.72 * a.h..0.78 * a.h), &plastic);
        let label = body.share(0.2..0.8, 0.35..0.65, 1.0..1.0).z(deep..1.08 * deep);
        m.mesh.crisp(label, &Stuff(Finish::Paper, 0x2f6fb0).surface());
    }
    let x = -0.24 * a.w;
    let path = [(x, 0.72), (x, 0.6), (0.5 * x, 0.53), (0.0, 0.55)].map(|(x, y)| Vec3::new(x, y * a.h, 0.5 * deep));
    m.mesh.tube(&path, 0.3 * r, &Stuff(Finish::Plastic, 0xbfd6de).surface());
    m.solid(block(x..0.5 * r, 0.53 * a.h..0.72 * a.h, 0.3 * deep..0.7 * deep));
    let pump = block(-0.2 * a.w..0.2 * a.w, 0.46 * a.h..0.56 * a.h, r..r + 0.24 * a.d);
    m.board(pump, &plastic);
    let face = pump.share(0.1..0.9, 0.4..0.85, 1.0..1.0).z(pump.max.z..pump.max.z + 0.01 * a.d);
    m.mesh.crisp(face, &Stuff(Finish::Screen, 0x2f7f5f).surface());
    m
}
