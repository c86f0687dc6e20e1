//! The search: depth first, with thirty children at the root and one everywhere else.

use super::{Constraint, Spot};
use crate::dataset::Dice;

/// As published: so many placements of the first object are tried.
const FIRST: usize = 30;
/// As published: a cell is the longer side of the room over this.
const CELLS: f64 = 20.0;
/// As published (metres): the front of an object is at least so far from a wall.
const FRONT: f64 = 0.3;
/// As published: what a satisfied relation is worth, before its weight.
const BONUS: f64 = 0.2;
/// As published (metres): nearer than this is near.
const NEAR: f64 = 0.8;
/// As published (metres): centres so far out of line are aligned.
const ALIGNED: f64 = 0.05;
/// The published limit is 30 seconds. Here it is so many placements judged, so that the result does not depend on the machine.
const WORK: u64 = 20_000_000;
/// Between what must not overlap (metres).
const TOUCH: f64 = 1e-6;

/// A room: its extents about its middle, and what of its floor is kept free.
pub(crate) struct Area {
    pub size: [f64; 2],
    pub taken: Vec<([f64; 2], [f64; 2])>,
}

/// An object: width and depth, and what is asked of it.
pub(crate) struct GridObject {
    pub size: [f64; 2],
    pub constraints: Vec<Constraint>,
}

pub(crate) struct BestAttempt {
    pub spots: Vec<Option<Spot>>,
    pub work: u64,
    pub is_cut: bool,
}

/// Half extents of a size after quarter turns.
fn half(size: [f64; 2], turns: usize) -> [f64; 2] {
    let [w, d] = size.map(|x| x / 2.0);
    if turns.is_multiple_of(2) { [w, d] } else { [d, w] }
}

/// Where the front points after quarter turns.
fn front(turns: usize) -> [f64; 2] {
    [[0.0, 1.0], [1.0, 0.0], [0.0, -1.0], [-1.0, 0.0]][turns % 4]
}

/// The gap between two boxes that are not turned otherwise than by quarters.
fn gap(a: ([f64; 2], [f64; 2]), b: ([f64; 2], [f64; 2])) -> f64 {
    let along = |i: usize| ((a.0[i] - b.0[i]).abs() - a.1[i] - b.1[i]).max(0.0);
    along(0).hypot(along(1))
}

fn overlap(a: ([f64; 2], [f64; 2]), b: ([f64; 2], [f64; 2])) -> bool {
    (0..2).all(|i| (a.0[i] - b.0[i]).abs() < a.1[i] + b.1[i] - TOUCH)
}

/// Looks for places of all pieces, in their order.
pub(crate) fn search(area: &Area, pieces: &[GridObject], dice: &mut Dice) -> BestAttempt {
    let mut attempt = Attempt { area, pieces, work: 0, placed: Vec::new(), score: 0.0 };
    let mut best: (f64, Vec<Spot>) = (f64::NEG_INFINITY, Vec::new());
    let mut first = pieces.first().map_or_else(Vec::new, |piece| attempt.placements(piece, dice));
    dice.shuffle(&mut first);
    first.truncate(FIRST);
    for (score, spot) in first {
        if attempt.work >= WORK {
            break;
        }
        attempt.placed = vec![spot];
        attempt.score = score;
        for piece in &pieces[1..] {
            let placements = attempt.placements(piece, dice);
            // Ties are broken by the order, which is random.
            let better = |a: (f64, Spot), b: (f64, Spot)| if b.0 > a.0 { b } else { a };
            let Some((score, spot)) = placements.into_iter().reduce(better) else { break };
            attempt.placed.push(spot);
            attempt.score += score;
        }
        if attempt.score > best.0 {
            best = (attempt.score, attempt.placed.clone());
        }
    }
    let mut spots: Vec<Option<Spot>> = best.1.into_iter().map(Some).collect();
    spots.resize(pieces.len(), None);
    BestAttempt { spots, work: attempt.work, is_cut: attempt.work >= WORK }
}

struct Attempt<'a> {
    area: &'a Area,
    pieces: &'a [GridObject],
    work: u64,
    placed: Vec<Spot>,
    score: f64,
}

impl Attempt<'_> {
    /// Where the next piece may stand, in random order, with what each place is worth.
    fn placements(&mut self, piece: &GridObject, dice: &mut Dice) -> Vec<(f64, Spot)> {
        let cell = self.area.size[0].max(self.area.size[1]) / CELLS;
        let is_edge = piece.constraints.contains(&Constraint::Edge);
        let mut free: Vec<Spot> = Vec::new();
        let steps = self.area.size.map(|length| (length / cell).floor() as usize);
        for turns in 0..4 {
            for (i, j) in (0..steps[0]).flat_map(|i| (0..steps[1]).map(move |j| (i, j))) {
                self.work += 1;
                let at = [i, j].map(|n| n as f64 * cell);
                let at = [at[0] - self.area.size[0] / 2.0, at[1] - self.area.size[1] / 2.0];
                let own = half(piece.size, turns);
                if let Some(at) = self.at_edge(at, own, turns, if is_edge { Some(cell) } else { None })
                    && self.is_free(at, own, turns)
                {
                    free.push((at, turns));
                }
            }
        }
        dice.shuffle(&mut free);
        let gaps: Vec<(f64, f64)> = piece.constraints.iter().map(|c| self.range(*c, piece, &free)).collect();
        let worth = |spot: &Spot| {
            let each = piece.constraints.iter().zip(&gaps);
            each.map(|(c, range)| c.weight() * self.worth(*c, piece, *spot, *range, cell)).sum::<f64>()
        };
        let count = piece.constraints.len().max(1) as f64;
        free.iter().map(|spot| (worth(spot) / count, *spot)).collect()
    }

    /// A place that has to be at the edge is moved there, if it is no more than a cell away from it.
    fn at_edge(&self, at: [f64; 2], own: [f64; 2], turns: usize, cell: Option<f64>) -> Option<[f64; 2]> {
        let Some(cell) = cell else { return Some(at) };
        let way = front(turns);
        let axis = usize::from(way[0] == 0.0);
        let wall = -way[axis] * (self.area.size[axis] / 2.0 - own[axis]);
        let mut moved = at;
        moved[axis] = wall;
        ((at[axis] - wall).abs() <= cell).then_some(moved)
    }

    fn is_free(&self, at: [f64; 2], own: [f64; 2], turns: usize) -> bool {
        let inside = |i: usize| at[i].abs() + own[i] <= self.area.size[i] / 2.0 + TOUCH;
        let way = front(turns);
        let axis = usize::from(way[0] == 0.0);
        let ahead = self.area.size[axis] / 2.0 - (at[axis] + way[axis] * own[axis]) * way[axis];
        let taken = self.area.taken.iter().map(|(centre, size)| (*centre, size.map(|x| x / 2.0)));
        let others = self.placed.iter().zip(self.pieces).map(|(spot, piece)| (spot.0, half(piece.size, spot.1)));
        inside(0) && inside(1) && ahead >= FRONT && !taken.chain(others).any(|other| overlap((at, own), other))
    }

    fn target(&self, index: usize) -> Option<(Spot, [f64; 2])> {
        let spot = *self.placed.get(index)?;
        Some((spot, half(self.pieces[index].size, spot.1)))
    }

    /// The least and the greatest distance that the places have, of a constraint on distances.
    fn range(&self, constraint: Constraint, piece: &GridObject, free: &[Spot]) -> (f64, f64) {
        let (Constraint::Near(target) | Constraint::Far(target)) = constraint else { return (0.0, 0.0) };
        let Some((spot, size)) = self.target(target) else { return (0.0, 0.0) };
        let gaps = free.iter().map(|(at, turns)| gap((*at, half(piece.size, *turns)), (spot.0, size)));
        gaps.fold((f64::INFINITY, 0.0), |(lo, hi), gap| (lo.min(gap), hi.max(gap)))
    }

    /// What a place is worth for a constraint, before its weight.
    fn worth(&self, c: Constraint, piece: &GridObject, (at, turns): Spot, (least, most): (f64, f64), cell: f64) -> f64 {
        let bonus = |is: bool| if is { BONUS } else { 0.0 };
        let target = match c {
            Constraint::Edge | Constraint::Middle => return bonus(c == Constraint::Edge),
            Constraint::Near(t) | Constraint::Far(t) | Constraint::LeftOf(t) | Constraint::RightOf(t) => t,
            Constraint::InFrontOf(t) | Constraint::SideOf(t) | Constraint::FaceTo(t) => t,
            Constraint::CenterAligned(t) => t,
        };
        let Some((spot, size)) = self.target(target) else { return 0.0 };
        let distance = gap((at, half(piece.size, turns)), (spot.0, size));
        let ahead = front(spot.1);
        let right = front(spot.1 + 1);
        let d = [at[0] - spot.0[0], at[1] - spot.0[1]];
        let along = |way: [f64; 2]| d[0] * way[0] + d[1] * way[1];
        let own = |way: [f64; 2]| size[usize::from(way[0] == 0.0)];
        match c {
            Constraint::Near(_) if least < NEAR => ((NEAR - distance) / (NEAR - least)).max(0.0),
            Constraint::Far(_) if most > least => (distance - least) / (most - least),
            Constraint::LeftOf(_) => bonus(along(right) < -own(right) && along(ahead).abs() <= own(ahead)),
            Constraint::RightOf(_) => bonus(along(right) > own(right) && along(ahead).abs() <= own(ahead)),
            Constraint::InFrontOf(_) => bonus(along(ahead) > own(ahead) && along(right).abs() < cell),
            Constraint::SideOf(_) => bonus(along(ahead).abs() <= own(ahead)),
            Constraint::CenterAligned(_) => bonus(d[0].abs() < ALIGNED || d[1].abs() < ALIGNED),
            Constraint::FaceTo(_) => {
                let way = front(turns);
                let axis = usize::from(way[0] == 0.0);
                bonus(-d[axis] * way[axis] + size[axis] >= 0.0 && d[1 - axis].abs() <= size[1 - axis])
            }
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(pieces: &[GridObject]) -> Vec<Option<Spot>> {
        let area = Area { size: [4.0, 3.0], taken: vec![([0.0, -1.0], [1.0, 1.0])] };
        search(&area, pieces, &mut Dice::new(1, 0)).spots
    }

    #[test]
    fn what_is_asked_for_is_found_where_there_is_room() {
        let piece = |size, constraints: &[Constraint]| GridObject { size, constraints: constraints.to_vec() };
        let spots = found(&[
            piece([1.6, 0.8], &[Constraint::Edge]),
            piece([0.5, 0.5], &[Constraint::Middle, Constraint::Near(0), Constraint::FaceTo(0)]),
            piece([0.5, 0.5], &[Constraint::Edge, Constraint::Far(0)]),
        ]);
        let [desk, chair, cabinet] = [0, 1, 2].map(|i| spots[i].unwrap());
        let sizes = [half([1.6, 0.8], desk.1), half([0.5, 0.5], chair.1), half([0.5, 0.5], cabinet.1)];
        let back = [desk.0[0] - front(desk.1)[0] * sizes[0][0], desk.0[1] - front(desk.1)[1] * sizes[0][1]];
        assert!(
            (back[0].abs() - 2.0).abs() < 1e-9 || (back[1].abs() - 1.5).abs() < 1e-9,
            "its back is at a wall: {desk:?}"
        );
        assert!(gap((desk.0, sizes[0]), (chair.0, sizes[1])) < 0.3, "{desk:?} {chair:?}");
        assert!(gap((desk.0, sizes[0]), (cabinet.0, sizes[2])) > 1.0, "{desk:?} {cabinet:?}");
    }

    #[test]
    fn what_has_no_place_ends_the_attempt() {
        let piece = |size| GridObject { size, constraints: vec![Constraint::Middle] };
        let spots = found(&[piece([1.0, 0.5]), piece([3.9, 2.9]), piece([0.2, 0.2])]);
        assert!(spots[0].is_some() && spots[1].is_none() && spots[2].is_none(), "{spots:?}");
    }
}
