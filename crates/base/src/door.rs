//! The one door to the disk. Every file that a command or the server reads or writes goes through a [`Door`], which knows
//! its root: the folder that files may not lead out of.
//!
//! A path that the user names is allowed. A path that a file names (an import, the program of a layout, a setting of the
//! editor) must stay below the root, whatever `..`, absolute paths and links it is made of. Only regular files are read,
//! without waiting for anybody to write them, and only so much of them, whatever length they claim to have.
//!
//! Absent here: which files there are to read, and what is said of those that are refused.

mod place;
mod read;

pub use place::{FilePlace, MARK};
pub use read::MOST;

use std::collections::BTreeSet;
use std::error::Error;
use std::fmt;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, OnceLock};

/// Files that the user has named on the command line, and folders that were named or opened.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Named {
    folders: Vec<PathBuf>,
    /// Without links.
    files: BTreeSet<PathBuf>,
}

impl Named {
    /// What these paths name. A file that is a link out of its own workspace was not named by the user but by whoever made
    /// the link.
    pub fn new<'p>(paths: impl IntoIterator<Item = &'p Path>) -> Arc<Self> {
        let mut out = Self::default();
        for path in paths {
            if path.is_dir() {
                out.folders.push(whole(path));
            } else if let Ok(real) = Door::of(path).resolve(path) {
                out.files.insert(real);
            }
        }
        Arc::new(out)
    }
}

/// Reads and writes the files of one workspace.
#[derive(Debug)]
pub struct Door {
    /// The file or folder that it was made for.
    path: PathBuf,
    /// The root, where it is not to be looked for.
    fixed: Option<PathBuf>,
    /// The folder that is never left, whatever is around it.
    inside: Option<PathBuf>,
    /// What else the user has named.
    named: Arc<Named>,
    /// Looked for when the first file is asked for.
    place: OnceLock<FilePlace>,
}

impl Door {
    /// The door of a file or folder that the user names, or that was found in one.
    pub fn of(path: &Path) -> Self {
        let path = whole(path);
        Self { path, fixed: None, inside: None, named: Arc::default(), place: OnceLock::new() }
    }

    /// A door whose root is this folder, which the user has named, and which need not be there. If it is a link out of the
    /// workspace that it stands in, nothing is written through it: who made it may be somebody else.
    pub fn within(folder: &Path) -> Self {
        let folder = whole(folder);
        let above = FilePlace::of(folder.parent().unwrap_or(&folder), &[]).root;
        let leads_out = !nearest(&folder).starts_with(nearest(&above));
        Self { fixed: Some(if leads_out { above } else { folder.clone() }), ..Self::of(&folder) }
    }

    /// Allows what else the user has named.
    #[must_use]
    pub fn named(self, named: &Arc<Named>) -> Self {
        Self { named: Arc::clone(named), place: OnceLock::new(), ..self }
    }

    /// Keeps to this folder, which the user has opened, even if it is part of a larger workspace; only the settings of that
    /// one still count.
    #[must_use]
    pub fn inside(self, folder: &Path) -> Self {
        let folder = whole(folder);
        let named = Named { folders: vec![folder.clone()], files: BTreeSet::new() };
        Self { inside: Some(folder), named: Arc::new(named), place: OnceLock::new(), ..self }
    }

    /// The folder that files may not lead out of.
    pub fn root(&self) -> &Path {
        &self.place().root
    }

    /// Where settings for its file may be, nearest first.
    pub fn settings(&self) -> &[PathBuf] {
        &self.place().settings
    }

    fn place(&self) -> &FilePlace {
        self.place.get_or_init(|| match &self.fixed {
            Some(folder) => FilePlace { root: folder.clone(), settings: Vec::new() },
            None => {
                let mut place = FilePlace::of(&self.path, &self.named.folders);
                if let Some(folder) = self.inside.as_ref().filter(|folder| !place.root.starts_with(folder)) {
                    place.root.clone_from(folder);
                }
                place
            }
        })
    }

    /// The bytes of a file.
    ///
    /// # Errors
    /// It is outside the root ([`outside`]), no regular file, too large, or what the file system says.
    pub fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        read::regular(&self.resolve(path)?)
    }

    /// Writes a file, whole or not at all, and makes the folders that it is in.
    ///
    /// # Errors
    /// It is outside the root, or what the file system says; with the path in front.
    pub fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        match self.permits(path) {
            Err(e) => Err(io::Error::new(e.kind(), format!("cannot write {}: {e}", path.display()))),
            // What is not there is made; what cannot be looked at is for the writing to say.
            Ok(()) => crate::fs::write_whole(path, bytes),
        }
    }

    /// Whether a path may be read or written, whatever is there.
    ///
    /// # Errors
    /// It is outside the root ([`outside`]).
    pub fn permits(&self, path: &Path) -> io::Result<()> {
        match self.resolve(path) {
            Err(e) if outside(&e).is_some() => Err(e),
            _ => Ok(()),
        }
    }

    /// Whether there is a regular file that may be read.
    pub fn is_file(&self, path: &Path) -> bool {
        self.resolve(path).is_ok_and(|real| real.is_file())
    }

    /// The path without links.
    fn resolve(&self, path: &Path) -> io::Result<PathBuf> {
        let absolute = std::path::absolute(path)?;
        let found = std::fs::canonicalize(&absolute);
        let real = match &found {
            Ok(real) => real.clone(),
            // Of what is not there, the folders count that are: whether something is there outside is not told.
            Err(_) => nearest(&normal(&absolute)),
        };
        if !self.allows(&real) {
            let refused = Outside { path: normal(path), root: self.root().to_path_buf() };
            return Err(io::Error::new(io::ErrorKind::PermissionDenied, refused));
        }
        found
    }

    fn allows(&self, real: &Path) -> bool {
        let settings = |file: &PathBuf| file.parent().is_some_and(|folder| real == nearest(folder).join(MARK));
        let root = nearest(self.root());
        // A file at the very top does not make a workspace of the whole disk.
        let below = real.starts_with(&root) && (root.parent().is_some() || real == self.path);
        // A folder inside may be a link out of it, and have settings.
        let inside = self.inside.as_ref().is_none_or(|folder| real.starts_with(nearest(folder)));
        below && inside
            || self.named.files.contains(real)
            || real.ends_with(MARK) && self.settings().iter().any(settings)
    }
}

/// A path that leads out of the root.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outside {
    /// The path as it was asked for.
    pub path: PathBuf,
    /// The folder that it leads out of.
    pub root: PathBuf,
}

impl Outside {
    /// What to do about it.
    pub fn advice(&self) -> String {
        format!(
            "only files in {} are read and written; move the file there, name it on the command line, or put a \
             {MARK} (which may be empty) into the folder that contains both",
            self.root.display()
        )
    }
}

impl fmt::Display for Outside {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "it leads outside the workspace {}", self.root.display())
    }
}

impl Error for Outside {}

/// Where a path leads, if an error says that it leads out of the root.
pub fn outside(e: &io::Error) -> Option<&Outside> {
    e.get_ref()?.downcast_ref()
}

/// The path without `.` and, where possible, without `..`; not resolved on disk.
pub fn normal(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir if matches!(out.components().next_back(), Some(Component::Normal(_))) => {
                out.pop();
            }
            // There is nothing above the top.
            Component::ParentDir if out.has_root() => {}
            other => out.push(other),
        }
    }
    out
}

/// A path as seen from a folder, with `/` between the parts; both from the same start.
pub fn relative(path: &Path, folder: &Path) -> String {
    let shared = path.components().zip(folder.components()).take_while(|(a, b)| a == b).count();
    let up = folder.components().skip(shared).map(|_| "..".as_ref());
    let down = path.components().skip(shared).map(|c| c.as_os_str());
    up.chain(down).collect::<PathBuf>().to_string_lossy().replace('\\', "/")
}

/// The path from the top.
fn whole(path: &Path) -> PathBuf {
    normal(&std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf()))
}

/// The path without links, as far as it is there.
fn nearest(path: &Path) -> PathBuf {
    for above in path.ancestors() {
        if let (Ok(real), Ok(rest)) = (std::fs::canonicalize(above), path.strip_prefix(above)) {
            return if rest.as_os_str().is_empty() { real } else { real.join(rest) };
        }
    }
    path.to_path_buf()
}

#[cfg(test)]
mod tests;
