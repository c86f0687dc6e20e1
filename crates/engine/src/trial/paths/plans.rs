//! Plans of corridors: made, forgotten, doubted, confirmed by the evaluator.

use super::corridors::step;
use super::{PathGroup, Trial};
use crate::frame::checks::Check;
use crate::trial::Judge;

/// Where paths were planned, and what each group of them cost.
pub struct Plans {
    groups: Vec<PathGroup>,
    found: Vec<(f64, bool)>,
}

impl Plans {
    /// What all of them cost.
    pub fn cost(&self) -> f64 {
        self.found.iter().map(|(cost, _)| cost).sum()
    }
}

impl Trial<'_> {
    /// No way is planned.
    pub fn forget_paths(&mut self) {
        for group in &mut self.groups {
            (group.branches, group.off) = (None, 0.0);
            group.lacks.clear();
        }
    }

    /// Plans the paths that have no plan, until it is late.
    pub fn plan_missing(&mut self, late: &dyn Fn() -> bool) {
        let all = (0..self.groups.len()).take_while(|_| !late());
        all.for_each(|group| {
            if !self.groups[group].is_planned() && self.looks_at(group) {
                self.plan_again(group);
            }
        });
    }

    /// Judges all paths that have a plan by where everything is now.
    pub fn judge_paths(&mut self) {
        for at in 0..self.walks.len() {
            let (t, group) = self.walks[at];
            if self.groups[group].is_planned() {
                let (cost, holds) = self.judge_group(group);
                self.set(t, cost, holds);
            }
        }
    }

    /// Plans a way anew.
    pub fn plan_again(&mut self, index: usize) {
        let branches = self.corridors(index);
        let doors = self.door_places();
        let group = &mut self.groups[index];
        group.steps = branches.iter().flat_map(|b| b.bends.windows(2)).map(|pair| step(pair[0], pair[1])).collect();
        (group.branches, group.doors, group.stale) = (Some(branches), doors, false);
        group.bounds = group.surround();
        let (term, _) = self.walks[index];
        let (cost, holds) = self.judge_group(index);
        self.set(term, cost, holds);
    }

    /// Asks the evaluator whether there are the paths that are thought barred: a plan is only a plan. Whether there are.
    pub fn confirm_paths(&mut self) -> bool {
        self.begin_to_follow();
        self.follow();
        for check in self.bad.clone() {
            let Some(Judge::PathGroup(group)) = self.judges.get(check) else { return false };
            let group = *group;
            for t in 0..self.judges.len() {
                if matches!(self.judges[t], Judge::PathGroup(w) | Judge::Shared(w) if w == group)
                    && !self.evaluate_path(t)
                {
                    return false;
                }
            }
            self.set(check, 0.0, true);
        }
        true
    }

    /// What was thought to hold does not: paths are planned wider from now on, and terms are asked of the evaluator.
    /// Whether that is all that fails.
    pub fn doubt(&mut self, failing: &[usize]) -> bool {
        const MORE: f64 = 0.01;
        const MOST: f64 = 0.05;
        for &check in failing {
            match self.judges.get(check) {
                Some(Judge::PathGroup(group) | Judge::Shared(group)) => {
                    let group = &mut self.groups[*group];
                    group.doubt = (group.doubt + MORE).min(MOST);
                    group.branches = None;
                }
                Some(Judge::Code(_) | Judge::Inside(..) | Judge::Clear(_) | Judge::Turn) => self.ask_evaluator(check),
                Some(Judge::Mixed(mixed)) if mixed.is_rough() => self.ask_evaluator(check),
                Some(_) => return false,
                None => {
                    let objects = match self.numbering.check(check) {
                        Check::Collide(a, b) => vec![a, b],
                        Check::Bounds(a) | Check::Support(a) => vec![a],
                        Check::Term(_) => return false,
                    };
                    if objects.iter().all(|id| self.asked[id.0 as usize]) {
                        return false;
                    }
                    objects.into_iter().for_each(|id| self.asked[id.0 as usize] = true);
                    self.begin_to_follow();
                }
            }
        }
        true
    }

    /// By how much a trial costs more, paths left aside; `None`: more than `limit`.
    pub fn judge_all_but_paths(&mut self, limit: f64) -> Option<f64> {
        let walks = std::mem::take(&mut self.walks);
        let judged = self.judge(limit);
        self.walks = walks;
        judged
    }

    /// Where paths are planned, and what that costs.
    pub fn plans(&self) -> Plans {
        let found = self.walks.iter().map(|(t, _)| (self.cost[*t], self.holds[*t])).collect();
        Plans { groups: self.groups.clone(), found }
    }

    /// Plans those paths anew that are barred where everything is now.
    pub fn plan_barred(&mut self) {
        self.judge_paths();
        for at in 0..self.walks.len() {
            let (t, group) = self.walks[at];
            if self.cost[t] > 0.0 && self.looks_at(group) {
                self.plan_again(group);
            }
        }
    }

    /// Plans are as they were, when everything was where it is again.
    pub fn put_plans(&mut self, plans: Plans) {
        self.groups = plans.groups;
        for (at, (cost, holds)) in plans.found.into_iter().enumerate() {
            self.set(self.walks[at].0, cost, holds);
        }
    }
}
