//! One line in a process of its own, which has its memory and its time and takes nobody along where it ends badly: the hidden
//! command `scenelang batch-line`, which reads a [`Task`] from standard input.

use super::manifest::{Job, beside};
use super::record::{FailureKind, Record, Trouble, layout_of, scene_of};
use crate::{FAILED, GOOD, formalize, interrupt, replace, settings};
use scenelang_base::door::{Door, MOST};
use scenelang_synth::{Failure, Hold, LayoutRequest, Observer, Stage};
use scenelang_verify::report::Report;
use scenelang_verify::report::model::Finding;
use scenelang_verify::{Checked, Explain, exit_code};
use serde::{Deserialize, Serialize};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// So many violations or errors are said.
const SAID: usize = 5;

/// What a process has to do.
#[derive(Debug, Serialize, Deserialize)]
pub struct Task {
    /// What is asked for.
    pub job: Job,
    /// What its files are called.
    pub name: String,
    /// The sum of what is asked for.
    pub key: String,
    /// The manifest, from whose folder programs are seen.
    pub manifest: PathBuf,
    /// The folder to write to.
    pub folder: PathBuf,
    /// The process that started it.
    pub parent: u32,
    /// How long it may take (seconds): whoever started it ends it then, and where that one is gone, it ends itself.
    pub time: f64,
    /// The most memory (bytes), where the system can enforce it.
    pub memory: u64,
}

/// Reads the task and does it; the record says what came of it.
pub fn run() -> u8 {
    let mut text = String::new();
    let read = std::io::stdin().take(MOST).read_to_string(&mut text);
    let task: Task =
        match read.map_err(|e| e.to_string()).and_then(|_| serde_json::from_str(&text).map_err(|e| e.to_string())) {
            Ok(task) => task,
            Err(why) => {
                eprintln!("error: `batch-line` can be started only by `scenelang batch`: {why}");
                return FAILED;
            }
        };
    bound(task.memory);
    interrupt::within(Some(2 * Duration::from_secs_f64(task.time)));
    let record = match make(&task) {
        Ok(objects) => {
            let scene = task.job.program.is_none().then(|| scene_of(&task.name));
            Record::good(&task.name, &task.key, scene, objects)
        }
        Err(trouble) => Record::bad(&task.name, &task.key, Some(trouble)),
    };
    // Where whoever started it is gone, the next command may be at work on the same line, and finishes it once.
    if interrupt::asked() || is_orphan(task.parent) {
        return crate::INTERRUPTED;
    }
    match record.write(&task.folder) {
        Ok(()) => GOOD,
        Err(why) => {
            eprintln!("error: {why}");
            FAILED
        }
    }
}

/// Whether the process that started this one has ended.
#[cfg(unix)]
fn is_orphan(parent: u32) -> bool {
    rustix::process::getppid().is_none_or(|pid| u32::try_from(pid.as_raw_nonzero().get()) != Ok(parent))
}

#[cfg(not(unix))]
fn is_orphan(_parent: u32) -> bool {
    false
}

/// Bounds the address space of this process.
#[cfg(unix)]
fn bound(memory: u64) {
    use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
    let old = getrlimit(Resource::As);
    let most = old.maximum.map_or(memory, |most| most.min(memory));
    // A system that cannot do so has its own bounds, as the book says.
    let _ = setrlimit(Resource::As, Rlimit { current: Some(most), maximum: old.maximum });
}

#[cfg(not(unix))]
fn bound(_memory: u64) {}

/// Writes program and layout; how many objects there are.
fn make(task: &Task) -> Result<usize, Trouble> {
    let (job, folder) = (&task.job, &task.folder);
    let files = |why: String| Trouble::new(FailureKind::Files, why);
    let input = |why: String| Trouble::new(FailureKind::Input, why);
    let scene = folder.join(scene_of(&task.name));
    let mut start = None;
    let mut quality = job.quality;
    if let Some(request) = &job.request {
        let request = formalize::RequestSource::Words(request.clone());
        let understood =
            formalize::understand(request, job.literal, true, None, &interrupt::stop(), None).map_err(input)?;
        if understood.reading.nothing {
            return Err(Trouble::new(
                FailureKind::Input,
                "nothing in the request was understood; say what stands in which room",
            ));
        }
        replace::program(&scene, &understood.program).map_err(files)?;
        if let Some(why) = understood.overfull {
            return Err(Trouble::new(FailureKind::Unsatisfied, why));
        }
        start =
            understood.layout.filter(|_| job.seed == 0).map(|layout| scenelang_layout::file::to_json(&layout, None));
        if start.is_some() {
            quality = quality.div_ceil(scenelang_synth::PLANNED);
        }
    } else if let Some(source) = &job.source {
        replace::program(&scene, source).map_err(files)?;
    }
    // A program in a file stays where it is, so that what it imports is found.
    let program = match &job.program {
        Some(program) => beside(&task.manifest, program),
        None => scene,
    };
    solved(task, &program, start.as_deref(), quality)
}

fn solved(task: &Task, program: &Path, start: Option<&str>, quality: u8) -> Result<usize, Trouble> {
    let layout = task.folder.join(layout_of(&task.name));
    let called = match &task.job.program {
        Some(program) => program.clone(),
        None => scene_of(&task.name),
    };
    let input = |sources, findings| {
        let options = scenelang_verify::Options::default();
        Trouble::new(FailureKind::Input, errors(&Checked::refused(&called, sources, findings, &options).report))
    };
    let mut judge = settings::all(&Default::default(), &Door::of(program))
        .map_err(|refused| input(refused.sources, refused.diagnostics))?
        .0
        .options;
    judge.detail.explain = Explain::First(0);
    let layout_name = layout_of(&task.name);
    let request = LayoutRequest {
        name: &called,
        path: program,
        files: &Door::of(program),
        start: start.map(|text| (layout_name.as_str(), text)),
        before: None,
        share: 1,
        layout_name: &layout_name,
        scene_member: &crate::solve::relative(program, &layout),
        hold: Hold::Nothing,
        time: None,
        alternatives: None,
        free: 0,
        // As many lines at once are worth more than as many threads for each.
        threads: 1,
        effort: task.job.effort,
        quality,
        stop: &interrupt::stop(),
        seed: task.job.seed,
        furniture: None,
        judge,
    };
    match scenelang_synth::solve(&request, &mut Unseen) {
        Ok(solved) if exit_code(&solved.first.checked.report) == 0 => {
            replace::layouts(&[(&layout, &solved.first.text)], |_| false)
                .map_err(|why| Trouble::new(FailureKind::Files, why))?;
            Ok(solved.first.layout().objects.len())
        }
        Ok(solved) => Err(Trouble::new(FailureKind::Unsatisfied, violations(&solved.first.checked))),
        Err(Failure::Interrupted) => Err(Trouble::new(FailureKind::Crash, "it was interrupted")),
        Err(Failure::Contradiction(checked)) => Err(Trouble::new(FailureKind::Contradiction, errors(&checked.report))),
        Err(Failure::Input(sources, findings)) => Err(input(sources, findings)),
    }
}

/// The errors of a report, each with its place.
fn errors(report: &Report) -> String {
    let place = |d: &Finding| d.span.as_ref().map(|p| format!("{}:{}:{}: ", p.file, p.start[0], p.start[1]));
    let errors = report.diagnostics.iter().filter(|d| d.severity == "error");
    let line = |d: &Finding| format!("{}{} [{}]", place(d).unwrap_or_default(), d.message, d.code);
    let list: Vec<String> = errors.take(SAID).map(line).collect();
    if list.is_empty() { "it cannot be read".to_owned() } else { list.join("; ") }
}

/// What a layout that was found breaks.
fn violations(checked: &Checked) -> String {
    let rows: Vec<String> = checked
        .report
        .constraints
        .iter()
        .filter(|row| row.is_violation())
        .map(|row| format!("{}: {}", row.id, row.text.split_whitespace().collect::<Vec<_>>().join(" ")))
        .collect();
    let more = match rows.len().saturating_sub(SAID) {
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    let named = rows.iter().take(SAID).cloned().collect::<Vec<_>>().join("; ");
    format!("no layout was found that satisfies all hard constraints; the best one violates {named}{more}")
}

/// Nobody watches.
struct Unseen;

impl Observer for Unseen {
    fn enter(&mut self, _stage: Stage) {}
    fn leave(&mut self, _stage: Stage) {}
    fn solving(&mut self, _progress: &scenelang_solve::Progress) {}
}
