//! The folder that tools work in: which paths are allowed, where files come from, and what was made and not written.

use crate::replace;
use crate::room::layout_of;
use crate::settings;
use scenelang_analysis::{FileSettings, Judging, Question};
use scenelang_base::door::{Door, MARK, normal, outside};
use scenelang_engine::program_of;
use scenelang_lang::sources::Loader;
use scenelang_verify::settings::Settings;
use scenelang_verify::{Checked, Detail, Explain};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// So many files are kept in memory, the newest ones.
const KEPT: usize = 16;
/// And so much of them in all (bytes).
const KEPT_BYTES: usize = 32 << 20;
/// So many violations are explained with a move.
const EXPLAINED: usize = 5;

/// An opened folder.
pub struct Workspace {
    /// Without links.
    root: PathBuf,
    write: bool,
    /// What tools made, by path from the top, oldest first.
    kept: Mutex<Vec<(PathBuf, String)>>,
}

/// A file that is to be kept or written.
pub struct Made {
    /// Where, as a path in the workspace.
    pub path: PathBuf,
    /// What it says.
    pub text: String,
    /// Whether what is there stays its author's: then it is written without the mark of what is ours.
    pub edited: bool,
}

impl Workspace {
    /// Opens a folder and makes it the current one, so that files are called as they are from there.
    ///
    /// # Errors
    /// There is no such folder.
    pub fn open(folder: &Path, write: bool) -> Result<Self, String> {
        let said = |e: io::Error| format!("cannot open the folder {}: {e}", folder.display());
        let root = std::fs::canonicalize(folder).map_err(said)?;
        std::env::set_current_dir(&root).map_err(said)?;
        Ok(Self { root, write, kept: Mutex::default() })
    }

    /// Whether tools write files.
    pub fn writes(&self) -> bool {
        self.write
    }

    fn kept(&self) -> MutexGuard<'_, Vec<(PathBuf, String)>> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn whole(&self, path: &Path) -> PathBuf {
        normal(&self.root.join(path))
    }

    /// A path that a tool was given, as it is from the workspace.
    ///
    /// # Errors
    /// It leads outside, links included.
    pub fn path(&self, given: &str) -> Result<PathBuf, String> {
        let refused =
            || format!("`{given}` is outside the workspace {}; only files in it are used", self.root.display());
        let whole = self.whole(Path::new(given));
        let path = whole.strip_prefix(&self.root).map_err(|_| refused())?.to_path_buf();
        if path.as_os_str().is_empty() || given.contains('\0') {
            return Err(format!("`{given}` is not a file; name one such as room.scene"));
        }
        self.door(&path).permits(&path).map_err(|_| refused())?;
        Ok(path)
    }

    /// A program or a layout.
    ///
    /// # Errors
    /// It is another kind of file, or outside.
    pub fn scene_file(&self, given: &str) -> Result<PathBuf, String> {
        let path = self.path(given)?;
        if is_program(&path) || path.extension().is_some_and(|e| e.eq_ignore_ascii_case("json")) {
            return Ok(path);
        }
        Err(format!("`{given}` is neither a program (NAME.scene) nor a layout (NAME.layout.json)"))
    }

    fn door(&self, path: &Path) -> Door {
        Door::of(path).inside(&self.root)
    }

    /// The files that belong to one.
    pub fn files(&self, path: &Path) -> Files<'_> {
        Files { workspace: self, door: self.door(path), instead: None }
    }

    /// Keeps what was made in memory, or writes it, all or nothing.
    ///
    /// # Errors
    /// A file is not ours to replace, or cannot be written.
    pub fn keep(&self, made: Vec<Made>) -> Result<(), String> {
        if self.write {
            let (edited, ours): (Vec<&Made>, Vec<&Made>) = made.iter().partition(|made| made.edited);
            return replace::mixed(
                &ours.iter().map(|m| (m.path.as_path(), m.text.as_str())).collect::<Vec<_>>(),
                &edited.iter().map(|m| (m.path.as_path(), m.text.as_str())).collect::<Vec<_>>(),
            );
        }
        let mut kept = self.kept();
        for Made { path, text, .. } in made {
            let path = self.whole(&path);
            kept.retain(|(other, _)| *other != path);
            kept.push((path, text));
        }
        while kept.len() > KEPT || kept.iter().map(|(_, text)| text.len()).sum::<usize>() > KEPT_BYTES {
            kept.remove(0);
        }
        Ok(())
    }

    /// Whether a file may be made where there may be one.
    ///
    /// # Errors
    /// What is there is somebody else's.
    pub fn permit(&self, path: &Path, inputs: &[&Path]) -> Result<(), String> {
        if self.kept().iter().any(|(other, _)| *other == self.whole(path)) {
            return Ok(());
        }
        // An assistant has no `--force`.
        let said = |why: String| why.replace("use --force to overwrite it, or name another file", "name another file");
        replace::permit(path, inputs, false).map_err(said)
    }

    /// How a file is judged.
    ///
    /// # Errors
    /// The settings have errors.
    pub fn judging(&self, files: &Files<'_>) -> Result<Judging, String> {
        let found = settings::find(&files.door, files);
        if let Some(finding) = found.diagnostics.first() {
            return Err(format!("{MARK} cannot be used: {}", finding.message));
        }
        Ok(found.judging(&Settings::default()))
    }

    /// Judges a layout, or a program by the layout beside it if there is one.
    pub fn judge(&self, path: &Path, files: &Files<'_>) -> Checked {
        let beside = layout_of(path);
        let path = if files.has(&beside) { &beside } else { path };
        let found: FileSettings = settings::find(&files.door, files);
        let detail = Detail { sentences: true, explain: Explain::First(EXPLAINED), ..Detail::default() };
        let (name, given) = (called(path), Settings::default());
        let compile = scenelang_lang::Options::default();
        scenelang_analysis::judge(&Question { name: &name, path, given: &given, detail, compile }, &found, files)
    }

    /// The program of a layout, or the file itself.
    ///
    /// # Errors
    /// The layout names none that can be read.
    pub fn program(&self, path: &Path) -> Result<PathBuf, String> {
        let files = self.files(path);
        let found = program_of(&called(path), path, &files).map(|(_, program)| normal(&program));
        found.ok_or_else(|| format!("{} cannot be read or does not name a program", called(path)))
    }
}

/// Whether a file is a program by its name.
pub fn is_program(path: &Path) -> bool {
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case("scene"))
}

/// What a file is called in answers.
pub fn called(path: &Path) -> String {
    path.to_string_lossy().replace('\\', "/")
}

/// Files of a workspace: those that were made, else those on disk; one may have another text.
pub struct Files<'w> {
    workspace: &'w Workspace,
    /// What it allows.
    pub door: Door,
    instead: Option<(PathBuf, String)>,
}

impl Files<'_> {
    /// The same with another text for a file.
    #[must_use]
    pub fn with(self, path: &Path, text: String) -> Self {
        Self { instead: Some((self.workspace.whole(path), text)), ..self }
    }

    /// Whether there is such a file.
    pub fn has(&self, path: &Path) -> bool {
        self.made(path).is_some() || self.door.is_file(path)
    }

    /// The text of a file.
    ///
    /// # Errors
    /// It is not there, outside, or no text.
    pub fn text(&self, path: &Path) -> Result<String, String> {
        let said = |e: io::Error| match outside(&e) {
            _ if e.kind() == ErrorKind::NotFound => format!("there is no file {}", called(path)),
            _ => format!("cannot read {}: {e}", called(path)),
        };
        String::from_utf8(self.load(path).map_err(said)?).map_err(|_| format!("{} is not valid UTF-8", called(path)))
    }

    fn made(&self, path: &Path) -> Option<Vec<u8>> {
        let whole = self.workspace.whole(path);
        if let Some((_, text)) = self.instead.as_ref().filter(|(other, _)| *other == whole) {
            return Some(text.clone().into_bytes());
        }
        let kept = self.workspace.kept();
        kept.iter().find(|(other, _)| *other == whole).map(|(_, text)| text.clone().into_bytes())
    }
}

impl Loader for Files<'_> {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.made(path).map_or_else(|| self.door.load(path), Ok)
    }
}
