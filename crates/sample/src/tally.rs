//! What was tried and what came of it, as counts: kinds of moves, and which statements and rules refused how many of them.

use scenelang_engine::frame::Frame;
use scenelang_engine::frame::checks::{Check, Numbering};
use scenelang_lang::Program;
use serde::{Deserialize, Serialize};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MoveKind {
    /// A step aside, of any size.
    Step,
    /// A turn of any size.
    Turn,
    /// A quarter turn, or two.
    Quarter,
    /// To anywhere that things of its kind can be.
    Place,
    /// To another place along the walls.
    Wall,
    /// Up or down.
    Lift,
    /// Two things change places.
    Swap,
    /// Two things at once to anywhere.
    Pair,
}

/// All kinds, with how often each is tried, and what it is called.
pub const KINDS: [(MoveKind, f64, &str); 8] = [
    (MoveKind::Step, 0.32, "step"),
    (MoveKind::Turn, 0.12, "turn"),
    (MoveKind::Quarter, 0.08, "quarterTurn"),
    (MoveKind::Place, 0.2, "anywhere"),
    (MoveKind::Wall, 0.12, "alongWalls"),
    (MoveKind::Lift, 0.04, "lift"),
    (MoveKind::Swap, 0.06, "swap"),
    (MoveKind::Pair, 0.06, "pairAnywhere"),
];

/// The physical rules that can refuse a move, after the statements.
pub const RULES: [&str; 4] = ["P-COLLIDE", "P-BOUNDS", "P-SUPPORT", "P-OPEN"];

/// Counts of one sample, or of many.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tally {
    /// By kind of move: tried, and taken.
    pub moves: [[u64; 2]; KINDS.len()],
    /// Layouts drawn as a whole: tried, and taken.
    pub whole: [u64; 2],
    /// Runs of moves after which ways over the floor were looked for, and those that left them free.
    pub ways: [u64; 2],
    /// By constraint of the program, then by rule as in [`RULES`]: how many moves each refused first.
    pub refused: Vec<u64>,
}

impl Tally {
    pub fn new(program: &Program) -> Self {
        Self { refused: vec![0; program.constraints.len() + RULES.len()], ..Self::default() }
    }

    /// Counts a move.
    pub fn tried(&mut self, kind: MoveKind, taken: bool) {
        let at = KINDS.iter().position(|(k, ..)| *k == kind).expect("the table has all kinds");
        self.moves[at][0] += 1;
        self.moves[at][1] += u64::from(taken);
    }

    /// Counts what refused one.
    pub fn refused(&mut self, frame: &Frame<'_>, numbering: Numbering, check: usize) {
        let rules = frame.program.constraints.len();
        let at = match numbering.check(check) {
            Check::Term(t) if frame.terms[t].opens.is_some() => rules + 3,
            Check::Term(t) => frame.terms[t].constraint,
            Check::Collide(..) => rules,
            Check::Bounds(_) => rules + 1,
            Check::Support(_) => rules + 2,
        };
        self.refused[at] += 1;
    }

    /// Adds those of another sample of the same program.
    pub fn add(&mut self, other: &Self) {
        let pairs = self.moves.iter_mut().zip(&other.moves);
        for (own, theirs) in pairs.chain([(&mut self.whole, &other.whole), (&mut self.ways, &other.ways)]) {
            own[0] += theirs[0];
            own[1] += theirs[1];
        }
        self.refused.resize(self.refused.len().max(other.refused.len()), 0);
        self.refused.iter_mut().zip(&other.refused).for_each(|(own, theirs)| *own += theirs);
    }
}
