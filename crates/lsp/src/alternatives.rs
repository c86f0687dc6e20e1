//! Several layouts of a program to choose from: each with its plan as a picture, and the seed that makes it again.

use crate::commands::{Hold, Watch, count};
use crate::dispatch::Fault;
use crate::jobs::Job;
use crate::picture::Picture;
use crate::refuted::{Sought, unless_refuted};
use scenelang_layout::file as layout_file;
use scenelang_synth::{Arranging, arrange, too_large};
use serde::Serialize;

/// So many are made.
const COUNT: u64 = 4;

/// What `scenelang.alternatives` answers.
#[derive(Serialize)]
pub struct Alternatives {
    /// Those in which most holds first.
    alternatives: Vec<Alternative>,
}

#[derive(Serialize)]
struct Alternative {
    /// With it, `scenelang.solveAnew` finds the layout again.
    seed: u64,
    /// How many constraints hold, of how many.
    holds: usize,
    total: usize,
    /// An SVG image; null: a part of the room cannot be drawn.
    plan: Option<String>,
}

/// Layouts of the seeds from `first`, in which what is held stays where it is.
///
/// # Errors
/// The program is too large, no layout satisfies it, what is to stay is not there, or nobody waits any more.
pub fn alternatives(job: &Job, first: u64, hold: &Hold) -> Result<Alternatives, Fault> {
    let program = &job.compiled.program;
    if let Some(finding) = too_large(program) {
        return Err(Fault::Failed(finding.message));
    }
    let (kept, locked) = hold.anew(job)?;
    let mut found: Vec<Alternative> = unless_refuted(job, kept.as_ref(), |stop| {
        let mut found = Vec::new();
        for i in 0..COUNT {
            job.progress.say(&format!("layout {} of {COUNT}", i + 1));
            let how = Arranging {
                previous: kept.as_ref(),
                locked: locked.clone(),
                seed: first.wrapping_add(i),
                judge: job.judging.options,
                stop: stop.clone(),
                ..Arranging::default()
            };
            match one(job, how) {
                Ok(one) => found.push(one),
                Err(fault) => return Sought::failed(fault),
            }
        }
        // One layout in which all holds is proof enough that there is one.
        let converged = found.iter().any(|one| one.holds == one.total);
        Sought { result: Ok(found), converged }
    })?;
    found.sort_by_key(|one| one.total - one.holds);
    Ok(Alternatives { alternatives: found })
}

/// The layout of one seed.
fn one(job: &Job, how: Arranging<'_>) -> Result<Alternative, Fault> {
    let (program, seed) = (&job.compiled.program, how.seed);
    let arranged = arrange(program, how, None, &mut Watch(job)).ok_or(Fault::Cancelled)?;
    let mut layout = arranged.outcome.layout;
    layout.seed = Some(seed);
    let verdict = job.verdict(&layout, 0);
    let [holds, total] = count(&verdict);
    let picture = Picture {
        path: &job.path,
        program,
        sources: &job.sources,
        about: job.main,
        layout_file: job.layout.as_ref().map(|l| l.file),
        layout: &layout,
        text: &layout_file::to_json(&layout, None),
        verdict: &verdict,
        options: &job.judging.options,
        looks: &job.looks,
    };
    let plan = picture.plan()?;
    Ok(Alternative { seed, holds, total, plan })
}
