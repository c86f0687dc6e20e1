//! What a path leads to: a file that can be replaced, or something that is written to plainly. Nothing is changed here,
//! but for the mode and the owner of a temporary file.

use std::fs::{self, File, Metadata};
use std::io;
use std::path::{Path, PathBuf};

/// Where bytes go.
#[derive(Debug)]
pub(super) enum WriteTarget {
    /// Standard output: a second handle would write over what was printed.
    Stdout,
    /// Standard error.
    Stderr,
    /// A pipe, a device, or a file that somebody else holds open for us (`/dev/fd/3`).
    Plain(PathBuf),
    /// A file, links followed, and what is known of the one that is there.
    File { path: PathBuf, old: Option<Metadata> },
}

/// What a path leads to.
///
/// # Errors
/// Why nothing can be written there.
pub(super) fn of(path: &Path) -> io::Result<WriteTarget> {
    if cfg!(unix) {
        let is = |names: [&str; 3]| names.iter().any(|name| path == Path::new(name));
        if is(["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"]) {
            return Ok(WriteTarget::Stdout);
        }
        if is(["/dev/stderr", "/dev/fd/2", "/proc/self/fd/2"]) {
            return Ok(WriteTarget::Stderr);
        }
    }
    let refuse = |kind: io::ErrorKind, why: String| Err(io::Error::new(kind, why));
    match fs::metadata(path) {
        Ok(data) if data.is_dir() => refuse(io::ErrorKind::IsADirectory, "it is a folder".to_owned()),
        Ok(data) if !data.is_file() || is_handle(path) => Ok(WriteTarget::Plain(path.to_path_buf())),
        Ok(data) => {
            let real = if is_link(path) { path.canonicalize()? } else { path.to_path_buf() };
            if is_read_only(&real, &data) {
                let say = "it is read-only; make it writable, or name another file".to_owned();
                return refuse(io::ErrorKind::PermissionDenied, say);
            }
            Ok(WriteTarget::File { path: real, old: Some(data) })
        }
        Err(e) if e.kind() == io::ErrorKind::NotFound => match fs::read_link(path) {
            // Where the link leads was not decided by whoever runs this, and there is no file that could be compared.
            Ok(to) => {
                let say = format!(
                    "it is a link to {}, which does not exist; make that file, or remove the link",
                    to.display()
                );
                refuse(io::ErrorKind::NotFound, say)
            }
            Err(_) => Ok(WriteTarget::File { path: path.to_path_buf(), old: None }),
        },
        Err(e) => Err(e),
    }
}

/// Whether a path is that of an open file of this process.
fn is_handle(path: &Path) -> bool {
    cfg!(unix) && (path.starts_with("/dev/fd") || path.starts_with("/proc/self/fd"))
}

fn is_link(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|data| data.is_symlink())
}

/// Whether a file may not be written to: its mode says so, or the system. The superuser could, but was not asked.
fn is_read_only(path: &Path, data: &Metadata) -> bool {
    let denied = |e: io::Error| matches!(e.kind(), io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem);
    data.permissions().readonly() || File::options().write(true).open(path).is_err_and(denied)
}

/// Gives a temporary file the owner and the mode of the file that it will replace.
///
/// # Errors
/// The file would get another owner.
pub(super) fn keep(file: &File, old: &Metadata) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt, fchown};
        let new = file.metadata()?;
        if new.uid() != old.uid() && fchown(file, Some(old.uid()), None).is_err() {
            let say = "it belongs to another user, and replacing it would make it yours; name another file";
            return Err(io::Error::new(io::ErrorKind::PermissionDenied, say));
        }
        if new.gid() != old.gid() {
            // Only members of a group may give files to it.
            let _ = fchown(file, None, Some(old.gid()));
        }
    }
    file.set_permissions(old.permissions())
}
