//! What is said of the thing under the cursor.

use crate::fixture::Fixture;
use scenelang_ide::hover::hover;

fn said(fixture: &Fixture) -> Option<String> {
    let (range, text) = hover(&fixture.snapshot, fixture.at).unwrap()?;
    assert!(range.start <= fixture.at && fixture.at <= range.end, "{text}");
    Some(text)
}

/// Each part, separated by `|`, is in what is said.
fn says(fixture: &Fixture, parts: &str) {
    let text = said(fixture).unwrap_or_else(|| panic!("nothing is said; wanted {parts}"));
    for part in parts.split('|') {
        assert!(text.contains(part), "no {part:?} in {text}");
    }
}

#[test]
fn names() {
    for (marked, parts) in [
        ("object $0bed", "object bed|Where one sleeps|`bed` is at (0, 0, -0.9), 1.60 × 0.55 × 2.00 m|fails: "),
        ("object $0stand", "object stand[2]|`stand[1]` is at"),
        ("region r$0oom", "region room|4.00 × 2.60 × 4.00 m"),
        ("Number $0space", "Number space|is `0.02` in the layout"),
        ("assert o$0n(lamp", "predicate on(Object a, Object b)|of the standard library"),
        ("lamp.t$0op", "object.top : Number|is `0.9` in the layout|margin"),
        ("g$0ap(stand[1]", "gap(Object a, Object b) -> Number|distance between the surfaces"),
        ("low(Object t$0hing", "Object thing|parameter"),
    ] {
        says(&Fixture::at(marked), parts);
    }
    says(&Fixture::with("assert atH$0and(lamp, bed);"), "predicate atHand(Object a, Object b)|within arm's length");
    says(
        &Fixture::with("bed.color <- one$0Of(\"red\", \"blue\");"),
        "oneOf(String a, String b, …) -> String|drawn with equal chances",
    );
    says(&Fixture::with("assert forall $0s in stand: s.top < 1;"), "Object s|variable of a quantifier");
    assert_eq!(said(&Fixture::with("// a be$0d")), None);
}

#[test]
fn constraints_and_their_parts() {
    says(
        &Fixture::at("as$0sert gap(stand[1], bed) >= space and"),
        "**fails**, margin **−0.12 m**|to repair it: move `stand[1]` 0.12 m east|\
         `gap(stand[1], bed) >= space` **fails**, margin −0.12 m|`lamp.top > 0.5` holds, margin +0.40 m",
    );
    // What is no conjunction has no parts.
    let one = said(&Fixture::at("as$0sert on(lamp, stand[0])")).unwrap();
    assert!(one.starts_with("holds") && !one.contains("`on(lamp, stand[0])`"), "{one}");
    // Each instance of a quantifier belongs to the part that it is in.
    says(
        &Fixture::with("as$0sert (forall s in stand: near(s, bed, 5)) and bed.top < 0.1;"),
        "`forall s in stand: near(s, bed, 5)` holds|`bed.top < 0.1` **fails**, margin −0.45 m",
    );
}

/// On a predicate of a conjunction its own verdict is said, not that of the whole.
#[test]
fn a_part_of_a_conjunction_says_whether_it_holds() {
    for (statement, state) in [
        ("assert ga$0p(stand[0], bed) >= 0.01 and lamp.top > 3;", "\n---\nholds, margin **+"),
        ("assert ga$0p(stand[1], bed) >= 2 and lamp.top > 0.5;", "\n---\n**fails**, margin **−"),
        ("assert gap(stand[1], bed) >= 2 and ne$0ar(lamp, bed, 5);", "\n---\nholds, margin **+"),
        // An instance of a quantifier, and what is behind another `and`.
        ("assert forall s in stand: ne$0ar(s, bed, 5) and s.top > 3;", "\n---\nholds, margin **+"),
        ("assert forall s in stand: near(s, bed, 5) and s.t$0op > 3;", "\n---\n**fails**, margin **−"),
        ("assert bed.top < 0.1 and (lamp.top > 0 and on$0Floor(bed, room));", "\n---\nholds"),
        // No conjunction: the whole is the part.
        ("assert ne$0ar(lamp, bed, 0.01) or bed.top > 3;", "\n---\n**fails**"),
    ] {
        says(&Fixture::with(statement), state);
    }
}

#[test]
fn requirements() {
    says(
        &Fixture::at("@r$0eq(\"a lamp stands on the left stand\")"),
        "“a lamp stands on the left stand”|is met|- line 15: `assert on(lamp, stand[0])`: holds",
    );
    let twice = "@req(\"a lamp stands on the left st$0and\")\nassert bed.top > 3;";
    says(
        &Fixture::with(twice),
        "is **not met**: 1 of 2 hold|- line 15: |- line 18: `assert bed.top > 3`: **fails**, margin **−2.45 m**",
    );
    says(&Fixture::with("@re$0q(\"a plant\")\nobject plant;"), "“a plant”|- line 18: `object plant`");
}

#[test]
fn words_of_the_language() {
    for (lines, parts) in [
        ("obj$0ect x;", "```scene\nobject chair[4];\n```|declares an object"),
        ("pre$0fer bed.top > 0;", "holds, margin|states a preference"),
        ("assert bed.top > 0 a$0nd bed.top > 0;", "margin is the smaller"),
        ("assert for$0all s in stand: s.top > 0;", "holds for each"),
        ("allow$0Collide(bed, lamp);", "may not overlap"),
        ("Deg$0ree turn;", "declares an angle"),
        ("im$0port \"parts.scene\";", "reads another program"),
    ] {
        says(&Fixture::with(lines), parts);
    }
    assert_eq!(said(&Fixture::with("object c[$03];")), None);
}

#[test]
fn categories() {
    says(&Fixture::at("bed.category <- \"b$0ed\""), "**bed**|usual size: |m (width × height × depth)");
    says(&Fixture::with("lamp.category <- \"flor la$0mp\";"), "**flor lamp**");
    says(&Fixture::with("lamp.category <- \"wadrobe$0 \";"), "no usual size is known; did you mean `wardrobe`?");
    // Another text is no category.
    assert_eq!(said(&Fixture::with("lamp.color <- \"be$0d\";")), None);
}
