//! What stands in workshops and is worked at: a saw, a potter's wheel; and what clothes are ironed on.

use crate::ask::Ask;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::BuiltModel;

/// A table saw: cabinet, table of cast iron, blade with its guard, fence; with `band`, a band saw.
pub(super) fn saw(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let body = a.main(Stuff(Finish::Paint, 0x3f6f5e));
    let (iron, dark) = (stuff::STEEL.surface(), stuff::DARK_PLASTIC.surface());
    if a.says(&["band", "bandsaw"]) {
        m.board(b.share(0.1..0.9, 0.0..0.4, 0.0..0.9), &body);
        let table = b.share(0.0..1.0, 0.52..0.56, 0.0..1.0);
        m.board(b.share(0.2..0.8, 0.4..0.52, 0.1..0.8), &dark);
        m.board(table, &iron);
        m.board(b.share(0.0..0.26, 0.56..0.86, 0.2..0.7), &body);
        m.board(b.share(0.0..0.9, 0.84..1.0, 0.15..0.75), &body);
        m.board(b.share(0.68..0.78, 0.66..0.84, 0.4..0.5), &dark);
        m.mesh.crisp(b.share(0.72..0.73, 0.56..0.66, 0.43..0.47), &iron);
        m.surface = Some(0.56 * a.h);
        return m;
    }
    let (top, under) = (0.9, 0.84);
    let cabinet = b.share(0.14..0.8, 0.0..under, 0.1..0.9);
    m.board(cabinet, &body);
    m.mesh.board(cabinet.share(0.2..0.8, 0.12..0.5, 0.99..1.01), &shade(&body, 0.8));
    m.disc(2, b.share(0.4..0.5, 0.58..0.72, 0.9..0.94), &dark);
    m.board(b.share(0.0..1.0, under..top, 0.0..0.97), &iron);
    m.board(b.share(0.0..1.0, under..top - 0.02, 0.97..1.0), &dark);
    m.board(b.share(0.62..0.66, top..0.95, 0.0..1.0), &shade(&iron, 0.7));
    m.solid(b.share(0.44..0.47, top..1.0, 0.2..0.66));
    m.mesh.disc(0, b.share(0.452..0.458, top - 0.06..0.99, 0.24..0.6), &iron);
    m.mesh.board(b.share(0.44..0.47, 0.96..1.0, 0.2..0.66), &Stuff(Finish::Plastic, 0xd9a441).surface());
    m.mesh.crisp(b.share(0.453..0.457, top..0.96, 0.2..0.22), &dark);
    m.surface = Some(top * a.h);
    m
}

/// A wheel in its basin on a low frame.
pub(super) fn potters_wheel(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let frame = a.main(Stuff(Finish::Paint, 0x5b6b7a));
    let tray = stuff::GRAY_PLASTIC.surface();
    m.legs(b.share(0.02..0.98, 0.0..0.7, 0.02..0.98), 0.05, &frame);
    m.board(b.share(0.0..1.0, 0.7..0.78, 0.0..1.0), &frame);
    m.board(b.share(0.24..0.76, 0.2..0.7, 0.24..0.76), &shade(&frame, 0.7));
    for side in b.share(0.0..0.04, 0.78..0.9, 0.0..1.0).both_sides() {
        m.board(side, &tray);
    }
    m.board(b.share(0.04..0.96, 0.78..0.9, 0.0..0.05), &tray);
    m.drum(b.share(0.44..0.56, 0.78..0.86, 0.44..0.56), &stuff::STEEL.surface());
    m.drum(b.share(0.22..0.78, 0.86..0.9, 0.22..0.78), &stuff::STEEL.surface());
    let clay = Stuff(Finish::Ceramic, 0xa4684a).surface();
    m.lathe(b.share(0.36..0.64, 0.9..1.0, 0.36..0.64), &[(0.5, 0.0), (0.9, 0.4), (0.7, 0.7), (1.0, 1.0)], &clay);
    m.surface = Some(0.9 * a.h);
    m
}

/// A padded board, pointed at one end, on crossed legs.
pub(super) fn ironing_board(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let cloth = a.main(Stuff(Finish::Fabric, 0x8fa9c2));
    let steel = stuff::STEEL.surface();
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let outline = [(z, -x), (z, 0.5 * x), (0.35 * z, x), (-0.35 * z, x), (-z, 0.5 * x), (-z, -x)];
    m.extrude(1, &outline, 0.95 * a.h..a.h, &cloth);
    for foot in [b.share(0.14..0.18, 0.0..0.04, 0.1..0.9), b.share(0.74..0.78, 0.0..0.04, 0.1..0.9)] {
        m.board(foot, &steel);
    }
    let point = |px: f64, py: f64, pz: f64| scenelang_layout::Vec3::new((px - 0.5) * a.w, py * a.h, (pz - 0.5) * a.d);
    m.solid(b.share(0.44..0.52, 0.04..0.95, 0.3..0.7));
    let thin = (0.012_f64).min(0.03 * a.w.min(a.d).min(a.h));
    for pz in [0.32, 0.68] {
        m.mesh.rod(point(0.16, 0.03, pz), point(0.78, 0.95, pz), thin, &steel);
        m.mesh.rod(point(0.76, 0.03, pz), point(0.2, 0.95, pz), thin, &steel);
    }
    m
}

/// A drill press: a foot, a column, a table on it, and the head with its chuck above the table.
pub(super) fn drill_press(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let body = a.main(Stuff(Finish::Paint, 0x3f6f5e));
    let (iron, dark) = (stuff::STEEL.surface(), stuff::DARK_PLASTIC.surface());
    m.board(b.share(0.0..1.0, 0.0..0.04, 0.0..1.0), &iron);
    m.drum(b.share(0.4..0.6, 0.04..0.72, 0.08..0.28), &iron);
    m.board(b.share(0.2..0.8, 0.46..0.49, 0.3..0.9), &iron);
    m.board(b.share(0.42..0.58, 0.4..0.46, 0.2..0.6), &iron);
    m.board(b.share(0.2..0.8, 0.72..0.94, 0.04..0.86), &body);
    m.board(b.share(0.14..0.86, 0.94..1.0, 0.02..0.9), &shade(&body, 0.8));
    m.drum(b.share(0.42..0.58, 0.64..0.72, 0.5..0.7), &dark);
    m.board(b.share(0.485..0.515, 0.54..0.64, 0.585..0.615), &iron);
    m.board(b.share(0.8..0.86, 0.76..0.9, 0.5..0.54), &dark);
    m.surface = Some(0.49 * a.h);
    m
}

/// A lathe: two pedestals, a bed, the headstock with its chuck at the left, the tailstock at the right, a guard behind.
pub(super) fn lathe(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let body = a.main(Stuff(Finish::Paint, 0x4f6b82));
    let (iron, dark) = (stuff::STEEL.surface(), stuff::DARK_PLASTIC.surface());
    for side in [b.share(0.0..0.26, 0.0..0.5, 0.1..0.9), b.share(0.78..1.0, 0.0..0.5, 0.1..0.9)] {
        m.board(side, &body);
    }
    m.board(b.share(0.0..1.0, 0.5..0.58, 0.0..1.0), &shade(&body, 0.8));
    m.board(b.share(0.28..1.0, 0.58..0.64, 0.3..0.7), &iron);
    m.board(b.share(0.0..0.28, 0.58..0.94, 0.2..0.86), &body);
    m.disc(0, b.share(0.28..0.34, 0.7..0.88, 0.38..0.64), &iron);
    m.board(b.share(0.84..0.96, 0.64..0.82, 0.34..0.68), &body);
    m.disc(0, b.share(0.76..0.84, 0.75..0.81, 0.48..0.56), &iron);
    m.board(b.share(0.52..0.64, 0.64..0.74, 0.28..0.94), &iron);
    m.mesh.disc(2, b.share(0.55..0.61, 0.65..0.73, 0.94..0.97), &dark);
    m.board(b.share(0.0..1.0, 0.58..1.0, 0.0..0.04), &shade(&body, 1.15));
    let panel = b.share(0.05..0.2, 0.66..0.86, 0.86..0.88);
    m.mesh.board(panel, &dark);
    m.mesh.crisp(b.share(0.08..0.11, 0.74..0.78, 0.88..0.89), &stuff::RED.surface());
    m.surface = Some(0.64 * a.h);
    m
}
