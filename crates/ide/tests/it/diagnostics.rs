//! What is marked, and where.

use crate::fixture::{Fixture, ROOM};
use scenelang_ide::diagnostics::diagnostics;

/// `code text: message`, in the main file.
fn marked(fixture: &Fixture) -> Vec<String> {
    let found = diagnostics(&fixture.snapshot).unwrap();
    let own = found.iter().filter_map(|f| {
        let label = f.diagnostic.primary.as_ref()?;
        let text = fixture.snapshot.slice(label.place).split_whitespace().collect::<Vec<_>>().join(" ");
        Some(format!("{} {text}: {}", f.diagnostic.code, f.diagnostic.message))
    });
    own.collect()
}

#[test]
fn what_fails_is_a_sentence_with_names() {
    let all = marked(&Fixture::with("assert facing(lamp, bed);\nassert leftOf(bed, lamp);\n"));
    let starts = |start: &str| all.iter().any(|m| m.starts_with(start));
    assert!(
        starts("V0101 assert gap(stand[1], bed) >= space and lamp.top > 0.5: `gap(stand[1], bed)` is -0.1"),
        "{all:#?}"
    );
    // By the sentence of the predicate, not by its formula.
    for (predicate, names) in
        [("assert facing(lamp, bed)", ["`lamp`", "`bed`"]), ("assert leftOf(bed, lamp)", ["`bed`", "`lamp`"])]
    {
        let own = all.iter().find(|m| m.contains(predicate)).unwrap_or_else(|| panic!("{predicate}: {all:#?}"));
        let (_, message) = own.split_once(": ").unwrap();
        assert!(names.iter().all(|name| message.contains(name)) && !message.contains("dot("), "{message}");
    }
    // A rule is shown at the declarations of both.
    assert!(starts("V0102 bed: ") && starts("V0102 stand: "), "{all:#?}");
}

#[test]
fn a_misspelt_category_is_marked() {
    let all = marked(&Fixture::with("lamp.category <- \"wadrobe\";\n"));
    assert!(all.iter().any(|m| m.starts_with("W0205 \"wadrobe\": ")), "{all:#?}");
    assert!(marked(&Fixture::new(ROOM)).iter().all(|m| !m.starts_with("W0205")));
}
