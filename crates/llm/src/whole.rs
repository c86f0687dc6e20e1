//! Files written whole: a temporary file in the same folder, then a rename, so that a reader never sees a half of one.

use crate::error::Error;
use std::io::{self, Write};
use std::path::Path;

/// Writes a file and the folders above it. Others cannot read it: it holds what somebody said to a model.
///
/// # Errors
/// What the file system says.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let write = || -> io::Result<()> {
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        std::fs::create_dir_all(folder)?;
        let mut file = tempfile::Builder::new().prefix(".scenelang-").tempfile_in(folder)?;
        file.write_all(bytes)?;
        file.persist(path).map_err(|e| e.error)?;
        Ok(())
    };
    write().map_err(|e| Error::File(format!("cannot write {}: {e}", path.display())))
}
