//! What is proved of a program, kept while its text changes in ways that mean nothing: blanks, lines and comments. To find it
//! again takes too long to be done after each keystroke, and who types an empty line has not repaired a contradiction.

use crate::text::{Encoding, Text};
use rustc_hash::FxHasher;
use scenelang_ide::Snapshot;
use scenelang_lang::token::{Token, lex};
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
        let (before, after) = (tokens(self.text.as_str()), tokens(text.as_str()));
        let moved = Moved { before: (&self.text, &before), after: (text, &after), encoding };
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

/// A text before and after, with the words that both have.
struct Moved<'a> {
    before: (&'a Text, &'a [Token]),
    after: (&'a Text, &'a [Token]),
    encoding: Encoding,
}

impl Moved<'_> {
    fn range(&self, Range { start, end }: Range) -> Option<Range> {
        Some(Range { start: self.position(start, false)?, end: self.position(end, true)? })
    }

    /// A place in or at a word, from its beginning; `ends`: the word before the place counts.
    fn position(&self, at: Position, ends: bool) -> Option<Position> {
        let offset = self.before.0.offset(at, self.encoding);
        let over = |t: &Token| if ends { t.range.end < offset } else { t.range.end <= offset };
        let index = self.before.1.partition_point(over);
        let (old, new) = (self.before.1.get(index)?, self.after.1.get(index)?);
        let into = offset.checked_sub(old.range.start)?;
        Some(self.after.0.position(new.range.start + into, self.encoding))
    }
}

/// The words of a text that mean something: a comment does where it silences a warning.
fn tokens(text: &str) -> Vec<Token> {
    let mut all = lex(text);
    all.retain(|token| {
        let silences = || token.kind.is_comment() && text[token.range.bytes()].contains("allow(");
        !token.kind.is_trivia() || silences()
    });
    all
}

/// A number for what a program says; the same as long as its own words, and the files that it imports, are the same.
pub fn meaning(snapshot: &Snapshot) -> u64 {
    let mut hasher = FxHasher::default();
    let layout = snapshot.layout().map(|layout| layout.file);
    for (id, file) in snapshot.sources().iter().filter(|(id, _)| Some(*id) != layout) {
        let text = file.text();
        if id == snapshot.main() {
            for token in tokens(text) {
                (token.kind as u32, &text[token.range.bytes()]).hash(&mut hasher);
            }
        } else {
            text.hash(&mut hasher);
        }
    }
    hasher.finish()
}
