//! Materials as small pictures that repeat without a seam: how light, how bumpy and how rough each place is. Made in code,
//! the same on every machine; one source for all that draws.
//!
//! A picture has no colour of its own: it is multiplied into any. Its mean is known, so that whoever multiplies can keep the
//! colour that was asked for. Rows run upwards: the first one is at v = 0.

mod cloth;
mod hard;
mod noise;
mod wood;

use crate::mesh::Surface;
use std::array::from_fn;
use std::sync::LazyLock;

/// A kind of material that is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Texture {
    /// Grain along v.
    Wood,
    /// A floor of boards along v.
    Boards,
    /// Threads over and under.
    Weave,
    /// Fine creases.
    Leather,
    /// Brushed along v.
    Metal,
    /// Clouds, speckles and a few veins.
    Stone,
    /// Square tiles with joints.
    Tiles,
    /// A wall.
    Plaster,
    /// Tufts.
    Carpet,
    /// Fibres.
    Paper,
    /// A leaf with veins.
    Plant,
}

/// A place of a texture.
#[derive(Clone, Copy, Debug)]
struct Texel {
    /// How much of the light is reflected, 0 to 1.
    light: f32,
    /// Metres above the lowest place.
    height: f32,
    /// Factor of the roughness, 0 to 1.
    rough: f32,
}

/// A texture, in pixels from the bottom row up.
#[derive(Debug)]
pub struct Pixels {
    /// Width and height, pixels.
    pub size: [usize; 2],
    /// Width and height, metres.
    pub tile: [f64; 2],
    /// Index into the ramp for each pixel.
    pub shade: Vec<u8>,
    /// For each shade the factors of red, green and blue, sRGB.
    pub ramp: Vec<[u8; 3]>,
    /// Mean of the factors, linear light.
    pub mean: [f32; 3],
    /// Unit normals: along u, along v and outward, each from −1 to 1 as 0 to 255.
    pub normal: Vec<[u8; 3]>,
    /// Factor of the roughness, 0 to 1 as 0 to 255.
    pub rough: Vec<u8>,
    pub rough_mean: f32,
}

/// All of them, in the order of the type.
const ALL: [Texture; 11] = [
    Texture::Wood,
    Texture::Boards,
    Texture::Weave,
    Texture::Leather,
    Texture::Metal,
    Texture::Stone,
    Texture::Tiles,
    Texture::Plaster,
    Texture::Carpet,
    Texture::Paper,
    Texture::Plant,
];

/// What a texture has at a place, in tiles.
type Places = Box<dyn Fn(f32, f32) -> Texel>;

/// How a texture is made: pixels and metres of the tile, how much its dark places take from green and blue, and its places.
struct Recipe {
    size: [usize; 2],
    tile: [f64; 2],
    warm: [f32; 2],
    places: fn() -> Places,
}

impl Texture {
    /// All kinds.
    pub fn all() -> impl Iterator<Item = Self> {
        ALL.into_iter()
    }

    /// What a surface is covered with, by the finish that its name begins with; `None`: it is smooth.
    pub fn of(surface: &Surface) -> Option<Self> {
        match surface.name.split('-').next()? {
            "wood" => Some(Self::Wood),
            "boards" => Some(Self::Boards),
            "fabric" | "velvet" | "wicker" | "mesh" => Some(Self::Weave),
            "leather" => Some(Self::Leather),
            "metal" | "iron" | "brass" => Some(Self::Metal),
            "stone" => Some(Self::Stone),
            "tiles" => Some(Self::Tiles),
            "plaster" => Some(Self::Plaster),
            "carpet" => Some(Self::Carpet),
            "paper" => Some(Self::Paper),
            "leaf" => Some(Self::Plant),
            _ => None,
        }
    }

    /// In file names: `wood`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Wood => "wood",
            Self::Boards => "boards",
            Self::Weave => "weave",
            Self::Leather => "leather",
            Self::Metal => "metal",
            Self::Stone => "stone",
            Self::Tiles => "tiles",
            Self::Plaster => "plaster",
            Self::Carpet => "carpet",
            Self::Paper => "paper",
            Self::Plant => "plant",
        }
    }

    fn recipe(self) -> Recipe {
        let of = |size, tile, warm, places| Recipe { size, tile, warm, places };
        match self {
            Self::Wood => of([256, 128], [0.6, 2.0], [0.06, 0.16], wood::wood),
            Self::Boards => of([512, 256], [1.68, 4.2], [0.05, 0.13], wood::boards),
            Self::Weave => of([128, 128], [0.1, 0.1], [0.0, 0.0], cloth::weave),
            Self::Leather => of([128, 128], [0.12, 0.12], [0.02, 0.04], cloth::leather),
            Self::Metal => of([128, 128], [0.2, 0.8], [0.0, 0.0], hard::metal),
            Self::Stone => of([128, 128], [0.8, 0.8], [0.02, 0.05], hard::stone),
            Self::Tiles => of([256, 256], [0.8, 0.8], [0.01, 0.03], hard::tiles),
            Self::Plaster => of([128, 128], [0.6, 0.6], [0.0, 0.0], hard::plaster),
            Self::Carpet => of([128, 128], [0.2, 0.2], [0.0, 0.0], cloth::carpet),
            Self::Paper => of([128, 128], [0.3, 0.3], [0.01, 0.03], cloth::paper),
            Self::Plant => of([128, 128], [0.15, 0.15], [0.0, 0.05], cloth::leaf),
        }
    }

    /// The texture itself, made when it is first asked for.
    pub fn pixels(self) -> &'static Pixels {
        static MADE: [LazyLock<Pixels>; ALL.len()] = [
            LazyLock::new(|| make(&Texture::Wood.recipe())),
            LazyLock::new(|| make(&Texture::Boards.recipe())),
            LazyLock::new(|| make(&Texture::Weave.recipe())),
            LazyLock::new(|| make(&Texture::Leather.recipe())),
            LazyLock::new(|| make(&Texture::Metal.recipe())),
            LazyLock::new(|| make(&Texture::Stone.recipe())),
            LazyLock::new(|| make(&Texture::Tiles.recipe())),
            LazyLock::new(|| make(&Texture::Plaster.recipe())),
            LazyLock::new(|| make(&Texture::Carpet.recipe())),
            LazyLock::new(|| make(&Texture::Paper.recipe())),
            LazyLock::new(|| make(&Texture::Plant.recipe())),
        ];
        &MADE[self as usize]
    }
}

impl Pixels {
    /// The factors of red, green and blue that keep the mean of a colour (linear light): no more than 1 each.
    pub fn factor(&self, color: [f32; 3]) -> [f32; 3] {
        from_fn(|i| (color[i] / self.mean[i]).min(1.0))
    }
}

fn make(recipe: &Recipe) -> Pixels {
    let [width, height] = recipe.size;
    let count = width * height;
    let place = (recipe.places)();
    let texels: Vec<Texel> = (0..count)
        .map(|at| {
            let [x, y] = [at % width, at / width];
            place((x as f32 + 0.5) / width as f32, (y as f32 + 0.5) / height as f32)
        })
        .collect();
    let byte = |v: f32| (v.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
    // Shades are sRGB, as the eye divides light; half of the steps is enough and takes less space.
    let shades: Vec<u8> = (0..=4095_u16).map(|light| byte(encoded(f32::from(light) / 4095.0)) | 1).collect();
    let shade: Vec<u8> = texels.iter().map(|t| shades[(t.light.clamp(0.0, 1.0) * 4095.0) as usize]).collect();
    let ramp: Vec<[u8; 3]> = (0..=255_u8)
        .map(|s| {
            let light = f32::from(s) / 255.0;
            [0.0, recipe.warm[0], recipe.warm[1]].map(|warm| byte(light * (1.0 - warm * (1.0 - light) * 4.0)))
        })
        .collect();
    let step = [recipe.tile[0] as f32 / width as f32, recipe.tile[1] as f32 / height as f32];
    let normal = (0..count)
        .map(|at| {
            let [x, y] = [at % width, at / width];
            let h = |x: usize, y: usize| texels[y % height * width + x % width].height;
            let du = (h(x + 1, y) - h(x + width - 1, y)) / (2.0 * step[0]);
            let dv = (h(x, y + 1) - h(x, y + height - 1)) / (2.0 * step[1]);
            let length = (du * du + dv * dv + 1.0).sqrt();
            // Even steps: the middle is 128, and small files have few values.
            [-du / length, -dv / length, 1.0 / length].map(|n| (((n * 63.5 + 64.5) as i32) * 2).clamp(1, 255) as u8)
        })
        .collect();
    let rough: Vec<u8> = texels.iter().map(|t| byte(t.rough) | 3).collect();
    let linear: Vec<[f32; 3]> = ramp.iter().map(|c| c.map(|v| decoded(f32::from(v) / 255.0))).collect();
    let sum = shade.iter().fold([0.0_f64; 3], |sum, s| from_fn(|i| sum[i] + f64::from(linear[usize::from(*s)][i])));
    let rough_sum: f64 = rough.iter().map(|r| f64::from(*r) / 255.0).sum();
    Pixels {
        size: recipe.size,
        tile: recipe.tile,
        mean: sum.map(|s| (s / count as f64) as f32),
        rough_mean: (rough_sum / count as f64) as f32,
        shade,
        ramp,
        normal,
        rough,
    }
}

/// An sRGB component from linear light.
pub fn encoded(v: f32) -> f32 {
    if v <= 0.003_130_8 { v * 12.92 } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 }
}

/// Linear light from an sRGB component.
fn decoded(v: f32) -> f32 {
    if v <= 0.040_45 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
}
