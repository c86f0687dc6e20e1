//! What a built-in declares about itself, for those who treat all of them alike: the search, the proofs, reports.

use crate::tolerances::Tolerances;
use scenelang_base::Code;
use scenelang_lang::program::{Arg, Formula, Node, ObjectId, ObjectSide, Unit};

/// A tolerance that is part of a margin; `None`: there is none.
pub type Slack = Option<fn(&Tolerances) -> f64>;

/// What a built-in declares about itself.
#[derive(Clone, Copy, Debug)]
pub struct Declared {
    /// Unit of what it measures.
    pub unit: Unit,
    /// The tolerance that is part of its margin where it is to hold. At that margin it holds comfortably: nothing of the
    /// tolerance is used.
    pub wanted: Slack,
    /// The same where it is not to hold.
    pub unwanted: Slack,
    /// Whether its value may be infinite.
    pub may_be_infinite: bool,
    /// The code of an assertion that fails because this holds; `None`: that of all assertions.
    pub violation: Option<Code>,
}

/// What a use of a built-in looks at beside its arguments: moving anything there may change it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surroundings {
    /// Nothing: its arguments decide alone.
    Nothing,
    /// The space on a side of an object, and the walls around it.
    Space {
        /// Whose.
        owner: ObjectId,
        side: ObjectSide,
        /// How deep it is (metres); `None`: that is no constant.
        depth: Option<f64>,
    },
    /// The space that the movable parts of an object go through, and what they reach.
    Swing {
        /// Whose.
        owner: ObjectId,
    },
    /// The line between the centres of two objects.
    Sight {
        /// From here.
        from: ObjectId,
        /// To there.
        to: ObjectId,
    },
    /// The paths over the floor between two objects. They take a search, which costs thousands of times more than
    /// anything else.
    Path {
        /// From here.
        from: ObjectId,
        /// To there.
        to: ObjectId,
        /// How wide they are (metres); `None`: that is no constant.
        width: Option<f64>,
    },
}

/// What a floor costs on which paths are searched, in comparisons: at least, and per object on it.
const FLOOR: usize = 250;
const FLOOR_PER_OBJECT: usize = 25;
/// What each path on it costs.
const PATH: usize = 60;
/// What trying the movable parts of an object costs.
const SWING: usize = 60;

impl Surroundings {
    /// Whether there are any, so that moving any object may change what is measured.
    pub fn is_something(&self) -> bool {
        *self != Self::Nothing
    }
    /// Whether paths over the floor are asked for.
    pub fn is_path(&self) -> bool {
        matches!(self, Self::Path { .. })
    }
    /// What looking at all of these costs in a program of so many objects, in units of a small comparison.
    pub fn cost(all: impl Iterator<Item = Self>, objects: usize) -> usize {
        let (mut paths, mut looks, mut swings) = (0, 0, 0);
        for one in all {
            match one {
                Self::Nothing => {}
                Self::Space { .. } | Self::Sight { .. } => looks += 1,
                Self::Swing { .. } => swings += 1,
                Self::Path { .. } => paths += 1,
            }
        }
        // The floor is made ready once for all paths on it.
        let floor = if paths > 0 { FLOOR.max(FLOOR_PER_OBJECT * objects) } else { 0 };
        floor + paths * PATH + looks * objects / 8 + swings * (SWING + objects / 8)
    }
}

/// The arguments of a built-in in a formula that is not evaluated.
pub(crate) struct Given<'a> {
    pub formula: &'a Formula,
    pub args: &'a [Arg],
}

impl Given<'_> {
    #[track_caller]
    fn ill_typed(&self) -> ! {
        unreachable!("a built-in with arguments of the wrong types: {:?}", self.args)
    }
    pub fn object(&self, index: usize) -> ObjectId {
        match self.args.get(index) {
            Some(Arg::Object(id)) => *id,
            _ => self.ill_typed(),
        }
    }
    pub fn side(&self, index: usize) -> ObjectSide {
        match self.args.get(index) {
            Some(Arg::Side(side)) => *side,
            _ => self.ill_typed(),
        }
    }
    /// The number at an index, if it is a constant.
    pub fn constant(&self, index: usize) -> Option<f64> {
        match self.args.get(index) {
            Some(Arg::Value(node)) => match self.formula.node(*node) {
                Node::Number(n) => Some(*n),
                _ => None,
            },
            _ => self.ill_typed(),
        }
    }
}
