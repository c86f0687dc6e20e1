//! Lamps: for the floor, the table, the desk, the ceiling and the wall. What shines has a `glow` surface.

use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;
use scenelang_layout::Vec3;
use std::f64::consts::TAU;

/// A square footprint of half width `r` about the axis.
fn about(r: f64, y0: f64, y1: f64) -> Block {
    block(-r..r, y0..y1, -r..r)
}

/// A shade open at both ends that fills `b`, with the bulb's light inside.
fn shade_of(m: &mut BuiltModel, b: Block, top: f64, s: &Surface) {
    m.solid_drum(b);
    let t = 0.03;
    m.mesh.lathe(b, &[(1.0, 0.0), (top, 1.0), (top - t, 1.0), (1.0 - t, 0.02)], 24, s);
    let size = b.size();
    let bulb = b.inset(0.26 * size.x, 0.2 * size.y, 0.26 * size.z);
    m.mesh.ball(bulb, &stuff::WARM.surface());
}

/// A lamp of a kind told by its words, else by its size.
pub(super) fn lamp(a: &Ask) -> BuiltModel {
    if a.says(&["ceiling"]) {
        ceiling_light(a)
    } else if a.says(&["pendant", "hanging"]) {
        pendant(a)
    } else if a.says(&["wall"]) {
        sconce(a)
    } else if a.says(&["desk", "study", "reading", "task", "work"]) && a.h < 0.9 {
        desk_lamp(a)
    } else if a.h > 0.9 {
        floor_lamp(a)
    } else {
        table_lamp(a)
    }
}

/// A round foot, a pole, a shade.
pub(super) fn floor_lamp(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let metal = a.second(stuff::BLACK_STEEL);
    let cloth = a.main(stuff::LINEN);
    let cloth = if crate::looks::is(&cloth, Finish::Fabric) { cloth } else { a.tinted(stuff::LINEN) };
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let foot = 0.035_f64.min(0.1 * a.h);
    let base = block(-0.75 * x..0.75 * x, 0.0..foot, -0.75 * z..0.75 * z);
    m.lathe(base, &[(0.97, 0.0), (1.0, 0.25), (0.96, 0.6), (0.15, 1.0)], &metal);
    let low = a.h - (0.2 * a.h).min(0.9 * a.w);
    let r = 0.014_f64.min(0.1 * x).min(0.1 * z);
    m.drum(about(r, foot, low + 0.5 * (a.h - low)), &metal);
    shade_of(&mut m, a.whole().y(low..a.h), 0.72, &cloth);
    m
}

/// A turned body with a shade.
pub(super) fn table_lamp(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let body = a.second(Stuff(Finish::Ceramic, 0x7fa3a8));
    let cloth = a.tinted(stuff::LINEN);
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let low = 0.52 * a.h;
    let jar = block(-0.62 * x..0.62 * x, 0.0..0.46 * a.h, -0.62 * z..0.62 * z);
    let turned = [(0.62, 0.0), (0.66, 0.06), (0.92, 0.22), (1.0, 0.42), (0.86, 0.66), (0.4, 0.88), (0.24, 1.0)];
    m.lathe(jar, &turned, &body);
    let r = 0.08 * x.min(z);
    m.drum(about(r, 0.46 * a.h, low + 0.4 * (a.h - low)), &stuff::BRASS.surface());
    shade_of(&mut m, a.whole().y(low..a.h), 0.7, &cloth);
    m
}

/// A foot, two arms, a head that leans over the work at +z.
pub(super) fn desk_lamp(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(stuff::BLACK_STEEL);
    let joint = stuff::BRASS.surface();
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let foot = 0.08 * a.h;
    m.lathe(block(-x..x, 0.0..foot, -z..0.35 * z), &[(0.97, 0.0), (1.0, 0.3), (0.96, 0.7), (0.2, 1.0)], &main);
    let r = (0.028 * a.h).min(0.12 * x).min(0.12 * z);
    let (low, elbow, head) = ((foot, -0.32 * z), (0.62 * a.h, -z + 2.0 * r), (a.h - 1.6 * r, 0.3 * z));
    for (from, to) in [(low, elbow), (elbow, head)] {
        m.mesh.rod(Vec3::new(0.0, from.0, from.1), Vec3::new(0.0, to.0, to.1), 0.6 * r, &main);
        let slanted = [(from.0, from.1 - r), (from.0, from.1 + r), (to.0, to.1 + r), (to.0, to.1 - r)];
        let points = [-r, r].into_iter().flat_map(|x| slanted.iter().map(move |&(y, z)| Vec3::new(x, y, z)));
        m.solid_hull(points.collect());
    }
    m.mesh.ball(about(1.3 * r, elbow.0 - 1.3 * r, elbow.0 + 1.3 * r).moved(0.0, 0.0, elbow.1 + 0.7 * r), &joint);
    let hood = block(-0.8 * x..0.8 * x, 0.74 * a.h..a.h, -0.2 * z..z);
    m.solid_drum(hood);
    m.mesh.lathe(hood, &[(1.0, 0.0), (0.82, 0.45), (0.4, 0.85), (0.25, 1.0)], 24, &main);
    let bulb = hood.inset(0.2 * x, 0.0, 0.2 * z);
    m.mesh.drum(bulb.y(0.735 * a.h..0.75 * a.h), &stuff::WARM.surface());
    m
}

/// Hangs: a rose at the ceiling, a cord, a shade or (`globe`, `paper`, `lantern`) a ball.
pub(super) fn pendant(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let metal = a.second(stuff::BLACK_STEEL);
    let b = a.whole();
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let high = (0.62 * a.h).min(0.8 * a.w.max(a.d));
    let rose = 0.03_f64.min(0.1 * a.h);
    let shade = b.y(0.0..high);
    if a.says(&["operating", "surgical", "examination", "dental"]) {
        // A flat head full of small lights on a jointed arm.
        let head = b.y(0.0..0.16 * a.h);
        m.solid_drum(head);
        m.mesh.lathe(head, &[(0.92, 0.0), (1.0, 0.3), (0.7, 0.9), (0.2, 1.0)], 24, &a.main(stuff::WHITE));
        let light = b.share(0.18..0.42, 0.0..1.0, 0.18..0.42).y(0.0..0.02 * a.h);
        for light in light.four_corners() {
            m.mesh.drum(light, &stuff::WARM.surface());
        }
        let r = 0.03_f64.min(0.05 * a.w).min(0.05 * a.d);
        m.drum(about(r, 0.15 * a.h, a.h - rose), &stuff::STEEL.surface());
        m.drum(b.inset(0.75 * x, 0.0, 0.75 * z).y(a.h - rose..a.h), &stuff::WHITE.surface());
        return m;
    }
    if a.says(&["globe", "ball", "paper", "lantern", "sphere"]) {
        m.solid_drum(shade);
        let cut = [(0.35, 0.0), (0.7, 0.1), (0.92, 0.28), (1.0, 0.5), (0.92, 0.72), (0.7, 0.9), (0.35, 1.0)];
        m.mesh.lathe(shade, &cut, 24, &a.tinted(Stuff(Finish::Glow, 0xfff1d6)));
    } else {
        let hood = a.main(stuff::BLACK_STEEL);
        m.solid_drum(shade);
        m.mesh.lathe(shade, &[(1.0, 0.0), (0.97, 0.18), (0.78, 0.55), (0.42, 0.85), (0.16, 1.0)], 24, &hood);
        m.mesh.drum(shade.inset(0.06 * x, 0.0, 0.06 * z).y(0.0..0.02 * high), &stuff::WARM.surface());
    }
    let r = 0.006_f64.min(0.05 * x).min(0.05 * z);
    m.drum(about(r, high, a.h - rose), &metal);
    m.drum(b.inset(0.7 * x, 0.0, 0.7 * z).y(a.h - rose..a.h), &metal);
    m
}

/// Flat against the ceiling: a disc, a panel, or a bar with spots.
pub(super) fn ceiling_light(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let rim = a.main(stuff::WHITE);
    let light = stuff::WARM.surface();
    if a.says(&["track", "spot", "spotlight"]) {
        m.board(b.y(0.6 * a.h..a.h).inset(0.0, 0.0, 0.3 * a.d), &rim);
        let n = pieces(a.w, 0.35, 2, 8);
        for s in b.y(0.0..0.7 * a.h).split(0, n, 0.0) {
            let c = s.center();
            let r = (0.4 * s.size().x).min(0.5 * a.d);
            let can = block(c.x - r..c.x + r, 0.0..0.7 * a.h, -0.5 * a.d..0.5 * a.d);
            m.lathe(can, &[(0.9, 0.03), (1.0, 0.1), (0.7, 1.0)], &rim);
            m.mesh.drum(can.inset(0.2 * r, 0.0, 0.1 * a.d).y(0.0..0.05 * a.h), &light);
        }
        return m;
    }
    let flat =
        a.says(&["panel", "led", "fluorescent", "tube", "square", "office"]) || a.w > 1.5 * a.d || a.d > 1.5 * a.w;
    if flat {
        m.solid(b);
        m.mesh.board(b.y(0.25 * a.h..a.h), &rim);
        m.mesh.board(b.inset(0.05 * a.w, 0.0, 0.05 * a.d).y(0.0..0.3 * a.h), &light);
    } else {
        m.solid_drum(b);
        m.mesh.drum(b.y(0.6 * a.h..a.h), &rim);
        let dome = b.inset(0.05 * a.w, 0.0, 0.05 * a.d).y(0.0..0.62 * a.h);
        m.mesh.lathe(dome, &[(0.35, 0.0), (0.7, 0.08), (0.92, 0.3), (1.0, 0.7), (1.0, 1.0)], 24, &light);
    }
    m
}

/// A ring of candles of light under a stem.
pub(super) fn chandelier(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::BRASS);
    let light = stuff::WARM.surface();
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let rose = 0.03_f64.min(0.1 * a.h);
    m.drum(b.inset(0.72 * x, 0.0, 0.72 * z).y(a.h - rose..a.h), &main);
    let ring = b.y(0.0..0.5 * a.h);
    m.solid_drum(ring);
    let r = 0.03 * x.min(z);
    m.solid_drum(about(r, 0.5 * a.h, a.h - rose));
    let stem = [(0.5, 0.0), (3.0, 0.04), (3.0, 0.1), (0.8, 0.2), (1.0, 1.0)].map(|(r, y)| (r / 3.0, y));
    m.mesh.lathe(about(3.0 * r, 0.0, a.h - rose), &stem, 24, &main);
    m.mesh.stretch(ring, |mesh| {
        for k in 0..8 {
            let (sin, cos) = (TAU * f64::from(k) / 8.0).sin_cos();
            let at = |r: f64, y: f64| Vec3::new(cos * r, y, sin * r);
            mesh.tube(&[at(0.05, 0.2), at(0.4, 0.0), at(0.8, 0.1), at(0.92, 0.35)], 0.025, &main);
            let c = at(0.92, 0.0);
            mesh.lathe(about(0.08, 0.32, 0.38).moved(c.x, 0.0, c.z), &[(1.0, 0.0), (1.0, 1.0)], 12, &main);
            mesh.bead(about(0.06, 0.38, 0.72).moved(c.x, 0.0, c.z), &light);
        }
    });
    m
}

/// On a wall at −z: a plate, an arm, a shade.
pub(super) fn sconce(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let metal = a.second(stuff::BRASS);
    let plate = 0.12 * a.d;
    m.board(b.inset(0.28 * a.w, 0.08 * a.h, 0.0).z(b.min.z..b.min.z + plate), &metal);
    let front = b.z(b.min.z + 1.6 * plate..b.max.z);
    let c = front.center();
    let t = 0.05 * a.h;
    m.board(block(-t.min(0.1 * a.w)..t.min(0.1 * a.w), 0.3 * a.h - t..0.3 * a.h + t, b.min.z + plate..c.z), &metal);
    shade_of(&mut m, front, 0.75, &a.tinted(stuff::LINEN));
    m
}

/// A candle on a small plate; a row of them where it is wide.
pub(super) fn candle(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wax = a.main(Stuff(Finish::Ceramic, 0xf3ead6));
    m.solid_drum(b);
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    m.mesh.lathe(b.y(0.0..0.1 * a.h), &[(0.7, 0.0), (1.0, 1.0), (0.95, 1.0), (0.7, 0.4)], 24, &stuff::BRASS.surface());
    m.mesh.drum(b.inset(0.35 * x, 0.0, 0.35 * z).y(0.04 * a.h..0.82 * a.h), &wax);
    let flame = block(-0.16 * x..0.16 * x, 0.83 * a.h..a.h, -0.16 * z..0.16 * z);
    m.mesh.lathe(
        flame,
        &[(0.0, 0.0), (0.8, 0.2), (1.0, 0.38), (0.5, 0.75), (0.0, 1.0)],
        12,
        &Stuff(Finish::Glow, 0xffc766).surface(),
    );
    m
}
