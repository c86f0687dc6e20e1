//! Beds and what lies on them. The head is at −z; the mattress is the flat support surface.

use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, is, shade, stuff, woody};
use crate::mesh::Surface;
use crate::model::BuiltModel;

/// A canopy is higher than this (metres).
const CANOPY: f64 = 1.3;

/// A made bed inside `b`, up to `top`: mattress, blanket from the foot to two thirds, pillows.
fn bedding(m: &mut BuiltModel, b: Block, cover: &Surface) {
    let size = b.size();
    let sheet = stuff::SHEET.surface();
    m.solid(b);
    m.mesh.rounded(b.inset(0.01, 0.0, 0.005).y(b.min.y..b.max.y - 0.06 * size.y), 0.06, 3, &sheet);
    let blanket = b.z(b.min.z + 0.34 * size.z..b.max.z);
    m.mesh.rounded(blanket.y(b.min.y + 0.35 * size.y..b.max.y), 0.05, 3, cover);
    let fold = b.inset(0.002, 0.0, 0.0).z(b.min.z + 0.27 * size.z..b.min.z + 0.4 * size.z);
    m.mesh.rounded(fold.y(b.min.y + 0.33 * size.y..b.max.y - 0.001 * size.y), 0.05, 3, &shade(cover, 1.35));
}

/// Pillows at the head of `b`, lying on its top.
fn pillows(m: &mut BuiltModel, b: Block, high: f64, s: &Surface) {
    let size = b.size();
    let row = b.inset(0.05 * size.x, 0.0, 0.0).y(b.max.y..b.max.y + high);
    let row = row.z(b.min.z + 0.02 * size.z..b.min.z + 0.02 * size.z + 0.42_f64.min(0.22 * size.z));
    m.solid(row);
    for p in row.split(0, pieces(size.x, 0.75, 1, 3), 0.05) {
        m.mesh.rounded(p, 0.5 * high, 3, s);
    }
}

/// A bed: frame, headboard as high as the box, mattress at a height to sit on.
pub(super) fn bed(a: &Ask) -> BuiltModel {
    if a.says(&["bunk", "loft"]) && a.h > 1.0 {
        return bunk(a);
    }
    if a.says(&["hospital", "patient"]) {
        return hospital(a);
    }
    let mut m = BuiltModel::default();
    let whole = a.whole();
    // The bed itself stands between the posts of a canopy.
    let post = 0.06_f64.min(0.1 * a.w);
    let canopy = a.says(&["canopy", "poster"]) && a.h > CANOPY;
    let b = if canopy { whole.inset(post, 0.0, post).y(0.0..0.5 * a.h) } else { whole };
    let frame = a.main(stuff::OAK);
    // A colour that is not a wood's is meant for the cloth.
    let wooden = is(&frame, Finish::Wood) && woody(frame.color);
    let soft = [Finish::Fabric, Finish::Velvet, Finish::Leather].iter().any(|f| is(&frame, *f));
    let plain = !a.has_color() || wooden || soft;
    let cover = if plain { a.second(stuff::CLOTH) } else { a.tinted(stuff::CLOTH) };
    let frame = if plain {
        frame
    } else if a.made_of(&[Finish::Wood, Finish::Metal, Finish::Iron]) {
        a.unpainted(stuff::OAK)
    } else {
        stuff::OAK.surface()
    };
    let top = 0.5_f64.min(if a.h > 0.6 { 0.62 * a.h } else { 0.72 * a.h });
    m.surface = Some(top);
    let head = 0.06_f64.min(0.1 * a.d);
    let rail = 0.54 * top;
    let raise = 0.3 * rail;
    let board = b.z(b.min.z..b.min.z + head);
    if soft {
        m.rounded(board, 0.04, &frame);
    } else {
        m.rounded(board, 0.012, &frame);
    }
    let body = b.z(b.min.z + head..b.max.z);
    m.solid(body.y(0.0..rail));
    m.mesh.rounded(body.y(raise..rail), 0.015, 2, &frame);
    let t = 0.06_f64.min(0.1 * a.w);
    for leg in body
        .x(b.min.x + 0.03 * a.w..b.min.x + 0.03 * a.w + t)
        .z(b.max.z - 0.02 * a.d - t.min(0.2 * a.d)..b.max.z - 0.02 * a.d)
        .both_sides()
    {
        m.mesh.crisp(leg.y(0.0..raise), &frame);
    }
    let mattress = body.inset(0.03 * a.w, 0.0, 0.0).y(rail..top).z(body.min.z..b.max.z - 0.015 * a.d);
    bedding(&mut m, mattress, &cover);
    pillows(&mut m, mattress, 0.12_f64.min(0.6 * (a.h - top)), &stuff::SHEET.surface());
    if canopy {
        canopied(&mut m, whole, post, [&frame, &cover]);
    }
    m
}

/// Four posts that carry beams and a cloth.
fn canopied(m: &mut BuiltModel, b: Block, post: f64, [frame, cloth]: [&Surface; 2]) {
    let top = b.max.y;
    for corner in b.x(b.min.x..b.min.x + post).z(b.min.z..b.min.z + post).four_corners() {
        m.board(corner, frame);
    }
    let beams = b.y(top - post..top);
    let across = beams.x(b.min.x + post..b.max.x - post);
    let along = beams.z(b.min.z + post..b.max.z - post);
    m.board(across.z(b.min.z..b.min.z + post), frame);
    m.board(across.z(b.max.z - post..b.max.z), frame);
    m.board(along.x(b.min.x..b.min.x + post), frame);
    m.board(along.x(b.max.x - post..b.max.x), frame);
    m.board(across.z(along.min.z..along.max.z).y(top - 0.6 * post..top - 0.4 * post), cloth);
}

/// A bed of a ward: a high steel frame on castors, panels at head and foot, a rail along each side.
fn hospital(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let (steel, panel) = (stuff::STEEL.surface(), stuff::PLASTIC.surface());
    let cover = a.second(stuff::CLOTH);
    let thick = 0.04_f64.min(0.1 * a.d);
    let (rail, top) = (0.44 * a.h, 0.62 * a.h);
    m.surface = Some(top);
    m.rounded(b.z(b.min.z..b.min.z + thick).y(0.35 * a.h..a.h), 0.015, &panel);
    m.rounded(b.z(b.max.z - thick..b.max.z).y(0.35 * a.h..0.84 * a.h), 0.015, &panel);
    let body = b.z(b.min.z + thick..b.max.z - thick);
    m.solid(body.y(0.0..rail));
    m.mesh.rounded(body.y(0.36 * a.h..rail), 0.015, 2, &steel);
    let t = 0.07_f64.min(0.1 * a.w);
    for leg in body.x(b.min.x + 0.06 * a.w..b.min.x + 0.06 * a.w + t).z(body.min.z..body.min.z + t).four_corners() {
        m.mesh.crisp(leg.y(0.1 * a.h..0.36 * a.h), &steel);
        m.mesh.crisp(leg.y(0.0..0.1 * a.h), &stuff::RUBBER.surface());
    }
    let mattress = body.inset(0.05 * a.w, 0.0, 0.01 * a.d).y(rail..top);
    bedding(&mut m, mattress, &cover);
    pillows(&mut m, mattress, 0.12_f64.min(0.5 * (a.h - top)), &stuff::SHEET.surface());
    let side = b.x(b.min.x..b.min.x + 0.03 * a.w).z(b.min.z + 0.2 * a.d..b.min.z + 0.6 * a.d);
    for rail_at in side.both_sides() {
        m.solid(rail_at.y(rail..0.8 * a.h));
        for low in [0.66, 0.76] {
            m.mesh.crisp(rail_at.y(low * a.h..(low + 0.03) * a.h), &steel);
        }
    }
    m
}

/// Two beds over each other between four posts, with a ladder in front of the foot.
fn bunk(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let frame = a.main(stuff::OAK);
    let cover = a.second(stuff::CLOTH);
    let t = 0.06_f64.min(0.1 * a.w).min(0.1 * a.d);
    for post in b.x(b.min.x..b.min.x + t).z(b.min.z..b.min.z + t).four_corners() {
        m.board(post, &frame);
    }
    // Under a loft bed there is room.
    let loft = a.says(&["loft"]);
    m.surface = Some(if loft { 0.83 * a.h } else { 0.27 * a.h });
    for base in [0.1 * a.h, 0.66 * a.h].into_iter().skip(usize::from(loft)) {
        let bed = b.inset(0.2 * t, 0.0, 0.2 * t);
        m.board(bed.y(base..base + 0.09 * a.h), &frame);
        let mattress = b.inset(t, 0.0, t).y(base + 0.09 * a.h..base + 0.17 * a.h);
        bedding(&mut m, mattress, &cover);
        pillows(&mut m, mattress, 0.05 * a.h, &stuff::SHEET.surface());
    }
    let guard = b.y(0.9 * a.h..0.985 * a.h);
    m.solid(guard.inset(t, 0.0, 0.0).z(b.min.z + 0.3 * t..b.min.z + 0.6 * t));
    let side = |at: Block| at.x(b.min.x + 0.3 * t..b.min.x + 0.6 * t);
    // Along both sides: either may be the one at the wall. One climbs up at the foot.
    for rail in side(guard.inset(0.0, 0.0, t)).both_sides() {
        m.solid(rail);
    }
    for y in [0.9 * a.h, 0.96 * a.h] {
        let rail = b.inset(0.3 * t, 0.0, 0.0).y(y..y + 0.025 * a.h);
        m.mesh.board(rail.z(b.min.z + 0.3 * t..b.min.z + 0.6 * t), &frame);
        for rail in side(b.inset(0.0, 0.0, 0.3 * t).y(y..y + 0.025 * a.h)).both_sides() {
            m.mesh.board(rail, &frame);
        }
    }
    let steps = block(b.max.x - 0.35 * a.w..b.max.x - 0.5 * t, 0.12 * a.h..0.66 * a.h, b.max.z - 0.7 * t..b.max.z);
    m.solid(steps);
    for step in steps.split(1, 5, 0.0) {
        m.mesh.board(step.y(step.min.y..step.min.y + 0.02 * a.h), &frame);
    }
    m.mesh.board(steps.x(steps.min.x..steps.min.x + 0.4 * t), &frame);
    m
}

/// A child's bed with bars.
pub(super) fn crib(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::BIRCH);
    let t = 0.035_f64.min(0.1 * a.w).min(0.1 * a.d);
    for post in b.x(b.min.x..b.min.x + t).z(b.min.z..b.min.z + t).four_corners() {
        m.board(post, &main);
    }
    let mattress = 0.38 * a.h;
    m.surface = Some(mattress);
    m.board(b.inset(0.3 * t, 0.0, 0.3 * t).y(0.24 * a.h..0.3 * a.h), &main);
    let soft = b.inset(t, 0.0, t).y(0.3 * a.h..mattress);
    m.cushion(soft, &stuff::SHEET.surface());
    m.mesh.cushion(
        soft.share(0.42..0.97, 0.5..1.0, 0.04..0.96).y(soft.min.y..mattress + 0.02 * a.h),
        &a.second(stuff::CLOTH),
    );
    m.mesh.cushion(
        soft.share(0.06..0.28, 0.5..1.0, 0.22..0.78).y(mattress - 0.02 * a.h..mattress + 0.03 * a.h),
        &stuff::LINEN.surface(),
    );
    let rail = 0.04 * a.h;
    for long in b.z(b.min.z + 0.25 * t..b.min.z + 0.75 * t).inset(t, 0.0, 0.0).four_corners().into_iter().step_by(2) {
        m.solid(long.y(mattress..0.97 * a.h));
        m.mesh.board(long.y(0.97 * a.h - rail..0.97 * a.h), &main);
        for bar in long.y(0.3 * a.h..0.97 * a.h - rail).split(0, pieces(a.w, 0.09, 3, 24), 0.06) {
            let half = 0.2 * t;
            m.mesh.crisp(bar.x(bar.center().x - half..bar.center().x + half), &main);
        }
    }
    for short in b.x(b.min.x + 0.25 * t..b.min.x + 0.75 * t).inset(0.0, 0.0, t).both_sides() {
        m.solid(short.y(mattress..0.97 * a.h));
        m.mesh.board(short.y(0.97 * a.h - rail..0.97 * a.h), &main);
        for bar in short.y(0.3 * a.h..0.97 * a.h - rail).split(2, pieces(a.d, 0.09, 3, 24), 0.06) {
            let half = 0.2 * t;
            m.mesh.crisp(bar.z(bar.center().z - half..bar.center().z + half), &main);
        }
    }
    m
}

/// A padded couch for patients, flat, on a frame; on castors where it is a stretcher.
pub(super) fn exam_table(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Leather, 0x3f6f78));
    let frame = stuff::STEEL.surface();
    let pad = 0.08_f64.min(0.2 * a.h);
    m.rounded(b.y(a.h - pad..a.h), 0.03, &main);
    m.board(b.inset(0.04, 0.0, 0.04).y(a.h - 1.6 * pad..a.h - pad), &frame);
    let wheels = a.says(&["stretcher", "gurney", "hospital", "mobile"]);
    let low = if wheels { 0.12_f64.min(0.15 * a.h) } else { 0.0 };
    let stand = b.inset(0.06, 0.0, 0.08 * a.d);
    m.legs(stand.y(0.9 * low..a.h - 1.6 * pad), 0.05, &frame);
    m.board(stand.inset(0.02, 0.0, 0.02).y(0.2 * a.h..0.24 * a.h), &frame);
    if wheels {
        let leg = stand.x(stand.min.x..stand.min.x + 0.05_f64.min(0.3 * a.w)).z(stand.min.z..stand.min.z + low);
        for c in leg.four_corners() {
            m.solid(c.y(0.0..low));
            m.mesh.ball(c.y(0.0..low), &stuff::RUBBER.surface());
        }
    }
    m
}

/// Soft and flat: mattresses, pillows, folded blankets and towels.
pub(super) fn soft(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::LINEN);
    m.solid(b);
    if a.says(&["pillow", "cushion"]) {
        m.mesh.rounded(b, 0.45 * b.size().min(), 4, &main);
    } else {
        let layers = if a.says(&["towel", "blanket", "linen"]) { pieces(a.h, 0.03, 2, 6) } else { 1 };
        for layer in b.split(1, layers, 0.002) {
            m.mesh.rounded(layer, 0.04, 3, &main);
        }
    }
    m
}

/// A table to change a baby on: a mat with padded sides on a top with a rim, and shelves with baskets and cloths below.
pub(super) fn changing_table(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wood = a.main(stuff::BIRCH);
    let top = a.h - 0.08_f64.min(0.12 * a.h);
    let thick = 0.025_f64.min(0.04 * a.h);
    let t = 0.03_f64.min(0.06 * a.w).min(0.08 * a.d);
    for side in b.x(b.min.x..b.min.x + t).y(0.0..top).both_sides() {
        m.board(side, &wood);
    }
    m.board(b.inset(t, 0.0, 0.0).y(0.06 * a.h..top).z(b.min.z..b.min.z + 0.5 * t), &shade(&wood, 0.9));
    let inner = b.inset(t, 0.0, 0.0).z(b.min.z + 0.5 * t..b.max.z);
    m.board(b.y(top..top + thick), &wood);
    let span = top - 0.06 * a.h;
    for k in 0..3 {
        let y = 0.06 * a.h + span * f64::from(k) / 3.0;
        m.board(inner.y(y..y + thick), &wood);
        let room = inner.y(y + thick..y + span / 3.0).share(0.04..0.96, 0.0..0.72, 0.06..0.94);
        m.solid(room);
        if k == 2 {
            // Cloths and nappies in piles.
            for (pile, colour) in room.split(0, 3, 0.04).zip([0xf3f1ec, 0xcfe0e6, 0xf0d9c6]) {
                for (at, fold) in pile.split(1, 3, 0.006).enumerate() {
                    let colour = if at == 1 { 0xe9e6df } else { colour };
                    m.mesh.rounded(fold, 0.3 * fold.size().y, 1, &Stuff(Finish::Fabric, colour).surface());
                }
            }
            continue;
        }
        for basket in room.split(0, 2, 0.03) {
            m.mesh.board(basket, &Stuff(Finish::Wicker, 0xb58a5a).surface());
            m.mesh.crisp(
                basket.share(0.3..0.7, 0.6..0.75, 1.0..1.0).z(basket.max.z..basket.max.z + 0.01 * a.d),
                &shade(&wood, 0.5),
            );
        }
    }
    // The mat, which is level so that things can stand on it: two padded sides, and between them where the baby lies.
    let vinyl = a.second(Stuff(Finish::Fabric, 0x9fcbd6));
    let mat = b.inset(0.02 * a.w, 0.0, 0.02 * a.d).y(top + thick..a.h);
    let bed = mat.share(0.1..1.0, 0.0..1.0, 0.2..0.8);
    m.cushion(bed, &shade(&vinyl, 1.5));
    for side in [mat.share(0.0..1.0, 0.0..1.0, 0.0..0.2), mat.share(0.0..1.0, 0.0..1.0, 0.8..1.0)] {
        m.cushion(side, &vinyl);
    }
    m.cushion(mat.share(0.0..0.1, 0.0..1.0, 0.2..0.8), &vinyl);
    for rim in b.x(b.min.x..b.min.x + 0.012 * a.w).y(top + thick..a.h - 0.3 * (a.h - top)).both_sides() {
        m.board(rim, &wood);
    }
    m
}
