//! What is shown to people and written into logs, without what would do something there: control characters (the escape
//! sequences of terminals begin with one), line breaks where a line is meant, and the characters that turn the direction
//! of text, so that it reads as something else than it is.
//!
//! Names, messages and texts of programs come from files, and files from strangers. JSON is not for this: its writer
//! escapes what has to be.

use std::borrow::Cow;
use std::fmt::Write;

/// Whether a character does something else than being seen.
fn acts(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}' | '\u{2029}')
        || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{e0000}'..='\u{e007f}')
}

/// A text as part of a line: line breaks and tabs are blanks, and what else acts is written as its number, `\u{1b}`.
pub fn line(text: &str) -> Cow<'_, str> {
    only(text, |_| false)
}

/// A text of several lines: line breaks and tabs stay, and no line is a command to a build server.
pub fn lines(text: &str) -> Cow<'_, str> {
    let text = only(text, |c| matches!(c, '\n' | '\t'));
    if !text.split('\n').any(is_command) {
        return text;
    }
    Cow::Owned(text.split('\n').map(no_command).collect::<Vec<_>>().join("\n"))
}

/// A line that is no command to a build server, which takes commands from what a program prints.
pub fn no_command(line: &str) -> Cow<'_, str> {
    if is_command(line) { Cow::Owned(format!("\\{line}")) } else { Cow::Borrowed(line) }
}

fn is_command(line: &str) -> bool {
    let start = line.trim_start();
    start.starts_with("::") || start.starts_with("##[") || start.starts_with("##vso[")
}

fn only(text: &str, stays: impl Fn(char) -> bool) -> Cow<'_, str> {
    let acts = |c: char| acts(c) && !stays(c);
    if !text.contains(acts) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 8);
    for c in text.chars() {
        match c {
            '\n' | '\r' | '\t' if acts(c) => out.push(' '),
            c if acts(c) => drop(write!(out, "\\u{{{:x}}}", u32::from(c))),
            c => out.push(c),
        }
    }
    Cow::Owned(out)
}

/// A file's text with something to see in place of what acts, of the same length in bytes, so that places in it stay what
/// they are. Line breaks and tabs stay.
pub fn excerpt(text: &str) -> Cow<'_, str> {
    let acts = |c: char| acts(c) && !matches!(c, '\n' | '\r' | '\t');
    if !text.contains(acts) {
        return Cow::Borrowed(text);
    }
    let seen = |c: char| match c {
        c if !acts(c) => c,
        c => match c.len_utf8() {
            1 => '?',
            2 => '¿',
            3 => '\u{fffd}',
            _ => '\u{1f6ab}',
        },
    };
    Cow::Owned(text.chars().map(seen).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_acts_is_shown_and_does_nothing() {
        for (text, wanted) in [
            ("chair → table é 🪑", "chair → table é 🪑"),
            ("q\n::error::x", "q ::error::x"),
            ("\x1b[31mred\x07", "\\u{1b}[31mred\\u{7}"),
            ("a\u{202e}b\u{2066}c\u{85}", "a\\u{202e}b\\u{2066}c\\u{85}"),
            ("a\tb\r", "a b "),
        ] {
            assert_eq!(line(text), wanted);
        }
        assert_eq!(lines("a\n\tb\x1b\n"), "a\n\tb\\u{1b}\n");
        assert_eq!(lines("a\n ::error::x\n##[group]\n:: "), "a\n\\ ::error::x\n\\##[group]\n\\:: ");
    }

    #[test]
    fn an_excerpt_keeps_its_places() {
        let text = "a\x1b[1m\u{85}é\u{202e}\r\n\tb\u{e0041}";
        let shown = excerpt(text);
        assert_eq!(shown, "a?[1m¿é\u{fffd}\r\n\tb\u{1f6ab}");
        assert_eq!(shown.len(), text.len());
    }
}
