//! Options of `export` and `synth` that say which formats are written, and how.

use clap::{Args as ClapArgs, ValueEnum};

/// Which formats `export` and `synth` write.
#[derive(ClapArgs, Debug, Clone)]
pub struct Formats {
    /// Only these formats, separated by commas: unity, glb, plan, picture, preview (the default ones), mjcf, usd, usdz, sdf,
    /// obj, report
    #[arg(long, value_name = "FORMATS", value_delimiter = ',', value_parser = crate::formats::name)]
    pub only: Vec<String>,
    /// All formats, not only the default ones
    #[arg(long, conflicts_with = "only")]
    pub all_formats: bool,
    /// Add rigid bodies to the GLB file: colliders, masses, and joints with limits (the draft extension KHR_physics_rigid_bodies)
    #[arg(long)]
    pub gltf_physics: bool,
    /// The version of Unity that the project targets [default: that of the project in the output folder, or
    /// 2022.3]
    #[arg(long, value_enum, value_name = "VERSION")]
    pub unity: Option<UnityVersion>,
    /// The viewpoint of the picture
    #[arg(long, value_enum, value_name = "VIEW", default_value_t = ViewName::Iso)]
    pub view: ViewName,
    /// The size of the picture in pixels: each side from 16 to 4096, at most 8294400 pixels (3840x2160) in all
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1280x800", value_parser = size, allow_hyphen_values = true)]
    pub size: [usize; 2],
}

/// What a side of a picture may measure, and how many pixels it may have: what is drawn takes about 150 bytes for each.
const SIDES: std::ops::RangeInclusive<usize> = 16..=4096;
const PIXELS: usize = 3840 * 2160;

/// `--size`: width and height of the picture.
fn size(text: &str) -> Result<[usize; 2], String> {
    let sides = text.split_once('x').and_then(|(width, height)| Some([side(width)?, side(height)?]));
    let Some([width, height]) = sides else {
        return Err("expected width and height in pixels, such as 1280x800".to_owned());
    };
    if [width, height].iter().any(|side| !SIDES.contains(side)) {
        return Err(format!("each side must be from {} to {} pixels", SIDES.start(), SIDES.end()));
    }
    if width * height > PIXELS {
        return Err(format!("a picture may have at most {PIXELS} pixels, as 3840x2160 has"));
    }
    Ok([width, height])
}

/// A number of digits only; what is too large for a number is as large as one can be.
fn side(text: &str) -> Option<usize> {
    let digits = !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    digits.then(|| text.parse().unwrap_or(usize::MAX))
}

/// `synth --view`, `export --view`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum ViewName {
    /// From the door of the largest room at a height of 1.6 m, or from a corner if it has no door
    Eye,
    /// Straight down from above, without ceilings
    Top,
    /// From a raised corner, without ceilings and near walls
    Iso,
}

/// `synth --unity`, `export --unity`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnityVersion {
    /// Unity 2022.3
    #[value(name = "2022.3")]
    V2022,
    /// Unity 6 (6000.0)
    #[value(name = "6000")]
    V6000,
}
