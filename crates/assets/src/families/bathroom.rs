//! Toilets, baths, showers and vanities: backs at −z.

use super::kitchen::{hatch, tap};
use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::BuiltModel;
use scenelang_layout::Vec3;

/// A bowl with a closed lid (the support surface) and a cistern behind it.
pub(super) fn toilet(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::CERAMIC);
    let seat = 0.43_f64.min(0.56 * a.h);
    m.surface = Some(seat);
    let tank = 0.27 * a.d;
    let lid = 0.06 * seat;
    let behind = b.z(b.min.z..b.min.z + tank);
    m.solid(behind);
    m.mesh.rounded(behind.y(0.78 * seat..a.h - 0.05 * a.h), 0.03, 3, &main);
    m.mesh.rounded(behind.y(a.h - 0.05 * a.h..a.h), 0.01, 2, &main);
    m.mesh.board(behind.inset(0.22 * a.w, 0.0, 0.0).y(0.0..0.8 * seat), &main);
    m.mesh.drum(
        block(-0.03 * a.w..0.03 * a.w, a.h - 0.01 * a.h..a.h, b.min.z + 0.4 * tank..b.min.z + 0.6 * tank),
        &stuff::CHROME.surface(),
    );
    let bowl = b.inset(0.04 * a.w, 0.0, 0.0).z(b.min.z + 0.7 * tank..b.max.z);
    m.solid_drum(bowl.y(0.0..seat - lid));
    // The lid is hinged before the cistern.
    let cover = bowl.z(b.min.z + tank..b.max.z).y(seat - lid..seat);
    let before = m.parts.len();
    m.solid_drum(cover);
    if m.parts.len() > before {
        m.lid("lid", cover);
    }
    m.mesh.lathe(
        bowl.y(0.0..seat - lid),
        &[(0.55, 0.0), (0.56, 0.08), (0.52, 0.45), (0.8, 0.72), (0.98, 0.92), (1.0, 1.0)],
        24,
        &main,
    );
    m.mesh.lathe(bowl.y(seat - lid..seat), &[(0.97, 0.0), (1.0, 0.2), (1.0, 0.7), (0.94, 1.0)], 24, &shade(&main, 1.2));
    m
}

/// A bowl on the wall.
pub(super) fn urinal(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::CERAMIC);
    m.solid(b);
    m.mesh.rounded(b.z(b.min.z..b.min.z + 0.35 * a.d), 0.05, 3, &main);
    let bowl = b.inset(0.05 * a.w, 0.0, 0.0).y(0.0..0.4 * a.h).z(b.min.z + 0.05 * a.d..b.max.z);
    m.mesh.lathe(bowl, &[(0.3, 0.0), (0.7, 0.15), (0.95, 0.6), (1.0, 1.0), (0.85, 1.0), (0.75, 0.6)], 24, &main);
    let pipe =
        block(-0.03 * a.w..0.03 * a.w, 0.85 * a.h..a.h, b.min.z + 0.4 * a.d..b.min.z + 0.4 * a.d + 0.06 * a.w.min(a.d));
    m.mesh.drum(pipe, &stuff::CHROME.surface());
    m
}

/// A bath: four walls and a floor, a tap at the left end.
pub(super) fn bathtub(a: &Ask) -> BuiltModel {
    if a.says(&["corner"]) && a.w > 0.6 * a.d && a.d > 0.6 * a.w {
        return corner_bathtub(a);
    }
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::CERAMIC);
    let inner = shade(&main, 0.95);
    let rim = 0.075_f64.min(0.14 * a.w.min(a.d));
    let floor = 0.22 * a.h;
    m.solid(b.y(0.0..floor));
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let sides = [b.z(-z..-z + rim), b.z(z - rim..z)];
    let ends = [b.x(-x..-x + rim), b.x(x - rim..x)];
    for (wall, drawn) in sides.iter().map(|w| (*w, w.y(0.0..a.h))).chain(ends.map(|w| (w, w.y(0.0..0.995 * a.h)))) {
        // One piece to the eye: the long sides go through, the ends stand between them.
        m.solid(wall.y(floor..a.h));
        m.mesh.rounded(drawn, 0.012, 3, &main);
    }
    m.mesh.rounded(b.inset(0.8 * rim, 0.0, 0.8 * rim).y(0.0..floor), 0.02, 2, &inner);
    // The slope to lean on, at the right end.
    let slope = [(floor, x - rim), (a.h - 0.1 * a.h, x - rim), (floor, x - rim - 0.16 * a.w)].map(|(y, x)| (x, y));
    m.mesh.extrude(2, &slope, -z + rim..z - rim, &inner);
    let r = 0.025_f64.min(0.1 * a.w).min(0.1 * a.d);
    m.mesh.drum(block(-0.3 * a.w - r..-0.3 * a.w + r, floor..floor + 0.01 * a.h, -r..r), &stuff::CHROME.surface());
    // A tap over the rim, with a handle at each side.
    let chrome = stuff::CHROME.surface();
    let (thick, reach) = (0.02_f64.min(0.2 * rim), 0.028_f64.min(0.1 * a.w));
    m.mesh.rounded(block(-x + rim..-x + rim + reach, 0.86 * a.h..0.93 * a.h, -thick..thick), 0.008, 2, &chrome);
    for side in [-1.0, 1.0] {
        let middle = side * (0.1_f64.min(0.2 * a.d));
        let handle = block(-x + rim..-x + rim + 0.4 * reach, 0.84 * a.h..0.95 * a.h, middle - thick..middle + thick);
        m.mesh.rounded(handle, 0.008, 2, &chrome);
    }
    m
}

/// A tray, two panes of glass, a column with a rose.
pub(super) fn shower(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::CERAMIC);
    let chrome = stuff::CHROME.surface();
    let tray = 0.08_f64.min(0.1 * a.h);
    let t = 0.012_f64.min(0.05 * a.w).min(0.05 * a.d);
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    m.rounded(b.y(0.0..tray), 0.015, &main);
    for pane in [b.x(x - t..x), b.x(-x..-x + 0.3 * a.w).z(z - t..z)] {
        m.solid(pane.y(tray..a.h));
        m.mesh.crisp(pane.y(tray..a.h - 0.02 * a.h), &stuff::GLASS.surface());
        m.mesh.board(pane.y(a.h - 0.02 * a.h..a.h), &chrome);
    }
    let r = 0.012_f64.min(0.04 * a.w).min(0.04 * a.d).min(0.025 * a.h);
    let back = -z + 3.0 * r;
    m.solid(block(-2.0 * r..2.0 * r, tray..0.97 * a.h, -z..-z + 4.0 * r));
    let at = |y: f64, z: f64| Vec3::new(0.0, y * a.h, z);
    m.mesh.tube(&[at(0.4, back), at(0.93, back), at(0.97, back + 3.0 * r), at(0.97, 0.0)], r, &chrome);
    let rose = block(-0.13 * a.w..0.13 * a.w, 0.93 * a.h..0.965 * a.h, -0.13 * a.d..0.13 * a.d);
    m.mesh.drum(rose, &chrome);
    m.solid(rose.z(-z + 4.0 * r..0.13 * a.d));
    m.mesh.board(block(-0.05 * a.w..0.05 * a.w, 0.48 * a.h..0.51 * a.h, -z + 2.0 * r..-z + 5.0 * r), &chrome);
    m
}

/// Bars between two rails on the wall, a towel over them.
pub(super) fn towel_rail(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let metal = a.main(stuff::CHROME);
    m.solid(b);
    let t = 0.03_f64.min(0.1 * a.w);
    for side in b.x(b.min.x..b.min.x + t).both_sides() {
        m.mesh.board(side.z(b.min.z..b.max.z), &metal);
    }
    let n = pieces(a.h, 0.09, 1, 16);
    for bar in b.inset(0.8 * t, 0.0, 0.0).split(1, n, 0.0) {
        let (c, r) = (bar.center().y, 0.25 * bar.size().y.min(0.4 * a.d));
        m.mesh.rod(Vec3::new(bar.min.x, c, 0.1 * a.d), Vec3::new(bar.max.x, c, 0.1 * a.d), r, &metal);
    }
    if a.h > 0.3 {
        let towel = block(-0.3 * a.w..0.25 * a.w, 0.35 * a.h..0.86 * a.h, 0.15 * a.d..b.max.z);
        m.mesh.rounded(towel, 0.3 * towel.size().z, 3, &a.second(stuff::LINEN));
    }
    m
}

/// A pillar with a rose and a pull, and a basin for the eyes: for laboratories.
pub(super) fn emergency_shower(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let yellow = a.main(Stuff(Finish::Paint, 0xe5b82e));
    let green = stuff::GREEN_LIGHT.surface();
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let r = 0.025_f64.min(0.06 * a.w).min(0.06 * a.d);
    let foot = 0.02_f64.min(0.05 * a.h);
    if a.h < 1.3 {
        // An eyewash alone: a basin at the top of a column.
        m.drum(b.y(0.0..foot).inset(0.25 * a.w, 0.0, 0.25 * a.d), &yellow);
        m.drum(block(-r..r, foot..0.75 * a.h, -r..r), &yellow);
        m.lathe(
            b.y(0.75 * a.h..a.h),
            &[(0.3, 0.0), (0.8, 0.3), (1.0, 0.8), (1.0, 1.0), (0.88, 1.0), (0.6, 0.5)],
            &green,
        );
        return m;
    }
    m.drum(b.y(0.0..foot), &yellow);
    let back = -z + 0.25 * a.d;
    m.drum(block(-r..r, foot..0.95 * a.h, back - r..back + r), &yellow);
    m.board(block(-r..r, 0.95 * a.h..a.h, back - r..z - 0.25 * a.d), &yellow);
    let rose = b.y(0.88 * a.h..0.95 * a.h).inset(0.2 * a.w, 0.0, 0.0).z(-0.3 * z..z);
    m.lathe(rose, &[(1.0, 0.0), (0.95, 0.35), (0.3, 1.0)], &green);
    let basin = b.y(0.4 * a.h..0.47 * a.h).z(back..z - 0.1 * a.d);
    m.lathe(basin, &[(0.3, 0.0), (0.8, 0.3), (1.0, 1.0), (0.9, 1.0), (0.6, 0.5)], &green);
    m.mesh.rod(Vec3::new(0.3 * x, 0.66 * a.h, 0.2 * z), Vec3::new(0.3 * x, 0.89 * a.h, 0.2 * z), 0.4 * r, &yellow);
    m.solid(block(0.3 * x - r..0.3 * x + r, 0.66 * a.h..0.88 * a.h, 0.2 * z - r..0.2 * z + r));
    let sign = b.inset(0.3 * a.w, 0.0, 0.0).y(0.7 * a.h..0.82 * a.h).z(back - 1.6 * r..back - r);
    m.board(sign, &green);
    m
}

/// A soap or paper dispenser, a hand dryer: a rounded case on the wall.
pub(super) fn dispenser(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::PLASTIC);
    m.solid(b);
    m.mesh.rounded(b.y(0.08 * a.h..a.h), 0.03, 3, &main);
    m.mesh.board(b.inset(0.12 * a.w, 0.0, 0.1 * a.d).y(0.0..0.12 * a.h), &stuff::DARK_PLASTIC.surface());
    if a.says(&["tap", "soap"]) {
        tap(&mut m, b.inset(0.4 * a.w, 0.0, 0.0).y(0.0..0.3 * a.h), &stuff::CHROME.surface());
        m.parts.truncate(1);
    }
    m
}

/// A cabinet with a basin let into its top, or with two where it is wide or says so.
pub(super) fn vanity_unit(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::OAK);
    let (top, bowl, chrome) = (a.second(stuff::CERAMIC), stuff::CERAMIC.surface(), stuff::CHROME.surface());
    let rim = a.h - 0.2_f64.min(0.22 * a.h);
    let (thick, deep) = (0.07 * rim, 0.035_f64.min(0.1 * a.d));
    m.surface = Some(rim);
    let plinth = 0.12 * rim;
    let body = b.y(plinth..rim - thick).inset(0.01, 0.0, 0.0).z(b.min.z..b.max.z - 0.03 * a.d);
    let wall = 0.02_f64.min(0.05 * a.w).min(0.1 * rim).min(0.1 * a.d);
    m.shell(body.z(body.min.z..body.max.z - deep), wall, 0.0, &main);
    m.board(b.inset(0.05, 0.0, 0.0).y(0.0..plinth).z(b.min.z..b.max.z - 0.15 * a.d), &stuff::DARK_PLASTIC.surface());
    let doors = pieces(a.w, 0.45, 1, 6);
    let faces = body.inset(0.005, 0.004, 0.0).z(body.max.z - deep..body.max.z);
    for (i, door) in faces.split(0, doors, 0.006).enumerate() {
        hatch(&mut m, door, true, i % 2 == 1, &shade(&main, 1.06), &chrome);
    }
    let slab = b.y(rim - thick..rim);
    m.solid(slab);
    let back = 0.2 * a.d;
    let basins = if a.w >= 1.15 || a.says(&["double", "two", "twin"]) { 2 } else { 1 };
    let holes: Vec<Block> = slab
        .split(0, basins, 0.0)
        .map(|half| {
            let (c, wide) = (half.center(), (0.25_f64).min(0.36 * half.size().x));
            half.x(c.x - wide..c.x + wide).z(b.min.z + back..b.max.z - 0.12 * a.d)
        })
        .collect();
    // Strips of the top around the basins, from the left to the right.
    let mut from = slab.min.x;
    for hole in &holes {
        m.mesh.crisp(slab.x(from..hole.min.x), &top);
        m.mesh.crisp(slab.x(hole.min.x..hole.max.x).z(slab.min.z..hole.min.z), &top);
        m.mesh.crisp(slab.x(hole.min.x..hole.max.x).z(hole.max.z..slab.max.z), &top);
        m.mesh.crisp(hole.y(slab.min.y..slab.min.y + 0.3 * thick), &shade(&bowl, 0.86));
        let c = hole.center();
        let half = 0.04_f64.min(0.1 * a.w);
        let spout = b.min.z + 0.05 * a.d;
        tap(&mut m, block(c.x - half..c.x + half, rim..a.h, spout..spout + 0.42 * a.d.min(0.4)), &chrome);
        from = hole.max.x;
    }
    m.mesh.crisp(slab.x(from..slab.max.x), &top);
    m
}

/// The outline of a bath in a corner, from +x towards +z: two straight sides at -x and -z, and a bow before them. It is
/// shrunk towards a point within by a factor.
fn bow(a: &Ask, factor: f64) -> Vec<[f64; 2]> {
    const STEPS: usize = 12;
    let middle = [-0.1 * a.w, -0.1 * a.d];
    let at = |k: usize| {
        let (sin, cos) = crate::shapes::turn(k, 4 * STEPS);
        // Fuller than a quarter of a circle.
        [-a.w / 2.0 + a.w * cos.powf(0.7), -a.d / 2.0 + a.d * sin.powf(0.7)]
    };
    let outline = (0..=STEPS).map(at).chain([[-a.w / 2.0, -a.d / 2.0]]);
    outline.map(|p| [0, 1].map(|i| middle[i] + factor * (p[i] - middle[i]))).collect()
}

/// A bath for a corner, which is at -x and -z: a bowed front, a wide rim, water, a tap over the corner.
fn corner_bathtub(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(stuff::CERAMIC);
    let (rim, floor) = (0.9 * a.h, 0.25 * a.h);
    let ring = |factor: f64, y: f64| bow(a, factor).into_iter().map(|[x, z]| Vec3::new(x, y, z)).collect::<Vec<_>>();
    let rings = [
        ring(0.95, 0.0),
        ring(0.95, 0.78 * a.h),
        ring(1.0, 0.8 * a.h),
        ring(1.0, rim),
        ring(0.78, rim),
        ring(0.64, floor),
    ];
    m.mesh.loft(&rings, &main);
    m.solid_hull([ring(0.95, 0.0), ring(0.95, floor)].concat());
    // Walls in pieces, four of the bow and two at the walls of the room.
    let (outer, inner) = (bow(a, 1.0), bow(a, 0.7));
    let last = outer.len() - 1;
    let spans = [[0, 3], [3, 6], [6, 9], [9, 12], [last - 1, last], [last, 0]];
    for span in spans {
        let corners = span.map(|k| [outer[k], inner[k]]).concat();
        let mut points: Vec<Vec3> = Vec::new();
        for y in [floor, rim] {
            points.extend(corners.iter().map(|[x, z]| Vec3::new(*x, y, *z)));
            if span[1] > span[0] + 1 {
                points.extend((span[0] + 1..span[1]).map(|k| Vec3::new(outer[k][0], y, outer[k][1])));
            }
        }
        m.solid_hull(points);
    }
    let water: Vec<(f64, f64)> = bow(a, 0.77).into_iter().map(|[x, z]| (z, x)).collect();
    m.mesh.extrude(1, &water, 0.7 * a.h..0.76 * a.h, &Stuff(Finish::Water, 0x8fcfe6).surface());
    let chrome = stuff::CHROME.surface();
    let spout = a.whole().share(0.05..0.09, 0.9..1.0, 0.05..0.09);
    m.board(spout, &chrome);
    m.mesh.board(a.whole().share(0.09..0.17, 0.955..1.0, 0.06..0.08), &chrome);
    m.solid(a.whole().share(0.09..0.17, 0.955..1.0, 0.06..0.08));
    for (x, z) in [(0.05, 0.14), (0.14, 0.04)] {
        m.drum(a.whole().share(x..x + 0.04, 0.9..0.96, z..z + 0.04), &chrome);
    }
    m
}
