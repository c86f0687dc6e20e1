//! What the formatter gives back has the same words and comments in the same order, says the same, and is formatted.
#![no_main]

use libfuzzer_sys::fuzz_target;
use scenelang_lang::fmt::{FormatOptions, format};
use scenelang_lang::parse::parse_file;
use scenelang_lang::token::{Kind, lex};

/// The words of a text in order; operators by what they mean. An arrow inside an expression means `< -`, and is written
/// so.
fn words(text: &str) -> Vec<(Kind, &str)> {
    let tokens = lex(text).into_iter().filter(|t| !t.kind.is_trivia() && t.kind != Kind::Bom);
    let word = |kind, text| match kind {
        Kind::Arrow | Kind::ArrowSign => vec![(Kind::Lt, ""), (Kind::Minus, "")],
        Kind::Ident | Kind::Number | Kind::Str => vec![(kind, text)],
        kind => vec![(kind, "")],
    };
    tokens.flat_map(|t| word(t.kind, &text[t.range.bytes()])).collect()
}

/// The comments, without the blanks that the formatter may move.
fn comments(text: &str) -> Vec<String> {
    let tokens = lex(text).into_iter().filter(|t| t.kind.is_comment());
    tokens.map(|t| text[t.range.bytes()].split_whitespace().collect::<Vec<_>>().join(" ")).collect()
}

fuzz_target!(|input: (u8, &str)| {
    let (width, text) = input;
    let options = FormatOptions { width: 20 + usize::from(width) };
    let once = format(text, &options);
    assert_eq!(words(text), words(&once), "the words changed:\n{text:?}\n{once:?}");
    assert_eq!(comments(text), comments(&once), "the comments changed:\n{text:?}\n{once:?}");
    let errors = |text: &str| {
        let found = parse_file(text).diagnostics.into_iter().filter(|d| d.is_error());
        found.map(|d| d.code).collect::<Vec<_>>()
    };
    assert_eq!(errors(text), errors(&once), "other errors:\n{text:?}\n{once:?}");
    assert_eq!(once, format(&once, &options), "formatting twice is not formatting once:\n{text:?}");
});
