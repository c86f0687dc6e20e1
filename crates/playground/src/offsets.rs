//! Places as a page counts them: JavaScript has texts in units of UTF-16.

use scenelang_base::TextRange;

/// From bytes of a text to its units of UTF-16, and back.
#[derive(Clone, Debug)]
pub struct Offsets<'t> {
    text: &'t str,
    /// Every so many bytes, the units before; none where both are the same.
    marks: Vec<u32>,
}

/// Between two marks.
const STEP: usize = 256;

impl<'t> Offsets<'t> {
    /// Those of a text.
    pub fn new(text: &'t str) -> Self {
        let mut marks = Vec::new();
        if !text.is_ascii() {
            let mut units = 0;
            let mut from = 0;
            for at in (0..=text.len()).step_by(STEP) {
                let at = text.floor_char_boundary(at);
                units += length(&text[from..at]);
                marks.push(units);
                from = at;
            }
        }
        Self { text, marks }
    }

    /// The units before a byte; within a character, those before it.
    pub fn units(&self, byte: u32) -> u32 {
        let byte = self.text.floor_char_boundary((byte as usize).min(self.text.len()));
        if self.marks.is_empty() {
            return byte as u32;
        }
        let mark = byte / STEP;
        self.marks[mark] + length(&self.text[self.text.floor_char_boundary(mark * STEP)..byte])
    }

    /// The byte after so many units; within a character, where that begins; beyond the text, its end.
    pub fn byte(&self, units: u32) -> u32 {
        if self.marks.is_empty() {
            return units.min(self.text.len() as u32);
        }
        let mark = self.marks.partition_point(|before| *before <= units).saturating_sub(1);
        let start = self.text.floor_char_boundary(mark * STEP);
        let mut left = units - self.marks[mark];
        for (at, c) in self.text[start..].char_indices() {
            let size = c.len_utf16() as u32;
            if left < size {
                return (start + at) as u32;
            }
            left -= size;
        }
        self.text.len() as u32
    }

    /// A range as two numbers of units.
    pub fn range(&self, range: TextRange) -> [u32; 2] {
        [self.units(range.start), self.units(range.end)]
    }
}

fn length(text: &str) -> u32 {
    text.chars().map(|c| c.len_utf16() as u32).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_and_units_are_those_of_the_standard_library() {
        let long = "a→😀é\n".repeat(200);
        for text in ["", "plain", "😀", "aé😀z", &long] {
            let offsets = Offsets::new(text);
            for (byte, c) in text.char_indices() {
                let units = text[..byte].encode_utf16().count() as u32;
                assert_eq!(offsets.units(byte as u32), units, "{byte} of {text:?}");
                assert_eq!(offsets.byte(units), byte as u32, "{units} of {text:?}");
                for within in 1..c.len_utf8() {
                    assert_eq!(offsets.units((byte + within) as u32), units);
                }
                if c.len_utf16() == 2 {
                    assert_eq!(offsets.byte(units + 1), byte as u32);
                }
            }
            assert_eq!(offsets.byte(u32::MAX), text.len() as u32);
            assert_eq!(offsets.units(u32::MAX), text.encode_utf16().count() as u32);
        }
    }
}
