//! P-OPEN and what is said of it: what is in the way and what is not, and that a move is offered which clears the way.

use crate::given::{judged, layout};
use scenelang_verify::report::model::{Report, Row};
use scenelang_verify::{Opens, Options};
use serde_json::Value;

/// A door 0.9 m wide in the wall of a hall, which opens into it; its leaf is 0.76 m wide.
const DOOR: &str = r#"object door 0 0 -1.5 | 0.9 2.1 0.1 | 0 0 0 | {"parts": [
    {"shape": "box", "pos": [-0.415, 1.05, 0], "size": [0.07, 2.1, 0.1]},
    {"shape": "box", "pos": [0.415, 1.05, 0], "size": [0.07, 2.1, 0.1]},
    {"shape": "box", "pos": [0, 1.01, 0], "size": [0.76, 2.02, 0.06]}],
  "joints": [{"name": "leaf", "motion": "hinge", "parts": [2], "axis": [0, -1, 0], "anchor": [-0.38, 0, 0.03],
    "limits": [0, 110], "useful": 90}]}"#;

/// A cabinet 0.5 m wide and deep, with a door over a drawer, at a place.
fn cabinet(pos: &str) -> String {
    format!(
        r#"object cabinet {pos} | 0.5 1 0.5 | 0 0 0 | {{"parts": [
    {{"shape": "box", "pos": [0, 0.5, -0.02], "size": [0.5, 1, 0.46]}},
    {{"shape": "box", "pos": [0, 0.7, 0.23], "size": [0.5, 0.6, 0.04]}},
    {{"shape": "box", "pos": [0, 0.2, 0.23], "size": [0.5, 0.4, 0.04]}}],
  "joints": [
    {{"name": "door", "motion": "hinge", "parts": [1], "axis": [0, -1, 0], "anchor": [-0.25, 0, 0.25], "limits": [0, 110], "useful": 90}},
    {{"name": "drawer", "motion": "slide", "parts": [2], "axis": [0, 0, 1], "anchor": [0, 0.2, 0.25], "limits": [0, 0.4], "useful": 0.3}}]}}"#
    )
}

const HALL: &str = "region hall 0 0 0 | 4 2.5 3";

/// A layout in short; an asset may go over several lines.
fn short(parts: &[&str]) -> String {
    layout(&parts.iter().map(|part| part.replace('\n', " ")).collect::<Vec<_>>().join("\n"))
}

fn report(scene: &str, parts: &[&str], opens: Opens) -> Report {
    judged(scene, &short(parts), &Options { opens, ..Options::default() }).report
}

fn rows(report: &Report) -> Vec<&Row> {
    report.constraints.iter().filter(|row| row.rule.as_deref() == Some("P-OPEN")).collect()
}

const ROOM: &str = "region hall; object door; object wardrobe; assert connects(door, hall);";

#[test]
fn a_wardrobe_before_a_door_is_a_violation_with_a_move() {
    // 0.57 m between the door and the wardrobe.
    let parts = [HALL, DOOR, "object wardrobe 0 0 -0.58 | 1.2 2 0.6"];
    let report = report(ROOM, &parts, Opens::Doors);
    let [row] = rows(&report)[..] else { panic!("{:?}", report.constraints) };
    assert_eq!((row.id.as_str(), row.code.as_deref()), ("P-OPEN:door/leaf", Some("V0107")));
    assert_eq!(row.objects, ["door", "wardrobe"]);
    // The tip of the leaf would be 0.17 m deep in the wardrobe; it comes as far as the arc goes
    // until it is a millimetre in.
    assert!((row.margin.unwrap() + 0.169).abs() < 1e-3, "{:?}", row.margin);
    let free = (0.591f64 / 0.76).asin().to_degrees().floor();
    assert!(
        row.message.starts_with(&format!("`leaf` of `door` opens {free}° of 90°, then hits `wardrobe`")),
        "{}",
        row.message
    );
    let offered = row.explanation.as_ref().and_then(|e| e.repair.as_ref()).expect("a move is offered");
    assert!(offered.breaks.is_empty(), "{offered:?}");
    // The move does what is said of it.
    let mut moved: Value = serde_json::from_str(&short(&parts)).unwrap();
    for (object, by, turn) in std::iter::once((&offered.object, offered.by, offered.turn))
        .chain(offered.also.iter().map(|step| (&step.object, step.by, step.turn)))
    {
        let place = &mut moved["objects"][object.as_str()];
        for (axis, step) in by.iter().enumerate() {
            place["pos"][axis] = (place["pos"][axis].as_f64().unwrap() + step).into();
        }
        place["rot"][1] = (place["rot"][1].as_f64().unwrap() + turn).into();
    }
    let after = judged(ROOM, &moved.to_string(), &Options::default()).report;
    assert!(after.ok, "{:?} {:?}", offered, after.constraints);
}

#[test]
fn what_settings_say_is_asked() {
    let scene = "region hall; object door; object cabinet; object crate; assert connects(door, hall);";
    let cabinet = cabinet("1 0 0");
    let parts = [HALL, DOOR, &cabinet, "object crate 1 0 0.6 | 0.5 0.5 0.5"];
    let failing = |opens| rows(&report(scene, &parts, opens)).iter().map(|row| row.id.clone()).collect::<Vec<_>>();
    assert_eq!(failing(Opens::Doors), Vec::<String>::new());
    assert_eq!(failing(Opens::None), Vec::<String>::new());
    assert_eq!(failing(Opens::All), ["P-OPEN:cabinet/door", "P-OPEN:cabinet/drawer"]);
    // As boxes, things have no parts that move.
    let options = Options { opens: Opens::All, geometry: scenelang_verify::Geometry::Box, ..Options::default() };
    assert!(rows(&judged(scene, &short(&parts), &options).report).is_empty());
    // Without joints nothing is asked.
    let count = |opens| {
        let plain = [HALL, "object door 0 0 -1.5 | 0.9 2.1 0.1", "object cabinet 1 0 0 | 0.5 1 0.5", parts[3]];
        report(scene, &plain, opens).summary.physical.total
    };
    assert_eq!(count(Opens::All), count(Opens::None));
}

#[test]
fn what_gives_way_is_not_in_the_way() {
    let scene = |more: &str| format!("region hall; object cabinet; object thing; {more}");
    let holds = |more: &str, thing: &str| {
        let report = report(&scene(more), &[HALL, &cabinet("1 0 0"), thing], Opens::All);
        rows(&report).is_empty()
    };
    let before = "object thing 1 0 0.5 | 0.4 0.8 0.4";
    assert!(!holds("", before));
    assert!(holds("thing.category <- \"chair\";", before), "a chair is pushed aside");
    assert!(holds("thing.category <- \"plastic storage bins\";", before), "so are bins");
    assert!(!holds("thing.category <- \"chair\"; thing.features <- \"fixed\";", before), "unless it is fixed");
    assert!(holds("thing.category <- \"table\"; thing.features <- \"light, folding\";", before), "or it is light");
    assert!(holds("thing.category <- \"rug\";", "object thing 1 0 0.5 | 1 0.01 1"), "a rug");
    assert!(holds("allowCollide(thing, cabinet);", before), "what may overlap");
    assert!(holds("", "object thing 1 1 0.1 | 0.2 0.3 0.2"), "what stands on the body");

    // The door of a room is no furniture: nobody moves a chair for it.
    let chair = "object thing 0 0 -1.1 | 0.4 0.8 0.4";
    let room = "region hall; object door; object thing; thing.category <- \"chair\"; assert connects(door, hall);";
    assert_eq!(rows(&report(room, &[HALL, DOOR, chair], Opens::Doors)).len(), 1);
}

#[test]
fn walls_are_in_the_way_and_a_door_has_its_own_opening() {
    let scene = "region hall; object cabinet;";
    let at = |z: f64| {
        let report = report(scene, &[HALL, &cabinet(&format!("0 0 {z}"))], Opens::All);
        rows(&report).iter().map(|row| row.message.split(';').next().unwrap().to_owned()).collect::<Vec<_>>()
    };
    assert!(at(0.7).is_empty(), "0.55 m before a wall");
    let said = at(0.85);
    assert_eq!(said.len(), 1, "{said:?}");
    assert!(said[0].starts_with("`door` of `cabinet` opens 53° of 90°, then hits a wall of `hall`"), "{said:?}");
    assert_eq!(at(1.0).len(), 2, "0.25 m before a wall, the drawer does not come out either");
    // A cabinet whose side touches a wall opens all the same.
    let beside = report(scene, &[HALL, &cabinet("-1.75 0 0")], Opens::All);
    assert!(rows(&beside).is_empty(), "{:?}", rows(&beside));
    // Outdoors there are no walls.
    let outdoors = "region hall; object cabinet; hall.features <- \"outdoor\";";
    assert!(rows(&report(outdoors, &[HALL, &cabinet("0 0 1.0")], Opens::All)).is_empty());
    // The leaf of a door goes through no wall, unless another one stands beside its hinges.
    let door = "region hall; object door; assert connects(door, hall);";
    assert!(rows(&report(door, &[HALL, DOOR], Opens::Doors)).is_empty());
    let corner = DOOR.replacen("0 0 -1.5", "-1.55 0 -1.5", 1);
    assert!(rows(&report(door, &[HALL, &corner], Opens::Doors)).is_empty());
    let narrow = "region hall 0 0 -1.2 | 4 2.5 0.6";
    assert_eq!(rows(&report(door, &[narrow, DOOR], Opens::Doors)).len(), 1, "the hall is 0.6 m deep");
}

#[test]
fn what_is_said_in_the_language_agrees_with_the_rule() {
    let scene = "region hall; object cabinet; object crate;
assert opens(cabinet); assert opens(cabinet, 90deg); assert slides(cabinet, 0.3);
assert opening(cabinet) < 90deg; assert sliding(cabinet) < 0.3; assert not opens(crate);";
    for (x, y) in [(0.6, 0.7), (0.55, 0.9), (0.7, 0.4), (0.9, 0.0)] {
        let crate_at = format!("object crate {y} 0 {x} | 0.4 0.5 0.4");
        let cabinet = cabinet("0 0 0");
        let report = report(scene, &[HALL, &cabinet, &crate_at], Opens::All);
        let stated = |text: &str| report.constraints.iter().find(|row| row.text.contains(text)).unwrap();
        let rule = |part: &str| !report.constraints.iter().any(|row| row.id == format!("P-OPEN:cabinet/{part}"));
        assert_eq!(stated("opens(cabinet, 90").satisfied, Some(rule("door")), "{x} {y}");
        assert_eq!(stated("slides(").satisfied, Some(rule("drawer")), "{x} {y}");
        assert_eq!(stated("opens(cabinet)").satisfied, Some(rule("door") && rule("drawer")), "{x} {y}");
        assert_eq!(stated("opening(").satisfied, Some(!rule("door")), "{x} {y}");
        assert_eq!(stated("sliding(").satisfied, Some(!rule("drawer")), "{x} {y}");
        assert_eq!(stated("not opens(crate)").satisfied, Some(true));
    }
}
