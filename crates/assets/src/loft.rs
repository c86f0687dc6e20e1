//! Two more primitives: rings of points joined to a skin (hulls of boats, shoes, hats that are no circle in plan), and a
//! ring that has a hole.

use crate::block::Block;
use crate::mesh::{Mesh, Surface};
use crate::shapes::turn;
use scenelang_layout::Vec3;

/// Points of a ring about an upright axis, and of the section of a torus.
const AROUND: usize = 24;
const SECTION: usize = 8;

/// An oval ring of points at a height, from +x towards +z: its middle (x, z) and its half extents (x, z). `taper` 1 is an
/// ellipse; more makes its two ends on z more pointed, less makes it fuller.
pub(crate) fn oval(y: f64, middle: [f64; 2], half: [f64; 2], taper: f64) -> Vec<Vec3> {
    let at = |k: usize| {
        let (sin, cos) = turn(k, AROUND);
        let wide = cos.signum() * cos.abs().powf(taper);
        Vec3::new(middle[0] + half[0] * wide, y, middle[1] + half[1] * sin)
    };
    (0..AROUND).map(at).collect()
}

impl Mesh {
    /// Rings of equally many points, each from +x towards +z, the first below (or, for a vessel, the last ones inside),
    /// joined by flat faces and closed at both ends. Seen from its middle an end must show all of its edge.
    pub(crate) fn loft(&mut self, rings: &[Vec<Vec3>], s: &Surface) {
        let (Some(first), Some(last)) = (rings.first(), rings.last()) else { return };
        let group = self.group(s);
        for pair in rings.windows(2) {
            let n = pair[0].len().min(pair[1].len());
            for j in 0..n {
                let k = (j + 1) % n;
                let [a, b, c, d] = [pair[0][j], pair[1][j], pair[1][k], pair[0][k]];
                group.facet(&[a, b, d]);
                group.facet(&[b, c, d]);
            }
        }
        for (ring, is_first) in [(first, true), (last, false)] {
            let middle = ring.iter().sum::<Vec3>() / ring.len().max(1) as f64;
            for j in 0..ring.len() {
                let (p, q) = (ring[j], ring[(j + 1) % ring.len()]);
                group.facet(&if is_first { [middle, p, q] } else { [middle, q, p] });
            }
        }
    }
    /// A ring about the upright axis that fills the box; `thick` is how much of the radius the ring has, up to 1.
    pub(crate) fn torus(&mut self, b: Block, thick: f64, s: &Surface) {
        let (size, c) = (b.size(), b.center());
        let (rx, ry, rz) = (size.x / 2.0, size.y / 2.0, size.z / 2.0);
        let half = (thick / 2.0).clamp(0.01, 0.49);
        let mean = half * (rx + rz) / 2.0;
        let group = self.group(s);
        let mut rings = Vec::new();
        for k in 0..AROUND {
            let (sin, cos) = turn(k, AROUND);
            let point = |j: usize| {
                let (up, out) = turn(j, SECTION);
                let r = 1.0 - half + half * out;
                let n = Vec3::new(out * cos / mean, up / ry, out * sin / mean);
                let p = Vec3::new(c.x + rx * r * cos, c.y + ry * up, c.z + rz * r * sin);
                (p, n.try_normalize(1e-18).unwrap_or_else(Vec3::y))
            };
            let ring: Vec<u32> = (0..SECTION).map(point).map(|(p, n)| group.vertex(p, n)).collect();
            rings.push(ring);
        }
        for k in 0..AROUND {
            let (near, far) = (&rings[k], &rings[(k + 1) % AROUND]);
            for j in 0..SECTION {
                let i = (j + 1) % SECTION;
                group.quad(near[j], near[i], far[i], far[j]);
            }
        }
    }
}
