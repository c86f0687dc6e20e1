//! `scenelang trace`: from requirements to statements, objects and verdicts, and back.

use crate::support::{Ended, fits, folder_of, root, scenelang, scenelang_with_input};
use serde_json::{Value, json};
use std::fs;

const SCENE: &str = "\
@req(\"a small study\")
region study;
study.scale <- vec3(4, 2.5, 4);
@req(\"a desk with a lamp on it\")
object desk;
desk.dimensions <- vec3(1.4, 0.75, 0.7);
@req(\"two chairs\")
object chair[2];
object lamp;
lamp.dimensions <- vec3(0.2, 0.4, 0.2);
@req(\"a desk with a lamp on it\")
assert on(lamp, desk);
@req(\"the chairs are near the desk\")
@req(\"two chairs\")
assert forall c in chair: near(c, desk, 0.5);
@req(\"the first chair is the nearer one\")
prefer gap(chair[0], desk) <= gap(chair[1], desk);
@req(\"inferred: a lamp is upright\")
assert lamp.rot.x = 0;
assert desk.pos.x <= 1;
@req(\"it feels cosy\")
predicate unmet1() := true;
@req(\"the lamp may be green\")
lamp.color <- \"green\";
";

const LAYOUT: &str = r#"{ "format": "scenelang.layout/1", "scene": "room.scene",
  "objects": {
    "desk": { "pos": [0, 0, 0], "scale": [1.4, 0.75, 0.7] },
    "lamp": { "pos": [0.3, 0.75, 0], "scale": [0.2, 0.4, 0.2] },
    "chair[0]": { "pos": [0, 0, 1.5], "scale": [0.5, 0.9, 0.5] },
    "chair[1]": { "pos": [0, 0, -0.8], "scale": [0.5, 0.9, 0.5] } },
  "regions": { "study": { "pos": [0, 0, 0], "scale": [4, 2.5, 4] } } }"#;

fn trace(files: &[(&str, &str)], more: &[&str]) -> Ended {
    scenelang(folder_of(files).path(), ["trace", "room.scene"].iter().chain(more))
}

fn verdicts(document: &Value) -> Vec<(String, String)> {
    let all = document["requirements"].as_array().unwrap();
    all.iter().map(|r| (r["text"].as_str().unwrap().into(), r["verdict"].as_str().unwrap().into())).collect()
}

#[test]
fn people_read_it_both_ways() {
    let files = [("room.scene", SCENE), ("room.layout.json", LAYOUT)];
    let ended = trace(&files, &[]);
    assert_eq!(ended.code, 1, "{ended:?}");
    insta::assert_snapshot!("trace-by-requirement", ended.stdout);
    let ended = trace(&files, &["--by", "object"]);
    assert_eq!(ended.code, 1, "{ended:?}");
    insta::assert_snapshot!("trace-by-object", ended.stdout);
    let ended = trace(&files[..1], &[]);
    assert!(
        ended.stdout.contains("not checked") && ended.stdout.contains("\"it feels cosy\": NO STATEMENT\n"),
        "{ended:?}"
    );
}

#[test]
fn machines_read_verdicts_objects_and_what_is_missing() {
    let files = [("room.scene", SCENE), ("room.layout.json", LAYOUT)];
    let with = fits("trace", &trace(&files, &["--format", "json"]).stdout);
    let wanted = [
        ("a small study", "declared"),
        ("a desk with a lamp on it", "holds"),
        ("two chairs", "fails"),
        ("the chairs are near the desk", "fails"),
        ("the first chair is the nearer one", "unmet"),
        ("a lamp is upright", "holds"),
        ("it feels cosy", "none"),
        ("the lamp may be green", "declared"),
    ];
    assert_eq!(verdicts(&with), wanted.map(|(text, verdict)| (text.to_owned(), verdict.to_owned())));
    let chairs = &with["requirements"][2];
    assert_eq!(
        (&chairs["declares"], &chairs["statements"][0]["objects"]),
        (&json!(["chair"]), &json!(["desk", "chair"]))
    );
    assert_eq!(with["requirements"][5]["inferred"], true);
    assert_eq!(with["untraced"][0]["text"], "assert desk.pos.x <= 1");
    let lamp = with["objects"].as_array().unwrap().iter().find(|o| o["name"] == "lamp").unwrap();
    assert_eq!((&lamp["requirements"], &lamp["satisfied"]), (&json!([1, 5, 7]), &json!(true)));
    assert_eq!(lamp["statements"].as_array().unwrap().len(), 4);
    // The ids are those of reports.
    let dir = folder_of(&files);
    let report = scenelang(dir.path(), ["check", "room.layout.json", "--format", "json"]).reports().remove(0);
    let ids: Vec<&Value> = report["constraints"].as_array().unwrap().iter().map(|row| &row["id"]).collect();
    for statement in with["requirements"].as_array().unwrap().iter().flat_map(|r| r["statements"].as_array().unwrap()) {
        assert!(statement["kind"] == "property" || ids.contains(&&statement["id"]), "{statement}");
    }

    let without = fits("trace", &trace(&files[..1], &["--format", "json"]).stdout);
    assert_eq!(without["layout"], Value::Null);
    assert_eq!(verdicts(&without)[2].1, "not_judged");
    assert_eq!(without["summary"]["none"], 1);
}

#[test]
fn exit_codes_tell_good_missing_and_unjudged() {
    let good = SCENE.replace("@req(\"it feels cosy\")\n", "").replace("0.5);", "2);");
    let missing = LAYOUT.replace("\"lamp\"", "\"lamps\"");
    let nested = "import \"room.scene\";\n@req(\"more\") assert desk.pos.y = 0;\n";
    for (files, more, code, said) in [
        (vec![("room.scene", good.as_str()), ("room.layout.json", LAYOUT)], vec![], 0, "4 hold"),
        (vec![("room.scene", good.as_str())], vec![], 0, "not checked"),
        (vec![("room.scene", SCENE)], vec![], 1, "1 has no statement"),
        (vec![("room.scene", good.as_str()), ("room.layout.json", missing.as_str())], vec![], 2, "cannot be checked"),
        (vec![("room.scene", good.as_str()), ("room.layout.json", "{")], vec![], 2, ""),
        (vec![("room.scene", "object")], vec![], 2, ""),
        (vec![], vec![], 2, ""),
        (vec![("room.scene", good.as_str())], vec!["other.layout.json"], 2, ""),
        (
            vec![("room.scene", good.as_str()), ("other.layout.json", LAYOUT)],
            vec!["other.layout.json"],
            0,
            "checked with other",
        ),
        (vec![("room.scene", "")], vec![], 0, "0 requirements"),
    ] {
        let ended = trace(&files, &more);
        assert_eq!(ended.code, code, "{files:?} {more:?}\n{ended:?}");
        assert!(ended.stdout.contains(said) && (code < 2 || !ended.stderr.is_empty()), "{said}: {ended:?}");
    }
    // From standard input, and what an import says.
    let ended = scenelang_with_input(folder_of(&[]).path(), ["trace", "-"], good.as_bytes());
    assert_eq!(ended.code, 0, "{ended:?}");
    let dir = folder_of(&[("room.scene", good.as_str()), ("all.scene", nested)]);
    let ended = scenelang(dir.path(), ["trace", "all.scene"]);
    assert!(ended.stdout.contains("\"more\": not checked") && ended.stdout.contains("\"two chairs\""), "{ended:?}");
}

#[test]
fn the_book_shows_a_trace_as_it_is() {
    let page = fs::read_to_string(root().join("spec/src/command-line.md")).unwrap();
    let section = page.split("\n## trace\n").nth(1).unwrap().split("\n## ").next().unwrap();
    let block = |tag: &str| section.split(&format!("```{tag}\n")).nth(1).unwrap().split("```").next().unwrap();
    let ended = trace(&[("room.scene", block("scene"))], &[]);
    assert_eq!(ended.stdout, block("text trace"));
}
