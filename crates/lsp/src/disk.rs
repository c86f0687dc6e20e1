//! Files: addresses of documents as paths and back, open buffers before the disk, settings, and what lies in the folders of
//! a workspace.

use crate::reading::Reading;
use crate::text::Text;
use scenelang_analysis::Found;
use scenelang_base::door::{Door, Named};
use scenelang_lang::sources::{Loader, normal};
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
pub struct Files {
    /// Of open documents, by path.
    pub texts: Arc<BTreeMap<PathBuf, Arc<Text>>>,
    /// Folders of the workspace.
    pub named: Arc<Named>,
    /// Who reads for a thread that must not wait.
    pub reading: Option<Arc<Reading>>,
}

impl Files {
    /// The files that a program, or what belongs to it, may name.
    pub fn of(&self, path: &Path) -> Reach {
        Reach { files: self.clone(), door: Arc::new(Door::of(path).named(&self.named)) }
    }
}

/// The files of one workspace: open texts before the disk.
#[derive(Clone)]
pub struct Reach {
    files: Files,
    door: Arc<Door>,
}

impl Reach {
    /// What may be read and written.
    pub fn door(&self) -> &Arc<Door> {
        &self.door
    }

    /// Whether there is such a file, open or not.
    pub fn has(&self, path: &Path) -> bool {
        self.files.texts.contains_key(path) && self.door.permits(path).is_ok() || self.door.is_file(path)
    }
}

impl Loader for Reach {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        // What has no file names none.
        if !path.is_absolute() {
            return Err(io::ErrorKind::NotFound.into());
        }
        let (text, door, path) = (self.files.texts.get(path).cloned(), Arc::clone(&self.door), path.to_owned());
        let own = path.clone();
        let read = move || match text {
            Some(text) => door.permits(&own).map(|()| text.as_str().as_bytes().to_vec()),
            None => door.read(&own),
        };
        match &self.files.reading {
            Some(reading) => reading.read(&path, read),
            None => read(),
        }
    }
}

/// The settings that count for the file of a workspace.
pub fn settings_for(reach: &Reach) -> Found {
    Found::of(reach.door(), reach, crate::documents::name_of)
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
