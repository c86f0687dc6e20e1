//! `scenelang diff`: the table that people read, the JSON as its schema says, the exit codes.

use crate::support::{fits, scenelang};
use std::fs;

const SCENE: &str = "\
region room;
object desk;
object lamp;
object plant;
Number space;
assert lamp.pos.y >= desk.top - 0.01;
assert desk.pos.x - plant.pos.x >= space;
prefer lamp.rot.y = 0;
";

const BEFORE: &str = r#"{ "format": "scenelang.layout/1", "scene": "room.scene",
  "objects": {
    "desk": { "pos": [0, 0, 0], "scale": [1.4, 0.75, 0.7] },
    "lamp": { "pos": [0.3, 0.75, 0], "scale": [0.2, 0.4, 0.2],
              "asset": { "id": "one", "parts": [ { "shape": "box", "pos": [0, 0.2, 0], "size": [0.2, 0.4, 0.2] } ] } },
    "plant": { "pos": [-1.5, 0, 1], "scale": [0.3, 1, 0.3] } },
  "regions": { "room": { "pos": [0, 0, 0], "scale": [5, 2.5, 5] } },
  "variables": { "space": 1 } }"#;

const AFTER: &str = r#"{ "format": "scenelang.layout/1", "scene": "room.scene",
  "objects": {
    "desk": { "pos": [0, 0, 0.5], "rot": [0, -90, 0], "scale": [1.6, 0.75, 0.7] },
    "lamp": { "pos": [0.1, 0.6, 0.5], "scale": [0.2, 0.4, 0.2],
              "asset": { "id": "two", "parts": [ { "shape": "box", "pos": [0, 0.2, 0], "size": [0.2, 0.4, 0.2] } ] } },
    "plant": { "pos": [-1.5, 0, 1], "scale": [0.3, 1, 0.3] } },
  "regions": { "room": { "pos": [0, 0, 0], "scale": [5, 2.5, 5], "vertices": [[-3, -3], [3, -3], [0, 3]] } },
  "variables": { "space": 1.25 } }"#;

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [
        ("room.scene", SCENE.to_owned()),
        ("before.layout.json", BEFORE.to_owned()),
        ("after.layout.json", AFTER.to_owned()),
        // The same, said otherwise.
        (
            "same.layout.json",
            BEFORE.replace("\"pos\": [0.3, 0.75, 0]", "\"rot\": [0, 360, 0], \"pos\": [3e-1, 0.75, 0]"),
        ),
        ("missing.layout.json", BEFORE.replace("\"plant\"", "\"plants\"")),
        ("broken.layout.json", BEFORE.replace("\"objects\"", "objects {")),
        // The program with its lines moved, and with a statement more.
        ("other/room.scene", format!("// later\n\n{SCENE}assert plant.pos.x < 0;\n")),
        ("other/before.layout.json", BEFORE.to_owned()),
    ] {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

#[test]
fn people_read_what_moved_and_what_that_did() {
    let folder = folder();
    let ended = scenelang(folder.path(), ["diff", "before.layout.json", "after.layout.json"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (1, ""));
    insta::assert_snapshot!(ended.stdout, @r##"
      object  is       how
      ──────  ───────  ──────────────────────────────────────────────
      desk    moved    0.5 m north
      desk    turned   90° anticlockwise, seen from above
      desk    resized  1.60 × 0.75 × 0.70 m, was 1.40 × 0.75 × 0.70 m
      lamp    moved    0.5 m north, 0.2 m west, 0.15 m down
      lamp    asset    different id

      region  is        how
      ──────  ────────  ────────────────────────────────
      room    reshaped  an outline with 3 corners, was 4

      variable  was  is
      ────────  ───  ────
      space     1.0  1.25

      constraint                                        change          margin before  margin after
      ────────────────────────────────────────────────  ──────────────  ─────────────  ────────────
      room.scene:6:1 lamp.pos.y >= desk.top - 0.01      ceases to hold        0.010 m      -0.140 m
      room.scene:7:1 desk.pos.x - plant.pos.x >= space  margin shrinks        0.500 m       0.250 m
      P-COLLIDE:desk:lamp                               ceases to hold  –                  -0.149 m
      P-BOUNDS:plant                                    ceases to hold  –                  -0.647 m
      P-SUPPORT:lamp                                    ceases to hold  –                  -0.145 m

    before.layout.json → after.layout.json: they differ
    "##);
}

#[test]
fn exit_codes() {
    let folder = folder();
    for (a, b, code) in [
        ("before.layout.json", "before.layout.json", 0),
        ("before.layout.json", "same.layout.json", 0),
        ("before.layout.json", "after.layout.json", 1),
        ("before.layout.json", "other/before.layout.json", 1),
        ("before.layout.json", "missing.layout.json", 2),
        ("broken.layout.json", "before.layout.json", 2),
        ("before.layout.json", "nowhere.layout.json", 2),
        ("missing.layout.json", "nowhere.layout.json", 2),
        ("before.layout.json", "room.scene", 2),
        ("before.layout.json", ".", 2),
    ] {
        let ended = scenelang(folder.path(), ["diff", a, b]);
        assert_eq!(ended.code, code, "{a} {b}: {}{}", ended.stdout, ended.stderr);
        assert!(code < 2 || !ended.stderr.is_empty(), "{a} {b} says why");
        assert!(code < 2 || !ended.stdout.contains("equal"), "{a} {b}: {}", ended.stdout);
    }
}

#[test]
fn json_has_words_and_numbers() {
    let folder = folder();
    let diff = |a: &str, b: &str| fits("diff", &scenelang(folder.path(), ["diff", a, b, "--format", "json"]).stdout);
    let differ = diff("before.layout.json", "after.layout.json");
    let desk = &differ["objects"][0];
    assert_eq!(desk["name"], "desk");
    insta::assert_snapshot!(desk["changes"].to_string(), @r##"[{"what":"moved","words":"0.5 m north","amount":0.5,"before":[0.0,0.0,0.0],"after":[0.0,0.0,0.5]},{"what":"turned","words":"90° anticlockwise, seen from above","amount":90.0,"before":[0.0,0.0,0.0],"after":[0.0,-90.0,0.0]},{"what":"resized","words":"1.60 × 0.75 × 0.70 m, was 1.40 × 0.75 × 0.70 m","before":[1.4,0.75,0.7],"after":[1.6,0.75,0.7]}]"##);
    insta::assert_snapshot!(differ["constraints"][0].to_string(), @r##"{"id":"room.scene:6:1","kind":"assert","text":"lamp.pos.y >= desk.top - 0.01","what":"ceases to hold","unit":"m","before":{"satisfied":true,"margin":0.010000000000000009},"after":{"satisfied":false,"margin":-0.14}}"##);

    let equal = diff("before.layout.json", "same.layout.json");
    assert_eq!(equal["equal"], true);
    let other = diff("before.layout.json", "other/before.layout.json");
    let changes: Vec<_> = other["constraints"].as_array().unwrap().iter().map(|c| (&c["id"], &c["what"])).collect();
    assert_eq!(changes, [(&"room.scene:11:1".into(), &"added".into())], "statements are found again by their text");
    fits(
        "diff",
        &scenelang(folder.path(), ["diff", "before.layout.json", "missing.layout.json", "--format", "json"]).stdout,
    );
}

#[test]
fn margins_count_from_the_threshold_on() {
    let folder = folder();
    let rows = |threshold: &str| {
        let args = ["diff", "before.layout.json", "after.layout.json", "--format", "json", "--threshold", threshold];
        fits("diff", &scenelang(folder.path(), args).stdout)["constraints"].as_array().unwrap().len()
    };
    assert!(rows("0.001") > rows("100"));
}

/// Of a file that is not there nothing is compared.
#[test]
fn a_missing_layout_is_an_error_and_no_table() {
    let folder = folder();
    let ended = scenelang(folder.path(), ["diff", "before.layout.json", "nowhere.layout.json"]);
    assert!(ended.code == 2 && ended.stdout.is_empty(), "{}{}", ended.stdout, ended.stderr);
    assert!(ended.stderr.contains("nowhere.layout.json"), "{}", ended.stderr);
}
