//! The loop of the quick search: take something violated and an object that it speaks of, try many poses, take the best
//! if it is better; where none is, let what is violated weigh more.

use super::judge::carried;
use super::moves::Inputs;
use super::{Home, Judge, Quick, Room};
use crate::checks::Check;
use crate::limit::Limit;
use crate::pool::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_lang::program::ObjectId;

/// What a violated check gains in weight when no move helps.
const STUBBORN: f64 = 0.5;
/// How many poses are tried for each object of a first layout.
const FIRST: usize = 24;
/// So many steps without a new best, and all begins anew, in a room that is full: per object, and per root of the number
/// of objects, whichever is less. Large scenes are better begun anew than waited for.
const PATIENCE: [f64; 2] = [400.0, 2500.0];
/// The part of it for a room with space: a bad arrangement is better left, and a bad plan of ways not quite so soon.
const HASTE: f64 = 0.1;
const HASTE_ON_WAYS: f64 = 0.3;
/// The covered share of the floor from which on a room is on the way to be full, and from which on it is.
const FULL: [f64; 2] = [0.5, 0.9];
/// How many exchanges of two objects are tried in a step.
const EXCHANGES: usize = 2;
/// How many moves of a whole array.
const TOGETHER: usize = 4;
/// How many places are tried, each with a look for the paths of a term that asks for them beside other things.
const PATHS: usize = 4;
/// How many moves with whatever has to go along, and of how many objects at most: at first, and once ways are looked at.
const ALONG: usize = 4;
const COMPANY: [usize; 2] = [12, 40];
/// How often the evaluator is asked whether there are ways, where all else holds: once in so many times.
const CONFIRMED: usize = 30;
/// How much more work ways are worth than all else, and what that takes at least.
const WALKING: u64 = 5;
const SOON: u64 = 150_000;
/// How often the plan of a way is looked at again when it is barred: once in so many times.
const PLANS: usize = 10;
/// What is left of the weight of a way when a better plan is found.
const FORGIVEN: f64 = 0.7;
/// How much more is walked round a thing each time that it could not be moved.
const RELUCTANCE: f64 = 0.2;

/// What a step does.
#[derive(Clone, Copy)]
enum Choice {
    /// The object goes there.
    Alone(Inputs),
    /// It changes places with another, and turns with it or not.
    Exchange(usize, bool),
    /// It goes there with all of its array.
    Together(Inputs),
    /// It goes there with whatever has to stay where it is in relation to it.
    Along(Inputs),
}

impl Quick<'_> {
    /// Searches until all holds that is judged here, or so much work is done. Whether it does.
    /// Objects that are `given` a place start from there at first.
    pub fn search(&mut self, chance: &mut ChaCha8Rng, budget: u64, limit: &Limit, given: &[bool]) -> bool {
        let late = || limit.is_over();
        let mut kept_in_place = given;
        let end = self.work + budget;
        self.wishing = false;
        let patience = self.patience();
        let mut turn = 0;
        let mut best = usize::MAX;
        let mut kept: Vec<Inputs> = Vec::new();
        let mut poses = Vec::new();
        loop {
            self.begin(chance, kept_in_place, &late);
            self.skew = true;
            kept_in_place = &[];
            let (mut idle, mut least) = (0, usize::MAX);
            let (begun, mut walking_since) = (self.work, self.work);
            turn += 1;
            let patience = (patience * luby(turn)) as usize;
            if std::env::var_os("DRV").is_some() {
                eprintln!("begin turn {turn} work {} patience {patience} bad {}", self.work, self.bad.len());
            }
            while self.work < end && !late() && idle < patience {
                if self.bad.is_empty() && !self.walking {
                    // Corridors are worth planning where all else is in its place.
                    self.walking = true;
                    walking_since = self.work;
                    if std::env::var_os("DRV").is_some() {
                        eprintln!("walking at {} turn {turn}", self.work);
                    }
                    self.plan_missing(&late);
                    (idle, least) = (0, usize::MAX);
                }
                if self.is_done(&late) {
                    break;
                }
                // An arrangement that is soon found, but bars ways, is better left than mended for long.
                let share = WALKING * (walking_since - begun).max(SOON);
                if !self.ways.is_empty()
                    && self.walking
                    && (self.work - walking_since) as f64 > luby(turn) * share as f64
                {
                    break;
                }
                self.step(chance, &mut poses);
                if std::env::var_os("DRV").is_some() && idle % 500 == 499 {
                    eprintln!("idle {idle} work {}", self.work);
                    self.report(&[]);
                }
                let bad = self.bad.len() + if self.walking { 0 } else { self.ways.len() };
                idle = if bad < least { 0 } else { idle + 1 };
                least = least.min(bad);
                if bad < best {
                    best = bad;
                    kept = (0..self.count()).map(|i| self.inputs(i)).collect();
                }
            }
            if self.movable.is_empty() || self.bad.is_empty() && self.walking && !late() {
                return self.is_done(&late);
            }
            if self.work >= end || late() {
                break;
            }
        }
        for (i, inputs) in kept.into_iter().enumerate() {
            self.put(i, inputs);
        }
        false
    }

    /// Whether all holds, paths that terms ask for beside other things included.
    pub(super) fn is_done(&mut self, late: &dyn Fn() -> bool) -> bool {
        self.bad.is_empty() && (self.paths.is_empty() || self.find_paths(late))
    }

    /// How many steps without a new best are worth waiting for, at least. What is packed tightly gets better slowly but
    /// surely, what has space is either soon right or never.
    fn patience(&self) -> f64 {
        let n = self.movable.len().max(5) as f64;
        let covered: f64 = (0..self.count())
            .filter(|&i| self.bases[i].is_empty() && matches!(self.homes[i], Home::Stands(_)))
            .map(|i| self.size[i][0] * self.size[i][2])
            .sum();
        let least = if self.ways.is_empty() { HASTE } else { HASTE_ON_WAYS };
        let full = (covered / self.floor_area() - FULL[0]) / (FULL[1] - FULL[0]);
        (least + (1.0 - least) * full).clamp(least, 1.0) * (PATIENCE[0] * n).min(PATIENCE[1] * n.sqrt())
    }

    /// Of all rooms, zones within them not counted again (m²).
    fn floor_area(&self) -> f64 {
        let is_zone =
            |room: &&Room| self.rooms.iter().any(|other| other.area > room.area && other.field.contains(&room.field));
        self.rooms.iter().filter(|room| !is_zone(room)).map(|room| room.area).sum()
    }

    /// A first layout: one object after the other at the best of some poses. Large ones come first, and what has to do
    /// with those that are there already.
    fn begin(&mut self, chance: &mut ChaCha8Rng, given: &[bool], late: &dyn Fn() -> bool) {
        self.weight.fill(1.0);
        self.reluctance.fill(0.0);
        self.work += self.count() as u64;
        let is_new = |i: &usize| !given.get(*i).copied().unwrap_or(false);
        let mut waiting: Vec<usize> = self.movable.iter().copied().filter(is_new).collect();
        self.away.fill(false);
        let is_warm = waiting.is_empty();
        if !is_warm {
            self.forget_ways();
        }
        self.trust_paths();
        for &i in &waiting {
            self.away[i] = true;
            for k in self.dependants(i) {
                self.away[k] = true;
            }
        }
        for i in 0..self.count() {
            self.put(i, self.inputs(i));
        }
        self.away_count = self.away.iter().filter(|a| **a).count();
        self.judge_all();
        let luck: Vec<f64> = (0..self.count()).map(|_| chance.between(0.7, 1.3)).collect();
        let company = chance.between(0.0, 1.0);
        let mut links = vec![0.0; self.count()];
        for i in (0..self.count()).filter(|i| !self.away[*i]) {
            self.link(i, &mut links);
        }
        let mut poses = Vec::new();
        while !waiting.is_empty() {
            let rank = |i: usize| {
                let door = if self.doors.contains(&i) { 100.0 } else { 0.0 };
                door + self.size[i][0] * self.size[i][2] * luck[i] + company * links[i]
            };
            let based = |i: &usize| self.bases[*i].iter().chain(&self.container[*i]).all(|base| !self.away[*base]);
            let ready = (0..waiting.len()).filter(|&k| based(&waiting[k]));
            let next = ready.max_by(|&a, &b| rank(waiting[a]).total_cmp(&rank(waiting[b]))).unwrap_or(0);
            let i = waiting.swap_remove(next);
            self.bring_in(i, chance, &mut poses, late);
            self.link(i, &mut links);
        }
        self.judge_all();
        self.walking = is_warm && self.bad.is_empty() || self.ways.is_empty();
        if self.walking {
            self.judge_ways();
            self.plan_missing(late);
        }
    }

    /// Objects that go wherever rules put them when this one moves.
    fn dependants(&self, i: usize) -> Vec<usize> {
        let rules = self.frame.followers[i].iter().map(|&rule| self.rules[rule].owner);
        rules.filter(|&k| k != i && !self.is_movable(k)).collect()
    }

    /// Gives an object its first place.
    fn bring_in(&mut self, i: usize, chance: &mut ChaCha8Rng, poses: &mut Vec<Inputs>, late: &dyn Fn() -> bool) {
        self.away[i] = false;
        let mut movers = Vec::new();
        for k in self.dependants(i) {
            movers.clear();
            self.movers(k, 0, &mut movers);
            self.away[k] = movers.iter().any(|mover| self.away[*mover]);
        }
        for k in std::iter::once(i).chain(self.dependants(i)) {
            self.put(k, self.inputs(k));
        }
        self.away_count = self.away.iter().filter(|a| **a).count();
        let pose = self.anywhere(i, chance);
        self.settle(i, pose);
        let mut best = (-1e-9, None);
        for round in 0..2 {
            if late() {
                return;
            }
            poses.clear();
            if round == 0 {
                for _ in 0..FIRST {
                    let pose = self.anywhere(i, chance);
                    poses.push(pose);
                }
            } else {
                self.poses(i, chance, poses);
                self.by_analogy(i, poses);
            }
            for &pose in poses.iter() {
                self.go(i, pose);
                if let Some(delta) = self.judge(best.0) {
                    best = (delta - 1e-9, Some(pose));
                }
                self.undo();
            }
            if let Some(pose) = best.1.take() {
                self.settle(i, pose);
            }
            best.0 = -1e-9;
            if self.terms_of[i].iter().all(|&t| self.bad_at[t] == u32::MAX) && self.hits[i].is_empty() {
                break;
            }
        }
    }

    /// Others have so much more to do with what is there.
    fn link(&self, i: usize, links: &mut [f64]) {
        for (other, weight) in &self.frame.related[i] {
            links[other.0 as usize] += weight;
        }
    }

    /// Judges everything anew.
    pub(super) fn judge_all(&mut self) {
        self.cost.fill(0.0);
        self.holds.fill(true);
        self.bad.clear();
        self.bad_at.fill(u32::MAX);
        self.hits.iter_mut().for_each(Vec::clear);
        self.moved = (0..self.count()).map(|i| (i, self.inputs(i), self.span[i])).collect();
        for i in 0..self.count() {
            self.put(i, self.inputs(i));
        }
        let _ = self.judge(f64::INFINITY);
        self.keep();
    }

    pub(super) fn settle(&mut self, i: usize, pose: Inputs) {
        self.go(i, pose);
        if self.judge(f64::INFINITY).is_some() {
            self.keep();
        } else {
            self.undo();
        }
    }

    /// One object of something violated goes to the best of many poses, or changes places with another.
    pub(super) fn step(&mut self, chance: &mut ChaCha8Rng, poses: &mut Vec<Inputs>) {
        self.work += 1;
        let check = self.bad[chance.below(self.bad.len())];
        if let Some(Judge::Way(way)) = self.judges.get(check)
            && (self.is_stale(*way) || chance.below(PLANS) == 0)
        {
            let way = *way;
            let before = self.cost[check];
            self.plan_again(way);
            if self.cost[check] < before {
                self.weight[check] = (self.weight[check] * FORGIVEN).max(1.0);
            }
            return;
        }
        if matches!(self.judges.get(check), Some(Judge::Mixed(mixed)) if mixed.walks())
            && self.bad.iter().all(|c| self.paths.contains(c))
            && chance.below(2) == 0
        {
            self.clear_path(check, chance, poses);
            return;
        }
        if self.bad.iter().all(|c| matches!(self.judges.get(*c), Some(Judge::Way(_))))
            && chance.below(CONFIRMED) == 0
            && self.confirm_ways()
        {
            return;
        }
        let Some(i) = self.culprit(check, chance) else {
            self.weight[check] += STUBBORN;
            return;
        };
        self.poses(i, chance, poses);
        let mut best = (1e-9, None);
        let now = self.inputs(i);
        for &pose in poses.iter() {
            if pose == now {
                continue;
            }
            self.go(i, pose);
            if let Some(delta) = self.judge(best.0) {
                best = (delta, Some(pose));
            }
            self.undo();
        }
        let mut choice = best.1.map(Choice::Alone);
        for _ in 0..EXCHANGES {
            let j = self.movable[chance.below(self.movable.len())];
            if i == j {
                continue;
            }
            let turn = chance.below(2) == 0;
            self.exchange(i, j, turn);
            if let Some(delta) = self.judge(best.0) {
                best.0 = delta;
                choice = Some(Choice::Exchange(j, turn));
            }
            self.undo();
        }
        let mut group = Vec::new();
        if !self.frame.siblings[i].is_empty() {
            group = self.group(i, chance);
            for _ in 0..TOGETHER {
                let pose = poses[chance.below(poses.len())];
                self.go_together(i, &group, pose);
                if let Some(delta) = self.judge(best.0) {
                    best.0 = delta;
                    choice = Some(Choice::Together(pose));
                }
                self.undo();
            }
        }
        // As often as it pays.
        let [pays, tried] = self.along;
        let often = (pays + 1.0) / (tried + 5.0) > 0.3 * chance.unit();
        let count = if often { ALONG } else { 0 };
        self.along[1] += f64::from(u8::from(often));
        let mut along: Vec<Inputs> = (0..count).map(|_| poses[chance.below(poses.len())]).collect();
        if self.walking && !self.ways.is_empty() {
            self.out_of_the_way(i, &mut along);
            along.extend((0..ALONG).map(|_| {
                // Far away, but turned as it is: a whole row may go there.
                let pose = self.anywhere(i, chance);
                [pose[0], now[1], pose[2], now[3], now[4], now[5]]
            }));
        }
        for pose in along {
            if pose == now || !self.go_along(i, pose) {
                self.undo();
                continue;
            }
            if let Some(delta) = self.judge(best.0) {
                best.0 = delta;
                choice = Some(Choice::Along(pose));
            }
            self.undo();
        }
        match choice {
            Some(Choice::Along(pose)) => {
                self.along[0] += 1.0;
                self.go_along(i, pose);
            }
            Some(Choice::Alone(pose)) => self.go(i, pose),
            Some(Choice::Exchange(j, turn)) => self.exchange(i, j, turn),
            Some(Choice::Together(pose)) => self.go_together(i, &group, pose),
            None => {}
        }
        if choice.is_some() && self.judge(f64::INFINITY).is_some() {
            self.keep();
        }
        if best.0 > -1e-9 {
            self.reluctance[i] += RELUCTANCE;
            for at in 0..self.bad.len() {
                self.weight[self.bad[at]] += STUBBORN * chance.unit();
            }
        }
    }

    /// Looks for a place for an object where all else holds and a term has the path that it asks for.
    fn clear_path(&mut self, t: usize, chance: &mut ChaCha8Rng, poses: &mut Vec<Inputs>) {
        let own = self.culprit(t, chance).filter(|_| chance.below(2) == 0);
        let i = own.unwrap_or(self.movable[chance.below(self.movable.len())]);
        self.poses(i, chance, poses);
        let before = self.inputs(i);
        for _ in 0..PATHS {
            let pose = poses[chance.below(poses.len())];
            self.go(i, pose);
            if self.judge(1e-9).is_none() {
                self.undo();
                continue;
            }
            self.keep();
            if self.find_paths_of(t) {
                return;
            }
            self.settle(i, before);
        }
    }

    /// An object goes somewhere with others, as if all were one piece.
    fn go_together(&mut self, i: usize, group: &[usize], pose: Inputs) {
        let old = self.inputs(i);
        self.go(i, pose);
        let pose = self.inputs(i);
        for &k in group {
            if k != i && self.is_movable(k) {
                self.go(k, carried(&old, &pose, &self.inputs(k)));
            }
        }
    }

    /// An object goes somewhere, and with it go others whose relation to it would be broken, and others whose relation to
    /// those would. Whether there are such.
    fn go_along(&mut self, i: usize, pose: Inputs) -> bool {
        let old = self.inputs(i);
        self.go(i, pose);
        let pose = self.inputs(i);
        let mut looked = 0;
        let most = COMPANY[usize::from(self.walking && !self.ways.is_empty())];
        while looked < self.moved.len() && self.moved.len() < most {
            let k = self.moved[looked].0;
            looked += 1;
            for at in 0..self.terms_of[k].len() {
                let t = self.terms_of[k][at];
                let objects = &self.frame.terms[t].objects;
                if !(2..=3).contains(&objects.len()) || self.bad_at[t] != u32::MAX {
                    continue;
                }
                let stays = |o: &&ObjectId| !self.moved.iter().any(|(m, ..)| *m == o.0 as usize);
                let others: Vec<usize> = objects.iter().filter(stays).map(|o| o.0 as usize).collect();
                if others.is_empty() || self.term(t).1 {
                    continue;
                }
                for other in others {
                    if self.is_movable(other) {
                        self.go(other, carried(&old, &pose, &self.inputs(other)));
                    }
                }
            }
        }
        self.moved.len() > 1
    }

    /// Its array; or that with others that have to do with it, and with those, but for what is beyond one of them.
    fn group(&self, i: usize, chance: &mut ChaCha8Rng) -> Vec<usize> {
        let mut found = vec![i];
        let array = |k: usize| self.frame.siblings[k].iter().map(|o| o.0 as usize);
        found.extend(array(i));
        let others: Vec<usize> = self.neighbours(i).filter(|k| !found.contains(k)).collect();
        if others.is_empty() || chance.below(4) > 0 {
            return found;
        }
        let beyond = others[chance.below(others.len())];
        let mut open = found.clone();
        while let Some(k) = open.pop() {
            for next in self.neighbours(k).chain(array(k)) {
                if next != beyond && !found.contains(&next) && !array(beyond).any(|b| b == next) {
                    found.push(next);
                    open.push(next);
                }
            }
        }
        found
    }

    /// Elements of arrays that it has to do with.
    fn neighbours(&self, i: usize) -> impl Iterator<Item = usize> + '_ {
        let related = self.related[i].iter().copied();
        related.filter(|&k| !self.frame.siblings[k].is_empty())
    }

    fn exchange(&mut self, i: usize, j: usize, turn: bool) {
        let (a, b) = (self.inputs(i), self.inputs(j));
        let at = |own: Inputs, theirs: Inputs| {
            let mut next = if turn { theirs } else { own };
            (next[0], next[2]) = (theirs[0], theirs[2]);
            next[1] = own[1];
            next
        };
        self.go(i, at(a, b));
        self.go(j, at(b, a));
    }

    /// Who has to move for an object to move: itself, or those that rules set its place by; into `out`.
    fn movers(&self, i: usize, depth: usize, out: &mut Vec<usize>) {
        if self.is_movable(i) && !out.contains(&i) {
            out.push(i);
        }
        // Part of where it is may be set by others.
        if depth < 8 {
            self.bases[i].iter().for_each(|&base| self.movers(base, depth + 1, out));
        }
    }

    /// A movable object that a check speaks of.
    fn culprit(&self, check: usize, chance: &mut ChaCha8Rng) -> Option<usize> {
        let mut movers = Vec::new();
        let mut moves = |o: &ObjectId| self.movers(o.0 as usize, 0, &mut movers);
        match self.numbering.check(check) {
            Check::Term(t) => {
                match &self.judges[t] {
                    Judge::Way(way) => return self.hindrance(*way, chance),
                    Judge::Clear(clear) if chance.below(2) == 0 => {
                        let mut blockers = self.in_the_way(clear);
                        blockers.retain(|j| self.is_movable(*j));
                        if !blockers.is_empty() {
                            return Some(blockers[chance.below(blockers.len())]);
                        }
                    }
                    _ => {}
                }
                self.frame.terms[t].objects.iter().for_each(&mut moves);
            }
            Check::Collide(a, b) => [a, b].iter().for_each(&mut moves),
            Check::Bounds(a) | Check::Support(a) => moves(&a),
        }
        movers.get(chance.below(movers.len())).copied()
    }
}

/// The series 1, 1, 2, 1, 1, 2, 4, … by which restarts are rarely much later than the best moment for them, which nobody
/// knows (Luby, Sinclair, Zuckerman: Optimal speedup of Las Vegas algorithms, 1993). Counted from 1.
fn luby(turn: u32) -> f64 {
    let length = (turn + 1).next_power_of_two();
    if length == turn + 1 { f64::from(length / 2) } else { luby(turn + 1 - length / 2) }
}

#[cfg(test)]
mod tests {
    use super::luby;

    #[test]
    fn restarts_follow_the_series() {
        let series: Vec<f64> = (1..=15).map(luby).collect();
        assert_eq!(series, [1, 1, 2, 1, 1, 2, 4, 1, 1, 2, 1, 1, 2, 4, 8].map(f64::from));
    }
}
