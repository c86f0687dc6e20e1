//! What can be folded, what a selection grows to, links, and names that change together.

use crate::fixture::Fixture;
use scenelang_ide::shape::{Fold, Link, folds, linked, links, selections};

#[test]
fn sections_comments_imports_and_statements() {
    let text = "// one\n// two\nimport \"a\";\nimport \"b\";\n// ---- Doors ----\nobject a;\nassert a.top >\n  1;\n";
    let found: Vec<(&str, Fold)> = folds(text).into_iter().map(|(r, fold)| (&text[r.bytes()], fold)).collect();
    assert_eq!(
        found,
        [
            ("// one\n// two", Fold::Comment),
            ("import \"a\";\nimport \"b\";", Fold::Imports),
            ("// ---- Doors ----\nobject a;\nassert a.top >\n  1;", Fold::Section),
            ("assert a.top >\n  1;", Fold::Statement),
        ]
    );
}

#[test]
fn a_selection_grows() {
    let text = "assert near(a, b + 1);";
    let found: Vec<&str> = selections(text, 15).into_iter().map(|r| &text[r.bytes()]).collect();
    assert_eq!(found[..3], ["b", "b + 1", "(a, b + 1)"]);
    assert_eq!(found.last(), Some(&text));
}

#[test]
fn imports_and_the_layout_are_links() {
    let fixture = Fixture::with("// its places are in room.layout.json\n");
    let found = links(&fixture.snapshot).unwrap();
    let said: Vec<(&str, bool)> =
        found.iter().map(|(range, link)| (fixture.slice(*range), *link == Link::Layout)).collect();
    assert_eq!(said, [("parts.scene", false), ("room.layout.json", true)]);
}

#[test]
fn names_that_change_together() {
    let fixture = Fixture::at("low(Object th$0ing, Number");
    let found = linked(&fixture.snapshot, fixture.at).unwrap();
    assert_eq!(found.iter().map(|r| fixture.slice(*r)).collect::<Vec<_>>(), ["thing", "thing"]);
    let fixture = Fixture::at("object b$0ed");
    assert_eq!(linked(&fixture.snapshot, fixture.at).unwrap(), [], "the layout knows it");
}
