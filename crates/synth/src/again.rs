//! Solving again, after a small edit: the layout to start from with the fewest moves after which all holds.

use scenelang_lang::Program;
use scenelang_lang::program::ObjectId;
use scenelang_layout::Layout;
use scenelang_solve::repair::{Damaged, How, RepairOptions, Which, repair};
use scenelang_solve::{Options, Placed};

/// Work for it: little beside that of a search. What it takes more for is no small edit.
const WORK: u64 = 20_000_000;

/// A layout in which all that must hold does, few moves away from one in which not all does; `None`: that one is fine, or
/// something has no place in it, or no few moves were found that leave alone what is locked.
pub fn mended(program: &Program, layout: &Layout, placed: &Placed, options: &Options) -> Option<Layout> {
    let objects = (0..program.objects.len() as u32).map(ObjectId);
    if *placed == Placed::None || !objects.into_iter().all(|id| placed.object(id)) {
        return None;
    }
    let how = RepairOptions {
        budget: WORK,
        time: options.time.map(|time| time / 2),
        stop: options.stop.clone(),
        alternatives: 1,
        judge: options.judge,
    };
    let found = repair(&Damaged { program, layout, text: None }, &Which::All, &how).ok()?;
    let best = found.alternatives.into_iter().find(|a| a.how == How::Moves)?;
    let free = best.moves.iter().all(|m| !options.locked.contains(&m.object));
    free.then_some(best.layout)
}
