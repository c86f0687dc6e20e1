//! The picture: the room in perspective from a raised corner, near walls cut down to a kerb, ceilings off; or from above; or as
//! someone sees it who comes in through its door.
//!
//! Drawn by a small z-buffer rasteriser: no window, no graphics card, the same pixels on every machine. Each thread draws a
//! band of rows; how many there are changes nothing.

mod bands;
mod cloth;
#[cfg(not(target_family = "wasm"))]
mod labels;
mod light;
mod raster;
mod sources;
mod stage;

use crate::scene::View;
use crate::{ExportError, Exporter, OutFile, Scene, Shows};

/// `picture.png`.
#[derive(Clone, Copy, Debug)]
pub struct Picture {
    pub view: PictureView,
    /// Width and height, pixels.
    pub size: [usize; 2],
}

impl Default for Picture {
    fn default() -> Self {
        Self { view: PictureView::Iso, size: SIZE }
    }
}

/// Where a picture is seen from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PictureView {
    /// At the door of the largest room, by someone who looks at its middle.
    Eye,
    /// Straight down from above.
    Top,
    /// From a raised corner.
    #[default]
    Iso,
}

/// Width and height unless others are asked for, pixels.
pub const SIZE: [usize; 2] = [1280, 800];

impl Exporter for Picture {
    fn name(&self) -> &'static str {
        "picture"
    }
    fn shows(&self) -> Shows {
        Shows::Bodies
    }
    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError> {
        Ok(vec![OutFile::new("picture.png", png(scene, *self)?)])
    }
}

/// The picture as PNG.
///
/// # Errors
/// The picture cannot be encoded: a side is 0 or far too long.
pub fn png(scene: &Scene, Picture { view: kind, size }: Picture) -> Result<Vec<u8>, ExportError> {
    let aspect = size[0] as f64 / size[1].max(1) as f64;
    let inside = if kind == PictureView::Eye { View::entering(scene) } else { None };
    // Where there is no room to stand in, it is seen from outside.
    let (view, kind) = match (inside, kind) {
        (Some(view), _) => (view, kind),
        (None, PictureView::Top) => (View::above(scene, aspect), kind),
        (None, _) => (View::of(scene, aspect), PictureView::Iso),
    };
    let stage = stage::Stage::new(scene, &view, kind);
    #[cfg_attr(target_family = "wasm", expect(unused_mut, reason = "names are written where text can be drawn"))]
    let mut pixels = light::render(&stage, &view, size, bands::cores());
    #[cfg(not(target_family = "wasm"))]
    labels::write(&mut pixels, scene, &view, size)?;
    encoded(&pixels, size).map_err(|e| ExportError::Format("picture", e.to_string()))
}

/// Red, green and blue of each pixel as PNG.
fn encoded(pixels: &[u8], size: [usize; 2]) -> Result<Vec<u8>, png::EncodingError> {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, size[0] as u32, size[1] as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_filter(png::Filter::Adaptive);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SceneInput;
    use scenelang_base::FileId;
    use scenelang_lang::{Options, compile_text};
    use scenelang_layout::file;
    use std::path::Path;

    const PROGRAM: &str = r#"
region room; object table; table.category <- "table"; object lamp; object window; window.category <- "window";
assert connects(window, room);
"#;
    const LAYOUT: &str = r#"{ "format": "scenelang.layout/1", "variables": {}, "draws": {},
  "objects": {
    "table":  { "pos": [0, 0, 0], "rot": [0, 20, 0], "scale": [1.6, 0.75, 0.8] },
    "lamp":   { "pos": [0.3, 0.75, 0], "rot": [0, 0, 0], "scale": [0.2, 0.4, 0.2] },
    "window": { "pos": [-0.5, 0.9, -2.015], "rot": [0, 0, 0], "scale": [1.2, 1.2, 0.06],
                "asset": { "parts": [ { "shape": "box", "pos": [0, 0.6, 0], "size": [1.2, 1.2, 0.06] } ] } } },
  "regions": { "room": { "pos": [0, 0, 0], "scale": [4, 2.6, 4] } } }"#;

    #[test]
    fn the_number_of_threads_changes_no_byte() {
        let compiled = compile_text("room.scene", Path::new("room.scene"), PROGRAM, Options::default());
        let read = file::read(LAYOUT, FileId(0));
        assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
        let scene = Scene::build(&SceneInput {
            name: "room",
            program: &compiled.program.unwrap(),
            sources: &compiled.sources,
            files: &[compiled.main],
            layout: &read.layout,
            layout_text: LAYOUT,
            report: &serde_json::json!({ "ok": true, "constraints": [], "diagnostics": [] }),
        });
        let scene = scene.unwrap();
        let size = [160, 101];
        let view = View::of(&scene, size[0] as f64 / size[1] as f64);
        let mut stage = stage::Stage::new(&scene, &view, PictureView::Iso);
        // The last object lets light through.
        let last = stage.triangles.iter().map(|t| usize::from(t.look)).next_back().unwrap();
        stage.looks[last].opacity = 0.4;
        let drawn = [1, 2, 3, 7].map(|threads| light::render(&stage, &view, size, threads));
        assert_eq!(drawn[0].len(), 3 * size[0] * size[1]);
        assert!(drawn.iter().all(|other| *other == drawn[0]));
    }
}
