//! The outline of a file, and names that are searched for.

use crate::fixture::Fixture;
use scenelang_ide::symbols::{Sort, declarations, matches, outline};

#[test]
fn an_outline() {
    let fixture = Fixture::with("");
    let found = outline(&fixture.snapshot, fixture.snapshot.main()).unwrap();
    let said: Vec<(&str, Sort, &str)> = found.iter().map(|e| (e.name.as_str(), e.sort, e.detail.as_str())).collect();
    assert_eq!(
        said,
        [
            ("room", Sort::Region, ""),
            ("bed", Sort::Object, ""),
            ("stand", Sort::Array, "[2]"),
            ("lamp", Sort::Object, ""),
            ("space", Sort::Variable, "Number"),
            ("low", Sort::Predicate, "(thing, height)"),
            ("assert on(lamp, stand[0])", Sort::Constraint, "a lamp stands on the left stand"),
            ("assert gap(stand[1], bed) >= space and lamp.top > 0.5", Sort::Constraint, ""),
        ]
    );
    assert_eq!(found.len() - declarations(&fixture.text).len(), 2, "constraints are not searched for");
}

#[test]
fn letters_in_their_order() {
    for (query, name, wanted) in
        [("stnd", "stand", true), ("ATH", "atHand", true), ("", "a", true), ("ba", "ab", false)]
    {
        assert_eq!(matches(query, name), wanted, "{query} {name}");
    }
}
