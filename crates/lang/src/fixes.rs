//! Applies the fixes of a program's findings to its files, in memory, until none is left: the safe ones, or all of them.
//!
//! A fix may make others possible (a statement that parses is looked at more closely), so the program is compiled again
//! after each round. Writing the files is left to the caller.

use crate::compile::{Compiled, Options, compile_with};
use crate::sources::{Loader, normal};
use scenelang_base::{Applicability, Code, Diagnostic, Edit, FileId, Fix, Severity, SourceMap, TextRange, fix};
use std::collections::BTreeMap;
use std::io;
use std::path::{Component, Path, PathBuf};

/// More rounds than this are not made: each makes all fixes that do not overlap, so a few are enough.
const ROUNDS: usize = 50;

/// What became of a program's files.
#[derive(Clone, Debug, Default)]
pub struct Fixed {
    /// Files that are changed, by path.
    pub files: Vec<File>,
    /// Fixes that could not be made, since they overlap or would make the syntax worse.
    pub refused: usize,
    /// Files with fixes that are not below the main file's folder, and so stay as they are.
    pub foreign: Vec<String>,
}

/// A changed file.
#[derive(Clone, Debug)]
pub struct File {
    /// As it is called in messages.
    pub name: String,
    /// Where it is.
    pub path: PathBuf,
    /// Its text after all fixes.
    pub text: String,
    /// The fixes, in the order in which they were made.
    pub made: Vec<Made>,
    /// Findings in it that are left.
    pub left: usize,
}

/// A fix that was made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Made {
    /// Of a finding of this code.
    pub code: Code,
    /// In the imperative.
    pub title: String,
    /// The line on which the finding began, in the text as it was then.
    pub line: u32,
}

/// Makes the fixes of a program in `path`, called `name`, and of what it imports from below its folder. `up_to`: with
/// `Unsafe`, guesses are made too, where a finding has one fix only.
pub fn fix_all(name: &str, path: &Path, options: Options, up_to: Applicability, loader: &dyn Loader) -> Fixed {
    let mut changed = Changed { loader, files: BTreeMap::new() };
    let folder = normal(path.parent().unwrap_or(Path::new("")));
    let mut refused = 0;
    let mut compiled = compile_with(name, path, options, &changed, SourceMap::new());
    for _ in 0..ROUNDS {
        let before = changed.files.clone();
        refused = round(&compiled, &folder, up_to, &mut changed.files);
        if changed.files.iter().all(|(path, file)| before.get(path).is_some_and(|b| b.text == file.text)) {
            break;
        }
        let next = compile_with(name, path, options, &changed, SourceMap::new());
        if syntax_errors(&next) > syntax_errors(&compiled) {
            // No fix should do this; if one does, the text stays as it was.
            refused = wanted(&compiled, &folder, up_to).count();
            changed.files = before;
            break;
        }
        compiled = next;
    }
    let findings = |of: FileId| compiled.diagnostics.iter().filter(|d| file_of(d) == Some(of)).count();
    let mut out = Fixed { refused, ..Fixed::default() };
    for (id, source) in compiled.sources.iter() {
        if let Some(mut file) = changed.files.remove(source.path()) {
            file.left = findings(id);
            out.files.push(file);
        }
    }
    for d in compiled.diagnostics.iter().filter(|d| fix_of(d, up_to).is_some()) {
        if let Some(id) = file_of(d).filter(|id| !is_below(&folder, compiled.sources.get(*id).path())) {
            let name = compiled.sources.get(id).name().to_owned();
            if !out.foreign.contains(&name) {
                out.foreign.push(name);
            }
        }
    }
    out
}

/// Makes one round of fixes; returns how many were left out because they overlap.
fn round(compiled: &Compiled, folder: &Path, up_to: Applicability, files: &mut BTreeMap<PathBuf, File>) -> usize {
    let mut refused = 0;
    for (id, source) in compiled.sources.iter() {
        let of_file: Vec<(&Diagnostic, Vec<Edit<TextRange>>)> = wanted(compiled, folder, up_to)
            .filter(|(d, _)| file_of(d) == Some(id))
            .map(|(d, fix)| {
                (d, fix.edits.iter().map(|e| Edit { place: e.place.range, text: e.text.clone() }).collect())
            })
            .collect();
        let applied = fix::apply(source.text(), of_file.iter().map(|(_, edits)| edits.as_slice()));
        refused += applied.left.len();
        if applied.made.is_empty() {
            continue;
        }
        let file = files.entry(source.path().to_path_buf()).or_insert_with(|| File {
            name: source.name().to_owned(),
            path: source.path().to_path_buf(),
            text: String::new(),
            made: Vec::new(),
            left: 0,
        });
        file.text = applied.text;
        for (d, _) in applied.made.iter().map(|i| &of_file[*i]) {
            let line = d.primary.as_ref().map_or(1, |l| source.position(l.place.range.start).line);
            let title = fix_of(d, up_to).map_or(String::new(), |fix| fix.title.clone());
            file.made.push(Made { code: d.code, title, line });
        }
    }
    refused
}

/// The findings with a fix that is wanted, in a file below the folder.
fn wanted<'c>(
    compiled: &'c Compiled,
    folder: &'c Path,
    up_to: Applicability,
) -> impl Iterator<Item = (&'c Diagnostic, &'c Fix)> {
    compiled.diagnostics.iter().filter_map(move |d| {
        let fix = fix_of(d, up_to)?;
        let file = file_of(d)?;
        let own = fix.edits.iter().all(|e| e.place.file == file);
        (own && is_below(folder, compiled.sources.get(file).path())).then_some((d, fix))
    })
}

fn fix_of(d: &Diagnostic, up_to: Applicability) -> Option<&Fix> {
    let safe = d.fixes.iter().find(|fix| fix.applicability == Applicability::Safe);
    match d.fixes.as_slice() {
        [only] if up_to == Applicability::Unsafe => Some(only),
        _ => safe,
    }
}

fn file_of(d: &Diagnostic) -> Option<FileId> {
    Some(d.primary.as_ref()?.place.file)
}

fn syntax_errors(compiled: &Compiled) -> usize {
    let syntax = |d: &&Diagnostic| d.severity == Severity::Error && d.code.as_str().starts_with("E01");
    compiled.diagnostics.iter().filter(syntax).count()
}

/// Whether a file is in a folder or below it.
fn is_below(folder: &Path, file: &Path) -> bool {
    let file = normal(file);
    file.strip_prefix(folder).is_ok_and(|rest| rest.components().all(|c| matches!(c, Component::Normal(_))))
}

/// Files as they are after the fixes, on top of another loader.
struct Changed<'l> {
    loader: &'l dyn Loader,
    files: BTreeMap<PathBuf, File>,
}

impl Loader for Changed<'_> {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        match self.files.get(path) {
            Some(file) => Ok(file.text.clone().into_bytes()),
            None => self.loader.load(path),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Memory(Vec<(PathBuf, String)>);

    impl Loader for Memory {
        fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
            let file = self.0.iter().find(|(p, _)| p == path);
            file.map(|(_, text)| text.clone().into_bytes()).ok_or_else(|| io::ErrorKind::NotFound.into())
        }
    }

    fn memory(files: &[(&str, &str)]) -> Memory {
        Memory(files.iter().map(|(path, text)| (PathBuf::from(path), (*text).to_owned())).collect())
    }

    #[test]
    fn imported_files_are_repaired_if_they_are_below() {
        let files = memory(&[
            ("room/main.scene", "import \"parts/a.scene\";\nimport \"../b.scene\";\nobject x;;\n"),
            ("room/parts/a.scene", "object a;;\nobject c\n"),
            ("b.scene", "object b;;\n"),
        ]);
        let path = Path::new("room/main.scene");
        let fixed = fix_all("room/main.scene", path, Options::default(), Applicability::Safe, &files);
        let texts: Vec<(&str, &str, usize)> =
            fixed.files.iter().map(|f| (f.path.to_str().unwrap(), f.text.as_str(), f.made.len())).collect();
        assert_eq!(
            texts,
            [
                ("room/main.scene", "import \"parts/a.scene\";\nimport \"../b.scene\";\nobject x;\n", 1),
                ("room/parts/a.scene", "object a;\nobject c;\n", 2),
            ]
        );
        assert_eq!(fixed.foreign, ["b.scene"]);
        assert_eq!(fixed.refused, 0);
    }

    #[test]
    fn guesses_are_made_only_where_they_are_asked_for() {
        let files = memory(&[("a.scene", "object lamp;;\nassert lapm.pos.x > 1;\nlamp.category <- \"wardrob\";\n")]);
        let path = Path::new("a.scene");
        let text = |up_to| fix_all("a.scene", path, Options::default(), up_to, &files).files[0].text.clone();
        assert_eq!(text(Applicability::Safe), "object lamp;\nassert lapm.pos.x > 1;\nlamp.category <- \"wardrob\";\n");
        assert_eq!(
            text(Applicability::Unsafe),
            "object lamp;\nassert lamp.pos.x > 1;\nlamp.category <- \"wardrobe\";\n"
        );
    }

    #[test]
    fn what_is_below_a_folder() {
        let cases =
            [("", "a.scene", true), ("", "b/a.scene", true), ("", "../a.scene", false), ("b", "a.scene", false)];
        for (folder, file, expected) in cases {
            assert_eq!(is_below(Path::new(folder), Path::new(file)), expected, "{folder} {file}");
        }
    }
}
