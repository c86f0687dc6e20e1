//! Explanations of what fails, as values and in words: both sides of what decided, where the objects are, what pulls the
//! other way, and a move that repairs it.
//!
//! Not here: looking for that move, which takes a layout that changes (`engine`).

mod measured;
mod places;

pub use measured::{Measured, Quantity};
pub(crate) use measured::{of_rule, of_statement};
pub(crate) use places::row_in_words;
pub use places::{ObjectPlace, facing_in_words, move_in_words};

use crate::check::Subject;
use crate::report::model::RowKind;
use scenelang_lang::program::{ObjectId, Program};

/// How many violations are explained in full; the others say what was measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Explain {
    /// All of them, however long that takes.
    All,
    /// The first so many, hard ones before preferences.
    First(usize),
}

impl Default for Explain {
    fn default() -> Self {
        Self::First(20)
    }
}

/// A row, listed or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RowRef {
    /// What kind of constraint.
    pub kind: RowKind,
    /// What it is about.
    pub subject: Subject,
}

/// Why a row fails, and what would repair it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Explanation {
    /// The values on both sides of what decided.
    pub measured: Option<Measured>,
    /// The objects of the deciding instance, where they are.
    pub objects: Vec<ObjectPlace>,
    /// What holds now and would fail, or come nearest to failing, under the smallest move that repairs this row.
    pub opposing: Vec<RowRef>,
    /// The move offered.
    pub repair: Option<SmallestMove>,
    /// Moves that repair it and break nothing, of different objects or in different ways, the best first. The first is the
    /// move offered, if that breaks nothing.
    pub choices: Vec<SmallestMove>,
    /// Assignments that keep its objects from being moved, where all of them are kept.
    pub pinned: Vec<RowRef>,
    /// Whether a move was looked for.
    pub searched: bool,
}

/// A move that repairs a row.
#[derive(Clone, Debug, PartialEq)]
pub struct SmallestMove {
    /// What is moved, in this order; usually one object.
    pub steps: Vec<ObjectMove>,
    /// What holds in the layout and fails after the move.
    pub breaks: Vec<RowRef>,
    /// What fails in the layout and holds after the move, beside the row itself.
    pub repairs: Vec<RowRef>,
}

/// A move of one object from where the layout has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectMove {
    pub object: ObjectId,
    /// Along x, y, z (metres).
    pub by: [f64; 3],
    /// Added to its `rot.y` (degrees).
    pub turn: f64,
    /// The object that it goes along with, because it rests on it.
    pub with: Option<ObjectId>,
}

fn name(program: &Program, id: ObjectId) -> &str {
    &program.objects[id.0 as usize].name
}
