//! What stands in a gym: benches with a barbell, racks of dumbbells, kettlebells, a ring for boxers.

use crate::ask::Ask;
use crate::block::{block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::BuiltModel;

/// A padded bench along z, and behind it two uprights with a barbell.
pub(super) fn weight_bench(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let pad = a.main(Stuff(Finish::Leather, 0x23262b));
    let steel = stuff::BLACK_STEEL.surface();
    m.solid(b.share(0.38..0.62, 0.34..0.42, 0.0..1.0));
    m.mesh.rounded(b.share(0.38..0.62, 0.36..0.42, 0.0..1.0), 0.03, 3, &pad);
    m.mesh.crisp(b.share(0.42..0.58, 0.34..0.36, 0.02..0.98), &steel);
    for foot in [b.share(0.46..0.54, 0.0..0.34, 0.84..0.9), b.share(0.46..0.54, 0.0..0.34, 0.3..0.36)] {
        m.board(foot, &steel);
    }
    for beam in [b.share(0.34..0.66, 0.0..0.04, 0.9..0.96), b.share(0.24..0.76, 0.0..0.04, 0.18..0.22)] {
        m.board(beam, &steel);
    }
    for upright in b.share(0.25..0.29, 0.04..0.84, 0.18..0.22).both_sides() {
        m.board(upright, &steel);
    }
    m.solid(b.share(0.0..1.0, 0.84..0.88, 0.18..0.22));
    m.mesh.rounded(b.share(0.0..1.0, 0.845..0.875, 0.19..0.21), 0.012, 2, &stuff::CHROME.surface());
    for (x, r) in [(0.05..0.09, 0.14), (0.1..0.13, 0.11)] {
        for plate in b.share(x.clone(), 0.86 - r..0.86 + r, 0.2 - 0.73 * r..0.2 + 0.73 * r).both_sides() {
            m.disc(0, plate, &stuff::RUBBER.surface());
        }
    }
    m.surface = Some(0.42 * a.h);
    m
}

/// Sides and shelves of steel, and on each shelf a row of dumbbells, larger ones below.
pub(super) fn dumbbell_rack(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let steel = a.main(stuff::BLACK_STEEL);
    let (iron, grip) = (stuff::RUBBER.surface(), stuff::CHROME.surface());
    for side in b.share(0.0..0.03, 0.0..1.0, 0.0..1.0).both_sides() {
        m.board(side, &steel);
    }
    let rows = pieces(a.h, 0.38, 1, 3);
    for (row, space) in b.share(0.03..0.97, 0.08..1.0, 0.04..0.96).split(1, rows, 0.0).enumerate() {
        let board = space.share(0.0..1.0, 0.0..0.08, 0.0..1.0);
        m.board(board, &steel);
        let n = pieces(space.size().x, 0.17 - 0.015 * row as f64, 2, 9);
        let held = space.share(0.0..1.0, 0.08..0.5 - 0.06 * row as f64, 0.14..0.86);
        m.solid(held);
        for place in held.split(0, n, 0.0) {
            let weight = place.share(0.1..0.9, 0.0..1.0, 0.0..1.0);
            for head in [weight.share(0.0..1.0, 0.0..1.0, 0.0..0.3), weight.share(0.0..1.0, 0.0..1.0, 0.7..1.0)] {
                m.mesh.rounded(head, 0.25 * head.size().min(), 1, &iron);
            }
            m.mesh.crisp(weight.share(0.38..0.62, 0.36..0.64, 0.3..0.7), &grip);
        }
    }
    m
}

/// A ball of iron with a handle over it.
pub(super) fn kettlebell(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::RUBBER);
    let ball = b.share(0.0..1.0, 0.0..0.68, 0.0..1.0);
    m.solid_drum(ball);
    m.mesh.lathe(ball, &[(0.55, 0.0), (0.8, 0.08), (1.0, 0.45), (0.85, 0.8), (0.4, 1.0)], 20, &main);
    for post in b.share(0.18..0.3, 0.55..0.9, 0.42..0.58).both_sides() {
        m.board(post, &main);
    }
    m.solid(b.share(0.18..0.82, 0.88..1.0, 0.4..0.6));
    m.mesh.rounded(b.share(0.18..0.82, 0.88..1.0, 0.4..0.6), 0.02, 2, &main);
    m
}

/// Two rails on posts, one higher than the other, for dancers.
pub(super) fn barre(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let (wood, steel) = (a.main(stuff::OAK), stuff::STEEL.surface());
    for post in b.share(0.06..0.09, 0.03..0.97, 0.44..0.56).both_sides() {
        m.board(post, &steel);
    }
    for foot in b.share(0.05..0.1, 0.0..0.03, 0.0..1.0).both_sides() {
        m.board(foot, &steel);
    }
    for rail in [0.66..0.7, 0.96..1.0] {
        m.board(b.share(0.0..1.0, rail, 0.4..0.6), &wood);
    }
    m
}

/// A cage of four uprights with a barbell on its hooks and bars that catch it.
pub(super) fn squat_rack(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let steel = a.main(stuff::BLACK_STEEL);
    let (chrome, rubber) = (stuff::CHROME.surface(), stuff::RUBBER.surface());
    let t = 0.06_f64.min(0.08 * a.w).min(0.08 * a.d).min(0.1 * a.h);
    let cage = b.share(0.16..0.84, 0.0..1.0, 0.0..1.0);
    for post in cage.x(cage.min.x..cage.min.x + t).z(cage.min.z..cage.min.z + t).four_corners() {
        m.board(post, &steel);
    }
    let between = cage.z(cage.min.z + t..cage.max.z - t);
    for beam in [0.0..0.03, 0.3..0.32, 0.97..1.0] {
        for side in between.share(0.0..1.0, beam.clone(), 0.0..1.0).x(cage.min.x..cage.min.x + t).both_sides() {
            m.board(side, &steel);
        }
    }
    let across = cage.x(cage.min.x + t..cage.max.x - t);
    m.board(across.share(0.0..1.0, 0.97..1.0, 0.0..1.0).z(cage.min.z..cage.min.z + t), &steel);
    m.board(across.share(0.0..1.0, 0.97..1.0, 0.0..1.0).z(cage.max.z - t..cage.max.z), &steel);
    // The bar lies before the uprights at the front, inside the box.
    let (y, z) = (0.66 * a.h, cage.max.z - 1.6 * t);
    let bar = b.y(y - 0.3 * t..y + 0.3 * t).z(z - 0.3 * t..z + 0.3 * t);
    m.board(bar, &chrome);
    let r = (0.1 * a.h).min(0.4 * a.d);
    for plate in b.share(0.02..0.1, 0.0..1.0, 0.0..1.0).y(y - r..y + r).z(z - r..z + r).both_sides() {
        let high = plate.z(plate.min.z.max(b.min.z)..plate.max.z.min(b.max.z));
        m.disc(0, high, &rubber);
    }
    m
}

/// A rail with a sliding seat, foot rests and a flywheel in its cage at the front; who rows looks to +z.
pub(super) fn rowing_machine(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let frame = a.main(stuff::BLACK_STEEL);
    let steel = stuff::STEEL.surface();
    let dark = stuff::DARK_PLASTIC.surface();
    m.board(b.share(0.1..0.9, 0.0..0.05, 0.02..0.08), &frame);
    m.board(b.share(0.0..1.0, 0.0..0.05, 0.86..0.94), &frame);
    m.board(b.share(0.45..0.55, 0.05..0.24, 0.03..0.07), &frame);
    m.board(b.share(0.44..0.56, 0.24..0.32, 0.0..0.74), &steel);
    m.cushion(b.share(0.25..0.75, 0.32..0.4, 0.16..0.32), &dark);
    for rest in b.share(0.14..0.38, 0.1..0.36, 0.62..0.68).both_sides() {
        m.board(rest, &dark);
    }
    m.board(b.share(0.38..0.62, 0.14..0.24, 0.62..0.68), &frame);
    m.board(b.share(0.46..0.54, 0.05..0.7, 0.88..0.92), &frame);
    m.disc(0, b.share(0.34..0.66, 0.12..0.68, 0.72..1.0), &frame);
    m.board(b.share(0.46..0.54, 0.7..0.86, 0.87..0.91), &frame);
    m.board(b.share(0.3..0.7, 0.8..1.0, 0.84..0.87), &dark);
    m.board(b.share(0.15..0.85, 0.44..0.48, 0.69..0.71), &steel);
    m
}

/// A canvas on a platform between four padded posts, with four ropes on each side.
pub(super) fn boxing_ring(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let apron = a.main(Stuff(Finish::Fabric, 0x1f3f7a));
    let deck = 0.6_f64.min(0.3 * a.h);
    m.surface = Some(deck);
    m.solid(b.y(0.0..deck));
    m.mesh.crisp(b.inset(0.01, 0.0, 0.01).y(0.0..0.86 * deck), &apron);
    m.mesh.board(b.y(0.86 * deck..deck), &shade(&apron, 0.7));
    let mat = b.inset(0.05 * a.w, 0.0, 0.05 * a.d);
    m.mesh.crisp(mat.y(deck..deck + 0.004 * a.h), &Stuff(Finish::Fabric, 0xdfe3e6).surface());
    let corners = [stuff::RED, stuff::WHITE, stuff::WHITE, Stuff(Finish::Paint, 0x2456b0)];
    let thick = 0.2_f64.min(0.06 * a.w).min(0.06 * a.d);
    let post = b.share(0.05..0.06, 0.0..1.0, 0.05..0.06);
    let post = post.x(post.min.x..post.min.x + thick).y(deck..a.h).z(post.min.z..post.min.z + thick);
    for (place, color) in post.four_corners().into_iter().zip(corners) {
        m.solid(place);
        m.mesh.board(place.inset(0.22 * thick, 0.0, 0.22 * thick), &stuff::BLACK_STEEL.surface());
        // The pad that turns to the middle of the ring.
        m.mesh.board(place.share(0.0..1.0, 0.22..0.96, 0.0..1.0), &color.surface());
    }
    let r = 0.025_f64.min(0.02 * a.h).min(0.3 * thick);
    let ropes = [stuff::RED, stuff::WHITE, Stuff(Finish::Paint, 0x2456b0), stuff::RED];
    for (k, color) in ropes.into_iter().enumerate() {
        let y = deck + (0.27 + 0.21 * k as f64) * (a.h - deck);
        let color = color.surface();
        let c = post.center();
        let along_x = block(post.max.x..-post.max.x, y - r..y + r, c.z - r..c.z + r);
        let along_z = block(c.x - r..c.x + r, y - r..y + r, post.max.z..-post.max.z);
        for rope in
            [along_x, along_x.z(-along_x.max.z..-along_x.min.z), along_z, along_z.x(-along_z.max.x..-along_z.min.x)]
        {
            m.solid(rope);
            m.mesh.crisp(rope, &color);
        }
    }
    m
}

/// A wall of panels to climb, with holds of many colours.
pub(super) fn climbing_wall(a: &Ask) -> BuiltModel {
    const HOLDS: [u32; 6] = [0xd8433a, 0xf0b93a, 0x2f7fc2, 0x4f9d4a, 0xe8832e, 0x8a5fa8];
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Wood, 0xd9c4a0));
    let deep = 0.8 * a.d;
    m.solid(b);
    let face = b.z(b.min.z..b.min.z + deep);
    let (cols, rows) = (pieces(a.w, 1.2, 1, 10), pieces(a.h, 1.2, 1, 6));
    let mut dice = a.dice();
    for (k, column) in face.split(0, cols, 0.006).enumerate() {
        for (r, panel) in column.split(1, rows, 0.006).enumerate() {
            m.mesh.board(panel, &shade(&main, if (k + r) % 2 == 0 { 1.0 } else { 0.93 }));
            let front = panel.share(0.06..0.94, 0.06..0.94, 1.0..1.0).z(face.max.z..b.max.z);
            for row in front.split(1, 2, 0.0) {
                for spot in row.split(0, 3, 0.0) {
                    let (x, y) = (0.15 + 0.4 * dice.unit(), 0.15 + 0.4 * dice.unit());
                    let hold = spot.share(x..x + 0.3, y..y + 0.28, 0.0..1.0);
                    m.mesh.crisp(hold, &Stuff(Finish::Plastic, *dice.pick(&HOLDS)).surface());
                }
            }
        }
    }
    m
}
