//! File writes that happen whole or not at all: a temporary file in the same folder, then a rename.

use std::io::{self, Write};
use std::path::Path;

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
    let mut file = tempfile::Builder::new().prefix(".scenelang-").tempfile_in(folder).map_err(tell)?;
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
}
