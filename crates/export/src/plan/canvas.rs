//! A sheet of SVG in pixels with the world on it: x to the right, z up, some pixels to the metre.

use scenelang_layout::Vec2;
use std::fmt::Write;

/// Three components, 0 to 1.
pub(super) type Rgb = [f32; 3];

/// An SVG document as it grows.
pub(super) struct Canvas {
    out: String,
    /// Pixels to the metre.
    pub scale: f64,
    /// Where the world's origin is on the sheet.
    origin: [f64; 2],
}

/// A point of the sheet, pixels from its upper left corner.
pub(super) type Px = [f64; 2];

impl Canvas {
    /// A sheet of a size (pixels), with the world's point `corner` (least x, greatest z) at `at`.
    pub fn new(size: [f64; 2], scale: f64, corner: Vec2, at: Px) -> Self {
        let origin = [at[0] - corner.x * scale, at[1] + corner.y * scale];
        let [w, h] = size.map(|v| v.round());
        let mut out = String::new();
        let _ = writeln!(
            out,
            r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {w} {h}" width="{w}" height="{h}" font-family="'Noto Sans', system-ui, sans-serif" fill="#22262b">"##
        );
        let _ = writeln!(out, r##"<rect width="{w}" height="{h}" fill="#ffffff"/>"##);
        Self { out, scale, origin }
    }

    /// Where a point of the world is.
    pub fn px(&self, p: Vec2) -> Px {
        [self.origin[0] + p.x * self.scale, self.origin[1] - p.y * self.scale]
    }

    /// Adds markup as it is.
    pub fn raw(&mut self, markup: &str) {
        self.out.push_str(markup);
        self.out.push('\n');
    }

    /// A filled polygon of the world; `style` are further attributes.
    pub fn polygon(&mut self, points: &[Vec2], style: &str) {
        let mut list = String::new();
        for p in points {
            let [x, y] = self.px(*p);
            let _ = write!(list, "{}{},{}", if list.is_empty() { "" } else { " " }, short(x), short(y));
        }
        let _ = writeln!(self.out, r#"<polygon points="{list}" {style}/>"#);
    }

    /// A line between two points of the sheet.
    pub fn line(&mut self, a: Px, b: Px, style: &str) {
        let [x1, y1, x2, y2] = [a[0], a[1], b[0], b[1]].map(short);
        let _ = writeln!(self.out, r#"<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" {style}/>"#);
    }

    /// Text centred on a point of the sheet, turned by degrees.
    pub fn text(&mut self, at: Px, text: &str, size: f64, turn: f64, style: &str) {
        let [x, y] = at.map(short);
        let turned = if turn == 0.0 { String::new() } else { format!(r#" transform="rotate({turn} {x} {y})""#) };
        let _ = writeln!(
            self.out,
            r#"<text x="{x}" y="{y}" font-size="{}" text-anchor="middle" dominant-baseline="central"{turned} {style}>{}</text>"#,
            short(size),
            escape(text)
        );
    }

    /// The document.
    pub fn finish(mut self) -> String {
        self.out.push_str("</svg>\n");
        self.out
    }
}

/// A pixel coordinate: two decimals at most.
pub(super) fn short(v: f64) -> String {
    let text = format!("{v:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.to_owned() }
}

/// Text for XML; characters that XML forbids are left out.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\u{0}'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => {}
            c => out.push(c),
        }
    }
    out
}

/// `#rrggbb`
pub(super) fn hex(color: Rgb) -> String {
    let [r, g, b] = color.map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// A share of the way from one colour to another.
pub(super) fn mix(a: Rgb, b: Rgb, share: f32) -> Rgb {
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * share)
}

/// How wide a text is, pixels: near enough for Latin letters, and wide ones count double.
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    text.chars().map(|c| if (c as u32) < 0x1100 { 0.57 } else { 1.0 }).sum::<f64>() * size
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_text_is_safe() {
        for (v, want) in [(1.0, "1"), (-0.001, "0"), (12.345, "12.35"), (0.5, "0.5"), (100.0, "100")] {
            assert_eq!(short(v), want);
        }
        assert_eq!(escape("a<b>&\"\u{1}ü"), "a&lt;b&gt;&amp;&quot;ü");
        assert_eq!(hex(mix([0.0; 3], [1.0; 3], 0.5)), "#808080");
    }
}
