//! Faces that lie in one plane are moved apart, or viewers would show a flicker of both: of primitives that share a plane
//! the one with less of it is taken for a detail and stays, and the other draws back by less than can be seen.
//!
//! So the box of the mesh stays what it is, and primitives stay closed.

use crate::mesh::{Group, wide};
use scenelang_layout::Vec3;
use std::collections::BTreeMap;
use std::ops::Range;

/// Planes no farther from each other than this are one (metres).
const NEAR: f64 = 1.5e-4;
/// How far a primitive draws back (metres), and the most of its own extent.
const BACK: f64 = 4e-4;
const MOST: f64 = 0.1;
/// Less than this is no face (square metres), and touching by this much is no overlap (metres).
const FACE: f64 = 1e-6;
const TOUCH: f64 = 2e-4;

/// A primitive: its group, and its indices there.
pub(crate) struct Piece {
    pub group: usize,
    pub indices: Range<usize>,
}

/// A triangle in its plane.
struct Flat {
    piece: usize,
    /// The direction of its normal, roughly.
    way: [i32; 3],
    normal: Vec3,
    offset: f64,
    area: f64,
    lo: Vec3,
    hi: Vec3,
}

impl Flat {
    fn of(piece: usize, [a, b, c]: [Vec3; 3]) -> Option<Self> {
        let normal = (b - a).cross(&(c - a));
        let area = normal.norm() / 2.0;
        if area.is_nan() || area < FACE {
            return None;
        }
        let normal = normal / (2.0 * area);
        // A step between two ways of a thousand, and not at a round number.
        let way = [0, 1, 2].map(|i| (normal[i] * 500.0 + 0.37).floor() as i32);
        Some(Self { piece, way, normal, offset: normal.dot(&a), area, lo: a.inf(&b).inf(&c), hi: a.sup(&b).sup(&c) })
    }

    /// Whether two triangles of one plane overlap, as far as their boxes tell.
    fn overlaps(&self, other: &Self) -> bool {
        let within = |i: usize| {
            // Across the plane there is nothing to overlap.
            self.normal[i].abs() > 0.9 || self.hi[i].min(other.hi[i]) - self.lo[i].max(other.lo[i]) > TOUCH
        };
        (0..3).all(within)
    }
}

/// Moves faces apart.
pub(crate) fn apart(groups: &mut [Group], pieces: &[Piece]) {
    let mut flats: Vec<Flat> = Vec::new();
    for (number, piece) in pieces.iter().enumerate() {
        let group = &groups[piece.group];
        let corners = group.indices[piece.indices.clone()].chunks_exact(3);
        flats.extend(
            corners.filter_map(|t| Flat::of(number, [t[0], t[1], t[2]].map(|i| wide(group.positions[i as usize])))),
        );
    }
    flats.sort_by(|a, b| a.way.cmp(&b.way).then(a.offset.total_cmp(&b.offset)));
    let mut moves = Vec::new();
    for plane in flats.chunk_by(|a, b| a.way == b.way && b.offset - a.offset < NEAR) {
        if plane.iter().any(|f| f.piece != plane[0].piece) {
            moves.extend(drawn_back(plane));
        }
    }
    let all = groups.iter().flat_map(|g| &g.positions).map(|p| wide(*p));
    let whole = all.fold((Vec3::repeat(f64::MAX), Vec3::repeat(f64::MIN)), |(lo, hi), p| (lo.inf(&p), hi.sup(&p)));
    for (piece, normal, offset, steps) in moves {
        draw_back(&mut groups[pieces[piece].group], &pieces[piece].indices, (normal, offset), steps, whole);
    }
}

/// Which primitives of a plane draw back, from where, and by how many steps.
fn drawn_back(plane: &[Flat]) -> Vec<(usize, Vec3, f64, u32)> {
    let mut areas: BTreeMap<usize, f64> = BTreeMap::new();
    for flat in plane {
        *areas.entry(flat.piece).or_default() += flat.area;
    }
    // The smallest first; of equal ones the one that was drawn last.
    let mut order: Vec<(usize, f64)> = areas.into_iter().collect();
    order.sort_by(|a, b| {
        let equal = (a.1 - b.1).abs() < 1e-3 * a.1.max(b.1);
        if equal { b.0.cmp(&a.0) } else { a.1.total_cmp(&b.1) }
    });
    let mut steps: Vec<(usize, u32)> = Vec::new();
    for (piece, _) in order {
        let own = || plane.iter().filter(|f| f.piece == piece);
        let meets = |other: usize| plane.iter().filter(|f| f.piece == other).any(|f| own().any(|g| f.overlaps(g)));
        let deepest = steps.iter().filter(|(other, _)| meets(*other)).map(|(_, step)| step + 1).max();
        steps.push((piece, deepest.unwrap_or(0)));
    }
    let of = |(piece, steps): (usize, u32)| {
        let flat = plane.iter().find(|f| f.piece == piece)?;
        (steps > 0).then_some((piece, flat.normal, flat.offset, steps))
    };
    steps.into_iter().filter_map(of).collect()
}

/// Moves what of a primitive is in a plane inwards, and nothing out of the box of the whole.
fn draw_back(
    group: &mut Group,
    indices: &Range<usize>,
    (normal, offset): (Vec3, f64),
    steps: u32,
    (lo, hi): (Vec3, Vec3),
) {
    let mut own: Vec<u32> = group.indices[indices.clone()].to_vec();
    own.sort_unstable();
    own.dedup();
    let height = |i: u32| normal.dot(&wide(group.positions[i as usize])) - offset;
    let thick = own.iter().map(|&i| -height(i)).fold(0.0, f64::max);
    let by = normal * (BACK * f64::from(steps)).min(MOST * thick);
    let level: Vec<u32> = own.iter().copied().filter(|&i| height(i).abs() < NEAR).collect();
    for i in level {
        let p = (wide(group.positions[i as usize]) - by).sup(&lo).inf(&hi);
        group.positions[i as usize] = [p.x as f32, p.y as f32, p.z as f32];
    }
}
