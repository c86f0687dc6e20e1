//! The picture: the room in perspective from a raised corner, near walls cut down to a kerb, ceilings off.
//!
//! Drawn by a small z-buffer rasteriser: no window, no graphics card, the same pixels on every machine.

mod light;
mod pattern;
mod raster;
mod stage;

use crate::scene::View;
use crate::{ExportError, Exporter, OutFile, Scene};
use image::{ExtendedColorType, ImageEncoder, codecs::png::PngEncoder};

/// `picture.png`.
#[derive(Clone, Copy, Debug)]
pub struct Picture;

/// Width and height, pixels.
const SIZE: [usize; 2] = [1280, 800];

impl Exporter for Picture {
    fn name(&self) -> &'static str {
        "picture"
    }
    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError> {
        Ok(vec![OutFile::new("picture.png", png(scene, SIZE)?)])
    }
}

/// The picture in a size of its own: width and height, pixels.
///
/// # Errors
/// The picture cannot be encoded: a side is 0 or far too long.
pub fn png(scene: &Scene, size: [usize; 2]) -> Result<Vec<u8>, ExportError> {
    let view = View::of(scene, size[0] as f64 / size[1] as f64);
    let stage = stage::Stage::new(scene, &view);
    let pixels = light::render(&stage, &view, size);
    let mut png = Vec::new();
    PngEncoder::new(&mut png)
        .write_image(&pixels, size[0] as u32, size[1] as u32, ExtendedColorType::Rgb8)
        .map_err(|e| ExportError::Format("picture", e.to_string()))?;
    Ok(png)
}
