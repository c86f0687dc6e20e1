//! What is shown between the words, only where it says something; and what can be done above a line.

use crate::fixture::{Fixture, ROOM};
use scenelang_base::TextRange;
use scenelang_ide::hints::{Lens, hints, lenses, tooltip, unplaced};

/// Hints as `line → label`.
fn shown(fixture: &Fixture) -> Vec<String> {
    let whole = TextRange::new(0, fixture.text.len());
    let line = |at: u32| {
        let start = fixture.text[..at as usize].rfind('\n').map_or(0, |i| i + 1);
        fixture.text[start..at as usize].to_owned()
    };
    hints(&fixture.snapshot, whole).unwrap().iter().map(|h| format!("{} → {}", line(h.at), h.label)).collect()
}

#[test]
fn margins_values_and_sizes() {
    assert_eq!(
        shown(&Fixture::with("assert low(bed, 1);\nprefer bed.pos.x > 1;\n")),
        [
            "object stand[2] → 0.40 × 0.50 × 0.40 m",
            "object lamp → 0.20 × 0.40 × 0.20 m",
            "Number space → = 0.02",
            "assert gap(stand[1], bed) >= space and lamp.top > 0.5 → ✗ −0.12 m",
            "assert low(bed, 1) → +0.45 m",
            "prefer bed.pos.x > 1 → ✗ −1.00 m",
        ]
    );
}

/// An equality that holds has its tolerance for a margin, a fact has none, and a size that is written is not written again.
#[test]
fn nothing_where_there_is_nothing_to_say() {
    let all = shown(&Fixture::with("assert bed.pos.x = 0;\nassert bed.rot.y = 0deg;\nassert true;\n"));
    assert!(all.iter().all(|h| !h.contains("+0.0010") && !h.contains("+0.10°") && !h.contains('✓')), "{all:?}");
    assert!(all.iter().all(|h| !h.starts_with("object bed")), "{all:?}");
    // What fails is always shown.
    let fails = shown(&Fixture::with("assert bed.pos.x = 0.5;\nassert false;\n"));
    assert!(fails.iter().any(|h| h.starts_with("assert bed.pos.x = 0.5 → ✗ −0.50 m")), "{fails:?}");
    assert!(fails.iter().any(|h| h == "assert false → ✗"), "{fails:?}");
}

#[test]
fn who_points_at_a_margin_is_told_the_rest() {
    let fixture = Fixture::at("assert gap(stand[1], bed) >= space and lamp.top > 0.5$0");
    let text = tooltip(&fixture.snapshot, fixture.at).unwrap().unwrap();
    assert!(text.contains("to repair it: ") && text.contains("`lamp.top > 0.5` holds"), "{text}");
    assert_eq!(tooltip(&fixture.snapshot, 0).unwrap(), None);
}

#[test]
fn what_can_be_done() {
    let fixture = Fixture::with("object desk;\nobject plant[2];\n");
    let found = lenses(&fixture.snapshot).unwrap();
    let said: Vec<(String, Lens)> =
        found.into_iter().map(|(r, lens)| (fixture.slice(r).replace('\n', " "), lens)).collect();
    let own = |text: &str, lens: Lens| (text.to_owned(), lens);
    assert_eq!(
        said,
        [
            own("import \"parts.scene\"", Lens::Program),
            own("assert gap(stand[1], bed) >= space and lamp.top > 0.5", Lens::Failing),
            own("object desk", Lens::Unplaced("desk".into())),
            own("object plant[2]", Lens::Unplaced("plant".into())),
        ]
    );
    // An array lacks a place as long as one of its elements does; without a layout nothing lacks one.
    let three = Fixture::new(&ROOM.replace("object stand[2]", "object stand[3]"));
    assert_eq!(unplaced(&three.snapshot).unwrap().len(), 1);
    assert_eq!(unplaced(&Fixture::beside(ROOM, "{").snapshot).unwrap(), []);
}
