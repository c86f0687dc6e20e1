//! A layout with its program, judged and ready to be shown or written in other formats.

use crate::settings;
use crate::watch::{Seen, Watched};
use scenelang_analysis::Question;
use scenelang_base::door::Door;
use scenelang_base::{Diagnostic, FileId};
use scenelang_export::{Scene, SceneInput};
use scenelang_lang::program::Program;
use scenelang_lang::sources::Loader;
use scenelang_layout::Layout;
use scenelang_verify::report::{self, Human};
use scenelang_verify::settings::Settings;
use scenelang_verify::{Checked, Detail, Options};
use std::io;
use std::path::{Path, PathBuf};

/// A layout with its program, checked.
pub struct CheckedLayout {
    pub path: PathBuf,
    /// All files read, and what holds.
    pub checked: Checked,
    /// How it was judged.
    pub options: Options,
    pub program: Program,
    /// Where everything is.
    pub layout: Layout,
}

impl CheckedLayout {
    /// Reads and judges a layout, or the layout beside a program.
    ///
    /// # Errors
    /// What is wrong with it, for people: a line for each error.
    pub fn read(path: &Path, seen: Option<&Seen>) -> Result<Self, String> {
        let path = layout_of(path);
        let door = Door::of(&path);
        match seen {
            Some(seen) => Self::judge(path, &door, &Watched { seen, door: &door }),
            None => Self::judge(path, &door, &door),
        }
    }

    /// The same room with another text in place of its layout file's.
    ///
    /// # Errors
    /// As for [`CheckedLayout::read`].
    pub fn with_layout(&self, text: &str) -> Result<Self, String> {
        let door = Door::of(&self.path);
        Self::judge(self.path.clone(), &door, &Instead { path: &self.path, text, door: &door })
    }

    /// Judges a layout whose files come from `loader`.
    ///
    /// # Errors
    /// As for [`CheckedLayout::read`].
    pub fn judge(path: PathBuf, door: &Door, loader: &dyn Loader) -> Result<Self, String> {
        let name = path.display().to_string();
        let found = settings::find(door, loader);
        let (given, detail, compile) = (Settings::default(), Detail::default(), scenelang_lang::Options::default());
        let question = Question { name: &name, path: &path, given: &given, detail, compile };
        let mut checked = scenelang_analysis::judge(&question, &found, loader);
        let options = found.judging(&given).options;
        let whole = !checked.verdict.diagnostics.iter().any(Diagnostic::is_error);
        match (checked.program.take(), checked.layout.take()) {
            (Some(program), Some(layout)) if whole => Ok(Self { path, checked, options, program, layout }),
            _ => Err(report::compact(&checked.report, Human { color: false, all: false }).trim_end().to_owned()),
        }
    }

    /// The layout file as it was read, and the file itself.
    pub fn text(&self) -> &str {
        self.checked.sources.iter().find(|(_, file)| file.path() == self.path).map_or("", |(_, file)| file.text())
    }

    /// The stem of its files: `study` of `study.layout.json`.
    pub fn stem(&self) -> String {
        let name = self.path.file_name().map_or_else(Default::default, |name| name.to_string_lossy());
        name.strip_suffix(".json").map_or(&*name, |name| name.strip_suffix(".layout").unwrap_or(name)).to_owned()
    }

    /// What exporters need.
    ///
    /// # Errors
    /// Something is not placed, or a floor is no polygon.
    pub fn scene(&self) -> Result<Scene, String> {
        let sources = &self.checked.sources;
        let files: Vec<FileId> = sources.iter().filter(|(_, f)| f.path() != self.path).map(|(id, _)| id).collect();
        let report = serde_json::to_value(&self.checked.report).map_err(|e| e.to_string())?;
        let input = SceneInput {
            name: &self.stem(),
            program: &self.program,
            sources,
            files: &files,
            layout: &self.layout,
            layout_text: self.text(),
            report: &report,
        };
        Scene::build(&input).map_err(|e| e.to_string())
    }
}

/// The files of a door, but one that has another text.
struct Instead<'a> {
    path: &'a Path,
    text: &'a str,
    door: &'a Door,
}

impl Loader for Instead<'_> {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        if path == self.path { Ok(self.text.as_bytes().to_vec()) } else { self.door.load(path) }
    }
}

/// The layout that is meant: the file itself, or the one beside a program.
pub fn layout_of(path: &Path) -> PathBuf {
    let program = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("scene"));
    if program { path.with_extension("layout.json") } else { path.to_path_buf() }
}
