//! Objects from above: the outline of each convex part in the colour of its top, lower parts first; doors with their
//! swing, windows as lines in the wall.

use super::canvas::{Canvas, Rgb, escape, hex, mix, short};
use crate::Scene;
use crate::scene::{Body, Object, RegionKind};
use scenelang_layout::planar::convex_hull;
use scenelang_layout::{Convex, Motion, Obb, Prism, Vec2, Vec3};

const WHITE: Rgb = [1.0; 3];
const INK: Rgb = [0.13, 0.14, 0.16];
/// What hangs higher above the floor is over the heads of people (metres).
const HEAD: f64 = 1.9;
/// What violates something that must hold.
pub(super) const RED: &str = "#d7263d";

/// Something to draw: an object's part by the height of its top, or an object that is drawn whole.
struct Item<'a> {
    top: f64,
    object: &'a Object,
    part: Option<(usize, Convex)>,
}

/// Draws all objects, what is higher over what is lower: a chair's seat under the table, its back over it. So an object
/// may be in several groups.
pub(super) fn draw(canvas: &mut Canvas, scene: &Scene) {
    let mut items: Vec<Item<'_>> = Vec::new();
    for object in &scene.objects {
        if drawn_whole(object) {
            items.push(Item { top: Obb::from_placement(&object.place).aabb().max.y, object, part: None });
        } else {
            let parts = object.world_solid().enumerate();
            items.extend(parts.map(|p| Item { top: p.1.aabb().max.y, object, part: Some(p) }));
        }
    }
    items.sort_by(|a, b| a.top.total_cmp(&b.top));
    for run in items.chunk_by(|a, b| a.object.name == b.object.name) {
        let object = run[0].object;
        let bad = if object.violated { r#" data-violated="true""# } else { "" };
        let name = escape(&object.name);
        canvas.raw(&format!(r#"<g data-object="{name}"{bad}><title>{}</title>"#, escape(&title(object))));
        for item in run {
            match (&item.part, object.family.as_str()) {
                (Some((index, world)), _) => part(canvas, scene, object, *index, world),
                (None, "door") => door(canvas, object),
                (None, _) => window(canvas, object),
            }
        }
        canvas.raw("</g>");
    }
}

/// Draws the area that parts sweep when they open as far as is demanded or useful: in thin lines, and in red where something is
/// in the way.
pub(super) fn sweeps(canvas: &mut Canvas, scene: &Scene) {
    for object in &scene.objects {
        for opening in object.openings.iter().filter(|o| o.asked && !o.swept.is_empty()) {
            let outline: Vec<Vec2> = opening.swept.iter().map(|p| object.at(Vec3::new(p.x, 0.0, p.y)).xz()).collect();
            let (ink, bad) = if opening.blocked { (RED, r#" data-violated="true""#) } else { ("#6a717b", "") };
            let name = escape(&format!("{}/{}", object.name, object.place.joints[opening.joint].name));
            canvas.polygon(
                &outline,
                &format!(r#"data-swept="{name}"{bad} fill="{ink}" fill-opacity="0.06" stroke="{ink}" stroke-width="0.7" stroke-dasharray="3 2.5""#),
            );
        }
    }
}

/// Doors and windows that stand upright have signs of their own.
fn drawn_whole(object: &Object) -> bool {
    ["door", "window"].contains(&object.family.as_str()) && object.axes[(1, 1)] > 0.99
}

/// `chair[0] — office chair, 0.5 × 0.9 × 0.5 m`
fn title(object: &Object) -> String {
    let kind = if object.category.is_empty() { &object.family } else { &object.category };
    let [w, h, d] = [object.place.scale.x, object.place.scale.y, object.place.scale.z].map(short);
    format!("{} — {kind}, {w} × {h} × {d} m", object.name)
}

fn part(canvas: &mut Canvas, scene: &Scene, object: &Object, index: usize, world: &Convex) {
    let outline = convex_hull(world.vertices().iter().map(|v| Vec2::new(v.x, v.z)));
    if is_overhead(scene, object) {
        let ink = if object.violated { RED } else { "#8a9099" };
        canvas.polygon(&outline, &format!(r#"fill="none" stroke="{ink}" stroke-width="0.9" stroke-dasharray="4 3""#));
        return;
    }
    canvas.polygon(&outline, &style(object, color_of(scene, object, index), 1.0));
}

/// The colour of a part seen from above; of what stands upright it is found out once.
fn color_of(scene: &Scene, object: &Object, part: usize) -> Rgb {
    if object.axes.row(1).transpose() != Vec3::y() {
        return top_color(scene, object, &object.solid[part]);
    }
    object.tops.get_or_init(|| object.solid.iter().map(|part| top_color(scene, object, part)).collect())[part]
}

/// Whether an object hangs over the heads of people: such things are drawn in dashes.
pub(super) fn is_overhead(scene: &Scene, object: &Object) -> bool {
    let under =
        |prism: &Prism| object.place.pos.y > prism.floor + HEAD && prism.polygon.contains(object.place.pos.xz());
    object.body == Body::Held && scene.regions.iter().any(|r| r.kind == RegionKind::Room && under(&r.prism))
}

/// Fill and outline of something of a colour; what violates a constraint is reddened and outlined in red.
fn style(object: &Object, color: Rgb, width: f64) -> String {
    let fill = mix(color, WHITE, 0.12);
    let (fill, stroke, width) = if object.violated {
        (hex(mix(fill, [0.93, 0.3, 0.34], 0.55)), RED.to_owned(), width + 0.8)
    } else {
        (hex(fill), hex(mix(color, INK, 0.55)), width)
    };
    format!(r#"fill="{fill}" stroke="{stroke}" stroke-width="{}" stroke-linejoin="round""#, short(width))
}

/// The colour of a part seen from above: of the largest faces that look up within it, else of the object's largest.
fn top_color(scene: &Scene, object: &Object, part: &Convex) -> Rgb {
    const SLACK: f64 = 0.01;
    let bounds = part.aabb();
    let within = |p: &Vec3| (0..3).all(|k| p[k] > bounds.min[k] - SLACK && p[k] < bounds.max[k] + SLACK);
    let mut best = (0.0, None);
    let mut largest = (0.0, None);
    for group in &object.mesh {
        let (mut facing_up, mut all) = (0.0, 0.0);
        for corners in group.triangles() {
            let [a, b, c] = corners.map(|p| Vec3::from(p.map(f64::from)));
            let area = (b - a).cross(&(c - a));
            all += area.norm();
            let up = object.axes.row(1).dot(&area.transpose());
            if up > 0.3 * area.norm() && within(&((a + b + c) / 3.0)) {
                facing_up += up;
            }
        }
        if facing_up > best.0 {
            best = (facing_up, Some(group.surface));
        }
        if all > largest.0 {
            largest = (all, Some(group.surface));
        }
    }
    best.1.or(largest.1).map_or([0.6; 3], |s| scene.surfaces[s].color)
}

/// Right and front in the plan, and the middle of the object.
fn frame(object: &Object) -> (Vec2, Vec2, Vec2) {
    let axis = |k: usize| Vec2::new(object.axes[(0, k)], object.axes[(2, k)]).normalize();
    (axis(0), axis(2), object.place.pos.xz())
}

fn corners(object: &Object) -> [Vec2; 4] {
    let (right, front, middle) = frame(object);
    let (r, f) = (right * object.place.scale.x / 2.0, front * object.place.scale.z / 2.0);
    [middle - r - f, middle + r - f, middle + r + f, middle - r + f]
}

/// A leaf that stands open towards the front, and the quarter circle it sweeps; a wide door has two.
fn door(canvas: &mut Canvas, object: &Object) {
    let (right, front, middle) = frame(object);
    let ink = if object.violated { RED } else { "#4a4f57" };
    canvas.polygon(&corners(object), &format!(r##"fill="#ffffff" stroke="{ink}" stroke-width="0.8""##));
    let width = object.place.scale.x;
    let half = right * width / 2.0;
    let hinged = object.openings.iter().filter(|o| object.place.joints[o.joint].motion == Motion::Hinge);
    for ends in hinged.filter_map(|o| o.swept.first().zip(o.swept.last())) {
        let [h, o] = [ends.0, ends.1].map(|p| canvas.px(object.at(Vec3::new(p.x, 0.0, p.y)).xz()));
        canvas.line(h, o, &format!(r#"stroke="{ink}" stroke-width="2.2" stroke-linecap="round""#));
    }
    // What is swept is drawn from the joints where there are any.
    let leaves = if slides(object) || !object.openings.is_empty() {
        Vec::new()
    } else if width > 1.3 {
        vec![(middle - half, middle, width / 2.0), (middle + half, middle, width / 2.0)]
    } else {
        vec![(middle - half, middle + half, width)]
    };
    for (hinge, latch, length) in leaves {
        let open = hinge + front * length;
        let [h, l, o] = [hinge, latch, open].map(|p| canvas.px(p));
        let turn = (l[0] - h[0]) * (o[1] - h[1]) - (l[1] - h[1]) * (o[0] - h[0]);
        let r = short(length * canvas.scale);
        canvas.raw(&format!(
            r#"<path d="M {} {} A {r} {r} 0 0 {} {} {}" fill="none" stroke="{ink}" stroke-width="0.9" stroke-dasharray="3 2.5"/>"#,
            short(l[0]), short(l[1]), i32::from(turn > 0.0), short(o[0]), short(o[1])
        ));
        canvas.line(h, o, &format!(r#"stroke="{ink}" stroke-width="2.2" stroke-linecap="round""#));
    }
}

/// Whether a door goes up or aside, so that no leaf stands in the way.
fn slides(object: &Object) -> bool {
    const KINDS: [&str; 7] = ["garage", "roller", "loading", "sliding", "elevator", "lift", "barn"];
    let category = object.category.replace('_', " ");
    category.split(' ').any(|word| KINDS.contains(&word))
}

/// The frame, and the pane as a line along its middle.
fn window(canvas: &mut Canvas, object: &Object) {
    let ink = if object.violated { RED } else { "#4f7d99" };
    canvas.polygon(&corners(object), &format!(r##"fill="#e8f3f9" stroke="{ink}" stroke-width="0.9""##));
    let (right, _, middle) = frame(object);
    let half = right * object.place.scale.x / 2.0;
    let [a, b] = [middle - half, middle + half].map(|p| canvas.px(p));
    canvas.line(a, b, &format!(r#"stroke="{ink}" stroke-width="0.9""#));
}
