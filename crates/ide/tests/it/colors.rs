//! Colours in a program, and how else they are written.

use crate::fixture::Fixture;
use scenelang_assets::color_of;
use scenelang_ide::colors::{colors, spellings};

#[test]
fn texts_that_are_colours() {
    let fixture = Fixture::with(
        "bed.color <- \"steelblue\";\nroom.wallColor <- \"red\";\nlamp.category <- \"red\";\nbed.color <- \"none such\";\n",
    );
    let found = colors(&fixture.snapshot).unwrap();
    let said: Vec<(&str, [u8; 3])> = found.into_iter().map(|(range, rgb)| (fixture.slice(range), rgb)).collect();
    let rgb = |name: &str| color_of(name).unwrap();
    assert_eq!(said, [("steelblue", rgb("steelblue")), ("red", rgb("red"))]);
}

#[test]
fn exactly_and_by_the_nearest_name() {
    let [r, g, b] = color_of("red").unwrap();
    assert_eq!(spellings([r, g, b + 3]), [format!("#{r:02x}{g:02x}{:02x}", b + 3), "red".to_owned()]);
    assert_eq!(spellings([0, 255, 0]), ["#00ff00"]);
}
