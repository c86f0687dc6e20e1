//! The TextMate grammar, run by the tokenizer of VS Code: every byte of a good program is of the class that the table of
//! tokens gives it.

use crate::programs::{Program, book, made, root, written};
use scenelang_grammars::style::style;
use scenelang_lang::parse::{parse_file, read_tokens};
use scenelang_lang::token::{Class, Token, UNITS};
use serde_json::Value;
use std::process::Command;
use std::{env, fs};

/// The scopes of each byte, outermost first; none where the tokenizer is missing.
fn scopes(programs: &[Program]) -> Option<Vec<Vec<Vec<String>>>> {
    let oracles = root().join("tests/oracles");
    if !oracles.join("node_modules/vscode-textmate").exists() {
        assert!(env::var("CI").as_deref() != Ok("true"), "in CI nothing may be skipped: no vscode-textmate");
        eprintln!("skipped: no vscode-textmate (Node and tests/oracles/node_modules)");
        return None;
    }
    let folder = tempfile::tempdir().unwrap();
    let mut node = Command::new("node");
    node.arg(oracles.join("textmate.mjs")).arg(root().join("editors/vscode/syntaxes/scenelang.tmLanguage.json"));
    for (i, program) in programs.iter().enumerate() {
        let path = folder.path().join(format!("{i}.scene"));
        fs::write(&path, &program.text).unwrap();
        node.arg(path);
    }
    let output = node.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let lines = String::from_utf8(output.stdout).unwrap();
    let of_line = |(line, program): (&str, &Program)| {
        let mut bytes = vec![Vec::new(); program.text.len()];
        for token in serde_json::from_str::<Vec<Vec<Value>>>(line).unwrap() {
            let place = |i: usize| token[i].as_u64().unwrap() as usize;
            let scopes: Vec<String> = token[2..].iter().map(|s| s.as_str().unwrap().to_owned()).collect();
            bytes[place(0)..place(1)].fill(scopes);
        }
        bytes
    };
    let all: Vec<_> = lines.lines().zip(programs).map(of_line).collect();
    assert_eq!(all.len(), programs.len());
    Some(all)
}

/// The scope that a byte of a token has, as `(scope, whether it may stand around a finer one)`.
fn expected(class: Class, token: &str, at: usize) -> (&'static str, bool) {
    let unit = UNITS.iter().filter(|u| token.ends_with(*u)).map(|u| u.len()).max().unwrap_or(0);
    match class {
        Class::Number if at >= token.len() - unit => ("keyword.other.unit", false),
        Class::Text if in_escape(token, at) => ("constant.character.escape", false),
        class => (style(class).scope, matches!(class, Class::Text | Class::Comment | Class::Documentation)),
    }
}

/// Whether a byte of a string is part of an escape.
fn in_escape(token: &str, at: usize) -> bool {
    let mut from = 0;
    while let Some(found) = token[from..].find('\\') {
        let start = from + found;
        from = start + if token[start..].starts_with("\\u") { 6 } else { 2 };
        if (start..from).contains(&at) {
            return true;
        }
    }
    false
}

/// The first byte whose scope is not that of its class.
fn misjudged(text: &str, scopes: &[Vec<String>]) -> Option<String> {
    const NAMES: [&str; 4] =
        ["variable.other", "support.variable.property", "support.function", "entity.name.function"];
    for Token { kind, range } in read_tokens(text).into_iter().filter(|t| t.kind.class() != Class::Blank) {
        let token = &text[range.bytes()];
        for at in range.bytes().filter(|at| !matches!(text.as_bytes()[*at], b'\r' | b'\n')) {
            let (scope, outer) = expected(kind.class(), token, at - range.start as usize);
            let is = |given: &String, scope: &str| given.strip_prefix(scope).is_some_and(|rest| rest.starts_with('.'));
            let fits = match (scopes[at].last(), kind.class()) {
                (None, _) => false,
                (Some(given), Class::Name) => NAMES.iter().any(|name| is(given, name)),
                (Some(_), _) if outer => scopes[at].iter().any(|given| is(given, scope)),
                (Some(given), _) => is(given, scope),
            };
            if !fits {
                return Some(format!("`{token}` ({kind:?}) is {:?}, not {scope}", scopes[at]));
            }
        }
    }
    None
}

/// Tries all that parse. Where `<-` is no arrow a warning says so: it looks like one to people and to this grammar.
fn agree(programs: impl IntoIterator<Item = Program>) {
    let programs: Vec<Program> = programs.into_iter().filter(|p| parse_file(&p.text).diagnostics.is_empty()).collect();
    assert!(programs.len() > 5);
    let programs = programs.as_slice();
    let Some(scopes) = scopes(programs) else { return };
    let mut wrong = String::new();
    for (program, scopes) in programs.iter().zip(&scopes) {
        if let Some(found) = misjudged(&program.text, scopes) {
            wrong += &format!("{}: {found}\n{}\n", program.name, program.text);
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn written_programs_have_the_scopes_of_their_classes() {
    agree(written());
}

#[test]
fn programs_of_the_book_have_the_scopes_of_their_classes() {
    agree(book());
}

/// Words that are names where they stand, comments that nest, text that looks like a comment.
#[test]
fn words_and_comments_have_the_scopes_of_what_they_are_there() {
    let texts = [
        "object count;\nobject weight;\nNumber prefer;\nprefer <- 2;\nprefer count.pos.x > weight weight 3;",
        "object objects;\nassert forall c in objects where .category = \"a\": near(c, c, weight - 1);",
        "predicate near(Object weight, Objects String, Number d) := weight.pos.x > d;\npredicate count(Object a) := true;",
        "assert count(c in chair: c.pos.x > 1) >= 2 and count(a, b);",
        "object in;\nassert exists\n  c in objects: c.where < in.weight;",
        "/* a /* b // c */ d\n \"e */ object a; // f /* g\n/// h\n//// i\nobject b; /// j",
        "a.features <- \"// no /* comment \\\" \\u00e9 é\"; // é\nobject größe; object 電灯;",
        "assert forall i in 0..4: chair[i].pos.x ≤ 5. ∨ ¬(chair[i + 1].top >= .5cm) && 1e3mm ≠ 2.5E-1ft;",
        "@req(\"one\")\n@req(\"two\")\nimport \"a.scene\";\nallowFloat(a);\nallowCollide(a, objects);",
    ];
    agree(texts.map(|text| Program { name: String::new(), text: text.into() }));
}

/// What no token is, is marked.
#[test]
fn errors_are_illegal() {
    let cases = [
        ("a <- 3kg;", "3kg"),
        ("a <- 1_000;", "1_000"),
        ("a <- 1.2.3;", "1.2.3"),
        ("a <- 'red';", "'red'"),
        ("a <- “red”;", "“red”"),
        ("assert a => 1;", "=>"),
        ("assert a -> b;", "->"),
        ("assert a × 2 = b;", "×"),
        ("@reqs(\"a\") object b;", "@reqs"),
        ("object a {};", "{"),
        ("a.color <- \"r\\xed\";", "\\x"),
        ("object a; #", "#"),
        ("object\u{a0}a;", "\u{a0}"),
    ];
    let programs = cases.map(|(text, _)| Program { name: String::new(), text: text.into() });
    let Some(all) = scopes(&programs) else { return };
    for ((text, bad), scopes) in cases.iter().zip(&all) {
        let start = text.find(bad).unwrap();
        for (at, scopes) in scopes.iter().enumerate() {
            let illegal = scopes.iter().any(|s| s.starts_with("invalid.illegal."));
            let wanted = (start..start + bad.len()).contains(&at) || *bad == "{" && text.as_bytes()[at] == b'}';
            assert_eq!(illegal, wanted, "{text} at {at}: {scopes:?}");
        }
    }
}

#[test]
fn sentences_of_the_grammar_have_the_scopes_of_their_classes() {
    agree(made(500));
}
