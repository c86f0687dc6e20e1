//! After any edits the front end says what a fresh one says of the same text.
#![no_main]

use libfuzzer_sys::fuzz_target;
use scenelang_base::{SourceFile, SourceMap};
use scenelang_lang::Options;
use scenelang_lang::db::Analysis;
use scenelang_lang::sources::Loader;
use std::io;
use std::path::Path;

struct Nothing;

impl Loader for Nothing {
    fn load(&self, _: &Path) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }
}

/// What is said of `text` by an analysis that may know other texts already.
fn said(analysis: &mut Analysis, text: &str) -> String {
    let mut sources = SourceMap::new();
    let main = sources.put(SourceFile::new("main.scene", "main.scene", text));
    analysis.update(main, &mut sources, &Nothing);
    format!("{:?}\n{:?}", analysis.diagnostics(), analysis.program(&sources))
}

/// The nearest border between characters, from the left.
fn border(text: &str, at: u16) -> usize {
    let at = usize::from(at) % (text.len() + 1);
    (0..=at).rev().find(|i| text.is_char_boundary(*i)).unwrap_or(0)
}

fuzz_target!(|input: (&str, Vec<(u16, u8, &str)>)| {
    let (start, edits) = input;
    let mut text = start.to_owned();
    let mut old = Analysis::new(Options::default());
    said(&mut old, &text);
    for (at, cut, put) in edits.into_iter().take(8) {
        let from = border(&text, at);
        let to = border(&text, (from + usize::from(cut)).min(text.len()) as u16).max(from);
        text.replace_range(from..to, put);
        let fresh = said(&mut Analysis::new(Options::default()), &text);
        assert_eq!(said(&mut old, &text), fresh, "{text:?}");
    }
});
