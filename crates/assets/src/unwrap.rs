//! Where on its material each vertex is: every primitive is looked at from the six sides of its own box, and each triangle
//! is drawn as it is seen from the side that it faces most.
//!
//! So one metre of a surface is one metre of its material, or at least 0.57 of it where the surface is seen at a slant, and
//! the grain (the second axis) runs along the greater extent of what is seen.

use crate::mesh::{MeshGroup, wide};
use nalgebra::UnitQuaternion;
use scenelang_layout::Vec3;
use std::ops::Range;

/// Of two sides that are faced equally the one of the axis that comes first here is taken.
const BIAS: [f64; 3] = [1.0, 1.002, 0.998];
/// One extent is the greater one if it is this much greater; else the grain is upright.
const LONGER: f64 = 1.02;

/// Gives a group its `uvs`. A primitive begins at each of the indices of `solids` and lies along the axes beside it.
/// Vertices that are seen from several sides are doubled.
pub(crate) fn unwrap(group: &mut MeshGroup, solids: &[(usize, UnitQuaternion<f64>)]) {
    let ends = solids.iter().skip(1).map(|(first, _)| *first).chain([group.indices.len()]);
    let count = group.positions.len();
    // Few vertices are seen from several sides.
    let some = count + count / 4;
    let mut out = Unwrapped {
        positions: Vec::with_capacity(some),
        normals: Vec::with_capacity(some),
        uvs: Vec::with_capacity(some),
        indices: Vec::with_capacity(group.indices.len()),
        known: vec![[NONE; 3]; count],
        local: vec![Vec3::zeros(); count],
    };
    for (number, ((first, turn), end)) in solids.iter().zip(ends).enumerate() {
        out.solid(group, *first..end, turn, number);
    }
    let Unwrapped { positions, normals, uvs, indices, .. } = out;
    (group.positions, group.normals, group.uvs, group.indices) = (positions, normals, uvs, indices);
}

/// No vertex.
const NONE: u32 = u32::MAX;

struct Unwrapped {
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    indices: Vec<u32>,
    /// For each old vertex the new ones, by the axis along which they are seen.
    known: Vec<[u32; 3]>,
    /// For each old vertex of the solid where it is along the axes of the solid.
    local: Vec<Vec3>,
}

impl Unwrapped {
    fn solid(&mut self, group: &MeshGroup, range: Range<usize>, turn: &UnitQuaternion<f64>, number: usize) {
        let corners = &group.indices[range];
        let upright = *turn == UnitQuaternion::identity();
        let (mut lo, mut hi) = (Vec3::repeat(f64::MAX), Vec3::repeat(f64::MIN));
        for &i in corners {
            let p = wide(group.positions[i as usize]);
            let p = if upright { p } else { turn.inverse_transform_vector(&p) };
            self.local[i as usize] = p;
            (lo, hi) = (lo.inf(&p), hi.sup(&p));
        }
        let sides = [0, 1, 2].map(|axis| side(axis, hi - lo));
        // No two boards come from the same place of the tree.
        let shift = [0.618, 0.414].map(|step| (number as f64 * step).fract());
        for t in corners.chunks_exact(3) {
            let [a, b, c] = [t[0], t[1], t[2]].map(|i| self.local[i as usize]);
            let normal = (b - a).cross(&(c - a));
            let faces = |axis: usize| normal[axis].abs() * BIAS[axis];
            let axis = (0..3).fold(1, |best, axis| if faces(axis) > faces(best) { axis } else { best });
            for &old in t {
                if self.known[old as usize][axis] == NONE {
                    self.known[old as usize][axis] = self.positions.len() as u32;
                    let p = self.local[old as usize] - lo;
                    let [u, v] = sides[axis];
                    self.positions.push(group.positions[old as usize]);
                    self.normals.push(group.normals[old as usize]);
                    self.uvs.push([(p[u] + shift[0]) as f32, (p[v] + shift[1]) as f32]);
                }
                self.indices.push(self.known[old as usize][axis]);
            }
        }
    }
}

/// The two axes across and along the grain of what is seen along an axis.
fn side(axis: usize, size: Vec3) -> [usize; 2] {
    let [across, along] = match axis {
        0 => [2, 1],
        1 => [0, 2],
        _ => [0, 1],
    };
    if size[across] > LONGER * size[along] { [along, across] } else { [across, along] }
}
