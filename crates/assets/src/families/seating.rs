//! Chairs, stools, benches, sofas: a seat at a height people sit at, and a flat one, so that things can be put on it.

use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, is, shade, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;
use crate::shapes::sphere;
use scenelang_layout::Vec3;

/// Where the seat is on something of this height.
fn seat_height(h: f64, usual: f64) -> f64 {
    usual.min(0.52 * h)
}

/// A board bent about the sitter: filled box, hollow side to the front.
fn bent_back(m: &mut BuiltModel, b: Block, s: &Surface) {
    m.solid(b);
    let (size, c) = (b.size(), b.center());
    let half = 0.3 * size.z;
    m.mesh.stretch(b, |mesh| {
        let path: Vec<_> = (0..=10)
            .map(|i| {
                let t = f64::from(i) / 5.0 - 1.0;
                let at = Vec3::new(c.x + t * size.x / 2.0, c.y, b.min.z + half + (size.z - 2.0 * half) * t * t);
                (at, half, size.y / 2.0)
            })
            .collect();
        mesh.sweep(&path, Vec3::y(), 14, s);
    });
}

/// Names of chairs on runners.
const ROCKING: [&str; 5] = ["rocking", "rocker", "glider", "nursing", "nursery"];

/// Four legs, a seat, two posts and a bent back; upholstered if of cloth or leather.
pub(super) fn chair(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let seat = seat_height(a.h, 0.46);
    let main = a.main(stuff::OAK);
    let soft = [Finish::Fabric, Finish::Velvet, Finish::Leather, Finish::Carpet].iter().any(|f| is(&main, *f));
    let legs = a.legs(&main);
    let thick = if soft { 0.07 } else { 0.035_f64 }.min(0.12 * a.h);
    let post = 0.035_f64.min(0.1 * a.w).min(0.1 * a.d);
    let under = seat - thick;
    m.surface = Some(seat);
    let runner = if a.says(&ROCKING) { 0.05 * a.h } else { 0.0 };
    for side in b.x(b.min.x + 0.02..b.min.x + 0.02 + post).both_sides().into_iter().filter(|_| runner > 0.0) {
        m.board(side.y(0.0..runner), &legs);
    }
    m.legs(b.y(runner..under).inset(0.02, 0.0, if runner > 0.0 { 0.16 * a.d } else { 0.015 }), 1.1 * post, &legs);
    let board = b.y(under..seat).z(b.min.z + if soft { 0.0 } else { 0.4 * post }..b.max.z);
    if soft {
        m.cushion(board, &main)
    } else {
        m.rounded(board, 0.02, &main)
    }
    // The posts carry on the hind legs; the back sits between seat and top.
    let depth = (0.09 * a.d).max(1.6 * post).min(0.2 * a.d);
    let gap = if soft { 0.12 } else { 0.42 } * (a.h - seat);
    let back = b.y(seat + gap..a.h).z(b.min.z..b.min.z + depth);
    for p in b.x(b.min.x + 0.02 * a.w..b.min.x + 0.02 * a.w + post).both_sides() {
        m.board(p.y(under..seat + gap + 0.3 * (a.h - seat - gap)).z(b.min.z..b.min.z + post), &legs);
    }
    if soft {
        m.cushion(back, &main)
    } else {
        bent_back(&mut m, back, &main)
    }
    if runner > 0.0 && !soft {
        // Nobody nurses on bare wood.
        let pad = board.inset(0.04 * a.w, 0.0, 0.0).y(seat..seat + 0.05 * a.h).z(b.min.z + depth..b.max.z - 0.02 * a.d);
        m.cushion(pad, &stuff::LINEN.surface());
        m.surface = Some(pad.max.y);
    }
    if a.says(&["armrest", "arm", "armed"]) || a.says(&ROCKING) {
        let rest = seat + 0.45 * (a.h - seat);
        for side in b.x(b.min.x..b.min.x + 1.2 * post).both_sides() {
            m.board(side.y(rest - 0.6 * post..rest).z(b.min.z + depth..b.max.z - 0.12 * a.d), &legs);
            m.board(side.y(seat..rest - 0.6 * post).z(b.max.z - 0.12 * a.d - post..b.max.z - 0.12 * a.d), &legs);
        }
    }
    m
}

/// Five castors, a gas spring, a padded seat, arms and a back.
pub(super) fn office_chair(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let seat = seat_height(a.h, 0.5);
    let main = a.main(stuff::DARK_CLOTH);
    let frame = a.second(stuff::DARK_PLASTIC);
    let thick = 0.08_f64.min(0.2 * seat);
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    m.surface = Some(seat);
    // Base: the solid is the disc that the castors turn in.
    let foot = b.y(0.0..0.2 * seat).inset(0.03 * a.w, 0.0, 0.03 * a.d);
    m.solid_drum(foot);
    let wheel = (0.06 * seat).min(0.1 * x).min(0.1 * z);
    for k in 0..5 {
        let (sin, cos) = (std::f64::consts::TAU * (f64::from(k) / 5.0 + 0.05)).sin_cos();
        let at = |r: f64, y: f64| Vec3::new(r * x * sin, y, r * z * cos);
        let end = at(0.82, 2.6 * wheel);
        let slim = (0.05 * x.min(z)).min(0.04 * seat);
        m.mesh.sweep(&[(at(0.06, 0.19 * seat), slim, 1.6 * slim), (end, slim, slim)], Vec3::y(), 8, &frame);
        let caster = block(-wheel..wheel, 0.0..2.0 * wheel, -wheel..wheel).moved(end.x, 0.0, end.z);
        m.mesh.lathe(caster, &sphere(6), 8, &stuff::RUBBER.surface());
    }
    let column = 0.05 * x.min(z);
    m.drum(block(-column * 1.6..column * 1.6, 0.12 * seat..0.55 * seat, -column * 1.6..column * 1.6), &frame);
    m.drum(block(-column..column, 0.55 * seat..seat - thick, -column..column), &stuff::CHROME.surface());
    let arms = !a.says(&["armless"]);
    let arm = if arms { 0.1 * a.w } else { 0.0 };
    let depth = 0.16 * a.d;
    m.cushion(b.x(-x + arm..x - arm).y(seat - thick..seat).z(-z + 0.08 * a.d..z), &main);
    let back = b.x(-x + 1.1 * arm..x - 1.1 * arm).y(seat + 0.08 * (a.h - seat)..a.h).z(-z..-z + depth);
    bent_back(&mut m, back, &main);
    let stem = 0.12 * a.w;
    m.board(
        block(-stem..stem, seat - 0.7 * thick..seat + 0.3 * (a.h - seat), -z + 0.1 * depth..-z + 0.5 * depth),
        &frame,
    );
    if arms {
        let rest = seat + 0.36 * (a.h - seat);
        for side in b.x(-x..-x + 0.9 * arm).both_sides() {
            m.rounded(side.y(rest - 0.025_f64.min(0.06 * a.h)..rest).z(-0.55 * z..0.45 * z), 0.01, &frame);
            m.board(side.inset(0.2 * arm, 0.0, 0.0).y(seat - 0.8 * thick..rest).z(-0.2 * z..0.02 * z), &frame);
        }
    }
    m
}

/// A round seat on four splayed legs, with a ring for the feet where it is high.
pub(super) fn stool(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::OAK);
    let legs = a.legs(&main);
    let soft = [Finish::Fabric, Finish::Velvet, Finish::Leather].iter().any(|f| is(&main, *f));
    let thick = if soft { 0.07 } else { 0.035_f64 }.min(0.15 * a.h);
    let under = a.h - thick;
    let square = a.says(&["square"]) || a.w > 1.6 * a.d || a.d > 1.6 * a.w;
    if square {
        if soft { m.rounded(b.y(under..a.h), 0.03, &main) } else { m.rounded(b.y(under..a.h), 0.015, &main) }
    } else if soft {
        m.lathe(b.y(under..a.h), &[(0.9, 0.0), (1.0, 0.3), (1.0, 0.7), (0.95, 0.92), (0.86, 1.0)], &main);
    } else {
        m.drum(b.y(under..a.h), &main);
    }
    let t = 0.035_f64.min(0.1 * a.w).min(0.1 * a.d);
    let reach = if square { 0.96 } else { 0.78 };
    let (fx, fz) = (reach * a.w / 2.0, reach * a.d / 2.0);
    let foot = block(-fx..-fx + 0.8 * t, 0.0..under, -fz..-fz + 0.8 * t);
    let head = foot.moved(0.3 * fx, 0.0, 0.3 * fz).inset(-0.1 * t, 0.0, -0.1 * t);
    for (f, h) in foot.four_corners().into_iter().zip(head.four_corners()) {
        m.taper(f, h, &legs);
    }
    if under > 0.5 {
        let y = 0.3 * under;
        let (rx, rz) = (fx * 0.87 - 0.4 * t, fz * 0.87 - 0.4 * t);
        let corner = [(rx, rz), (-rx, rz), (-rx, -rz), (rx, -rz)].map(|(x, z)| Vec3::new(x, y, z));
        for i in 0..4 {
            m.mesh.rod(corner[i], corner[(i + 1) % 4], 0.3 * t, &legs);
        }
    }
    m
}

/// A plank on two frames; a high one has a back.
pub(super) fn bench(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::OAK);
    let legs = a.legs(&main);
    let backed = a.h > 0.6 && !a.says(&["backless"]);
    let seat = if backed { seat_height(a.h, 0.45) } else { a.h };
    let thick = 0.05_f64.min(0.2 * seat);
    let front = if backed { b.z(b.min.z + 0.12 * a.d..b.max.z) } else { b };
    let slats = pieces(a.d, 0.13, 1, 5);
    m.solid(front.y(seat - thick..seat));
    let padded = !backed && a.says(&["piano", "bed", "padded", "upholstered", "dressing", "vanity"]);
    if padded {
        let cloth = a.second(stuff::DARK_CLOTH);
        m.mesh.rounded(front.y(seat - thick..seat), 0.4 * thick, 3, &cloth);
    } else {
        for slat in front.y(seat - thick..seat).split(2, slats, 0.012) {
            m.mesh.rounded(slat, 0.008, 2, &main);
        }
    }
    let t = 0.06_f64.min(0.15 * a.w);
    for side in b.x(b.min.x + 0.08 * a.w..b.min.x + 0.08 * a.w + t).both_sides() {
        m.board(side.y(0.0..seat - thick).z(b.min.z + 0.04 * a.d..b.max.z - 0.04 * a.d), &legs);
        if backed {
            m.board(side.y(seat - thick..a.h - 0.02 * a.h).z(b.min.z + 0.03 * a.d..b.min.z + 0.1 * a.d), &legs);
        }
    }
    if backed {
        m.surface = Some(seat);
        let back = b.y(seat + 0.3 * (a.h - seat)..a.h).z(b.min.z..b.min.z + 0.12 * a.d);
        m.solid(back);
        for slat in back.split(1, 2, 0.03) {
            m.mesh.rounded(slat, 0.008, 2, &main);
        }
    }
    m
}

/// Sofas, and armchairs as the narrow ones: base, back, two arms, loose cushions; with `corner` or `sectional`, a chaise.
pub(super) fn sofa(a: &Ask) -> BuiltModel {
    if a.says(&["booth", "banquette"]) {
        return booth(a);
    }
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::CLOTH);
    let light = shade(&main, 1.08);
    let seat = seat_height(a.h, 0.44);
    m.surface = Some(seat);
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let arm = 0.17_f64.min(0.14 * a.w);
    let bent = a.says(&["sectional", "corner", "chaise", "lshaped"]) || a.says(&["l"]) && a.says(&["shaped", "shape"]);
    let chaise = a.d > 1.2 && bent;
    let front = if chaise { -z + (0.95_f64).min(0.65 * a.d) } else { z };
    let back = 0.24_f64.min(0.27 * (front + z));
    let rest = seat + 0.42 * (a.h - seat);
    let foot = 0.05_f64.min(0.08 * a.h).min(0.4 * arm).min(0.1 * a.d);
    let base = seat - 0.36 * seat;
    // Solids reach the floor: nothing but a rug goes under a sofa.
    m.solid(b.x(-x + arm..x - arm).y(0.0..seat).z(-z + back..front));
    m.solid(b.x(-x + arm..x - arm).z(-z..-z + back));
    let inner = b.x(-x + arm..x - arm);
    m.mesh.rounded(b.inset(0.01, 0.0, 0.0).y(foot..base).z(-z + 0.01 * a.d..front - 0.02 * a.d), 0.03, 3, &main);
    let seats = pieces(a.w - 2.0 * arm, 0.62, 1, 5);
    for c in inner.y(base..seat).z(-z + 0.8 * back..front).split(0, seats, 0.006) {
        m.mesh.rounded(c, 0.05_f64.min(0.3 * (seat - base)), 3, &light);
    }
    m.mesh.rounded(
        inner.inset(-0.02 * arm, 0.0, 0.0).y(foot..a.h - 0.04 * (a.h - seat)).z(-z..-z + 0.55 * back),
        0.05,
        3,
        &main,
    );
    for c in inner.y(seat..a.h).z(-z + 0.4 * back..-z + back).split(0, seats, 0.006) {
        m.mesh.rounded(c, 0.07, 3, &light);
    }
    for (i, side) in b.x(-x..-x + arm).both_sides().into_iter().enumerate() {
        let side = side.y(0.0..rest).z(-z..if chaise && i == 1 { z } else { front });
        m.solid(side);
        m.mesh.rounded(side.y(foot..rest), 0.05, 3, &main);
    }
    if chaise {
        let lounge = b.x(x - arm - 0.36 * (a.w - 2.0 * arm)..x - arm).z(front..z);
        m.solid(lounge.y(0.0..seat));
        m.mesh.rounded(lounge.y(foot..base), 0.03, 3, &main);
        m.mesh.rounded(lounge.y(base..seat), 0.05, 3, &light);
    }
    let feet = block(-x + 0.3 * arm..-x + 0.3 * arm + foot, 0.0..foot, -z + 0.04 * a.d..-z + 0.04 * a.d + foot);
    let wood = a.second(stuff::WALNUT);
    for f in feet.both_sides() {
        m.mesh.crisp(f, &wood);
        let ahead = front - f.max.z - 0.04 * a.d;
        m.mesh.crisp(f.moved(0.0, 0.0, ahead.max(0.0)), &wood);
    }
    m
}

/// A padded bench with a high back in upright channels, as in restaurants.
fn booth(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Leather, 0x6e2f2c));
    let wood = a.second(stuff::WALNUT);
    let seat = seat_height(a.h, 0.46);
    let (thick, back) = (0.12_f64.min(0.3 * seat), 0.18_f64.min(0.3 * a.d));
    m.surface = Some(seat);
    m.board(b.y(0.0..seat - thick).z(b.min.z + back..b.max.z - 0.06 * a.d), &wood);
    m.cushion(b.y(seat - thick..seat).z(b.min.z + back..b.max.z), &main);
    m.solid(b.z(b.min.z..b.min.z + back));
    m.mesh.board(b.z(b.min.z..b.min.z + 0.35 * back), &wood);
    let pad = b.y(seat - thick..0.96 * a.h).z(b.min.z + 0.3 * back..b.min.z + back);
    for channel in pad.split(0, pieces(a.w, 0.16, 2, 12), 0.0) {
        m.mesh.rounded(channel, 0.3 * channel.size().x.min(channel.size().z), 2, &main);
    }
    m
}

/// A padded block on short feet, or a round pouf.
pub(super) fn ottoman(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::CLOTH);
    if a.says(&["bean", "beanbag"]) {
        // Sunken where one sits, and widest near the floor.
        let bag = [(0.72, 0.0), (0.96, 0.1), (1.0, 0.24), (0.93, 0.45), (0.74, 0.7), (0.5, 0.9), (0.28, 1.0)];
        m.lathe(b, &bag, &main);
        return m;
    }
    if a.says(&["round", "pouf", "pouffe"]) {
        let bag = [(0.8, 0.0), (0.97, 0.12), (1.0, 0.3), (1.0, 0.62), (0.95, 0.86), (0.8, 0.97), (0.6, 1.0)];
        m.lathe(b, &bag, &main);
        return m;
    }
    let foot = 0.08_f64.min(0.2 * a.h);
    m.legs(b.y(0.0..foot).inset(0.03, 0.0, 0.03), 0.04, &a.second(stuff::WALNUT));
    m.solid(b.y(foot..a.h));
    let seam = a.h - 0.3 * (a.h - foot);
    m.mesh.rounded(b.inset(0.006, 0.0, 0.006).y(foot..seam), 0.02, 3, &main);
    m.mesh.rounded(b.y(seam..a.h), 0.05, 3, &shade(&main, 1.08));
    m
}

/// A seat between two large wheels, with a back, arms and a footrest.
pub(super) fn wheelchair(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::DARK_CLOTH);
    let frame = stuff::STEEL.surface();
    let seat = seat_height(a.h, 0.5);
    m.surface = Some(seat);
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let rim = 0.09 * a.w;
    let wheel = (0.62 * a.h).min(0.62 * a.d);
    for side in b.x(-x..-x + rim).both_sides() {
        m.solid(side.y(0.0..wheel).z(-z..-z + wheel));
        let tyre = |from: f64, to: f64| [(from, 0.3), (1.0, 0.0), (1.0, 1.0), (from, 0.7)].map(|(r, y)| (r * to, y));
        m.mesh.stretch(side.y(0.0..wheel).z(-z..-z + wheel), |mesh| {
            mesh.place(Vec3::zeros(), [0.0, 0.0, 90.0], |mesh| {
                mesh.lathe(block(-1.0..1.0, 0.0..0.2, -1.0..1.0), &tyre(0.86, 1.0), 32, &stuff::RUBBER.surface());
                mesh.lathe(block(-0.1..0.1, 0.02..0.18, -0.1..0.1), &[(1.0, 0.0), (1.0, 1.0)], 12, &frame);
            });
        });
        let small = (0.18 * a.h).min(0.3 * a.d);
        m.solid(side.y(0.0..small).z(z - 0.15 * a.d - small..z - 0.15 * a.d));
        m.mesh.drum(side.y(0.0..small).z(z - 0.15 * a.d - small..z - 0.15 * a.d), &stuff::RUBBER.surface());
        m.board(
            side.inset(0.2 * rim, 0.0, 0.0).y(seat + 0.22 * a.h..seat + 0.26 * a.h).z(-z + 0.1 * a.d..z - 0.35 * a.d),
            &frame,
        );
    }
    let inner = b.x(-x + rim..x - rim);
    m.cushion(inner.y(seat - 0.07 * a.h..seat).z(-z + 0.06 * a.d..z - 0.22 * a.d), &main);
    m.cushion(inner.y(seat..a.h).z(-z..-z + 0.1 * a.d), &main);
    m.board(inner.y(0.06 * a.h..0.1 * a.h).z(z - 0.24 * a.d..z), &frame);
    m.board(inner.inset(0.35 * a.w, 0.0, 0.0).y(0.1 * a.h..seat - 0.07 * a.h).z(z - 0.24 * a.d..z - 0.2 * a.d), &frame);
    m
}
