//! The front end in one call: read, parse, resolve, check, lower.

use crate::check::{self, cycles};
use crate::items::{Items, Place};
use crate::lint::{self, Linted, Uses};
use crate::lower;
use crate::parse::core;
use crate::program::Program;
use crate::sources::{Disk, Loader, Units, decode, plain, read_units};
use rustc_hash::FxHashSet;
use scenelang_base::{Code, Diagnostic, FileId, SourceFile, SourceMap, TextRange, codes};
use std::path::Path;

/// At most so many errors of a file are listed, and as many warnings.
pub const MAX_ERRORS: usize = 100;

/// How to compile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Accept only the published core language.
    pub core: bool,
}

/// What came of it.
#[derive(Debug)]
pub struct Compiled {
    /// All files read.
    pub sources: SourceMap,
    /// The main file.
    pub main: FileId,
    /// The program, if there is no error.
    pub program: Option<Program>,
    /// Errors and warnings, by file and place; at most [`MAX_ERRORS`] of each in a file.
    pub diagnostics: Vec<Diagnostic>,
}

impl Compiled {
    /// Whether there is an error.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(Diagnostic::is_error)
    }
}

/// Compiles a file from disk; `name` is how it is called in messages.
pub fn compile_file(name: &str, path: &Path, options: Options) -> Compiled {
    compile_with(name, path, options, &Disk, SourceMap::new())
}

/// Compiles a text; imports come from disk, relative to `path`.
pub fn compile_text(name: &str, path: &Path, text: &str, options: Options) -> Compiled {
    let mut sources = SourceMap::new();
    let main = sources.add(SourceFile::new(name, path, text));
    compile_main(main, options, &Disk, sources)
}

/// Compiles `path` with files from `loader`; `sources` may hold other files already (a layout).
pub fn compile_with(
    name: &str,
    path: &Path,
    options: Options,
    loader: &dyn Loader,
    mut sources: SourceMap,
) -> Compiled {
    match loader.load(path) {
        Err(e) => {
            let main = sources.add(SourceFile::new(name, path, ""));
            let d = Diagnostic::without_place(codes::E0001, format!("cannot read {name}: {}", plain(&e)));
            Compiled { sources, main, program: None, diagnostics: vec![d] }
        }
        Ok(bytes) => match decode(name, path, bytes, &mut sources) {
            Err(refused) => {
                let (main, d) = *refused;
                Compiled { sources, main, program: None, diagnostics: vec![d] }
            }
            Ok(main) => compile_main(main, options, loader, sources),
        },
    }
}

/// Compiles a file that is in `sources` already.
pub fn compile_main(main: FileId, options: Options, loader: &dyn Loader, mut sources: SourceMap) -> Compiled {
    let units = read_units(main, &mut sources, loader);
    let (program, mut diagnostics) = analyse(&units, &sources, options);
    lint::allow::silence_all(&sources, main, &mut diagnostics);
    let diagnostics = listed(diagnostics);
    let program = if diagnostics.iter().any(Diagnostic::is_error) { None } else { program };
    Compiled { sources, main, program, diagnostics }
}

fn analyse(units: &Units, sources: &SourceMap, options: Options) -> (Option<Program>, Vec<Diagnostic>) {
    let mut out = units.diagnostics.clone();
    let places: Vec<Place<'_>> = units
        .units
        .iter()
        .flat_map(|u| {
            u.parsed.statements.iter().map(|(offset, stmt)| Place { file: Some(u.file), offset: *offset, stmt })
        })
        .collect();
    let (items, found) = Items::collect(units, |file, range: TextRange| sources.get(file).slice(range));
    out.extend(found);
    out.extend(cycles::variable_cycles(&items));
    out.extend(cycles::predicate_cycles(&items, &places));
    let uses: Vec<Uses> = places.iter().map(|place| lint::uses(place.stmt)).collect();
    let mut linted = Vec::with_capacity(places.len());
    for (place, uses) in places.iter().zip(&uses) {
        let Some(file) = place.file else { continue };
        let mut found = check::statement(&items, *place);
        if options.core {
            found = core::check(place.stmt, found);
        }
        let sound = !found.iter().any(Diagnostic::is_error);
        if sound {
            found.extend(lint::statement(&items, *place));
        }
        linted.push(Linted::new(*place, uses, sound, &found));
        out.extend(found.into_iter().map(|d| check::absolute(d, *place, file, &items)));
    }
    let errors: Vec<Code> = out.iter().filter(|d| d.is_error()).map(|d| d.code).collect();
    out.extend(lint::program(&items, &linted, &errors));
    let bad = bad_statements(&out, &places);
    let (program, found) = lower::lower(&items, units, sources, &bad);
    out.extend(found);
    (Some(program), out)
}

/// Statements that hold the primary place of an error, or take part in a circle.
fn bad_statements(found: &[Diagnostic], places: &[Place<'_>]) -> FxHashSet<(FileId, u32)> {
    let mut bad = FxHashSet::default();
    for d in found.iter().filter(|d| d.is_error()) {
        let circle = d.code == codes::E0204 || d.code == codes::E0210;
        let related = d.related.iter().filter(|_| circle);
        for label in d.primary.iter().chain(related) {
            let span = label.place;
            // Places stand in the order of their files and offsets.
            let at = places.partition_point(|p| (p.file, p.offset) <= (Some(span.file), span.range.start));
            if let Some(p) = at.checked_sub(1).and_then(|i| places.get(i)) {
                bad.insert((span.file, p.offset));
            }
        }
    }
    bad
}

/// By file and place, with at most [`MAX_ERRORS`] errors of a file, and as many warnings.
fn listed(mut all: Vec<Diagnostic>) -> Vec<Diagnostic> {
    all.sort_by_key(|d| d.primary.as_ref().map(|l| (l.place.file, l.place.range.start, d.code)));
    let mut last = None;
    let mut counts = [0; 2];
    all.retain(|d| {
        let file = d.primary.as_ref().map(|l| l.place.file);
        if file != last {
            last = file;
            counts = [0; 2];
        }
        let count = &mut counts[usize::from(d.is_error())];
        *count += 1;
        *count <= MAX_ERRORS
    });
    all
}
