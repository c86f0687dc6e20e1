//! The judgement of a file, from disk or from an editor: a program by itself, or a layout with its program.

use crate::explain::check_at;
use scenelang_base::door::Door;
use scenelang_base::{Diagnostic, SourceFile, SourceMap, codes};
use scenelang_lang::compile::{self, Compiled, compile_with};
use scenelang_lang::program::{ObjectId, Program};
use scenelang_lang::sources::{Loader, unreadable};
use scenelang_layout::{Layout, ReadLayout, file as layout_file};
use scenelang_verify::check::{matching, rooms};
use scenelang_verify::prove::{Findings, ProveOptions, prove_closely};
use scenelang_verify::report::build;
use scenelang_verify::{CheckVerdict, Checked, Options};
use std::path::{Path, PathBuf};

/// How to judge a file: what it is called, where it is, and where its program comes from.
#[derive(Clone, Copy)]
struct Job<'a> {
    name: &'a str,
    path: &'a Path,
    options: &'a Options,
    compile: compile::Options,
    loader: &'a dyn Loader,
    /// The program's name and path, where it is not to be looked for where the layout says.
    program: Option<(&'a str, &'a Path)>,
}

/// Judges a file from disk: a layout (`.json`) with its program, or else a program by itself. In messages it is called
/// `name`, and other files accordingly.
///
/// Of a program alone it tells what is proved of it.
pub fn check_file(name: &str, path: &Path, options: &Options, compile: compile::Options) -> Checked {
    check_file_with(name, path, options, compile, &Door::of(path))
}

/// The same with files from `loader`.
pub fn check_file_with(
    name: &str,
    path: &Path,
    options: &Options,
    compile: compile::Options,
    loader: &dyn Loader,
) -> Checked {
    let job = Job { name, path, options, compile, loader, program: None };
    if !is_layout(path) {
        let compiled = compile_with(name, path, compile, loader, SourceMap::new());
        let explain = options.detail.proofs;
        let proofs = ProveOptions { judging: *options, explain, usual: true, ..ProveOptions::default() };
        let findings = compiled.program.as_ref().map(|program| prove_closely(program, &proofs)).unwrap_or_default();
        return check_program(name, compiled, &findings, options);
    }
    let text = match loader.load(path) {
        Ok(bytes) => layout_file::decode(bytes),
        Err(e) => Err(Box::new(unreadable(&format!("read {name}"), &e))),
    };
    match text {
        Ok(text) => judge_layout(text, &job),
        Err(finding) => {
            let mut out = Unfinished::default();
            out.verdict.diagnostics.push(*finding);
            out.finish(name, options)
        }
    }
}

/// The judgement of a program by itself: what its text and what is proved of it say.
pub fn check_program(name: &str, compiled: Compiled, findings: &Findings, options: &Options) -> Checked {
    let Compiled { sources, program, mut diagnostics, .. } = compiled;
    if let Some(program) = &program {
        let mut proved = findings.diagnostics(program);
        proved.extend(rooms::warn_of_program(program, options));
        scenelang_lang::lint::allow::silence(&sources, &mut proved);
        diagnostics.extend(proved);
    }
    let verdict = CheckVerdict { diagnostics, ..CheckVerdict::default() };
    Unfinished { sources, program, layout: None, verdict }.finish(name, options)
}

/// Judges the text of a layout file, called `name`, that is or would be at `path`; its program comes from `loader`.
pub fn check_layout_text(
    name: &str,
    path: &Path,
    text: String,
    options: &Options,
    compile: compile::Options,
    loader: &dyn Loader,
) -> Checked {
    judge_layout(text, &Job { name, path, options, compile, loader, program: None })
}

/// Judges the text of a layout that is called `name` and belongs to the program at `program` (name and path), wherever
/// the layout will be.
pub fn check_layout_of(
    name: &str,
    text: String,
    program: (&str, &Path),
    options: &Options,
    compile: compile::Options,
    loader: &dyn Loader,
) -> Checked {
    judge_layout(text, &Job { name, path: Path::new(name), options, compile, loader, program: Some(program) })
}

fn judge_layout(text: String, job: &Job<'_>) -> Checked {
    let mut out = Unfinished::default();
    let file = out.sources.add(SourceFile::new(job.name, job.path, text));
    let read = layout_file::read(out.sources.get(file).text(), file);
    out.verdict.diagnostics.clone_from(&read.diagnostics);
    if read.usable {
        let found = out.judge(&read, job);
        out.verdict.diagnostics.extend(found);
        out.layout = Some(read.layout);
    }
    out.finish(job.name, job.options)
}

#[derive(Default)]
struct Unfinished {
    sources: SourceMap,
    program: Option<Program>,
    layout: Option<Layout>,
    verdict: CheckVerdict,
}

impl Unfinished {
    fn finish(self, name: &str, options: &Options) -> Checked {
        let report = build(name, &self.verdict, self.program.as_ref(), &self.sources, options);
        let Self { sources, program, layout, verdict } = self;
        Checked { sources, program, layout, verdict, report }
    }

    /// Finds and compiles the program, and judges; returns what more there is to say.
    fn judge(&mut self, read: &ReadLayout, job: &Job<'_>) -> Vec<Diagnostic> {
        let stated = read.places.top.get("scene");
        let place = stated.map_or(read.places.opening(), |entry| entry.place.value);
        let Some(scene) = scene_of(read.layout.scene.as_deref(), stated.is_some(), job.path) else { return Vec::new() };
        if is_layout(&scene) {
            let say = format!("`{}` is a layout, not a program", scene.display());
            return vec![Diagnostic::new(codes::E0510, place, say)];
        }
        let (shown, path) = match job.program {
            Some((name, path)) => (name.to_owned(), path.to_path_buf()),
            None => beside(&scene, job.name, job.path),
        };
        let sources = std::mem::take(&mut self.sources);
        let compiled = compile_with(&shown, &path, job.compile, job.loader, sources);
        self.sources = compiled.sources;
        let Some(program) = compiled.program else {
            return unfit(&shown, place, stated.is_some(), compiled.diagnostics);
        };
        let mut found = compiled.diagnostics;
        let judged = check_read(&program, read, job.options);
        found.extend(judged.diagnostics);
        scenelang_lang::lint::allow::silence(&self.sources, &mut found);
        (self.verdict.rows, self.verdict.summary) = (judged.rows, judged.summary);
        (self.verdict.unlisted, self.verdict.parts) = (judged.unlisted, judged.parts);
        self.program = Some(program);
        found
    }
}

/// Judges a layout as it was read, by a program that is compiled already. Among the diagnostics is what does not match
/// between the two; what is wrong with the layout file by itself is not.
pub fn check_read(program: &Program, read: &ReadLayout, options: &Options) -> CheckVerdict {
    check_read_locked(program, read, options, &[])
}

/// The same; no move that is offered moves what is `locked`.
pub fn check_read_locked(program: &Program, read: &ReadLayout, options: &Options, locked: &[ObjectId]) -> CheckVerdict {
    let mut found = matching::check(program, read);
    let mut verdict = check_at(program, &read.layout, Some(&read.places), options, locked);
    found.append(&mut verdict.diagnostics);
    verdict.diagnostics = found;
    verdict
}

/// What to say where the program does not compile: its own errors and, in the layout, that they are there.
/// `stated`: the layout says which program it is.
fn unfit(scene: &str, place: scenelang_base::Span, stated: bool, diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let first = diagnostics.iter().find(|d| d.is_error());
    let unread = first.filter(|d| d.primary.is_none());
    let message = match unread {
        Some(d) => d.message.clone(),
        None => format!("the program {scene} has errors"),
    };
    let code = unread.filter(|d| d.code == codes::E0009).map_or(codes::E0510, |d| d.code);
    let mut finding = Diagnostic::new(code, place, message);
    if let Some(d) = unread {
        finding.notes.clone_from(&d.notes);
        if !stated {
            let note = format!("the layout names no program, so {scene} is expected; add `\"scene\": \"…\"`");
            finding = finding.note(note);
        }
    }
    if let Some(label) = first.and_then(|d| d.primary.as_ref()) {
        finding = finding.related(label.place, "the first of them");
    }
    // A file that is not there has no place of its own: the layout's is enough.
    let rest = diagnostics.into_iter().filter(|d| d.primary.is_some());
    std::iter::once(finding).chain(rest).collect()
}

/// The path of the program, relative to the layout's folder; `None` where the layout names it in a way that has been
/// refused.
fn scene_of(scene: Option<&str>, stated: bool, layout: &Path) -> Option<PathBuf> {
    match (scene, stated) {
        (Some(scene), _) => Some(PathBuf::from(scene)),
        (None, true) => None,
        (None, false) => {
            let file = layout.file_name()?.to_string_lossy().into_owned();
            let stem = file.strip_suffix(".layout.json").or_else(|| file.strip_suffix(".json")).unwrap_or(&file);
            Some(PathBuf::from(format!("{stem}.scene")))
        }
    }
}

/// What a program is called, and where it is; `scene` is relative to the folder of the layout that is called `name` and
/// is at `path`.
fn beside(scene: &Path, name: &str, path: &Path) -> (String, PathBuf) {
    let beside = |path: &Path| path.parent().map_or_else(|| scene.to_path_buf(), |folder| folder.join(scene));
    (beside(Path::new(name)).to_string_lossy().replace('\\', "/"), beside(path))
}

/// The program that a file is or, if it is a layout, that it belongs to: what it is called, and where it is. `None`: the
/// layout cannot be read, or names no program. The layout comes from `loader`; whether the program may be read is for that
/// to say, too.
pub fn program_of(name: &str, path: &Path, loader: &dyn Loader) -> Option<(String, PathBuf)> {
    if !is_layout(path) {
        return Some((name.to_owned(), path.to_path_buf()));
    }
    let text = layout_file::decode(loader.load(path).ok()?).ok()?;
    let mut sources = SourceMap::new();
    let file = sources.add(SourceFile::new(name, path, text));
    let read = layout_file::read(sources.get(file).text(), file);
    let stated = read.places.top.get("scene").is_some();
    let scene = scene_of(read.layout.scene.as_deref(), stated, path).filter(|scene| !is_layout(scene))?;
    Some(beside(&scene, name, path))
}

/// Whether a path is that of a layout.
fn is_layout(path: &Path) -> bool {
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case("json"))
}
