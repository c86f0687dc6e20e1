//! Reading the main file and what it imports, each file once, cycles reported with their path.

use crate::ast::StmtKind;
use crate::parse::{ParsedFile, parse_file};
use scenelang_base::{Diagnostic, FileId, SourceFile, SourceMap, Span, TextRange, codes};
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

/// A file of the program, parsed.
#[derive(Debug)]
pub struct Unit {
    /// Its id.
    pub file: FileId,
    /// Its statements.
    pub parsed: ParsedFile,
    /// The path relative to the main file, as in draw keys; empty for the main file.
    pub prefix: String,
}

/// The main file and its imports.
#[derive(Debug)]
pub struct Units {
    /// Main first, then imports in the order met.
    pub units: Vec<Unit>,
    /// What went wrong with reading, parsing, importing.
    pub diagnostics: Vec<Diagnostic>,
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
        let id = sources.add(SourceFile::new(name, path, ""));
        let message = format!("{name} has {} MB; more than {} MB is not read", bytes.len() >> 20, MAX_FILE >> 20);
        return Err(Box::new((id, Diagnostic::new(codes::E0006, TextRange::empty(0).in_file(id), message))));
    }
    match String::from_utf8(bytes) {
        Ok(text) => Ok(sources.add(SourceFile::new(name, path, text))),
        Err(e) => {
            let at = e.utf8_error().valid_up_to();
            let bytes = e.into_bytes();
            let utf16 = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
            // What comes before the bad byte is kept, so that the place can be shown.
            let text = String::from_utf8_lossy(&bytes[..at]).into_owned();
            let id = sources.add(SourceFile::new(name, path, text));
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

/// Reads and parses `main` (its text already in `sources`) and everything it imports.
pub fn read_units(main: FileId, sources: &mut SourceMap, loader: &dyn Loader) -> Units {
    let mut reader =
        Reader { sources, loader, out: Units { units: Vec::new(), diagnostics: Vec::new() }, open: Vec::new() };
    let path = normal(reader.sources.get(main).path());
    reader.read(main, &path, "");
    reader.out
}

struct Reader<'a> {
    sources: &'a mut SourceMap,
    loader: &'a dyn Loader,
    out: Units,
    /// Files whose imports are being read, outermost first.
    open: Vec<PathBuf>,
}

impl Reader<'_> {
    fn read(&mut self, file: FileId, path: &Path, prefix: &str) {
        let mut parsed = parse_file(self.sources.get(file).text());
        let found = std::mem::take(&mut parsed.diagnostics);
        self.out.diagnostics.extend(found.into_iter().map(|d| d.map_places(|r: TextRange| r.in_file(file))));
        let imports: Vec<(String, Span)> = parsed
            .statements
            .iter()
            .filter_map(|(offset, stmt)| match &stmt.kind {
                StmtKind::Import { path, range } => Some((path.clone(), range.shifted(*offset).in_file(file))),
                _ => None,
            })
            // A path without quotation marks has been reported.
            .filter(|(_, place)| self.sources.text(*place).starts_with('"'))
            .collect();
        self.out.units.push(Unit { file, parsed, prefix: prefix.to_owned() });
        self.open.push(path.to_path_buf());
        for (written, place) in imports {
            self.import(path, prefix, &written, place);
        }
        self.open.pop();
    }

    fn import(&mut self, from: &Path, prefix: &str, written: &str, place: Span) {
        let folder = from.parent().unwrap_or(Path::new(""));
        let path = normal(&folder.join(written));
        if let Some(at) = self.open.iter().position(|p| *p == path) {
            let mut names: Vec<String> = self.open[at..].iter().map(|p| file_name(p)).collect();
            names.push(file_name(&path));
            let message = format!("`{written}` imports itself: {}", names.join(" → "));
            self.out.diagnostics.push(
                Diagnostic::new(codes::E0206, place, message)
                    .label("closes the circle")
                    .note("move what both files need into a third one and import that"),
            );
            return;
        }
        if self.out.units.iter().any(|u| normal(self.sources.get(u.file).path()) == path) {
            return;
        }
        if Path::new(written).is_absolute() {
            let message = format!("`{written}` is an absolute path; imports are relative to the file they stand in");
            self.out.diagnostics.push(Diagnostic::new(codes::E0206, place, message));
            return;
        }
        let relative = Path::new(prefix).parent().unwrap_or(Path::new("")).join(written);
        let relative = normal(&relative).to_string_lossy().replace('\\', "/");
        let shown = self.sources.get(place.file).path().parent().unwrap_or(Path::new("")).join(written);
        match self.loader.load(&path) {
            Ok(bytes) => match decode(&normal(&shown).to_string_lossy(), &path, bytes, self.sources) {
                Ok(file) => self.read(file, &path, &relative),
                Err(refused) => self.out.diagnostics.push(refused.1.related(place, "imported here")),
            },
            Err(e) => {
                let message = format!("cannot import `{written}`: {}", plain(&e));
                self.out.diagnostics.push(
                    Diagnostic::new(codes::E0206, place, message)
                        .note("the path is relative to the folder of this file"),
                );
            }
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

fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |n| n.to_string_lossy().into_owned())
}

/// The path without `.` and, where possible, without `..`; not resolved on disk, so that it works for any loader.
pub(crate) fn normal(path: &Path) -> PathBuf {
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
