//! Moves that repair: what `check` offers for the same rows, else what the local search finds, of which no more is taken
//! than is needed.

use super::judge::Judge;
use super::room::{self, Fixtures, RepairSearch, describe};
use super::{Alternative, RepairOptions, least, whole};
use crate::problem::pose::Pose;
use crate::search::Snapshot;
use scenelang_engine::candidate::Change;
use scenelang_engine::moves_for;
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Layout, Vec3};
use scenelang_verify::explain::{RowRef, SmallestMove};

/// What `check` offers for the same rows, as far as that repairs them all and breaks no demand.
pub(super) fn offered(judge: &Judge<'_>) -> Vec<Alternative> {
    let moves = moves_for(judge.program, judge.layout, &judge.options, &judge.verdict, &judge.targets, &judge.locked);
    moves.iter().filter_map(|repair| made(judge, repair)).collect()
}

/// Layouts in which some rows hold after a move that breaks nothing, whether or not the others do.
pub(super) fn reachable(judge: &Judge<'_>, rows: &[RowRef]) -> Vec<Layout> {
    let moves = moves_for(judge.program, judge.layout, &judge.options, &judge.verdict, rows, &judge.locked);
    moves.iter().filter(|repair| repair.breaks.is_empty()).filter_map(|repair| moved(judge, repair)).collect()
}

/// What a move makes of the layout, if that repairs.
fn made(judge: &Judge<'_>, repair: &SmallestMove) -> Option<Alternative> {
    let layout = moved(judge, repair)?;
    let broken = judge.judge(&layout)?;
    let mut alternative = describe(judge, layout, &broken);
    for moved in &mut alternative.moves {
        moved.with = repair.steps.iter().find(|s| s.object == moved.object).and_then(|s| s.with);
    }
    Some(alternative)
}

/// The layout after a move.
fn moved(judge: &Judge<'_>, repair: &SmallestMove) -> Option<Layout> {
    let mut layout = judge.layout.clone();
    for step in &repair.steps {
        let name = &judge.program.objects[step.object.0 as usize].name;
        let (_, placement) = layout.objects.iter_mut().find(|(n, _)| n == name)?;
        placement.pos += Vec3::from(step.by);
        if step.turn != 0.0 {
            placement.rot.y = (placement.rot.y + step.turn).rem_euclid(360.0);
        }
    }
    Some(layout)
}

/// All that was found; the best first. With `careless`, preferences may break. Doors and windows move only where nothing
/// else helps, and what fails speaks of them.
pub(super) fn all(judge: &Judge<'_>, options: &RepairOptions, careless: bool) -> Vec<Alternative> {
    let Some(holding) = judge.holding_fittings() else { return searched(judge, options, careless) };
    let held = searched(&holding, options, careless);
    let about = |id: &ObjectId| holding.locked.contains(id) && !judge.locked.contains(id);
    let fails = judge.verdict.rows.iter().filter(|judged| judge.targets.contains(&judged.row()));
    if held.is_empty() && fails.flat_map(|judged| &judged.objects).any(about) {
        return searched(judge, options, careless);
    }
    held
}

fn searched(judge: &Judge<'_>, options: &RepairOptions, careless: bool) -> Vec<Alternative> {
    let solver = room::solver(options);
    let fixtures = Fixtures::new(judge);
    let mut room = RepairSearch::new(judge, &fixtures, &solver, careless);
    let mut found: Vec<Alternative> = Vec::new();
    if room.missing().is_empty() {
        // The rules of the program have put everything where it belongs.
        let solutions = vec![room.search.snapshot()];
        gather(&mut room, solutions, &mut found);
    }
    if found.is_empty() {
        let solutions = whole::search(&mut room, options);
        gather(&mut room, solutions, &mut found);
    }
    found.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    found.truncate(options.alternatives);
    found
}

/// Takes of each solution what is needed, and adds it to what was found if it repairs.
fn gather(room: &mut RepairSearch<'_, '_>, solutions: Vec<Snapshot>, found: &mut Vec<Alternative>) {
    for snapshot in solutions {
        room.search.restore(&snapshot);
        least::shrink(room);
        let Some(alternative) = room.alternative() else { continue };
        let objects = |a: &Alternative| a.moves.iter().map(|m| m.object).collect::<Vec<_>>();
        // Of moves of the same objects the smallest is enough.
        match found.iter_mut().find(|a| objects(a) == objects(&alternative)) {
            Some(known) if known.cost > alternative.cost => *known = alternative,
            Some(_) => {}
            None => found.push(alternative),
        }
    }
}

/// The changes that bring objects to poses.
pub(super) fn changes(to: &[(ObjectId, Pose)]) -> Vec<Change> {
    to.iter().map(|(id, pose)| Change::Object(*id, *pose)).collect()
}
