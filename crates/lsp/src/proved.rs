//! What is proved of a program, kept while its text changes in ways that mean nothing: blanks, lines and comments. To find it
//! again takes too long to be done after each keystroke, and who types an empty line has not repaired a contradiction.

use crate::text::{Encoding, Text};
use rustc_hash::FxHasher;
use scenelang_ide::Snapshot;
use scenelang_lang::token::{Kind, Token, lex};
use std::hash::{Hash, Hasher};
use std::sync::Arc;
use tower_lsp::ls_types::{Diagnostic, Position, Range};

/// Marks of what is proved, and the text that they are about.
#[derive(Default)]
pub struct Proofs {
    marks: Vec<Diagnostic>,
    text: Arc<Text>,
}

impl Proofs {
    pub fn new(marks: Vec<Diagnostic>, text: Arc<Text>) -> Self {
        Self { marks, text }
    }

    pub fn marks(&self) -> &[Diagnostic] {
        &self.marks
    }

    /// Takes over another text of the document `uri` that means the same. Marks that are not between words have no place in it.
    pub fn follow(&mut self, uri: &str, text: &Arc<Text>, encoding: Encoding) {
        if self.marks.is_empty() || self.text.as_str() == text.as_str() {
            return;
        }
        let moved =
            Moved { change: Change::of(self.text.as_str(), text.as_str()), before: &self.text, after: text, encoding };
        self.marks.retain_mut(|mark| {
            let Some(range) = moved.range(mark.range) else { return false };
            mark.range = range;
            let places = mark.related_information.iter_mut().flatten().map(|related| &mut related.location);
            for place in places.filter(|place| place.uri.as_str() == uri) {
                if let Some(range) = moved.range(place.range) {
                    place.range = range;
                }
            }
            true
        });
        self.text = Arc::clone(text);
    }
}

/// What a program said when it was last looked at.
pub struct Said {
    text: Arc<Text>,
    /// A number for the files that it imports.
    imports: u64,
}

impl Said {
    pub fn new(snapshot: &Snapshot, text: &Arc<Text>) -> Self {
        let mut hasher = FxHasher::default();
        let layout = snapshot.layout().map(|layout| layout.file);
        let own = |id| Some(id) == layout || id == snapshot.main();
        snapshot.sources().iter().filter(|(id, _)| !own(*id)).for_each(|(_, file)| file.text().hash(&mut hasher));
        Self { text: Arc::clone(text), imports: hasher.finish() }
    }

    /// Whether both have the same words, and import the same.
    pub fn means_the_same(&self, other: &Self) -> bool {
        let change = || Change::of(self.text.as_str(), other.text.as_str());
        self.imports == other.imports && (Arc::ptr_eq(&self.text, &other.text) || change().means_nothing())
    }
}

/// The lines in which two texts differ, with their words. A token ends with its line, but for block comments: in a text
/// that has one, these are all lines.
struct Change<'t> {
    before: Lines<'t>,
    after: Lines<'t>,
}

/// Lines of a text, and the words in them that mean something.
struct Lines<'t> {
    text: &'t str,
    /// Bytes of the whole text.
    start: usize,
    words: Vec<Token>,
}

impl<'t> Change<'t> {
    fn of(before: &'t str, after: &'t str) -> Self {
        let has_blocks = |text: &str| text.contains("/*");
        let (start, rest) = if has_blocks(before) || has_blocks(after) { (0, 0) } else { alike(before, after) };
        let lines = |text: &'t str| {
            let text = &text[start..text.len() - rest];
            Lines { text, start, words: words(text) }
        };
        Self { before: lines(before), after: lines(after) }
    }

    fn means_nothing(&self) -> bool {
        let said = |lines: &Lines<'t>| -> Vec<(Kind, &'t str)> {
            lines.words.iter().map(|word| (word.kind, &lines.text[word.range.bytes()])).collect()
        };
        said(&self.before) == said(&self.after)
    }
}

/// So many bytes are compared at once.
const BLOCK: usize = 64;

/// How many bytes of whole lines two texts have in common at the beginning, and how many at the end.
fn alike(before: &str, after: &str) -> (usize, usize) {
    let (a, b) = (before.as_bytes(), after.as_bytes());
    let is_end = |at: usize| at == 0 || a[at - 1] == b'\n';
    // By blocks first: the texts are long, and differ in one place.
    let blocks = a.chunks(BLOCK).zip(b.chunks(BLOCK)).take_while(|(x, y)| x == y && x.len() == BLOCK).count() * BLOCK;
    let same = blocks + a[blocks..].iter().zip(&b[blocks..]).take_while(|(x, y)| x == y).count();
    let start = (0..=same).rev().find(|at| is_end(*at)).unwrap_or(0);
    let (a, b) = (&a[start..], &b[start..]);
    let blocks = a.rchunks(BLOCK).zip(b.rchunks(BLOCK)).take_while(|(x, y)| x == y && x.len() == BLOCK).count() * BLOCK;
    let ends = |text: &[u8]| text.len() - blocks;
    let same = a[..ends(a)].iter().rev().zip(b[..ends(b)].iter().rev()).take_while(|(x, y)| x == y).count() + blocks;
    // What remains begins after a line break in both.
    let begins = |text: &[u8], rest: usize| text.len() == rest || text[text.len() - rest - 1] == b'\n';
    let rest = (0..=same).rev().find(|rest| begins(a, *rest) && begins(b, *rest)).unwrap_or(0);
    (start, rest)
}

/// A text before and after, with the words that both have.
struct Moved<'a> {
    change: Change<'a>,
    before: &'a Text,
    after: &'a Text,
    encoding: Encoding,
}

impl Moved<'_> {
    fn range(&self, Range { start, end }: Range) -> Option<Range> {
        Some(Range { start: self.position(start, false)?, end: self.position(end, true)? })
    }

    /// A place in or at a word, from its beginning; `ends`: the word before the place counts.
    fn position(&self, at: Position, ends: bool) -> Option<Position> {
        let offset = self.before.offset(at, self.encoding) as usize;
        let (before, after) = (&self.change.before, &self.change.after);
        let to = |offset: usize| Some(self.after.position(u32::try_from(offset).ok()?, self.encoding));
        let end = before.start + before.text.len();
        if offset < before.start || ends && offset == before.start {
            return to(offset);
        }
        if offset > end || !ends && offset == end {
            return to(after.start + after.text.len() + (offset - end));
        }
        let within = (offset - before.start) as u32;
        let over = |t: &Token| if ends { t.range.end < within } else { t.range.end <= within };
        let index = before.words.partition_point(over);
        let (old, new) = (before.words.get(index)?, after.words.get(index)?);
        to(after.start + (new.range.start + within.checked_sub(old.range.start)?) as usize)
    }
}

/// The words of a text that mean something: a comment does where it silences a warning.
fn words(text: &str) -> Vec<Token> {
    let mut all = lex(text);
    all.retain(|token| {
        let silences = || token.kind.is_comment() && text[token.range.bytes()].contains("allow(");
        !token.kind.is_trivia() || silences()
    });
    all
}

#[cfg(test)]
mod tests {
    use super::{Change, alike, words};

    #[test]
    fn a_change_is_looked_for_in_its_lines_alone() {
        let before = "object a;\nobject b; // x\nassert a.top > 1;\n";
        for (after, same) in [
            ("object a;\nobject b; // xy\nassert a.top > 1;\n", true),
            ("object a;\n\n\nobject b;\nassert a.top > 1;\n", true),
            ("object a;\nobject b; assert a.top > 1;\n", true),
            ("object a;\nobject c; // x\nassert a.top > 1;\n", false),
            ("object a;\nobject b; // x\nassert a.top > 1;\nobject d;", false),
            ("object a;\n/* object b; // x */\nassert a.top > 1;\n", false),
            ("object a;\nobject b; // allow(W0101)\nassert a.top > 1;\n", false),
            ("", false),
            (before, true),
        ] {
            assert_eq!(Change::of(before, after).means_nothing(), same, "{after:?}");
            assert_eq!(Change::of(after, before).means_nothing(), same, "{after:?}");
        }
        // One line is looked at, whatever else there is.
        let change = Change::of(before, "object a;\nobject b; // xy\nassert a.top > 1;\n");
        assert_eq!((change.before.text, change.after.text), ("object b; // x\n", "object b; // xy\n"));
    }

    #[test]
    fn lines_that_are_alike_are_lexed_alike() {
        let texts =
            ["a\nb\n", "a\n\nb\n", "a\r\nb\r\n", "x = \"a\n\";", "", "\n", "é\nß", "a // b\n// c", "a\nb\nc", "c"];
        for before in texts {
            for after in texts {
                let (start, rest) = alike(before, after);
                assert_eq!(before[..start], after[..start]);
                assert_eq!(before[before.len() - rest..], after[after.len() - rest..]);
                for text in [before, after] {
                    let parts = [&text[..start], &text[start..text.len() - rest], &text[text.len() - rest..]];
                    let apart: Vec<_> = parts.iter().flat_map(|part| words(part)).map(|word| word.kind).collect();
                    let whole: Vec<_> = words(text).iter().map(|word| word.kind).collect();
                    assert_eq!(apart, whole, "{text:?}");
                }
            }
        }
    }
}
