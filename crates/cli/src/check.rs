//! `scenelang check`: judges files and prints reports.

use crate::args::{Beside, Check, Format, Judging, Verbosity};
use crate::progress::Progress;
use crate::targets::JudgeTarget;
use crate::watch::{Seen, Watched};
use crate::{FAILED, GOOD, fix, foreign, interrupt, out, parallel, permissions, settings, targets, watch};
use scenelang_analysis::Question;
use scenelang_analysis::permissions::measured;
use scenelang_base::door::{Door, Named};
use scenelang_base::{Applicability, Diagnostic, SourceMap, codes};
use scenelang_engine::check_layout_text;
use scenelang_export::embedded;
use scenelang_lang::sources::Loader;
use scenelang_verify::report::{self, Human};
use scenelang_verify::{Checked, Detail, exit_code};
use std::io::IsTerminal;
use std::path::PathBuf;
use std::time::Duration;

/// Judges each file; the worst exit code.
pub fn run(args: &Check) -> u8 {
    interrupt::within(args.time.filter(|_| !args.watch).map(Duration::from_secs_f64));
    if args.watch { watch::run(args) } else { pass(args, None) }
}

/// Judges each file once, and prints the reports in the order of the files. What is read is remembered in `seen`.
pub fn pass(args: &Check, seen: Option<&Seen>) -> u8 {
    let targets = targets::find(&args.files);
    let named = Named::new(args.files.iter().map(PathBuf::as_path));
    let jobs = args.jobs.map_or_else(parallel::usual, usize::from);
    let mut kept: Vec<Checked> = Vec::new();
    let mut worst = GOOD;
    let compile = scenelang_lang::Options { core: args.core };
    let people = args.format == Format::Human;
    let up_to = if args.unsafe_fixes { Applicability::Unsafe } else { Applicability::Safe };
    let wanted = if args.fix || args.unsafe_fixes { targets.as_slice() } else { &[] };
    let fixes: Vec<_> =
        wanted.iter().map(|t| fix::run(t.path(), compile, up_to, &Door::of(t.path()).named(&named), people)).collect();
    let mut fixed = fixes.into_iter();
    let progress = match targets.as_slice() {
        [one] => Progress::new(format!("checking {}", one.path().display())),
        many => Progress::new(format!("checking {} files", many.len())),
    };
    let look = Human { color: color(), all: args.all };
    // People read what fails; machines all there is.
    let detail = Detail {
        all: args.all,
        sentences: args.all || args.format != Format::Human,
        bars: true,
        explain: args.explain,
        proofs: args.explain_proof,
        ..Detail::default()
    };
    let work = |target: &JudgeTarget| {
        let door = Door::of(target.path()).named(&named);
        let watched = seen.map(|seen| Watched { seen, door: &door });
        let loader = watched.as_ref().map_or(&door as &dyn Loader, |watched| watched);
        judge(target, &args.judging, &args.beside, detail, args.core, &door, loader)
    };
    parallel::in_order(&targets, jobs, work, |mut checked| {
        match fixed.next() {
            Some(Ok(fixed)) => checked.report.fixed = fixed,
            Some(Err(e)) => {
                eprintln!("error: {e}");
                worst = FAILED;
            }
            None => {}
        }
        worst = worst.max(exit_code(&checked.report));
        if matches!(args.format, Format::Human | Format::Json) {
            checked.report.permissions = measured(&checked);
        }
        let text = match args.format {
            Format::Human if args.verbosity == Verbosity::Compact => report::compact(&checked.report, look),
            Format::Human => report::human(&checked, look) + &permissions::listed(&checked.report.permissions),
            Format::Json => report::json(&checked.report) + "\n",
            Format::Github => report::github(std::slice::from_ref(&checked.report)),
            Format::Sarif | Format::Junit => return kept.push(checked),
        };
        progress.aside(|| {
            print!("{text}");
            if out::is_closed() {
                // Whoever reads has seen enough, and all that is left is to be read.
                std::process::exit(out::CLOSED.into());
            }
        });
    });
    drop(progress);
    match args.format {
        Format::Sarif => println!("{}", report::sarif(&kept)),
        Format::Junit => {
            let reports: Vec<_> = kept.into_iter().map(|checked| checked.report).collect();
            print!("{}", report::junit(&reports));
        }
        Format::Human | Format::Json | Format::Github => {}
    }
    worst
}

/// Judges one target by its settings; files come from `loader`, where `door` allows them. `beside`: what is known of a file of
/// another system.
pub fn judge(
    target: &JudgeTarget,
    judging: &Judging,
    beside: &Beside,
    detail: Detail,
    core: bool,
    door: &Door,
    loader: &dyn Loader,
) -> Checked {
    let (path, name) = (target.path(), target.path().display().to_string());
    let found = settings::find(door, loader);
    let given = settings::given(judging);
    let compile = scenelang_lang::Options { core };
    let question = Question { name: &name, path, given: &given, detail, compile };
    let nothing = |finding: Diagnostic| {
        question.judge_by(&found, |options| Checked::refused(&name, SourceMap::new(), vec![finding], options))
    };
    match target {
        JudgeTarget::File(_) => match foreign::find(&name, path, beside, loader) {
            Some(read) => question.judge_by(&found, |options| foreign::judge(&name, read, &question, options)),
            None => scenelang_analysis::judge(&question, &found, loader),
        },
        JudgeTarget::Empty(_) => {
            let say = format!("there is neither a .scene nor a .layout.json file in {name}");
            nothing(Diagnostic::without_place(codes::E0001, say))
        }
        JudgeTarget::Carrier(path, kind) => match embedded::read(&name, path, *kind, loader) {
            Err(finding) => nothing(*finding),
            Ok(scene) => question.judge_by(&found, |options| {
                let (called, at, text) = (&scene.layout_name, &scene.layout_path, scene.layout.clone());
                let mut checked = check_layout_text(called, at, text, options, compile, &scene);
                if !scene.changes.is_empty() {
                    checked.preface(called, scene.changes.clone(), options);
                }
                checked.report.file.clone_from(&name);
                checked
            }),
        },
    }
}

/// Whether standard output takes colours: a terminal, and `NO_COLOR` not set.
pub fn color() -> bool {
    std::io::stdout().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty())
}
