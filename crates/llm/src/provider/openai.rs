//! Chat completions, as OpenAI has them and many others since.

use super::{Call, Key, Question, ReplyText};
use crate::error::{Error, plain};
use crate::message::{Message, Role};
use serde::Deserialize;
use serde_json::{Value, json};

pub(super) fn write(question: &Question<'_>, key: Option<&Key>) -> Call {
    let system = json!({ "role": "system", "content": question.system() });
    let rest = question.request.messages.iter().filter(|m| m.role != Role::System);
    let messages: Vec<Value> = std::iter::once(system).chain(rest.map(message)).collect();
    let mut body = json!({ "model": question.target.model, "messages": messages });
    body[question.target.provider.most] = question.request.max_output.into();
    if let Some(temperature) = question.temperature() {
        body["temperature"] = temperature.into();
    }
    if let Some(seed) = question.seed() {
        body["seed"] = seed.into();
    }
    body["response_format"] = match question.schema() {
        Some(schema) => {
            let name = &question.request.schema.name;
            json!({ "type": "json_schema", "json_schema": { "name": name, "strict": true, "schema": schema } })
        }
        None => json!({ "type": "json_object" }),
    };
    let headers = key.map(|k| ("authorization", format!("Bearer {}", k.reveal()))).into_iter().collect();
    Call { path: "/chat/completions".into(), headers, body }
}

fn message(message: &Message) -> Value {
    let role = if message.role == Role::Assistant { "assistant" } else { "user" };
    if message.images.is_empty() {
        return json!({ "role": role, "content": message.text });
    }
    let mut parts = vec![json!({ "type": "text", "text": message.text })];
    for image in &message.images {
        let url = format!("data:{};base64,{}", image.media, image.base64);
        parts.push(json!({ "type": "image_url", "image_url": { "url": url } }));
    }
    json!({ "role": role, "content": parts })
}

#[derive(Deserialize)]
struct Completion {
    choices: Vec<Choice>,
    usage: Option<Tokens>,
}

#[derive(Deserialize)]
struct Choice {
    message: Said,
    finish_reason: Option<String>,
}

#[derive(Deserialize)]
struct Said {
    content: Option<String>,
    refusal: Option<String>,
}

#[derive(Deserialize)]
struct Tokens {
    prompt_tokens: u64,
    completion_tokens: u64,
}

pub(super) fn read(body: &[u8]) -> ReplyText {
    let got: Completion = super::envelope(body)?;
    let choice = got.choices.into_iter().next().ok_or_else(|| Error::Malformed("it has no choices".into()))?;
    match choice.finish_reason.as_deref() {
        Some("length") => return Err(Error::CutShort),
        Some("content_filter") => return Err(Error::Declined("a content filter stopped the answer".into())),
        _ => {}
    }
    if let Some(refusal) = choice.message.refusal.filter(|r| !r.is_empty()) {
        return Err(Error::Declined(plain(&refusal, 300)));
    }
    let tokens = got.usage.map(|u| (u.prompt_tokens, u.completion_tokens));
    Ok((choice.message.content.unwrap_or_default(), tokens))
}
