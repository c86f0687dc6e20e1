//! A layout judged, and for the first rows that fail a move that repairs them. It has been judged before it is offered.
//!
//! A check without violations comes here with nothing to do. Of many violations only the first few are explained in
//! full, and each within a budget that counts work, so that the same input gives the same words on any machine.
//!
//! Not here: solving. A move changes one or a few objects and leaves everything else where it is; where none is found,
//! the layout may still be repaired in another way.

use crate::moves::MoveFinder;
use scenelang_base::codes;
use scenelang_lang::program::{ObjectId, Program};
use scenelang_layout::{Layout, Places};
use scenelang_verify::check::{Judged, judged};
use scenelang_verify::explain::{ObjectPlace, RowRef, SmallestMove};
use scenelang_verify::report::model::RowKind;
use scenelang_verify::{CheckVerdict, Explain, Options, World};

/// What judging dear rows may cost in all, in small comparisons, where not all must be explained however long that takes.
const PURSE: usize = 240_000;

/// What [`scenelang_verify::check`] says, with the moves that repair what fails, as far as the options ask for them.
pub fn check(program: &Program, layout: &Layout, options: &Options) -> CheckVerdict {
    check_at(program, layout, None, options, &[])
}

/// The same; `places` says where the values of the layout stand, and no move that is offered moves what is `locked`.
pub(crate) fn check_at(
    program: &Program,
    layout: &Layout,
    places: Option<&Places>,
    options: &Options,
    locked: &[ObjectId],
) -> CheckVerdict {
    let (mut verdict, world) = judged(program, layout, places, options);
    // Whoever could not be judged among so many cannot be moved among them either.
    let explain = if too_dense(&verdict) { Explain::First(0) } else { options.detail.explain };
    complete(program, world, &mut verdict, explain, locked);
    verdict
}

/// Completes the explanations of the first rows that fail.
fn complete(program: &Program, world: World<f64>, verdict: &mut CheckVerdict, how_many: Explain, locked: &[ObjectId]) {
    let failing = failing(verdict);
    let fails = |row: &&mut Judged| row.satisfied == Some(false);
    let (hard, soft): (Vec<_>, Vec<_>) =
        verdict.rows.iter_mut().filter(fails).partition(|row| row.kind != RowKind::Prefer);
    // What a guideline asks for is plain, and a room may fail many of them: moves are looked for on request only.
    let soft = soft.into_iter().filter(|row| how_many == Explain::All || row.guideline.is_none());
    let (most, purse) = match how_many {
        Explain::All => (usize::MAX, usize::MAX),
        Explain::First(n) => (n, PURSE),
    };
    let mut rows = hard.into_iter().chain(soft).take(most).peekable();
    if rows.peek().is_none() {
        return;
    }
    let mut finder = MoveFinder::new(program, world, failing, purse).locking(locked);
    for row in rows {
        let explanation = row.explanation.get_or_insert_default();
        let objects = row.objects.iter();
        explanation.objects = objects.filter_map(|id| ObjectPlace::of(program, finder.layout(), *id)).collect();
        if finder.is_spent() {
            continue;
        }
        let found = finder.explain(RowRef { kind: row.kind, subject: row.subject }, &row.objects);
        explanation.searched = found.searched;
        explanation.opposing = found.opposing;
        explanation.repair = found.choices.first().cloned();
        explanation.choices = found.choices;
        explanation.choices.retain(|choice| choice.breaks.is_empty());
        explanation.pinned = found.pinned;
    }
}

/// Moves after which `rows` of a verdict hold, the best first: what [`check`] offers for one of them. The first may break
/// something; then [`SmallestMove::breaks`] says so, and there is no other. What is `locked` stays where it is.
pub fn moves_for(
    program: &Program,
    layout: &Layout,
    options: &Options,
    verdict: &CheckVerdict,
    rows: &[RowRef],
    locked: &[ObjectId],
) -> Vec<SmallestMove> {
    if too_dense(verdict) {
        return Vec::new();
    }
    let world = World::new(program, layout, options);
    MoveFinder::new(program, world, failing(verdict), usize::MAX).locking(locked).choices(rows)
}

/// Whether so much is in one place that not all of it was judged.
fn too_dense(verdict: &CheckVerdict) -> bool {
    verdict.diagnostics.iter().any(|d| d.code == codes::E0005)
}

/// What must hold and does not.
fn failing(verdict: &CheckVerdict) -> Vec<RowRef> {
    let fails = verdict.rows.iter().filter(|row| row.satisfied == Some(false) && row.kind != RowKind::Prefer);
    fails.map(Judged::row).collect()
}
