//! Things stand out against the floor they stand on.

use crate::looks::{Finish, Rgb, shade, surface, tinted_by};
use crate::mesh::{Mesh, MeshGroup, wide};

/// The least difference between a thing and its floor, see [`difference`].
const LEAST: f64 = 12.0;
/// Groups no farther from the main colour than this change with it.
const ALIKE: f64 = 30.0;
/// How a colour may change: darker below 1, towards white above; the least change first.
const STEPS: [f32; 10] = [0.85, 1.2, 0.75, 1.4, 0.65, 1.7, 0.55, 2.2, 0.45, 3.0];

/// Shades what most of a mesh looks like until most of it stands out against a floor of this colour. Glass, mirrors, lamps
/// and plants stay as they are, and what is white, such as a bathtub, stays white.
pub fn stand_out(mesh: &mut Mesh, floor: [f32; 3]) {
    for _ in 0..mesh.groups.len() {
        let Some(lost) = lost(mesh, floor) else { return };
        let (color, finish) = (lost.surface.color, finish(lost).to_owned());
        let is_wood = finish == "wood";
        let enough = |by: &&f32| difference(changed(color, **by, is_wood), floor) >= LEAST;
        let Some(by) = STEPS.iter().find(enough) else { return };
        for group in &mut mesh.groups {
            if self::finish(group) == finish && difference(group.surface.color, color) < ALIKE {
                group.surface = match is_wood {
                    true => surface(Finish::Wood, changed(group.surface.color, *by, true)),
                    false => shade(&group.surface, *by),
                };
            }
        }
    }
}

/// A colour, darker or lighter. Wood that is stained darker is warmer, too, not grey.
fn changed(color: Rgb, by: f32, is_wood: bool) -> Rgb {
    if !is_wood || by > 1.0 {
        return tinted_by(color, by);
    }
    let [r, g, b] = color;
    [r * by.powf(0.6), g * by, b * by.powf(1.5)]
}

/// The largest group that does not stand out, if such groups are more than half of all that have a colour of their own.
fn lost(mesh: &Mesh, floor: [f32; 3]) -> Option<&MeshGroup> {
    let own = |g: &&MeshGroup| !["glass", "mirror", "leaf", "water", "screen", "glow", "soil"].contains(&finish(g));
    let areas: Vec<(&MeshGroup, f64)> = mesh.groups.iter().filter(own).map(|g| (g, area(g))).collect();
    let (near, far): (Vec<_>, Vec<_>) =
        areas.into_iter().partition(|(g, _)| !is_white(g.surface.color) && difference(g.surface.color, floor) < LEAST);
    let sum = |of: &[(&MeshGroup, f64)]| of.iter().map(|(_, area)| area).sum::<f64>();
    let most = near.iter().max_by(|a, b| a.1.total_cmp(&b.1)).map(|(g, _)| *g);
    most.filter(|_| sum(&near) > 0.8 * sum(&far))
}

fn is_white(color: Rgb) -> bool {
    let [lightness, a, b] = lab(color);
    lightness > 92.0 && a.hypot(b) < 6.0
}

fn finish(group: &MeshGroup) -> &str {
    group.surface.name.split('-').next().unwrap_or_default()
}

fn area(group: &MeshGroup) -> f64 {
    let corners = group.indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]].map(|i| wide(group.positions[i as usize])));
    corners.map(|[a, b, c]| (b - a).cross(&(c - a)).norm()).sum()
}

/// How different two colours (sRGB) are to the eye: their distance in CIE L*a*b*. 2 is just noticed, 100 is black and white.
pub fn difference(one: [f32; 3], other: [f32; 3]) -> f64 {
    let (p, q) = (lab(one), lab(other));
    (0..3).map(|i| (p[i] - q[i]).powi(2)).sum::<f64>().sqrt()
}

fn lab(color: Rgb) -> [f64; 3] {
    let linear = |c: f32| {
        let c = f64::from(c);
        if c <= 0.040_45 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
    };
    let [r, g, b] = color.map(linear);
    // In relation to the white of daylight.
    let xyz = [
        (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505,
        0.2126 * r + 0.7152 * g + 0.0722 * b,
        (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089,
    ];
    let [x, y, z] = xyz.map(|t| if t > 0.008_856 { t.cbrt() } else { 7.787 * t + 16.0 / 116.0 });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}
