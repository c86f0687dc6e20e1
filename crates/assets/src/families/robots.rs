//! Workshops and laboratories: robots, carts, pallets, machines, tanks.

use super::kitchen::dial;
use super::tables::drawers;
use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::BuiltModel;
use scenelang_layout::Vec3;

/// An arm with two links on a pedestal, reaching to +z.
pub(super) fn robot_arm(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Paint, 0xe8792b));
    let dark = a.second(stuff::DARK_PLASTIC);
    let steel = stuff::STEEL.surface();
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    // A plate that carries the weight of what leans out.
    let plate = 0.04 * a.h;
    m.board(b.y(0.0..plate).z(-z..0.7 * z), &dark);
    let shoulder = -0.3 * z;
    let r = 0.5 * x.min(0.55 * z);
    let pedestal = block(-r..r, plate..0.34 * a.h, shoulder - r..shoulder + r);
    m.lathe(
        pedestal,
        &[(1.0, 0.0), (1.0, 0.1), (0.8, 0.2), (0.78, 0.82), (0.95, 0.86), (0.95, 1.0)],
        &stuff::GRAY.surface(),
    );
    let turret = block(-0.9 * r..0.9 * r, 0.34 * a.h..0.46 * a.h, shoulder - 0.9 * r..shoulder + 0.9 * r);
    m.drum(turret, &main);
    let t = (0.42 * r).min(0.05 * a.h);
    let joint = (0.46 * a.h, shoulder);
    let motor = (0.08 * a.h).min(0.4 * z);
    let elbow = (a.h - motor, shoulder - 0.25 * z);
    let wrist = (0.78 * a.h, z - 0.2 * z);
    for (from, to, half, s) in [(joint, elbow, 0.5 * r, &main), (elbow, wrist, 0.36 * r, &main)] {
        let (dy, dz) = (to.0 - from.0, to.1 - from.1);
        let length = dy.hypot(dz).max(1e-9);
        let (ny, nz) = (-dz / length * t, dy / length * t);
        let quad = [
            (from.0 + ny, from.1 + nz),
            (from.0 - ny, from.1 - nz),
            (to.0 - 0.7 * ny, to.1 - 0.7 * nz),
            (to.0 + 0.7 * ny, to.1 + 0.7 * nz),
        ];
        let fit = quad.map(|(y, z_)| (y.min(a.h), z_.clamp(-z, z)));
        m.extrude(0, &fit, -half..half, s);
    }
    // The motors at the joints, across.
    let low = (joint.0 + 0.02 * a.h, joint.1, motor.min(0.8 * r), 0.75 * r);
    for (y, z_, r_, half) in [low, (elbow.0, elbow.1, motor, 0.62 * r)] {
        let hub = block(-half..half, y - r_..y + r_, z_ - r_..z_ + r_);
        m.solid(hub);
        m.mesh.stretch(hub, |mesh| {
            mesh.place(Vec3::zeros(), [0.0, 0.0, 90.0], |mesh| mesh.drum(block(-1.0..1.0, 0.0..1.0, -1.0..1.0), &dark));
        });
    }
    let hand = block(-0.3 * r..0.3 * r, 0.66 * a.h..0.84 * a.h, z - 0.3 * z..z - 0.12 * z);
    m.board(hand, &steel);
    for finger in block(-0.28 * r..-0.12 * r, 0.55 * a.h..0.66 * a.h, z - 0.28 * z..z - 0.14 * z).both_sides() {
        m.board(finger, &dark);
    }
    m.board(block(-0.2 * r..0.2 * r, 0.72 * a.h..0.8 * a.h, z - 0.12 * z..z), &dark);
    m
}

/// A low carrier on wheels with a laser scanner; tall ones have a mast with a face.
pub(super) fn mobile_robot(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Plastic, 0xf0f1f2));
    let dark = stuff::DARK_PLASTIC.surface();
    let light = Stuff(Finish::Glow, 0x3fb6ff).surface();
    let tall = a.h > 1.1 * a.w.min(a.d);
    let body = b.y(0.0..if tall { 0.34 * a.h } else { 0.78 * a.h });
    let gap = 0.12 * body.size().y;
    m.solid(body);
    m.mesh.rounded(body.y(gap..body.max.y), 0.25 * body.size().min(), 4, &main);
    m.mesh.board(body.inset(0.06 * a.w, 0.0, 0.06 * a.d).y(0.3 * gap..gap * 1.5), &dark);
    let belt =
        body.inset(-0.0, 0.0, -0.0).y(body.max.y - 0.42 * (body.max.y - gap)..body.max.y - 0.34 * (body.max.y - gap));
    m.mesh.crisp(belt.inset(0.2 * a.w, 0.0, 0.0).z(b.max.z - 0.02 * a.d..b.max.z), &light);
    let r = (0.34 * body.max.y).min(0.2 * a.d);
    for wheel in block(b.min.x + 0.02 * a.w..b.min.x + 0.12 * a.w, 0.0..2.0 * r, -r..r).both_sides() {
        m.mesh.stretch(wheel, |mesh| {
            mesh.place(Vec3::zeros(), [0.0, 0.0, 90.0], |mesh| {
                mesh.drum(block(-1.0..1.0, 0.0..1.0, -1.0..1.0), &stuff::RUBBER.surface())
            });
        });
    }
    let r = 0.18 * a.w.min(a.d);
    if tall {
        let mast = 0.16 * a.w.min(a.d);
        m.board(block(-mast..mast, body.max.y..0.78 * a.h, -0.8 * mast..0.8 * mast), &stuff::GRAY.surface());
        let head = b.y(0.76 * a.h..a.h).inset(0.14 * a.w, 0.0, 0.18 * a.d);
        m.solid(head);
        m.mesh.rounded(head, 0.3 * head.size().min(), 4, &main);
        let face = head.inset(0.08 * a.w, 0.05 * a.h, 0.0).z(head.max.z - 0.01 * a.d..head.max.z + 0.015 * a.d);
        m.mesh.board(face, &stuff::SCREEN.surface());
        for eye in
            block(-0.13 * a.w..-0.06 * a.w, 0.87 * a.h..0.91 * a.h, face.max.z..face.max.z + 0.01 * a.d).both_sides()
        {
            m.mesh.crisp(eye, &light);
        }
    } else {
        m.drum(block(-r..r, body.max.y..0.92 * a.h, 0.1 * a.d - r..0.1 * a.d + r), &dark);
        m.drum(block(-0.8 * r..0.8 * r, 0.92 * a.h..a.h, 0.1 * a.d - 0.8 * r..0.1 * a.d + 0.8 * r), &main);
    }
    m
}

/// Trolleys: trays between posts on castors; tool trolleys are chests, shopping ones baskets.
pub(super) fn cart(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let medical = a.says(&["medical", "crash", "medicine", "medication"]);
    let tools = medical || a.says(&["tool", "drawer"]);
    let main = a.main(match () {
        () if medical => stuff::WHITE,
        () if tools => stuff::RED,
        () => stuff::STEEL,
    });
    let wheel = 0.11_f64.min(0.16 * a.h).min(0.4 * a.d).min(0.4 * a.w);
    let half = 0.5 * wheel;
    let place = block(
        b.min.x + 0.02 * a.w..b.min.x + 0.02 * a.w + half,
        0.0..wheel,
        b.min.z + 0.02 * a.d..b.min.z + 0.02 * a.d + wheel,
    );
    for w in place.four_corners() {
        m.solid(w);
        m.mesh.stretch(w, |mesh| {
            mesh.place(Vec3::zeros(), [0.0, 0.0, 90.0], |mesh| {
                mesh.drum(block(-1.0..1.0, 0.0..1.0, -1.0..1.0), &stuff::RUBBER.surface())
            });
        });
    }
    if tools {
        m.solid(b.y(wheel..a.h));
        let deep = 0.05 * a.d;
        m.mesh.board(b.y(wheel..a.h - 0.03 * a.h).z(b.min.z..b.max.z - deep), &main);
        let top = if medical { stuff::STEEL } else { stuff::RUBBER };
        m.mesh.board(b.y(a.h - 0.03 * a.h..a.h), &top.surface());
        drawers(
            &mut m,
            b.inset(0.02 * a.w, 0.0, 0.0).y(wheel + 0.02 * a.h..a.h - 0.04 * a.h),
            pieces(a.h, 0.16, 2, 7),
            deep,
            &if medical { Stuff(Finish::Paint, 0x7fb2c9).surface() } else { shade(&main, 1.08) },
            &stuff::STEEL.surface(),
        );
        return m;
    }
    let t = 0.025_f64.min(0.08 * a.w).min(0.08 * a.d);
    let tray = 0.06_f64.min(0.1 * a.h);
    for post in b.x(b.min.x..b.min.x + t).z(b.min.z..b.min.z + t).four_corners() {
        m.board(post.y(wheel..a.h), &main);
    }
    let trays = if a.h > 0.7 { 3 } else { 2 };
    for k in 0..trays {
        let y = wheel + (a.h - tray - wheel) * k as f64 / (trays - 1) as f64;
        let floor = b.inset(0.3 * t, 0.0, 0.3 * t);
        // The top tray is level with the box: what is put on it stands on an even face.
        m.board(floor.y(if k + 1 == trays { a.h - 0.4 * tray..a.h } else { y..y + 0.4 * tray }), &main);
    }
    m
}

/// Boards on blocks.
pub(super) fn pallet(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::BIRCH);
    m.solid(b);
    let t = 0.18 * a.h;
    for board in b.y(a.h - t..a.h).split(2, pieces(a.d, 0.16, 3, 9), 0.04) {
        m.mesh.crisp(board, &main);
    }
    for row in b.y(t..a.h - t).split(2, 3, 1.0) {
        for cube in row.split(0, 3, 1.0) {
            m.mesh.crisp(cube.inset(0.12 * cube.size().x, 0.0, 0.1 * cube.size().z), &shade(&main, 0.85));
        }
    }
    for board in b.y(0.0..t).split(2, 3, 0.2) {
        m.mesh.crisp(board, &main);
    }
    m
}

/// A belt over rollers on legs.
pub(super) fn conveyor(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::GRAY);
    let bed = 0.12_f64.min(0.3 * a.h);
    m.solid(b.y(a.h - bed..a.h));
    let rail = 0.06 * a.d;
    for side in b.y(a.h - bed..a.h - 0.1 * bed).z(b.min.z..b.min.z + rail).four_corners().into_iter().step_by(2) {
        m.mesh.board(side, &main);
    }
    m.mesh.rounded(b.y(a.h - 0.8 * bed..a.h).inset(0.0, 0.0, rail), 0.3 * bed, 4, &a.second(stuff::RUBBER));
    m.legs(b.y(0.0..a.h - bed).inset(0.06 * a.w, 0.0, 0.02), 0.06, &main);
    m
}

/// A machine tool or 3D printer: a case with a window and a panel on an arm.
pub(super) fn machine(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::GRAY);
    m.solid(b);
    let deep = 0.08 * a.d;
    m.mesh.rounded(b.z(b.min.z..b.max.z - deep), 0.03, 2, &main);
    let face = b.z(b.max.z - deep..b.max.z);
    let window = face.x(b.max.x - 0.66 * a.w..b.max.x - 0.1 * a.w).y(0.34 * a.h..0.84 * a.h);
    m.mesh
        .board(window.inset(-0.03 * a.w, -0.03 * a.h, 0.0).z(face.min.z..face.max.z - 0.5 * deep), &shade(&main, 0.6));
    m.mesh.crisp(window.z(face.min.z..face.max.z - 0.3 * deep), &Stuff(Finish::Screen, 0x35505f).surface());
    let panel = face.x(b.min.x + 0.05 * a.w..b.min.x + 0.25 * a.w).y(0.5 * a.h..0.84 * a.h);
    m.mesh.board(panel.z(face.min.z..face.max.z - 0.3 * deep), &stuff::DARK_PLASTIC.surface());
    let size = panel.size();
    m.mesh.crisp(
        panel
            .inset(0.12 * size.x, 0.0, 0.0)
            .y(panel.max.y - 0.5 * size.y..panel.max.y - 0.1 * size.y)
            .z(face.max.z - 0.3 * deep..face.max.z - 0.2 * deep),
        &Stuff(Finish::Screen, 0x4a9bc5).surface(),
    );
    let r = 0.16 * size.x.min(size.y);
    let c = panel.center();
    dial(
        &mut m.mesh,
        block(
            c.x - r..c.x + r,
            panel.min.y + 0.1 * size.y..panel.min.y + 0.1 * size.y + 2.0 * r,
            face.max.z - 0.3 * deep..face.max.z,
        ),
        &[(1.0, 0.0), (1.0, 0.6), (0.8, 1.0)],
        &stuff::RED.surface(),
    );
    m.mesh.board(
        face.y(0.03 * a.h..0.28 * a.h).inset(0.06 * a.w, 0.0, 0.0).z(face.min.z..face.max.z - 0.6 * deep),
        &shade(&main, 0.9),
    );
    m
}

/// Gas bottles, boilers, barrels.
pub(super) fn tank(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    if a.says(&["wine", "wooden", "oak", "cask"]) {
        let hoop = stuff::BLACK_STEEL.surface();
        m.lathe(b, &[(0.8, 0.0), (0.92, 0.2), (0.97, 0.4), (0.97, 0.6), (0.92, 0.8), (0.8, 1.0)], &a.main(stuff::OAK));
        for (at, wide) in [(0.04, 0.86), (0.26, 0.96), (0.47, 1.0), (0.68, 0.96), (0.9, 0.86)] {
            let by = (1.0 - wide) / 2.0;
            m.mesh.drum(b.share(by..1.0 - by, at..at + 0.06, by..1.0 - by), &hoop);
        }
        return m;
    }
    if a.says(&["barrel", "drum", "keg"]) {
        let main = a.main(Stuff(Finish::Paint, 0x3a6a9a));
        let ribs = [
            (0.95, 0.0),
            (1.0, 0.02),
            (0.97, 0.04),
            (0.97, 0.33),
            (1.0, 0.35),
            (0.97, 0.37),
            (0.97, 0.65),
            (1.0, 0.67),
            (0.97, 0.69),
            (0.97, 0.96),
            (1.0, 0.98),
            (0.97, 1.0),
        ];
        m.lathe(b, &ribs, &main);
        return m;
    }
    let main = a.main(Stuff(Finish::Paint, 0x8a98a3));
    m.solid_drum(b);
    m.mesh.lathe(
        b.y(0.0..0.88 * a.h),
        &[(0.96, 0.0), (1.0, 0.02), (1.0, 0.86), (0.9, 0.94), (0.6, 0.99), (0.3, 1.0)],
        24,
        &main,
    );
    m.mesh.drum(b.inset(0.38 * a.w, 0.0, 0.38 * a.d).y(0.86 * a.h..a.h), &stuff::BRASS.surface());
    m
}

/// A charging place for robots: a low ramp before a lit panel.
pub(super) fn dock(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::DARK_PLASTIC);
    let back = b.z(b.min.z..b.min.z + 0.35 * a.d);
    m.rounded(back, 0.02, &main);
    let ramp = 0.12 * a.h;
    m.extrude(
        0,
        &[(0.0, back.max.z), (ramp, back.max.z), (0.1 * ramp, b.max.z), (0.0, b.max.z)],
        b.min.x..b.max.x,
        &shade(&main, 1.3),
    );
    let strip = back.inset(0.2 * a.w, 0.0, 0.0).y(0.7 * a.h..0.76 * a.h).z(back.max.z..back.max.z + 0.01 * a.d);
    m.mesh.crisp(strip, &Stuff(Finish::Glow, 0x48d37f).surface());
    m
}

/// A fume cupboard: work space behind a glass sash, cupboard below.
pub(super) fn fume_hood(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    m.solid(b);
    let main = a.main(stuff::WHITE);
    let dark = shade(&main, 0.5);
    let (low, high) = (0.38 * a.h, 0.86 * a.h);
    let side = 0.07 * a.w;
    m.mesh.board(b.y(0.0..low), &main);
    m.mesh.board(b.y(high..a.h), &main);
    for s in b.x(b.min.x..b.min.x + side).y(low..high).both_sides() {
        m.mesh.board(s, &main);
    }
    let bay = b.inset(side, 0.0, 0.0).y(low..high);
    m.mesh.crisp(bay.z(b.min.z..b.min.z + 0.1 * a.d), &dark);
    m.mesh.crisp(bay.y(low + 0.12 * a.h..high).z(b.max.z - 0.06 * a.d..b.max.z - 0.04 * a.d), &stuff::GLASS.surface());
    m.mesh.board(
        bay.y(low + 0.11 * a.h..low + 0.13 * a.h).z(b.max.z - 0.07 * a.d..b.max.z - 0.02 * a.d),
        &stuff::STEEL.surface(),
    );
    for door in b.inset(0.01 * a.w, 0.0, 0.0).y(0.06 * a.h..low - 0.04 * a.h).z(b.max.z - 0.001 * a.d..b.max.z).split(
        0,
        pieces(a.w, 0.6, 1, 4),
        0.01,
    ) {
        m.mesh.crisp(door, &shade(&main, 0.94));
    }
    m
}

/// A quadcopter: a body, four arms with rotors.
pub(super) fn drone(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b: Block = a.whole();
    let main = a.main(stuff::DARK_PLASTIC);
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let body = b.y(0.0..0.75 * a.h).inset(0.3 * a.w, 0.0, 0.3 * a.d);
    m.solid(body);
    m.mesh.rounded(body.y(0.25 * a.h..0.75 * a.h), 0.1 * a.h, 3, &main);
    for leg in body.x(body.min.x..body.min.x + 0.04 * a.w).both_sides() {
        m.mesh.crisp(leg.y(0.0..0.4 * a.h), &main);
    }
    let rotors = b.y(0.7 * a.h..a.h);
    m.solid(rotors);
    let (rx, rz) = (0.22 * a.w, 0.22 * a.d);
    let arm = (0.05 * a.h).min(0.02 * a.w).min(0.02 * a.d);
    for spot in block(-x..-x + 2.0 * rx, 0.9 * a.h..a.h, -z..-z + 2.0 * rz).four_corners() {
        let c = spot.center();
        m.mesh.rod(Vec3::new(0.3 * c.x, 0.6 * a.h, 0.3 * c.z), Vec3::new(c.x, 0.75 * a.h, c.z), arm, &main);
        m.mesh.drum(
            block(c.x - 0.2 * rx..c.x + 0.2 * rx, 0.7 * a.h..0.92 * a.h, c.z - 0.2 * rz..c.z + 0.2 * rz),
            &stuff::STEEL.surface(),
        );
        m.mesh.drum(spot, &stuff::GLASS.surface());
    }
    m
}
