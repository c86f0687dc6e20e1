//! What other people's programs read: SARIF by its official schema, JUnit XML by a parser, annotations as GitHub takes
//! them. All are made of the same good and bad files.

use crate::support::{faults, has_node_package, python, root, run, scenelang, skip};
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
        (
            "a folder, 100 %/wärmt: so.scene",
            "object a; assert a.pos.x <-1;\nlamp.color <- \u{201c}red\u{201d};\n".to_owned(),
        ),
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
    let uris: Vec<_> =
        results.iter().map(|r| &r["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]).collect();
    assert!(uris.iter().any(|u| *u == "a%20folder%2C%20100%20%25/w%C3%A4rmt%3A%20so.scene"), "{uris:?}");

    if !has_node_package("@microsoft/jest-sarif") {
        return skip("SARIF not validated: no @microsoft/jest-sarif (Node and tests/oracles/node_modules)");
    }
    let package = root().join("tests/oracles/node_modules/@microsoft/jest-sarif");
    let text = fs::read_to_string(package.join("lib/schemas/sarif-2.1.0-rtm.5.json")).unwrap();
    // A bracket too many in the pattern of a member that we do not write: not every engine takes it for a character.
    let schema: Value = serde_json::from_str(&text.replace("{2}]?$", "{2}?$")).unwrap();
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
    assert!(suites.contains(&"fails.layout.json: 6 4 0 1"), "{suites:#?}");
    assert!(suites.contains(&"null.layout.json: 7 2 1 2"), "{suites:#?}");
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
        let known = [
            &["file", "title"][..],
            &["file", "line", "endLine", "title"],
            &["file", "line", "endLine", "col", "endColumn", "title"],
        ];
        assert!(known.contains(&keys.as_slice()), "{line}");
    }
    assert!(text.contains("file=a folder%2C 100 %25/wärmt%3A so.scene,line=1"), "{text}");
    insta::assert_snapshot!(
        text.lines().filter(|l| l.contains("title=V0")).collect::<Vec<_>>().join("\n"),
        @r##"
    ::error file=good.scene,line=4,endLine=5,title=V0101::box.pos.x > 1 fails: `box.pos.x` is 0, but must be more than 1 (margin -1.000 m)
    ::notice file=good.scene,line=6,endLine=6,col=1,endColumn=20,title=V0106::lid.rot.y = 0 is not met: `lid.rot.y` is 30°, but must be equal to 0° (margin -29.9°)
    ::error file=good.scene,line=8,endLine=8,col=1,endColumn=30,title=V0101::1 / (box.pos.x - 5) > 0 fails: `1 / (box.pos.x - 5)` is -0.2, but must be more than 0 (margin -0.200 m)
    ::error file=good.scene,line=1,endLine=1,col=8,endColumn=10,title=V0102::`box` overlaps `lid` by 0.10 m (margin -0.099 m)
    ::error file=good.scene,line=2,endLine=2,col=8,endColumn=10,title=V0104::`lid` is not supported: it reaches 0.1 m below the top of `box` (margin -0.095 m)
    ::notice file=good.scene,line=6,endLine=6,col=1,endColumn=20,title=V0106::lid.rot.y = 0 is not met: `lid.rot.y` is 30°, but must be equal to 0° (margin -29.9°)
    ::error file=good.scene,line=1,endLine=1,col=8,endColumn=10,title=V0102::`box` overlaps `lid` by 0.10 m (margin -0.099 m)
    ::error file=good.scene,line=2,endLine=2,col=8,endColumn=10,title=V0104::`lid` is not supported: it reaches 0.1 m below the top of `box` (margin -0.095 m)
    "##
    );
}

#[test]
fn compact_is_one_line_each() {
    let folder = folder();
    let ended = scenelang(folder.path(), ["check", "fails.layout.json", "broken.scene", "--verbosity", "compact"]);
    insta::assert_snapshot!(ended.stdout, @r##"
    good.scene:7:8: warning[W0304]: this compares something with itself
    good.scene:4:1: error[V0101]: box.pos.x > 1 fails: `box.pos.x` is 0, but must be more than 1 (margin -1.000 m)
    good.scene:6:1: advice[V0106]: lid.rot.y = 0 is not met: `lid.rot.y` is 30°, but must be equal to 0° (margin -29.9°)
    good.scene:8:1: error[V0101]: 1 / (box.pos.x - 5) > 0 fails: `1 / (box.pos.x - 5)` is -0.2, but must be more than 0 (margin -0.200 m)
    good.scene:1:8: error[V0102]: `box` overlaps `lid` by 0.10 m (margin -0.099 m)
    good.scene:2:8: error[V0104]: `lid` is not supported: it reaches 0.1 m below the top of `box` (margin -0.095 m)
    fails.layout.json: 1 of 3 assertions, 0 of 1 preferences, 1 of 3 physical rules hold, 1 warning
    broken.scene:1:9: error[E0111]: missing `;` at the end of this statement
    broken.scene:2:16: error[E0112]: a value is missing after `>`
    broken.scene:3:8: error[E0201]: `b` is not declared
    broken.scene:3:20: warning[W0101]: there is no statement before this `;`
    broken.scene:3:22: error[E0102]: this string is not closed on its line
    broken.scene: 4 errors, 1 warning
    "##);
}
