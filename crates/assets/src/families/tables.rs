//! Tables, desks and counters: a level top exactly at the height of the box, room for knees where people sit.

use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;

/// A handle bar across the front of a drawer or door that faces +z; `front` is the free space it may fill.
pub(super) fn handle(m: &mut BuiltModel, front: Block, s: &Surface) {
    m.mesh.rounded(front, 0.004, 1, s);
}

/// A stack of drawer fronts that fill a face looking to +z: the casing ends `deep` behind the face.
pub(super) fn drawers(m: &mut BuiltModel, face: Block, rows: usize, deep: f64, front: &Surface, grip: &Surface) {
    for f in face.z(face.max.z - deep..face.max.z - 0.45 * deep).split(1, rows, 0.006) {
        let f = f.inset(0.004, 0.0, 0.0);
        m.mesh.board(f, front);
        let (size, c) = (f.size(), f.center());
        let half = (0.07_f64).min(0.25 * size.x);
        let thin = 0.007_f64.min(0.12 * size.y);
        handle(m, block(c.x - half..c.x + half, c.y - thin..c.y + thin, f.max.z..face.max.z), grip);
    }
}

/// Dining, side, coffee and conference tables, by words and size.
pub(super) fn table(a: &Ask) -> BuiltModel {
    let b = a.whole();
    let main = a.main(stuff::OAK);
    let legs = a.legs(&main);
    let round = a.says(&["round", "circular", "oval", "pedestal", "bistro"]);
    let large = a.w.min(a.d) > 0.8 && a.w.max(a.d) > 2.0;
    if a.says(&["ushaped", "horseshoe"]) || a.says(&["u"]) && a.says(&["shaped", "shape"]) {
        return horseshoe(a, &main, &legs);
    }
    let mut m = BuiltModel::default();
    let thick = if large { 0.05 } else { 0.035_f64 }.min(0.12 * a.h);
    let under = a.h - thick;
    if round && !(large && a.w.max(a.d) > 1.7 * a.w.min(a.d)) {
        m.drum(b.y(under..a.h), &main);
        let foot = 0.035_f64.min(0.1 * a.h);
        let (fx, fz) = (0.3 * a.w, 0.3 * a.d);
        m.lathe(block(-fx..fx, 0.0..foot, -fz..fz), &[(0.98, 0.0), (1.0, 0.3), (0.9, 0.6), (0.3, 1.0)], &legs);
        let r = (0.07 * a.w.min(a.d)).min(0.06);
        m.solid_drum(block(-r..r, foot..under, -r..r));
        let column = [(1.0, 0.0), (0.75, 0.12), (0.7, 0.5), (0.75, 0.85), (1.0, 1.0)];
        m.mesh.lathe(block(-r..r, foot..under, -r..r), &column, 24, &legs);
        return m;
    }
    if round {
        m.drum(b.y(under..a.h), &main);
    } else {
        m.rounded(b.y(under..a.h), 0.012, &main);
    }
    if large || a.says(&["conference", "meeting", "boardroom"]) {
        trestles(&mut m, b.y(0.0..under), &legs);
        return m;
    }
    let t = 0.055_f64.min(0.1 * a.w).min(0.1 * a.d);
    let stand = b.inset(0.025, 0.0, 0.025);
    m.legs(stand.y(0.0..under), t, &legs);
    // A rail under the top; the solid fills what it encloses.
    let rail = stand.inset(0.6 * t, 0.0, 0.6 * t).y(under - 0.045_f64.min(0.1 * a.h)..under);
    m.solid(rail);
    let (dark, size) = (shade(&legs, 0.94), rail.size());
    for side in rail.x(rail.min.x..rail.min.x + 0.02_f64.min(0.3 * size.x)).both_sides() {
        m.mesh.board(side, &dark);
    }
    for side in rail.z(rail.min.z..rail.min.z + 0.02_f64.min(0.3 * size.z)).four_corners().into_iter().step_by(2) {
        m.mesh.board(side, &dark);
    }
    if a.h < 0.55 && a.h > 0.3 && a.w > 0.7 && a.says(&["coffee", "living", "low"]) {
        m.board(stand.inset(0.5 * t, 0.0, 0.5 * t).y(0.28 * a.h..0.28 * a.h + 0.6 * thick), &main);
    }
    m
}

/// Tables in a U that is open at the front, each part on legs; people sit at its outer sides.
fn horseshoe(a: &Ask, main: &Surface, legs: &Surface) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let thick = 0.035_f64.min(0.12 * a.h);
    let under = a.h - thick;
    let wide = 0.6_f64.min(0.3 * a.w).min(0.45 * a.d);
    let arm = |x: std::ops::Range<f64>| b.x(x).z(b.min.z + wide..b.max.z);
    let arms = arm(b.min.x..b.min.x + wide).both_sides();
    for run in [b.z(b.min.z..b.min.z + wide), arms[0], arms[1]] {
        let axis = if run.size().x > run.size().z { 0 } else { 2 };
        let n = (run.size()[axis] / 1.8).ceil().max(1.0) as usize;
        m.solid(run.y(under..a.h));
        for table in run.split(axis, n, 0.004) {
            m.mesh.rounded(table.y(under..a.h), 0.006, 1, main);
        }
        // A panel at each end, and one where two tables meet.
        let t = 0.04_f64.min(0.1 * wide);
        for k in 0..=n {
            let at = run.min[axis] + (run.size()[axis] - t) * k as f64 / n as f64;
            let mut panel = run.inset(0.03, 0.0, 0.03).y(0.0..under);
            (panel.min[axis], panel.max[axis]) = (at, at + t);
            m.board(panel, legs);
        }
    }
    m
}

/// Two panels on feet and a beam, across the longer side: the long sides stay free for knees.
fn trestles(m: &mut BuiltModel, b: Block, s: &Surface) {
    let size = b.size();
    let long = usize::from(size.z > size.x) * 2;
    let cross = 2 - long;
    let cut = |b: Block, lo: f64, hi: f64, half: f64| {
        let mut b = b;
        (b.min[long], b.max[long]) = (lo, hi);
        (b.min[cross], b.max[cross]) = (-half, half);
        b
    };
    let (at, thick) = (0.3 * size[long], 0.07_f64.min(0.08 * size[long]));
    let foot = 0.05_f64.min(0.12 * size.y);
    for side in [-1.0, 1.0] {
        let (lo, hi) = (side * at - thick / 2.0, side * at + thick / 2.0);
        m.board(cut(b, lo, hi, 0.13 * size[cross]).y(foot..b.max.y - foot), s);
        m.board(cut(b, lo - 0.2 * thick, hi + 0.2 * thick, 0.34 * size[cross]).y(b.min.y..b.min.y + foot), s);
        m.board(cut(b, lo - 0.2 * thick, hi + 0.2 * thick, 0.38 * size[cross]).y(b.max.y - foot..b.max.y), s);
    }
    m.board(
        cut(b, -at + thick / 2.0, at - thick / 2.0, 0.015_f64.max(0.02 * size[cross])).y(0.72 * size.y..0.84 * size.y),
        s,
    );
}

/// A desk along the back of its box with a return at the right; its user sits in the corner between them.
fn corner_desk(a: &Ask, main: &Surface, thick: f64) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let legs = a.legs(main);
    let under = a.h - thick;
    let (long, back) = (0.65_f64.min(0.5 * a.d), b.min.z);
    let wing = b.x(b.max.x - 0.55_f64.min(0.4 * a.w)..b.max.x).z(back + long..b.max.z);
    m.rounded(b.y(under..a.h).z(back..back + long), 0.008, main);
    m.rounded(wing.y(under..a.h), 0.008, main);
    let side = 0.035_f64.min(0.08 * a.w).min(0.2 * long);
    m.board(b.x(b.min.x..b.min.x + side).y(0.0..under).z(back + 0.01 * a.d..back + 0.97 * long), &legs);
    m.board(b.y(0.35 * a.h..under).x(b.min.x + side..b.max.x).z(back..back + 0.5 * side), main);
    // Drawers under the end of the return.
    let chest =
        wing.y(0.0..under).z(wing.max.z - 0.5_f64.min(0.6 * wing.size().z)..wing.max.z).inset(0.02 * a.w, 0.0, 0.0);
    m.solid(chest);
    let deep = 0.05 * chest.size().z;
    m.mesh.board(chest.z(chest.min.z..chest.max.z - deep), main);
    drawers(&mut m, chest, 3, deep, &shade(main, 1.08), &stuff::BLACK_STEEL.surface());
    m.board(wing.x(b.max.x - side..b.max.x).y(0.0..under).z(back + 0.1 * long..back + long), &legs);
    m
}

/// A desk; its user sits at +z. Wide ones have drawers on the right; `standing` ones two lifting columns, school desks four
/// legs.
pub(super) fn desk(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::OAK);
    let thick = 0.03_f64.min(0.1 * a.h);
    let under = a.h - thick;
    let bent = a.says(&["corner", "lshaped"]) || a.says(&["l"]) && a.says(&["shaped", "shape"]);
    if bent && a.d > 0.55 * a.w {
        return corner_desk(a, &main, thick);
    }
    m.rounded(b.y(under..a.h), 0.008, &main);
    if a.says(&["standing", "adjustable", "electric", "sit", "motorized"]) {
        let steel = a.second(stuff::GRAY);
        let t = 0.08_f64.min(0.1 * a.w);
        for side in b.x(b.min.x + 0.1 * a.w..b.min.x + 0.1 * a.w + t).both_sides() {
            m.rounded(side.y(0.0..0.03_f64.min(0.1 * a.h)).inset(0.0, 0.0, 0.05 * a.d), 0.01, &steel);
            let column = side.inset(0.1 * t, 0.0, 0.0).z(-0.07 * a.d..0.03 * a.d);
            m.solid(column.y(0.03_f64.min(0.1 * a.h)..under));
            m.mesh.board(column.y(0.03_f64.min(0.1 * a.h)..0.55 * under), &steel);
            m.mesh.board(column.inset(0.01, 0.0, 0.01).y(0.55 * under..under), &shade(&steel, 0.85));
        }
        m.board(
            b.inset(0.1 * a.w + t, 0.0, 0.0).y(under - 0.05_f64.min(0.1 * a.h)..under).z(-0.07 * a.d..0.03 * a.d),
            &steel,
        );
        return m;
    }
    let legs = if a.says(&["student", "school", "pupil"]) { a.second(stuff::STEEL) } else { a.legs(&main) };
    if a.w < 1.0 || a.says(&["student", "school", "pupil", "writing"]) {
        m.legs(b.inset(0.02, 0.0, 0.02).y(0.0..under), 0.04, &legs);
        m.board(
            b.inset(0.07 * a.w, 0.0, 0.0).y(under - 0.16 * a.h..under).z(b.min.z + 0.02..b.min.z + 0.02 + 0.015),
            &main,
        );
        return m;
    }
    let side = 0.035_f64.min(0.1 * a.w);
    m.board(b.x(b.min.x + 0.01..b.min.x + 0.01 + side).y(0.0..under).inset(0.0, 0.0, 0.03 * a.d), &main);
    let right = b.max.x - 0.01;
    let chest = b.x(right - 0.4_f64.min(0.3 * a.w)..right).y(0.0..under).inset(0.0, 0.0, 0.03 * a.d);
    let deep = 0.04_f64.min(0.1 * a.d);
    let wall = 0.018_f64.min(0.1 * chest.size().x).min(0.1 * a.h).min(0.1 * a.d);
    m.shell(chest.z(chest.min.z..chest.max.z - deep), wall, 0.0, &main);
    let front = shade(&main, 1.12);
    let fronts = chest.y(0.03..under).inset(0.0, 0.002, 0.0);
    drawers(&mut m, fronts, 3, deep, &front, &stuff::BLACK_STEEL.surface());
    for f in fronts.z(chest.max.z - deep..chest.max.z).inset(0.004, 0.0, 0.0).split(1, 3, 0.006) {
        m.drawer(f, chest.min.z + wall, 3, &front);
    }
    let back = b
        .x(b.min.x + 0.01 + side..chest.min.x)
        .y(0.45 * under..under)
        .z(b.min.z + 0.06 * a.d..b.min.z + 0.06 * a.d + 0.018_f64.min(0.1 * a.d));
    m.board(back, &main);
    m
}

/// Counters of every trade: a body with a top that overhangs to the front, where the customer stands.
pub(super) fn counter(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::WHITE);
    let thick = 0.04_f64.min(0.15 * a.h);
    let under = a.h - thick;
    let top = a.second(if a.made_of(&[Finish::Metal, Finish::Stone]) {
        stuff::STEEL
    } else if a.says(&["lab", "laboratory", "chemistry"]) {
        Stuff(Finish::Stone, 0x5a6066)
    } else {
        stuff::OAK
    });
    m.rounded(b.y(under..a.h), 0.008, &top);
    let plinth = 0.09_f64.min(0.15 * a.h);
    // Who sits at an island has room for the knees; its doors are on the side of the cook.
    let island = a.says(&["island"]);
    let overhang = match island {
        true => 0.28,
        false if a.says(&["bar", "breakfast"]) => 0.22,
        false => 0.04,
    } * a.d;
    let body = b.inset(0.01, 0.0, 0.01).y(plinth..under).z(b.min.z + 0.01 * a.d..b.max.z - overhang);
    m.solid(body.y(0.0..under));
    m.mesh.board(body.inset(0.03, 0.0, 0.03).y(0.0..plinth), &stuff::BLACK_STEEL.surface());
    let skin = 0.022_f64.min(0.2 * a.d);
    let behind = if island { skin } else { 0.0 };
    m.mesh.board(body.z(body.min.z + behind..body.max.z - skin), &main);
    let face = body.z(body.max.z - skin..body.max.z);
    if island {
        for panel in face.split(0, pieces(a.w, 0.6, 1, 10), 0.006) {
            m.mesh.board(panel, &main);
        }
        for door in body.z(body.min.z..body.min.z + skin).split(0, pieces(a.w, 0.5, 1, 12), 0.006) {
            m.mesh.board(door.z(door.min.z + 0.4 * skin..door.max.z), &shade(&main, 1.1));
            let grip = door.share(0.3..0.7, 0.9..0.93, 0.0..0.4);
            m.mesh.crisp(grip, &stuff::STEEL.surface());
        }
    } else if a.says(&["kitchen", "island", "vanity", "base", "lab", "laboratory", "pantry", "worktop"]) {
        let doors = pieces(a.w, 0.5, 1, 12);
        for door in face.split(0, doors, 0.006) {
            m.mesh.board(door.inset(0.002, 0.002, 0.0).z(face.min.z..face.max.z - 0.4 * skin), &shade(&main, 1.1));
            let size = door.size();
            let grip = door.inset(0.3 * size.x, 0.0, 0.0).y(door.max.y - 0.09 * size.y..door.max.y - 0.07 * size.y);
            handle(&mut m, grip.z(face.max.z - 0.4 * skin..face.max.z), &stuff::STEEL.surface());
        }
    } else {
        let slats = pieces(a.w, 0.09, 2, 60);
        for slat in face.split(0, slats, 0.02) {
            m.mesh.crisp(slat, &main);
        }
    }
    if a.says(&["bar", "pub"]) && a.h > 0.6 {
        let y = 0.2 * a.h;
        let z = (body.max.z + 0.6 * overhang).min(b.max.z - 0.02 * a.d);
        let r = 0.015_f64.min(0.2 * overhang);
        let rail = block(body.min.x..body.max.x, y - r..y + r, z - r..z + r);
        m.solid(rail);
        m.mesh.rounded(rail, r, 2, &stuff::BRASS.surface());
    }
    m
}

/// A thick top on four strong legs with a shelf below; laboratories have cupboards instead.
pub(super) fn workbench(a: &Ask) -> BuiltModel {
    if a.says(&["lab", "laboratory", "chemistry", "demonstration"]) {
        return counter(a);
    }
    let mut m = BuiltModel::default();
    let b = a.whole();
    let top = a.main(stuff::BIRCH);
    let frame = a.second(stuff::BLACK_STEEL);
    let thick = 0.05_f64.min(0.15 * a.h);
    let under = a.h - thick;
    m.rounded(b.y(under..a.h), 0.006, &top);
    let t = 0.06_f64.min(0.12 * a.w).min(0.12 * a.d);
    let stand = b.inset(0.03, 0.0, 0.03).y(0.0..under);
    for leg in stand.x(stand.min.x..stand.min.x + t).z(stand.min.z..stand.min.z + t).four_corners() {
        m.board(leg, &frame);
    }
    m.board(stand.inset(0.2 * t, 0.0, 0.2 * t).y(0.18 * a.h..0.18 * a.h + 0.6 * thick), &top);
    let rail = stand.inset(0.2 * t, 0.0, 0.2 * t).y(under - 1.2 * thick..under);
    m.board(rail, &frame);
    if a.w > 1.1 && a.h > 0.6 {
        let chest = stand
            .x(stand.max.x - t - 0.4 * a.w..stand.max.x - t)
            .y(under - 0.32 * a.h..under - 1.2 * thick)
            .inset(0.0, 0.0, 0.3 * t);
        m.solid(chest);
        let deep = 0.03_f64.min(0.1 * a.d);
        m.mesh.board(chest.z(chest.min.z..chest.max.z - deep), &frame);
        drawers(&mut m, chest.inset(0.003, 0.003, 0.0), 2, deep, &stuff::RED.surface(), &stuff::STEEL.surface());
    }
    m
}

/// A slanted board on a column: the audience is at +z, the speaker behind. A high one has a microphone, that of a host a book
/// and a lamp.
pub(super) fn lectern(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::WALNUT);
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let equipped = a.h > 0.9 && !a.says(&["pulpit", "witness"]);
    let top = if equipped { 0.86 * a.h } else { a.h };
    if equipped {
        m.surface = Some(top);
    }
    let foot = 0.04_f64.min(0.1 * a.h);
    let low = top - 0.16_f64.min(0.3 * a.h);
    m.rounded(b.y(0.0..foot).inset(0.06 * a.w, 0.0, 0.03 * a.d), 0.01, &main);
    m.board(block(-0.32 * a.w..0.32 * a.w, foot..low, -0.28 * a.d..0.3 * a.d), &main);
    m.mesh.board(
        block(-0.26 * a.w..0.26 * a.w, foot + 0.06 * a.h..low - 0.06 * a.h, 0.3 * a.d..0.315 * a.d),
        &shade(&main, 1.2),
    );
    let thick = 0.03_f64.min(0.08 * a.h);
    m.extrude(0, &[(low, -z), (low, z), (top, z), (low + thick, -z)], -x..x, &shade(&main, 1.1));
    if equipped {
        fitted(&mut m, b.y(top..a.h), a.says(&["host", "hostess", "maitre"]));
    }
    m
}

/// What stands on the upper edge of a lectern: a microphone on a neck, or the lamp of a host and a book that leans there.
fn fitted(m: &mut BuiltModel, b: Block, host: bool) {
    let dark = stuff::BLACK_STEEL.surface();
    if host {
        let brass = stuff::BRASS.surface();
        m.board(b.share(0.16..0.2, 0.0..0.7, 0.84..0.9), &brass);
        m.board(b.share(0.06..0.3, 0.7..1.0, 0.74..0.98), &Stuff(Finish::Glow, 0xf6d79a).surface());
        m.board(b.share(0.44..0.9, 0.0..0.62, 0.84..0.92), &Stuff(Finish::Leather, 0x6f1f2a).surface());
        m.mesh.crisp(b.share(0.5..0.84, 0.2..0.4, 0.92..0.93), &brass);
        return;
    }
    m.board(b.share(0.47..0.53, 0.0..0.6, 0.88..0.94), &dark);
    m.board(b.share(0.44..0.56, 0.6..1.0, 0.8..0.94), &stuff::DARK_PLASTIC.surface());
}

/// A low platform with an edge.
pub(super) fn platform(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::OAK);
    let floor = 0.03_f64.min(0.3 * a.h);
    m.solid(b);
    m.mesh.board(b.inset(0.02, 0.0, 0.02).y(0.0..a.h - floor), &stuff::BLACK_STEEL.surface());
    let planks = pieces(a.d, 0.2, 1, 30);
    for p in b.y(a.h - floor..a.h).split(2, planks, 0.004) {
        m.mesh.crisp(p, &main);
    }
    m
}

/// Green cloth between wooden rails, on thick legs; ping-pong tables have a net.
pub(super) fn game_table(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    if a.says(&["pong", "tennis"]) {
        let main = a.tinted(Stuff(Finish::Paint, 0x2b5d8c));
        let play = a.h - 0.15_f64.min(0.2 * a.h);
        let thick = 0.03_f64.min(0.1 * a.h);
        m.surface = Some(play);
        m.board(b.y(play - thick..play), &main);
        let net = block(-0.003..0.003, play..a.h, b.min.z..b.max.z);
        m.board(net, &stuff::WHITE.surface());
        m.legs(b.y(0.0..play - thick).inset(0.12 * a.w, 0.0, 0.05 * a.d), 0.06, &stuff::BLACK_STEEL.surface());
        return m;
    }
    let wood = a.second(stuff::WALNUT);
    let cloth = a.tinted(Stuff(Finish::Carpet, 0x2c7a4b));
    let rim = 0.12_f64.min(0.12 * a.w.min(a.d));
    let box_low = a.h - 0.22 * a.h;
    m.solid(b.y(box_low..a.h));
    m.mesh.board(b.inset(0.03, 0.0, 0.03).y(box_low..a.h - 0.03 * a.h), &shade(&wood, 0.8));
    m.mesh.board(b.inset(rim, 0.0, rim).y(a.h - 0.06 * a.h..a.h - 0.02 * a.h), &cloth);
    for long in b.y(a.h - 0.09 * a.h..a.h).z(b.min.z..b.min.z + rim).four_corners().into_iter().step_by(2) {
        m.mesh.rounded(long, 0.015, 2, &wood);
    }
    for short in b.y(a.h - 0.09 * a.h..a.h).x(b.min.x..b.min.x + rim).inset(0.0, 0.0, rim).both_sides() {
        m.mesh.rounded(short, 0.015, 2, &wood);
    }
    if a.says(&["pool", "billiard", "snooker"]) {
        // Pockets in the corners and in the middle of the long sides, a little above the cloth.
        let r = 0.065_f64.min(0.1 * a.w.min(a.d));
        let field = b.inset(rim, 0.0, rim);
        let long = usize::from(a.d > a.w) * 2;
        let ends = |k: usize| [field.min[k] + 0.8 * r, field.max[k] - 0.8 * r];
        let middle = (field.min[long] + field.max[long]) / 2.0;
        let along = ends(long).into_iter().chain([middle]);
        for (u, v) in along.flat_map(|u| ends(2 - long).map(|v| (u, v))) {
            let (x, z) = if long == 0 { (u, v) } else { (v, u) };
            let pocket = block(x - r..x + r, a.h - 0.03 * a.h..a.h - 0.015 * a.h, z - r..z + r);
            m.mesh.drum(pocket, &stuff::RUBBER.surface());
        }
    }
    m.legs(b.inset(0.1, 0.0, 0.1).y(0.0..box_low), 0.14, &wood);
    m
}
