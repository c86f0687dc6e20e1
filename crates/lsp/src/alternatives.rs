//! Several layouts of a program to choose from: each with its plan as a picture, and the seed that makes it again.

use crate::commands::{Watch, count};
use crate::dispatch::Fault;
use crate::jobs::Job;
use scenelang_base::FileId;
use scenelang_export::{Scene, SceneInput, plan};
use scenelang_layout::{Layout, file as layout_file};
use scenelang_synth::{Arranging, arrange, too_large};
use scenelang_verify::{Verdict, report};
use serde_json::{Value, json};

/// So many are made.
const COUNT: u64 = 4;

/// Layouts of the seeds from `first`, those in which most holds first: `{seed, holds, total, plan}`.
///
/// # Errors
/// The program is too large, or nobody waits any more.
pub fn alternatives(job: &Job, first: u64) -> Result<Value, Fault> {
    let program = &job.compiled.program;
    if let Some(finding) = too_large(program) {
        return Err(Fault::Failed(finding.message));
    }
    let mut found: Vec<(usize, Value)> = Vec::new();
    for i in 0..COUNT {
        job.progress.say(&format!("layout {} of {COUNT}", i + 1));
        let seed = first.wrapping_add(i);
        let how = Arranging { seed, judge: job.judging.options, stop: job.stop.clone(), ..Arranging::default() };
        let arranged = arrange(program, how, None, &mut Watch(job)).ok_or(Fault::Cancelled)?;
        let mut layout = arranged.outcome.layout;
        layout.seed = Some(seed);
        let verdict = job.verdict(&layout, 0);
        let [holds, total] = count(&verdict);
        let plan = picture(job, &layout, &verdict)?;
        found.push((total - holds, json!({ "seed": seed, "holds": holds, "total": total, "plan": plan })));
    }
    found.sort_by_key(|(open, _)| *open);
    Ok(json!({ "alternatives": found.into_iter().map(|(_, one)| one).collect::<Vec<_>>() }))
}

/// The plan of a layout (SVG); null: it cannot be drawn.
fn picture(job: &Job, layout: &Layout, verdict: &Verdict) -> Result<Option<String>, Fault> {
    let (program, sources) = (&job.compiled.program, &*job.sources);
    let name = sources.get(job.main).name();
    let report = report::build(name, verdict, Some(program), sources, &job.judging.options);
    let report = serde_json::to_value(&report).map_err(|_| Fault::Internal)?;
    let stem = job.path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let old = job.layout.as_ref().map(|l| l.file);
    let files: Vec<FileId> = sources.iter().map(|(id, _)| id).filter(|id| Some(*id) != old).collect();
    let layout_text = layout_file::to_json(layout, None);
    let input =
        SceneInput { name: &stem, program, sources, files: &files, layout, layout_text: &layout_text, report: &report };
    Ok(Scene::build(&input).ok().map(|scene| plan::svg(&scene)))
}
