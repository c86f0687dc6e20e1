//! SVG as pixels, with a font that comes with the program.

use crate::ExportError;
use resvg::{tiny_skia, usvg};
use std::sync::{Arc, OnceLock};

/// Renders an SVG document, `zoom` pixels for one of its own.
pub(crate) fn pixels(svg: &str, zoom: f32, format: &'static str) -> Result<tiny_skia::Pixmap, ExportError> {
    let wrong = |why: String| ExportError::Format(format, why);
    let options = usvg::Options { fontdb: fonts(), font_family: "Noto Sans".into(), ..usvg::Options::default() };
    let tree = usvg::Tree::from_str(svg, &options).map_err(|e| wrong(e.to_string()))?;
    let size = tree.size().to_int_size().scale_by(zoom).ok_or_else(|| wrong("the drawing has no size".into()))?;
    let mut pixels = tiny_skia::Pixmap::new(size.width(), size.height())
        .ok_or_else(|| wrong(format!("the drawing is too large: {} × {} pixels", size.width(), size.height())))?;
    resvg::render(&tree, tiny_skia::Transform::from_scale(zoom, zoom), &mut pixels.as_mut());
    Ok(pixels)
}

/// Noto Sans, regular and bold; no font of the system is looked at, so that all machines draw the same.
fn fonts() -> Arc<usvg::fontdb::Database> {
    static FONTS: OnceLock<Arc<usvg::fontdb::Database>> = OnceLock::new();
    Arc::clone(FONTS.get_or_init(|| {
        let mut fonts = usvg::fontdb::Database::new();
        for font in [notosans::REGULAR_TTF, notosans::BOLD_TTF] {
            fonts.load_font_data(font.to_vec());
        }
        fonts.set_sans_serif_family("Noto Sans");
        Arc::new(fonts)
    }))
}
