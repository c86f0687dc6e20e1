//! A client that speaks to `scenelang mcp` line by line, and writes down what was said.

use crate::support::binary;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

/// A server that says nothing for so long hangs. No test measures time; this only ends what would never end.
const HANGS: Duration = Duration::from_secs(120);

pub struct Client {
    child: Child,
    input: Option<ChildStdin>,
    lines: Receiver<String>,
    next: u64,
    /// What was said so far, for a snapshot.
    pub transcript: String,
}

impl Client {
    /// Starts a server in a folder, and greets it.
    pub fn new(folder: &Path, options: &[&str]) -> Self {
        let mut command = binary();
        command.arg("mcp").args(options).current_dir(folder);
        Self::start(command)
    }

    /// Starts a server, and greets it.
    pub fn start(mut command: Command) -> Self {
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::inherit());
        let mut child = command.spawn().unwrap();
        let (input, output) = (child.stdin.take(), child.stdout.take().unwrap());
        let (tell, lines) = channel();
        std::thread::spawn(move || {
            for line in BufReader::new(output).lines() {
                if tell.send(line.unwrap()).is_err() {
                    break;
                }
            }
        });
        let mut client = Self { child, input, lines, next: 0, transcript: String::new() };
        let who = json!({ "name": "test", "version": "1" });
        client.ask("initialize", &json!({ "protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": who }));
        client.tell("notifications/initialized", &json!({}));
        client
    }

    pub fn id(&self) -> u32 {
        self.child.id()
    }

    fn send(&mut self, message: &Value) {
        let input = self.input.as_mut().unwrap();
        writeln!(input, "{message}").unwrap();
        input.flush().unwrap();
    }

    /// A notification.
    pub fn tell(&mut self, method: &str, params: &Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// Sends a request and does not wait; its id.
    pub fn begin(&mut self, method: &str, params: &Value) -> u64 {
        self.next += 1;
        self.send(&json!({ "jsonrpc": "2.0", "id": self.next, "method": method, "params": params }));
        self.next
    }

    /// The next message of the server.
    pub fn hear(&mut self) -> Value {
        let line = self.lines.recv_timeout(HANGS).expect("the server says nothing");
        serde_json::from_str(&line).unwrap()
    }

    /// A request and its answer, `result` or `error`.
    pub fn ask(&mut self, method: &str, params: &Value) -> Value {
        let id = self.begin(method, params);
        let answer = self.hear();
        assert_eq!(answer["id"], id, "{answer}");
        self.transcript += &format!("→ {method} {params}\n{}\n\n", shown(&answer));
        answer.get("result").or(answer.get("error")).unwrap().clone()
    }

    /// A call of a tool.
    pub fn call(&mut self, tool: &str, arguments: &Value) -> Value {
        self.ask("tools/call", &json!({ "name": tool, "arguments": arguments }))
    }

    /// What a tool says that did its work.
    pub fn done(&mut self, tool: &str, arguments: &Value) -> Value {
        let result = self.call(tool, arguments);
        assert_eq!(result["isError"], false, "{tool} {arguments}: {result}");
        let text = result["content"][0]["text"].as_str().unwrap();
        assert_eq!(serde_json::from_str::<Value>(text).unwrap(), result["structuredContent"]);
        result["structuredContent"].clone()
    }

    /// Why a tool did not do its work.
    pub fn refused(&mut self, tool: &str, arguments: &Value) -> String {
        let result = self.call(tool, arguments);
        assert_eq!(result["isError"], true, "{tool} {arguments}: {result}");
        result["content"][0]["text"].as_str().unwrap().to_owned()
    }

    /// Closes standard input; the exit code.
    pub fn end(mut self) -> i32 {
        drop(self.input.take());
        self.child.wait().unwrap().code().unwrap()
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        self.child.kill().ok();
        self.child.wait().ok();
    }
}

/// An answer as it is compared: without the version, the bytes of pictures, and what is said twice.
fn shown(answer: &Value) -> String {
    let mut answer = answer.clone();
    if let Some(version) = answer.pointer_mut("/result/serverInfo/version") {
        *version = "VERSION".into();
    }
    if answer.pointer("/result/structuredContent").is_some() {
        answer["result"]["content"][0]["text"] = "(structuredContent)".into();
    }
    if let Some(data) = answer.pointer_mut("/result/content/1/data") {
        *data = "(PNG)".into();
    }
    serde_json::to_string_pretty(&answer).unwrap()
}
