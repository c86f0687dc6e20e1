//! The plan: the room from straight above, as SVG, and the same as PNG (not in a browser, which draws it itself).

mod canvas;
mod dimensions;
mod furniture;
mod labels;
mod svg;

pub(crate) use canvas::{escape, text_width};
pub use svg::svg;

use crate::{ExportError, Exporter, OutFile, Scene};

/// `plan.svg` and `plan.png`.
#[derive(Clone, Copy, Debug)]
pub struct Plan;

impl Exporter for Plan {
    fn name(&self) -> &'static str {
        "plan"
    }
    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError> {
        let drawing = svg(scene);
        #[cfg(not(target_family = "wasm"))]
        let picture = Some(OutFile::new("plan.png", png(&drawing)?));
        #[cfg(target_family = "wasm")]
        let picture = None;
        Ok([OutFile::new("plan.svg", drawing)].into_iter().chain(picture).collect())
    }
}

/// Pixels of `plan.png` for one of the drawing.
#[cfg(not(target_family = "wasm"))]
const ZOOM: f32 = 1.5;

#[cfg(not(target_family = "wasm"))]
fn png(drawing: &str) -> Result<Vec<u8>, ExportError> {
    let pixels = crate::drawing::pixels(drawing, ZOOM, "plan")?;
    pixels.encode_png().map_err(|e| ExportError::Format("plan", e.to_string()))
}
