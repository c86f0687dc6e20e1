//! `reachable` on boxes: for the paths that are asked for corridors are planned through what can be moved, and what then
//! stands in them costs. So a search learns what to move out of the way; whether there is a path is asked of the
//! evaluator in the end.
//!
//! Paths of one width that begin at the same thing are planned and judged together: they share most of their corridors.

mod asked;
mod corridors;
mod group;
mod plans;

use super::{Inputs, Moved, Span, Trial};
use crate::penalty;
pub(super) use asked::PathRequest;
pub(super) use corridors::Floor;
use corridors::NEAR;
use group::Branch;
pub use group::PathGroup;
pub use plans::Plans;
use scenelang_verify::coded::Flat;

/// What reaches no higher above the floor is stepped over, what begins higher is walked under (metres).
const IN_THE_WAY: [f64; 2] = [0.05, 2.0];
/// A little more than what is missing (metres).
const EASE: f64 = 1e-3;

impl Trial<'_> {
    /// Whether paths are looked at: they must be there, or preferences count.
    pub fn looks_at(&self, group: usize) -> bool {
        self.preferring || self.groups[group].preference.is_none()
    }

    /// How many groups of paths are looked at.
    pub fn path_count(&self) -> usize {
        (0..self.groups.len()).filter(|&group| self.looks_at(group)).count()
    }

    /// Whether one cannot step over it or walk under it.
    pub fn is_in_the_way(&self, j: usize) -> bool {
        let span = &self.span[j];
        // Corridors are planned only where all rooms share a floor.
        let floor = self.floor.unwrap_or(0.0);
        !self.doors.contains(&j) && span.min[1] < floor + IN_THE_WAY[1] && span.max[1] > floor + IN_THE_WAY[0]
    }

    /// What paths cost, and whether nothing stands in their corridors.
    fn judge_group(&mut self, index: usize) -> (f64, bool) {
        self.work += 4 + self.count() as u64 / 2;
        let group = &self.groups[index];
        let lacks = (0..self.count()).map(|j| (j, self.reaches_in(group, j))).filter(|(_, lack)| *lack > 0.0).collect();
        let off = self.off_ends(group);
        let group = &mut self.groups[index];
        (group.lacks, group.off) = (lacks, off);
        let cost = group.lacks.iter().map(|(_, lack)| lack).sum::<f64>() + off;
        if self.is_stale(index) {
            return (penalty::BASE + 1.0, false);
        }
        (cost, cost == 0.0)
    }

    /// What it costs that ends are not where corridors begin, and that some have none.
    fn off_ends(&self, group: &PathGroup) -> f64 {
        let off = group.stands().map(|(end, at)| self.flat(end).distance(at) - group.radius - NEAR);
        let off: f64 = off.map(|off| if off > 0.0 { penalty::cost(false, off) } else { 0.0 }).sum();
        off + (penalty::BASE + 1.0) * group.unreached().count() as f64
    }

    /// How the paths that a trial concerns change.
    pub(super) fn paths_change(&mut self, moved: &[Moved]) -> f64 {
        let mut sum = 0.0;
        let through_door = moved.iter().any(|(m, ..)| self.doors.contains(m));
        for at in 0..self.walks.len() {
            let (t, index) = self.walks[at];
            let group = &self.groups[index];
            let near = |(m, _, old): &Moved| group.bounds.meets(old) || group.bounds.meets(&self.span[*m]);
            let has_end = moved.iter().any(|(m, ..)| group.has_end(*m));
            if !group.is_planned() || !self.counts(t) || !(through_door || has_end || moved.iter().any(near)) {
                continue;
            }
            let stale = if through_door { group.doors != self.door_places() } else { group.stale };
            let found = if stale {
                (penalty::BASE + 1.0, false)
            } else {
                let stays = |(j, _): &&(usize, f64)| !moved.iter().any(|(m, ..)| m == j);
                let others = group.lacks.iter().filter(stays).map(|(_, lack)| lack).sum::<f64>();
                let own = moved.iter().map(|(m, ..)| self.reaches_in(group, *m)).sum::<f64>();
                let cost = others + own + if has_end { self.off_ends(group) } else { group.off };
                (cost, cost == 0.0)
            };
            self.work += 2 * moved.len() as u64;
            sum += self.note(t, found) - self.weight[t] * self.cost[t];
        }
        sum
    }

    /// Objects have moved for good.
    pub(super) fn paths_keep(&mut self, moved: &[Moved]) {
        let through_door = moved.iter().any(|(m, ..)| self.doors.contains(m));
        let doors = if through_door { self.door_places() } else { Vec::new() };
        for index in 0..self.groups.len() {
            if through_door {
                self.groups[index].stale = self.groups[index].doors != doors;
            }
            let group = &self.groups[index];
            if !group.is_planned() {
                continue;
            }
            let off = if moved.iter().any(|(m, ..)| group.has_end(*m)) { self.off_ends(group) } else { group.off };
            let new: Vec<(usize, f64)> = moved.iter().map(|(m, ..)| (*m, self.reaches_in(group, *m))).collect();
            let group = &mut self.groups[index];
            group.off = off;
            group.lacks.retain(|(j, _)| !moved.iter().any(|(m, ..)| m == j));
            group.lacks.extend(new.into_iter().filter(|(_, lack)| *lack > 0.0));
        }
    }

    /// What it costs that an object stands in a corridor.
    fn reaches_in(&self, group: &PathGroup, j: usize) -> f64 {
        if !group.bounds.meets(&self.span[j]) || !self.is_in_the_way(j) {
            return 0.0;
        }
        let flat = self.flat(j);
        let size = flat.half[0] + flat.half[1] + group.width();
        let near = |step: &&Flat| {
            let off = [step.at[0] - flat.at[0], step.at[1] - flat.at[1]];
            off[0] * off[0] + off[1] * off[1] < (size + step.half[1]).powi(2)
        };
        let least = group.steps.iter().filter(near).map(|step| step.gap(&flat)).fold(f64::INFINITY, f64::min);
        let lack = group.width() - least;
        if lack > 0.0 { penalty::cost(false, lack) } else { 0.0 }
    }

    /// What a group of paths would be better without, and its ends where those are off it.
    pub fn hindrances(&self, index: usize) -> Vec<usize> {
        let group = &self.groups[index];
        let mut found: Vec<usize> = group.lacks.iter().map(|(j, _)| *j).collect();
        found.extend(group.stands().filter(|(j, p)| self.flat(*j).distance(*p) > group.radius + NEAR).map(|(j, _)| j));
        if group.unreached().next().is_some() {
            found.push(group.from);
            found.extend(group.unreached().flatten());
        }
        found.retain(|j| self.is_movable(*j));
        found
    }

    /// Whether paths have no plan, or doors have moved since.
    pub fn is_stale(&self, index: usize) -> bool {
        !self.groups[index].is_planned() || self.groups[index].stale
    }

    /// Out of the corridors that an object stands in, and back to those that begin at it; into `out`.
    pub fn out_of_the_way(&self, i: usize, out: &mut Vec<Inputs>) {
        let (now, flat) = (self.inputs(i), self.flat(i));
        let mut aside = |by: [f64; 2]| {
            let mut pose = now;
            (pose[0], pose[2]) = (now[0] + by[0], now[2] + by[1]);
            out.push(pose);
        };
        for group in &self.groups {
            if group.lacks.iter().any(|(j, _)| *j == i)
                && let Some(step) = group.steps.iter().min_by(|a, b| a.gap(&flat).total_cmp(&b.gap(&flat)))
            {
                let side = [step.turn[1], -step.turn[0]];
                let reach = {
                    let [sin, cos] = flat.turn;
                    (side[0] * cos - side[1] * sin).abs() * flat.half[0]
                        + (side[0] * sin + side[1] * cos).abs() * flat.half[1]
                };
                let across = step.local(flat.at)[0];
                for sign in [-1.0, 1.0] {
                    let by = sign * (reach + group.width() + EASE) - across;
                    aside([side[0] * by, side[1] * by]);
                }
            }
            for (_, p) in group.stands().filter(|(end, _)| *end == i) {
                let near = flat.away(p, group.radius + NEAR / 2.0);
                aside([p[0] - near[0], p[1] - near[1]]);
            }
        }
    }
}
