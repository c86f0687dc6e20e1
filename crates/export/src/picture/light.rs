//! Light: a sun with soft shadows, a sky, and the dimness of corners; then the pixels.

use super::bands::bands;
use super::raster::{Buffer, Lens, NOTHING, blend, cover, depths, dot, draw, sub, unit};
use super::sources::Source;
use super::stage::{Stage, Triangle, TriangleLook};
use crate::scene::View;
use nalgebra::Matrix3;
use scenelang_layout::Vec3;
use std::array::from_fn;
use std::ops::Range;

/// Samples per pixel along each axis.
const FINE: usize = 2;
/// Side of the shadow map, pixels.
const SHADOW: usize = 2048;
/// Radius of a shadow's soft edge, pixels of the map and steps.
const SOFT: i32 = 2;
/// How far corners darken, metres.
const REACH: f32 = 0.4;

const SUN: [f32; 3] = [0.74, 0.70, 0.63];
const SKY: [f32; 3] = [0.44, 0.46, 0.49];
const GROUND: [f32; 3] = [0.32, 0.31, 0.29];
/// From the other side, without shadows, so that what the sun does not reach keeps its form.
const FILL: [f32; 3] = [0.15, 0.16, 0.18];
/// Background at the top and at the bottom, linear.
const BACKDROP: [[f32; 3]; 2] = [[0.80, 0.84, 0.88], [0.93, 0.94, 0.94]];

/// Renders to RGB bytes, row by row. They are the same whatever the number of threads.
pub(super) fn render(stage: &Stage, view: &View, size: [usize; 2], threads: usize) -> Vec<u8> {
    let lens = camera(view, size.map(|s| s * FINE));
    let is_opaque = |t: &&Triangle| stage.looks[t.look as usize].opacity >= 1.0;
    // An eye in a room has walls and floors that reach behind it.
    let triangles = stage.before(lens.eye, lens.axes[2]);
    let (opaque, clear): (Vec<&Triangle>, Vec<&Triangle>) = triangles.iter().partition(is_opaque);
    let buffer = draw(&lens, &opaque, threads);
    let corners = Occlusion::of(&buffer, &lens, threads);
    let sun = Sun::new(stage, view, threads);
    let clear = far_first(clear, &lens);
    let width = lens.size[0];
    let seen = Seen { stage, lens: &lens, opaque: &opaque, buffer: &buffer, corners: &corners, sun: &sun };
    let developed = bands(size[1], threads, |rows| {
        let fine = rows.start * FINE..rows.end * FINE;
        let mut light = vec![[0.0; 3]; fine.len() * width];
        for y in rows.clone() {
            for x in 0..size[0] {
                for (at, sample) in seen.pixel(x, y) {
                    light[at - fine.start * width] = sample;
                }
            }
        }
        for triangle in &clear {
            glaze(stage, &lens, &buffer, &sun, triangle, &fine, &mut light);
        }
        develop(&light, width, [size[0], rows.len()])
    });
    developed.concat()
}

/// What is opaque as the eye sees it, and all that its light depends on.
struct Seen<'a> {
    stage: &'a Stage,
    lens: &'a Lens,
    opaque: &'a [&'a Triangle],
    buffer: &'a Buffer,
    corners: &'a Occlusion,
    sun: &'a Sun,
}

impl Seen<'_> {
    /// The light of the samples of a pixel. Where all of them show the same triangle, it is that of their middle.
    fn pixel(&self, x: usize, y: usize) -> [(usize, [f32; 3]); FINE * FINE] {
        let Self { lens, buffer, .. } = self;
        let places: [[usize; 2]; FINE * FINE] = from_fn(|k| [x * FINE + k % FINE, y * FINE + k / FINE]);
        let at = places.map(|[x, y]| y * lens.size[0] + x);
        let open = self.corners.at(x * FINE, y * FINE);
        if at.iter().all(|i| buffer.shown[*i] == buffer.shown[at[0]]) {
            let share = 1.0 / at.len() as f32;
            let depth = at.iter().map(|i| buffer.depth[*i]).sum::<f32>() * share;
            let normal = unit(from_fn(|k| at.iter().map(|i| buffer.normal[*i][k]).sum::<f32>()));
            let middle = [x, y].map(|v| (v * FINE) as f32 + FINE as f32 / 2.0);
            let light = self.light(middle, depth, normal, buffer.shown[at[0]], (open, FINE as f32));
            return at.map(|i| (i, light));
        }
        from_fn(|k| {
            let (i, middle) = (at[k], places[k].map(|v| v as f32 + 0.5));
            (i, self.light(middle, buffer.depth[i], buffer.normal[i], buffer.shown[i], (open, 1.0)))
        })
    }

    /// The light of a place on the sheet, so many samples wide, that shows a triangle or nothing.
    fn light(&self, middle: [f32; 2], depth: f32, normal: [f32; 3], shown: u32, (open, wide): (f32, f32)) -> [f32; 3] {
        let Some(triangle) = self.opaque.get(shown as usize) else { return backdrop(self.stage, self.lens, middle) };
        let spot = Spot::at(self.lens, middle, depth, normal, wide);
        shade(
            &Matter::of(self.stage, triangle, &spot, self.lens),
            &spot,
            self.lens.eye,
            (self.sun, &self.stage.sources),
            open,
        )
    }
}

/// A pale sheet that darkens where the building stands on it.
fn backdrop(stage: &Stage, lens: &Lens, at: [f32; 2]) -> [f32; 3] {
    let t = at[1] / lens.size[1] as f32;
    let sheet: [f32; 3] = from_fn(|i| BACKDROP[0][i] + (BACKDROP[1][i] - BACKDROP[0][i]) * t);
    let way = sub(lens.world(at, 1.0), lens.eye);
    if way[1] >= -1e-3 {
        return sheet;
    }
    let far = (stage.ground - lens.eye[1]) / way[1];
    let away = stage.distance_to_footprint([lens.eye[0] + way[0] * far, lens.eye[2] + way[2] * far]);
    // Farther away it is not seen.
    if away > 6.0 {
        return sheet;
    }
    let dim = 1.0 - 0.2 * (-away / 0.16).exp() - 0.1 * (-away / 0.8).exp();
    sheet.map(|v| v * dim)
}

pub(super) fn camera(view: &View, size: [usize; 2]) -> Lens {
    let half = (view.fov / 2.0).to_radians().tan();
    Lens {
        eye: narrow(view.eye),
        axes: rows(&view.axes()),
        focal: (size[1] as f64 / 2.0 / half) as f32,
        zoom: 0.0,
        size,
    }
}

fn rows(axes: &Matrix3<f64>) -> [[f32; 3]; 3] {
    from_fn(|k| narrow(axes.column(k).into()))
}

fn narrow(v: Vec3) -> [f32; 3] {
    [v.x as f32, v.y as f32, v.z as f32]
}

/// Parallel light from over the viewer's left shoulder, and what it reaches.
struct Sun {
    lens: Lens,
    /// Towards the sun.
    way: [f32; 3],
    /// Towards the weaker light on the other side.
    fill: [f32; 3],
    depths: Vec<f32>,
}

impl Sun {
    fn new(stage: &Stage, view: &View, threads: usize) -> Self {
        let axes = view.axes();
        let level = |v: Vec3| Vec3::new(v.x, 0.0, v.z).try_normalize(1e-9);
        let right = level(axes.column(0).into()).unwrap_or(Vec3::x());
        // Seen from straight above, what is up in the picture is ahead.
        let ahead = level(axes.column(2).into()).or_else(|| level(axes.column(1).into())).unwrap_or(Vec3::z());
        let way = (Vec3::y() * 1.2 - right * 0.55 - ahead * 0.6).normalize();
        let fill = (Vec3::y() * 0.3 + right - ahead * 0.7).normalize();
        let sight = View { eye: way, target: Vec3::zeros(), fov: 0.0 }.axes();
        let mut lens = Lens { eye: [0.0; 3], axes: rows(&sight), focal: 0.0, zoom: 1.0, size: [SHADOW, SHADOW] };
        // The map is centred on what throws shadows and just large enough for it.
        let casters: Vec<&Triangle> = stage.triangles.iter().filter(|t| t.shadow).collect();
        let (mut lo, mut hi) = ([f32::MAX; 3], [f32::MIN; 3]);
        for p in casters.iter().flat_map(|t| t.points).map(|p| lens.seen(p)) {
            lo = from_fn(|i| lo[i].min(p[i]));
            hi = from_fn(|i| hi[i].max(p[i]));
        }
        if lo[0] <= hi[0] {
            let middle: [f32; 3] = from_fn(|i| (lo[i] + hi[i]) / 2.0);
            let [r, u, f] = lens.axes;
            lens.eye = from_fn(|i| r[i] * middle[0] + u[i] * middle[1] + f[i] * middle[2]);
            lens.zoom = (SHADOW as f32 - 16.0) / (hi[0] - lo[0]).max(hi[1] - lo[1]).max(0.1);
        }
        let depths = depths(&lens, &casters, threads);
        Self { lens, way: narrow(way), fill: narrow(fill), depths }
    }

    /// The share of the sun that is seen from a place, 0 to 1.
    fn seen_from(&self, place: [f32; 3], normal: [f32; 3]) -> f32 {
        // A little off the surface, more so where it is grazed, lest it shade itself.
        let slant = 1.0 - dot(normal, self.way).clamp(0.0, 1.0);
        // In a large room a pixel of the map is large too: the edge reaches over four of them, five across a corner.
        let steep = (1.0 - (1.0 - slant) * (1.0 - slant)).sqrt();
        let off = (0.006 + 0.02 * slant).max(5.0 * steep / self.lens.zoom);
        let eye = self.lens.seen(from_fn(|i| place[i] + normal[i] * off));
        let [x, y] = self.lens.pixel(eye);
        let open = |dx: i32, dy: i32| {
            let (u, v) = (x + dx as f32 * 2.0, y + dy as f32 * 2.0);
            let inside = u >= 0.0 && v >= 0.0 && u < SHADOW as f32 && v < SHADOW as f32;
            !(inside && self.depths[v as usize * SHADOW + u as usize] < eye[2] - 0.004)
        };
        // Nearly all places are in full light or in full shadow, as the middle and the rim of the edge tell.
        let rim = (0..3).flat_map(|i| (0..3).map(move |k| ((i - 1) * SOFT, (k - 1) * SOFT)));
        match rim.filter(|(dx, dy)| open(*dx, *dy)).count() {
            0 => 0.0,
            9 => 1.0,
            _ => {
                let all = || (-SOFT..=SOFT).flat_map(|dy| (-SOFT..=SOFT).map(move |dx| (dx, dy)));
                all().filter(|(dx, dy)| open(*dx, *dy)).count() as f32 / all().count() as f32
            }
        }
    }
}

/// A place that is seen.
struct Spot {
    place: [f32; 3],
    normal: [f32; 3],
    /// How large it is, metres.
    size: f32,
}

impl Spot {
    /// What is so many samples wide at a place on the sheet.
    fn at(lens: &Lens, middle: [f32; 2], depth: f32, normal: [f32; 3], wide: f32) -> Self {
        Self { place: lens.world(middle, depth), normal, size: wide * depth / lens.focal }
    }
}

/// What is there, its texture looked up.
struct Matter {
    color: [f32; 3],
    glow: [f32; 3],
    roughness: f32,
    metallic: f32,
    normal: [f32; 3],
}

impl Matter {
    fn of(stage: &Stage, triangle: &Triangle, spot: &Spot, lens: &Lens) -> Self {
        let &TriangleLook { color, glow, roughness, metallic, cloth, .. } = &stage.looks[usize::from(triangle.look)];
        let plain = Self { color, glow, roughness, metallic, normal: spot.normal };
        let Some(cloth) = cloth else { return plain };
        let at = triangle.weave.map(|[x, y, z, shift]| dot([x, y, z], spot.place) + shift);
        // What is seen at a slant is seen from farther away in one direction.
        let slant = dot(spot.normal, unit(sub(lens.eye, spot.place))).abs().max(0.1);
        let sample = cloth.sample(at, spot.size / slant.sqrt());
        let along = triangle.weave.map(|[x, y, z, _]| unit([x, y, z]));
        let bent = from_fn(|i| spot.normal[i] + along[0][i] * sample.lean[0] + along[1][i] * sample.lean[1]);
        Self {
            color: from_fn(|i| color[i] * sample.color[i]),
            roughness: roughness * sample.rough,
            normal: unit(bent),
            ..plain
        }
    }
}

/// What leaves a surface towards the eye.
fn shade(matter: &Matter, spot: &Spot, eye: [f32; 3], (sun, sources): (&Sun, &[Source]), open: f32) -> [f32; 3] {
    let normal = matter.normal;
    let facing = dot(normal, sun.way).max(0.0);
    let direct = if facing > 0.0 { facing * sun.seen_from(spot.place, spot.normal) } else { 0.0 };
    let filled = dot(normal, sun.fill).max(0.0);
    let mut near = [0.0; 3];
    for source in sources {
        let light = source.at(spot.place, normal);
        near = from_fn(|i| near[i] + light[i]);
    }
    let up = normal[1] * 0.5 + 0.5;
    let way = unit(sub(eye, spot.place));
    let half = unit(from_fn(|i| way[i] + sun.way[i]));
    let smooth = (1.0 - matter.roughness).powi(2) * 0.9 * direct;
    // What is dull has no lights to speak of.
    let gloss = if smooth > 0.003 {
        smooth * dot(normal, half).max(0.0).powf(4.0 + 120.0 * (1.0 - matter.roughness).powi(3))
    } else {
        0.0
    };
    // Smooth things mirror the sky towards their rim.
    let rim = (1.0 - dot(normal, way).max(0.0)).powi(4) * (1.0 - matter.roughness) * 0.35 * open;
    from_fn(|i| {
        let sky = (GROUND[i] + (SKY[i] - GROUND[i]) * up + FILL[i] * filled) * open;
        let color = matter.color[i];
        let tint = 1.0 + (color - 1.0) * matter.metallic;
        color * (sky + SUN[i] * direct + near[i] * open)
            + gloss * SUN[i] * tint
            + rim * SKY[i] * tint
            + matter.glow[i] * 0.7
    })
}

/// Points about a place at which it is looked whether something hides the sky.
const SAMPLES: usize = 14;
/// The points of a pixel are turned against those of its neighbours, over so many pixels in each direction.
const TURNS: usize = 4;

/// A unit vector over the ground, and how far away along it (metres).
#[derive(Clone, Copy)]
struct Probe {
    way: [f32; 3],
    far: f32,
}

/// Points on a spiral over the hemisphere, nearer ones more often; by pixel.
fn ways() -> [[Probe; SAMPLES]; TURNS * TURNS] {
    from_fn(|turn| {
        from_fn(|i| {
            let t = (i as f32 + 0.5) / SAMPLES as f32;
            let rise = 1.0 - t;
            let flat = (1.0 - rise * rise).sqrt();
            let (s, c) = (i as f32 * 2.399_963 + turn as f32 * 0.39).sin_cos();
            let far = REACH * (0.12 + 0.88 * ((i * 5) % SAMPLES) as f32 / SAMPLES as f32);
            Probe { way: [c * flat, rise, s * flat], far }
        })
    })
}

/// How open to the sky each pixel's surroundings are: looked up in the depths around it, at half the fineness.
struct Occlusion {
    size: [usize; 2],
    open: Vec<f32>,
}

impl Occlusion {
    fn of(buffer: &Buffer, lens: &Lens, threads: usize) -> Self {
        let size = lens.size.map(|s| s / FINE);
        let each = |value: &(dyn Fn(usize) -> f32 + Sync)| {
            let band = |rows: Range<usize>| (rows.start * size[0]..rows.end * size[0]).map(value).collect::<Vec<_>>();
            bands(size[1], threads, band).concat()
        };
        let ways = ways();
        let raw = each(&|at| {
            let (x, y) = (at % size[0], at / size[0]);
            Self::sample(buffer, lens, [x * FINE, y * FINE], &ways[x % TURNS * TURNS + y % TURNS])
        });
        // The mean over 4 × 4 pixels has all turns.
        let depth = |x: usize, y: usize| buffer.depth[y * FINE * lens.size[0] + x * FINE];
        let open = each(&|at| {
            let (x, y) = (at % size[0], at / size[0]);
            let own = depth(x, y);
            let (mut sum, mut weight) = (0.0, 0.0);
            for v in y.saturating_sub(2)..(y + 2).min(size[1]) {
                for u in x.saturating_sub(2)..(x + 2).min(size[0]) {
                    if (depth(u, v) - own).abs() < 0.08 || (u, v) == (x, y) {
                        sum += raw[v * size[0] + u];
                        weight += 1.0;
                    }
                }
            }
            if weight > 0.0 { sum / weight } else { 1.0 }
        });
        Self { size, open }
    }

    fn sample(buffer: &Buffer, lens: &Lens, [x, y]: [usize; 2], ways: &[Probe; SAMPLES]) -> f32 {
        let at = y * lens.size[0] + x;
        if buffer.shown[at] == NOTHING {
            return 1.0;
        }
        let normal = buffer.normal[at];
        let place = lens.world([x as f32 + 0.5, y as f32 + 0.5], buffer.depth[at]);
        let mut hidden = 0.0;
        for &Probe { way: mut d, far } in ways {
            let along = dot(d, normal);
            if along < 0.0 {
                d = from_fn(|k| d[k] - 2.0 * along * normal[k]);
            }
            let probe: [f32; 3] = from_fn(|k| place[k] + normal[k] * 0.01 + d[k] * far);
            let eye = lens.seen(probe);
            let [px, py] = lens.pixel(eye);
            if px < 0.0 || py < 0.0 || px >= lens.size[0] as f32 || py >= lens.size[1] as f32 {
                continue;
            }
            let front = eye[2] - buffer.depth[py as usize * lens.size[0] + px as usize];
            // Something just in front hides the sky; something far in front is another thing altogether.
            if front > 0.012 {
                hidden += (1.0 - (front - far * 1.5).max(0.0) / REACH).clamp(0.0, 1.0);
            }
        }
        1.0 - 0.85 * hidden / SAMPLES as f32
    }

    fn at(&self, x: usize, y: usize) -> f32 {
        let (x, y) = ((x / FINE).min(self.size[0] - 1), (y / FINE).min(self.size[1] - 1));
        self.open[y * self.size[0] + x]
    }
}

/// What is not opaque in the order in which it is drawn: farther things first.
fn far_first<'a>(mut clear: Vec<&'a Triangle>, lens: &Lens) -> Vec<&'a Triangle> {
    let far = |t: &Triangle| t.points.iter().map(|p| lens.seen(*p)[2]).sum::<f32>();
    clear.sort_by(|a, b| far(b).total_cmp(&far(a)));
    clear
}

/// Draws a triangle that is not opaque over the light of some rows.
fn glaze(
    stage: &Stage,
    lens: &Lens,
    buffer: &Buffer,
    sun: &Sun,
    triangle: &Triangle,
    rows: &Range<usize>,
    light: &mut [[f32; 3]],
) {
    let look = &stage.looks[triangle.look as usize];
    let width = lens.size[0];
    cover(lens, rows, triangle, |hit| {
        if hit.depth < buffer.depth[hit.at] {
            let normal = blend(triangle.normals, hit.weights);
            let middle = [hit.at % width, hit.at / width].map(|v| v as f32 + 0.5);
            let spot = Spot::at(lens, middle, hit.depth, normal, 1.0);
            let own = shade(&Matter::of(stage, triangle, &spot, lens), &spot, lens.eye, (sun, &stage.sources), 1.0);
            let light = &mut light[hit.at - rows.start * width];
            *light = from_fn(|i| light[i] + (own[i] - light[i]) * look.opacity);
        }
    });
}

/// Light to sRGB bytes: bright parts are rolled off, then samples are averaged. `width` is that of the light.
fn develop(light: &[[f32; 3]], width: usize, to: [usize; 2]) -> Vec<u8> {
    let mut out = Vec::with_capacity(to[0] * to[1] * 3);
    for y in 0..to[1] {
        for x in 0..to[0] {
            let mut sum = [0.0; 3];
            for k in 0..FINE * FINE {
                let sample = light[(y * FINE + k / FINE) * width + x * FINE + k % FINE];
                sum = from_fn(|i| sum[i] + shoulder(sample[i]));
            }
            out.extend(sum.map(|v| (encoded(v / (FINE * FINE) as f32) * 255.0).round() as u8));
        }
    }
    out
}

/// Straight up to a point, then bent so that it never passes 1.
fn shoulder(v: f32) -> f32 {
    const KNEE: f32 = 0.7;
    if v <= KNEE { v.max(0.0) } else { KNEE + (1.0 - KNEE) * (1.0 - (-(v - KNEE) / (1.0 - KNEE)).exp()) }
}

/// An sRGB component from linear light.
fn encoded(v: f32) -> f32 {
    if v <= 0.003_130_8 { v * 12.92 } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 }
}
