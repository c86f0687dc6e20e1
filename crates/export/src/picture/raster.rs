//! Triangles to pixels: a depth buffer with the normal of what is nearest, and which triangle that is.

use super::bands::bands;
use super::stage::Triangle;
use std::ops::Range;

/// A point in front of the camera: right, up, forward.
type Eye = [f32; 3];

/// How the camera turns the world: rows are right, up, forward; then pixels for a slope.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lens {
    /// Where the eye is.
    pub eye: [f32; 3],
    /// Right, up, forward.
    pub axes: [[f32; 3]; 3],
    /// Pixels for a slope of 1; 0: parallel light, then `zoom` pixels to the metre.
    pub focal: f32,
    /// Pixels to the metre where the projection is parallel.
    pub zoom: f32,
    /// Width and height, pixels.
    pub size: [usize; 2],
}

impl Lens {
    /// A point in the camera's frame.
    pub fn seen(&self, p: [f32; 3]) -> Eye {
        let d = sub(p, self.eye);
        self.axes.map(|a| dot(a, d))
    }

    /// Pixel coordinates of a point in the camera's frame.
    pub fn pixel(&self, [x, y, z]: Eye) -> [f32; 2] {
        let k = if self.focal > 0.0 { self.focal / z } else { self.zoom };
        [self.size[0] as f32 / 2.0 + x * k, self.size[1] as f32 / 2.0 - y * k]
    }

    /// The point of the world at a pixel and a depth.
    pub fn world(&self, [px, py]: [f32; 2], z: f32) -> [f32; 3] {
        let k = if self.focal > 0.0 { z / self.focal } else { 1.0 / self.zoom };
        let x = (px - self.size[0] as f32 / 2.0) * k;
        let y = (self.size[1] as f32 / 2.0 - py) * k;
        let [r, u, f] = self.axes;
        std::array::from_fn(|i| self.eye[i] + r[i] * x + u[i] * y + f[i] * z)
    }
}

/// What is hit at a pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hit {
    /// The pixel, as index.
    pub at: usize,
    /// Depth along the view, metres.
    pub depth: f32,
    /// Weights of the triangle's corners.
    pub weights: [f32; 3],
}

/// Calls `hit` for each pixel of some rows whose centre a triangle covers and that it faces.
pub(super) fn cover(lens: &Lens, rows: &Range<usize>, triangle: &Triangle, mut hit: impl FnMut(Hit)) {
    let eye = triangle.points.map(|p| lens.seen(p));
    // The camera stands outside; what reaches behind it would cover everything.
    if eye.iter().any(|p| lens.focal > 0.0 && p[2] < 0.05) {
        return;
    }
    let [a, b, c] = eye.map(|p| lens.pixel(p));
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    // Triangles run clockwise seen from outside; on the sheet, with y down, that is a positive area.
    if area <= 1e-6 {
        return;
    }
    let span = |k: usize| {
        let lo = a[k].min(b[k]).min(c[k]).max(0.0).ceil_half();
        let hi = a[k].max(b[k]).max(c[k]).min(lens.size[k] as f32).ceil_half();
        lo..hi.min(lens.size[k])
    };
    // Perspective keeps 1/z, not z, linear on the sheet.
    let inverse = if lens.focal > 0.0 { eye.map(|p| 1.0 / p[2]) } else { [1.0; 3] };
    let (across, down) = (span(0), span(1));
    // Where an edge crosses the middle of a row: what lies more than a pixel beyond it is not looked at.
    let crossing = |s: [f32; 2], t: [f32; 2], y: f32| s[0] + (t[0] - s[0]) * (y - s[1]) / (t[1] - s[1]);
    for y in down.start.max(rows.start)..down.end.min(rows.end) {
        let (mut from, mut to) = (across.start, across.end);
        for (s, t) in [(a, b), (b, c), (c, a)] {
            let at = crossing(s, t, y as f32 + 0.5);
            // With y down and corners clockwise, the inside is to the right of an edge that rises.
            if t[1] < s[1] {
                from = from.max((at - 1.5).max(0.0) as usize);
            } else if t[1] > s[1] {
                to = to.min((at + 2.5).max(0.0) as usize);
            }
        }
        for x in from..to {
            let p = [x as f32 + 0.5, y as f32 + 0.5];
            let edge = |s: [f32; 2], t: [f32; 2]| (t[0] - s[0]) * (p[1] - s[1]) - (t[1] - s[1]) * (p[0] - s[0]);
            let flat = [edge(b, c), edge(c, a), edge(a, b)];
            if flat.iter().any(|&w| w < 0.0) {
                continue;
            }
            let w: [f32; 3] = std::array::from_fn(|i| flat[i] / area * inverse[i]);
            let sum = w[0] + w[1] + w[2];
            let weights = w.map(|v| v / sum);
            let depth = weights[0] * eye[0][2] + weights[1] * eye[1][2] + weights[2] * eye[2][2];
            hit(Hit { at: y * lens.size[0] + x, depth, weights });
        }
    }
}

/// The first pixel whose centre is not before a coordinate.
trait CeilHalf {
    fn ceil_half(self) -> usize;
}
impl CeilHalf for f32 {
    fn ceil_half(self) -> usize {
        (self - 0.5).ceil().max(0.0) as usize
    }
}

/// No surface at a pixel.
pub(super) const NOTHING: u32 = u32::MAX;

/// What is seen at each pixel.
pub(super) struct Buffer {
    pub depth: Vec<f32>,
    pub normal: Vec<[f32; 3]>,
    /// Index of the triangle.
    pub shown: Vec<u32>,
}

/// Draws opaque triangles.
pub(super) fn draw(lens: &Lens, triangles: &[&Triangle], threads: usize) -> Buffer {
    let [width, height] = lens.size;
    let drawn = bands(height, threads, |rows| {
        let pixels = rows.len() * width;
        let mut out =
            Buffer { depth: vec![f32::INFINITY; pixels], normal: vec![[0.0; 3]; pixels], shown: vec![NOTHING; pixels] };
        for (index, triangle) in triangles.iter().enumerate() {
            cover(lens, &rows, triangle, |hit| {
                let at = hit.at - rows.start * width;
                if hit.depth < out.depth[at] {
                    out.depth[at] = hit.depth;
                    out.normal[at] = blend(triangle.normals, hit.weights);
                    out.shown[at] = index as u32;
                }
            });
        }
        out
    });
    let mut out = Buffer { depth: Vec::new(), normal: Vec::new(), shown: Vec::new() };
    for band in drawn {
        out.depth.extend(band.depth);
        out.normal.extend(band.normal);
        out.shown.extend(band.shown);
    }
    out
}

/// Depths only, as the light sees it.
pub(super) fn depths(lens: &Lens, triangles: &[&Triangle], threads: usize) -> Vec<f32> {
    let [width, height] = lens.size;
    let drawn = bands(height, threads, |rows| {
        let mut out = vec![f32::INFINITY; rows.len() * width];
        for triangle in triangles {
            cover(lens, &rows, triangle, |hit| {
                let at = hit.at - rows.start * width;
                out[at] = out[at].min(hit.depth);
            });
        }
        out
    });
    drawn.concat()
}

/// The normal between corners.
pub(super) fn blend(normals: [[f32; 3]; 3], weights: [f32; 3]) -> [f32; 3] {
    unit(std::array::from_fn(|i| (0..3).map(|k| normals[k][i] * weights[k]).sum()))
}

pub(super) fn sub(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    std::array::from_fn(|i| a[i] - b[i])
}
pub(super) fn cross(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
pub(super) fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
pub(super) fn unit(a: [f32; 3]) -> [f32; 3] {
    let l = dot(a, a).sqrt().max(1e-12);
    a.map(|v| v / l)
}
