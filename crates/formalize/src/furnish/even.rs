//! Beds of one room side by side, and what else stands in a run: heads at one wall, or at two that are opposite, all at the same distance.

use super::floor::{Floor, Pose, Shape};
use super::seek::{self, Wall};

/// Between the places of two beds there is so much more at most (metres): where each has a place of its own, and where two
/// beds share a night table.
const MORE: f64 = 0.7;
const SHARED: f64 = 0.02;
/// A place that takes more than this has curtains or chairs of its own.
const OWN: f64 = 2.0;
/// Beds with nothing beside them have so much between them, and at least so much; what is wider has something beside it.
const BETWEEN: [f64; 2] = [0.75, 0.45];
const NARROW: f64 = 1.25;
/// One slides into a booth from between two.
const BOOTHS: [f64; 2] = [0.9, 0.45];
/// What is less deep is no bed.
const BED: f64 = 1.2;
/// The fewest seats in a row.
const FEWEST: usize = 2;
/// From one place that is tried to the next.
const STEP: f64 = 0.1;

/// Places for so many groups of a depth, evenly at one wall, else at two opposite ones, of seats at as many walls as are needed; none if there is no room for all. `is_close`:
/// with no more between them than is needed; `may_stand`: whether one may stand there.
pub fn places(
    floor: &Floor,
    shape: &Shape,
    n: usize,
    (depth, is_close): (f64, bool),
    windows: &[Wall],
    may_stand: &dyn Fn(&Pose) -> bool,
) -> Option<Vec<Pose>> {
    let mut walls = Wall::ALL;
    walls.sort_by_key(|wall| windows.contains(wall));
    for wall in walls {
        if let Some(found) = row(floor, shape, n, (depth, is_close), wall, may_stand) {
            return Some(found);
        }
    }
    for wall in [Wall::Left, Wall::Back] {
        let (first, second) = (n.div_ceil(2), n / 2);
        for (one, other) in [(first, second), (second, first)] {
            let Some(mut found) = row(floor, shape, one, (depth, is_close), wall, may_stand) else { continue };
            let mut left = floor.clone();
            found.iter().for_each(|at| left.take(shape, at));
            if let Some(more) = row(&left, shape, other, (depth, is_close), wall.across(), may_stand) {
                found.extend(more);
                return Some(found);
            }
        }
    }
    if is_close || depth >= BED {
        return None;
    }
    // Seats fill one wall after the other.
    let (mut left, mut found) = (floor.clone(), Vec::new());
    for wall in walls {
        let rest = n - found.len();
        let most = |k: &usize| row(&left, shape, *k, (depth, is_close), wall, may_stand);
        let Some(more) = (FEWEST.min(rest)..=rest).rev().find_map(|k| most(&k)) else { continue };
        more.iter().for_each(|at| left.take(shape, at));
        found.extend(more);
        if found.len() == n {
            return Some(found);
        }
    }
    None
}

/// A row at one wall, as near to its middle as it fits.
fn row(
    floor: &Floor,
    shape: &Shape,
    n: usize,
    (depth, is_close): (f64, bool),
    wall: Wall,
    may_stand: &dyn Fn(&Pose) -> bool,
) -> Option<Vec<Pose>> {
    let [left, right, back, _] = seek::reach(shape);
    let (each, length) = (left + right, wall.length(floor.size) - 0.04);
    let rest = length - n as f64 * each;
    if n == 0 || rest < 0.0 {
        return (n == 0).then(Vec::new);
    }
    let [most, least] = match each {
        _ if is_close => [SHARED, 0.0],
        _ if shape.is_lounge => BOOTHS,
        _ if each > OWN || depth < BED => [MORE, 0.0],
        _ if each < NARROW => BETWEEN,
        _ => [SHARED, 0.0],
    };
    let away = back.max(depth / 2.0) + seek::BEHIND;
    let mut more = (rest / n as f64).min(most);
    while more >= least {
        let step = each + more;
        let slack = length - (n as f64 - 1.0) * step - each;
        let tries = (slack / 2.0 / STEP).max(0.0) as i64;
        let shifts = (0..=tries).flat_map(|k| [k as f64 * STEP, -(k as f64) * STEP]);
        for shift in shifts {
            // The middle of the row, the bed's own middle apart.
            let first = shift - (n as f64 - 1.0) * step / 2.0 + (left - right) / 2.0;
            let poses: Vec<Pose> = (0..n).map(|i| wall.place(floor.size, first + step * i as f64, away)).collect();
            if poses.iter().all(|at| floor.fits(shape, at) && may_stand(at)) && ways(floor, shape, &poses) {
                return Some(poses);
            }
        }
        more -= STEP;
    }
    None
}

/// Whether one gets to all when they stand there.
fn ways(floor: &Floor, shape: &Shape, poses: &[Pose]) -> bool {
    let Some((last, before)) = poses.split_last() else { return true };
    let mut with = floor.clone();
    before.iter().for_each(|at| with.take(shape, at));
    with.leaves_ways(shape, last)
}
