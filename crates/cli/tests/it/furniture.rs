//! Furniture from folders and from generators: what `synth` makes of it, and that a workspace cannot have anything run.

use crate::support::{Ended, binary, read_json, run};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use tempfile::{TempDir, tempdir};

const ROOM: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(4, 2.6, 4);\n\
    object chair[2];\nchair.category <- \"chair\";\nobject gizmo;\ngizmo.dimensions <- vec3(0.5, 1, 0.5);\n\
    assert inside(chair[0], room);\nassert inside(chair[1], room);\nassert inside(gizmo, room);\n";
/// A tetrahedron half a metre wide and deep, and 0.9 m high: nothing that the library draws.
const TENT: &str = "v 0 0 0\nv 0.5 0 0\nv 0 0.9 0\nv 0 0 0.5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// A program with a folder of models beside it.
fn room() -> TempDir {
    let folder = tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir_all(at("models")).unwrap();
    fs::create_dir_all(at("home/scenelang")).unwrap();
    fs::write(at("room.scene"), ROOM).unwrap();
    fs::write(at("models/tent.obj"), TENT).unwrap();
    let card = json!({ "category": "chair", "description": "a tent to sit in", "licence": "CC0-1.0", "front": "+z" });
    fs::write(at("models/tent.json"), card.to_string()).unwrap();
    folder
}

fn scenelang(folder: &Path, args: &[&str]) -> Ended {
    let mut command = binary();
    command
        .current_dir(folder)
        .env("XDG_CONFIG_HOME", folder.join("home"))
        .env("SCENELANG_CACHE", folder.join("cache"));
    run(command.args(args), b"")
}

/// `synth` without anything that takes long.
fn synth(folder: &Path, more: &[&str]) -> Ended {
    let args = ["synth", "room.scene", "--only", "obj", "--quality", "0", "--format", "json"];
    scenelang(folder, &[&args[..], more].concat())
}

/// Who furnished which object, in a line each.
fn told(furniture: &Value) -> Vec<String> {
    let text = |row: &Value, key: &str| row[key].as_str().unwrap_or_default().to_owned();
    let passed =
        |row: &Value| row["passed"].as_array().unwrap().iter().map(|p| text(p, "why")).collect::<Vec<_>>().join(",");
    let rows = furniture["objects"].as_array().unwrap().iter();
    rows.map(|row| {
        format!("{} {}:{} [{}]", text(row, "object"), text(row, "provider"), text(row, "source"), passed(row))
    })
    .collect()
}

#[test]
fn a_room_is_furnished_from_a_folder() {
    let folder = room();
    let at = |name: &str| folder.path().join(name);
    let ended = synth(folder.path(), &["-o", "plain"]);
    assert!(ended.code == 0 && !at("plain/furniture.json").exists(), "{ended:?}");
    let ended = synth(folder.path(), &["-o", "out", "--assets", "models"]);
    assert_eq!(ended.code, 0, "{ended:?}");
    let furniture = read_json(&at("out/furniture.json"));
    let wanted = ["chair[0] models:tent.obj []", "chair[1] models:tent.obj []", "gizmo box:unknown [nothing,nothing]"];
    assert_eq!(told(&furniture), wanted);
    assert_eq!(serde_json::from_str::<Value>(&ended.stdout).unwrap()["furniture"], furniture["objects"]);
    assert!(furniture["objects"][0]["sha256"].as_str().is_some_and(|sum| sum.len() == 64), "{furniture}");
    let layout = read_json(&at("out/room.layout.json"));
    let height = layout["objects"]["chair[0]"]["scale"][1].as_f64().unwrap();
    assert!((height - 0.9).abs() < 1e-6, "{height}");
    // The settings of the workspace say the same, and the same comes of it.
    fs::write(at("scenelang.toml"), "[assets]\nfolders = [\"models\"]\n").unwrap();
    assert_eq!(synth(folder.path(), &["-o", "again"]).code, 0);
    for file in ["furniture.json", "room.layout.json"] {
        assert_eq!(fs::read(at("out").join(file)).unwrap(), fs::read(at("again").join(file)).unwrap(), "{file}");
    }
    // A file that cannot be used is told, and the room is furnished all the same.
    fs::write(at("models/tent.obj"), "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let ended = synth(folder.path(), &["-o", "broken"]);
    let summary: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert!(ended.code == 0 && summary["warnings"].to_string().contains("models: tent.obj: "), "{ended:?}");
    assert_eq!(told(&read_json(&at("broken/furniture.json")))[0], "chair[0] library:chair [broken]");
}

#[test]
fn a_workspace_has_nothing_run() {
    let folder = room();
    let at = |name: &str| folder.path().join(name);
    let script = format!("#!/bin/sh\ntouch {}\nexit 1\n", at("ran").display());
    fs::write(at("make.sh"), script).unwrap();
    for setting in ["command = [\"sh\", \"make.sh\"]", "generator = \"command\"", "url = \"http://127.0.0.1:9\""] {
        fs::write(at("scenelang.toml"), format!("[assets]\n{setting}\n")).unwrap();
        let ended = synth(folder.path(), &["-o", "out"]);
        assert!(ended.code == 2 && ended.stderr.contains("is not a workspace setting"), "{ended:?}");
    }
    fs::write(at("scenelang.toml"), "[assets]\norder = [\"generator\", \"library\"]\nmax_models = 9\n").unwrap();
    assert_eq!(synth(folder.path(), &["-o", "out"]).code, 0);
    fs::write(at("scenelang.toml"), "[assets]\nfolders = [\"../elsewhere\"]\n").unwrap();
    let ended = synth(folder.path(), &["-o", "out"]);
    assert!(ended.code == 2 && ended.stderr.contains("outside its workspace"), "{ended:?}");
    assert!(!at("ran").exists());
    fs::remove_file(at("scenelang.toml")).unwrap();
    for (generator, said) in [
        ("sofa", "there is no generator `sofa`"),
        ("command", "`--generator command` needs a program"),
        ("meshy", "meshy needs a key: set MESHY_API_KEY"),
        ("hunyuan:ftp://a.example", "must start with https:// or http://"),
    ] {
        let ended = synth(folder.path(), &["-o", "out", "--generator", generator]);
        assert!(ended.code == 2 && ended.stderr.contains(said), "{generator}: {ended:?}");
    }
}

#[test]
#[cfg(unix)]
fn the_user_has_a_program_run() {
    let folder = room();
    let at = |name: &str| folder.path().join(name);
    let models = scenelang(folder.path(), &["assets", "import", "models", "-o", "made"]);
    assert_eq!(models.code, 0, "{models:?}");
    let script = format!("echo x >> {}; cat {}", at("ran").display(), at("made/tent.glb").display());
    let own = format!("[assets]\ngenerator = \"command\"\ncommand = [\"sh\", \"-c\", {script:?}]\nmax_models = 5\n");
    fs::write(at("home/scenelang/config.toml"), own).unwrap();
    let ended = synth(folder.path(), &["-o", "out"]);
    assert_eq!(ended.code, 0, "{ended:?}");
    assert!(ended.stderr.contains("asking the generator command for missing models: at most 5"), "{ended:?}");
    let furniture = read_json(&at("out/furniture.json"));
    assert_eq!(told(&furniture)[0], "chair[0] command:chair []", "{furniture}");
    // Two kinds of things were made; the next run makes nothing, and a bound of nothing is enough for it.
    let runs = || fs::read_to_string(at("ran")).unwrap().lines().count();
    assert_eq!(runs(), 2);
    let ended = synth(folder.path(), &["-o", "again", "--max-models", "0"]);
    assert_eq!((ended.code, runs()), (0, 2), "{ended:?}");
    assert_eq!(fs::read(at("out/room.layout.json")).unwrap(), fs::read(at("again/room.layout.json")).unwrap());
    assert_eq!(synth(folder.path(), &["-o", "none", "--generator", "none"]).code, 0);
    assert!(!at("none/furniture.json").exists());
}

#[test]
fn a_folder_is_imported_and_a_gallery_is_drawn() {
    let folder = room();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("models/short.glb"), "glTF").unwrap();
    let ended = scenelang(folder.path(), &["assets", "import", "models", "-o", "shop"]);
    assert!(ended.code == 2 && ended.stdout.contains("1 of 2 models were written to shop"), "{ended:?}");
    assert!(ended.stderr.contains("short.glb: error[E0701]"), "{ended:?}");
    let checked = scenelang(folder.path(), &["assets", "check", "shop"]);
    assert!(checked.stdout.contains("shop: 1 model checked, 0 with findings"), "{checked:?}");

    let args = ["assets", "gallery", "chair", "fridge", "-o", "gallery.html"];
    let ended = scenelang(folder.path(), &args);
    assert_eq!(ended.code, 0, "{ended:?}");
    let page = fs::read_to_string(at("gallery.html")).unwrap();
    // Three sizes of a chair; of a fridge, open, too.
    assert_eq!((page.matches("<img").count(), page.matches("open:").count()), (9, 3));
    assert!(page.len() < 400_000 && !page.contains("http"), "{}", page.len());
    assert_eq!(scenelang(folder.path(), &args).code, 2, "what is there stays");
    let ended = scenelang(folder.path(), &["assets", "gallery", "fridg", "-o", "other.html"]);
    assert!(ended.code == 2 && ended.stderr.contains("did you mean `fridge`?"), "{ended:?}");
}
