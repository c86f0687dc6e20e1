//! A client that speaks to `scenelang lsp` as a process.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::Duration;

/// A server that does not answer within this time hangs; the machine may be busy.
const PATIENCE: Duration = Duration::from_secs(60);

/// A client of a server that is a process.
pub struct Client {
    child: Child,
    to: ChildStdin,
    from: Receiver<Value>,
    said: Vec<Value>,
    next: i64,
    name: &'static str,
}

impl Client {
    /// Starts `scenelang lsp`; `name`: what the test is called.
    pub fn start(mut command: Command, name: &'static str) -> Self {
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
        let (send, from) = channel();
        let mut out = BufReader::new(child.stdout.take().unwrap());
        thread::spawn(move || {
            while let Some(message) = read(&mut out) {
                if send.send(message).is_err() {
                    return;
                }
            }
        });
        Self { to: child.stdin.take().unwrap(), child, from, said: Vec::new(), next: 0, name }
    }

    /// Ends the server: all that it said.
    pub fn end(mut self) -> Vec<Value> {
        self.ask("shutdown", &Value::Null);
        self.tell("exit", &Value::Null);
        let Self { mut child, to, said, name, .. } = self;
        drop(to);
        let code = child.wait().unwrap().code();
        assert_eq!(code, Some(0), "{name}: the server ended with {code:?}");
        said
    }

    /// Tells something.
    pub fn tell(&mut self, method: &str, params: &Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// Asks something, and waits for the answer.
    pub fn ask(&mut self, method: &str, params: &Value) -> Value {
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
    pub fn wait(&mut self, is_meant: impl Fn(&Value) -> bool) -> Value {
        self.wait_for(1, is_meant)
    }

    /// The last of so many messages that are meant.
    pub fn wait_for(&mut self, count: usize, is_meant: impl Fn(&Value) -> bool) -> Value {
        let meant: Vec<&Value> = self.said.iter().filter(|message| is_meant(message)).collect();
        if meant.len() >= count {
            return meant[count - 1].clone();
        }
        let mut missing = count - meant.len();
        loop {
            let message = self.from.recv_timeout(PATIENCE);
            let message = message.unwrap_or_else(|e| panic!("{}: the server does not answer: {e}", self.name));
            self.said.push(message.clone());
            if let (Some(id), true) = (message.get("id"), message["method"].is_string()) {
                self.send(&json!({ "jsonrpc": "2.0", "id": id, "result": null }));
            }
            if is_meant(&message) {
                missing -= 1;
                if missing == 0 {
                    return message;
                }
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
