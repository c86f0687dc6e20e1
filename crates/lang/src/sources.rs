//! Where files come from, and what a file must be to be read.

use scenelang_base::{Diagnostic, FileId, SourceFile, SourceMap, TextRange, codes};
use std::io;
use std::path::{Component, Path, PathBuf};

/// Files larger than this are refused (bytes).
pub const MAX_FILE: usize = 64 << 20;

/// Where files come from: the disk, an editor's buffers, a test's table.
pub trait Loader {
    /// The bytes of a file.
    ///
    /// # Errors
    /// What the file system says.
    fn load(&self, path: &Path) -> io::Result<Vec<u8>>;
}

/// The disk.
pub struct Disk;

impl Loader for Disk {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        if path.is_dir() {
            return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a directory"));
        }
        std::fs::read(path)
    }
}

/// Decodes a file: UTF-8, with or without a byte order mark (which stays in the text).
///
/// # Errors
/// A diagnostic that says where the first bad byte is, or what the file seems to be.
pub fn decode(
    name: &str,
    path: &Path,
    bytes: Vec<u8>,
    sources: &mut SourceMap,
) -> Result<FileId, Box<(FileId, Diagnostic)>> {
    if bytes.len() > MAX_FILE {
        let id = sources.put(SourceFile::new(name, path, ""));
        let message = format!("{name} has {} MB; more than {} MB is not read", bytes.len() >> 20, MAX_FILE >> 20);
        return Err(Box::new((id, Diagnostic::new(codes::E0006, TextRange::empty(0).in_file(id), message))));
    }
    match String::from_utf8(bytes) {
        Ok(text) => Ok(sources.put(SourceFile::new(name, path, text))),
        Err(e) => {
            let at = e.utf8_error().valid_up_to();
            let bytes = e.into_bytes();
            let utf16 = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
            // What comes before the bad byte is kept, so that the place can be shown.
            let text = String::from_utf8_lossy(&bytes[..at]).into_owned();
            let id = sources.put(SourceFile::new(name, path, text));
            let message = if utf16 {
                format!("{name} is not UTF-8 text but seems to be UTF-16")
            } else {
                format!("{name} is not UTF-8 text: the byte 0x{:02x} cannot stand here", bytes[at])
            };
            let diagnostic = Diagnostic::new(codes::E0003, TextRange::empty(at as u32).in_file(id), message)
                .note("save the file as UTF-8");
            Err(Box::new((id, diagnostic)))
        }
    }
}

/// An operating system's message without its error number.
pub fn plain(e: &io::Error) -> String {
    match e.kind() {
        io::ErrorKind::NotFound => "there is no such file".into(),
        io::ErrorKind::PermissionDenied => "it may not be read".into(),
        io::ErrorKind::IsADirectory => "it is a directory".into(),
        _ => e.to_string(),
    }
}

/// The last part of a path, to show.
pub(crate) fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |n| n.to_string_lossy().into_owned())
}

/// The path without `.` and, where possible, without `..`; not resolved on disk, so that it works for any loader.
pub fn normal(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir if matches!(out.components().next_back(), Some(Component::Normal(_))) => {
                out.pop();
            }
            other => out.push(other),
        }
    }
    out
}
