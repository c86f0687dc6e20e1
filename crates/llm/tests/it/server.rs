//! A server on loopback that plays a script: for each request the next act. It remembers what it was asked.

use serde_json::{Value, json};
use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream};
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// What the server does with a request.
#[derive(Clone, Debug)]
pub enum Act {
    /// A status, more headers, a body.
    Answer(u16, Vec<(&'static str, String)>, Vec<u8>),
    /// A body that promises more bytes than come.
    Broken(Vec<u8>),
    /// The beginning of an answer, and then nothing until the client has had enough.
    Stalled,
    /// An answer without an end, until the client has had enough.
    Endless,
    /// No answer at all.
    HangUp,
}

impl Act {
    /// What a model says, as OpenAI writes it.
    pub fn says(text: &str) -> Self {
        Self::json(&json!({
            "choices": [{ "message": { "role": "assistant", "content": text }, "finish_reason": "stop" }],
            "usage": { "prompt_tokens": 100, "completion_tokens": 20 },
        }))
    }
    /// Any JSON.
    pub fn json(body: &Value) -> Self {
        Self::Answer(200, Vec::new(), body.to_string().into_bytes())
    }
    /// A status that is no success.
    pub fn fails(status: u16, message: &str) -> Self {
        Self::Answer(status, Vec::new(), json!({ "error": { "message": message } }).to_string().into_bytes())
    }
    /// With one more header.
    pub fn with(self, name: &'static str, value: &str) -> Self {
        match self {
            Self::Answer(status, mut headers, body) => {
                headers.push((name, value.to_owned()));
                Self::Answer(status, headers, body)
            }
            other => other,
        }
    }
}

/// What a client asked for.
#[derive(Clone, Debug)]
pub struct Asked {
    pub path: String,
    pub headers: Vec<(String, String)>,
    pub body: Value,
}

impl Asked {
    pub fn header(&self, name: &str) -> Option<&str> {
        self.headers.iter().find(|(n, _)| n == name).map(|(_, v)| v.as_str())
    }
}

/// A running server; it ends with the test.
pub struct Server {
    pub url: String,
    asked: Arc<Mutex<Vec<Asked>>>,
}

impl Server {
    /// Plays `script`; after its end, the last act again.
    pub fn new(script: Vec<Act>) -> Self {
        Self::playing(move |n, _| script[n.min(script.len() - 1)].clone())
    }

    /// Plays what a function says for the n-th request.
    pub fn playing(act: impl Fn(usize, &Asked) -> Act + Send + 'static) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let url = format!("http://{}", listener.local_addr().unwrap());
        let asked = Arc::new(Mutex::new(Vec::new()));
        let memory = Arc::clone(&asked);
        std::thread::spawn(move || {
            for stream in listener.incoming() {
                let Ok(mut stream) = stream else { return };
                let Some(request) = read(&mut stream) else { continue };
                let n = {
                    let mut memory = memory.lock().unwrap();
                    memory.push(request.clone());
                    memory.len() - 1
                };
                let act = act(n, &request);
                // An act may last; whoever asks next is not to wait for it.
                std::thread::spawn(move || play(&mut stream, &act));
            }
        });
        Self { url, asked }
    }

    /// What was asked so far.
    pub fn asked(&self) -> Vec<Asked> {
        self.asked.lock().unwrap().clone()
    }
}

fn read(stream: &mut TcpStream) -> Option<Asked> {
    stream.set_read_timeout(Some(Duration::from_secs(10))).ok()?;
    let mut bytes = Vec::new();
    let mut buffer = [0; 4096];
    let head = loop {
        if let Some(end) = bytes.windows(4).position(|w| w == b"\r\n\r\n") {
            break end + 4;
        }
        match stream.read(&mut buffer).ok()? {
            0 => return None,
            n => bytes.extend_from_slice(&buffer[..n]),
        }
    };
    let text = String::from_utf8_lossy(&bytes[..head]).into_owned();
    let mut lines = text.lines();
    let path = lines.next()?.split(' ').nth(1)?.to_owned();
    let headers: Vec<(String, String)> =
        lines.filter_map(|l| l.split_once(": ")).map(|(n, v)| (n.to_ascii_lowercase(), v.to_owned())).collect();
    let length = headers.iter().find(|(n, _)| n == "content-length")?.1.parse::<usize>().ok()?;
    while bytes.len() < head + length {
        match stream.read(&mut buffer).ok()? {
            0 => return None,
            n => bytes.extend_from_slice(&buffer[..n]),
        }
    }
    Some(Asked { path, headers, body: serde_json::from_slice(&bytes[head..]).ok()? })
}

/// Errors are the client's leaving, which is part of the play.
fn play(stream: &mut TcpStream, act: &Act) {
    let head = |status: u16, length: usize, more: &str| {
        format!(
            "HTTP/1.1 {status} X\r\ncontent-type: application/json\r\ncontent-length: {length}\r\nconnection: close\r\n{more}\r\n"
        )
    };
    match act {
        Act::Answer(status, headers, body) => {
            let more: String = headers.iter().map(|(n, v)| format!("{n}: {v}\r\n")).collect();
            let _ = stream.write_all(head(*status, body.len(), &more).as_bytes());
            let _ = stream.write_all(body);
        }
        Act::Broken(body) => {
            let _ = stream.write_all(head(200, body.len() + 1000, "").as_bytes());
            let _ = stream.write_all(body);
        }
        Act::Stalled => {
            let _ = stream.write_all(head(200, 1000, "").as_bytes());
            let _ = stream.write_all(b"{\"choices\": [");
            // Returns when the client hangs up.
            let _ = stream.set_read_timeout(None);
            let _ = stream.read(&mut [0; 1]);
        }
        Act::Endless => {
            let head = "HTTP/1.1 200 X\r\ncontent-type: application/json\r\nconnection: close\r\n\r\n";
            let _ = stream.write_all(head.as_bytes());
            let _ = stream.write_all(b"{\"choices\": [");
            while stream.write_all(&[b' '; 65_536]).is_ok() {}
        }
        Act::HangUp => {}
    }
}
