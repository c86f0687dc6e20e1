//! Where files come from, and what a file must be to be read. The disk is behind a [`Door`].

use scenelang_base::door::{Door, outside};
use scenelang_base::{Code, Diagnostic, FileId, SourceFile, SourceMap, TextRange, codes};
use std::io;
use std::path::Path;

pub use scenelang_base::door::normal;

/// Files larger than this are refused (bytes).
pub const MAX_FILE: usize = scenelang_base::door::MOST as usize;

/// Where files come from: the disk behind its door, an editor's buffers, a test's table.
pub trait Loader {
    /// The bytes of a file.
    ///
    /// # Errors
    /// What the file system says.
    fn load(&self, path: &Path) -> io::Result<Vec<u8>>;
}

impl Loader for Door {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.read(path)
    }
}

/// Why a file cannot be used, as a diagnostic without a place; `what` is done to it: "read room.scene".
pub fn unreadable(what: &str, e: &io::Error) -> Diagnostic {
    with_advice(Diagnostic::without_place(code_of(e, codes::E0001), format!("cannot {what}: {}", plain(e))), e)
}

/// The code of what the file system says; `usual`, where there is no better one.
pub(crate) fn code_of(e: &io::Error, usual: Code) -> Code {
    match e.kind() {
        _ if outside(e).is_some() => codes::E0009,
        io::ErrorKind::FileTooLarge => codes::E0006,
        _ => usual,
    }
}

/// A diagnostic with what to do about a file outside the workspace, if it is about one.
pub(crate) fn with_advice(diagnostic: Diagnostic, e: &io::Error) -> Diagnostic {
    match outside(e) {
        Some(refused) => diagnostic.note(refused.advice()),
        None => diagnostic,
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
        let message =
            format!("{name} is {} MB; files larger than {} MB are not read", bytes.len() >> 20, MAX_FILE >> 20);
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
                format!("{name} is not valid UTF-8; it seems to be UTF-16")
            } else {
                format!("{name} is not UTF-8 text: the byte 0x{:02x} is not allowed here", bytes[at])
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
        // An error of ours says it itself.
        _ if e.get_ref().is_some() => e.to_string(),
        io::ErrorKind::NotFound => "there is no such file".into(),
        io::ErrorKind::PermissionDenied => "permission denied".into(),
        io::ErrorKind::IsADirectory => "it is a directory".into(),
        _ => e.to_string(),
    }
}

/// The last part of a path, to show.
pub(crate) fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |n| n.to_string_lossy().into_owned())
}
