//! `scenelang solve`: a layout for a program.

use crate::args::{Plain, Solve};
use crate::check::color;
use crate::model::{ModelSession, summary};
use crate::progress::Progress;
use crate::{FAILED, INTERRUPTED, furniture, interrupt, replace, settings, solution};
use scenelang_base::door::Door;
use scenelang_base::fs::{is_same, is_stream};
use scenelang_synth::{Failure, Hold, LayoutRequest, Observer, Stage, numbered};
use scenelang_verify::report::{self, Human};
use scenelang_verify::{Checked, exit_code};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// How much work goes into what a layout leaves open, where that is asked for: less than a second.
const FREE: u64 = 20_000_000;

/// Solves and writes the layout; 0 if all hard constraints hold, else 1 with the best layout found.
pub fn run(args: &Solve) -> u8 {
    if let Err(message) = is_program(&args.scene) {
        return fail(&message);
    }
    let stop = interrupt::stop();
    interrupt::within(args.time.map(|time| patience(Duration::from_secs_f64(time))));
    let output = args.output.clone().unwrap_or_else(|| args.scene.with_extension("layout.json"));
    let files: Vec<PathBuf> = match args.alternatives {
        None => vec![output.clone()],
        Some(n) => (1..=usize::from(n)).map(|n| numbered(&output, n)).collect(),
    };
    // Who names a layout to start from and to write to asks for it to be replaced.
    let named = |file: &Path| args.layout.as_deref().is_some_and(|start| is_same(start, file));
    for file in &files {
        if let Err(message) = replace::permit(file, &[&args.scene], args.force || named(file)) {
            return fail(&message);
        }
    }
    let start = match args.layout.as_deref().map(start).transpose() {
        Ok(start) => start,
        Err(message) => return fail(&message),
    };
    let (judging, settings) = match settings::all(&args.judging, &Door::of(&args.scene)) {
        Ok(both) => both,
        Err(refused) => return explain(&Failure::Input(refused.sources, refused.diagnostics)),
    };
    let furniture =
        match furniture::chain(&args.furniture, &settings.assets, &Door::of(&args.scene), args.model.offline) {
            Ok(furniture) => furniture,
            Err(message) => return fail(&message),
        };
    let mut model = match ModelSession::new(&args.model, &settings.llm, args.seed) {
        // Several layouts are looked for without one.
        Ok(model) => model.filter(|_| args.alternatives.is_none()),
        Err(error) => {
            eprintln!("error: {error}");
            return FAILED;
        }
    };
    let member = relative(&args.scene, &output);
    let request = LayoutRequest {
        name: &args.scene.display().to_string(),
        path: &args.scene,
        files: &Door::of(&args.scene),
        start: start.as_ref().map(|(name, text)| (name.as_str(), text.as_str())),
        before: None,
        share: 1,
        layout_name: &output.display().to_string(),
        scene_member: &member,
        hold: match (args.lock.as_slice(), args.only.as_slice()) {
            ([], []) => Hold::Nothing,
            (names, []) => Hold::These(names),
            (_, names) => Hold::AllBut(names),
        },
        time: args.time.map(Duration::from_secs_f64),
        alternatives: args.alternatives.map(usize::from),
        free: if args.free { FREE } else { 0 },
        threads: args.search.threads(),
        effort: args.search.effort,
        quality: args.search.quality,
        stop: &stop,
        seed: args.seed,
        judge: judging.options,
        furniture: furniture.as_ref(),
    };
    let mut watch = Watch { progress: Progress::new("reading") };
    let solved = scenelang_synth::solve_with(&request, model.as_mut().map(ModelSession::adviser), &mut watch);
    drop(watch);
    let mut solved = match solved {
        Ok(solved) => solved,
        Err(Failure::Contradiction(checked)) if args.format == Plain::Json => {
            println!("{}", solution::refuted(request.name, &checked));
            return exit_code(&checked.report);
        }
        Err(failure) => return explain(&failure),
    };
    for found in std::iter::once(&mut solved.first).chain(&mut solved.others) {
        found.checked.report.judged_with.clone_from(&judging.with);
    }
    eprint!("{}", report::diagnostics(&solved.warnings, &solved.compiled.sources, color_err()));
    let edited = |file: &Path| named(file) && start.as_ref().is_some_and(|(_, text)| !replace::is_ours(file, text));
    let files: Vec<PathBuf> = files.into_iter().take(solved.all().count()).collect();
    let texts: Vec<_> = solved.all().zip(&files).map(|(found, file)| (file.as_path(), found.text.as_str())).collect();
    if let Err(message) = replace::layouts(&texts, edited) {
        return fail(&message);
    }
    if let Some(file) = files.iter().find(|file| !is_stream(file) && Door::of(file).permits(&args.scene).is_err()) {
        let (file, scene) = (file.display(), args.scene.display());
        eprintln!("note: {file} is outside the folder of its program; check it with `scenelang check {file} {scene}`");
    }
    match args.format {
        Plain::Json => println!("{}", solution::json(request.name, &solved, &files)),
        Plain::Text => {
            print!("{}", solution::text(&solved, &files, request.alternatives, request.hold));
            summary(model.as_ref(), solved.advice.as_ref());
        }
    }
    if solved.first.layout().incomplete { INTERRUPTED } else { exit_code(&solved.first.checked.report) }
}

/// The name and the text of the layout to start from.
fn start(path: &Path) -> Result<(String, String), String> {
    Ok((path.display().to_string(), read(path)?))
}

/// Refuses a layout in place of a program.
fn is_program(scene: &Path) -> Result<(), String> {
    if scene.extension().is_none_or(|e| !e.eq_ignore_ascii_case("json")) {
        return Ok(());
    }
    let name = scene.display();
    Err(format!("{name} is not a program; `solve` takes a `.scene` file, and a layout to start from with --layout"))
}

/// How long is waited for a search to begin that may take so long: from then on it looks at the time itself, and has a
/// layout to show when it is over.
pub fn patience(time: Duration) -> Duration {
    2 * time + Duration::from_secs(1)
}

/// What is proved of a program that cannot hold, as `check` says it.
fn contradiction(checked: &Checked) -> u8 {
    print!("{}", report::human(checked, Human { color: color(), all: false }));
    println!("no layout was written, because none satisfies the program");
    exit_code(&checked.report)
}

/// Says why there is no layout.
pub fn explain(failure: &Failure) -> u8 {
    match failure {
        Failure::Interrupted => {
            eprintln!("interrupted; nothing was written");
            INTERRUPTED
        }
        Failure::Contradiction(checked) => contradiction(checked),
        Failure::Input(sources, diagnostics) => {
            eprint!("{}", report::diagnostics(diagnostics, sources, color_err()));
            FAILED
        }
    }
}

/// The path of `scene` seen from the folder of `layout`: relative where the two share a start, else as it is.
pub fn relative(scene: &Path, layout: &Path) -> String {
    let absolute = |p: &Path| std::path::absolute(p).unwrap_or_else(|_| p.to_path_buf());
    let (scene, folder) = (absolute(scene), absolute(layout));
    scenelang_base::door::relative(&scene, folder.parent().unwrap_or(Path::new("")))
}

fn read(path: &Path) -> Result<String, String> {
    let bytes = Door::of(path)
        .read(path)
        .map_err(|e| format!("cannot read {}: {}", path.display(), scenelang_lang::sources::plain(&e)))?;
    scenelang_layout::file::decode(bytes).map_err(|d| format!("{}: {}", path.display(), d.message))
}

/// Whether standard error takes colours.
pub fn color_err() -> bool {
    use std::io::IsTerminal;
    std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty())
}

fn fail(message: &str) -> u8 {
    eprintln!("error: {message}");
    FAILED
}

/// Shows the stage, ends the work on Ctrl-C.
struct Watch {
    progress: Progress,
}

impl Observer for Watch {
    fn enter(&mut self, stage: Stage) {
        self.progress.say(stage.name());
    }
    fn leave(&mut self, _stage: Stage) {}
    fn furnishing(&mut self, said: &str) {
        interrupt::gently();
        self.progress.say(said);
    }
    fn solving(&mut self, p: &scenelang_solve::Progress) {
        interrupt::gently();
        self.progress.say(crate::progress::solving(p));
    }
}
