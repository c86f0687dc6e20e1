//! Fences around machines.

use crate::ask::Ask;
use crate::block::{Block, pieces};
use crate::looks::{Finish, Stuff, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;

/// The way in is so wide (metres).
const GATE: f64 = 0.9;

/// Posts, rails and bars of one side, along x (0) or z (2).
fn side(m: &mut BuiltModel, b: Block, axis: usize, posts: &Surface, bars: &Surface) {
    m.solid(b);
    let along = |from: f64, to: f64| match axis {
        0 => b.share(from..to, 0.0..1.0, 0.0..1.0),
        _ => b.share(0.0..1.0, 0.0..1.0, from..to),
    };
    let length = b.size()[axis];
    let thick = (0.05 / length).min(0.2);
    for post in [along(0.0, thick), along(1.0 - thick, 1.0)] {
        m.mesh.crisp(post, posts);
    }
    let thin = |b: Block| match axis {
        0 => b.share(0.0..1.0, 0.0..1.0, 0.3..0.7),
        _ => b.share(0.3..0.7, 0.0..1.0, 0.0..1.0),
    };
    for rail in [(0.04, 0.07), (0.5, 0.53), (0.95, 1.0)] {
        m.mesh.crisp(thin(along(thick, 1.0 - thick)).share(0.0..1.0, rail.0..rail.1, 0.0..1.0), posts);
    }
    for bar in thin(along(thick, 1.0 - thick)).split(axis, pieces(length, 0.16, 1, 40), 0.0).skip(1) {
        let bar = match axis {
            0 => bar.share(0.0..0.08, 0.07..0.95, 0.0..1.0),
            _ => bar.share(0.0..1.0, 0.07..0.95, 0.0..0.08),
        };
        m.mesh.crisp(bar, bars);
    }
}

/// Four sides, with a gap in the front one (+z) to go in by.
pub(super) fn enclosure(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let posts = a.main(Stuff(Finish::Paint, 0xe3b52a));
    let bars = a.second(stuff::BLACK_STEEL);
    let (t, gate) = (0.05_f64.min(0.1 * a.w).min(0.1 * a.d), GATE.min(0.5 * a.w));
    side(&mut m, b.z(b.min.z..b.min.z + t), 0, &posts, &bars);
    for end in b.x(b.min.x..b.min.x + t).z(b.min.z + t..b.max.z - t).both_sides() {
        side(&mut m, end, 2, &posts, &bars);
    }
    for front in b.x(b.min.x..-gate / 2.0).z(b.max.z - t..b.max.z).both_sides() {
        side(&mut m, front, 0, &posts, &bars);
    }
    m
}
