//! Output folders that are made again: only what an edit touches is, what no longer belongs is removed, and whoever was ended in
//! between is gone on with. Work is counted, never timed.

use crate::support::{Ended, example, read_json, scenelang};
use scenelang_base::door::Door;
use scenelang_base::owned::{Change, Steps, sum_of};
use scenelang_export::OutFile;
use scenelang_export::glb::Glb;
use scenelang_export::unity::Unity;
use scenelang_synth::rebuild::{Known, Manifest, State, own_names, planned, sum};
use scenelang_synth::{Hold, LayoutRequest, Observer, Stage, own_files, program_files, scene, solve};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// The stool stands before the desk, the plant anywhere.
const ROOM: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(5, 2.6, 4);\n\
    object desk;\ndesk.category <- \"desk\";\ndesk.color <- \"white\";\nassert againstWall(desk, room);\n\
    object stool;\nstool.category <- \"stool\";\nstool.color <- \"red\";\n\
    assert inFrontOf(stool, desk) and gap(stool, desk) >= 0.2 and gap(stool, desk) <= 0.3;\n\
    object plant;\nplant.category <- \"plant\";\nassert inside(plant, room);\n";

struct Folder(tempfile::TempDir);

/// A file's bytes, and when it was written.
type Files = BTreeMap<String, (Vec<u8>, SystemTime)>;

impl Folder {
    /// A program and what comes of it.
    fn made(text: &str, more: &[&str]) -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        folder.program(text);
        folder.synth(more);
        folder
    }

    fn at(&self, path: &str) -> PathBuf {
        self.0.path().join(path)
    }

    fn program(&self, text: &str) {
        fs::write(self.at("room.scene"), text).unwrap();
    }

    fn run(&self, more: &[&str]) -> Ended {
        scenelang(self.0.path(), ["synth", "room.scene", "-o", "out", "--only", "glb,unity"].iter().chain(more))
    }

    fn synth(&self, more: &[&str]) -> Ended {
        let ended = self.run(more);
        assert_eq!(ended.code, 0, "{more:?}: {}{}", ended.stdout, ended.stderr);
        ended
    }

    /// What is said of the rebuild.
    fn told(&self, more: &[&str]) -> Value {
        let ended = self.synth(&[&["--explain-rebuild", "--format", "json"], more].concat());
        let mut summary: Value = serde_json::from_str(&ended.stdout).unwrap();
        summary["rebuild"].take()
    }

    /// All files of the output folder.
    fn files(&self) -> Files {
        let root = self.at("out");
        let mut found = Files::new();
        let mut folders = vec![root.clone()];
        while let Some(folder) = folders.pop() {
            for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
                if path.is_dir() {
                    folders.push(path);
                } else {
                    let name = path.strip_prefix(&root).unwrap().to_string_lossy().replace('\\', "/");
                    let at = fs::metadata(&path).unwrap().modified().unwrap();
                    found.insert(name, (fs::read(&path).unwrap(), at));
                }
            }
        }
        found
    }

    fn restore(&self, files: &Files) {
        fs::remove_dir_all(self.at("out")).unwrap();
        fs::create_dir(self.at("out")).unwrap();
        for (name, (bytes, _)) in files {
            let path = self.at("out").join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, bytes).unwrap();
        }
    }
}

fn bytes(files: &Files) -> BTreeMap<&str, &[u8]> {
    files.iter().map(|(name, (bytes, _))| (name.as_str(), bytes.as_slice())).collect()
}

/// Files of which nothing was touched, not even the time at which they were written, are left out; so are the two of our own.
fn touched(before: &Files, after: &Files) -> BTreeSet<String> {
    let names: BTreeSet<&String> = before.keys().chain(after.keys()).collect();
    let differs = |name: &&String| before.get(*name) != after.get(*name) && !name.starts_with(".scenelang-");
    names.into_iter().filter(differs).cloned().collect()
}

/// Whether the list of the folder has exactly the files that are there.
fn has_no_orphans(files: &Files) {
    let list = String::from_utf8(files[".scenelang-files.sha256"].0.clone()).unwrap();
    let listed: BTreeSet<&str> = list.lines().map(|line| line.split_once("  ").unwrap().1).collect();
    let there: BTreeSet<&str> =
        files.keys().map(String::as_str).filter(|name| !name.starts_with(".scenelang-")).collect();
    assert_eq!(listed, there);
}

#[test]
fn one_colour_of_forty_objects_makes_one_asset_again() {
    let text = fs::read_to_string(example("restaurant")).unwrap();
    let painted = |color: &str| format!("{text}\nbackShelf.color <- \"{color}\";\n");
    let folder = Folder::made(&painted("white"), &[]);
    let before = folder.files();
    folder.program(&painted("navy"));
    let told = folder.told(&[]);
    let after = folder.files();
    assert_eq!(
        told["assets"],
        json!({ "objects": 40, "made": { "backShelf": ["color has changed from \"white\" to \"navy\""] } })
    );
    assert_eq!(told["layout"], json!({ "made": false, "why": [] }));
    let why = json!(["`backShelf` looks different", "the text of the program has changed"]);
    assert_eq!(told["export"]["unity"], json!({ "made": true, "why": why }));
    let touched = touched(&before, &after);
    let materials = touched.iter().filter(|name| name.contains("/Materials/")).count();
    let others: Vec<&str> = touched.iter().map(String::as_str).filter(|name| !name.contains("/Materials/")).collect();
    let wanted = [
        "room.glb",
        "room.scene",
        "unity/Assets/Scenelang/Meshes/Objects/backShelf.obj",
        "unity/Assets/Scenelang/spec.scene.txt",
        "unity/Assets/Scenes/room.unity",
    ];
    assert!(
        others
            .iter()
            .all(|name| wanted.contains(name) || name.starts_with("unity/Assets/Scenelang/Meshes/Objects/backShelf."))
    );
    assert!(wanted.iter().all(|name| others.contains(name)), "{others:?}");
    // Those of the new colour, and those of the old one.
    assert!(materials >= 4, "{touched:?}");
    assert!(told["removed"].as_array().unwrap().len() >= 2, "{told}");
    has_no_orphans(&after);
    // As if it had been made at once.
    let fresh = Folder::made(&painted("navy"), &[]);
    let (mut fresh, mut after) = (fresh.files(), after);
    fresh.remove(".scenelang-manifest.json");
    after.remove(".scenelang-manifest.json");
    assert!(bytes(&fresh) == bytes(&after));
}

#[test]
fn a_second_run_touches_nothing() {
    let folder = Folder::made(ROOM, &[]);
    let before = folder.files();
    let told = folder.told(&[]);
    assert_eq!(before, folder.files(), "not even our own files");
    let kept = json!({ "made": false, "why": [] });
    assert_eq!(
        told,
        json!({
            "program": kept, "assets": { "objects": 3, "made": {} }, "layout": kept, "export": { "glb": kept, "unity": kept },
            "written": [], "removed": [], "kept": [],
        })
    );
}

/// Six stools in a row, each of its own colour.
fn stools(colors: [&str; 6]) -> String {
    let mut text = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(8, 2.6, 4);\nobject stool[6];\n\
        stool.category <- \"stool\";\nassert forall s in stool: inside(s, room);\n"
        .to_owned();
    for (i, color) in colors.iter().enumerate() {
        text += &format!("stool[{i}].pos <- vec3({}, 0, 0);\nstool[{i}].color <- \"{color}\";\n", i as i32 - 2);
    }
    text
}

#[test]
fn one_of_six_equal_objects_is_painted_and_the_prefab_of_the_others_is_not_touched() {
    let folder = Folder::made(&stools(["white"; 6]), &[]);
    let before = folder.files();
    let of = |files: &Files, what: &str| -> Vec<String> {
        files.keys().filter(|name| name.contains(what) && !name.ends_with(".meta")).cloned().collect()
    };
    assert_eq!(of(&before, "/Prefabs/").len(), 1, "{:?}", of(&before, "/Prefabs/"));
    let mut colors = ["white"; 6];
    colors[2] = "navy";
    folder.program(&stools(colors));
    let told = folder.told(&[]);
    let after = folder.files();
    assert_eq!(told["assets"]["made"], json!({ "stool[2]": ["color has changed from \"white\" to \"navy\""] }));
    assert_eq!(told["removed"], json!([]));
    let is_own = |name: &String| {
        ["room.glb", "room.scene", "unity/Assets/Scenelang/spec.scene.txt", "unity/Assets/Scenes/room.unity"]
            .contains(&name.as_str())
            || name.contains("/Meshes/Objects/stool_2.")
            || name.contains("/Materials/")
    };
    let touched = touched(&before, &after);
    assert!(touched.iter().all(is_own), "{touched:?}");
    assert_eq!(
        touched.iter().filter(|name| name.contains("/Materials/")).count(),
        2,
        "a material and its .meta: {touched:?}"
    );
    has_no_orphans(&after);
    // Two more of it are another prefab; with all of them the first one goes.
    colors[4] = "navy";
    folder.program(&stools(colors));
    folder.synth(&[]);
    let two = folder.files();
    assert_eq!((of(&two, "/Prefabs/").len(), of(&two, "/Objects/stool_").len()), (2, 0));
    has_no_orphans(&two);
    folder.program(&stools(["navy"; 6]));
    folder.synth(&[]);
    let all = folder.files();
    assert_eq!(of(&all, "/Prefabs/").len(), 1);
    assert!(
        of(&two, "/Prefabs/").contains(&of(&all, "/Prefabs/")[0]) && of(&all, "/Prefabs/") != of(&before, "/Prefabs/")
    );
    has_no_orphans(&all);
    folder.program(&stools(["white"; 6]));
    folder.synth(&[]);
    assert!(bytes(&before) == bytes(&folder.files()));
}

#[test]
fn a_comment_makes_neither_furniture_nor_a_layout_again() {
    let folder = Folder::made(ROOM, &[]);
    folder.program(&format!("// A study.\n{ROOM}"));
    let told = folder.told(&[]);
    assert_eq!((&told["assets"]["made"], &told["layout"]["made"]), (&json!({}), &json!(false)));
    assert_eq!(told["program"], json!({ "made": true, "why": ["room.scene was changed"] }));
}

#[test]
fn after_a_changed_constraint_only_what_must_move_moves() {
    let folder = Folder::made(ROOM, &[]);
    let before = read_json(&folder.at("out/room.layout.json"));
    folder.program(&ROOM.replace(">= 0.2", ">= 0.5").replace("<= 0.3", "<= 0.6"));
    let told = folder.told(&[]);
    let after = read_json(&folder.at("out/room.layout.json"));
    let moved: Vec<&str> = ["desk", "stool", "plant"]
        .into_iter()
        .filter(|name| before["objects"][name] != after["objects"][name])
        .collect();
    assert_eq!(moved, ["stool"]);
    assert!(told["layout"]["why"][0].as_str().unwrap().contains("gap(stool, desk) >= 0.5"), "{told}");
    // And it stays there.
    let files = folder.files();
    folder.synth(&[]);
    assert_eq!(files, folder.files());
}

#[test]
fn what_the_user_changed_stays_and_is_named() {
    let folder = Folder::made(ROOM, &[]);
    let materials: Vec<String> = folder.files().into_keys().filter(|name| name.contains("/Materials/")).collect();
    fs::write(folder.at("out/unity/Assets/mine.txt"), "mine").unwrap();
    fs::write(folder.at("out/unity/Assets/Scenelang/Materials/mine.mat"), "mine").unwrap();
    // Which of the materials goes is known once it is gone.
    folder.program(&ROOM.replace("\"red\"", "\"navy\""));
    let told = folder.told(&[]);
    let removed: Vec<&str> = told["removed"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
    let gone = removed.iter().find(|name| name.ends_with(".mat")).unwrap_or_else(|| panic!("{told}"));
    assert!(materials.contains(&(*gone).to_owned()) && !folder.at("out").join(gone).exists());
    let now: Vec<String> =
        folder.files().into_keys().filter(|n| n.ends_with(".mat") && !materials.contains(n)).collect();
    let navy = now.iter().find(|name| !name.ends_with("mine.mat")).unwrap();
    let path = folder.at("out").join(navy);
    let edited = fs::read_to_string(&path).unwrap().replace("m_Name", "m_Name ");
    fs::write(&path, &edited).unwrap();
    folder.program(ROOM);
    assert_eq!(folder.run(&[]).code, 2, "an edited project is not written over without a word");
    let ended = folder.synth(&["--overwrite"]);
    let said = format!(
        "{} no longer belongs to the scene, but is kept because it was edited",
        Path::new("out").join(navy).display()
    );
    assert!(ended.stderr.contains(&said), "{}", ended.stderr);
    assert_eq!(fs::read_to_string(&path).unwrap(), edited);
    for mine in ["out/unity/Assets/mine.txt", "out/unity/Assets/Scenelang/Materials/mine.mat"] {
        assert_eq!(fs::read_to_string(folder.at(mine)).unwrap(), "mine");
    }
    // It is the user's now, and in nobody's way.
    folder.synth(&[]);
    assert_eq!(fs::read_to_string(&path).unwrap(), edited);
}

#[test]
fn a_missing_file_is_made_again() {
    let folder = Folder::made(ROOM, &[]);
    let before = folder.files();
    fs::remove_file(folder.at("out/unity/Assets/Scenes/room.unity")).unwrap();
    let told = folder.told(&[]);
    assert_eq!(told["export"]["unity"]["why"], json!(["unity/Assets/Scenes/room.unity is missing"]));
    assert_eq!(
        (&told["export"]["glb"]["made"], &told["written"]),
        (&json!(false), &json!(["unity/Assets/Scenes/room.unity"]))
    );
    assert!(bytes(&before) == bytes(&folder.files()));
    fs::remove_file(folder.at("out/room.layout.json")).unwrap();
    let why = folder.told(&[])["layout"]["why"].take();
    assert_eq!(why, json!(["it is missing, was changed since it was written, or was not finished"]));
    assert!(bytes(&before) == bytes(&folder.files()));
}

#[test]
fn stages_are_ended_after_and_begun_from() {
    let folder = Folder(tempfile::tempdir().unwrap());
    folder.program(ROOM);
    let there = |folder: &Folder| -> Vec<String> {
        let names = folder.files().into_keys().filter(|name| !name.starts_with(".scenelang-"));
        names.filter(|name| !name.starts_with("unity/")).collect()
    };
    folder.synth(&["--until", "program"]);
    assert_eq!(there(&folder), ["room.scene"]);
    let told = folder.told(&["--until", "assets"]);
    assert_eq!(told["assets"]["made"].as_object().unwrap().len(), 3);
    assert_eq!((&told["layout"], there(&folder)), (&Value::Null, vec!["room.scene".to_owned()]));
    folder.synth(&["--until", "layout"]);
    assert_eq!(there(&folder), ["report.json", "room.layout.json", "room.scene"]);
    let told = folder.told(&[]);
    assert_eq!((&told["assets"]["made"], &told["layout"]["made"]), (&json!({}), &json!(false)));
    assert_eq!(there(&folder), ["report.json", "room.glb", "room.layout.json", "room.scene"]);
    let whole = folder.files();
    for (from, made) in [("export", [0, 0]), ("layout", [0, 1]), ("assets", [3, 1]), ("program", [3, 1])] {
        let told = folder.told(&["--from", from]);
        let counted = [told["assets"]["made"].as_object().unwrap().len(), usize::from(told["layout"]["made"] == true)];
        assert_eq!((counted, &told["export"]["glb"]["made"]), (made, &json!(true)), "{from}: {told}");
        assert!(bytes(&whole) == bytes(&folder.files()), "{from}");
    }
    // A folder that ends earlier keeps what later stages have written.
    folder.program(&ROOM.replace("\"red\"", "\"navy\""));
    folder.synth(&["--until", "program"]);
    assert!(folder.at("out/room.glb").exists() && folder.at("out/report.json").exists());
    assert_eq!(folder.run(&["--until", "somewhere"]).code, 2);
}

#[test]
fn a_request_is_read_once() {
    let folder = tempfile::tempdir().unwrap();
    let run = |request: &str| {
        let args = ["synth", request, "-o", "out", "--only", "glb", "--explain-rebuild", "--format", "json"];
        let ended = scenelang(folder.path(), args);
        assert_eq!(ended.code, 0, "{ended:?}");
        let mut told = serde_json::from_str::<Value>(&ended.stdout).unwrap();
        // How it was read is told where it was read.
        let rebuilt = told["rebuild"].take();
        assert_eq!(told["reading"].is_object(), rebuilt["program"]["made"] == true, "{told}");
        (rebuilt, told["reading"].take())
    };
    let (first, reading) = run("a bedroom with a bed and a desk");
    assert_eq!(first["program"]["made"], true);
    assert_eq!((&reading["understood"], &reading["words"]["unused"]), (&json!(1), &json!([])), "{reading}");
    assert!(reading["narrowed"].is_array() && reading["program"].is_null(), "{reading}");
    let (again, _) = run("a bedroom with a bed and a desk");
    for (stage, made) in [(&again["program"], false), (&again["layout"], false), (&again["export"]["glb"], false)] {
        assert_eq!(stage["made"], made, "{again}");
    }
    let (painted, _) = run("a bedroom with a bed and a red desk");
    assert_eq!(painted["program"]["made"], true);
    let made: Vec<&String> = painted["assets"]["made"].as_object().unwrap().keys().collect();
    assert_eq!((made, &painted["layout"]["made"]), (vec![&"desk".to_owned()], &json!(false)), "{painted}");
}

#[test]
fn export_makes_only_the_formats_again_that_show_the_change() {
    let folder = Folder::made(ROOM, &[]);
    fs::copy(folder.at("out/room.layout.json"), folder.at("room.layout.json")).unwrap();
    let export = |only: &str| {
        let args =
            ["export", "room.layout.json", "-o", "made", "--only", only, "--explain-rebuild", "--format", "json"];
        let ended = scenelang(folder.0.path(), args);
        assert_eq!(ended.code, 0, "{ended:?}");
        serde_json::from_str::<Value>(&ended.stdout).unwrap()["rebuild"].take()
    };
    export("picture,glb");
    folder.program(&format!("// A study.\n{ROOM}"));
    let told = export("picture,glb");
    assert_eq!((&told["export"]["picture"]["made"], &told["export"]["glb"]["made"]), (&json!(false), &json!(true)));
    // What was not asked for stays.
    export("glb");
    assert!(folder.at("made/picture.png").exists());
}

#[test]
fn a_project_stays_one_for_its_version_of_unity() {
    let folder = Folder::made(ROOM, &["--unity", "6000"]);
    let version = || fs::read_to_string(folder.at("out/unity/ProjectSettings/ProjectVersion.txt")).unwrap();
    assert!(version().starts_with("m_EditorVersion: 6000."));
    let told = folder.told(&[]);
    assert_eq!((&told["export"]["unity"]["made"], &told["written"]), (&json!(false), &json!([])));
    fs::copy(folder.at("out/room.layout.json"), folder.at("room.layout.json")).unwrap();
    let ended = scenelang(folder.0.path(), ["export", "room.layout.json", "-o", "out", "--only", "unity"]);
    assert!(ended.code == 0 && version().starts_with("m_EditorVersion: 6000."), "{ended:?}");
    let told = folder.told(&["--unity", "2022.3"]);
    assert_eq!(told["export"]["unity"]["why"], json!(["its options have changed"]));
    assert!(version().starts_with("m_EditorVersion: 2022.3"));
}

#[test]
fn the_explanation_is_for_people() {
    let folder = Folder::made(ROOM, &[]);
    folder.program(&ROOM.replace("\"red\"", "\"navy\"").replace("<= 0.3", "<= 0.25"));
    let told = folder.synth(&["--explain-rebuild"]).stdout;
    let from = told.find("program  rebuilt").unwrap();
    let told = &told[from..];
    let told = &told[..told.find("\n\n").unwrap()];
    let wanted = r#"program  rebuilt: room.scene was changed
assets   1 of 3 rebuilt
  stool: color has changed from "red" to "navy"
layout   rebuilt: `assert inFrontOf(stool, desk) and gap(stool, desk) >= 0.2 and gap(stool, desk) <= 0.25` was added, `assert inFrontOf(stool, desk) and gap(stool, desk) >= 0.2 and gap(stool, desk) <= 0.3` was removed
export   unity: rebuilt: `stool` looks different, the text of the program has changed, the text of the report has changed
export   glb: rebuilt: `stool` looks different, the text of the program has changed, the text of the report has changed
files    10 written, 2 removed
  removed unity/Assets/Scenelang/Materials/wood-c23b33.mat
  removed unity/Assets/Scenelang/Materials/wood-c23b33.mat.meta"#;
    assert_eq!(told, wanted);
}

/// The steps in which `synth` would bring a folder up to date; what it writes lives as long as its bytes.
fn steps<'a>(folder: &Folder, keep: &'a mut Vec<OutFile>) -> Steps<'a> {
    struct Nobody;
    impl Observer for Nobody {
        fn enter(&mut self, _: Stage) {}
        fn leave(&mut self, _: Stage) {}
        fn solving(&mut self, _: &scenelang_solve::Progress) {}
    }
    let (out, path) = (folder.at("out"), folder.at("room.scene"));
    let manifest = Manifest::of(&out);
    let known = manifest.scene("room");
    let before = known.layout(&out);
    let request = LayoutRequest {
        name: "room.scene",
        path: &path,
        files: &Door::of(&path),
        start: None,
        before: before.as_ref(),
        layout_name: "room.layout.json",
        scene_member: "room.scene",
        hold: Hold::Nothing,
        time: None,
        alternatives: None,
        free: 0,
        threads: 1,
        effort: 1,
        quality: 20,
        share: 1,
        stop: &scenelang_solve::Stop::default(),
        seed: 0,
        judge: scenelang_verify::Options::default(),
        furniture: None,
    };
    let solved = solve(&request, &mut Nobody).unwrap();
    let state = |inputs, files: &[OutFile], converged| State {
        inputs,
        files: own_names(files),
        sum: sum_of(files.iter().map(|file| file.bytes.as_slice())),
        converged,
    };
    let program = program_files(&solved.compiled, "room");
    let sums = own_names(&program).into_iter().zip(program.iter().map(|file| sum(&file.bytes))).collect();
    let layout = [OutFile::new("room.layout.json", solved.first.text.as_str())];
    let own = own_files(&solved, "room");
    let next = Known {
        program: vec![state(sums, &program, false)],
        assets: solved.made.looks.clone(),
        layout: vec![state(solved.made.inputs.clone(), &layout, solved.first.outcome.converged)],
        own: own_names(&own),
        formats: known.formats.clone(),
    };
    let exporters: [Box<dyn scenelang_export::Exporter>; 2] = [Box::new(Unity::default()), Box::new(Glb)];
    let drawn = scene(&solved, "room").unwrap();
    let planned = planned(&drawn, (&out, &known), &exporters, None, &mut |_| true).unwrap().unwrap();
    let (next, gone) = manifest.after("room", next, &planned.formats);
    let record = manifest.record("room", &next);
    *keep = [own, planned.files].concat();
    let set: Vec<(PathBuf, &[u8])> = keep.iter().map(|file| (file.path.clone(), file.bytes.as_slice())).collect();
    Change { files: &set, gone: &gone, record: Some(&record) }.steps(&out).unwrap()
}

/// Ended after each of some steps, the next run ends with the same bytes as if nothing had happened.
fn is_gone_on_with(folder: &Folder, before: &Files, wanted: &Files, points: usize) {
    let mut keep = Vec::new();
    folder.restore(before);
    let steps = steps(folder, &mut keep);
    let count = steps.steps.len();
    steps.run().unwrap();
    assert!(bytes(wanted) == bytes(&folder.files()), "the steps are those of the command");
    let mut tried: Vec<usize> = (0..points).map(|point| point * count / points).collect();
    tried.dedup();
    for point in tried {
        folder.restore(before);
        steps.first(point).unwrap();
        folder.synth(&[]);
        let files = folder.files();
        let differ: Vec<&str> = bytes(wanted)
            .keys()
            .chain(bytes(&files).keys())
            .copied()
            .filter(|name| bytes(wanted).get(name) != bytes(&files).get(name))
            .collect();
        assert!(differ.is_empty(), "after {point} of {count} steps: {differ:?}");
    }
}

#[test]
fn a_run_that_was_ended_is_gone_on_with() {
    // The layout is another one, a colour is, and a thing is not there any more.
    let edited = ROOM.replace("\"red\"", "\"navy\"").replace(">= 0.2", ">= 0.5").replace("<= 0.3", "<= 0.6");
    let edited = edited.split("object plant;").next().unwrap();
    let folder = Folder::made(ROOM, &[]);
    let before = folder.files();
    folder.program(edited);
    folder.synth(&[]);
    let after = folder.files();
    is_gone_on_with(&folder, &before, &after, 25);
}

#[test]
fn a_first_run_that_was_ended_is_gone_on_with() {
    let folder = Folder::made(ROOM, &[]);
    let made = folder.files();
    is_gone_on_with(&folder, &Files::new(), &made, 25);
}
