//! The plan: the room from straight above, as SVG, and the same as PNG.

mod canvas;
mod dimensions;
mod furniture;
mod labels;
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
        let picture = png::png(&drawing)?;
        Ok(vec![OutFile::new("plan.svg", drawing), OutFile::new("plan.png", picture)])
    }
}
