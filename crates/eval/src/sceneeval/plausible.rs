//! Plausibility of the objects of a layout: whether something holds them, whether they are inside each other, whether they
//! are outside of the rooms. Doors and windows are part of the house, and not asked.

use super::floor;
use super::scene::{Held, ScoredObject, ScoredRoom, ScoredScene};
use super::table::Table;
use scenelang_layout::planar::{convex_hull, depth_in_convex};
use scenelang_layout::{Convex, Vec2, Vec3, convex};

/// An object is lifted by so much before it is asked what is below it (metres).
const LIFT: f64 = 0.005;
/// What is that near then holds it (metres).
const REACH: f64 = 0.01;
/// Bodies that are this deep inside each other collide (metres).
const DEEP: f64 = 0.005;
/// The share of an object that has to be above a floor.
const IN_BOUNDS: f64 = 0.99;
/// Points along each axis of a box where its share is measured.
const ACROSS: usize = 12;

/// What is plausible about a layout.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plausible {
    /// How many objects there are, doors and windows apart.
    pub objects: usize,
    /// The objects that nothing holds.
    pub unsupported: Vec<String>,
    /// Pairs of objects that are inside each other.
    pub collisions: Vec<[String; 2]>,
    /// How many objects are in such a pair.
    pub colliding: usize,
    /// The objects that are not over a floor.
    pub outside: Vec<String>,
    /// The share of the free floor that can be walked on from its largest piece; `None`: there is no room.
    pub navigability: Option<f64>,
    /// Of each object that is stepped up to, the greatest share of the strip at one of its sides that is free.
    pub accessibility: Vec<(String, f64)>,
}

impl Plausible {
    /// Looks at a layout.
    pub fn of(scene: &ScoredScene, table: &Table) -> Self {
        let things: Vec<&ScoredObject> = scene.things.iter().filter(|thing| thing.held != Held::House).collect();
        let name = |thing: &ScoredObject| thing.looks.name.clone();
        let mut out = Self { objects: things.len(), ..Self::default() };
        let mut colliding = vec![false; things.len()];
        for (i, a) in things.iter().enumerate() {
            for (j, b) in things.iter().enumerate().skip(i + 1) {
                if collide(a, b) {
                    (colliding[i], colliding[j]) = (true, true);
                    out.collisions.push([name(a), name(b)]);
                }
            }
        }
        out.colliding = colliding.into_iter().filter(|collides| *collides).count();
        let names =
            |those: &dyn Fn(&ScoredObject) -> bool| things.iter().filter(|t| those(t)).map(|t| name(t)).collect();
        out.unsupported = names(&|thing| !is_held(thing, scene));
        out.outside = names(&|thing| share_in_bounds(thing, &scene.rooms) < IN_BOUNDS);
        out.navigability = floor::navigability(scene);
        out.accessibility = floor::accessibility(scene, table);
        out
    }
}

fn collide(a: &ScoredObject, b: &ScoredObject) -> bool {
    let apart = convex::aabb(&a.solid).distance(&convex::aabb(&b.solid)) > 0.0;
    !apart && convex::nearest(&a.solid, &b.solid).is_some_and(|nearest| nearest.separation.gap < -DEEP)
}

/// The share of an object's box that is above a floor.
fn share_in_bounds(thing: &ScoredObject, rooms: &[ScoredRoom]) -> f64 {
    let obb = &thing.shape.obb;
    let step = |i: usize| (2 * i + 1) as f64 / ACROSS as f64 - 1.0;
    let points = (0..ACROSS.pow(3)).map(|i| {
        let cell = Vec3::new(step(i / (ACROSS * ACROSS)), step(i / ACROSS % ACROSS), step(i % ACROSS));
        obb.center + obb.axes * cell.component_mul(&obb.half)
    });
    let above = |p: &Vec3| rooms.iter().any(|r| p.y >= r.floor && r.outline.contains(Vec2::new(p.x, p.z)));
    points.filter(above).count() as f64 / ACROSS.pow(3) as f64
}

/// Whether something holds an object: of what hangs, anything behind or above it; of what stands, so much below it that
/// its middle is over what carries it.
fn is_held(thing: &ScoredObject, scene: &ScoredScene) -> bool {
    let others: Vec<&Convex> = scene
        .things
        .iter()
        .filter(|other| !std::ptr::eq(*other, thing))
        .flat_map(|other| &other.solid)
        .filter(|part| part.aabb().distance(&convex::aabb(&thing.solid)) <= REACH)
        .collect();
    let meets = |from: &Vec3, way: &Vec3| {
        let start = from - way * LIFT;
        others.iter().filter_map(|part| enters(part, &start, way)).any(|distance| distance < REACH)
    };
    let near = |gap: f64| gap.abs() <= REACH - LIFT + 1e-9;
    let obb = &thing.shape.obb;
    match thing.held {
        Held::House => true,
        Held::Wall => {
            let back: Vec3 = -Vec3::from(obb.axes.column(2));
            let at_wall =
                |p: &Vec3| scene.rooms.iter().any(|r| near(r.outline.clearance_of_point(Vec2::new(p.x, p.z)).value));
            face(&thing.solid, &back).iter().any(|p| at_wall(p) || meets(p, &back))
        }
        Held::Ceiling => {
            let at_ceiling =
                |p: &Vec3| scene.rooms.iter().any(|r| near(r.ceiling - p.y) && r.outline.contains(Vec2::new(p.x, p.z)));
            face(&thing.solid, &Vec3::y()).iter().any(|p| at_ceiling(p) || meets(p, &Vec3::y()))
        }
        Held::Below => {
            let down = -Vec3::y();
            let on_floor = |p: &Vec3| {
                let over = |r: &ScoredRoom| r.outline.clearance_of_point(Vec2::new(p.x, p.z)).value >= -REACH;
                scene.rooms.iter().any(|r| near(p.y - r.floor) && over(r))
            };
            let contacts = face(&thing.solid, &down).into_iter().filter(|p| on_floor(p) || meets(p, &down));
            let base = convex_hull(contacts.map(|p| Vec2::new(p.x, p.z)));
            base.len() > 2 && depth_in_convex(&base, Vec2::new(obb.center.x, obb.center.z)) >= -1e-9
        }
    }
}

/// Points of a body that are furthest that way, within a centimetre: its corners, and between them a grid on each part.
fn face(solid: &[Convex], way: &Vec3) -> Vec<Vec3> {
    const STEPS: usize = 8;
    let furthest = solid.iter().map(|part| part.support_height(way)).fold(f64::NEG_INFINITY, f64::max);
    // Two directions across it.
    let some = if way.y.abs() > 0.9 { Vec3::x() } else { Vec3::y() };
    let u = some.cross(way).normalize();
    let v = way.cross(&u);
    let mut out = Vec::new();
    for part in solid {
        let corners: Vec<Vec3> = part.vertices().iter().copied().filter(|c| c.dot(way) >= furthest - REACH).collect();
        let Some(first) = corners.first() else { continue };
        let height = first.dot(way);
        let outline = convex_hull(corners.iter().map(|c| Vec2::new(c.dot(&u), c.dot(&v))));
        let low = outline.iter().fold(Vec2::repeat(f64::INFINITY), |m, c| m.inf(c));
        let high = outline.iter().fold(Vec2::repeat(f64::NEG_INFINITY), |m, c| m.sup(c));
        let step = |i: usize| (2 * i + 1) as f64 / (2 * STEPS) as f64;
        let cells =
            (0..STEPS * STEPS).map(|i| low + (high - low).component_mul(&Vec2::new(step(i / STEPS), step(i % STEPS))));
        let inside = cells.filter(|cell| outline.len() > 2 && depth_in_convex(&outline, *cell) >= 0.0);
        out.extend(inside.map(|cell| u * cell.x + v * cell.y + way * height));
        out.extend(corners);
    }
    out
}

/// How far along a ray it meets a body; 0 within it, `None` where it does not.
fn enters(part: &Convex, from: &Vec3, way: &Vec3) -> Option<f64> {
    let (mut enters, mut leaves) = (0.0_f64, f64::INFINITY);
    for face in part.faces() {
        let corner = part.face_corners(face).next()?;
        let (off, along) = (face.normal.dot(&(corner - from)), face.normal.dot(way));
        if along.abs() < 1e-12 {
            if off < 0.0 {
                return None;
            }
        } else if along < 0.0 {
            enters = enters.max(off / along);
        } else {
            leaves = leaves.min(off / along);
        }
    }
    (enters <= leaves).then_some(enters)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sceneeval::names::Looks;
    use crate::sceneeval::shape::Shape;
    use scenelang_layout::{Geometry, Placement};

    fn thing(name: &str, pos: [f64; 3], scale: [f64; 3], held: Held) -> ScoredObject {
        let (pos, rot, scale) = (Vec3::from(pos), Vec3::zeros(), Vec3::from(scale));
        let placement = Placement { pos, rot, scale, parts: Vec::new(), surface: None, joints: Vec::new() };
        let looks = Looks { name: name.into(), category: name.into(), ..Looks::default() };
        let solid = convex::solid(&placement, Geometry::Parts);
        ScoredObject { looks, shape: Shape::new(&placement), solid, held }
    }

    fn look(things: Vec<ScoredObject>) -> Plausible {
        let scene = ScoredScene { things, rooms: vec![ScoredRoom::rectangle([-2.0, -2.0], [2.0, 2.0], 0.0, 2.6)] };
        Plausible::of(&scene, &Table::new())
    }

    #[test]
    fn what_stands_and_what_does_not() {
        let found = look(vec![
            thing("desk", [0.0, 0.0, 0.0], [1.0, 0.7, 0.6], Held::Below),
            thing("vase", [0.3, 0.7, 0.0], [0.2, 0.3, 0.2], Held::Below),
            // Its middle is beyond the edge of the desk.
            thing("bowl", [-0.55, 0.7, 0.0], [0.3, 0.2, 0.3], Held::Below),
            thing("balloon", [1.0, 1.0, 1.0], [0.3, 0.3, 0.3], Held::Below),
        ]);
        assert_eq!(found.unsupported, ["bowl", "balloon"]);
        assert_eq!((found.objects, found.colliding, found.outside.len()), (4, 0, 0));
    }

    #[test]
    fn what_hangs() {
        // A thing's back is at -z.
        let found = look(vec![
            thing("mirror", [0.0, 1.0, -1.98], [0.6, 0.8, 0.04], Held::Wall),
            thing("picture", [1.0, 1.0, -1.9], [0.6, 0.8, 0.04], Held::Wall),
            thing("pendant", [0.0, 2.2, 0.0], [0.4, 0.4, 0.4], Held::Ceiling),
            thing("lantern", [1.0, 2.0, 0.0], [0.4, 0.4, 0.4], Held::Ceiling),
            thing("door", [0.0, 0.0, 2.05], [0.9, 2.0, 0.1], Held::House),
        ]);
        assert_eq!(found.unsupported, ["picture", "lantern"]);
        assert_eq!(found.objects, 4);
    }

    #[test]
    fn inside_each_other_and_outside() {
        let found = look(vec![
            thing("desk", [0.0, 0.0, 0.0], [1.0, 0.7, 0.6], Held::Below),
            // A collision begins beyond five millimetres.
            thing("shelf", [0.996, 0.0, 0.0], [1.0, 0.7, 0.6], Held::Below),
            thing("chair", [0.0, 0.0, 0.4], [0.4, 0.9, 0.4], Held::Below),
            thing("bed", [1.5, 0.0, -1.0], [1.6, 0.5, 1.0], Held::Below),
        ]);
        assert_eq!(found.collisions, [["desk", "chair"]]);
        assert_eq!((found.colliding, found.outside), (2, vec!["bed".to_owned()]));
    }
}
