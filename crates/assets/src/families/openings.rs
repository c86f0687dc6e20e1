//! What sits in walls or divides rooms: doors, windows, curtains, blinds, partitions, stairs, pillars.

use super::moving::{Hung, MOST};
use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, is, shade, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;
use scenelang_layout::Vec3;

/// A fence that is wider and deeper than this goes around something (metres).
const DEEP: f64 = 1.0;

/// Four strips along the edges of a face (normal z), `side` wide left and right, `top` above, `bottom` below.
pub(super) fn frame(m: &mut BuiltModel, b: Block, side: f64, top: f64, bottom: f64, s: &Surface) {
    for strip in [b.x(b.min.x..b.min.x + side), b.x(b.max.x - side..b.max.x)] {
        m.mesh.board(strip, s);
    }
    let inner = b.x(b.min.x + side..b.max.x - side);
    m.mesh.board(inner.y(b.max.y - top..b.max.y), s);
    if bottom > 0.0 {
        m.mesh.board(inner.y(b.min.y..b.min.y + bottom), s);
    }
}

/// A closed door in its frame: one leaf or two, panelled or glazed, a handle on both faces. It opens to its front, to the
/// other side if it "opens outward"; a single leaf has its hinges on its own left, or as features say ("hinged right").
pub(super) fn door(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let exit = a.says(&["exit", "emergency", "fire"]);
    let main = a.main(if exit { Stuff(Finish::Paint, 0x7d8f97) } else { stuff::WHITE });
    let casing = if a.has_color() && is(&main, Finish::Paint) { stuff::WHITE.surface() } else { shade(&main, 0.9) };
    let side = 0.07_f64.min(0.1 * a.w);
    frame(&mut m, b, side, side.min(0.1 * a.h), 0.0, &casing);
    let glazed = is(&main, Finish::Glass) || a.says(&["glass", "glazed", "sliding", "patio", "balcony", "french"]);
    let hole = b.x(b.min.x + side..b.max.x - side).y(0.004_f64.min(0.01 * a.h)..a.h - side.min(0.1 * a.h));
    let leaves = if a.w > 1.25 || a.says(&["double"]) { 2 } else { 1 };
    let half = 0.29 * a.d;
    for jamb in b.x(b.min.x..b.min.x + side).both_sides() {
        m.solid(jamb);
    }
    m.solid(b.inset(side, 0.0, 0.0).y(hole.max.y..a.h));
    let turned = leaves == 1 && a.says(&["right"]);
    let sliding = a.says(&["sliding", "automatic", "revolving", "elevator", "lift"]);
    for (i, leaf) in hole.split(0, leaves, 0.006).enumerate() {
        let leaf = leaf.z(-half..half);
        let size = leaf.size();
        if sliding {
            m.solid(leaf);
        } else {
            let hung = if i == 1 || turned { Hung::Right } else { Hung::Left };
            m.swing(leaf, hung, a.says(&["outward", "outwards"]));
        }
        if glazed {
            let metal = if is(&main, Finish::Glass) { stuff::BLACK_STEEL.surface() } else { main.clone() };
            let bar = 0.09_f64.min(0.12 * size.x);
            frame(&mut m, leaf, bar, bar.min(0.1 * size.y), 0.12_f64.min(0.1 * size.y), &metal);
            let pane = leaf.inset(bar, bar.min(0.1 * size.y), 0.38 * size.z);
            m.mesh.crisp(pane, &stuff::GLASS.surface());
        } else {
            m.mesh.board(leaf, &main);
            // Raised fields on both faces.
            let fields = [(0.07, 0.42), (0.5, 0.93)];
            let count = if exit || a.says(&["flush", "modern", "plain", "steel"]) { 0 } else { 2 };
            for (lo, hi) in fields.into_iter().take(count) {
                let field = leaf.inset(0.14 * size.x, 0.0, -0.035 * a.d);
                m.mesh.rounded(
                    field.y(leaf.min.y + lo * size.y..leaf.min.y + hi * size.y),
                    0.02,
                    1,
                    &shade(&main, 1.1),
                );
            }
        }
        // The handle is away from the hinges: where leaves meet.
        let inward = if i == 1 || turned { -1.0 } else { 1.0 };
        let edge = if i == 1 || turned { leaf.min.x } else { leaf.max.x };
        let y = leaf.min.y + (1.03 / size.y).min(0.5) * size.y;
        let metal = stuff::STEEL.surface();
        let long = 0.13_f64.min(0.18 * size.x);
        let thin = 0.012_f64.min(0.015 * size.y).min(0.04 * size.x);
        for face in [1.0, -1.0] {
            let (near, far) = (face * half, face * a.d / 2.0);
            let out = |b: Block, f: f64, g: f64| b.z(f.min(g)..f.max(g));
            let x = edge - inward * 0.06_f64.min(0.1 * size.x);
            let rose = block(x - 2.0 * thin..x + 2.0 * thin, y - 4.0 * thin..y + 2.0 * thin, 0.0..1.0);
            m.mesh.board(out(rose, near, near + 0.25 * (far - near)), &metal);
            let (from, to) =
                if exit { (edge, edge - inward * 0.9 * size.x) } else { (x + inward * 0.1 * long, x - inward * long) };
            let lever = block(from.min(to)..from.max(to), y - thin..y + thin, 0.0..1.0);
            m.mesh.rounded(out(lever, near + 0.5 * (far - near), far), 0.008, 1, if exit { &casing } else { &metal });
            let neck = block(x - thin..x + thin, y - thin..y + thin, 0.0..1.0);
            m.mesh.crisp(out(neck, near, near + 0.6 * (far - near)), &metal);
        }
    }
    m
}

/// Glass in a frame with bars, and a sill. Its casements open to its front, unless it is one that slides or does not open;
/// nobody demands that they do.
pub(super) fn window(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::WHITE);
    let main = if is(&main, Finish::Glass) { stuff::BLACK_STEEL.surface() } else { main };
    let side = 0.06_f64.min(0.1 * a.w).min(0.1 * a.h);
    let sill = 0.035_f64.min(0.06 * a.h);
    m.mesh.board(b.y(0.0..sill), &main);
    let hole = b.y(sill..a.h);
    let casing = hole.z(b.min.z..b.max.z - 0.2 * a.d);
    frame(&mut m, casing, side, side, side, &main);
    let inner = hole.inset(side, side, 0.0).z(-0.3 * a.d..0.15 * a.d);
    let columns = pieces(a.w, 0.75, 1, 8);
    let rows = if a.h > 1.9 { 2 } else { 1 };
    let fixed =
        a.says(&["sliding", "sash", "fixed", "skylight", "shop", "display", "curtain"]) || columns * rows > MOST;
    if fixed {
        m.solid(b);
    } else {
        m.solid(b.y(0.0..sill));
        for jamb in casing.x(b.min.x..b.min.x + side).both_sides() {
            m.solid(jamb);
        }
        let rails = casing.inset(side, 0.0, 0.0);
        m.solid(rails.y(sill..sill + side));
        m.solid(rails.y(a.h - side..a.h));
    }
    for (i, column) in inner.split(0, columns, 0.004).enumerate() {
        for pane in column.split(1, rows, 0.004) {
            if !fixed {
                // No two casements hang on one mullion: open, they would be in each other.
                m.casement(pane, if 2 * i >= columns { Hung::Right } else { Hung::Left });
            }
            let bar = 0.045_f64.min(0.12 * pane.size().x).min(0.12 * pane.size().y);
            frame(&mut m, pane, bar, bar, bar, &main);
            m.mesh.crisp(pane.inset(bar, bar, 0.4 * pane.size().z), &stuff::GLASS.surface());
        }
    }
    m
}

/// Two drawn curtains on a rail, in folds.
pub(super) fn curtain(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    m.solid(b);
    let cloth = a.main(Stuff(Finish::Fabric, 0xcfc6b4));
    let rail = 0.03_f64.min(0.05 * a.h);
    let metal = a.second(stuff::BRASS);
    m.mesh.rounded(b.y(a.h - rail..a.h).inset(0.0, 0.0, 0.25 * a.d), 0.4 * rail, 2, &metal);
    let closed = a.says(&["closed", "drawn", "shower", "hospital", "stage", "cubicle"]);
    let share = if closed { 0.5 } else { 0.27 };
    for side in b.y(0.0..a.h - 0.6 * rail).x(b.min.x..b.min.x + share * a.w).both_sides() {
        let n = pieces(share * a.w, 0.075, 2, 40);
        for (i, fold) in side.split(0, n, 0.0).enumerate() {
            let lean = if i % 2 == 0 { 0.0 } else { 0.28 * a.d };
            let c = fold.inset(-0.04 * a.w / n as f64, 0.0, 0.0).z(b.min.z + lean..b.max.z - 0.28 * a.d + lean);
            let c = c.x(c.min.x.max(b.min.x)..c.max.x.min(b.max.x));
            m.mesh.lathe(c, &[(1.0, 0.0), (0.9, 0.5), (0.8, 1.0)], 12, &cloth);
        }
    }
    m
}

/// Slats under a head rail.
pub(super) fn blinds(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    m.solid(b);
    let main = a.main(stuff::WHITE);
    let head = 0.05_f64.min(0.12 * a.h);
    m.mesh.board(b.y(a.h - head..a.h), &main);
    let n = pieces(a.h, 0.05, 3, 40);
    let slats = b.y(0.0..a.h - head).inset(0.004, 0.0, 0.06 * a.d);
    for slat in slats.split(1, n, 0.0) {
        // Tilted, from the upper edge at the back to the lower one in front.
        let (high, t) = (slat.size().y, 0.25 * slat.size().y);
        let (low, up) = (slat.min.y, slat.min.y + 0.6 * high);
        let (back, front) = (slat.min.z, slat.max.z);
        let section = [(low, front), (low + t, front), (up + t, back), (up, back)];
        m.mesh.extrude(0, &section, slat.min.x..slat.max.x, &main);
    }
    m
}

/// Screens between places: panels on feet; railings and fences have bars, glass ones are clear. A fence that is deep goes
/// around something.
pub(super) fn partition(a: &Ask) -> BuiltModel {
    if a.d > DEEP && a.w > DEEP && a.says(&["fence", "cage"]) {
        return super::fences::enclosure(a);
    }
    let mut m = BuiltModel::default();
    let b = a.whole();
    if a.says(&["house"]) {
        m.board(b, &a.main(stuff::WHITE));
        return m;
    }
    let open = a.says(&["railing", "fence", "banister", "balustrade", "barrier"]);
    let main = a.main(match () {
        () if open => stuff::BLACK_STEEL,
        () if a.says(&["glass", "sneeze", "shower"]) => stuff::GLASS,
        () => Stuff(Finish::Fabric, 0x8fa39a),
    });
    let frame_of = a.second(stuff::GRAY);
    let feet = a.d > 0.12;
    let thin = if feet { 0.05 } else { a.d };
    let foot = if feet { 0.04_f64.min(0.1 * a.h) } else { 0.0 };
    let panel = b.y(foot..a.h).z(-thin / 2.0..thin / 2.0);
    if feet {
        let t = 0.06_f64.min(0.12 * a.w);
        for side in b.y(0.0..foot).x(b.min.x + 0.05 * a.w..b.min.x + 0.05 * a.w + t).both_sides() {
            m.board(side, &frame_of);
        }
    }
    m.solid(panel);
    let edge = 0.04_f64.min(0.08 * a.w).min(0.08 * a.h);
    if open {
        frame(&mut m, panel, edge, edge, edge, &main);
        for bar in panel.inset(edge, edge, 0.25 * thin).split(0, pieces(a.w, 0.13, 2, 60), 0.0) {
            let (c, half) = (bar.center().x, (0.15 * thin).min(0.2 * bar.size().x));
            m.mesh.crisp(bar.x(c - half..c + half), &main);
        }
    } else {
        for field in panel.split(0, pieces(a.w, 1.0, 1, 8), 0.01) {
            frame(&mut m, field, edge, edge, edge, if is(&main, Finish::Glass) { &frame_of } else { &main });
            m.mesh.board(field.inset(edge, edge, 0.15 * thin), &main);
        }
    }
    m
}

/// Steps that rise towards −z.
pub(super) fn stairs(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::OAK);
    let body = a.second(stuff::WHITE);
    let n = pieces(a.h, 0.18, 1, 16);
    for (i, tread) in b.split(2, n, 0.0).enumerate() {
        let top = a.h * (n - i) as f64 / n as f64;
        let t = 0.03_f64.min(0.25 * a.h / n as f64);
        m.solid(tread.y(0.0..top));
        m.mesh.crisp(tread.y(0.0..top - t).z(tread.min.z..tread.max.z - 0.006 * a.d), &body);
        m.mesh.board(tread.y(top - t..top), &main);
    }
    m
}

/// A step ladder: rungs on two stiles in front, two behind.
pub(super) fn ladder(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::STEEL);
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let t = 0.05_f64.min(0.1 * a.w).min(0.1 * a.d);
    let top = 0.04_f64.min(0.1 * a.h);
    m.board(b.y(a.h - top..a.h).inset(0.08 * a.w, 0.0, 0.34 * a.d), &stuff::DARK_PLASTIC.surface());
    for side in b.x(-x..-x + t).both_sides() {
        for s in [1.0, -1.0] {
            let lean = [
                (0.0, s * z),
                (0.0, s * (z - t)),
                (a.h - top, s * (0.1 * a.d - 0.5 * t)),
                (a.h - top, s * (0.1 * a.d + 0.5 * t)),
            ];
            m.extrude(0, &lean, side.min.x..side.max.x, &main);
        }
    }
    let rungs = pieces(a.h, 0.27, 1, 8);
    for k in 1..=rungs {
        let y = a.h * k as f64 / (rungs + 1) as f64;
        let at = z + (0.1 * a.d - z) * y / (a.h - top);
        m.board(block(-x + t..x - t, y - 0.015_f64.min(0.02 * a.h)..y, at - 1.4 * t..at - 0.2 * t), &main);
    }
    m
}

/// A round or square column with base and head.
pub(super) fn pillar(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::STONE);
    let cap = 0.12_f64.min(0.08 * a.h);
    m.solid(b);
    m.mesh.board(b.y(0.0..cap), &main);
    m.mesh.board(b.y(a.h - cap..a.h), &main);
    let shaft = b.y(cap..a.h - cap).inset(0.08 * a.w, 0.0, 0.08 * a.d);
    if a.says(&["square", "concrete", "post"]) {
        m.mesh.board(shaft, &main);
    } else {
        m.mesh.lathe(shaft, &[(1.0, 0.0), (0.94, 0.06), (0.88, 0.94), (0.98, 1.0)], 24, &main);
    }
    m
}

/// A mantel around a fire.
pub(super) fn fireplace(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    m.solid(b);
    let main = a.main(stuff::STONE);
    let (side, top) = (0.2 * a.w, 0.24 * a.h);
    let mantel = 0.06_f64.min(0.1 * a.h);
    m.mesh.board(b.y(a.h - mantel..a.h), &main);
    let body = b.y(0.0..a.h - mantel).inset(0.03 * a.w, 0.0, 0.0).z(b.min.z..b.max.z - 0.1 * a.d);
    frame(&mut m, body, side, top, 0.05 * a.h, &main);
    let hole = body.inset(side, 0.0, 0.0).y(0.05 * a.h..a.h - mantel - top);
    // Its back is closed.
    let (rear, soot) = (body.min.z + 0.04 * a.d, body.min.z + 0.2 * a.d);
    m.mesh.crisp(hole.z(body.min.z..rear), &main);
    m.mesh.crisp(hole.z(rear..soot), &stuff::BLACK_STEEL.surface());
    let wood = stuff::WALNUT.surface();
    let size = hole.size();
    for (y, z) in [(0.1, -0.2), (0.1, 0.1), (0.22, -0.05)] {
        let at = |x: f64| Vec3::new(x * size.x, hole.min.y + y * size.y, z * a.d);
        m.mesh.rod(at(-0.32), at(0.32), 0.08 * size.y.min(a.d), &wood);
    }
    for (k, (x, high)) in [(-0.18, 0.4), (0.02, 0.6), (0.2, 0.35)].into_iter().enumerate() {
        let r = 0.09 * size.x;
        let r_z = r.min(0.12 * a.d);
        let flame = block(
            x * size.x - r..x * size.x + r,
            hole.min.y + 0.2 * size.y..hole.min.y + (0.2 + high) * size.y,
            -r_z..r_z,
        );
        let s = Stuff(Finish::Glow, [0xff9a3c, 0xffc04d, 0xff8330][k]).surface();
        m.mesh.lathe(flame, &[(0.0, 0.0), (0.9, 0.2), (1.0, 0.35), (0.5, 0.75), (0.0, 1.0)], 12, &s);
    }
    m
}
