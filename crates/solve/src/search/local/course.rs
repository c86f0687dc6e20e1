//! The course of a local search: a first layout, then step after step; where nothing gets better for long, a part of the best
//! layout is built anew (`ruin`), and after a few of these all of it. It can be interrupted and taken up again.

use super::ruin::Lineage;
use super::{Home, LocalSearch};
use rand_chacha::ChaCha8Rng;
use scenelang_engine::limit::Limit;
use scenelang_engine::trial::{Inputs, RoomBox};

/// So many steps without a new best, and all begins anew, in a room that is full: per object, and per root of the number
/// of objects, whichever is less. Large scenes are better begun anew than waited for.
const PATIENCE: [f64; 2] = [400.0, 2500.0];
/// The part of it for a room with space: a bad arrangement is better left, and a bad plan of paths not quite so soon.
const HASTE: f64 = 0.1;
const HASTE_ON_PATHS: f64 = 0.3;
/// The covered share of the floor from which on a room is on the way to be full, and from which on it is.
const FULL: [f64; 2] = [0.5, 0.9];
/// How much more work paths are worth than all else, and what that takes at least.
const WALKING: u64 = 5;
const SOON: u64 = 150_000;
/// The part of the patience for a turn that began from a part of a layout, since what is to be found there is found soon, and
/// how much longer paths may be barred in it.
const REBUILT: [f64; 2] = [0.25, 3.0];
/// Turns in which things stand as they do worse come once in so many, and if they do much worse, once in so many.
const RARELY: [u32; 2] = [4, 16];
/// Paths that are barred by no more than this part of what they were are worth going on for.
const LESS: f64 = 0.9;
/// How far a search is.
#[derive(Clone, Debug, Default)]
pub(super) struct Course {
    /// How often all was begun anew.
    pub(super) turn: u32,
    /// The best layout since then, parts of which are built anew.
    pub(super) lineage: Lineage,
    /// Whether the present turn began from a part of that.
    pub(super) is_rebuilt: bool,
    /// Whether the present turn goes on, and whether it began from places that were given.
    open: bool,
    warm: bool,
    /// Steps without a new best in this turn, and how much was violated at its best.
    idle: usize,
    least: usize,
    /// The work when this turn began, and when paths came to be looked at.
    begun: u64,
    walking_since: u64,
    /// The work when paths were last barred less than ever in this turn, and how much that was.
    freed: u64,
    barred: f64,
    /// How much was violated at best in turns in which things stand square, and in others.
    least_of: [Option<usize>; 2],
    /// How much was violated at best in all turns, and where everything was then.
    best: Option<(usize, Vec<Inputs>)>,
}

impl LocalSearch<'_> {
    /// Searches until all holds that is judged here, or so much work is done. Whether it does. Objects that are `given`
    /// a place start from there at first. Asked again it goes on where it was.
    pub fn search(&mut self, chance: &mut ChaCha8Rng, budget: u64, limit: &Limit, given: &[bool]) -> bool {
        let late = || limit.is_over();
        let end = self.trial.work + budget;
        self.trial.preferring = false;
        let patience = [self.patience(HASTE), self.patience(HASTE_ON_PATHS)];
        let mut poses = Vec::new();
        loop {
            if !self.course.open {
                if self.may_ruin() {
                    self.ruin(chance, &late);
                } else {
                    self.begin_anew(chance, given, &late);
                }
            }
            // Square turns and others come in pairs of the same length.
            let mut turn = if self.course.is_rebuilt { REBUILT } else { [luby(self.course.turn.div_ceil(2)); 2] };
            let mut patience = patience.map(|steps| steps * turn[0]);
            if self.is_clustered && !self.course.is_rebuilt {
                // Where clusters stand well, paths are soon free; else they hardly ever are, however long the turn is.
                patience[1] /= turn[0];
                turn[1] = 1.0;
            }
            let patience = patience.map(|steps| steps as usize);
            // What has its place already is not given up so soon.
            while self.trial.work < end
                && !late()
                && self.course.idle
                    < patience[usize::from(self.is_warm() || self.walking && self.trial.path_count() > 0)]
            {
                if self.trial.bad.is_empty() && !self.walking {
                    // Corridors are worth planning where all else is in its place.
                    self.walking = true;
                    self.trial.plan_missing(&late);
                    (self.course.walking_since, self.course.idle, self.course.least) = (self.trial.work, 0, usize::MAX);
                }
                if self.is_done(&late) || self.bars_paths(turn[1]) {
                    break;
                }
                self.step(chance, &mut poses);
                self.note_best();
            }
            if self.trial.is_settled() || self.trial.bad.is_empty() && self.walking && !late() {
                self.course = Course::default();
                return self.is_done(&late);
            }
            if self.trial.work >= end || late() {
                return false;
            }
            self.course.open = false;
        }
    }

    /// Begins a turn with a new layout.
    fn begin_anew(&mut self, chance: &mut ChaCha8Rng, given: &[bool], late: &dyn Fn() -> bool) {
        let given = if self.course.turn == 0 { given } else { &[] };
        let skew = self.next_is_skew() || given.contains(&true);
        self.skew = skew && self.course.turn > 0;
        self.stacks = self.course.turn % 4 == 3 && self.covered() >= FULL[1];
        // What stands in clusters hardly ever leaves space for paths that was not left at first.
        self.air = if self.is_other && !self.is_clustered { 0.0 } else { self.widest_path() };
        self.course.is_rebuilt = false;
        let begun = self.trial.work;
        self.begin(chance, given, late);
        self.skew = skew;
        let Course { turn, best, least_of, .. } = std::mem::take(&mut self.course);
        let lineage = Lineage::begun_at(begun);
        self.course =
            Course { turn: turn + 1, warm: given.contains(&true), least_of, best, lineage, ..Course::default() };
        self.open_turn();
    }

    /// A turn begins here.
    pub(super) fn open_turn(&mut self) {
        let now = self.trial.work;
        let course = &mut self.course;
        (course.open, course.idle, course.least) = (true, 0, usize::MAX);
        (course.begun, course.walking_since, course.freed, course.barred) = (now, now, now, f64::INFINITY);
    }

    /// Whether things may stand askew in the next turn. They stand square at first: that is what people expect, and rows of
    /// them do not drift. What does better is done more often from then on.
    fn next_is_skew(&self) -> bool {
        let Course { turn, least_of: [square, skew], .. } = &self.course;
        let other = (turn % 2 == 1) != self.is_other;
        match (square, skew) {
            (Some(square), Some(skew)) if square != skew => {
                let much = *square.max(skew) > 2 * *square.min(skew);
                let rarely = RARELY[usize::from(much)];
                (skew < square) != (turn % rarely == rarely - 1)
            }
            _ => other,
        }
    }

    /// The width of the widest path that is looked at.
    pub(super) fn widest_path(&self) -> f64 {
        let groups = (0..self.trial.groups.len()).filter(|&group| self.trial.looks_at(group));
        groups.map(|group| 2.0 * self.trial.groups[group].width()).fold(0.0, f64::max)
    }

    /// A search of another kind: its first turn is none in which things stand square, and it leaves no room for paths at
    /// first; in a crowded room it plans them from the beginning instead. Where most things stand in clusters, it leaves room
    /// for paths, too, and builds each cluster as one piece from its first turn on.
    pub fn of_another_kind(mut self) -> Self {
        self.is_other = true;
        self
    }

    /// Whether things have places already, of which as few as possible are given up.
    pub(super) fn is_warm(&self) -> bool {
        self.course.warm
    }

    /// Whether an arrangement was soon found, but bars paths for long: it is better left than repaired.
    fn bars_paths(&self, turn: f64) -> bool {
        let Course { begun, walking_since, freed, .. } = self.course;
        let share = WALKING * (walking_since - begun).max(SOON);
        self.walking
            && self.trial.path_count() > 0
            && (self.trial.work - freed.max(walking_since)) as f64 > turn * share as f64
    }

    /// Remembers what is violated least.
    fn note_best(&mut self) {
        let bad = self.trial.bad.len() + if self.walking { 0 } else { self.trial.path_count() };
        let barred = self.trial.walks.iter().map(|(t, _)| self.trial.cost[*t]).sum::<f64>();
        self.note_lineage(bad);
        let course = &mut self.course;
        course.idle = if bad < course.least { 0 } else { course.idle + 1 };
        course.least = course.least.min(bad);
        if self.walking && barred < LESS * course.barred {
            (course.barred, course.freed, course.idle) = (barred, self.trial.work, 0);
        }
        let least = &mut course.least_of[usize::from(self.skew)];
        *least = Some(least.map_or(bad, |least| least.min(bad)));
        if course.best.as_ref().is_none_or(|(least, _)| bad < *least) {
            self.course.best = Some((bad, self.trial.everything()));
        }
    }

    /// How much was violated at best.
    pub fn least_violated(&self) -> usize {
        self.course.best.as_ref().map_or(usize::MAX, |(least, _)| *least)
    }

    /// Puts everything where the least was violated.
    pub fn restore_best(&mut self) {
        if let Some((_, poses)) = self.course.best.take() {
            self.trial.put_everything(&poses);
        }
        self.course = Course::default();
    }

    /// Whether all holds, paths that terms ask for beside other things included.
    pub(super) fn is_done(&mut self, late: &dyn Fn() -> bool) -> bool {
        self.trial.bad.is_empty() && (self.trial.path_terms.is_empty() || self.trial.find_paths(late))
    }

    /// How many steps without a new best are worth waiting for, at least. What is packed tightly gets better slowly but
    /// surely, what has space is either soon right or never.
    fn patience(&self, least: f64) -> f64 {
        let n = self.trial.movable.len().max(5) as f64;
        let full = (self.covered() - FULL[0]) / (FULL[1] - FULL[0]);
        (least + (1.0 - least) * full).clamp(least, 1.0) * (PATIENCE[0] * n).min(PATIENCE[1] * n.sqrt())
    }

    /// The part of the floor that things stand on.
    pub(super) fn covered(&self) -> f64 {
        let stands = |&i: &usize| self.bases[i].is_empty() && matches!(self.homes[i], Home::Stands(_));
        let covered: f64 =
            (0..self.trial.count()).filter(stands).map(|i| self.trial.size[i][0] * self.trial.size[i][2]).sum();
        covered / self.floor_area()
    }

    /// Of all rooms, zones within them not counted again (m²).
    fn floor_area(&self) -> f64 {
        let is_zone = |room: &&RoomBox| {
            self.trial.rooms.iter().any(|other| other.area > room.area && other.field.contains(&room.field))
        };
        self.trial.rooms.iter().filter(|room| !is_zone(room)).map(|room| room.area).sum()
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
