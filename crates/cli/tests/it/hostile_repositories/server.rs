//! A server on a hostile repository: it answers about a good document, whatever the bad one does, and tells no secret.

use super::{PATIENCE, Repository, Row};
use serde_json::{Value, json};
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{ChildStdin, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;

/// Starts a server, opens the good and the bad, asks about both; all that the server said.
pub fn serve(repo: &Repository, row: &Row) -> String {
    let mut command = repo.command(&["lsp"]);
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
    let (send, receive) = channel();
    let mut out = BufReader::new(child.stdout.take().unwrap());
    thread::spawn(move || {
        while let Some(message) = read(&mut out) {
            if send.send(message).is_err() {
                return;
            }
        }
    });
    let mut client =
        Client { to: child.stdin.take().unwrap(), from: receive, said: Vec::new(), next: 0, name: row.name };
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
    client.ask("shutdown", &Value::Null);
    client.tell("exit", &Value::Null);
    let told = client.said.iter().map(Value::to_string).collect::<Vec<_>>().join("\n");
    drop(client);
    let code = child.wait().unwrap().code();
    assert_eq!(code, Some(0), "{}: the server ended with {code:?}", row.name);
    told
}

struct Client {
    to: ChildStdin,
    from: Receiver<Value>,
    said: Vec<Value>,
    next: i64,
    name: &'static str,
}

impl Client {
    fn tell(&mut self, method: &str, params: &Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    fn ask(&mut self, method: &str, params: &Value) -> Value {
        self.next += 1;
        let id = self.next;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        self.wait(|message| message["id"] == id && message["method"].is_null())
    }

    fn send(&mut self, message: &Value) {
        let text = message.to_string();
        write!(self.to, "Content-Length: {}\r\n\r\n{text}", text.len()).unwrap();
        self.to.flush().unwrap();
    }

    /// The message that is meant, among those that were said or will be.
    fn wait(&mut self, is_meant: impl Fn(&Value) -> bool) -> Value {
        if let Some(found) = self.said.iter().find(|message| is_meant(message)) {
            return found.clone();
        }
        loop {
            let message = self.from.recv_timeout(PATIENCE);
            let message = message.unwrap_or_else(|e| panic!("{}: the server does not answer: {e}", self.name));
            self.said.push(message.clone());
            if let (Some(id), true) = (message.get("id"), message["method"].is_string()) {
                self.send(&json!({ "jsonrpc": "2.0", "id": id, "result": null }));
            }
            if is_meant(&message) {
                return message;
            }
        }
    }
}

fn read(from: &mut impl BufRead) -> Option<Value> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if from.read_line(&mut line).ok()? == 0 {
            return None;
        }
        if let Some(number) = line.strip_prefix("Content-Length: ") {
            length = number.trim().parse().ok()?;
        }
        if line == "\r\n" {
            break;
        }
    }
    let mut bytes = vec![0; length];
    from.read_exact(&mut bytes).ok()?;
    serde_json::from_slice(&bytes).ok()
}
