//! `reachable` on boxes: for the paths that are asked for corridors are planned through what can be moved, and what then
//! stands in them costs. So a search learns what to move out of the way; whether there is a path is asked of the
//! evaluator in the end.
//!
//! Paths of one width that begin at the same thing are planned and judged together: they share most of their corridors.

use super::corridors::{NEAR, step};
use super::judge::Moved;
use super::moves::Inputs;
use super::{Judge, LocalSearch, Span};
use crate::search::chance::Chance;
use rand_chacha::ChaCha8Rng;
use scenelang_engine::frame::checks::Check;
use scenelang_engine::penalty;
use scenelang_lang::program::{Comparison, Formula, Node, NodeId};
use scenelang_verify::coded::Flat;
use scenelang_verify::{Surroundings, World, surroundings};

/// What reaches no higher above the floor is stepped over, what begins higher is walked under (metres).
const IN_THE_WAY: [f64; 2] = [0.05, 2.0];
/// A little more than what is missing (metres).
const EASE: f64 = 1e-3;

/// What a term asks for: a way of a width between two things, or from one of them to any of several.
#[derive(Clone, Debug)]
pub(super) struct Asked {
    pub term: usize,
    ends: [usize; 2],
    goals: Vec<usize>,
    width: f64,
    /// The preference that it is a part of; `None`: it must be there.
    preference: Option<usize>,
}

impl Asked {
    /// What a formula says, if it asks for a path of constant width, or for one of several that share an end.
    pub fn of(term: usize, formula: &Formula, preference: Option<usize>) -> Option<Self> {
        let one = |node: NodeId| {
            let node = match formula.node(node) {
                // How far one walks is asked of the evaluator in the end; there has to be a path at all.
                Node::Compare(Comparison::Le | Comparison::Lt, _, distance, most)
                    if matches!(formula.node(*most), Node::Number(_)) =>
                {
                    formula.node(*distance)
                }
                node => node,
            };
            let Surroundings::Path { from, to, width: Some(width) } = surroundings(formula, node) else { return None };
            Some(([from.0 as usize, to.0 as usize], width))
        };
        let all: Vec<([usize; 2], f64)> = match formula.root_node() {
            Node::Or(parts) => parts.iter().map(|&part| one(part)).collect::<Option<_>>()?,
            _ => vec![one(formula.root)?],
        };
        let &(ends, width) = all.first()?;
        let shared = |end: &usize| all.iter().all(|(ends, w)| ends.contains(end) && *w == width);
        let from = ends.into_iter().find(shared)?;
        let goals: Vec<usize> = all.iter().map(|(ends, _)| if ends[0] == from { ends[1] } else { ends[0] }).collect();
        Some(Self { term, ends: [from, goals[0]], goals, width, preference })
    }

    /// Paths by where they begin: things at which many do come first.
    pub fn together(all: &[Self], world: &World<f64>) -> Vec<(PathGroup, Vec<usize>)> {
        let mut found: Vec<(PathGroup, Vec<usize>)> = Vec::new();
        let asks = |end: usize, width: f64, preference: Option<usize>| {
            all.iter()
                .filter(|a| {
                    a.width == width
                        && a.preference == preference
                        && (a.ends[0] == end || a.goals == [a.ends[1]] && a.ends[1] == end)
                })
                .count()
        };
        for asked in all {
            let [a, b] = asked.ends;
            let turned = asked.goals.len() == 1
                && asks(b, asked.width, asked.preference) > asks(a, asked.width, asked.preference);
            let (from, goals) = if turned { (b, vec![a]) } else { (a, asked.goals.clone()) };
            let radius = ((asked.width - world.options.tolerances.contact) / 2.0).max(0.0);
            let alike = |group: &PathGroup| {
                group.from == from && group.radius == radius && group.preference == asked.preference
            };
            match found.iter_mut().find(|(group, _)| alike(group)) {
                Some((group, terms)) => {
                    group.targets.push(goals);
                    terms.push(asked.term);
                }
                None => found.push((PathGroup::new(from, goals, radius, asked.preference), vec![asked.term])),
            }
        }
        found
    }
}

/// A corridor from where paths begin, or from another corridor of theirs, to a goal.
#[derive(Clone, Debug)]
pub(super) struct Branch {
    pub goal: usize,
    /// Whether it begins where the paths do.
    pub is_rooted: bool,
    /// Empty: there is none.
    pub bends: Vec<[f64; 2]>,
}

/// Paths of one width that begin at the same thing.
#[derive(Clone, Debug)]
pub(super) struct PathGroup {
    pub from: usize,
    /// What is to be reached: for each, things of which one will do.
    pub targets: Vec<Vec<usize>>,
    pub radius: f64,
    /// The preference that asks for them; `None`: they must be there.
    preference: Option<usize>,
    /// By target; `None`: nothing is planned yet.
    branches: Option<Vec<Branch>>,
    /// Where doors were when it was planned, and whether some are elsewhere now.
    doors: Vec<[f64; 3]>,
    stale: bool,
    /// The steps of all corridors, as rectangles without width.
    steps: Vec<Flat>,
    /// What stands in the corridors, and what that costs.
    lacks: Vec<(usize, f64)>,
    /// What it costs that ends are not where corridors begin, and that some targets have none.
    off: f64,
    /// What surrounds the corridors.
    bounds: Span,
    /// How much wider than asked for it is planned, since what was planned proved too narrow (metres).
    doubt: f64,
}

impl PathGroup {
    fn new(from: usize, goals: Vec<usize>, radius: f64, preference: Option<usize>) -> Self {
        Self {
            from,
            targets: vec![goals],
            radius,
            preference,
            branches: None,
            doors: Vec::new(),
            stale: false,
            steps: Vec::new(),
            lacks: Vec::new(),
            off: 0.0,
            bounds: Span::default(),
            doubt: 0.0,
        }
    }
    /// Half the width that is planned for.
    pub fn width(&self) -> f64 {
        self.radius + self.doubt
    }
    fn is_planned(&self) -> bool {
        self.branches.is_some()
    }
    fn branches(&self) -> &[Branch] {
        self.branches.as_deref().unwrap_or_default()
    }
    /// Its ends, each with where the corridor begins there.
    fn stands(&self) -> impl Iterator<Item = (usize, [f64; 2])> + '_ {
        let begins =
            self.branches().iter().filter(|b| b.is_rooted).filter_map(|b| Some((self.from, *b.bends.first()?)));
        begins.chain(self.branches().iter().filter_map(|b| Some((b.goal, *b.bends.last()?))))
    }
    fn has_end(&self, i: usize) -> bool {
        self.from == i || self.branches().iter().any(|b| b.goal == i)
    }
    /// Targets without a corridor.
    fn unreached(&self) -> impl Iterator<Item = &Vec<usize>> {
        self.targets.iter().zip(self.branches()).filter(|(_, b)| b.bends.is_empty()).map(|(goals, _)| goals)
    }
    /// What surrounds the corridors, at any height.
    fn surround(&self) -> Span {
        let r = self.width();
        let bends = || self.branches().iter().flat_map(|b| &b.bends);
        let least = |k: usize| bends().map(|p| p[k]).fold(f64::INFINITY, f64::min) - r;
        let most = |k: usize| bends().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max) + r;
        Span { min: [least(0), f64::NEG_INFINITY, least(1)], max: [most(0), f64::INFINITY, most(1)] }
    }
}

impl LocalSearch<'_> {
    /// Whether paths are looked at: they must be there, or preferences count.
    pub(super) fn looks_at(&self, group: usize) -> bool {
        self.preferring || self.groups[group].preference.is_none()
    }

    /// How many groups of paths are looked at.
    pub(super) fn path_count(&self) -> usize {
        (0..self.groups.len()).filter(|&group| self.looks_at(group)).count()
    }

    pub(super) fn is_in_the_way(&self, j: usize) -> bool {
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

    /// Something that a way would be better without, or one of its ends where those are off it.
    pub(super) fn hindrance(&self, index: usize, chance: &mut ChaCha8Rng) -> Option<usize> {
        let group = &self.groups[index];
        let mut found: Vec<usize> = group.lacks.iter().map(|(j, _)| *j).collect();
        found.extend(group.stands().filter(|(j, p)| self.flat(*j).distance(*p) > group.radius + NEAR).map(|(j, _)| j));
        if group.unreached().next().is_some() {
            found.push(group.from);
            found.extend(group.unreached().flatten());
        }
        found.retain(|j| self.is_movable(*j));
        (!found.is_empty()).then(|| found[chance.below(found.len())])
    }

    /// Whether paths have no plan, or doors have moved since.
    pub(super) fn is_stale(&self, index: usize) -> bool {
        !self.groups[index].is_planned() || self.groups[index].stale
    }

    /// Out of the corridors that an object stands in, and back to those that begin at it; into `out`.
    pub(super) fn out_of_the_way(&self, i: usize, out: &mut Vec<Inputs>) {
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

    /// No way is planned.
    pub(super) fn forget_paths(&mut self) {
        for group in &mut self.groups {
            (group.branches, group.off) = (None, 0.0);
            group.lacks.clear();
        }
    }

    /// Plans the paths that have no plan, until it is late.
    pub(super) fn plan_missing(&mut self, late: &dyn Fn() -> bool) {
        let all = (0..self.groups.len()).take_while(|_| !late());
        all.for_each(|group| {
            if !self.groups[group].is_planned() && self.looks_at(group) {
                self.plan_again(group);
            }
        });
    }

    /// Judges all paths that have a plan by where everything is now.
    pub(super) fn judge_paths(&mut self) {
        for at in 0..self.walks.len() {
            let (t, group) = self.walks[at];
            if self.groups[group].is_planned() {
                let (cost, holds) = self.judge_group(group);
                self.set(t, cost, holds);
            }
        }
    }

    /// Plans a way anew.
    pub(super) fn plan_again(&mut self, index: usize) {
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
    pub(super) fn confirm_paths(&mut self) -> bool {
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
}
