//! Which objects come near each other.

use crate::number::Number;
use crate::world::World;
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Aabb, broad};

/// Pairs of objects whose upright boxes are at most `distance` apart, smaller id first, sorted.
pub fn pairs_within<N: Number>(world: &World<N>, distance: f64) -> Vec<(ObjectId, ObjectId)> {
    let (ids, boxes): (Vec<ObjectId>, Vec<Aabb>) = world.bodies().map(|(id, body)| (id, body.aabb())).unzip();
    let pairs = broad::pairs_within(&boxes, distance).into_iter();
    pairs.map(|(i, j)| (ids[i as usize], ids[j as usize])).collect()
}
