//! What the cursor speaks of.

use crate::fixture::Fixture;
use scenelang_ide::spoken::spoken;

#[test]
fn objects_arrays_elements_and_constraints() {
    for (lines, wanted) in [
        ("assert on(la$0mp, stand[1]);", Some("lamp")),
        ("assert on(lamp, sta$0nd[1]);", Some("stand[1]")),
        ("assert forall s in sta$0nd: near(s, bed, 3);", Some("stand")),
        ("object desk$0[6];", Some("desk")),
        ("lamp.co$0lor <- \"red\";", None),
        ("// la$0mp", None),
    ] {
        let fixture = Fixture::with(lines);
        assert_eq!(spoken(&fixture.snapshot, fixture.at, "room.scene").unwrap().as_deref(), wanted, "{lines}");
    }
    let fixture = Fixture::at("assert g$0ap(stand[1], bed)");
    let found = spoken(&fixture.snapshot, fixture.at, "room.layout.json").unwrap().unwrap();
    assert!(found.ends_with("room.scene:16:1"), "{found}");
}
