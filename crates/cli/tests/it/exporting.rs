//! `export`, and which formats it and `synth` write.

use crate::support::{Ended, binary, folder_of, python, run, scenelang, skip};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// A rug that a bed stands on by permission, and a lamp that hangs in the air if it says so.
const ROOM: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(4, 2.6, 4);\n\
    object bed;\nbed.category <- \"bed\";\nbed.dimensions <- vec3(1.6, 0.55, 2);\n\
    object rug;\nrug.category <- \"rug\";\nrug.dimensions <- vec3(2, 0.01, 2);\n\
    allowCollide(bed, rug);\nassert bed.pos = vec3(0, 0, 0);\nassert rug.pos = vec3(0.2, 0, 0);\n";

/// A folder with the room and its layout.
fn solved() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.scene"), ROOM).unwrap();
    let ended = scenelang(folder.path(), ["solve", "room.scene"]);
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    folder
}

fn export(folder: &Path, more: &[&str]) -> Ended {
    scenelang(folder, ["export", "room.layout.json", "-o", "out"].iter().chain(more))
}

/// Files and folders directly in the output folder.
fn written(folder: &Path) -> BTreeSet<String> {
    let names = fs::read_dir(folder.join("out")).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
    names.filter(|name| !name.starts_with('.')).collect()
}

#[test]
fn only_the_usual_formats_are_written_unless_others_are_asked_for() {
    let folder = solved();
    assert_eq!(export(folder.path(), &[]).code, 0);
    let usual = ["picture.png", "plan.png", "plan.svg", "preview.html", "room.glb", "unity"].map(str::to_owned);
    assert_eq!(written(folder.path()), BTreeSet::from(usual.clone()));
    let further =
        ["obj", "report.html", "room.mjcf.json", "room.mjcf.xml", "room.usda", "room.usdz", "sdf", "textures"]
            .map(str::to_owned);
    assert_eq!(export(folder.path(), &["--all-formats"]).code, 0);
    assert_eq!(written(folder.path()), usual.into_iter().chain(further).collect());
    let ended = scenelang(folder.path(), ["synth", "room.scene", "-o", "some", "--only", "mjcf", "--format", "json"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let told: Value = serde_json::from_str(&ended.stdout).unwrap();
    let files: BTreeSet<&str> = told["files"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
    let own = ["some/report.json", "some/room.layout.json", "some/room.scene"];
    assert_eq!(files, own.into_iter().chain(["some/room.mjcf.json", "some/room.mjcf.xml"]).collect());
    assert_eq!(told["lost"][0]["what"], "meshes");
}

#[test]
fn a_unity_project_is_for_the_version_that_is_asked_for() {
    let folder = solved();
    let version = |out: &str| {
        fs::read_to_string(folder.path().join(out).join("unity/ProjectSettings/ProjectVersion.txt")).unwrap()
    };
    assert_eq!(export(folder.path(), &["--only", "unity"]).code, 0);
    assert!(version("out").starts_with("m_EditorVersion: 2022.3."));
    assert_eq!(export(folder.path(), &["--only", "unity", "--unity", "6000"]).code, 0);
    assert!(version("out").starts_with("m_EditorVersion: 6000.0."));
    let ended = scenelang(folder.path(), ["synth", "room.scene", "-o", "made", "--only", "unity", "--unity", "6000"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    assert!(version("made").starts_with("m_EditorVersion: 6000.0."));
    assert_eq!(export(folder.path(), &["--unity", "5"]).code, 2);
}

/// Width and height of a PNG file, as its header has them.
fn png_size(bytes: &[u8]) -> [u32; 2] {
    [16, 20].map(|at| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap()))
}

#[test]
fn the_picture_has_the_view_and_the_size_that_are_asked_for() {
    let folder = solved();
    let picture = |more: &[&str]| {
        let ended = export(folder.path(), &[&["--only", "picture"], more].concat());
        assert_eq!(ended.code, 0, "{}", ended.stderr);
        fs::read(folder.path().join("out/picture.png")).unwrap()
    };
    let usual = picture(&[]);
    assert_eq!(png_size(&usual), [1280, 800]);
    assert!(usual == picture(&["--view", "iso", "--size", "1280x800"]));
    let views = ["iso", "top", "eye"].map(|view| picture(&["--view", view, "--size", "320x200"]));
    assert!(views.iter().all(|png| png_size(png) == [320, 200]));
    assert_eq!(views.iter().collect::<BTreeSet<_>>().len(), 3);
    assert!(views[2] == picture(&["--view", "eye", "--size", "320x200"]));
    let made = ["synth", "room.scene", "-o", "made", "--only", "picture", "--view", "eye", "--size", "16x4096"];
    assert_eq!(scenelang(folder.path(), made).code, 0);
    assert_eq!(png_size(&fs::read(folder.path().join("made/picture.png")).unwrap()), [16, 4096]);
}

#[test]
fn views_and_sizes_that_do_not_exist_are_refused() {
    let folder = solved();
    for (more, why) in [
        (["--view", "front"], "[possible values: eye, top, iso]"),
        (["--size", "800"], "expected width and height in pixels, such as 1280x800"),
        (["--size", "-1x800"], "expected width and height in pixels"),
        (["--size", "1280x800x3"], "expected width and height in pixels"),
        (["--size", "0x800"], "each side must be from 16 to 4096 pixels"),
        (["--size", "99999999999999999999999x800"], "each side must be from 16 to 4096 pixels"),
        (["--size", "4096x4096"], "a picture may have at most 8294400 pixels, as 3840x2160 has"),
    ] {
        let ended = export(folder.path(), &more);
        assert_eq!(ended.code, 2, "{more:?}");
        assert!(ended.stderr.contains(why), "{more:?}: {}", ended.stderr);
        assert!(!folder.path().join("out").exists());
    }
}

#[test]
fn what_a_format_cannot_hold_is_said() {
    let folder = solved();
    let ended = export(folder.path(), &["--only", "usd,sdf"]);
    let pair = "note: sdf: permissions to overlap are lost: bed and rug may be pushed apart";
    assert!(ended.stderr.contains(pair), "{}", ended.stderr);
    assert!(!ended.stderr.contains("usd:"), "{}", ended.stderr);
    let ended = export(folder.path(), &["--only", "usd,sdf", "--format", "json"]);
    let told: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!((&told["format"], &told["ok"]), (&"scenelang.export/1".into(), &true.into()));
    let lost: Vec<&str> = told["lost"].as_array().unwrap().iter().filter_map(|l| l["what"].as_str()).collect();
    assert_eq!(lost, ["overlaps", "program"]);
    assert!(told["files"].as_array().unwrap().contains(&"out/room.usda".into()));
}

#[test]
fn a_name_that_is_no_format_is_refused_and_the_formats_are_listed() {
    let folder = solved();
    let ended = export(folder.path(), &["--only", "fbx"]);
    assert_eq!(ended.code, 2);
    for name in ["unity", "glb", "plan", "picture", "preview", "mjcf", "usd", "usdz", "sdf", "obj", "report"] {
        assert!(ended.stderr.contains(name), "{name}: {}", ended.stderr);
    }
    assert_eq!(export(folder.path(), &["--only", "usd", "--all-formats"]).code, 2);
}

#[test]
fn two_runs_write_the_same_bytes() {
    let folder = solved();
    let formats = ["--only", "mjcf,usd,usdz,sdf,obj"];
    let sums = || {
        assert_eq!(export(folder.path(), &formats).code, 0);
        fs::read_to_string(folder.path().join("out/.scenelang-files.sha256")).unwrap()
    };
    let first = sums();
    fs::remove_dir_all(folder.path().join("out")).unwrap();
    assert_eq!(sums(), first);
}

#[test]
fn a_trial_says_what_overlaps_and_what_moves() {
    let Some(python) = python() else { return skip("no trial: no .venv") };
    let folder = solved();
    let tried = |args: &[&str]| {
        let command = &mut binary();
        command.args(["export", "room.layout.json", "-o", "out", "--force", "--only", "mjcf", "--try"]).args(args);
        run(command.env("SCENELANG_PYTHON", &python).current_dir(folder.path()), b"")
    };
    // What is imported is not what lies around.
    fs::write(folder.path().join("mujoco.py"), "raise SystemExit(9)").unwrap();
    let ended = tried(&[]);
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    assert!(ended.stdout.contains("nothing overlaps by more than 2 mm"), "{}", ended.stdout);
    let told: Value = serde_json::from_str(&tried(&["--format", "json"]).stdout).unwrap();
    assert_eq!(told["trial"]["ok"], true, "{told}");
    // Lifted by hand, it falls.
    let path = folder.path().join("room.layout.json");
    let mut layout: Value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
    layout["objects"]["bed"]["pos"][1] = 0.2.into();
    fs::write(&path, layout.to_string()).unwrap();
    let ended = tried(&[]);
    assert_eq!(ended.code, 1, "{}{}", ended.stdout, ended.stderr);
    assert!(ended.stdout.contains("bed moves by "), "{}", ended.stdout);
}

/// What is lifted against its weight is driven as far as what is pulled.
#[test]
fn lids_and_doors_are_driven_as_far_as_they_go() {
    let Some(python) = python() else { return skip("nothing driven: no .venv") };
    let program = "region room;\nroom.scale <- vec3(3, 2.6, 3);\nobject toilet; toilet.category <- \"toilet\";\n\
                   object stove; stove.category <- \"gas stove\";\nassert againstWall(toilet, room) and againstWall(stove, room);\n\
                   assert gap(toilet, stove) >= 1;\nassert clear(toilet, front, 0.6) and clear(stove, front, 0.8);\n";
    let folder = folder_of(&[("room.scene", program)]);
    let ended = scenelang(folder.path(), ["synth", "room.scene", "-o", "out", "--only", "mjcf"]);
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    let command = &mut binary();
    command.args(["export", "out/room.layout.json", "-o", "tried", "--only", "mjcf", "--try", "--format", "json"]);
    let ended = run(command.env("SCENELANG_PYTHON", &python).current_dir(folder.path()), b"");
    let told: Value = serde_json::from_str(&ended.stdout).unwrap();
    let joints = told["trial"]["joints"].as_array().unwrap();
    assert!(joints.len() >= 2, "{told}");
    for joint in joints {
        let [reach, limit] = ["reach", "limit"].map(|key| joint[key].as_f64().unwrap());
        let least = if joint["motion"] == "hinge" { 1.0 } else { 0.005 };
        assert!(limit - reach <= least, "{joint}");
    }
}

#[test]
fn a_trial_without_an_engine_says_what_is_missing_and_the_files_are_written() {
    let folder = solved();
    let command = &mut binary();
    command.args(["export", "room.layout.json", "-o", "out", "--only", "usd", "--try"]);
    let ended = run(command.env("SCENELANG_PYTHON", "no-such-python").current_dir(folder.path()), b"");
    assert_eq!(ended.code, 2);
    assert!(ended.stderr.contains("--try needs Python with the package `mujoco`"), "{}", ended.stderr);
    assert!(written(folder.path()).contains("room.mjcf.xml"));
}
