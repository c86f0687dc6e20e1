//! The standard form: of a file, of what was just ended.

use scenelang_ide::format::{ended, file};

fn made(text: &str, replacement: Option<(scenelang_base::TextRange, String)>) -> String {
    let mut out = text.to_owned();
    if let Some((range, new)) = replacement {
        out.replace_range(range.bytes(), &new);
    }
    out
}

#[test]
fn of_a_file_and_of_the_statement_that_was_ended() {
    let text = "object   a;\nassert a.top>1;\n";
    assert_eq!(made(text, file(text)), "object a;\nassert a.top > 1;\n");
    assert_eq!(file("object a;\n"), None);
    // Only what was ended.
    assert_eq!(made(text, ended(text, 11)), "object a;\nassert a.top>1;\n");
}
