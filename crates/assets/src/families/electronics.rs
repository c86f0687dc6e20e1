//! Screens, computers, printers and other devices. Screens look to +z.

use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;
use scenelang_layout::Vec3;

/// A lit display with a few windows on it, on the front of `b` (its whole depth is used).
fn display(m: &mut BuiltModel, b: Block, busy: bool) {
    let size = b.size();
    m.mesh.crisp(b.z(b.min.z..b.min.z + 0.4 * size.z), &stuff::SCREEN.surface());
    if !busy {
        return;
    }
    let at = |x0: f64, x1: f64, y0: f64, y1: f64, k: f64| {
        // Seen from the front, +x is on the left.
        let (x, y) = (b.max.x, b.min.y);
        block(
            x - x1 * size.x..x - x0 * size.x,
            y + y0 * size.y..y + y1 * size.y,
            b.min.z..b.min.z + (0.4 + k * 0.2) * size.z,
        )
    };
    let lit = |hex: u32| Stuff(Finish::Screen, hex).surface();
    m.mesh.crisp(at(0.05, 0.62, 0.12, 0.92, 1.0), &lit(0xe9eef2));
    m.mesh.crisp(at(0.05, 0.62, 0.86, 0.92, 2.0), &lit(0x4a86c5));
    for (k, end) in [0.52, 0.57, 0.4, 0.55, 0.3].into_iter().enumerate() {
        let y = 0.75 - 0.13 * k as f64;
        m.mesh.crisp(at(0.09, end, y, y + 0.05, 2.0), &lit(0xb4bfca));
    }
    m.mesh.crisp(at(0.66, 0.95, 0.56, 0.92, 1.0), &lit(0x3f9a83));
    m.mesh.crisp(at(0.66, 0.95, 0.12, 0.5, 1.0), &lit(0xd9a441));
}

/// Monitors and televisions: a panel on a foot; where it is too shallow for a foot, or hung, the panel alone.
pub(super) fn monitor(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.tinted(stuff::DARK_PLASTIC);
    let tv = a.says(&["tv", "television", "signage", "display", "directory"]);
    let hung = a.d < 0.12 * a.h || a.d < 0.03 || a.says(&["wall", "mounted", "hanging"]);
    let thin = if hung { a.d } else { 0.035_f64.min(0.22 * a.d) };
    let low = if hung {
        0.0
    } else if tv {
        0.09 * a.h
    } else {
        0.24 * a.h
    };
    let foot = 0.015_f64.min(0.3 * low);
    let panel = if hung { b } else { b.y(low..a.h).z(-0.5 * thin..0.5 * thin) };
    m.solid(panel);
    let glass = 0.25 * thin;
    m.mesh.board(panel.z(panel.min.z..panel.max.z - 0.6 * glass), &main);
    let rim = 0.012_f64.min(0.04 * a.w);
    let face = panel.inset(rim, rim, 0.0).z(panel.max.z - 0.6 * glass..panel.max.z);
    super::openings::frame(&mut m, panel.z(panel.max.z - 0.6 * glass..panel.max.z), rim, rim, 1.6 * rim, &main);
    display(&mut m, face.z(face.min.z..face.min.z + 0.7 * face.size().z), !tv);
    if !hung {
        let (half, neck) = if tv { (0.3 * a.w, 0.12 * a.w) } else { (0.22 * a.w, 0.05 * a.w) };
        m.board(block(-half..half, 0.0..foot, b.min.z..b.max.z), &main);
        m.board(block(-neck..neck, foot..low + 0.2 * a.h, -0.5 * thin - 0.12 * a.d..-0.5 * thin), &main);
    }
    m
}

/// A laptop: open, its lid leaning back; closed if it is flat.
pub(super) fn laptop(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Metal, 0xb9bdc2));
    if a.h < 0.12 * a.d {
        let lid = b.y(0.5 * a.h..a.h);
        m.rounded(b.y(0.0..0.5 * a.h), 0.006, &main);
        m.rounded(lid, 0.006, &main);
        m.lid("lid", lid);
        return m;
    }
    let base = 0.018_f64.min(0.12 * a.h);
    let lean = 0.16 * a.d;
    let thin = 0.012_f64.min(0.12 * a.d);
    let deck = b.y(0.0..base).z(b.min.z + lean..b.max.z);
    m.rounded(deck, 0.006, &main);
    keys(
        &mut m,
        deck.inset(0.06 * a.w, 0.0, 0.0)
            .z(deck.min.z + 0.1 * deck.size().z..deck.min.z + 0.6 * deck.size().z)
            .y(base..base + 0.0012_f64.min(0.02 * a.h)),
        5,
        12,
        &stuff::DARK_PLASTIC.surface(),
    );
    let pad = block(
        -0.14 * a.w..0.14 * a.w,
        base..base + 0.0006_f64.min(0.01 * a.h),
        b.max.z - 0.3 * deck.size().z..b.max.z - 0.05 * deck.size().z,
    );
    m.mesh.crisp(pad, &shade(&main, 0.85));
    // The lid is a sheared box, from the hinge to the back of the box.
    let hinge = b.min.z + lean;
    let lid = [(0.0, hinge), (0.0, hinge + thin), (a.h, b.min.z + thin), (a.h, b.min.z)];
    m.extrude(0, &lid, b.min.x..b.max.x, &main);
    let glass = |y: f64, off: f64| (y * a.h, hinge + thin - y * lean + off);
    let off = 0.12 * thin;
    let face = [glass(0.16, 0.0), glass(0.16, off), glass(0.95, off), glass(0.95, 0.0)];
    m.mesh.extrude(0, &face, -0.465 * a.w..0.465 * a.w, &stuff::SCREEN.surface());
    let text = |lo: f64, hi: f64| [glass(lo, off), glass(lo, 1.6 * off), glass(hi, 1.6 * off), glass(hi, off)];
    m.mesh.extrude(0, &text(0.25, 0.86), -0.4 * a.w..0.12 * a.w, &Stuff(Finish::Screen, 0xe9eef2).surface());
    m.mesh.extrude(0, &text(0.25, 0.86), 0.16 * a.w..0.4 * a.w, &Stuff(Finish::Screen, 0x4a86c5).surface());
    m
}

/// Rows of keys that fill a thin box.
fn keys(m: &mut BuiltModel, b: Block, rows: usize, columns: usize, s: &Surface) {
    for row in b.split(2, rows, 0.004) {
        for key in row.split(0, columns, 0.004) {
            m.mesh.crisp(key, s);
        }
    }
}

/// A keyboard with rows of keys.
pub(super) fn keyboard(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::DARK_PLASTIC);
    m.solid(b);
    m.mesh.rounded(b.y(0.0..0.6 * a.h), 0.01, 2, &main);
    keys(&mut m, b.inset(0.025 * a.w, 0.0, 0.08 * a.d).y(0.55 * a.h..a.h), 5, 14, &shade(&main, 1.35));
    m
}

/// Small things held in the hand: mice, phones, remote controls.
pub(super) fn gadget(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::DARK_PLASTIC);
    m.solid(b);
    if a.says(&["mouse"]) {
        m.mesh.rounded(b, 0.45 * b.size().min(), 4, &main);
    } else {
        m.mesh.rounded(b.y(0.0..0.9 * a.h), 0.4 * a.h, 2, &main);
        m.mesh.crisp(b.inset(0.05 * a.w, 0.0, 0.04 * a.d).y(0.85 * a.h..a.h), &stuff::SCREEN.surface());
    }
    m
}

/// A computer's case, with a light and slots on its front.
pub(super) fn computer(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::DARK_PLASTIC);
    m.solid(b);
    let front = 0.04 * a.d;
    m.mesh.board(b.z(b.min.z..b.max.z - front), &main);
    let face = b.inset(0.04 * a.w, 0.02 * a.h, 0.0).z(b.max.z - front..b.max.z);
    m.mesh.board(face.y(face.min.y..face.min.y + 0.7 * a.h), &shade(&main, 1.25));
    m.mesh.crisp(face.y(0.78 * a.h..0.8 * a.h), &stuff::GRAY_PLASTIC.surface());
    m.mesh.crisp(face.inset(0.4 * a.w, 0.0, 0.0).y(0.9 * a.h..0.92 * a.h), &Stuff(Finish::Glow, 0x5fd0ff).surface());
    m
}

/// Desk printers, and copiers that stand on the floor with paper drawers.
pub(super) fn printer(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::PLASTIC);
    let dark = stuff::DARK_PLASTIC.surface();
    m.solid(b);
    let tall = a.h > 0.7;
    let neck = if tall { 0.66 } else { 0.34 } * a.h;
    let lid = a.h - if tall { 0.1 } else { 0.22 } * a.h;
    m.mesh.rounded(b.y(0.0..neck), 0.015, 2, &main);
    m.mesh.board(b.inset(0.06 * a.w, 0.0, 0.0).y(neck..lid).z(b.min.z..b.max.z - 0.4 * a.d), &main);
    m.mesh.board(b.inset(0.14 * a.w, 0.0, 0.08 * a.d).y(neck..neck + 0.03 * a.h), &dark);
    m.mesh.rounded(b.y(lid..a.h), 0.02, 2, &shade(&main, 0.92));
    let pillar = b.x(b.min.x..b.min.x + 0.16 * a.w).y(neck..lid);
    m.mesh.board(pillar.z(b.min.z..b.max.z - 0.05 * a.d), &main);
    let panel = b
        .x(b.max.x - 0.32 * a.w..b.max.x - 0.04 * a.w)
        .y(lid - 0.5 * (lid - neck)..lid)
        .z(b.max.z - 0.4 * a.d..b.max.z - 0.1 * a.d);
    m.mesh.board(panel, &dark);
    if tall {
        for tray in b.y(0.06 * a.h..neck - 0.04 * a.h).split(1, 3, 0.01) {
            let tray = tray.inset(0.05 * a.w, 0.004, 0.0);
            let grip = tray.inset(0.25 * a.w, 0.4 * tray.size().y, 0.0).z(b.max.z - 0.004 * a.d..b.max.z);
            m.mesh.crisp(grip, &dark);
        }
    } else {
        m.mesh.crisp(b.inset(0.2 * a.w, 0.0, 0.0).y(0.08 * a.h..0.14 * a.h).z(b.max.z - 0.004 * a.d..b.max.z), &dark);
    }
    m
}

/// A projector; its lens looks to +z.
pub(super) fn projector(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::PLASTIC);
    let deep = 0.1 * a.d;
    let foot = 0.06 * a.h;
    let body = b.z(b.min.z..b.max.z - deep).y(foot..a.h);
    m.solid(body.y(0.0..a.h));
    m.mesh.rounded(body, 0.02, 3, &main);
    for c in body
        .y(0.0..foot)
        .x(b.min.x + 0.08 * a.w..b.min.x + 0.16 * a.w)
        .z(body.min.z + 0.06 * a.d..body.min.z + 0.14 * a.d)
        .both_sides()
    {
        m.mesh.crisp(c, &stuff::RUBBER.surface());
        m.mesh.crisp(c.moved(0.0, 0.0, 0.7 * a.d), &stuff::RUBBER.surface());
    }
    let r = (0.32 * a.h).min(0.16 * a.w);
    let c = Vec3::new(0.24 * a.w, 0.54 * a.h, 0.0);
    let lens = block(c.x - r..c.x + r, c.y - r..c.y + r, b.max.z - 1.4 * deep..b.max.z);
    m.solid(lens);
    m.mesh.stretch(lens, |mesh| {
        mesh.place(Vec3::zeros(), [90.0, 0.0, 0.0], |mesh| {
            let ring = [(1.0, 0.0), (1.0, 1.0), (0.8, 1.0), (0.7, 0.6)];
            mesh.lathe(block(-1.0..1.0, 0.0..1.0, -1.0..1.0), &ring, 24, &stuff::DARK_PLASTIC.surface());
            mesh.lathe(
                block(-0.7..0.7, 0.6..0.75, -0.7..0.7),
                &[(1.0, 0.0), (0.7, 0.7), (0.0, 1.0)],
                24,
                &Stuff(Finish::Screen, 0x7fb4e8).surface(),
            );
        });
    });
    for k in 0..5 {
        let x = -0.4 * a.w + 0.07 * a.w * f64::from(k);
        m.mesh.crisp(
            block(x..x + 0.03 * a.w, 0.3 * a.h..0.75 * a.h, body.max.z..body.max.z + 0.05 * deep),
            &stuff::GRAY_PLASTIC.surface(),
        );
    }
    m
}

/// A loudspeaker with its cones.
pub(super) fn speaker(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::DARK_PLASTIC);
    m.solid(b);
    let deep = 0.04 * a.d;
    m.mesh.rounded(b.z(b.min.z..b.max.z - deep), 0.01, 2, &main);
    let (x, front) = (0.36 * a.w, b.max.z - deep..b.max.z);
    for (y, r) in [(0.32, 1.0), (0.74, 0.55)] {
        let (rx, ry) = (x * r, (x * r).min(0.22 * a.h));
        let ring = block(-rx..rx, y * a.h - ry..y * a.h + ry, front.clone());
        m.mesh.stretch(ring, |mesh| {
            mesh.place(Vec3::zeros(), [90.0, 0.0, 0.0], |mesh| {
                mesh.lathe(
                    block(-1.0..1.0, 0.0..1.0, -1.0..1.0),
                    &[(1.0, 0.0), (1.0, 1.0), (0.86, 1.0), (0.3, 0.2), (0.2, 0.6), (0.0, 0.8)],
                    24,
                    &stuff::GRAY_PLASTIC.surface(),
                );
            });
        });
    }
    m
}

/// A till: a slanted body with keys, a display on a neck.
pub(super) fn till(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::DARK_PLASTIC);
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    m.board(b.y(0.0..0.25 * a.h), &main);
    m.extrude(
        0,
        &[(0.25 * a.h, -z), (0.25 * a.h, z), (0.3 * a.h, z), (0.48 * a.h, -z)],
        -0.92 * x..0.92 * x,
        &shade(&main, 1.3),
    );
    m.board(block(-0.12 * x..0.12 * x, 0.4 * a.h..0.6 * a.h, -0.85 * z..-0.6 * z), &main);
    let screen = block(-0.85 * x..0.85 * x, 0.55 * a.h..a.h, -0.8 * z..-0.62 * z);
    m.board(screen, &main);
    display(&mut m, screen.inset(0.05 * a.w, 0.03 * a.h, 0.0).z(-0.62 * z..-0.58 * z), true);
    m
}

/// Tall machines with a lit face: vending, cash, tickets, games, information.
pub(super) fn kiosk(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let vending = a.says(&["vending", "snack", "drink", "beverage"]);
    let main = a.main(if vending { Stuff(Finish::Paint, 0xa8322c) } else { Stuff(Finish::Paint, 0x3b4754) });
    m.solid(b);
    let deep = 0.06 * a.d;
    m.mesh.rounded(b.z(b.min.z..b.max.z - deep), 0.02, 2, &main);
    let face = b.z(b.max.z - deep..b.max.z);
    if vending {
        let window = face.x(b.max.x - 0.68 * a.w..b.max.x - 0.06 * a.w).y(0.3 * a.h..0.94 * a.h);
        m.mesh.crisp(window.z(face.min.z..face.min.z + 0.1 * deep), &Stuff(Finish::Screen, 0xdfe8ec).surface());
        let mut dice = a.dice();
        for row in window.split(1, 5, 0.0) {
            for item in row.split(0, 5, 0.0) {
                let item = item.inset(0.2 * item.size().x, 0.0, 0.0).y(item.min.y..item.min.y + 0.7 * item.size().y);
                let s = Stuff(Finish::Paper, *dice.pick(&[0xd8574a, 0xe8b84a, 0x4a8fc2, 0x6aa860, 0x8a5fa8])).surface();
                m.mesh.crisp(item.z(face.min.z + 0.1 * deep..face.min.z + 0.5 * deep), &s);
            }
        }
        m.mesh.crisp(window.z(face.max.z - 0.2 * deep..face.max.z), &stuff::GLASS.surface());
        m.mesh.board(
            face.x(b.min.x + 0.06 * a.w..b.max.x - 0.75 * a.w).y(0.45 * a.h..0.75 * a.h),
            &stuff::DARK_PLASTIC.surface(),
        );
        m.mesh.board(
            face.x(b.max.x - 0.64 * a.w..b.max.x - 0.1 * a.w).y(0.1 * a.h..0.2 * a.h),
            &stuff::DARK_PLASTIC.surface(),
        );
    } else {
        let screen = face.inset(0.12 * a.w, 0.0, 0.0).y(0.5 * a.h..0.86 * a.h);
        m.mesh.board(
            screen.inset(-0.03 * a.w, -0.015 * a.h, 0.0).z(face.min.z..face.max.z - 0.3 * deep),
            &stuff::DARK_PLASTIC.surface(),
        );
        display(&mut m, screen.z(face.max.z - 0.3 * deep..face.max.z), true);
        m.mesh.board(face.inset(0.12 * a.w, 0.0, 0.0).y(0.36 * a.h..0.44 * a.h), &stuff::STEEL.surface());
        m.mesh.board(
            face.inset(0.3 * a.w, 0.0, 0.0).y(0.9 * a.h..0.95 * a.h).z(face.min.z..face.max.z - 0.5 * deep),
            &Stuff(Finish::Glow, 0xf2f5f7).surface(),
        );
    }
    m
}

/// Boxes with a panel and a display: laboratory and office machines without a family of their own.
pub(super) fn device(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::PLASTIC);
    m.solid(b);
    let deep = 0.04 * a.d;
    m.mesh.rounded(b.z(b.min.z..b.max.z - deep), 0.012, 2, &main);
    let face = b.inset(0.05 * a.w, 0.06 * a.h, 0.0).z(b.max.z - deep..b.max.z);
    m.mesh.board(face.z(face.min.z..face.min.z + 0.5 * deep), &shade(&main, 0.82));
    let screen = face
        .x(face.min.x + 0.05 * a.w..face.min.x + 0.5 * a.w)
        .y(face.max.y - 0.5 * face.size().y..face.max.y - 0.12 * face.size().y);
    display(&mut m, screen.z(face.min.z + 0.5 * deep..face.max.z), false);
    for (k, knob) in
        face.x(face.max.x - 0.32 * a.w..face.max.x - 0.05 * a.w).split(0, pieces(a.w, 0.12, 2, 4), 0.0).enumerate()
    {
        let (c, r) = (knob.center(), 0.3 * knob.size().x.min(0.3 * a.h));
        let s = if k == 0 { stuff::RED } else { stuff::DARK_PLASTIC }.surface();
        m.mesh.crisp(block(c.x - r..c.x + r, c.y - r..c.y + r, face.min.z + 0.5 * deep..face.max.z), &s);
    }
    m
}
