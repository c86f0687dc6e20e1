//! Ollama's own interface: unlike the one it shares with OpenAI, it takes a schema from every version that has one.

use super::{Call, Question, ReplyText};
use crate::error::Error;
use crate::message::{Message, Role};
use serde::Deserialize;
use serde_json::{Value, json};

pub(super) fn write(question: &Question<'_>) -> Call {
    let system = json!({ "role": "system", "content": question.system() });
    let rest = question.request.messages.iter().filter(|m| m.role != Role::System);
    let mut options = json!({ "num_predict": question.request.max_output });
    if let Some(temperature) = question.temperature() {
        options["temperature"] = temperature.into();
    }
    if let Some(seed) = question.seed() {
        options["seed"] = seed.into();
    }
    let body = json!({
        "model": question.target.model,
        "stream": false,
        "messages": std::iter::once(system).chain(rest.map(message)).collect::<Vec<_>>(),
        "format": question.schema().cloned().unwrap_or_else(|| "json".into()),
        "options": options,
    });
    Call { path: "/api/chat".into(), headers: Vec::new(), body }
}

fn message(message: &Message) -> Value {
    let role = if message.role == Role::Assistant { "assistant" } else { "user" };
    let mut out = json!({ "role": role, "content": message.text });
    if !message.images.is_empty() {
        out["images"] = message.images.iter().map(|i| i.base64.as_str()).collect();
    }
    out
}

#[derive(Deserialize)]
struct Chatted {
    message: Said,
    done_reason: Option<String>,
    prompt_eval_count: Option<u64>,
    eval_count: Option<u64>,
}

#[derive(Deserialize)]
struct Said {
    content: String,
}

pub(super) fn read(body: &[u8]) -> ReplyText {
    let got: Chatted = super::envelope(body)?;
    if got.done_reason.as_deref() == Some("length") {
        return Err(Error::CutShort);
    }
    Ok((got.message.content, got.prompt_eval_count.zip(got.eval_count)))
}
