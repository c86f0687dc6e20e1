//! A server on a hostile repository: it answers about a good document, whatever the bad one does, and tells no secret.

use super::{Repository, Row};
use crate::mcp::client::Client as Assistant;
use crate::speaking::Client;
use serde_json::{Value, json};
use std::fs;

/// Starts a server, opens the good and the bad, asks about both; all that the server said.
pub fn serve(repo: &Repository, row: &Row) -> String {
    let mut client = Client::start(repo.command(&["lsp"]), row.name);
    let uri = |file: &str| format!("file://{}/{file}", repo.root().display());
    // An editor that makes no changes itself: what is to be written the server writes.
    client.ask(
        "initialize",
        &json!({
            "processId": null, "rootUri": uri(""), "capabilities": {},
            "initializationOptions": { "layout": row.setting },
        }),
    );
    client.tell("initialized", &json!({}));
    for file in ["room.scene", "good.scene"] {
        // What an editor cannot show it does not open.
        let path = repo.at(file);
        let regular = path.metadata().is_ok_and(|data| data.is_file());
        let text = if regular { fs::read_to_string(path).unwrap_or_default() } else { String::new() };
        let text = if text.contains(super::SECRET) { super::ROOM.to_owned() } else { text };
        let document = json!({ "uri": uri(file), "languageId": "scenelang", "version": 1, "text": text });
        client.tell("textDocument/didOpen", &json!({ "textDocument": document }));
    }
    let of = |file: &str| json!({ "textDocument": { "uri": uri(file) }, "position": { "line": 0, "character": 9 } });
    let good = client.ask("textDocument/documentSymbol", &of("good.scene"));
    assert!(good["result"].to_string().contains("good"), "{}: the good document has no symbols: {good}", row.name);
    client.wait(|message| {
        message["method"] == "textDocument/publishDiagnostics" && message["params"]["uri"] == uri("good.scene").as_str()
    });
    for method in ["hover", "definition", "documentLink", "codeLens", "inlayHint", "completion", "references"] {
        let mut params = of("room.scene");
        params["range"] = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 9, "character": 0 } });
        params["context"] = json!({ "includeDeclaration": true });
        client.ask(&format!("textDocument/{method}"), &params);
    }
    client.ask("workspace/symbol", &json!({ "query": "" }));
    client.ask("workspace/diagnostic", &json!({ "previousResultIds": [] }));
    for command in ["scenelang.check", "scenelang.repairAll", "scenelang.solve"] {
        client.ask(
            "workspace/executeCommand",
            &json!({ "command": command, "arguments": [{ "uri": uri("room.scene") }] }),
        );
    }
    let good = client.ask("textDocument/hover", &of("good.scene"));
    assert!(good["error"].is_null(), "{}: {good}", row.name);
    let said = client.end();
    said.iter().map(Value::to_string).collect::<Vec<_>>().join("\n")
}

/// Has an assistant, who may write, do with it all that tools do; all that it was told.
pub fn assist(repo: &Repository) -> String {
    let mut client = Assistant::start(repo.command(&["mcp", "--write"]));
    for (file, tools) in [
        ("room.scene", &["check", "why_not", "render", "solve", "repair"][..]),
        ("room.layout.json", &["check", "render"][..]),
    ] {
        for tool in tools {
            client.call(tool, &json!({ "file": file }));
        }
        client.ask("resources/read", &json!({ "uri": format!("scenelang://report/{file}") }));
    }
    client.call("repair", &json!({ "file": "room.scene", "apply": 1 }));
    client.call("formalize", &json!({ "request": "a room with a bed", "file": "room.scene", "literal": true }));
    client.ask("resources/list", &json!({}));
    let good = client.call("check", &json!({ "file": "good.scene" }));
    assert!(good["structuredContent"]["file"].is_string(), "{good}");
    let told = std::mem::take(&mut client.transcript);
    client.end();
    told
}
