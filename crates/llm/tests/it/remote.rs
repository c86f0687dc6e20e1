//! One request and its answer: the four shapes, and every way in which an answer can be bad.

use crate::server::{Act, Server};
use crate::{question, remote, remote_within};
use scenelang_llm::{Error, Image, Message, Model, ModelName, Remote, Reply, Role, Usage};
use serde_json::{Value, json};
use std::time::Duration;

const KEY: &str = "sk-very-secret";

/// Model, path, header of the key, body of the request, a good answer.
type Shape = (&'static str, &'static str, Option<(&'static str, &'static str)>, Value, Value);

fn shapes() -> Vec<Shape> {
    let schema = question().schema.json;
    let said = |text: &str| json!({ "role": "user", "content": text });
    let system = json!({ "role": "system", "content": "You place things." });
    vec![
        (
            "openai:gpt-4o",
            "/chat/completions",
            Some(("authorization", "Bearer sk-very-secret")),
            json!({
                "model": "gpt-4o", "messages": [system, said("Where?")], "max_completion_tokens": 500, "temperature": 0.7,
                "seed": 5,
                "response_format": {
                    "type": "json_schema", "json_schema": { "name": "point", "strict": true, "schema": schema },
                },
            }),
            json!({
                "choices": [{ "message": { "content": "{\"x\": 1}", "refusal": null }, "finish_reason": "stop" }],
                "usage": { "prompt_tokens": 10, "completion_tokens": 4, "total_tokens": 14 },
            }),
        ),
        (
            "anthropic:claude-sonnet-4-5",
            "/messages",
            Some(("x-api-key", KEY)),
            json!({
                "model": "claude-sonnet-4-5", "max_tokens": 500, "system": "You place things.",
                "messages": [{ "role": "user", "content": [{ "type": "text", "text": "Where?" }] }], "temperature": 0.7,
                "output_config": { "format": { "type": "json_schema", "schema": schema } },
            }),
            json!({
                "content": [{ "type": "thinking", "thinking": "hm" }, { "type": "text", "text": "{\"x\": 1}" }],
                "stop_reason": "end_turn",
                "usage": { "input_tokens": 7, "cache_read_input_tokens": 3, "output_tokens": 4 },
            }),
        ),
        (
            "gemini:gemini-2.5-pro",
            "/models/gemini-2.5-pro:generateContent",
            Some(("x-goog-api-key", KEY)),
            json!({
                "systemInstruction": { "parts": [{ "text": "You place things." }] },
                "contents": [{ "role": "user", "parts": [{ "text": "Where?" }] }],
                "generationConfig": {
                    "maxOutputTokens": 500, "responseMimeType": "application/json", "temperature": 0.7, "seed": 5,
                    "responseJsonSchema": schema,
                },
            }),
            json!({
                "candidates": [{
                    "content": { "parts": [{ "text": "hm", "thought": true }, { "text": "{\"x\": 1}" }] },
                    "finishReason": "STOP",
                }],
                "usageMetadata": { "promptTokenCount": 10, "candidatesTokenCount": 3, "thoughtsTokenCount": 1 },
            }),
        ),
        (
            "ollama:llama3.1:8b",
            "/api/chat",
            None,
            json!({
                "model": "llama3.1:8b", "stream": false, "messages": [system, said("Where?")], "format": schema,
                "options": { "num_predict": 500, "temperature": 0.7, "seed": 5 },
            }),
            json!({
                "message": { "role": "assistant", "content": "{\"x\": 1}" }, "done": true, "done_reason": "stop",
                "prompt_eval_count": 10, "eval_count": 4,
            }),
        ),
    ]
}

#[test]
fn every_provider_is_spoken_to_in_its_own_way() {
    for (model, path, header, body, answer) in shapes() {
        let server = Server::new(vec![Act::json(&answer)]);
        let reply = remote(model, &server.url, Some(KEY)).ask(&question());
        let usage = Usage { input: 10, output: 4, estimated: false };
        assert_eq!(reply, Ok(Reply { text: "{\"x\": 1}".into(), usage }), "{model}");
        let asked = server.asked().remove(0);
        assert_eq!((asked.path.as_str(), &asked.body), (path, &body), "{model}");
        match header {
            Some((name, value)) => assert_eq!(asked.header(name), Some(value), "{model}"),
            None => assert!(!format!("{:?}", asked.headers).contains(KEY), "{model}"),
        }
        assert!(!asked.body.to_string().contains(KEY));
    }
}

#[test]
fn a_provider_without_schemas_gets_it_in_words() {
    let server = Server::new(vec![Act::says("{\"x\": 1}")]);
    remote("deepseek:deepseek-chat", &server.url, Some(KEY)).ask(&question()).unwrap();
    let body = &server.asked()[0].body;
    assert_eq!(body["response_format"], json!({ "type": "json_object" }));
    assert_eq!(body["max_tokens"], 500);
    let system = body["messages"][0]["content"].as_str().unwrap();
    assert!(system.starts_with("You place things.") && system.contains("\"additionalProperties\":false"), "{system}");
}

#[test]
fn pictures_go_along() {
    let mut shown = question();
    let mut message = Message::new(Role::User, "And here?");
    message.images.push(Image { media: "image/png".into(), base64: "aGk=".into() });
    shown.messages.push(Message::new(Role::Assistant, "{}"));
    shown.messages.push(message);
    for ((model, .., answer), pointer, wanted) in shapes()
        .into_iter()
        .zip([
            ("/messages/3/content/1/image_url/url", "data:image/png;base64,aGk="),
            ("/messages/2/content/0/source/data", "aGk="),
            ("/contents/2/parts/0/inlineData/data", "aGk="),
            ("/messages/3/images/0", "aGk="),
        ])
        .map(|(shape, (pointer, wanted))| (shape, pointer, wanted))
    {
        let server = Server::new(vec![Act::json(&answer)]);
        remote(model, &server.url, Some(KEY)).ask(&shown).unwrap();
        let asked = server.asked().remove(0);
        assert_eq!(asked.body.pointer(pointer), Some(&json!(wanted)), "{model}: {}", asked.body);
    }
}

/// What becomes of an act, in words.
fn said(act: Act) -> String {
    // Only what never comes is not waited for.
    let patience = if matches!(act, Act::Stalled) { Duration::from_millis(500) } else { Duration::from_secs(60) };
    let server = Server::new(vec![act]);
    match remote_within(patience, "openai:m", &server.url, Some(KEY)).ask(&question()) {
        Ok(reply) => format!("ok: {}", reply.text),
        Err(error) => {
            let passing = if error.is_passing() { "passing" } else { "final" };
            format!("{passing}: {error}")
        }
    }
}

#[test]
fn every_bad_answer_has_an_error_of_its_own() {
    let choice = |content: Value, finish: &str| json!({ "choices": [{ "message": content, "finish_reason": finish }] });
    let raw = |body: &[u8]| Act::Answer(200, Vec::new(), body.to_vec());
    let deep = [b"{\"choices\": ".to_vec(), vec![b'['; 60_000]].concat();
    for (act, wanted) in [
        (Act::says("fine"), "ok: fine"),
        (raw(b"{\"choices\": [{\"mess"), "passing: the answer does not have the expected form: EOF while parsing"),
        (raw(b"<html>busy</html>"), "passing: the answer does not have the expected form: expected value"),
        (raw(b""), "passing: the answer does not have the expected form: EOF"),
        (raw(&deep), "passing: the answer does not have the expected form: "),
        (raw(b"{\"choices\": NaN}"), "passing: the answer does not have the expected form: "),
        (
            raw(b"{\"choices\": [{\"message\": {\"content\": \"\xff\xfe\"}}]}"),
            "passing: the answer does not have the expected form: invalid unicode",
        ),
        (Act::json(&json!({ "choices": "many" })), "passing: the answer does not have the expected form: invalid type"),
        (
            Act::json(&json!({ "choices": [] })),
            "passing: the answer does not have the expected form: it has no choices",
        ),
        (
            Act::json(&choice(json!({ "content": 7 }), "stop")),
            "passing: the answer does not have the expected form: invalid type",
        ),
        (
            Act::json(&choice(json!({ "content": null }), "stop")),
            "passing: the answer does not have the expected form: it is empty",
        ),
        (
            Act::json(&choice(json!({ "content": "{\"x\"" }), "length")),
            "final: the answer was cut off at the token limit",
        ),
        (
            Act::json(&choice(json!({ "refusal": "no \u{1b}[2Jchairs" }), "stop")),
            "final: the model refused to answer: no [2Jchairs",
        ),
        (Act::Broken(b"{\"choices\": [".to_vec()), "passing: the model cannot be reached: "),
        (Act::HangUp, "passing: the model cannot be reached: "),
        (Act::Stalled, "passing: the model gave no complete answer within 0.5 s"),
        (Act::Endless, "final: the answer is larger than 65536 bytes"),
        (raw(&vec![b' '; 65_537]), "final: the answer is larger than 65536 bytes"),
        (Act::fails(429, "slow down"), "passing: the provider has received too many requests (429): slow down"),
        (Act::fails(500, "oops"), "passing: the provider reports an internal error (500): oops"),
        (Act::fails(529, "Overloaded"), "passing: the provider reports an internal error (529): Overloaded"),
        (
            Act::fails(401, "Incorrect API key: sk-very-secret"),
            "final: the provider does not accept the key: Incorrect API key: [key]",
        ),
        (Act::fails(404, "no such model"), "final: the provider refuses the request (404): no such model"),
        (Act::fails(400, "Unsupported value: 'temperature'"), "passing: the model does not support `temperature`"),
        (
            Act::fails(302, "").with("location", "http://127.0.0.1:1/"),
            "final: the provider refuses the request (302): it redirects to another host",
        ),
        (
            Act::Answer(429, Vec::new(), br#"{"error": {"message": "pay", "code": "insufficient_quota"}}"#.to_vec()),
            "final: the provider refuses the request (429): pay (insufficient_quota)",
        ),
    ] {
        let shown = format!("{act:?}");
        let said = said(act);
        assert!(said.starts_with(wanted), "{shown:.200}\n  {said}");
        assert!(!said.contains(KEY) && said.len() < 600 && !said.contains('\u{1b}'), "{said}");
    }
}

#[test]
fn an_echoed_key_goes_nowhere() {
    let server = Server::new(vec![Act::says(&format!("{{\"x\": 1, \"key\": \"{KEY}\"}}"))]);
    let reply = remote("openai:m", &server.url, Some(KEY)).ask(&question()).unwrap();
    assert_eq!(reply.text, "{\"x\": 1, \"key\": \"[key]\"}");
}

#[test]
fn nobody_there_is_an_error() {
    let error = remote("openai:m", "http://127.0.0.1:9", None).ask(&question()).unwrap_err();
    assert!(matches!(error, Error::Unreachable(_)), "{error:?}");
}

#[test]
fn a_request_can_be_given_up() {
    let server = Server::new(vec![Act::Stalled]);
    let target = ModelName::new("openai:m", Some(&server.url)).unwrap();
    let mut remote = Remote::new(target, None, Duration::from_secs(3600), 1000, || true).unwrap();
    assert_eq!(remote.ask(&question()), Err(Error::Interrupted));
}
