//! What hotels have for guests: a cart and a rack for luggage, food kept warm and fresh behind glass, a day bed.

use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, is, shade, stuff, woody};
use crate::mesh::Surface;
use crate::model::BuiltModel;
use scenelang_layout::Vec3;
use std::f64::consts::PI;

/// A bed along a wall to sit on by day: a back, two arms, a mattress, cushions along the back.
pub(super) fn daybed(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let asked = a.main(stuff::OAK);
    let wooden = !a.has_color() || is(&asked, Finish::Wood) && woody(asked.color);
    let (frame, cloth) = if wooden { (asked, a.second(stuff::LINEN)) } else { (stuff::OAK.surface(), asked) };
    let t = 0.06_f64.min(0.06 * a.w).min(0.1 * a.d);
    let top = 0.46_f64.min(0.6 * a.h);
    m.surface = Some(top);
    let (raise, rail) = (0.24 * top, 0.56 * top);
    // The back goes through, the arms stand before it.
    let back = b.z(b.min.z..b.min.z + t);
    fence(&mut m, back, 0, &frame);
    for arm in b.x(b.min.x..b.min.x + t).z(back.max.z..b.max.z).y(0.0..0.94 * a.h).both_sides() {
        fence(&mut m, arm, 2, &frame);
    }
    let inner = b.inset(t, 0.0, 0.0).z(back.max.z..b.max.z);
    m.board(inner.y(raise..rail), &frame);
    m.cushion(inner.y(rail..top).z(inner.min.z..b.max.z - 0.01 * a.d), &cloth);
    let rest = (0.92 * a.h - top).min(0.44);
    let soft = inner.y(top..top + rest);
    let colors = [stuff::CLOTH, Stuff(Finish::Fabric, 0xb8705a), Stuff(Finish::Fabric, 0xd8b36a)];
    for (k, cushion) in soft.z(soft.min.z..soft.min.z + 0.2 * a.d).split(0, pieces(a.w, 0.6, 2, 5), 0.03).enumerate() {
        m.cushion(cushion, &colors[k % 3].surface());
    }
    // A roll at each arm.
    let round = (0.22_f64).min(0.9 * rest).min(0.14 * a.w);
    let roll =
        block(inner.min.x..inner.min.x + round, top..top + round, inner.min.z + 0.24 * a.d..b.max.z - 0.06 * a.d);
    for one in roll.both_sides() {
        m.disc(2, one, &stuff::DARK_CLOTH.surface());
    }
    m
}

/// Two posts, a rail between their heads, and slats below it; along x (0) or z (2).
fn fence(m: &mut BuiltModel, b: Block, along: usize, s: &Surface) {
    m.solid(b);
    let size = b.size();
    let post = (0.06_f64).min(0.2 * size[along]);
    let part = |from: f64, to: f64| if along == 0 { b.x(from..to) } else { b.z(from..to) };
    m.mesh.board(part(b.min[along], b.min[along] + post), s);
    m.mesh.board(part(b.max[along] - post, b.max[along]), s);
    let between = part(b.min[along] + post, b.max[along] - post);
    m.mesh.board(between.share(0.0..1.0, 0.9..1.0, 0.0..1.0), s);
    m.mesh.board(between.share(0.0..1.0, 0.3..0.38, 0.0..1.0), s);
    for slat in between.share(0.0..1.0, 0.38..0.9, 0.0..1.0).split(along, pieces(size[along], 0.14, 2, 16), 0.05) {
        let size = slat.size();
        m.mesh.crisp(slat.inset(0.2 * size.x, 0.0, 0.2 * size.z), s);
    }
}

/// A platform with a carpet on wheels, two hoops of brass over it with a rail between them, and suitcases.
pub(super) fn luggage_cart(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let brass = a.main(stuff::BRASS);
    let wheel = 0.16_f64.min(0.14 * a.h).min(0.2 * a.w).min(0.3 * a.d);
    let thin = 0.3 * wheel;
    let place = block(
        b.min.x + 0.06 * a.w..b.min.x + 0.06 * a.w + wheel,
        0.0..wheel,
        b.min.z + 0.08 * a.d..b.min.z + 0.08 * a.d + thin,
    );
    for w in place.four_corners() {
        m.disc(2, w, &stuff::RUBBER.surface());
    }
    let deck = b.y(wheel..wheel + 0.05 * a.h);
    m.surface = Some(deck.max.y);
    m.solid(deck);
    m.mesh.board(deck.share(0.0..1.0, 0.0..0.8, 0.0..1.0), &brass);
    m.mesh.crisp(deck.share(0.03..0.97, 0.8..1.0, 0.04..0.96), &Stuff(Finish::Carpet, 0x8a2432).surface());
    // A hoop at each end: two posts and half an ellipse.
    let r = 0.022_f64.min(0.05 * a.w).min(0.05 * a.d).min(0.04 * a.h);
    let (foot, spring) = (deck.max.y, 0.72 * a.h);
    let half = a.d / 2.0 - 0.04 * a.d - r;
    for side in [-1.0, 1.0] {
        let x = side * (a.w / 2.0 - 0.03 * a.w - r);
        let mut path = vec![Vec3::new(x, foot, -half)];
        let bend = |k: usize| {
            let (sin, cos) = (PI * k as f64 / 10.0).sin_cos();
            Vec3::new(x, spring + sin * (a.h - r - spring), -half * cos)
        };
        path.extend((0..=10).map(bend));
        path.push(Vec3::new(x, foot, half));
        m.mesh.tube(&path, r, &brass);
        let post = block(x - r..x + r, foot..spring, -half - r..-half + r);
        m.solid(post);
        m.solid(post.z(half - r..half + r));
        m.solid(block(x - r..x + r, spring..a.h, -half..half));
    }
    let end = a.w / 2.0 - 0.03 * a.w - r;
    // The rail touches the top, so that the box is filled.
    m.board(block(-end..end, a.h - 1.6 * r..a.h, -0.8 * r..0.8 * r), &brass);
    cases(&mut m, b.share(0.14..0.86, 0.0..1.0, 0.12..0.88).y(foot..a.h));
    m
}

/// Three suitcases on the deck.
fn cases(m: &mut BuiltModel, room: Block) {
    let (dark, grip) = (stuff::WALNUT.surface(), stuff::DARK_PLASTIC.surface());
    let low = room.share(0.0..0.62, 0.0..0.22, 0.1..0.9);
    let stands = room.share(0.68..1.0, 0.0..0.42, 0.15..0.8);
    let above = room.share(0.06..0.54, 0.22..0.36, 0.15..0.85);
    for (case, color) in [(low, 0x9a6a3a), (stands, 0x2f4f7a), (above, 0x6f2f3a)] {
        m.rounded(case, 0.02, &Stuff(Finish::Leather, color).surface());
        for strap in [case.share(0.2..0.26, 0.0..1.0, 1.0..1.0), case.share(0.74..0.8, 0.0..1.0, 1.0..1.0)] {
            m.mesh.crisp(strap.z(case.max.z..case.max.z + 0.01 * room.size().z), &dark);
        }
    }
    m.mesh.crisp(stands.share(0.35..0.65, 1.0..1.02, 0.45..0.55), &grip);
}

/// Crossed legs under two rails, with straps between them to put a suitcase on.
pub(super) fn luggage_rack(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wood = a.main(stuff::WALNUT);
    let t = 0.035_f64.min(0.1 * a.w).min(0.1 * a.d).min(0.1 * a.h);
    let low = a.h - 1.4 * t;
    for rail in [b.z(b.min.z..b.min.z + 1.4 * t), b.z(b.max.z - 1.4 * t..b.max.z)] {
        m.board(rail.y(low..a.h - 0.2 * t), &wood);
    }
    // Each frame has its two legs side by side, so that they pass each other.
    let (near, far) = (b.min.z, b.max.z);
    for (k, (foot, head)) in [(near, far), (far, near)].into_iter().enumerate() {
        let inwards = if foot < head { t } else { -t };
        let outline = [(0.0, foot), (0.0, foot + 1.3 * inwards), (low, head), (low, head - 1.3 * inwards)];
        let x = b.min.x + 0.06 * a.w + 1.1 * t * k as f64;
        for leg in [x..x + t, -x - t..-x] {
            m.extrude(0, &outline, leg, &wood);
        }
        let bar = foot + inwards * 1.6;
        m.board(b.x(x..-x).y(0.14 * a.h..0.14 * a.h + 0.8 * t).z(bar - 0.3 * t..bar + 0.3 * t), &wood);
    }
    let strap = b.y(a.h - 0.4 * t..a.h);
    m.solid(strap);
    for one in strap.inset(0.06 * a.w, 0.0, 0.0).split(0, 4, 0.0) {
        let size = one.size();
        m.mesh.crisp(one.inset(0.24 * size.x, 0.0, 0.0), &stuff::DARK_CLOTH.surface());
    }
    m
}

const SALADS: &[u32] = &[0x6fae3f, 0xc8402f, 0xe8912d, 0xf0d98a, 0x9a4a6a, 0x3f7d3a, 0xf3ead2];

/// A counter with tubs of salads on ice under a pane that keeps breath off.
pub(super) fn salad_bar(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::OAK);
    let (steel, glass) = (stuff::STEEL.surface(), stuff::GLASS.surface());
    let top = 0.9_f64.min(0.66 * a.h);
    m.surface = Some(top);
    m.board(b.share(0.03..0.97, 0.0..1.0, 0.05..0.95).y(0.0..0.1 * top), &stuff::DARK_PLASTIC.surface());
    let body = b.y(0.1 * top..0.93 * top);
    m.solid(body);
    m.mesh.crisp(body.share(0.005..0.995, 0.0..1.0, 0.01..0.985), &shade(&main, 0.75));
    for panel in body.z(b.max.z - 0.015 * a.d..b.max.z).split(0, pieces(a.w, 0.6, 1, 8), 0.012) {
        m.mesh.crisp(panel, &main);
    }
    let deck = b.y(0.93 * top..top);
    m.solid(deck);
    m.mesh.board(deck.share(0.0..1.0, 0.0..0.55, 0.0..1.0), &steel);
    let well = deck.inset(0.06 * a.w, 0.0, 0.16 * a.d);
    for edge in [deck.x(b.min.x..well.min.x), deck.x(well.max.x..b.max.x)] {
        m.mesh.crisp(edge.y(0.955 * top..top), &steel);
    }
    let between = deck.x(well.min.x..well.max.x).y(0.955 * top..top);
    for edge in [between.z(b.min.z..well.min.z), between.z(well.max.z..b.max.z)] {
        m.mesh.crisp(edge, &steel);
    }
    let cols = pieces(well.size().x, 0.34, 2, 8);
    for (row, half) in well.split(2, 2, 0.02).enumerate() {
        for (k, tub) in half.split(0, cols, 0.02).enumerate() {
            let color = Stuff(Finish::Ceramic, SALADS[(k * 3 + row * 5) % SALADS.len()]).surface();
            let heap = tub.y(0.94 * top..1.03 * top);
            m.mesh.rounded(heap, 0.4 * heap.size().min(), 1, &color);
            for bit in 0..3 {
                let (x, z) = (0.2 + 0.22 * f64::from(bit), 0.3 + 0.2 * f64::from((bit + row as i32) % 3));
                let leaf = heap.share(x..x + 0.16, 0.95..1.12, z..z + 0.16);
                m.mesh.crisp(leaf, &shade(&color, if bit == 1 { 1.5 } else { 0.75 }));
            }
        }
    }
    m.solid(well.y(top..1.03 * top));
    guard(&mut m, b.y(top..a.h), [&steel, &glass]);
    m
}

/// Posts along the middle that carry a shelf of glass and slanted panes.
fn guard(m: &mut BuiltModel, b: Block, [steel, glass]: [&Surface; 2]) {
    let size = b.size();
    let t = 0.03_f64.min(0.04 * size.x).min(0.06 * size.z);
    for post in b.x(b.min.x + 0.02 * size.x..b.min.x + 0.02 * size.x + t).z(-t / 2.0..t / 2.0).both_sides() {
        m.board(post.share(0.0..1.0, 0.0..0.94, 0.0..1.0), steel);
    }
    m.board(b.share(0.0..1.0, 0.94..1.0, 0.2..0.8), glass);
    for z in [0.14, 0.8] {
        let pane = b.share(0.03..0.97, 0.5..0.94, z..z + 0.06);
        m.solid(pane);
        m.mesh.crisp(pane.share(0.0..1.0, 0.0..1.0, 0.4..0.6), glass);
        m.mesh.crisp(pane.share(0.0..1.0, 0.0..0.06, 0.0..1.0), steel);
    }
}

/// A dish that keeps food warm: a frame with a flame below, a pan, a lid that rolls back.
pub(super) fn chafing_dish(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let (steel, dark) = (a.main(stuff::CHROME), stuff::DARK_PLASTIC.surface());
    for leg in b.share(0.04..0.1, 0.0..0.34, 0.06..0.16).four_corners() {
        m.board(leg, &steel);
    }
    let tray = b.share(0.06..0.94, 0.07..0.1, 0.08..0.92);
    m.solid(tray);
    m.mesh.crisp(tray, &steel);
    m.drum(b.share(0.4..0.6, 0.1..0.24, 0.38..0.62), &dark);
    m.mesh.crisp(b.share(0.46..0.54, 0.24..0.28, 0.46..0.54), &Stuff(Finish::Glow, 0xf2a33a).surface());
    m.board(b.share(0.0..1.0, 0.34..0.52, 0.0..1.0), &steel);
    // Half a cylinder along x.
    let (low, up) = (0.52 * a.h, 0.94 * a.h);
    let arc = |k: usize| {
        let (sin, cos) = (PI * k as f64 / 12.0).sin_cos();
        (low + sin * (up - low), 0.46 * a.d * cos)
    };
    let outline: Vec<(f64, f64)> = (0..=12).map(arc).collect();
    m.extrude(0, &outline, -0.47 * a.w..0.47 * a.w, &shade(&steel, 1.15));
    m.board(b.share(0.3..0.7, 0.94..1.0, 0.46..0.54), &dark);
    m
}
