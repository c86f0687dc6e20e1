//! A draft becomes a program that reads well, compiles without a word, and is left alone by the formatter.

use crate::support::{complaints, office, room, thing};
use scenelang_formalize::draft::{Draft, Note, ThingOrigin};
use scenelang_formalize::{arrange_rooms, write::write};
use scenelang_lang::fmt::{FormatOptions, format};

#[test]
fn reads_like_a_program() {
    let mut draft = office();
    arrange_rooms(&mut draft);
    let program = write(&draft);
    insta::assert_snapshot!(program);
    assert_eq!(complaints(&program), [] as [&str; 0]);
    assert_eq!(format(&program, &FormatOptions::default()), program);
}

#[test]
fn an_outline_and_no_walls() {
    let mut yard = room("yard", [8.0, 6.0]);
    yard.outline = Some(vec![[-4.0, -3.0], [4.0, -3.0], [4.0, 0.0], [0.0, 0.0], [0.0, 3.0], [-4.0, 3.0]]);
    let draft = Draft { request: "A yard.".into(), outdoor: true, rooms: vec![yard], ..Draft::default() };
    let program = write(&draft);
    assert!(program.contains("yard.features <- \"outdoor\";"), "{program}");
    assert!(program.contains("yard.vertices <- polygon("), "{program}");
    assert_eq!(complaints(&program), [] as [&str; 0]);
}

/// Whatever a request holds stays text: nothing of it becomes a statement, or silences a warning.
fn stays_text(words: &str) {
    let all = 0..words.len();
    let mut chair = thing("chair", "chair", Some(0));
    chair.look.color = Some(words.into());
    chair.look.material = Some(words.into());
    chair.look.features = vec![words.into(), words.into()];
    chair.source = ThingOrigin::Stated(all.clone());
    let mut cell = room("cell", [4.0, 4.0]);
    cell.kind = words.into();
    cell.walls.color = Some(words.into());
    cell.source = ThingOrigin::Inferred(words.into());
    let draft = Draft {
        request: words.into(),
        rooms: vec![cell],
        things: vec![chair],
        notes: vec![Note { at: all, reason: words.into() }],
        ..Draft::default()
    };
    let program = write(&draft);
    assert_eq!(complaints(&program), [] as [&str; 0], "{words:?}:\n{program}");
    assert_eq!(format(&program, &FormatOptions::default()), program, "{words:?}");
    assert!(!program.lines().any(|line| line.trim_start().starts_with("object evil")), "{program}");
}

#[test]
fn words_stay_words() {
    let hostile = [
        "\"); object evil; // \\",
        "\" \n object evil; \n@req(\"",
        "*/ object evil; /*",
        "allow(W0201) // allow(W0402)\nobject evil;",
        "\u{202e}evil\u{0}\u{2028}object evil;",
        "",
        "🪑🪑🪑 椅子を置く。",
        "\\u0022); object evil;",
        "\u{feff}object evil;\r\nobject evil;",
    ];
    hostile.iter().for_each(|words| stays_text(words));
}

proptest::proptest! {
    #[test]
    fn any_words_stay_words(words in r#"(\PC|[\\"/*(){};@\n\r\t\x00-\x1f]|allow\(W0201\)|object evil;|//|\*/){0,40}"#) {
        stays_text(&words);
    }
}
