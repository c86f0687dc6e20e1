//! Another name, wherever it stands.

use crate::fixture::Fixture;
use scenelang_ide::rename::{renamable, rename};

#[test]
fn in_the_program_and_its_layout() {
    let fixture = Fixture::at("object b$0ed");
    assert_eq!(renamable(&fixture.snapshot, fixture.at).unwrap().map(|r| fixture.slice(r)), Some("bed"));
    let edits = rename(&fixture.snapshot, fixture.at, "couch").unwrap().unwrap();
    let text = fixture.edited(&edits);
    assert!(
        text.contains("object couch;\ncouch.category <- \"bed\";") && text.contains("gap(stand[1], couch)"),
        "{text}"
    );
    let elsewhere: Vec<&str> =
        edits.iter().filter(|e| e.place.file != fixture.snapshot.main()).map(|e| e.text.as_str()).collect();
    assert_eq!(elsewhere, ["\"couch\""]);
}

#[test]
fn what_cannot_be() {
    for (marked, new, why) in [
        ("object b$0ed", "lamp", "already"),
        ("object b$0ed", "9lives", "is not a name"),
        ("object b$0ed", "assert", "is not a name"),
        ("predicate l$0ow", "gap", "built-in"),
        ("assert o$0n(lamp", "upon", "nothing here can be renamed"),
        ("lamp.t$0op", "upper", "nothing here can be renamed"),
    ] {
        let fixture = Fixture::at(marked);
        let refused = rename(&fixture.snapshot, fixture.at, new).unwrap().unwrap_err();
        assert!(refused.contains(why), "{marked} {new}: {refused}");
    }
}
