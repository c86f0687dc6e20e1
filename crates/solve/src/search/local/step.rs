//! A step of a local search: take something violated and an object that it speaks of, try many poses, take the best if
//! it is better; where none is, let what is violated weigh more.

use super::{Home, LocalSearch};
use crate::search::chance::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::frame::checks::Check;
use scenelang_engine::trial::{Inputs, Judge, carried};
use scenelang_lang::program::ObjectId;

/// What a violated check gains in weight when nothing can be moved for it.
const STUBBORN: f64 = 0.5;
/// What weighs so much has been violated for long: doors are moved for it, too.
const INSISTENT: f64 = 2.0;
/// How many exchanges of two objects are tried in a step.
const EXCHANGES: usize = 2;
/// How many moves of a whole array.
const TOGETHER: usize = 4;
/// While preferences are raised: groups are mirrored once in so many steps.
const MIRRORED: usize = 4;
/// How many places are tried, each with a look for the paths of a term that asks for them beside other things.
const PATHS: usize = 4;
/// How many moves with whatever has to go along, and of how many objects at most: at first, and once paths are looked at.
const ALONG: usize = 4;
const COMPANY: [usize; 2] = [12, 40];
/// How often the evaluator is asked whether there are paths, where all else holds: once in so many times where much stands
/// in the corridors, and where what does costs no more than so.
const CONFIRMED: [usize; 2] = [200, 20];
const NEARLY: f64 = 0.5;
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
    /// It is mirrored along this axis, with what it has most to do with.
    Mirrored(usize),
}

/// The best choice of a step so far, and by how much the layout costs more with it.
struct Best {
    delta: f64,
    choice: Option<Choice>,
}

impl LocalSearch<'_> {
    /// One object of something violated goes to the best of many poses, or changes places with another.
    pub(super) fn step(&mut self, chance: &mut ChaCha8Rng, poses: &mut Vec<Inputs>) {
        // Where the program fixes everything there is nothing to try;
        // and where ways alone are missing that are only preferred, nothing counts as violated.
        if self.trial.is_settled() || self.trial.bad.is_empty() {
            return;
        }
        self.trial.work += 1;
        let check = self.pick(chance);
        if self.frees_path(check, chance, poses) || self.takes_variable(check, chance) || self.takes_lean(check, chance)
        {
            return;
        }
        let kept = |i: &usize| self.keeps_openings && self.is_opening(*i);
        let Some(i) = self.culprit(check, chance).filter(|i| !kept(i)) else {
            self.trial.weight[check] += STUBBORN;
            return;
        };
        let mut best = Best { delta: 1e-9, choice: None };
        self.poses(i, chance, poses);
        self.try_alone(i, poses, &mut best);
        self.try_exchanges(i, chance, &mut best);
        let group = if self.trial.frame.siblings[i].is_empty() { Vec::new() } else { self.group(i, chance) };
        // What has its place already stays there if one thing alone can make way.
        if !(self.is_warm() && best.choice.is_some()) {
            self.try_together(i, &group, poses, chance, &mut best);
            self.try_along(i, poses, chance, &mut best);
        }
        if !self.stake.is_empty() && chance.below(MIRRORED) == 0 {
            for axis in [0, 2] {
                if self.go_mirrored(i, axis) {
                    self.weigh(Choice::Mirrored(axis), &mut best);
                }
            }
        }
        match best.choice {
            Some(Choice::Along(pose)) => {
                self.along[0] += 1.0;
                self.go_along(i, pose);
            }
            Some(Choice::Alone(pose)) => self.trial.go(i, pose),
            Some(Choice::Exchange(j, turn)) => self.exchange(i, j, turn),
            Some(Choice::Mirrored(axis)) => {
                self.go_mirrored(i, axis);
            }
            Some(Choice::Together(pose)) => self.go_together(i, &group, pose),
            None => {}
        }
        if best.choice.is_some() && self.trial.judge(f64::INFINITY).is_some() {
            self.trial.keep();
        }
        if best.delta > -1e-9 {
            self.trial.reluctance[i] += RELUCTANCE;
            self.insist(chance);
        }
    }

    /// Where a path is missing: a new plan, another arrangement, a question to the evaluator. Whether the step is done.
    fn frees_path(&mut self, check: usize, chance: &mut ChaCha8Rng, poses: &mut Vec<Inputs>) -> bool {
        if let Some(Judge::PathGroup(group)) = self.trial.judges.get(check)
            && (self.trial.is_stale(*group) || chance.below(PLANS) == 0)
        {
            let group = *group;
            let before = self.trial.cost[check];
            self.trial.plan_again(group);
            if self.trial.cost[check] < before {
                self.trial.weight[check] = (self.trial.weight[check] * FORGIVEN).max(1.0);
            }
            return true;
        }
        if matches!(self.trial.judges.get(check), Some(Judge::Mixed(mixed)) if mixed.walks())
            && self.trial.bad.iter().all(|c| self.trial.path_terms.contains(c))
            && chance.below(2) == 0
        {
            self.clear_path(check, chance, poses);
            return true;
        }
        if !self.are_only_paths_barred() {
            return false;
        }
        let nearly = self.trial.bad.iter().map(|check| self.trial.cost[*check]).sum::<f64>() < NEARLY;
        if chance.below(CONFIRMED[usize::from(nearly)]) == 0 && self.trial.confirm_paths() {
            return true;
        }
        self.rearranges(chance) && self.rearrange(chance, poses)
    }

    /// Judges a trial, and takes it back; it is remembered if it is the best yet.
    fn weigh(&mut self, choice: Choice, best: &mut Best) {
        let charged = self.charged();
        if let Some(delta) = self.trial.judge(best.delta - charged) {
            *best = Best { delta: delta + charged, choice: Some(choice) };
        }
        self.trial.undo();
    }

    fn try_alone(&mut self, i: usize, poses: &[Inputs], best: &mut Best) {
        let now = self.trial.inputs(i);
        for &pose in poses.iter().filter(|pose| **pose != now) {
            self.trial.go(i, pose);
            self.weigh(Choice::Alone(pose), best);
        }
    }

    fn try_exchanges(&mut self, i: usize, chance: &mut ChaCha8Rng, best: &mut Best) {
        for _ in 0..EXCHANGES {
            let j = self.trial.movable[chance.below(self.trial.movable.len())];
            if i != j && !self.trial.away[j] {
                let turn = chance.below(2) == 0;
                self.exchange(i, j, turn);
                self.weigh(Choice::Exchange(j, turn), best);
            }
        }
    }

    fn try_together(&mut self, i: usize, group: &[usize], poses: &[Inputs], chance: &mut ChaCha8Rng, best: &mut Best) {
        for _ in 0..if group.is_empty() { 0 } else { TOGETHER } {
            let pose = poses[chance.below(poses.len())];
            self.go_together(i, group, pose);
            self.weigh(Choice::Together(pose), best);
        }
    }

    fn try_along(&mut self, i: usize, poses: &[Inputs], chance: &mut ChaCha8Rng, best: &mut Best) {
        let now = self.trial.inputs(i);
        // As often as it pays.
        let [pays, tried] = self.along;
        let often = (pays + 1.0) / (tried + 5.0) > 0.3 * chance.unit();
        let count = if often { ALONG } else { 0 };
        self.along[1] += f64::from(u8::from(often));
        let mut along: Vec<Inputs> = (0..count).map(|_| poses[chance.below(poses.len())]).collect();
        if self.walking && self.trial.path_count() > 0 {
            self.trial.out_of_the_way(i, &mut along);
            along.extend((0..ALONG).map(|_| {
                // Far away, but turned as it is: a whole row may go there.
                let pose = self.anywhere(i, chance);
                [pose[0], now[1], pose[2], now[3], now[4], now[5]]
            }));
        }
        for pose in along {
            if pose != now && self.go_along(i, pose) {
                self.weigh(Choice::Along(pose), best);
            } else {
                self.trial.undo();
            }
        }
    }

    /// Looks for a place for an object where all else holds and a term has the path that it asks for.
    fn clear_path(&mut self, t: usize, chance: &mut ChaCha8Rng, poses: &mut Vec<Inputs>) {
        let own = self.culprit(t, chance).filter(|_| chance.below(2) == 0);
        let i = own.unwrap_or(self.trial.movable[chance.below(self.trial.movable.len())]);
        self.poses(i, chance, poses);
        let before = self.trial.inputs(i);
        for _ in 0..PATHS {
            let pose = poses[chance.below(poses.len())];
            self.trial.go(i, pose);
            if self.trial.judge(1e-9).is_none() {
                self.trial.undo();
                continue;
            }
            self.trial.keep();
            if self.trial.find_paths_of(t) {
                return;
            }
            self.trial.settle(i, before);
        }
    }

    /// An object goes somewhere with others, as if all were one piece.
    pub(super) fn go_together(&mut self, i: usize, group: &[usize], pose: Inputs) {
        let old = self.trial.inputs(i);
        self.trial.go(i, pose);
        let pose = self.trial.inputs(i);
        for &k in group {
            if k != i && self.trial.is_movable(k) {
                self.trial.go(k, carried(&old, &pose, &self.trial.inputs(k)));
            }
        }
    }

    /// An object goes somewhere, and with it go others whose relation to it would be broken, and others whose relation to
    /// those would. Whether there are such.
    pub(super) fn go_along(&mut self, i: usize, pose: Inputs) -> bool {
        let old = self.trial.inputs(i);
        self.trial.go(i, pose);
        let pose = self.trial.inputs(i);
        let mut looked = 0;
        let most = COMPANY[usize::from(self.walking && self.trial.path_count() > 0)];
        while looked < self.trial.moved.len() && self.trial.moved.len() < most {
            let k = self.trial.moved[looked].0;
            looked += 1;
            // While preferences are raised, those that hold tie things together, too.
            let preferences = if self.stake.is_empty() { 0 } else { self.trial.preferences_of[k].len() };
            for at in 0..self.trial.terms_of[k].len() + preferences {
                let hard = self.trial.terms_of[k].len();
                let t = if at < hard { self.trial.terms_of[k][at] } else { self.trial.preferences_of[k][at - hard] };
                let objects = &self.trial.frame.terms[t].objects;
                if !(2..=3).contains(&objects.len()) || self.trial.is_bad(t) {
                    continue;
                }
                let stays = |o: &&ObjectId| !self.trial.moved.iter().any(|(m, ..)| *m == o.0 as usize);
                let others: Vec<usize> = objects.iter().filter(stays).map(|o| o.0 as usize).collect();
                if others.is_empty() || self.trial.term(t).1 {
                    continue;
                }
                for other in others {
                    if self.trial.is_movable(other) {
                        self.trial.go(other, carried(&old, &pose, &self.trial.inputs(other)));
                    }
                }
            }
        }
        self.trial.moved.len() > 1
    }

    /// Its array; or that with others that have to do with it, and with those, but for what is beyond one of them.
    fn group(&self, i: usize, chance: &mut ChaCha8Rng) -> Vec<usize> {
        let mut found = vec![i];
        let array = |k: usize| self.trial.frame.siblings[k].iter().map(|o| o.0 as usize);
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
        related.filter(|&k| !self.trial.frame.siblings[k].is_empty())
    }

    fn exchange(&mut self, i: usize, j: usize, turn: bool) {
        let (a, b) = (self.trial.inputs(i), self.trial.inputs(j));
        let at = |own: Inputs, theirs: Inputs| {
            let mut next = if turn { theirs } else { own };
            (next[0], next[2]) = (theirs[0], theirs[2]);
            next[1] = own[1];
            next
        };
        self.trial.go(i, at(a, b));
        self.trial.go(j, at(b, a));
    }

    /// Who has to move for an object to move: itself, or those that rules set its place by; into `out`.
    pub(super) fn movers(&self, i: usize, depth: usize, out: &mut Vec<usize>) {
        if self.trial.is_movable(i) && !out.contains(&i) {
            out.push(i);
        }
        // Part of where it is may be set by others.
        if depth < 8 {
            self.bases[i].iter().for_each(|&base| self.movers(base, depth + 1, out));
        }
    }

    /// Something that a group of paths would be better without, or one of its ends where those are off it.
    pub(super) fn hindrance(&self, group: usize, chance: &mut ChaCha8Rng) -> Option<usize> {
        let found = self.trial.hindrances(group);
        found.get(chance.below(found.len())).copied()
    }

    /// A movable object that a check speaks of.
    fn culprit(&self, check: usize, chance: &mut ChaCha8Rng) -> Option<usize> {
        let mut movers = Vec::new();
        let mut moves = |o: &ObjectId| self.movers(o.0 as usize, 0, &mut movers);
        match self.trial.numbering.check(check) {
            Check::Term(t) => {
                match &self.trial.judges[t] {
                    Judge::PathGroup(group) => return self.hindrance(*group, chance),
                    Judge::Clear(clear) if chance.below(2) == 0 => {
                        let mut blockers = self.trial.in_the_way(clear);
                        blockers.retain(|j| self.trial.is_movable(*j));
                        if !blockers.is_empty() {
                            return Some(blockers[chance.below(blockers.len())]);
                        }
                    }
                    _ => {}
                }
                self.trial.frame.terms[t].objects.iter().for_each(&mut moves);
            }
            Check::Collide(a, b) => [a, b].iter().for_each(&mut moves),
            Check::Bounds(a) | Check::Support(a) => moves(&a),
        }
        // Openings stay where they are as long as something else may help.
        let opens = |i: &usize| self.is_opening(*i);
        if self.keeps_openings || self.trial.weight[check] < INSISTENT && !movers.iter().all(opens) {
            movers.retain(|i| !opens(i));
        }
        movers.get(chance.below(movers.len())).copied()
    }

    /// Whether an object is in a wall: a door or a window.
    fn is_opening(&self, i: usize) -> bool {
        matches!(self.homes[i], Home::Door(_))
    }
}
