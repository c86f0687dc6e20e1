//! Colours in a program, and how else they are written.

use crate::fixture::{Fixture, Words};
use scenelang_ide::colors::{colors, spellings};

#[test]
fn texts_that_are_colours() {
    let fixture = Fixture::with(
        "bed.color <- \"steelblue\";\nroom.wallColor <- \"red\";\nlamp.category <- \"red\";\nbed.color <- \"none such\";\n",
    );
    let found = colors(&fixture.snapshot, &Words).unwrap();
    let said: Vec<(&str, [u8; 3])> = found.into_iter().map(|(range, rgb)| (fixture.slice(range), rgb)).collect();
    assert_eq!(said, [("steelblue", [70, 130, 180]), ("red", [255, 0, 0])]);
}

#[test]
fn exactly_and_by_the_nearest_name() {
    assert_eq!(spellings([255, 3, 0], &Words), ["#ff0300", "red"]);
    assert_eq!(spellings([0, 255, 0], &Words), ["#00ff00"]);
}
