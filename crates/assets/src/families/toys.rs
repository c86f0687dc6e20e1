//! Toys: animals of cloth that sit, building blocks, a chess set, a theatre of puppets.

use super::strokes::{of, small};
use crate::ask::Ask;
use crate::block::{Block, block};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::BuiltModel;

/// A bear that sits, or another animal of cloth: rabbit, koala, monkey, frog.
pub(super) fn teddy(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let (rabbit, koala) = (a.says(&["rabbit", "bunny", "hare"]), a.says(&["koala"]));
    let (monkey, frog) = (a.says(&["monkey"]), a.says(&["frog"]));
    let color = match () {
        () if rabbit => 0xb7aa9c,
        () if koala => 0x8f979d,
        () if monkey => 0x6b4630,
        () if frog => 0x6da544,
        () => 0xa5733f,
    };
    let fur = a.main(Stuff(Finish::Fabric, color));
    let light = shade(&fur, 1.35);
    let dark = stuff::DARK_PLASTIC.surface();
    // Long ears stand over the rest.
    let top = if rabbit { 0.72 } else { 1.0 };
    let share = |x: std::ops::Range<f64>, y: std::ops::Range<f64>, z: std::ops::Range<f64>| {
        let end = if y.end == 1.0 { top } else { top * y.end };
        b.share(x, top * y.start..end, z)
    };
    let body = share(0.16..0.84, 0.0..0.58, 0.1..0.82);
    let head = share(0.2..0.8, 0.5..0.94, 0.16..0.84);
    for part in [body, head] {
        m.solid(part);
        m.mesh.ball(part, &fur);
    }
    let ear = match () {
        () if rabbit => b.share(0.26..0.42, 0.62..1.0, 0.36..0.54),
        () if koala => share(0.02..0.36, 0.68..1.0, 0.36..0.6),
        () if monkey => share(0.06..0.28, 0.62..0.84, 0.4..0.58),
        () if frog => share(0.24..0.44, 0.82..1.0, 0.5..0.74),
        () => share(0.14..0.36, 0.82..1.0, 0.36..0.58),
    };
    let limbs = [share(0.0..0.28, 0.26..0.52, 0.34..0.76), share(0.06..0.4, 0.0..0.24, 0.5..1.0)];
    for part in [ear].into_iter().chain(limbs).flat_map(Block::both_sides) {
        m.solid(part);
        m.mesh.ball(part, &fur);
    }
    if monkey {
        let crown = share(0.36..0.64, 0.9..1.0, 0.3..0.6);
        m.solid(crown);
        m.mesh.bead(crown, &fur);
    }
    let tail = share(0.42..0.58, 0.06..0.2, 0.0..0.2);
    m.solid(tail);
    m.mesh.ball(tail, &fur);
    m.mesh.ball(share(0.3..0.7, 0.1..0.46, 0.6..0.86), &light);
    let face = if monkey { share(0.28..0.72, 0.54..0.86, 0.6..0.9) } else { share(0.36..0.64, 0.55..0.74, 0.68..0.92) };
    m.mesh.ball(face, &light);
    let nose =
        if koala { share(0.42..0.58, 0.62..0.78, 0.84..0.96) } else { share(0.45..0.55, 0.67..0.74, 0.84..0.94) };
    m.mesh.bead(nose, &dark);
    let eye = match () {
        () if frog => share(0.3..0.38, 0.9..0.96, 0.7..0.77),
        () if monkey => share(0.36..0.43, 0.73..0.79, 0.84..0.92),
        () => share(0.34..0.41, 0.73..0.79, 0.72..0.8),
    };
    for eye in eye.both_sides() {
        m.mesh.bead(eye, &dark);
    }
    m
}

const COLORS: [u32; 6] = [0xc8392f, 0x3f7fb5, 0xe3bd3a, 0x6da544, 0xd9783a, 0x7a5aa0];

/// A block to build with: with a letter's field on each side, with studs, with the nine colours of a side; a brick.
pub(super) fn building_block(a: &Ask) -> BuiltModel {
    if a.says(&["rubik", "cube"]) {
        return small(a, |mesh| {
            mesh.rounded(block(-1.0..1.0, -1.0..1.0, -1.0..1.0), 0.06, 1, &stuff::DARK_PLASTIC.surface());
            for axis in 0..3 {
                for (side, low) in [(0, -1.03), (3, 0.97)] {
                    let mut face = block(-0.96..0.96, -0.96..0.96, -0.96..0.96);
                    (face.min[axis], face.max[axis]) = (low, low + 0.06);
                    for (i, row) in face.split((axis + 1) % 3, 3, 0.08).enumerate() {
                        for (k, cell) in row.split((axis + 2) % 3, 3, 0.08).enumerate() {
                            let color = COLORS[(axis + side + (i * 3 + k) * (i + 2 * k) % 7 % 3) % 6];
                            mesh.crisp(cell, &of(Finish::Plastic, color));
                        }
                    }
                }
            }
        });
    }
    if a.says(&["lego", "set"]) {
        return small(a, |mesh| {
            let places = [
                (-0.9, 0.0, -0.8, 0.8, 0.5),
                (0.0, 0.0, -0.9, 0.8, 0.8),
                (-0.8, 0.0, 0.1, 1.0, 0.6),
                (0.35, 0.0, 0.2, 0.5, 0.5),
                (-0.6, 0.24, -0.6, 0.7, 0.4),
                (0.2, 0.24, -0.5, 0.5, 0.8),
                (-0.5, 0.24, 0.15, 0.8, 0.5),
            ];
            for (k, (x, y, z, w, d)) in places.into_iter().enumerate() {
                let s = of(Finish::Plastic, COLORS[k % 6]);
                let brick = block(x..x + w, y..y + 0.22, z..z + d);
                mesh.crisp(brick, &s);
                for row in brick.y(brick.max.y..brick.max.y + 0.07).split(0, 3, 0.0) {
                    for stud in row.split(2, 2, 0.0) {
                        mesh.lathe(
                            stud.inset(0.2 * stud.size().x, 0.0, 0.2 * stud.size().z),
                            &[(1.0, 0.0), (1.0, 1.0)],
                            8,
                            &s,
                        );
                    }
                }
            }
        });
    }
    if a.says(&["brick"]) {
        let clay = a.main(Stuff(Finish::Stone, 0xa5523a));
        return small(a, |mesh| {
            mesh.rounded(block(-1.0..1.0, 0.0..0.62, -0.48..0.48), 0.03, 1, &clay);
            for hole in block(-0.75..0.75, 0.6..0.63, -0.2..0.2).split(0, 3, 0.16) {
                mesh.lathe(hole, &[(1.0, 0.0), (1.0, 1.0)], 16, &shade(&clay, 0.4));
            }
        });
    }
    if a.says(&["yoga", "climbing", "foam", "sponge"]) {
        let sponge = a.says(&["sponge"]);
        let usual = if sponge { 0xe6c53a } else { 0x5f7fb0 };
        let foam = a.main(Stuff(Finish::Rubber, usual));
        return small(a, |mesh| {
            let low = if sponge { 0.3 } else { 0.0 };
            mesh.rounded(block(-1.0..1.0, low..1.0, -1.0..1.0), 0.06, 2, &foam);
            if sponge {
                mesh.rounded(block(-1.0..1.0, 0.0..0.32, -1.0..1.0), 0.05, 1, &of(Finish::Fabric, 0x3f7a4c));
            }
        });
    }
    let mut dice = a.dice();
    let wood = a.main(Stuff(Finish::Paint, *dice.pick(&COLORS)));
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, -1.0..1.0, -1.0..1.0), 0.12, 2, &stuff::BIRCH.surface());
        for axis in 0..3 {
            for low in [-1.02, 0.97] {
                let mut field = block(-0.72..0.72, -0.72..0.72, -0.72..0.72);
                (field.min[axis], field.max[axis]) = (low, low + 0.05);
                mesh.crisp(field, &wood);
                // A bar and a foot, as of a letter.
                let out = if low < 0.0 { low - 0.02 } else { low + 0.04 };
                let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                for (from, to) in
                    [([-0.3, -0.45], [-0.1, 0.45]), ([-0.1, -0.45], [0.35, -0.25]), ([-0.1, 0.05], [0.2, 0.22])]
                {
                    let mut bar = field;
                    (bar.min[axis], bar.max[axis]) = (out, out + 0.03);
                    (bar.min[u], bar.max[u], bar.min[v], bar.max[v]) = (from[0], to[0], from[1], to[1]);
                    mesh.crisp(bar, &stuff::BIRCH.surface());
                }
            }
        }
    })
}

/// A board of 64 fields with some of the pieces on it.
pub(super) fn chess_set(a: &Ask) -> BuiltModel {
    let wood = a.main(stuff::WALNUT);
    let (pale, dark) = (stuff::BIRCH.surface(), of(Finish::Wood, 0x3a2a20));
    small(a, |mesh| {
        mesh.rounded(block(-1.0..1.0, 0.0..0.1, -1.0..1.0), 0.02, 1, &wood);
        mesh.crisp(block(-0.88..0.88, 0.05..0.11, -0.88..0.88), &pale);
        let field = 0.22;
        for k in 0..32 {
            let (row, column) = (k / 4, 2 * (k % 4) + k / 4 % 2);
            let (x, z) = (-0.88 + field * f64::from(column), -0.88 + field * f64::from(row));
            mesh.crisp(block(x..x + field, 0.06..0.115, z..z + field), &dark);
        }
        if !a.says(&["set", "game"]) {
            return;
        }
        let places = [
            (0, 0, 3),
            (1, 1, 0),
            (2, 0, 1),
            (3, 0, 4),
            (4, 0, 5),
            (5, 1, 0),
            (6, 2, 0),
            (7, 0, 3),
            (0, 6, 0),
            (2, 7, 1),
            (3, 5, 0),
            (4, 7, 5),
            (5, 6, 0),
            (7, 7, 3),
        ];
        for (column, row, kind) in places {
            let (x, z) = (-0.77 + field * f64::from(column), -0.77 + field * f64::from(row));
            let high = 0.26 + 0.06 * f64::from(kind);
            let s = if row < 4 { &dark } else { &pale };
            let turned = [(1.0, 0.0), (0.9, 0.12), (0.4, 0.3), (0.34, 0.65), (0.6, 0.72), (0.5, 0.88), (0.0, 1.0)];
            mesh.lathe(block(x - 0.075..x + 0.075, 0.11..0.11 + high, z - 0.075..z + 0.075), &turned, 8, s);
        }
    })
}

/// A stage with a roof and curtains over a low front.
pub(super) fn puppet_theatre(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wall = a.main(Stuff(Finish::Paint, 0x3f6f9c));
    let cloth = a.second(Stuff(Finish::Velvet, 0xa8282c));
    let gold = stuff::BRASS.surface();
    m.board(b.share(0.0..1.0, 0.0..0.44, 0.5..1.0), &wall);
    m.board(b.share(0.0..1.0, 0.44..0.48, 0.4..1.0), &gold);
    for side in b.share(0.0..0.1, 0.48..0.82, 0.5..1.0).both_sides() {
        m.board(side, &wall);
    }
    for side in b.share(0.0..0.06, 0.0..0.44, 0.0..0.5).both_sides() {
        m.board(side, &wall);
    }
    let gable = b.share(0.0..1.0, 0.82..1.0, 0.5..1.0);
    let (s, c) = (gable.size(), gable.center());
    let outline = [
        (gable.min.x, gable.min.y),
        (gable.max.x, gable.min.y),
        (gable.max.x, c.y),
        (c.x, gable.max.y),
        (gable.min.x, c.y),
    ];
    m.extrude(2, &outline, gable.min.z..gable.max.z, &wall);
    m.mesh
        .ball(block(-0.06 * s.x..0.06 * s.x, c.y - 0.2 * s.y..c.y + 0.2 * s.y, 0.99 * gable.max.z..gable.max.z), &gold);
    for half in b.share(0.1..0.36, 0.48..0.82, 0.62..0.78).both_sides() {
        m.solid(half);
        for (k, fold) in half.split(0, 5, 0.0).enumerate() {
            let by = if k % 2 == 0 { 0.0 } else { 0.3 * half.size().z };
            m.mesh.crisp(fold.z(fold.min.z..fold.max.z - by), &shade(&cloth, if k % 2 == 0 { 1.0 } else { 0.8 }));
        }
    }
    for x in [0.42, 0.58] {
        let puppet = b.share(x - 0.06..x + 0.06, 0.48..0.66, 0.6..0.72);
        m.solid(puppet);
        m.mesh.crisp(
            puppet.share(0.1..0.9, 0.0..0.6, 0.0..1.0),
            &of(Finish::Fabric, if x < 0.5 { 0x6da544 } else { 0xe3bd3a }),
        );
        m.mesh.ball(puppet.share(0.0..1.0, 0.5..1.0, 0.0..1.0), &of(Finish::Ceramic, 0xe0a988));
    }
    m
}
