//! Which objects come near each other: a sweep along the longer side of the scene.

use crate::number::Number;
use crate::world::World;
use scenelang_lang::program::ObjectId;
use scenelang_layout::Aabb;

/// Pairs of objects whose upright boxes are at most `distance` apart, smaller id first, sorted.
pub fn pairs_within<N: Number>(world: &World<N>, distance: f64) -> Vec<(ObjectId, ObjectId)> {
    let mut boxes: Vec<(Aabb, ObjectId)> = world.bodies().map(|(id, body)| (body.aabb(), id)).collect();
    let Some(whole) = boxes.iter().map(|(b, _)| *b).reduce(|a, b| a.cover(&b)) else { return Vec::new() };
    let axis = (whole.max - whole.min).imax();
    boxes.sort_by(|a, b| a.0.min[axis].total_cmp(&b.0.min[axis]).then(a.1.cmp(&b.1)));
    let mut pairs = Vec::new();
    for (i, (first, a)) in boxes.iter().enumerate() {
        let near = boxes[i + 1..].iter().take_while(|(second, _)| second.min[axis] <= first.max[axis] + distance);
        for (_, b) in near.filter(|(second, _)| meet(first, second, distance)) {
            pairs.push((*a.min(b), *a.max(b)));
        }
    }
    pairs.sort_unstable();
    pairs
}

fn meet(a: &Aabb, b: &Aabb, distance: f64) -> bool {
    (0..3).all(|i| a.min[i] <= b.max[i] + distance && b.min[i] <= a.max[i] + distance)
}
