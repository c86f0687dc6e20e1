//! The wider circles: a search from the layout as it is, with everything free to move; then a new solution. Either is taken
//! over as far as it takes. Many objects may have moved then, so what was found is only a beginning.

use super::RepairOptions;
use super::moves::changes;
use super::room::Room;
use crate::pipeline::solve;
use crate::problem::frame::Frame;
use crate::problem::pose::Pose;
use crate::problem::{Options, Placed, Problem};
use crate::search::Snapshot;
use crate::search::state::Change;
use scenelang_lang::program::{ObjectId, RegionId};
use std::ops::ControlFlow;

/// The part of the budget for a search from the layout as it is.
const PART: f64 = 0.6;
/// The part of the budget of a new solution that may go into preferences.
const POLISH: f64 = 0.5;
/// So many new solutions are looked for where a preference is to be repaired.
const TRIES: u64 = 4;
/// Layouts in which nothing is missing.
pub(super) fn search(room: &mut Room<'_, '_>, options: &RepairOptions) -> Vec<Snapshot> {
    let work = (options.budget as f64 * PART) as u64;
    let found = solved(room, options, Placed::All, work, 0);
    let another = |room: &mut Room<'_, '_>| {
        // Other random numbers may end where this layout can be taken to, and the first ones did not.
        let preferred = room.missing().iter().any(|&check| !room.search.state.is_hard(check));
        let tries = if preferred { TRIES } else { 1 };
        let mut tries = (0..tries).take_while(|_| !room.judge.limit.is_over());
        tries.find_map(|variant| {
            let regions = (0..room.judge.program.regions.len() as u32).map(RegionId).collect();
            let anew = Placed::Some { objects: Vec::new(), regions };
            let left = options.budget.saturating_sub(room.search.state.work);
            solved(room, options, anew, left, variant)
        })
    };
    found.or_else(|| another(room)).into_iter().collect()
}

/// A new solution, of which only that is taken over which must be.
fn solved(
    room: &mut Room<'_, '_>,
    options: &RepairOptions,
    placed: Placed,
    budget: u64,
    variant: u64,
) -> Option<Snapshot> {
    let judge = room.judge;
    let problem = Problem { program: judge.program, start: judge.layout.clone(), placed };
    // A solution owes preferences nothing: where one is to be repaired, work goes into them as well.
    let preferred = room.missing().iter().any(|&check| !room.search.state.is_hard(check));
    let solver = Options {
        seed: judge.layout.seed.unwrap_or(0),
        variant,
        budget,
        judge: judge.options,
        polish: if preferred { POLISH } else { 0.0 },
        diagnose: false,
        time: judge.limit.left(),
        stop: options.stop.clone(),
        ..Options::default()
    };
    let outcome = solve(&problem, &solver, &mut |_| ControlFlow::Continue(()));
    let frame: &Frame<'_> = room.search.state.frame;
    let goal: Vec<Pose> = frame
        .objects()
        .map(|id| {
            let here = room.poses[id.0 as usize];
            let there = outcome.layout.object(frame.name(id));
            there.map_or(here, |p| Pose { pos: p.pos, rot: p.rot, scale: here.scale })
        })
        .collect();
    let start = room.start.clone();
    room.search.restore(&start);
    // What something missing points at takes its new place, until nothing is missing.
    let mut settled = vec![false; goal.len()];
    loop {
        let missing = room.missing();
        if missing.is_empty() {
            return Some(room.search.snapshot());
        }
        let mut next: Vec<ObjectId> = Vec::new();
        for check in missing {
            next.extend(room.search.state.objects_of(check).into_iter().filter(|id| !settled[id.0 as usize]));
        }
        if next.is_empty() {
            next.extend(frame.objects().filter(|id| !settled[id.0 as usize]));
        }
        if next.is_empty() {
            return None;
        }
        next.sort_unstable();
        next.dedup();
        next.iter().for_each(|id| settled[id.0 as usize] = true);
        let to: Vec<(ObjectId, Pose)> = next.iter().map(|id| (*id, goal[id.0 as usize])).collect();
        let moves: Vec<Change> = changes(&to);
        if room.search.state.attempt(&moves, f64::INFINITY).is_some() {
            room.search.state.keep();
        }
    }
}
