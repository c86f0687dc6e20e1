//! Models over HTTP, against a scripted server on loopback: what is sent, and what becomes of every kind of answer.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

mod remote;
mod server;
mod sessions;

use scenelang_llm::{Key, Message, ModelName, Remote, Request, Role, Schema};
use serde_json::json;
use std::time::Duration;

/// A question for a point.
fn question() -> Request {
    let point = json!({
        "type": "object",
        "properties": { "x": { "type": "number" } },
        "required": ["x"],
        "additionalProperties": false,
    });
    Request {
        messages: vec![Message::new(Role::System, "You place things."), Message::new(Role::User, "Where?")],
        schema: Schema { name: "point".into(), json: point },
        temperature: Some(0.7),
        seed: Some(5),
        max_output: 500,
    }
}

/// A model at a server, with room for 64 KiB in an answer and more patience than any test needs.
fn remote(model: &str, url: &str, key: Option<&str>) -> Remote {
    remote_within(Duration::from_secs(60), model, url, key)
}

/// The same with so much patience.
fn remote_within(patience: Duration, model: &str, url: &str, key: Option<&str>) -> Remote {
    let target = ModelName::new(model, Some(url)).unwrap();
    let key = key.map(|k| Key::new(k).unwrap());
    Remote::new(target, key, patience, 65_536, || false).unwrap()
}
