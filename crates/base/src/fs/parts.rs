//! Temporary files: made, known while they last, given their names or taken away.
//!
//! All that this process is writing is in one list behind a lock, and temporary files are made, renamed and removed only
//! under that lock. So a process that has to end at once can take the lock, remove what is unfinished, and say what is
//! finished.

use super::{Ready, folder_of};
use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, SystemTime};
use tempfile::{NamedTempFile, TempPath};

/// Temporary files are called this, six letters or digits, and [`SUFFIX`].
const PREFIX: &str = ".scenelang-";
/// How the name of a temporary file ends.
const SUFFIX: &str = ".part";
/// How long a temporary file is left alone that nobody seems to write: between its making and its lock nothing shows that
/// somebody does, and a file of a set that is complete waits for the others without one.
const GRACE: Duration = Duration::from_secs(60);

/// What this process writes.
#[derive(Default)]
struct Writing {
    /// Temporary files that are there now.
    unfinished: BTreeSet<PathBuf>,
    /// Files that were written, in order.
    finished: Vec<PathBuf>,
    /// Nothing more is to be written.
    over: bool,
}

static WRITING: Mutex<Writing> = Mutex::new(Writing { unfinished: BTreeSet::new(), finished: Vec::new(), over: false });

fn writing() -> MutexGuard<'static, Writing> {
    let guard = WRITING.lock().unwrap_or_else(PoisonError::into_inner);
    if guard.over {
        drop(guard);
        // The process ends; whoever ends it decides how.
        loop {
            std::thread::park();
        }
    }
    guard
}

/// Ends all writing of this process for good: what is unfinished is removed, and whoever wants to write waits for the end
/// of the process. Which files were written before.
pub fn end() -> Vec<PathBuf> {
    let mut writing = WRITING.lock().unwrap_or_else(PoisonError::into_inner);
    writing.over = true;
    for path in std::mem::take(&mut writing.unfinished) {
        let _ = std::fs::remove_file(path);
    }
    std::mem::take(&mut writing.finished)
}

/// A file under a temporary name. Dropped, it is gone.
pub(super) struct PartialFile {
    /// Open until it is complete.
    file: Option<File>,
    temporary: Option<TempPath>,
    /// Its name to be.
    path: PathBuf,
}

impl PartialFile {
    /// An empty file in `folder`. `private`: nobody else may read it, unless it gets another mode later.
    pub(super) fn new(folder: &Path, path: &Path, private: bool) -> io::Result<Self> {
        let mut builder = tempfile::Builder::new();
        builder.prefix(PREFIX).suffix(SUFFIX);
        #[cfg(unix)]
        if !private {
            use std::os::unix::fs::PermissionsExt;
            // The system takes away what the user's umask says.
            builder.permissions(std::fs::Permissions::from_mode(0o666));
        }
        #[cfg(not(unix))]
        let _ = private;
        let mut writing = writing();
        let made: NamedTempFile = builder.tempfile_in(folder)?;
        writing.unfinished.insert(made.path().to_path_buf());
        drop(writing);
        let (file, temporary) = made.into_parts();
        // The lock ends with the process, however that ends. Where there are no locks, nothing is ever swept.
        let _ = file.try_lock();
        Ok(Self { file: Some(file), temporary: Some(temporary), path: path.to_path_buf() })
    }

    pub(super) fn file(&self) -> &File {
        self.file.as_ref().expect("it is closed only when it is complete")
    }

    pub(super) fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.file().write_all(bytes)
    }

    /// Closes the file: a set may have more files than a process may have open.
    pub(super) fn complete(&mut self) {
        self.file = None;
    }
}

impl Drop for PartialFile {
    fn drop(&mut self) {
        if let Some(temporary) = self.temporary.take() {
            let mut writing = writing();
            writing.unfinished.remove(&*temporary);
            drop(temporary);
        }
    }
}

/// Gives files their names, one after the other. `named`: how they were called by whoever asked.
///
/// # Errors
/// The first that could not be given its name, and why.
pub(super) fn replace(ready: Vec<Ready<'_>>, named: &[&Path]) -> Result<(), (usize, io::Error)> {
    let mut folders = BTreeSet::new();
    let mut parts = Vec::new();
    for (at, ready) in ready.into_iter().enumerate() {
        match ready {
            Ready::Part(part) => parts.push((at, part)),
            // Whoever reads a pipe may take long: nobody waits for the lock meanwhile.
            Ready::Plain(target, bytes) => target.write(bytes).map_err(|e| (at, e))?,
        }
    }
    let mut failed = None;
    let mut writing = writing();
    for (at, part) in &mut parts {
        let Some(temporary) = part.temporary.take() else { continue };
        let from = temporary.to_path_buf();
        match temporary.persist(&part.path) {
            Ok(()) => {
                writing.unfinished.remove(&from);
                writing.finished.push(named[*at].to_path_buf());
                folders.insert(folder_of(&part.path).to_path_buf());
            }
            Err(e) => {
                part.temporary = Some(e.path);
                failed = Some((*at, e.error));
                break;
            }
        }
    }
    drop(writing);
    drop(parts);
    // So that the new names, too, outlast a crash of the machine. Not every file system can; the files are whole anyway.
    for folder in folders {
        let _ = File::open(folder).and_then(|folder| folder.sync_all());
    }
    failed.map_or(Ok(()), Err)
}

/// Removes temporary files of processes that are gone. Whatever cannot be looked at or removed stays: it is in nobody's way.
pub(super) fn sweep(folder: &Path) {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    for entry in entries.filter(|entry| is_temporary(&entry.file_name())) {
        if is_left(&entry) {
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

/// Whether a file is called as our temporary files are.
fn is_temporary(name: &OsStr) -> bool {
    let random = name.to_str().and_then(|name| name.strip_prefix(PREFIX)?.strip_suffix(SUFFIX));
    random.is_some_and(|random| random.len() == 6 && random.bytes().all(|b| b.is_ascii_alphanumeric()))
}

/// Whether nobody writes a temporary file any more: it has been still for a while, and is not locked.
fn is_left(entry: &std::fs::DirEntry) -> bool {
    let Some(data) = entry.metadata().ok().filter(std::fs::Metadata::is_file) else { return false };
    let age = data.modified().ok().and_then(|at| SystemTime::now().duration_since(at).ok());
    age.is_some_and(|age| age > GRACE) && File::open(entry.path()).is_ok_and(|file| file.try_lock().is_ok())
}
