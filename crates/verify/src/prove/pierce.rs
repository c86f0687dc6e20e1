//! Guesses of points for a thing of which statements say where it may stand: along a wall, in a corner, in a zone. The places
//! that are left are swept from one side to the other; the first that has no point yet gets one that as many of the next
//! have as well.

use super::probes::{Cell, Points, ProbeBox};

/// So many places are looked at.
const MOST_PLACES: usize = 2000;
/// So many cells are made to find them.
const MOST_CELLS: usize = 12_000;
/// Places are told apart by one of these parts of the smaller side: the first that makes few enough of them.
const FINE: [f64; 3] = [0.12, 0.2, 0.35];
/// The same at first, where it costs little.
const COARSE: f64 = 1.0;
/// Points in a thing are tried at these parts of its sides, from the middle.
const TRIED: [f64; 5] = [-0.48, -0.25, 0.0, 0.25, 0.48];
/// A point is so far in a thing, at least (metres).
const LEAST: f64 = 1e-6;
/// Directions of the sweeps: along x and z.
const SWEEPS: [[f64; 2]; 6] = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [1.0, 0.7], [-0.7, 1.0]];

/// A place of the middle, and a turn.
type Pose = [f64; 3];

/// Sets of fewer than `fewer` points, the smallest first.
pub(super) fn guesses(
    floor: [f64; 2],
    kind: &ProbeBox,
    fewer: usize,
    may_be: &mut dyn FnMut(&Cell) -> bool,
    work: &mut u64,
) -> Vec<Points> {
    // Where so many of it can stand without a common point, there is no smaller set of points.
    let coarse = places(floor, kind, COARSE, may_be, work);
    if coarse.is_some_and(|coarse| disjoint(&coarse, kind, fewer)) {
        return Vec::new();
    }
    let Some(places) = FINE.iter().find_map(|fine| places(floor, kind, *fine, may_be, work)) else { return Vec::new() };
    let mut out: Vec<Points> = Vec::new();
    for pair in SWEEPS.chunks(2) {
        let found: Vec<Option<Points>> =
            pair.iter().map(|direction| sweep(&places, kind, *direction, fewer - 1, work)).collect();
        if let [Some(there), Some(back)] = &found[..]
            && there.len() == back.len()
        {
            let mid = |(p, q): (&[f64; 2], &[f64; 2])| [(p[0] + q[0]) / 2.0, (p[1] + q[1]) / 2.0];
            out.push(std::iter::zip(there, back.iter().rev()).map(mid).collect());
        }
        out.extend(found.into_iter().flatten());
    }
    out.sort_by_key(Vec::len);
    out.truncate(4);
    out
}

/// Where it may stand, roughly; nothing, where that is too much.
fn places(
    floor: [f64; 2],
    kind: &ProbeBox,
    fine: f64,
    may_be: &mut dyn FnMut(&Cell) -> bool,
    work: &mut u64,
) -> Option<Vec<Pose>> {
    let [w, d] = kind.size;
    let half = w.hypot(d) / 2.0;
    let fine = fine * (kind.core[0].min(kind.core[1]) + 2.0 * kind.space);
    let [x, z] = floor.map(|f| (f / 2.0 - w.min(d) / 2.0).max(0.0));
    let mut open = vec![Cell { lo: [-x, -z, kind.turns[0]], hi: [x, z, kind.turns[1]] }];
    let (mut out, mut cells) = (Vec::new(), 0);
    while let Some(cell) = open.pop() {
        cells += 1;
        *work += 2;
        if cells > MOST_CELLS || out.len() > MOST_PLACES {
            return None;
        }
        let mid: Pose = std::array::from_fn(|i| (cell.lo[i] + cell.hi[i]) / 2.0);
        let off: [f64; 3] = std::array::from_fn(|i| (cell.hi[i] - cell.lo[i]) / 2.0);
        let (sin, cos) = mid[2].sin_cos();
        let reach = [w * cos.abs() + d * sin.abs(), w * sin.abs() + d * cos.abs()].map(|r| r / 2.0 - half * off[2]);
        let outside = (0..2).any(|i| mid[i].abs() - off[i] + reach[i] > floor[i] / 2.0);
        if outside || !may_be(&cell) {
            continue;
        }
        let sizes = [off[0], off[1], off[2] * half];
        let widest = (0..3).max_by(|&i, &k| sizes[i].total_cmp(&sizes[k])).unwrap_or(0);
        if 2.0 * sizes[widest] < fine {
            // Of a place that may be, its middle may still be none.
            let point = Cell { lo: mid, hi: mid };
            if (0..2).all(|i| mid[i].abs() + reach[i] <= floor[i] / 2.0) && may_be(&point) {
                out.push(mid);
            }
            continue;
        }
        for upper in [false, true] {
            let mut part = cell;
            let end = if upper { &mut part.lo } else { &mut part.hi };
            end[widest] = mid[widest];
            open.push(part);
        }
    }
    Some(out)
}

/// Whether some of the places, at least so many, have no point in common, whichever way the thing is turned there.
fn disjoint(places: &[Pose], kind: &ProbeBox, least: usize) -> bool {
    let apart = kind.core[0].hypot(kind.core[1]) + 2.0 * kind.space;
    let mut taken: Vec<&Pose> = Vec::new();
    for place in places {
        if taken.iter().all(|other| (place[0] - other[0]).hypot(place[1] - other[1]) > apart) {
            taken.push(place);
        }
        if taken.len() >= least {
            return true;
        }
    }
    false
}

/// Points so that each place has one, by a sweep; nothing, where that takes more than `most`.
fn sweep(places: &[Pose], kind: &ProbeBox, direction: [f64; 2], most: usize, work: &mut u64) -> Option<Points> {
    let along = |p: &Pose| p[0] * direction[0] + p[1] * direction[1];
    let mut left: Vec<Pose> = places.to_vec();
    left.sort_by(|p, q| along(p).total_cmp(&along(q)));
    let mut points = Points::new();
    while let Some(first) = left.first().copied() {
        if points.len() == most {
            return None;
        }
        let (sin, cos) = first[2].sin_cos();
        let size = kind.core.map(|s| s + 1.8 * kind.space);
        let mut best: Option<(usize, f64, [f64; 2])> = None;
        for (u, v) in TRIED.iter().flat_map(|u| TRIED.iter().map(move |v| (u * size[0], v * size[1]))) {
            let point = [first[0] + u * cos + v * sin, first[1] - u * sin + v * cos];
            let (count, spare) = covered(&left, kind, point);
            *work += left.len() as u64 / 8;
            if best.is_none_or(|(most, least, _)| count > most || count == most && spare > least) {
                best = Some((count, spare, point));
            }
        }
        let (mut count, mut spare, mut point) = best.filter(|(count, ..)| *count > 0)?;
        // Nearer to the middle of the places that have it there is more to spare.
        let own: Vec<Pose> = left.iter().copied().filter(|place| away(kind, place, point) < -LEAST).collect();
        let middle = [0, 1].map(|i| own.iter().map(|place| place[i]).sum::<f64>() / count as f64);
        for part in [0.25, 0.5, 0.75, 1.0] {
            let moved = [0, 1].map(|i| point[i] + part * (middle[i] - point[i]));
            let (n, s) = covered(&left, kind, moved);
            *work += left.len() as u64 / 8;
            if n >= count && s > spare {
                (count, spare, point) = (n, s, moved);
            }
        }
        left.retain(|place| away(kind, place, point) >= -LEAST);
        points.push(point);
    }
    Some(points)
}

/// How many places have a point, and how far it is in the one that it is least far in.
fn covered(places: &[Pose], kind: &ProbeBox, point: [f64; 2]) -> (usize, f64) {
    let inside = places.iter().map(|place| -away(kind, place, point)).filter(|spare| *spare > LEAST);
    inside.fold((0, f64::INFINITY), |(count, least), spare| (count + 1, least.min(spare)))
}

/// How far a point is outside of what a thing keeps for itself at a place; negative inside.
fn away(kind: &ProbeBox, [x, z, turn]: &Pose, point: [f64; 2]) -> f64 {
    let (sin, cos) = turn.sin_cos();
    let (dx, dz) = (point[0] - x, point[1] - z);
    let (u, v) = ((dx * cos - dz * sin).abs() - kind.core[0] / 2.0, (dx * sin + dz * cos).abs() - kind.core[1] / 2.0);
    let away = if u > 0.0 && v > 0.0 { u.hypot(v) } else { u.max(v) };
    away - kind.space
}
