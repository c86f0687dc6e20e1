//! What shops, garages and offices have that homes have not: fitting rooms, doors for cars, water dispensers, hand trucks.

use crate::ask::Ask;
use crate::block::pieces;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::BuiltModel;

/// Three walls, a seat, a mirror, and a curtain that is drawn half-way.
pub(super) fn fitting_room(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wall = a.main(Stuff(Finish::Paint, 0xe9e4da));
    let cloth = a.second(Stuff(Finish::Velvet, 0x8c5560));
    for side in b.share(0.0..0.04, 0.0..1.0, 0.0..1.0).both_sides() {
        m.board(side, &wall);
    }
    m.board(b.share(0.04..0.96, 0.0..1.0, 0.0..0.04), &wall);
    m.solid(b.share(0.04..0.96, 0.95..0.98, 0.93..0.96));
    m.mesh.rounded(b.share(0.04..0.96, 0.955..0.975, 0.935..0.955), 0.01, 2, &stuff::BRASS.surface());
    let curtain = b.share(0.5..0.95, 0.06..0.95, 0.92..0.98);
    m.solid(curtain);
    for (i, fold) in curtain.split(0, 9, 0.0).enumerate() {
        let back = if i % 2 == 0 { 0.0..0.75 } else { 0.25..1.0 };
        m.mesh.rounded(fold.share(0.0..1.0, 0.0..1.0, back), 0.02, 2, &cloth);
    }
    m.board(b.share(0.1..0.9, 0.19..0.22, 0.04..0.3), &stuff::OAK.surface());
    m.mesh.crisp(b.share(0.28..0.72, 0.3..0.88, 0.04..0.05), &stuff::MIRROR.surface());
    m
}

/// Folded shirts and sweaters, one on the other.
pub(super) fn folded(a: &Ask) -> BuiltModel {
    const COLORS: [u32; 8] = [0xe9e5dc, 0x31445c, 0x9a4b43, 0x6f8264, 0xc9a867, 0x7a6a86, 0xb9bec4, 0x2c2e33];
    let mut m = BuiltModel::default();
    let mut dice = a.dice();
    let b = a.whole();
    m.solid(b);
    let n = pieces(a.h, 0.03, 1, 8);
    for (i, layer) in b.split(1, n, 0.0).enumerate() {
        let cloth =
            if a.has_color() { a.main(stuff::LINEN) } else { Stuff(Finish::Fabric, *dice.pick(&COLORS)).surface() };
        let off = if i == 0 || i + 1 == n { 0.0 } else { dice.between(0.0, 0.04) };
        let layer = layer.inset(off * a.w, 0.0, off * a.d);
        // A fold at the front, and the ends that lie in it.
        m.mesh.rounded(layer.share(0.0..1.0, 0.0..1.0, 0.0..1.0), 0.5 * layer.size().y, 3, &cloth);
    }
    m
}

/// A door that goes up: a frame, and sections one over the other.
pub(super) fn garage_door(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    m.solid(b);
    let main = a.main(Stuff(Finish::Metal, 0xc9cdd0));
    let rail = shade(&main, 0.55);
    for side in b.share(0.0..0.025, 0.0..1.0, 0.0..1.0).both_sides() {
        m.mesh.board(side, &rail);
    }
    m.mesh.board(b.share(0.025..0.975, 0.96..1.0, 0.0..1.0), &rail);
    let door = b.share(0.025..0.975, 0.0..0.96, 0.3..0.7);
    let roller = a.says(&["roller", "roll", "shutter"]);
    let each = if roller { 0.12 } else { 0.5 };
    for section in door.split(1, pieces(a.h, each, 2, 24), 0.03 * each) {
        m.mesh.board(section, &main);
        if !roller {
            for field in section.split(0, pieces(a.w, 0.7, 1, 8), 0.0) {
                m.mesh.rounded(field.share(0.1..0.9, 0.22..0.78, -0.12..1.12), 0.02, 1, &shade(&main, 1.06));
            }
        }
    }
    m.mesh.crisp(door.share(0.0..1.0, 0.0..0.015, -0.05..1.05), &stuff::RUBBER.surface());
    m
}

/// A column with taps over a tray, and a bottle upside down on it.
pub(super) fn water_dispenser(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::PLASTIC);
    let dark = stuff::DARK_PLASTIC.surface();
    let body = b.share(0.0..1.0, 0.0..0.68, 0.0..0.98);
    m.solid(b.share(0.0..1.0, 0.0..0.68, 0.0..1.0));
    m.mesh.rounded(body, 0.03, 2, &main);
    m.mesh.crisp(b.share(0.2..0.8, 0.42..0.63, 0.975..0.985), &dark);
    m.mesh.board(b.share(0.22..0.78, 0.4..0.425, 0.97..1.0), &dark);
    for (x, color) in [(0.34, 0x3b78b8), (0.58, 0xc2413a)] {
        m.mesh.board(b.share(x..x + 0.08, 0.54..0.58, 0.975..1.0), &Stuff(Finish::Plastic, color).surface());
    }
    let bottle = b.share(0.1..0.9, 0.68..1.0, 0.1..0.9);
    m.solid_drum(bottle);
    let round = [(0.35, 0.0), (0.45, 0.06), (0.95, 0.22), (1.0, 0.3), (1.0, 0.92), (0.9, 1.0), (0.0, 1.0)];
    m.mesh.lathe(bottle, &round, 20, &Stuff(Finish::Glass, 0x8fc0e2).surface());
    m
}

/// Two wheels, a plate to lift with, and a frame to hold.
pub(super) fn hand_truck(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::RED);
    m.board(b.share(0.12..0.88, 0.0..0.025, 0.4..1.0), &stuff::STEEL.surface());
    for post in b.share(0.16..0.22, 0.02..1.0, 0.34..0.42).both_sides() {
        m.board(post, &main);
    }
    for y in [0.15, 0.45, 0.72, 0.96] {
        m.mesh.board(b.share(0.22..0.78, y..y + 0.04, 0.35..0.41), &main);
    }
    m.solid(b.share(0.22..0.78, 0.15..1.0, 0.35..0.41));
    for wheel in b.share(0.0..0.1, 0.0..0.22, 0.0..0.44).both_sides() {
        m.solid(wheel);
        m.mesh.rounded(wheel, 0.45 * wheel.size().min(), 3, &stuff::RUBBER.surface());
    }
    m.mesh.crisp(b.share(0.1..0.9, 0.1..0.12, 0.2..0.24), &stuff::STEEL.surface());
    m
}

/// A panel with tools that hang on it.
pub(super) fn tool_board(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    m.solid(b);
    let main = a.main(Stuff(Finish::Paint, 0xd8c9a8));
    let (steel, wood, red) = (stuff::STEEL.surface(), stuff::OAK.surface(), stuff::RED.surface());
    m.mesh.board(b.share(0.0..1.0, 0.0..1.0, 0.0..0.45), &main);
    let mut hang = |x: std::ops::Range<f64>, y: std::ops::Range<f64>, z: f64, s: &crate::mesh::Surface| {
        m.mesh.crisp(b.share(x, y, 0.45..z), s);
    };
    // A hammer, a saw, three screwdrivers, a spanner, pliers.
    hang(0.08..0.1, 0.25..0.72, 0.8, &wood);
    hang(0.05..0.14, 0.72..0.8, 1.0, &steel);
    hang(0.2..0.42, 0.62..0.76, 0.65, &steel);
    hang(0.42..0.48, 0.6..0.8, 0.8, &wood);
    for i in 0..3 {
        let x = 0.55 + 0.06 * f64::from(i);
        hang(x..x + 0.025, 0.6..0.8, 0.9, &red);
        hang(x + 0.008..x + 0.017, 0.38..0.6, 0.7, &steel);
    }
    hang(0.78..0.8, 0.3..0.8, 0.7, &steel);
    hang(0.76..0.82, 0.74..0.84, 0.75, &steel);
    hang(0.87..0.89, 0.3..0.6, 0.8, &red);
    hang(0.91..0.93, 0.3..0.6, 0.8, &red);
    hang(0.87..0.93, 0.6..0.76, 0.75, &steel);
    hang(0.2..0.46, 0.2..0.28, 0.8, &steel);
    m
}
