//! Solving again: of several ways to make all hold once more, the one that moves least.
//!
//! A search that starts from a layout is charged for each thing that leaves its place, a little. What moved all the same
//! goes back where that breaks nothing, alone or with whatever has to go back with it. Where much is still elsewhere, the
//! search begins again from the layout with other random numbers and a higher charge.

use super::LocalSearch;
use super::course::Course;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::limit::Limit;
use scenelang_engine::trial::{Inputs, PathGroup, Span};

/// What it costs that a thing leaves its place: at first, and in each further search.
const CHARGE: f64 = 0.05;
const CHARGES: [f64; 6] = [0.1, 0.3, 1.0, 0.1, 0.3, 1.0];
/// The work of a further search: as much as the first one took, but at least and at most so much.
const WORK: [u64; 2] = [300_000, 2_000_000];
/// All further searches together may take so many times that.
const IN_ALL: u64 = 3;
/// How often all that moved is gone through to go back.
const PASSES: usize = 4;
/// What going back may cost.
const HARM: f64 = 1e-9;
/// Where everything was, and the corridors that were planned then.
struct Kept {
    moved: usize,
    poses: Vec<Inputs>,
    groups: Vec<PathGroup>,
}

impl LocalSearch<'_> {
    /// Remembers where things are that are given a place.
    pub fn remember_homes(&mut self, given: &[bool]) {
        let home = |i: usize| (given.get(i) == Some(&true) && self.trial.is_movable(i)).then(|| self.trial.inputs(i));
        self.at_first = (0..self.trial.count()).map(home).collect();
        self.charge = CHARGE;
    }

    /// What a trial costs because things leave the places that they were given, less what it gains where they go back.
    pub(super) fn charged(&self) -> f64 {
        if self.charge == 0.0 || !self.is_warm() {
            return 0.0;
        }
        let left = |(i, old, _): &(usize, Inputs, Span)| {
            let Some(home) = &self.at_first[*i] else { return 0.0 };
            f64::from(u8::from(*home != self.trial.inputs(*i))) - f64::from(u8::from(home != old))
        };
        self.charge * self.trial.moved.iter().map(left).sum::<f64>()
    }

    /// How many things are not where they were given a place.
    fn strayed(&self) -> usize {
        (0..self.trial.count()).filter(|&i| self.has_strayed(i)).count()
    }

    fn has_strayed(&self, i: usize) -> bool {
        self.at_first[i].is_some_and(|home| home != self.trial.inputs(i))
    }

    /// In a layout in which all holds: looks for one in which fewer things have left the places that they were given.
    pub fn move_less(&mut self, chance: &mut ChaCha8Rng, limit: &Limit, given: &[bool]) {
        if self.at_first.iter().all(Option::is_none) {
            return;
        }
        // Where nothing is new, something had to move.
        let least = usize::from(given.iter().all(|given| *given));
        let work = self.trial.work.clamp(WORK[0], WORK[1]);
        let end = self.trial.work + IN_ALL * work;
        self.go_back();
        let mut best = self.kept();
        for charge in CHARGES {
            if best.moved <= least || self.trial.work >= end || limit.is_over() {
                break;
            }
            (0..self.trial.count()).for_each(|i| self.trial.put(i, self.at_first[i].unwrap_or(self.trial.inputs(i))));
            self.course = Course::default();
            self.charge = charge;
            if self.search(chance, work, limit, given) {
                self.go_back();
                if self.strayed() < best.moved {
                    best = self.kept();
                }
            }
        }
        self.course = Course::default();
        self.trial.away.fill(false);
        self.trial.away_count = 0;
        self.trial.put_everything(&best.poses);
        self.trial.groups = best.groups;
        self.trial.judge_all();
        self.trial.judge_paths();
    }

    fn kept(&self) -> Kept {
        Kept { moved: self.strayed(), poses: self.trial.everything(), groups: self.trial.groups.clone() }
    }

    /// Things go back to where they were given a place, as far as everything holds then.
    fn go_back(&mut self) {
        for _ in 0..PASSES {
            let mut changed = false;
            for at in 0..self.trial.movable.len() {
                let i = self.trial.movable[at];
                changed |= self.has_strayed(i) && self.goes_back(i);
            }
            if !changed {
                break;
            }
        }
    }

    /// A thing goes back, and with it those that are in its way there and have left their places, too. Whether it did.
    fn goes_back(&mut self, first: usize) -> bool {
        let mut company = vec![first];
        loop {
            for &i in &company {
                let Some(home) = self.at_first[i] else { continue };
                self.trial.go(i, home);
            }
            let judged = self.trial.judge(f64::INFINITY);
            let failing: Vec<usize> = self
                .trial
                .fresh
                .iter()
                .filter(|(c, _, holds)| !holds && self.trial.is_hard(*c))
                .map(|(c, ..)| *c)
                .collect();
            if failing.is_empty() && judged.is_some_and(|delta| delta <= HARM) {
                self.trial.keep();
                return true;
            }
            self.trial.undo();
            let before = company.len();
            let mut more = Vec::new();
            failing.into_iter().for_each(|check| self.movers_of(check, &mut more));
            more.retain(|&i| self.has_strayed(i) && !company.contains(&i));
            company.extend(more);
            if company.len() == before {
                return false;
            }
        }
    }
}
