//! What other people's programs read: SARIF by its official schema, JUnit XML by a parser, annotations as GitHub takes
//! them. All are made of the same good and bad files.

use crate::support::{faults, has_node_package, python, read_json, root, run, scenelang, skip};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;

/// A folder with everything that a report can be about.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let layout = |scene: &str, x: &str| {
        format!(
            r#"{{ "format": "scenelang.layout/1", "scene": "{scene}",
                 "objects": {{ "box": {{ "pos": [{x}, 0, 0], "scale": [1, 1, 1] }},
                               "lid": {{ "pos": [{x}, 0.9, 0], "rot": [0, 30, 0], "scale": [1, 1, 1] }} }} }}"#
        )
    };
    let good = "object box;\nobject lid;\n@req(\"<é & 100 %>\")\nassert box.pos.x\n  > 1;\nprefer lid.rot.y = 0;\nassert box = box;\n\
                assert 1 / (box.pos.x - 5) > 0;\n";
    for (name, text) in [
        ("good.scene", good.to_owned()),
        ("fails.layout.json", layout("good.scene", "0")),
        ("null.layout.json", layout("good.scene", "5")),
        ("missing.layout.json", layout("nowhere.scene", "0")),
        ("broken.layout.json", layout("good.scene", "NaN")),
        ("broken.scene", "object a\nassert a.pos.x > ;\nassert b.pos.x > 1;; \"\n".to_owned()),
        ("a folder, 100 %/wärmt: so.scene", "object a; assert a.pos.x <-1;\nlamp.color <- \u{201c}red\u{201d};\n".to_owned()),
    ] {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    fs::write(folder.path().join("latin.scene"), b"object a;\n// \xff\n").unwrap();
    folder
}

/// What `check` prints of all of it, and of a file that is not there.
fn printed(folder: &Path, format: &str) -> String {
    let ended = scenelang(folder, ["check", ".", "nowhere.scene", "--format", format]);
    assert_eq!(ended.code, 2, "{}", ended.stderr);
    ended.stdout
}

#[test]
fn json_is_as_its_schema_says() {
    let folder = folder();
    let reports = scenelang(folder.path(), ["check", ".", "nowhere.scene", "--format", "json", "--all"]).reports();
    let files: Vec<_> = reports.iter().map(|r| r["file"].as_str().unwrap()).collect();
    assert_eq!(
        files,
        [
            "a folder, 100 %/wärmt: so.scene",
            "broken.layout.json",
            "broken.scene",
            "fails.layout.json",
            "good.scene",
            "latin.scene",
            "missing.layout.json",
            "null.layout.json",
            "nowhere.scene"
        ]
    );
}

#[test]
fn sarif_is_as_its_official_schema_says() {
    let folder = folder();
    let log: Value = serde_json::from_str(&printed(folder.path(), "sarif")).unwrap();
    let results = log["runs"][0]["results"].as_array().unwrap();
    assert!(results.iter().any(|r| r["fixes"].is_array()) && results.iter().any(|r| r["relatedLocations"].is_array()));
    assert!(results.iter().any(|r| r["level"] == "note") && results.iter().any(|r| r["level"] == "warning"));
    let uris: Vec<_> = results.iter().map(|r| &r["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]).collect();
    assert!(uris.iter().any(|u| *u == "a%20folder%2C%20100%20%25/w%C3%A4rmt%3A%20so.scene"), "{uris:?}");

    if !has_node_package("@microsoft/jest-sarif") {
        return skip("SARIF not validated: no @microsoft/jest-sarif (Node and tests/oracles/node_modules)");
    }
    let package = root().join("tests/oracles/node_modules/@microsoft/jest-sarif");
    let schema = read_json(&package.join("lib/schemas/sarif-2.1.0-rtm.5.json"));
    let validator = jsonschema::options().should_validate_formats(true).build(&schema).unwrap();
    let found = faults(&validator, &log);
    assert!(found.is_empty(), "{found:#?}");
    let mut bad = log.clone();
    bad["runs"][0]["results"][0]["level"] = "fatal".into();
    assert_eq!(faults(&validator, &bad).len(), 1, "the schema does look at results");
}

#[test]
fn junit_is_read_by_a_parser() {
    let folder = folder();
    let path = folder.path().join("junit.xml");
    fs::write(&path, printed(folder.path(), "junit")).unwrap();
    let Some(python) = python() else { return skip("JUnit XML not parsed: no .venv") };
    let ended = run(Command::new(python).arg(root().join("tests/oracles/junit.py")).arg(&path), b"");
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    let suites: Vec<&str> = ended.stdout.lines().collect();
    // Name; tests, failures, errors, skipped as stated, and the same as counted by the parser.
    assert!(suites.contains(&"fails.layout.json: 5 2 0 1"), "{suites:#?}");
    assert!(suites.contains(&"null.layout.json: 6 1 1 2"), "{suites:#?}");
    assert!(suites.contains(&"nowhere.scene: 1 0 1 0"), "{suites:#?}");
    assert_eq!(suites.len(), 9, "{suites:#?}");
}

#[test]
fn annotations_are_one_line_each() {
    let folder = folder();
    let text = printed(folder.path(), "github");
    for line in text.lines() {
        let (level, rest) = line.strip_prefix("::").and_then(|l| l.split_once(' ')).expect(line);
        let (properties, message) = rest.split_once("::").expect(line);
        assert!(["error", "warning", "notice"].contains(&level) && !message.is_empty(), "{line}");
        let keys: Vec<_> = properties.split(',').map(|p| p.split_once('=').expect(line).0).collect();
        let known = [&["file", "title"][..], &["file", "line", "endLine", "title"], &["file", "line", "endLine", "col", "endColumn", "title"]];
        assert!(known.contains(&keys.as_slice()), "{line}");
    }
    assert!(text.contains("file=a folder%2C 100 %25/wärmt%3A so.scene,line=1"), "{text}");
    insta::assert_snapshot!(
        text.lines().filter(|l| l.contains("title=V0")).collect::<Vec<_>>().join("\n"),
        @""
    );
}

#[test]
fn compact_is_one_line_each() {
    let folder = folder();
    let ended = scenelang(folder.path(), ["check", "fails.layout.json", "broken.scene", "--verbosity", "compact"]);
    insta::assert_snapshot!(ended.stdout, @"");
}
