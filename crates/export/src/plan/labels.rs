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
            let name = words(&region.name);
            let width = text_width(&name, size).max(text_width(&second, 11.0)) + 6.0;
            let height = if zone { size } else { size + 17.0 } + 4.0;
            let at = canvas.px(emptiest(scene, region, [width / canvas.scale, height / canvas.scale]));
            self.claim(at, [width, height]);
            let lift = if zone { 0.0 } else { 8.0 };
            let style = format!(r##"font-weight="600" fill="#5a6069" {HALO}"##);
            canvas.text([at[0], at[1] - lift], &name, size, 0.0, &style);
            if !zone {
                canvas.text([at[0], at[1] + 9.0], &second, 11.0, 0.0, &format!(r##"fill="#7a818b" {HALO}"##));
            }
        }
    }

    /// What objects are, larger ones first, where the words fit on the object. One that violates something has its name in
    /// the program, wherever that ends; the others have it in the title that a browser shows.
    pub fn objects(&mut self, canvas: &mut Canvas, scene: &Scene) {
        let shown = scene.objects.iter().filter(|o| o.violated || !super::furniture::is_overhead(scene, o));
        let mut order: Vec<(&Object, [f64; 2])> = shown.map(|o| (o, extent(canvas, o))).collect();
        order.sort_by(|a, b| b.0.violated.cmp(&a.0.violated).then((b.1[0] * b.1[1]).total_cmp(&(a.1[0] * a.1[1]))));
        for (object, [w, h]) in order {
            let at = canvas.px(Obb::from_placement(&object.place).center.xz());
            let text = if object.violated { object.name.clone() } else { words(&object.name) };
            let fit = |along: f64, across: f64| {
                let size = LARGEST.min(along / text_width(&text, 1.0)).min(across * 0.8);
                (size >= SMALLEST).then_some(size)
            };
            let turned = || fit(h, w).filter(|_| h > 1.4 * w).map(|size| (size, -90.0));
            let forced = object.violated.then_some((SMALLEST, 0.0));
            let Some((size, turn)) = fit(w, h).map(|size| (size, 0.0)).or_else(turned).or(forced) else { continue };
            let long = text_width(&text, size);
            let room = if turn == 0.0 { [long, size] } else { [size, long] };
            if self.claim(at, room) {
                let color = if object.violated { super::furniture::RED } else { "#1f2328" };
                canvas.text(at, &text, size, turn, &format!(r#"fill="{color}" {HALO}"#));
            }
        }
    }
}

/// The words of a name, without what tells one from others of its kind: `studentDesk2[0]` is a student desk.
fn words(name: &str) -> String {
    let own = name.split('[').next().unwrap_or(name);
    let own = own.trim_end_matches(|c: char| c.is_ascii_digit());
    let mut out = String::with_capacity(own.len() + 4);
    for c in own.chars() {
        if c.is_uppercase() || c == '_' {
            out.push(' ');
        }
        out.extend(c.to_lowercase().filter(|c| *c != '_'));
    }
    out.trim().to_owned()
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

#[cfg(test)]
mod tests {
    use super::words;

    #[test]
    fn names_of_programs_become_words() {
        let said = ["studentDesk2[0]", "open_plan_office", "lamp[3]", "TV", "bed"].map(words);
        assert_eq!(said, ["student desk", "open plan office", "lamp", "t v", "bed"]);
    }
}
