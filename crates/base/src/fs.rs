//! File writes that happen whole or not at all: a temporary file in the same folder, then a rename. What a process that
//! was killed within a write has left, the next write into the folder takes away.

use std::ffi::OsStr;
use std::fs::File;
use std::io::{self, Write};
use std::path::Path;
use std::time::{Duration, SystemTime};

/// Temporary files are called this, six letters or digits, and [`SUFFIX`].
const PREFIX: &str = ".scenelang-";
/// How the name of a temporary file ends.
const SUFFIX: &str = ".part";
/// How long a temporary file is left alone that nobody seems to write: between its making and its lock nothing shows that
/// somebody does.
const GRACE: Duration = Duration::from_secs(60);

/// Writes `bytes` to `path`; on any failure the old file, if there was one, is untouched.
///
/// # Errors
/// What the file system says, with the path in front.
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let folder = match path.parent() {
        Some(p) if !p.as_os_str().is_empty() => p,
        _ => Path::new("."),
    };
    let tell = |e: io::Error| io::Error::new(e.kind(), format!("cannot write {}: {e}", path.display()));
    std::fs::create_dir_all(folder).map_err(tell)?;
    sweep(folder);
    let mut file = tempfile::Builder::new().prefix(PREFIX).suffix(SUFFIX).tempfile_in(folder).map_err(tell)?;
    // The lock ends with the process, however that ends. Where there are no locks, nothing is ever swept.
    let _ = file.as_file().try_lock();
    file.write_all(bytes).map_err(tell)?;
    // A temporary file is private; what we leave should have the usual permissions, or those it had before.
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let mode = std::fs::metadata(path).map_or(0o644, |m| m.permissions().mode() & 0o777);
        file.as_file().set_permissions(std::fs::Permissions::from_mode(mode)).map_err(tell)?;
    }
    file.persist(path).map_err(|e| tell(e.error))?;
    Ok(())
}

/// Removes temporary files of processes that are gone. Whatever cannot be looked at or removed stays: it is in nobody's way.
fn sweep(folder: &Path) {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn replaces_a_file_and_leaves_nothing_else() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("deep/er/a.txt");
        write_whole(&path, b"one").unwrap();
        write_whole(&path, b"two").unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"two");
        assert_eq!(std::fs::read_dir(path.parent().unwrap()).unwrap().count(), 1);
    }

    #[test]
    fn a_failed_write_says_the_path() {
        let dir = tempfile::tempdir().unwrap();
        let e = write_whole(dir.path(), b"x").unwrap_err();
        assert!(e.to_string().contains(&dir.path().display().to_string()), "{e}");
    }

    #[test]
    fn what_a_killed_process_left_is_swept() {
        let dir = tempfile::tempdir().unwrap();
        let made = |name: &str, age: u64| {
            let file = File::create(dir.path().join(name)).unwrap();
            file.set_modified(SystemTime::now() - Duration::from_secs(age)).unwrap();
            file
        };
        let written = made(".scenelang-wRiTe1.part", 600);
        written.lock().unwrap();
        for (name, age) in [
            (".scenelang-aB3dE6.part", 600),
            (".scenelang-young1.part", 5),
            // Ours are not called like this.
            (".scenelang-backup", 600),
            (".scenelang-seven77.part", 600),
            (".scenelang-a.b_c1.part", 600),
            ("scenelang-aB3dE6.part", 600),
        ] {
            made(name, age);
        }
        std::fs::create_dir(dir.path().join(".scenelang-folder.part")).unwrap();
        write_whole(&dir.path().join("room.scene"), b"").unwrap();
        let mut left: Vec<String> = std::fs::read_dir(dir.path())
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        left.sort();
        let expected = [
            ".scenelang-a.b_c1.part",
            ".scenelang-backup",
            ".scenelang-folder.part",
            ".scenelang-seven77.part",
            ".scenelang-wRiTe1.part",
            ".scenelang-young1.part",
            "room.scene",
            "scenelang-aB3dE6.part",
        ];
        assert_eq!(left, expected);
    }
}
