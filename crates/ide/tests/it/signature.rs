//! What a call takes, and which argument is being written.

use crate::fixture::Fixture;
use scenelang_ide::signature::help;

#[test]
fn calls() {
    for (lines, label, argument) in [
        ("assert near(bed, $0", "near(Object a, Object b, Number d)", 1),
        ("assert near(bed, lamp, max(1, $0", "max(x, y, …)", 1),
        ("assert low($0", "low(Object thing, Number height)", 0),
        ("assert atHand(bed, $0);", "atHand(Object a, Object b)", 1),
        ("allowCollide(bed, $0", "allowCollide(a, b)", 1),
        ("bed.color <- oneOf(\"red\", $0", "oneOf(a, b, …)", 1),
        ("bed.pos <- vec3(1, 2, $0", "vec3(Number x, Number y, Number z) -> Vector3", 2),
    ] {
        let fixture = Fixture::with(lines);
        let found = help(&fixture.snapshot, fixture.at).unwrap().unwrap_or_else(|| panic!("{lines}"));
        assert_eq!((found.signatures[found.active].label.as_str(), found.argument), (label, argument), "{lines}");
    }
    let fixture = Fixture::with("assert distance(bed, room) $0");
    assert_eq!(help(&fixture.snapshot, fixture.at).unwrap(), None);
}
