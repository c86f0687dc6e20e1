//! Commands, the scene for a preview, dragging, and what the program becomes.

use crate::client::{Client, at, edited, edits_of, room, usual};
use scenelang_lsp::{Beside, Setup};
use serde_json::{Value, json};
use std::sync::Mutex;

fn run(client: &mut Client, command: &str, argument: Value) -> Value {
    client.ask("workspace/executeCommand", json!({ "command": command, "arguments": [argument] }))
}

/// The change that the client was last asked to make.
fn asked(client: &Client) -> Value {
    client.asked.iter().rev().find(|m| m["method"] == "workspace/applyEdit").expect("an edit")["params"]["edit"].clone()
}

#[test]
fn checking_solving_and_repairing() {
    let (folder, scene, layout) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &scene);
    client.published(&uri);
    let of = json!({ "uri": uri });
    let checked = run(&mut client, "scenelang.check", of.clone());
    assert_eq!((&checked["holds"], &checked["total"]), (&json!(9), &json!(12)));
    assert!(client.asked.iter().all(|m| m["method"] != "workspace/applyEdit"));

    // What is locked is not moved.
    let locked = json!({ "uri": uri, "lock": ["bed", "stand", "lamp"] });
    let ask = json!({ "command": "scenelang.repairAll", "arguments": [locked] });
    let (_, why) = client.refused("workspace/executeCommand", ask);
    assert!(why.ends_with("leaves what is locked in place: `bed`, `stand[0]`, `stand[1]`, `lamp`"), "{why}");
    // What is only proposed is not made.
    let proposed = run(&mut client, "scenelang.repairAll", json!({ "uri": uri, "propose": true }));
    assert!(proposed["message"].as_str().unwrap().contains("stand[1]"), "{proposed}");
    assert_eq!((&proposed["moves"][0]["object"], &proposed["uri"]), (&json!("stand[1]"), &json!(uri)));
    assert!(edits_of(&proposed["edit"], &client.uri("room.layout.json"))[0]["newText"].is_string());
    assert!(client.asked.iter().all(|m| m["method"] != "workspace/applyEdit"));

    let repaired = run(&mut client, "scenelang.repairAll", of.clone());
    assert!(repaired["message"].as_str().unwrap().contains("stand[1]"), "{repaired}");
    let data = client.uri("room.layout.json");
    let after = edited(&layout, edits_of(&asked(&client), &data));
    assert!(after.contains("\"note\": \"mine\""), "what others wrote stays: {after}");
    // The editor has made it, but has not opened the file with us: it is what counts all the same.
    client.until("it to hold", |c| c.published(&uri).iter().all(|m| m["code"] == "V0106").then_some(()));
    assert_eq!(
        std::fs::read_to_string(folder.path().join("room.layout.json")).unwrap(),
        layout,
        "nobody wrote the file"
    );

    let line = at(&scene, "|prefer bed")["line"].clone();
    let one = run(&mut client, "scenelang.repair", json!({ "uri": uri, "line": line }));
    assert!(one["message"].is_string());
    let solved = run(&mut client, "scenelang.solve", json!({ "uri": uri, "seed": 3 }));
    assert_eq!(solved["holds"], solved["total"], "{solved}");
    let text = edits_of(&asked(&client), &data)[0]["newText"].as_str().unwrap().to_owned();
    assert!(text.contains("\"seed\": 3"));

    for (command, argument, code) in [
        ("scenelang.nothing", of.clone(), -32602),
        ("scenelang.solve", json!({}), -32602),
        ("scenelang.repair", of.clone(), -32602),
        ("scenelang.check", json!({ "uri": "file:///nowhere.scene" }), -32602),
        ("scenelang.repair", json!({ "uri": uri, "line": 0 }), -32803),
    ] {
        let ask = json!({ "command": command, "arguments": [argument] });
        assert_eq!(client.refused("workspace/executeCommand", ask).0, code, "{command}");
    }
    client.set(&uri, "object a");
    let ask = json!({ "command": "scenelang.solve", "arguments": [of] });
    assert!(client.refused("workspace/executeCommand", ask).1.contains("errors"));
    client.stop();
}

/// A room in which a chair must stand.
const STUDY: &str = "region r;\nr.pos <- vec3(0, 0, 0);\nr.scale <- vec3(3, 2.5, 3);\nobject chair;\nchair.category <- \"chair\";\nassert inside(chair, r);\n";

/// An editor that is asked to make a file makes it empty, and keeps what is in it in a buffer: so the file is written, whole,
/// whether the editor could make it or not.
#[test]
fn a_layout_that_is_not_there_is_written() {
    for applies in [true, false] {
        let (folder, ..) = room();
        let mut can = usual();
        can["workspace"]["applyEdit"] = applies.into();
        let mut client = Client::start_with(folder.path(), can, Value::Null);
        let uri = client.open("new.scene", STUDY);
        client.published(&uri);
        let file = folder.path().join("new.layout.json");
        let solved = run(&mut client, "scenelang.solve", json!({ "uri": uri }));
        assert!(client.asked.iter().all(|m| m["method"] != "workspace/applyEdit"));
        let text = std::fs::read_to_string(&file).unwrap();
        assert!(text.contains("\"scene\": \"new.scene\"") && text.contains("\"chair\""), "{text}");
        // And it is what counts from then on.
        let total = solved["total"].clone();
        client.until("a verdict on it", |c| {
            let said = c.told.iter().rev().find(|m| m["method"] == "scenelang/changed")?;
            (said["params"]["holds"] == total && said["params"]["layout"].is_string()).then_some(())
        });
        client.stop();
    }
}

/// Solving again begins with the layout that is there. Where nothing has to move nothing is edited, since editors take an
/// empty edit for a failure; whoever wants another room asks for one.
#[test]
fn solving_again_starts_from_what_is_there() {
    let (folder, ..) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("new.scene", STUDY);
    client.published(&uri);
    run(&mut client, "scenelang.solve", json!({ "uri": uri }));
    let layout = std::fs::read_to_string(folder.path().join("new.layout.json")).unwrap();
    let data = client.open("new.layout.json", &layout);
    client.published(&data);
    let again = run(&mut client, "scenelang.solve", json!({ "uri": uri }));
    assert_eq!(again["holds"], again["total"], "{again}");
    assert!(again["message"].as_str().unwrap().contains("where it was"), "{again}");
    assert!(client.asked.iter().all(|m| m["method"] != "workspace/applyEdit"));

    let anew = run(&mut client, "scenelang.solveAnew", json!({ "uri": uri }));
    assert_eq!(anew["holds"], anew["total"]);
    let other = edited(&layout, edits_of(&asked(&client), &data));
    let (before, after): (Value, Value) =
        (serde_json::from_str(&layout).unwrap(), serde_json::from_str(&other).unwrap());
    assert_ne!(before["objects"]["chair"]["pos"], after["objects"]["chair"]["pos"]);
    assert_eq!((&before["seed"], &after["seed"]), (&json!(0), &json!(1)));
    client.stop();
}

/// What is locked stays, and so does all that is not among what alone may move.
#[test]
fn some_objects_stay_where_they_are() {
    let (folder, ..) = room();
    let mut client = Client::start(folder.path());
    let text = format!("{STUDY}object lamp;\nlamp.category <- \"lamp\";\nassert inside(lamp, r);\n");
    let uri = client.open("new.scene", &text);
    client.published(&uri);
    run(&mut client, "scenelang.solve", json!({ "uri": uri }));
    let layout = std::fs::read_to_string(folder.path().join("new.layout.json")).unwrap();
    let data = client.open("new.layout.json", &layout);
    client.published(&data);
    let places = |text: &str| -> Vec<Value> {
        let layout: Value = serde_json::from_str(text).unwrap();
        ["chair", "lamp"].map(|name| layout["objects"][name]["pos"].clone()).to_vec()
    };
    let before = places(&layout);
    let locked = |objects: Value| json!({ "uri": uri, "objects": objects });
    for (hold, stays, goes) in
        [(json!({ "lock": ["chair"] }), 0, 1), (json!({ "only": ["chair"] }), 1, 0), (json!({}), 0, 1)]
    {
        // What the editor has said is locked counts for every command; what the program does not have, for none.
        let told = if hold == json!({}) { json!(["chair", "ghost"]) } else { json!([]) };
        client.tell("scenelang/lock", locked(told));
        let mut argument = json!({ "uri": uri, "seed": 7 });
        hold.as_object().unwrap().iter().for_each(|(key, names)| argument[key] = names.clone());
        let solved = run(&mut client, "scenelang.solveAnew", argument);
        assert_eq!(solved["holds"], solved["total"], "{solved}");
        let after = places(&edited(&layout, edits_of(&asked(&client), &data)));
        assert_eq!(after[stays], before[stays], "{hold}");
        assert_ne!(after[goes], before[goes], "{hold}");
        client.set(&data, &layout);
        client.next_verdict(&uri);
    }
    let ask = json!({ "command": "scenelang.solve", "arguments": [{ "uri": uri, "lock": ["ghost"] }] });
    assert!(client.refused("workspace/executeCommand", ask).1.contains("no `ghost`"));
    client.stop();
}

/// Each alternative has a picture, and its seed makes it again.
#[test]
fn alternatives_are_made_again_by_their_seeds() {
    let (folder, ..) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("new.scene", STUDY);
    client.published(&uri);
    run(&mut client, "scenelang.solve", json!({ "uri": uri }));
    let found = run(&mut client, "scenelang.alternatives", json!({ "uri": uri }))["alternatives"].clone();
    let found = found.as_array().unwrap();
    assert_eq!(found.len(), 4);
    for one in found {
        assert_eq!(one["holds"], one["total"], "{one}");
        assert!(one["plan"].as_str().unwrap().starts_with("<svg"), "{one}");
    }
    let pictures: std::collections::BTreeSet<&str> = found.iter().map(|one| one["plan"].as_str().unwrap()).collect();
    assert!(pictures.len() > 1, "they differ");
    let chosen = &found[1];
    let solved = run(&mut client, "scenelang.solveAnew", json!({ "uri": uri, "seed": chosen["seed"] }));
    assert_eq!(solved["holds"], chosen["holds"]);
    let seen = client.ask("scenelang/scene", json!({ "uri": uri }));
    assert_eq!(seen["data"]["plan"], chosen["plan"], "the same room");
    // What is locked stays in the pictures, too, so that the room that is chosen is the one that was seen.
    client.set(&uri, &format!("{STUDY}object lamp;\nlamp.category <- \"lamp\";\nassert inside(lamp, r);\n"));
    client.published(&uri);
    run(&mut client, "scenelang.solve", json!({ "uri": uri }));
    let lock = json!(["chair"]);
    let found = run(&mut client, "scenelang.alternatives", json!({ "uri": uri, "lock": lock }))["alternatives"].clone();
    let chosen = &found[2];
    run(&mut client, "scenelang.solveAnew", json!({ "uri": uri, "seed": chosen["seed"], "lock": lock }));
    let seen = client.ask("scenelang/scene", json!({ "uri": uri }));
    assert_eq!(seen["data"]["plan"], chosen["plan"], "the same room");
    client.stop();
}

/// An object that was added is placed, and nothing else is moved.
#[test]
fn an_object_is_placed_among_the_others() {
    let (folder, ..) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("new.scene", STUDY);
    client.published(&uri);
    run(&mut client, "scenelang.solve", json!({ "uri": uri }));
    let layout = std::fs::read_to_string(folder.path().join("new.layout.json")).unwrap();
    let data = client.open("new.layout.json", &layout);
    client.published(&data);
    client.set(&uri, &format!("{STUDY}object vase[2];\nvase[0].category <- \"vase\";\nassert inside(vase[1], r);\n"));
    client.published(&uri);
    let lenses = client.ask("textDocument/codeLens", json!({ "textDocument": { "uri": uri } }));
    let lens = lenses.as_array().unwrap().iter().find(|l| l["command"]["title"] == "Place `vase`").expect("a lens");
    let argument = json!({ "uri": uri, "object": "vase" });
    assert_eq!(lens["command"]["arguments"], json!([argument]));
    let start = lens["range"]["start"].clone();
    let actions = client.ask(
        "textDocument/codeAction",
        json!({ "textDocument": { "uri": uri }, "range": { "start": start, "end": start }, "context": { "diagnostics": [] } }),
    );
    assert!(actions.as_array().unwrap().iter().any(|a| a["command"]["arguments"] == json!([argument])), "{actions}");

    let placed = run(&mut client, "scenelang.place", argument);
    assert!(placed["message"].as_str().unwrap().starts_with("placed `vase`: "), "{placed}");
    assert_eq!(placed["holds"], placed["total"], "{placed}");
    let after: Value = serde_json::from_str(&edited(&layout, edits_of(&asked(&client), &data))).unwrap();
    let before: Value = serde_json::from_str(&layout).unwrap();
    assert_eq!(after["objects"]["chair"], before["objects"]["chair"]);
    assert!(["vase[0]", "vase[1]"].iter().all(|name| after["objects"][name]["pos"].is_array()), "{after}");
    for (argument, why) in
        [(json!({ "uri": uri }), "does not say which object"), (json!({ "uri": uri, "object": "rug" }), "no `rug`")]
    {
        let ask = json!({ "command": "scenelang.place", "arguments": [argument] });
        assert!(client.refused("workspace/executeCommand", ask).1.contains(why), "{why}");
    }
    client.stop();
}

/// Without a layout there is a room all the same: nothing is written before someone solves, and what is added moves nothing.
#[test]
fn a_program_without_a_layout_has_a_room() {
    let (folder, ..) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("new.scene", STUDY);
    client.published(&uri);
    let place = |room: &Value, name: &str| {
        let objects = room["data"]["objects"].as_array().unwrap();
        objects.iter().find(|o| o["name"] == name).map(|o| (o["pos"].clone(), o["rot"].clone())).expect("it is placed")
    };
    let first = client.ask("scenelang/provisional", json!({ "uri": uri }));
    assert_eq!(first["holds"], first["total"], "{first}");
    assert!(!folder.path().join("new.layout.json").exists());
    client.set(&uri, &format!("{STUDY}object vase;\nvase.category <- \"vase\";\nassert inside(vase, r);\n"));
    client.published(&uri);
    let second = client.ask("scenelang/provisional", json!({ "uri": uri, "known": first["data"]["shape"] }));
    assert_eq!(second["holds"], second["total"], "{second}");
    assert_eq!(place(&second, "chair"), place(&first, "chair"));
    place(&second, "vase");
    // What is written is what was seen.
    run(&mut client, "scenelang.solve", json!({ "uri": uri }));
    assert!(folder.path().join("new.layout.json").exists());
    client.published(&uri);
    let solved = client.ask("scenelang/scene", json!({ "uri": uri }));
    assert_eq!((place(&solved, "chair"), place(&solved, "vase")), (place(&second, "chair"), place(&second, "vase")));
    assert!(client.refused("scenelang/provisional", json!({ "uri": uri })).1.contains("has a layout"));
    // A program with errors has none.
    let broken = client.open("broken.scene", "object chair");
    client.published(&broken);
    assert!(client.refused("scenelang/provisional", json!({ "uri": broken })).1.contains("errors"));
    client.stop();
}

#[test]
fn the_scene_is_what_the_viewer_reads() {
    let (folder, scene, layout) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &scene);
    let found = client.ask("scenelang/scene", json!({ "uri": uri }));
    assert_eq!((&found["holds"], &found["total"]), (&json!(9), &json!(12)));
    assert_eq!(found["layout"], client.uri("room.layout.json"));
    assert_eq!(found["data"]["format"], "scenelang.preview/1");
    assert!(found["data"]["glb"].as_str().unwrap().len() > 1000);
    // Who has the geometry is told of places only, as long as things are only moved.
    let shape = found["data"]["shape"].clone();
    let again = client.ask("scenelang/scene", json!({ "uri": uri, "known": shape }));
    assert_eq!((&again["data"]["glb"], &again["data"]["shape"]), (&Value::Null, &shape));
    let data = client.open("room.layout.json", &layout.replace("[0.9, 0, -1.5]", "[1.03, 0, -1.5]"));
    let moved = client.ask("scenelang/scene", json!({ "uri": uri, "known": shape }))["data"].clone();
    assert_eq!((&moved["glb"], &moved["shape"]), (&Value::Null, &shape));
    let placed = moved["objects"].as_array().unwrap().iter().find(|o| o["name"] == "stand[1]").unwrap();
    assert_eq!(placed["pos"], json!([1.03, 0.0, -1.5]));
    client.set(&data, &layout.replace("[1.6, 0.55, 2]", "[1.4, 0.55, 2]"));
    let other = client.ask("scenelang/scene", json!({ "uri": uri, "known": shape }))["data"].clone();
    assert!(other["glb"].is_string() && other["shape"] != shape);
    client.tell("textDocument/didClose", json!({ "textDocument": { "uri": data } }));
    let names: Vec<&str> = found["objects"].as_array().unwrap().iter().map(|o| o["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["bed", "stand", "lamp"]);
    let rows = found["constraints"].as_array().unwrap();
    let fails = rows.iter().find(|r| r["text"].as_str().unwrap().starts_with("gap(")).unwrap();
    assert_eq!((&fails["state"], &fails["unit"]), (&json!("fails"), &json!("m")));
    assert_eq!(fails["id"], "room.scene:34:1");
    assert_eq!(fails["line"], 33);
    assert_eq!(fails["objects"], json!(["bed", "stand[1]"]));
    assert!(rows.iter().any(|r| r["id"] == "P-COLLIDE:bed:stand[1]"));

    // A drag is judged step by step, and nothing is done until it ends.
    let state = |answer: &Value, id: &str| {
        answer["constraints"].as_array().unwrap().iter().find(|r| r["id"] == id).unwrap()["state"].clone()
    };
    let mut step = json!({ "uri": uri, "object": "stand[1]", "pos": [1.2, 0, -1.5], "commit": false });
    let answer = client.ask("scenelang/move", step.clone());
    assert_eq!((state(&answer, "room.scene:34:1"), &answer["physical"]), (json!("holds"), &json!([])));
    assert_eq!(state(&answer, "room.scene:32:1"), "fails");
    step["pos"] = json!([1.05, 0, -1.5]);
    let answer = client.ask("scenelang/move", step.clone());
    assert_eq!(state(&answer, "room.scene:32:1"), "holds");
    // Another object: the first is where it was.
    let other = json!({ "uri": uri, "object": "lamp", "pos": [-1.05, 0.5, -1.5], "rot": [0, 90, 0], "commit": false });
    assert_eq!(client.ask("scenelang/move", other)["holds"], 9);
    assert!(client.asked.iter().all(|m| m["method"] != "workspace/applyEdit"));
    step["commit"] = true.into();
    let answer = client.ask("scenelang/move", step);
    assert_eq!(state(&answer, "room.scene:34:1"), "holds");
    let data = client.uri("room.layout.json");
    let after = edited(&layout, edits_of(&asked(&client), &data));
    assert_eq!(after, layout.replace("[0.9, 0, -1.5]", "[1.05, 0, -1.5]"), "only the position");
    for bad in [
        json!({ "uri": uri, "object": "nobody", "pos": [0, 0, 0] }),
        json!({ "uri": uri, "object": "lamp", "pos": [0, 0] }),
        json!({ "uri": uri, "object": "lamp", "pos": [1e300, 0, 0] }),
        json!({ "uri": "file:///x.scene", "object": "lamp", "pos": [0, 0, 0] }),
    ] {
        assert_eq!(client.refused("scenelang/move", bad).0, -32602);
    }
    client.stop();
}

#[test]
fn what_a_program_becomes() {
    let (folder, scene, _) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &scene);
    for (form, part) in
        [("syntax", "Declaration"), ("hir", "lamp : Object"), ("constraints", "room.scene:34:1: assert")]
    {
        let text =
            client.ask("scenelang/forms", json!({ "uri": uri, "form": form }))["text"].as_str().unwrap().to_owned();
        assert!(text.contains(part), "{form}: {text}");
    }
    assert_eq!(client.refused("scenelang/forms", json!({ "uri": uri, "form": "poem" })).0, -32602);
    client.stop();
}

/// What was selected in rooms beside the editor.
static SELECTED: Mutex<Vec<String>> = Mutex::new(Vec::new());

fn show(path: &std::path::Path) -> Result<Beside, String> {
    let name = path.file_name().unwrap().to_string_lossy().into_owned();
    let select = Box::new(|what: &str| {
        SELECTED.lock().unwrap().push(what.to_owned());
        // The page is closed after a while.
        what != "stand[1]"
    });
    if name == "broken.scene" { Err("nobody shows it".to_owned()) } else { Ok(Beside { address: name, select }) }
}

#[test]
fn a_room_beside_follows_the_cursor() {
    let (folder, scene, _) = room();
    let silent = Client::silent(folder.path(), Setup { show: Some(show), ..Setup::default() });
    let mut client = Client::introduced(silent, usual(), Value::Null);
    let uri = client.open("room.scene", &scene);
    client.published(&uri);
    let place = |marked: &str| json!({ "textDocument": { "uri": uri }, "position": at(&scene, marked) });
    // Nothing is shown yet.
    client.ask("textDocument/documentHighlight", place("object |lamp"));
    // Some editors cannot give a command an argument.
    let ask = json!({ "command": "scenelang.view" });
    let answer = client.ask("workspace/executeCommand", ask);
    assert_eq!(answer["message"], "the room is shown at room.layout.json");
    client.until("it to be said", |c| {
        c.told
            .iter()
            .any(|m| m["method"] == "window/showMessage" && m["params"]["message"] == answer["message"])
            .then_some(())
    });
    let marks = ["object |bed", "object |lamp", "on(lamp, |stand[0]", "gap(|stand[1]"];
    for (i, marked) in marks.into_iter().enumerate() {
        client.ask("textDocument/documentHighlight", place(marked));
        // It is selected beside the answer; the server gets round to that while it is asked other things.
        while SELECTED.lock().unwrap().len() <= i {
            run(&mut client, "scenelang.check", json!({ "uri": uri }));
        }
    }
    // Nobody listens any more.
    client.ask("textDocument/documentHighlight", place("object |bed"));
    run(&mut client, "scenelang.check", json!({ "uri": uri }));
    assert_eq!(*SELECTED.lock().unwrap(), ["bed", "lamp", "stand[0]", "stand[1]"]);

    let broken = client.open("broken.scene", "object sofa;\n");
    let ask = json!({ "command": "scenelang.view", "arguments": [{ "uri": broken }] });
    assert_eq!(client.refused("workspace/executeCommand", ask), (-32803, "nobody shows it".to_owned()));
    client.stop();
}

/// Who looks for a layout of a program that has none is told why, with the statements that contradict each other, and without a
/// search: solving anew, beginning with a layout, with several seeds, or for a room that is only shown.
#[test]
fn what_cannot_be_is_not_searched_for() {
    let (folder, scene, _) = room();
    let without = STUDY.replace("\nassert", "\nassert chair.pos.x > 1;\nassert chair.pos.x < 0;\nassert");
    let with = format!("{scene}assert bed.pos.x > 1;\nassert bed.pos.x < 0;\n");
    let mut client = Client::start(folder.path());
    for (file, text, object) in [("new.scene", &without, "chair"), ("room.scene", &with, "bed")] {
        let uri = client.open(file, text);
        client.published(&uri);
        let of = json!({ "uri": uri });
        for command in ["scenelang.solve", "scenelang.solveAnew", "scenelang.alternatives"] {
            let ask = json!({ "command": command, "arguments": [of] });
            let (code, why) = client.refused("workspace/executeCommand", ask);
            assert_eq!(code, -32803);
            for member in ["> 1", "< 0"] {
                assert!(why.contains(&format!("`{object}.pos.x {member}` (line ")), "{command}: {why}");
            }
        }
    }
    let (_, why) = client.refused("scenelang/provisional", json!({ "uri": client.uri("new.scene") }));
    assert!(why.starts_with("no layout satisfies all of these statements: "), "{why}");
    client.stop();
}
