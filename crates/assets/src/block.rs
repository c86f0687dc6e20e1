//! Axis-aligned boxes in the object's frame, and the few ways furniture divides them.

use scenelang_layout::Vec3;
use std::ops::Range;

/// An axis-aligned box (metres).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Block {
    /// Least corner.
    pub min: Vec3,
    /// Greatest corner.
    pub max: Vec3,
}

/// The box of three ranges.
pub(crate) fn block(x: Range<f64>, y: Range<f64>, z: Range<f64>) -> Block {
    Block { min: Vec3::new(x.start, y.start, z.start), max: Vec3::new(x.end, y.end, z.end) }
}

impl Block {
    /// Extents.
    pub fn size(self) -> Vec3 {
        self.max - self.min
    }
    pub fn center(self) -> Vec3 {
        (self.min + self.max) / 2.0
    }
    /// The same box with another range of x.
    pub fn x(mut self, r: Range<f64>) -> Self {
        (self.min.x, self.max.x) = (r.start, r.end);
        self
    }
    /// The same box with another range of y.
    pub fn y(mut self, r: Range<f64>) -> Self {
        (self.min.y, self.max.y) = (r.start, r.end);
        self
    }
    /// The same box with another range of z.
    pub fn z(mut self, r: Range<f64>) -> Self {
        (self.min.z, self.max.z) = (r.start, r.end);
        self
    }
    /// The part of it between these shares of its width, height and depth, each 0 to 1.
    pub fn share(self, x: Range<f64>, y: Range<f64>, z: Range<f64>) -> Self {
        let (at, size) = (self.min, self.size());
        let range = |k: usize, r: Range<f64>| {
            // The far end is met exactly.
            let end = if r.end == 1.0 { self.max[k] } else { at[k] + r.end * size[k] };
            at[k] + r.start * size[k]..end
        };
        block(range(0, x), range(1, y), range(2, z))
    }
    /// Smaller by this much on each side of each axis; at most 45 % of an extent, so that something is left.
    pub fn inset(self, x: f64, y: f64, z: f64) -> Self {
        let by = Vec3::new(x, y, z).zip_map(&self.size(), |b, s| b.min(0.45 * s));
        Self { min: self.min + by, max: self.max - by }
    }
    pub fn moved(self, x: f64, y: f64, z: f64) -> Self {
        let by = Vec3::new(x, y, z);
        Self { min: self.min + by, max: self.max + by }
    }
    /// Its mirror image left and right, after itself.
    pub fn both_sides(self) -> [Self; 2] {
        [self, self.x(-self.max.x..-self.min.x)]
    }
    /// Its four images at the corners of the footprint.
    pub fn four_corners(self) -> [Self; 4] {
        let [a, b] = self.both_sides();
        let back = |c: Self| c.z(-c.max.z..-c.min.z);
        [a, b, back(a), back(b)]
    }
    /// `n` equal pieces along `axis` with gaps between them (a gap takes at most a third of a piece).
    pub fn split(self, axis: usize, n: usize, gap: f64) -> impl Iterator<Item = Self> {
        let step = (self.max[axis] - self.min[axis]) / n as f64;
        let half = gap.min(step / 3.0) / 2.0;
        (0..n).map(move |i| {
            let mut b = self;
            if i > 0 {
                b.min[axis] = self.min[axis] + step * i as f64 + half;
            }
            if i + 1 < n {
                b.max[axis] = self.min[axis] + step * (i + 1) as f64 - half;
            }
            b
        })
    }
}

/// How many pieces of about `each` go into `length`, within limits.
pub(crate) fn pieces(length: f64, each: f64, least: usize, most: usize) -> usize {
    ((length / each).round() as usize).clamp(least, most)
}
