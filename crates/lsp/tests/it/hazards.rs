//! What goes wrong on the transport by itself: order, waiting for the client, long work.

use crate::client::{Client, at, room};
use serde_json::{Value, json};

/// Four hundred edits in a row, each of which must be made before the next, then a question about the last.
#[test]
fn edits_are_made_in_their_order() {
    let (folder, ..) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("order.scene", "object a;\n");
    for n in 0..400 {
        let start = json!({ "line": 0, "character": "object a".len() + n });
        let digit = char::from(b'0' + (n % 10) as u8).to_string();
        client.change(&uri, json!([{ "range": { "start": start, "end": start }, "text": digit }]));
    }
    let name: String = std::iter::once('a').chain((0..400).map(|n| char::from(b'0' + (n % 10) as u8))).collect();
    let symbols = client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri } }));
    assert_eq!(symbols[0]["name"], name);
    // What was published last is about the last version, and versions never went back.
    client.published(&uri);
    let about = |m: &&Value| m["method"] == "textDocument/publishDiagnostics" && m["params"]["uri"] == uri;
    let versions: Vec<i64> =
        client.told.iter().filter(about).map(|m| m["params"]["version"].as_i64().unwrap()).collect();
    assert!(versions.is_sorted(), "{versions:?}");
    assert_eq!(versions.last(), Some(&401));
    assert_eq!(client.stop(), 0);
}

/// Work that waits for the client, while the client sends a lot before it answers.
#[test]
fn a_client_that_answers_late_stops_nothing() {
    let (folder, scene, _) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &scene);
    client.published(&uri);
    client.mute = true;
    let solve = json!({ "command": "scenelang.repairAll", "arguments": [{ "uri": uri }] });
    let waiting: Vec<i64> = (0..8).map(|_| client.begin("workspace/executeCommand", solve.clone())).collect();
    client.until("edits to be made", |c| {
        let edits = c.asked.iter().filter(|m| m["method"] == "workspace/applyEdit").count();
        (edits == 8).then_some(())
    });
    for _ in 0..300 {
        client.tell("$/nothing", json!({}));
    }
    let hover = json!({ "textDocument": { "uri": uri }, "position": at(&scene, "object |bed") });
    assert!(client.ask("textDocument/hover", hover)["contents"]["value"].as_str().unwrap().contains("object bed"));
    client.mute = false;
    for message in client.asked.clone() {
        let result = if message["method"] == "workspace/applyEdit" { json!({ "applied": true }) } else { Value::Null };
        client.send(json!({ "id": message["id"], "result": result }));
    }
    for id in waiting {
        let answer = client.end(id);
        assert!(answer["result"]["message"].as_str().unwrap().contains("stand[1]"), "{answer}");
    }
    assert_eq!(client.stop(), 0);
}

/// Long work does not stand in the way of a question, and can be cancelled in two ways.
#[test]
fn long_work_lets_others_pass_and_ends_when_it_is_not_wanted() {
    let (folder, ..) = room();
    let mut client = Client::start(folder.path());
    // Many things in a room that is too small for them: the search goes on for long.
    let mut scene = "region r; r.pos <- vec3(0, 0, 0); r.scale <- vec3(6, 3, 6);\n".to_owned();
    for i in 0..60 {
        scene += &format!("object o{i}; o{i}.dimensions <- vec3(0.9, 0.5, 0.9); assert inside(o{i}, r);\n");
    }
    let uri = client.open("full.scene", &scene);
    client.published(&uri);
    for how in ["request", "progress"] {
        let solve = json!({
            "command": "scenelang.solve", "arguments": [{ "uri": uri }], "workDoneToken": format!("t-{how}"),
        });
        let id = client.begin("workspace/executeCommand", solve);
        client.until("progress", |c| {
            let of_ours = |m: &&Value| m["method"] == "$/progress" && m["params"]["token"] == format!("t-{how}");
            c.told.iter().find(of_ours).map(|_| ())
        });
        let hover = json!({ "textDocument": { "uri": uri }, "position": at(&scene, "object |o7;") });
        assert!(client.ask("textDocument/hover", hover).is_object());
        match how {
            "request" => client.tell("$/cancelRequest", json!({ "id": id })),
            _ => client.tell("window/workDoneProgress/cancel", json!({ "token": format!("t-{how}") })),
        }
        assert_eq!(client.end(id)["error"]["code"], -32800, "{how}");
    }
    assert!(client.asked.iter().all(|m| m["method"] != "workspace/applyEdit"), "nothing is done after all");
    assert!(!folder.path().join("full.layout.json").exists());
    assert_eq!(client.stop(), 0);
}
