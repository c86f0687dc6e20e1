//! A layout whose things move. A pose is written in one place, which notes what was there before: so every move can be
//! taken back, to the last digit.

use crate::pose::Pose;
use scenelang_lang::program::{ObjectId, RegionId, VariableId};
use scenelang_layout::Aabb;
use scenelang_verify::{Cause, Value, World};

/// A thing as it was.
#[derive(Clone, Copy, Debug)]
enum Before {
    Object(ObjectId, Pose),
    Region(RegionId, Pose),
    Variable(VariableId, Result<Value<f64>, Cause>),
}

#[derive(Debug)]
pub struct State {
    world: World<f64>,
    /// What has changed since the last [`State::keep`], each object once, in the order of its first change.
    journal: Vec<Before>,
    /// By object: whether the journal has it.
    has_moved: Vec<bool>,
    /// Counts changes, for those who follow: see [`Mirror`](crate::Mirror).
    pub(crate) clock: u64,
    /// By object: when it was last moved.
    pub(crate) moved_at: Vec<u64>,
    /// When a region or a decision variable was last changed.
    pub(crate) changed_at: u64,
}

impl State {
    /// With everything where an instance has it.
    pub fn new(world: World<f64>) -> Self {
        let objects = world.bodies().map(|(id, _)| id.0 as usize + 1).max().unwrap_or(0);
        let (has_moved, moved_at) = (vec![false; objects], vec![0; objects]);
        Self { world, journal: Vec::new(), has_moved, clock: 0, moved_at, changed_at: 0 }
    }

    /// The layout as it is now.
    pub fn world(&self) -> &World<f64> {
        &self.world
    }

    /// Where an object is, unless the layout lacks it.
    pub fn pose(&self, id: ObjectId) -> Option<Pose> {
        self.world.object(id).ok().map(Pose::of)
    }

    /// The box around an object, unless the layout lacks it.
    pub fn bounds(&self, id: ObjectId) -> Option<Aabb> {
        self.world.object(id).ok().map(|thing| thing.body.aabb())
    }

    /// Objects other than one that are no further than this from one of these boxes (metres).
    pub fn near(&self, id: ObjectId, boxes: &[Aabb], reach: f64) -> Vec<ObjectId> {
        let is_near = |theirs: &Aabb| boxes.iter().any(|own| own.distance(theirs) <= reach);
        let others = self.world.bodies().filter(|(other, body)| *other != id && is_near(&body.aabb()));
        others.map(|(other, _)| other).collect()
    }

    /// Where a region is, unless the layout lacks it.
    pub fn region_pose(&self, id: RegionId) -> Option<Pose> {
        let room = self.world.region(id).ok()?;
        Some(Pose { pos: room.pos.value(), rot: room.rot.value(), scale: room.scale.value() })
    }

    /// Objects that have been moved since the last [`State::keep`], with where they were, in the order of their first moves.
    pub fn moved(&self) -> impl Iterator<Item = (ObjectId, Pose)> + '_ {
        self.journal.iter().filter_map(|before| match before {
            Before::Object(id, pose) => Some((*id, *pose)),
            _ => None,
        })
    }

    /// Where an object was at the last [`State::keep`].
    pub fn home(&self, id: ObjectId) -> Option<Pose> {
        if !self.has_moved.get(id.0 as usize).copied().unwrap_or(false) {
            return self.pose(id);
        }
        self.moved().find(|(moved, _)| *moved == id).map(|(_, pose)| pose)
    }

    /// Puts an object somewhere. Does nothing for one that the layout lacks.
    pub fn set_pose(&mut self, id: ObjectId, pose: &Pose) {
        let Some(old) = self.pose(id) else { return };
        if !std::mem::replace(&mut self.has_moved[id.0 as usize], true) {
            self.journal.push(Before::Object(id, old));
        }
        self.put(id, pose);
    }

    /// The same, of a region.
    pub fn set_region(&mut self, id: RegionId, pose: &Pose) {
        let Some(old) = self.region_pose(id) else { return };
        self.journal.push(Before::Region(id, old));
        self.put_region(id, pose);
    }

    /// Gives a decision variable a value of its kind.
    pub fn set_variable(&mut self, id: VariableId, value: Value<f64>) {
        self.journal.push(Before::Variable(id, self.world.variable(id)));
        self.put_variable(id, Ok(value));
    }

    /// From here on things are where they belong.
    pub fn keep(&mut self) {
        let Self { journal, has_moved, .. } = self;
        for before in journal.drain(..) {
            if let Before::Object(id, _) = before {
                has_moved[id.0 as usize] = false;
            }
        }
    }

    /// Puts everything back to where it was at the last [`State::keep`].
    pub fn undo(&mut self) {
        while let Some(before) = self.journal.pop() {
            match before {
                Before::Object(id, pose) => {
                    self.has_moved[id.0 as usize] = false;
                    self.put(id, &pose);
                }
                Before::Region(id, pose) => self.put_region(id, &pose),
                Before::Variable(id, value) => self.put_variable(id, value),
            }
        }
    }

    fn put(&mut self, id: ObjectId, pose: &Pose) {
        let [pos, rot, scale] = pose.constant();
        self.world.place(id, pos, rot, scale);
        self.clock += 1;
        self.moved_at[id.0 as usize] = self.clock;
    }

    fn put_region(&mut self, id: RegionId, pose: &Pose) {
        let [pos, rot, scale] = pose.constant();
        self.world.place_region(id, pos, rot, scale);
        self.clock += 1;
        self.changed_at = self.clock;
    }

    fn put_variable(&mut self, id: VariableId, value: Result<Value<f64>, Cause>) {
        match value {
            Ok(value) => self.world.set_variable(id, value),
            Err(cause) => self.world.refuse_variable(id, cause),
        }
        self.clock += 1;
        self.changed_at = self.clock;
    }
}
