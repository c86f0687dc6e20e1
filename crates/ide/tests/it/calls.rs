//! Who speaks of whom.

use crate::fixture::Fixture;
use scenelang_ide::calls::{incoming, item_at, outgoing};

#[test]
fn from_an_object_to_what_was_asked_for_and_back() {
    let fixture = Fixture::at("object la$0mp");
    let names = |found: Vec<(scenelang_ide::calls::Item, Vec<scenelang_base::TextRange>)>| {
        found.into_iter().map(|(item, _)| item).collect::<Vec<_>>()
    };
    let lamp = item_at(&fixture.snapshot, fixture.at).unwrap().unwrap();
    assert_eq!(lamp.name, "lamp");
    let constraints = names(incoming(&fixture.snapshot, &lamp.node).unwrap());
    assert_eq!(constraints[0].name, "assert on(lamp, stand[0])");
    let asked = names(incoming(&fixture.snapshot, &constraints[0].node).unwrap());
    assert_eq!(asked[0].name, "a lamp stands on the left stand");
    let answers = names(outgoing(&fixture.snapshot, &asked[0].node).unwrap());
    assert_eq!(answers[0].name, "assert on(lamp, stand[0])");
    let things = names(outgoing(&fixture.snapshot, &answers[0].node).unwrap());
    assert_eq!(things.iter().map(|i| i.name.as_str()).collect::<Vec<_>>(), ["lamp", "stand"]);
}
