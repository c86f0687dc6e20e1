//! Files written whole, so that a reader never sees a half of one.

use crate::error::Error;
use scenelang_base::fs::write_private;
use std::path::Path;

/// Writes a file and the folders above it. Others cannot read it: it holds what somebody said to a model.
///
/// # Errors
/// What the file system says.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    write_private(path, bytes).map_err(|e| Error::File(e.to_string()))
}
