//! `scenelang solve`, from end to end: what is proved impossible, and what is printed for other programs.

use crate::problems::{file, sample};
use crate::repair::contains;
use crate::support::{fits, read_json, root, scenelang};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// No layout satisfies these, and each of the two is needed for that.
const IMPOSSIBLE: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(4, 2.5, 4);\nobject a;\nobject b;\n\
                          assert a.pos.x >= b.pos.x + 1;\nassert inside(a, room);\nassert b.pos.x >= a.pos.x;\n";

/// The programs of the book's section, each with the part of the answer that it shows.
fn book() -> Vec<(String, Value)> {
    let page = fs::read_to_string(root().join("spec/src/command-line.md")).unwrap();
    let section = page.split("\n## solve\n").nth(1).unwrap().split("\n## ").next().unwrap();
    let block = |text: &str| text.split("```").next().unwrap().to_owned();
    let examples = section.split("```scene\n").skip(1);
    examples
        .map(|text| {
            let answer = text.split("```json solve\n").nth(1).expect("an answer for each program");
            (block(text), serde_json::from_str(&block(answer)).unwrap())
        })
        .collect()
}

#[test]
fn the_examples_of_the_book_are_as_shown() {
    let examples = book();
    assert!(!examples.is_empty());
    for (scene, shown) in examples {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("room.scene"), &scene).unwrap();
        let ended = scenelang(folder.path(), ["solve", "room.scene", "--format", "json"]);
        let answer = fits("solution", &ended.stdout);
        assert!(contains(&answer, &shown), "{scene}\n{shown:#}\nbut\n{answer:#}");
    }
}

#[test]
fn what_is_in_the_way_is_named_in_words() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, _) = book().remove(1);
    fs::write(folder.path().join("room.scene"), &scene).unwrap();
    let ended = scenelang(folder.path(), ["solve", "room.scene"]);
    assert_eq!(ended.code, 1, "{}", ended.stderr);
    let said = "without this statement the rest can hold, as in this layout (found by search, not proved):\n  \
                room.scene:7:1: forall a in lamp: forall b in lamp: a != b implies distance(a, b) >= 3\n";
    assert!(ended.stdout.contains(said), "{}", ended.stdout);
    // The layout is the witness, as `check` sees it.
    let report = scenelang(folder.path(), ["check", "room.layout.json", "--format", "json"]).reports().remove(0);
    let failing: Vec<&Value> =
        report["constraints"].as_array().unwrap().iter().filter(|c| c["satisfied"] == false).collect();
    assert_eq!((failing.len(), &failing[0]["id"]), (1, &"room.scene:7:1".into()));
}

/// The lines of the statements of which a report says that they cannot hold together.
fn proved(report: &Value) -> BTreeSet<u64> {
    let found = report["diagnostics"].as_array().unwrap().iter().filter(|d| d["code"] == "E0401");
    let places = found.flat_map(|d| d["related"].as_array().unwrap());
    places.map(|p| p["span"]["start"][0].as_u64().unwrap()).collect()
}

#[test]
fn what_is_proved_impossible_gets_no_layout() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.scene"), IMPOSSIBLE).unwrap();
    let judged = scenelang(folder.path(), ["check", "room.scene"]);
    for args in [["solve", "room.scene"], ["synth", "room.scene"]] {
        let ended = scenelang(folder.path(), args);
        assert_eq!(ended.code, 1, "{args:?}: {}", ended.stderr);
        assert!(ended.stdout.starts_with(&judged.stdout), "{}\nbut check says\n{}", ended.stdout, judged.stdout);
        assert!(ended.stdout.contains("these 2 statements cannot hold together"), "{}", ended.stdout);
    }
    let ended = scenelang(folder.path(), ["solve", "room.scene", "--format", "json"]);
    let answer = fits("solution", &ended.stdout);
    assert_eq!((ended.code, &answer["end"], &answer["ok"]), (1, &"contradiction".into(), &false.into()));
    assert_eq!(fits("report", &answer["report"].to_string()), answer["report"]);
    assert_eq!(proved(&answer["report"]), BTreeSet::from([6, 8]));
    let ended = scenelang(folder.path(), ["synth", "room.scene", "--format", "json"]);
    let answer: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!((ended.code, proved(&answer["report"])), (1, BTreeSet::from([6, 8])));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "nothing is written");
}

#[test]
fn planted_contradictions_are_the_answer() {
    let mut seen = 0;
    for name in sample() {
        let facts = read_json(&file(&name, "json"));
        let Some(planted) = facts["contradiction"].as_array() else { continue };
        seen += 1;
        let folder = tempfile::tempdir().unwrap();
        let (scene, output) = (file(&name, "scene"), folder.path().join("out.layout.json"));
        let args = ["solve".as_ref(), scene.as_os_str(), "--format".as_ref(), "json".as_ref()];
        let ended = scenelang(&root(), args.into_iter().chain(["-o".as_ref(), output.as_os_str()]));
        assert_eq!(ended.code, 1, "{name}: {}", ended.stderr);
        let lines = proved(&fits("solution", &ended.stdout)["report"]);
        let text = fs::read_to_string(&scene).unwrap();
        let told: BTreeSet<&str> = lines.iter().map(|line| requirement(&text, *line)).collect();
        assert_eq!(told, planted.iter().map(|p| p.as_str().unwrap()).collect(), "{name}");
        assert!(!output.exists(), "{name}");
    }
    assert!(seen > 0);
}

/// The `@req` text in a line.
fn requirement(text: &str, line: u64) -> &str {
    let line = text.lines().nth(line as usize - 1).unwrap();
    line.split('"').nth(1).unwrap_or_else(|| panic!("nothing is required in {line}"))
}

#[test]
fn the_answer_as_json() {
    let folder = tempfile::tempdir().unwrap();
    let text = IMPOSSIBLE.replace("assert b.pos.x >= a.pos.x;", "prefer b.pos.z > a.pos.z;");
    fs::write(folder.path().join("room.scene"), text).unwrap();
    let ended = scenelang(folder.path(), ["solve", "room.scene", "--format", "json"]);
    let answer = fits("solution", &ended.stdout);
    assert_eq!((ended.code, &answer["end"], &answer["ok"]), (0, &"solved".into(), &true.into()));
    let layout = &answer["layouts"][0];
    let report = fits("report", &layout["report"].to_string());
    assert_eq!((&report["ok"], report["constraints"].as_array().unwrap().len()), (&true.into(), 5));
    assert!(folder.path().join(Path::new(layout["file"].as_str().unwrap())).exists());
}
