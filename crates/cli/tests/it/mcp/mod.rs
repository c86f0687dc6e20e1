//! `scenelang mcp`, as a client sees it: what is said, what is refused, what ends, and what does not grow.

pub mod client;

use crate::support::{folder_of, python, root, run, skip};
use client::Client;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use std::process::Command;

const STUDY: &str = "\
region study;
study.pos <- vec3(0, 0, 0);
study.scale <- vec3(4, 2.6, 3);
object desk;
desk.category <- \"desk\";
object lamp;
lamp.category <- \"table lamp\";
assert on(lamp, desk);
assert againstWall(desk, study);
";

/// Nothing can be at both ends of a room at once.
const TORN: &str = "\
region study;
study.pos <- vec3(0, 0, 0);
study.scale <- vec3(4, 2.6, 3);
object desk;
desk.category <- \"desk\";
assert desk.pos.x > 1;
assert desk.pos.x < -1;
assert desk.pos.z > 0.5;
";

/// More than there is room for, which takes long to find out.
const CROWD: &str = "\
region hall;
hall.pos <- vec3(0, 0, 0);
hall.scale <- vec3(9, 2.6, 9);
object chair[106];
chair.category <- \"armchair\";
";

fn written(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn a_session_that_only_reads() {
    let folder = folder_of(&[("study.scene", STUDY)]);
    let mut client = Client::new(folder.path(), &[]);
    client.ask("tools/list", &json!({}));
    client.ask("resources/list", &json!({}));
    client.done("check", &json!({ "file": "study.scene" }));
    let solved = client.done("solve", &json!({ "file": "study.scene" }));
    assert_eq!((&solved["ok"], &solved["in_memory"]), (&json!(true), &json!(["study.layout.json"])));
    client.done("check", &json!({ "file": "study.layout.json" }));
    let edit = json!([{ "old": "assert on(lamp, desk);", "new": "assert lamp.pos.y > 2;" }]);
    let guess = client.done("speculate", &json!({ "file": "study.scene", "edits": edit }));
    assert_eq!((&guess["before"]["ok"], &guess["after"]["ok"]), (&json!(true), &json!(false)));
    let shown = client.call("render", &json!({ "file": "study.scene" }));
    let picture = &shown["content"][1];
    assert_eq!((&picture["type"], &picture["mimeType"]), (&json!("image"), &json!("image/png")));
    assert!(picture["data"].as_str().unwrap().starts_with("iVBORw0KGgo"), "it is no PNG");
    client.done("why_not", &json!({ "file": "study.scene", "statement": "assert desk.pos.x > 9;" }));
    client.done("vocabulary", &json!({ "word": "againstwall" }));
    client.done("repair", &json!({ "file": "study.scene" }));
    insta::assert_snapshot!(client.transcript);
    assert_eq!(written(folder.path()), ["study.scene"], "nothing is written");
    assert_eq!(client.end(), 0);
}

#[test]
fn a_room_from_words() {
    let folder = folder_of(&[]);
    let mut client = Client::new(folder.path(), &["--write"]);
    let request = json!({ "request": "a study with a desk and a lamp on it", "file": "study.scene", "literal": true });
    let formalized = client.done("formalize", &request);
    assert_eq!(formalized["written"], json!(["study.scene"]));
    let solved = client.done("solve", &json!({ "file": "study.scene" }));
    assert_eq!((&solved["ok"], &solved["written"]), (&json!(true), &json!(["study.layout.json"])));
    assert_eq!(written(folder.path()), ["study.layout.json", "study.scene"]);
    // The command line finds the same, and the files are known again.
    let ended = run(crate::support::binary().args(["check", "study.layout.json"]).current_dir(folder.path()), b"");
    assert_eq!(ended.code, 0, "{}", ended.stdout);
    client.done("formalize", &request);
    fs::write(folder.path().join("study.scene"), STUDY).unwrap();
    assert!(client.refused("formalize", &request).contains("name another file"));
    assert!(client.refused("formalize", &json!({ "request": "zzz" })).contains("nothing in the request"));
    assert_eq!(client.end(), 0);
}

#[test]
fn what_was_moved_is_repaired() {
    let layout = |x: f64| {
        json!({ "format": "scenelang.layout/1", "scene": "room.scene",
            "objects": { "desk": { "pos": [x, 0, 1], "scale": [1, 0.7, 0.6] } } })
        .to_string()
    };
    let scene = "object desk;\ndesk.scale <- vec3(1, 0.7, 0.6);\nassert desk.pos.x > 1;\n";
    let folder = folder_of(&[("room.scene", scene), ("room.layout.json", &layout(0.5))]);
    let mut client = Client::new(folder.path(), &["--write"]);
    let found = client.done("repair", &json!({ "file": "room.scene" }));
    assert_eq!(found["ways"][0]["how"], "move");
    assert_eq!(fs::read_to_string(folder.path().join("room.layout.json")).unwrap(), layout(0.5));
    // With the desk locked only the program can change.
    let locked = client.done("repair", &json!({ "file": "room.scene", "lock": ["desk"] }));
    assert!(locked["ways"].as_array().unwrap().iter().all(|way| way["how"] != "move"), "{locked}");
    assert!(client.refused("repair", &json!({ "file": "room.scene", "lock": ["dask"] })).contains("no object `dask`"));
    let made = client.done("repair", &json!({ "file": "room.scene", "apply": 1 }));
    assert_eq!((&made["written"], &made["after"]["ok"]), (&json!(["room.layout.json"]), &json!(true)));
    assert!(client.refused("repair", &json!({ "file": "room.scene", "apply": 9 })).contains("no repair number 9"));
    insta::assert_snapshot!(client.transcript);
}

#[test]
fn a_contradiction_is_told_with_its_smallest_set() {
    let folder = folder_of(&[("torn.scene", TORN)]);
    let mut client = Client::new(folder.path(), &[]);
    let told = client.done("why_not", &json!({ "file": "torn.scene", "proof": true }));
    let statements: Vec<_> =
        told["sets"][0]["statements"].as_array().unwrap().iter().map(|s| s["at"].clone()).collect();
    assert_eq!(statements, ["torn.scene:6:1", "torn.scene:7:1"]);
    let solved = client.done("solve", &json!({ "file": "torn.scene" }));
    assert_eq!(solved["ok"], false);
    insta::assert_snapshot!(client.transcript);
}

#[test]
fn wrong_calls_are_refused_and_say_what_is_right() {
    let folder = folder_of(&[("study.scene", STUDY), ("notes.txt", "x")]);
    let mut client = Client::new(folder.path(), &[]);
    client.call("demolish", &json!({}));
    client.ask("tools/destroy", &json!({}));
    for (tool, arguments) in [
        ("check", json!({})),
        ("check", json!({ "file": 7 })),
        ("check", json!({ "file": "study.scene", "colour": "red" })),
        ("check", json!({ "file": "missing.scene" })),
        ("check", json!({ "file": "notes.txt" })),
        ("check", json!({ "file": "" })),
        ("explain", json!({ "word": "nearr" })),
        ("vocabulary", json!({ "word": "qqq" })),
        ("render", json!({ "file": "study.scene" })),
        ("render", json!({ "file": "study.scene", "view": "film" })),
        ("repair", json!({ "file": "study.scene" })),
        ("speculate", json!({ "file": "study.scene" })),
        ("speculate", json!({ "file": "study.scene", "edits": [{ "old": "desk", "new": "bed" }] })),
        ("solve", json!({ "file": "study.layout.json" })),
        ("solve", json!({ "file": "study.scene", "seed": -1 })),
    ] {
        client.refused(tool, &arguments);
    }
    insta::assert_snapshot!(client.transcript.split_once("→ tools/call").unwrap().1);
}

#[test]
fn paths_do_not_lead_out_of_the_workspace() {
    let around = tempfile::tempdir().unwrap();
    let inside = around.path().join("in");
    // A repository around the workspace opens nothing.
    fs::create_dir_all(around.path().join(".git")).unwrap();
    fs::create_dir_all(&inside).unwrap();
    fs::write(around.path().join("secret.scene"), "object hunter2;\n").unwrap();
    fs::write(inside.join("import.scene"), "import \"../secret.scene\";\n").unwrap();
    let layout = r#"{ "format": "scenelang.layout/1", "scene": "../secret.scene", "objects": {} }"#;
    fs::write(inside.join("names.layout.json"), layout).unwrap();
    let absolute = around.path().join("secret.scene").display().to_string();
    let mut files = vec!["../secret.scene", "a/../../secret.scene", &absolute];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("../secret.scene", inside.join("link.scene")).unwrap();
        std::os::unix::fs::symlink("..", inside.join("up")).unwrap();
        files.extend(["link.scene", "up/secret.scene"]);
    }
    for options in [&[][..], &["--write"]] {
        let mut client = Client::new(&inside, options);
        for file in &files {
            for tool in ["check", "solve", "repair", "why_not", "render", "speculate"] {
                let why = client.refused(
                    tool,
                    &json!({ "file": file, "text": "object a;" }).as_object().map_or_else(
                        || json!({}),
                        |all| {
                            let kept = all.iter().filter(|(name, _)| tool == "speculate" || *name == "file");
                            Value::Object(kept.map(|(name, value)| (name.clone(), value.clone())).collect())
                        },
                    ),
                );
                assert!(why.contains("is outside the workspace"), "{tool} {file}: {why}");
            }
            let why = client.refused("formalize", &json!({ "request": "a room with a bed", "file": file }));
            assert!(why.contains("is outside the workspace"), "{file}: {why}");
            for kind in ["program", "report"] {
                let read = client.ask("resources/read", &json!({ "uri": format!("scenelang://{kind}/{file}") }));
                assert!(read["message"].as_str().unwrap().contains("is outside the workspace"), "{read}");
            }
        }
        for file in ["import.scene", "names.layout.json"] {
            client.done("check", &json!({ "file": file }));
            client.call("why_not", &json!({ "file": file }));
        }
        client.call("solve", &json!({ "file": "import.scene" }));
        assert!(!client.transcript.contains("hunter2"), "{}", client.transcript);
    }
    assert_eq!(fs::read_to_string(around.path().join("secret.scene")).unwrap(), "object hunter2;\n");
}

#[test]
fn a_call_that_is_cancelled_ends_and_others_go_on() {
    let folder = folder_of(&[("crowd.scene", CROWD)]);
    let mut client = Client::new(folder.path(), &[]);
    let calls: Vec<u64> = (0..3)
        .map(|seed| {
            let arguments = json!({ "file": "crowd.scene", "seed": seed });
            client.begin("tools/call", &json!({ "name": "solve", "arguments": arguments }))
        })
        .collect();
    for call in &calls {
        client.tell("notifications/cancelled", &json!({ "requestId": call, "reason": "no longer wanted" }));
    }
    // It is answered although all who work were busy; of the cancelled calls nothing is heard.
    let last = client.begin("tools/call", &json!({ "name": "explain", "arguments": { "word": "near" } }));
    let heard = client.hear();
    assert_eq!(heard["id"], last, "{heard}");
    assert_eq!(client.end(), 0);
}

#[test]
fn a_call_that_takes_too_long_says_so() {
    let folder = folder_of(&[("crowd.scene", CROWD)]);
    let mut client = Client::new(folder.path(), &["--time", "0.2"]);
    let why = client.refused("solve", &json!({ "file": "crowd.scene" }));
    assert!(why.contains("0.2 s") && why.contains("--time"), "{why}");
}

/// Memory that a process has in use (kB).
#[cfg(target_os = "linux")]
fn memory(id: u32) -> u64 {
    let status = fs::read_to_string(format!("/proc/{id}/status")).unwrap();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).unwrap();
    line.trim().trim_end_matches(" kB").parse().unwrap()
}

#[cfg(target_os = "linux")]
#[test]
fn a_thousand_calls_leave_nothing_behind() {
    let folder = folder_of(&[("torn.scene", TORN)]);
    let mut client = Client::new(folder.path(), &[]);
    let round = |client: &mut Client, n: usize| {
        for i in 0..n {
            match i % 4 {
                0 => client.call("check", &json!({ "file": "torn.scene" })),
                1 => client.call("vocabulary", &json!({ "word": "near" })),
                2 => client.call("nothing", &json!({})),
                _ => client.call("speculate", &json!({ "file": "torn.scene", "text": "object a;\n" })),
            };
            client.transcript.clear();
        }
        memory(client.id())
    };
    let before = round(&mut client, 200);
    let after = round(&mut client, 800);
    assert!(after < before + (8 << 10), "{before} kB after 200 calls, {after} kB after 1,000");
}

/// The client of those who made the protocol.
#[test]
fn the_official_client_is_served() {
    let Some(python) = python() else { return skip("there is no .venv for the official client") };
    let has = Command::new(&python).args(["-c", "import mcp"]).status().is_ok_and(|status| status.success());
    if !has {
        return skip("the Python package mcp is not installed");
    }
    let folder = folder_of(&[("study.scene", STUDY), ("torn.scene", TORN)]);
    let mut command = Command::new(python);
    command.arg(root().join("tests/oracles/mcp_client.py")).arg(env!("CARGO_BIN_EXE_scenelang")).arg(folder.path());
    let ended = run(&mut command, b"");
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    assert!(ended.stdout.contains("9 tools"), "{}", ended.stdout);
}

/// A client that knows nothing but `repair` brings damaged layouts of the public problems back.
#[test]
fn whoever_follows_repair_arrives() {
    let (mut all, mut lost) = (0, Vec::new());
    for name in crate::problems::sample() {
        let witness = crate::problems::file(&name, "witness.json");
        if !witness.exists() {
            continue;
        }
        let folder = tempfile::tempdir().unwrap();
        fs::copy(crate::problems::file(&name, "scene"), folder.path().join("room.scene")).unwrap();
        for which in 0..3 {
            let mut layout = crate::support::read_json(&witness);
            layout["scene"] = "room.scene".into();
            let objects = layout["objects"].as_object_mut().unwrap();
            let chosen = (which * 5 + 1) % objects.len();
            let (_, object) = objects.iter_mut().nth(chosen).unwrap();
            object["pos"][0] = (object["pos"][0].as_f64().unwrap() + 0.4).into();
            fs::write(folder.path().join("room.layout.json"), layout.to_string()).unwrap();
            let mut client = Client::new(folder.path(), &[]);
            let mut ok = client.done("check", &json!({ "file": "room.scene" }))["ok"] == true;
            for _ in 0..5 {
                if ok {
                    break;
                }
                let made = client.call("repair", &json!({ "file": "room.scene", "apply": 1 }));
                ok = made["structuredContent"]["after"]["ok"] == true;
                client.transcript.clear();
            }
            all += 1;
            if !ok {
                lost.push(format!("{name} {which}"));
            }
        }
    }
    println!("{} of {all} arrive", all - lost.len());
    assert!(lost.is_empty(), "{lost:?}");
}
