//! Messages, as Anthropic has them.

use super::{Call, Key, Question, ReplyText};
use crate::error::Error;
use crate::message::{Message, Role};
use serde::Deserialize;
use serde_json::{Value, json};

/// The version of the interface that this file speaks.
const VERSION: &str = "2023-06-01";

pub(super) fn write(question: &Question<'_>, key: Option<&Key>) -> Call {
    let rest = question.request.messages.iter().filter(|m| m.role != Role::System);
    let mut body = json!({
        "model": question.target.model,
        "max_tokens": question.request.max_output,
        "system": question.system(),
        "messages": rest.map(message).collect::<Vec<_>>(),
    });
    if let Some(temperature) = question.temperature() {
        body["temperature"] = temperature.into();
    }
    if let Some(schema) = question.schema() {
        body["output_config"] = json!({ "format": { "type": "json_schema", "schema": schema } });
    }
    let mut headers = vec![("anthropic-version", VERSION.to_owned())];
    headers.extend(key.map(|k| ("x-api-key", k.reveal().to_owned())));
    Call { path: "/messages".into(), headers, body }
}

fn message(message: &Message) -> Value {
    let role = if message.role == Role::Assistant { "assistant" } else { "user" };
    let image = |i: &crate::Image| json!({ "type": "image", "source": { "type": "base64", "media_type": i.media, "data": i.base64 } });
    let mut parts: Vec<Value> = message.images.iter().map(image).collect();
    parts.push(json!({ "type": "text", "text": message.text }));
    json!({ "role": role, "content": parts })
}

#[derive(Deserialize)]
struct Answered {
    content: Vec<Block>,
    stop_reason: Option<String>,
    usage: Option<Tokens>,
}

#[derive(Deserialize)]
struct Block {
    text: Option<String>,
}

#[derive(Deserialize)]
struct Tokens {
    input_tokens: u64,
    output_tokens: u64,
    #[serde(default)]
    cache_creation_input_tokens: Option<u64>,
    #[serde(default)]
    cache_read_input_tokens: Option<u64>,
}

impl Tokens {
    fn input(&self) -> u64 {
        let cached = [self.cache_creation_input_tokens, self.cache_read_input_tokens];
        cached.iter().flatten().fold(self.input_tokens, |sum, n| sum.saturating_add(*n))
    }
}

pub(super) fn read(body: &[u8]) -> ReplyText {
    let got: Answered = super::envelope(body)?;
    match got.stop_reason.as_deref() {
        Some("max_tokens" | "model_context_window_exceeded") => return Err(Error::CutShort),
        Some("refusal") => return Err(Error::Declined(String::new())),
        _ => {}
    }
    let text: String = got.content.into_iter().filter_map(|b| b.text).collect();
    Ok((text, got.usage.map(|u| (u.input(), u.output_tokens))))
}
