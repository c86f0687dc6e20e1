//! A program under edit: its files read, its diagnostics asked for, its formulas made.

use super::checked::{checked, meanings, summaries};
use super::names::{At, KnownNames, Twice, assignments, circles, names};
use super::reader::{ReadFile, Reader};
use super::runs::{File, Sources, allowances, parsed, placed_runs};
use super::{Cancelled, Database, Observer, cancellable};
use crate::ast::{Stmt, StmtKind};
use crate::check::{Where, cycles};
use crate::compile::{MAX_ERRORS, Options};
use crate::hir::Meanings;
use crate::items::{Items, Located};
use crate::lint::{self, Linted, allow};
use crate::lower;
use crate::parse::ParsedFile;
use crate::program::Program;
use crate::sources::Loader;
use rustc_hash::FxHashSet;
use salsa::Setter;
use scenelang_base::{Code, Diagnostic, FileId, SourceMap, Span, TextRange, codes};
use smol_str::SmolStr;
use std::panic::{AssertUnwindSafe, resume_unwind};
use std::thread;

/// A program of so many runs of statements is looked at by two threads.
const MANY: usize = 128;
/// What the second one has to recurse on (bytes): as much as those of an editor.
const STACK: usize = 8 << 20;

/// A program whose text may change. What has been found out is kept as long as it is true.
pub struct Analysis {
    db: Database,
    sources: Sources,
    files: Vec<ReadFile>,
    /// What went wrong with reading and importing.
    unread: Vec<Diagnostic>,
}

/// A file of the program, parsed.
pub(crate) struct Unit<'a> {
    pub file: FileId,
    /// The path relative to the main file, as in draw keys; empty for the main file.
    pub prefix: &'a str,
    /// Whether it is a file of the library that was imported.
    pub bundled: bool,
    /// Its statements, with the byte offset in the file that their places are relative to.
    runs: Vec<(u32, &'a ParsedFile)>,
}

impl<'a> Unit<'a> {
    /// Its statements in order.
    pub fn places(&self) -> impl Iterator<Item = Located<'a>> {
        let file = Some(self.file);
        self.runs.iter().flat_map(move |(start, run)| {
            run.statements.iter().map(move |(offset, stmt)| Located { file, offset: start + offset, stmt })
        })
    }

    fn place(&self, run: u32, stmt: u32) -> Located<'a> {
        let (start, run) = self.runs[run as usize];
        let (offset, stmt) = &run.statements[stmt as usize];
        Located { file: Some(self.file), offset: start + offset, stmt }
    }
}

impl Analysis {
    /// No file yet.
    pub fn new(options: Options) -> Self {
        Self::build(options, None)
    }

    /// No file yet; `observer` is told the name of every query that runs, `parsed(Id(3))`.
    pub fn observed(options: Options, observer: impl Fn(&str) + Send + Sync + 'static) -> Self {
        Self::build(options, Some(Box::new(observer)))
    }

    fn build(options: Options, observer: Option<Observer>) -> Self {
        let db = Database::new(observer);
        let sources = Sources::new(&db, Vec::new(), options.core);
        Self { db, sources, files: Vec::new(), unread: Vec::new() }
    }

    /// Takes over the text of `main` and reads what it imports. Files that did not change cost nothing.
    pub fn update(&mut self, main: FileId, sources: &mut SourceMap, loader: &dyn Loader) {
        let before = std::mem::take(&mut self.files);
        let reader = Reader::new(&mut self.db, &before, sources, loader);
        (self.files, self.unread) = reader.read_all(main);
        let files: Vec<File> = self.files.iter().map(|f| f.text).collect();
        if files != self.sources.files(&self.db) {
            self.sources.set_files(&mut self.db).to(files);
        }
    }

    /// A handle for another thread, which reads what is known now. As soon as this analysis is updated, the other
    /// thread's questions end with [`Cancelled`]; the update waits for that.
    pub fn reader(&self) -> Self {
        Self { db: self.db.clone(), sources: self.sources, files: self.files.clone(), unread: self.unread.clone() }
    }

    /// What can be said after each keystroke: errors of syntax, names and types, and warnings about single statements,
    /// by file and place; at most [`MAX_ERRORS`] errors of a file, and as many warnings.
    ///
    /// # Errors
    /// [`Cancelled`]: the text was changed by another thread.
    pub fn diagnostics(&self) -> Result<Vec<Diagnostic>, Cancelled> {
        cancellable(AssertUnwindSafe(|| self.listed(self.unsilenced(self.found(&self.units())))))
    }

    /// The program, if there is no error, and all errors and warnings: also warnings about the whole program, and what
    /// shows only when quantifiers and predicates are expanded.
    ///
    /// # Errors
    /// [`Cancelled`]: the text was changed by another thread.
    pub fn program(&self, sources: &SourceMap) -> Result<(Option<Program>, Vec<Diagnostic>), Cancelled> {
        let (program, out) = self.partial(sources)?;
        Ok((Some(program).filter(|_| !out.iter().any(Diagnostic::is_error)), out))
    }

    /// The same, but of a program with errors there is what can be made of its other statements: those with an error,
    /// and all that need one of these, are left out.
    ///
    /// # Errors
    /// [`Cancelled`]: the text was changed by another thread.
    pub fn partial(&self, sources: &SourceMap) -> Result<(Program, Vec<Diagnostic>), Cancelled> {
        cancellable(AssertUnwindSafe(|| {
            let units = self.units();
            let mut out = self.found(&units);
            let errors: Vec<Code> = out.iter().filter(|d| d.is_error()).map(|d| d.code).collect();
            let bad = bad_statements(&out, &units);
            let expand = || lower::lower(&self.items(&units), &units, sources, &bad);
            let (warnings, (program, found)) = self.warnings_beside(&errors, expand)?;
            out.extend(warnings);
            out.extend(found);
            if let Some(main) = self.files.first() {
                out.extend(allow::idle(allowances(&self.db, main.text), main.file, &out));
            }
            Ok((program, self.listed(self.unsilenced(out))))
        }))
        .flatten()
    }

    /// What the statements of a file of the program mean; nothing of a file that is not of the program.
    ///
    /// # Errors
    /// [`Cancelled`]: the text was changed by another thread.
    pub fn meanings(&self, file: FileId) -> Result<Meanings<'_>, Cancelled> {
        cancellable(AssertUnwindSafe(|| {
            let units = self.units();
            let table = names(&self.db, self.sources);
            let span = |(name, at): (&SmolStr, At)| Some((name.clone(), name_span(place_of(&units, at))?));
            let read = self.files.iter().zip(&units).find(|(read, _)| read.file == file);
            let statements = read.map_or(Vec::new(), |(read, unit)| {
                let runs = placed_runs(&self.db, read.text).iter();
                unit.places().zip(runs.flat_map(|(_, run)| meanings(&self.db, *run))).collect()
            });
            Meanings {
                statements,
                declared: table.items.iter().map(|(name, (_, at))| (name, *at)).filter_map(span).collect(),
                defined: table.predicates.iter().map(|(name, (_, at))| (name, *at)).filter_map(span).collect(),
            }
        }))
    }

    fn units(&self) -> Vec<Unit<'_>> {
        let unit = |f: &'_ ReadFile| -> Vec<(u32, &'_ ParsedFile)> {
            placed_runs(&self.db, f.text).iter().map(|(at, run)| (*at, parsed(&self.db, *run))).collect()
        };
        self.files.iter().map(|f| Unit { file: f.file, prefix: &f.prefix, bundled: f.bundled, runs: unit(f) }).collect()
    }

    fn items<'a>(&'a self, units: &[Unit<'a>]) -> Items<'a> {
        let assigned = &assignments(&self.db, self.sources).by_key;
        Items::new(names(&self.db, self.sources), assigned, |at| place_of(units, at))
    }

    /// All that is found without expansion, in no order.
    fn found(&self, units: &[Unit<'_>]) -> Vec<Diagnostic> {
        let mut out = self.unread.clone();
        for (file, unit) in self.files.iter().zip(units) {
            for ((start, run), (_, parsed)) in placed_runs(&self.db, file.text).iter().zip(&unit.runs) {
                let here = |range: TextRange| range.shifted(*start).in_file(file.file);
                out.extend(parsed.diagnostics.iter().map(|d| d.clone().map_places(here)));
                for (stmt, d) in checked(&self.db, *run) {
                    let (offset, stmt) = &parsed.statements[*stmt as usize];
                    let place = Located { file: Some(file.file), offset: start + offset, stmt };
                    out.push(self.absolute(d.clone(), place, file.file, units));
                }
            }
        }
        self.found_twice(units, &mut out);
        let circles = circles(&self.db, self.sources);
        let variable = |at: At| {
            let place = place_of(units, at);
            target(place.stmt).and_then(|range| place.span(range))
        };
        let name = |at: At| name_span(place_of(units, at));
        out.extend(circles.variables.iter().filter_map(|c| cycles::report(c, variable, codes::E0204, "variables")));
        out.extend(circles.predicates.iter().filter_map(|c| cycles::report(c, name, codes::E0210, "predicates")));
        out
    }

    /// Warnings about the whole program, in which errors with these codes were found; and what `expand` makes of it, at
    /// the same time where that is worth a thread.
    fn warnings_beside<T>(
        &self,
        errors: &[Code],
        expand: impl FnOnce() -> T,
    ) -> Result<(Vec<Diagnostic>, T), Cancelled> {
        if self.files.iter().map(|f| placed_runs(&self.db, f.text).len()).sum::<usize>() < MANY {
            return Ok((self.warnings(errors), expand()));
        }
        let other = self.reader();
        thread::scope(|scope| {
            let work = move || cancellable(AssertUnwindSafe(|| other.warnings(errors)));
            let beside = thread::Builder::new().stack_size(STACK).spawn_scoped(scope, work);
            let expanded = expand();
            let warnings = match beside {
                Ok(beside) => beside.join().unwrap_or_else(|panic| resume_unwind(panic))?,
                // There are threads enough already.
                Err(_) => self.warnings(errors),
            };
            Ok((warnings, expanded))
        })
    }

    /// Warnings about the whole program, in which errors with these codes were found.
    fn warnings(&self, errors: &[Code]) -> Vec<Diagnostic> {
        let units = self.units();
        let mut linted = Vec::new();
        // What the library says of all objects is no reason for silence about one of which the program says nothing.
        for (file, unit) in self.files.iter().zip(&units).filter(|(file, _)| !file.bundled) {
            let mut places = unit.places();
            for (_, run) in placed_runs(&self.db, file.text) {
                let checked = checked(&self.db, *run);
                for (uses, i) in summaries(&self.db, *run).iter().zip(0..) {
                    let about = checked.iter().filter(|(stmt, _)| *stmt == i).map(|(_, d)| d);
                    linted.extend(places.next().map(|place| Linted::new(place, uses, about)));
                }
            }
        }
        lint::program(&KnownNames(&self.db), &linted, errors)
    }

    /// What comments do not silence.
    fn unsilenced(&self, mut found: Vec<Diagnostic>) -> Vec<Diagnostic> {
        found.retain(|d| {
            let file = d.primary.as_ref().and_then(|l| self.files.iter().find(|f| f.file == l.place.file));
            !file.is_some_and(|f| allow::silenced(d, allowances(&self.db, f.text)))
        });
        found
    }

    /// A diagnostic of the statement at `place`, its places made absolute.
    fn absolute(&self, d: Diagnostic<Where>, place: Located<'_>, file: FileId, units: &[Unit<'_>]) -> Diagnostic {
        let here = |range: TextRange| range.shifted(place.offset).in_file(file);
        let table = names(&self.db, self.sources);
        d.map_places(|w| {
            let declared = match w {
                Where::Here(range) => return here(range),
                Where::Item(name) => table.items.get(&name).and_then(|(_, at)| name_span(place_of(units, *at))),
                Where::Predicate(name) => table.predicates.get(&name).and_then(|(_, at)| {
                    let place = place_of(units, *at);
                    place.span(place.stmt.range)
                }),
            };
            declared.unwrap_or(here(place.stmt.range))
        })
    }

    fn found_twice(&self, units: &[Unit<'_>], out: &mut Vec<Diagnostic>) {
        let table = names(&self.db, self.sources);
        let assigned = assignments(&self.db, self.sources);
        let mut report =
            |twice: &[Twice], code: Code, verb: &str, note: &str, span: fn(Located<'_>) -> Option<Span>| {
                for Twice { what, first, again } in twice {
                    let Some(here) = span(place_of(units, *again)) else { continue };
                    let kind = if verb == "defined" { "predicate " } else { "" };
                    let mut d = Diagnostic::new(code, here, format!("{kind}`{what}` is {verb} twice"))
                        .label(format!("{verb} again"));
                    if let Some(first) = span(place_of(units, *first)) {
                        d = d.related(first, format!("first {verb} here"));
                    }
                    out.push(d.note(note));
                }
            };
        let rename = "give one of them another name, or remove one";
        report(&table.declared_twice, codes::E0202, "declared", rename, name_span);
        report(&table.defined_twice, codes::E0202, "defined", rename, name_span);
        let one_value = "the order of statements does not matter, so a property or variable can be assigned only once";
        report(&assigned.twice, codes::E0203, "assigned", one_value, |p| p.span(target(p.stmt)?));
    }

    /// In the order of the files and places, with at most [`MAX_ERRORS`] errors of a file, and as many warnings.
    fn listed(&self, mut all: Vec<Diagnostic>) -> Vec<Diagnostic> {
        let unit = |file: FileId| self.files.iter().position(|f| f.file == file);
        all.sort_by_key(|d| {
            d.primary.as_ref().map(|l| (unit(l.place.file).is_none(), unit(l.place.file), l.place, d.code))
        });
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
}

fn place_of<'a>(units: &[Unit<'a>], at: At) -> Located<'a> {
    units[at.unit as usize].place(at.run, at.stmt)
}

/// The name that a statement declares or defines.
fn name_span(place: Located<'_>) -> Option<Span> {
    match &place.stmt.kind {
        StmtKind::Declare { name, .. } | StmtKind::Predicate { name, .. } => place.span(name.range),
        _ => None,
    }
}

/// What a statement assigns.
fn target(stmt: &Stmt) -> Option<TextRange> {
    if let StmtKind::Assign { target, .. } = &stmt.kind { Some(*target) } else { None }
}

/// Statements that hold the primary place of an error, or take part in a circle.
fn bad_statements(found: &[Diagnostic], units: &[Unit<'_>]) -> FxHashSet<(FileId, u32)> {
    let mut bad = FxHashSet::default();
    if !found.iter().any(Diagnostic::is_error) {
        return bad;
    }
    let offsets: Vec<Vec<u32>> = units.iter().map(|u| u.places().map(|p| p.offset).collect()).collect();
    for d in found.iter().filter(|d| d.is_error()) {
        let circle = d.code == codes::E0204 || d.code == codes::E0210;
        let related = d.related.iter().filter(|_| circle);
        for label in d.primary.iter().chain(related) {
            let Span { file, range } = label.place;
            let Some(unit) = units.iter().position(|u| u.file == file) else { continue };
            let at = offsets[unit].partition_point(|offset| *offset <= range.start);
            if let Some(offset) = at.checked_sub(1).map(|i| offsets[unit][i]) {
                bad.insert((file, offset));
            }
        }
    }
    bad
}
