//! Where things can be: the floors, the ceilings and the tops of other things, with how likely each is tried. The density of
//! what is tried is known, so that the chain can take it out again.

use crate::dice::Dice;
use scenelang_engine::Pose;
use scenelang_engine::candidate::Candidate;
use scenelang_engine::frame::{Frame, Hold};
use scenelang_lang::program::{ObjectId, RegionId};
use scenelang_layout::{Vec2, Vec3, rotation};
use scenelang_verify::World;

/// Tops that are nearer to each other than this (metres) are one.
const LEVEL: f64 = 1e-3;
/// No more tops than this are looked at of one thing.
const LEVELS: usize = 12;
/// How much likelier a thing is tried on what constraints tie it to than on anything else.
const RELATED: f64 = 12.0;
/// The part of tries on the floors of the rooms that constraints name for a thing, where they name any.
const NAMED: f64 = 0.8;

/// What a thing can be put on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum On {
    /// The floor of a region, its ceiling, or the air between, as the thing is held.
    Room(usize),
    /// A top of another thing.
    Top(ObjectId),
    /// The inside of what contains it, at the height that it has.
    Inside(ObjectId),
}

/// A place with its part of the tries.
#[derive(Clone, Copy, Debug)]
struct Slot {
    on: On,
    share: f64,
}

/// The rectangle around a region.
#[derive(Clone, Copy, Debug)]
struct FloorBox {
    id: RegionId,
    min: Vec2,
    max: Vec2,
    floor: f64,
    ceiling: f64,
}

impl FloorBox {
    fn area(&self) -> f64 {
        (self.max.x - self.min.x) * (self.max.y - self.min.y)
    }
    /// The highest base of a thing under its ceiling.
    fn highest(&self, pose: &Pose) -> f64 {
        (self.ceiling - pose.scale.y).max(self.floor + LEVEL)
    }
    fn holds(&self, pos: &Vec3) -> bool {
        (self.min.x..=self.max.x).contains(&pos.x) && (self.min.y..=self.max.y).contains(&pos.z)
    }
}

/// See the file. Nothing in it changes with the layout.
pub struct Places {
    rooms: Vec<FloorBox>,
    /// By object: heights of its tops above its base, lowest first.
    levels: Vec<Vec<f64>>,
    slots: Vec<Vec<Slot>>,
    /// Heights that differ by less are the same.
    tolerance: f64,
}

impl Places {
    /// Of a program, with rooms and things as large as an instance has them.
    pub fn new(frame: &Frame<'_>, world: &World<f64>) -> Self {
        let rooms = world.prisms().map(|(id, prism)| {
            let corners = prism.polygon.corners();
            let least = corners.iter().fold(Vec2::repeat(f64::INFINITY), |a, b| a.inf(b));
            let most = corners.iter().fold(Vec2::repeat(f64::NEG_INFINITY), |a, b| a.sup(b));
            FloorBox { id, min: least, max: most, floor: prism.floor, ceiling: prism.ceiling }
        });
        let levels = frame.objects().map(|id| tops(world, id)).collect();
        let tolerance = world.options.tolerances.support.max(LEVEL);
        let mut places = Self { rooms: rooms.collect(), levels, slots: Vec::new(), tolerance };
        places.slots = frame.objects().map(|id| places.slots(frame, id)).collect();
        places
    }

    fn slots(&self, frame: &Frame<'_>, id: ObjectId) -> Vec<Slot> {
        if let Hold::Container(container) = frame.hold(id) {
            return vec![Slot { on: On::Inside(container), share: 1.0 }];
        }
        let area = |named: bool| {
            let counts = |room: &&FloorBox| !named || frame.regions[id.0 as usize].contains(&room.id);
            self.rooms.iter().filter(counts).map(FloorBox::area).sum::<f64>()
        };
        let (named, all) = (area(true), area(false));
        let is_named = |room: &FloorBox| frame.regions[id.0 as usize].contains(&room.id);
        let part = if named > 0.0 { NAMED } else { 0.0 };
        let of_room = |(i, room): (usize, &FloorBox)| {
            let among = if part > 0.0 && is_named(room) { part / named } else { 0.0 };
            Slot { on: On::Room(i), share: room.area() * (among + (1.0 - part) / all) }
        };
        let mut slots: Vec<Slot> = self.rooms.iter().enumerate().map(of_room).collect();
        if frame.hold(id) != Hold::Rests {
            return slots;
        }
        let others = frame.objects().filter(|other| *other != id && !self.levels[other.0 as usize].is_empty());
        let weight = |other: ObjectId| {
            let related = frame.related[id.0 as usize].iter().any(|(near, _)| *near == other);
            if related { RELATED } else { 1.0 }
        };
        let tops: Vec<(ObjectId, f64)> = others.map(|other| (other, weight(other))).collect();
        let total: f64 = tops.iter().map(|(_, weight)| weight).sum();
        if total > 0.0 {
            slots.iter_mut().for_each(|slot| slot.share /= 2.0);
            slots.extend(tops.iter().map(|(other, w)| Slot { on: On::Top(*other), share: w / total / 2.0 }));
        }
        slots
    }

    /// A place for a thing that is turned as `pose` is; `None` where the place drawn is on one of `group`, which moves along,
    /// or there is none.
    pub fn draw(
        &self,
        state: &Candidate<'_>,
        id: ObjectId,
        pose: &Pose,
        group: &[ObjectId],
        dice: &mut Dice,
    ) -> Option<Pose> {
        let slots = &self.slots[id.0 as usize];
        let slot = slots.get(dice.pick(slots.iter().map(|slot| slot.share)))?;
        match slot.on {
            On::Top(other) | On::Inside(other) if group.contains(&other) => None,
            on => self.put(&|other| state.pose(other), state.frame.hold(id), pose, on, dice),
        }
    }

    /// What to put a thing on, so that [`Self::put`] then comes to all its places alike.
    pub fn uniform(
        &self,
        poses: &dyn Fn(ObjectId) -> Pose,
        hold: Hold,
        id: ObjectId,
        pose: &Pose,
        dice: &mut Dice,
    ) -> Option<On> {
        let slots = &self.slots[id.0 as usize];
        let sizes: Vec<f64> = slots.iter().map(|slot| self.size(poses, hold, pose, slot.on)).collect();
        slots.get(dice.pick(sizes.iter().copied())).map(|slot| slot.on)
    }

    /// Somewhere on something. `poses` says where that is.
    pub fn put(
        &self,
        poses: &dyn Fn(ObjectId) -> Pose,
        hold: Hold,
        pose: &Pose,
        on: On,
        dice: &mut Dice,
    ) -> Option<Pose> {
        match on {
            On::Room(i) => {
                let room = &self.rooms[i];
                let (x, z) = (dice.between(room.min.x, room.max.x), dice.between(room.min.y, room.max.y));
                let y = match hold {
                    Hold::Floats => dice.between(room.floor, room.highest(pose)),
                    Hold::Ceiling(_) => room.ceiling - pose.scale.y,
                    _ => room.floor + pose.depth_below(),
                };
                Some(pose.at(x, y, z))
            }
            On::Top(other) => {
                let carrier = poses(other);
                let at = within(&carrier, dice);
                let levels = &self.levels[other.0 as usize];
                let level = levels.get(dice.below(levels.len()))?;
                Some(pose.at(at.x, carrier.pos.y + level + pose.depth_below(), at.z))
            }
            On::Inside(other) => {
                let at = within(&poses(other), dice);
                Some(pose.at(at.x, pose.pos.y, at.z))
            }
        }
    }

    /// How many places something has: square metres times heights (cubic metres, of what floats).
    fn size(&self, poses: &dyn Fn(ObjectId) -> Pose, hold: Hold, pose: &Pose, on: On) -> f64 {
        match on {
            On::Room(i) if hold == Hold::Floats => {
                self.rooms[i].area() * (self.rooms[i].highest(pose) - self.rooms[i].floor)
            }
            On::Room(i) => self.rooms[i].area(),
            On::Top(other) | On::Inside(other) => {
                let scale = poses(other).scale;
                let levels = if on == On::Top(other) { self.levels[other.0 as usize].len() } else { 1 };
                scale.x * scale.z * levels as f64
            }
        }
    }

    /// Whether a pose is one of those that [`Self::put`] comes to.
    fn is_on(&self, state: &Candidate<'_>, id: ObjectId, pose: &Pose, on: On) -> bool {
        let free = !state.frame.fixed(id).pos[1];
        let is_at = |height: f64| !free || (pose.pos.y - pose.depth_below() - height).abs() <= self.tolerance;
        match on {
            On::Room(i) => {
                let room = &self.rooms[i];
                room.holds(&pose.pos)
                    && match state.frame.hold(id) {
                        Hold::Floats => !free || (room.floor..=room.highest(pose)).contains(&pose.pos.y),
                        Hold::Ceiling(_) => true,
                        _ => is_at(room.floor),
                    }
            }
            On::Top(other) | On::Inside(other) => {
                let carrier = state.pose(other);
                let local = rotation::matrix(carrier.rot).tr_mul(&(pose.pos - carrier.pos));
                let is_over = 2.0 * local.x.abs() <= carrier.scale.x && 2.0 * local.z.abs() <= carrier.scale.z;
                let mut levels = self.levels[other.0 as usize].iter();
                is_over && (on == On::Inside(other) || levels.any(|level| is_at(carrier.pos.y + level)))
            }
        }
    }

    /// How likely [`Self::draw`] comes to a pose, per square metre (cubic, of what floats); 0 where it cannot.
    pub fn density(&self, state: &Candidate<'_>, id: ObjectId, pose: &Pose, group: &[ObjectId]) -> f64 {
        let moves_along = |on: On| matches!(on, On::Top(other) | On::Inside(other) if group.contains(&other));
        let slots = self.slots[id.0 as usize].iter().filter(|slot| !moves_along(slot.on));
        let size = |on: On| self.size(&|other| state.pose(other), state.frame.hold(id), pose, on);
        slots.filter(|slot| self.is_on(state, id, pose, slot.on)).map(|slot| slot.share / size(slot.on)).sum()
    }

    /// In how many ways a thing can have come to be where it is.
    pub fn ways_to(&self, state: &Candidate<'_>, id: ObjectId) -> usize {
        let pose = state.pose(id);
        self.slots[id.0 as usize].iter().filter(|slot| self.is_on(state, id, &pose, slot.on)).count()
    }

    /// The floor and the highest base of a thing in the room where it is; `None`: it is in none.
    pub fn heights(&self, pose: &Pose) -> Option<[f64; 2]> {
        let room = self.rooms.iter().find(|room| room.holds(&pose.pos) && pose.pos.y < room.ceiling)?;
        Some([room.floor, room.highest(pose)])
    }

    /// The longest way within any room (metres).
    pub fn diameter(&self) -> f64 {
        self.rooms.iter().map(|room| (room.max - room.min).norm()).fold(1.0, f64::max)
    }
}

/// A point in the rectangle of a thing.
fn within(carrier: &Pose, dice: &mut Dice) -> Vec3 {
    let [x, z] = [carrier.scale.x, carrier.scale.z].map(|far| dice.between(-far / 2.0, far / 2.0));
    carrier.pos + rotation::matrix(carrier.rot) * Vec3::new(x, 0.0, z)
}

/// Heights of the tops of a thing above its base.
fn tops(world: &World<f64>, id: ObjectId) -> Vec<f64> {
    let Ok(thing) = world.object(id) else { return Vec::new() };
    let base = thing.pos.value().y;
    let mut levels: Vec<f64> = thing.body.solid().iter().map(|part| part.aabb().max.y - base).collect();
    levels.sort_by(f64::total_cmp);
    levels.dedup_by(|a, b| (*a - *b).abs() < LEVEL);
    // Of more than that, the upper ones: things are put on top.
    levels.split_off(levels.len().saturating_sub(LEVELS))
}
