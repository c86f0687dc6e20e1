//! `scenelang solve`, from end to end: what is proved impossible, and what is printed for other programs.

use crate::problems::{file, sample};
use crate::repair::contains;
use crate::support::{fits, read_json, root, scenelang};
use serde_json::{Value, json};
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

/// Another kind of file, or a misspelt name, in place of a program.
#[test]
fn what_is_no_program_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let text = r#"{"format": "scenelang.layout/1", "objects": {"a": {"position": [0, 0, 0], "rot": [0, 0, 0], "scale": [1, 1, 1]}}}"#;
    fs::write(folder.path().join("room.layout.json"), text).unwrap();
    fs::write(folder.path().join("room.scene"), "object a;\nassert a.pos.x >= 0;\n").unwrap();
    for (args, said) in [
        (&["solve", "room.layout.json"][..], "`solve` takes a `.scene` file, and a layout to start from with --layout"),
        (&["synth", "bedroom.scen", "-o", "out"], "there is no file bedroom.scen; a program ends in `.scene`"),
        (&["check", "room.layout.json"], "has no `pos`; `position` is not read"),
        (&["check", "layout.scene"], "if this file is a layout, its name must end in `.json`"),
    ] {
        fs::write(folder.path().join("layout.scene"), text).unwrap();
        let ended = scenelang(folder.path(), args.iter().copied());
        let all = ended.stdout.clone() + &ended.stderr;
        assert!(ended.code == 2 && all.contains(said), "{args:?}: {} {all}", ended.code);
        assert!(!folder.path().join("out").exists(), "{args:?}");
    }
}

#[test]
fn the_examples_of_the_book_are_as_shown() {
    let examples = book();
    assert!(!examples.is_empty());
    for (scene, shown) in examples {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("room.scene"), &scene).unwrap();
        let ended = scenelang(folder.path(), ["solve", "room.scene", "--free", "--format", "json"]);
        let answer = fits("solution", &ended.stdout);
        assert!(contains(&answer, &shown), "{scene}\n{shown:#}\nbut\n{answer:#}");
    }
}

#[test]
fn what_is_in_the_way_is_named_in_words() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, _) = book().remove(2);
    fs::write(folder.path().join("room.scene"), &scene).unwrap();
    let ended = scenelang(folder.path(), ["solve", "room.scene"]);
    assert_eq!(ended.code, 1, "{}", ended.stderr);
    let said = "the layout satisfies all statements except this one, although removing it may not be necessary:\n  \
                room.scene:7:1: forall a in lamp: forall b in lamp: a != b implies distance(a, b) = 2\n";
    assert!(
        ended.stdout.contains("after the search budget was used up (increase it with --effort)\n"),
        "{}",
        ended.stdout
    );
    assert!(ended.stdout.contains(said), "{}", ended.stdout);
    // The layout is the witness, as `check` sees it.
    let report = scenelang(folder.path(), ["check", "room.layout.json", "--format", "json"]).reports().remove(0);
    let failing: Vec<&Value> =
        report["constraints"].as_array().unwrap().iter().filter(|c| c["satisfied"] == false).collect();
    assert_eq!((failing.len(), &failing[0]["id"]), (1, &"room.scene:7:1".into()));
}

/// Some things in a room, one of them where only its turn is open and one that only moves along z.
const OPEN: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(5, 2.5, 4);\nobject table;\nobject lamp;\n\
                    object chair[3];\ntable.dimensions <- vec3(1.2, 0.7, 0.8);\nlamp.dimensions <- vec3(0.4, 1.5, 0.4);\n\
                    chair.dimensions <- vec3(0.5, 0.9, 0.5);\ntable.pos <- vec3(0, 0, 0);\nassert lamp.pos.x = 2;\n\
                    lamp.rot <- rot(0, 0, 0);\nassert forall c in chair: gap(c, table) <= 0.8;\n";

#[test]
fn several_layouts_differ_in_kind() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.scene"), OPEN).unwrap();
    let ended = scenelang(folder.path(), ["solve", "room.scene", "--alternatives", "3", "--format", "json"]);
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    let answer = fits("solution", &ended.stdout);
    let files: Vec<&str> = answer["layouts"].as_array().unwrap().iter().map(|l| l["file"].as_str().unwrap()).collect();
    assert_eq!(files, ["room.1.layout.json", "room.2.layout.json", "room.3.layout.json"]);
    assert_eq!(scenelang(folder.path(), ["check"].iter().chain(&files)).code, 0);
    let layouts: Vec<Value> = files.iter().map(|f| read_json(&folder.path().join(f))).collect();
    for (i, a) in layouts.iter().enumerate() {
        for b in &layouts[..i] {
            let moved = a["objects"].as_object().unwrap().iter().filter(|(name, p)| {
                let q = &b["objects"][name.as_str()];
                let far = |k: &str, i: usize| (p[k][i].as_f64().unwrap() - q[k][i].as_f64().unwrap()).abs();
                far("pos", 0) > 0.35 || far("pos", 2) > 0.35 || far("rot", 1) > 39.0
            });
            assert!(moved.count() >= 1, "{a:#}\n{b:#}");
        }
    }

    // Of what can only be in one way there is one layout, and that is said.
    fs::write(folder.path().join("one.scene"), "object a; a.pos <- vec3(0, 0, 0); a.rot <- rot(0, 0, 0);").unwrap();
    let ended = scenelang(folder.path(), ["solve", "one.scene", "--alternatives", "3"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    assert!(ended.stdout.contains("1 of 3 substantially different layouts were found"), "{}", ended.stdout);
    let written = |name: &str| folder.path().join(name).exists();
    assert!(written("one.1.layout.json") && !written("one.2.layout.json") && !written("one.layout.json"));
}

#[test]
fn what_is_still_free_is_named() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.scene"), OPEN).unwrap();
    let solve = |more: &[&str]| scenelang(folder.path(), ["solve", "room.scene"].iter().chain(more));
    // Only who asks for it waits for it.
    assert!(!solve(&[]).stdout.contains("free"));
    let answer = fits("solution", &solve(&["--format", "json"]).stdout);
    assert_eq!(answer["layouts"][0]["free"], json!({ "objects": [], "complete": false }));
    let answer = fits("solution", &solve(&["--free", "--format", "json"]).stdout);
    let free = &answer["layouts"][0]["free"];
    let of = |name: &str| free["objects"].as_array().unwrap().iter().find(|f| f["object"] == name);
    assert!(free["complete"] == true && of("chair[2]").is_some(), "{free:#}");
    let table = of("table").unwrap();
    assert_eq!((&table["x"], &table["z"], &table["turn"]), (&json!([0.0, 0.0]), &json!([0.0, 0.0]), &true.into()));
    let lamp = of("lamp").unwrap();
    assert_eq!((&lamp["x"], &lamp["turn"]), (&json!([0.0, 0.0]), &false.into()));
    let reach: f64 = lamp["z"].as_array().unwrap().iter().map(|z| z.as_f64().unwrap()).sum();
    assert!(reach > 0.0 && reach <= 3.61, "within a room of 4 m, 0.4 m thick: {lamp}");
    let ended = solve(&["--free"]);
    let line = ended.stdout.lines().find(|l| l.starts_with("objects that can still move: ")).expect("a line");
    assert!(line.contains(lamp["text"].as_str().unwrap()) && line.contains("`lamp` along z by up to "), "{line}");
}

#[test]
fn threads_change_no_byte_and_effort_raises_the_budget() {
    let folder = tempfile::tempdir().unwrap();
    // No layout satisfies it, and none is proved impossible: the whole budget is spent.
    let (scene, _) = book().remove(2);
    fs::write(folder.path().join("room.scene"), &scene).unwrap();
    let solve = |more: &[&str]| {
        let ended = scenelang(folder.path(), ["solve", "room.scene", "--format", "json"].iter().chain(more));
        assert_eq!(ended.code, 1, "{more:?}: {}", ended.stderr);
        let warnings = fits("solution", &ended.stdout)["warnings"].to_string();
        let budget = warnings.split("the budget of ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
        assert!(warnings.contains("`--effort`"), "{warnings}");
        let budget: u64 = budget.parse().unwrap();
        (ended.stdout, fs::read(folder.path().join("room.layout.json")).unwrap(), budget)
    };
    let usual = solve(&["--threads", "1"]);
    assert!(solve(&["--threads", "2", "--effort", "1"]) == usual);
    assert_eq!(solve(&["--effort", "2"]).2, 2 * usual.2);

    fs::write(folder.path().join("room.scene"), OPEN).unwrap();
    let layouts = [["--threads", "1"], ["--threads", "2"], ["--effort", "3"]].map(|option| {
        let ended = scenelang(folder.path(), ["synth", "room.scene", "-o", "out"].iter().chain(&option));
        assert_eq!(ended.code, 0, "{option:?}: {}", ended.stderr);
        fs::read(folder.path().join("out/room.layout.json")).unwrap()
    });
    assert!(layouts.iter().all(|layout| *layout == layouts[0]));
}

#[test]
fn threads_and_effort_have_limits() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.scene"), OPEN).unwrap();
    for command in ["solve", "synth"] {
        for [option, value] in [
            ["--effort", "0"],
            ["--effort", "1001"],
            ["--effort", "-1"],
            ["--effort", "much"],
            ["--quality", "101"],
            ["--quality", "-1"],
            ["--threads", "0"],
            ["--threads", "65536"],
        ] {
            let ended = scenelang(folder.path(), [command, "room.scene", &format!("{option}={value}")]);
            assert_eq!(ended.code, 2, "{command} {option} {value}: {}", ended.stderr);
            assert!(ended.stderr.contains(option), "{}", ended.stderr);
        }
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "nothing was written");
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
        assert!(ended.stdout.contains("these 2 statements contradict each other"), "{}", ended.stdout);
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

/// What a layout of some scene has of its preferences, by weight, and the layout.
fn preferred(scene: &str, options: &[&str]) -> ([f64; 2], Vec<u8>) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.scene"), scene).unwrap();
    let ended = scenelang(folder.path(), ["solve", "room.scene", "--format", "json"].iter().chain(options));
    assert_eq!(ended.code, 0, "{options:?}: {}", ended.stderr);
    let answer = fits("solution", &ended.stdout);
    let weights = ["met", "all"].map(|key| answer["layouts"][0]["preferences"][key].as_f64().unwrap());
    (weights, fs::read(folder.path().join("room.layout.json")).unwrap())
}

#[test]
fn quality_says_how_much_is_done_for_preferences() {
    let scene = fs::read_to_string(file("soft-n12-d40-s11", "scene")).unwrap();
    let ([none, all], _) = preferred(&scene, &["--quality", "0"]);
    let ([usual, _], layout) = preferred(&scene, &[]);
    let ([most, _], _) = preferred(&scene, &["--quality", "40"]);
    assert!(none < usual && usual <= most && most <= all, "{none} {usual} {most} {all}");
    // The hidden layout is no better.
    let hidden = tempfile::tempdir().unwrap();
    fs::write(hidden.path().join("soft-n12-d40-s11.scene"), &scene).unwrap();
    fs::copy(file("soft-n12-d40-s11", "witness.json"), hidden.path().join("witness.json")).unwrap();
    let report = scenelang(hidden.path(), ["check", "witness.json", "--format", "json", "--explain", "none"]);
    let report = report.reports().remove(0);
    let rows = report["constraints"].as_array().unwrap().iter();
    let met = rows.filter(|row| row["kind"] == "prefer" && row["satisfied"] == true);
    assert!(usual >= met.map(|row| row["weight"].as_f64().unwrap()).sum::<f64>());
    for threads in ["1", "2"] {
        assert!(preferred(&scene, &["--threads", threads]).1 == layout, "{threads}");
    }
}

#[test]
fn paths_that_cannot_be_are_no_obstacle_where_they_are_only_preferred() {
    let scene = "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(5, 2.5, 4);
                 object door; object table; object chair[4]; object shelf[3];
                 table.dimensions <- vec3(1.6, 0.75, 0.9); door.dimensions <- vec3(0.9, 2, 0.05);
                 assert connects(door, room) and door.pos.y = 0;
                 assert forall c in chair: inside(c, room) and near(c, table, 0.3);
                 assert forall s in shelf: inside(s, room);
                 prefer forall c in chair: reachable(door, c, 0.75) weight 2;
                 prefer reachable(door, table, 3.9) weight 2;
                 prefer forall s in shelf: againstWall(s, room);";
    let ([met, all], _) = preferred(scene, &[]);
    assert_eq!((met, all), (3.0, 5.0));
}

#[test]
fn what_may_turn_freely_stands_along_the_nearest_wall() {
    let scene = "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(6, 2.5, 5); room.rot <- rot(0, 20, 0);
                 object a; object b; object c; assert inside(a, room) and inside(b, room) and inside(c, room);
                 assert distance(a, b) >= 2; assert near(b, c, 0.5);";
    let (_, layout) = preferred(scene, &[]);
    let layout: Value = serde_json::from_slice(&layout).unwrap();
    for (name, placement) in layout["objects"].as_object().unwrap() {
        let off = (placement["rot"][1].as_f64().unwrap() - 20.0).rem_euclid(90.0);
        assert!(off.min(90.0 - off) < 1e-6, "{name}: {off}");
    }
}
