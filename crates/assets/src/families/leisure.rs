//! Music, sport, boxes and bins: what is left.

use super::storage::carton;
use crate::ask::Ask;
use crate::block::{block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::BuiltModel;
use scenelang_layout::Vec3;

/// Upright pianos; deep ones are grand, with three legs and the bend on the right. The player sits at +z.
pub(super) fn piano(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Ceramic, 0x1d1d20));
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let grand = a.d > 1.1 || a.says(&["grand"]);
    let key = if grand { 0.7 * a.h } else { 0.6 * a.h };
    let deep = 0.16_f64.min(0.3 * a.d);
    let bed = block(-x..x, key - 0.12 * a.h..key, z - 1.4 * deep..z);
    if grand {
        let low = key - 0.08 * a.h;
        let front = z - 1.2 * deep;
        let plan = |x_: f64, z_: f64| (z_, x_);
        let bend = [
            plan(-x, front),
            plan(-x, -z),
            plan(-0.1 * x, -z),
            plan(0.45 * x, -0.55 * z),
            plan(x, 0.2 * z),
            plan(x, front),
        ];
        m.extrude(1, &bend, low..a.h, &main);
        m.board(bed.y(low..key).z(front..z), &main);
        for cheek in block(-x..-x + 0.06 * a.w, key..key + 0.1 * a.h, front..z).both_sides() {
            m.board(cheek, &main);
        }
        let t = 0.05 * a.w;
        for (px, pz) in [(-0.85 * x, 0.6 * z), (0.85 * x - t, 0.6 * z), (-0.55 * x, -0.85 * z)] {
            m.board(block(px..px + t, 0.0..low, pz..pz + t), &main);
        }
    } else {
        let body = b.z(-z..z - deep);
        m.board(body.y(0.0..a.h - 0.03 * a.h), &main);
        m.mesh.board(
            body.inset(0.06 * a.w, 0.0, 0.0).y(0.12 * a.h..key - 0.16 * a.h).z(z - deep..z - 0.96 * deep),
            &shade(&main, 1.15),
        );
        m.board(b.y(a.h - 0.03 * a.h..a.h).z(-z..z - 0.9 * deep), &main);
        m.board(bed, &main);
        for cheek in block(-x..-x + 0.05 * a.w, 0.0..key - 0.12 * a.h, z - 0.35 * deep..z - 0.05 * deep).both_sides() {
            m.board(cheek, &main);
        }
    }
    let keys = block(-0.9 * x..0.9 * x, key..key + 0.012 * a.h, z - 0.95 * deep..z - 0.08 * deep);
    m.mesh.crisp(keys, &Stuff(Finish::Plastic, 0xf7f5ee).surface());
    let n = pieces(a.w, 0.035, 7, 52);
    for (i, k) in keys.split(0, n, 0.0).enumerate() {
        if matches!(i % 7, 2 | 6) {
            continue;
        }
        let half = 0.28 * k.size().x;
        let at = k.max.x.min(keys.max.x - half);
        m.mesh.crisp(
            block(
                at - half..at + half,
                keys.max.y..keys.max.y + 0.01 * a.h,
                keys.min.z..keys.min.z + 0.6 * keys.size().z,
            ),
            &stuff::DARK_PLASTIC.surface(),
        );
    }
    m
}

/// Bins: round and open, or square with a lid (`recycling`, `pedal`, or not square in plan).
pub(super) fn bin(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let square = a.says(&["recycling", "recycle", "square", "container", "wheelie"]) || (a.w / a.d - 1.0).abs() > 0.15;
    let green = a.says(&["recycling", "recycle"]);
    let main = a.main(if green { Stuff(Finish::Plastic, 0x3f8a52) } else { stuff::GRAY });
    if square {
        let lid = 0.12 * a.h;
        m.solid(b);
        m.mesh.taper(
            b.inset(0.08 * a.w, 0.0, 0.08 * a.d).y(0.0..0.01 * a.h),
            b.inset(0.02 * a.w, 0.0, 0.02 * a.d).y(0.8 * a.h..a.h - lid),
            &main,
        );
        m.mesh.rounded(b.y(a.h - lid..a.h), 0.02, 2, &shade(&main, 0.85));
        let slot = b.inset(0.25 * a.w, 0.0, 0.0).y(a.h - 0.72 * lid..a.h - 0.35 * lid).z(b.max.z - 0.02 * a.d..b.max.z);
        m.mesh.crisp(slot, &stuff::DARK_PLASTIC.surface());
    } else {
        let open = [(0.78, 0.0), (0.8, 0.02), (0.97, 0.96), (1.0, 0.97), (1.0, 1.0), (0.92, 1.0), (0.75, 0.06)];
        m.lathe(b, &open, &main);
    }
    m
}

/// Cartons, crates and chests.
pub(super) fn crate_box(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    if a.says(&["chest", "trunk"]) {
        // A hollow box with a lid.
        let (t, lid) = (0.08 * b.size().min(), 0.12 * a.h);
        m.solid(b.y(0.0..t));
        let sides = b.y(t..a.h - lid);
        for end in sides.x(b.min.x..b.min.x + t).both_sides() {
            m.solid(end);
        }
        let between = sides.inset(t, 0.0, 0.0);
        for face in [between.z(b.min.z..b.min.z + t), between.z(b.max.z - t..b.max.z)] {
            m.solid(face);
        }
        let cover = b.y(a.h - lid..a.h);
        m.solid(cover);
        m.lid("lid", cover);
    } else {
        m.solid(b);
    }
    if a.says(&["crate", "wooden", "chest", "planter", "trunk"]) || a.made_of(&[Finish::Wood]) {
        let main = a.main(stuff::BIRCH);
        let t = 0.08 * b.size().min();
        m.mesh.crisp(b.inset(t, 0.0, t).y(0.0..a.h - 0.3 * t), &shade(&main, 0.75));
        for plank in b.split(1, pieces(a.h, 0.12, 2, 8), 0.02) {
            for f in
                plank.z(b.min.z + 0.3 * t..b.min.z + t).inset(0.3 * t, 0.0, 0.0).four_corners().into_iter().step_by(2)
            {
                m.mesh.crisp(f, &main);
            }
            for f in plank.x(b.min.x + 0.3 * t..b.min.x + t).inset(0.0, 0.0, t).both_sides() {
                m.mesh.crisp(f, &main);
            }
        }
        for plank in b.y(a.h - 0.4 * t..a.h).split(2, pieces(a.d, 0.12, 2, 8), 0.02) {
            m.mesh.crisp(plank, &main);
        }
        for post in b.x(b.min.x..b.min.x + 2.0 * t).z(b.min.z..b.min.z + 0.4 * t).four_corners() {
            m.mesh.crisp(post, &main);
        }
    } else if a.says(&["tool", "toolbox", "toy", "storage", "tote", "container", "plastic"])
        || a.made_of(&[Finish::Plastic, Finish::Metal])
    {
        let main = a.main(Stuff(Finish::Plastic, 0x4a6f9c));
        m.mesh.taper(
            b.inset(0.05 * a.w, 0.0, 0.05 * a.d).y(0.0..0.1 * a.h),
            b.inset(0.02 * a.w, 0.0, 0.02 * a.d).y(0.1 * a.h..0.85 * a.h),
            &main,
        );
        m.mesh.rounded(b.y(0.85 * a.h..a.h), 0.01, 2, &shade(&main, 0.85));
    } else {
        carton(&mut m, b, &a.main(stuff::CARDBOARD));
    }
    m
}

/// Woven baskets, open at the top.
pub(super) fn basket(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(Stuff(Finish::Wicker, 0xc79f66));
    let mut weave = vec![(0.76, 0.0)];
    for k in 0..8 {
        let y = f64::from(k) / 8.0;
        weave.push((0.8 + 0.17 * y, y + 0.03));
        weave.push((0.77 + 0.17 * y, y + 0.1));
    }
    weave.extend([(1.0, 0.96), (1.0, 1.0), (0.9, 1.0), (0.74, 0.1)]);
    m.lathe(a.whole(), &weave, &main);
    m
}

/// Suitcases and bags, standing.
pub(super) fn suitcase(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Plastic, 0x35506b));
    let grip = 0.1 * a.h;
    let wheel = 0.04 * a.h;
    m.solid(b.y(0.0..a.h - grip));
    m.mesh.rounded(b.y(wheel..a.h - grip), 0.2 * b.size().min(), 3, &main);
    for k in 1..5 {
        let x = b.min.x + a.w * f64::from(k) / 5.0;
        m.mesh.crisp(
            block(x - 0.01 * a.w..x + 0.01 * a.w, 0.15 * a.h..0.8 * a.h, b.max.z - 0.01 * a.d..b.max.z),
            &shade(&main, 0.8),
        );
    }
    for w in
        block(b.min.x + 0.06 * a.w..b.min.x + 0.14 * a.w, 0.0..1.5 * wheel, b.min.z + 0.08 * a.d..b.min.z + 0.3 * a.d)
            .four_corners()
    {
        m.mesh.crisp(w, &stuff::RUBBER.surface());
    }
    m.solid(b.inset(0.28 * a.w, 0.0, 0.3 * a.d).y(a.h - grip..a.h));
    for side in block(-0.22 * a.w..-0.18 * a.w, a.h - grip..a.h, -0.06 * a.d..0.06 * a.d).both_sides() {
        m.mesh.crisp(side, &stuff::STEEL.surface());
    }
    m.mesh.rounded(
        block(-0.22 * a.w..0.22 * a.w, a.h - 0.35 * grip..a.h, -0.1 * a.d..0.1 * a.d),
        0.01,
        2,
        &stuff::DARK_PLASTIC.surface(),
    );
    m
}

/// A treadmill and its kin: a belt, two uprights, a console.
pub(super) fn treadmill(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::DARK_PLASTIC);
    let deck = 0.13_f64.min(0.15 * a.h);
    m.rounded(b.y(0.0..deck), 0.03, &main);
    m.mesh.crisp(b.inset(0.14 * a.w, 0.0, 0.03 * a.d).y(deck..deck + 0.004 * a.h), &stuff::RUBBER.surface());
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let t = 0.08 * a.w;
    let (far, near) = (-z + 0.12 * a.d, -z + 0.2 * a.d);
    for side in block(-x..-x + t, deck..0.9 * a.h, 0.0..1.0).both_sides() {
        let (lo, hi) = (side.min.x, side.max.x);
        m.extrude(
            0,
            &[(deck, far), (deck, near + 0.04 * a.d), (0.9 * a.h, near), (0.9 * a.h, far)],
            lo..hi,
            &stuff::STEEL.surface(),
        );
        m.board(side.y(0.68 * a.h..0.72 * a.h).z(near..near + 0.25 * a.d), &main);
    }
    m.extrude(
        0,
        &[(0.82 * a.h, near), (0.86 * a.h, near + 0.06 * a.d), (a.h, far), (0.86 * a.h, far - 0.02 * a.d)],
        -x + 0.1 * t..x - 0.1 * t,
        &main,
    );
    m
}

/// An exercise bike.
pub(super) fn bike(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::RED);
    let dark = stuff::DARK_PLASTIC.surface();
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let t = 0.05 * a.h;
    m.board(b.y(0.0..t).z(-z..-z + 0.1 * a.d), &dark);
    m.board(b.y(0.0..t).z(z - 0.1 * a.d..z), &dark);
    m.board(block(-0.12 * x..0.12 * x, 0.0..t, -z + 0.1 * a.d..z - 0.1 * a.d), &main);
    let r = (0.2 * a.h).min(0.24 * a.d);
    let wheel = block(-0.16 * x..0.16 * x, 1.2 * t..1.2 * t + 2.0 * r, 0.45 * z - r..0.45 * z + r);
    m.solid(wheel);
    m.mesh.stretch(wheel, |mesh| {
        mesh.place(Vec3::zeros(), [0.0, 0.0, 90.0], |mesh| mesh.drum(block(-1.0..1.0, 0.0..1.0, -1.0..1.0), &main));
    });
    let post = |z_: f64, y: f64| block(-0.1 * x..0.1 * x, t..y, z_ - 0.04 * a.d..z_ + 0.04 * a.d);
    m.board(post(-0.45 * z, 0.66 * a.h), &stuff::STEEL.surface());
    m.board(post(0.45 * z, 0.9 * a.h), &stuff::STEEL.surface());
    m.cushion(block(-0.4 * x..0.4 * x, 0.66 * a.h..0.72 * a.h, -0.75 * z..-0.15 * z), &dark);
    m.board(block(-0.8 * x..0.8 * x, 0.86 * a.h..0.9 * a.h, 0.3 * z..0.42 * z), &dark);
    m.board(block(-0.25 * x..0.25 * x, 0.9 * a.h..a.h, 0.42 * z..0.5 * z), &dark);
    m
}

/// Fins of hot water under a window.
pub(super) fn radiator(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::WHITE);
    m.solid(b);
    let n = pieces(a.w, 0.06, 3, 27);
    for fin in b.y(0.0..a.h).split(0, n, 0.012) {
        m.mesh.rounded(fin, 0.4 * fin.size().x, 2, &main);
    }
    for y in [0.1, 0.86] {
        m.mesh.crisp(b.inset(0.01 * a.w, 0.0, 0.3 * a.d).y(y * a.h..(y + 0.05) * a.h), &main);
    }
    m
}

/// Air conditioners and heaters: a case with slats.
pub(super) fn air_conditioner(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::WHITE);
    m.solid(b);
    let deep = 0.06 * a.d;
    m.mesh.rounded(b.z(b.min.z..b.max.z - deep), 0.03, 3, &main);
    let (lo, hi) = if a.h > 0.8 { (0.62, 0.92) } else { (0.1, 0.4) };
    let grille = b.inset(0.06 * a.w, 0.0, 0.0).y(lo * a.h..hi * a.h).z(b.max.z - deep..b.max.z);
    m.mesh.crisp(grille.z(grille.min.z..grille.min.z + 0.2 * deep), &stuff::DARK_PLASTIC.surface());
    for slat in grille.split(1, 5, 0.02) {
        m.mesh.crisp(slat, &shade(&main, 0.93));
    }
    m.mesh.crisp(
        b.x(b.max.x - 0.16 * a.w..b.max.x - 0.1 * a.w)
            .y(0.52 * a.h..0.55 * a.h)
            .z(b.max.z - deep..b.max.z - 0.8 * deep),
        &stuff::GREEN_LIGHT.surface(),
    );
    m
}

/// A fan on a stand, or from the ceiling.
pub(super) fn fan(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::WHITE);
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    if a.says(&["ceiling"]) {
        let hub = b.y(0.0..0.4 * a.h);
        m.solid_drum(hub);
        let r = 0.1 * x.min(z);
        m.drum(block(-r..r, 0.4 * a.h..a.h, -r..r), &stuff::STEEL.surface());
        m.mesh.drum(block(-2.0 * r..2.0 * r, 0.0..0.4 * a.h, -2.0 * r..2.0 * r), &main);
        m.mesh.stretch(b.y(0.12 * a.h..0.22 * a.h), |mesh| {
            for k in 0..4 {
                let yaw = f64::from(k) * std::f64::consts::FRAC_PI_2;
                let at = |r: f64| Vec3::new(yaw.cos() * r, 0.0, yaw.sin() * r);
                mesh.sweep(
                    &[(at(0.1), 0.08, 0.01), (at(0.3), 0.13, 0.012), (at(1.0), 0.13, 0.012)],
                    Vec3::y(),
                    6,
                    &stuff::OAK.surface(),
                );
            }
        });
        return m;
    }
    let foot = 0.04 * a.h;
    m.lathe(b.y(0.0..foot), &[(0.6, 0.0), (0.62, 0.3), (0.5, 0.7), (0.1, 1.0)].map(|(r, y)| (r / 0.62, y)), &main);
    let cage = (0.4 * a.h).min(a.w);
    let r = 0.06 * x.min(z);
    m.drum(block(-r..r, foot..a.h - 0.5 * cage, -r..r), &stuff::STEEL.surface());
    let head = block(-x..x, a.h - cage..a.h, -0.5 * z..0.5 * z);
    m.solid(head);
    m.mesh.stretch(head, |mesh| {
        mesh.place(Vec3::zeros(), [90.0, 0.0, 0.0], |mesh| {
            mesh.lathe(
                block(-1.0..1.0, 0.0..0.5, -1.0..1.0),
                &[(1.0, 0.4), (1.0, 0.6), (0.94, 0.6), (0.94, 0.4)],
                32,
                &main,
            );
            mesh.lathe(
                block(-0.2..0.2, 0.0..0.5, -0.2..0.2),
                &[(0.7, 0.0), (1.0, 0.3), (1.0, 0.8), (0.6, 1.0)],
                24,
                &main,
            );
            for k in 0..24 {
                let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / 24.0).sin_cos();
                let at = |r: f64, y: f64| Vec3::new(cos * r, y, sin * r);
                mesh.sweep(
                    &[(at(0.15, 0.45), 0.012, 0.012), (at(0.6, 0.48), 0.012, 0.012), (at(0.97, 0.26), 0.012, 0.012)],
                    Vec3::y(),
                    4,
                    &main,
                );
            }
            for k in 0..3 {
                let yaw = std::f64::consts::TAU * f64::from(k) / 3.0;
                let at = |r: f64| Vec3::new(yaw.cos() * r, 0.24, yaw.sin() * r);
                mesh.sweep(
                    &[(at(0.1), 0.1, 0.02), (at(0.5), 0.28, 0.02), (at(0.85), 0.18, 0.02)],
                    Vec3::new(0.3 * yaw.sin(), 1.0, -0.3 * yaw.cos()),
                    6,
                    &stuff::GLASS.surface(),
                );
            }
        });
    });
    m
}

/// What nobody has a shape for: a rounded box.
pub(crate) fn unknown(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(Stuff(Finish::Plastic, 0xb9c0c8));
    m.rounded(a.whole(), 0.12 * a.whole().size().min().min(0.4), &main);
    m
}
