//! `scenelang solve`: a layout for a program.

use crate::args::{Plain, Solve};
use crate::check::color;
use crate::model::{Asked, summary};
use crate::progress::Progress;
use crate::{FAILED, INTERRUPTED, interrupt, settings};
use scenelang_lang::sources::Disk;
use scenelang_solve::End;
use scenelang_synth::{Failure, Hold, Observer, Request, Solved, Stage, save_layout};
use scenelang_verify::report::{self, Human};
use scenelang_verify::{Checked, exit_code};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// What the answer as JSON calls itself.
const SOLUTION: &str = "scenelang.solution/1";

/// Solves and writes the layout; 0 if all hard constraints hold, else 1 with the best layout found.
pub fn run(args: &Solve) -> u8 {
    let stop = interrupt::listen();
    let output = args.output.clone().unwrap_or_else(|| args.scene.with_extension("layout.json"));
    let start = match &args.layout {
        None => None,
        Some(path) => match read(path) {
            Ok(text) => Some((path.display().to_string(), text)),
            Err(message) => return fail(&message),
        },
    };
    let (judge, settings) = match settings::all(&args.judging, &args.scene, &Disk) {
        Ok(both) => both,
        Err(refused) => return explain(&Failure::Input(refused.sources, refused.diagnostics)),
    };
    let mut model = match Asked::new(&args.model, &settings.llm, args.seed) {
        Ok(model) => model,
        Err(error) => {
            eprintln!("error: {error}");
            return FAILED;
        }
    };
    let member = relative(&args.scene, &output);
    let request = Request {
        name: &args.scene.display().to_string(),
        path: &args.scene,
        start: start.as_ref().map(|(name, text)| (name.as_str(), text.as_str())),
        layout_name: &output.display().to_string(),
        scene_member: &member,
        hold: match (args.lock.as_slice(), args.only.as_slice()) {
            ([], []) => Hold::Nothing,
            (names, []) => Hold::These(names),
            (_, names) => Hold::AllBut(names),
        },
        time: args.time.map(Duration::from_secs_f64),
        stop,
        seed: args.seed,
        judge,
    };
    let mut watch = Watch { progress: Progress::new("reading") };
    let solved = scenelang_synth::solve_with(&request, model.as_mut().map(Asked::adviser), &mut watch);
    drop(watch);
    let solved = match solved {
        Ok(solved) => solved,
        Err(Failure::Contradiction(checked)) if args.format == Plain::Json => {
            let file = request.name;
            let format = SOLUTION;
            let report = &checked.report;
            let answer = json!({ "format": format, "file": file, "ok": false, "end": "contradiction", "layouts": [],
                                 "report": report, "warnings": [] });
            println!("{answer}");
            return exit_code(&checked.report);
        }
        Err(failure) => return explain(&failure),
    };
    eprint!("{}", report::diagnostics(&solved.warnings, &solved.compiled.sources, color_err()));
    if let Err(e) = save_layout(&solved, &output) {
        return fail(&e.to_string());
    }
    match args.format {
        Plain::Json => println!("{}", answer(request.name, &solved, &output)),
        Plain::Text => {
            print!("{}", report::human(&solved.checked, Human { color: color(), all: false }));
            let end = match solved.outcome.end {
                _ if solved.layout.incomplete => ", as far as it was when interrupted, and marked as incomplete",
                End::Time => ", when the time was over",
                End::Budget => ", when the budget was spent",
                _ => "",
            };
            println!("{} written after {} rounds{end}", output.display(), solved.outcome.iterations);
            print!("{}", in_the_way(&solved));
            summary(model.as_ref(), solved.advice.as_ref());
        }
    }
    if solved.layout.incomplete { INTERRUPTED } else { exit_code(&solved.checked.report) }
}

/// What came of it, as JSON.
fn answer(file: &str, solved: &Solved, output: &Path) -> Value {
    let end = match solved.outcome.end {
        _ if solved.layout.incomplete => "interrupted",
        End::Solved => "solved",
        End::Budget => "budget",
        End::Time => "time",
        End::Exhausted => "exhausted",
        End::Asked => "interrupted",
    };
    let said = solved.warnings.iter().map(|d| d.message.clone());
    json!({
        "format": SOLUTION,
        "file": file,
        "ok": solved.checked.report.ok,
        "end": end,
        "layouts": [{
            "file": output.display().to_string(),
            "rounds": solved.outcome.iterations,
            "in_the_way": named(solved).map(|(id, text)| json!({ "id": id, "text": text })).collect::<Vec<_>>(),
            "report": solved.checked.report,
        }],
        "report": null,
        "warnings": said.chain(solved.outcome.warnings.iter().cloned()).collect::<Vec<_>>(),
    })
}

/// The statements in the way: how reports call them, and what they say.
fn named(solved: &Solved) -> impl Iterator<Item = (String, &str)> {
    let Checked { sources, program, report, .. } = &solved.checked;
    let constraints = program.iter().flat_map(|program| &program.constraints);
    let found = constraints.enumerate().filter(|(index, _)| solved.outcome.in_the_way.contains(index));
    found.map(|(_, c)| (report::statement_id(&report.file, sources, c.span), c.text.as_str()))
}

/// The statements in the way, in words.
fn in_the_way(solved: &Solved) -> String {
    let found: Vec<(String, &str)> = named(solved).collect();
    let mut out = match found.len() {
        0 => return String::new(),
        1 => "without this statement the rest can hold, as in this layout (found by search, not proved):\n".to_owned(),
        n => format!(
            "without these {n} statements the rest can hold, as in this layout (found by search, not proved):\n"
        ),
    };
    for (id, text) in found {
        out += &format!("  {id}: {}\n", text.split_whitespace().collect::<Vec<_>>().join(" "));
    }
    out
}

/// What is proved of a program that cannot hold, as `check` says it.
fn contradiction(checked: &Checked) -> u8 {
    print!("{}", report::human(checked, Human { color: color(), all: false }));
    println!("no layout was written: there is none in which all of it holds");
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
    let folder = folder.parent().map(Path::to_path_buf).unwrap_or_default();
    let (a, b): (Vec<_>, Vec<_>) = (scene.components().collect(), folder.components().collect());
    let shared = a.iter().zip(&b).take_while(|(x, y)| x == y).count();
    let mut out = PathBuf::new();
    for _ in shared..b.len() {
        out.push("..");
    }
    out.extend(&a[shared..]);
    out.to_string_lossy().replace('\\', "/")
}

fn read(path: &Path) -> Result<String, String> {
    let bytes = std::fs::read(path)
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
    fn solving(&mut self, p: &scenelang_solve::Progress) {
        self.progress.say(crate::progress::solving(p));
    }
}
