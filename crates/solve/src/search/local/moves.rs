//! Where an object could go: anywhere, a little aside, turned, up against another thing or a wall, and to where a
//! violated constraint would hold.

use super::{Home, LocalSearch, Stretch, Wall};
use crate::search::chance::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::trial::{Inputs, Judge, carried};
use scenelang_lang::program::ObjectId;
use scenelang_layout::rotation::sin_cos;
use scenelang_verify::coded::Flat;

/// A step to see how a margin changes: metres, and degrees.
const PROBE: f64 = 1e-3;
const TURN: f64 = 0.05;
/// How many violated terms an object is moved for.
const TERMS: usize = 6;
/// How many others that an object has to do with are looked at for analogies, and how many of these are tried.
const RELATED: usize = 6;
const ANALOGIES: usize = 6;
/// The same for places in line with them.
const LINES: usize = 3;
/// A little more than what is missing, so that rounding does not take it away (metres).
const EASE: f64 = 1e-4;
/// How often a place of a rotated room is drawn before one outside is taken.
const DRAWS: usize = 8;
/// How far apart things are put that are put beside each other (metres), at most.
const APART: f64 = 0.15;

impl LocalSearch<'_> {
    /// Poses for an object, into `out`.
    pub(super) fn poses(&mut self, i: usize, chance: &mut ChaCha8Rng, out: &mut Vec<Inputs>) {
        out.clear();
        let now = self.trial.inputs(i);
        out.extend(self.at_first[i].filter(|_| self.is_warm()));
        for _ in 0..6 {
            let pose = self.anywhere(i, chance);
            out.push(pose);
        }
        self.satisfying(i, chance, out);
        for at in 0..self.trial.yaws[i].len() {
            let yaw = self.trial.yaws[i][at];
            if yaw != now[3] {
                out.push(turned(now, yaw));
            }
        }
        if self.trial.turns[i] && self.skew {
            self.turning(i, chance, out);
        }
        for far in [0.02, 0.1, 0.4, 1.0] {
            let mut pose = now;
            pose[0] += chance.between(-far, far);
            pose[2] += chance.between(-far, far);
            out.push(pose);
        }
        self.beside_others(i, chance, out);
        let first = out.len();
        if !self.trial.frame.siblings[i].is_empty() && chance.below(3) == 0 {
            self.by_analogy(i, out);
        }
        for _ in ANALOGIES..out.len() - first {
            let drop = first + chance.below(out.len() - first);
            out.swap_remove(drop);
        }
        self.trial.out_of_the_way(i, out);
        for _ in 0..3 {
            self.at_a_wall(i, chance, out);
        }
    }

    /// Anywhere that it may be.
    pub(super) fn anywhere(&self, i: usize, chance: &mut ChaCha8Rng) -> Inputs {
        match &self.homes[i] {
            Home::Stands(_) => {}
            Home::Hangs(walls) => return self.on_wall(i, &walls[chance.below(walls.len())], chance),
            Home::Within(container) => return self.within(i, *container, chance),
            Home::Door(stretches) => return self.in_wall(i, &stretches[chance.below(stretches.len())], chance),
            Home::Ceiling(height) => {
                let mut pose = self.on_the_ground(i, chance);
                pose[1] = height - self.trial.size[i][1];
                return pose;
            }
        }
        let mut pose = self.on_the_ground(i, chance);
        if self.trial.rests[i] {
            pose[1] = self.level(i, chance);
        }
        pose
    }

    /// A floor that it may stand on.
    fn level(&self, i: usize, chance: &mut ChaCha8Rng) -> f64 {
        let level = match self.levels[i][..] {
            [level] => level,
            ref levels => levels[chance.below(levels.len())],
        };
        level + self.trial.depth_below(i)
    }

    /// Somewhere in what holds it, at its bottom.
    fn within(&self, i: usize, container: usize, chance: &mut ChaCha8Rng) -> Inputs {
        let mut pose = self.some_turn(i, chance);
        if self.trial.turns[i] && chance.below(2) == 0 {
            pose = turned(pose, self.trial.inputs(container)[3] + 90.0 * chance.below(4) as f64);
        }
        let flat = self.trial.flat(container);
        let along = [flat.point([1.0, 0.0]), flat.point([0.0, 1.0])].map(|p| [p[0] - flat.at[0], p[1] - flat.at[1]]);
        let play = [0, 1].map(|k| (flat.half[k] - self.reach_along(i, &pose, along[k])).max(0.0));
        [pose[0], pose[2]] = flat.point(play.map(|far| chance.between(-far, far)));
        pose[1] = self.trial.span[container].min[1] + self.trial.depth_below(i);
        pose
    }

    fn on_the_ground(&self, i: usize, chance: &mut ChaCha8Rng) -> Inputs {
        let mut pose = self.some_turn(i, chance);
        let (rx, rz) = self.reach(i, &pose);
        let field = &self.field[i];
        for _ in 0..DRAWS {
            pose[0] = within(chance, field.min[0] + rx, field.max[0] - rx);
            pose[2] = within(chance, field.min[1] + rz, field.max[1] - rz);
            let at = [pose[0], pose[2]];
            if self.outlines[i].iter().all(|&room| self.trial.rooms[room].depth(at) >= rx.min(rz)) {
                break;
            }
        }
        pose
    }

    fn some_turn(&self, i: usize, chance: &mut ChaCha8Rng) -> Inputs {
        let yaws = &self.trial.yaws[i];
        if self.trial.turns[i] && self.skew && chance.below(4) == 0 {
            return turned(self.trial.inputs(i), chance.between(0.0, 360.0));
        }
        turned(self.trial.inputs(i), yaws[chance.below(yaws.len())])
    }

    pub(super) fn reach(&self, i: usize, pose: &Inputs) -> (f64, f64) {
        let ([w, _, d], [.., sin, cos]) = (self.trial.size[i], *pose);
        ((cos.abs() * w + sin.abs() * d) / 2.0, (sin.abs() * w + cos.abs() * d) / 2.0)
    }

    /// How far it reaches along a direction on the floor.
    fn reach_along(&self, i: usize, pose: &Inputs, [x, z]: [f64; 2]) -> f64 {
        let ([w, _, d], [.., sin, cos]) = (self.trial.size[i], *pose);
        ((cos * x - sin * z).abs() * w + (sin * x + cos * z).abs() * d) / 2.0
    }

    /// Where it is, turned otherwise: a little, at random, and as what it has to do with has it.
    fn turning(&self, i: usize, chance: &mut ChaCha8Rng, out: &mut Vec<Inputs>) {
        let now = self.trial.inputs(i);
        for far in [3.0, 15.0, 180.0] {
            out.push(turned(now, now[3] + chance.between(-far, far)));
        }
        for _ in 0..3.min(self.related[i].len()) {
            let j = self.related[i][chance.below(self.related[i].len())];
            out.push(turned(now, self.turn_beside(i, &now, j, chance)));
        }
    }

    /// A yaw that another thing suggests: towards it, or as it is turned, give or take quarter turns.
    fn turn_beside(&self, i: usize, pose: &Inputs, j: usize, chance: &mut ChaCha8Rng) -> f64 {
        let other = self.trial.inputs(j);
        let base = if chance.below(2) == 0 && i != j {
            (other[0] - pose[0]).atan2(other[2] - pose[2]).to_degrees()
        } else {
            other[3]
        };
        // Most look the same way or at it.
        base + [0.0, 0.0, 180.0, 90.0, 270.0][chance.below(5)]
    }

    /// Along x, z or y, or by turning, to where a violated term of it would hold, and some way beyond.
    fn satisfying(&mut self, i: usize, chance: &mut ChaCha8Rng, out: &mut Vec<Inputs>) {
        let now = self.trial.inputs(i);
        let fixed = self.trial.frame.fixed(ObjectId(i as u32));
        // Those of what goes along by rules, too.
        let mut owners = vec![i];
        owners.extend(
            self.trial.followers[i].iter().map(|&rule| self.trial.rules[rule].owner).filter(|owner| *owner != i),
        );
        let mut terms: Vec<usize> = Vec::new();
        for &owner in &owners {
            terms.extend(self.trial.terms_of[owner].iter().copied().filter(|&t| self.trial.is_bad(t)));
            terms.extend(
                self.trial.preferences_of[owner]
                    .iter()
                    .copied()
                    .filter(|&t| self.trial.counts(t) && self.trial.cost[t] > 0.0),
            );
        }
        terms.retain(|&t| matches!(self.trial.judges[t], Judge::Code(_) | Judge::Mixed(_)));
        terms.truncate(TERMS);
        for t in terms {
            let missing = self.missing(t, i, now);
            let mut slopes = [0.0; 3];
            for axis in [0, 2, 1] {
                // What stands goes up and down by what it stands on: see `on_others`.
                if fixed.pos[axis] || axis == 1 && self.trial.rests[i] {
                    continue;
                }
                let mut probe = now;
                probe[axis] += PROBE;
                let slope = (self.missing(t, i, probe) - missing) / PROBE;
                slopes[axis] = slope;
                if slope.abs() < 1e-3 {
                    continue;
                }
                let step = -(missing + EASE) / slope;
                if !step.is_finite() || step.abs() > 100.0 {
                    continue;
                }
                let mut pose = now;
                pose[axis] += step;
                out.push(pose);
                let beyond = chance.unit();
                pose[axis] += step.signum() * beyond * beyond;
                let other = 2 - axis;
                if axis != 1 && !fixed.pos[other] {
                    out.push(pose);
                    let field = &self.field[i];
                    pose[other] = chance.between(field.min[other / 2], field.max[other / 2]);
                }
                out.push(pose);
            }
            if self.trial.turns[i] && self.skew {
                self.straight_there(now, missing, slopes, out);
                let slope = (self.missing(t, i, turned(now, now[3] + TURN)) - missing) / TURN;
                let step = -(missing + EASE) / slope;
                if step.abs() <= 180.0 {
                    out.push(turned(now, now[3] + step));
                    out.push(turned(now, now[3] + step * (1.0 + chance.unit())));
                }
            }
        }
    }

    /// Along the steepest way over the floor: what walks along an axis may be far off for what is turned.
    fn straight_there(&self, now: Inputs, missing: f64, [x, _, z]: [f64; 3], out: &mut Vec<Inputs>) {
        let steepness = x * x + z * z;
        if steepness < 1e-6 || (x == 0.0 || z == 0.0) {
            return;
        }
        let step = -(missing + EASE) / steepness;
        if step.is_finite() && step.abs() < 100.0 {
            let mut pose = now;
            (pose[0], pose[2]) = (now[0] + step * x, now[2] + step * z);
            out.push(pose);
        }
    }

    /// What a term lacks with an object somewhere (metres).
    fn missing(&mut self, t: usize, i: usize, pose: Inputs) -> f64 {
        self.trial.go(i, pose);
        let missing = self.trial.lacks(t);
        self.trial.undo();
        missing
    }

    /// Where it would go on with a row, and where it would stand as another of its array does to what that belongs to.
    pub(super) fn by_analogy(&self, i: usize, out: &mut Vec<Inputs>) {
        let placed = |j: &usize| *j != i && !self.trial.away[*j];
        let array = |k: usize| self.trial.frame.siblings[k].iter().map(|o| o.0 as usize);
        let known = |k: usize| self.related[k].iter().copied().filter(placed).take(RELATED);
        for j in known(i) {
            let here = self.trial.inputs(j);
            for m in known(j).filter(|m| array(j).any(|k| k == *m)) {
                let before = self.trial.inputs(m);
                let mut pose = here;
                (0..3).step_by(2).for_each(|k| pose[k] += here[k] - before[k]);
                pose[1] = self.trial.inputs(i)[1];
                out.push(pose);
            }
            for s in array(i).filter(placed).take(RELATED) {
                for a in known(s).filter(|a| *a != j && array(j).any(|k| k == *a)) {
                    out.push(carried(&self.trial.inputs(a), &here, &self.trial.inputs(s)));
                }
            }
        }
    }

    /// In line with things that it has to do with, up against them, turned as they are or the other way: so rows grow.
    pub(super) fn in_line(&self, i: usize, out: &mut Vec<Inputs>) {
        let now = self.trial.inputs(i);
        for &j in self.related[i].iter().filter(|j| **j != i && !self.trial.away[**j]).take(LINES) {
            let (flat, other) = (self.trial.flat(j), self.trial.inputs(j));
            for yaw in [other[3], other[3] + 180.0] {
                let pose = turned(now, yaw);
                if !self.trial.turns[i] && !self.trial.yaws[i].contains(&pose[3]) {
                    continue;
                }
                for (axis, side) in [(0, -1.0), (0, 1.0), (1, -1.0), (1, 1.0)] {
                    let mut at = [0.0; 2];
                    at[axis] = side * (flat.half[axis] + self.trial.size[i][2 * axis] / 2.0 + EASE);
                    let [x, z] = flat.point(at);
                    out.push([x, now[1], z, pose[3], pose[4], pose[5]]);
                }
            }
        }
    }

    /// Up against what it overlaps, has to do with, or meets by chance.
    fn beside_others(&self, i: usize, chance: &mut ChaCha8Rng, out: &mut Vec<Inputs>) {
        for round in 0..6 {
            let pool = match round {
                0 | 1 if !self.trial.hits[i].is_empty() => &self.trial.hits[i],
                2 | 3 if !self.related[i].is_empty() => &self.related[i],
                _ => &self.trial.movable,
            };
            if let Some(&j) = pool.get(chance.below(pool.len()))
                && i != j
                && !self.trial.away[j]
            {
                let apart = if chance.below(3) == 0 { APART * chance.unit() } else { 0.0 };
                out.push(self.beside(i, j, apart, chance));
            }
        }
        let stands = matches!(self.homes[i], Home::Stands(_));
        if stands && self.stacks && !self.trial.hits[i].is_empty() {
            let j = self.trial.hits[i][chance.below(self.trial.hits[i].len())];
            self.on_others(i, &[j], chance, out);
        } else if stands && !self.carriers[i].is_empty() {
            self.on_others(i, &self.carriers[i], chance, out);
        }
    }

    /// With room for a path of a width between it and a wall, and between it and another thing; into `out`.
    pub(super) fn a_path_apart(&self, i: usize, width: f64, chance: &mut ChaCha8Rng, out: &mut Vec<Inputs>) {
        let Home::Stands(walls) = &self.homes[i] else { return };
        let width = width + EASE;
        if !walls.is_empty() {
            out.push(self.along(i, &walls[chance.below(walls.len())], self.trial.inputs(i), -width, chance));
        }
        let j = self.trial.movable[chance.below(self.trial.movable.len())];
        if i != j && !self.trial.away[j] && self.trial.is_in_the_way(j) {
            out.push(self.beside(i, j, width, chance));
        }
    }

    /// At a side of another thing, as that is turned, so far from it.
    fn beside(&self, i: usize, j: usize, apart: f64, chance: &mut ChaCha8Rng) -> Inputs {
        let other = self.trial.flat(j);
        let now = self.trial.inputs(i);
        let square = other.turn[0] == 0.0 || other.turn[1] == 0.0;
        let mut pose = if chance.below(2) == 0 { now } else { self.some_turn(i, chance) };
        if self.trial.turns[i] && (!square || chance.below(4) == 0) && chance.below(3) > 0 {
            pose = turned(now, self.trial.inputs(j)[3] + 90.0 * chance.below(4) as f64);
        }
        let axis = chance.below(2);
        let ways = [other.point([1.0, 0.0]), other.point([0.0, 1.0])].map(|p| [p[0] - other.at[0], p[1] - other.at[1]]);
        let own = ways.map(|way| self.reach_along(i, &pose, way));
        let side = if chance.below(2) == 0 { -1.0 } else { 1.0 };
        let mut at = [0.0; 2];
        at[axis] = side * (other.half[axis] + own[axis] + apart);
        let across = 1 - axis;
        let flush = other.half[across] - own[across];
        at[across] = match chance.below(5) {
            0 => flush,
            1 => -flush,
            2 => chance.between(-1.0, 1.0) * (other.half[across] + own[across]),
            3 => 0.0,
            _ => other.local([now[0], now[2]])[across],
        };
        [pose[0], pose[2]] = other.point(at);
        pose
    }

    /// On the floor, or on one of some others.
    fn on_others(&self, i: usize, others: &[usize], chance: &mut ChaCha8Rng, out: &mut Vec<Inputs>) {
        let mut low = self.anywhere(i, chance);
        low[1] = self.level(i, chance);
        out.push(low);
        for &j in others.iter().take(3).filter(|&&j| !self.trial.away[j]) {
            let Flat { at, half, .. } = self.trial.flat(j);
            let top = self.trial.span[j].min[1] + self.trial.surface[j] + self.trial.depth_below(i);
            for _ in 0..2 {
                let mut pose = self.some_turn(i, chance);
                if self.trial.turns[i] && chance.below(2) == 0 {
                    pose = turned(pose, self.trial.inputs(j)[3] + 90.0 * chance.below(4) as f64);
                }
                // With all of it over the other, or with its middle.
                let mut local = half.map(|h| chance.between(-h, h));
                if chance.below(4) > 0 {
                    let ways = [[1.0, 0.0], [0.0, 1.0]].map(|way| self.trial.flat(j).point(way));
                    let reach = ways.map(|p| self.reach_along(i, &pose, [p[0] - at[0], p[1] - at[1]]));
                    local = [0, 1].map(|k| {
                        let play = half[k] - reach[k];
                        if play > 0.0 { chance.between(-play, play) } else { 0.0 }
                    });
                }
                pose[1] = top;
                [pose[0], pose[2]] = if chance.below(3) == 0 { at } else { self.trial.flat(j).point(local) };
                out.push(pose);
            }
        }
    }

    /// With its back to a wall or as it is turned, somewhere along it; into `out`.
    pub(super) fn at_a_wall(&self, i: usize, chance: &mut ChaCha8Rng, out: &mut Vec<Inputs>) {
        let walls = match &self.homes[i] {
            Home::Stands(walls) if !walls.is_empty() => walls,
            Home::Ceiling(_) | Home::Stands(_) | Home::Within(_) => return,
            Home::Hangs(_) | Home::Door(_) => {
                let pose = self.anywhere(i, chance);
                out.push(pose);
                return;
            }
        };
        let wall = &walls[chance.below(walls.len())];
        let now = self.trial.inputs(i);
        let back = self.trial.turns[i] || self.trial.yaws[i].contains(&wall.yaw);
        let pose = match chance.below(3) {
            0 if back => turned(now, wall.yaw),
            1 => self.some_turn(i, chance),
            _ => now,
        };
        out.push(self.along(i, wall, pose, 0.0, chance));
    }

    /// Along a wall: in a corner, where it is already, or anywhere.
    fn along(&self, i: usize, wall: &Wall, mut pose: Inputs, behind: f64, chance: &mut ChaCha8Rng) -> Inputs {
        let side = self.reach_along(i, &pose, wall.along);
        let depth = self.reach_along(i, &pose, wall.inward);
        let at = match chance.below(6) {
            0 => side,
            1 => wall.length - side,
            2 | 3 => wall.shadow([pose[0], pose[2]]),
            _ => chance.between(side, wall.length - side),
        };
        [pose[0], pose[2]] = wall.point(at, depth - behind);
        pose
    }

    fn on_wall(&self, i: usize, wall: &Wall, chance: &mut ChaCha8Rng) -> Inputs {
        let now = self.trial.inputs(i);
        let pose =
            if self.trial.turns[i] || self.trial.yaws[i].contains(&wall.yaw) { turned(now, wall.yaw) } else { now };
        let mut pose = self.along(i, wall, pose, 0.0, chance);
        let room = self.trial.rooms.iter().find(|room| room.depth([pose[0], pose[2]]) >= -1e-6);
        let (floor, ceiling) = room.map_or((0.0, 2.5), |room| (room.floor, room.ceiling));
        if chance.below(2) == 0 {
            pose[1] = within(chance, floor, ceiling - self.trial.size[i][1]);
        }
        pose
    }

    fn in_wall(&self, i: usize, stretch: &Stretch, chance: &mut ChaCha8Rng) -> Inputs {
        let now = self.trial.inputs(i);
        let yaw = stretch.wall.yaw + if chance.below(2) == 0 { 0.0 } else { 180.0 };
        let pose = if self.trial.turns[i] || self.trial.yaws[i].contains(&yaw) { turned(now, yaw) } else { now };
        let depth = self.reach_along(i, &pose, stretch.wall.inward);
        let mut pose = self.along(i, &stretch.wall, pose, depth + stretch.behind, chance);
        pose[1] = stretch.floor;
        pose
    }
}

/// The same, turned.
pub(super) fn turned(pose: Inputs, yaw: f64) -> Inputs {
    let yaw = crate::problem::pose::round_turn(yaw);
    let (sin, cos) = sin_cos(yaw);
    [pose[0], pose[1], pose[2], yaw, sin, cos]
}

fn within(chance: &mut ChaCha8Rng, lo: f64, hi: f64) -> f64 {
    if lo < hi { chance.between(lo, hi) } else { (lo + hi) / 2.0 }
}
