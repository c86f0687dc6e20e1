//! What is sold and sat on in shops and theatres: flowers in buckets, ice cream in tubs, fruit in crates, records, seats of
//! an audience, carts for what one buys.

use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use crate::shapes::sphere;

/// A padded seat between two panels with arm rests, and a high padded back.
pub(super) fn theatre_seat(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let pad = a.main(Stuff(Finish::Velvet, 0x8a2432));
    let (dark, wood) = (stuff::DARK_PLASTIC.surface(), stuff::WALNUT.surface());
    for panel in b.share(0.0..0.09, 0.0..0.62, 0.14..0.9).both_sides() {
        m.board(panel, &dark);
        m.board(panel.share(0.0..1.0, 1.0..1.08, -0.06..1.06), &wood);
    }
    m.board(b.share(0.09..0.91, 0.3..0.36, 0.24..0.92), &dark);
    m.cushion(b.share(0.1..0.9, 0.36..0.49, 0.22..1.0), &pad);
    m.cushion(b.share(0.1..0.9, 0.4..1.0, 0.03..0.22), &pad);
    m.board(b.share(0.12..0.88, 0.36..0.94, 0.0..0.03), &dark);
    m.surface = Some(0.49 * a.h);
    m
}

const PETALS: &[Stuff] = &[
    Stuff(Finish::Leaf, 0xd9546b),
    Stuff(Finish::Leaf, 0xf0b93a),
    Stuff(Finish::Leaf, 0xf3e9ef),
    Stuff(Finish::Leaf, 0x9a5fb5),
    Stuff(Finish::Leaf, 0xe8824a),
];

/// A bucket of cut flowers of one colour.
pub(super) fn flower_bucket(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let zinc = a.main(Stuff(Finish::Metal, 0xa7adb0));
    let mut dice = a.dice();
    let petals = dice.pick(PETALS).surface();
    let pail = b.share(0.14..0.86, 0.0..0.46, 0.14..0.86);
    m.lathe(pail, &[(0.78, 0.0), (1.0, 0.94), (1.0, 1.0)], &zinc);
    let stems = b.share(0.1..0.9, 0.46..0.74, 0.1..0.9);
    m.lathe(stems, &[(0.8, 0.0), (1.0, 1.0)], &stuff::LEAF.surface());
    let heads = b.share(0.0..1.0, 0.72..1.0, 0.0..1.0);
    m.solid_drum(heads);
    m.mesh.stretch(heads, |mesh| bunch(mesh, &petals, dice.unit()));
    m
}

/// Blossoms in rings, higher in the middle.
fn bunch(mesh: &mut Mesh, petals: &Surface, turn: f64) {
    let rings: [(u32, f64, f64); 3] = [(1, 0.0, 0.66), (5, 0.5, 0.45), (9, 0.8, 0.0)];
    for (n, far, low) in rings {
        for k in 0..n {
            let (sin, cos) = (std::f64::consts::TAU * (f64::from(k) / f64::from(n) + turn)).sin_cos();
            let (x, z, r) = (far * cos, far * sin, 0.2);
            let blossom = block(x - r..x + r, low..low + 0.34, z - r..z + r);
            let tint = if k % 2 == 0 { petals.clone() } else { shade(petals, 0.88) };
            mesh.rounded(blossom, 0.15, 1, &tint);
        }
    }
}

const SCOOPS: &[Stuff] = &[
    Stuff(Finish::Ceramic, 0xf3e3bd),
    Stuff(Finish::Ceramic, 0xe89aa9),
    Stuff(Finish::Ceramic, 0x6e4632),
    Stuff(Finish::Ceramic, 0xa9cf9b),
    Stuff(Finish::Ceramic, 0xf2c14e),
    Stuff(Finish::Ceramic, 0x8a5a86),
];

/// A counter with tubs of ice cream behind a pane that the guests look through, at +z; who serves stands at -z.
pub(super) fn ice_cream_counter(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::WHITE);
    let (steel, glass) = (stuff::STEEL.surface(), stuff::GLASS.surface());
    m.board(b.share(0.02..0.98, 0.0..0.08, 0.06..0.9), &stuff::DARK_PLASTIC.surface());
    m.board(b.share(0.0..1.0, 0.08..0.66, 0.0..1.0), &main);
    let well = b.share(0.03..0.97, 0.66..0.7, 0.2..0.9);
    m.board(well, &steel);
    let tubs = pieces(a.w - 0.1, 0.18, 2, 12);
    m.solid(b.share(0.04..0.96, 0.7..0.78, 0.22..0.88));
    for (row, place) in b.share(0.04..0.96, 0.7..0.78, 0.22..0.88).split(2, 2, 0.0).enumerate() {
        for (k, tub) in place.split(0, tubs, 0.0).enumerate() {
            let ice = SCOOPS[(k * 5 + row * 3) % SCOOPS.len()].surface();
            let heap = tub.share(0.06..0.94, 0.0..1.0, 0.08..0.92);
            m.mesh.rounded(heap, 0.45 * heap.size().min(), 2, &ice);
        }
    }
    let t = 0.012_f64.min(0.05 * a.w).min(0.05 * a.d);
    let hall = b.share(0.0..1.0, 0.66..0.96, 0.0..1.0);
    for pane in hall.x(hall.min.x..hall.min.x + t).z(hall.min.z + 0.1 * a.d..hall.max.z - t).both_sides() {
        m.board(pane, &glass);
    }
    m.board(hall.z(hall.max.z - t..hall.max.z), &glass);
    m.board(b.share(0.0..1.0, 0.96..1.0, 0.3..1.0), &steel);
    m
}

const SLEEVES: &[u32] = &[0x2f5d7c, 0xb9422f, 0xd9a441, 0x3c6b4f, 0x222629, 0xe6dfd2, 0x7b4a75];

/// A box on legs, open above, with records in rows that one leafs through.
pub(super) fn record_bin(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wood = a.main(stuff::OAK);
    let chest = b.share(0.0..1.0, 0.56..0.9, 0.0..1.0);
    m.legs(b.share(0.03..0.97, 0.0..0.56, 0.06..0.94), 0.05_f64.min(0.08 * a.w), &wood);
    m.board(chest.share(0.0..1.0, 0.0..0.08, 0.0..1.0), &wood);
    let t = 0.018_f64.min(0.04 * a.w).min(0.1 * a.d);
    for side in chest.share(0.0..1.0, 0.08..1.0, 0.0..1.0).x(chest.min.x..chest.min.x + t).both_sides() {
        m.board(side, &wood);
    }
    let inner = chest.share(0.0..1.0, 0.08..1.0, 0.0..1.0).x(chest.min.x + t..chest.max.x - t);
    for wall in [inner.z(inner.min.z..inner.min.z + t), inner.z(inner.max.z - t..inner.max.z)] {
        m.board(wall, &wood);
    }
    let mut dice = a.dice();
    let rows = pieces(inner.size().x, 0.36, 1, 6);
    let held = inner.z(inner.min.z + 1.5 * t..inner.max.z - 1.5 * t);
    for place in held.split(0, rows, 0.02) {
        let stack = place.y(place.min.y..a.h);
        m.solid(stack);
        for (k, sleeve) in stack.split(2, pieces(stack.size().z, 0.04, 4, 24), 0.012).enumerate() {
            let tint = Stuff(Finish::Paper, *dice.pick(SLEEVES)).surface();
            // The first is as high as the box.
            let high = if k == 0 { 0.0 } else { sleeve.size().y * (0.08 * dice.unit()) };
            m.mesh.crisp(sleeve.y(sleeve.min.y..sleeve.max.y - high), &tint);
        }
    }
    m
}

const FRUIT: &[u32] = &[0xc8402f, 0xe8912d, 0x6fa13c, 0xe3c23f, 0x5b3a63, 0xd97b4f];

/// No more pieces of fruit than this are drawn on a stand.
const HEAPED: usize = 47;

/// Crates of fruit and vegetables in tiers that rise to the back, tilted to the front.
pub(super) fn produce_stand(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wood = a.main(stuff::OAK);
    let mut dice = a.dice();
    let tiers = pieces(a.h, 0.42, 1, 3);
    m.board(b.share(0.0..1.0, 0.0..1.0, 0.0..0.04), &wood);
    let columns = pieces(a.w, 0.5, 2, 3);
    let each = (HEAPED / (tiers * columns)).clamp(2, 5);
    let mut kind = (dice.unit() * FRUIT.len() as f64) as usize;
    for (tier, depth) in b.share(0.0..1.0, 0.0..1.0, 0.04..1.0).split(2, tiers, 0.0).enumerate() {
        let floor = a.h * (0.3 + 0.4 * (tiers - 1 - tier) as f64 / tiers as f64);
        m.board(depth.y(0.0..floor), &wood);
        m.solid(depth.y(floor..floor + 0.24 * a.h));
        for place in depth.y(floor..floor + 0.24 * a.h).split(0, columns, 0.02) {
            kind += 1;
            crate_of_fruit(&mut m.mesh, place.inset(0.005, 0.0, 0.005), each, FRUIT[kind % FRUIT.len()]);
        }
    }
    m
}

/// A crate with a higher back, and round fruit in two rows that lie along its slope.
fn crate_of_fruit(mesh: &mut Mesh, place: Block, each: usize, color: u32) {
    let (size, low) = (place.size(), place.min.y);
    let (front, back) = (low + 0.3 * size.y, low + 0.66 * size.y);
    let wood = stuff::BIRCH.surface();
    let sides = [(low, place.max.z), (front, place.max.z), (back, place.min.z), (low, place.min.z)];
    let t = 0.015_f64.min(0.06 * size.x).min(0.2 * size.z);
    // Two sides and between them the bed of the fruit, a little lower.
    for x in [place.min.x, place.max.x - t] {
        mesh.extrude(0, &sides, x..x + t, &wood);
    }
    let bed = [
        (low, place.max.z),
        (front - 0.06 * size.y, place.max.z),
        (back - 0.06 * size.y, place.min.z),
        (low, place.min.z),
    ];
    mesh.extrude(0, &bed, place.min.x + t..place.max.x - t, &shade(&wood, 0.85));
    mesh.crisp(place.inset(t, 0.0, 0.0).y(low..front).z(place.max.z - t..place.max.z), &wood);
    let fruit = Stuff(Finish::Ceramic, color).surface();
    let profile = sphere(4);
    let rows = [each.div_ceil(2), each / 2];
    for (row, count) in rows.into_iter().enumerate() {
        let along = 0.28 + 0.44 * row as f64;
        let (y, z) = (front + (back - front) * along, place.max.z + (place.min.z - place.max.z) * along);
        let wide = (size.x - 2.0 * t) / rows[0] as f64;
        let r = (0.5 * wide).min(0.28 * size.z).min(0.26 * size.y);
        for k in 0..count {
            let x = place.center().x + (k as f64 - (count as f64 - 1.0) / 2.0) * wide;
            mesh.lathe(block(x - r..x + r, y - 0.6 * r..y + 1.4 * r, z - r..z + r), &profile, 8, &fruit);
        }
    }
}

/// A basket of wire on wheels, with a handle at -z.
pub(super) fn shopping_cart(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let wire = a.main(stuff::STEEL);
    let red = stuff::RED.surface();
    for wheel in b.share(0.06..0.16, 0.0..0.1, 0.08..0.2).four_corners() {
        m.board(wheel, &stuff::RUBBER.surface());
    }
    m.board(b.share(0.06..0.94, 0.1..0.14, 0.06..0.94), &wire);
    for post in b.share(0.08..0.12, 0.14..0.5, 0.08..0.12).both_sides() {
        m.board(post, &wire);
    }
    let basket = b.share(0.0..1.0, 0.5..0.92, 0.12..1.0);
    m.solid(basket);
    m.mesh.crisp(basket.share(0.0..1.0, 0.0..0.03, 0.0..1.0), &wire);
    for height in [0.34..0.37, 0.66..0.69, 0.96..1.0] {
        let ring = basket.share(0.0..1.0, height, 0.0..1.0);
        let t = 0.03;
        for side in ring.share(0.0..t, 0.0..1.0, 0.0..1.0).both_sides() {
            m.mesh.crisp(side, &wire);
        }
        for end in [ring.share(t..1.0 - t, 0.0..1.0, 0.0..t), ring.share(t..1.0 - t, 0.0..1.0, 1.0 - t..1.0)] {
            m.mesh.crisp(end, &wire);
        }
    }
    let bars = basket.share(0.0..1.0, 0.03..0.96, 0.0..1.0);
    for bar in bars.split(2, 9, 0.0) {
        for side in bar.share(0.004..0.014, 0.0..1.0, 0.4..0.6).both_sides() {
            m.mesh.crisp(side, &wire);
        }
    }
    for arm in b.share(0.06..0.1, 0.86..0.94, 0.04..0.12).both_sides() {
        m.board(arm, &wire);
    }
    m.board(b.share(0.02..0.98, 0.94..1.0, 0.0..0.08), &red);
    m
}
