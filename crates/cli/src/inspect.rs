//! Commands that show what becomes of a program: its tree (`syntax`), what its names and expressions mean (`hir`), what
//! its statements become (`constraints`).

use crate::args::{Inspect, Plain};
use crate::out::Out;
use crate::solve::color_err;
use crate::{FAILED, FINDINGS, GOOD, input};
use scenelang_base::door::Door;
use scenelang_base::{Diagnostic, FileId, SourceMap, TextRange};
use scenelang_ide::forms;
use scenelang_lang::db::Analysis;
use scenelang_lang::parse::parse_file;
use scenelang_lang::{Options, compile_main};
use scenelang_verify::report;
use std::fmt::Display;
use std::io::{BufWriter, Write};
use std::path::Path;

/// Prints the tree; errors of syntax go to standard error and make the exit code 1.
pub fn syntax(args: &Inspect) -> u8 {
    let Some((sources, id)) = read(&args.file) else { return FAILED };
    let file = sources.get(id);
    match args.format {
        Plain::Text => crate::out::show(&forms::syntax::text(file.text())),
        Plain::Json => print(format_args!("{}\n", forms::syntax::json(file.name(), file.text()))),
    }
    let errors: Vec<Diagnostic> = parse_file(file.text())
        .diagnostics
        .into_iter()
        .filter(Diagnostic::is_error)
        .map(|d| d.map_places(|range: TextRange| range.in_file(id)))
        .collect();
    if show(&errors, &sources) { FINDINGS } else { GOOD }
}

/// Prints the declarations and statements of a file; errors go to standard error and make the exit code 1.
pub fn hir(args: &Inspect) -> u8 {
    let Some((mut sources, main)) = read(&args.file) else { return FAILED };
    let mut analysis = Analysis::new(Options::default());
    analysis.update(main, &mut sources, &Door::of(&args.file));
    let (Ok(meanings), Ok(diagnostics)) = (analysis.meanings(main), analysis.diagnostics()) else { return FAILED };
    let file = sources.get(main);
    match args.format {
        Plain::Text => crate::out::show(&forms::hir::text(file, &sources, &meanings)),
        Plain::Json => print(format_args!("{}\n", forms::hir::json(file, &sources, &meanings))),
    }
    if show(&diagnostics, &sources) { FINDINGS } else { GOOD }
}

/// Prints one line for each constraint, or all as JSON. A program that does not compile has none.
pub fn constraints(args: &Inspect) -> u8 {
    let Some((sources, main)) = read(&args.file) else { return FAILED };
    let compiled = compile_main(main, Options::default(), &Door::of(&args.file), sources);
    show(&compiled.diagnostics, &compiled.sources);
    let Some(program) = &compiled.program else { return FAILED };
    match args.format {
        Plain::Text => crate::out::show(&forms::constraints::text(program, &compiled.sources, main)),
        Plain::Json => print(format_args!("{}\n", forms::constraints::json(program, &compiled.sources, main))),
    }
    GOOD
}

/// Reads the program, or says why not.
fn read(path: &Path) -> Option<(SourceMap, FileId)> {
    let read = input::read(path);
    read.map_err(|message| eprintln!("error: {message}")).ok()
}

/// Prints to standard output, a large piece at a time.
fn print(what: impl Display) {
    // What is printed to never fails.
    let _ = write!(BufWriter::new(Out), "{what}");
}

/// Shows diagnostics on standard error; whether there is an error among them.
fn show(diagnostics: &[Diagnostic], sources: &SourceMap) -> bool {
    eprint!("{}", report::diagnostics(diagnostics, sources, color_err()));
    diagnostics.iter().any(Diagnostic::is_error)
}
