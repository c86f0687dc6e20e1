//! A search in progress: the layout, the polisher, chance, the best so far, and the moves that all steps are made of.

pub(crate) mod least_squares;
pub(crate) mod local;
pub(crate) mod looks;
pub(crate) mod penalty;
pub(crate) mod pool;
pub(crate) mod state;

use crate::pipeline::tidy;
use crate::problem::Options;
use crate::problem::checks::Check;
use crate::problem::pose::{Pose, Ride};
use crate::search::least_squares::{Polisher, Targets};
use crate::search::state::{Change, State};
use pool::{Breadth, Chance};
use rand_chacha::ChaCha8Rng;
use scenelang_lang::program::{ObjectId, RegionId, VariableId};
use scenelang_verify::Value;

/// How many of the ranked candidates are polished.
const POLISHED: usize = 5;
/// Steps of a polish of one object, and of several.
pub(crate) const STEPS: [usize; 2] = [10, 25];
/// How many objects are moved together to end a trouble.
const PARTNERS: [usize; 2] = [8, 40];
/// How much chance there is in the order in which objects are placed anew.
const RECREATION_NOISE: f64 = 0.4;
/// Candidates whose costs differ by less than this are equally good: chance decides.
const ALIKE: f64 = 0.003;

/// A layout as values.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Snapshot {
    objects: Vec<Option<Pose>>,
    regions: Vec<Pose>,
    variables: Vec<Option<Value<f64>>>,
}

impl Snapshot {
    /// Of a state.
    pub fn of(state: &State<'_>) -> Self {
        let program = state.frame.program;
        Self {
            objects: state.frame.objects().map(|o| state.is_placed(o).then(|| state.pose(o))).collect(),
            regions: (0..program.regions.len() as u32).map(|r| state.region_pose(RegionId(r))).collect(),
            variables: crate::problem::frame::variables(program).map(|v| state.world().variable(v).ok()).collect(),
        }
    }

    /// Brings a state to this layout.
    pub fn show(&self, state: &mut State<'_>) {
        let mut changes = Vec::new();
        for (index, pose) in self.objects.iter().enumerate() {
            let id = ObjectId(index as u32);
            match pose {
                Some(pose) if !state.is_placed(id) || state.pose(id) != *pose => {
                    changes.push(Change::Object(id, *pose));
                }
                None if state.is_placed(id) => state.banish(id),
                _ => {}
            }
        }
        for (index, pose) in self.regions.iter().enumerate() {
            let id = RegionId(index as u32);
            if state.region_pose(id) != *pose {
                changes.push(Change::Region(id, *pose));
            }
        }
        for (index, value) in self.variables.iter().enumerate() {
            let id = VariableId(index as u32);
            if let Some(value) = value.filter(|v| state.world().variable(id).ok() != Some(*v)) {
                changes.push(Change::Variable(id, value));
            }
        }
        if !changes.is_empty() && state.attempt(&changes, f64::INFINITY).is_some() {
            state.keep();
        }
    }
}

/// The best layout so far.
#[derive(Clone, Debug)]
pub(crate) struct Best {
    /// How many checks it violates, and what those cost.
    pub hard: (usize, f64),
    /// What it costs otherwise.
    pub soft: f64,
    /// The layout.
    pub snapshot: Snapshot,
}

impl Best {
    /// Whether one (violations, their cost, the rest) is better than another.
    pub fn is_better(a: ((usize, f64), f64), b: ((usize, f64), f64)) -> bool {
        let ((n, hard), soft) = a;
        let ((m, worst), other) = b;
        n.cmp(&m).then(if n == 0 { (hard + soft).total_cmp(&(worst + other)) } else { hard.total_cmp(&worst) }).is_lt()
    }
}

/// A search in progress.
pub(crate) struct Search<'a> {
    /// The layout.
    pub state: State<'a>,
    /// What makes it exact.
    pub polisher: Polisher,
    /// Chance.
    pub chance: ChaCha8Rng,
    /// How to solve.
    pub options: &'a Options,
    /// By object: which come first. Troublemakers rise.
    pub priority: Vec<f64>,
    /// The best layout so far.
    pub best: Option<Best>,
}

impl<'a> Search<'a> {
    /// Whether the work is used up to a part of the budget.
    pub fn is_spent(&self, part: f64) -> bool {
        self.is_late() || self.state.work as f64 >= self.options.budget as f64 * part
    }

    /// Whether the time is over, or the end was asked for.
    pub fn is_late(&self) -> bool {
        self.state.limit.is_over()
    }

    /// The layout as values.
    pub fn snapshot(&self) -> Snapshot {
        Snapshot::of(&self.state)
    }

    /// Goes back to a layout.
    pub fn restore(&mut self, snapshot: &Snapshot) {
        snapshot.show(&mut self.state);
    }

    /// Remembers the layout if it is the best so far. Whether it is.
    pub fn note(&mut self) -> bool {
        let now = (self.state.hard(), self.state.soft());
        let better = self.best.as_ref().is_none_or(|b| Best::is_better(now, (b.hard, b.soft)));
        if better {
            self.best = Some(Best { hard: now.0, soft: now.1, snapshot: self.snapshot() });
        }
        better
    }

    /// Finds a place for an object, the best of many candidates; what stands on it goes along, and so does `group`. With
    /// `improve` it stays where it is unless another place is better. Whether anything changed.
    pub fn place(&mut self, id: ObjectId, breadth: Breadth, group: &[ObjectId], improve: bool) -> bool {
        let start = improve.then(|| (self.state.total(), self.snapshot()));
        let candidates = pool::candidates(&mut self.state, id, breadth, &mut self.chance);
        let mut ranked: Vec<(f64, Pose)> = Vec::with_capacity(POLISHED + 1);
        for pose in candidates {
            if self.is_late() && !ranked.is_empty() {
                break;
            }
            let limit = if ranked.len() < POLISHED { f64::INFINITY } else { ranked[POLISHED - 1].0 };
            let changes = self.ride(id, pose, group);
            let Some(cost) = self.state.attempt(&changes, limit) else { continue };
            self.state.undo();
            let cost = cost + ALIKE * self.chance.unit();
            let at = ranked.partition_point(|(c, _)| *c <= cost);
            // The same place twice would be polished twice.
            if at == 0 || ranked[at - 1].1 != pose {
                ranked.insert(at, (cost, pose));
                ranked.truncate(POLISHED);
            }
        }
        let mut best: Option<(f64, Snapshot)> = start.clone();
        let from = self.snapshot();
        for (rank, (_, pose)) in ranked.into_iter().enumerate() {
            if rank > 0 {
                if self.is_late() {
                    break;
                }
                self.restore(&from);
            }
            let changes = self.ride(id, pose, group);
            if self.state.attempt(&changes, f64::INFINITY).is_none() {
                continue;
            }
            self.state.keep();
            if self.is_troubled(id) {
                self.polish(vec![id], STEPS[0]);
            }
            let total = self.state.total() + ALIKE * self.chance.unit();
            if best.as_ref().is_none_or(|(least, _)| total < *least - 1e-9) {
                best = Some((total, self.snapshot()));
            }
        }
        let Some((total, snapshot)) = best else { return false };
        self.restore(&snapshot);
        let moved = start.is_none_or(|(before, _)| total < before);
        if moved {
            self.reconcile(id);
            tidy::object(&mut self.state, id);
        }
        moved
    }

    /// The moves that bring an object to a pose, with what stands on it and with some others.
    fn ride(&self, id: ObjectId, pose: Pose, group: &[ObjectId]) -> Vec<Change> {
        let mut changes = self.state.with_riders(id, pose);
        let ride = Ride::new(&self.state.pose(id), &pose);
        if !self.state.is_placed(id) {
            // They take their places from their rules.
            changes.extend(self.state.companions(id).into_iter().map(Change::Join));
        }
        for &other in group.iter().filter(|o| **o != id && self.state.is_placed(**o)) {
            if !changes.iter().any(|c| matches!(c, Change::Object(o, _) if *o == other)) {
                changes.push(Change::Object(other, ride.apply(&self.state.pose(other))));
            }
        }
        changes
    }

    /// Moves objects, and the decision variables that their terms read, so that less is violated.
    pub fn polish(&mut self, mut objects: Vec<ObjectId>, steps: usize) -> bool {
        objects.sort_unstable();
        let targets = Targets::objects(&self.state, objects);
        self.polisher.polish(&mut self.state, &targets, steps)
    }

    /// If an object is in trouble where it is: moves those with it that it is in trouble with, then all that goes where
    /// these go.
    pub fn reconcile(&mut self, id: ObjectId) -> bool {
        let mut improved = false;
        for most in PARTNERS {
            if !self.is_troubled(id) {
                break;
            }
            let mut objects = self.quarrel(id);
            objects.truncate(PARTNERS[0]);
            if most > PARTNERS[0] {
                objects = self.dependents(&objects, most);
            }
            improved |= self.polish(objects, STEPS[1]);
        }
        improved
    }

    /// An object and the movable ones that it shares failing hard checks with.
    fn quarrel(&self, id: ObjectId) -> Vec<ObjectId> {
        let state = &self.state;
        let pairs = state.placed().filter(|o| *o != id).map(|o| state.numbering.collide(id, o));
        let terms = state.frame.index.of_object(id).iter().copied();
        let mut list = vec![id];
        for check in terms.chain(pairs).filter(|&c| state.is_hard(c) && state.cost(c) > 0.0) {
            for other in state.objects_of(check) {
                if state.is_placed(other) && state.frame.is_movable(other) && !list.contains(&other) {
                    list.push(other);
                }
            }
        }
        list
    }

    /// Whether some hard check that speaks of an object costs anything.
    pub fn is_troubled(&self, id: ObjectId) -> bool {
        let state = &self.state;
        let physical = [state.numbering.bounds(id), state.numbering.support(id)];
        let pairs = state.placed().filter(|o| *o != id).map(|o| state.numbering.collide(id, o));
        let terms = state.frame.index.of_object(id).iter().copied();
        terms.chain(physical).chain(pairs).any(|c| state.is_hard(c) && state.cost(c) > 0.0)
    }

    /// Takes objects out and finds places for them anew, one after the other.
    pub fn recreate(&mut self, objects: &[ObjectId]) {
        let objects = self.with_companions(objects);
        for &id in &objects {
            self.state.banish(id);
        }
        let noise = |chance: &mut ChaCha8Rng| RECREATION_NOISE * chance.unit();
        let mut order: Vec<(f64, ObjectId)> =
            objects.iter().map(|&o| (self.priority[o.0 as usize] + noise(&mut self.chance), o)).collect();
        order.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let mut waiting: Vec<ObjectId> = order.into_iter().map(|(_, o)| o).collect();
        while !waiting.is_empty() {
            let ready = waiting.iter().position(|&o| self.is_ready(o, &waiting)).unwrap_or(0);
            let id = waiting.remove(ready);
            if !self.state.is_placed(id) {
                if self.is_spent(1.0) {
                    self.put_anywhere(id);
                } else {
                    self.bring_in(id);
                }
            }
        }
    }

    /// Objects, and those whose places are fixed by theirs.
    fn with_companions(&self, objects: &[ObjectId]) -> Vec<ObjectId> {
        let frame = self.state.frame;
        let mut all = objects.to_vec();
        for id in objects {
            for owner in frame.followers[id.0 as usize].iter().map(|&r| frame.rules.list[r].owner) {
                if !all.contains(&owner) && frame.is_settled(owner) {
                    all.push(owner);
                }
            }
        }
        all
    }

    /// Gives an object the place that its rules give it, without a look at anything.
    pub fn put_anywhere(&mut self, id: ObjectId) {
        if self.state.attempt(&[Change::Join(id)], f64::INFINITY).is_some() {
            self.state.keep();
        }
    }

    /// Finds a place for an object that has none; those that come with it are looked at, too.
    pub fn bring_in(&mut self, id: ObjectId) {
        let companions = self.state.companions(id);
        self.place(id, Breadth::All, &[], false);
        for other in companions {
            if self.is_troubled(other) {
                self.place(other, Breadth::All, &[], true);
            }
        }
    }

    /// Whether nothing that an object's place is made of is still waiting for one.
    pub fn is_ready(&self, id: ObjectId, waiting: &[ObjectId]) -> bool {
        let frame = self.state.frame;
        let container = match frame.hold(id) {
            crate::problem::frame::Hold::Container(c) => Some(c),
            _ => None,
        };
        frame.sources[id.0 as usize].iter().copied().chain(container).all(|o| o == id || !waiting.contains(&o))
    }

    /// Objects that go where others go: what stands on them, and what is placed after them because of them.
    pub fn dependents(&mut self, seeds: &[ObjectId], most: usize) -> Vec<ObjectId> {
        let frame = self.state.frame;
        let mut found: Vec<ObjectId> = seeds.to_vec();
        let mut next = 0;
        while next < found.len() && found.len() < most {
            let base = found[next];
            next += 1;
            let depends = |o: &ObjectId| {
                let anchor = frame.related[o.0 as usize]
                    .iter()
                    .map(|(r, _)| *r)
                    .find(|r| self.priority[r.0 as usize] > self.priority[o.0 as usize]);
                anchor == Some(base)
            };
            let mut more: Vec<ObjectId> = self.state.riders(base);
            more.extend(frame.followers[base.0 as usize].iter().map(|&r| frame.rules.list[r].owner));
            more.extend(frame.objects().filter(depends));
            for o in more {
                if !found.contains(&o) && found.len() < most {
                    found.push(o);
                }
            }
        }
        found
    }

    /// Movable objects that a check speaks of; of one that depends on everything around, those that make it fail, too.
    pub fn blamed(&mut self, check: usize) -> Vec<ObjectId> {
        let frame = self.state.frame;
        let mut list: Vec<ObjectId> = match self.state.numbering.check(check) {
            Check::Term(t) => frame.terms[t].objects.clone(),
            Check::Collide(a, b) => vec![a, b],
            Check::Bounds(a) => vec![a],
            Check::Support(a) => std::iter::once(a).chain(self.state.seats[a.0 as usize]).collect(),
        };
        if frame.terms.get(check).is_some_and(|t| t.sees_all) && !self.is_spent(1.0) {
            list = self.state.in_the_way(check);
        }
        // What a pin puts somewhere moves with what the pin reads.
        for i in 0..list.len() {
            list.extend(
                frame.sources[list[i].0 as usize].iter().filter(|o| !list.contains(o)).copied().collect::<Vec<_>>(),
            );
        }
        list.retain(|o| frame.is_movable(*o));
        list
    }
}
