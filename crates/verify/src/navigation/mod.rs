//! Walking: where a disc can stand on the floor, from where to where it can move, and how far that is.
//!
//! A disc moves in the union of the regions and of the asserted doors (or, without any region, on the open floor),
//! around the footprints of what reaches into the space above the floor. Its centre is therefore free in what remains
//! after everything that blocks has grown by the radius.

mod free;
mod shortest;

use crate::number::Number;
use crate::world::World;
use free::Floor;
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Obb, inside_clearance};
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
/// Corners of a full circle where the way is measured: 0.2 mm per turn round a corner.
const COARSE: usize = 64;

/// Floors of one instance by the disc that walks on them, each made when it is first asked for.
#[derive(Debug, Default)]
pub(crate) struct Walks(Mutex<Vec<Walk>>);

/// Radius and corners of the disc, and its floor.
type Walk = ((f64, usize), Arc<Floor>);

impl Clone for Walks {
    fn clone(&self) -> Self {
        Self(Mutex::new(self.lock().clone()))
    }
}

impl Walks {
    fn lock(&self) -> std::sync::MutexGuard<'_, Vec<Walk>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
    fn floor<N: Number>(&self, world: &World<N>, radius: f64, corners: usize) -> Arc<Floor> {
        let key = (radius, corners);
        if let Some((_, floor)) = self.lock().iter().find(|(k, _)| *k == key) {
            return Arc::clone(floor);
        }
        let floor = Arc::new(make(world, radius, corners));
        self.lock().push((key, Arc::clone(&floor)));
        floor
    }
}

/// Whether a disc of the given diameter can move from one object to the other.
pub(crate) fn reachable<N: Number>(world: &World<N>, a: &Obb, b: &Obb, width: f64) -> bool {
    let radius = ((width - world.options.tolerances.contact) / 2.0).max(0.0);
    let floor = world.walks.floor(world, radius, FINE);
    let [from, to] = [a, b].map(|obb| floor.places(&obb.footprint(), radius + NEAR, FINE));
    from.iter().zip(&to).any(|(x, y)| !x.0.is_empty() && !y.0.is_empty())
}

/// The length of the shortest way of a person from one object to the other (metres); infinite where there is none.
pub(crate) fn walk<N: Number>(world: &World<N>, a: &Obb, b: &Obb) -> f64 {
    let radius = (PERSON - world.options.tolerances.contact) / 2.0;
    let floor = world.walks.floor(world, radius, COARSE);
    let [from, to] = [a, b].map(|obb| floor.places(&obb.footprint(), radius + NEAR, COARSE));
    shortest::between(&floor, &from, &to)
}

fn make<N: Number>(world: &World<N>, radius: f64, corners: usize) -> Floor {
    let is_door = |id: ObjectId| world.allow.doors.iter().any(|door| door.object == id);
    let bodies = || world.bodies().map(|(id, body)| (id, &body.obb));
    let obstacles: Vec<_> = bodies()
        .filter(|(id, obb)| !is_door(*id) && stands_in_the_way(world, obb))
        .map(|(_, obb)| obb.footprint())
        .collect();
    let rooms: Vec<_> = world.prisms().map(|(_, prism)| prism.polygon.corners().to_vec()).collect();
    if world.regions.is_empty() {
        let around = bodies().map(|(_, obb)| obb.footprint()).collect::<Vec<_>>();
        return Floor::open(&around, &obstacles, radius, corners);
    }
    let through = 2.0 * world.options.eta + world.options.tolerances.door;
    let doors = bodies().filter(|(id, _)| is_door(*id)).map(|(_, obb)| {
        let mut long = *obb;
        long.half.z += through;
        long.footprint()
    });
    Floor::new(rooms.into_iter().chain(doors), &obstacles, radius, corners)
}

/// Whether a box reaches into the space above the floor that it stands on.
fn stands_in_the_way<N: Number>(world: &World<N>, obb: &Obb) -> bool {
    let span = obb.aabb();
    let center = scenelang_layout::Vec2::new(obb.center.x, obb.center.z);
    let floor = world
        .prisms()
        .filter(|(_, prism)| prism.polygon.contains(center))
        .map(|(_, prism)| (inside_clearance(obb, prism).least(), prism.floor))
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map_or(0.0, |(_, floor)| floor);
    span.min.y < floor + HEAD && span.max.y > floor + STEP
}
