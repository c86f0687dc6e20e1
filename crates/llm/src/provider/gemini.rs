//! `generateContent`, as Google's Gemini has it.

use super::{Call, Key, Question, ReplyText};
use crate::error::{Error, plain};
use crate::message::{Message, Role};
use serde::Deserialize;
use serde_json::{Value, json};

pub(super) fn write(question: &Question<'_>, key: Option<&Key>) -> Call {
    let rest = question.request.messages.iter().filter(|m| m.role != Role::System);
    let mut config = json!({
        "maxOutputTokens": question.request.max_output,
        "responseMimeType": "application/json",
    });
    if let Some(temperature) = question.temperature() {
        config["temperature"] = temperature.into();
    }
    if let Some(seed) = question.seed() {
        config["seed"] = seed.into();
    }
    if let Some(schema) = question.schema() {
        config["responseJsonSchema"] = schema.clone();
    }
    let body = json!({
        "systemInstruction": { "parts": [{ "text": question.system() }] },
        "contents": rest.map(message).collect::<Vec<_>>(),
        "generationConfig": config,
    });
    let headers = key.map(|k| ("x-goog-api-key", k.reveal().to_owned())).into_iter().collect();
    Call { path: format!("/models/{}:generateContent", question.target.model), headers, body }
}

fn message(message: &Message) -> Value {
    let role = if message.role == Role::Assistant { "model" } else { "user" };
    let image = |i: &crate::Image| json!({ "inlineData": { "mimeType": i.media, "data": i.base64 } });
    let mut parts: Vec<Value> = message.images.iter().map(image).collect();
    parts.push(json!({ "text": message.text }));
    json!({ "role": role, "parts": parts })
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Generated {
    #[serde(default)]
    candidates: Vec<Candidate>,
    prompt_feedback: Option<Feedback>,
    usage_metadata: Option<Tokens>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Candidate {
    content: Option<Content>,
    finish_reason: Option<String>,
}

#[derive(Deserialize)]
struct Content {
    #[serde(default)]
    parts: Vec<Part>,
}

#[derive(Deserialize)]
struct Part {
    text: Option<String>,
    #[serde(default)]
    thought: bool,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Feedback {
    block_reason: Option<String>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Tokens {
    #[serde(default)]
    prompt_token_count: u64,
    #[serde(default)]
    candidates_token_count: u64,
    #[serde(default)]
    thoughts_token_count: u64,
}

pub(super) fn read(body: &[u8]) -> ReplyText {
    let got: Generated = super::envelope(body)?;
    if let Some(reason) = got.prompt_feedback.and_then(|f| f.block_reason) {
        return Err(Error::Declined(plain(&reason, 100)));
    }
    let candidate = got.candidates.into_iter().next().ok_or_else(|| Error::Malformed("it has no candidates".into()))?;
    match candidate.finish_reason.as_deref() {
        None | Some("STOP" | "FINISH_REASON_UNSPECIFIED") => {}
        Some("MAX_TOKENS") => return Err(Error::CutShort),
        Some(reason) => return Err(Error::Declined(plain(reason, 100))),
    }
    let parts = candidate.content.map(|c| c.parts).unwrap_or_default();
    let text: String = parts.into_iter().filter(|p| !p.thought).filter_map(|p| p.text).collect();
    let tokens = got
        .usage_metadata
        .map(|u| (u.prompt_token_count, u.candidates_token_count.saturating_add(u.thoughts_token_count)));
    Ok((text, tokens))
}
