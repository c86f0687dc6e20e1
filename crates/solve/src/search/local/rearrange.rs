//! Where nothing but paths is barred: what belongs together goes elsewhere as one piece, paths are planned anew, and the new
//! arrangement is kept if it bars them no more than the old one.

use super::LocalSearch;
use super::moves::turned;
use crate::search::chance::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::penalty;
use scenelang_engine::trial::{Inputs, Judge};

/// How many places are looked at until one is found in which nothing is violated.
const PLACES: usize = 12;
/// How often such moves are tried at least and at most, and how much more often for each that paid.
const OFTEN: [f64; 2] = [0.05, 0.5];
const PAYS: f64 = 3.0;
/// What one that pays leaves of what paths cost, at most.
const LESS: f64 = 0.98;
/// How far something is shifted (metres), at most.
const SHIFT: f64 = 2.5;
impl LocalSearch<'_> {
    /// Whether all holds but planned paths.
    pub(super) fn are_only_paths_barred(&self) -> bool {
        !self.trial.bad.is_empty()
            && self.trial.bad.iter().all(|c| matches!(self.trial.judges.get(*c), Some(Judge::PathGroup(_))))
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
            if !(is_group || self.trial.doors.contains(&i)) || !self.keeps_all_but_paths() {
                self.trial.undo();
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
            0 => any(&self.trial.doors, chance).filter(|&door| self.trial.is_movable(door)),
            1 => any(&self.trial.movable, chance),
            _ => {
                let check = self.trial.bad[chance.below(self.trial.bad.len())];
                let Some(Judge::PathGroup(group)) = self.trial.judges.get(check) else { return None };
                self.hindrance(*group, chance)
            }
        }
        .or_else(|| any(&self.trial.movable, chance))
    }

    /// Other places for something and its company, into `out`.
    fn elsewhere(&self, i: usize, chance: &mut ChaCha8Rng, out: &mut Vec<Inputs>) {
        out.clear();
        let now = self.trial.inputs(i);
        let far = self.anywhere(i, chance);
        out.push(far);
        out.push([far[0], now[1], far[2], now[3], now[4], now[5]]);
        for axis in [0, 2] {
            let mut pose = now;
            pose[axis] += chance.between(-SHIFT, SHIFT);
            out.push(pose);
        }
        if self.trial.turns[i] || self.trial.yaws[i].len() > 1 {
            out.push(turned(now, now[3] + 90.0 * (1 + chance.below(3)) as f64));
        }
        self.at_a_wall(i, chance, out);
        self.a_path_apart(i, self.widest_path(), chance, out);
        self.trial.out_of_the_way(i, out);
    }

    /// Whether a trial breaks nothing, paths left aside.
    fn keeps_all_but_paths(&mut self) -> bool {
        let Self { trial, .. } = self;
        let judged = trial.judge_all_but_paths(penalty::BASE);
        judged.is_some() && trial.fresh.iter().all(|(check, _, holds)| *holds || !trial.is_hard(*check))
    }

    /// Keeps a trial if paths that are planned anew cost no more than before; else all is as it was. Whether it is kept.
    fn keep_if_no_worse(&mut self) -> bool {
        let Self { trial, rearranged, .. } = self;
        let before = trial.plans();
        let poses: Vec<(usize, Inputs)> = trial.moved.iter().map(|(k, pose, _)| (*k, *pose)).collect();
        trial.keep();
        trial.plan_barred();
        let (old, new) = (before.cost(), trial.plans().cost());
        rearranged[0] += f64::from(u8::from(new < LESS * old));
        rearranged[1] += 1.0;
        if new <= old {
            return true;
        }
        poses.into_iter().for_each(|(k, pose)| trial.go(k, pose));
        let _ = trial.judge(f64::INFINITY);
        trial.keep();
        trial.put_plans(before);
        false
    }
}
