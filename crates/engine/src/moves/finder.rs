//! The smallest move that repairs rows: of one object, with what it carries, or of one after the other. Whoever offers a
//! move asks here, so that all offer the same one.
//!
//! What is offered has been judged: after it the rows hold. Of several moves the one is offered that breaks least; of
//! these the one that leaves doors and windows where they are; of these the one that repairs most, since what displaced
//! an object broke all that speaks of it; of these a turn, where the rows are about directions, and else the smallest,
//! where what is awkward counts as a longer way.
//! Nothing comes to rest on what it did not rest on, unless that is asked for.
//!
//! What a move would break becomes a goal in its turn, and the search begins again. So what one object can repair without
//! harm is found first; others are moved only where that is not enough.

use super::DEAR;
use super::choice::{self, Judged, keep};
use super::search::{Freedom, MoveSearch};
use super::stage::Stage;
use crate::rows::{Goal, row_of};
use scenelang_lang::program::{ObjectId, Program};
use scenelang_verify::World;
use scenelang_verify::explain::{ObjectMove, RowRef, SmallestMove};
use scenelang_verify::report::model::RowKind;

/// What looking for a move may cost, in small comparisons.
const BUDGET: usize = 120_000;
/// What looking for one that repairs all that fails may cost: it is looked for once.
const TOGETHER: usize = 2 * BUDGET;
/// So many objects of a row are tried.
const OBJECTS: usize = 4;
/// So many moves of one object are judged by all that they touch.
const JUDGED: usize = 8;
/// So many steps a move has at most, what goes along not counted.
const STEPS: usize = 4;
/// So often what a move would break becomes a goal.
const ROUNDS: usize = 5;
/// What goes farther than this is carried, and may as well be put where such things stand (metres).
pub(super) const FAR: f64 = 1.0;
/// Of so many ways to satisfy goals no more are looked for.
const WAYS: usize = 4;
/// What it counts that an object goes along: a part of what the move counts, and metres for taking hold of it.
const ALONG: (f64, f64) = (0.5, 0.5);
/// So many rows are named that pull the other way.
const OPPOSING: usize = 3;

/// What was found for a row.
#[derive(Debug, Default)]
pub(crate) struct FoundMove {
    /// Moves that repair it, the best first; only the first one may break something.
    pub choices: Vec<SmallestMove>,
    pub opposing: Vec<RowRef>,
    pub pinned: Vec<RowRef>,
    /// Whether there was something to be moved.
    pub searched: bool,
}

/// Looks for moves in one layout.
pub(crate) struct MoveFinder<'a> {
    pub(super) stage: Stage<'a>,
    /// What must hold and does not.
    failing: Vec<RowRef>,
    /// What one object can do about all of that, and what else does no harm; `None`: nobody has asked yet.
    whole: Option<(Option<Judged>, Vec<Judged>)>,
    /// The work up to which something may be looked for.
    pub(super) limit: usize,
    /// Moves of one object that repair what is asked for and do no harm.
    harmless: Vec<Judged>,
    /// Moves of the object that is looked at, from where it is, that break something: of each company the smallest.
    pub(super) leaving: Vec<Judged>,
    /// Objects that stay where they are.
    pub(super) locked: Vec<ObjectId>,
}

impl<'a> MoveFinder<'a> {
    /// Whoever tries out what is dear has so much to spend.
    pub fn new(program: &'a Program, world: World<f64>, failing: Vec<RowRef>, purse: usize) -> Self {
        let stage = Stage::new(program, world, purse);
        Self { stage, failing, whole: None, limit: 0, harmless: Vec::new(), leaving: Vec::new(), locked: Vec::new() }
    }

    /// The same, but these objects stay where they are.
    pub fn locking(self, locked: &[ObjectId]) -> Self {
        Self { locked: locked.to_vec(), ..self }
    }

    /// The layout, with everything where it was given.
    pub fn layout(&mut self) -> &World<f64> {
        self.stage.set(&[]);
        self.stage.world()
    }

    /// Whether nothing is left for dear rows.
    pub fn is_spent(&self) -> bool {
        self.stage.has_spent(usize::MAX)
    }

    /// What there is to say of a row that fails.
    pub fn explain(&mut self, row: RowRef, objects: &[ObjectId]) -> FoundMove {
        let mut found = FoundMove::default();
        self.stage.set(&[]);
        let mut all = self.stage.deciding(Goal::Row(row));
        all.extend(objects);
        let mut pins: Vec<usize> = Vec::new();
        for &id in &all {
            match self.stage.pins(id, &[row]) {
                [Some(a), Some(b)] => pins.extend([a, b]),
                _ => found.searched = true,
            }
        }
        found.choices = self.choices(&[row]);
        if self.is_spent() {
            found.choices.clear();
        }
        if found.searched {
            found.opposing = self.opposing(row);
        } else if found.choices.is_empty() {
            pins.sort_unstable();
            pins.dedup();
            found.pinned = pins.into_iter().map(|i| row_of(self.stage.program, i)).collect();
        }
        self.stage.set(&[]);
        found
    }

    /// Moves after which rows hold, the best first; where that breaks something, there is no other.
    pub fn choices(&mut self, rows: &[RowRef]) -> Vec<SmallestMove> {
        self.harmless.clear();
        let best = match self.together(rows) {
            Some(best) => Some(best),
            None => self.in_turn(rows),
        };
        let Some(best) = best else { return Vec::new() };
        let others = std::mem::take(&mut self.harmless);
        let others = others.into_iter().filter(|other| rows.iter().all(|row| other.does.repairs.contains(row)));
        let offered = |j: Judged| SmallestMove {
            steps: j.steps,
            breaks: j.does.breaks,
            repairs: j.does.repairs.into_iter().filter(|r| rows != [*r]).collect(),
        };
        choice::choose(best, others.collect()).into_iter().map(offered).collect()
    }

    /// What conflicts with it: what the smallest move would break or, if nothing, what comes nearest to it.
    fn opposing(&mut self, row: RowRef) -> Vec<RowRef> {
        self.limit = self.stage.work + BUDGET;
        let mut smallest: Option<Judged> = None;
        for object in self.blamed(&[row]) {
            let limit = self.share();
            let (steps, rows) = (&[], [row]);
            let try_out =
                Attempt { object, goals: vec![Goal::Row(row)], rows: &rows, steps, free: &rows, limit, company: 0 };
            for judged in self.nearest(&try_out) {
                if smallest.as_ref().is_none_or(|s| judged.cost < s.cost) {
                    smallest = Some(judged);
                }
            }
        }
        let Some(smallest) = smallest else { return Vec::new() };
        let does = smallest.does;
        let mut broken: Vec<RowRef> = does.breaks.iter().copied().filter(|r| *r != row).take(OPPOSING).collect();
        if broken.is_empty() {
            // It must fall by a good part of the move, or it hardly pulls.
            let pulls = |(r, by): &&(RowRef, f64)| *r != row && r.kind.rule().is_none() && *by >= 0.5 * smallest.cost;
            broken.extend(does.falls.iter().filter(pulls).map(|(r, _)| *r).take(1));
        }
        broken
    }

    /// A move of one object that repairs all that fails, if that is what rows need.
    fn together(&mut self, rows: &[RowRef]) -> Option<Judged> {
        if self.failing.len() < 2 || rows.iter().any(|row| !self.failing.contains(row)) {
            return None;
        }
        if self.whole.is_none() {
            let failing = self.failing.clone();
            self.limit = self.stage.work + TOGETHER;
            let goals: Vec<Goal> = failing.iter().map(|row| Goal::Row(*row)).collect();
            let mut best = None;
            for object in self.blamed(&failing) {
                let limit = self.share();
                let (goals, rows, free) = (goals.clone(), failing.as_slice(), failing.as_slice());
                let found = self.object(&Attempt { object, goals, rows, steps: &[], free, limit, company: 0 });
                keep(&mut best, found.filter(|j| j.harm() == (0, 0)));
            }
            self.whole = Some((best, std::mem::take(&mut self.harmless)));
        }
        let (best, harmless) = self.whole.clone()?;
        self.harmless = harmless;
        best
    }

    /// A move of objects one after the other, until all rows hold and nothing is broken, or as near to that as it gets.
    fn in_turn(&mut self, rows: &[RowRef]) -> Option<Judged> {
        self.limit = self.stage.work + BUDGET;
        let mut at: Option<Judged> = None;
        for _ in 0..STEPS {
            let does = at.as_ref().map(|a| &a.does);
            let (done, left): (Vec<RowRef>, Vec<RowRef>) =
                rows.iter().partition(|row| does.is_some_and(|d| d.repairs.contains(row)));
            let next = left.iter().copied().chain(does.into_iter().flat_map(|d| d.breaks.iter().copied())).next();
            let Some(next) = next else { break };
            let steps = at.as_ref().map_or(Vec::new(), |a| a.steps.clone());
            let mut found = self.one(next, &done, &steps);
            if found.is_none() && at.is_none() {
                found = self.parts(Goal::Row(next), next, Vec::new());
            }
            let Some(mut found) = found else { break };
            found.open = rows.iter().filter(|row| !found.does.repairs.contains(row)).count();
            let was = at.as_ref().map_or((usize::MAX, 0), Judged::harm);
            if found.harm() >= was {
                break;
            }
            at = Some(found);
        }
        at.filter(|found| found.open == 0)
    }

    /// Repairs the parts of a conjunction one after the other.
    fn parts(&mut self, goal: Goal, row: RowRef, mut steps: Vec<ObjectMove>) -> Option<Judged> {
        let mut last = None;
        while steps.len() < STEPS && !self.stage.has_spent(self.limit) {
            self.stage.set(&steps);
            let Some(&part) = self.stage.failing_parts(goal).first() else { break };
            let mut best = None;
            for object in self.deciding(&[part]) {
                let limit = self.share();
                let free = [row];
                let goals = vec![part];
                let found =
                    self.object(&Attempt { object, goals, rows: &[], steps: &steps, free: &free, limit, company: 0 });
                keep(&mut best, found);
            }
            let judged = best.or_else(|| self.parts(part, row, steps.clone()))?;
            steps.clone_from(&judged.steps);
            last = Some(judged);
        }
        self.stage.set(&steps);
        let holds = self.stage.truth(goal).is_some_and(|t| t.holds);
        last.filter(|_| holds)
    }

    /// The best move of one object that repairs a row, after some steps, and keeps what these have repaired.
    fn one(&mut self, row: RowRef, done: &[RowRef], steps: &[ObjectMove]) -> Option<Judged> {
        self.stage.set(steps);
        let mut best: Option<Judged> = None;
        for object in self.deciding(&[Goal::Row(row)]) {
            // All that fails and speaks of it, if one move repairs that.
            let mut group = vec![row];
            if row.kind != RowKind::Prefer {
                let others = self.failing.iter().copied();
                group.extend(others.filter(|r| *r != row && !done.contains(r) && self.stage.is_about(r, object)));
            }
            let share = self.share();
            let groups = if group.len() > 1 { vec![group, vec![row]] } else { vec![group] };
            for (i, group) in groups.iter().enumerate() {
                let limit = if i + 1 < groups.len() { self.stage.work + (share - self.stage.work) / 2 } else { share };
                let rows: Vec<RowRef> = group.iter().chain(done).copied().collect();
                let goals = group.iter().map(|row| Goal::Row(*row)).collect();
                let found = self.object(&Attempt { object, goals, rows: &rows, steps, free: group, limit, company: 0 });
                let harmless = found.as_ref().is_some_and(|j| j.harm() == (0, 0));
                keep(&mut best, found.filter(|_| harmless || i + 1 == groups.len()));
                if harmless {
                    break;
                }
            }
        }
        best
    }

    /// The objects that decide goals as things are on the stage, those that decide most of them first.
    fn deciding(&mut self, goals: &[Goal]) -> Vec<ObjectId> {
        let mut found: Vec<(ObjectId, usize)> = Vec::new();
        for goal in goals {
            let own = self.stage.deciding(*goal);
            for id in own.iter().enumerate().filter(|(i, id)| !own[..*i].contains(id)).map(|(_, id)| *id) {
                match found.iter_mut().find(|(o, _)| *o == id) {
                    Some((_, times)) => *times += 1,
                    None => found.push((id, 1)),
                }
            }
        }
        let fitting = |id| self.stage.is_fitting(id);
        found.sort_by_key(|(id, times)| (fitting(*id), std::cmp::Reverse(*times)));
        found.into_iter().map(|(id, _)| id).filter(|id| !self.locked.contains(id)).take(OBJECTS).collect()
    }

    /// The same of rows, in the layout.
    fn blamed(&mut self, rows: &[RowRef]) -> Vec<ObjectId> {
        self.stage.set(&[]);
        let goals: Vec<Goal> = rows.iter().map(|row| Goal::Row(*row)).collect();
        self.deciding(&goals)
    }

    /// The work that one object may take: a dear row must not spend all on the first one.
    pub(super) fn share(&self) -> usize {
        let share = self.limit.saturating_sub(self.stage.work) / (OBJECTS + 1);
        self.stage.work + share.max(1)
    }

    /// The best move of an object with others that go along: from where it is first, then from places farther off.
    pub(super) fn with_company(&mut self, attempt: &Attempt<'_>, company: &[ObjectId]) -> Option<Judged> {
        let mut best = None;
        let mut attempt = Attempt { company: company.len(), ..attempt.clone() };
        let mut riders = self.riders(&attempt, attempt.object);
        for &id in company {
            let carried = self.riders(&attempt, id);
            riders.extend(std::iter::once(id).chain(carried).filter(|id| *id != attempt.object));
        }
        let mut known = rustc_hash::FxHashSet::default();
        riders.retain(|id| known.insert(*id));
        if !riders.is_empty() && company.is_empty() {
            // Alone it leaves something without support, most likely.
            for judged in self.judged(&attempt, &[], From::Here) {
                keep(&mut best, Some(judged));
            }
        }
        let mut first = true;
        let half = attempt.limit.saturating_sub(self.stage.work) / 2;
        let more = |limit: usize, stage: &Stage<'_>| limit.max(stage.work + half);
        for from in [From::Here, From::Afar] {
            let far = from == From::Afar;
            if far {
                // However dear it was to look around, something is left for places farther off.
                attempt.limit = more(attempt.limit, &self.stage);
            }
            for _ in 0..ROUNDS {
                if self.stage.has_spent(attempt.limit) {
                    break;
                }
                if best.as_ref().is_some_and(|b| b.harm() == (0, 0)) {
                    attempt.limit = more(attempt.limit, &self.stage);
                    return self.properly(best, &attempt, &riders);
                }
                let found = self.judged(&attempt, &riders, from);
                if std::mem::take(&mut first) {
                    let breaking = found.iter().filter(|judged| !judged.does.breaks.is_empty());
                    self.leaving.extend(breaking.min_by(|a, b| a.cost.total_cmp(&b.cost)).cloned());
                }
                let before = attempt.goals.len();
                for judged in &found {
                    let broken = judged.does.breaks.iter().map(|row| Goal::Row(*row));
                    let new: Vec<Goal> = broken.filter(|goal| !attempt.goals.contains(goal)).collect();
                    attempt.goals.extend(new);
                }
                for judged in found {
                    keep(&mut best, Some(judged));
                }
                if attempt.goals.len() == before {
                    break;
                }
            }
            if !far {
                self.stage.set(attempt.steps);
                let kept = self.stage.kept(attempt.object);
                let new: Vec<Goal> = kept.into_iter().filter(|goal| !attempt.goals.contains(goal)).collect();
                attempt.goals.extend(new);
            }
        }
        attempt.limit = more(attempt.limit, &self.stage);
        self.properly(best, &attempt, &riders)
    }

    /// The best move of an object; where the one that is known is awkward or goes far, it may go where such things stand.
    fn properly(&mut self, known: Option<Judged>, attempt: &Attempt<'_>, riders: &[ObjectId]) -> Option<Judged> {
        let dear = attempt.goals.iter().any(|goal| self.stage.cost(*goal) > DEAR);
        let near = |known: &Judged| known.is_sound() && (dear || known.cost <= FAR);
        if known.as_ref().is_some_and(near) || self.stage.has_spent(attempt.limit) {
            return known;
        }
        let mut best = known;
        for judged in self.judged(attempt, riders, From::Proper) {
            keep(&mut best, Some(judged));
        }
        best
    }

    /// What rests on an object and may go along.
    fn riders(&mut self, attempt: &Attempt<'_>, object: ObjectId) -> Vec<ObjectId> {
        let carried = self.stage.carried_by(object).into_iter();
        carried.filter(|id| !self.locked.contains(id) && self.stage.pins(*id, attempt.free)[0].is_none()).collect()
    }

    /// The smallest moves of an object, whatever they break.
    fn nearest(&mut self, attempt: &Attempt<'_>) -> Vec<Judged> {
        let riders = self.riders(attempt, attempt.object);
        let mut found = self.judged(attempt, &[], From::Here);
        if !riders.is_empty() {
            found.extend(self.judged(attempt, &riders, From::Here));
        }
        found
    }

    /// Goals, and the same with one way to satisfy one of them in its place, for each way; where places are given, all of
    /// them are tried anyway.
    fn different(&mut self, goals: &[Goal], object: ObjectId, places: From) -> Vec<Vec<Goal>> {
        let mut sets = vec![goals.to_vec()];
        if places == From::Proper {
            return sets;
        }
        for (i, &goal) in goals.iter().enumerate() {
            if sets.len() > WAYS || !self.stage.has_ways(goal) || self.stage.truth(goal).is_some_and(|t| t.holds) {
                continue;
            }
            for way in self.stage.ways(goal, object) {
                let mut set = goals.to_vec();
                set.splice(i..=i, way);
                sets.push(set);
            }
        }
        sets
    }

    /// Moves of an object with what goes along, by what they do; up to the first that neither does harm nor is awkward.
    fn judged(&mut self, attempt: &Attempt<'_>, riders: &[ObjectId], places: From) -> Vec<Judged> {
        let Attempt { object, goals, rows, steps, free, limit, company } = attempt;
        let [pos, turn] = self.stage.pins(*object, free);
        let freedom = Freedom { pos: pos.is_none(), turn: turn.is_none() };
        let earlier = steps.iter().find(|s| s.object == *object).copied();
        let here = ObjectMove { object: *object, by: [0.0; 3], turn: 0.0, with: None };
        self.stage.set(steps);
        let mut froms = vec![earlier.unwrap_or(here)];
        if earlier.is_none() && freedom.pos {
            // What stands on something and belongs on the floor is looked for places there first.
            let drop = self.stage.drop_to_floor(*object);
            froms.splice(0..0, drop.map(|far| ObjectMove { by: [0.0, -far, 0.0], ..here }));
        }
        let asked: Vec<Goal> = rows.iter().map(|row| Goal::Row(*row)).collect();
        let asked = if asked.is_empty() { goals } else { &asked };
        // Of a conjunction what fails counts: a chair before its desk that looks away is to be turned.
        let mut wanting: Vec<Goal> = Vec::new();
        for goal in asked {
            let parts = self.stage.failing_parts(*goal);
            wanting.extend(if parts.is_empty() { vec![*goal] } else { parts });
        }
        let directed = self.stage.is_about_direction(&wanting, *object);
        let mut candidates = Vec::new();
        for goals in self.different(goals, *object, places) {
            for from in &froms {
                let Some(search) = MoveSearch::new(&mut self.stage, &goals, (*from, riders), freedom, *limit) else {
                    return Vec::new();
                };
                let search = search.directed(directed);
                candidates.extend(match places {
                    From::Here => search.near(),
                    From::Afar => search.far(),
                    From::Proper => search.proper(),
                });
            }
        }
        candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
        candidates.dedup_by(|a, b| a.1 == b.1);
        if directed {
            candidates.sort_by_key(|(_, step)| !choice::is_turn(step));
        }
        let mut found = Vec::new();
        // Of each kind, turns and others, the first that is sound is enough.
        let mut done = [false; 2];
        for (i, (cost, step)) in candidates.into_iter().take(JUDGED * froms.len()).enumerate() {
            if i > 0 && self.stage.has_spent(self.limit) {
                break;
            }
            let turn = choice::is_turn(&step);
            if done[usize::from(turn)] {
                continue;
            }
            let along: Vec<ObjectMove> = riders.iter().filter_map(|id| self.stage.along(&step, *id)).collect();
            let moves = |s: &ObjectMove| s.object == *object || along.iter().any(|a| a.object == s.object);
            let mut all: Vec<ObjectMove> = steps.iter().filter(|s| !moves(s)).copied().collect();
            all.push(step);
            all.extend(along);
            self.stage.set(&all);
            if !goals.iter().all(|goal| self.stage.truth(*goal).is_some_and(|t| t.holds)) {
                continue;
            }
            let moved: Vec<ObjectId> = all.iter().map(|s| s.object).collect();
            let does = self.stage.consequences(&moved);
            if !self.stage.lands(&all, asked).is_empty() {
                continue;
            }
            let open = rows.iter().filter(|row| !does.repairs.contains(row)).count();
            let fitting = moved.iter().any(|id| self.stage.is_fitting(*id));
            let flaws = self.stage.new_flaws(&moved) + self.stage.misplaced(asked) + self.stage.half_out(&moved, asked);
            let cost = cost * (1.0 + ALONG.0 * *company as f64) + ALONG.1 * *company as f64;
            let judged =
                Judged { cost, steps: all, does, open, flaws, fitting, company: *company, directed: directed && turn };
            if judged.harm() == (0, 0) {
                self.harmless.push(judged.clone());
                done[usize::from(turn)] |= judged.is_sound();
            }
            found.push(judged);
            if done == [true; 2] {
                break;
            }
        }
        found
    }
}

/// Where moves of an object begin.
#[derive(Clone, Copy, PartialEq, Eq)]
enum From {
    /// Where it is.
    Here,
    /// Places farther off.
    Afar,
    /// Places where people put such things: beside a sofa, before the middle of a desk.
    Proper,
}

/// What is to be done about goals by moving an object.
#[derive(Clone)]
pub(super) struct Attempt<'t> {
    pub object: ObjectId,
    pub goals: Vec<Goal>,
    /// The rows that a move has to repair.
    pub rows: &'t [RowRef],
    /// What has been moved already.
    pub steps: &'t [ObjectMove],
    /// Assignments among these rows do not keep it where it is.
    pub free: &'t [RowRef],
    /// The work up to which it may be looked for.
    pub limit: usize,
    /// How many objects go along that it does not carry.
    pub company: usize,
}
