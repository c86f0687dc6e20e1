//! Texts of documents and places in them, as the protocol counts: lines, and units of the encoding agreed upon.

use scenelang_base::TextRange;
use tower_lsp::ls_types::{Position, Range, TextDocumentContentChangeEvent};

/// What a position counts within a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    /// Bytes.
    Utf8,
    /// What every client can.
    #[default]
    Utf16,
    /// Code points.
    Utf32,
}

impl Encoding {
    /// As the protocol calls it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Utf8 => "utf-8",
            Self::Utf16 => "utf-16",
            Self::Utf32 => "utf-32",
        }
    }

    /// How long a text is.
    pub fn len(self, text: &str) -> u32 {
        let len = match self {
            // Most texts, and looked through sixteen bytes at a time: layouts are often one long line.
            _ if text.is_ascii() => text.len(),
            Self::Utf8 => text.len(),
            Self::Utf16 => text.chars().map(char::len_utf16).sum(),
            Self::Utf32 => text.chars().count(),
        };
        len as u32
    }

    /// How many bytes the first units of a text are; in the middle of a character, where that begins.
    fn bytes(self, text: &str, units: u32) -> usize {
        if self == Self::Utf8 {
            return text.floor_char_boundary(units as usize);
        }
        let mut left = units;
        for (at, c) in text.char_indices() {
            let size = if self == Self::Utf16 { c.len_utf16() as u32 } else { 1 };
            if left < size {
                return at;
            }
            left -= size;
        }
        text.len()
    }
}

/// A text and where its lines begin; LF, CRLF and a lone CR end one.
#[derive(Clone, Debug, Default)]
pub struct Text {
    text: String,
    starts: Vec<u32>,
}

impl Text {
    pub fn new(text: String) -> Self {
        let starts = starts(&text);
        Self { text, starts }
    }

    /// All of it.
    pub fn as_str(&self) -> &str {
        &self.text
    }

    /// How many lines it has; an empty one has one.
    pub fn lines(&self) -> u32 {
        self.starts.len() as u32
    }

    /// The bytes of a line, without what ends it.
    pub fn line(&self, line: u32) -> TextRange {
        let Some(&start) = self.starts.get(line as usize) else { return TextRange::empty(self.text.len() as u32) };
        let end = self.starts.get(line as usize + 1).map_or(self.text.len(), |end| *end as usize);
        let line = self.text[start as usize..end].trim_end_matches(['\n', '\r']);
        TextRange { start, end: start + line.len() as u32 }
    }

    pub fn line_of(&self, offset: u32) -> u32 {
        self.starts.partition_point(|start| *start <= offset) as u32 - 1
    }

    /// The offset of a position. Beyond the end of a line means its end, beyond the last line the end of the text.
    pub fn offset(&self, at: Position, encoding: Encoding) -> u32 {
        if at.line >= self.lines() {
            return self.text.len() as u32;
        }
        let line = self.line(at.line);
        line.start + encoding.bytes(&self.text[line.bytes()], at.character) as u32
    }

    /// The position of an offset. Within what ends a line, or a character, means before it.
    pub fn position(&self, offset: u32, encoding: Encoding) -> Position {
        let offset = self.text.floor_char_boundary(offset as usize) as u32;
        let number = self.line_of(offset);
        let line = self.line(number);
        let before = &self.text[line.start as usize..offset.min(line.end) as usize];
        Position { line: number, character: encoding.len(before) }
    }

    pub fn bytes(&self, range: Range, encoding: Encoding) -> TextRange {
        let [a, b] = [range.start, range.end].map(|at| self.offset(at, encoding));
        TextRange { start: a.min(b), end: a.max(b) }
    }

    /// A range of bytes as positions.
    pub fn range(&self, range: TextRange, encoding: Encoding) -> Range {
        Range { start: self.position(range.start, encoding), end: self.position(range.end, encoding) }
    }

    /// Makes a change.
    pub fn change(&mut self, change: TextDocumentContentChangeEvent, encoding: Encoding) {
        match change.range {
            None => *self = Self::new(change.text),
            Some(range) => {
                let place = self.bytes(range, encoding);
                self.text.replace_range(place.bytes(), &change.text);
                self.starts = starts(&self.text);
            }
        }
    }
}

fn starts(text: &str) -> Vec<u32> {
    let bytes = text.as_bytes();
    let ends = |&(i, b): &(usize, &u8)| *b == b'\n' || (*b == b'\r' && bytes.get(i + 1) != Some(&b'\n'));
    let ends = bytes.iter().enumerate().filter(ends);
    std::iter::once(0).chain(ends.map(|(i, _)| i as u32 + 1)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_count_in_three_ways() {
        let text = Text::new("a🪑é\r\nb\rc\n".to_owned());
        for (offset, line, units) in [
            (0, 0, [0, 0, 0]),
            (1, 0, [1, 1, 1]),
            (5, 0, [5, 3, 2]),
            (7, 0, [7, 4, 3]),
            (9, 1, [0; 3]),
            (11, 2, [0; 3]),
            (13, 3, [0; 3]),
        ] {
            for (encoding, character) in [Encoding::Utf8, Encoding::Utf16, Encoding::Utf32].into_iter().zip(units) {
                let at = Position { line, character };
                assert_eq!(text.position(offset, encoding), at, "{offset}");
                assert_eq!(text.offset(at, encoding), offset, "{at:?}");
            }
        }
        // Between CR and LF, within a character.
        assert_eq!(text.position(8, Encoding::Utf8), Position { line: 0, character: 7 });
        assert_eq!(text.offset(Position { line: 0, character: 2 }, Encoding::Utf16), 1);
        assert_eq!(text.offset(Position { line: 0, character: 99 }, Encoding::Utf16), 7);
        assert_eq!(text.offset(Position { line: 9, character: 0 }, Encoding::Utf16), 13);
        assert_eq!(text.lines(), 4);
    }
}
