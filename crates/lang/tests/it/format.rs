//! The formatter: what it makes of `format/*.scene` (in `snapshots/`), and its promises for any text.

use crate::shape;
use crate::soup;
use proptest::prelude::*;
use scenelang_lang::fmt::{FormatOptions, format};
use scenelang_lang::parse::parse_file;
use scenelang_lang::token::lex;
use std::path::Path;

fn shapes(text: &str) -> Vec<String> {
    parse_file(text).statements.iter().map(|(_, s)| shape::stmt(s)).collect()
}

/// The comments of a text, without blanks at their ends.
fn comments(text: &str) -> Vec<String> {
    let comments = lex(text).into_iter().filter(|t| t.kind.is_comment());
    let line_feeds = |s: &str| s.trim_end().replace("\r\n", "\n").replace('\r', "\n");
    comments.map(|t| line_feeds(&text[t.range.bytes()])).collect()
}

/// What holds for every text at every width.
fn check(text: &str, width: usize) {
    let options = FormatOptions { width };
    let once = format(text, &options);
    assert_eq!(format(&once, &options), once, "twice is not once, of {text:?}");
    assert_eq!(comments(&once), comments(text), "comments of {text:?}");
    assert_eq!(shapes(&once), shapes(text), "{text:?} became {once:?}");
}

#[test]
fn files() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/format");
    let mut seen = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let text = std::fs::read_to_string(&path).unwrap();
        check(&text, 100);
        check(&text, 30);
        insta::with_settings!({ prepend_module_to_snapshot => false, omit_expression => true }, {
            insta::assert_snapshot!(format!("format-{name}"), format(&text, &FormatOptions::default()));
        });
        seen += 1;
    }
    assert!(seen >= 2, "the fixtures are not where they should be");
}

#[test]
fn small_cases() {
    let cases = [
        ("", ""),
        ("\n\n", ""),
        ("object a;", "object a;\n"),
        ("\u{feff}object a;\r\nobject b;\r\n", "\u{feff}object a;\nobject b;\n"),
        ("object a;\r\r\robject b;", "object a;\n\nobject b;\n"),
        ("\n\n\nobject a;\n\n\n\nobject b;\n\n\n", "object a;\n\nobject b;\n"),
        ("object a; object b;", "object a;\nobject b;\n"),
        ("assert a==b&&!c||d≠e;", "assert a = b and not c or d != e;\n"),
        ("assert a<-1;", "assert a < -1;\n"),
        ("assert a- -1>-(- b);", "assert a - -1 > -(-b);\n"),
        ("assert forall i in 0 .. 5 : c [ i+1 ] . pos . x>1;", "assert forall i in 0..5: c[i + 1].pos.x > 1;\n"),
        ("assert exists i in 5. .. 6: a;", "assert exists i in 5. .. 6: a;\n"),
        ("assert f(s where.color=\"red\");", "assert f(s where .color = \"red\");\n"),
        ("a.pos←vec3( 1,2 , 3 ) ;", "a.pos <- vec3(1, 2, 3);\n"),
        ("predicate p ( Object a ):=a.top>1;", "predicate p(Object a) := a.top > 1;\n"),
        ("@req(\"x\")object a;", "@req(\"x\")\nobject a;\n"),
        ("object a; // one\n// two\nobject b;", "object a; // one\n// two\nobject b;\n"),
        ("object a; /* x */ object b;", "object a; /* x */\nobject b;\n"),
        ("/* x */ object a;", "/* x */ object a;\n"),
        ("assert f(a/* x */,/* y */b);", "assert f(a /* x */, /* y */ b);\n"),
        ("assert   x > ;object b  ;", "assert   x > ;\nobject b;\n"),
        ("object a;\n/* open", "object a;\n/* open"),
        ("object a;;", "object a;\n;\n"),
    ];
    for (text, expected) in cases {
        assert_eq!(format(text, &FormatOptions::default()), expected, "{text:?}");
        check(text, 100);
    }
}

/// Too deep for the layout, or for the parser: left alone, and no stack is lost.
#[test]
fn deep_statements() {
    for n in [50, 150, 990, 5000] {
        for (open, close) in
            [("(", ")"), ("f(", ")"), ("not ", ""), ("forall x in s: ", ""), ("count(x in s: ", ")"), ("a + (", ")")]
        {
            let text = format!("assert {}a{};", open.repeat(n), close.repeat(n));
            let once = format(&text, &FormatOptions::default());
            assert_eq!(format(&once, &FormatOptions::default()), once, "{n} times {open}");
        }
    }
}

#[test]
fn no_line_that_can_be_broken_is_too_long() {
    let text = "assert aaaa.pos.x > 1 and bbbb.pos.y + cccc.pos.z * dddd.pos.x < max(eeee.top, ffff.top, gggg.top) or not hhhh;";
    for width in 24..120 {
        let formatted = format(text, &FormatOptions { width });
        assert!(formatted.lines().all(|l| l.chars().count() <= width), "{width}:\n{formatted}");
    }
}

proptest! {
    #[test]
    fn programs_keep_their_meaning_and_comments(text in soup::program(), width in 10usize..120) {
        check(&text, width);
    }

    #[test]
    fn any_words_keep_their_meaning_and_comments(text in soup::soup(), width in 10usize..120) {
        check(&text, width);
    }
}
