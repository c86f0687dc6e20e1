//! The light that lamps give: where it comes from, its colour, and how much of it there is.

use crate::mesh::{Mesh, wide};
use scenelang_layout::Vec3;

/// A light that shines in all directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Where it is, in the object's own frame (metres).
    pub pos: Vec3,
    /// sRGB, each 0 to 1.
    pub color: [f32; 3],
    /// Luminous flux.
    pub lumens: f64,
}

/// Families of lamps, with the luminous flux of one of usual make. Screens and signs glow and light nothing.
const LAMPS: [(&str, f64); 10] = [
    ("candle", 12.0),
    ("ceiling_light", 1600.0),
    ("chandelier", 2400.0),
    ("desk_lamp", 500.0),
    ("floor_lamp", 1000.0),
    ("lamp", 800.0),
    ("pendant", 800.0),
    ("sconce", 400.0),
    ("softbox", 3000.0),
    ("table_lamp", 470.0),
];

/// The light of a thing of a family: in the middle of all of it that shines.
pub(crate) fn lights(family: &str, mesh: &Mesh) -> Vec<Light> {
    let Some((_, lumens)) = LAMPS.iter().find(|(name, _)| *name == family) else { return Vec::new() };
    let shining = || mesh.groups.iter().filter_map(|g| Some((g, g.surface.emissive?)));
    let Some((_, color)) = shining().next() else { return Vec::new() };
    let mut points = shining().flat_map(|(g, _)| &g.positions).map(|p| wide(*p));
    let Some(first) = points.next() else { return Vec::new() };
    let (lo, hi) = points.fold((first, first), |(lo, hi), p| (lo.inf(&p), hi.sup(&p)));
    vec![Light { pos: (lo + hi) / 2.0, color, lumens: *lumens }]
}
