//! Beginning and end, and messages that are none.

use crate::client::{Client, room, usual};
use scenelang_lsp::{Recorder, Setup, replay};
use serde_json::{Value, json};

#[test]
fn a_session_has_a_beginning_and_an_end() {
    let (folder, ..) = room();
    let mut client = Client::silent(folder.path(), Setup::default());
    let hover = json!({ "textDocument": { "uri": "file:///x" }, "position": { "line": 0, "character": 0 } });
    assert_eq!(client.refused("textDocument/hover", hover).0, -32002);
    let mut client = Client::introduced(client, usual(), Value::Null);
    assert_eq!(client.refused("initialize", json!({ "capabilities": {} })).0, -32600);
    assert_eq!(client.refused("textDocument/nothing", json!({})).0, -32601);
    assert_eq!(client.refused("$/nothing", json!({})).0, -32601);
    client.tell("$/nothing", json!({}));
    client.tell("nothing", json!([1, 2]));
    assert_eq!(client.ask("shutdown", Value::Null), Value::Null);
    assert_eq!(client.refused("workspace/symbol", json!({ "query": "" })).0, -32600);
    assert_eq!(client.exit(), 0);
}

#[test]
fn exit_codes() {
    let (folder, ..) = room();
    assert_eq!(Client::start(folder.path()).stop(), 0);
    assert_eq!(Client::start(folder.path()).exit(), 1);
    assert_eq!(Client::start(folder.path()).hang_up(), 1);
    let mut client = Client::start(folder.path());
    client.ask("shutdown", Value::Null);
    assert_eq!(client.hang_up(), 0);
}

#[test]
fn what_is_no_message_is_answered_and_survived() {
    let (folder, ..) = room();
    let mut client = Client::start(folder.path());
    for bad in ["{not json", "[]", "{}", "3", "{\"jsonrpc\":\"2.0\",\"id\":{},\"method\":\"x\"}", "\u{fffd}"] {
        client.raw(format!("Content-Length: {}\r\n\r\n{bad}", bad.len()).as_bytes());
        assert_eq!(client.nobody()["error"]["code"], -32700, "{bad}");
    }
    client.raw(b"rubbish\r\n\r\ncontent-length: 2\r\n\r\n{}");
    client.nobody();
    for params in [json!({}), json!([1]), json!({ "textDocument": 3 }), Value::Null] {
        assert_eq!(client.refused("textDocument/hover", params).0, -32602);
    }
    client.tell("textDocument/didOpen", json!({ "textDocument": 5 }));
    client.tell("textDocument/didChange", json!([]));
    client.tell("$/cancelRequest", json!({ "id": 999 }));
    client.tell("$/cancelRequest", Value::Null);
    assert_eq!(client.stop(), 0);
}

#[test]
fn a_session_can_be_recorded_and_played_again() {
    let (folder, scene, _) = room();
    let file = folder.path().join("session.jsonl");
    let setup = Setup { record: Some(Recorder::new(&file).unwrap()), ..Setup::default() };
    let mut client = Client::introduced(Client::silent(folder.path(), setup), usual(), Value::Null);
    let uri = client.open("room.scene", &scene);
    client.published(&uri);
    let symbols = client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri } }));
    client.stop();

    let lines = std::fs::read_to_string(&file).unwrap();
    let from = |who: &str| lines.lines().filter(|l| l.starts_with(&format!("{{\"from\":\"{who}\""))).count();
    assert!(from("client") >= 6 && from("server") >= 4, "{lines}");

    // The same questions get the same answers.
    let (reads, writes) = std::io::pipe().unwrap();
    let played = std::thread::spawn(move || std::io::read_to_string(reads).unwrap());
    assert_eq!(replay(&file, writes).unwrap(), 0);
    let said = played.join().unwrap();
    assert!(said.contains(&symbols.to_string()), "{said}");
    std::fs::write(&file, "{}\n").unwrap();
    assert!(replay(&file, Vec::new()).is_err());
}

/// What the server says that it can is what the table of `docs/editors.md` says, and no more.
#[test]
fn the_document_lists_what_the_server_can() {
    let (folder, ..) = room();
    let client = Client::start_with(folder.path(), crate::client::pulling(), Value::Null);
    let can: Vec<String> = client.capabilities.as_object().unwrap().keys().cloned().collect();
    client.stop();
    let text = include_str!("../../../../docs/editors.md");
    let rows = text.lines().skip_while(|l| !l.starts_with("| what |")).take_while(|l| l.starts_with('|'));
    let mut said: Vec<String> = Vec::new();
    for row in rows.filter(|row| row.contains('●')) {
        let cell = row.split('|').nth(3).unwrap();
        said.extend(cell.split('`').skip(1).step_by(2).map(str::to_owned));
    }
    let sorted = |mut list: Vec<String>| {
        list.sort();
        list
    };
    assert_eq!(sorted(said), sorted(can));
}
