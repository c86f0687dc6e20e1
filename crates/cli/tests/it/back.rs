//! Exported scenes that somebody edited: nothing of that is written over without a word, and it can be gone on from.

use crate::carriers::edit_glb;
use crate::support::{Ended, fits, read_json, scenelang};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// The bed may stand anywhere in the room, the stool only where it is.
const ROOM: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(4, 2.6, 4);\n\
    object bed;\nbed.category <- \"bed\";\nbed.dimensions <- vec3(1.6, 0.55, 2);\n\
    object stool;\nstool.category <- \"stool\";\nstool.pos <- vec3(-1.6, 0, -1.6);\n\
    assert inside(bed, room);\nassert inside(stool, room);\n";

pub const SYNTH: [&str; 6] = ["synth", "room.scene", "-o", "out", "--only", "glb,unity"];
const EXPORT: [&str; 6] = ["export", "room.layout.json", "-o", "out", "--only", "glb,unity"];

/// Where the bed is put: it holds there.
const PUT: [f64; 3] = [0.3, 0.0, 0.4];

pub struct Room(tempfile::TempDir);

impl Room {
    /// A program, and what a command makes of it.
    fn made_by(command: &[&str]) -> Self {
        Self::of(ROOM, command)
    }

    /// Another program, and what a command makes of it.
    pub fn of(text: &str, command: &[&str]) -> Self {
        let room = Self(tempfile::tempdir().unwrap());
        fs::write(room.at("room.scene"), text).unwrap();
        if command[0] == "export" {
            room.run(&["solve", "room.scene"], &[], 0);
        }
        room.run(command, &[], 0);
        room
    }

    pub fn at(&self, path: &str) -> PathBuf {
        self.0.path().join(path)
    }

    /// Runs a command that ends so.
    pub fn run(&self, command: &[&str], more: &[&str], code: i32) -> Ended {
        let ended = self.any(command, more);
        assert_eq!(ended.code, code, "{command:?} {more:?}: {}{}", ended.stdout, ended.stderr);
        ended
    }

    /// Runs a command that ends in any way.
    pub fn any(&self, command: &[&str], more: &[&str]) -> Ended {
        scenelang(self.0.path(), command.iter().chain(more))
    }

    /// All files.
    pub fn files(&self) -> BTreeMap<PathBuf, Vec<u8>> {
        let mut found = BTreeMap::new();
        let mut folders = vec![self.0.path().to_path_buf()];
        while let Some(folder) = folders.pop() {
            for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
                if path.is_dir() {
                    folders.push(path);
                } else {
                    found.insert(path.clone(), fs::read(path).unwrap());
                }
            }
        }
        found
    }

    /// Puts a thing somewhere in one of the exported scenes.
    pub fn put(&self, carrier: &str, name: &str, [x, y, z]: [f64; 3]) {
        if carrier == "glb" {
            return edit_glb(&self.at("out/room.glb"), |document| {
                node(document, name)["translation"] = json!([-x, y, z]);
            });
        }
        let path = self.at("out/unity/Assets/Scenes/room.unity");
        let mut text = fs::read_to_string(&path).unwrap();
        let named = |quote: &str| format!("propertyPath: m_Name\n      value: {quote}{name}{quote}\n");
        if let Some(at) = text.find(&named("")).or_else(|| text.find(&named("\""))) {
            // An instance of a prefab: its place is a change for each axis.
            let begin = text[..at].rfind("--- !u!1001 ").unwrap();
            for (axis, value) in [("x", x), ("y", y), ("z", z)] {
                let change = format!("propertyPath: m_LocalPosition.{axis}\n      value: ");
                let from = begin + text[begin..].find(&change).unwrap() + change.len();
                let to = from + text[from..].find('\n').unwrap();
                text.replace_range(from..to, &value.to_string());
            }
            return fs::write(&path, text).unwrap();
        }
        let at = text.find(&format!("m_Name: {name}\n")).unwrap();
        let begin = at + text[at..].find("m_LocalPosition:").unwrap();
        let end = begin + text[begin..].find('\n').unwrap();
        let line = format!("m_LocalPosition: {{x: {x}, y: {y}, z: {z}}}");
        fs::write(&path, format!("{}{line}{}", &text[..begin], &text[end..])).unwrap();
    }

    /// Whether a thing of a layout is there.
    fn stands(&self, layout: &str, name: &str, pos: [f64; 3]) -> bool {
        let found = &read_json(&self.at(layout))["objects"][name]["pos"];
        (0..3).all(|k| (found[k].as_f64().unwrap() - pos[k]).abs() < 1e-5)
    }

    /// Whether layout and exported scenes say the same.
    fn agrees(&self, layout: &str) {
        for carrier in ["out/room.glb", "out/unity"] {
            self.run(&["diff", layout, carrier], &[], 0);
        }
    }
}

fn node<'d>(document: &'d mut Value, name: &str) -> &'d mut Value {
    document["nodes"].as_array_mut().unwrap().iter_mut().find(|node| node["name"] == name).unwrap()
}

/// Takes a thing out of the GLB file.
fn remove(path: &Path, name: &str) {
    edit_glb(path, |document| {
        let index = document["nodes"].as_array().unwrap().iter().position(|node| node["name"] == name).unwrap();
        document["scenes"][0]["nodes"].as_array_mut().unwrap().retain(|node| *node != json!(index));
    });
}

#[test]
fn nothing_is_written_over_an_edited_scene() {
    for command in [SYNTH, EXPORT] {
        for carrier in ["glb", "unity"] {
            let room = Room::made_by(&command);
            let made = room.files();
            room.put(carrier, "bed", PUT);
            let edited = room.files();
            assert_ne!(made, edited);
            let ended = room.run(&command, &[], 2);
            for part in ["has been edited since scenelang wrote it", "`bed` was moved by", "--take", "--overwrite"] {
                assert!(ended.stderr.contains(part), "{part}: {ended:?}");
            }
            assert!(room.files() == edited, "{command:?} {carrier}");
            // The user says so, and hears what is lost.
            let ended = room.run(&command, &["--overwrite"], 0);
            assert!(ended.stderr.contains("writing over") && ended.stderr.contains("`bed` was moved"), "{ended:?}");
            assert!(room.files() == made, "{command:?} {carrier}");
            assert_eq!(room.run(&command, &[], 0).stderr, "");
            room.put(carrier, "bed", PUT);
            let ended = room.run(&command, &["--force"], 0);
            assert!(ended.stderr.contains("`bed` was moved"), "{ended:?}");
            assert!(room.files() == made, "{command:?} {carrier}");
        }
    }
}

#[test]
fn synth_goes_on_from_an_edited_scene() {
    for carrier in ["glb", "unity"] {
        let room = Room::made_by(&SYNTH);
        room.put(carrier, "bed", PUT);
        let ended = room.run(&SYNTH, &["--take", "--format", "json"], 0);
        let told: Value = serde_json::from_str(&ended.stdout).unwrap();
        assert!(told["taken"]["from"].as_str().unwrap().contains(carrier), "{told:#}");
        assert!(told["taken"]["changes"][0].as_str().unwrap().starts_with("`bed` was moved by"), "{told:#}");
        assert_eq!(told["taken"]["moved"], json!([]), "{told:#}");
        assert!(room.stands("out/room.layout.json", "bed", PUT), "{carrier}");
        room.agrees("out/room.layout.json");
        // Nobody has edited anything now; what stands there stays.
        room.run(&SYNTH, &["--take"], 0);
        assert!(room.stands("out/room.layout.json", "bed", PUT), "{carrier}");
        room.run(&SYNTH, &[], 0);
    }
}

#[test]
fn only_what_must_move_moves() {
    let room = Room::made_by(&SYNTH);
    let before = read_json(&room.at("out/room.layout.json"))["objects"]["bed"]["pos"].clone();
    let before = [0, 1, 2].map(|k| before[k].as_f64().unwrap());
    room.put("glb", "stool", [-1.0, 0.0, -1.0]);
    let ended = room.run(&SYNTH, &["--take"], 0);
    assert!(ended.stderr.contains("so that everything holds: `stool` was moved by"), "{ended:?}");
    assert!(room.stands("out/room.layout.json", "stool", [-1.6, 0.0, -1.6]));
    assert!(room.stands("out/room.layout.json", "bed", before));
}

#[test]
fn what_was_removed_or_added_is_told() {
    let room = Room::made_by(&SYNTH);
    remove(&room.at("out/room.glb"), "bed");
    edit_glb(&room.at("out/room.glb"), |document| {
        let mut sofa = node(document, "stool").clone();
        sofa["name"] = "sofa".into();
        sofa.as_object_mut().unwrap().remove("extras");
        let nodes = document["nodes"].as_array_mut().unwrap();
        let index = nodes.len();
        nodes.push(sofa);
        document["scenes"][0]["nodes"].as_array_mut().unwrap().push(index.into());
    });
    let ended = room.run(&SYNTH, &[], 2);
    for part in ["`bed` was removed from the scene", "`sofa` was added"] {
        assert!(ended.stderr.contains(part), "{part}: {ended:?}");
    }
    let ended = room.run(&SYNTH, &["--take"], 0);
    for part in ["`bed` was removed from the scene", "`sofa` was added", "so that everything holds: `bed` was added"] {
        assert!(ended.stderr.contains(part), "{part}: {ended:?}");
    }
    assert!(read_json(&room.at("out/room.layout.json"))["objects"]["bed"].is_object());
    // A layout as it is can leave nothing out that the program has.
    let room = Room::made_by(&EXPORT);
    remove(&room.at("out/room.glb"), "bed");
    let edited = room.files();
    let ended = room.run(&EXPORT, &["--take"], 2);
    assert!(ended.stderr.contains("object missing from the layout: `bed`"), "{ended:?}");
    assert!(room.files() == edited);
}

/// The bytes are others, the scene is the same.
#[test]
fn a_file_that_another_program_has_saved_is_not_ours_any_more() {
    let room = Room::made_by(&SYNTH);
    let made = room.files();
    let save = || edit_glb(&room.at("out/room.glb"), |document| document["asset"]["generator"] = "another".into());
    save();
    let ended = room.run(&SYNTH, &[], 2);
    assert!(ended.stderr.contains("another program has saved it; nothing was moved"), "{ended:?}");
    room.run(&SYNTH, &["--overwrite"], 0);
    assert!(room.files() == made);
    save();
    fs::copy(room.at("out/room.layout.json"), room.at("before.layout.json")).unwrap();
    room.run(&SYNTH, &["--take"], 0);
    room.run(&["diff", "before.layout.json", "out/room.layout.json"], &[], 0);
    // Nothing is left in it to be taken.
    edit_glb(&room.at("out/room.glb"), |document| document["scenes"][0]["extras"] = Value::Null);
    for more in [&[][..], &["--take"]] {
        let ended = room.run(&SYNTH, more, 2);
        assert!(ended.stderr.contains("so its edits cannot be used"), "{ended:?}");
        assert!(ended.stderr.contains("--overwrite"), "{ended:?}");
    }
    room.run(&SYNTH, &["--overwrite"], 0);
}

/// A Unity project whose scene is none of ours any more: where things stand in it is not known, so nothing is taken from it.
#[test]
fn what_cannot_be_read_of_a_project_is_not_taken_and_not_lost() {
    let room = Room::made_by(&SYNTH);
    let made = room.files();
    let scene = room.at("out/unity/Assets/Scenes/room.unity");
    let text = fs::read_to_string(&scene).unwrap();
    fs::write(&scene, text.replace("layoutSha256", "sum")).unwrap();
    let edited = room.files();
    for more in [&[][..], &["--take"]] {
        let ended = room.run(&SYNTH, more, 2);
        assert!(ended.stderr.contains("so its edits cannot be used"), "{ended:?}");
        assert!(room.files() == edited);
    }
    let ended = room.run(&["check", "out/unity"], &[], 0);
    assert!(ended.stdout.contains("W0504") && ended.stdout.contains("the embedded layout is checked"), "{ended:?}");
    room.run(&SYNTH, &["--overwrite"], 0);
    assert!(room.files() == made);
}

#[test]
fn of_two_scenes_that_differ_none_is_taken() {
    let room = Room::made_by(&SYNTH);
    room.put("glb", "bed", PUT);
    room.put("unity", "bed", [-0.3, 0.0, 0.4]);
    let edited = room.files();
    let ended = room.run(&SYNTH, &["--take"], 2);
    assert!(ended.stderr.contains("out/room.glb and out/unity were both edited"), "{ended:?}");
    assert!(room.files() == edited);
    // The same edit in both is one.
    room.put("unity", "bed", PUT);
    room.run(&SYNTH, &["--take"], 0);
    assert!(room.stands("out/room.layout.json", "bed", PUT));
}

#[test]
fn export_takes_an_edit_into_its_layout() {
    for carrier in ["glb", "unity"] {
        let room = Room::made_by(&EXPORT);
        room.put(carrier, "bed", PUT);
        let ended = room.run(&EXPORT, &["--take", "--format", "json"], 0);
        let told: Value = serde_json::from_str(&ended.stdout).unwrap();
        assert_eq!(told["files"][0], "room.layout.json", "{told:#}");
        assert!(told["taken"]["changes"][0].as_str().unwrap().starts_with("`bed` was moved by"), "{told:#}");
        assert!(room.stands("room.layout.json", "bed", PUT), "{carrier}");
        room.agrees("room.layout.json");
        // Both are ours again.
        let made = room.files();
        assert_eq!(room.run(&EXPORT, &[], 0).stderr, "");
        assert!(room.files() == made);
        room.run(&["solve", "room.scene"], &[], 0);
    }
}

#[test]
fn a_layout_that_is_somebody_elses_takes_nothing_unasked() {
    let room = Room::made_by(&EXPORT);
    let layout = room.at("room.layout.json");
    let text = fs::read_to_string(&layout).unwrap();
    fs::write(&layout, text.replacen("\"scene\":", "\"note\": \"mine\",\n  \"scene\":", 1)).unwrap();
    room.put("glb", "bed", PUT);
    let edited = room.files();
    let ended = room.run(&EXPORT, &["--take"], 2);
    assert!(ended.stderr.contains("use --force to write to it"), "{ended:?}");
    assert!(room.files() == edited);
    room.run(&EXPORT, &["--take", "--force"], 0);
    assert!(room.stands("room.layout.json", "bed", PUT));
    assert_eq!(read_json(&layout)["note"], "mine");
    // What stands elsewhere in the layout by now is not known to the scene.
    room.put("glb", "bed", [-0.3, 0.0, 0.4]);
    room.run(&["solve", "room.scene", "--seed", "3"], &["--force"], 0);
    let ended = room.run(&EXPORT, &["--take"], 2);
    assert!(ended.stderr.contains("is no longer the layout"), "{ended:?}");
}

#[test]
fn what_is_not_written_over_is_in_nobodys_way() {
    let room = Room::made_by(&SYNTH);
    room.put("glb", "bed", PUT);
    let glb = fs::read(room.at("out/room.glb")).unwrap();
    room.run(&["export", "out/room.layout.json", "-o", "out", "--only", "plan"], &[], 0);
    assert_eq!(fs::read(room.at("out/room.glb")).unwrap(), glb);
    // Files beside the scene of a Unity project are lost with it, and that is said.
    let room = Room::made_by(&SYNTH);
    let settings = room.at("out/unity/ProjectSettings/ProjectVersion.txt");
    fs::write(&settings, "m_EditorVersion: 6000.0.0f1\n").unwrap();
    let ended = room.run(&SYNTH, &[], 2);
    assert!(ended.stderr.contains("`ProjectSettings/ProjectVersion.txt` was edited as well"), "{ended:?}");
    // A file that is no part of a scene is the user's, as ever.
    let room = Room::made_by(&SYNTH);
    let report = room.at("out/report.json");
    fs::write(&report, "{}").unwrap();
    room.put("glb", "bed", PUT);
    for more in ["--take", "--overwrite"] {
        let ended = room.run(&SYNTH, &[more], 2);
        assert!(ended.stderr.contains("report.json has been edited since scenelang wrote it"), "{ended:?}");
    }
}

/// Two stools that are instances of one prefab.
const STOOLS: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(4, 2.6, 4);\n\
    object stool[2];\nstool.category <- \"stool\";\nassert inside(stool[0], room) and inside(stool[1], room);\n";

#[test]
fn an_edited_instance_of_a_prefab_is_an_edited_object() {
    let put = [1.25, 0.0, -1.25];
    let room = Room::of(STOOLS, &SYNTH);
    let scene = fs::read_to_string(room.at("out/unity/Assets/Scenes/room.unity")).unwrap();
    assert_eq!(scene.matches("--- !u!1001 ").count(), 2);
    room.run(&["check", "out/unity"], &[], 0);
    let other = read_json(&room.at("out/room.layout.json"))["objects"]["stool[0]"].clone();
    room.put("unity", "stool[1]", put);
    let ended = room.run(&["check", "out/unity"], &[], 0);
    assert!(ended.stdout.contains("`stool[1]` was moved by") && !ended.stdout.contains("`stool[0]` was"), "{ended:?}");
    let ended = room.run(&["query", "out/unity", "--object", "stool[1]", "--format", "json"], &[], 0);
    let pose = &fits("query", &ended.stdout)["objects"][0]["pose"];
    assert!((0..3).all(|k| (pose["pos"][k].as_f64().unwrap() - put[k]).abs() < 1e-5), "{pose:#}");
    room.run(&["import", "out/unity", "-o", "in"], &[], 0);
    assert!(room.stands("in/room.layout.json", "stool[1]", put));
    let edited = room.files();
    let ended = room.run(&SYNTH, &[], 2);
    assert!(ended.stderr.contains("`stool[1]` was moved by"), "{ended:?}");
    assert!(room.files() == edited);
    room.run(&SYNTH, &["--take"], 0);
    assert!(room.stands("out/room.layout.json", "stool[1]", put));
    assert_eq!(read_json(&room.at("out/room.layout.json"))["objects"]["stool[0]"], other);
    room.agrees("out/room.layout.json");
}

#[test]
fn a_query_sees_the_scene_as_it_stands_now() {
    let room = Room::made_by(&SYNTH);
    room.put("glb", "bed", PUT);
    let ended = room.run(&["query", "out/room.glb", "--object", "bed", "--format", "json"], &[], 0);
    let found = fits("query", &ended.stdout);
    let bed = &found["objects"][0];
    assert!((0..3).all(|k| (bed["pose"]["pos"][k].as_f64().unwrap() - PUT[k]).abs() < 1e-5), "{bed:#}");
    assert!(ended.stderr.contains("`bed` was moved by"), "{ended:?}");
    let ended = room.run(&["query", "out/unity"], &[], 0);
    assert!(ended.stdout.contains("stool"), "{ended:?}");
}
