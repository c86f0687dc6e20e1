//! Source files and places in them.
//!
//! Offsets are bytes (`u32`). Line and column are 1-based; a column counts code points (a tab is one, a byte order
//! mark at the start of the file none); LF, CRLF and a lone CR end a line.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// A file in a [`SourceMap`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FileId(pub u32);

/// A half-open range of bytes, relative to whatever the holder says (a statement, a file).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TextRange {
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl TextRange {
    /// The range `start..end`.
    pub fn new(start: usize, end: usize) -> Self {
        Self { start: start as u32, end: end as u32 }
    }
    /// An empty range at `offset`.
    pub fn empty(offset: u32) -> Self {
        Self { start: offset, end: offset }
    }
    /// The smallest range that holds both.
    pub fn cover(self, other: Self) -> Self {
        Self { start: self.start.min(other.start), end: self.end.max(other.end) }
    }
    /// The range moved right by `offset` bytes.
    pub fn shifted(self, offset: u32) -> Self {
        Self { start: self.start + offset, end: self.end + offset }
    }
    /// The range as a place in `file`.
    pub fn in_file(self, file: FileId) -> Span {
        Span { file, range: self }
    }
    /// The range as usable with `str` slicing.
    pub fn bytes(self) -> std::ops::Range<usize> {
        self.start as usize..self.end as usize
    }
    /// Length in bytes.
    pub fn len(self) -> u32 {
        self.end - self.start
    }
    /// Whether nothing is in it.
    pub fn is_empty(self) -> bool {
        self.start == self.end
    }
}

/// A place in a file: an absolute range of bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    pub file: FileId,
    /// Bytes from the start of that file.
    pub range: TextRange,
}

/// A 1-based line and column (code points).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LineColumn {
    /// Line, from 1.
    pub line: u32,
    /// Column, from 1, in code points.
    pub column: u32,
}

/// One file: its name as shown to people, its path, its text and where its lines start.
#[derive(Clone, Debug)]
pub struct SourceFile {
    name: String,
    path: PathBuf,
    text: String,
    line_starts: Vec<u32>,
}

impl SourceFile {
    /// A file with `text`, shown as `name`.
    pub fn new(name: impl Into<String>, path: impl Into<PathBuf>, text: impl Into<String>) -> Self {
        let text = text.into();
        let bytes = text.as_bytes();
        let mut line_starts = vec![0];
        for (i, &b) in bytes.iter().enumerate() {
            if b == b'\n' || (b == b'\r' && bytes.get(i + 1) != Some(&b'\n')) {
                line_starts.push(i as u32 + 1);
            }
        }
        Self { name: name.into(), path: path.into(), text, line_starts }
    }
    /// The name shown in reports.
    pub fn name(&self) -> &str {
        &self.name
    }
    /// Where it was read from (may be a made-up path, for the library and for tests).
    pub fn path(&self) -> &Path {
        &self.path
    }
    /// The whole text.
    pub fn text(&self) -> &str {
        &self.text
    }
    /// How many lines it has; an empty file has one.
    pub fn line_count(&self) -> u32 {
        self.line_starts.len() as u32
    }
    /// The line and column of a byte offset; past the end means the end.
    pub fn position(&self, offset: u32) -> LineColumn {
        let mut offset = (offset as usize).min(self.text.len());
        while !self.text.is_char_boundary(offset) {
            offset -= 1;
        }
        let line = self.line_starts.partition_point(|&s| s as usize <= offset) - 1;
        let start = self.line_starts[line] as usize;
        let mut before = &self.text[start..offset];
        if start == 0 {
            before = before.strip_prefix('\u{feff}').unwrap_or(before);
        }
        LineColumn { line: line as u32 + 1, column: before.chars().count() as u32 + 1 }
    }
    /// The byte offset of a line and column; clamped to the line's end, `None` past the last line.
    pub fn offset(&self, at: LineColumn) -> Option<u32> {
        let line = at.line.checked_sub(1)? as usize;
        let start = *self.line_starts.get(line)? as usize;
        let end = self.line_starts.get(line + 1).map_or(self.text.len(), |&e| e as usize);
        let mut text = &self.text[start..end];
        let mut skipped = 0;
        if start == 0
            && let Some(rest) = text.strip_prefix('\u{feff}')
        {
            skipped = text.len() - rest.len();
            text = rest;
        }
        let line_text = text.trim_end_matches(['\n', '\r']);
        let within =
            line_text.char_indices().nth(at.column.saturating_sub(1) as usize).map_or(line_text.len(), |(i, _)| i);
        Some((start + skipped + within) as u32)
    }
    pub fn slice(&self, range: TextRange) -> &str {
        self.text.get(range.bytes()).unwrap_or("")
    }
}

/// The files of one compilation.
#[derive(Clone, Debug, Default)]
pub struct SourceMap {
    files: Vec<SourceFile>,
    /// The first file of each path.
    by_path: HashMap<PathBuf, FileId>,
}

impl SourceMap {
    pub fn new() -> Self {
        Self::default()
    }
    pub fn add(&mut self, file: SourceFile) -> FileId {
        let id = FileId(self.files.len() as u32);
        self.by_path.entry(file.path.clone()).or_insert(id);
        self.files.push(file);
        id
    }
    /// Adds a file, or replaces the one of the same path.
    pub fn put(&mut self, file: SourceFile) -> FileId {
        match self.by_path.get(&file.path).copied() {
            Some(id) => {
                self.files[id.0 as usize] = file;
                id
            }
            None => self.add(file),
        }
    }
    /// The file of an id handed out by this map.
    pub fn get(&self, id: FileId) -> &SourceFile {
        &self.files[id.0 as usize]
    }
    /// All files, with their ids.
    pub fn iter(&self) -> impl Iterator<Item = (FileId, &SourceFile)> {
        self.files.iter().enumerate().map(|(i, f)| (FileId(i as u32), f))
    }
    /// Start and end of a span as lines and columns.
    pub fn lines(&self, span: Span) -> (LineColumn, LineColumn) {
        let file = self.get(span.file);
        (file.position(span.range.start), file.position(span.range.end))
    }
    pub fn text(&self, span: Span) -> &str {
        self.get(span.file).slice(span.range)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_code_points_and_lines_end_in_three_ways() {
        let f = SourceFile::new("a", "a", "\u{feff}é\tb\r\nc\rd\n");
        let at = |needle: char| f.position(f.text().find(needle).unwrap() as u32);
        assert_eq!(at('é'), LineColumn { line: 1, column: 1 });
        assert_eq!(at('b'), LineColumn { line: 1, column: 3 });
        assert_eq!(at('c'), LineColumn { line: 2, column: 1 });
        assert_eq!(at('d'), LineColumn { line: 3, column: 1 });
        assert_eq!(f.position(999), LineColumn { line: 4, column: 1 });
        for needle in ['é', 'b', 'c', 'd'] {
            assert_eq!(f.offset(at(needle)), f.text().find(needle).map(|o| o as u32));
        }
    }
}
