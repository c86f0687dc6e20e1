//! Explanations of what fails: the values on both sides, where the objects are, what pulls the other way, and the
//! smallest move that mends it, judged before it is offered.
//!
//! A check without violations comes here with nothing to do. Of many violations only the first few are explained in
//! full, and each within a budget that counts work, so that the same input gives the same words on any machine.
//!
//! Not here: solving. A move changes one or a few objects and leaves everything else where it is; where none is found,
//! the layout may still be mended in another way.

mod index;
mod measured;
mod moves;
mod places;
mod search;
mod stage;

pub(crate) use index::Index;
pub use measured::{Measured, Quantity};
pub(crate) use measured::{of_rule, of_statement};
pub use moves::{Mend, Step};
pub(crate) use places::row_in_words;
pub use places::{Place, facing_in_words, move_in_words};

use crate::check::{Judged, Subject, Verdict};
use crate::report::model::Kind;
use crate::tolerances::Options;
use crate::world::World;
use moves::Mender;
use scenelang_lang::program::{ObjectId, Program};
use scenelang_layout::Layout;

/// A row that costs more than this to judge is dear: it is tried less often.
const DEAR: usize = 100;
/// What judging dear rows may cost in all, in small comparisons, where not all must be explained however long that takes.
const PURSE: usize = 240_000;

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
    pub kind: Kind,
    /// What it is about.
    pub subject: Subject,
}

/// Why a row fails, and what would mend it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Explanation {
    /// The values on both sides of what decided.
    pub measured: Option<Measured>,
    /// The objects of the deciding instance, where they are.
    pub objects: Vec<Place>,
    /// What holds now and would fail, or come nearest to failing, under the smallest move that mends this row.
    pub opposing: Vec<RowRef>,
    /// The move offered.
    pub mend: Option<Mend>,
    /// Assignments that keep its objects from being moved, where all of them are kept.
    pub pinned: Vec<RowRef>,
    /// Whether a move was looked for.
    pub searched: bool,
}

impl Judged {
    /// Which row it is.
    pub(crate) fn row(&self) -> RowRef {
        RowRef { kind: self.kind, subject: self.subject }
    }
}

/// Completes the explanations of the first rows that fail.
pub(crate) fn complete(program: &Program, world: &World<f64>, verdict: &mut Verdict, how_many: Explain) {
    let failing = failing(verdict);
    let fails = |row: &&mut Judged| row.satisfied == Some(false);
    let (hard, soft): (Vec<_>, Vec<_>) =
        verdict.rows.iter_mut().filter(fails).partition(|row| row.kind != Kind::Prefer);
    let most = match how_many {
        Explain::All => usize::MAX,
        Explain::First(n) => n,
    };
    // What a guideline asks for is plain, and a room may fail many of them: moves are looked for on request only.
    let soft = soft.into_iter().filter(|row| how_many == Explain::All || row.guideline.is_none());
    let purse = if how_many == Explain::All { usize::MAX } else { PURSE };
    let mut mender: Option<Mender<'_>> = None;
    for row in hard.into_iter().chain(soft).take(most) {
        let mender = mender.get_or_insert_with(|| Mender::new(program, world, failing.clone(), purse));
        let explanation = row.explanation.get_or_insert_default();
        explanation.objects = row.objects.iter().filter_map(|id| Place::of(program, world, *id)).collect();
        if mender.is_spent() {
            continue;
        }
        let found = mender.explain(RowRef { kind: row.kind, subject: row.subject }, &row.objects);
        explanation.searched = found.searched;
        explanation.opposing = found.opposing;
        explanation.mend = found.mend;
        explanation.pinned = found.pinned;
    }
}

/// The smallest move after which `rows` of a verdict hold: what [`check`](crate::check()) offers for one of them. It may
/// break something; then [`Mend::breaks`] says so.
pub fn smallest_move(
    program: &Program,
    layout: &Layout,
    options: &Options,
    verdict: &Verdict,
    rows: &[RowRef],
) -> Option<Mend> {
    let world = World::new(program, layout, options);
    Mender::new(program, &world, failing(verdict), usize::MAX).mend(rows)
}

/// What must hold and does not.
fn failing(verdict: &Verdict) -> Vec<RowRef> {
    let fails = verdict.rows.iter().filter(|row| row.satisfied == Some(false) && row.kind != Kind::Prefer);
    fails.map(Judged::row).collect()
}

/// The name of an object.
fn name(program: &Program, id: ObjectId) -> &str {
    &program.objects[id.0 as usize].name
}
