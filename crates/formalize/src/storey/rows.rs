//! The shapes that a storey may have: the room that leads to the others in the middle, a row of rooms on one or both of its
//! long sides, and at one end a column of rooms as deep as all of it.
//!
//! ```text
//! ┌─────┬────┬───────┬──────┐
//! │     row 0        │ end  │
//! ├─────┴────┴───────┤      │
//! │   hub            ├──────┤
//! ├───────┬──────┬───┤      │
//! │     row 1        │      │
//! └───────┴──────┴───┴──────┘
//! ```
//!
//! Every room but the hub lies at an outer wall, so it can have windows, and all rooms of a row share a wall with the hub.

use crate::arrange::WALL;

/// What a plan has to know of a room.
#[derive(Clone, Debug)]
pub struct Cell {
    /// Square metres: as many as it should have, and at most.
    pub area: [f64; 2],
    /// Its sides are at least so long, the shorter one and the longer one (metres).
    pub sides: [f64; 2],
    /// Width and depth, where they are given.
    pub fixed: Option<[f64; 2]>,
    /// Whether nobody goes through it to get elsewhere.
    pub private: bool,
    /// Whether it has pipes.
    pub wet: bool,
    /// Whether it is there to walk through.
    pub hall: bool,
    /// Whether one cooks there.
    pub kitchen: bool,
    /// Whether one eats or sits there together.
    pub shared: bool,
    /// Whether a car is driven in from outside.
    pub garage: bool,
    /// The room that alone leads to it: of a bathroom its bedroom.
    pub own: Option<usize>,
}

/// A rectangle: its lower corner and its size.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rect {
    /// The corner.
    pub low: [f64; 2],
    /// Along x and z.
    pub size: [f64; 2],
}

impl Rect {
    fn high(&self, axis: usize) -> f64 {
        self.low[axis] + self.size[axis]
    }

    /// How long the wall is that two share.
    pub fn shared(&self, other: &Self) -> f64 {
        let gap = |axis: usize| (self.low[axis] - other.high(axis)).max(other.low[axis] - self.high(axis));
        let [x, z] = [gap(0), gap(1)];
        if (x - WALL).abs() < 1e-3 {
            (-z).max(0.0)
        } else if (z - WALL).abs() < 1e-3 {
            (-x).max(0.0)
        } else {
            0.0
        }
    }
}

/// Which rooms are where.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Order {
    /// On the two sides of the hub and at its end, by index.
    pub rows: [Vec<usize>; 3],
}

/// The shallowest and the deepest row (metres).
const DEPTHS: [f64; 2] = [1.5, 9.0];

fn rounded(v: f64) -> f64 {
    (v * 100.0).round() / 100.0
}

/// How wide a room of a row is that is so deep.
fn width(cell: &Cell, depth: f64) -> f64 {
    match cell.fixed {
        Some([w, _]) => w,
        None => (cell.area[0] / depth).max(cell.sides[0]),
    }
}

/// How long a row of such a depth is.
fn length(cells: &[Cell], row: &[usize], depth: f64) -> f64 {
    row.iter().map(|room| width(&cells[*room], depth)).sum::<f64>() + WALL * row.len().saturating_sub(1) as f64
}

/// The depth at which a row is so long; `None`: it is too long at any depth, or nothing of it can be stretched.
fn depth_for(cells: &[Cell], row: &[usize], long: f64) -> Option<f64> {
    if row.iter().all(|room| cells[*room].fixed.is_some()) {
        return None;
    }
    let [mut low, mut high] = DEPTHS;
    if length(cells, row, high) > long {
        return None;
    }
    for _ in 0..24 {
        let middle = (low + high) / 2.0;
        if length(cells, row, middle) > long { low = middle } else { high = middle }
    }
    Some(high)
}

/// Where rooms are when row 0 is so deep; `None` where that cannot be.
pub fn place(cells: &[Cell], hub: usize, order: &Order, depth: f64) -> Option<Vec<Rect>> {
    let [first, second, end] = &order.rows;
    let fixed_depth =
        |row: &[usize]| row.iter().filter_map(|room| cells[*room].fixed).map(|[_, d]| d).fold(0.0, f64::max);
    // A row of given sizes is as long as it is.
    let rigid = |row: &[usize]| row.iter().all(|room| cells[*room].fixed.is_some());
    let own = &cells[hub];
    let long = match own.fixed {
        _ if !rigid(first) => length(cells, first, depth),
        _ if !rigid(second) && !second.is_empty() => length(cells, second, depth),
        Some([w, _]) => w,
        None => length(cells, first, 1.0).max(length(cells, second, 1.0)).max(own.sides[1]),
    };
    // A room that is more than a hall keeps its usual least width.
    let long = if own.hall || own.fixed.is_some() { long } else { long.max(own.sides[0]) };
    let long = rounded(long);
    let depths = [first, second].map(|row| match depth_for(cells, row, long) {
        Some(depth) => rounded(depth),
        None => rounded(fixed_depth(row)),
    });
    let stretched = |row: &[usize]| row.is_empty() || rigid(row) || depth_for(cells, row, long).is_some();
    if !stretched(first) || !stretched(second) {
        return None;
    }
    let [hub_w, hub_d] = match own.fixed {
        Some(size) => size,
        None if own.hall => [long, own.sides[0]],
        None => [long, (own.area[0] / long).max(own.sides[0])],
    }
    .map(rounded);
    let mut out = vec![Rect::default(); cells.len()];
    out[hub] = Rect { low: [0.0, 0.0], size: [hub_w, hub_d] };
    for (row, (rooms, row_depth)) in [first, second].into_iter().zip(depths).enumerate() {
        let mut x = 0.0;
        for (k, room) in rooms.iter().enumerate() {
            let cell = &cells[*room];
            let last = k + 1 == rooms.len() && !rigid(rooms);
            let (mut w, d) = match cell.fixed {
                Some([w, d]) => (w, d),
                None => (rounded(width(cell, row_depth)), row_depth),
            };
            if last && cell.fixed.is_none() {
                w = rounded(long - x);
            }
            let z = if row == 0 { hub_d + WALL } else { -WALL - d };
            out[*room] = Rect { low: [x, z], size: [w, d] };
            x += w + WALL;
        }
    }
    if !end.is_empty() {
        column(cells, end, &mut out, (long.max(hub_w), hub_d, depths))?;
    }
    Some(out)
}

/// Places the rooms at the end of the hub.
fn column(cells: &[Cell], end: &[usize], out: &mut [Rect], (long, hub_d, depths): (f64, f64, [f64; 2])) -> Option<()> {
    if end.iter().any(|room| cells[*room].fixed.is_some()) {
        return None;
    }
    let beside = depths.map(|d| if d > 0.0 { d + WALL } else { 0.0 });
    let deep = beside[0] + hub_d + beside[1];
    let area: f64 = end.iter().map(|room| cells[*room].area[0]).sum();
    let free = deep - WALL * (end.len() as f64 - 1.0);
    let wide = rounded((area / free).max(end.iter().map(|room| cells[*room].sides[0]).fold(0.0, f64::max)));
    let mut z = -beside[1];
    for (k, room) in end.iter().enumerate() {
        // By their areas, but none narrower than such rooms are.
        let least = cells[*room].sides[0];
        let others: f64 = end[k + 1..].iter().map(|other| cells[*other].sides[0] + WALL).sum();
        let most = (hub_d + beside[0] - z - others).max(least);
        let mut d = rounded((free * cells[*room].area[0] / area).clamp(least, most));
        if k + 1 == end.len() {
            d = rounded(hub_d + beside[0] - z);
        }
        out[*room] = Rect { low: [long + WALL, z], size: [wide, d] };
        z += d + WALL;
    }
    Some(())
}
