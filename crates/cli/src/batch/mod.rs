//! `scenelang batch`: a scene for each line of a manifest. Each line is worked on by a process of its own, and is done once
//! its record is written; so whatever ends the command, the next one goes on from there.

mod manifest;
mod merge;
mod record;
mod worker;

pub use merge::run as merge;
pub use worker::run as worker;

use crate::args::{BatchRun, SummaryFormat};
use crate::progress::Progress;
use crate::{FAILED, FINDINGS, GOOD, INTERRUPTED, interrupt, out, parallel, replace};
use manifest::{Job, Line, lines};
use record::{FailureKind, Record, Trouble, layout_of, scene_of};
use scenelang_base::door::Door;
use scenelang_base::owned::{Standing, standing};
use serde::{Deserialize, Serialize};
use std::io::{Read, Write};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};
use worker::Task;

/// What a summary calls itself.
const SUMMARY: &str = "scenelang.batchSummary/1";
/// How often a process is looked at.
const LOOK: Duration = Duration::from_millis(5);
/// How long a process has to end by itself.
const PATIENCE: Duration = Duration::from_secs(2);
/// So much is kept of what a process says that ends badly (bytes).
const SAID: u64 = 4 << 10;
/// So many failed lines are named to people.
const NAMED: usize = 20;

/// What came of the lines of one shard, or of all.
#[derive(Debug, Serialize, Deserialize)]
pub struct Summary {
    format: String,
    /// The sum of the manifest.
    manifest: String,
    /// Which shard, of how many; none of all together.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    shard: Option<[u64; 2]>,
    lines: usize,
    good: usize,
    failed: usize,
    results: Vec<Outcome>,
}

/// What came of a line.
#[derive(Debug, Serialize, Deserialize)]
struct Outcome {
    line: usize,
    name: String,
    ok: bool,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    error: Option<Trouble>,
}

impl Summary {
    fn new(manifest: &str, shard: Option<[u64; 2]>, results: Vec<Outcome>) -> Self {
        let good = results.iter().filter(|outcome| outcome.ok).count();
        let (format, manifest) = (SUMMARY.to_owned(), manifest.to_owned());
        Self { format, manifest, shard, lines: results.len(), good, failed: results.len() - good, results }
    }

    fn text(&self) -> Result<String, String> {
        serde_json::to_string_pretty(self).map(|text| text + "\n").map_err(|e| e.to_string())
    }

    /// Shows it, and what follows for the exit code.
    fn show(&self, format: SummaryFormat) -> u8 {
        match format {
            SummaryFormat::Json => println!("{}", serde_json::to_string(self).unwrap_or_default()),
            SummaryFormat::Human => {
                let failed = self.results.iter().filter(|outcome| !outcome.ok);
                for outcome in failed.take(NAMED) {
                    let why = outcome.error.as_ref().map_or("", |error| error.message.as_str());
                    out::show(&format!(
                        "line {} ({}): {}\n",
                        outcome.line,
                        outcome.name,
                        scenelang_base::plain::line(why)
                    ));
                }
                if self.failed > NAMED {
                    out::show(&format!("and {} more\n", self.failed - NAMED));
                }
                out::show(&format!("{} of {} lines have a scene, {} failed\n", self.good, self.lines, self.failed));
            }
        }
        if self.failed > 0 { FINDINGS } else { GOOD }
    }
}

/// The file of a shard's summary.
fn summary_of(shard: [u64; 2]) -> String {
    format!("summary-{:05}-of-{:05}.json", shard[0], shard[1])
}

/// Works on the lines; 0 if each has a scene, 1 if some failed.
pub fn run(args: &BatchRun) -> u8 {
    match all(args) {
        Ok(code) => code,
        Err(message) => {
            eprintln!("error: {message}");
            FAILED
        }
    }
}

fn all(args: &BatchRun) -> Result<u8, String> {
    interrupt::gently();
    let name = args.manifest.display();
    let bytes = Door::of(&args.manifest).read(&args.manifest).map_err(|e| {
        let split = if e.kind() == std::io::ErrorKind::FileTooLarge { "; split it into several" } else { "" };
        format!("cannot read {name}: {e}{split}")
    })?;
    let (lines, sum) = lines(&bytes, &args.manifest);
    drop(bytes);
    let range = args.shard.range(lines.len() as u64);
    let own = &lines[range.start as usize..range.end as usize];
    let shard = [args.shard.index, args.shard.of];
    let summary = args.output.join(summary_of(shard));
    replace::permit(&summary, &[&args.manifest], args.force)?;
    let program = std::env::current_exe().map_err(|e| format!("cannot find the program itself: {e}"))?;
    let progress = Progress::new(format!("0 of {} lines", own.len()));
    let (mut results, mut failed, mut again) = (Vec::new(), 0, 0);
    let jobs = args.jobs.map_or_else(parallel::usual, usize::from);
    parallel::in_order(
        own,
        jobs,
        |line| one(args, &program, line),
        |outcome| {
            let Some((outcome, is_old)) = outcome else { return };
            failed += usize::from(!outcome.ok);
            again += usize::from(is_old);
            results.push(outcome);
            let left = progress.left(results.len() - again, own.len() - results.len());
            progress.say(format!("{} of {} lines, {failed} failed{left}", results.len(), own.len()));
        },
    );
    drop(progress);
    if interrupt::asked() {
        eprintln!("interrupted after {} of {} lines; run the same command again to continue", results.len(), own.len());
        return Ok(INTERRUPTED);
    }
    let found = Summary::new(&sum, Some(shard), results);
    replace::json(&summary, &found.text()?)?;
    if again > 0 && args.format == SummaryFormat::Human {
        out::show(&format!("{again} lines were done before\n"));
    }
    let files = found.results.iter().filter_map(|o| o.error.as_ref()).filter(|error| error.kind == FailureKind::Files);
    let mut code = found.show(args.format);
    for error in files.take(NAMED) {
        eprintln!("error: {}", error.message);
        code = FAILED;
    }
    Ok(code)
}

/// What came of a line, and whether that was known before; `None`: the end was asked for.
fn one(args: &BatchRun, program: &Path, line: &Line) -> Option<(Outcome, bool)> {
    if interrupt::asked() {
        return None;
    }
    let of = |record: Record| Outcome { line: line.number, name: record.name, ok: record.ok, error: record.error };
    let bad = |kind, message: String| Record::bad(&line.name, &line.key, Some(Trouble::new(kind, message)));
    let own = [scene_of(&line.name), layout_of(&line.name)].map(|name| args.output.join(name));
    for file in own.iter().chain([&record::path(&args.output, &line.name)]) {
        if let Err(why) = replace::permit(file, &[&args.manifest], args.force) {
            return Some((of(bad(FailureKind::Files, why)), false));
        }
    }
    if let Some(record) = Record::of(&args.output, line).filter(|record| record.ok || !args.retry) {
        // A scene that somebody took away is made again, and so is one that was edited, where that is to be lost.
        let is_ours = |path: &Path| standing(path).is_ok_and(|is| is == Standing::Ours);
        let is_there = |name: &Option<String>| name.as_ref().is_none_or(|name| is_ours(&args.output.join(name)));
        if is_there(&record.scene) && is_there(&record.layout) {
            return Some((of(record), true));
        }
    }
    let trouble = match &line.job {
        Err(why) => Some(Trouble::new(FailureKind::Line, why.clone())),
        Ok(job) => worked(args, program, line, job),
    };
    if trouble.as_ref().is_some_and(|trouble| trouble.kind == FailureKind::Crash) {
        // Ctrl-C reaches the process as soon as it reaches us.
        std::thread::sleep(10 * LOOK);
    }
    if interrupt::asked() {
        return None;
    }
    let record = match trouble {
        // The process wrote what came of it.
        None => match Record::of(&args.output, line) {
            Some(record) => return Some((of(record), false)),
            None => bad(FailureKind::Crash, "the process that worked on it ended without a result".to_owned()),
        },
        Some(trouble) => Record::bad(&line.name, &line.key, Some(trouble)),
    };
    match record.write(&args.output) {
        Ok(()) => Some((of(record), false)),
        Err(why) => Some((of(bad(FailureKind::Files, why)), false)),
    }
}

/// Has a process work on a line; `None`: it has written what came of it.
fn worked(args: &BatchRun, program: &Path, line: &Line, job: &Job) -> Option<Trouble> {
    let crash = |why: String| Some(Trouble::new(FailureKind::Crash, why));
    let task = Task {
        job: job.clone(),
        name: line.name.clone(),
        key: line.key.clone(),
        manifest: args.manifest.clone(),
        folder: args.output.clone(),
        parent: std::process::id(),
        time: args.time,
        memory: args.memory << 20,
    };
    let text = match serde_json::to_string(&task) {
        Ok(text) => text,
        Err(why) => return crash(why.to_string()),
    };
    let mut command = Command::new(program);
    command.arg("batch-line").stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
    let mut child = match command.spawn() {
        Ok(child) => child,
        Err(why) => return crash(format!("no process could be started for it: {why}")),
    };
    let said = child.stderr.take().map(|stderr| {
        std::thread::spawn(move || {
            let mut said = Vec::new();
            let mut stderr = stderr;
            let _ = stderr.by_ref().take(SAID).read_to_end(&mut said);
            // The rest is read, too: else the process waits for ever.
            let _ = std::io::copy(&mut stderr, &mut std::io::sink());
            String::from_utf8_lossy(&said).into_owned()
        })
    });
    if let Some(mut stdin) = child.stdin.take() {
        // A process that ends before it has read all says so by its exit code.
        let _ = stdin.write_all(text.as_bytes());
    }
    let ended = wait(&mut child, Duration::from_secs_f64(args.time));
    let said = said.and_then(|said| said.join().ok()).unwrap_or_default();
    match ended {
        Ok(Some(status)) if status.success() => None,
        Ok(Some(status)) => Some(badly(status, &said, args.memory)),
        Ok(None) => Some(Trouble::new(
            FailureKind::Time,
            format!("it was stopped after {} s (--time increases the limit)", args.time),
        )),
        Err(why) => crash(format!("cannot wait for its process: {why}")),
    }
}

/// Waits for a process, for so long; `None`: it was ended.
fn wait(child: &mut Child, time: Duration) -> std::io::Result<Option<ExitStatus>> {
    let begun = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        if begun.elapsed() >= time || interrupt::asked() {
            end(child)?;
            return Ok(None);
        }
        std::thread::sleep(LOOK);
    }
}

/// Ends a process: first so that it can take its temporary files away.
fn end(child: &mut Child) -> std::io::Result<()> {
    #[cfg(unix)]
    if let Some(process) = i32::try_from(child.id()).ok().and_then(rustix::process::Pid::from_raw) {
        let _ = rustix::process::kill_process(process, rustix::process::Signal::TERM);
        let begun = Instant::now();
        while begun.elapsed() < PATIENCE {
            if child.try_wait()?.is_some() {
                return Ok(());
            }
            std::thread::sleep(LOOK);
        }
    }
    let _ = child.kill();
    child.wait().map(drop)
}

/// What is said of a process that ended badly.
fn badly(status: ExitStatus, said: &str, memory: u64) -> Trouble {
    // What the standard library says before it ends the process.
    if said.contains("memory allocation of") || said.contains("Cannot allocate memory") {
        return Trouble::new(
            FailureKind::Memory,
            format!("it needed more than {memory} MiB of memory (--memory increases the limit)"),
        );
    }
    let last = said.lines().rev().find(|line| !line.trim().is_empty()).unwrap_or("it said nothing");
    Trouble::new(FailureKind::Crash, format!("its process ended with {status}: {}", last.trim()))
}
