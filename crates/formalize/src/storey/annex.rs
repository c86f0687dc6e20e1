//! Balconies and terraces of a home lie outside its outline, along an outer wall of the room that leads to them.

use super::rows::Rect;
use crate::arrange::WALL;
use crate::furnish::kinds::{self, PlanPlace};

/// It is hardly of use where it would be less wide (metres).
const NARROW: f64 = 1.6;

/// Whether such a room has open edges.
pub fn is_outside(room: &str) -> bool {
    kinds::of(room).is_some_and(|kind| kind.lines.iter().any(|line| line.place == PlanPlace::Edge))
}

/// A place for what is so wide and so deep along one of the outer walls of a room, as wide as possible and in the middle of
/// the wall if that is free. The rectangle has its sides along x and z as it lies.
pub fn beside(rects: &[Rect], of: usize, [wide, deep]: [f64; 2]) -> Option<Rect> {
    let own = rects[of];
    let mut best: Option<(f64, Rect)> = None;
    for (across, outwards) in [(1, false), (1, true), (0, false), (0, true)] {
        let along = 1 - across;
        let length = wide.min(own.size[along]);
        let free = own.size[along] - length;
        for share in [0.5, 0.0, 1.0] {
            let mut rect = Rect::default();
            rect.low[along] = own.low[along] + share * free;
            rect.size[along] = length;
            rect.low[across] =
                if outwards { own.low[across] + own.size[across] + WALL } else { own.low[across] - WALL - deep };
            rect.size[across] = deep;
            let apart = |other: &Rect| {
                (0..2).any(|axis| {
                    rect.low[axis] >= other.low[axis] + other.size[axis] + WALL - 1e-6
                        || other.low[axis] >= rect.low[axis] + rect.size[axis] + WALL - 1e-6
                })
            };
            let wider = best.as_ref().is_none_or(|(known, _)| length > known + 1e-6);
            if wider && length >= NARROW && rects.iter().all(apart) {
                best = Some((length, rect));
            }
        }
    }
    best.map(|(_, rect)| rect)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_lies_at_a_free_wall() {
        let rect = |low: [f64; 2], size: [f64; 2]| Rect { low, size };
        let rooms = [rect([0.0, 0.0], [4.0, 4.0]), rect([0.0, -3.06], [4.0, 3.0])];
        let found = beside(&rooms, 0, [3.0, 1.5]).unwrap();
        assert_eq!((found.low, found.size), ([0.5, 4.0 + WALL], [3.0, 1.5]));
        let shut = [[-2.0, 0.0], [4.0 + WALL, 0.0], [0.0, -2.0 - WALL], [0.0, 4.0 + WALL]];
        let mut all = vec![rooms[0]];
        all.extend(shut.map(|low| rect(low, if low[1] == 0.0 { [2.0 - WALL, 4.0] } else { [4.0, 2.0] })));
        assert_eq!(beside(&all, 0, [3.0, 1.5]), None);
    }
}
