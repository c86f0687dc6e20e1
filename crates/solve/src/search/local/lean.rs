//! Things that do not stand upright: they lie, lean or are tipped, because the program or the layout says so.
//!
//! The yaw is the outermost of the three turns. So such a thing is, for the search, an upright one with another shape:
//! each of its parts is the box around it as it leans. Where that is more than the part, the physical rules are asked of
//! the evaluator; so is every formula that speaks of such a thing.
//!
//! How a thing leans is left as it is unless the program speaks of it; then it is searched for as the values of decision
//! variables are.

use super::LocalSearch;
use crate::search::chance::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::frame::checks::Check;
use scenelang_lang::program::{Node, ObjectId};

/// A small turn to see how a margin changes (degrees), and how much further than needed one goes, against rounding.
const PROBE: f64 = 0.05;
const EASE: f64 = 1e-6;
/// How often the slope is followed.
const FOLLOWED: usize = 4;
/// How many violated terms of a thing say how it should lean.
const TERMS: usize = 6;
/// Changes at random are as large as this (degrees), and then rounded to whole grades of this.
const FAR: [f64; 3] = [5.0, 30.0, 180.0];
const GRADE: f64 = 5.0;

impl LocalSearch<'_> {
    /// Where a check speaks of a thing that may lean otherwise, that may be tried in place of a move. Whether it was.
    pub(super) fn takes_lean(&mut self, check: usize, chance: &mut ChaCha8Rng) -> bool {
        let is_free = |o: &ObjectId| self.trial.may_lean(o.0 as usize);
        let free: Vec<usize> = match self.trial.numbering.check(check) {
            Check::Term(t) => {
                self.trial.frame.terms[t].objects.iter().filter(|o| is_free(o)).map(|o| o.0 as usize).collect()
            }
            Check::Collide(a, b) => [a, b].iter().filter(|o| is_free(o)).map(|o| o.0 as usize).collect(),
            Check::Bounds(a) | Check::Support(a) => [a].iter().filter(|o| is_free(o)).map(|o| o.0 as usize).collect(),
        };
        if free.is_empty() || chance.below(2) == 0 {
            return false;
        }
        self.step_lean(free[chance.below(free.len())], chance);
        true
    }

    /// A thing leans in the best of many ways, if that is better than the one it has.
    fn step_lean(&mut self, i: usize, chance: &mut ChaCha8Rng) {
        let all = self.ways_to_lean(i, chance);
        self.step_among(&all, chance, |local, angles| local.trial.go_lean(i, angles));
    }

    /// Angles to try: what its terms name, where the violated ones would hold, quarter turns, changes at random.
    fn ways_to_lean(&mut self, i: usize, chance: &mut ChaCha8Rng) -> Vec<[f64; 2]> {
        let now = self.trial.angles(i);
        let mut out = vec![[0.0; 2]];
        let mut terms: Vec<usize> =
            self.trial.terms_of[i].iter().copied().filter(|&t| self.trial.cost[t] > 0.0).collect();
        while terms.len() > TERMS {
            terms.swap_remove(chance.below(terms.len()));
        }
        for axis in 0..2 {
            let with = |angle: f64| {
                let mut next = now;
                next[axis] = angle;
                next
            };
            out.extend([90.0, -90.0, 180.0].map(with));
            for far in FAR {
                let angle = now[axis] + chance.between(-far, far);
                out.extend([with(angle), with((angle / GRADE).round() * GRADE)]);
            }
            for &t in &terms {
                for node in &self.trial.frame.terms[t].formula.nodes {
                    if let Node::Number(angle) = node {
                        out.extend([with(*angle), with(-angle)]);
                    }
                }
                self.where_it_leans(i, axis, t, &mut out);
            }
        }
        out.retain(|angles| *angles != now && angles.iter().all(|angle| angle.is_finite()));
        out.iter_mut().flatten().for_each(|angle| *angle = crate::problem::pose::half_turn(*angle));
        out
    }

    /// Along the slope to where a term would hold, and a little beyond.
    fn where_it_leans(&mut self, i: usize, axis: usize, t: usize, out: &mut Vec<[f64; 2]>) {
        let mut next = self.trial.angles(i);
        for _ in 0..FOLLOWED {
            let missing = self.lacks_leaning(t, i, next);
            if missing == 0.0 {
                break;
            }
            let mut probe = next;
            probe[axis] += PROBE;
            let slope = (self.lacks_leaning(t, i, probe) - missing) / PROBE;
            let step = -(missing + EASE) / slope;
            if !step.is_finite() || step.abs() > 180.0 {
                break;
            }
            next[axis] += step;
            out.push(next);
        }
    }

    fn lacks_leaning(&mut self, t: usize, i: usize, angles: [f64; 2]) -> f64 {
        self.trial.go_lean(i, angles);
        let lacks = self.trial.lacks(t);
        self.trial.work += 4;
        self.trial.undo();
        lacks
    }
}
