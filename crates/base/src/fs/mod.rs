//! File writes that happen whole or not at all: a temporary file in the same folder, then a rename. What a process that
//! was killed within a write has left, the next write into the folder takes away.
//!
//! A link stays and the file it leads to is replaced; a read-only file stays as it is; the mode and the owner of a file
//! that is replaced are kept. What is no file (a pipe, a device) is written to plainly.

mod parts;
mod target;

use parts::PartialFile;
pub use parts::end;
use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use target::WriteTarget;

/// Writes `bytes` to `path`; on any failure the old file, if there was one, is untouched.
///
/// # Errors
/// What the file system says, with the path in front.
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    write_set(&[(path.to_path_buf(), bytes)])
}

/// Writes several files. All are made under temporary names before the first one replaces an old one, so a disk that is
/// full, or a file that is read-only, leaves all of them as they were.
///
/// # Errors
/// What the file system says, with the path in front; and which files are new, if some are.
pub fn write_set(files: &[(PathBuf, &[u8])]) -> io::Result<()> {
    write(files, false)
}

/// Writes a file that others cannot read, unless they could read the one that it replaces.
///
/// # Errors
/// As for [`write_whole`].
pub fn write_private(path: &Path, bytes: &[u8]) -> io::Result<()> {
    write(&[(path.to_path_buf(), bytes)], true)
}

fn write(files: &[(PathBuf, &[u8])], private: bool) -> io::Result<()> {
    let mut ready = Vec::with_capacity(files.len());
    for (path, bytes) in files {
        ready.push(prepare(path, bytes, private).map_err(|e| tell(path, &e))?);
    }
    let paths: Vec<&Path> = files.iter().map(|(path, _)| path.as_path()).collect();
    parts::replace(ready, &paths).map_err(|(at, e)| {
        let told = tell(paths[at], &e);
        if at == 0 {
            return told;
        }
        let new: Vec<String> = paths[..at].iter().map(|p| p.display().to_string()).collect();
        io::Error::new(
            told.kind(),
            format!("{told}; these files are new; all others are unchanged: {}", new.join(", ")),
        )
    })
}

/// A file that is ready to replace another, or the stream that is to be written to.
enum Ready<'a> {
    Part(PartialFile),
    Plain(WriteTarget, &'a [u8]),
}

fn tell(path: &Path, e: &io::Error) -> io::Error {
    io::Error::new(e.kind(), format!("cannot write {}: {}", path.display(), plain(e)))
}

/// A fault without the number that the system gives it.
fn plain(e: &io::Error) -> String {
    let said = e.to_string();
    said.split_once(" (os error").map_or(said.clone(), |(text, _)| text.to_lowercase())
}

/// Removes what a process left in these folders that was ended while it wrote there.
pub fn sweep<'a>(folders: impl IntoIterator<Item = &'a Path>) {
    folders.into_iter().for_each(parts::sweep);
}

fn prepare<'a>(path: &Path, bytes: &'a [u8], private: bool) -> io::Result<Ready<'a>> {
    let (path, old) = match target::of(path)? {
        WriteTarget::File { path, old } => (path, old),
        stream => return Ok(Ready::Plain(stream, bytes)),
    };
    let folder = folder_of(&path);
    std::fs::create_dir_all(folder)?;
    parts::sweep(folder);
    let mut part = PartialFile::new(folder, &path, private || old.is_some())?;
    part.write(bytes)?;
    if let Some(old) = &old {
        target::keep(part.file(), old)?;
    }
    // Before the rename: after a crash of the machine there must not be an empty file in place of the old one.
    part.file().sync_all()?;
    part.complete();
    Ok(Ready::Part(part))
}

impl WriteTarget {
    fn write(&self, bytes: &[u8]) -> io::Result<()> {
        match self {
            Self::Stdout => io::stdout().write_all(bytes).and_then(|()| io::stdout().flush()),
            Self::Stderr => io::stderr().write_all(bytes),
            Self::Plain(path) | Self::File { path, .. } => {
                let mut file = open_plainly(path)?;
                file.write_all(bytes)
            }
        }
    }
}

/// Opens what is written to as it is. Opening a pipe waits for somebody who reads it, unless told not to: nobody may.
#[cfg(unix)]
fn open_plainly(path: &Path) -> io::Result<File> {
    use rustix::fs::{OFlags, fcntl_getfl, fcntl_setfl};
    use std::os::unix::fs::OpenOptionsExt;
    let flags = OFlags::NONBLOCK.bits().cast_signed();
    let opened = File::options().write(true).truncate(true).custom_flags(flags).open(path);
    let file = opened.map_err(|e| match e.raw_os_error() {
        Some(code) if code == rustix::io::Errno::NXIO.raw_os_error() => {
            io::Error::new(io::ErrorKind::BrokenPipe, "no process is reading from this pipe; start the reader first")
        }
        _ => e,
    })?;
    // From here on a slow reader is waited for.
    fcntl_setfl(&file, fcntl_getfl(&file)? - OFlags::NONBLOCK)?;
    Ok(file)
}

#[cfg(not(unix))]
fn open_plainly(path: &Path) -> io::Result<File> {
    File::options().write(true).truncate(true).open(path)
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// Whether two paths lead to the same file, by whatever way: `./a` and `a`, a link and what it leads to, two names of one
/// file.
pub fn is_same(a: &Path, b: &Path) -> bool {
    #[cfg(unix)]
    if let (Ok(a), Ok(b)) = (std::fs::metadata(a), std::fs::metadata(b)) {
        use std::os::unix::fs::MetadataExt;
        return a.is_file() && (a.dev(), a.ino()) == (b.dev(), b.ino());
    }
    a == b || a.canonicalize().is_ok_and(|a| b.canonicalize().is_ok_and(|b| a == b))
}

/// Whether a path leads to something that is no file and no folder: a pipe, a device, a stream of this process.
pub fn is_stream(path: &Path) -> bool {
    matches!(target::of(path), Ok(WriteTarget::Stdout | WriteTarget::Stderr | WriteTarget::Plain(_)))
}

#[cfg(test)]
mod tests;
