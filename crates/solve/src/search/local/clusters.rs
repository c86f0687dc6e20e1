//! Clusters: things that the program keeps close together, such as a row of racks or a desk with its chair. A path has to
//! lead past all of a cluster, and a row fits into a room in few ways: so a first layout builds each cluster where there is
//! space, and then tries it as one piece in other places and turns, before the next one is built.

use super::moves::turned;
use super::{Home, LocalSearch};
use crate::search::chance::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::trial::{Inputs, Judge, carried};

/// What a constraint lets stand further apart than this keeps nothing together (metres).
const CLOSE: f64 = 1.0;
/// Two distances at which a constraint is looked at: one that keeps two things together lacks more at the greater (metres).
const FAR: [f64; 2] = [100.0, 200.0];
/// Fewer things than this are moved well enough one at a time.
const LEAST: usize = 3;
/// What it costs along an axis that a cluster is neither at a wall nor just a path away from something: space is lost then.
const LOOSE: f64 = 1e-3;
/// How many steps, per member, are worth it to make a cluster hold before others come.
const STEPS: usize = 30;
/// How often each cluster may go elsewhere again, on average, once all are there.
const ROUNDS: usize = 4;
/// How many places are tried for a cluster.
const PLACES: usize = 300;
/// Which things belong together.
#[derive(Clone, Debug, Default)]
pub(super) struct Clusters {
    pub members: Vec<Vec<usize>>,
    /// By object: the cluster that it is in.
    pub of: Vec<Option<usize>>,
}

impl Clusters {
    /// Whether two things are in the same cluster.
    pub fn share(&self, i: usize, j: usize) -> bool {
        self.of[i].is_some() && self.of[i] == self.of[j]
    }
}

impl LocalSearch<'_> {
    /// The clusters of a program.
    pub(super) fn find_clusters(&mut self) -> Clusters {
        let n = self.trial.count();
        let mut root: Vec<usize> = (0..n).collect();
        fn find(root: &[usize], mut i: usize) -> usize {
            while root[i] != i {
                i = root[i];
            }
            i
        }
        for t in 0..self.trial.judges.len() {
            let Some([a, b]) = self.stands_with(t) else { continue };
            let (ra, rb) = (find(&root, a), find(&root, b));
            if ra != rb && self.keeps_together(t, a, b) {
                root[ra.max(rb)] = ra.min(rb);
            }
        }
        let mut by_root: Vec<Vec<usize>> = vec![Vec::new(); n];
        (0..n).for_each(|i| by_root[find(&root, i)].push(i));
        let members: Vec<Vec<usize>> = by_root.into_iter().filter(|members| members.len() >= LEAST).collect();
        let mut of = vec![None; n];
        for (cluster, i) in members.iter().enumerate().flat_map(|(c, list)| list.iter().map(move |i| (c, *i))) {
            of[i] = Some(cluster);
        }
        Clusters { members, of }
    }

    /// The two things that a term speaks of, if both stand on a floor and may be moved.
    fn stands_with(&self, t: usize) -> Option<[usize; 2]> {
        let (Judge::Code(_), [a, b]) = (&self.trial.judges[t], &self.trial.frame.terms[t].objects[..]) else {
            return None;
        };
        let both = [a.0 as usize, b.0 as usize];
        let stands = |i: usize| matches!(self.homes[i], Home::Stands(_)) && self.trial.is_movable(i);
        (self.trial.frame.terms[t].is_hard() && both.into_iter().all(stands)).then_some(both)
    }

    /// Whether a term is violated wherever two things are more than a step apart, the more so the further.
    fn keeps_together(&mut self, t: usize, a: usize, b: usize) -> bool {
        let from = self.trial.inputs(b);
        let touching = self.trial.size[a][0].max(self.trial.size[a][2]) / 2.0
            + self.trial.size[b][0].max(self.trial.size[b][2]) / 2.0;
        let [near, far, further] = [touching + CLOSE, FAR[0], FAR[1]];
        let before = self.trial.inputs(a);
        let mut lacks = |apart: f64, [x, z]: [f64; 2]| {
            let mut pose = before;
            (pose[0], pose[2]) = (from[0] + apart * x, from[2] + apart * z);
            self.trial.lacks_at(t, a, pose)
        };
        [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]]
            .into_iter()
            .all(|way| lacks(further, way) - lacks(far, way) > (FAR[1] - FAR[0]) / 2.0 && lacks(near, way) > 0.0)
    }

    /// Makes what is there hold before anything else comes: a cluster that is built badly is no piece.
    pub(super) fn mend_cluster(
        &mut self,
        cluster: usize,
        chance: &mut ChaCha8Rng,
        poses: &mut Vec<Inputs>,
        late: &dyn Fn() -> bool,
    ) {
        for _ in 0..STEPS * self.clusters.members[cluster].len() {
            if self.trial.bad.is_empty() || late() {
                break;
            }
            self.step(chance, poses);
        }
    }

    /// Tries a cluster as one piece elsewhere, and leaves it at the best of these places.
    pub(super) fn settle_cluster(&mut self, cluster: usize, chance: &mut ChaCha8Rng, late: &dyn Fn() -> bool) {
        let members = self.clusters.members[cluster].clone();
        let Some(&leader) = members.first().filter(|_| !late()) else { return };
        let mut around = Vec::new();
        let mut crowd = |local: &mut Self| members.iter().map(|&k| local.crowd(k, &mut around)).sum::<f64>();
        let mut best = (crowd(self) + 2.0 * LOOSE, None);
        for _ in 0..PLACES {
            let (pose, loose) = self.elsewhere_as_one(&members, chance);
            self.go_together(leader, &members, pose);
            let crowd = crowd(self) + loose;
            if let Some(delta) = self.trial.judge(best.0 - crowd) {
                best = (delta + crowd - 1e-9, Some(pose));
            }
            self.trial.undo();
        }
        if let Some(pose) = best.1 {
            self.go_together(leader, &members, pose);
            if self.trial.judge(f64::INFINITY).is_some() {
                self.trial.keep();
            } else {
                self.trial.undo();
            }
        }
    }

    /// Once all is there: clusters go elsewhere in turn, until there is room for paths around each.
    pub(super) fn arrange_clusters(&mut self, chance: &mut ChaCha8Rng, late: &dyn Fn() -> bool) {
        let mut around = Vec::new();
        for _ in 0..ROUNDS * self.clusters.members.len() {
            let crowded: Vec<usize> = (0..self.clusters.members.len())
                .filter(|&c| self.clusters.members[c].clone().into_iter().any(|k| self.crowd(k, &mut around) > 0.0))
                .collect();
            if crowded.is_empty() || late() {
                return;
            }
            // One that stands well may have to make room for the others.
            let any = chance.below(self.clusters.members.len());
            let one = if chance.below(3) == 0 { any } else { crowded[chance.below(crowded.len())] };
            self.settle_cluster(one, chance, late);
        }
    }

    /// Another pose for the first of some things that all go with it: turned by quarters, along each axis at a wall, a path
    /// away from it or from another thing, or anywhere; and what it costs that it is anywhere.
    fn elsewhere_as_one(&self, members: &[usize], chance: &mut ChaCha8Rng) -> (Inputs, f64) {
        let leader = members[0];
        let now = self.trial.inputs(leader);
        let quarters = if chance.below(2) == 0 { 0.0 } else { 90.0 * chance.below(4) as f64 };
        let may_turn = members.iter().all(|&k| {
            let yaw = crate::problem::pose::round_turn(self.trial.inputs(k)[3] + quarters);
            self.trial.turns[k] || self.trial.yaws[k].contains(&yaw)
        });
        let mut pose = if may_turn { turned(now, now[3] + quarters) } else { now };
        // How far all of it reaches from the leader, once turned.
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for &k in members {
            let there = carried(&now, &pose, &self.trial.inputs(k));
            let (rx, rz) = self.reach(k, &there);
            for (axis, (at, reach)) in [(there[0] - pose[0], rx), (there[2] - pose[2], rz)].into_iter().enumerate() {
                low[axis] = low[axis].min(at - reach);
                high[axis] = high[axis].max(at + reach);
            }
        }
        let (field, path) = (&self.field[leader], self.widest_path() + 1e-4);
        let other = self.trial.movable[chance.below(self.trial.movable.len())];
        let beside = !self.trial.away[other] && !members.contains(&other);
        let mut loose = 0.0;
        for (axis, k) in [(0, 0), (1, 2)] {
            let [least, most] = [field.min[axis] - low[axis], field.max[axis] - high[axis]];
            let [begin, end] = [self.trial.span[other].min[k], self.trial.span[other].max[k]];
            pose[k] = match chance.below(if beside { 8 } else { 5 }) {
                0 => least,
                1 => most,
                2 => least + path,
                3 => most - path,
                4 => {
                    loose += LOOSE;
                    chance.between(least.min(most), most.max(least))
                }
                5 => end - low[axis] + path,
                6 => begin - high[axis] - path,
                _ => begin - low[axis],
            };
        }
        (pose, loose)
    }
}
