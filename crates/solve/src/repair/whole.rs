//! Local searches from the layout as it is, with everything free to move; then new solutions. What they find is taken over as
//! far as it takes. Many objects may have moved then, so what was found is only a beginning.

use super::RepairOptions;
use super::moves::changes;
use super::room::RepairSearch;
use crate::pipeline::solve;
use crate::problem::pose::Pose;
use crate::problem::{Options, Placed, Problem};
use crate::search::Snapshot;
use scenelang_engine::candidate::Change;
use scenelang_engine::frame::Frame;
use scenelang_lang::program::{ObjectId, RegionId};
use std::ops::ControlFlow;

/// The part of the budget that a search from the layout may take, and that of a new solution.
const PARTS: [f64; 2] = [0.1, 0.15];
/// The part of the budget of a search that may go into preferences, where one is to be repaired.
const POLISH: f64 = 0.5;
/// So many searches, each with random numbers of its own, begin at the layout; so many, if they find nothing.
const FROM_HERE: u64 = 12;
const FRUITLESS: u64 = 4;
/// So many new solutions are looked for where those find nothing: for what must hold, and where a preference is to be repaired.
const ANEW: [u64; 2] = [2, 4];

/// Layouts in which nothing is missing.
pub(super) fn search(room: &mut RepairSearch<'_, '_>, options: &RepairOptions) -> Vec<Snapshot> {
    let [here, anew] = PARTS.map(|part| (options.budget as f64 * part) as u64);
    let mut found: Vec<Snapshot> = Vec::new();
    let mut left = options.budget;
    for variant in 0..FROM_HERE {
        // Where each look is dear, the first that is found is enough.
        let enough = if found.is_empty() { variant >= FRUITLESS } else { room.dear || left < here };
        if enough || room.judge.limit.is_over() {
            break;
        }
        let (snapshot, work) = solved(room, options, Placed::All, here, variant);
        found.extend(snapshot);
        left = left.saturating_sub(work);
    }
    if found.is_empty() {
        let regions: Vec<RegionId> = (0..room.judge.program.regions.len() as u32).map(RegionId).collect();
        let placed = || Placed::Some { objects: room.judge.locked.clone(), regions: regions.clone() };
        let preferred = room.missing().iter().any(|&check| !room.search.state.is_hard(check));
        let mut tries = (0..ANEW[usize::from(preferred)]).take_while(|_| !room.judge.limit.is_over());
        found.extend(tries.find_map(|variant| solved(room, options, placed(), anew, variant).0));
    }
    found
}

/// A solution, of which only that is taken over which must be, and the work that it took.
fn solved(
    room: &mut RepairSearch<'_, '_>,
    options: &RepairOptions,
    placed: Placed,
    budget: u64,
    variant: u64,
) -> (Option<Snapshot>, u64) {
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
        locked: judge.locked.clone(),
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
            return (Some(room.search.snapshot()), outcome.work);
        }
        let mut next: Vec<ObjectId> = Vec::new();
        for check in missing {
            next.extend(room.search.state.objects_of(check).into_iter().filter(|id| !settled[id.0 as usize]));
        }
        if next.is_empty() {
            next.extend(frame.objects().filter(|id| !settled[id.0 as usize]));
        }
        if next.is_empty() {
            return (None, outcome.work);
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
