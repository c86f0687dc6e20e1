//! `scenelang check`: judges files and prints reports.

use crate::args::{Check, Format, Geometry, Judging};
use crate::{GOOD, progress::Progress};
use scenelang_verify::prove::ProveOptions;
use scenelang_verify::report::{self, Human, Report};
use scenelang_verify::{Options, check_file, exit_code};
use std::io::{IsTerminal, Write};

/// Judges each file; the worst exit code.
pub fn run(args: &Check) -> u8 {
    let options = Options { all: args.all, ..options(args.judging) };
    let proofs = ProveOptions { judging: options, explain: args.explain_proof, ..ProveOptions::default() };
    let compile = scenelang_lang::Options { core: args.core };
    let mut reports: Vec<Report> = Vec::with_capacity(args.files.len());
    let mut out = std::io::stdout().lock();
    let mut worst = GOOD;
    for path in &args.files {
        let name = path.display().to_string();
        let checked = {
            let _progress = Progress::new(format!("checking {name}"));
            check_file(&name, path, &options, &proofs, compile)
        };
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
