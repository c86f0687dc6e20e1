//! A layout in other numbers, or for another purpose, that follows one which moves: what moved is noted, and taken over
//! when somebody looks.

use crate::pose::Pose;
use scenelang_lang::program::ObjectId;
use scenelang_verify::vector::V3;
use scenelang_verify::{Number, World};

/// See the file.
#[derive(Debug)]
pub struct Mirror<N: Number> {
    world: World<N>,
    /// Objects that moved since, each once.
    stale: Vec<ObjectId>,
    is_stale: Vec<bool>,
}

impl<N: Number> Mirror<N> {
    /// Of an instance as it is.
    pub fn new(world: World<N>) -> Self {
        let objects = world.bodies().map(|(id, _)| id.0 as usize + 1).max().unwrap_or(0);
        Self { world, stale: Vec::new(), is_stale: vec![false; objects] }
    }

    /// The instance, as it was when somebody last looked.
    pub fn world(&self) -> &World<N> {
        &self.world
    }

    /// An object has moved.
    pub fn moved(&mut self, id: ObjectId) {
        if self.is_stale.get_mut(id.0 as usize).is_some_and(|stale| !std::mem::replace(stale, true)) {
            self.stale.push(id);
        }
    }

    /// Takes over what has moved; `pose` says where it is now.
    pub fn follow(&mut self, pose: impl Fn(ObjectId) -> Option<Pose>) -> &World<N> {
        while let Some(id) = self.stale.pop() {
            self.is_stale[id.0 as usize] = false;
            if let Some(pose) = pose(id) {
                let [pos, rot, scale] = pose.constant();
                self.world.place(id, pos, rot, scale);
            }
        }
        &self.world
    }

    /// Puts an object somewhere for one look: the next one finds it where it belongs.
    pub fn set(&mut self, id: ObjectId, [pos, rot, scale]: [V3<N>; 3]) {
        self.world.place(id, pos, rot, scale);
        self.moved(id);
    }
}
