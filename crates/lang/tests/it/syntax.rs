//! The parser: trees of what parses, messages for what does not, and promises that hold for any text.
//!
//! Each `syntax/*.scene` holds broken statements; what is said of them stands in `snapshots/`.
#![allow(clippy::unwrap_used)] // the helpers of tests may fail as tests do

use crate::shape;
use crate::soup;
use proptest::prelude::*;
use scenelang_base::{Applicability, Diagnostic, Fix, SourceFile, TextRange};
use scenelang_lang::parse::core::check_core;
use scenelang_lang::parse::{ParsedFile, parse_file};
use std::fmt::Write;
use std::path::Path;

fn shapes(text: &str) -> Vec<String> {
    parse_file(text).statements.iter().map(|(_, s)| shape::stmt(s)).collect()
}

fn errors(file: &ParsedFile) -> usize {
    file.diagnostics.iter().filter(|d| d.is_error()).count()
}

fn apply(text: &str, fix: &Fix<TextRange>) -> String {
    let mut edits = fix.edits.clone();
    edits.sort_by_key(|e| e.place.start);
    let mut made = text.to_owned();
    for edit in edits.iter().rev() {
        made.replace_range(edit.place.bytes(), &edit.text);
    }
    made
}

/// A diagnostic as a person would like to read it, with what each fix makes of the line.
fn render(out: &mut String, file: &SourceFile, d: &Diagnostic<TextRange>) {
    let primary = d.primary.as_ref().unwrap();
    let (from, to) = (file.position(primary.place.start), file.position(primary.place.end));
    let line = |text: &str| text.lines().nth(from.line as usize - 1).unwrap_or("").to_owned();
    let width = if from.line == to.line { (to.column - from.column).max(1) as usize } else { 1 };
    writeln!(out, "{}[{}] {}:{}: {}", d.severity.as_str(), d.code, from.line, from.column, d.message).unwrap();
    writeln!(out, "    {}", line(file.text()).replace('\t', " ")).unwrap();
    let marks = format!("{}{} {}", " ".repeat(from.column as usize + 3), "^".repeat(width), primary.message);
    writeln!(out, "{}", marks.trim_end()).unwrap();
    for related in &d.related {
        let at = file.position(related.place.start);
        writeln!(out, "  {}:{}: {}", at.line, at.column, related.message).unwrap();
    }
    for note in &d.notes {
        writeln!(out, "  note: {note}").unwrap();
    }
    for fix in &d.fixes {
        let sure = if fix.applicability == Applicability::Safe { "fix" } else { "perhaps" };
        writeln!(out, "  {sure}: {}\n    {}", fix.title, line(&apply(file.text(), fix))).unwrap();
    }
}

pub fn fixtures() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/syntax");
    let mut all: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| {
            let path = entry.unwrap().path();
            (path.file_stem().unwrap().to_str().unwrap().to_owned(), std::fs::read_to_string(&path).unwrap())
        })
        .collect();
    all.sort();
    assert!(all.len() >= 8, "the fixtures are not where they should be");
    all
}

#[test]
fn messages() {
    for (name, text) in fixtures() {
        let file = SourceFile::new(&name, &name, &text);
        let mut parsed = parse_file(&text);
        if name == "core" {
            for (offset, stmt) in &parsed.statements {
                parsed.diagnostics.extend(check_core(stmt).into_iter().map(|d| d.map_places(|r| r.shifted(*offset))));
            }
        }
        let mut out = String::new();
        parsed.diagnostics.iter().for_each(|d| render(&mut out, &file, d));
        insta::with_settings!({ prepend_module_to_snapshot => false, omit_expression => true }, {
            insta::assert_snapshot!(format!("syntax-{name}"), out);
        });
    }
}

/// A fix that claims to be safe repairs what it is attached to, and nothing gets worse.
#[test]
fn safe_fixes_repair() {
    let mut tried = 0;
    for (name, text) in fixtures() {
        let parsed = parse_file(&text);
        for d in &parsed.diagnostics {
            for fix in d.fixes.iter().filter(|f| f.applicability == Applicability::Safe) {
                let repaired = parse_file(&apply(&text, fix));
                let count = |file: &ParsedFile| file.diagnostics.iter().filter(|e| e.code == d.code).count();
                let better = count(&repaired) < count(&parsed) && errors(&repaired) <= errors(&parsed);
                assert!(better, "{name}: {} — {}", d.message, fix.title);
                tried += 1;
            }
        }
    }
    assert!(tried > 20, "only {tried} fixes were tried");
}

#[test]
fn trees() {
    let cases = [
        ("object a;", "Object a"),
        ("entity chair[6];", "Object chair[6]"),
        ("Vector3 v;", "Vector3 v"),
        ("lamp.pos <- vec3(1, -2, 3cm);", "lamp.pos <- vec3(1, (neg 2), 3Cm)"),
        ("chair[1].color ← \"red\";", "chair[1].color <- \"red\""),
        ("assert a + b * -c - d / 2 < 1;", "assert ((Sub (Add a (Mul b (neg c))) (Div d 2)) Lt 1)"),
        ("assert not a = 1 and b or c;", "assert (Or (And (not (a Eq 1)) b) c)"),
        ("assert a implies b implies c;", "assert (Implies a (Implies b c))"),
        ("assert a implies b or c and not d;", "assert (Implies a (Or b (And c (not d))))"),
        (
            "assert ¬a ∧ b ∨ c ≠ d && e ≤ f || g ≥ h;",
            "assert (Or (Or (And (not a) b) (And (c Ne d) (e Le f))) (g Ge h))",
        ),
        ("assert (a < b) = (c == d);", "assert ((a Lt b) Eq (c Eq d))"),
        ("assert a.rot.y <-1;", "assert (a.rot.y Lt (neg 1))"),
        ("assert a <- b + c;", "assert (a Lt (Add (neg b) c))"),
        ("assert (a.pos).x > -(1);", "assert (a.pos.x Gt (neg 1))"),
        (
            "assert forall d in desk: exists c in chair: near(c, d, 1) and facing(c, d);",
            "assert (Forall d desk: (Exists c chair: (And near(c, d, 1) facing(c, d))))",
        ),
        (
            "assert exists c in objects where .category = \"seat\" and not .color = \"red\": c.pos.x > 0;",
            "assert (Exists c (where OBJECTS (And (.category Eq \"seat\") (not (.color Eq \"red\")))): (c.pos.x Gt 0))",
        ),
        ("assert a and forall c in s: p(c) or q(c);", "assert (And a (Forall c s: (Or p(c) q(c))))"),
        ("assert count(c in s: inside(c, r)) >= 2;", "assert ((Count c s: inside(c, r)) Ge 2)"),
        (
            "assert forall i in 0..n - 1: p(c[i], c[i + 1]);",
            "assert (Forall i (0 .. (Sub n 1)): p(c[i], c[(Add i 1)]))",
        ),
        ("prefer a > 1 and b weight 2.5;", "prefer (And (a Gt 1) b) weight 2.5"),
        ("prefer forall c in s: c weight 2;", "prefer (Forall c s: c) weight 2"),
        ("prefer a;", "prefer a weight -"),
        ("allowCollide(rug, objects);", "allow Collide rug OBJECTS"),
        ("allowFloat(a[1]);", "allow Float a[1]"),
        (
            "predicate around(Objects s, Object b, Number d, String t) := (forall c in s: gap(c, b) <= d);",
            "predicate around(Objects s, Object b, Number d, String t) := (Forall c s: (gap(c, b) Le d))",
        ),
        ("import \"a/b.scene\";", "import \"a/b.scene\""),
        ("/// one\n//  plain\n///two\n@req(\"x\") @req(\"y;\") object a;", "\"one\\ntwo\" @\"x\" @\"y;\" Object a"),
        (";", ";"),
        // Only core words are reserved.
        ("object near;", "Object near"),
        ("object objects;", "Object objects"),
        ("objects.pos <- forall.pos;", "objects.pos <- forall.pos"),
        (
            "assert in.where > count(weight) and prefer[1].import;",
            "assert (And (in.where Gt count(weight)) prefer[1].import)",
        ),
        ("prefer <- 3;", "prefer <- 3"),
        ("prefer prefer weight weight;", "prefer prefer weight weight"),
        ("assert a.object.assert.rot > 1;", "assert (a.object.assert.rot Gt 1)"),
    ];
    for (text, expected) in cases {
        let parsed = parse_file(text);
        assert_eq!(errors(&parsed), 0, "{text}: {:?}", parsed.diagnostics);
        assert_eq!(shapes(text), [expected], "{text}");
    }
}

/// What a broken statement declares, assigns or defines is kept.
#[test]
fn salvage() {
    let cases: &[(&str, &[&str])] = &[
        ("object a, b;", &["Object a", "Object b"]),
        ("object a b;", &["Object a", "Object b"]),
        ("objct a;", &["Object a"]),
        ("Object a[3];", &["Object a[3]"]),
        ("object a[];", &["Object a[ERROR]"]),
        ("object a[3;", &["Object a[3]"]),
        ("Color c <- \"red\";", &["Color c", "c <- ERROR"]),
        ("object a object b;", &["Object a", "Object b"]),
        ("a.color <- ;", &["a.color <- ERROR"]),
        ("a.color := \"red\";", &["a.color <- ERROR"]),
        ("n = 3;", &["n <- ERROR"]),
        ("a[i + 1].pos <- vec3(;", &["a[ERROR].pos <- ERROR"]),
        ("predicate p(Object a, Number d) = a > d;", &["predicate p(Object a, Number d) := ERROR"]),
        ("predicate p(a) := a > 1;", &["predicate p() := ERROR"]),
        ("import parts.scene;", &["import \"parts.scene\""]),
        ("assert a > 1,\nassert b > 1;", &["assert (a Gt 1)", "assert (b Gt 1)"]),
        ("assert a > ;", &["error"]),
        ("asert a > 1;", &["assert (a Gt 1)"]),
        ("assert a > =1;", &["error"]),
        ("assert a => 1 and b = 'x' and c < 3kg;", &["assert (And (And (a Ge 1) (b Eq \"x\")) (c Lt ERROR))"]),
        ("a.color <- \"red;\nb.color <- \"blue\";", &["a.color <- ERROR", "b.color <- \"blue\""]),
        ("/// doc\n@req(\"x\") object a", &["\"doc\" @\"x\" Object a"]),
        ("object a /// not b's\n/// doc of b\nobject b;", &["Object a", "\"doc of b\" Object b"]),
    ];
    for (text, expected) in cases {
        assert!(errors(&parse_file(text)) > 0, "{text}");
        assert_eq!(shapes(text), *expected, "{text}");
    }
}

#[test]
fn ranges_are_those_of_the_text() {
    let text = "/// doc\n@req(\"x\") assert (a.pos).x > f(b) ; ";
    let (offset, stmt) = &parse_file(text).statements[0];
    let slice = |range: TextRange| &text[range.shifted(*offset).bytes()];
    assert_eq!(slice(stmt.range), "assert (a.pos).x > f(b)");
    assert_eq!(slice(stmt.attributes.unwrap()), "@req(\"x\")");
    assert_eq!(slice(stmt.requirements[0].1), "\"x\"");
    let exprs: Vec<&str> = stmt.exprs.iter().map(|e| slice(e.range)).collect();
    assert_eq!(exprs, ["a", "a.pos", "(a.pos).x", "b", "f(b)", "(a.pos).x > f(b)"]);
}

/// Hostile inputs: refused or read, on the small stack of a test's thread.
#[test]
fn nothing_overflows() {
    let n = 10_000;
    let refused = [
        format!("assert {}a{} > 1;", "(".repeat(n), ")".repeat(n)),
        format!("assert {};", "(".repeat(n)),
        format!("assert a{};", "[".repeat(n)),
        format!("assert {}a;", "not ".repeat(n)),
        format!("assert {}1 > 2;", "-".repeat(n)),
        format!("assert {}a;", "a implies ".repeat(n)),
        format!("assert {}a;", "forall x in s: ".repeat(n)),
        format!("assert {}1 > 2;", "1 + ".repeat(5 * n)),
        format!("assert {}true;", "a and ".repeat(5 * n)),
        format!("assert a{} > 1;", ".pos".repeat(n)),
        format!("assert a{} > 1;", "[0]".repeat(n)),
        format!("asert {}a{} > 1;", "(".repeat(n), ")".repeat(n)),
        format!("a{} <- 1;", "[0".repeat(n)),
    ];
    for text in refused {
        let parsed = parse_file(&text);
        let codes: Vec<&str> = parsed.diagnostics.iter().map(|d| d.code.as_str()).collect();
        assert_eq!(codes, ["E0004"], "{}", &text[..40]);
    }
    let nearly = [
        format!("assert {}a{} > 1;", "(".repeat(990), ")".repeat(990)),
        format!("assert {}a > 1;", "not ".repeat(990)),
        format!("assert {}a > 1;", "forall x in s: ".repeat(990)),
        format!("assert {}1{} > 1;", "count(x in s: ".repeat(490), ")".repeat(490)),
        format!("assert {}a > 1;", "a - 1 > -1 and ".repeat(990)),
    ];
    for text in nearly {
        let parsed = parse_file(&text);
        assert_eq!(errors(&parsed), 0, "{:?}", parsed.diagnostics);
        assert!(check_core(&parsed.statements[0].1).len() <= 990);
    }
    for text in
        [format!("object {};", "a".repeat(1_000_000)), "object a;\n@@ ## $$ ;\n".repeat(2000), "a ".repeat(200_000)]
    {
        let _ = parse_file(&text);
    }
    let comment = parse_file(&format!("object a;\n{}", "/*".repeat(20_000)));
    assert_eq!(comment.diagnostics.len(), 1);
    let digits = parse_file(&format!("assert a < {};", "9".repeat(100_000)));
    assert_eq!(digits.diagnostics.len(), 1);
}

/// Every place in every diagnostic can be shown, and no fix is out of bounds.
fn check_places(text: &str) {
    let parsed = parse_file(text);
    let inside = |r: TextRange| r.start <= r.end && text.get(r.bytes()).is_some();
    for d in &parsed.diagnostics {
        let labels = d.primary.iter().chain(&d.related).map(|l| l.place);
        let edits = d.fixes.iter().flat_map(|f| f.edits.iter().map(|e| e.place));
        labels.chain(edits).for_each(|place| assert!(inside(place), "{d:?} in {text:?}"));
        for fix in &d.fixes {
            let _ = parse_file(&apply(text, fix));
        }
    }
    for (offset, stmt) in &parsed.statements {
        assert!(inside(stmt.range.shifted(*offset)), "{stmt:?}");
        assert!(stmt.exprs.iter().all(|e| inside(e.range.shifted(*offset))), "{stmt:?}");
        let _ = check_core(stmt);
        let _ = shape::stmt(stmt);
    }
}

#[test]
fn every_prefix_of_the_fixtures_is_read() {
    for (_, text) in fixtures() {
        for (end, _) in text.char_indices().step_by(3) {
            check_places(&text[..end]);
        }
    }
}

proptest! {
    #[test]
    fn any_words_are_read(text in soup::soup()) {
        check_places(&text);
    }

    #[test]
    fn programs_parse(text in soup::program()) {
        let found = parse_file(&text);
        let codes: Vec<&str> = found.diagnostics.iter().filter(|d| d.is_error()).map(|d| d.code.as_str()).collect();
        prop_assert!(codes.is_empty(), "{:?}\n{}", found.diagnostics, text);
    }

    /// What is said of a statement does not depend on its neighbours.
    #[test]
    fn statements_are_independent(text in soup::program()) {
        let alone = shapes(&text);
        let among = shapes(&format!("object before;\n{text}\nassert after > ;"));
        prop_assert_eq!(&among[1..among.len() - 1], &alone[..]);
    }
}
