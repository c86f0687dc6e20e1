//! A search in progress: the layout, chance, and the best so far.

pub(crate) mod chance;
pub(crate) mod least_squares;
pub(crate) mod local;

use crate::problem::pose::Pose;
use crate::problem::{Options, Phase, Progress};
use rand_chacha::ChaCha8Rng;
use scenelang_engine::candidate::{Candidate, Change};
use scenelang_lang::program::{ObjectId, RegionId, VariableId};
use scenelang_verify::Value;

/// A layout as values.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Snapshot {
    objects: Vec<Option<Pose>>,
    regions: Vec<Pose>,
    variables: Vec<Option<Value<f64>>>,
}

impl Snapshot {
    pub fn of(state: &Candidate<'_>) -> Self {
        let program = state.frame.program;
        Self {
            objects: state.frame.objects().map(|o| state.is_placed(o).then(|| state.pose(o))).collect(),
            regions: (0..program.regions.len() as u32).map(|r| state.region_pose(RegionId(r))).collect(),
            variables: scenelang_engine::frame::variables(program).map(|v| state.world().variable(v).ok()).collect(),
        }
    }

    /// Brings a state to this layout.
    pub fn show(&self, state: &mut Candidate<'_>) {
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
    pub state: Candidate<'a>,
    pub chance: ChaCha8Rng,
    /// How to solve.
    pub options: &'a Options,
    /// The best layout so far.
    pub best: Option<Best>,
}

impl<'a> Search<'a> {
    /// How far the search is.
    pub fn progress(&self, phase: Phase, iteration: usize) -> Progress {
        let frame = self.state.frame;
        let n = frame.program.objects.len();
        let physical = frame.scope.as_ref().map_or(0, |s| s.pairs(n, |_| true) + 2 * n);
        let total = frame.terms.iter().filter(|t| t.is_hard()).count() + physical;
        Progress { phase, iteration, held: total.saturating_sub(self.state.violated().len()), total }
    }

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

    /// Gives an object the place that its rules give it, without a look at anything.
    pub fn put_anywhere(&mut self, id: ObjectId) {
        if self.state.attempt(&[Change::Join(id)], f64::INFINITY).is_some() {
            self.state.keep();
        }
    }

    /// Whether nothing that an object's place is made of is still waiting for one.
    pub fn is_ready(&self, id: ObjectId, waiting: &[ObjectId]) -> bool {
        let frame = self.state.frame;
        let container = match frame.hold(id) {
            scenelang_engine::frame::Hold::Container(c) => Some(c),
            _ => None,
        };
        frame.sources[id.0 as usize].iter().copied().chain(container).all(|o| o == id || !waiting.contains(&o))
    }
}
