//! What changes outside a document reaches it: layouts, imports, settings, the editor's configuration, folders.

use crate::client::{Client, pulling, room, usual};
use serde_json::{Value, json};

fn codes(marks: &[Value]) -> Vec<String> {
    let mut out: Vec<String> = marks.iter().map(|m| m["code"].as_str().unwrap().to_owned()).collect();
    out.sort();
    out
}

fn changed(client: &mut Client, file: &str) {
    let uri = client.uri(file);
    client.tell("workspace/didChangeWatchedFiles", json!({ "changes": [{ "uri": uri, "type": 2 }] }));
}

#[test]
fn a_layout_that_another_program_writes_is_seen() {
    let (folder, scene, layout) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &scene);
    let verdict = client.next_verdict(&uri);
    assert_eq!(verdict["layout"], client.uri("room.layout.json"));
    assert_eq!((verdict["holds"].as_u64(), verdict["total"].as_u64()), (Some(9), Some(12)));
    assert_eq!(codes(&client.published(&uri)), ["V0101", "V0102", "V0102", "V0106"]);
    client.until("files to be watched", |c| {
        c.asked.iter().find(|m| m["method"] == "client/registerCapability").map(|_| ())
    });

    std::fs::write(folder.path().join("room.layout.json"), layout.replace("[0.9, 0, -1.5]", "[1.03, 0, -1.5]"))
        .unwrap();
    changed(&mut client, "room.layout.json");
    assert_eq!(client.next_verdict(&uri)["holds"], 10);
    assert_eq!(codes(&client.published(&uri)), ["V0106"]);
    client.until("hints to be asked for again", |c| {
        c.asked.iter().find(|m| m["method"] == "workspace/inlayHint/refresh").map(|_| ())
    });

    // Open in the editor it counts as it is there, key by key; what is wrong with it is marked in it.
    let data = client.open("room.layout.json", &layout.replace("\"lamp\"", "\"lmap\""));
    client.next_verdict(&uri);
    let marks = client.published(&data);
    assert_eq!(codes(&marks), ["E0506", "E0507"], "{marks:?}");
    client.set(&data, &layout.replace("[0.9, 0, -1.5]", "[1.2, 0, -1.5]"));
    assert_eq!(client.next_verdict(&uri)["holds"], 9);
    assert_eq!(codes(&client.published(&data)), [""; 0]);
    // Closed again, the disk counts.
    client.tell("textDocument/didClose", json!({ "textDocument": { "uri": data } }));
    assert_eq!(client.next_verdict(&uri)["holds"], 10);

    std::fs::remove_file(folder.path().join("room.layout.json")).unwrap();
    changed(&mut client, "room.layout.json");
    let verdict = client.next_verdict(&uri);
    assert_eq!((verdict["layout"].clone(), verdict["total"].clone()), (Value::Null, json!(0)));
    assert_eq!(client.stop(), 0);
}

/// The same for a client that does not say what changes on disk.
#[test]
fn files_are_looked_at_where_nobody_watches_them() {
    let (folder, scene, layout) = room();
    let mut can = usual();
    can["workspace"]["didChangeWatchedFiles"] = json!({});
    let mut client = Client::start_with(folder.path(), can, Value::Null);
    let uri = client.open("room.scene", &scene);
    assert_eq!(client.next_verdict(&uri)["holds"], 9);
    let until = |client: &mut Client, holds: u64| while client.next_verdict(&uri)["holds"] != holds {};
    let wrote = |file: &str, text: &str| std::fs::write(folder.path().join(file), text).unwrap();
    wrote("room.layout.json", &layout.replace("[0.9, 0, -1.5]", "[1.03, 0, -1.5] "));
    until(&mut client, 10);
    wrote("parts.scene", "predicate atHand(Object a, Object b) := gap(a, b) <= 0.001;\n");
    until(&mut client, 9);
    std::fs::remove_file(folder.path().join("room.layout.json")).unwrap();
    until(&mut client, 0);
    wrote("room.layout.json", &layout);
    until(&mut client, 8);
    assert_eq!(client.stop(), 0);
}

#[test]
fn what_is_imported_counts_as_it_is_open() {
    let (folder, scene, _) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &scene);
    client.next_verdict(&uri);
    let parts = client.open("parts.scene", "predicate atHand(Object a, Object b) := gap(a, b) <= 0.01;\n");
    assert_eq!(client.next_verdict(&uri)["holds"], 8);
    client.set(&parts, "predicate atHand(Object a) := a.top > 0;\n");
    client.until("the call to be wrong", |c| {
        let marks = c.published(&uri);
        marks.iter().any(|m| m["code"] == "E0303").then_some(())
    });
    assert_eq!(client.stop(), 0);
}

#[test]
fn settings_of_the_workspace_and_of_the_editor_count() {
    let (folder, scene, layout) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &scene);
    client.next_verdict(&uri);
    std::fs::write(folder.path().join("scenelang.toml"), "physics = false\n").unwrap();
    changed(&mut client, "scenelang.toml");
    assert_eq!(client.next_verdict(&uri)["total"], 11);
    std::fs::write(folder.path().join("scenelang.toml"), "phisics = false\n").unwrap();
    changed(&mut client, "scenelang.toml");
    client.next_verdict(&uri);
    let toml = client.uri("scenelang.toml");
    assert_eq!(codes(&client.published(&toml)), ["E0007"]);
    // As on the command line, nothing is judged by settings that cannot be used.
    assert!(client.published(&uri).is_empty());
    std::fs::write(folder.path().join("scenelang.toml"), "").unwrap();
    changed(&mut client, "scenelang.toml");
    client.next_verdict(&uri);

    // Another place for layouts, asked for when told that something has changed.
    std::fs::create_dir(folder.path().join("out")).unwrap();
    std::fs::write(
        folder.path().join("out/room.json"),
        layout.replace("room.scene", "../room.scene").replace("[0.9, 0, -1.5]", "[1.03, 0, -1.5]"),
    )
    .unwrap();
    client.settings = json!({ "layout": "out/{stem}.json", "inlayHints": { "sizes": false, "values": false } });
    client.tell("workspace/didChangeConfiguration", json!({ "settings": null }));
    let verdict = client.next_verdict(&uri);
    assert_eq!(verdict["layout"], client.uri("out/room.json"));
    assert_eq!(verdict["holds"], 10);
    let end = json!({ "line": 999, "character": 0 });
    let all =
        json!({ "textDocument": { "uri": uri }, "range": { "start": { "line": 0, "character": 0 }, "end": end } });
    let hints = client.ask("textDocument/inlayHint", all.clone());
    let labels: Vec<&str> = hints.as_array().unwrap().iter().map(|h| h["label"].as_str().unwrap()).collect();
    assert!(labels.iter().all(|l| !l.contains('×') && !l.starts_with('=')) && labels.len() > 3, "{labels:?}");
    let settings = json!({ "scenelang": { "layout": "out/{stem}.json", "inlayHints": { "margins": false } } });
    client.tell("workspace/didChangeConfiguration", json!({ "settings": settings }));
    client.next_verdict(&uri);
    let hints = client.ask("textDocument/inlayHint", all);
    let labels: Vec<&str> = hints.as_array().unwrap().iter().map(|h| h["label"].as_str().unwrap()).collect();
    assert!(labels.iter().all(|l| l.contains('×') || l.starts_with('=')) && labels.contains(&"= 0.02"), "{labels:?}");
    assert_eq!(client.stop(), 0);
}

#[test]
fn clients_that_ask_are_told_when_to_ask_again() {
    let (folder, scene, layout) = room();
    let mut client = Client::start_with(folder.path(), pulling(), Value::Null);
    let uri = client.open("room.scene", &scene);
    let document = json!({ "textDocument": { "uri": uri } });
    let first = client.ask("textDocument/diagnostic", document);
    assert_eq!(codes(first["items"].as_array().unwrap()), ["V0101", "V0102", "V0102", "V0106"]);
    let again = json!({ "textDocument": { "uri": uri }, "previousResultId": first["resultId"] });
    assert_eq!(client.ask("textDocument/diagnostic", again.clone())["kind"], "unchanged");
    std::fs::write(folder.path().join("room.layout.json"), layout.replace("[0.9, 0, -1.5]", "[1.03, 0, -1.5]"))
        .unwrap();
    changed(&mut client, "room.layout.json");
    client.until("to be told", |c| c.asked.iter().find(|m| m["method"] == "workspace/diagnostic/refresh").map(|_| ()));
    let second = client.ask("textDocument/diagnostic", again);
    assert_eq!(codes(second["items"].as_array().unwrap()), ["V0106"]);
    // Nothing is said twice: what is asked for is not published.
    let published =
        client.told.iter().filter(|m| m["params"]["uri"] == uri && m["method"] == "textDocument/publishDiagnostics");
    assert!(published.flat_map(|m| m["params"]["diagnostics"].as_array().unwrap()).all(|d| d["code"] != "V0101"));
    assert_eq!(client.stop(), 0);
}

#[test]
fn the_workspace_is_reported_and_then_waited_for() {
    let (folder, scene, _) = room();
    std::fs::create_dir(folder.path().join("more")).unwrap();
    std::fs::write(folder.path().join("more/bad.scene"), "object a;\nassert a.tpo > 1;\n").unwrap();
    let mut client = Client::start_with(folder.path(), pulling(), Value::Null);
    let none = json!({ "identifier": "scenelang", "previousResultIds": [] });
    let report = client.ask("workspace/diagnostic", none);
    let items = report["items"].as_array().unwrap();
    let of = |file: &str| items.iter().find(|i| i["uri"].as_str().unwrap().ends_with(file)).unwrap();
    assert_eq!(codes(of("more/bad.scene")["items"].as_array().unwrap()), ["E0207"]);
    assert_eq!(codes(of("room.scene")["items"].as_array().unwrap()), ["V0101", "V0102", "V0102", "V0106"]);
    let known: Vec<Value> = items.iter().map(|i| json!({ "uri": i["uri"], "value": i["resultId"] })).collect();
    let id = client.begin("workspace/diagnostic", json!({ "previousResultIds": known }));
    std::fs::write(folder.path().join("more/bad.scene"), "object a;\nassert a.top > 1;\n").unwrap();
    changed(&mut client, "more/bad.scene");
    let report = client.end(id);
    let items = report["result"]["items"].as_array().unwrap();
    let kinds: Vec<&str> = items.iter().map(|i| i["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds.iter().filter(|k| **k == "unchanged").count(), items.len() - 1, "{report}");
    // A second folder comes along.
    let (other, ..) = room();
    std::fs::write(other.path().join("room.scene"), &scene).unwrap();
    let event =
        json!({ "added": [{ "uri": format!("file://{}", other.path().display()), "name": "other" }], "removed": [] });
    client.tell("workspace/didChangeWorkspaceFolders", json!({ "event": event }));
    let found = client.ask("workspace/symbol", json!({ "query": "stnd" }));
    let places: Vec<&str> = found.as_array().unwrap().iter().map(|s| s["location"]["uri"].as_str().unwrap()).collect();
    assert_eq!(places.len(), 2, "{found}");
    assert_eq!(client.stop(), 0);
}
