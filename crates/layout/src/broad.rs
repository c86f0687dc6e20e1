//! Which of many boxes come near each other: a sweep along the longest side of the scene, then the separating axes.
//!
//! Scenes are flat and their things of like sizes, so a sorted sweep beats a tree well past 10,000 boxes: nothing to
//! build, nothing to balance, memory read in order (`./x bench overlap` compares them).

use crate::obb::apart;
use crate::{Aabb, Obb};
use std::ops::ControlFlow;

/// Pairs of upright boxes at most `distance` apart (metres) in each direction, smaller index first, sorted.
pub fn pairs_within(boxes: &[Aabb], distance: f64) -> Vec<(u32, u32)> {
    let mut pairs = Vec::new();
    // Without a limit nothing ends it early.
    let _whole = visit_within(boxes, distance, usize::MAX, |i, j| {
        pairs.push((i, j));
        ControlFlow::Continue(())
    });
    pairs.sort_unstable();
    pairs
}

/// Hands over the same pairs one after the other, in no order that means anything but always in the same one, until `visit`
/// breaks or more than `most` pairs of boxes would have been compared. Returns whether it came to the end.
pub fn visit_within(
    boxes: &[Aabb],
    distance: f64,
    most: usize,
    mut visit: impl FnMut(u32, u32) -> ControlFlow<()>,
) -> bool {
    let Some(whole) = boxes.iter().copied().reduce(|a, b| a.cover(&b)) else { return true };
    let axis = (whole.max - whole.min).imax();
    let [second, third] = [(axis + 1) % 3, (axis + 2) % 3];
    // Least and greatest along the three, one after the other in memory.
    let mut sorted: Vec<([f64; 6], u32)> = boxes
        .iter()
        .zip(0..)
        .map(|(b, i)| {
            let end = |k: usize| b.max[k] + distance;
            ([b.min[axis], end(axis), b.min[second], end(second), b.min[third], end(third)], i)
        })
        .collect();
    sorted.sort_unstable_by(|a, b| a.0[0].total_cmp(&b.0[0]).then(a.1.cmp(&b.1)));
    let mut left = most;
    for (at, (a, i)) in sorted.iter().enumerate() {
        if left == 0 {
            return false;
        }
        let mut compared = 0;
        for (b, j) in sorted[at + 1..].iter().take_while(|(b, _)| b[0] <= a[1]) {
            compared += 1;
            let near = (b[2] <= a[3]) & (a[2] <= b[3]) & (b[4] <= a[5]) & (a[4] <= b[5]);
            if near && visit(*i.min(j), *i.max(j)).is_break() {
                return false;
            }
        }
        left = left.saturating_sub(compared);
    }
    true
}

/// Pairs of boxes that overlap by more than `tolerance` (metres), smaller index first, sorted.
pub fn overlapping(boxes: &[Obb], tolerance: f64) -> Vec<(u32, u32)> {
    let around: Vec<Aabb> = boxes.iter().map(Obb::aabb).collect();
    let mut pairs = pairs_within(&around, -tolerance);
    pairs.retain(|&(i, j)| !apart(&boxes[i as usize], &boxes[j as usize], -tolerance));
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::obb::separation;
    use crate::{Placement, Vec3};
    use proptest::prelude::*;

    fn boxes() -> impl Strategy<Value = Vec<Obb>> {
        let one = (
            [-4.0..4.0, -0.5..0.5, -9.0..9.0f64],
            [0.0..360.0, -30.0..30.0, 0.0..360.0],
            [0.1..2.0, 0.1..2.0, 0.1..2.0],
        )
            .prop_map(|(pos, rot, scale)| {
                Obb::from_placement(&Placement {
                    pos: Vec3::from(pos),
                    rot: Vec3::from(rot),
                    scale: Vec3::from(scale),
                    parts: Vec::new(),
                    surface: None,
                    joints: Vec::new(),
                })
            });
        prop::collection::vec(one, 0..40)
    }

    proptest! {
        #[test]
        fn pairs_are_those_that_all_pairs_have(boxes in boxes(), tolerance in 0.0..0.01f64) {
            let all = (0..boxes.len() as u32).flat_map(|i| (i + 1..boxes.len() as u32).map(move |j| (i, j)));
            let wanted: Vec<(u32, u32)> =
                all.filter(|(i, j)| separation(&boxes[*i as usize], &boxes[*j as usize]).gap < -tolerance).collect();
            prop_assert_eq!(overlapping(&boxes, tolerance), wanted);
        }
    }
}
