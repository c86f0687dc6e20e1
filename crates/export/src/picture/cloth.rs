//! The textures of the furniture library as they are seen from afar: averaged over what a pixel covers, so that nothing
//! flickers or speckles.

use scenelang_assets::textures::{Pixels, Texture};
use std::array::from_fn;
use std::sync::OnceLock;

/// What a texture says of a place.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sample {
    /// Factors of red, green and blue, linear light.
    pub color: [f32; 3],
    /// How far the normal leans along u and v.
    pub lean: [f32; 2],
    /// Factor of the roughness.
    pub rough: f32,
}

/// Factor of red, lean along u and v, roughness: four numbers, which processors take at once.
type Texel = [f32; 4];
/// Steps of the tint.
const TINTS: usize = 256;

/// A texture in all sizes, each half of the one before.
pub(super) struct Cloth {
    levels: Vec<Level>,
    /// For factors of red from 0 to 1, those of green and blue in relation to it.
    tint: Vec<[f32; 2]>,
    /// The lesser side of a texel of the first, metres.
    fine: f32,
    /// Width and height of the whole, metres.
    tile: [f32; 2],
}

struct Level {
    size: [usize; 2],
    texels: Vec<Texel>,
}

impl Cloth {
    /// The sizes of a kind of texture, made when they are first asked for.
    pub fn of(texture: Texture) -> &'static Self {
        const KINDS: usize = 16;
        static MADE: [OnceLock<Cloth>; KINDS] = [const { OnceLock::new() }; KINDS];
        MADE[texture as usize % KINDS].get_or_init(|| Self::new(texture.pixels()))
    }

    fn new(pixels: &Pixels) -> Self {
        let linear: Vec<[f32; 3]> =
            pixels.ramp.iter().map(|c| c.map(|v| crate::glb::linear(f32::from(v) / 255.0) as f32)).collect();
        let lean = |v: u8| (f32::from(v) - 128.0) / 127.0;
        let texels = (0..pixels.shade.len())
            .map(|at| {
                let [along_u, along_v, _] = pixels.normal[at];
                let red = linear[usize::from(pixels.shade[at])][0];
                [red, lean(along_u), lean(along_v), f32::from(pixels.rough[at]) / 255.0]
            })
            .collect();
        let tint = (0..TINTS)
            .map(|step| {
                let red = step as f32 / (TINTS - 1) as f32;
                let near = linear.partition_point(|c| c[0] < red).clamp(1, linear.len() - 1);
                let [r, g, b] = linear[near];
                [g / r.max(1e-6), b / r.max(1e-6)]
            })
            .collect();
        let mut levels = vec![Level { size: pixels.size, texels }];
        while let Some(smaller) = levels.last().and_then(Level::half) {
            levels.push(smaller);
        }
        let side = |i: usize| (pixels.tile[i] / pixels.size[i] as f64) as f32;
        Self { levels, tint, fine: side(0).min(side(1)), tile: pixels.tile.map(|metres| metres as f32) }
    }

    /// Width and height, metres.
    pub fn tile(&self) -> [f32; 2] {
        self.tile
    }

    /// The mean over about so many metres at a place, in tiles.
    pub fn sample(&self, at: [f32; 2], metres: f32) -> Sample {
        let last = self.levels.len() - 1;
        let level = log2((metres / self.fine).max(1.0)).min(last as f32);
        let low = level as usize;
        // Mostly one level is near enough; only half-way between two both are looked at.
        let share = (((level - low as f32) - 0.25) * 2.0).clamp(0.0, 1.0);
        let near = |level: usize| self.levels[level.min(last)].at(at);
        let texel = if share == 0.0 {
            near(low)
        } else if share == 1.0 {
            near(low + 1)
        } else {
            let (fine, coarse) = (near(low), near(low + 1));
            from_fn(|i| fine[i] + (coarse[i] - fine[i]) * share)
        };
        let [red, along_u, along_v, rough] = texel;
        let [green, blue] = self.tint[((red * (TINTS - 1) as f32) as usize).min(TINTS - 1)];
        Sample { color: [red, red * green, red * blue], lean: [along_u, along_v], rough }
    }
}

impl Level {
    /// The same at half the size; `None` for a single texel.
    fn half(&self) -> Option<Self> {
        if self.size == [1, 1] {
            return None;
        }
        let size = self.size.map(|s| s.div_ceil(2));
        let [width, height] = self.size;
        let texels = (0..size[0] * size[1])
            .map(|at| {
                let (x, y) = (at % size[0] * 2, at / size[0] * 2);
                let four = [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)];
                let four = four.map(|(x, y)| &self.texels[y % height * width + x % width]);
                from_fn(|i| four.iter().map(|t| t[i]).sum::<f32>() / 4.0)
            })
            .collect();
        Some(Self { size, texels })
    }

    /// Between the four texels about a place, in tiles.
    fn at(&self, [u, v]: [f32; 2]) -> Texel {
        let [width, height] = self.size;
        let along = |t: f32, n: usize| {
            // Half a texel before the first is the last.
            let t = (t - floor(t)) * n as f32 + n as f32 - 0.5;
            let low = t as usize;
            (low % n, (low + 1) % n, t - low as f32)
        };
        let ((x0, x1, s), (y0, y1, t)) = (along(u, width), along(v, height));
        let [a, b, c, d] = [(x0, y0), (x1, y0), (x0, y1), (x1, y1)].map(|(x, y)| &self.texels[y * width + x]);
        let [p, q, r, o] = [(1.0 - s) * (1.0 - t), s * (1.0 - t), (1.0 - s) * t, s * t];
        from_fn(|i| a[i] * p + b[i] * q + c[i] * r + d[i] * o)
    }
}

/// As `f32::floor`, for what is not huge; much faster.
fn floor(t: f32) -> f32 {
    let whole = t as i32 as f32;
    if whole > t { whole - 1.0 } else { whole }
}

/// Nearly the binary logarithm of what is at least 1: straight between powers of two.
fn log2(v: f32) -> f32 {
    let bits = v.to_bits();
    ((bits >> 23) as i32 - 127) as f32 + (bits & 0x7f_ffff) as f32 / (1 << 23) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn from_afar_every_texture_is_its_mean() {
        for texture in Texture::all() {
            let (cloth, pixels) = (Cloth::of(texture), texture.pixels());
            let far = cloth.sample([0.3, 0.7], 100.0);
            for i in 0..3 {
                assert!((far.color[i] - pixels.mean[i]).abs() < 0.01, "{texture:?}: {far:?}");
            }
            assert!((far.rough - pixels.rough_mean).abs() < 1e-3 && far.lean.iter().all(|l| l.abs() < 0.02), "{far:?}");
        }
    }

    #[test]
    fn near_by_it_is_the_pixel_and_it_repeats() {
        let (cloth, pixels) = (Cloth::of(Texture::Wood), Texture::Wood.pixels());
        let [width, height] = pixels.size;
        let (x, y) = (37, 101);
        let at = [(x as f32 + 0.5) / width as f32, (y as f32 + 0.5) / height as f32];
        let shade = pixels.ramp[usize::from(pixels.shade[y * width + x])];
        let own = cloth.sample(at, 0.0).color.map(|c| c.powf(1.0 / 2.2) * 255.0);
        assert!((0..3).all(|i| (own[i] - f32::from(shade[i])).abs() < 4.0), "{own:?} {shade:?}");
        let next = cloth.sample([at[0] - 3.0, at[1] + 2.0], 0.0).color;
        assert!((0..3).all(|i| (next[i] - cloth.sample(at, 0.0).color[i]).abs() < 1e-3));
    }
}
