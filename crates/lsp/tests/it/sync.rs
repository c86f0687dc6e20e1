//! Texts that are edited in any way end in the state that a fresh server finds.

use crate::client::{Client, pulling, room, slice, usual};
use serde_json::{Value, json};

/// A generator of numbers that is the same everywhere.
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 33) % n.max(1) as u64) as usize
    }
}

/// What is put in: pieces of programs, and what is hard to count.
const PIECES: &[&str] = &[
    "object",
    "bed",
    ";",
    "assert ",
    "near(bed, lamp, 1)",
    "\n",
    "\r\n",
    "\r",
    " ",
    "🪑",
    "é",
    "e\u{301}",
    "\u{2028}",
    "\0",
    "\"",
    "/*",
    "*/",
    "//",
    "(",
    ")",
    "[",
    "]",
    "{",
    "1e999",
    "<-",
    "@req(\"",
    "forall x in",
    "room.",
    "\u{feff}",
    "region r;\nobject c[3];\n",
];

/// Offsets at characters, and their positions in UTF-16.
fn position(text: &str, offset: usize) -> Value {
    let mut line = 0;
    let mut start = 0;
    let bytes = text.as_bytes();
    for i in 0..offset {
        if bytes[i] == b'\n' || (bytes[i] == b'\r' && bytes.get(i + 1) != Some(&b'\n')) {
            line += 1;
            start = i + 1;
        }
    }
    let units: usize = text[start..offset].chars().map(char::len_utf16).sum();
    json!({ "line": line, "character": units })
}

fn boundary(text: &str, dice: &mut Dice) -> usize {
    let mut at = text.floor_char_boundary(dice.below(text.len() + 1));
    // Between CR and LF there is no position.
    if at > 0 && text.as_bytes()[at - 1] == b'\r' && text.as_bytes().get(at) == Some(&b'\n') {
        at -= 1;
    }
    at
}

/// All that can be said of a document.
fn state(client: &mut Client, uri: &str) -> Vec<Value> {
    let document = json!({ "textDocument": { "uri": uri } });
    let mut diagnostics = client.ask("textDocument/diagnostic", document.clone());
    diagnostics["resultId"] = Value::Null;
    let mut tokens = client.ask("textDocument/semanticTokens/full", document.clone());
    tokens["resultId"] = Value::Null;
    let end = json!({ "line": 100_000, "character": 0 });
    let hints =
        json!({ "textDocument": { "uri": uri }, "range": { "start": { "line": 0, "character": 0 }, "end": end } });
    vec![
        diagnostics,
        tokens,
        client.ask("textDocument/documentSymbol", document.clone()),
        client.ask("textDocument/foldingRange", document.clone()),
        client.ask("textDocument/inlayHint", hints),
        client.ask("textDocument/codeLens", document),
    ]
}

/// Ten thousand edits with questions among them, many of which are cancelled.
#[test]
fn edits_and_cancellations_end_where_a_fresh_server_is() {
    const EDITS: usize = 10_000;
    let (folder, scene, _) = room();
    let mut dice = Dice(7);
    let mut client = Client::start_with(folder.path(), pulling(), Value::Null);
    let uri = client.open("room.scene", &scene);
    let mut text = scene.clone();
    let mut cancelled = Vec::new();
    for n in 0..EDITS {
        let mut changes = Vec::new();
        for _ in 0..1 + dice.below(3) {
            let (a, b) = (boundary(&text, &mut dice), boundary(&text, &mut dice));
            // Mostly short ones, near each other.
            let (a, b) = (a.min(b), a.max(b));
            let b = if dice.below(4) == 0 { b.min(text.floor_char_boundary(a + 12)) } else { a };
            let piece = PIECES[dice.below(PIECES.len())];
            let range = json!({ "start": position(&text, a), "end": position(&text, b) });
            changes.push(json!({ "range": range, "text": piece }));
            text.replace_range(a..b, piece);
        }
        if text.len() > 6000 {
            text.clone_from(&scene);
            changes = vec![json!({ "text": text })];
        }
        client.change(&uri, changes.into());
        if dice.below(10) == 0 {
            let place = position(&text, boundary(&text, &mut dice));
            let method = ["hover", "completion", "definition", "documentHighlight", "signatureHelp"][dice.below(5)];
            let id = client
                .begin(&format!("textDocument/{method}"), json!({ "textDocument": { "uri": uri }, "position": place }));
            if dice.below(2) == 0 {
                client.tell("$/cancelRequest", json!({ "id": id }));
            }
            cancelled.push(id);
        }
        if n % 2500 == 2499 {
            let mut other = Client::start_with(folder.path(), pulling(), Value::Null);
            let fresh = other.open("room.scene", &text);
            assert_eq!(state(&mut client, &uri), state(&mut other, &fresh), "after {n} edits: {text}");
            other.stop();
        }
    }
    for id in cancelled {
        let answer = client.end(id);
        let code = answer["error"]["code"].as_i64();
        assert!(code.is_none() || code == Some(-32800), "{answer}");
    }
    client.set(&uri, &scene);
    let mut other = Client::start_with(folder.path(), pulling(), Value::Null);
    let fresh = other.open("room.scene", &scene);
    assert_eq!(state(&mut client, &uri), state(&mut other, &fresh));
    assert_eq!((client.stop(), other.stop()), (0, 0));
}

#[test]
fn positions_count_as_agreed() {
    let (folder, ..) = room();
    let text = "/* 🪑é */ object läuft; assert läuft.top > 1;\n";
    for (offered, chosen, column) in [
        (json!(["utf-16"]), "utf-16", 17),
        (json!(["utf-32"]), "utf-32", 16),
        (json!(["utf-16", "utf-8"]), "utf-8", 20),
        (json!([]), "utf-16", 17),
    ] {
        let mut can = usual();
        can["general"]["positionEncodings"] = offered;
        let mut client = Client::start_with(folder.path(), can, Value::Null);
        assert_eq!(client.capabilities["positionEncoding"], chosen);
        let uri = client.open("units.scene", text);
        let symbols = client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri } }));
        assert_eq!(symbols[0]["name"], "läuft");
        assert_eq!(symbols[0]["selectionRange"]["start"], json!({ "line": 0, "character": column }), "{chosen}");
        let place = json!({ "textDocument": { "uri": uri }, "position": { "line": 0, "character": column + 1 } });
        let marks = client.ask("textDocument/documentHighlight", place);
        assert_eq!(marks.as_array().unwrap().len(), 2, "{chosen}");
        client.stop();
    }
}

#[test]
fn places_and_documents_that_are_not_there_are_no_reason_to_die() {
    let (folder, scene, _) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &scene);
    let methods = [
        "hover",
        "completion",
        "definition",
        "references",
        "documentHighlight",
        "signatureHelp",
        "prepareRename",
        "linkedEditingRange",
        "prepareCallHierarchy",
        "onTypeFormatting",
    ];
    for (line, character) in [(0, 99_999), (99_999, 0), (4_294_967_295_u64, 4_294_967_295_u64), (3, 1)] {
        for uri in [&uri, "file:///nowhere/at/all.scene", "untitled:Untitled-1"] {
            for method in methods {
                let place = json!({
                    "textDocument": { "uri": uri }, "position": { "line": line, "character": character },
                    "context": { "includeDeclaration": true }, "ch": ";", "options": { "tabSize": 2, "insertSpaces": true },
                });
                client.ask(&format!("textDocument/{method}"), place);
            }
        }
    }
    client.tell(
        "textDocument/didChange",
        json!({ "textDocument": { "uri": "file:///x", "version": 2 }, "contentChanges": [{ "text": "" }] }),
    );
    client.tell("textDocument/didClose", json!({ "textDocument": { "uri": "file:///x" } }));
    // A change beyond the end of a line is made at its end; one the wrong way round is made all the same.
    client.set(&uri, "object a;\nobject b;\n");
    let far = json!({ "line": 0, "character": 999 });
    client.change(&uri, json!([{ "range": { "start": far, "end": far }, "text": " object c;" }]));
    let names =
        |v: Value| v.as_array().unwrap().iter().map(|s| s["name"].as_str().unwrap().to_owned()).collect::<Vec<_>>();
    let document = json!({ "textDocument": { "uri": uri } });
    assert_eq!(names(client.ask("textDocument/documentSymbol", document.clone())), ["a", "c", "b"]);
    let (later, earlier) = (json!({ "line": 1, "character": 8 }), json!({ "line": 1, "character": 7 }));
    client.change(&uri, json!([{ "range": { "start": later, "end": earlier }, "text": "d" }]));
    assert_eq!(names(client.ask("textDocument/documentSymbol", document)), ["a", "c", "d"]);
    assert_eq!(client.stop(), 0);
}

/// Ten megabytes, and what nests too deeply.
#[test]
fn very_large_and_very_deep_files_are_survived() {
    let (folder, ..) = room();
    let mut client = Client::start_with(folder.path(), pulling(), Value::Null);
    let line = "object x; // a comment that makes the line longer, and the file larger\n";
    let large = line.repeat((10 << 20) / line.len());
    for text in [large, "(".repeat(100_000), "a.".repeat(50_000), "/*".repeat(50_000), "\n".repeat(200_000)] {
        let uri = client.open("large.scene", &text);
        let document = json!({ "textDocument": { "uri": uri } });
        let answer = client.ask("textDocument/diagnostic", document.clone());
        assert!(answer["items"].as_array().unwrap().len() <= 400);
        client.ask("textDocument/foldingRange", document.clone());
        client.tell("textDocument/didClose", document);
    }
    assert_eq!(client.stop(), 0);
}

/// Whatever is open is answered for under the address that it came with.
#[test]
fn addresses_are_given_back_as_they_came() {
    let (folder, ..) = room();
    let mut client = Client::start(folder.path());
    for uri in [
        "file:///c%3A/Users/x/a.scene",
        "untitled:Untitled-1",
        "vscode-remote://host/x/a.scene",
        "file:///a%2Bb/%C3%A9.scene",
    ] {
        let text = "object a;\nassert b.top > 1;\n";
        client.open_uri(uri, text);
        let marks = client.published(uri);
        assert_eq!(slice(text, &marks[0]["range"]), "b", "{uri}: {marks:?}");
        client.tell("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
        client.until("the marks to go", |c| {
            let last = c
                .told
                .iter()
                .rev()
                .find(|m| m["params"]["uri"] == uri && m["method"] == "textDocument/publishDiagnostics")?;
            last["params"]["diagnostics"].as_array().unwrap().is_empty().then_some(())
        });
    }
    assert_eq!(client.stop(), 0);
}
