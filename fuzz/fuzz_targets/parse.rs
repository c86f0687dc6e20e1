//! Any text is cut into tokens without gaps, parsed without a panic, and said of places that it has.
#![no_main]

use libfuzzer_sys::fuzz_target;
use scenelang_lang::parse::parse_file;
use scenelang_lang::token::lex;

fuzz_target!(|text: &str| {
    let mut at = 0;
    for token in lex(text) {
        assert_eq!(token.range.start, at, "a gap between tokens");
        at = token.range.end;
    }
    assert_eq!(at as usize, text.len(), "the last token ends before the text");

    let file = parse_file(text);
    let mut last = 0;
    for (offset, stmt) in &file.statements {
        assert!(*offset >= last, "statements out of order");
        last = *offset;
        assert!(text.get(stmt.range.shifted(*offset).bytes()).is_some(), "a statement outside the text");
        for expr in &stmt.exprs {
            assert!(text.get(expr.range.shifted(*offset).bytes()).is_some(), "an expression outside the text");
        }
    }
    for d in &file.diagnostics {
        for label in d.primary.iter().chain(&d.related) {
            assert!(text.get(label.place.bytes()).is_some(), "a place outside the text: {d:?}");
        }
    }
});
