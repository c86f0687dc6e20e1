//! Blocks of code in Markdown, and the marks in them that say what is expected.
//!
//! A trailing comment `//~ CODE` says that a diagnostic of that code starts on that line; `//~ CODE:COLUMN` fixes its
//! column too; several are separated by blanks. Another comment may follow on the same line (`//= holds`).

#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

/// A fenced block.
pub struct Block {
    /// Line of the Markdown file where its text begins.
    pub line: usize,
    /// What stands behind the opening fence.
    pub info: String,
    /// Its text, each line with its end.
    pub text: String,
}

impl Block {
    /// The words behind the opening fence.
    pub fn words(&self) -> Vec<&str> {
        self.info.split_whitespace().collect()
    }
    /// Whether it is a program.
    pub fn is_scene(&self) -> bool {
        self.words().first() == Some(&"scene")
    }
    /// The value of a word `key=value`.
    pub fn setting(&self, key: &str) -> Option<&str> {
        self.words().into_iter().find_map(|w| w.strip_prefix(key)?.strip_prefix('='))
    }
}

/// The blocks of a page, in order.
pub fn blocks(markdown: &str) -> Vec<Block> {
    let mut out: Vec<Block> = Vec::new();
    let mut open = false;
    for (i, line) in markdown.lines().enumerate() {
        match (open, line.strip_prefix("```")) {
            (false, Some(info)) => {
                out.push(Block { line: i + 2, info: info.trim().into(), text: String::new() });
                open = true;
            }
            (true, Some(_)) => open = false,
            (true, None) => {
                let block = out.last_mut().unwrap();
                block.text.push_str(line);
                block.text.push('\n');
            }
            (false, None) => {}
        }
    }
    out
}

/// A diagnostic: line, code, and the column, which a mark may leave open.
pub type Mark = (u32, String, Option<u32>);

/// The marks of a program, sorted.
pub fn expected(text: &str) -> Vec<Mark> {
    let mut out = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let Some((_, marks)) = line.split_once("//~") else { continue };
        for mark in marks.split("//").next().unwrap_or_default().split_whitespace() {
            let (code, column) = match mark.split_once(':') {
                Some((code, column)) => (code, Some(column.parse().unwrap())),
                None => (mark, None),
            };
            out.push((i as u32 + 1, code.to_owned(), column));
        }
    }
    out.sort();
    out
}

/// The diagnostics that count for a program with these marks: warnings (W02 to W04) only where it marks one of that
/// code, since an example is about one thing.
pub fn relevant(mut found: Vec<Mark>, wanted: &[Mark]) -> Vec<Mark> {
    let warning = |code: &str| ["W02", "W03", "W04"].iter().any(|s| code.starts_with(s));
    found.retain(|(_, code, _)| !warning(code) || wanted.iter().any(|w| w.1 == *code));
    found
}

/// Whether the diagnostics are those that the marks ask for, no more and no less.
pub fn agree(found: &[Mark], wanted: &[Mark]) -> bool {
    found.len() == wanted.len()
        && found.iter().zip(wanted).all(|(f, w)| (f.0, &f.1) == (w.0, &w.1) && (w.2.is_none() || w.2 == f.2))
}
