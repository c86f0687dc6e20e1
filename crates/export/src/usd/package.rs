//! A USDZ package: a ZIP archive without compression, in which each file begins at a multiple of 64 bytes.

use crate::ExportError;
use std::io::{Cursor, Write};
use zip::write::{SimpleFileOptions, ZipWriter};
use zip::{CompressionMethod, DateTime};

/// Where files begin.
const ALIGNMENT: u16 = 64;

/// A package with one layer.
///
/// # Errors
/// The layer has more than 4 GB.
pub(super) fn of(name: &str, layer: &[u8]) -> Result<Vec<u8>, ExportError> {
    let fail = |e: &dyn std::fmt::Display| ExportError::Format("usdz", format!("the package cannot be made: {e}"));
    // Always the same time, so that the same scene gives the same bytes.
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .with_alignment(ALIGNMENT)
        .last_modified_time(DateTime::default());
    let mut archive = ZipWriter::new(Cursor::new(Vec::with_capacity(layer.len() + 1024)));
    archive.start_file(name, options).map_err(|e| fail(&e))?;
    archive.write_all(layer).map_err(|e| fail(&e))?;
    archive.finish().map(Cursor::into_inner).map_err(|e| fail(&e))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_layer_begins_at_a_multiple_of_64_and_is_as_it_was() {
        let layer = b"#usda 1.0\n";
        let package = of("scene.usda", layer).unwrap();
        let at = package.windows(layer.len()).position(|w| w == layer).unwrap();
        assert_eq!(at % 64, 0);
        assert_eq!(package, of("scene.usda", layer).unwrap());
    }
}
