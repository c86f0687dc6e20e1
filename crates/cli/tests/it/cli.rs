//! The command line as other programs see it: exit codes, formats, files written.

use crate::support::{folder_with, scenelang, scenelang_with_input};
use serde_json::Value;
use std::fs;
use std::path::Path;

const GOOD: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(4, 2.5, 4);\nobject box;\n\
                    box.scale <- vec3(1, 1, 1);\nassert box.pos.x >= 1;\n";

/// A folder with one good program, a layout that satisfies it and one that does not, and some bad files.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let layout = |x: f64| {
        format!(
            r#"{{ "format": "scenelang.layout/1", "scene": "good.scene",
                 "objects": {{ "box": {{ "pos": [{x}, 0, 0], "scale": [1, 1, 1] }} }},
                 "regions": {{ "room": {{ "pos": [0, 0, 0], "scale": [4, 2.5, 4] }} }} }}"#
        )
    };
    for (name, text) in [
        ("good.scene", GOOD.to_owned()),
        ("holds.layout.json", layout(1.2)),
        ("fails.layout.json", layout(0.5)),
        ("broken.layout.json", layout(1.2).replace("\"objects\"", "\"objects\" \"objects\"")),
        ("broken.scene", "object a\nassert a.pos.x > ;\n".to_owned()),
        ("extended.scene", "object a[2];\nassert forall x in a: x.pos.x > 0;\n".to_owned()),
        ("warns.scene", "object a;;\na.scale <- vec3(1, 1, 1);\nassert a.pos.x > 0;\n".to_owned()),
        ("loose.scene", "object   a ; assert a.pos.x>1; // why\n".to_owned()),
    ] {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

#[test]
fn exit_codes() {
    let folder = folder();
    for (args, want) in [
        (&["check", "good.scene"][..], 0),
        (&["check", "warns.scene"], 0),
        (&["check", "holds.layout.json"], 0),
        (&["check", "fails.layout.json"], 1),
        (&["check", "broken.layout.json"], 2),
        (&["check", "broken.scene"], 2),
        (&["check", "nowhere.scene"], 2),
        (&["check", "good.scene", "fails.layout.json"], 1),
        (&["check", "fails.layout.json", "broken.scene", "good.scene"], 2),
        (&["check", "extended.scene"], 0),
        (&["check", "--core", "extended.scene"], 2),
        (&["check", "--core", "good.scene"], 0),
        (&["check"], 2),
        (&["check", "good.scene", "--format", "yaml"], 2),
        (&["fmt", "--check", "good.scene"], 0),
        (&["fmt", "--check", "loose.scene"], 1),
        (&["fmt", "broken.scene"], 2),
        (&["solve", "good.scene", "-o", "new.layout.json"], 0),
        (&["check", "new.layout.json"], 0),
        (&["solve", "broken.scene"], 2),
        (&["solve", "nowhere.scene"], 2),
        (&["synth", "a bedroom with a bed and two lamps", "-o", "out"], 0),
        (&["synth", "colourless green ideas", "-o", "none"], 2),
        (&["formalize", "a bedroom with a bed and two lamps", "-o", "bedroom.scene"], 0),
        (&["check", "bedroom.scene"], 0),
        (&["formalize", "a bedroom with a bed", "--explain", "--literal", "--format", "json"], 0),
        (&["formalize", "colourless green ideas"], 1),
        (&["formalize"], 2),
        (&["formalize", "-f", "nowhere.txt"], 2),
        (&["dance"], 2),
        (&["--version"], 0),
        (&["--help"], 0),
    ] {
        let ended = scenelang(folder.path(), args);
        assert_eq!(ended.code, want, "{args:?}: {}{}", ended.stdout, ended.stderr);
        assert!(ended.code == 0 || !(ended.stdout.is_empty() && ended.stderr.is_empty()), "{args:?} says why");
    }
}

#[test]
fn json_is_one_report_per_file_whatever_happens() {
    let folder = folder();
    let files = ["good.scene", "fails.layout.json", "nowhere.scene", "broken.layout.json", "broken.scene"];
    let ended = scenelang(folder.path(), ["check", "--format", "json"].iter().chain(&files));
    let reports = ended.reports();
    assert_eq!(reports.len(), files.len());
    for (report, file) in reports.iter().zip(files) {
        assert_eq!(report["format"], "scenelang.report/1");
        assert!(report["file"].as_str().unwrap().ends_with(file), "{report:#}");
        assert_eq!(report["ok"].as_bool(), Some(file == "good.scene"), "{report:#}");
    }
    let row = &reports[1]["constraints"].as_array().unwrap().iter().find(|c| c["satisfied"] == false).unwrap();
    assert_eq!((&row["kind"], &row["unit"]), (&Value::from("assert"), &Value::from("m")));
    assert_eq!(row["text"], "box.pos.x >= 1");
    assert!((row["margin"].as_f64().unwrap() + 0.5).abs() < 1e-9);
    assert_eq!(row["span"]["start"], serde_json::json!([6, 1]));
}

#[test]
fn a_broken_layout_is_shown_where_it_breaks() {
    let folder = folder();
    let ended = scenelang(folder.path(), ["check", "--format", "json", "broken.layout.json"]);
    let report = &ended.reports()[0];
    assert_eq!(report["diagnostics"][0]["span"]["start"][0], 2, "{report:#}");
}

#[test]
fn other_formats_are_what_they_say() {
    let folder = folder();
    let sarif = scenelang(folder.path(), ["check", "fails.layout.json", "--format", "sarif"]);
    let log: Value = serde_json::from_str(&sarif.stdout).unwrap();
    assert_eq!((sarif.code, &log["version"]), (1, &Value::from("2.1.0")));
    assert_eq!(log["runs"][0]["results"][0]["ruleId"], "V0101");

    let junit = scenelang(folder.path(), ["check", "fails.layout.json", "--format", "junit"]);
    assert_eq!(junit.code, 1);
    for part in ["<?xml", "<testsuite", "<testcase", "<failure"] {
        assert!(junit.stdout.contains(part), "{part} in {}", junit.stdout);
    }

    let human = scenelang(folder.path(), ["check", "fails.layout.json"]);
    for part in ["V0101", "box", "good.scene:6"] {
        assert!(human.stdout.contains(part) || human.stderr.contains(part), "{part} in {human:?}");
    }
}

#[test]
fn fmt_keeps_comments_and_is_done_after_once() {
    let folder = folder();
    let text = "// first\nobject a;/* in */a.pos←vec3(1,2,3) ; // last";
    let once = scenelang_with_input(folder.path(), ["fmt", "-"], text.as_bytes());
    assert_eq!(once.code, 0, "{once:?}");
    for part in ["// first", "/* in */", "// last", "a.pos <- vec3(1, 2, 3);"] {
        assert!(once.stdout.contains(part), "{part} in {}", once.stdout);
    }
    let twice = scenelang_with_input(folder.path(), ["fmt", "-"], once.stdout.as_bytes());
    assert_eq!(twice.stdout, once.stdout);

    assert_eq!(scenelang(folder.path(), ["fmt", "loose.scene"]).code, 0);
    assert_eq!(scenelang(folder.path(), ["fmt", "--check", "loose.scene"]).code, 0);
    assert!(fs::read_to_string(folder.path().join("loose.scene")).unwrap().contains("// why"));
}

#[test]
fn all_shows_the_physical_rows_too() {
    let folder = folder();
    let rows = |args: &[&str]| {
        let reports = scenelang(folder.path(), args).reports();
        reports[0]["constraints"].as_array().unwrap().iter().filter(|c| !c["rule"].is_null()).count()
    };
    assert_eq!(rows(&["check", "--format", "json", "holds.layout.json"]), 0);
    assert!(rows(&["check", "--format", "json", "--all", "holds.layout.json"]) >= 2);
    assert_eq!(rows(&["check", "--format", "json", "--all", "--no-physics", "holds.layout.json"]), 0);
}

#[test]
fn synth_writes_everything_it_promises() {
    let (folder, _) = folder_with("bedroom");
    let ended = scenelang(folder.path(), ["synth", "bedroom.scene", "-o", "out", "--seed", "3"]);
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    let out = folder.path().join("out");
    for file in [
        "bedroom.scene",
        "bedroom.layout.json",
        "report.json",
        "bedroom.glb",
        "plan.svg",
        "plan.png",
        "picture.png",
        "preview.html",
        "unity/Assets",
        "unity/Packages/manifest.json",
        "unity/ProjectSettings/ProjectVersion.txt",
    ] {
        assert!(out.join(file).exists(), "{file}");
    }
    let starts = |file: &str, magic: &[u8]| fs::read(out.join(file)).unwrap().starts_with(magic);
    assert!(starts("plan.png", b"\x89PNG") && starts("picture.png", b"\x89PNG") && starts("bedroom.glb", b"glTF"));
    let report = crate::support::read_json(&out.join("report.json"));
    assert_eq!(report["ok"], true);
    let checked = scenelang(&out, ["check", "bedroom.layout.json"]);
    assert_eq!(checked.code, 0, "what was written stands on its own: {checked:?}");
    assert!(outside_links(&out.join("preview.html")).is_empty());
}

/// Addresses that a page would load from elsewhere.
fn outside_links(page: &Path) -> Vec<String> {
    let text = fs::read_to_string(page).unwrap();
    let loads = ["src=\"http", "src='http", "href=\"http", "url(http", "import(\"http"];
    loads.iter().filter(|l| text.contains(**l)).map(|l| (*l).to_owned()).collect()
}

#[test]
fn what_is_locked_stays_and_what_may_move_does() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(6, 3, 6);\nobject box[3];\nobject post;\n\
                 box.dimensions <- vec3(0.5, 0.5, 0.5);\npost.dimensions <- vec3(0.3, 1, 0.3);\n\
                 assert forall b in box: inside(b, room) and distance(b, post) <= 9;\nassert inside(post, room);\n";
    fs::write(folder.path().join("room.scene"), scene).unwrap();
    let first = scenelang(folder.path(), ["solve", "room.scene"]);
    assert_eq!(first.code, 0, "{}{}", first.stdout, first.stderr);
    let places = |file: &str| {
        let text = fs::read_to_string(folder.path().join(file)).unwrap();
        let layout: Value = serde_json::from_str(&text).unwrap();
        ["box[0]", "box[1]", "box[2]", "post"].map(|name| layout["objects"][name]["pos"].clone())
    };
    let before = places("room.layout.json");
    // What is asked now cannot hold with the post where it is, nor with the box where it is.
    let far = format!(
        "{scene}assert abs(post.pos.x - {}) >= 1 and abs(box[0].pos.x - {}) >= 1;\n",
        before[3][0], before[0][0]
    );
    fs::write(folder.path().join("room.scene"), far).unwrap();
    let run = |more: &[&str]| {
        let start = ["solve", "room.scene", "--layout", "room.layout.json", "-o", "next.json", "--time", "20"];
        scenelang(folder.path(), start.iter().chain(more))
    };
    let ended = run(&["--only", "post", "box[0]"]);
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    let after = places("next.json");
    assert_eq!((&after[1], &after[2]), (&before[1], &before[2]));
    assert!(after[0] != before[0] && after[3] != before[3], "{after:?}");
    let ended = run(&["--lock", "box", "post", "--format", "json"]);
    assert_eq!(ended.code, 1, "{}{}", ended.stdout, ended.stderr);
    let said: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!(said["end"], "exhausted", "with everything locked there is nothing to search");
    assert_eq!(places("next.json"), before);
    let ended = run(&["--lock", "box", "post"]);
    assert!(ended.stdout.contains("unlocking some of them may be enough"), "{}", ended.stdout);
    let ended = run(&["--lock", "boks"]);
    assert_eq!(ended.code, 2, "{}", ended.stdout);
    assert!(ended.stderr.contains("no object `boks`"), "{}", ended.stderr);
}
