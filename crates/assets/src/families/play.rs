//! What children and those at rest use: a rocking horse, a dolls' house, a hammock.

use crate::ask::Ask;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::Model;

/// Two runners, four legs, a body with a saddle, a neck and a head; it looks to +z.
pub(super) fn rocking_horse(a: &Ask) -> Model {
    let mut m = Model::default();
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
pub(super) fn dollhouse(a: &Ask) -> Model {
    let mut m = Model::default();
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
pub(super) fn hammock(a: &Ask) -> Model {
    let mut m = Model::default();
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
