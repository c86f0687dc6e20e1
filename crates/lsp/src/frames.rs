//! Frames of the base protocol, read with patience: header names in any case, headers that are not ours, garbage between
//! messages. What cannot be a message is told of, and the next one is found.

use serde_json::{Map, Value};
use std::io::{self, BufRead, Read};

/// Bodies larger than this are passed over (bytes).
const LARGEST: u64 = 512 << 20;
/// Header lines longer than this are none (bytes).
const LONGEST: u64 = 8 << 10;

/// What was found on the wire.
#[derive(Debug, PartialEq)]
pub enum Frame {
    /// A message: a JSON object with what a request, a notification or a response needs.
    Message(Value),
    /// Something that is none.
    Malformed,
}

/// The next frame; `None` at the end.
///
/// # Errors
/// What the stream says.
pub fn next(input: &mut impl BufRead) -> io::Result<Option<Frame>> {
    let mut length: Option<u64> = None;
    loop {
        let mut line = Vec::new();
        if input.by_ref().take(LONGEST).read_until(b'\n', &mut line)? == 0 {
            return Ok(None);
        }
        let line = String::from_utf8_lossy(&line);
        let line = line.trim();
        if line.is_empty() {
            match length {
                Some(_) => break,
                // Blank lines before a header mean nothing.
                None => continue,
            }
        }
        // What came before on the line may be the rest of something that was cut short.
        let lower = line.to_ascii_lowercase();
        if let Some(at) = lower.rfind("content-length:") {
            length = lower[at + "content-length:".len()..].trim().parse().ok();
            if length.is_none() {
                return Ok(Some(Frame::Malformed));
            }
        }
    }
    let length = length.unwrap_or_default();
    if length > LARGEST {
        io::copy(&mut input.by_ref().take(length), &mut io::sink())?;
        return Ok(Some(Frame::Malformed));
    }
    let mut body = Vec::new();
    if input.by_ref().take(length).read_to_end(&mut body)? < length as usize {
        return Ok(None);
    }
    Ok(Some(match serde_json::from_slice(&body) {
        Ok(Value::Object(message)) if is_message(&message) => Frame::Message(Value::Object(message)),
        _ => Frame::Malformed,
    }))
}

/// Whether an object is a request, a notification or a response.
fn is_message(message: &Map<String, Value>) -> bool {
    let id = message.get("id");
    let good_id = |id: &Value| id.is_string() || id.is_i64();
    match message.get("method") {
        Some(method) => method.is_string() && id.is_none_or(good_id),
        None => id.is_some_and(good_id) && (message.contains_key("result") || message.contains_key("error")),
    }
}

/// A message as bytes with its header.
pub fn framed(message: &Value) -> Vec<u8> {
    let body = message.to_string();
    format!("Content-Length: {}\r\n\r\n{body}", body.len()).into_bytes()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_are_found_among_garbage() {
        let ok = r#"{"jsonrpc":"2.0","method":"a"}"#;
        let cases: &[(&str, &str)] = &[
            ("Content-Length: 30\r\n\r\n@", "m"),
            ("content-length:30\r\nContent-Type: application/vscode-jsonrpc; charset=utf-8\r\n\r\n@", "m"),
            ("Content-Type: x\r\nCONTENT-LENGTH: 30\r\n\r\n@", "m"),
            ("\r\n\r\nhello\r\nContent-Length: 30\r\n\r\n@", "m"),
            ("Content-Length: 9\r\n\r\n{not jsonContent-Length: 30\r\n\r\n@", "xm"),
            ("Content-Length: nine\r\n\r\nContent-Length: 30\r\n\r\n@", "xm"),
            ("Content-Length: 2\r\n\r\n[]Content-Length: 30\r\n\r\n@", "xm"),
            ("Content-Length: 2\r\n\r\n{}Content-Length: 30\r\n\r\n@", "xm"),
            ("Content-Length: 99\r\n\r\n@", ""),
            ("", ""),
        ];
        for (wire, wanted) in cases {
            let wire = wire.replace('@', ok);
            let mut input = wire.as_bytes();
            let mut found = String::new();
            while let Some(frame) = next(&mut input).unwrap() {
                found.push(if frame == Frame::Malformed { 'x' } else { 'm' });
            }
            assert_eq!(found, *wanted, "{wire}");
        }
        let deep = "[".repeat(100_000);
        let wire = format!("Content-Length: {}\r\n\r\n{deep}", deep.len());
        assert_eq!(next(&mut wire.as_bytes()).unwrap(), Some(Frame::Malformed));
    }
}
