//! `reachable` on boxes: for each way that is asked for a corridor is planned through what can be moved, and what then
//! stands in it costs. So a search learns what to move out of the way; whether there is a way is asked of the
//! evaluator in the end.

use super::judge::Moved;
use super::moves::Inputs;
use super::{Judge, Quick, Span};
use crate::merit;
use crate::pool::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_lang::program::Formula;
use scenelang_verify::coded::Flat;
use scenelang_verify::{Surroundings, World, surroundings};
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
const SPARE: f64 = 0.02;
/// Bends of less than this are none (metres).
const STRAIGHT: f64 = 0.015;
/// A little more than what is missing (metres).
const EASE: f64 = 1e-3;

/// A way that is asked for.
#[derive(Clone, Debug)]
pub(super) struct Way {
    ends: [usize; 2],
    radius: f64,
    /// Bends of the corridor; `None`: none is planned yet; empty: there is none.
    path: Option<Vec<[f64; 2]>>,
    /// Where doors were when it was planned.
    doors: Vec<[f64; 3]>,
    /// Its steps, as rectangles without width.
    steps: Vec<Flat>,
    /// What stands in the corridor, and what that costs.
    lacks: Vec<(usize, f64)>,
    /// What it costs that ends are not where it begins.
    off: f64,
    /// What surrounds the corridor.
    bounds: Span,
    /// How much wider than asked for it is planned, since what was planned proved too narrow (metres).
    doubt: f64,
}

impl Way {
    /// What a formula says, if it is a `reachable` of constant width.
    pub fn of(formula: &Formula, world: &World<f64>) -> Option<Self> {
        let Surroundings::Path { from, to, width: Some(width) } = surroundings(formula, formula.root_node()) else {
            return None;
        };
        let radius = ((width - world.options.tolerances.contact) / 2.0).max(0.0);
        let ends = [from.0 as usize, to.0 as usize];
        Some(Self {
            ends,
            radius,
            path: None,
            doors: Vec::new(),
            steps: Vec::new(),
            lacks: Vec::new(),
            off: 0.0,
            bounds: Span::default(),
            doubt: 0.0,
        })
    }
    fn width(&self) -> f64 {
        self.radius + self.doubt
    }
    fn bends(&self) -> &[[f64; 2]] {
        self.path.as_deref().unwrap_or_default()
    }
    /// Its ends, each with where the corridor begins there.
    fn stands(&self) -> impl Iterator<Item = (usize, [f64; 2])> + '_ {
        let bends = self.bends();
        self.ends.into_iter().zip([bends.first(), bends.last()]).filter_map(|(end, at)| Some((end, *at?)))
    }
    /// What surrounds the corridor, at any height.
    fn surround(&self) -> Span {
        let r = self.width();
        let bends = self.bends();
        let least = |k: usize| bends.iter().map(|p| p[k]).fold(f64::INFINITY, f64::min) - r;
        let most = |k: usize| bends.iter().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max) + r;
        Span { min: [least(0), f64::NEG_INFINITY, least(1)], max: [most(0), f64::INFINITY, most(1)] }
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
    fn way(&mut self, index: usize) -> (f64, bool) {
        self.work += 4 + self.count() as u64 / 2;
        let way = &self.ways[index];
        if way.bends().is_empty() {
            return (merit::BASE + 1.0, false);
        }
        let lacks = (0..self.count()).map(|j| (j, self.reaches_in(way, j))).filter(|(_, lack)| *lack > 0.0).collect();
        let off = self.off_ends(way);
        let way = &mut self.ways[index];
        (way.lacks, way.off) = (lacks, off);
        let cost = way.lacks.iter().map(|(_, lack)| lack).sum::<f64>() + off;
        (cost, cost == 0.0)
    }

    /// What it costs that ends are not where the corridor begins.
    fn off_ends(&self, way: &Way) -> f64 {
        let off = way.stands().map(|(end, at)| self.flat(end).distance(at) - way.radius - NEAR);
        off.map(|off| if off > 0.0 { merit::cost(false, off) } else { 0.0 }).sum()
    }

    /// How the ways that a trial concerns change.
    pub(super) fn ways_change(&mut self, moved: &[Moved]) -> f64 {
        let mut sum = 0.0;
        let through_door = moved.iter().any(|(m, ..)| self.doors.contains(m));
        for at in 0..self.walks.len() {
            let (t, index) = self.walks[at];
            let way = &self.ways[index];
            let near = |(m, _, old): &Moved| way.bounds.meets(old) || way.bounds.meets(&self.span[*m]);
            let has_end = moved.iter().any(|(m, ..)| way.ends.contains(m));
            if way.bends().is_empty() || !(through_door || has_end || moved.iter().any(near)) {
                continue;
            }
            let found = if through_door && way.doors != self.door_places() {
                (merit::BASE + 1.0, false)
            } else {
                let stays = |(j, _): &&(usize, f64)| !moved.iter().any(|(m, ..)| m == j);
                let others = way.lacks.iter().filter(stays).map(|(_, lack)| lack).sum::<f64>();
                let own = moved.iter().map(|(m, ..)| self.reaches_in(way, *m)).sum::<f64>();
                let cost = others + own + if has_end { self.off_ends(way) } else { way.off };
                (cost, cost == 0.0)
            };
            self.work += 2 * moved.len() as u64;
            sum += self.note(t, found) - self.weight[t] * self.cost[t];
        }
        sum
    }

    /// Objects have moved for good.
    pub(super) fn ways_keep(&mut self, moved: &[Moved]) {
        for index in 0..self.ways.len() {
            let way = &self.ways[index];
            if way.bends().is_empty() {
                continue;
            }
            let off = if moved.iter().any(|(m, ..)| way.ends.contains(m)) { self.off_ends(way) } else { way.off };
            let new: Vec<(usize, f64)> = moved.iter().map(|(m, ..)| (*m, self.reaches_in(way, *m))).collect();
            let way = &mut self.ways[index];
            way.off = off;
            way.lacks.retain(|(j, _)| !moved.iter().any(|(m, ..)| m == j));
            way.lacks.extend(new.into_iter().filter(|(_, lack)| *lack > 0.0));
        }
    }

    /// What it costs that an object stands in a corridor.
    fn reaches_in(&self, way: &Way, j: usize) -> f64 {
        if !way.bounds.meets(&self.span[j]) || !self.is_in_the_way(j) {
            return 0.0;
        }
        let flat = self.flat(j);
        let size = flat.half[0] + flat.half[1] + way.width();
        let near = |step: &&Flat| {
            let off = [step.at[0] - flat.at[0], step.at[1] - flat.at[1]];
            off[0] * off[0] + off[1] * off[1] < (size + step.half[1]).powi(2)
        };
        let least = way.steps.iter().filter(near).map(|step| step.gap(&flat)).fold(f64::INFINITY, f64::min);
        let lack = way.width() - least;
        if lack > 0.0 { merit::cost(false, lack) } else { 0.0 }
    }

    /// Something that a way would be better without, or one of its ends where those are off it.
    pub(super) fn hindrance(&self, index: usize, chance: &mut ChaCha8Rng) -> Option<usize> {
        let way = &self.ways[index];
        let mut found: Vec<usize> = way.lacks.iter().map(|(j, _)| *j).collect();
        found.extend(way.stands().filter(|(j, p)| self.flat(*j).distance(*p) > way.radius + NEAR).map(|(j, _)| j));
        if way.bends().is_empty() {
            found.extend(way.ends);
        }
        found.retain(|j| self.is_movable(*j));
        (!found.is_empty()).then(|| found[chance.below(found.len())])
    }

    /// Whether a way has no plan, or doors have moved since.
    pub(super) fn is_stale(&self, index: usize) -> bool {
        self.ways[index].bends().is_empty() || self.ways[index].doors != self.door_places()
    }

    /// Out of the corridors that an object stands in, and back to those that begin at it; into `out`.
    pub(super) fn out_of_the_way(&self, i: usize, out: &mut Vec<Inputs>) {
        let (now, flat) = (self.inputs(i), self.flat(i));
        let mut aside = |way: [f64; 2]| {
            let mut pose = now;
            (pose[0], pose[2]) = (now[0] + way[0], now[2] + way[1]);
            out.push(pose);
        };
        for way in &self.ways {
            if way.lacks.iter().any(|(j, _)| *j == i)
                && let Some(step) = way.steps.iter().min_by(|a, b| a.gap(&flat).total_cmp(&b.gap(&flat)))
            {
                let side = [step.turn[1], -step.turn[0]];
                let reach = {
                    let [sin, cos] = flat.turn;
                    (side[0] * cos - side[1] * sin).abs() * flat.half[0]
                        + (side[0] * sin + side[1] * cos).abs() * flat.half[1]
                };
                let across = step.local(flat.at)[0];
                for sign in [-1.0, 1.0] {
                    let by = sign * (reach + way.width() + EASE) - across;
                    aside([side[0] * by, side[1] * by]);
                }
            }
            for (_, p) in way.stands().filter(|(end, _)| *end == i) {
                let near = flat.away(p, way.radius + NEAR / 2.0);
                aside([p[0] - near[0], p[1] - near[1]]);
            }
        }
    }

    /// No way is planned.
    pub(super) fn forget_ways(&mut self) {
        for way in &mut self.ways {
            (way.path, way.off) = (None, 0.0);
            way.lacks.clear();
        }
    }

    /// Plans all ways anew, until it is late.
    pub(super) fn plan_all(&mut self, late: &dyn Fn() -> bool) {
        (0..self.ways.len()).take_while(|_| !late()).for_each(|way| self.plan_again(way));
    }

    /// Plans a way anew.
    pub(super) fn plan_again(&mut self, index: usize) {
        let path = self.plan(index);
        let doors = self.door_places();
        let way = &mut self.ways[index];
        (way.path, way.doors) = (Some(path), doors);
        way.steps = way.bends().windows(2).map(|pair| step(pair[0], pair[1])).collect();
        way.bounds = way.surround();
        let (term, _) = self.walks[index];
        let (cost, holds) = self.way(index);
        self.set(term, cost, holds);
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
            way.path = None;
        }
        true
    }

    /// The corridor between two things that asks for the least to be moved; empty: there is none.
    fn plan(&mut self, index: usize) -> Vec<[f64; 2]> {
        let Some(grid) = Grid::new(self) else { return Vec::new() };
        self.work += WORK * grid.count() as u64;
        let way = &self.ways[index];
        let radius = way.width();
        let [from, to] = way.ends.map(|end| self.around(end, way.radius + NEAR / 2.0, radius));
        let cost = self.cost_of_cells(&grid, radius);
        let cells = grid.shortest(&cost, &from, &to);
        let ([first, ..], [.., last]) = (&cells[..], &cells[..]) else { return Vec::new() };
        let nearest = |places: &[[f64; 2]], cell: usize| {
            let far = |p: &[f64; 2]| (p[0] - grid.middle(cell)[0]).hypot(p[1] - grid.middle(cell)[1]);
            places.iter().copied().min_by(|a, b| far(a).total_cmp(&far(b)))
        };
        let ends = [nearest(&from, *first), nearest(&to, *last)];
        let mut path: Vec<[f64; 2]> = ends[0].into_iter().collect();
        path.extend(cells.iter().map(|c| grid.middle(*c)));
        path.extend(ends[1]);
        self.push_aside(&mut path, radius);
        simplified(&path)
    }

    /// Places on the floor so far from a thing.
    fn around(&self, j: usize, far: f64, radius: f64) -> Vec<[f64; 2]> {
        /// Between two of them (metres).
        const STEP: f64 = 0.07;
        let flat = self.flat(j);
        let [w, d] = flat.half;
        let beyond = [w + far, d + far];
        let mut places = Vec::new();
        for axis in [0, 1] {
            let count = (2.0 * beyond[1 - axis] / STEP).ceil().min(100.0) as usize;
            for (k, side) in (0..=count).flat_map(|k| [(k, -1.0), (k, 1.0)]) {
                let mut local = [0.0; 2];
                local[axis] = side * beyond[axis];
                local[1 - axis] = beyond[1 - axis] * (2.0 * k as f64 / count as f64 - 1.0);
                // Rounded off at the corners.
                places.push(flat.away(flat.point(local), far));
            }
        }
        places.retain(|p| self.is_floor(*p, radius, 0.0));
        places
    }

    /// What it costs to walk through each cell, per metre; infinite where there is no floor.
    fn cost_of_cells(&self, grid: &Grid, radius: f64) -> Vec<f64> {
        let mut cost: Vec<f64> = (0..grid.count())
            .map(|c| if self.is_floor(grid.middle(c), radius, grid.cell) { 1.0 } else { f64::INFINITY })
            .collect();
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

/// A segment as a rectangle without width.
fn step(from: [f64; 2], to: [f64; 2]) -> Flat {
    let way = [to[0] - from[0], to[1] - from[1]];
    let length = (way[0] * way[0] + way[1] * way[1]).sqrt().max(1e-12);
    let at = [0, 1].map(|k| (from[k] + to[k]) / 2.0);
    Flat { at, turn: [way[0] / length, way[1] / length], half: [0.0, length / 2.0] }
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

    /// The cheapest way from one of some places to one of others.
    fn shortest(&self, cost: &[f64], from: &[[f64; 2]], to: &[[f64; 2]]) -> Vec<usize> {
        const UNSEEN: u32 = u32::MAX;
        let mut far = vec![f64::INFINITY; cost.len()];
        let mut before = vec![UNSEEN; cost.len()];
        let mut is_end = vec![false; cost.len()];
        let mut open = BinaryHeap::new();
        // Costs as whole micrometres: they can be compared, and are alike on every machine.
        let whole = |metres: f64| (metres * 1e6) as u64;
        let beside = |p: &[f64; 2]| {
            let point = Span { min: [p[0], 0.0, p[1]], max: [p[0], 0.0, p[1]] };
            let (at, reach) = (*p, self.cell);
            self.around(&point, reach).filter(move |&c| {
                let m = self.middle(c);
                (m[0] - at[0]).hypot(m[1] - at[1]) <= reach
            })
        };
        for c in to.iter().flat_map(beside) {
            is_end[c] = true;
        }
        for c in from.iter().flat_map(beside).filter(|&c| cost[c].is_finite()) {
            far[c] = 0.0;
            open.push(Reverse((0, c)));
        }
        while let Some(Reverse((key, c))) = open.pop() {
            if key > whole(far[c]) {
                continue;
            }
            if is_end[c] {
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
