//! The summary of `scenelang synth`: what holds, how long the stages took, which files there are.

use crate::args::SummaryFormat;
use crate::check::color;
use crate::edited::Taken;
use crate::model::{self, ModelSession};
use crate::rebuild::RebuildReport;
use crate::solve::color_err;
use crate::table::Table;
use crate::{formats, out};
use scenelang_base::FileId;
use scenelang_export::{Loss, embedded};
use scenelang_synth::{Furnishings, Solved, Stage};
use scenelang_verify::exit_code;
use scenelang_verify::report::{self, Human};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// What the summary as JSON calls itself.
pub const SYNTHESIS: &str = "scenelang.synthesis/1";

/// How it is told.
pub struct How<'a> {
    pub format: SummaryFormat,
    pub folder: &'a Path,
    /// What was made again, if that is asked for.
    pub rebuilt: Option<&'a RebuildReport>,
    /// How the request was read, if that was done in this run.
    pub read: Option<&'a Value>,
}

/// What was done.
pub struct Done<'a> {
    pub solved: &'a Solved,
    /// All files of the scene.
    pub files: &'a [PathBuf],
    pub lost: &'a [Loss],
    pub seconds: &'a [(Stage, Duration)],
    pub model: Option<&'a ModelSession>,
    pub taken: Option<&'a Taken>,
}

/// Prints what was done.
pub fn tell(how: &How<'_>, done: &Done<'_>) {
    let Done { solved, files, lost, seconds, model, taken } = *done;
    let moved = taken.map_or_else(Vec::new, |taken| moved(taken, solved));
    match how.format {
        SummaryFormat::Human => {
            for line in &moved {
                eprintln!("note: changed so that everything holds: {}", scenelang_base::plain::line(line));
            }
            human(how, solved, files, seconds);
            eprint!("{}", formats::notes(lost));
            model::summary(model, solved.advice.as_ref());
        }
        SummaryFormat::Json => {
            let mut summary = json(solved, files, seconds);
            summary["lost"] = formats::json(lost);
            if let Some(taken) = taken {
                summary["taken"] = json!({ "from": taken.name, "changes": taken.changes, "moved": moved });
            }
            if !solved.furniture.is_empty() {
                summary["furniture"] = scenelang_synth::manifest(&solved.furniture)["objects"].take();
            }
            if let Some(said) = model::json(model, solved.advice.as_ref()) {
                summary["model"] = said;
            }
            how.add_to(&mut summary);
            println!("{summary}");
        }
    }
}

impl How<'_> {
    /// Adds how the request was read and what was made again.
    fn add_to(&self, summary: &mut Value) {
        if let Some(read) = self.read {
            summary["reading"] = read.clone();
        }
        if let Some(told) = self.rebuilt {
            summary["rebuild"] = told.json(self.folder);
        }
    }
}

/// Prints what was done where that ended before there was a layout.
pub fn tell_early(how: &How<'_>, until: &str, made: Option<&Furnishings>, files: &[PathBuf]) {
    if let Some(made) = made {
        eprint!("{}", report::diagnostics(&made.warnings, &made.compiled.sources, color_err()));
    }
    match how.format {
        SummaryFormat::Human => {
            if let Some(told) = how.rebuilt {
                out::show(&format!("{}\n", told.human(how.folder)));
            }
            for path in shown(files, how.folder) {
                out::show(&format!("{}\n", path.display()));
            }
        }
        SummaryFormat::Json => {
            let files = files.iter().map(|p| p.display().to_string()).collect::<Vec<_>>();
            let mut summary = json!({ "format": SYNTHESIS, "ok": true, "until": until, "files": files });
            how.add_to(&mut summary);
            println!("{summary}");
        }
    }
}

/// What stands elsewhere than in the scene that was taken, in words.
fn moved(taken: &Taken, solved: &Solved) -> Vec<String> {
    let before = scenelang_layout::file::read(&taken.scene.layout, FileId(0)).layout;
    embedded::differences(&before, solved.first.layout())
}

fn human(how: &How<'_>, solved: &Solved, written: &[PathBuf], seconds: &[(Stage, Duration)]) {
    let report = &solved.first.checked.report;
    eprint!("{}", report::diagnostics(&solved.warnings, &solved.compiled.sources, color_err()));
    if exit_code(report) != 0 {
        print!("{}", report::human(&solved.first.checked, Human { color: color(), all: false }));
    }
    let summary = &report.summary;
    let mut held = Table::new(&["kind", "hold", "total"]);
    for (what, tally) in [
        ("assertions", summary.assertions),
        ("preferences", summary.preferences),
        ("physical rules", summary.physical),
        ("assignments", summary.pins),
    ] {
        held.row([what.into(), tally.satisfied.to_string(), tally.total.to_string()]);
    }
    let mut times = Table::new(&["stage", "seconds"]);
    for (stage, time) in seconds {
        times.row([stage.name().into(), format!("{:.2}", time.as_secs_f64())]);
    }
    let count = |n: usize, what: &str| if n == 1 { format!("1 {what}") } else { format!("{n} {what}s") };
    let layout = solved.first.layout();
    println!("{} in {}\n", count(layout.objects.len(), "object"), count(layout.regions.len(), "region"));
    println!("{}\n{}", held.render(), times.render());
    if !solved.furniture.is_empty() {
        println!("furniture: {}\n", scenelang_synth::told(&solved.furniture));
    }
    if let Some(told) = how.rebuilt {
        out::show(&format!("{}\n", told.human(how.folder)));
    }
    for path in shown(written, how.folder) {
        out::show(&format!("  {}\n", path.display()));
    }
    if let Some(page) = written.iter().find(|p| p.ends_with("preview.html")) {
        println!("\nopen {} to view the room", page.display());
    }
}

/// Files directly in the output folder, and folders in it, each once.
fn shown(written: &[PathBuf], folder: &Path) -> Vec<PathBuf> {
    let mut out: Vec<PathBuf> = Vec::new();
    for path in written {
        let first = path.strip_prefix(folder).ok().and_then(|p| p.components().next());
        let top = first.map_or_else(|| path.clone(), |c| folder.join(c));
        if !out.contains(&top) {
            out.push(top);
        }
    }
    out
}

fn json(solved: &Solved, written: &[PathBuf], seconds: &[(Stage, Duration)]) -> Value {
    let stages: serde_json::Map<String, Value> =
        seconds.iter().map(|(s, t)| (s.name().to_owned(), t.as_secs_f64().into())).collect();
    json!({
        "format": SYNTHESIS,
        "ok": solved.first.checked.report.ok,
        "incomplete": solved.first.layout().incomplete,
        "objects": solved.first.layout().objects.len(),
        "regions": solved.first.layout().regions.len(),
        "summary": solved.first.checked.report.summary,
        "warnings": solved.warnings.iter().map(|d| &d.message).collect::<Vec<_>>(),
        "seconds": stages,
        "files": written.iter().map(|p| p.display().to_string()).collect::<Vec<_>>(),
    })
}
