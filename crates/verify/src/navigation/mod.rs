//! Walking: where a disc can stand on the floor, from where to where it can move, and how far that is.
//!
//! A disc moves in the union of the regions and of the asserted doors (or, without any region, on the open floor),
//! around the footprints of what reaches into the space above the floor, on one storey. Its centre is therefore free in what remains
//! after everything that blocks has grown by the radius.

mod bottleneck;
mod free;
mod shortest;

pub(crate) use bottleneck::{Blocker, Bottleneck};
pub(crate) use shortest::Path;

use crate::number::Number;
use crate::tolerances::Options;
use crate::world::World;
use bottleneck::Tried;
use free::{Floor, Ground, Obstacle};
use geo::MultiPolygon;
use rustc_hash::FxHashMap;
use scenelang_lang::program::{ObjectId, RegionId};
use scenelang_layout::planar::{depth_in_convex, nearest_on_segment};
use scenelang_layout::{Obb, Prism, Vec2, inside_clearance};
use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering::Relaxed;
use std::sync::{Arc, Mutex, PoisonError};

/// What reaches no higher than this above the floor is stepped over (metres).
const STEP: f64 = 0.05;
/// What begins no lower than this above the floor is walked under (metres).
const HEAD: f64 = 2.0;
/// How near to a footprint is there (metres).
const NEAR: f64 = 0.05;
/// The diameter of the disc that `walkDistance` moves (metres).
pub(crate) const PERSON: f64 = 0.5;

/// Corners of a full circle where only "is there a way" is asked: narrow gaps need it fine.
const FINE: usize = 256;
/// Corners of the polygons around the disc and in it that are tried before, the fewest first: where the one gets through, so
/// does the disc, and where the other does not, neither does the disc. Each in the disc is one of the fine circle's.
const AROUND: [usize; 2] = [8, 24];
const WITHIN: [usize; 2] = [8, 32];
/// Corners of a full circle where the way is measured: 0.2 mm per turn round a corner.
const COARSE: usize = 64;

/// What is known about walking in one instance, each thing found out when it is first asked for.
#[derive(Debug, Default)]
pub(crate) struct Walks {
    known: Mutex<Known>,
    /// Whether there was no way the last time that somebody asked. Where things are tried here and there, there will probably
    /// be none the next time either: that is looked at first then. What is found does not depend on it.
    barred: AtomicBool,
}

/// The bits of the radius of a disc and its corners, its storey, and the bits of the corners of a footprint.
type Beside = (u64, usize, Option<RegionId>, Vec<[u64; 2]>);

/// A storey, and the radius of the widest disc on it.
type Wide = (Option<RegionId>, f64);

#[derive(Clone, Debug, Default)]
struct Known {
    /// Floors by the disc that walks on them.
    floors: Vec<(Walk, Arc<Floor>)>,
    /// The ground by storey and by the widest disc on it.
    grounds: Vec<(Wide, Arc<Tried>)>,
    /// Which pieces of a floor are near a footprint: the same doors are asked for once for each thing.
    near: FxHashMap<Beside, Arc<[usize]>>,
    /// What keeps a disc of a radius from getting from one object to another.
    bottlenecks: Vec<((f64, ObjectId, ObjectId), Option<Bottleneck>)>,
    /// What closes the way where there is none of any width.
    closings: Vec<((f64, ObjectId, ObjectId), Vec<ObjectId>)>,
    /// The outlines of rooms and doors, and the floor made of them.
    whole: Option<(Vec<Vec<Vec2>>, MultiPolygon)>,
}

/// Who walks where.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Walk {
    /// Of the disc (metres).
    radius: f64,
    /// Corners of a full circle.
    corners: usize,
    /// The first region of the storey; `None`: the open floor.
    storey: Option<RegionId>,
}

impl Clone for Walks {
    fn clone(&self) -> Self {
        let barred = AtomicBool::new(self.barred.load(Relaxed));
        Self { known: Mutex::new(self.lock().clone()), barred }
    }
}

impl Walks {
    fn lock(&self) -> std::sync::MutexGuard<'_, Known> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }
    /// Forgets what is not so any more when something has moved.
    pub(crate) fn forget(&mut self) {
        let known = self.known.get_mut().unwrap_or_else(PoisonError::into_inner);
        *known = Known { whole: known.whole.take(), ..Known::default() };
    }
    /// The floor made of rooms and doors.
    fn whole(&self, outlines: Vec<Vec<Vec2>>) -> MultiPolygon {
        if let Some((_, whole)) = self.lock().whole.as_ref().filter(|(of, _)| *of == outlines) {
            return whole.clone();
        }
        let whole = free::whole(&outlines);
        self.lock().whole = Some((outlines, whole.clone()));
        whole
    }
    fn floor<N: Number>(&self, world: &World<N>, walk: Walk) -> Arc<Floor> {
        if let Some((_, floor)) = self.lock().floors.iter().find(|(known, _)| *known == walk) {
            return Arc::clone(floor);
        }
        let ground = ground(world, walk.storey, walk.radius);
        let floor = Arc::new(ground.free(walk.radius, walk.corners, None));
        self.lock().floors.push((walk, Arc::clone(&floor)));
        floor
    }
    /// The pieces of the floor on which a disc that walks there is within `reach` of a footprint.
    fn near(&self, walk: Walk, floor: &Floor, footprint: &[Vec2], reach: f64) -> Arc<[usize]> {
        let outline = footprint.iter().map(|p| [p.x.to_bits(), p.y.to_bits()]).collect();
        let key = (walk.radius.to_bits(), walk.corners, walk.storey, outline);
        if let Some(known) = self.lock().near.get(&key) {
            return Arc::clone(known);
        }
        let found: Arc<[usize]> = floor.pieces_near(footprint, reach, walk.corners).into();
        self.lock().near.insert(key, Arc::clone(&found));
        found
    }
    fn tried<N: Number>(&self, world: &World<N>, storey: Option<RegionId>, radius: f64) -> Arc<Tried> {
        let key = (storey, radius);
        if let Some((_, tried)) = self.lock().grounds.iter().find(|(known, _)| *known == key) {
            return Arc::clone(tried);
        }
        let tried = Arc::new(Tried::new(ground(world, storey, radius)));
        self.lock().grounds.push((key, Arc::clone(&tried)));
        tried
    }
}

/// The radius of the disc that stands for a width: a hair smaller.
fn radius_of<N: Number>(world: &World<N>, width: f64) -> f64 {
    ((width - world.options.tolerances.contact) / 2.0).max(0.0)
}

/// Whether a disc of the given diameter can move from one object to the other.
pub(crate) fn reachable<N: Number>(world: &World<N>, a: &Obb, b: &Obb, width: f64) -> bool {
    let radius = radius_of(world, width);
    let storey = storey(world, a);
    if storey != self::storey(world, b) {
        return false;
    }
    let apothem = |corners: usize| scenelang_layout::rotation::sin_cos(180.0 / corners as f64).1;
    let through = |radius: f64, corners: usize, reach: f64| {
        let walk = Walk { radius, corners, storey };
        let floor = world.walks.floor(world, walk);
        let near = |obb: &Obb| world.walks.near(walk, &floor, &obb.footprint(), reach);
        let from = near(a);
        !from.is_empty() && near(b).iter().any(|piece| from.contains(piece))
    };
    let reach = radius + NEAR;
    let barred = world.walks.barred.load(Relaxed);
    let decided = AROUND.into_iter().zip(WITHIN).find_map(|(around, within)| {
        // Few corners cost little, and nearly always tell.
        let passes = || through(radius / apothem(around), around, reach).then_some(true);
        let fails = || (!through(radius, within, reach / apothem(within))).then_some(false);
        if barred { fails().or_else(passes) } else { passes().or_else(fails) }
    });
    let reached = decided.unwrap_or_else(|| through(radius, FINE, reach));
    world.walks.barred.store(!reached, Relaxed);
    reached
}

/// Why a disc of the given diameter cannot move from one object to the other, which is known. `None`: there is no way
/// of any width, or an object is missing.
pub(crate) fn bottleneck<N: Number>(world: &World<N>, a: ObjectId, b: ObjectId, width: f64) -> Option<Bottleneck> {
    let radius = radius_of(world, width);
    let key = (radius, a, b);
    if let Some((_, known)) = world.walks.lock().bottlenecks.iter().find(|(k, _)| *k == key) {
        return known.clone();
    }
    let found = find_bottleneck(world, a, b, radius);
    world.walks.lock().bottlenecks.push((key, found.clone()));
    found
}

/// The ways on the storey of two objects, and the objects; `None`: they are on different ones, or one is missing.
fn tried_between<N: Number>(
    world: &World<N>,
    a: ObjectId,
    b: ObjectId,
    radius: f64,
) -> Option<(Arc<Tried>, [&Obb; 2])> {
    let both = [&world.object(a).ok()?.body.obb, &world.object(b).ok()?.body.obb];
    let [from, to] = both.map(|obb| storey(world, obb));
    (from == to).then(|| (world.walks.tried(world, from, radius), both))
}

fn find_bottleneck<N: Number>(world: &World<N>, a: ObjectId, b: ObjectId, radius: f64) -> Option<Bottleneck> {
    let (tried, [from, to]) = tried_between(world, a, b, radius)?;
    let ground = &tried.ground;
    let (gap, end) = bottleneck::find(&tried, [&from.footprint(), &to.footprint()], radius)?;
    let bare = gap.between.iter().all(|&i| ground.obstacles[i].object.is_none());
    let door = door_at(world, gap.at).filter(|_| bare);
    let blocker = |i: usize| match (ground.obstacles[gap.between[i]].object, door) {
        (Some(object), _) => Blocker::Object(object),
        (None, Some(door)) => Blocker::Door(door),
        (None, None) => wall_at(world, gap.at[i]),
    };
    let mut sides = [(blocker(0), gap.at[0]), (blocker(1), gap.at[1])];
    // Things are named before walls.
    if sides[1].0 < sides[0].0 {
        sides.swap(0, 1);
    }
    Some(Bottleneck { width: gap.width, between: sides.map(|s| s.0), at: sides.map(|s| s.1), end })
}

/// The objects that close the way from one object to another, where there is none of any width; empty: walls do, or a thing
/// is missing.
pub(crate) fn closing<N: Number>(world: &World<N>, a: ObjectId, b: ObjectId, width: f64) -> Vec<ObjectId> {
    let radius = radius_of(world, width);
    let key = (radius, a, b);
    if let Some((_, known)) = world.walks.lock().closings.iter().find(|(k, _)| *k == key) {
        return known.clone();
    }
    let found = find_closing(world, a, b, radius).unwrap_or_default();
    world.walks.lock().closings.push((key, found.clone()));
    found
}

fn find_closing<N: Number>(world: &World<N>, a: ObjectId, b: ObjectId, radius: f64) -> Option<Vec<ObjectId>> {
    let (tried, [from, to]) = tried_between(world, a, b, radius)?;
    let ground = &tried.ground;
    let found = bottleneck::closing(ground, [&from.footprint(), &to.footprint()], [a, b], radius);
    Some(found.into_iter().filter_map(|i| ground.obstacles[i].object).collect())
}

/// The door in whose opening both points are.
fn door_at<N: Number>(world: &World<N>, at: [Vec2; 2]) -> Option<ObjectId> {
    let mut doors = world.bodies().filter(|(id, _)| is_door(world, *id));
    let holds = |obb: &Obb| at.iter().all(|p| depth_in_convex(&opening(obb, &world.options), *p) >= -1e-6);
    doors.find(|(_, body)| holds(&body.obb)).map(|(id, _)| id)
}

/// The region whose outline is nearest to a point of a wall.
fn wall_at<N: Number>(world: &World<N>, at: Vec2) -> Blocker {
    let distance = |prism: &Prism| {
        let sides = prism.polygon.edges().map(|(a, b)| (nearest_on_segment(&at, &a, &b) - at).norm());
        sides.fold(f64::INFINITY, f64::min)
    };
    let regions = world.prisms().map(|(id, prism)| (distance(prism), id));
    regions.min_by(|a, b| a.0.total_cmp(&b.0)).map_or(Blocker::Edge, |(_, id)| Blocker::Wall(id))
}

/// The shortest way of a person from one object to the other; `None` where there is none.
pub(crate) fn walk<N: Number>(world: &World<N>, a: &Obb, b: &Obb) -> Option<Path> {
    let radius = radius_of(world, PERSON);
    let floor = shared_floor(world, a, b, radius, COARSE)?;
    let places = |obb: &Obb| floor.places(&obb.footprint(), radius + NEAR, COARSE);
    shortest::between(&floor, &places(a), &places(b))
}

/// The floor of both objects; `None`: on different storeys.
fn shared_floor<N: Number>(world: &World<N>, a: &Obb, b: &Obb, radius: f64, corners: usize) -> Option<Arc<Floor>> {
    let storey = storey(world, a);
    (storey == self::storey(world, b)).then(|| world.walks.floor(world, Walk { radius, corners, storey }))
}

fn is_door<N: Number>(world: &World<N>, id: ObjectId) -> bool {
    world.allow.doors.iter().any(|door| door.object == id)
}

/// The ground of a storey, wide enough for discs of up to `radius`.
fn ground<N: Number>(world: &World<N>, storey: Option<RegionId>, radius: f64) -> Ground {
    let here = |obb: &Obb| self::storey(world, obb) == storey;
    let bodies = || world.bodies().map(|(id, body)| (id, &body.obb)).filter(|(_, obb)| here(obb));
    let obstacles = bodies()
        .filter(|(id, obb)| !is_door(world, *id) && stands_in_the_way(world, obb))
        .map(|(id, obb)| Obstacle { object: Some(id), outline: obb.footprint() });
    if storey.is_none() {
        let around: Vec<_> = bodies().map(|(_, obb)| obb.footprint()).collect();
        return Ground::open(&around, obstacles, radius);
    }
    let rooms = world.prisms().filter(|(id, _)| storey_of(world, *id) == storey);
    let rooms: Vec<_> = rooms.map(|(_, prism)| prism.polygon.corners().to_vec()).collect();
    let doors = bodies().filter(|(id, _)| is_door(world, *id)).map(|(_, obb)| opening(obb, &world.options));
    Ground::new(world.walks.whole(rooms.into_iter().chain(doors).collect()), obstacles)
}

/// The obstacle whose outline a disc of a person touches at a place, with the point of it that is touched.
pub(crate) fn touched<N: Number>(world: &World<N>, place: Vec2) -> Option<(ObjectId, Vec2)> {
    let reach = radius_of(world, PERSON) + 1e-6;
    let bodies = world.bodies().filter(|(id, body)| !is_door(world, *id) && stands_in_the_way(world, &body.obb));
    let nearest = |obb: &Obb| {
        let footprint = obb.footprint();
        let points = scenelang_layout::planar::edges(&footprint).map(|(a, b)| nearest_on_segment(&place, &a, &b));
        points.min_by(|p, q| (p - place).norm_squared().total_cmp(&(q - place).norm_squared()))
    };
    let points = bodies.filter_map(|(id, body)| Some((id, nearest(&body.obb)?)));
    points
        .filter(|(_, p)| (p - place).norm() <= reach)
        .min_by(|a, b| (a.1 - place).norm_squared().total_cmp(&(b.1 - place).norm_squared()))
}

/// Where a door lets through: its footprint, longer to front and back by the walls and what a door may be off them.
pub(crate) fn opening(door: &Obb, options: &Options) -> Vec<Vec2> {
    let mut long = *door;
    long.half.z += 2.0 * options.eta + options.tolerances.door;
    long.footprint()
}

/// The region that a box stands in: among those over which its centre is, the one that holds it best or, of several
/// that hold it, the one whose floor is nearest to its base.
fn standing_in<N: Number>(world: &World<N>, obb: &Obb) -> Option<(RegionId, f64)> {
    let base = obb.aabb().min.y;
    let center = Vec2::new(obb.center.x, obb.center.z);
    let fit = |prism: &Prism| (inside_clearance(obb, prism).least() + world.options.tolerances.contact).min(0.0);
    world
        .prisms()
        .filter(|(_, prism)| prism.polygon.contains(center))
        .map(|(id, prism)| ((fit(prism), -(base - prism.floor).abs()), id, prism.floor))
        .max_by(|((a, b), ..), ((c, d), ..)| a.total_cmp(c).then(b.total_cmp(d)))
        .map(|(_, id, floor)| (id, floor))
}

/// Whether a box reaches into the space above the floor that it stands on.
fn stands_in_the_way<N: Number>(world: &World<N>, obb: &Obb) -> bool {
    let span = obb.aabb();
    let floor = standing_in(world, obb).map_or(0.0, |(_, floor)| floor);
    span.min.y < floor + HEAD && span.max.y > floor + STEP
}

/// The storey of a box, by its first region: that of the region it stands in or, in none (a door in a wall), of the
/// nearest one. `None` without any region.
fn storey<N: Number>(world: &World<N>, obb: &Obb) -> Option<RegionId> {
    let best = || {
        let fit = |prism: &Prism| inside_clearance(obb, prism).least();
        world.prisms().map(|(id, prism)| (fit(prism), id)).max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, id)| id)
    };
    storey_of(world, standing_in(world, obb).map(|(id, _)| id).or_else(best)?)
}

/// Regions share a storey when their heights overlap, or when a third one's do with both.
fn storey_of<N: Number>(world: &World<N>, region: RegionId) -> Option<RegionId> {
    let spans: Vec<(RegionId, f64, f64)> = world.prisms().map(|(id, p)| (id, p.floor, p.ceiling)).collect();
    let (_, mut low, mut high) = *spans.iter().find(|(id, ..)| *id == region)?;
    loop {
        let contact = world.options.tolerances.contact;
        let meets = |floor: f64, ceiling: f64| floor < high - contact && ceiling > low + contact;
        let same = || spans.iter().filter(|(_, floor, ceiling)| meets(*floor, *ceiling));
        let lowest = same().map(|s| s.1).fold(low, f64::min);
        let highest = same().map(|s| s.2).fold(high, f64::max);
        if (lowest, highest) == (low, high) {
            return same().map(|s| s.0).min();
        }
        (low, high) = (lowest, highest);
    }
}
