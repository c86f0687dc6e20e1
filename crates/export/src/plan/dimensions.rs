//! Measures around the plan: width and depth of every room, a scale bar, and which way x and z go.

use super::canvas::{Canvas, Px};
use crate::Scene;
use crate::scene::RegionKind;
use scenelang_layout::Vec2;

const LINE: &str = r##"stroke="#7a818b" stroke-width="0.9""##;
/// Pixels between two rows of dimension lines.
pub(super) const ROW: f64 = 20.0;

/// A span along one axis, metres, and the row it is drawn in.
struct Span {
    lo: f64,
    hi: f64,
    row: usize,
}

/// Spans of all rooms along an axis (0: x, 1: z), each once, in as few rows as keep them apart.
fn spans(scene: &Scene, axis: usize) -> Vec<Span> {
    let mut all: Vec<(f64, f64)> = scene
        .regions
        .iter()
        .filter(|r| r.kind != RegionKind::Zone)
        .map(|r| {
            let along = r.prism.polygon.corners().iter().map(|c| c[axis]);
            along.fold((f64::MAX, f64::MIN), |(lo, hi), v| (lo.min(v), hi.max(v)))
        })
        .collect();
    all.sort_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)).then(a.0.total_cmp(&b.0)));
    all.dedup_by(|a, b| (a.0 - b.0).abs() < 0.005 && (a.1 - b.1).abs() < 0.005);
    let mut out: Vec<Span> = Vec::new();
    for (lo, hi) in all {
        let clash = |row: usize| out.iter().any(|s| s.row == row && s.lo < hi - 1e-6 && lo < s.hi - 1e-6);
        let row = (0..).find(|&row| !clash(row)).unwrap_or(0);
        out.push(Span { lo, hi, row });
    }
    out
}

/// How many rows of lines there are above (x) and on the left (z).
pub(super) fn rows(scene: &Scene) -> [usize; 2] {
    [0, 1].map(|axis| spans(scene, axis).iter().map(|s| s.row + 1).max().unwrap_or(0))
}

/// Dimension lines above and on the left of the drawing, whose world corner (least x, greatest z) is `corner`.
pub(super) fn draw(canvas: &mut Canvas, scene: &Scene, corner: Vec2) {
    let [left, top] = canvas.px(corner);
    for span in spans(scene, 0) {
        let y = top - 16.0 - ROW * span.row as f64;
        let [a, b] = [span.lo, span.hi].map(|x| [canvas.px(Vec2::new(x, 0.0))[0], y]);
        measure(canvas, a, b, span.hi - span.lo);
    }
    for span in spans(scene, 1) {
        let x = left - 16.0 - ROW * span.row as f64;
        let [a, b] = [span.lo, span.hi].map(|z| [x, canvas.px(Vec2::new(0.0, z))[1]]);
        measure(canvas, a, b, span.hi - span.lo);
    }
}

/// A line with a slash at each end and its length in the middle.
fn measure(canvas: &mut Canvas, a: Px, b: Px, metres: f64) {
    canvas.line(a, b, LINE);
    for [x, y] in [a, b] {
        canvas.line([x - 3.5, y + 3.5], [x + 3.5, y - 3.5], r##"stroke="#4a4f57" stroke-width="1.2""##);
    }
    let text = format!("{metres:.2} m");
    let turn = if (a[0] - b[0]).abs() < 0.01 { -90.0 } else { 0.0 };
    let middle = [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0];
    let style = r##"fill="#4a4f57" stroke="#ffffff" stroke-width="6" paint-order="stroke""##;
    canvas.text(middle, &text, 11.0, turn, style);
}

/// The scale bar at the lower left, the axes at the lower right; `y` is the height of both on the sheet.
pub(super) fn legend(canvas: &mut Canvas, left: f64, right: f64, y: f64) {
    let step = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0].into_iter().find(|s| s * canvas.scale >= 46.0).unwrap_or(50.0);
    let px = step * canvas.scale;
    for i in 0..2 {
        let fill = ["#3a3f46", "#ffffff"][i];
        let x = left + px * i as f64;
        canvas.raw(&format!(
            r##"<rect x="{:.2}" y="{:.2}" width="{px:.2}" height="5" fill="{fill}" stroke="#3a3f46" stroke-width="0.8"/>"##,
            x, y - 2.5
        ));
    }
    for i in 0..3 {
        let text = if i == 2 { format!("{} m", step * 2.0) } else { format!("{}", step * f64::from(i)) };
        canvas.text([left + px * f64::from(i), y + 12.0], &text, 10.0, 0.0, r##"fill="#4a4f57""##);
    }
    let arrow = r##"stroke="#7a818b" stroke-width="1.2" stroke-linecap="round""##;
    let o = [right - 44.0, y + 8.0];
    canvas.line(o, [o[0] + 28.0, o[1]], arrow);
    canvas.line(o, [o[0], o[1] - 28.0], arrow);
    for (tip, a, b) in [([28.0, 0.0], [-5.0, -3.0], [-5.0, 3.0]), ([0.0, -28.0], [-3.0, 5.0], [3.0, 5.0])] {
        for side in [a, b] {
            let tip = [o[0] + tip[0], o[1] + tip[1]];
            canvas.line(tip, [tip[0] + side[0], tip[1] + side[1]], arrow);
        }
    }
    canvas.text([o[0] + 37.0, o[1]], "x", 11.0, 0.0, r##"fill="#4a4f57""##);
    canvas.text([o[0], o[1] - 37.0], "z", 11.0, 0.0, r##"fill="#4a4f57""##);
}
