//! `check --fix`, and comments that silence warnings, as far as files and later stages are concerned.

use crate::support::{root, scenelang};
use std::fs;
use std::path::Path;

fn write(folder: &Path, files: &[(&str, &str)]) {
    for (name, text) in files {
        fs::create_dir_all(folder.join(name).parent().unwrap()).unwrap();
        fs::write(folder.join(name), text).unwrap();
    }
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap()
}

const LAYOUT: &str = r#"{ "format": "scenelang.layout/1", "scene": "room.scene",
    "objects": { "box": { "pos": [1, 0, 0], "scale": [1, 1, 1] } } }"#;

#[test]
fn safe_fixes_are_made_and_the_rest_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    write(
        at,
        &[
            ("in/room.scene", "import \"parts/a.scene\";\nobject box;;\nassert box.pos.x > 0 & lump.pos.x > 1\n"),
            ("in/parts/a.scene", "Number gap;;\ngap <- 1;\n"),
            ("in/fine.scene", "object box;\nassert box.pos.x > 0;\n"),
        ],
    );
    let unchanged = fs::metadata(at.join("in/fine.scene")).unwrap().modified().unwrap();
    let ended = scenelang(at, ["check", "--fix", "in/room.scene", "in/fine.scene"]);
    assert_eq!(ended.code, 2, "an unknown name is left: {ended:?}");
    for line in [
        "fixed 3 of 4 findings in in/room.scene\n",
        "fixed 1 of 1 finding in in/parts/a.scene\n",
        "[E0201]",
        "in/fine.scene: no problems found\n",
    ] {
        assert!(ended.stdout.contains(line), "{line} in {}", ended.stdout);
    }
    assert!(!ended.stdout.contains("E0111"), "{}", ended.stdout);
    let room = "import \"parts/a.scene\";\nobject box;\nassert box.pos.x > 0 and lump.pos.x > 1;\n";
    assert_eq!(read(at, "in/room.scene"), room);
    assert_eq!(read(at, "in/parts/a.scene"), "Number gap;\ngap <- 1;\n");
    assert_eq!(fs::metadata(at.join("in/fine.scene")).unwrap().modified().unwrap(), unchanged);

    let again = scenelang(at, ["check", "--fix", "in/room.scene"]);
    assert!(!again.stdout.contains("fixed"), "{}", again.stdout);
    assert_eq!(read(at, "in/room.scene"), room);
}

#[test]
fn the_program_of_a_layout_is_fixed() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    write(at, &[("room.scene", "object box\nassert box.pos.x =< 2;\n"), ("room.layout.json", LAYOUT)]);
    assert_eq!(scenelang(at, ["check", "room.layout.json"]).code, 2);
    let ended = scenelang(at, ["check", "--fix", "--format", "json", "room.layout.json"]);
    assert_eq!(ended.code, 0, "{ended:?}");
    let report = &ended.reports()[0];
    assert_eq!(report["ok"], true);
    let fixed = report["fixed"].as_array().unwrap();
    let told: Vec<String> = fixed.iter().map(|f| format!("{} {} {}", f["file"], f["line"], f["code"])).collect();
    assert_eq!(told, ["\"room.scene\" 1 \"E0111\"", "\"room.scene\" 2 \"E0116\""]);
    assert_eq!(read(at, "room.layout.json"), LAYOUT);
    // Without anything to fix there is no such member.
    let report = &scenelang(at, ["check", "--fix", "--format", "json", "room.layout.json"]).reports()[0];
    assert!(report.get("fixed").is_none());
}

#[test]
fn files_elsewhere_and_files_that_are_not_there_stay_as_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let shared = "object table;;\n";
    write(at, &[("in/room.scene", "import \"../shared.scene\";\nassert table.pos.x > 1;\n"), ("shared.scene", shared)]);
    // Makes one workspace of both folders.
    write(at, &[("scenelang.toml", "")]);
    let ended = scenelang(at, ["check", "--fix", "in/room.scene"]);
    assert_eq!(ended.code, 0, "{ended:?}");
    assert!(ended.stdout.contains("shared.scene is outside the program's folder"), "{}", ended.stdout);
    assert_eq!(read(at, "shared.scene"), shared);
    let ended = scenelang(at, ["check", "--fix", "nowhere.scene", "nowhere.layout.json"]);
    assert_eq!(ended.code, 2);
    assert!(!at.join("nowhere.scene").exists());
}

#[cfg(unix)]
#[test]
fn what_cannot_be_written_is_said() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    write(at, &[("sealed/room.scene", "object a;;\nassert a.pos.x > 0;\n")]);
    let sealed = at.join("sealed");
    fs::set_permissions(&sealed, fs::Permissions::from_mode(0o555)).unwrap();
    if fs::write(sealed.join("probe"), "").is_ok() {
        // Whoever may write everywhere cannot see this fail.
        return;
    }
    let ended = scenelang(at, ["check", "--fix", "sealed/room.scene"]);
    fs::set_permissions(&sealed, fs::Permissions::from_mode(0o755)).unwrap();
    assert_eq!(ended.code, 2, "{ended:?}");
    assert!(ended.stderr.contains("cannot write"), "{}", ended.stderr);
    assert_eq!(read(&sealed, "room.scene"), "object a;;\nassert a.pos.x > 0;\n");
}

#[test]
fn later_stages_heed_comments_too() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let scene = "object thing; WHAT\nthing.category <- \"quux\";\nassert thing.pos.x > 0;\n";
    for (what, warned) in [("", true), ("// allow(W0601, W0602): a box will do", false)] {
        write(at, &[("room.scene", &scene.replace("WHAT", what))]);
        let ended = scenelang(at, ["solve", "room.scene"]);
        assert_eq!(ended.code, 0, "{ended:?}");
        assert_eq!(ended.stderr.contains("W0602"), warned, "{}", ended.stderr);
        assert_eq!(ended.stderr.contains("W0601"), warned, "{}", ended.stderr);
    }
    // What is told once for many things is told of those that no comment speaks of.
    let things: String = (0..12).map(|i| format!("object q{i}; WHAT{i}\nq{i}.category <- \"quux {i}\";\n")).collect();
    write(at, &[("room.scene", &things.replace("WHAT0\n", "// allow(W0601, W0602)\n").replace("WHAT", "// "))]);
    let ended = scenelang(at, ["solve", "room.scene"]);
    let told: Vec<&str> = ended.stderr.lines().filter(|line| line.contains("W060")).collect();
    assert_eq!(told.len(), 2, "{}", ended.stderr);
    let kinds = "\"quux 1\", \"quux 2\", \"quux 3\" and 8 more";
    assert!(told.iter().all(|line| line.contains(kinds)), "{}", ended.stderr);
    let wall = r#"{ "format": "scenelang.layout/1",
        "regions": { "room": { "pos": [0, 0, 0], "scale": [4, 2.5, 3] } },
        "objects": { "pipe": { "pos": [2, 0, 0], "scale": [1, 0.1, 0.1] } } }"#;
    for (what, warned) in [("", true), ("// allow(W0503)", false)] {
        let scene = format!("region room;\nobject pipe; {what}\nallowOutside(pipe);\n");
        write(at, &[("room.scene", &scene), ("room.layout.json", wall)]);
        let ended = scenelang(at, ["check", "room.layout.json"]);
        assert_eq!(ended.stdout.contains("W0503"), warned, "{}", ended.stdout);
        assert!(!ended.stdout.contains("W0103"), "{}", ended.stdout);
    }
}

#[test]
fn guesses_are_made_only_where_they_are_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let text = "object fridge;\nfridge.category <- \"refridgerator\";\nassert fridge.pos.y > 0;\n";
    write(at, &[("room.scene", text)]);
    scenelang(at, ["check", "--fix", "room.scene"]);
    assert_eq!(read(at, "room.scene"), text);
    let ended = scenelang(at, ["check", "--unsafe-fixes", "room.scene"]);
    assert_eq!(read(at, "room.scene"), text.replace("refridgerator", "refrigerator"), "{ended:?}");
    assert!(!ended.stdout.contains("W0205"), "{}", ended.stdout);
}

#[test]
fn drawings_of_predicates_are_written() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let ended = scenelang(at, ["explain", "near", "clear", "--drawings", "seen"]);
    assert!(ended.code == 0 && ended.stderr.contains("2 drawings written to seen"), "{ended:?}");
    assert!(ended.stdout.contains("Drawing: lamp is 25 cm from sofa"), "{}", ended.stdout);
    assert_eq!(
        fs::read(at.join("seen/near.svg")).unwrap(),
        fs::read(root().join("spec/src/pictures/near.svg")).unwrap()
    );
    let ended = scenelang(at, ["explain", "E0201", "--drawings", "other"]);
    assert!(
        ended.code == 2 && ended.stderr.contains("no drawing of `E0201`") && !at.join("other").exists(),
        "{ended:?}"
    );
}

#[test]
fn categories_are_listed_and_suggested() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let ended = scenelang(at, ["categories", "fridge"]);
    assert!(ended.code == 0 && ended.stdout.lines().skip(1).any(|l| l.starts_with("fridge ")), "{ended:?}");
    let ended = scenelang(at, ["categories", "fridge", "--format", "json"]);
    let listed: serde_json::Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!(listed["format"], "scenelang.categories/1");
    let rows = listed["categories"].as_array().unwrap();
    assert!(rows.iter().any(|row| row["category"] == "fridge" && row["size"].is_array()), "{listed}");
    let ended = scenelang(at, ["categories", "mini fridge", "--pictures", "seen"]);
    assert!(ended.code == 0 && ended.stderr.contains("1 picture written to seen"), "{ended:?}");
    assert!(fs::read(at.join("seen/mini fridge.png")).unwrap().starts_with(b"\x89PNG"));
    let ended = scenelang(at, ["categories", "refridgerator"]);
    assert!(ended.code != 0 && ended.stderr.contains("refrigerator"), "{ended:?}");
}
