//! A layout in other numbers, or for another purpose, that follows one which moves: what has changed is taken over when
//! somebody looks. In between things can be put elsewhere in it, to see what would be.

use crate::{Pose, State};
use scenelang_lang::program::{ObjectId, RegionId, VariableId};
use scenelang_verify::vector::V3;
use scenelang_verify::{Number, Value, World};

#[derive(Debug)]
pub struct Mirror<N: Number> {
    world: World<N>,
    /// Objects that may be elsewhere than they belong, each once.
    stale: Vec<ObjectId>,
    is_stale: Vec<bool>,
    /// The same of regions and decision variables.
    others_stale: bool,
    /// The time of the last look, by the clock of what it follows.
    seen: u64,
}

impl<N: Number> Mirror<N> {
    /// Of an instance as it is. Who moves things says so with [`Mirror::moved`].
    pub fn new(world: World<N>) -> Self {
        let objects = world.bodies().map(|(id, _)| id.0 as usize + 1).max().unwrap_or(0);
        Self { world, stale: Vec::new(), is_stale: vec![false; objects], others_stale: false, seen: 0 }
    }

    /// Of a state; it is brought up to date by [`Mirror::catch_up`].
    pub fn of(state: &State) -> Self {
        Self { seen: state.clock, ..Self::new(state.world().constant()) }
    }

    /// The instance, as it was when somebody last looked.
    pub fn world(&self) -> &World<N> {
        &self.world
    }

    pub fn moved(&mut self, id: ObjectId) {
        if self.is_stale.get_mut(id.0 as usize).is_some_and(|stale| !std::mem::replace(stale, true)) {
            self.stale.push(id);
        }
    }

    /// Takes over what has moved; `pose` says where it is now.
    pub fn follow(&mut self, pose: impl Fn(ObjectId) -> Option<Pose>) {
        while let Some(id) = self.stale.pop() {
            self.is_stale[id.0 as usize] = false;
            if let Some(pose) = pose(id) {
                let [pos, rot, scale] = pose.constant();
                self.world.place(id, pos, rot, scale);
            }
        }
    }

    /// Takes over what has changed in the state that it follows.
    pub fn catch_up(&mut self, state: &State) {
        let seen = std::mem::replace(&mut self.seen, state.clock);
        if seen < state.clock {
            for (i, _) in state.moved_at.iter().enumerate().filter(|(_, at)| **at > seen) {
                self.moved(ObjectId(i as u32));
            }
        }
        self.follow(|id| state.pose(id));
        if std::mem::take(&mut self.others_stale) || seen < state.changed_at {
            for (id, _) in state.world().prisms() {
                if let Some(pose) = state.region_pose(id) {
                    let [pos, rot, scale] = pose.constant();
                    self.world.place_region(id, pos, rot, scale);
                }
            }
            for (id, value) in state.world().values() {
                self.world.set_variable(id, value.constant());
            }
        }
    }

    /// Puts an object somewhere for one look: after the next it is where it belongs.
    pub fn set(&mut self, id: ObjectId, [pos, rot, scale]: [V3<N>; 3]) {
        self.world.place(id, pos, rot, scale);
        self.moved(id);
    }

    /// The same of a region.
    pub fn set_region(&mut self, id: RegionId, [pos, rot, scale]: [V3<N>; 3]) {
        self.world.place_region(id, pos, rot, scale);
        self.others_stale = true;
    }

    /// The same of a decision variable.
    pub fn set_variable(&mut self, id: VariableId, value: Value<N>) {
        self.world.set_variable(id, value);
        self.others_stale = true;
    }
}
