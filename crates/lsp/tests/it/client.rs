//! A client on two pipes. It answers what the server asks, and fails the test when a message is not what the protocol allows.

use scenelang_lsp::{Setup, serve};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::io::{BufRead, BufReader, PipeWriter, Write, pipe};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// No answer within this time is a failure; the machine may be busy.
pub const PATIENCE: Duration = Duration::from_secs(60);
const TOLD: [&str; 6] = [
    "textDocument/publishDiagnostics",
    "scenelang/changed",
    "$/progress",
    "$/logTrace",
    "window/logMessage",
    "window/showMessage",
];

/// What the client can, unless a test says otherwise.
pub fn usual() -> Value {
    json!({
        "general": { "positionEncodings": ["utf-16"] },
        "window": { "workDoneProgress": true },
        "workspace": {
            "applyEdit": true, "configuration": true,
            "workspaceEdit": {
                "documentChanges": true, "resourceOperations": ["create"],
                "changeAnnotationSupport": { "groupsOnLabel": true },
            },
            "didChangeWatchedFiles": { "dynamicRegistration": true },
            "inlayHint": { "refreshSupport": true },
        },
        "textDocument": {
            "publishDiagnostics": { "relatedInformation": true },
            "documentSymbol": { "hierarchicalDocumentSymbolSupport": true },
            "definition": { "linkSupport": true },
            "completion": { "completionItem": { "snippetSupport": true } },
            "codeAction": { "resolveSupport": { "properties": ["edit"] } },
        },
    })
}

/// The same for a client that asks for diagnostics itself.
pub fn pulling() -> Value {
    let mut can = usual();
    can["textDocument"]["diagnostic"] = json!({ "relatedDocumentSupport": true });
    can["workspace"]["diagnostics"] = json!({ "refreshSupport": true });
    can
}

/// What becomes of a question to the editor's language model.
#[derive(Clone, Debug)]
pub enum Model {
    /// It is answered so.
    Says(Value),
    /// It is refused so.
    Fails(Value),
    /// It stays open.
    Thinks,
}

pub struct Client {
    to: Option<PipeWriter>,
    from: Receiver<Value>,
    server: Option<JoinHandle<u8>>,
    next: i64,
    open: BTreeSet<i64>,
    answers: BTreeMap<String, Value>,
    /// What the server told, in order.
    pub told: Vec<Value>,
    /// What the server asked, in order.
    pub asked: Vec<Value>,
    /// What the editor has set for us.
    pub settings: Value,
    /// Whether questions of the server stay unanswered.
    pub mute: bool,
    /// The editor's language model.
    pub model: Model,
    /// What the server says that it can.
    pub capabilities: Value,
    versions: BTreeMap<String, i32>,
    /// The folder of the test.
    pub folder: PathBuf,
}

impl Client {
    /// A client that has said nothing yet.
    pub fn silent(folder: &Path, setup: Setup) -> Self {
        let (server_reads, to) = pipe().unwrap();
        let (from_server, server_writes) = pipe().unwrap();
        let server = thread::spawn(move || serve(server_reads, server_writes, setup));
        let (send, from) = channel();
        thread::spawn(move || {
            let mut input = BufReader::new(from_server);
            while let Some(message) = read(&mut input) {
                if send.send(message).is_err() {
                    return;
                }
            }
        });
        Self {
            to: Some(to),
            from,
            server: Some(server),
            next: 0,
            open: BTreeSet::new(),
            answers: BTreeMap::new(),
            told: Vec::new(),
            asked: Vec::new(),
            settings: Value::Null,
            mute: false,
            model: Model::Says(Value::Null),
            capabilities: Value::Null,
            versions: BTreeMap::new(),
            folder: folder.to_owned(),
        }
    }

    /// A client that has been introduced, with the folder as its workspace.
    pub fn start(folder: &Path) -> Self {
        Self::start_with(folder, usual(), Value::Null)
    }

    pub fn start_with(folder: &Path, capabilities: Value, options: Value) -> Self {
        Self::introduced(Self::silent(folder, Setup::default()), capabilities, options)
    }

    pub fn introduced(mut client: Self, capabilities: Value, options: Value) -> Self {
        let root = client.uri("");
        let answer = client.ask(
            "initialize",
            json!({
                "processId": null, "rootUri": root, "capabilities": capabilities,
                "workspaceFolders": [{ "uri": root.trim_end_matches('/'), "name": "test" }],
                "initializationOptions": options,
            }),
        );
        client.capabilities = answer["capabilities"].clone();
        client.tell("initialized", json!({}));
        client
    }

    /// The address of a file in the folder.
    pub fn uri(&self, file: &str) -> String {
        format!("file://{}/{file}", self.folder.display())
    }

    // ── Sending ──

    pub fn raw(&mut self, bytes: &[u8]) {
        self.to.as_mut().unwrap().write_all(bytes).unwrap();
    }

    pub fn send(&mut self, mut message: Value) {
        message["jsonrpc"] = "2.0".into();
        let body = message.to_string();
        self.raw(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
    }

    pub fn tell(&mut self, method: &str, params: Value) {
        self.send(json!({ "method": method, "params": params }));
    }

    /// Asks without waiting; the number of the question.
    pub fn begin(&mut self, method: &str, params: Value) -> i64 {
        self.next += 1;
        self.open.insert(self.next);
        self.send(json!({ "id": self.next, "method": method, "params": params }));
        self.next
    }

    /// Waits for the whole answer of a question.
    pub fn end(&mut self, id: i64) -> Value {
        let key = json!(id).to_string();
        self.until(&format!("the answer to {id}"), |c| c.answers.remove(&key))
    }

    /// The result of a question; an error fails the test.
    pub fn ask(&mut self, method: &str, params: Value) -> Value {
        let id = self.begin(method, params);
        let answer = self.end(id);
        assert!(answer.get("error").is_none(), "{method}: {answer}");
        answer["result"].clone()
    }

    /// The error of a question; a result fails the test.
    pub fn refused(&mut self, method: &str, params: Value) -> (i64, String) {
        let id = self.begin(method, params);
        let answer = self.end(id);
        let error = answer.get("error").unwrap_or_else(|| panic!("{method} was answered: {answer}"));
        (error["code"].as_i64().unwrap(), error["message"].as_str().unwrap().to_owned())
    }

    // ── Receiving ──

    /// Takes messages until something is there.
    pub fn until<T>(&mut self, what: &str, mut found: impl FnMut(&mut Self) -> Option<T>) -> T {
        let end = Instant::now() + PATIENCE;
        loop {
            if let Some(found) = found(self) {
                return found;
            }
            match self.from.recv_timeout(end.saturating_duration_since(Instant::now())) {
                Ok(message) => self.take(message),
                Err(RecvTimeoutError::Timeout) => panic!("waited in vain for {what}"),
                Err(RecvTimeoutError::Disconnected) => panic!("the server is gone; waited for {what}"),
            }
        }
    }

    fn take(&mut self, message: Value) {
        assert_eq!(message["jsonrpc"], "2.0", "{message}");
        match (message.get("id"), message["method"].as_str()) {
            (Some(id), Some(method)) => {
                self.asked.push(message.clone());
                let id = id.clone();
                if method == "scenelang/languageModel" {
                    match &self.model {
                        Model::Says(result) => self.send(json!({ "id": id, "result": result })),
                        Model::Fails(error) => self.send(json!({ "id": id, "error": error })),
                        Model::Thinks => {}
                    }
                } else if !self.mute {
                    let result = self.result(method, &message["params"]);
                    self.send(json!({ "id": id, "result": result }));
                }
            }
            (None, Some(method)) => {
                assert!(TOLD.contains(&method), "{message}");
                self.told.push(message);
            }
            (Some(id), None) => {
                assert!(message.get("result").is_some() != message.get("error").is_some(), "{message}");
                if let Some(number) = id.as_i64() {
                    assert!(self.open.remove(&number), "nobody asked {message}");
                }
                self.answers.insert(id.to_string(), message);
            }
            (None, None) => panic!("neither question nor answer: {message}"),
        }
    }

    fn result(&mut self, method: &str, params: &Value) -> Value {
        match method {
            "workspace/configuration" => json!([self.settings]),
            "workspace/applyEdit" => json!({ "applied": true }),
            "client/registerCapability" | "window/workDoneProgress/create" => Value::Null,
            _ if method.ends_with("/refresh") => Value::Null,
            _ => panic!("the server asks {method} {params}"),
        }
    }

    /// The answer with a null id, to what was no message.
    pub fn nobody(&mut self) -> Value {
        self.until("an answer to nobody", |c| c.answers.remove("null"))
    }

    // ── Documents ──

    pub fn open(&mut self, file: &str, text: &str) -> String {
        let uri = self.uri(file);
        self.open_uri(&uri, text);
        uri
    }

    pub fn open_uri(&mut self, uri: &str, text: &str) {
        self.versions.insert(uri.to_owned(), 1);
        let language = if uri.ends_with(".json") { "json" } else { "scene" };
        let document = json!({ "uri": uri, "languageId": language, "version": 1, "text": text });
        self.tell("textDocument/didOpen", json!({ "textDocument": document }));
    }

    pub fn change(&mut self, uri: &str, changes: Value) {
        let version = self.versions.get_mut(uri).unwrap();
        *version += 1;
        let document = json!({ "uri": uri, "version": *version });
        self.tell("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    }

    pub fn set(&mut self, uri: &str, text: &str) {
        self.change(uri, json!([{ "text": text }]));
    }

    /// What was published about a document for the version that it has.
    pub fn published(&mut self, uri: &str) -> Vec<Value> {
        let version = self.versions.get(uri).copied();
        self.until("diagnostics", |c| {
            let about = |m: &&Value| m["method"] == "textDocument/publishDiagnostics" && m["params"]["uri"] == uri;
            let last = c.told.iter().rev().find(about)?;
            let fits = version.is_none() || last["params"]["version"] == json!(version);
            fits.then(|| last["params"]["diagnostics"].as_array().unwrap().clone())
        })
    }

    /// Forgets what was told, and waits for the next verdict on a document.
    pub fn next_verdict(&mut self, uri: &str) -> Value {
        self.until("a verdict", |c| {
            let at = c.told.iter().position(|m| m["method"] == "scenelang/changed" && m["params"]["uri"] == uri)?;
            Some(c.told.remove(at)["params"].clone())
        })
    }

    /// The exit code after `shutdown` and `exit`.
    pub fn stop(mut self) -> u8 {
        let answer = self.ask("shutdown", Value::Null);
        assert_eq!(answer, Value::Null);
        self.exit()
    }

    /// The exit code after `exit`.
    pub fn exit(mut self) -> u8 {
        self.send(json!({ "method": "exit" }));
        self.server.take().unwrap().join().unwrap()
    }

    /// The exit code after the end of the stream.
    pub fn hang_up(mut self) -> u8 {
        drop(self.to.take());
        self.server.take().unwrap().join().unwrap()
    }
}

fn read(input: &mut impl BufRead) -> Option<Value> {
    let mut length = None;
    loop {
        let mut line = String::new();
        if input.read_line(&mut line).ok()? == 0 {
            return None;
        }
        match line.trim() {
            "" => break,
            line => length = line.strip_prefix("Content-Length: ").map(|n| n.parse::<usize>().unwrap()).or(length),
        }
    }
    let mut body = vec![0; length.expect("a header says how long the body is")];
    input.read_exact(&mut body).ok()?;
    Some(serde_json::from_slice(&body).expect("the server writes JSON"))
}

/// A position after the first occurrence of some text, in UTF-16; `|` in the text says where in it.
pub fn at(text: &str, marked: &str) -> Value {
    let plain = marked.replacen('|', "", 1);
    let start = text.find(&plain).unwrap_or_else(|| panic!("no {plain:?}"));
    let offset = start + marked.find('|').unwrap_or(0);
    let before = &text[..offset];
    let line = before.matches('\n').count();
    let column: usize = before.rsplit('\n').next().unwrap().chars().map(char::len_utf16).sum();
    json!({ "line": line, "character": column })
}

/// The text of a range, which is in UTF-16.
pub fn slice(text: &str, range: &Value) -> String {
    text[offset(text, &range["start"])..offset(text, &range["end"])].to_owned()
}

pub fn offset(text: &str, at: &Value) -> usize {
    let line = at["line"].as_u64().unwrap() as usize;
    let start: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
    let mut left = at["character"].as_u64().unwrap();
    let mut out = start;
    for c in text[start..].chars() {
        if left == 0 {
            break;
        }
        left = left.checked_sub(c.len_utf16() as u64).expect("no position within a character");
        out += c.len_utf8();
    }
    out
}

/// A text after edits.
pub fn edited(text: &str, edits: &Value) -> String {
    let mut list: Vec<(usize, usize, &str)> = edits
        .as_array()
        .unwrap()
        .iter()
        .map(|e| (offset(text, &e["range"]["start"]), offset(text, &e["range"]["end"]), e["newText"].as_str().unwrap()))
        .collect();
    list.sort();
    let mut out = text.to_owned();
    for (start, end, new) in list.into_iter().rev() {
        out.replace_range(start..end, new);
    }
    out
}

/// The edits of a document in a change of the workspace.
pub fn edits_of<'v>(change: &'v Value, uri: &str) -> &'v Value {
    let changes = change["documentChanges"].as_array().expect("changes with versions");
    let own = changes.iter().find(|c| c["textDocument"]["uri"] == uri);
    &own.unwrap_or_else(|| panic!("nothing about {uri}: {change}"))["edits"]
}

/// A folder with a room and its layout, in which some things do not hold.
pub fn room() -> (tempfile::TempDir, String, String) {
    let folder = tempfile::tempdir().unwrap();
    let (scene, layout) = (include_str!("room/room.scene"), include_str!("room/room.layout.json"));
    std::fs::write(folder.path().join("room.scene"), scene).unwrap();
    std::fs::write(folder.path().join("parts.scene"), include_str!("room/parts.scene")).unwrap();
    std::fs::write(folder.path().join("room.layout.json"), layout).unwrap();
    (folder, scene.to_owned(), layout.to_owned())
}
