//! What the solver is given and what it gives back, as values.

pub(crate) mod draws;
pub(crate) mod opens;
pub(crate) mod setup;
pub(crate) mod sound;
pub(crate) mod values;

pub(crate) use scenelang_engine::pose;

use scenelang_engine::limit::Stop;
use scenelang_lang::Program;
use scenelang_lang::program::{ObjectId, RegionId};
use scenelang_layout::Layout;
use smol_str::SmolStr;
use std::time::Duration;

/// More objects than this are not laid out: every pair of them may collide, and is a check of its own.
pub const MOST_OBJECTS: usize = 4000;

/// What part of the usual work may go into preferences, in percent, unless it is said otherwise.
pub const QUALITY: u8 = 20;

/// A scene to be laid out.
#[derive(Clone, Debug)]
pub struct Problem<'a> {
    /// What must hold.
    pub program: &'a Program,
    /// Sizes, parts and support surfaces of the objects (those of the assets), and whatever else is known.
    /// An object that is missing here is a cube of 0.5 m, unless the program assigns its size.
    pub start: Layout,
    /// Which poses of `start` mean something: the solver starts from these.
    pub placed: Placed,
}

/// Which objects and regions of the layout to start from are where they belong already.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Placed {
    /// None: a new scene.
    #[default]
    None,
    /// All that the layout has: solving again after an edit.
    All,
    /// These.
    Some { objects: Vec<ObjectId>, regions: Vec<RegionId> },
}

impl Placed {
    /// Whether the pose of an object that the layout has counts.
    pub fn object(&self, id: ObjectId) -> bool {
        match self {
            Self::None => false,
            Self::All => true,
            Self::Some { objects, .. } => objects.contains(&id),
        }
    }
    /// Whether the place of a region that the layout has counts.
    pub fn region(&self, id: RegionId) -> bool {
        match self {
            Self::None => false,
            Self::All => true,
            Self::Some { regions, .. } => regions.contains(&id),
        }
    }
}

/// How to solve. Budgets count work, not seconds, so that a result does not depend on the machine.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Fixes draws and every random choice.
    pub seed: u64,
    /// How many violated constraints are taken up at a time.
    pub batch: usize,
    /// At most so much work in all; a unit is some twenty nanoseconds. 0: by the number of objects.
    pub budget: u64,
    /// How many times the usual work is allowed where the number of objects sets the budget; 0 counts as 1.
    pub effort: u64,
    /// At most so long, whatever the budget. What comes of it then depends on the machine.
    pub time: Option<Duration>,
    /// How many threads may work; 0: as many as there are cores. The outcome does not depend on it.
    pub threads: usize,
    /// Set from elsewhere, it ends the search; what was found by then is the outcome.
    pub stop: Stop,
    /// Which of the layouts that the seed leads to: draws stay the same, choices differ.
    pub variant: u64,
    /// Objects that stay where the layout to start from has them.
    pub locked: Vec<ObjectId>,
    /// At most this part of the budget goes into preferences and looks once all that must hold does.
    pub polish: f64,
    /// Whether to look, where not all that must hold does, for what is in the way.
    pub diagnose: bool,
    /// Tolerances, η, what a solid is, whether the physical rules apply.
    pub judge: scenelang_verify::Options,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            seed: 0,
            batch: 3,
            budget: 0,
            effort: 1,
            time: None,
            threads: 0,
            stop: Stop::default(),
            variant: 0,
            locked: Vec::new(),
            polish: f64::from(QUALITY) / 100.0,
            diagnose: true,
            judge: scenelang_verify::Options::default(),
        }
    }
}

impl Options {
    /// How many threads may work.
    pub(crate) fn threads(&self) -> usize {
        match self.threads {
            0 => std::thread::available_parallelism().map_or(1, usize::from),
            threads => threads,
        }
    }

    /// The same with a budget for so many objects.
    pub(crate) fn budgeted(&self, objects: usize) -> Self {
        const LEAST: u64 = 20_000_000;
        const PER_OBJECT: u64 = 8_000_000;
        // The searches add budgets up and take parts of them as `f64`, which has all whole numbers up to here.
        const MOST: u64 = 1 << 53;
        let usual = LEAST.saturating_add(PER_OBJECT.saturating_mul(objects as u64));
        let budget = match self.budget {
            0 => usual.saturating_mul(self.effort.max(1)).min(MOST),
            budget => budget,
        };
        Self { budget, ..self.clone() }
    }
}

/// Why a search came to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// All that must hold does.
    Solved,
    /// The work that was allowed is done.
    Budget,
    /// The time that was allowed is over.
    Time,
    /// There is nothing more to try, or nobody who could.
    Exhausted,
    /// The caller ended it.
    Asked,
}

/// How a stated constraint stands in the layout found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing {
    /// Whether it holds.
    pub holds: bool,
    /// By how much it holds, or fails if negative: metres or degrees; `None`: it has no metres, or cannot be judged.
    pub margin: Option<f64>,
}

/// What came of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The best layout found: every object, region, variable and draw of the program. No object is ever dropped.
    pub layout: Layout,
    /// Whether all that must hold does.
    pub converged: bool,
    /// Why the search ended.
    pub end: End,
    /// How every stated constraint stands, by its index in [`Program::constraints`].
    pub constraints: Vec<Standing>,
    /// Where not all that must hold does: few stated constraints, found by search (not proved), without which the rest
    /// can hold. All that must hold but these does so in this layout. Empty where none were found.
    pub in_the_way: Vec<usize>,
    /// Rounds of the loop in all.
    pub iterations: usize,
    /// Work done, see [`Options::budget`].
    pub work: u64,
    /// What does not hold, preferences included.
    pub unsatisfied: Vec<Unsatisfied>,
    /// What the user should know: sizes changed, a budget spent, a draw without bounds.
    pub warnings: Vec<String>,
}

/// Something that does not hold in the layout found.
#[derive(Clone, Debug, PartialEq)]
pub struct Unsatisfied {
    pub what: TermSubject,
    /// By how much it fails: negative, metres or degrees; `None`: it has no metres, or cannot be judged.
    pub margin: Option<f64>,
}

/// A constraint of the program, or a physical rule with what it speaks of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TermSubject {
    /// An index into [`Program::constraints`]: an assertion, a pin, or a preference.
    Stated(usize),
    /// P-COLLIDE of two objects.
    Collision(SmolStr, SmolStr),
    /// P-BOUNDS of an object.
    Bounds(SmolStr),
    /// P-SUPPORT of an object.
    Support(SmolStr),
    /// P-OPEN of an object, with what keeps it from opening, if that is an object.
    Open(SmolStr, Option<SmolStr>),
}

/// A step of the solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Finding a first place for everything.
    InitialPlacement,
    /// Pushing overlapping solids apart.
    PhysicsRelaxation,
    /// Repairing batches of violated constraints.
    Repair,
}

/// How far the solver is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// The current step.
    pub phase: Phase,
    /// Rounds of the loop so far.
    pub iteration: usize,
    /// How many of the terms that must hold do.
    pub held: usize,
    /// How many there are.
    pub total: usize,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn effort_multiplies_the_budget_of_the_objects_only() {
        let budget =
            |budget, effort, objects| Options { budget, effort, ..Options::default() }.budgeted(objects).budget;
        let usual = budget(0, 1, 10);
        assert_eq!((budget(0, 0, 10), budget(0, 7, 10)), (usual, 7 * usual));
        assert_eq!(budget(5, 7, 10), 5);
        assert_eq!(budget(0, u64::MAX, usize::MAX), 1 << 53);
        let budgeted = Options { effort: 3, ..Options::default() }.budgeted(10);
        assert_eq!(budgeted.budgeted(10), budgeted, "it is not multiplied again");
    }
}
