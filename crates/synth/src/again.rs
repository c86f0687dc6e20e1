//! Solving again, after a small edit: the layout to start from with the fewest moves after which all holds.

use scenelang_lang::Program;
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Layout, Placement};
use scenelang_solve::repair::{Damaged, How, RepairOptions, Which, repair};
use scenelang_solve::{Options, Placed};

/// Work for it: little beside that of a search. What it takes more for is no small edit.
const WORK: u64 = 20_000_000;

/// Where so few objects move, the solver is not asked whether fewer would do.
pub const FEW: usize = 2;
/// What has moved by less is where it was (metres, degrees).
const SAME: f64 = 1e-6;

/// A layout, and how many objects moved for it.
pub struct Repaired {
    /// Where everything is.
    pub layout: Layout,
    /// How many objects moved.
    pub moved: usize,
}

/// A layout in which all that must hold does, few moves away from one in which not all does; `None`: that one is fine, or
/// something has no place in it, or no few moves were found that leave alone what is locked.
pub fn repaired(program: &Program, layout: &Layout, placed: &Placed, options: &Options) -> Option<Repaired> {
    let objects = (0..program.objects.len() as u32).map(ObjectId);
    if *placed == Placed::None || !objects.into_iter().all(|id| placed.object(id)) {
        return None;
    }
    let how = RepairOptions {
        budget: WORK,
        time: options.time.map(|time| time / 2),
        stop: options.stop.clone(),
        locked: options.locked.clone(),
        alternatives: 1,
        judge: options.judge,
    };
    let found = repair(&Damaged { program, layout, text: None }, &Which::All, &how).ok()?;
    let best = found.alternatives.into_iter().find(|a| a.how == How::Moves)?;
    let moved = moved(layout, &best.layout);
    Some(Repaired { layout: best.layout, moved })
}

/// How many objects are not where they were.
pub fn moved(before: &Layout, after: &Layout) -> usize {
    let stays = |name: &str, old: &Placement| {
        after.object(name).is_some_and(|new| (new.pos - old.pos).norm() < SAME && (new.rot - old.rot).norm() < SAME)
    };
    before.objects.iter().filter(|(name, old)| !stays(name, old)).count()
}
