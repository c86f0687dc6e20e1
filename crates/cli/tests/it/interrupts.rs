//! Ctrl-C, sent to the binary while it solves: the best layout so far is there, whole and marked; a second one ends at
//! once and leaves nothing half-written.
#![cfg(unix)]

use crate::support::{binary, fits, scenelang};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// What the shell sees of an end by Ctrl-C.
const INTERRUPTED: i32 = 130;

/// Four of them cannot all be as far from each other on a floor, which nothing proves; with all the others the search takes
/// long.
const ENDLESS: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(14, 2.5, 14);\nobject lamp[4];\n\
    object crate[122];\nlamp.dimensions <- vec3(0.3, 1.5, 0.3);\ncrate.dimensions <- vec3(0.5, 0.5, 0.5);\n\
    assert forall a in lamp: inside(a, room);\n\
    assert forall a in lamp: forall b in lamp: a != b implies distance(a, b) = 5;\n\
    assert forall i in 0..121: distance(crate[i], crate[i + 1]) <= 4;\n";

fn start(folder: &Path, args: &[&str]) -> Child {
    let mut command = binary();
    command.args(args).current_dir(folder).env("NO_COLOR", "1").stdin(Stdio::null());
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// Presses Ctrl-C; whether there was still somebody to hear it.
fn press(child: &Child) -> bool {
    let signal = Command::new("kill").args(["-INT", &child.id().to_string()]).stderr(Stdio::null()).status();
    signal.unwrap().success()
}

/// Runs and interrupts the solver, later and later until it was at work by then.
fn interrupted(args: &[&str], shown: &str) -> (tempfile::TempDir, Output) {
    for wait in [400, 1_000, 3_000, 10_000] {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("room.scene"), ENDLESS).unwrap();
        let child = start(folder.path(), args);
        sleep(Duration::from_millis(wait));
        assert!(press(&child), "it ended by itself");
        let output = child.wait_with_output().unwrap();
        if output.status.code() == Some(INTERRUPTED) && folder.path().join(shown).exists() {
            return (folder, output);
        }
        // It had not begun, or did not even listen yet: nothing may be there then.
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "{output:?}");
    }
    panic!("no wait was long enough");
}

/// A layout that is whole, has everything in it, and says that it is incomplete.
fn is_incomplete(path: &Path) {
    let layout = fits("layout", &fs::read_to_string(path).unwrap());
    assert_eq!(layout["incomplete"], true);
    assert_eq!(layout["objects"].as_object().unwrap().len(), 126, "nothing is dropped");
}

#[test]
fn solve_writes_what_it_has() {
    let (folder, output) = interrupted(&["solve", "room.scene"], "room.layout.json");
    let told = String::from_utf8(output.stdout).unwrap();
    assert!(told.contains("incomplete because of the interruption"), "{told}");
    let path = folder.path().join("room.layout.json");
    is_incomplete(&path);
    let ended = scenelang(folder.path(), ["check", "room.layout.json", "--format", "json", "--explain", "none"]);
    assert!(ended.code == 1 && ended.reports()[0]["diagnostics"] == Value::Array(Vec::new()), "{}", ended.stdout);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[test]
fn the_mark_goes_when_the_work_is_done() {
    let folder = tempfile::tempdir().unwrap();
    let marked = r#"{ "format": "scenelang.layout/1", "incomplete": true, "note": "kept",
                      "objects": { "box": { "pos": [0, 0, 0], "scale": [1, 1, 1] } } }"#;
    for command in [&["solve", "room.scene", "--layout", "room.layout.json"][..], &["repair", "room.layout.json"]] {
        fs::write(folder.path().join("room.scene"), "object box; assert box.pos.x >= 1;").unwrap();
        fs::write(folder.path().join("room.layout.json"), marked).unwrap();
        let ended = scenelang(folder.path(), command);
        assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
        let layout = fits("layout", &fs::read_to_string(folder.path().join("room.layout.json")).unwrap());
        assert_eq!((&layout["incomplete"], &layout["note"]), (&Value::Null, &"kept".into()), "{command:?}");
    }
}

#[test]
fn json_says_that_it_was_interrupted() {
    let (folder, output) = interrupted(&["solve", "room.scene", "--format", "json"], "room.layout.json");
    let answer = fits("solution", &String::from_utf8(output.stdout).unwrap());
    assert_eq!((&answer["end"], &answer["ok"]), (&"interrupted".into(), &false.into()));
    is_incomplete(&folder.path().join("room.layout.json"));
}

#[test]
fn synth_writes_the_layout_and_no_exports() {
    let (folder, output) = interrupted(&["synth", "room.scene", "-o", "out"], "out/room.layout.json");
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("interrupted before files were exported"), "{said}");
    let out = folder.path().join("out");
    is_incomplete(&out.join("room.layout.json"));
    let mut files: Vec<String> =
        fs::read_dir(&out).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    files.sort();
    assert_eq!(
        files,
        [".scenelang-files.sha256", ".scenelang-manifest.json", "report.json", "room.layout.json", "room.scene"]
    );
    assert_eq!(scenelang(folder.path(), ["check", "out/room.layout.json", "--explain", "none"]).code, 1);
}

#[test]
fn a_second_one_ends_at_once() {
    for between in [0, 5, 40] {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("room.scene"), ENDLESS).unwrap();
        let child = start(folder.path(), &["solve", "room.scene"]);
        sleep(Duration::from_millis(600));
        assert!(press(&child));
        sleep(Duration::from_millis(between));
        press(&child);
        let output = child.wait_with_output().unwrap();
        // Where it does not listen yet, the signal itself ends it.
        assert!(matches!(output.status.code(), Some(INTERRUPTED) | None), "{output:?}");
        let layout = folder.path().join("room.layout.json");
        if layout.exists() {
            is_incomplete(&layout);
        }
    }
}
