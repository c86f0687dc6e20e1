//! What a step of the solver from outside sees of a layout under search, and what it may propose.

use crate::problem::TermSubject;
use crate::problem::pose::Pose;
use scenelang_engine::candidate::Candidate;
use scenelang_engine::frame::checks::Check;
use scenelang_lang::Program;
use scenelang_lang::program::{ObjectId, RegionId};
use scenelang_layout::Vec3;
use scenelang_verify::{World, judge, rules};

/// A layout under search, to be read.
#[derive(Clone, Copy)]
pub struct View<'v> {
    state: &'v Candidate<'v>,
}

/// A constraint or a physical rule, and how it stands in the layout.
#[derive(Clone, Debug, PartialEq)]
pub struct Concern {
    pub what: TermSubject,
    /// Whether it must hold; else it is a preference.
    pub hard: bool,
    /// Whether it holds.
    pub holds: bool,
    /// By how much it holds, or fails if negative: metres or degrees; `None`: it has no metres, or cannot be judged.
    pub margin: Option<f64>,
    /// Objects that it speaks of.
    pub objects: Vec<ObjectId>,
}

/// Where an object is to go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Move {
    pub object: ObjectId,
    /// Centre of its bottom face (metres).
    pub pos: Vec3,
    /// Euler triple (degrees).
    pub rot: Vec3,
}

/// Moves that belong together: all of them are made, or none.
///
/// What stands on an object goes with it, what the program assigns stays as it is assigned, and numbers that are not
/// finite make the proposal void.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Proposal {
    pub moves: Vec<Move>,
}

impl<'v> View<'v> {
    pub(crate) fn new(state: &'v Candidate<'v>) -> Self {
        Self { state }
    }
    /// What must hold.
    pub fn program(&self) -> &'v Program {
        self.state.frame.program
    }
    /// The layout as an instance of the program, in which any formula can be judged.
    pub fn world(&self) -> &'v World<f64> {
        self.state.world()
    }
    /// All objects.
    pub fn objects(&self) -> impl Iterator<Item = ObjectId> + use<> {
        self.state.frame.objects()
    }
    /// The name of an object, as in the layout.
    pub fn name(&self, id: ObjectId) -> &'v str {
        self.state.frame.name(id)
    }
    pub fn object(&self, name: &str) -> Option<ObjectId> {
        self.objects().find(|id| self.name(*id) == name)
    }
    /// Where an object is; `None` while it has no place.
    pub fn pose(&self, id: ObjectId) -> Option<Pose> {
        self.state.is_placed(id).then(|| self.state.pose(id))
    }
    /// Its full extents (metres).
    pub fn size(&self, id: ObjectId) -> Vec3 {
        self.state.pose(id).scale
    }
    /// Where a region is, and its full extents.
    pub fn region(&self, id: RegionId) -> Pose {
        self.state.region_pose(id)
    }
    /// Whether a proposal may move an object: neither the program nor a lock fixes all of it.
    pub fn is_movable(&self, id: ObjectId) -> bool {
        self.state.frame.is_movable(id)
    }
    /// Every stated constraint, in the order of the program, and how it stands.
    pub fn constraints(&self) -> Vec<Concern> {
        (0..self.program().constraints.len()).map(|index| self.stated(index)).collect()
    }
    /// Whatever must hold and does not: stated constraints in order, then physical rules.
    pub fn unsatisfied(&self) -> Vec<Concern> {
        let mut list: Vec<Concern> = self.constraints().into_iter().filter(|c| c.hard && !c.holds).collect();
        let physical = self.state.violated().into_iter().filter_map(|check| self.physical(check));
        list.extend(physical);
        list
    }

    fn stated(&self, index: usize) -> Concern {
        let constraint = &self.program().constraints[index];
        let truth = judge(&constraint.formula, self.world()).ok();
        Concern {
            what: TermSubject::Stated(index),
            hard: !matches!(constraint.kind, scenelang_lang::program::ConstraintKind::Prefer { .. }),
            holds: truth.is_some_and(|t| t.holds),
            margin: truth.map(|t| t.margin).filter(|m| m.is_finite()),
            objects: constraint.formula.objects(),
        }
    }

    pub(crate) fn concern(&self, check: usize) -> Concern {
        match self.state.numbering.check(check) {
            Check::Term(term) => {
                let term = &self.state.frame.terms[term];
                let truth = judge(&term.formula, self.world()).ok();
                Concern {
                    what: match term.opens {
                        Some(id) => TermSubject::Open(self.name(id).into(), None),
                        None => TermSubject::Stated(term.constraint),
                    },
                    hard: term.is_hard(),
                    holds: truth.is_some_and(|t| t.holds),
                    margin: truth.map(|t| t.margin).filter(|m| m.is_finite()),
                    objects: term.objects.clone(),
                }
            }
            _ => self.physical(check).expect("a check that is no term is a physical rule"),
        }
    }

    fn physical(&self, check: usize) -> Option<Concern> {
        let name = |id| self.name(id).into();
        let world = self.world();
        let (what, truth) = match self.state.numbering.check(check) {
            Check::Term(_) => return None,
            Check::Collide(a, b) => (TermSubject::Collision(name(a), name(b)), rules::collide::pair(world, a, b).ok()),
            Check::Bounds(a) => (TermSubject::Bounds(name(a)), rules::bounds::object(world, a).ok()),
            Check::Support(a) => (TermSubject::Support(name(a)), rules::support::object(world, a).ok()),
        };
        Some(Concern {
            what,
            hard: true,
            holds: self.state.does_hold(check),
            margin: truth.map(|t| t.margin).filter(|m| m.is_finite()),
            objects: self.state.objects_of(check),
        })
    }
}
