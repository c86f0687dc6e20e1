//! Where corridors go: one search over square cells from the object where they begin, to all that is to be reached.
//! What can be moved is walked through at a price, so that a plan asks for as little as possible to be moved.

use super::Branch;
use crate::trial::{Field, Inputs, Span, Trial};
use scenelang_verify::coded::Flat;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// How near to a thing is there (metres).
pub(super) const NEAR: f64 = 0.05;
/// A grid has about so many cells, none smaller than this (metres).
const CELLS: f64 = 10_000.0;
const CELL: f64 = 0.05;
/// Half the width of a path is about so many cells: finer ones only cost more.
const FINE: f64 = 5.0;
/// How many metres of detour one takes rather than move a thing, and per metre that it reaches in.
const DETOUR: [f64; 2] = [3.0, 15.0];
/// The same for what cannot be moved.
const BARRED: f64 = 300.0;
/// How much of a cell lies at most between its middle and where a corridor ends in it: half of its diagonal.
const ACROSS: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// Work that a plan takes, per cell.
const WORK: u64 = 4;
/// How often the bends of a plan are pushed away from what is beside them, and how much room they are to keep (metres).
const PUSHES: usize = 12;
const SPARE: f64 = 0.02;
/// Bends of less than this are none (metres).
const STRAIGHT: f64 = 0.015;
const UNSEEN: u32 = u32::MAX;

impl Trial<'_> {
    /// Corridors of a width from an object to one of the goals of each target, as branches of one tree; of a target that
    /// cannot be reached the branch is empty.
    pub(super) fn corridors(&mut self, index: usize) -> Vec<Branch> {
        let group = &self.groups[index];
        let (radius, near) = (group.width(), group.radius + NEAR / 2.0);
        let none = |goals: &[usize]| Branch { goal: goals[0], is_rooted: false, bends: Vec::new() };
        let Some(grid) = Grid::new(self, radius) else {
            return group.targets.iter().map(|goals| none(goals)).collect();
        };
        self.work += WORK * grid.count() as u64;
        let floor = self.floor_of_cells(&grid, radius);
        let cost = self.cost_of_cells(&grid, radius, &floor);
        self.floors.push(floor);
        let group = &self.groups[index];
        let from = self.around(&grid, group.from, near, radius);
        let mut ends: Vec<End> = Vec::new();
        for (target, goals) in group.targets.iter().enumerate() {
            for &goal in goals {
                ends.extend(self.around(&grid, goal, near, radius).into_iter().map(|cell| End { cell, target, goal }));
            }
        }
        ends.sort_unstable();
        let tree = grid.tree(&cost, &from, &ends, group.targets.len());
        // Where exactly a corridor begins or ends in a cell.
        let touch = |j: usize, cell: usize| self.flat(j).away(grid.middle(cell), near);
        let beside: Vec<Flat> = (0..self.count()).filter(|&j| self.is_in_the_way(j)).map(|j| self.flat(j)).collect();
        let mut used = vec![false; grid.count()];
        let mut steps: Vec<Flat> = Vec::new();
        let mut branches: Vec<Branch> = group.targets.iter().map(|goals| none(goals)).collect();
        // Near ones first: those beyond go on from there.
        for &End { target, cell: last, goal } in &tree.reached {
            let mut cells = vec![last];
            while let Some(before) = tree.before(cells[cells.len() - 1]).filter(|_| !used[cells[cells.len() - 1]]) {
                cells.push(before);
            }
            cells.reverse();
            cells.iter().for_each(|&c| used[c] = true);
            let first = grid.middle(cells[0]);
            let joins = nearest(&steps, first);
            let is_rooted = tree.before(cells[0]).is_none();
            let root = touch(group.from, cells[0]);
            let mut path: Vec<[f64; 2]> = vec![if is_rooted { root } else { joins.unwrap_or(root) }];
            path.extend(cells.iter().map(|c| grid.middle(*c)));
            path.push(touch(goal, last));
            self.push_aside(&mut path, radius, &beside);
            let bends = simplified(&path);
            steps.extend(bends.windows(2).map(|pair| step(pair[0], pair[1])));
            branches[target] = Branch { goal, is_rooted, bends };
        }
        branches
    }

    /// Cells in which a disc on the floor is so far from a thing.
    fn around(&self, grid: &Grid, j: usize, far: f64, radius: f64) -> Vec<usize> {
        let flat = self.flat(j);
        let mut cells: Vec<usize> = grid.around(&self.span[j], far + grid.cell).collect();
        cells.retain(|&c| {
            let middle = grid.middle(c);
            let off = flat.distance(middle);
            off > 0.0 && (off - far).abs() <= ACROSS * grid.cell && self.is_floor(flat.away(middle, far), radius, 0.0)
        });
        cells
    }

    /// What it costs to walk through each cell where nothing stands, per metre; infinite where there is no floor. Rooms do not
    /// change, and doors hardly ever, so it is worked out once.
    fn floor_of_cells(&mut self, grid: &Grid, radius: f64) -> Floor {
        let doors = self.door_places();
        self.floors.retain(|floor| floor.doors == doors);
        if let Some(at) = self.floors.iter().position(|floor| floor.radius == radius) {
            return self.floors.swap_remove(at);
        }
        let floor = |c: usize| if self.is_floor(grid.middle(c), radius, grid.cell) { 1.0 } else { f64::INFINITY };
        Floor { radius, doors, cost: (0..grid.count()).map(floor).collect() }
    }

    /// What it costs to walk through each cell, per metre; infinite where there is no floor.
    fn cost_of_cells(&self, grid: &Grid, radius: f64, floor: &Floor) -> Vec<f64> {
        let mut cost = floor.cost.clone();
        for j in (0..self.count()).filter(|&j| self.is_in_the_way(j)) {
            let flat = self.flat(j);
            let [base, per] = if self.is_movable(j) { DETOUR } else { [BARRED; 2] };
            let base = base * (1.0 + self.reluctance[j]);
            for c in grid.around(&self.span[j], radius) {
                let lack = radius - flat.distance(grid.middle(c));
                if lack > 0.0 {
                    cost[c] += base / radius.max(0.1) + per * lack;
                }
            }
        }
        cost
    }

    /// Whether a disc fits on the floor there, in a room or in a doorway.
    fn is_floor(&self, p: [f64; 2], radius: f64, ease: f64) -> bool {
        self.rooms.iter().any(|room| room.depth(p) >= radius) || self.in_doorway(p, radius, ease)
    }

    fn in_doorway(&self, p: [f64; 2], radius: f64, ease: f64) -> bool {
        self.doors.iter().any(|&j| {
            let flat = self.flat(j);
            let [u, v] = flat.local(p);
            let play = flat.half[0] - radius;
            play >= 0.0 && u.abs() <= play + ease && v.abs() <= flat.half[1] + self.doorway + radius + ease
        })
    }

    /// Pushes the bends of a corridor away from what is beside them.
    fn push_aside(&self, path: &mut [[f64; 2]], radius: f64, beside: &[Flat]) {
        let wanted = radius + SPARE;
        let around = surround(path, wanted);
        let near = |flat: &&Flat| {
            let reach = flat.half[0] + flat.half[1];
            (0..2).all(|k| flat.at[k] + reach > around[0][k] && flat.at[k] - reach < around[1][k])
        };
        let beside: Vec<&Flat> = beside.iter().filter(near).collect();
        for _ in 0..PUSHES {
            for at in 1..path.len().saturating_sub(1) {
                let here = path[at];
                let mut next = here;
                for flat in &beside {
                    let off = flat.distance(here);
                    if off > 0.0 && off < wanted {
                        let away = flat.away(here, wanted);
                        (0..2).for_each(|k| next[k] += (away[k] - here[k]) / 2.0);
                    }
                }
                // Not far from its neighbours either.
                (0..2).for_each(|k| next[k] += 0.1 * ((path[at - 1][k] + path[at + 1][k]) / 2.0 - here[k]));
                if self.is_floor(next, radius, 0.0) || !self.is_floor(here, radius, 0.0) {
                    path[at] = next;
                }
            }
        }
        for p in path.iter_mut() {
            for &j in &self.doors {
                let flat = self.flat(j);
                let [u, v] = flat.local(*p);
                let play = flat.half[0] - radius;
                if play >= 0.0 && v.abs() <= flat.half[1] + self.doorway && u.abs() <= flat.half[0] {
                    *p = flat.point([u.clamp(-play, play), v]);
                }
            }
        }
    }

    /// Where doors are: corridors lead through them.
    pub(super) fn door_places(&self) -> Vec<[f64; 3]> {
        let place = |&j: &usize| {
            let [x, _, z, yaw, ..]: Inputs = self.inputs(j);
            [x, z, yaw]
        };
        self.doors.iter().map(place).collect()
    }
}

/// The least and the greatest x and z of what is so far around points.
fn surround(path: &[[f64; 2]], far: f64) -> [[f64; 2]; 2] {
    let least = [0, 1].map(|k| path.iter().map(|p| p[k]).fold(f64::INFINITY, f64::min) - far);
    [least, [0, 1].map(|k| path.iter().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max) + far)]
}

/// Without bends that hardly are any (Douglas and Peucker's way).
fn simplified(path: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let (Some(&first), Some(&last)) = (path.first(), path.last()) else { return Vec::new() };
    let line = step(first, last);
    let off = |p: &[f64; 2]| line.distance(*p);
    let farthest = (1..path.len().saturating_sub(1)).max_by(|&a, &b| off(&path[a]).total_cmp(&off(&path[b])));
    match farthest.filter(|&k| off(&path[k]) > STRAIGHT) {
        Some(bend) => {
            let mut out = simplified(&path[..=bend]);
            out.pop();
            out.extend(simplified(&path[bend..]));
            out
        }
        None => vec![first, last],
    }
}

/// The point of some segments that is nearest to a point.
fn nearest(steps: &[Flat], p: [f64; 2]) -> Option<[f64; 2]> {
    let far = |q: &[f64; 2]| (q[0] - p[0]).powi(2) + (q[1] - p[1]).powi(2);
    steps.iter().map(|step| on_step(step, p)).min_by(|a, b| far(a).total_cmp(&far(b)))
}

/// A segment as a rectangle without width.
pub(super) fn step(from: [f64; 2], to: [f64; 2]) -> Flat {
    let along = [to[0] - from[0], to[1] - from[1]];
    let length = (along[0] * along[0] + along[1] * along[1]).sqrt().max(1e-12);
    let at = [0, 1].map(|k| (from[k] + to[k]) / 2.0);
    Flat { at, turn: [along[0] / length, along[1] / length], half: [0.0, length / 2.0] }
}

/// The point of a segment that is nearest to a point.
fn on_step(step: &Flat, p: [f64; 2]) -> [f64; 2] {
    let [_, v] = step.local(p);
    step.point([0.0, v.clamp(-step.half[1], step.half[1])])
}

/// Where there is floor for a disc of a radius, with doors where they are.
#[derive(Clone, Debug)]
pub(in crate::trial) struct Floor {
    radius: f64,
    doors: Vec<[f64; 3]>,
    cost: Vec<f64>,
}

/// Square cells over all rooms.
struct Grid {
    from: [f64; 2],
    cell: f64,
    size: [usize; 2],
}

/// A cell in which a target is reached, at one of its goals.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct End {
    cell: usize,
    target: usize,
    goal: usize,
}

/// The cheapest paths from where a search began.
struct Tree {
    before: Vec<u32>,
    /// Where targets are reached; the nearest first.
    reached: Vec<End>,
}

impl Tree {
    fn before(&self, cell: usize) -> Option<usize> {
        Some(self.before[cell]).filter(|c| *c != UNSEEN).map(|c| c as usize)
    }
}

impl Grid {
    /// For paths of half such a width.
    fn new(local: &Trial<'_>, radius: f64) -> Option<Self> {
        let field = local.rooms.iter().map(|room| room.field).reduce(Field::join)?;
        let [w, d] = [0, 1].map(|k| field.max[k] - field.min[k]);
        let cell = (w * d / CELLS).sqrt().max(CELL).max(radius / FINE);
        let size = [w, d].map(|m| (m / cell).ceil().max(1.0) as usize);
        (w.is_finite() && d.is_finite()).then_some(Self { from: field.min, cell, size })
    }
    pub fn count(&self) -> usize {
        self.size[0] * self.size[1]
    }
    fn middle(&self, c: usize) -> [f64; 2] {
        let at = [c % self.size[0], c / self.size[0]];
        [0, 1].map(|k| self.from[k] + (at[k] as f64 + 0.5) * self.cell)
    }
    /// Cells whose middle may be so near to a span.
    fn around(&self, span: &Span, reach: f64) -> impl Iterator<Item = usize> + use<> {
        let index = |k: usize, value: f64| {
            (((value - self.from[k]) / self.cell).floor().max(0.0) as usize).min(self.size[k] - 1)
        };
        let (x0, x1) = (index(0, span.min[0] - reach), index(0, span.max[0] + reach));
        let (z0, z1) = (index(1, span.min[2] - reach), index(1, span.max[2] + reach));
        let row = self.size[0];
        (z0..=z1).flat_map(move |z| (x0..=x1).map(move |x| z * row + x))
    }
    /// The cheapest paths from some cells to one of the ends of each target (Dijkstra's algorithm). Ends are sorted.
    fn tree(&self, cost: &[f64], from: &[usize], ends: &[End], targets: usize) -> Tree {
        let mut far = vec![f64::INFINITY; cost.len()];
        let mut tree = Tree { before: vec![UNSEEN; cost.len()], reached: Vec::new() };
        let mut is_end = vec![false; cost.len()];
        ends.iter().for_each(|end| is_end[end.cell] = true);
        let mut found = vec![false; targets];
        let mut open = BinaryHeap::new();
        // Costs as whole micrometres, then the cell, in one number: they are compared fast, and alike on every machine.
        let bits = usize::BITS - cost.len().leading_zeros();
        let key = |metres: f64, c: usize| ((metres * 1e6) as u64).min(u64::MAX >> bits) << bits | c as u64;
        for &c in from.iter().filter(|&&c| cost[c].is_finite()) {
            far[c] = 0.0;
            open.push(Reverse(key(0.0, c)));
        }
        while let Some(Reverse(least)) = open.pop() {
            let c = (least & ((1 << bits) - 1)) as usize;
            if least > key(far[c], c) {
                continue;
            }
            if is_end[c] {
                let first = ends.partition_point(|end| end.cell < c);
                for end in ends[first..].iter().take_while(|end| end.cell == c) {
                    if !std::mem::replace(&mut found[end.target], true) {
                        tree.reached.push(*end);
                    }
                }
                if tree.reached.len() == targets {
                    break;
                }
            }
            let (x, z) = ((c % self.size[0]) as i64, (c / self.size[0]) as i64);
            for (dx, dz) in [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)] {
                let (i, j) = (x + dx, z + dz);
                if i < 0 || j < 0 || i >= self.size[0] as i64 || j >= self.size[1] as i64 {
                    continue;
                }
                let next = j as usize * self.size[0] + i as usize;
                let length = if dx != 0 && dz != 0 { std::f64::consts::SQRT_2 } else { 1.0 } * self.cell;
                let there = far[c] + length * (cost[c] + cost[next]) / 2.0;
                if there < far[next] {
                    far[next] = there;
                    tree.before[next] = c as u32;
                    open.push(Reverse(key(there, next)));
                }
            }
        }
        tree
    }
}
