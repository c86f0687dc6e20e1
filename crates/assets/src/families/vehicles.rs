//! What people drive, and what serves it: a car with its cabin, windows, wheels and lights; a motorcycle, a bicycle, a
//! forklift; a lift for cars and a stack of tires. The front is at +z.

use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::BuiltModel;
use scenelang_layout::Vec3;

/// A wheel with its axle across.
fn wheel(m: &mut BuiltModel, b: Block) {
    let tyre = stuff::RUBBER.surface();
    let rim = stuff::STEEL.surface();
    m.solid(b);
    for (inset, surface) in [(0.0, &tyre), (0.35, &rim)] {
        let size = b.size();
        // The rim stands out a little on both sides.
        let out = if inset > 0.0 { 0.02 * size.x } else { 0.06 * size.x };
        let part = b.inset(out, inset * 0.5 * size.y, inset * 0.5 * size.z);
        m.mesh.stretch(part, |mesh| {
            mesh.place(Vec3::zeros(), [0.0, 0.0, 90.0], |mesh| {
                mesh.drum(block(-1.0..1.0, 0.0..1.0, -1.0..1.0), surface);
            });
        });
    }
}

/// A car; a van, where it says so.
pub(super) fn car(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let paint = a.main(Stuff(Finish::Paint, if a.says(&["school"]) { 0xe3b02f } else { 0x5b7f9c }));
    let glass = Stuff(Finish::Screen, 0x2b3844).surface();
    let dark = stuff::DARK_PLASTIC.surface();
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let r = (0.22 * a.h).min(0.09 * a.d);
    let sill = 0.55 * r;
    let belt = 0.56 * a.h;
    let van = a.says(&["van", "truck", "lorry", "ambulance", "bus", "minibus"]);
    // The body over the wheels, and the cabin, which is narrower towards the roof.
    // The lights stand out a little.
    let out = 0.004 * a.d;
    m.solid(block(-x..x, sill..belt, -z..z));
    m.mesh.rounded(block(-x..x, sill..belt, -z + out..z - out), 0.3 * r, 3, &paint);
    let (back, front, roof_back, roof_front) = match () {
        () if a.says(&["bus", "minibus"]) => (-0.98 * z, 0.97 * z, -0.97 * z, 0.92 * z),
        () if van => (-0.98 * z, 0.72 * z, -0.97 * z, 0.5 * z),
        () => (-0.82 * z, 0.5 * z, -0.55 * z, 0.1 * z),
    };
    let foot = block(-0.92 * x..0.92 * x, belt..belt + 0.001, back..front);
    let glazed = 0.94 * a.h;
    let head = block(-0.76 * x..0.76 * x, glazed - 0.001..glazed, roof_back..roof_front);
    m.taper(foot, head, &glass);
    m.rounded(block(-0.76 * x..0.76 * x, glazed..a.h, roof_back..roof_front), 0.02, &paint);
    for at in [-0.62 * z, 0.62 * z] {
        for side in block(x - 0.2 * a.w..x, 0.0..2.0 * r, at - r..at + r).both_sides() {
            wheel(&mut m, side);
        }
    }
    let lamp = Stuff(Finish::Glow, 0xfff4d6).surface();
    let tail = stuff::RED.surface();
    for (at, surface) in [(z - 0.015 * a.d..z, &lamp), (-z..-z + 0.015 * a.d, &tail)] {
        let corner = block(0.55 * x..0.9 * x, 0.36 * a.h..0.44 * a.h, at);
        for light in corner.both_sides() {
            m.mesh.crisp(light, surface);
        }
    }
    let bumper = block(-0.96 * x..0.96 * x, sill..0.3 * a.h, z - 0.03 * a.d..z - 0.001 * a.d);
    m.mesh.crisp(bumper, &shade(&dark, 1.2));
    m
}

/// Two wheels in a row, an engine between them, tank, saddle and handlebar.
pub(super) fn motorcycle(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let paint = a.main(Stuff(Finish::Paint, 0x8c2f2b));
    let (dark, chrome) = (stuff::DARK_PLASTIC.surface(), stuff::CHROME.surface());
    let r = (0.27 * a.h).min(0.18 * a.d);
    for at in [-a.d / 2.0 + r, a.d / 2.0 - r] {
        wheel(&mut m, b.share(0.42..0.58, 0.0..1.0, 0.0..1.0).y(0.0..2.0 * r).z(at - r..at + r));
    }
    m.board(b.share(0.32..0.68, 0.18..0.52, 0.36..0.62), &chrome);
    let tank = b.share(0.32..0.68, 0.52..0.74, 0.46..0.72);
    m.solid(tank);
    m.mesh.rounded(tank, 0.3 * tank.size().min(), 3, &paint);
    let saddle = b.share(0.34..0.66, 0.56..0.68, 0.14..0.48);
    m.solid(saddle);
    m.mesh.rounded(saddle, 0.3 * saddle.size().min(), 2, &dark);
    for fork in b.share(0.36..0.41, 0.24..0.86, 0.8..0.85).both_sides() {
        m.board(fork, &chrome);
    }
    m.board(b.share(0.41..0.59, 0.66..0.74, 0.7..0.84), &dark);
    m.board(b.share(0.0..1.0, 0.92..0.96, 0.76..0.8), &chrome);
    m.board(b.share(0.4..0.6, 0.84..0.94, 0.74..0.84), &dark);
    let lamp = b.share(0.38..0.62, 0.74..0.86, 0.84..0.92);
    m.disc(2, lamp, &Stuff(Finish::Glow, 0xfff4d6).surface());
    for mirror in b.share(0.1..0.2, 0.96..1.0, 0.76..0.78).both_sides() {
        m.board(mirror, &dark);
    }
    m.board(b.share(0.68..0.76, 0.2..0.28, 0.06..0.5), &chrome);
    m
}

/// Two wheels in a frame of tubes, with saddle, pedals and handlebar.
pub(super) fn bicycle(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let paint = a.main(Stuff(Finish::Paint, 0x2f6f8f));
    let (dark, chrome) = (stuff::DARK_PLASTIC.surface(), stuff::CHROME.surface());
    let r = (0.33 * a.h).min(0.24 * a.d);
    for at in [-a.d / 2.0 + r, a.d / 2.0 - r] {
        wheel(&mut m, b.share(0.46..0.54, 0.0..1.0, 0.0..1.0).y(0.0..2.0 * r).z(at - r..at + r));
    }
    let at = |y: f64, z: f64| Vec3::new(0.0, y * a.h, b.min.z + z * a.d);
    let (crank, seat, head) = (at(0.3, 0.45), at(0.82, 0.34), at(0.78, 0.72));
    let (rear, front) = (Vec3::new(0.0, r, b.min.z + r), Vec3::new(0.0, r, b.max.z - r));
    m.solid(b.share(0.46..0.54, 0.26..0.84, 0.3..0.76));
    for path in [[rear, crank], [rear, seat], [crank, seat], [crank, head], [seat, head], [head, front]] {
        m.mesh.tube(&path, (0.018 * a.h).min(0.02 * a.d).min(0.04 * a.w), &paint);
    }
    m.board(b.share(0.36..0.64, 0.88..0.94, 0.24..0.42), &dark);
    m.board(b.share(0.48..0.52, 0.8..0.88, 0.32..0.36), &chrome);
    m.board(b.share(0.47..0.53, 0.76..0.97, 0.7..0.74), &chrome);
    m.board(b.share(0.12..0.88, 0.96..0.99, 0.71..0.74), &chrome);
    for grip in b.share(0.0..0.14, 0.95..1.0, 0.66..0.74).both_sides() {
        m.board(grip, &dark);
    }
    m.board(b.share(0.3..0.7, 0.27..0.3, 0.43..0.47), &dark);
    m
}

/// A body with its counterweight behind, a seat under a guard, a mast and two forks.
pub(super) fn forklift(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let paint = a.main(Stuff(Finish::Paint, 0xe0a020));
    let (dark, steel) = (stuff::DARK_PLASTIC.surface(), stuff::BLACK_STEEL.surface());
    let r = (0.13 * a.h).min(0.12 * a.d);
    for at in [b.min.z + 0.1 * a.d + r, b.min.z + 0.52 * a.d - r] {
        for side in b.share(0.0..0.18, 0.0..1.0, 0.0..1.0).y(0.0..2.0 * r).z(at - r..at + r).both_sides() {
            wheel(&mut m, side);
        }
    }
    m.rounded(b.share(0.06..0.94, 0.08..0.46, 0.0..0.2), 0.04 * a.h, &paint);
    m.board(b.share(0.18..0.82, 0.08..0.4, 0.2..0.58), &paint);
    m.board(b.share(0.3..0.7, 0.4..0.46, 0.22..0.4), &dark);
    m.board(b.share(0.3..0.7, 0.46..0.68, 0.18..0.23), &dark);
    m.board(b.share(0.46..0.54, 0.4..0.62, 0.5..0.53), &dark);
    for post in b.share(0.1..0.15, 0.4..0.92, 0.14..0.18).both_sides() {
        m.board(post, &dark);
    }
    for post in b.share(0.1..0.15, 0.4..0.92, 0.54..0.58).both_sides() {
        m.board(post, &dark);
    }
    m.board(b.share(0.0..1.0, 0.92..0.96, 0.12..0.6), &dark);
    for upright in b.share(0.24..0.32, 0.03..1.0, 0.59..0.63).both_sides() {
        m.board(upright, &steel);
    }
    for bar in [0.08..0.12, 0.4..0.44, 0.94..0.98] {
        m.board(b.share(0.32..0.68, bar, 0.59..0.63), &steel);
    }
    m.board(b.share(0.2..0.8, 0.06..0.24, 0.63..0.65), &steel);
    for fork in b.share(0.26..0.36, 0.02..0.05, 0.63..1.0).both_sides() {
        m.board(fork, &steel);
    }
    m
}

/// A lift with four posts and two runways, on which a car stands.
pub(super) fn car_lift(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let paint = a.main(Stuff(Finish::Paint, 0x2f5f9e));
    let steel = stuff::STEEL.surface();
    let (foot, post) = (0.02 * a.h, (0.06 * a.w).min(0.06 * a.d));
    let (low, top) = (0.48 * a.h, 0.54 * a.h);
    m.surface = Some(top);
    for plate in b.share(0.0..0.12, 0.0..1.0, 0.06..0.12).four_corners() {
        m.board(plate.y(0.0..foot), &steel);
        let c = plate.center();
        let half = 0.5 * post;
        m.board(block(c.x - half..c.x + half, foot..a.h, c.z - half..c.z + half), &paint);
    }
    // The beams at the two ends carry the runways.
    let inner = b.share(0.09..0.91, 0.0..1.0, 0.0..1.0);
    for beam in [inner.share(0.0..1.0, 0.0..1.0, 0.06..0.12), inner.share(0.0..1.0, 0.0..1.0, 0.88..0.94)] {
        m.board(beam.y(low..low + 0.4 * (top - low)), &paint);
    }
    for runway in b.share(0.16..0.38, 0.0..1.0, 0.03..0.97).both_sides() {
        m.board(runway.y(low + 0.4 * (top - low)..top), &steel);
    }
    // Stops before the wheels, and the ramps by which a car comes.
    for stop in b.share(0.16..0.38, 0.0..1.0, 0.0..0.03).both_sides() {
        m.board(stop.y(low..top + 0.02 * a.h), &paint);
        let ahead = b.max.z - stop.max.z;
        m.board(stop.moved(0.0, 0.0, ahead).y(low..top), &steel);
    }
    m
}

/// Two feet across each other, a mast, and an arm with a clamp that holds a bicycle.
pub(super) fn repair_stand(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let (steel, clamp) = (a.main(stuff::BLACK_STEEL), stuff::RED.surface());
    m.board(b.share(0.0..1.0, 0.0..0.03, 0.42..0.58), &steel);
    for foot in [b.share(0.42..0.58, 0.0..0.03, 0.0..0.42), b.share(0.42..0.58, 0.0..0.03, 0.58..1.0)] {
        m.board(foot, &steel);
    }
    m.board(b.share(0.46..0.54, 0.03..0.94, 0.46..0.54), &stuff::STEEL.surface());
    m.board(b.share(0.46..0.54, 0.88..0.94, 0.54..0.88), &steel);
    m.board(b.share(0.4..0.6, 0.84..1.0, 0.88..1.0), &clamp);
    m
}

fn tire_rack(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let (steel, tyre) = (a.main(stuff::BLACK_STEEL), stuff::RUBBER.surface());
    for end in b.share(0.0..0.03, 0.0..1.0, 0.0..1.0).both_sides() {
        m.board(end, &steel);
    }
    for row in b.share(0.03..0.97, 0.0..1.0, 0.0..1.0).split(1, pieces(a.h, 0.72, 1, 4), 0.0) {
        m.board(row.share(0.0..1.0, 0.08..0.12, 0.02..0.98), &steel);
        let held = row.share(0.0..1.0, 0.12..0.96, 0.04..0.96);
        m.solid(held);
        for place in held.split(0, pieces(held.size().x, 0.23, 1, 12), 0.02) {
            m.mesh.disc(0, place, &tyre);
        }
    }
    m
}

/// Tires lying on each other, or side by side on the boards of a rack.
pub(super) fn tire_stack(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    if a.says(&["rack"]) {
        return tire_rack(a);
    }
    let tyre = a.main(stuff::RUBBER);
    let side = [(0.55, 0.0), (0.92, 0.04), (1.0, 0.25), (1.0, 0.75), (0.92, 0.96), (0.55, 1.0), (0.55, 0.0)];
    m.solid_drum(b);
    for tire in b.split(1, pieces(a.h, 0.21, 1, 6), 0.0) {
        m.mesh.lathe(tire, &side, 24, &tyre);
    }
    m
}
