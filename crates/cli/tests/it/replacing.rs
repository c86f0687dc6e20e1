//! What the user has written is replaced only where the user says so, by every command that writes; and what a command
//! reads it never writes over.

use crate::support::{Ended, scenelang};
use std::fs;
use std::path::Path;

const ROOM: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(4, 2.6, 4);\n\
    object bed;\nbed.category <- \"bed\";\nbed.dimensions <- vec3(1.6, 0.55, 2);\nassert inside(bed, room);\n";
const REQUEST: &str = "a bedroom with a bed and a desk";
const TRUTH: &str = r#"{ "id": "one", "rooms": [], "objects": [], "relations": [], "numeric": [] }"#;
const BROKEN: &str = r#"{ "format": "scenelang.layout/1", "scene": "broken.scene",
    "objects": { "box": { "pos": [0, 0, 0], "scale": [1, 1, 1] } } }"#;
const MINE: &str = "this is mine\n";

const SUITE: &str = r#"{ "format": "scenelang.suite/1", "name": "one", "scenes": 1, "seed": 7 }"#;

/// Every command that writes: its arguments, and a file that it writes.
const COMMANDS: [(&[&str], &str); 16] = [
    (&["solve", "room.scene"], "room.layout.json"),
    (&["solve", "room.scene", "-o", "other.json"], "other.json"),
    (&["solve", "room.scene", "--alternatives", "2", "-o", "some.layout.json"], "some.2.layout.json"),
    (&["repair", "broken.layout.json", "-o", "repaired.json"], "repaired.json"),
    (&["formalize", REQUEST, "--untried", "-o", "asked.scene"], "asked.scene"),
    (&["synth", REQUEST, "-o", "asked"], "asked/room.scene"),
    (&["synth", "room.scene", "-o", "out"], "out/room.layout.json"),
    (&["export", "room.layout.json", "--only", "plan,glb", "-o", "out"], "out/plan.svg"),
    (&["import", "room.glb", "-o", "back"], "back/room.scene"),
    (&["sample", "room.scene", "-n", "2", "-o", "samples"], "samples/samples-000000000.jsonl"),
    (&["batch", "jobs.jsonl", "-o", "many"], "many/box.layout.json"),
    (&["eval", "requests", "requests", "--untried", "-o", "programs"], "programs/one.scene"),
    (&["eval", "dataset", "--scenes", "1", "-o", "data"], "data/dataset.jsonl"),
    (&["eval", "run", "--suite", "suite.json", "-o", "results"], "results/figures.json"),
    (&["assets", "import", "models", "-o", "shop"], "shop/one.json"),
    (&["bench", "solve", "room.scene", "-o", "record.json", "--layouts", "layouts"], "record.json"),
];

/// A folder with what the commands read.
fn prepared() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("room.scene"), ROOM).unwrap();
    fs::write(at("jobs.jsonl"), "{\"name\": \"box\", \"source\": \"object a;\"}").unwrap();
    fs::create_dir(at("models")).unwrap();
    fs::write(at("models/one.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
        .unwrap();
    fs::create_dir(at("requests")).unwrap();
    fs::write(at("requests/one.txt"), "A room with a bed.").unwrap();
    fs::write(at("requests/one.expect.json"), TRUTH).unwrap();
    fs::write(at("suite.json"), SUITE).unwrap();
    fs::write(at("broken.scene"), "object box; assert box.pos.x >= 1;").unwrap();
    fs::write(at("broken.layout.json"), BROKEN).unwrap();
    assert_eq!(scenelang(folder.path(), ["solve", "room.scene"]).code, 0);
    assert_eq!(scenelang(folder.path(), ["export", "room.layout.json", "--only", "glb", "-o", "made"]).code, 0);
    fs::copy(at("made/room.glb"), at("room.glb")).unwrap();
    folder
}

fn refuses(ended: &Ended, file: &str) {
    assert_eq!(ended.code, 2, "{}{}", ended.stdout, ended.stderr);
    assert!(ended.stderr.contains(Path::new(file).file_name().unwrap().to_str().unwrap()), "{}", ended.stderr);
}

fn forced<'a>(args: &[&'a str]) -> Vec<&'a str> {
    args.iter().copied().chain(["--force"]).collect()
}

#[test]
fn a_file_of_the_user_stays() {
    for (args, file) in COMMANDS {
        let folder = prepared();
        let path = folder.path().join(file);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, MINE).unwrap();
        // The layout that is repaired or exported is not the one that is in the way.
        let ended = scenelang(folder.path(), args);
        refuses(&ended, file);
        assert!(ended.stderr.contains("was not written by scenelang") && ended.stderr.contains("--force"), "{ended:?}");
        assert_eq!(fs::read_to_string(&path).unwrap(), MINE, "{args:?}");
        let ended = scenelang(folder.path(), forced(args));
        assert!(ended.code <= 1 && fs::read_to_string(&path).is_ok_and(|text| text != MINE), "{args:?} {ended:?}");
    }
}

#[test]
fn what_scenelang_wrote_is_replaced_until_it_is_edited() {
    for (args, file) in COMMANDS {
        let folder = prepared();
        let path = folder.path().join(file);
        for _ in 0..2 {
            let ended = scenelang(folder.path(), args);
            assert!(ended.code <= 1, "{args:?} {ended:?}");
        }
        let text = fs::read_to_string(&path).unwrap();
        let edited = text + "\n";
        fs::write(&path, &edited).unwrap();
        let ended = scenelang(folder.path(), args);
        refuses(&ended, file);
        assert!(ended.stderr.contains("has been edited since scenelang wrote it"), "{args:?} {ended:?}");
        assert_eq!(fs::read_to_string(&path).unwrap(), edited, "{args:?}");
        let ended = scenelang(folder.path(), forced(args));
        assert!(ended.code <= 1, "{args:?} {ended:?}");
        let ended = scenelang(folder.path(), args);
        assert!(ended.code <= 1, "{args:?} {ended:?}");
    }
}

#[test]
fn an_input_is_never_written_over() {
    let folder = prepared();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("request.txt"), REQUEST).unwrap();
    fs::copy(at("room.layout.json"), at("start.layout.json")).unwrap();
    let mut aliases = vec!["./room.scene".to_owned()];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("room.scene", at("link.scene")).unwrap();
        fs::hard_link(at("room.scene"), at("hard.scene")).unwrap();
        aliases.extend(["link.scene".to_owned(), "hard.scene".to_owned()]);
    }
    for alias in &aliases {
        for args in [&["solve", "room.scene", "-o"][..], &["repair", "room.layout.json", "-o"]] {
            let args: Vec<&str> = args.iter().copied().chain([alias.as_str(), "--force"]).collect();
            refuses(&scenelang(folder.path(), &args), alias);
            assert_eq!(fs::read_to_string(at("room.scene")).unwrap(), ROOM, "{args:?}");
        }
    }
    let args = ["formalize", "-f", "request.txt", "-o", "./request.txt", "--force"];
    refuses(&scenelang(folder.path(), args), "request.txt");
    assert_eq!(fs::read_to_string(at("request.txt")).unwrap(), REQUEST);
    // A layout to start from may be the one to write: that is what is asked for.
    let args = ["solve", "room.scene", "--layout", "start.layout.json", "-o", "start.layout.json"];
    assert_eq!(scenelang(folder.path(), args).code, 0);
}

/// An edit by hand that a command keeps is not taken for its own work by the next one.
#[test]
fn what_was_edited_stays_edited() {
    let folder = prepared();
    let path = folder.path().join("room.layout.json");
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, text.replacen("\"scene\":", "\"note\": \"mine\",\n  \"scene\":", 1)).unwrap();
    let again = ["solve", "room.scene", "--layout", "room.layout.json"];
    assert_eq!(scenelang(folder.path(), again).code, 0);
    assert!(fs::read_to_string(&path).unwrap().contains("mine"));
    refuses(&scenelang(folder.path(), ["solve", "room.scene"]), "room.layout.json");
    assert!(fs::read_to_string(&path).unwrap().contains("mine"));
}

/// A failure leaves the old file.
#[test]
fn a_failed_command_leaves_the_old_file() {
    let folder = prepared();
    let path = folder.path().join("room.layout.json");
    let old = fs::read(&path).unwrap();
    for broken in ["object bed; assert bed.pos.x > ;", "object bed; assert bed.pos.x > 1; assert bed.pos.x < 0;"] {
        fs::write(folder.path().join("room.scene"), broken).unwrap();
        assert_ne!(scenelang(folder.path(), ["solve", "room.scene"]).code, 0);
        assert_eq!(fs::read(&path).unwrap(), old);
    }
}

#[cfg(unix)]
#[test]
fn links_modes_and_read_only_files_are_respected() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = prepared();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("far")).unwrap();
    fs::rename(at("room.layout.json"), at("far/real.json")).unwrap();
    symlink("far/real.json", at("room.layout.json")).unwrap();
    let mode = |path: &Path, mode: u32| fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
    mode(&at("far/real.json"), 0o640);
    let old = fs::read(at("far/real.json")).unwrap();
    assert_eq!(scenelang(folder.path(), ["solve", "room.scene", "--seed", "3"]).code, 0);
    assert!(fs::symlink_metadata(at("room.layout.json")).unwrap().is_symlink());
    assert_ne!(fs::read(at("far/real.json")).unwrap(), old);
    assert_eq!(fs::metadata(at("far/real.json")).unwrap().permissions().mode() & 0o777, 0o640);
    mode(&at("far/real.json"), 0o440);
    let ended = scenelang(folder.path(), ["solve", "room.scene"]);
    assert!(ended.code == 2 && ended.stderr.contains("read-only"), "{ended:?}");
}

#[cfg(unix)]
#[test]
fn what_is_no_file_is_written_to() {
    let folder = prepared();
    let ended = scenelang(folder.path(), ["solve", "room.scene", "-o", "/dev/stdout", "--format", "json"]);
    assert!(ended.code == 0 && ended.stdout.starts_with("{\n  \"format\": \"scenelang.layout/1\""), "{ended:?}");
    let ended = scenelang(folder.path(), ["formalize", REQUEST, "--untried", "-o", "/dev/null"]);
    assert_eq!(ended.code, 0, "{ended:?}");
    assert!(!fs::metadata("/dev/null").unwrap().is_file());
}
