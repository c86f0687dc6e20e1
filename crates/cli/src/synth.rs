//! `scenelang synth`: the whole corridor, with a summary at the end.

use crate::args::{Judging, Pipeline, SummaryFormat, Synth};
use crate::check::color;
use crate::edited::{self, Permission, Taken};
use crate::model::{self, Asked};
use crate::progress::{Progress, solving};
use crate::replace::May;
use crate::solve::{color_err, explain, patience};
use crate::table::Table;
use crate::{FAILED, FINDINGS, INTERRUPTED, formalize, formats, furniture, interrupt, out, replace, settings};
use scenelang_base::FileId;
use scenelang_base::door::Door;
use scenelang_export::{Exporter, Loss, OutFile, embedded, losses, unity};
use scenelang_synth::{Failure, Hold, Observer, Request, Solved, Stage, own_files};
use scenelang_verify::exit_code;
use scenelang_verify::report::{self, Human};
use serde_json::json;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What the summary as JSON calls itself.
const SYNTHESIS: &str = "scenelang.synthesis/1";
/// The part of the work for preferences that is done where the furniture has its places already.
pub const PLANNED: u8 = 20;

/// Builds the scene; 0 if all hard constraints hold.
pub fn run(args: &Synth) -> u8 {
    let begun = Instant::now();
    let time = args.time.map(Duration::from_secs_f64);
    interrupt::within(time.map(patience));
    let (path, request) = match asked_for(args) {
        Ok(both) => both,
        Err(message) => return fail(&message),
    };
    let stem = path.file_stem().map_or_else(|| "scene".into(), |s| s.to_string_lossy().into_owned());
    let exporters = chosen(args);
    let Permission { taken, replaced } = match permitted(args, &path, request.is_some(), &stem, &exporters) {
        Ok(answer) => answer,
        Err(message) => return fail(&message),
    };
    let (judging, settings) = match settings::all(&Judging::default(), &Door::of(&path)) {
        Ok(both) => both,
        Err(refused) => return explain(&Failure::Input(refused.sources, refused.diagnostics)),
    };
    let furniture = match furniture::chain(&args.furniture, &settings.assets, &Door::of(&path), args.model.offline) {
        Ok(furniture) => furniture,
        Err(message) => return fail(&message),
    };
    let mut model = match Asked::new(&args.model, &settings.llm, args.seed) {
        Ok(model) => model,
        Err(error) => return fail(&error.to_string()),
    };
    let planned = match request.as_ref().map(|request| write(args, &path, request, model.as_mut())) {
        Some(Ok(Begun::With(planned))) => planned,
        Some(Ok(Begun::Overfull(why))) => return too_full(args.format, &why),
        Some(Err(message)) => return fail(&message),
        None => None,
    };
    let layout_name = format!("{stem}.layout.json");
    let (start, quality) = match (&taken, &planned) {
        // What somebody has put somewhere is not moved for a preference.
        (Some(taken), _) => (Some((taken.scene.layout_name.as_str(), taken.scene.layout.as_str())), 0),
        // What was planned is good already: little work shows what more there is.
        (None, Some(text)) => (Some((layout_name.as_str(), text.as_str())), args.search.quality.div_ceil(PLANNED)),
        (None, None) => (None, args.search.quality),
    };
    let request = Request {
        name: &path.display().to_string(),
        path: &path,
        files: &Door::of(&path),
        start,
        // As seen from the output folder, so that what is written does not depend on where that is.
        layout_name: &layout_name,
        scene_member: &format!("{stem}.scene"),
        hold: Hold::Nothing,
        time: time.map(|time| time.saturating_sub(begun.elapsed())),
        alternatives: None,
        free: 0,
        threads: args.search.threads(),
        effort: args.search.effort,
        quality,
        stop: &interrupt::stop(),
        seed: args.seed,
        judge: judging.options,
        furniture: furniture.as_ref(),
    };
    let mut stages = Stages { progress: Progress::new("reading"), begun: Instant::now(), seconds: Vec::new() };
    let mut solved = match scenelang_synth::solve_with(&request, model.as_mut().map(Asked::adviser), &mut stages) {
        Ok(solved) => solved,
        Err(failure) => {
            drop(stages);
            if let (Failure::Contradiction(checked), SummaryFormat::Json) = (&failure, args.format) {
                println!("{}", json!({ "format": SYNTHESIS, "ok": false, "report": checked.report, "files": [] }));
                return exit_code(&checked.report);
            }
            return explain(&failure);
        }
    };
    solved.first.checked.report.judged_with = judging.with;
    stages.enter(Stage::Export);
    // A layout that was found is not lost to a Ctrl-C while it is exported.
    interrupt::gently();
    let written = exported(&solved, &stem, &exporters).and_then(|exported| {
        let interrupted = exported.is_none();
        let (files, lost) = exported.unwrap_or_else(|| (own_files(&solved, &stem), Vec::new()));
        let inputs: Vec<&Path> = solved.compiled.sources.iter().map(|(_, file)| file.path()).collect();
        let may = May { force: args.force, these: &replaced };
        Ok((replace::folder(&args.output, &files, &inputs, may)?, lost, interrupted))
    });
    let (written, lost, interrupted) = match written {
        Ok(written) => written,
        Err(message) => {
            drop(stages);
            return fail(&message);
        }
    };
    stages.leave(Stage::Export);
    let seconds = std::mem::take(&mut stages.seconds);
    drop(stages);
    tell(args, &solved, &written, &lost, &seconds, model.as_ref(), taken.as_ref());
    if interrupted {
        let so_far = if solved.first.layout().incomplete {
            "; the best layout found was written and marked as incomplete"
        } else {
            ""
        };
        eprintln!("interrupted before files were exported{so_far}");
        return INTERRUPTED;
    }
    exit_code(&solved.first.checked.report)
}

/// The program to build, and the request that it is to be written from, beside what comes of it.
fn asked_for(args: &Synth) -> Result<(PathBuf, Option<String>), String> {
    let named = PathBuf::from(&args.request);
    let is = |ends: &[&str]| named.extension().is_some_and(|e| ends.iter().any(|end| e == *end));
    if is(&["scene"]) && !args.request.contains(' ') || is(&["scene"]) && named.exists() {
        return Ok((named, None));
    }
    let request = if is(&["txt", "md"]) && named.exists() { formalize::text(&named)? } else { args.request.clone() };
    Ok((args.output.join("room.scene"), Some(request)))
}

/// What is known once the program is written.
enum Begun {
    /// A layout to begin with, where one is known and no other is asked for by a seed.
    With(Option<String>),
    /// Why what is asked for does not fit on a floor.
    Overfull(String),
}

/// Ends without a layout, because what is asked for does not fit.
fn too_full(format: SummaryFormat, why: &str) -> u8 {
    if format == SummaryFormat::Json {
        println!("{}", json!({ "format": SYNTHESIS, "ok": false, "reason": why, "files": [] }));
    }
    eprintln!("no layout was written: make the room larger, or ask for fewer objects");
    FINDINGS
}

/// Writes the program of a request.
fn write(args: &Synth, path: &Path, request: &str, model: Option<&mut Asked>) -> Result<Begun, String> {
    let understood = formalize::understand(
        formalize::Request::Words(request.to_owned()),
        args.literal,
        true,
        args.time.map(|time| Duration::from_secs_f64(time / 3.0)),
        &interrupt::stop(),
        model,
    )?;
    eprint!("{}", formalize::notes(&understood.reading));
    formalize::tell(&understood.diagnostics, None);
    if understood.reading.nothing {
        return Err("nothing in the request was understood; say which objects are in which room".into());
    }
    replace::program(path, &understood.program)?;
    if let Some(why) = understood.overfull {
        return Ok(Begun::Overfull(why));
    }
    let planned = understood.layout.filter(|_| args.seed == 0);
    Ok(Begun::With(planned.map(|layout| scenelang_layout::file::to_json(&layout, None))))
}

/// Whether what is known before the work will be written may be: so that it is not done in vain. The scene to go on from,
/// if there is one.
fn permitted(
    args: &Synth,
    path: &Path,
    asked: bool,
    stem: &str,
    exporters: &[Box<dyn Exporter>],
) -> Result<Permission, String> {
    // First of all, so that nobody who says --force of another file loses an edit that was never spoken of.
    let answer = edited::ask(&args.output, stem, exporters, args.edits, args.force)?;
    let named = PathBuf::from(&args.request);
    let mut inputs: Vec<&Path> = vec![path];
    if asked {
        inputs = vec![&named];
        replace::permit(path, &inputs, args.force)?;
    }
    replace::permit(&args.output.join(format!("{stem}.layout.json")), &inputs, args.force)?;
    replace::permit(&args.output.join("report.json"), &inputs, args.force)?;
    Ok(answer)
}

/// All files of a scene, and what is not in them.
type Exported = (Vec<OutFile>, Vec<Loss>);

/// The files of the scene; `None`: Ctrl-C was pressed before they were made.
fn exported(solved: &Solved, stem: &str, exporters: &[Box<dyn Exporter>]) -> Result<Option<Exported>, String> {
    let mut files = own_files(solved, stem);
    if interrupt::asked() {
        return Ok(None);
    }
    let scene = scenelang_synth::scene(solved, stem).map_err(|e| e.to_string())?;
    for exporter in exporters {
        files.extend(exporter.files(&scene).map_err(|e| e.to_string())?);
        if interrupt::asked() {
            return Ok(None);
        }
    }
    Ok(Some((files, losses(&scene, exporters))))
}

fn fail(message: &str) -> u8 {
    eprintln!("error: {message}");
    FAILED
}

/// The exporters asked for.
fn chosen(args: &Synth) -> Vec<Box<dyn Exporter>> {
    let pipeline = match args.pipeline {
        Pipeline::Builtin => unity::Pipeline::BuiltIn,
        Pipeline::Urp => unity::Pipeline::Urp,
    };
    formats::chosen(&args.formats, pipeline)
}

/// Prints what was done.
fn tell(
    args: &Synth,
    solved: &Solved,
    written: &[PathBuf],
    lost: &[Loss],
    seconds: &[(Stage, Duration)],
    model: Option<&Asked>,
    taken: Option<&Taken>,
) {
    let moved = taken.map_or_else(Vec::new, |taken| moved(taken, solved));
    match args.format {
        SummaryFormat::Human => {
            for line in &moved {
                eprintln!("note: so that all holds: {}", scenelang_base::plain::line(line));
            }
            human(solved, written, seconds, &args.output);
            eprint!("{}", formats::notes(lost));
            model::summary(model, solved.advice.as_ref());
        }
        SummaryFormat::Json => {
            let mut summary = json(solved, written, seconds);
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
            println!("{summary}");
        }
    }
}

/// What stands elsewhere than in the scene that was taken, in words.
fn moved(taken: &Taken, solved: &Solved) -> Vec<String> {
    let before = scenelang_layout::file::read(&taken.scene.layout, FileId(0)).layout;
    embedded::differences(&before, solved.first.layout())
}

fn human(solved: &Solved, written: &[PathBuf], seconds: &[(Stage, Duration)], folder: &Path) {
    let report = &solved.first.checked.report;
    eprint!("{}", report::diagnostics(&solved.warnings, &solved.compiled.sources, color_err()));
    if exit_code(report) != 0 {
        print!("{}", report::human(&solved.first.checked, Human { color: color(), all: false }));
    }
    let summary = &report.summary;
    let mut held = Table::new(&["what", "held", "of"]);
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
    for path in shown(written, folder) {
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

fn json(solved: &Solved, written: &[PathBuf], seconds: &[(Stage, Duration)]) -> serde_json::Value {
    let stages: serde_json::Map<String, serde_json::Value> =
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

/// Times the stages and shows them on a terminal.
struct Stages {
    progress: Progress,
    begun: Instant,
    seconds: Vec<(Stage, Duration)>,
}

impl Observer for Stages {
    fn enter(&mut self, stage: Stage) {
        self.begun = Instant::now();
        self.progress.say(stage.name());
    }
    fn leave(&mut self, stage: Stage) {
        let time = self.begun.elapsed();
        self.progress.done(format!("  {:<8} {:>6.2} s", stage.name(), time.as_secs_f64()));
        self.seconds.push((stage, time));
    }
    fn furnishing(&mut self, said: &str) {
        interrupt::gently();
        self.progress.say(said.to_owned());
    }
    fn solving(&mut self, p: &scenelang_solve::Progress) {
        interrupt::gently();
        self.progress.say(solving(p));
    }
}
