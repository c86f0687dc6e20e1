//! `scenelang check`: judges files and prints reports.

use crate::args::{Check, Format, Geometry, Judging};
use crate::{FAILED, GOOD, progress::Progress};
use scenelang_lang::mend::mend;
use scenelang_lang::sources::Disk;
use scenelang_verify::report::model::Fixed;
use scenelang_verify::report::{self, Human, Report};
use scenelang_verify::{Options, check_file, exit_code, program_of};
use std::io::{IsTerminal, Write};
use std::path::Path;

/// Judges each file; the worst exit code.
pub fn run(args: &Check) -> u8 {
    // People read what fails; machines all there is.
    let sentences = args.all || args.format != Format::Human;
    let options = Options { all: args.all, sentences, ..options(args.judging) };
    let compile = scenelang_lang::Options { core: args.core };
    let mut reports: Vec<Report> = Vec::with_capacity(args.files.len());
    let mut out = std::io::stdout().lock();
    let mut worst = GOOD;
    let people = args.format == Format::Human;
    for path in &args.files {
        let name = path.display().to_string();
        let fixed = if args.fix { fix(&name, path, compile, people.then_some(&mut out)) } else { Ok(Vec::new()) };
        let mut checked = {
            let _progress = Progress::new(format!("checking {name}"));
            check_file(&name, path, &options, compile)
        };
        match fixed {
            Ok(fixed) => checked.report.fixed = fixed,
            Err(e) => {
                eprintln!("error: {e}");
                worst = FAILED;
            }
        }
        worst = worst.max(exit_code(&checked.report));
        // A closed pipe is no reason to fail: whoever reads has seen enough.
        let _ = match args.format {
            Format::Human => {
                write!(out, "{}", report::human(&checked, Human { color: color(), all: args.all }))
            }
            Format::Json => writeln!(out, "{}", report::json(&checked.report)),
            Format::Sarif | Format::Junit => {
                reports.push(checked.report);
                Ok(())
            }
        };
    }
    let _ = match args.format {
        Format::Sarif => writeln!(out, "{}", report::sarif(&reports)),
        Format::Junit => write!(out, "{}", report::junit(&reports)),
        Format::Human | Format::Json => Ok(()),
    };
    worst
}

/// Makes the safe fixes in a program, or in that of a layout, and writes the files that they change, each whole or not at
/// all. To `out` it says how many there were.
fn fix(
    name: &str,
    path: &Path,
    compile: scenelang_lang::Options,
    out: Option<&mut impl Write>,
) -> std::io::Result<Vec<Fixed>> {
    // A layout without a program is an error that the check reports.
    let Some((name, path)) = program_of(name, path) else { return Ok(Vec::new()) };
    let mended = mend(&name, &path, compile, &Disk);
    let mut fixed = Vec::new();
    for file in &mended.files {
        scenelang_base::fs::write_whole(&file.path, file.text.as_bytes())?;
        let made = file.made.iter();
        fixed.extend(made.map(|m| Fixed {
            file: file.name.clone(),
            line: m.line,
            code: m.code.to_string(),
            title: m.title.clone(),
        }));
    }
    if let Some(out) = out {
        // A closed pipe is no reason to fail, as for the report.
        let _ = mended.files.iter().try_for_each(|file| {
            let (made, all) = (file.made.len(), file.made.len() + file.left);
            let plural = if all == 1 { "" } else { "s" };
            writeln!(out, "fixed {made} of {all} finding{plural} in {}", file.name)
        });
        let _ = match mended.refused {
            0 => Ok(()),
            n => writeln!(out, "{n} not fixed, since what they change overlaps"),
        };
        let _ = mended
            .foreign
            .iter()
            .try_for_each(|name| writeln!(out, "{name} is outside the program's folder and stays as it is"));
    }
    Ok(fixed)
}

/// The verifier's options.
pub fn options(judging: Judging) -> Options {
    Options {
        geometry: match judging.geometry {
            Geometry::Parts => scenelang_layout::Geometry::Parts,
            Geometry::Box => scenelang_layout::Geometry::Box,
        },
        physics: !judging.no_physics,
        ..Options::default()
    }
}

/// Whether standard output takes colours: a terminal, and `NO_COLOR` not set.
pub fn color() -> bool {
    std::io::stdout().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty())
}
