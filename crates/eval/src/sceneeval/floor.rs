//! Plausibility of the floor: how much of what is free hangs together, and whether one can step up to things. Both look at
//! the floor from above, where every object is its box's footprint, a rug like a wardrobe.

use super::names::words;
use super::scene::{Held, ScoredObject, ScoredScene};
use super::shape::Shape;
use super::table::Table;
use scenelang_layout::planar::depth_in_convex;
use scenelang_layout::{Vec2, Vec3};

/// Cells along each side of the picture of the floor.
const CELLS: usize = 256;
/// Around the floor (metres).
const MARGIN: f64 = 0.2;
/// Half the width of who walks (metres).
const HALF: f64 = 0.1;
/// Objects whose middle is higher above the lowest floor do not block it (metres).
const HEAD: f64 = 2.0;
/// How deep the strip is that has to be free before a side, and how far from it (metres).
const STRIP: [f64; 2] = [0.2, 0.05];
/// Through a door one steps so far to both sides of it (metres).
const THRESHOLD: f64 = 0.3;
/// What begins lower than this stands on the floor (metres).
const STANDS: f64 = 0.05;

/// The floor and what is on it.
struct Ground<'a> {
    scene: &'a ScoredScene,
    /// Ways through doors.
    doors: Vec<Vec<Vec2>>,
    /// Footprints, each with its object.
    blocks: Vec<(&'a ScoredObject, Vec<Vec2>)>,
    /// Height of the lowest floor.
    base: f64,
}

impl<'a> Ground<'a> {
    fn new(scene: &'a ScoredScene) -> Self {
        let base = scene.rooms.iter().map(|room| room.floor).fold(f64::INFINITY, f64::min);
        let is_door = |thing: &&ScoredObject| {
            thing.held == Held::House && words(&thing.looks.category).last().is_some_and(|noun| noun == "door")
        };
        let way = |thing: &ScoredObject| {
            let mut obb = thing.shape.obb;
            obb.half.z += THRESHOLD;
            obb.footprint()
        };
        let blocks = |thing: &&ScoredObject| thing.held != Held::House && thing.shape.obb.center.y - base <= HEAD;
        Self {
            scene,
            doors: scene.things.iter().filter(is_door).map(way).collect(),
            blocks: scene.things.iter().filter(blocks).map(|t| (t, t.shape.obb.footprint())).collect(),
            base,
        }
    }

    fn is_floor(&self, p: Vec2) -> bool {
        self.scene.rooms.iter().any(|room| room.outline.contains(p))
            || self.doors.iter().any(|door| depth_in_convex(door, p) >= 0.0)
    }
}

/// The share of the free floor that the largest piece of it has, eight neighbours to a cell; 0 where nothing is free,
/// `None` where there is no room.
pub fn navigability(scene: &ScoredScene) -> Option<f64> {
    let low = scene.rooms.iter().map(|room| room.low).reduce(|a, b| a.inf(&b))?;
    let high = scene.rooms.iter().map(|room| room.high).reduce(|a, b| a.sup(&b))?;
    let ground = Ground::new(scene);
    let center = (low + high) / 2.0;
    let cell = 2.0 * ((high - low).amax() / 2.0 + MARGIN) / CELLS as f64;
    let at = |i: usize, j: usize| {
        let step = |n: usize| (n as f64 + 0.5 - CELLS as f64 / 2.0) * cell;
        center + Vec2::new(step(i), step(j))
    };
    let floor = picture(|i, j| ground.is_floor(at(i, j)));
    let floor = eroded(&floor, (HALF / cell).floor() as usize);
    let free = picture(|i, j| {
        floor[i * CELLS + j] && !ground.blocks.iter().any(|(_, block)| depth_in_convex(block, at(i, j)) > -HALF)
    });
    let all = free.iter().filter(|cell| **cell).count();
    Some(if all == 0 { 0.0 } else { largest(free) as f64 / all as f64 })
}

fn picture(of: impl Fn(usize, usize) -> bool) -> Vec<bool> {
    (0..CELLS * CELLS).map(|n| of(n / CELLS, n % CELLS)).collect()
}

/// The cells around which a square of so many cells to each side is all floor: first along one axis, then the other.
fn eroded(floor: &[bool], by: usize) -> Vec<bool> {
    let whole = |n: usize| n.saturating_sub(by)..=(n + by).min(CELLS - 1);
    let along = picture(|i, j| whole(i).all(|i| floor[i * CELLS + j]));
    picture(|i, j| whole(j).all(|j| along[i * CELLS + j]))
}

/// How many cells the largest connected piece has.
fn largest(mut free: Vec<bool>) -> usize {
    let mut most = 0;
    for start in 0..free.len() {
        let (mut open, mut size) = (Vec::new(), 0);
        if std::mem::take(&mut free[start]) {
            open.push(start);
        }
        while let Some(n) = open.pop() {
            size += 1;
            let near = |m: usize| m.saturating_sub(1)..=(m + 1).min(CELLS - 1);
            for i in near(n / CELLS) {
                for j in near(n % CELLS) {
                    if std::mem::take(&mut free[i * CELLS + j]) {
                        open.push(i * CELLS + j);
                    }
                }
            }
        }
        most = most.max(size);
    }
    most
}

/// Of each object that stands on a floor and is stepped up to, the greatest share, over the sides from which it is used, of
/// the strip before that side that is floor with nothing on it.
pub fn accessibility(scene: &ScoredScene, table: &Table) -> Vec<(String, f64)> {
    let ground = Ground::new(scene);
    let stands = |thing: &&ScoredObject| {
        let lowest = thing.shape.obb.aabb().min.y;
        thing.held == Held::Below && scene.rooms.iter().any(|room| (lowest - room.floor).abs() < STANDS)
    };
    let score = |thing: &ScoredObject| {
        let sides = sides(thing, table).iter();
        let best = sides.map(|side| free_share(&ground, &thing.shape, *side)).reduce(f64::max)?;
        Some((thing.looks.name.clone(), best))
    };
    if ground.base.is_finite() { scene.things.iter().filter(stands).filter_map(score).collect() } else { Vec::new() }
}

/// The sides from which a thing is used, as axis and direction.
fn sides(thing: &ScoredObject, table: &Table) -> &'static [(usize, f64)] {
    let noun = words(&thing.looks.category).pop().unwrap_or_default();
    if table.has("sides none", &noun) {
        &[]
    } else if table.has("sides all", &noun) {
        &[(2, 1.0), (2, -1.0), (0, 1.0), (0, -1.0)]
    } else if table.has("sides three", &noun) {
        &[(2, 1.0), (0, 1.0), (0, -1.0)]
    } else {
        &[(2, 1.0)]
    }
}

/// The share of the strip before a side that is free.
fn free_share(ground: &Ground<'_>, shape: &Shape, (axis, way): (usize, f64)) -> f64 {
    const ALONG: usize = 40;
    const DEEP: usize = 8;
    let obb = &shape.obb;
    let across = 2 - axis;
    let mut free = 0;
    for n in 0..ALONG * DEEP {
        let (i, j) = ((n / DEEP) as f64 + 0.5, (n % DEEP) as f64 + 0.5);
        let mut local = Vec3::zeros();
        local[across] = (2.0 * i / ALONG as f64 - 1.0) * obb.half[across];
        local[axis] = way * (obb.half[axis] + STRIP[1] + STRIP[0] * j / DEEP as f64);
        let point = obb.center + obb.axes * local;
        let point = Vec2::new(point.x, point.z);
        let blocked = ground.blocks.iter().any(|(_, block)| depth_in_convex(block, point) > 0.0);
        free += usize::from(ground.is_floor(point) && !blocked);
    }
    free as f64 / (ALONG * DEEP) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sceneeval::names::Looks;
    use crate::sceneeval::scene::ScoredRoom;
    use scenelang_layout::{Geometry, Placement, convex};

    fn thing(name: &str, pos: [f64; 3], scale: [f64; 3]) -> ScoredObject {
        let (pos, rot, scale) = (Vec3::from(pos), Vec3::zeros(), Vec3::from(scale));
        let placement = Placement { pos, rot, scale, parts: Vec::new(), surface: None, joints: Vec::new() };
        let looks = Looks { name: name.into(), category: name.into(), ..Looks::default() };
        let held = if name == "door" { Held::House } else { Held::Below };
        ScoredObject { looks, shape: Shape::new(&placement), solid: convex::solid(&placement, Geometry::Parts), held }
    }

    fn scene(things: Vec<ScoredObject>) -> ScoredScene {
        ScoredScene { things, rooms: vec![ScoredRoom::rectangle([-2.0, -2.0], [2.0, 2.0], 0.0, 2.6)] }
    }

    #[test]
    fn a_wall_of_furniture_divides_the_floor() {
        assert_eq!(navigability(&scene(vec![])), Some(1.0));
        assert_eq!(navigability(&ScoredScene { things: vec![], rooms: vec![] }), None);
        // Free are x from -1.9 to -0.1 on one side, and from 1.1 to 1.9 on the other.
        let divided = navigability(&scene(vec![thing("shelf", [0.5, 0.0, 0.0], [1.0, 2.0, 4.0])])).unwrap();
        assert!((divided - 1.8 / 2.6).abs() < 0.01, "{divided}");
        // Nobody walks into what hangs above.
        assert_eq!(navigability(&scene(vec![thing("shelf", [0.5, 2.1, 0.0], [1.0, 0.4, 4.0])])), Some(1.0));
    }

    #[test]
    fn a_door_joins_two_rooms() {
        let mut house = scene(vec![]);
        house.rooms.push(ScoredRoom::rectangle([2.1, -2.0], [6.1, 2.0], 0.0, 2.6));
        let apart = navigability(&house).unwrap();
        assert!((apart - 0.5).abs() < 0.02, "{apart}");
        let mut door = thing("door", [2.05, 0.0, 0.0], [0.1, 2.0, 0.9]);
        // Its front is to the other room.
        door.shape = Shape::new(&Placement {
            pos: Vec3::new(2.05, 0.0, 0.0),
            rot: Vec3::new(0.0, 90.0, 0.0),
            scale: Vec3::new(0.9, 2.0, 0.1),
            parts: Vec::new(),
            surface: None,
            joints: Vec::new(),
        });
        house.things.push(door);
        assert_eq!(navigability(&house), Some(1.0));
    }

    #[test]
    fn what_is_blocked_cannot_be_used() {
        let found = accessibility(
            &scene(vec![
                // Its front is +z, where half of its width is blocked.
                thing("wardrobe", [0.0, 0.0, 0.0], [1.0, 2.0, 0.6]),
                thing("box", [0.5, 0.0, 0.6], [1.0, 0.4, 0.6]),
                // From any side.
                thing("table", [-1.0, 0.0, 1.0], [0.6, 0.7, 0.6]),
                thing("rug", [1.0, 0.0, -1.0], [0.6, 0.01, 0.6]),
                // Nobody steps up to what is on something else.
                thing("vase", [-1.0, 0.7, 1.0], [0.2, 0.3, 0.2]),
            ]),
            &Table::new(),
        );
        let found: Vec<_> = found.iter().map(|(name, share)| (name.as_str(), *share)).collect();
        assert_eq!(found, [("wardrobe", 0.5), ("box", 1.0), ("table", 1.0)]);
    }
}
