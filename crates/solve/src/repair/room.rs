//! The layout under the solver's own search, with what is wanted of it: from here objects are moved and moved back.

use super::judge::Judge;
use super::{Alternative, EACH, How, Moved, RepairOptions};
use crate::problem::Options;
use crate::problem::opens;
use crate::problem::pose::round_to;
use crate::problem::pose::{Pose, Ride, half_turn};
use crate::search::{Search, Snapshot};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use scenelang_engine::candidate::{Candidate, Change};
use scenelang_engine::frame::checks::Check;
use scenelang_engine::frame::terms;
use scenelang_engine::frame::{Frame, variables};
use scenelang_lang::program::{ObjectId, RegionId};
use scenelang_layout::digits;
use scenelang_layout::{DecisionValue, Layout, Vec3};
use scenelang_verify::check::Subject;
use scenelang_verify::explain::RowRef;
use scenelang_verify::report::model::RowKind;
use scenelang_verify::rules::Scope;
use scenelang_verify::{Value, World};

/// What a look at one way over the floor takes, as the search counts.
const WALK: u64 = 150_000;
/// What is smaller than this is no move (metres, degrees).
const STILL: f64 = 1e-7;
/// Digits that are written, as few as will do (metres and degrees); at last all that there are.
const DIGITS: [f64; 3] = [digits::STEP, 1e-6, 0.0];

/// The solver's options for a search with a budget.
pub(super) fn solver(options: &RepairOptions) -> Options {
    Options { budget: options.budget, judge: options.judge, ..Options::default() }
}

/// What stays the same while a layout is repaired.
pub(super) struct Fixtures<'a> {
    frame: Frame<'a>,
    world: World<f64>,
}

impl<'a> Fixtures<'a> {
    pub fn new(judge: &Judge<'a>) -> Self {
        let world = World::<f64>::new(judge.program, judge.layout, &judge.options);
        let scope = judge.options.physics.then(|| Scope::new(&world));
        let size = |id: ObjectId| judge.layout.object(&judge.program.objects[id.0 as usize].name).map(|p| p.scale);
        let terms = terms::split(judge.program).into_iter().chain(opens::terms(&world)).collect();
        let mut frame = Frame::new(judge.program, terms, scope, |id| size(id).unwrap_or_else(|| Vec3::repeat(1.0)));
        judge.locked.iter().for_each(|id| frame.lock(*id));
        Self { frame, world }
    }
}

pub(super) struct RepairSearch<'r, 'a> {
    pub judge: &'r Judge<'a>,
    pub search: Search<'r>,
    /// The layout as the search has it: rules of the program obeyed.
    pub start: Snapshot,
    /// By object: its pose in the layout, but for what is too little to speak of.
    pub poses: Vec<Pose>,
    /// By check: whether it is to hold.
    wanted: Vec<bool>,
    /// Whether ways over the floor are among what is wanted: then each look is dear.
    pub dear: bool,
    /// The work up to which something may be tried, if it is dear.
    most: u64,
    /// What it takes to judge all of it.
    judgement: u64,
}

impl<'r, 'a> RepairSearch<'r, 'a> {
    /// With the layout in it. With `careless`, preferences may break.
    pub fn new(judge: &'r Judge<'a>, fixtures: &'r Fixtures<'a>, options: &'r Options, careless: bool) -> Self {
        let frame = &fixtures.frame;
        let placed: Vec<Change> = frame
            .objects()
            .filter_map(|id| fixtures.world.object(id).ok().map(|thing| Change::Object(id, Pose::of(thing))))
            .collect();
        let mut state = Candidate::new(frame, fixtures.world.clone());
        state.limit = judge.limit.clone();
        if state.attempt(&placed, f64::INFINITY).is_some() {
            state.keep();
        }
        state.measure_all();
        state.look_at_ways();
        let n = frame.program.objects.len();
        let wanted: Vec<bool> = (0..state.numbering.len())
            .map(|check| {
                let row = row_of(frame, state.numbering.check(check));
                let soft = !state.is_hard(check);
                // One term says of all parts of an object that they open.
                if let Subject::Part(id, _) = row.subject {
                    let about = |row: &RowRef| matches!(row.subject, Subject::Part(other, _) if other == id);
                    return state.does_hold(check) || judge.targets.iter().any(about);
                }
                if judge.targets.contains(&row) {
                    return true;
                }
                // A part of a demand that held is kept, even if the whole did not.
                let held = if soft { !judge.failed(&row) } else { state.does_hold(check) || !judge.failed(&row) };
                held && !(soft && careless)
            })
            .collect();
        for (check, wanted) in wanted.iter().enumerate() {
            state.weight[check] = if *wanted { 1.0 } else { 0.0 };
        }
        let chance = ChaCha8Rng::seed_from_u64(judge.layout.seed.unwrap_or(0));
        let poses = frame.objects().map(|id| before(&fixtures.world, &state, id)).collect();
        let dear = frame.walks.iter().any(|&t| wanted[t]);
        let judgement = WALK * frame.walks.len() as u64;
        let search = Search { state, chance, options, best: None };
        debug_assert_eq!(n, search.state.placed().count());
        Self { judge, start: search.snapshot(), search, poses, wanted, dear, most: u64::MAX, judgement }
    }

    /// What is wanted and does not hold; ways over the floor only where all else holds.
    pub fn missing(&mut self) -> Vec<usize> {
        let cheap = self.cheaply_missing();
        if !cheap.is_empty() || !self.dear {
            return cheap;
        }
        self.search.state.look_at_ways();
        let state = &self.search.state;
        (0..self.wanted.len()).filter(|&c| self.wanted[c] && !state.does_hold(c)).collect()
    }

    /// What is wanted and does not hold, ways over the floor left out.
    pub fn cheaply_missing(&self) -> Vec<usize> {
        let state = &self.search.state;
        let walks = |c: usize| state.frame.terms.get(c).is_some_and(|t| t.walks);
        (0..self.wanted.len()).filter(|&c| self.wanted[c] && !state.does_hold(c) && !walks(c)).collect()
    }

    /// Whether all that is wanted holds.
    pub fn holds(&mut self) -> bool {
        let wanted = &self.wanted;
        self.cheaply_missing().is_empty() && (!self.dear || self.search.state.has_ways(|term| wanted[term]))
    }

    /// Whether nothing more may be tried: ways over the floor are too dear to be looked at often, or the time is over.
    pub fn is_spent(&self) -> bool {
        self.search.is_late() || self.dear && self.search.state.work >= self.most
    }

    /// From here on so much work is allowed where each look is dear.
    pub fn allow(&mut self, work: u64) {
        self.most = self.search.state.work + work;
    }

    /// Makes changes; keeps them if all that is wanted holds then. Whether it does.
    pub fn hold(&mut self, changes: &[Change]) -> bool {
        if self.is_spent() {
            return false;
        }
        let before = self.search.snapshot();
        if self.search.state.attempt(changes, f64::INFINITY).is_none() {
            return false;
        }
        self.search.state.keep();
        let holds = self.holds();
        if !holds {
            self.search.restore(&before);
        }
        holds
    }

    /// Objects that are elsewhere than at the start.
    pub fn moved(&self) -> Vec<ObjectId> {
        let state = &self.search.state;
        state.frame.objects().filter(|id| differ(&state.pose(*id), &self.poses[id.0 as usize])).collect()
    }

    /// What a move of an object costs.
    pub fn travel(&self, id: ObjectId, to: &Pose) -> f64 {
        travel(&self.poses[id.0 as usize], to)
    }

    /// The layout as it now is, if that repairs: as few objects moved as the search has it, or, where that is not enough,
    /// with everything where the rules of the program put it.
    pub fn alternative(&mut self) -> Option<Alternative> {
        let fine = [true, false].into_iter().find_map(|lazy| {
            DIGITS.into_iter().find_map(|digits| {
                let layout = self.compose(lazy, digits);
                let broken = self.judge.judge(&layout)?;
                Some((layout, broken))
            })
        });
        let (mut layout, mut broken) = fine?;
        // What need not move after all, stays.
        for index in 0..layout.objects.len() {
            let old = &self.judge.layout.objects[index].1;
            if layout.objects[index].1 == *old || self.is_spent() {
                continue;
            }
            // Judging the whole is a look, too.
            self.search.state.work += self.judgement;
            let mut fewer = layout.clone();
            fewer.objects[index].1 = old.clone();
            if let Some(now) = self.judge.judge(&fewer).filter(|now| now.len() <= broken.len()) {
                (layout, broken) = (fewer, now);
            }
        }
        let mut alternative = describe(self.judge, layout, &broken);
        let ways: Vec<(ObjectId, Ride)> =
            alternative.moves.iter().map(|m| (m.object, Ride::new(&m.from, &m.to))).collect();
        for m in &mut alternative.moves {
            let carries = |(leader, way): &&(ObjectId, Ride)| {
                *leader != m.object
                    && near(&way.apply(&m.from), &m.to)
                    && self.search.state.riders(*leader).contains(&m.object)
            };
            m.with = ways.iter().find(carries).map(|(leader, _)| *leader);
        }
        Some(alternative)
    }

    /// Of these objects those that go where another of them carries them.
    pub fn carried(&self, objects: &[ObjectId]) -> Vec<ObjectId> {
        let state = &self.search.state;
        let mut found = Vec::new();
        for &leader in objects {
            let way = Ride::new(&self.poses[leader.0 as usize], &state.pose(leader));
            let along = |id: &ObjectId| near(&way.apply(&self.poses[id.0 as usize]), &state.pose(*id));
            found.extend(state.riders(leader).into_iter().filter(|id| objects.contains(id) && along(id)));
        }
        found
    }

    /// The layout with what the search has moved; `lazy`: what only rules have moved stays.
    fn compose(&self, lazy: bool, digits: f64) -> Layout {
        let state = &self.search.state;
        let frame = state.frame;
        let cut = |new: f64, old: f64| {
            if (new - old).abs() < STILL {
                old
            } else if digits > 0.0 {
                round_to(new, digits)
            } else {
                new
            }
        };
        let vec = |new: Vec3, old: Vec3| Vec3::from_fn(|i, _| cut(new[i], old[i]));
        let mut layout = self.judge.layout.clone();
        for (name, placement) in &mut layout.objects {
            let Some(id) = frame.objects().find(|id| frame.name(*id) == *name) else { continue };
            let pose = state.pose(id);
            let shifted = differ(&pose, &self.poses[id.0 as usize]);
            if shifted || !lazy {
                placement.pos = vec(pose.pos, placement.pos);
                placement.rot = turned(vec(pose.rot, placement.rot), placement.rot);
                if placement.parts.is_empty() {
                    placement.scale = vec(pose.scale, placement.scale);
                }
            }
        }
        for (index, region) in frame.program.regions.iter().enumerate() {
            let pose = state.region_pose(RegionId(index as u32));
            if let Some((_, placement)) = layout.regions.iter_mut().find(|(name, _)| *name == region.name) {
                placement.pos = vec(pose.pos, placement.pos);
                placement.scale = vec(pose.scale, placement.scale);
            }
        }
        for id in variables(frame.program) {
            let name = &frame.program.variables[id.0 as usize].name;
            let Some((_, written)) = layout.variables.iter_mut().find(|(n, _)| n == name) else { continue };
            match (state.world().variable(id), &mut *written) {
                (Ok(Value::Number(new)), DecisionValue::Number(old)) => *old = cut(new, *old),
                (Ok(Value::Vector(new) | Value::Rotation(new)), DecisionValue::Triple(old)) => {
                    *old = std::array::from_fn(|i| cut(new.0[i], old[i]));
                }
                _ => {}
            }
        }
        layout
    }
}

/// What differs between a layout that repairs and ours.
pub(super) fn describe(judge: &Judge<'_>, layout: Layout, broken: &[RowRef]) -> Alternative {
    let mut moves = Vec::new();
    for (index, object) in judge.program.objects.iter().enumerate() {
        let (Some(old), Some(new)) = (judge.layout.object(&object.name), layout.object(&object.name)) else { continue };
        if old != new {
            let [from, to] = [old, new].map(|p| Pose { pos: p.pos, rot: p.rot, scale: p.scale });
            moves.push(Moved { object: ObjectId(index as u32), from, to, with: None });
        }
    }
    let regions = judge.layout.regions.iter().filter(|(name, old)| layout.region(name) != Some(old));
    let value = |name: &str| layout.variables.iter().find(|(n, _)| n == name).map(|(_, v)| v);
    let values = judge.layout.variables.iter().filter(|(name, old)| value(name) != Some(old));
    let also: Vec<String> =
        regions.map(|(name, _)| name.to_string()).chain(values.map(|(name, _)| name.to_string())).collect();
    let cost = moves.iter().map(|m| EACH + travel(&m.from, &m.to)).sum::<f64>() + EACH * also.len() as f64;
    let drops = broken.iter().filter_map(|row| match row.subject {
        Subject::Statement(index) => Some(index),
        _ => None,
    });
    let drops: Vec<usize> = drops.collect();
    let how = if drops.is_empty() { How::Moves } else { How::Drop };
    Alternative { how, moves, also, edits: Vec::new(), least: Vec::new(), shown: Vec::new(), drops, layout, cost }
}

/// Metres that the farthest point of an object travels at most, by its weight.
fn travel(from: &Pose, to: &Pose) -> f64 {
    let (per_degree, weight) = from.heft();
    let turn: f64 = (0..3).map(|i| half_turn(to.rot[i] - from.rot[i]).abs()).sum();
    ((to.pos - from.pos).norm() + turn * per_degree) * weight
}

/// Whether two poses of an object are not the same place.
fn differ(a: &Pose, b: &Pose) -> bool {
    (a.pos - b.pos).amax() > STILL
        || (a.scale - b.scale).amax() > STILL
        || (0..3).any(|i| half_turn(a.rot[i] - b.rot[i]).abs() > STILL)
}

/// Whether two poses are the same to the eye.
fn near(a: &Pose, b: &Pose) -> bool {
    (a.pos - b.pos).amax() < 1e-4 && (0..3).all(|i| half_turn(a.rot[i] - b.rot[i]).abs() < 1e-2)
}

/// The angles as they were written, where they are the same but for whole turns.
fn turned(new: Vec3, old: Vec3) -> Vec3 {
    Vec3::from_fn(|i, _| if half_turn(new[i] - old[i]).abs() < STILL { old[i] } else { new[i] })
}

/// Where the layout has an object. What rules of the program shift by less than their tolerance has not moved.
fn before(world: &World<f64>, state: &Candidate<'_>, id: ObjectId) -> Pose {
    let now = state.pose(id);
    let Ok(pose) = world.object(id).map(Pose::of) else { return now };
    let tolerances = &world.options.tolerances;
    let turned = (0..3).any(|i| half_turn(pose.rot[i] - now.rot[i]).abs() > tolerances.angle);
    let shifted = (pose.pos - now.pos).norm() > 2.0 * tolerances.equal;
    if turned || shifted { pose } else { now }
}

/// The row that a check belongs to.
fn row_of(frame: &Frame<'_>, check: Check) -> RowRef {
    let (kind, subject) = match check {
        Check::Term(t) if frame.terms[t].opens.is_some() => {
            (RowKind::Open, Subject::Part(frame.terms[t].opens.unwrap_or(ObjectId(0)), 0))
        }
        Check::Term(t) => {
            let kind = if frame.terms[t].is_hard() { RowKind::Assert } else { RowKind::Prefer };
            (kind, Subject::Statement(frame.terms[t].constraint))
        }
        Check::Collide(a, b) => {
            let sorted = frame.name(a) <= frame.name(b);
            (RowKind::Collision, if sorted { Subject::Pair(a, b) } else { Subject::Pair(b, a) })
        }
        Check::Bounds(a) => (RowKind::Bounds, Subject::Object(a)),
        Check::Support(a) => (RowKind::Support, Subject::Object(a)),
    };
    RowRef { kind, subject }
}
