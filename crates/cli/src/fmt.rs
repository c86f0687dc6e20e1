//! `scenelang fmt`: programs in the standard form.

use crate::args::Fmt;
use crate::input::{self, is_stdin, name_of};
use crate::solve::color_err;
use crate::{FAILED, FINDINGS, GOOD};
use scenelang_base::door::Door;
use scenelang_base::{Diagnostic, TextRange};
use scenelang_lang::fmt::{FormatOptions, format};
use scenelang_lang::parse::parse_file;
use scenelang_verify::report;
use std::path::Path;

/// Formats each file in place (or says that it would); the worst exit code.
pub fn run(args: &Fmt) -> u8 {
    let options = FormatOptions { width: usize::from(args.width) };
    args.files.iter().map(|file| one(file, args.check, &options)).max().unwrap_or(GOOD)
}

fn one(path: &Path, check: bool, options: &FormatOptions) -> u8 {
    let name = name_of(path);
    let (sources, id) = match input::read(path) {
        Ok(read) => read,
        Err(message) => return fail(&message),
    };
    let text = sources.get(id).text();
    let errors: Vec<Diagnostic> = parse_file(text)
        .diagnostics
        .into_iter()
        .map(|d| d.map_places(|range: TextRange| range.in_file(id)))
        .filter(Diagnostic::is_error)
        .collect();
    if !errors.is_empty() {
        eprint!("{}", report::diagnostics(&errors, &sources, color_err()));
        return fail(&format!("{name} has syntax errors and was not changed"));
    }
    let formatted = format(text, options);
    if check {
        if formatted == text {
            return GOOD;
        }
        let line = text
            .lines()
            .zip(formatted.lines())
            .position(|(a, b)| a != b)
            .unwrap_or(text.lines().count().min(formatted.lines().count()));
        eprintln!("{name}:{}: not formatted; run `scenelang fmt {name}`", line + 1);
        return FINDINGS;
    }
    if is_stdin(path) {
        print!("{formatted}");
        return GOOD;
    }
    if formatted != text
        && let Err(e) = Door::of(path).write(path, formatted.as_bytes())
    {
        return fail(&e.to_string());
    }
    GOOD
}

fn fail(message: &str) -> u8 {
    eprintln!("error: {message}");
    FAILED
}
