//! Names on the plan: objects on their footprint where there is room, regions in the emptiest spot of their floor.

use super::canvas::{Canvas, Px, text_width};
use crate::Scene;
use crate::scene::{Object, Region, RegionKind};
use scenelang_layout::{Obb, Vec2};

const LARGEST: f64 = 11.5;
const SMALLEST: f64 = 7.5;
const HALO: &str = r##"stroke="#ffffff" stroke-opacity="0.72" stroke-width="2.6" stroke-linejoin="round" paint-order="stroke" pointer-events="none""##;

/// A rectangle of the sheet: least and greatest corner.
type Span = [Px; 2];

/// Labels set so far; a new one must not touch them.
#[derive(Default)]
pub(super) struct Labels {
    taken: Vec<Span>,
}

impl Labels {
    /// Keeps a text clear of others; says whether it may stand there.
    fn claim(&mut self, at: Px, [w, h]: [f64; 2]) -> bool {
        let span = [[at[0] - w / 2.0, at[1] - h / 2.0], [at[0] + w / 2.0, at[1] + h / 2.0]];
        let apart = |other: &Span| (0..2).any(|k| span[1][k] < other[0][k] || span[0][k] > other[1][k]);
        let free = self.taken.iter().all(apart);
        if free {
            self.taken.push(span);
        }
        free
    }

    /// Name and area of rooms, names of zones.
    pub fn regions(&mut self, canvas: &mut Canvas, scene: &Scene) {
        for region in &scene.regions {
            let zone = region.kind == RegionKind::Zone;
            let size = if zone { 11.0 } else { 15.0 };
            let second = if zone { String::new() } else { format!("{:.1} m²", region.prism.area()) };
            let width = text_width(&region.name, size).max(text_width(&second, 11.0)) + 6.0;
            let height = if zone { size } else { size + 17.0 } + 4.0;
            let at = canvas.px(emptiest(scene, region, [width / canvas.scale, height / canvas.scale]));
            self.claim(at, [width, height]);
            let lift = if zone { 0.0 } else { 8.0 };
            let style = format!(r##"font-weight="600" fill="#5a6069" {HALO}"##);
            canvas.text([at[0], at[1] - lift], &region.name, size, 0.0, &style);
            if !zone {
                canvas.text([at[0], at[1] + 9.0], &second, 11.0, 0.0, &format!(r##"fill="#7a818b" {HALO}"##));
            }
        }
    }

    /// Names of objects, larger ones first.
    pub fn objects(&mut self, canvas: &mut Canvas, scene: &Scene) {
        let mut order: Vec<(&Object, [f64; 2])> = scene.objects.iter().map(|o| (o, extent(canvas, o))).collect();
        order.sort_by(|a, b| (b.1[0] * b.1[1]).total_cmp(&(a.1[0] * a.1[1])));
        for (object, [w, h]) in order {
            let at = canvas.px(Obb::from_placement(&object.place).center.xz());
            let index = object.name.find('[').map_or("", |i| &object.name[i..]);
            let whole = (object.name.as_str(), w, h);
            let turned = h > 1.4 * w;
            let fit = |text: &str, along: f64, across: f64| {
                let size = LARGEST.min(along / text_width(text, 1.0)).min(across * 0.8);
                (size >= SMALLEST).then_some(size)
            };
            let (text, size, turn) = if let Some(size) = fit(whole.0, w, h) {
                (whole.0, size, 0.0)
            } else if let Some(size) = fit(whole.0, h, w).filter(|_| turned) {
                (whole.0, size, -90.0)
            } else if let Some(size) = fit(index, w, h).filter(|_| !index.is_empty()) {
                (index, size, 0.0)
            } else {
                (whole.0, SMALLEST, 0.0)
            };
            let long = text_width(text, size);
            let room = if turn == 0.0 { [long, size] } else { [size, long] };
            if self.claim(at, room) {
                let color = if object.violated { super::furniture::RED } else { "#1f2328" };
                canvas.text(at, text, size, turn, &format!(r#"fill="{color}" {HALO}"#));
            }
        }
    }
}

/// How wide and high the footprint is on the sheet.
fn extent(canvas: &Canvas, object: &Object) -> [f64; 2] {
    let bounds = Obb::from_placement(&object.place).aabb();
    let size = (bounds.max - bounds.min) * canvas.scale;
    [size.x, size.z]
}

/// Where in a region a text of a size (metres) has most room around it, furniture and walls considered.
fn emptiest(scene: &Scene, region: &Region, [w, h]: [f64; 2]) -> Vec2 {
    const STEPS: i32 = 36;
    let polygon = &region.prism.polygon;
    let things: Vec<_> = scene.objects.iter().map(|o| Obb::from_placement(&o.place).aabb()).collect();
    let (mut lo, mut hi) = (polygon.corners()[0], polygon.corners()[0]);
    for c in polygon.corners() {
        (lo, hi) = (lo.inf(c), hi.sup(c));
    }
    let room = |p: Vec2| {
        let from_text = |q: Vec2| {
            let d = (q - p).abs() - Vec2::new(w, h) / 2.0;
            d.x.max(d.y)
        };
        let walls = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(i, j)| polygon.clearance_of_point(p + Vec2::new(i * w, j * h) / 2.0).value);
        let furniture = things.iter().map(|b| from_text(p.sup(&b.min.xz()).inf(&b.max.xz())));
        furniture.chain(walls).fold(0.6, f64::min) - 0.02 * (p - polygon.centroid()).norm()
    };
    let at = |i: i32, j: i32| lo + (hi - lo).component_mul(&Vec2::new(f64::from(i), f64::from(j))) / f64::from(STEPS);
    let mut best = (f64::NEG_INFINITY, polygon.centroid());
    for (i, j) in (1..STEPS).flat_map(|i| (1..STEPS).map(move |j| (i, j))) {
        let value = room(at(i, j));
        if value > best.0 {
            best = (value, at(i, j));
        }
    }
    best.1
}
