//! Where nothing but paths is barred: what belongs together goes elsewhere as one piece, paths are planned anew, and the new
//! arrangement is kept if it bars them no more than the old one.

use super::moves::{Inputs, turned};
use super::paths::PathGroup;
use super::{Judge, LocalSearch};
use crate::search::chance::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::penalty;

/// How many places are looked at until one is found in which nothing is violated.
const PLACES: usize = 12;
/// How often such moves are tried at least and at most, and how much more often for each that paid.
const OFTEN: [f64; 2] = [0.05, 0.5];
const PAYS: f64 = 3.0;
/// What one that pays leaves of what paths cost, at most.
const LESS: f64 = 0.98;
/// How far something is shifted (metres), at most.
const SHIFT: f64 = 2.5;

/// Where paths were planned, and what each group of them cost.
struct Plans {
    groups: Vec<PathGroup>,
    found: Vec<(f64, bool)>,
}

impl LocalSearch<'_> {
    /// Whether all holds but planned paths.
    pub(super) fn are_only_paths_barred(&self) -> bool {
        !self.bad.is_empty() && self.bad.iter().all(|c| matches!(self.judges.get(*c), Some(Judge::PathGroup(_))))
    }

    /// Whether to try the next such move: the more often the better they do.
    pub(super) fn rearranges(&self, chance: &mut ChaCha8Rng) -> bool {
        let [pays, tried] = self.rearranged;
        !self.is_warm() && chance.unit() < (PAYS * (pays + 2.0) / (tried + 2.0)).clamp(OFTEN[0], OFTEN[1])
    }

    /// Moves something with its company. Whether it stays there.
    pub(super) fn rearrange(&mut self, chance: &mut ChaCha8Rng, poses: &mut Vec<Inputs>) -> bool {
        let Some(i) = self.to_rearrange(chance) else { return false };
        for _ in 0..PLACES {
            self.elsewhere(i, chance, poses);
            let pose = poses[chance.below(poses.len())];
            // Single things are moved by other steps, without a new plan.
            let is_group = self.go_along(i, pose);
            if !(is_group || self.doors.contains(&i)) || !self.keeps_all_but_paths() {
                self.undo();
                continue;
            }
            return self.keep_if_no_worse();
        }
        false
    }

    /// Something that stands in a corridor; now and then a door, or anything.
    fn to_rearrange(&self, chance: &mut ChaCha8Rng) -> Option<usize> {
        let any = |list: &[usize], chance: &mut ChaCha8Rng| list.get(chance.below(list.len())).copied();
        match chance.below(6) {
            0 => any(&self.doors, chance).filter(|&door| self.is_movable(door)),
            1 => any(&self.movable, chance),
            _ => {
                let check = self.bad[chance.below(self.bad.len())];
                let Some(Judge::PathGroup(group)) = self.judges.get(check) else { return None };
                self.hindrance(*group, chance)
            }
        }
        .or_else(|| any(&self.movable, chance))
    }

    /// Other places for something and its company, into `out`.
    fn elsewhere(&self, i: usize, chance: &mut ChaCha8Rng, out: &mut Vec<Inputs>) {
        out.clear();
        let now = self.inputs(i);
        let far = self.anywhere(i, chance);
        out.push(far);
        out.push([far[0], now[1], far[2], now[3], now[4], now[5]]);
        for axis in [0, 2] {
            let mut pose = now;
            pose[axis] += chance.between(-SHIFT, SHIFT);
            out.push(pose);
        }
        if self.turns[i] || self.yaws[i].len() > 1 {
            out.push(turned(now, now[3] + 90.0 * (1 + chance.below(3)) as f64));
        }
        self.at_a_wall(i, chance, out);
        self.a_path_apart(i, self.widest_path(), chance, out);
        self.out_of_the_way(i, out);
    }

    /// Whether a trial breaks nothing, paths left aside.
    fn keeps_all_but_paths(&mut self) -> bool {
        let walks = std::mem::take(&mut self.walks);
        let judged = self.judge(penalty::BASE);
        self.walks = walks;
        judged.is_some() && self.fresh.iter().all(|(check, _, holds)| *holds || !self.is_hard(*check))
    }

    pub(super) fn is_hard(&self, check: usize) -> bool {
        self.frame.terms.get(check).is_none_or(|term| term.is_hard())
    }

    /// Keeps a trial if paths that are planned anew cost no more than before; else all is as it was. Whether it is kept.
    fn keep_if_no_worse(&mut self) -> bool {
        let before = self.plans();
        let poses: Vec<(usize, Inputs)> = self.moved.iter().map(|(k, pose, _)| (*k, *pose)).collect();
        self.keep();
        (0..self.groups.len()).for_each(|group| self.plan_again(group));
        let cost = |found: &[(f64, bool)]| found.iter().map(|(cost, _)| cost).sum::<f64>();
        let (old, new) = (cost(&before.found), cost(&self.plans().found));
        self.rearranged[0] += f64::from(u8::from(new < LESS * old));
        self.rearranged[1] += 1.0;
        if new <= old {
            return true;
        }
        poses.into_iter().for_each(|(k, pose)| self.go(k, pose));
        let _ = self.judge(f64::INFINITY);
        self.keep();
        self.groups = before.groups;
        for (at, (cost, holds)) in before.found.into_iter().enumerate() {
            self.set(self.walks[at].0, cost, holds);
        }
        false
    }

    fn plans(&self) -> Plans {
        let found = self.walks.iter().map(|(t, _)| (self.cost[*t], self.holds[*t])).collect();
        Plans { groups: self.groups.clone(), found }
    }
}
