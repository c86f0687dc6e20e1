//! Files: addresses of documents as paths and back, open buffers before the disk, settings, and what lies in the folders of
//! a workspace.

use crate::text::Text;
use scenelang_base::{Diagnostic, SourceFile, SourceMap, codes};
use scenelang_ide::Judging;
use scenelang_lang::sources::{Disk, Loader, normal, plain};
use scenelang_verify::settings::{self, Settings};
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::SystemTime;
use tower_lsp::ls_types::Uri;

/// At most so many programs of a workspace are looked at.
const MOST: usize = 2000;
/// Folders nested deeper are not looked into.
const DEEPEST: usize = 12;

/// The path of a document; of one that is not on this disk, something that names it.
pub fn path_of(uri: &Uri) -> PathBuf {
    let file = if is_file(uri) { uri.to_file_path() } else { None };
    file.map_or_else(|| PathBuf::from(uri.as_str()), |path| normal(&path))
}

/// Whether a document is on this disk, or could be.
pub fn is_file(uri: &Uri) -> bool {
    uri.as_str().starts_with("file:")
}

/// The address of a path.
pub fn uri_of(path: &Path) -> Option<Uri> {
    Uri::from_file_path(path)
}

/// The texts of open documents, and the disk for all others.
#[derive(Clone, Default)]
pub struct Files(pub Arc<BTreeMap<PathBuf, Arc<Text>>>);

impl Loader for Files {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        match self.0.get(path) {
            Some(text) => Ok(text.as_str().as_bytes().to_vec()),
            None => Disk.load(path),
        }
    }
}

/// The settings of a workspace as they are in the nearest `scenelang.toml`.
#[derive(Debug, Default)]
pub struct Found {
    /// The file, if there is one.
    pub file: Option<PathBuf>,
    /// Its text, for places.
    pub sources: SourceMap,
    /// What it says, or the usual where it has errors.
    pub settings: Settings,
    /// What is wrong with it.
    pub diagnostics: Vec<Diagnostic>,
}

impl Found {
    /// How layouts are judged.
    pub fn judging(&self) -> Judging {
        let mut judging = Judging { allow: self.settings.allow.clone(), ..Judging::default() };
        self.settings.apply(&mut judging.options);
        judging
    }
}

/// The settings for a file: from its folder, or the nearest one above that has any.
pub fn settings_for(path: &Path, files: &Files) -> Found {
    for folder in path.ancestors().skip(1).filter(|folder| folder.is_absolute()) {
        let file = folder.join(settings::FILE);
        let bytes = match files.load(&file) {
            Ok(bytes) => bytes,
            Err(e) if matches!(e.kind(), io::ErrorKind::NotFound | io::ErrorKind::NotADirectory) => continue,
            Err(e) => {
                let say = format!("cannot read {}: {}", settings::FILE, plain(&e));
                let diagnostics = vec![Diagnostic::without_place(codes::E0001, say)];
                return Found { file: Some(file), diagnostics, ..Found::default() };
            }
        };
        let mut sources = SourceMap::new();
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let id = sources.add(SourceFile::new(settings::FILE, &file, text));
        let (settings, diagnostics) = match settings::read(sources.get(id).text(), id) {
            Ok(settings) => (settings, Vec::new()),
            Err(found) => (Settings::default(), found),
        };
        return Found { file: Some(file), sources, settings, diagnostics };
    }
    Found::default()
}

/// What tells one state of a file from another: its time and its length; `None`: there is none.
type Stamp = Option<(SystemTime, u64)>;

/// What files were when they were looked at last, for clients that do not say when they change.
#[derive(Default)]
pub struct Stamps(BTreeMap<PathBuf, Stamp>);

impl Stamps {
    /// Remembers what files are that were read just now; those that are remembered already stay as they are.
    pub fn learn(&mut self, paths: impl Iterator<Item = PathBuf>) {
        for path in paths {
            self.0.entry(path).or_insert_with_key(|path| stamp(path));
        }
    }

    /// Looks at files; those that are other than they are remembered. Files that are no longer asked about are forgotten.
    pub fn changed(&mut self, paths: impl Iterator<Item = PathBuf>) -> Vec<PathBuf> {
        let now: BTreeMap<_, _> = paths.map(|path| (path.clone(), stamp(&path))).collect();
        let before = std::mem::replace(&mut self.0, now);
        let other = |(path, stamp): &(&PathBuf, &Stamp)| before.get(*path).is_some_and(|known| known != *stamp);
        self.0.iter().filter(other).map(|(path, _)| path.clone()).collect()
    }
}

fn stamp(path: &Path) -> Stamp {
    let data = std::fs::metadata(path).ok()?;
    Some((data.modified().ok()?, data.len()))
}

/// The programs in a folder and below, in the order of their paths. Hidden folders and what others build are passed over.
pub fn programs(root: &Path) -> Vec<PathBuf> {
    let mut out = Vec::new();
    let mut folders = vec![(root.to_path_buf(), 0)];
    while let Some((folder, depth)) = folders.pop() {
        let Ok(entries) = std::fs::read_dir(&folder) else { continue };
        for entry in entries.flatten() {
            let Ok(kind) = entry.file_type() else { continue };
            let name = entry.file_name();
            let name = name.to_string_lossy();
            if kind.is_dir() && depth < DEEPEST && !name.starts_with('.') && name != "node_modules" && name != "target"
            {
                folders.push((entry.path(), depth + 1));
            } else if kind.is_file() && name.ends_with(".scene") {
                out.push(entry.path());
            }
            if out.len() == MOST {
                break;
            }
        }
    }
    out.sort_unstable();
    out
}
