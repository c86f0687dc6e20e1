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
        let view = View::of(scene, SIZE[0] as f64 / SIZE[1] as f64);
        let stage = stage::Stage::new(scene, &view);
        let pixels = light::render(&stage, &view, SIZE);
        let mut png = Vec::new();
        PngEncoder::new(&mut png)
            .write_image(&pixels, SIZE[0] as u32, SIZE[1] as u32, ExtendedColorType::Rgb8)
            .map_err(|e| ExportError::Format("picture", e.to_string()))?;
        Ok(vec![OutFile::new("picture.png", png)])
    }
}
