//! Noise that repeats: values at the points of a grid, smooth between them.

/// A repeatable number in 0..1 for a cell.
pub(super) fn cell(i: u32, j: u32, seed: u32) -> f32 {
    let mut h = i.wrapping_mul(0x9e37_79b9) ^ j.wrapping_mul(0x85eb_ca6b) ^ seed.wrapping_mul(0xc2b2_ae35);
    h = (h ^ (h >> 15)).wrapping_mul(0x2c1b_3c6d);
    h = (h ^ (h >> 12)).wrapping_mul(0x297a_2d39);
    ((h ^ (h >> 15)) >> 8) as f32 / (1 << 24) as f32
}

/// What is behind the point of a number that is not negative; much faster than `fract`.
pub(super) fn fraction(t: f32) -> f32 {
    t - t as u32 as f32
}

/// How far a number that is not negative is from the nearest whole one.
pub(super) fn from_whole(t: f32) -> f32 {
    (fraction(t + 0.5) - 0.5).abs()
}

/// Smooth noise of 0 to 1.
pub(super) struct Noise {
    across: u32,
    along: u32,
    /// At the points of the grid, row by row; the last of a row and the last row are the first again.
    values: Vec<f32>,
}

impl Noise {
    /// With `across` by `along` cells in the tile.
    pub fn new(across: u32, along: u32, seed: u32) -> Self {
        let row = |j: u32| (0..=across).map(move |i| cell(i % across, j % along, seed));
        Self { across, along, values: (0..=along).flat_map(row).collect() }
    }

    /// At a place in tiles, not negative.
    pub fn at(&self, u: f32, v: f32) -> f32 {
        let (x, y) = (fraction(u) * self.across as f32, fraction(v) * self.along as f32);
        let (i, j) = ((x as u32).min(self.across - 1), (y as u32).min(self.along - 1));
        let smooth = |t: f32| t * t * (3.0 - 2.0 * t);
        let (s, t) = (smooth(x - i as f32), smooth(y - j as f32));
        let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
        let width = self.across as usize + 1;
        let first = j as usize * width + i as usize;
        let row = |first: usize| mix(self.values[first], self.values[first + 1], s);
        mix(row(first), row(first + width), t)
    }
}

/// Noise of several sizes, each half the one before and half as strong: 0 to 1, about 0.5.
pub(super) struct Clouds(Vec<Noise>);

impl Clouds {
    /// The first with `across` by `along` cells in the tile.
    pub fn new(across: u32, along: u32, octaves: u32, seed: u32) -> Self {
        Self((0..octaves).map(|k| Noise::new(across << k, along << k, seed + k)).collect())
    }

    /// At a place in tiles, not negative.
    pub fn at(&self, u: f32, v: f32) -> f32 {
        let (mut sum, mut all, mut weight) = (0.0, 0.0, 1.0);
        for noise in &self.0 {
            sum += weight * noise.at(u, v);
            all += weight;
            weight *= 0.5;
        }
        sum / all
    }
}

/// Points scattered over the tile, one in each cell of a square grid.
pub(super) struct Scattered {
    cells: u32,
    points: Vec<[f32; 2]>,
}

impl Scattered {
    /// With so many cells to a side.
    pub fn new(cells: u32, seed: u32) -> Self {
        let point = |at: u32| [0, 1].map(|k| cell(at % cells, at / cells, seed + k));
        Self { cells, points: (0..cells * cells).map(point).collect() }
    }

    /// How far a place is from the nearest two, in cells.
    pub fn at(&self, u: f32, v: f32) -> [f32; 2] {
        let cells = self.cells;
        let (x, y) = (fraction(u) * cells as f32, fraction(v) * cells as f32);
        let (i, j) = (x as u32, y as u32);
        let mut near = [f32::MAX; 2];
        for dj in 0..3 {
            for di in 0..3 {
                let (a, b) = ((i + di + cells - 1) % cells, (j + dj + cells - 1) % cells);
                let [px, py] = self.points[(b * cells + a) as usize];
                let (dx, dy) = ((i + di) as f32 - 1.0 + px - x, (j + dj) as f32 - 1.0 + py - y);
                let d = dx * dx + dy * dy;
                if d < near[0] {
                    near = [d, near[0]];
                } else if d < near[1] {
                    near[1] = d;
                }
            }
        }
        near.map(f32::sqrt)
    }
}
