//! Candidate poses for one object, from geometry alone: along walls, in corners, beside what it has to do with and
//! facing it, on top of things, under the ceiling, in walls, anywhere.
//!
//! No predicate is named here: candidates are guesses that the evaluator judges, and the polish makes exact.

mod beside;
mod room;
mod tops;

use crate::problem::frame::Hold;
use crate::problem::pose::{Pose, round_turn, yaw_towards};
use crate::search::chance::Chance;
use crate::search::state::State;
use rand_chacha::ChaCha8Rng;
use scenelang_lang::program::{ObjectId, RegionId};
use scenelang_layout::{Prism, Vec2, Vec3};

/// What stands along a wall keeps so far from it (metres): a skirting board.
const SKIRTING: f64 = 0.01;

/// How many siblings are looked at.
const SIBLINGS: usize = 6;

/// Gathers candidates for one object.
struct Pool<'s, 'a> {
    state: &'s State<'a>,
    id: ObjectId,
    /// Where it is now, with its pinned properties.
    now: Pose,
    /// Whether its yaw is free.
    turns: bool,
    chance: &'s mut ChaCha8Rng,
    out: Vec<Pose>,
}

/// Candidates for an object; pinned properties are as they are. Never empty.
pub(crate) fn candidates(state: &mut State<'_>, id: ObjectId, chance: &mut ChaCha8Rng) -> Vec<Pose> {
    let fixed = state.frame.fixed(id);
    let now = if state.is_placed(id) { state.pose(id) } else { state.home(id) };
    let mut pool = Pool { state, id, now, turns: !fixed.rot, chance, out: Vec::new() };
    if fixed.pos == [true; 3] {
        pool.on_the_spot();
    } else {
        pool.elsewhere();
    }
    if pool.out.is_empty() {
        pool.out.push(now);
    }
    pool.out
}

impl Pool<'_, '_> {
    /// Other objects that it has to do with and that have a place, closest relations first.
    fn related(&self) -> Vec<ObjectId> {
        let related = self.state.frame.related[self.id.0 as usize].iter().map(|(o, _)| *o);
        related.filter(|o| self.state.is_placed(*o)).collect()
    }

    /// Regions that it may belong to: those that its own terms name, else all.
    fn regions(&self) -> Vec<RegionId> {
        let named = &self.state.frame.regions[self.id.0 as usize];
        if named.is_empty() { self.state.world().prisms().map(|(id, _)| id).collect() } else { named.clone() }
    }

    fn prism(&self, id: RegionId) -> Option<&Prism> {
        self.state.world().region(id).ok().map(|room| &room.prism)
    }

    /// Yaws to try: quarter turns of a direction, or the one that is fixed.
    fn yaws(&self, base: f64) -> Vec<f64> {
        if self.turns { (0..4).map(|i| round_turn(base + 90.0 * f64::from(i))).collect() } else { vec![self.now.rot.y] }
    }

    /// The turn of a region's sides.
    fn room_yaw(&self, id: RegionId) -> f64 {
        let room = self.state.world().region(id).ok();
        room.map_or(0.0, |r| {
            let corners = r.prism.polygon.corners();
            let side = corners[1] - corners[0];
            yaw_towards(&Vec3::new(side.x, 0.0, side.y)).rem_euclid(90.0)
        })
    }

    /// The height at which it stands on the floor at a place.
    fn on_floor(&self, pose: &Pose) -> f64 {
        let here = Vec2::new(pose.pos.x, pose.pos.z);
        let floors = self.state.world().prisms().filter(|(_, p)| p.polygon.contains(here));
        floors
            .map(|(_, p)| p.floor)
            .fold(None, |best: Option<f64>, f| Some(best.map_or(f, |b| b.max(f))))
            .unwrap_or(0.0)
            + pose.depth_below()
    }

    /// Adds a pose that stands on the floor.
    fn push_standing(&mut self, pose: Pose) {
        let y = self.on_floor(&pose);
        self.out.push(pose.at(pose.pos.x, y, pose.pos.z));
    }

    /// Only the yaw is free, or nothing.
    fn on_the_spot(&mut self) {
        self.out.push(self.now);
        if self.turns {
            for i in 0..8 {
                self.out.push(self.now.facing(self.now.rot.y + 45.0 * f64::from(i)));
            }
            for other in self.related() {
                let way = self.state.pose(other).center() - self.now.center();
                let yaws = self.yaws(self.state.pose(other).rot.y);
                self.out.extend(yaws.into_iter().map(|yaw| self.now.facing(yaw)));
                self.out.push(self.now.facing(yaw_towards(&way)));
            }
        }
    }

    fn elsewhere(&mut self) {
        match self.state.frame.hold(self.id) {
            Hold::Door(first, second) => self.in_wall(first, second),
            Hold::Wall(region) => self.on_wall(region),
            Hold::Ceiling(region) => self.under_ceiling(region),
            Hold::Container(container) => self.within(container),
            Hold::Rests => {
                self.like_siblings();
                self.around_the_room();
                self.by_the_others();
                self.on_the_others();
                self.among_neighbours();
            }
            Hold::Floats => {
                self.around_the_room();
                self.by_the_others();
                self.on_the_others();
                self.afloat();
            }
        }
    }

    /// As its siblings stand to what they belong to.
    fn like_siblings(&mut self) {
        let now = self.now;
        let mut alike: Vec<Pose> = self.state.as_siblings(self.id);
        alike.truncate(SIBLINGS);
        self.out.extend(alike.into_iter().map(|p| Pose { scale: now.scale, ..p }));
    }

    /// The same place with other heights.
    fn afloat(&mut self) {
        let mut heights = vec![1.0, 1.8];
        for other in self.related() {
            let span = self.state.span(other);
            heights.extend([span.max.y + 0.02, span.max.y + 0.5, span.min.y, span.min.y - self.now.scale.y - 0.02]);
        }
        for region in self.regions() {
            heights.extend(self.prism(region).map(|p| p.ceiling - self.now.scale.y));
        }
        let low = self.out.clone();
        for pose in low {
            let height = heights[self.chance.below(heights.len())];
            self.out.push(pose.at(pose.pos.x, height, pose.pos.z));
        }
    }
}
