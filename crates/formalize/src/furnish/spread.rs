//! Several like things that stand free are spread evenly over the floor that is left: in lines and columns, as far from each
//! other and from what is around them as there is room for.

use super::choose::Choice;
use super::floor::{Block, Floor, Pose, Shape};
use super::seek;

/// So much is free at the walls, and at least so much between two of them (metres).
const WALLS: f64 = 0.6;
const WAY: f64 = 0.6;
/// So many distances from one to the next are tried, and so many places of the whole; more of them where none of these will do.
const STEPS: [usize; 2] = [4, 8];
const SHIFTS: [i32; 2] = [2, 5];
/// Of the arrangements so many are held against the ways.
const TRIED: usize = 8;
/// Of fewer, each finds a place by itself.
const SEVERAL: usize = 4;
/// A wall is as good as something that is so much nearer (metres).
const NEARER: f64 = 0.5;
/// No more than this are spread, and no floor is emptier than this around a thing.
const MOST: usize = 8;
/// In a lattice, no more than this.
const MOST_IN_LATTICE: usize = 20;
const FAR: f64 = 2.5;
/// A metre off the middle is worth so much room.
const OFF: f64 = 0.1;

/// Places in a line: the first of them and the distance from each to the next; more finely the second time.
fn lines(length: f64, cell: f64, n: usize, time: usize) -> Vec<(f64, f64)> {
    let free = length - 2.0 * WALLS - cell;
    let between = (n - 1) as f64;
    if free < -1e-9 || n > 1 && free < between * (cell + WAY) {
        return Vec::new();
    }
    let steps = if n > 1 { STEPS[time] } else { 1 };
    let shifts = SHIFTS[time];
    let mut out = Vec::new();
    for i in 0..steps {
        let (widest, least) = if n > 1 { (free / between, cell + WAY) } else { (0.0, 0.0) };
        let step = widest - (widest - least) * i as f64 / STEPS[time] as f64;
        let slack = free - step * between;
        for k in -shifts..=shifts {
            out.push((slack * f64::from(k) / f64::from(2 * shifts) - step * between / 2.0, step));
            if slack < 0.05 {
                break;
            }
        }
    }
    out
}

impl Choice<'_> {
    /// The places of so many groups; none if there is no room for all of them.
    pub fn spread(&self, floor: &Floor, shape: &Shape, n: usize, yaws: &[f64]) -> Option<Vec<Pose>> {
        if !(2..=MOST_IN_LATTICE).contains(&n) || self.near.is_some() {
            return None;
        }
        let times: &[usize] = match n {
            _ if n > MOST => &[],
            _ if n < SEVERAL => &[0],
            _ => &[0, 1],
        };
        let all = times.iter().find_map(|time| self.spread_once(floor, shape, (n, yaws), *time));
        all.or_else(|| if n < SEVERAL { None } else { self.lattice(floor, shape, (n, yaws)) })
    }

    /// The same at places of a lattice, some of which are taken or not needed.
    fn lattice(&self, floor: &Floor, shape: &Shape, (n, yaws): (usize, &[f64])) -> Option<Vec<Pose>> {
        let counts = (2..=n).flat_map(|columns| {
            let rows = n.div_ceil(columns)..=(2 * n + 2) / columns;
            rows.filter(|rows| *rows > 1).map(move |rows| [columns, rows])
        });
        let arrangements =
            counts.flat_map(|counts| yaws.iter().flat_map(move |yaw| grids(floor, shape, *yaw, counts, 0)));
        let found = arrangements.filter_map(|(gaps, mut places)| {
            places.retain(|at| floor.fits(shape, at) && !self.is_misplaced(at));
            if places.len() < n {
                return None;
            }
            // Those that are nearest to something are left out.
            let room = |at: &Pose| self.room(floor, shape, std::slice::from_ref(at));
            places.sort_by_cached_key(|at| std::cmp::Reverse((room(at) * 1000.0) as i64));
            places.truncate(n);
            Some((places.last().map_or(0.0, room).min(gaps[0]).min(gaps[1]), places))
        });
        best(floor, shape, found.collect())
    }

    fn spread_once(&self, floor: &Floor, shape: &Shape, (n, yaws): (usize, &[f64]), time: usize) -> Option<Vec<Pose>> {
        // No line is short by more than one.
        let counts = (1..=n).map(|columns| [columns, n.div_ceil(columns)]);
        let counts = counts.filter(|[columns, rows]| columns * rows - n <= 1);
        let arrangements =
            yaws.iter().flat_map(|yaw| counts.clone().flat_map(move |counts| grids(floor, shape, *yaw, counts, time)));
        let found = arrangements.filter_map(|(gaps, mut places)| {
            places.truncate(n);
            if !places.iter().all(|at| floor.fits(shape, at) && !self.is_misplaced(at)) {
                return None;
            }
            // Of like arrangements the one about the middle.
            let middle = |of: fn(&Pose) -> f64| places.iter().map(of).sum::<f64>() / n as f64;
            let off = middle(|at| at.x).abs() + middle(|at| at.z).abs();
            let room = self.room(floor, shape, &places).min(gaps[0]).min(gaps[1]);
            // A mat is lain on: not where one stands before something else.
            let flat = self.size[1] < 0.05;
            let is_trodden = |at: &Pose| flat && floor.keeps_free(&Block::of(at, self.size));
            let trodden = if places.iter().any(is_trodden) { FAR } else { 0.0 };
            Some((room - OFF * off - trodden, places))
        });
        best(floor, shape, found.collect())
    }

    /// The least room around one of the places.
    fn room(&self, floor: &Floor, shape: &Shape, places: &[Pose]) -> f64 {
        let [w, _, d] = floor.size;
        let own = |at: &Pose| {
            let block = around(shape, at.yaw);
            let to_walls = (w / 2.0 - (at.x + block.high[0]).max(-at.x - block.low[0]))
                .min(d / 2.0 - (at.z + block.high[2]).max(-at.z - block.low[2]));
            floor.room_around(shape, at).min(to_walls + NEARER)
        };
        places.iter().map(own).fold(FAR, f64::min)
    }
}

/// Arrangements in so many columns and rows: how far apart two are in each, and all places.
fn grids(
    floor: &Floor,
    shape: &Shape,
    yaw: f64,
    [columns, rows]: [usize; 2],
    time: usize,
) -> Vec<([f64; 2], Vec<Pose>)> {
    let [w, _, d] = floor.size;
    let own = around(shape, yaw);
    let cell = [own.high[0] - own.low[0], own.high[2] - own.low[2]];
    let off = [(own.low[0] + own.high[0]) / 2.0, (own.low[2] + own.high[2]) / 2.0];
    let gap = |n: usize, step: f64, cell: f64| if n > 1 { step - cell } else { FAR };
    let mut out = Vec::new();
    for (x, step_x) in lines(w, cell[0], columns, time) {
        for (z, step_z) in lines(d, cell[1], rows, time) {
            let at = |i: usize| {
                let (column, row) = ((i % columns) as f64, (i / columns) as f64);
                Pose { x: x + step_x * column - off[0], y: 0.0, z: z + step_z * row - off[1], yaw }
            };
            let gaps = [gap(columns, step_x, cell[0]), gap(rows, step_z, cell[1])];
            out.push((gaps, (0..columns * rows).map(at).collect()));
        }
    }
    out
}

/// The best arrangement that leaves a way to all of its places and to everything else.
fn best(floor: &Floor, shape: &Shape, mut found: Vec<(f64, Vec<Pose>)>) -> Option<Vec<Pose>> {
    found.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    found.into_iter().take(TRIED).map(|(_, places)| places).find(|places| floor.leaves_ways_to_all(shape, places))
}

/// What a group takes around its first thing when it is turned so.
fn around(shape: &Shape, yaw: f64) -> Block {
    let [left, right, back, front] = seek::reach(shape);
    let middle = Pose { x: (right - left) / 2.0, z: (front - back) / 2.0, ..Pose::default() };
    Block::of(&Pose { yaw, ..Pose::default() }.then(&middle), [left + right, 0.1, back + front])
}
