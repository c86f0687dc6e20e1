//! What the boxes are that stand for things which no furniture is drawn for: their names, as on a plan.

use super::light::camera;
use crate::plan::{escape, text_width};
use crate::{ExportError, Scene, drawing, scene::View};
use resvg::tiny_skia::PremultipliedColorU8;
use scenelang_layout::Vec3;
use std::fmt::Write as _;

/// The family of the library that is a plain box.
const UNKNOWN: &str = "unknown";
/// Height of the letters of a picture that is `WIDE` pixels wide, and in any picture at least.
const LETTERS: f64 = 13.0;
const WIDE: f64 = 1280.0;
const SMALLEST: f64 = 9.0;

/// Writes the names over a picture of red, green and blue.
pub(super) fn write(pixels: &mut [u8], scene: &Scene, view: &View, size: [usize; 2]) -> Result<(), ExportError> {
    let Some(svg) = svg(scene, view, size) else { return Ok(()) };
    let over = drawing::pixels(&svg, 1.0, "picture")?;
    for (below, above) in pixels.chunks_exact_mut(3).zip(over.pixels()) {
        let channels = [PremultipliedColorU8::red, PremultipliedColorU8::green, PremultipliedColorU8::blue];
        for (value, channel) in below.iter_mut().zip(channels) {
            let rest = u16::from(*value) * u16::from(255 - above.alpha()) / 255;
            *value = channel(*above).saturating_add(rest as u8);
        }
    }
    Ok(())
}

/// The names as a drawing of the size of the picture; none where there is nothing to name.
fn svg(scene: &Scene, view: &View, size: [usize; 2]) -> Option<String> {
    let lens = camera(view, size);
    let [width, height] = size.map(|s| s as f64);
    let letters = (LETTERS * width / WIDE).max(SMALLEST);
    let mut out = String::new();
    for object in scene.objects.iter().filter(|o| o.family == UNKNOWN) {
        let top = object.at(Vec3::new(0.0, object.place.scale.y, 0.0));
        let seen = lens.seen([top.x as f32, top.y as f32, top.z as f32]);
        let [x, y] = lens.pixel(seen).map(f64::from);
        if seen[2] <= 0.0 || !(0.0..width).contains(&x) || !(0.0..height).contains(&y) {
            continue;
        }
        let wide = text_width(&object.label, letters) + letters;
        let (left, base) = (x - wide / 2.0, y + 0.35 * letters);
        let _ = write!(
            out,
            r##"<rect x="{left:.1}" y="{:.1}" width="{wide:.1}" height="{:.1}" rx="3" fill="#ffffff" fill-opacity="0.82"/>"##,
            y - 0.75 * letters,
            1.5 * letters,
        );
        let _ = write!(
            out,
            r##"<text x="{x:.1}" y="{base:.1}" font-size="{letters:.1}" text-anchor="middle" fill="#2f343b">{}</text>"##,
            escape(&object.label),
        );
    }
    let start = format!(r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}">"#);
    (!out.is_empty()).then(|| format!("{start}{out}</svg>"))
}
