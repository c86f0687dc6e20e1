//! Physical rules, one file each, and which objects and pairs each of them speaks of.
//!
//! A rule gives a margin per object or pair, cheap enough for a solver to ask again and again; the whole judgement of
//! an instance is in `check`.

pub mod bounds;
pub mod collide;
mod near;
pub mod open;
pub mod support;

pub use near::{Columns, Near, pairs_up_to, pairs_within};

use crate::number::Number;
use crate::world::World;
use rustc_hash::FxHashSet;
use scenelang_lang::overlaps::Overlaps;
use scenelang_lang::program::{Allowances, Mount, ObjectId};
use std::sync::Arc;

/// Which physical rules apply to what, by the statements of the program and by which containers are solid boxes.
#[derive(Clone, Debug, Default)]
pub struct Scope {
    /// Pairs that may overlap by a statement.
    allowed: Arc<Overlaps>,
    /// Pairs of contents and containers, smaller id first.
    may_overlap: FxHashSet<(ObjectId, ObjectId)>,
    outside: FxHashSet<ObjectId>,
    float: FxHashSet<ObjectId>,
    /// Objects that a container without parts holds.
    held: FxHashSet<ObjectId>,
    /// Objects in a wall or on a ceiling; doors in walls.
    mounted: FxHashSet<ObjectId>,
    doors: FxHashSet<ObjectId>,
}

/// What P-SUPPORT asks of an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Support {
    /// Nothing: it may float, or is a door.
    Lifted,
    /// It is held by the container that it is in.
    Held,
    /// It touches the wall or the ceiling that it is mounted on.
    Mounted,
    /// It rests on something.
    Rests,
}

impl Scope {
    /// The scope of the rules in an instance.
    pub fn new<N: Number>(world: &World<N>) -> Self {
        let allow = &world.allow;
        let pair = |a: ObjectId, b: ObjectId| (a.min(b), a.max(b));
        let mut may_overlap = FxHashSet::default();
        let mut held = FxHashSet::default();
        for &(content, container) in hollow(world).iter() {
            held.insert(content);
            may_overlap.insert(pair(content, container));
        }
        for (content, container) in nested(&hollow(world)) {
            may_overlap.insert(pair(content, container));
        }
        Self {
            allowed: allow.collide.clone(),
            may_overlap,
            outside: allow.outside.iter().copied().collect(),
            float: allow.float.iter().copied().collect(),
            held,
            mounted: allow.mounts.iter().map(|m| m.object).collect(),
            doors: allow.doors.iter().map(|d| d.object).collect(),
        }
    }
    /// Whether P-COLLIDE speaks of a pair.
    pub fn collide(&self, a: ObjectId, b: ObjectId) -> bool {
        a != b && !self.may_overlap.contains(&(a.min(b), a.max(b))) && !self.allowed.contains(a, b)
    }
    /// How many pairs P-COLLIDE speaks of, among those of `objects` that pass.
    pub fn pairs(&self, objects: usize, passes: impl Fn(ObjectId) -> bool) -> usize {
        let n = (0..objects as u32).filter(|&i| passes(ObjectId(i))).count();
        let apart = |a: ObjectId, b: ObjectId| passes(a) && passes(b) && !self.allowed.contains(a, b);
        let excepted = self.may_overlap.iter().filter(|(a, b)| apart(*a, *b)).count() + self.allowed.count(&passes);
        n * n.saturating_sub(1) / 2 - excepted
    }
    /// Objects that may overlap any other.
    pub fn excepted(&self) -> FxHashSet<ObjectId> {
        self.allowed.objects().into_iter().chain(self.may_overlap.iter().flat_map(|(a, b)| [*a, *b])).collect()
    }
    /// Whether P-BOUNDS speaks of an object, in a program that has regions.
    pub fn bounds(&self, object: ObjectId) -> bool {
        !self.outside.contains(&object) && !self.doors.contains(&object)
    }
    /// What P-SUPPORT asks of an object.
    pub fn support(&self, object: ObjectId) -> Support {
        if self.float.contains(&object) || self.doors.contains(&object) {
            Support::Lifted
        } else if self.mounted.contains(&object) {
            Support::Mounted
        } else if self.held.contains(&object) {
            Support::Held
        } else {
            Support::Rests
        }
    }
}

pub fn mounts(allow: &Allowances, object: ObjectId) -> impl Iterator<Item = &Mount> {
    allow.mounts.iter().filter(move |m| m.object == object)
}

/// Contents with their containers, where these have no parts that could collide with or carry them.
fn hollow<N: Number>(world: &World<N>) -> Vec<(ObjectId, ObjectId)> {
    let has_parts = |id: ObjectId| world.object(id).is_ok_and(|thing| thing.body.has_parts());
    world.allow.contents.iter().copied().filter(|&(own, container)| own != container && !has_parts(container)).collect()
}

/// The content of a content, with the outer container.
fn nested(pairs: &[(ObjectId, ObjectId)]) -> Vec<(ObjectId, ObjectId)> {
    let mut known: FxHashSet<_> = pairs.iter().copied().collect();
    let mut open: Vec<_> = pairs.to_vec();
    let mut found = Vec::new();
    while let Some((content, container)) = open.pop() {
        for &(_, outer) in pairs.iter().filter(|(inner, outer)| *inner == container && *outer != content) {
            if known.insert((content, outer)) {
                found.push((content, outer));
                open.push((content, outer));
            }
        }
    }
    found
}
