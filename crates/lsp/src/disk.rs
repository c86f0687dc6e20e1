//! Files: addresses of documents as paths and back, open buffers before the disk, settings, and what lies in the folders of
//! a workspace.

use crate::reading::Reading;
use crate::text::Text;
use scenelang_analysis::FileSettings;
use scenelang_base::door::{Door, Named};
use scenelang_lang::sources::{Loader, normal};
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};
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
    pub folders: Arc<Folders>,
    /// Who reads for those who must not wait for long.
    pub reading: Option<Arc<Reading>>,
}

impl Files {
    /// The files that a program, or what belongs to it, may name. Nothing is looked at yet.
    pub fn of(&self, path: &Path) -> Reach {
        Reach { files: self.clone(), path: path.to_owned(), door: OnceLock::new() }
    }
}

/// Folders that the user has opened, looked at when somebody needs them.
#[derive(Default)]
pub struct Folders {
    paths: Vec<PathBuf>,
    named: OnceLock<Arc<Named>>,
}

impl Folders {
    /// These folders.
    pub fn new(paths: &[PathBuf]) -> Arc<Self> {
        Arc::new(Self { paths: paths.to_vec(), named: OnceLock::new() })
    }

    fn named(&self) -> &Arc<Named> {
        self.named.get_or_init(|| Named::new(self.paths.iter().map(PathBuf::as_path)))
    }
}

/// The files of one workspace: open texts before the disk.
#[derive(Clone)]
pub struct Reach {
    files: Files,
    path: PathBuf,
    door: OnceLock<Arc<Door>>,
}

impl Reach {
    /// What may be read and written.
    pub fn door(&self) -> &Arc<Door> {
        self.door.get_or_init(|| Arc::new(Door::of(&self.path).named(self.files.folders.named())))
    }

    /// Whether there is such a file, open or not.
    pub fn has(&self, path: &Path) -> bool {
        self.files.texts.contains_key(path) && self.door().permits(path).is_ok() || self.door().is_file(path)
    }

    /// The bytes of a file, and whether it is open. Whoever reads it does something else `first`.
    pub fn load_after(&self, path: &Path, first: impl FnOnce() + Send + 'static) -> (io::Result<Vec<u8>>, bool) {
        // What has no file names none.
        if !path.is_absolute() {
            return (Err(io::ErrorKind::NotFound.into()), false);
        }
        let (text, door, own) = (self.files.texts.get(path).cloned(), Arc::clone(self.door()), path.to_owned());
        let open = text.is_some();
        let read = move || {
            first();
            match text {
                Some(text) => door.permits(&own).map(|()| text.as_str().as_bytes().to_vec()),
                None => door.read(&own),
            }
        };
        let read = match &self.files.reading {
            Some(reading) => reading.read(path, read),
            None => read(),
        };
        (read, open)
    }
}

impl Loader for Reach {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.load_after(path, || {}).0
    }
}

/// The settings that count for the file of a workspace.
pub fn settings_for(door: &Door, loader: &dyn Loader) -> FileSettings {
    FileSettings::of(door, loader, crate::documents::name_of)
}

/// What tells one state of a file from another: its time and its length; `None`: there is none.
pub type Stamp = Option<(SystemTime, u64)>;

/// What a file is now.
pub fn stamp(path: &Path) -> Stamp {
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
