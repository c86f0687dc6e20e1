//! `scenelang assets` over folders of models that the tests write.

use crate::support::{fits, read_json, root, scenelang};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use tempfile::{TempDir, tempdir};

/// A box on the floor, as OBJ.
fn block(w: f64, h: f64, d: f64) -> String {
    let mut text = String::new();
    for i in 0..8 {
        let side = |bit: i32, size: f64| if i >> bit & 1 == 1 { size } else { 0.0 };
        text += &format!("v {} {} {}\n", side(0, w), side(1, h), side(2, d));
    }
    for face in ["2 4 8 6", "1 5 7 3", "3 7 8 4", "1 2 6 5", "5 6 8 7", "1 3 4 2"] {
        text += &format!("f {face}\n");
    }
    text
}

fn write(folder: &Path, name: &str, model: &str, card: &Value) {
    fs::write(folder.join(format!("{name}.obj")), model).unwrap();
    fs::write(folder.join(format!("{name}.json")), card.to_string()).unwrap();
}

/// A shop of three good models.
fn shop() -> TempDir {
    let folder = tempdir().unwrap();
    let models = folder.path().join("models");
    fs::create_dir(&models).unwrap();
    let card = |category: &str, description: &str| json!({ "category": category, "description": description, "front": "+z", "licence": "CC0-1.0" });
    write(&models, "a", &block(0.5, 0.9, 0.5), &card("chair", "a plain oak chair"));
    write(&models, "b", &block(1.6, 0.75, 0.9), &card("table", "dining table for six chairs"));
    write(&models, "c", &block(0.5, 0.5, 0.5), &card("table", "side table"));
    folder
}

#[test]
fn search_names_the_family_and_the_best_models() {
    let folder = shop();
    let ended = scenelang(folder.path(), ["assets", "search", "chair"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    assert!(
        ended.stdout.starts_with("the furniture library has a generator for it: chair; usually "),
        "{}",
        ended.stdout
    );

    let ended = scenelang(
        folder.path(),
        ["assets", "search", "table", "--size", "0.5x0.5x0.5", "--in", "models", "--format", "json"],
    );
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let found: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!((&found["format"], &found["library"]["family"]), (&json!("scenelang.assets/1"), &json!("table")));
    let files: Vec<&str> = found["models"].as_array().unwrap().iter().filter_map(|m| m["file"].as_str()).collect();
    assert_eq!(files, ["c.obj", "b.obj"]);

    let ended = scenelang(folder.path(), ["assets", "search", "zyzzyva", "--in", "models"]);
    assert_eq!(ended.code, 1, "{}", ended.stdout);
    assert!(ended.stdout.contains("no model in the folder matches these words"), "{}", ended.stdout);

    let ended = scenelang(folder.path(), ["assets", "search", "table", "--size", "1x2"]);
    assert!(ended.code == 2 && ended.stderr.contains("WxHxD"), "{}", ended.stderr);
}

#[test]
fn list_shows_what_there_is_and_warns_of_what_is_passed_over() {
    let folder = shop();
    let ended = scenelang(folder.path(), ["assets", "list", "models"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    assert!(ended.stdout.contains("0.50 × 0.90 × 0.50 m") && ended.stdout.contains("CC0-1.0"), "{}", ended.stdout);
    fs::write(folder.path().join("models/bad.glb"), "glTF").unwrap();
    let ended = scenelang(folder.path(), ["assets", "list", "models", "--format", "json"]);
    assert_eq!(ended.code, 2, "{}", ended.stderr);
    let found: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!((found["models"].as_array().unwrap().len(), &found["refused"][0]["code"]), (3, &json!("E0701")));
    let ended = scenelang(folder.path(), ["assets", "list", "nowhere"]);
    assert!(ended.code == 2 && ended.stderr.contains("nowhere: there is no such folder"), "{}", ended.stderr);
}

#[test]
fn check_has_three_forms_and_three_exit_codes() {
    let folder = shop();
    let ended = scenelang(folder.path(), ["assets", "check", "models"]);
    assert_eq!(
        (ended.code, ended.stdout.as_str()),
        (0, "models: 3 models checked, 0 with findings\n"),
        "{}",
        ended.stderr
    );

    fs::remove_file(folder.path().join("models/a.json")).unwrap();
    let ended = scenelang(folder.path(), ["assets", "check", "models"]);
    assert_eq!(ended.code, 1, "{}", ended.stdout);
    for line in [
        "models/a.obj: warning[W0703]: the direction of its front is not given; +z is assumed\n",
        "models/a.obj: warning[W0707]: no licence is stated\n",
        "models: 3 models checked, 1 with findings\n",
    ] {
        assert!(ended.stdout.contains(line), "{}", ended.stdout);
    }

    fs::write(folder.path().join("models/bad.glb"), "glTF").unwrap();
    let ended = scenelang(folder.path(), ["assets", "check", "models", "--format", "json"]);
    assert_eq!(ended.code, 2);
    let codes: Vec<Vec<String>> = ended
        .stdout
        .lines()
        .map(|line| {
            let report = fits("report", line);
            let findings = report["diagnostics"].as_array().unwrap();
            findings.iter().map(|d| d["code"].as_str().unwrap().to_owned()).collect()
        })
        .collect();
    assert_eq!(codes, [vec!["W0703", "W0707"], vec![], vec!["E0701"], vec![]]);

    let ended = scenelang(folder.path(), ["assets", "check", "models", "--format", "sarif"]);
    let log: Value = serde_json::from_str(&ended.stdout).unwrap();
    let results = log["runs"][0]["results"].as_array().unwrap();
    let rules: Vec<&str> = results.iter().map(|r| r["ruleId"].as_str().unwrap()).collect();
    assert_eq!(rules, ["W0703", "W0707", "E0701"]);
    let place = &results[0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"];
    assert_eq!(place, "models/a.obj");
}

#[test]
fn the_book_lists_the_commands() {
    let page = fs::read_to_string(root().join("spec/src/command-line.md")).unwrap();
    for command in ["assets search", "assets list", "assets check"] {
        assert!(page.contains(&format!("scenelang {command}")), "{command}");
    }
}

/// What requests speak of is drawn, or stands here.
#[test]
fn nouns_of_requests_are_drawn() {
    let folder = root().join("tests/requests/development");
    let mut nouns = BTreeSet::new();
    for entry in fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
        if entry.to_string_lossy().ends_with(".expect.json") {
            let expected = read_json(&entry);
            nouns
                .extend(expected["objects"].as_array().unwrap().iter().map(|o| o["name"].as_str().unwrap().to_owned()));
        }
    }
    let missing: Vec<&String> = nouns.iter().filter(|noun| scenelang_assets::family_of(noun, "").is_none()).collect();
    println!("{} of {} nouns are drawn; not: {missing:?}", nouns.len() - missing.len(), nouns.len());
    assert!(nouns.len() > 100 && 20 * missing.len() <= nouns.len(), "{missing:?} of {}", nouns.len());
}
