//! `reachable` on boxes: for each way that is asked for a corridor is planned through what can be moved, and what then
//! stands in it costs. So a search learns what to move out of the way; whether there is a way is asked of the
//! evaluator in the end.

use super::{Judge, Quick, Span};
use crate::merit;
use crate::pool::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_lang::program::{Arg, Formula, Native, Node};
use scenelang_verify::World;
use scenelang_verify::coded::Flat;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// What reaches no higher above the floor is stepped over, what begins higher is walked under (metres).
const IN_THE_WAY: [f64; 2] = [0.05, 2.0];
/// How near to a thing is there (metres).
const NEAR: f64 = 0.05;
/// A grid has about so many cells, none smaller than this (metres).
const CELLS: f64 = 10_000.0;
const CELL: f64 = 0.05;
/// How many metres of detour one takes rather than move a thing, and per metre that it reaches in.
const DETOUR: [f64; 2] = [3.0, 15.0];
/// The same for what cannot be moved.
const BARRED: f64 = 300.0;
/// Work that a plan takes, per cell.
const WORK: u64 = 4;
/// How often the bends of a plan are pushed away from what is beside them, and how much room they are to keep (metres).
const PUSHES: usize = 12;
const SPARE: f64 = 0.01;

/// A way that is asked for.
#[derive(Clone, Debug)]
pub(super) struct Way {
    ends: [usize; 2],
    radius: f64,
    /// Bends of the corridor; empty: none is planned yet.
    path: Vec<[f64; 2]>,
    /// Where doors were when it was planned.
    doors: Vec<[f64; 3]>,
    /// How much wider than asked for it is planned, since what was planned proved too narrow (metres).
    doubt: f64,
}

impl Way {
    /// What a formula says, if it is a `reachable` of constant width.
    pub fn of(formula: &Formula, world: &World<f64>) -> Option<Self> {
        let Node::Native(Native::Reachable, args) = formula.root_node() else { return None };
        let [Arg::Object(a), Arg::Object(b), Arg::Value(width)] = args[..] else { return None };
        let Node::Number(width) = *formula.node(width) else { return None };
        let radius = ((width - world.options.tolerances.contact) / 2.0).max(0.0);
        let ends = [a.0 as usize, b.0 as usize];
        Some(Self { ends, radius, path: Vec::new(), doors: Vec::new(), doubt: 0.0 })
    }
    fn width(&self) -> f64 {
        self.radius + self.doubt
    }
    fn steps(&self) -> impl Iterator<Item = Flat> + '_ {
        self.path.windows(2).map(|pair| {
            let way = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
            let length = way[0].hypot(way[1]).max(1e-12);
            let at = [0, 1].map(|k| (pair[0][k] + pair[1][k]) / 2.0);
            Flat { at, turn: [way[0] / length, way[1] / length], half: [0.0, length / 2.0] }
        })
    }
    /// Whether something could stand in it.
    pub fn meets(&self, span: &Span) -> bool {
        let r = self.width();
        self.path.windows(2).any(|p| {
            p[0][0].min(p[1][0]) - r < span.max[0]
                && p[0][0].max(p[1][0]) + r > span.min[0]
                && p[0][1].min(p[1][1]) - r < span.max[2]
                && p[0][1].max(p[1][1]) + r > span.min[2]
        })
    }
}

impl Quick<'_> {
    fn is_in_the_way(&self, j: usize) -> bool {
        let span = &self.span[j];
        !self.doors.contains(&j) && span.min[1] < self.floor + IN_THE_WAY[1] && span.max[1] > self.floor + IN_THE_WAY[0]
    }

    fn door_places(&self) -> Vec<[f64; 3]> {
        let place = |&j: &usize| {
            let [x, _, z, yaw, ..] = self.inputs(j);
            [x, z, yaw]
        };
        self.doors.iter().map(place).collect()
    }

    /// What a way costs, and whether nothing stands in its corridor.
    pub(super) fn way(&mut self, index: usize) -> (f64, bool) {
        let way = &self.ways[index];
        self.work += 4 + (way.path.len() + self.size.len()) as u64 / 4;
        if way.path.is_empty() {
            return (0.0, true);
        }
        if way.doors != self.door_places() {
            return (merit::BASE + 1.0, false);
        }
        let mut cost = 0.0;
        for j in 0..self.count() {
            if way.meets(&self.span[j]) && self.is_in_the_way(j) {
                cost += merit::cost(true, 0.0) + self.reaches_in(way, j);
            }
        }
        for (end, at) in [(way.ends[0], way.path.first()), (way.ends[1], way.path.last())] {
            let off = at.map_or(0.0, |p| self.off(end, *p)) - way.radius - NEAR;
            cost += if off > 0.0 { merit::cost(false, off) } else { 0.0 };
        }
        (cost, cost == 0.0)
    }

    /// What it costs that an object stands in a corridor.
    fn reaches_in(&self, way: &Way, j: usize) -> f64 {
        let flat = self.flat(j);
        let least = way.steps().map(|step| step.gap(&flat)).fold(f64::INFINITY, f64::min);
        let lack = way.width() - least;
        if lack > 0.0 { merit::cost(false, lack) } else { 0.0 }
    }

    /// How far an object is from a point.
    fn off(&self, j: usize, p: [f64; 2]) -> f64 {
        self.flat(j).distance(p)
    }

    /// Something that a way would be better without, or one of its ends where those are off it.
    pub(super) fn hindrance(&self, index: usize, chance: &mut ChaCha8Rng) -> Option<usize> {
        let way = &self.ways[index];
        let movable = |j: &usize| self.is_movable(*j);
        let blocks = |j: &usize| way.meets(&self.span[*j]) && self.is_in_the_way(*j) && self.reaches_in(way, *j) > 0.0;
        let mut found: Vec<usize> = (0..self.count()).filter(|j| movable(j) && blocks(j)).collect();
        for (end, at) in [(way.ends[0], way.path.first()), (way.ends[1], way.path.last())] {
            if movable(&end) && at.is_some_and(|p| self.off(end, *p) > way.radius + NEAR) {
                found.push(end);
            }
        }
        (!found.is_empty()).then(|| found[chance.below(found.len())])
    }

    /// Plans all ways anew.
    pub(super) fn plan_all(&mut self) {
        for index in 0..self.ways.len() {
            self.ways[index].path = self.plan(index);
            self.ways[index].doors = self.door_places();
        }
    }

    /// Plans a way anew, and keeps that where it costs less.
    pub(super) fn plan_again(&mut self, index: usize) -> (f64, bool) {
        let before = self.way(index);
        let path = self.plan(index);
        let doors = self.door_places();
        let old = std::mem::replace(&mut self.ways[index].path, path);
        let old_doors = std::mem::replace(&mut self.ways[index].doors, doors);
        let after = self.way(index);
        if after.0 < before.0 {
            return after;
        }
        self.ways[index].path = old;
        self.ways[index].doors = old_doors;
        before
    }

    /// Ways that were thought free are not: from now on they are planned wider. Whether that is all that fails.
    pub fn doubt(&mut self, failing: &[usize]) -> bool {
        const MORE: f64 = 0.01;
        const MOST: f64 = 0.05;
        let way = |t: &usize| match self.judges.get(*t) {
            Some(Judge::Way(way)) => Some(*way),
            _ => None,
        };
        let Some(ways) = failing.iter().map(way).collect::<Option<Vec<usize>>>() else { return false };
        for way in ways {
            let way = &mut self.ways[way];
            way.doubt = (way.doubt + MORE).min(MOST);
            way.path.clear();
        }
        true
    }

    /// The corridor between two things that asks for the least to be moved; empty: there is none.
    fn plan(&mut self, index: usize) -> Vec<[f64; 2]> {
        let Some(grid) = Grid::new(self) else { return Vec::new() };
        self.work += WORK * grid.count() as u64;
        let way = &self.ways[index];
        let (radius, [a, b]) = (way.width(), way.ends);
        let cost = self.cost_of_cells(&grid, radius, [a, b]);
        let there = |j: usize| {
            let flat = self.flat(j);
            let reach = radius + NEAR + 0.7 * grid.cell;
            move |p: [f64; 2]| flat.distance(p) <= reach
        };
        let cells = grid.shortest(&cost, there(a), there(b));
        let mut path: Vec<[f64; 2]> = cells.into_iter().map(|c| grid.middle(c)).collect();
        if path.is_empty() {
            return path;
        }
        self.push_aside(&mut path, radius);
        let count = path.len();
        for (at, end) in [(0, a), (count - 1, b)] {
            path[at] = self.flat(end).away(path[at], way.radius + NEAR / 2.0);
        }
        straight(path)
    }

    /// What it costs to walk through each cell, per metre; infinite where there is no floor.
    fn cost_of_cells(&self, grid: &Grid, radius: f64, ends: [usize; 2]) -> Vec<f64> {
        let mut cost: Vec<f64> = (0..grid.count())
            .map(|c| if self.is_floor(grid.middle(c), radius, grid.cell) { 1.0 } else { f64::INFINITY })
            .collect();
        for j in (0..self.count()).filter(|&j| self.is_in_the_way(j)) {
            let flat = self.flat(j);
            let ease = if ends.contains(&j) { grid.cell } else { 0.0 };
            let [base, per] = if self.is_movable(j) { DETOUR } else { [BARRED; 2] };
            for c in grid.around(&self.span[j], radius) {
                let lack = radius - ease - flat.distance(grid.middle(c));
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
    fn push_aside(&self, path: &mut [[f64; 2]], radius: f64) {
        let wanted = radius + SPARE;
        let beside: Vec<Flat> = (0..self.count()).filter(|&j| self.is_in_the_way(j)).map(|j| self.flat(j)).collect();
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
}

/// Without bends that are none.
fn straight(path: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let mut out: Vec<[f64; 2]> = Vec::with_capacity(path.len());
    for p in path {
        if let [.., a, b] = out[..] {
            let turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
            if turn.abs() < 1e-9 {
                out.pop();
            }
        }
        out.push(p);
    }
    out
}

/// Square cells over all rooms.
struct Grid {
    from: [f64; 2],
    cell: f64,
    size: [usize; 2],
}

impl Grid {
    fn new(quick: &Quick<'_>) -> Option<Self> {
        let field = quick.rooms.iter().map(|room| room.field).reduce(super::Field::join)?;
        let [w, d] = [0, 1].map(|k| field.max[k] - field.min[k]);
        let cell = (w * d / CELLS).sqrt().max(CELL);
        let size = [w, d].map(|m| (m / cell).ceil().max(1.0) as usize);
        (w.is_finite() && d.is_finite()).then_some(Self { from: field.min, cell, size })
    }
    fn count(&self) -> usize {
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

    /// The cheapest way from where one is to where one wants to be.
    fn shortest(&self, cost: &[f64], from: impl Fn([f64; 2]) -> bool, to: impl Fn([f64; 2]) -> bool) -> Vec<usize> {
        const UNSEEN: u32 = u32::MAX;
        let mut far = vec![f64::INFINITY; cost.len()];
        let mut before = vec![UNSEEN; cost.len()];
        let mut open = BinaryHeap::new();
        // Costs as whole micrometres: they can be compared, and are alike on every machine.
        let whole = |metres: f64| (metres * 1e6) as u64;
        for c in (0..cost.len()).filter(|&c| cost[c].is_finite() && from(self.middle(c))) {
            far[c] = 0.0;
            open.push(Reverse((0, c)));
        }
        while let Some(Reverse((key, c))) = open.pop() {
            if key > whole(far[c]) {
                continue;
            }
            if to(self.middle(c)) {
                let mut path = vec![c];
                let mut at = c;
                while before[at] != UNSEEN {
                    at = before[at] as usize;
                    path.push(at);
                }
                path.reverse();
                return path;
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
                    before[next] = c as u32;
                    open.push(Reverse((whole(there), next)));
                }
            }
        }
        Vec::new()
    }
}
