//! The plan: the room from straight above, as SVG, and the same as PNG (not in a browser, which draws it itself).

mod canvas;
mod dimensions;
mod furniture;
mod labels;
#[cfg(not(target_family = "wasm"))]
mod png;
mod svg;

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
        let picture = Some(OutFile::new("plan.png", png::png(&drawing)?));
        #[cfg(target_family = "wasm")]
        let picture = None;
        Ok([OutFile::new("plan.svg", drawing)].into_iter().chain(picture).collect())
    }
}
