//! `scenelang repair`: the example of the book, what is written and what is not, the exit codes, the examples repaired.

use crate::support::{EXAMPLES, Ended, example, fits, read_json, root, scenelang};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// The program, the layout and part of the answer, as the book shows them.
fn book() -> [String; 3] {
    let page = fs::read_to_string(root().join("spec/src/command-line.md")).unwrap();
    let section = page.split("\n## repair\n").nth(1).unwrap().split("\n## ").next().unwrap();
    let block = |info: &str| {
        let start = format!("```{info}\n");
        section.split(&start).nth(1).unwrap().split("```").next().unwrap().to_owned()
    };
    ["scene", "json layout", "json repair"].map(block)
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let [scene, layout, _] = book();
    fs::write(folder.path().join("room.scene"), scene).unwrap();
    fs::write(folder.path().join("room.layout.json"), layout).unwrap();
    folder
}

fn repair(folder: &Path, args: &[&str]) -> Ended {
    scenelang(folder, ["repair", "room.layout.json"].iter().chain(args))
}

fn text(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap()
}

/// Whether all that `part` says is in `whole`; arrays item by item.
pub fn contains(whole: &Value, part: &Value) -> bool {
    match (whole, part) {
        (Value::Object(whole), Value::Object(part)) => {
            part.iter().all(|(key, value)| whole.get(key).is_some_and(|w| contains(w, value)))
        }
        (Value::Array(whole), Value::Array(part)) => {
            whole.len() == part.len() && whole.iter().zip(part).all(|(w, p)| contains(w, p))
        }
        (Value::Number(a), Value::Number(b)) => a.as_f64() == b.as_f64(),
        _ => whole == part,
    }
}

#[test]
fn the_example_of_the_book_is_as_shown() {
    let folder = folder();
    let ended = repair(folder.path(), &["--dry-run", "--format", "json"]);
    let whole = fits("repair", &ended.stdout);
    assert_eq!((ended.code, &whole["applied"]), (0, &Value::Null));
    assert!(contains(&whole, &serde_json::from_str(&book()[2]).unwrap()), "{whole:#}");
    assert_eq!(repair(folder.path(), &["--dry-run", "--format", "json"]).stdout, ended.stdout, "the same each time");
}

/// What is locked is moved by no repair that is offered, and a name that nothing has is an error.
#[test]
fn what_is_locked_stays() {
    let folder = folder();
    let ways = |args: &[&str]| -> Vec<Value> {
        let all: Vec<&str> = ["--dry-run", "--format", "json"].iter().chain(args).copied().collect();
        let found = fits("repair", &repair(folder.path(), &all).stdout);
        found["alternatives"].as_array().unwrap().clone()
    };
    let moved = |ways: &[Value]| -> Vec<String> {
        let moves = ways.iter().flat_map(|way| way["moves"].as_array().unwrap());
        moves.map(|m| m["object"].as_str().unwrap().to_owned()).collect()
    };
    let free = moved(&ways(&[]));
    let first = free.first().expect("a move").clone();
    let held = ways(&["--lock", "table", "sofa"]);
    assert!(first == "table" && moved(&held).is_empty() && !held.is_empty(), "numbers are still offered: {held:?}");
    let ended = repair(folder.path(), &["--lock", "ghost"]);
    assert_eq!(ended.code, 2);
    assert!(ended.stderr.contains("the program has no object `ghost`"), "{}", ended.stderr);
}

#[test]
fn nothing_is_written_but_what_was_chosen() {
    let [scene, layout, _] = book();
    let folder = folder();
    let here = folder.path();
    let same = |name: &str, old: &str| assert_eq!(text(here, name), old);
    assert_eq!(repair(here, &["--dry-run"]).code, 0);
    same("room.layout.json", &layout);
    // Into another file: the old one stays, and the new one finds its program.
    fs::create_dir(here.join("repaired")).unwrap();
    assert_eq!(repair(here, &["-o", "repaired/new.json"]).code, 0);
    same("room.layout.json", &layout);
    let new = read_json(&here.join("repaired/new.json"));
    assert_eq!((&new["note"], &new["objects"]["table"]["label"]), (&"kept".into(), &"oak".into()));
    // Its program is in another folder, which must be of the same workspace, or be named, too.
    assert!(scenelang(here, ["check", "repaired/new.json"]).stdout.contains("E0009"));
    assert_eq!(scenelang(here, ["check", "repaired/new.json", "room.scene"]).code, 0);
    fs::write(here.join("scenelang.toml"), "").unwrap();
    assert_eq!(scenelang(here, ["check", "repaired/new.json"]).code, 0);
    // A number of the program.
    assert_eq!(repair(here, &["--apply", "2"]).code, 0);
    same("room.layout.json", &layout);
    assert_ne!(text(here, "room.scene"), scene);
    assert_eq!(scenelang(here, ["check", "room.layout.json"]).code, 0);
    assert!(repair(here, &[]).stdout.contains("nothing to repair"));
    // The layout itself.
    fs::write(here.join("room.scene"), &scene).unwrap();
    assert_eq!(repair(here, &[]).code, 0);
    same("room.scene", &scene);
    assert_eq!(scenelang(here, ["check", "room.layout.json"]).code, 0);
    assert_eq!(read_json(&here.join("room.layout.json"))["note"], "kept");
}

#[test]
fn exit_codes_say_whether_it_is_repaired() {
    let [scene, layout, _] = book();
    let line = scene.lines().position(|l| l.contains("gap(table")).unwrap() + 1;
    let line = line.to_string();
    let id = format!("room.scene:{line}:1");
    // Nothing can move: only the program can give way, and that is not done without asking.
    let turned = "table.rot <- rot(0, 0, 0);\nsofa.rot <- rot(0, 0, 0);\n";
    let pinned = format!("{scene}table.pos <- vec3(0, 0, 0);\n{turned}");
    for (scene, layout, args, code) in [
        (scene.as_str(), layout.as_str(), vec!["--dry-run"], 0),
        (&scene, &layout, vec!["--dry-run", "--constraint", &line], 0),
        (&scene, &layout, vec!["--dry-run", "--constraint", &id], 0),
        (&scene, &layout, vec!["--constraint", "P-COLLIDE:lamp:table"], 0),
        (&scene, &layout, vec!["--constraint", "1"], 2),
        (&scene, &layout, vec!["--constraint", "sofa"], 2),
        (&scene, &layout, vec!["--apply", "9"], 2),
        (&pinned, &layout, vec![], 1),
        (&pinned, &layout, vec!["--apply", "1"], 0),
        ("object sofa\n", &layout, vec![], 2),
        (&scene, "{}", vec![], 2),
        (&scene, &layout.replace("\"table\":", "\"tables\":"), vec![], 2),
    ] {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("room.scene"), scene).unwrap();
        fs::write(folder.path().join("room.layout.json"), layout).unwrap();
        let ended = repair(folder.path(), &args);
        assert_eq!(ended.code, code, "{args:?} {}{}", ended.stdout, ended.stderr);
        if code != 0 {
            assert_eq!(text(folder.path(), "room.layout.json"), layout, "{args:?}");
            assert_eq!(text(folder.path(), "room.scene"), scene, "{args:?}");
        }
    }
    let ended = scenelang(&root(), [Path::new("repair"), &example("bedroom")]);
    assert_eq!(ended.code, 2);
}

#[test]
fn examples_with_an_object_displaced_are_repaired() {
    for name in EXAMPLES {
        let folder = tempfile::tempdir().unwrap();
        let scene = folder.path().join("room.scene");
        fs::copy(example(name), &scene).unwrap();
        assert_eq!(scenelang(folder.path(), ["solve", "room.scene"]).code, 0, "{name}");
        let path = folder.path().join("room.layout.json");
        let mut layout = read_json(&path);
        let objects = layout["objects"].as_object_mut().unwrap();
        // Out through the wall, whatever it is.
        let (moved, object) = objects.iter_mut().nth(3).unwrap();
        let moved = moved.clone();
        object["pos"][0] = (object["pos"][0].as_f64().unwrap() + 0.7).into();
        fs::write(&path, layout.to_string()).unwrap();
        let broken = scenelang(folder.path(), ["check", "room.layout.json"]).code;
        let ended = repair(folder.path(), &["--format", "json"]);
        let told = fits("repair", &ended.stdout);
        assert_eq!(ended.code, 0, "{name} {moved}: {told:#}");
        assert_eq!(scenelang(folder.path(), ["check", "room.layout.json"]).code, 0, "{name} {moved}");
        if broken == 1 {
            assert!(told["alternatives"][0]["moves"].as_array().unwrap().len() <= 4, "{name} {moved}: {told:#}");
        }
    }
}
