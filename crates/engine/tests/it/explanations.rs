//! Explanations: full reports of one violation of each kind (`explained.txt`), and that a move does what is said of it.

use crate::given::{cases, judged, layout};
use scenelang_verify::report::model::{Report, Row};
use scenelang_verify::report::{Human, human};
use scenelang_verify::{Detail, Explain, Options};
use serde_json::Value;
use std::collections::BTreeSet;

const CASES: &str = include_str!("explained.txt");

#[test]
fn every_kind_of_violation_is_explained() {
    let cases = cases(CASES);
    let kinds: BTreeSet<&str> = cases.iter().map(|case| case.title).collect();
    assert!(kinds.len() >= 20 && kinds.len() == cases.len(), "{}", kinds.len());
    for case in &cases {
        let checked = judged(&case.scene, &layout(&case.layout), &Options::default());
        insta::assert_snapshot!(case.title.replace(' ', "-"), human(&checked, Human::default()));
    }
}

/// The example of the published requirement, with its trolley pushed into the aisle.
#[test]
fn the_safety_requirement_names_its_bottleneck() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/workshop-safety.scene");
    let scene = std::fs::read_to_string(path).unwrap();
    let layout = layout(include_str!("workshop-blocked.txt"));
    let checked = judged(&scene, &layout, &Options::default());
    insta::assert_snapshot!(human(&checked, Human::default()));
    let row = checked.report.constraints.iter().find(|row| row.text.contains("canEscape")).expect("it is stated");
    assert!(row.message.starts_with("the passage between `table` and `trolley` is 1.45 m wide, 0.05 m too narrow"));
    assert!(hold_to_its_word(&scene, &layout, &checked.report, row), "a move is offered");
}

/// Ids of rows that fail, with all rows listed that can be.
fn failing(report: &Report) -> BTreeSet<String> {
    report.constraints.iter().filter(|row| row.satisfied == Some(false)).map(|row| row.id.clone()).collect()
}

/// Does what the move of a row says, and compares what comes of it with what was said.
fn hold_to_its_word(scene: &str, layout: &str, report: &Report, row: &Row) -> bool {
    let Some(repair) = row.explanation.as_ref().and_then(|e| e.repair.as_ref()) else { return false };
    let mut moved: Value = serde_json::from_str(layout).unwrap();
    let first = [(&repair.object, repair.by, repair.turn)];
    for (object, by, turn) in first.into_iter().chain(repair.also.iter().map(|s| (&s.object, s.by, s.turn))) {
        let place = &mut moved["objects"][object];
        for (i, d) in by.into_iter().enumerate() {
            place["pos"][i] = (place["pos"][i].as_f64().unwrap() + d).into();
        }
        let yaw = place["rot"][1].as_f64().unwrap_or(0.0) + turn;
        if place["rot"].is_array() {
            place["rot"][1] = yaw.into();
        } else {
            place["rot"] = vec![0.0, yaw, 0.0].into();
        }
    }
    let options = Options { detail: Detail { explain: Explain::First(0), ..Detail::default() }, ..Options::default() };
    let after = failing(&judged(scene, &moved.to_string(), &options).report);
    let before = failing(report);
    assert!(!after.contains(&row.id), "{} does not repair {}\n{scene}\n{layout}", repair.text, row.id);
    let said = |ids: &[String]| ids.iter().cloned().collect::<BTreeSet<_>>();
    let breaks: BTreeSet<String> = after.difference(&before).cloned().collect();
    assert_eq!(breaks, said(&repair.breaks), "{}: breaks\n{scene}\n{layout}", repair.text);
    let mut repairs: BTreeSet<String> = before.difference(&after).cloned().collect();
    assert!(repairs.remove(&row.id));
    assert_eq!(repairs, said(&repair.repairs), "{}: repairs\n{scene}\n{layout}", repair.text);
    true
}

#[test]
fn moves_of_the_cases_do_what_they_say() {
    let mut offered = 0;
    for case in cases(CASES) {
        let layout = layout(&case.layout);
        let report = judged(&case.scene, &layout, &Options::default()).report;
        for row in report.constraints.iter().filter(|row| row.satisfied == Some(false)) {
            offered += usize::from(hold_to_its_word(&case.scene, &layout, &report, row));
        }
    }
    assert!(offered > 20, "only {offered} moves");
}

const ROOM: &str = "\
object table; object lamp; object chair[3]; object shelf; object door;
region room;
assert on(lamp, table);
assert forall c in chair: near(c, table, 0.6) and facing(c, table);
assert againstWall(shelf, room);
assert connects(door, room);
assert reachable(door, shelf, 0.8);
assert visible(chair[0], lamp);
assert clear(shelf, front, 0.7);
assert table.pos.x > chair[1].pos.x;
prefer walkDistance(chair[2], door) <= 1;
prefer distance(shelf, lamp) >= 2;
door.rot <- rot(0, 0, 0);
";

#[test]
fn moves_in_random_rooms_do_what_they_say() {
    let mut seed = 1u64;
    // A small generator (xorshift), so that the rooms are the same everywhere.
    let mut unit = || {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        (seed >> 11) as f64 / (1u64 << 53) as f64
    };
    let (mut offered, mut failed) = (0, 0);
    for _ in 0..8 {
        let mut text = "region room 0 0 0 | 5 2.6 4\n".to_owned();
        let mut object = |name: &str, y: f64, size: [f64; 3]| {
            let (x, z) = (4.4 * unit() - 2.2, 3.4 * unit() - 1.7);
            let yaw = if unit() < 0.5 { (4.0 * unit()).floor() * 90.0 } else { (360.0 * unit()).round() };
            let y = if unit() < 0.8 { y } else { y + 0.3 * unit() };
            let [w, h, d] = size;
            text += &format!("object {name} {x:.3} {y:.3} {z:.3} | {w} {h} {d} | 0 {yaw} 0\n");
        };
        object("table", 0.0, [1.4, 0.75, 0.8]);
        object("lamp", 0.75, [0.2, 0.4, 0.2]);
        for i in 0..3 {
            object(&format!("chair[{i}]"), 0.0, [0.45, 0.9, 0.45]);
        }
        object("shelf", 0.0, [1.0, 1.8, 0.4]);
        text += &format!("object door {:.3} 0 -2.03 | 0.9 2.1 0.06\n", 3.0 * unit() - 1.5);
        let layout = layout(&text);
        let options = Options { detail: Detail { explain: Explain::All, ..Detail::default() }, ..Options::default() };
        let report = judged(ROOM, &layout, &options).report;
        for row in report.constraints.iter().filter(|row| row.satisfied == Some(false)) {
            failed += 1;
            offered += usize::from(hold_to_its_word(ROOM, &layout, &report, row));
        }
        // The same again, word for word.
        assert_eq!(judged(ROOM, &layout, &options).report, report);
    }
    assert!(failed > 40 && offered * 10 > failed * 8, "{offered} of {failed}");
}

#[test]
fn only_the_first_are_explained_in_full() {
    let scene = "object a; object b;\nassert a.pos.x > 1;\nprefer a.pos.z > 1;\nassert b.pos.x > 1;";
    let layout = layout("object a 0 0 0\nobject b 0 0 3");
    for (explain, want) in [
        (Explain::First(0), [false, false, false]),
        (Explain::First(2), [true, false, true]),
        (Explain::All, [true, true, true]),
    ] {
        let report =
            judged(scene, &layout, &Options { detail: Detail { explain, ..Detail::default() }, ..Options::default() })
                .report;
        let rows = report.constraints.iter().map(|row| row.explanation.as_ref().expect("it fails"));
        let explained: Vec<bool> = rows.clone().map(|e| e.repair.is_some()).collect();
        assert_eq!(explained, want, "{explain:?}");
        assert!(rows.into_iter().all(|e| e.measured.is_some()));
    }
}
