//! The smallest move that mends a row: of one object, with what it carries, or of one after the other.
//!
//! What is offered has been judged: after it the row holds. Of several moves the one is offered that breaks least, and
//! of these the smallest.

use super::RowRef;
use super::search::{Freedom, Search};
use super::stage::{Consequences, Goal, Stage, row_of};
use scenelang_lang::program::ObjectId;

/// What looking for a move may cost, in small comparisons.
const BUDGET: usize = 120_000;
/// So many objects of a row are tried.
const OBJECTS: usize = 4;
/// So many moves of one object are judged by all that they touch.
const JUDGED: usize = 8;
/// So many steps a move has at most, what goes along not counted.
const STEPS: usize = 4;
/// So many rows are named that pull the other way.
const OPPOSING: usize = 3;

/// A move that mends a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Mend {
    /// What is moved, in this order; usually one object.
    pub steps: Vec<Step>,
    /// What holds in the layout and fails after the move.
    pub breaks: Vec<RowRef>,
    /// What fails in the layout and holds after the move, beside the row itself.
    pub mends: Vec<RowRef>,
}

/// A move of one object from where the layout has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Which.
    pub object: ObjectId,
    /// Along x, y, z (metres).
    pub by: [f64; 3],
    /// Added to its `rot.y` (degrees).
    pub turn: f64,
    /// The object that it goes along with, because it rests on it.
    pub with: Option<ObjectId>,
}

/// What was found for a row.
#[derive(Debug, Default)]
pub(super) struct Found {
    pub mend: Option<Mend>,
    pub opposing: Vec<RowRef>,
    pub pinned: Vec<RowRef>,
    /// Whether there was something to be moved.
    pub searched: bool,
}

/// A move with what it does.
#[derive(Clone, Debug)]
struct Judged {
    cost: f64,
    steps: Vec<Step>,
    does: Consequences,
}

impl Judged {
    /// Less harm first, then the smaller one.
    fn better_than(&self, other: &Self) -> bool {
        let key = |j: &Self| (j.does.harm(), j.cost);
        key(self).0 < key(other).0 || key(self).0 == key(other).0 && self.cost < other.cost
    }
}

/// The smallest move after which a row holds.
pub(super) fn mend(stage: &mut Stage<'_>, row: RowRef, objects: &[ObjectId]) -> Found {
    stage.set(&[]);
    let mut found = Found::default();
    let mut all = stage.deciding(Goal::Row(row));
    all.extend(objects);
    let mut pins: Vec<usize> = Vec::new();
    for &id in &all {
        match stage.pins(id, row) {
            [Some(a), Some(b)] => pins.extend([a, b]),
            _ => found.searched = true,
        }
    }
    if !found.searched {
        pins.sort_unstable();
        pins.dedup();
        found.pinned = pins.into_iter().map(|i| row_of(stage.program, i)).collect();
        return found;
    }
    let mut mender = Mender { limit: stage.work + BUDGET, stage, row, smallest: None };
    let best = mender.whole();
    let smallest = mender.smallest.take();
    mender.stage.set(&[]);
    if let Some(smallest) = smallest {
        found.opposing = opposing(&smallest.does, row, smallest.cost);
    }
    found.mend = best.map(|best| {
        let mends = best.does.mends.into_iter().filter(|r| *r != row).collect();
        Mend { steps: best.steps, breaks: best.does.breaks, mends }
    });
    found
}

/// What pulls the other way: what the smallest move would break or, if nothing, what comes nearest to it.
fn opposing(does: &Consequences, row: RowRef, moved: f64) -> Vec<RowRef> {
    let mut broken: Vec<RowRef> = does.breaks.iter().copied().filter(|r| *r != row).take(OPPOSING).collect();
    if broken.is_empty() {
        // It must fall by a good part of the move, or it hardly pulls.
        let pulls = |(r, by): &&(RowRef, f64)| *r != row && r.kind.rule().is_none() && *by >= 0.5 * moved;
        broken.extend(does.falls.iter().filter(pulls).map(|(r, _)| *r).take(1));
    }
    broken
}

struct Mender<'s, 'a> {
    stage: &'s mut Stage<'a>,
    row: RowRef,
    limit: usize,
    /// The smallest move seen that mends the row, whatever it breaks.
    smallest: Option<Judged>,
}

impl Mender<'_, '_> {
    /// The best move, of one object or of several.
    fn whole(&mut self) -> Option<Judged> {
        let goal = Goal::Row(self.row);
        let mut best = self.one(goal, &[]).or_else(|| self.parts(goal, Vec::new()))?;
        if self.smallest.is_none() {
            self.smallest = Some(best.clone());
        }
        // What is broken may be mended in turn, by moving something else.
        for _ in 1..STEPS {
            let Some(&broken) = best.does.breaks.first() else { break };
            let steps = best.steps.clone();
            self.stage.set(&steps);
            let next = self.one(Goal::Row(broken), &steps);
            let keeps = |next: &Judged| next.does.mends.contains(&self.row) && next.does.harm() < best.does.harm();
            match next.filter(keeps) {
                Some(next) => best = next,
                None => break,
            }
        }
        Some(best)
    }

    /// Mends the parts of a conjunction one after the other.
    fn parts(&mut self, goal: Goal, mut steps: Vec<Step>) -> Option<Judged> {
        let mut last = None;
        while steps.len() < STEPS && !self.stage.has_spent(self.limit) {
            self.stage.set(&steps);
            let Some(&part) = self.stage.failing_parts(goal).first() else { break };
            let judged = self.one(part, &steps).or_else(|| self.parts(part, steps.clone()))?;
            steps.clone_from(&judged.steps);
            last = Some(judged);
        }
        self.stage.set(&steps);
        let holds = self.stage.truth(goal).is_some_and(|t| t.holds);
        last.filter(|_| holds)
    }

    /// The best move of one object that makes a goal hold, after some steps.
    fn one(&mut self, goal: Goal, steps: &[Step]) -> Option<Judged> {
        let mut objects = self.stage.deciding(goal);
        objects.dedup();
        let mut candidates: Vec<(f64, Step)> = Vec::new();
        for &object in objects.iter().take(OBJECTS) {
            let [pos, turn] = self.stage.pins(object, self.row);
            let freedom = Freedom { pos: pos.is_none(), turn: turn.is_none() };
            let earlier = steps.iter().find(|s| s.object == object).copied();
            let from = earlier.unwrap_or(Step { object, by: [0.0; 3], turn: 0.0, with: None });
            // Each object has its share, so that a dear row does not spend all on the first one.
            let share = self.limit.saturating_sub(self.stage.work) / (OBJECTS + 1);
            let limit = self.stage.work + share.max(1);
            self.stage.set(steps);
            if let Some(search) = Search::new(self.stage, goal, from, limit) {
                candidates.extend(search.run(freedom));
            }
        }
        candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut best: Option<Judged> = None;
        for (i, (cost, step)) in candidates.into_iter().take(JUDGED).enumerate() {
            if i > 0 && self.stage.has_spent(self.limit) {
                break;
            }
            let most = best.as_ref().map(|b| b.does.harm());
            for judged in self.judged(steps, cost, step, goal, most) {
                if best.as_ref().is_none_or(|b| judged.better_than(b)) {
                    best = Some(judged);
                }
            }
            if best.as_ref().is_some_and(|b| b.does.harm() == (0, 0)) {
                break;
            }
        }
        best
    }

    /// A step by itself and, if that leaves something without support, with what it carries.
    fn judged(
        &mut self,
        steps: &[Step],
        cost: f64,
        step: Step,
        goal: Goal,
        most: Option<(usize, usize)>,
    ) -> Vec<Judged> {
        let mut all: Vec<Step> = steps.iter().filter(|s| s.object != step.object).copied().collect();
        all.push(step);
        let carried = self.stage.carried_by(step.object);
        // With something on it, the harm of moving it alone says little.
        let first = most.filter(|_| carried.is_empty());
        let mut out: Vec<Judged> = self.consequences(all.clone(), cost, goal, first).into_iter().collect();
        if !carried.is_empty() {
            let along = carried.into_iter().filter(|id| self.stage.pins(*id, self.row)[0].is_none());
            let along: Vec<Step> = along.filter_map(|id| self.along(&step, id)).collect();
            if !along.is_empty() {
                all.retain(|s| along.iter().all(|a| a.object != s.object));
                all.extend(along);
                out.extend(self.consequences(all, cost, goal, most));
            }
        }
        if steps.is_empty() && goal == Goal::Row(self.row) {
            for judged in &out {
                if self.smallest.as_ref().is_none_or(|s| judged.cost < s.cost) {
                    self.smallest = Some(judged.clone());
                }
            }
        }
        out
    }

    /// The step of an object that goes along with another.
    fn along(&self, leader: &Step, object: ObjectId) -> Option<Step> {
        let place = |id: ObjectId| self.stage.layout().object(id).ok().map(|thing| thing.pos.0);
        let (pivot, pos) = (place(leader.object)?, place(object)?);
        let (sin, cos) = scenelang_layout::rotation::sin_cos(leader.turn);
        let (x, z) = (pos[0] - pivot[0], pos[2] - pivot[2]);
        let [bx, by, bz] = leader.by;
        let by = [bx + cos * x + sin * z - x, by, bz + cos * z - sin * x - z];
        Some(Step { object, by, turn: leader.turn, with: Some(leader.object) })
    }

    /// What steps do, if the goal holds after them and the harm is no more than `most`.
    fn consequences(
        &mut self,
        steps: Vec<Step>,
        cost: f64,
        goal: Goal,
        most: Option<(usize, usize)>,
    ) -> Option<Judged> {
        self.stage.set(&steps);
        if !self.stage.truth(goal)?.holds {
            return None;
        }
        let moved: Vec<ObjectId> = steps.iter().map(|s| s.object).collect();
        let does = self.stage.consequences(&moved, most)?;
        Some(Judged { cost, steps, does })
    }
}
