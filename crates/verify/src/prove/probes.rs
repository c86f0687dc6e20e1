//! Points on a floor such that a thing covers some of them wherever it stands: things that keep clear of each other
//! cannot cover a point twice, so where they cover more points together than there are, they do not fit.
//!
//! Four points do it for squares of 1.6 m on a floor of 4 by 4 m, a point in the middle of each wall for wardrobes that
//! stand along the walls, a row of points for lockers in a passage. Where to put points is a guess; that a thing covers
//! one wherever it may stand is tried in every cell of its places and turns, the cells made smaller until it shows.

use super::interval::Interval;
use std::f64::consts::{FRAC_PI_2, PI};

/// A thing on a floor, all sizes at least so (metres).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ProbeBox {
    /// Its footprint, which the walls keep inside.
    pub size: [f64; 2],
    /// What of it is solid, about its middle: nothing, where it is its centre that keeps distances.
    pub core: [f64; 2],
    /// How far around that no other thing's space comes.
    pub space: f64,
    /// Its turns (radians).
    pub turns: [f64; 2],
}

impl ProbeBox {
    /// The area that it keeps for itself.
    pub fn taken(&self) -> f64 {
        let [w, d] = self.core;
        w * d + 2.0 * (w + d) * self.space + PI * self.space * self.space
    }
}

/// Any turn of a rectangle, whichever way it faces.
pub(super) const ANY_TURN: [f64; 2] = [0.0, PI];
/// Any turn.
pub(super) const WHOLE_TURN: [f64; 2] = [0.0, 2.0 * PI];

/// A set of points on a floor; the middle of the floor is (0, 0).
pub(super) type Points = Vec<[f64; 2]>;

/// Cells that are looked at before a guess is given up.
const MOST_CELLS: u32 = 60_000;
/// Smaller cells are not made (metres).
const SMALLEST: f64 = 2e-4;
/// What rounding may cost (metres).
const ROUNDING: f64 = 1e-9;
/// So many points are looked at, at most.
const MOST_POINTS: usize = 64;

/// Places and turns between bounds: x, z, turn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    pub lo: [f64; 3],
    pub hi: [f64; 3],
}

/// Whether a thing covers one of the points wherever it stands on a floor (metres by metres), and wherever `may_be` does
/// not exclude.
pub(super) fn covers_one(
    floor: [f64; 2],
    kind: &ProbeBox,
    points: &Points,
    may_be: &mut dyn FnMut(&Cell) -> bool,
    work: &mut u64,
) -> bool {
    let ([w, d], core) = (kind.size, kind.core);
    let half = w.hypot(d) / 2.0;
    let [x, z] = floor.map(|f| (f / 2.0 - w.min(d) / 2.0).max(0.0));
    let mut open = vec![Cell { lo: [-x, -z, kind.turns[0]], hi: [x, z, kind.turns[1]] }];
    let mut cells = 0;
    while let Some(cell) = open.pop() {
        cells += 1;
        *work += 1 + points.len() as u64 / 4;
        if cells > MOST_CELLS {
            return false;
        }
        let mid: [f64; 3] = std::array::from_fn(|i| (cell.lo[i] + cell.hi[i]) / 2.0);
        let off: [f64; 3] = std::array::from_fn(|i| (cell.hi[i] - cell.lo[i]) / 2.0);
        let (sin, cos) = mid[2].sin_cos();
        // A turn moves no corner by more than half the diagonal times its angle.
        let reach = [w * cos.abs() + d * sin.abs(), w * sin.abs() + d * cos.abs()].map(|r| r / 2.0 - half * off[2]);
        if (0..2).any(|i| mid[i].abs() - off[i] + reach[i] > floor[i] / 2.0 + ROUNDING) {
            continue;
        }
        let moved = off[0].hypot(off[1]);
        let covers = |p: &[f64; 2]| {
            let (dx, dz) = (p[0] - mid[0], p[1] - mid[1]);
            // Along its right (cos, −sin) and its front (sin, cos).
            let (u, v) = ((dx * cos - dz * sin).abs() - core[0] / 2.0, (dx * sin + dz * cos).abs() - core[1] / 2.0);
            let away = if u > 0.0 && v > 0.0 { u.hypot(v) } else { u.max(v) };
            let turned = if core == [0.0; 2] { 0.0 } else { dx.hypot(dz) * off[2] };
            away + moved + turned < kind.space - ROUNDING
        };
        if points.iter().any(covers) || !may_be(&cell) {
            continue;
        }
        let sizes = [off[0], off[1], off[2] * half];
        let widest = (0..3).max_by(|&i, &k| sizes[i].total_cmp(&sizes[k])).unwrap_or(0);
        if sizes[widest] < SMALLEST {
            return false;
        }
        for upper in [false, true] {
            let mut part = cell;
            let end = if upper { &mut part.lo } else { &mut part.hi };
            end[widest] = mid[widest];
            open.push(part);
        }
    }
    true
}

/// Places along a line: its length, the side of what stands there, the space around it, how many.
type Spread = fn(f64, f64, f64, usize) -> Vec<f64>;

/// Guesses for things of a kind on a floor: fewer than `fewer` points each.
pub(super) fn guesses(floor: [f64; 2], kind: &ProbeBox, fewer: usize) -> Vec<Points> {
    let side = kind.core[0].min(kind.core[1]) + 2.0 * kind.space;
    let longer = kind.core[0].max(kind.core[1]) + 2.0 * kind.space;
    let most = fewer.saturating_sub(1).min(MOST_POINTS);
    let mut out: Vec<Points> = Vec::new();
    let mut add = |points: Points| {
        if !points.is_empty() && points.len() <= most && !out.contains(&points) {
            out.push(points);
        }
    };
    let fit = |length: f64, side: f64| ((length + 2.0 * kind.space) / side + 1e-6).floor().max(1.0) as usize;
    for spread in [at_walls as Spread, evenly, amid] {
        let line = |i: usize, n: usize| spread(floor[i], side, kind.space, n);
        let [nx, nz] = [0, 1].map(|i| fit(floor[i], side));
        let [x, z] = [line(0, nx), line(1, nz)];
        add(x.iter().flat_map(|x| z.iter().map(|z| [*x, *z])).collect());
        // A row of long things needs one line of points, straight or across.
        let n = nx.max(nz);
        add(std::iter::zip(line(0, n), line(1, n)).map(|(x, z)| [x, z]).collect());
        for n in [nx, nz] {
            add(line(0, n).into_iter().map(|x| [x, 0.0]).collect());
            add(line(1, n).into_iter().map(|z| [0.0, z]).collect());
        }
        // A row of things with their longer sides along it.
        for (i, other) in [(0, 1), (1, 0)] {
            let row = spread(floor[i], longer, kind.space, fit(floor[i], longer));
            let at = |v: f64| if other == 1 { [v, 0.0] } else { [0.0, v] };
            add(row.into_iter().map(at).collect());
        }
        // Along the four walls.
        let [ax, az] = [0, 1].map(|i| spread(floor[i], longer, kind.space, fit(floor[i], longer)));
        let deep = side / 2.0 - kind.space;
        let [bx, bz] = floor.map(|f| f / 2.0 - deep);
        let along = ax.iter().flat_map(|x| [[*x, -bz], [*x, bz]]);
        add(along.chain(az.iter().flat_map(|z| [[-bx, *z], [bx, *z]])).collect());
    }
    // Cells of the places of the middle, few and as square as can be.
    let places = floor.map(|f| (f - kind.size[0].min(kind.size[1])).max(0.0));
    for nx in 1..=most {
        let nz = (1..=most / nx).find(|nz| {
            let cell = [places[0] / nx as f64, places[1] / *nz as f64];
            cell[0].hypot(cell[1]) / 2.0 < side / 2.0 - ROUNDING
        });
        if let Some(nz) = nz {
            let [x, z] = [middles(places[0], nx), middles(places[1], nz)];
            add(x.iter().flat_map(|x| z.iter().map(|z| [*x, *z])).collect());
        }
    }
    out.sort_by_key(Vec::len);
    out
}

/// So that the outermost are just reached from the walls, the others evenly between.
fn at_walls(length: f64, side: f64, space: f64, n: usize) -> Vec<f64> {
    let first = length / 2.0 - (side - space) + 1e-3 * side;
    match n {
        1 => vec![0.0],
        n => (0..n).map(|i| first.max(0.0) * (2.0 * i as f64 / (n - 1) as f64 - 1.0)).collect(),
    }
}

/// At equal distances, the outermost as far from the end of what may be covered.
fn evenly(length: f64, _: f64, space: f64, n: usize) -> Vec<f64> {
    let length = length + 2.0 * space;
    (1..=n).map(|i| length * (i as f64 / (n + 1) as f64 - 0.5)).collect()
}

/// Between the two.
fn amid(length: f64, side: f64, space: f64, n: usize) -> Vec<f64> {
    let pairs = std::iter::zip(at_walls(length, side, space, n), evenly(length, side, space, n));
    pairs.map(|(a, b)| (a + b) / 2.0).collect()
}

/// The middles of equal parts.
fn middles(length: f64, n: usize) -> Vec<f64> {
    (0..n).map(|i| length * ((i as f64 + 0.5) / n as f64 - 0.5)).collect()
}

/// The turns of a thing of which sine and cosine are known to be near to a point, or all.
pub(super) fn turns(cos: Interval, sin: Interval) -> Option<[f64; 2]> {
    // A unit vector that is off by so much in each component is turned by less than three times as much.
    let off = 3.0 * cos.width().max(sin.width()) + ROUNDING;
    let turn = (sin.lo + sin.width() / 2.0).atan2(cos.lo + cos.width() / 2.0);
    (off < 0.06).then_some([turn - off, turn + off])
}

/// Sine and cosine of the turns between two (radians).
pub(super) fn sine_and_cosine(lo: f64, hi: f64) -> [Interval; 2] {
    let of = |shift: f64| {
        let (a, b) = (lo + shift, hi + shift);
        // Cosine between two angles: its ends, and where a multiple of π lies between them, that extreme.
        let (p, q) = (a.cos(), b.cos());
        let (mut least, mut most) = (p.min(q) - ROUNDING, p.max(q) + ROUNDING);
        let first = (a / PI).ceil() as i64;
        let last = (b / PI).floor() as i64;
        for k in first..=last {
            if k % 2 == 0 { most = 1.0 } else { least = -1.0 }
        }
        Interval::new(least.max(-1.0), most.min(1.0))
    };
    [of(-FRAC_PI_2), of(0.0)]
}
