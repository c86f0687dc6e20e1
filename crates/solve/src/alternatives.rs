//! Several layouts of one scene that differ in kind, not in centimetres.

use crate::pipeline::solve;
use crate::problem::{End, Options, Outcome, Placed, Problem, Progress};
use scenelang_engine::limit::Limit;
use scenelang_lang::program::RegionId;
use scenelang_layout::{Layout, Placement};
use std::ops::ControlFlow;

/// An object stands elsewhere if it is moved so far (metres) or turned so far (degrees).
const ELSEWHERE: (f64, f64) = (0.5, 40.0);
/// Two layouts differ in kind if this part of their objects stands elsewhere.
const DIFFERENT: f64 = 0.2;
/// How many layouts are looked at for each that is wanted.
const TRIES: u64 = 6;
/// What all of it may take, in budgets of one search.
const BUDGETS: u64 = 3;

/// Up to `wanted` layouts in which all that must hold does, each different in kind from those before it. Draws are those
/// of the seed in all of them. What has a place already keeps it in the first one; in the others only what is locked does.
/// Time and budget are those of all together. Where not even one is found, what comes closest.
pub fn alternatives(
    problem: &Problem<'_>,
    options: &Options,
    wanted: usize,
    progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Vec<Outcome> {
    let mut found: Vec<Outcome> = Vec::new();
    let mut closest: Option<Outcome> = None;
    let limit = Limit::new(options.time, &options.stop);
    let anew = Problem { placed: anew(problem, options), ..problem.clone() };
    let most = BUDGETS * options.budgeted(problem.program.objects.len()).budget;
    let mut work = 0;
    for variant in 0..TRIES * wanted as u64 {
        let first = variant == 0;
        let options = Options {
            variant: options.variant + variant,
            time: limit.left(),
            diagnose: options.diagnose && first,
            ..options.clone()
        };
        let next = solve(if first { problem } else { &anew }, &options, progress);
        work += next.work;
        let asked = next.end == End::Asked || limit.is_over() || work >= most;
        if next.converged {
            if found.iter().all(|other| differ(&other.layout, &next.layout)) {
                found.push(next);
            }
        } else if closest.as_ref().is_none_or(|c| next.unsatisfied.len() < c.unsatisfied.len()) {
            closest = Some(next);
        }
        // What cannot be solved once is not tried again and again.
        if asked || found.len() == wanted || found.is_empty() && variant > 0 {
            break;
        }
    }
    if found.is_empty() { closest.into_iter().collect() } else { found }
}

/// What keeps its place in layouts that are to differ: what must, and the regions.
fn anew(problem: &Problem<'_>, options: &Options) -> Placed {
    if problem.placed == Placed::None {
        return Placed::None;
    }
    let regions = (0..problem.program.regions.len() as u32).map(RegionId);
    Placed::Some {
        objects: options.locked.iter().copied().filter(|id| problem.placed.object(*id)).collect(),
        regions: regions.filter(|id| problem.placed.region(*id)).collect(),
    }
}

/// Whether two layouts of the same objects differ in kind.
fn differ(a: &Layout, b: &Layout) -> bool {
    let elsewhere = |p: &Placement, q: &Placement| {
        let turn = (p.rot.y - q.rot.y).rem_euclid(360.0);
        (p.pos - q.pos).norm() > ELSEWHERE.0 || turn.min(360.0 - turn) > ELSEWHERE.1
    };
    let count = a.objects.iter().zip(&b.objects).filter(|((_, p), (_, q))| elsewhere(p, q)).count();
    count as f64 >= (DIFFERENT * a.objects.len() as f64).max(1.0)
}
