//! Reading the main file and what it imports, each file once, circles reported with their path.

use super::Database;
use super::names::{Head, outline};
use super::runs::{File, parsed, placed_runs};
use crate::ast::StmtKind;
use crate::library;
use crate::sources::{Loader, code_of, decode, file_name, normal, plain, with_advice};
use rustc_hash::{FxHashMap, FxHashSet};
use salsa::Setter;
use scenelang_base::suggest::nearest;
use scenelang_base::{Applicability, Diagnostic, FileId, SourceFile, SourceMap, Span, codes};
use std::path::{Path, PathBuf};

/// A file of the program and where it came from.
#[derive(Clone)]
pub(super) struct ReadFile {
    pub file: FileId,
    /// The path relative to the main file, as in draw keys; empty for the main file.
    pub prefix: String,
    /// Without `.` and `..`.
    pub path: PathBuf,
    pub text: File,
    /// Whether it is of the library, not of the disk.
    pub bundled: bool,
}

/// Follows the imports.
pub(super) struct Reader<'a> {
    db: &'a mut Database,
    /// The files of the last time, whose storage is used again.
    before: FxHashMap<&'a Path, File>,
    sources: &'a mut SourceMap,
    loader: &'a dyn Loader,
    /// Files whose imports are being read, outermost first.
    open: Vec<PathBuf>,
    files: Vec<ReadFile>,
    /// The paths of `files`.
    met: FxHashSet<PathBuf>,
    found: Vec<Diagnostic>,
}

impl<'a> Reader<'a> {
    pub fn new(
        db: &'a mut Database,
        before: &'a [ReadFile],
        sources: &'a mut SourceMap,
        loader: &'a dyn Loader,
    ) -> Self {
        let before = before.iter().map(|f| (f.path.as_path(), f.text)).collect();
        let (open, files, met, found) = (Vec::new(), Vec::new(), FxHashSet::default(), Vec::new());
        Self { db, before, sources, loader, open, files, met, found }
    }

    /// The main file first, then the others in the order met; and what went wrong.
    pub fn read_all(mut self, main: FileId) -> (Vec<ReadFile>, Vec<Diagnostic>) {
        let path = normal(self.sources.get(main).path());
        self.read(main, &path, "", false);
        (self.files, self.found)
    }

    fn read(&mut self, file: FileId, path: &Path, prefix: &str, bundled: bool) {
        let new = self.sources.get(file).text();
        let text = match self.before.get(path).copied() {
            Some(known) => {
                if known.text(self.db) != new {
                    known.set_text(self.db).to(new.to_owned());
                }
                known
            }
            None => File::new(self.db, new.to_owned(), bundled),
        };
        let imports = self.imports(file, text);
        self.files.push(ReadFile { file, prefix: prefix.to_owned(), path: path.to_owned(), text, bundled });
        self.met.insert(path.to_owned());
        self.open.push(path.to_owned());
        for (written, place) in imports {
            self.import(path, prefix, &written, place);
        }
        self.open.pop();
    }

    fn imports(&self, file: FileId, text: File) -> Vec<(String, Span)> {
        let db = &*self.db;
        let mut out = Vec::new();
        for (heads, (start, run)) in outline(db, text).iter().zip(placed_runs(db, text)) {
            for (i, head) in heads.list(db) {
                let Head::Imports { path } = head else { continue };
                let (offset, stmt) = &parsed(db, *run).statements[*i as usize];
                if let StmtKind::Import { range, .. } = &stmt.kind {
                    out.push((path.clone(), range.shifted(start + offset).in_file(file)));
                }
            }
        }
        out
    }

    /// A file that comes with the language: there is no path on the disk that it could be taken for.
    fn bundled(&mut self, name: &str, text: &str) {
        let path = Path::new("<library>").join(name);
        if self.met.contains(&path) {
            return;
        }
        let file = self.sources.put(SourceFile::new(name, &path, text));
        self.read(file, &path, name, true);
    }

    fn import(&mut self, from: &Path, prefix: &str, written: &str, place: Span) {
        if let Some(text) = library::imported(written) {
            self.bundled(written, text);
            return;
        }
        let folder = from.parent().unwrap_or(Path::new(""));
        let path = normal(&folder.join(written));
        let met = self.met.contains(&path);
        if let Some(at) = self.open.iter().position(|p| met && *p == path) {
            let mut names: Vec<String> = self.open[at..].iter().map(|p| file_name(p)).collect();
            names.push(file_name(&path));
            let message = format!("`{written}` imports itself: {}", names.join(" → "));
            self.found.push(
                Diagnostic::new(codes::E0206, place, message)
                    .label("closes the cycle")
                    .note("move what both files need into a third file and import that"),
            );
            return;
        }
        if met {
            return;
        }
        if Path::new(written).is_absolute() {
            let message = format!("`{written}` is an absolute path; imports are relative to the importing file");
            self.found.push(Diagnostic::new(codes::E0206, place, message));
            return;
        }
        let relative = Path::new(prefix).parent().unwrap_or(Path::new("")).join(written);
        let relative = normal(&relative).to_string_lossy().replace('\\', "/");
        let shown = self.sources.get(place.file).path().parent().unwrap_or(Path::new("")).join(written);
        match self.loader.load(&path) {
            Ok(bytes) => match decode(&normal(&shown).to_string_lossy(), &path, bytes, self.sources) {
                Ok(file) => self.read(file, &path, &relative, false),
                Err(refused) => self.found.push(refused.1.related(place, "imported here")),
            },
            Err(e) => {
                let message = format!("cannot import `{written}`: {}", plain(&e));
                let found = Diagnostic::new(code_of(&e, codes::E0206), place, message);
                self.found.push(match found.code {
                    codes::E0206 => not_found(found, written, place),
                    _ => with_advice(found, &e),
                });
            }
        }
    }
}

/// What to write instead of the path of a file that does not exist.
fn not_found(found: Diagnostic, written: &str, place: Span) -> Diagnostic {
    if !written.starts_with("std/") {
        return found.note("the path is relative to the folder of this file, unless it begins with `std/`");
    }
    let names: Vec<&str> = library::IMPORTED.iter().map(|(name, _)| *name).collect();
    let whole = format!("{}.scene", written.trim_end_matches(".scene"));
    match nearest(&whole, names.iter().copied()) {
        Some(near) => {
            let fix = format!("write `{near}`");
            found.label(format!("did you mean `{near}`?")).fix(Applicability::Unsafe, fix, place, format!("\"{near}\""))
        }
        None => found.note(format!("the files that can be imported from `std/` are: {}", names.join(", "))),
    }
}
