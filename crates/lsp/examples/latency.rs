//! How fast a language server answers, over its own protocol: p50 and p95 of edits and questions, time to the first
//! diagnostics, resident memory. Any server, one after the other, with the same client:
//!
//! ```text
//! cargo build --release && cargo run --release -p scenelang-lsp --example latency -- \
//!     --scene 500x50 "target/release/scenelang lsp" --file long.py python "ty server"
//! ```
//!
//! `--scene LINESxOBJECTS` makes a program with a layout in which all holds; `--file PATH LANGUAGE` takes a file that is
//! there. An edit puts a character into a comment and takes it out again, and counts until the diagnostics of that version
//! are published.

use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// How often each thing is measured.
const TIMES: usize = 200;
/// How often a server is started.
const STARTS: usize = 10;

fn main() {
    let mut args = std::env::args().skip(1);
    let mut subject: Option<Subject> = None;
    println!("{:44} {:>9} {:>9} {:>9}   ms", "", "p50", "p95", "worst");
    while let Some(arg) = args.next() {
        match arg.as_str() {
            "--scene" => {
                let size = args.next().unwrap_or_default();
                let (lines, objects) = size.split_once('x').expect("LINESxOBJECTS");
                subject = Some(Subject::scene(lines.parse().expect("lines"), objects.parse().expect("objects")));
            }
            "--file" => {
                let path = PathBuf::from(args.next().expect("a file"));
                subject = Some(Subject::file(&path, &args.next().expect("its language")));
            }
            server => {
                let subject = subject.as_ref().expect("--scene or --file comes first");
                println!("{server}, {} lines", subject.text.lines().count());
                measure(server, subject);
            }
        }
    }
}

/// A document to work on.
struct Subject {
    path: PathBuf,
    language: String,
    text: String,
    /// Where an edit hurts nobody: the end of a comment.
    comment: u32,
    /// Where there is something to be said.
    word: (u32, u32),
    /// Held as long as the files are needed.
    _folder: Option<tempfile::TempDir>,
}

impl Subject {
    fn file(path: &Path, language: &str) -> Self {
        let text = fs::read_to_string(path).expect("the file");
        let path = std::path::absolute(path).expect("a path");
        let (text, comment) = with_comment(&text, language);
        let word = text.lines().position(|l| l.contains("def ")).unwrap_or(0) as u32;
        Self { path, language: language.to_owned(), text, comment, word: (word, 5), _folder: None }
    }

    /// Objects in a grid, each spoken of in as many lines as it takes.
    fn scene(lines: usize, objects: usize) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let side = (objects as f64).sqrt().ceil();
        let width = side * 1.5 + 2.0;
        let mut text = format!("region hall;\nhall.pos <- vec3(0, 0, 0);\nhall.scale <- vec3({width}, 3, {width});\n");
        let mut placed: Vec<String> = Vec::new();
        for i in 0..objects {
            let [x, z] = [i % side as usize, i / side as usize].map(|n| n as f64 * 1.5 - side * 0.75 + 0.75);
            let _ = write!(
                text,
                "object chair{i};\nchair{i}.category <- \"chair\";\nchair{i}.dimensions <- vec3(0.5, 0.9, 0.5);\nassert inside(chair{i}, hall);\n"
            );
            placed.push(format!(
                "\"chair{i}\": {{ \"pos\": [{x}, 0, {z}], \"rot\": [0, 0, 0], \"scale\": [0.5, 0.9, 0.5] }}"
            ));
        }
        let mut at = 0;
        while text.lines().count() < lines {
            let (a, b) = (at % objects, (at * 7 + 1) % objects);
            let _ = match at % 5 {
                0 => writeln!(text, "assert chair{a}.top < 1.5 and chair{a}.pos.y = 0;"),
                1 => writeln!(text, "assert distance(chair{a}, chair{b}) < {};", width * 2.0),
                2 => writeln!(
                    text,
                    "assert a{at}(chair{a}, chair{b});\npredicate a{at}(Object a, Object b) := a.top <= b.top + 1;"
                ),
                3 => writeln!(text, "assert gap(chair{a}, hall) > 0.1; // it has its place"),
                _ => writeln!(text, "prefer angle(chair{a}.front, chair{b}.front) <= 90;"),
            };
            at += 1;
        }
        let layout = format!(
            "{{ \"format\": \"scenelang.layout/1\", \"scene\": \"hall.scene\", \"objects\": {{ {} }}, \"regions\": {{ \"hall\": {{ \"pos\": [0, 0, 0], \"scale\": [{width}, 3, {width}] }} }} }}",
            placed.join(", ")
        );
        fs::write(folder.path().join("hall.layout.json"), layout).expect("a layout");
        let (text, comment) = with_comment(&text, "scene");
        let path = folder.path().join("hall.scene");
        fs::write(&path, &text).expect("a program");
        let word = text.lines().position(|l| l.starts_with("assert distance")).unwrap_or(0) as u32;
        Self { path, language: "scene".to_owned(), text, comment, word: (word, 18), _folder: Some(folder) }
    }
}

/// The text with a comment in the middle, and its line.
fn with_comment(text: &str, language: &str) -> (String, u32) {
    let mark = if language == "python" { "# note" } else { "// note" };
    let mut lines: Vec<&str> = text.lines().collect();
    // Before something that begins in the first column, where a comment can stand in any language.
    let half = lines.len() / 2;
    let free = |l: &&str| l.chars().next().is_some_and(char::is_alphabetic);
    let at = lines[half..].iter().position(free).map_or(0, |i| half + i);
    lines.insert(at, mark);
    (lines.join("\n") + "\n", at as u32)
}

fn measure(server: &str, subject: &Subject) {
    let mut first = Vec::new();
    for _ in 0..STARTS {
        let begun = Instant::now();
        let mut client = Client::start(server, subject);
        client.diagnostics(1);
        first.push(begun.elapsed());
        client.stop();
    }
    show("cold start to first diagnostics", first);

    let mut client = Client::start(server, subject);
    client.diagnostics(1);
    // Whatever is done behind the first diagnostics is not part of an edit.
    std::thread::sleep(Duration::from_secs(2));
    let mut edits = Vec::new();
    for n in 0..TIMES {
        let (start, end) = if n % 2 == 0 { (7, 7) } else { (7, 8) };
        let line = subject.comment;
        let range = json!({
            "start": { "line": line, "character": start }, "end": { "line": line, "character": end },
        });
        let version = 2 + n as i64;
        let begun = Instant::now();
        client.change(version, &json!([{ "range": range, "text": if n % 2 == 0 { "x" } else { "" } }]));
        client.diagnostics(version);
        edits.push(begun.elapsed());
        std::thread::sleep(Duration::from_millis(5));
    }
    show("edit to diagnostics", edits);
    let (line, character) = subject.word;
    let place = json!({ "line": line, "character": character });
    let document = json!({ "uri": client.uri });
    let all = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 40, "character": 0 } });
    for (method, params) in [
        ("hover", json!({ "textDocument": document, "position": place })),
        ("completion", json!({ "textDocument": document, "position": place, "context": { "triggerKind": 1 } })),
        ("definition", json!({ "textDocument": document, "position": place })),
        (
            "references",
            json!({ "textDocument": document, "position": place, "context": { "includeDeclaration": true } }),
        ),
        ("documentSymbol", json!({ "textDocument": document })),
        ("semanticTokens/full", json!({ "textDocument": document })),
        ("inlayHint", json!({ "textDocument": document, "range": all })),
        (
            "codeAction",
            json!({ "textDocument": document, "range": { "start": place, "end": place }, "context": { "diagnostics": [] } }),
        ),
    ] {
        let provider = format!("{}Provider", method.split('/').next().unwrap_or(method));
        if client.capabilities[&provider].is_null() {
            continue;
        }
        let mut times = Vec::new();
        for _ in 0..TIMES {
            let begun = Instant::now();
            client.ask(&format!("textDocument/{method}"), &params);
            times.push(begun.elapsed());
        }
        show(method, times);
    }
    if subject.language == "scene" {
        println!("  {:42} {:>9.1} MB", "resident, after questions about the text", client.resident());
        let mut times = Vec::new();
        for n in 0..TIMES {
            let pos = [f64::from(n as u32 % 20) * 0.01, 0.0, 0.0];
            let begun = Instant::now();
            client.ask("scenelang/move", &json!({ "uri": client.uri, "object": "chair0", "pos": pos }));
            times.push(begun.elapsed());
        }
        show("scenelang/move", times);
        // What a page asks after an edit: everything, and then only what it does not have.
        let room = json!({ "uri": client.uri });
        let shape = client.ask("scenelang/scene", &room)["data"]["shape"].clone();
        for (what, params) in [("all", room), ("places", json!({ "uri": client.uri, "known": shape }))] {
            let (mut times, mut bytes) = (Vec::new(), 0);
            for _ in 0..TIMES / 4 {
                let begun = Instant::now();
                let answer = client.ask("scenelang/scene", &params);
                times.push(begun.elapsed());
                bytes = answer.to_string().len();
            }
            show(&format!("scenelang/scene, {what}: {} kB", bytes / 1000), times);
        }
    }
    println!("  {:42} {:>9.1} MB", "resident", client.resident());
    client.stop();
}

fn show(what: &str, mut times: Vec<Duration>) {
    times.sort();
    let at = |share: f64| times[((times.len() - 1) as f64 * share) as usize].as_secs_f64() * 1000.0;
    println!("  {what:42} {:9.2} {:9.2} {:9.2}", at(0.5), at(0.95), at(1.0));
}

struct Client {
    child: Child,
    to: ChildStdin,
    from: Receiver<Value>,
    uri: String,
    capabilities: Value,
    next: i64,
    answers: BTreeMap<i64, Value>,
    /// The newest version that diagnostics were published for; `None` in it: they do not say.
    published: Vec<Option<i64>>,
}

impl Client {
    fn start(server: &str, subject: &Subject) -> Self {
        let mut words = server.split_whitespace();
        let program = words.next().expect("a server");
        let folder = subject.path.parent().expect("a folder");
        let mut child = Command::new(program)
            .args(words)
            .current_dir(if Path::new(program).components().count() > 1 { Path::new(".") } else { folder })
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the server starts");
        let to = child.stdin.take().expect("piped");
        let mut output = BufReader::new(child.stdout.take().expect("piped"));
        let (send, from) = channel();
        std::thread::spawn(move || {
            while let Some(message) = read(&mut output) {
                if send.send(message).is_err() {
                    return;
                }
            }
        });
        let uri = format!("file://{}", subject.path.display());
        let mut client = Self {
            child,
            to,
            from,
            uri: uri.clone(),
            capabilities: Value::Null,
            next: 0,
            answers: BTreeMap::new(),
            published: Vec::new(),
        };
        let root = format!("file://{}", folder.display());
        let answer = client.ask(
            "initialize",
            &json!({
                "processId": std::process::id(), "rootUri": root, "workspaceFolders": [{ "uri": root, "name": "x" }],
                "capabilities": {
                    "textDocument": {
                        "publishDiagnostics": { "versionSupport": true },
                        // As all editors do: a long edit is worked out when it is chosen.
                        "codeAction": { "resolveSupport": { "properties": ["edit"] } },
                        "semanticTokens": {
                            "requests": { "full": true }, "formats": ["relative"], "tokenModifiers": [],
                            "tokenTypes": ["class", "function", "variable", "keyword"],
                        },
                    },
                },
            }),
        );
        client.capabilities = answer["capabilities"].clone();
        client.send(json!({ "method": "initialized", "params": {} }));
        let document = json!({ "uri": uri, "languageId": subject.language, "version": 1, "text": subject.text });
        client.send(json!({ "method": "textDocument/didOpen", "params": { "textDocument": document } }));
        client
    }

    fn send(&mut self, mut message: Value) {
        message["jsonrpc"] = "2.0".into();
        let body = message.to_string();
        write!(self.to, "Content-Length: {}\r\n\r\n{body}", body.len()).expect("the server reads");
        self.to.flush().expect("the server reads");
    }

    fn change(&mut self, version: i64, changes: &Value) {
        self.published.clear();
        let document = json!({ "uri": self.uri, "version": version });
        let params = json!({ "textDocument": document, "contentChanges": changes });
        self.send(json!({ "method": "textDocument/didChange", "params": params }));
    }

    fn ask(&mut self, method: &str, params: &Value) -> Value {
        self.next += 1;
        let id = self.next;
        self.send(json!({ "id": id, "method": method, "params": params }));
        loop {
            if let Some(answer) = self.answers.remove(&id) {
                return answer["result"].clone();
            }
            self.take();
        }
    }

    /// Waits for the diagnostics of a version.
    fn diagnostics(&mut self, version: i64) {
        let fits = |of: &Option<i64>| of.is_none_or(|v| v == version);
        while !self.published.iter().any(fits) {
            self.take();
        }
    }

    fn take(&mut self) {
        let message = self.from.recv_timeout(Duration::from_secs(60)).expect("the server answers within a minute");
        let id = message.get("id").cloned();
        match (id, message["method"].as_str()) {
            (Some(id), Some(method)) => {
                let items = message["params"]["items"].as_array().map_or(0, Vec::len);
                let configured = method == "workspace/configuration";
                let result = if configured { json!(vec![Value::Null; items]) } else { Value::Null };
                self.send(json!({ "id": id, "result": result }));
            }
            (Some(id), None) => drop(self.answers.insert(id.as_i64().unwrap_or_default(), message)),
            (None, Some("textDocument/publishDiagnostics")) if message["params"]["uri"] == self.uri => {
                self.published.push(message["params"]["version"].as_i64());
            }
            _ => {}
        }
    }

    /// Megabytes, where the system says it.
    fn resident(&self) -> f64 {
        let status = fs::read_to_string(format!("/proc/{}/status", self.child.id())).unwrap_or_default();
        let line = status.lines().find_map(|l| l.strip_prefix("VmRSS:")).unwrap_or("0 kB");
        line.split_whitespace().next().and_then(|n| n.parse::<f64>().ok()).unwrap_or_default() / 1000.0
    }

    fn stop(mut self) {
        self.ask("shutdown", &Value::Null);
        self.send(json!({ "method": "exit" }));
        let _ = self.child.wait();
    }
}

fn read(input: &mut impl BufRead) -> Option<Value> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if input.read_line(&mut line).ok()? == 0 {
            return None;
        }
        match line.trim() {
            "" => break,
            line => length = line.strip_prefix("Content-Length: ").and_then(|n| n.parse().ok()).unwrap_or(length),
        }
    }
    let mut body = vec![0; length];
    std::io::Read::read_exact(input, &mut body).ok()?;
    serde_json::from_slice(&body).ok()
}
