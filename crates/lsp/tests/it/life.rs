//! Beginning and end, and messages that are none.

use crate::client::{Client, at, room, usual};
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

/// The sentence of a trace; of anything else, nothing.
fn trace(message: &Value) -> &str {
    let own = message["method"] == "$/logTrace";
    message["params"]["message"].as_str().filter(|_| own).unwrap_or_default()
}

/// What is told of the server's own work is what the client asked for last: when it began, or since.
#[test]
fn traces_are_as_the_client_wants_them() {
    let (folder, scene, _) = room();
    for (first, then, message, verbose) in [
        (json!("messages"), None, true, false),
        (json!("verbose"), None, true, true),
        (json!("off"), None, false, false),
        (Value::Null, None, false, false),
        (Value::Null, Some("messages"), true, false),
        (json!("messages"), Some("verbose"), true, true),
        (json!("verbose"), Some("off"), false, false),
        (json!("verbose"), Some("nonsense"), false, false),
    ] {
        let mut client = Client::silent(folder.path(), Setup::default());
        client.ask("initialize", json!({ "processId": null, "capabilities": usual(), "trace": first }));
        assert!(client.told.is_empty(), "nothing is told before the answer: {:?}", client.told);
        client.tell("initialized", json!({}));
        if let Some(value) = then {
            client.tell("$/setTrace", json!({ "value": value }));
        }
        let uri = client.open("room.scene", &scene);
        client.published(&uri);
        let id = client.begin(
            "textDocument/hover",
            json!({ "textDocument": { "uri": uri }, "position": at(&scene, "object |bed") }),
        );
        assert!(client.end(id)["result"].is_object());
        // Answers may overtake what is told.
        let answered = format!("sending response 'textDocument/hover - ({id})'");
        if message {
            client.until("a trace of the answer", |c| {
                c.told.iter().find(|m| trace(m).starts_with(&answered)).map(|_| ())
            });
        }
        assert_eq!(client.ask("shutdown", Value::Null), Value::Null);

        let entries: Vec<&Value> = client.told.iter().filter(|m| m["method"] == "$/logTrace").collect();
        // What was told before the client changed its mind is as it was.
        let since = entries.iter().position(|m| trace(m).contains("'$/setTrace'")).map_or(0, |at| at + 1);
        let entries = &entries[since..];
        let case = format!("{first} {then:?}: {entries:?}");
        for entry in entries {
            let keys: Vec<&String> = entry["params"].as_object().unwrap().keys().collect();
            assert_eq!(keys, if verbose { vec!["message", "verbose"] } else { vec!["message"] }, "{case}");
        }
        let said = |words: &str, about: &str| {
            let found = entries.iter().find(|m| trace(m).starts_with(words));
            assert_eq!(found.is_some(), message, "{words} in {case}");
            let text = found.map_or("", |m| m["params"]["verbose"].as_str().unwrap_or_default());
            assert_eq!(text.contains(about), verbose, "{about} in {case}");
        };
        said("received notification 'textDocument/didOpen'", "A bed");
        said(&format!("received request 'textDocument/hover - ({id})'"), "position");
        said(&answered, "Where one sleeps");
        said(&format!("checked {uri}: 9 of 12 hold"), "generation");
        assert_eq!(client.exit(), 0);
    }
}

/// What is asked where the server says that it can something.
const ASKED: &[(&str, &str)] = &[
    (
        "callHierarchyProvider",
        "textDocument/prepareCallHierarchy callHierarchy/incomingCalls callHierarchy/outgoingCalls",
    ),
    ("codeActionProvider", "textDocument/codeAction codeAction/resolve"),
    ("codeLensProvider", "textDocument/codeLens"),
    ("colorProvider", "textDocument/documentColor textDocument/colorPresentation"),
    ("completionProvider", "textDocument/completion completionItem/resolve"),
    ("declarationProvider", "textDocument/declaration"),
    ("definitionProvider", "textDocument/definition"),
    ("diagnosticProvider", "textDocument/diagnostic workspace/diagnostic"),
    ("documentFormattingProvider", "textDocument/formatting"),
    ("documentHighlightProvider", "textDocument/documentHighlight"),
    ("documentLinkProvider", "textDocument/documentLink"),
    ("documentOnTypeFormattingProvider", "textDocument/onTypeFormatting"),
    ("documentRangeFormattingProvider", "textDocument/rangeFormatting"),
    ("documentSymbolProvider", "textDocument/documentSymbol"),
    ("executeCommandProvider", "workspace/executeCommand"),
    ("foldingRangeProvider", "textDocument/foldingRange"),
    ("hoverProvider", "textDocument/hover"),
    ("inlayHintProvider", "textDocument/inlayHint inlayHint/resolve"),
    ("linkedEditingRangeProvider", "textDocument/linkedEditingRange"),
    ("referencesProvider", "textDocument/references"),
    ("renameProvider", "textDocument/prepareRename textDocument/rename"),
    ("selectionRangeProvider", "textDocument/selectionRange"),
    (
        "semanticTokensProvider",
        "textDocument/semanticTokens/full textDocument/semanticTokens/full/delta textDocument/semanticTokens/range",
    ),
    ("signatureHelpProvider", "textDocument/signatureHelp"),
    ("typeDefinitionProvider", "textDocument/typeDefinition"),
    ("workspaceSymbolProvider", "workspace/symbol"),
    // These are told, not asked.
    ("positionEncoding", "positionEncodings"),
    ("textDocumentSync", "contentChanges textDocument/didClose"),
    ("workspace", "workspace/didChangeWorkspaceFolders workspace/didChangeWatchedFiles workspace/willRenameFiles"),
];

/// The rows of the table of `docs/editors.md`: what the server says that it can, and where that is tested.
fn promised() -> Vec<[Vec<String>; 2]> {
    let text = include_str!("../../../../docs/editors.md");
    let rows = text.lines().skip_while(|l| !l.starts_with("| what |")).take_while(|l| l.starts_with('|'));
    let quoted = |cell: &str| cell.split('`').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
    rows.filter(|row| row.contains('●'))
        .map(|row| [3, 4].map(|column| quoted(row.split('|').nth(column).unwrap())))
        .collect()
}

fn sorted(mut list: Vec<String>) -> Vec<String> {
    list.sort();
    list
}

/// What the server says that it can is what the table of `docs/editors.md` says, and no more.
#[test]
fn the_document_lists_what_the_server_can() {
    let (folder, ..) = room();
    let client = Client::start_with(folder.path(), crate::client::pulling(), Value::Null);
    let can: Vec<String> = client.capabilities.as_object().unwrap().keys().cloned().collect();
    client.stop();
    let said = promised().into_iter().flat_map(|[capabilities, _]| capabilities).collect();
    assert_eq!(sorted(said), sorted(can.clone()));
    assert_eq!(sorted(ASKED.iter().map(|(name, _)| (*name).to_owned()).collect()), sorted(can));
}

/// Each question that belongs to a row of the table is asked in the tests that the row names, and there are no others but
/// those of our own.
#[test]
fn what_the_document_lists_is_asked_where_it_says() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let test = |name: &String| std::fs::read_to_string(folder.join(format!("tests/it/{name}.rs"))).unwrap();
    let mut missing = Vec::new();
    for [capabilities, names] in promised() {
        assert!(!names.is_empty(), "{capabilities:?}");
        let texts: String = names.iter().map(test).collect();
        for (_, asked) in ASKED.iter().filter(|(name, _)| capabilities.iter().any(|c| c == name)) {
            let short = |method: &&str| format!("\"{}\"", method.trim_start_matches("textDocument/"));
            let is_asked = |method: &&str| texts.contains(&format!("\"{method}\"")) || texts.contains(&short(method));
            missing.extend(asked.split(' ').filter(|m| !is_asked(m)).map(|m| format!("{m} in {names:?}")));
        }
    }
    assert!(missing.is_empty(), "{missing:?}");

    let answered = include_str!("../../src/dispatch.rs").lines().filter_map(|l| l.trim().split_once("\" => "));
    let answered = answered.map(|(method, _)| method.trim_start_matches('"').to_owned());
    let known = ASKED.iter().flat_map(|(_, asked)| asked.split(' ')).filter(|m| m.contains('/') && !m.contains("/did"));
    let answered = answered.filter(|method| !method.starts_with("scenelang/")).collect();
    assert_eq!(sorted(answered), sorted(known.map(str::to_owned).collect()));
}
