//! `scenelang synth`: the whole corridor, as far as something has changed, with a summary at the end.

use crate::args::{Judging, Pipeline, StageName, SummaryFormat, Synth};
use crate::edited::{self, Permission};
use crate::model::ModelSession;
use crate::progress::{Progress, solving};
use crate::rebuild::Rebuild;
use crate::replace::May;
use crate::solve::{explain, patience};
use crate::summary::{self, Done, How, SYNTHESIS};
use crate::{FAILED, FINDINGS, GOOD, INTERRUPTED, formalize, formats, furniture, input, interrupt, replace, settings};
use scenelang_base::door::Door;
use scenelang_export::{Exporter, Loss, losses, unity};
use scenelang_lang::Compiled;
use scenelang_synth::rebuild::{Inputs, Planned, sum};
use scenelang_synth::{
    Failure, Furnishings, Hold, LayoutRequest, Observer, PLANNED, Solved, Stage, furniture_file, own_files,
    program_files,
};
use scenelang_verify::exit_code;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Builds the scene; 0 if all hard constraints hold.
pub fn run(args: &Synth) -> u8 {
    build(args).unwrap_or_else(|code| code)
}

/// The same; as an error, the exit code of what ended it early.
fn build(args: &Synth) -> Result<u8, u8> {
    let begun = Instant::now();
    let time = args.time.map(Duration::from_secs_f64);
    interrupt::within(time.map(patience));
    let (path, asked) = asked_for(args).map_err(|why| fail(&why))?;
    let stem = path.file_stem().map_or_else(|| "scene".into(), |s| s.to_string_lossy().into_owned());
    let exporters = if args.until < StageName::Export { Vec::new() } else { chosen(args) };
    let permission = permitted(args, &path, asked.is_some(), &stem, &exporters).map_err(|why| fail(&why))?;
    let input = |refused: settings::Refused| explain(&Failure::Input(refused.sources, refused.diagnostics));
    let (judging, settings) = settings::all(&Judging::default(), &Door::of(&path)).map_err(input)?;
    let door = Door::of(&path);
    let furniture = furniture::chain(&args.furniture, &settings.assets, &door, args.model.offline);
    let furniture = furniture.map_err(|why| fail(&why))?;
    let mut model =
        ModelSession::new(&args.model, &settings.llm, args.seed).map_err(|error| fail(&error.to_string()))?;
    let mut rebuild = Rebuild::of(&args.output, &stem, args.from);
    let Program { planned, reading: read } = match &asked {
        Some(asked) => program(args, &path, asked, model.as_mut(), &mut rebuild)?,
        None => Program::default(),
    };
    let before = if permission.taken.is_none() { rebuild.before(args.seed) } else { None };
    let names = Names { path: path.display().to_string(), layout: format!("{stem}.layout.json") };
    let (start, quality, share) = begin(args, &permission, planned.as_deref(), &names.layout);
    let request = LayoutRequest {
        name: &names.path,
        path: &path,
        files: &door,
        start,
        before: before.as_ref(),
        // As seen from the output folder, so that what is written does not depend on where that is.
        layout_name: &names.layout,
        scene_member: &format!("{stem}.scene"),
        hold: Hold::Nothing,
        time: time.map(|time| time.saturating_sub(begun.elapsed())),
        alternatives: None,
        free: 0,
        threads: args.search.threads(),
        effort: args.search.effort,
        quality,
        share,
        stop: &interrupt::stop(),
        seed: args.seed,
        judge: judging.options,
        furniture: furniture.as_ref(),
    };
    let mut stages = Stages { progress: Progress::new("reading"), begun: Instant::now(), seconds: Vec::new() };
    let asked = asked.map(|asked| reading(args, &asked, model.is_some()));
    if args.until < StageName::Layout {
        return early(args, &request, (&stem, asked, read.as_ref()), rebuild, stages);
    }
    let mut solved = match scenelang_synth::solve_with(&request, model.as_mut().map(ModelSession::adviser), &mut stages)
    {
        Ok(solved) => solved,
        Err(failure) => {
            drop(stages);
            return unsolved(args, &failure);
        }
    };
    solved.first.checked.report.judged_with = judging.with;
    rebuild.program(asked, &program_files(&solved.compiled, &stem));
    rebuild.assets(&solved.made);
    rebuild.layout(&solved, args.search.quality, permission.taken.as_ref().map(|taken| taken.name.as_str()));
    stages.enter(Stage::Export);
    // A layout that was found is not lost to a Ctrl-C while it is exported.
    interrupt::gently();
    let written = exported(&solved, &stem, &exporters, &mut rebuild, &stages).and_then(|exported| {
        let interrupted = exported.is_none();
        let (planned, lost) = exported.unwrap_or_default();
        let inputs: Vec<&Path> = solved.compiled.sources.iter().map(|(_, file)| file.path()).collect();
        let may = May { force: args.force, these: &permission.replaced };
        Ok((rebuild.write(own_files(&solved, &stem), planned, &inputs, may, true)?, lost, interrupted))
    });
    let (files, lost, interrupted) = match written {
        Ok(written) => written,
        Err(message) => {
            drop(stages);
            return Err(fail(&message));
        }
    };
    stages.leave(Stage::Export);
    let seconds = std::mem::take(&mut stages.seconds);
    drop(stages);
    let rebuilt = args.explain_rebuild.then_some(&rebuild.told);
    let (solved, files, taken) = (&solved, files.as_slice(), permission.taken.as_ref());
    let done = Done { solved, files, lost: &lost, seconds: &seconds, model: model.as_ref(), taken };
    summary::tell(&How { format: args.format, folder: &args.output, rebuilt, read: read.as_ref() }, &done);
    if interrupted {
        return Ok(without_files(solved));
    }
    Ok(exit_code(&solved.first.checked.report))
}

/// Tells why there is no layout: a program that cannot hold has a report all the same.
fn unsolved(args: &Synth, failure: &Failure) -> Result<u8, u8> {
    if let (Failure::Contradiction(checked), SummaryFormat::Json) = (failure, args.format) {
        println!("{}", json!({ "format": SYNTHESIS, "ok": false, "report": checked.report, "files": [] }));
        return Ok(exit_code(&checked.report));
    }
    Err(explain(failure))
}

/// Tells what there is after an interruption during the export.
fn without_files(solved: &Solved) -> u8 {
    let so_far = if solved.first.layout().incomplete {
        "; the best layout found was written and marked as incomplete"
    } else {
        ""
    };
    eprintln!("interrupted before files were exported{so_far}");
    INTERRUPTED
}

/// How the program and the layout are called.
struct Names {
    path: String,
    layout: String,
}

/// The name and the text of a layout to start from, if there is one; the work for preferences, and what part of it is enough.
fn begin<'a>(
    args: &Synth,
    permission: &'a Permission,
    planned: Option<&'a str>,
    layout_name: &'a str,
) -> (Option<(&'a str, &'a str)>, u8, u8) {
    match (&permission.taken, planned) {
        // What somebody has put somewhere is not moved for a preference.
        (Some(taken), _) => (Some((taken.scene.layout_name.as_str(), taken.scene.layout.as_str())), 0, 1),
        // What was planned is good already: little work shows what more there is.
        (None, Some(text)) => (Some((layout_name, text)), args.search.quality, PLANNED),
        (None, None) => (None, args.search.quality, 1),
    }
}

/// What a request is read from, for the manifest.
fn reading(args: &Synth, request: &str, is_advised: bool) -> Inputs {
    let how = format!("{} {:?} {:?}", args.literal, args.time, is_advised.then_some(&args.model));
    let pairs = [
        ("request", sum(request.as_bytes())),
        ("options", sum(how.as_bytes())),
        ("scenelang", env!("CARGO_PKG_VERSION").to_owned()),
    ];
    pairs.into_iter().map(|(key, sum)| (key.to_owned(), sum)).collect()
}

/// Writes the program of a request, unless it is there; a layout to begin with, where one is known.
fn program(
    args: &Synth,
    path: &Path,
    request: &str,
    model: Option<&mut ModelSession>,
    rebuild: &mut Rebuild<'_>,
) -> Result<Program, u8> {
    // Without its layout it is read again, because that is planned with it.
    let has_layout = args.until < StageName::Layout || rebuild.before(args.seed).is_some();
    if rebuild.has_program(&reading(args, request, model.is_some())) && has_layout {
        return Ok(Program::default());
    }
    match write(args, path, request, model).map_err(|why| fail(&why))? {
        Begun::With(program) => Ok(program),
        Begun::Overfull(why) => Err(too_full(args.format, &why)),
    }
}

/// What there is of a scene without a layout.
enum Early {
    Program(Compiled),
    Assets(Furnishings),
}

/// Ends after the program, or after the furniture.
fn early(
    args: &Synth,
    request: &LayoutRequest<'_>,
    (stem, asked, read): (&str, Option<Inputs>, Option<&serde_json::Value>),
    mut rebuild: Rebuild<'_>,
    mut stages: Stages,
) -> Result<u8, u8> {
    let ended = if args.until == StageName::Program {
        scenelang_synth::compiled(request, &mut stages).map(Early::Program)
    } else {
        scenelang_synth::furnished(request, &mut stages).map(Early::Assets)
    };
    drop(stages);
    let ended = ended.map_err(|failure| explain(&failure))?;
    let (compiled, made) = match &ended {
        Early::Program(compiled) => (compiled, None),
        Early::Assets(made) => (&made.compiled, Some(made)),
    };
    let mut files = program_files(compiled, stem);
    rebuild.program(asked, &files);
    if let Some(made) = made {
        rebuild.assets(&made.made);
        files.extend(furniture_file(&made.furniture));
    }
    let inputs: Vec<&Path> = compiled.sources.iter().map(|(_, file)| file.path()).collect();
    let may = May { force: args.force, these: &[] };
    let files = rebuild.write(files, Planned::default(), &inputs, may, false).map_err(|why| fail(&why))?;
    let rebuilt = args.explain_rebuild.then_some(&rebuild.told);
    let until = if made.is_some() { "assets" } else { "program" };
    let how = How { format: args.format, folder: &args.output, rebuilt, read };
    summary::tell_early(&how, until, made, &files);
    Ok(GOOD)
}

/// Whether an argument is the name of a file rather than words: `bedroom.scen`, `rooms/bedroom`.
pub fn is_name(argument: &str) -> bool {
    let end = argument.rsplit('.').next().filter(|end| end.len() < argument.len());
    let has_extension = end.is_some_and(|end| (1..=6).contains(&end.len()) && end.chars().all(char::is_alphanumeric));
    !argument.contains(char::is_whitespace) && (has_extension || argument.contains('/'))
}

/// The program to build, and the request that it is to be written from, beside what comes of it.
fn asked_for(args: &Synth) -> Result<(PathBuf, Option<String>), String> {
    let named = PathBuf::from(&args.request);
    let is = |ends: &[&str]| named.extension().is_some_and(|e| ends.iter().any(|end| e == *end));
    if args.output.is_file() {
        return Err(format!("-o takes a folder, but {} is a file", args.output.display()));
    }
    if is(&["scene"]) && !args.request.contains(' ') || is(&["scene"]) && named.exists() {
        return Ok((named, None));
    }
    if !named.exists() && is_name(&args.request) {
        let why = "a program ends in `.scene`, and a request is written in words";
        return Err(format!("there is no file {}; {why}", args.request));
    }
    let request = if is(&["txt", "md"]) && named.exists() { formalize::text(&named)? } else { args.request.clone() };
    if input::is_program(&request) {
        let why = "this is a program, not a request in words; the name of a program ends in `.scene`";
        return Err(if named.exists() { format!("{}: {why}", args.request) } else { why.to_owned() });
    }
    let program = PathBuf::from(format!("{}.scene", args.request));
    if !args.request.contains(char::is_whitespace) && program.is_file() {
        let name = program.display();
        eprintln!(
            "note: `{}` is read as a request; to build the program {name}, write `scenelang synth {name}`",
            args.request
        );
    }
    Ok((args.output.join("room.scene"), Some(request)))
}

/// What came of a request, if it was read in this run.
#[derive(Default)]
struct Program {
    /// A layout to begin with, where one is known and no seed asks for another.
    planned: Option<String>,
    /// How it was read, as `formalize` tells it.
    reading: Option<serde_json::Value>,
}

/// What is known once the program is written.
enum Begun {
    With(Program),
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
fn write(args: &Synth, path: &Path, request: &str, model: Option<&mut ModelSession>) -> Result<Begun, String> {
    let understood = formalize::understand(
        formalize::RequestSource::Words(request.to_owned()),
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
    let planned = planned.map(|layout| scenelang_layout::file::to_json(&layout, None));
    Ok(Begun::With(Program { planned, reading: Some(formalize::summary(&understood.reading)) }))
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

/// What is exported, and what is not in it.
type Exported = (Planned, Vec<Loss>);

/// What the formats are to be; `None`: Ctrl-C was pressed before they were made.
fn exported(
    solved: &Solved,
    stem: &str,
    exporters: &[Box<dyn Exporter>],
    rebuild: &mut Rebuild<'_>,
    stages: &Stages,
) -> Result<Option<Exported>, String> {
    let mut go_on = |name: &str| {
        stages.progress.say(format!("export: {name}"));
        !interrupt::asked()
    };
    if !go_on("scene") {
        return Ok(None);
    }
    if exporters.is_empty() {
        return Ok(Some(Exported::default()));
    }
    let scene = scenelang_synth::scene(solved, stem).map_err(|e| e.to_string())?;
    let planned = rebuild.formats(&scene, exporters, &mut go_on)?;
    Ok(planned.filter(|_| !interrupt::asked()).map(|planned| (planned, losses(&scene, exporters))))
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
    formats::chosen(&args.formats, pipeline, &args.output)
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
