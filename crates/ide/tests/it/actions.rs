//! What can be done at a place, made.

use crate::fixture::Fixture;
use scenelang_base::TextRange;
use scenelang_ide::actions::{Detail, actions, all_safe, failing};

/// The lines behind the room after the action of a title at the cursor.
fn made(lines: &str, title: &str) -> String {
    let fixture = Fixture::with(lines);
    let all = actions(&fixture.snapshot, TextRange::empty(fixture.at), Detail::Edits).unwrap();
    let titles: Vec<&str> = all.iter().map(|a| a.title.as_str()).collect();
    let action = all.iter().find(|a| a.title == title).unwrap_or_else(|| panic!("{lines}: {titles:?}"));
    let text = fixture.edited(&action.edits);
    text.strip_prefix(crate::fixture::ROOM).unwrap_or(&text).to_owned()
}

#[test]
fn fixes_and_changes_of_form() {
    for (lines, title, wanted) in [
        ("assert bed.t$0po > 0;", "Write `top`", "assert bed.top > 0;"),
        ("object a1$0", "Insert `;`", "object a1;"),
        ("assert va$0se.top > 0;", "Declare `vase` as an object", "object vase;\nassert vase.top > 0;"),
        ("object id$0le;", "Allow W0201 here", "object idle; // allow(W0201)"),
        (
            "assert bed.t$0op > 0 and lamp.top > 0;",
            "Split into 2 assertions",
            "assert bed.top > 0;\nassert lamp.top > 0;",
        ),
        ("assert l$0ow(lamp, 1 + 1);", "Inline predicate `low`", "assert (lamp.top < (1 + 1));"),
        (
            "object c$0up1;\nobject cup2;\nassert cup1.top > cup2.top;",
            "Combine these objects into the array `cup[2]`",
            "object cup[2];\nassert cup[0].top > cup[1].top;",
        ),
    ] {
        assert_eq!(made(lines, title), wanted, "{title}");
    }
}

#[test]
fn a_category_that_is_misspelt_is_corrected() {
    let fixture = Fixture::with("lamp.category <- \"wadr$0obe\";");
    let all = actions(&fixture.snapshot, TextRange::empty(fixture.at), Detail::Edits).unwrap();
    assert!(all.iter().any(|a| a.title.contains("wardrobe")), "{:?}", all.iter().map(|a| &a.title).collect::<Vec<_>>());
}

#[test]
fn what_fails_here() {
    let fixture = Fixture::at("assert g$0ap(stand[1], bed)");
    assert_eq!(failing(&fixture.snapshot, TextRange::empty(fixture.at)).unwrap().len(), 1);
    let all = actions(&fixture.snapshot, TextRange::empty(fixture.at), Detail::Edits).unwrap();
    assert!(all.iter().any(|a| a.preferred && a.title.starts_with("Move `stand[1]` 0.12 m east")));
}

#[test]
fn a_color_that_is_misspelt_is_corrected() {
    assert_eq!(made("bed.color <- \"stelblu$0e\";", "Write \"steelblue\""), "bed.color <- \"steelblue\";",);
}

#[test]
fn all_that_is_safe() {
    let fixture = Fixture::with(";;\nobject a\n");
    let edit = all_safe(&fixture.snapshot).unwrap().unwrap();
    assert!(edit.text.ends_with("\nobject a;\n") && !edit.text.contains(";;"), "{}", edit.text);
    assert_eq!(all_safe(&Fixture::with("").snapshot).unwrap(), None);
}
