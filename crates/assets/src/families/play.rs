//! What children and those at rest use: a rocking horse, a dolls' house, a slide, a toy kitchen, a hammock.

use crate::ask::Ask;
use crate::block::pieces;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::BuiltModel;

/// Two runners, four legs, a body with a saddle, a neck and a head; it looks to +z.
pub(super) fn rocking_horse(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wood = a.main(stuff::BIRCH);
    let red = a.second(Stuff(Finish::Fabric, 0xb5432e));
    for runner in b.share(0.0..0.14, 0.0..0.08, 0.0..1.0).both_sides() {
        m.solid(runner);
        m.mesh.rounded(runner, 0.02, 2, &shade(&wood, 0.8));
        for (from, to) in [(0.2, 0.28), (0.66, 0.74)] {
            m.board(runner.share(0.1..0.9, 1.0..1.0, from..to).y(runner.max.y..0.42 * a.h), &wood);
        }
    }
    let body = b.share(0.1..0.9, 0.4..0.66, 0.14..0.8);
    m.solid(body);
    m.mesh.rounded(body, 0.3 * body.size().min(), 3, &wood);
    m.board(b.share(0.06..0.94, 0.62..0.69, 0.3..0.58), &red);
    let neck = b.share(0.3..0.7, 0.6..0.94, 0.66..0.84);
    m.board(neck, &wood);
    let head = b.share(0.28..0.72, 0.8..1.0, 0.7..1.0);
    m.solid(head);
    m.mesh.rounded(head, 0.25 * head.size().min(), 2, &wood);
    m.board(b.share(0.4..0.6, 0.66..0.96, 0.6..0.68), &red);
    let bar = b.share(0.08..0.92, 0.78..0.82, 0.72..0.76);
    m.board(bar, &shade(&wood, 0.7));
    m.board(b.share(0.42..0.58, 0.3..0.6, 0.06..0.14), &red);
    for eye in b.share(0.24..0.3, 0.89..0.93, 0.84..0.88).both_sides() {
        m.mesh.ball(eye, &stuff::DARK_PLASTIC.surface());
    }
    m
}

/// An open front with rooms on two floors under a gable.
pub(super) fn dollhouse(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wall = a.main(Stuff(Finish::Paint, 0xe9c6cf));
    let roof = a.second(Stuff(Finish::Paint, 0xa7473f));
    let inner = shade(&wall, 1.12);
    let house = b.share(0.04..0.96, 0.0..0.66, 0.02..1.0);
    m.board(house.share(0.0..1.0, 0.0..1.0, 0.0..0.06), &inner);
    for side in house.share(0.0..0.04, 0.0..1.0, 0.06..1.0).both_sides() {
        m.board(side, &wall);
    }
    for floor in [0.0..0.05, 0.49..0.54, 0.95..1.0] {
        m.board(house.share(0.04..0.96, floor, 0.06..1.0), &stuff::OAK.surface());
    }
    for storey in [0.05..0.49, 0.54..0.95] {
        m.board(house.share(0.49..0.52, storey, 0.06..0.96), &inner);
    }
    let things =
        [(0.12..0.34, 0.05..0.2, 0x6f8aa3), (0.62..0.86, 0.05..0.16, 0xc49b6b), (0.14..0.38, 0.54..0.66, 0xb5432e)];
    for (x, y, color) in things {
        let thing = house.share(x, y, 0.2..0.7);
        m.board(thing, &Stuff(Finish::Paint, color).surface());
    }
    let (low, top) = (b.share(0.0..1.0, 0.66..0.67, 0.0..1.0), b.share(0.46..0.54, 0.99..1.0, 0.0..1.0));
    m.taper(low, top, &roof);
    m
}

/// A cloth hung between two posts of a stand along its longer side.
pub(super) fn hammock(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let cloth = a.main(Stuff(Finish::Fabric, 0xd9c3a0));
    let frame = a.second(stuff::OAK);
    let along = a.d >= a.w;
    let share = |long: std::ops::Range<f64>, y: std::ops::Range<f64>, wide: std::ops::Range<f64>| {
        if along { b.share(wide, y, long) } else { b.share(long, y, wide) }
    };
    m.board(share(0.06..0.94, 0.0..0.07, 0.46..0.54), &frame);
    for end in [0.0..0.07, 0.93..1.0] {
        m.board(share(end.clone(), 0.0..0.06, 0.0..1.0), &frame);
        m.board(share(end, 0.06..1.0, 0.45..0.55), &frame);
    }
    // Sags to the middle, where one lies.
    const N: usize = 15;
    for i in 0..N {
        let (from, to) = (0.07 + 0.86 * i as f64 / N as f64, 0.07 + 0.86 * (i + 1) as f64 / N as f64);
        let t = from + to - 1.0;
        let (low, half) = (0.42 + 0.45 * t * t, 0.44 - 0.32 * t * t);
        m.board(share(from..to, low..low + 0.08, 0.5 - half..0.5 + half), &cloth);
    }
    m.surface = Some(0.48 * a.h);
    m
}

/// A ladder with a platform, and a chute that ends low at the front.
pub(super) fn slide(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let chute = a.main(Stuff(Finish::Plastic, 0xe2a12f));
    let frame = a.second(Stuff(Finish::Plastic, 0x2f7fb5));
    let (top, foot, edge) = (0.62 * a.h, 0.06 * a.h, 0.26 * a.d);
    for post in b.share(0.0..0.12, 0.0..0.96, 0.0..0.05).both_sides() {
        m.board(post, &frame);
    }
    for post in b.share(0.02..0.1, 0.0..0.58, 0.2..0.24).both_sides() {
        m.board(post, &frame);
    }
    for step in [0.12, 0.27, 0.42] {
        m.board(b.share(0.12..0.88, step..step + 0.04, 0.005..0.06), &frame);
    }
    m.board(b.share(0.02..0.98, 0.58..0.62, 0.05..0.26), &chute);
    for rail in b.share(0.0..0.08, 0.96..1.0, 0.0..0.27).both_sides() {
        m.board(rail, &frame);
    }
    for post in b.share(0.01..0.07, 0.62..0.96, 0.22..0.26).both_sides() {
        m.board(post, &frame);
    }
    let (back, front) = (b.min.z + edge, b.max.z);
    let slope =
        |low: f64, high: f64| [(top + low, back), (top + high, back), (foot + high, front), (foot + low, front)];
    let thick = 0.06 * a.h;
    m.extrude(0, &slope(-thick, 0.0), b.min.x + 0.1 * a.w..b.max.x - 0.1 * a.w, &chute);
    let side = 0.1 * a.w;
    for from in [b.min.x, b.max.x - side] {
        m.extrude(0, &slope(-thick, 0.1 * a.h), from..from + side, &chute);
    }
    m
}

/// A cupboard with rings, a basin and a shelf above, as high as a child reaches; its front looks to +z.
pub(super) fn toy_kitchen(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let body = a.main(stuff::BIRCH);
    let front = a.second(stuff::WHITE);
    let dark = stuff::DARK_PLASTIC.surface();
    m.board(b.share(0.0..1.0, 0.0..0.52, 0.0..0.94), &body);
    m.board(b.share(0.0..1.0, 0.52..0.55, 0.0..1.0), &front);
    for (x, y) in [(0.03..0.48, 0.04..0.48), (0.52..0.97, 0.04..0.48)] {
        m.board(b.share(x.clone(), y, 0.94..0.97), &front);
        let middle = (x.start + x.end) / 2.0;
        m.mesh.crisp(b.share(middle - 0.08..middle + 0.08, 0.42..0.445, 0.97..0.99), &dark);
    }
    m.mesh.crisp(b.share(0.08..0.43, 0.14..0.36, 0.97..0.98), &dark);
    for z in [0.2..0.48, 0.56..0.84] {
        m.mesh.drum(b.share(0.1..0.34, 0.55..0.565, z), &dark);
    }
    m.mesh.drum(b.share(0.56..0.92, 0.55..0.575, 0.24..0.86), &stuff::STEEL.surface());
    m.board(b.share(0.72..0.76, 0.55..0.7, 0.14..0.2), &stuff::STEEL.surface());
    m.board(b.share(0.0..1.0, 0.55..0.96, 0.0..0.06), &body);
    m.board(b.share(0.0..1.0, 0.96..1.0, 0.0..0.4), &body);
    for side in b.share(0.0..0.05, 0.55..0.96, 0.06..0.36).both_sides() {
        m.board(side, &body);
    }
    m
}

/// A metal box heaped with stones, behind a rail of wood at three sides.
pub(super) fn sauna_heater(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let metal = a.main(stuff::BLACK_STEEL);
    let wood = a.second(stuff::OAK);
    m.board(b.share(0.12..0.88, 0.06..0.8, 0.04..0.86), &metal);
    for foot in b.share(0.14..0.22, 0.0..0.06, 0.06..0.84).both_sides() {
        m.board(foot, &metal);
    }
    let stone = stuff::STONE.surface();
    let gray = shade(&stone, 0.55);
    for (k, (x, z)) in [
        (0.15, 0.08),
        (0.4, 0.1),
        (0.63, 0.07),
        (0.17, 0.34),
        (0.41, 0.36),
        (0.64, 0.33),
        (0.16, 0.6),
        (0.4, 0.62),
        (0.62, 0.58),
    ]
    .into_iter()
    .enumerate()
    {
        let top = 0.94 + 0.06 * ((k * 2 % 3) as f64) / 2.0;
        m.mesh.ball(b.share(x..x + 0.23, 0.76..top, z..z + 0.24), if k % 2 == 0 { &gray } else { &stone });
    }
    m.solid(b.share(0.15..0.87, 0.8..1.0, 0.07..0.86));
    m.board(b.share(0.0..1.0, 0.6..0.68, 0.94..1.0), &wood);
    for side in b.share(0.0..0.06, 0.6..0.68, 0.0..0.94).both_sides() {
        m.board(side, &wood);
    }
    for post in b.share(0.0..0.06, 0.0..0.6, 0.94..1.0).both_sides() {
        m.board(post, &wood);
    }
    m
}

/// A cabin of planks with a front of glass, behind which two benches and a heater are seen.
pub(super) fn sauna(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    m.solid(b);
    let wood = a.main(stuff::BIRCH);
    let inside = shade(&wood, 0.88);
    let dark = stuff::BLACK_STEEL.surface();
    let (tx, tz) = (0.07 / a.w.max(0.7), 0.07 / a.d.max(0.7));
    m.mesh.board(b.share(0.0..1.0, 0.0..0.04, 0.0..1.0), &wood);
    m.mesh.board(b.share(0.0..1.0, 0.95..1.0, 0.0..1.0), &wood);
    m.mesh.board(b.share(tx..1.0 - tx, 0.04..0.95, 0.0..tz), &inside);
    for side in b.share(0.0..tx, 0.04..0.95, 0.0..1.0).both_sides() {
        for plank in side.split(1, pieces(0.9 * a.h, 0.12, 4, 24), 0.004) {
            m.mesh.crisp(plank, &wood);
        }
    }
    // The benches are one above the other, and the heater stands before the lower one.
    m.mesh.board(b.share(tx..1.0 - tx, 0.4..0.44, tz..0.4), &wood);
    m.mesh.board(b.share(tx..0.6, 0.2..0.24, 0.42..0.68), &wood);
    m.mesh.crisp(b.share(0.7..0.88, 0.04..0.3, 0.6..0.82), &dark);
    let face = b.share(tx..1.0 - tx, 0.04..0.95, 1.0 - tz..1.0);
    for plank in face.share(0.0..0.18, 0.0..1.0, 0.0..0.9).split(1, pieces(0.9 * a.h, 0.12, 4, 24), 0.004) {
        m.mesh.crisp(plank, &wood);
    }
    m.mesh.crisp(face.share(0.2..0.56, 0.0..1.0, 0.3..0.5), &stuff::GLASS.surface());
    for post in [0.18..0.2, 0.56..0.59, 0.97..1.0] {
        m.mesh.crisp(face.share(post, 0.0..1.0, 0.0..0.9), &wood);
    }
    m.mesh.crisp(face.share(0.6..0.96, 0.01..0.99, 0.3..0.5), &stuff::GLASS.surface());
    m.mesh.rounded(face.share(0.63..0.65, 0.42..0.6, 0.55..1.0), 0.01, 2, &dark);
    m
}
