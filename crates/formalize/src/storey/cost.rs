//! What is wrong with a plan, as a number: doors that find no wall, rooms that nobody gets to, odd proportions, pipes far
//! apart, ground that nothing uses.

use super::rows::{Cell, Rect};

/// Two rooms that a door joins share at least so much wall (metres).
pub const DOORWAY: f64 = 1.15;
/// Rooms with pipes are next to each other if they share so much wall (metres).
const PIPES: f64 = 0.5;

/// The length of a parked car with the way around it, and the width of a place for one (metres).
const CAR: [f64; 2] = [6.0, 3.2];
/// What a garage costs that no car fits into.
const NO_DRIVE: f64 = 60.0;

/// Which doors a plan has, and what it lacks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ways {
    /// The doors that were added.
    pub doors: Vec<(usize, usize)>,
    /// Doors that were asked for and find no wall.
    pub unmet: usize,
    /// Rooms that nobody gets to, or only through a private one.
    pub unreached: usize,
    /// Private rooms that one gets to through another room than the hub.
    pub roundabout: usize,
}

/// The doors of a plan: those that are asked for, and as few others as lead to all rooms.
pub fn ways(cells: &[Cell], rects: &[Rect], hub: usize, links: &[(usize, usize)]) -> Ways {
    let mut out = Ways::default();
    let wide = |a: usize, b: usize| rects[a].shared(&rects[b]) >= DOORWAY;
    let met: Vec<(usize, usize)> = links.iter().copied().filter(|(a, b)| wide(*a, *b)).collect();
    out.unmet = links.len() - met.len();
    let mut reached = vec![false; cells.len()];
    reached[hub] = true;
    let passes = |room: usize, to: usize| room == hub || !cells[room].private || cells[to].own == Some(room);
    let close = |reached: &mut [bool]| {
        for _ in 0..cells.len() {
            for (a, b) in &met {
                for (from, to) in [(*a, *b), (*b, *a)] {
                    reached[to] |= reached[from] && passes(from, to);
                }
            }
        }
    };
    close(&mut reached);
    // Those beside the hub first, then those behind them.
    for direct in [true, false] {
        for room in 0..cells.len() {
            if reached[room] || cells[room].own.is_some() {
                continue;
            }
            let from = (0..cells.len()).filter(|from| reached[*from] && passes(*from, room) && wide(*from, room));
            let from = from.filter(|from| !direct || *from == hub).min_by_key(|from| (*from != hub, *from));
            let Some(from) = from else { continue };
            out.roundabout += usize::from(from != hub && cells[room].private);
            out.doors.push((from, room));
            reached[room] = true;
            close(&mut reached);
        }
    }
    out.unreached = reached.iter().filter(|reached| !**reached).count();
    out
}

/// How bad a plan is.
pub fn cost(cells: &[Cell], rects: &[Rect], hub: usize, links: &[(usize, usize)]) -> f64 {
    let ways = ways(cells, rects, hub, links);
    let mut out = 200.0 * ways.unreached as f64 + 80.0 * ways.unmet as f64 + 40.0 * ways.roundabout as f64;
    for (room, (cell, rect)) in cells.iter().zip(rects).enumerate() {
        if cell.fixed.is_none() {
            out += shape(cell, rect, room == hub);
        }
        if cell.garage && !has_drive(rect, rects) {
            out += NO_DRIVE;
        }
    }
    out + pipes(cells, rects) + outline(rects)
}

/// What is odd about the shape of a room.
fn shape(cell: &Cell, rect: &Rect, hub: bool) -> f64 {
    let [w, d] = rect.size;
    let (long, short) = (w.max(d), w.min(d));
    let area = w * d;
    if cell.hall {
        return 0.5 * area + 20.0 * (long / short / 5.0 - 1.0).max(0.0);
    }
    let even = match (cell.wet, hub) {
        (true, _) => 1.8,
        (false, true) => 1.6,
        _ => 1.4,
    };
    // Who sits in a passage has no living room.
    let weight = if cell.shared { 24.0 } else { 14.0 };
    let square = |v: f64| v.max(0.0).powi(2);
    let narrow = |least: f64, is: f64| if is < least - 1e-6 { 2.0 + 90.0 * square(least - is) } else { 0.0 };
    weight * square(long / short - even)
        + narrow(cell.sides[0], short)
        + narrow(cell.sides[1], long)
        + 800.0 * square(area / cell.area[1] - 1.0)
        + 30.0 * square(1.0 - area / cell.area[0])
}

/// Whether a car that enters through an outer wall has room behind that wall.
fn has_drive(rect: &Rect, rects: &[Rect]) -> bool {
    let [low, size] = bounds(rects);
    (0..2).any(|axis| {
        let at_low = rect.low[axis] < low[axis] + 0.01;
        let at_high = rect.low[axis] + rect.size[axis] > low[axis] + size[axis] - 0.01;
        (at_low || at_high) && rect.size[axis] >= CAR[0] && rect.size[1 - axis] >= CAR[1]
    })
}

/// What pipes that are far apart cost, and a kitchen that is away from where one eats.
fn pipes(cells: &[Cell], rects: &[Rect]) -> f64 {
    let next = |a: usize, b: usize| rects[a].shared(&rects[b]) >= PIPES;
    let groups = |rooms: &[usize]| {
        let mut left: Vec<usize> = rooms.to_vec();
        let mut groups = 0;
        while let Some(first) = left.pop() {
            groups += 1;
            let mut group = vec![first];
            while let Some(room) = group.pop() {
                let (near, far): (Vec<usize>, Vec<usize>) = left.iter().partition(|other| next(room, **other));
                left = far;
                group.extend(near);
            }
        }
        groups as f64
    };
    let wet: Vec<usize> = (0..cells.len()).filter(|room| cells[*room].wet).collect();
    let common: Vec<usize> = wet.iter().copied().filter(|room| cells[*room].own.is_none()).collect();
    let together = |rooms: &[usize], each: f64| each * (groups(rooms) - 1.0).max(0.0);
    let mut out = together(&wet, 1.5) + together(&common, 40.0);
    let eat: Vec<usize> = (0..cells.len()).filter(|room| cells[*room].shared).collect();
    for kitchen in (0..cells.len()).filter(|room| cells[*room].kitchen && !eat.is_empty()) {
        out += if eat.iter().any(|room| rects[kitchen].shared(&rects[*room]) >= DOORWAY) { 0.0 } else { 4.0 };
    }
    out
}

/// What a straggling outline costs.
fn outline(rects: &[Rect]) -> f64 {
    let bound = |axis: usize| {
        let low = rects.iter().map(|r| r.low[axis]).fold(f64::INFINITY, f64::min);
        rects.iter().map(|r| r.low[axis] + r.size[axis]).fold(f64::NEG_INFINITY, f64::max) - low
    };
    let (w, d) = (bound(0), bound(1));
    let used: f64 = rects.iter().map(|r| (r.size[0] + 0.06) * (r.size[1] + 0.06)).sum();
    let empty = 1.0 - used / ((w + 0.06) * (d + 0.06));
    20.0 * empty.max(0.0) + 30.0 * (w.max(d) / w.min(d) - 1.6).max(0.0).powi(2)
}

/// The outline's width and depth, and its lower corner.
pub fn bounds(rects: &[Rect]) -> [[f64; 2]; 2] {
    let low = [0, 1].map(|axis| rects.iter().map(|r| r.low[axis]).fold(f64::INFINITY, f64::min));
    let high = [0, 1].map(|axis| rects.iter().map(|r| r.low[axis] + r.size[axis]).fold(f64::NEG_INFINITY, f64::max));
    [low, [high[0] - low[0], high[1] - low[1]]]
}
