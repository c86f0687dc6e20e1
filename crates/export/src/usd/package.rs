//! A USDZ package: a ZIP archive without compression, in which each file begins at a multiple of 64 bytes.

use crate::ExportError;
use std::io::{Cursor, Write};
use zip::write::{SimpleFileOptions, ZipWriter};
use zip::{CompressionMethod, DateTime};

/// Where files begin.
const ALIGNMENT: u16 = 64;

/// A package of files, by their paths; the first one is its layer.
///
/// # Errors
/// A file has more than 4 GB.
pub(super) fn of(files: &[(String, Vec<u8>)]) -> Result<Vec<u8>, ExportError> {
    let fail = |e: &dyn std::fmt::Display| ExportError::Format("usdz", format!("the package cannot be written: {e}"));
    // Always the same time, so that the same scene gives the same bytes.
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .with_alignment(ALIGNMENT)
        .last_modified_time(DateTime::default());
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (path, bytes) in files {
        archive.start_file(path, options).map_err(|e| fail(&e))?;
        archive.write_all(bytes).map_err(|e| fail(&e))?;
    }
    archive.finish().map(Cursor::into_inner).map_err(|e| fail(&e))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_begin_at_multiples_of_64_and_are_as_they_were() {
        let files = [("scene.usda", &b"#usda 1.0\n"[..]), ("textures/wood_color.png", &b"a picture"[..])];
        let files = files.map(|(path, bytes)| (path.to_owned(), bytes.to_vec()));
        let package = of(&files).unwrap();
        for (_, bytes) in &files {
            let at = package.windows(bytes.len()).position(|w| w == bytes).unwrap();
            assert_eq!(at % 64, 0);
        }
        assert_eq!(package, of(&files).unwrap());
    }
}
