//! Folders, several files at once, and the settings of a workspace.

use crate::support::{fits, scenelang};
use std::fs;
use std::path::Path;

/// A room with a box that leans 3 mm into a second one: right with a larger tolerance, or without physics.
const SCENE: &str = "object a;\nobject b;\nassert a.pos.x = 0;\nassert b.pos.x = 1;\n";

fn write(folder: &Path, name: &str, text: &str) {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

fn layout(x: f64) -> String {
    format!(
        r#"{{ "format": "scenelang.layout/1", "scene": "room.scene",
             "objects": {{ "a": {{ "pos": [0, 0, 0], "scale": [1, 1, 1] }}, "b": {{ "pos": [{x}, 0, 0], "scale": [1, 1, 1] }} }} }}"#
    )
}

#[test]
fn settings_are_found_above_the_file_and_options_come_first() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "deep/er/room.scene", SCENE);
    write(folder.path(), "deep/er/room.layout.json", &layout(0.9985));
    let check = |args: &[&str]| {
        let ended =
            scenelang(folder.path(), ["check", "deep/er/room.layout.json", "--format", "json"].iter().chain(args));
        let report = ended.reports().remove(0);
        (ended.code, report)
    };
    // 1.5 mm off: too much for `=`, and too deep for the boxes.
    assert_eq!(check(&[]).0, 1);
    write(folder.path(), "scenelang.toml", "eta = 0.05\n[tolerances]\nequal = 0.002\ncontact = 0.002\n");
    let (code, report) = check(&[]);
    assert_eq!((code, &report["eta"]), (0, &0.05.into()));
    assert_eq!(report["tolerances"]["equal"], 0.002);
    assert_eq!(report["tolerances"]["angle"], 0.1, "what is not given stays");
    assert_eq!(check(&["--tolerance", "contact=0.001"]).0, 1);
    assert_eq!(check(&["--eta", "0.1"]).1["eta"], 0.1);
    // The nearest file counts, alone.
    write(folder.path(), "deep/scenelang.toml", "physics = false\n");
    let (code, report) = check(&[]);
    assert_eq!((code, &report["summary"]["physical"]["total"]), (1, &0.into()));
    assert_eq!(check(&["--tolerance", "equal=0.002"]).0, 0);
    assert_eq!(check(&["--tolerance", "equal=0.002", "--physics"]).0, 1);
    for (args, wanted) in [
        (["--tolerance", "equals=1"], "did you mean `equal`?"),
        (["--tolerance", "equal"], "NAME=VALUE"),
        (["--tolerance", "equal=-1"], "from 0 to a million"),
        (["--eta", "inf"], "from 0 to a million"),
    ] {
        let ended = scenelang(folder.path(), ["check", "deep/er/room.layout.json"].iter().chain(&args));
        assert!(ended.code == 2 && ended.stderr.contains(wanted), "{args:?}: {}", ended.stderr);
    }
}

#[test]
fn settings_hold_for_solve_and_synth_too() {
    let folder = tempfile::tempdir().unwrap();
    write(
        folder.path(),
        "room.scene",
        "object a;\na.pos <- vec3(0, 2, 0);\na.scale <- vec3(1, 1, 1);\nassert a.pos.y > 1;\n",
    );
    assert_eq!(scenelang(folder.path(), ["solve", "room.scene"]).code, 1, "it floats");
    write(folder.path(), "scenelang.toml", "physics = false\n");
    assert_eq!(scenelang(folder.path(), ["solve", "room.scene"]).code, 0);
    fits("layout", &fs::read_to_string(folder.path().join("room.layout.json")).unwrap());
    write(folder.path(), "scenelang.toml", "physik = false\n");
    for args in [&["solve", "room.scene"][..], &["synth", "room.scene"], &["check", "room.scene"]] {
        let ended = scenelang(folder.path(), args);
        assert_eq!(ended.code, 2);
        let said = format!("{}{}", ended.stdout, ended.stderr);
        assert!(said.contains("scenelang.toml:1:1") && said.contains("did you mean `physics`?"), "{said}");
    }
}

#[test]
fn slips_in_settings_are_shown_with_their_place() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "room.scene", SCENE);
    write(folder.path(), "scenelang.toml", "physics = true\n\n[tolerance]\nequal = 0.002\n");
    let ended = scenelang(folder.path(), ["check", "room.scene"]);
    assert_eq!(ended.code, 2);
    insta::assert_snapshot!(ended.stdout, @r##"
    [E0007] Error: there is no setting `tolerance`; did you mean `tolerances`?
       ╭─[ scenelang.toml:3:2 ]
       │
     3 │ [tolerance]
       │  ────┬────
       │      ╰────── here
    ───╯
    room.scene: 1 error
    "##);
    let report = scenelang(folder.path(), ["check", "room.scene", "--format", "json"]).reports().remove(0);
    assert_eq!(report["file"], "room.scene");
    let finding = &report["diagnostics"][0];
    assert_eq!((&finding["code"], &finding["span"]["file"]), (&"E0007".into(), &"scenelang.toml".into()));
}

#[test]
fn warnings_can_be_silenced_by_settings() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "room.scene", "object a;;\nassert a.pos.x > 0;\n");
    let codes = || -> Vec<String> {
        let report = scenelang(folder.path(), ["check", "room.scene", "--format", "json"]).reports().remove(0);
        report["diagnostics"].as_array().unwrap().iter().map(|d| d["code"].as_str().unwrap().to_owned()).collect()
    };
    assert!(codes().contains(&"W0101".to_owned()));
    write(folder.path(), "scenelang.toml", "[lints]\nallow = [\"W0101\"]\n");
    assert!(!codes().contains(&"W0101".to_owned()));
}

#[test]
fn folders_are_judged_in_order_by_any_number_of_threads() {
    let folder = tempfile::tempdir().unwrap();
    for i in 0..12 {
        let x = if i == 7 { 3.0 } else { 1.0 };
        write(folder.path(), &format!("rooms/{i:02}/room.scene"), SCENE);
        write(folder.path(), &format!("rooms/{i:02}/room.layout.json"), &layout(x));
    }
    write(folder.path(), "rooms/node_modules/x.scene", "not a program");
    write(folder.path(), "rooms/.hidden/x.scene", "not a program");
    let with = |jobs: &str| {
        let ended = scenelang(folder.path(), ["check", "rooms", "--format", "json", "--jobs", jobs]);
        assert_eq!(ended.code, 1, "the worst: {}", ended.stderr);
        ended
    };
    let alone = with("1");
    let files: Vec<String> = alone.reports().iter().map(|r| r["file"].as_str().unwrap().to_owned()).collect();
    assert_eq!(files.len(), 24);
    assert_eq!(&files[..2], ["rooms/00/room.layout.json", "rooms/00/room.scene"]);
    assert!(files.is_sorted());
    for jobs in ["2", "7"] {
        assert_eq!(with(jobs).stdout, alone.stdout, "{jobs} at once");
    }
    assert_eq!(scenelang(folder.path(), ["check", "rooms", "--jobs", "0"]).code, 2);
}

#[test]
fn a_folder_without_scenes_cannot_be_judged() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "empty/readme.txt", "");
    let ended = scenelang(folder.path(), ["check", "empty", "--format", "json"]);
    let report = ended.reports().remove(0);
    assert_eq!((ended.code, &report["file"]), (2, &"empty".into()));
    assert_eq!(report["diagnostics"][0]["code"], "E0001");
}

#[test]
fn schemas_are_printed() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in scenelang_verify::schemas::ALL {
        let ended = scenelang(folder.path(), ["schema", name]);
        assert_eq!((ended.code, ended.stdout.as_str()), (0, text));
    }
    let ended = scenelang(folder.path(), ["schema", "sofa"]);
    assert!(
        ended.code == 2 && ended.stderr.contains("config, diff, layout, query, repair, report, solution"),
        "{}",
        ended.stderr
    );
}

/// Whatever judges a layout says by which settings, in the same words, where these are not the usual ones.
#[test]
fn the_settings_are_named_by_every_command_that_judges() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "room.scene", "object a;\nobject b;\n@req(\"a is there\")\nassert a.pos.x = 0;\n");
    write(folder.path(), "room.layout.json", &layout(0.5));
    let commands: [&[&str]; 5] = [
        &["check", "room.layout.json"],
        &["repair", "room.layout.json"],
        &["trace", "room.scene"],
        &["query", "room.scene"],
        &["diff", "room.layout.json", "room.layout.json"],
    ];
    for (settings, wanted) in [("physics = false\n", true), ("physics = true\n", false)] {
        write(folder.path(), "scenelang.toml", settings);
        for command in commands {
            let told = scenelang(folder.path(), command);
            let line = told.stdout.lines().filter(|line| *line == "checked with scenelang.toml: physics off").count();
            assert_eq!(line, usize::from(wanted), "{command:?}: {}{}", told.stdout, told.stderr);
            let json = scenelang(folder.path(), command.iter().chain(&["--format", "json"]));
            let schema = match command[0] {
                "check" => "report",
                name => name,
            };
            let document = fits(schema, json.stdout.trim());
            let with = if schema == "diff" { &document["before"]["judged_with"] } else { &document["judged_with"] };
            assert_eq!(with["changes"] == serde_json::json!(["physics off"]), wanted, "{command:?}: {document}");
        }
    }
}
