//! The plan as one SVG document: floors, walls in their real thickness, furniture, names, measures.

use super::canvas::{Canvas, Rgb, escape, hex, mix};
use super::labels::Labels;
use super::{dimensions, furniture};
use crate::Scene;
use crate::scene::shell::{Role, Shell};
use scenelang_layout::{Obb, Vec2};

/// Walls are cut at this height above the floor of their room, metres: through doors and windows.
const CUT: f64 = 1.2;
/// The drawing fits into this many pixels, unless that makes it too small to read.
const DRAWING: [f64; 2] = [1060.0, 760.0];

/// The document. Elements of an object carry `data-object`, those of a region `data-region`.
pub fn svg(scene: &Scene) -> String {
    let (lo, hi) = bounds(scene);
    let size = hi - lo;
    let scale = (DRAWING[0] / size.x).min(DRAWING[1] / size.y).clamp(28.0, 150.0);
    let [above, beside] = dimensions::rows(scene).map(|n| n as f64 * dimensions::ROW);
    let (left, top) = (30.0 + beside, 74.0 + above);
    let sheet = [left + size.x * scale + 30.0, top + size.y * scale + 62.0];
    let corner = Vec2::new(lo.x, hi.y);
    let mut canvas = Canvas::new(sheet, scale, corner, [left, top]);
    title(&mut canvas, scene);
    canvas.raw(r#"<g class="floors">"#);
    for shell in &scene.shells {
        floor(&mut canvas, scene, shell);
    }
    canvas.raw("</g>\n<g class=\"walls\">");
    for shell in &scene.shells {
        wall(&mut canvas, scene, shell);
    }
    canvas.raw("</g>\n<g class=\"objects\">");
    furniture::draw(&mut canvas, scene);
    canvas.raw("</g>\n<g class=\"swept\" pointer-events=\"none\">");
    furniture::sweeps(&mut canvas, scene);
    canvas.raw("</g>\n<g class=\"labels\" pointer-events=\"none\">");
    let mut labels = Labels::default();
    labels.regions(&mut canvas, scene);
    labels.objects(&mut canvas, scene);
    canvas.raw("</g>\n<g class=\"measures\">");
    dimensions::draw(&mut canvas, scene, corner);
    dimensions::legend(&mut canvas, left, left + size.x * scale, sheet[1] - 30.0);
    canvas.raw("</g>");
    canvas.finish()
}

/// Least and greatest x, z of all there is.
fn bounds(scene: &Scene) -> (Vec2, Vec2) {
    let mut points: Vec<Vec2> = scene.shells.iter().flat_map(|s| &s.pieces).flat_map(|p| &p.polygon).copied().collect();
    points.extend(scene.objects.iter().flat_map(|o| Obb::from_placement(&o.place).footprint()));
    let first = points.first().copied().unwrap_or_default();
    let (lo, hi) = points.iter().fold((first, first), |(lo, hi), p| (lo.inf(p), hi.sup(p)));
    // An empty scene still is a drawing.
    (lo, hi.sup(&(lo + Vec2::new(0.5, 0.5))))
}

fn title(canvas: &mut Canvas, scene: &Scene) {
    let judged = scene.rows.iter().filter(|r| r.kind != "prefer" && r.satisfied.is_some());
    let (held, all) = judged.fold((0, 0), |(h, n), r| (h + usize::from(r.satisfied == Some(true)), n + 1));
    let objects = scene.objects.len();
    let verdict = match scene.report["ok"].as_bool() {
        Some(true) => format!("{objects} objects, all constraints hold"),
        _ => format!("{objects} objects, {held} of {all} listed constraints hold"),
    };
    let name = escape(&scene.name.replace('_', " "));
    canvas.raw(&format!(r#"<text x="30" y="34" font-size="20" font-weight="700">{name}</text>"#));
    canvas.raw(&format!(r##"<text x="30" y="53" font-size="12" fill="#6a717b">{}</text>"##, escape(&verdict)));
}

fn floor(canvas: &mut Canvas, scene: &Scene, shell: &Shell) {
    let pale = |share: f32| hex(mix(surface(scene, shell), [1.0; 3], share));
    let style = match shell.role {
        Role::Floor => format!(r#"fill="{}""#, pale(0.62)),
        Role::Tint => format!(r##"fill="{}" stroke="#8c939c" stroke-width="1" stroke-dasharray="6 4""##, pale(0.55)),
        Role::Ceiling | Role::Wall { .. } | Role::Skirting { .. } => return,
    };
    let region = shell.region.as_deref().map_or(String::new(), |r| format!(r#" data-region="{}""#, escape(r)));
    for piece in &shell.pieces {
        canvas.polygon(&piece.polygon, &format!("{style}{region}"));
    }
}

/// What stands at the height of the cut is dark; what is lower (below a window) only outlined.
fn wall(canvas: &mut Canvas, scene: &Scene, shell: &Shell) {
    let Role::Wall { .. } = shell.role else { return };
    let floor = scene.regions.iter().find(|r| shell.region.as_deref() == Some(&r.name)).map_or(0.0, |r| r.prism.floor);
    for piece in shell.pieces.iter().filter(|p| p.low < floor + CUT) {
        let cut = piece.high > floor + CUT;
        // A stroke in the same colour keeps a thin wall visible at any scale.
        let across = (piece.polygon[2] - piece.polygon[1]).norm();
        let thin = (2.2 - across * canvas.scale).max(0.4);
        let style = if cut {
            format!(r##"fill="#2f343b" stroke="#2f343b" stroke-width="{thin:.2}" stroke-linejoin="miter""##)
        } else {
            r##"fill="#f3f4f6" stroke="#2f343b" stroke-width="0.7""##.to_owned()
        };
        canvas.polygon(&piece.polygon, &style);
    }
}

fn surface(scene: &Scene, shell: &Shell) -> Rgb {
    scene.surfaces[shell.group.surface].color
}
