//! `scenelang eval requests`: tables and JSON, exit codes, what is missing.

use crate::support::{Ended, scenelang};
use serde_json::Value;
use std::fs;
use std::path::Path;

const TRUTH: &str = r#"{ "id": "x", "building": "office", "rooms": [{ "name": "room", "size": null }], "connections": [],
  "objects": [
    { "name": "desk", "count": 1, "room": "room", "colour": "white", "material": null, "features": null },
    { "name": "chair", "count": 2, "room": "room", "colour": null, "material": null, "features": null },
    { "name": "plant", "count": 0, "room": "room", "colour": null, "material": null, "features": null }
  ],
  "relations": [{ "subject": "chair", "relation": "around", "object": "desk" }],
  "numeric": [{ "quote": "1 m", "quantity": "gap", "between": ["desk", "room"], "op": ">=", "value": 1, "unit": "m" }] }"#;

const GOOD: &str = "region room;\nobject desk;\ndesk.color <- \"white\";\nobject chair[2];\n\
    assert around(chair, desk, 0.4);\nassert gap(desk, room) >= 1m;\n";

/// Requests `a`, `b`, … with these programs in `programs/`.
fn folder(programs: &[&str]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("programs")).unwrap();
    for (name, program) in ["a", "b", "c", "d"].into_iter().zip(programs) {
        let put = |name: String, text: &str| fs::write(folder.path().join(name), text).unwrap();
        put(format!("{name}.txt"), "A white desk, two chairs around it, 1 m to the wall, no plant.");
        put(format!("{name}.expect.json"), TRUTH);
        put(format!("programs/{name}.scene"), program);
    }
    folder
}

fn eval(folder: &Path, more: &[&str]) -> Ended {
    scenelang(folder, ["eval", "requests", ".", "--programs", "programs"].iter().chain(more))
}

#[test]
fn a_table_of_shares_and_what_was_missed() {
    let half = "region room;\nobject chair;\nobject plant;\nobject desk;\nassert inside(chair, room);\n";
    let folder = folder(&[GOOD, half]);
    let ended = eval(folder.path(), &["--worst", "1"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    let cells = |line: &str| line.split("  ").map(str::trim).filter(|c| !c.is_empty()).collect::<Vec<_>>().join("|");
    let lines: Vec<String> = ended.stdout.lines().map(cells).collect();
    assert_eq!(lines[2], "a|14|100 %|100 %|100 %|100 %|100 %|100 %|100 %|good");
    assert_eq!(lines[3], "b|14|67 %|100 %|33 %|0 %|0 %|0 %|0 %|good");
    assert_eq!(lines[4], "mean|83 %|100 %|67 %|50 %|50 %|50 %|50 %|2/2 good");
    let misses = ["b", "unasked: plant", "1 chair, not 2", "forbidden: plant", "desk is not white"];
    assert_eq!(lines[6], "weakened 0/1 (0 %)");
    assert_eq!(lines[8..13], misses);
    assert_eq!(lines[13..], ["no statement: chair around desk", "no number: 1 m"]);
}

#[test]
fn the_same_as_json() {
    let contradictory = GOOD.to_owned() + "assert gap(desk, room) < 0.5;\n";
    let folder = folder(&[GOOD, "object desk\nobject ;\n", &contradictory]);
    let ended = eval(folder.path(), &["--format", "json"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (1, ""));
    let found: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!(found["format"], "scenelang.requests/1");
    assert_eq!((&found["compiled"], &found["contradiction_free"]), (&Value::from([2, 3]), &Value::from([1, 3])));
    assert_eq!(found["mean"]["recall"], 2.0 / 3.0);
    let cases = found["cases"].as_array().unwrap();
    assert_eq!(cases[0]["score"]["relations"]["named"], Value::from([1, 1]));
    assert_eq!(cases[0]["score"]["misses"], Value::from(Vec::<Value>::new()));
    assert_eq!((&cases[1]["compiled"], &cases[1]["contradictions"]), (&Value::from(false), &Value::Null));
    assert_eq!((&cases[2]["compiled"], &cases[2]["contradictions"]), (&Value::from(true), &Value::from(1)));
    assert_eq!(eval(folder.path(), &["--format", "json"]).stdout, ended.stdout);
}

#[test]
fn what_is_missing_is_named() {
    let folder = folder(&[GOOD, GOOD]);
    fs::remove_file(folder.path().join("programs/b.scene")).unwrap();
    let ended = eval(folder.path(), &[]);
    assert_eq!((ended.code, ended.stdout.as_str()), (2, ""));
    assert!(ended.stderr.contains("b.scene"), "{}", ended.stderr);
    fs::write(folder.path().join("a.expect.json"), "{ \"id\": 7 }").unwrap();
    let ended = eval(folder.path(), &[]);
    assert!(ended.code == 2 && ended.stderr.contains("a.expect.json"), "{}", ended.stderr);
    let ended = scenelang(folder.path(), ["eval", "requests", "programs", "--programs", "."]);
    assert!(ended.code == 2 && ended.stderr.contains("NAME.expect.json"), "{}", ended.stderr);
}

#[test]
fn requests_are_read_without_a_model() {
    let folder = tempfile::tempdir().unwrap();
    let put = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    put("a.txt", "An office with a white desk and two chairs around the desk. Bananas quickly because.");
    put("a.expect.json", TRUTH);
    let read = |more: &[&str]| {
        let ended = scenelang(folder.path(), ["eval", "requests", ".", "--format", "json"].iter().chain(more));
        assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{}", ended.stdout);
        serde_json::from_str::<Value>(&ended.stdout).unwrap()
    };
    let found = read(&["-o", "out/programs"]);
    let case = &found["cases"][0];
    assert_eq!(case["score"]["objects"]["recall"], Value::from([2, 2]));
    assert_eq!(case["score"]["relations"]["mentioned"], Value::from([1, 1]));
    let (understood, clauses) = (case["clauses"][0].as_u64().unwrap(), case["clauses"][1].as_u64().unwrap());
    assert!(0 < understood && understood < clauses, "{case}");
    assert!(case["milliseconds"].as_f64().unwrap() > 0.0);
    // What was written is what was scored.
    let again = read(&["--programs", "out/programs"]);
    assert_eq!(again["cases"][0]["score"], case["score"]);
    assert_eq!((&again["cases"][0]["milliseconds"], &again["cases"][0]["clauses"][1]), (&Value::Null, &Value::from(0)));
    // What nobody asked for is in the program only if it is wanted.
    let more = read(&["--expand"]);
    let things = |v: &Value| v["cases"][0]["score"]["objects"]["precision"][1].as_u64().unwrap();
    assert!(things(&more) > things(&found), "{more}");
}
