//! Faces that lie in one plane are moved apart, or viewers would show a flicker of both: of primitives that share a plane
//! the one with less of it is taken for a detail and stays, and the other draws back by less than can be seen.
//!
//! So the box of the mesh stays what it is, and primitives stay closed.

use crate::mesh::{MeshGroup, wide};
use scenelang_layout::Vec3;
use std::cmp::Reverse;
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
pub(crate) struct MeshPrimitive {
    pub group: usize,
    pub indices: Range<usize>,
}

/// A triangle in its plane.
struct Flat {
    piece: usize,
    corners: [Vec3; 3],
    normal: Vec3,
    offset: f64,
    area: f64,
}

impl Flat {
    /// With the direction of its normal, roughly: equal numbers are equal directions.
    fn of(piece: usize, corners: [Vec3; 3]) -> Option<(u64, Self)> {
        let [a, b, c] = corners;
        let normal = (b - a).cross(&(c - a));
        let area = normal.norm() / 2.0;
        if area.is_nan() || area < FACE {
            return None;
        }
        let normal = normal / (2.0 * area);
        // A step between two ways of a thousand, and not at a round number; all are from 0 to 1,000.
        let step = |i: usize| (normal[i] * 500.0 + 500.37) as u64;
        let way = step(0) << 20 | step(1) << 10 | step(2);
        Some((way, Self { piece, corners, normal, offset: normal.dot(&a), area }))
    }

    /// Least and greatest corner.
    fn bounds(&self) -> [Vec3; 2] {
        let [a, b, c] = self.corners;
        [a.inf(&b).inf(&c), a.sup(&b).sup(&c)]
    }
}

/// Whether two boxes in one plane overlap. Across the plane there is nothing to overlap.
fn overlap(normal: &Vec3, [lo, hi]: &[Vec3; 2], [other_lo, other_hi]: &[Vec3; 2]) -> bool {
    let within = |i: usize| normal[i].abs() > 0.9 || hi[i].min(other_hi[i]) - lo[i].max(other_lo[i]) > TOUCH;
    (0..3).all(within)
}

/// Moves faces apart.
pub(crate) fn apart(groups: &mut [MeshGroup], pieces: &[MeshPrimitive]) {
    let mut flats: Vec<Flat> = Vec::new();
    // Directions and where their triangles are: small, since there are many and most share their plane with no other piece.
    let mut ways: Vec<(u64, u32)> = Vec::new();
    for (number, piece) in pieces.iter().enumerate() {
        let group = &groups[piece.group];
        for t in group.indices[piece.indices.clone()].chunks_exact(3) {
            if let Some((way, flat)) = Flat::of(number, [t[0], t[1], t[2]].map(|i| wide(group.positions[i as usize]))) {
                ways.push((way, flats.len() as u32));
                flats.push(flat);
            }
        }
    }
    ways.sort_unstable();
    let mut moves = Vec::new();
    for alike in ways.chunk_by(|a, b| a.0 == b.0) {
        let of = |(_, at): &(u64, u32)| &flats[*at as usize];
        let first = of(&alike[0]).piece;
        if alike.iter().all(|at| of(at).piece == first) {
            continue;
        }
        let mut alike: Vec<&Flat> = alike.iter().map(of).collect();
        alike.sort_by(|a, b| a.offset.total_cmp(&b.offset));
        for plane in alike.chunk_by(|a, b| b.offset - a.offset < NEAR) {
            if plane.iter().any(|f| f.piece != plane[0].piece) {
                moves.extend(drawn_back(plane));
            }
        }
    }
    let all = groups.iter().flat_map(|g| &g.positions).map(|p| wide(*p));
    let whole = all.fold((Vec3::repeat(f64::MAX), Vec3::repeat(f64::MIN)), |(lo, hi), p| (lo.inf(&p), hi.sup(&p)));
    if moves.is_empty() {
        return;
    }
    let before: Vec<Vec<[f32; 3]>> = groups.iter().map(|g| g.positions.clone()).collect();
    for (piece, normal, offset, steps) in moves {
        draw_back(&mut groups[pieces[piece].group], &pieces[piece].indices, (normal, offset), steps, whole);
    }
    fill(groups, &before, whole);
}

/// By less than this the mesh may fall short of its box (metres).
const SHORT: f32 = 9e-5;

/// Puts back to the box of the whole what was there, on those of its sides where nothing is left near.
fn fill(groups: &mut [MeshGroup], before: &[Vec<[f32; 3]>], (lo, hi): (Vec3, Vec3)) {
    for axis in 0..3 {
        for bound in [lo[axis] as f32, hi[axis] as f32] {
            if groups.iter().flat_map(|g| &g.positions).any(|p| (p[axis] - bound).abs() < SHORT) {
                continue;
            }
            for (group, before) in groups.iter_mut().zip(before) {
                let was_there = group.positions.iter_mut().zip(before).filter(|(_, old)| old[axis] == bound);
                was_there.for_each(|(p, old)| p[axis] = old[axis]);
            }
        }
    }
}

/// What one primitive has of a plane.
struct Share<'f> {
    piece: usize,
    area: f64,
    /// The first triangle.
    first: &'f Flat,
    /// The boxes of the triangles, and the box around all of them.
    boxes: Vec<[Vec3; 2]>,
    around: [Vec3; 2],
}

impl Share<'_> {
    /// Whether a triangle of one overlaps a triangle of another.
    fn meets(&self, other: &Self) -> bool {
        let normal = &self.first.normal;
        let meets = |own: &[Vec3; 2]| {
            overlap(normal, own, &other.around) && other.boxes.iter().any(|others| overlap(normal, own, others))
        };
        overlap(normal, &self.around, &other.around) && self.boxes.iter().any(meets)
    }
}

/// Which primitives of a plane draw back, from where, and by how many steps.
fn drawn_back(plane: &[&Flat]) -> Vec<(usize, Vec3, f64, u32)> {
    let mut shares: BTreeMap<usize, Share<'_>> = BTreeMap::new();
    for flat in plane {
        let bounds = flat.bounds();
        let new = || Share { piece: flat.piece, area: 0.0, first: flat, boxes: Vec::new(), around: bounds };
        let share = shares.entry(flat.piece).or_insert_with(new);
        share.area += flat.area;
        share.boxes.push(bounds);
        share.around = [share.around[0].inf(&bounds[0]), share.around[1].sup(&bounds[1])];
    }
    // The smallest first; of equal ones the one that was drawn last.
    let mut order: Vec<Share<'_>> = shares.into_values().collect();
    order.sort_by(|a, b| a.area.total_cmp(&b.area));
    for equal in order.chunk_by_mut(|a, b| b.area - a.area < 1e-3 * b.area) {
        equal.sort_by_key(|share| Reverse(share.piece));
    }
    let mut steps: Vec<u32> = Vec::new();
    for (at, share) in order.iter().enumerate() {
        let before = order[..at].iter().zip(&steps).filter(|(other, _)| other.meets(share));
        steps.push(before.map(|(_, step)| step + 1).max().unwrap_or(0));
    }
    let moved = order.iter().zip(steps).filter(|(_, steps)| *steps > 0);
    moved.map(|(share, steps)| (share.piece, share.first.normal, share.first.offset, steps)).collect()
}

/// Moves what of a primitive is in a plane inwards, and nothing out of the box of the whole.
fn draw_back(
    group: &mut MeshGroup,
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
