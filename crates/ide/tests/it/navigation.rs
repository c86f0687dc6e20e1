//! From a name to where it comes from, and to wherever else it stands.

use crate::fixture::Fixture;
use scenelang_ide::navigate::{NavigationTarget, declaration, definition, highlights, type_definition};
use scenelang_lang::library;

/// Where a target is: the file, and the text of the name there.
fn place(fixture: &Fixture, target: NavigationTarget) -> String {
    match target {
        NavigationTarget::File(span, _) => {
            let file = fixture.snapshot.sources().get(span.file);
            let name = file.path().file_name().unwrap().to_string_lossy();
            format!("{name} {}", file.slice(span.range)).trim().to_owned()
        }
        NavigationTarget::Library(file, name, _) => {
            format!("{} {}", library::FILES[file].0, &library::FILES[file].1[name.bytes()])
        }
    }
}

#[test]
fn definitions_declarations_and_types() {
    type Find = fn(
        &scenelang_ide::Snapshot,
        u32,
    ) -> Result<Option<(scenelang_base::TextRange, NavigationTarget)>, scenelang_ide::Cancelled>;
    let [defined, declared, kind]: [Find; 3] = [definition, declaration, type_definition];
    for (find, lines, wanted) in [
        (defined, "assert on(lamp, st$0and[0]);", Some("room.scene stand")),
        (defined, "assert forall s in stand: near($0s, bed, 1);", Some("room.scene s")),
        (defined, "assert at$0Hand(lamp, bed);", Some("parts.scene atHand")),
        (defined, "assert o$0n(lamp, stand[0]);", Some("std/contact.scene on")),
        (defined, "import \"par$0ts.scene\";", Some("parts.scene")),
        (declared, "space <- 3;\nassert bed.top < spa$0ce;", Some("room.scene space")),
        (declared, "assert bed.t$0op < 1;", None),
        (kind, "assert on(st$0and[0], bed);", Some("room.scene stand.category")),
        (kind, "assert forall s in stand: near($0s, bed, 1);", Some("room.scene stand")),
    ] {
        let fixture = Fixture::with(lines);
        let found = find(&fixture.snapshot, fixture.at).unwrap().map(|(_, target)| place(&fixture, target));
        assert_eq!(found.as_deref(), wanted, "{lines}");
    }
}

#[test]
fn wherever_else_it_stands() {
    let fixture = Fixture::at("Number sp$0ace");
    let found = highlights(&fixture.snapshot, fixture.at).unwrap();
    assert_eq!(
        found.iter().map(|(r, role)| format!("{} {role:?}", fixture.slice(*r))).collect::<Vec<_>>(),
        ["space Declares", "space Reads"]
    );
}
